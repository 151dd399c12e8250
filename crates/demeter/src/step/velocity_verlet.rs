//! Velocity Verlet. The kick that ends a step and the drift that begins the next take one pass where nobody looks at the grains in
//! between; the bits are the same.

use super::{GRAINS_PER_TASK, Motion, first_by_id};
use crate::particles::spread::{GRAINS_OF_A_SPREAD, Spread};
use crate::particles::{Domain, HalfKick, Load};
use crate::simulation::Simulation;
use crate::threads::{Divisible, divide_at, inside};
use demeter_physics::integrator::rotate_wide;
use demeter_physics::lanes::{self, Kernel, Lanes, MOST_LANES, Quad, Vector};
use glam::{DQuat, DVec3};
use std::ops::Range;

impl Simulation {
    /// Half kick, drift, and the predicted velocity of some grains; orientations turn where they are followed. Where the latest step
    /// awaits its kick, it comes first.
    pub(super) fn drift(&mut self, some: Range<usize>) -> Motion {
        let (dt, domain, instructions) = (self.dt, *self.comm.domain(), self.instructions);
        let grains = &mut self.grains;
        let ids = &grains.id;
        let loads = &grains.load.rows()[some.clone()];
        let moved = Moved {
            first: some.start,
            spreads: &mut self.spreads[some.start / GRAINS_OF_A_SPREAD..some.end.div_ceil(GRAINS_OF_A_SPREAD)],
            position: &mut grains.position.table_mut()[some.clone()],
            velocity: &mut grains.velocity.table_mut()[some.clone()],
            spin: &mut grains.angular_velocity.table_mut()[some.clone()],
            half_kicks: &mut grains.half_kicks.0[some.clone()],
            orientation: grains.orientation.as_mut().map(|all| &mut all[some.clone()]),
            dt,
            domain: &domain,
        };
        let at = (some.start, inside(self.sums.shares.first_grains(), &some));
        let merge = |one: Motion, other: Motion| one.merge(other, ids);
        if !self.awaits_kick {
            let forces = Told(loads);
            let drift = |some: Drift<Told>| lanes::run(instructions, some);
            return divide_at(at, Drift { moved, forces }, GRAINS_OF_A_SPREAD, &drift, &merge);
        }
        let forces = Summed {
            first: some.start,
            ids,
            loads,
            gravity: self.gravity,
            kick: 0.5 * dt,
            bad: None,
        };
        let drift = |some: Drift<Summed>| lanes::run(instructions, some);
        divide_at(at, Drift { moved, forces }, GRAINS_OF_A_SPREAD, &drift, &merge)
    }

    /// Body force, and the half kick over `kick` [s] in place of the one that was foreseen. Tells the first grain, by its id, with a
    /// value that is not a number.
    pub(super) fn kick(&mut self, kick: f64) -> Option<usize> {
        let (gravity, instructions) = (self.gravity, self.instructions);
        let own = self.own_grains();
        let grains = &mut self.grains;
        grains.foresee_half_kicks();
        let ids = &grains.id;
        let all = Kick {
            first: own.start,
            velocity: &mut grains.velocity.table_mut()[own.clone()],
            spin: &mut grains.angular_velocity.table_mut()[own.clone()],
            half_kicks: &grains.half_kicks.0[own.clone()],
            loads: &mut grains.load.rows_mut()[own.clone()],
            ids,
            gravity,
            kick,
        };
        let at = (own.start, inside(self.sums.shares.first_grains(), &own));
        let kick = |some: Kick| lanes::run(instructions, some);
        divide_at(at, all, GRAINS_PER_TASK, &kick, &|one, other| {
            first_by_id(ids, one, other)
        })
    }
}

/// How a grain moves at the beginning of a step, and the half kick of what acts on it; what stands beside vectors stays.
struct State<Q> {
    velocity: Q,
    spin: Q,
    kick: Q,
    twist: Q,
}

/// Where the loads on some grains come from.
trait Forces: Sized + Send {
    /// Those on the first so many, and on the others.
    fn split(self, first: usize) -> (Self, Self);

    /// How a grain moves, told its rows of velocity and angular velocity, the half kick foreseen, and half a step [s].
    fn begin<Q: Quad>(&mut self, k: usize, rows: [&[f64; 4]; 2], foreseen: &HalfKick, half: f64) -> State<Q>;

    /// The first grain, by its id, with a value that is not a number.
    fn bad(&self) -> Option<usize>;
}

/// Loads as they stand in the tables.
struct Told<'a>(&'a [Load]);

