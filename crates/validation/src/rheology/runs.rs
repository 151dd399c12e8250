//! The run of the series.

use super::RheologyError;
use crate::folder::{State, absolute, state};
use demeter::scenario::{Observer, Progress, RunEnd, RunError, RunOptions, Scenario, resume, run};
use std::path::{Path, PathBuf};

/// What is run.
#[derive(Clone, Debug)]
pub struct Experiment {
    /// The scenario.
    pub scenario: PathBuf,
    /// Changes of it, as `demeter run --set`.
    pub set: Vec<String>,
    /// Number of threads; all cores when absent.
    pub threads: Option<usize>,
    /// Whether another run in the folder may be replaced.
    pub overwrite: bool,
}

/// Runs the series in a folder; a finished run of the same scenario is used again, an interrupted one goes on.
pub fn run_series(
    experiment: &Experiment,
    folder: &Path,
    tell: &(dyn Fn(&str) + Sync),
) -> Result<Scenario, RheologyError> {
    let wrong = |faults| RheologyError::Scenario(Box::new(faults));
    let path = absolute(&experiment.scenario);
    let scenario = Scenario::read(&path, &experiment.set).map_err(wrong)?;
    let options = RunOptions {
        threads: experiment.threads,
        overwrite: experiment.overwrite,
        ..RunOptions::default()
    };
    let mut watcher = Watcher { tell, told: 0.0 };
    let report = match state(folder, &scenario) {
        State::Finished => return Ok(scenario),
        State::Begun => resume(folder, options, &mut watcher),
        State::Other if !experiment.overwrite => {
            return Err(RheologyError::OtherRun {
                folder: folder.to_owned(),
            });
        }
        State::Other | State::Free => run(&scenario, folder, options, &mut watcher),
    };
    let report = report.map_err(|error| match error {
        RunError::Scenario(faults) => RheologyError::Scenario(faults),
        other => RheologyError::Run(Box::new(other)),
    })?;
    let reason = match report.end {
        RunEnd::Finished => return Ok(scenario),
        RunEnd::Interrupted => "it was interrupted".to_string(),
        RunEnd::Fault(fault) => fault.to_string(),
    };
    Err(RheologyError::Unfinished {
        folder: folder.to_owned(),
        reason,
    })
}

/// Seconds between two reports of progress.
const REPORT_EVERY: f64 = 60.0;

/// Passes on what a run tells.
struct Watcher<'a> {
    tell: &'a (dyn Fn(&str) + Sync),
    told: f64,
}

impl Observer for Watcher<'_> {
    fn progress(&mut self, progress: &Progress) -> bool {
        if progress.elapsed - self.told >= REPORT_EVERY {
            self.told = progress.elapsed;
            let rate = progress.steps_here as f64 / progress.elapsed;
            (self.tell)(&format!(
                "{}, {:.4} s, {rate:.0} steps/s",
                progress.stage, progress.time
            ));
        }
        true
    }

    fn message(&mut self, text: &str) {
        (self.tell)(text);
    }
}
