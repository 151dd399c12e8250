//! The results of all runs in one table.

use super::error::SweepError;
use super::folder::{Status, SweepFolder};
use super::metric::Metric;
use super::picture::axis_column;
use super::value::{Value, unquoted, value_of};
use crate::checkpoint::{Durability, write_atomically};
use crate::results::{Columns, ResultsError, Run, column_name, position_of};
use crate::scenario::Scenario;
use std::path::Path;

/// Columns of the series that say where the last row stands, and nothing of what came out.
const PLACES: [&str; 4] = ["step", "time", "stage", "stage time"];

/// Numbers of `summary.json` that the series does not tell: where they stand there, and their titles here.
const OF_SUMMARY: [(&str, &str); 6] = [
    ("/steps", "steps"),
    ("/simulated_time", "simulated time [s]"),
    ("/time_step", "time step [s]"),
    ("/wall_clock_time", "computing time [s]"),
    ("/threads", "threads"),
    ("/energies/max_residual", "max energy residual"),
];

/// How a run is told to have ended whose outcome says that it is finished, and whose results do not.
const DAMAGED: &str = "damaged";

/// A cell of the table.
#[derive(Clone, Debug, PartialEq)]
pub enum ResultsCell {
    /// Nothing is known.
    Empty,
    /// A number.
    Number(f64),
    /// Words.
    Word(String),
}

impl ResultsCell {
    /// The number, if it is one.
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            _ => None,
        }
    }

    /// As in a CSV file: numbers read back to the same bits.
    pub fn text(&self) -> String {
        match self {
            Self::Empty => String::new(),
            Self::Number(number) if number.fract() == 0.0 && number.abs() < 1e15 => format!("{number:.0}"),
            Self::Number(number) => format!("{number:?}"),
            Self::Word(word) => word.clone(),
        }
    }
}

/// A table: a row for every run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Results {
    /// Titles with units.
    pub titles: Vec<String>,
    /// The cells, row by row.
    pub rows: Vec<Vec<ResultsCell>>,
    /// Which columns are varied.
    pub varied: std::ops::Range<usize>,
    /// Columns that were asked for.
    pub asked: Vec<usize>,
    /// What could not be read.
    pub problems: Vec<String>,
    /// Results that were asked for and of which finished runs have no value.
    pub missing: Vec<String>,
}

impl Results {
    /// Index of a column, told with or without its unit.
    pub fn find(&self, name: &str) -> Option<usize> {
        position_of(&self.titles, name)
    }

    /// Writes the table as CSV, whole or not at all.
    pub fn write(&self, path: &Path) -> Result<(), SweepError> {
        let other = |error: csv::Error| SweepError::io("write", path)(error.into());
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(&self.titles).map_err(other)?;
        for row in &self.rows {
            writer.write_record(row.iter().map(ResultsCell::text)).map_err(other)?;
        }
        let bytes = writer
            .into_inner()
            .map_err(|error| SweepError::io("write", path)(error.into_error()))?;
        write_atomically(path, &bytes, Durability::PowerCut).map_err(SweepError::io("write", path))
    }

    /// Sets a cell of the last row, in a column that is made where it is not there.
    fn set(&mut self, title: &str, cell: ResultsCell) -> usize {
        let at = match self.titles.iter().position(|known| known == title) {
            Some(at) => at,
            None => {
                self.titles.push(title.to_string());
                self.titles.len() - 1
            }
        };
        if let Some(row) = self.rows.last_mut() {
            if row.len() <= at {
                row.resize(at + 1, ResultsCell::Empty);
            }
            row[at] = cell;
        }
        at
    }
}

/// The results that all runs have left until now. Runs that are not finished tell their values and how far they are.
pub fn gather(folder: &SweepFolder, statuses: &[Status]) -> Result<Results, SweepError> {
    let metrics = metrics(&folder.wishes.results)?;
    let titles = varied_titles(folder);
    let mut results = Results {
        varied: 1..1 + titles.len(),
        titles: [
            &["run".to_string()],
            &titles[..],
            &["end".to_string(), "message".to_string()],
        ]
        .concat(),
        ..Results::default()
    };
    for (index, status) in statuses.iter().enumerate() {
        let run = &folder.plan.runs[index];
        results.rows.push(vec![ResultsCell::Word(run.name.clone())]);
        for (title, value) in titles.iter().zip(&run.values) {
            results.set(title, varied_cell(title, value));
        }
        results.set("end", ResultsCell::Word(status.name().to_string()));
        let message = match status {
            Status::Ended(outcome) => outcome.message.clone(),
            other => other.name().to_string(),
        };
        results.set("message", ResultsCell::Word(message));
        if status.is_finished()
            && let Err(error) = add_run(&mut results, folder, index, &metrics)
        {
            // the cells stay empty, and the row says why
            results.set("end", ResultsCell::Word(DAMAGED.to_string()));
            results.set("message", ResultsCell::Word(error.to_string()));
            results.problems.push(error.to_string());
        }
    }
    let columns = results.titles.len();
    for row in &mut results.rows {
        row.resize(columns, ResultsCell::Empty);
    }
    results.missing = missing(&results);
    Ok(results)
}

/// Tells of which results that were asked for runs have no value.
fn missing(results: &Results) -> Vec<String> {
    let is_nan = |cell: &ResultsCell| matches!(cell, ResultsCell::Number(value) if value.is_nan());
    let told = results.asked.iter().filter_map(|&at| {
        let count = results.rows.iter().filter(|row| is_nan(&row[at])).count();
        (count > 0).then(|| {
            format!(
                "{count} of {} runs have no value of `{}`: no row of their series lies there, or its cells are empty",
                results.rows.len(),
                results.titles[at]
            )
        })
    });
    told.collect()
}

