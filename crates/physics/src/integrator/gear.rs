//! The predictor-corrector of Gear: fifth order in Nordsieck form, for second-order equations.
//!
//! The state of one coordinate is its value `x` and five derivatives. One step of length `dt`:
//!
//! 1. predict `x` and all derivatives by their Taylor series
//! 2. find the acceleration `a` at the predicted place and velocity; `D = a - a_predicted`
//! 3. correct the `k`-th derivative by `c_k (k!/dt^k) (dt^2/2) D`, with
//!    `c = 3/16, 251/360, 1, 11/18, 1/6, 1/60`
//!
//! Source: Allen and Tildesley, *Computer Simulation of Liquids* (1987), section 3.2 and appendix E, table E.1: six values,
//! second-order equation; `c_0` is 3/16 and not 3/20, as forces depend on velocity. Forces are found once per step.
//!
//! The rate then follows the four-step Adams-Moulton formula with the predicted force at the new end. For smooth forces the
//! error over a given time falls with the fourth power of `dt` or faster; a start without derivatives costs second order, once.

use glam::{DQuat, DVec3};

/// Derivatives of one coordinate above its acceleration: third, fourth and fifth of place
/// [m/s^3, m/s^4, m/s^5]; for a rotation those of the angle, the second to fourth of the angular velocity [1/s^3 ...].
pub type Derivatives = [DVec3; 3];

/// Derivatives below this are none [SI units]. Where nothing acts they fall by some 10^3 in each step, and without this end they stay
/// at the least numbers that there are, with which a processor computes many times slower.
const NOTHING: f64 = 1e-200;

/// One coordinate with its rate and acceleration.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// Place [m], or an angle as rotation vector.
    pub place: DVec3,
    /// First derivative: velocity [m/s], or angular velocity [1/s].
    pub rate: DVec3,
    /// Second derivative [m/s^2], [1/s^2].
    pub acceleration: DVec3,
}

/// The method for one time step, with what depends on its length only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gear {
    /// `dt^k/k!` for `k` = 1 to 5.
    taylor: [f64; 5],
    /// What a unit of `D` adds to place, rate and derivatives.
    place: f64,
    rate: f64,
    derivatives: [f64; 3],
    /// Share of `w_n x w_(n+1)` in the angle of one step.
    twist: f64,
}

impl Gear {
    /// The method for a time step [s].
    pub fn new(dt: f64) -> Self {
        let dt2 = dt * dt;
        let dt3 = dt2 * dt;
        Self {
            taylor: [dt, dt2 / 2.0, dt3 / 6.0, dt2 * dt2 / 24.0, dt2 * dt3 / 120.0],
            place: 3.0 / 16.0 * dt2 / 2.0,
            rate: 251.0 / 360.0 * dt / 2.0,
            derivatives: [11.0 / 18.0 * 3.0 / dt, 1.0 / 6.0 * 12.0 / dt2, 1.0 / 60.0 * 60.0 / dt3],
            twist: dt2 / 12.0,
        }
    }

    /// Step 1: the Taylor series.
    #[inline(always)]
    pub fn predict(&self, motion: &mut Motion, derivatives: &mut Derivatives) {
        let [t1, t2, t3, t4, t5] = self.taylor;
        let Motion {
            place,
            rate,
            acceleration,
        } = motion;
        let [third, fourth, fifth] = derivatives;
        *place += *rate * t1 + *acceleration * t2 + *third * t3 + *fourth * t4 + *fifth * t5;
        *rate += *acceleration * t1 + *third * t2 + *fourth * t3 + *fifth * t4;
        *acceleration += *third * t1 + *fourth * t2 + *fifth * t3;
        *third += *fourth * t1 + *fifth * t2;
        *fourth += *fifth * t1;
    }

    /// Step 3 for all but the acceleration; `error` is `D`.
    #[inline(always)]
    pub fn correct(&self, place: &mut DVec3, rate: &mut DVec3, derivatives: &mut Derivatives, error: DVec3) {
        *place += error * self.place;
        *rate += error * self.rate;
        for (derivative, share) in derivatives.iter_mut().zip(self.derivatives) {
            let corrected = *derivative + error * share;
            *derivative = DVec3::select(corrected.abs().cmplt(DVec3::splat(NOTHING)), DVec3::ZERO, corrected);
        }
    }

