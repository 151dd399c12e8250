//! One collision of the Hertzian spring-dashpot (HSD), for any damping (Antypov & Elliott 2011, eqs 9-19).
//!
//! `m x'' + alpha sqrt(m K) x^(1/4) x' + K x^(3/2) = 0`, `x(0) = 0`, `x'(0) = v0`, `K = 4/3 E_eff sqrt(r_eff)`. Everything
//! here is in units of the collision, [`PowerScale`](super::power::PowerScale) with exponent 3/2: lengths in
//! `(m v0^2/K)^(2/5)`, times in `(m/K)^(2/5) v0^(-1/5)`, speeds in `v0`, forces in `m^(3/5) K^(2/5) v0^(6/5)`.
//!
//! **The map.** With `x = (5/4)^(2/5) X^(4/5)` (eqs 14-16, 19) the speed `v(X)` is that of the linear collision with damping
//! ratio `g = alpha/sqrt(5)`, over- and under-damped. So restitution at both ends of contact and damping follow from
//! [`LinearCollision`]; the largest overlap is `(5/4)^(2/5)` times its largest overlap to the power 4/5; the force is
//! `(5/4)^(3/5) X^(1/5)` times its force. Only time is another: see [`duration`]. None of it depends on the impact speed, but
//! through the units.
//!
//! Eq 18 of the paper, the frequency of the equivalent linear spring for two equal spheres, has the constant
//! `2 sqrt(2)/sqrt(pi) = 1.59577` with the reduced mass of eq 1; the printed `2/sqrt(pi)` goes with the mass of one grain. It
//! is not needed: in the units above the frequency is 1.

pub use super::duration::{contact_time_first_order, contact_time_quadratic};
use super::linear::{LinearCollision, PhasePoint, phases};
use super::{ContactEnd, RestitutionError, bracketed, duration, not_negative};

/// `alpha` from which on the overlap never returns to zero: `sqrt(5)`.
pub const CRITICAL_ALPHA: f64 = 2.236_067_977_499_79;

/// A collision of the Hertzian spring-dashpot with a given damping coefficient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HertzCollision {
    linear: LinearCollision,
    alpha: f64,
}

impl HertzCollision {
    /// The collision with the damping coefficient `alpha`, 0 or above; critical at [`CRITICAL_ALPHA`].
    pub fn new(alpha: f64) -> Result<Self, RestitutionError> {
        not_negative("damping coefficient alpha", alpha)?;
        LinearCollision::new(alpha / CRITICAL_ALPHA).map(|linear| Self { linear, alpha })
    }

    /// The collision with the restitution `e` at the given end of contact, the exact inverse of [`Self::restitution`].
    ///
    /// Zero overlap: `alpha = sqrt(5) L/sqrt(L^2 + pi^2)` (eq 17). Zero force: as the linear collision.
    pub fn from_restitution(restitution: f64, end: ContactEnd) -> Result<Self, RestitutionError> {
        LinearCollision::from_restitution(restitution, end).map(|linear| Self {
            linear,
            alpha: CRITICAL_ALPHA * linear.ratio(),
        })
    }

    /// Damping coefficient `alpha`.
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// The linear collision with the same trajectory `v(X)`.
    pub fn linear(&self) -> LinearCollision {
        self.linear
    }

    /// Coefficient of restitution: that of the linear collision with `g = alpha/sqrt(5)`.
    pub fn restitution(&self, end: ContactEnd) -> Result<f64, RestitutionError> {
        self.linear.restitution(end).map_err(|error| self.in_alpha(error))
    }

    /// Phase at the end of contact, see [`LinearCollision::end_phase`].
    pub fn end_phase(&self, end: ContactEnd) -> Result<f64, RestitutionError> {
        self.linear.end_phase(end).map_err(|error| self.in_alpha(error))
    }

