//! Profiles along an axis: packing fraction and velocity in slices of a box.

use super::images::{Periods, around};
use super::told_first::each_grain;
use super::{Selection, sphere_in_box};
use crate::particles::Origins;
use crate::simulation::Simulation;
use glam::DVec3;

/// Most slices.
pub const MAX_SLICES: u32 = 10_000;

/// Slices of equal width of a box.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// Lower corner of the box [m].
    pub lower: DVec3,
    /// Upper corner [m].
    pub upper: DVec3,
    /// Axis across the slices: 0 to 2.
    pub axis: usize,
    /// Number of slices.
    pub slices: u32,
    /// Which grains count.
    pub selection: Selection,
}

/// A slice.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Slice {
    /// Middle of the slice on the axis [m].
    pub place: f64,
    /// Grains whose centres lie in it.
    pub grains: u64,
    /// Their mass [kg].
    pub mass: f64,
    /// Their mass as a share of the mass of all grains whose centres lie in it; not a number without any.
    pub share: f64,
    /// Share of its volume that grains fill; spheres are cut exactly, overlaps not subtracted.
    pub packing_fraction: f64,
    /// Mean velocity by mass [m/s]; not a number without grains.
    pub velocity: DVec3,
    /// Root of the mean square of the deviation from it by mass, over the three directions [m/s].
    pub fluctuation: f64,
}

impl Profile {
    /// Corners of a slice [m].
    fn corners(&self, slice: u32) -> (DVec3, DVec3) {
        let edge = |k: u32| {
            let share = f64::from(k) / f64::from(self.slices);
            self.lower[self.axis] + share * (self.upper[self.axis] - self.lower[self.axis])
        };
        let (mut lower, mut upper) = (self.lower, self.upper);
        (lower[self.axis], upper[self.axis]) = (edge(slice), edge(slice + 1));
        (lower, upper)
    }

    /// The slice that a coordinate on the axis lies in; slices before the first and behind the last are told, too.
    fn slice_of(&self, x: f64) -> i64 {
        let (from, to) = (self.lower[self.axis], self.upper[self.axis]);
        ((x - from) / (to - from) * f64::from(self.slices)).floor() as i64
    }

    /// The slice that a centre lies in; nothing outside of the box.
    fn slice_with(&self, centre: DVec3) -> Option<usize> {
        let inside = centre.cmpge(self.lower).all() && centre.cmplt(self.upper).all();
        let last = i64::from(self.slices) - 1;
        inside.then(|| self.slice_of(centre[self.axis]).clamp(0, last) as usize)
    }

    /// Measures all slices; across periodic sides every image counts that lies in the box, or reaches into it. Grains are summed up in the
    /// order of their ids.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Slice> {
        let grains = &sim.grains;
        let last = i64::from(self.slices) - 1;
        let mut whole = vec![0.0; self.slices as usize];
        let mut slices = vec![Slice::default(); self.slices as usize];
        let mut squares = vec![0.0; slices.len()];
        let centre = |g: usize| sim.comm.wrapped(grains.position[g]);
        let counts = |g: usize| self.selection.holds(grains, origins, g);
        let periods = Periods::of(sim);
        let bounds = (self.lower, self.upper);
        let is_in = |g: usize| periods.any_meets(around(centre(g), grains.radius(g)), bounds);
        let tell = |g: usize| {
            let ball = (centre(g), grains.radius(g));
            (ball, grains.mass(g), counts(g).then_some(grains.velocity[g]))
        };
        let mut add = |(centre, radius): (DVec3, f64), mass: f64, velocity: Option<DVec3>| {
            let slice = self.slice_with(centre);
            if let Some(k) = slice {
                whole[k] += mass;
            }
            let Some(velocity) = velocity else { return };
            let [first, end] = [-radius, radius].map(|reach| self.slice_of(centre[self.axis] + reach));
            for k in first.max(0)..=end.min(last) {
                let (lower, upper) = self.corners(k as u32);
                slices[k as usize].packing_fraction += sphere_in_box(centre, radius, lower, upper);
            }
            if let Some(k) = slice {
                slices[k].grains += 1;
                slices[k].mass += mass;
                slices[k].velocity += velocity * mass;
                squares[k] += velocity.length_squared() * mass;
            }
        };
        each_grain(sim, is_in, tell, |_, ((centre, radius), mass, velocity)| {
            periods.each_image(around(centre, radius), bounds, &mut |shift, faster| {
                add(
                    (centre + shift, radius),
                    mass,
                    velocity.map(|velocity| velocity + faster),
                );
            });
        });
        for (k, (slice, squares)) in slices.iter_mut().zip(squares).enumerate() {
            let (lower, upper) = self.corners(k as u32);
            let size = upper - lower;
            slice.place = 0.5 * (lower[self.axis] + upper[self.axis]);
            slice.packing_fraction /= size.x * size.y * size.z;
            slice.share = slice.mass / whole[k];
            slice.velocity /= slice.mass;
            let mean_square = squares / slice.mass - slice.velocity.length_squared();
            slice.fluctuation = (mean_square.max(0.0) / 3.0).sqrt();
            if slice.grains == 0 {
                slice.fluctuation = f64::NAN;
            }
        }
        slices
    }
}
