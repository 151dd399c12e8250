//! The exact displacement, with the slow sum `T` made fast.
//!
//! With `q_0 = (B n + C)/D(n)`, `D = n^2 + a n + b`, every step `q_j (n) = B_j/(n + j + 1) + q_(j+1)(n)/(n + j + 1)` leaves a
//! rest of the same form, `q_j = (B_j n + C_j)/D`. So `q_0` is a sum of `B_j/((n + 1) ... (n + j + 1))`, whose series are
//! known, and a rest that falls as `n^-7`.

/// Terms of `T` that are summed in closed form.
const CLOSED: usize = 6;
/// Terms of the rest; what is left out is below 1e-14 of the displacement.
const TERMS: usize = 300;

/// The displacement of one Poisson's ratio, ready to be summed.
pub(super) struct Series {
    nu: f64,
    /// `B_j`.
    closed: [f64; CLOSED],
    /// What is left of the coefficient of `P_n`, from `n = 2`.
    rest: [f64; TERMS],
}

impl Series {
    pub(super) fn new(nu: f64) -> Self {
        let (a, b) = (1.0 + 2.0 * nu, 1.0 + nu);
        let (mut slope, mut constant) = (1.0 - 8.0 * nu + 8.0 * nu * nu, -2.0 - nu + 4.0 * nu * nu);
        let closed = std::array::from_fn(|j| {
            let (factor, this) = ((j + 1) as f64, slope);
            slope = (factor - a) * this + constant;
            constant = factor * constant - b * this;
            this
        });
        let rest = std::array::from_fn(|place| {
            let n = (place + 2) as f64;
            let factors: f64 = (1..=CLOSED).map(|j| n + j as f64).product();
            (slope * n + constant) / (n * n + a * n + b) / factors
        });
        Self { nu, closed, rest }
    }

    /// `g` at `square = sin^2(theta/2)`, between 0 and 1.
    pub(super) fn at(&self, square: f64) -> f64 {
        let (nu, sine, cosine) = (self.nu, square.sqrt(), 1.0 - 2.0 * square);
        let (log, log_more) = (libm::log(sine), libm::log1p(sine));
        let zeroth = 0.5 / sine - 1.0 - cosine;
        let first = 1.0 - 2.0 * sine - cosine - cosine * (log + log_more);
        let slow = self.closed_part(sine, cosine, log_more - log) + self.rest(cosine);
        let low = (1.0 - 2.0 * nu) / (1.0 + nu) * (1.0 + 1.5 * cosine);
        -(4.0 * (1.0 - nu) * zeroth + first + slow + low)
    }

    /// Sum of `B_j K_j` with `K_j`, the sum of `P_n/((n + 1) ... (n + j + 1))` from `n = 2`: the integral of
    /// `(1 - t)^j/j!` times the generating function of the `P_n` over `0 < t < 1`, less the first two terms.
    fn closed_part(&self, sine: f64, cosine: f64, integral_0: f64) -> f64 {
        let square = 4.0 * sine * sine;
        // integrals of t^j/sqrt(t^2 - 4 s^2 t + 4 s^2)
        let (mut before, mut integral) = (0.0, integral_0);
        let (mut sum, mut factorial) = (0.0, 1.0);
        for (j, b) in self.closed.iter().enumerate() {
            let j = j as f64;
            if j > 0.0 {
                let ends = if j > 1.0 { 1.0 } else { 1.0 - 2.0 * sine };
                let next = (ends + (j - 0.5) * square * integral - (j - 1.0) * square * before) / j;
                (before, integral) = (integral, next);
                factorial *= j;
            }
            let first_two = (1.0 + cosine / (j + 2.0)) / (j + 1.0);
            sum += b * (integral - first_two) / factorial;
        }
        sum
    }

