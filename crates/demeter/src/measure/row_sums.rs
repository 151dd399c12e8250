//! What a row of the series tells of all grains and contacts, as sums over their segments.

use crate::comm::segment_sums::Summand;
use crate::contacts::ContactChunk;
use crate::simulation::{Segment, Simulation};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::ops::Range;

/// What some grains and their contacts come to.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct RowSums {
    /// Contacts between grains that act.
    pub contacts: u64,
    /// Contacts with walls that act, and those of every wall; empty where no wall is near.
    pub wall_contacts: u64,
    pub of_walls: Vec<u32>,
    /// Largest overlap as a share of the smaller radius.
    pub max_overlap: f64,
    /// Square of the largest speed [m^2/s^2].
    pub speed2: f64,
    /// [kg m/s]
    pub momentum: DVec3,
    /// Volume of the grains [m^3].
    pub solid: f64,
    /// Sum of `F l` with the force `F` on a grain and the branch vector `l` from its partner's centre (a wall: from the contact
    /// point) to its own; compression is positive: xx, yy, zz, xy, xz, yz [N m].
    pub stress: [f64; 6],
    /// Corners of the box around the grains' surfaces [m]; infinite, the lower above the upper, without grains.
    bounds: [DVec3; 2],
}

impl Default for RowSums {
    fn default() -> Self {
        Self {
            contacts: 0,
            wall_contacts: 0,
            of_walls: Vec::new(),
            max_overlap: 0.0,
            speed2: 0.0,
            momentum: DVec3::ZERO,
            solid: 0.0,
            stress: [0.0; 6],
            bounds: [DVec3::INFINITY, DVec3::NEG_INFINITY],
        }
    }
}

impl Summand for RowSums {
    fn add(&mut self, other: &Self) {
        self.contacts += other.contacts;
        self.wall_contacts += other.wall_contacts;
        if self.of_walls.len() < other.of_walls.len() {
            self.of_walls.resize(other.of_walls.len(), 0);
        }
        for (sum, more) in self.of_walls.iter_mut().zip(&other.of_walls) {
            *sum += more;
        }
        self.max_overlap = self.max_overlap.max(other.max_overlap);
        self.speed2 = self.speed2.max(other.speed2);
        self.momentum += other.momentum;
        self.solid += other.solid;
        for (sum, more) in self.stress.iter_mut().zip(other.stress) {
            *sum += more;
        }
        let ([lower, upper], [other_lower, other_upper]) = (self.bounds, other.bounds);
        self.bounds = [lower.min(other_lower), upper.max(other_upper)];
    }
}

impl RowSums {
    /// Those of all grains and contacts, of all processes.
    pub fn of_all(sim: &Simulation) -> Self {
        sim.sum_of_all(|segment| Self::of_segment(sim, segment))
    }

    fn of_segment(sim: &Simulation, segment: Segment) -> Self {
        let mut sums = Self::default();
        sums.add_grains(sim, segment.grains);
        for chunk in segment.pairs {
            sums.contacts += chunk.acting() as u64;
            sums.add_contacts(sim, chunk, |k| {
                let radius = |g: u32| sim.grains.radius(g as usize);
                radius(chunk.i[k]).min(radius(chunk.j[k]))
            });
        }
        for chunk in segment.walls {
            sums.wall_contacts += chunk.acting() as u64;
            sums.of_walls.resize(sim.walls.len(), 0);
            for k in (0..chunk.len()).filter(|&k| chunk.acts(k)) {
                sums.of_walls[chunk.j[k] as usize] += 1;
            }
            sums.add_contacts(sim, chunk, |k| sim.grains.radius(chunk.i[k] as usize));
        }
        sums
    }

    fn add_grains(&mut self, sim: &Simulation, some: Range<usize>) {
        let grains = &sim.grains;
        let [mut lower, mut upper] = self.bounds;
        for g in some {
            let (r, place, velocity) = (grains.radius(g), grains.position[g], grains.velocity[g]);
            self.solid += 4.0 / 3.0 * PI * r * r * r;
            self.momentum += velocity * grains.mass(g);
            self.speed2 = self.speed2.max(velocity.length_squared());
            lower = lower.min(place - r);
            upper = upper.max(place + r);
        }
        self.bounds = [lower, upper];
    }

    fn add_contacts(&mut self, sim: &Simulation, chunk: &ContactChunk, smaller_radius: impl Fn(usize) -> f64) {
        for k in 0..chunk.len() {
            let contact = sim.contact(chunk, k);
            self.max_overlap = self.max_overlap.max(contact.overlap / smaller_radius(k));
            let f = chunk.force(k, contact.normal);
            let l = contact.normal * (contact.lever_i + contact.lever_j);
            let shear = [f.x * l.y + f.y * l.x, f.x * l.z + f.z * l.x, f.y * l.z + f.z * l.y];
            let terms = [
                f.x * l.x,
                f.y * l.y,
                f.z * l.z,
                0.5 * shear[0],
                0.5 * shear[1],
                0.5 * shear[2],
            ];
            for (sum, term) in self.stress.iter_mut().zip(terms) {
                *sum += term;
            }
        }
    }

    /// Volume of the box around the grains' surfaces, whole in periodic directions [m^3].
    pub fn volume(&self, sim: &Simulation) -> f64 {
        let [lower, upper] = self.bounds;
        let mut size = if sim.grains.is_empty() {
            DVec3::ZERO
        } else {
            upper - lower
        };
        for axis in (0..3).filter(|&k| sim.domain().periodic[k]) {
            size[axis] = sim.domain().size()[axis];
        }
        size.x * size.y * size.z
    }
}
