//! Where grains are and how they move: one grain, or the mean of several.

use super::told_first::each_grain;
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
        let (mut count, mut mass, mut sums, mut latest) = (0, 0.0, [DVec3::ZERO; 3], [DVec3::ZERO; 3]);
        let mut force = DVec3::ZERO;
        let is_traced = |g: usize| self.selection.holds(grains, origins, g);
        let tell = |g: usize| {
            let motion = [sim.unwrapped(g), grains.velocity[g], grains.angular_velocity[g]];
            (grains.mass(g), motion, grains.force(g))
        };
        each_grain(sim, is_traced, tell, |_, (m, motion, f)| {
            count += 1;
            mass += m;
            (sums.iter_mut().zip(motion)).for_each(|(sum, of)| *sum += of * m);
            latest = motion;
            force += f;
        });
        let means = match count {
            // one grain tells its own numbers, not what rounding makes of them
            1 => latest,
            _ => sums.map(|sum| sum / mass),
        };
        if count == 0 {
            force = DVec3::NAN;
        }
        let numbers = means
            .into_iter()
            .chain([force])
            .map(|v| v.to_array().map(Value::Number));
        let count = Value::Count(count);
        std::iter::once(count).chain(numbers.flatten()).collect()
    }
}