    fn rest(&self, cosine: f64) -> f64 {
        let (mut before, mut legendre) = (1.0, cosine);
        let mut sum = 0.0;
        for (place, coefficient) in self.rest.iter().enumerate() {
            let n = (place + 2) as f64;
            let next = ((2.0 * n - 1.0) * cosine * legendre - (n - 1.0) * before) / n;
            (before, legendre) = (legendre, next);
            sum += coefficient * legendre;
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    fn at(nu: f64, degrees: f64) -> f64 {
        let sine = libm::sin(degrees * PI / 360.0);
        Series::new(nu).at(sine * sine)
    }

    /// Displacement of the mode `n >= 2` at the surface by the pressure `(2 n + 1) P_n`, from the two conditions there: units
    /// in which `(1 + nu)/E` and `R` are 1.
    fn mode(nu: f64, n: f64) -> f64 {
        // pressure and shear by the amplitudes of both solutions (Lur'e), `[[p_a, p_b], [t_a, t_b]]`
        let pressure = [(n + 1.0) * (n * n - n - 2.0 - 2.0 * nu), n * (n - 1.0)];
        let shear = [n * n + 2.0 * n - 1.0 + 2.0 * nu, n - 1.0];
        let determinant = pressure[0] * shear[1] - pressure[1] * shear[0];
        let given = -(2.0 * n + 1.0);
        let (a, b) = (given * shear[1] / determinant, -given * shear[0] / determinant);
        a * (n + 1.0) * (n - 2.0 + 4.0 * nu) + b * n
    }

    /// 1 far below `x = 1` and 0 beyond it, with all derivatives.
    fn fading(x: f64) -> f64 {
        let bump = |x: f64| if x > 0.0 { libm::exp(-1.0 / x) } else { 0.0 };
        bump(1.0 - x) / (bump(1.0 - x) + bump(x - 0.1))
    }

    /// The plain sum of the modes that fade out: as exact as many terms as one takes.
    fn sum_of_modes(nu: f64, cosine: f64) -> f64 {
        const MODES: u32 = 4000;
        let (mut before, mut legendre) = (1.0, cosine);
        let mut sum = -(1.0 - 2.0 * nu) / (1.0 + nu) * (1.0 + 1.5 * cosine);
        for n in (2..MODES).map(f64::from) {
            let next = ((2.0 * n - 1.0) * cosine * legendre - (n - 1.0) * before) / n;
            (before, legendre) = (legendre, next);
            sum += fading(n / f64::from(MODES)) * mode(nu, n) * legendre;
        }
        sum
    }

    #[test]
    fn is_the_sum_of_the_modes_of_a_sphere() {
        for nu in [-0.9, -0.4, 0.0, 0.3, 0.5] {
            for degrees in [15.0, 40.0, 77.0, 90.0, 120.0, 165.0, 180.0] {
                let expected = sum_of_modes(nu, libm::cos(degrees * PI / 180.0));
                assert_relative_eq!(at(nu, degrees), expected, epsilon = 1e-9, max_relative = 1e-9);
            }
        }
    }

    const REFERENCE: &[(f64, f64, f64)] = &[
        (0.5, 0.01, -11_456.500_112_198_99),
        (0.5, 2.0, -54.588_810_114_089_48),
        (0.5, 15.0, -4.607_895_349_671_053),
        (0.5, 30.0, -0.550_002_591_199_851),
        (0.5, 90.0, 0.867_939_903_700_365_8),
        (0.5, 150.0, -1.097_410_085_884_511_3),
        (0.5, 180.0, -1.478_487_789_915_240_7),
        (0.3, 0.01, -16_041.404_673_554_065),
        (0.3, 2.0, -77.095_480_287_771_64),
        (0.3, 30.0, -1.278_889_854_522_549),
        (0.3, 90.0, 0.781_424_743_318_310_7),
        (0.3, 180.0, -1.703_918_332_461_119_1),
        (-0.5, 0.01, -34_442.286_395_408_26),
        (-0.5, 2.0, -194.181_006_437_552_67),
        (-0.5, 15.0, -28.557_456_298_582_5),
        (-0.5, 30.0, -11.627_992_683_995_238),
        (-0.5, 90.0, -0.736_216_082_541_923_2),
        (-0.5, 150.0, -2.906_596_943_925_331_6),
        (-0.5, 180.0, -3.462_444_187_586_551_7),
        (-0.95, 0.01, -44_976.836_869_065_17),
        (-0.95, 2.0, -419.493_381_890_868_36),
        (-0.95, 15.0, -183.286_819_852_869_34),
        (-0.95, 30.0, -143.325_010_263_213_24),
        (-0.95, 90.0, -49.060_766_660_986_36),
        (-0.95, 150.0, 6.492_664_420_440_634),
        (-0.95, 180.0, 14.023_182_123_630_5),
    ];

    /// From the integral of the generating function with the roots of the denominator, to 30 digits.
    #[test]
    fn reference_values() {
        for &(nu, degrees, expected) in REFERENCE {
            assert_relative_eq!(at(nu, degrees), expected, max_relative = 1e-13);
        }
    }
}
