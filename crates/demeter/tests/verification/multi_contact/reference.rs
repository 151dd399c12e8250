//! The coupled equation of a whole packing, solved by Newton's method with a dense matrix, over all pairs: nothing of the
//! engine but the places of the grains enters.

use super::influence::{Ball, Model, Place};
use demeter_physics::DVec3;
use std::f64::consts::PI;

/// Normal law of one contact.
#[derive(Clone, Copy, Debug)]
pub struct Force {
    /// `4/3 E sqrt(R)` [N/m^1.5].
    pub stiffness: f64,
    /// Pull at contact, separation, and cut-off of the tail of `dmt`; all 0 for `hertz-tsuji`.
    pub pull: f64,
    pub separation: f64,
    pub cutoff: f64,
}

/// Laws of all contacts.
#[derive(Clone, Copy, Debug, Default)]
pub struct Adhesion {
    pub work: f64,
    pub separation: f64,
    pub cutoff: f64,
}

impl Force {
    pub fn new(effective_modulus: f64, effective_radius: f64, adhesion: Adhesion) -> Self {
        Self {
            stiffness: 4.0 / 3.0 * effective_modulus * effective_radius.sqrt(),
            pull: 2.0 * PI * adhesion.work * effective_radius,
            separation: adhesion.separation,
            cutoff: adhesion.cutoff,
        }
    }

    /// Force and its slope at a displaced overlap.
    pub fn at(&self, y: f64) -> (f64, f64) {
        if y > 0.0 {
            let root = y.sqrt();
            (self.stiffness * y * root - self.pull, 1.5 * self.stiffness * root)
        } else if -y < self.cutoff {
            let share = self.separation / (self.separation - y);
            let force = -self.pull * share * share;
            (force, 2.0 * force / (self.separation - y))
        } else {
            (0.0, 0.0)
        }
    }

    /// Mean of Hertz's force over the path from `y - h` to `y + h`.
    pub fn hertz_mean(&self, y: f64, h: f64) -> f64 {
        let whole = |y: f64| {
            let y = f64::max(y, 0.0);
            0.4 * y * y * y.sqrt()
        };
        if h > 1e-3 * y.abs() {
            self.stiffness * (whole(y + h) - whole(y - h)) / (2.0 * h)
        } else {
            // f + f'' h^2/6
            self.at(y).0 * (1.0 + h * h / (8.0 * y * y))
        }
    }
}

/// A pair of balls, or of a ball and a wall, that touch or might.
#[derive(Clone, Copy, Debug)]
pub struct Touch {
    pub first: usize,
    /// Nothing at a wall.
    pub second: Option<usize>,
    /// Unit vector into the first ball.
    pub normal: DVec3,
    /// Overlap of the undisplaced surfaces [m].
    pub overlap: f64,
    /// Distance of the centres, or of the centre from the wall [m].
    pub distance: f64,
    pub force: Force,
    /// What displaces it.
    pub model: Model,
}

/// Displacement of both surfaces [m].
pub type Shift = [f64; 2];

pub struct Packing {
    pub balls: Vec<Ball>,
    pub touches: Vec<Touch>,
}

pub struct Solution {
    pub force: Vec<f64>,
    pub shift: Vec<Shift>,
}

impl Packing {
    /// The contact as one of its bodies sees it, with the surfaces displaced.
    pub fn place(&self, touch: usize, side: usize, shift: Shift) -> (usize, Place) {
        let t = &self.touches[touch];
        let Some(second) = t.second else {
            let (normal, lever) = (t.normal, t.distance);
            return (t.first, Place { normal, lever });
        };
        let (ri, rj) = (self.balls[t.first].radius, self.balls[second].radius);
        let first_lever = 0.5 * (t.distance + (ri + shift[0]) - (rj + shift[1]));
        let (ball, normal, lever) = match side {
            0 => (t.first, t.normal, first_lever),
            _ => (second, -t.normal, t.distance - first_lever),
        };
        (ball, Place { normal, lever })
    }

    fn feels_levers(&self) -> bool {
        self.touches.iter().any(|t| t.model.feels_levers())
    }

    fn sides(&self, touch: usize) -> std::ops::Range<usize> {
        0..if self.touches[touch].second.is_some() { 2 } else { 1 }
    }

    /// Touches of every ball, with the side that the ball is on.
    fn by_ball(&self) -> Vec<Vec<(usize, usize)>> {
        let mut of = vec![Vec::new(); self.balls.len()];
        for (k, touch) in self.touches.iter().enumerate() {
            of[touch.first].push((k, 0));
            if let Some(second) = touch.second {
                of[second].push((k, 1));
            }
        }
        of
    }

