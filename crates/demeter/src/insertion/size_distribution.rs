//! Drawing diameters from a size distribution.
//!
//! Everything is drawn by number. A distribution by mass with density `q3(d)` has the number density
//! `q0(d) ~ q3(d) / d^3` (ISO 9276-2), since all grains of a batch have one mass density.

use super::random::{RandomNumbers, normal_below, normal_quantile};
use super::rosin_rammler::RosinRammlerSampler;
use super::spec::{Basis, SizeDistribution};
pub(super) use crate::grain_files::DIAMETERS;
use libm::{exp, log};
use std::f64::consts::PI;
use thiserror::Error;

/// Smallest share of a distribution that its bounds must hold.
const SMALLEST_SHARE: f64 = 1e-9;

/// Why a size distribution cannot be used.
#[derive(Clone, Debug, PartialEq, Error)]
#[allow(missing_docs)]
pub enum SizeError {
    #[error("size distribution: {what} is {value:?}; allowed are 1e-12 m to 1e6 m")]
    Diameter { what: &'static str, value: f64 },
    #[error("size distribution: {what} is {value}; it must be a finite number above {above}")]
    Parameter { what: &'static str, value: f64, above: f64 },
    #[error("size distribution: there are no diameters; give at least {least}")]
    Empty { least: usize },
    #[error("size distribution: {diameters} diameters but {shares} shares; give as many of both")]
    Lengths { diameters: usize, shares: usize },
    #[error("size distribution: share {number} is {value}; a share must be 0 or a positive number")]
    Share { number: usize, value: f64 },
    #[error("size distribution: all shares are 0; at least one must be positive")]
    AllSharesZero,
    #[error("size distribution: the smallest diameter, {lower} m, must not be above the largest, {upper} m")]
    Bounds { lower: f64, upper: f64 },
    #[error(
        "size distribution: only a share of {share:e} lies between {lower} m and {upper} m (at least 1e-9 is needed); \
         widen the bounds or move the distribution"
    )]
    BoundsExcludeAll { lower: f64, upper: f64, share: f64 },
    #[error("size distribution: {what} {number} is {value} but the one before it is {before}; they must rise")]
    NotRising {
        what: &'static str,
        number: usize,
        before: f64,
        value: f64,
    },
    #[error("size distribution: the cumulative shares run from {first} to {last}; they must run from 0 to 1")]
    TableEnds { first: f64, last: f64 },
}

fn check_diameter(what: &'static str, value: f64) -> Result<f64, SizeError> {
    match DIAMETERS.contains(&value) {
        true => Ok(value),
        false => Err(SizeError::Diameter { what, value }),
    }
}

fn check_parameter(what: &'static str, value: f64, above: f64) -> Result<f64, SizeError> {
    match value.is_finite() && value > above {
        true => Ok(value),
        false => Err(SizeError::Parameter { what, value, above }),
    }
}

/// Checks the bounds of a cut distribution.
fn check_bounds(lower: f64, upper: f64) -> Result<(), SizeError> {
    check_diameter("the smallest diameter", lower)?;
    check_diameter("the largest diameter", upper)?;
    match lower <= upper {
        true => Ok(()),
        false => Err(SizeError::Bounds { lower, upper }),
    }
}

fn check_share_within(lower: f64, upper: f64, share: f64) -> Result<(), SizeError> {
    match share >= SMALLEST_SHARE {
        true => Ok(()),
        false => Err(SizeError::BoundsExcludeAll { lower, upper, share }),
    }
}

/// Standard normal distribution cut to an interval, drawn by its inverse.
#[derive(Clone, Debug)]
struct CutNormal {
    /// Ends, mirrored so that the interval does not lie in the upper tail, where shares lose their digits.
    from: f64,
    to: f64,
    mirrored: bool,
    below_from: f64,
    share: f64,
}

impl CutNormal {
    fn new(from: f64, to: f64) -> Self {
        let mirrored = from > 0.0;
        let (from, to) = if mirrored { (-to, -from) } else { (from, to) };
        let below_from = normal_below(from);
        let share = normal_below(to) - below_from;
        Self {
            from,
            to,
            mirrored,
            below_from,
            share,
        }
    }

