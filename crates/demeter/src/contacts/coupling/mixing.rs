//! Anderson mixing: the next forces to try, from the latest deviations.
//!
//! With the deviation `r = f(overlap + D(x)) - x` of the forces `x` tried, the plain iteration goes on with `x + r`. It
//! contracts by the largest eigenvalue of the coupling, which nears 1 at the fold. Anderson mixing takes off
//! `sum w_a (dx_a + dr_a)`, where `dx_a` and `dr_a` are the latest changes of `x` and `r` and `w` makes `r - sum w_a dr_a`
//! least (Walker and Ni, SIAM J. Numer. Anal. 49 (2011) 1715). Its sums do not depend on the order of the contacts, so
//! that a packing gives the same bits in any order.

use serde::{Deserialize, Serialize};

/// Plain iterations before forces are mixed: near rest one is enough.
const PLAIN_ITERATIONS: usize = 6;

/// Forces are not mixed as long as a plain iteration leaves less than this share of the largest deviation: it works on the forces
/// alone that are not good enough yet, and mixing on all.
const QUICK: f64 = 0.5;

/// Changes kept.
const DEPTH: usize = 5;

/// Numbers of [`Largest`].
pub(crate) const LARGEST: usize = DEPTH + 2;

/// A change is left out when it is this close to a combination of the others, as a share of its square.
const DEPENDENT: f64 = 1e-12;

/// The deviation may grow by this factor before the changes are forgotten.
const PATIENCE: f64 = 2.0;

/// One weight per change.
pub(crate) type Weights = [f64; DEPTH];

/// Changes of one chunk's forces and deviations.
#[derive(Clone, Debug, Default)]
pub(crate) struct Memory {
    /// Changes kept, and the place of the next one.
    kept: usize,
    next: usize,
    begun: bool,
    trial: Vec<f64>,
    deviation: Vec<f64>,
    trial_changes: [Vec<f64>; DEPTH],
    deviation_changes: [Vec<f64>; DEPTH],
}

/// Largest values of a chunk, or of all: of every change of the deviation, and of the deviation itself [N].
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Largest {
    kept: usize,
    changes: [f64; DEPTH],
    deviation: f64,
}

impl Largest {
    /// As numbers of which the largest count.
    pub(crate) fn numbers(&self) -> [f64; LARGEST] {
        let mut numbers = [0.0; LARGEST];
        numbers[..DEPTH].copy_from_slice(&self.changes);
        numbers[DEPTH..].copy_from_slice(&[self.deviation, self.kept as f64]);
        numbers
    }

    pub(crate) fn of_numbers(numbers: [f64; LARGEST]) -> Self {
        Self {
            kept: numbers[DEPTH + 1] as usize,
            changes: std::array::from_fn(|a| numbers[a]),
            deviation: numbers[DEPTH],
        }
    }

    pub(crate) fn join(mut self, other: &Self) -> Self {
        self.kept = self.kept.max(other.kept);
        self.deviation = self.deviation.max(other.deviation);
        for (mine, theirs) in self.changes.iter_mut().zip(other.changes) {
            *mine = mine.max(theirs);
        }
        self
    }
}

/// A sum of values of at most 1 that does not depend on their order: of multiples of 2^-40.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
struct OrderlessSum(i128);

impl OrderlessSum {
    const UNIT: f64 = (1u64 << 40) as f64;

    fn of_products(a: &[f64], b: &[f64], scale: f64) -> Self {
        let factor = if scale > 0.0 { Self::UNIT / scale } else { 0.0 };
        Self(a.iter().zip(b).map(|(x, y)| (x * y * factor) as i128).sum())
    }

    fn value(self) -> f64 {
        self.0 as f64 / Self::UNIT
    }
}

/// Scalar products that the weights follow from, with every change and the deviation as shares of their largest values.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Products {
    changes: [[OrderlessSum; DEPTH]; DEPTH],
    with_deviation: [OrderlessSum; DEPTH],
    deviation: OrderlessSum,
}

impl Products {
    pub(crate) fn add(mut self, other: &Self) -> Self {
        self.deviation.0 += other.deviation.0;
        for a in 0..DEPTH {
            self.with_deviation[a].0 += other.with_deviation[a].0;
            for b in 0..DEPTH {
                self.changes[a][b].0 += other.changes[a][b].0;
            }
        }
        self
    }

    /// Root of the sum of the squares of the deviations [N].
    fn norm(&self, largest: &Largest) -> f64 {
        self.deviation.value().sqrt() * largest.deviation
    }

    /// Weights that make the deviation least, by Gauss-Jordan elimination with the largest pivots first.
    pub(crate) fn weights(&self, largest: &Largest) -> Weights {
        let mut matrix = self.changes.map(|row| row.map(OrderlessSum::value));
        let mut right = self.with_deviation.map(OrderlessSum::value);
        let scale: [f64; DEPTH] = std::array::from_fn(|a| matrix[a][a]);
        let mut solved = [false; DEPTH];
        for _ in 0..largest.kept {
            let pivot = (0..largest.kept)
                .filter(|&a| !solved[a] && matrix[a][a] > DEPENDENT * scale[a])
                .max_by(|&a, &b| (matrix[a][a] / scale[a]).total_cmp(&(matrix[b][b] / scale[b])));
            let Some(pivot) = pivot else { break };
            solved[pivot] = true;
            let inverse = 1.0 / matrix[pivot][pivot];
            matrix[pivot].iter_mut().for_each(|x| *x *= inverse);
            right[pivot] *= inverse;
            let (row, value) = (matrix[pivot], right[pivot]);
            for a in (0..largest.kept).filter(|&a| a != pivot) {
                let factor = matrix[a][pivot];
                for (x, y) in matrix[a].iter_mut().zip(row) {
                    *x -= factor * y;
                }
                right[a] -= factor * value;
            }
        }
        std::array::from_fn(|a| {
            if solved[a] {
                right[a] * largest.deviation / largest.changes[a]
            } else {
                0.0
            }
        })
    }
}

