//! The series that a run left in its folder.

use std::path::{Path, PathBuf};

/// Why a series cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("the run in `{}` cannot be read: {problem}", folder.display())]
pub struct SeriesError {
    /// Folder of the run.
    pub folder: PathBuf,
    /// What is wrong.
    pub problem: String,
}

/// All rows of `series.csv`.
#[derive(Clone, Debug)]
pub struct SeriesTable {
    folder: PathBuf,
    header: csv::StringRecord,
    rows: Vec<csv::StringRecord>,
}

impl SeriesTable {
    /// Reads the series of a run.
    pub fn read(folder: &Path) -> Result<Self, SeriesError> {
        let fault = |e: csv::Error| SeriesError {
            folder: folder.to_owned(),
            problem: e.to_string(),
        };
        let mut reader = csv::Reader::from_path(folder.join("series.csv")).map_err(fault)?;
        Ok(Self {
            folder: folder.to_owned(),
            header: reader.headers().map_err(fault)?.clone(),
            rows: reader.records().collect::<Result<_, _>>().map_err(fault)?,
        })
    }

    /// A column as it is written.
    pub fn words(&self, title: &str) -> Result<Vec<&str>, SeriesError> {
        let missing = || SeriesError {
            folder: self.folder.clone(),
            problem: format!("its series has no column `{title}`"),
        };
        let place = self.header.iter().position(|name| name == title).ok_or_else(missing)?;
        Ok(self.rows.iter().map(|row| row.get(place).unwrap_or("")).collect())
    }

    /// A column of numbers; NaN where a cell holds none.
    pub fn column(&self, title: &str) -> Result<Vec<f64>, SeriesError> {
        let words = self.words(title)?;
        Ok(words.iter().map(|cell| cell.parse().unwrap_or(f64::NAN)).collect())
    }
}
