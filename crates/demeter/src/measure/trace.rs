//! Where grains are and how they move: one grain, or the mean of several.

use super::{Selection, ToldColumn, Value};
use crate::particles::Origins;
use crate::simulation::Simulation;
use glam::DVec3;

/// Columns of a trace. Means are weighed by mass; not a number when no grain is left.
pub const TRACE_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("traced", "", "number of grains that are traced"),
    ToldColumn::new("x", "m", "centre of mass, counted on across periodic sides"),
    ToldColumn::new("y", "m", "see x"),
    ToldColumn::new("z", "m", "see x"),
    ToldColumn::new("velocity x", "m/s", "mean velocity"),
    ToldColumn::new("velocity y", "m/s", "see velocity x"),
    ToldColumn::new("velocity z", "m/s", "see velocity x"),
    ToldColumn::new("angular velocity x", "rad/s", "mean angular velocity"),
    ToldColumn::new("angular velocity y", "rad/s", "see angular velocity x"),
    ToldColumn::new("angular velocity z", "rad/s", "see angular velocity x"),
    ToldColumn::new("force x", "N", "sum of the forces on them, gravity included"),
    ToldColumn::new("force y", "N", "see force x"),
    ToldColumn::new("force z", "N", "see force x"),
];

/// Grains that are traced.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GrainTrace {
    /// Which grains.
    pub selection: Selection,
}

impl GrainTrace {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        TRACE_COLUMNS.iter().map(|c| c.title(name)).collect()
    }

    /// Its values now, in the order of [`TRACE_COLUMNS`]. Grains are summed up in the order of their ids.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Value> {
        let grains = &sim.grains;
        let mut traced: Vec<(u32, usize)> = (0..grains.len())
            .filter(|&g| self.selection.holds(grains, origins, g))
            .map(|g| (grains.id[g], g))
            .collect();
        traced.sort_unstable();
        let mut mass = 0.0;
        let [mut place, mut velocity, mut spin, mut force] = [DVec3::ZERO; 4];
        for &(_, g) in &traced {
            let m = grains.mass[g];
            mass += m;
            place += sim.unwrapped(g) * m;
            velocity += grains.velocity[g] * m;
            spin += grains.angular_velocity[g] * m;
            force += grains.force[g];
        }
        if let [(_, g)] = traced[..] {
            // one grain tells its own numbers, not what rounding makes of them
            (place, velocity) = (sim.unwrapped(g), grains.velocity[g]);
            spin = grains.angular_velocity[g];
        } else {
            [place, velocity, spin] = [place / mass, velocity / mass, spin / mass];
        }
        if traced.is_empty() {
            force = DVec3::NAN;
        }
        let numbers = [place, velocity, spin, force].map(|v| v.to_array().map(Value::Number));
        let count = Value::Count(traced.len() as u64);
        std::iter::once(count).chain(numbers.into_iter().flatten()).collect()
    }
}
