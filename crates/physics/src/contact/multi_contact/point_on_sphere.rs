#![doc = include_str!("point_on_sphere.md")]

mod series;
mod table;

use super::{ContactPair, Material, MultiContact};
use crate::contact::MaterialPair;
use crate::lanes::Lanes;
use crate::parameters::{ParameterError, ParameterInfo, Values};
use crate::params;
use table::Displacements;

params! {
    /// Parameters of a point force on a sphere: none.
    pub struct PointOnSphereParameters {}
}

/// Point force on a sphere, bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointOnSphere {
    grain: Material,
    displacements: &'static Displacements,
}

impl MultiContact for PointOnSphere {
    const NAME: &'static str = "point-on-sphere";
    const SUMMARY: &'static str = "exact displacements of a sphere under point forces (Bondareva)";
    const DOC: &'static str = include_str!("point_on_sphere.md");
    const PARAMETERS: &'static [ParameterInfo] = PointOnSphereParameters::TABLE;
    const FEELS_LEVERS: bool = false;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        PointOnSphereParameters::from_values(values)?;
        Ok(Self {
            grain: Material::new(pair),
            displacements: Displacements::of(pair.a.poisson_ratio),
        })
    }

    #[inline(always)]
    fn influence<L: Lanes>(&self, at: &ContactPair<L>) -> L {
        let (compliance, _) = self.grain.terms();
        let half = L::splat(0.5) / at.radius;
        let square = ((L::splat(1.0) - at.cosine) * 0.5).max(at.least_distance_squared * (half * half));
        half * self.displacements.at(square) * compliance
    }

    fn largest_bulge(&self, radius: f64, _least_lever: f64) -> f64 {
        let (compliance, _) = self.grain.terms();
        0.5 * compliance / radius * self.displacements.largest()
    }

    fn largest_pull(&self, radius: f64, least_distance: f64) -> f64 {
        let (compliance, _) = self.grain.terms();
        let sine = 0.5 * least_distance / radius;
        0.5 * compliance / radius * self.displacements.deepest_from(sine * sine)
    }
}

#[cfg(test)]
mod tests {
    use super::super::SphereToSphere;
    use super::*;
    use crate::contact::Elastic;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    fn pair(poisson_ratio: f64) -> MaterialPair {
        let m = Elastic {
            young_modulus: 1.0,
            poisson_ratio,
        };
        MaterialPair { a: m, b: m }
    }

    fn on_the_sphere(degrees: f64) -> ContactPair {
        ContactPair {
            cosine: libm::cos(degrees * PI / 180.0),
            source_lever: 1.0,
            target_lever: 1.0,
            least_distance_squared: 1e-10,
            radius: 1.0,
        }
    }

    #[test]
    fn reference_values() {
        for (nu, degrees, expected) in [
            (0.5, 30.0, -0.550_002_591_199_851),
            (0.5, 90.0, 0.867_939_903_700_365_8),
            (0.5, 150.0, -1.097_410_085_884_511_3),
            (0.5, 180.0, -1.478_487_789_915_240_7),
            (0.3, 90.0, 0.781_424_743_318_310_7),
        ] {
            let law = PointOnSphere::new(&Values::new(), &pair(nu)).unwrap();
            let found = law.influence(&on_the_sphere(degrees));
            assert_relative_eq!(found * 4.0 * PI / (1.0 + nu), expected, max_relative = 1e-12);
        }
    }

    #[test]
    fn is_the_half_space_near_the_force() {
        for nu in [-0.3, 0.0, 0.3, 0.5] {
            let exact = PointOnSphere::new(&Values::new(), &pair(nu)).unwrap();
            let near = SphereToSphere::new(&Values::new(), &pair(nu)).unwrap();
            for degrees in [0.003, 0.03, 0.3] {
                let at = on_the_sphere(degrees);
                let (one, other) = (exact.influence(&at), near.influence(&at));
                // what is left grows as the logarithm of the angle
                let share = 2.0 * libm::log(degrees).abs() * degrees * PI / 180.0 + 5e-2 * degrees;
                assert!(
                    (one - other).abs() <= share * one.abs(),
                    "{nu} {degrees}: {one} {other}"
                );
            }
        }
    }

    /// Pressure all around is a sum over all directions: it leaves the volume to shrink by `3 (1 - 2 nu)/E` of it.
    #[test]
    fn pressure_all_around_shrinks_the_sphere() {
        for nu in [-0.5, 0.0, 0.3, 0.5] {
            let law = PointOnSphere::new(&Values::new(), &pair(nu)).unwrap();
            // mean over the sphere, uniform in the cosine; s^2 substituted so that 1/s is smooth
            let steps = 20_000;
            let mean: f64 = (0..steps)
                .map(|k| {
                    let sine = (f64::from(k) + 0.5) / f64::from(steps);
                    let at = ContactPair {
                        cosine: 1.0 - 2.0 * sine * sine,
                        ..on_the_sphere(0.0)
                    };
                    2.0 * sine * law.influence(&at) / f64::from(steps)
                })
                .sum();
            let expected = -(1.0 - 2.0 * nu) / (4.0 * PI);
            assert!((mean - expected).abs() < 1e-7, "{nu}: {mean} {expected}");
        }
    }
}
