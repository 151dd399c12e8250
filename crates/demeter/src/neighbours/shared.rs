//! Tables of candidates that several processes share: each has the pairs that one of its own grains is in.

use super::incidence::OfGrains;
use super::packed::PackedPair;
use super::pairs::PairTable;
use super::search::per_task;
use super::table::{Segment, Table};
use super::{FormerPlaces, Neighbours, Pair, SearchEffort, WallPair};
use crate::materials::Materials;
use crate::particles::Grains;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Candidates of some segments, as other processes are told.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct SegmentsOfCandidates {
    per_segment: usize,
    pairs: Vec<Segment<PackedPair>>,
    walls: Vec<Segment<WallPair>>,
}

impl Neighbours {
    /// Grains of every segment but the last.
    pub(crate) fn grains_per_segment(&self) -> usize {
        self.pairs.per_segment
    }

    /// Number of pairs of grains of a segment.
    pub(crate) fn candidates_of_segment(&self, segment: usize) -> usize {
        self.pairs.table.segments[segment].candidates.len()
    }

    /// Number of pairs of a segment, also with walls: a measure of its work.
    pub(crate) fn work_of_segment(&self, segment: usize) -> usize {
        self.candidates_of_segment(segment) + self.walls.segments[segment].candidates.len()
    }

    /// The grains that bear the work of candidates here, two for each between grains: those whose later grain is own, and those
    /// with walls.
    pub(crate) fn bearers(&self, own: &Range<usize>) -> impl Iterator<Item = (u32, u32)> + '_ {
        let own = own.clone();
        let pairs = (0..self.segments()).flat_map(|segment| self.pairs.of_segment(segment).iter());
        let walls = self.walls.segments.iter().flat_map(|segment| &segment.candidates);
        let of_pairs = pairs.map(|pair| (pair.later(), pair.earlier()));
        let all = of_pairs.chain(walls.map(|pair| (pair.grain, pair.grain)));
        all.filter(move |(later, _)| own.contains(&(*later as usize)))
    }

    /// Segments from the first one of some on, up to the last with any pair.
    pub(crate) fn segments_in_use(&self, own: &Range<usize>) -> Range<usize> {
        let segments = &self.pairs.table.segments;
        let last = segments.iter().rposition(|s| !s.candidates.is_empty());
        own.start..own.end.max(last.map_or(0, |last| last + 1))
    }

    /// Segments of own grains, whose segments are whole.
    fn segments_of(&self, own: &Range<usize>) -> Range<usize> {
        let per_segment = self.pairs.per_segment.max(1);
        own.start.div_ceil(per_segment)..own.end.div_ceil(per_segment)
    }

    /// Segments with pairs of own grains, whose segments are whole.
    pub(crate) fn segments_with(&self, own: &Range<usize>) -> impl Iterator<Item = usize> + Clone + '_ {
        self.pairs.segments_with(self.segments_of(own))
    }

    /// All pairs of own grains, whose segments are whole, with others, by the index of the own one.
    pub(crate) fn pairs_across(&self, own: &Range<usize>) -> impl Iterator<Item = (u32, u32)> + '_ {
        let pairs = self
            .segments_with(own)
            .flat_map(|segment| self.pairs.of_segment(segment).iter());
        let own = own.clone();
        pairs.filter_map(
            move |pair| match (own.contains(&(pair.i as usize)), own.contains(&(pair.j as usize))) {
                (true, false) => Some((pair.i, pair.j)),
                (false, true) => Some((pair.j, pair.i)),
                _ => None,
            },
        )
    }

    /// All pairs of own grains with others, with their chunks and their places there.
    pub(crate) fn places_across(&self, own: &Range<usize>) -> impl Iterator<Item = (Pair, usize, usize)> + '_ {
        let own = own.clone();
        let of_chunk = |chunk| (self.chunk(chunk).0.iter().enumerate()).map(move |(slot, pair)| (pair, chunk, slot));
        let pairs = (0..self.chunks()).flat_map(of_chunk);
        pairs.filter(move |(pair, ..)| own.contains(&(pair.i as usize)) != own.contains(&(pair.j as usize)))
    }

    /// Notes the effort and the number of pairs of all processes.
    pub(crate) fn note_total(&mut self, effort: SearchEffort, total: usize) {
        self.effort = effort;
        self.total = total;
    }

    /// Candidates of some segments.
    pub(crate) fn of_segments(&self, segments: Range<usize>) -> SegmentsOfCandidates {
        SegmentsOfCandidates {
            per_segment: self.pairs.per_segment,
            pairs: self.pairs.table.segments[segments.clone()].to_vec(),
            walls: self.walls.segments[segments].to_vec(),
        }
    }

    /// The candidates that one of the own grains, whose segments are whole, is in.
    pub(crate) fn picked(&self, own: &Range<usize>) -> SegmentsOfCandidates {
        let is_own = |grain: u32| own.contains(&(grain as usize));
        let mut picked = SegmentsOfCandidates {
            per_segment: self.pairs.per_segment,
            pairs: vec![Segment::default(); self.segments()],
            walls: vec![Segment::default(); self.segments()],
        };
        for s in self.segments_with(own) {
            let first = (s * self.pairs.per_segment) as u32;
            picked.pairs[s] = self.pairs.table.segments[s].picked(|packed| {
                let pair = packed.pair(first);
                is_own(pair.i) || is_own(pair.j)
            });
        }
        for s in self.segments_of(own) {
            picked.walls[s].clone_from(&self.walls.segments[s]);
        }
        picked
    }

    /// A table without candidates for a search among these grains.
    pub(crate) fn before_search(&self, grains: &Grains, materials: &Materials) -> Self {
        let per_segment = per_task(materials);
        let segments = grains.len().div_ceil(per_segment);
        Self {
            pairs: PairTable::of_segments(vec![Segment::default(); segments], per_segment),
            walls: Table::of_segments(vec![Segment::default(); segments]),
            incidence: self.incidence.as_ref().map(|_| OfGrains::default()),
            former: FormerPlaces::unknown(grains.len(), per_segment),
            ..Self::default()
        }
    }

    /// A table like this one of other candidates, which are told segment by segment; [`Neighbours::restore`] finds the rest.
    pub(crate) fn with_candidates(&self, all: impl IntoIterator<Item = SegmentsOfCandidates>) -> Self {
        let (mut pairs, mut walls, mut per_segment) = (Vec::new(), Vec::new(), self.pairs.per_segment);
        for some in all {
            per_segment = some.per_segment;
            pairs.extend(some.pairs);
            walls.extend(some.walls);
        }
        Self {
            pairs: PairTable::of_segments(pairs, per_segment),
            walls: Table::of_segments(walls),
            incidence: self.incidence.as_ref().map(|_| OfGrains::default()),
            effort: self.effort,
            total: self.total,
            former: self.former.clone(),
            wall_reference: self.wall_reference.clone(),
            ..Self::default()
        }
    }
}
