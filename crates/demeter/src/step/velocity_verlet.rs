//! Velocity Verlet.

use super::{GRAINS_PER_TASK, Motion, first_by_id};
use crate::contacts::Contacts;
use crate::contacts::sum::contact_load;
use crate::neighbours::Neighbours;
use crate::particles::{Domain, Row};
use crate::simulation::Simulation;
use demeter_physics::integrator::rotate;
use demeter_physics::lanes::{self, Kernel, Lanes};
use glam::{DQuat, DVec3};
use rayon::prelude::*;

impl Simulation {
    /// Half kick, drift, and the predicted velocity; orientations turn.
    pub(super) fn drift(&mut self) -> Motion {
        let dt = self.dt;
        let domain = *self.comm.domain();
        let instructions = self.instructions;
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
                    let drift = Drift {
                        first: task * n,
                        position,
                        velocity,
                        spin,
                        orientation,
                        force,
                        torque,
                        reference,
                        dt,
                        domain: &domain,
                    };
                    lanes::run(instructions, drift)
                },
            )
            .reduce(Motion::default, Motion::merge)
    }

    /// Sum per grain, body force, and the kick over `correction` [s] that corrects the predicted velocity. Tells the first
    /// grain, by its id, with a value that is not a number.
    pub(super) fn kick(&mut self, correction: f64) -> Option<usize> {
        let (neighbours, contacts, gravity) = (&self.neighbours, &self.contacts, self.gravity);
        let instructions = self.instructions;
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
                let kick = Kick {
                    first: task * n,
                    velocity,
                    spin,
                    force,
                    torque,
                    mass,
                    gravity,
                    correction,
                    neighbours,
                    contacts,
                    ids,
                };
                lanes::run(instructions, kick)
            })
            .reduce(|| None, |one, other| first_by_id(ids, one, other))
    }
}

/// The first half of a step of some grains. Their rows are the lanes here: the code is plain, but compiled for the
/// instructions of a kernel.
struct Drift<'a> {
    /// Index of the first of them.
    first: usize,
    position: &'a mut [Row],
    velocity: &'a mut [Row],
    spin: &'a mut [Row],
    orientation: &'a mut [DQuat],
    force: &'a [DVec3],
    torque: &'a [DVec3],
    reference: &'a [DVec3],
    dt: f64,
    domain: &'a Domain,
}

impl Kernel for Drift<'_> {
    type Output = Motion;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Motion {
        let (dt, half) = (self.dt, 0.5 * self.dt);
        let mut motion = Motion::default();
        let (mut speed2, mut displacement2) = (0.0f64, 0.0f64);
        let each = (self.position.iter_mut().zip(self.velocity).zip(self.spin))
            .zip(self.orientation)
            .zip(self.force.iter().zip(self.torque).zip(self.reference));
        for (k, ((((position, velocity), spin), orientation), ((force, torque), reference))) in each.enumerate() {
            let kick = *force * (half * velocity.scalar);
            let middle = velocity.vector + kick;
            position.vector += middle * dt;
            velocity.vector = middle + kick;
            let twist = *torque * (half * spin.scalar);
            let middle_spin = spin.vector + twist;
            *orientation = rotate(*orientation, middle_spin, dt);
            spin.vector = middle_spin + twist;
            speed2 = speed2.max(velocity.vector.length_squared());
            displacement2 = displacement2.max((position.vector - *reference).length_squared());
            if motion.misplaced.is_none() && !self.domain.contains(position.vector) {
                motion.misplaced = Some(self.first + k);
            }
        }
        motion.max_speed = speed2.sqrt();
        motion.max_displacement = displacement2.sqrt();
        motion
    }
}

/// The second half of a step of some grains, compiled as [`Drift`] is.
struct Kick<'a> {
    /// Index of the first of them.
    first: usize,
    velocity: &'a mut [Row],
    spin: &'a mut [Row],
    force: &'a mut [DVec3],
    torque: &'a mut [DVec3],
    mass: &'a [f64],
    gravity: DVec3,
    correction: f64,
    neighbours: &'a Neighbours,
    contacts: &'a Contacts,
    ids: &'a [u32],
}

impl Kernel for Kick<'_> {
    type Output = Option<usize>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Option<usize> {
        let mut bad = None;
        let each = (self.velocity.iter_mut().zip(self.spin))
            .zip(self.force.iter_mut().zip(self.torque))
            .zip(self.mass);
        for (k, (((velocity, spin), (force, torque)), mass)) in each.enumerate() {
            let grain = self.first + k;
            let (contact_force, new_torque) = contact_load(grain, self.neighbours, self.contacts);
            let new_force = contact_force + self.gravity * *mass;
            velocity.vector += (new_force - *force) * (self.correction * velocity.scalar);
            spin.vector += (new_torque - *torque) * (self.correction * spin.scalar);
            *force = new_force;
            *torque = new_torque;
            // a sum is finite where its terms are, unless they are near the largest number there is
            let all = velocity.vector + spin.vector + new_force + new_torque;
            if !(all.x + all.y + all.z).is_finite()
                && !(velocity.vector.is_finite()
                    && spin.vector.is_finite()
                    && new_force.is_finite()
                    && new_torque.is_finite())
            {
                bad = first_by_id(self.ids, bad, Some(grain));
            }
        }
        bad
    }
}
