//! What can go wrong when runs are compared.

use crate::output::OutputError;
use crate::results::ResultsError;
use std::path::PathBuf;

/// Why a run or a measured curve cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    /// A file of a run or a measured curve cannot be read.
    #[error(transparent)]
    Read(#[from] ResultsError),
    /// No stage has the name that was told.
    #[error(
        "`{}` has no stage `{stage}`, which was told as the {phase} stage; its stages are {}", 
        path.display(), known.join(", ")
    )]
    NoStage {
        /// The series.
        path: PathBuf,
        /// The name that was told.
        stage: String,
        /// `"loading"` or `"unloading"`.
        phase: &'static str,
        /// Names of the stages, without the numbers of repeats.
        known: Vec<String>,
    },
    /// All cycles are discarded.
    #[error(
        "`{}` holds {found} cycles, and the first {discarded} are to be discarded: none is left. Discard fewer \
         (`--discard`), or repeat the stages more often",
        path.display()
    )]
    NoCycles {
        /// The series.
        path: PathBuf,
        /// Number of cycles in it.
        found: usize,
        /// Number to discard.
        discarded: usize,
    },
    /// The position in a stroke goes back.
    #[error(
        "`{}`, stage `{stage}`: the {position} turns back from {before} to {after} at {time} s, so that there is no one \
         force at a {position}. Name a stage that moves the plate in one direction only",
        path.display()
    )]
    TurnsBack {
        /// The series.
        path: PathBuf,
        /// The stage.
        stage: String,
        /// What the position is.
        position: &'static str,
        /// Position of the row before.
        before: f64,
        /// Position of the row.
        after: f64,
        /// Time of the row [s].
        time: f64,
    },
    /// A stroke is one row long.
    #[error(
        "`{}`, stage `{stage}`: {rows} rows at different {position}s are too few for a stroke; at least 2 are needed. \
         Write rows more often (`output.series`), or name the stage that moves the plate",
        path.display()
    )]
    ShortStroke {
        /// The series.
        path: PathBuf,
        /// The stage.
        stage: String,
        /// What the position is.
        position: &'static str,
        /// Number of rows.
        rows: usize,
    },
    /// The position cannot be had from the series.
    #[error("`{}` tells no {position}: {reason}", path.display())]
    NoPosition {
        /// The series.
        path: PathBuf,
        /// What the position is.
        position: &'static str,
        /// Why, and what to do.
        reason: String,
    },
    /// There are several force distributions, or not the one that was told.
    #[error("`{}` {problem}", folder.display())]
    Distribution {
        /// The folder of the run.
        folder: PathBuf,
        /// What is wrong and what to do.
        problem: String,
    },
    /// The distributions are too large.
    #[error(
        "`{}` holds more than {allowed} counts in the cycles that are kept. Use wider bins, fewer rows, or discard more \
         cycles",
        path.display()
    )]
    TooManyCounts {
        /// The distributions.
        path: PathBuf,
        /// The largest number of counts.
        allowed: usize,
    },
    /// A row of the series has no distribution.
    #[error(
        "`{}` tells nothing of step {step}, of which the series has a row: it belongs to another run, or was cut", 
        path.display()
    )]
    NoRow {
        /// The distributions.
        path: PathBuf,
        /// The step.
        step: u64,
    },
    /// A measured curve holds nothing that can be used.
    #[error("{name}: {problem}")]
    Measured {
        /// The file, or where the curve was told.
        name: String,
        /// What is wrong.
        problem: String,
    },
}

impl CompareError {
    /// Whether the system refused to read, rather than that what was read is wrong.
    pub fn is_io(&self) -> bool {
        matches!(self, Self::Read(error) if error.is_io())
    }
}

impl From<OutputError> for CompareError {
    fn from(error: OutputError) -> Self {
        Self::Read(error.into())
    }
}
