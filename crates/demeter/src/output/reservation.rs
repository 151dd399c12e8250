//! How the folder of a run is reserved: by a lock on its marker, which is neither removed nor replaced as long as the folder is there.

use super::error::OutputError;
use super::folder::{MARKER, RunFolder, names_in};
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

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
        Self::reserve(root, overwrite).map(|(folder, _)| folder)
    }

    /// Makes the folder of a new run and reserves it. Of several that ask for it at the same moment one gets it.
    ///
    /// A folder that is not empty is refused, unless `overwrite` is set: then the files of an earlier run, known by
    /// their names, are removed. Other files are never touched.
    pub fn reserve(root: &Path, overwrite: bool) -> Result<(Self, RunLock), OutputError> {
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
        if !overwrite && folder.holds_a_run(&lock, is_new)? {
            return Err(OutputError::HoldsARun {
                folder: root.to_owned(),
            });
        }
        folder.remove_run()?;
        folder.make_folders()?;
        lock.mark().map_err(OutputError::io("write", &folder.marker()))?;
        Ok((folder, lock))
    }

    /// Makes and reserves the folder of a new run under this name, or, where it is taken, under the next free one of
    /// `NAME-2`, `NAME-3`, ...
    pub fn reserve_numbered(root: &Path) -> Result<(Self, RunLock), OutputError> {
        let mut number = 1;
        loop {
            match Self::reserve(&numbered(root, number), false) {
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

    /// Whether a run was begun here; an empty marker alone was left by one that was killed before.
    fn holds_a_run(&self, lock: &RunLock, is_new: bool) -> Result<bool, OutputError> {
        if !lock.is_locked {
            // without locks the one that made the marker has the folder
            return Ok(!is_new);
        }
        let path = self.marker();
        let length = lock.marker.metadata().map_err(OutputError::io("look at", &path))?.len();
        Ok(length > 0 || names_in(self.root())?.len() > 1)
    }
}

impl RunLock {
    /// Writes what the marker tells. A new file in its place would not be locked.
    fn mark(&mut self) -> io::Result<()> {
        let text = format!(
            "{{\n  \"program\": \"demeter\",\n  \"version\": \"{}\"\n}}\n",
            crate::VERSION
        );
        self.marker.write_all(text.as_bytes())?;
        self.marker.set_len(text.len() as u64)
    }
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
            let answers = race(6, || RunFolder::reserve(&root, overwrite));
            assert_eq!(answers.iter().filter(|answer| answer.is_ok()).count(), 1, "{answers:?}");
            for refused in answers.iter().filter_map(|answer| answer.as_ref().err()) {
                assert!(matches!(refused, OutputError::InUse { .. }), "{refused}");
            }
            assert!(RunFolder::find(&root).unwrap().is_locked());
        }
        let refused = RunFolder::reserve(&root, false).unwrap_err();
        assert!(matches!(refused, OutputError::HoldsARun { .. }), "{refused}");
    }

    #[test]
    fn who_asked_for_no_folder_takes_the_next() {
        let place = tempfile::tempdir().unwrap();
        let root = place.path().join("run");
        let answers = race(4, || RunFolder::reserve_numbered(&root).unwrap());
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
        let (folder, _lock) = RunFolder::reserve(place.path(), false).unwrap();
        let text = fs::read_to_string(folder.marker()).unwrap();
        assert!(text.contains(crate::VERSION), "{text}");
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
