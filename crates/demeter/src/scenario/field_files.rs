//! The files of fields and force chains, written with every frame.

use super::measures::MeasureKind;
use super::traffic::Traffic;
use super::{Scenario, run::labels};
use crate::measure::{Field, ForceChains, Moment};
use crate::output::{ChainWriter, FieldWriter, OutputError, RowFile, RunFolder, tell_chains};
use crate::simulation::Simulation;
use std::path::PathBuf;

/// A writer for every field and all force chains of a scenario, in its order.
pub(super) struct FieldFiles<'a> {
    fields: Vec<FieldWriter>,
    chains: Vec<(&'a ForceChains, ChainWriter)>,
}

impl<'a> FieldFiles<'a> {
    /// All files that every frame changes.
    pub fn files(scenario: &Scenario, folder: &RunFolder) -> Vec<PathBuf> {
        let mut files = Vec::new();
        for measure in &scenario.measures {
            let name = measure.name.as_str();
            match &measure.kind {
                MeasureKind::Field(field) => {
                    files.push(folder.field_collection(name));
                    files.extend(is_row(field).then(|| folder.field_table(name)));
                }
                MeasureKind::ForceChains(_) => files.push(folder.chain_collection(name)),
                _ => {}
            }
        }
        files
    }

    /// Starts all files, or goes on with them after a step; tells what is gone, as warnings.
    pub fn open(
        scenario: &'a Scenario,
        folder: &RunFolder,
        after: Option<u64>,
    ) -> Result<(Self, Vec<String>), OutputError> {
        let (mut fields, mut chains, mut warnings) = (Vec::new(), Vec::new(), Vec::new());
        for measure in &scenario.measures {
            let name = measure.name.as_str();
            match &measure.kind {
                MeasureKind::Field(field) => {
                    folder.make_fields()?;
                    let stages = labels(scenario).stages;
                    let (writer, told) = FieldWriter::open(folder, name, is_row(field), stages, after)?;
                    fields.push(writer);
                    warnings.extend(told);
                }
                MeasureKind::ForceChains(of) => {
                    folder.make_chains()?;
                    let (writer, told) = ChainWriter::open(folder, name, after)?;
                    chains.push((of, writer));
                    warnings.extend(told);
                }
                _ => {}
            }
        }
        Ok((Self { fields, chains }, warnings))
    }

    /// The tables of fields that are open.
    pub fn tables(&self) -> impl Iterator<Item = &RowFile> {
        self.fields.iter().filter_map(FieldWriter::rows)
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

/// Whether the grid of a field is a row of cells, which has a table.
fn is_row(field: &Field) -> bool {
    field.cells.iter().filter(|n| **n > 1).count() <= 1
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
