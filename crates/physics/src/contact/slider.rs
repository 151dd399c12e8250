//! Resistance that knows its magnitude and the direction of motion, and remembers nothing: shared by friction and rolling
//! resistance.

use crate::lanes::{Lanes, Vector};

/// What the slider answers.
#[derive(Clone, Copy, Debug)]
pub struct SliderResponse<L: Lanes = f64> {
    /// Load over this step: force or torque on the first body.
    pub load: L::Vector,
    /// Energy dissipated in this step [J].
    pub dissipated: L,
}

/// A load of magnitude `limit` against `rate`, and no more than takes off a share of the rate: `inertia` times this share
/// over the time step is `stopping`.
#[inline(always)]
pub fn resist<L: Lanes>(rate: L::Vector, limit: L, stopping: L, dt: f64) -> SliderResponse<L> {
    let square = rate.square();
    let speed = square.sqrt();
    // load per rate, the smaller of the two branches: no division by a vanishing rate
    let coefficient = L::select(limit.lt(stopping * speed), limit / speed, stopping);
    let coefficient = coefficient.keep(limit.gt(L::splat(0.0)));
    SliderResponse {
        load: -rate * coefficient,
        dissipated: coefficient * square * dt,
    }
}
