//! Active contacts: the central table of the engine.
//!
//! Candidates are cut into chunks of one law. A chunk owns its contacts (struct of arrays), is handled by one task
//! and keeps its own sums, so nothing depends on the number of threads. Within a step a chunk goes through
//!
//! 1. [`narrow`]: candidates -> contacts that may act; every few steps, or in every step where contacts feel each other
//! 2. [`coupling`], where contacts feel each other: displacements of the surfaces
//! 3. `respond`: which contacts act, and their laws, several contacts at a time
//!
//! and [`sum`] then adds up per grain, in the order of the partners in memory.

mod asking;
mod at_walls;
mod bodies;
mod carried;
pub mod coupling;
mod evaluate;
mod fault;
mod impacts;
mod kinematics;
pub mod laws;
mod leaving;
mod look_again;
mod marks;
mod meetings;
mod merge;
pub mod narrow;
mod near;
mod near_triangles;
mod rare;
mod respond;
mod saved;
mod seams;
mod shares;
pub(crate) mod step_work;
pub mod sum;
mod together;
mod told;
mod transfer;
mod wall_contacts;

pub(crate) use asking::Span;
pub use at_walls::Surfaces;
pub use carried::{CarriedContact, ContactKey};
pub use coupling::Coupling;
pub(crate) use fault::WHY_OUTSIDE;
pub use fault::{Departure, Fault};
pub(crate) use fault::{SOLID_BEHIND, TWO_SIDES};
pub(crate) use impacts::{Impact, Struck};
pub(crate) use leaving::{PairsAndWalls, grains_in};
pub use narrow::Scene;
pub(crate) use near::Approach;
pub use near::NearTables;
pub(crate) use saved::SavedContacts;

pub use crate::neighbours::CHUNK;

use crate::particles::{Beyond, Load, make_room, set_aside};
use crate::walls::Mark;
use coupling::{Coupled, Scratch};
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use evaluate::WORD;
use glam::DVec3;
use rare::{Rare, begins_empty};
use respond::Lost;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use told::Told;
use wall_contacts::Touched;

/// Work of the contact forces in one step [J], and what is needed to watch a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Tally {
    /// Dissipated by normal dashpots.
    pub viscous: f64,
    /// Lost by normal laws otherwise: plastic work, tear-off of adhesive contacts.
    pub plastic: f64,
    /// Dissipated by friction.
    pub friction: f64,
    /// Dissipated by rolling resistance.
    pub rolling: f64,
    /// Done on the grains by moving walls.
    pub wall_work: f64,
    /// Put into the stored energy by multi-contact displacements without work of the contacts; negative where they took
    /// it out.
    pub multi_contact: f64,
}

impl Tally {
    /// Adds another tally.
    pub fn add(&mut self, other: &Self) {
        self.viscous += other.viscous;
        self.plastic += other.plastic;
        self.friction += other.friction;
        self.rolling += other.rolling;
        self.wall_work += other.wall_work;
        self.multi_contact += other.multi_contact;
    }
}

/// How many contacts lie together where numbers are kept component by component, or summed up in as many sums: the same for all
/// instructions, a multiple of the lanes of every register.
pub(crate) const EIGHT: usize = 8;

/// What survives of a contact from one step to the next.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Kept {
    /// Contacts of candidate `c` of a chunk with walls: `start[c]..start[c + 1]`.
    pub(crate) start: Vec<u32>,
    /// Candidate of every contact between grains: each has at most one.
    pub(crate) candidate: Vec<u16>,
    /// Number of the contact of every candidate between grains, from 1, 0 where it is none: where it is often asked for, as contacts feel
    /// each other.
    place: Vec<u16>,
    /// Element of the wall that is touched; empty between grains.
    pub(crate) element: Vec<u32>,
    /// Geometry; between grains whose contacts do not feel each other only while forces are found.
    pub(crate) geometry: Vec<Contact>,
    /// Normal force on the first body along the normal, rounded to single precision [N].
    pub(crate) normal_force: Vec<f32>,
    /// Force on the first body in the contact plane [N].
    pub(crate) tangential: Told,
    /// History of the laws, `stride` values per contact.
    pub(crate) history: Vec<f64>,
    /// What contacts that feel each other remember; empty where all are independent.
    pub(crate) coupling: Vec<Coupled>,
}

begins_empty!(Kept);

impl Kept {
    fn clear(&mut self) {
        self.start.clear();
        self.start.push(0);
        self.place.clear();
        self.candidate.clear();
        self.element.clear();
        self.geometry.clear();
        self.normal_force.clear();
        self.tangential.clear();
        self.history.clear();
        self.coupling.clear();
    }

    fn len(&self) -> usize {
        self.normal_force.len()
    }

