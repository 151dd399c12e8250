#![doc = include_str!("coulomb.md")]

use super::{Tangential, TangentialInput, TangentialResponse};
use crate::contact::slider::resist;
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
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

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &TangentialInput, history: &mut [f64]) -> TangentialResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &TangentialInput<L>, _history: &mut [L]) -> TangentialResponse<L> {
        let limit = self.limit(input.normal_force);
        let stopping = input.size.tangential_mass() * (input.removable_share / input.dt);
        let response = resist(input.velocity, limit, stopping, input.dt);
        TangentialResponse {
            force: response.load,
            dissipated: response.dissipated,
        }
    }

    #[inline(always)]
    fn limit<L: Lanes>(&self, normal_force: L) -> L {
        normal_force * self.friction
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
