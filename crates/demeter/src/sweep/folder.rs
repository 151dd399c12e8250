//! The folder of a sweep: `sweep.json`, and a folder for every run.

use super::error::SweepError;
use super::plan::{Plan, Wishes};
use crate::checkpoint::{self, Durability, part_path, write_atomically};
use crate::output::RunFolder;
use crate::scenario::content;
use serde::{Deserialize, Serialize};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};

/// Version of the layout of `sweep.json`.
const FORMAT: u32 = 1;
/// The file that marks the folder of a sweep.
const MARKER: &str = "sweep.json";
/// The file by which processes tell each other that they work on the sweep.
const LOCK: &str = "sweep.lock";
/// How a run of a sweep ended, in its folder.
const OUTCOME: &str = "outcome.json";
/// Largest `sweep.json` that is read [bytes].
const MAX_SIZE: u64 = 256 << 20;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum End {
    /// All its stages are done.
    Finished,
    /// The simulation reached a state that the model does not cover.
    Fault,
    /// It could not go on: files could not be read or written.
    Error,
    /// Its process died.
    Crash,
}

impl End {
    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Finished => "finished",
            Self::Fault => "fault",
            Self::Error => "error",
            Self::Crash => "crash",
        }
    }
}

/// What came of a run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Outcome {
    /// How it ended.
    pub end: End,
    /// In words.
    pub message: String,
}

/// What is noted in the folder of a run that ended.
#[derive(Serialize, Deserialize)]
struct Record {
    #[serde(flatten)]
    outcome: Outcome,
    /// Of a finished run: [`SweepFolder::results_checksum`].
    #[serde(default)]
    results: Option<u32>,
}

/// How far a run is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Status {
    /// Nothing of it is there.
    Waiting,
    /// A process runs it.
    Running,
    /// It was interrupted or killed, and can go on.
    Interrupted,
    /// It ended.
    Ended(Outcome),
}

impl Status {
    /// Its name in tables and in `sweep.json`.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Waiting => "waiting",
            Self::Running => "running",
            Self::Interrupted => "interrupted",
            Self::Ended(outcome) => outcome.end.name(),
        }
    }

    /// Whether all its stages are done.
    pub fn is_finished(&self) -> bool {
        matches!(self, Self::Ended(outcome) if outcome.end == End::Finished)
    }

    /// Why it failed, if it did.
    pub fn failure(&self) -> Option<&Outcome> {
        match self {
            Self::Ended(outcome) if outcome.end != End::Finished => Some(outcome),
            _ => None,
        }
    }
}

/// Keeps others from working on the sweep, until it is dropped or the process ends, however it ends.
#[derive(Debug)]
pub struct Held {
    /// Nothing where the file system knows no locks.
    _lock: Option<File>,
}

/// The folder of a sweep.
#[derive(Clone, Debug)]
pub struct SweepFolder {
    root: PathBuf,
    /// What its runs follow from.
    pub plan: Plan,
    /// What is told and drawn.
    pub wishes: Wishes,
}

/// What `sweep.json` holds.
#[derive(Serialize, Deserialize)]
struct SweepFile {
    program: String,
    format: u32,
    #[serde(flatten)]
    plan: Plan,
    #[serde(flatten)]
    wishes: Wishes,
    /// How far each run was when the file was written.
    #[serde(default)]
    state: Vec<String>,
}

impl SweepFolder {
    /// A sweep that is to be; nothing is written.
    pub fn planned(root: &Path, plan: Plan, wishes: Wishes) -> Self {
        Self {
            root: root.to_owned(),
            plan,
            wishes,
        }
    }

    /// Makes the folder, which must be new or empty, and writes the plan into it.
    pub fn create(&self) -> Result<(), SweepError> {
        let root = &self.root;
        fs::create_dir_all(root).map_err(SweepError::io("make the folder", root))?;
        for entry in fs::read_dir(root).map_err(SweepError::io("list", root))? {
            let name = entry.map_err(SweepError::io("list", root))?.file_name();
            // what a kill in the middle of this left is replaced
            if Some(name.as_os_str()) != part_path(&root.join(MARKER)).file_name() {
                return Err(SweepError::HoldsOtherFiles {
                    folder: root.to_owned(),
                    example: name.to_string_lossy().into_owned(),
                });
            }
        }
        self.write_state(&self.statuses())
    }

    /// Whether a folder holds a sweep.
    pub fn is_one(root: &Path) -> bool {
        root.join(MARKER).is_file()
    }

    /// Opens the folder of a sweep.
    pub fn open(root: &Path) -> Result<Self, SweepError> {
        if !Self::is_one(root) {
            return Err(SweepError::NoSweep {
                folder: root.to_owned(),
            });
        }
        let path = root.join(MARKER);
        let damaged = |problem: String| SweepError::Damaged {
            path: path.clone(),
            problem,
        };
        let mut text = String::new();
        File::open(&path)
            .and_then(|file| file.take(MAX_SIZE).read_to_string(&mut text))
            .map_err(SweepError::io("read", &path))?;
        let read: SweepFile = serde_json::from_str(&text).map_err(|error| damaged(error.to_string()))?;
        if (read.program.as_str(), read.format) != ("demeter", FORMAT) {
            return Err(damaged(format!("its format is {}, known is {FORMAT}", read.format)));
        }
        if let Some(problem) = read.plan.problem() {
            return Err(damaged(problem));
        }
        Ok(Self {
            root: root.to_owned(),
            plan: read.plan,
            wishes: read.wishes,
        })
    }

    /// The folder itself.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The folder of a run.
    pub fn run_folder(&self, index: usize) -> PathBuf {
        self.root.join(&self.plan.runs[index].name)
    }

