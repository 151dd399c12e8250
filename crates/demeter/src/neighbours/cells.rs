//! Cells: grains of every size class sorted into a grid of cells as large as the class needs, and their places copied
//! beside each other in that order.
//!
//! The copies are `f32`: a filter. What passes it is looked at again in `f64`, so nothing depends on its rounding.

use super::ranges::{for_ranges, sums};
use crate::particles::{Domain, Grains};
use glam::DVec3;
use rayon::prelude::*;

/// Distance tests made at a time: a loop over columns of fixed length has no branches and is vectorised.
pub(super) const LANES: usize = 8;

/// Rounding of places in `f32`, as a share of the extent: two roundings in each of three directions, and to spare.
const ROUNDING: f64 = 5e-7;

/// What rounding of the arithmetic of the filter may take from a reach.
const FILTER: f64 = 1.0 + 4e-6;

/// Grains whose cells are found by one task.
const GRAINS_PER_TASK: usize = 4096;

/// Most size classes.
const CLASSES: usize = 20;

/// The box around all grains, in which places are measured from its lower corner.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Frame {
    lower: DVec3,
    size: DVec3,
    periodic: [bool; 3],
    /// What rounding to `f32` may add to a distance [m].
    slack: f64,
}

impl Frame {
    /// Bounding box of the grains; the whole box in periodic directions.
    fn around(grains: &Grains, domain: &Domain) -> Self {
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
            periodic: domain.periodic,
            slack: ROUNDING * size.max_element(),
        }
    }

    /// Place in the frame. A grain that has left a periodic box is put back: it is met where its image is.
    #[inline(always)]
    pub(super) fn local(&self, position: DVec3) -> DVec3 {
        let mut p = position - self.lower;
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
    cells: [i32; 3],
    edge: DVec3,
    per_edge: DVec3,
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
                *cells = (frame.size[axis] / wanted).floor().clamp(1.0, 1e6) as i32;
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
    fn coordinates(&self, local: DVec3) -> [i32; 3] {
        let at = local * self.per_edge;
        // a cast to whole numbers rounds towards 0; below 0 is nothing but rounding
        [0, 1, 2].map(|axis| (at[axis] as i32).clamp(0, self.cells[axis] - 1))
    }

    #[inline(always)]
    fn row(&self, x: i32, y: i32) -> usize {
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

/// A place whose surroundings are searched.
#[derive(Clone, Copy)]
struct Probe {
    at: [f32; 3],
    /// Reach without the radius of the other grain [m].
    reach: f32,
    /// Periods; infinite where there is none.
    period: [f32; 3],
}

/// Runs of grains in the order of the cells.
#[derive(Default)]
struct Runs {
    list: [(u32, u32); 10],
    count: usize,
}

impl Runs {
    #[inline(always)]
    fn push(&mut self, from: u32, to: u32) {
        if from < to {
            self.list[self.count] = (from, to);
            self.count += 1;
        }
    }
}

/// Limits of the size classes, which halve from the largest radius on.
#[derive(Clone, Debug, Default)]
struct Classes {
    /// Smallest radius of every class but the last [m].
    limits: Vec<f64>,
}

impl Classes {
    #[inline(always)]
    fn of(&self, radius: f64) -> usize {
        self.limits.iter().take_while(|&&limit| radius < limit).count()
    }
}

/// Grains by size class and cell.
#[derive(Debug, Default)]
pub(super) struct Cells {
    frame: Frame,
    classes: Classes,
    pub(super) grids: Vec<Grid>,
    /// Which other classes the grains of a class search.
    asks: Vec<Vec<usize>>,
    skin: f64,
    cell: Vec<u32>,
    start: Vec<u32>,
    x: Vec<f32>,
    y: Vec<f32>,
    z: Vec<f32>,
    radius: Vec<f32>,
    member: Vec<u32>,
}

impl Cells {
    /// Sorts the grains anew, for a search of all pairs closer than `skin` to touching.
    pub(super) fn sort(&mut self, grains: &Grains, domain: &Domain, skin: f64) {
        self.skin = skin;
        self.frame = Frame::around(grains, domain);
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
        self.cell.resize(n, 0);
        let (frame, classes, grids) = (&self.frame, &self.classes, &self.grids);
        (self.cell.par_chunks_mut(GRAINS_PER_TASK))
            .zip(grains.position.rows().par_chunks(GRAINS_PER_TASK))
            .for_each(|(cells, rows)| {
                for (cell, row) in cells.iter_mut().zip(rows) {
                    let grid = &grids[classes.of(row.scalar)];
                    let [x, y, z] = grid.coordinates(frame.local(row.vector));
                    *cell = (grid.row(x, y) as i32 + z) as u32;
                }
            });
        self.start.clear();
        self.start.resize(cells + 1, 0);
        let cell = &self.cell;
        for_ranges(0, &mut self.start[1..], n, &|first, counts: &mut [u32]| {
            for &c in cell {
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
        let cell = &self.cell;
        super::ranges::scatter(0, &mut self.start[1..], 0, member, &|first, starts, base, members| {
            for (grain, &c) in cell.iter().enumerate() {
                if let Some(next) = starts.get_mut((c as usize).wrapping_sub(first)) {
                    members[*next as usize - base] = grain as u32;
                    *next += 1;
                }
            }
        });
        let frame = &self.frame;
        let n = GRAINS_PER_TASK;
        (
            self.x[..grains.len()].par_chunks_mut(n),
            self.y[..grains.len()].par_chunks_mut(n),
            self.z[..grains.len()].par_chunks_mut(n),
            self.radius[..grains.len()].par_chunks_mut(n),
            self.member[..grains.len()].par_chunks(n),
        )
            .into_par_iter()
            .for_each(|(x, y, z, radius, members)| {
                for (k, &member) in members.iter().enumerate() {
                    let row = &grains.position.rows()[member as usize];
                    let p = frame.local(row.vector);
                    (x[k], y[k], z[k], radius[k]) = (p.x as f32, p.y as f32, p.z as f32, row.scalar as f32);
                }
            });
        for column in [&mut self.x, &mut self.y, &mut self.z] {
            column[grains.len()..].fill(f32::INFINITY);
        }
    }

    /// Whether a search has to look across periodic sides.
    pub(super) fn is_periodic(&self) -> bool {
        self.frame.periodic != [false; 3]
    }

    /// Calls `f` with every grain that may be close to one and is not looked for from the other side. Tells the number of
    /// distance tests.
    #[inline(always)]
    pub(super) fn visit<const PERIODIC: bool>(
        &self,
        grain: u32,
        position: DVec3,
        radius: f64,
        f: &mut impl FnMut(u32),
    ) -> u64 {
        let local = self.frame.local(position);
        let period = |axis: usize| {
            if self.frame.periodic[axis] {
                self.frame.size[axis] as f32
            } else {
                f32::INFINITY
            }
        };
        let probe = Probe {
            at: local.to_array().map(|x| x as f32),
            reach: ((radius + self.skin) * FILTER + self.frame.slack) as f32,
            period: [0, 1, 2].map(period),
        };
        let class = self.classes.of(radius);
        let mut tests = self.visit_own::<PERIODIC>(grain, &self.grids[class], local, &probe, f);
        for &other in &self.asks[class] {
            let grid = &self.grids[other];
            let reach = radius + grid.largest + self.skin;
            tests += self.visit_other::<PERIODIC>(grid, local, reach, &probe, f);
        }
        tests
    }

    /// Grains of the own class: later ones in the own cell, and half of the cells around.
    #[inline(always)]
    fn visit_own<const PERIODIC: bool>(
        &self,
        grain: u32,
        grid: &Grid,
        local: DVec3,
        probe: &Probe,
        f: &mut impl FnMut(u32),
    ) -> u64 {
        let [x, y, z] = grid.coordinates(local);
        let mut runs = Runs::default();
        let depth = grid.cells[2];
        let is_ring = self.frame.periodic[2] && depth > 1;
        // the own row: later grains of the own cell, and the cell behind
        let own = grid.row(x, y) + z as usize;
        let (own_start, own_end) = (self.start[own], self.start[own + 1]);
        let members = &self.member[own_start as usize..own_end as usize];
        let place = members.iter().position(|&m| m == grain).unwrap_or(members.len());
        let behind = if z + 1 < depth { self.start[own + 2] } else { own_end };
        runs.push(own_start + place as u32 + 1, behind);
        if is_ring && z + 1 == depth {
            runs.push(
                self.start[own + 1 - depth as usize],
                self.start[own + 2 - depth as usize],
            );
        }
        // rows beside, three cells of each
        let (low, high) = ((z - 1).max(0) as usize, (z + 1).min(depth - 1) as usize + 1);
        let mut row = |x: i32, y: i32| {
            let row = grid.row(x, y);
            runs.push(self.start[row + low], self.start[row + high]);
            if is_ring && z == 0 {
                runs.push(self.start[row + depth as usize - 1], self.start[row + depth as usize]);
            } else if is_ring && z + 1 == depth {
                runs.push(self.start[row], self.start[row + 1]);
            }
        };
        let ahead = self.beside(grid, 1, y + 1);
        if let Some(y) = ahead {
            row(x, y);
        }
        if let Some(x) = self.beside(grid, 0, x + 1) {
            row(x, y);
            if let Some(y) = self.beside(grid, 1, y - 1) {
                row(x, y);
            }
            if let Some(y) = ahead {
                row(x, y);
            }
        }
        let mut tests = 0;
        for &(from, to) in &runs.list[..runs.count] {
            tests += u64::from(to - from);
            self.near::<PERIODIC>(from, to, probe, f);
        }
        tests
    }

    /// The cell beside another, if there is one.
    #[inline(always)]
    fn beside(&self, grid: &Grid, axis: usize, to: i32) -> Option<i32> {
        let cells = grid.cells[axis];
        if (0..cells).contains(&to) {
            Some(to)
        } else if self.frame.periodic[axis] && cells > 1 {
            Some(if to < 0 { to + cells } else { to - cells })
        } else {
            None
        }
    }

    /// All grains of another class within a reach.
    #[inline(always)]
    fn visit_other<const PERIODIC: bool>(
        &self,
        grid: &Grid,
        local: DVec3,
        reach: f64,
        probe: &Probe,
        f: &mut impl FnMut(u32),
    ) -> u64 {
        let reach = reach + self.frame.slack;
        let mut tests = 0;
        let xs = self.span(grid, 0, local.x, reach);
        let ys = self.span(grid, 1, local.y, reach);
        for x in xs.cells() {
            let dx = xs.distance(x, local.x, grid.edge.x);
            for y in ys.cells() {
                let dy = ys.distance(y, local.y, grid.edge.y);
                let left = reach * reach - dx * dx - dy * dy;
                if left < 0.0 {
                    continue;
                }
                let zs = self.span(grid, 2, local.z, left.sqrt());
                let row = grid.row(xs.wrap(x), ys.wrap(y));
                let mut run = |from: i32, to: i32| {
                    let (from, to) = (self.start[row + from as usize], self.start[row + to as usize]);
                    tests += u64::from(to - from);
                    self.near::<PERIODIC>(from, to, probe, &mut *f);
                };
                let (from, to) = (zs.first, zs.first + zs.count);
                if from < 0 {
                    run(from + zs.period, zs.period);
                    run(0, to);
                } else if to > grid.cells[2] {
                    run(from, zs.period);
                    run(0, to - zs.period);
                } else {
                    run(from, to);
                }
            }
        }
        tests
    }

    /// Cells along one axis that a reach touches, each once.
    #[inline(always)]
    fn span(&self, grid: &Grid, axis: usize, at: f64, reach: f64) -> Span {
        let cells = grid.cells[axis];
        let last = cells - 1;
        let low = ((at - reach) * grid.per_edge[axis]).floor() as i32;
        let high = ((at + reach) * grid.per_edge[axis]).floor() as i32;
        if !self.frame.periodic[axis] {
            let (low, high) = (low.clamp(0, last), high.clamp(0, last));
            return Span {
                first: low,
                count: high - low + 1,
                period: cells,
                is_whole: false,
            };
        }
        let count = high.saturating_sub(low).saturating_add(1);
        if count >= cells {
            return Span {
                first: 0,
                count: cells,
                period: cells,
                is_whole: true,
            };
        }
        Span {
            first: low,
            count,
            period: cells,
            is_whole: false,
        }
    }

    /// Calls `f` with the grains at `from..to` in the order of the cells that pass the filter.
    #[inline(always)]
    fn near<const PERIODIC: bool>(&self, from: u32, to: u32, probe: &Probe, f: &mut impl FnMut(u32)) {
        let to = to as usize;
        let mut k = from as usize;
        while k < to {
            let mut mask = self.filter::<PERIODIC>(k, probe);
            let left = to - k;
            if left < LANES {
                mask &= (1 << left) - 1;
            }
            while mask != 0 {
                f(self.member[k + mask.trailing_zeros() as usize]);
                mask &= mask - 1;
            }
            k += LANES;
        }
    }

    /// Which of the grains `k..k + LANES` in the order of the cells are near enough.
    #[inline(always)]
    fn filter<const PERIODIC: bool>(&self, k: usize, probe: &Probe) -> u32 {
        let columns = (
            self.x[k..].first_chunk::<LANES>(),
            self.y[k..].first_chunk::<LANES>(),
            self.z[k..].first_chunk::<LANES>(),
            self.radius[k..].first_chunk::<LANES>(),
        );
        let (Some(x), Some(y), Some(z), Some(radius)) = columns else {
            return 0;
        };
        let along = |axis: usize, x: f32| {
            let d = (probe.at[axis] - x).abs();
            if !PERIODIC {
                return d;
            }
            let other = probe.period[axis] - d;
            if other < d { other } else { d }
        };
        let mut near = [0u32; LANES];
        for l in 0..LANES {
            let (dx, dy, dz) = (along(0, x[l]), along(1, y[l]), along(2, z[l]));
            let reach = probe.reach + radius[l];
            near[l] = u32::from(dx * dx + dy * dy + dz * dz < reach * reach) << l;
        }
        near.iter().fold(0, |all, one| all | one)
    }

    /// Bytes in use.
    pub(super) fn bytes(&self) -> usize {
        4 * (self.cell.capacity() + self.start.capacity() + self.member.capacity() + 4 * self.x.capacity())
    }
}

/// Cells along one axis; beyond the ends of a periodic one they go on on the other side.
struct Span {
    first: i32,
    count: i32,
    period: i32,
    /// Whether it holds all cells of a ring.
    is_whole: bool,
}

impl Span {
    #[inline(always)]
    fn cells(&self) -> std::ops::Range<i32> {
        self.first..self.first + self.count
    }

    #[inline(always)]
    fn wrap(&self, cell: i32) -> i32 {
        cell.rem_euclid(self.period)
    }

    /// Distance of a place from a cell [m]: never too large.
    #[inline(always)]
    fn distance(&self, cell: i32, at: f64, edge: f64) -> f64 {
        if self.is_whole {
            return 0.0;
        }
        let below = f64::from(cell) * edge - at;
        let above = at - f64::from(cell + 1) * edge;
        (below.max(above) * (1.0 - 1e-9)).max(0.0)
    }
}
