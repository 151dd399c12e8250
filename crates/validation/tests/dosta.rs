//! The cases of Dosta et al. (2024) on small packings and walls of the same kind, made here in the format of the published files
//! and run by the same protocol, with softer and fewer grains: a ball that stops in a bed, a drum that lifts its grains, a silo
//! that empties at the rate of Beverloo.

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test tells what it measured, and may panic"
)]

use demeter_validation::dosta::{Case, DostaError, Experiment, Outcome, find_case, prepare, run_case, write_outcome};
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

type Point = [f64; 3];

/// Walls in the format of the published files.
#[derive(Default)]
struct Walls(String);

impl Walls {
    fn new() -> Self {
        Self("vertex1_X[m] vertex1_Y[m] ... vertex3_Z[m]\n".to_owned())
    }

    fn triangle(&mut self, corners: [Point; 3]) {
        let words: Vec<String> = corners.iter().flatten().map(f64::to_string).collect();
        self.0.push_str(&words.join(" "));
        self.0.push('\n');
    }

    fn quad(&mut self, [a, b, c, d]: [Point; 4]) {
        self.triangle([a, b, c]);
        self.triangle([a, c, d]);
    }

    /// Between two circles of many corners about an axis: radius and height of each; the axis is z, or y.
    fn ring(&mut self, from: [f64; 2], to: [f64; 2], about_y: bool) {
        let corners = 24;
        let at = |[radius, height]: [f64; 2], k: i32| {
            let angle = TAU * f64::from(k % corners) / f64::from(corners);
            let (a, b) = (radius * libm::cos(angle), radius * libm::sin(angle));
            if about_y { [a, height, b] } else { [a, b, height] }
        };
        for k in 0..corners {
            self.quad([at(from, k), at(from, k + 1), at(to, k + 1), at(to, k)]);
        }
    }
}

/// Grains in the format of the published files, with what follows them there.
fn particles(grains: &[(f64, Point)]) -> String {
    let mut text = String::from("Radius[m]\tPosX[m] PosY[m] PosZ[m]\n");
    for (radius, [x, y, z]) in grains {
        let _ = writeln!(text, " {radius} {x} {y} {z}");
    }
    text.push_str("\n 5 0.01 0.01 0 0 0.06\n\n");
    text
}

/// A cubic lattice from one corner to another.
fn lattice(radius: f64, lower: Point, upper: Point, inside: impl Fn(Point) -> bool) -> Vec<(f64, Point)> {
    let spacing = 2.02 * radius;
    let count = |k: usize| ((upper[k] - lower[k]) / spacing).floor() as i32;
    let mut grains = Vec::new();
    for a in 0..=count(0) {
        for b in 0..=count(1) {
            for c in 0..=count(2) {
                // layers that are shifted a little do not stand like columns
                let shift = 0.004 * radius * f64::from((a + 2 * b + 3 * c) % 3);
                let p = [
                    lower[0] + spacing * f64::from(a) + shift,
                    lower[1] + spacing * f64::from(b) + shift,
                    lower[2] + spacing * f64::from(c),
                ];
                if inside(p) {
                    grains.push((radius, p));
                }
            }
        }
    }
    grains
}

fn write(folder: &Path, name: &str, text: &str) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

fn experiment(data: &Path, until: f64, set: &[&str]) -> Experiment {
    let soft = [
        "material.m1.young_modulus=\"10 MPa\"",
        "material.steel.young_modulus=\"100 MPa\"",
        "simulation.max_overlap=0.2",
        "output.picture=false",
    ];
    Experiment {
        data: data.to_owned(),
        scenarios: Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/dosta"),
        until: Some(until),
        set: soft.iter().chain(set).map(ToString::to_string).collect(),
        threads: Some(1),
        overwrite: false,
    }
}

fn run(case: &'static Case, experiment: &Experiment, out: &Path) -> (Outcome, PathBuf) {
    let folder = match run_case(experiment, case, out, &|_| ()) {
        Ok(folder) => folder,
        Err(error) => panic!("{error}"),
    };
    let outcome = Outcome::read(case, &folder).unwrap();
    let (line, table) = write_outcome(&outcome, case, out).unwrap();
    println!("{line}");
    let rows = fs::read_to_string(table).unwrap().lines().count();
    assert_eq!(rows, outcome.rows.len() + 1);
    assert!(outcome.residual < 1e-3, "{}", outcome.residual);
    (outcome, folder)
}

