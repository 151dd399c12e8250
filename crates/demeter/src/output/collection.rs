//! Collections (`.pvd`): which file belongs to which time.

use super::error::OutputError;
use super::folder::{RunFolder, STEP_DIGITS, names_in};
use super::vtk_file::ends_whole;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

/// The files of one kind, in the order of their steps.
#[derive(Debug)]
pub(crate) struct Collection {
    /// Folder of the collection.
    root: PathBuf,
    /// Folder of the files, from there; empty when it is the same.
    below: &'static str,
    kind: String,
    ending: &'static str,
    path: PathBuf,
    /// Step and time [s] of every file, in the order of the steps.
    entries: Vec<(u64, f64)>,
    /// How many of them the collection on disk names, and where its end begins there [bytes]; nothing where it is to be written anew.
    saved: Option<(usize, u64)>,
}

const BEGIN: &str = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n";
const END: &str = "</Collection>\n</VTKFile>\n";

impl Collection {
    /// An empty collection.
    pub fn new(folder: &RunFolder, kind: &'static str) -> Self {
        Self::of(folder.frame_collection(kind), "frames/", kind, ".vtp")
    }

    /// An empty collection of fields.
    pub fn of_fields(folder: &RunFolder, measure: &str) -> Self {
        Self::of(folder.field_collection(measure), "", measure, ".vti")
    }

    /// An empty collection of force chains.
    pub fn of_chains(folder: &RunFolder, measure: &str) -> Self {
        Self::of(folder.chain_collection(measure), "", measure, ".vtp")
    }

    fn of(path: PathBuf, below: &'static str, kind: &str, ending: &'static str) -> Self {
        Self {
            root: path.parent().unwrap_or(Path::new("")).to_owned(),
            path,
            below,
            kind: kind.to_owned(),
            ending,
            entries: Vec::new(),
            saved: None,
        }
    }

    /// The file of a step.
    pub fn file_path(&self, step: u64) -> PathBuf {
        self.root.join(self.file(step))
    }

    /// Number of files.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Name of the file of a step, from the folder of the collection. The digits keep names sorted by step.
    pub fn file(&self, step: u64) -> String {
        format!("{}{}_{step:0STEP_DIGITS$}{}", self.below, self.kind, self.ending)
    }

    /// Adds a file, in place of one of the same step.
    pub fn add(&mut self, step: u64, time: f64) {
        let at = self.entries.partition_point(|entry| entry.0 < step);
        self.saved = self.saved.filter(|(count, _)| *count <= at);
        match self.entries.get_mut(at) {
            Some(entry) if entry.0 == step => entry.1 = time,
            _ => self.entries.insert(at, (step, time)),
        }
    }

    /// Writes the collection: in place of its end where the file is as it was left, so that many frames do not each write all
    /// before them; anew otherwise.
    pub fn save(&mut self, folder: &RunFolder) -> Result<(), OutputError> {
        let at = match self.saved.take() {
            Some((count, at)) if self.append(count, at).is_ok() => at + self.lines(count).len() as u64,
            _ => {
                let text = [BEGIN, &self.lines(0), END].concat();
                folder.write(&self.path, text.as_bytes())?;
                (text.len() - END.len()) as u64
            }
        };
        self.saved = Some((self.entries.len(), at));
        Ok(())
    }

    /// Writes all but the first entries over the end of the file, which begins at a place.
    fn append(&self, count: usize, at: u64) -> io::Result<()> {
        let mut file = OpenOptions::new().write(true).open(&self.path)?;
        if file.metadata()?.len() != at + END.len() as u64 {
            return Err(io::Error::other("changed by someone else"));
        }
        file.seek(SeekFrom::Start(at))?;
        file.write_all([self.lines(count).as_str(), END].concat().as_bytes())
    }

    /// The lines of all but the first entries.
    fn lines(&self, count: usize) -> String {
        let line = |&(step, time): &(u64, f64)| {
            let file = self.file(step);
            format!("<DataSet timestep=\"{time:?}\" part=\"0\" file=\"{file}\"/>\n")
        };
        self.entries[count..].iter().map(line).collect()
    }

    /// Starts the collection, or goes on with it after a step: later files are taken out and removed. Tells files that it names and
    /// that are gone, and files that it does not name, as warnings.
    pub fn open(&mut self, folder: &RunFolder, after: Option<u64>) -> Result<Vec<String>, OutputError> {
        let Some(step) = after else {
            self.save(folder)?;
            return Ok(Vec::new());
        };
        let gone = self.load()?;
        let lacks = [self.names_in_vain(&gone, step), self.lacks(step)?];
        self.cut(folder, step)?;
        Ok(lacks.into_iter().flatten().collect())
    }

