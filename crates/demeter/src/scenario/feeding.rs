//! How the grains of a feed come: what is due, what finds room, and when it ends.

use super::feeds::{FeedRate, FeedSpec, exchange_steps};
use super::solids::{InTheWay, Solid};
use super::words;
use crate::insertion::{MAX_AT_ONCE, Streaming};
use crate::measure::contact_counts;
use crate::particles::NewGrain;
use crate::simulation::Simulation;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Contacts that hold a grain on a pile.
const CONTACTS_AT_REST: u32 = 3;

/// Share of its weight that may act on a grain that lies.
const UNBORNE: f64 = 0.5;

/// A feed is told to be behind when this share of what is due waits, ...
const BEHIND: f64 = 0.05;
/// ... and so many mean grains.
const BEHIND_GRAINS: f64 = 10.0;

#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct FeedState {
    pub(super) active: bool,
    pub(super) done: bool,
    /// Step up to which the time was counted.
    clock: u64,
    /// Steps during which the feed ran.
    steps: u64,
    pub(super) grains: u64,
    pub(super) mass: f64,
    /// What rates that were changed on the way had let come due, in the unit of the present one [kg or grains], ...
    due: f64,
    /// ... and the steps during which they held.
    steps_before: u64,
    told_behind: bool,
}

impl FeedState {
    pub(super) const NEW: Self = Self {
        active: true,
        done: false,
        clock: 0,
        steps: 0,
        grains: 0,
        mass: 0.0,
        due: 0.0,
        steps_before: 0,
        told_behind: false,
    };

    /// Counts the time up to a step, and no longer than the feed runs.
    pub(super) fn count_time(&mut self, step: u64, last: Option<u64>) {
        if self.active && !self.done {
            let [until, from] = [step, self.clock].map(|step| step.min(last.unwrap_or(u64::MAX)));
            self.steps += until.saturating_sub(from);
        }
        self.clock = step;
    }
}

/// A feed at a moment.
pub(super) struct Feeding<'a> {
    pub(super) spec: &'a FeedSpec,
    pub(super) source: &'a Streaming,
    pub(super) sim: &'a Simulation,
    /// Closed meshes.
    pub(super) solids: &'a [Solid],
}

