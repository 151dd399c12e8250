//! A planted number is found again from its own curve; what ends a search otherwise.

use super::*;
use crate::compare::read_run;
use crate::contacts::Fault;
use crate::scenario::{FitTask, Progress, RunOptions, Scenario, run};
use std::path::PathBuf;
use std::time::Duration;
use tempfile::TempDir;

/// 27 soft grains in a box, squeezed and released.
const SQUEEZE: &str = include_str!("squeeze.toml");

/// Watches without a word; asks the run to end when told to.
struct Quiet {
    goes_on: bool,
    messages: Vec<String>,
}

impl Quiet {
    fn new() -> Self {
        Self {
            goes_on: true,
            messages: Vec::new(),
        }
    }
}

impl Observer for Quiet {
    fn progress(&mut self, _: &Progress) -> bool {
        self.goes_on
    }

    fn interval(&self) -> Duration {
        Duration::ZERO
    }

    fn message(&mut self, text: &str) {
        self.messages.push(text.to_string());
    }
}

/// A folder with the scenario and what was measured of it.
struct Bench(TempDir);

impl Bench {
    /// Measured is a run of the scenario as it is, at its levels of both phases.
    fn new(discard: usize) -> Self {
        let place = tempfile::tempdir().unwrap();
        std::fs::write(place.path().join("squeeze.toml"), SQUEEZE).unwrap();
        let bench = Self(place);
        let scenario = Scenario::read(&bench.path("squeeze.toml"), &[]).unwrap();
        let folder = bench.path("experiment");
        run(&scenario, &folder, RunOptions::default(), &mut Quiet::new()).unwrap();
        let reading = crate::compare::Reading {
            discard,
            ..crate::compare::Reading::default()
        };
        let strokes = read_run(&folder, &reading, None).unwrap();
        let mut text = "strain,loading force [N],unloading force [N]\n".to_string();
        for (a, b) in strokes.loading.iter().zip(&strokes.unloading) {
            text += &format!("{:?},{:?},\n", a.position, a.force.unwrap().value);
            text += &format!("{:?},,{:?}\n", b.position, b.force.unwrap().value);
        }
        std::fs::write(bench.path("measured.csv"), text).unwrap();
        bench
    }

