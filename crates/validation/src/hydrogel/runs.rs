//! Runs of the scenario, one per model, some at a time.

use super::{Model, ValidationError};
use crate::folder::{State, absolute, state};
use demeter::scenario::{Observer, Progress, RunEnd, RunError, RunOptions, Scenario, resume, run};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Says what happens, from any thread.
pub type Tell<'a> = &'a (dyn Fn(&str) + Sync);

/// What is run.
#[derive(Clone, Debug)]
pub struct Experiment {
    /// The scenario.
    pub scenario: PathBuf,
    /// Changes of it, as `demeter run --set`.
    pub set: Vec<String>,
    /// File of grains; those of the scenario when absent.
    pub packing: Option<PathBuf>,
    /// Number of cycles.
    pub cycles: usize,
    /// Prefactor of the fitted model.
    pub prefactor: f64,
    /// Whether other runs in the folders may be replaced.
    pub overwrite: bool,
}

impl Experiment {
    /// The scenario with a model.
    pub fn scenario_of(&self, model: &Model) -> Result<Scenario, ValidationError> {
        let mut set = vec![
            format!("stage[2].repeat={}", self.cycles),
            format!("contact.multi_contact={}", model.law(self.prefactor)),
        ];
        if let Some(packing) = &self.packing {
            let file = absolute(packing).display().to_string();
            let quoted = file.replace('\\', "\\\\").replace('"', "\\\"");
            set.push(format!(
                "grains=[{{ material = \"hydrogel\", source = \"file\", file = \"{quoted}\" }}]"
            ));
        }
        set.extend(self.set.iter().cloned());
        let mut scenario =
            Scenario::read(&self.scenario, &set).map_err(|faults| ValidationError::Scenario(Box::new(faults)))?;
        // the scenario in the run folder must find its files from anywhere
        scenario.base = absolute(&scenario.base);
        Ok(scenario)
    }
}

/// Runs the experiment with every model, `jobs` at a time with one thread each. A finished run of the same scenario is used
/// again, an interrupted one goes on. Answers with the folders of the runs, in the order of the models.
pub fn run_models(
    experiment: &Experiment,
    models: &[Model],
    out: &Path,
    jobs: usize,
    tell: Tell<'_>,
) -> Result<Vec<PathBuf>, ValidationError> {
    let next = AtomicUsize::new(0);
    let results: Vec<Mutex<Option<Result<PathBuf, ValidationError>>>> =
        models.iter().map(|_| Mutex::new(None)).collect();
    thread::scope(|scope| {
        for _ in 0..jobs.clamp(1, models.len().max(1)) {
            scope.spawn(|| {
                while let Some((model, result)) = {
                    let k = next.fetch_add(1, Ordering::Relaxed);
                    models.get(k).zip(results.get(k))
                } {
                    let folder = out.join(model.folder(experiment.prefactor));
                    let done = run_model(experiment, model, &folder, tell).map(|()| folder);
                    if let Ok(mut slot) = result.lock() {
                        *slot = Some(done);
                    }
                }
            });
        }
    });
    let folder = |(model, slot): (&Model, Mutex<Option<_>>)| {
        slot.into_inner().ok().flatten().unwrap_or_else(|| {
            Err(ValidationError::Unfinished {
                model: model.name,
                folder: out.join(model.folder(experiment.prefactor)),
                reason: "its thread ended early".to_string(),
            })
        })
    };
    models.iter().zip(results).map(folder).collect()
}

fn run_model(experiment: &Experiment, model: &Model, folder: &Path, tell: Tell<'_>) -> Result<(), ValidationError> {
    let scenario = experiment.scenario_of(model)?;
    let state = state(folder, &scenario);
    let shown = folder.display();
    let options = RunOptions {
        threads: Some(1),
        overwrite: experiment.overwrite,
        ..RunOptions::default()
    };
    let mut watcher = Watcher { model, tell };
    let report = match state {
        State::Finished => {
            tell(&format!("{}: taken from {shown}", model.name));
            return Ok(());
        }
        State::Begun => {
            tell(&format!("{}: goes on in {shown}", model.name));
            resume(folder, options, &mut watcher)
        }
        State::Other if !experiment.overwrite => {
            return Err(ValidationError::OtherRun {
                folder: folder.to_owned(),
            });
        }
        State::Other | State::Free => {
            tell(&format!("{}: runs in {shown}", model.name));
            run(&scenario, folder, options, &mut watcher)
        }
    };
    let report = report.map_err(|error| match error {
        RunError::Scenario(faults) => ValidationError::Scenario(faults),
        source => ValidationError::Run {
            model: model.name,
            source: Box::new(source),
        },
    })?;
    let reason = match report.end {
        RunEnd::Finished => return Ok(()),
        RunEnd::Interrupted => "it was interrupted".to_string(),
        RunEnd::Fault(fault) => fault.to_string(),
    };
    Err(ValidationError::Unfinished {
        model: model.name,
        folder: folder.to_owned(),
        reason,
    })
}

/// Passes on what a run tells.
struct Watcher<'a> {
    model: &'a Model,
    tell: Tell<'a>,
}

impl Observer for Watcher<'_> {
    fn progress(&mut self, _progress: &Progress) -> bool {
        true
    }

    fn message(&mut self, text: &str) {
        (self.tell)(&format!("{}: {text}", self.model.name));
    }
}
