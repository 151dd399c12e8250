//! What a run leaves behind at its end: summary, picture, plots.

use super::measures::MeasureKind;
use super::plots;
use super::run::{Observer, Runner, larger};
use super::run_error::RunError;
use super::words;
use crate::contacts::{Fault, WHY_OUTSIDE};
use crate::measure::measure;
use crate::output::picture::{PictureOptions, render_packing};
use crate::output::{OutputError, RunFolder, Summary, path_lines};
use crate::report::{self, ReportError};
use crate::simulation::{MOST_TOLD, Phase};
use std::path::PathBuf;

/// How a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum RunEnd {
    /// All stages are done.
    Finished,
    /// It was asked to end; a checkpoint holds its state.
    Interrupted,
    /// The simulation reached a state that the model does not cover.
    Fault(Fault),
}

/// A run at its end.
#[derive(Clone, Debug)]
pub struct Report {
    /// How it ended.
    pub end: RunEnd,
    /// What `summary.json` tells.
    pub summary: Summary,
    /// The folder of the results.
    pub folder: PathBuf,
}

/// Most stages whose ends are drawn.
const MAX_STAGE_PICTURES: usize = 99;

/// A residual of the energy books that a run is warned of.
const LARGEST_RESIDUAL: f64 = 1e-3;

