//! Velocity Verlet.

use super::{GRAINS_PER_TASK, Motion, first_by_id};
use crate::contacts::sum::GrainSums;
use crate::particles::Domain;
use crate::particles::spread::{GRAINS_OF_A_SPREAD, Spread};
use crate::simulation::Simulation;
use crate::threads::{Divisible, divide};
use demeter_physics::integrator::rotate_wide;
use demeter_physics::lanes::{self, Kernel, Lanes, MOST_LANES, Quad, Vector};
use glam::{DQuat, DVec3};
use std::ops::Range;

impl Simulation {
    /// Half kick, drift, and the predicted velocity of some grains; orientations turn.
    pub(super) fn drift(&mut self, some: Range<usize>) -> Motion {
        let dt = self.dt;
        let domain = *self.comm.domain();
        let instructions = self.instructions;
        let grains = &mut self.grains;
        let all = Drift {
            first: some.start,
            spreads: &mut self.spreads[some.start / GRAINS_OF_A_SPREAD..some.end.div_ceil(GRAINS_OF_A_SPREAD)],
            position: &mut grains.position.table_mut()[some.clone()],
            velocity: &mut grains.velocity.table_mut()[some.clone()],
            spin: &mut grains.angular_velocity.table_mut()[some.clone()],
            orientation: &mut grains.orientation[some.clone()],
            force: &grains.force.table()[some.clone()],
            torque: &grains.torque.table()[some.clone()],
            reference: &self.neighbours.reference.table()[some],
            dt,
            domain: &domain,
        };
        let drift = |some: Drift| lanes::run(instructions, some);
        divide(all, GRAINS_OF_A_SPREAD, &drift, &Motion::merge)
    }

    /// Sum per grain, body force, and the kick over `correction` [s] that corrects the predicted velocity. Tells the first
    /// grain, by its id, with a value that is not a number.
    pub(super) fn kick(&mut self, correction: f64) -> Option<usize> {
        let (neighbours, walls, gravity) = (&self.neighbours, &self.contacts.walls, self.gravity);
        let (sums, instructions) = (&self.sums, self.instructions);
        let own = self.own_grains();
        let grains = &mut self.grains;
        let ids = &grains.id;
        let all = Kick {
            first: own.start,
            ids,
            velocity: &mut grains.velocity.table_mut()[own.clone()],
            spin: &mut grains.angular_velocity.table_mut()[own.clone()],
            force: &mut grains.force.table_mut()[own.clone()],
            torque: &mut grains.torque.table_mut()[own.clone()],
            mass: &grains.mass[own.clone()],
            sums: GrainSums::new(sums, neighbours, walls).behind(own.start),
            gravity,
            correction,
        };
        let kick = |some: Kick| lanes::run(instructions, some);
        divide(all, GRAINS_PER_TASK, &kick, &|one, other| first_by_id(ids, one, other))
    }
}

/// The first half of a step of some grains.
struct Drift<'a> {
    /// Index of the first of them.
    first: usize,
    spreads: &'a mut [Spread],
    position: &'a mut [[f64; 4]],
    velocity: &'a mut [[f64; 4]],
    spin: &'a mut [[f64; 4]],
    orientation: &'a mut [DQuat],
    force: &'a [[f64; 4]],
    torque: &'a [[f64; 4]],
    reference: &'a [[f64; 4]],
    dt: f64,
    domain: &'a Domain,
}

impl Divisible for Drift<'_> {
    fn len(&self) -> usize {
        self.position.len()
    }

    fn split(self, first: usize) -> (Self, Self) {
        let (spreads, other_spreads) = self.spreads.split_at_mut(first / GRAINS_OF_A_SPREAD);
        let (position, positions) = self.position.split_at_mut(first);
        let (velocity, velocities) = self.velocity.split_at_mut(first);
        let (spin, spins) = self.spin.split_at_mut(first);
        let (orientation, orientations) = self.orientation.split_at_mut(first);
        let (force, forces) = self.force.split_at(first);
        let (torque, torques) = self.torque.split_at(first);
        let (reference, references) = self.reference.split_at(first);
        let others = Self {
            first: self.first + first,
            spreads: other_spreads,
            position: positions,
            velocity: velocities,
            spin: spins,
            orientation: orientations,
            force: forces,
            torque: torques,
            reference: references,
            ..self
        };
        let some = Self {
            spreads,
            position,
            velocity,
            spin,
            orientation,
            force,
            torque,
            reference,
            ..self
        };
        (some, others)
    }
}

