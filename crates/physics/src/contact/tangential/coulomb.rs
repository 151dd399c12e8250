#![doc = include_str!("coulomb.md")]

use super::{Tangential, TangentialInput, TangentialResponse};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::params;

params! {
    /// Parameters of saturated Coulomb friction.
    pub struct CoulombParameters {
        friction: NONE, required 0.3, in Range::NOT_NEGATIVE, "Coefficient of friction";
    }
}

/// Saturated Coulomb friction bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coulomb {
    friction: f64,
}

impl Tangential for Coulomb {
    const NAME: &'static str = "coulomb";
    const SUMMARY: &'static str = "saturated Coulomb friction, F_t = mu F_n against sliding";
    const DOC: &'static str = include_str!("coulomb.md");
    const PARAMETERS: &'static [ParameterInfo] = CoulombParameters::TABLE;
    const HISTORY: &'static [Dimension] = &[];

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = CoulombParameters::from_values(values)?;
        Ok(Self { friction: p.friction })
    }

    #[inline(always)]
    fn respond(&self, input: &TangentialInput, _history: &mut [f64]) -> TangentialResponse {
        let speed = input.velocity.length();
        let sliding = self.friction * input.normal_force;
        // force per speed, the smaller of the two branches: no division by a vanishing speed
        let sticking = input.removable_share * input.tangential_mass / input.dt;
        let coefficient = if sliding < sticking * speed {
            sliding / speed
        } else {
            sticking
        };
        let coefficient = if sliding > 0.0 { coefficient } else { 0.0 };
        let force = -input.velocity * coefficient;
        TangentialResponse {
            force,
            dissipated: coefficient * speed * speed * input.dt,
        }
    }

    #[inline(always)]
    fn energy(&self, _history: &[f64]) -> f64 {
        0.0
    }

    #[inline(always)]
    fn stiffness(&self, _size: PairSize, _overlap: f64) -> f64 {
        0.0
    }
}
