//! Velocity Verlet.

use super::{GRAINS_PER_TASK, Motion, first_by_id};
use crate::contacts::sum::contact_load;
use crate::simulation::Simulation;
use demeter_physics::integrator::rotate;
use rayon::prelude::*;

impl Simulation {
    /// Half kick, drift, and the predicted velocity; orientations turn.
    pub(super) fn drift(&mut self) -> Motion {
        let dt = self.dt;
        let half = 0.5 * dt;
        let domain = *self.comm.domain();
        let grains = &mut self.grains;
        let n = GRAINS_PER_TASK;
        (
            grains.position.rows_mut().par_chunks_mut(n),
            grains.velocity.rows_mut().par_chunks_mut(n),
            grains.angular_velocity.rows_mut().par_chunks_mut(n),
            grains.orientation.par_chunks_mut(n),
            (grains.force.par_chunks(n), grains.torque.par_chunks(n)),
            self.neighbours.reference.par_chunks(n),
        )
            .into_par_iter()
            .enumerate()
            .map(
                |(task, (position, velocity, spin, orientation, (force, torque), reference))| {
                    let mut motion = Motion::default();
                    let (mut speed2, mut displacement2) = (0.0f64, 0.0f64);
                    for k in 0..position.len() {
                        let kick = force[k] * (half * velocity[k].scalar);
                        let middle = velocity[k].vector + kick;
                        position[k].vector += middle * dt;
                        velocity[k].vector = middle + kick;
                        let twist = torque[k] * (half * spin[k].scalar);
                        let middle_spin = spin[k].vector + twist;
                        orientation[k] = rotate(orientation[k], middle_spin, dt);
                        spin[k].vector = middle_spin + twist;
                        speed2 = speed2.max(velocity[k].vector.length_squared());
                        displacement2 = displacement2.max((position[k].vector - reference[k]).length_squared());
                        if motion.misplaced.is_none() && !domain.contains(position[k].vector) {
                            motion.misplaced = Some(task * n + k);
                        }
                    }
                    motion.max_speed = speed2.sqrt();
                    motion.max_displacement = displacement2.sqrt();
                    motion
                },
            )
            .reduce(Motion::default, Motion::merge)
    }

    /// Sum per grain, body force, and the kick over `correction` [s] that corrects the predicted velocity. Tells the first
    /// grain, by its id, with a value that is not a number.
    pub(super) fn kick(&mut self, correction: f64) -> Option<usize> {
        let (neighbours, contacts, gravity) = (&self.neighbours, &self.contacts, self.gravity);
        let grains = &mut self.grains;
        let (n, ids) = (GRAINS_PER_TASK, &grains.id);
        (
            grains.velocity.rows_mut().par_chunks_mut(n),
            grains.angular_velocity.rows_mut().par_chunks_mut(n),
            grains.force.par_chunks_mut(n),
            grains.torque.par_chunks_mut(n),
            grains.mass.par_chunks(n),
        )
            .into_par_iter()
            .enumerate()
            .map(|(task, (velocity, spin, force, torque, mass))| {
                let mut bad = None;
                for k in 0..velocity.len() {
                    let (contact_force, new_torque) = contact_load(task * n + k, neighbours, contacts);
                    let new_force = contact_force + gravity * mass[k];
                    velocity[k].vector += (new_force - force[k]) * (correction * velocity[k].scalar);
                    spin[k].vector += (new_torque - torque[k]) * (correction * spin[k].scalar);
                    force[k] = new_force;
                    torque[k] = new_torque;
                    if !(velocity[k].vector.is_finite()
                        && spin[k].vector.is_finite()
                        && new_force.is_finite()
                        && new_torque.is_finite())
                    {
                        bad = first_by_id(ids, bad, Some(task * n + k));
                    }
                }
                bad
            })
            .reduce(|| None, |one, other| first_by_id(ids, one, other))
    }
}
