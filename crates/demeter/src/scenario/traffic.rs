//! Grains that come and go while a run goes on, and what is counted of them: feeds, removals, flows through gates.
//!
//! Everything happens between two steps, at steps that the scenario tells, one grain after the other: the same bits on any
//! number of threads and after a restart.

use super::Scenario;
use super::feeding::{FeedState, Feeding};
use super::feeds::{FeedSpec, RemovalSpec, exchange_steps};
use super::followed::{Followed, FollowedState};
use super::measures::MeasureKind;
use super::run_error::RunError;
use super::solids::Solid;
use crate::insertion::{InsertionProblem, Streaming};
use crate::measure::{
    Counted, DOMAIN_COLUMNS, FEED_COLUMNS, FieldValues, OF_MATERIAL_COLUMNS, REMOVAL_COLUMNS, Value, holds,
};
use crate::output::GoneGrain;
use crate::particles::{Domain, NewGrain, Origins, Outside};
use crate::simulation::{Simulation, Stage};
use serde::{Deserialize, Serialize};

/// What a restart needs to go on.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(super) struct TrafficState {
    origins: Origins,
    feeds: Vec<FeedState>,
    removals: Vec<RemovalState>,
    followed: FollowedState,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
struct RemovalState {
    active: bool,
    /// Grains and their mass [kg], by material.
    gone: Vec<(u64, f64)>,
    /// Sum of the times that they were in the run [s].
    stay: f64,
    /// Those since the latest row of the series, where they are listed.
    listed: Vec<GoneGrain>,
}

/// Feeds, removals and flows of a run.
pub(super) struct Traffic<'a> {
    scenario: &'a Scenario,
    sources: Vec<Streaming>,
    /// Closed meshes, which no grain comes into.
    solids: Vec<Solid>,
    followed: Followed<'a>,
    state: TrafficState,
    /// Whether there were tags, as those of a file, when this began or went on.
    began_with_tags: bool,
}

/// A grain that goes.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Gone {
    index: usize,
    grain: GoneGrain,
    /// Number of the removal that it goes by.
    removal: usize,
}

impl<'a> Traffic<'a> {
    /// At the start of a run: everything runs until a stage says otherwise.
    pub fn begin(scenario: &'a Scenario, sim: &Simulation, origins: Origins) -> Result<Self, RunError> {
        let removal = |_: &RemovalSpec| RemovalState {
            active: true,
            gone: vec![(0, 0.0); scenario.materials.len()],
            stay: 0.0,
            listed: Vec::new(),
        };
        let state = TrafficState {
            origins,
            feeds: vec![FeedState::NEW; scenario.feeds.len()],
            removals: scenario.removals.iter().map(removal).collect(),
            followed: Followed::begin(scenario).state().clone(),
        };
        Self::resume(scenario, sim, state)
    }

    /// Goes on from a state.
    pub fn resume(scenario: &'a Scenario, sim: &Simulation, state: TrafficState) -> Result<Self, RunError> {
        let followed = Followed::resume(scenario, state.followed.clone());
        let materials = scenario.materials.len();
        let fits = state.feeds.len() == scenario.feeds.len()
            && state.removals.len() == scenario.removals.len()
            && state.removals.iter().all(|r| r.gone.len() == materials);
        let (Some(followed), true) = (followed, fits) else {
            return Err(RunError::OtherTraffic);
        };
        Ok(Self {
            solids: if scenario.feeds.is_empty() {
                Vec::new()
            } else {
                Solid::all(&sim.walls)
            },
            sources: sources(scenario, sim.domain()).map_err(|(feed, problem)| RunError::Feed {
                feed: scenario.feeds[feed].name.clone(),
                problem: Box::new(problem),
            })?,
            scenario,
            followed,
            began_with_tags: state.origins.have_tags(),
            state,
        })
    }

    /// What a checkpoint holds.
    pub fn state(&self) -> TrafficState {
        TrafficState {
            followed: self.followed.state().clone(),
            ..self.state.clone()
        }
    }