    fn draw(&self, random: &mut RandomNumbers) -> f64 {
        let p = self.below_from + random.uniform_open() * self.share;
        let z = normal_quantile(p.clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON)).clamp(self.from, self.to);
        if self.mirrored { -z } else { z }
    }

    /// Mean of `f(z)` by Simpson's rule over the interval, cut where the density is below 1e-22 of its peak.
    fn mean_of(&self, f: impl Fn(f64) -> f64) -> f64 {
        let (from, to) = (self.from.max(-10.0), self.to.min(10.0));
        let (mut weights, mut sum) = (0.0, 0.0);
        let intervals = 2000;
        for k in 0..=intervals {
            let z = from + (to - from) * f64::from(k) / f64::from(intervals);
            let simpson = match k {
                0 => 1.0,
                k if k == intervals => 1.0,
                k if k % 2 == 1 => 4.0,
                _ => 2.0,
            };
            let weight = simpson * exp(-0.5 * z * z);
            weights += weight;
            sum += weight * f(if self.mirrored { -z } else { z });
        }
        sum / weights
    }
}

/// Piecewise distribution by number: points, or intervals of constant `q0` or constant `q3`.
#[derive(Clone, Debug)]
struct Pieces {
    pieces: Vec<Piece>,
    /// Share by number up to and with each piece, ending at 1.
    cumulative: Vec<f64>,
}

#[derive(Clone, Copy, Debug)]
struct Piece {
    lower: f64,
    upper: f64,
    basis: Basis,
}

impl Piece {
    /// Number of grains per mass, relative: mean of `d^-3` with constant `q3`.
    fn number_per_mass(&self) -> f64 {
        if self.lower == self.upper {
            1.0 / (self.lower * self.lower * self.lower)
        } else {
            // (1/a^2 - 1/b^2) / (2 (b - a)), without the difference of nearly equal numbers.
            let (a, b) = (self.lower, self.upper);
            (a + b) / (2.0 * a * a * b * b)
        }
    }

    fn draw(&self, random: &mut RandomNumbers) -> f64 {
        let u = random.uniform();
        let d = match self.basis {
            Basis::Number => self.lower + u * (self.upper - self.lower),
            // Inverse of the integral of d^-3.
            Basis::Mass => {
                let ratio = self.lower / self.upper;
                self.lower / libm::sqrt(1.0 - u * (1.0 - ratio * ratio))
            }
        };
        d.clamp(self.lower, self.upper)
    }

    /// Mean of `d` and of `d^3` by number.
    fn moments(&self) -> (f64, f64) {
        let (a, b) = (self.lower, self.upper);
        match self.basis {
            Basis::Number => (0.5 * (a + b), 0.25 * (a + b) * (a * a + b * b)),
            // Integrals of d^-2 and d^0 over that of d^-3.
            Basis::Mass => (2.0 * a * b / (a + b), 2.0 * a * a * b * b / (a + b)),
        }
    }
}

impl Pieces {
    /// `shares` count what `basis` says.
    fn new(pieces: Vec<Piece>, shares: &[f64], basis: Basis) -> Result<Self, SizeError> {
        let number_share = |piece: &Piece, share: f64| match basis {
            Basis::Number => share,
            Basis::Mass => share * piece.number_per_mass(),
        };
        let largest = (pieces.iter().zip(shares)).fold(0.0, |m: f64, (p, s)| m.max(number_share(p, *s)));
        if largest <= 0.0 {
            return Err(SizeError::AllSharesZero);
        }
        let mut sum = 0.0;
        let mut cumulative: Vec<f64> = Vec::with_capacity(pieces.len());
        for (piece, share) in pieces.iter().zip(shares) {
            sum += number_share(piece, *share) / largest;
            cumulative.push(sum);
        }
        for value in &mut cumulative {
            *value /= sum;
        }
        Ok(Self { pieces, cumulative })
    }

    fn draw(&self, random: &mut RandomNumbers) -> f64 {
        let u = random.uniform();
        // The first piece whose cumulative share exceeds u; a piece without share is never the first.
        let found = self.cumulative.partition_point(|c| *c <= u).min(self.pieces.len() - 1);
        self.pieces[found].draw(random)
    }

    fn mean_of(&self, f: impl Fn(&Piece) -> f64) -> f64 {
        let mut before = 0.0;
        let mut sum = 0.0;
        for (piece, upto) in self.pieces.iter().zip(&self.cumulative) {
            sum += (upto - before) * f(piece);
            before = *upto;
        }
        sum
    }
}

/// A checked size distribution, ready to draw from.
#[derive(Clone, Debug)]
pub struct SizeSampler {
    kind: Kind,
    lower: f64,
    upper: f64,
}