    /// Only a point at the top, of any force.
    fn of_point(force: f64) -> Self {
        let place = tempfile::tempdir().unwrap();
        std::fs::write(place.path().join("squeeze.toml"), SQUEEZE).unwrap();
        let text = format!("strain,loading force [N]\n0.0967,{force}\n");
        std::fs::write(place.path().join("measured.csv"), text).unwrap();
        Self(place)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn file(&self, packing: &str) -> PackingFile {
        let text =
            format!("[packing]\nscenario = \"squeeze.toml\"\n{packing}\n[packing.measured]\nfile = \"measured.csv\"\n");
        std::fs::write(self.path("fit.toml"), text).unwrap();
        match FitTask::read(&self.path("fit.toml"), &[]).unwrap() {
            FitTask::Packing(file) => *file,
            FitTask::Collisions(_) => panic!("not a packing"),
        }
    }

    fn fit(&self, file: &PackingFile, observer: &mut Quiet) -> Result<PackingReport, PackingError> {
        fit_packing(file, &self.path("trials"), None, observer)
    }
}

const MODULUS: &str = "unknown = { key = \"material.gel.young_modulus\", from = \"30 kPa\", to = \"70 kPa\" }";

fn assert_found(report: &PackingReport, expected: f64, tolerance: f64, trials: usize) {
    let Answer::Inside { bracket, scatter } = report.answer else {
        panic!("{report:?}");
    };
    let (trial, _) = report.best().unwrap();
    assert!((trial.value - expected).abs() <= 2.0 * tolerance, "{}", trial.value);
    assert!(bracket.0 <= trial.value && trial.value <= bracket.1 && bracket.1 - bracket.0 <= 2.1 * tolerance);
    assert!(
        scatter.is_some_and(|error| error > 0.0 && error < 0.1 * expected),
        "{scatter:?}"
    );
    assert!(report.trials.len() <= trials, "{}", report.trials.len());
}

#[test]
fn a_planted_modulus_is_found_and_its_runs_are_used_again() {
    let bench = Bench::new(1);
    let file = bench.file(&format!("{MODULUS}\nmatch = \"top\"\ndiscard = 1"));
    let report = bench.fit(&file, &mut Quiet::new()).unwrap();
    assert_found(&report, 50e3, 400.0, 7);
    assert!(
        report
            .trials
            .iter()
            .all(|t| !t.reused && t.folder.join("summary.json").is_file())
    );
    let again = bench.fit(&file, &mut Quiet::new()).unwrap();
    assert!(again.trials.iter().all(|t| t.reused));
    assert_eq!(again.answer, report.answer);
    // of another scenario they are kept, and not used
    let file = bench.file(&format!("{MODULUS}\nmatch = \"top\"\nset = [\"seed=2\"]"));
    let other = bench.fit(&file, &mut Quiet::new()).unwrap();
    assert!(other.trials.iter().all(|t| !t.reused));
    assert!(
        other.trials[0].folder.ends_with("30000_Pa-2"),
        "{:?}",
        other.trials[0].folder
    );
}

#[test]
fn a_planted_modulus_is_found_from_the_whole_curve() {
    let bench = Bench::new(0);
    let file = bench.file(&format!("{MODULUS}\nmatch = \"curve\"\ntolerance = \"500 Pa\""));
    let report = bench.fit(&file, &mut Quiet::new()).unwrap();
    assert_found(&report, 50e3, 500.0, 11);
    let (_, best) = report.best().unwrap();
    assert!(best.errf.as_ref().unwrap().value < 2e-3 && best.remarks.is_empty());
}

#[test]
fn an_answer_outside_is_told() {
    let bench = Bench::of_point(30.0);
    let file = bench.file(&format!("{MODULUS}\nmatch = \"top\""));
    let report = bench.fit(&file, &mut Quiet::new()).unwrap();
    assert_eq!(
        (report.answer, report.best, report.trials.len()),
        (Answer::UpperEnd, Some(1), 2)
    );
}

#[test]
fn both_ends_beyond_the_fold_tell_nothing() {
    let bench = Bench::of_point(0.32);
    let unknown = "unknown = { key = \"contact.multi_contact.prefactor\", from = 5.0, to = 6.0 }";
    let file = bench.file(&format!("{unknown}\nmatch = \"top\""));
    let report = bench.fit(&file, &mut Quiet::new()).unwrap();
    assert_eq!(
        (report.answer, report.best, report.trials.len()),
        (Answer::Nowhere, None, 2)
    );
}

#[test]
fn what_is_wrong_at_the_other_end_is_told_before_the_first_trial() {
    let bench = Bench::of_point(0.3);
    let unknown = "unknown = { key = \"material.gel.young_modulus\", from = \"30 kPa\", to = \"30 GPa\" }";
    let file = bench.file(&format!(
        "{unknown}\nmatch = \"top\"\nset = ['simulation.time_step=\"50 us\"']"
    ));
    let error = bench.fit(&file, &mut Quiet::new()).unwrap_err();
    let PackingError::Run(RunError::Scenario(faults)) = error else {
        panic!("{error}");
    };
    assert!(faults.to_string().contains("time step"), "{faults}");
    assert!(!bench.path("trials").exists());
}

#[test]
fn beyond_the_fold_is_too_large() {
    let bench = Bench::of_point(0.32);
    let unknown = "unknown = { key = \"contact.multi_contact.prefactor\", from = 0.5, to = 6.0 }";
    let file = bench.file(&format!("{unknown}\nmatch = \"top\"\ntolerance = 0.2"));
    let report = bench.fit(&file, &mut Quiet::new()).unwrap();
    let beyond = |t: &Trial| matches!(&t.outcome, Outcome::BeyondFold(fault) if fault.contains("grain"));
    assert!(beyond(&report.trials[1]) && report.trials[1].value == 6.0);
    assert!(report.best().is_some_and(|(trial, _)| trial.value < 6.0));
    assert!(matches!(report.answer, Answer::Inside { .. }), "{:?}", report.answer);
}

#[test]
fn any_other_fault_ends_the_search() {
    let bench = Bench::of_point(0.3);
    let file = bench.file(&format!(
        "{MODULUS}\nmatch = \"top\"\nset = [\"simulation.max_overlap=0.1\"]"
    ));
    let error = bench.fit(&file, &mut Quiet::new()).unwrap_err();
    let text = error.to_string();
    assert!(
        matches!(error, PackingError::Fault { ref fault, .. } if matches!(**fault, Fault::Overlap { .. })),
        "{text}"
    );
    assert!(
        text.contains("material.gel.young_modulus = 30000 Pa") && text.contains("narrow the interval"),
        "{text}"
    );
}

#[test]
fn an_interrupted_trial_goes_on() {
    let bench = Bench::of_point(0.3);
    let file = bench.file(&format!("{MODULUS}\nmatch = \"top\"\ntolerance = \"30 kPa\""));
    let mut observer = Quiet::new();
    observer.goes_on = false;
    let error = bench.fit(&file, &mut observer).unwrap_err();
    assert!(matches!(error, PackingError::Interrupted { .. }), "{error}");
    let mut observer = Quiet::new();
    let report = bench.fit(&file, &mut observer).unwrap();
    assert!(
        observer.messages[0].contains("going on in") && report.trials[0].reused,
        "{:?}",
        observer.messages
    );
}

#[test]
fn a_run_is_no_place_for_trials() {
    let bench = Bench::of_point(0.3);
    let file = bench.file(&format!("{MODULUS}\nmatch = \"top\""));
    crate::output::RunFolder::create(&bench.path("trials"), false).unwrap();
    let error = bench.fit(&file, &mut Quiet::new()).unwrap_err();
    assert!(
        matches!(error, PackingError::NoPlace { .. }) && error.to_string().contains("--out"),
        "{error}"
    );
}

#[test]
fn values_are_rounded_to_the_tolerance() {
    assert_eq!(rounded(1.093_028_7, (0.8, 1.3), 0.005), 1.093);
    assert_eq!(rounded(1.093_07, (0.8, 1.3), 0.005), 1.0931);
    assert_eq!(rounded(49_728.3, (2e4, 9e4), 350.0), 49_730.0);
    assert_eq!(rounded(7.6, (2.0, 9.0), 10.0), 8.0);
    // ends stay as they are, and nothing is rounded out of the interval
    assert_eq!(rounded(0.812_345_6, (0.812_345_6, 1.3), 0.005), 0.812_345_6);
    assert_eq!(rounded(1.299_99, (0.8, 1.299_995), 0.005), 1.299_99);
}

mod files {
    use super::*;

