//! Forces of contacts that feel each other ([`crate::contacts::coupling`]).

use crate::contacts::coupling::bulge::{ALLOWANCE, Bounds, FIRST_BULGE};
use crate::contacts::coupling::displaced::ChunkPlace;
use crate::contacts::coupling::kernels::Kernels;
use crate::contacts::coupling::mixing::{Largest, Products, Progress};
use crate::contacts::coupling::sites::{Changes, GRAINS_PER_TASK, Scenery, Sites};
use crate::contacts::coupling::{Coupling, DEFAULT_TOLERANCE, Worst};
use crate::contacts::sum::{Collector, Work};
use crate::contacts::{ContactChunk, Contacts, Fault, Scene};

use super::parts;
use crate::materials::Materials;
use crate::neighbours::{Neighbours, Pair, WallPair};
use crate::particles::Grains;
use crate::simulation::Simulation;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Plain iterations before forces are mixed: near rest one is enough.
const PLAIN_ITERATIONS: usize = 6;

/// Iterations after which a force that jumps may be the reason for having no solution.
const PATIENCE_WITH_JUMPS: usize = 30;

/// Iterations after which the coupled equation is given up.
const MOST_ITERATIONS: usize = 1000;

/// Candidates are found for bulges this much larger than those foreseen.
const ROOM_TO_GROW: f64 = 1.2;

/// Share of the skin that bulges may take from the motion before candidates are looked for farther away.
const SHARE_OF_SKIN: f64 = 0.5;

/// Everything that coupled contacts need beyond what a contact remembers.
#[derive(Debug)]
pub(crate) struct CouplingState {
    pub(crate) scheme: Coupling,
    pub(crate) memory: CouplingMemory,
    kernels: Kernels,
    sites: Vec<Sites>,
    /// How far the surface of every grain bulges at most by the forces known [m].
    needed: Vec<f64>,
    changes: Changes,
}

/// What a restart needs of it.
#[derive(Clone, Debug, Default, serde::Serialize, serde::Deserialize)]
pub struct CouplingMemory {
    /// Bounds of the bulges of the grains that the run began with.
    bounds: Bounds,
    /// How far the surface of every grain may bulge in this step [m].
    bulge: Vec<f64>,
    max_bulge: f64,
    /// What candidates were looked for beyond the skin because surfaces bulge [m].
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
    /// Contacts whose force began or ended with a jump, so that they lagged in that step.
    pub jumps: u64,
}

impl CouplingState {
    /// Nothing where no contact feels another.
    pub(crate) fn new(scheme: Coupling, grains: &Grains, materials: &Materials) -> Option<Self> {
        materials.are_coupled().then(|| Self {
            scheme,
            memory: CouplingMemory {
                bounds: Bounds::new(grains, materials),
                ..CouplingMemory::default()
            },
            kernels: Kernels::new(materials),
            sites: Vec::new(),
            needed: Vec::new(),
            changes: Changes::default(),
        })
    }

    /// Notes that candidates are found now: with room for bulges to grow.
    pub(crate) fn take_margin(&mut self, skin: f64) {
        self.memory.margin = (ROOM_TO_GROW * self.bulges_of_two() - SHARE_OF_SKIN * skin).max(0.0);
    }

    /// Distance beyond touching at which displaced surfaces may meet in this step [m].
    pub(crate) fn bulges_of_two(&self) -> f64 {
        2.0 * self.memory.max_bulge
    }
}

/// Chunks of contacts between grains and with walls, with their places and candidates.
fn each_chunk<'a>(
    contacts: &'a mut Contacts,
    neighbours: &'a Neighbours,
    work: impl Fn(ChunkPlace, &mut ContactChunk, Candidates<'a>) + Sync + Send,
) {
    let place = |wall: bool, chunk: usize| ChunkPlace { wall, chunk };
    let pairs = (contacts.pairs.par_iter_mut().enumerate())
        .map(|(c, chunk)| work(place(false, c), chunk, Candidates::Pairs(neighbours.chunk(c))));
    let walls = (contacts.walls.par_iter_mut().enumerate())
        .map(|(c, chunk)| work(place(true, c), chunk, Candidates::Walls(neighbours.wall_chunk(c))));
    pairs.chain(walls).for_each(|()| ());
}

