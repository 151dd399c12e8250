//! Which candidates every grain is in.

use super::WallPair;
use super::packed::PackedPair;
use super::pairs::PairTable;
use super::ranges::{for_ranges, scatter, sums};
use super::table::{Entry, NOWHERE, Segment, Table};
use std::ops::Range;

/// Grains with so few candidates are sorted by counting, for every entry, those that go before it.
const FEW: usize = 16;

/// Candidates of every grain.
#[derive(Debug, Default)]
pub(super) struct OfGrains {
    pub(super) pairs: Incidence,
    pub(super) walls: Incidence,
}

impl OfGrains {
    /// Finds the entries of all grains anew.
    pub(super) fn find(&mut self, pairs: &PairTable, walls: &Table<WallPair>, ids: &[u32]) {
        self.pairs.find((&pairs.table, pairs.per_segment), ids, 2);
        self.walls.find((walls, pairs.per_segment), ids, 1);
    }

    /// Bytes in use.
    pub(super) fn bytes(&self) -> usize {
        self.pairs.bytes() + self.walls.bytes()
    }
}

/// Entries of every grain.
#[derive(Debug, Default)]
pub(super) struct Incidence {
    /// The first grain with any; before it and behind the last there are none.
    first: usize,
    start: Vec<u32>,
    entries: Vec<u32>,
}

/// A candidate and the grains that it is a candidate of.
pub(super) trait Candidate: Copy + Sync {
    /// Grains, with the number of the side, told the first grain of the segment.
    fn grains(&self, first: u32) -> impl Iterator<Item = (u32, u32)>;
    /// What the entry of a grain is sorted by.
    fn key(&self, first: u32, grain: u32, ids: &[u32]) -> u32;
}

impl Candidate for PackedPair {
    #[inline(always)]
    fn grains(&self, first: u32) -> impl Iterator<Item = (u32, u32)> {
        let pair = self.pair(first);
        [(pair.i, 0), (pair.j, 1)].into_iter()
    }

    #[inline(always)]
    fn key(&self, first: u32, grain: u32, ids: &[u32]) -> u32 {
        ids[self.pair(first).other(grain) as usize]
    }
}

impl Candidate for WallPair {
    #[inline(always)]
    fn grains(&self, _first: u32) -> impl Iterator<Item = (u32, u32)> {
        std::iter::once((self.grain, 0))
    }

    #[inline(always)]
    fn key(&self, _first: u32, _grain: u32, _ids: &[u32]) -> u32 {
        self.wall
    }
}

impl Incidence {
    /// Entries of a grain, in the order of the partner's id.
    #[inline(always)]
    pub(super) fn of(&self, grain: usize) -> impl ExactSizeIterator<Item = Entry> + '_ {
        self.entries[self.range_of(grain)]
            .iter()
            .map(|&bits| Entry::of_bits(bits))
    }

    /// Where the entries of a grain stand.
    #[inline(always)]
    pub(super) fn range_of(&self, grain: usize) -> Range<usize> {
        match self.start.get(grain.wrapping_sub(self.first)..) {
            Some(&[start, end, ..]) => start as usize..end as usize,
            _ => 0..0,
        }
    }

    /// Finds the entries of all grains anew, told how many grains a segment has.
    fn find<C: Candidate>(&mut self, of: (&Table<C>, usize), ids: &[u32], sides: usize) {
        let (table, per_segment) = of;
        let span = table.segments.iter().fold(NOWHERE, |span, segment| {
            (span.0.min(segment.span.0), span.1.max(segment.span.1))
        });
        let within = span.0.min(span.1.saturating_add(1)) as usize..span.1 as usize + 1;
        self.first = within.start;
        self.start.clear();
        self.start.resize(within.len() + 1, 0);
        for_ranges(
            within.start,
            &mut self.start[1..],
            within.len(),
            &|first, counts: &mut [u32]| {
                for (s, segment) in meeting(table, first, counts.len()) {
                    for candidate in &segment.candidates {
                        for (grain, _) in candidate.grains((s * per_segment) as u32) {
                            if let Some(count) = counts.get_mut((grain as usize).wrapping_sub(first)) {
                                *count += 1;
                            }
                        }
                    }
                }
            },
        );
        sums(&mut self.start);
        let entries = sides * table.len();
        if self.entries.capacity() < entries {
            self.entries.clear();
            self.entries.reserve_exact(entries + entries / 16);
        }
        self.entries.resize(entries, 0);
        let places = &mut self.entries[..];
        scatter(
            within.start,
            &mut self.start[1..],
            0,
            places,
            &|first, starts, base, entries| {
                place(of, first, starts, base, entries);
                let mut begin = base;
                let mut long = Vec::new();
                for (grain, &end) in (first as u32..).zip(starts.iter()) {
                    let own = &mut entries[begin - base..end as usize - base];
                    if own.len() <= FEW / 2 {
                        sort_few::<C, { FEW / 2 }>(own, grain, of, ids);
                    } else if own.len() <= FEW {
                        sort_few::<C, FEW>(own, grain, of, ids);
                    } else {
                        sort_many((own, grain), of, ids, &mut long);
                    }
                    begin = end as usize;
                }
            },
        );
    }

    /// Bytes in use.
    fn bytes(&self) -> usize {
        4 * (self.start.capacity() + self.entries.capacity())
    }
}

