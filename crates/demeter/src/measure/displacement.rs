//! How far grains have come: means and mean squares of their displacements.

use super::told_first::each_grain;
use super::{Selection, ToldColumn, Value};
use crate::particles::Origins;
use crate::simulation::Simulation;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Columns of displacements; means by number, not a number without grains.
pub const DISPLACEMENT_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new(
        "displaced grains",
        "",
        "grains that count and were there at the start of the count",
    ),
    ToldColumn::new(
        "displacement x",
        "m",
        "mean displacement, counted on across periodic sides",
    ),
    ToldColumn::new("displacement y", "m", "see displacement x"),
    ToldColumn::new("displacement z", "m", "see displacement x"),
    ToldColumn::new(
        "mean square displacement",
        "m^2",
        "mean of the square of the displacement",
    ),
    ToldColumn::new(
        "spread x",
        "m^2",
        "mean of the square of the deviation from the mean displacement in x",
    ),
    ToldColumn::new("spread y", "m^2", "see spread x"),
    ToldColumn::new("spread z", "m^2", "see spread x"),
    ToldColumn::new("largest displacement", "m", "largest displacement of a grain"),
];

/// Of which grains displacements are measured, and from when on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Displacement {
    /// Which grains count.
    pub selection: Selection,
    /// Time at which the count begins [s]; grains that come later count from when they are first seen.
    pub from: f64,
}

/// Where grains were when their count began: ids, rising, and places [m].
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DisplacementState {
    starts: Vec<(u32, DVec3)>,
}

impl Displacement {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        DISPLACEMENT_COLUMNS.iter().map(|c| c.title(name)).collect()
    }

    /// Notes where grains are that were not seen before; grains that are gone are forgotten.
    pub fn look(&self, sim: &Simulation, state: &mut DisplacementState) {
        if sim.time() < self.from * (1.0 - 1e-12) {
            return;
        }
        let mut now = Vec::new();
        each_grain(
            sim,
            |_| true,
            |g| sim.unwrapped(g),
            |id, place| {
                let before = state.starts.binary_search_by_key(&id, |start| start.0);
                now.push((id, before.map_or(place, |before| state.starts[before].1)));
            },
        );
        state.starts = now;
    }

    /// Its values now, in the order of [`DISPLACEMENT_COLUMNS`], after a look. Grains are summed up in the order of their ids.
    pub fn measure(&self, sim: &Simulation, origins: &Origins, state: &DisplacementState) -> Vec<Value> {
        let grains = &sim.grains;
        let mut ways = Vec::new();
        let counts = |g: usize| self.selection.holds(grains, origins, g);
        each_grain(
            sim,
            counts,
            |g| sim.unwrapped(g),
            |id, place| {
                let start = state.starts.binary_search_by_key(&id, |start| start.0);
                ways.extend(start.map(|at| place - state.starts[at].1));
            },
        );
        let count = ways.len() as f64;
        let mean = ways.iter().sum::<DVec3>() / count;
        let square = ways.iter().map(|way| way.length_squared()).sum::<f64>() / count;
        let spread = ways.iter().map(|way| (way - mean) * (way - mean)).sum::<DVec3>() / count;
        let largest = ways.iter().map(|way| way.length()).fold(f64::NAN, f64::max);
        let mut values = vec![Value::Count(ways.len() as u64)];
        values.extend(mean.to_array().map(Value::Number));
        values.push(Value::Number(square));
        values.extend(spread.to_array().map(Value::Number));
        values.push(Value::Number(largest));
        values
    }
}
