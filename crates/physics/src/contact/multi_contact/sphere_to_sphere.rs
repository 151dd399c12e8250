#![doc = include_str!("sphere_to_sphere.md")]

use super::{ContactPair, Material, MultiContact};
use crate::contact::MaterialPair;
use crate::lanes::Lanes;
use crate::parameters::{ParameterError, ParameterInfo, Values};
use crate::params;

params! {
    /// Parameters of spheres pressed on each other: none.
    pub struct SphereToSphereParameters {}
}

/// Spheres pressed on each other, bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereToSphere {
    grain: Material,
}

impl MultiContact for SphereToSphere {
    const NAME: &'static str = "sphere-to-sphere";
    const SUMMARY: &'static str = "approximate displacements of spheres pressed on each other (Gonzalez and Cuitino)";
    const DOC: &'static str = include_str!("sphere_to_sphere.md");
    const PARAMETERS: &'static [ParameterInfo] = SphereToSphereParameters::TABLE;
    const FEELS_LEVERS: bool = false;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        SphereToSphereParameters::from_values(values)?;
        Ok(Self {
            grain: Material::new(pair),
        })
    }

    #[inline(always)]
    fn influence<L: Lanes>(&self, at: &ContactPair<L>) -> L {
        let (compliance, nu) = self.grain.terms();
        let half = L::splat(0.5) / at.radius;
        let least = at.least_distance_squared * (half * half);
        let sine = ((L::splat(1.0) - at.cosine) * 0.5).max(least).sqrt();
        let bracket = L::splat(-2.0 * (1.0 - nu)) / sine - 2.0 * (1.0 - 2.0 * nu) + sine * (7.0 - 8.0 * nu);
        half * bracket * compliance
    }

    fn largest_bulge(&self, radius: f64, _least_lever: f64) -> f64 {
        // the bracket grows with the angle
        let (compliance, nu) = self.grain.terms();
        compliance / (2.0 * radius) * (3.0 - 2.0 * nu)
    }

    fn largest_pull(&self, radius: f64, least_distance: f64) -> f64 {
        let (compliance, nu) = self.grain.terms();
        compliance * (2.0 * (1.0 - nu) / least_distance + (1.0 - 2.0 * nu) / radius)
    }
}

#[cfg(test)]
mod tests {
    use super::super::HalfSpace;
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

    fn on_the_sphere(degrees: f64, radius: f64) -> ContactPair {
        ContactPair {
            cosine: libm::cos(degrees * PI / 180.0),
            source_lever: radius,
            target_lever: radius,
            least_distance_squared: 0.01 * radius * radius,
            radius,
        }
    }

    #[test]
    fn reference_values() {
        for (nu, degrees, expected) in [
            (0.5, 30.0, -3.087_246_170),
            (0.5, 90.0, std::f64::consts::FRAC_1_SQRT_2),
            (0.5, 150.0, 1.862_501_298),
            (0.5, 180.0, 2.0),
            (0.3, 90.0, 0.472_792_206_1),
        ] {
            let law = SphereToSphere::new(&Values::new(), &pair(nu)).unwrap();
            let found = law.influence(&on_the_sphere(degrees, 1.0));
            assert_relative_eq!(found * 4.0 * PI / (1.0 + nu), expected, max_relative = 1e-9);
        }
    }

    #[test]
    fn is_the_half_space_with_contacts_on_the_undeformed_sphere() {
        for nu in [-0.3, 0.0, 0.3, 0.5] {
            let spheres = SphereToSphere::new(&Values::new(), &pair(nu)).unwrap();
            let half_space = HalfSpace::new(&Values::new(), &pair(nu)).unwrap();
            for degrees in [20.0, 60.0, 77.0, 120.0, 180.0] {
                let at = on_the_sphere(degrees, 0.3);
                let (one, other) = (spheres.influence(&at), half_space.influence(&at));
                assert_relative_eq!(one, other, max_relative = 1e-12, epsilon = 1e-13);
                let bulge = spheres.largest_bulge(0.3, 0.3);
                assert!(one <= bulge * (1.0 + 1e-12) && -one <= spheres.largest_pull(0.3, 0.03));
            }
        }
    }
}
