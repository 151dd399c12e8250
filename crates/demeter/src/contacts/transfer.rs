//! Handing contacts over when the candidates are found anew.

use super::{CHUNK, ContactChunk, Contacts, WORD};
use crate::neighbours::{Moves, Neighbours};
use crate::particles::Beyond;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

/// No contacts to take over.
const NONE: u32 = u32::MAX;

/// Bits of an heir that tell the place in the old chunk.
const SLOT_BITS: u32 = CHUNK.next_power_of_two().trailing_zeros();

/// Contacts are handed over in so many rounds, after each of which the memory of old chunks is free for new ones.
const ROUNDS: usize = 16;

/// New chunks that one round fills, of so many.
pub(super) fn chunks_of_round(chunks: usize) -> usize {
    chunks.div_ceil(ROUNDS).max(2 * rayon::current_num_threads())
}

/// Contacts while they are handed over.
#[derive(Debug, Default)]
pub(super) struct Transfer {
    /// For every new candidate, the chunk and the place in it of the old one.
    heir: Vec<AtomicU32>,
    /// The last new chunk that takes contacts from every old one; [`NONE`] when its memory is free.
    last_use: Vec<u32>,
    pub(super) old: Vec<ContactChunk>,
    /// Chunks whose memory waits to be used again.
    pub(super) spare: Vec<ContactChunk>,
}

/// New candidates that contacts are handed to.
pub(super) trait Heirs: Sync {
    fn chunks(&self) -> usize;
    fn count(&self) -> usize;
    /// Candidates before a chunk, and in it.
    fn of_chunk(&self, chunk: usize) -> (usize, usize);
    /// Whether the second bodies are walls.
    fn are_walls(&self) -> bool;
    /// Material pair of a chunk.
    fn law(&self, chunk: usize) -> u32;
    /// Bodies of a candidate.
    fn bodies(&self, chunk: usize, slot: usize) -> (u32, u32);
    /// Chunk and number of the candidate of two bodies.
    fn find(&self, i: u32, j: u32) -> Option<(usize, usize)>;
    /// What candidates of one law are sorted by within a segment, told the bodies; the first tells the segment.
    fn place(&self, bodies: (u32, u32)) -> (u32, u32);
    fn grains_per_segment(&self) -> usize;
}

/// Candidates between grains, and where grains went in memory, if they did.
struct Pairs<'a>(&'a Neighbours, Option<&'a Moves>);

/// Candidates of grains and walls, with the same.
struct Walls<'a>(&'a Neighbours, Option<&'a Moves>);

/// New index of a grain, unless it is gone.
#[inline(always)]
fn renumber(moves: Option<&Moves>, grain: u32) -> Option<u32> {
    moves.map_or(Some(grain), |moves| moves.of(grain))
}

impl Heirs for Pairs<'_> {
    fn chunks(&self) -> usize {
        self.0.chunks()
    }

    fn count(&self) -> usize {
        self.0.pair_count()
    }

    fn of_chunk(&self, chunk: usize) -> (usize, usize) {
        (self.0.before_chunk(chunk), self.0.chunk(chunk).0.len())
    }

    fn are_walls(&self) -> bool {
        false
    }

    fn law(&self, chunk: usize) -> u32 {
        self.0.chunk(chunk).1
    }

    #[inline(always)]
    fn bodies(&self, chunk: usize, slot: usize) -> (u32, u32) {
        let pair = self.0.chunk(chunk).0.get(slot);
        (pair.i, pair.j)
    }

    #[inline(always)]
    fn find(&self, i: u32, j: u32) -> Option<(usize, usize)> {
        self.0.find_pair(renumber(self.1, i)?, renumber(self.1, j)?)
    }

    #[inline(always)]
    fn place(&self, (i, j): (u32, u32)) -> (u32, u32) {
        (i.max(j), i.min(j))
    }

    fn grains_per_segment(&self) -> usize {
        self.0.grains_per_segment()
    }
}

impl Heirs for Walls<'_> {
    fn chunks(&self) -> usize {
        self.0.wall_chunks()
    }

    fn count(&self) -> usize {
        self.0.wall_pair_count()
    }

    fn of_chunk(&self, chunk: usize) -> (usize, usize) {
        (self.0.before_wall_chunk(chunk), self.0.wall_chunk(chunk).0.len())
    }

    fn are_walls(&self) -> bool {
        true
    }

    fn law(&self, chunk: usize) -> u32 {
        self.0.wall_chunk(chunk).1
    }

    #[inline(always)]
    fn bodies(&self, chunk: usize, slot: usize) -> (u32, u32) {
        let pair = &self.0.wall_chunk(chunk).0[slot];
        (pair.grain, pair.wall)
    }

    #[inline(always)]
    fn find(&self, grain: u32, wall: u32) -> Option<(usize, usize)> {
        self.0.find_wall_pair(renumber(self.1, grain)?, wall)
    }

    #[inline(always)]
    fn place(&self, bodies: (u32, u32)) -> (u32, u32) {
        bodies
    }

    fn grains_per_segment(&self) -> usize {
        self.0.grains_per_segment()
    }
}

impl Transfer {
    /// Begins with spare chunks.
    fn begin(spare: Vec<ContactChunk>) -> Self {
        Self {
            spare,
            ..Self::default()
        }
    }

    /// Some spare chunks for the next time, with the memory that steps need; that for contacts is worth more until then.
    fn end(mut self, chunks: usize) -> Vec<ContactChunk> {
        self.spare.append(&mut self.old);
        self.spare.truncate(2 * chunks_of_round(chunks));
        for chunk in &mut self.spare {
            chunk.forget();
            chunk.make_room(0, 0, Beyond::GivenBack);
        }
        self.spare
    }

