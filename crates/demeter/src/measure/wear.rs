//! Columns of walls that record their wear.

use super::told::{ToldColumn, Value};
use crate::simulation::Simulation;

/// Columns of every wall that records its wear; their names begin with `wall NAME`.
pub const WEAR_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new(
        "impact energy",
        "J",
        "lost by the normal law at the wall since the start",
    ),
    ToldColumn::new("sliding energy", "J", "lost by friction at the wall since the start"),
    ToldColumn::new(
        "worn volume",
        "m^3",
        "volume worn off the wall since the start, by its coefficients",
    ),
];

/// Values of these columns for all walls that record their wear.
pub fn wear_values(sim: &Simulation) -> Vec<Value> {
    let worn = sim.walls.iter().filter(|wall| wall.recording().wear.is_some());
    worn.flat_map(|wall| wall.wear()).map(Value::Number).collect()
}
