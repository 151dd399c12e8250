//! Running a scenario: stages in order, output at its cadence, checkpoints, and how it ends.

mod changed;
mod sharing;
mod stages;
mod start;
mod writing;

use super::column_stops::Held;
use super::field_files::FieldFiles;
use super::input_files::InputFile;
use super::live::{Pause, Until};
use super::prepare::Prepared;
use super::report::{Report, RunEnd};
use super::rows::{Rows, told_titles};
use super::run_error::RunError;
use super::stray_walls::StrayWalls;
use super::traffic::{Traffic, TrafficState};
use super::{Scenario, measures::networks};
use crate::contacts::Fault;
use crate::measure::Measures;
use crate::output::{FrameWriter, RunFolder, SeriesLabels, StageSummary, Summary, WrittenFiles};
use crate::particles::Domain;
use crate::simulation::{Cadence, Simulation, SimulationState, Stage, StopCondition, ends_at};
use crate::walls::WallWork;
use glam::DVec3;
use serde::{Deserialize, Serialize};
pub use sharing::all_or_none;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

pub(super) use start::read_run;
pub(crate) use start::thread_pool;
pub use start::{resume, resume_shared, run, run_shared};
pub(super) use writing::larger;

/// Steps between two looks at the energies for a stop condition.
const ENERGY_INTERVAL: u64 = 50;

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
    /// Told every [`interval`](Self::interval); `false` asks the run to end with a checkpoint.
    fn progress(&mut self, progress: &Progress) -> bool;
    /// Least time between two reports of progress, a quarter of a second unless told; with zero there is one after each step.
    fn interval(&self) -> Duration {
        Duration::from_millis(250)
    }
    /// Told once things happen that a user wants to read: the time step, the end of a stage, a warning.
    fn message(&mut self, text: &str);
}

/// Place in the protocol and everything else that a restart needs.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Place {
    pub(super) stage: usize,
    /// Step at which the stage began.
    stage_step: u64,
    /// How many of the grains that left the domain since then were told.
    pub(super) departures_told: usize,
    /// Displacements of the walls when the stage began [m].
    stage_displacement: Vec<DVec3>,
    /// What walls had done until then.
    stage_work: Vec<WallWork>,
    /// Since when the conditions of the stage on columns hold, by their places in it.
    columns_held: Vec<Option<Held>>,
    last_row: Option<u64>,
    last_frame: Option<u64>,
    /// What is in the folder of the checkpoint.
    written: WrittenFiles,
    pub(super) max_residual: f64,
    pub(super) stages_done: Vec<StageSummary>,
    /// Seconds of computing so far.
    pub(super) wall_clock: f64,
    pub(super) time_step_reason: String,
    pub(super) warnings: Vec<String>,
    /// What files of rows lack, by their names, that were not whole when the run went on.
    pub(super) lost_rows: BTreeMap<String, String>,
    /// The scenario that is run, as its folder tells it.
    pub(super) scenario: String,
    /// Files that the scenario names, as they were at the start.
    pub(super) files: Vec<InputFile>,
}

/// Contents of a checkpoint.
#[derive(Debug, Serialize, Deserialize)]
pub struct RunState<'a> {
    simulation: SimulationState<'a>,
    place: Place,
    domain: Domain,
    traffic: TrafficState,
}

impl<'a> RunState<'a> {
    /// State of the simulation.
    pub fn simulation(&self) -> &SimulationState<'a> {
        &self.simulation
    }
}

/// Steps that a stage takes when no other condition ends it; they may be more than a run can count.
pub(super) fn longest(stage: &Stage, dt: f64) -> f64 {
    let limits = stage.stop.iter().filter_map(|stop| match stop {
        StopCondition::Duration(seconds) => Some(whole_steps(*seconds, dt)),
        StopCondition::Steps(steps) => Some(*steps as f64),
        _ => None,
    });
    limits.reduce(f64::min).unwrap_or(0.0)
}

fn whole_steps(seconds: f64, dt: f64) -> f64 {
    (seconds / dt).round().max(1.0)
}

/// Whole steps nearest to a time, at least one.
pub(super) fn steps_in(seconds: f64, dt: f64) -> u64 {
    whole_steps(seconds, dt) as u64
}

