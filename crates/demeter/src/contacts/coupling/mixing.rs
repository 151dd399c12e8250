//! Anderson mixing: the next forces to try, from the latest deviations.
//!
//! With the deviation `r = f(overlap + D(x)) - x` of the forces `x` tried, the plain iteration goes on with `x + r`. It
//! contracts by the largest eigenvalue of the coupling, which nears 1 at the fold. Anderson mixing takes off
//! `sum w_a (dx_a + dr_a)`, where `dx_a` and `dr_a` are the latest changes of `x` and `r` and `w` makes `r - sum w_a dr_a`
//! least (Walker and Ni, SIAM J. Numer. Anal. 49 (2011) 1715).

/// Changes kept.
const DEPTH: usize = 5;

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

/// Scalar products that the weights follow from; those of all chunks are added in a fixed order.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Products {
    kept: usize,
    changes: [[f64; DEPTH]; DEPTH],
    with_deviation: [f64; DEPTH],
    /// Square of the deviation [N^2].
    pub(crate) deviation: f64,
}

impl Products {
    pub(crate) fn add(mut self, other: &Self) -> Self {
        self.kept = self.kept.max(other.kept);
        self.deviation += other.deviation;
        for a in 0..DEPTH {
            self.with_deviation[a] += other.with_deviation[a];
            for b in 0..DEPTH {
                self.changes[a][b] += other.changes[a][b];
            }
        }
        self
    }

    /// Weights that make the deviation least, by Gauss-Jordan elimination with the largest pivots first.
    pub(crate) fn weights(&self) -> Weights {
        let (mut matrix, mut right) = (self.changes, self.with_deviation);
        let scale: [f64; DEPTH] = std::array::from_fn(|a| self.changes[a][a]);
        let mut solved = [false; DEPTH];
        for _ in 0..self.kept {
            let pivot = (0..self.kept)
                .filter(|&a| !solved[a] && matrix[a][a] > DEPENDENT * scale[a])
                .max_by(|&a, &b| (matrix[a][a] / scale[a]).total_cmp(&(matrix[b][b] / scale[b])));
            let Some(pivot) = pivot else { break };
            solved[pivot] = true;
            let inverse = 1.0 / matrix[pivot][pivot];
            matrix[pivot].iter_mut().for_each(|x| *x *= inverse);
            right[pivot] *= inverse;
            let (row, value) = (matrix[pivot], right[pivot]);
            for a in (0..self.kept).filter(|&a| a != pivot) {
                let factor = matrix[a][pivot];
                for (x, y) in matrix[a].iter_mut().zip(row) {
                    *x -= factor * y;
                }
                right[a] -= factor * value;
            }
        }
        std::array::from_fn(|a| if solved[a] { right[a] } else { 0.0 })
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
    pub(crate) fn note(&mut self, trial: &[f64], answer: &[f64]) -> Products {
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
        self.products()
    }

    fn products(&self) -> Products {
        let mut products = Products {
            kept: self.kept,
            deviation: dot(&self.deviation, &self.deviation),
            ..Products::default()
        };
        for a in 0..self.kept {
            let change = &self.deviation_changes[a];
            products.with_deviation[a] = dot(change, &self.deviation);
            for b in 0..=a {
                let product = dot(change, &self.deviation_changes[b]);
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
}

impl Progress {
    pub(crate) fn begin() -> Self {
        Self { least: f64::INFINITY }
    }

    /// Whether mixing does harm, so that the plain iteration must begin anew.
    pub(crate) fn is_lost(&mut self, products: &Products) -> bool {
        let norm = products.deviation.sqrt();
        let lost = norm > PATIENCE * self.least;
        self.least = if lost { norm } else { self.least.min(norm) };
        lost
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
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
            let products = memory.note(&x, &answer);
            if products.deviation.sqrt() < 1e-12 {
                let exact = x.iter().zip(eigenvalues).map(|(x, e)| (x - 1.0 / (1.0 - e)).abs());
                assert!(exact.fold(0.0, f64::max) < 1e-10);
                return count;
            }
            let weights = if mix { products.weights() } else { Default::default() };
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
        assert!(3 * mixed < plain, "{plain} plain, {mixed} mixed");
    }
}
