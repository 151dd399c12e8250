//! The energy books: what came in, what is stored, what was dissipated.

use super::{Segment, Simulation};
use crate::comm::segment_sums::Summand;
use crate::contacts::laws::{normal_energy, spring_energies};
use crate::contacts::{ContactChunk, Tally};
use crate::walls::{FreeStep, Wall};
use demeter_physics::contact::PairSize;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Energies of the ledger [J].
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Energies {
    /// Kinetic energy of translation.
    pub kinetic: f64,
    /// Kinetic energy of rotation.
    pub rotational: f64,
    /// Potential energy in the field of gravity.
    pub gravitational: f64,
    /// Stored by normal laws; negative where adhesion holds bodies together.
    pub elastic: f64,
    /// Stored by tangential springs.
    pub tangential: f64,
    /// Stored by rolling springs.
    pub rolling: f64,
    /// Dissipated by normal dashpots since the start.
    pub viscous_dissipated: f64,
    /// Lost by normal laws otherwise since the start: plastic work, tear-off of adhesive contacts.
    pub plastic_dissipated: f64,
    /// Dissipated by friction since the start.
    pub friction_dissipated: f64,
    /// Dissipated by rolling resistance since the start.
    pub rolling_dissipated: f64,
    /// Kinetic energy of freely moving walls, with that of their weight and springs.
    pub free_walls: f64,
    /// Lost in dampers and at the stops of freely moving walls since the start.
    pub wall_dissipated: f64,
    /// Work done by the drives of moving walls since the start: on the grains, and on walls that were set free or caught.
    pub wall_work: f64,
    /// Work done on the grains by a box that deforms since the start: by contacts across its sides, by the grains that pass
    /// them, and by the affine flow.
    pub boundary_work: f64,
    /// Work done on the grains by custom forces since the start, with what changes of places and velocities from outside brought.
    pub custom_work: f64,
    /// What multi-contact displacements add to the stored energy at this moment: part of `elastic`.
    pub multi_contact: f64,
    /// Put into the stored energy by multi-contact displacements since the start, without work of the contacts: because
    /// influences change with the geometry, are not mutual, or lag behind. Negative where they took it out.
    pub multi_contact_input: f64,
    /// Energy of grains inserted since the start.
    pub inserted: f64,
    /// Energy of grains removed since the start, and of contacts with walls that were taken away.
    pub removed: f64,
    /// Share of the energy that passed through the system which the books do not explain.
    pub residual: f64,
}

impl Energies {
    /// What is there now: kinetic, gravitational and stored [J].
    pub fn present(&self) -> f64 {
        let grains =
            self.kinetic + self.rotational + self.gravitational + self.elastic + self.tangential + self.rolling;
        grains + self.free_walls
    }

    /// What was dissipated since the start [J].
    pub fn dissipated(&self) -> f64 {
        let contacts =
            self.viscous_dissipated + self.plastic_dissipated + self.friction_dissipated + self.rolling_dissipated;
        contacts + self.wall_dissipated
    }
}

/// Books since the start of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Books {
    /// Work of all steps so far.
    done: Tally,
    /// Work of the latest step: half of it lies behind, half ahead.
    latest: Tally,
    /// Sum of the magnitudes of the wall work of every step [J].
    wall_throughput: f64,
    /// Work done by a box that deforms [J].
    boundary: f64,
    /// Sum of the magnitudes of the work of contacts across its sides and of the kinetic stress [J].
    boundary_throughput: f64,
    /// Energy that the affine flow of the box has given to the grains beside that work, and the most that it ever had [J].
    affine: f64,
    highest_affine: f64,
    /// Lost in dampers and at the stops of freely moving walls [J].
    wall_dissipated: f64,
    /// Largest kinetic energy of the freely moving walls [J].
    highest_wall_kinetic: f64,
    /// Energy at the start [J].
    initial: f64,
    /// Energy at the start without the gravitational part, whose zero is arbitrary [J].
    initial_throughput: f64,
    initial_gravitational: f64,
    lowest_gravitational: f64,
    /// Depth of the well into which attraction drew bodies [J], not positive.
    lowest_elastic: f64,
    removed: f64,
    /// Number of grains removed since the start.
    pub removed_grains: u64,
    /// Number and mass [kg] of the grains that left the domain and were removed.
    outside: (u64, f64),
    inserted: f64,
    /// Energy that came with grains without the gravitational part, whose zero is arbitrary [J].
    inserted_throughput: f64,
    /// Number of grains inserted since the start.
    pub inserted_grains: u64,
    /// Work of custom forces [J], the sum of its magnitudes in every step, and their power in the latest one [W].
    custom: f64,
    custom_throughput: f64,
    custom_power: f64,
}

