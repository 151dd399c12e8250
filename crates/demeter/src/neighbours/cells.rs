//! Cells: grains of every size class sorted into a grid of cells as large as the class needs, and their places copied
//! beside each other in that order.
//!
//! The copies are `f32`: a filter. What passes it is looked at again in `f64`, so nothing depends on its rounding.

use super::ranges::{for_ranges, sums};
use crate::comm::Single;
use crate::particles::Grains;
use glam::DVec3;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU32, Ordering};

/// Distance tests made at a time: a loop over columns of fixed length has no branches and is vectorised.
pub(super) const LANES: usize = 4;

/// Rounding of places in `f32`, as a share of the extent: two roundings in each of three directions, and to spare.
const ROUNDING: f64 = 5e-7;

/// Grains whose cells are found by one task.
const GRAINS_PER_TASK: usize = 4096;

/// Most size classes.
const CLASSES: usize = 20;

/// The box around all grains, in which places are measured from its lower corner.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Frame {
    lower: DVec3,
    pub(super) size: DVec3,
    /// Directions that are rings: periodic, and images do not slide across.
    pub(super) periodic: [bool; 3],
    /// What rounding to `f32` may add to a distance [m].
    pub(super) slack: f64,
}

impl Frame {
    /// Bounding box of the grains; the whole box in periodic directions.
    fn around(grains: &Grains, comm: &Single) -> Self {
        let domain = comm.domain();
        let ends = |(lower, upper): (DVec3, DVec3), other: (DVec3, DVec3)| (lower.min(other.0), upper.max(other.1));
        let nothing = || (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let (mut lower, mut upper) = (grains.position.rows().par_chunks(GRAINS_PER_TASK))
            .map(|rows| (rows.iter()).fold(nothing(), |all, row| ends(all, (row.vector, row.vector))))
            .reduce(nothing, ends);
        for axis in (0..3).filter(|&axis| domain.periodic[axis]) {
            lower[axis] = domain.lower[axis];
            upper[axis] = domain.upper[axis];
        }
        let size = (upper - lower).max(DVec3::ZERO);
        Self {
            lower,
            size,
            periodic: comm.rings(),
            slack: ROUNDING * size.max_element(),
        }
    }

    /// Place in the frame. A grain that has left a periodic box is put back: it is met where its image is.
    #[inline(always)]
    pub(super) fn local(&self, position: DVec3) -> DVec3 {
        self.put_back(position - self.lower)
    }

    /// A place in the frame that may lie one box outside of a ring.
    #[inline(always)]
    pub(super) fn put_back(&self, place: DVec3) -> DVec3 {
        let mut p = place;
        for axis in 0..3 {
            if self.periodic[axis] {
                if p[axis] >= self.size[axis] {
                    p[axis] -= self.size[axis];
                } else if p[axis] < 0.0 {
                    p[axis] += self.size[axis];
                }
            }
        }
        p
    }
}

/// The grid of one size class.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    pub(super) members: usize,
    /// Largest radius [m].
    pub(super) largest: f64,
    pub(super) cells: [i32; 3],
    pub(super) edge: DVec3,
    pub(super) per_edge: DVec3,
    /// Cells of the grids before it.
    first_cell: u32,
}

impl Grid {
    /// Cells of at least `edge`, coarser when they would outnumber the members by far.
    fn new(members: usize, largest: f64, edge: f64, frame: &Frame) -> Self {
        let most = 2.0 * members as f64 + 64.0;
        let mut cells = [1i32; 3];
        let mut wanted = edge * (1.0 + 1e-9);
        loop {
            for (axis, cells) in cells.iter_mut().enumerate() {
                let count = (frame.size[axis] / wanted).floor();
                // one cell also where a size is no number
                *cells = if count > 1.0 { count.min(1e6) as i32 } else { 1 };
                // on a ring of two cells each would be on both sides of the other
                if frame.periodic[axis] && *cells == 2 {
                    *cells = 1;
                }
            }
            if cells.iter().map(|&n| f64::from(n)).product::<f64>() <= most {
                break;
            }
            wanted *= 1.25;
        }
        let count = DVec3::from_array(cells.map(f64::from));
        let per_edge = |axis: usize| {
            if frame.size[axis] > 0.0 {
                count[axis] / frame.size[axis]
            } else {
                0.0
            }
        };
        Self {
            members,
            largest,
            cells,
            edge: frame.size / count,
            per_edge: DVec3::new(per_edge(0), per_edge(1), per_edge(2)),
            first_cell: 0,
        }
    }

