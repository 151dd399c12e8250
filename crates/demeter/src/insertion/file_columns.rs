//! Grains as text in columns (CSV, semicolons, tabs or spaces) named by a header line.
//!
//! ```text
//! # comment
//! id, x [mm], y [mm], z [mm], diameter [mm], material
//! 1, 0.5, 0.5, 0.25, 0.5, glass
//! ```

use super::grain_file::{
    FileProblem, GrainTable, Located, TypeOfGrain, check_ids, density, diameter, number, shown, whole,
};
use glam::DVec3;
use std::collections::BTreeMap;

/// Most names of materials that a file may use.
const MOST_NAMES: usize = 65_536;

/// What a column tells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quantity {
    Id,
    Position(usize),
    /// Diameter, or radius when doubled.
    Size {
        is_radius: bool,
    },
    Type,
    Density,
    Velocity(usize),
    AngularVelocity(usize),
}

/// Names of columns; the first of a quantity is the one that messages use.
const COLUMNS: [(&str, Quantity); 15] = [
    ("id", Quantity::Id),
    ("x", Quantity::Position(0)),
    ("y", Quantity::Position(1)),
    ("z", Quantity::Position(2)),
    ("diameter", Quantity::Size { is_radius: false }),
    ("radius", Quantity::Size { is_radius: true }),
    ("material", Quantity::Type),
    ("type", Quantity::Type),
    ("density", Quantity::Density),
    ("vx", Quantity::Velocity(0)),
    ("vy", Quantity::Velocity(1)),
    ("vz", Quantity::Velocity(2)),
    ("wx", Quantity::AngularVelocity(0)),
    ("wy", Quantity::AngularVelocity(1)),
    ("wz", Quantity::AngularVelocity(2)),
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
const VELOCITIES: Units = &[("m/s", 1.0), ("cm/s", 1e-2), ("mm/s", 1e-3)];
const ANGULAR_VELOCITIES: Units = &[("1/s", 1.0), ("rad/s", 1.0)];
const DENSITIES: Units = &[("kg/m^3", 1.0), ("kg/m3", 1.0), ("g/cm^3", 1e3), ("g/cm3", 1e3)];

impl Quantity {
    fn units(self) -> Units {
        match self {
            Self::Id | Self::Type => &[],
            Self::Position(_) | Self::Size { .. } => LENGTHS,
            Self::Density => DENSITIES,
            Self::Velocity(_) => VELOCITIES,
            Self::AngularVelocity(_) => ANGULAR_VELOCITIES,
        }
    }

    fn is_same(self, other: Self) -> bool {
        self == other || matches!((self, other), (Self::Size { .. }, Self::Size { .. }))
    }
}

#[derive(Debug)]
struct Column {
    name: String,
    quantity: Quantity,
    factor: f64,
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

    fn split(self, line: &str) -> impl Iterator<Item = &str> {
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

/// Reads a table of columns.
pub(super) fn parse(text: &str) -> Result<GrainTable, Located> {
    let mut lines = (text.lines().enumerate())
        .map(|(k, line)| (k + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let Some((line, header)) = lines.next() else {
        return Err(FileProblem::NoGrains.into());
    };
    let separator = Separator::of(header);
    let columns = parse_header(header, separator).map_err(|problem| problem.at(line, None))?;
    let mut reader = Reader::new(&columns);
    for (line, row) in lines {
        reader.read_row(line, row, separator)?;
    }
    reader.finish()
}

fn parse_header(header: &str, separator: Separator) -> Result<Vec<Column>, FileProblem> {
    // A unit belongs to the name before it, also where blanks separate.
    let header = header.replace(" [", "[").replace(" (", "(");
    let mut columns: Vec<Column> = Vec::new();
    for cell in separator.split(&header) {
        if columns.is_empty() && cell.parse::<f64>().is_ok() {
            return Err(FileProblem::NoHeader { found: shown(cell) });
        }
        let column = parse_column(cell)?;
        if let Some(other) = columns.iter().find(|c| c.quantity.is_same(column.quantity)) {
            return Err(FileProblem::TwiceColumn {
                name: column.name,
                other: other.name.clone(),
            });
        }
        // All names known and none twice: there are no more columns than quantities.
        columns.push(column);
    }
    let has = |quantity| columns.iter().any(|c: &Column| c.quantity.is_same(quantity));
    let group = |of: fn(usize) -> Quantity| (0..3).any(|k| has(of(k)));
    let moves = group(Quantity::Velocity);
    let turns = group(Quantity::AngularVelocity);
    for (name, quantity) in COLUMNS {
        let needed = match quantity {
            Quantity::Position(_) | Quantity::Size { .. } => true,
            Quantity::Velocity(_) => moves,
            Quantity::AngularVelocity(_) => turns,
            Quantity::Id | Quantity::Type | Quantity::Density => false,
        };
        if needed && !has(quantity) {
            return Err(FileProblem::MissingColumn { name });
        }
    }
    Ok(columns)
}

fn parse_column(cell: &str) -> Result<Column, FileProblem> {
    let (name, unit) = match cell.find(['[', '(']) {
        Some(at) => (&cell[..at], Some(cell[at + 1..].trim_end_matches([']', ')']).trim())),
        None => (cell, None),
    };
    let name = name.trim().to_ascii_lowercase();
    let Some((_, quantity)) = COLUMNS.iter().find(|(known, _)| *known == name) else {
        return Err(FileProblem::UnknownColumn {
            name: shown(&name),
            known: COLUMNS.map(|c| c.0).join(", "),
        });
    };
    let factor = match unit {
        None => 1.0,
        Some(unit) => {
            let units = quantity.units();
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

/// Collects rows.
struct Reader<'a> {
    columns: &'a [Column],
    table: GrainTable,
    lines: Vec<u32>,
    names: BTreeMap<String, u32>,
}

impl<'a> Reader<'a> {
    fn new(columns: &'a [Column]) -> Self {
        let has = |of: fn(&Quantity) -> bool| columns.iter().any(|c| of(&c.quantity));
        Self {
            columns,
            table: GrainTable {
                ids: has(|q| matches!(q, Quantity::Id)).then(Vec::new),
                types: has(|q| matches!(q, Quantity::Type)).then(Vec::new),
                densities: has(|q| matches!(q, Quantity::Density)).then(Vec::new),
                velocities: has(|q| matches!(q, Quantity::Velocity(_))).then(Vec::new),
                angular_velocities: has(|q| matches!(q, Quantity::AngularVelocity(_))).then(Vec::new),
                ..GrainTable::default()
            },
            lines: Vec::new(),
            names: BTreeMap::new(),
        }
    }

    fn read_row(&mut self, line: usize, row: &str, separator: Separator) -> Result<(), Located> {
        let found = separator.split(row).count();
        if found != self.columns.len() {
            let expected = self.columns.len().to_string();
            return Err(FileProblem::ValueCount { found, expected }.at(line, None));
        }
        if let Some(velocities) = &mut self.table.velocities {
            velocities.push(DVec3::ZERO);
        }
        if let Some(velocities) = &mut self.table.angular_velocities {
            velocities.push(DVec3::ZERO);
        }
        self.table.positions.push(DVec3::ZERO);
        let columns = self.columns;
        for (column, text) in columns.iter().zip(separator.split(row)) {
            self.read_value(column, text)
                .map_err(|problem| problem.at(line, Some(&column.name)))?;
        }
        self.lines.push(u32::try_from(line).unwrap_or(u32::MAX));
        Ok(())
    }

    fn read_value(&mut self, column: &Column, text: &str) -> Result<(), FileProblem> {
        let table = &mut self.table;
        let scaled = || number(text).map(|value| value * column.factor);
        let set = |values: Option<&mut Vec<DVec3>>, axis: usize, value: f64| {
            if let Some(last) = values.and_then(|v| v.last_mut()) {
                last[axis] = value;
            }
        };
        match column.quantity {
            Quantity::Id => push(&mut table.ids, whole(text)?),
            Quantity::Position(axis) => set(Some(&mut table.positions), axis, scaled()?),
            Quantity::Size { is_radius } => {
                let value = scaled()? * if is_radius { 2.0 } else { 1.0 };
                table.diameters.push(diameter(value, text)?);
            }
            Quantity::Density => push(&mut table.densities, density(scaled()?, text)?),
            Quantity::Velocity(axis) => set(table.velocities.as_mut(), axis, scaled()?),
            Quantity::AngularVelocity(axis) => set(table.angular_velocities.as_mut(), axis, scaled()?),
            Quantity::Type => {
                let kind = self.read_type(text)?;
                push(&mut self.table.types, kind);
            }
        }
        Ok(())
    }

    fn read_type(&mut self, text: &str) -> Result<TypeOfGrain, FileProblem> {
        if text.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '+') {
            return whole(text).map(TypeOfGrain::Number);
        }
        if let Some(index) = self.names.get(text) {
            return Ok(TypeOfGrain::Name(*index));
        }
        if text.is_empty() || self.table.type_names.len() >= MOST_NAMES {
            return Err(super::grain_file::not_allowed(
                text,
                "allowed are type numbers or at most 65536 names of materials",
            ));
        }
        let index = self.table.type_names.len() as u32;
        self.table.type_names.push(text.to_owned());
        self.names.insert(text.to_owned(), index);
        Ok(TypeOfGrain::Name(index))
    }

    fn finish(self) -> Result<GrainTable, Located> {
        if self.table.positions.is_empty() {
            return Err(FileProblem::NoGrains.into());
        }
        if let Some(ids) = &self.table.ids {
            check_ids(ids, |grain| self.lines[grain] as usize)?;
        }
        Ok(self.table)
    }
}

fn push<T>(values: &mut Option<Vec<T>>, value: T) {
    if let Some(values) = values {
        values.push(value);
    }
}

#[cfg(test)]
#[path = "file_columns_tests.rs"]
mod tests;
