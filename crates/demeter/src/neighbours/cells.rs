//! Cells: grains of every size class sorted into a grid of cells as large as the class needs, and their places copied
//! beside each other in that order.
//!
//! The copies are `f32`: a filter. What passes it is looked at again in `f64`, so nothing depends on its rounding.

use super::classes::SizeClasses;
use super::crowd::{Counts, Extent};
use super::ranges::{for_ranges, sums};
use super::rows_of_cells::RowsOfCells;
use super::vicinity::{Bounds, Vicinity};
use crate::comm::Single;
use crate::particles::{Grains, Row};
use glam::DVec3;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

/// Distance tests made at a time: a loop over columns of fixed length has no branches and is vectorised.
pub(super) const LANES: usize = 4;

/// Rounding of places in `f32`, as a share of the extent: two roundings in each of three directions, and to spare.
const ROUNDING: f64 = 5e-7;

/// Grains whose cells are found by one task.
const GRAINS_PER_TASK: usize = 4096;

/// The box around nearly all grains, in which places are measured from its lower corner.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Frame {
    lower: DVec3,
    pub(super) size: DVec3,
    /// Directions that are rings: periodic, and images do not slide across.
    pub(super) periodic: [bool; 3],
    /// What rounding to `f32` may add to a distance [m].
    pub(super) slack: f64,
    /// Least and largest places that are told apart: those beyond are drawn to the sides, which takes no two grains farther apart, so that the search still
    /// finds all that are near.
    ends: [DVec3; 2],
}

impl Frame {
    /// The box around the centres of nearly all grains; the whole box in periodic directions.
    pub(super) fn of(Extent { all, crowd }: Extent, comm: &Single) -> Self {
        let domain = comm.domain();
        let Bounds { mut lower, mut upper } = crowd;
        for axis in (0..3).filter(|&axis| domain.periodic[axis]) {
            lower[axis] = domain.lower[axis];
            upper[axis] = domain.upper[axis];
        }
        let size = (upper - lower).max(DVec3::ZERO);
        let mut ends = [DVec3::NEG_INFINITY, DVec3::INFINITY];
        for axis in (0..3).filter(|&axis| !domain.periodic[axis]) {
            if lower[axis] > all.lower[axis] || upper[axis] < all.upper[axis] {
                (ends[0][axis], ends[1][axis]) = (lower[axis], upper[axis]);
            }
        }
        Self {
            lower,
            size,
            periodic: comm.rings(),
            slack: ROUNDING * size.max_element(),
            ends,
        }
    }

    /// Place in the frame. A grain that has left a periodic box is put back: it is met where its image is.
    #[inline(always)]
    pub(super) fn local(&self, position: DVec3) -> DVec3 {
        self.put_back(self.drawn_in(position) - self.lower)
    }

