//! Many runs of one scenario with different values: what is varied, what comes of it.
//!
//! A [`Plan`] holds the scenario and the values of every run. It lies in `sweep.json` at the top of the folder of the sweep
//! ([`SweepFolder`]), and each run has a folder of its own below. How far a run is, its own folder tells: so processes on many
//! machines can work on one sweep without writing into one file, and a kill at any moment costs what a run had not yet put
//! into its checkpoint.
//!
//! Nothing here starts processes; `demeter sweep` does.

mod average;
mod check;
mod design;
mod error;
mod folder;
mod gather;
mod list;
mod metric;
mod names;
mod picture;
mod plan;
mod run;
mod slurm;
mod table;
mod value;

#[cfg(test)]
mod tests;

pub use average::averages;
pub use check::{Checked, SweepFault, SweepFaults, SweepWarning, check};
pub use design::{Axis, Varied};
pub use error::SweepError;
pub use folder::{End, Held, Outcome, Status, SweepFolder};
pub use gather::{Results, ResultsCell, check_wishes, gather, metrics, title_of};
pub use metric::{Metric, What};
pub use picture::plot;
pub use plan::{Column, Estimate, MAX_RUNS, Plan, PlannedRun, Wishes};
pub use run::{Carried, carry_out};
pub use slurm::{ArrayJob, LOGS, array_script, option_line, quoted};
