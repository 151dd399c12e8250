//! Candidate pairs: grains and walls close enough to touch before the next rebuild.
//!
//! A rebuild works in the memory of the one before and in parallel, and gives the same on any number of threads:
//!
//! 1. `cells`: grains are sorted into a grid per size class, and their places copied in that order;
//! 2. `search`, `visit`: every grain looks at half of the cells around it, and into the grids of other classes;
//! 3. `table`: what a task finds is put into the order of the laws and cut into chunks of one law;
//! 4. `incidence`: every grain learns its candidates, in the order of the partner's id.

mod cells;
mod incidence;
mod order;
mod ranges;
mod search;
mod table;
#[cfg(test)]
mod tests;
mod visit;

pub use order::{GONE, SpatialOrder};
pub use search::SearchEffort;
pub use table::CHUNK;

use crate::comm::Single;
use crate::materials::Materials;
use crate::particles::{Grains, Rows};
use crate::walls::{Pose, Wall};
use incidence::Incidence;
use rayon::prelude::*;
use search::Search;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use table::Table;

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

impl Pair {
    /// The other grain of the pair.
    #[inline(always)]
    pub fn other(&self, grain: u32) -> u32 {
        self.i ^ self.j ^ grain
    }
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
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct Neighbours {
    pairs: Table<Pair>,
    walls: Table<WallPair>,
    #[serde(skip)]
    incidence: Incidence,
    #[serde(skip)]
    wall_incidence: Incidence,
    /// First and last chunk of the pairs of every grain.
    #[serde(skip)]
    spans: Vec<[u32; 2]>,
    #[serde(skip)]
    search: Search,
    effort: SearchEffort,
    /// Where the grains were when the pairs were found [m].
    pub reference: Rows,
    /// Where the walls were.
    pub wall_reference: Vec<Pose>,
}

impl Clone for Neighbours {
    /// A copy holds what a checkpoint holds; [`Neighbours::restore`] finds the rest.
    fn clone(&self) -> Self {
        Self {
            pairs: self.pairs.saved(),
            walls: self.walls.saved(),
            effort: self.effort,
            reference: self.reference.clone(),
            wall_reference: self.wall_reference.clone(),
            ..Self::default()
        }
    }
}

impl Neighbours {
    /// Finds all pairs closer than `skin` [m] to touching.
    pub fn find(&mut self, grains: &Grains, walls: &[Wall], materials: &Materials, comm: &Single, skin: f64) {
        self.effort = self.search.pairs(&mut self.pairs, grains, (materials, comm), skin);
        self.search.walls(&mut self.walls, grains, (walls, materials), skin);
        self.find_incidence(grains);
        self.reference.copy(&grains.position);
        self.wall_reference.clear();
        self.wall_reference.extend(walls.iter().map(Wall::pose));
    }

    fn find_incidence(&mut self, grains: &Grains) {
        self.incidence.find(&self.pairs, &grains.id, 2);
        self.wall_incidence.find(&self.walls, &grains.id, 1);
        self.spans.resize(grains.len(), [0; 2]);
        let incidence = &self.incidence;
        (self.spans.par_iter_mut().enumerate())
            .with_min_len(1024)
            .for_each(|(grain, span)| {
                let chunks = incidence.of(grain).map(|entry| entry.chunk() as u32);
                *span = chunks.fold([u32::MAX, 0], |[low, high], c| [low.min(c), high.max(c)]);
            });
    }

    /// Makes the table of a checkpoint whole again; tells whether it fits these grains, walls and materials, as it does
    /// unless a file was tampered with.
    pub fn restore(&mut self, grains: &Grains, walls: usize, materials: usize) -> bool {
        let n = grains.len();
        let span = |indices: &mut dyn Iterator<Item = u32>| {
            indices.fold(table::NOWHERE, |span, g| (span.0.min(g), span.1.max(g)))
        };
        let fits = self.reference.len() == n
            && self.wall_reference.len() == walls
            && self.pairs.is_whole(materials.pow(2))
            && self.walls.is_whole(materials.pow(2))
            && (self.pairs.segments.iter().flat_map(|s| &s.candidates))
                .all(|p| (p.i as usize) < n && (p.j as usize) < n && p.i != p.j && p.shift < 27)
            && (self.walls.segments.iter().flat_map(|s| &s.candidates))
                .all(|p| (p.grain as usize) < n && (p.wall as usize) < walls);
        if !fits {
            return false;
        }
        for segment in &mut self.pairs.segments {
            segment.span = span(&mut segment.candidates.iter().flat_map(|p| [p.i, p.j]));
        }
        for segment in &mut self.walls.segments {
            segment.span = span(&mut segment.candidates.iter().map(|p| p.grain));
        }
        self.pairs.cut();
        self.walls.cut();
        self.find_incidence(grains);
        true
    }

