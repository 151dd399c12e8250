//! A run in the hands of a caller: it goes on as far as it is told, and shows its state in between.

use super::Scenario;
use super::prepare::prepare;
use super::report::RunEnd;
use super::run::{Observer, Runner, read_run, thread_pool};
use super::run_error::RunError;
use super::run_options::RunOptions;
use crate::output::{RunFolder, RunLock, SeriesTable, Summary};
use crate::simulation::{Energies, Simulation};
use self_cell::self_cell;
use std::path::{Path, PathBuf};
use std::time::Instant;

self_cell!(
    /// A runner with the scenario that it reads from.
    struct OwnRunner {
        owner: Scenario,
        #[not_covariant]
        dependent: Runner,
    }
);

/// How far a run is to go.
#[derive(Clone, Copy, Debug, Default)]
pub struct Until {
    /// To this step; to the end of the protocol when absent.
    pub step: Option<u64>,
    /// Until this moment of the clock, at the end of a step.
    pub deadline: Option<Instant>,
    /// To the end of the present stage.
    pub stage: bool,
    /// Beyond the last stage, as it stood at its end and without output.
    pub beyond: bool,
}

/// Where a run has stopped.
#[derive(Clone, Debug, PartialEq)]
pub enum Pause {
    /// At the step that was asked for.
    Step,
    /// At the deadline.
    Deadline,
    /// At the end of a stage.
    Stage,
    /// At the end of the last stage, by the observer, or by a fault.
    End(RunEnd),
}

/// A run that goes on as far as its caller says: step by step, to a time, stage by stage, or to the end. What it computes and
/// writes is the same as in [`run`](super::run()), wherever it pauses.
pub struct LiveRun {
    runner: OwnRunner,
    threads: rayon::ThreadPool,
    folder: Option<RunFolder>,
    /// Reserves the folder, until the protocol is over.
    lock: Option<RunLock>,
    /// How the protocol ended, once it did.
    end: Option<(RunEnd, Summary)>,
}

impl std::fmt::Debug for LiveRun {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "run at step {}", self.with_simulation(|sim| sim.step))
    }
}

