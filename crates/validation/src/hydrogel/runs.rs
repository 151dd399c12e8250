//! Runs of the scenario, one per model, some at a time.

use super::{Model, ValidationError};
use crate::folder::absolute;
use crate::runs::{Job, JobError, Tell, carry_out_all};
use demeter::scenario::Scenario;
use std::path::{Path, PathBuf};

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
            Scenario::read(&self.scenario, &set).map_err(|faults| JobError::Scenario(Box::new(faults)))?;
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
    let job = |model: &Model| {
        Ok(Job {
            name: model.name.to_owned(),
            scenario: experiment.scenario_of(model)?,
            folder: out.join(model.folder(experiment.prefactor)),
            threads: Some(1),
            overwrite: experiment.overwrite,
        })
    };
    let all: Vec<Job> = models.iter().map(job).collect::<Result<_, ValidationError>>()?;
    carry_out_all(&all, jobs, tell)?;
    Ok(all.into_iter().map(|job| job.folder).collect())
}
