//! Why packings cannot be converted.

use crate::grain_files::{FileError, FileProblem, Format, WriteError};
use crate::results::ResultsError;
use std::io;
use std::path::{Path, PathBuf};

/// Why packings cannot be converted.
#[derive(Debug, thiserror::Error)]
pub enum ConvertError {
    /// The input is wrong.
    #[error(transparent)]
    Read(#[from] FileError),
    /// The run cannot be read.
    #[error(transparent)]
    Run(#[from] ResultsError),
    /// The input is a table of a frame, but not that of its grains.
    #[error("`{}` holds {kind}, no grains; those of its moment are in `{}`", path.display(), grains.display())]
    NoGrains {
        /// The file.
        path: PathBuf,
        /// What it holds.
        kind: &'static str,
        /// The table of the grains.
        grains: PathBuf,
    },
    /// The input is what a run is made of.
    #[error("`{}` is a scenario, which holds no packing; run it, and name the folder of the run", path.display())]
    Scenario {
        /// The file.
        path: PathBuf,
    },
    /// A table cannot be written.
    #[error("{}: {problem}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// Why.
        problem: WriteError,
    },
    /// The system refused.
    #[error("cannot write `{}`: {source}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// There is a file already.
    #[error("`{}` is there already; name another file, or give `--overwrite`", path.display())]
    Exists {
        /// The file.
        path: PathBuf,
    },
    /// Input and output are the same file.
    #[error("`{}` is input and output; name another file to write", path.display())]
    Same {
        /// The file.
        path: PathBuf,
    },
    /// The name of the output tells no format.
    #[error(
        "`{}` tells no format; name it with one of {}, or tell it (`--to`): {}, vtp",
        path.display(),
        ENDINGS,
        Format::names().collect::<Vec<_>>().join(", ")
    )]
    NoFormat {
        /// The file.
        path: PathBuf,
    },
    /// Several moments for a format that holds one.
    #[error(
        "{format} holds one moment, and several are asked for; put a `*` into the name of the output, which stands for the step, as \
         `{example}`, or choose one (`--frame last`)"
    )]
    OneMoment {
        /// The format.
        format: String,
        /// A name with a star.
        example: String,
    },
    /// Something that was told beside the input, which tells otherwise.
    #[error("`--{option}` is told and has no effect: {why}; leave it out")]
    NoEffect {
        /// The option.
        option: &'static str,
        /// Why.
        why: &'static str,
    },
    /// A moment that is not there.
    #[error("`{}` has no moment number {number}; there are {there}, from 0{}", path.display(), and_lacks(lacks))]
    NoMoment {
        /// The input.
        path: PathBuf,
        /// The number that was asked for.
        number: usize,
        /// How many there are.
        there: usize,
        /// What is missing of the run, in words.
        lacks: Vec<String>,
    },
}

fn and_lacks(lacks: &[String]) -> String {
    lacks.iter().map(|problem| format!("; {problem}")).collect()
}

/// Endings that tell a format.
const ENDINGS: &str = ".csv, .data, .liggghts, .dump, .xyz, .yade, .vtp";

impl ConvertError {
    pub(super) fn io(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { path, source }
    }

    /// Whether the system refused, rather than that what was asked for is wrong.
    pub fn is_io(&self) -> bool {
        match self {
            Self::Io { .. }
            | Self::Write {
                problem: WriteError::Io(_),
                ..
            } => true,
            Self::Run(error) => error.is_io(),
            Self::Read(error) => {
                matches!(&*error.problem, FileProblem::Read(source) if source.kind() != io::ErrorKind::NotFound)
            }
            _ => false,
        }
    }
}
