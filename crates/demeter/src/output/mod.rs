//! What a run leaves behind: frames for ParaView and PyVista, the series, distributions, the summary, plots and a
//! picture, all in one folder.
//!
//! Every file but the log and those of rows gets its name only when it is whole; the rows of a moment are written in one
//! piece. So an error of the disk or a kill never costs anything that was written before.

mod chains;
pub(crate) mod collection;
pub(crate) mod distribution;
mod error;
mod fields;
mod folder;
mod frame;
pub mod picture;
mod plot;
mod profile;
mod reservation;
mod rows;
pub mod series;
mod summary;
mod tables;
pub(crate) mod ticks;
mod vti;
pub(crate) mod vtk;
pub(crate) mod vtk_file;
pub mod vtp;

pub use chains::{ChainWriter, tell_chains};
pub use distribution::DistributionWriter;
pub use error::OutputError;
pub use fields::FieldWriter;
pub use folder::RunFolder;
pub(crate) use frame::FramePart;
pub use frame::{ContactRecord, Frame, FrameBox, WallSurface};
pub use plot::{AxisSpec, Look, Plot, Series, Sheet};
pub use profile::ProfileWriter;
pub use reservation::RunLock;
pub(crate) use rows::{RowFile, WrittenFiles};
pub use series::{
    COLUMNS, Column, NETWORK_COLUMNS, SeriesLabels, SeriesTable, SeriesValues, SeriesWriter, WALL_COLUMNS,
};
pub use summary::{EnergySummary, StageSummary, Summary, WallSummary, wall_summaries};
pub use tables::{
    GoneGrain, MomentTable, collision_rows, collision_titles, gone_row, gone_titles, path_lines, path_row, path_titles,
    residence_row, residence_titles, ring_row, ring_titles, rose_rows, rose_titles,
};
pub use vtk::{BOX, BOX_PERIODIC, FrameWriter, MATERIAL_NAMES, MEAN_NORMAL_FORCE, WALL_NAMES};
pub(crate) use vtk::{box_fields, tell as tell_frame};