/// A column of the series of a run.
fn column(folder: &Path, title: &str) -> Vec<f64> {
    let mut reader = csv::Reader::from_path(folder.join("series.csv")).unwrap();
    let at = reader.headers().unwrap().iter().position(|name| name == title).unwrap();
    reader.records().map(|row| row.unwrap()[at].parse().unwrap()).collect()
}

#[test]
fn a_ball_falls_freely_then_gives_its_energy_to_the_bed() {
    let place = tempfile::tempdir().unwrap();
    let (half, floor, top) = (0.012, -0.02, 0.03);
    let mut walls = Walls::new();
    let corner = |k: usize, z: f64| {
        let (x, y) = [(-half, -half), (half, -half), (half, half), (-half, half)][k % 4];
        [x, y, z]
    };
    walls.quad([0, 1, 2, 3].map(|k| corner(k, floor)));
    for k in 0..4 {
        walls.quad([
            corner(k, floor),
            corner(k + 1, floor),
            corner(k + 1, top),
            corner(k, top),
        ]);
    }
    let bed = lattice(1e-3, [-0.0109, -0.0109, -0.019], [0.0109, 0.0109, -0.0115], |_| true);
    write(place.path(), "penetration/walls.txt", &walls.0);
    write(place.path(), "penetration/particles-25k.txt", &particles(&bed));
    let case = find_case("penetration-25k").unwrap();
    let set = [
        "simulation.time_step=\"4e-6 s\"",
        "grains.ball.diameter=\"8 mm\"",
        "grains.ball.positions=[\"0 0 -5 mm\"]",
        "grains.ball.velocity=\"0 0 -1 m/s\"",
    ];
    let experiment = experiment(place.path(), 0.03, &set);
    let (outcome, folder) = run(case, &experiment, &place.path().join("out"));
    assert_eq!(outcome.rows.len(), 31, "a row every 1 ms");
    assert_eq!(
        outcome.grains,
        bed.len() as f64 + 1.0,
        "the lines behind the grains are none"
    );
    let falls = |t: f64| -0.005 - t - 0.5 * 9.81 * t * t;
    // the bed begins 2 mm below the ball
    for row in &outcome.rows[..2] {
        assert!((row[1] - falls(row[0])).abs() < 1e-12, "{row:?}");
    }
    let energy = |row: &[f64]| 0.5 * row[2] * row[2] + 9.81 * (row[1] - floor);
    let first = energy(&outcome.rows[0]);
    assert!(outcome.rows.iter().all(|row| energy(row) <= first * (1.0 + 1e-9)));
    let last = outcome.rows.last().unwrap();
    assert!(0.5 * last[2] * last[2] < 0.05 * 0.5, "it has nearly stopped: {last:?}");
    let lowest = outcome.rows.iter().map(|row| row[1]).fold(0.0, f64::min);
    assert!(lowest > floor + 0.004 && lowest < -0.0095, "it dug itself in: {lowest}");
    // what the ball lost is what was dissipated, what the bed gained, and nothing else
    let lost = [
        "viscous dissipation [J]",
        "friction dissipation [J]",
        "kinetic energy [J]",
        "rotational energy [J]",
        "tangential energy [J]",
        "gravitational energy [J]",
        "elastic energy [J]",
    ];
    let change = |title: &str| {
        let told = column(&folder, title);
        told.last().unwrap() - told[0]
    };
    let sum: f64 = lost.iter().map(|title| change(title)).sum();
    let whole = 0.5 * 7200.0 * PI / 6.0 * 8e-3f64.powi(3);
    assert!(sum.abs() < 1e-3 * whole, "{sum} of {whole}");
    // and a second call takes the run that is there
    let again = run_case(&experiment, case, &place.path().join("out"), &|text| {
        assert!(text.contains("taken from"))
    });
    assert_eq!(again.unwrap(), folder);
}

