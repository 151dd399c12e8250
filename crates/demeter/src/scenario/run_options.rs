//! How a run is carried out.

use super::Scenario;
use super::named_files::named_files;
use crate::output::{OutputError, RunFolder, RunLock};
use crate::simulation::Simulation;
use demeter_physics::lanes::{Instructions, NoSuchInstructions};
use std::path::Path;

/// Most threads that a run may ask for.
pub const MOST_THREADS: u16 = 4096;

/// How a run is carried out; nothing but `changed` changes the results.
#[derive(Clone, Copy, Debug, Default)]
pub struct RunOptions {
    /// Number of threads, at least 1; all cores when absent.
    pub threads: Option<usize>,
    /// Whether an earlier run in the folder may be replaced.
    pub overwrite: bool,
    /// Whether a folder that is taken is left to others: the next free one of `FOLDER-2`, `FOLDER-3`, ... is then used.
    pub numbered: bool,
    /// Instructions of the processor ([`Instructions::named`]); the widest when absent.
    pub instructions: Option<Instructions>,
    /// Whether the summary tells where the time went.
    pub profile: bool,
    /// Whether a run goes on although its scenario is another one than that it began with.
    pub changed: bool,
}

impl RunOptions {
    /// Refuses instructions that this processor lacks.
    pub(super) fn check(&self) -> Result<(), NoSuchInstructions> {
        self.instructions
            .map_or(Ok(()), |asked| Instructions::named(asked.name()).map(|_| ()))
    }

    /// Makes the folder of a new run and reserves it.
    pub(super) fn reserve(&self, folder: &Path, scenario: &Scenario) -> Result<(RunFolder, RunLock), OutputError> {
        let named = |folder: &RunFolder, was_a_run| named_files(scenario, folder, was_a_run);
        match self.numbered {
            true => RunFolder::reserve_numbered(folder, named),
            false => RunFolder::reserve(folder, self.overwrite, named),
        }
    }

    /// Tells a simulation how to run.
    pub(super) fn apply(&self, sim: &mut Simulation) {
        if let Some(instructions) = self.instructions {
            sim.set_instructions(instructions);
        }
        if self.profile {
            sim.profile_from_now();
        }
    }
}
