//! Tables that grow with every row of the series: residence times, roses of contact angles, paths of grains, and grains that went.

use super::distribution::{ABOVE, BETWEEN, bin_title};
use super::error::OutputError;
use super::rows::RowFile;
use super::series::{number, stage_name};
use super::vtk_file::{NewArray, NewPolyData};
use super::vtp::Cells;
use crate::measure::{Counted, EnergyBins, Measures, PathPoint, Ring, Rose};
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Columns in front of those of the bins of a distribution by bins.
const MOMENT: [&str; 4] = ["step", "time [s]", "stage", "stage time [s]"];

/// A table whose rows begin with the moment.
#[derive(Debug)]
pub struct MomentTable {
    file: RowFile,
    stages: Vec<String>,
}

impl MomentTable {
    /// Starts a table with the titles of the columns behind the moment, or goes on after a step.
    pub fn open(path: &Path, titles: &[String], stages: Vec<String>, after: Option<u64>) -> Result<Self, OutputError> {
        let header: Vec<String> = MOMENT
            .iter()
            .map(ToString::to_string)
            .chain(titles.iter().cloned())
            .collect();
        let file = match after {
            None => RowFile::create(path, &header)?,
            Some(step) => RowFile::resume(path, &header, step)?,
        };
        Ok(Self { file, stages })
    }

    /// The file.
    pub(crate) fn rows(&self) -> &RowFile {
        &self.file
    }

    /// Adds rows of a moment.
    pub fn add(&mut self, moment: &Measures, rows: impl IntoIterator<Item = Vec<String>>) -> Result<(), OutputError> {
        let row = |cells: Vec<String>| {
            let mut row = vec![
                moment.step.to_string(),
                number(moment.time),
                stage_name(&self.stages, moment.stage),
                number(moment.stage_time),
            ];
            row.extend(cells);
            row
        };
        let rows: Vec<Vec<String>> = rows.into_iter().map(row).collect();
        self.file.add(&rows)
    }
}

/// Titles of a distribution of residence times with bins of a width [s].
pub fn residence_titles(width: f64, bins: u32) -> Vec<String> {
    // 3 times 0.05 is 0.15, and not 0.15000000000000002
    let edge = |k: u32| -> f64 {
        let exact = width * f64::from(k);
        format!("{exact:.12e}").parse().unwrap_or(exact)
    };
    let edges = (0..bins).map(|k| bin_title(edge(k), "s"));
    let title = std::iter::once("mass left [kg]".to_owned());
    title.chain(edges).chain(std::iter::once(ABOVE.to_owned())).collect()
}

/// The row of a distribution of residence times.
pub fn residence_row(bins: &[f64]) -> Vec<String> {
    let all = bins.iter().sum();
    std::iter::once(&all).chain(bins).map(|mass| number(*mass)).collect()
}

/// Titles of a distribution of collisions by energy.
pub fn collision_titles(bins: &EnergyBins) -> Vec<String> {
    let fixed = [
        "between",
        "collisions",
        "normal energy [J]",
        "tangential energy [J]",
        "below",
    ]
    .map(str::to_owned);
    let edges = bins.edges()[..bins.edges().len() - 1].iter();
    let title = fixed.into_iter().chain(edges.map(|edge| bin_title(number(*edge), "J")));
    title.chain(std::iter::once(ABOVE.to_owned())).collect()
}

/// The rows of a distribution of collisions: those between grains, and those with walls.
pub fn collision_rows(kinds: &[Counted; 2]) -> [Vec<String>; 2] {
    [0, 1].map(|k| {
        let counted = &kinds[k];
        let mut cells = vec![BETWEEN[k].to_owned(), counted.count.to_string()];
        cells.extend(counted.energies.map(number));
        cells.extend(counted.bins.iter().map(u64::to_string));
        cells
    })
}

/// Titles of a rose with bins that begin at angles [deg].
pub fn rose_titles(edges: &[f64]) -> Vec<String> {
    let fixed = ["of", "contacts", "direction [deg]", "anisotropy"].map(str::to_owned);
    let edges = edges.iter().map(|edge| bin_title(edge, "deg"));
    fixed.into_iter().chain(edges).collect()
}

/// The rows of a rose: shares of contacts, and mean normal forces [N].
pub fn rose_rows(rose: &Rose) -> [Vec<String>; 2] {
    [
        ("contacts", &rose.shares, rose.preference),
        ("force", &rose.forces, rose.force_preference),
    ]
    .map(|(of, bins, preference)| {
        let mut cells = vec![
            of.to_owned(),
            rose.contacts.to_string(),
            number(preference.direction),
            number(preference.anisotropy),
        ];
        cells.extend(bins.iter().map(|value| number(*value)));
        cells
    })
}

/// Columns of a profile in a cylinder behind the moment.
const RING_COLUMNS: [&str; 10] = [
    "bin",
    "place [m]",
    "grains",
    "mass [kg]",
    "share",
    "packing fraction",
    "velocity outwards [m/s]",
    "velocity around [m/s]",
    "velocity along [m/s]",
    "fluctuation [m/s]",
];

/// Titles of a profile in a cylinder.
pub fn ring_titles() -> Vec<String> {
    RING_COLUMNS.map(str::to_owned).to_vec()
}

