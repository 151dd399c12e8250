//! Grains so fast that they jump over others within a step.

use super::Simulation;
use crate::contacts::Fault;
use crate::step::Motion;

impl Simulation {
    /// Notes the radius of the smallest grain of all processes, before candidates are found.
    pub(super) fn note_least_radius(&mut self) {
        let radii = self.grains.position.rows()[self.own_grains()]
            .iter()
            .map(|row| row.scalar);
        let [least] = self.largest_of_all([-radii.fold(f64::INFINITY, f64::min)]);
        self.least_radius = -least;
    }

    /// A grain that moves by more than its radius in a step ends the run: it may come to the other side of a grain or a wall and never
    /// overlap with it. Where the box deforms, its flow does not count.
    pub(crate) fn check_jumps(&mut self, motion: &Motion) -> Result<(), Fault> {
        // that of the fastest of all processes, so all of them look or none does
        if motion.max_step.max(motion.max_speed * self.dt) > self.least_radius {
            let first = self.own_grains().filter_map(|g| self.jump(g)).min_by_key(Fault::grain);
            return self.fault_of_any(first);
        }
        Ok(())
    }

    fn jump(&self, g: usize) -> Option<Fault> {
        let (grains, position) = (&self.grains, self.grains.position[g]);
        let flow = self
            .comm
            .deforming()
            .map(|box_| box_.gradient(&box_.rates()) * (position - box_.middle));
        let speed = (grains.velocity[g] - flow.unwrap_or_default()).length();
        let (way, radius) = (speed * self.dt, grains.radius(g));
        // a velocity that is no number is told elsewhere; the speed of one that is may be none
        (way > radius && grains.velocity[g].is_finite()).then_some(Fault::Jump {
            step: self.step,
            id: grains.id[g],
            position,
            speed,
            way,
            radius,
        })
    }
}