#[derive(Clone, Debug)]
enum Kind {
    Pieces(Pieces),
    Normal {
        mean: f64,
        deviation: f64,
        cut: CutNormal,
    },
    Lognormal {
        median: f64,
        log_deviation: f64,
        cut: CutNormal,
    },
    RosinRammler(RosinRammlerSampler),
}

impl SizeSampler {
    /// Checks a distribution and prepares drawing from it.
    pub fn new(distribution: &SizeDistribution) -> Result<Self, SizeError> {
        match *distribution {
            SizeDistribution::Single(d) => Self::interval(check_diameter("the diameter", d)?, d),
            SizeDistribution::Uniform { lower, upper } => {
                check_bounds(lower, upper)?;
                Self::interval(lower, upper)
            }
            SizeDistribution::Normal {
                mean,
                standard_deviation,
                lower,
                upper,
            } => Self::normal(mean, standard_deviation, lower, upper),
            SizeDistribution::Lognormal {
                median,
                geometric_deviation,
                lower,
                upper,
            } => Self::lognormal(median, geometric_deviation, lower, upper),
            SizeDistribution::RosinRammler {
                scale,
                exponent,
                lower,
                upper,
            } => Self::rosin_rammler(scale, exponent, lower, upper),
            SizeDistribution::List {
                ref diameters,
                ref shares,
                basis,
            } => Self::list(diameters, shares, basis),
            SizeDistribution::Table {
                ref diameters,
                ref finer,
                basis,
            } => Self::table(diameters, finer, basis),
        }
    }

    /// Draws one diameter [m].
    pub(super) fn draw(&self, random: &mut RandomNumbers) -> f64 {
        let d = match &self.kind {
            Kind::Pieces(pieces) => pieces.draw(random),
            Kind::Normal { mean, deviation, cut } => mean + deviation * cut.draw(random),
            Kind::Lognormal {
                median,
                log_deviation,
                cut,
            } => median * exp(log_deviation * cut.draw(random)),
            Kind::RosinRammler(sampler) => sampler.draw(random),
        };
        d.clamp(self.lower, self.upper)
    }

    /// Smallest and largest diameter that can be drawn [m].
    pub fn bounds(&self) -> (f64, f64) {
        (self.lower, self.upper)
    }

    /// Mean diameter by number [m].
    pub fn mean_diameter(&self) -> f64 {
        match &self.kind {
            Kind::Pieces(pieces) => pieces.mean_of(|p| p.moments().0),
            Kind::Normal { mean, deviation, cut } => cut.mean_of(|z| mean + deviation * z),
            Kind::Lognormal {
                median,
                log_deviation,
                cut,
            } => cut.mean_of(|z| median * exp(log_deviation * z)),
            Kind::RosinRammler(sampler) => sampler.mean_of_power(1),
        }
    }

    /// Mean volume of a grain by number [m^3].
    pub fn mean_volume(&self) -> f64 {
        let cube = |d: f64| d * d * d;
        let mean_cube = match &self.kind {
            Kind::Pieces(pieces) => pieces.mean_of(|p| p.moments().1),
            Kind::Normal { mean, deviation, cut } => cut.mean_of(|z| cube(mean + deviation * z)),
            Kind::Lognormal {
                median,
                log_deviation,
                cut,
            } => cut.mean_of(|z| cube(median * exp(log_deviation * z))),
            Kind::RosinRammler(sampler) => sampler.mean_of_power(3),
        };
        PI / 6.0 * mean_cube
    }

    fn interval(lower: f64, upper: f64) -> Result<Self, SizeError> {
        let basis = Basis::Number;
        let pieces = Pieces::new(vec![Piece { lower, upper, basis }], &[1.0], basis)?;
        Ok(Self {
            kind: Kind::Pieces(pieces),
            lower,
            upper,
        })
    }

    fn normal(mean: f64, deviation: f64, lower: f64, upper: f64) -> Result<Self, SizeError> {
        check_diameter("the mean", mean)?;
        check_parameter("the standard deviation", deviation, 0.0)?;
        check_bounds(lower, upper)?;
        if lower == upper {
            return Self::interval(lower, upper);
        }
        let cut = CutNormal::new((lower - mean) / deviation, (upper - mean) / deviation);
        check_share_within(lower, upper, cut.share)?;
        Ok(Self {
            kind: Kind::Normal { mean, deviation, cut },
            lower,
            upper,
        })
    }

