//! The table of candidates: cut into chunks of one law each.

use super::WallPair;
use crate::particles::{Beyond, make_room, set_aside};
use serde::{Deserialize, Serialize};

/// Most candidates of one chunk.
pub const CHUNK: usize = 2048;

const SLOT_BITS: u32 = 11;
const _: () = assert!(CHUNK <= 1 << SLOT_BITS);

/// Which candidate a grain has, and on which side of it the grain is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Entry(u32);

impl Entry {
    #[inline(always)]
    pub(super) fn new(chunk: usize, slot: usize, side: u32) -> Self {
        Self((chunk as u32) << (SLOT_BITS + 1) | (slot as u32) << 1 | side)
    }

    #[inline(always)]
    pub(super) fn of_bits(bits: u32) -> Self {
        Self(bits)
    }

    #[inline(always)]
    pub(super) fn bits(self) -> u32 {
        self.0
    }

    #[inline(always)]
    pub(super) fn chunk(self) -> usize {
        (self.0 >> (SLOT_BITS + 1)) as usize
    }

    #[inline(always)]
    pub(super) fn slot(self) -> usize {
        (self.0 >> 1) as usize & ((1 << SLOT_BITS) - 1)
    }

    /// Whether the grain is the candidate's first.
    #[inline(always)]
    pub(super) fn is_first(self) -> bool {
        self.0 & 1 == 0
    }
}

/// A stretch of candidates of one law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Run {
    pub(super) law: u32,
    /// Where it ends in its segment.
    pub(super) end: u32,
}

/// Candidates that are found and summed up together, by law; within a law they keep the order in which they were given.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Segment<C> {
    pub(super) candidates: Vec<C>,
    pub(super) runs: Vec<Run>,
    /// Lowest and highest index of the grains in it.
    pub(super) span: (u32, u32),
}

impl<C> Default for Segment<C> {
    fn default() -> Self {
        Self {
            candidates: Vec::new(),
            runs: Vec::new(),
            span: NOWHERE,
        }
    }
}

/// Span of no grain.
pub(super) const NOWHERE: (u32, u32) = (u32::MAX, 0);

impl<C: Copy> Segment<C> {
    /// Those of the candidates that are wanted; [`Table::cut`] comes after it.
    pub(super) fn picked(&self, wanted: impl Fn(&C) -> bool) -> Self {
        let mut picked = Self::default();
        let mut start = 0;
        for run in &self.runs {
            let candidates = &self.candidates[start..run.end as usize];
            picked.candidates.extend(candidates.iter().copied().filter(&wanted));
            let end = picked.candidates.len() as u32;
            if picked.runs.last().map_or(0, |before| before.end) < end {
                picked.runs.push(Run { law: run.law, end });
            }
            start = run.end as usize;
        }
        picked
    }

    /// Takes what was found with its laws, in memory that it has wherever that is enough.
    pub(super) fn fill(&mut self, found: &[C], laws: &[u32], order: &mut LawOrder) {
        self.candidates.clear();
        self.runs.clear();
        make_room(&mut self.candidates, found.len(), Beyond::GivenBack);
        let Some(&law) = laws.first() else { return };
        if laws.iter().all(|&other| other == law) {
            self.candidates.extend_from_slice(found);
            let end = found.len() as u32;
            self.runs.push(Run { law, end });
            return;
        }
        order.sort(laws);
        for &law in &order.seen {
            let end = order.next[law as usize];
            self.runs.push(Run { law, end });
        }
        self.candidates.extend(order.places.iter().map(|&k| found[k as usize]));
        order.forget();
    }

    /// Candidates of each law, with the place of the first.
    pub(super) fn by_law(&self) -> impl Iterator<Item = (usize, &[C])> {
        let ends = self.runs.iter().map(|run| run.end as usize);
        let starts = std::iter::once(0).chain(ends.clone());
        starts
            .zip(ends)
            .map(|(start, end)| (start, &self.candidates[start..end]))
    }

    /// The place of the candidate with this key, by which those of each law are sorted.
    pub(super) fn find<K: Ord>(&self, wanted: &K, key: impl Fn(&C) -> K) -> Option<u32> {
        self.by_law().find_map(|(start, candidates)| {
            let place = candidates.binary_search_by_key(wanted, &key).ok()?;
            Some((start + place) as u32)
        })
    }
}

/// Memory for sorting candidates by their laws.
#[derive(Clone, Debug, Default)]
pub(super) struct LawOrder {
    /// Number of candidates of every law, then where the next of them goes; 0 for laws not seen.
    next: Vec<u32>,
    seen: Vec<u32>,
    places: Vec<u32>,
}

impl LawOrder {
    /// Finds the order by law; candidates of one law keep theirs. `next` ends as the ends of the laws.
    fn sort(&mut self, laws: &[u32]) {
        for &law in laws {
            if law as usize >= self.next.len() {
                self.next.resize(law as usize + 1, 0);
            }
            if self.next[law as usize] == 0 {
                self.seen.push(law);
            }
            self.next[law as usize] += 1;
        }
        self.seen.sort_unstable();
        let mut begin = 0;
        for &law in &self.seen {
            begin += std::mem::replace(&mut self.next[law as usize], begin);
        }
        self.places.resize(laws.len(), 0);
        for (k, &law) in laws.iter().enumerate() {
            let next = &mut self.next[law as usize];
            self.places[*next as usize] = k as u32;
            *next += 1;
        }
    }

    fn forget(&mut self) {
        for law in self.seen.drain(..) {
            self.next[law as usize] = 0;
        }
    }
}

