//! Velocity Verlet. The kick that ends a step and the drift that begins the next take one pass where nobody looks at the grains in
//! between; the bits are the same.

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
    /// Half kick, drift, and the predicted velocity of some grains; orientations turn. Where the latest step awaits its kick, it comes
    /// first.
    pub(super) fn drift(&mut self, some: Range<usize>) -> Motion {
        let (dt, domain, instructions) = (self.dt, *self.comm.domain(), self.instructions);
        let grains = &mut self.grains;
        let ids = &grains.id;
        let (force, torque) = (
            &mut grains.force.table_mut()[some.clone()],
            &mut grains.torque.table_mut()[some.clone()],
        );
        let moved = Moved {
            first: some.start,
            spreads: &mut self.spreads[some.start / GRAINS_OF_A_SPREAD..some.end.div_ceil(GRAINS_OF_A_SPREAD)],
            position: &mut grains.position.table_mut()[some.clone()],
            velocity: &mut grains.velocity.table_mut()[some.clone()],
            spin: &mut grains.angular_velocity.table_mut()[some.clone()],
            orientation: &mut grains.orientation[some.clone()],
            reference: &self.neighbours.reference.table()[some.clone()],
            dt,
            domain: &domain,
        };
        let merge = |one: Motion, other: Motion| one.merge(other, ids);
        if !self.awaits_kick {
            let forces = Told { force, torque };
            let drift = |some: Drift<Told>| lanes::run(instructions, some);
            return divide(Drift { moved, forces }, GRAINS_OF_A_SPREAD, &drift, &merge);
        }
        let forces = Summed {
            first: some.start,
            ids,
            force,
            torque,
            sums: GrainSums::from(some.start, &self.sums),
            mass: &grains.mass[some],
            gravity: self.gravity,
            correction: 0.5 * dt,
            bad: None,
        };
        let drift = |some: Drift<Summed>| lanes::run(instructions, some);
        divide(Drift { moved, forces }, GRAINS_OF_A_SPREAD, &drift, &merge)
    }

    /// Sum per grain, body force, and the kick over `correction` [s] that corrects the predicted velocity. Tells the first
    /// grain, by its id, with a value that is not a number.
    pub(super) fn kick(&mut self, correction: f64) -> Option<usize> {
        let (sums, gravity, instructions) = (&self.sums, self.gravity, self.instructions);
        let own = self.own_grains();
        let grains = &mut self.grains;
        let ids = &grains.id;
        let all = Kick {
            velocity: &mut grains.velocity.table_mut()[own.clone()],
            spin: &mut grains.angular_velocity.table_mut()[own.clone()],
            forces: Summed {
                first: own.start,
                ids,
                force: &mut grains.force.table_mut()[own.clone()],
                torque: &mut grains.torque.table_mut()[own.clone()],
                mass: &grains.mass[own.clone()],
                sums: GrainSums::from(own.start, sums),
                gravity,
                correction,
                bad: None,
            },
        };
        let kick = |some: Kick| lanes::run(instructions, some);
        divide(all, GRAINS_PER_TASK, &kick, &|one, other| first_by_id(ids, one, other))
    }
}

/// Motion and loads of one grain at the beginning of a step; what stands beside vectors stays.
struct State<Q> {
    velocity: Q,
    spin: Q,
    force: Q,
    torque: Q,
}

/// Where the loads on some grains come from.
trait Forces: Sized + Send {
    /// Those on the first so many, and on the others.
    fn split(self, first: usize) -> (Self, Self);

    /// How a grain moves, and what acts on it, told its velocity and angular velocity as they stand in the tables.
    fn begin<Q: Quad>(&mut self, k: usize, velocity: &[f64; 4], spin: &[f64; 4]) -> State<Q>;

    /// The first grain, by its id, with a value that is not a number.
    fn bad(&self) -> Option<usize>;
}

/// Loads as they stand in the tables.
struct Told<'a> {
    force: &'a [[f64; 4]],
    torque: &'a [[f64; 4]],
}

impl Forces for Told<'_> {
    fn split(self, first: usize) -> (Self, Self) {
        let (force, forces) = self.force.split_at(first);
        let (torque, torques) = self.torque.split_at(first);
        let others = Self {
            force: forces,
            torque: torques,
        };
        (Self { force, torque }, others)
    }

    #[inline(always)]
    fn begin<Q: Quad>(&mut self, k: usize, velocity: &[f64; 4], spin: &[f64; 4]) -> State<Q> {
        State {
            velocity: Q::load(velocity),
            spin: Q::load(spin),
            force: Q::load(&self.force[k]),
            torque: Q::load(&self.torque[k]),
        }
    }

    fn bad(&self) -> Option<usize> {
        None
    }
}