pub(super) struct Runner<'a> {
    pub(super) scenario: &'a Scenario,
    pub(super) sim: Simulation,
    /// `None` for a run that writes nothing.
    pub(super) files: Option<Files<'a>>,
    pub(super) place: Place,
    pub(super) started: Instant,
    pub(super) first_step: u64,
    /// The step of the latest checkpoint that is known here.
    checkpoint_step: u64,
    /// Seconds of computing when it paused last.
    computed: f64,
    /// Sum over the steps of this process of the number of grains.
    pub(super) particle_steps: u64,
    /// What the latest row told.
    latest: Option<Measures>,
    traffic: Traffic<'a>,
    stray_walls: StrayWalls,
    steps: u64,
    pub(super) rows: Rows<'a>,
    told: f64,
    cancelled: bool,
}

/// What a run writes beside its rows.
pub(super) struct Files<'a> {
    pub(super) folder: RunFolder,
    frames: FrameWriter,
    fields: FieldFiles<'a>,
}

impl<'a> Runner<'a> {
    /// A run before its first step; without a folder nothing is written.
    pub(super) fn begin(
        scenario: &'a Scenario,
        prepared: Prepared,
        folder: Option<&RunFolder>,
        observer: &mut dyn Observer,
    ) -> Result<Self, RunError> {
        let mut say = |text: String| {
            observer.message(&text);
            folder.map_or(Ok(()), |folder| folder.log_line(&text))
        };
        say(format!("time step {}", prepared.time_step_reason))?;
        for warning in &prepared.warnings {
            say(format!("warning: {warning}"))?;
        }
        let place = Place {
            stage: 0,
            stage_step: 0,
            departures_told: 0,
            stage_displacement: Vec::new(),
            stage_work: Vec::new(),
            columns_held: Vec::new(),
            last_row: None,
            last_frame: None,
            written: WrittenFiles::default(),
            max_residual: 0.0,
            stages_done: Vec::new(),
            wall_clock: 0.0,
            time_step_reason: prepared.time_step_reason,
            warnings: prepared.warnings,
            lost_rows: BTreeMap::new(),
            scenario: scenario.to_resolved_toml(),
            files: scenario.input_files(),
        };
        let rows = match folder {
            Some(folder) => Rows::create(scenario, folder)?,
            None => Rows::in_memory(scenario),
        };
        let files = |folder: &RunFolder| -> Result<Files, RunError> {
            Ok(Files {
                frames: FrameWriter::create(folder)?,
                fields: FieldFiles::open(scenario, folder, None)?.0,
                folder: folder.clone(),
            })
        };
        let files = folder.map(files).transpose()?;
        let (skin, coupling) = (prepared.setup.skin, prepared.setup.coupling);
        let mut sim = Simulation::new(prepared.setup);
        if !(scenario.feeds.is_empty() && prepared.later.is_empty()) {
            sim.expect(&prepared.to_come, &prepared.later, skin, coupling);
        }
        if scenario.deforms() {
            let plan = scenario.domain.deform.unwrap_or_default();
            sim.deform(plan).map_err(|source| RunError::Deformation {
                stage: "start".to_string(),
                source,
            })?;
        }
        let traffic = Traffic::begin(scenario, &sim, prepared.origins)?;
        let mut runner = Self::new(scenario, (sim, traffic), place, (rows, files));
        runner.begin_stage(observer)?;
        Ok(runner)
    }

