//! How the folder of a run is reserved: by a lock on its marker, which is neither removed nor replaced as long as the folder is there.

use super::error::OutputError;
use super::folder::{MARKER, RunFolder, is_frame, names_in};
use crate::checkpoint;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, Read, Seek, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// What the marker names as the program that wrote it.
const PROGRAM: &str = "demeter";

/// Longest marker that is read [bytes].
const LONGEST_MARKER: u64 = 1 << 16;

/// In the names of the frames of the start.
const FRAME_OF_THE_START: &str = "_0000000000.";

/// How often the lock is asked for: whoever only looks whether a run is going on has it for a moment.
const ATTEMPTS: u32 = 5;

/// Time between two of these.
const PAUSE: Duration = Duration::from_millis(10);

/// Keeps others from writing into the folder of a run, until it is dropped or the process ends, however it ends.
#[derive(Debug)]
pub struct RunLock {
    /// The marker, locked where the file system knows locks.
    marker: File,
    is_locked: bool,
}

impl RunFolder {
    /// Makes the folder of a new run and leaves it to whoever comes next; [`RunFolder::reserve`] keeps it.
    pub fn create(root: &Path, overwrite: bool) -> Result<Self, OutputError> {
        Self::reserve(root, overwrite, |_, _| Vec::new()).map(|(folder, _)| folder)
    }

    /// Makes the folder of a new run and reserves it. Of several that ask for it at the same moment one gets it.
    ///
    /// A folder that is not empty is refused, unless `overwrite` is set or a run ended there before its first checkpoint: then the
    /// files of an earlier run, known by their names, are removed. Other files are never touched. `named` tells the files whose names
    /// follow from a scenario; it hears whether a run was in the folder.
    pub fn reserve(
        root: &Path,
        overwrite: bool,
        named: impl Fn(&Self, bool) -> Vec<PathBuf>,
    ) -> Result<(Self, RunLock), OutputError> {
        if let Some(link) = root.ancestors().find(|path| path.is_symlink() && !path.exists()) {
            return Err(OutputError::LinkToNowhere { link: link.to_owned() });
        }
        if root.exists() && !root.is_dir() {
            return Err(OutputError::NotAFolder { path: root.to_owned() });
        }
        fs::create_dir_all(root).map_err(OutputError::io("make the folder", root))?;
        let folder = Self::at(root);
        let inside = names_in(root)?;
        if let (Some(example), false) = (inside.first(), overwrite || inside.iter().any(|name| name == MARKER)) {
            return Err(OutputError::HoldsOtherFiles {
                folder: root.to_owned(),
                example: example.clone(),
            });
        }
        let (mut lock, is_new) = folder.take_marker()?;
        // only now does nobody else change what is there
        if !overwrite && folder.holds_a_run(&mut lock, is_new)? {
            return Err(OutputError::HoldsARun {
                folder: root.to_owned(),
            });
        }
        let was_a_run = is_ours(&lock.read().map_err(OutputError::io("read", &folder.marker()))?);
        let named = named(&folder, was_a_run);
        // first of all: whoever finds what a kill from here on leaves knows that it is ours
        lock.mark().map_err(OutputError::io("write", &folder.marker()))?;
        folder.remove_run(&named)?;
        folder.make_folders()?;
        Ok((folder, lock))
    }

    /// Makes and reserves the folder of a new run under this name, or, where it is taken, under the next free one of
    /// `NAME-2`, `NAME-3`, ...
    pub fn reserve_numbered(
        root: &Path,
        named: impl Fn(&Self, bool) -> Vec<PathBuf>,
    ) -> Result<(Self, RunLock), OutputError> {
        let mut number = 1;
        loop {
            match Self::reserve(&numbered(root, number), false, &named) {
                Err(error) if error.is_taken() && number < u32::MAX => number += 1,
                reserved => return reserved,
            }
        }
    }

    /// Reserves the folder for the run that goes on in this process.
    pub fn lock(&self) -> Result<RunLock, OutputError> {
        let path = self.marker();
        let marker = File::open(&path).map_err(OutputError::io("open", &path))?;
        self.lock_marker(marker)
    }

    /// Whether a run reserves the folder now; `false` where the file system knows no locks.
    pub fn is_locked(&self) -> bool {
        let marker = File::open(self.marker());
        marker.is_ok_and(|marker| matches!(marker.try_lock_shared(), Err(TryLockError::WouldBlock)))
    }