/// The row of a ring or slice.
pub fn ring_row(number_of_bin: usize, ring: &Ring) -> Vec<String> {
    let mut cells = vec![number_of_bin.to_string(), number(ring.place), ring.grains.to_string()];
    let numbers = [ring.mass, ring.share, ring.packing_fraction];
    let velocity = ring.velocity.to_array();
    let rest = numbers.into_iter().chain(velocity).chain([ring.fluctuation]);
    cells.extend(rest.map(number));
    cells
}

/// Columns of paths behind the moment.
const PATH_COLUMNS: [&str; 12] = [
    "id",
    "tag",
    "x [m]",
    "y [m]",
    "z [m]",
    "velocity x [m/s]",
    "velocity y [m/s]",
    "velocity z [m/s]",
    "angular velocity x [rad/s]",
    "angular velocity y [rad/s]",
    "angular velocity z [rad/s]",
    "contacts",
];

/// Titles of paths.
pub fn path_titles() -> Vec<String> {
    PATH_COLUMNS.map(str::to_owned).to_vec()
}

/// The row of a grain on its path.
pub fn path_row(point: &PathPoint) -> Vec<String> {
    let mut cells = vec![point.id.to_string(), point.tag.to_string()];
    for vector in [point.place, point.velocity, point.angular_velocity] {
        cells.extend(vector.to_array().map(number));
    }
    cells.push(point.contacts.to_string());
    cells
}

/// A grain that a removal took.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GoneGrain {
    /// When [s].
    pub time: f64,
    /// Its id.
    pub id: u32,
    /// Its material.
    pub material: u16,
    /// Its diameter [m].
    pub diameter: f64,
    /// Its mass [kg].
    pub mass: f64,
    /// Its centre, counted on across periodic sides [m].
    pub place: DVec3,
    /// Its velocity [m/s].
    pub velocity: DVec3,
    /// Number of the batch or feed that it came from; batches count first.
    pub source: Option<u16>,
    /// Its tag.
    pub tag: i32,
    /// How long it was in the run [s].
    pub stay: f64,
}

/// Titles of the grains that a removal took.
pub fn gone_titles() -> Vec<String> {
    [
        "removed at [s]",
        "id",
        "material",
        "batch",
        "tag",
        "diameter [m]",
        "mass [kg]",
        "x [m]",
        "y [m]",
        "z [m]",
        "velocity x [m/s]",
        "velocity y [m/s]",
        "velocity z [m/s]",
        "residence [s]",
    ]
    .map(str::to_owned)
    .to_vec()
}

/// The row of a grain that a removal took, with the names of its material and its batch or feed.
pub fn gone_row(grain: &GoneGrain, material: &str, source: &str) -> Vec<String> {
    let mut cells = vec![
        number(grain.time),
        grain.id.to_string(),
        material.to_string(),
        source.to_string(),
        grain.tag.to_string(),
        number(grain.diameter),
        number(grain.mass),
    ];
    for vector in [grain.place, grain.velocity] {
        cells.extend(vector.to_array().map(number));
    }
    cells.push(number(grain.stay));
    cells
}

/// Reads paths from their table and tells them as a file of lines (`.vtp`), one for each grain, with time, speed and tag at their points.
pub fn path_lines(table: &Path, lines: &Path, (step, time): (u64, f64)) -> Result<Vec<u8>, OutputError> {
    let mut reader = csv::Reader::from_path(table).map_err(|e| OutputError::encode(table, &e))?;
    let mut points: Vec<(u32, f64, i32, DVec3, f64)> = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|e| OutputError::encode(table, &e))?;
        let cell = |k: usize| {
            record
                .get(k)
                .and_then(|text| text.parse::<f64>().ok())
                .unwrap_or(f64::NAN)
        };
        let vector = |k: usize| DVec3::new(cell(k), cell(k + 1), cell(k + 2));
        points.push((cell(4) as u32, cell(1), cell(5) as i32, vector(6), vector(9).length()));
    }
    // the table is in the order of time; so is every line
    points.sort_by_key(|point| point.0);
    let lengths: Vec<usize> = points.chunk_by(|a, b| a.0 == b.0).map(<[_]>::len).collect();
    let data = NewPolyData {
        step,
        time,
        texts: Vec::new(),
        fields: Vec::new(),
        count: points.len(),
        points: Box::new(points.iter().map(|p| p.3)),
        cells: Cells::Lines(lengths),
        point_data: vec![
            NewArray::counts("id", points.iter().map(|p| p.0)),
            NewArray::scalars("time", points.iter().map(|p| p.1)),
            NewArray::integers("tag", points.iter().map(|p| p.2)),
            NewArray::scalars("speed", points.iter().map(|p| p.4)),
        ],
        cell_data: Vec::new(),
    };
    data.encode().map_err(|e| OutputError::encode(lines, &e))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_of_bins_are_told_without_what_rounding_leaves() {
        let titles = residence_titles(0.05, 4);
        assert_eq!(
            titles,
            ["mass left [kg]", "0 [s]", "0.05 [s]", "0.1 [s]", "0.15 [s]", ABOVE]
        );
    }
}
