//! What a run left in its folder, read back: frames with their tables, the series and other tables of rows, the summary,
//! the scenario.
//!
//! A run may go on while it is read: files appear whole, and a last row that is not yet whole is left out. What is read is
//! not trusted: nothing outside the folder is opened, memory is bounded by the size of the files, and damage is an error.

mod columns;
mod error;
mod packing;
mod poly_data;
mod poly_head;
pub(crate) mod rows;
mod run;

pub use columns::{BIN, Cells, Column, Columns, IN_BIN, Update};
pub use error::ResultsError;
pub use packing::{PackedContacts, PackedGrains, PackedWall, Packing, Scalar};
pub use poly_data::TableFile;
pub(crate) use rows::nearest;
pub use rows::{column_name, position_of};
pub use run::{FrameTables, Moment, Run, TableKind, finished_steps, shortfall};

#[cfg(test)]
mod tests;
