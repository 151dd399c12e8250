//! Grains that come and go while a run goes on: what is counted, booked, and kept over threads and restarts.

use demeter::scenario::{Observer, Progress, Report, RunEnd, RunOptions, Scenario, resume, run};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Stops at a step, when told.
pub(super) struct Watcher {
    stop_at: Option<u64>,
    pub(super) messages: Vec<String>,
}

impl Watcher {
    pub(super) fn until(self, step: u64) -> Self {
        let stop_at = Some(step);
        Self { stop_at, ..self }
    }
}

impl Observer for Watcher {
    fn progress(&mut self, progress: &Progress) -> bool {
        self.stop_at.is_none_or(|step| progress.step < step)
    }

    fn interval(&self) -> Duration {
        Duration::ZERO
    }

    fn message(&mut self, text: &str) {
        self.messages.push(text.to_owned());
    }
}

pub(super) fn watcher() -> Watcher {
    Watcher {
        stop_at: None,
        messages: Vec::new(),
    }
}

pub(super) fn parse(text: &str) -> Scenario {
    match Scenario::parse(text, "case", Path::new(""), &[]) {
        Ok(scenario) => scenario,
        Err(faults) => panic!("{}", faults.render(false)),
    }
}

pub(super) fn run_in(scenario: &Scenario, folder: &Path, threads: usize, watcher: &mut Watcher) -> Report {
    let options = RunOptions {
        threads: Some(threads),
        ..RunOptions::default()
    };
    run(scenario, folder, options, watcher).unwrap()
}

/// Columns of a series by title.
pub(super) fn series(folder: &Path) -> BTreeMap<String, Vec<f64>> {
    let mut reader = csv::Reader::from_path(folder.join("series.csv")).unwrap();
    let titles: Vec<String> = reader.headers().unwrap().iter().map(String::from).collect();
    let mut columns: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for record in reader.records() {
        for (title, cell) in titles.iter().zip(record.unwrap().iter()) {
            let number = cell.parse().unwrap_or(f64::NAN);
            columns.entry(title.clone()).or_default().push(number);
        }
    }
    columns
}

pub(super) fn last(series: &BTreeMap<String, Vec<f64>>, title: &str) -> f64 {
    *series.get(title).unwrap_or_else(|| panic!("{title}")).last().unwrap()
}

fn every_exchange() -> Scenario {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/good/every_exchange.toml");
    Scenario::read(&file, &["output.picture=false".to_owned()]).unwrap()
}

/// The head of every case: soft grains of 2 mm and gravity.
pub(super) const HEAD: &str = r#"
title = "case"
[simulation]
gravity = "0 0 -9.81 m/s^2"
max_overlap = 0.3
[material.seed]
young_modulus = "500 kPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }
tangential = { law = "mindlin-history", friction = 0.4 }
[output]
picture = false
frames = "never"
series = "2 ms"
checkpoints = "10 ms"
"#;

