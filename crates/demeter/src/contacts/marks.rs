//! What contacts do to walls that record it.

use super::laws::spring_energies;
use super::respond::Lost;
use super::{ContactChunk, Scene};
use crate::neighbours::WallPair;
use crate::walls::Mark;

impl ContactChunk {
    /// Marks what friction loses where contacts of the step before end: what their springs still held.
    pub(super) fn mark_ends(&mut self, pairs: &[WallPair], scene: &Scene) {
        let law = scene.materials.law(self.law);
        for (c, pair) in pairs.iter().enumerate() {
            let wall = &scene.walls[pair.wall as usize];
            for k in self.before.range(c).filter(|_| wall.is_recorded()) {
                if self.goes_on[k] {
                    continue;
                }
                let history = &self.before.history[k * scene.stride..(k + 1) * scene.stride];
                let sliding = spring_energies(law, history).0;
                if sliding == 0.0 {
                    continue;
                }
                let contact = &self.before.geometry[k];
                let g = pair.grain as usize;
                let point = scene.grains.position[g] - contact.normal * contact.lever_i;
                self.marks.push(Mark {
                    wall: pair.wall,
                    element: wall.element_at(self.before.element[k], point, scene.grains.radius(g)),
                    normal_force: 0.0,
                    normal: contact.normal,
                    tangential: glam::DVec3::ZERO,
                    impact: 0.0,
                    sliding,
                    slid_load: 0.0,
                });
            }
        }
    }

    /// Marks what every contact does to its wall in this step.
    pub(super) fn mark_walls(&mut self, scene: &Scene) {
        for k in 0..self.len() {
            let wall = &scene.walls[self.j[k] as usize];
            // what the springs held of one that ended is lost in this step
            let does_nothing = !self.is_engaged(k) && self.losses[k] == Lost::default();
            if !wall.is_recorded() || does_nothing {
                continue;
            }
            let (g, contact) = (self.i[k] as usize, &self.now.geometry[k]);
            let normal_force = self.normal_force(k);
            let point = scene.grains.position[g] - contact.normal * contact.lever_i;
            let lost = self.losses[k];
            self.marks.push(Mark {
                wall: self.j[k],
                element: wall.element_at(self.now.element[k], point, scene.grains.radius(g)),
                normal_force,
                normal: contact.normal,
                tangential: -self.tangential_force(k),
                impact: lost.normal,
                sliding: lost.friction,
                slid_load: lost.slid_load,
            });
        }
    }
}
