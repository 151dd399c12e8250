//! Damped least squares (Levenberg 1944, Marquardt 1963) between bounds, from several starts.

use super::singular::dot;
use super::verdict::largest_sum;
use rayon::prelude::*;

/// Half of the distance over which slopes are taken, in logarithms of the unknowns.
const STEP: f64 = 1e-4;
const MOST_ITERATIONS: usize = 80;
/// Trial points before the search, and those from which it is begun.
const TRIALS: u32 = 48;
const STARTS: usize = 4;
/// Between the bounds of the first starts and the last ones, in logarithms, where others lie.
const FARTHER: [f64; 3] = [0.0, 0.33, 1.0];
/// Damping at which no step helps any more.
const MOST_DAMPING: f64 = 1e7;
/// Share of the cost that a step must gain for the search to go on, and the cost that is none.
const GAIN: f64 = 1e-8;
const NO_COST: f64 = 1e-20;
/// Once all deviations are far below the errors so many more steps are done: a smooth model is then exact, and a model with
/// rounding in it, as a bracketed velocity, would only be searched for its rounding.
const POLISH: usize = 2;
const GOOD_COST: f64 = 1e-8;

/// Deviations of a point, in errors; none where there is no answer.
pub(super) type Deviations<'a> = &'a (dyn Fn(&[f64]) -> Option<Vec<f64>> + Sync);

/// A sum of squares to be made small.
pub(super) struct Problem<'a> {
    pub deviations: Deviations<'a>,
    /// How many they are.
    pub measured: usize,
    /// Bounds within which starts lie.
    pub first: Vec<(f64, f64)>,
    /// Bounds that are never left.
    pub last: Vec<(f64, f64)>,
}

/// Where the search ended.
#[derive(Clone, Debug)]
pub(super) struct Minimum {
    pub point: Vec<f64>,
    /// Sum of the squares of all deviations.
    pub cost: f64,
}

impl Problem<'_> {
    /// Where searches from several starts end, the best first; none when there is no answer anywhere.
    pub fn minima(&self) -> Vec<Minimum> {
        let mut ends: Vec<Minimum> = Vec::new();
        for farther in FARTHER {
            let widened = |(first, last): (&(f64, f64), &(f64, f64))| {
                let towards = |from: f64, to: f64| from + farther * (to - from);
                (towards(first.0, last.0), towards(first.1, last.1))
            };
            let bounds: Vec<(f64, f64)> = self.first.iter().zip(&self.last).map(widened).collect();
            let mut trials: Vec<Minimum> = (0..TRIALS)
                .into_par_iter()
                .filter_map(|k| self.at(trial(&bounds, k)))
                .collect();
            trials.sort_by(|a, b| a.cost.total_cmp(&b.cost));
            trials.truncate(STARTS);
            ends.par_extend(trials.into_par_iter().map(|start| self.descend(start)));
            ends.sort_by(|a, b| a.cost.total_cmp(&b.cost));
            let fits = |best: &Minimum| best.cost <= largest_sum(self.measured, self.first.len());
            if self.first == self.last || ends.first().is_some_and(fits) {
                break;
            }
        }
        ends
    }

    /// Where searches end that begin where those of a like problem ended, the best first; these where none has an answer.
    pub fn minima_from(&self, like: Vec<Minimum>) -> Vec<Minimum> {
        let starts = like.iter().filter_map(|end| self.at(end.point.clone()));
        let mut ends: Vec<Minimum> = starts.map(|start| self.descend(start)).collect();
        ends.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        if ends.is_empty() { like } else { ends }
    }

    /// What a point costs, where there is an answer.
    pub fn at(&self, point: Vec<f64>) -> Option<Minimum> {
        let deviations = (self.deviations)(&point)?;
        let cost = dot(&deviations, &deviations);
        cost.is_finite().then_some(Minimum { point, cost })
    }

    /// Goes down from a point until nothing is gained.
    pub fn descend(&self, start: Minimum) -> Minimum {
        let mut best = start;
        let (mut damping, mut polished) = (1e-3, 0);
        for _ in 0..MOST_ITERATIONS {
            let Some(deviations) = (self.deviations)(&best.point) else {
                return best;
            };
            let Some(slopes) = slopes(self.deviations, &best.point, &self.last) else {
                return best;
            };
            let before = best.cost;
            while damping < MOST_DAMPING {
                let step = damped_step(&slopes, &deviations, damping);
                let to: Vec<f64> = (best.point.iter().zip(&step).zip(&self.last))
                    .map(|((x, dx), bounds)| (x + dx).clamp(bounds.0, bounds.1))
                    .collect();
                match self.at(to) {
                    Some(found) if found.cost < best.cost => {
                        best = found;
                        damping = (damping * 0.1).max(1e-15);
                        break;
                    }
                    _ => damping *= 10.0,
                }
            }
            polished += usize::from(best.cost < GOOD_COST);
            if polished > POLISH
                || damping >= MOST_DAMPING
                || before - best.cost <= GAIN * before
                || best.cost < NO_COST
            {
                return best;
            }
        }
        best
    }
}

