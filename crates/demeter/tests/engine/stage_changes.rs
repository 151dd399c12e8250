//! What stages change of what acts on the grains.

use super::exchange::{last, parse, run_in, series, watcher};
use demeter::scenario::{RunEnd, prepare};

/// A grain that flies, with a gravity in every stage.
#[test]
fn gravity_of_a_stage_acts_from_its_first_step_on() {
    for (integrator, tolerance) in [("velocity-verlet", 1e-12), ("gear", 1e-4)] {
        flies(integrator, tolerance);
    }
}

fn flies(integrator: &str, tolerance: f64) {
    let place = tempfile::tempdir().unwrap();
    let scenario = parse(&format!(
        r#"
[simulation]
integrator = "{integrator}"
gravity = "0 0 -10 m/s^2"
time_step = "10 us"
allow_unsafe_time_step = true
[material.seed]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"
[contact]
normal = {{ law = "hertz-tsuji", restitution = 0.5 }}
[[grains]]
material = "seed"
source = "list"
positions = [["0 m", "0 m", "0 m"]]
diameter = "2 mm"
[[stage]]
repeat = 2
[[stage.stage]]
steps = 10
gravity = "100 0 0 m/s^2"
[[stage.stage]]
steps = 20
[[stage.stage]]
steps = 30
gravity = "0 200 0 m/s^2"
[output]
report = false
picture = false
"#
    ));
    let report = run_in(&scenario, place.path(), 1, &mut watcher());
    assert_eq!(report.end, RunEnd::Finished);
    let series = series(place.path());
    let mass = 1000.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-9;
    for (axis, expected) in [("x", 2.0 * 30.0 * 100.0), ("y", 2.0 * 30.0 * 200.0), ("z", 0.0)] {
        let velocity = last(&series, &format!("momentum {axis} [kg m/s]")) / mass;
        assert!(
            (velocity - expected * 1e-5).abs() < tolerance,
            "{integrator}, {axis}: {velocity}"
        );
    }
    let residual = series["energy residual"]
        .iter()
        .fold(0.0f64, |most, r| most.max(r.abs()));
    assert!(residual < 10.0 * tolerance, "{integrator}: {residual}");
    assert!(last(&series, "custom work [J]") != 0.0);
}

/// What the scenarios of changing laws have in common.
const HEAD: &str = r#"
simulation.gravity = "0 0 -10 m/s^2"
[material.seed]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"
[output]
series = "1 ms"
report = false
picture = false
"#;

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

/// A grain that slides over a floor: without friction at first, then until it rolls, with 5/7 of its speed.
#[test]
fn friction_of_a_stage_acts_from_its_first_step_on() {
    let place = tempfile::tempdir().unwrap();
    let scenario = parse(&format!(
        r#"{HEAD}
[contact]
normal = {{ law = "hertz-tsuji", restitution = 0.2 }}
tangential = {{ law = "mindlin-history", friction = 0.2 }}
[[grains]]
material = "seed"
source = "list"
positions = [["0 m", "0 m", "1 mm"]]
velocity = "0.5 0 0 m/s"
diameter = "2 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 m"
normal = "z"
[[stage]]
duration = "20 ms"
contact = {{ tangential = {{ friction = 0 }} }}
[[stage]]
duration = "50 ms"
contact = {{}}
[[stage]]
duration = "50 ms"
contact = {{ tangential = {{ friction = 0.4 }} }}
"#
    ));
    let report = run_in(&scenario, place.path(), 1, &mut watcher());
    assert_eq!(report.end, RunEnd::Finished);
    let series = series(place.path());
    let mass = 1000.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-9;
    let speed_at = |moment: f64| {
        let row = series["time [s]"]
            .iter()
            .position(|t| (t - moment).abs() < 1e-5)
            .unwrap();
        series["momentum x [kg m/s]"][row] / mass
    };
    assert!((speed_at(0.02) - 0.5).abs() < 1e-9, "{}", speed_at(0.02));
    // until 5/7 are left, which takes 71 ms with 0.2 alone, less where 0.4 follows
    for (moment, expected) in [(0.05, 0.44), (0.07, 0.4), (0.08, 0.36), (0.12, 2.5 / 7.0)] {
        let speed = speed_at(moment);
        assert!((speed - expected).abs() < 2e-3, "{moment} s: {speed} for {expected}");
    }
    let residual = largest(&series["energy residual"]);
    assert!(residual < 2e-5, "{residual}");
}

