//! Taylor series integration of the viscoelastic Hertzian collision.
//!
//! With `x = u^2` and `dt = 2 u ds` the equation `x'' + beta sqrt(x) x' + x^(3/2) = 0` becomes polynomial,
//!
//! ```text
//! du/ds = v      dv/ds = -2 u^2 (beta v + u^2)      dt/ds = 2 u
//! ```
//!
//! so that all coefficients of the solution follow from recurrences (Cauchy products), and there is no singular point at
//! first touch or at zero overlap. Steps are as long as the last coefficients allow; an event is a root of a polynomial.

use super::ContactEnd;
use super::bracketed;

/// Highest power of the series.
const ORDER: usize = 24;

/// What the last terms of a series may add, by the size of the state.
const TOLERANCE: f64 = 1e-18;

/// Steps before giving up: some ten times what the strongest damping allowed takes.
const MOST_STEPS: usize = 400_000;

/// Where an integration ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Outcome {
    pub time: f64,
    pub speed: f64,
    pub overlap: f64,
}

/// Coefficients of `t`, `u` and `v` in powers of `s`.
struct Series {
    time: [f64; ORDER + 1],
    root: [f64; ORDER + 1],
    speed: [f64; ORDER + 1],
}

/// Coefficient `k` of the product of two series.
fn product(a: &[f64; ORDER + 1], b: &[f64; ORDER + 1], k: usize) -> f64 {
    (0..=k).map(|i| a[i] * b[k - i]).sum()
}

fn value(series: &[f64; ORDER + 1], s: f64) -> f64 {
    series.iter().rev().fold(0.0, |sum, coefficient| sum * s + coefficient)
}

impl Series {
    fn at(beta: f64, [time, root, speed]: [f64; 3]) -> Self {
        let mut all = Self {
            time: [0.0; ORDER + 1],
            root: [0.0; ORDER + 1],
            speed: [0.0; ORDER + 1],
        };
        (all.time[0], all.root[0], all.speed[0]) = (time, root, speed);
        let (mut square, mut force) = ([0.0; ORDER + 1], [0.0; ORDER + 1]);
        for k in 0..ORDER {
            square[k] = product(&all.root, &all.root, k);
            force[k] = beta * all.speed[k] + square[k];
            let over = 1.0 / (k as f64 + 1.0);
            all.time[k + 1] = 2.0 * all.root[k] * over;
            all.root[k + 1] = all.speed[k] * over;
            all.speed[k + 1] = -2.0 * product(&square, &force, k) * over;
        }
        all
    }

    /// The step over which the last terms stay below the tolerance: five, for without damping only every fifth is not zero.
    fn longest_step(&self, beta: f64) -> f64 {
        let square = self.root[0] * self.root[0];
        let speed = self.speed[0].abs() + square / (1.0 + beta);
        let scales = [(&self.root, self.root[0].abs() + speed), (&self.speed, speed)];
        let mut step = f64::INFINITY;
        for (series, scale) in scales {
            for (k, coefficient) in series.iter().enumerate().skip(ORDER - 4) {
                if *coefficient != 0.0 {
                    step = step.min(libm::pow(TOLERANCE * scale / coefficient.abs(), 1.0 / k as f64));
                }
            }
        }
        step
    }

    fn state(&self, s: f64) -> [f64; 3] {
        [&self.time, &self.root, &self.speed].map(|series| value(series, s))
    }

    /// `force/sqrt(x)`: `beta v + u^2`.
    fn force(&self, beta: f64, s: f64) -> f64 {
        let [_, u, v] = self.state(s);
        beta * v + u * u
    }
}

fn outcome([time, u, speed]: [f64; 3]) -> Outcome {
    Outcome {
        time,
        speed,
        overlap: u * u,
    }
}

/// From first touch with speed 1 to the largest overlap.
pub(super) fn to_largest_overlap(beta: f64) -> Option<Outcome> {
    let mut state = [0.0, 0.0, 1.0];
    for _ in 0..MOST_STEPS {
        let series = Series::at(beta, state);
        let h = series.longest_step(beta);
        let next = series.state(h);
        if next[2] <= 0.0 {
            let s = bracketed(|s| value(&series.speed, s), 0.0, h);
            return Some(outcome(series.state(s)));
        }
        state = next;
    }
    None
}

/// From first touch with speed 1 to the end of contact.
pub(super) fn to_end(beta: f64, end: ContactEnd) -> Option<Outcome> {
    let mut state = [0.0, 0.0, 1.0];
    for _ in 0..MOST_STEPS {
        let series = Series::at(beta, state);
        let h = series.longest_step(beta);
        let next = series.state(h);
        // the step's end, but no later than zero overlap: the force has its zero before
        let zero_overlap = next[1] <= 0.0;
        let last = if zero_overlap {
            let least = if state[1] > 0.0 { 0.0 } else { 0.5 * h };
            bracketed(|s| value(&series.root, s), least, h)
        } else {
            h
        };
        if end == ContactEnd::ZeroForce && series.force(beta, last) < 0.0 {
            let s = bracketed(|s| series.force(beta, s), 0.0, last);
            return Some(outcome(series.state(s)));
        }
        if zero_overlap {
            return Some(outcome(series.state(last)));
        }
        state = next;
    }
    None
}