    /// Number of chunks of pairs of grains.
    pub fn chunks(&self) -> usize {
        self.pairs.chunks()
    }

    /// Candidates of a chunk, and the material pair of all of them.
    #[inline(always)]
    pub fn chunk(&self, chunk: usize) -> (&[Pair], u32) {
        self.pairs.chunk(chunk)
    }

    /// Number of chunks of pairs of grain and wall.
    pub fn wall_chunks(&self) -> usize {
        self.walls.chunks()
    }

    /// Candidates of a chunk of pairs of grain and wall, and the material pair of all of them.
    #[inline(always)]
    pub fn wall_chunk(&self, chunk: usize) -> (&[WallPair], u32) {
        self.walls.chunk(chunk)
    }

    /// Number of candidate pairs of grains.
    pub fn pair_count(&self) -> usize {
        self.pairs.len()
    }

    /// Number of candidate pairs of grain and wall.
    pub fn wall_pair_count(&self) -> usize {
        self.walls.len()
    }

    /// Pairs that a grain is in, in the order of the partner's id: chunk, place in it, and whether the grain is its `i`.
    #[inline(always)]
    pub fn pairs_of(&self, grain: usize) -> impl ExactSizeIterator<Item = (usize, usize, bool)> + '_ {
        (self.incidence.of(grain)).map(|entry| (entry.chunk(), entry.slot(), entry.is_first()))
    }

    /// Where the pairs that a grain is in stand in the list of those of all grains, in the order of the partner's id.
    #[inline(always)]
    pub(crate) fn entries_of(&self, grain: usize) -> Range<usize> {
        self.incidence.range_of(grain)
    }

    /// Length of that list.
    pub(crate) fn entries(&self) -> usize {
        2 * self.pairs.len()
    }

    /// A pair of that list: chunk, place in it, and whether the grain is its `i`.
    #[inline(always)]
    pub(crate) fn entry(&self, place: usize) -> (usize, usize, bool) {
        let entry = self.incidence.entry(place);
        (entry.chunk(), entry.slot(), entry.is_first())
    }

    /// Pairs of a grain with walls, in the order of the walls: chunk, and place in it.
    #[inline(always)]
    pub fn wall_pairs_of(&self, grain: usize) -> impl ExactSizeIterator<Item = (usize, usize)> + '_ {
        (self.wall_incidence.of(grain)).map(|entry| (entry.chunk(), entry.slot()))
    }

    /// First and last chunk of the pairs that a grain is in; nothing but a first beyond the last where it is in none.
    #[inline(always)]
    pub(crate) fn span_of(&self, grain: usize) -> (usize, usize) {
        let [first, last] = self.spans[grain];
        (first as usize, last as usize)
    }

    /// Chunk of the candidate of two grains, and its number among all candidates; `i` has the lower id.
    #[inline]
    pub(crate) fn find_pair(&self, i: u32, j: u32) -> Option<(usize, usize)> {
        let mut entries = self.incidence.of(i as usize);
        let entry = entries.find(|&entry| self.pairs.candidate(entry).other(i) == j)?;
        Some((entry.chunk(), self.pairs.before(entry.chunk()) + entry.slot()))
    }

    /// Chunk of the candidate of a grain and a wall, and its number among all of them.
    #[inline]
    pub(crate) fn find_wall_pair(&self, grain: u32, wall: u32) -> Option<(usize, usize)> {
        let mut entries = self.wall_incidence.of(grain as usize);
        let entry = entries.find(|&entry| self.walls.candidate(entry).wall == wall)?;
        Some((entry.chunk(), self.walls.before(entry.chunk()) + entry.slot()))
    }

    /// Candidates in the chunks of pairs of grains before one.
    pub(crate) fn before_chunk(&self, chunk: usize) -> usize {
        self.pairs.before(chunk)
    }

    /// Candidates in the chunks of pairs of grain and wall before one.
    pub(crate) fn before_wall_chunk(&self, chunk: usize) -> usize {
        self.walls.before(chunk)
    }

    /// What the latest search took.
    pub fn effort(&self) -> SearchEffort {
        self.effort
    }

    /// Share of the candidates whose grains lie far apart in memory.
    pub(crate) fn scattered(&self) -> f64 {
        self.effort.scattered as f64 / self.pairs.len().max(1) as f64
    }

    /// Bytes in use: of the table, and of what a search needs.
    pub fn bytes(&self) -> (usize, usize) {
        let table = self.pairs.bytes() + self.walls.bytes() + self.incidence.bytes() + self.wall_incidence.bytes();
        (table + self.reference.bytes(), self.search.bytes())
    }
}
