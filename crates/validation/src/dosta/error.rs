//! What can go wrong with a case of the benchmark.

use super::CASES;
use demeter::scenario::{Diagnostics, RunError};
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
    /// The scenario is wrong.
    #[error("{0}")]
    Scenario(Box<Diagnostics>),
    /// The run could not be carried out.
    #[error("{case}: {source}")]
    Run {
        /// The case.
        case: &'static str,
        /// Why.
        source: Box<RunError>,
    },
    /// The run did not come to its end.
    #[error("{case}: the run in `{}` did not come to its end: {reason}", folder.display())]
    Unfinished {
        /// The case.
        case: &'static str,
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
