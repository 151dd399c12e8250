//! Distributions of contact forces: two rows per row of the series.

use super::error::OutputError;
use super::rows::RowFile;
use super::series::{number, stage_name};
use crate::measure::{ForceDistribution, ForceHistogram, Measures};
use std::fmt::Display;
use std::path::Path;

/// Columns in front of those of the bins.
pub(crate) const COLUMNS: [&str; 9] = [
    "step",
    "time [s]",
    "stage",
    "stage time [s]",
    "strain",
    "grains",
    "between",
    "contacts",
    "sum [N]",
];

/// Title of the column behind those of the bins.
pub(crate) const ABOVE: &str = "above";

/// The two kinds of contacts, in the column `between`.
pub(super) const BETWEEN: [&str; 2] = ["grains", "walls"];

/// Writes a distribution: at every moment a row of the contacts between grains, and one of those with walls.
///
/// The columns are `step`, `time [s]`, `stage`, `stage time [s]`, `strain` (empty without a gauge), `grains` (their
/// number), `between` (`grains` or `walls`), `contacts` (those that act), `sum [N]` (of their normal forces), one column
/// per bin, titled by its lower edge as `0.001 [N]`, with the number of contacts in it, and `above`, with the number of those
/// behind the last bin.
#[derive(Debug)]
pub struct DistributionWriter {
    file: RowFile,
    bins: usize,
    stages: Vec<String>,
}

impl DistributionWriter {
    /// Starts a distribution with its header; `stages` are the names of the stages, by index.
    pub fn create(path: &Path, bins: &ForceDistribution, stages: Vec<String>) -> Result<Self, OutputError> {
        let file = RowFile::create(path, &header(bins))?;
        Ok(Self::of(file, bins, stages))
    }

    /// Goes on after a step, as [`super::SeriesWriter::resume`] does.
    pub fn resume(path: &Path, bins: &ForceDistribution, stages: Vec<String>, step: u64) -> Result<Self, OutputError> {
        let file = RowFile::resume(path, &header(bins), step)?;
        Ok(Self::of(file, bins, stages))
    }

    fn of(file: RowFile, bins: &ForceDistribution, stages: Vec<String>) -> Self {
        let bins = bins.edges().len() - 1;
        Self { file, bins, stages }
    }

    /// The file.
    pub(crate) fn rows(&self) -> &RowFile {
        &self.file
    }

    /// Writes both rows of a moment; they are in the file when this returns.
    pub fn write(&mut self, moment: &Measures, counted: &[ForceHistogram; 2]) -> Result<(), OutputError> {
        if let Some(other) = counted.iter().find(|h| h.counts.len() != self.bins) {
            return Err(OutputError::RowDoesNotFit {
                path: self.file.path().to_owned(),
                what: "bins",
                expected: self.bins,
                found: other.counts.len(),
            });
        }
        let row = |k: usize| {
            let histogram = &counted[k];
            let mut cells = vec![
                moment.step.to_string(),
                number(moment.time),
                stage_name(&self.stages, moment.stage),
                number(moment.stage_time),
                moment.strain.map_or_else(String::new, number),
                moment.grains.to_string(),
                BETWEEN[k].to_owned(),
                histogram.contacts.to_string(),
                number(histogram.sum),
            ];
            cells.extend(histogram.counts.iter().map(u64::to_string));
            cells.push(histogram.above.to_string());
            cells
        };
        let rows = [row(0), row(1)];
        self.file.add(&rows)
    }
}

fn header(bins: &ForceDistribution) -> Vec<String> {
    let edges = bins.edges();
    let mut titles: Vec<String> = COLUMNS.iter().map(ToString::to_string).collect();
    titles.extend(edges[..edges.len() - 1].iter().map(|edge| bin_title(edge, "N")));
    titles.push(ABOVE.to_owned());
    titles
}

/// Title of the column of a bin: its lower edge.
pub(super) fn bin_title(edge: impl Display, unit: &str) -> String {
    format!("{edge} [{unit}]")
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn bins() -> ForceDistribution {
        ForceDistribution::new(0.0, 1e-3, 0.5e-3).unwrap()
    }

    fn stages() -> Vec<String> {
        vec!["squeeze, slowly".to_owned()]
    }

    fn moment(step: u64) -> (Measures, [ForceHistogram; 2]) {
        let row = Measures {
            step,
            time: step as f64 / 3.0,
            grains: 5,
            strain: (step > 1).then_some(0.125),
            ..Measures::default()
        };
        (row, [bins().count([1e-4, 2e-4, 0.25]), bins().count([6e-4])])
    }

    #[test]
    fn a_moment_is_two_rows() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("forces.csv");
        let mut writer = DistributionWriter::create(&path, &bins(), stages()).unwrap();
        for step in [1, 2] {
            let (row, counted) = moment(step);
            writer.write(&row, &counted).unwrap();
        }
        let text = fs::read_to_string(&path).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(
            lines[0],
            "step,time [s],stage,stage time [s],strain,grains,between,contacts,sum [N],0 [N],0.0005 [N],above"
        );
        let sum = 1e-4 + 2e-4 + 0.25;
        assert_eq!(
            lines[1],
            format!("1,0.3333333333333333,\"squeeze, slowly\",0.0,,5,grains,3,{sum:?},2,0,1")
        );
        assert_eq!(
            lines[4],
            "2,0.6666666666666666,\"squeeze, slowly\",0.0,0.125,5,walls,1,0.0006,0,1,0"
        );
        let other = ForceDistribution::new(0.0, 1.0, 1.0).unwrap();
        let text = writer
            .write(&moment(3).0, &[other.count([]), other.count([])])
            .unwrap_err()
            .to_string();
        assert!(text.contains("has 1 bins, its header has 2"), "{text}");
    }

    #[test]
    fn a_resumed_distribution_is_the_same_file() {
        let place = tempfile::tempdir().unwrap();
        let (path, other) = (place.path().join("a.csv"), place.path().join("b.csv"));
        let mut straight = DistributionWriter::create(&path, &bins(), stages()).unwrap();
        let add = |writer: &mut DistributionWriter, step: u64| {
            let (row, counted) = moment(step);
            writer.write(&row, &counted).unwrap();
        };
        (0..6).for_each(|step| add(&mut straight, step));
        let whole = fs::read(&path).unwrap();
        for length in 0..=whole.len() {
            // a checkpoint follows both rows of its step
            let rows = whole[..length]
                .iter()
                .filter(|&&b| b == b'\n')
                .count()
                .saturating_sub(1);
            let steps = rows as u64 / 2;
            fs::write(&other, &whole[..length]).unwrap();
            if steps == 0 {
                // no moment is whole, so the run has no checkpoint; a header is all that can be kept
                continue;
            }
            let mut resumed = DistributionWriter::resume(&other, &bins(), stages(), steps - 1).unwrap();
            (steps..6).for_each(|step| add(&mut resumed, step));
            assert!(fs::read(&other).unwrap() == whole, "cut at {length}");
        }
        let finer = ForceDistribution::new(0.0, 1e-3, 0.25e-3).unwrap();
        let error = DistributionWriter::resume(&path, &finer, stages(), 3).unwrap_err();
        assert!(matches!(error, OutputError::OtherColumns { .. }), "{error}");
    }
}
