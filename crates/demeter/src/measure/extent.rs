//! How far grains reach: the height of a bed, the level in a vessel, the thickness of a tablet.

use super::{Selection, ToldColumn, Value, bounds_of, holds};
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use glam::DVec3;

/// Columns of an extent; not a number without grains.
pub const EXTENT_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new(
        "lowest x",
        "m",
        "least x of the surfaces of the grains; NaN without grains",
    ),
    ToldColumn::new("lowest y", "m", "see lowest x"),
    ToldColumn::new("lowest z", "m", "see lowest x"),
    ToldColumn::new(
        "highest x",
        "m",
        "largest x of the surfaces of the grains; NaN without grains",
    ),
    ToldColumn::new("highest y", "m", "see highest x"),
    ToldColumn::new("highest z", "m", "see highest x"),
];

/// The box around the surfaces of some grains.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Extent {
    /// Where their centres lie.
    pub zone: Zone,
    /// Which of them.
    pub selection: Selection,
}

impl Extent {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        EXTENT_COLUMNS.iter().map(|column| column.title(name)).collect()
    }

    /// Its values now, in the order of the titles. Along periodic directions, in which grains repeat without end, the box ends them.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Value> {
        let counts = |g: usize| holds(sim, &self.zone, g) && self.selection.holds(&sim.grains, origins, g);
        let (mut lower, mut upper) = bounds_of(sim, counts);
        if lower.x > upper.x {
            (lower, upper) = (DVec3::NAN, DVec3::NAN);
        } else {
            let domain = sim.domain();
            for axis in (0..3).filter(|&axis| domain.periodic[axis]) {
                (lower[axis], upper[axis]) = (domain.lower[axis], domain.upper[axis]);
            }
        }
        let corners = [lower, upper].into_iter().flat_map(|corner| corner.to_array());
        corners.map(Value::Number).collect()
    }
}
