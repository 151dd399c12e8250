//! Forces of contacts that feel each other ([`crate::contacts::coupling`]).

use super::GRAINS_PER_TASK;
use crate::contacts::coupling::bulge::{ALLOWANCE, Bounds};
use crate::contacts::coupling::mixing::{Products, Progress};
use crate::contacts::coupling::rows::ChunkPlace;
use crate::contacts::coupling::sites::{self, ContactPlace, Sites};
use crate::contacts::coupling::{self, Coupling, Worst};
use crate::contacts::{CHUNK, ContactChunk, Contacts, Fault, Scene};
use crate::materials::Materials;
use crate::neighbours::{Neighbours, Pair, WallPair};
use crate::particles::Grains;
use crate::simulation::Simulation;
use rayon::prelude::*;

/// Iterations after which the coupled equation is given up.
const MOST_ITERATIONS: usize = 1000;

/// Candidates are found for bulges this much larger than those foreseen.
const ROOM_TO_GROW: f64 = 1.5;

/// Everything that coupled contacts need beyond what a contact remembers.
#[derive(Clone, Debug)]
pub(crate) struct CouplingState {
    pub(crate) scheme: Coupling,
    pub(crate) memory: CouplingMemory,
    feels_levers: bool,
    sites: Vec<Sites>,
    /// How far the surface of every grain may bulge in this step [m].
    bulge: Vec<f64>,
    max_bulge: f64,
}

/// What a restart needs of it.
#[derive(Clone, Debug, Default, serde::Serialize, serde::Deserialize)]
pub struct CouplingMemory {
    /// Bounds of the bulges of the grains that the run began with.
    bounds: Bounds,
    /// Bulges of two bodies for which the candidates were found [m].
    pub(crate) margin: f64,
    pub(crate) effort: Effort,
}

/// What solving the coupled equation took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Effort {
    /// Equations solved: one per step.
    pub solutions: u64,
    /// Iterations that they took.
    pub iterations: u64,
    /// Steps whose search for contacts was repeated because surfaces bulged more than was foreseen.
    pub repeats: u64,
}

impl CouplingState {
    /// Nothing where no contact feels another.
    pub(crate) fn new(scheme: Coupling, grains: &Grains, materials: &Materials) -> Option<Self> {
        (!coupling::independent(materials)).then(|| Self {
            scheme,
            feels_levers: coupling::feels_levers(materials),
            memory: CouplingMemory {
                bounds: Bounds::new(grains, materials),
                ..CouplingMemory::default()
            },
            sites: Vec::new(),
            bulge: Vec::new(),
            max_bulge: 0.0,
        })
    }

    /// Notes that candidates are found now: with room for bulges to grow.
    pub(crate) fn take_margin(&mut self) {
        self.memory.margin = ROOM_TO_GROW * self.bulges_of_two();
    }

    /// Distance beyond touching at which displaced surfaces may meet in this step [m].
    pub(crate) fn bulges_of_two(&self) -> f64 {
        2.0 * self.max_bulge
    }
}

/// Chunks of contacts between grains and with walls, with their places and candidates.
fn each_chunk<'a>(
    contacts: &'a mut Contacts,
    neighbours: &'a Neighbours,
    work: impl Fn(ChunkPlace, &mut ContactChunk, Candidates<'a>) + Sync + Send,
) {
    let place = |wall: bool, chunk: usize| ChunkPlace {
        wall,
        chunk: chunk as u32,
    };
    let pairs = (contacts.pairs.par_iter_mut())
        .zip(neighbours.pairs.par_chunks(CHUNK))
        .enumerate()
        .map(|(c, (chunk, pairs))| work(place(false, c), chunk, Candidates::Pairs(pairs)));
    let walls = (contacts.walls.par_iter_mut())
        .zip(neighbours.wall_pairs.par_chunks(CHUNK))
        .enumerate()
        .map(|(c, (chunk, pairs))| work(place(true, c), chunk, Candidates::Walls(pairs)));
    pairs.chain(walls).for_each(|()| ());
}

