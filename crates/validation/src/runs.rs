//! Runs of scenarios in folders: begun, taken up again, or taken as they are.

use crate::folder::{State, state};
use demeter::scenario::{Diagnostics, Observer, Progress, RunEnd, RunError, RunOptions, Scenario, resume, run};
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Says what happens, from any thread.
pub type Tell<'a> = &'a (dyn Fn(&str) + Sync);

/// One run.
#[derive(Clone, Debug)]
pub struct Job {
    /// Name, for messages.
    pub name: String,
    /// What is run.
    pub scenario: Scenario,
    /// Folder of the run.
    pub folder: PathBuf,
    /// Number of threads; all cores when absent.
    pub threads: Option<usize>,
    /// Whether another run in the folder may be replaced.
    pub overwrite: bool,
}

/// Why a run did not come to its end.
#[derive(Debug, thiserror::Error)]
pub enum JobError {
    /// The scenario is wrong.
    #[error("{0}")]
    Scenario(Box<Diagnostics>),
    /// The run could not be carried out.
    #[error("{name}: {source}")]
    Run {
        /// Name of the run.
        name: String,
        /// Why.
        source: Box<RunError>,
    },
    /// The run did not come to its end.
    #[error("{name}: the run in `{}` did not come to its end: {reason}", folder.display())]
    Unfinished {
        /// Name of the run.
        name: String,
        /// Folder of the run.
        folder: PathBuf,
        /// Why.
        reason: String,
    },
    /// The folder of a run holds another one.
    #[error(
        "`{}` holds a run of another scenario or version of Demeter; choose another --out, or replace it with \
         --overwrite",
        folder.display()
    )]
    OtherRun {
        /// The folder.
        folder: PathBuf,
    },
}

impl Job {
    /// Carries the run out. A finished run of the same scenario is used again, an interrupted one goes on.
    pub fn carry_out(&self, tell: Tell<'_>) -> Result<(), JobError> {
        let (name, folder) = (&self.name, &self.folder);
        let shown = folder.display();
        let options = RunOptions {
            threads: self.threads,
            overwrite: self.overwrite,
            ..RunOptions::default()
        };
        let mut watcher = Watcher { name, tell, told: 0.0 };
        let report = match state(folder, &self.scenario) {
            State::Finished => {
                tell(&format!("{name}: taken from {shown}"));
                return Ok(());
            }
            State::Begun => {
                tell(&format!("{name}: goes on in {shown}"));
                resume(folder, options, &mut watcher)
            }
            State::Other if !self.overwrite => {
                return Err(JobError::OtherRun { folder: folder.clone() });
            }
            State::Other | State::Free => {
                tell(&format!("{name}: runs in {shown}"));
                run(&self.scenario, folder, options, &mut watcher)
            }
        };
        let report = report.map_err(|error| match error {
            RunError::Scenario(faults) => JobError::Scenario(faults),
            source => JobError::Run {
                name: name.clone(),
                source: Box::new(source),
            },
        })?;
        match report.end {
            RunEnd::Finished => Ok(()),
            RunEnd::Interrupted => Err(self.unfinished("it was interrupted")),
            RunEnd::Fault(fault) => Err(self.unfinished(fault.to_string())),
        }
    }

    fn unfinished(&self, reason: impl Into<String>) -> JobError {
        JobError::Unfinished {
            name: self.name.clone(),
            folder: self.folder.clone(),
            reason: reason.into(),
        }
    }
}

/// Carries runs out, so many at a time. All are begun even when one fails; the failure of the first in the list is told.
pub fn carry_out_all(jobs: &[Job], at_a_time: usize, tell: Tell<'_>) -> Result<(), JobError> {
    let next = AtomicUsize::new(0);
    let results: Vec<Mutex<Option<Result<(), JobError>>>> = jobs.iter().map(|_| Mutex::new(None)).collect();
    thread::scope(|scope| {
        for _ in 0..at_a_time.clamp(1, jobs.len().max(1)) {
            scope.spawn(|| {
                while let Some((job, result)) = {
                    let k = next.fetch_add(1, Ordering::Relaxed);
                    jobs.get(k).zip(results.get(k))
                } {
                    let done = job.carry_out(tell);
                    if let Ok(mut slot) = result.lock() {
                        *slot = Some(done);
                    }
                }
            });
        }
    });
    for (job, slot) in jobs.iter().zip(results) {
        let done = slot.into_inner().ok().flatten();
        done.unwrap_or_else(|| Err(job.unfinished("its thread ended early")))?;
    }
    Ok(())
}

/// Seconds between two reports of progress.
const REPORT_EVERY: f64 = 60.0;

/// Passes on what a run tells.
struct Watcher<'a> {
    name: &'a str,
    tell: Tell<'a>,
    told: f64,
}

impl Observer for Watcher<'_> {
    fn progress(&mut self, progress: &Progress) -> bool {
        if progress.elapsed - self.told >= REPORT_EVERY {
            self.told = progress.elapsed;
            let Progress {
                stage, time, grains, ..
            } = progress;
            let rate = progress.steps_here as f64 / progress.elapsed;
            let line = format!("stage {stage}, {time:.5} s, {grains} grains, {rate:.0} steps/s");
            (self.tell)(&format!("{}: {line}", self.name));
        }
        true
    }

    fn message(&mut self, text: &str) {
        (self.tell)(&format!("{}: {text}", self.name));
    }
}