    fn new(
        scenario: &'a Scenario,
        (mut sim, traffic): (Simulation, Traffic<'a>),
        place: Place,
        (rows, files): (Rows<'a>, Option<Files<'a>>),
    ) -> Self {
        let steps = scenario
            .stages
            .iter()
            .map(|s| longest(s, sim.dt) as u64)
            .fold(0, u64::saturating_add);
        if traffic.hears_impacts() {
            sim.watch_impacts();
        }
        Self {
            scenario,
            stray_walls: StrayWalls::of(&sim.walls, sim.domain(), &sim.grains),
            first_step: sim.step,
            checkpoint_step: sim.step,
            particle_steps: 0,
            started: Instant::now(),
            computed: 0.0,
            sim,
            files,
            place,
            latest: None,
            traffic,
            steps,
            rows,
            told: 0.0,
            cancelled: false,
        }
    }

    fn run_to_the_end(&mut self, folder: &Path, observer: &mut dyn Observer) -> Result<Report, RunError> {
        let end = loop {
            if let Pause::End(end) = self.advance(&Until::default(), observer)? {
                break end;
            }
        };
        let summary = self.finish(&end, observer)?;
        let folder = folder.to_owned();
        Ok(Report { end, summary, folder })
    }

    /// Writes what a run leaves behind at its end.
    pub(super) fn finish(&mut self, end: &RunEnd, observer: &mut dyn Observer) -> Result<Summary, RunError> {
        self.started = clock_after(self.computed);
        if let RunEnd::Fault(fault) = &end {
            self.say(&format!("error: {fault}"), observer)?;
            self.write_frame()?;
        }
        if *end == RunEnd::Finished {
            self.check_rows()?;
        }
        self.tell_the_end(observer)?;
        self.place.wall_clock += self.started.elapsed().as_secs_f64();
        let summary = self.report(end)?;
        let page = self.write_page(observer);
        if *end == RunEnd::Finished {
            // last of all: a run whose checkpoint says that it is finished has all that it leaves, but for a page that can be written later
            self.write_checkpoint()?;
        }
        page.map(|()| summary)
    }

    /// Runs on, stage by stage. Where it pauses changes no bit of the results.
    pub(super) fn advance(&mut self, until: &Until, observer: &mut dyn Observer) -> Result<Pause, RunError> {
        self.started = clock_after(self.computed);
        let mut pause = self.run_on(until, observer)?;
        if let Err(fault) = self.sim.settle() {
            pause = Pause::End(RunEnd::Fault(fault));
        }
        self.computed = self.started.elapsed().as_secs_f64();
        Ok(pause)
    }

    fn run_on(&mut self, until: &Until, observer: &mut dyn Observer) -> Result<Pause, RunError> {
        if let Err(fault) = self.start(observer)? {
            return Ok(Pause::End(RunEnd::Fault(fault)));
        }
        let began_in = self.place.stage;
        loop {
            let is_over = self.place.stage >= self.scenario.stages.len();
            if is_over && !until.beyond {
                return Ok(Pause::End(RunEnd::Finished));
            }
            if let (false, Some((stop, reason))) = (is_over, self.stage_is_over()) {
                if let Err(fault) = self.sim.settle() {
                    return Ok(Pause::End(RunEnd::Fault(fault)));
                }
                let ended = self.end_stage((stop, &reason), observer);
                if let Err(fault) = self.or_fault(ended)? {
                    return Ok(Pause::End(RunEnd::Fault(fault)));
                }
                continue;
            }
            if until.stage && self.place.stage > began_in {
                return Ok(Pause::Stage);
            }
            if std::mem::take(&mut self.cancelled) {
                if let Err(fault) = self.sim.settle() {
                    return Ok(Pause::End(RunEnd::Fault(fault)));
                }
                self.write_checkpoint()?;
                return Ok(Pause::End(RunEnd::Interrupted));
            }
            if until.step.is_some_and(|step| self.sim.step >= step) {
                return Ok(Pause::Step);
            }
            if until.deadline.is_some_and(|deadline| Instant::now() >= deadline) {
                return Ok(Pause::Deadline);
            }
            if let Err(fault) = self.one_step(is_over, observer)? {
                return Ok(Pause::End(RunEnd::Fault(fault)));
            }
        }
    }

    /// The moment before the first step; the inner result tells a fault of the simulation.
    fn start(&mut self, observer: &mut dyn Observer) -> Result<Result<(), Fault>, RunError> {
        if self.sim.is_started() {
            return Ok(Ok(()));
        }
        let started = self.sim.start();
        self.tell_departures(observer)?;
        if let Err(fault) = started {
            return Ok(Err(fault));
        }
        self.traffic.tag(&self.sim);
        self.write_row()?;
        self.write_frame()?;
        // a run that is killed before its first interval ends can go on, too
        self.write_checkpoint()?;
        Ok(Ok(()))
    }

    /// One step, with what is written before and after it; nothing is when the protocol is over.
    fn one_step(&mut self, is_over: bool, observer: &mut dyn Observer) -> Result<Result<(), Fault>, RunError> {
        // right after a restart it would only push the one before it out
        if !is_over && self.sim.step > self.first_step && self.checkpoint_is_due() {
            self.write_checkpoint()?;
        }
        let exchanged = self.traffic.exchange(&mut self.sim);
        match self.or_fault(exchanged)? {
            Err(fault) => return Ok(Err(fault)),
            Ok(texts) => texts.iter().try_for_each(|text| self.say(text, observer))?,
        }
        let stepped = self.sim.step_on();
        self.tell_departures(observer)?;
        if let Err(fault) = stepped {
            return Ok(Err(fault));
        }
        if self.looks(is_over)
            && let Err(fault) = self.sim.settle()
        {
            return Ok(Err(fault));
        }
        self.traffic.watch(&mut self.sim);
        self.particle_steps += self.sim.grains.len() as u64;
        let cadence = self.stage().cadence;
        if !is_over && self.is_due(cadence.series) {
            self.write_row()?;
            self.tell_stray_walls(observer)?;
        }
        if !is_over && self.is_due(cadence.frames) {
            self.write_frame()?;
        }
        self.tell(observer);
        self.cancelled |= self.sim.is_asked_to_end();
        Ok(Ok(()))
    }

    /// What cannot be done in the state that the run has come to is a fault of the simulation: the inner result.
    fn or_fault<T>(&self, result: Result<T, RunError>) -> Result<Result<T, Fault>, RunError> {
        match result.map_err(|error| error.in_a_run(self.sim.step)) {
            Ok(value) => Ok(Ok(value)),
            Err(Ok(fault)) => Ok(Err(fault)),
            Err(Err(error)) => Err(error),
        }
    }

    /// Tells walls that grains do not meet any more.
    pub(super) fn tell_stray_walls(&mut self, observer: &mut dyn Observer) -> Result<(), RunError> {
        let news = (self.stray_walls).news(&self.sim.walls, self.sim.domain(), &self.sim.grains);
        news.iter().try_for_each(|text| self.say(text, observer))
    }

    /// Tells the observer and the log, and a warning the summary, too.
    pub(super) fn say(&mut self, text: &str, observer: &mut dyn Observer) -> Result<(), RunError> {
        if let Some(warning) = text.strip_prefix("warning: ") {
            self.place.warnings.push(warning.to_owned());
        }
        self.tell_text(text, observer)
    }

    /// Tells the observer and the log.
    pub(super) fn tell_text(&mut self, text: &str, observer: &mut dyn Observer) -> Result<(), RunError> {
        observer.message(text);
        let log = |files: &Files| files.folder.log_line(text);
        Ok(self.files.as_ref().map_or(Ok(()), log)?)
    }

    fn stage(&self) -> &'a Stage {
        &self.scenario.stages[self.place.stage.min(self.scenario.stages.len() - 1)]
    }

