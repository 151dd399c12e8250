//! Why there is no report.

use crate::output::OutputError;
use crate::results::ResultsError;

/// Why a report cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// The folder is no run.
    #[error(transparent)]
    Folder(#[from] ResultsError),
    /// The page cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
}

impl ReportError {
    /// Whether the system refused to read or write, rather than that the folder is wrong.
    pub fn is_io(&self) -> bool {
        match self {
            Self::Folder(error) => error.is_io(),
            Self::Output(_) => true,
        }
    }
}
