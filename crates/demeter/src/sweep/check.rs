//! Reads and prepares the scenarios of all runs before the first one starts.

use super::error::SweepError;
use super::plan::{Estimate, Plan};
use crate::scenario::{Diagnostic, Diagnostics, InputFile, prepare, thread_pool};
use rayon::prelude::*;
use std::collections::HashMap;

/// Runs that are prepared before what is wrong with them is put together.
const AT_ONCE: usize = 32;
/// Most different faults that are kept.
const MOST_FAULTS: usize = 100;

/// What the scenarios of all runs tell.
#[derive(Clone, Debug, Default)]
pub struct Checked {
    /// What each run will need.
    pub estimates: Vec<Estimate>,
    /// What the user should know, each with the runs that it is about.
    pub warnings: Vec<(String, Vec<usize>)>,
    /// Files that the scenarios name, each once.
    pub files: Vec<InputFile>,
}

/// A fault, and the runs that have it.
#[derive(Clone, Debug)]
pub struct SweepFault {
    /// What is wrong, as in the first of the runs.
    pub diagnostic: Diagnostic,
    /// The fault drawn with the line that it is in.
    pub drawn: String,
    /// The runs.
    pub runs: Vec<usize>,
}

/// Everything that is wrong with the scenarios of a sweep.
#[derive(Clone, Debug, Default)]
pub struct SweepFaults {
    /// Different faults, in the order in which the runs have them.
    pub faults: Vec<SweepFault>,
    /// How many more there are.
    pub left_out: usize,
    known: HashMap<String, usize>,
}

impl SweepFaults {
    fn add(&mut self, run: usize, found: &Diagnostics, colour: bool) {
        for diagnostic in found.list() {
            let Diagnostic {
                message,
                help,
                path,
                source,
                line,
                column,
                ..
            } = diagnostic;
            let what = format!("{message}\n{help:?}\n{path}\n{source}\n{line}\n{column}");
            if let Some(&at) = self.known.get(&what) {
                self.faults[at].runs.push(run);
            } else if self.faults.len() >= MOST_FAULTS {
                self.left_out += 1;
            } else {
                self.known.insert(what, self.faults.len());
                self.faults.push(SweepFault {
                    diagnostic: diagnostic.clone(),
                    drawn: found.render_one(diagnostic, colour),
                    runs: vec![run],
                });
            }
        }
    }
}

/// Reads and prepares all runs, or tells everything that is wrong with any of them. Faults are drawn with or without colours.
pub fn check(plan: &Plan, threads: usize, colour: bool) -> Result<Result<Checked, SweepFaults>, SweepError> {
    let pool = thread_pool(Some(threads))?;
    let mut checked = Checked::default();
    let mut faults = SweepFaults::default();
    let mut warned: HashMap<String, usize> = HashMap::new();
    let indices: Vec<usize> = (0..plan.runs.len()).collect();
    for chunk in indices.chunks(AT_ONCE) {
        let found: Vec<_> = pool.install(|| chunk.par_iter().map(|&run| check_one(plan, run)).collect());
        for (&run, found) in chunk.iter().zip(found) {
            match found {
                Ok((estimate, warnings, files)) => {
                    checked.estimates.push(estimate);
                    for file in files {
                        if !checked.files.iter().any(|known| known.path == file.path) {
                            checked.files.push(file);
                        }
                    }
                    for warning in warnings {
                        let at = *warned.entry(warning.clone()).or_insert(checked.warnings.len());
                        match checked.warnings.get_mut(at) {
                            Some((_, runs)) => runs.push(run),
                            None => checked.warnings.push((warning, vec![run])),
                        }
                    }
                }
                Err(found) => faults.add(run, &found, colour),
            }
        }
    }
    Ok(if faults.faults.is_empty() {
        Ok(checked)
    } else {
        Err(faults)
    })
}

fn check_one(plan: &Plan, run: usize) -> Result<(Estimate, Vec<String>, Vec<InputFile>), Box<Diagnostics>> {
    let scenario = plan.scenario(run)?;
    let prepared = prepare(&scenario)?;
    let estimate = Estimate {
        grains: prepared.setup.grains.len() as u64,
        steps: prepared.steps,
        memory: prepared.memory,
        run_time: prepared.run_time,
        simulated: prepared.steps as f64 * prepared.setup.dt,
    };
    Ok((estimate, prepared.warnings, scenario.input_files()))
}