/// Candidates of a chunk, and their material pair.
#[derive(Clone, Copy)]
enum Candidates<'a> {
    Pairs((&'a [Pair], u32)),
    Walls((&'a [WallPair], u32)),
}

/// How far a surface may bulge that needs so much now [m].
fn foreseen(needed: f64, radius: f64) -> f64 {
    ALLOWANCE * needed + FIRST_BULGE * radius
}

impl CouplingState {
    /// Works on the sites of all grains, in parallel: the sites of a task, its grains, what they are found from, and how far
    /// their surfaces bulge.
    fn each_task<'a>(
        &mut self,
        (grains, neighbours, contacts): (&'a Grains, &'a Neighbours, &'a Contacts),
        work: impl Fn(&mut Sites, std::ops::Range<usize>, Scenery<'_>, &mut [f64]) + Sync + Send,
    ) {
        self.sites
            .resize_with(grains.len().div_ceil(GRAINS_PER_TASK), Sites::default);
        self.needed.resize(grains.len(), 0.0);
        let from = Scenery {
            grains,
            neighbours,
            contacts,
            kernels: &self.kernels,
            bounds: &self.memory.bounds,
            changes: &self.changes,
        };
        let tasks = (self.sites.par_iter_mut()).zip(self.needed.par_chunks_mut(GRAINS_PER_TASK));
        tasks.enumerate().for_each(|(task, (sites, needed))| {
            let first = task * GRAINS_PER_TASK;
            work(sites, first..first + needed.len(), from, needed);
        });
    }

    /// Whether no surface bulges farther than contacts were looked for; if not, they will be looked for farther away.
    fn bulges_as_foreseen(&mut self, grains: &Grains) -> bool {
        let CouplingMemory { bulge, max_bulge, .. } = &mut self.memory;
        let mut as_foreseen = true;
        for ((bulge, needed), radius) in bulge.iter_mut().zip(&self.needed).zip(grains.radii()) {
            if needed > bulge {
                *bulge = foreseen(*needed, radius);
                *max_bulge = max_bulge.max(*bulge);
                as_foreseen = false;
            }
        }
        as_foreseen
    }

    /// Takes what the latest forces need, with an allowance, for the next step.
    fn foresee(&mut self, grains: &Grains) {
        self.memory.bulge.clear();
        let bulges = self.needed.iter().zip(grains.radii());
        self.memory
            .bulge
            .extend(bulges.map(|(needed, radius)| foreseen(*needed, radius)));
        self.memory.max_bulge = self.memory.bulge.iter().copied().fold(0.0, f64::max);
    }
}

impl Simulation {
    /// Finds how far surfaces may bulge from the forces of the step before: after grains were put in another order.
    pub(crate) fn foresee_bulges(&mut self) {
        let Some(state) = &mut self.coupling else { return };
        state.each_task(
            (&self.grains, &self.neighbours, &self.contacts),
            |_, of, from, needed| {
                for (needed, grain) in needed.iter_mut().zip(of) {
                    *needed = from.bounds.of_grain(grain, from.grains, from.neighbours, from.contacts);
                }
            },
        );
        state.foresee(&self.grains);
    }

    /// Narrow phase, displacements and contact laws.
    pub(super) fn find_coupled_contacts(&mut self, max_speed: f64) -> Result<(), Fault> {
        loop {
            self.look_for_contacts(max_speed);
            self.gather_sites();
            // a run begins with forces that are in agreement
            if (self.step == 0 || !self.lags())
                && let Err(fault) = self.solve_coupling(max_speed)
            {
                self.take_back_contacts();
                return Err(fault);
            }
            let Some(state) = &mut self.coupling else { return Ok(()) };
            if state.bulges_as_foreseen(&self.grains) {
                break;
            }
            state.memory.effort.repeats += 1;
            let farther = state.bulges_of_two() > state.memory.margin + SHARE_OF_SKIN * self.skin;
            self.take_back_contacts();
            if farther {
                self.find_candidates_for_bulges();
            }
        }
        self.evaluate_displaced(max_speed);
        if let Some(state) = &mut self.coupling {
            state.foresee(&self.grains);
        }
        Ok(())
    }

    /// Evaluates the laws at the displaced surfaces, and sums up.
    fn evaluate_displaced(&mut self, max_speed: f64) {
        let (mut contacts, mut sums) = (std::mem::take(&mut self.contacts), std::mem::take(&mut self.sums));
        if let Some(scene) = self.coupled_scene(max_speed, contacts.stride) {
            contacts.walls.par_iter_mut().enumerate().for_each(|(chunk, walls)| {
                walls.deform(ChunkPlace { wall: true, chunk }, &scene);
                walls.evaluate_walls(&scene);
            });
            let work = Work {
                neighbours: &self.neighbours,
                segments: 0..self.neighbours.segments(),
                instructions: self.instructions,
                waits: scene.is_deforming(),
                step: |number: usize, chunk: &mut ContactChunk, collector: &mut Collector| {
                    let at = ChunkPlace {
                        wall: false,
                        chunk: number,
                    };
                    chunk.deform(at, &scene);
                    chunk.evaluate_pairs(&scene, collector);
                },
            };
            let grains = self.grains.len();
            sums.work(&mut contacts.pairs, grains, parts(grains), &work);
        }
        (self.contacts, self.sums) = (contacts, sums);
    }

    /// What contacts that feel each other are made of.
    fn coupled_scene(&self, max_speed: f64, stride: usize) -> Option<Scene<'_>> {
        let state = self.coupling.as_ref()?;
        Some(Scene {
            grains: &self.grains,
            walls: &self.walls,
            materials: &self.materials,
            comm: &self.comm,
            dt: self.dt,
            integrator: self.integrator,
            step: self.step,
            max_speed,
            path: f64::INFINITY,
            max_reach: self.max_reach,
            max_overlap: self.max_overlap,
            stride,
            resists_rolling: self.resists_rolling,
            records_walls: self.records_walls,
            near: None,
            instructions: self.instructions,
            bulge: &state.memory.bulge,
        })
    }

    fn lags(&self) -> bool {
        self.coupling.as_ref().is_none_or(|c| c.scheme == Coupling::Lagged)
    }

    /// Works on all chunks, in parallel.
    fn with_chunks(
        &mut self,
        max_speed: f64,
        work: impl Fn(ChunkPlace, &mut ContactChunk, Candidates<'_>, &Scene<'_>, &CouplingState) + Sync + Send,
    ) {
        let mut contacts = std::mem::take(&mut self.contacts);
        if let (Some(state), Some(scene)) = (&self.coupling, self.coupled_scene(max_speed, contacts.stride)) {
            each_chunk(&mut contacts, &self.neighbours, |at, chunk, candidates| {
                work(at, chunk, candidates, &scene, state);
            });
        }
        self.contacts = contacts;
    }

    fn look_for_contacts(&mut self, max_speed: f64) {
        let Some(state) = &self.coupling else { return };
        let scheme = if self.step == 0 && state.scheme == Coupling::Lagged {
            Coupling::default()
        } else {
            state.scheme
        };
        self.with_chunks(max_speed, |at, chunk, candidates, scene, state| {
            match candidates {
                Candidates::Pairs(pairs) => chunk.find_pairs(pairs, scene),
                Candidates::Walls(pairs) => chunk.find_walls(pairs, scene),
            }
            chunk.begin_coupling(at, scene, scheme, &state.kernels);
        });
    }

    fn take_back_contacts(&mut self) {
        each_chunk(
            &mut self.contacts,
            &self.neighbours,
            |_, chunk, candidates| match candidates {
                Candidates::Pairs((pairs, _)) => chunk.take_back(pairs.len(), |c| (pairs[c].i, pairs[c].j)),
                Candidates::Walls((pairs, _)) => chunk.take_back(pairs.len(), |c| (pairs[c].grain, pairs[c].wall)),
            },
        );
    }

    /// Gathers the sites of all grains, and finds their influences on each other and the displacements.
    fn gather_sites(&mut self) {
        let Some(state) = &mut self.coupling else { return };
        state.each_task(
            (&self.grains, &self.neighbours, &self.contacts),
            |sites, of, from, needed| {
                sites.gather(of.clone(), from);
                sites.find_influences(of.clone(), from);
                sites.displace(of, from, needed);
            },
        );
    }

    /// Finds the displacements anew where forces or levers have changed.
    fn displace_again(&mut self) {
        let Some(state) = &mut self.coupling else { return };
        state.each_task(
            (&self.grains, &self.neighbours, &self.contacts),
            |sites, of, from, needed| {
                sites.displace_again(of, from, needed);
            },
        );
    }

    /// Solves the coupled equation at the places of this step.
    fn solve_coupling(&mut self, max_speed: f64) -> Result<(), Fault> {
        let Some(state) = &mut self.coupling else { return Ok(()) };
        let feels_levers = state.kernels.feel_levers();
        let tolerance = match state.scheme {
            Coupling::Converged { tolerance } => tolerance,
            Coupling::Lagged => DEFAULT_TOLERANCE,
        };
        let count = self.grains.len();
        // at first all displacements are new
        state.changes.clear(count);
        (0..count as u32).for_each(|grain| state.changes.note_force(grain));
        let largest = self.largest_force();
        let mut progress = Progress::begin();
        for iteration in 1..=MOST_ITERATIONS {
            self.with_chunks(max_speed, |at, chunk, _, scene, state| {
                chunk.answer(at, scene, &state.sites, &state.changes, largest);
            });
            let worst = self.worst().share;
            if worst.is_nan() {
                break;
            }
            self.coupling.iter_mut().for_each(|c| c.changes.clear(count));
            if worst > tolerance {
                if iteration.is_multiple_of(PATIENCE_WITH_JUMPS) && self.let_jumps_lag(max_speed, worst) > 0 {
                    progress = Progress::begin();
                } else if iteration < PLAIN_ITERATIONS {
                    self.with_chunks(max_speed, |at, chunk, _, _, state| {
                        chunk.iterate(at, &state.changes, tolerance);
                    });
                } else {
                    self.mix(&mut progress);
                }
            } else {
                let moved = feels_levers && self.move_levers(max_speed, tolerance);
                if !moved {
                    if let Some(state) = &mut self.coupling {
                        state.memory.effort.solutions += 1;
                        state.memory.effort.iterations += iteration as u64;
                    }
                    return Ok(());
                }
                progress = Progress::begin();
            }
            self.displace_again();
        }
        Err(self.beyond_fold(max_speed))
    }

    /// Moves the levers that displacements have changed; tells whether there are such.
    fn move_levers(&mut self, max_speed: f64, tolerance: f64) -> bool {
        self.with_chunks(max_speed, |at, chunk, _, scene, state| {
            chunk.move_levers(at, scene, &state.changes, tolerance);
        });
        (0..self.grains.len() as u32).any(|grain| self.coupling.as_ref().is_some_and(|c| c.changes.any(grain)))
    }

    /// Lets the contacts lag that are farthest from a solution because their force jumps; tells how many.
    fn let_jumps_lag(&mut self, max_speed: f64, worst: f64) -> u64 {
        let found = AtomicU64::new(0);
        self.with_chunks(max_speed, |at, chunk, _, _, state| {
            if chunk.coupling.worst.share == worst {
                found.fetch_add(u64::from(chunk.let_jump_lag(at, &state.changes)), Ordering::Relaxed);
            }
        });
        let found = found.into_inner();
        if let Some(state) = &mut self.coupling {
            state.memory.effort.jumps += found;
        }
        if found > 0 {
            self.chunks_mut().for_each(|chunk| chunk.coupling.mixing.forget());
        }
        found
    }

    /// Goes on with mixed forces.
    fn mix(&mut self, progress: &mut Progress) {
        let all = |largest: Largest, chunk: &mut ContactChunk| largest.join(&chunk.coupling.note());
        let mut largest = self.chunks_mut().fold(Largest::default(), all);
        let mut products = self.products(&largest);
        if progress.is_lost(&products, &largest) {
            self.chunks_mut().for_each(|chunk| chunk.coupling.mixing.forget());
            largest = self.chunks_mut().fold(Largest::default(), all);
            products = self.products(&largest);
        }
        let weights = products.weights(&largest);
        self.chunks_mut().for_each(|chunk| chunk.coupling.advance(&weights));
        if let Some(state) = &self.coupling {
            (0..self.grains.len() as u32).for_each(|grain| state.changes.note_force(grain));
        }
    }

    fn products(&mut self, largest: &Largest) -> Products {
        let of_chunk = |chunk: &mut ContactChunk| chunk.coupling.mixing.products(largest);
        self.chunks_mut()
            .map(of_chunk)
            .fold(Products::default(), |sum, p| sum.add(&p))
    }

    fn chunks(&self) -> impl Iterator<Item = &ContactChunk> {
        self.contacts.pairs.iter().chain(&self.contacts.walls)
    }

    fn chunks_mut(&mut self) -> impl Iterator<Item = &mut ContactChunk> {
        self.contacts.pairs.iter_mut().chain(&mut self.contacts.walls)
    }

    /// Largest force that the solution begins with [N].
    fn largest_force(&self) -> f64 {
        let forces = self.chunks().flat_map(|chunk| &chunk.coupling.trial);
        forces.fold(0.0, |largest, force| f64::max(largest, force.abs()))
    }

    fn worst(&self) -> Worst {
        let worse = |worst: Worst, w: Worst| {
            if w.share.is_nan() || w.share > worst.share {
                w
            } else {
                worst
            }
        };
        self.chunks()
            .map(|chunk| chunk.coupling.worst)
            .fold(Worst::default(), worse)
    }

    /// The fault at the contact that is farthest from a solution.
    fn beyond_fold(&mut self, max_speed: f64) -> Fault {
        let worst = self.worst().share;
        let told = std::sync::Mutex::new(None::<(ChunkPlace, Fault)>);
        self.with_chunks(max_speed, |at, chunk, _, scene, _| {
            let here = chunk.coupling.worst;
            if chunk.is_empty() || !(here.share == worst || here.share.is_nan()) {
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
                quantity: "coupled force".into(),
                position: self.grains.position[0],
            },
            |(_, fault)| fault,
        )
    }

    /// Finds the candidates anew in the middle of a step, for bulges that are known already.
    fn find_candidates_for_bulges(&mut self) {
        let Some(state) = &self.coupling else { return };
        let ids = self.grains.id.iter().copied();
        let mut by_id: Vec<(u32, f64)> = ids.zip(state.memory.bulge.iter().copied()).collect();
        by_id.sort_unstable_by_key(|b| b.0);
        self.find_candidates();
        let Some(state) = &mut self.coupling else { return };
        for (bulge, id) in state.memory.bulge.iter_mut().zip(&self.grains.id) {
            if let Ok(place) = by_id.binary_search_by_key(id, |b| b.0) {
                *bulge = by_id[place].1;
            }
        }
    }
}
