//! Why a number cannot be found from a measured curve.

use crate::compare::CompareError;
use crate::contacts::Fault;
use crate::scenario::RunError;
use std::path::PathBuf;

/// Why a fit of a packing ended without an answer.
#[derive(Debug, thiserror::Error)]
pub enum PackingError {
    /// A trial could not be run.
    #[error(transparent)]
    Run(#[from] RunError),
    /// A trial could not be compared.
    #[error(transparent)]
    Compare(#[from] CompareError),
    /// A trial stopped, for a reason that does not tell whether the value is too large or too small.
    #[error(
        "the trial with {what} stopped on a fault, so that its force is not known (its results are in `{}`): {fault}. \
         For the fit: narrow the interval of the unknown to values that run, or change the scenario",
        folder.display()
    )]
    Fault {
        /// Key and value.
        what: String,
        /// Folder of the trial.
        folder: PathBuf,
        /// The fault.
        fault: Box<Fault>,
    },
    /// A trial was interrupted.
    #[error(
        "interrupted in the trial with {what}, which has a checkpoint in `{}`; the same command goes on from there",
        folder.display()
    )]
    Interrupted {
        /// Key and value.
        what: String,
        /// Folder of the trial.
        folder: PathBuf,
    },
    /// A trial does not tell what is to be matched.
    #[error("the trial with {what}, in `{}`, cannot be compared with the measured curve: {reason}", folder.display())]
    Metric {
        /// Key and value.
        what: String,
        /// Folder of the trial.
        folder: PathBuf,
        /// Why.
        reason: String,
    },
    /// There is no folder for a trial.
    #[error(
        "the trials cannot go into `{}`: it is a run itself, a file, or full. Choose another folder (`--out`)",
        folder.display()
    )]
    NoPlace {
        /// The folder.
        folder: PathBuf,
    },
}
