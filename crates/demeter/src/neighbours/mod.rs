//! Candidate pairs: grains and walls close enough to touch before the next rebuild.
//!
//! A rebuild works in parallel and gives the same on any number of threads; what it needs beyond the table it gives back:
//!
//! 1. `cells`: grains are sorted into a grid per size class, and their places copied in that order; where a run is shared, those
//!    that are near own ones (`vicinity`), into the cells of all;
//! 2. `search`, `visit`: every grain looks at half of the cells around it, and into the grids of other classes;
//! 3. `pairs`: pairs are put into the order in which grains are summed up;
//! 4. `table`: they are cut into chunks of one law;
//! 5. `incidence`: where contacts feel each other every grain learns its candidates.

mod cells;
mod classes;
mod crowd;
mod former;
mod incidence;
mod moves;
mod order;
mod packed;
mod pairs;
mod ranges;
mod rows_of_cells;
mod search;
mod shared;
mod surroundings;
mod table;
#[cfg(test)]
mod tests;
mod vicinity;
mod visit;
mod written;

pub(crate) use classes::{Extremes, SizeClasses};
pub(crate) use crowd::{Counts, Extent, are_scattered, crowd};
pub(crate) use former::{Farthest, FormerPlaces};
pub use moves::{Moves, NewPlaces};
pub use order::put_in_order;
pub(crate) use order::{Curve, Keyed};
pub use packed::Pairs;
pub use search::SearchEffort;
pub(crate) use shared::SegmentsOfCandidates;
pub use table::CHUNK;
pub(crate) use vicinity::{Bounds, BoxesOfClasses, CORNERS, Reach, Vicinity};

use crate::comm::Single;
use crate::materials::Materials;
use crate::particles::Grains;
use crate::particles::spread::{GRAINS_OF_A_SPREAD, Spread};
use crate::walls::{Pose, Wall};
use incidence::OfGrains;
use pairs::PairTable;
use search::Search;
use serde::{Deserialize, Serialize};
use std::fmt::{Debug, Formatter};
use std::ops::Range;
use table::{Segment, Table};

/// A candidate pair of grains; `i` has the lower id.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C, packed)]
pub struct Pair {
    /// Index of the grain with the lower id.
    pub i: u32,
    /// Index of its partner.
    pub j: u32,
    /// Code of the periodic shift of `x_i - x_j`.
    pub shift: u8,
}

impl Pair {
    /// The grain that lies behind the other in memory.
    #[inline(always)]
    pub fn later(&self) -> u32 {
        self.i.max(self.j)
    }

    /// The grain that lies before the other in memory.
    #[inline(always)]
    pub fn earlier(&self) -> u32 {
        self.i.min(self.j)
    }

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
#[derive(Default, Deserialize)]
pub struct Neighbours {
    pairs: PairTable,
    walls: Table<WallPair>,
    /// Pairs of every grain; nothing where nobody asks for them.
    #[serde(skip)]
    incidence: Option<OfGrains>,
    #[serde(skip)]
    search: Search,
    effort: SearchEffort,
    /// Number of pairs, of all processes.
    total: usize,
    /// Where the grains were when the pairs were found; own ones where a run is shared.
    pub(crate) former: FormerPlaces,
    /// Where the walls were.
    pub wall_reference: Vec<Pose>,
}

impl Clone for Neighbours {
    /// A copy holds what a checkpoint holds; [`Neighbours::restore`] finds the rest.
    fn clone(&self) -> Self {
        Self {
            pairs: self.pairs.saved(),
            incidence: self.incidence.as_ref().map(|_| OfGrains::default()),
            walls: self.walls.saved(),
            effort: self.effort,
            total: self.total,
            former: self.former.clone(),
            wall_reference: self.wall_reference.clone(),
            ..Self::default()
        }
    }
}

impl Debug for Neighbours {
    /// Shows what a checkpoint holds.
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        let saved = self.clone();
        let mut fields = formatter.debug_struct("Neighbours");
        fields.field("pairs", &saved.pairs).field("walls", &saved.walls);
        fields.field("effort", &saved.effort).field("total", &saved.total);
        fields.field("former", &saved.former);
        fields.field("wall_reference", &saved.wall_reference).finish()
    }
}

