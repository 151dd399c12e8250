//! What can go wrong in a validation.

use super::MODELS;
use crate::runs::JobError;
use demeter::compare::CompareError;
use demeter::output::OutputError;
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
    /// A run did not come to its end.
    #[error(transparent)]
    Run(#[from] JobError),
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
