//! How many contacts begin, and with what energy.
//!
//! A collision is a contact that begins: bodies that stay in touch while they roll or slide do not collide. Its energy is that of the
//! relative motion along the normal with the effective mass, `m v_n^2 / 2`; that of the motion in the contact plane, `m v_t^2 / 2` of the
//! surfaces, is told apart. Contacts of the first moment do not count as long as they last. Where bodies that attract each other begin to feel so across a gap the collision begins.

use super::forces::rounded;
use super::{Selection, ToldColumn, Value, holds_place};
use crate::contacts::{Impact, Struck};
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use serde::{Deserialize, Serialize};

/// Most bins of collision energies.
pub const MAX_ENERGY_BINS: u32 = 10_000;

/// Columns of collisions.
pub const COLLISION_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new(
        "collisions",
        "",
        "contacts between grains that began since the start of the run",
    ),
    ToldColumn::new(
        "normal energy",
        "J",
        "sum of their energies of approach, m v_n^2/2 with the effective mass",
    ),
    ToldColumn::new(
        "tangential energy",
        "J",
        "the same of the surfaces in the contact plane, m v_t^2/2",
    ),
    ToldColumn::new(
        "wall collisions",
        "",
        "contacts with walls that began since the start of the run",
    ),
    ToldColumn::new("wall normal energy", "J", "sum of their energies of approach"),
    ToldColumn::new(
        "wall tangential energy",
        "J",
        "the same of the surfaces in the contact plane",
    ),
];

/// Bins of energies, each as much wider than the one before.
#[derive(Clone, Debug, PartialEq)]
pub struct EnergyBins {
    edges: Vec<f64>,
}

impl EnergyBins {
    /// So many bins from one energy to another, above 0 [J]; edges between are rounded to 12 digits. Nothing where edges would be the same.
    pub fn new(lower: f64, upper: f64, count: u32) -> Option<Self> {
        let are_sound = lower > 0.0 && upper.is_finite() && lower < upper && (1..=MAX_ENERGY_BINS).contains(&count);
        let step = are_sound.then(|| libm::log(upper / lower) / f64::from(count))?;
        let between = (1..count).map(|k| rounded(lower * libm::exp(step * f64::from(k))));
        let edges: Vec<f64> = std::iter::once(lower).chain(between).chain([upper]).collect();
        edges.is_sorted_by(|a, b| a < b).then_some(Self { edges })
    }

    /// Lower edge of every bin, and the upper edge of the last [J].
    pub fn edges(&self) -> &[f64] {
        &self.edges
    }

    /// Where an energy is counted: 0 below all bins, then the bins, and behind them what is above; a lower edge belongs to its bin.
    fn place(&self, energy: f64) -> usize {
        self.edges.partition_point(|&edge| edge <= energy)
    }
}

/// Which collisions are counted.
#[derive(Clone, Debug, PartialEq)]
pub struct Collisions {
    /// Where contact points lie.
    pub zone: Zone,
    /// Grains that collide: one at least is such a grain.
    pub selection: Selection,
    /// Material of what such a grain collides with, be it a grain or a wall.
    pub partner: Option<u16>,
    /// Bins of the distribution of energies.
    pub bins: Option<EnergyBins>,
}

/// What was seen so far.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CollisionState {
    /// Between grains, and with walls.
    kinds: [Counted; 2],
}

/// Collisions of one kind.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Counted {
    /// How many.
    pub count: u64,
    /// Sums of their energies along the normal and in the contact plane [J].
    pub energies: [f64; 2],
    /// How many below all bins, in each, and above.
    pub bins: Vec<u64>,
}

/// Contacts that began since the latest look, as the first process is told of all. Where processes share the run each calls this.
pub(crate) fn hear_impacts(sim: &mut Simulation, heard: &mut Vec<Impact>) {
    let own = sim.take_impacts();
    let together = sim.together();
    let all = together.merged(own.into_iter(), Impact::order);
    let is_first = together.is_first();
    heard.extend(all.filter(|_| is_first));
}

impl Collisions {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        COLLISION_COLUMNS.iter().map(|c| c.title(name)).collect()
    }

    /// Counts contacts that began.
    pub(crate) fn count(&self, impacts: &[Impact], sim: &Simulation, origins: &Origins, state: &mut CollisionState) {
        for impact in impacts {
            if !(self.concerns(impact, origins) && holds_place(sim, &self.zone, impact.place)) {
                continue;
            }
            let counted = &mut state.kinds[usize::from(impact.with_wall)];
            counted.count += 1;
            for (sum, energy) in counted.energies.iter_mut().zip(impact.energies) {
                *sum += energy;
            }
            if let Some(bins) = &self.bins {
                counted.bins.resize(bins.edges.len() + 1, 0);
                counted.bins[bins.place(impact.energies[0])] += 1;
            }
        }
    }

    /// Whether one of the bodies is a grain that is meant, and the other what it is to meet.
    fn concerns(&self, impact: &Impact, origins: &Origins) -> bool {
        let [one, other] = &impact.bodies;
        let is_meant = |grain: &Struck, partner: &Struck| {
            self.partner.is_none_or(|material| partner.material == material)
                && self
                    .selection
                    .holds_one(grain.id, grain.material, grain.diameter, origins)
        };
        is_meant(one, other) || !impact.with_wall && is_meant(other, one)
    }

    /// Its values, in the order of [`COLLISION_COLUMNS`], after a look.
    pub fn measure(&self, state: &CollisionState) -> Vec<Value> {
        let of = |counted: &Counted| {
            let [normal, tangential] = counted.energies.map(Value::Number);
            [Value::Count(counted.count), normal, tangential]
        };
        state.kinds.iter().flat_map(of).collect()
    }

    /// Collisions between grains and with walls, by bins where there are any.
    pub fn distribution(&self, state: &CollisionState) -> [Counted; 2] {
        state.kinds.clone().map(|mut counted| {
            counted.bins.resize(self.places(), 0);
            counted
        })
    }

    fn places(&self) -> usize {
        self.bins.as_ref().map_or(0, |bins| bins.edges.len() + 1)
    }

    /// Whether the state of a checkpoint is one of this measure.
    pub fn fits(&self, state: &CollisionState) -> bool {
        (state.kinds.iter()).all(|counted| counted.bins.is_empty() || counted.bins.len() == self.places())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn energies_lie_in_bins_of_equal_ratio() {
        let bins = EnergyBins::new(1e-9, 1e-3, 6).unwrap();
        assert_eq!(bins.edges(), [1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3]);
        let places = [0.0, 0.99e-9, 1e-9, 9.9e-9, 1e-8, 1e-4, 1e-3, 1.0].map(|energy| bins.place(energy));
        assert_eq!(places, [0, 0, 1, 1, 2, 6, 7, 7]);
        assert!(EnergyBins::new(1.0, 1.0 + 1e-13, 2).is_none() && EnergyBins::new(0.0, 1.0, 2).is_none());
        assert!(EnergyBins::new(1.0, f64::INFINITY, 2).is_none() && EnergyBins::new(1.0, 2.0, 0).is_none());
    }
}