/// A grain at rest on a spring that becomes four times as stiff, and another that hangs on a wall of another material.
#[test]
fn other_springs_of_a_stage_are_booked_as_work_from_outside() {
    let place = tempfile::tempdir().unwrap();
    let scenario = |stage: &str| {
        parse(&format!(
            r#"{HEAD}
[material.rubber]
young_modulus = "1 MPa"
poisson_ratio = 0.4
density = "1000 kg/m^3"
[contact]
normal = {{ law = "linear", stiffness = "1 N/m", restitution = 0.2 }}
[[contact.pair]]
between = ["seed", "rubber"]
normal = {{ stiffness = "2 N/m" }}
[[grains]]
material = "seed"
source = "list"
positions = [["0 m", "0 m", "0.96 mm"], ["9 mm", "0 m", "0.98 mm"]]
diameter = "2 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "rectangle"
center = "0 0 0 m"
half_u = "4 0 0 mm"
half_v = "0 4 0 mm"
[[wall]]
name = "other floor"
material = "rubber"
shape = "rectangle"
center = "9 0 0 mm"
half_u = "4 0 0 mm"
half_v = "0 4 0 mm"
[[stage]]
duration = "0.2 s"
[[stage]]
name = "stiff"
duration = "1 ms"
{stage}
"#
        ))
    };
    let told = scenario(r#"contact = { normal = { stiffness = "4 N/m" } }"#);
    let report = run_in(&told, place.path(), 1, &mut watcher());
    assert_eq!(report.end, RunEnd::Finished);
    let series = series(place.path());
    // d = m g / k with k = 1 and 2 N/m stores k d^2/2, and with 4 N/m four times and twice as much
    let weight = 1000.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-9 * 10.0;
    let stored = [1.0, 2.0].map(|stiffness| weight * weight / (2.0 * stiffness));
    let expected = 3.0 * stored[0] + stored[1];
    let work = last(&series, "custom work [J]");
    assert!((work / expected - 1.0).abs() < 1e-3, "{work} for {expected}");
    let residual = largest(&series["energy residual"]);
    assert!(residual < 5e-5, "{residual}");
    // the time step is that of the stiffest laws of all stages
    let scale = |stage: &str| prepare(&scenario(stage)).unwrap().time_scale.time;
    let ratio = scale("") / scale(r#"contact = { normal = { stiffness = "8 N/m" } }"#);
    assert!((ratio * ratio - 8.0).abs() < 1e-9, "{ratio}");
    let of_one_pair = r#"contact = { pair = [{ between = ["seed", "rubber"], normal = { stiffness = "8 N/m" } }] }"#;
    assert!((scale("") / scale(of_one_pair) - 2.0).abs() < 1e-9);
}

/// Grains that fly about and rub each other: the error of the books is that of the time step, before and behind the change.
#[test]
fn books_go_on_where_laws_change_among_rubbing_grains() {
    let residual = |time_step: &str| {
        let place = tempfile::tempdir().unwrap();
        let scenario = parse(&format!(
            r#"simulation.time_step = "{time_step}"
simulation.max_overlap = 0.3
{HEAD}
[contact]
normal = {{ law = "hertz-tsuji", restitution = 0.7 }}
tangential = {{ law = "mindlin-history", friction = 0.4 }}
[[grains]]
material = "seed"
source = "lattice"
lattice = "simple-cubic"
spacing = "2 mm"
region = {{ shape = "box", lower = "0 0 0 mm", upper = "14 14 14 mm" }}
diameter = {{ distribution = "uniform", lower = "1.8 mm", upper = "2 mm" }}
velocity_deviation = "0.2 m/s"
[[wall]]
name = "box"
material = "seed"
shape = "box"
lower = "0 0 0 mm"
upper = "14 14 14 mm"
[[stage]]
duration = "2 ms"
[[stage]]
duration = "1 ms"
contact = {{ normal = {{ restitution = 0.3 }}, tangential = {{ friction = 0.1 }} }}
"#
        ));
        let report = run_in(&scenario, place.path(), 1, &mut watcher());
        assert_eq!(report.end, RunEnd::Finished);
        let residual = &series(place.path())["energy residual"];
        [residual[2], residual[3]]
    };
    let [coarse, fine] = ["1/200", "1/400"].map(residual);
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(coarse.abs() < 2e-5, "{coarse}");
        assert!((3.0..5.0).contains(&(coarse / fine)), "{coarse}, {fine}");
    }
}

/// Grains that stick in dents: these tear where the law has it that acts, and the error of the books is that of the time step.
#[test]
fn dents_tear_where_the_other_law_of_a_stage_has_it() {
    let residual = |time_step: &str| {
        let place = tempfile::tempdir().unwrap();
        let scenario = parse(&format!(
            r#"simulation.time_step = "{time_step}"
simulation.max_overlap = 0.5
{HEAD}
[contact]
normal = {{ law = "eepa", alpha = 0, plasticity_ratio = 0.6, surface_energy = "4 J/m^2" }}
[[grains]]
material = "seed"
source = "list"
positions = [["0 m", "0 m", "0 m"]]
velocity = "0.3 0 0 m/s"
diameter = "2 mm"
[[grains]]
material = "seed"
source = "list"
positions = [["2 mm", "0 m", "0 m"], ["4.01 mm", "0 m", "0 m"]]
velocity = "-0.1 0 0 m/s"
diameter = "2 mm"
[[stage]]
duration = "4 ms"
[[stage]]
duration = "2 ms"
contact = {{ normal = {{ surface_energy = "2 J/m^2" }} }}
[[stage]]
duration = "2 ms"
contact = {{ normal = {{ plasticity_ratio = 0.4 }} }}
"#
        ));
        let report = run_in(&scenario, place.path(), 1, &mut watcher());
        assert_eq!(report.end, RunEnd::Finished);
        let residual = &series(place.path())["energy residual"];
        [residual[4], residual[5] - residual[4], residual[7] - residual[6]]
    };
    let [coarse, fine] = ["1/100", "1/200"].map(residual);
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        assert!(coarse.abs() < 5e-6, "{coarse}");
        assert!((3.0..5.0).contains(&(coarse / fine)), "{coarse}, {fine}");
    }
}

