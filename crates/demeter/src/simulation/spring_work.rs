//! What springs in the contact plane store at the moment of a row.
//!
//! A spring remembers its load half a step after the moment at which the velocities are told. What it gains in that half is what the bodies
//! give to it, less what friction loses: half of `W - D` of the latest step, with `W = -F . v dt` of its force and the velocity with which
//! the bodies slide (of rolling, its torque and relative angular velocity). `D` is in the books.

use super::{Energies, Segment, Simulation};
use crate::comm::Single;
use crate::comm::segment_sums::Summand;
use crate::contacts::laws::memories;
use crate::contacts::{ContactChunk, Tally};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What bodies give to springs and to friction in a step [J].
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
struct Given {
    sliding: f64,
    rolling: f64,
}

impl Summand for Given {
    fn add(&mut self, part: &Self) {
        self.sliding += part.sliding;
        self.rolling += part.rolling;
    }
}

impl Simulation {
    /// Energies of this moment, with springs as they are now and not half a step later; `latest`: what the contacts did in the latest step.
    /// Where processes share the run each calls this.
    pub(super) fn energies_now(&mut self, latest: Tally) -> Energies {
        let remembers = |which: usize| self.materials.laws().iter().any(|law| memories(law)[which].is_some());
        let [slides, rolls] = [1, 2].map(remembers);
        if slides || rolls {
            // near the borders velocities are still those that laws were told
            self.exchange_borders(|_| ());
        } else {
            self.hear_corrected_places();
        }
        let mut now = self.mechanical_energies();
        if slides || rolls {
            let given = self.sum_of_all(|segment| self.given_in(segment));
            if slides {
                now.tangential -= 0.5 * (given.sliding - latest.friction);
            }
            if rolls {
                now.rolling -= 0.5 * (given.rolling - latest.rolling);
            }
        }
        now
    }

    fn given_in(&self, segment: Segment) -> Given {
        let mut sum = Given::default();
        let chunks = segment.pairs.iter().map(|chunk| (chunk, false));
        for (chunk, wall) in chunks.chain(segment.walls.iter().map(|chunk| (chunk, true))) {
            for k in (0..chunk.len()).filter(|&k| chunk.is_engaged(k)) {
                let [sliding, turning] = self.relative_motion(chunk, k, wall);
                sum.sliding -= chunk.tangential_force(k).dot(sliding) * self.dt;
                sum.rolling -= chunk.rolling_torque(k).dot(turning) * self.dt;
            }
        }
        sum
    }

    /// Velocity of the first body relative to the second at the contact point [m/s], and angular velocity relative to it [1/s].
    fn relative_motion(&self, chunk: &ContactChunk, k: usize, wall: bool) -> [DVec3; 2] {
        let contact = self.contact(chunk, k);
        let (grains, i, j) = (&self.grains, chunk.i[k] as usize, chunk.j[k] as usize);
        let mut arms = grains.angular_velocity[i] * contact.lever_i;
        let (velocity, spin) = if wall {
            let wall = &self.walls[j];
            let point = grains.position[i] - contact.normal * contact.lever_i;
            (wall.velocity_at(point) + wall.belt(), wall.angular_velocity())
        } else {
            arms += grains.angular_velocity[j] * contact.lever_j;
            let code = self.comm.nearest_image(grains.position[i] - grains.position[j]);
            let boxes = Single::boxes(code);
            let passing: DVec3 = (0..3).map(|axis| self.comm.edge_velocity(axis) * boxes[axis]).sum();
            (grains.velocity[j] - passing, grains.angular_velocity[j])
        };
        [
            grains.velocity[i] - velocity - arms.cross(contact.normal),
            grains.angular_velocity[i] - spin,
        ]
    }
}
