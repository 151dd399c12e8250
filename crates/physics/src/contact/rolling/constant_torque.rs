#![doc = include_str!("constant_torque.md")]

use super::{Rolling, RollingInput, RollingResponse};
use crate::contact::slider::resist;
use crate::contact::{MaterialPair, PairSize};
use crate::dimension::Dimension;
use crate::lanes::Lanes;
use crate::parameters::{ParameterError, ParameterInfo, Range, Values};
use crate::params;

params! {
    /// Parameters of the constant directional torque.
    pub struct ConstantTorqueParameters {
        rolling_friction: NONE, required 0.05, in Range::NOT_NEGATIVE, "Coefficient of rolling friction";
    }
}

/// Constant directional torque bound to a pair of materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantTorque {
    rolling_friction: f64,
}

/// Moment of inertia of a sphere that turns about its centre over that of one that rolls about its surface.
const TURNING: f64 = 2.0 / 7.0;
/// By how much less of a spin may be removed than of a slip: spins of neighbours that turn against each other lose as much as
/// the share at every contact.
const OF_SPIN: f64 = 0.4;

impl Rolling for ConstantTorque {
    const NAME: &'static str = "constant-torque";
    const SUMMARY: &'static str = "constant directional torque, M = mu_r R F_n against rolling";
    const DOC: &'static str = include_str!("constant_torque.md");
    const PARAMETERS: &'static [ParameterInfo] = ConstantTorqueParameters::TABLE;
    const HISTORY: &'static [Dimension] = &[];

    fn new(values: &Values, _pair: &MaterialPair) -> Result<Self, Vec<ParameterError>> {
        let p = ConstantTorqueParameters::from_values(values)?;
        Ok(Self {
            rolling_friction: p.rolling_friction,
        })
    }

    const WIDE: bool = true;

    #[inline(always)]
    fn respond(&self, input: &RollingInput, history: &mut [f64]) -> RollingResponse {
        self.respond_wide(input, history)
    }

    #[inline(always)]
    fn respond_wide<L: Lanes>(&self, input: &RollingInput<L>, _history: &mut [L]) -> RollingResponse<L> {
        let limit = input.size.radius * input.normal_force * self.rolling_friction;
        let stopping = input.rolling_inertia * (TURNING * OF_SPIN * input.removable_share / input.dt);
        let response = resist(input.angular_velocity, limit, stopping, input.dt);
        RollingResponse {
            torque: response.load,
            dissipated: response.dissipated,
        }
    }

    #[inline(always)]
    fn energy(&self, _history: &[f64]) -> f64 {
        0.0
    }

    #[inline(always)]
    fn stiffness(&self, _size: PairSize, _normal_stiffness: f64) -> f64 {
        0.0
    }
}
