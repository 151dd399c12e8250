//! The folder of a run and the names of the files in it.

use super::error::OutputError;
use crate::checkpoint::{self, Durability, force_to_disk, part_path, write_atomically, write_atomically_with};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// The file that marks the folder of a run.
pub(super) const MARKER: &str = "run.json";

/// Every file that a run writes at the top of its folder, but for the marker, by whose lock the folder is reserved.
const FILES: [&str; 9] = [
    "scenario.toml",
    "log.txt",
    "series.csv",
    "summary.json",
    "packing.png",
    "grains.pvd",
    "contacts.pvd",
    "walls.pvd",
    "report.html",
];

/// Digits of a step in the name of a file, at least: they keep names sorted.
pub(super) const STEP_DIGITS: usize = 10;

/// The folder of a run.
#[derive(Clone, Debug)]
pub struct RunFolder {
    root: PathBuf,
    /// Files that a power cut may still take, of all that hold this folder.
    not_forced: Arc<Mutex<BTreeSet<PathBuf>>>,
}

impl PartialEq for RunFolder {
    fn eq(&self, other: &Self) -> bool {
        self.root == other.root
    }
}

impl Eq for RunFolder {}

impl RunFolder {
    pub(super) fn at(root: &Path) -> Self {
        Self {
            root: root.to_owned(),
            not_forced: Arc::default(),
        }
    }

    /// Finds the folder of a run that exists, to read from it.
    pub fn find(root: &Path) -> Result<Self, OutputError> {
        if root.join(MARKER).is_file() {
            return Ok(Self::at(root));
        }
        Err(OutputError::NotARun {
            folder: root.to_owned(),
            marker: MARKER,
        })
    }

    /// Opens the folder of a run that exists, to write more into it.
    pub fn open(root: &Path) -> Result<Self, OutputError> {
        let folder = Self::find(root)?;
        folder.make_folders()?;
        Ok(folder)
    }

    /// Makes the folders inside that every run has.
    pub(super) fn make_folders(&self) -> Result<(), OutputError> {
        for sub in [self.frames(), self.plots(), self.pictures()] {
            fs::create_dir_all(&sub).map_err(OutputError::io("make the folder", &sub))?;
        }
        Ok(())
    }

    /// Removes what an earlier run left, by name: the files that every run has, its frames, and these with names of their own, with the
    /// files that a collection among them numbers.
    pub(super) fn remove_run(&self, named: &[PathBuf]) -> Result<(), OutputError> {
        let of_all = FILES.iter().chain(&[checkpoint::LATEST, checkpoint::PREVIOUS]);
        for path in of_all.map(|name| self.root.join(name)).chain(named.iter().cloned()) {
            remove_if_there(&part_path(&path))?;
            remove_if_there(&path)?;
        }
        remove_from(&self.frames(), is_frame)?;
        for collection in named.iter().filter(|path| path.extension().is_some_and(|e| e == "pvd")) {
            if let (Some(folder), Some(stem)) = (collection.parent(), collection.file_stem()) {
                let stem = stem.to_string_lossy();
                remove_from(folder, |name| {
                    [".vti", ".vtp"].iter().any(|ending| is_numbered(name, &stem, ending))
                })?;
            }
        }
        // made by those runs only that measure them; they stay when they hold other files
        let _ = fs::remove_dir(self.distributions());
        let _ = fs::remove_dir(self.profiles());
        let _ = fs::remove_dir(self.fields());
        let _ = fs::remove_dir(self.paths());
        let _ = fs::remove_dir(self.chains());
        let _ = fs::remove_dir(self.removals());
        Ok(())
    }

    /// Writes a file of the run, whole or not at all.
    pub fn write(&self, path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
        write_atomically(path, bytes, Durability::Kill).map_err(OutputError::io("write", path))?;
        self.note(path);
        Ok(())
    }