impl Books {
    /// Opens the books with what is there at the start, and with the work of the forces of that moment: half of it lies ahead.
    pub(crate) fn open(&mut self, energies: &Energies, step: Tally) {
        self.latest = step;
        self.initial = energies.present();
        self.initial_throughput = energies.present() - energies.gravitational;
        self.initial_gravitational = energies.gravitational;
        self.lowest_gravitational = energies.gravitational;
    }

    /// Books one step. A force acts from half a step before its moment to half a step after it, so the work up to now
    /// is half of the latest step's.
    pub(crate) fn book(&mut self, step: Tally) {
        for work in [self.latest, step] {
            self.done.add(&Tally {
                viscous: 0.5 * work.viscous,
                plastic: 0.0,
                friction: 0.5 * work.friction,
                rolling: 0.5 * work.rolling,
                wall_work: 0.5 * work.wall_work,
                multi_contact: 0.0,
            });
        }
        // but what laws remember, and with it what they store, is that of the end of the step already
        self.done.plastic += step.plastic;
        self.done.multi_contact += step.multi_contact;
        self.wall_throughput += step.wall_work.abs();
        self.latest = step;
    }

    /// Takes forces that were found anew for those of the latest step: half a step of them lies ahead. Told is what they do in a time so
    /// many times shorter.
    pub(crate) fn go_on_with(&mut self, work: Tally, times: f64) {
        self.latest = Tally {
            viscous: times * work.viscous,
            friction: times * work.friction,
            rolling: times * work.rolling,
            wall_work: times * work.wall_work,
            ..Tally::default()
        };
    }

    /// Books work of contacts across the sides of a box that deforms [J].
    pub(crate) fn work_across(&mut self, work: f64) {
        self.boundary += work;
        self.boundary_throughput += work.abs();
    }

    /// Books kinetic energy that grains got by passing the sides of a box that deforms, or from its affine flow, and how much of
    /// it was work of their stress [J].
    pub(crate) fn carry_along(&mut self, energy: f64, work: f64) {
        self.boundary += energy;
        self.boundary_throughput += work.abs();
        self.affine += energy - work;
        self.highest_affine = self.highest_affine.max(self.affine.abs());
    }

    /// Books what freely moving walls did in a step of `dt` [s].
    pub(crate) fn book_free_walls(&mut self, step: &FreeStep, dt: f64) {
        self.wall_throughput += (step.power * dt).abs();
        self.wall_dissipated += step.dissipated;
        self.highest_wall_kinetic = self.highest_wall_kinetic.max(step.kinetic);
    }

    /// Books what a drive did on walls that were set free or caught.
    pub(crate) fn drive_walls(&mut self, work: f64) {
        self.done.wall_work += work;
        self.wall_throughput += work.abs();
    }

    /// Books what was stored in contacts with walls that are taken away.
    pub(crate) fn take_wall_away(&mut self, stored: f64) {
        self.removed += stored;
    }

    /// Books the power of custom forces at the end of a step of `dt` [s]: their work in it is the mean of both ends.
    pub(crate) fn book_custom(&mut self, power: f64, dt: f64) {
        self.intervene(0.5 * dt * (self.custom_power + power));
        self.custom_power = power;
    }

    /// Books work that was done on grains from outside [J].
    pub(crate) fn intervene(&mut self, work: f64) {
        self.custom += work;
        self.custom_throughput += work.abs();
    }

    /// Books what another gravity did to the gravitational energy [J].
    pub(crate) fn turn_gravity(&mut self, change: f64) {
        self.custom += change;
        // it depends on the origin, and must not look like a fall of the grains
        self.lowest_gravitational += change;
        self.initial_gravitational += change;
    }

    /// Books the removal of grains that carried these energies.
    pub(crate) fn remove(&mut self, grains: u64, gone: &Energies) {
        self.removed_grains += grains;
        self.removed += gone.present();
        // what they take along must not look like a fall of the others
        self.lowest_gravitational -= gone.gravitational;
        self.initial_gravitational -= gone.gravitational;
    }

