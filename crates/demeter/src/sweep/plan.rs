//! The plan of a sweep: the scenario, what is varied, and the values of every run.

use super::design::{Varied, combinations};
use super::error::SweepError;
use super::names::{is_name, names, short_keys};
use super::value::unquoted;
use crate::scenario::{Diagnostics, InputFile, Override, Scenario, key_steps, line_differences, resolve, shortened};
use serde::{Deserialize, Serialize};
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

/// Most runs of a sweep.
pub const MAX_RUNS: usize = 10_000;

/// A key that is varied.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Column {
    /// The key.
    pub key: String,
    /// The option that told its values.
    pub told_by: String,
    /// Whether its values have equal ratios.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub logarithmic: bool,
}

/// What a run will need.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Grains at the start.
    pub grains: u64,
    /// Steps when no condition ends a stage early.
    pub steps: u64,
    /// Memory [bytes].
    pub memory: u64,
    /// Time on one thread [s].
    pub run_time: f64,
    /// Simulated time when no condition ends a stage early [s]; 0 where it was not noted.
    #[serde(default)]
    pub simulated: f64,
}

/// A run of a sweep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct PlannedRun {
    /// Its name, which is that of its folder.
    pub name: String,
    /// Values of the keys, as written.
    pub values: Vec<String>,
    /// What it will need.
    pub estimate: Estimate,
}

/// What is told and drawn of a sweep beside what always is.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Wishes {
    /// Results of each run, as `mean:coordination@settle`.
    #[serde(default)]
    pub results: Vec<String>,
    /// Results that are drawn.
    #[serde(default)]
    pub plots: Vec<String>,
    /// The key against which they are drawn; the first one with numbers when absent.
    #[serde(default)]
    pub against: Option<String>,
}

/// A sweep: everything that its runs follow from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plan {
    /// Version of Demeter.
    pub version: String,
    /// The scenario file, as it was named.
    pub scenario: String,
    /// Folder from which paths in varied values start.
    pub base: PathBuf,
    /// The scenario without what is varied, as TOML.
    pub text: String,
    /// What is varied.
    pub columns: Vec<Column>,
    /// All runs.
    pub runs: Vec<PlannedRun>,
    /// Files that the scenarios name, as they were when these were checked.
    #[serde(default)]
    pub files: Vec<InputFile>,
}

impl Plan {
    /// Plans all combinations. The scenarios are not checked yet.
    pub fn make(file: &Path, varied: &Varied) -> Result<Self, SweepError> {
        let base = match file.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let base = std::path::absolute(base).map_err(SweepError::io("find", base))?;
        let text = resolve(file, &base, &varied.set).map_err(|faults| SweepError::Scenario(Box::new(faults)))?;
        let axes = varied.axes(&text)?;
        let runs = combinations(&axes);
        let column = |axis: &super::Axis, key: &String| Column {
            key: key.clone(),
            told_by: axis.told_by.clone(),
            logarithmic: axis.logarithmic,
        };
        let columns: Vec<Column> = axes
            .iter()
            .flat_map(|axis| axis.keys.iter().map(move |key| column(axis, key)))
            .collect();
        let keys: Vec<String> = columns.iter().map(|column| column.key.clone()).collect();
        let values: Vec<&[String]> = runs.iter().map(Vec::as_slice).collect();
        let names = names(&keys, &values);
        let planned = names.into_iter().zip(&runs).map(|(name, values)| PlannedRun {
            name,
            values: values.clone(),
            estimate: Estimate::default(),
        });
        Ok(Self {
            version: crate::VERSION.to_string(),
            scenario: file.display().to_string(),
            base,
            text,
            runs: planned.collect(),
            columns,
            files: Vec::new(),
        })
    }

    /// The scenario of a run, read and checked.
    pub fn scenario(&self, index: usize) -> Result<Scenario, Diagnostics> {
        let values = self.columns.iter().zip(&self.runs[index].values);
        let overrides: Vec<Override> = values
            .map(|(column, value)| Override {
                text: format!("{}={value}", column.key),
                source: column.told_by.clone(),
            })
            .collect();
        let mut scenario = Scenario::parse_with(&self.text, &self.scenario, &self.base, &overrides)?;
        scenario.title = format!("{}: {}", scenario.title, self.describe(index));
        Ok(scenario)
    }

    /// Short names of the keys.
    pub fn short_keys(&self) -> Vec<String> {
        let keys: Vec<String> = self.columns.iter().map(|column| column.key.clone()).collect();
        short_keys(&keys)
    }

