//! The cycles of a run, from the files in its folder.

use super::cycles::{Phase, Position, StrokeRow, average};
use super::error::CompareError;
use super::forces::Forces;
use super::strokes::Strokes;
use crate::output::RunFolder;
use crate::results::ResultsError;
use crate::results::rows::{Row, Table};
use std::collections::BTreeSet;
use std::path::Path;

/// Largest series that is read [bytes].
const MAX_SIZE: u64 = 8 << 30;
/// Most names of stages that a message lists.
const MAX_NAMES: usize = 20;
/// Share of a stroke by which a position may go back: rounding.
const ROUNDING: f64 = 1e-9;

/// How the cycles of a run are read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// Name of the stage that loads, without the numbers of repeats.
    pub load: String,
    /// Name of the stage that unloads; none when loading alone is looked at.
    pub unload: Option<String>,
    /// Number of cycles left out at the beginning.
    pub discard: usize,
    /// Column of the force, with or without its unit; a `-` before it turns its sign round.
    pub force: String,
    /// Other columns that are averaged; a mean of which one value is not a number (a mean over no contact) is none, either.
    pub also: Vec<String>,
    /// Name of the force distribution; the only one when absent.
    pub distribution: Option<String>,
}

impl Default for Reading {
    fn default() -> Self {
        Self {
            load: "squeeze".to_string(),
            unload: Some("release".to_string()),
            discard: 0,
            force: "wall top force z".to_string(),
            also: Vec::new(),
            distribution: None,
        }
    }
}

impl Reading {
    /// The column of the force without its sign, and the sign.
    pub fn force_column(&self) -> (&str, f64) {
        match self.force.strip_prefix('-') {
            Some(column) => (column.trim(), -1.0),
            None => (self.force.trim(), 1.0),
        }
    }

    /// Column of the displacement of the wall whose force is looked at: `wall top displacement z`.
    pub fn displacement_column(&self) -> Option<String> {
        let (force, _) = self.force_column();
        let column = force.split(" [").next().unwrap_or(force);
        let (wall, axis) = column.strip_prefix("wall ")?.rsplit_once(" force ")?;
        Some(format!("wall {wall} displacement {axis}"))
    }

    /// What a stage does.
    fn phase(&self, stage: &str) -> Option<Phase> {
        let unloads = |unload: &String| is_repeat(stage, unload);
        if is_repeat(stage, &self.load) {
            Some(Phase::Loading)
        } else {
            (self.unload.as_ref().is_some_and(unloads)).then_some(Phase::Unloading)
        }
    }
}

/// Whether a stage has this name, or this name and the number of a repeat: `squeeze`, `squeeze 2`, `squeeze 2.1`.
pub fn is_repeat(stage: &str, name: &str) -> bool {
    stage == name || base(stage) == name
}

/// A name without the number of a repeat.
fn base(stage: &str) -> &str {
    let number = |text: &str| {
        let mut parts = text.split('.');
        parts.all(|part| !part.is_empty() && part.bytes().all(|b| b.is_ascii_digit()))
    };
    match stage.rsplit_once(' ') {
        Some((name, last)) if number(last) => name,
        _ => stage,
    }
}

/// Whether the series of a run tells a strain.
pub fn tells_strain(folder: &Path) -> Result<bool, CompareError> {
    let series = RunFolder::find(folder)?.series();
    Ok(Table::open(&series, MAX_SIZE, true)?.column("strain").is_some())
}

