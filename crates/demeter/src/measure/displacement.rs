//! How far grains have come: means and mean squares of their displacements.

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
        let mut now: Vec<(u32, DVec3)> = (0..sim.grains.len())
            .map(|g| (sim.grains.id[g], sim.unwrapped(g)))
            .collect();
        now.sort_unstable_by_key(|grain| grain.0);
        for grain in &mut now {
            if let Ok(before) = state.starts.binary_search_by_key(&grain.0, |start| start.0) {
                grain.1 = state.starts[before].1;
            }
        }
        state.starts = now;
    }

    /// Its values now, in the order of [`DISPLACEMENT_COLUMNS`], after a look. Grains are summed up in the order of their ids.
    pub fn measure(&self, sim: &Simulation, origins: &Origins, state: &DisplacementState) -> Vec<Value> {
        let grains = &sim.grains;
        let mut ways: Vec<(u32, DVec3)> = (0..grains.len())
            .filter(|&g| self.selection.holds(grains, origins, g))
            .filter_map(|g| {
                let at = state.starts.binary_search_by_key(&grains.id[g], |start| start.0).ok()?;
                Some((grains.id[g], sim.unwrapped(g) - state.starts[at].1))
            })
            .collect();
        ways.sort_unstable_by_key(|way| way.0);
        let count = ways.len() as f64;
        let mean = ways.iter().map(|way| way.1).sum::<DVec3>() / count;
        let square = ways.iter().map(|way| way.1.length_squared()).sum::<f64>() / count;
        let spread = ways.iter().map(|way| (way.1 - mean) * (way.1 - mean)).sum::<DVec3>() / count;
        let largest = ways.iter().map(|way| way.1.length()).fold(f64::NAN, f64::max);
        let mut values = vec![Value::Count(ways.len() as u64)];
        values.extend(mean.to_array().map(Value::Number));
        values.push(Value::Number(square));
        values.extend(spread.to_array().map(Value::Number));
        values.push(Value::Number(largest));
        values
    }
}
