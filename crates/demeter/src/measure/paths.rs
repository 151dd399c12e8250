//! Paths of selected grains.

use super::Selection;
use crate::particles::Origins;
use crate::simulation::Simulation;
use glam::DVec3;

/// Most grains whose paths are written.
pub const MAX_PATHS: u32 = 10_000;

/// Which grains' paths are written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Paths {
    /// Which grains.
    pub selection: Selection,
    /// Of those that are selected, at most so many: the ones with the lowest ids.
    pub most: u32,
}

/// A grain on its path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// Id of the grain.
    pub id: u32,
    /// Its tag.
    pub tag: i32,
    /// Its centre, counted on across periodic sides [m].
    pub place: DVec3,
    /// Its velocity [m/s].
    pub velocity: DVec3,
    /// Its angular velocity [rad/s].
    pub angular_velocity: DVec3,
    /// Number of its contacts that act.
    pub contacts: u32,
}

impl Paths {
    /// Where the grains are now, in the order of their ids.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<PathPoint> {
        let grains = &sim.grains;
        let mut chosen: Vec<(u32, usize)> = (0..grains.len())
            .filter(|&g| self.selection.holds(grains, origins, g))
            .map(|g| (grains.id[g], g))
            .collect();
        chosen.sort_unstable();
        chosen.truncate(self.most as usize);
        let contacts = super::contact_counts(sim);
        let point = |(id, g): (u32, usize)| PathPoint {
            id,
            tag: origins.tag(id),
            place: sim.unwrapped(g),
            velocity: grains.velocity[g],
            angular_velocity: grains.angular_velocity[g],
            contacts: contacts[g],
        };
        chosen.into_iter().map(point).collect()
    }
}
