//! The time series: one row of measures per line of a CSV file.

use super::error::OutputError;
use super::rows::RowFile;
use crate::measure::{
    AXIAL_COLUMNS, BOX_COLUMNS, COLLISION_COLUMNS, DISPLACEMENT_COLUMNS, DOMAIN_COLUMNS, EXTENT_COLUMNS,
    FABRIC_COLUMNS, FEED_COLUMNS, FLOW_COLUMNS, MIXING_COLUMNS, Measures, NEIGHBOUR_COLUMNS, NetworkMeasures,
    OF_MATERIAL_COLUMNS, REGION_COLUMNS, REMOVAL_COLUMNS, RESIDENCE_COLUMNS, SLOPE_COLUMNS, TRACE_COLUMNS, ToldColumn,
    Value, WALL_MOTION_COLUMNS, WALLS_LOAD_COLUMNS, WEAR_COLUMNS, WallLoad,
};
use std::fmt::Write as _;
use std::path::Path;

/// A value of a row.
enum Cell {
    Count(u64),
    /// Index of a stage, written as its name.
    Stage(usize),
    Number(f64),
}

/// A column of the series.
pub struct Column<T: 'static> {
    /// Name of the quantity.
    pub name: &'static str,
    /// Unit; empty for dimensionless quantities.
    pub unit: &'static str,
    /// What it is.
    pub meaning: &'static str,
    value: fn(&T) -> Cell,
}

const fn column<T>(name: &'static str, unit: &'static str, meaning: &'static str, value: fn(&T) -> Cell) -> Column<T> {
    Column {
        name,
        unit,
        meaning,
        value,
    }
}

/// Columns of every series, in order.
pub const COLUMNS: &[Column<Measures>] = {
    use Cell::{Count, Number};
    &[
        column("step", "", "steps done since the start of the run", |m| Count(m.step)),
        column("time", "s", "simulated time", |m| Number(m.time)),
        column("stage", "", "name of the stage", |m| Cell::Stage(m.stage)),
        column("stage time", "s", "time since the start of the stage", |m| {
            Number(m.stage_time)
        }),
        column("grains", "", "number of grains", |m| Count(m.grains as u64)),
        column(
            "contacts",
            "",
            "number of contacts between grains that act: their normal force is not zero",
            |m| Count(m.contacts as u64),
        ),
        column(
            "coordination",
            "",
            "mean number of contacts that act per grain, those with walls counted",
            |m| Number(m.coordination),
        ),
        column(
            "max overlap",
            "",
            "largest overlap as a share of the smaller radius",
            |m| Number(m.max_overlap),
        ),
        column(
            "max speed",
            "m/s",
            "largest speed of a grain; beyond the affine flow and the drift of all grains where the box deforms",
            |m| Number(m.max_speed),
        ),
        column(
            "kinetic over elastic",
            "",
            "kinetic over elastic energy; beyond the affine flow and the drift of all grains where the box deforms",
            |m| Number(m.kinetic_over_elastic),
        ),
        column(
            "packing fraction",
            "",
            "solid volume over the volume of the box around the grains, overlaps not subtracted",
            |m| Number(m.packing_fraction),
        ),
        column(
            "stress xx",
            "Pa",
            "stress of all contacts over the volume of the box around the grains, compression positive",
            |m| Number(m.stress[0]),
        ),
        column("stress yy", "Pa", "see stress xx", |m| Number(m.stress[1])),
        column("stress zz", "Pa", "see stress xx", |m| Number(m.stress[2])),
        column("stress xy", "Pa", "see stress xx", |m| Number(m.stress[3])),
        column("stress xz", "Pa", "see stress xx", |m| Number(m.stress[4])),
        column("stress yz", "Pa", "see stress xx", |m| Number(m.stress[5])),
        column("momentum x", "kg m/s", "total momentum", |m| Number(m.momentum.x)),
        column("momentum y", "kg m/s", "total momentum", |m| Number(m.momentum.y)),
        column("momentum z", "kg m/s", "total momentum", |m| Number(m.momentum.z)),
        column("kinetic energy", "J", "energy of translation", |m| {
            Number(m.energies.kinetic)
        }),
        column("rotational energy", "J", "energy of rotation", |m| {
            Number(m.energies.rotational)
        }),
        column(
            "gravitational energy",
            "J",
            "potential energy in the field of gravity",
            |m| Number(m.energies.gravitational),
        ),
        column("elastic energy", "J", "stored by normal laws", |m| {
            Number(m.energies.elastic)
        }),
        column("tangential energy", "J", "stored by tangential springs", |m| {
            Number(m.energies.tangential)
        }),
        column("rolling energy", "J", "stored by rolling springs", |m| {
            Number(m.energies.rolling)
        }),
        column(
            "viscous dissipation",
            "J",
            "dissipated by normal dashpots since the start",
            |m| Number(m.energies.viscous_dissipated),
        ),
        column(
            "plastic dissipation",
            "J",
            "lost by plastic work and by the tear-off of adhesive contacts since the start",
            |m| Number(m.energies.plastic_dissipated),
        ),
        column(
            "friction dissipation",
            "J",
            "dissipated by friction since the start",
            |m| Number(m.energies.friction_dissipated),
        ),
        column(
            "rolling dissipation",
            "J",
            "dissipated by rolling resistance since the start",
            |m| Number(m.energies.rolling_dissipated),
        ),
        column(
            "wall dissipation",
            "J",
            "lost in dampers and at the stops of freely moving walls since the start",
            |m| Number(m.energies.wall_dissipated),
        ),
        column(
            "free wall energy",
            "J",
            "kinetic energy of freely moving walls, with that of their weight and springs since they were set free",
            |m| Number(m.energies.free_walls),
        ),
        column(
            "wall work",
            "J",
            "work done by the drives of moving walls since the start: on grains, and on free walls that they catch",
            |m| Number(m.energies.wall_work),
        ),
        column(
            "custom work",
            "J",
            "work done on the grains by custom forces, and by changes from outside, since the start (Python, Rust)",
            |m| Number(m.energies.custom_work),
        ),
        column(
            "multi-contact energy",
            "J",
            "what the displacements of contacts by each other add to the elastic energy (part of it)",
            |m| Number(m.energies.multi_contact),
        ),
        column(
            "multi-contact input",
            "J",
            "put into the elastic energy by these displacements since the start without work of the contacts",
            |m| Number(m.energies.multi_contact_input),
        ),
        column(
            "inserted energy",
            "J",
            "energy of grains inserted since the start",
            |m| Number(m.energies.inserted),
        ),
        column(
            "removed energy",
            "J",
            "energy of grains removed since the start, and of contacts with walls that went",
            |m| Number(m.energies.removed),
        ),
        column(
            "energy residual",
            "",
            "share of the energy that passed through the system which the books do not explain",
            |m| Number(m.energies.residual),
        ),
    ]
};

