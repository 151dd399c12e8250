//! The series: its columns, thinned, and which of them are plotted together.

use super::arrays::{f32s, f64s};
use super::thin::thinning;
use crate::output::COLUMNS;
use crate::results::{Column, Columns};
use serde_json::{Value, json};

/// Most columns that the page holds; a series has more where there are many walls.
const MOST_COLUMNS: usize = 400;
/// Most lines of a plot.
const MOST_LINES: usize = 12;
/// A component of a wall force that is smaller than this share of the largest is not plotted unasked.
const SMALL: f64 = 0.01;

/// Where plots are on the page.
pub(super) const SERIES: &str = "plots-series";
/// Plots of the ledger.
pub(super) const ENERGY: &str = "plots-energy";
/// Plots of walls.
pub(super) const WALLS: &str = "plots-walls";

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
pub(super) const PUT_IN: [&str; 4] = ["wall work", "boundary work", "multi-contact input", "inserted energy"];
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

/// Columns that are plotted together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Group {
    pub title: String,
    /// Where on the page.
    pub place: &'static str,
    pub x: String,
    pub y: Vec<String>,
}

/// The columns of numbers that the page holds.
fn shown(series: &Columns) -> impl Iterator<Item = &Column> {
    let numbers = series.all().iter().filter(|column| column.numbers().is_some());
    numbers.take(MOST_COLUMNS)
}

/// What is left out or thinned, as sentences.
pub(super) fn told(series: &Columns) -> Vec<String> {
    let mut told = Vec::new();
    let numbers = series.all().iter().filter(|column| column.numbers().is_some()).count();
    if numbers > MOST_COLUMNS {
        told.push(format!(
            "The series has {numbers} columns; the first {MOST_COLUMNS} are here, series.csv holds all."
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
pub(super) fn data(series: &Columns, asked: Vec<Group>) -> Value {
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
    let groups: Vec<Value> = (asked.into_iter().chain(groups(series)))
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

/// The groups of columns that every report plots; those without a column that changes are left out.
pub(super) fn groups(series: &Columns) -> Vec<Group> {
    let of = |title: &str, place: &'static str, names: &[&str]| Group {
        title: title.to_string(),
        place,
        x: "time".to_string(),
        y: names
            .iter()
            .filter(|name| changes(series, name))
            .map(|name| (*name).to_string())
            .collect(),
    };
    let without_gravity: Vec<&str> = STORED
        .iter()
        .copied()
        .filter(|name| !name.starts_with("gravi"))
        .collect();
    let mut groups = vec![
        of("Energies", ENERGY, &without_gravity),
        of("Energy of gravity", ENERGY, &["gravitational energy"]),
        of(
            "Work and losses since the start",
            ENERGY,
            &[&PUT_IN[..], &TAKEN_OUT[..]].concat(),
        ),
        of("Ledger residual", ENERGY, &[RESIDUAL]),
        wall_columns(series, "Wall forces", "force"),
        wall_columns(series, "Wall displacements", "displacement"),
        of("Coordination", SERIES, &["coordination"]),
        of("Contacts", SERIES, &["contacts"]),
        of("Grains", SERIES, &["grains"]),
        of("Packing fraction", SERIES, &["packing fraction", "solid fraction"]),
        of("Strain", SERIES, &["strain"]),
        of(
            "Stress",
            SERIES,
            &[
                "stress xx",
                "stress yy",
                "stress zz",
                "stress xy",
                "stress xz",
                "stress yz",
            ],
        ),
        of("Largest overlap", SERIES, &["max overlap"]),
        of("Largest speed", SERIES, &["max speed"]),
        of("Kinetic over elastic energy", SERIES, &["kinetic over elastic"]),
        of("Momentum", SERIES, &["momentum x", "momentum y", "momentum z"]),
    ];
    groups.retain(|group| !group.y.is_empty());
    groups
}

/// Components of a vector of all walls; small ones are left out.
fn wall_columns(series: &Columns, title: &str, quantity: &str) -> Group {
    let of_walls = || {
        let is_component = |name: &str| {
            name.starts_with("wall ")
                && ["x", "y", "z"]
                    .iter()
                    .any(|axis| name.ends_with(&format!(" {quantity} {axis}")))
        };
        shown(series).filter(move |column| is_component(column.name()))
    };
    let size = |column: &Column| {
        let numbers = column.numbers().unwrap_or_default().iter();
        numbers
            .filter(|v| v.is_finite())
            .fold(0.0_f64, |most, v| most.max(v.abs()))
    };
    let largest = of_walls().map(size).fold(0.0, f64::max);
    let mut kept: Vec<(&Column, f64)> = (of_walls().map(|c| (c, size(c))))
        .filter(|(_, size)| *size > 0.0 && *size >= SMALL * largest)
        .collect();
    kept.sort_by(|a, b| b.1.total_cmp(&a.1));
    kept.truncate(MOST_LINES);
    Group {
        title: title.to_string(),
        place: WALLS,
        x: "time".to_string(),
        y: kept.iter().map(|(column, _)| column.name().to_string()).collect(),
    }
}

/// Whether a column is there and has two different numbers.
fn changes(series: &Columns, name: &str) -> bool {
    let numbers = series.find(name).and_then(Column::numbers).unwrap_or_default();
    let mut finite = numbers.iter().filter(|v| v.is_finite());
    let first = finite.next();
    finite.any(|v| Some(v) != first)
}

/// The number of a column in a row.
pub(super) fn at(series: &Columns, name: &str, row: usize) -> Option<f64> {
    series.find(name)?.numbers()?.get(row).copied()
}

/// The number of a column in the last row.
pub(super) fn last(series: &Columns, name: &str) -> Option<f64> {
    at(series, name, series.rows().checked_sub(1)?)
}
