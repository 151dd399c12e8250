//! One collision of the linear spring-dashpot (LSD), for any damping (Antypov & Elliott 2011, eqs 3-8, 20-22, 25).
//!
//! `m x'' + 2 gamma m x' + k x = 0`, `x(0) = 0`, `x'(0) = v0`. Everything here is in units of the collision: times in
//! `1/w0`, overlaps in `v0/w0`, speeds in `v0`, forces in `m w0 v0`, with `w0 = sqrt(k/m)`
//! ([`PowerScale`](super::power::PowerScale) with exponent 1 turns them into SI).
//!
//! **One parameter for all dampings.** With `g = gamma/w0 = cos(c)` and the phase `s = w1 t / c` the solution (eqs 5, 6) is
//!
//! ```text
//! x = exp(-h s) sin(c s)/sin(c)      v = exp(-h s) sin(c (1 - s))/sin(c)      F = -v' = exp(-h s) sin(c (2 - s))/sin(c)
//! t = s c/sin(c)                     h = c cot(c)
//! ```
//!
//! Critical damping is the limit `c -> 0` (`sin(c s)/sin(c) -> s`, `h = 1`); over-damped, `g = cosh(c)` and `sin` becomes
//! `sinh`. So the overlap is largest at `s = 1`, the force is back at zero at `s = 2`, and the overlap at `s = pi/c` (never
//! unless under-damped). From this follow, without any approximation:
//!
//! | quantity | value |
//! |---|---|
//! | restitution, end at zero overlap (eq 7) | `exp(-pi cot(c))` |
//! | restitution, end at zero force | `exp(-2 h)` |
//! | largest overlap (eq 21) | `exp(-h)` = `sqrt(e)` of the end at zero force: eq 22 is exact there |
//! | contact time, zero overlap (eqs 7, 25) | `pi/sin(c)` = `sqrt(L^2 + pi^2)` |
//! | contact time, zero force | `2 c/sin(c)` |
//! | largest force | `2 g` at first touch if `g >= 1/2`, else `exp(-(3 c - pi) cot(c))` at `c s = 3 c - pi` |

use std::f64::consts::{FRAC_PI_2, PI};

use super::{ContactEnd, RestitutionError, bracketed, not_negative, share};

/// State of a collision at one phase, in units of the collision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhasePoint {
    /// Time since first touch.
    pub time: f64,
    /// Overlap.
    pub overlap: f64,
    /// Rate of approach in impact speeds: 1 at first touch, negative in rebound.
    pub speed: f64,
    /// Total force, repulsion positive.
    pub force: f64,
}

/// A collision of the linear spring-dashpot with a given damping ratio.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearCollision {
    ratio: f64,
    damping: Damping,
    /// `h = c cot(c)` or `c coth(c)`.
    decay: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Damping {
    Under { angle: f64, sine: f64 },
    Critical,
    Over { angle: f64, sine: f64 },
}

impl LinearCollision {
    /// The collision with `ratio = gamma / sqrt(k/m)`, 0 or above: under-damped below 1, over-damped above.
    pub fn new(ratio: f64) -> Result<Self, RestitutionError> {
        not_negative("damping ratio", ratio)?;
        let (damping, decay) = if ratio < 1.0 {
            let (angle, sine) = (libm::acos(ratio), ((1.0 - ratio) * (1.0 + ratio)).sqrt());
            (Damping::Under { angle, sine }, angle * ratio / sine)
        } else if ratio > 1.0 {
            let (angle, sine) = (libm::acosh(ratio), (ratio - 1.0).sqrt() * (ratio + 1.0).sqrt());
            (Damping::Over { angle, sine }, angle * (ratio / sine))
        } else {
            (Damping::Critical, 1.0)
        };
        Ok(Self { ratio, damping, decay })
    }