    /// Locks the marker, which is made where it is not there, and tells whether it was.
    fn take_marker(&self) -> Result<(RunLock, bool), OutputError> {
        let path = self.marker();
        let mut options = OpenOptions::new();
        options.read(true).write(true);
        let (marker, is_new) = match options.clone().create_new(true).open(&path) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => (options.open(&path), false),
            made => (made, true),
        };
        let marker = marker.map_err(OutputError::io("open", &path))?;
        Ok((self.lock_marker(marker)?, is_new))
    }

    fn lock_marker(&self, marker: File) -> Result<RunLock, OutputError> {
        for _ in 0..ATTEMPTS {
            match marker.try_lock() {
                Err(TryLockError::WouldBlock) => std::thread::sleep(PAUSE),
                tried => {
                    let is_locked = tried.is_ok();
                    return Ok(RunLock { marker, is_locked });
                }
            }
        }
        Err(OutputError::InUse {
            folder: self.root().to_owned(),
        })
    }

    /// Whether a run was begun here of which something is left. One that ended before its first checkpoint, at the start of the
    /// run, left nothing that another would not do again; an empty marker alone is from a time before that.
    fn holds_a_run(&self, lock: &mut RunLock, is_new: bool) -> Result<bool, OutputError> {
        if !lock.is_locked {
            // without locks the one that made the marker has the folder
            return Ok(!is_new);
        }
        let marker = lock.read().map_err(OutputError::io("read", &self.marker()))?;
        match marker.as_slice() {
            [] => Ok(names_in(self.root())?.len() > 1),
            marker if is_ours(marker) => self.came_beyond_its_start(),
            _ => Ok(true),
        }
    }

    /// Whether there is something that the start of a run does not leave: a checkpoint, the end of a stage or of the run, or, where
    /// these were removed, rows and frames.
    fn came_beyond_its_start(&self) -> Result<bool, OutputError> {
        let checkpoints = [checkpoint::LATEST, checkpoint::PREVIOUS].map(|name| self.root().join(name));
        let of_the_end = [self.summary(), self.picture(), self.report()];
        if checkpoints.iter().chain(&of_the_end).any(|path| path.exists()) {
            return Ok(true);
        }
        let is_later = |name: &String| !(is_frame(name) && name.contains(FRAME_OF_THE_START));
        for folder in [self.frames(), self.plots(), self.pictures()] {
            if names_in(&folder)?.iter().any(is_later) {
                return Ok(true);
            }
        }
        has_rows_behind_the_first(&self.series())
    }
}

impl RunLock {
    /// What is in the marker.
    fn read(&mut self) -> io::Result<Vec<u8>> {
        let mut text = Vec::new();
        self.marker.rewind()?;
        Read::by_ref(&mut self.marker)
            .take(LONGEST_MARKER)
            .read_to_end(&mut text)?;
        self.marker.rewind()?;
        Ok(text)
    }

    /// Writes what the marker tells. A new file in its place would not be locked.
    fn mark(&mut self) -> io::Result<()> {
        let text = format!(
            "{{\n  \"program\": \"{PROGRAM}\",\n  \"version\": \"{}\"\n}}\n",
            crate::VERSION
        );
        self.marker.write_all(text.as_bytes())?;
        self.marker.set_len(text.len() as u64)
    }
}

/// Whether a marker is that of a run, and not another file of this name.
fn is_ours(marker: &[u8]) -> bool {
    let marker: Option<serde_json::Value> = serde_json::from_slice(marker).ok();
    marker.is_some_and(|marker| marker["program"] == PROGRAM)
}

/// Whether a file of rows, with a header, holds more than one.
fn has_rows_behind_the_first(path: &Path) -> Result<bool, OutputError> {
    let file = match File::open(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(false),
        file => file.map_err(OutputError::io("open", path))?,
    };
    let mut third = BufReader::new(file).split(b'\n').skip(2);
    let third = third.next().transpose().map_err(OutputError::io("read", path))?;
    Ok(third.is_some())
}

