//! A box that deforms while the run goes on.
//!
//! Velocities are those in the frame in which the middle of the box rests. A grain that passes a side takes the velocity of
//! its image. Where the deformation is affine, every grain is also kicked by what the affine flow `G x` at its place
//! changes in a step, `dG x + G G x dt`, half of it before the forces are found and half after, as these forces act on both
//! sides of their moment: then `c = v - G x` obeys `dc/dt = F/m - G c`, as if the box deformed slowly whatever
//! its inertia (Evans and Morriss, Statistical Mechanics of Nonequilibrium Liquids, section 6.3), and no wave runs in from
//! the sides.
//!
//! **Work.** A contact across a side acts on both of its grains, whose images move against each other by `dS` in a step:
//! `-F dS` of work comes from outside, half of it with the force before the step and half with that after it, as velocity
//! Verlet does its work. Passing a side and the affine kick change kinetic energy; both are booked as they happen.

use super::deformation::{DRIVES, Deformation, DeformationError, Drive};
use super::shear_drive::ShearDrive;
use super::{Fault, Simulation};
use crate::comm::{Carry, Deforming, Rates, ShearAxes};
use crate::particles::Domain;
use crate::simulation::division::heard_grains;
use crate::step::{GRAINS_PER_TASK, Motion};
use crate::walls::Servo;
use glam::{DMat3, DVec3, Vec3Swizzles};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Of the drives, how many drive lengths: each direction, and all together. The shear comes behind.
const LENGTHS: usize = DRIVES - 1;

/// What rounding may take from a bound of the relative motion.
const SLACK: f64 = 1.001;

/// Share of a length within which a grain meets no two images of a partner: half, and what rounding takes of it.
pub(crate) const USABLE: f64 = 0.49;

/// Reach of the table of contacts beyond touching, as a share of the largest radius, at most (see `contacts/near.rs`).
const NEAR: f64 = 0.1;

/// How a box deforms, and what a restart needs of it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct DeformingBox {
    pub(super) plan: Deformation,
    /// Controllers of lengths that follow a stress.
    pub(super) servos: [Option<Servo>; LENGTHS],
    pub(super) shear_drive: Option<ShearDrive>,
    /// Lengths at the start of the run and of the stage [m].
    lengths: [DVec3; 2],
    /// Shear so far, and at the start of the stage.
    sheared: [f64; 2],
    /// What the controllers tell for the next step: a step ahead, so that forces are found at the flow of their moment [1/s].
    pending: [f64; DRIVES],
    /// Forces across the sides in the latest step [N].
    across: [DVec3; 3],
    /// How the box has deformed since the candidates were found.
    since: Carry,
    largest_radius: f64,
}

/// What a checkpoint holds of a box that deforms.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct DeformingState {
    domain: Domain,
    deforming: Deforming,
    state: DeformingBox,
}

impl DeformingState {
    /// Whether its numbers are possible, as they are unless a file was tampered with.
    pub(super) fn is_sound(&self, dt: f64) -> bool {
        let size = self.domain.size();
        let has_length = |k: usize| !self.domain.periodic[k] || (size[k] > 0.0 && size[k].is_finite());
        self.deforming.is_sound()
            && (0..3).all(has_length)
            && self.state.plan.check(self.domain.periodic, dt).is_ok()
            && self.state.largest_radius > 0.0
    }
}

/// What a box that deforms has come to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoxState {
    /// Lengths [m].
    pub lengths: DVec3,
    /// True strains `ln(L/L0)` since the start of the run, negative where the box has shrunk.
    pub strain: DVec3,
    /// The same since the start of the stage.
    pub stage_strain: DVec3,
    /// Shear since the start of the run.
    pub shear_strain: f64,
    /// Shear since the start of the stage.
    pub stage_shear_strain: f64,
    /// Rates of true strain in the latest step [1/s].
    pub strain_rate: DVec3,
    /// Rate of shear in the latest step [1/s].
    pub shear_rate: f64,
    /// Stress of the box with its kinetic part, compression positive: xx, yy, zz, xy, xz, yz [Pa].
    pub stress: [f64; 6],
    /// Kinetic part of the stress: of the motion beyond the affine flow and beyond the drift of all grains [Pa].
    pub kinetic_stress: [f64; 6],
    /// Solid volume over the volume of the box.
    pub solid_fraction: f64,
}

