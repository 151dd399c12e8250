//! The network of contacts: how many, how strong, how long, how densely packed.

use super::images::{Periods, around};
use super::told_first::{Acting, each, each_in_order, own_pairs, own_with_walls};
use super::{bounds_of, sphere_in_box};
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
        let counts = |contact: &Acting<'_>| contact.normal_force().abs() >= self.threshold;
        let tell = |pair: Acting<'_>| {
            let contact = pair.contact(sim);
            (pair.normal_force(), contact.lever_i + contact.lever_j)
        };
        each(sim, own_pairs(sim).filter(counts).map(tell), |(f, apart)| {
            contacts += 1;
            force += f;
            distance += apart;
        });
        let with_walls = sim.together().count(own_with_walls(sim).filter(counts).count());
        let mean = |sum: f64| if contacts > 0 { sum / contacts as f64 } else { f64::NAN };
        NetworkMeasures {
            contacts,
            coordination: (2 * contacts + with_walls) as f64 / sim.grains.len().max(1) as f64,
            mean_force: mean(force),
            centre_distance: mean(distance),
            packing_fraction: self.packing_fraction(sim),
        }
    }

    /// Lower and upper corner of the core [m]; it is empty when they are not in order.
    pub fn core(&self, sim: &Simulation) -> (DVec3, DVec3) {
        let grains = &sim.grains;
        let (mut lower, mut upper) = bounds_of(sim, |_| true);
        let mut diameters = 0.0;
        each_in_order(sim, |g| Some(grains.radius(g)), |radius| diameters += radius);
        let mean_diameter = 2.0 * sim.together().told_by_first(&[diameters])[0] / grains.len().max(1) as f64;
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
        // a grain that reaches across a periodic side is in the core there with a part of its image
        let periods = Periods::of(sim);
        let parts = sim.own_grains().flat_map(|g| {
            let (centre, radius) = (sim.grains.position[g], sim.grains.radius(g));
            let mut parts = Vec::new();
            periods.each_image(around(centre, radius), (lower, upper), &mut |shift, _| {
                parts.push(sphere_in_box(centre + shift, radius, lower, upper));
            });
            parts.into_iter().filter(|part| *part != 0.0)
        });
        let mut solid = 0.0;
        each(sim, parts, |part| solid += part);
        solid / (size.x * size.y * size.z)
    }
}
