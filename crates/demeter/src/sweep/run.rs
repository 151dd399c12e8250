//! One run of a sweep: begun, or gone on with where an earlier process left it.

use super::error::SweepError;
use super::folder::{End, Outcome, Status, SweepFolder, has_checkpoint};
use crate::output::{OutputError, RunFolder};
use crate::scenario::{Observer, RunEnd, RunError, RunOptions, Scenario, resume, run};
use std::fs;
use std::path::Path;
use std::time::{Duration, Instant};

/// How long a process waits for one that is ending in the same folder, such as one whose parent was killed.
const PATIENCE: Duration = Duration::from_secs(60);
/// Time between two looks.
const LOOK: Duration = Duration::from_millis(100);

/// What came of an attempt to carry out a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Carried {
    /// It ended, now or earlier.
    Ended(Outcome),
    /// It was asked to end; a checkpoint holds its state.
    Interrupted,
}

/// Carries out a run. One that is finished is left as it is, and one that failed, too, unless it is to be tried again. How it
/// ends is noted in its folder.
pub fn carry_out(
    folder: &SweepFolder,
    index: usize,
    retry: bool,
    options: RunOptions,
    observer: &mut dyn Observer,
) -> Result<Carried, SweepError> {
    folder.check_index(index)?;
    if let Status::Ended(outcome) = folder.status(index)
        && (outcome.end == End::Finished || !retry)
    {
        return Ok(Carried::Ended(outcome));
    }
    let outcome = match attempt(folder, index, options, observer) {
        Ok(RunEnd::Interrupted) => return Ok(Carried::Interrupted),
        Ok(RunEnd::Finished) => Outcome {
            end: End::Finished,
            message: "all stages are done".to_string(),
        },
        Ok(RunEnd::Fault(fault)) => Outcome {
            end: End::Fault,
            message: fault.to_string(),
        },
        // another process goes on with it, and will tell how it ends
        Err(error @ SweepError::Run(RunError::Output(OutputError::InUse { .. }))) => return Err(error),
        Err(error) => Outcome {
            end: End::Error,
            message: error.to_string(),
        },
    };
    folder.record(index, &outcome)?;
    Ok(Carried::Ended(outcome))
}

fn attempt(
    folder: &SweepFolder,
    index: usize,
    options: RunOptions,
    observer: &mut dyn Observer,
) -> Result<RunEnd, SweepError> {
    folder.check_files()?;
    let scenario = folder.plan.scenario(index).map_err(RunError::from)?;
    let root = folder.run_folder(index);
    wait_for_others(&root);
    folder.forget(index)?;
    let found = RunFolder::find(&root).ok().filter(|_| has_checkpoint(&root));
    let Some(found) = found else {
        let options = RunOptions {
            overwrite: true,
            ..options
        };
        return Ok(run(&scenario, &root, options, observer)?.end);
    };
    if !is_of(&found, &scenario) {
        return Err(SweepError::OtherRun { folder: root });
    }
    match resume(&root, options, observer) {
        Err(RunError::Finished { .. }) => Ok(RunEnd::Finished),
        report => Ok(report?.end),
    }
}

/// Whether a folder holds a run of the scenario.
fn is_of(found: &RunFolder, scenario: &Scenario) -> bool {
    fs::read_to_string(found.scenario()).is_ok_and(|text| text == scenario.to_resolved_toml())
}

fn wait_for_others(root: &Path) {
    let began = Instant::now();
    while RunFolder::find(root).is_ok_and(|found| found.is_locked()) && began.elapsed() < PATIENCE {
        std::thread::sleep(LOOK);
    }
}