    /// Reads the collection as [`Self::save`] wrote it; lines that it does not know, and files that are not whole,
    /// are left out. Tells the steps of the latter.
    fn load(&mut self) -> Result<Vec<u64>, OutputError> {
        let text = match fs::read_to_string(&self.path) {
            Err(e) if e.kind() == io::ErrorKind::NotFound => String::new(),
            text => text.map_err(OutputError::io("read", &self.path))?,
        };
        Ok(self.read(&text))
    }

    /// Takes over the entries of a text as [`Self::save`] writes it, where their files are whole; tells the steps of the others.
    pub fn read(&mut self, text: &str) -> Vec<u64> {
        self.entries.clear();
        self.saved = None;
        let entries: Vec<(u64, f64)> = text.lines().filter_map(|line| self.parse(line)).collect();
        let (there, gone): (Vec<_>, Vec<_>) = entries
            .into_iter()
            .partition(|(step, _)| is_whole(&self.file_path(*step)));
        there.into_iter().for_each(|(step, time)| self.add(step, time));
        gone.into_iter().map(|(step, _)| step).collect()
    }

    /// Where the collection is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Step and time [s] of every file, in the order of the steps.
    pub fn entries(&self) -> &[(u64, f64)] {
        &self.entries
    }

    fn parse(&self, line: &str) -> Option<(u64, f64)> {
        let time = attribute(line, "timestep")?.parse().ok()?;
        let step = self.step_of(attribute(line, "file")?.strip_prefix(self.below)?)?;
        Some((step, time))
    }

    fn step_of(&self, name: &str) -> Option<u64> {
        let digits = name.strip_prefix(self.kind.as_str())?.strip_prefix('_')?;
        digits.strip_suffix(self.ending)?.parse().ok()
    }

    /// A warning of files up to a step that the collection names and that are not there.
    fn names_in_vain(&self, gone: &[u64], step: u64) -> Option<String> {
        let gone: Vec<u64> = gone.iter().copied().filter(|gone| *gone <= step).collect();
        let [first, ..] = gone[..] else { return None };
        let (path, count) = (self.path.display(), gone.len());
        let (files, are) = if count == 1 { ("file", "is") } else { ("files", "are") };
        Some(format!(
            "`{path}` names {count} {files} that {are} gone or cut short, `{}` among them: left out from now on",
            self.file(first)
        ))
    }

    /// A warning of files up to a step that the collection does not name.
    pub(crate) fn lacks(&self, step: u64) -> Result<Option<String>, OutputError> {
        let names = names_in(&self.root.join(self.below))?;
        let steps = names.iter().filter_map(|name| self.step_of(name));
        let is_known = |step: &u64| self.entries.binary_search_by_key(step, |entry| entry.0).is_ok();
        let unknown: Vec<u64> = steps.filter(|found| *found <= step && !is_known(found)).collect();
        let [first, ..] = unknown[..] else { return Ok(None) };
        let (path, count) = (self.path.display(), unknown.len());
        let files = if count == 1 { "file" } else { "files" };
        Ok(Some(format!(
            "`{path}` does not name {count} {files} that the run has written, `{}` among them: what reads frames \
            will not find them",
            self.file(first)
        )))
    }

    /// Drops what is later than a step: from the collection first, then the files.
    fn cut(&mut self, folder: &RunFolder, step: u64) -> Result<(), OutputError> {
        self.entries.retain(|entry| entry.0 <= step);
        self.saved = None;
        self.save(folder)?;
        let frames = self.root.join(self.below);
        for name in names_in(&frames)? {
            if self
                .step_of(name.strip_suffix(".part").unwrap_or(&name))
                .is_some_and(|s| s > step)
            {
                let path = frames.join(name);
                fs::remove_file(&path).map_err(OutputError::io("remove", &path))?;
            }
        }
        Ok(())
    }
}

/// Whether a file is there to its end. One that the system does not let be read now is not lost.
fn is_whole(path: &Path) -> bool {
    let is_file = fs::metadata(path).is_ok_and(|file| file.is_file());
    is_file
        && File::open(path)
            .and_then(|mut file| ends_whole(&mut file))
            .unwrap_or(true)
}