/// A vector and what stands beside it.
#[inline(always)]
fn row<Q: Quad>(vector: DVec3, beside: f64) -> Q {
    Q::load(&[vector.x, vector.y, vector.z, beside])
}

impl Kernel for Drift<'_> {
    type Output = Motion;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Motion {
        let (dt, half) = (self.dt, 0.5 * self.dt);
        let (lower, upper) = self.domain.allowed();
        let (lower, upper): (L::Quad, L::Quad) = (row(lower, f64::NEG_INFINITY), row(upper, f64::INFINITY));
        // what stands beside a vector stays
        let time = L::Quad::load(&[dt, dt, dt, 0.0]);
        let count = self.position.len();
        // tables of one length: each index is checked once
        let (velocity, spin) = (&mut self.velocity[..count], &mut self.spin[..count]);
        let (force, torque) = (&self.force[..count], &self.torque[..count]);
        let reference = &self.reference[..count];
        let (mut of_middle, mut of_end) = (Bounds::<L::Quad>::nothing(), Bounds::<L::Quad>::nothing());
        let mut displacement2 = L::splat(0.0);
        let mut misplaced = None;
        for k in (0..count).step_by(L::COUNT) {
            let here = k..(k + L::COUNT).min(count);
            let (mut spins, mut displacements) = ([[0.0; 4]; MOST_LANES], [[0.0; 4]; MOST_LANES]);
            let rows = spins.iter_mut().zip(&mut displacements);
            for (g, (turning, displacement)) in here.clone().zip(rows) {
                let kick = L::Quad::load(&force[g]) * L::Quad::all(half * velocity[g][3]);
                let twist = L::Quad::load(&torque[g]) * L::Quad::all(half * spin[g][3]);
                let middle = L::Quad::load(&velocity[g]) + kick;
                let middle_spin = L::Quad::load(&spin[g]) + twist;
                let place = L::Quad::load(&self.position[g]) + middle * time;
                let ahead = middle + kick;
                self.position[g] = place.store();
                velocity[g] = ahead.store();
                spin[g] = (middle_spin + twist).store();
                *turning = middle_spin.store();
                *displacement = (place - L::Quad::load(&reference[g])).store();
                of_end.include(ahead);
                of_middle.include(middle);
                if !place.lies_within(lower, upper) && misplaced.is_none() {
                    misplaced = Some(self.first + g);
                }
            }
            let [x, y, z, _] = L::strided(displacements.as_flattened(), 0, 4);
            // what is not a number is told as misplaced
            displacement2 = L::Vector::new(x, y, z).square().max(displacement2);
            turn::<L>(&mut self.orientation[here], &spins, dt);
        }
        let displacement2 = displacement2.to_array().into_iter().fold(0.0, f64::max);
        let (middle, ahead) = (of_middle.spread(), of_end.spread());
        // a piece has a spread of its own
        if let Some(spread) = self.spreads.first_mut() {
            *spread = middle.join(ahead);
        }
        Motion {
            max_speed: ahead.speed(),
            max_step: middle.speed() * dt,
            max_displacement: displacement2.sqrt(),
            misplaced,
        }
    }
}

/// Turns as many grains as there are lanes, or fewer, at these angular velocities.
#[inline(always)]
fn turn<L: Lanes>(orientation: &mut [DQuat], spins: &[[f64; 4]; MOST_LANES], dt: f64) {
    let numbers: &mut [f64] = bytemuck::cast_slice_mut(orientation);
    if numbers.len() == 4 * L::COUNT {
        return turn_all::<L>(numbers, spins, dt);
    }
    let mut some = [0.0; 4 * MOST_LANES];
    some[..numbers.len()].copy_from_slice(numbers);
    turn_all::<L>(&mut some, spins, dt);
    numbers.copy_from_slice(&some[..numbers.len()]);
}

