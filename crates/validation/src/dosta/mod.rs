//! The cross-code benchmark of Dosta et al., Computer Physics Communications 296 (2024) 109066: eight open codes on a ball that
//! falls into a bed, a turning drum and a silo, from published packings and walls.
//!
//! [`CASES`] names the cases; [`prepare`] turns the published files into those that a scenario names; [`run_case`] runs the scenario
//! of `validation/dosta` beside them, or takes the run that is there; [`Outcome::read`] reads what the benchmark asks for, and
//! [`write_outcome`] writes it.

mod cases;
mod data;
mod error;
mod outcome;
mod runs;

pub use cases::{CASES, Case, Kind, Orifice, find_case};
pub use data::{Files, prepare};
pub use error::DostaError;
pub use outcome::{Outcome, write_outcome};
pub use runs::{Experiment, run_case};