    /// Whether an interval of the stage ends at this step.
    fn is_due(&self, interval: Option<f64>) -> bool {
        let elapsed = self.sim.step - self.place.stage_step;
        interval.is_some_and(|seconds| ends_at(seconds, self.sim.dt, elapsed))
    }

    /// Whether a checkpoint is to be written at this step: an interval ends, or a stage did and the last checkpoint is half an interval old.
    fn checkpoint_is_due(&self) -> bool {
        let age = (self.sim.step - self.checkpoint_step) as f64 * self.sim.dt;
        let is_old = |interval: f64| age >= 0.5 * interval;
        let before = self
            .place
            .stage
            .checked_sub(1)
            .and_then(|stage| Some(self.scenario.stages.get(stage)?.cadence));
        let begins = self.sim.step == self.place.stage_step;
        self.is_due(self.stage().cadence.checkpoints)
            || begins && before.is_some_and(|before| before.checkpoints.is_some_and(is_old))
    }

    /// Whether the grains are looked at after this step: by what is written, by what lets grains come and go or follows them, or by a
    /// condition that ends the stage.
    fn looks(&self, is_over: bool) -> bool {
        let Cadence {
            series,
            frames,
            checkpoints,
        } = self.stage().cadence;
        let writes = [series, frames, checkpoints]
            .into_iter()
            .any(|interval| self.is_due(interval));
        let elapsed = self.sim.step - self.place.stage_step;
        (!is_over && (writes || elapsed.is_multiple_of(ENERGY_INTERVAL))) || self.traffic.looks(&self.sim)
    }

    fn tell(&mut self, observer: &mut dyn Observer) {
        let elapsed = self.started.elapsed().as_secs_f64();
        if elapsed - self.told < observer.interval().as_secs_f64() {
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
        if observer.progress(&progress) {
            return;
        }
        if self.sim.sharing().is_some() {
            // all end after the same step
            self.sim.ask_to_end();
        } else {
            self.cancelled = true;
        }
    }
}

/// The files that every frame changes.
fn of_frames(scenario: &Scenario, folder: &RunFolder) -> Vec<PathBuf> {
    [FrameWriter::files(folder), FieldFiles::files(scenario, folder)].concat()
}

/// A clock that has run for so many seconds.
fn clock_after(seconds: f64) -> Instant {
    let now = Instant::now();
    now.checked_sub(Duration::from_secs_f64(seconds)).unwrap_or(now)
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