#[inline(always)]
fn turn_all<L: Lanes>(orientations: &mut [f64], spins: &[[f64; 4]; MOST_LANES], dt: f64) {
    let [x, y, z, _] = L::strided(spins.as_flattened(), 0, 4);
    let turned = rotate_wide::<L>(L::strided(orientations, 0, 4), L::Vector::new(x, y, z), dt);
    L::put_strided(turned, orientations, 0, 4);
}

/// Bounds of velocities, the lower with the other sign.
struct Bounds<Q> {
    upper: Q,
    lower: Q,
}

impl<Q: Quad> Bounds<Q> {
    #[inline(always)]
    fn nothing() -> Self {
        let nothing = Q::all(f64::NEG_INFINITY);
        Self {
            upper: nothing,
            lower: nothing,
        }
    }

    #[inline(always)]
    fn include(&mut self, velocity: Q) {
        self.upper = self.upper.larger(velocity);
        self.lower = self.lower.larger(velocity * Q::all(-1.0));
    }

    fn spread(&self) -> Spread {
        let vector = |[x, y, z, _]: [f64; 4]| DVec3::new(x, y, z);
        Spread {
            lower: -vector(self.lower.store()),
            upper: vector(self.upper.store()),
        }
    }
}

/// The second half of a step of some grains.
struct Kick<'a> {
    /// Index of the first of them.
    first: usize,
    ids: &'a [u32],
    velocity: &'a mut [[f64; 4]],
    spin: &'a mut [[f64; 4]],
    force: &'a mut [[f64; 4]],
    torque: &'a mut [[f64; 4]],
    mass: &'a [f64],
    sums: GrainSums<'a>,
    gravity: DVec3,
    correction: f64,
}

impl Divisible for Kick<'_> {
    fn len(&self) -> usize {
        self.mass.len()
    }

    fn split(self, first: usize) -> (Self, Self) {
        let (velocity, velocities) = self.velocity.split_at_mut(first);
        let (spin, spins) = self.spin.split_at_mut(first);
        let (force, forces) = self.force.split_at_mut(first);
        let (torque, torques) = self.torque.split_at_mut(first);
        let (mass, masses) = self.mass.split_at(first);
        let others = Self {
            first: self.first + first,
            velocity: velocities,
            spin: spins,
            force: forces,
            torque: torques,
            mass: masses,
            sums: self.sums.behind(first),
            ..self
        };
        let some = Self {
            velocity,
            spin,
            force,
            torque,
            mass,
            ..self
        };
        (some, others)
    }
}

impl Kernel for Kick<'_> {
    type Output = Option<usize>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Option<usize> {
        let gravity: L::Quad = row(self.gravity, 0.0);
        let finite = (L::Quad::all(f64::MIN), L::Quad::all(f64::MAX));
        let mut bad = None;
        let count = self.mass.len();
        let (velocity, spin) = (&mut self.velocity[..count], &mut self.spin[..count]);
        let (force, torque) = (&mut self.force[..count], &mut self.torque[..count]);
        for (k, &mass) in self.mass.iter().enumerate() {
            let (contact_force, new_torque) = self.sums.of::<L::Quad>(k);
            let new_force = contact_force + gravity * L::Quad::all(mass);
            let change = (new_force - L::Quad::load(&force[k])) * L::Quad::all(self.correction * velocity[k][3]);
            let twist = (new_torque - L::Quad::load(&torque[k])) * L::Quad::all(self.correction * spin[k][3]);
            let (new_velocity, new_spin) = (L::Quad::load(&velocity[k]) + change, L::Quad::load(&spin[k]) + twist);
            velocity[k] = new_velocity.store();
            spin[k] = new_spin.store();
            force[k] = new_force.store();
            torque[k] = new_torque.store();
            // a sum is finite only where all are
            let all = (new_velocity + new_spin) + (new_force + new_torque);
            if !all.lies_within(finite.0, finite.1) {
                let values = [velocity[k], spin[k], force[k], torque[k]];
                if values.as_flattened().iter().any(|value| !value.is_finite()) {
                    bad = first_by_id(self.ids, bad, Some(self.first + k));
                }
            }
        }
        bad
    }
}