/// Segments with candidates of any of these grains.
fn meeting<C>(table: &Table<C>, first: usize, count: usize) -> impl Iterator<Item = (usize, &Segment<C>)> {
    let segments = table.segments.iter().enumerate();
    segments.filter(move |(_, s)| (s.span.0 as usize) < first + count && s.span.1 as usize >= first)
}

/// Puts entries where those of their grain begin; the starts end as ends.
fn place<C: Candidate>(
    (table, per_segment): (&Table<C>, usize),
    first: usize,
    starts: &mut [u32],
    base: usize,
    entries: &mut [u32],
) {
    let whole = (first, first + starts.len());
    for chunk in 0..table.chunks() {
        let span = table.span(chunk);
        if span.0 as usize >= whole.1 || (span.1 as usize) < whole.0 {
            continue;
        }
        let first_of_segment = (table.segment_of(chunk) * per_segment) as u32;
        for (slot, candidate) in table.chunk(chunk).0.iter().enumerate() {
            for (grain, side) in candidate.grains(first_of_segment) {
                if let Some(next) = starts.get_mut((grain as usize).wrapping_sub(first)) {
                    entries[*next as usize - base] = Entry::new(chunk, slot, side).bits();
                    *next += 1;
                }
            }
        }
    }
}

#[inline(always)]
fn key<C: Candidate>(bits: u32, grain: u32, (table, per_segment): (&Table<C>, usize), ids: &[u32]) -> u32 {
    let entry = Entry::of_bits(bits);
    let first = (table.segment_of(entry.chunk()) * per_segment) as u32;
    table.candidate(entry).key(first, grain, ids)
}

/// Sorts at most `MOST` by counting: without a branch that depends on what is compared.
#[inline(always)]
fn sort_few<C: Candidate, const MOST: usize>(entries: &mut [u32], grain: u32, of: (&Table<C>, usize), ids: &[u32]) {
    let (mut keys, mut from) = ([u32::MAX; MOST], [0u32; MOST]);
    for ((&bits, place), from) in entries.iter().zip(&mut keys).zip(&mut from) {
        *from = bits;
        *place = key(bits, grain, of, ids);
    }
    for (&bits, &own) in from.iter().zip(&keys).take(entries.len()) {
        let rank: u32 = keys.iter().map(|&other| u32::from(other < own)).sum();
        entries[rank as usize] = bits;
    }
}

fn sort_many<C: Candidate>(
    (entries, grain): (&mut [u32], u32),
    of: (&Table<C>, usize),
    ids: &[u32],
    keyed: &mut Vec<u64>,
) {
    keyed.clear();
    keyed.extend(
        entries
            .iter()
            .map(|&bits| u64::from(key(bits, grain, of, ids)) << 32 | u64::from(bits)),
    );
    keyed.sort_unstable();
    for (entry, keyed) in entries.iter_mut().zip(keyed) {
        *entry = *keyed as u32;
    }
}
