//! Contacts of a moment, as they are written and drawn: each is found when it is asked for, so that no list of them takes memory.

use super::told_first::{Acting, acting};
use crate::contacts::ContactChunk;
use crate::output::ContactRecord;
use crate::simulation::Simulation;
use glam::DVec3;

/// The contacts of a moment, those that act ([`ContactChunk::acts`]): between grains first, then with walls.
///
/// Bodies that are near, or touch without force, are left out: they would appear as contacts in pictures and counts, and
/// as many of them as the time step and the reach of the law happen to gather.
#[derive(Clone, Copy, Debug)]
pub enum ContactsAt<'a> {
    /// Of a state, in the order of its tables.
    State(&'a Simulation),
    /// In a list, as a file has them.
    List(&'a [ContactRecord]),
}

/// One of them, of which no more is found than what is asked for.
#[derive(Clone, Copy)]
pub(crate) enum ContactAt<'a> {
    State(&'a Simulation, Acting<'a>),
    Listed(&'a ContactRecord),
}

/// Some of them, one after the other.
pub(crate) type SomeContacts<'a> = Box<dyn Iterator<Item = ContactAt<'a>> + 'a>;

/// All contacts of a state that own grains are in.
pub fn contact_records(sim: &Simulation) -> Vec<ContactRecord> {
    ContactsAt::State(sim).all().map(ContactAt::record).collect()
}

impl<'a> ContactsAt<'a> {
    /// Between grains. Where processes share the run, each contact is told by one of them.
    pub(crate) fn pairs(self) -> SomeContacts<'a> {
        match self {
            Self::State(sim) => of_chunks(sim, &sim.contacts.pairs[..sim.own_chunks().end], false),
            Self::List(list) => of_list(list, false),
        }
    }

    /// Between own grains and those of other processes that these tell.
    fn pairs_of_others(self) -> SomeContacts<'a> {
        match self {
            Self::State(sim) => of_chunks(sim, &sim.contacts.pairs[sim.own_chunks().end..], false),
            Self::List(_) => Box::new(std::iter::empty()),
        }
    }

    /// With walls.
    pub(crate) fn with_walls(self) -> SomeContacts<'a> {
        match self {
            Self::State(sim) => of_chunks(sim, &sim.contacts.walls, true),
            Self::List(list) => of_list(list, true),
        }
    }

    /// All that own grains are in.
    pub(crate) fn all(self) -> impl Iterator<Item = ContactAt<'a>> {
        self.pairs().chain(self.pairs_of_others()).chain(self.with_walls())
    }
}

fn of_chunks<'a>(sim: &'a Simulation, chunks: &'a [ContactChunk], with_wall: bool) -> SomeContacts<'a> {
    Box::new(acting(chunks, with_wall).map(move |contact| ContactAt::State(sim, contact)))
}

fn of_list(list: &[ContactRecord], with_wall: bool) -> SomeContacts<'_> {
    let meant = move |record: &&ContactRecord| (record.wall >= 0) == with_wall;
    Box::new(list.iter().filter(meant).map(ContactAt::Listed))
}

impl ContactAt<'_> {
    /// Indices of its grains; `find` tells that of an id, where it knows ids alone.
    pub fn grains(self, find: impl Fn(u32) -> Option<usize>) -> [Option<usize>; 2] {
        match self {
            Self::State(_, acting) => acting.grains(),
            Self::Listed(record) => {
                [Some(record.id_i), (record.wall < 0).then_some(record.id_j)].map(|id| id.and_then(&find))
            }
        }
    }

    /// Id of the first grain.
    pub fn id_i(self) -> u32 {
        match self {
            Self::State(sim, acting) => sim.grains.id[acting.i()],
            Self::Listed(record) => record.id_i,
        }
    }

    /// Id of the second grain; 0 for a wall.
    pub fn id_j(self) -> u32 {
        match self {
            Self::State(_, acting) if acting.with_wall => 0,
            Self::State(sim, acting) => sim.grains.id[acting.j() as usize],
            Self::Listed(record) => record.id_j,
        }
    }

    /// Index of the wall; -1 between grains.
    pub fn wall(self) -> i32 {
        match self {
            Self::State(_, acting) if acting.with_wall => acting.j() as i32,
            Self::State(..) => -1,
            Self::Listed(record) => record.wall,
        }
    }

    /// Which element of the wall is touched; 0 between grains.
    pub fn element(self) -> u32 {
        match self {
            Self::State(sim, acting) if acting.with_wall => {
                let (wall, reach) = (&sim.walls[acting.j() as usize], sim.grains.radius(acting.i()));
                wall.element_at(acting.chunk.element(acting.place), self.position(), reach)
            }
            Self::State(..) => 0,
            Self::Listed(record) => record.element,
        }
    }

    /// Contact point [m].
    pub fn position(self) -> DVec3 {
        match self {
            Self::State(sim, acting) => {
                let contact = acting.contact(sim);
                sim.grains.position[acting.i()] - contact.normal * contact.lever_i
            }
            Self::Listed(record) => record.position,
        }
    }

    /// Unit normal, from `j` or the wall towards `i`.
    pub fn normal(self) -> DVec3 {
        match self {
            Self::State(sim, acting) => acting.contact(sim).normal,
            Self::Listed(record) => record.normal,
        }
    }

    /// Overlap [m].
    pub fn overlap(self) -> f64 {
        match self {
            Self::State(sim, acting) => acting.contact(sim).overlap,
            Self::Listed(record) => record.overlap,
        }
    }

    /// Normal force, repulsion positive [N].
    pub fn repulsion(self) -> f64 {
        match self {
            Self::State(_, acting) => f64::from(acting.normal_force() as f32),
            Self::Listed(record) => record.repulsion(),
        }
    }

    /// Normal force on grain `i` [N].
    pub fn normal_force(self) -> DVec3 {
        self.normal() * self.repulsion()
    }

    /// Tangential force on grain `i` [N].
    pub fn tangential_force(self) -> DVec3 {
        match self {
            Self::State(_, acting) => acting.chunk.tangential_force(acting.place).as_vec3().as_dvec3(),
            Self::Listed(record) => record.tangential_force(),
        }
    }

    /// Force on grain `i` [N].
    pub fn force(self) -> DVec3 {
        self.normal_force() + self.tangential_force()
    }

    /// Rolling torque on grain `i` [N m].
    pub fn rolling_torque(self) -> DVec3 {
        match self {
            Self::State(_, acting) => acting.chunk.rolling_torque(acting.place).as_vec3().as_dvec3(),
            Self::Listed(record) => record.rolling_torque(),
        }
    }

    fn record(self) -> ContactRecord {
        ContactRecord {
            id_i: self.id_i(),
            id_j: self.id_j(),
            wall: self.wall(),
            element: self.element(),
            position: self.position(),
            normal: self.normal(),
            overlap: self.overlap(),
            push: self.repulsion() as f32,
            drag: self.tangential_force().as_vec3(),
            torque: self.rolling_torque().as_vec3(),
        }
    }
}