    /// Lets feeds go on from a step as they are told now in place of what a former scenario told of them.
    pub fn go_on_otherwise(&mut self, was: &[FeedSpec], (step, dt): (u64, f64)) {
        let feeds = self.state.feeds.iter_mut().zip(&self.sources);
        for ((feed, source), (was, is)) in feeds.zip(was.iter().zip(&self.scenario.feeds)) {
            feed.go_on_otherwise(was, is, source, (step, dt));
        }
    }

    /// Starts and stops what the stage tells.
    pub fn begin_stage(&mut self, stage: &Stage, (step, dt): (u64, f64)) {
        if let Some(running) = &stage.feeds {
            for (k, feed) in self.state.feeds.iter_mut().enumerate() {
                feed.count_time(step, self.scenario.feeds[k].last_step(dt));
                feed.active = running.contains(&k);
            }
        }
        if let Some(acting) = &stage.removals {
            for (k, removal) in self.state.removals.iter_mut().enumerate() {
                removal.active = acting.contains(&k);
            }
        }
    }

    /// What a user wants to read of feeds that end with a stage, told by its index, before all came that they were told.
    pub fn end_stage(&self, stage: usize, dt: f64) -> Vec<String> {
        let later = self.scenario.stages.get(stage + 1..).unwrap_or_default();
        let is_last = |&feed: &usize| {
            // a stage that tells nothing of feeds leaves them as they are
            let runs = |stage: &Stage| stage.feeds.as_ref().is_none_or(|running| running.contains(&feed));
            !later.first().is_some_and(runs)
                && later
                    .iter()
                    .filter_map(|s| s.feeds.as_ref())
                    .all(|f| !f.contains(&feed))
        };
        let name = self.scenario.stages.get(stage).map_or("", |stage| stage.name.as_str());
        let feeds = (0..self.state.feeds.len()).filter(is_last);
        feeds
            .filter_map(|feed| {
                let (spec, source) = (&self.scenario.feeds[feed], &self.sources[feed]);
                self.state.feeds[feed].cut_short(spec, source, dt, name)
            })
            .collect()
    }

    /// Whether a feed has come to its end.
    pub fn is_done(&self, feed: usize) -> bool {
        self.state.feeds.get(feed).is_none_or(|feed| feed.done)
    }

    /// The first process looks where grains are when it is time. Each calls this.
    pub fn watch(&mut self, sim: &mut Simulation) {
        if self.followed.is_due(sim) {
            if self.followed.needs_contacts(sim) {
                sim.hear_corrected_places();
            }
            self.followed.watch(sim, &self.state.origins);
        }
    }

    /// Whether contacts that begin are asked for.
    pub fn hears_impacts(&self) -> bool {
        self.followed.hears_impacts()
    }

    /// Takes over from the simulation what its own state does not hold. Each process calls this before the state is told.
    pub fn hear_impacts(&mut self, sim: &mut Simulation) {
        self.followed.hear_impacts(sim);
    }

    /// What measures remember of this run up to now. Each process calls this.
    pub fn remembered(&mut self, sim: &mut Simulation) -> FollowedState {
        self.hear_impacts(sim);
        self.followed.state().clone()
    }

    /// Goes on with what they remembered.
    pub fn remember(&mut self, state: FollowedState) {
        self.followed.remember(state);
    }

    /// Whether grains are looked at after the latest step.
    pub fn looks(&self, sim: &Simulation) -> bool {
        self.followed.is_due(sim) || self.is_due(sim)
    }

    /// Whether grains may come and go between the latest step and the next.
    fn is_due(&self, sim: &Simulation) -> bool {
        let (scenario, state) = (self.scenario, &self.state);
        let mut removals = scenario.removals.iter().zip(&state.removals);
        let mut feeds = scenario.feeds.iter().zip(&state.feeds);
        scenario.tags.iter().any(|tag| tag.is_due(sim))
            || removals.any(|(spec, state)| state.active && is_due(sim, spec.every))
            || feeds.any(|(spec, state)| state.active && !state.done && is_due(sim, spec.every))
    }

    /// The first process looks at what is followed. Each calls this.
    fn look(&mut self, sim: &mut Simulation) {
        self.followed.look(sim, &self.state.origins);
    }