impl BoxState {
    /// Mean normal stress [Pa].
    pub fn pressure(&self) -> f64 {
        (self.stress[0] + self.stress[1] + self.stress[2]) / 3.0
    }

    /// Shear stress that drives a shear [Pa]: positive where it drives a positive rate.
    pub fn shear_stress(&self, axes: ShearAxes) -> f64 {
        shear_stress(&self.stress, axes)
    }
}

/// Shear stress that drives a shear [Pa], of the stress (compression positive): `-stress` of flow and gradient.
fn shear_stress(stress: &[f64; 6], axes: ShearAxes) -> f64 {
    // xy, xz and yz stand behind the three normal stresses
    -stress[(axes.flow + axes.gradient + 2).min(5)]
}

/// `ln(L/L0)` in each direction; 0 where the length is the same, were it infinite.
fn true_strain(from: DVec3, to: DVec3) -> DVec3 {
    let along = |k: usize| {
        if to[k] == from[k] {
            0.0
        } else {
            libm::log(to[k] / from[k])
        }
    };
    DVec3::new(along(0), along(1), along(2))
}

/// Symmetric part of a dyad: xx, yy, zz, xy, xz, yz.
fn dyad(a: DVec3, b: DVec3) -> [f64; 6] {
    let [d, e] = add_dyad([DVec3::ZERO; 2], a, b);
    [d.x, d.y, d.z, e.x, e.y, e.z]
}

/// The symmetric part of a dyad as its diagonal and the rest, added to others.
#[inline(always)]
fn add_dyad([diagonal, rest]: [DVec3; 2], a: DVec3, b: DVec3) -> [DVec3; 2] {
    [diagonal + a * b, rest + 0.5 * (a.xxy() * b.yzz() + a.yzz() * b.xxy())]
}

/// Momentum [kg m/s] and mass [kg] of a grain.
fn momentum(mass: f64, velocity: DVec3) -> [f64; 4] {
    let DVec3 { x, y, z } = velocity * mass;
    [x, y, z, mass]
}

fn plus(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|k| a[k] + b[k])
}

/// Velocity of the centre of mass [m/s], of momenta and masses that were added up.
fn mean_velocity([x, y, z, mass]: [f64; 4]) -> DVec3 {
    if mass > 0.0 {
        DVec3::new(x, y, z) / mass
    } else {
        DVec3::ZERO
    }
}

impl Simulation {
    /// Tells how the periodic box deforms from now on; before the start or between two steps. A box that has deformed keeps its
    /// shape when the deformation ends. Where processes share the run each calls this.
    pub fn deform(&mut self, plan: Deformation) -> Result<(), DeformationError> {
        self.check_deformation(&plan)?;
        self.comm.begin_to_deform(plan.shear.map(|shear| shear.axes));
        let size = self.domain().size();
        let (largest_radius, _) = self.largest_grain();
        let state = self.deforming.get_or_insert_with(|| {
            Box::new(DeformingBox {
                plan,
                servos: Default::default(),
                shear_drive: None,
                lengths: [size; 2],
                sheared: [0.0; 2],
                pending: [0.0; DRIVES],
                across: [DVec3::ZERO; 3],
                since: Carry::NONE,
                largest_radius,
            })
        });
        let [.., shear_before] = state.plan.drives();
        let [.., shear] = plan.drives();
        match shear {
            Drive::Stress { target, max_rate } if state.shear_drive.is_none() || shear != shear_before => {
                state.shear_drive = Some(ShearDrive::new(target, max_rate, Self::rates(state).shear));
            }
            Drive::Stress { .. } => {}
            Drive::Fixed | Drive::StrainRate(_) => state.shear_drive = None,
        }
        for ((servo, drive), before) in (state.servos.iter_mut()).zip(plan.drives()).zip(state.plan.drives()) {
            match drive {
                Drive::Stress { target, max_rate } if servo.is_none() || drive != before => {
                    *servo = Some(Servo::new(target, max_rate));
                }
                Drive::Stress { .. } => {}
                Drive::Fixed | Drive::StrainRate(_) => *servo = None,
            }
        }
        state.plan = plan;
        Ok(())
    }

    /// Whether the periodic box deforms, or has deformed.
    pub fn deforms(&self) -> bool {
        self.deforming.is_some()
    }