    /// Contact time: the closed form of [`duration`] at zero overlap, its quadrature at zero force.
    pub fn contact_time(&self, end: ContactEnd) -> Result<f64, RestitutionError> {
        match end {
            ContactEnd::ZeroOverlap => {
                let loss = self.linear.loss_at_zero_overlap().ok_or_else(|| self.overdamped())?;
                Ok(duration::UNDAMPED * duration::ratio_of_loss(loss))
            }
            ContactEnd::ZeroForce => Ok(duration::until(&self.linear, 2.0)),
        }
    }

    /// Largest overlap, `(5/4)^(2/5) X^(4/5)` (eqs 19, 21). Near `e = 1` it falls as `e^(2/5)`.
    pub fn max_overlap(&self) -> f64 {
        stretched(self.linear.max_overlap())
    }

    /// Largest total force, the one maximum of `(5/4)^(3/5) X^(1/5) (X + 2 g v)`.
    ///
    /// The paper does not give it. At the maximum `v F/5 + X (v - 2 g F) = 0` (of the linear collision), which changes sign
    /// once between first touch and zero force.
    pub fn max_force(&self) -> f64 {
        let linear = &self.linear;
        let rise = |log: f64| {
            let point = linear.at(libm::exp(log));
            0.2 * point.speed * point.force + point.overlap * (point.speed - 2.0 * linear.ratio() * point.force)
        };
        // below this phase the force still grows as time^(1/5); an undamped collision has its maximum at 1
        let phase = if linear.ratio() > 0.0 {
            libm::exp(bracketed(rise, -40.0, std::f64::consts::LN_2))
        } else {
            1.0
        };
        self.at(phase).force
    }

    /// State at the phase `s` of the linear collision: 0 first touch, 1 largest overlap, 2 zero force (eqs 13-16).
    pub fn at(&self, phase: f64) -> PhasePoint {
        let point = self.linear.at(phase);
        let overlap = point.overlap.max(0.0);
        PhasePoint {
            time: duration::until(&self.linear, phase),
            overlap: stretched(overlap),
            speed: point.speed,
            force: libm::pow(1.25, 0.6) * libm::pow(overlap, 0.2) * point.force,
        }
    }

    /// The phase-space trajectory (fig 1) from first touch to the end of contact: `points >= 2`, of equal spacing in the
    /// time of the linear collision.
    pub fn trajectory(&self, end: ContactEnd, points: u32) -> Result<Vec<PhasePoint>, RestitutionError> {
        let last = self.end_phase(end)?;
        Ok(phases(last, points).map(|phase| self.at(phase)).collect())
    }

    fn overdamped(&self) -> RestitutionError {
        RestitutionError::Overdamped {
            quantity: "damping coefficient alpha",
            value: self.alpha,
            limit: CRITICAL_ALPHA,
        }
    }

    fn in_alpha(&self, error: RestitutionError) -> RestitutionError {
        match error {
            RestitutionError::Overdamped { .. } => self.overdamped(),
            other => other,
        }
    }
}

