//! Coefficients between sizes for which they were solved.
//!
//! Grains of many sizes make pairs of still more, and to solve for one pair takes some ten collisions. So coefficients are solved for on a
//! grid of sizes, and interpolated in the logarithms of effective radius and mass by polynomials of the fifth degree. Where those of
//! the third degree tell another value there is a kink, as between bodies that yield and those that do not, and nothing is told. What
//! is told is a pure function of the size: it does not depend on which sizes were asked about before.

use crate::contact::PairSize;

/// Sizes of the grid per doubling.
const PER_OCTAVE: f64 = 16.0;

/// By how much of the coefficient, or of [`LEAST`], polynomials of the third and of the fifth degree may differ.
const AGREEMENT: f64 = 1e-6;
const LEAST: f64 = 0.01;

/// The coefficient for a size, told those for sizes of the grid, or nothing where one is out of reach.
pub(super) fn interpolated(size: PairSize, on_grid: impl Fn(PairSize) -> Option<f64>) -> Option<f64> {
    let (radius, mass) = (Place::of(size.radius), Place::of(size.mass));
    let (mut fifth, mut third) = (0.0, 0.0);
    for row in 0..6 {
        let mass_there = mass.on_grid(row);
        let mut values = [0.0; 6];
        for (column, value) in values.iter_mut().enumerate() {
            *value = on_grid(PairSize::new(radius.on_grid(column), mass_there))?;
        }
        fifth += mass.fifth[row] * dot(&radius.fifth, &values);
        if (1..5).contains(&row) {
            third += mass.third[row - 1] * dot(&radius.third, &values[1..5]);
        }
    }
    let agree = (fifth - third).abs() <= AGREEMENT * fifth.max(LEAST);
    (agree && fifth >= 0.0).then_some(fifth)
}

/// Where a size lies among those of the grid.
struct Place {
    /// Number of the first of six sizes of the grid around it.
    first: f64,
    /// Weights of the six, and of the four in the middle.
    fifth: [f64; 6],
    third: [f64; 4],
}

impl Place {
    fn of(size: f64) -> Self {
        let place = PER_OCTAVE * libm::log2(size);
        let below = place.floor();
        Self {
            first: below - 2.0,
            fifth: weights(2.0 + (place - below)),
            third: weights(1.0 + (place - below)),
        }
    }

    fn on_grid(&self, number: usize) -> f64 {
        libm::exp2((self.first + number as f64) / PER_OCTAVE)
    }
}

/// Weights of values at 0, 1, 2, ... in the polynomial through them (Lagrange).
fn weights<const N: usize>(place: f64) -> [f64; N] {
    std::array::from_fn(|k| {
        let others = (0..N).filter(|&other| other != k);
        others.fold(1.0, |product, other| {
            product * (place - other as f64) / (k as f64 - other as f64)
        })
    })
}

fn dot(weights: &[f64], values: &[f64]) -> f64 {
    weights
        .iter()
        .zip(values)
        .fold(0.0, |sum, (weight, value)| sum + weight * value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::cell::Cell;

    const SIZE: PairSize = PairSize::new(1.3e-3, 4.7e-6);

    fn power(size: PairSize) -> f64 {
        0.3 * libm::pow(size.radius / 1e-3, -0.7) * libm::pow(size.mass / 1e-6, 0.4)
    }

    #[test]
    fn powers_of_the_size_are_told_to_nine_digits() {
        for k in 0..20 {
            let size = PairSize::new(
                SIZE.radius * libm::exp2(0.013 * f64::from(k)),
                SIZE.mass * libm::exp2(-0.11 * f64::from(k)),
            );
            let told = interpolated(size, |there| Some(power(there))).unwrap();
            assert_relative_eq!(told, power(size), max_relative = 1e-9);
        }
    }

    #[test]
    fn sizes_of_the_grid_have_their_own_value() {
        let size = PairSize::new(libm::exp2(-150.0 / 16.0), libm::exp2(-290.0 / 16.0));
        let told = interpolated(size, |there| Some(power(there))).unwrap();
        assert_relative_eq!(told, power(size), max_relative = 1e-13);
    }

    #[test]
    fn nothing_is_told_across_a_kink_or_beside_sizes_out_of_reach() {
        let kinked = |there: PairSize| 0.3 + (there.mass / SIZE.mass - 1.0).max(0.0);
        assert_eq!(interpolated(SIZE, |there| Some(kinked(there))), None);
        let asked = Cell::new(0);
        let some = |there: PairSize| {
            asked.set(asked.get() + 1);
            (asked.get() != 20).then(|| power(there))
        };
        assert_eq!(interpolated(SIZE, some), None);
        assert_eq!(interpolated(SIZE, |_| Some(0.0)), Some(0.0));
    }
}