fn attribute<'a>(line: &'a str, name: &str) -> Option<&'a str> {
    let start = line.find(&format!("{name}=\""))? + name.len() + 2;
    let length = line[start..].find('"')?;
    line.get(start..start + length)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: &[u8] = b"x\n</AppendedData>\n</VTKFile>\n";

    #[test]
    fn what_is_later_than_the_restart_goes() {
        let place = tempfile::tempdir().unwrap();
        let folder = RunFolder::create(place.path(), false).unwrap();
        let mut collection = Collection::new(&folder, "grains");
        for step in [0, 10, 20, 30] {
            folder.write(&folder.root().join(collection.file(step)), FRAME).unwrap();
            collection.add(step, step as f64 / 3.0);
        }
        collection.save(&folder).unwrap();
        // A frame that was written before the kill, but is not yet in the collection.
        folder.write(&folder.root().join(collection.file(40)), FRAME).unwrap();
        fs::write(folder.frames().join("contacts_0000000040.vtp"), FRAME).unwrap();

        let mut again = Collection::new(&folder, "grains");
        again.load().unwrap();
        again.cut(&folder, 15).unwrap();
        assert_eq!(again.entries, [(0, 0.0), (10, 10.0 / 3.0)]);
        let left = names_in(&folder.frames()).unwrap();
        assert_eq!(
            left,
            [
                "contacts_0000000040.vtp",
                "grains_0000000000.vtp",
                "grains_0000000010.vtp"
            ]
        );
        let text = fs::read_to_string(folder.root().join("grains.pvd")).unwrap();
        assert_eq!(text.matches("<DataSet ").count(), 2);
    }

    #[test]
    fn what_is_added_is_written_over_the_end_and_anew_where_someone_wrote() {
        let place = tempfile::tempdir().unwrap();
        let folder = RunFolder::create(place.path(), false).unwrap();
        let mut collection = Collection::new(&folder, "grains");
        let text = |collection: &Collection| fs::read_to_string(collection.path()).unwrap();
        collection.save(&folder).unwrap();
        let empty = text(&collection);
        // a mark in what stands before the end tells whether it was written anew
        fs::write(collection.path(), empty.replace("0.1", "0.7")).unwrap();
        for step in [1, 2, 4] {
            collection.add(step, step as f64);
            collection.save(&folder).unwrap();
        }
        assert!(text(&collection).contains("0.7"), "{}", text(&collection));

        // one between, one in place of another, and a file that is longer or gone
        let whole = |collection: &mut Collection, step: u64, time: f64| {
            collection.add(step, time);
            collection.save(&folder).unwrap();
            let mut again = Collection::new(&folder, "grains");
            again.entries.clone_from(&collection.entries);
            let written = text(collection);
            again.save(&folder).unwrap();
            assert_eq!(written, text(&again));
        };
        whole(&mut collection, 3, 3.0);
        whole(&mut collection, 4, 4.5);
        whole(&mut collection, 5, 5.0);
        fs::write(collection.path(), text(&collection) + "\n").unwrap();
        whole(&mut collection, 6, 6.0);
        fs::remove_file(collection.path()).unwrap();
        whole(&mut collection, 7, 7.0);
    }

    #[test]
    fn files_that_the_collection_does_not_name_are_told() {
        let place = tempfile::tempdir().unwrap();
        let folder = RunFolder::create(place.path(), false).unwrap();
        let mut collection = Collection::new(&folder, "grains");
        for step in [0, 10, 20, 30] {
            folder.write(&folder.root().join(collection.file(step)), FRAME).unwrap();
        }
        collection.add(0, 0.0);
        collection.add(10, 0.5);
        assert_eq!(collection.lacks(10).unwrap(), None);
        let told = collection.lacks(25).unwrap().unwrap();
        assert!(
            told.contains("1 file that") && told.contains("grains_0000000020.vtp"),
            "{told}"
        );
    }

    #[test]
    fn a_damaged_collection_is_read_as_far_as_it_makes_sense() {
        let place = tempfile::tempdir().unwrap();
        let folder = RunFolder::create(place.path(), false).unwrap();
        let mut collection = Collection::new(&folder, "walls");
        collection.load().unwrap();
        assert_eq!(collection.len(), 0);
        folder.write(&folder.root().join(collection.file(7)), FRAME).unwrap();
        let text = "<DataSet timestep=\"1.5\" file=\"frames/walls_0000000007.vtp\"/>\n<DataSet timestep=\"\n\
                    <DataSet timestep=\"2\" file=\"../walls_0000000008.vtp\"/>\n";
        fs::write(&collection.path, text).unwrap();
        collection.load().unwrap();
        assert_eq!(collection.entries, [(7, 1.5)]);
        for cut in [&FRAME[..FRAME.len() - 1], b""] {
            fs::write(collection.file_path(7), cut).unwrap();
            assert_eq!(collection.load().unwrap(), [7], "{cut:?}");
        }
    }
}