    /// Directions of the shear of a box that deforms, if it is sheared.
    pub(crate) fn shear_axes(&self) -> Option<ShearAxes> {
        Some(self.deforming.as_deref()?.plan.shear?.axes)
    }

    /// Strains of the stage are counted from here.
    pub(crate) fn mark_strain(&mut self) {
        let size = self.domain().size();
        if let Some(state) = &mut self.deforming {
            state.lengths[1] = size;
            state.sheared[1] = state.sheared[0];
        }
    }

    /// True strains and shear of a box that deforms since the start of the stage.
    pub(crate) fn stage_strain(&self) -> Option<(DVec3, f64)> {
        let state = self.deforming.as_deref()?;
        let strain = true_strain(state.lengths[1], self.domain().size());
        Some((strain, state.sheared[0] - state.sheared[1]))
    }

    /// What a periodic box that deforms has come to; `None` where the box keeps its shape. Where processes share the run each calls this.
    pub fn box_state(&self) -> Option<BoxState> {
        let (state, deforming) = (self.deforming.as_deref()?, self.comm.deforming()?);
        let (lengths, rates) = (self.domain().size(), deforming.rates());
        let [kinetic_stress, contacts] = self.box_stresses(state, deforming);
        let solid = self.sum_of_all(|segment| -> f64 {
            let radii = segment.grains.map(|g| self.grains.radius(g));
            radii.map(|r| 4.0 / 3.0 * std::f64::consts::PI * r * r * r).sum()
        });
        Some(BoxState {
            lengths,
            strain: true_strain(state.lengths[0], lengths),
            stage_strain: true_strain(state.lengths[1], lengths),
            shear_strain: state.sheared[0],
            stage_shear_strain: state.sheared[0] - state.sheared[1],
            strain_rate: rates.stretching,
            shear_rate: rates.shear,
            stress: std::array::from_fn(|k| contacts[k] + kinetic_stress[k]),
            kinetic_stress,
            solid_fraction: solid / (lengths.x * lengths.y * lengths.z),
        })
    }

    /// Kinetic energy [J] and largest speed [m/s] of the grains' motion beyond the affine flow of a box that deforms, and beyond what
    /// they do together.
    pub fn beyond_flow(&self) -> Option<(f64, f64)> {
        let deforming = self.comm.deforming()?;
        let (middle, gradient, grains) = (deforming.middle, deforming.gradient(&deforming.now()), &self.grains);
        let beyond = |g: usize| grains.velocity[g] - gradient * (grains.position[g] - middle);
        let of_segments: Vec<[f64; 4]> = self
            .in_pieces()
            .map(|some| some.map(|g| momentum(grains.mass(g), beyond(g))).fold([0.0; 4], plus))
            .collect();
        let drift = mean_velocity(self.total(&of_segments));
        let of_segments: Vec<[f64; 2]> = self
            .in_pieces()
            .map(|some| {
                some.fold([0.0, 0.0], |[kinetic, most], g| {
                    let speed2 = (beyond(g) - drift).length_squared();
                    [kinetic + 0.5 * grains.mass(g) * speed2, speed2.max(most)]
                })
            })
            .collect();
        let most = of_segments.iter().fold(0.0, |most, of| f64::max(most, of[1]));
        let [kinetic, _] = self.total(&of_segments);
        let [speed2] = self.largest_of_all([most]);
        Some((kinetic, speed2.sqrt()))
    }

    /// Own grains, segment by segment, on all threads.
    fn in_pieces(&self) -> impl IndexedParallelIterator<Item = Range<usize>> {
        (self.own_pieces().into_par_iter()).with_min_len(self.pieces_per_task())
    }

