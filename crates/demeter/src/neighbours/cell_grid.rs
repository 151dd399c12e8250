//! Cell grid for one size class.

use crate::particles::{Domain, Rows};
use glam::DVec3;

/// Grains of one size class, sorted into cells. Periodic directions hold a whole number of cells.
pub(super) struct CellGrid {
    lower: DVec3,
    inverse_edge: DVec3,
    cells: [i64; 3],
    periodic: [bool; 3],
    start: Vec<u32>,
    members: Vec<u32>,
    /// Largest radius in the class [m].
    pub(super) max_radius: f64,
}

impl CellGrid {
    /// Sorts `members` into cells of at least `edge`, coarser when the space is so sparse that cells would outnumber
    /// grains by far.
    pub(super) fn new(members: &[u32], position: &Rows, max_radius: f64, edge: f64, domain: &Domain) -> Self {
        let (lower, upper) = extent(members, position, domain);
        let size = upper - lower;
        let most = 4.0 * members.len() as f64 + 64.0;
        let mut edge = edge;
        let mut cells = [1i64; 3];
        loop {
            for axis in 0..3 {
                cells[axis] = (size[axis] / edge).floor().clamp(1.0, 1e6) as i64;
            }
            if cells.iter().map(|&n| n as f64).product::<f64>() <= most {
                break;
            }
            edge *= 1.25;
        }
        let per_edge = |axis: usize| {
            if size[axis] > 0.0 {
                cells[axis] as f64 / size[axis]
            } else {
                0.0
            }
        };
        let mut grid = Self {
            lower,
            inverse_edge: DVec3::new(per_edge(0), per_edge(1), per_edge(2)),
            cells,
            periodic: domain.periodic,
            start: Vec::new(),
            members: vec![0; members.len()],
            max_radius,
        };
        grid.sort(members, position);
        grid
    }

    fn sort(&mut self, members: &[u32], position: &Rows) {
        let count = (self.cells[0] * self.cells[1] * self.cells[2]) as usize;
        let cell: Vec<u32> = members
            .iter()
            .map(|&g| self.cell_of(position[g as usize]) as u32)
            .collect();
        self.start = vec![0; count + 1];
        for &c in &cell {
            self.start[c as usize + 1] += 1;
        }
        for c in 0..count {
            self.start[c + 1] += self.start[c];
        }
        let mut next = self.start.clone();
        for (&g, &c) in members.iter().zip(&cell) {
            self.members[next[c as usize] as usize] = g;
            next[c as usize] += 1;
        }
    }

    #[inline]
    fn coordinate(&self, axis: usize, x: f64) -> i64 {
        ((x - self.lower[axis]) * self.inverse_edge[axis]).floor() as i64
    }

    fn cell_of(&self, p: DVec3) -> usize {
        let c = |axis: usize| self.coordinate(axis, p[axis]).clamp(0, self.cells[axis] - 1);
        ((c(0) * self.cells[1] + c(1)) * self.cells[2] + c(2)) as usize
    }

    /// Cells along one axis that a reach around `x` touches: first cell (unwrapped) and their number.
    fn span(&self, axis: usize, x: f64, reach: f64) -> (i64, i64) {
        let last = self.cells[axis] - 1;
        let (mut low, mut high) = (self.coordinate(axis, x - reach), self.coordinate(axis, x + reach));
        if self.periodic[axis] {
            // a grain slightly outside the box lies in the border cell, so the border cells are reached with it
            return (low, (high - low + 1).min(self.cells[axis]));
        }
        low = low.clamp(0, last);
        high = high.clamp(0, last);
        (low, high - low + 1)
    }

    /// Calls `f` with every grain whose cell is within `reach` of a point, each once, in a fixed order.
    pub(super) fn visit(&self, point: DVec3, reach: f64, mut f: impl FnMut(u32)) {
        let spans = [0, 1, 2].map(|axis| self.span(axis, point[axis], reach));
        for a in 0..spans[0].1 {
            let x = (spans[0].0 + a).rem_euclid(self.cells[0]);
            for b in 0..spans[1].1 {
                let y = (spans[1].0 + b).rem_euclid(self.cells[1]);
                for c in 0..spans[2].1 {
                    let z = (spans[2].0 + c).rem_euclid(self.cells[2]);
                    let cell = ((x * self.cells[1] + y) * self.cells[2] + z) as usize;
                    for &g in &self.members[self.start[cell] as usize..self.start[cell + 1] as usize] {
                        f(g);
                    }
                }
            }
        }
    }
}

/// Bounding box of the grains; the whole box in periodic directions.
fn extent(members: &[u32], position: &Rows, domain: &Domain) -> (DVec3, DVec3) {
    let (mut lower, mut upper) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for &g in members {
        lower = lower.min(position[g as usize]);
        upper = upper.max(position[g as usize]);
    }
    for axis in 0..3 {
        if domain.periodic[axis] {
            lower[axis] = domain.lower[axis];
            upper[axis] = domain.upper[axis];
        }
    }
    (lower, upper)
}
