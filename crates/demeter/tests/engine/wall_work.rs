//! What passes between walls and grains, over stages and the run.

use super::silent::{Silent, parsed};
use demeter::contacts::Fault;
use demeter::results::Columns;
use demeter::scenario::{RunEnd, RunOptions, run};
use serde_json::Value;
use std::f64::consts::TAU;
use std::path::Path;

/// Grains that are pressed together by a plate, and then stirred by a drum that turns while the plate is away.
const PRESSED_AND_TURNED: &str = r#"
title = "pressed and turned"
[simulation]
gravity = "0 0 -9.81 m/s^2"
max_overlap = 0.3
[material.seed]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "2000 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.3 }
tangential = { law = "mindlin-history", friction = 0.5 }
[[grains]]
material = "seed"
source = "random"
region = { shape = "cylinder", start = "0 -5 0 mm", end = "0 5 0 mm", radius = "11 mm" }
diameter = "2 mm"
count = 150
[[wall]]
name = "drum"
material = "seed"
shape = "cylinder"
start = "0 -5 0 mm"
end = "0 5 0 mm"
radius = "12 mm"
[[wall]]
name = "front"
material = "seed"
shape = "plane"
point = "0 -5 0 mm"
normal = "y"
[[wall]]
name = "plate"
material = "seed"
shape = "plane"
point = "0 5 0 mm"
normal = "-y"
[[stage]]
name = "press"
duration = "20 ms"
motion.plate = { velocity = "0 -0.1 0 m/s" }
[[stage]]
name = "turn"
duration = "50 ms"
motion.plate = "rest"
motion.drum = { rotation = { point = "0 0 0 mm", axis = "y", angular_velocity = "2 rad/s" } }
"#;

fn vector(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|k| value[k].as_f64().unwrap())
}

#[test]
fn works_of_walls_add_up_to_the_books_and_forces_to_the_momentum() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("run");
    let scenario = parsed(PRESSED_AND_TURNED, Path::new(""));
    run(&scenario, &folder, RunOptions::default(), &mut Silent).unwrap();
    let summary: Value = serde_json::from_slice(&std::fs::read(folder.join("summary.json")).unwrap()).unwrap();
    let names = ["drum", "front", "plate"];
    let of = |walls: &Value, key: &str| -> f64 { names.iter().map(|name| walls[name][key].as_f64().unwrap()).sum() };
    let all = of(&summary["walls"], "work");
    let booked = summary["energies"]["wall_work"].as_f64().unwrap();
    assert!(all > 1e-6 && (all / booked - 1.0).abs() < 1e-9, "{all} {booked}");
    let stages = summary["stages"].as_array().unwrap();
    let of_stages: f64 = stages.iter().map(|stage| of(&stage["walls"], "work")).sum();
    assert!((all / of_stages - 1.0).abs() < 1e-12, "{all} {of_stages}");
    // each at its time
    let work = |stage: usize, wall: &str| stages[stage]["walls"][wall]["work"].as_f64().unwrap();
    assert!(work(0, "plate") > 0.0 && work(1, "drum") > 0.0);
    assert_eq!([work(0, "front"), work(1, "front"), work(0, "drum")], [0.0; 3]);

    let turned = &stages[1]["walls"]["drum"];
    let seconds = stages[1]["end"].as_f64().unwrap() - stages[1]["start"].as_f64().unwrap();
    let power = turned["mean_power"].as_f64().unwrap();
    let [_, torque, _] = vector(&turned["mean_torque"]);
    assert!((power * seconds / work(1, "drum") - 1.0).abs() < 1e-9);
    // but for the half step in which the drum began to turn
    assert!((-2.0 * torque / power - 1.0).abs() < 1e-2, "{torque} {power}");

    // what the grains got from gravity and did not keep they gave to the walls
    let series = Columns::series_of(&folder).unwrap();
    let at_end = |title: &str| *series.numbers(title).unwrap().last().unwrap();
    let end = summary["simulated_time"].as_f64().unwrap();
    let mass = 150.0 * 2000.0 * TAU / 12.0 * 2e-3_f64.powi(3);
    for (axis, gravity) in [("x", 0.0), ("y", 0.0), ("z", -9.81)] {
        let k = usize::from(axis.as_bytes()[0] - b'x');
        let given: f64 = (names.iter())
            .map(|name| end * vector(&summary["walls"][name]["mean_force"])[k])
            .sum();
        let kept = at_end(&format!("momentum {axis}"));
        let missing = mass * gravity * end - kept - given;
        assert!(missing.abs() < 1e-9 * mass * 9.81 * end, "{axis}: {missing}");
    }
    let last = at_end("wall plate work");
    assert_eq!(last, summary["walls"]["plate"]["work"].as_f64().unwrap());
}

