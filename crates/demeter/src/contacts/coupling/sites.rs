//! The contacts of every grain, as sources of displacement.

use crate::contacts::{CHUNK, ContactChunk, Contacts};
use crate::neighbours::Neighbours;
use crate::particles::Grains;
use demeter_physics::contact::multi_contact::clearance;
use std::ops::Range;

/// Grains handled by one task.
pub(crate) const GRAINS_PER_TASK: usize = 64;

/// Which contact: its chunk, its place in it, and whether the partner is a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ContactPlace {
    pub(crate) wall: bool,
    pub(crate) chunk: u32,
    pub(crate) contact: u32,
}

impl ContactPlace {
    /// The chunk that the contact is in.
    #[inline(always)]
    pub(crate) fn chunk<'c>(&self, contacts: &'c Contacts) -> &'c ContactChunk {
        let chunks = if self.wall { &contacts.walls } else { &contacts.pairs };
        &chunks[self.chunk as usize]
    }
}

/// Contacts of the grains of one task, by grain, in the order of the partner's id.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sites {
    start: Vec<u32>,
    place: Vec<ContactPlace>,
    /// Whether the grain is the first body.
    first: Vec<bool>,
    /// Normals into the grain.
    normal: [Vec<f64>; 3],
    lever: Vec<f64>,
    clearance: Vec<f64>,
    force: Vec<f64>,
}

/// Contacts of one grain.
#[derive(Clone, Copy)]
pub(crate) struct GrainSites<'a> {
    pub(crate) place: &'a [ContactPlace],
    pub(crate) normal: [&'a [f64]; 3],
    pub(crate) lever: &'a [f64],
    pub(crate) clearance: &'a [f64],
    pub(crate) force: &'a [f64],
}

/// The contacts of a grain.
#[inline(always)]
pub(crate) fn of_grain(sites: &[Sites], grain: usize) -> GrainSites<'_> {
    let task = &sites[grain / GRAINS_PER_TASK];
    let range = task.range(grain % GRAINS_PER_TASK);
    GrainSites {
        place: &task.place[range.clone()],
        normal: [0, 1, 2].map(|axis| &task.normal[axis][range.clone()]),
        lever: &task.lever[range.clone()],
        clearance: &task.clearance[range.clone()],
        force: &task.force[range],
    }
}

impl Sites {
    #[inline(always)]
    fn range(&self, grain: usize) -> Range<usize> {
        self.start[grain] as usize..self.start[grain + 1] as usize
    }

    fn clear(&mut self) {
        self.start.clear();
        self.start.push(0);
        self.place.clear();
        self.first.clear();
        self.normal.iter_mut().for_each(Vec::clear);
        self.lever.clear();
        self.clearance.clear();
        self.force.clear();
    }

    /// Gathers the contacts of grains; with `only_acting` those that push or pull.
    pub(crate) fn gather(
        &mut self,
        of: Range<usize>,
        grains: &Grains,
        neighbours: &Neighbours,
        contacts: &Contacts,
        only_acting: bool,
    ) {
        self.clear();
        for grain in of {
            let radius = grains.radius[grain];
            for (pair, first) in neighbours.pairs_of(grain) {
                self.take(false, pair, first, radius, &contacts.pairs[pair / CHUNK], only_acting);
            }
            for pair in neighbours.wall_pairs_of(grain) {
                self.take(true, pair, true, radius, &contacts.walls[pair / CHUNK], only_acting);
            }
            self.start.push(self.place.len() as u32);
        }
    }

    /// Takes the contacts of one candidate.
    #[inline(always)]
    fn take(&mut self, wall: bool, pair: usize, first: bool, radius: f64, chunk: &ContactChunk, only_acting: bool) {
        for k in chunk.contacts_of(pair % CHUNK) {
            let force = chunk.coupling.trial[k];
            if only_acting && force == 0.0 {
                continue;
            }
            let contact = &chunk.now.geometry[k];
            let normal = if first { contact.normal } else { -contact.normal };
            let size = (!wall).then(|| chunk.coupling.size[k].radius);
            self.place.push(ContactPlace {
                wall,
                chunk: (pair / CHUNK) as u32,
                contact: k as u32,
            });
            self.first.push(first);
            self.normal[0].push(normal.x);
            self.normal[1].push(normal.y);
            self.normal[2].push(normal.z);
            self.lever.push(lever(chunk, k, wall, first));
            self.clearance.push(clearance(radius, size));
            self.force.push(force);
        }
    }

    /// Takes the forces tried now.
    pub(crate) fn take_forces(&mut self, contacts: &Contacts) {
        for (force, place) in self.force.iter_mut().zip(&self.place) {
            *force = place.chunk(contacts).coupling.trial[place.contact as usize];
        }
    }

    /// Takes the levers that follow from the displacements found now.
    pub(crate) fn take_levers(&mut self, contacts: &Contacts) {
        for ((lever_of, place), &first) in self.lever.iter_mut().zip(&self.place).zip(&self.first) {
            *lever_of = lever(place.chunk(contacts), place.contact as usize, place.wall, first);
        }
    }
}

/// Distance of a contact point from the centre of one of its bodies, with the displacements found latest [m].
#[inline(always)]
pub(super) fn lever(chunk: &ContactChunk, k: usize, wall: bool, first: bool) -> f64 {
    let contact = &chunk.now.geometry[k];
    // at a wall it is the foot of the perpendicular
    let shift = if wall { 0.0 } else { chunk.now.coupling[k].lever_shift() };
    if first {
        contact.lever_i + shift
    } else {
        contact.lever_j - shift
    }
}
