//! Profiles in a cylinder: rings about its axis or slices along it, with velocities along the radius, around the axis and along it.

use super::Selection;
use super::images::{Periods, around, around_cylinder};
use super::told_first::each_grain;
use crate::particles::Origins;
use crate::simulation::Simulation;
use glam::DVec3;
use std::f64::consts::PI;

/// Places and weights of Gauss and Legendre on [-1, 1], the upper half of 16.
const GAUSS: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_73),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
];

/// Which way the bins of a profile follow each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// Rings of equal width, from the axis outwards.
    Radius,
    /// Slices from the start of the axis to its end.
    Axis,
}

/// Rings or slices of a cylinder.
#[derive(Clone, Debug, PartialEq)]
pub struct CylinderProfile {
    /// Start of the axis [m].
    pub start: DVec3,
    /// End of the axis [m].
    pub end: DVec3,
    /// Radius [m].
    pub radius: f64,
    /// Which way the bins follow each other.
    pub along: Along,
    /// Number of bins.
    pub bins: u32,
    /// Which grains count.
    pub selection: Selection,
}

/// A ring or a slice.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ring {
    /// Middle of the bin, from the axis or from its start [m].
    pub place: f64,
    /// Grains whose centres lie in it.
    pub grains: u64,
    /// Their mass [kg].
    pub mass: f64,
    /// Mass of the grains that count as a share of the mass of all whose centres lie in it.
    pub share: f64,
    /// Share of its volume that grains fill, to 1e-3; overlaps not subtracted.
    pub packing_fraction: f64,
    /// Mean velocity by mass: outwards, around the axis (right-handed) and along it [m/s]; not a number without grains.
    pub velocity: DVec3,
    /// Root of the mean square of the deviation from it by mass, over the three directions [m/s].
    pub fluctuation: f64,
}

impl CylinderProfile {
    /// Radii and heights between which a bin lies [m].
    fn limits(&self, bin: usize) -> ([f64; 2], [f64; 2]) {
        let length = (self.end - self.start).length();
        let edge = |k: usize, whole: f64| whole * k as f64 / f64::from(self.bins);
        match self.along {
            Along::Radius => ([edge(bin, self.radius), edge(bin + 1, self.radius)], [0.0, length]),
            Along::Axis => ([0.0, self.radius], [edge(bin, length), edge(bin + 1, length)]),
        }
    }

    /// Measures all bins; across periodic sides every image counts that lies in the cylinder, or reaches into it. Grains are summed up in
    /// the order of their ids.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Ring> {
        let grains = &sim.grains;
        let axis = (self.end - self.start).normalize();
        let mut rings = vec![Ring::default(); self.bins as usize];
        let (mut squares, mut whole) = (vec![0.0; rings.len()], vec![0.0; rings.len()]);
        let limits: Vec<([f64; 2], [f64; 2])> = (0..rings.len()).map(|k| self.limits(k)).collect();
        let periods = Periods::of(sim);
        let bounds = around_cylinder(self.start, self.end, self.radius);
        let centre = |g: usize| sim.comm.wrapped(grains.position[g]);
        let is_in = |g: usize| periods.any_meets(around(centre(g), grains.radius(g)), bounds);
        let tell = |g: usize| {
            let velocity = self.selection.holds(grains, origins, g).then_some(grains.velocity[g]);
            ((centre(g), grains.radius(g)), grains.mass(g), velocity)
        };
        let mut add = |(away, radius): (DVec3, f64), mass: f64, velocity: Option<DVec3>| {
            let height = away.dot(axis);
            let outwards = away - axis * height;
            let distance = outwards.length();
            let bin = self.bin_of(distance, height);
            if let Some(bin) = bin {
                whole[bin] += mass;
            }
            let Some(v) = velocity else { return };
            match self.along {
                Along::Axis => {
                    for (ring, &(radii, heights)) in rings.iter_mut().zip(&limits) {
                        if heights[1] > height - radius && heights[0] < height + radius {
                            ring.packing_fraction += sphere_in_cylinder(distance, height, radius, radii[1], heights);
                        }
                    }
                }
                Along::Radius => {
                    let mut within = 0.0;
                    let first = limits.partition_point(|(radii, _)| radii[1] <= distance - radius);
                    for (ring, &(radii, heights)) in rings.iter_mut().zip(&limits).skip(first) {
                        if radii[0] >= distance + radius {
                            break;
                        }
                        let inner = within;
                        within = sphere_in_cylinder(distance, height, radius, radii[1], heights);
                        ring.packing_fraction += within - inner;
                    }
                }
            }
            if let Some(bin) = bin {
                let out = if distance > 0.0 {
                    outwards / distance
                } else {
                    DVec3::ZERO
                };
                let velocity = DVec3::new(v.dot(out), v.dot(axis.cross(out)), v.dot(axis));
                let ring = &mut rings[bin];
                ring.grains += 1;
                ring.mass += mass;
                ring.velocity += velocity * mass;
                squares[bin] += velocity.length_squared() * mass;
            }
        };
        each_grain(sim, is_in, tell, |_, ((centre, radius), mass, velocity)| {
            periods.each_image(around(centre, radius), bounds, &mut |shift, faster| {
                let away = centre + shift - self.start;
                add((away, radius), mass, velocity.map(|velocity| velocity + faster));
            });
        });
        for (k, ring) in rings.iter_mut().enumerate() {
            let (radii, heights) = limits[k];
            let area = PI * (radii[1] * radii[1] - radii[0] * radii[0]);
            let between = if self.along == Along::Radius { radii } else { heights };
            ring.place = 0.5 * (between[0] + between[1]);
            ring.packing_fraction /= area * (heights[1] - heights[0]);
            ring.share = ring.mass / whole[k];
            ring.velocity /= ring.mass;
            let mean_square = squares[k] / ring.mass - ring.velocity.length_squared();
            ring.fluctuation = match ring.grains {
                0 => f64::NAN,
                _ => (mean_square.max(0.0) / 3.0).sqrt(),
            };
        }
        rings
    }

    fn bin_of(&self, distance: f64, height: f64) -> Option<usize> {
        let length = (self.end - self.start).length();
        if !(distance < self.radius && height >= 0.0 && height < length) {
            return None;
        }
        let share = match self.along {
            Along::Radius => distance / self.radius,
            Along::Axis => height / length,
        };
        Some(((share * f64::from(self.bins)) as usize).min(self.bins as usize - 1))
    }
}

