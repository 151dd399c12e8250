//! The experiment of Brodu, Dijksman and Behringer (2015): its protocol with five contact models, Table I, figures 3 to 6.
//!
//! [`run_models`] runs the scenario once per model, or takes the runs that are there; [`Results::read`] averages their cycles
//! and compares them; [`write_table`] and [`write_figures`] write what the paper shows.
//!
//! **What is compared with what.** Published of the experiment are the force on the plate at full compression ([`TOP_FORCE`])
//! and Table I. `Rtop` is against that force. `errf`, `errZ` and `bhat` need the measured curves, which are not
//! published as numbers: they are told against the run of the fitted model, a *stand-in* for the experiment, and also against a
//! measured curve when there is one. The rank of the models is the statement, not the values.

mod error;
mod figures;
mod models;
mod rank;
mod results;
mod runs;
mod table;

pub use error::ValidationError;
pub use figures::{Check, write_figures};
pub use models::{MODELS, Model, Published, find_models};
pub use rank::{METRICS, MetricInfo, ranks};
pub use results::{ModelResult, Results, Standards};
pub use runs::{Experiment, run_models};
pub use table::write_table;

/// Force on the plate at full compression that Table I and the published forces tell [N].
pub const TOP_FORCE: f64 = 15.6;

/// Force below which the experiment sees no contact [N] (Table I, MC-DEM).
pub const RESOLUTION: f64 = 4e-3;
