//! Candidate pairs in the order in which grains are summed up: by segments of the later of both grains in memory, there by laws, then by
//! the place of the later grain, then by that of the earlier.
//!
//! Whoever adds what a pair does to both of its grains, pair by pair, adds to each grain in this order. It does not depend on how the
//! work is shared out: a task that has the pairs of some segments adds to their grains itself, and what it has for grains of other
//! tasks is added afterwards, task by task.

use super::Pair;
use super::packed::{MOST_OF_A_SEGMENT, PackedPair, Pairs};
use super::ranges::sums;
use super::table::{LawOrder, NOWHERE, Segment, Table};
use crate::particles::set_aside;
use rayon::prelude::*;
use serde::Deserialize;
use std::ops::Range;

/// Candidate pairs by segments of grains that lie behind each other: each has the pairs whose later grain is one of its own.
#[derive(Clone, Debug, Default, Deserialize)]
pub(super) struct PairTable {
    pub(super) table: Table<PackedPair>,
    /// Grains of a segment.
    pub(super) per_segment: usize,
    /// For every segment the others with the earlier grains of its pairs.
    #[serde(skip)]
    others: Vec<Vec<u32>>,
}

/// Pairs that tasks found whose later grain belongs to the segment of another.
struct Strays {
    /// By segment of the later grain.
    pairs: Vec<Pair>,
    /// Where those of each segment begin, and the last end.
    first: Vec<u32>,
}

/// Memory of a thread for putting pairs in order.
#[derive(Debug, Default)]
pub(super) struct Sorter {
    pairs: Vec<PackedPair>,
    /// Where the pairs of each later grain begin, and where the next of them goes.
    starts: Vec<u32>,
    next: Vec<u32>,
    laws: Vec<u32>,
    order: LawOrder,
}

impl PairTable {
    /// Has the pairs found by tasks with as many grains as segments have: those whose later grain is one of the task's own, in the memory
    /// of the table itself.
    pub(super) fn search(
        &mut self,
        grains: usize,
        per_segment: usize,
    ) -> impl IndexedParallelIterator<Item = &mut Vec<PackedPair>> {
        self.per_segment = per_segment;
        let segments = grains.div_ceil(per_segment);
        self.others.resize_with(segments, Vec::new);
        self.table.segments.resize_with(segments, Segment::default);
        self.table.segments.par_iter_mut().map(|segment| {
            segment.candidates.clear();
            &mut segment.candidates
        })
    }

    /// Grains of a segment.
    pub(super) fn grains_of(&self, segment: usize, grains: usize) -> Range<usize> {
        segment * self.per_segment..((segment + 1) * self.per_segment).min(grains)
    }

    /// Pairs of a segment.
    pub(super) fn of_segment(&self, segment: usize) -> Pairs<'_> {
        Pairs::new(segment * self.per_segment, &self.table.segments[segment].candidates)
    }

    /// Segments with pairs that grains of some segments are in: these, and those behind them with partners.
    pub(super) fn segments_with(&self, some: Range<usize>) -> impl Iterator<Item = usize> + Clone + '_ {
        let partners = move |segment: usize| self.others.get(segment).into_iter().flatten();
        let is_one = move |other: usize| some.contains(&other);
        let of_all = 0..self.table.segments.len();
        of_all.filter(move |&s| is_one(s) || partners(s).any(|&other| is_one(other as usize)))
    }

    /// Pairs of a chunk, and the material pair of all of them.
    #[inline(always)]
    pub(super) fn chunk(&self, chunk: usize) -> (Pairs<'_>, u32) {
        let (packed, law) = self.table.chunk(chunk);
        (Pairs::new(self.table.segment_of(chunk) * self.per_segment, packed), law)
    }

    /// Puts all that was found in order, with the strays in any order; `law` tells the material pair of a pair.
    pub(super) fn sort(
        &mut self,
        grains: usize,
        strays: Vec<Vec<Pair>>,
        law: impl Fn(&Pair) -> u32 + Sync,
        with_sorter: impl Fn(&mut dyn FnMut(&mut Sorter)) + Sync,
    ) {
        let per_segment = self.per_segment;
        let strays = &Strays::collect(strays, self.table.segments.len(), per_segment);
        (self.table.segments.par_iter_mut().enumerate())
            .zip(&mut self.others)
            .for_each(|((s, segment), others)| {
                let strays = strays.of_segment(s);
                let first = s * per_segment;
                let own = (grains - first).min(per_segment);
                with_sorter(&mut |sorter| sorter.fill(segment, strays, (first, own), &law));
                find_others(&segment.candidates, s, per_segment, others);
            });
        self.table.cut();
    }

    /// Makes the table of a checkpoint whole again; tells whether it fits so many grains and material pairs.
    pub(super) fn restore(&mut self, grains: usize, laws: usize) -> bool {
        let per_segment = self.per_segment;
        let fits = |(s, segment): (usize, &Segment<PackedPair>)| {
            let own = self.grains_of(s, grains);
            let is_whole = |packed: &PackedPair| {
                let later = own.start + packed.place();
                own.contains(&later) && (packed.earlier() as usize) < later && packed.pair(0).shift < 27
            };
            segment.candidates.iter().all(is_whole)
        };
        if !self.table.is_whole(laws)
            || !(1..=MOST_OF_A_SEGMENT).contains(&per_segment)
            || self.table.segments.len() != grains.div_ceil(per_segment)
            || !self.table.segments.iter().enumerate().all(fits)
        {
            return false;
        }
        let mut is_in_order = true;
        self.others.resize_with(self.table.segments.len(), Vec::new);
        let mut keys = Vec::new();
        for (s, (segment, others)) in self.table.segments.iter_mut().zip(&mut self.others).enumerate() {
            is_in_order &= (segment.by_law()).all(|(_, pairs)| pairs.is_sorted_by_key(PackedPair::key));
            keys.clear();
            keys.extend(segment.candidates.iter().map(PackedPair::key));
            keys.sort_unstable();
            // no two grains are a pair twice
            is_in_order &= keys.windows(2).all(|two| two[0] != two[1]);
            segment.span = span(&segment.candidates, s * per_segment);
            find_others(&segment.candidates, s, per_segment, others);
        }
        self.table.cut();
        is_in_order
    }

    /// The other segments with the earlier grains of the pairs of a segment.
    pub(super) fn others_of(&self, segment: usize) -> &[u32] {
        &self.others[segment]
    }

    /// Chunk and place in it of the pair of two grains.
    #[inline]
    pub(super) fn find(&self, i: u32, j: u32) -> Option<(usize, usize)> {
        let (later, earlier) = (i.max(j) as usize, i.min(j));
        let (s, place) = (later / self.per_segment, later % self.per_segment);
        let candidate = (self.table.segments.get(s)?).find(&(place, earlier), PackedPair::key)?;
        Some(self.table.chunk_and_slot(s, candidate))
    }

    /// A table of segments; [`PairTable::restore`] finds the rest.
    pub(super) fn of_segments(segments: Vec<Segment<PackedPair>>, per_segment: usize) -> Self {
        Self {
            table: Table::of_segments(segments),
            per_segment,
            ..Self::default()
        }
    }

    /// Without what is found again.
    pub(super) fn saved(&self) -> Self {
        Self {
            table: self.table.saved(),
            per_segment: self.per_segment,
            ..Self::default()
        }
    }

    /// Bytes in use.
    pub(super) fn bytes(&self) -> usize {
        self.table.bytes() + self.others.iter().map(set_aside).sum::<usize>()
    }
}