    /// Has a file of the run written, whole or not at all.
    pub(crate) fn write_with(
        &self,
        path: &Path,
        write: impl FnOnce(&mut File) -> io::Result<()>,
    ) -> Result<(), OutputError> {
        write_atomically_with(path, Durability::Kill, write).map_err(OutputError::io("write", path))?;
        self.note(path);
        Ok(())
    }

    /// Notes that something was written into a file.
    fn note(&self, path: &Path) {
        let mut files = self.not_forced.lock().unwrap_or_else(PoisonError::into_inner);
        files.insert(path.to_owned());
    }

    /// Forces to the disk what was written since the last time, and these files that are open: a checkpoint builds on them, and must not
    /// outlive them in a power cut.
    pub(crate) fn force_to_disk<'a>(&self, open: impl Iterator<Item = &'a Path>) -> Result<(), OutputError> {
        let noted = std::mem::take(&mut *self.not_forced.lock().unwrap_or_else(PoisonError::into_inner));
        let files: BTreeSet<PathBuf> = noted.into_iter().chain(open.map(Path::to_owned)).collect();
        force_to_disk(&files).map_err(|(path, error)| OutputError::io("force to the disk", &path)(error))
    }

    /// Adds a line to the log.
    pub fn log_line(&self, text: &str) -> Result<(), OutputError> {
        let path = self.log();
        let add = || {
            let mut file = fs::OpenOptions::new().create(true).append(true).open(&path)?;
            file.write_all(format!("{text}\n").as_bytes())
        };
        add().map_err(OutputError::io("add to", &path))?;
        self.note(&path);
        Ok(())
    }

    /// The folder itself.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The file that marks it as that of a run, written when the run begins.
    pub fn marker(&self) -> PathBuf {
        self.root.join(MARKER)
    }

    /// The resolved scenario.
    pub fn scenario(&self) -> PathBuf {
        self.root.join("scenario.toml")
    }

    /// The log.
    pub fn log(&self) -> PathBuf {
        self.root.join("log.txt")
    }

    /// The time series.
    pub fn series(&self) -> PathBuf {
        self.root.join("series.csv")
    }

    /// The summary.
    pub fn summary(&self) -> PathBuf {
        self.root.join("summary.json")
    }

    /// The picture of the packing.
    pub fn picture(&self) -> PathBuf {
        self.root.join("packing.png")
    }

    /// The report, a page for browsers.
    pub fn report(&self) -> PathBuf {
        self.root.join("report.html")
    }

    /// The folder of the frames.
    pub fn frames(&self) -> PathBuf {
        self.root.join("frames")
    }

    /// The folder of the plots.
    pub fn plots(&self) -> PathBuf {
        self.root.join("plots")
    }

    /// Folder of the pictures of the ends of the stages.
    pub fn pictures(&self) -> PathBuf {
        self.root.join("pictures")
    }

    /// The picture of the end of a stage, by its number from 1 and its name.
    pub fn stage_picture(&self, number: usize, stage: &str) -> PathBuf {
        self.pictures().join(format!("{number:02}-{}.png", file_stem(stage)))
    }

    /// Folder of the distributions; [`RunFolder::make_distributions`] makes it.
    pub fn distributions(&self) -> PathBuf {
        self.root.join("distributions")
    }

    /// Makes the folder of the distributions.
    pub fn make_distributions(&self) -> Result<(), OutputError> {
        let sub = self.distributions();
        fs::create_dir_all(&sub).map_err(OutputError::io("make the folder", &sub))
    }

    /// The distribution that a measure writes, by the name of the measure.
    pub fn distribution(&self, measure: &str) -> PathBuf {
        self.distributions().join(format!("{measure}.csv"))
    }

    /// Folder of the profiles; [`RunFolder::make_profiles`] makes it.
    pub fn profiles(&self) -> PathBuf {
        self.root.join("profiles")
    }

    /// Makes the folder of the profiles.
    pub fn make_profiles(&self) -> Result<(), OutputError> {
        let sub = self.profiles();
        fs::create_dir_all(&sub).map_err(OutputError::io("make the folder", &sub))
    }

    /// The profile that a measure writes, by the name of the measure.
    pub fn profile(&self, measure: &str) -> PathBuf {
        self.profiles().join(format!("{measure}.csv"))
    }

    /// Folder of the fields; [`RunFolder::make_fields`] makes it.
    pub fn fields(&self) -> PathBuf {
        self.root.join("fields")
    }

    /// Makes the folder of the fields.
    pub fn make_fields(&self) -> Result<(), OutputError> {
        let sub = self.fields();
        fs::create_dir_all(&sub).map_err(OutputError::io("make the folder", &sub))
    }

    /// The collection of a field, by the name of the measure.
    pub fn field_collection(&self, measure: &str) -> PathBuf {
        self.fields().join(format!("{measure}.pvd"))
    }

    /// The table of a field along one direction, by the name of the measure.
    pub fn field_table(&self, measure: &str) -> PathBuf {
        self.fields().join(format!("{measure}.csv"))
    }

    /// Folder of the force chains; [`RunFolder::make_chains`] makes it.
    pub fn chains(&self) -> PathBuf {
        self.root.join("chains")
    }

    /// Makes the folder of the force chains.
    pub fn make_chains(&self) -> Result<(), OutputError> {
        let sub = self.chains();
        fs::create_dir_all(&sub).map_err(OutputError::io("make the folder", &sub))
    }

    /// The collection of force chains, by the name of the measure.
    pub fn chain_collection(&self, measure: &str) -> PathBuf {
        self.chains().join(format!("{measure}.pvd"))
    }

    /// The collection of the frames of a kind: `grains`, `contacts`, `walls`.
    pub fn frame_collection(&self, kind: &str) -> PathBuf {
        self.root.join(format!("{kind}.pvd"))
    }

    /// Folder of the paths of grains; [`RunFolder::make_paths`] makes it.
    pub fn paths(&self) -> PathBuf {
        self.root.join("paths")
    }

    /// Makes the folder of the paths.
    pub fn make_paths(&self) -> Result<(), OutputError> {
        let sub = self.paths();
        fs::create_dir_all(&sub).map_err(OutputError::io("make the folder", &sub))
    }

    /// The paths that a measure writes as a table, by the name of the measure.
    pub fn path_table(&self, measure: &str) -> PathBuf {
        self.paths().join(format!("{measure}.csv"))
    }

    /// The same paths as lines.
    pub fn path_lines(&self, measure: &str) -> PathBuf {
        self.paths().join(format!("{measure}.vtp"))
    }

    /// Folder of the grains that removals took; [`RunFolder::make_removals`] makes it.
    pub fn removals(&self) -> PathBuf {
        self.root.join("removals")
    }

    /// Makes the folder of the grains that removals took.
    pub fn make_removals(&self) -> Result<(), OutputError> {
        let sub = self.removals();
        fs::create_dir_all(&sub).map_err(OutputError::io("make the folder", &sub))
    }

    /// The grains that a removal took, by its name.
    pub fn removal(&self, name: &str) -> PathBuf {
        self.removals().join(format!("{name}.csv"))
    }

    /// A plot, by name without extension.
    pub fn plot(&self, name: &str) -> PathBuf {
        self.plots().join(format!("{}.svg", file_stem(name)))
    }
}

