//! What can go wrong with the series.

use demeter::output::OutputError;
use demeter::scenario::{Diagnostics, RunError};
use std::io;
use std::path::{Path, PathBuf};

/// Why the series could not be simulated or read.
#[derive(Debug, thiserror::Error)]
pub enum RheologyError {
    /// The scenario is wrong.
    #[error("{0}")]
    Scenario(Box<Diagnostics>),
    /// The run could not be carried out.
    #[error(transparent)]
    Run(#[from] Box<RunError>),
    /// The run did not come to its end.
    #[error("the run in `{}` did not come to its end: {reason}", folder.display())]
    Unfinished {
        /// Folder of the run.
        folder: PathBuf,
        /// Why.
        reason: String,
    },
    /// The folder of the run holds another one.
    #[error(
        "`{}` holds a run of another scenario or version of Demeter; choose another --out, or replace it with --overwrite",
        folder.display()
    )]
    OtherRun {
        /// The folder.
        folder: PathBuf,
    },
    /// The run tells less than it should.
    #[error("the run in `{}` cannot be read: {problem}", folder.display())]
    Reading {
        /// The folder.
        folder: PathBuf,
        /// What is wrong.
        problem: String,
    },
    /// A figure could not be written.
    #[error(transparent)]
    Figure(#[from] OutputError),
    /// A file could not be read or written.
    #[error("cannot use {}: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

impl RheologyError {
    /// An error of reading or writing a file.
    pub(super) fn io(path: &Path) -> impl Fn(io::Error) -> Self + '_ {
        move |source| Self::Io {
            path: path.to_owned(),
            source,
        }
    }
}