fn numbered(root: &Path, number: u32) -> PathBuf {
    match number {
        1 => root.to_owned(),
        _ => {
            let mut name = root.as_os_str().to_owned();
            name.push(format!("-{number}"));
            name.into()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Barrier;
    use std::thread;

    /// No files with names of their own.
    fn none(_: &RunFolder, _: bool) -> Vec<PathBuf> {
        Vec::new()
    }

    /// What several get that ask at the same moment.
    fn race<T: Send>(count: usize, ask: impl Fn() -> T + Sync) -> Vec<T> {
        let (start, ask) = (Barrier::new(count), &ask);
        thread::scope(|scope| {
            let begin = || {
                start.wait();
                ask()
            };
            let asking: Vec<_> = (0..count).map(|_| scope.spawn(begin)).collect();
            asking.into_iter().map(|one| one.join().unwrap()).collect()
        })
    }

    #[test]
    fn of_several_at_the_same_moment_one_gets_the_folder() {
        let place = tempfile::tempdir().unwrap();
        let root = place.path().join("run");
        for overwrite in [false, true, true] {
            // all answers are kept to the end of the race, and the lock with them
            let answers = race(6, || RunFolder::reserve(&root, overwrite, none));
            assert_eq!(answers.iter().filter(|answer| answer.is_ok()).count(), 1, "{answers:?}");
            for refused in answers.iter().filter_map(|answer| answer.as_ref().err()) {
                assert!(matches!(refused, OutputError::InUse { .. }), "{refused}");
            }
            assert!(RunFolder::find(&root).unwrap().is_locked());
        }
        fs::write(RunFolder::at(&root).summary(), "{}").unwrap();
        let refused = RunFolder::reserve(&root, false, none).unwrap_err();
        assert!(matches!(refused, OutputError::HoldsARun { .. }), "{refused}");
    }

    #[test]
    fn who_asked_for_no_folder_takes_the_next() {
        let place = tempfile::tempdir().unwrap();
        let root = place.path().join("run");
        let answers = race(4, || RunFolder::reserve_numbered(&root, none).unwrap());
        let mut names: Vec<_> = answers.iter().map(|(folder, _)| folder.root().to_owned()).collect();
        names.sort();
        names.dedup();
        assert_eq!(names.len(), 4);
        assert_eq!(names[0], root);
    }

    #[test]
    fn a_run_that_was_killed_before_it_began_is_in_nobodys_way() {
        let place = tempfile::tempdir().unwrap();
        fs::write(place.path().join(MARKER), "").unwrap();
        let (folder, _lock) = RunFolder::reserve(place.path(), false, none).unwrap();
        let text = fs::read_to_string(folder.marker()).unwrap();
        assert!(text.contains(crate::VERSION), "{text}");
    }

    /// Killed, or ended with all processes of its job, between the making of the folder and its first checkpoint.
    #[test]
    fn a_run_that_ended_before_its_first_checkpoint_is_in_nobodys_way() {
        let place = tempfile::tempdir().unwrap();
        let root = place.path().join("run");
        let begin = || {
            let folder = RunFolder::create(&root, false).unwrap();
            for (path, text) in [
                (folder.scenario(), "title = \"a\""),
                (folder.log(), "time step"),
                (folder.series(), "step,time [s]\n0,0.0\n"),
                (folder.frames().join("grains_0000000000.vtp"), "x"),
                (checkpoint::part_path(&root.join(checkpoint::LATEST)), "DEMETERC"),
            ] {
                fs::write(path, text).unwrap();
            }
            folder
        };
        let folder = begin();
        RunFolder::create(&root, false).unwrap();
        assert!(!folder.series().exists() && !folder.log().exists());

        // but all that tells of more is kept
        let later = [
            (root.join(checkpoint::LATEST), "x"),
            (root.join(checkpoint::PREVIOUS), "x"),
            (folder.summary(), "{}"),
            (folder.report(), "<html>"),
            (folder.stage_picture(1, "settle"), "x"),
            (folder.series(), "step,time [s]\n0,0.0\n9,0.1\n"),
            (folder.frames().join("walls_0000000009.vtp"), "x"),
        ];
        for (path, text) in later {
            begin();
            fs::write(&path, text).unwrap();
            let refused = RunFolder::reserve(&root, false, none).unwrap_err();
            assert!(matches!(refused, OutputError::HoldsARun { .. }), "{refused}");
            assert_eq!(fs::read_to_string(&path).unwrap(), text);
            assert!(folder.scenario().exists());
            fs::remove_file(path).unwrap();
        }
        // a marker of something else protects what is there
        begin();
        fs::write(folder.marker(), "{}").unwrap();
        let refused = RunFolder::reserve(&root, false, none).unwrap_err();
        assert!(matches!(refused, OutputError::HoldsARun { .. }), "{refused}");
        assert!(folder.scenario().exists());
        // also where it is alone
        let alone = tempfile::tempdir().unwrap();
        fs::write(alone.path().join(MARKER), "{}").unwrap();
        assert!(RunFolder::reserve(alone.path(), false, none).is_err());
    }

    #[test]
    fn a_longer_marker_leaves_nothing_behind() {
        let place = tempfile::tempdir().unwrap();
        fs::write(place.path().join(MARKER), "{}".repeat(200)).unwrap();
        let folder = RunFolder::create(place.path(), true).unwrap();
        let text = fs::read_to_string(folder.marker()).unwrap();
        assert!(serde_json::from_str::<serde_json::Value>(&text).is_ok(), "{text}");
    }
}
