//! Text dumps of LAMMPS and LIGGGHTS.

use super::super::format::Format;
use super::super::rows::Quantity;
use super::super::table::GrainTable;
use super::columns::{Column, chosen, rows};
use super::{WriteError, cell_of};
use std::io::Write;

const DEFAULT: [&str; 20] = [
    "id", "type", "x", "y", "z", "radius", "mass", "density", "vx", "vy", "vz", "wx", "wy", "wz", "fx", "fy", "fz",
    "tx", "ty", "tz",
];

pub(super) fn write(
    out: &mut impl Write,
    table: &GrainTable,
    format: Format,
    asked: Option<&[String]>,
    first: bool,
) -> Result<(), WriteError> {
    let columns = chosen(table, asked, &DEFAULT)?;
    if format == Format::LammpsDump {
        if first {
            writeln!(out, "ITEM: UNITS\nsi")?;
        }
        if let Some(time) = table.time {
            writeln!(out, "ITEM: TIME\n{time:?}")?;
        }
    }
    let cell = cell_of(table, format);
    let flags = cell
        .periodic
        .map(|periodic| if periodic { "pp" } else { "ff" })
        .join(" ");
    writeln!(out, "ITEM: TIMESTEP\n{}", table.step.unwrap_or(0))?;
    writeln!(out, "ITEM: NUMBER OF ATOMS\n{}", table.len())?;
    if cell.is_general() {
        writeln!(out, "ITEM: BOX BOUNDS abc origin {flags}")?;
        let (corner, edges) = cell.right_handed();
        for (axis, edge) in edges.into_iter().enumerate() {
            writeln!(out, "{:?} {:?} {:?} {:?}", edge.x, edge.y, edge.z, corner[axis])?;
        }
    } else if cell.is_tilted() {
        writeln!(out, "ITEM: BOX BOUNDS xy xz yz {flags}")?;
        let over = cell.overhang();
        for axis in 0..3 {
            let [low, high] = over.get(axis).copied().unwrap_or_default();
            let (low, high) = (cell.lower[axis] + low, cell.upper[axis] + high);
            writeln!(out, "{low:?} {high:?} {:?}", cell.tilt[axis])?;
        }
    } else {
        writeln!(out, "ITEM: BOX BOUNDS {flags}")?;
        for axis in 0..3 {
            writeln!(out, "{:?} {:?}", cell.lower[axis], cell.upper[axis])?;
        }
    }
    let names: Vec<String> = columns.iter().map(name).collect();
    writeln!(out, "ITEM: ATOMS {}", names.join(" "))?;
    // names of materials are words, which a dump cannot hold
    let columns: Vec<Column> = columns.into_iter().map(numbered).collect();
    rows(out, table, &columns, " ")
}

/// The name of a column in a dump.
fn name(column: &Column) -> String {
    let axis = |k: usize| ["x", "y", "z"][k];
    match column.quantity {
        Quantity::Type => "type".to_owned(),
        Quantity::AngularVelocity(k) => format!("omega{}", axis(k)),
        Quantity::Torque(k) => format!("tq{}", axis(k)),
        _ => column.name.clone(),
    }
}

fn numbered(mut column: Column) -> Column {
    if column.quantity == Quantity::Type {
        column.name = "type".to_owned();
    }
    column
}
