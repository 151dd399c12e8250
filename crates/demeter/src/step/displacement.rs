//! How far grains have come since candidates were found.
//!
//! To measure that, the places of all grains now and then are read, which most steps need not: no grain has come farther than the
//! largest moves of all steps together, and while those do not use up the skin, nor does any grain. Whether a skin is used up is decided by what is
//! measured alone, so nothing depends on when it was measured last.

use super::Motion;
use crate::neighbours::Farthest;
use crate::simulation::Simulation;
use demeter_physics::integrator::Integrator;

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
    pub(crate) fn measure_travel(&mut self, motion: &Motion) -> f64 {
        let (places, own) = (&self.grains.position, self.own_grains());
        let farthest = (self.neighbours.former).farthest(places, &own, self.carried_along());
        let [displacement2, offset2] = self.largest_of_all([farthest.displacement2, farthest.offset2]);
        let travel = Farthest { displacement2, offset2 }.bound();
        let travel = self.with_box(travel, motion);
        self.travel = travel * ROUNDING;
        travel
    }
}