impl Runner<'_> {
    /// Draws the end of the present stage.
    pub(super) fn draw_stage(&mut self) -> Result<(), RunError> {
        let stage = self.place.stage;
        if !self.scenario.output.picture || stage >= MAX_STAGE_PICTURES {
            return Ok(());
        }
        let name = &self.scenario.stages[stage].name;
        let title = format!("{}: end of {name}", self.scenario.title);
        self.draw(|folder| folder.stage_picture(stage + 1, name), &title)?;
        self.sim.took(Phase::Output);
        Ok(())
    }

    /// The warning of books that do not close.
    fn residual_warning(&self) -> Option<String> {
        let residual = self.place.max_residual;
        // one that is no number is told, too
        (residual.is_nan() || residual > LARGEST_RESIDUAL).then(|| {
            format!(
                "the energy books do not close: the residual reached {residual:.1e} of the energy that passed through; \
                 half the time step makes it smaller where the step is the reason; where it does not, please report it with the \
                 scenario"
            )
        })
    }

    /// Tells the first grains that left the domain in a stage, where that removes grains.
    pub(super) fn tell_departures(&mut self, observer: &mut dyn Observer) -> Result<(), RunError> {
        let departures = std::mem::take(&mut self.sim.departures);
        let untold = MOST_TOLD - self.place.departures_told.min(MOST_TOLD);
        for departure in departures.iter().take(untold) {
            self.place.departures_told += 1;
            let time = self.sim.time();
            let more = match self.place.departures_told {
                1 => format!("; if it should not: {WHY_OUTSIDE}"),
                MOST_TOLD => "; what leaves after it in this stage is only counted".to_owned(),
                _ => String::new(),
            };
            self.say(
                &format!("{departure}, at {time:.4e} s, and was removed{more}"),
                observer,
            )?;
        }
        Ok(())
    }

    /// How much left the domain, where that removes grains.
    fn left_the_domain(&self) -> Option<String> {
        let (grains, mass) = self.sim.books.left_the_domain();
        (grains > 0).then(|| {
            let (grains_were, were) = if grains == 1 {
                ("grain", "was")
            } else {
                ("grains", "were")
            };
            format!(
                "{grains} {grains_were}, {} left the domain and {were} removed, as `domain.outside = \"remove\"` says",
                words::mass(mass)
            )
        })
    }

    /// Tells what only the end of a run knows.
    pub(super) fn tell_the_end(&mut self, observer: &mut dyn Observer) -> Result<(), RunError> {
        if let Some(left) = self.left_the_domain() {
            self.say(&left, observer)?;
        }
        if let Some(warning) = self.residual_warning() {
            self.tell_text(&format!("warning: {warning}"), observer)?;
        }
        Ok(())
    }

    /// Writes the report, of what the folder holds. What cannot be read there is warned of; a page that cannot be written is missing.
    pub(super) fn write_page(&mut self, observer: &mut dyn Observer) -> Result<(), RunError> {
        let files = self.files.as_ref().filter(|_| self.scenario.output.report);
        let Some(folder) = files.map(|files| files.folder.root().to_owned()) else {
            return Ok(());
        };
        let problems = match report::write_at_the_end(&folder) {
            Ok(written) => written.problems,
            Err(ReportError::Output(error)) => {
                // told to the observer alone: where there is no room for the page, there may be none in the log
                observer.message(&format!(
                    "all else of the run is written; `demeter report {}` writes the page that is missing",
                    folder.display()
                ));
                return Err(error.into());
            }
            Err(error) => vec![format!("no report: {error}")],
        };
        for problem in problems {
            self.say(&format!("warning: {problem}"), observer)?;
        }
        Ok(())
    }

    /// Writes the paths of grains, which are tables so far, as lines.
    fn write_path_lines(&self, folder: &RunFolder) -> Result<(), OutputError> {
        for measure in &self.scenario.measures {
            if let MeasureKind::Paths(_) = measure.kind {
                let lines = folder.path_lines(&measure.name);
                let moment = (self.sim.step, self.sim.time());
                let bytes = path_lines(&folder.path_table(&measure.name), &lines, moment)?;
                folder.write(&lines, &bytes)?;
            }
        }
        Ok(())
    }

    /// Draws the packing, where files are written.
    fn draw(&mut self, path: impl FnOnce(&RunFolder) -> PathBuf, title: &str) -> Result<(), RunError> {
        if self.files.is_none() && self.sim.is_first_process() {
            return Ok(());
        }
        let options = PictureOptions {
            title: title.to_string(),
            ..PictureOptions::default()
        };
        let picture = self.with_frame(|frame| render_packing(frame, &options));
        match &self.files {
            Some(files) => Ok(picture.write_png(&path(&files.folder))?),
            None => Ok(()),
        }
    }

    /// Writes the summary and, after whole runs and faults, the picture and the plots.
    pub(super) fn report(&mut self, end: &RunEnd) -> Result<Summary, RunError> {
        self.sim.took(Phase::Other);
        let mut summary = self.summary(end);
        if self.scenario.output.picture {
            self.draw(RunFolder::picture, &self.scenario.title)?;
        }
        let Some(files) = &self.files else {
            summary.profile = self.sim.profile();
            return Ok(summary);
        };
        let folder = files.folder.clone();
        plots::write(&folder, &self.scenario.output.plots)?;
        self.write_path_lines(&folder)?;
        self.sim.took(Phase::Output);
        summary.profile = self.sim.profile();
        summary.write(&folder)?;
        Ok(summary)
    }

    /// Notes where the time step comes from, when it is no longer the one before.
    pub(super) fn note_time_step(&mut self, before: f64) {
        let (dt, step) = (self.sim.dt, self.sim.step);
        if dt != before {
            self.place.time_step_reason = format!("set in the run: {dt:.3e} s from step {step} on");
        }
    }

    /// What `summary.json` tells, but for the profile. Each process calls this.
    fn summary(&mut self, end: &RunEnd) -> Summary {
        let moment = self.moment();
        // the latest row of the series may be older than the state, and after a restart there may be none
        let now = measure(&mut self.sim, moment, self.scenario.output.strain.as_ref());
        let seconds_here = self.started.elapsed().as_secs_f64();
        let speed = self.particle_steps as f64 / seconds_here.max(1e-9);
        let mut summary = Summary {
            version: crate::VERSION.to_string(),
            title: self.scenario.title.clone(),
            scenario: self.scenario.name.clone(),
            seed: self.scenario.seed,
            finished: *end == RunEnd::Finished,
            stopped_by: match end {
                RunEnd::Finished => "all stages are done".to_string(),
                RunEnd::Interrupted => "interrupted; continue with `demeter resume`".to_string(),
                RunEnd::Fault(fault) => fault.to_string(),
            },
            time_step: self.sim.dt,
            time_step_reason: self.place.time_step_reason.clone(),
            wall_clock_time: self.place.wall_clock,
            particle_steps_per_second: speed,
            threads: rayon::current_num_threads(),
            processes: self.sim.processes(),
            stages: self.place.stages_done.clone(),
            warnings: [
                self.place.warnings.clone(),
                self.left_the_domain().into_iter().collect(),
                self.residual_warning().into_iter().collect(),
            ]
            .concat(),
            lost_rows: self.place.lost_rows.clone(),
            ..Summary::default()
        };
        let names: Vec<String> = self.sim.walls.iter().map(|w| w.name.clone()).collect();
        let max_residual = larger(self.place.max_residual, now.energies.residual.abs());
        summary.set_measures(&now, max_residual, &names, &self.works());
        summary
    }
}
