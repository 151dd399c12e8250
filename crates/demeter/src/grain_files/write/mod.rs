//! Writes files of grains. Numbers are written so that they read back to the same bits.

mod columns;
mod dump;
mod extended_xyz;
mod lammps_data;
mod yade;

pub use columns::column_names;
pub(super) use extended_xyz::words;

use super::format::Format;
use super::table::{Cell, GrainTable};
use glam::DVec3;
use std::io::{self, Write};

/// How a file of grains is written.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WriteOptions {
    /// The columns of formats that let one choose, by name; all that the table tells when absent.
    pub columns: Option<Vec<String>>,
    /// Whether tabs separate the values of [`Format::Columns`] instead of commas.
    pub tabs: bool,
}

/// Why a file of grains cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The system refused.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// A format needs densities.
    #[error(
        "{format} needs densities, and there are none; tell the density of all grains (`--density \"2500 kg/m^3\"`)"
    )]
    NoDensities {
        /// The format.
        format: Format,
    },
    /// A column that is not there.
    #[error("there is no column `{name}`; there are {}", known.join(", "))]
    UnknownColumn {
        /// The name.
        name: String,
        /// Those there are.
        known: Vec<String>,
    },
    /// A column that is asked for again.
    #[error("the column `{name}` is asked for twice; name it once")]
    TwiceColumn {
        /// The name.
        name: String,
    },
    /// The columns of the format are fixed.
    #[error("the columns of {format} are fixed; leave `--columns` out, or write csv, xyz or a dump")]
    FixedColumns {
        /// The format.
        format: Format,
    },
    /// Another moment for a format that holds one.
    #[error("{format} holds one moment; write each into a file of its own")]
    OneMoment {
        /// The format.
        format: Format,
    },
}

/// Writes moments into a file.
#[derive(Debug)]
pub struct GrainWriter<W> {
    out: W,
    format: Format,
    options: WriteOptions,
    moments: usize,
}

impl<W: Write> GrainWriter<W> {
    /// A writer that has written nothing.
    pub fn new(out: W, format: Format, options: WriteOptions) -> Result<Self, WriteError> {
        let fixed = !matches!(
            format,
            Format::Columns | Format::LammpsDump | Format::LiggghtsDump | Format::ExtendedXyz
        );
        match fixed && options.columns.is_some() {
            true => Err(WriteError::FixedColumns { format }),
            false => Ok(Self {
                out,
                format,
                options,
                moments: 0,
            }),
        }
    }

    /// Writes a moment.
    pub fn write(&mut self, table: &GrainTable) -> Result<(), WriteError> {
        let (out, format, first) = (&mut self.out, self.format, self.moments == 0);
        let columns = self.options.columns.as_deref();
        if !first && !format.holds_many() {
            return Err(WriteError::OneMoment { format });
        }
        match format {
            Format::Columns => columns::write(out, table, columns, if self.options.tabs { "\t" } else { "," })?,
            Format::LammpsData | Format::LiggghtsData => lammps_data::write(out, table, format)?,
            Format::LammpsDump | Format::LiggghtsDump => dump::write(out, table, format, columns, first)?,
            Format::ExtendedXyz => extended_xyz::write(out, table, columns)?,
            Format::Yade => yade::write(out, table)?,
        }
        self.moments += 1;
        Ok(())
    }

    /// The file, when all is written.
    pub fn finish(mut self) -> io::Result<W> {
        self.out.flush()?;
        Ok(self.out)
    }
}

/// The box of a table, or, where there is none that the format knows, the smallest one around all grains, a little widened so that
/// no grain lies on its side; without grains one of a metre.
fn cell_of(table: &GrainTable, format: Format) -> Cell {
    if let Some(cell) = table.cell.filter(|cell| format.knows_box(cell)) {
        return cell;
    }
    let balls = table.positions.iter().zip(&table.diameters);
    let boxes = balls.map(|(position, diameter)| (*position - 0.5 * *diameter, *position + 0.5 * *diameter));
    let (lower, upper) = (boxes.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))).unwrap_or((DVec3::ZERO, DVec3::ONE));
    let margin = 1e-6 * (upper - lower);
    Cell {
        lower: lower - margin,
        upper: upper + margin,
        ..Cell::default()
    }
}