    /// Refuses to go on with files that are not what they were when the sweep began.
    pub fn check_files(&self) -> Result<(), SweepError> {
        let changes = self.plan.changed_files();
        if changes.is_empty() {
            return Ok(());
        }
        Err(SweepError::FilesChanged {
            folder: self.root.clone(),
            changes,
        })
    }

    /// Refuses a number that no run has.
    pub fn check_index(&self, index: usize) -> Result<(), SweepError> {
        match self.plan.runs.len() {
            count if index < count => Ok(()),
            count => Err(SweepError::NoRun {
                folder: self.root.clone(),
                index,
                last: count - 1,
            }),
        }
    }

    /// The table of results.
    pub fn results(&self) -> PathBuf {
        self.root.join("results.csv")
    }

    /// The means over seeds.
    pub fn averages(&self) -> PathBuf {
        self.root.join("averages.csv")
    }

    /// The folder of the plots.
    pub fn plots(&self) -> PathBuf {
        self.root.join("plots")
    }

    /// The script for Slurm.
    pub fn job_script(&self) -> PathBuf {
        self.root.join("job.sh")
    }

    /// Reserves the whole sweep for this process.
    pub fn hold(&self) -> Result<Held, SweepError> {
        self.lock(File::try_lock)
    }

    /// Reserves a part of the sweep, as others may do at the same time.
    pub fn join(&self) -> Result<Held, SweepError> {
        self.lock(File::try_lock_shared)
    }

    fn lock(&self, lock: impl Fn(&File) -> Result<(), TryLockError>) -> Result<Held, SweepError> {
        let path = self.root.join(LOCK);
        let opened = OpenOptions::new().create(true).truncate(false).write(true).open(&path);
        let file = opened.map_err(SweepError::io("open", &path))?;
        match lock(&file) {
            Ok(()) => Ok(Held { _lock: Some(file) }),
            Err(TryLockError::WouldBlock) => Err(SweepError::InUse {
                folder: self.root.clone(),
            }),
            Err(TryLockError::Error(_)) => Ok(Held { _lock: None }),
        }
    }

    /// How far a run is.
    pub fn status(&self, index: usize) -> Status {
        let folder = self.run_folder(index);
        if let Some(record) = read_record(&folder) {
            return Status::Ended(record.outcome);
        }
        match RunFolder::find(&folder) {
            Ok(run) if run.is_locked() => Status::Running,
            Ok(_) if has_checkpoint(&folder) => Status::Interrupted,
            _ => Status::Waiting,
        }
    }

    /// How far all runs are.
    pub fn statuses(&self) -> Vec<Status> {
        (0..self.plan.runs.len()).map(|index| self.status(index)).collect()
    }

    /// Notes what came of a run.
    pub fn record(&self, index: usize, outcome: &Outcome) -> Result<(), SweepError> {
        let folder = self.run_folder(index);
        fs::create_dir_all(&folder).map_err(SweepError::io("make the folder", &folder))?;
        let is_finished = outcome.end == End::Finished;
        let record = Record {
            outcome: outcome.clone(),
            results: is_finished.then(|| self.results_checksum(index)),
        };
        write_json(&folder.join(OUTCOME), &record)
    }

    /// Whether the results of a run are still those which it left when it finished.
    pub(super) fn holds_what_was_left(&self, index: usize) -> bool {
        let noted = read_record(&self.run_folder(index)).and_then(|record| record.results);
        noted.is_none_or(|noted| noted == self.results_checksum(index))
    }

    /// Checksum of the name of a run and of its results; a file that is not there counts 0.
    fn results_checksum(&self, index: usize) -> u32 {
        let mut checksum = crc32fast::Hasher::new();
        checksum.update(self.plan.runs[index].name.as_bytes());
        if let Ok(run) = RunFolder::find(&self.run_folder(index)) {
            for path in [run.series(), run.summary()] {
                let of_file = content(&path).map_or(0, |content| content.checksum);
                checksum.update(&of_file.to_le_bytes());
            }
        }
        checksum.finalize()
    }

    /// Forgets what came of a run.
    pub(super) fn forget(&self, index: usize) -> Result<(), SweepError> {
        let path = self.run_folder(index).join(OUTCOME);
        match fs::remove_file(&path) {
            Err(error) if error.kind() != ErrorKind::NotFound => Err(SweepError::io("remove", &path)(error)),
            _ => Ok(()),
        }
    }

    /// Writes `sweep.json` anew, with how far the runs are.
    pub fn write_state(&self, statuses: &[Status]) -> Result<(), SweepError> {
        let file = SweepFile {
            program: "demeter".to_string(),
            format: FORMAT,
            plan: self.plan.clone(),
            wishes: self.wishes.clone(),
            state: statuses.iter().map(|status| status.name().to_string()).collect(),
        };
        write_json(&self.root.join(MARKER), &file)
    }
}

/// Whether a run can go on in a folder.
pub(super) fn has_checkpoint(folder: &Path) -> bool {
    [checkpoint::LATEST, checkpoint::PREVIOUS]
        .iter()
        .any(|name| folder.join(name).is_file())
}

fn read_record(folder: &Path) -> Option<Record> {
    let text = fs::read_to_string(folder.join(OUTCOME)).ok()?;
    serde_json::from_str(&text).ok()
}

fn write_json<T: Serialize>(path: &Path, value: &T) -> Result<(), SweepError> {
    let mut text = serde_json::to_string_pretty(value)
        .map_err(|error| SweepError::io("encode", path)(std::io::Error::other(error)))?;
    text.push('\n');
    write_atomically(path, text.as_bytes(), Durability::PowerCut).map_err(SweepError::io("write", path))
}
