//! What can go wrong when results are written.

use super::folder::MARKER;
use crate::checkpoint::hint;
use std::io;
use std::path::{Path, PathBuf};

/// Why results could not be written.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The system refused.
    #[error("cannot {action} `{}`: {source}.{}", path.display(), hint_of(source))]
    Io {
        /// What was tried.
        action: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// The folder holds results of an earlier run.
    #[error(
        "`{}` already holds a Demeter run. Choose another folder, continue that run with `demeter resume`, \
         or allow to overwrite it (`--overwrite`).",
        folder.display()
    )]
    HoldsARun {
        /// The folder.
        folder: PathBuf,
    },
    /// The folder holds something else.
    #[error(
        "`{}` is not empty and not a Demeter run (it holds `{example}`): nothing was written there. Choose another \
         folder, or allow to overwrite; only files with the names of a run would be replaced.",
        folder.display()
    )]
    HoldsOtherFiles {
        /// The folder.
        folder: PathBuf,
        /// Something in it.
        example: String,
    },
    /// Another process writes into the folder.
    #[error(
        "another run is being written into `{}` at this moment. Wait for it, stop it, or choose another folder.",
        folder.display()
    )]
    InUse {
        /// The folder.
        folder: PathBuf,
    },
    /// The name belongs to a file.
    #[error("`{}` is a file, a folder is needed for the results. Choose another name.", path.display())]
    NotAFolder {
        /// The file.
        path: PathBuf,
    },
    /// The name is that of a link which leads to nothing that is there.
    #[error(
        "`{}` is a link that leads nowhere{}, a folder is needed for the results. Make what it leads to, remove the link, or choose \
         another name.",
        link.display(), its_target(link)
    )]
    LinkToNowhere {
        /// The link.
        link: PathBuf,
    },
    /// The folder is no run.
    #[error(
        "`{}` is not the folder of a Demeter run: {}. Name the folder that `demeter run` wrote{}.",
        folder.display(), lacks(folder, marker), its_run(folder)
    )]
    NotARun {
        /// The folder.
        folder: PathBuf,
        /// The file that is missing.
        marker: &'static str,
    },
    /// A file of rows does not belong to the run.
    #[error(
        "`{}` does not continue this run: {problem}. Put the file back as the run wrote it. To go on without its rows, put an empty \
        file in its place.",
        path.display()
    )]
    OtherSeries {
        /// The file.
        path: PathBuf,
        /// What differs.
        problem: String,
    },
    /// A file of rows has other columns than the scenario asks for.
    #[error(
        "`{}` has other columns than the scenario tells: {}. A file keeps its columns: put it back as the run wrote it, or, where the \
        scenario was changed, leave walls, feeds, removals, measures and what walls record as they were. To go on without its rows \
        so far, put an empty file in its place.",
        path.display(), other_titles(lacks, others)
    )]
    OtherColumns {
        /// The file.
        path: PathBuf,
        /// Titles that it lacks.
        lacks: Vec<String>,
        /// Titles that it has beside those of the scenario.
        others: Vec<String>,
    },
    /// Files of a run that goes on are gone.
    #[error(
        "{}. Put the {} back, or begin the run anew in another folder. To go on without what is lost, put an empty file in its place.",
        are_gone(files), if files.len() == 1 { "file" } else { "files" }
    )]
    FilesGone {
        /// Each with the step of the last moment that was written into it; there is one at least.
        files: Vec<(PathBuf, u64)>,
    },
    /// A file of rows is not as the run wrote it, at its end.
    #[error(
        "{problem}. Something else removed or changed this file while the run went on. \
        Leave the files of a run alone until it is over. To end the run from its latest checkpoint, put `{}` back, or an \
        empty file in its place, and call `demeter resume`.",
        path.display()
    )]
    RowsLost {
        /// The file.
        path: PathBuf,
        /// What reading it told.
        problem: String,
    },
    /// A row does not fit the header.
    #[error("a row of `{}` has {found} {what}, its header has {expected}. This is a defect of Demeter.", path.display())]
    RowDoesNotFit {
        /// The file.
        path: PathBuf,
        /// What differs in number.
        what: &'static str,
        /// How many the header has.
        expected: usize,
        /// How many the row has.
        found: usize,
    },
    /// Something cannot be encoded.
    #[error("cannot encode `{}`: {problem}. This is a defect of Demeter.", path.display())]
    Encode {
        /// The file.
        path: PathBuf,
        /// What the encoder said.
        problem: String,
    },
}

impl OutputError {
    /// Whether a folder is taken, so that another name may do.
    pub(super) fn is_taken(&self) -> bool {
        matches!(
            self,
            Self::HoldsARun { .. } | Self::HoldsOtherFiles { .. } | Self::InUse { .. } | Self::NotAFolder { .. }
        )
    }

    pub(super) fn io(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::Io { action, path, source }
    }

    pub(crate) fn encode(path: &Path, problem: &impl ToString) -> Self {
        Self::Encode {
            path: path.to_owned(),
            problem: problem.to_string(),
        }
    }
}

fn hint_of(source: &io::Error) -> String {
    hint(source).map_or_else(String::new, |hint| format!(" {hint}"))
}

/// Titles told of each kind, at most.
const TITLES: usize = 3;

/// Which columns differ.
fn other_titles(lacks: &[String], others: &[String]) -> String {
    let list = |what: &str, titles: &[String]| {
        let told: Vec<String> = titles.iter().take(TITLES).map(|title| format!("`{title}`")).collect();
        let more = match titles.len().saturating_sub(TITLES) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        (!titles.is_empty()).then(|| format!("{what} {}{more}", told.join(", ")))
    };
    let told: Vec<String> = [list("it lacks", lacks), list("it has", others)]
        .into_iter()
        .flatten()
        .collect();
    match told.is_empty() {
        true => "they have another order".to_owned(),
        false => told.join("; "),
    }
}

/// Which files are not there, and what they held.
fn are_gone(files: &[(PathBuf, u64)]) -> String {
    let one = |(path, step): &(PathBuf, u64)| {
        let path = path.display();
        format!("`{path}` is not there, though the run wrote into it up to step {step}")
    };
    let told: Vec<String> = files.iter().map(one).collect();
    told.join(";\n")
}

/// Where a link leads to.
fn its_target(link: &Path) -> String {
    let target = std::fs::read_link(link);
    target.map_or_else(|_| String::new(), |target| format!(" (to `{}`)", target.display()))
}

/// Why a path is no run.
fn lacks(path: &Path, marker: &str) -> String {
    match path.is_file() {
        true => "it is a file".to_owned(),
        false if !path.exists() => "there is no such folder".to_owned(),
        false => format!("it has no `{marker}`"),
    }
}

/// The run that a file lies in, or, of a scenario that was run, where its run lies.
fn its_run(path: &Path) -> String {
    let around = path.parent().filter(|around| around.join(MARKER).is_file());
    let name = path
        .file_stem()
        .filter(|_| path.extension().is_some_and(|e| e == "toml"));
    let run = || name.map(|name| Path::new("runs").join(name)).filter(|run| run.is_dir());
    let run = around.map(Path::to_owned).or_else(run);
    run.map_or_else(String::new, |run| format!(", as `{}`", run.display()))
}
