//! How long a damped Hertzian collision lasts (Antypov & Elliott 2011, eqs 24-29), in `(m/K)^(2/5) v0^(-1/5)`.
//!
//! The trajectory of the damped Hertzian spring in the phase plane is that of the linear one on a stretched axis,
//! `x = (5/4)^(2/5) X^(4/5)` (eq 19), so its time is (eq 24)
//!
//! ```text
//! tau = integral dx/v = (4/5) (5/4)^(2/5) integral X(t)^(-1/5) dt
//! ```
//!
//! over the time `t` of the linear collision. With contact from first touch to zero overlap, `X ~ exp(-g t) sin(w t)`, this
//! is a known integral (Gradshteyn & Ryzhik 3.631.1), and the contact time has a closed form that the paper does not give:
//!
//! ```text
//! tau/T = exp(L/10) (1 + L^2/pi^2)^(2/5) Gamma(9/10)^2 / |Gamma(9/10 + i L/(10 pi))|^2,   L = -ln e
//! ```
//!
//! Its slope at `L = 0` is 1/10 exactly (eq 28), its curvature 0.0474764137 (eq 29 fitted 0.0473), and for `e -> 0` it grows as
//! `1.1467633 e^(-1/5)`. Up to any other phase, and for critical and over-damping, the integral is done by quadrature; with
//! time `~ r^5` no singular point is left, neither at first touch nor at zero overlap.

use std::f64::consts::{FRAC_PI_2, PI};

use super::linear::LinearCollision;
use super::quadrature::integrate;

/// Contact time `T` of an undamped Hertzian collision, `(4/5) (5/4)^(2/5) sqrt(pi) Gamma(2/5)/Gamma(9/10)`.
pub const UNDAMPED: f64 = 3.218_065_459_719_043;

/// `(4/5) (5/4)^(2/5)`.
const SCALE: f64 = 0.874_689_659_154_622_5;

/// `tau/T` of the contact that ends at zero overlap, exact for every restitution `e` in (0, 1].
pub fn ratio_at_zero_overlap(restitution: f64) -> f64 {
    ratio_of_loss(-libm::log(restitution))
}

/// The same of `L = -ln e`.
pub(super) fn ratio_of_loss(l: f64) -> f64 {
    libm::exp(0.1 * l) * libm::pow(1.0 + l * l / (PI * PI), 0.4) * gamma_ratio(0.9, 0.1 * l / PI)
}

/// First order of `tau/T` in `ln e`, `1 - ln(e)/10` (eq 28). 6 % low at `e = 0.3`.
///
/// The denominator printed in eq 28, `tau(0)`, is a misprint for `tau(e = 1)`, as eq 29 has it.
pub fn contact_time_first_order(restitution: f64) -> f64 {
    1.0 - 0.1 * libm::log(restitution)
}

/// Quadratic fit of `tau/T`, `1 - 0.1 ln(e) + 0.0473 ln(e)^2` (eq 29): within 0.5 % from `e = 0.3`, 5.7 % low at `e = 0.01`.
pub fn contact_time_quadratic(restitution: f64) -> f64 {
    let l = -libm::log(restitution);
    1.0 + 0.1 * l + 0.0473 * l * l
}

/// `Gamma(x)^2 / |Gamma(x + i y)|^2` for `x > 0`, the product of `1 + y^2/(x + k)^2` over all `k >= 0`.
///
/// The first factors are multiplied; the logarithm of the rest is summed by Euler and Maclaurin (Stirling's series).
fn gamma_ratio(x: f64, y: f64) -> f64 {
    /// `2 B(2k) / (2k (2k - 1))` of Stirling's series.
    const STIRLING: [f64; 8] = [
        1.0 / 6.0,
        -1.0 / 180.0,
        1.0 / 630.0,
        -1.0 / 840.0,
        1.0 / 594.0,
        -691.0 / 180_180.0,
        1.0 / 78.0,
        -3617.0 / 61_200.0,
    ];
    const FACTORS: u8 = 14;
    let y2 = y * y;
    // the product less 1, which keeps its digits where y is small
    let mut excess = 0.0;
    for k in 0..FACTORS {
        let u = x + f64::from(k);
        let factor = y2 / (u * u);
        excess += factor + excess * factor;
    }
    let u = x + f64::from(FACTORS);
    let log = libm::log1p(y2 / (u * u));
    let mut sum = 2.0 * y * libm::atan2(y, u) - u * log + 0.5 * log;
    // powers of 1/(u + i y), every second one
    let square = u * u + y2;
    let (re1, im1) = (u / square, -y / square);
    let (re2, im2) = (re1 * re1 - im1 * im1, 2.0 * re1 * im1);
    let (mut re, mut im, mut real) = (re1, im1, 1.0 / u);
    for coefficient in STIRLING {
        sum -= coefficient * (re - real);
        (re, im) = (re * re2 - im * im2, re * im2 + im * re2);
        real /= u * u;
    }
    (1.0 + excess) * libm::exp(sum)
}

