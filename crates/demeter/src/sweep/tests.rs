//! Sweeps without processes: plans, folders, tables.

use super::*;
use crate::scenario::{Observer, Progress, RunOptions};
use std::fs;
use std::path::Path;
use std::time::Duration;

/// Grains that fall a little, some hundred steps.
const FALL: &str = r#"
seed = 5

[simulation]
gravity = "0 0 -9.81 m/s^2"
max_overlap = 0.3

[material.glass]
young_modulus = "1 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"

[contact]
normal = { law = "hertz-tsuji", restitution = 0.7 }

[[grains]]
material = "glass"
source = "random"
region = { shape = "box", lower = "0 0 0 mm", upper = "8 8 8 mm" }
diameter = "2 mm"
count = 10

[[wall]]
name = "box"
material = "glass"
shape = "box"
lower = "0 0 0 mm"
upper = "8 8 8 mm"

[[stage]]
name = "fall"
steps = 200

[output]
series = "1 ms"
picture = false
report = false
"#;

/// Nobody, who asks a run to end at a step.
struct Nobody(Option<u64>);

impl Observer for Nobody {
    fn progress(&mut self, progress: &Progress) -> bool {
        self.0.is_none_or(|step| progress.step < step)
    }

    fn interval(&self) -> Duration {
        Duration::ZERO
    }

    fn message(&mut self, _: &str) {}
}

fn varied(vary: &[&str]) -> Varied {
    Varied {
        vary: vary.iter().map(ToString::to_string).collect(),
        ..Varied::default()
    }
}

fn plan(place: &Path, varied: &Varied) -> Plan {
    let file = place.join("fall.toml");
    fs::write(&file, FALL).unwrap();
    Plan::make(&file, varied).unwrap_or_else(|error| panic!("{error}"))
}

fn sweep(place: &Path, varied: &Varied) -> SweepFolder {
    let folder = SweepFolder::planned(&place.join("sweep"), plan(place, varied), Wishes::default());
    folder.create().unwrap();
    folder
}

#[test]
fn a_plan_reads_back_and_gives_the_scenarios_of_its_runs() {
    let place = tempfile::tempdir().unwrap();
    let mut varied = varied(&["contact.normal.restitution=0.5,0.9", "grains[0].diameter=1 mm,2 mm"]);
    varied.set.push("stage[0].steps=100".to_string());
    varied.repeat = Some(2);
    let folder = sweep(place.path(), &varied);
    let read = SweepFolder::open(folder.root()).unwrap();
    assert_eq!((&read.plan, &read.wishes), (&folder.plan, &folder.wishes));
    assert_eq!(read.plan.runs.len(), 8);
    assert_eq!(read.plan.runs[3].name, "restitution=0.5_diameter=2mm_seed=6");
    assert_eq!(read.plan.describe(3), "restitution = 0.5, diameter = 2 mm, seed = 6");
    let scenario = read.plan.scenario(3).unwrap();
    let by_hand: Vec<String> = [
        "stage[0].steps=100",
        "contact.normal.restitution=0.5",
        "grains[0].diameter=2 mm",
        "seed=6",
    ]
    .map(String::from)
    .to_vec();
    let expected = crate::scenario::Scenario::parse(FALL, "fall.toml", place.path(), &by_hand).unwrap();
    assert_eq!(scenario.to_resolved_toml(), expected.to_resolved_toml());
    assert_eq!(scenario.seed, 6);
    assert_eq!(scenario.title, "fall: restitution = 0.5, diameter = 2 mm, seed = 6");
}

#[test]
fn every_fault_of_every_run_is_told_with_its_runs() {
    let place = tempfile::tempdir().unwrap();
    let plan = plan(
        place.path(),
        &varied(&["contact.normal.restitution=0.5,1.5", "grains[0].cuont=5,6"]),
    );
    let faults = check(&plan, 1, false).unwrap().unwrap_err().faults;
    let told: Vec<(&str, &[usize])> = faults
        .iter()
        .map(|fault| (fault.diagnostic.message.as_str(), fault.runs.as_slice()))
        .collect();
    assert!(
        told.iter()
            .any(|(m, runs)| m.contains("cuont") && *runs == [0, 1, 2, 3]),
        "{told:?}"
    );
    assert!(
        told.iter().any(|(m, runs)| m.contains("1.5") && *runs == [2, 3]),
        "{told:?}"
    );
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(
        faults
            .iter()
            .any(|fault| fault.drawn.contains("did you mean `count`") && fault.drawn.contains("--vary"))
    );

    let right = self::plan(place.path(), &varied(&["grains[0].count=5,10"]));
    let checked = check(&right, 2, false).unwrap().unwrap();
    assert_eq!(checked.estimates.iter().map(|e| e.grains).collect::<Vec<_>>(), [5, 10]);
    assert!(checked.estimates.iter().all(|e| e.steps == 200 && e.memory > 0));
}

