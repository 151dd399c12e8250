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

use crate::lanes::{Lanes, Mask, Vector};
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
    /// The decays of all contacts of a grain add up. The predictor-corrector, whose forces follow from predicted
    /// rates alone, is stable up to a decay of 0.163 per step, velocity Verlet up to 1 (for the predicted rate `w + (dt/2) a` of a decay `S`
    /// it is `x^2 - (1 - 3/2 S) x - S/2 = 0`, whose root reaches -1 there). Equal spheres that all turn alike, which is the fastest decay of
    /// slips, lose 2/3 of 5/7 of the share for each of their neighbours: 0.91 where they have twelve.
    #[inline(always)]
    pub fn removable_share(self) -> f64 {
        match self {
            Self::VelocityVerlet => 0.16,
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
    DQuat::from_array(rotate_wide::<f64>(orientation.to_array(), omega, dt))
}

/// The same in every lane; quaternions as `x, y, z, w`.
#[inline(always)]
pub fn rotate_wide<L: Lanes>([x, y, z, w]: [L; 4], omega: L::Vector, dt: f64) -> [L; 4] {
    let half = omega * L::splat(0.5 * dt);
    let square = half.square();
    let one = L::splat(1.0);
    let mut sine_share = one - square * (1.0 / 6.0) * (one - square * (1.0 / 20.0) * (one - square * (1.0 / 42.0)));
    let mut cosine = one - square * 0.5 * (one - square * (1.0 / 12.0) * (one - square * (1.0 / 30.0)));
    let large = square.ge(L::splat(SMALL_SQUARE));
    if large.any() {
        let (mut sines, mut cosines, squares) = (sine_share.to_array(), cosine.to_array(), square.to_array());
        let mut lane = 0;
        while lane < L::COUNT {
            if squares[lane] >= SMALL_SQUARE {
                let angle = squares[lane].sqrt();
                sines[lane] = libm::sin(angle) / angle;
                cosines[lane] = libm::cos(angle);
            }
            lane += 1;
        }
        (sine_share, cosine) = (L::load(&sines), L::load(&cosines));
    }
    let [tx, ty, tz] = (half * sine_share).components();
    let turned = [
        cosine * x + tx * w + ty * z - tz * y,
        cosine * y - tx * z + ty * w + tz * x,
        cosine * z + tx * y - ty * x + tz * w,
        cosine * w - tx * x - ty * y - tz * z,
    ];
    // one step of Newton for the inverse root of a square that is 1 but for rounding
    let length2 = turned[0] * turned[0] + turned[1] * turned[1] + turned[2] * turned[2] + turned[3] * turned[3];
    let factor = L::splat(1.5) - length2 * 0.5;
    [
        turned[0] * factor,
        turned[1] * factor,
        turned[2] * factor,
        turned[3] * factor,
    ]
}

/// Square of the half angle below which the series of sine and cosine in [`rotate`] are exact: the first terms that are left
/// out are `x^8/9!` and `x^8/8!`, 2.5e-17 at most.
const SMALL_SQUARE: f64 = 1e-3;

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
