//! What can go wrong with a case of the benchmark.

use super::CASES;
use crate::runs::JobError;
use demeter::results::ResultsError;
use std::io;
use std::path::{Path, PathBuf};

/// Why a case could not be simulated.
#[derive(Debug, thiserror::Error)]
pub enum DostaError {
    /// No case has the name.
    #[error("there is no case `{name}`; there are {}", CASES.map(|c| format!("`{}`", c.name)).join(", "))]
    UnknownCase {
        /// The name.
        name: String,
    },
    /// A published file holds what it should not.
    #[error("{} holds {found}; {expected}", path.display())]
    Data {
        /// The file.
        path: PathBuf,
        /// What was found.
        found: String,
        /// What should be there.
        expected: &'static str,
    },
    /// A run did not come to its end.
    #[error(transparent)]
    Run(#[from] JobError),
    /// A series cannot be read.
    #[error(transparent)]
    Series(#[from] ResultsError),
    /// A run tells less than it should.
    #[error("the run in `{}` cannot be read: {problem}", folder.display())]
    Reading {
        /// Folder of the run.
        folder: PathBuf,
        /// What is missing.
        problem: String,
    },
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

impl DostaError {
    pub(super) fn io(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { action, path, source }
    }
}
