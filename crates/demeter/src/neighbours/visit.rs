//! Looking around a grain: runs of grains in the order of the cells, and distance tests on them, a few at a time.

use super::cells::{Cells, Grid, LANES};
use glam::DVec3;
use std::sync::atomic::Ordering;

/// What rounding of the arithmetic of the filter may take from a reach.
const FILTER: f64 = 1.0 + 4e-6;

/// A place whose surroundings are searched.
#[derive(Clone, Copy)]
struct Probe {
    at: [f32; 3],
    /// Reach without the radius of the other grain [m].
    reach: f32,
    /// Periods; infinite where there is none.
    period: [f32; 3],
}

impl Probe {
    /// Which of the first `left` grains of columns are near enough: 1 for those, 0 for others.
    #[inline(always)]
    fn filter<const PERIODIC: bool>(&self, [x, y, z, radius]: [&[f32; LANES]; 4], left: i32) -> [u32; LANES] {
        let along = |axis: usize, x: f32| {
            let d = (self.at[axis] - x).abs();
            if !PERIODIC {
                return d;
            }
            let other = self.period[axis] - d;
            if other < d { other } else { d }
        };
        let mut is_near = [0u32; LANES];
        for l in 0..LANES {
            let (dx, dy, dz) = (along(0, x[l]), along(1, y[l]), along(2, z[l]));
            let reach = self.reach + radius[l];
            let passes = dx * dx + dy * dy + dz * dz < reach * reach;
            is_near[l] = u32::from(passes) & u32::from((l as i32) < left);
        }
        is_near
    }
}

/// Grains that passed the filter.
#[derive(Debug, Default)]
pub(super) struct Near {
    list: Vec<u32>,
    count: usize,
}

impl Near {
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        self.count = 0;
    }

    #[inline(always)]
    pub(super) fn grains(&self) -> &[u32] {
        &self.list[..self.count]
    }
}

/// Runs of grains in the order of the cells.
#[derive(Default)]
struct Runs {
    list: [(u32, u32); 12],
    count: usize,
}

impl Runs {
    #[inline(always)]
    fn push(&mut self, from: u32, to: u32) {
        // whether a run is empty cannot be foreseen
        self.list[self.count] = (from, to);
        self.count += usize::from(from < to);
    }
}

impl Cells {
    /// Whether a search has to look across periodic sides.
    pub(super) fn is_periodic(&self) -> bool {
        self.frame.periodic != [false; 3]
    }

    /// Adds every grain that may be close to one and is not looked for from the other side. Tells the number of distance
    /// tests.
    pub(super) fn visit(&self, grain: u32, position: DVec3, radius: f64, near: &mut Near) -> u64 {
        let local = self.frame.local(position);
        let probe = self.probe(local, radius);
        let class = self.classes.of(radius);
        let own = &self.grids[class];
        let mut runs = Runs::default();
        let is_inside = self.runs_of_own(grain, own, local, &mut runs);
        let mut tests = if is_inside || !self.is_periodic() {
            self.near::<false>(&runs.list[..runs.count], &probe, near)
        } else {
            self.near::<true>(&runs.list[..runs.count], &probe, near)
        };
        for &other in &self.asks[class] {
            let grid = &self.grids[other];
            let reach = radius + grid.largest + self.skin + self.frame.slack;
            tests += if self.is_inside(local, radius + grid.largest) {
                self.visit_other::<false>(grid, local, reach, &probe, near)
            } else {
                self.visit_other::<true>(grid, local, reach, &probe, near)
            };
        }
        tests
    }

    /// Adds every grain that may be close to the image of one that slides along the opposite side of the box: `to_image`
    /// leads from the grain to its image below the lower side of a direction. Pairs across that side are found from above.
    /// Tells the number of distance tests.
    pub(super) fn visit_below(&self, position: DVec3, radius: f64, to_image: (usize, DVec3), near: &mut Near) -> u64 {
        let (gradient, to_image) = to_image;
        let place = self.frame.local(position) + to_image;
        let mut tests = 0;
        for grid in self.grids.iter().filter(|grid| grid.members > 0) {
            let reach = radius + grid.largest + self.skin + self.frame.slack;
            if place[gradient] + reach > 0.0 {
                let local = self.frame.put_back(place);
                let probe = self.probe(local, radius);
                tests += self.visit_other::<true>(grid, local, reach, &probe, near);
            }
        }
        tests
    }

    #[inline(always)]
    fn probe(&self, local: DVec3, radius: f64) -> Probe {
        let period = |axis: usize| {
            if self.frame.periodic[axis] {
                self.frame.size[axis] as f32
            } else {
                f32::INFINITY
            }
        };
        Probe {
            at: local.to_array().map(|x| x as f32),
            reach: ((radius + self.skin) * FILTER + self.frame.slack) as f32,
            period: [0, 1, 2].map(period),
        }
    }

    /// Whether a search does not reach across a periodic side.
    #[inline(always)]
    fn is_inside(&self, local: DVec3, touch: f64) -> bool {
        let reach = touch + self.skin + self.frame.slack;
        let frame = &self.frame;
        (0..3).all(|k| !frame.periodic[k] || (local[k] - reach > 0.0 && local[k] + reach < frame.size[k]))
    }

