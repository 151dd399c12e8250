//! What a run leaves behind: frames for ParaView and PyVista, the series, the summary, plots and a picture, all in one
//! folder.
//!
//! Every file but the series and the log gets its name only when it is whole; a row of the series is written in one
//! piece. So an error of the disk or a kill never costs anything that was written before.

mod collection;
mod error;
mod folder;
mod frame;
pub mod picture;
mod plot;
pub mod series;
mod summary;
mod ticks;
mod vtk;
mod vtp;

pub use error::OutputError;
pub use folder::RunFolder;
pub use frame::{ContactRecord, Frame, WallSurface};
pub use plot::{AxisSpec, Look, Plot, Series, Sheet};
pub use series::{COLUMNS, Column, SeriesLabels, SeriesWriter, WALL_COLUMNS};
pub use summary::{EnergySummary, StageSummary, Summary, WallSummary, wall_summaries};
pub use vtk::FrameWriter;
