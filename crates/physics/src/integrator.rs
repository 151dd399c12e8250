//! Velocity Verlet for translation and rotation of rigid spheres.
//!
//! One step of length `dt` from state `n` to `n + 1`:
//!
//! 1. half kick and drift: `v' = v_n + a_n dt/2`, `x_(n+1) = x_n + v' dt`, and the predicted velocity `v* = v' + a_n dt/2`
//! 2. forces `a_(n+1)` at `x_(n+1)`, with `v*` for what depends on velocity
//! 3. correcting kick: `v_(n+1) = v* + (a_(n+1) - a_n) dt/2`

use glam::{DQuat, DVec3};

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