/// Reads the cycles of a run and averages them. Without a position it is the strain, or the stage time where there is no
/// strain.
pub fn read_run(folder: &Path, reading: &Reading, position: Option<Position>) -> Result<Strokes, CompareError> {
    let series = RunFolder::find(folder)?.series();
    let table = Table::open(&series, MAX_SIZE, true)?;
    let position = position.unwrap_or(match table.column("strain") {
        Some(_) => Position::Strain,
        None => Position::StageTime,
    });
    let reader = CycleReader {
        columns: Columns::of(&table, reading, position)?,
        reading,
        position,
    };
    let also = reader.columns.also.iter().map(|k| table.header()[*k].clone()).collect();
    let mut cycles = reader.cycles(table)?;
    let found = cycles.len();
    if found <= reading.discard {
        return Err(CompareError::NoCycles {
            path: series,
            found,
            discarded: reading.discard,
        });
    }
    cycles.drain(..reading.discard);
    if position == Position::Compression {
        compressions(&mut cycles, &series)?;
    }
    let kept = cycles.len();
    let [mut loading, mut unloading] = [Vec::new(), Vec::new()];
    for cycle in cycles {
        loading.push(stroke(cycle.loading, Phase::Loading, position, &series)?);
        if let Some(part) = cycle.unloading {
            unloading.push(stroke(part, Phase::Unloading, position, &series)?);
        }
    }
    let steps: BTreeSet<u64> = (loading.iter().chain(&unloading).flatten())
        .map(|row| row.step)
        .collect();
    let forces = Forces::read(folder, reading.distribution.as_deref(), &steps)?;
    Ok(Strokes {
        name: folder.display().to_string(),
        position,
        loading: average(&loading, forces.as_ref())?,
        unloading: average(&unloading, forces.as_ref())?,
        bins: forces.map(|f| f.bins),
        also,
        cycles: Some((kept, reading.discard)),
    })
}

/// Columns that are read.
struct Columns {
    step: usize,
    time: usize,
    stage: usize,
    stage_time: usize,
    strain: Option<usize>,
    displacement: Option<usize>,
    force: usize,
    also: Vec<usize>,
}

impl Columns {
    fn of(table: &Table, reading: &Reading, position: Position) -> Result<Self, CompareError> {
        let displacement = match (position, reading.displacement_column()) {
            (Position::Compression, None) => {
                return Err(CompareError::NoPosition {
                    path: table.path().to_owned(),
                    position: position.name(),
                    reason: format!(
                        "it is the way of the wall whose force is compared, and `{}` is not the force of a wall; name a \
                         column as `wall top force z`, or give the reference a column `strain`",
                        reading.force
                    ),
                });
            }
            (Position::Compression, Some(column)) => Some(table.required(&column)?),
            _ => None,
        };
        let strain = table.column("strain");
        if position == Position::Strain && strain.is_none() {
            return Err(CompareError::NoPosition {
                path: table.path().to_owned(),
                position: position.name(),
                reason:
                    "it has no column `strain`, by which the reference is told. Tell `output.strain` in the scenario"
                        .to_string(),
            });
        }
        Ok(Self {
            step: table.required("step")?,
            time: table.required("time")?,
            stage: table.required("stage")?,
            stage_time: table.required("stage time")?,
            strain,
            displacement,
            force: table.required(reading.force_column().0)?,
            also: reading
                .also
                .iter()
                .map(|c| table.required(c))
                .collect::<Result<_, _>>()?,
        })
    }
}

/// A row of the series that belongs to a cycle, or stands where one begins.
#[derive(Clone, Debug)]
struct CycleRow {
    time: f64,
    strain: Option<f64>,
    row: StrokeRow,
}

/// Rows of one stage of a cycle.
#[derive(Debug)]
struct Part {
    stage: String,
    rows: Vec<CycleRow>,
}

#[derive(Debug)]
struct Cycle {
    loading: Part,
    unloading: Option<Part>,
}

struct CycleReader<'r> {
    columns: Columns,
    reading: &'r Reading,
    position: Position,
}

/// What is remembered of the row before.
struct Before {
    stage: String,
    stage_time: f64,
    time: f64,
    /// What cannot be read matters only where a stroke begins with it.
    row: Result<CycleRow, CompareError>,
}

