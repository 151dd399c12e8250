//! Which way contacts point in a plane: the rose of contact angles.

use super::told_first::counting;
use super::{Fabric, Selection};
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use glam::DVec3;
use std::f64::consts::PI;

/// Most bins of a rose.
pub const MAX_ANGLES: u32 = 3600;

/// A rose: the contacts by the angle of their normal in a plane, 0 to 180 degrees, as a contact has no front.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactAngles {
    /// Unit vector from which angles are counted.
    pub from: DVec3,
    /// Unit vector perpendicular to it, at 90 degrees.
    pub towards: DVec3,
    /// Number of bins.
    pub bins: u32,
    /// Grains whose centres lie elsewhere do not count.
    pub zone: Zone,
    /// Which grains count.
    pub selection: Selection,
    /// Whether contacts with walls count.
    pub with_walls: bool,
}

/// Contacts and their normal forces by bins.
#[derive(Clone, Debug, PartialEq)]
pub struct Rose {
    /// Number of contacts that have a direction in the plane.
    pub contacts: u64,
    /// Share of the contacts in each bin, weighed by how far the normal lies in the plane.
    pub shares: Vec<f64>,
    /// Mean normal force in each bin, weighed in the same way [N].
    pub forces: Vec<f64>,
    /// Which way they point.
    pub preference: Preference,
    /// The same, weighed by the magnitude of the normal force.
    pub force_preference: Preference,
}

/// Which way contacts point in the plane, all together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preference {
    /// Preferred direction [deg], 0 to 180; not a number without any.
    pub direction: f64,
    /// 0 when no direction is preferred, 1 when all normals point along one line.
    pub anisotropy: f64,
}

impl ContactAngles {
    /// Lower edges of the bins [deg].
    pub fn edges(&self) -> Vec<f64> {
        (0..self.bins)
            .map(|k| 180.0 * f64::from(k) / f64::from(self.bins))
            .collect()
    }

    /// Measures the present state.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Rose {
        let fabric = Fabric {
            zone: self.zone.clone(),
            selection: self.selection.clone(),
            threshold: 0.0,
            with_walls: self.with_walls,
        };
        let counts = counting(sim, &self.zone, &self.selection, origins);
        let mut sums = Sums::new(self.bins as usize);
        fabric.each_contact(sim, &counts, |contact| {
            if self.with_walls || !contact.with_wall {
                sums.add(self, contact.normal, contact.force[0], contact.weight());
            }
        });
        sums.rose()
    }
}

/// What contacts come to, bin by bin.
struct Sums {
    contacts: u64,
    weights: Vec<f64>,
    forces: Vec<f64>,
    all: Doubled,
    all_by_force: Doubled,
}

/// Sums over normals by twice their angle, so that fronts do not matter.
#[derive(Clone, Copy, Default)]
struct Doubled {
    weight: f64,
    cosine: f64,
    sine: f64,
}

impl Doubled {
    /// Adds a normal with its parts along and across the direction from which angles are counted.
    fn add(&mut self, (x, y): (f64, f64), weight: f64) {
        self.weight += weight * (x * x + y * y);
        self.cosine += weight * (x * x - y * y);
        self.sine += weight * 2.0 * x * y;
    }

    fn preference(self) -> Preference {
        let length = (self.cosine * self.cosine + self.sine * self.sine).sqrt();
        let direction = libm::atan2(self.sine, self.cosine) * (90.0 / PI);
        Preference {
            direction: match length > 0.0 {
                true if direction < 0.0 => direction + 180.0,
                true => direction,
                false => f64::NAN,
            },
            anisotropy: length / self.weight,
        }
    }
}

impl Sums {
    fn new(bins: usize) -> Self {
        Self {
            contacts: 0,
            weights: vec![0.0; bins],
            forces: vec![0.0; bins],
            all: Doubled::default(),
            all_by_force: Doubled::default(),
        }
    }

    /// Adds a contact of which so many grains count.
    fn add(&mut self, plane: &ContactAngles, normal: DVec3, force: f64, grains: f64) {
        let (x, y) = (normal.dot(plane.from), normal.dot(plane.towards));
        let in_plane = x * x + y * y;
        if in_plane <= 0.0 {
            return;
        }
        let weight = grains * in_plane;
        let angle = libm::atan2(y, x) / PI;
        let turn = if angle < 0.0 { angle + 1.0 } else { angle };
        let bins = self.weights.len();
        let bin = ((turn * bins as f64) as usize) % bins;
        self.contacts += 1;
        self.weights[bin] += weight;
        self.forces[bin] += weight * force;
        self.all.add((x, y), grains);
        self.all_by_force.add((x, y), grains * force.abs());
    }

    fn rose(self) -> Rose {
        let (weights, forces) = (self.weights.iter(), self.forces.iter());
        Rose {
            contacts: self.contacts,
            forces: forces
                .zip(weights.clone())
                .map(|(force, weight)| force / weight)
                .collect(),
            shares: weights.map(|weight| weight / self.all.weight).collect(),
            preference: self.all.preference(),
            force_preference: self.all_by_force.preference(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl ContactAngles {
        fn rose(&self, contacts: impl Iterator<Item = (DVec3, f64)>) -> Rose {
            let mut sums = Sums::new(self.bins as usize);
            contacts.for_each(|(normal, force)| sums.add(self, normal, force, 2.0));
            sums.rose()
        }
    }

    #[test]
    fn a_rose_tells_where_contacts_point() {
        let rose = ContactAngles {
            from: DVec3::X,
            towards: DVec3::Z,
            bins: 18,
            zone: Zone::default(),
            selection: Selection::default(),
            with_walls: true,
        };
        let at = |degrees: f64| {
            let (s, c) = libm::sincos(degrees.to_radians());
            DVec3::new(c, 0.0, s)
        };
        // fronts do not matter, and what is across the plane tells nothing
        let told = rose.rose([(at(32.0), 1.0), (at(212.0), 3.0), (DVec3::Y, 9.0), (at(36.0), 2.0)].into_iter());
        assert_eq!(told.contacts, 3);
        assert!((told.shares[3] - 1.0).abs() < 1e-12 && (told.forces[3] - 2.0).abs() < 1e-12);
        let near = |told: Preference, degrees: f64| (told.direction - degrees).abs() < 0.01 && told.anisotropy > 0.99;
        assert!(near(told.preference, 33.333) && near(told.force_preference, 33.333));
        let all = rose.rose((0..180).map(|k| (at(f64::from(k) + 0.5), 1.0)));
        assert!(all.shares.iter().all(|share| (share - 1.0 / 18.0).abs() < 1e-12));
        assert!(all.preference.anisotropy < 1e-12 && all.force_preference.anisotropy < 1e-12);
        // as many contacts along x as along z, and forces along z alone: pushes and pulls weigh alike
        let pressed = rose.rose([(at(0.0), 1.0), (at(90.0), 3.0), (at(0.0), 1.0), (at(90.0), -3.0)].into_iter());
        assert!(pressed.preference.anisotropy < 1e-12);
        let by_force = pressed.force_preference;
        assert!((by_force.direction - 90.0).abs() < 1e-9 && (by_force.anisotropy - 0.5).abs() < 1e-12);
        assert_eq!(rose.edges()[17], 170.0);
        assert!(rose.rose(std::iter::empty()).preference.direction.is_nan());
    }
}
