//! Measured curves: a CSV file, or points told elsewhere.

use super::cycles::{Level, Mean, Phase, Position};
use super::error::CompareError;
use super::strokes::Strokes;
use crate::results::rows::Table;
use std::path::Path;

/// Largest measured curve that is read [bytes].
const MAX_SIZE: u64 = 16 << 20;

/// Columns of a measured curve.
pub const MEASURED_COLUMNS: &str = "`strain` or `compression [m]`; `loading force [N]`, `unloading force [N]` or both; \
    and, if it was measured, `loading coordination`, `unloading coordination`";

const FORCE: [&str; 2] = ["loading force [N]", "unloading force [N]"];
const COORDINATION: [&str; 2] = ["loading coordination", "unloading coordination"];

/// Reads a measured curve: one row per level, cells may be empty.
pub fn read_measured(path: &Path) -> Result<Strokes, CompareError> {
    let name = path.display().to_string();
    let mut table = Table::open(path, MAX_SIZE, false)?;
    let known = |title: &String| {
        let positions = [Position::Strain.title(), Position::Compression.title()];
        positions.contains(&title.as_str()) || FORCE.iter().chain(&COORDINATION).any(|t| t == title)
    };
    if let Some(other) = table.header().iter().find(|title| !known(title)) {
        let other: String = other.chars().take(60).collect();
        let problem = format!("unknown column `{other}`; a measured curve has the columns {MEASURED_COLUMNS}");
        return Err(CompareError::Measured { name, problem });
    }
    let header = table.header();
    if let Some((_, twice)) = header
        .iter()
        .enumerate()
        .find(|(k, title)| header[..*k].contains(title))
    {
        let problem = format!("the column `{twice}` is there twice; leave one of them out");
        return Err(CompareError::Measured { name, problem });
    }
    let find = |title: &str| header.iter().position(|t| t == title);
    let position = match (find(Position::Strain.title()), find(Position::Compression.title())) {
        (Some(column), None) => (Position::Strain, column),
        (None, Some(column)) => (Position::Compression, column),
        (both, _) => {
            let found = if both.is_some() { "both" } else { "neither" };
            let problem = format!("it must have one column of `strain` and `compression [m]`, it has {found}");
            return Err(CompareError::Measured { name, problem });
        }
    };
    let (force, coordination) = (FORCE.map(find), COORDINATION.map(find));
    let mut phases: [Vec<Level>; 2] = [Vec::new(), Vec::new()];
    while let Some(row) = table.next()? {
        let at = row.number(position.1)?;
        for (phase, levels) in phases.iter_mut().enumerate() {
            let cell = |column: Option<usize>| column.map_or(Ok(None), |k| row.maybe_number(k));
            let (force, coordination) = (cell(force[phase])?, cell(coordination[phase])?);
            if force.is_some() || coordination.is_some() {
                levels.push(measured_level(at, force, coordination));
            }
        }
    }
    let [loading, unloading] = phases;
    strokes(name, position.0, loading, unloading)
}

/// A measured curve of points `(position, force [N])`.
pub fn measured_points(
    name: &str,
    position: Position,
    loading: &[(f64, f64)],
    unloading: &[(f64, f64)],
) -> Result<Strokes, CompareError> {
    let levels = |points: &[(f64, f64)]| {
        let level = |&(at, force): &(f64, f64)| measured_level(at, Some(force), None);
        points.iter().map(level).collect()
    };
    strokes(name.to_string(), position, levels(loading), levels(unloading))
}

fn measured_level(position: f64, force: Option<f64>, coordination: Option<f64>) -> Level {
    Level {
        position,
        force: force.map(Mean::single),
        coordination,
        contacts: None,
        also: Vec::new(),
    }
}

fn strokes(
    name: String,
    position: Position,
    loading: Vec<Level>,
    unloading: Vec<Level>,
) -> Result<Strokes, CompareError> {
    let mut strokes = Strokes {
        name,
        position,
        loading,
        unloading,
        bins: None,
        also: Vec::new(),
        cycles: None,
    };
    let refuse = |problem: String, name: &str| CompareError::Measured {
        name: name.to_string(),
        problem,
    };
    for (phase, levels) in Phase::ALL
        .into_iter()
        .zip([&mut strokes.loading, &mut strokes.unloading])
    {
        levels.sort_by(|a, b| a.position.total_cmp(&b.position));
        if let Some(twice) = levels.windows(2).find(|w| w[0].position >= w[1].position) {
            let at = twice[0].position;
            let problem = format!(
                "two values of {} at a {} of {at}; average them first",
                phase.name(),
                position.name()
            );
            return Err(refuse(problem, &strokes.name));
        }
    }
    if strokes.loading.is_empty() && strokes.unloading.is_empty() {
        let problem = format!("it holds no values; a measured curve has the columns {MEASURED_COLUMNS}");
        return Err(refuse(problem, &strokes.name));
    }
    Ok(strokes)
}