    /// Stress of the motion beyond the affine flow, and of the contacts [Pa].
    ///
    /// The first counts no motion of all grains together: the flow is the same about whichever point it is told, and a frame in which
    /// all of them drift feels no stress.
    ///
    /// The sum of `F l` over all contacts, with the branch vector `l` from the partner's image, is that of `F x` over all
    /// grains with the force of all their contacts, and of `F S` over the contacts across the sides.
    fn box_stresses(&self, state: &DeformingBox, deforming: &Deforming) -> [[f64; 6]; 2] {
        let grains = &self.grains;
        let (middle, gradient) = (deforming.middle, deforming.gradient(&deforming.now()));
        let (positions, velocities, loads) = (grains.position.rows(), grains.velocity.rows(), grains.load.rows());
        let of_segments: Vec<[f64; 16]> = self
            .in_pieces()
            .map(|some| {
                let (mut motion, mut contacts) = ([DVec3::ZERO; 2], [DVec3::ZERO; 2]);
                let mut moved = [0.0; 4];
                let rows = positions[some.clone()]
                    .iter()
                    .zip(&velocities[some.clone()])
                    .zip(&loads[some]);
                for ((position, velocity), load) in rows {
                    let (place, mass) = (position.vector - middle, load.mass());
                    let beyond = velocity.vector - gradient * place;
                    motion = add_dyad(motion, beyond * mass, beyond);
                    contacts = add_dyad(contacts, load.force(), place);
                    moved = plus(moved, momentum(mass, beyond));
                }
                let ([a, b], [c, d], [x, y, z, mass]) = (motion, contacts, moved);
                [
                    a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, d.x, d.y, d.z, x, y, z, mass,
                ]
            })
            .collect();
        let mut sum = self.total(&of_segments);
        let moved = [sum[12], sum[13], sum[14], sum[15]];
        let drift = mean_velocity(moved);
        let together = dyad(drift * moved[3], drift);
        sum.iter_mut().zip(together).for_each(|(sum, term)| *sum -= term);
        for (axis, force) in state.across.iter().enumerate() {
            let edge = self.comm.edge(axis);
            sum[6..12]
                .iter_mut()
                .zip(dyad(*force, edge))
                .for_each(|(sum, term)| *sum += term);
        }
        let size = self.domain().size();
        let per_volume = 1.0 / (size.x * size.y * size.z);
        [0, 6].map(|first| std::array::from_fn(|k| sum[first + k] * per_volume))
    }

    /// Deforms the box by one step, before the grains move.
    pub(crate) fn deform_box(&mut self) {
        let Some(mut state) = self.deforming.take() else {
            return;
        };
        if let Some(deforming) = self.comm.deforming().copied() {
            let dt = self.dt;
            let rates = Self::rates(&state);
            self.control(&mut state, &deforming);
            let next = Self::rates(&state);
            if state.plan.affine && !(rates == deforming.now() && rates.stretching == DVec3::ZERO) {
                self.push_along(&deforming, &rates, 0.0, deforming.first_half(&rates, dt));
            }
            self.comm.advance([rates, next], dt);
            state.sheared[0] += rates.shear * dt;
            self.book_across(&state);
            if let Some(deforming) = self.comm.deforming() {
                state.since = state.since.then(&deforming.carry);
            }
        }
        self.deforming = Some(state);
    }

    /// Asks the controllers, which see the stress at this moment, for the step after the next.
    fn control(&self, state: &mut DeformingBox, deforming: &Deforming) {
        if !state.plan.follows_stress() {
            state.pending = [0.0; DRIVES];
            return;
        }
        let [kinetic, contacts] = self.box_stresses(state, deforming);
        let stress: [f64; 6] = std::array::from_fn(|k| kinetic[k] + contacts[k]);
        let [x, y, z, ..] = stress;
        let stresses = [x, y, z, (x + y + z) / 3.0];
        for ((pending, servo), stress) in state.pending.iter_mut().zip(&mut state.servos).zip(stresses) {
            // a controller tells how fast to press
            *pending = servo.as_mut().map_or(0.0, |servo| -servo.speed(stress));
        }
        let sheared = state.shear_drive.as_mut().zip(state.plan.shear);
        state.pending[LENGTHS] = sheared.map_or(0.0, |(drive, shear)| {
            drive.rate(shear_stress(&stress, shear.axes), self.dt)
        });
    }

    /// Velocity gradient of a step.
    fn rates(state: &DeformingBox) -> Rates {
        let drives = state.plan.drives();
        let [x, y, z, all, shear] = std::array::from_fn(|k| match drives[k] {
            Drive::Fixed => 0.0,
            Drive::StrainRate(rate) => rate,
            Drive::Stress { .. } => state.pending[k],
        });
        Rates {
            stretching: DVec3::new(x, y, z) + DVec3::splat(all),
            shear,
        }
    }

