//! Fields, tags, paths and regions of whole runs: what they tell, and that threads and restarts keep their bytes.

use demeter::scenario::{Observer, Progress, Report, RunEnd, RunOptions, Scenario, resume, run};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

struct Watcher;

impl Observer for Watcher {
    fn progress(&mut self, _: &Progress) -> bool {
        true
    }

    fn message(&mut self, _: &str) {}
}

fn run_in(scenario: &Scenario, folder: &Path, threads: usize) -> Report {
    let options = RunOptions {
        threads: Some(threads),
        ..RunOptions::default()
    };
    run(scenario, folder, options, &mut Watcher).unwrap()
}

fn parse(text: &str) -> Scenario {
    match Scenario::parse(text, "case", Path::new(""), &[]) {
        Ok(scenario) => scenario,
        Err(faults) => panic!("{}", faults.render(false)),
    }
}

fn every_field() -> Scenario {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/good/every_field.toml");
    match Scenario::read(&file, &[]) {
        Ok(scenario) => scenario,
        Err(faults) => panic!("{}", faults.render(false)),
    }
}

/// Columns of a table by title.
fn table(file: &Path) -> BTreeMap<String, Vec<f64>> {
    let mut reader = csv::Reader::from_path(file).unwrap();
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

/// The part of a table that belongs to its last step.
fn last_step(table: &BTreeMap<String, Vec<f64>>) -> BTreeMap<&str, Vec<f64>> {
    let steps = &table["step"];
    let last = *steps.last().unwrap();
    let of_last = |values: &[f64]| {
        let pairs = values.iter().zip(steps);
        pairs
            .filter(|(_, step)| **step == last)
            .map(|(value, _)| *value)
            .collect()
    };
    table
        .iter()
        .map(|(title, values)| (title.as_str(), of_last(values)))
        .collect()
}

fn last(series: &BTreeMap<String, Vec<f64>>, title: &str) -> f64 {
    *series.get(title).unwrap_or_else(|| panic!("{title}")).last().unwrap()
}

/// All files of results with their bytes.
fn results(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut files = BTreeMap::new();
    for sub in ["", "fields", "chains", "paths", "distributions", "profiles", "frames"] {
        for file in fs::read_dir(folder.join(sub)).unwrap().map(|f| f.unwrap().path()) {
            let name = file.strip_prefix(folder).unwrap().to_owned();
            let ending = name.extension().and_then(|e| e.to_str()).unwrap_or_default();
            if ["csv", "vti", "vtp", "pvd"].contains(&ending) {
                files.insert(name, fs::read(&file).unwrap());
            }
        }
    }
    files
}

fn assert_same(one: &BTreeMap<PathBuf, Vec<u8>>, other: &BTreeMap<PathBuf, Vec<u8>>, what: &str) {
    assert_eq!(
        one.keys().collect::<Vec<_>>(),
        other.keys().collect::<Vec<_>>(),
        "{what}"
    );
    for (name, bytes) in one {
        assert!(*bytes == other[name], "{what}: {}", name.display());
    }
}

#[test]
fn threads_and_restarts_keep_the_bytes_of_all_that_is_told() {
    let place = tempfile::tempdir().unwrap();
    let folder = |name: &str| place.path().join(name);
    let scenario = every_field();
    let report = run_in(&scenario, &folder("one"), 1);
    assert_eq!(report.end, RunEnd::Finished);
    run_in(&scenario, &folder("three"), 3);
    let told = results(&folder("one"));
    for name in [
        "fields/column.csv",
        "fields/map.pvd",
        "fields/whole.pvd",
        "chains/chains.pvd",
        "paths/tracers.vtp",
        "distributions/rose.csv",
        "distributions/stay.csv",
        "distributions/hits.csv",
        "profiles/rings.csv",
    ] {
        assert!(told.contains_key(Path::new(name)), "{name}");
    }
    assert_same(&told, &results(&folder("three")), "threads");

    // gone on from the checkpoint before the last
    let previous = fs::read(folder("three").join("checkpoint.previous")).unwrap();
    fs::write(folder("three").join("checkpoint.latest"), previous).unwrap();
    resume(&folder("three"), RunOptions::default(), &mut Watcher).unwrap();
    assert_same(&told, &results(&folder("three")), "restart");

    let series = table(&folder("one").join("series.csv"));
    let count = |title: &str| last(&series, title);
    // gel that comes through the hatch is tagged while it is in the bucket
    assert_eq!(series["tagged grains"][0], 0.0);
    assert!(
        series["tagged grains"].iter().any(|n| *n > 0.0),
        "{:?}",
        series["tagged grains"]
    );
    assert!(count("stay inside") > 0.0 && count("stay left") > 0.0);
    assert!(count("moved displaced grains") > 5.0);
    assert!(count("fabric counted contacts") > 0.0 && count("fabric contacts per grain") > 0.0);
    let chains = fs::read(newest(&folder("one"), "chains", "chains_")).unwrap();
    let head = String::from_utf8_lossy(&chains[..1500]).into_owned();
    assert!(
        head.contains("NumberOfLines=") && !head.contains("NumberOfLines=\"0\""),
        "{head}"
    );
    let trace: f64 = ["xx", "yy", "zz"]
        .map(|k| count(&format!("fabric fabric {k}")))
        .iter()
        .sum();
    assert!((trace - 1.0).abs() < 1e-12);
    let mass = table(&folder("one").join("distributions/stay.csv"));
    let (all, above) = (last(&mass, "mass left [kg]"), last(&mass, "above"));
    assert!((all - count("stay mass left [kg]")).abs() < 1e-15 && above <= all);
    let hits = table(&folder("one").join("distributions/hits.csv"));
    let (all, in_bucket) = (count("hits collisions"), count("hits-in-bucket collisions"));
    assert!(all > 100.0 && in_bucket > 0.0 && in_bucket < all, "{all} {in_bucket}");
    assert_eq!(last(&hits, "collisions"), count("hits wall collisions"));
    let paths = last_step(&table(&folder("one").join("paths/tracers.csv")))["id"].clone();
    assert!(
        (1..=5).contains(&paths.len()) && paths.windows(2).all(|w| w[0] < w[1]),
        "{paths:?}"
    );
}

/// Grains that settle on a floor between periodic sides.
const SETTLED: &str = r#"
title = "settled"
[simulation]
gravity = "0 0 -9.81 m/s^2"
max_overlap = 0.3
[domain]
lower = "0 0 -5 mm"
upper = "10 10 40 mm"
periodic = ["x", "y"]
[material.seed]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "2000 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.1 }
tangential = { law = "mindlin-history", friction = 0.5 }
[[grains]]
material = "seed"
source = "random"
region = { shape = "box", lower = "0 0 0 mm", upper = "10 10 25 mm" }
diameter = { distribution = "uniform", lower = "1.8 mm", upper = "2.4 mm" }
count = 220
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 mm"
normal = "z"
[[measure]]
name = "column"
kind = "field"
cells = [1, 1, 450]
width = "4 mm"
[[measure]]
name = "box"
kind = "field"
cells = [1, 1, 1]
width = "4 mm"
[[measure]]
name = "map"
kind = "field"
cells = [8, 8, 32]
width = "4 mm"
[output]
picture = false
series = "50 ms"
frames = "0.3 s"
checkpoints = "never"
[[stage]]
duration = "0.3 s"
"#;

#[test]
fn a_settled_column_carries_its_weight() {
    let place = tempfile::tempdir().unwrap();
    let report = run_in(&parse(SETTLED), place.path(), 2);
    assert_eq!(report.end, RunEnd::Finished);
    let column = table(&place.path().join("fields/column.csv"));
    let column = last_step(&column);
    let series = table(&place.path().join("series.csv"));
    let (g, step, area) = (9.81, 45e-3 / 450.0, 1e-4);
    let mass: f64 = column["density [kg/m^3]"].iter().sum::<f64>() * step * area;
    let one = table(&place.path().join("fields/box.csv"));
    let one = last_step(&one);
    let whole = one["density [kg/m^3]"][0] * area * 45e-3;
    assert!((mass / whole - 1.0).abs() < 1e-6, "{mass} {whole}");
    // from the top down: what lies above is carried by stress, and by the floor where it pushes
    let weight = whole * g / area;
    let stress = &column["contact stress zz [Pa]"];
    let (mut above, mut largest) = (0.0, 0.0f64);
    for k in (0..450).rev() {
        let load = (column["density [kg/m^3]"][k] * g - column["traction z [N/m^3]"][k]) * step;
        let kinetic = column["kinetic stress zz [Pa]"][k];
        let off = (stress[k] + kinetic - above - 0.5 * load).abs();
        largest = largest.max(off);
        above += load;
    }
    assert!(largest < 0.01 * weight, "{largest} of {weight} Pa");
    let most = stress.iter().copied().fold(0.0, f64::max);
    assert!(most > 0.6 * weight && most < 1.05 * weight, "{most} of {weight}");
    // the floor pushes as much as it is pushed
    let traction: f64 = column["traction z [N/m^3]"].iter().sum::<f64>() * step * area;
    let floor = last(&series, "wall floor force z [N]");
    assert!((traction / -floor - 1.0).abs() < 1e-6, "{traction} {floor}");
    // one cell tells the sum of force times branch, as the stress of every series does, over another volume
    let told = last(&series, "stress zz [Pa]") / one["contact stress zz [Pa]"][0];
    let other = last(&series, "stress xx [Pa]") / one["contact stress xx [Pa]"][0];
    assert!((told / other - 1.0).abs() < 1e-10, "{told} {other}");
    let map = fs::read(newest(place.path(), "fields", "map_")).unwrap();
    let head = String::from_utf8_lossy(&map[..2000]).into_owned();
    assert!(
        head.contains("WholeExtent=\"0 8 0 8 0 32\"") && head.contains("Name=\"contact_stress\""),
        "{head}"
    );
}

/// The latest file of a collection.
fn newest(folder: &Path, sub: &str, start: &str) -> PathBuf {
    let files = fs::read_dir(folder.join(sub)).unwrap().map(|f| f.unwrap().path());
    let ours = files.filter(|f| f.extension().is_some_and(|e| e == "vti" || e == "vtp"));
    ours.filter(|f| f.file_name().unwrap().to_string_lossy().starts_with(start))
        .max()
        .unwrap()
}
