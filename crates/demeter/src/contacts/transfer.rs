//! Handing contacts over when the candidates are found anew, and to and from a checkpoint.

use super::coupling::Coupled;
use super::{CHUNK, ContactChunk, Contacts, WORD};
use crate::comm::together::Together;
use crate::neighbours::{Moves, Neighbours};
use crate::particles::{Beyond, Grains};
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use glam::DVec3;
use rayon::prelude::*;
use serde::ser::SerializeSeq;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;
use std::fmt::{Debug, Formatter};
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

/// What a contact is, whatever the order of the grains: lower id, partner's id (or index of the wall), element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct ContactKey {
    /// Whether the partner is a wall.
    pub wall: bool,
    /// Id of the first grain.
    pub grain: u32,
    /// Id of the second grain, or index of the wall.
    pub partner: u32,
    /// Element of the wall.
    pub element: u32,
}

/// A contact as a checkpoint holds it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CarriedContact {
    /// Identity.
    pub key: ContactKey,
    /// Geometry, where it is not found from the places of the grains again.
    pub geometry: Option<Box<Contact>>,
    /// Whether it is engaged, and not merely near.
    pub is_engaged: bool,
    /// Normal force [N].
    pub normal_force: f64,
    /// Force on the first body in the contact plane [N].
    pub tangential: DVec3,
    /// Torque of the rolling law on the first body [N m].
    pub rolling: Option<Box<DVec3>>,
    /// History of its laws.
    pub history: Box<[f64]>,
    /// What it remembers of the displacements by the other contacts, where contacts feel each other.
    pub coupling: Option<Box<Coupled>>,
}

/// Contacts of a checkpoint, by rising keys.
#[derive(Clone)]
pub enum CarriedContacts<'a> {
    /// Those of a run, made one by one as they are written.
    Present(PresentContacts<'a>),
    /// Those that were read.
    Read(Vec<CarriedContact>),
}

/// Contacts of a run, by rising keys.
#[derive(Clone)]
pub struct PresentContacts<'a> {
    /// All that this process has.
    contacts: &'a Contacts,
    /// The chunks of its own, those with walls behind the others, and their places there.
    places: Vec<(ContactKey, u32, u32)>,
    /// Who has the others.
    together: Together<'a>,
    /// Number of all.
    count: usize,
}

impl CarriedContacts<'_> {
    /// Number of contacts.
    pub fn len(&self) -> usize {
        match self {
            Self::Present(present) => present.count,
            Self::Read(contacts) => contacts.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Those that this process has, by rising keys.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Cow<'_, CarriedContact>> {
        self.behind(0)
    }

    /// Those from a key on.
    fn iter_from(&self, first: ContactKey) -> impl ExactSizeIterator<Item = Cow<'_, CarriedContact>> {
        self.behind(match self {
            Self::Present(present) => present.places.partition_point(|(key, ..)| *key < first),
            Self::Read(contacts) => contacts.partition_point(|contact| contact.key < first),
        })
    }

    fn behind(&self, first: usize) -> impl ExactSizeIterator<Item = Cow<'_, CarriedContact>> {
        let end = match self {
            Self::Present(present) => present.places.len(),
            Self::Read(contacts) => contacts.len(),
        };
        (first..end).map(|k| match self {
            Self::Present(present) => {
                let (key, chunk, place) = present.places[k];
                Cow::Owned(present.contacts.carried(key, chunk as usize, place as usize))
            }
            Self::Read(contacts) => Cow::Borrowed(&contacts[k]),
        })
    }
}

impl Debug for CarriedContacts<'_> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> std::fmt::Result {
        formatter.debug_list().entries(self.iter()).finish()
    }
}