impl Neighbours {
    /// Finds all pairs closer than `skin` [m] to touching.
    pub fn find(&mut self, grains: &Grains, walls: &[Wall], materials: &Materials, comm: &Single, skin: f64) {
        let all = 0..grains.len();
        self.find_of((&all, None), grains, (walls, materials, comm), skin);
        self.note_places(&all, grains);
    }

    /// Finds all pairs closer than `skin` [m] to touching that one of the `own` grains is in, where no others are known than
    /// those told; [`Neighbours::note_places`] comes after it.
    pub(crate) fn find_of(
        &mut self,
        (own, vicinity): (&Range<usize>, Option<&Vicinity>),
        grains: &Grains,
        (walls, materials, comm): (&[Wall], &Materials, &Single),
        skin: f64,
    ) {
        let search = &mut self.search;
        self.effort = search.pairs(&mut self.pairs, grains, (materials, comm), skin, (own, vicinity));
        search.walls(&mut self.walls, grains, (walls, materials), skin, own);
        self.total = self.pairs.table.len();
        self.find_incidence(grains);
        self.wall_reference.clear();
        self.wall_reference.extend(walls.iter().map(Wall::pose));
    }

    /// Notes where the own grains are with these candidates.
    pub(crate) fn note_places(&mut self, own: &Range<usize>, grains: &Grains) {
        self.former.note(&grains.position, own, self.pairs.per_segment);
    }

    fn find_incidence(&mut self, grains: &Grains) {
        if let Some(incidence) = &mut self.incidence {
            incidence.find(&self.pairs, &self.walls, &grains.id);
        }
    }

    /// Has every grain learn its pairs from now on ([`Neighbours::pairs_of`], [`Neighbours::wall_pairs_of`]).
    pub fn tell_pairs_of_grains(&mut self) {
        self.incidence.get_or_insert_default();
    }

    /// Makes the table of a checkpoint whole again; tells whether it fits these grains, walls and materials, as it does
    /// unless a file was tampered with.
    pub fn restore(&mut self, grains: &Grains, walls: usize, materials: usize) -> bool {
        let n = grains.len();
        let is_own = |(s, segment): (usize, &Segment<WallPair>)| {
            let own = self.pairs.grains_of(s, n);
            (segment.candidates.iter()).all(|p| own.contains(&(p.grain as usize)) && (p.wall as usize) < walls)
        };
        let fits = self.former.fits(n, self.pairs.per_segment)
            && self.wall_reference.len() == walls
            && self.walls.is_whole(materials.pow(2))
            && self.walls.segments.len() == self.pairs.table.segments.len()
            && self.walls.segments.iter().enumerate().all(is_own)
            && self.pairs.restore(n, materials.pow(2));
        if !fits {
            return false;
        }
        for segment in &mut self.walls.segments {
            let grains = segment.candidates.iter().map(|p| p.grain);
            segment.span = grains.fold(table::NOWHERE, |span, g| (span.0.min(g), span.1.max(g)));
        }
        self.walls.cut_by_grain();
        self.find_incidence(grains);
        true
    }

    /// Number of chunks of pairs of grains.
    pub fn chunks(&self) -> usize {
        self.pairs.table.chunks()
    }

    /// Candidates of a chunk, and the material pair of all of them.
    #[inline(always)]
    pub fn chunk(&self, chunk: usize) -> (Pairs<'_>, u32) {
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

    /// Number of candidate pairs of grains in the table.
    pub fn pair_count(&self) -> usize {
        self.pairs.table.len()
    }

    /// Number of candidate pairs of grains, of all processes.
    pub(crate) fn total(&self) -> usize {
        self.total
    }

    /// Number of candidate pairs of grain and wall.
    pub fn wall_pair_count(&self) -> usize {
        self.walls.len()
    }

    /// Pairs that a grain is in, in the order of the partner's id: chunk, place in it, and whether the grain is its `i`. None
    /// where they are not told ([`Neighbours::tell_pairs_of_grains`]).
    #[inline(always)]
    pub fn pairs_of(&self, grain: usize) -> impl Iterator<Item = (usize, usize, bool)> + '_ {
        let entries = self.incidence.iter().flat_map(move |of| of.pairs.of(grain));
        entries.map(|entry| (entry.chunk(), entry.slot(), entry.is_first()))
    }

