//! Candidate pairs in the order in which grains are summed up: by segments of the later of both grains in memory, there by laws, then by
//! the place of the later grain, then by that of the earlier.
//!
//! Whoever adds what a pair does to both of its grains, pair by pair, adds to each grain in this order. It does not depend on how the
//! work is shared out: a task that has the pairs of some segments adds to their grains itself, and what it has for grains of other
//! tasks is added afterwards, task by task.

use super::Pair;
use super::table::{LawOrder, NOWHERE, Segment, Table};
use crate::particles::set_aside;
use rayon::prelude::*;
use serde::Deserialize;
use std::ops::Range;

/// Candidate pairs by segments of grains that lie behind each other: each has the pairs whose later grain is one of its own.
#[derive(Clone, Debug, Default, Deserialize)]
pub(super) struct PairTable {
    pub(super) table: Table<Pair>,
    /// Grains of a segment.
    pub(super) per_segment: usize,
    /// For every segment where the pairs of each later grain begin, in the order of the sums.
    #[serde(skip)]
    starts: Vec<Vec<u32>>,
    /// For every segment the others with the earlier grains of its pairs.
    #[serde(skip)]
    others: Vec<Vec<u32>>,
    /// Pairs that the task of each segment found and whose later grain belongs to another.
    #[serde(skip)]
    strays_found: Vec<Vec<Pair>>,
    /// The same by segment of the later grain, and where those of each segment begin.
    #[serde(skip)]
    strays: Vec<Pair>,
    #[serde(skip)]
    first_strays: Vec<u32>,
}

/// What a task of the search finds.
pub(super) struct Found<'a> {
    /// Pairs whose later grain is one of the task's own.
    pub(super) own: &'a mut Vec<Pair>,
    /// Others.
    pub(super) strays: &'a mut Vec<Pair>,
}

/// Memory of a thread for putting pairs in order.
#[derive(Debug, Default)]
pub(super) struct Sorter {
    pairs: Vec<Pair>,
    next: Vec<u32>,
    laws: Vec<u32>,
    order: LawOrder,
}