/// Volume of the part of a sphere within a cylinder of a radius and between two heights along its axis [m^3].
fn sphere_in_cylinder(distance: f64, height: f64, radius: f64, cylinder: f64, heights: [f64; 2]) -> f64 {
    let (from, to) = ((heights[0] - height).max(-radius), (heights[1] - height).min(radius));
    if to <= from {
        return 0.0;
    }
    let area = |s: f64| {
        let cut = (radius * radius - s * s).max(0.0).sqrt();
        common_area(cut, cylinder, distance)
    };
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let sum = |(x, w): &(f64, f64)| w * (area(middle - half * x) + area(middle + half * x));
    half * GAUSS.iter().map(sum).sum::<f64>()
}

/// Area that two circles share, by their radii and the distance of their centres [m^2].
fn common_area(a: f64, b: f64, distance: f64) -> f64 {
    if distance >= a + b || a <= 0.0 || b <= 0.0 {
        return 0.0;
    }
    let small = a.min(b);
    if distance <= (a - b).abs() {
        return PI * small * small;
    }
    let angle = |r: f64, other: f64| {
        let cosine = (distance * distance + r * r - other * other) / (2.0 * distance * r);
        libm::acos(cosine.clamp(-1.0, 1.0))
    };
    let kite = (a + b - distance) * (distance + a - b) * (distance - a + b) * (distance + a + b);
    a * a * angle(a, b) + b * b * angle(b, a) - 0.5 * kite.max(0.0).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_a_sphere_are_its_whole_and_its_caps() {
        let ball = 4.0 / 3.0 * PI;
        let whole = sphere_in_cylinder(0.3, 5.0, 1.0, 9.0, [0.0, 10.0]);
        assert!((whole / ball - 1.0).abs() < 1e-12, "{whole}");
        let half = sphere_in_cylinder(0.3, 5.0, 1.0, 9.0, [5.0, 10.0]);
        assert!((half / ball - 0.5).abs() < 1e-12);
        // a bore of radius 0.6 through the middle leaves 4/3 pi 0.8^3
        let [all, bore] = [2.0, 0.6].map(|cylinder| sphere_in_cylinder(0.0, 0.0, 1.0, cylinder, [-2.0, 2.0]));
        assert!(((all - bore) / (ball * 0.512) - 1.0).abs() < 1e-2, "{all} {bore}");
        assert!((common_area(1.0, 1.0, 0.0) - PI).abs() < 1e-15);
        assert_eq!(common_area(1.0, 1.0, 2.0), 0.0);
        // a lens of two unit circles at distance 1: 2 pi/3 - sqrt(3)/2
        assert!((common_area(1.0, 1.0, 1.0) - (2.0 * PI / 3.0 - 0.75f64.sqrt())).abs() < 1e-14);
    }
}
