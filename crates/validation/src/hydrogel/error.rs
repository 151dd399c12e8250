//! What can go wrong in a validation.

use super::MODELS;
use demeter::compare::CompareError;
use demeter::output::OutputError;
use demeter::scenario::{Diagnostics, RunError};
use std::io;
use std::path::{Path, PathBuf};

/// Why the experiment could not be simulated or compared.
#[derive(Debug, thiserror::Error)]
pub enum ValidationError {
    /// No model has the name.
    #[error("there is no model `{name}`; there are {}", MODELS.map(|m| format!("`{}`", m.name)).join(", "))]
    UnknownModel {
        /// The name.
        name: String,
    },
    /// The scenario is wrong.
    #[error("{0}")]
    Scenario(Box<Diagnostics>),
    /// A run could not be carried out.
    #[error("{model}: {source}")]
    Run {
        /// The model.
        model: &'static str,
        /// Why.
        source: Box<RunError>,
    },
    /// A run did not come to its end.
    #[error("{model}: the run in `{}` did not come to its end: {reason}", folder.display())]
    Unfinished {
        /// The model.
        model: &'static str,
        /// Folder of the run.
        folder: PathBuf,
        /// Why.
        reason: String,
    },
    /// The folder of a run holds another one.
    #[error(
        "`{}` holds a run of another scenario or version of Demeter; choose another --out, or replace it with \
         --overwrite",
        folder.display()
    )]
    OtherRun {
        /// The folder.
        folder: PathBuf,
    },
    /// A run or a measured curve cannot be compared.
    #[error(transparent)]
    Compare(#[from] CompareError),
    /// A figure could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A metric that Table I needs is left out.
    #[error("{model}: {metric} cannot be told: {reason}")]
    LeftOut {
        /// The model.
        model: &'static str,
        /// The metric.
        metric: &'static str,
        /// Why.
        reason: String,
    },
    /// There is nothing to compare.
    #[error("no model was run; tell at least one with --models")]
    NoModel,
    /// The system refused.
    #[error("cannot write `{}`: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
}

impl ValidationError {
    pub(super) fn io(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { path, source }
    }
}
