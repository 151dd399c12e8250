//! What can go wrong with the series.

use crate::runs::JobError;
use demeter::output::OutputError;
use std::io;
use std::path::{Path, PathBuf};

/// Why the series could not be simulated or read.
#[derive(Debug, thiserror::Error)]
pub enum RheologyError {
    /// The run did not come to its end.
    #[error(transparent)]
    Run(#[from] JobError),
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