/// `(5/4)^(2/5) X^(4/5)` (eq 19).
fn stretched(overlap: f64) -> f64 {
    libm::pow(1.25, 0.4) * libm::pow(overlap, 0.8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::restitution::brute_force::{Law, brute_force};
    use crate::restitution::hertz_damping;
    use crate::restitution::power::{PowerScale, UndampedCollision};
    use ContactEnd::{ZeroForce, ZeroOverlap};
    use approx::assert_relative_eq;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    #[test]
    fn the_reference_table() {
        for (e, alpha, tau, overlap, at_zero_force, tau_at_zero_force) in [
            (0.1, 1.3218628408, 4.861402527, 0.63070503, 0.2527293796, 2.53591828),
            (0.54, 0.4303779787, 3.477236761, 0.88088633, 0.5826257310, 2.89241253),
            (0.9, 0.0749495307, 3.253683413, 1.04918396, 0.9020260687, 3.12510775),
        ] {
            let collision = HertzCollision::from_restitution(e, ZeroOverlap).unwrap();
            assert_relative_eq!(collision.alpha(), alpha, max_relative = 1e-9);
            assert_relative_eq!(collision.alpha(), hertz_damping(e), max_relative = 1e-15);
            assert_relative_eq!(collision.contact_time(ZeroOverlap).unwrap(), tau, max_relative = 2e-10);
            assert_relative_eq!(collision.max_overlap(), overlap, max_relative = 1e-8);
            assert_relative_eq!(
                collision.restitution(ZeroForce).unwrap(),
                at_zero_force,
                max_relative = 2e-10
            );
            let time = collision.contact_time(ZeroForce).unwrap();
            assert_relative_eq!(time, tau_at_zero_force, max_relative = 2e-9);
            let raw = HertzCollision::new(collision.alpha()).unwrap();
            assert_relative_eq!(raw.restitution(ZeroOverlap).unwrap(), e, max_relative = 1e-14);
            assert_relative_eq!(
                raw.contact_time(ZeroOverlap).unwrap(),
                collision.contact_time(ZeroOverlap).unwrap(),
                max_relative = 1e-14
            );
        }
    }

    #[test]
    fn the_granule_of_fig_1() {
        let (diameter, density, modulus) = (0.01f64, 1500.0, 6e9 / (1.0 - 0.3 * 0.3) / 2.0);
        let scale = PowerScale {
            exponent: 1.5,
            mass: 0.5 * density * PI / 6.0 * diameter * diameter * diameter,
            stiffness: 4.0 / 3.0 * modulus * (0.25 * diameter).sqrt(),
            speed: 1.0,
        };
        let collision = HertzCollision::from_restitution(0.54, ZeroOverlap).unwrap();
        let time = collision.contact_time(ZeroOverlap).unwrap() * scale.time();
        assert_relative_eq!(time, 69.51247874e-6, max_relative = 1e-9);
        let undamped = UndampedCollision::new(1.5).unwrap().contact_time() * scale.time();
        assert_relative_eq!(undamped, 64.33145691e-6, max_relative = 1e-9);
        assert_relative_eq!(
            collision.max_overlap() * scale.length(),
            17.60955505e-6,
            max_relative = 1e-9
        );
    }

    #[test]
    fn every_damping_agrees_with_integration() {
        for alpha in [0.0, 0.05, 0.43, 1.0, 1.9, CRITICAL_ALPHA, 4.0] {
            let collision = HertzCollision::new(alpha).unwrap();
            for end in [ZeroOverlap, ZeroForce] {
                if alpha > 1.5 && end == ZeroOverlap {
                    continue;
                }
                let found = brute_force(Law::Hertz { alpha }, end);
                assert_relative_eq!(
                    collision.restitution(end).unwrap(),
                    found.restitution,
                    max_relative = 1e-10
                );
                assert_relative_eq!(
                    collision.contact_time(end).unwrap(),
                    found.contact_time,
                    max_relative = 1e-10
                );
                assert_relative_eq!(collision.max_overlap(), found.max_overlap, max_relative = 1e-10);
                assert_relative_eq!(collision.max_force(), found.max_force, max_relative = 1e-5);
            }
        }
    }

    #[test]
    fn the_largest_force_agrees_with_thirty_digits() {
        for (ratio, force) in [
            (0.01, 1.122_235_088_690_194),
            (0.3, 0.826_290_750_371_909_7),
            (0.999, 1.217_207_600_313_858),
            (1.0, 1.218_050_639_906_169_7),
            (2.0, 2.041_789_925_441_767_9),
            (50.0, 26.505_889_431_261_972),
        ] {
            let collision = HertzCollision::new(ratio * CRITICAL_ALPHA).unwrap();
            assert_relative_eq!(collision.max_force(), force, max_relative = 1e-14);
        }
        let undamped = UndampedCollision::new(1.5).unwrap().max_force();
        assert_relative_eq!(
            HertzCollision::new(0.0).unwrap().max_force(),
            undamped,
            max_relative = 1e-15
        );
        for tiny in [1e-300, 1e-17, 1e-9] {
            assert_relative_eq!(
                HertzCollision::new(tiny).unwrap().max_force(),
                undamped,
                max_relative = 2e-9
            );
        }
        assert!(HertzCollision::new(1e12).unwrap().max_force().is_finite());
    }

    #[test]
    fn a_trajectory_obeys_the_equation_of_motion() {
        for (alpha, end) in [
            (0.3, ZeroOverlap),
            (0.3, ZeroForce),
            (CRITICAL_ALPHA, ZeroForce),
            (6.0, ZeroForce),
        ] {
            let collision = HertzCollision::new(alpha).unwrap();
            for point in collision.trajectory(end, 33).unwrap() {
                let root = point.overlap.sqrt();
                let force = point.overlap * root + alpha * root.sqrt() * point.speed;
                assert!(
                    (point.force - force).abs() < 1e-12,
                    "{alpha}: {} not {force}",
                    point.force
                );
            }
            // dx/dt = v, with the time of the trajectory
            let (low, middle, high) = (collision.at(0.7), collision.at(0.70001), collision.at(0.70002));
            let speed = (high.overlap - low.overlap) / (high.time - low.time);
            assert_relative_eq!(speed, middle.speed, max_relative = 1e-8);
            let last = collision.trajectory(end, 5).unwrap()[4];
            assert_relative_eq!(last.time, collision.contact_time(end).unwrap(), max_relative = 1e-12);
            assert_relative_eq!(-last.speed, collision.restitution(end).unwrap(), max_relative = 1e-12);
        }
    }

    proptest! {
        #[test]
        fn requested_is_realised_at_both_ends(loss in 0f64..30.0) {
            let e = libm::exp(-loss);
            for end in [ZeroOverlap, ZeroForce] {
                let collision = HertzCollision::from_restitution(e, end).unwrap();
                assert_relative_eq!(collision.restitution(end).unwrap(), e, max_relative = 1e-14);
                let raw = HertzCollision::new(collision.alpha()).unwrap();
                // near critical damping the restitution at zero overlap hangs on the last digits of alpha
                let bound = if end == ZeroForce { 1e-13 } else { 1e-15 * (10.0 + loss * loss * loss) };
                assert_relative_eq!(raw.restitution(end).unwrap(), e, max_relative = bound);
                prop_assert!(collision.contact_time(end).unwrap() > 0.0);
            }
            let pulled = HertzCollision::from_restitution(e, ZeroOverlap).unwrap();
            prop_assert!(pulled.restitution(ZeroForce).unwrap() >= e);
            prop_assert!(pulled.contact_time(ZeroForce).unwrap() <= pulled.contact_time(ZeroOverlap).unwrap());
        }
    }

    /// The usual silent error of other codes: eq 17 with the pull cut off.
    #[test]
    fn cutting_the_pull_off_without_the_right_inverse_misses_the_request() {
        for (requested, realised) in [(0.3, 0.397), (0.5, 0.550)] {
            let wrong = HertzCollision::from_restitution(requested, ZeroOverlap).unwrap();
            assert!((wrong.restitution(ZeroForce).unwrap() - realised).abs() < 5e-4);
            let right = HertzCollision::from_restitution(requested, ZeroForce).unwrap();
            assert_relative_eq!(right.restitution(ZeroForce).unwrap(), requested, max_relative = 1e-15);
            let found = brute_force(Law::Hertz { alpha: right.alpha() }, ZeroForce);
            assert_relative_eq!(found.restitution, requested, max_relative = 1e-10);
        }
    }

    #[test]
    fn overdamped_contact_is_refused_at_zero_overlap_with_its_limit() {
        for alpha in [CRITICAL_ALPHA, 3.0] {
            let collision = HertzCollision::new(alpha).unwrap();
            let text = collision.contact_time(ZeroOverlap).unwrap_err().to_string();
            assert!(text.contains("alpha") && text.contains("2.236"), "{text}");
            assert!(collision.restitution(ZeroOverlap).is_err() && collision.trajectory(ZeroOverlap, 9).is_err());
            assert!(collision.contact_time(ZeroForce).is_ok());
        }
        assert!(HertzCollision::new(f64::INFINITY).is_err());
        assert!(HertzCollision::from_restitution(0.0, ZeroForce).is_err());
    }
}