/// Where a chunk lies.
#[derive(Clone, Copy, Debug)]
struct Place {
    segment: u32,
    start: u32,
    end: u32,
    law: u32,
    /// Candidates in the chunks before it.
    before: u32,
}

/// Candidates, cut into chunks.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct Table<C> {
    pub(super) segments: Vec<Segment<C>>,
    #[serde(skip)]
    places: Vec<Place>,
    /// The first chunk of every segment, and the number of all chunks.
    #[serde(skip)]
    first_chunks: Vec<u32>,
    #[serde(skip)]
    count: usize,
}

impl<C> Default for Table<C> {
    fn default() -> Self {
        Self {
            segments: Vec::new(),
            places: Vec::new(),
            first_chunks: vec![0],
            count: 0,
        }
    }
}

impl Table<WallPair> {
    /// Cuts the segments into chunks: those of a grain with one law lie in one.
    pub(super) fn cut_by_grain(&mut self) {
        self.cut_into(CHUNK - CHUNK / 4, |a, b| a.grain == b.grain);
    }
}

impl<C> Table<C> {
    /// Cuts the segments into chunks: every run of one law into pieces of even length.
    pub(super) fn cut(&mut self) {
        self.cut_into(CHUNK, |_, _| false);
    }

    /// The same, into pieces of some candidates at most where those of a run are too many for one, and of so many more as belong together, as
    /// far as there is room.
    fn cut_into(&mut self, most: usize, belong_together: impl Fn(&C, &C) -> bool) {
        self.places.clear();
        self.first_chunks.clear();
        self.first_chunks.push(0);
        let mut before = 0;
        for (segment, content) in self.segments.iter().enumerate() {
            let mut start = 0;
            for run in &content.runs {
                let count = (run.end - start) as usize;
                let pieces = if count <= CHUNK { 1 } else { count.div_ceil(most) as u32 };
                for piece in (1..=pieces).rev() {
                    let mut end = start + (run.end - start).div_ceil(piece);
                    let at_end = |end: u32| &content.candidates[end as usize - 1..=end as usize];
                    while end < run.end
                        && ((end - start) as usize) < CHUNK
                        && matches!(at_end(end), [a, b] if belong_together(a, b))
                    {
                        end += 1;
                    }
                    self.places.push(Place {
                        segment: segment as u32,
                        start,
                        end,
                        law: run.law,
                        before,
                    });
                    before += end - start;
                    start = end;
                }
            }
            self.first_chunks.push(self.places.len() as u32);
        }
        self.count = before as usize;
    }

    /// A table of segments, not cut yet.
    pub(super) fn of_segments(segments: Vec<Segment<C>>) -> Self {
        Self {
            segments,
            ..Self::default()
        }
    }

    /// Without what [`Table::cut`] finds again.
    pub(super) fn saved(&self) -> Self
    where
        C: Clone,
    {
        Self {
            segments: self.segments.clone(),
            ..Self::default()
        }
    }

    /// Number of chunks.
    pub(super) fn chunks(&self) -> usize {
        self.places.len()
    }

    /// Chunks of a segment.
    pub(super) fn chunks_of(&self, segment: usize) -> std::ops::Range<usize> {
        self.first_chunks[segment] as usize..self.first_chunks[segment + 1] as usize
    }

    /// Chunk of a candidate of a segment, and its place in it.
    #[inline(always)]
    pub(super) fn chunk_and_slot(&self, segment: usize, candidate: u32) -> (usize, usize) {
        let chunks = self.chunks_of(segment);
        let of_segment = &self.places[chunks.clone()];
        let before = of_segment.iter().take_while(|place| place.end <= candidate).count();
        (chunks.start + before, (candidate - of_segment[before].start) as usize)
    }

    /// Number of candidates.
    pub(super) fn len(&self) -> usize {
        self.count
    }

    /// Candidates of a chunk, and their law.
    #[inline(always)]
    pub(super) fn chunk(&self, chunk: usize) -> (&[C], u32) {
        let place = &self.places[chunk];
        let candidates = &self.segments[place.segment as usize].candidates;
        (&candidates[place.start as usize..place.end as usize], place.law)
    }

    /// The segment of a chunk.
    #[inline(always)]
    pub(super) fn segment_of(&self, chunk: usize) -> usize {
        self.places[chunk].segment as usize
    }

    /// Candidates in the chunks before one.
    #[inline(always)]
    pub(super) fn before(&self, chunk: usize) -> usize {
        self.places[chunk].before as usize
    }

    /// Lowest and highest index of the grains in the segment of a chunk.
    pub(super) fn span(&self, chunk: usize) -> (u32, u32) {
        self.segments[self.places[chunk].segment as usize].span
    }

    #[inline(always)]
    pub(super) fn candidate(&self, entry: Entry) -> &C {
        let place = &self.places[entry.chunk()];
        &self.segments[place.segment as usize].candidates[place.start as usize + entry.slot()]
    }

    /// Whether runs cover all candidates and name laws that exist, as they do unless a file was tampered with.
    pub(super) fn is_whole(&self, laws: usize) -> bool {
        self.segments.iter().all(|segment| {
            let mut start = 0;
            segment.runs.iter().all(|run| {
                let fits = run.end > start && (run.law as usize) < laws;
                start = run.end;
                fits
            }) && start as usize == segment.candidates.len()
        })
    }

    /// Bytes in use.
    pub(super) fn bytes(&self) -> usize {
        self.segments.iter().map(|s| set_aside(&s.candidates)).sum::<usize>()
            + self.segments.capacity() * size_of::<Segment<C>>()
            + self.places.capacity() * size_of::<Place>()
    }
}