    /// Gives grains the tags that are due now; twice at one moment changes nothing.
    pub fn tag(&mut self, sim: &Simulation) {
        for tag in &self.scenario.tags {
            tag.apply(sim, &mut self.state.origins);
        }
    }

    /// The tags of all grains, by index, when any grain of the run may have one.
    pub fn tags(&self, ids: &[u32]) -> Option<Vec<i32>> {
        let scenario = self.scenario;
        let any = self.began_with_tags
            || !scenario.tags.is_empty()
            || scenario
                .grains
                .iter()
                .any(|batch| batch.tag.is_some_and(|tag| tag != 0))
            || scenario.feeds.iter().any(|feed| feed.tag != 0);
        any.then(|| ids.iter().map(|id| self.state.origins.tag(*id)).collect())
    }

    /// Mass that left a region by bins of residence time; `index` counts the measures of residence.
    pub fn residence_distribution(&self, index: usize) -> Vec<f64> {
        self.followed.residence_distribution(index)
    }

    /// Collisions between grains and with walls by bins of energy; `index` counts the measures of collisions.
    pub fn collision_distribution(&self, index: usize) -> [Counted; 2] {
        self.followed.collision_distribution(index)
    }

    /// The grains that a removal took since the latest row of the series, where it lists them.
    pub fn listed(&self, removal: usize) -> &[GoneGrain] {
        self.state.removals.get(removal).map_or(&[], |removal| &removal.listed)
    }

    /// Forgets which grains are listed already.
    pub fn begin_lists(&mut self) {
        self.state
            .removals
            .iter_mut()
            .for_each(|removal| removal.listed.clear());
    }

    /// The fields of a measure, `index` counts those; means begin anew.
    pub fn take_field(&mut self, index: usize, sim: &Simulation) -> Option<FieldValues> {
        self.followed.take_field(index, sim, &self.state.origins)
    }

    /// Which batch or feed every grain came from.
    pub fn origins(&self) -> &Origins {
        &self.state.origins
    }

    /// Lets grains go and come that are due between the latest step and the next; answers with what a user wants to read.
    pub fn exchange(&mut self, sim: &mut Simulation) -> Result<Vec<String>, RunError> {
        let mut messages = Vec::new();
        if !self.is_due(sim) {
            return Ok(messages);
        }
        self.tag(sim);
        let gone = self.leaving(sim);
        let leaving: Vec<usize> = gone.iter().map(|gone| gone.index).collect();
        let (come, from) = self.coming(sim, &leaving, &mut messages);
        if leaving.is_empty() && come.is_empty() {
            return Ok(messages);
        }
        // a grain that leaves may have passed a gate since the latest look
        self.look(sim);
        for gone in &gone {
            self.state.origins.forget_tag(gone.grain.id);
        }
        let ids = sim.exchange(&leaving, &come)?;
        let batches = self.scenario.grains.len();
        for (id, source) in ids.zip(from) {
            self.state.origins.add(id, source, sim.step);
            let feed = usize::from(source)
                .checked_sub(batches)
                .and_then(|k| self.scenario.feeds.get(k));
            if let Some(feed) = feed.filter(|feed| feed.tag != 0) {
                self.state.origins.set_tag(id, feed.tag);
            }
        }
        self.look(sim);
        Ok(messages)
    }

