//! What a run writes row by row: the series, and a distribution for every measure that asks for one.

use super::checks::told_motions;
use super::measures::{MeasureKind, distributions, networks, profiles};
use super::traffic::Traffic;
use super::{Scenario, run::labels};
use crate::measure::{
    ContactAngles, ContactNetwork, CylinderProfile, EnergyBins, ForceDistribution, Measures, Moment, Paths, Profile,
    ToldColumn, WALL_MOTION_COLUMNS, WEAR_COLUMNS, box_titles, box_values, measure, wall_motion_values, wear_values,
};
use crate::output::{
    DistributionWriter, GoneGrain, MomentTable, OutputError, ProfileWriter, RowFile, RunFolder, SeriesTable,
    SeriesWriter, collision_rows, collision_titles, gone_row, gone_titles, path_row, path_titles, residence_row,
    residence_titles, ring_row, ring_titles, rose_rows, rose_titles,
};
use crate::simulation::Simulation;
use std::collections::BTreeSet;
use std::path::PathBuf;

/// All files of rows, open at their ends. Without files what they tell is measured, too, where another process writes it.
pub(super) struct Rows<'a> {
    scenario: &'a Scenario,
    series: Series,
    networks: Vec<&'a ContactNetwork>,
    distributions: Vec<(&'a ForceDistribution, Option<DistributionWriter>)>,
    profiles: Vec<(&'a Profile, Option<ProfileWriter>)>,
    tables: Vec<(Told<'a>, Option<MomentTable>)>,
}

/// Where the rows of the series go.
enum Series {
    File(SeriesWriter),
    Memory(SeriesTable),
}

/// What is told in a table of its own.
enum Told<'a> {
    /// Residence times of the measure of this number among those, in bins of this width [s] and so many.
    Residence(usize, (f64, u32)),
    /// Collisions of the measure of this number among those, by their energies.
    Collisions(usize, &'a EnergyBins),
    Angles(&'a ContactAngles),
    Paths(&'a Paths),
    Rings(&'a CylinderProfile),
    /// What the removal of this number took.
    Gone(usize, &'a Scenario),
}

impl Told<'_> {
    /// The table of a measure.
    fn file(&self, measure: &str, folder: &RunFolder) -> PathBuf {
        match self {
            Self::Residence(..) | Self::Collisions(..) | Self::Angles(_) => folder.distribution(measure),
            Self::Rings(_) => folder.profile(measure),
            Self::Paths(_) => folder.path_table(measure),
            Self::Gone(..) => folder.removal(measure),
        }
    }

    fn rows(&self, sim: &Simulation, traffic: &Traffic<'_>) -> Vec<Vec<String>> {
        let origins = traffic.origins();
        match self {
            Self::Residence(index, _) => vec![residence_row(&traffic.residence_distribution(*index))],
            Self::Collisions(index, _) => collision_rows(&traffic.collision_distribution(*index)).to_vec(),
            Self::Angles(angles) => rose_rows(&angles.measure(sim, origins)).to_vec(),
            Self::Rings(profile) => {
                let rings = profile.measure(sim, origins);
                rings.iter().enumerate().map(|(k, ring)| ring_row(k, ring)).collect()
            }
            Self::Paths(paths) => paths.measure(sim, origins).iter().map(path_row).collect(),
            Self::Gone(removal, scenario) => {
                let batches = scenario.grains.iter().map(|batch| batch.name.as_str());
                let sources: Vec<&str> = batches
                    .chain(scenario.feeds.iter().map(|feed| feed.name.as_str()))
                    .collect();
                let row = |grain: &GoneGrain| {
                    let material = scenario.materials.get(usize::from(grain.material));
                    let source = grain.source.and_then(|source| sources.get(usize::from(source)));
                    gone_row(
                        grain,
                        material.map_or("", |material| &material.name),
                        source.unwrap_or(&""),
                    )
                };
                traffic.listed(*removal).iter().map(row).collect()
            }
        }
    }
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
        let measures = &scenario.measures;
        Self {
            scenario,
            series: Series::Memory(SeriesTable::new(labels(scenario))),
            networks: networks(measures).map(|(_, network)| network).collect(),
            distributions: distributions(measures).map(|(_, bins)| (bins, None)).collect(),
            profiles: profiles(measures).map(|(_, profile)| (profile, None)).collect(),
            tables: told_in_tables(scenario).map(|(_, told)| (told, None)).collect(),
        }
    }

    /// The series so far, where it is kept in memory.
    pub fn series(&self) -> Option<&SeriesTable> {
        match &self.series {
            Series::File(_) => None,
            Series::Memory(table) => Some(table),
        }
    }

    /// All files that a row is written into.
    pub fn files(scenario: &Scenario, folder: &RunFolder) -> Vec<PathBuf> {
        let measures = &scenario.measures;
        let bins = distributions(measures).map(|(name, _)| folder.distribution(name));
        let slices = profiles(measures).map(|(name, _)| folder.profile(name));
        let tables = told_in_tables(scenario).map(|(name, told)| told.file(name, folder));
        std::iter::once(folder.series())
            .chain(bins)
            .chain(slices)
            .chain(tables)
            .collect()
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

    /// All files that are open, and whether every moment has rows there.
    pub fn open_files(&self) -> impl Iterator<Item = (&RowFile, bool)> {
        let series = match &self.series {
            Series::File(writer) => Some(writer.rows()),
            Series::Memory(_) => None,
        };
        let bins = self
            .distributions
            .iter()
            .filter_map(|(_, file)| Some(file.as_ref()?.rows()));
        let slices = self.profiles.iter().filter_map(|(_, file)| Some(file.as_ref()?.rows()));
        let of_all = series.into_iter().chain(bins).chain(slices).map(|file| (file, true));
        // these tell nothing where no grain is there, or none went
        let tables = self.tables.iter().filter_map(|(told, file)| {
            let every_moment = !matches!(told, Told::Paths(_) | Told::Gone(..));
            Some((file.as_ref()?.rows(), every_moment))
        });
        of_all.chain(tables)
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
            distributions(&scenario.measures).map(|(name, bins)| Ok((bins, Some(open(name, bins, stages.clone())?))));
        Ok(Self {
            scenario,
            series: Series::File(series),
            networks: networks(&scenario.measures).map(|(_, network)| network).collect(),
            profiles: profiles(measures)
                .map(|(name, profile)| Ok((profile, Some(open_profile(name, stages.clone())?))))
                .collect::<Result<_, OutputError>>()?,
            distributions: opened.collect::<Result<_, OutputError>>()?,
            tables: tables(scenario, folder, after)?,
        })
    }

    /// Measures the present state. Each process calls this; the first is told what they know together.
    pub fn measure(&self, sim: &mut Simulation, traffic: &mut Traffic<'_>, moment: Moment) -> Measures {
        let mut row = measure(sim, moment, self.scenario.output.strain.as_ref());
        sim.hear_corrected_places();
        row.networks = self.networks.iter().map(|network| network.measure(sim)).collect();
        row.told = traffic.values(sim);
        row.told.extend(wear_values(sim));
        row.told.extend(wall_motion_values(
            followed_walls(self.scenario).into_iter().map(|wall| &sim.walls[wall]),
        ));
        if self.scenario.deforms() {
            row.told.extend(box_values(sim, row.energies.boundary_work));
        }
        row
    }

    /// Measures the present state; the first process adds it to all files. Each calls this.
    pub fn write(
        &mut self,
        sim: &mut Simulation,
        traffic: &mut Traffic<'_>,
        moment: Moment,
    ) -> Result<Measures, OutputError> {
        let row = self.measure(sim, traffic, moment);
        self.add(&row, sim, traffic)?;
        traffic.begin_lists();
        Ok(row)
    }

    /// Adds a row to all files.
    fn add(&mut self, row: &Measures, sim: &Simulation, traffic: &Traffic<'_>) -> Result<(), OutputError> {
        if sim.is_first_process() {
            match &mut self.series {
                Series::File(writer) => writer.write(row)?,
                Series::Memory(table) => table.add(row),
            }
        }
        let origins = traffic.origins();
        for (bins, writer) in &mut self.distributions {
            tell(
                sim,
                writer,
                || bins.measure(sim),
                |writer, told| writer.write(row, &told),
            )?;
        }
        for (profile, writer) in &mut self.profiles {
            let measure = || profile.measure(sim, origins);
            tell(sim, writer, measure, |writer, told| writer.write(row, &told))?;
        }
        for (told, table) in &mut self.tables {
            let measure = || told.rows(sim, traffic);
            tell(sim, table, measure, |table, rows| table.add(row, rows))?;
        }
        Ok(())
    }
}

/// Measures what is written into a file, or what another process is told that has it.
fn tell<F, T>(
    sim: &Simulation,
    file: &mut Option<F>,
    measure: impl FnOnce() -> T,
    write: impl FnOnce(&mut F, T) -> Result<(), OutputError>,
) -> Result<(), OutputError> {
    match file {
        Some(file) => write(file, measure()),
        None if sim.is_divided() => {
            measure();
            Ok(())
        }
        None => Ok(()),
    }
}

/// Measures and removals that have a table of their own, with their names.
fn told_in_tables(scenario: &Scenario) -> impl Iterator<Item = (&str, Told<'_>)> {
    let (mut residences, mut collisions) = (0, 0);
    let removals = scenario.removals.iter().enumerate().filter(|(_, removal)| removal.list);
    let removals = removals.map(|(k, removal)| (removal.name.as_str(), Told::Gone(k, scenario)));
    let measures = scenario.measures.iter().filter_map(move |measure| {
        let told = match &measure.kind {
            MeasureKind::Residence(residence) => {
                residences += 1;
                Told::Residence(residences - 1, residence.bins?)
            }
            MeasureKind::Collisions(counted) => {
                collisions += 1;
                Told::Collisions(collisions - 1, counted.bins.as_ref()?)
            }
            MeasureKind::ContactAngles(angles) => Told::Angles(angles),
            MeasureKind::CylinderProfile(profile) => Told::Rings(profile),
            MeasureKind::Paths(paths) => Told::Paths(paths),
            _ => return None,
        };
        Some((measure.name.as_str(), told))
    });
    measures.chain(removals)
}

/// Opens these tables, after a step when it is told.
fn tables<'a>(
    scenario: &'a Scenario,
    folder: &RunFolder,
    after: Option<u64>,
) -> Result<Vec<(Told<'a>, Option<MomentTable>)>, OutputError> {
    let stages = labels(scenario).stages;
    let open = |(name, told): (&str, Told<'a>)| {
        let titles = match &told {
            Told::Residence(_, (width, bins)) => {
                folder.make_distributions()?;
                residence_titles(*width, *bins)
            }
            Told::Collisions(_, bins) => {
                folder.make_distributions()?;
                collision_titles(bins)
            }
            Told::Angles(angles) => {
                folder.make_distributions()?;
                rose_titles(&angles.edges())
            }
            Told::Rings(_) => {
                folder.make_profiles()?;
                ring_titles()
            }
            Told::Paths(_) => {
                folder.make_paths()?;
                path_titles()
            }
            Told::Gone(..) => {
                folder.make_removals()?;
                gone_titles()
            }
        };
        let table = MomentTable::open(&told.file(name, folder), &titles, stages.clone(), after)?;
        Ok((told, Some(table)))
    };
    told_in_tables(scenario).map(open).collect()
}

/// Titles of the columns behind all others.
pub(super) fn told_titles(scenario: &Scenario) -> Vec<String> {
    let mut titles = Traffic::titles(scenario);
    titles.extend(wear_titles(scenario));
    titles.extend(wall_motion_titles(scenario));
    if scenario.deforms() {
        titles.extend(box_titles());
    }
    titles
}

/// Titles of the columns of walls that record their wear.
fn wear_titles(scenario: &Scenario) -> impl Iterator<Item = String> {
    let worn = scenario.walls.iter().filter(|wall| wall.recording.wear.is_some());
    worn.flat_map(|wall| wall_titles(&wall.name, WEAR_COLUMNS))
}

/// Titles of the columns of walls that move freely or turn.
fn wall_motion_titles(scenario: &Scenario) -> impl Iterator<Item = String> {
    let followed = followed_walls(scenario).into_iter();
    followed.flat_map(|wall| wall_titles(&scenario.walls[wall].name, WALL_MOTION_COLUMNS))
}

fn wall_titles(wall: &str, columns: &'static [ToldColumn]) -> impl Iterator<Item = String> + use<> {
    let name = format!("wall {wall}");
    columns.iter().map(move |column| column.title(&name))
}

/// Walls that move freely or are told to turn in some stage, by index.
fn followed_walls(scenario: &Scenario) -> BTreeSet<usize> {
    let followed = told_motions(scenario).filter(|(_, motions)| motions.is_free() || motions.turns());
    followed
        .map(|(wall, _)| wall)
        .filter(|&wall| wall < scenario.walls.len())
        .collect()
}
