//! The predictor-corrector of Gear.
//!
//! Forces are found at the predicted places, which the test of the candidates sees; the corrector then moves the grains by
//! a little, which the next prediction starts from.

use super::{GRAINS_PER_TASK, Motion, first_by_id};
use crate::simulation::Simulation;
use demeter_physics::integrator::gear::{self, Gear};
use rayon::prelude::*;
use std::ops::Range;

impl Simulation {
    /// Predicts of some grains places, velocities, orientations, accelerations and their derivatives.
    pub(super) fn predict(&mut self, some: Range<usize>) -> Motion {
        let method = Gear::new(self.dt);
        let domain = *self.comm.domain();
        let grains = &mut self.grains;
        // a predictor-corrector always follows them
        let orientation = grains.orientation.as_deref_mut().unwrap_or_default();
        let n = GRAINS_PER_TASK;
        (
            (
                grains.position.rows_mut()[some.clone()].par_chunks_mut(n),
                grains.velocity.rows_mut()[some.clone()].par_chunks_mut(n),
            ),
            (
                orientation[some.clone()].par_chunks_mut(n),
                grains.angular_velocity.rows_mut()[some.clone()].par_chunks_mut(n),
            ),
            grains.load.rows()[some.clone()].par_chunks(n),
            grains.higher[some.clone()].par_chunks_mut(n),
        )
            .into_par_iter()
            .enumerate()
            .map(|(task, ((position, velocity), (orientation, spin), load, higher))| {
                let mut motion = Motion::default();
                let mut speed2 = 0.0f64;
                for k in 0..position.len() {
                    let mut moving = gear::Motion {
                        place: position[k].vector,
                        rate: velocity[k].vector,
                        acceleration: load[k].force() * velocity[k].scalar,
                    };
                    method.predict(&mut moving, &mut higher[k].translation);
                    (position[k].vector, velocity[k].vector) = (moving.place, moving.rate);
                    let mut twist = load[k].torque() * spin[k].scalar;
                    let derivatives = &mut higher[k].rotation;
                    method.predict_rotation(&mut orientation[k], &mut spin[k].vector, &mut twist, derivatives);
                    higher[k].foreseen = [moving.acceleration, twist];
                    speed2 = speed2.max(velocity[k].vector.length_squared());
                    if motion.misplaced.is_none() && !domain.contains(position[k].vector) {
                        motion.misplaced = Some(some.start + task * n + k);
                    }
                }
                motion.max_speed = speed2.sqrt();
                // the corrector moves grains, too: contacts are looked for in every step
                motion.max_step = f64::INFINITY;
                motion
            })
            .reduce(Motion::default, |one, other| one.merge(other, &grains.id))
    }

    /// Sum per grain, body force, and the correction of all that was predicted. Tells the first grain, by its id, with a value
    /// that is not a number.
    pub(super) fn correct(&mut self) -> Option<usize> {
        let method = Gear::new(self.dt);
        let gravity = self.gravity;
        let own = self.own_grains();
        let grains = &mut self.grains;
        let (n, ids) = (GRAINS_PER_TASK, &grains.id);
        let orientation = grains.orientation.as_deref_mut().unwrap_or_default();
        (
            (
                grains.position.rows_mut()[own.clone()].par_chunks_mut(n),
                grains.velocity.rows_mut()[own.clone()].par_chunks_mut(n),
            ),
            (
                orientation[own.clone()].par_chunks_mut(n),
                grains.angular_velocity.rows_mut()[own.clone()].par_chunks_mut(n),
            ),
            grains.load.rows_mut()[own.clone()].par_chunks_mut(n),
            grains.higher[own.clone()].par_chunks_mut(n),
        )
            .into_par_iter()
            .enumerate()
            .map(|(task, ((position, velocity), (orientation, spin), load, higher))| {
                let mut bad = None;
                for k in 0..velocity.len() {
                    let (force, torque) = (load[k].force() + gravity * load[k].mass(), load[k].torque());
                    let [acceleration, twist] = higher[k].foreseen;
                    let error = force * velocity[k].scalar - acceleration;
                    method.correct(
                        &mut position[k].vector,
                        &mut velocity[k].vector,
                        &mut higher[k].translation,
                        error,
                    );
                    let error = torque * spin[k].scalar - twist;
                    method.correct_rotation(&mut orientation[k], &mut spin[k].vector, &mut higher[k].rotation, error);
                    load[k].put(force, torque);
                    if !(velocity[k].vector.is_finite()
                        && spin[k].vector.is_finite()
                        && force.is_finite()
                        && torque.is_finite())
                    {
                        bad = first_by_id(ids, bad, Some(own.start + task * n + k));
                    }
                }
                bad
            })
            .reduce(|| None, |one, other| first_by_id(ids, one, other))
    }
}