    /// Grains that go now, by rising indices; they are counted. Each process looks at its own, and tells which go and by which removal.
    fn leaving(&mut self, sim: &Simulation) -> Vec<Gone> {
        let due: Vec<usize> = (0..self.state.removals.len())
            .filter(|&k| self.state.removals[k].active && is_due(sim, self.scenario.removals[k].every))
            .collect();
        if due.is_empty() {
            return Vec::new();
        }
        let grains = &sim.grains;
        let goes = |g: usize| {
            let by = |k: &usize| {
                let removal = &self.scenario.removals[*k];
                holds(sim, &removal.zone, g) && removal.selection.holds(grains, &self.state.origins, g)
            };
            due.iter().copied().find(by).map(|removal| Gone {
                index: g,
                grain: GoneGrain {
                    time: sim.time(),
                    id: grains.id[g],
                    material: grains.material[g],
                    diameter: 2.0 * grains.radius(g),
                    mass: grains.mass(g),
                    place: sim.unwrapped(g),
                    velocity: grains.velocity[g],
                    // what the first process knows
                    source: None,
                    tag: 0,
                    stay: 0.0,
                },
                removal,
            })
        };
        let mut leaving: Vec<Gone> = sim.of_all_segments(sim.own_grains().filter_map(goes).collect());
        let origins = &self.state.origins;
        for Gone { grain, removal, .. } in &mut leaving {
            grain.stay = sim.step.saturating_sub(origins.born(grain.id)) as f64 * sim.dt;
            grain.source = origins.of(grain.id);
            grain.tag = origins.tag(grain.id);
            let state = &mut self.state.removals[*removal];
            let gone = &mut state.gone[usize::from(grain.material)];
            gone.0 += 1;
            gone.1 += grain.mass;
            state.stay += grain.stay;
            if self.scenario.removals[*removal].list {
                state.listed.push(grain.clone());
            }
        }
        leaving
    }

    /// The grains that come now, and the source of each.
    fn coming(&mut self, sim: &Simulation, leaving: &[usize], messages: &mut Vec<String>) -> (Vec<NewGrain>, Vec<u16>) {
        let (mut come, mut from): (Vec<NewGrain>, Vec<u16>) = (Vec::new(), Vec::new());
        let batches = self.scenario.grains.len();
        for (k, spec) in self.scenario.feeds.iter().enumerate() {
            let (state, source) = (&mut self.state.feeds[k], &self.sources[k]);
            if !state.active || state.done || !is_due(sim, spec.every) {
                continue;
            }
            state.count_time(sim.step, spec.last_step(sim.dt));
            let feeding = Feeding {
                spec,
                source,
                sim,
                solids: &self.solids,
            };
            feeding.feed(state, leaving, &mut come);
            from.resize(come.len(), (batches + k) as u16);
            messages.extend(feeding.say(state));
        }
        (come, from)
    }

    /// Titles of the columns of measures, feeds and removals.
    pub fn titles(scenario: &Scenario) -> Vec<String> {
        let materials: Vec<&str> = scenario.materials.iter().map(|m| m.name.as_str()).collect();
        let mut titles = Vec::new();
        for measure in &scenario.measures {
            match &measure.kind {
                MeasureKind::RegionCount(count) => titles.extend(count.titles(&measure.name, &materials)),
                MeasureKind::Extent(extent) => titles.extend(extent.titles(&measure.name)),
                MeasureKind::GrainTrace(trace) => titles.extend(trace.titles(&measure.name)),
                MeasureKind::MassFlow(flow) => titles.extend(flow.titles(&measure.name)),
                MeasureKind::Mixing(mixing) => titles.extend(mixing.titles(&measure.name)),
                MeasureKind::Slope(slope) => titles.extend(slope.titles(&measure.name)),
                MeasureKind::Fabric(fabric) => titles.extend(fabric.titles(&measure.name)),
                MeasureKind::Residence(residence) => titles.extend(residence.titles(&measure.name)),
                MeasureKind::Displacement(displacement) => titles.extend(displacement.titles(&measure.name)),
                MeasureKind::NeighbourMixing(mixing) => titles.extend(mixing.titles(&measure.name)),
                MeasureKind::Collisions(collisions) => titles.extend(collisions.titles(&measure.name)),
                MeasureKind::WallsLoad(load) => titles.extend(load.titles(&measure.name)),
                MeasureKind::ContactNetwork(_)
                | MeasureKind::ForceDistribution(_)
                | MeasureKind::Profile(_)
                | MeasureKind::Field(_)
                | MeasureKind::ContactAngles(_)
                | MeasureKind::ForceChains(_)
                | MeasureKind::Paths(_)
                | MeasureKind::CylinderProfile(_) => {}
            }
        }
        for feed in &scenario.feeds {
            let name = format!("feed {}", feed.name);
            titles.extend(FEED_COLUMNS.iter().map(|c| c.title(&name)));
        }
        for removal in &scenario.removals {
            let name = format!("removal {}", removal.name);
            titles.extend(REMOVAL_COLUMNS.iter().map(|c| c.title(&name)));
            for material in &materials {
                let name = format!("{name} {material}");
                titles.extend(OF_MATERIAL_COLUMNS.iter().map(|c| c.title(&name)));
            }
        }
        if scenario.domain.outside == Outside::Remove {
            titles.extend(DOMAIN_COLUMNS.iter().map(|c| c.title("domain")));
        }
        titles
    }

