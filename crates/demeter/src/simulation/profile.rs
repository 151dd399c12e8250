//! Where the time of a run goes: asked for with [`Simulation::profile_from_now`], else no clock is read.
//!
//! The clock goes on from lap to lap, so the phases add up to the whole. Within the pass over the contacts every thread adds
//! up its own time for the narrow phase, the laws (with adding up what contacts do) and the walls; what is left of the pass is adding
//! what tasks have for the grains of others, and threads that wait.

use super::memory::MemoryPart;
use super::roofline::{Machine, Passes, Roofline, Work};
use super::{SharingReport, Simulation};
use crate::step::Effort;
use demeter_physics::integrator::Integrator;
use serde::Serialize;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// What the time of one lap went to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// Candidates found anew: order of the grains, search, contacts handed over.
    Search,
    /// Narrow phase and laws of contacts that do not feel each other.
    Contacts,
    /// Narrow phase, displacements and laws of contacts that feel each other.
    Coupled,
    /// Sums per grain and the correction of the velocities.
    Sums,
    /// Grains moved to the end of the step.
    Motion,
    /// Walls moved, and their loads.
    Walls,
    /// Other processes told and heard, and waited for.
    Ranks,
    /// Energy books.
    Books,
    /// Rows, frames, checkpoints, pictures.
    Output,
    /// Everything else.
    Other,
}

const PHASES: usize = Phase::Other as usize + 1;

/// A part of the pass over the contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// Which candidates touch.
    Narrow,
    /// Contact laws.
    Laws,
    /// Contacts with walls: both.
    Walls,
}

const PARTS: usize = Part::Walls as usize + 1;

/// Times of one run.
#[derive(Debug)]
pub(crate) struct Profile {
    begun: Instant,
    latest: Instant,
    phases: [Duration; PHASES],
    /// Nanoseconds of all threads in the parts of the pass over the contacts.
    parts: [AtomicU64; PARTS],
    steps: u64,
    rebuilds_before: u64,
    coupling_before: Effort,
    work: Work,
}

impl Profile {
    fn new(rebuilds: u64, coupling: Effort) -> Self {
        let now = Instant::now();
        Self {
            begun: now,
            latest: now,
            phases: [Duration::ZERO; PHASES],
            parts: Default::default(),
            steps: 0,
            rebuilds_before: rebuilds,
            coupling_before: coupling,
            work: Work::default(),
        }
    }

    fn lap(&mut self, phase: Phase) {
        let now = Instant::now();
        self.phases[phase as usize] += now - self.latest;
        self.latest = now;
    }

    /// Begins to time one chunk of contacts; nothing is timed without a profile.
    #[inline(always)]
    pub(crate) fn chunk(profile: Option<&Self>) -> ChunkClock<'_> {
        ChunkClock(profile.map(|profile| (Instant::now(), &profile.parts)))
    }

    /// Rows of the table, which add up to the seconds since the beginning.
    fn rows(&self, threads: usize) -> Vec<(&'static str, f64)> {
        let of = |phase: Phase| self.phases[phase as usize].as_secs_f64();
        let pass = of(Phase::Contacts);
        let parts = (self.parts.each_ref()).map(|part| part.load(Ordering::Relaxed) as f64 * 1e-9);
        // the clocks of threads and that of the pass are read at different moments
        let available = (pass * threads as f64).max(parts.iter().sum()).max(f64::MIN_POSITIVE);
        let [narrow, laws, walls] = parts.map(|part| pass * part / available);
        let waiting = (pass - narrow - laws - walls).max(0.0);
        vec![
            ("search", of(Phase::Search)),
            ("narrow phase", narrow),
            ("laws", laws),
            ("sums within, waiting", waiting),
            ("coupled contacts", of(Phase::Coupled)),
            ("walls", walls + of(Phase::Walls)),
            ("sums and kick alone", of(Phase::Sums)),
            ("sums, kick and drift", of(Phase::Motion)),
            ("other ranks", of(Phase::Ranks)),
            ("books", of(Phase::Books)),
            (OUTPUT, of(Phase::Output)),
            (OTHER, of(Phase::Other)),
        ]
    }
}

const OUTPUT: &str = "output";
const OTHER: &str = "other";

/// Times a chunk of contacts on its thread.
pub(crate) struct ChunkClock<'a>(Option<(Instant, &'a [AtomicU64; PARTS])>);