#[test]
fn what_differs_from_the_sweep_in_a_folder_is_told() {
    let place = tempfile::tempdir().unwrap();
    let one = plan(place.path(), &varied(&["grains[0].count=5,6"]));
    let difference = |other: &Plan| one.differences(other).join("; ");
    assert_eq!(difference(&plan(place.path(), &varied(&["grains[0].count=5,6"]))), "");
    let text = difference(&plan(place.path(), &varied(&["grains[0].count=5,7"])));
    assert_eq!(text, "`grains[0].count`: the values 7 are new, 6 are left out");
    let text = difference(&plan(place.path(), &varied(&["grains[0].count=6,5"])));
    assert!(text.contains("order"), "{text}");
    let text = difference(&plan(place.path(), &varied(&["seed=5,6"])));
    assert_eq!(text, "it varies `grains[0].count`, now `seed` is told");
    let mut set = varied(&["grains[0].count=5,6"]);
    set.set.push("contact.normal.restitution=0.8".to_string());
    let text = difference(&plan(place.path(), &set));
    assert!(
        text.contains("restitution = 0.8") && text.contains("in place of") && text.contains("0.7"),
        "{text}"
    );
    let older = Plan {
        version: "0.0.1".to_string(),
        ..one.clone()
    };
    assert!(older.differences(&one).join("").contains("begun by Demeter 0.0.1"));
}

#[test]
fn runs_end_go_on_and_are_not_repeated() {
    let place = tempfile::tempdir().unwrap();
    let folder = sweep(
        place.path(),
        &varied(&["grains[0].count=5,6", "stage[0].steps=100,200"]),
    );
    assert!(folder.statuses().iter().all(|status| *status == Status::Waiting));
    let carry = |index, nobody| carry_out(&folder, index, false, RunOptions::default(), &mut Nobody(nobody)).unwrap();
    assert!(matches!(
        carry(0, None),
        Carried::Ended(Outcome { end: End::Finished, .. })
    ));
    assert_eq!(carry(1, Some(150)), Carried::Interrupted);
    let statuses = folder.statuses();
    assert!(statuses[0].is_finished() && statuses[1] == Status::Interrupted && statuses[2] == Status::Waiting);
    // a finished run is not touched, even if asked to be tried again
    let series = folder.run_folder(0).join("series.csv");
    fs::write(&series, "mine").unwrap();
    carry_out(&folder, 0, true, RunOptions::default(), &mut Nobody(None)).unwrap();
    assert_eq!(fs::read(&series).unwrap(), b"mine");
    // a run of another scenario in the folder of one is refused
    let scenario = folder.run_folder(1).join("scenario.toml");
    fs::write(&scenario, fs::read_to_string(&scenario).unwrap().replace("0.7", "0.8")).unwrap();
    let Carried::Ended(outcome) = carry(1, None) else {
        panic!("it went on")
    };
    assert!(
        outcome.end == End::Error && outcome.message.contains("another scenario"),
        "{outcome:?}"
    );
    // what failed stays so until it is tried again
    assert!(matches!(
        carry(1, None),
        Carried::Ended(Outcome { end: End::Error, .. })
    ));
    assert!(
        folder
            .check_index(4)
            .unwrap_err()
            .to_string()
            .contains("numbered from 0 to 3")
    );
}

#[test]
fn results_stand_in_one_table_with_units_and_means() {
    let place = tempfile::tempdir().unwrap();
    let mut varied = varied(&["grains[0].diameter=1 mm,1.5 mm,2 mm"]);
    varied.repeat = Some(2);
    let mut folder = sweep(place.path(), &varied);
    let between_two_rows = "mean:max speed@1.4 ms..1.5 ms";
    folder.wishes.results = ["max:max speed@fall", "computing time", between_two_rows]
        .map(String::from)
        .to_vec();
    for index in 0..5 {
        carry_out(&folder, index, false, RunOptions::default(), &mut Nobody(None)).unwrap();
    }
    let results = gather(&folder, &folder.statuses()).unwrap();
    assert_eq!(
        results.titles[..7],
        [
            "run",
            "grains[0].diameter [mm]",
            "seed",
            "end",
            "message",
            "max max speed in fall [m/s]",
            "computing time [s]"
        ]
    );
    assert_eq!(results.asked, [5, 6, 7]);
    let [missing] = &results.missing[..] else {
        panic!("{:?}", results.missing)
    };
    assert!(
        missing.starts_with("5 of 6 runs have no value of `mean max speed in 1.4 ms..1.5 ms [m/s]`"),
        "{missing}"
    );
    assert!(results.problems.is_empty() && results.rows.len() == 6);
    results.write(&folder.results()).unwrap();
    let read = crate::results::Columns::read(&folder.results()).unwrap();
    let (x, count) = (
        read.numbers("grains[0].diameter").unwrap(),
        read.numbers("grains").unwrap(),
    );
    assert_eq!(x, [1.0, 1.0, 1.5, 1.5, 2.0, 2.0]);
    assert_eq!(count[..5], [10.0; 5]);
    assert!(count[5].is_nan(), "the last did not run");
    assert_eq!(read.words("end").unwrap()[5], "waiting");
    let series = crate::results::Columns::read(&folder.run_folder(2).join("series.csv")).unwrap();
    let last = |name: &str| *series.numbers(name).unwrap().last().unwrap();
    for name in [
        "kinetic energy",
        "wall box force z",
        "packing fraction",
        "coordination",
        "energy residual",
    ] {
        assert_eq!(read.numbers(name).unwrap()[2], last(name), "{name}");
    }
    let most = series.numbers("max speed").unwrap().iter().copied().fold(0.0, f64::max);
    assert_eq!(read.numbers("max max speed in fall").unwrap()[2], most);

    let means = averages(&folder, &results).unwrap();
    assert_eq!(
        means.titles[..4],
        [
            "grains[0].diameter [mm]",
            "finished runs",
            "max max speed in fall [m/s]",
            "max max speed in fall deviation [m/s]"
        ]
    );
    let number = |row: usize, k: usize| means.rows[row][k].number();
    assert_eq!((number(0, 1), number(2, 1)), (Some(2.0), Some(1.0)));
    let both = [0, 1].map(|run| results.rows[run][5].number().unwrap());
    assert!((number(0, 2).unwrap() - 0.5 * (both[0] + both[1])).abs() < 1e-15);
    assert!((number(0, 3).unwrap() - (both[0] - both[1]).abs() / 2f64.sqrt()).abs() < 1e-15);
    assert_eq!(number(2, 3), None);

    let drawn = plot(&folder, &results, "max max speed in fall [m/s]").unwrap();
    assert_eq!(
        (drawn.x_label.as_str(), drawn.series.len()),
        ("grains[0].diameter [mm]", 2)
    );
    assert_eq!((drawn.series[0].points.len(), drawn.series[1].points.len()), (3, 5));
    assert_eq!(drawn.series[0].points[0].1, number(0, 2).unwrap());
}

