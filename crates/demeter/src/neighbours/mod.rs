//! Candidate pairs: grains and walls close enough to touch before the next rebuild.

mod cell_grid;
mod order;
#[cfg(test)]
mod tests;

pub use order::space_filling_order;

use crate::comm::Single;
use crate::particles::Grains;
use crate::walls::{Pose, Wall};
use cell_grid::CellGrid;
use glam::DVec3;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Grains handled by one task of the search.
const GRAINS_PER_TASK: usize = 1024;

/// A candidate pair of grains; `i` has the lower id.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Pair {
    /// Index of the grain with the lower id.
    pub i: u32,
    /// Index of its partner.
    pub j: u32,
    /// Code of the periodic shift of `x_i - x_j`.
    pub shift: u8,
}

/// A candidate pair of grain and wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct WallPair {
    /// Index of the grain.
    pub grain: u32,
    /// Index of the wall.
    pub wall: u32,
}

/// Candidate pairs, and for every grain the pairs that it is in.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Neighbours {
    /// Pairs of grains, by the index of `i`, then by the id of `j`.
    pub pairs: Vec<Pair>,
    /// Pairs of grain and wall, by grain, then by wall.
    pub wall_pairs: Vec<WallPair>,
    pair_start: Vec<u32>,
    pair_entries: Vec<u32>,
    wall_start: Vec<u32>,
    /// Where the grains were when the pairs were found [m].
    pub reference: Vec<DVec3>,
    /// Where the walls were.
    pub wall_reference: Vec<Pose>,
}

impl Neighbours {
    /// Finds all pairs closer than `skin` to touching.
    pub fn find(grains: &Grains, walls: &[Wall], comm: &Single, skin: f64) -> Self {
        let mut pairs = grain_pairs(grains, comm, skin);
        pairs.par_sort_unstable_by_key(|p| (p.i, grains.id[p.j as usize]));
        let (pair_start, pair_entries) = incidence(&pairs, grains);
        let (wall_start, wall_pairs) = wall_pairs(grains, walls, skin);
        Self {
            pairs,
            wall_pairs,
            pair_start,
            pair_entries,
            wall_start,
            reference: grains.position.iter().copied().collect(),
            wall_reference: walls.iter().map(Wall::pose).collect(),
        }
    }

    /// Whether all indices fit a number of grains and walls, as they do unless a file was tampered with.
    pub fn fits(&self, grains: usize, walls: usize) -> bool {
        let rising = |start: &[u32], end: usize| {
            start.len() == grains + 1 && start.is_sorted() && start.last().is_some_and(|&l| l as usize == end)
        };
        self.reference.len() == grains
            && self.wall_reference.len() == walls
            && self
                .pairs
                .iter()
                .all(|p| (p.i as usize) < grains && (p.j as usize) < grains && p.shift < 27)
            && self
                .wall_pairs
                .iter()
                .all(|p| (p.grain as usize) < grains && (p.wall as usize) < walls)
            && self
                .pair_entries
                .iter()
                .all(|&e| ((e >> 1) as usize) < self.pairs.len())
            && rising(&self.pair_start, self.pair_entries.len())
            && rising(&self.wall_start, self.wall_pairs.len())
    }

    /// Pairs that a grain is in, in the order of the partner's id: index of the pair, and whether the grain is its `i`.
    #[inline]
    pub fn pairs_of(&self, grain: usize) -> impl Iterator<Item = (usize, bool)> + '_ {
        let range = self.pair_start[grain] as usize..self.pair_start[grain + 1] as usize;
        self.pair_entries[range]
            .iter()
            .map(|&e| ((e >> 1) as usize, e & 1 == 0))
    }

    /// Indices of the pairs of a grain with walls, in the order of the walls.
    #[inline]
    pub fn wall_pairs_of(&self, grain: usize) -> std::ops::Range<usize> {
        self.wall_start[grain] as usize..self.wall_start[grain + 1] as usize
    }
}

