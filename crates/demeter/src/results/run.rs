//! The folder of a run, read.

use super::columns::{Column, Columns, Update};
use super::error::ResultsError;
use super::poly_data::TableFile;
use crate::output::RunFolder;
use crate::output::collection::Collection;
use crate::output::vtk::KINDS;
use crate::output::vtp::PolyData;
use std::collections::BTreeSet;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Largest collection, summary or scenario that is read [bytes].
const MAX_TEXT: u64 = 256 << 20;

/// The tables of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum TableKind {
    /// One row for every grain.
    Grains,
    /// One row for every contact that acts.
    Contacts,
    /// One row for every triangle of a wall.
    Walls,
}

impl TableKind {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Grains, Self::Contacts, Self::Walls];

    /// Its name, with which its files begin.
    pub fn name(self) -> &'static str {
        KINDS[self as usize]
    }
}

/// A moment that a run has written a frame of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Steps done.
    pub step: u64,
    /// Simulated time [s].
    pub time: f64,
}

/// The three tables of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameTables {
    /// The grains.
    pub grains: PolyData,
    /// The contacts that act.
    pub contacts: PolyData,
    /// The triangles of the walls.
    pub walls: PolyData,
}

/// What a run left in its folder, or has left until now.
#[derive(Clone, Debug)]
pub struct Run {
    folder: RunFolder,
    /// The folder without links, which no file may leave.
    inside: PathBuf,
}

impl Run {
    /// Opens the folder of a run.
    pub fn open(root: &Path) -> Result<Self, ResultsError> {
        let folder = RunFolder::find(root)?;
        let inside = root.canonicalize().map_err(ResultsError::io(root))?;
        Ok(Self { folder, inside })
    }

    /// The folder, which knows the names of its files.
    pub fn folder(&self) -> &RunFolder {
        &self.folder
    }

    /// Whether a process writes into the folder at this moment; `false` where the file system knows no locks.
    pub fn is_going_on(&self) -> bool {
        self.folder.is_locked()
    }

    /// The moments of which all three tables are there, in order.
    pub fn moments(&self) -> Result<Vec<Moment>, ResultsError> {
        let mut collections = Vec::new();
        for kind in TableKind::ALL {
            collections.push(self.collection(kind)?.0);
        }
        let has = |collection: &Collection, step| collection.entries().binary_search_by_key(&step, |e| e.0).is_ok();
        let whole = |(step, _): &&(u64, f64)| collections.iter().all(|collection| has(collection, *step));
        let moment = |&(step, time): &(u64, f64)| Moment { step, time };
        Ok(collections[0].entries().iter().filter(whole).map(moment).collect())
    }

    /// That tables of frames which the run has written are gone or cut short, or not named by their collection, in words; nothing where none is
    /// missing.
    pub fn missing_frames(&self) -> Result<Option<String>, ResultsError> {
        let mut steps = BTreeSet::new();
        let mut problems = Vec::new();
        let may_lag = self.is_going_on();
        for kind in TableKind::ALL {
            let (collection, gone) = self.collection(kind)?;
            // of a file that is gone is told below
            let unnamed = if may_lag || !gone.is_empty() {
                None
            } else {
                collection.lacks(u64::MAX)?
            };
            problems.extend(unnamed);
            steps.extend(gone);
        }
        if let Some(last) = steps.last() {
            let (count, frames) = (steps.len(), if steps.len() == 1 { "frame is" } else { "frames are" });
            problems.push(format!(
                "{count} {frames} not whole: files are gone or cut short that the run has written, the last of them of step {last}"
            ));
        }
        Ok((!problems.is_empty()).then(|| problems.join("; ")))
    }

    /// What is not there any more, or not whole, of the results of a finished run: summary, series, frames. As long as a run goes on
    /// nothing is missing.
    pub fn missing(&self) -> Result<Vec<String>, ResultsError> {
        if self.is_going_on() {
            return Ok(Vec::new());
        }
        let mut missing = Vec::new();
        if self.summary()?.is_none() {
            missing.push("`summary.json` is gone".to_string());
        }
        missing.extend(self.missing_series()?);
        if let Some(series) = self.series()? {
            missing.extend(
                self.shortfall(&series)?
                    .map(|problem| format!("`series.csv`: {problem}")),
            );
        }
        missing.extend(self.missing_frames()?);
        Ok(missing)
    }

    /// The tables of a kind that the run tells of, as far as they are there, and the steps of those that are not.
    fn collection(&self, kind: TableKind) -> Result<(Collection, Vec<u64>), ResultsError> {
        let mut collection = Collection::new(&self.folder, kind.name());
        let text = self.text(collection.path())?.unwrap_or_default();
        let gone = collection.read(&text);
        Ok((collection, gone))
    }

    /// Opens a table of the frame of a step, to read some of its arrays.
    pub fn open_table(&self, kind: TableKind, step: u64) -> Result<TableFile, ResultsError> {
        let path = self.table_path(kind, step);
        let file = self.file(&path)?.ok_or_else(|| ResultsError::NoFrame {
            folder: self.folder.root().to_owned(),
            step,
        })?;
        TableFile::open(&path, file)
    }