/// Points that fill the bounds evenly (Halton); the first is the middle.
fn trial(bounds: &[(f64, f64)], k: u32) -> Vec<f64> {
    const BASES: [u32; 8] = [2, 3, 5, 7, 11, 13, 17, 19];
    let place = |(low, high): (f64, f64), base: u32| {
        let share = if k == 0 { 0.5 } else { radical_inverse(k, base) };
        low + (high - low) * share
    };
    let bases = BASES.into_iter().cycle();
    bounds.iter().zip(bases).map(|(b, base)| place(*b, base)).collect()
}

fn radical_inverse(mut k: u32, base: u32) -> f64 {
    let (mut value, mut share) = (0.0, 1.0 / f64::from(base));
    while k > 0 {
        value += share * f64::from(k % base);
        share /= f64::from(base);
        k /= base;
    }
    value
}

/// Slopes of all values against all unknowns, a row for every value; one-sided at a bound.
pub(super) fn slopes(
    values: impl Fn(&[f64]) -> Option<Vec<f64>>,
    point: &[f64],
    bounds: &[(f64, f64)],
) -> Option<Vec<Vec<f64>>> {
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for (column, &(low, high)) in bounds.iter().enumerate() {
        let moved = |by: f64| {
            let mut to = point.to_vec();
            to[column] = (to[column] + by).clamp(low, high);
            to
        };
        let (below, above) = (moved(-STEP), moved(STEP));
        let span = above[column] - below[column];
        let (below, above) = (values(&below)?, values(&above)?);
        rows.resize(below.len(), vec![0.0; bounds.len()]);
        for ((row, low), high) in rows.iter_mut().zip(&below).zip(&above) {
            row[column] = if span > 0.0 { (high - low) / span } else { 0.0 };
        }
    }
    Some(rows)
}

/// Solution of `(J^T J + damping diag(J^T J)) step = -J^T r`, by Cholesky's method.
fn damped_step(slopes: &[Vec<f64>], deviations: &[f64], damping: f64) -> Vec<f64> {
    let n = slopes.first().map_or(0, Vec::len);
    let column = |c: usize| slopes.iter().map(move |row| row[c]);
    let mut matrix: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            (0..n)
                .map(|j| column(i).zip(column(j)).map(|(a, b)| a * b).sum())
                .collect()
        })
        .collect();
    let largest = (0..n).map(|i| matrix[i][i]).fold(f64::MIN_POSITIVE, f64::max);
    for (i, row) in matrix.iter_mut().enumerate() {
        // an unknown that nothing depends on stays where it is
        row[i] += damping * row[i].max(1e-9 * largest) + 1e-14 * largest;
    }
    let mut right: Vec<f64> = (0..n)
        .map(|i| -column(i).zip(deviations).map(|(a, r)| a * r).sum::<f64>())
        .collect();
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| matrix[i][k] * matrix[j][k]).sum();
            let rest = matrix[i][j] - sum;
            matrix[i][j] = if i == j {
                rest.max(f64::MIN_POSITIVE).sqrt()
            } else {
                rest / matrix[j][j]
            };
        }
    }
    for i in 0..n {
        let sum: f64 = (0..i).map(|k| matrix[i][k] * right[k]).sum();
        right[i] = (right[i] - sum) / matrix[i][i];
    }
    for i in (0..n).rev() {
        let sum: f64 = (i + 1..n).map(|k| matrix[k][i] * right[k]).sum();
        right[i] = (right[i] - sum) / matrix[i][i];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curved_valley_is_followed_to_its_end() {
        // Rosenbrock's function as two deviations, with its minimum at (1, 1)
        let deviations = |x: &[f64]| Some(vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]]);
        let problem = Problem {
            deviations: &deviations,
            measured: 2,
            first: vec![(-2.0, 2.0); 2],
            last: vec![(-2.0, 2.0); 2],
        };
        let found = problem.minima();
        assert!(found[0].point.iter().all(|x| (x - 1.0).abs() < 1e-9), "{found:?}");
    }

    #[test]
    fn bounds_hold_and_points_without_an_answer_are_left_out() {
        let deviations = |x: &[f64]| (x[0] < 0.8).then(|| vec![x[0]]);
        let problem = Problem {
            deviations: &deviations,
            measured: 1,
            first: vec![(0.5, 1.0)],
            last: vec![(0.5, 1.0)],
        };
        assert_eq!(problem.minima()[0].point, [0.5]);
        let nowhere = |_: &[f64]| None;
        let problem = Problem {
            deviations: &nowhere,
            ..problem
        };
        assert!(problem.minima().is_empty());
    }
    #[test]
    fn starts_lie_farther_out_where_nothing_near_fits() {
        // flat but for a valley at -20
        let deviations = |x: &[f64]| Some(vec![((x[0] + 20.0) * 10.0).clamp(-40.0, 40.0)]);
        let problem = Problem {
            deviations: &deviations,
            measured: 1,
            first: vec![(-7.0, 7.0)],
            last: vec![(-27.0, 27.0)],
        };
        let found = problem.minima();
        assert!((found[0].point[0] + 20.0).abs() < 1e-9, "{found:?}");
    }
}