    /// Has all grains follow the second half of what the affine flow changes in a step: after they moved, before the forces.
    pub(crate) fn follow_box(&mut self) {
        let is_affine = self.deforming.as_ref().is_some_and(|state| state.plan.affine);
        if let Some(deforming) = self.comm.deforming().copied().filter(|_| is_affine) {
            let rates = deforming.rates();
            if !(rates == deforming.now() && rates.stretching == DVec3::ZERO) {
                let change = deforming.second_half();
                self.push_along(&deforming, &rates, 0.5 * self.dt, change);
                for g in heard_grains(self.division.as_deref()) {
                    let place = self.grains.position[g] - deforming.middle;
                    self.grains.velocity[g] += change * place;
                }
            }
        }
    }

    /// Adds up what every segment came to, in the order of the segments.
    fn total<const N: usize>(&self, of_own: &[[f64; N]]) -> [f64; N] {
        let all = self.of_all_segments(of_own.as_flattened().to_vec());
        all.chunks_exact(N).fold([0.0; N], |mut sum, part| {
            sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
            sum
        })
    }

    /// Changes the velocities of own grains by what a gradient tells for their places relative to the middle. Forces have acted on the
    /// velocities for `ahead` [s] beyond the middle of the step.
    fn push_along(&mut self, deforming: &Deforming, rates: &Rates, ahead: f64, change: DMat3) {
        let (middle, gradient, half) = (deforming.middle, deforming.gradient(rates), 0.5 * self.dt);
        let (own, n, least) = (self.own_grains(), self.grains_per_piece(), self.pieces_per_task());
        let grains = &mut self.grains;
        let of_segments: Vec<[f64; 2]> = (
            grains.position.rows()[own.clone()].par_chunks(n),
            grains.velocity.rows_mut()[own.clone()].par_chunks_mut(n),
            grains.load.rows()[own].par_chunks(n),
        )
            .into_par_iter()
            .with_min_len(least)
            .map(|(position, velocity, load)| {
                let (mut gained, mut work) = (0.0, 0.0);
                for ((position, velocity), load) in position.iter().zip(velocity).zip(load) {
                    let mass = load.mass();
                    let place = position.vector - middle;
                    let kick = change * place;
                    let then = velocity.vector - load.force() * (ahead * velocity.scalar);
                    gained += mass * (then + 0.5 * kick).dot(kick);
                    velocity.vector += kick;
                    let beyond = velocity.vector - gradient * place;
                    work -= mass * half * beyond.dot(gradient * beyond);
                }
                [gained, work]
            })
            .collect();
        let [gained, work] = self.total(&of_segments);
        self.books.carry_along(gained, work);
    }

    /// Books half of the work of the contacts across the sides in this step: with the forces before it or after it.
    fn book_across(&mut self, state: &DeformingBox) {
        if let Some(deforming) = self.comm.deforming() {
            let work = state.across.iter().zip(deforming.changes());
            let work: f64 = work.map(|(force, change)| force.dot(change)).sum();
            self.books.work_across(-0.5 * work);
        }
    }

    /// Notes the forces across the sides at the end of a step, or before the first.
    pub(crate) fn note_across(&mut self) {
        let Some(mut state) = self.deforming.take() else {
            return;
        };
        state.across = self.work.across;
        if self.step > 0 {
            self.book_across(&state);
        }
        self.deforming = Some(state);
    }

    /// The point that rests, and how the box carried all places along since the candidates were found: what the whole does together
    /// brings no grain nearer to another than the strain tells.
    pub(crate) fn carried_along(&self) -> (DVec3, &Carry) {
        match (self.deforming.as_deref(), self.comm.deforming()) {
            (Some(state), Some(deforming)) => (deforming.middle, &state.since),
            _ => (DVec3::ZERO, &Carry::NONE),
        }
    }

    /// A displacement since the candidates were found, with what the box did meanwhile [m].
    pub(crate) fn with_box(&self, displacement: f64, motion: &Motion) -> f64 {
        match self.deforming {
            Some(_) => SLACK * (displacement + motion.by_box),
            None => displacement,
        }
    }