    fn lognormal(median: f64, geometric_deviation: f64, lower: f64, upper: f64) -> Result<Self, SizeError> {
        check_diameter("the median", median)?;
        check_parameter("the geometric standard deviation", geometric_deviation, 1.0)?;
        check_bounds(lower, upper)?;
        if lower == upper {
            return Self::interval(lower, upper);
        }
        let log_deviation = log(geometric_deviation);
        let cut = CutNormal::new(log(lower / median) / log_deviation, log(upper / median) / log_deviation);
        check_share_within(lower, upper, cut.share)?;
        Ok(Self {
            kind: Kind::Lognormal {
                median,
                log_deviation,
                cut,
            },
            lower,
            upper,
        })
    }

    fn rosin_rammler(scale: f64, exponent: f64, lower: f64, upper: f64) -> Result<Self, SizeError> {
        check_diameter("the scale", scale)?;
        check_parameter("the exponent", exponent, 0.0)?;
        check_bounds(lower, upper)?;
        if lower == upper {
            return Self::interval(lower, upper);
        }
        let sampler = RosinRammlerSampler::new(scale, exponent, lower, upper);
        check_share_within(lower, upper, sampler.mass_share())?;
        Ok(Self {
            kind: Kind::RosinRammler(sampler),
            lower,
            upper,
        })
    }

    fn list(diameters: &[f64], shares: &[f64], basis: Basis) -> Result<Self, SizeError> {
        check_lengths(diameters, shares, 1)?;
        for (k, &share) in shares.iter().enumerate() {
            if !(share.is_finite() && share >= 0.0) {
                return Err(SizeError::Share {
                    number: k + 1,
                    value: share,
                });
            }
        }
        let (mut lower, mut upper) = (f64::INFINITY, 0.0_f64);
        let mut pieces = Vec::with_capacity(diameters.len());
        for (&d, &share) in diameters.iter().zip(shares) {
            check_diameter("a diameter of the list", d)?;
            if share > 0.0 {
                (lower, upper) = (lower.min(d), upper.max(d));
            }
            pieces.push(Piece {
                lower: d,
                upper: d,
                basis,
            });
        }
        Ok(Self {
            kind: Kind::Pieces(Pieces::new(pieces, shares, basis)?),
            lower,
            upper,
        })
    }

    fn table(diameters: &[f64], finer: &[f64], basis: Basis) -> Result<Self, SizeError> {
        check_lengths(diameters, finer, 2)?;
        for &d in diameters {
            check_diameter("a diameter of the table", d)?;
        }
        let rising = |what, values: &[f64], may_stay: bool| {
            for (k, pair) in values.windows(2).enumerate() {
                // Written so that NaN fails.
                if !(pair[1] > pair[0] || may_stay && pair[1] == pair[0]) {
                    return Err(SizeError::NotRising {
                        what,
                        number: k + 2,
                        before: pair[0],
                        value: pair[1],
                    });
                }
            }
            Ok(())
        };
        rising("diameter", diameters, false)?;
        rising("cumulative share", finer, true)?;
        let (first, last) = (finer[0], finer[finer.len() - 1]);
        if first != 0.0 || (last - 1.0).abs() > 1e-9 {
            return Err(SizeError::TableEnds { first, last });
        }
        let shares: Vec<f64> = finer.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let pieces: Vec<Piece> = diameters
            .windows(2)
            .map(|pair| Piece {
                lower: pair[0],
                upper: pair[1],
                basis,
            })
            .collect();
        // Table intervals without share at the ends are outside the distribution.
        let used = |k: &usize| shares[*k] > 0.0;
        let lowest = (0..shares.len()).find(used).unwrap_or(0);
        let highest = (0..shares.len()).rfind(used).unwrap_or(0);
        Ok(Self {
            lower: pieces[lowest].lower,
            upper: pieces[highest].upper,
            kind: Kind::Pieces(Pieces::new(pieces, &shares, basis)?),
        })
    }
}

fn check_lengths(diameters: &[f64], shares: &[f64], least: usize) -> Result<(), SizeError> {
    if diameters.len() != shares.len() {
        return Err(SizeError::Lengths {
            diameters: diameters.len(),
            shares: shares.len(),
        });
    }
    match diameters.len() >= least {
        true => Ok(()),
        false => Err(SizeError::Empty { least }),
    }
}

#[cfg(test)]
#[path = "size_distribution_tests.rs"]
mod tests;