#[test]
fn what_comes_and_goes_is_counted_and_booked() {
    let place = tempfile::tempdir().unwrap();
    let mut watcher = watcher();
    let report = run_in(&every_exchange(), place.path(), 2, &mut watcher);
    assert_eq!(report.end, RunEnd::Finished);
    let series = series(place.path());
    let count = |title: &str| last(&series, title);
    assert_eq!(count("feed shower grains"), 30.0);
    assert!(watcher.messages.iter().any(|m| m.starts_with("feed `shower` is done")));
    assert_eq!(count("feed shower behind [kg]"), 0.0);
    // 300 per second for 60 ms, counted at the steps at which grains come
    assert!(
        (17.0..=18.0).contains(&count("feed side grains")),
        "{}",
        count("feed side grains")
    );
    // the mass that came is nearest to the one that was asked for: 0.2 g of grains of 5.0265e-6 kg
    assert_eq!(count("feed lot grains"), 40.0);
    let fed: f64 = ["shower", "side", "lot", "fill"]
        .map(|f| count(&format!("feed {f} grains")))
        .iter()
        .sum();
    let gone: f64 = ["outlet", "sieve"]
        .map(|r| count(&format!("removal {r} grains")))
        .iter()
        .sum();
    let fallen = count("removal outlet grains");
    assert!(fallen > 10.0, "{fallen} fell off the tray by {} s", count("time [s]"));
    assert_eq!(count("grains"), 1.0 + fed - gone);
    let by_material = count("removal outlet seed grains") + count("removal outlet gel grains");
    assert_eq!(by_material, count("removal outlet grains"));
    assert_eq!(count("ball traced"), 1.0);
    // 0.1 s of fall from 40 to -10 mm
    let residence = count("removal outlet mean residence [s]");
    assert!((0.03..0.16).contains(&residence), "{residence}");
    assert!(series["removal outlet mean residence [s]"][0].is_nan(), "none is gone");
    // every grain that went is listed, with what the columns sum up
    let mut reader = csv::Reader::from_path(place.path().join("removals/outlet.csv")).unwrap();
    let titles: Vec<String> = reader.headers().unwrap().iter().map(String::from).collect();
    let place_of = |title: &str| {
        titles
            .iter()
            .position(|t| t == title)
            .unwrap_or_else(|| panic!("{title}"))
    };
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let cells = |title: &str| {
        rows.iter()
            .map(move |row| row[place_of(title)].to_string())
            .collect::<Vec<_>>()
    };
    let numbers = |title: &str| {
        cells(title)
            .iter()
            .map(|cell| cell.parse().unwrap())
            .collect::<Vec<f64>>()
    };
    assert_eq!(rows.len() as f64, fallen);
    let close = |found: f64, told: f64| assert!((found / told - 1.0).abs() < 1e-9, "{found} {told}");
    close(numbers("mass [kg]").iter().sum(), count("removal outlet mass [kg]"));
    close(numbers("residence [s]").iter().sum::<f64>() / fallen, residence);
    let gel = cells("material").iter().filter(|material| *material == "gel").count();
    assert_eq!(gel as f64, count("removal outlet gel grains"));
    let named = ["shower", "side", "lot", "fill"];
    assert!(
        cells("batch").iter().all(|batch| named.contains(&batch.as_str())),
        "{:?}",
        cells("batch")
    );
    let moments = numbers("removed at [s]").into_iter().zip(numbers("time [s]"));
    assert!(
        moments.clone().all(|(gone, row)| gone <= row + 1e-12),
        "a grain is listed before it went"
    );
    assert!(
        moments.clone().any(|(gone, row)| gone < row),
        "grains go between rows, too"
    );
    assert!(numbers("z [m]").iter().all(|z| *z < -0.01));
    assert!(count("down grains forward") >= count("mouth grains forward"));
    assert_eq!(count("mouth grains forward"), 3.0);
    let slot = (count("slot grains forward"), count("slot grains backward"));
    assert_eq!(slot.0, 0.0);
    assert!((15.0..=18.0).contains(&slot.1), "{slot:?}");
    assert!(
        report.summary.energies.max_residual < 1e-3,
        "{}",
        report.summary.energies.max_residual
    );
    assert!(series["inserted energy [J]"].windows(2).any(|w| w[1] != w[0]));
    assert!(series["removed energy [J]"].windows(2).any(|w| w[1] != w[0]));
}

#[test]
fn threads_and_restarts_keep_the_bytes_of_what_comes_and_goes() {
    let place = tempfile::tempdir().unwrap();
    let folder = |name: &str| place.path().join(name);
    let scenario = every_exchange();
    run_in(&scenario, &folder("one"), 1, &mut watcher());
    run_in(&scenario, &folder("three"), 3, &mut watcher());
    let bytes = |folder: &Path, name: &str| fs::read(folder.join(name)).unwrap();
    assert!(bytes(&folder("one"), "series.csv") == bytes(&folder("three"), "series.csv"));
    let list = "removals/outlet.csv";
    assert!(bytes(&folder("one"), list) == bytes(&folder("three"), list));

    // killed at several places and gone on from the latest checkpoint
    let whole = place.path().join("killed");
    run_in(&scenario, &whole, 2, &mut watcher());
    let rows = bytes(&whole, "series.csv");
    let frame = last_frame(&whole);
    let previous = bytes(&whole, "checkpoint.previous");
    fs::write(whole.join("checkpoint.latest"), previous).unwrap();
    resume(&whole, RunOptions::default(), &mut watcher()).unwrap();
    assert!(bytes(&whole, "series.csv") == rows, "after a restart");
    assert!(bytes(&whole, list) == bytes(&folder("one"), list), "after a restart");
    assert!(fs::read(last_frame(&whole)).unwrap() == fs::read(&frame).unwrap());
    assert!(bytes(&folder("one"), "series.csv") == rows);
}

fn last_frame(folder: &Path) -> PathBuf {
    let frames = fs::read_dir(folder.join("frames")).unwrap().map(|f| f.unwrap().path());
    let grains = frames.filter(|f| f.file_name().unwrap().to_string_lossy().starts_with("grains_"));
    grains.max().unwrap()
}

