//! What is spread over a grid, and how: some layers of cells are one task, which takes all that reaches it in a fixed order.

use super::kernel::KernelIn;
use crate::measure::images::Periods;
use glam::DVec3;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Most tasks.
const MOST_BLOCKS: usize = 64;
/// A branch shorter than this share of the reach of the kernel, seen along the averaged directions, is a point.
const POINT: f64 = 1e-12;

/// Numbers that are kept of every cell: number, mass, solid volume and contacts of grains, momentum, momentum flux
/// (xx, yy, zz, xy, xz, yz), contact stress (row by row) and force density of what is not counted.
pub const SUMS: usize = 25;
pub(super) const NUMBER: usize = 0;
pub(super) const MASS: usize = 1;
pub(super) const SOLID: usize = 2;
pub(super) const CONTACTS: usize = 3;
pub(super) const MOMENTUM: usize = 4;
pub(super) const FLUX: usize = 7;
pub(super) const STRESS: usize = 13;
pub(super) const TRACTION: usize = 22;

/// What is spread from a point.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) enum Load {
    /// A grain.
    Grain {
        mass: f64,
        solid: f64,
        contacts: f64,
        velocity: DVec3,
    },
    /// A force from what is not counted [N].
    Force(DVec3),
}

/// A grain, or the end of a force from what is not counted.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Point {
    pub place: DVec3,
    pub load: Load,
}

impl Load {
    /// What it adds to the sums, with the velocity of the image added; and the first of these sums.
    fn adds(&self, image: DVec3) -> (usize, [f64; STRESS]) {
        let mut adds = [0.0; STRESS];
        match *self {
            Self::Grain {
                mass,
                solid,
                contacts,
                velocity,
            } => {
                let v = velocity + image;
                let flux = [v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.x * v.z, v.y * v.z];
                adds[..MOMENTUM].copy_from_slice(&[1.0, mass, solid, contacts]);
                adds[MOMENTUM..FLUX].copy_from_slice(&(v * mass).to_array());
                adds[FLUX..].copy_from_slice(&flux.map(|vv| mass * vv));
                (NUMBER, adds)
            }
            Self::Force(force) => {
                adds[..3].copy_from_slice(&force.to_array());
                (TRACTION, adds)
            }
        }
    }
}

/// A force along a branch.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Branch {
    /// Where it begins [m].
    pub from: DVec3,
    /// The branch vector [m].
    pub branch: DVec3,
    /// The force on the grain at its end [N].
    pub force: DVec3,
}

/// What a state spreads.
#[derive(Clone, Debug, Default)]
pub(super) struct Spread {
    pub periods: Periods,
    pub points: Vec<Point>,
    pub branches: Vec<Branch>,
}

/// A grid of cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Grid {
    pub lower: DVec3,
    pub upper: DVec3,
    pub cells: [usize; 3],
}

/// Cells that one task takes: layers that follow each other.
#[derive(Clone, Copy)]
struct Block {
    axis: usize,
    layers: [usize; 2],
    /// Index of the first cell.
    first: usize,
}

/// A piece of what is spread, at one of its periodic images.
#[derive(Clone, Copy)]
struct Piece {
    index: u32,
    shift: DVec3,
    velocity: DVec3,
    /// Share of a branch between these ends lies in the averaged directions.
    ends: [f64; 2],
}

impl Grid {
    pub fn len(&self) -> usize {
        self.cells.iter().product()
    }

    pub fn cell_size(&self) -> DVec3 {
        let count = DVec3::from_array(self.cells.map(|n| n as f64));
        (self.upper - self.lower) / count
    }

    /// Directions with more than one cell; over the others the fields are means.
    pub fn fine(&self) -> [bool; 3] {
        self.cells.map(|n| n > 1)
    }

    pub fn dimensions(&self) -> usize {
        self.fine().into_iter().filter(|fine| *fine).count()
    }

    /// Length, area or volume of the averaged directions.
    fn averaged_size(&self) -> f64 {
        let size = self.upper - self.lower;
        let fine = self.fine();
        (0..3).filter(|&k| !fine[k]).map(|k| size[k]).product()
    }