    /// Appends the forces of a contact: along the normal, and in the contact plane [N].
    fn push_force(&mut self, normal: f64, tangential: DVec3) {
        let place = self.len();
        self.normal_force.push(normal as f32);
        self.tangential.resize(self.len());
        self.tangential.put(place, tangential);
    }

    /// What a contact remembers.
    fn history_of(&self, contact: usize, stride: usize) -> &[f64] {
        &self.history[contact * stride..(contact + 1) * stride]
    }

    /// Appends contacts of the step before, but for their forces in the contact plane.
    fn take_on(&mut self, before: &Self, contacts: Range<usize>, stride: usize) {
        let history = contacts.start * stride..contacts.end * stride;
        self.coupling
            .extend(before.coupling.get(contacts.clone()).into_iter().flatten());
        self.normal_force.extend_from_slice(&before.normal_force[contacts]);
        self.history.extend_from_slice(&before.history[history]);
    }

    /// Appends a contact that begins, but for its force in the contact plane.
    fn begin_contact(&mut self, stride: usize, is_coupled: bool) {
        if is_coupled {
            self.coupling.push(Coupled::default());
        }
        self.normal_force.push(0.0);
        self.history.resize(self.history.len() + stride, 0.0);
    }

    /// Lets no contact have a force in the contact plane.
    fn clear_tangential(&mut self) {
        self.tangential.clear();
        self.tangential.resize(self.len());
    }

    /// Notes where the contacts of so many candidates between grains are.
    fn note_places(&mut self, candidates: usize) {
        self.place.clear();
        self.place.resize(candidates, 0);
        for (contact, &candidate) in (1..).zip(&self.candidate) {
            self.place[usize::from(candidate)] = contact;
        }
    }

    /// Copies contacts between grains that do not feel each other.
    fn copy(&mut self, other: &Self, stride: usize) {
        self.clear();
        self.make_room(other.len(), stride, Beyond::Kept);
        self.candidate.extend_from_slice(&other.candidate);
        self.normal_force.extend_from_slice(&other.normal_force);
        self.tangential.copy(&other.tangential);
        self.history.extend_from_slice(&other.history);
    }

    /// Sets memory aside for so many contacts where there is none.
    fn make_room(&mut self, contacts: usize, stride: usize, beyond: Beyond) {
        make_room(&mut self.candidate, contacts, beyond);
        make_room(&mut self.normal_force, contacts, beyond);
        self.tangential.make_room(contacts, beyond);
        make_room(&mut self.history, contacts * stride, beyond);
    }

    /// The contact of a candidate between grains that feels others.
    #[inline(always)]
    pub(crate) fn contact_of(&self, candidate: usize) -> usize {
        usize::from(self.place[candidate]).wrapping_sub(1)
    }

    pub(crate) fn range(&self, candidate: usize) -> Range<usize> {
        if let Some(&place) = self.place.get(candidate) {
            usize::from(place).saturating_sub(1)..usize::from(place)
        } else if self.start.len() > candidate + 1 {
            self.start[candidate] as usize..self.start[candidate + 1] as usize
        } else {
            match self.candidate.binary_search(&(candidate as u16)) {
                Ok(place) => place..place + 1,
                Err(_) => 0..0,
            }
        }
    }

    /// Candidates that have contacts, each with these.
    fn of_candidates(&self) -> impl Iterator<Item = (usize, Range<usize>)> + '_ {
        let at_walls =
            (self.start.windows(2).enumerate()).map(|(slot, ends)| (slot, ends[0] as usize..ends[1] as usize));
        let of_pairs = (self.candidate.iter().enumerate()).map(|(place, &slot)| (usize::from(slot), place..place + 1));
        at_walls.filter(|(_, contacts)| !contacts.is_empty()).chain(of_pairs)
    }
}

