//! The displacement as polynomials of the squared sine of half the angle: no root, no logarithm when it is asked for.
//!
//! The displacement is smooth but at angle zero, so cells of a constant relative width take polynomials of one degree: the
//! cells are the leading bits of the number itself.

use super::series::Series;
use crate::lanes::{Lanes, MOST_LANES};
use std::fmt;
use std::sync::{Mutex, PoisonError};

/// Leading bits of the mantissa that tell the cell.
const CELL_BITS: u32 = 5;
const SHIFT: u32 = f64::MANTISSA_DIGITS - 1 - CELL_BITS;
/// Octaves of the squared sine, the highest ends at 1.
const OCTAVES: usize = 40;
const CELLS: usize = OCTAVES << CELL_BITS;
const LARGEST: f64 = 1.0 - f64::EPSILON / 2.0;
const SMALLEST: f64 = 1.0 / (1u64 << OCTAVES) as f64;
const FIRST_CELL: usize = (SMALLEST.to_bits() >> SHIFT) as usize;
const MANTISSA: u64 = (1 << (f64::MANTISSA_DIGITS - 1)) - 1;
const ONE: u64 = 1.0f64.to_bits();
/// Half the width of a cell, with the number scaled to between 1 and 2.
const HALF_WIDTH: f64 = 0.5 / (1u64 << CELL_BITS) as f64;
const COEFFICIENTS: usize = 6;

/// Displacements `g` of one Poisson's ratio.
pub(super) struct Displacements {
    poisson_ratio: f64,
    /// In powers of the distance from the middle of the cell, scaled as the number is.
    cells: Vec<[f64; COEFFICIENTS]>,
    /// At least the largest of all `g`, never below zero.
    largest: f64,
    /// At least the largest of `-g` in the cell before and above, never below zero: one more than cells.
    deepest: Vec<f64>,
}

impl fmt::Debug for Displacements {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Displacements({})", self.poisson_ratio)
    }
}

impl PartialEq for Displacements {
    fn eq(&self, other: &Self) -> bool {
        self.poisson_ratio.to_bits() == other.poisson_ratio.to_bits()
    }
}

/// Cell of a number within the table, and its scaled distance from the middle.
#[inline(always)]
fn place(square: f64) -> (usize, f64) {
    // not `clamp`, which lets pass what is not a number
    let within = if square > SMALLEST {
        square.min(LARGEST)
    } else {
        SMALLEST
    };
    let bits = within.to_bits();
    let scaled = f64::from_bits((bits & MANTISSA) | ONE);
    let half = 1 << (SHIFT - 1);
    let middle = f64::from_bits((bits & MANTISSA & !(2 * half - 1)) | half | ONE);
    ((bits >> SHIFT) as usize - FIRST_CELL, scaled - middle)
}

impl Displacements {
    /// One lasting copy for each Poisson's ratio in use, so that laws stay plain values.
    pub(super) fn of(poisson_ratio: f64) -> &'static Self {
        static KEPT: Mutex<Vec<&'static Displacements>> = Mutex::new(Vec::new());
        let mut all = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
        let bits = poisson_ratio.to_bits();
        if let Some(known) = all.iter().find(|known| known.poisson_ratio.to_bits() == bits) {
            return known;
        }
        let lasting: &'static Self = Box::leak(Box::new(Self::new(poisson_ratio)));
        all.push(lasting);
        lasting
    }

    fn new(poisson_ratio: f64) -> Self {
        let series = Series::new(poisson_ratio);
        let cells: Vec<[f64; COEFFICIENTS]> = (0..CELLS)
            .map(|cell| {
                let start = f64::from_bits(((cell + FIRST_CELL) as u64) << SHIFT);
                let scale = f64::from_bits(start.to_bits() & !MANTISSA);
                let middle = start / scale + HALF_WIDTH;
                polynomial(|offset| series.at((middle + offset) * scale))
            })
            .collect();
        let largest = cells.iter().map(|c| c[0] + spread(c)).fold(0.0, f64::max);
        let depths = cells.iter().map(|c| spread(c) - c[0]);
        let mut deepest: Vec<f64> = depths.clone().take(1).chain(depths).collect();
        let mut above = 0.0;
        for depth in deepest.iter_mut().rev() {
            above = f64::max(above, *depth);
            *depth = above;
        }
        Self {
            poisson_ratio,
            cells,
            largest,
            deepest,
        }
    }

    /// `g` at a squared sine of half the angle; it stays the same below `1e-12`.
    #[inline(always)]
    pub(super) fn at<L: Lanes>(&self, square: L) -> L {
        let (mut starts, mut offsets) = ([0; MOST_LANES], [0.0; MOST_LANES]);
        let mut lane = 0;
        while lane < L::COUNT {
            let (cell, offset) = place(square.as_slice()[lane]);
            (starts[lane], offsets[lane]) = (COEFFICIENTS * cell, offset);
            lane += 1;
        }
        let (cells, offset) = (self.cells.as_flattened(), L::load(&offsets));
        let [a, b, c, d] = L::columns(cells, &starts);
        starts.iter_mut().for_each(|start| *start += COEFFICIENTS - 4);
        let [_, _, e, f] = L::columns(cells, &starts);
        a + offset * (b + offset * (c + offset * (d + offset * (e + offset * f))))
    }

    /// At least the largest `g` of all, not below zero.
    pub(super) fn largest(&self) -> f64 {
        self.largest
    }

    /// At least the largest `-g` at this squared sine and above, not below zero, without a jump.
    pub(super) fn deepest_from(&self, square: f64) -> f64 {
        let (cell, offset) = place(square);
        let (before, here) = (self.deepest[cell], self.deepest[cell + 1]);
        before + (0.5 + offset / (2.0 * HALF_WIDTH)) * (here - before)
    }
}