#[test]
fn a_drum_lifts_its_grains_on_the_side_to_which_its_floor_moves() {
    let place = tempfile::tempdir().unwrap();
    let (radius, half) = (0.02, 0.006);
    let mut walls = Walls::new();
    walls.ring([radius, -half], [radius, half], true);
    walls.ring([1e-5, -half], [radius, -half], true);
    walls.ring([1e-5, half], [radius, half], true);
    let inside =
        |reach: f64| move |p: Point| libm::hypot(p[0], p[2]) < radius - reach && p[1].abs() + reach * 0.9 < half;
    let mut grains = lattice(
        2e-3,
        [-0.0162, -0.0035, -0.017],
        [0.0162, 0.0035, -0.009],
        inside(2.3e-3),
    );
    let large = grains.len();
    grains.extend(lattice(
        1e-3,
        [-0.018, -0.0045, -0.0058],
        [0.018, 0.0045, -0.001],
        inside(1.3e-3),
    ));
    let small = grains.len() - large;
    write(place.path(), "drum/walls.txt", &walls.0);
    write(place.path(), "drum/particles.txt", &particles(&grains));
    let case = find_case("drum").unwrap();
    let set = [
        "simulation.time_step=\"8e-6 s\"",
        "material.m1.young_modulus=\"3 MPa\"",
        "material.m2.young_modulus=\"2 MPa\"",
        "material.steel.young_modulus=\"20 MPa\"",
        "wall.drum.motion={ rotation = { point = \"0 0 0 m\", axis = \"-y\", angular_velocity = \"10 rad/s\" } }",
        "output.series=\"10 ms\"",
    ];
    let (outcome, _) = run(case, &experiment(place.path(), 0.4, &set), &place.path().join("out"));
    assert_eq!(outcome.grains, (small + large) as f64);
    assert!(small > 100 && large > 15, "{small} and {large}");
    let first = &outcome.rows[0];
    // at the start the bed is symmetric and below the axis
    assert_eq!([first[1], first[2]], [0.0; 2]);
    assert!(
        (first[3] / small as f64 - 0.5).abs() < 0.1 && (first[4] / large as f64 - 0.5).abs() < 0.15,
        "{first:?}"
    );
    for row in &outcome.rows {
        assert!(
            row[1] + row[3] <= small as f64 && row[2] + row[4] <= large as f64,
            "{row:?}"
        );
    }
    let steady = &outcome.rows[outcome.rows.len() - 10..];
    let mean = |k: usize| steady.iter().map(|row| row[k]).sum::<f64>() / steady.len() as f64;
    // the floor moves to +x: grains rise there and leave the other side
    let share = (mean(3) + mean(4)) / (small + large) as f64;
    assert!(
        (0.05..0.35).contains(&share),
        "{share} of the grains are left in zone 2"
    );
    let scatter = steady.iter().map(|row| (row[3] - mean(3)).abs()).fold(0.0, f64::max);
    // after two thirds of a turn the bed still swings, as that of the benchmark does
    assert!(scatter < 0.2 * small as f64, "{scatter} around {}", mean(3));
}