impl PairTable {
    /// Has the pairs found by tasks with as many grains as segments have, in the memory of the table itself.
    pub(super) fn search(
        &mut self,
        grains: usize,
        per_segment: usize,
    ) -> impl IndexedParallelIterator<Item = Found<'_>> {
        self.per_segment = per_segment;
        let segments = grains.div_ceil(per_segment);
        self.strays_found.resize_with(segments, Vec::new);
        self.starts.resize_with(segments, Vec::new);
        self.others.resize_with(segments, Vec::new);
        self.table.segments.resize_with(segments, Segment::default);
        let found = self.table.segments.par_iter_mut().zip(&mut self.strays_found);
        found.map(|(segment, strays)| {
            let own = &mut segment.candidates;
            own.clear();
            strays.clear();
            Found { own, strays }
        })
    }

    /// Grains of a segment.
    pub(super) fn grains_of(&self, segment: usize, grains: usize) -> Range<usize> {
        segment * self.per_segment..((segment + 1) * self.per_segment).min(grains)
    }

    fn collect_strays(&mut self) {
        let segment_of = |pair: &Pair| pair.later() as usize / self.per_segment;
        let segments = self.strays_found.len();
        self.first_strays.clear();
        self.first_strays.resize(segments + 1, 0);
        let all = || self.strays_found.iter().flatten();
        all().for_each(|pair| self.first_strays[segment_of(pair) + 1] += 1);
        for segment in 0..segments {
            self.first_strays[segment + 1] += self.first_strays[segment];
        }
        let nothing = Pair { i: 0, j: 0, shift: 0 };
        self.strays.resize(self.first_strays[segments] as usize, nothing);
        // starts become ends, and then starts again
        for &pair in self.strays_found.iter().flatten() {
            let next = &mut self.first_strays[segment_of(&pair)];
            self.strays[*next as usize] = pair;
            *next += 1;
        }
        self.first_strays.rotate_right(1);
        self.first_strays[0] = 0;
    }

    /// Puts all that was found in order; `law` tells the material pair of a pair.
    pub(super) fn sort(
        &mut self,
        grains: usize,
        law: impl Fn(&Pair) -> u32 + Sync,
        with_sorter: impl Fn(&mut dyn FnMut(&mut Sorter)) + Sync,
    ) {
        self.collect_strays();
        let per_segment = self.per_segment;
        let (strays, first_strays) = (&self.strays, &self.first_strays);
        (self.table.segments.par_iter_mut().enumerate())
            .zip(self.starts.par_iter_mut().zip(&mut self.others))
            .for_each(|((s, segment), (starts, others))| {
                let strays = &strays[first_strays[s] as usize..first_strays[s + 1] as usize];
                let first = s * per_segment;
                let own = (grains - first).min(per_segment);
                with_sorter(&mut |sorter| sorter.fill(segment, starts, strays, (first, own), &law));
                find_others(&segment.candidates, s, per_segment, others);
            });
        self.table.cut();
    }

    /// Makes the table of a checkpoint whole again; tells whether it fits so many grains and material pairs.
    pub(super) fn restore(&mut self, grains: usize, laws: usize) -> bool {
        let per_segment = self.per_segment;
        let fits = |(s, segment): (usize, &Segment<Pair>)| {
            let own = s * per_segment..(s + 1) * per_segment;
            let is_own = |p: &Pair| own.contains(&(p.later() as usize));
            let is_whole = |p: &Pair| {
                (p.i as usize) < grains && (p.j as usize) < grains && p.i != p.j && p.shift < 27 && is_own(p)
            };
            segment.candidates.iter().all(is_whole)
        };
        if !self.table.is_whole(laws)
            || per_segment == 0
            || self.table.segments.len() != grains.div_ceil(per_segment)
            || !self.table.segments.iter().enumerate().all(fits)
        {
            return false;
        }
        self.starts.resize_with(self.table.segments.len(), Vec::new);
        let mut is_in_order = true;
        self.others.resize_with(self.table.segments.len(), Vec::new);
        let lists = self.starts.iter_mut().zip(&mut self.others);
        for (s, (segment, (starts, others))) in self.table.segments.iter_mut().zip(lists).enumerate() {
            let mut order: Vec<u32> = (0..segment.candidates.len() as u32).collect();
            let key = |k: u32| segment.candidates[k as usize].key();
            order.sort_unstable_by_key(|&k| key(k));
            is_in_order &= order.windows(2).all(|two| key(two[0]) < key(two[1]));
            let first = s * per_segment;
            starts.clear();
            starts.extend((first..=first + per_segment.min(grains - first)).map(|grain| {
                order.partition_point(|&k| (segment.candidates[k as usize].later() as usize) < grain) as u32
            }));
            segment.span = span(&segment.candidates);
            find_others(&segment.candidates, s, per_segment, others);
            segment.order = if segment.runs.len() > 1 { order } else { Vec::new() };
            is_in_order &= segment.runs.len() > 1 || segment.candidates.is_sorted_by_key(Pair::key);
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
        let s = later / self.per_segment;
        let (segment, starts) = (self.table.segments.get(s)?, &self.starts[s]);
        let own = later - s * self.per_segment;
        let among = starts[own]..starts[own + 1];
        for place in among {
            let candidate = segment.order.get(place as usize).copied().unwrap_or(place);
            if segment.candidates[candidate as usize].earlier() == earlier {
                return Some(self.table.chunk_and_slot(s, candidate));
            }
        }
        None
    }

    /// A table of segments; [`PairTable::restore`] finds the rest.
    pub(super) fn of_segments(segments: Vec<Segment<Pair>>, per_segment: usize) -> Self {
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

    /// Gives back what only a search needs.
    pub(super) fn forget_found(&mut self) {
        self.strays_found = Vec::new();
        self.strays = Vec::new();
        self.first_strays = Vec::new();
    }

    /// Bytes in use.
    pub(super) fn bytes(&self) -> usize {
        let of = |lists: &[Vec<u32>]| lists.iter().map(set_aside).sum::<usize>();
        self.table.bytes() + of(&self.starts) + of(&self.others)
    }
}

/// Finds the other segments with the earlier grains of the pairs of a segment.
fn find_others(pairs: &[Pair], segment: usize, per_segment: usize, others: &mut Vec<u32>) {
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

fn span(pairs: &[Pair]) -> (u32, u32) {
    let ends = |span: (u32, u32), p: &Pair| (span.0.min(p.earlier()), span.1.max(p.later()));
    pairs.iter().fold(NOWHERE, ends)
}

impl Sorter {
    /// Puts the pairs in order that the segment of some grains behind each other holds, with others that belong to it. The
    /// grains are told by the first and how many.
    fn fill(
        &mut self,
        segment: &mut Segment<Pair>,
        starts: &mut Vec<u32>,
        strays: &[Pair],
        (first, grains): (usize, usize),
        law: impl Fn(&Pair) -> u32,
    ) {
        let own = &segment.candidates;
        let all = || own.iter().chain(strays);
        let is_empty = own.is_empty() && strays.is_empty() && segment.runs.is_empty();
        if is_empty && starts.len() == grains + 1 && starts.last() == Some(&0) {
            return;
        }
        starts.clear();
        starts.resize(grains + 1, 0);
        all().for_each(|pair| starts[pair.later() as usize - first + 1] += 1);
        for grain in 0..grains {
            starts[grain + 1] += starts[grain];
        }
        self.next.clear();
        self.next.extend_from_slice(starts);
        self.pairs
            .resize(own.len() + strays.len(), Pair { i: 0, j: 0, shift: 0 });
        for pair in all() {
            let later = pair.later() as usize - first;
            // few pairs have the same later grain: each goes to its place among them at once
            let mut place = self.next[later] as usize;
            let least = starts[later] as usize;
            while place > least && self.pairs[place - 1].earlier() > pair.earlier() {
                self.pairs[place] = self.pairs[place - 1];
                place -= 1;
            }
            self.pairs[place] = *pair;
            self.next[later] += 1;
        }
        self.laws.clear();
        self.laws.extend(self.pairs.iter().map(law));
        segment.span = span(&self.pairs);
        segment.fill(&self.pairs, &self.laws, &mut self.order);
    }
}