    /// The axis across the layers that tasks take: the last with more than one cell.
    fn layer_axis(&self) -> usize {
        (0..3).rev().find(|&k| self.cells[k] > 1).unwrap_or(0)
    }

    /// Cells whose centres lie between two coordinates; empty when the first is behind the second.
    fn range(&self, axis: usize, from: f64, to: f64) -> (usize, usize) {
        if self.cells[axis] == 1 {
            return (0, 1);
        }
        let step = self.cell_size()[axis];
        let place = |x: f64| (x - self.lower[axis]) / step - 0.5;
        let first = place(from).ceil().max(0.0) as usize;
        let last = (place(to).floor() + 1.0).max(0.0) as usize;
        (first, last.min(self.cells[axis]))
    }

    /// Adds all that is spread to the sums, the same bits on any number of threads.
    pub fn spread(&self, spread: &Spread, kernel: &KernelIn, sums: &mut [[f64; SUMS]]) {
        let axis = self.layer_axis();
        let layers = self.cells[axis];
        let stride = self.len() / layers;
        let points: Vec<(Piece, [usize; 2])> = (spread.points.iter().enumerate())
            .flat_map(|(k, point)| self.pieces(k, (point.place, DVec3::ZERO), kernel, &spread.periods))
            .collect();
        let branches: Vec<(Piece, [usize; 2])> = (spread.branches.iter().enumerate())
            .flat_map(|(k, b)| self.pieces(k, (b.from, b.branch), kernel, &spread.periods))
            .collect();
        let thick = layers.div_ceil(MOST_BLOCKS);
        let (of_points, of_branches) = (by_block(&points, layers, thick), by_block(&branches, layers, thick));
        let share = 1.0 / self.averaged_size();
        sums.par_chunks_mut(stride * thick)
            .enumerate()
            .for_each(|(block, cells)| {
                let layers = [block * thick, ((block + 1) * thick).min(layers)];
                let block_of_cells = Block {
                    axis,
                    layers,
                    first: block * thick * stride,
                };
                for &k in &of_points[block] {
                    self.add_point(spread, &points[k as usize].0, (kernel, share), block_of_cells, cells);
                }
                for &k in &of_branches[block] {
                    self.add_branch(spread, &branches[k as usize].0, (kernel, share), block_of_cells, cells);
                }
            });
    }

    /// The images of a branch (a point has no length) that reach cells, with the range of layers that they reach.
    fn pieces(
        &self,
        index: usize,
        (from, branch): (DVec3, DVec3),
        kernel: &KernelIn,
        periods: &Periods,
    ) -> Vec<(Piece, [usize; 2])> {
        let (low, high) = (from.min(from + branch), from.max(from + branch));
        let axis = self.layer_axis();
        let mut pieces = Vec::new();
        for (shift, velocity) in self.images(low, high, kernel.reach(), periods) {
            let Some(ends) = self.clipped(from + shift, branch) else {
                continue;
            };
            let reach = kernel.reach();
            let (first, end) = self.range(axis, low[axis] + shift[axis] - reach, high[axis] + shift[axis] + reach);
            if first < end {
                let piece = Piece {
                    index: index as u32,
                    shift,
                    velocity,
                    ends,
                };
                pieces.push((piece, [first, end]));
            }
        }
        pieces
    }

    /// Shifts to the images of a box that come within reach of the grid, and their velocities.
    fn images(&self, low: DVec3, high: DVec3, reach: f64, periods: &Periods) -> Vec<(DVec3, DVec3)> {
        let reach = DVec3::from_array(self.fine().map(|fine| if fine { reach } else { 0.0 }));
        let mut images = Vec::new();
        let within = (self.lower - reach, self.upper + reach);
        periods.each_image((low, high), within, &mut |shift, velocity| {
            images.push((shift, velocity))
        });
        images
    }