/// Loads that are summed up now, with which predicted velocities are corrected.
struct Summed<'a> {
    /// Index of the first grain.
    first: usize,
    ids: &'a [u32],
    force: &'a mut [[f64; 4]],
    torque: &'a mut [[f64; 4]],
    mass: &'a [f64],
    sums: GrainSums<'a>,
    gravity: DVec3,
    correction: f64,
    bad: Option<usize>,
}

impl Forces for Summed<'_> {
    fn split(self, first: usize) -> (Self, Self) {
        let (force, forces) = self.force.split_at_mut(first);
        let (torque, torques) = self.torque.split_at_mut(first);
        let (mass, masses) = self.mass.split_at(first);
        let others = Self {
            first: self.first + first,
            force: forces,
            torque: torques,
            mass: masses,
            sums: self.sums.behind(first),
            ..self
        };
        let some = Self {
            force,
            torque,
            mass,
            ..self
        };
        (some, others)
    }

    #[inline(always)]
    fn begin<Q: Quad>(&mut self, k: usize, velocity: &[f64; 4], spin: &[f64; 4]) -> State<Q> {
        let (contact_force, new_torque) = self.sums.of::<Q>(k);
        let new_force = contact_force + row::<Q>(self.gravity, 0.0) * Q::all(self.mass[k]);
        let change = (new_force - Q::load(&self.force[k])) * Q::all(self.correction * velocity[3]);
        let twist = (new_torque - Q::load(&self.torque[k])) * Q::all(self.correction * spin[3]);
        let (new_velocity, new_spin) = (Q::load(velocity) + change, Q::load(spin) + twist);
        self.force[k] = new_force.store();
        self.torque[k] = new_torque.store();
        // a sum is finite only where all are
        let all = (new_velocity + new_spin) + (new_force + new_torque);
        if !all.lies_within(Q::all(f64::MIN), Q::all(f64::MAX)) {
            let values = [new_velocity.store(), new_spin.store(), self.force[k], self.torque[k]];
            if values.as_flattened().iter().any(|value| !value.is_finite()) {
                self.bad = first_by_id(self.ids, self.bad, Some(self.first + k));
            }
        }
        State {
            velocity: new_velocity,
            spin: new_spin,
            force: new_force,
            torque: new_torque,
        }
    }

    fn bad(&self) -> Option<usize> {
        self.bad
    }
}

/// What changes when grains move.
struct Moved<'a> {
    /// Index of the first of them.
    first: usize,
    spreads: &'a mut [Spread],
    position: &'a mut [[f64; 4]],
    velocity: &'a mut [[f64; 4]],
    spin: &'a mut [[f64; 4]],
    orientation: &'a mut [DQuat],
    reference: &'a [[f64; 4]],
    dt: f64,
    domain: &'a Domain,
}

/// The first half of a step of some grains.
struct Drift<'a, F> {
    moved: Moved<'a>,
    forces: F,
}

impl<F: Forces> Divisible for Drift<'_, F> {
    fn len(&self) -> usize {
        self.moved.position.len()
    }

    fn split(self, first: usize) -> (Self, Self) {
        let (forces, other_forces) = self.forces.split(first);
        let all = self.moved;
        let (spreads, other_spreads) = all.spreads.split_at_mut(first / GRAINS_OF_A_SPREAD);
        let (position, positions) = all.position.split_at_mut(first);
        let (velocity, velocities) = all.velocity.split_at_mut(first);
        let (spin, spins) = all.spin.split_at_mut(first);
        let (orientation, orientations) = all.orientation.split_at_mut(first);
        let (reference, references) = all.reference.split_at(first);
        let others = Moved {
            first: all.first + first,
            spreads: other_spreads,
            position: positions,
            velocity: velocities,
            spin: spins,
            orientation: orientations,
            reference: references,
            ..all
        };
        let some = Moved {
            spreads,
            position,
            velocity,
            spin,
            orientation,
            reference,
            ..all
        };
        let others = Self {
            moved: others,
            forces: other_forces,
        };
        (Self { moved: some, forces }, others)
    }
}

