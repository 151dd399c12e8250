//! One time step, in the order in which things happen.

mod coupled;
mod displacement;
mod gear;
mod velocity_verlet;
mod walls;

pub(crate) use coupled::CouplingState;
pub use coupled::{CouplingMemory, Effort};

use crate::contacts::sum::{Adder, Work};
use crate::contacts::{Approach, ContactChunk, Fault, Scene, Span};
use crate::neighbours::Neighbours;
use crate::particles::spread::{GRAINS_OF_A_SPREAD, Spread};
use crate::simulation::memory;
use crate::simulation::profile::{Part, Profile};
use crate::simulation::{Counts, Loads, Phase, Simulation};
use demeter_physics::integrator::Integrator;
use std::ops::Range;

/// Grains handled by one task that does little for each: to wake another thread for fewer takes longer than to do them.
pub(crate) const GRAINS_PER_TASK: usize = 1024;

/// Grains that a part has at least.
const LEAST_GRAINS_OF_A_PART: usize = 400;

impl Simulation {
    /// Advances the run by one time step (see [`demeter_physics::integrator`]).
    pub fn step(&mut self) -> Result<(), Fault> {
        self.steps(1)
    }

    /// Advances the run by so many time steps, or up to one that fails. The bits are those of as many calls of [`step`](Self::step), in
    /// less time: the kick that ends a step and the drift that begins the next take one pass.
    pub fn steps(&mut self, count: u64) -> Result<(), Fault> {
        if rayon::current_thread_index().is_none() && self.division.is_none() && self.takes_many_threads() {
            // a thread outside the pool would hand over one phase of a step after the other, and sleep until each is done. Processes that
            // share a run wait for each other, which the threads of a pool must not
            return rayon::scope(|_| self.steps(count));
        }
        for _ in 0..count {
            self.step_on()?;
        }
        self.settle()
    }

    /// One time step whose kick at the end may be left to the next one: until [`settle`](Self::settle) velocities are those
    /// predicted, and forces and torques those of contacts alone.
    pub(crate) fn step_on(&mut self) -> Result<(), Fault> {
        self.start()?;
        self.divide();
        if self.takes_many_threads() {
            self.awake.keep();
        }
        self.step += 1;
        self.took(Phase::Other);
        let spreads = self.grains.len().div_ceil(GRAINS_OF_A_SPREAD);
        self.spreads.resize(spreads, Spread::ANY);
        self.deform_box();
        if self.integrator == Integrator::VelocityVerlet {
            // also where a process has no grains: what it is told of some has their half kicks
            self.grains.foresee_half_kicks();
        }
        let motion = self.move_and_exchange(Self::move_grains);
        self.awaits_kick = false;
        let fault = self.fault_of_grain(motion.bad, self.step - 1);
        let motion = self.motion_of_all(motion, fault)?;
        let motion = self.beyond_affine(motion);
        self.follow_box();
        self.took(Phase::Motion);
        self.drive_walls();
        self.move_walls();
        // after the grains: a load that is no number came from one of them
        self.check_walls()?;
        self.check_bodies()?;
        self.took(Phase::Walls);
        // before those that left the domain are taken out: they may have passed a wall
        self.check_jumps(&motion)?;
        self.check_places(&motion)?;
        if let Some(skin) = self.next_skin(&motion) {
            self.skin = self.skin_that_fits(skin)?;
            self.find_candidates_with(Loads::Forgotten);
            self.check_crossings()?;
            self.foresee_bulges();
            // others are neighbours now
            self.exchange_borders(|_| ());
        }
        self.took(Phase::Search);
        self.span = Span::of_step(self.dt);
        let wall_speed = self.wall_speed();
        let unsolved = self.find_contacts(&motion, wall_speed);
        self.took(self.phase_of_contacts());
        let too_deep = self.sum_up_work();
        let beyond = unsolved.and(too_deep);
        self.gather_impacts();
        self.took(Phase::Ranks);
        self.awaits_kick = self.may_await_kick() && beyond.is_ok();
        let ended = self.end_step();
        beyond.and(ended)
    }

    /// All that comes behind the forces of a step; also of one in which an overlap is too deep or no coupled force is found, so that the
    /// ledger closes where a run stops.
    fn end_step(&mut self) -> Result<(), Fault> {
        if !self.awaits_kick {
            self.sum_and_correct(Moment::Step)?;
        }
        self.note_across();
        self.took(Phase::Sums);
        self.load_walls(self.dt);
        self.took(Phase::Walls);
        self.book_step();
        self.took(Phase::Books);
        self.count_work();
        self.custom_failure()
    }

    /// Whether there is work for more than one thread in every step.
    fn takes_many_threads(&self) -> bool {
        self.coupling.is_some() || parts(self.own_grains().len()) > 1
    }

    /// Ends the latest step: whoever looks at velocities, forces or torques between two calls of [`step_on`](Self::step_on) calls this
    /// first. Twice changes nothing. Where processes share the run each calls this.
    pub(crate) fn settle(&mut self) -> Result<(), Fault> {
        if std::mem::take(&mut self.awaits_kick) {
            self.sum_and_correct(Moment::Step)?;
            self.took(Phase::Sums);
        }
        self.check_walls()
    }