    fn count(&self) -> u32 {
        self.cells.iter().map(|&n| n as u32).product()
    }

    #[inline(always)]
    pub(super) fn coordinates(&self, local: DVec3) -> [i32; 3] {
        let at = local * self.per_edge;
        // a cast to whole numbers rounds towards 0; below 0 is nothing but rounding
        [0, 1, 2].map(|axis| (at[axis] as i32).clamp(0, self.cells[axis] - 1))
    }

    #[inline(always)]
    pub(super) fn row(&self, x: i32, y: i32) -> usize {
        self.first_cell as usize + ((x * self.cells[1] + y) * self.cells[2]) as usize
    }

    /// Rows of cells that a search with a reach has to look at.
    fn rows_within(&self, reach: f64) -> f64 {
        (0..2)
            .map(|axis| {
                let cells = f64::from(self.cells[axis]);
                (2.0 * reach * self.per_edge[axis] + 1.0).min(cells)
            })
            .product()
    }
}

/// Limits of the size classes, which halve from the largest radius on.
#[derive(Clone, Debug, Default)]
pub(super) struct Classes {
    /// Smallest radius of every class but the last [m].
    limits: Vec<f64>,
}

impl Classes {
    #[inline(always)]
    pub(super) fn of(&self, radius: f64) -> usize {
        self.limits.iter().take_while(|&&limit| radius < limit).count()
    }
}

/// Grains by size class and cell.
#[derive(Debug, Default)]
pub(super) struct Cells {
    pub(super) frame: Frame,
    pub(super) classes: Classes,
    pub(super) grids: Vec<Grid>,
    /// Which other classes the grains of a class search.
    pub(super) asks: Vec<Vec<usize>>,
    pub(super) skin: f64,
    /// Cell of every grain; when the grains are in order, its place in it. Every value is written by one task.
    pub(super) place: Vec<AtomicU32>,
    pub(super) start: Vec<u32>,
    pub(super) x: Vec<f32>,
    pub(super) y: Vec<f32>,
    pub(super) z: Vec<f32>,
    pub(super) radius: Vec<f32>,
    pub(super) member: Vec<u32>,
}

impl Cells {
    /// Sorts the grains anew, for a search of all pairs closer than `skin` to touching.
    pub(super) fn sort(&mut self, grains: &Grains, comm: &Single, skin: f64) {
        self.skin = skin;
        self.frame = Frame::around(grains, comm);
        self.find_classes(grains);
        self.choose_directions();
        self.fill(grains);
    }

    fn find_classes(&mut self, grains: &Grains) {
        type Found = ([u32; CLASSES], [f64; CLASSES]);
        let largest = (grains.position.rows().par_chunks(GRAINS_PER_TASK))
            .map(|rows| rows.iter().map(|row| row.scalar).fold(0.0, f64::max))
            .reduce(|| 0.0, f64::max);
        let smallest = (grains.position.rows().par_chunks(GRAINS_PER_TASK))
            .map(|rows| rows.iter().map(|row| row.scalar).fold(f64::INFINITY, f64::min))
            .reduce(|| f64::INFINITY, f64::min);
        self.classes.limits.clear();
        let mut limit = 0.5 * largest;
        while smallest < limit && self.classes.limits.len() + 1 < CLASSES {
            self.classes.limits.push(limit);
            limit *= 0.5;
        }
        let join = |mut a: Found, b: Found| {
            for class in 0..CLASSES {
                a.0[class] += b.0[class];
                a.1[class] = a.1[class].max(b.1[class]);
            }
            a
        };
        let nothing = || ([0; CLASSES], [0.0; CLASSES]);
        let (members, radii): Found = (grains.position.rows().par_chunks(GRAINS_PER_TASK))
            .map(|rows| {
                let mut found = nothing();
                for row in rows {
                    let class = self.classes.of(row.scalar);
                    found.0[class] += 1;
                    found.1[class] = f64::max(found.1[class], row.scalar);
                }
                found
            })
            .reduce(nothing, join);
        self.grids.clear();
        let mut first_cell = 0;
        for class in 0..=self.classes.limits.len() {
            let edge = 2.0 * radii[class] + self.skin;
            let mut grid = Grid::new(members[class] as usize, radii[class], edge, &self.frame);
            grid.first_cell = first_cell;
            first_cell += grid.count();
            self.grids.push(grid);
        }
    }

