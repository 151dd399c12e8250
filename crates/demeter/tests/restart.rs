//! A state that was read can be written again at once, without a step in between.
#![allow(clippy::unwrap_used, reason = "helpers of tests may fail as tests do")]

use demeter::scenario::{Scenario, prepare, template};
use demeter::simulation::{Setup, Simulation};
use std::path::Path;

fn setup() -> Setup {
    let changes = ["grains[0].count=60", "grains[0].region.upper=\"15 15 15 mm\""];
    let changes = changes.map(str::to_string);
    let scenario = Scenario::parse(template("settle").unwrap(), "settle", Path::new(""), &changes).unwrap();
    prepare(&scenario).unwrap().setup
}

/// The contacts of a state that was just read had no bodies; handing them over again panicked.
#[test]
fn a_state_survives_two_restarts_without_a_step() {
    let mut whole = Simulation::new(setup());
    for _ in 0..12_000 {
        whole.step().unwrap();
    }
    let state = whole.state();
    assert!(state.contact_count() > 10, "{} contacts", state.contact_count());
    let mut again = Simulation::resume(setup(), state.clone()).unwrap();
    let twice = again.state();
    assert_eq!(format!("{twice:?}"), format!("{state:?}"));
    assert_eq!(again.energies(), whole.energies());
    let mut again = Simulation::resume(setup(), twice).unwrap();
    for _ in 0..500 {
        whole.step().unwrap();
        again.step().unwrap();
    }
    assert_eq!(format!("{:?}", again.state()), format!("{:?}", whole.state()));
}