    /// How all grains can have moved against each other and against images in a box that deforms, told the motion of all: by their motion beyond the
    /// affine flow, and by what the flow does over the distance of two that may meet.
    pub(crate) fn beyond_affine(&self, motion: Motion) -> Motion {
        let (Some(state), Some(deforming)) = (self.deforming.as_deref(), self.comm.deforming()) else {
            return motion;
        };
        let grains = &self.grains;
        let (middle, gradient, carry) = (
            deforming.middle,
            deforming.gradient(&deforming.rates()),
            deforming.carry,
        );
        let (dt, own, n) = (self.dt, self.own_grains(), GRAINS_PER_TASK);
        let (speed2, step2) = (
            grains.position.rows()[own.clone()].par_chunks(n),
            grains.velocity.rows()[own.clone()].par_chunks(n),
            grains.load.rows()[own].par_chunks(n),
        )
            .into_par_iter()
            .map(|(position, velocity, load)| {
                let (mut speed2, mut step2) = (0.0f64, 0.0f64);
                for ((position, velocity), load) in position.iter().zip(velocity).zip(load) {
                    let middle_velocity = velocity.vector - load.force() * (0.5 * dt * velocity.scalar);
                    let place = position.vector - middle;
                    let before = place - middle_velocity * dt;
                    let beyond = velocity.vector - gradient * place;
                    speed2 = speed2.max(beyond.length_squared());
                    step2 = step2.max((place - carry.apply(before)).length_squared());
                }
                (speed2, step2)
            })
            .reduce(|| (0.0, 0.0), |a, b| (a.0.max(b.0), a.1.max(b.1)));
        let [speed2, step2] = self.largest_of_all([speed2, step2]);
        let speed = speed2.sqrt();
        // two grains farther apart than this approach by no more of their distance than others
        let apart = 2.0 * state.largest_radius
            + self.beyond_touch()
            + self.skin
            + NEAR * state.largest_radius
            + 4.0 * speed * dt;
        Motion {
            max_speed: SLACK * (speed + 0.5 * deforming.steepness() * apart),
            max_step: SLACK * (step2.sqrt() + 0.5 * carry.strain() * apart),
            by_box: 0.5 * state.since.strain() * apart,
            ..motion
        }
    }

    /// Notes that candidates were found.
    pub(super) fn note_candidates_of_box(&mut self) {
        if let Some(state) = &mut self.deforming {
            state.since = Carry::NONE;
        }
    }

    /// A skin with which no grain of a box that deforms meets two images of a partner; a fault where there is none.
    pub(crate) fn skin_that_fits(&self, skin: f64) -> Result<f64, Fault> {
        let Some(state) = &self.deforming else {
            return Ok(skin);
        };
        let domain = self.domain();
        let axis = (0..3)
            .filter(|&k| domain.periodic[k])
            .min_by(|&a, &b| domain.size()[a].total_cmp(&domain.size()[b]));
        let Some(axis) = axis else {
            return Ok(skin);
        };
        let size = domain.size()[axis];
        let room = USABLE * size - 2.0 * state.largest_radius - self.beyond_touch();
        let least = self.tuner.least().unwrap_or(skin);
        // not a number has no room
        if room >= least {
            return Ok(skin.min(room));
        }
        let (_, id) = self.largest_grain();
        Err(Fault::BoxTooSmall {
            step: self.step,
            id,
            direction: ["x", "y", "z"][axis].into(),
            size,
            least: (2.0 * state.largest_radius + self.beyond_touch() + least) / USABLE,
        })
    }

    /// Radius [m] and id of the largest grain of all processes; of several the last in memory.
    fn largest_grain(&self) -> (f64, u32) {
        let own = self.own_grains().map(|g| (self.grains.radius(g), self.grains.id[g]));
        let larger = |a: &(f64, u32), b: &(f64, u32)| a.0.total_cmp(&b.0);
        let all = self.of_all_segments(own.max_by(larger).into_iter().collect());
        all.into_iter().max_by(larger).unwrap_or((0.0, 0))
    }

    /// What a checkpoint holds of the box.
    pub(super) fn deforming_state(&self) -> Option<DeformingState> {
        Some(DeformingState {
            domain: *self.domain(),
            deforming: *self.comm.deforming()?,
            state: self.deforming.as_deref()?.clone(),
        })
    }

    /// Goes on with a box that has deformed.
    pub(super) fn restore_box(&mut self, state: DeformingState) {
        self.comm.restore(state.domain, state.deforming);
        self.deforming = Some(Box::new(state.state));
    }
}