#[test]
fn a_run_that_is_interrupted_while_grains_come_goes_on_to_the_same_bytes() {
    let place = tempfile::tempdir().unwrap();
    let scenario = every_exchange();
    let (straight, broken) = (place.path().join("straight"), place.path().join("broken"));
    let whole = run_in(&scenario, &straight, 2, &mut watcher());
    let mut impatient = Watcher {
        stop_at: Some(whole.summary.steps / 2),
        messages: Vec::new(),
    };
    assert_eq!(run_in(&scenario, &broken, 1, &mut impatient).end, RunEnd::Interrupted);
    let report = resume(&broken, RunOptions::default(), &mut watcher()).unwrap();
    assert_eq!(report.end, RunEnd::Finished);
    let rows = |folder: &Path| fs::read_to_string(folder.join("series.csv")).unwrap();
    assert!(rows(&straight) == rows(&broken));
}

#[test]
fn grains_that_rest_on_the_removed_carry_on() {
    // a column of three: the middle one is removed, the upper falls on the lower
    let text = format!(
        r#"{HEAD}
[domain]
lower = "-20 -20 -5 mm"
upper = "20 20 40 mm"
[[grains]]
material = "seed"
source = "list"
positions = ["0 0 0.999 mm", "0 0 2.998 mm", "0 0 4.997 mm"]
diameter = "2 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 mm"
normal = "z"
[[removal]]
name = "pick"
region = {{ shape = "sphere", center = "0 0 3 mm", radius = "0.5 mm" }}
ids = [2]
[[measure]]
name = "top"
kind = "grain-trace"
ids = [3]
[[stage]]
duration = "10 ms"
removals = []
[[stage]]
duration = "40 ms"
removals = ["pick"]
stop = {{ grains_at_most = 1 }}
"#
    );
    let place = tempfile::tempdir().unwrap();
    let report = run_in(&parse(&text), place.path(), 1, &mut watcher());
    let series = series(place.path());
    assert_eq!(last(&series, "removal pick grains"), 1.0);
    assert_eq!(report.summary.grains, 2);
    let heights = &series["top z [m]"];
    assert!(heights[0] > 4.9e-3 && *heights.last().unwrap() < 3.5e-3, "{heights:?}");
    // it falls by 2 mm: about 0.2 m/s, then less
    let fastest = series["top velocity z [m/s]"].iter().copied().fold(0.0, f64::min);
    assert!((-0.2..-0.15).contains(&fastest), "{fastest}");
    assert!(
        report.summary.energies.max_residual < 1e-3,
        "{:?}",
        report.summary.energies
    );
}

#[test]
fn profiles_and_counts_agree_and_are_the_same_bytes_after_a_restart() {
    let text = format!(
        r#"{HEAD}
[domain]
lower = "0 0 -1 mm"
upper = "20 20 60 mm"
periodic = ["x", "y"]
[[grains]]
name = "low"
material = "seed"
source = "random"
region = {{ shape = "box", lower = "0 0 0 mm", upper = "20 20 15 mm" }}
diameter = "2 mm"
count = 300
[[grains]]
name = "high"
material = "seed"
source = "random"
region = {{ shape = "box", lower = "0 0 15 mm", upper = "20 20 30 mm" }}
diameter = "2 mm"
count = 300
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 mm"
normal = "z"
[[measure]]
name = "slices"
kind = "profile"
lower = "0 0 0 mm"
upper = "20 20 60 mm"
axis = "z"
slices = 12
[[measure]]
name = "mix"
kind = "mixing"
lower = "0 0 0 mm"
upper = "20 20 60 mm"
cells = [1, 1, 4]
batch = "low"
[[measure]]
name = "bed"
kind = "surface-slope"
point = "0 0 0 mm"
along = "x"
between = ["0 mm", "20 mm"]
bins = 5
[[stage]]
duration = "0.1 s"
"#
    );
    let place = tempfile::tempdir().unwrap();
    run_in(&parse(&text), place.path(), 2, &mut watcher());
    let file = place.path().join("profiles/slices.csv");
    let bytes = fs::read(&file).unwrap();
    let mut reader = csv::Reader::from_path(&file).unwrap();
    let header: Vec<String> = reader.headers().unwrap().iter().map(String::from).collect();
    let at = |title: &str| header.iter().position(|name| name == title).unwrap();
    let rows: Vec<Vec<f64>> = (reader.records())
        .map(|row| {
            row.unwrap()
                .iter()
                .map(|cell| cell.parse().unwrap_or(f64::NAN))
                .collect()
        })
        .collect();
    let ball = std::f64::consts::PI / 6.0 * 2e-3f64.powi(3);
    let slice = 0.02 * 0.02 * 0.005;
    for moment in rows.chunks(12) {
        let sum = |title: &str| moment.iter().map(|row| row[at(title)]).sum::<f64>();
        assert_eq!(sum("grains"), 600.0);
        assert!((sum("mass [kg]") / (600.0 * 1000.0 * ball) - 1.0).abs() < 1e-12);
        // what reaches across a periodic side comes in on the other; grains that hit the floor stick out of the box below by some per cent of
        // their radius
        let filled = sum("packing fraction") * slice / (600.0 * ball);
        assert!((1.0 - 1e-4..1.0 + 1e-12).contains(&filled), "{filled}");
    }
    let last_moment = &rows[rows.len() - 12..];
    let bed = last_moment[1][at("packing fraction")];
    assert!((0.45..0.7).contains(&bed), "{bed}");
    let series = series(place.path());
    assert!(series["mix Lacey index"][0].abs() < 0.05, "apart at the start");
    assert_eq!(last(&series, "mix share"), 0.5);
    assert!(
        last(&series, "bed angle [deg]").abs() < 8.0,
        "{}",
        last(&series, "bed angle [deg]")
    );

    let previous = fs::read(place.path().join("checkpoint.previous")).unwrap();
    fs::write(place.path().join("checkpoint.latest"), previous).unwrap();
    resume(place.path(), RunOptions::default(), &mut watcher()).unwrap();
    assert!(fs::read(&file).unwrap() == bytes);
}