impl Strays {
    fn collect(found: Vec<Vec<Pair>>, segments: usize, per_segment: usize) -> Self {
        let segment_of = |pair: &Pair| pair.later() as usize / per_segment;
        let mut first = vec![0; segments + 1];
        found.iter().flatten().for_each(|pair| first[segment_of(pair) + 1] += 1);
        sums(&mut first);
        let nothing = Pair { i: 0, j: 0, shift: 0 };
        let mut pairs = vec![nothing; found.iter().map(Vec::len).sum()];
        // starts become ends
        for pair in found.into_iter().flatten() {
            let next = &mut first[segment_of(&pair) + 1];
            pairs[*next as usize] = pair;
            *next += 1;
        }
        Self { pairs, first }
    }

    fn of_segment(&self, segment: usize) -> &[Pair] {
        &self.pairs[self.first[segment] as usize..self.first[segment + 1] as usize]
    }
}

/// Finds the other segments with the earlier grains of the pairs of a segment.
fn find_others(pairs: &[PackedPair], segment: usize, per_segment: usize, others: &mut Vec<u32>) {
    others.clear();
    let mut last = segment;
    for pair in pairs {
        let other = pair.earlier() as usize / per_segment;
        if other != last && other != segment {
            last = other;
            if !others.contains(&(other as u32)) {
                others.push(other as u32);
            }
        }
    }
}

/// Lowest and highest index of the grains of the pairs of a segment that begins with a grain.
fn span(pairs: &[PackedPair], first: usize) -> (u32, u32) {
    let ends = |span: (u32, u32), p: &PackedPair| {
        let later = (first + p.place()) as u32;
        (span.0.min(p.earlier()), span.1.max(later))
    };
    pairs.iter().fold(NOWHERE, ends)
}

impl Sorter {
    /// Puts the pairs in order that the segment of some grains behind each other holds, with others that belong to it. The
    /// grains are told by the first and how many.
    fn fill(
        &mut self,
        segment: &mut Segment<PackedPair>,
        strays: &[Pair],
        (first, grains): (usize, usize),
        law: impl Fn(&Pair) -> u32,
    ) {
        let own = &segment.candidates;
        if own.is_empty() && strays.is_empty() && segment.runs.is_empty() {
            return;
        }
        let packed = |pair| PackedPair::new(pair, first as u32);
        let all = || own.iter().copied().chain(strays.iter().map(packed));
        self.starts.clear();
        self.starts.resize(grains + 1, 0);
        all().for_each(|pair| self.starts[pair.place() + 1] += 1);
        for grain in 0..grains {
            self.starts[grain + 1] += self.starts[grain];
        }
        self.next.clear();
        self.next.extend_from_slice(&self.starts);
        self.pairs.resize(own.len() + strays.len(), PackedPair::default());
        for pair in all() {
            let later = pair.place();
            // few pairs have the same later grain: each goes to its place among them at once
            let mut place = self.next[later] as usize;
            let least = self.starts[later] as usize;
            while place > least && self.pairs[place - 1].earlier() > pair.earlier() {
                self.pairs[place] = self.pairs[place - 1];
                place -= 1;
            }
            self.pairs[place] = pair;
            self.next[later] += 1;
        }
        self.laws.clear();
        self.laws
            .extend(Pairs::new(first, &self.pairs).iter().map(|pair| law(&pair)));
        segment.span = span(&self.pairs, first);
        segment.fill(&self.pairs, &self.laws, &mut self.order);
    }
}
