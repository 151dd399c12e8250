//! Plots of the series.

use super::reader::did_you_mean;
use super::run::labels;
use super::{Diagnostics, PlotSpec, Scenario};
use crate::output::{OutputError, Plot, RunFolder, Series, SeriesLabels};
use std::path::Path;

/// Most stages that get a line of their own in a plot of one column.
const MAX_LINES: usize = 8;

/// Tells the plots that ask for a column which the series does not have.
pub(super) fn check(scenario: &Scenario, faults: &mut Diagnostics) {
    let header = labels(scenario).header();
    for (k, plot) in scenario.output.plots.iter().enumerate() {
        for column in plot.y.iter().chain([&plot.x]) {
            if find(&header, column).is_none() {
                let help = did_you_mean(column, header.iter().map(|title| name_of(title)));
                faults.push(
                    &format!("output.plots[{k}]"),
                    format!("the series has no column `{column}`"),
                    help.or_else(|| {
                        Some("columns are, for example, `time`, `elastic energy`, `wall NAME force z`".into())
                    }),
                );
            }
        }
    }
}

/// Writes the plots: energies over time, and those that the scenario asks for.
pub(super) fn write(folder: &RunFolder, labels: &SeriesLabels, asked: &[PlotSpec]) -> Result<(), OutputError> {
    let energies = PlotSpec {
        name: "energies".to_string(),
        x: "time".to_string(),
        y: [
            "kinetic energy",
            "elastic energy",
            "viscous dissipation",
            "friction dissipation",
            "wall work",
        ]
        .map(String::from)
        .to_vec(),
    };
    let table = Table::read(&folder.series(), labels)?;
    for spec in std::iter::once(&energies).chain(asked) {
        table.plot(spec).write_svg(&folder.plot(&spec.name))?;
    }
    Ok(())
}

/// A title without its unit.
fn name_of(title: &str) -> &str {
    title.split(" [").next().unwrap_or(title)
}

/// Index of a column, told by its title with or without the unit.
fn find(header: &[String], column: &str) -> Option<usize> {
    header
        .iter()
        .position(|title| title == column || name_of(title) == column)
}

/// The series as numbers.
struct Table {
    header: Vec<String>,
    stages: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Table {
    fn read(path: &Path, labels: &SeriesLabels) -> Result<Self, OutputError> {
        let header = labels.header();
        let stage = find(&header, "stage");
        let mut table = Self {
            header,
            stages: Vec::new(),
            rows: Vec::new(),
        };
        let mut reader = csv::Reader::from_path(path).map_err(|e| OutputError::encode(path, &e))?;
        for record in reader.records() {
            let record = record.map_err(|e| OutputError::encode(path, &e))?;
            table
                .stages
                .push(stage.and_then(|k| record.get(k)).unwrap_or_default().to_string());
            table
                .rows
                .push(record.iter().map(|cell| cell.parse().unwrap_or(f64::NAN)).collect());
        }
        Ok(table)
    }

    fn plot(&self, spec: &PlotSpec) -> Plot {
        let mut plot = Plot {
            title: spec.name.clone(),
            x_label: self.label(&spec.x),
            ..Plot::default()
        };
        let Some(x) = find(&self.header, &spec.x) else {
            return plot;
        };
        let columns: Vec<usize> = spec.y.iter().filter_map(|name| find(&self.header, name)).collect();
        plot.y_label = match columns.as_slice() {
            [only] => self.header[*only].clone(),
            _ => self.common_unit(&columns),
        };
        for &y in &columns {
            let points = |rows: &[Vec<f64>]| rows.iter().map(|row| (row[x], row[y])).collect::<Vec<_>>();
            let stages = self.stage_ranges();
            if columns.len() == 1 && stages.len() <= MAX_LINES && spec.x != "time" {
                for range in stages {
                    let name = self.stages[range.start].clone();
                    plot.series.push(Series::line(name, points(&self.rows[range])));
                }
            } else {
                plot.series
                    .push(Series::line(name_of(&self.header[y]), points(&self.rows)));
            }
        }
        plot
    }

    fn label(&self, column: &str) -> String {
        find(&self.header, column).map_or_else(|| column.to_string(), |k| self.header[k].clone())
    }

    /// The unit that all columns share, in brackets, or nothing.
    fn common_unit(&self, columns: &[usize]) -> String {
        let unit = |k: &usize| self.header[*k].split_once(" [").map(|(_, unit)| format!("[{unit}"));
        let first = columns.first().and_then(unit);
        if columns.iter().all(|k| unit(k) == first) {
            first.unwrap_or_default()
        } else {
            String::new()
        }
    }

    /// Rows of every stage.
    fn stage_ranges(&self) -> Vec<std::ops::Range<usize>> {
        let mut ranges: Vec<std::ops::Range<usize>> = Vec::new();
        for k in 0..self.rows.len() {
            match ranges.last_mut() {
                Some(range) if self.stages[range.start] == self.stages[k] => range.end = k + 1,
                _ => ranges.push(k..k + 1),
            }
        }
        ranges
    }
}