    /// `(source, influence)` on both sides of every touch; sources for which `counts` is false are left out.
    fn influences(&self, shift: &[Shift], counts: impl Fn(usize) -> bool) -> Vec<[Vec<(usize, f64)>; 2]> {
        let by_ball = self.by_ball();
        let row = |c: usize, side: usize| {
            let (ball, to) = self.place(c, side, shift[c]);
            let others = by_ball[ball].iter().filter(|(k, _)| *k != c && counts(*k));
            others
                .map(|&(k, of)| {
                    let from = self.place(k, of, shift[k]).1;
                    (k, self.touches[c].model.influence(&self.balls[ball], from, to))
                })
                .collect::<Vec<_>>()
        };
        let rows = |c: usize| {
            let second = self.sides(c).nth(1).map_or_else(Vec::new, |side| row(c, side));
            [row(c, 0), second]
        };
        (0..self.touches.len()).map(rows).collect()
    }

    /// Displacements by forces, with the contact points told.
    pub fn displacements(&self, force: &[f64], shift: &[Shift]) -> Vec<Shift> {
        let rows = self.influences(shift, |k| force[k] != 0.0);
        let sum = |row: &Vec<(usize, f64)>| row.iter().map(|(k, a)| a * force[*k]).sum();
        rows.iter().map(|sides| [sum(&sides[0]), sum(&sides[1])]).collect()
    }

    /// Displacements by forces, with contact points on the surfaces that these displacements give.
    pub fn consistent_displacements(&self, force: &[f64]) -> Vec<Shift> {
        let mut shift = vec![[0.0; 2]; self.touches.len()];
        for _ in 0..60 {
            let found = self.displacements(force, &shift);
            let change = largest(found.iter().flatten().zip(shift.iter().flatten()).map(|(a, b)| a - b));
            shift = found;
            if change < 1e-12 || !self.feels_levers() {
                return shift;
            }
        }
        panic!("contact points do not settle");
    }

    /// Forces and displacements that agree with each other, or nothing where Newton's method finds none.
    pub fn solve(&self) -> Option<Solution> {
        let count = self.touches.len();
        let mut force: Vec<f64> = self.touches.iter().map(|t| t.force.at(t.overlap).0).collect();
        let mut shift = vec![[0.0; 2]; count];
        let mut rows = Vec::new();
        for _ in 0..200 {
            if rows.is_empty() || self.feels_levers() {
                rows = self.influences(&shift, |_| true);
            }
            let sum = |row: &Vec<(usize, f64)>| row.iter().map(|(k, a)| a * force[*k]).sum::<f64>();
            let found: Vec<Shift> = rows.iter().map(|sides| [sum(&sides[0]), sum(&sides[1])]).collect();
            let moved = largest(found.iter().flatten().zip(shift.iter().flatten()).map(|(a, b)| a - b));
            shift = found;
            let mut matrix = vec![vec![0.0; count + 1]; count];
            for (c, touch) in self.touches.iter().enumerate() {
                let (answer, slope) = touch.force.at(touch.overlap + shift[c][0] + shift[c][1]);
                matrix[c][c] += 1.0;
                for (k, a) in rows[c].iter().flatten() {
                    matrix[c][*k] -= slope * a;
                }
                matrix[c][count] = answer - force[c];
            }
            let change = eliminate(&mut matrix)?;
            for (f, d) in force.iter_mut().zip(&change) {
                *f += d;
            }
            if largest(change.iter().copied()) < 1e-15 * largest(force.iter().copied()) && moved < 1e-14 {
                return Some(Solution { force, shift });
            }
        }
        None
    }
}

pub fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |largest, v| f64::max(largest, v.abs()))
}

/// Gaussian elimination with row pivots; the last column is the right-hand side.
fn eliminate(matrix: &mut [Vec<f64>]) -> Option<Vec<f64>> {
    let count = matrix.len();
    for p in 0..count {
        let pivot = (p..count).max_by(|&a, &b| matrix[a][p].abs().total_cmp(&matrix[b][p].abs()))?;
        matrix.swap(p, pivot);
        let (above, below) = matrix.split_at_mut(p + 1);
        let row = &above[p];
        if row[p] == 0.0 {
            return None;
        }
        for other in below.iter_mut().filter(|r| r[p] != 0.0) {
            let factor = other[p] / row[p];
            for (x, y) in other[p..].iter_mut().zip(&row[p..]) {
                *x -= factor * y;
            }
        }
    }
    let mut solution = vec![0.0; count];
    for p in (0..count).rev() {
        let known: f64 = (p + 1..count).map(|k| matrix[p][k] * solution[k]).sum();
        solution[p] = (matrix[p][count] - known) / matrix[p][p];
    }
    Some(solution)
}