    /// What a wrong file says.
    fn refusal(packing: &str, measured: &str) -> String {
        let place = tempfile::tempdir().unwrap();
        std::fs::write(place.path().join("squeeze.toml"), SQUEEZE).unwrap();
        let text = format!("[packing]\nscenario = \"squeeze.toml\"\n{packing}\n[packing.measured]\n{measured}\n");
        let path = place.path().join("fit.toml");
        std::fs::write(&path, text).unwrap();
        FitTask::read(&path, &[]).unwrap_err().to_string()
    }

    const POINT: &str = "loading = [[0.09, \"0.3 N\"]]";

    #[test]
    fn points_may_stand_in_the_file() {
        let text = format!(
            "[packing]\nscenario = \"squeeze.toml\"\n{MODULUS}\nmatch = \"top\"\nunload = false\n[packing.measured]\n\
             loading = [[\"2 mm\", \"0.3 N\"], [\"1 mm\", \"100 mN\"]]\n"
        );
        let place = tempfile::tempdir().unwrap();
        std::fs::write(place.path().join("squeeze.toml"), SQUEEZE).unwrap();
        let file = PackingFile::parse(&text, "fit.toml", place.path(), &[]).unwrap();
        let told: Vec<_> = file
            .measured
            .loading
            .iter()
            .map(|l| (l.position, l.force.unwrap().value))
            .collect();
        assert_eq!(told, [(1e-3, 0.1), (2e-3, 0.3)]);
        assert_eq!(
            (file.measured.position, file.reading.unload),
            (crate::compare::Position::Compression, None)
        );
        assert!((file.tolerance - 400.0).abs() < 1e-9);
    }