/// Contacts of one chunk of candidates. Other processes are told what can be asked of it after a step.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct ContactChunk {
    pub(crate) now: Kept,
    #[serde(skip)]
    pub(crate) before: Rare<Kept>,
    /// Whether a contact of the step before goes on.
    #[serde(skip)]
    pub(crate) goes_on: Vec<bool>,
    /// Whether some contact began or ended in this step, where contacts feel each other.
    #[serde(skip)]
    pub(crate) is_renewed: bool,
    #[serde(skip)]
    touched: Rare<Touched>,
    #[serde(skip)]
    pub(crate) coupling: Rare<Scratch>,
    /// The material pair of all contacts.
    pub(crate) law: u32,
    /// Index of the first grain.
    pub i: Vec<u32>,
    /// Index of the second grain, or of the wall.
    pub j: Vec<u32>,
    /// Code of the shift across periodic sides, where there are any; found from the candidates when needed.
    #[serde(skip)]
    shift: Vec<u8>,
    /// Bits of the contacts that are engaged, a word for each block; empty where all are.
    engaged: Vec<u64>,
    /// Torque of the rolling laws on the first body [N m]; empty where no law resists rolling.
    pub(crate) rolling: Told,
    /// Work of this step.
    #[serde(skip)]
    pub tally: Tally,
    /// Force and torque on every wall (torque about its origin), for chunks of wall contacts.
    #[serde(skip)]
    pub wall_load: Vec<(DVec3, DVec3)>,
    /// What of it springs do to walls that move with servos; empty where none does.
    #[serde(skip)]
    pub(crate) wall_springs: Vec<(DVec3, DVec3)>,
    /// What every contact lost in this step, and what that did to the walls: where walls record it.
    #[serde(skip)]
    losses: Vec<Lost>,
    /// Normal forces that do not depend on the rate [N], where contacts feel each other or walls move with servos.
    #[serde(skip)]
    elastic: Vec<f64>,
    /// What every wall feels, while contacts are summed up.
    #[serde(skip)]
    felt: Vec<Load>,
    #[serde(skip)]
    pub(crate) marks: Vec<Mark>,
    /// Contacts that began in this step, where somebody asks.
    #[serde(skip)]
    pub(crate) impacts: Vec<Impact>,
    /// The fault with the lowest id, if any.
    #[serde(skip)]
    pub fault: Option<Box<Fault>>,
    /// Force of the contacts across periodic sides on their first bodies, times the boxes to the image of the second, by
    /// direction [N]; only where the box deforms.
    #[serde(skip)]
    across: [DVec3; 3],
}

impl ContactChunk {
    /// Forgets all contacts and all of their work.
    fn forget(&mut self) {
        self.now.clear();
        self.before.if_there().into_iter().for_each(Kept::clear);
        self.touched.if_there().into_iter().for_each(Touched::forget);
        self.coupling.if_there().into_iter().for_each(|c| c.size.clear());
        self.i.clear();
        self.j.clear();
        self.shift.clear();
        self.engaged.clear();
        self.rolling.clear();
        self.tally = Tally::default();
        self.wall_load.clear();
        self.wall_springs.clear();
        self.marks.clear();
        self.impacts.clear();
        self.fault = None;
        self.across = [DVec3::ZERO; 3];
    }

    /// Sets memory aside for the contacts of a chunk that has none.
    fn make_room(&mut self, contacts: usize, stride: usize, beyond: Beyond) {
        make_room(&mut self.i, contacts, beyond);
        make_room(&mut self.j, contacts, beyond);
        make_room(&mut self.engaged, contacts.div_ceil(WORD), beyond);
        self.now.make_room(contacts, stride, beyond);
    }

    /// Bytes set aside for bodies, forces, histories, and all else.
    pub(crate) fn bytes(&self) -> [usize; 4] {
        let kept = [&self.now, &*self.before];
        let of = |bytes: fn(&Kept) -> usize| kept.into_iter().map(bytes).sum::<usize>();
        let bodies =
            of(|k| set_aside(&k.start) + set_aside(&k.place) + set_aside(&k.candidate) + set_aside(&k.element));
        let forces = of(|k| set_aside(&k.normal_force) + k.tangential.bytes());
        let other = of(|k| set_aside(&k.geometry) + set_aside(&k.coupling));
        [
            bodies + set_aside(&self.i) + set_aside(&self.j) + set_aside(&self.shift) + set_aside(&self.engaged),
            forces + self.rolling.bytes(),
            of(|k| set_aside(&k.history)),
            other
                + set_aside(&self.felt)
                + set_aside(&self.goes_on)
                + set_aside(&self.losses)
                + set_aside(&self.elastic)
                + self.before.bytes()
                + self.touched.bytes()
                + self.coupling.bytes()
                + size_of::<Self>(),
        ]
    }

    /// Force of a contact with this normal on its first body [N]; on the second it is the opposite. What is told of forces is rounded to
    /// single precision; what acts on the grains is not.
    pub fn force(&self, contact: usize, normal: DVec3) -> DVec3 {
        normal * self.normal_force(contact) + self.tangential_force(contact)
    }

    /// Its part in the contact plane [N], rounded to single precision; what acts on the grains is not.
    pub fn tangential_force(&self, contact: usize) -> DVec3 {
        self.now.tangential.of(contact)
    }

    /// Torque of the rolling law on the first body [N m], rounded to single precision; on the second it is the opposite.
    pub fn rolling_torque(&self, contact: usize) -> DVec3 {
        self.rolling.of(contact)
    }

    /// Number of contacts.
    pub fn len(&self) -> usize {
        self.now.len()
    }

