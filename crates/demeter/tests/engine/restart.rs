//! A state that was read can be written again at once, without a step in between.

use demeter::scenario::{Scenario, prepare, template};
use demeter::simulation::{Setup, Simulation, SimulationState};
use std::path::Path;

fn setup() -> Setup {
    let changes = [
        "grains[0].count=70",
        "grains[0].region.upper=\"20 20 20 mm\"",
        "grains[0].velocity=\"0.2 0 -0.5 m/s\"",
    ];
    let changes = changes.map(str::to_string);
    let scenario = Scenario::parse(template("settle").unwrap(), "settle", Path::new(""), &changes).unwrap();
    prepare(&scenario).unwrap().setup
}

/// The contacts of a state that was just read had no bodies; handing them over again panicked.
#[test]
fn a_state_survives_two_restarts_without_a_step() {
    let mut whole = Simulation::new(setup());
    for _ in 0..10_000 {
        whole.step().unwrap();
    }
    let state = whole.state();
    assert!(state.contact_count() > 10, "{} contacts", state.contact_count());
    let again = Simulation::resume(setup(), state.clone()).unwrap();
    let twice = again.state();
    assert_same(&twice, &state);
    let mut again = Simulation::resume(setup(), twice).unwrap();
    for _ in 0..500 {
        whole.step().unwrap();
        again.step().unwrap();
    }
    assert_same(&again.state(), &whole.state());
    let mut read = Simulation::resume(setup(), whole.state()).unwrap();
    assert_eq!(read.energies(), whole.energies());
}

/// Compares all bits, as every `f64` is written with all its digits; shows the first place that differs.
fn assert_same(a: &SimulationState, b: &SimulationState) {
    let (a, b) = (format!("{a:?}"), format!("{b:?}"));
    if let Some(at) = (0..a.len().min(b.len())).find(|&k| a.as_bytes()[k] != b.as_bytes()[k]) {
        let from = at.saturating_sub(150);
        panic!(
            "{}\n{}",
            &a[from..(at + 50).min(a.len())],
            &b[from..(at + 50).min(b.len())]
        );
    }
    assert_eq!(a.len(), b.len());
}