pub(super) fn is_frame(name: &str) -> bool {
    ["grains", "contacts", "walls"]
        .iter()
        .any(|kind| is_numbered(name, kind, ".vtp"))
}

/// Whether a name is that of a step in a collection, or of a file that is to become it.
fn is_numbered(name: &str, kind: &str, ending: &str) -> bool {
    let name = name.strip_suffix(".part").unwrap_or(name);
    let number = name.strip_prefix(kind).and_then(|rest| rest.strip_prefix('_'));
    let digits = number.and_then(|rest| rest.strip_suffix(ending)).unwrap_or_default();
    digits.len() >= STEP_DIGITS && digits.bytes().all(|digit| digit.is_ascii_digit())
}

/// A name that is a file name everywhere: letters and digits in lower case, all else as hyphens.
fn file_stem(name: &str) -> String {
    let words = name
        .split(|c: char| !c.is_alphanumeric())
        .filter(|word| !word.is_empty());
    let stem = words.map(str::to_lowercase).collect::<Vec<_>>().join("-");
    let cut: String = stem.chars().take(60).collect();
    if cut.is_empty() { "unnamed".to_string() } else { cut }
}

fn remove_from(folder: &Path, is_ours: impl Fn(&str) -> bool) -> Result<(), OutputError> {
    let mut names = names_in(folder)?.into_iter().filter(|name| is_ours(name));
    names.try_for_each(|name| remove_if_there(&folder.join(name)))
}