/// How far a polynomial goes from its middle within its cell, at most.
fn spread(coefficients: &[f64; COEFFICIENTS]) -> f64 {
    let powers = coefficients[1..].iter().rev();
    powers.fold(0.0, |sum, c| (sum + c.abs()) * HALF_WIDTH)
}

/// The polynomial through the function at the Chebyshev points of a cell (Newton's divided differences).
fn polynomial(function: impl Fn(f64) -> f64) -> [f64; COEFFICIENTS] {
    let points: [f64; COEFFICIENTS] = std::array::from_fn(|i| {
        let angle = (2 * i + 1) as f64 * std::f64::consts::PI / (2 * COEFFICIENTS) as f64;
        HALF_WIDTH * libm::cos(angle)
    });
    let mut differences = points.map(function);
    for order in 1..COEFFICIENTS {
        for i in (order..COEFFICIENTS).rev() {
            differences[i] = (differences[i] - differences[i - 1]) / (points[i] - points[i - order]);
        }
    }
    let mut powers = [0.0; COEFFICIENTS];
    for (point, difference) in points.iter().zip(differences).rev() {
        // times (x - point), plus the difference
        for i in (1..COEFFICIENTS).rev() {
            powers[i] = powers[i - 1] - point * powers[i];
        }
        powers[0] = difference - point * powers[0];
    }
    powers
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_series() {
        for nu in [-0.95, -0.3, 0.0, 0.3, 0.5] {
            let (table, series) = (Displacements::of(nu), Series::new(nu));
            for step in 0..=5000 {
                // from the smallest to 1, evenly in the logarithm
                let square = libm::exp2(-39.99 * (1.0 - f64::from(step) / 5000.0));
                let (found, expected) = (table.at(square), series.at(square));
                let scale = expected.abs().max(1.0 / square.sqrt());
                assert!(
                    (found - expected).abs() <= 1e-12 * scale,
                    "{nu} {square:e}: {found} {expected}"
                );
                assert!(found <= table.largest() && -found <= table.deepest_from(square));
            }
        }
    }

    #[test]
    fn bounds_are_close() {
        let table = Displacements::of(0.5);
        let most = (1..=1000).map(|k| table.at(f64::from(k) / 1000.0)).fold(0.0, f64::max);
        assert!(table.largest() < 1.001 * most, "{} {most}", table.largest());
        let (deepest, there) = (table.deepest_from(0.01), -table.at(0.01));
        assert!(deepest > there && deepest < 1.05 * there, "{deepest} {there}");
    }

    #[test]
    fn anything_finds_a_cell() {
        let table = Displacements::of(0.3);
        for square in [0.0, -1.0, 1.0, 1.0 + 1e-15, f64::NAN, f64::INFINITY, f64::MIN_POSITIVE] {
            assert!(table.at(square).is_finite() && table.deepest_from(square).is_finite());
        }
        assert_eq!(table.at(0.0), table.at(1e-13));
        // the same copy again, whatever the ratio
        assert!(std::ptr::eq(Displacements::of(f64::NAN), Displacements::of(f64::NAN)));
    }
}