impl Forces for Told<'_> {
    fn split(self, first: usize) -> (Self, Self) {
        let (some, others) = self.0.split_at(first);
        (Self(some), Self(others))
    }

    #[inline(always)]
    fn begin<Q: Quad>(&mut self, k: usize, [velocity, spin]: [&[f64; 4]; 2], _: &HalfKick, half: f64) -> State<Q> {
        let [force, torque] = self.0[k].parts();
        State {
            velocity: Q::load(velocity),
            spin: Q::load(spin),
            kick: Q::load(force) * (over::<Q>(half) * Q::all(velocity[3])),
            twist: Q::load(torque) * (over::<Q>(half) * Q::all(spin[3])),
        }
    }

    fn bad(&self) -> Option<usize> {
        None
    }
}

/// Loads of contacts that were summed up, whose half kick takes the place of the one foreseen.
struct Summed<'a> {
    /// Index of the first grain.
    first: usize,
    ids: &'a [u32],
    loads: &'a [Load],
    gravity: DVec3,
    /// Length of the half kick [s].
    kick: f64,
    bad: Option<usize>,
}

/// A time [s] over which vectors act; what stands beside them does not.
#[inline(always)]
fn over<Q: Quad>(time: f64) -> Q {
    Q::load(&[time, time, time, 0.0])
}

/// How a grain moves after a half kick over some time [s] by what contacts and gravity [m/s^2] do, in place of the one that was foreseen;
/// and what acts on it, gravity added, with what stands beside it.
#[inline(always)]
fn kicked<Q: Quad>(
    load: &Load,
    gravity: Q,
    [velocity, spin]: [&[f64; 4]; 2],
    HalfKick(foreseen): &HalfKick,
    time: f64,
) -> (State<Q>, [Q; 2]) {
    let [force, torque] = load.parts();
    let (force, torque) = (Q::load(force) + gravity * Q::all(load.mass()), Q::load(torque));
    let [kick, twist] = Q::of_singles(foreseen);
    let (middle, middle_spin) = (Q::load(velocity) - kick, Q::load(spin) - twist);
    let time = over::<Q>(time);
    let (kick, twist) = (force * (time * Q::all(velocity[3])), torque * (time * Q::all(spin[3])));
    let state = State {
        velocity: middle + kick,
        spin: middle_spin + twist,
        kick,
        twist,
    };
    (state, [force, torque])
}

/// Whether any value of a grain is not a number.
#[inline(always)]
fn is_bad<Q: Quad>(state: &State<Q>, [force, torque]: [Q; 2]) -> bool {
    // a sum is finite only where all are
    let all = (state.velocity + state.spin) + (force + torque);
    !all.lies_within(Q::all(f64::MIN), Q::all(f64::MAX)) && {
        let values = [
            state.velocity.store(),
            state.spin.store(),
            force.store(),
            torque.store(),
        ];
        values.as_flattened().iter().any(|value| !value.is_finite())
    }
}