/// Reads the results that are asked for, or tells all that is wrong with them.
pub fn metrics(told: &[String]) -> Result<Vec<Metric>, SweepError> {
    let (mut read, mut problems) = (Vec::new(), Vec::new());
    for told in told {
        match Metric::read(told) {
            Ok(metric) => read.push(metric),
            Err(problem) => problems.push(problem),
        }
    }
    if problems.is_empty() {
        Ok(read)
    } else {
        Err(SweepError::Told { problems })
    }
}

/// The number of the summary that a metric names: its place and title.
fn summary_column(metric: &Metric) -> Option<(&'static str, &'static str)> {
    let is_named = |title: &str| title == metric.column || column_name(title) == metric.column;
    OF_SUMMARY
        .into_iter()
        .find(|(_, title)| metric.is_last() && is_named(title))
}

/// The title that a metric has in the table, where it is known what the series will hold.
pub fn title_of(metric: &Metric, series: &[String]) -> Option<String> {
    match summary_column(metric) {
        Some((_, title)) => Some(title.to_string()),
        None => position_of(series, &metric.column).map(|at| metric.title(&series[at])),
    }
}

/// Tells results that no run of the sweep would have, and what cannot be drawn.
pub fn check_wishes(folder: &SweepFolder, scenario: &Scenario) -> Result<(), SweepError> {
    let titles = scenario.series_titles();
    let stages: Vec<&str> = scenario.stages.iter().map(|stage| stage.name.as_str()).collect();
    let ends = folder.plan.runs.iter().map(|run| run.estimate.simulated);
    let latest = ends.fold(0.0, f64::max);
    let metrics = metrics(&folder.wishes.results)?;
    let of_series = metrics.iter().filter(|metric| summary_column(metric).is_none());
    let problems: Vec<String> = of_series
        .filter_map(|metric| metric.problem(&titles, &stages, latest))
        .collect();
    if !problems.is_empty() {
        return Err(SweepError::Told { problems });
    }
    if folder.wishes.plots.is_empty() {
        return Ok(());
    }
    let none = vec![Status::Waiting; folder.plan.runs.len()];
    axis_column(folder, &gather(folder, &none)?).map(|_| ())
}

/// Adds what a finished run left to the last row.
fn add_run(results: &mut Results, sweep: &SweepFolder, index: usize, metrics: &[Metric]) -> Result<(), ResultsError> {
    let folder = sweep.run_folder(index);
    let run = Run::open(&folder)?;
    let damaged = |what: &str, problem: String| ResultsError::Table {
        path: folder.join(what),
        problem,
    };
    let missing = |what: &str| damaged(what, "it is not there, though the run is finished".to_string());
    let series = run.series()?.ok_or_else(|| missing("series.csv"))?;
    let summary = run.summary()?.ok_or_else(|| missing("summary.json"))?;
    if summary["finished"].as_bool() != Some(true) {
        let stopped_by = summary["stopped_by"].as_str().unwrap_or("nothing");
        let problem = format!(
            "the run was finished, and something ran it again, which was stopped by: {stopped_by}. Go on with it by \
             `demeter resume`"
        );
        return Err(damaged("summary.json", problem));
    }
    if let Some(problem) = run.shortfall(&series)? {
        return Err(damaged("series.csv", problem));
    }
    if !sweep.holds_what_was_left(index) {
        let problem = "this or `summary.json` is not what the run of this sweep left: something wrote it anew";
        return Err(damaged("series.csv", problem.to_string()));
    }
    let of_summary = |place: &str| {
        let number = summary.pointer(place).and_then(serde_json::Value::as_f64);
        number.map_or(ResultsCell::Empty, ResultsCell::Number)
    };
    for metric in metrics {
        let at = match summary_column(metric) {
            Some((place, title)) => results.set(title, of_summary(place)),
            None => {
                let (title, value) = metric.of(&series)?;
                results.set(&title, ResultsCell::Number(value))
            }
        };
        if !results.asked.contains(&at) {
            results.asked.push(at);
        }
    }
    for (place, title) in OF_SUMMARY {
        results.set(title, of_summary(place));
    }
    add_last_row(results, &series);
    Ok(())
}

fn add_last_row(results: &mut Results, series: &Columns) {
    for column in series.all().iter().filter(|column| !PLACES.contains(&column.name())) {
        if let Some(last) = column.numbers().and_then(<[f64]>::last) {
            results.set(&column.title, ResultsCell::Number(*last));
        }
    }
}

/// Titles of the varied keys, with the unit that all values of a key have.
fn varied_titles(folder: &SweepFolder) -> Vec<String> {
    let plan = &folder.plan;
    let title = |(k, column): (usize, &super::Column)| {
        let values = plan.runs.iter().map(|run| value_of(&run.values[k]));
        let mut units = values.map(|value| match value {
            Value::Number { unit, .. } => Some(unit),
            Value::Word(_) => None,
        });
        let first = units.next().flatten().unwrap_or_default();
        match !first.is_empty() && units.all(|unit| unit.as_ref() == Some(&first)) {
            true => format!("{} [{first}]", column.key),
            false => column.key.clone(),
        }
    };
    plan.columns.iter().enumerate().map(title).collect()
}

/// A value: a number where its unit is in the title or it has none, else as it was written.
fn varied_cell(title: &str, written: &str) -> ResultsCell {
    match value_of(written) {
        Value::Number { number, unit } if unit.is_empty() || title.ends_with(&format!(" [{unit}]")) => {
            ResultsCell::Number(number)
        }
        _ => ResultsCell::Word(unquoted(written)),
    }
}