impl ChunkClock<'_> {
    /// Books the time since the last call.
    #[inline(always)]
    pub(crate) fn took(&mut self, part: Part) {
        if let Some((since, parts)) = &mut self.0 {
            let now = Instant::now();
            parts[part as usize].fetch_add((now - *since).as_nanos() as u64, Ordering::Relaxed);
            *since = now;
        }
    }
}

/// Where the time went.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProfileReport {
    /// Wall-clock time in all [s].
    pub seconds: f64,
    /// Steps.
    pub steps: u64,
    /// Sum over the steps of the number of grains.
    pub particle_steps: u64,
    /// How often candidates were found anew.
    pub rebuilds: u64,
    /// What solving the coupled equation took; absent where no contact feels another.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coupling: Option<Effort>,
    /// Number of threads.
    pub threads: usize,
    /// Instructions that the kernels ran with.
    pub instructions: &'static str,
    /// What the time went to; adds up to all of it.
    pub phases: Vec<PhaseTime>,
    /// What the tables hold in memory at the end.
    pub memory: Vec<MemoryPart>,
    /// Against what the machine could do; absent without steps.
    pub roofline: Option<Roofline>,
    /// What sharing the run with other processes took; absent where it is not shared.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sharing: Option<SharingReport>,
}

/// Time of one phase.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PhaseTime {
    /// Name.
    pub name: &'static str,
    /// Wall-clock time [s].
    pub seconds: f64,
    /// Share of all time.
    pub share: f64,
    /// Time per grain and step in ns; 0 without steps.
    pub ns_per_particle_step: f64,
}

impl Simulation {
    /// Reads the clock from now on, and forgets what it told before.
    pub fn profile_from_now(&mut self) {
        self.profile = Some(Box::new(Profile::new(self.rebuilds, self.coupling_effort())));
    }

    /// Books the time since the last call as that of a phase; nothing without a profile.
    #[inline(always)]
    pub fn took(&mut self, phase: Phase) {
        if let Some(profile) = &mut self.profile {
            profile.lap(phase);
        }
    }

    /// Counts what a step worked on.
    pub(crate) fn count_work(&mut self) {
        let Some(mut profile) = self.profile.take() else { return };
        profile.steps += 1;
        profile.work.add(&self.work());
        profile.lap(Phase::Other);
        self.profile = Some(profile);
    }

    /// What a step on the present tables works on.
    pub fn work(&self) -> Work {
        Work::of(&self.grains, &self.contacts, &self.neighbours, &self.materials)
    }

    /// Distances that the latest search for candidates looked at.
    pub fn distance_tests(&self) -> u64 {
        self.neighbours.effort().tests
    }

    /// Where the time went since [`Simulation::profile_from_now`]; measures for some hundredths of a second what the machine
    /// can do, on the threads at hand.
    pub fn profile(&self) -> Option<ProfileReport> {
        let profile = self.profile.as_deref()?;
        let threads = rayon::current_num_threads();
        let seconds = (profile.latest - profile.begun).as_secs_f64();
        let particle_steps = profile.work.grains;
        let per_particle_step = |seconds: f64| seconds * 1e9 / particle_steps.max(1) as f64;
        let phases: Vec<PhaseTime> = (profile.rows(threads).into_iter())
            .map(|(name, time)| PhaseTime {
                name,
                seconds: time,
                share: time / seconds.max(f64::MIN_POSITIVE),
                ns_per_particle_step: per_particle_step(time),
            })
            .collect();
        let roofline = (particle_steps > 0).then(|| {
            let in_steps = phases.iter().filter(|p| ![OUTPUT, OTHER].contains(&p.name));
            let seconds = in_steps.map(|p| p.seconds).sum();
            let passes = match self.integrator {
                Integrator::Gear => Passes::Gear,
                Integrator::VelocityVerlet if self.may_await_kick() => Passes::Joined,
                Integrator::VelocityVerlet => Passes::Apart,
            };
            let motion = (passes, self.grains.orientation.is_some());
            let needs = profile.work.needs(self.contacts.stride, self.resists_rolling, motion);
            Roofline::new(&profile.work, needs, Machine::measure(self.instructions), seconds)
        });
        Some(ProfileReport {
            seconds,
            steps: profile.steps,
            particle_steps,
            rebuilds: self.rebuilds - profile.rebuilds_before,
            coupling: (self.coupling.as_ref()).map(|_| self.coupling_effort().since(profile.coupling_before)),
            threads,
            instructions: self.instructions.name(),
            phases,
            memory: self.memory(),
            roofline,
            sharing: self.sharing_of_all(profile.steps, particle_steps),
        })
    }
}