    /// Counts grains that left the domain, by their masses [kg].
    pub(crate) fn leave_the_domain(&mut self, masses: &[f64]) {
        self.outside.0 += masses.len() as u64;
        self.outside.1 += masses.iter().sum::<f64>();
    }

    /// Number and mass [kg] of the grains that left the domain and were removed since the start.
    pub fn left_the_domain(&self) -> (u64, f64) {
        self.outside
    }

    /// Books the insertion of grains that carry these energies.
    pub(crate) fn insert(&mut self, grains: u64, gained: &Energies) {
        self.inserted_grains += grains;
        self.inserted += gained.present();
        self.inserted_throughput += gained.present() - gained.gravitational;
        // what they bring along must not look like a rise of the others
        self.lowest_gravitational += gained.gravitational;
        self.initial_gravitational += gained.gravitational;
    }

    /// Completes the energies of this moment with what happened since the start, and the residual.
    pub(crate) fn close(&mut self, mut now: Energies) -> Energies {
        now.viscous_dissipated = self.done.viscous;
        now.plastic_dissipated = self.done.plastic;
        now.friction_dissipated = self.done.friction;
        now.rolling_dissipated = self.done.rolling;
        now.wall_work = self.done.wall_work;
        now.boundary_work = self.boundary;
        now.custom_work = self.custom;
        now.wall_dissipated = self.wall_dissipated;
        now.multi_contact_input = self.done.multi_contact;
        now.inserted = self.inserted;
        now.removed = self.removed;
        self.lowest_gravitational = self.lowest_gravitational.min(now.gravitational);
        self.lowest_elastic = self.lowest_elastic.min(now.elastic);
        let work = now.wall_work + now.boundary_work + now.custom_work;
        let explained = self.initial + work + now.multi_contact_input + now.inserted - now.removed - now.dissipated();
        let passed = self.initial_throughput
            + self.wall_throughput
            + self.boundary_throughput
            + self.highest_affine
            + self.custom_throughput
            + self.highest_wall_kinetic
            + (self.initial_gravitational - self.lowest_gravitational)
            - self.lowest_elastic
            + self.inserted_throughput;
        let unexplained = now.present() - explained;
        // what is no number must be told
        now.residual = if passed <= 0.0 && unexplained.is_finite() {
            0.0
        } else {
            unexplained / passed
        };
        now
    }
}

/// Energies stored in contacts [J].
#[derive(Clone, Copy, Default)]
struct Stored {
    normal: f64,
    tangential: f64,
    rolling: f64,
    /// What displacements by other contacts make of the normal energy.
    multi_contact: f64,
}

impl Summand for Energies {
    /// Adds what grains and their contacts have at a moment.
    fn add(&mut self, part: &Self) {
        self.kinetic += part.kinetic;
        self.rotational += part.rotational;
        self.gravitational += part.gravitational;
        self.elastic += part.elastic;
        self.tangential += part.tangential;
        self.rolling += part.rolling;
        self.multi_contact += part.multi_contact;
    }
}

impl Simulation {
    pub(crate) fn book_step(&mut self) {
        let tally = self.step_tally();
        self.books.book(tally);
        self.books.book_free_walls(&self.free_walls, self.dt);
    }

    /// Work of this step. What the grains do on freely moving walls passes from them to these: no drive does it.
    pub(crate) fn step_tally(&self) -> Tally {
        let mut tally = self.work.tally;
        tally.wall_work += self.free_walls.power * self.dt;
        tally
    }

    /// Energies at this moment with the books since the start. Where processes share the run each calls this.
    pub fn energies(&mut self) -> Energies {
        let now = self.energies_now(self.books.latest);
        self.books.close(now)
    }

    /// What is there at this moment, as the books tell it [J]. Where processes share the run each calls this.
    pub(crate) fn present_energy(&mut self) -> f64 {
        self.energies_now(self.books.latest).present()
    }

    /// Kinetic, gravitational and stored energies at this moment, of all processes; what springs in the contact plane store is that of half a step later.
    pub(crate) fn mechanical_energies(&self) -> Energies {
        assert!(!self.awaits_kick, "velocities are those predicted");
        let free_walls = self.walls.iter().map(Wall::energy).sum();
        Energies {
            free_walls,
            ..self.sum_of_all(|segment| self.energies_in(segment, &|_| true))
        }
    }

