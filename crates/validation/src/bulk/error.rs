//! What can go wrong with a study.

use super::STUDIES;
use crate::runs::JobError;
use demeter::output::OutputError;
use demeter::results::ResultsError;
use std::io;
use std::path::{Path, PathBuf};

/// Why a study could not be carried out.
#[derive(Debug, thiserror::Error)]
pub enum BulkError {
    /// No study has the name.
    #[error("there is no study `{name}`; there are {}", STUDIES.map(|s| format!("`{}`", s.name)).join(", "))]
    UnknownStudy {
        /// The name.
        name: String,
    },
    /// A point cannot be studied.
    #[error("{study}: {value} is no {meaning}; {allowed}")]
    Point {
        /// The study.
        study: &'static str,
        /// The value.
        value: f64,
        /// What it should be.
        meaning: &'static str,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A run did not come to its end.
    #[error(transparent)]
    Run(#[from] JobError),
    /// A run cannot be read.
    #[error(transparent)]
    Series(#[from] ResultsError),
    /// A run is too short to tell what it is asked for.
    #[error("the run in `{}` is too short: {problem}", folder.display())]
    TooShort {
        /// Folder of the run.
        folder: PathBuf,
        /// What is missing.
        problem: &'static str,
    },
    /// A figure could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The system refused.
    #[error("cannot {action} `{}`: {source}", path.display())]
    Io {
        /// What was to be done.
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
}

impl BulkError {
    pub(super) fn io(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { action, path, source }
    }
}
