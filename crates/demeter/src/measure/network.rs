//! The network of contacts: how many, how strong, how long, how densely packed.

use super::{bounds, sphere_in_box};
use crate::contacts::ContactChunk;
use crate::simulation::Simulation;
use glam::DVec3;

/// Which contacts a network is made of, and where its packing fraction is measured.
///
/// **The core.** Walls order the grains beside them, so the packing fraction is that of a box within the packing: the
/// box around the grains' surfaces, less [`ContactNetwork::margin`] mean diameters on every side. In a container of
/// axis-parallel planes that is the distance from the walls (to within the overlap of the grains with them); where the
/// packing ends freely it is the distance from its surface. Any other container, a cylinder or a mesh, does not fill the
/// box around its grains: [`ContactNetwork::region`] then says where to measure, and what of it lies in the core counts.
/// Periodic directions have no margin.
///
/// **Solid volume.** Spheres are cut by the core exactly ([`sphere_in_box`]). Overlaps are not subtracted: they stand for
/// deformation, in which material is displaced and not lost, so every grain keeps its volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactNetwork {
    /// Contacts with a normal force of smaller magnitude are left out [N]; 0: all that act.
    pub threshold: f64,
    /// Distance of the core from the ends of the packing, in mean diameters (by number).
    pub margin: f64,
    /// Lower and upper corner of a box that the core is limited to [m].
    pub region: Option<(DVec3, DVec3)>,
}

impl Default for ContactNetwork {
    fn default() -> Self {
        Self {
            threshold: 0.0,
            margin: 1.0,
            region: None,
        }
    }
}

/// What a [`ContactNetwork`] measures.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct NetworkMeasures {
    /// Contacts between grains that count.
    pub contacts: usize,
    /// Mean number of contacts per grain `Z`: twice those between grains and those with walls, over the grains (also
    /// those without any contact).
    pub coordination: f64,
    /// Mean normal force `f` of the contacts between grains that count, repulsion positive [N]; not a number without any.
    pub mean_force: f64,
    /// Mean distance `b` of the centres of the grains of these contacts [m]; not a number without any.
    pub centre_distance: f64,
    /// Solid volume over volume of the core `phi`; not a number when the core is empty.
    pub packing_fraction: f64,
}

impl NetworkMeasures {
    /// `Z phi b f` [N m]: proportional to the force on the plate that squeezes a packing (Brodu, Dijksman and Behringer
    /// 2015, eq 2). Not a number when one of the factors is not.
    pub fn scaling(&self) -> f64 {
        self.coordination * self.packing_fraction * self.centre_distance * self.mean_force
    }
}

impl ContactNetwork {
    /// Measures the present state.
    pub fn measure(&self, sim: &Simulation) -> NetworkMeasures {
        let (mut contacts, mut force, mut distance) = (0, 0.0, 0.0);
        for chunk in &sim.contacts.pairs {
            for k in (0..chunk.len()).filter(|&k| self.counts(chunk, k)) {
                let contact = sim.contact(chunk, k);
                contacts += 1;
                force += chunk.normal_force()[k];
                distance += contact.lever_i + contact.lever_j;
            }
        }
        let of_chunk = |chunk: &ContactChunk| (0..chunk.len()).filter(|&k| self.counts(chunk, k)).count();
        let with_walls: usize = sim.contacts.walls.iter().map(of_chunk).sum();
        let mean = |sum: f64| if contacts > 0 { sum / contacts as f64 } else { f64::NAN };
        NetworkMeasures {
            contacts,
            coordination: (2 * contacts + with_walls) as f64 / sim.grains.len().max(1) as f64,
            mean_force: mean(force),
            centre_distance: mean(distance),
            packing_fraction: self.packing_fraction(sim),
        }
    }

    fn counts(&self, chunk: &ContactChunk, k: usize) -> bool {
        chunk.acts(k) && chunk.normal_force()[k].abs() >= self.threshold
    }

    /// Lower and upper corner of the core [m]; it is empty when they are not in order.
    pub fn core(&self, sim: &Simulation) -> (DVec3, DVec3) {
        let grains = &sim.grains;
        let (mut lower, mut upper) = bounds(grains, 0..grains.len());
        let mean_diameter = 2.0 * grains.radii().sum::<f64>() / grains.len().max(1) as f64;
        lower += self.margin * mean_diameter;
        upper -= self.margin * mean_diameter;
        let domain = sim.domain();
        for axis in (0..3).filter(|&k| domain.periodic[k]) {
            lower[axis] = domain.lower[axis];
            upper[axis] = domain.upper[axis];
        }
        if let Some((least, most)) = self.region {
            (lower, upper) = (lower.max(least), upper.min(most));
        }
        (lower, upper)
    }

    /// Solid volume in the core over its volume; not a number when the core is empty.
    fn packing_fraction(&self, sim: &Simulation) -> f64 {
        let (lower, upper) = self.core(sim);
        let size = upper - lower;
        if sim.grains.is_empty() || size.min_element() <= 0.0 {
            return f64::NAN;
        }
        let domain = sim.domain();
        // a grain that reaches across a periodic face is in the core there with a part of its image
        let images: [&[f64]; 3] = domain.periodic.map(|p| if p { &[-1.0, 0.0, 1.0][..] } else { &[0.0] });
        let period = domain.size();
        let mut solid = 0.0;
        for (&centre, radius) in sim.grains.position.iter().zip(sim.grains.radii()) {
            for &x in images[0] {
                for &y in images[1] {
                    for &z in images[2] {
                        // not a product: an open direction may be of infinite length
                        let shift = |k: usize, boxes: f64| if boxes == 0.0 { 0.0 } else { boxes * period[k] };
                        let image = centre + DVec3::new(shift(0, x), shift(1, y), shift(2, z));
                        solid += sphere_in_box(image, radius, lower, upper);
                    }
                }
            }
        }
        solid / (size.x * size.y * size.z)
    }
}
