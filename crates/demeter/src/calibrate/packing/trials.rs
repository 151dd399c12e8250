//! Runs of a scenario with trial values, kept in folders that are named after the value.

use super::PackingError;
use crate::checkpoint;
use crate::compare::{Comparison, Thresholds, compare, read_run};
use crate::contacts::Fault;
use crate::output::RunFolder;
use crate::scenario::{Observer, PackingFile, RunEnd, RunError, RunOptions, Scenario, resume, run};
use std::fs;
use std::path::{Path, PathBuf};

/// Most folders of trials of one value.
const MOST_FOLDERS: u32 = 1000;

/// A run with a value of the unknown.
#[derive(Clone, Debug)]
pub struct Trial {
    /// The value, in SI.
    pub value: f64,
    /// Its folder.
    pub folder: PathBuf,
    /// Whether a run that was there was used.
    pub reused: bool,
    /// What came of it.
    pub outcome: Outcome,
}

/// What came of a trial.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It ran to its end.
    Compared(Box<Comparison>),
    /// The contacts have no solution any more.
    BeyondFold(String),
}

impl Trial {
    /// Beside the experiment, when it ran to its end.
    pub fn comparison(&self) -> Option<&Comparison> {
        match &self.outcome {
            Outcome::Compared(comparison) => Some(comparison),
            Outcome::BeyondFold(_) => None,
        }
    }
}

/// Makes trials.
pub(super) struct Laboratory<'a> {
    pub file: &'a PackingFile,
    pub out: &'a Path,
    pub threads: Option<usize>,
    pub observer: &'a mut dyn Observer,
    pub trials: Vec<Trial>,
}

/// How a run of a value can be had.
enum Place {
    /// It is there, finished.
    Finished(PathBuf),
    /// It was interrupted.
    Begun(PathBuf),
    /// Not yet.
    Free(PathBuf),
}

impl Laboratory<'_> {
    /// The trial of a value; one that was made before is not made again.
    pub fn trial(&mut self, value: f64) -> Result<&Trial, PackingError> {
        let known = self.trials.iter().position(|trial| trial.value == value);
        let index = match known {
            Some(index) => index,
            None => {
                let trial = self.make(value)?;
                self.trials.push(trial);
                self.trials.len() - 1
            }
        };
        Ok(&self.trials[index])
    }

    fn make(&mut self, value: f64) -> Result<Trial, PackingError> {
        let unknown = &self.file.unknown;
        let what = format!("{} = {}", unknown.key, unknown.plain(value));
        let mut scenario = self.file.scenario_at(value).map_err(RunError::from)?;
        // the scenario in the run folder must find its files from anywhere
        scenario.base = std::path::absolute(&scenario.base).unwrap_or(scenario.base);
        let place = place(self.out, &unknown.plain(value), &scenario)?;
        let number = self.trials.len() + 1;
        let (folder, reused, end) = match place {
            Place::Finished(folder) => {
                self.observer
                    .message(&format!("trial {number}: {what}, from {}", folder.display()));
                (folder, true, RunEnd::Finished)
            }
            Place::Begun(folder) => {
                self.observer
                    .message(&format!("trial {number}: {what}, going on in {}", folder.display()));
                let report = resume(&folder, self.options(), self.observer)?;
                (folder, true, report.end)
            }
            Place::Free(folder) => {
                self.observer
                    .message(&format!("trial {number}: {what}, in {}", folder.display()));
                let report = run(&scenario, &folder, self.options(), self.observer)?;
                (folder, false, report.end)
            }
        };
        let outcome = match end {
            RunEnd::Finished => {
                let strokes = read_run(&folder, &self.file.reading, Some(self.file.measured.position))?;
                Outcome::Compared(Box::new(compare(&strokes, &self.file.measured, Thresholds::default())))
            }
            RunEnd::Fault(fault @ Fault::BeyondFold { .. }) => Outcome::BeyondFold(fault.to_string()),
            RunEnd::Fault(fault) => {
                let fault = Box::new(fault);
                return Err(PackingError::Fault { what, folder, fault });
            }
            RunEnd::Interrupted => return Err(PackingError::Interrupted { what, folder }),
        };
        Ok(Trial {
            value,
            folder,
            reused,
            outcome,
        })
    }

    fn options(&self) -> RunOptions {
        RunOptions {
            threads: self.threads,
            ..RunOptions::default()
        }
    }
}

/// The folder of a value: the first one whose run is of the same scenario, or that is free.
fn place(out: &Path, value: &str, scenario: &Scenario) -> Result<Place, PackingError> {
    if RunFolder::find(out).is_ok() || out.is_file() {
        return Err(PackingError::NoPlace { folder: out.to_owned() });
    }
    let expected = scenario.to_resolved_toml();
    let stem = value.replace(['/', ' '], "_");
    for number in 1..=MOST_FOLDERS {
        let folder = match number {
            1 => out.join(&stem),
            _ => out.join(format!("{stem}-{number}")),
        };
        if is_free(&folder) {
            return Ok(Place::Free(folder));
        }
        let same = RunFolder::find(&folder).is_ok_and(|found| {
            fs::read_to_string(found.scenario()).is_ok_and(|text| text == expected) && is_of_this_version(&folder)
        });
        if !same {
            continue;
        }
        if is_finished(&folder) {
            return Ok(Place::Finished(folder));
        }
        if folder.join(checkpoint::LATEST).is_file() {
            return Ok(Place::Begun(folder));
        }
    }
    Err(PackingError::NoPlace { folder: out.to_owned() })
}

fn is_free(folder: &Path) -> bool {
    match fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) => error.kind() == std::io::ErrorKind::NotFound,
    }
}

/// A value of a file of JSON in a run folder.
fn told(path: &Path, key: &str) -> Option<serde_json::Value> {
    let text = fs::read_to_string(path).ok()?;
    let value: serde_json::Value = serde_json::from_str(&text).ok()?;
    value.get(key).cloned()
}

fn is_of_this_version(folder: &Path) -> bool {
    told(&folder.join("run.json"), "version").is_some_and(|version| version == crate::VERSION)
}

fn is_finished(folder: &Path) -> bool {
    told(&folder.join("summary.json"), "finished").is_some_and(|finished| finished == true)
}