impl CycleReader<'_> {
    fn cycles(&self, mut table: Table) -> Result<Vec<Cycle>, CompareError> {
        let path = table.path().to_owned();
        let mut cycles: Vec<Cycle> = Vec::new();
        let mut names: Vec<String> = Vec::new();
        let mut before: Option<Before> = None;
        while let Some(line) = table.next()? {
            let stage = line.text(self.columns.stage).to_string();
            let (time, stage_time) = (line.number(self.columns.time)?, line.number(self.columns.stage_time)?);
            let row = self.row(line, time, stage_time);
            let goes_on = (before.as_ref()).is_some_and(|b| b.stage == stage && b.stage_time <= stage_time);
            let name = base(&stage);
            if !goes_on && names.len() < MAX_NAMES && !names.iter().any(|n| n == name) {
                names.push(name.to_string());
            }
            if let Some(phase) = self.reading.phase(&stage) {
                let row = row?;
                if goes_on {
                    if let Some(part) = open_part(&mut cycles, phase) {
                        part.rows.push(row.clone());
                    }
                } else {
                    let start = before.filter(|b| is_start(b.time, time, stage_time));
                    let start = start.map(|b| b.row).transpose()?.map(|start| self.at_start(start));
                    let rows = start.into_iter().chain([row.clone()]).collect();
                    let part = Part {
                        stage: stage.clone(),
                        rows,
                    };
                    begin(&mut cycles, phase, part, &path)?;
                }
                before = Some(Before {
                    stage,
                    stage_time,
                    time,
                    row: Ok(row),
                });
            } else {
                before = Some(Before {
                    stage,
                    stage_time,
                    time,
                    row,
                });
            }
        }
        self.check_stages(&path, &names, &cycles)?;
        Ok(cycles)
    }

    fn row(&self, line: Row<'_>, time: f64, stage_time: f64) -> Result<CycleRow, CompareError> {
        let columns = &self.columns;
        let strain = match self.position {
            Position::StageTime => None,
            _ => columns.strain.map(|k| line.number(k)).transpose()?,
        };
        let displacement = columns.displacement.map(|k| line.number(k)).transpose()?;
        let sign = self.reading.force_column().1;
        let mut values = vec![sign * line.number(columns.force)?];
        for column in &columns.also {
            values.push(line.number_or_nan(*column)?);
        }
        Ok(CycleRow {
            time,
            strain,
            row: StrokeRow {
                step: line.count(columns.step)?,
                position: match self.position {
                    Position::Strain => strain.unwrap_or(f64::NAN),
                    Position::Compression => displacement.unwrap_or(f64::NAN),
                    Position::StageTime => stage_time,
                },
                values,
            },
        })
    }

    /// The last row of the stage before, as the first of this one.
    fn at_start(&self, mut start: CycleRow) -> CycleRow {
        if self.position == Position::StageTime {
            start.row.position = 0.0;
        }
        start
    }

    /// Whether both stages that were told are there.
    fn check_stages(&self, path: &Path, names: &[String], cycles: &[Cycle]) -> Result<(), CompareError> {
        let missing = |stage: &str, phase| CompareError::NoStage {
            path: path.to_owned(),
            stage: stage.to_string(),
            phase,
            known: names.iter().map(|n| format!("`{n}`")).collect(),
        };
        if cycles.is_empty() {
            return Err(missing(&self.reading.load, Phase::Loading.name()));
        }
        match &self.reading.unload {
            Some(unload) if cycles.iter().all(|c| c.unloading.is_none()) => {
                Err(missing(unload, Phase::Unloading.name()))
            }
            _ => Ok(()),
        }
    }
}

/// Whether the row before a stage was written at the moment when the stage began.
fn is_start(before: f64, time: f64, stage_time: f64) -> bool {
    (time - stage_time - before).abs() <= ROUNDING * time.abs()
}

/// The part of the latest cycle that goes on.
fn open_part(cycles: &mut [Cycle], phase: Phase) -> Option<&mut Part> {
    let cycle = cycles.last_mut()?;
    match phase {
        Phase::Loading => Some(&mut cycle.loading),
        Phase::Unloading => cycle.unloading.as_mut(),
    }
}