/// A vector and what stands beside it.
#[inline(always)]
fn row<Q: Quad>(vector: DVec3, beside: f64) -> Q {
    Q::load(&[vector.x, vector.y, vector.z, beside])
}

impl<F: Forces> Kernel for Drift<'_, F> {
    type Output = Motion;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Motion {
        let Self { moved, mut forces } = self;
        let Moved { first, dt, .. } = moved;
        let half = 0.5 * dt;
        let (lower, upper) = moved.domain.allowed();
        let (lower, upper): (L::Quad, L::Quad) = (row(lower, f64::NEG_INFINITY), row(upper, f64::INFINITY));
        // what stands beside a vector stays
        let time = L::Quad::load(&[dt, dt, dt, 0.0]);
        let count = moved.position.len();
        // tables of one length: each index is checked once
        let (velocity, spin) = (&mut moved.velocity[..count], &mut moved.spin[..count]);
        let (position, reference) = (&mut moved.position[..count], &moved.reference[..count]);
        let (mut of_middle, mut of_end) = (Bounds::<L::Quad>::nothing(), Bounds::<L::Quad>::nothing());
        let mut displacement2 = L::splat(0.0);
        let mut misplaced = None;
        // behind the last grain they still hold what was there before, which counts no more
        let (mut spins, mut displacements) = ([[0.0; 4]; MOST_LANES], [[0.0; 4]; MOST_LANES]);
        for k in (0..count).step_by(L::COUNT) {
            let here = k..(k + L::COUNT).min(count);
            let rows = spins.iter_mut().zip(&mut displacements);
            for (g, (turning, displacement)) in here.clone().zip(rows) {
                let now = forces.begin::<L::Quad>(g, &velocity[g], &spin[g]);
                let kick = now.force * L::Quad::all(half * velocity[g][3]);
                let twist = now.torque * L::Quad::all(half * spin[g][3]);
                let middle = now.velocity + kick;
                let middle_spin = now.spin + twist;
                let place = L::Quad::load(&position[g]) + middle * time;
                let ahead = middle + kick;
                position[g] = place.store();
                velocity[g] = ahead.store();
                spin[g] = (middle_spin + twist).store();
                *turning = middle_spin.store();
                *displacement = (place - L::Quad::load(&reference[g])).store();
                of_end.include(ahead);
                of_middle.include(middle);
                if !place.lies_within(lower, upper) && misplaced.is_none() {
                    misplaced = Some(first + g);
                }
            }
            let [x, y, z, _] = L::strided(displacements.as_flattened(), 0, 4);
            // what is not a number is told as misplaced
            displacement2 = L::Vector::new(x, y, z).square().max(displacement2);
            turn::<L>(&mut moved.orientation[here], &spins, dt);
        }
        let displacement2 = displacement2.to_array().into_iter().fold(0.0, f64::max);
        let (middle, ahead) = (of_middle.spread(), of_end.spread());
        // a piece has a spread of its own
        if let Some(spread) = moved.spreads.first_mut() {
            *spread = middle.join(ahead);
        }
        Motion {
            max_speed: ahead.speed(),
            max_step: middle.speed() * dt,
            max_displacement: displacement2.sqrt(),
            misplaced,
            bad: forces.bad(),
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
    velocity: &'a mut [[f64; 4]],
    spin: &'a mut [[f64; 4]],
    forces: Summed<'a>,
}

impl Divisible for Kick<'_> {
    fn len(&self) -> usize {
        self.velocity.len()
    }

    fn split(self, first: usize) -> (Self, Self) {
        let (velocity, velocities) = self.velocity.split_at_mut(first);
        let (spin, spins) = self.spin.split_at_mut(first);
        let (forces, other_forces) = self.forces.split(first);
        let others = Self {
            velocity: velocities,
            spin: spins,
            forces: other_forces,
        };
        let some = Self { velocity, spin, forces };
        (some, others)
    }
}

impl Kernel for Kick<'_> {
    type Output = Option<usize>;

    #[inline(always)]
    fn run<L: Lanes>(mut self) -> Option<usize> {
        for (k, (velocity, spin)) in self.velocity.iter_mut().zip(&mut *self.spin).enumerate() {
            let now = self.forces.begin::<L::Quad>(k, velocity, spin);
            *velocity = now.velocity.store();
            *spin = now.spin.store();
        }
        self.forces.bad
    }
}
