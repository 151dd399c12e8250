//! Rosin-Rammler distribution by mass, drawn by number.

use super::random::RandomNumbers;
use libm::{exp, expm1, log1p, pow};

/// Strata of diameters; more make rejections rarer.
const STRATA: usize = 256;

/// Rosin-Rammler (Weibull) distribution by mass, `Q3(d) = 1 - exp(-(d/scale)^exponent)` (Rosin and Rammler 1933,
/// J. Inst. Fuel 7, 29), cut to an interval and drawn by number.
///
/// The interval is cut into strata of equal ratio of diameters. A stratum is chosen by the mass in it over the cube of
/// its smallest diameter, a diameter in it by the inverse of `Q3`, and kept with probability `(smallest / d)^3`. What
/// is kept has exactly the number density `q3 / d^3`, for any exponent and width.
#[derive(Clone, Debug)]
pub(super) struct RosinRammlerSampler {
    scale: f64,
    inverse_exponent: f64,
    strata: Vec<Stratum>,
    /// Relative weight up to and with each stratum, ending at 1.
    cumulative: Vec<f64>,
    mass_share: f64,
}

#[derive(Clone, Copy, Debug)]
struct Stratum {
    lower: f64,
    upper: f64,
    /// `(lower / scale)^exponent`.
    t_lower: f64,
    /// `exp(-(t_upper - t_lower)) - 1`, at most 0.
    fall: f64,
    /// Share of the uncut mass.
    mass: f64,
}

impl RosinRammlerSampler {
    pub(super) fn new(scale: f64, exponent: f64, lower: f64, upper: f64) -> Self {
        let power = |d: f64| pow(d / scale, exponent);
        let edge = |k: usize| match k {
            0 => lower,
            STRATA => upper,
            k => (lower * pow(upper / lower, k as f64 / STRATA as f64)).clamp(lower, upper),
        };
        let mut strata = Vec::with_capacity(STRATA);
        let mut cumulative = Vec::with_capacity(STRATA);
        let (mut sum, mut mass_share) = (0.0, 0.0);
        for k in 0..STRATA {
            let (from, to) = (edge(k), edge(k + 1));
            let (t_lower, t_upper) = (power(from), power(to));
            let fall = expm1(-(t_upper - t_lower).clamp(0.0, 1e3));
            // Beyond t = 700 nothing is left, and exp would underflow (or t be infinite).
            let mass = if t_lower < 700.0 { exp(-t_lower) * -fall } else { 0.0 };
            let relative = lower / from;
            sum += mass * relative * relative * relative;
            mass_share += mass;
            cumulative.push(sum);
            strata.push(Stratum {
                lower: from,
                upper: to,
                t_lower,
                fall,
                mass,
            });
        }
        for value in &mut cumulative {
            *value /= sum;
        }
        Self {
            scale,
            inverse_exponent: 1.0 / exponent,
            strata,
            cumulative,
            mass_share,
        }
    }

    /// Share of the uncut mass inside the bounds.
    pub(super) fn mass_share(&self) -> f64 {
        self.mass_share
    }

    /// Diameter below which the share `u` of the mass of a stratum lies.
    fn quantile(&self, stratum: &Stratum, u: f64) -> f64 {
        let t = stratum.t_lower - log1p(u * stratum.fall);
        (self.scale * pow(t, self.inverse_exponent)).clamp(stratum.lower, stratum.upper)
    }

    pub(super) fn draw(&self, random: &mut RandomNumbers) -> f64 {
        loop {
            let u = random.uniform();
            let found = self.cumulative.partition_point(|c| *c <= u).min(STRATA - 1);
            let stratum = &self.strata[found];
            let d = self.quantile(stratum, random.uniform());
            let keep = stratum.lower / d;
            if random.uniform() < keep * keep * keep {
                return d;
            }
        }
    }

    /// Mean of `d^power` by number, for a power of at most 3, by Simpson's rule in the mass of each stratum.
    pub(super) fn mean_of_power(&self, power: u32) -> f64 {
        const INTERVALS: u32 = 32;
        let (mut numbers, mut sum) = (0.0, 0.0);
        for stratum in self.strata.iter().filter(|s| s.mass > 0.0) {
            for k in 0..=INTERVALS {
                let simpson = match k {
                    0 | INTERVALS => 1.0,
                    k if k % 2 == 1 => 4.0,
                    _ => 2.0,
                };
                let d = self.quantile(stratum, f64::from(k) / f64::from(INTERVALS));
                // Relative to the smallest diameter, so that tiny grains do not overflow.
                let relative = self.strata[0].lower / d;
                let weight = simpson * stratum.mass * relative * relative * relative;
                numbers += weight;
                sum += weight * (0..power).fold(1.0, |product, _| product * d);
            }
        }
        sum / numbers
    }
}
