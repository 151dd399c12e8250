#![doc = include_str!("epsd.md")]

use super::{Rolling, RollingInput, RollingResponse};
use crate::contact::spring::{SpringInput, advance_spring, compliance, dashpot, spring_energy};
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::params;

params! {
    /// Parameters of the elastic-plastic spring-dashpot against rolling.
    pub struct EpsdParameters {
        rolling_friction: NONE, required 0.05, in Range::NOT_NEGATIVE, "Coefficient of rolling friction";
        damping_ratio: NONE, default 0.3, in Range::SHARE,
            "Share of critical damping of the rolling spring";
    }
}

/// The elastic-plastic spring-dashpot bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Epsd {
    parameters: EpsdParameters,
}

impl Rolling for Epsd {
    const NAME: &'static str = "epsd";
    const SUMMARY: &'static str = "elastic-plastic spring-dashpot against rolling";
    const DOC: &'static str = include_str!("epsd.md");
    const PARAMETERS: &'static [ParameterInfo] = EpsdParameters::TABLE;
    const HISTORY: &'static [Dimension] = &[
        Dimension::ENERGY,
        Dimension::ENERGY,
        Dimension::ENERGY,
        Dimension::ROLLING_COMPLIANCE,
    ];

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        Ok(Self {
            parameters: EpsdParameters::from_values(values)?,
        })
    }

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &RollingInput, history: &mut [f64]) -> RollingResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &RollingInput<L>, history: &mut [L]) -> RollingResponse<L> {
        let spring = self.driven(input, input.angular_velocity, input.rolling_inertia);
        let response = advance_spring(&spring, history, None);
        RollingResponse {
            torque: response.load,
            dissipated: response.dissipated,
        }
    }

    fn damping_ratio(&self) -> f64 {
        self.parameters.damping_ratio
    }

    #[inline(always)]
    fn energy(&self, history: &[f64]) -> f64 {
        spring_energy(history)
    }

    #[inline(always)]
    fn stiffness(&self, size: PairSize, normal_stiffness: f64) -> f64 {
        self.spring(size, normal_stiffness)
    }
}

impl Epsd {
    pub(super) fn of(rolling_friction: f64, damping_ratio: f64) -> Self {
        Self {
            parameters: EpsdParameters {
                rolling_friction,
                damping_ratio,
            },
        }
    }

    /// What drives its spring at an angular velocity, of bodies with an effective moment of inertia.
    #[inline(always)]
    pub(super) fn driven<L: Lanes>(&self, input: &RollingInput<L>, rate: L::Vector, inertia: L) -> SpringInput<L> {
        let stiffness = self.spring(input.size, input.normal_stiffness);
        SpringInput {
            normal: input.normal,
            rate,
            spin: input.spin,
            stiffness,
            compliance: compliance(stiffness),
            damping: dashpot(self.parameters.damping_ratio, stiffness, inertia),
            limit: input.size.radius * input.normal_force * self.parameters.rolling_friction,
            dt: input.dt,
        }
    }

    /// Rolling stiffness, `9/4 k_n (mu_r R)^2` [N m].
    #[inline(always)]
    fn spring<L: Lanes>(&self, size: PairSize<L>, normal_stiffness: L) -> L {
        let arm = size.radius * self.parameters.rolling_friction;
        normal_stiffness * 2.25 * arm * arm
    }
}
