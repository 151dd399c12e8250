//! Profiles: one row per slice and row of the series.

use super::error::OutputError;
use super::rows::RowFile;
use super::series::{number, stage_name};
use crate::measure::{Measures, Slice};
use std::path::Path;

/// Columns of a profile.
const COLUMNS: [&str; 14] = [
    "step",
    "time [s]",
    "stage",
    "stage time [s]",
    "slice",
    "place [m]",
    "grains",
    "mass [kg]",
    "packing fraction",
    "velocity x [m/s]",
    "velocity y [m/s]",
    "velocity z [m/s]",
    "fluctuation [m/s]",
    "share",
];

/// Writes a profile: at every moment one row per slice, numbered from 0.
#[derive(Debug)]
pub struct ProfileWriter {
    file: RowFile,
    stages: Vec<String>,
}

impl ProfileWriter {
    /// Starts a profile with its header; `stages` are the names of the stages, by index.
    pub fn create(path: &Path, stages: Vec<String>) -> Result<Self, OutputError> {
        let file = RowFile::create(path, &COLUMNS.map(str::to_owned))?;
        Ok(Self { file, stages })
    }

    /// Goes on after a step, as [`super::SeriesWriter::resume`] does.
    pub fn resume(path: &Path, stages: Vec<String>, step: u64) -> Result<Self, OutputError> {
        let file = RowFile::resume(path, &COLUMNS.map(str::to_owned), step)?;
        Ok(Self { file, stages })
    }

    /// The file.
    pub(crate) fn rows(&self) -> &RowFile {
        &self.file
    }

    /// Writes all slices of a moment; they are in the file when this returns.
    pub fn write(&mut self, moment: &Measures, slices: &[Slice]) -> Result<(), OutputError> {
        let row = |(k, slice): (usize, &Slice)| {
            vec![
                moment.step.to_string(),
                number(moment.time),
                stage_name(&self.stages, moment.stage),
                number(moment.stage_time),
                k.to_string(),
                number(slice.place),
                slice.grains.to_string(),
                number(slice.mass),
                number(slice.packing_fraction),
                number(slice.velocity.x),
                number(slice.velocity.y),
                number(slice.velocity.z),
                number(slice.fluctuation),
                number(slice.share),
            ]
        };
        let rows: Vec<Vec<String>> = slices.iter().enumerate().map(row).collect();
        self.file.add(&rows)
    }
}