    /// The part of a branch inside of the box in the averaged directions, as shares of it; for a point all or nothing. The
    /// lower side belongs to the box and the upper does not, so that boxes side by side share nothing.
    fn clipped(&self, from: DVec3, branch: DVec3) -> Option<[f64; 2]> {
        let (mut start, mut end) = (0.0f64, 1.0f64);
        let fine = self.fine();
        for axis in (0..3).filter(|&k| !fine[k]) {
            let (x, way) = (from[axis], branch[axis]);
            let (lower, upper) = (self.lower[axis], self.upper[axis]);
            if way == 0.0 {
                if x < lower || x >= upper {
                    return None;
                }
            } else {
                let (a, b) = ((lower - x) / way, (upper - x) / way);
                start = start.max(a.min(b));
                end = end.min(a.max(b));
            }
        }
        (start < end).then_some([start, end])
    }

    /// Calls back with the cells of a block whose centres lie in a box, and the centres.
    fn each_cell(&self, low: DVec3, high: DVec3, block: Block, mut visit: impl FnMut(usize, DVec3)) {
        let step = self.cell_size();
        let mut ranges = [0, 1, 2].map(|axis| self.range(axis, low[axis], high[axis]));
        let across = &mut ranges[block.axis];
        *across = (across.0.max(block.layers[0]), across.1.min(block.layers[1]));
        for k in ranges[2].0..ranges[2].1 {
            for j in ranges[1].0..ranges[1].1 {
                for i in ranges[0].0..ranges[0].1 {
                    let centre = self.lower + step * DVec3::new(i as f64 + 0.5, j as f64 + 0.5, k as f64 + 0.5);
                    visit((k * self.cells[1] + j) * self.cells[0] + i - block.first, centre);
                }
            }
        }
    }

    /// A vector without its components along averaged directions.
    fn across(&self, v: DVec3) -> DVec3 {
        let fine = self.fine();
        DVec3::from_array([0, 1, 2].map(|k| if fine[k] { v[k] } else { 0.0 }))
    }

    fn add_point(
        &self,
        spread: &Spread,
        piece: &Piece,
        (kernel, share): (&KernelIn, f64),
        block: Block,
        cells: &mut [[f64; SUMS]],
    ) {
        let Point { place, load } = spread.points[piece.index as usize];
        let place = place + piece.shift;
        let (first, adds) = load.adds(piece.velocity);
        let reach = DVec3::splat(kernel.reach());
        self.each_cell(place - reach, place + reach, block, |at, centre| {
            let weight = kernel.at(self.across(centre - place).length_squared()) * share;
            if weight > 0.0 {
                for (sum, add) in cells[at][first..].iter_mut().zip(&adds) {
                    *sum += add * weight;
                }
            }
        });
    }

    fn add_branch(
        &self,
        spread: &Spread,
        piece: &Piece,
        (kernel, share): (&KernelIn, f64),
        block: Block,
        cells: &mut [[f64; SUMS]],
    ) {
        let Branch { from, branch, force } = spread.branches[piece.index as usize];
        let from = from + piece.shift;
        let [start, end] = piece.ends;
        let seen = self.across(branch);
        let length = seen.length();
        let is_point = length <= POINT * kernel.reach();
        let along = if is_point { DVec3::ZERO } else { seen / length };
        let reach = DVec3::splat(kernel.reach());
        let (low, high) = (from.min(from + branch) - reach, from.max(from + branch) + reach);
        self.each_cell(low, high, block, |at, centre| {
            let away = self.across(centre - from);
            let foot = away.dot(along);
            let weight = if is_point {
                (end - start) * kernel.at(away.length_squared())
            } else {
                let off2 = (away - along * foot).length_squared();
                kernel.along(off2, start * length - foot, end * length - foot) / length
            };
            if weight != 0.0 {
                let weight = weight * share;
                for (row, f) in force.to_array().into_iter().enumerate() {
                    for (column, l) in branch.to_array().into_iter().enumerate() {
                        cells[at][STRESS + 3 * row + column] += f * l * weight;
                    }
                }
            }
        });
    }
}

/// Indices of the pieces that reach each block of layers, rising.
fn by_block(pieces: &[(Piece, [usize; 2])], layers: usize, thick: usize) -> Vec<Vec<u32>> {
    let mut lists = vec![Vec::new(); layers.div_ceil(thick)];
    for (k, (_, [first, end])) in pieces.iter().enumerate() {
        for list in &mut lists[first / thick..end.div_ceil(thick)] {
            list.push(k as u32);
        }
    }
    lists
}