    /// The collision with the restitution `e` at the given end of contact, the exact inverse of [`Self::restitution`].
    ///
    /// * Zero overlap: `g = L/sqrt(L^2 + pi^2)` (eq 8), always under-damped.
    /// * Zero force: `2 c cot(c) = L`, solved in `g`, in which it is smooth through critical damping at `e = exp(-2)`:
    ///   every `e` in (0, 1] has its `g`.
    pub fn from_restitution(restitution: f64, end: ContactEnd) -> Result<Self, RestitutionError> {
        // of 1 it is 0, not -0
        let l = 0.0 - libm::log(share(restitution)?);
        match end {
            ContactEnd::ZeroOverlap => {
                let length = (l * l + PI * PI).sqrt();
                let angle = libm::atan2(PI, l);
                Ok(Self {
                    ratio: l / length,
                    damping: Damping::Under {
                        angle,
                        sine: PI / length,
                    },
                    decay: angle * (l / PI),
                })
            }
            ContactEnd::ZeroForce => Self::new(ratio_of_decay(0.5 * l)),
        }
    }

    /// Damping ratio `g = gamma / sqrt(k/m)`.
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    /// Phase at the end of contact: `pi/c` at zero overlap, 2 at zero force.
    ///
    /// Refused for the end at zero overlap from critical damping on, where the overlap never returns to zero.
    pub fn end_phase(&self, end: ContactEnd) -> Result<f64, RestitutionError> {
        match (end, self.damping) {
            (ContactEnd::ZeroForce, _) => Ok(2.0),
            (ContactEnd::ZeroOverlap, Damping::Under { angle, .. }) => Ok(PI / angle),
            (ContactEnd::ZeroOverlap, _) => Err(self.overdamped()),
        }
    }

    fn overdamped(&self) -> RestitutionError {
        RestitutionError::Overdamped {
            quantity: "damping ratio",
            value: self.ratio,
            limit: 1.0,
        }
    }

    /// Coefficient of restitution: `exp(-pi cot(c))` at zero overlap (eq 7), `exp(-2 h)` at zero force.
    pub fn restitution(&self, end: ContactEnd) -> Result<f64, RestitutionError> {
        match (end, self.damping) {
            (ContactEnd::ZeroForce, _) => Ok(libm::exp(-2.0 * self.decay)),
            (ContactEnd::ZeroOverlap, _) => {
                let loss = self.loss_at_zero_overlap().ok_or_else(|| self.overdamped())?;
                Ok(libm::exp(-loss))
            }
        }
    }

    /// Contact time in `1/w0`: `pi/sqrt(1 - g^2)` at zero overlap (eq 7), `2 c/sin(c)` at zero force.
    pub fn contact_time(&self, end: ContactEnd) -> Result<f64, RestitutionError> {
        match (end, self.damping) {
            (ContactEnd::ZeroForce, _) => Ok(2.0 * self.time_per_phase()),
            (ContactEnd::ZeroOverlap, Damping::Under { sine, .. }) => Ok(PI / sine),
            (ContactEnd::ZeroOverlap, _) => Err(self.overdamped()),
        }
    }

    /// Largest overlap in `v0/w0`, `exp(-h)` (eq 21 for every damping).
    pub fn max_overlap(&self) -> f64 {
        libm::exp(-self.decay)
    }

    /// Largest total force in `m w0 v0`.
    pub fn max_force(&self) -> f64 {
        match self.damping {
            Damping::Under { angle, sine } if self.ratio < 0.5 => libm::exp((PI - 3.0 * angle) * (self.ratio / sine)),
            _ => 2.0 * self.ratio,
        }
    }

    /// State at the phase `s`: 0 first touch, 1 largest overlap, 2 zero force, [`Self::end_phase`] zero overlap.
    pub fn at(&self, phase: f64) -> PhasePoint {
        let [overlap, speed, force] = [phase, 1.0 - phase, 2.0 - phase].map(|part| self.wave(part, phase));
        PhasePoint {
            time: phase * self.time_per_phase(),
            overlap,
            speed,
            force,
        }
    }