/// Time from first touch to the phase `s >= 0` of the linear collision ([`LinearCollision::at`]), any damping.
///
/// `s = 2` is the end at zero force. Beyond zero overlap there is no contact: the time stays at its value there.
pub fn until(linear: &LinearCollision, phase: f64) -> f64 {
    if phase <= 0.0 {
        return 0.0;
    }
    let turn = match linear.under_damped() {
        Some((angle, _)) => FRAC_PI_2 / angle,
        None => phase,
    };
    let first = from_touch(linear, phase.min(turn));
    match linear.under_damped() {
        Some((angle, sine)) if phase > turn => {
            // the angle left to pi; at the end at zero force it is pi - 2 arccos(g) = 2 arcsin(g), of which nothing is lost
            let left = match PI - angle * phase {
                _ if phase == 2.0 => 2.0 * libm::asin(linear.ratio()),
                rounding if rounding < 8.0 * f64::EPSILON => 0.0,
                left => left,
            };
            first + towards_zero_overlap(linear.ratio() / sine, sine, left)
        }
        _ => first,
    }
}

/// From first touch to `phase`, `s = r^5`: `X^(-1/5) ds = 5 r^3 (s/X)^(1/5) dr`.
fn from_touch(linear: &LinearCollision, phase: f64) -> f64 {
    let integrand = |r: f64| {
        let s = r * r * r * r * r;
        5.0 * r * r * r * libm::pow(s / linear.at(s).overlap, 0.2)
    };
    SCALE * linear.time_per_phase() * integrate(integrand, 0.0, libm::pow(phase, 0.2))
}

