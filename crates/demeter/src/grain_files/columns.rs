//! Grains as text in columns (CSV, semicolons, tabs or spaces) named by a header line.
//!
//! ```text
//! # comment
//! id, x [mm], y [mm], z [mm], diameter [mm], material
//! 1, 0.5, 0.5, 0.25, 0.5, glass
//! ```

use super::error::{FileProblem, Located};
use super::lines::Lines;
use super::numbers::shown;
use super::read::{Context, Notes, ReadOptions};
use super::rows::{Column, MOST_COLUMNS, Quantity, Rows};
use super::table::{GrainTable, TAG};
use super::units::FileUnits;

/// Names of columns; the first of a quantity is the one that messages use.
pub(super) const COLUMNS: [(&str, Quantity); 22] = [
    ("id", Quantity::Id),
    ("x", Quantity::Position(0)),
    ("y", Quantity::Position(1)),
    ("z", Quantity::Position(2)),
    ("diameter", Quantity::Size { is_radius: false }),
    ("radius", Quantity::Size { is_radius: true }),
    ("material", Quantity::Type),
    ("type", Quantity::Type),
    ("density", Quantity::Density),
    ("mass", Quantity::Mass),
    ("vx", Quantity::Velocity(0)),
    ("vy", Quantity::Velocity(1)),
    ("vz", Quantity::Velocity(2)),
    ("wx", Quantity::AngularVelocity(0)),
    ("wy", Quantity::AngularVelocity(1)),
    ("wz", Quantity::AngularVelocity(2)),
    ("fx", Quantity::Force(0)),
    ("fy", Quantity::Force(1)),
    ("fz", Quantity::Force(2)),
    ("tx", Quantity::Torque(0)),
    ("ty", Quantity::Torque(1)),
    ("tz", Quantity::Torque(2)),
];

/// Columns of the frames of a run that are no quantity of a packing; `demeter convert` writes them.
const OF_FRAMES: [&str; 5] = [
    "coordination",
    "orientation_x",
    "orientation_y",
    "orientation_z",
    "orientation_w",
];

type Units = &'static [(&'static str, f64)];

const LENGTHS: Units = &[
    ("m", 1.0),
    ("cm", 1e-2),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("\u{b5}m", 1e-6),
    ("\u{3bc}m", 1e-6),
];
const MASSES: Units = &[("kg", 1.0), ("g", 1e-3), ("mg", 1e-6), ("ug", 1e-9)];
const VELOCITIES: Units = &[("m/s", 1.0), ("cm/s", 1e-2), ("mm/s", 1e-3)];
const ANGULAR_VELOCITIES: Units = &[("1/s", 1.0), ("rad/s", 1.0)];
const DENSITIES: Units = &[("kg/m^3", 1.0), ("kg/m3", 1.0), ("g/cm^3", 1e3), ("g/cm3", 1e3)];
const FORCES: Units = &[("N", 1.0), ("mN", 1e-3), ("uN", 1e-6), ("kN", 1e3)];
const TORQUES: Units = &[("N m", 1.0), ("Nm", 1.0), ("N*m", 1.0)];

/// Units of a quantity; the first is SI.
pub(super) fn units_of(quantity: Quantity) -> Units {
    match quantity {
        Quantity::Position(_) | Quantity::Size { .. } => LENGTHS,
        Quantity::Density => DENSITIES,
        Quantity::Mass => MASSES,
        Quantity::Velocity(_) => VELOCITIES,
        Quantity::AngularVelocity(_) => ANGULAR_VELOCITIES,
        Quantity::Force(_) => FORCES,
        Quantity::Torque(_) => TORQUES,
        _ => &[],
    }
}

/// What a number of a quantity is in SI.
fn factor_of(quantity: Quantity, units: &FileUnits) -> f64 {
    match quantity {
        Quantity::Position(_) | Quantity::Size { .. } => units.length,
        Quantity::Density => units.density(),
        Quantity::Mass => units.mass,
        Quantity::Velocity(_) => units.velocity(),
        Quantity::AngularVelocity(_) => units.rate(),
        Quantity::Force(_) => units.force(),
        Quantity::Torque(_) => units.torque(),
        _ => 1.0,
    }
}

/// What separates values.
#[derive(Clone, Copy)]
enum Separator {
    Character(char),
    Blanks,
}

impl Separator {
    fn of(header: &str) -> Self {
        match [',', ';', '\t'].into_iter().find(|c| header.contains(*c)) {
            Some(c) => Self::Character(c),
            None => Self::Blanks,
        }
    }

    fn split(self, line: &str) -> impl Iterator<Item = &str> + Clone {
        let (by_character, by_blanks) = match self {
            Self::Character(c) => (Some(line.split(c)), None),
            Self::Blanks => (None, Some(line.split_whitespace())),
        };
        let values = by_character
            .into_iter()
            .flatten()
            .chain(by_blanks.into_iter().flatten());
        values.map(|value| value.trim().trim_matches('"').trim())
    }
}

/// The next line that says something.
fn next<'l>(lines: &'l mut Lines) -> Result<Option<(usize, &'l str)>, Located> {
    loop {
        let Some((_, line)) = lines.peek()? else {
            return Ok(None);
        };
        let line = line.trim();
        if !line.is_empty() && !line.starts_with('#') {
            break;
        }
        lines.next()?;
    }
    Ok(lines.next()?.map(|(number, line)| (number, line.trim())))
}