impl LiveRun {
    /// A run before its first step. Without a folder it writes nothing and keeps its series in memory.
    pub fn new(
        scenario: Scenario,
        folder: Option<&Path>,
        options: RunOptions,
        observer: &mut dyn Observer,
    ) -> Result<Self, RunError> {
        options.check()?;
        let threads = thread_pool(options.threads)?;
        let folder_and_lock = |scenario: &Scenario, root: &Path| -> Result<_, RunError> {
            let (folder, lock) = options.reserve(root, scenario)?;
            folder.write(&folder.scenario(), scenario.to_resolved_toml().as_bytes())?;
            Ok((folder, lock))
        };
        let (mut kept, mut lock) = (None, None);
        let runner = threads.install(|| {
            OwnRunner::try_new(scenario, |scenario| -> Result<Runner<'_>, RunError> {
                let prepared = prepare(scenario)?;
                (kept, lock) = folder.map(|root| folder_and_lock(scenario, root)).transpose()?.unzip();
                let mut runner = Runner::begin(scenario, prepared, kept.as_ref(), observer)?;
                options.apply(&mut runner.sim);
                Ok(runner)
            })
        })?;
        Ok(Self {
            runner,
            threads,
            folder: kept,
            lock,
            end: None,
        })
    }

    /// The run in a folder from its latest checkpoint on, also when its protocol is over.
    pub fn resume(folder: &Path, options: RunOptions, observer: &mut dyn Observer) -> Result<Self, RunError> {
        options.check()?;
        let folder = RunFolder::open(folder)?;
        let lock = folder.lock()?;
        let (scenario, state, former) = read_run(&folder, &options, observer)?;
        let threads = thread_pool(options.threads)?;
        let runner = threads.install(|| {
            OwnRunner::try_new(scenario, |scenario| -> Result<Runner<'_>, RunError> {
                let mut runner = Runner::resume(scenario, state, Some(&folder), observer)?;
                if let Some(former) = &former {
                    runner.go_on_otherwise(former, observer)?;
                }
                options.apply(&mut runner.sim);
                Ok(runner)
            })
        })?;
        Ok(Self {
            runner,
            threads,
            folder: Some(folder),
            lock: Some(lock),
            end: None,
        })
    }

    /// Goes on. At the end of the protocol, and at a fault, what a run leaves behind is written; after a custom force or motion
    /// failed it is not, for the run may go on. A run that another fault has ended tells it again.
    pub fn advance(&mut self, until: &Until, observer: &mut dyn Observer) -> Result<Pause, RunError> {
        if until.beyond && self.end.is_none() {
            // what a run leaves behind at its end is written before it goes beyond
            let within = Until {
                beyond: false,
                ..*until
            };
            let pause = self.advance_to(&within, observer)?;
            if pause != Pause::End(RunEnd::Finished) {
                return Ok(pause);
            }
        }
        self.advance_to(until, observer)
    }

    fn advance_to(&mut self, until: &Until, observer: &mut dyn Observer) -> Result<Pause, RunError> {
        if let Some((fault @ RunEnd::Fault(_), _)) = &self.end {
            return Ok(Pause::End(fault.clone()));
        }
        let is_done = self.end.is_some();
        let (pause, summary) = self.in_threads(|runner| {
            let pause = runner.advance(until, observer)?;
            let leaves = match &pause {
                Pause::End(RunEnd::Fault(crate::contacts::Fault::Custom { .. }) | RunEnd::Interrupted) => None,
                Pause::End(end) if !is_done => Some(end),
                _ => None,
            };
            let summary = leaves.map(|end| runner.finish(end, observer)).transpose()?;
            Ok::<_, RunError>((pause, summary))
        })?;
        if let (Pause::End(end), Some(summary)) = (&pause, summary) {
            self.end = Some((end.clone(), summary));
            if *end == RunEnd::Finished {
                // what comes after the protocol is not written
                self.release();
            }
        }
        Ok(pause)
    }

    /// Lets a run that a fault has ended go on, as when what led to it was changed.
    pub fn go_on_after_fault(&mut self) {
        self.end.take_if(|(end, _)| matches!(end, RunEnd::Fault(_)));
    }

    /// Lets the folder go, so that another run may be written there; this one must not go on within its protocol.
    pub fn release(&mut self) {
        self.lock = None;
    }

    /// How the run ended and its summary, when the protocol is over or a fault stopped it.
    pub fn end(&self) -> Option<&(RunEnd, Summary)> {
        self.end.as_ref()
    }

    /// The folder of the run, if it writes.
    pub fn folder(&self) -> Option<&Path> {
        self.folder.as_ref().map(RunFolder::root)
    }

    /// The scenario.
    pub fn scenario(&self) -> &Scenario {
        self.runner.borrow_owner()
    }

    /// The stage that the run is in, by its number from 0; `None` when the protocol is over.
    pub fn stage(&self) -> Option<usize> {
        let stage = self.runner.with_dependent(|_, runner| runner.place.stage);
        (stage < self.scenario().stages.len()).then_some(stage)
    }

    /// Looks at the simulation.
    pub fn with_simulation<T>(&self, look: impl FnOnce(&Simulation) -> T) -> T {
        self.runner.with_dependent(|_, runner| look(&runner.sim))
    }

    /// Works on the simulation, with the threads of the run.
    pub fn change<T: Send>(&mut self, work: impl FnOnce(&mut Simulation) -> T + Send) -> T {
        self.in_threads(|runner| {
            let before = runner.sim.dt;
            let done = work(&mut runner.sim);
            runner.note_time_step(before);
            done
        })
    }

    /// The energies and their ledger at this moment.
    pub fn energies(&mut self) -> Energies {
        self.in_threads(|runner| runner.energies())
    }

    /// What a row of the series would tell now, as a series of one row.
    pub fn present(&mut self) -> SeriesTable {
        self.in_threads(|runner| runner.present())
    }

    /// The series so far of a run without a folder; `None` for one that writes it.
    pub fn with_series<T>(&self, look: impl FnOnce(&SeriesTable) -> T) -> Option<T> {
        self.runner.with_dependent(|_, runner| runner.rows.series().map(look))
    }

    /// Writes a checkpoint: into the folder of the run, or, told another one, into a new folder there, from which
    /// [`resume`](Self::resume) goes on; what a run has left there is removed if `overwrite` is told. Tells the folder.
    pub fn checkpoint(&mut self, folder: Option<&Path>, overwrite: bool) -> Result<PathBuf, RunError> {
        let own = self.folder.as_ref();
        let own = own.filter(|own| folder.is_none_or(|root| root == own.root()));
        let _own_lock;
        let _new_lock;
        let folder = match (folder, own) {
            (_, Some(own)) => {
                _own_lock = self.lock.is_none().then(|| own.lock()).transpose()?;
                own.clone()
            }
            (None, None) => return Err(RunError::NoFolder),
            (Some(root), None) => {
                let folder;
                let options = RunOptions {
                    overwrite,
                    ..RunOptions::default()
                };
                (folder, _new_lock) = options.reserve(root, self.scenario())?;
                folder.write(&folder.scenario(), self.scenario().to_resolved_toml().as_bytes())?;
                folder
            }
        };
        self.in_threads(|runner| runner.save_checkpoint(folder.root()))?;
        Ok(folder.root().to_owned())
    }

    fn in_threads<T: Send>(&mut self, work: impl FnOnce(&mut Runner<'_>) -> T + Send) -> T {
        let runner = &mut self.runner;
        self.threads
            .install(|| runner.with_dependent_mut(|_, runner| work(runner)))
    }
}
