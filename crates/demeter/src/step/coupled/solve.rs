//! The coupled equation of contacts that feel each other, solved by plain iterations and then by mixing.

use crate::contacts::coupling::displaced::Scale;
use crate::contacts::coupling::mixing::{Largest, Products, Progress};
use crate::contacts::coupling::{Coupling, DEFAULT_TOLERANCE};
use crate::contacts::{ContactChunk, Contacts, Fault};
use crate::simulation::Simulation;
use crate::simulation::division::known_grains;
use std::sync::{Mutex, PoisonError};

/// Iteration from which on it is watched whether forces fall as surfaces come nearer.
const FIRST_WATCHED: usize = 4;

/// Iterations after which contacts whose forces do give way more, again and again.
const PATIENCE_WITH_FALLS: usize = 30;

/// Iterations after which contacts give way whose force falls, even if they come closer to a solution.
const PATIENCE_WITH_THOSE_THAT_COME_CLOSER: usize = 200;

/// Iterations after which forces are good enough that are as close to a solution as this.
const PATIENCE_WITH_ROUNDING: usize = 100;
const ROUNDING: f64 = 1e-10;

/// Iterations after which the coupled equation is given up.
const MOST_ITERATIONS: usize = 1000;

impl Simulation {
    /// Solves the coupled equation at the places of this step.
    pub(super) fn solve_coupling(&mut self, max_speed: f64) -> Result<(), Fault> {
        let Some(state) = &self.coupling else { return Ok(()) };
        let feels_levers = state.kernels.feel_levers();
        let tolerance = match state.scheme {
            Coupling::Converged { tolerance } => tolerance,
            Coupling::Lagged => DEFAULT_TOLERANCE,
        };
        // at first all displacements are new
        self.clear_changes();
        self.note_all_forces();
        let [of_all] = self.largest_of_all([self.largest_force()]);
        let mut progress = Progress::begin();
        for iteration in 1..=MOST_ITERATIONS {
            self.with_chunks(max_speed, |at, chunk, _, scene, state| {
                let of_grains = &state.largest_force;
                chunk.answer(at, scene, Scale { of_grains, of_all }, &state.changes);
            });
            let worst = self.worst();
            if worst.is_nan() {
                break;
            }
            self.clear_changes();
            // laws that follow a path are exact to rounding only
            let enough = if iteration > PATIENCE_WITH_ROUNDING {
                tolerance.max(ROUNDING)
            } else {
                tolerance
            };
            if worst > enough {
                let mixes = progress.mixes(iteration, worst);
                if iteration >= FIRST_WATCHED && self.watch_falls(iteration) {
                    progress = Progress::begin();
                }
                if !mixes {
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

    /// Forgets what has changed at the contacts of the grains that are known here.
    pub(super) fn clear_changes(&mut self) {
        let known = known_grains(self.division.as_deref(), self.grains.len());
        if let Some(state) = &mut self.coupling {
            state.changes.clear(self.grains.len(), known);
        }
    }

    /// Notes that the forces tried have changed on all grains.
    fn note_all_forces(&self) {
        let Some(state) = &self.coupling else { return };
        known_grains(self.division.as_deref(), self.grains.len())
            .for_each(|grain| state.changes.note_force(grain as u32));
    }

    /// Finds the displacements anew where forces or levers have changed.
    fn displace_again(&mut self) {
        let own = self.own_grains();
        let Some(state) = &mut self.coupling else { return };
        let tables = (&self.grains, &self.neighbours, &self.contacts);
        state.each_task(&own, tables, self.instructions, |sites, of, from, mut told| {
            sites.displace_again(of, from, &mut told);
        });
        self.exchange_displacements();
    }

    /// Moves the levers that displacements have changed; tells whether there are such.
    fn move_levers(&mut self, max_speed: f64, tolerance: f64) -> bool {
        self.with_chunks(max_speed, |at, chunk, _, scene, state| {
            chunk.move_levers(at, scene, &state.changes, tolerance);
        });
        let mut own = self.own_grains();
        let moved = own.any(|grain| self.coupling.as_ref().is_some_and(|c| c.changes.any(grain as u32)));
        self.any_of_all(moved)
    }

    /// Looks for contacts whose force falls as their surfaces come nearer; tells whether forces are sought in another way now.
    fn watch_falls(&mut self, iteration: usize) -> bool {
        let once_more = iteration.is_multiple_of(PATIENCE_WITH_FALLS);
        let late = iteration > PATIENCE_WITH_THOSE_THAT_COME_CLOSER;
        let own = self.own_chunks();
        let (mut found, mut more) = (0, 0);
        let pairs = self.contacts.pairs.iter_mut().enumerate();
        let pairs = pairs.map(|(number, chunk)| (own.contains(&number), chunk));
        let walls = self.contacts.walls.iter_mut().map(|chunk| (true, chunk));
        for (counts, chunk) in pairs.chain(walls) {
            let here = chunk.watch_falls(once_more, late);
            found += if counts { here.found } else { 0 };
            more += here.more;
        }
        let found = self.count_of_all(found);
        if let Some(state) = &mut self.coupling {
            state.memory.effort.jumps += found;
        }
        let differs = found > 0 || once_more && self.count_of_all(more) > 0;
        if differs {
            self.chunks_mut().for_each(|chunk| chunk.coupling.mixing.forget());
        }
        differs
    }

    /// Goes on with mixed forces.
    fn mix(&mut self, progress: &mut Progress) {
        let mut largest = self.note_deviations();
        let mut products = self.products(&largest);
        if progress.is_lost(&products, &largest) {
            self.chunks_mut().for_each(|chunk| chunk.coupling.mixing.forget());
            largest = self.note_deviations();
            products = self.products(&largest);
        }
        let weights = products.weights(&largest);
        self.chunks_mut().for_each(|chunk| chunk.coupling.advance(&weights));
        self.note_all_forces();
    }

    fn note_deviations(&mut self) -> Largest {
        let all = |largest: Largest, chunk: &mut ContactChunk| largest.join(&chunk.coupling.note());
        let here = self.chunks_mut().fold(Largest::default(), all);
        Largest::of_numbers(self.largest_of_all(here.numbers()))
    }

    fn products(&self, largest: &Largest) -> Products {
        let Contacts { pairs, walls, .. } = &self.contacts;
        let own = pairs[self.own_chunks()].iter().chain(walls);
        let of_own = own.map(|chunk| chunk.coupling.mixing.products(largest));
        let add = |sum: Products, of_some: Products| sum.add(&of_some);
        let all = self.of_all_segments(vec![of_own.fold(Products::default(), add)]);
        all.into_iter().fold(Products::default(), add)
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

    /// The largest deviation of any contact; not a number where any is none.
    fn worst(&self) -> f64 {
        let here = self.chunks().map(|chunk| chunk.coupling.worst.share).fold(0.0, worse);
        let [worst] = self.largest_of_all([here]);
        worst
    }

    /// The fault at the contact that is farthest from a solution: of several the one of the grain with the lowest id.
    fn beyond_fold(&mut self, max_speed: f64) -> Fault {
        let worst = self.worst();
        let told = Mutex::new(Vec::new());
        self.with_chunks(max_speed, |at, chunk, _, scene, _| {
            let here = chunk.coupling.worst;
            if chunk.is_empty() || !(here.share == worst || here.share.is_nan()) {
                return;
            }
            let overlap = chunk.now.geometry[here.contact].overlap;
            let fault = chunk.beyond_fold(here.contact, at, scene, overlap);
            told.lock().unwrap_or_else(PoisonError::into_inner).push(fault);
        });
        let told = told.into_inner().unwrap_or_else(PoisonError::into_inner);
        let first = told.into_iter().min_by_key(|fault| (fault.grain(), fault.to_string()));
        self.fault_of_any(first).err().unwrap_or_else(|| Fault::NotFinite {
            step: self.step,
            id: self.grains.id[0],
            quantity: "coupled force".into(),
            position: self.grains.position[0],
        })
    }
}

/// The larger of two deviations; not a number where either is none.
fn worse(one: f64, other: f64) -> f64 {
    if one.is_nan() || one > other { one } else { other }
}