/// Contacts do not feel what of a belt points along their normal.
#[test]
fn the_work_of_a_belt_that_is_told_off_its_plane_is_that_of_the_books() {
    let inclined = r#"
title = "inclined"
[simulation]
gravity = "0 0 -9.81 m/s^2"
[material.seed]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "2000 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.3 }
tangential = { law = "mindlin-history", friction = 0.5 }
[[grains]]
material = "seed"
source = "list"
positions = ["0 0 1.04 mm"]
diameter = "2 mm"
[[wall]]
name = "belt"
material = "seed"
shape = "rectangle"
center = "0 0 0 mm"
half_u = "50 0 13 mm"
half_v = "0 20 0 mm"
motion = { belt = "0.1 0 0 m/s" }
[[stage]]
duration = "20 ms"
"#;
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("run");
    run(
        &parsed(inclined, Path::new("")),
        &folder,
        RunOptions::default(),
        &mut Silent,
    )
    .unwrap();
    let summary: Value = serde_json::from_slice(&std::fs::read(folder.join("summary.json")).unwrap()).unwrap();
    let work = summary["walls"]["belt"]["work"].as_f64().unwrap();
    let booked = summary["energies"]["wall_work"].as_f64().unwrap();
    assert!(work > 0.0 && (work / booked - 1.0).abs() < 1e-6, "{work} {booked}");
}

/// The work of the plates in the step in which an overlap was too deep was not booked: 8.8e-4 of the energy.
#[test]
fn the_ledger_closes_where_a_run_stops_as_an_overlap_is_too_deep() {
    let squeezed = r#"
title = "squeezed"
[material.steel]
young_modulus = "1 GPa"
poisson_ratio = 0.3
density = "7800 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }
[[grains]]
material = "steel"
source = "list"
positions = ["0 0 0 mm"]
diameter = "10 mm"
[[wall]]
name = "bottom"
material = "steel"
shape = "plane"
point = "0 0 -5 mm"
normal = "z"
motion = { velocity = "0 0 0.1 m/s" }
[[wall]]
name = "top"
material = "steel"
shape = "plane"
point = "0 0 5 mm"
normal = "-z"
motion = { velocity = "0 0 -0.1 m/s" }
[[stage]]
name = "squeeze"
duration = "3 ms"
"#;
    for coupling in ["", "multi_contact = { law = \"half-space\" }\n"] {
        let text = squeezed.replace("[[grains]]", &format!("{coupling}[[grains]]"));
        let place = tempfile::tempdir().unwrap();
        let scenario = parsed(&text, place.path());
        let report = run(&scenario, &place.path().join("run"), RunOptions::default(), &mut Silent).unwrap();
        assert!(
            matches!(report.end, RunEnd::Fault(Fault::Overlap { .. })),
            "{:?}",
            report.end
        );
        let residual = report.summary.energies.ledger.residual;
        assert!(residual.abs() < 1e-4, "{residual:e}");
    }
}

