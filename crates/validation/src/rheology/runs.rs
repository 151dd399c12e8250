//! The run of the series.

use super::RheologyError;
use crate::folder::absolute;
use crate::runs::{Job, JobError, Tell};
use demeter::scenario::Scenario;
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
pub fn run_series(experiment: &Experiment, folder: &Path, tell: Tell<'_>) -> Result<Scenario, RheologyError> {
    let path = absolute(&experiment.scenario);
    let scenario = Scenario::read(&path, &experiment.set).map_err(|faults| JobError::Scenario(Box::new(faults)))?;
    let job = Job {
        name: "rheology".to_owned(),
        scenario,
        folder: folder.to_owned(),
        threads: experiment.threads,
        overwrite: experiment.overwrite,
    };
    job.carry_out(tell)?;
    Ok(job.scenario)
}
