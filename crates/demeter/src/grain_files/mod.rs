//! Files of grains of this and other codes, read and written: named columns (CSV), data files and dumps of LAMMPS and
//! LIGGGHTS, extended XYZ for OVITO, text packings of YADE.
//!
//! Files are not trusted: sizes, numbers and ids are checked before anything is made of them, memory grows with what is
//! there and never with what a header claims, and every fault names its line. A file of many moments is read and written
//! one moment at a time.

mod carries;
mod columns;
mod dump;
mod error;
mod extended_xyz;
mod format;
mod lammps_data;
mod lammps_styles;
mod lines;
mod numbers;
mod read;
mod rows;
mod table;
mod units;
mod write;
mod yade;

pub use carries::losses;
pub use error::{FileError, FileProblem, Location};
pub use format::{Format, UnknownFormat, restart_of};
pub use lines::{MAX_FRAME_BYTES, MAX_LINE_BYTES};
pub use read::{GrainFile, ReadOptions, Which, read_grain_file};
pub use rows::density_of;
pub use table::{Cell, Extra, GrainTable, TypeOfGrain};
pub use units::{FileUnits, UnknownUnits};
pub use write::{GrainWriter, WriteError, WriteOptions, column_names};

pub(crate) use numbers::{DIAMETERS, LARGEST, diameter, not_allowed, shown};

#[cfg(test)]
mod tests;
