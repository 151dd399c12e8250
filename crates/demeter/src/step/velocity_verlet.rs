//! Velocity Verlet.

use super::{GRAINS_PER_TASK, Motion, first_by_id};
use crate::contacts::sum::contact_load;
use crate::particles::{Domain, Row};
use crate::simulation::Simulation;
use demeter_physics::integrator::rotate_wide;
use demeter_physics::lanes::{self, Kernel, Lanes, MOST_LANES, Mask, Places, Vector};
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
        let sums = &self.sums;
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
                    let known = sums.get(task * n + k).copied().flatten();
                    let (contact_force, new_torque) =
                        known.unwrap_or_else(|| contact_load(task * n + k, neighbours, contacts));
                    let new_force = contact_force + gravity * mass[k];
                    let (velocity, spin) = (&mut velocity[k], &mut spin[k]);
                    velocity.vector += (new_force - force[k]) * (correction * velocity.scalar);
                    spin.vector += (new_torque - torque[k]) * (correction * spin.scalar);
                    force[k] = new_force;
                    torque[k] = new_torque;
                    if !(velocity.vector.is_finite()
                        && spin.vector.is_finite()
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

/// The first half of a step of some grains, several at a time.
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

/// Places of the lanes from grain `k` on, `width` numbers each; lanes beyond the end repeat the last grain.
#[inline(always)]
fn places<L: Lanes>(count: usize, k: usize, width: usize) -> Places {
    let mut places = [0; MOST_LANES];
    let mut lane = 0;
    while lane < L::COUNT {
        places[lane] = width * (k + lane).min(count - 1);
        lane += 1;
    }
    places
}

/// A vector per lane out of plain numbers.
#[inline(always)]
fn gather<L: Lanes>(values: &[f64], mut places: Places) -> L::Vector {
    let x = L::gather(values, &places);
    let mut lane = 0;
    while lane < L::COUNT {
        places[lane] += 1;
        lane += 1;
    }
    let y = L::gather(values, &places);
    lane = 0;
    while lane < L::COUNT {
        places[lane] += 1;
        lane += 1;
    }
    L::Vector::new(x, y, L::gather(values, &places))
}

/// Puts rows of vectors with a number into a slice.
#[inline(always)]
fn put<L: Lanes>(rows: &mut [Row], vector: L::Vector, scalar: L) {
    let [x, y, z] = vector.components();
    let columns = L::rows([x, y, z, scalar]);
    for (row, new) in rows.iter_mut().zip(columns.as_ref()) {
        *row = bytemuck::cast(*new);
    }
}

impl Kernel for Drift<'_> {
    type Output = Motion;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Motion {
        let (dt, half) = (self.dt, 0.5 * self.dt);
        let (lower, upper) = self.domain.allowed();
        let count = self.position.len();
        let (force, torque) = (bytemuck::cast_slice(self.force), bytemuck::cast_slice(self.torque));
        let reference = bytemuck::cast_slice(self.reference);
        let (mut speed2, mut displacement2) = (L::splat(0.0), L::splat(0.0));
        let mut misplaced = None;
        for k in (0..count).step_by(L::COUNT) {
            let (rows, vectors) = (places::<L>(count, k, 4), places::<L>(count, k, 3));
            let here = k..(k + L::COUNT).min(count);
            let [x, y, z, radius] = L::columns(bytemuck::cast_slice(self.position), &rows);
            let [vx, vy, vz, inverse_mass] = L::columns(bytemuck::cast_slice(self.velocity), &rows);
            let [wx, wy, wz, inverse_inertia] = L::columns(bytemuck::cast_slice(self.spin), &rows);
            let orientation = L::columns(bytemuck::cast_slice(self.orientation), &rows);
            let kick = gather::<L>(force, vectors) * (inverse_mass * half);
            let middle = L::Vector::new(vx, vy, vz) + kick;
            let place = L::Vector::new(x, y, z) + middle * L::splat(dt);
            let velocity = middle + kick;
            let twist = gather::<L>(torque, vectors) * (inverse_inertia * half);
            let middle_spin = L::Vector::new(wx, wy, wz) + twist;
            let turned = L::rows(rotate_wide::<L>(orientation, middle_spin, dt));
            put::<L>(&mut self.position[here.clone()], place, radius);
            put::<L>(&mut self.velocity[here.clone()], velocity, inverse_mass);
            put::<L>(&mut self.spin[here.clone()], middle_spin + twist, inverse_inertia);
            for (orientation, turned) in self.orientation[here].iter_mut().zip(turned.as_ref()) {
                *orientation = DQuat::from_array(*turned);
            }
            speed2 = velocity.square().max(speed2);
            displacement2 = (place - gather::<L>(reference, vectors)).square().max(displacement2);
            let [x, y, z] = place.components();
            let inside = x.ge(L::splat(lower.x)) & y.ge(L::splat(lower.y)) & z.ge(L::splat(lower.z));
            let inside = inside & L::splat(upper.x).ge(x) & L::splat(upper.y).ge(y) & L::splat(upper.z).ge(z);
            if (!inside).any() && misplaced.is_none() {
                let lane = (!inside).bits().trailing_zeros() as usize;
                misplaced = Some(self.first + (k + lane).min(count - 1));
            }
        }
        Motion {
            max_speed: largest(speed2).sqrt(),
            max_displacement: largest(displacement2).sqrt(),
            misplaced,
        }
    }
}

/// The largest of all lanes, which are not negative.
#[inline(always)]
fn largest<L: Lanes>(lanes: L) -> f64 {
    lanes.to_array().into_iter().fold(0.0, f64::max)
}