/// The columns of a header, and names and units of those that are no known quantity.
struct Header {
    columns: Vec<Column>,
    extras: Vec<(String, String)>,
}

/// Reads a table of columns.
pub(super) fn read(lines: &mut Lines, context: &Context, notes: &mut Notes) -> Result<GrainTable, Located> {
    let Some((line, header)) = next(lines)? else {
        return Err(FileProblem::NoGrains.into());
    };
    let separator = Separator::of(header);
    let header = parse_header(header, separator, context).map_err(|problem| problem.at(line, None))?;
    notes.add_extras(&header.extras);
    let mut rows = Rows::new(&header.columns, &header.extras);
    while let Some((line, row)) = next(lines)? {
        rows.read(line, separator.split(row))?;
    }
    rows.finish(context.options.diameter, None)
}

fn parse_header(header: &str, separator: Separator, context: &Context) -> Result<Header, FileProblem> {
    // A unit belongs to the name before it, also where blanks separate.
    let header = header.replace(" [", "[").replace(" (", "(");
    let mut columns: Vec<Column> = Vec::new();
    let mut extras = Vec::new();
    for cell in separator.split(&header) {
        if columns.is_empty() && cell.parse::<f64>().is_ok() {
            return Err(FileProblem::NoHeader { found: shown(cell) });
        }
        let column = parse_column(cell, &context.options, &mut extras)?;
        if columns.len() == MOST_COLUMNS {
            let found = format!("{MOST_COLUMNS} columns and more");
            return Err(FileProblem::Expected {
                found,
                expected: "a header of fewer",
            });
        }
        add_column(&mut columns, column)?;
    }
    check_complete(&columns, context.options.diameter.is_some())?;
    let needs_units =
        |(cell, column): (&str, &Column)| !cell.contains(['[', '(']) && !units_of(column.quantity).is_empty();
    if context.options.units.is_some() && !separator.split(&header).zip(&columns).any(needs_units) {
        return Err(FileProblem::NoEffect {
            option: "units",
            why: "all columns of the file tell their units",
        });
    }
    Ok(Header { columns, extras })
}

/// Adds a column, unless another tells the same.
pub(super) fn add_column(columns: &mut Vec<Column>, column: Column) -> Result<(), FileProblem> {
    if let Some(other) = columns.iter().find(|c| c.quantity.is_same(column.quantity)) {
        return Err(FileProblem::TwiceColumn {
            name: shown(&column.name),
            other: shown(&other.name),
        });
    }
    columns.push(column);
    Ok(())
}

/// Checks that no quantity is told in part. Sizes may be missing where they are told otherwise.
pub(super) fn check_complete(columns: &[Column], sized: bool) -> Result<(), FileProblem> {
    let has = |quantity| columns.iter().any(|c: &Column| c.quantity.is_same(quantity));
    let group = |of: fn(usize) -> Quantity| (0..3).any(|k| has(of(k)));
    let moves = group(Quantity::Velocity);
    let turns = group(Quantity::AngularVelocity);
    let (pushed, twisted) = (group(Quantity::Force), group(Quantity::Torque));
    for (name, quantity) in COLUMNS {
        let needed = match quantity {
            Quantity::Position(_) => true,
            Quantity::Size { .. } => !sized,
            Quantity::Velocity(_) => moves,
            Quantity::AngularVelocity(_) => turns,
            Quantity::Force(_) => pushed,
            Quantity::Torque(_) => twisted,
            _ => false,
        };
        if needed && !has(quantity) {
            return Err(FileProblem::MissingColumn { name });
        }
    }
    Ok(())
}

/// A cell of the header: name, and maybe a unit in brackets.
fn parse_column(cell: &str, options: &ReadOptions, extras: &mut Vec<(String, String)>) -> Result<Column, FileProblem> {
    let (name, unit) = match cell.split_once(['[', '(']) {
        Some((name, rest)) => (name.trim(), Some(rest.trim_end_matches([']', ')']).trim())),
        None => (cell, None),
    };
    let name = name.to_lowercase();
    let Some((_, quantity)) = COLUMNS.iter().find(|(known, _)| *known == name) else {
        if name == TAG || (options.extra_columns && !name.is_empty()) {
            let told = name.replace(char::is_whitespace, "_");
            let quantity = Quantity::extra(&told, unit.unwrap_or_default(), options, extras);
            return Ok(Column::new(&name, quantity, 1.0));
        }
        if OF_FRAMES.contains(&name.as_str()) {
            return Ok(Column::new(&name, Quantity::Skipped, 1.0));
        }
        return Err(FileProblem::UnknownColumn {
            name: shown(&name),
            known: COLUMNS.map(|c| c.0).join(", "),
        });
    };
    let factor = match unit {
        None => options.units.map_or(1.0, |units| factor_of(*quantity, &units)),
        Some(unit) => {
            let units = units_of(*quantity);
            let found = units.iter().find(|(known, _)| *known == unit);
            found.map(|u| u.1).ok_or_else(|| FileProblem::UnknownUnit {
                unit: shown(unit),
                allowed: match units.is_empty() {
                    true => format!("none for `{name}`"),
                    false => units.iter().map(|u| u.0).collect::<Vec<_>>().join(", "),
                },
            })?
        }
    };
    Ok(Column {
        name,
        quantity: *quantity,
        factor,
    })
}

#[cfg(test)]
#[path = "columns_tests.rs"]
mod tests;
