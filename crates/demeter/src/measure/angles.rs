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
    weight: f64,
    /// Sums of the cosine and sine of twice the angle.
    double: [f64; 2],
}

impl Sums {
    fn new(bins: usize) -> Self {
        Self {
            contacts: 0,
            weights: vec![0.0; bins],
            forces: vec![0.0; bins],
            weight: 0.0,
            double: [0.0; 2],
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
        self.weight += weight;
        self.weights[bin] += weight;
        self.forces[bin] += weight * force;
        self.double[0] += grains * (x * x - y * y);
        self.double[1] += grains * 2.0 * x * y;
    }

    fn rose(self) -> Rose {
        let (weights, forces) = (self.weights.iter(), self.forces.iter());
        let [x, y] = self.double;
        let length = (x * x + y * y).sqrt();
        let direction = libm::atan2(y, x) * (90.0 / PI);
        Rose {
            contacts: self.contacts,
            forces: forces
                .zip(weights.clone())
                .map(|(force, weight)| force / weight)
                .collect(),
            shares: weights.map(|weight| weight / self.weight).collect(),
            direction: match length > 0.0 {
                true if direction < 0.0 => direction + 180.0,
                true => direction,
                false => f64::NAN,
            },
            anisotropy: length / self.weight,
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
        assert!((told.direction - 33.333).abs() < 0.01 && told.anisotropy > 0.99);
        let all = rose.rose((0..180).map(|k| (at(f64::from(k) + 0.5), 1.0)));
        assert!(all.shares.iter().all(|share| (share - 1.0 / 18.0).abs() < 1e-12));
        assert!(all.anisotropy < 1e-12);
        assert_eq!(rose.edges()[17], 170.0);
        assert!(rose.rose(std::iter::empty()).direction.is_nan());
    }
}
