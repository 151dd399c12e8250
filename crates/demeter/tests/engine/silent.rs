//! A scenario told as a text, and an observer that says nothing.

use demeter::scenario::{Observer, Progress, Scenario};
use std::path::Path;

pub struct Silent;

impl Observer for Silent {
    fn progress(&mut self, _: &Progress) -> bool {
        true
    }

    fn message(&mut self, _: &str) {}
}

/// Reads a scenario, whose files are in a folder.
pub fn parsed(text: &str, place: &Path) -> Scenario {
    match Scenario::parse(text, "case", place, &[]) {
        Ok(scenario) => scenario,
        Err(faults) => panic!("{}", faults.render(false)),
    }
}