/// A grain that swings on a floor without ever leaving it.
#[test]
fn another_restitution_of_a_stage_damps_contacts_that_last() {
    let viscous = |law: &str, stage: &str| {
        let place = tempfile::tempdir().unwrap();
        let scenario = parse(&format!(
            r#"{HEAD}
[contact]
normal = {{ {law} }}
[[grains]]
material = "seed"
source = "list"
positions = [["0 m", "0 m", "0.998 mm"]]
diameter = "2 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 m"
normal = "z"
[[stage]]
duration = "2 ms"
[[stage]]
duration = "8 ms"
{stage}
"#
        ));
        let report = run_in(&scenario, place.path(), 1, &mut watcher());
        assert_eq!(report.end, RunEnd::Finished);
        last(&series(place.path()), "viscous dissipation [J]")
    };
    let solved = r#"restitution = 0.95, impact_speed = "10 mm/s""#;
    let table = |at_rest: f64| format!(r#"restitution = [["0.1 m/s", {at_rest}], ["1 m/s", 0.1]]"#);
    let constant = "restitution = 0.3".to_string();
    for (law, other) in [
        (format!(r#"law = "viscoelastic", {solved}"#), &constant),
        (
            format!(r#"law = "jkr", work_of_adhesion = "1e-5 J/m^2", {solved}"#),
            &constant,
        ),
        (
            format!(r#"law = "eepa", plasticity_ratio = 0.01, surface_energy = "0 J/m^2", {solved}"#),
            &constant,
        ),
        (format!(r#"law = "hertz-tsuji", {}"#, table(0.95)), &table(0.3)),
    ] {
        let other = format!("contact = {{ normal = {{ {other} }} }}");
        let [changed, same] = [other.as_str(), ""].map(|stage| viscous(&law, stage));
        assert!(
            changed > 1.5 * same,
            "{law}: {changed} J where it changes, {same} J where not"
        );
    }
}
