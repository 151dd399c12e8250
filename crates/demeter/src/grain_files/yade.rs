//! YADE's text packings: `yade.export.text` and `textExt` write them, `yade.ymport.text` and `textExt` read them. A line
//! `#format NAME` tells the columns; materials and ids count from 0 there.

use super::error::{FileProblem, Located};
use super::lines::Lines;
use super::numbers::{not_allowed, shown};
use super::read::{Context, Notes};
use super::rows::{Column, MOST_COLUMNS, Quantity, Rows};
use super::table::GrainTable;
use super::units::FileUnits;

/// The formats of YADE and their columns; those that count from 0 there are shifted.
const FORMATS: [(&str, &[&str]); 4] = [
    ("x_y_z_r", &["x", "y", "z", "r"]),
    ("x_y_z_r_matId", &["x", "y", "z", "r", "matId"]),
    ("id_x_y_z_r_matId", &["id", "x", "y", "z", "r", "matId"]),
    ("x_y_z_r_attrs", &["x", "y", "z", "r"]),
];

/// Whether a text is a packing of YADE.
pub(super) fn looks_like(text: &str) -> bool {
    text.starts_with("#format ")
}

/// Reads a packing.
pub(super) fn read(lines: &mut Lines, context: &Context, notes: &mut Notes) -> Result<GrainTable, Located> {
    let units = context.options.units.unwrap_or(FileUnits::SI);
    let mut names: Vec<String> = FORMATS[0].1.iter().map(|name| (*name).to_owned()).collect();
    let mut attributes = false;
    while let Some((at, line)) = lines.peek()? {
        let line = line.trim();
        if !line.is_empty() && !line.starts_with('#') {
            break;
        }
        let mut words = line.split_whitespace();
        let (first, second) = (words.next(), words.next());
        if first == Some("#format") {
            let told = second.unwrap_or_default();
            let format = FORMATS.iter().find(|(name, _)| *name == told).ok_or_else(|| {
                let what = format!("the format `{}` of YADE", shown(told));
                let remedy = "write `x_y_z_r`, `x_y_z_r_matId`, `id_x_y_z_r_matId` or `x_y_z_r_attrs`";
                FileProblem::NotRead { what, remedy }.at(at, None)
            })?;
            names = format.1.iter().map(|name| (*name).to_owned()).collect();
            attributes = format.0 == "x_y_z_r_attrs";
        } else if attributes && line.trim_start_matches('#').trim_start().starts_with("x y z r ") {
            let told = line.trim_start_matches('#').split_whitespace();
            names = told.take(MOST_COLUMNS).map(str::to_owned).collect();
        }
        lines.next()?;
    }
    let mut extras: Vec<(String, String)> = Vec::new();
    if attributes && names.len() == 4 {
        unnamed_attributes(lines, &mut names)?;
    }
    let columns: Vec<Column> = names.iter().map(|name| column(name, &units, &mut extras)).collect();
    notes.add_extras(&extras);
    read_rows(lines, &columns, &extras, context)
}

/// Names the columns behind the radius that the file does not name.
fn unnamed_attributes(lines: &mut Lines, names: &mut Vec<String>) -> Result<(), Located> {
    if let Some((_, row)) = lines.peek()? {
        let count = row.split_whitespace().take(MOST_COLUMNS).count();
        names.extend((1..=count.saturating_sub(4)).map(|k| format!("attribute_{k}")));
    }
    Ok(())
}

fn column(name: &str, units: &FileUnits, extras: &mut Vec<(String, String)>) -> Column {
    let (quantity, factor) = match name {
        "x" => (Quantity::Position(0), units.length),
        "y" => (Quantity::Position(1), units.length),
        "z" => (Quantity::Position(2), units.length),
        "r" => (Quantity::Size { is_radius: true }, units.length),
        "id" => (Quantity::Id, 1.0),
        "matId" => (Quantity::Type, 1.0),
        _ => {
            extras.push((name.to_owned(), String::new()));
            (Quantity::Extra(extras.len() - 1), 1.0)
        }
    };
    Column::new(name, quantity, factor)
}

fn read_rows(
    lines: &mut Lines,
    columns: &[Column],
    extras: &[(String, String)],
    context: &Context,
) -> Result<GrainTable, Located> {
    let mut rows = Rows::new(columns, extras);
    let from_zero: Vec<usize> = (0..columns.len())
        .filter(|k| matches!(columns[*k].quantity, Quantity::Id | Quantity::Type))
        .collect();
    while let Some((line, row)) = lines.next()? {
        let row = row.trim();
        if row.is_empty() || row.starts_with('#') {
            continue;
        }
        if from_zero.is_empty() {
            rows.read(line, row.split_whitespace())?;
            continue;
        }
        let mut words: Vec<String> = row.split_whitespace().take(MOST_COLUMNS).map(str::to_owned).collect();
        for k in &from_zero {
            let Some(word) = words.get_mut(*k) else { continue };
            let number: u32 = word.parse().ok().filter(|n| *n < u32::MAX).ok_or_else(|| {
                let problem = not_allowed(word, "allowed are whole numbers from 0 to 4294967294");
                problem.at(line, Some(&columns[*k].name))
            })?;
            *word = (number + 1).to_string();
        }
        rows.read(line, words.iter().map(String::as_str))?;
    }
    rows.finish(context.options.diameter, None)
}

#[cfg(test)]
#[path = "yade_tests.rs"]
mod tests;
