//! What can be wrong with a checkpoint.

use super::atomic_file;
use std::io;
use std::path::{Path, PathBuf};

/// What is wrong with a checkpoint and what to do about it.
#[derive(Debug, thiserror::Error)]
pub enum CheckpointError {
    /// The system refused.
    #[error("cannot {action} `{}`: {source}.{}", path.display(), hint_of(source))]
    Io {
        /// What was tried.
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The file is something else.
    #[error("`{}` is not a Demeter checkpoint: it does not start with `DEMETERC`. Name a checkpoint or a run folder.", path.display())]
    NotACheckpoint {
        /// The file.
        path: PathBuf,
    },
    /// The file ends too early.
    #[error(
        "checkpoint `{}` is cut short: {found} bytes instead of {expected}. It was copied or written incompletely; \
         use `checkpoint.previous` beside it, or copy it again.",
        path.display()
    )]
    CutShort {
        /// The file.
        path: PathBuf,
        /// Its right length [bytes].
        expected: u64,
        /// Its length [bytes].
        found: u64,
    },
    /// The file goes on after its end.
    #[error(
        "checkpoint `{}` is {found} bytes long, but its contents end after {expected}: it is damaged; \
         use `checkpoint.previous` beside it, or copy it again.",
        path.display()
    )]
    TooLong {
        /// The file.
        path: PathBuf,
        /// Its right length [bytes].
        expected: u64,
        /// Its length [bytes].
        found: u64,
    },
    /// The bytes changed after they were written.
    #[error(
        "checkpoint `{}` is damaged: the checksum of its {part} is {found:08x} instead of {expected:08x}; \
         use `checkpoint.previous` beside it, or copy it again.",
        path.display()
    )]
    Checksum {
        /// The file.
        path: PathBuf,
        /// Which part is damaged.
        part: &'static str,
        /// Checksum in the file.
        expected: u32,
        /// Checksum of what was read.
        found: u32,
    },
    /// Written by another Demeter.
    #[error(
        "checkpoint `{}` has format {found}, this Demeter ({}) reads format {known}. \
         Resume it with the version of Demeter that wrote it{}.",
        path.display(),
        crate::VERSION,
        if found > known { ", which is newer than this one" } else { ", which is older than this one" }
    )]
    Format {
        /// The file.
        path: PathBuf,
        /// Format of the file.
        found: u32,
        /// Format that is understood.
        known: u32,
    },
    /// The contents do not make sense although the checksum is right.
    #[error(
        "checkpoint `{}`: its {part} does not decode ({problem}). It was made by a different build of Demeter; \
         resume it with the build that wrote it.",
        path.display()
    )]
    Contents {
        /// The file.
        path: PathBuf,
        /// Which part.
        part: &'static str,
        /// What the decoder said.
        problem: String,
    },
    /// The state cannot be turned into bytes.
    #[error("cannot write checkpoint `{}`: its {part} does not encode ({problem}). This is a defect of Demeter.", path.display())]
    Encode {
        /// The file.
        path: PathBuf,
        /// Which part.
        part: &'static str,
        /// What the encoder said.
        problem: String,
    },
    /// There is none.
    #[error("`{}` holds no checkpoint: the run was not started here, or ended before its first checkpoint. Start it with `demeter run`.", folder.display())]
    Missing {
        /// The folder.
        folder: PathBuf,
    },
    /// There are some, none usable.
    #[error("`{}` holds no usable checkpoint: {}", folder.display(), join(problems))]
    NoneUsable {
        /// The folder.
        folder: PathBuf,
        /// What is wrong with each, newest first.
        problems: Vec<CheckpointError>,
    },
}

impl CheckpointError {
    pub(super) fn io(action: &'static str, path: &Path, source: io::Error) -> Self {
        Self::Io {
            action,
            path: path.to_owned(),
            source,
        }
    }

    pub(super) fn is_absent(&self) -> bool {
        matches!(self, Self::Io { source, .. } if source.kind() == io::ErrorKind::NotFound)
    }
}

fn hint_of(source: &io::Error) -> String {
    atomic_file::hint(source).map_or_else(String::new, |hint| format!(" {hint}"))
}

fn join(problems: &[CheckpointError]) -> String {
    let texts: Vec<String> = problems.iter().map(ToString::to_string).collect();
    texts.join(" ")
}
