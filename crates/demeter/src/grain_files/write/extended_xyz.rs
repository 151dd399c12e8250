//! Extended XYZ, with the names of properties that OVITO knows.

use super::super::rows::Quantity;
use super::super::table::{GrainTable, TypeOfGrain};
use super::WriteError;
use super::columns::{Column, chosen, rows};
use std::collections::BTreeSet;
use std::io::Write;

const DEFAULT: [&str; 19] = [
    "material", "x", "y", "z", "id", "radius", "density", "vx", "vy", "vz", "wx", "wy", "wz", "fx", "fy", "fz", "tx",
    "ty", "tz",
];

pub(super) fn write(out: &mut impl Write, table: &GrainTable, asked: Option<&[String]>) -> Result<(), WriteError> {
    let mut columns = chosen(table, asked, &DEFAULT)?;
    for column in &mut columns {
        // a word in this format may not hold a blank; numbers are told as such
        if column.quantity == Quantity::Type && !named(table) {
            column.name = "type".to_owned();
        }
    }
    writeln!(out, "{}", table.len())?;
    if let Some(cell) = table.cell {
        let edges = cell.edges().map(|e| format!("{:?} {:?} {:?}", e.x, e.y, e.z)).join(" ");
        let origin = cell.lower;
        let flags = cell.periodic.map(|periodic| if periodic { "T" } else { "F" }).join(" ");
        write!(
            out,
            "Lattice=\"{edges}\" Origin=\"{:?} {:?} {:?}\" pbc=\"{flags}\" ",
            origin.x, origin.y, origin.z
        )?;
    }
    write!(out, "Properties={}", properties(table, &columns))?;
    if let Some(time) = table.time {
        write!(out, " Time={time:?}")?;
    }
    if let Some(step) = table.step {
        write!(out, " Timestep={step}")?;
    }
    writeln!(out)?;
    let words = words(&table.type_names);
    if words == table.type_names {
        return rows(out, table, &columns, " ");
    }
    let renamed = GrainTable {
        type_names: words,
        ..table.clone()
    };
    rows(out, &renamed, &columns, " ")
}

/// Whether some grain has a material with a name.
fn named(table: &GrainTable) -> bool {
    let is_name = |kind: &TypeOfGrain| matches!(kind, TypeOfGrain::Name(_));
    table.types.iter().flatten().any(is_name)
}

/// Names of materials without blanks, which this format cannot hold in a word; different ones stay different.
pub(in super::super) fn words(names: &[String]) -> Vec<String> {
    let has_blanks = |name: &str| name.contains(char::is_whitespace);
    let mut taken: BTreeSet<String> = names.iter().filter(|name| !has_blanks(name)).cloned().collect();
    let mut word = |name: &String| {
        if !has_blanks(name) {
            return name.clone();
        }
        let joined = name.replace(char::is_whitespace, "_");
        let mut word = joined.clone();
        let mut number = 2;
        while !taken.insert(word.clone()) {
            word = format!("{joined}_{number}");
            number += 1;
        }
        word
    };
    names.iter().map(&mut word).collect()
}

/// `NAME:KIND:COUNT:...` of the columns; three components that follow each other are one property.
fn properties(table: &GrainTable, columns: &[Column]) -> String {
    let mut parts: Vec<String> = Vec::new();
    let mut k = 0;
    while let Some(column) = columns.get(k) {
        let (name, kind, count) = property(columns, k);
        let name = name.map_or_else(|| column.name.clone(), str::to_owned);
        let kind = if column.quantity == Quantity::Type && named(table) {
            "S"
        } else {
            kind
        };
        parts.push(format!("{name}:{kind}:{count}"));
        k += count;
    }
    parts.join(":")
}

/// How the components of a vector are told apart, and its name.
type Vector = (fn(usize) -> Quantity, &'static str);

/// Name, kind and number of components of the property that begins at a column.
fn property(columns: &[Column], k: usize) -> (Option<&'static str>, &'static str, usize) {
    let triple = |of: fn(usize) -> Quantity| (0..3).all(|a| columns.get(k + a).is_some_and(|c| c.quantity == of(a)));
    let vectors: [Vector; 5] = [
        (Quantity::Position, "pos"),
        (Quantity::Velocity, "velo"),
        (Quantity::AngularVelocity, "angular_velocity"),
        (Quantity::Force, "force"),
        (Quantity::Torque, "torque"),
    ];
    if let Some((_, name)) = vectors.iter().find(|(of, _)| triple(*of)) {
        return (Some(name), "R", 3);
    }
    let turned = ["orientation_x", "orientation_y", "orientation_z", "orientation_w"];
    let is_turned = |(a, name): (usize, &&str)| columns.get(k + a).is_some_and(|c| c.name == *name);
    if turned.iter().enumerate().all(is_turned) {
        return (Some("orientation"), "R", 4);
    }
    match columns[k].quantity {
        Quantity::Id => (None, "I", 1),
        Quantity::Type => (
            Some(if columns[k].name == "material" {
                "species"
            } else {
                "type"
            }),
            "I",
            1,
        ),
        _ => (None, "R", 1),
    }
}
