//! What a run writes while it goes on: rows, frames, checkpoints.

use super::{Files, RunState, Runner, labels};
use crate::checkpoint::{self, Header};
use crate::measure::{Moment, contact_records, wall_surfaces};
use crate::output::{Frame, FrameBox, SeriesTable};
use crate::scenario::run_error::RunError;
use crate::simulation::{Phase, Simulation};
use crate::walls::Wall;
use std::path::Path;

impl<'a> Runner<'a> {
    pub(super) fn write_row(&mut self) -> Result<(), RunError> {
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

    /// What a row of the series would tell now, as a series of one row.
    pub(in crate::scenario) fn present(&mut self) -> SeriesTable {
        let moment = self.moment();
        let row = self.rows.measure(&mut self.sim, &mut self.traffic, moment);
        let mut table = SeriesTable::new(labels(self.scenario));
        table.add(&row);
        table
    }

    pub(super) fn moment(&self) -> Moment {
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
        self.at_first(|runner| {
            let Some(mut files) = runner.files.take() else {
                return Ok(());
            };
            let written = runner.write_files(&mut files);
            runner.files = Some(files);
            written
        })?;
        self.sim.walls.iter_mut().for_each(Wall::begin_interval);
        self.place.last_frame = Some(self.sim.step);
        self.sim.took(Phase::Output);
        Ok(())
    }

    fn write_files(&mut self, files: &mut Files<'a>) -> Result<(), RunError> {
        self.with_frame(|frame| files.frames.write(frame))?;
        let moment = self.moment();
        Ok(files.fields.write(&self.sim, &mut self.traffic, moment)?)
    }

    /// Hands the present state to a writer.
    pub(in crate::scenario) fn with_frame<T>(&self, work: impl FnOnce(&Frame) -> T) -> T {
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
            cell: self.scenario.domain.bounds.map(|_| frame_box(&self.sim)),
        };
        work(&frame)
    }

    pub(super) fn write_checkpoint(&mut self) -> Result<(), RunError> {
        self.at_first(|runner| {
            let root = runner.files.as_ref().map(|files| files.folder.root().to_owned());
            root.map_or(Ok(()), |root| runner.save_checkpoint(&root))
        })
    }

    /// The first process works with all grains and contacts. Each calls this.
    pub(in crate::scenario) fn at_first(
        &mut self,
        work: impl FnOnce(&mut Self) -> Result<(), RunError>,
    ) -> Result<(), RunError> {
        self.sim.bring_together();
        let done = match self.sim.is_first_process() {
            true => work(self),
            false => Ok(()),
        };
        self.sim.go_apart();
        done
    }

    /// Writes a checkpoint into a folder.
    pub(in crate::scenario) fn save_checkpoint(&mut self, root: &Path) -> Result<(), RunError> {
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
        checkpoint::write_latest(root, &header, &state)?;
        self.sim.took(Phase::Output);
        Ok(())
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