    /// Moves all contacts into chunks for new candidates, straight from the old chunks, wherever grains went in between.
    fn look_up(&mut self, chunks: &mut Vec<ContactChunk>, heirs: &impl Heirs, stride: usize) {
        std::mem::swap(chunks, &mut self.old);
        self.find_heirs(heirs);
        let count = heirs.chunks();
        let round = chunks_of_round(count);
        let mut done = 0;
        while done < count {
            let end = (done + round).min(count);
            chunks.extend((done..end).map(|_| self.spare.pop().unwrap_or_default()));
            let (old, heir) = (&self.old, &self.heir);
            (chunks[done..end].par_iter_mut().enumerate()).for_each(|(k, chunk)| {
                let (before, candidates) = heirs.of_chunk(done + k);
                chunk.forget();
                chunk.law = heirs.law(done + k);
                let inherited = |heir: &AtomicU32| {
                    let from = heir.load(Ordering::Relaxed);
                    (from != NONE).then(|| contacts_from(old, from))
                };
                let mine = &heir[before..before + candidates];
                let contacts = mine.iter().filter_map(inherited).map(|(_, contacts)| contacts.len());
                chunk.make_room(contacts.sum(), stride, Beyond::GivenBack);
                for (slot, heir) in mine.iter().enumerate() {
                    if let Some((old, contacts)) = inherited(heir) {
                        let (i, j) = heirs.bodies(done + k, slot);
                        let first = chunk.len();
                        chunk.take_over(old, contacts, stride);
                        chunk.i[first..].fill(i);
                        chunk.j[first..].fill(j);
                    }
                    chunk.end_candidate(slot, heirs.are_walls());
                }
            });
            self.free_chunks(end);
            done = end;
        }
    }

    /// Finds for every new candidate the old one with its contacts. Contacts whose bodies are no candidates end.
    fn find_heirs(&mut self, heirs: &impl Heirs) {
        self.heir.resize_with(heirs.count(), AtomicU32::default);
        self.heir.par_iter_mut().for_each(|heir| *heir.get_mut() = NONE);
        self.last_use.clear();
        self.last_use.resize(self.old.len(), 0);
        let heir = &self.heir;
        (self.old.par_iter().zip(&mut self.last_use).enumerate()).for_each(|(number, (chunk, last_use))| {
            for (slot, Range { start: contact, .. }) in chunk.now.of_candidates() {
                if let Some((new_chunk, candidate)) = heirs.find(chunk.i[contact], chunk.j[contact]) {
                    let place = (number << SLOT_BITS | slot) as u32;
                    heir[candidate].store(place, Ordering::Relaxed);
                    *last_use = (*last_use).max(new_chunk as u32);
                }
            }
        });
    }

    /// Frees the memory of old chunks that no new chunk from `end` on needs.
    fn free_chunks(&mut self, end: usize) {
        for (chunk, last_use) in self.old.iter_mut().zip(&mut self.last_use) {
            if *last_use != NONE && (*last_use as usize) < end {
                self.spare.push(std::mem::take(chunk));
                *last_use = NONE;
            }
        }
    }
}

/// The old chunk and its contacts that an heir names.
#[inline(always)]
fn contacts_from(old: &[ContactChunk], from: u32) -> (&ContactChunk, Range<usize>) {
    let chunk = &old[(from >> SLOT_BITS) as usize];
    (chunk, chunk.contacts_of(from as usize & ((1 << SLOT_BITS) - 1)))
}

impl ContactChunk {
    /// Ends the contacts of one candidate, told its number.
    pub(super) fn end_candidate(&mut self, slot: usize, walls: bool) {
        let contacts = self.now.len();
        if walls {
            self.now.start.push(contacts as u32);
        } else {
            self.now.candidate.resize(contacts, slot as u16);
        }
    }

    /// Appends contacts of an old chunk, with all that can be asked of them after a step.
    pub(super) fn take_over(&mut self, old: &Self, contacts: Range<usize>, stride: usize) {
        let first = self.len();
        self.i.extend_from_slice(&old.i[contacts.clone()]);
        self.j.extend_from_slice(&old.j[contacts.clone()]);
        if !old.rolling.is_empty() {
            self.rolling.take_over(first, &old.rolling, contacts.clone());
        }
        let (now, before) = (&mut self.now, &old.now);
        now.element
            .extend(before.element.get(contacts.clone()).into_iter().flatten());
        now.geometry
            .extend(before.geometry.get(contacts.clone()).into_iter().flatten());
        now.take_on(before, contacts.clone(), stride);
        now.tangential.take_over(first, &before.tangential, contacts.clone());
        if !old.engaged.is_empty() {
            self.engaged.resize(self.now.len().div_ceil(WORD), 0);
            for (place, contact) in (first..).zip(contacts) {
                self.engaged[place / WORD] |= u64::from(old.is_engaged(contact)) << (place % WORD);
            }
        }
    }
}

impl Contacts {
    /// Hands all contacts over to new candidates, told where grains went in memory, if they did.
    pub(crate) fn hand_over(&mut self, neighbours: &Neighbours, moves: Option<&Moves>) {
        let stride = self.stride;
        let (pairs, walls) = (Pairs(neighbours, moves), Walls(neighbours, moves));
        let [mut of_pairs, mut of_walls] = std::mem::take(&mut self.spare).map(Transfer::begin);
        if moves.is_some() {
            of_pairs.look_up(&mut self.pairs, &pairs, stride);
            of_walls.look_up(&mut self.walls, &walls, stride);
        } else {
            of_pairs.merge(&mut self.pairs, &pairs, stride);
            of_walls.merge(&mut self.walls, &walls, stride);
        }
        self.spare = [of_pairs.end(self.pairs.len()), of_walls.end(self.walls.len())];
    }
}
