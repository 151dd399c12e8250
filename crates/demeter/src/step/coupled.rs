//! Forces of contacts that feel each other ([`crate::contacts::coupling`]).

mod solve;

use crate::comm::parts::{InParts, Listed, Part};
use crate::contacts::coupling::Coupling;
use crate::contacts::coupling::bulge::{ALLOWANCE, Bounds, FIRST_BULGE};
use crate::contacts::coupling::displaced::ChunkPlace;
use crate::contacts::coupling::kernels::Kernels;
use crate::contacts::coupling::sites::{Changes, GRAINS_PER_TASK, Scenery, Sites, Told};
use crate::contacts::sum::{Adder, Work};
use crate::contacts::{ContactChunk, Contacts, Fault, Scene};

use super::parts;
use crate::materials::Materials;
use crate::neighbours::{Neighbours, Pairs, WallPair};
use crate::particles::Grains;
use crate::simulation::Simulation;
use crate::simulation::division::known_grains;
use demeter_physics::lanes::Instructions;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::ops::Range;

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
    pub(crate) needed: Vec<f64>,
    /// Largest force on every grain [N].
    pub(crate) largest_force: Vec<f64>,
    pub(crate) changes: Changes,
}

/// What a restart needs of it.
#[derive(Clone, Debug, Default, Deserialize)]
pub struct CouplingMemory {
    /// Bounds of the bulges of the grains that the run began with.
    bounds: Bounds,
    /// How far the surface of every grain may bulge in this step [m].
    pub(crate) bulge: Vec<f64>,
    max_bulge: f64,
    /// What candidates were looked for beyond the skin because surfaces bulge [m].
    pub(crate) margin: f64,
    pub(crate) effort: Effort,
}

/// What is saved of a [`CouplingMemory`].
#[derive(Serialize)]
#[serde(rename = "CouplingMemory")]
struct Written<'a, 'b> {
    bounds: &'b Bounds,
    bulge: Listed<'a, 'b, f64>,
    max_bulge: f64,
    margin: f64,
    effort: Effort,
}

impl InParts for CouplingMemory {
    fn in_parts<'a>(&'a self, part: &'a Part<'_>) -> impl Serialize + 'a {
        Written {
            bounds: &self.bounds,
            bulge: part.of_grains(&self.bulge),
            max_bulge: self.max_bulge,
            margin: self.margin,
            effort: self.effort,
        }
    }
}

/// What solving the coupled equation took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Effort {
    /// Equations solved: one per step.
    pub solutions: u64,
    /// Iterations that they took.
    pub iterations: u64,
    /// Steps whose search for contacts was repeated because surfaces bulged more than was foreseen.
    pub repeats: u64,
    /// Contacts whose force falls as their surfaces come nearer: where a pull begins or ends with a jump, they act for a share of the step.
    pub jumps: u64,
}

impl Effort {
    /// What was added to an earlier one.
    pub(crate) fn since(self, earlier: Self) -> Self {
        Self {
            solutions: self.solutions - earlier.solutions,
            iterations: self.iterations - earlier.iterations,
            repeats: self.repeats - earlier.repeats,
            jumps: self.jumps - earlier.jumps,
        }
    }
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
            largest_force: Vec::new(),
            changes: Changes::default(),
        })
    }

    /// Notes that the tables of contacts are others now.
    pub(crate) fn outdate(&self) {
        self.sites.iter().for_each(Sites::outdate);
    }

    /// Notes that candidates are found now: with room for bulges to grow.
    pub(crate) fn take_margin(&mut self, skin: f64) {
        self.outdate();
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
    let place = |wall: bool| ChunkPlace { wall };
    let pairs = (contacts.pairs.par_iter_mut().enumerate())
        .map(|(c, chunk)| work(place(false), chunk, Candidates::Pairs(neighbours.chunk(c))));
    let walls = (contacts.walls.par_iter_mut().enumerate())
        .map(|(c, chunk)| work(place(true), chunk, Candidates::Walls(neighbours.wall_chunk(c))));
    pairs.chain(walls).for_each(|()| ());
}

