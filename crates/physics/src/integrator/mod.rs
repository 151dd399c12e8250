//! Steps of the equations of motion of rigid spheres: what is common to both integrators, and velocity Verlet.
//!
//! One step of velocity Verlet of length `dt` from state `n` to `n + 1`, for translation and rotation:
//!
//! 1. half kick and drift: `v' = v_n + a_n dt/2`, `x_(n+1) = x_n + v' dt`, and the predicted velocity `v* = v' + a_n dt/2`
//! 2. forces `a_(n+1)` at `x_(n+1)`, with `v*` for what depends on velocity
//! 3. correcting kick: `v_(n+1) = v* + (a_(n+1) - a_n) dt/2`
//!
//! The other integrator is that of [`gear`].

pub mod gear;

use crate::lanes::Lanes;
use glam::{DQuat, DVec3};

/// How the equations of motion are integrated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Integrator {
    /// Velocity Verlet: second order; the energy of an elastic system does not drift.
    #[default]
    VelocityVerlet,
    /// The predictor-corrector of [`gear`]: high order where forces are smooth, but the energy drifts.
    Gear,
}

/// Half windows of overlap from an end of the contact within which the predictor-corrector takes the force as its mean
/// over the step: eight steps at a steady rate. A dashpot that rises as the fourth root of the overlap bends so much near
/// the end that fewer cost accuracy there (a factor of 3 in a trajectory from 4 to 16); more cost the order of slow swings.
const END: f64 = 16.0;

impl Integrator {
    /// Largest share of the relative speed at a contact that a law without memory may remove in one step, where it holds
    /// rather than slides: `f` of `coulomb` and `constant-torque`.
    ///
    /// The rates of decay of all contacts of a grain add up. The predictor-corrector, whose forces follow from predicted
    /// rates alone, is stable up to a decay of 0.163 per step; velocity Verlet up to 1.
    #[inline(always)]
    pub fn removable_share(self) -> f64 {
        match self {
            Self::VelocityVerlet => 0.2,
            Self::Gear => 0.01,
        }
    }

    /// Half of the path of the overlap over which a normal law takes the mean of its force in one step [m]; 0: the force
    /// at the overlap itself.
    ///
    /// With velocity Verlet it is the mean over the whole step, always. The predictor-corrector, whose high order only a
    /// force taken at its own moment keeps, takes the mean near the ends of a contact alone: there the force has a kink,
    /// whose phase within the step would be felt in first order.
    #[inline(always)]
    pub fn half_window<L: Lanes>(self, overlap: L, rate: L, dt: f64) -> L {
        let half_window = rate.abs() * (0.5 * dt);
        match self {
            Self::Gear => half_window.keep(!overlap.gt(half_window * END)),
            Self::VelocityVerlet => half_window,
        }
    }
}

/// Orientation after turning at the angular velocity `omega` (world frame) [1/s] for `dt` [s].
#[inline]
pub fn rotate(orientation: DQuat, omega: DVec3, dt: f64) -> DQuat {
    let speed = omega.length();
    if speed > 0.0 {
        let half = 0.5 * speed * dt;
        let axis = omega * (libm::sin(half) / speed);
        (DQuat::from_xyzw(axis.x, axis.y, axis.z, libm::cos(half)) * orientation).normalize()
    } else {
        orientation
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn a_full_turn_in_many_steps_returns() {
        let omega = DVec3::new(0.3, -1.2, 0.7);
        let steps = 1000;
        let dt = 2.0 * PI / omega.length() / f64::from(steps);
        let mut q = DQuat::IDENTITY;
        for _ in 0..steps {
            q = rotate(q, omega, dt);
        }
        assert!((q * DVec3::X - DVec3::X).length() < 1e-12);
    }
}
