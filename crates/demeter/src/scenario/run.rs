//! Running a scenario: stages in order, output at its cadence, checkpoints, and how it ends.

use super::deformation::reached;
use super::field_files::FieldFiles;
use super::prepare::{Prepared, prepare, prepare_to_resume};
use super::report::{Report, RunEnd};
use super::rows::{Rows, told_titles};
use super::run_error::RunError;
use super::run_options::RunOptions;
use super::traffic::{Traffic, TrafficState};
use super::{Scenario, measures::networks};
use crate::checkpoint::{self, Header};
use crate::contacts::Fault;
use crate::measure::{Measures, Moment, contact_records, kinetic_over_elastic, wall_surfaces};
use crate::output::{Frame, FrameWriter, RunFolder, SeriesLabels, StageSummary, wall_summaries};
use crate::particles::Domain;
use crate::simulation::{Phase, Setup, Simulation, SimulationState, Stage, StopCondition};
use crate::walls::Wall;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::path::Path;
use std::time::Instant;

/// Steps between two looks at the energies for a stop condition.
const ENERGY_INTERVAL: u64 = 50;

/// Time between two reports of progress [s].
const PROGRESS_INTERVAL: f64 = 0.25;

/// Where a run stands.
#[derive(Clone, Debug)]
pub struct Progress<'a> {
    /// Name of the stage.
    pub stage: &'a str,
    /// Its number, from 1, and the number of stages.
    pub stage_of: (usize, usize),
    /// Steps done.
    pub step: u64,
    /// Steps of the whole run when no condition ends a stage early.
    pub steps: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Number of grains.
    pub grains: usize,
    /// Seconds since this process began to run steps.
    pub elapsed: f64,
    /// Steps done by this process.
    pub steps_here: u64,
}

/// Whoever watches a run.
pub trait Observer: Send {
    /// Told now and then; `false` asks the run to end with a checkpoint.
    fn progress(&mut self, progress: &Progress) -> bool;
    /// Told once things happen that a user wants to read: the time step, the end of a stage, a warning.
    fn message(&mut self, text: &str);
}

/// Place in the protocol and everything else that a restart needs.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Place {
    pub(super) stage: usize,
    /// Step at which the stage began.
    stage_step: u64,
    /// Displacements of the walls when the stage began [m].
    stage_displacement: Vec<DVec3>,
    last_row: Option<u64>,
    last_frame: Option<u64>,
    pub(super) max_residual: f64,
    pub(super) stages_done: Vec<StageSummary>,
    /// Seconds of computing so far.
    pub(super) wall_clock: f64,
    pub(super) time_step_reason: String,
    pub(super) warnings: Vec<String>,
}

/// Contents of a checkpoint.
#[derive(Debug, Serialize, Deserialize)]
pub struct RunState {
    simulation: SimulationState,
    place: Place,
    domain: Domain,
    traffic: TrafficState,
}

impl RunState {
    /// State of the simulation.
    pub fn simulation(&self) -> &SimulationState {
        &self.simulation
    }
}

/// Runs a scenario and writes its results into a folder.
pub fn run(
    scenario: &Scenario,
    folder: &Path,
    options: RunOptions,
    observer: &mut dyn Observer,
) -> Result<Report, RunError> {
    options.check()?;
    let prepared = prepare(scenario)?;
    with_threads(options.threads, || {
        let folder = RunFolder::create(folder, options.overwrite)?;
        let _lock = folder.lock()?;
        folder.write(&folder.scenario(), scenario.to_resolved_toml().as_bytes())?;
        let mut runner = Runner::begin(scenario, prepared, folder, observer)?;
        options.apply(&mut runner.sim);
        runner.run_to_the_end()
    })
}

/// Continues the run in a folder from its latest checkpoint.
pub fn resume(folder: &Path, options: RunOptions, observer: &mut dyn Observer) -> Result<Report, RunError> {
    options.check()?;
    let folder = RunFolder::open(folder)?;
    let _lock = folder.lock()?;
    let mut scenario = Scenario::read(&folder.scenario(), &[])?;
    let restored = checkpoint::read_latest::<RunState>(folder.root())?;
    // a scenario without a title is named after its file, which has another name here
    scenario.title.clone_from(&restored.header.title);
    for warning in &restored.warnings {
        observer.message(&format!("warning: {warning}"));
    }
    if restored.value.place.stage >= scenario.stages.len() {
        let folder = folder.root().to_owned();
        return Err(RunError::Finished { folder });
    }
    with_threads(options.threads, || {
        let mut runner = Runner::resume(&scenario, restored.value, folder, observer)?;
        options.apply(&mut runner.sim);
        runner.run_to_the_end()
    })
}