/// Candidates of a chunk, and their material pair.
#[derive(Clone, Copy)]
enum Candidates<'a> {
    Pairs((Pairs<'a>, u32)),
    Walls((&'a [WallPair], u32)),
}

/// How far a surface may bulge that needs so much now [m].
fn foreseen(needed: f64, radius: f64) -> f64 {
    ALLOWANCE * needed + FIRST_BULGE * radius
}

impl CouplingState {
    /// Works on the sites of own grains, in parallel: the sites of a task, its grains, what they are found from, and what they tell.
    fn each_task<'a>(
        &mut self,
        own: &Range<usize>,
        (grains, neighbours, contacts): (&'a Grains, &'a Neighbours, &'a Contacts),
        instructions: Instructions,
        work: impl Fn(&mut Sites, Range<usize>, Scenery<'_>, Told<'_>) + Sync + Send,
    ) {
        self.sites
            .resize_with(own.len().div_ceil(GRAINS_PER_TASK), Sites::default);
        self.needed.resize(grains.len(), 0.0);
        self.largest_force.resize(grains.len(), 0.0);
        let from = Scenery {
            grains,
            neighbours,
            contacts,
            kernels: &self.kernels,
            bounds: &self.memory.bounds,
            changes: &self.changes,
            instructions,
        };
        let of_tasks = self.needed[own.clone()].par_chunks_mut(GRAINS_PER_TASK);
        let of_tasks = of_tasks.zip(self.largest_force[own.clone()].par_chunks_mut(GRAINS_PER_TASK));
        let tasks = self.sites.par_iter_mut().zip(of_tasks);
        tasks.enumerate().for_each(|(task, (sites, (bulge, largest_force)))| {
            let first = own.start + task * GRAINS_PER_TASK;
            work(sites, first..first + bulge.len(), from, Told { bulge, largest_force });
        });
    }

    /// Notes which grains have other contacts than in the step before.
    fn outdate_sites(&self, own: &Range<usize>, chunk: &ContactChunk, candidates: Candidates<'_>) {
        if !chunk.is_renewed {
            return;
        }
        let outdate = |grain: u32| {
            let grain = grain as usize;
            if own.contains(&grain) {
                let place = grain - own.start;
                if let Some(sites) = self.sites.get(place / GRAINS_PER_TASK) {
                    sites.outdate_grain(place % GRAINS_PER_TASK);
                }
            }
        };
        match candidates {
            Candidates::Pairs((pairs, _)) => chunk.coming_or_going().for_each(|candidate| {
                let pair = pairs.get(usize::from(candidate));
                outdate(pair.i);
                outdate(pair.j);
            }),
            Candidates::Walls((pairs, _)) => pairs.iter().for_each(|pair| outdate(pair.grain)),
        }
    }

    /// Has contacts be looked for farther away where surfaces of some grains bulge more than was foreseen; tells how far at most [m], 0
    /// where none does.
    fn bulges_farther(&mut self, grains: &Grains, some: impl Iterator<Item = usize>) -> f64 {
        let (bulge, needed) = (&mut self.memory.bulge, &self.needed);
        let mut farthest = 0.0;
        for grain in some {
            if needed[grain] > bulge[grain] {
                bulge[grain] = foreseen(needed[grain], grains.radius(grain));
                farthest = f64::max(farthest, bulge[grain]);
            }
        }
        farthest
    }

    /// Takes what the latest forces on some grains need, with an allowance, for the next step; tells how far any bulges [m].
    fn foresee(&mut self, grains: &Grains, some: impl Iterator<Item = usize>) -> f64 {
        let bulge = &mut self.memory.bulge;
        bulge.resize(grains.len(), 0.0);
        some.fold(0.0, |farthest, grain| {
            bulge[grain] = foreseen(self.needed[grain], grains.radius(grain));
            f64::max(farthest, bulge[grain])
        })
    }
}

impl Simulation {
    /// Finds how far surfaces may bulge from the forces of the step before: after grains were put in another order.
    pub(crate) fn foresee_bulges(&mut self) {
        let own = self.own_grains();
        let Some(state) = &mut self.coupling else { return };
        let tables = (&self.grains, &self.neighbours, &self.contacts);
        state.each_task(&own, tables, self.instructions, |_, of, from, told| {
            for (needed, grain) in told.bulge.iter_mut().zip(of) {
                *needed = from.bounds.of_grain(grain, from.grains, from.neighbours, from.contacts);
            }
        });
        self.exchange_bulges();
        self.foresee();
    }

    /// Takes what the latest forces need, with an allowance, for the next step.
    fn foresee(&mut self) {
        let known = known_grains(self.division.as_deref(), self.grains.len());
        let Some(state) = &mut self.coupling else { return };
        let max_bulge = state.foresee(&self.grains, known);
        let [max_bulge] = self.largest_of_all([max_bulge]);
        self.coupling.iter_mut().for_each(|c| c.memory.max_bulge = max_bulge);
    }

    /// Whether no surface bulges farther than contacts were looked for; if not, they will be looked for farther away.
    fn bulges_as_foreseen(&mut self) -> bool {
        let known = known_grains(self.division.as_deref(), self.grains.len());
        let Some(state) = &mut self.coupling else { return true };
        let farthest = state.bulges_farther(&self.grains, known);
        let [farthest] = self.largest_of_all([farthest]);
        if let Some(state) = &mut self.coupling {
            state.memory.max_bulge = state.memory.max_bulge.max(farthest);
        }
        farthest == 0.0
    }

    /// Narrow phase, displacements and contact laws.
    pub(super) fn find_coupled_contacts(&mut self, max_speed: f64) -> Result<(), Fault> {
        loop {
            self.look_for_contacts(max_speed);
            self.gather_sites();
            if self.solves()
                && let Err(fault) = self.solve_coupling(max_speed)
            {
                if self.step == 0 {
                    self.take_back_contacts();
                } else {
                    self.displace_as_before(max_speed);
                }
                return Err(fault);
            }
            if self.bulges_as_foreseen() {
                break;
            }
            let Some(state) = &mut self.coupling else { return Ok(()) };
            state.memory.effort.repeats += 1;
            let farther = state.bulges_of_two() > state.memory.margin + SHARE_OF_SKIN * self.skin;
            self.take_back_contacts();
            if farther {
                self.find_candidates_for_bulges();
            }
        }
        self.evaluate_displaced(max_speed);
        self.foresee();
        Ok(())
    }

    /// Where no coupled force is found in a step, has the forces of the step before displace, so that the books close where a run stops.
    fn displace_as_before(&mut self, max_speed: f64) {
        self.with_chunks(max_speed, |at, chunk, _, _, _| chunk.begin_coupling(at, false));
        self.gather_sites();
        self.evaluate_displaced(max_speed);
    }

    /// Evaluates the laws at the displaced surfaces, and sums up.
    fn evaluate_displaced(&mut self, max_speed: f64) {
        let (mut contacts, mut sums) = (std::mem::take(&mut self.contacts), std::mem::take(&mut self.sums));
        let mut loads = std::mem::take(&mut self.grains.load);
        if let Some(scene) = self.coupled_scene(max_speed, contacts.stride) {
            let work = Work {
                neighbours: &self.neighbours,
                segments: self.segments_here(),
                instructions: self.instructions,
                step: |_: usize, chunk: &mut ContactChunk, adder: &mut Adder| {
                    chunk.deform(ChunkPlace { wall: false }, &scene);
                    chunk.evaluate_pairs(&scene, adder);
                },
                at_walls: |_: usize, chunk: &mut ContactChunk, adder: &mut Adder| {
                    chunk.deform(ChunkPlace { wall: true }, &scene);
                    chunk.evaluate_walls(&scene, adder);
                },
            };
            let own = self.own_grains();
            let parts = parts(own.len());
            sums.work((&mut loads, &mut contacts), own, parts, &work);
        }
        (self.contacts, self.sums, self.grains.load) = (contacts, sums, loads);
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
            span: self.span,
            integrator: self.integrator,
            step: self.step,
            max_speed,
            surfaces: &self.surfaces,
            max_reach: self.max_reach,
            max_overlap: self.max_overlap,
            stride,
            resists_rolling: self.resists_rolling,
            records_walls: self.records_walls,
            tells_impacts: self.watches_impacts(),
            instructions: self.instructions,
            bulge: &state.memory.bulge,
        })
    }

    /// Whether the coupled equation is solved in this step: a run begins with forces that are in agreement.
    fn solves(&self) -> bool {
        self.step == 0 || self.coupling.as_ref().is_some_and(|c| c.scheme != Coupling::Lagged)
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
        let (own, converge) = (self.own_grains(), self.solves());
        self.with_chunks(max_speed, |at, chunk, candidates, scene, state| {
            match candidates {
                Candidates::Pairs(pairs) => chunk.find_pairs(pairs, scene),
                Candidates::Walls(pairs) => chunk.find_walls(pairs, scene),
            }
            state.outdate_sites(&own, chunk, candidates);
            chunk.begin_coupling(at, converge);
        });
    }

    fn take_back_contacts(&mut self) {
        let own = self.own_grains();
        let Some(state) = &self.coupling else { return };
        each_chunk(&mut self.contacts, &self.neighbours, |_, chunk, candidates| {
            state.outdate_sites(&own, chunk, candidates);
            match candidates {
                Candidates::Pairs((pairs, _)) => chunk.take_back(pairs.len(), |c| {
                    let pair = pairs.get(c);
                    (pair.i, pair.j)
                }),
                Candidates::Walls((pairs, _)) => chunk.take_back(pairs.len(), |c| (pairs[c].grain, pairs[c].wall)),
            }
        });
    }

    /// Gathers the sites of own grains, and finds their influences on each other and the displacements.
    fn gather_sites(&mut self) {
        self.clear_changes();
        // displacements may be found again where the coupled equation is solved
        let is_kept = self.solves();
        let own = self.own_grains();
        let Some(state) = &mut self.coupling else { return };
        let tables = (&self.grains, &self.neighbours, &self.contacts);
        state.each_task(&own, tables, self.instructions, |sites, of, from, mut told| {
            sites.work(of, is_kept, from, &mut told);
        });
        self.exchange_displacements();
    }

    /// Finds the candidates anew in the middle of a step, for bulges that are known already.
    fn find_candidates_for_bulges(&mut self) {
        self.share_bulges();
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
        // others are neighbours now
        self.exchange_borders(|_| ());
    }
}
