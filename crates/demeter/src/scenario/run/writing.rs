//! What a run writes while it goes on: rows, frames, checkpoints.

use super::{Files, RunState, Runner, labels, of_frames};
use crate::checkpoint::{self, Header};
use crate::measure::{ContactsAt, Moment, wall_surfaces};
use crate::output::{Frame, FrameBox, FramePart, OutputError, RowFile, SeriesTable, WrittenFiles, tell_frame};
use crate::scenario::rows::Rows;
use crate::scenario::run_error::RunError;
use crate::scenario::{Scenario, column_stops, field_files};
use crate::simulation::{Energies, Phase, Simulation, SimulationState, StopCondition};
use crate::walls::Wall;
use std::path::{Path, PathBuf};

impl<'a> Runner<'a> {
    pub(super) fn write_row(&mut self) -> Result<(), RunError> {
        if self.place.last_row == Some(self.sim.step) {
            return Ok(());
        }
        self.sim.took(Phase::Other);
        let moment = self.moment();
        let row = self.rows.write(&mut self.sim, &mut self.traffic, moment)?;
        let stage = self.stage();
        let has_columns = stage.stop.iter().any(|stop| matches!(stop, StopCondition::Column(_)));
        if has_columns && self.sim.step > self.place.stage_step {
            let labels = labels(self.scenario);
            column_stops::look(stage, (&row, &labels), &self.sim, &mut self.place.columns_held);
        }
        self.place.max_residual = larger(self.place.max_residual, row.energies.residual.abs());
        self.place.last_row = Some(self.sim.step);
        self.latest = Some(row);
        self.sim.took(Phase::Output);
        Ok(())
    }

    /// The energies and their ledger at this moment.
    pub(in crate::scenario) fn energies(&mut self) -> Energies {
        self.without_a_trace(|runner| runner.sim.energies())
    }

    /// What a row of the series would tell now, as a series of one row.
    pub(in crate::scenario) fn present(&mut self) -> SeriesTable {
        let moment = self.moment();
        let row = self.without_a_trace(|runner| runner.rows.measure(&mut runner.sim, &mut runner.traffic, moment));
        let mut table = SeriesTable::new(labels(self.scenario));
        table.add(&row);
        table
    }

    /// Looks as a row of the series does; those that are written tell the same as without.
    fn without_a_trace<T>(&mut self, look: impl FnOnce(&mut Self) -> T) -> T {
        let remembered = (self.sim.books, self.traffic.remembered(&mut self.sim));
        let seen = look(self);
        self.sim.books = remembered.0;
        self.traffic.remember(remembered.1);
        seen
    }

    pub(in crate::scenario) fn moment(&self) -> Moment {
        Moment {
            stage: self.place.stage,
            stage_time: (self.sim.step - self.place.stage_step) as f64 * self.sim.dt,
        }
    }

    pub(super) fn write_frame(&mut self) -> Result<(), RunError> {
        if self.place.last_frame == Some(self.sim.step) {
            return Ok(());
        }
        if self.files.is_none() && self.sim.is_first_process() {
            return Ok(());
        }
        self.sim.took(Phase::Other);
        let mut files = self.files.take();
        let written = self.write_files(files.as_mut());
        self.files = files;
        written?;
        self.sim.walls.iter_mut().for_each(Wall::begin_interval);
        self.place.last_frame = Some(self.sim.step);
        self.sim.took(Phase::Output);
        Ok(())
    }

    /// Writes the files of a frame, or tells the first process what this one has of them.
    fn write_files(&mut self, mut files: Option<&mut Files<'a>>) -> Result<(), RunError> {
        self.with_frame(|frame| match &mut files {
            Some(files) => files.frames.write(frame),
            None => {
                tell_frame(frame);
                Ok(())
            }
        })?;
        let moment = self.moment();
        match files {
            Some(files) => files.fields.write(&self.sim, &mut self.traffic, moment)?,
            None => field_files::tell(self.scenario, &self.sim, &mut self.traffic),
        }
        Ok(())
    }

