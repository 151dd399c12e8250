//! Fields on a grid: one `.vti` file for every frame, a collection of them, and a table where the grid is a row of cells.

use super::collection::Collection;
use super::error::OutputError;
use super::folder::RunFolder;
use super::rows::RowFile;
use super::series::{number, stage_name};
use super::vti::ImageData;
use super::vtk_file::NewArray;
use crate::measure::{CellValues, FieldValues, Moment};
use glam::DVec3;

/// A number of a cell.
type OfCell = fn(&CellValues) -> f64;

/// Columns of the table behind those that tell moment and place.
const COLUMNS: [(&str, OfCell); 30] = [
    ("number density [1/m^3]", |c| c.number_density),
    ("density [kg/m^3]", |c| c.density),
    ("solid fraction", |c| c.solid_fraction),
    ("coordination", |c| c.coordination),
    ("velocity x [m/s]", |c| c.velocity.x),
    ("velocity y [m/s]", |c| c.velocity.y),
    ("velocity z [m/s]", |c| c.velocity.z),
    ("granular temperature [m^2/s^2]", |c| c.granular_temperature),
    ("pressure [Pa]", CellValues::pressure),
    ("contact stress xx [Pa]", |c| c.contact_stress[0]),
    ("contact stress xy [Pa]", |c| c.contact_stress[1]),
    ("contact stress xz [Pa]", |c| c.contact_stress[2]),
    ("contact stress yx [Pa]", |c| c.contact_stress[3]),
    ("contact stress yy [Pa]", |c| c.contact_stress[4]),
    ("contact stress yz [Pa]", |c| c.contact_stress[5]),
    ("contact stress zx [Pa]", |c| c.contact_stress[6]),
    ("contact stress zy [Pa]", |c| c.contact_stress[7]),
    ("contact stress zz [Pa]", |c| c.contact_stress[8]),
    ("kinetic stress xx [Pa]", |c| c.kinetic_stress[0]),
    ("kinetic stress xy [Pa]", |c| c.kinetic_stress[1]),
    ("kinetic stress xz [Pa]", |c| c.kinetic_stress[2]),
    ("kinetic stress yy [Pa]", |c| c.kinetic_stress[4]),
    ("kinetic stress yz [Pa]", |c| c.kinetic_stress[5]),
    ("kinetic stress zz [Pa]", |c| c.kinetic_stress[8]),
    ("momentum x [kg/(m^2 s)]", |c| c.momentum.x),
    ("momentum y [kg/(m^2 s)]", |c| c.momentum.y),
    ("momentum z [kg/(m^2 s)]", |c| c.momentum.z),
    ("traction x [N/m^3]", |c| c.traction.x),
    ("traction y [N/m^3]", |c| c.traction.y),
    ("traction z [N/m^3]", |c| c.traction.z),
];

/// Writes the fields of a measure.
#[derive(Debug)]
pub struct FieldWriter {
    folder: RunFolder,
    collection: Collection,
    /// Where the grid is a row of cells.
    table: Option<RowFile>,
    stages: Vec<String>,
}

impl FieldWriter {
    /// Starts without files, or goes on after a step; tells what is gone, as warnings. `is_row` tells whether a table is written,
    /// `stages` are the names of the stages, by index.
    pub fn open(
        folder: &RunFolder,
        measure: &str,
        is_row: bool,
        stages: Vec<String>,
        after: Option<u64>,
    ) -> Result<(Self, Vec<String>), OutputError> {
        let mut collection = Collection::of_fields(folder, measure);
        let warnings = collection.open(folder, after)?;
        let path = folder.field_table(measure);
        let table = is_row.then(|| match after {
            None => RowFile::create(&path, &header()),
            Some(step) => RowFile::resume(&path, &header(), step),
        });
        let writer = Self {
            folder: folder.clone(),
            collection,
            table: table.transpose()?,
            stages,
        };
        Ok((writer, warnings))
    }

    /// The table, where there is one.
    pub(crate) fn rows(&self) -> Option<&RowFile> {
        self.table.as_ref()
    }

    /// Writes the fields of a moment.
    pub fn write(&mut self, (step, time): (u64, f64), moment: Moment, fields: &FieldValues) -> Result<(), OutputError> {
        let path = self.collection.file_path(step);
        let bytes = image(step, time, fields)
            .encode()
            .map_err(|e| OutputError::encode(&path, &e))?;
        self.folder.write(&path, &bytes)?;
        self.collection.add(step, time);
        self.collection.save(&self.folder)?;
        let Some(table) = &mut self.table else { return Ok(()) };
        let size = spacing(fields);
        let row = |(k, cell): (usize, &CellValues)| {
            let [nx, ny, _] = fields.cells;
            let at = DVec3::new((k % nx) as f64, (k / nx % ny) as f64, (k / (nx * ny)) as f64);
            let centre = fields.lower + size * (at + 0.5);
            let mut cells = vec![
                step.to_string(),
                number(time),
                stage_name(&self.stages, moment.stage),
                number(moment.stage_time),
                fields.samples.to_string(),
                k.to_string(),
            ];
            cells.extend(centre.to_array().map(number));
            cells.extend(COLUMNS.iter().map(|(_, value)| number(value(cell))));
            cells
        };
        let rows: Vec<Vec<String>> = fields.of_cells.iter().enumerate().map(row).collect();
        table.add(&rows)
    }
}

fn header() -> Vec<String> {
    let moment = [
        "step",
        "time [s]",
        "stage",
        "stage time [s]",
        "samples",
        "cell",
        "x [m]",
        "y [m]",
        "z [m]",
    ];
    let titles = moment.into_iter().chain(COLUMNS.iter().map(|(title, _)| *title));
    titles.map(str::to_owned).collect()
}

fn spacing(fields: &FieldValues) -> DVec3 {
    (fields.upper - fields.lower) / DVec3::from_array(fields.cells.map(|n| n as f64))
}

fn image(step: u64, time: f64, fields: &FieldValues) -> ImageData<'_> {
    let c = &fields.of_cells;
    let scalars = |name, value: OfCell| NewArray::scalars(name, c.iter().map(value));
    let tensor = |name, value: fn(&CellValues) -> [f64; 9]| NewArray::rows(name, c.iter().map(value));
    ImageData {
        step,
        time,
        lower: fields.lower,
        spacing: spacing(fields),
        cells: fields.cells,
        cell_data: vec![
            scalars("number_density", |c| c.number_density),
            scalars("density", |c| c.density),
            scalars("solid_fraction", |c| c.solid_fraction),
            scalars("coordination", |c| c.coordination),
            NewArray::vectors("momentum", c.iter().map(|c| c.momentum)),
            NewArray::vectors("velocity", c.iter().map(|c| c.velocity)),
            scalars("granular_temperature", |c| c.granular_temperature),
            scalars("pressure", CellValues::pressure),
            tensor("kinetic_stress", |c| c.kinetic_stress),
            tensor("contact_stress", |c| c.contact_stress),
            NewArray::vectors("traction", c.iter().map(|c| c.traction)),
        ],
    }
}
