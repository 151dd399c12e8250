//! Grains and contacts one after the other, as the first process is told of them by those that have them.
//!
//! It keeps what a measure makes of them and no more, whatever the run holds. Others are told nothing. Where processes share the run each
//! calls these functions, in the same order.

use super::{Selection, holds};
use crate::contacts::ContactChunk;
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// A contact that acts, in the tables.
#[derive(Clone, Copy)]
pub(crate) struct Acting<'s> {
    pub chunk: &'s ContactChunk,
    pub place: usize,
    pub with_wall: bool,
}

impl Acting<'_> {
    /// Its first grain.
    pub fn i(&self) -> usize {
        self.chunk.i[self.place] as usize
    }

    /// Its second grain, or its wall.
    pub fn j(&self) -> u32 {
        self.chunk.j[self.place]
    }

    pub fn contact(&self, sim: &Simulation) -> Contact {
        sim.contact(self.chunk, self.place)
    }

    /// Its grains; nothing in place of a wall.
    pub fn grains(&self) -> [Option<usize>; 2] {
        [Some(self.i()), (!self.with_wall).then_some(self.j() as usize)]
    }

    /// Its normal force, repulsion positive [N].
    pub fn normal_force(&self) -> f64 {
        self.chunk.normal_force(self.place)
    }
}

/// Contacts that act of some chunks.
pub(super) fn acting(chunks: &[ContactChunk], with_wall: bool) -> impl Iterator<Item = Acting<'_>> {
    let of_chunk = move |chunk| {
        let act = move |place: &usize| ContactChunk::acts(chunk, *place);
        (0..chunk.len()).filter(act).map(move |place| Acting {
            chunk,
            place,
            with_wall,
        })
    };
    chunks.iter().flat_map(of_chunk)
}

/// The own contacts that act: of all processes together, every contact is the own one of one.
pub(super) fn own_pairs(sim: &Simulation) -> impl Iterator<Item = Acting<'_>> {
    acting(&sim.contacts.pairs[sim.own_chunks()], false)
}

/// The same with walls.
pub(super) fn own_with_walls(sim: &Simulation) -> impl Iterator<Item = Acting<'_>> {
    acting(&sim.contacts.walls[sim.own_wall_chunks()], true)
}

/// Own grains that are chosen, with their ids, which rise.
pub(super) fn chosen_by_id(sim: &Simulation, is_chosen: impl Fn(usize) -> bool) -> Vec<(u32, u32)> {
    let own = sim.own_grains().filter(|&g| is_chosen(g));
    let mut chosen: Vec<(u32, u32)> = own.map(|g| (sim.grains.id[g], g as u32)).collect();
    chosen.sort_unstable();
    chosen
}

/// What is told of grains, by rising ids: each tells of these of its own.
pub(super) fn each_of<T: Serialize + DeserializeOwned>(
    sim: &Simulation,
    own: Vec<(u32, u32)>,
    tell: impl Fn(usize) -> T,
    mut look: impl FnMut(u32, T),
) {
    let own = own.into_iter().map(|(id, g)| (id, tell(g as usize)));
    let all = sim.together().merged(own, |told| told.0);
    first_looks(sim, all, |(id, told)| look(id, told));
}

/// What is told of all grains that are chosen, by rising ids.
pub(super) fn each_grain<T: Serialize + DeserializeOwned>(
    sim: &Simulation,
    is_chosen: impl Fn(usize) -> bool,
    tell: impl Fn(usize) -> T,
    look: impl FnMut(u32, T),
) {
    each_of(sim, chosen_by_id(sim, is_chosen), tell, look);
}

/// What is told of grains, in the order of the tables.
pub(super) fn each_in_order<T: Serialize + DeserializeOwned>(
    sim: &Simulation,
    tell: impl Fn(usize) -> Option<T>,
    look: impl FnMut(T),
) {
    each(sim, sim.own_grains().filter_map(tell), look);
}

/// What is told of contacts that act: of those between grains and then of those with walls, in the order of the tables.
pub(super) fn each_contact<T: Serialize + DeserializeOwned>(
    sim: &Simulation,
    tell: impl Fn(Acting<'_>) -> Option<T>,
    mut look: impl FnMut(T),
) {
    each(sim, own_pairs(sim).filter_map(&tell), &mut look);
    each(sim, own_with_walls(sim).filter_map(&tell), &mut look);
}

/// What all have, in the order of the tables.
pub(super) fn each<T: Serialize + DeserializeOwned>(
    sim: &Simulation,
    own: impl Iterator<Item = T>,
    look: impl FnMut(T),
) {
    first_looks(sim, sim.together().joined(own), look);
}

fn first_looks<T>(sim: &Simulation, all: impl Iterator<Item = T>, mut look: impl FnMut(T)) {
    let is_first = sim.together().is_first();
    for told in all {
        if is_first {
            look(told);
        }
    }
}

/// For every grain whether it lies in a zone and is meant; of grains that this process knows nothing of it tells no.
pub(super) fn counting(sim: &Simulation, zone: &Zone, selection: &Selection, origins: &Origins) -> Vec<bool> {
    let mut counts = vec![false; sim.grains.len()];
    for g in sim.grains_here() {
        counts[g] = holds(sim, zone, g) && selection.holds(&sim.grains, origins, g);
    }
    counts
}