    /// Of two classes that one searches the other which has to look at fewer rows of cells: mostly the larger grains, as
    /// there are fewer of them.
    fn choose_directions(&mut self) {
        self.asks.resize_with(self.grids.len().max(self.asks.len()), Vec::new);
        self.asks.iter_mut().for_each(Vec::clear);
        for large in 0..self.grids.len() {
            for small in large + 1..self.grids.len() {
                let (a, b) = (&self.grids[large], &self.grids[small]);
                let reach = a.largest + b.largest + self.skin;
                let down = a.members as f64 * b.rows_within(reach);
                let up = b.members as f64 * a.rows_within(reach);
                if down == 0.0 || up == 0.0 {
                    continue;
                }
                if down <= up {
                    self.asks[large].push(small);
                } else {
                    self.asks[small].push(large);
                }
            }
        }
    }

    /// Counting sort by cell; grains of one cell are in the order of their indices.
    fn fill(&mut self, grains: &Grains) {
        let n = grains.len();
        let cells = self.grids.last().map_or(0, |grid| grid.first_cell + grid.count()) as usize;
        self.place.resize_with(n, AtomicU32::default);
        let (frame, classes, grids) = (&self.frame, &self.classes, &self.grids);
        (self.place.par_chunks_mut(GRAINS_PER_TASK))
            .zip(grains.position.rows().par_chunks(GRAINS_PER_TASK))
            .for_each(|(cells, rows)| {
                for (cell, row) in cells.iter_mut().zip(rows) {
                    let grid = &grids[classes.of(row.scalar)];
                    let [x, y, z] = grid.coordinates(frame.local(row.vector));
                    *cell.get_mut() = (grid.row(x, y) as i32 + z) as u32;
                }
            });
        self.start.clear();
        self.start.resize(cells + 1, 0);
        let cell = &self.place;
        for_ranges(0, &mut self.start[1..], n, &|first, counts: &mut [u32]| {
            for c in cell {
                let c = c.load(Ordering::Relaxed);
                if let Some(count) = counts.get_mut((c as usize).wrapping_sub(first)) {
                    *count += 1;
                }
            }
        });
        sums(&mut self.start);
        for column in [&mut self.x, &mut self.y, &mut self.z, &mut self.radius] {
            column.resize(n + LANES, f32::INFINITY);
        }
        self.member.resize(n + LANES, 0);
        self.place(grains);
    }

    /// Puts the grains where their cells begin. `start[c + 1]` begins as the start of cell `c`, and ends as its end.
    fn place(&mut self, grains: &Grains) {
        let member = &mut self.member[..grains.len()];
        let cell = &self.place;
        super::ranges::scatter(0, &mut self.start[1..], 0, member, &|first, starts, base, members| {
            for (grain, c) in cell.iter().enumerate() {
                let c = c.load(Ordering::Relaxed);
                if let Some(next) = starts.get_mut((c as usize).wrapping_sub(first)) {
                    members[*next as usize - base] = grain as u32;
                    *next += 1;
                }
            }
        });
        let (frame, place) = (&self.frame, &self.place);
        let n = GRAINS_PER_TASK;
        (
            self.x[..grains.len()].par_chunks_mut(n),
            self.y[..grains.len()].par_chunks_mut(n),
            self.z[..grains.len()].par_chunks_mut(n),
            self.radius[..grains.len()].par_chunks_mut(n),
            self.member[..grains.len()].par_chunks(n),
        )
            .into_par_iter()
            .enumerate()
            .for_each(|(task, (x, y, z, radius, members))| {
                for (k, &member) in members.iter().enumerate() {
                    place[member as usize].store((task * n + k) as u32, Ordering::Relaxed);
                    let row = &grains.position.rows()[member as usize];
                    let p = frame.local(row.vector);
                    (x[k], y[k], z[k], radius[k]) = (p.x as f32, p.y as f32, p.z as f32, row.scalar as f32);
                }
            });
        for column in [&mut self.x, &mut self.y, &mut self.z] {
            column[grains.len()..].fill(f32::INFINITY);
        }
    }

    /// Bytes in use.
    pub(super) fn bytes(&self) -> usize {
        4 * (self.place.capacity() + self.start.capacity() + self.member.capacity() + 4 * self.x.capacity())
    }
}
