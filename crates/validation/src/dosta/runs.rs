//! Runs of the cases.

use super::{Case, DostaError, Files, prepare};
use crate::folder::absolute;
use crate::runs::{Job, JobError, Tell};
use demeter::scenario::Scenario;
use std::fs;
use std::path::{Path, PathBuf};

/// What is run.
#[derive(Clone, Debug)]
pub struct Experiment {
    /// Folder of the published files.
    pub data: PathBuf,
    /// Folder of the scenarios.
    pub scenarios: PathBuf,
    /// Simulated time of the case [s]; the published one when absent. A silo counts from when it is opened.
    pub until: Option<f64>,
    /// Changes of the scenario, as `demeter run --set`.
    pub set: Vec<String>,
    /// Number of threads; all cores when absent.
    pub threads: Option<usize>,
    /// Whether another run in the folder may be replaced.
    pub overwrite: bool,
}

impl Experiment {
    /// The scenario of a case, beside files that [`prepare`] wrote.
    pub fn scenario_of(&self, case: &Case, files: &Files) -> Result<Scenario, DostaError> {
        let path = self.scenarios.join(case.scenario);
        let text = fs::read_to_string(&path).map_err(DostaError::io("read", &path))?;
        let mut set: Vec<String> = case.set.iter().map(ToString::to_string).collect();
        if let Some(until) = self.until {
            set.push(format!("stage[{}].duration=\"{until} s\"", case.last_stage));
        }
        set.extend(self.set.iter().cloned());
        let name = path.display().to_string();
        let base = absolute(&files.folder);
        Scenario::parse(&text, &name, &base, &set).map_err(|faults| JobError::Scenario(Box::new(faults)).into())
    }
}

/// Runs a case in a folder; a finished run of the same scenario is used again, an interrupted one goes on. Answers with the folder
/// of the run.
pub fn run_case(experiment: &Experiment, case: &Case, out: &Path, tell: Tell<'_>) -> Result<PathBuf, DostaError> {
    let files = prepare(case, &experiment.data, &out.join("input"))?;
    let scenario = experiment.scenario_of(case, &files)?;
    let job = Job {
        name: case.name.to_owned(),
        scenario,
        folder: out.join("run"),
        threads: experiment.threads,
        overwrite: experiment.overwrite,
    };
    job.carry_out(tell)?;
    Ok(job.folder)
}