impl Feeding<'_> {
    /// Lets all grains come that are due and find room, also those that came due before the feed ended at a time.
    pub(super) fn feed(&self, state: &mut FeedState, leaving: &[usize], come: &mut Vec<NewGrain>) {
        let (sim, end) = (self.sim, &self.spec.end);
        let is_over = self.spec.last_step(sim.dt).is_some_and(|last| sim.step >= last);
        let has_rate = self.spec.rate != FeedRate::AsRoomAllows;
        state.done = (is_over && !has_rate)
            || end
                .level
                .is_some_and(|plane| sim.any_of_all(is_piled_beyond(sim, plane, self.spec.stream.velocity)));
        self.let_come(state, leaving, come);
        state.done |= is_over;
    }

    fn let_come(&self, state: &mut FeedState, leaving: &[usize], come: &mut Vec<NewGrain>) {
        let sim = self.sim;
        if self.next(state).is_none() {
            return;
        }
        let mut there = self.near_the_inlet(leaving);
        there.extend(come.iter().map(|grain| (grain.position, grain.radius)));
        let expected = (self.due(state) / self.source.mean_mass()).min(MAX_AT_ONCE as f64) as u64 + 1;
        let mut occupied = self.source.occupied(there.into_iter(), sim.largest_reach(), expected);
        let solid = InTheWay::of(self.source, self.solids, &sim.walls);
        let is_blocked = |place: DVec3, reach: f64| solid.meets(place, reach);
        for _ in 0..MAX_AT_ONCE {
            let Some(radius) = self.next(state) else { return };
            let Some(grain) = self
                .source
                .grain((state.grains, sim.step), radius, &mut occupied, is_blocked)
            else {
                return;
            };
            state.grains += 1;
            state.mass += self.source.mass(radius);
            come.push(grain);
        }
    }

    /// Centres and radii of all grains that stay and may be in the way, which each process tells of its own [m].
    fn near_the_inlet(&self, leaving: &[usize]) -> Vec<(DVec3, f64)> {
        let (sim, gap) = (self.sim, self.sim.largest_reach());
        let vicinity = self.source.vicinity();
        let is_near = |g: &usize| {
            leaving.binary_search(g).is_err() && vicinity.may_meet(sim.grains.position[*g], sim.grains.radius(*g), gap)
        };
        let near = sim.own_grains().filter(is_near);
        sim.of_all_segments(near.map(|g| (sim.grains.position[g], sim.grains.radius(g))).collect())
    }

    /// Radius of the next grain, when one is due [m]. Notes the end of the feed.
    fn next(&self, state: &mut FeedState) -> Option<f64> {
        let end = &self.spec.end;
        state.done |= end.count.is_some_and(|count| state.grains >= count);
        if state.done {
            return None;
        }
        let radius = self.source.radius(state.grains);
        let mass = self.source.mass(radius);
        // the mass that comes is nearest to the one that was asked for
        state.done = end.mass.is_some_and(|most| state.mass + 0.5 * mass > most);
        let due = |rate: f64| state.due_by(rate, self.sim.dt);
        let is_due = match self.spec.rate {
            FeedRate::AsRoomAllows => true,
            FeedRate::Mass(rate) => state.mass + mass <= due(rate),
            FeedRate::Number(rate) => (state.grains + 1) as f64 <= due(rate),
        };
        (is_due && !state.done).then_some(radius)
    }

    /// Mass that is due and has not come [kg]; without a rate, the most that finds room.
    fn due(&self, state: &FeedState) -> f64 {
        let due = match self.spec.rate {
            FeedRate::AsRoomAllows => self.source.capacity() * self.source.mean_mass(),
            _ => state.behind(self.spec, self.source, self.sim.dt),
        };
        due.min(state.left(self.spec, self.source))
    }

    /// What a user wants to read of the feed.
    pub(super) fn say(&self, state: &mut FeedState) -> Option<String> {
        let FeedState { grains, mass, .. } = *state;
        let name = &self.spec.name;
        let behind = state.far_behind(self.spec, self.source, self.sim.dt);
        if state.done {
            let waiting = behind.map_or_else(String::new, |mass| {
                format!("; {} more were due and found no room", words::mass(mass))
            });
            let warning = if behind.is_some() { "warning: " } else { "" };
            return Some(format!(
                "{warning}feed `{name}` is done: {grains} grains, {} came{waiting}",
                words::mass(mass)
            ));
        }
        let behind = behind?;
        if state.told_behind {
            return None;
        }
        state.told_behind = true;
        Some(format!(
            "warning: feed `{name}` is behind: {} of {} came, as grains wait for room; a larger inlet, faster \
             grains or a lower rate let all come",
            words::mass(mass),
            words::mass(mass + behind)
        ))
    }
}

impl FeedState {
    /// What of a feed found no room until the end of its last stage.
    pub(super) fn cut_short(&self, spec: &FeedSpec, source: &Streaming, dt: f64, stage: &str) -> Option<String> {
        if !self.active || self.done {
            return None;
        }
        let came = match (spec.end.count, spec.end.mass) {
            _ if spec.rate != FeedRate::AsRoomAllows => {
                let behind = self.far_behind(spec, source, dt)?;
                format!("{} of {}", words::mass(self.mass), words::mass(self.mass + behind))
            }
            (Some(count), _) if self.grains < count => format!("{} of {count} grains", self.grains),
            (None, Some(mass)) => format!("{} of {}", words::mass(self.mass), words::mass(mass)),
            _ => return None,
        };
        let interval = exchange_steps(spec.every, dt);
        let why = match self.steps < interval && !self.told_behind {
            true => format!(
                "the time of the others had not come, as grains come every {:.4e} s; a shorter `every` or a longer stage lets all come",
                interval as f64 * dt
            ),
            false => "the others found no room; a larger inlet, one that is free of walls and grains, faster grains or a longer stage \
                      let all come"
                .to_owned(),
        };
        Some(format!(
            "warning: feed `{}` let {came} come until the end of stage `{stage}`: {why}",
            spec.name
        ))
    }

