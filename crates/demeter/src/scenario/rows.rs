//! What a run writes row by row: the series, and a distribution for every measure that asks for one.

use super::measures::{LooksAt, MeasureKind, distributions, networks, profiles, rows_look_at};
use super::traffic::Traffic;
use super::{Scenario, run::labels};
use crate::measure::{
    ContactAngles, ContactNetwork, CylinderProfile, ForceDistribution, Measures, Moment, Paths, Profile, Value,
    WEAR_COLUMNS, box_titles, box_values, measure, wear_values,
};
use crate::output::{
    DistributionWriter, MomentTable, OutputError, ProfileWriter, RunFolder, SeriesTable, SeriesWriter, path_row,
    path_titles, residence_row, residence_titles, ring_row, ring_titles, rose_rows, rose_titles,
};
use crate::simulation::Simulation;

/// All files of rows, open at their ends.
pub(super) struct Rows<'a> {
    scenario: &'a Scenario,
    series: Series,
    networks: Vec<&'a ContactNetwork>,
    distributions: Vec<(&'a ForceDistribution, DistributionWriter)>,
    profiles: Vec<(&'a Profile, ProfileWriter)>,
    tables: Vec<(Told<'a>, MomentTable)>,
}

/// Where the rows of the series go.
enum Series {
    File(SeriesWriter),
    Memory(SeriesTable),
}

/// What is told in a table of its own.
enum Told<'a> {
    /// Residence times of the measure of this number among those.
    Residence(usize),
    Angles(&'a ContactAngles),
    Paths(&'a Paths),
    Rings(&'a CylinderProfile),
}

impl<'a> Rows<'a> {
    /// Starts all files.
    pub fn create(scenario: &'a Scenario, folder: &RunFolder) -> Result<Self, OutputError> {
        let series = SeriesWriter::create(&folder.series(), labels(scenario))?;
        Self::with(
            scenario,
            folder,
            (series, None),
            |name, bins, stages| DistributionWriter::create(&folder.distribution(name), bins, stages),
            |name, stages| ProfileWriter::create(&folder.profile(name), stages),
        )
    }

    /// Without files: the series alone, kept in memory.
    pub fn in_memory(scenario: &'a Scenario) -> Self {
        Self {
            scenario,
            series: Series::Memory(SeriesTable::new(labels(scenario))),
            networks: networks(&scenario.measures).map(|(_, network)| network).collect(),
            distributions: Vec::new(),
            profiles: Vec::new(),
            tables: Vec::new(),
        }
    }

    /// The series so far, where it is kept in memory.
    pub fn series(&self) -> Option<&SeriesTable> {
        match &self.series {
            Series::File(_) => None,
            Series::Memory(table) => Some(table),
        }
    }

    /// Goes on with all files after a step.
    pub fn resume(scenario: &'a Scenario, folder: &RunFolder, step: u64) -> Result<Self, OutputError> {
        let series = SeriesWriter::resume(&folder.series(), labels(scenario), step)?;
        Self::with(
            scenario,
            folder,
            (series, Some(step)),
            |name, bins, stages| DistributionWriter::resume(&folder.distribution(name), bins, stages, step),
            |name, stages| ProfileWriter::resume(&folder.profile(name), stages, step),
        )
    }

    fn with(
        scenario: &'a Scenario,
        folder: &RunFolder,
        (series, after): (SeriesWriter, Option<u64>),
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
            series: Series::File(series),
            networks: networks(&scenario.measures).map(|(_, network)| network).collect(),
            profiles: profiles(measures)
                .map(|(name, profile)| Ok((profile, open_profile(name, stages.clone())?)))
                .collect::<Result<_, OutputError>>()?,
            distributions: opened.collect::<Result<_, OutputError>>()?,
            tables: tables(scenario, folder, after)?,
        })
    }

    /// Measures the present state, where one process has it all.
    pub fn measure(&self, sim: &mut Simulation, traffic: &mut Traffic<'_>, moment: Moment) -> Measures {
        let (mut row, of_box) = self.sums(sim, moment);
        self.complete(&mut row, of_box, sim, traffic);
        row
    }

    /// What all processes know of a row, with the columns of a box that deforms. Each calls this.
    fn sums(&self, sim: &mut Simulation, moment: Moment) -> (Measures, Vec<Value>) {
        let row = measure(sim, moment, self.scenario.output.strain.as_ref());
        let deforms = self.scenario.deforms();
        let of_box = deforms.then(|| box_values(sim, row.energies.boundary_work));
        (row, of_box.unwrap_or_default())
    }

    /// Adds what is told by the process that has all that the measures look at.
    fn complete(&self, row: &mut Measures, of_box: Vec<Value>, sim: &Simulation, traffic: &mut Traffic<'_>) {
        row.networks = self.networks.iter().map(|network| network.measure(sim)).collect();
        row.told = traffic.values(sim);
        row.told.extend(wear_values(sim));
        row.told.extend(of_box);
    }

    /// Measures the present state; the first process adds it to all files. Each calls this.
    pub fn write(
        &mut self,
        sim: &mut Simulation,
        traffic: &mut Traffic<'_>,
        moment: Moment,
    ) -> Result<Measures, OutputError> {
        let (mut row, of_box) = self.sums(sim, moment);
        match rows_look_at(&self.scenario.measures) {
            LooksAt::Sums => {}
            LooksAt::Grains => sim.bring_grains_together(),
            LooksAt::Contacts => sim.bring_together(),
        }
        let written = match sim.is_first_process() {
            true => {
                self.complete(&mut row, of_box, sim, traffic);
                self.add(&row, sim, traffic)
            }
            false => Ok(()),
        };
        sim.go_apart();
        written.map(|()| row)
    }

    /// Adds a row to all files.
    fn add(&mut self, row: &Measures, sim: &Simulation, traffic: &Traffic<'_>) -> Result<(), OutputError> {
        match &mut self.series {
            Series::File(writer) => writer.write(row)?,
            Series::Memory(table) => table.add(row),
        }
        for (bins, writer) in &mut self.distributions {
            writer.write(row, &bins.measure(sim))?;
        }
        for (profile, writer) in &mut self.profiles {
            writer.write(row, &profile.measure(sim, traffic.origins()))?;
        }
        for (told, table) in &mut self.tables {
            match told {
                Told::Residence(index) => table.add(row, [residence_row(&traffic.residence_distribution(*index))])?,
                Told::Angles(angles) => table.add(row, rose_rows(&angles.measure(sim, traffic.origins())))?,
                Told::Rings(profile) => {
                    let rings = profile.measure(sim, traffic.origins());
                    table.add(row, rings.iter().enumerate().map(|(k, ring)| ring_row(k, ring)))?;
                }
                Told::Paths(paths) => {
                    let points = paths.measure(sim, traffic.origins());
                    table.add(row, points.iter().map(path_row))?;
                }
            }
        }
        Ok(())
    }
}

/// Opens the tables of measures that have one of their own, after a step when it is told.
fn tables<'a>(
    scenario: &'a Scenario,
    folder: &RunFolder,
    after: Option<u64>,
) -> Result<Vec<(Told<'a>, MomentTable)>, OutputError> {
    let mut tables = Vec::new();
    let mut residences = 0;
    let stages = labels(scenario).stages;
    for measure in &scenario.measures {
        let name = &measure.name;
        let (told, path, titles) = match &measure.kind {
            MeasureKind::Residence(residence) => {
                residences += 1;
                let Some((width, bins)) = residence.bins else { continue };
                folder.make_distributions()?;
                let titles = residence_titles(width, bins);
                (Told::Residence(residences - 1), folder.distribution(name), titles)
            }
            MeasureKind::ContactAngles(angles) => {
                folder.make_distributions()?;
                (
                    Told::Angles(angles),
                    folder.distribution(name),
                    rose_titles(&angles.edges()),
                )
            }
            MeasureKind::CylinderProfile(profile) => {
                folder.make_profiles()?;
                (Told::Rings(profile), folder.profile(name), ring_titles())
            }
            MeasureKind::Paths(paths) => {
                folder.make_paths()?;
                (Told::Paths(paths), folder.path_table(name), path_titles())
            }
            _ => continue,
        };
        tables.push((told, MomentTable::open(&path, &titles, stages.clone(), after)?));
    }
    Ok(tables)
}

/// Titles of the columns behind all others.
pub(super) fn told_titles(scenario: &Scenario) -> Vec<String> {
    let mut titles = Traffic::titles(scenario);
    titles.extend(wear_titles(scenario));
    if scenario.deforms() {
        titles.extend(box_titles());
    }
    titles
}

/// Titles of the columns of walls that record their wear.
fn wear_titles(scenario: &Scenario) -> impl Iterator<Item = String> {
    let worn = scenario.walls.iter().filter(|wall| wall.recording.wear.is_some());
    worn.flat_map(|wall| {
        let name = format!("wall {}", wall.name);
        WEAR_COLUMNS.iter().map(move |column| column.title(&name))
    })
}
