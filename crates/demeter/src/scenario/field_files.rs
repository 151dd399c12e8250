//! The files of fields and force chains, written with every frame.

use super::measures::MeasureKind;
use super::traffic::Traffic;
use super::{Scenario, run::labels};
use crate::measure::{ForceChains, Moment};
use crate::output::{ChainWriter, FieldWriter, OutputError, RunFolder, tell_chains};
use crate::simulation::Simulation;

/// A writer for every field and all force chains of a scenario, in its order.
pub(super) struct FieldFiles<'a> {
    fields: Vec<FieldWriter>,
    chains: Vec<(&'a ForceChains, ChainWriter)>,
}

impl<'a> FieldFiles<'a> {
    /// Starts all files, or goes on with them after a step.
    pub fn open(scenario: &'a Scenario, folder: &RunFolder, after: Option<u64>) -> Result<Self, OutputError> {
        let (mut fields, mut chains) = (Vec::new(), Vec::new());
        for measure in &scenario.measures {
            let name = measure.name.as_str();
            match &measure.kind {
                MeasureKind::Field(field) => {
                    folder.make_fields()?;
                    let is_row = field.cells.iter().filter(|n| **n > 1).count() <= 1;
                    let stages = labels(scenario).stages;
                    fields.push(FieldWriter::open(folder, name, is_row, stages, after)?);
                }
                MeasureKind::ForceChains(of) => {
                    folder.make_chains()?;
                    chains.push((of, ChainWriter::open(folder, name, after)?));
                }
                _ => {}
            }
        }
        Ok(Self { fields, chains })
    }

    /// Writes all fields and chains of a moment; means begin anew.
    pub fn write(&mut self, sim: &Simulation, traffic: &mut Traffic<'_>, moment: Moment) -> Result<(), OutputError> {
        let at = (sim.step, sim.time());
        for (k, writer) in self.fields.iter_mut().enumerate() {
            if let Some(fields) = traffic.take_field(k, sim) {
                writer.write(at, moment, &fields)?;
            }
        }
        for (of, writer) in &mut self.chains {
            writer.write(at, &of.measure(sim, traffic.origins()))?;
        }
        Ok(())
    }
}

/// Tells the first process what this one has of all fields and chains, as it writes them.
pub(super) fn tell(scenario: &Scenario, sim: &Simulation, traffic: &mut Traffic<'_>) {
    let fields = scenario
        .measures
        .iter()
        .filter(|m| matches!(m.kind, MeasureKind::Field(_)));
    for k in 0..fields.count() {
        traffic.take_field(k, sim);
    }
    for measure in &scenario.measures {
        if let MeasureKind::ForceChains(of) = &measure.kind {
            tell_chains(&of.measure(sim, traffic.origins()));
        }
    }
}
