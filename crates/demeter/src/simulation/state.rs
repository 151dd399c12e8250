//! Everything that a restart to the same bits needs.

use super::deforming_box::DeformingState;
use super::skin::SkinTuner;
use super::{Books, Setup, Simulation, memory};
use crate::comm::parts::{Part, Saved};
use crate::contacts::{NearTables, SavedContacts};
use crate::neighbours::Neighbours;
use crate::particles::Grains;
use crate::step::CouplingMemory;
use crate::walls::{Wall, WallState};
use demeter_physics::integrator::Integrator;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// State of a simulation after a whole step. What a run has stays where it is, until it is written.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct SimulationState<'a> {
    /// Whether the forces of the first moment were found.
    started: bool,
    /// Steps done.
    pub step: u64,
    /// Time step [s].
    pub dt: f64,
    /// Grains, in their present order.
    pub(crate) grains: Saved<'a, Grains>,
    /// Walls, in the order of the scenario.
    pub walls: Vec<WallState>,
    contacts: SavedContacts<'a>,
    neighbours: Saved<'a, Neighbours>,
    books: Books,
    rebuilds: u64,
    scattered_in_order: f64,
    skin: f64,
    tuner: SkinTuner,
    near: Saved<'a, NearTables>,
    bounds: (DVec3, DVec3),
    max_reach: f64,
    latest_id: u32,
    /// Whether a custom force acted, which the state does not hold.
    had_custom_force: bool,
    /// Nothing where contacts are independent.
    coupling: Option<Saved<'a, CouplingMemory>>,
    /// Nothing where the box keeps its shape.
    deforming: Option<DeformingState>,
}

/// Why a state does not fit the scenario that it is to continue.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StateError {
    /// The number of walls differs.
    #[error("the checkpoint holds {found} walls, the scenario {expected}: it belongs to another scenario")]
    Walls {
        /// Walls in the checkpoint.
        found: usize,
        /// Walls in the scenario.
        expected: usize,
    },
    /// The state was written by a run with the other integrator.
    #[error(
        "the checkpoint was written with another `simulation.integrator` than the scenario names: a run goes on with the \
         integrator that it began with"
    )]
    Integrator,
    /// The state was written by a run with independent contacts, and the scenario couples them, or the other way.
    #[error(
        "the checkpoint was written with another choice of `multi_contact` laws than the scenario names: a run goes on with \
         the laws that it began with"
    )]
    Coupling,
    /// A wall that records loads or wear has another shape than it had.
    #[error(
        "the checkpoint holds loads or wear on other elements than wall `{wall}` has: while a wall records them (`stress`, `wear`) its \
         shape stays as it was when the run began"
    )]
    OtherElements {
        /// The wall.
        wall: String,
    },
    /// Arrays of the checkpoint contradict each other.
    #[error("the checkpoint contradicts itself ({0}): it was not written by this engine")]
    Inconsistent(&'static str),
}

impl SimulationState<'_> {
    /// Whether a custom force acted, which the state does not hold.
    pub fn had_custom_force(&self) -> bool {
        self.had_custom_force
    }

    /// Number of contacts.
    pub fn contact_count(&self) -> usize {
        self.contacts.len()
    }

    fn check(&self, walls: usize, materials: usize, integrator: Integrator) -> Result<(), StateError> {
        let g = &self.grains;
        let n = g.len();
        let remembered = match integrator {
            Integrator::VelocityVerlet => 0,
            Integrator::Gear => n,
        };
        let lengths = [
            g.material.len(),
            g.position.len(),
            g.velocity.len(),
            g.angular_velocity.len(),
            g.orientation.as_ref().map_or(n, Vec::len),
            g.load.len(),
        ];
        if self.walls.len() != walls {
            Err(StateError::Walls {
                found: self.walls.len(),
                expected: walls,
            })
        } else if lengths.iter().any(|&l| l != n) {
            Err(StateError::Inconsistent("lengths of the grain arrays"))
        } else if g.higher.len() != remembered {
            Err(StateError::Integrator)
        } else if g.material.iter().any(|&m| m as usize >= materials) {
            Err(StateError::Inconsistent("a grain's material"))
        } else if !g.radii().all(|r| (0.0..f64::INFINITY).contains(&r)) {
            Err(StateError::Inconsistent("a grain's radius"))
        } else if !self.tuner.fits(self.skin, self.step) {
            Err(StateError::Inconsistent("the skin"))
        } else if !self.near.are_sound(self.neighbours.segments()) {
            Err(StateError::Inconsistent("the reach of the table of contacts"))
        } else if !self.deforming.as_ref().is_none_or(|d| d.is_sound(self.dt)) {
            Err(StateError::Inconsistent("the box that deforms"))
        } else if self.started != (self.rebuilds > 0) || !self.started && self.neighbours.segments() > 0 {
            Err(StateError::Inconsistent("whether it has begun"))
        } else {
            Ok(())
        }
    }
}