    /// Grains of the own class: later ones in the own cell, and half of the cells around. Tells whether none of these cells
    /// is at the border of the grid.
    #[inline(always)]
    fn runs_of_own(&self, grain: u32, grid: &Grid, local: DVec3, runs: &mut Runs) -> bool {
        let [x, y, z] = grid.coordinates(local);
        // the own row: later grains of the own cell, and the cell behind
        let own = self.rows.start(grid, x, y) + z as usize;
        let place = self.place[grain as usize].load(Ordering::Relaxed);
        runs.push(place + 1, self.start[own + 1 + usize::from(z + 1 < grid.cells[2])]);
        let inner = |axis: usize, at: i32| at > 0 && at + 1 < grid.cells[axis];
        if inner(0, x) && inner(1, y) && inner(2, z) {
            // rows beside, three cells of each
            let beside = if self.rows.are_all() {
                let row = grid.stride() as usize;
                let sheet = grid.cells[1] as usize * row;
                [own + row, own + sheet - row, own + sheet, own + sheet + row]
            } else {
                [(x, y + 1), (x + 1, y - 1), (x + 1, y), (x + 1, y + 1)]
                    .map(|(x, y)| self.rows.start(grid, x, y) + z as usize)
            };
            for to in beside {
                runs.push(self.start[to - 1], self.start[to + 2]);
            }
            return true;
        }
        self.runs_at_border(grid, [x, y, z], runs);
        false
    }

    /// Runs of the cells around one at the border: those beyond a periodic side are on the other.
    fn runs_at_border(&self, grid: &Grid, [x, y, z]: [i32; 3], runs: &mut Runs) {
        let depth = grid.cells[2];
        let is_ring = self.frame.periodic[2] && depth > 1;
        let mut cells = |row: usize, from: i32, to: i32| {
            runs.push(self.start[row + from as usize], self.start[row + to as usize]);
        };
        if is_ring && z + 1 == depth {
            cells(self.rows.start(grid, x, y), 0, 1);
        }
        let (low, high) = ((z - 1).max(0), (z + 1).min(depth - 1) + 1);
        let mut row = |x: i32, y: i32| {
            let row = self.rows.start(grid, x, y);
            cells(row, low, high);
            if is_ring && z == 0 {
                cells(row, depth - 1, depth);
            } else if is_ring && z + 1 == depth {
                cells(row, 0, 1);
            }
        };
        let ahead = self.beside(grid, 1, y + 1);
        if let Some(y) = ahead {
            row(x, y);
        }
        if let Some(x) = self.beside(grid, 0, x + 1) {
            row(x, y);
            for y in self.beside(grid, 1, y - 1).into_iter().chain(ahead) {
                row(x, y);
            }
        }
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
    fn visit_other<const PERIODIC: bool>(
        &self,
        grid: &Grid,
        local: DVec3,
        reach: f64,
        probe: &Probe,
        near: &mut Near,
    ) -> u64 {
        let mut tests = 0;
        let mut runs = Runs::default();
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
                let row = self.rows.start(grid, xs.wrap(x), ys.wrap(y));
                let mut run = |from: i32, to: i32| {
                    runs.push(self.start[row + from as usize], self.start[row + to as usize]);
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
                if runs.count + 2 > runs.list.len() {
                    tests += self.near::<PERIODIC>(&runs.list[..runs.count], probe, near);
                    runs.count = 0;
                }
            }
        }
        tests + self.near::<PERIODIC>(&runs.list[..runs.count], probe, near)
    }

    /// Cells along one axis that a reach touches, each once.
    #[inline(always)]
    fn span(&self, grid: &Grid, axis: usize, at: f64, reach: f64) -> Span {
        let cells = grid.cells[axis];
        let last = cells - 1;
        let low = floor((at - reach) * grid.per_edge[axis]);
        let high = floor((at + reach) * grid.per_edge[axis]);
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

    /// Adds the grains of runs in the order of the cells that pass the filter. Tells the number of distance tests.
    #[inline(always)]
    fn near<const PERIODIC: bool>(&self, runs: &[(u32, u32)], probe: &Probe, near: &mut Near) -> u64 {
        let tests: usize = runs.iter().map(|&(from, to)| (to - from) as usize).sum();
        let room = near.count + tests + LANES;
        if near.list.len() < room {
            near.list.resize(2 * room, 0);
        }
        let mut count = near.count;
        for &(from, to) in runs {
            // columns may be read beyond the end of a run; what is there does not count
            let length = (to - from) as usize;
            let padded = from as usize..from as usize + length.next_multiple_of(LANES);
            let columns = (self.x[padded.clone()].as_chunks().0.iter())
                .zip(self.y[padded.clone()].as_chunks().0)
                .zip(self.z[padded.clone()].as_chunks().0)
                .zip(self.radius[padded.clone()].as_chunks().0)
                .zip(self.member[padded].as_chunks::<LANES>().0);
            let mut left = length as i32;
            for ((((x, y), z), radius), member) in columns {
                let is_near = probe.filter::<PERIODIC>([x, y, z, radius], left);
                let Some(list) = near.list.get_mut(count..count + LANES) else {
                    break;
                };
                // what to keep is not decided by branches, which nothing could foresee: all are written, and the next of
                // them over those not near
                let mut kept = 0;
                for l in 0..LANES {
                    list[kept & (LANES - 1)] = member[l];
                    kept += is_near[l] as usize;
                }
                count += kept;
                left -= LANES as i32;
            }
        }
        near.count = count;
        tests as u64
    }
}

/// The next lower whole number, without the call that [`f64::floor`] is on old processors.
#[inline(always)]
fn floor(x: f64) -> i32 {
    let towards_zero = x as i32;
    towards_zero.saturating_sub(i32::from(f64::from(towards_zero) > x))
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