/// From the angle `pi/2` to `pi - left`, counted back from zero overlap: `pi - phi = r^5`.
fn towards_zero_overlap(cotangent: f64, sine: f64, left: f64) -> f64 {
    let integrand = |r: f64| {
        let angle = r * r * r * r * r;
        5.0 * r * r * r * libm::pow(angle / libm::sin(angle), 0.2) * libm::exp(0.2 * cotangent * (PI - angle))
    };
    SCALE * libm::pow(sine, -0.8) * integrate(integrand, libm::pow(left, 0.2), libm::pow(FRAC_PI_2, 0.2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::restitution::ContactEnd::{ZeroForce, ZeroOverlap};
    use crate::restitution::power::UndampedCollision;
    use approx::assert_relative_eq;

    #[test]
    fn the_gamma_ratio_agrees_with_thirty_digits() {
        for (y, ratio) in [
            (0.001, 1.000_001_922_540_996),
            (0.1, 1.019_329_308_547_451_6),
            (1.0, 4.259_002_722_467_928),
            (5.0, 332_957.734_989_846_1),
            (24.0, 7.949_619_636_419_499e30),
        ] {
            assert_relative_eq!(gamma_ratio(0.9, y), ratio, max_relative = 5e-15);
        }
        // |Gamma(1/2 + i y)|^2 = pi/cosh(pi y), |Gamma(1 + i y)|^2 = pi y/sinh(pi y)
        for y in [1e-6, 0.03, 0.7, 4.0, 30.0] {
            assert_relative_eq!(gamma_ratio(0.5, y), libm::cosh(PI * y), max_relative = 2e-14);
            assert_relative_eq!(gamma_ratio(1.0, y), libm::sinh(PI * y) / (PI * y), max_relative = 2e-14);
        }
    }

    #[test]
    fn contact_time_of_the_reference_table() {
        assert_relative_eq!(
            UNDAMPED,
            UndampedCollision::new(1.5).unwrap().contact_time(),
            max_relative = 2e-15
        );
        assert_relative_eq!(SCALE, 0.8 * libm::pow(1.25, 0.4), max_relative = 4e-16);
        for (e, tau, ratio, at_zero_force) in [
            (0.1, 4.861402527, 1.510659925, 2.53591828),
            (0.54, 3.477236761, 1.080536367, 2.89241253),
            (0.9, 3.253683413, 1.011068126, 3.12510775),
        ] {
            assert_relative_eq!(ratio_at_zero_overlap(e), ratio, max_relative = 4e-10);
            assert_relative_eq!(UNDAMPED * ratio_at_zero_overlap(e), tau, max_relative = 2e-10);
            let linear = LinearCollision::from_restitution(e, ZeroOverlap).unwrap();
            assert_relative_eq!(until(&linear, 2.0), at_zero_force, max_relative = 2e-9);
        }
        for (e, ratio) in [
            (1e-10, 117.754_117_034_343_72),
            (0.01, 2.612_389_747_416_498_8),
            (0.3, 1.194_865_739_521_979_7),
            (0.999999, 1.000_000_100_000_097_5),
        ] {
            assert_relative_eq!(ratio_at_zero_overlap(e), ratio, max_relative = 3e-15);
        }
    }

    #[test]
    fn quadrature_agrees_with_the_closed_form() {
        for e in [1.0, 1.0 - 1e-9, 0.99, 0.54, 0.2, 0.1, 1e-3, 1e-8, 1e-30] {
            let linear = LinearCollision::from_restitution(e, ZeroOverlap).unwrap();
            let end = linear.end_phase(ZeroOverlap).unwrap();
            let exact = UNDAMPED * ratio_at_zero_overlap(e);
            assert_relative_eq!(until(&linear, end), exact, max_relative = 1e-12);
        }
    }

    #[test]
    fn time_at_zero_force_agrees_with_thirty_digits_for_any_damping() {
        for (ratio, time) in [
            (0.0, UNDAMPED),
            (0.01, 3.180_206_131_427_796),
            (0.3, 2.777_409_824_810_329),
            (0.999, 2.290_743_552_595_659),
            (1.0, 2.290_230_441_701_279_8),
            (1.001, 2.289_717_683_835_039_5),
            (2.0, 1.903_214_870_431_890_4),
            (50.0, 0.413_376_991_088_593_2),
        ] {
            let linear = LinearCollision::new(ratio).unwrap();
            assert_relative_eq!(until(&linear, 2.0), time, max_relative = 1e-13);
        }
        assert!(until(&LinearCollision::new(1e140).unwrap(), 2.0).is_finite());
        for e in [1.0 - 1e-15, 1.0 - 1e-8, 1e-4, 1e-12] {
            let linear = LinearCollision::from_restitution(e, ZeroForce).unwrap();
            let nearly = until(&linear, 2.0 * (1.0 - 1e-9));
            assert!(
                nearly < until(&linear, 2.0) && nearly > 0.97 * until(&linear, 2.0),
                "{e}"
            );
        }
    }

    #[test]
    fn slope_curvature_and_limit_of_the_contact_time() {
        let ratio = |l: f64| ratio_at_zero_overlap(libm::exp(-l));
        let h = 1e-3;
        let slope = (ratio(h) - ratio(-h)) / (2.0 * h);
        let curvature = (ratio(h) - 2.0 + ratio(-h)) / (2.0 * h * h);
        assert_relative_eq!(slope, 0.1, max_relative = 1e-6);
        assert_relative_eq!(curvature, 0.0474764137, max_relative = 1e-6);
        // what is missing at large L falls as 1/L^2
        let scaled = |l: f64| ratio(l) * libm::exp(-0.2 * l);
        let limit = (4.0 * scaled(600.0) - scaled(300.0)) / 3.0;
        assert_relative_eq!(limit, 1.1467633, max_relative = 5e-8);
    }

    #[test]
    fn the_approximations_of_the_paper_are_as_good_as_documented() {
        let off = |approximate: fn(f64) -> f64, e| approximate(e) / ratio_at_zero_overlap(e) - 1.0;
        assert!((off(contact_time_quadratic, 0.01) + 0.057).abs() < 0.0005);
        for i in 30..=100 {
            assert!(off(contact_time_quadratic, f64::from(i) / 100.0).abs() < 0.005);
        }
        assert!((off(contact_time_first_order, 0.3) + 0.062).abs() < 0.0005);
    }
}