impl Simulation {
    /// The state after the latest step. Where the run is shared each process calls this and writes what it gets; what the first writes
    /// is the state of all.
    pub fn state(&self) -> SimulationState<'_> {
        self.state_of(self.part())
    }

    /// The same without what belongs to single grains: with it another process can go on that is handed its part of these.
    pub(crate) fn state_without_grains(&self) -> SimulationState<'_> {
        self.state_of(Part::NOTHING)
    }

    fn state_of<'a>(&'a self, part: Part<'a>) -> SimulationState<'a> {
        assert!(!self.awaits_kick, "velocities are those predicted");
        SimulationState {
            started: self.started,
            step: self.step,
            dt: self.dt,
            grains: Saved::new(Cow::Borrowed(&self.grains), &part),
            walls: self.walls.iter().map(Wall::state).collect(),
            contacts: self.saved_contacts(&part),
            neighbours: Saved::new(Cow::Borrowed(&self.neighbours), &part),
            books: self.books,
            rebuilds: self.rebuilds,
            scattered_in_order: self.scattered_in_order,
            skin: self.skin,
            tuner: self.tuner,
            near: Saved::new(Cow::Owned(self.near.saved()), &part),
            bounds: self.bounds,
            max_reach: self.max_reach,
            latest_id: self.latest_id,
            had_custom_force: self.has_custom_force(),
            coupling: (self.coupling.as_ref()).map(|c| Saved::new(Cow::Borrowed(&c.memory), &part)),
            deforming: self.deforming_state(),
        }
    }

    /// Continues from a state; the bits are those of an uninterrupted run. The grains, the time step and the skin of
    /// `setup` are replaced by the state's.
    pub fn resume(setup: Setup, state: SimulationState<'_>) -> Result<Self, StateError> {
        state.check(setup.walls.len(), setup.materials.list().len(), setup.integrator)?;
        let mut sim = Self::new(Setup {
            grains: state.grains.into_owned(),
            ..setup
        });
        for (wall, state) in sim.walls.iter_mut().zip(&state.walls) {
            if !wall.restore(state) {
                return Err(StateError::OtherElements {
                    wall: wall.name.clone(),
                });
            }
        }
        sim.started = state.started;
        sim.step = state.step;
        sim.dt = state.dt;
        sim.books = state.books;
        sim.rebuilds = state.rebuilds;
        sim.forget_spreads(0);
        sim.scattered_in_order = state.scattered_in_order;
        (sim.skin, sim.tuner, sim.near) = (state.skin, state.tuner, state.near.into_owned());
        sim.bounds = state.bounds;
        sim.max_reach = state.max_reach;
        sim.latest_id = sim.latest_id.max(state.latest_id);
        match (&mut sim.coupling, state.coupling) {
            (Some(coupling), Some(memory)) => coupling.memory = memory.into_owned(),
            (None, None) => {}
            _ => return Err(StateError::Coupling),
        }
        if let Some(deforming) = state.deforming {
            sim.restore_box(deforming);
        }
        sim.neighbours = state.neighbours.into_owned();
        if sim.coupling.is_some() {
            sim.neighbours.tell_pairs_of_grains();
        }
        let (walls, materials) = (sim.walls.len(), sim.materials.list().len());
        if sim.started && !sim.neighbours.restore(&sim.grains, walls, materials) {
            return Err(StateError::Inconsistent("candidate pairs"));
        }
        let contacts = (state.contacts).restored(&sim.neighbours, sim.contacts.stride, sim.coupling.is_some());
        [sim.contacts.pairs, sim.contacts.walls] = contacts.ok_or(StateError::Inconsistent("contacts"))?;
        sim.walls_before = sim.walls.iter().map(Wall::pose).collect();
        memory::give_back();
        Ok(sim)
    }
}
