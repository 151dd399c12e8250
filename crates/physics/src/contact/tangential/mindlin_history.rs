#![doc = include_str!("mindlin_history.md")]

use super::{Tangential, TangentialInput, TangentialResponse};
use crate::contact::spring::{Carried, SpringInput, advance_spring, spring_energy};
use crate::contact::{MaterialPair, PairSize, TANGENTIAL_SHARE};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::params;

params! {
    /// Parameters of Mindlin friction.
    pub struct MindlinHistoryParameters {
        friction: NONE, required 0.3, in Range::NOT_NEGATIVE, "Coefficient of friction";
        damping_ratio: NONE, default 0.1, in Range::SHARE,
            "Share of critical damping of the tangential spring";
    }
}

/// Mindlin friction bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MindlinHistory {
    parameters: MindlinHistoryParameters,
    /// `8 G` [Pa].
    modulus: f64,
    /// Its inverse [1/Pa].
    inverse: f64,
    /// Coefficient of the dashpot over `sqrt(m a)` with the radius `a` of contact: `2 zeta sqrt(8 G m_t/m)`.
    dashpot: f64,
}

impl Tangential for MindlinHistory {
    const NAME: &'static str = "mindlin-history";
    const SUMMARY: &'static str = "Mindlin friction in rate form, no force jump on unloading";
    const DOC: &'static str = include_str!("mindlin_history.md");
    const PARAMETERS: &'static [ParameterInfo] = MindlinHistoryParameters::TABLE;
    const HISTORY: &'static [Dimension] = &[
        Dimension::FORCE,
        Dimension::FORCE,
        Dimension::FORCE,
        Dimension::COMPLIANCE,
    ];

    fn new(values: &Values, pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let parameters = MindlinHistoryParameters::from_values(values)?;
        let modulus = 8.0 * pair.effective_shear_modulus();
        Ok(Self {
            parameters,
            modulus,
            inverse: 1.0 / modulus,
            dashpot: 2.0 * parameters.damping_ratio * (modulus * TANGENTIAL_SHARE).sqrt(),
        })
    }

    const WIDE: bool = true;
    const REMEMBERS_A_SPRING: bool = true;

    #[inline(always)]
    fn respond(&self, input: &TangentialInput, history: &mut [f64]) -> TangentialResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &TangentialInput<L>, history: &mut [L]) -> TangentialResponse<L> {
        self.respond_carried(input, history, None)
    }

    #[inline(always)]
    fn respond_carried<L: Lanes>(
        &self,
        input: &TangentialInput<L>,
        history: &mut [L],
        carried: Option<Carried<L>>,
    ) -> TangentialResponse<L> {
        // the roots and the quotient are those of the spring of Hertz
        let radius = (input.size.radius * input.overlap).sqrt();
        let spring = SpringInput {
            normal: input.normal,
            rate: input.velocity,
            spin: input.spin,
            stiffness: radius * self.modulus,
            compliance: ((L::splat(1.0) / radius) * self.inverse).keep(radius.gt(L::splat(0.0))),
            damping: (input.size.mass * radius).sqrt() * self.dashpot,
            limit: self.limit(input.normal_force),
            dt: input.dt,
        };
        let response = advance_spring(&spring, history, carried);
        TangentialResponse {
            force: response.load,
            dissipated: response.dissipated,
        }
    }

    #[inline(always)]
    fn limit<L: Lanes>(&self, normal_force: L) -> L {
        normal_force * self.parameters.friction
    }

    fn damping_ratio(&self) -> f64 {
        self.parameters.damping_ratio
    }

    #[inline(always)]
    fn energy(&self, history: &[f64]) -> f64 {
        spring_energy(history)
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, overlap: f64) -> f64 {
        (size.radius * overlap.max(0.0)).sqrt() * self.modulus
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::Elastic;
    use crate::contact::normal::{HertzTsuji, Normal};
    use crate::parameters::values;
    use approx::assert_relative_eq;

    #[test]
    fn stiffness_against_that_of_hertz() {
        // Mindlin (1949): for equal bodies k_t/k_n = 2 (1 - nu)/(2 - nu), at any overlap and size
        for poisson_ratio in [0.0, 0.2, 0.3, 0.5] {
            let material = Elastic {
                young_modulus: 7e9,
                poisson_ratio,
            };
            let pair = MaterialPair {
                a: material,
                b: material,
            };
            let normal = HertzTsuji::new(&values(&[("restitution", 0.5)]), &pair).unwrap();
            let tangential = MindlinHistory::new(&values(&[("friction", 0.5)]), &pair).unwrap();
            for (radius, overlap) in [(1e-3, 1e-6), (0.2, 1e-3)] {
                let size = PairSize::new(radius, 1.0);
                let ratio = tangential.stiffness(size, overlap) / normal.stiffness(size, overlap, &[]);
                let expected = 2.0 * (1.0 - poisson_ratio) / (2.0 - poisson_ratio);
                assert_relative_eq!(ratio, expected, max_relative = 1e-14);
            }
        }
    }
}
