//! What a run writes row by row: the series, and a distribution for every measure that asks for one.

use super::measures::{distributions, networks};
use super::traffic::Traffic;
use super::{Scenario, run::labels};
use crate::measure::{ContactNetwork, ForceDistribution, Measures, Moment, measure};
use crate::output::{DistributionWriter, OutputError, RunFolder, SeriesWriter};
use crate::simulation::Simulation;

/// All files of rows, open at their ends.
pub(super) struct Rows<'a> {
    scenario: &'a Scenario,
    series: SeriesWriter,
    networks: Vec<&'a ContactNetwork>,
    distributions: Vec<(&'a ForceDistribution, DistributionWriter)>,
}

impl<'a> Rows<'a> {
    /// Starts all files.
    pub fn create(scenario: &'a Scenario, folder: &RunFolder) -> Result<Self, OutputError> {
        let series = SeriesWriter::create(&folder.series(), labels(scenario))?;
        Self::with(scenario, folder, series, |name, bins, stages| {
            DistributionWriter::create(&folder.distribution(name), bins, stages)
        })
    }

    /// Goes on with all files after a step.
    pub fn resume(scenario: &'a Scenario, folder: &RunFolder, step: u64) -> Result<Self, OutputError> {
        let series = SeriesWriter::resume(&folder.series(), labels(scenario), step)?;
        Self::with(scenario, folder, series, |name, bins, stages| {
            DistributionWriter::resume(&folder.distribution(name), bins, stages, step)
        })
    }

    fn with(
        scenario: &'a Scenario,
        folder: &RunFolder,
        series: SeriesWriter,
        open: impl Fn(&str, &ForceDistribution, Vec<String>) -> Result<DistributionWriter, OutputError>,
    ) -> Result<Self, OutputError> {
        if distributions(&scenario.measures).next().is_some() {
            folder.make_distributions()?;
        }
        let stages = labels(scenario).stages;
        let opened =
            distributions(&scenario.measures).map(|(name, bins)| Ok((bins, open(name, bins, stages.clone())?)));
        Ok(Self {
            scenario,
            series,
            networks: networks(&scenario.measures).map(|(_, network)| network).collect(),
            distributions: opened.collect::<Result<_, OutputError>>()?,
        })
    }

    /// Measures the present state and adds it to all files.
    pub fn write(
        &mut self,
        sim: &mut Simulation,
        traffic: &mut Traffic<'_>,
        moment: Moment,
    ) -> Result<Measures, OutputError> {
        let mut row = measure(sim, moment, self.scenario.output.strain.as_ref());
        row.networks = self.networks.iter().map(|network| network.measure(sim)).collect();
        row.told = traffic.values(sim);
        self.series.write(&row)?;
        for (bins, writer) in &mut self.distributions {
            writer.write(&row, &bins.measure(sim))?;
        }
        Ok(row)
    }
}