fn with_threads<T: Send>(
    threads: Option<usize>,
    work: impl FnOnce() -> Result<T, RunError> + Send,
) -> Result<T, RunError> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.unwrap_or(0))
        .build();
    let failed = |e: rayon::ThreadPoolBuildError| RunError::Threads {
        threads: threads.unwrap_or(0),
        reason: e.to_string(),
    };
    pool.map_err(failed)?.install(work)
}

/// Steps that a stage takes when no other condition ends it.
pub(super) fn longest(stage: &Stage, dt: f64) -> u64 {
    let limits = stage.stop.iter().filter_map(|stop| match stop {
        StopCondition::Duration(seconds) => Some(steps_in(*seconds, dt)),
        StopCondition::Steps(steps) => Some(*steps),
        _ => None,
    });
    limits.min().unwrap_or(0)
}

/// Whole steps nearest to a time, at least one.
fn steps_in(seconds: f64, dt: f64) -> u64 {
    (seconds / dt).round().max(1.0) as u64
}

pub(super) struct Runner<'a> {
    pub(super) scenario: &'a Scenario,
    pub(super) sim: Simulation,
    pub(super) folder: RunFolder,
    pub(super) place: Place,
    pub(super) started: Instant,
    pub(super) first_step: u64,
    /// Sum over the steps of this process of the number of grains.
    pub(super) particle_steps: u64,
    /// What the latest row told.
    pub(super) latest: Option<Measures>,
    traffic: Traffic<'a>,
    steps: u64,
    rows: Rows<'a>,
    frames: FrameWriter,
    fields: FieldFiles<'a>,
    observer: &'a mut dyn Observer,
    told: f64,
    cancelled: bool,
}

impl<'a> Runner<'a> {
    fn begin(
        scenario: &'a Scenario,
        prepared: Prepared,
        folder: RunFolder,
        observer: &'a mut dyn Observer,
    ) -> Result<Self, RunError> {
        let mut say = |text: String| {
            observer.message(&text);
            folder.log_line(&text)
        };
        say(format!("time step {}", prepared.time_step_reason))?;
        for warning in &prepared.warnings {
            say(format!("warning: {warning}"))?;
        }
        let place = Place {
            stage: 0,
            stage_step: 0,
            stage_displacement: Vec::new(),
            last_row: None,
            last_frame: None,
            max_residual: 0.0,
            stages_done: Vec::new(),
            wall_clock: 0.0,
            time_step_reason: prepared.time_step_reason,
            warnings: prepared.warnings,
        };
        let rows = Rows::create(scenario, &folder)?;
        let frames = (
            FrameWriter::create(&folder)?,
            FieldFiles::open(scenario, &folder, None)?,
        );
        let (skin, coupling) = (prepared.setup.skin, prepared.setup.coupling);
        let mut sim = Simulation::new(prepared.setup);
        if !scenario.feeds.is_empty() {
            sim.expect_grains(&prepared.to_come, skin, coupling);
        }
        if scenario.deforms() {
            let plan = scenario.domain.deform.unwrap_or_default();
            sim.deform(plan).map_err(|source| RunError::Deformation {
                stage: "start".to_string(),
                source,
            })?;
        }
        let traffic = Traffic::begin(scenario, sim.domain(), prepared.origins)?;
        let mut runner = Self::new(scenario, (sim, traffic), folder, place, (rows, frames), observer);
        runner.begin_stage()?;
        Ok(runner)
    }

    fn resume(
        scenario: &'a Scenario,
        state: RunState,
        folder: RunFolder,
        observer: &'a mut dyn Observer,
    ) -> Result<Self, RunError> {
        let mut setup: Setup = prepare_to_resume(scenario, state.domain)?;
        setup.dt = state.simulation.dt;
        let step = state.simulation.step;
        let sim = Simulation::resume(setup, state.simulation)?;
        let traffic = Traffic::resume(scenario, sim.domain(), state.traffic)?;
        let rows = Rows::resume(scenario, &folder, step)?;
        let frames = (
            FrameWriter::resume(&folder, step)?,
            FieldFiles::open(scenario, &folder, Some(step))?,
        );
        let text = format!("going on from step {step}, time {:.4e} s", sim.time());
        observer.message(&text);
        folder.log_line(&text)?;
        let runner = Self::new(scenario, (sim, traffic), folder, state.place, (rows, frames), observer);
        Ok(runner)
    }

