//! Runs of the cases.

use super::{Case, DostaError, Files, prepare};
use crate::folder::{State, absolute, state};
use demeter::scenario::{Observer, Progress, RunEnd, RunError, RunOptions, Scenario, resume, run};
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
        Scenario::parse(&text, &name, &base, &set).map_err(|faults| DostaError::Scenario(Box::new(faults)))
    }
}

/// Runs a case in a folder; a finished run of the same scenario is used again, an interrupted one goes on. Answers with the folder
/// of the run.
pub fn run_case(
    experiment: &Experiment,
    case: &Case,
    out: &Path,
    tell: &(dyn Fn(&str) + Sync),
) -> Result<PathBuf, DostaError> {
    let files = prepare(case, &experiment.data, &out.join("input"))?;
    let scenario = experiment.scenario_of(case, &files)?;
    let folder = out.join("run");
    let options = RunOptions {
        threads: experiment.threads,
        overwrite: experiment.overwrite,
        ..RunOptions::default()
    };
    let mut watcher = Watcher { case, tell, told: 0.0 };
    let shown = folder.display();
    let report = match state(&folder, &scenario) {
        State::Finished => {
            tell(&format!("{}: taken from {shown}", case.name));
            return Ok(folder);
        }
        State::Begun => {
            tell(&format!("{}: goes on in {shown}", case.name));
            resume(&folder, options, &mut watcher)
        }
        State::Other if !experiment.overwrite => return Err(DostaError::OtherRun { folder }),
        State::Other | State::Free => {
            tell(&format!("{}: runs in {shown}", case.name));
            run(&scenario, &folder, options, &mut watcher)
        }
    };
    let report = report.map_err(|error| match error {
        RunError::Scenario(faults) => DostaError::Scenario(faults),
        source => DostaError::Run {
            case: case.name,
            source: Box::new(source),
        },
    })?;
    let reason = match report.end {
        RunEnd::Finished => return Ok(folder),
        RunEnd::Interrupted => "it was interrupted".to_string(),
        RunEnd::Fault(fault) => fault.to_string(),
    };
    Err(DostaError::Unfinished {
        case: case.name,
        folder,
        reason,
    })
}

/// Seconds between two reports of progress.
const REPORT_EVERY: f64 = 60.0;

/// Passes on what a run tells.
struct Watcher<'a> {
    case: &'a Case,
    tell: &'a (dyn Fn(&str) + Sync),
    told: f64,
}

impl Observer for Watcher<'_> {
    fn progress(&mut self, progress: &Progress) -> bool {
        if progress.elapsed - self.told >= REPORT_EVERY {
            self.told = progress.elapsed;
            let Progress {
                stage, time, grains, ..
            } = progress;
            let rate = progress.steps_here as f64 / progress.elapsed;
            let line = format!("stage {stage}, {time:.5} s, {grains} grains, {rate:.0} steps/s");
            (self.tell)(&format!("{}: {line}", self.case.name));
        }
        true
    }

    fn message(&mut self, text: &str) {
        (self.tell)(&format!("{}: {text}", self.case.name));
    }
}