/// Begins a part: loading begins a cycle. What unloads before the first loading belongs to none.
fn begin(cycles: &mut Vec<Cycle>, phase: Phase, part: Part, path: &Path) -> Result<(), CompareError> {
    match (phase, cycles.last_mut()) {
        (Phase::Loading, _) => cycles.push(Cycle {
            loading: part,
            unloading: None,
        }),
        (Phase::Unloading, None) => {}
        (Phase::Unloading, Some(cycle)) => {
            if let Some(first) = &cycle.unloading {
                return Err(CompareError::from(ResultsError::Table {
                    path: path.to_owned(),
                    problem: format!(
                        "the stages `{}` and `{}` both unload after `{}`; a cycle has one stage of each",
                        first.stage, part.stage, cycle.loading.stage
                    ),
                }));
            }
            cycle.unloading = Some(part);
        }
    }
    Ok(())
}

/// Turns displacements into compressions: from where the strain is 0, or from the start of each loading.
fn compressions(cycles: &mut [Cycle], path: &Path) -> Result<(), CompareError> {
    let length = length(cycles, path)?;
    for cycle in cycles {
        let start = cycle.loading.rows.first().map_or(0.0, |row| row.row.position);
        let parts = [Some(&mut cycle.loading), cycle.unloading.as_mut()];
        for row in parts.into_iter().flatten().flat_map(|part| &mut part.rows) {
            row.row.position = match (row.strain, length) {
                (Some(strain), Some(length)) => strain * length,
                _ => (row.row.position - start).abs(),
            };
        }
    }
    Ok(())
}

/// Length by which the way of the wall is divided to give the strain [m]; none where the series tells no strain.
fn length(cycles: &[Cycle], path: &Path) -> Result<Option<f64>, CompareError> {
    let rows = || cycles.iter().flat_map(|cycle| &cycle.loading.rows);
    let told = || rows().filter_map(|row| Some((row.strain?, row.row.position)));
    let by_strain = |a: &(f64, f64), b: &(f64, f64)| a.0.total_cmp(&b.0);
    let (Some(low), Some(high)) = (told().min_by(by_strain), told().max_by(by_strain)) else {
        return Ok(None);
    };
    let length = ((high.1 - low.1) / (high.0 - low.0)).abs();
    if length.is_finite() && length > 0.0 {
        return Ok(Some(length));
    }
    Err(CompareError::NoPosition {
        path: path.to_owned(),
        position: Position::Compression.name(),
        reason: "the wall whose force is compared does not move along this axis while the strain changes".to_string(),
    })
}

/// The rows of a stage as a stroke, ascending by position; rows that do not advance are left out.
fn stroke(part: Part, phase: Phase, position: Position, path: &Path) -> Result<Vec<StrokeRow>, CompareError> {
    let falls = phase == Phase::Unloading && position != Position::StageTime;
    let sign = if falls { -1.0 } else { 1.0 };
    let along = |row: &CycleRow| sign * row.row.position;
    let (low, high) = part
        .rows
        .iter()
        .map(along)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| (a.min(x), b.max(x)));
    let slack = ROUNDING * (high - low);
    let mut rows: Vec<StrokeRow> = Vec::with_capacity(part.rows.len());
    for row in part.rows {
        let before = rows.last().map(|before| before.position);
        let advance = before.map_or(f64::INFINITY, |before| sign * (row.row.position - before));
        if let (Some(before), true) = (before, advance < -slack) {
            return Err(CompareError::TurnsBack {
                path: path.to_owned(),
                stage: part.stage,
                position: position.name(),
                before,
                after: row.row.position,
                time: row.time,
            });
        }
        if advance > slack {
            rows.push(row.row);
        }
    }
    if rows.len() < 2 {
        return Err(CompareError::ShortStroke {
            path: path.to_owned(),
            stage: part.stage,
            position: position.name(),
            rows: rows.len(),
        });
    }
    if falls {
        rows.reverse();
    }
    Ok(rows)
}
