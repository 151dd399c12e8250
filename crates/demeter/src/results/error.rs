//! What can go wrong when results are read.

use crate::checkpoint::hint;
use crate::output::OutputError;
use std::io;
use std::path::{Path, PathBuf};

/// Why results cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum ResultsError {
    /// The folder is no run.
    #[error(transparent)]
    Folder(#[from] OutputError),
    /// The system refused.
    #[error("cannot read `{}`: {source}{}", path.display(), hint_of(source))]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A link, or a folder in the place of a file.
    #[error(
        "`{}` is not a file of the run: it is a link that leads out of the folder, or no file at all. \
         Put the file itself there",
        path.display()
    )]
    NotInside {
        /// The file.
        path: PathBuf,
    },
    /// The file is larger than what is read.
    #[error("`{}` has {size} bytes; at most {allowed} are read. Write fewer rows (`output.series`)", path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// Its size [bytes].
        size: u64,
        /// The largest size [bytes].
        allowed: u64,
    },
    /// The run has no frame of the step.
    #[error("the run in `{}` has no frame of step {step}; `demeter info` tells how many it has", folder.display())]
    NoFrame {
        /// The folder of the run.
        folder: PathBuf,
        /// The step that was asked for.
        step: u64,
    },
    /// The file is not as it was written.
    #[error("`{}` is damaged, or no frame of Demeter: {problem}", path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        problem: String,
    },
    /// The file has no array of the name.
    #[error("`{}` has no array `{name}`; there are {}", path.display(), known.join(", "))]
    NoArray {
        /// The file.
        path: PathBuf,
        /// The name.
        name: String,
        /// The names of those that it has.
        known: Vec<String>,
    },
    /// The text is no table.
    #[error("`{}`: {problem}", path.display())]
    Table {
        /// The file.
        path: PathBuf,
        /// What is wrong, with the line.
        problem: String,
    },
    /// A column is missing.
    #[error("`{}` has no column `{column}`; {help}", path.display())]
    NoColumn {
        /// The file.
        path: PathBuf,
        /// The column.
        column: String,
        /// What there is, or how to get it.
        help: String,
    },
    /// A name fits more than one column.
    #[error("`{}`: the name `{column}` fits several columns: {columns}; {help}", path.display())]
    SeveralColumns {
        /// The file.
        path: PathBuf,
        /// The name.
        column: String,
        /// The columns.
        columns: String,
        /// What to do.
        help: &'static str,
    },
    /// A cell holds something else than it should.
    #[error("`{}`, line {line}, column `{column}`: `{found}` is not {expected}", path.display())]
    Cell {
        /// The file.
        path: PathBuf,
        /// Line of the file, from 1.
        line: u64,
        /// The column.
        column: String,
        /// What stands there, shortened.
        found: String,
        /// What should.
        expected: &'static str,
    },
}

impl ResultsError {
    pub(crate) fn io(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { path, source }
    }

    pub(super) fn damaged(path: &Path, problem: impl Into<String>) -> Self {
        Self::Damaged {
            path: path.to_owned(),
            problem: problem.into(),
        }
    }

    /// Whether the system refused to read, rather than that what was read is wrong.
    pub fn is_io(&self) -> bool {
        matches!(self, Self::Io { .. } | Self::Folder(OutputError::Io { .. }))
    }
}

fn hint_of(source: &io::Error) -> String {
    hint(source).map_or_else(String::new, |hint| format!(". {hint}"))
}