    /// The phase-space trajectory (fig 1) from first touch to the end of contact, `points >= 2` of equal spacing in time.
    pub fn trajectory(&self, end: ContactEnd, points: u32) -> Result<Vec<PhasePoint>, RestitutionError> {
        let last = self.end_phase(end)?;
        Ok(phases(last, points).map(|phase| self.at(phase)).collect())
    }

    /// `-ln e = pi cot(c)` where contact ends at zero overlap, none if it never does.
    pub(super) fn loss_at_zero_overlap(&self) -> Option<f64> {
        self.under_damped().map(|(_, sine)| PI * (self.ratio / sine))
    }

    /// `t/s = c/sin(c)`.
    pub(super) fn time_per_phase(&self) -> f64 {
        match self.damping {
            Damping::Under { angle, sine } | Damping::Over { angle, sine } => angle / sine,
            Damping::Critical => 1.0,
        }
    }

    /// `(c, sin(c))` if under-damped.
    pub(super) fn under_damped(&self) -> Option<(f64, f64)> {
        match self.damping {
            Damping::Under { angle, sine } => Some((angle, sine)),
            _ => None,
        }
    }

    /// `exp(-h s) sin(c part)/sin(c)`; the over-damped form holds no `sinh`, which would overflow.
    fn wave(&self, part: f64, phase: f64) -> f64 {
        match self.damping {
            Damping::Under { angle, sine } => libm::exp(-self.decay * phase) * libm::sin(angle * part) / sine,
            Damping::Critical => libm::exp(-phase) * part,
            Damping::Over { angle, .. } => {
                let growth = libm::exp(angle * (part - 1.0) - self.decay * phase);
                growth * libm::expm1(-2.0 * angle * part) / libm::expm1(-2.0 * angle)
            }
        }
    }
}

/// `points` phases of equal spacing from 0 to `last`, both included.
pub(super) fn phases(last: f64, points: u32) -> impl Iterator<Item = f64> {
    let steps = points.max(2) - 1;
    (0..=steps).map(move |i| last * (f64::from(i) / f64::from(steps)))
}

/// `h(g) = g arccos(g)/sqrt(1 - g^2)` and its continuation above 1, strictly rising from 0.
fn decay_of(ratio: f64) -> f64 {
    if ratio < 1.0 {
        ratio * libm::acos(ratio) / ((1.0 - ratio) * (1.0 + ratio)).sqrt()
    } else if ratio > 1.0 {
        libm::acosh(ratio) * (ratio / ((ratio - 1.0).sqrt() * (ratio + 1.0).sqrt()))
    } else {
        1.0
    }
}

/// `dh/dg = (h/g - g)/(1 - g^2)`, by its Taylor polynomial where that difference cancels.
fn decay_slope(ratio: f64, decay: f64) -> f64 {
    let d = ratio - 1.0;
    if d.abs() < 1e-4 {
        2.0 / 3.0 - 0.4 * d
    } else {
        (decay / ratio - ratio) / ((1.0 - ratio) * (1.0 + ratio))
    }
}

