//! A root and a minimum in an interval, with few evaluations: each is a run (Brent, Algorithms for Minimization without
//! Derivatives, 1973, chapters 4 and 5).
//!
//! A value may be infinite: there is no answer, as beyond a fold. The root and the least lie towards the end of the interval that has an
//! answer, and the search halves the interval there.

/// Largest number of evaluations; halving alone takes 40 of them for an accuracy of 1e-12 of the interval.
pub(super) const MOST: usize = 60;
/// Part of an interval that a golden section step takes, `(3 - sqrt(5))/2`.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

/// What a search came to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Found {
    /// The value, and the interval in which the exact one lies.
    Inside { value: f64, bracket: (f64, f64) },
    /// All values of the interval are too small, or the least is at its upper end.
    Upper,
    /// All values of the interval are too large, or the least is at its lower end.
    Lower,
    /// Neither end of the interval has an answer.
    Nowhere,
}

/// Something that is zero in an interval and rises or falls through it, evaluated at rounded places. Where one end has no answer the root
/// is taken to lie between them, until a place between the ends is farther from zero than the other end is.
pub(super) fn root<E>(
    (from, to): (f64, f64),
    tolerance: f64,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<Found, E> {
    let (mut a, mut fa) = (from, f(from)?);
    let (mut b, mut fb) = (to, f(to)?);
    let mut answered = None;
    match (fa.is_finite(), fb.is_finite()) {
        (true, true) => {}
        (true, false) => {
            fb = f64::INFINITY.copysign(-fa);
            answered = Some((fa, Found::Lower));
        }
        (false, true) => {
            fa = f64::INFINITY.copysign(-fb);
            answered = Some((fb, Found::Upper));
        }
        (false, false) => return Ok(Found::Nowhere),
    }
    let folded = if fa.is_finite() { fb } else { fa };
    if (fa > 0.0) == (fb > 0.0) && fa != 0.0 && fb != 0.0 {
        return Ok(if fa.abs() < fb.abs() {
            Found::Lower
        } else {
            Found::Upper
        });
    }
    let (mut c, mut fc) = (a, fa);
    let mut before_last = b - a;
    let mut last = before_last;
    for _ in 2..MOST {
        if fb != 0.0 && (fb > 0.0) == (fc > 0.0) {
            (c, fc) = (a, fa);
            last = b - a;
            before_last = last;
        }
        if fc.abs() < fb.abs() {
            (a, b, c) = (b, c, b);
            (fa, fb, fc) = (fb, fc, fb);
        }
        let middle = 0.5 * (c - b);
        if middle.abs() <= tolerance || fb == 0.0 {
            break;
        }
        let step = interpolated((a, fa), (b, fb), (c, fc));
        let short = |step: &f64| {
            *step * middle > 0.0
                && step.abs() < 1.5 * middle.abs() - 0.5 * tolerance
                && step.abs() < 0.5 * before_last.abs()
        };
        (before_last, last) = match step.filter(short) {
            Some(step) if before_last.abs() >= tolerance => (last, step),
            _ => (middle, middle),
        };
        (a, fa) = (b, fb);
        b += if last.abs() > tolerance {
            last
        } else {
            tolerance.copysign(middle)
        };
        fb = f(b)?;
        if !fb.is_finite() {
            fb = folded;
        } else if let Some((end, beyond)) = answered.take()
            && (fb > 0.0) == (end > 0.0)
            && fb.abs() > end.abs()
        {
            return Ok(beyond);
        }
    }
    let bracket = if fb == 0.0 { (b, b) } else { (b.min(c), b.max(c)) };
    Ok(Found::Inside { value: b, bracket })
}

/// Step from `b` to the root of what goes through the points, as far as they are finite.
fn interpolated((a, fa): (f64, f64), (b, fb): (f64, f64), (c, fc): (f64, f64)) -> Option<f64> {
    let secant = |x: f64, fx: f64| (fx.is_finite() && fx != fb).then(|| fb * (b - x) / (fx - fb));
    if a == c || !fa.is_finite() {
        return secant(c, fc);
    }
    if !fc.is_finite() {
        return secant(a, fa);
    }
    if fa == fb || fa == fc {
        return secant(c, fc);
    }
    let (q, r, s) = (fa / fc, fb / fc, fb / fa);
    let p = s * ((c - b) * q * (q - r) - (b - a) * (r - 1.0));
    let q = (q - 1.0) * (r - 1.0) * (s - 1.0);
    Some(-p / q).filter(|step| step.is_finite())
}

/// The least value in an interval.
pub(super) fn least<E>(
    (from, to): (f64, f64),
    tolerance: f64,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<Found, E> {
    let (mut low, mut high) = (from, to);
    let mut x = low + GOLDEN * (high - low);
    let mut fx = f(x)?;
    // the second and the third of the values found so far
    let (mut w, mut fw, mut v, mut fv) = (x, fx, x, fx);
    let (mut last, mut before_last) = (0.0f64, 0.0f64);
    let step = 0.5 * tolerance;
    let mut answered = None;
    for _ in 1..MOST {
        let middle = 0.5 * (low + high);
        if (x - middle).abs() <= 2.0 * step - 0.5 * (high - low) {
            break;
        }
        let way = parabolic((x, fx), (w, fw), (v, fv)).filter(|way| {
            before_last.abs() > step && way.abs() < 0.5 * before_last.abs() && x + way > low && x + way < high
        });
        (before_last, last) = match way {
            // not too close to an end
            Some(way) if x + way - low < 2.0 * step || high - x - way < 2.0 * step => (last, step.copysign(middle - x)),
            Some(way) => (last, way),
            None => {
                let rest = if x < middle { high - x } else { low - x };
                (rest, GOLDEN * rest)
            }
        };
        let u = x + if last.abs() >= step { last } else { step.copysign(last) };
        let fu = f(u)?;
        let better = if fx.is_finite() || fu.is_finite() {
            fu <= fx
        } else {
            let lower = match answered {
                Some(lower) => lower,
                None if f(from)?.is_finite() => true,
                None if f(to)?.is_finite() => false,
                None => return Ok(Found::Nowhere),
            };
            answered = Some(lower);
            (u < x) == lower
        };
        if better {
            *(if u < x { &mut high } else { &mut low }) = x;
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            *(if u < x { &mut low } else { &mut high }) = u;
            if fu <= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu <= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    // the search never reaches an end, but comes as near as the tolerance
    if low == from && x - from <= 2.0 * tolerance {
        return Ok(Found::Lower);
    }
    if high == to && to - x <= 2.0 * tolerance {
        return Ok(Found::Upper);
    }
    let bracket = (low, high);
    Ok(Found::Inside { value: x, bracket })
}

/// Way from the first point to the least of a parabola.
fn parabolic((x, fx): (f64, f64), (w, fw): (f64, f64), (v, fv): (f64, f64)) -> Option<f64> {
    let (r, q) = ((x - w) * (fx - fv), (x - v) * (fx - fw));
    let p = (x - v) * q - (x - w) * r;
    let way = -0.5 * p / (q - r);
    way.is_finite().then_some(way)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::RefCell;

    type Place = Result<f64, ()>;

    /// A search, and how many evaluations it took.
    fn counted(
        search: impl FnOnce(&dyn Fn(f64) -> Place) -> Result<Found, ()>,
        f: impl Fn(f64) -> f64,
    ) -> (Found, usize) {
        let seen = RefCell::new(0);
        let found = search(&|x| {
            *seen.borrow_mut() += 1;
            Ok(f(x))
        });
        (found.unwrap(), seen.into_inner())
    }

    fn assert_inside(found: Found, expected: f64, tolerance: f64) {
        let Found::Inside { value, bracket } = found else {
            panic!("{found:?}");
        };
        assert!((value - expected).abs() <= 2.0 * tolerance, "{found:?}");
        assert!(bracket.0 <= expected && expected <= bracket.1, "{found:?}");
        assert!(bracket.1 - bracket.0 <= 2.001 * tolerance, "{found:?}");
    }

    #[test]
    fn a_root_takes_few_evaluations() {
        // the force of the hydrogel packing against the prefactor, roughly
        let force = |x: f64| 0.43 + 0.37 * x + 0.13 * x * x * x * x - 1.0;
        let (found, evaluations) = counted(|f| root((0.8, 1.3), 0.005, f), force);
        assert_inside(found, 1.073_659, 0.005);
        assert!(evaluations <= 5, "{evaluations}");
        let falling = |x: f64| 1.0 / x - 0.5;
        let (found, evaluations) = counted(|f| root((1.0, 10.0), 1e-9, f), falling);
        assert_inside(found, 2.0, 1e-9);
        assert!(evaluations <= 14, "{evaluations}");
    }

    #[test]
    fn a_root_is_found_beside_a_fold() {
        // no answer above 1.05
        let folded = |x: f64| if x > 1.05 { f64::INFINITY } else { x - 1.0 };
        let (found, evaluations) = counted(|f| root((0.0, 2.0), 0.001, f), folded);
        assert_inside(found, 1.0, 0.001);
        assert!(evaluations <= 12, "{evaluations}");
        let cliff = |x: f64| if x > 0.7 { f64::INFINITY } else { -1.0 };
        let (found, _) = counted(|f| root((0.0, 2.0), 0.001, f), cliff);
        assert_inside(found, 0.7, 0.001);
    }

    #[test]
    fn a_fold_may_lie_at_either_end() {
        // as the force of a packing against its modulus: no answer where it is soft
        let soft = |x: f64| if x < 0.6 { f64::INFINITY } else { x - 1.0 };
        assert_inside(counted(|f| root((0.0, 2.0), 0.001, f), soft).0, 1.0, 0.001);
        let (found, evaluations) = counted(|f| root((0.0, 0.9), 0.001, f), soft);
        assert_eq!((found, evaluations), (Found::Upper, 4));
        let squares = |x: f64| soft(x) * soft(x);
        assert_inside(counted(|f| least((0.0, 2.0), 0.01, f), squares).0, 1.0, 0.01);
        let steep = |x: f64| if x < 0.9 { f64::INFINITY } else { (x - 1.0) * (x - 1.0) };
        assert_inside(counted(|f| least((0.0, 1.2), 0.01, f), steep).0, 1.0, 0.01);
        let hard = |x: f64| if x > 0.2 { f64::INFINITY } else { x - 0.1 };
        assert_inside(counted(|f| root((0.0, 2.0), 0.001, f), hard).0, 0.1, 0.001);
        assert_eq!(counted(|f| root((0.15, 0.3), 0.001, f), hard).0, Found::Lower);
        assert_inside(
            counted(|f| least((0.0, 2.0), 0.001, f), |x| hard(x) * hard(x)).0,
            0.1,
            0.001,
        );
        let nowhere = |_: f64| f64::INFINITY;
        assert_eq!(counted(|f| root((0.0, 1.0), 0.1, f), nowhere).0, Found::Nowhere);
        assert_eq!(counted(|f| least((0.0, 1.0), 0.1, f), nowhere).0, Found::Nowhere);
    }

    #[test]
    fn a_root_outside_is_told_by_the_nearer_end() {
        assert_eq!(counted(|f| root((0.0, 1.0), 0.1, f), |x| x - 2.0).0, Found::Upper);
        assert_eq!(counted(|f| root((0.0, 1.0), 0.1, f), |x| x + 2.0).0, Found::Lower);
        let (found, evaluations) = counted(|f| root((0.0, 1.0), 0.1, f), |x| x - 1.0);
        let Found::Inside { value, bracket } = found else {
            panic!("{found:?}");
        };
        assert_eq!((value, bracket, evaluations), (1.0, (1.0, 1.0), 2));
    }

    #[test]
    fn the_least_of_a_parabola_and_of_something_else() {
        let (found, evaluations) = counted(|f| least((0.0, 1.0), 0.01, f), |x| (x - 0.3) * (x - 0.3) + 2.0);
        assert_inside(found, 0.3, 0.01);
        assert!(evaluations <= 8, "{evaluations}");
        let (found, evaluations) = counted(|f| least((0.0, 1.0), 0.001, f), |x: f64| (x - 0.62).abs());
        assert_inside(found, 0.62, 0.001);
        assert!(evaluations <= 20, "{evaluations}");
        let folded = |x: f64| if x > 0.35 { f64::INFINITY } else { (x - 0.3) * (x - 0.3) };
        assert_inside(counted(|f| least((0.0, 1.0), 0.01, f), folded).0, 0.3, 0.01);
    }

    #[test]
    fn the_least_at_an_end_is_told() {
        assert_eq!(counted(|f| least((0.0, 1.0), 0.01, f), |x| x).0, Found::Lower);
        assert_eq!(counted(|f| least((0.0, 1.0), 0.01, f), |x| -x).0, Found::Upper);
    }

    #[test]
    fn a_fault_ends_the_search() {
        assert_eq!(root((0.0, 1.0), 0.1, |_| Err("fault")), Err("fault"));
        assert_eq!(least((0.0, 1.0), 0.1, |_| Err("fault")), Err("fault"));
    }
}