#[test]
fn grains_come_into_runs_of_every_integrator_and_of_coupled_and_attracting_contacts() {
    let case = |simulation: &str, contact: &str| {
        format!(
            r#"
title = "case"
[simulation]
gravity = "0 0 -9.81 m/s^2"
max_overlap = 0.3
{simulation}
[material.seed]
young_modulus = "500 kPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"
[contact]
{contact}
[domain]
lower = "-20 -20 -5 mm"
upper = "20 20 80 mm"
[[grains]]
material = "seed"
source = "list"
positions = ["0 0 1 mm", "3 0 1 mm"]
diameter = "2 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 mm"
normal = "z"
[[feed]]
name = "large"
material = "seed"
diameter = {{ distribution = "uniform", lower = "1 mm", upper = "4 mm" }}
from = {{ shape = "box", lower = "-8 -8 4 mm", upper = "8 8 16 mm" }}
count = 25
every = "4 ms"
[[removal]]
name = "pick"
region = {{ shape = "half-space", point = "5 0 0 mm", normal = "x" }}
every = "7 ms"
[[stage]]
duration = "40 ms"
[output]
picture = false
frames = "never"
series = "2 ms"
checkpoints = "10 ms"
"#
        )
    };
    let hertz = "normal = { law = \"hertz-tsuji\", restitution = 0.5 }";
    let cases = [
        ("integrator = \"gear\"", hertz.to_owned()),
        ("", format!("{hertz}\nmulti_contact = {{ law = \"half-space\", prefactor = 1.0 }}")),
        ("", "normal = { law = \"dmt\", work_of_adhesion = \"0.05 J/m^2\", alpha = 0.3, separation = \"1 um\", cutoff = \"50 um\" }".to_owned()),
    ];
    for (simulation, contact) in cases {
        let scenario = parse(&case(simulation, &contact));
        let place = tempfile::tempdir().unwrap();
        let report = run_in(&scenario, place.path(), 2, &mut watcher());
        assert_eq!(report.end, RunEnd::Finished, "{simulation}{contact}");
        let series = series(place.path());
        assert_eq!(last(&series, "feed large grains"), 25.0, "{simulation}{contact}");
        let gone = last(&series, "removal pick grains");
        assert!(gone > 0.0);
        assert_eq!(last(&series, "grains"), 27.0 - gone);
        let residual = report.summary.energies.max_residual;
        assert!(residual < 1e-3, "{simulation}{contact}: {residual}");
        let rows = fs::read(place.path().join("series.csv")).unwrap();
        let previous = fs::read(place.path().join("checkpoint.previous")).unwrap();
        fs::write(place.path().join("checkpoint.latest"), previous).unwrap();
        resume(place.path(), RunOptions::default(), &mut watcher()).unwrap();
        assert!(
            fs::read(place.path().join("series.csv")).unwrap() == rows,
            "{simulation}{contact}"
        );
    }
}