    /// Hands what this process has of the present state to a writer. Where processes share the run each calls this.
    pub(in crate::scenario) fn with_frame<T>(&mut self, work: impl FnOnce(&Frame) -> T) -> T {
        self.sim.hear_corrected_places();
        let walls = wall_surfaces(&self.sim);
        let own = self.sim.own_grains();
        let frame = Frame {
            step: self.sim.step,
            time: self.sim.time(),
            grains: &self.sim.grains,
            materials: self.sim.materials.list(),
            contacts: ContactsAt::State(&self.sim),
            walls: &walls,
            tags: self.traffic.tags(&self.sim.grains.id[own.clone()]),
            cell: self.scenario.domain.bounds.map(|_| frame_box(&self.sim)),
            part: FramePart {
                together: self.sim.together(),
                grains: own,
            },
        };
        work(&frame)
    }

    pub(super) fn write_checkpoint(&mut self) -> Result<(), RunError> {
        self.checkpoint_step = self.sim.step;
        match self.files.as_ref().map(|files| files.folder.root().to_owned()) {
            Some(root) => self.save_checkpoint(&root),
            None if self.sim.is_first_process() => Ok(()),
            None => {
                self.traffic.hear_impacts(&mut self.sim);
                checkpoint::pass(&self.sim.state());
                Ok(())
            }
        }
    }

    /// The state of the run, told that of the simulation.
    pub(super) fn state_with<'s>(&self, simulation: SimulationState<'s>) -> RunState<'s> {
        let mut place = self.place.clone();
        place.wall_clock += self.started.elapsed().as_secs_f64();
        RunState {
            simulation,
            place,
            domain: *self.sim.domain(),
            traffic: self.traffic.state(),
        }
    }

    /// Writes a checkpoint into a folder.
    pub(in crate::scenario) fn save_checkpoint(&mut self, root: &Path) -> Result<(), RunError> {
        self.sim.took(Phase::Other);
        self.traffic.hear_impacts(&mut self.sim);
        let simulation = self.sim.state();
        let header = Header {
            engine_version: crate::VERSION.to_string(),
            title: self.scenario.title.clone(),
            step: self.sim.step,
            time: self.sim.time(),
            grains: self.sim.grains.len() as u64,
            contacts: simulation.contact_count() as u64,
        };
        let mut state = self.state_with(simulation);
        match self.files.as_ref().filter(|files| files.folder.root() == root) {
            Some(files) => {
                state.place.written = files.written(self.scenario, &self.rows);
                let collections = of_frames(self.scenario, &files.folder);
                let rows = files.rows(&self.rows).map(RowFile::path);
                let open = rows.chain(collections.iter().map(PathBuf::as_path));
                files.folder.force_to_disk(open)?;
            }
            None => {
                // the rows and frames so far stay where they are
                state.place.last_row = None;
                state.place.last_frame = None;
                state.place.written = WrittenFiles::default();
            }
        }
        checkpoint::write_latest(root, &header, &state)?;
        self.sim.took(Phase::Output);
        Ok(())
    }
}

impl Runner<'_> {
    /// Refuses to end as if all were whole where something else changed a file of rows.
    pub(super) fn check_rows(&self) -> Result<(), OutputError> {
        let Some(files) = &self.files else { return Ok(()) };
        match files.rows(&self.rows).find_map(|file| Some((file, file.is_changed()?))) {
            None => Ok(()),
            Some((file, problem)) => Err(OutputError::RowsLost {
                path: file.path().to_owned(),
                problem,
            }),
        }
    }
}

impl Files<'_> {
    /// All that was written so far, with the rows.
    fn written(&self, scenario: &Scenario, rows: &Rows<'_>) -> WrittenFiles {
        WrittenFiles::of(&self.folder, self.rows(rows), &of_frames(scenario, &self.folder))
    }

    /// All files of rows, open at their ends.
    fn rows<'f>(&'f self, rows: &'f Rows<'_>) -> impl Iterator<Item = &'f RowFile> {
        rows.open_files().map(|(file, _)| file).chain(self.fields.tables())
    }
}

/// The larger of two residuals; one that is no number is larger than all.
pub(in crate::scenario) fn larger(one: f64, other: f64) -> f64 {
    if one.is_nan() || other.is_nan() {
        f64::NAN
    } else {
        one.max(other)
    }
}

/// The domain as it is now.
fn frame_box(simulation: &Simulation) -> FrameBox {
    let domain = simulation.domain();
    FrameBox {
        corner: domain.lower,
        edges: simulation.box_edges(),
        periodic: domain.periodic,
    }
}
