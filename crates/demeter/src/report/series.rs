//! The series: its columns, thinned.

use super::arrays::{f32s, f64s};
use super::plots::Group;
use super::thin::thinning;
use crate::output::COLUMNS;
use crate::results::{Column, Columns};
use serde_json::{Value, json};

/// Most columns that the page holds; a series has more where there are many walls.
const MOST_COLUMNS: usize = 400;

/// Energies that are there at a moment.
pub(super) const STORED: [&str; 7] = [
    "kinetic energy",
    "rotational energy",
    "gravitational energy",
    "elastic energy",
    "tangential energy",
    "rolling energy",
    "free wall energy",
];
/// What was put into the system since the start.
pub(super) const PUT_IN: [&str; 5] = [
    "wall work",
    "box boundary work",
    "custom work",
    "multi-contact input",
    "inserted energy",
];
/// What was taken out of it since the start.
pub(super) const TAKEN_OUT: [&str; 6] = [
    "viscous dissipation",
    "plastic dissipation",
    "friction dissipation",
    "rolling dissipation",
    "wall dissipation",
    "removed energy",
];
/// The share that the books do not explain.
pub(super) const RESIDUAL: &str = "energy residual";

/// The columns of numbers that the page holds: those of walls behind the others, as there may be very many walls.
pub(super) fn shown(series: &Columns) -> impl Iterator<Item = &Column> {
    let numbers = || series.all().iter().filter(|column| column.numbers().is_some());
    let of_wall = |column: &&Column| column.name().starts_with("wall ");
    let others = numbers().filter(move |column| !of_wall(column));
    others.chain(numbers().filter(of_wall)).take(MOST_COLUMNS)
}

/// What is left out or thinned, as sentences.
pub(super) fn told(series: &Columns) -> Vec<String> {
    let mut told = Vec::new();
    let numbers = series.all().iter().filter(|column| column.numbers().is_some()).count();
    if numbers > MOST_COLUMNS {
        told.push(format!(
            "The series has {numbers} columns; {MOST_COLUMNS} are here, those of walls behind the others; series.csv holds all."
        ));
    }
    let thinning = thinning(series, numbers.min(MOST_COLUMNS));
    if thinning.is_needed() {
        told.push(format!(
            "The series has {} rows. {} are here: each of {} equal pieces shows its least and its largest value, \
             so that no peak is lost; series.csv holds all.",
            series.rows(),
            thinning.rows(),
            thinning.rows() / 2
        ));
    }
    told
}

/// The series for the page.
pub(super) fn data(series: &Columns, groups: &[Group]) -> Value {
    let thinning = thinning(series, shown(series).count());
    let column = |column: &Column| {
        let values = thinning.of(column.numbers().unwrap_or_default());
        // a long run takes steps that 32 bits do not tell apart
        let fine = ["time", "step", "stage time"].contains(&column.name());
        json!({
            "name": column.name(),
            "unit": column.unit(),
            "meaning": meaning(column.name()),
            "values": if fine { f64s(values) } else { f32s(values) },
        })
    };
    let stages: Vec<Value> = (series.spans("stage").into_iter())
        .filter(|(name, _)| !name.is_empty())
        .map(|(name, rows)| json!({ "name": name, "row": thinning.place_of(rows.start) }))
        .collect();
    let groups: Vec<Value> = (groups.iter())
        .map(|group| json!({ "title": group.title, "place": group.place, "x": group.x, "y": group.y }))
        .collect();
    json!({
        "rows": thinning.rows(),
        "columns": shown(series).map(column).collect::<Vec<_>>(),
        "stages": stages,
        "groups": groups,
    })
}

/// What a column of every series means.
fn meaning(name: &str) -> &'static str {
    COLUMNS
        .iter()
        .find(|column| column.name == name)
        .map_or("", |column| column.meaning)
}

/// The number of a column in a row.
pub(super) fn at(series: &Columns, name: &str, row: usize) -> Option<f64> {
    series.find(name)?.numbers()?.get(row).copied()
}

/// The number of a column in the last row.
pub(super) fn last(series: &Columns, name: &str) -> Option<f64> {
    at(series, name, series.rows().checked_sub(1)?)
}