    /// A place without what it lies beyond the ends.
    #[inline(always)]
    pub(super) fn drawn_in(&self, place: DVec3) -> DVec3 {
        let [least, most] = self.ends;
        place.max(least).min(most)
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
    /// Rows of cells of the grids before it, and where its own cells begin where all rows are in use.
    first_row: u32,
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
            first_row: 0,
            first_cell: 0,
        }
    }

    /// Rows of cells along the last direction.
    pub(super) fn rows(&self) -> u32 {
        (self.cells[0] * self.cells[1]) as u32
    }

    /// Cells of a row, and one that is always empty: rows in use need not be those beside each other.
    #[inline(always)]
    pub(super) fn stride(&self) -> u32 {
        self.cells[2] as u32 + 1
    }

    #[inline(always)]
    pub(super) fn coordinates(&self, local: DVec3) -> [i32; 3] {
        let at = local * self.per_edge;
        // a cast to whole numbers rounds towards 0; below 0 is nothing but rounding
        [0, 1, 2].map(|axis| (at[axis] as i32).clamp(0, self.cells[axis] - 1))
    }

    /// Number of a row among those of all grids.
    #[inline(always)]
    pub(super) fn row(&self, x: i32, y: i32) -> usize {
        self.first_row as usize + (x * self.cells[1] + y) as usize
    }

    /// Where a row begins, where all are in use.
    #[inline(always)]
    pub(super) fn start_of_row(&self, x: i32, y: i32) -> usize {
        self.first_cell as usize + (x * self.cells[1] + y) as usize * self.stride() as usize
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

/// The grids of all classes.
pub(super) fn grids(classes: &SizeClasses, frame: &Frame, skin: f64) -> Vec<Grid> {
    let (mut first_row, mut first_cell) = (0, 0);
    let grid = |&(members, largest): &(usize, f64)| {
        let mut grid = Grid::new(members, largest, 2.0 * largest + skin, frame);
        (grid.first_row, grid.first_cell) = (first_row, first_cell);
        first_row += grid.rows();
        first_cell += grid.rows() * grid.stride();
        grid
    };
    classes.members.iter().map(grid).collect()
}

/// Grains by size class and cell.
#[derive(Debug, Default)]
pub(super) struct Cells {
    pub(super) frame: Frame,
    pub(super) classes: SizeClasses,
    pub(super) grids: Vec<Grid>,
    /// Which other classes the grains of a class search.
    pub(super) asks: Vec<Vec<usize>>,
    pub(super) skin: f64,
    pub(super) rows: RowsOfCells,
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
    /// Sorts the grains anew, for a search of all pairs closer than `skin` to touching: those that are known here, in the
    /// grids of all.
    pub(super) fn sort(&mut self, grains: &Grains, comm: &Single, skin: f64, vicinity: Option<&Vicinity>) {
        self.skin = skin;
        match vicinity {
            Some(vicinity) => {
                self.frame = Frame::of(vicinity.extent, comm);
                self.classes.clone_from(&vicinity.classes);
            }
            None => {
                self.classes = SizeClasses::of_all(grains);
                let rows = || grains.position.rows().par_chunks(GRAINS_PER_TASK);
                let all = rows().map(Bounds::of_centres).reduce(|| Bounds::NOTHING, Bounds::join);
                let extent = Extent::find(all, &self.classes, comm, skin, |within| {
                    let some = |rows: &[Row]| Counts::of(rows.iter().map(|row| row.vector), within);
                    rows().map(some).reduce(Counts::none, Counts::plus)
                });
                self.frame = Frame::of(extent, comm);
            }
        }
        self.grids = grids(&self.classes, &self.frame, skin);
        self.choose_directions();
        let all = 0..grains.len();
        let known = vicinity.map_or(std::slice::from_ref(&all), |vicinity| &vicinity.known);
        self.fill(grains, known, vicinity.is_some());
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

    /// Counting sort by cell of the grains known; those of one cell are in the order of their indices.
    fn fill(&mut self, grains: &Grains, known: &[Range<usize>], are_some: bool) {
        let n = known.iter().map(Range::len).sum();
        self.place.resize_with(grains.len(), AtomicU32::default);
        let (frame, classes, grids) = (&self.frame, &self.classes, &self.grids);
        let place_of = |row: &Row| {
            let grid = &grids[classes.of(row.scalar)];
            (grid, grid.coordinates(frame.local(row.vector)))
        };
        let rows = grains.position.rows();
        let in_use = known.iter().flat_map(|some| &rows[some.clone()]).map(|row| {
            let (grid, [x, y, _]) = place_of(row);
            grid.row(x, y)
        });
        self.rows.find(grids, are_some.then_some(in_use));
        let rows_of_cells = &self.rows;
        for some in known {
            (self.place[some.clone()].par_chunks_mut(GRAINS_PER_TASK))
                .zip(rows[some.clone()].par_chunks(GRAINS_PER_TASK))
                .for_each(|(cells, rows)| {
                    for (cell, row) in cells.iter_mut().zip(rows) {
                        let (grid, [x, y, z]) = place_of(row);
                        *cell.get_mut() = (rows_of_cells.start(grid, x, y) + z as usize) as u32;
                    }
                });
        }
        self.start.clear();
        self.start.resize(self.rows.cells() + 1, 0);
        let cell = &self.place;
        for_ranges(0, &mut self.start[1..], n, &|first, counts: &mut [u32]| {
            for c in known.iter().flat_map(|some| &cell[some.clone()]) {
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
        self.place(grains, known, n);
    }

    /// Puts the grains where their cells begin. `start[c + 1]` begins as the start of cell `c`, and ends as its end.
    fn place(&mut self, grains: &Grains, known: &[Range<usize>], count: usize) {
        let member = &mut self.member[..count];
        let cell = &self.place;
        super::ranges::scatter(0, &mut self.start[1..], 0, member, &|first, starts, base, members| {
            for grain in known.iter().cloned().flatten() {
                let c = cell[grain].load(Ordering::Relaxed);
                if let Some(next) = starts.get_mut((c as usize).wrapping_sub(first)) {
                    members[*next as usize - base] = grain as u32;
                    *next += 1;
                }
            }
        });
        let (frame, place) = (&self.frame, &self.place);
        let n = GRAINS_PER_TASK;
        (
            self.x[..count].par_chunks_mut(n),
            self.y[..count].par_chunks_mut(n),
            self.z[..count].par_chunks_mut(n),
            self.radius[..count].par_chunks_mut(n),
            self.member[..count].par_chunks(n),
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
            column[count..].fill(f32::INFINITY);
        }
    }
}
