//! How many grains have passed through a gate, and their mass.
//!
//! Centres of grains near the gate are looked at every [`LOOK_EVERY`] steps, and whenever a row is written. A grain has
//! passed when the straight way of its centre between two looks goes through the gate; from which side tells the direction.
//! Near are grains that may get to the plane of the gate before the next look.

use super::told_first::each_grain;
use super::{Selection, ToldColumn, Value};
use crate::particles::Origins;
use crate::simulation::Simulation;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Steps between two looks.
pub const LOOK_EVERY: u64 = 10;

/// Columns of a flow.
pub const FLOW_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new(
        "grains forward",
        "",
        "grains that passed along the normal since the start of the run",
    ),
    ToldColumn::new("mass forward", "kg", "their mass"),
    ToldColumn::new(
        "grains backward",
        "",
        "grains that passed against the normal since the start of the run",
    ),
    ToldColumn::new("mass backward", "kg", "their mass"),
    ToldColumn::new(
        "mass rate",
        "kg/s",
        "mass forward less mass backward since the row before, per time",
    ),
];

/// A part of a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gate {
    /// All of it.
    Plane,
    /// A disc about the point, of this radius [m].
    Disc(f64),
    /// A rectangle about the point, between two perpendicular vectors from it to the middles of its edges [m].
    Rectangle(DVec3, DVec3),
}

/// What has passed through a gate.
#[derive(Clone, Debug, PartialEq)]
pub struct MassFlow {
    /// A point of the plane, and the centre of the gate [m].
    pub point: DVec3,
    /// Unit vector across the gate: forward.
    pub normal: DVec3,
    /// How much of the plane it is.
    pub gate: Gate,
    /// Which grains count.
    pub selection: Selection,
}

/// What was counted so far, and where the grains near the gate were at the latest look.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlowState {
    /// Id and place of the grains near the plane, sorted by id.
    near: Vec<(u32, DVec3)>,
    /// Grains that passed, forward and backward.
    grains: [u64; 2],
    /// Their mass [kg].
    mass: [f64; 2],
    /// Of the latest row: its step, mass forward less backward [kg], and the rate [kg/s].
    row: (u64, f64, f64),
}

impl MassFlow {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        FLOW_COLUMNS.iter().map(|c| c.title(name)).collect()
    }

    /// Looks which grains have passed since the latest look. Looking twice at one moment changes nothing.
    pub fn look(&self, sim: &Simulation, origins: &Origins, state: &mut FlowState) {
        let (grains, comm) = (&sim.grains, &sim.comm);
        // twice the way at the present speed: a grain may be faster later
        let window = 2.0 * LOOK_EVERY as f64 * sim.dt;
        let is_near = |g: usize| {
            let distance = comm.difference(grains.position[g], self.point).dot(self.normal).abs();
            distance < grains.radius(g) || distance < grains.radius(g) + window * grains.velocity[g].length()
        };
        let mut near = Vec::new();
        let tell = |g: usize| {
            let counts = self.selection.holds(grains, origins, g);
            (grains.position[g], counts.then_some(grains.mass(g)))
        };
        each_grain(sim, is_near, tell, |id, (now, mass)| {
            near.push((id, now));
            let Ok(before) = state.near.binary_search_by_key(&id, |grain| grain.0) else {
                return;
            };
            let before = state.near[before].1;
            let way = comm.difference(now, before);
            let direction = self.passed(before, way, |a, b| comm.difference(a, b));
            if let (Some(direction), Some(mass)) = (direction, mass) {
                state.grains[direction] += 1;
                state.mass[direction] += mass;
            }
        });
        state.near = near;
    }

    /// Whether a way goes through the gate: 0 forward, 1 backward. The plane itself belongs to its back.
    fn passed(&self, from: DVec3, way: DVec3, difference: impl Fn(DVec3, DVec3) -> DVec3) -> Option<usize> {
        let from = difference(from, self.point);
        let (before, along) = (from.dot(self.normal), way.dot(self.normal));
        let after = before + along;
        if (before > 0.0) == (after > 0.0) {
            return None;
        }
        let place = from - way * (before / along);
        let inside = match self.gate {
            Gate::Plane => true,
            Gate::Disc(radius) => place.length_squared() <= radius * radius,
            Gate::Rectangle(u, v) => {
                place.dot(u).abs() <= u.length_squared() && place.dot(v).abs() <= v.length_squared()
            }
        };
        inside.then_some(usize::from(before > 0.0))
    }

    /// Its values at a row, in the order of [`FLOW_COLUMNS`], after a look.
    pub fn measure(&self, sim: &Simulation, state: &mut FlowState) -> Vec<Value> {
        let net = state.mass[0] - state.mass[1];
        if sim.step > state.row.0 {
            let seconds = (sim.step - state.row.0) as f64 * sim.dt;
            state.row = (sim.step, net, (net - state.row.1) / seconds);
        }
        vec![
            Value::Count(state.grains[0]),
            Value::Number(state.mass[0]),
            Value::Count(state.grains[1]),
            Value::Number(state.mass[1]),
            Value::Number(state.row.2),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    fn gate(gate: Gate) -> MassFlow {
        MassFlow {
            point: dvec3(0.0, 0.0, 1.0),
            normal: DVec3::NEG_Z,
            gate,
            selection: Selection::default(),
        }
    }

    fn passed(gate: &MassFlow, from: DVec3, to: DVec3) -> Option<usize> {
        gate.passed(from, to - from, |a, b| a - b)
    }

    #[test]
    fn a_way_counts_where_it_meets_the_plane() {
        let (above, below) = (dvec3(0.9, 0.0, 1.2), dvec3(1.3, 0.0, 0.8));
        // it meets the plane at x = 1.1
        for (shape, inside) in [
            (Gate::Plane, true),
            (Gate::Disc(1.0), false),
            (Gate::Disc(1.2), true),
            (Gate::Rectangle(DVec3::X * 1.05, DVec3::Y), false),
            (Gate::Rectangle(DVec3::Y, DVec3::X * 1.15), true),
        ] {
            let gate = gate(shape);
            assert_eq!(passed(&gate, above, below), inside.then_some(0), "{shape:?}");
            assert_eq!(passed(&gate, below, above), inside.then_some(1), "{shape:?}");
            assert_eq!(passed(&gate, above, above), None);
        }
    }

    #[test]
    fn a_grain_that_rests_on_the_plane_passes_once() {
        let plane = gate(Gate::Plane);
        let on = dvec3(0.0, 0.0, 1.0);
        let (above, below) = (on + DVec3::Z, on - DVec3::Z);
        assert_eq!([passed(&plane, above, on), passed(&plane, on, below)], [None, Some(0)]);
        assert_eq!([passed(&plane, below, on), passed(&plane, on, above)], [Some(1), None]);
        assert_eq!(passed(&plane, on, on), None);
    }
}