    /// Whether nothing needs the velocities at the end of a step before the next.
    pub(crate) fn may_await_kick(&self) -> bool {
        self.integrator == Integrator::VelocityVerlet && self.deforming.is_none() && !self.has_customs()
    }

    /// Forces at the very start, before any step.
    pub(crate) fn find_first_forces(&mut self) -> Result<(), Fault> {
        let own = self.grains.velocity.rows()[self.own_grains()].iter();
        let max_speed = own.map(|row| row.vector.length()).fold(0.0, f64::max);
        let motion = Motion {
            max_speed: self.together().largest(max_speed),
            ..Motion::default()
        };
        self.check_places(&motion)?;
        self.find_candidates_with(Loads::Forgotten);
        // before contacts take memory that the search has left in pieces
        memory::give_back();
        self.check_crossings()?;
        self.check_jumps(&motion)?;
        self.even_out_start();
        self.foresee_bulges();
        self.exchange_borders(|_| ());
        self.span = Span::of_start(self.dt, self.integrator);
        // walls have not moved yet
        let wall_speed = self.wall_speed().max(self.wall_speed_now());
        self.find_contacts(&motion, wall_speed)?;
        self.sum_up_work()?;
        self.sum_and_correct(Moment::Start)?;
        self.note_across();
        self.load_walls(0.0);
        Ok(())
    }

    /// Moves some grains to the end of the step and predicts their velocities there.
    fn move_grains(&mut self, some: Range<usize>) -> Motion {
        match self.integrator {
            Integrator::VelocityVerlet => self.drift(some),
            Integrator::Gear => self.predict(some),
        }
    }

    /// The skin to find candidates anew with: when some grain may touch a partner that is not among its candidates, and
    /// when a narrower skin would do.
    fn next_skin(&mut self, motion: &Motion) -> Option<f64> {
        self.add_travel(motion);
        // the narrow phase looks ahead by half a step
        let windows = if self.max_reach > 0.0 { 2.0 } else { 1.0 };
        let window = windows * motion.max_speed * self.dt;
        let wall = self.wall_displacement();
        let (bulges, margin) = (self.coupling.as_ref()).map_or((0.0, 0.0), |c| (c.bulges_of_two(), c.memory.margin));
        let used = |travel: f64| {
            let grain = travel + window;
            (2.0 * grain).max(grain + wall) - (margin - bulges)
        };
        let looks_at_all = self.coupling.is_some() || self.integrator == Integrator::Gear;
        let counts = |sim: &Self| Counts::new(&sim.neighbours, sim.engaged_contacts(), looks_at_all);
        let is_old = self.neighbours.former.len() != self.grains.len();
        let may_be_used_up = |sim: &Self| used(sim.travel) > sim.skin;
        if is_old || may_be_used_up(self) && used(self.measure_travel(motion)) > self.skin {
            return Some(self.tuner.after_use(self.skin, self.step, counts(self)));
        }
        let tuner = self.tuner;
        let counts = tuner.counts_when_wide(self.step, || counts(self))?;
        tuner.instead_of_wide(self.skin, used(self.measure_travel(motion)).max(0.0), self.step, counts)
    }

    fn phase_of_contacts(&self) -> Phase {
        match self.coupling {
            Some(_) => Phase::Coupled,
            None => Phase::Contacts,
        }
    }

    /// Narrow phase and contact laws, chunk by chunk.
    fn find_contacts(&mut self, motion: &Motion, wall_speed: f64) -> Result<(), Fault> {
        let max_speed = motion.max_speed.max(wall_speed);
        self.surfaces.find(&self.walls);
        if self.coupling.is_some() {
            return self.find_coupled_contacts(max_speed);
        }
        let mut loads = std::mem::take(&mut self.grains.load);
        let scene = Scene {
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
            stride: self.contacts.stride,
            resists_rolling: self.resists_rolling,
            records_walls: self.records_walls,
            tells_impacts: self.watches_impacts(),
            instructions: self.instructions,
            bulge: &[],
        };
        let (own, segments) = (self.own_grains(), self.segments_here());
        let (neighbours, profile) = (&self.neighbours, self.profile.as_deref());
        // images across the sides of a box that deforms move, too, and a predictor-corrector is not bounded by velocities
        let are_bounded = self.integrator == Integrator::VelocityVerlet && !scene.is_deforming();
        let spreads = are_bounded.then_some(&self.spreads[..]);
        let approach = |segment| approach(segment, &scene, motion, wall_speed, (neighbours, spreads));
        self.near.advance(segments.clone(), self.dt, approach);
        let near = &self.near;
        let work = Work {
            neighbours,
            segments,
            instructions: self.instructions,
            step: |c: usize, chunk: &mut ContactChunk, adder: &mut Adder| {
                let mut clock = Profile::chunk(profile);
                let sought = near.sought(neighbours.segment_of_chunk(c));
                let found = || clock.took(Part::Narrow);
                chunk.step_pairs(neighbours.chunk(c), sought, &scene, adder, found);
                clock.took(Part::Laws);
            },
            at_walls: |c: usize, chunk: &mut ContactChunk, adder: &mut Adder| {
                let mut clock = Profile::chunk(profile);
                let reach = near.at_walls(neighbours.segment_of_wall_chunk(c));
                chunk.meet_walls(neighbours.wall_chunk(c), reach, &scene);
                chunk.evaluate_walls(&scene, adder);
                clock.took(Part::Walls);
            },
        };
        let parts = parts(own.len());
        (self.sums).work((&mut loads, &mut self.contacts), own, parts, &work);
        self.grains.load = loads;
        Ok(())
    }