impl Forces for Summed<'_> {
    fn split(self, first: usize) -> (Self, Self) {
        let (loads, other_loads) = self.loads.split_at(first);
        let others = Self {
            first: self.first + first,
            loads: other_loads,
            ..self
        };
        (Self { loads, ..self }, others)
    }

    #[inline(always)]
    fn begin<Q: Quad>(&mut self, k: usize, rows: [&[f64; 4]; 2], foreseen: &HalfKick, _: f64) -> State<Q> {
        let (state, loads) = kicked(&self.loads[k], row(self.gravity, 0.0), rows, foreseen, self.kick);
        if is_bad(&state, loads) {
            self.bad = first_by_id(self.ids, self.bad, Some(self.first + k));
        }
        state
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
    /// Those that the latest step foresaw, and then those of this one.
    half_kicks: &'a mut [HalfKick],
    orientation: Option<&'a mut [DQuat]>,
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
        let (half_kicks, other_kicks) = all.half_kicks.split_at_mut(first);
        let (orientation, orientations) = all.orientation.map(|all| all.split_at_mut(first)).unzip();
        let others = Moved {
            first: all.first + first,
            spreads: other_spreads,
            position: positions,
            velocity: velocities,
            spin: spins,
            half_kicks: other_kicks,
            orientation: orientations,
            ..all
        };
        let some = Moved {
            spreads,
            position,
            velocity,
            spin,
            half_kicks,
            orientation,
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
        let Self { mut moved, mut forces } = self;
        let Moved { first, dt, .. } = moved;
        let half = 0.5 * dt;
        let (lower, upper) = moved.domain.allowed();
        let (lower, upper): (L::Quad, L::Quad) = (row(lower, f64::NEG_INFINITY), row(upper, f64::INFINITY));
        let time = over::<L::Quad>(dt);
        let count = moved.position.len();
        // tables of one length: each index is checked once
        let (velocity, spin) = (&mut moved.velocity[..count], &mut moved.spin[..count]);
        let (position, half_kicks) = (&mut moved.position[..count], &mut moved.half_kicks[..count]);
        let (mut of_middle, mut of_end) = (Bounds::<L::Quad>::nothing(), Bounds::<L::Quad>::nothing());
        let mut of_kick = L::Quad::all(0.0);
        let mut misplaced = None;
        // behind the last grain it still holds what was there before, which counts no more
        let mut spins = [[0.0; 4]; MOST_LANES];
        for k in (0..count).step_by(L::COUNT) {
            let here = k..(k + L::COUNT).min(count);
            for (g, turning) in here.clone().zip(&mut spins) {
                let now = forces.begin::<L::Quad>(g, [&velocity[g], &spin[g]], &half_kicks[g], half);
                let middle = now.velocity + now.kick;
                let middle_spin = now.spin + now.twist;
                let place = L::Quad::load(&position[g]) + middle * time;
                // the velocity that is foreseen needs no more than singles, which take half the memory until the kick is known
                L::Quad::put_singles(now.kick, now.twist, &mut half_kicks[g].0);
                let ahead = middle + now.kick.rounded();
                position[g] = place.store();
                velocity[g] = ahead.store();
                spin[g] = (middle_spin + now.twist.rounded()).store();
                *turning = middle_spin.store();
                of_end.include(ahead);
                of_middle.include(middle);
                of_kick = of_kick.larger(now.kick).larger(now.kick * L::Quad::all(-1.0));
                if !place.lies_within(lower, upper) && misplaced.is_none() {
                    misplaced = Some(first + g);
                }
            }
            if let Some(orientation) = &mut moved.orientation {
                turn::<L>(&mut orientation[here], &spins, dt);
            }
        }
        let (middle, ahead) = (of_middle.spread(), of_end.spread());
        // a piece has a spread of its own
        if let Some(spread) = moved.spreads.first_mut() {
            let [x, y, z, _] = of_kick.store();
            *spread = Spread {
                kick: DVec3::new(x, y, z).length(),
                ..middle.join(ahead)
            };
        }
        Motion {
            max_speed: ahead.speed(),
            max_step: middle.speed() * dt,
            by_box: 0.0,
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
            kick: 0.0,
        }
    }
}

/// The second half of a step of some grains.
struct Kick<'a> {
    /// Index of the first grain.
    first: usize,
    velocity: &'a mut [[f64; 4]],
    spin: &'a mut [[f64; 4]],
    half_kicks: &'a [HalfKick],
    /// Of contacts, and then with gravity.
    loads: &'a mut [Load],
    ids: &'a [u32],
    gravity: DVec3,
    /// Length of the half kick [s].
    kick: f64,
}

impl Divisible for Kick<'_> {
    fn len(&self) -> usize {
        self.velocity.len()
    }

    fn split(self, first: usize) -> (Self, Self) {
        let (velocity, velocities) = self.velocity.split_at_mut(first);
        let (spin, spins) = self.spin.split_at_mut(first);
        let (half_kicks, other_kicks) = self.half_kicks.split_at(first);
        let (loads, other_loads) = self.loads.split_at_mut(first);
        let others = Self {
            first: self.first + first,
            velocity: velocities,
            spin: spins,
            half_kicks: other_kicks,
            loads: other_loads,
            ..self
        };
        let some = Self {
            velocity,
            spin,
            half_kicks,
            loads,
            ..self
        };
        (some, others)
    }
}

impl Kernel for Kick<'_> {
    type Output = Option<usize>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Option<usize> {
        let mut bad = None;
        for (k, (velocity, spin)) in self.velocity.iter_mut().zip(self.spin).enumerate() {
            let (rows, gravity) = ([&*velocity, &*spin], row::<L::Quad>(self.gravity, 0.0));
            let (state, loads) = kicked(&self.loads[k], gravity, rows, &self.half_kicks[k], self.kick);
            if is_bad(&state, loads) {
                bad = first_by_id(self.ids, bad, Some(self.first + k));
            }
            self.loads[k] = Load(bytemuck::cast([loads[0].store(), loads[1].store()]));
            *velocity = state.velocity.store();
            *spin = state.spin.store();
        }
        bad
    }
}
