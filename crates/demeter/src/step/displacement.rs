//! How far grains have come since candidates were found.
//!
//! To measure that, the places of all grains now and then are read, which most steps need not: no grain has come farther than the
//! largest moves of all steps together, and while those do not use up the skin, nor does any grain. Whether a skin is used up is decided by what is
//! measured alone, so nothing depends on when it was measured last.

use super::{GRAINS_PER_TASK, Motion};
use crate::simulation::Simulation;
use demeter_physics::integrator::Integrator;
use rayon::prelude::*;

/// Sums of steps are told a little too long, as they are rounded.
const ROUNDING: f64 = 1.0 + 1e-9;

/// By how much places are rounded in a step, in the rounding of the largest coordinate: twice what three coordinates can come to.
const ROUNDED: f64 = 4.0 * f64::EPSILON;

impl Simulation {
    /// Notes how the grains moved in a step.
    pub(super) fn add_travel(&mut self, motion: &Motion) {
        let is_bounded = self.integrator == Integrator::VelocityVerlet && self.deforming.is_none();
        let domain = self.domain();
        let coordinate = (domain.lower.abs().max(domain.upper.abs()) + domain.size()).max_element();
        self.travel += match is_bounded {
            true => motion.max_step * ROUNDING + ROUNDED * coordinate,
            false => f64::INFINITY,
        };
    }

    /// Largest displacement of any grain since the candidates were found, as it is now [m].
    pub(super) fn measure_travel(&mut self, motion: &Motion) -> f64 {
        let (own, n) = (self.own_grains(), GRAINS_PER_TASK);
        let now = self.grains.position.rows()[own.clone()].par_chunks(n);
        let then = self.neighbours.reference.rows()[own].par_chunks(n);
        let largest = now.zip(then).map(|(now, then)| {
            let squares = now
                .iter()
                .zip(then)
                .map(|(now, then)| (now.vector - then.vector).length_squared());
            // what is not a number is told as misplaced
            squares.fold(0.0, f64::max)
        });
        let [square] = self.largest_of_all([largest.reduce(|| 0.0, f64::max)]);
        let travel = self.with_box(square.sqrt(), motion);
        self.travel = travel * ROUNDING;
        travel
    }
}