    /// The values of a run in words: `restitution = 0.5, count = 1000`.
    pub fn describe(&self, index: usize) -> String {
        let values = self.runs[index].values.iter().map(|value| unquoted(value));
        let told: Vec<String> = (self.short_keys().iter().zip(values))
            .map(|(key, value)| format!("{key} = {value}"))
            .collect();
        told.join(", ")
    }

    /// Index of a key, told whole or by its short name.
    pub fn column(&self, name: &str) -> Option<usize> {
        let whole = self.columns.iter().position(|column| column.key == name);
        whole.or_else(|| self.short_keys().iter().position(|short| short == name))
    }

    /// What has changed in the files that the scenarios name, since these were checked.
    pub fn changed_files(&self) -> Vec<String> {
        self.files.iter().filter_map(InputFile::change).collect()
    }

    /// What another plan would have otherwise; nothing when both are of the same runs.
    pub fn differences(&self, new: &Self) -> Vec<String> {
        let mut told = Vec::new();
        if self.version != new.version {
            told.push(format!(
                "it was begun by Demeter {}, this is {}: results of both do not belong together",
                self.version, new.version
            ));
        }
        told.extend(line_differences(&self.text, &new.text));
        let keys = |plan: &Self| -> Vec<String> { plan.columns.iter().map(|c| c.key.clone()).collect() };
        if keys(self) == keys(new) {
            told.extend(self.value_differences(new));
        } else {
            told.push(format!(
                "it varies `{}`, now `{}` is told",
                keys(self).join("`, `"),
                keys(new).join("`, `")
            ));
        }
        told
    }

    /// Whether another plan has all of these runs, with the same values and under the same names, and differs in nothing but having more.
    pub fn is_part_of(&self, larger: &Self) -> bool {
        let of_larger: HashMap<&str, &[String]> = (larger.runs.iter())
            .map(|run| (run.name.as_str(), run.values.as_slice()))
            .collect();
        let keys = |plan: &Self| -> Vec<String> { plan.columns.iter().map(|c| c.key.clone()).collect() };
        self.version == larger.version
            && self.text == larger.text
            && self.base == larger.base
            && keys(self) == keys(larger)
            && (self.runs.iter()).all(|run| of_larger.get(run.name.as_str()) == Some(&run.values.as_slice()))
    }

    fn value_differences(&self, new: &Self) -> Vec<String> {
        let mut told = Vec::new();
        for (k, column) in self.columns.iter().enumerate() {
            let known = |plan: &Self| -> Vec<String> {
                let mut seen = HashSet::new();
                let values = plan.runs.iter().map(|run| run.values[k].clone());
                values.filter(|value| seen.insert(value.clone())).collect()
            };
            let (was, is) = (known(self), known(new));
            let lacks = |some: &[String], all: &[String]| -> Vec<String> {
                some.iter().filter(|value| !all.contains(value)).cloned().collect()
            };
            let (gone, come) = (lacks(&was, &is), lacks(&is, &was));
            let of = |values: &[String]| shortened(values).join(", ");
            match (gone.is_empty(), come.is_empty()) {
                (true, true) => {}
                (true, false) => told.push(format!("`{}`: the values {} are new", column.key, of(&come))),
                (false, true) => told.push(format!("`{}`: the values {} are left out", column.key, of(&gone))),
                (false, false) => told.push(format!(
                    "`{}`: the values {} are new, {} are left out",
                    column.key,
                    of(&come),
                    of(&gone)
                )),
            }
        }
        let rows = |plan: &Self| -> Vec<Vec<String>> { plan.runs.iter().map(|run| run.values.clone()).collect() };
        if told.is_empty() && rows(self) != rows(new) {
            told.push("the combinations, or their order, differ".to_string());
        }
        told
    }

    /// What is wrong with a plan that was read, if anything is.
    pub(super) fn problem(&self) -> Option<String> {
        let keys = self.columns.len();
        if keys == 0 || self.runs.is_empty() || self.runs.len() > MAX_RUNS {
            return Some(format!("it tells {keys} keys and {} runs", self.runs.len()));
        }
        if let Some(column) = self.columns.iter().find(|column| key_steps(&column.key).is_none()) {
            return Some(format!("`{}` is not a key", column.key));
        }
        let mut taken = HashSet::new();
        let is_wrong = |run: &&PlannedRun| run.values.len() != keys || !is_name(&run.name);
        let wrong = self
            .runs
            .iter()
            .find(|run| is_wrong(run) || !taken.insert(run.name.clone()));
        wrong.map(|run| format!("the run `{}` is told wrongly, or twice", run.name))
    }
}