/// A servo has another speed in every step; springs act with both speeds, one on each side of a moment, and the residual was of first order
/// in the time step: 2e-3 in the coarser of these.
#[test]
fn the_residual_of_a_servo_falls_with_the_square_of_the_step() {
    let pressed = r#"
title = "pressed"
[simulation]
time_step = "STEP"
[material.steel]
young_modulus = "1 GPa"
poisson_ratio = 0.3
density = "7800 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = RESTITUTION }
[[grains]]
material = "steel"
source = "list"
positions = ["0 0 0 mm"]
diameter = "10 mm"
[[wall]]
name = "floor"
material = "steel"
shape = "plane"
point = "0 0 -5 mm"
normal = "z"
[[wall]]
name = "plate"
material = "steel"
shape = "plane"
point = "0 0 5.01 mm"
normal = "-z"
motion = { with = "press" }
[[wall]]
name = "press"
material = "steel"
shape = "plane"
point = "0 0 8 mm"
normal = "-z"
motion = { servo = { axis = "-z", force = "50 N", max_speed = "0.2 m/s" } }
[[stage]]
name = "press"
duration = "2 ms"
"#;
    let residual = |restitution: &str, step: &str| {
        let text = pressed.replace("STEP", step).replace("RESTITUTION", restitution);
        let place = tempfile::tempdir().unwrap();
        let scenario = parsed(&text, place.path());
        let report = run(&scenario, &place.path().join("run"), RunOptions::default(), &mut Silent).unwrap();
        let energies = &report.summary.energies;
        let works: f64 = report.summary.walls.values().map(|wall| wall.work).sum();
        assert!((works / energies.ledger.wall_work - 1.0).abs() < 1e-9, "{energies:?}");
        energies.ledger.residual.abs()
    };
    // without dashpots, and with: these are booked with the speeds at the moments of their forces
    for restitution in ["1.0", "0.5"] {
        let (coarse, fine) = (residual(restitution, "2 us"), residual(restitution, "1 us"));
        assert!(
            coarse < 3e-5 && coarse > 2.5 * fine,
            "{restitution}: {coarse:e} {fine:e}"
        );
    }
}

/// A grain on a floor, and a lid that a servo presses on it from the second stage on. A hook moves with the lid.
const LID_TO_COME: &str = r#"
[domain]
lower = "-10 -10 -10 mm"
upper = "10 10 60 mm"
[material.seed]
young_modulus = "5 MPa"
poisson_ratio = 0.3
density = "2500 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }
[[grains]]
material = "seed"
source = "list"
positions = ["0 0 0.99 mm"]
diameter = "2 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 mm"
normal = "z"
[[wall]]
name = "lid"
material = "seed"
shape = "plane"
point = "0 0 5 mm"
normal = "-z"
motion = { servo = { axis = "-z", force = "1 mN", max_speed = "0.5 m/s" } }
[[wall]]
name = "hook"
material = "seed"
shape = "disc"
center = "0 0 40 mm"
normal = "z"
radius = "2 mm"
motion = { with = "lid" }
[[stage]]
name = "wait"
duration = "4 ms"
absent = ["lid", "hook"]
[[stage]]
name = "press"
duration = "20 ms"
absent = []
[output]
picture = false
report = false
"#;

#[test]
fn a_servo_rests_while_its_wall_is_absent() {
    let place = tempfile::tempdir().unwrap();
    let ways = |text: &str| {
        let folder = place.path().join("run");
        let options = RunOptions {
            overwrite: true,
            ..RunOptions::default()
        };
        run(&parsed(text, Path::new("")), &folder, options, &mut Silent).unwrap();
        let series = Columns::read(&folder.join("series.csv")).unwrap();
        let way = series.numbers("wall lid displacement z [m]").unwrap();
        let time = series.numbers("time [s]").unwrap();
        let waited = time.iter().position(|time| *time > 3.9e-3).unwrap();
        [way[waited], way[way.len() - 1]]
    };
    let [waiting, pressing] = ways(LID_TO_COME);
    assert_eq!(waiting, 0.0);
    assert!(pressing < -2.9e-3 && pressing > -3.1e-3, "{pressing}");
    // what moves with it is there
    let [waiting, _] = ways(&LID_TO_COME.replace("[\"lid\", \"hook\"]", "[\"lid\"]"));
    assert!(waiting < -1.9e-3, "{waiting}");
}
