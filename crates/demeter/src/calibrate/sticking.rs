//! Critical sticking speed against size.

use super::error::CalibrateError;
use crate::scenario::ImpactFile;
use demeter_physics::collision::{Sticking, Tolerance, sticking_speed_of};
use rayon::prelude::*;

/// The critical speed of one size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StickingPoint {
    /// Effective radius [m].
    pub effective_radius: f64,
    /// What is known of the speed.
    pub sticking: Sticking,
}

/// Critical sticking speeds of the two bodies of a file, scaled to each of these effective radii [m].
pub fn sticking(file: &ImpactFile, radii: &[f64]) -> Result<Vec<StickingPoint>, CalibrateError> {
    let law = file.law()?;
    let one = |&radius: &f64| -> Result<StickingPoint, CalibrateError> {
        let size = file.with_effective_radius(radius).size();
        file.check_size(&law, size)?;
        Ok(StickingPoint {
            effective_radius: radius,
            sticking: sticking_speed_of(&law.normal, size, file.impact.start, &Tolerance::default())?,
        })
    };
    radii.par_iter().map(one).collect()
}

/// So many values from `first` to `last`, both included, at equal ratios.
pub fn log_spaced(first: f64, last: f64, count: usize) -> Vec<f64> {
    let (low, high) = (libm::log(first), libm::log(last));
    (0..count)
        .map(|k| match k {
            0 => first,
            k if k + 1 == count => last,
            k => libm::exp(low + (high - low) * (k as f64 / (count - 1) as f64)),
        })
        .collect()
}