#[test]
fn a_silo_empties_at_a_steady_rate_near_that_of_beverloo() {
    let place = tempfile::tempdir().unwrap();
    let (radius, orifice) = (0.010, 0.005);
    let mut walls = Walls::new();
    walls.ring([orifice, 0.0], [radius, 0.0], false);
    walls.ring([radius, 0.0], [radius, 0.07], false);
    write(place.path(), "silo/walls-small.txt", &walls.0);
    let case = find_case("silo-small-m1").unwrap();
    let grains = 900;
    let set = [
        "simulation.time_step=\"8e-6 s\"",
        "material.m1.young_modulus=\"3 MPa\"",
        "material.steel.young_modulus=\"20 MPa\"",
        "feed.filling.count=900",
        "feed.filling.diameter=\"2 mm\"",
        "feed.filling.from={ shape = \"disc\", center = \"0 0 60 mm\", normal = \"-z\", radius = \"9 mm\" }",
        "wall.cover.center=\"0 0 0 mm\"",
        "wall.cover.radius=\"6 mm\"",
        "removal.below.region.point=\"0 0 -20 mm\"",
        "measure.left.region.point=\"0 0 0 mm\"",
        "measure.orifice.gate.point=\"0 0 0 mm\"",
        "stage.settle.stop={ kinetic_over_elastic = 0.2 }",
        "output.series=\"10 ms\"",
    ];
    let (outcome, folder) = run(case, &experiment(place.path(), 0.4, &set), &place.path().join("out"));
    let first = &outcome.rows[0];
    assert_eq!((first[0], first[1]), (0.0, f64::from(grains)), "filled, and closed");
    let last = |title: &str| *column(&folder, title).last().unwrap();
    assert_eq!(last("feed filling grains"), f64::from(grains));
    let (removed, left) = (last("removal below grains"), outcome.rows.last().unwrap()[1]);
    assert_eq!(removed + last("grains"), f64::from(grains));
    assert_eq!(
        last("orifice grains forward") - last("orifice grains backward"),
        f64::from(grains) - left
    );
    // grains between the orifice and the place where they are removed: 20 mm of free fall
    let falling = f64::from(grains) - left - removed;
    assert!(
        removed > 200.0 && (1.0..100.0).contains(&falling),
        "{removed} and {falling}"
    );
    let rate = |from: f64, to: f64| {
        let within: Vec<f64> = (outcome.rows.iter())
            .filter(|row| row[0] > from && row[0] <= to + 1e-9)
            .map(|row| row[2])
            .collect();
        within.iter().sum::<f64>() / within.len() as f64
    };
    let rates = [rate(0.1, 0.2), rate(0.2, 0.3), rate(0.3, 0.4)];
    let mean = rates.iter().sum::<f64>() / 3.0;
    println!("rates {rates:?} kg/s");
    // about 100 grains in 0.1 s: each rate scatters by a tenth
    assert!(rates.iter().all(|r| (r / mean - 1.0).abs() < 0.3), "{rates:?}");
    // Beverloo with C = 0.58, k = 1.4 and a bulk density of 0.58 x 2500 kg/m^3; C and k scatter between packings
    let opening = 2.0 * orifice - 1.4 * 2e-3;
    let beverloo = 0.58 * 0.58 * 2500.0 * 9.81f64.sqrt() * opening.powf(2.5);
    assert!((0.6..1.6).contains(&(mean / beverloo)), "{mean} beside {beverloo}");
}

#[test]
fn files_and_cases_that_are_none_are_told() {
    let place = tempfile::tempdir().unwrap();
    assert!(matches!(find_case("silo"), Err(DostaError::UnknownCase { .. })));
    let case = find_case("silo-large-m2").unwrap();
    let told = |text: &str| {
        write(place.path(), "silo/walls-large.txt", text);
        prepare(case, place.path(), &place.path().join("input")).map_err(|e| e.to_string())
    };
    assert!(told("header\n1 2 3 4 5 6 7 8 9\n").is_ok());
    assert!(
        told("header\n1 2 3 4 5 6 7 8\n")
            .unwrap_err()
            .contains("no line of 9 numbers")
    );
    let error = told("header\n1 2 3 4 5 6 7 8 9\n\n1 2 3 4 5 6 7 8 x\n").unwrap_err();
    assert!(error.contains("in line 4"), "{error}");
    fs::remove_file(place.path().join("silo/walls-large.txt")).unwrap();
    let error = prepare(case, place.path(), &place.path().join("input")).unwrap_err();
    assert!(error.to_string().contains("walls-large.txt"), "{error}");
}

#[test]
fn every_case_names_what_its_scenario_has() {
    let place = tempfile::tempdir().unwrap();
    let scenarios = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/dosta");
    for case in demeter_validation::dosta::CASES {
        let input = place.path().join(case.name);
        for name in ["walls.stl", "bed.csv", "m1.csv", "m2.csv"] {
            write(&input, name, "x,y,z,radius\n0,0,0,0.001\n");
        }
        let experiment = Experiment {
            data: PathBuf::new(),
            scenarios: scenarios.clone(),
            until: Some(1.5),
            set: Vec::new(),
            threads: None,
            overwrite: false,
        };
        let files = demeter_validation::dosta::Files {
            folder: input,
            grains: 1,
            triangles: 1,
        };
        let scenario = match experiment.scenario_of(&case, &files) {
            Ok(scenario) => scenario,
            Err(error) => panic!("{}: {error}", case.name),
        };
        let longest = scenario.stages.last().unwrap().stop.clone();
        let expected = demeter::simulation::StopCondition::Duration(1.5);
        assert_eq!(longest, [expected], "{}", case.name);
    }
}