    /// Sum per grain, body force, and what the new forces change of the motion.
    fn sum_and_correct(&mut self, moment: Moment) -> Result<(), Fault> {
        self.add_custom_loads();
        let bad = match (self.integrator, moment) {
            (Integrator::Gear, Moment::Step) => self.correct(),
            (Integrator::VelocityVerlet, Moment::Step) => self.kick(0.5 * self.dt),
            // at the start of a run the velocities are those given
            (_, Moment::Start) => {
                self.grains.half_kicks.0.clear();
                self.kick(0.0)
            }
        };
        let fault = self.fault_of_grain(bad, self.step);
        self.fault_of_any(fault)?;
        self.book_custom(match moment {
            Moment::Step => self.dt,
            Moment::Start => 0.0,
        });
        Ok(())
    }

    /// The fault of a grain with a value that was not finite at the end of a step.
    fn fault_of_grain(&self, bad: Option<usize>, step: u64) -> Option<Fault> {
        bad.map(|g| Fault::NotFinite {
            step,
            id: self.grains.id[g],
            quantity: self.not_finite(g).into(),
            position: self.grains.position[g],
        })
    }

    /// Which quantity of a grain is not finite: the cause before its effects.
    fn not_finite(&self, g: usize) -> &'static str {
        let grains = &self.grains;
        if !(grains.force(g).is_finite() && grains.torque(g).is_finite()) {
            "force"
        } else if !grains.velocity[g].is_finite() {
            "velocity"
        } else {
            "angular velocity"
        }
    }
}

/// How two grains of a segment may move against each other in a step, and a grain against a wall.
fn approach(
    segment: usize,
    scene: &Scene,
    motion: &Motion,
    wall_speed: f64,
    (neighbours, spreads): (&Neighbours, Option<&[Spread]>),
) -> [Approach; 2] {
    let (widest, step_of_walls) = (scene.widest_window(), wall_speed * scene.dt);
    let Some(spreads) = spreads else {
        return [2.0 * motion.max_step, motion.max_step + step_of_walls]
            .map(|nearer| Approach::at_most(nearer, widest));
    };
    let (speed, kick) = neighbours.approach(segment, spreads);
    let nearer = speed * scene.dt;
    let to_wall = neighbours.spread_of(segment, spreads).speed() * scene.dt + step_of_walls;
    let window_at_wall = scene.window(0.5 * to_wall).min(widest);
    let of_grains = Approach {
        nearer,
        window: scene.window(0.5 * nearer),
        kick,
    };
    [of_grains, Approach::at_most(to_wall, window_at_wall)]
}

/// Parts that the work on the contacts of so many grains is cut into: each costs something for pairs with grains of others, and few
/// grains are done before another thread has begun.
fn parts(grains: usize) -> usize {
    rayon::current_num_threads().min(grains / LEAST_GRAINS_OF_A_PART).max(1)
}

/// The one of two grains that has the lower id.
fn first_by_id(ids: &[u32], one: Option<usize>, other: Option<usize>) -> Option<usize> {
    one.into_iter().chain(other).min_by_key(|&g| ids[g])
}

/// When forces are found.
#[derive(Clone, Copy)]
enum Moment {
    /// Before any step.
    Start,
    /// At the end of a step.
    Step,
}

/// What the motion of the grains came to.
#[derive(Clone, Debug, Default)]
pub(crate) struct Motion {
    pub(crate) max_speed: f64,
    /// Largest displacement in this step [m].
    pub(crate) max_step: f64,
    /// By how much images came nearer since the candidates were found, as the box deformed [m].
    pub(crate) by_box: f64,
    /// Some grain outside the domain or not at a finite place.
    pub(crate) misplaced: Option<usize>,
    /// The first grain, by its id, with a value that was not finite before it moved.
    pub(crate) bad: Option<usize>,
}

impl Motion {
    pub(crate) fn merge(self, other: Self, ids: &[u32]) -> Self {
        Self {
            max_speed: self.max_speed.max(other.max_speed),
            max_step: self.max_step.max(other.max_step),
            by_box: self.by_box.max(other.by_box),
            misplaced: self.misplaced.or(other.misplaced),
            bad: first_by_id(ids, self.bad, other.bad),
        }
    }
}
