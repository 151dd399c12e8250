//! Adaptive explicit Runge-Kutta steps of order 8 for small systems that do not depend on time.
//!
//! A step comes with an estimate of its error; a caller that wants to end a step on an event, such as the zero of a
//! velocity, does the step again with other lengths until the event lies at its end ([`locate`]). That places events
//! to rounding, where an interpolation would place them to its own order.

use super::dormand_prince::{ERROR_5, INNER, STAGES, WEIGHTS, WEIGHTS_3};

/// A tried step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trial<const N: usize> {
    /// State at the end of the step.
    pub end: [f64; N],
    /// Estimated error over what is allowed: at most 1 in a step to be accepted; infinite when a value is not finite.
    pub error: f64,
}

/// One step of length `h` from `start`. `allowed` is the error allowed in every component.
pub fn step<const N: usize>(
    rates: impl Fn(&[f64; N]) -> [f64; N],
    start: &[f64; N],
    h: f64,
    allowed: &[f64; N],
) -> Trial<N> {
    let mut slopes = [[0.0; N]; STAGES];
    slopes[0] = rates(start);
    for (stage, weights) in INNER.iter().enumerate() {
        let mut at = *start;
        for (i, value) in at.iter_mut().enumerate() {
            *value += h * weights
                .iter()
                .map(|&(from, weight)| weight * slopes[from][i])
                .sum::<f64>();
        }
        slopes[stage + 1] = rates(&at);
    }
    let sum = |weights: &[f64; STAGES], i: usize| weights.iter().zip(&slopes).map(|(w, k)| w * k[i]).sum::<f64>();
    let mut end = *start;
    let (mut fifth, mut third) = (0.0, 0.0);
    for i in 0..N {
        let mean = sum(&WEIGHTS, i);
        end[i] += h * mean;
        let scaled = |difference: f64| {
            let share = difference / allowed[i];
            share * share
        };
        fifth += scaled(sum(&ERROR_5, i));
        third += scaled(mean - sum(&WEIGHTS_3, i));
    }
    // both estimates together behave as one of order 8 (Hairer, Norsett and Wanner, section II.10)
    let both = fifth + 0.01 * third;
    let error = if both > 0.0 {
        h.abs() * fifth / (both * N as f64).sqrt()
    } else {
        0.0
    };
    let finite = error.is_finite() && both.is_finite() && end.iter().all(|x| x.is_finite());
    Trial {
        end,
        error: if finite { error } else { f64::INFINITY },
    }
}

/// Least and largest factor from one step to the next.
const FACTORS: (f64, f64) = (0.1, 8.0);

/// By which factor the next step should be longer than one with this error.
pub fn step_factor(error: f64) -> f64 {
    if error <= 0.0 {
        return FACTORS.1;
    }
    (0.9 * libm::pow(error, -0.125)).clamp(FACTORS.0, FACTORS.1)
}

/// Most evaluations of one search for an event.
const MAX_EVALUATIONS: usize = 200;

/// Where a function that has the value `lower.1` at `lower.0` and another sign (or 0) at `upper` is zero, to rounding:
/// the side of `upper`. Illinois method with bisection where it is slow.
pub fn locate(mut function: impl FnMut(f64) -> f64, lower: (f64, f64), upper: (f64, f64)) -> f64 {
    let ((mut a, mut fa), (mut b, mut fb)) = (lower, upper);
    let mut width = (b - a).abs();
    let mut kept_lower = None;
    for turn in 0..MAX_EVALUATIONS {
        if fb == 0.0 || (b - a).abs() <= 2.0 * f64::EPSILON * a.abs().max(b.abs()) {
            break;
        }
        let secant = b - fb * (b - a) / (fb - fa);
        let inside = secant > a.min(b) && secant < a.max(b);
        // every third turn the bracket must have become much smaller
        let slow = turn % 3 == 2 && (b - a).abs() > 0.25 * std::mem::replace(&mut width, (b - a).abs());
        let c = if inside && !slow { secant } else { 0.5 * (a + b) };
        if c == a || c == b {
            break;
        }
        let fc = function(c);
        if fc == 0.0 {
            return c;
        }
        if (fc > 0.0) == (fa > 0.0) {
            (a, fa) = (c, fc);
            fb *= if kept_lower == Some(false) { 0.5 } else { 1.0 };
            kept_lower = Some(false);
        } else {
            (b, fb) = (c, fc);
            fa *= if kept_lower == Some(true) { 0.5 } else { 1.0 };
            kept_lower = Some(true);
        }
    }
    b
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Rotation in the plane: `x'' = -x`.
    fn circle(y: &[f64; 2]) -> [f64; 2] {
        [y[1], -y[0]]
    }

    #[test]
    fn weights_are_consistent() {
        assert_relative_eq!(WEIGHTS.iter().sum::<f64>(), 1.0, max_relative = 1e-14);
        assert_relative_eq!(WEIGHTS_3.iter().sum::<f64>(), 1.0, max_relative = 1e-14);
        assert!(ERROR_5.iter().sum::<f64>().abs() < 1e-14);
        let nodes: Vec<f64> = std::iter::once(0.0)
            .chain(INNER.iter().map(|row| row.iter().map(|(_, w)| w).sum()))
            .collect();
        assert_relative_eq!(nodes[STAGES - 1], 1.0, max_relative = 1e-13);
        // quadrature conditions of order 8
        for power in 1..8 {
            let mean: f64 = WEIGHTS.iter().zip(&nodes).map(|(w, c)| w * c.powi(power)).sum();
            assert_relative_eq!(mean, 1.0 / f64::from(power + 1), max_relative = 1e-13);
        }
    }

    #[test]
    fn a_step_is_of_order_eight_and_knows_its_error() {
        let error = |h: f64| {
            let trial = step(circle, &[1.0, 0.0], h, &[1.0; 2]);
            let exact = [libm::cos(h), -libm::sin(h)];
            let distance = (trial.end[0] - exact[0]).hypot(trial.end[1] - exact[1]);
            assert!(trial.error > distance, "{} {distance}", trial.error);
            distance
        };
        // order 8: the error of one step falls as the ninth power
        let order = libm::log2(error(0.8) / error(0.4));
        assert!((8.7..9.6).contains(&order), "{order}");
    }

    #[test]
    fn what_is_not_finite_is_never_accepted() {
        let trial = step(|y: &[f64; 1]| [1.0 / (y[0] - y[0])], &[1.0], 0.1, &[1.0]);
        assert_eq!(trial.error, f64::INFINITY);
    }

    #[test]
    fn zeros_are_found_to_rounding() {
        let root = locate(libm::cos, (0.0, 1.0), (2.0, libm::cos(2.0)));
        assert_relative_eq!(root, std::f64::consts::FRAC_PI_2, max_relative = 1e-15);
        // flat on one side, steep on the other
        let mut count = 0;
        let steep = |x: f64| {
            count += 1;
            if x < 1e-9 { 1e-12 } else { 1e-9 - x }
        };
        let root = locate(steep, (0.0, 1e-12), (1.0, -1.0));
        assert_relative_eq!(root, 1e-9, max_relative = 1e-6);
        assert!(count < 190, "{count}");
    }
}