    #[test]
    fn wrong_files_tell_what_is_wrong() {
        let cases = [
            (
                format!("{MODULUS}\nmatch = \"tops\""),
                POINT,
                "unknown value `tops` of `match` (did you mean `top`?)",
            ),
            (MODULUS.to_string(), POINT, "`match` is missing"),
            (
                format!("{MODULUS}\nmatch = \"top\"\nload = \"press\""),
                POINT,
                "the scenario has no stage `press`",
            ),
            (
                format!("{MODULUS}\nmatch = \"top\"\ndiscard = 3"),
                POINT,
                "3 cycles are to be discarded: none is left",
            ),
            (
                format!("{MODULUS}\nmatch = \"top\"\nforce = \"wall lid force z\""),
                POINT,
                "no column `wall lid force z`",
            ),
            (
                format!("{MODULUS}\nmatch = \"top\"\nset = [\"output.strain=3\"]"),
                POINT,
                "`strain` must be a table",
            ),
            (
                format!("{MODULUS}\nmatch = \"top\"\ntolerance = 1"),
                POINT,
                "`tolerance` must be a pressure or modulus with a unit",
            ),
            (
                format!("{MODULUS}\nmatch = \"top\""),
                "",
                "the measured curve is missing",
            ),
            (
                format!("{MODULUS}\nmatch = \"top\""),
                "file = \"none.csv\"",
                "cannot read",
            ),
            (
                format!("{MODULUS}\nmatch = \"top\""),
                "loading = [[0.1]]",
                "a point must be a strain and a force",
            ),
            (
                format!("{MODULUS}\nmatch = \"top\""),
                "loading = [[0.1, \"1 m\"]]",
                "must be a force",
            ),
            (
                "unknown = { key = \"material.gel.young_modulus\", from = \"1 kPa\", to = 3 }\nmatch = \"top\""
                    .to_string(),
                POINT,
                "`from` is a pressure or modulus and `to` a pure number",
            ),
            (
                "unknown = { key = \"material.gel.young_modulus\", from = \"3 kPa\", to = \"3 kPa\" }\nmatch = \"top\""
                    .to_string(),
                POINT,
                "`to` must be above `from`",
            ),
            (
                "unknown = { key = \"material.gel.young_module\", from = \"1 kPa\", to = \"3 kPa\" }\nmatch = \"top\""
                    .to_string(),
                POINT,
                "unknown key `young_module`",
            ),
        ];
        for (packing, measured, expected) in cases {
            let found = refusal(&packing, measured);
            assert!(found.contains(expected), "{found}\n{expected}");
        }
    }

    #[test]
    fn a_file_tells_a_packing_or_collisions() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("fit.toml");
        std::fs::write(place.path().join("squeeze.toml"), SQUEEZE).unwrap();
        let text = format!(
            "[packing]\nscenario = \"squeeze.toml\"\n{MODULUS}\nmatch = \"top\"\nmeasured = {{ {POINT} }}\n[fit]\nlaw = \"linear\"\n"
        );
        std::fs::write(&path, text).unwrap();
        let found = FitTask::read(&path, &[]).unwrap_err().to_string();
        assert!(found.contains("unknown key `fit` in a file of a packing"), "{found}");
    }
}