    /// What is worth telling of [`Self::behind`].
    fn far_behind(&self, spec: &FeedSpec, source: &Streaming, dt: f64) -> Option<f64> {
        let behind = self.behind(spec, source, dt);
        let is_far = behind > BEHIND * (self.mass + behind) && behind > BEHIND_GRAINS * source.mean_mass();
        is_far.then_some(behind)
    }

    /// Mass that is due by the rate and has not come [kg]; of a feed that has ended only where a time ended it.
    pub(super) fn behind(&self, spec: &FeedSpec, source: &Streaming, dt: f64) -> f64 {
        let has_its_time = spec.last_step(dt).is_some_and(|last| self.clock >= last);
        let behind = match spec.rate {
            _ if self.done && !has_its_time => 0.0,
            FeedRate::AsRoomAllows => 0.0,
            FeedRate::Mass(rate) => self.due_by(rate, dt) - self.mass,
            FeedRate::Number(rate) => (self.due_by(rate, dt) - self.grains as f64).floor() * source.mean_mass(),
        };
        behind.min(self.left(spec, source)).max(0.0)
    }

    /// What is due by a rate since the start, in its unit [kg or grains].
    fn due_by(&self, rate: f64, dt: f64) -> f64 {
        self.due + rate * ((self.steps - self.steps_before) as f64 * dt)
    }

    /// The most that may come until the feed ends by its mass or number [kg].
    fn left(&self, spec: &FeedSpec, source: &Streaming) -> f64 {
        let of_grains = |count: u64| count.saturating_sub(self.grains) as f64 * source.mean_mass();
        let limits = [
            spec.end.count.map(of_grains),
            spec.end.mass.map(|mass| (mass - self.mass).max(0.0)),
        ];
        limits.into_iter().flatten().fold(f64::INFINITY, f64::min)
    }

    /// Goes on from a step with what a feed is told now in place of what it was told before: what was due stays due, another rate counts
    /// from here on, and another end may let more come.
    pub(super) fn go_on_otherwise(
        &mut self,
        was: &FeedSpec,
        is: &FeedSpec,
        source: &Streaming,
        (step, dt): (u64, f64),
    ) {
        self.count_time(step, was.last_step(dt));
        if (was.rate, was.end) == (is.rate, is.end) {
            return;
        }
        let mean = source.mean_mass();
        let left = self.left(was, source);
        let behind = match was.rate {
            FeedRate::AsRoomAllows => 0.0,
            FeedRate::Mass(rate) => (self.due_by(rate, dt) - self.mass).min(left),
            FeedRate::Number(rate) => ((self.due_by(rate, dt) - self.grains as f64) * mean).min(left),
        };
        self.due = match is.rate {
            FeedRate::Number(_) => self.grains as f64 + behind / mean,
            FeedRate::Mass(_) | FeedRate::AsRoomAllows => self.mass + behind,
        };
        self.steps_before = self.steps;
        self.done &= was.end == is.end;
    }
}

/// Whether an own grain beyond a plane lies on others or on walls: it has contacts that bear half of its weight at least, and no more than
/// half of it beside, and is slower than one that has fallen by its radius. So those which meet in flight do not count. Without gravity
/// it is slower than half of the speed with which grains come.
fn is_piled_beyond(sim: &Simulation, (point, normal): (DVec3, DVec3), inlet: DVec3) -> bool {
    let is_beyond = |g: &usize| (sim.grains.position[*g] - point).dot(normal) > 0.0;
    let gravity = sim.gravity.length();
    let lies = |g: &usize| {
        let (grains, speed2) = (&sim.grains, sim.grains.velocity[*g].length_squared());
        match gravity > 0.0 {
            true => {
                speed2 <= 2.0 * gravity * grains.radius(*g)
                    && grains.force(*g).length() <= UNBORNE * gravity * grains.mass(*g)
            }
            false => speed2 <= 0.25 * inlet.length_squared(),
        }
    };
    let mut beyond = sim.own_grains().filter(is_beyond).filter(lies).peekable();
    if beyond.peek().is_none() {
        return false;
    }
    let contacts = contact_counts(sim);
    beyond.any(|g| contacts[g] >= CONTACTS_AT_REST)
}
