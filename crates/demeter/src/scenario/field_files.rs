//! The files of fields, written with every frame.

use super::measures::MeasureKind;
use super::traffic::Traffic;
use super::{Scenario, run::labels};
use crate::measure::Moment;
use crate::output::{FieldWriter, OutputError, RunFolder};
use crate::simulation::Simulation;

/// A writer for every field of a scenario, in its order.
pub(super) struct FieldFiles {
    writers: Vec<FieldWriter>,
}

impl FieldFiles {
    /// Starts all files, or goes on with them after a step.
    pub fn open(scenario: &Scenario, folder: &RunFolder, after: Option<u64>) -> Result<Self, OutputError> {
        let fields = scenario.measures.iter().filter_map(|measure| match &measure.kind {
            MeasureKind::Field(field) => Some((measure.name.as_str(), field)),
            _ => None,
        });
        let mut writers = Vec::new();
        for (name, field) in fields {
            folder.make_fields()?;
            let is_row = field.cells.iter().filter(|n| **n > 1).count() <= 1;
            let stages = labels(scenario).stages;
            writers.push(match after {
                None => FieldWriter::create(folder, name, is_row, stages)?,
                Some(step) => FieldWriter::resume(folder, name, is_row, stages, step)?,
            });
        }
        Ok(Self { writers })
    }

    /// Writes all fields of a moment; means begin anew.
    pub fn write(&mut self, sim: &Simulation, traffic: &mut Traffic<'_>, moment: Moment) -> Result<(), OutputError> {
        for (k, writer) in self.writers.iter_mut().enumerate() {
            if let Some(fields) = traffic.take_field(k, sim) {
                writer.write((sim.step, sim.time()), moment, &fields)?;
            }
        }
        Ok(())
    }
}