    /// Where a table of the frame of a step is, or would be.
    pub fn table_path(&self, kind: TableKind, step: u64) -> PathBuf {
        Collection::new(&self.folder, kind.name()).file_path(step)
    }

    /// A table of the frame of a step.
    pub fn table(&self, kind: TableKind, step: u64) -> Result<PolyData, ResultsError> {
        self.open_table(kind, step)?.read_all()
    }

    /// All tables of the frame of a step.
    pub fn frame(&self, step: u64) -> Result<FrameTables, ResultsError> {
        Ok(FrameTables {
            grains: self.table(TableKind::Grains, step)?,
            contacts: self.table(TableKind::Contacts, step)?,
            walls: self.table(TableKind::Walls, step)?,
        })
    }

    /// The series; nothing as long as the run has not begun it.
    pub fn series(&self) -> Result<Option<Columns>, ResultsError> {
        self.columns(&self.folder.series())
    }

    /// That a finished run has no series any more, in words; nothing where no summary can be read.
    pub fn missing_series(&self) -> Result<Option<String>, ResultsError> {
        let summary = self.summary().ok().flatten();
        let is_finished = summary.as_ref().and_then(finished_steps).is_some();
        let is_gone = is_finished && self.series()?.is_none();
        Ok(is_gone.then(|| "`series.csv` is gone, which the run has written".to_string()))
    }

    /// What the series of a finished run lacks, in words; nothing where no summary tells that it is finished, and as
    /// long as it goes on.
    pub fn shortfall(&self, series: &Columns) -> Result<Option<String>, ResultsError> {
        let Some(summary) = self.summary()? else {
            return Ok(None);
        };
        let Some(steps) = finished_steps(&summary) else {
            return Ok(None);
        };
        if let Some(problem) = summary["lost_rows"]["series.csv"].as_str() {
            return Ok(Some(format!(
                "it {problem}: it was not whole when the run went on. Run the scenario again for all rows"
            )));
        }
        let last = series.find("step").and_then(Column::numbers).and_then(<[f64]>::last);
        if last.is_some_and(|last| *last >= steps as f64) || self.is_going_on() {
            return Ok(None);
        }
        Ok(Some(shortfall(last.map(|last| *last as u64), steps)))
    }

    /// A table of rows in the folder: the series, a profile, a distribution; nothing when it is not there.
    pub fn columns(&self, path: &Path) -> Result<Option<Columns>, ResultsError> {
        let file = self.file(path)?;
        file.map(|file| Columns::from_file(path, file)).transpose()
    }

    /// Reads what was added to a table of rows since.
    pub fn update(&self, columns: &mut Columns) -> Result<Update, ResultsError> {
        let path = columns.path().to_owned();
        match self.file(&path)? {
            Some(file) => columns.update_from(file),
            None => Ok(Update::Unchanged),
        }
    }

    /// The summary; nothing as long as the run goes on, and after a kill.
    pub fn summary(&self) -> Result<Option<serde_json::Value>, ResultsError> {
        let path = self.folder.summary();
        let Some(text) = self.text(&path)? else {
            return Ok(None);
        };
        let summary = serde_json::from_str(&text);
        summary.map(Some).map_err(|e| ResultsError::Table {
            path,
            problem: format!("not JSON: {e}"),
        })
    }

    /// The text of the scenario as it was run; nothing when it is not there.
    pub fn scenario(&self) -> Result<Option<String>, ResultsError> {
        self.text(&self.folder.scenario())
    }

    /// A file of the folder, open; nothing when it is not there. Links that lead out of the folder are refused, and what is
    /// no plain file.
    pub fn file(&self, path: &Path) -> Result<Option<File>, ResultsError> {
        let io = |e| Err(ResultsError::io(path)(e));
        let real = match path.canonicalize() {
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            Err(e) => return io(e),
            Ok(real) => real,
        };
        if !real.starts_with(&self.inside) || !real.is_file() {
            return Err(ResultsError::NotInside { path: path.to_owned() });
        }
        File::open(&real).map_or_else(io, |file| Ok(Some(file)))
    }

    fn text(&self, path: &Path) -> Result<Option<String>, ResultsError> {
        let Some(file) = self.file(path)? else {
            return Ok(None);
        };
        let size = file.metadata().map_err(ResultsError::io(path))?.len();
        let allowed = MAX_TEXT;
        if size > allowed {
            let path = path.to_owned();
            return Err(ResultsError::TooLarge { path, size, allowed });
        }
        let mut text = String::new();
        file.take(allowed)
            .read_to_string(&mut text)
            .map_err(ResultsError::io(path))?;
        Ok(Some(text))
    }
}

/// The steps of a finished run, as its summary tells them.
pub fn finished_steps(summary: &serde_json::Value) -> Option<u64> {
    let is_finished = summary["finished"].as_bool() == Some(true);
    summary["steps"].as_u64().filter(|_| is_finished)
}

/// That the series of a finished run has no row of its last step.
pub fn shortfall(last: Option<u64>, steps: u64) -> String {
    let end = last.map_or_else(|| "has no rows".to_owned(), |last| format!("ends at step {last}"));
    format!(
        "it {end}, though the run is finished and has {steps} steps: rows are missing. Put the file back as the run wrote it, \
         or run the scenario again"
    )
}
