//! Cycles of runs, averaged, beside those of another run or of an experiment.
//!
//! [`read_run`] takes the rows of the stages that load and unload out of `series.csv`, drops the first cycles, and averages
//! the others at the same position in the stroke, loading and unloading apart. A new occurrence of the loading stage begins a
//! cycle. The row that ends the stage before belongs to a stroke, too: it is the state in which the stage begins. The
//! position is the strain, the compression of the plate, or the stage time.
//!
//! Levels are the rows of the first cycle that is kept. In another cycle, a row within [`SAME`] of the stroke is taken as it
//! is; between rows the values are interpolated linearly; a level within [`BEYOND`] of the stroke beyond its end is taken
//! at its end, and any farther the cycle does not count for that level.
//!
//! [`compare`] tells the metrics of Brodu, Dijksman and Behringer (Phys. Rev. E 91, 032201, 2015, section IV) at the levels of
//! the reference, between which the run is interpolated in the same way. What cannot be told from the reference is left
//! out, with the reason.

mod cycles;
mod error;
mod forces;
mod json;
mod measured;
mod metrics;
mod run;
mod strokes;
#[cfg(test)]
mod tests;

pub use cycles::{BEYOND, Level, Mean, Phase, Position, SAME};
pub use error::CompareError;
pub use forces::{Bins, Contacts};
pub use json::comparisons_to_json;
pub use measured::{MEASURED_COLUMNS, measured_points, read_measured};
pub use metrics::{Comparison, ContactMisfit, LeftOut, Metric, Misfit, Pair, Thresholds, TopRatio, compare};
pub use run::{Reading, is_repeat, read_run, tells_strain};
pub use strokes::Strokes;