/// The `g` with `h(g) = decay`, to the last bits: bracketed in `ln g`, over the decades of it, then polished by Newton.
///
/// The bracket: `h <= pi g/2` everywhere, `h(1) = 1`, and `h >= arccosh(g) >= ln(g)` above.
fn ratio_of_decay(decay: f64) -> f64 {
    if decay <= 0.0 {
        return 0.0;
    }
    let low = decay / FRAC_PI_2;
    let high = if decay < 1.0 { 1.0 } else { libm::exp(decay) };
    let misfit = |log: f64| decay_of(libm::exp(log)) - decay;
    let mut g = libm::exp(bracketed(misfit, libm::log(low), libm::log(high)));
    for _ in 0..3 {
        let at_g = decay_of(g);
        g = (g - (at_g - decay) / decay_slope(g, at_g)).clamp(low, high);
    }
    g
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::restitution::brute_force::{Law, brute_force};
    use crate::restitution::{damping_ratio, linear_contact_time};
    use ContactEnd::{ZeroForce, ZeroOverlap};
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    #[test]
    fn restitution_at_zero_force_of_the_reference_table() {
        for (e, at_zero_force) in [(0.1, 0.2527293796), (0.54, 0.5826257310), (0.9, 0.9020260687)] {
            let collision = LinearCollision::from_restitution(e, ZeroOverlap).unwrap();
            assert_relative_eq!(collision.ratio(), damping_ratio(e), max_relative = 1e-15);
            assert_relative_eq!(
                collision.restitution(ZeroForce).unwrap(),
                at_zero_force,
                max_relative = 2e-10
            );
            let l = -libm::log(e);
            let direct = libm::exp(-2.0 * l / PI * libm::atan(PI / l));
            assert_relative_eq!(collision.restitution(ZeroForce).unwrap(), direct, max_relative = 1e-14);
            assert_relative_eq!(
                collision.contact_time(ZeroOverlap).unwrap(),
                linear_contact_time(1.0, 1.0, e),
                max_relative = 1e-14
            );
        }
    }

    /// 30-digit evaluation of the closed forms: ratio, restitution at zero force, largest overlap, time at zero force.
    const REFERENCE: [[f64; 4]; 7] = [
        [
            0.01,
            0.969_264_750_464_492_5,
            0.984_512_443_021_668_7,
            3.121_748_411_564_418,
        ],
        [
            0.3,
            0.450_975_452_893_128_48,
            0.671_547_059_328_777_5,
            2.654_474_563_785_356_6,
        ],
        [
            0.999,
            0.135_515_904_859_451_1,
            0.368_124_849_554_401_97,
            2.000_666_933_447_67,
        ],
        [1.0, 0.135_335_283_236_612_7, 0.367_879_441_171_442_32, 2.0],
        [
            1.001,
            0.135_155_010_478_285_69,
            0.367_634_343_442_347_2,
            1.999_333_599_885_765,
        ],
        [
            2.0,
            0.047_768_732_505_620_19,
            0.218_560_592_297_925_9,
            1.520_691_992_601_892_7,
        ],
        [
            50.0,
            9.983_587_973_939_515e-5,
            0.009_991_790_617_271_519,
            0.184_239_658_456_611_92,
        ],
    ];

    #[test]
    fn every_damping_agrees_with_thirty_digits() {
        for [ratio, e, overlap, time] in REFERENCE {
            let collision = LinearCollision::new(ratio).unwrap();
            assert_relative_eq!(collision.restitution(ZeroForce).unwrap(), e, max_relative = 4e-15);
            assert_relative_eq!(collision.max_overlap(), overlap, max_relative = 2e-15);
            assert_relative_eq!(collision.contact_time(ZeroForce).unwrap(), time, max_relative = 1e-14);
            let back = LinearCollision::from_restitution(e, ZeroForce).unwrap();
            assert_relative_eq!(back.ratio(), ratio, max_relative = 1e-13);
        }
    }

    #[test]
    fn every_damping_agrees_with_integration() {
        for ratio in [0.0, 0.07, 0.45, 0.6, 0.99, 1.0, 1.01, 3.0] {
            let collision = LinearCollision::new(ratio).unwrap();
            for end in [ZeroOverlap, ZeroForce] {
                if ratio >= 0.99 && end == ZeroOverlap {
                    continue;
                }
                let found = brute_force(Law::Linear { ratio }, end);
                assert_relative_eq!(
                    collision.restitution(end).unwrap(),
                    found.restitution,
                    max_relative = 1e-11
                );
                assert_relative_eq!(
                    collision.contact_time(end).unwrap(),
                    found.contact_time,
                    max_relative = 1e-11
                );
                assert_relative_eq!(collision.max_overlap(), found.max_overlap, max_relative = 1e-11);
                assert_relative_eq!(collision.max_force(), found.max_force, max_relative = 1e-6);
            }
        }
    }

    #[test]
    fn no_loss_is_a_damping_of_zero() {
        for end in [ZeroOverlap, ZeroForce] {
            let ratio = LinearCollision::from_restitution(1.0, end).unwrap().ratio();
            assert!(ratio == 0.0 && ratio.is_sign_positive(), "{end:?}: {ratio}");
        }
    }

    #[test]
    fn the_inverse_closes_for_every_restitution_at_both_ends() {
        let mut wanted: Vec<f64> = (1..=300).map(|i| libm::exp(-0.1 * f64::from(i))).collect();
        wanted.extend((1..=16).flat_map(|i| {
            let near = libm::pow(10.0, -f64::from(i));
            [
                1.0 - near,
                libm::exp(-2.0) * (1.0 + near),
                libm::exp(-2.0) * (1.0 - near),
            ]
        }));
        wanted.extend([1.0, libm::exp(-2.0), 1e-100, 1e-300]);
        for e in wanted {
            for end in [ZeroOverlap, ZeroForce] {
                let collision = LinearCollision::from_restitution(e, end).unwrap();
                let (got, l) = (collision.restitution(end).unwrap(), -libm::log(e));
                assert_relative_eq!(got, e, max_relative = 4e-16 * (4.0 + l));
                // near e = 1 the damping itself must be right to its own last digits, not only 1 - e
                let loss = match end {
                    ZeroForce => 2.0 * collision.decay,
                    ZeroOverlap => collision.loss_at_zero_overlap().unwrap(),
                };
                assert_relative_eq!(loss, l, max_relative = 4e-15);
            }
        }
        assert_eq!(LinearCollision::from_restitution(1.0, ZeroForce).unwrap().ratio(), 0.0);
        assert!(LinearCollision::from_restitution(0.1353, ZeroForce).unwrap().ratio() > 1.0);
        assert!(LinearCollision::from_restitution(0.1354, ZeroForce).unwrap().ratio() < 1.0);
    }

    #[test]
    fn the_trajectory_obeys_the_equation_of_motion() {
        for ratio in [0.0, 0.2, 0.999_999, 1.0, 1.000_001, 5.0, 1e6] {
            let collision = LinearCollision::new(ratio).unwrap();
            let end = if ratio < 0.9 { ZeroOverlap } else { ZeroForce };
            let trajectory = collision.trajectory(end, 41).unwrap();
            for point in &trajectory {
                let scale = 1.0 + 2.0 * ratio;
                assert_abs_diff_eq!(
                    point.force,
                    point.overlap + 2.0 * ratio * point.speed,
                    epsilon = 1e-14 * scale
                );
                assert!(point.overlap <= collision.max_overlap() * (1.0 + 1e-14));
                assert!(point.force <= collision.max_force() * (1.0 + 1e-14));
            }
            let (first, last) = (trajectory[0], trajectory[40]);
            assert_eq!((first.time, first.overlap), (0.0, 0.0));
            assert_relative_eq!(first.speed, 1.0, max_relative = 1e-15);
            assert_relative_eq!(-last.speed, collision.restitution(end).unwrap(), max_relative = 1e-13);
            assert_relative_eq!(last.time, collision.contact_time(end).unwrap(), max_relative = 1e-14);
            let zero = if end == ZeroOverlap { last.overlap } else { last.force };
            assert_abs_diff_eq!(zero, 0.0, epsilon = 1e-15);
            assert_relative_eq!(collision.at(1.0).overlap, collision.max_overlap(), max_relative = 1e-14);
        }
    }

    #[test]
    fn critical_damping_is_refused_only_where_the_overlap_must_return() {
        for ratio in [1.0, 1.5, 1e200] {
            let collision = LinearCollision::new(ratio).unwrap();
            assert!(collision.restitution(ZeroOverlap).is_err());
            assert!(collision.contact_time(ZeroOverlap).is_err());
            assert!(collision.trajectory(ZeroOverlap, 10).is_err());
            assert!(collision.at(1.5).speed <= 0.0);
            assert!(collision.restitution(ZeroForce).is_ok());
        }
        assert!(LinearCollision::new(-0.1).is_err());
        assert!(LinearCollision::new(f64::NAN).is_err());
    }
}
