//! Files that appear whole under their name or not at all.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// What a finished file survives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Durability {
    /// The death of the process, at any moment.
    Kill,
    /// A power cut too: the file and its folder are forced to the disk, which takes milliseconds.
    PowerCut,
}

/// Name under which a file is written before it gets its own: the name with `.part` behind it, in the same folder.
pub fn part_path(path: &Path) -> PathBuf {
    let mut name = path.file_name().map_or_else(OsString::new, OsString::from);
    name.push(".part");
    path.with_file_name(name)
}

/// Writes a file under a temporary name in the same folder and then gives it its own name, replacing what was there.
///
/// On an error the file that was there before is untouched and the temporary one is removed.
pub fn write_atomically(path: &Path, bytes: &[u8], durability: Durability) -> io::Result<()> {
    write_atomically_with(path, durability, |file| file.write_all(bytes))
}

/// The same with a file that is written piece by piece.
pub(crate) fn write_atomically_with(
    path: &Path,
    durability: Durability,
    write: impl FnOnce(&mut File) -> io::Result<()>,
) -> io::Result<()> {
    let part = write_part(path, durability, write)?;
    give_name(&part, path, durability)
}

/// Has a file written under the temporary name and returns that.
pub(super) fn write_part(
    path: &Path,
    durability: Durability,
    write: impl FnOnce(&mut File) -> io::Result<()>,
) -> io::Result<PathBuf> {
    let part = part_path(path);
    let written = write_file(&part, durability, write);
    if written.is_err() {
        // A leftover is harmless, it is overwritten by the next attempt: the error that matters is the first.
        let _ = fs::remove_file(&part);
    }
    written.map(|()| part)
}

fn write_file(path: &Path, durability: Durability, write: impl FnOnce(&mut File) -> io::Result<()>) -> io::Result<()> {
    let mut file = File::create(path)?;
    write(&mut file)?;
    match durability {
        Durability::Kill => Ok(()),
        Durability::PowerCut => file.sync_all(),
    }
}

/// Renames a finished temporary file to its own name.
pub(super) fn give_name(part: &Path, path: &Path, durability: Durability) -> io::Result<()> {
    fs::rename(part, path)?;
    match durability {
        Durability::Kill => Ok(()),
        Durability::PowerCut => sync_folder(path),
    }
}

/// Forces files to the disk, and the entries of their folders; those that are gone are passed over. The first that could not be is told with
/// the error.
pub(crate) fn force_to_disk(files: &BTreeSet<PathBuf>) -> Result<(), (PathBuf, io::Error)> {
    let if_there = |done: io::Result<()>| match done {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        done => done,
    };
    for file in files {
        let forced = OpenOptions::new()
            .write(true)
            .open(file)
            .and_then(|file| file.sync_all());
        if_there(forced).map_err(|error| (file.clone(), error))?;
    }
    let folders: BTreeSet<&Path> = files.iter().map(|file| folder_of(file)).collect();
    for folder in folders {
        if_there(sync_entries(folder)).map_err(|error| (folder.to_owned(), error))?;
    }
    Ok(())
}

/// Forces the entries of the folder of a file to the disk.
fn sync_folder(path: &Path) -> io::Result<()> {
    sync_entries(folder_of(path))
}

/// Forces the entries of a folder to the disk, where the system knows how.
fn sync_entries(folder: &Path) -> io::Result<()> {
    if cfg!(unix) {
        File::open(folder)?.sync_all()
    } else {
        Ok(())
    }
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// What a user can do about an error of the file system, as a sentence, if there is something to say.
pub fn hint(error: &io::Error) -> Option<&'static str> {
    use io::ErrorKind as Kind;
    match error.kind() {
        Kind::StorageFull => Some("The disk is full: free some space. Everything written before is intact."),
        Kind::QuotaExceeded => {
            Some("Your disk quota is used up: free some space. Everything written before is intact.")
        }
        Kind::PermissionDenied => Some("You may not write there: choose another folder or change its permissions."),
        Kind::ReadOnlyFilesystem => Some("The file system is read-only: choose another folder."),
        Kind::NotFound => Some("Check the path; was the folder moved or deleted?"),
        Kind::FileTooLarge => Some(
            "No file may become that large there: choose another disk, or raise the limit of your shell (`ulimit -f`). \
             Everything written before is intact.",
        ),
        _ if is_out_of_handles(error) => Some(
            "This process, or the machine, may not open more files: raise the limit of your shell (`ulimit -n`), or end other programs.",
        ),
        _ => None,
    }
}

/// Whether no file could be opened as too many are open, for which no kind of errors stands.
fn is_out_of_handles(error: &io::Error) -> bool {
    const ENFILE: i32 = 23;
    const EMFILE: i32 = 24;
    cfg!(unix) && matches!(error.raw_os_error(), Some(ENFILE | EMFILE))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_replaced_whole_and_leaves_no_part() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        write_atomically(&path, b"first", Durability::Kill).unwrap();
        write_atomically(&path, b"second", Durability::PowerCut).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"second");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[cfg(unix)]
    #[test]
    fn too_many_open_files_are_told_with_what_helps() {
        for code in [23, 24] {
            let told = hint(&io::Error::from_raw_os_error(code)).unwrap();
            assert!(told.contains("ulimit -n"), "{told}");
        }
    }

    #[test]
    fn a_failed_write_keeps_the_old_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        write_atomically(&path, b"first", Durability::Kill).unwrap();
        // A folder in the way of the temporary file makes the write fail.
        fs::create_dir(part_path(&path)).unwrap();
        write_atomically(&path, b"second", Durability::Kill).unwrap_err();
        assert_eq!(fs::read(&path).unwrap(), b"first");
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_named() {
        let full = Path::new("/dev/full");
        let error = write_file(full, Durability::Kill, |file| file.write_all(b"x")).unwrap_err();
        assert!(hint(&error).unwrap().contains("disk is full"));
    }
}
