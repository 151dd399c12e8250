//! Laws of bulk solids that every engine must give: Beverloo's discharge of a silo, Janssen's floor of a column, and an angle of
//! repose that rises with friction.
//!
//! [`STUDIES`] names the studies; [`run_study`] carries out their runs, or takes those that are there, and [`Findings`] tells
//! what they found beside the law. `validation/bulk/README.md` tells the results.

mod error;
mod findings;
mod floor;
mod line;
mod studies;

pub use error::BulkError;
pub use findings::{Findings, find, write_findings};
pub use line::{Line, fit_line};
pub use studies::{Experiment, Kind, STUDIES, Study, find_study, run_study};
