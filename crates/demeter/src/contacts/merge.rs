//! Handing contacts over where all grains kept their places in memory: then the contacts of the old chunks and the candidates of the
//! new ones come in one order, and are merged.

use super::transfer::{Heirs, Transfer, chunks_of_round};
use super::{ContactChunk, Kept};
use crate::particles::Beyond;
use crate::threads::{Divisible, divide};
use std::ops::Range;

/// Where a contact or a candidate stands in the order of the table: segment, law, bodies.
type Key = (usize, u32, (u32, u32));

/// What a chunk takes from an old one.
type Piece<'a> = (&'a ContactChunk, Range<usize>);

/// The old chunks that have contacts.
struct Old<'a, H> {
    chunks: &'a [ContactChunk],
    heirs: &'a H,
}

impl<H: Heirs> Old<'_, H> {
    fn key(&self, chunk: &ContactChunk, contact: usize) -> Key {
        let place = self.heirs.place((chunk.i[contact], chunk.j[contact]));
        (place.0 as usize / self.heirs.grains_per_segment(), chunk.law, place)
    }

    /// The first contact that does not stand before the first candidate of a new chunk: chunk and number; what is behind the last
    /// for what is behind the last.
    fn first_of(&self, new_chunk: usize) -> (usize, usize) {
        if new_chunk == self.heirs.chunks() {
            return (self.chunks.len(), 0);
        }
        let place = self.heirs.place(self.heirs.bodies(new_chunk, 0));
        let segment = place.0 as usize / self.heirs.grains_per_segment();
        let key = (segment, self.heirs.law(new_chunk), place);
        let chunk = (self.chunks).partition_point(|chunk| self.key(chunk, chunk.len() - 1) < key);
        let contact = self.chunks.get(chunk).map_or(0, |old| {
            let (mut from, mut to) = (0, old.len());
            while from < to {
                let middle = from.midpoint(to);
                if self.key(old, middle) < key {
                    from = middle + 1;
                } else {
                    to = middle;
                }
            }
            from
        });
        (chunk, contact)
    }

    /// Contacts that may go on in a new chunk.
    fn pieces(&self, new_chunk: usize) -> impl Iterator<Item = Piece<'_>> + Clone {
        let ((first, start), (last, end)) = (self.first_of(new_chunk), self.first_of(new_chunk + 1));
        (first..(last + 1).min(self.chunks.len())).map(move |k| {
            let chunk = &self.chunks[k];
            let from = if k == first { start } else { 0 };
            let to = if k == last { end } else { chunk.len() };
            (chunk, from..to)
        })
    }
}

/// New chunks that follow each other, told by the number of the first.
struct Chunks<'a>(usize, &'a mut [ContactChunk]);

impl Divisible for Chunks<'_> {
    fn len(&self) -> usize {
        self.1.len()
    }

    fn split(self, first: usize) -> (Self, Self) {
        let (some, others) = self.1.split_at_mut(first);
        (Self(self.0, some), Self(self.0 + first, others))
    }
}

impl Transfer {
    /// Moves all contacts into chunks for new candidates, straight from the old chunks.
    pub(super) fn merge<H: Heirs>(&mut self, chunks: &mut Vec<ContactChunk>, heirs: &H, stride: usize) {
        let count = heirs.chunks();
        let round = chunks_of_round(count);
        for chunk in chunks.drain(..) {
            if chunk.is_empty() {
                self.spare.push(chunk);
            } else {
                self.old.push(chunk);
            }
        }
        let (mut done, mut freed) = (0, 0);
        while done < count {
            let end = (done + round).min(count);
            chunks.extend((done..end).map(|_| self.spare.pop().unwrap_or_default()));
            let old = Old {
                chunks: &self.old[freed..],
                heirs,
            };
            let fill = |Chunks(first, chunks): Chunks| {
                for (k, chunk) in (first..).zip(chunks) {
                    chunk.forget();
                    chunk.law = heirs.law(k);
                    chunk.continue_contacts(&old, k, stride);
                }
            };
            divide(Chunks(done, &mut chunks[done..end]), 1, &fill, &|(), ()| ());
            // the memory of these is free now
            let (next, _) = old.first_of(end);
            self.spare
                .extend(self.old[freed..freed + next].iter_mut().map(std::mem::take));
            freed += next;
            done = end;
        }
    }
}

impl ContactChunk {
    /// Takes the contacts of old chunks that are candidates of this one, the new chunk of a number.
    fn continue_contacts<H: Heirs>(&mut self, old: &Old<H>, number: usize, stride: usize) {
        let heirs = old.heirs;
        let (_, candidates) = heirs.of_chunk(number);
        let place_of = |slot: usize| heirs.place(heirs.bodies(number, slot));
        let most = old.pieces(number).map(|(_, contacts)| contacts.len()).sum();
        self.make_room(most, stride, Beyond::GivenBack);
        let mut slot = 0;
        for (chunk, contacts) in old.pieces(number) {
            // contacts that go on one behind the other are taken over together
            let mut going_on = contacts.start..contacts.start;
            for contact in contacts {
                let place = heirs.place((chunk.i[contact], chunk.j[contact]));
                while slot < candidates && place_of(slot) < place {
                    slot += 1;
                }
                if slot == candidates {
                    break;
                }
                if place_of(slot) != place {
                    continue;
                }
                self.now.candidate.push(slot as u16);
                if going_on.end != contact {
                    self.take_over(chunk, going_on, stride);
                    going_on = contact..contact;
                }
                going_on.end += 1;
            }
            self.take_over(chunk, going_on, stride);
        }
        if heirs.are_walls() {
            self.now.find_starts(candidates);
        }
    }
}

impl Kept {
    /// Notes where the contacts of so many candidates with walls are, told the candidates of all contacts.
    fn find_starts(&mut self, candidates: usize) {
        let mut contact = 0;
        for candidate in 0..candidates as u16 {
            while self.candidate.get(contact) == Some(&candidate) {
                contact += 1;
            }
            self.start.push(contact as u32);
        }
        self.candidate.clear();
    }
}