#[test]
fn wishes_that_no_run_fulfils_are_told_before() {
    let place = tempfile::tempdir().unwrap();
    let mut folder = sweep(place.path(), &varied(&["contact.normal.law=hertz-tsuji,linear"]));
    let scenario = folder.plan.scenario(0).unwrap();
    let told = |folder: &SweepFolder| check_wishes(folder, &scenario).unwrap_err().to_string();
    folder.wishes.results = vec![
        "cordination".to_string(),
        "mean:contacts@settle".to_string(),
        "steps".to_string(),
    ];
    let text = told(&folder);
    assert!(
        text.contains("did you mean `coordination`?") && text.contains("no stage `settle`"),
        "{text}"
    );
    folder.wishes.results = vec!["meen:contacts".to_string()];
    assert!(told(&folder).contains("`meen` is none of"));
    folder.wishes.results = vec!["steps".to_string()];
    folder.wishes.plots = vec!["steps".to_string()];
    assert!(told(&folder).contains("none of them has numbers"));
    folder.wishes.against = Some("law".to_string());
    assert!(told(&folder).contains("its values are words"));
    folder.wishes.against = Some("count".to_string());
    assert!(told(&folder).contains("`count` is not varied; varied are `contact.normal.law`"));
}

#[test]
fn two_never_hold_a_sweep() {
    let place = tempfile::tempdir().unwrap();
    let folder = sweep(place.path(), &varied(&["grains[0].count=5,6"]));
    let held = folder.hold().unwrap();
    assert!(matches!(folder.hold(), Err(SweepError::InUse { .. })));
    assert!(matches!(folder.join(), Err(SweepError::InUse { .. })));
    drop(held);
    let parts = (folder.join().unwrap(), folder.join().unwrap());
    assert!(matches!(folder.hold(), Err(SweepError::InUse { .. })));
    drop(parts);
    folder.hold().unwrap();
}

#[test]
fn a_damaged_or_foreign_folder_is_refused() {
    let place = tempfile::tempdir().unwrap();
    let folder = sweep(place.path(), &varied(&["grains[0].count=5,6"]));
    let marker = folder.root().join("sweep.json");
    let text = fs::read_to_string(&marker).unwrap();
    let broken = [
        ("\"count=5\"", "\"../../count=5\"", "told wrongly"),
        ("\"count=6\"", "\"count=5\"", "twice"),
        ("\"format\": 1", "\"format\": 7", "format is 7"),
        ("\"demeter\"", "\"other\"", "format"),
        ("\"grains[0].count\"", "\"\"", "is not a key"),
        ("{", "", "expected"),
    ];
    for (from, to, expected) in broken {
        fs::write(&marker, text.replacen(from, to, 1)).unwrap();
        let error = SweepFolder::open(folder.root()).unwrap_err().to_string();
        assert!(error.contains("damaged") && error.contains(expected), "{from}: {error}");
    }
    fs::remove_file(&marker).unwrap();
    assert!(
        SweepFolder::open(folder.root())
            .unwrap_err()
            .to_string()
            .contains("holds no sweep")
    );
    fs::write(folder.root().join("thesis.tex"), "mine").unwrap();
    assert!(folder.create().unwrap_err().to_string().contains("thesis.tex"));
}
