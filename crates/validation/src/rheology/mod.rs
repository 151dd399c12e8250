//! The friction of dense granular flow: spheres sheared at a constant pressure in a periodic box, from fast to slow.
//!
//! The scenario is `validation/rheology/scenario.toml`. Each stage that shears is a point: [`Point`] holds the inertial number
//! `I = rate d sqrt(density / pressure)`, the friction `shear stress / pressure` and the solid fraction, means over the later part
//! of the stage. [`glass_beads`] is the law that Jop, Forterre and Pouliquen (Nature 441, 727, 2006) measured for glass beads.

mod error;
mod points;
mod runs;
mod tables;

pub use error::RheologyError;
pub use points::{Flow, Point, read_points};
pub use runs::{Experiment, run_series};
pub use tables::{glass_beads, write_tables};