    /// Values of a row, in the order of the titles.
    pub fn values(&mut self, sim: &mut Simulation) -> Vec<Value> {
        self.look(sim);
        let mut values = Vec::new();
        let origins = &self.state.origins;
        let mut followed = self.followed.values(sim, origins);
        for measure in &self.scenario.measures {
            match &measure.kind {
                MeasureKind::RegionCount(count) => values.extend(count.measure(sim, origins)),
                MeasureKind::Extent(extent) => values.extend(extent.measure(sim, origins)),
                MeasureKind::GrainTrace(trace) => values.extend(trace.measure(sim, origins)),
                MeasureKind::MassFlow(_) => values.extend(followed.flows.next().into_iter().flatten()),
                MeasureKind::Residence(_) => values.extend(followed.residences.next().into_iter().flatten()),
                MeasureKind::Displacement(_) => values.extend(followed.displacements.next().into_iter().flatten()),
                MeasureKind::Collisions(_) => values.extend(followed.collisions.next().into_iter().flatten()),
                MeasureKind::Fabric(fabric) => values.extend(fabric.measure(sim, origins)),
                MeasureKind::NeighbourMixing(mixing) => values.extend(mixing.measure(sim, origins)),
                MeasureKind::Mixing(mixing) => values.extend(mixing.measure(sim, origins)),
                MeasureKind::Slope(slope) => values.extend(slope.measure(sim, origins)),
                MeasureKind::WallsLoad(load) => values.extend(load.measure(sim)),
                MeasureKind::ContactNetwork(_)
                | MeasureKind::ForceDistribution(_)
                | MeasureKind::Profile(_)
                | MeasureKind::Field(_)
                | MeasureKind::ContactAngles(_)
                | MeasureKind::ForceChains(_)
                | MeasureKind::Paths(_)
                | MeasureKind::CylinderProfile(_) => {}
            }
        }
        for ((spec, feed), source) in self.scenario.feeds.iter().zip(&self.state.feeds).zip(&self.sources) {
            let behind = feed.behind(spec, source, sim.dt);
            values.extend([
                Value::Count(feed.grains),
                Value::Number(feed.mass),
                Value::Number(behind),
            ]);
        }
        for removal in &self.state.removals {
            let all = removal
                .gone
                .iter()
                .fold((0, 0.0), |sum, of| (sum.0 + of.0, sum.1 + of.1));
            values.extend([Value::Count(all.0), Value::Number(all.1)]);
            values.push(Value::Number(removal.stay / all.0 as f64));
            for (grains, mass) in &removal.gone {
                values.extend([Value::Count(*grains), Value::Number(*mass)]);
            }
        }
        if self.scenario.domain.outside == Outside::Remove {
            let (grains, mass) = sim.books.left_the_domain();
            values.extend([Value::Count(grains), Value::Number(mass)]);
        }
        values
    }
}

/// The checked streams of all feeds, or the first that cannot be and why.
pub(super) fn sources(scenario: &Scenario, domain: &Domain) -> Result<Vec<Streaming>, (usize, InsertionProblem)> {
    let source = |(k, feed): (usize, &FeedSpec)| {
        Streaming::new(&feed.stream, &scenario.materials, domain).map_err(|problem| (k, problem))
    };
    scenario.feeds.iter().enumerate().map(source).collect()
}

/// Whether grains come or go between the latest step and the next.
fn is_due(sim: &Simulation, every: Option<f64>) -> bool {
    sim.step.is_multiple_of(exchange_steps(every, sim.dt))
}
