//! What a run writes row by row: the series, and a distribution for every measure that asks for one.

use super::measures::{distributions, networks, profiles};
use super::traffic::Traffic;
use super::{Scenario, run::labels};
use crate::measure::{ContactNetwork, ForceDistribution, Measures, Moment, Profile, box_values, measure, wear_values};
use crate::output::{DistributionWriter, OutputError, ProfileWriter, RunFolder, SeriesWriter};
use crate::simulation::Simulation;

/// All files of rows, open at their ends.
pub(super) struct Rows<'a> {
    scenario: &'a Scenario,
    series: SeriesWriter,
    networks: Vec<&'a ContactNetwork>,
    distributions: Vec<(&'a ForceDistribution, DistributionWriter)>,
    profiles: Vec<(&'a Profile, ProfileWriter)>,
}

impl<'a> Rows<'a> {
    /// Starts all files.
    pub fn create(scenario: &'a Scenario, folder: &RunFolder) -> Result<Self, OutputError> {
        let series = SeriesWriter::create(&folder.series(), labels(scenario))?;
        Self::with(
            scenario,
            folder,
            series,
            |name, bins, stages| DistributionWriter::create(&folder.distribution(name), bins, stages),
            |name, stages| ProfileWriter::create(&folder.profile(name), stages),
        )
    }

    /// Goes on with all files after a step.
    pub fn resume(scenario: &'a Scenario, folder: &RunFolder, step: u64) -> Result<Self, OutputError> {
        let series = SeriesWriter::resume(&folder.series(), labels(scenario), step)?;
        Self::with(
            scenario,
            folder,
            series,
            |name, bins, stages| DistributionWriter::resume(&folder.distribution(name), bins, stages, step),
            |name, stages| ProfileWriter::resume(&folder.profile(name), stages, step),
        )
    }

    fn with(
        scenario: &'a Scenario,
        folder: &RunFolder,
        series: SeriesWriter,
        open: impl Fn(&str, &ForceDistribution, Vec<String>) -> Result<DistributionWriter, OutputError>,
        open_profile: impl Fn(&str, Vec<String>) -> Result<ProfileWriter, OutputError>,
    ) -> Result<Self, OutputError> {
        let measures = &scenario.measures;
        if distributions(measures).next().is_some() {
            folder.make_distributions()?;
        }
        if profiles(measures).next().is_some() {
            folder.make_profiles()?;
        }
        let stages = labels(scenario).stages;
        let opened =
            distributions(&scenario.measures).map(|(name, bins)| Ok((bins, open(name, bins, stages.clone())?)));
        Ok(Self {
            scenario,
            series,
            networks: networks(&scenario.measures).map(|(_, network)| network).collect(),
            profiles: profiles(measures)
                .map(|(name, profile)| Ok((profile, open_profile(name, stages.clone())?)))
                .collect::<Result<_, OutputError>>()?,
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
        row.told.extend(wear_values(sim));
        if self.scenario.deforms() {
            row.told.extend(box_values(sim, row.energies.boundary_work));
        }
        self.series.write(&row)?;
        for (bins, writer) in &mut self.distributions {
            writer.write(&row, &bins.measure(sim))?;
        }
        for (profile, writer) in &mut self.profiles {
            writer.write(&row, &profile.measure(sim, traffic.origins()))?;
        }
        Ok(row)
    }
}
