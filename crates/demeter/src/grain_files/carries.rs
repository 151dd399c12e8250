//! What each format can carry, so that nothing is lost without a word.

use super::format::Format;
use super::table::{GrainTable, TypeOfGrain};
use super::write::words;

/// What is lost when a table is written in a format, and what was taken in place of what is missing; in words.
pub fn losses(table: &GrainTable, format: Format) -> Vec<String> {
    use Format::{Columns, ExtendedXyz, LammpsData, LammpsDump, LiggghtsData, LiggghtsDump, Yade};
    let data = matches!(format, LammpsData | LiggghtsData);
    let dump = matches!(format, LammpsDump | LiggghtsDump);
    let mut names: Vec<&str> = Vec::new();
    let mut left_out = |what: &'static str, is_lost: bool| {
        if is_lost {
            names.push(what);
        }
    };
    left_out("ids", format == Yade && table.ids.is_some());
    left_out("velocities", format == Yade && table.velocities.is_some());
    left_out(
        "angular velocities",
        format == Yade && table.angular_velocities.is_some(),
    );
    left_out("densities", format == Yade && table.densities.is_some());
    left_out("forces", (data || format == Yade) && table.forces.is_some());
    left_out("torques", (data || format == Yade) && table.torques.is_some());
    left_out(
        "time",
        !dump_with_time(format) && format != ExtendedXyz && table.time.is_some(),
    );
    left_out(
        "step",
        matches!(format, Yade | Columns | LiggghtsData) && table.step.is_some(),
    );
    left_out("box", matches!(format, Yade | Columns) && table.cell.is_some());
    let general = table.cell.is_some_and(|cell| cell.is_general());
    left_out(
        "box, whose edges are not along x and in the plane of x and y (the smallest one around all grains is written, with open sides)",
        matches!(format, LiggghtsData | LiggghtsDump) && general,
    );
    let periodic = table.cell.is_some_and(|cell| cell.periodic != [false; 3]);
    left_out(
        "periodic sides (`boundary` in the input script tells them)",
        data && periodic,
    );
    if data || format == Yade {
        names.extend(table.extras.iter().map(|extra| extra.name.as_str()));
    }
    let mut lost = Vec::new();
    if !names.is_empty() {
        lost.push(format!("left out, {format} does not carry it: {}", names.join(", ")));
    }
    if data || dump || format == Yade {
        lost.extend(named_types(table, format));
    }
    if format == ExtendedXyz {
        lost.extend(renamed_types(table));
    }
    lost.extend(taken(table, format));
    lost
}

fn dump_with_time(format: Format) -> bool {
    format == Format::LammpsDump
}

/// The numbers that names of materials got.
fn named_types(table: &GrainTable, format: Format) -> Option<String> {
    let types = table.types.as_ref()?;
    let named = types.iter().any(|kind| matches!(kind, TypeOfGrain::Name(_)));
    let base = table.largest_number();
    let from = if format == Format::Yade { 0 } else { 1 };
    let numbers = (base + from..).zip(&table.type_names);
    let list = some_of(numbers.map(|(number, name)| format!("{number} = {name}")));
    named.then(|| format!("names of materials: {format} has numbers, {list}"))
}

/// The names that lost their blanks.
fn renamed_types(table: &GrainTable) -> Option<String> {
    table.types.as_ref()?;
    let words = words(&table.type_names);
    let renamed = table.type_names.iter().zip(&words).filter(|(name, word)| name != word);
    let list = some_of(renamed.map(|(name, word)| format!("`{name}` becomes `{word}`")));
    (!list.is_empty()).then(|| {
        format!(
            "names of materials: {} has no blanks in them, {list}",
            Format::ExtendedXyz
        )
    })
}

/// The first of a list.
fn some_of(mut items: impl Iterator<Item = String>) -> String {
    const MOST: usize = 20;
    let list: Vec<String> = items.by_ref().take(MOST).collect();
    let more = if items.next().is_some() { ", ..." } else { "" };
    format!("{}{more}", list.join(", "))
}

/// What a format needs and the table does not tell.
fn taken(table: &GrainTable, format: Format) -> Option<String> {
    use Format::{LammpsData, LammpsDump, LiggghtsData, LiggghtsDump};
    let boxed = matches!(format, LammpsData | LiggghtsData | LammpsDump | LiggghtsDump);
    let taken = "box: none is told; the smallest one around all grains is written, with open sides";
    let general = "box: its edges are not along x and in the plane of x and y; written as `avec`, `bvec`, `cvec` or `abc origin`, which \
                   LAMMPS reads from 17 April 2024 on";
    match table.cell {
        None => boxed.then(|| taken.to_owned()),
        Some(cell) => (cell.is_general() && matches!(format, LammpsData | LammpsDump)).then(|| general.to_owned()),
    }
}
