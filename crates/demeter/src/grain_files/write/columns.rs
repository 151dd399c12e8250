//! The columns that a table can be written in, and CSV.

use super::super::columns::{COLUMNS, units_of};
use super::super::rows::{Quantity, WHOLE};
use super::super::table::{GrainTable, TypeOfGrain};
use super::WriteError;
use std::fmt;
use std::io::Write;

/// A column that is written.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Column {
    /// Its name, of ours or of an extra.
    pub name: String,
    pub quantity: Quantity,
}

/// A value that is written.
pub(super) enum Value<'t> {
    Whole(i64),
    Number(f64),
    Word(&'t str),
}

impl fmt::Display for Value<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Whole(value) => write!(f, "{value}"),
            // the shortest digits that read back to the same bits
            Self::Number(value) => write!(f, "{value:?}"),
            Self::Word(word) => f.write_str(word),
        }
    }
}

/// Names of all columns that a table can be written in.
pub fn column_names(table: &GrainTable) -> Vec<String> {
    let ours = COLUMNS.iter().filter(|(_, quantity)| is_told(table, *quantity));
    let names = ours.map(|(name, _)| (*name).to_owned());
    names
        .chain(table.extras.iter().map(|extra| extra.name.clone()))
        .collect()
}

fn is_told(table: &GrainTable, quantity: Quantity) -> bool {
    match quantity {
        Quantity::Density | Quantity::Mass => table.densities.is_some(),
        Quantity::Velocity(_) => table.velocities.is_some(),
        Quantity::AngularVelocity(_) => table.angular_velocities.is_some(),
        Quantity::Force(_) => table.forces.is_some(),
        Quantity::Torque(_) => table.torques.is_some(),
        Quantity::Extra(k) | Quantity::Tag(k) | Quantity::Image(k) => k < table.extras.len(),
        _ => true,
    }
}

/// The columns that were asked for, or those of `default` that the table tells, and its extras.
pub(super) fn chosen(
    table: &GrainTable,
    asked: Option<&[String]>,
    default: &[&str],
) -> Result<Vec<Column>, WriteError> {
    let find = |name: &str| {
        let ours = COLUMNS
            .iter()
            .find(|(known, _)| *known == name)
            .map(|(_, quantity)| *quantity);
        let extra = || {
            table
                .extras
                .iter()
                .position(|extra| extra.name == name)
                .map(Quantity::Extra)
        };
        let quantity = ours.or_else(extra).filter(|quantity| is_told(table, *quantity));
        quantity.map(|quantity| Column {
            name: name.to_owned(),
            quantity,
        })
    };
    let Some(asked) = asked else {
        let extras = table.extras.iter().map(|extra| extra.name.as_str());
        return Ok(default.iter().copied().chain(extras).filter_map(find).collect());
    };
    let unknown = |name: &String| WriteError::UnknownColumn {
        name: name.clone(),
        known: column_names(table),
    };
    let mut columns: Vec<Column> = Vec::with_capacity(asked.len());
    for name in asked {
        let column = find(name).ok_or_else(|| unknown(name))?;
        if columns.contains(&column) {
            return Err(WriteError::TwiceColumn { name: name.clone() });
        }
        columns.push(column);
    }
    Ok(columns)
}

/// The value of a grain in a column.
pub(super) fn value<'t>(table: &'t GrainTable, numbers: &[u32], column: &Column, grain: usize) -> Value<'t> {
    let part = |values: &Option<Vec<glam::DVec3>>, axis: usize| {
        Value::Number(values.as_ref().map_or(0.0, |values| values[grain][axis]))
    };
    match column.quantity {
        Quantity::Id => Value::Whole(table.id(grain).into()),
        Quantity::Type if column.name == "material" => match table.types.as_ref().map(|types| types[grain]) {
            Some(TypeOfGrain::Name(index)) => Value::Word(&table.type_names[index as usize]),
            _ => Value::Whole(numbers[grain].into()),
        },
        Quantity::Type => Value::Whole(numbers[grain].into()),
        Quantity::Position(axis) | Quantity::ScaledPosition(axis) => Value::Number(table.positions[grain][axis]),
        Quantity::Size { is_radius } => Value::Number(table.diameters[grain] * if is_radius { 0.5 } else { 1.0 }),
        Quantity::Density => Value::Number(table.densities.as_ref().map_or(0.0, |values| values[grain])),
        Quantity::Mass => Value::Number(table.mass(grain).unwrap_or(0.0)),
        Quantity::Velocity(axis) => part(&table.velocities, axis),
        Quantity::AngularVelocity(axis) => part(&table.angular_velocities, axis),
        Quantity::Force(axis) => part(&table.forces, axis),
        Quantity::Torque(axis) => part(&table.torques, axis),
        Quantity::Extra(k) | Quantity::Tag(k) | Quantity::Image(k) => {
            let (extra, value) = (&table.extras[k], table.extras[k].values[grain]);
            let whole = value as i64;
            match WHOLE.contains(&extra.name.as_str()) && whole as f64 == value {
                true => Value::Whole(whole),
                false => Value::Number(value),
            }
        }
        Quantity::Label | Quantity::Skipped => Value::Whole(0),
    }
}

/// Writes CSV, or the same between other separators, with names and units.
pub(super) fn write(
    out: &mut impl Write,
    table: &GrainTable,
    asked: Option<&[String]>,
    separator: &str,
) -> Result<(), WriteError> {
    let mut default = vec!["x", "y", "z", "diameter"];
    if table.ids.is_some() {
        default.insert(0, "id");
    }
    if table.types.is_some() {
        default.push("material");
    }
    let rest = [
        "density", "vx", "vy", "vz", "wx", "wy", "wz", "fx", "fy", "fz", "tx", "ty", "tz",
    ];
    default.extend(rest);
    let columns = chosen(table, asked, &default)?;
    let title = |column: &Column| {
        let unit = match column.quantity {
            Quantity::Extra(k) => table.extras[k].unit.as_str(),
            quantity => units_of(quantity).first().map_or("", |(name, _)| name),
        };
        let name = &column.name;
        if unit.is_empty() {
            name.clone()
        } else {
            format!("{name} [{unit}]")
        }
    };
    writeln!(out, "{}", columns.iter().map(title).collect::<Vec<_>>().join(separator))?;
    rows(out, table, &columns, separator)
}

/// Writes one line per grain.
pub(super) fn rows(
    out: &mut impl Write,
    table: &GrainTable,
    columns: &[Column],
    separator: &str,
) -> Result<(), WriteError> {
    let numbers = table.type_numbers();
    for grain in 0..table.len() {
        for (k, column) in columns.iter().enumerate() {
            if k > 0 {
                out.write_all(separator.as_bytes())?;
            }
            write!(out, "{}", value(table, &numbers, column, grain))?;
        }
        out.write_all(b"\n")?;
    }
    Ok(())
}