/// Column of the strain, behind [`COLUMNS`] when the scenario tells which wall strains the packing.
pub const STRAIN_COLUMN: Column<Measures> = column(
    "strain",
    "",
    "displacement of the wall that strains the packing over the length of the packing",
    |m| Cell::Number(m.strain.unwrap_or(f64::NAN)),
);

/// Columns of every wall, behind the others; their names begin with `wall NAME`.
pub const WALL_COLUMNS: &[Column<WallLoad>] = {
    use Cell::{Count, Number};
    &[
        column("force x", "N", "force of the grains on the wall", |w| Number(w.force.x)),
        column("force y", "N", "force of the grains on the wall", |w| Number(w.force.y)),
        column("force z", "N", "force of the grains on the wall", |w| Number(w.force.z)),
        column(
            "torque x",
            "N m",
            "torque of the grains on the wall about the origin of its pose",
            |w| Number(w.torque.x),
        ),
        column("torque y", "N m", "see torque x", |w| Number(w.torque.y)),
        column("torque z", "N m", "see torque x", |w| Number(w.torque.z)),
        column("power", "W", "rate of the work of the wall on the grains", |w| {
            Number(w.power)
        }),
        column(
            "work",
            "J",
            "work of the wall on the grains since the start of the run",
            |w| Number(w.work),
        ),
        column("displacement x", "m", "displacement since the start of the run", |w| {
            Number(w.displacement.x)
        }),
        column("displacement y", "m", "displacement since the start of the run", |w| {
            Number(w.displacement.y)
        }),
        column("displacement z", "m", "displacement since the start of the run", |w| {
            Number(w.displacement.z)
        }),
        column("contacts", "", "number of contacts with grains that act", |w| {
            Count(u64::from(w.contacts))
        }),
    ]
};

/// Columns of every contact network, in order.
pub const NETWORK_COLUMNS: &[Column<NetworkMeasures>] = {
    use Cell::{Count, Number};
    &[
        column(
            "contacts",
            "",
            "number of contacts between grains that carry at least the threshold",
            |n| Count(n.contacts as u64),
        ),
        column(
            "coordination",
            "",
            "mean number of contacts per grain that carry at least the threshold, those with walls counted",
            |n| Number(n.coordination),
        ),
        column(
            "mean force",
            "N",
            "mean normal force of these contacts between grains; NaN without any",
            |n| Number(n.mean_force),
        ),
        column(
            "centre distance",
            "m",
            "mean distance of the centres of the grains of these contacts; NaN without any",
            |n| Number(n.centre_distance),
        ),
        column(
            "packing fraction",
            "",
            "solid volume over the volume of the core of the packing, overlaps not subtracted; NaN when the core is empty",
            |n| Number(n.packing_fraction),
        ),
        column(
            "scaling",
            "N m",
            "coordination x packing fraction x centre distance x mean force; NaN when one of them is",
            |n| Number(n.scaling()),
        ),
    ]
};