impl Memory {
    /// Forgets all changes.
    pub(crate) fn forget(&mut self) {
        self.kept = 0;
        self.next = 0;
        self.begun = false;
    }

    /// Notes the deviation of the forces tried, and its change.
    pub(crate) fn note(&mut self, trial: &[f64], answer: &[f64]) -> Largest {
        if self.begun {
            let slot = self.next;
            self.next = (slot + 1) % DEPTH;
            self.kept = (self.kept + 1).min(DEPTH);
            let (trials, deviations) = (&mut self.trial_changes[slot], &mut self.deviation_changes[slot]);
            trials.clear();
            trials.extend(trial.iter().zip(&self.trial).map(|(new, old)| new - old));
            deviations.clear();
            let changes = (trial.iter().zip(answer).zip(&self.deviation)).map(|((x, f), old)| (f - x) - old);
            deviations.extend(changes);
        }
        self.begun = true;
        self.trial.clear();
        self.trial.extend_from_slice(trial);
        self.deviation.clear();
        self.deviation.extend(trial.iter().zip(answer).map(|(x, f)| f - x));
        Largest {
            kept: self.kept,
            changes: std::array::from_fn(|a| largest(&self.deviation_changes[a])),
            deviation: largest(&self.deviation),
        }
    }

    /// Scalar products of what was noted.
    pub(crate) fn products(&self, all: &Largest) -> Products {
        let mut products = Products {
            deviation: OrderlessSum::of_products(&self.deviation, &self.deviation, all.deviation * all.deviation),
            ..Products::default()
        };
        for a in 0..self.kept {
            let (change, size) = (&self.deviation_changes[a], all.changes[a]);
            products.with_deviation[a] = OrderlessSum::of_products(change, &self.deviation, size * all.deviation);
            for b in 0..=a {
                let other = &self.deviation_changes[b];
                let product = OrderlessSum::of_products(change, other, size * all.changes[b]);
                products.changes[a][b] = product;
                products.changes[b][a] = product;
            }
        }
        products
    }

    /// The next forces to try.
    pub(crate) fn advance(&self, weights: &Weights, trial: &mut [f64]) {
        for (x, r) in trial.iter_mut().zip(&self.deviation) {
            *x += r;
        }
        for a in (0..self.kept).filter(|&a| weights[a] != 0.0) {
            let changes = self.trial_changes[a].iter().zip(&self.deviation_changes[a]);
            for (x, (dx, dr)) in trial.iter_mut().zip(changes) {
                *x -= weights[a] * (dx + dr);
            }
        }
    }
}

/// Watches that the deviation shrinks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Progress {
    least: f64,
    /// Largest deviation before the latest iteration, as a share of a force.
    before: f64,
    mixes: bool,
}

impl Progress {
    pub(crate) fn begin() -> Self {
        Self {
            least: f64::INFINITY,
            before: f64::INFINITY,
            mixes: false,
        }
    }

    /// Whether forces are mixed in an iteration, told the largest deviation; once they are it goes on.
    pub(crate) fn mixes(&mut self, iteration: usize, worst: f64) -> bool {
        self.mixes |= iteration >= PLAIN_ITERATIONS && worst > QUICK * self.before;
        self.before = worst;
        self.mixes
    }

    /// Whether mixing does harm, so that the plain iteration must begin anew.
    pub(crate) fn is_lost(&mut self, products: &Products, largest: &Largest) -> bool {
        let norm = products.norm(largest);
        let lost = norm > PATIENCE * self.least;
        self.least = if lost { norm } else { self.least.min(norm) };
        lost
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| f64::max(most, x.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Iterations until `x = g(x)` to 1e-12, for a linear map with these eigenvalues.
    fn iterations(eigenvalues: &[f64], mix: bool) -> usize {
        let mut memory = Memory::default();
        let mut x = vec![0.0; eigenvalues.len()];
        for count in 1..10_000 {
            let answer: Vec<f64> = x.iter().zip(eigenvalues).map(|(x, e)| 1.0 + e * x).collect();
            let largest = memory.note(&x, &answer);
            if largest.deviation < 1e-12 {
                let exact = x.iter().zip(eigenvalues).map(|(x, e)| (x - 1.0 / (1.0 - e)).abs());
                assert!(exact.fold(0.0, f64::max) < 1e-10);
                return count;
            }
            let weights = if mix {
                memory.products(&largest).weights(&largest)
            } else {
                Default::default()
            };
            memory.advance(&weights, &mut x);
        }
        usize::MAX
    }

    #[test]
    fn mixing_solves_a_few_modes_at_once() {
        assert!(iterations(&[0.95], false) > 400);
        assert!(iterations(&[0.95], true) <= 4);
        assert!(iterations(&[0.95, -0.5, 0.3], true) <= 7);
    }

    #[test]
    fn mixing_speeds_up_many_modes() {
        let eigenvalues: Vec<f64> = (0..200).map(|k| -0.5 + 1.4 * f64::from(k) / 199.0).collect();
        let (plain, mixed) = (iterations(&eigenvalues, false), iterations(&eigenvalues, true));
        assert!(2 * mixed < plain, "{plain} plain, {mixed} mixed");
    }
}