    /// Whether there is no contact.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Normal force of a contact [N], rounded to single precision; what acts on the grains is not.
    pub fn normal_force(&self, contact: usize) -> f64 {
        f64::from(self.now.normal_force[contact])
    }

    /// Whether the laws were asked about a contact in the latest step: the bodies touch, feel each other across a gap, or do so
    /// within half a step. The others in the table are merely near; they have no force and remember nothing.
    #[inline]
    pub fn is_engaged(&self, contact: usize) -> bool {
        is_set(&self.engaged, contact)
    }

    /// Number of contacts that are engaged.
    pub fn engaged(&self) -> usize {
        if self.engaged.is_empty() {
            self.len()
        } else {
            self.engaged.iter().map(|word| word.count_ones() as usize).sum()
        }
    }

    /// Notes whether the latest contact of the table is engaged.
    fn note_engaged(&mut self, is_engaged: bool) {
        let contact = self.len() - 1;
        self.engaged.resize(contact / WORD + 1, 0);
        self.engaged[contact / WORD] |= u64::from(is_engaged) << (contact % WORD);
    }

    /// Whether a contact acts: its normal force is not zero.
    ///
    /// The table also holds bodies that are merely near: across a gap within the reach of an attraction or of a bulge,
    /// or about to touch; and bodies that touch without force, in the dent of a plastic contact or
    /// while they part faster than they relax. None of these carries load, and how many of them are in the table
    /// depends on the time step and on the law. What is counted, written or averaged is therefore what acts.
    #[inline(always)]
    pub fn acts(&self, contact: usize) -> bool {
        self.now.normal_force[contact] != 0.0
    }

    /// Number of contacts that act.
    pub fn acting(&self) -> usize {
        (0..self.len()).filter(|&k| self.acts(k)).count()
    }

    /// The material pair of all contacts.
    pub fn law(&self) -> u32 {
        self.law
    }

    /// Element of the wall that a contact touches; 0 between grains.
    pub fn element(&self, contact: usize) -> u32 {
        self.now.element.get(contact).copied().unwrap_or(0)
    }

    /// What the contacts remember of the displacements by each other; empty where all are independent.
    pub fn coupling(&self) -> &[Coupled] {
        &self.now.coupling
    }

    /// History of one contact.
    pub fn history(&self, contact: usize, stride: usize) -> &[f64] {
        &self.now.history[contact * stride..(contact + 1) * stride]
    }

    /// History of one contact, to be changed.
    pub(crate) fn history_mut(&mut self, contact: usize, stride: usize) -> &mut [f64] {
        &mut self.now.history[contact * stride..(contact + 1) * stride]
    }

    /// Contacts of a candidate of this chunk.
    #[inline(always)]
    pub fn contacts_of(&self, candidate: usize) -> Range<usize> {
        self.now.range(candidate)
    }
}

/// Whether the bit of a contact is set; it is where there are no bits.
#[inline(always)]
fn is_set(bits: &[u64], contact: usize) -> bool {
    (bits.get(contact / WORD)).is_none_or(|word| word >> (contact % WORD) & 1 != 0)
}

/// All contacts: between grains, and between grains and walls.
#[derive(Clone, Debug, Default)]
pub struct Contacts {
    /// Contacts between grains, by chunks of [`crate::neighbours::Neighbours::chunk`].
    pub pairs: Vec<ContactChunk>,
    /// Contacts with walls, by chunks of [`crate::neighbours::Neighbours::wall_chunk`].
    pub walls: Vec<ContactChunk>,
    /// Number of history values per contact.
    pub stride: usize,
    /// Chunks without contacts for the next search, between grains and with walls.
    pub(crate) spare: [Vec<ContactChunk>; 2],
}

impl Contacts {
    /// Number of contacts between grains that act; see [`ContactChunk::acts`].
    pub fn acting_pairs(&self) -> usize {
        self.pairs.iter().map(ContactChunk::acting).sum()
    }

    /// Number of contacts with walls that act; see [`ContactChunk::acts`].
    pub fn acting_walls(&self) -> usize {
        self.walls.iter().map(ContactChunk::acting).sum()
    }

    /// Number of contacts between grains that are engaged, those without force counted; see [`ContactChunk::is_engaged`].
    pub fn pair_count(&self) -> usize {
        self.pairs.iter().map(ContactChunk::engaged).sum()
    }

    /// Number of contacts with walls that are engaged, those without force counted.
    pub fn wall_count(&self) -> usize {
        self.walls.iter().map(ContactChunk::engaged).sum()
    }

    /// The first fault, between grains before walls.
    pub fn fault(&self) -> Option<&Fault> {
        self.pairs
            .iter()
            .chain(&self.walls)
            .find_map(|chunk| chunk.fault.as_deref())
    }
}
