//! Plots of the series.

use super::reader::did_you_mean;
use super::run::labels;
use super::{Diagnostics, PlotSpec, Scenario};
use crate::output::{OutputError, Plot, RunFolder, Series};
use crate::results::{Column, Columns, ResultsError, column_name, position_of};
use std::io::ErrorKind;

/// Most stages that get a line of their own in a plot of one column.
const MAX_LINES: usize = 8;

/// Tells the plots that ask for a column which the series does not have.
pub(super) fn check(scenario: &Scenario, faults: &mut Diagnostics) {
    let header = labels(scenario).header();
    for (k, plot) in scenario.output.plots.iter().enumerate() {
        for column in plot.y.iter().chain([&plot.x]) {
            if let Err((message, help)) = column_of(&header, column) {
                faults.push(&format!("output.plots[{k}]"), message, help);
            }
        }
    }
}

/// Index of a column of the series, told by its name or title; or a message and help.
pub(super) fn column_of(header: &[String], column: &str) -> Result<usize, (String, Option<String>)> {
    position_of(header, column).ok_or_else(|| {
        let help = did_you_mean(column, header.iter().map(|title| column_name(title)));
        let examples = || "columns are, for example, `time`, `elastic energy`, `wall NAME force z`".to_string();
        let message = format!("the series has no column `{column}`");
        (message, help.or_else(|| Some(examples())))
    })
}

/// The plot that every run has.
pub(super) const ENERGIES: &str = "energies";

/// Writes the plots: energies over time, and those that the scenario asks for.
pub(super) fn write(folder: &RunFolder, asked: &[PlotSpec]) -> Result<(), OutputError> {
    let energies = PlotSpec {
        name: ENERGIES.to_string(),
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
    let path = folder.series();
    let table = Columns::read(&path).map_err(|error| match error {
        ResultsError::Io { path, source } if source.kind() != ErrorKind::NotFound => OutputError::Io {
            action: "read",
            path,
            source,
        },
        error => OutputError::RowsLost {
            problem: error.to_string(),
            path,
        },
    })?;
    for spec in std::iter::once(&energies).chain(asked) {
        plot(&table, spec).write_svg(&folder.plot(&spec.name))?;
    }
    Ok(())
}

fn plot(table: &Columns, spec: &PlotSpec) -> Plot {
    let mut plot = Plot {
        title: spec.name.clone(),
        x_label: table.find(&spec.x).map_or_else(|| spec.x.clone(), |x| x.title.clone()),
        ..Plot::default()
    };
    let Some(x) = table.find(&spec.x).and_then(Column::numbers) else {
        return plot;
    };
    let columns: Vec<&Column> = spec.y.iter().filter_map(|name| table.find(name)).collect();
    plot.y_label = match columns.as_slice() {
        [only] => only.title.clone(),
        _ => common_unit(&columns),
    };
    let stages = table.spans("stage");
    for column in &columns {
        let Some(y) = column.numbers() else { continue };
        let points = |rows: std::ops::Range<usize>| rows.map(|row| (x[row], y[row])).collect::<Vec<_>>();
        if columns.len() == 1 && stages.len() <= MAX_LINES && spec.x != "time" {
            for (name, rows) in &stages {
                plot.series.push(Series::line(name.as_str(), points(rows.clone())));
            }
        } else {
            plot.series.push(Series::line(column.name(), points(0..table.rows())));
        }
    }
    plot
}

/// The unit that all columns share, in brackets, or nothing.
fn common_unit(columns: &[&Column]) -> String {
    let unit = columns.first().map_or("", |column| column.unit());
    if unit.is_empty() || columns.iter().any(|column| column.unit() != unit) {
        return String::new();
    }
    format!("[{unit}]")
}
