//! What can be wrong with a sweep.

use crate::checkpoint::hint;
use crate::output::OutputError;
use crate::results::ResultsError;
use crate::scenario::{Diagnostics, RunError};
use std::io;
use std::path::{Path, PathBuf};

/// Why a sweep cannot be made or go on.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// What is varied is not told as it must be.
    #[error("{}", problems.join("\n"))]
    Told {
        /// All that is wrong.
        problems: Vec<String>,
    },
    /// The scenario is no TOML, or what `--set` tells does not fit it.
    #[error("{0}")]
    Scenario(Box<Diagnostics>),
    /// The folder holds another sweep.
    #[error(
        "`{}` holds another sweep:\n  {}\nName another folder with --out, or tell the same to go on with this one.",
        folder.display(), differences.join("\n  ")
    )]
    Differs {
        /// The folder.
        folder: PathBuf,
        /// What differs.
        differences: Vec<String>,
    },
    /// Files that the scenarios name were changed since the sweep began.
    #[error(
        "files of the sweep in `{}` are not what they were when it began:\n  {}\nPut them back as they were, or begin the sweep anew \
         in another folder with --out.",
        folder.display(), changes.join("\n  ")
    )]
    FilesChanged {
        /// The folder.
        folder: PathBuf,
        /// Each with what changed.
        changes: Vec<String>,
    },
    /// The folder holds something else.
    #[error("`{}` is not empty and holds no sweep (but `{example}`): nothing was written there. Name another folder with --out.", folder.display())]
    HoldsOtherFiles {
        /// The folder.
        folder: PathBuf,
        /// Something in it.
        example: String,
    },
    /// The folder holds no sweep.
    #[error("`{}` holds no sweep: it has no `sweep.json`. Name the folder that `demeter sweep` wrote.", folder.display())]
    NoSweep {
        /// The folder.
        folder: PathBuf,
    },
    /// Another process works on the sweep.
    #[error("another `demeter sweep` works on `{}` at this moment. Wait for it, or stop it.", folder.display())]
    InUse {
        /// The folder.
        folder: PathBuf,
    },
    /// `sweep.json` is not as it was written.
    #[error("`{}` is damaged: {problem}. Move it away, and begin the sweep anew in another folder.", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        problem: String,
    },
    /// There is no run of this number.
    #[error("there is no run {index}: the runs of `{}` are numbered from 0 to {last}", folder.display())]
    NoRun {
        /// The folder.
        folder: PathBuf,
        /// The number asked for.
        index: usize,
        /// The last one.
        last: usize,
    },
    /// The folder of a run holds one of another scenario.
    #[error(
        "`{}` holds a run of another scenario, which this sweep did not begin. Move it away: the run is then begun anew.",
        folder.display()
    )]
    OtherRun {
        /// The folder of the run.
        folder: PathBuf,
    },
    /// The system refused.
    #[error("cannot {action} `{}`: {source}.{}", path.display(), hint(source).map_or_else(String::new, |h| format!(" {h}")))]
    Io {
        /// What was tried.
        action: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A run could not be carried out.
    #[error(transparent)]
    Run(#[from] RunError),
    /// Results cannot be read.
    #[error(transparent)]
    Results(#[from] ResultsError),
    /// Results cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
}

impl SweepError {
    /// One thing that is told wrongly.
    pub fn told(problem: impl Into<String>) -> Self {
        Self::Told {
            problems: vec![problem.into()],
        }
    }

    pub(super) fn io(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { action, path, source }
    }
}