    /// Number of segments of pairs, each with the pairs of some grains with those before them.
    pub(crate) fn segments(&self) -> usize {
        self.pairs.table.segments.len()
    }

    /// Grains of a segment, or what lies behind the last.
    pub(crate) fn grains_of_segment(&self, segment: usize) -> Range<usize> {
        self.pairs.grains_of(segment, self.former.len())
    }

    /// Chunks of a segment.
    pub(crate) fn chunks_of_segment(&self, segment: usize) -> Range<usize> {
        self.pairs.table.chunks_of(segment)
    }

    /// Chunks of pairs with walls of a segment.
    pub(crate) fn wall_chunks_of_segment(&self, segment: usize) -> Range<usize> {
        self.walls.chunks_of(segment)
    }

    /// The segment of a chunk.
    #[inline(always)]
    pub(crate) fn segment_of_chunk(&self, chunk: usize) -> usize {
        self.pairs.table.segment_of(chunk)
    }

    /// The segment of a chunk of pairs with walls.
    pub(crate) fn segment_of_wall_chunk(&self, chunk: usize) -> usize {
        self.walls.segment_of(chunk)
    }

    /// Stretches whose velocities are bounded together of a segment.
    pub(crate) fn spreads_of_segment(&self, segment: usize) -> Range<usize> {
        let grains = self.grains_of_segment(segment);
        grains.start / GRAINS_OF_A_SPREAD..grains.end.div_ceil(GRAINS_OF_A_SPREAD)
    }

    /// Bounds of the velocities of the grains of a segment.
    pub(crate) fn spread_of(&self, segment: usize, spreads: &[Spread]) -> Spread {
        let of = &spreads[self.spreads_of_segment(segment)];
        of.iter().copied().fold(Spread::NONE, Spread::join)
    }

    /// A speed with which no two grains approach each other faster whose pair belongs to a segment, and by how much both of their half
    /// kicks together change that at most [m/s].
    pub(crate) fn approach(&self, segment: usize, spreads: &[Spread]) -> (f64, f64) {
        let own = self.spread_of(segment, spreads);
        let others = self.pairs.others_of(segment).iter();
        others.fold((own.against(&own), 2.0 * own.kick), |(speed, kick), &other| {
            let other = self.spread_of(other as usize, spreads);
            (speed.max(own.against(&other)), kick.max(own.kick + other.kick))
        })
    }

    /// Pairs of a grain with walls, in the order of the walls: chunk, and place in it. None where they are not told
    /// ([`Neighbours::tell_pairs_of_grains`]).
    #[inline(always)]
    pub fn wall_pairs_of(&self, grain: usize) -> impl Iterator<Item = (usize, usize)> + '_ {
        let entries = self.incidence.iter().flat_map(move |of| of.walls.of(grain));
        entries.map(|entry| (entry.chunk(), entry.slot()))
    }

    /// Chunk of the candidate of two grains, and its number among all candidates.
    #[inline]
    pub(crate) fn find_pair(&self, i: u32, j: u32) -> Option<(usize, usize)> {
        let (chunk, slot) = self.pairs.find(i, j)?;
        Some((chunk, self.pairs.table.before(chunk) + slot))
    }

    /// Chunk of the candidate of a grain and a wall, and its number among all of them.
    #[inline]
    pub(crate) fn find_wall_pair(&self, grain: u32, wall: u32) -> Option<(usize, usize)> {
        let s = grain as usize / self.pairs.per_segment;
        let candidate = (self.walls.segments.get(s)?).find(&(grain, wall), |pair| (pair.grain, pair.wall))?;
        let (chunk, slot) = self.walls.chunk_and_slot(s, candidate);
        Some((chunk, self.walls.before(chunk) + slot))
    }

    /// Candidates in the chunks of pairs of grains before one.
    pub(crate) fn before_chunk(&self, chunk: usize) -> usize {
        self.pairs.table.before(chunk)
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
        self.effort.scattered as f64 / self.total.max(1) as f64
    }

    /// Bytes in use, with so many own grains.
    pub fn bytes(&self, own: usize) -> usize {
        let incidence = self.incidence.as_ref().map_or(0, OfGrains::bytes);
        self.pairs.bytes() + self.walls.bytes() + incidence + self.former.bytes(own)
    }
}