fn remove_if_there(path: &Path) -> Result<(), OutputError> {
    match fs::remove_file(path) {
        Err(e) if e.kind() != io::ErrorKind::NotFound => Err(OutputError::io("remove", path)(e)),
        _ => Ok(()),
    }
}

/// Names in a folder, sorted; none when the folder does not exist.
pub(super) fn names_in(folder: &Path) -> Result<Vec<String>, OutputError> {
    let entries = match fs::read_dir(folder) {
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        entries => entries.map_err(OutputError::io("list", folder))?,
    };
    let mut names = Vec::new();
    for entry in entries {
        let entry = entry.map_err(OutputError::io("list", folder))?;
        names.push(entry.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    Ok(names)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_folder_opens_again() {
        let place = tempfile::tempdir().unwrap();
        let root = place.path().join("runs").join("first");
        let folder = RunFolder::create(&root, false).unwrap();
        assert_eq!(RunFolder::open(&root).unwrap(), folder);
        assert!(folder.frames().is_dir() && folder.plots().is_dir());
    }

    #[test]
    fn what_was_written_is_forced_to_the_disk_once() {
        let place = tempfile::tempdir().unwrap();
        let folder = RunFolder::create(place.path(), false).unwrap();
        let waiting = || folder.not_forced.lock().unwrap().clone();
        folder.write(&folder.summary(), b"{}").unwrap();
        folder
            .write_with(&folder.report(), |file| file.write_all(b"x"))
            .unwrap();
        // another hand on the same folder
        folder.clone().log_line("said").unwrap();
        assert_eq!(
            waiting(),
            BTreeSet::from([folder.summary(), folder.report(), folder.log()])
        );
        // what somebody removed meanwhile is passed over
        fs::remove_file(folder.report()).unwrap();
        folder.force_to_disk([folder.series().as_path()].into_iter()).unwrap();
        assert!(waiting().is_empty());
        // a folder in place of a file cannot be forced as one, and is told
        folder.log_line("said").unwrap();
        fs::remove_file(folder.log()).unwrap();
        fs::create_dir(folder.log()).unwrap();
        let told = folder.force_to_disk(std::iter::empty()).unwrap_err().to_string();
        assert!(told.contains("force to the disk") && told.contains("log.txt"), "{told}");
    }

    #[test]
    fn an_earlier_run_is_kept_unless_told() {
        let place = tempfile::tempdir().unwrap();
        let folder = RunFolder::create(place.path(), false).unwrap();
        folder.write(&folder.series(), b"time\n").unwrap();
        folder
            .write(&folder.frames().join("grains_0000000001.vtp"), b"x")
            .unwrap();
        folder.make_distributions().unwrap();
        fs::write(folder.distribution("forces"), b"step\n").unwrap();
        folder.make_profiles().unwrap();
        fs::write(folder.profile("slices"), b"step\n").unwrap();
        folder.make_fields().unwrap();
        folder.make_chains().unwrap();
        let numbered = folder.fields().join("flow_0000000012.vti");
        let others = [
            place.path().join("notes.txt"),
            folder.profile("mine"),
            folder.fields().join("flow_of_mine.vti"),
            folder.chains().join("flow_0000000012.vtp"),
            folder.frames().join("grains_of_mine.vtp"),
            folder.plots().join("mine.svg"),
            folder.pictures().join("2024.png"),
        ];
        for path in others.iter().chain([&numbered]) {
            fs::write(path, "mine").unwrap();
        }
        let error = RunFolder::create(place.path(), false).unwrap_err();
        assert!(matches!(error, OutputError::HoldsARun { .. }));
        assert!(folder.series().exists());

        let named = |folder: &RunFolder, _| {
            vec![
                folder.distribution("forces"),
                folder.profile("slices"),
                folder.field_collection("flow"),
            ]
        };
        RunFolder::reserve(place.path(), true, named).unwrap();
        assert!(!folder.series().exists());
        assert!(!folder.frames().join("grains_0000000001.vtp").exists());
        assert!(!folder.distributions().exists() && !folder.profile("slices").exists());
        assert!(!numbered.exists());
        for path in others {
            assert_eq!(fs::read(&path).unwrap(), b"mine", "{}", path.display());
        }
    }

    #[test]
    fn two_runs_never_write_into_one_folder() {
        let place = tempfile::tempdir().unwrap();
        let folder = RunFolder::create(place.path(), false).unwrap();
        let lock = folder.lock().unwrap();
        folder.write(&folder.series(), b"time\n").unwrap();
        for refused in [
            folder.lock().map(|_| ()),
            RunFolder::create(place.path(), true).map(|_| ()),
        ] {
            assert!(matches!(refused, Err(OutputError::InUse { .. })), "{refused:?}");
        }
        // to read is allowed, and nothing was lost
        assert!(folder.is_locked());
        assert!(RunFolder::find(place.path()).is_ok());
        assert_eq!(fs::read(folder.series()).unwrap(), b"time\n");
        drop(lock);
        assert!(!folder.is_locked());
        RunFolder::create(place.path(), true).unwrap().lock().unwrap();
    }

    #[test]
    fn a_folder_of_something_else_is_refused() {
        let place = tempfile::tempdir().unwrap();
        fs::write(place.path().join("thesis.tex"), "mine").unwrap();
        let text = RunFolder::create(place.path(), false).unwrap_err().to_string();
        assert!(text.contains("thesis.tex"), "{text}");
        assert_eq!(names_in(place.path()).unwrap(), ["thesis.tex"]);
        let error = RunFolder::open(place.path()).unwrap_err();
        assert!(matches!(error, OutputError::NotARun { .. }));
        let run = place.path().join("run");
        let folder = RunFolder::create(&run, false).unwrap();
        folder.write(&folder.series(), b"step\n").unwrap();
        let text = RunFolder::open(&folder.series()).unwrap_err().to_string();
        assert!(text.ends_with(&format!("wrote, as `{}`.", run.display())), "{text}");
        let error = RunFolder::create(&place.path().join("thesis.tex"), true).unwrap_err();
        assert!(matches!(error, OutputError::NotAFolder { .. }));
    }

    #[cfg(unix)]
    #[test]
    fn a_link_that_leads_nowhere_is_told() {
        let place = tempfile::tempdir().unwrap();
        let (dangling, looping) = (place.path().join("a"), place.path().join("b"));
        std::os::unix::fs::symlink("gone", &dangling).unwrap();
        std::os::unix::fs::symlink("b", &looping).unwrap();
        for (root, link) in [
            (dangling.clone(), "a` is"),
            (looping, "b` is"),
            (dangling.join("run"), "a` is"),
        ] {
            let text = RunFolder::create(&root, true).unwrap_err().to_string();
            assert!(
                text.contains(link) && text.contains("a link that leads nowhere (to `"),
                "{text}"
            );
        }
        std::fs::create_dir(place.path().join("gone")).unwrap();
        RunFolder::create(&dangling.join("run"), false).unwrap();
    }
}