fn grain_pairs(grains: &Grains, comm: &Single, skin: f64) -> Vec<Pair> {
    let classes = size_classes(grains);
    let largest = |members: &[u32]| members.iter().map(|&g| grains.radius(g as usize)).fold(0.0, f64::max);
    let grids: Vec<CellGrid> = (classes.members.iter())
        .map(|members| {
            let radius = largest(members);
            CellGrid::new(members, &grains.position, radius, 2.0 * radius + skin, comm.domain())
        })
        .collect();
    let tasks: Vec<Vec<Pair>> = (0..grains.len().div_ceil(GRAINS_PER_TASK))
        .into_par_iter()
        .map(|task| {
            let mut found = Vec::new();
            let last = ((task + 1) * GRAINS_PER_TASK).min(grains.len());
            for g in task * GRAINS_PER_TASK..last {
                pairs_of_grain(g as u32, grains, &grids, classes.class[g], comm, skin, &mut found);
            }
            found
        })
        .collect();
    tasks.concat()
}

/// Pairs of one grain with grains of its own class that come later, and with all of larger classes.
fn pairs_of_grain(
    g: u32,
    grains: &Grains,
    grids: &[CellGrid],
    class: u8,
    comm: &Single,
    skin: f64,
    found: &mut Vec<Pair>,
) {
    let (x, r) = (grains.position[g as usize], grains.radius(g as usize));
    for (other_class, grid) in grids.iter().enumerate().take(class as usize + 1) {
        let own = other_class == class as usize;
        grid.visit(x, r + grid.max_radius + skin, |h| {
            if own && h <= g {
                return;
            }
            let difference = x - grains.position[h as usize];
            let shift = comm.nearest_image(difference);
            let reach = r + grains.radius(h as usize) + skin;
            if (difference + comm.shift(shift)).length_squared() < reach * reach {
                found.push(if grains.id[g as usize] < grains.id[h as usize] {
                    Pair { i: g, j: h, shift }
                } else {
                    Pair {
                        i: h,
                        j: g,
                        shift: Single::opposite(shift),
                    }
                });
            }
        });
    }
}

struct SizeClasses {
    class: Vec<u8>,
    members: Vec<Vec<u32>>,
}

/// Classes by halving of the largest radius; class 0 holds the largest grains. Without empty classes at the end.
fn size_classes(grains: &Grains) -> SizeClasses {
    const MOST: u8 = 20;
    let largest = grains.radii().fold(0.0, f64::max);
    let class: Vec<u8> = grains
        .radii()
        .map(|r| {
            let (mut class, mut limit) = (0, 0.5 * largest);
            while r < limit && class < MOST {
                class += 1;
                limit *= 0.5;
            }
            class
        })
        .collect();
    let count = class.iter().copied().max().map_or(0, |c| c as usize + 1);
    let mut members = vec![Vec::new(); count];
    for (g, &c) in class.iter().enumerate() {
        members[c as usize].push(g as u32);
    }
    SizeClasses { class, members }
}

fn incidence(pairs: &[Pair], grains: &Grains) -> (Vec<u32>, Vec<u32>) {
    let mut start = vec![0u32; grains.len() + 1];
    for p in pairs {
        start[p.i as usize + 1] += 1;
        start[p.j as usize + 1] += 1;
    }
    for g in 0..grains.len() {
        start[g + 1] += start[g];
    }
    let mut entries = vec![0u32; 2 * pairs.len()];
    let mut next = start.clone();
    for (k, p) in pairs.iter().enumerate() {
        for (grain, side) in [(p.i, 0), (p.j, 1)] {
            entries[next[grain as usize] as usize] = 2 * k as u32 + side;
            next[grain as usize] += 1;
        }
    }
    let partner = |e: u32| {
        let p = &pairs[(e >> 1) as usize];
        grains.id[if e & 1 == 0 { p.j } else { p.i } as usize]
    };
    for g in 0..grains.len() {
        entries[start[g] as usize..start[g + 1] as usize].sort_unstable_by_key(|&e| partner(e));
    }
    (start, entries)
}

fn wall_pairs(grains: &Grains, walls: &[Wall], skin: f64) -> (Vec<u32>, Vec<WallPair>) {
    let near: Vec<Vec<u32>> = (0..grains.len())
        .into_par_iter()
        .with_min_len(GRAINS_PER_TASK)
        .map(|g| {
            let reach = grains.radius(g) + skin;
            (0..walls.len() as u32)
                .filter(|&w| walls[w as usize].near(grains.position[g], reach))
                .collect()
        })
        .collect();
    let mut start = vec![0u32];
    let mut pairs = Vec::new();
    for (g, walls) in near.iter().enumerate() {
        pairs.extend(walls.iter().map(|&wall| WallPair { grain: g as u32, wall }));
        start.push(pairs.len() as u32);
    }
    (start, pairs)
}