impl<T> Column<T> {
    /// Name and unit, as in the header: `time [s]`.
    pub fn title(&self) -> String {
        if self.unit.is_empty() {
            self.name.to_owned()
        } else {
            format!("{} [{}]", self.name, self.unit)
        }
    }
}

/// Header name of a column of a wall: `wall top force z [N]`.
fn wall_title(wall: &str, column: &Column<WallLoad>) -> String {
    format!("wall {wall} {}", column.title())
}

/// Header name of a column of a contact network: `packing mean force [N]`.
fn network_title(network: &str, column: &Column<NetworkMeasures>) -> String {
    format!("{network} {}", column.title())
}

/// Columns behind all others, with what their titles begin with.
const TOLD: [(&str, &[ToldColumn]); 21] = [
    ("MEASURE", REGION_COLUMNS),
    ("MEASURE MATERIAL", OF_MATERIAL_COLUMNS),
    ("MEASURE", EXTENT_COLUMNS),
    ("MEASURE", TRACE_COLUMNS),
    ("MEASURE", FLOW_COLUMNS),
    ("MEASURE", MIXING_COLUMNS),
    ("MEASURE", SLOPE_COLUMNS),
    ("MEASURE", FABRIC_COLUMNS),
    ("MEASURE", RESIDENCE_COLUMNS),
    ("MEASURE", DISPLACEMENT_COLUMNS),
    ("MEASURE", NEIGHBOUR_COLUMNS),
    ("MEASURE", COLLISION_COLUMNS),
    ("MEASURE", WALLS_LOAD_COLUMNS),
    ("MEASURE", AXIAL_COLUMNS),
    ("feed NAME", FEED_COLUMNS),
    ("removal NAME", REMOVAL_COLUMNS),
    ("removal NAME MATERIAL", OF_MATERIAL_COLUMNS),
    ("domain", DOMAIN_COLUMNS),
    ("box", BOX_COLUMNS),
    ("wall NAME", WEAR_COLUMNS),
    ("wall NAME", WALL_MOTION_COLUMNS),
];

/// The table of all columns in Markdown, for the book.
pub fn columns_table() -> String {
    let mut text = String::from("| column | unit | meaning |\n|---|---|---|\n");
    let plain = COLUMNS
        .iter()
        .chain([&STRAIN_COLUMN])
        .map(|c| (c.title(), c.unit, c.meaning));
    let walls = WALL_COLUMNS.iter().map(|c| (wall_title("NAME", c), c.unit, c.meaning));
    let networks = (NETWORK_COLUMNS.iter()).map(|c| (network_title("MEASURE", c), c.unit, c.meaning));
    let told = (TOLD.iter()).flat_map(|(name, columns)| columns.iter().map(|c| (c.title(name), c.unit, c.meaning)));
    for (title, unit, meaning) in plain.chain(walls).chain(networks).chain(told) {
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "| `{title}` | {} | {meaning} |",
            if unit.is_empty() { "1" } else { unit }
        );
    }
    text
}

/// Names that a series needs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SeriesLabels {
    /// Names of the stages, by index.
    pub stages: Vec<String>,
    /// Names of the walls, by index.
    pub walls: Vec<String>,
    /// Whether there is a column for the strain.
    pub strain: bool,
    /// Names of the contact networks, by index.
    pub networks: Vec<String>,
    /// Titles of the columns behind all others.
    pub told: Vec<String>,
}

impl SeriesLabels {
    /// The columns in front of those of the walls.
    fn columns(&self) -> impl Iterator<Item = &'static Column<Measures>> {
        COLUMNS.iter().chain(self.strain.then_some(&STRAIN_COLUMN))
    }

    /// The values of a row, in the order of the titles.
    fn cells(&self, row: &Measures) -> Vec<Cell> {
        let mut cells: Vec<Cell> = self.columns().map(|c| (c.value)(row)).collect();
        for wall in &row.walls {
            cells.extend(WALL_COLUMNS.iter().map(|c| (c.value)(wall)));
        }
        for network in &row.networks {
            cells.extend(NETWORK_COLUMNS.iter().map(|c| (c.value)(network)));
        }
        cells.extend(row.told.iter().map(|value| match *value {
            Value::Count(n) => Cell::Count(n),
            Value::Number(x) => Cell::Number(x),
        }));
        cells
    }

    /// The number that a row tells in the column of a title.
    pub(crate) fn value(&self, row: &Measures, title: &str) -> Option<f64> {
        let place = self.header().iter().position(|known| known == title)?;
        match self.cells(row).get(place)? {
            Cell::Count(count) => Some(*count as f64),
            Cell::Number(number) => Some(*number),
            Cell::Stage(_) => None,
        }
    }

    /// Titles of all columns, as in the header.
    pub fn header(&self) -> Vec<String> {
        let mut names: Vec<String> = self.columns().map(Column::title).collect();
        for wall in &self.walls {
            names.extend(WALL_COLUMNS.iter().map(|c| wall_title(wall, c)));
        }
        for network in &self.networks {
            names.extend(NETWORK_COLUMNS.iter().map(|c| network_title(network, c)));
        }
        names.extend(self.told.iter().cloned());
        names
    }
}

