#![doc = include_str!("linear_history.md")]

use super::{Tangential, TangentialInput, TangentialResponse};
use crate::contact::spring::{Carried, SpringInput, advance_spring, compliance, dashpot, spring_energy};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::params;

params! {
    /// Parameters of the linear tangential spring.
    pub struct LinearHistoryParameters {
        friction: NONE, required 0.3, in Range::NOT_NEGATIVE, "Coefficient of friction";
        stiffness: STIFFNESS, required 2e3, in Range::POSITIVE, "Tangential stiffness, force per elongation";
        damping_ratio: NONE, default 0.1, in Range::SHARE,
            "Share of critical damping of the tangential spring";
    }
}

/// The linear tangential spring bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearHistory {
    parameters: LinearHistoryParameters,
}

impl Tangential for LinearHistory {
    const NAME: &'static str = "linear-history";
    const SUMMARY: &'static str = "linear tangential spring with history and Coulomb slider";
    const DOC: &'static str = include_str!("linear_history.md");
    const PARAMETERS: &'static [ParameterInfo] = LinearHistoryParameters::TABLE;
    const HISTORY: &'static [Dimension] = &[
        Dimension::FORCE,
        Dimension::FORCE,
        Dimension::FORCE,
        Dimension::COMPLIANCE,
    ];

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        Ok(Self {
            parameters: LinearHistoryParameters::from_values(values)?,
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
        let p = &self.parameters;
        let (stiffness, compliance) = (L::splat(p.stiffness), L::splat(compliance(p.stiffness)));
        let spring = SpringInput {
            normal: input.normal,
            rate: input.velocity,
            spin: input.spin,
            stiffness,
            compliance,
            damping: dashpot(p.damping_ratio, stiffness, input.size.tangential_mass()),
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
    fn stiffness(&self, _size: PairSize, _overlap: f64) -> f64 {
        self.parameters.stiffness
    }
}