    /// Step 1 for a rotation: predicts the angular velocity (world frame), its derivatives and the orientation.
    ///
    /// The orientation turns by `exp(A)` with the Magnus series `A = int w dt - dt^2/12 w_n x w_(n+1)`, whose next term is
    /// of fifth order in `dt`; the integral is the Taylor series of the angle.
    #[inline(always)]
    pub fn predict_rotation(
        &self,
        orientation: &mut DQuat,
        spin: &mut DVec3,
        acceleration: &mut DVec3,
        derivatives: &mut Derivatives,
    ) {
        let mut turning = Motion {
            place: DVec3::ZERO,
            rate: *spin,
            acceleration: *acceleration,
        };
        self.predict(&mut turning, derivatives);
        let angle = turning.place - spin.cross(turning.rate) * self.twist;
        *orientation = super::rotate(*orientation, angle, 1.0);
        (*spin, *acceleration) = (turning.rate, turning.acceleration);
    }

    /// Step 3 for a rotation: the orientation turns by the correction of the angle.
    #[inline(always)]
    pub fn correct_rotation(
        &self,
        orientation: &mut DQuat,
        spin: &mut DVec3,
        derivatives: &mut Derivatives,
        error: DVec3,
    ) {
        let mut angle = DVec3::ZERO;
        self.correct(&mut angle, spin, derivatives, error);
        *orientation = super::rotate(*orientation, angle, 1.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Slope of the error between the first and the last number of steps.
    fn order(error: impl Fn(u32) -> f64, steps: [u32; 2]) -> f64 {
        let [coarse, fine] = steps.map(&error);
        libm::log(coarse / fine) / libm::log(f64::from(steps[1]) / f64::from(steps[0]))
    }

    /// A damped oscillator `a = -x - 2 z v` from `x = 1`, `v = 1/2`, with the exact derivatives at the start or without.
    fn oscillator_error(damping: f64, steps: u32, exact_start: bool) -> f64 {
        let acceleration = |x: DVec3, v: DVec3| -x - v * (2.0 * damping);
        let end = 6.0;
        let gear = Gear::new(end / f64::from(steps));
        let (place, rate) = (DVec3::X, DVec3::X * 0.5);
        let mut motion = Motion {
            place,
            rate,
            acceleration: acceleration(place, rate),
        };
        let mut higher = [DVec3::ZERO; 3];
        if exact_start {
            higher[0] = acceleration(motion.rate, motion.acceleration);
            higher[1] = acceleration(motion.acceleration, higher[0]);
            higher[2] = acceleration(higher[0], higher[1]);
        }
        for _ in 0..steps {
            gear.predict(&mut motion, &mut higher);
            let error = acceleration(motion.place, motion.rate) - motion.acceleration;
            motion.acceleration += error;
            gear.correct(&mut motion.place, &mut motion.rate, &mut higher, error);
        }
        let w = (1.0 - damping * damping).sqrt();
        let decay = libm::exp(-damping * end);
        let (sin, cos) = (libm::sin(w * end), libm::cos(w * end));
        let x = decay * (cos + (damping + 0.5) / w * sin);
        let v = decay * (0.5 * cos - (1.0 + 0.5 * damping) / w * sin);
        (motion.place.x - x).abs().max((motion.rate.x - v).abs())
    }

    #[test]
    fn order_on_a_smooth_motion() {
        for damping in [0.0, 0.1, 0.7] {
            let found = order(|n| oscillator_error(damping, n, true), [200, 800]);
            assert!((3.9..5.3).contains(&found), "damping {damping}: order {found}");
            let found = order(|n| oscillator_error(damping, n, false), [200, 800]);
            assert!(
                (1.9..2.3).contains(&found),
                "damping {damping}, without derivatives at the start: order {found}"
            );
        }
    }

    /// Largest ratio of a decaying rate to that of the step before, late in its decay.
    fn growth(decay_per_step: f64) -> f64 {
        let gear = Gear::new(1.0);
        let (mut motion, mut higher) = (Motion::default(), [DVec3::ZERO; 3]);
        (motion.rate, motion.acceleration) = (DVec3::X, DVec3::X * -decay_per_step);
        let mut size = [0.0; 2];
        for step in 0..4000 {
            gear.predict(&mut motion, &mut higher);
            let error = motion.rate * -decay_per_step - motion.acceleration;
            motion.acceleration += error;
            gear.correct(&mut motion.place, &mut motion.rate, &mut higher, error);
            size[usize::from(step >= 2000)] = motion.rate.x.abs().max(size[usize::from(step >= 2000)]);
        }
        size[1] / size[0]
    }

    #[test]
    fn limit_of_stability() {
        assert!(growth(0.163) < 1.0, "{}", growth(0.163));
        assert!(growth(0.164) > 1.0, "{}", growth(0.164));
    }

    #[test]
    fn derivatives_of_a_free_motion_vanish() {
        let gear = Gear::new(3.6e-6);
        let mut motion = Motion {
            acceleration: DVec3::X * 100.0,
            ..Motion::default()
        };
        let mut higher = [DVec3::ZERO; 3];
        for _ in 0..200 {
            gear.predict(&mut motion, &mut higher);
            let error = -motion.acceleration;
            motion.acceleration = DVec3::ZERO;
            gear.correct(&mut motion.place, &mut motion.rate, &mut higher, error);
        }
        assert_eq!(higher, [DVec3::ZERO; 3]);
    }

    #[test]
    fn a_polynomial_of_the_fifth_degree_is_exact() {
        let gear = Gear::new(0.125);
        let mut motion = Motion::default();
        let mut higher = [DVec3::ZERO, DVec3::ZERO, DVec3::X * 120.0];
        for step in 1..=16 {
            gear.predict(&mut motion, &mut higher);
            let t = 0.125 * f64::from(step);
            let t2 = t * t;
            assert!((motion.place.x - t2 * t2 * t).abs() < 1e-13 * (1.0 + t2 * t2 * t));
            assert!((motion.rate.x - 5.0 * t2 * t2).abs() < 1e-12);
            assert!((motion.acceleration.x - 20.0 * t2 * t).abs() < 1e-12);
        }
    }

    /// Orientation after a turn whose axis and speed change: the body's frame precesses at `W` about z and turns at `s(t)`
    /// about its own axis, so that the orientation is known: `Rz(W t) Rx(S(t))`.
    fn precession_error(steps: u32) -> f64 {
        let (precession, end) = (1.3, 4.0);
        let spin_angle = |t: f64| 2.0 * t + libm::sin(t);
        // derivatives of w(t) = W z + s(t) (cos Wt, sin Wt, 0), by complex numbers in the plane
        let omega = |t: f64, derivative: usize| {
            let s = [
                2.0 + libm::cos(t),
                -libm::sin(t),
                -libm::cos(t),
                libm::sin(t),
                libm::cos(t),
            ];
            let binomial = [
                [1.0, 0.0, 0.0, 0.0],
                [1.0, 1.0, 0.0, 0.0],
                [1.0, 2.0, 1.0, 0.0],
                [1.0, 3.0, 3.0, 1.0],
            ];
            let (mut x, mut y) = (0.0, 0.0);
            for k in 0..=derivative {
                let power = derivative - k;
                let size = binomial[derivative][k] * s[k] * libm::pow(precession, power as f64);
                let angle = precession * t + power as f64 * std::f64::consts::FRAC_PI_2;
                x += size * libm::cos(angle);
                y += size * libm::sin(angle);
            }
            DVec3::new(x, y, if derivative == 0 { precession } else { 0.0 })
        };
        let dt = end / f64::from(steps);
        let gear = Gear::new(dt);
        let mut q = DQuat::IDENTITY;
        let (mut spin, mut acceleration) = (omega(0.0, 0), omega(0.0, 1));
        let mut higher = [omega(0.0, 2), omega(0.0, 3), DVec3::ZERO];
        for step in 1..=steps {
            gear.predict_rotation(&mut q, &mut spin, &mut acceleration, &mut higher);
            let error = omega(dt * f64::from(step), 1) - acceleration;
            acceleration += error;
            gear.correct_rotation(&mut q, &mut spin, &mut higher, error);
        }
        let about = |axis: DVec3, angle: f64| super::super::rotate(DQuat::IDENTITY, axis * angle, 1.0);
        let exact = about(DVec3::Z, precession * end) * about(DVec3::X, spin_angle(end));
        (q * q.dot(exact).signum() - exact).length()
    }

    #[test]
    fn order_of_the_orientation() {
        let found = order(precession_error, [200, 800]);
        assert!(found > 3.9, "order {found}");
        assert!(precession_error(800) < 1e-9, "{}", precession_error(800));
    }
}
