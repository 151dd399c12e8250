#![doc = include_str!("half_space.md")]

use super::{ContactPair, Material, MultiContact};
use crate::contact::MaterialPair;
use crate::lanes::Lanes;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::params;

params! {
    /// Parameters of the elastic half-space.
    pub struct HalfSpaceParameters {
        prefactor: NONE, default 1.0, in Range::NOT_NEGATIVE, "Prefactor gamma of all displacements";
    }
}

/// Elastic half-space bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace {
    grain: Material,
    prefactor: f64,
}

/// Least `1 + n_k.u`.
const LEAST_DENOMINATOR: f64 = 0.5;

impl MultiContact for HalfSpace {
    const NAME: &'static str = "half-space";
    const SUMMARY: &'static str = "point forces on an elastic half-space (MC-DEM, Brodu et al.)";
    const DOC: &'static str = include_str!("half_space.md");
    const PARAMETERS: &'static [ParameterInfo] = HalfSpaceParameters::TABLE;
    const FEELS_LEVERS: bool = true;

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = HalfSpaceParameters::from_values(values)?;
        Ok(Self {
            grain: Material::new(pair),
            prefactor: p.prefactor,
        })
    }

    #[inline(always)]
    fn is_mutual(&self) -> bool {
        self.grain.poisson_ratio == 0.5
    }

    #[inline(always)]
    fn influence<L: Lanes>(&self, at: &ContactPair<L>) -> L {
        let (compliance, nu) = self.grain.terms();
        let (cosine, from, to) = (at.cosine, at.source_lever, at.target_lever);
        // the same to the bit where both are exchanged, so that it need not be found twice then
        let distance = (from * from + to * to - from * to * (cosine * 2.0))
            .max(at.least_distance_squared)
            .sqrt();
        let inverse = L::splat(1.0) / distance;
        let source_slope = (from - to * cosine) * inverse;
        let target_slope = (from * cosine - to) * inverse;
        let last = (cosine + target_slope) / (source_slope + 1.0).max(L::splat(LEAST_DENOMINATOR));
        let braces = source_slope * target_slope + cosine * (3.0 - 4.0 * nu) - last * (1.0 - 2.0 * nu);
        inverse * braces * (-self.prefactor * compliance)
    }

    fn largest_bulge(&self, _radius: f64, least_lever: f64) -> f64 {
        // opposite the force
        let (compliance, nu) = self.grain.terms();
        self.prefactor * compliance * (3.0 - 2.0 * nu) / (2.0 * least_lever)
    }

    fn largest_pull(&self, _radius: f64, least_distance: f64) -> f64 {
        // |n_k + u| <= sqrt(2 (1 + n_k.u)), so the last term is at most 2 (1 - 2 nu)
        let (compliance, nu) = self.grain.terms();
        self.prefactor * compliance * (6.0 - 8.0 * nu) / least_distance
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Elastic;
    use approx::assert_relative_eq;
    use glam::DVec3;

    fn law(poisson_ratio: f64) -> HalfSpace {
        let m = Elastic {
            young_modulus: 1.0,
            poisson_ratio,
        };
        HalfSpace::new(&Values::new(), &MaterialPair { a: m, b: m }).unwrap()
    }

    /// Eq 1 in vectors.
    fn vectors(nu: f64, from: DVec3, to: DVec3) -> f64 {
        let (n_k, n_c) = (-from.normalize(), -to.normalize());
        let d = (to - from).length();
        let u = (to - from) / d;
        let last = (n_k + u).dot(n_c) / (1.0 + n_k.dot(u));
        -(1.0 + nu) / (2.0 * std::f64::consts::PI * d)
            * (n_k.dot(u) * n_c.dot(u) + (3.0 - 4.0 * nu) * n_k.dot(n_c) - (1.0 - 2.0 * nu) * last)
    }

    fn contacts(from: DVec3, to: DVec3) -> ContactPair {
        ContactPair {
            cosine: from.normalize().dot(to.normalize()),
            source_lever: from.length(),
            target_lever: to.length(),
            least_distance_squared: 0.01,
            radius: 1.0,
        }
    }

    #[test]
    fn general_positions() {
        let (p0, p1) = (DVec3::new(0.1, -0.2, -0.95), DVec3::new(0.85, 0.3, 0.25));
        for (nu, from, to, expected) in [
            (0.5, p0, p1, 0.135_027_072_165_4),
            (0.3, p0, p1, 0.111_753_066_5),
            (0.3, p1, p0, 0.110_747_598_7),
        ] {
            let found = law(nu).influence(&contacts(from, to));
            assert_relative_eq!(found, expected, max_relative = 1e-9);
            assert_relative_eq!(found, vectors(nu, from, to), max_relative = 1e-13);
        }
    }

    #[test]
    fn nothing_bulges_beyond_the_bounds() {
        for nu in [-0.5, 0.0, 0.2, 0.3, 0.5] {
            let law = law(nu);
            for levers in [(1.0, 1.0), (0.7, 0.7), (0.7, 1.0), (1.0, 0.7), (0.85, 1.1), (1.1, 0.85)] {
                for step in 0..=2000 {
                    let cosine = -1.0 + f64::from(step) / 1000.0;
                    let at = ContactPair {
                        cosine,
                        source_lever: levers.0,
                        target_lever: levers.1,
                        least_distance_squared: 0.04,
                        radius: 1.0,
                    };
                    let influence = law.influence(&at);
                    let bulge = law.largest_bulge(1.0, f64::min(levers.0, levers.1));
                    assert!(
                        influence <= bulge * (1.0 + 1e-12),
                        "{nu} {levers:?} {cosine} {influence} {bulge}"
                    );
                    let pull = law.largest_pull(1.0, 0.2);
                    assert!(-influence <= pull * (1.0 + 1e-12), "{nu} {levers:?} {cosine}");
                }
            }
        }
    }
}
