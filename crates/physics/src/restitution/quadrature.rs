//! Gauss-Legendre quadrature over panels that are doubled until nothing changes.

/// Positive abscissae and weights of the 16-point Gauss-Legendre rule on [-1, 1] (zeros of `P16`, computed to 20 digits).
const RULE: [[f64; 2]; 8] = [
    [0.989_400_934_991_649_9, 0.027_152_459_411_754_095],
    [0.944_575_023_073_232_6, 0.062_253_523_938_647_893],
    [0.865_631_202_387_831_8, 0.095_158_511_682_492_79],
    [0.755_404_408_355_003, 0.124_628_971_255_533_87],
    [0.617_876_244_402_643_8, 0.149_595_988_816_576_73],
    [0.458_016_777_657_227_39, 0.169_156_519_395_002_54],
    [0.281_603_550_779_258_9, 0.182_603_415_044_923_59],
    [0.095_012_509_837_637_44, 0.189_450_610_455_068_5],
];

/// Most panels an interval is cut into.
const MOST_PANELS: u32 = 512;

/// Integral of `f` from `a` to `b`, to some 1e-15 of it where `f` is analytic on the interval.
pub(super) fn integrate(f: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let mut panels = 2;
    let mut last = over_panels(&f, a, b, 1);
    loop {
        let next = over_panels(&f, a, b, panels);
        if (next - last).abs() <= 4.0 * f64::EPSILON * next.abs() || panels >= MOST_PANELS {
            return next;
        }
        last = next;
        panels *= 2;
    }
}

fn over_panels(f: &impl Fn(f64) -> f64, a: f64, b: f64, panels: u32) -> f64 {
    let half = 0.5 * (b - a) / f64::from(panels);
    let mut sum = 0.0;
    for panel in 0..panels {
        let middle = a + half * f64::from(2 * panel + 1);
        for [x, weight] in RULE {
            sum += weight * (f(middle - half * x) + f(middle + half * x));
        }
    }
    half * sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rule_is_exact_for_polynomials_of_degree_31() {
        for degree in 0..32u32 {
            let exact = if degree % 2 == 0 {
                2.0 / f64::from(degree + 1)
            } else {
                0.0
            };
            let sum = over_panels(&|x: f64| libm::pow(x, f64::from(degree)), -1.0, 1.0, 1);
            assert!((sum - exact).abs() < 2e-16 * 8.0, "degree {degree}: {sum} not {exact}");
        }
        let steep = integrate(|x| libm::exp(30.0 * x), 0.0, 1.0);
        assert!((steep * 30.0 / libm::expm1(30.0) - 1.0).abs() < 1e-14);
    }
}