impl Serialize for CarriedContacts<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Present(present) => {
                let mut list = serializer.serialize_seq(Some(present.count))?;
                let mut all = present
                    .together
                    .merged(self.iter().map(Cow::into_owned), |contact| contact.key);
                all.try_for_each(|contact| list.serialize_element(&contact))?;
                list.end()
            }
            Self::Read(contacts) => contacts.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for CarriedContacts<'_> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Self::Read(Vec::deserialize(deserializer)?))
    }
}

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

    /// Appends a contact of a checkpoint.
    fn restore(&mut self, contact: &CarriedContact, (i, j): (u32, u32), stride: usize) {
        self.i.push(i);
        self.j.push(j);
        if let Some(rolling) = &contact.rolling {
            let place = self.len();
            self.rolling.resize(place + 1);
            self.rolling.put(place, **rolling);
        }
        let now = &mut self.now;
        if contact.key.wall {
            now.element.push(contact.key.element);
        }
        now.geometry.extend(contact.geometry.as_deref());
        now.push_force(contact.normal_force, contact.tangential);
        let history = contact.history.iter().copied();
        now.history.extend(history.chain(std::iter::repeat(0.0)).take(stride));
        now.coupling.extend(contact.coupling.as_deref());
        if contact.coupling.is_none() {
            self.note_engaged(contact.is_engaged);
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

    /// All contacts, by rising keys.
    pub fn carry(&self, grains: &Grains) -> CarriedContacts<'_> {
        self.carry_some((0..self.pairs.len(), 0..self.walls.len()), grains, Together::ALONE)
    }

    /// The contacts of some chunks, between grains and with walls; other processes have the others.
    pub(crate) fn carry_some<'a>(
        &'a self,
        (pairs, walls): (Range<usize>, Range<usize>),
        grains: &Grains,
        together: Together<'a>,
    ) -> CarriedContacts<'a> {
        let walls = walls.start + self.pairs.len()..walls.end + self.pairs.len();
        let numbers = || pairs.clone().chain(walls.clone());
        let mut places = Vec::with_capacity(numbers().map(|number| self.any_chunk(number).len()).sum());
        for number in numbers() {
            let wall = number >= self.pairs.len();
            let (chunk, number) = (self.any_chunk(number), number as u32);
            for k in 0..chunk.len() {
                let key = ContactKey {
                    wall,
                    grain: grains.id[chunk.i[k] as usize],
                    partner: if wall {
                        chunk.j[k]
                    } else {
                        grains.id[chunk.j[k] as usize]
                    },
                    element: chunk.element(k),
                };
                places.push((key, number, k as u32));
            }
        }
        places.par_sort_unstable();
        CarriedContacts::Present(PresentContacts {
            contacts: self,
            count: together.count(places.len()),
            places,
            together,
        })
    }

    /// A chunk, where those with walls are behind the others.
    fn any_chunk(&self, number: usize) -> &ContactChunk {
        match number.checked_sub(self.pairs.len()) {
            Some(chunk) => &self.walls[chunk],
            None => &self.pairs[number],
        }
    }

    /// A contact, told its chunk and its place there.
    fn carried(&self, key: ContactKey, chunk: usize, place: usize) -> CarriedContact {
        let chunk = self.any_chunk(chunk);
        CarriedContact {
            key,
            geometry: chunk.now.geometry.get(place).copied().map(Box::new),
            is_engaged: chunk.is_engaged(place),
            normal_force: chunk.normal_force(place),
            tangential: chunk.tangential_force(place),
            rolling: (!chunk.rolling.is_empty()).then(|| Box::new(chunk.rolling_torque(place))),
            history: chunk.history(place, self.stride).into(),
            coupling: chunk.now.coupling.get(place).copied().map(Box::new),
        }
    }

    /// Makes chunks for candidates with the contacts of a checkpoint, sorted by their keys, as if a step had just ended with
    /// them: all that can be asked of a contact after a step can be asked now.
    pub fn adopt(&mut self, grains: &Grains, neighbours: &Neighbours, carried: &CarriedContacts) {
        let stride = self.stride;
        let key = |wall, i: u32, partner| ContactKey {
            wall,
            grain: grains.id[i as usize],
            partner,
            element: 0,
        };
        refill(&mut self.pairs, &Pairs(neighbours, None), |(i, j), chunk| {
            remember(carried, key(false, i, grains.id[j as usize]), (i, j), stride, chunk);
        });
        refill(&mut self.walls, &Walls(neighbours, None), |(i, j), chunk| {
            remember(carried, key(true, i, j), (i, j), stride, chunk);
        });
    }
}

/// Fills chunks for candidates; they keep the memory that they have.
fn refill(chunks: &mut Vec<ContactChunk>, heirs: &impl Heirs, fill: impl Fn((u32, u32), &mut ContactChunk)) {
    chunks.resize_with(heirs.chunks(), ContactChunk::default);
    for (number, chunk) in chunks.iter_mut().enumerate() {
        chunk.forget();
        chunk.law = heirs.law(number);
        for slot in 0..heirs.of_chunk(number).1 {
            fill(heirs.bodies(number, slot), chunk);
            chunk.end_candidate(slot, heirs.are_walls());
        }
    }
}

/// Appends the contacts of a grain and a partner in a checkpoint, from `first` on, whatever their elements.
fn remember(carried: &CarriedContacts, first: ContactKey, bodies: (u32, u32), stride: usize, chunk: &mut ContactChunk) {
    let same = |key: ContactKey| key.wall == first.wall && key.grain == first.grain && key.partner == first.partner;
    for contact in carried.iter_from(first).take_while(|contact| same(contact.key)) {
        chunk.restore(&contact, bodies, stride);
    }
}
