//! Two bodies: collisions, contact curves and sticking speeds of the laws in a file; and what measurements tell of
//! parameters.
//!
//! * [`collide()`]: one collision, head-on with error control or oblique by extrapolation of the engine's own steps.
//! * [`contact_curve`]: quasi-static loading, unloading, reloading and pull-off.
//! * [`sticking`]: the speed below which bodies stick, against their size.
//! * [`fit`]: from observations to the parameters of a law, with what they cannot tell.
//! * [`packing`]: from a measured force curve to one number of a scenario, by whole runs.
//! * [`figure`]: the figures of the papers whose mathematics Demeter uses.

mod collide;
mod curve;
mod error;
mod extrapolate;
pub mod figure;
pub mod fit;
mod flight;
mod json;
pub mod packing;
mod pull;
mod sticking;

#[cfg(test)]
mod tests;

pub use collide::{CollideReport, Engine, Moment, collide};
pub use curve::{Branch, ContactCurve, CurvePoint, Extremes, contact_curve};
pub use error::CalibrateError;
pub use sticking::{StickingPoint, log_spaced, sticking};
