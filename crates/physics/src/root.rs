//! A bracketed root by Chandrupatla's method (1997): inverse quadratic steps where they are safe, halving elsewhere.

use std::convert::Infallible;

/// Root of `f` between `a` and `b`, where `f` has opposite signs (or is zero at one of them), to the last bits of it.
///
/// Where the signs do not differ, the end with the smaller `|f|` comes back.
pub fn bracketed(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let ends = ((a, f(a)), (b, f(b)));
    match between(|x| Ok::<f64, Infallible>(f(x)), ends, 0.0) {
        Ok(root) => root,
    }
}

/// As [`bracketed`], of a function that may fail, with two ends `(x, f(x))` that are known already, and done as soon as
/// `|f|` is at most `accuracy`.
pub(crate) fn between<E>(
    f: impl Fn(f64) -> Result<f64, E>,
    ends: ((f64, f64), (f64, f64)),
    accuracy: f64,
) -> Result<f64, E> {
    const MOST_STEPS: usize = 200;
    let ((mut b, mut fb), (mut a, mut fa)) = ends;
    if fa * fb > 0.0 {
        return Ok(if fa.abs() < fb.abs() { a } else { b });
    }
    let mut share = 0.5;
    for _ in 0..MOST_STEPS {
        let x = a + share * (b - a);
        let fx = f(x)?;
        // the third point is the one that leaves the bracket
        let (c, fc) = if (fx < 0.0) == (fa < 0.0) { (a, fa) } else { (b, fb) };
        if (fx < 0.0) != (fa < 0.0) {
            (b, fb) = (a, fa);
        }
        (a, fa) = (x, fx);
        let (best, fbest) = if fa.abs() < fb.abs() { (a, fa) } else { (b, fb) };
        let tolerance = 2.0 * f64::EPSILON * best.abs();
        let least_share = 0.5 * tolerance / (b - a).abs();
        if fbest.abs() <= accuracy || least_share > 0.5 {
            return Ok(best);
        }
        let xi = (a - b) / (c - b);
        let phi = (fa - fb) / (fc - fb);
        let quadratic_is_safe = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        share = if quadratic_is_safe {
            fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        } else {
            0.5
        };
        share = share.clamp(least_share, 1.0 - least_share);
    }
    Ok(if fa.abs() < fb.abs() { a } else { b })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_steep_and_flat_roots() {
        assert!((bracketed(|x| x * x - 2.0, 0.0, 2.0) - 2f64.sqrt()).abs() < 1e-15);
        assert!((bracketed(|x| libm::exp(40.0 * x) - 1e10, 0.0, 1.0) - libm::log(1e10) / 40.0).abs() < 1e-15);
        assert!((bracketed(|x| (x - 0.3) * (x - 0.3) * (x - 0.3), 1.0, -2.0) - 0.3).abs() < 1e-5);
        assert_eq!(bracketed(|x| x, 0.0, 1.0), 0.0);
        assert_eq!(bracketed(|x| x + 1.0, 0.0, 1.0), 0.0);
    }
}
