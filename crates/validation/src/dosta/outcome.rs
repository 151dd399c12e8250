//! What the benchmark asks of a case, and how fast and how true the run was.

use super::{Case, DostaError, Kind};
use crate::folder::told;
use demeter::results::Columns;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// What came out of a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Name of the case.
    pub case: &'static str,
    /// Titles of the columns of the benchmark.
    pub titles: Vec<&'static str>,
    /// Its rows.
    pub rows: Vec<Vec<f64>>,
    /// Grains at the end.
    pub grains: f64,
    /// Steps.
    pub steps: f64,
    /// Seconds of computing.
    pub wall_time: f64,
    /// Grains times steps per second.
    pub particle_steps_per_second: f64,
    /// Threads.
    pub threads: f64,
    /// Largest residual of the energy books in any row of the series.
    pub residual: f64,
}

/// Columns of the benchmark, and those of the series that they are.
fn columns(kind: Kind) -> &'static [(&'static str, &'static str)] {
    match kind {
        Kind::Penetration => &[
            ("time [s]", "time [s]"),
            ("z [m]", "ball z [m]"),
            ("velocity z [m/s]", "ball velocity z [m/s]"),
        ],
        Kind::Drum => &[
            ("time [s]", "time [s]"),
            ("m1 in zone 1", "zone-1 m1 grains"),
            ("m2 in zone 1", "zone-1 m2 grains"),
            ("m1 in zone 2", "zone-2 m1 grains"),
            ("m2 in zone 2", "zone-2 m2 grains"),
        ],
        Kind::Silo(_) => &[
            ("time [s]", "time [s]"),
            ("grains", "left grains"),
            ("mass rate [kg/s]", "orifice mass rate [kg/s]"),
        ],
    }
}

/// Stage of a silo that begins when it is opened.
const OPEN: &str = "open";

impl Outcome {
    /// Reads the run of a case.
    pub fn read(case: &Case, folder: &Path) -> Result<Self, DostaError> {
        let summary = folder.join("summary.json");
        let number = |key: &str| {
            let missing = || reading(folder, format!("its summary does not tell `{key}`"));
            let told = match key.split_once('.') {
                Some((outer, inner)) => told(&summary, outer).and_then(|value| value.get(inner)?.as_f64()),
                None => told(&summary, key).and_then(|value| value.as_f64()),
            };
            told.ok_or_else(missing)
        };
        let (titles, rows) = rows(case, folder)?;
        Ok(Self {
            case: case.name,
            titles,
            rows,
            grains: number("grains")?,
            steps: number("steps")?,
            wall_time: number("wall_clock_time")?,
            particle_steps_per_second: number("particle_steps_per_second")?,
            threads: number("threads")?,
            residual: number("energies.max_residual")?,
        })
    }

    /// What the benchmark compares, in words.
    pub fn findings(&self, kind: Kind) -> String {
        let column = |k: usize| self.rows.iter().map(move |row| (row[0], row[k]));
        let last = self.rows.last();
        let time = last.map_or(f64::NAN, |row| row[0]);
        match kind {
            Kind::Penetration => {
                let lowest = column(1).fold((f64::NAN, f64::INFINITY), |low, at| if at.1 < low.1 { at } else { low });
                let highest_after = column(1)
                    .filter(|at| at.0 >= lowest.0)
                    .map(|at| at.1)
                    .fold(lowest.1, f64::max);
                format!(
                    "lowest z {:.6} m at {:.4} s, highest after it {:.6} m, z {:.6} m at {time:.4} s",
                    lowest.1,
                    lowest.0,
                    highest_after,
                    last.map_or(f64::NAN, |row| row[1])
                )
            }
            Kind::Drum => {
                let counts: Vec<String> = (1..5)
                    .map(|k| format!("{} {}", self.titles[k], last.map_or(f64::NAN, |row| row[k])))
                    .collect();
                format!("at {time:.3} s: {}", counts.join(", "))
            }
            Kind::Silo(_) => format!(
                "{} grains left {time:.3} s after opening; mean mass rate of the rows before {:.4} kg/s",
                last.map_or(f64::NAN, |row| row[1]),
                mean(column(2).filter(|at| at.0 > 0.0).map(|at| at.1))
            ),
        }
    }
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), x| (sum + x, count + 1.0));
    sum / count
}

fn reading(folder: &Path, problem: String) -> DostaError {
    DostaError::Reading {
        folder: folder.to_owned(),
        problem,
    }
}

type Table = (Vec<&'static str>, Vec<Vec<f64>>);

/// The rows that the benchmark asks for. A silo counts the time from when it is opened.
fn rows(case: &Case, folder: &Path) -> Result<Table, DostaError> {
    let series = Columns::series_of(folder)?;
    let wanted = columns(case.kind);
    let columns: Vec<&[f64]> = wanted
        .iter()
        .map(|(_, title)| series.numbers(title))
        .collect::<Result<_, _>>()?;
    let stage = series.words("stage")?;
    let first = match case.kind {
        // the row before is the state in which it is opened
        Kind::Silo(_) => stage
            .iter()
            .position(|name| *name == OPEN)
            .map_or(stage.len(), |open| open.saturating_sub(1)),
        Kind::Penetration | Kind::Drum => 0,
    };
    let start = match case.kind {
        Kind::Silo(_) => columns[0].get(first).copied().unwrap_or(0.0),
        Kind::Penetration | Kind::Drum => 0.0,
    };
    let row = |k: usize| {
        let mut row: Vec<f64> = columns.iter().map(|column| column[k]).collect();
        row[0] -= start;
        row
    };
    let titles = wanted.iter().map(|(title, _)| *title).collect();
    Ok((titles, (first..stage.len()).map(row).collect()))
}

/// Writes the columns of the benchmark as CSV, and a line in words; answers with the line and the file.
pub fn write_outcome(outcome: &Outcome, case: &Case, out: &Path) -> Result<(String, PathBuf), DostaError> {
    let path = out.join(format!("{}.csv", case.name));
    let mut text = outcome.titles.join(",");
    text.push('\n');
    for row in &outcome.rows {
        let cells: Vec<String> = row.iter().map(|x| format!("{x}")).collect();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{}", cells.join(","));
    }
    fs::write(&path, text).map_err(DostaError::io("write", &path))?;
    let line = format!(
        "{}: {}. {} grains at the end, {} steps, {:.1} s of computing on {} threads, {:.3e} particle-steps/s, energy residual {:.1e}",
        case.name,
        outcome.findings(case.kind),
        outcome.grains,
        outcome.steps,
        outcome.wall_time,
        outcome.threads,
        outcome.particle_steps_per_second,
        outcome.residual
    );
    let words = out.join(format!("{}.txt", case.name));
    fs::write(&words, format!("{line}\n")).map_err(DostaError::io("write", &words))?;
    Ok((line, path))
}
