//! What stages change of what acts on the grains.

use super::exchange::{last, parse, run_in, series, watcher};
use demeter::scenario::RunEnd;

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