/// A column of a series in memory.
#[derive(Clone, Debug, PartialEq)]
pub enum SeriesValues {
    /// Numbers of things.
    Counts(Vec<u64>),
    /// Quantities in SI.
    Numbers(Vec<f64>),
    /// Names of stages.
    Names(Vec<String>),
}

/// The series of a run in memory, column by column.
#[derive(Clone, Debug)]
pub struct SeriesTable {
    labels: SeriesLabels,
    /// Title and values of every column, as in the file; none before the first row.
    columns: Vec<(String, SeriesValues)>,
}

impl SeriesTable {
    /// A series without rows.
    pub fn new(labels: SeriesLabels) -> Self {
        let columns = Vec::new();
        Self { labels, columns }
    }

    /// Title and values of every column; none before the first row.
    pub fn columns(&self) -> &[(String, SeriesValues)] {
        &self.columns
    }

    /// Adds a row.
    pub fn add(&mut self, row: &Measures) {
        let cells = self.labels.cells(row);
        if self.columns.is_empty() {
            let empty = |cell: &Cell| match cell {
                Cell::Count(_) => SeriesValues::Counts(Vec::new()),
                Cell::Stage(_) => SeriesValues::Names(Vec::new()),
                Cell::Number(_) => SeriesValues::Numbers(Vec::new()),
            };
            self.columns = self.labels.header().into_iter().zip(cells.iter().map(empty)).collect();
        }
        for ((_, values), cell) in self.columns.iter_mut().zip(cells) {
            match (values, cell) {
                (SeriesValues::Counts(values), Cell::Count(n)) => values.push(n),
                (SeriesValues::Numbers(values), Cell::Number(x)) => values.push(x),
                (SeriesValues::Names(values), Cell::Stage(k)) => values.push(stage_name(&self.labels.stages, k)),
                // a column keeps its kind
                (SeriesValues::Counts(_) | SeriesValues::Numbers(_) | SeriesValues::Names(_), _) => {}
            }
        }
    }
}

/// Writes the series of a run.
#[derive(Debug)]
pub struct SeriesWriter {
    file: RowFile,
    labels: SeriesLabels,
}

impl SeriesWriter {
    /// Starts a series with its header.
    pub fn create(path: &Path, labels: SeriesLabels) -> Result<Self, OutputError> {
        let file = RowFile::create(path, &labels.header())?;
        Ok(Self { file, labels })
    }

    /// Goes on after a step: rows of later steps and a row that was cut short are removed. A series that is not there,
    /// or was cut in its header, is started again.
    pub fn resume(path: &Path, labels: SeriesLabels, step: u64) -> Result<Self, OutputError> {
        let file = RowFile::resume(path, &labels.header(), step)?;
        Ok(Self { file, labels })
    }

    /// The file.
    pub(crate) fn rows(&self) -> &RowFile {
        &self.file
    }

    /// Writes a row; it is in the file when this returns.
    pub fn write(&mut self, row: &Measures) -> Result<(), OutputError> {
        let sizes = [
            ("walls", self.labels.walls.len(), row.walls.len()),
            ("contact networks", self.labels.networks.len(), row.networks.len()),
            ("further columns", self.labels.told.len(), row.told.len()),
        ];
        for (what, expected, found) in sizes {
            if found != expected {
                return Err(OutputError::RowDoesNotFit {
                    path: self.file.path().to_owned(),
                    what,
                    expected,
                    found,
                });
            }
        }
        let cells = self.labels.cells(row);
        let cells: Vec<String> = cells.iter().map(|cell| self.text(cell)).collect();
        self.file.add(&[cells])
    }

    fn text(&self, cell: &Cell) -> String {
        match *cell {
            Cell::Count(n) => n.to_string(),
            Cell::Number(x) => number(x),
            Cell::Stage(k) => stage_name(&self.labels.stages, k),
        }
    }
}

/// Shortest text that reads back to the same bits.
pub(super) fn number(x: f64) -> String {
    format!("{x:?}")
}

/// Name of a stage by its index.
pub(super) fn stage_name(stages: &[String], index: usize) -> String {
    stages.get(index).cloned().unwrap_or_else(|| index.to_string())
}

#[cfg(test)]
mod tests;