    /// Energies of some grains and of the contacts that they are in, of all processes.
    pub(crate) fn energies_of(&self, counts: impl Fn(usize) -> bool + Sync) -> Energies {
        self.sum_of_all(|segment| self.energies_in(segment, &counts))
    }

    /// Energies of some grains of a segment and of the contacts that they are in.
    fn energies_in(&self, segment: Segment, counts: &impl Fn(usize) -> bool) -> Energies {
        let mut e = self.energies_of_grains(segment.grains, counts);
        let pairs = segment.pairs.iter().map(|chunk| self.stored(chunk, false, counts));
        let walls = segment.walls.iter().map(|chunk| self.stored(chunk, true, counts));
        for part in pairs.chain(walls) {
            e.elastic += part.normal;
            e.tangential += part.tangential;
            e.rolling += part.rolling;
            e.multi_contact += part.multi_contact;
        }
        e
    }

    fn energies_of_grains(&self, some: Range<usize>, counts: &impl Fn(usize) -> bool) -> Energies {
        let mut e = Energies::default();
        let grains = &self.grains;
        for g in some.filter(|&g| counts(g)) {
            e.kinetic += 0.5 * grains.mass(g) * grains.velocity[g].length_squared();
            e.rotational += 0.5 * grains.inertia(g) * grains.angular_velocity[g].length_squared();
            let place = self.comm.unwrapped(grains.position[g], grains.crossings(g));
            e.gravitational -= grains.mass(g) * self.gravity.dot(place);
        }
        e
    }

    /// Energies stored in the contacts of a chunk.
    fn stored(&self, chunk: &ContactChunk, wall: bool, counts: &impl Fn(usize) -> bool) -> Stored {
        let mut sum = Stored::default();
        for k in (0..chunk.len()).filter(|&k| chunk.is_engaged(k)) {
            if !counts(chunk.i[k] as usize) && (wall || !counts(chunk.j[k] as usize)) {
                continue;
            }
            let part = self.stored_in(chunk, k, wall);
            sum.normal += part.normal;
            sum.tangential += part.tangential;
            sum.rolling += part.rolling;
            sum.multi_contact += part.multi_contact;
        }
        sum
    }

    /// Energies stored in one contact.
    fn stored_in(&self, chunk: &ContactChunk, k: usize, wall: bool) -> Stored {
        let law = self.materials.law(chunk.law());
        let size = self.pair_size(chunk.i[k] as usize, (!wall).then(|| chunk.j[k] as usize));
        let history = chunk.history(k, self.contacts.stride);
        let overlap = self.contact(chunk, k).overlap;
        let mut stored = Stored {
            normal: normal_energy(law, size, overlap, history),
            ..Stored::default()
        };
        if let Some(coupled) = chunk.coupling().get(k) {
            let undisplaced = normal_energy(law, size, overlap - coupled.sum(), history);
            stored.normal -= 0.5 * coupled.elastic * coupled.sum();
            stored.multi_contact = stored.normal - undisplaced;
        }
        (stored.tangential, stored.rolling) = spring_energies(law, history);
        stored
    }

    /// Energy stored in the contacts with some walls [J], of all processes.
    pub(super) fn stored_at_walls(&self, walls: &[usize]) -> f64 {
        let of_segment = |segment: Segment<'_>| {
            let mut sum = Energies::default();
            for chunk in segment.walls {
                let counts = |&k: &usize| chunk.is_engaged(k) && walls.contains(&(chunk.j[k] as usize));
                for k in (0..chunk.len()).filter(counts) {
                    let stored = self.stored_in(chunk, k, true);
                    sum.elastic += stored.normal;
                    sum.tangential += stored.tangential;
                    sum.rolling += stored.rolling;
                }
            }
            sum
        };
        self.sum_of_all(of_segment).present()
    }

    /// Effective radius and mass of a grain and its partner, a grain or a wall.
    pub(crate) fn pair_size(&self, i: usize, j: Option<usize>) -> PairSize {
        PairSize::new(
            1.0 / (1.0 / self.grains.radius(i) + j.map_or(0.0, |j| 1.0 / self.grains.radius(j))),
            1.0 / (self.grains.inverse_mass(i) + j.map_or(0.0, |j| self.grains.inverse_mass(j))),
        )
    }
}
