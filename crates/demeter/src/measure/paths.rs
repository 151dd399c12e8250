//! Paths of selected grains.

use super::Selection;
use super::told_first::{chosen_by_id, each_of};
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
        let mut chosen = chosen_by_id(sim, |g| self.selection.holds(grains, origins, g));
        chosen.truncate(self.most as usize);
        let contacts = super::contact_counts(sim);
        let tell = |g: usize| {
            let motion = [sim.unwrapped(g), grains.velocity[g], grains.angular_velocity[g]];
            (motion, contacts[g])
        };
        let mut points = Vec::new();
        each_of(
            sim,
            chosen,
            tell,
            |id, ([place, velocity, angular_velocity], contacts)| {
                points.push(PathPoint {
                    id,
                    tag: origins.tag(id),
                    place,
                    velocity,
                    angular_velocity,
                    contacts,
                });
            },
        );
        points.truncate(self.most as usize);
        points
    }
}