/// Candidates of a chunk.
#[derive(Clone, Copy)]
enum Candidates<'a> {
    Pairs(&'a [Pair]),
    Walls(&'a [WallPair]),
}

/// What the scene needs to know beside the state of the coupling.
#[derive(Clone, Copy)]
struct Search {
    max_speed: f64,
}

impl Simulation {
    /// Foresees how far surfaces may bulge in this step, from the forces of the step before.
    pub(super) fn foresee_bulges(&mut self) {
        let force = |contacts: &Contacts, place: ContactPlace| {
            place.chunk(contacts).now.coupling[place.contact as usize].elastic
        };
        self.bound_bulges(force, |bulge, bound| *bulge = ALLOWANCE * bound);
    }

    /// Finds for every grain how far its surface may bulge, and takes it.
    fn bound_bulges(
        &mut self,
        force: impl Fn(&Contacts, ContactPlace) -> f64 + Sync,
        take: impl Fn(&mut f64, f64) + Sync,
    ) {
        let Some(state) = &mut self.coupling else { return };
        let (grains, neighbours, contacts, bounds) =
            (&self.grains, &self.neighbours, &self.contacts, &state.memory.bounds);
        state.bulge.resize(grains.len(), 0.0);
        // before the first search there are no candidates
        if neighbours.reference.len() == grains.len() {
            state
                .bulge
                .par_iter_mut()
                .with_min_len(GRAINS_PER_TASK)
                .enumerate()
                .for_each(|(g, bulge)| {
                    take(bulge, bounds.of_grain(g, grains, neighbours, contacts, &force));
                });
        }
        state.max_bulge = state.bulge.iter().copied().fold(0.0, f64::max);
    }

    /// Narrow phase, displacements and contact laws.
    pub(super) fn find_coupled_contacts(&mut self, max_speed: f64) -> Result<(), Fault> {
        let search = Search { max_speed };
        loop {
            self.look_for_contacts(search);
            let lagged = self.coupling.as_ref().is_none_or(|c| c.scheme == Coupling::Lagged);
            // a run begins with forces that are in agreement
            if lagged && self.step > 0 {
                self.gather_sites(true);
                break;
            }
            if let Err(fault) = self.solve_coupling(search) {
                self.take_back_contacts();
                return Err(fault);
            }
            if self.bulges_as_foreseen() {
                break;
            }
            self.take_back_contacts();
            self.coupling.iter_mut().for_each(|c| c.memory.effort.repeats += 1);
            if self
                .coupling
                .as_ref()
                .is_some_and(|c| c.bulges_of_two() > c.memory.margin)
            {
                let bulges: Vec<(u32, f64)> = self.bulges_by_id();
                self.find_candidates();
                self.set_bulges(&bulges);
            }
        }
        let keep = self.step == 0 || self.coupling.as_ref().is_some_and(|c| c.scheme != Coupling::Lagged);
        self.with_chunks(search, |at, chunk, _, scene, sites| {
            if !keep {
                chunk.displace(at, scene, sites);
            }
            chunk.deform(at, scene);
            if at.wall {
                chunk.evaluate_walls(scene);
            } else {
                chunk.evaluate_pairs(scene);
            }
            chunk.book_lost(scene);
        });
        Ok(())
    }

    /// Works on all chunks, in parallel.
    fn with_chunks<'a>(
        &'a mut self,
        search: Search,
        work: impl Fn(ChunkPlace, &mut ContactChunk, Candidates<'a>, &Scene<'_>, &[Sites]) + Sync + Send,
    ) {
        let Some(state) = &self.coupling else { return };
        let scene = Scene {
            grains: &self.grains,
            walls: &self.walls,
            materials: &self.materials,
            comm: &self.comm,
            dt: self.dt,
            integrator: self.integrator,
            step: self.step,
            max_speed: search.max_speed,
            max_reach: self.max_reach,
            max_overlap: self.max_overlap,
            stride: self.contacts.stride,
            bulge: &state.bulge,
        };
        each_chunk(&mut self.contacts, &self.neighbours, |at, chunk, candidates| {
            work(at, chunk, candidates, &scene, &state.sites);
        });
    }

    fn look_for_contacts(&mut self, search: Search) {
        let scheme = self.coupling.as_ref().map_or(Coupling::Lagged, |c| c.scheme);
        self.with_chunks(search, |_, chunk, candidates, scene, _| {
            match candidates {
                Candidates::Pairs(pairs) => chunk.find_pairs(pairs, scene),
                Candidates::Walls(pairs) => chunk.find_walls(pairs, scene),
            }
            chunk.coupling.begin(scheme);
        });
    }

    fn take_back_contacts(&mut self) {
        each_chunk(
            &mut self.contacts,
            &self.neighbours,
            |_, chunk, candidates| match candidates {
                Candidates::Pairs(pairs) => chunk.take_back(pairs.len(), |c| (pairs[c].i, pairs[c].j)),
                Candidates::Walls(pairs) => chunk.take_back(pairs.len(), |c| (pairs[c].grain, pairs[c].wall)),
            },
        );
    }

    fn gather_sites(&mut self, only_acting: bool) {
        let Some(state) = &mut self.coupling else { return };
        let (grains, neighbours, contacts) = (&self.grains, &self.neighbours, &self.contacts);
        let count = grains.len();
        state
            .sites
            .resize_with(count.div_ceil(sites::GRAINS_PER_TASK), Sites::default);
        state.sites.par_iter_mut().enumerate().for_each(|(task, sites)| {
            let first = task * sites::GRAINS_PER_TASK;
            let of = first..(first + sites::GRAINS_PER_TASK).min(count);
            sites.gather(of, grains, neighbours, contacts, only_acting);
        });
    }

    fn update_sites(&mut self, levers: bool) {
        let Some(state) = &mut self.coupling else { return };
        let contacts = &self.contacts;
        state.sites.par_iter_mut().for_each(|sites| {
            sites.take_forces(contacts);
            if levers {
                sites.take_levers(contacts);
            }
        });
    }

    /// Solves the coupled equation at the places of this step.
    fn solve_coupling(&mut self, search: Search) -> Result<(), Fault> {
        let Some(state) = &self.coupling else { return Ok(()) };
        let feels_levers = state.feels_levers;
        let tolerance = match state.scheme {
            Coupling::Converged { tolerance } => tolerance,
            Coupling::Lagged => coupling::DEFAULT_TOLERANCE,
        };
        self.gather_sites(false);
        self.with_chunks(search, |at, chunk, _, scene, sites| {
            chunk.find_influences(at, scene, sites)
        });
        let mut progress = Progress::begin();
        for iteration in 1..=MOST_ITERATIONS {
            self.with_chunks(search, |at, chunk, _, scene, sites| chunk.answer(at, scene, sites));
            let worst = self.worst();
            if worst.share <= tolerance {
                if !(feels_levers && self.lever_change() > tolerance) {
                    if let Some(state) = &mut self.coupling {
                        state.memory.effort.solutions += 1;
                        state.memory.effort.iterations += iteration as u64;
                    }
                    return Ok(());
                }
                self.chunks_mut().for_each(|chunk| chunk.coupling.accept());
                self.update_sites(true);
                self.with_chunks(search, |at, chunk, _, scene, sites| {
                    chunk.find_influences(at, scene, sites)
                });
                progress = Progress::begin();
                continue;
            }
            if worst.share.is_nan() {
                break;
            }
            self.mix(&mut progress);
            self.update_sites(false);
        }
        Err(self.beyond_fold(search))
    }

    /// The next forces to try.
    fn mix(&mut self, progress: &mut Progress) {
        let note = |chunk: &mut ContactChunk| chunk.coupling.note();
        let mut products = self
            .chunks_mut()
            .map(note)
            .fold(Products::default(), |sum, p| sum.add(&p));
        if progress.is_lost(&products) {
            self.chunks_mut().for_each(|chunk| chunk.coupling.forget());
            products = self
                .chunks_mut()
                .map(note)
                .fold(Products::default(), |sum, p| sum.add(&p));
        }
        let weights = products.weights();
        self.chunks_mut().for_each(|chunk| chunk.coupling.advance(&weights));
    }

    fn chunks_mut(&mut self) -> impl Iterator<Item = &mut ContactChunk> {
        self.contacts.pairs.iter_mut().chain(&mut self.contacts.walls)
    }

    fn worst(&self) -> Worst {
        let chunks = self.contacts.pairs.iter().chain(&self.contacts.walls);
        chunks
            .map(|chunk| chunk.coupling.worst)
            .fold(Worst::default(), |worst, w| {
                if w.share.is_nan() || w.share > worst.share {
                    w
                } else {
                    worst
                }
            })
    }

    fn lever_change(&self) -> f64 {
        let chunks = self.contacts.pairs.iter().chain(&self.contacts.walls);
        chunks.map(|chunk| chunk.coupling.lever_change).fold(0.0, f64::max)
    }

    /// The fault at the contact that is farthest from a solution.
    fn beyond_fold(&mut self, search: Search) -> Fault {
        let worst = self.worst().share;
        let told = std::sync::Mutex::new(None::<(ChunkPlace, Fault)>);
        self.with_chunks(search, |at, chunk, _, scene, _| {
            let here = chunk.coupling.worst;
            let is_worst = here.share == worst || here.share.is_nan();
            if chunk.is_empty() || !is_worst {
                return;
            }
            let overlap = chunk.now.geometry[here.contact].overlap;
            let fault = chunk.beyond_fold(here.contact, at, scene, overlap);
            let mut told = told.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            if told
                .as_ref()
                .is_none_or(|(other, _)| (at.wall, at.chunk) < (other.wall, other.chunk))
            {
                *told = Some((at, fault));
            }
        });
        let told = told.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
        told.map_or_else(
            || Fault::NotFinite {
                step: self.step,
                id: self.grains.id[0],
                quantity: "coupled force",
                position: self.grains.position[0],
            },
            |(_, fault)| fault,
        )
    }

    /// Whether no surface bulges farther than contacts were looked for; if not, looks farther.
    fn bulges_as_foreseen(&mut self) -> bool {
        let force =
            |contacts: &Contacts, place: ContactPlace| place.chunk(contacts).coupling.trial[place.contact as usize];
        let foreseen = self.coupling.as_ref().map_or_else(Vec::new, |c| c.bulge.clone());
        self.bound_bulges(force, |bulge, bound| {
            if bound > *bulge {
                *bulge = ALLOWANCE * bound;
            }
        });
        self.coupling.as_ref().is_none_or(|c| c.bulge == foreseen)
    }

    fn bulges_by_id(&self) -> Vec<(u32, f64)> {
        let Some(state) = &self.coupling else { return Vec::new() };
        let mut bulges: Vec<(u32, f64)> = (self.grains.id.iter().copied())
            .zip(state.bulge.iter().copied())
            .collect();
        bulges.sort_unstable_by_key(|b| b.0);
        bulges
    }

    fn set_bulges(&mut self, by_id: &[(u32, f64)]) {
        let Some(state) = &mut self.coupling else { return };
        for (bulge, id) in state.bulge.iter_mut().zip(&self.grains.id) {
            if let Ok(place) = by_id.binary_search_by_key(id, |b| b.0) {
                *bulge = by_id[place].1;
            }
        }
    }
}