    fn new(
        scenario: &'a Scenario,
        (sim, traffic): (Simulation, Traffic<'a>),
        folder: RunFolder,
        place: Place,
        (rows, (frames, fields)): (Rows<'a>, (FrameWriter, FieldFiles<'a>)),
        observer: &'a mut dyn Observer,
    ) -> Self {
        let steps = scenario
            .stages
            .iter()
            .map(|s| longest(s, sim.dt))
            .fold(0, u64::saturating_add);
        Self {
            scenario,
            first_step: sim.step,
            particle_steps: 0,
            started: Instant::now(),
            sim,
            folder,
            place,
            latest: None,
            traffic,
            steps,
            rows,
            frames,
            fields,
            observer,
            told: 0.0,
            cancelled: false,
        }
    }

    fn run_to_the_end(&mut self) -> Result<Report, RunError> {
        let end = match self.run_stages()? {
            Ok(end) => end,
            Err(fault) => {
                self.say(&format!("error: {fault}"))?;
                self.write_frame()?;
                RunEnd::Fault(fault)
            }
        };
        self.place.wall_clock += self.started.elapsed().as_secs_f64();
        let report = self.report(end)?;
        if report.end == RunEnd::Finished {
            // last of all: a run whose checkpoint says that it is finished has its report
            self.write_checkpoint()?;
        }
        Ok(report)
    }

    /// Runs all stages; the inner result tells a fault of the simulation.
    fn run_stages(&mut self) -> Result<Result<RunEnd, Fault>, RunError> {
        if !self.sim.is_started() {
            if let Err(fault) = self.sim.start() {
                return Ok(Err(fault));
            }
            self.traffic.tag(&self.sim);
            self.write_row()?;
            self.write_frame()?;
            // a run that is killed before its first interval ends can go on, too
            self.write_checkpoint()?;
        }
        while self.place.stage < self.scenario.stages.len() {
            if let Some(reason) = self.stage_is_over() {
                self.end_stage(&reason)?;
                continue;
            }
            if self.cancelled {
                self.write_checkpoint()?;
                return Ok(Ok(RunEnd::Interrupted));
            }
            // right after a restart it would only push the one before it out
            if self.sim.step > self.first_step && self.is_due(self.stage().cadence.checkpoints) {
                self.write_checkpoint()?;
            }
            for text in self.traffic.exchange(&mut self.sim)? {
                self.say(&text)?;
            }
            if let Err(fault) = self.sim.step() {
                return Ok(Err(fault));
            }
            self.traffic.watch(&self.sim);
            self.particle_steps += self.sim.grains.len() as u64;
            let cadence = self.stage().cadence;
            if self.is_due(cadence.series) {
                self.write_row()?;
            }
            if self.is_due(cadence.frames) {
                self.write_frame()?;
            }
            self.tell();
        }
        Ok(Ok(RunEnd::Finished))
    }

    /// Tells the observer and the log.
    pub(super) fn say(&mut self, text: &str) -> Result<(), RunError> {
        self.observer.message(text);
        Ok(self.folder.log_line(text)?)
    }

    fn stage(&self) -> &'a Stage {
        &self.scenario.stages[self.place.stage.min(self.scenario.stages.len() - 1)]
    }

    fn begin_stage(&mut self) -> Result<(), RunError> {
        self.place.stage_step = self.sim.step;
        self.place.stage_displacement = self.sim.walls.iter().map(|w| w.displacement()).collect();
        let Some(stage) = self.scenario.stages.get(self.place.stage) else {
            return Ok(());
        };
        self.traffic.begin_stage(stage, self.sim.step);
        if let Some(plan) = stage.deformation {
            self.sim.deform(plan).map_err(|source| RunError::Deformation {
                stage: stage.name.clone(),
                source,
            })?;
        }
        self.sim.mark_strain();
        for (wall, motion) in &stage.motions {
            (self.sim)
                .set_wall_motion(*wall, motion.clone())
                .map_err(|source| RunError::Motion {
                    stage: stage.name.clone(),
                    source,
                })?;
        }
        let Some(absent) = &stage.absent else { return Ok(()) };
        let come_and_go = self.sim.set_absent(|wall| absent.contains(&wall));
        come_and_go.map_err(|source| RunError::WallInTheWay {
            stage: stage.name.clone(),
            source: Box::new(source),
        })
    }

    fn end_stage(&mut self, reason: &str) -> Result<(), RunError> {
        self.write_row()?;
        self.write_frame()?;
        self.draw_stage()?;
        let stage = self.stage();
        let (start, dt) = (self.place.stage_step, self.sim.dt);
        self.say(&format!(
            "stage `{}` ended at {:.4e} s: {reason}",
            stage.name,
            self.sim.time()
        ))?;
        self.place.stages_done.push(StageSummary {
            name: stage.name.clone(),
            first_step: start,
            last_step: self.sim.step,
            start: start as f64 * dt,
            end: self.sim.time(),
            ended_by: reason.to_string(),
            walls: self
                .latest
                .as_ref()
                .map(|row| wall_summaries(row, &labels(self.scenario).walls))
                .unwrap_or_default(),
        });
        self.place.stage += 1;
        self.begin_stage()
    }

    /// Whether an interval of the stage ends at this step.
    fn is_due(&self, interval: Option<f64>) -> bool {
        let elapsed = self.sim.step - self.place.stage_step;
        interval.is_some_and(|seconds| elapsed > 0 && elapsed.is_multiple_of(steps_in(seconds, self.sim.dt)))
    }

    /// What ends the stage at this step, in words.
    fn stage_is_over(&mut self) -> Option<String> {
        let elapsed = self.sim.step - self.place.stage_step;
        let dt = self.sim.dt;
        self.stage().stop.iter().find_map(|stop| match stop {
            StopCondition::Duration(seconds) => {
                (elapsed >= steps_in(*seconds, dt)).then(|| format!("its duration of {seconds} s is over"))
            }
            StopCondition::Steps(steps) => (elapsed >= *steps).then(|| format!("its {steps} steps are done")),
            StopCondition::KineticOverElastic(share) => {
                let looks = elapsed > 0 && elapsed.is_multiple_of(ENERGY_INTERVAL);
                let energies = looks.then(|| self.sim.energies()).filter(|e| e.elastic > 0.0)?;
                let ratio = kinetic_over_elastic(&self.sim, &energies);
                (ratio < *share).then(|| format!("kinetic over elastic energy is {ratio:.3e}, below {share:e}"))
            }
            StopCondition::WallForce {
                walls,
                direction,
                above,
            } => {
                let walls = || walls.iter().map(|&wall| &self.sim.walls[wall]);
                let force: f64 = walls().map(|w| w.load().0.dot(DVec3::from_array(*direction))).sum();
                (elapsed > 0 && force >= *above).then(|| {
                    let names: Vec<String> = walls().map(|wall| format!("`{}`", wall.name)).collect();
                    let names = names.join(" and ");
                    format!("the force on wall {names} is {force:.6} N, {above} N was asked")
                })
            }
            StopCondition::WallTravel { wall, distance } => {
                let travel = self.travel(*wall);
                (travel >= *distance * (1.0 - 1e-12))
                    .then(|| format!("wall `{}` has moved by {travel:.6} m", self.sim.walls[*wall].name))
            }
            StopCondition::Strain { wall, length, strain } => {
                let reached = self.travel(*wall) / length;
                (reached >= *strain * (1.0 - 1e-12)).then(|| format!("the strain is {reached:.6}"))
            }
            StopCondition::BoxStress { .. } | StopCondition::BoxStrain { .. } | StopCondition::ShearStrain(_) => {
                let looks = elapsed > 0 && elapsed.is_multiple_of(ENERGY_INTERVAL);
                reached(stop, &self.sim, looks)
            }
            StopCondition::MotionDone(wall) => {
                let wall = &self.sim.walls[*wall];
                (elapsed > 0 && wall.motion_is_done()).then(|| format!("the motion of wall `{}` is done", wall.name))
            }
            StopCondition::FeedDone(feed) => {
                let name = self.scenario.feeds.get(*feed).map_or("", |f| f.name.as_str());
                self.traffic.is_done(*feed).then(|| format!("feed `{name}` is done"))
            }
            StopCondition::GrainsAtMost(count) => {
                let left = self.sim.grains.len();
                (elapsed > 0 && left as u64 <= *count).then(|| format!("{left} grains are left"))
            }
        })
    }

    /// Distance of a wall from where it stood at the start of the stage [m].
    fn travel(&self, wall: usize) -> f64 {
        (self.sim.walls[wall].displacement() - self.place.stage_displacement[wall]).length()
    }

    fn write_row(&mut self) -> Result<(), RunError> {
        if self.place.last_row == Some(self.sim.step) {
            return Ok(());
        }
        self.sim.took(Phase::Other);
        let moment = self.moment();
        let row = self.rows.write(&mut self.sim, &mut self.traffic, moment)?;
        self.place.max_residual = self.place.max_residual.max(row.energies.residual.abs());
        self.place.last_row = Some(self.sim.step);
        self.latest = Some(row);
        self.sim.took(Phase::Output);
        Ok(())
    }

    fn moment(&self) -> Moment {
        Moment {
            stage: self.place.stage,
            stage_time: (self.sim.step - self.place.stage_step) as f64 * self.sim.dt,
        }
    }

    fn write_frame(&mut self) -> Result<(), RunError> {
        if self.place.last_frame == Some(self.sim.step) {
            return Ok(());
        }
        self.sim.took(Phase::Other);
        self.with_frame(|frames, frame| frames.write(frame))?;
        let moment = self.moment();
        self.fields.write(&self.sim, &mut self.traffic, moment)?;
        self.sim.walls.iter_mut().for_each(Wall::begin_interval);
        self.place.last_frame = Some(self.sim.step);
        self.sim.took(Phase::Output);
        Ok(())
    }

    /// Hands the present state to a writer.
    pub(super) fn with_frame<T>(&mut self, work: impl FnOnce(&mut FrameWriter, &Frame) -> T) -> T {
        let contacts = contact_records(&self.sim);
        let walls = wall_surfaces(&self.sim);
        let frame = Frame {
            step: self.sim.step,
            time: self.sim.time(),
            grains: &self.sim.grains,
            materials: self.sim.materials.list(),
            contacts: &contacts,
            walls: &walls,
            tags: self.traffic.tags(&self.sim),
        };
        work(&mut self.frames, &frame)
    }

    fn write_checkpoint(&mut self) -> Result<(), RunError> {
        self.sim.took(Phase::Other);
        let simulation = self.sim.state();
        let header = Header {
            engine_version: crate::VERSION.to_string(),
            title: self.scenario.title.clone(),
            step: self.sim.step,
            time: self.sim.time(),
            grains: self.sim.grains.len() as u64,
            contacts: simulation.contact_count() as u64,
        };
        let mut place = self.place.clone();
        place.wall_clock += self.started.elapsed().as_secs_f64();
        let state = RunState {
            simulation,
            place,
            domain: *self.sim.domain(),
            traffic: self.traffic.state(),
        };
        checkpoint::write_latest(self.folder.root(), &header, &state)?;
        self.sim.took(Phase::Output);
        Ok(())
    }

    fn tell(&mut self) {
        let elapsed = self.started.elapsed().as_secs_f64();
        if elapsed - self.told < PROGRESS_INTERVAL {
            return;
        }
        self.told = elapsed;
        let progress = Progress {
            stage: &self.stage().name,
            stage_of: (self.place.stage + 1, self.scenario.stages.len()),
            step: self.sim.step,
            steps: self.steps,
            time: self.sim.time(),
            grains: self.sim.grains.len(),
            elapsed,
            steps_here: self.sim.step - self.first_step,
        };
        self.cancelled = !self.observer.progress(&progress);
    }
}

pub(super) fn labels(scenario: &Scenario) -> SeriesLabels {
    SeriesLabels {
        stages: scenario.stages.iter().map(|s| s.name.clone()).collect(),
        walls: scenario.walls.iter().map(|w| w.name.clone()).collect(),
        strain: scenario.output.strain.is_some(),
        networks: networks(&scenario.measures).map(|(name, _)| name.to_owned()).collect(),
        told: told_titles(scenario),
    }
}
