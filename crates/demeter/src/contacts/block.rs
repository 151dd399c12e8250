//! Contact laws, family by family, over blocks of contacts that stay in the cache.
//!
//! A block gathers the kinematics of its contacts, runs the normal, tangential and rolling laws over runs of contacts
//! of one material pair (one dispatch per run), and writes forces and torques.

use super::{ContactChunk, Scene, Tally};
use crate::materials::Materials;
use demeter_physics::contact::normal::{Normal, NormalInput, NormalVisitor, centred_force};
use demeter_physics::contact::rolling::{Rolling, RollingInput, RollingVisitor};
use demeter_physics::contact::tangential::{Tangential, TangentialInput, TangentialVisitor};
use demeter_physics::contact::{PairLaw, PairSize};
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use demeter_physics::integrator::Integrator;
use glam::DVec3;
use std::ops::Range;

/// Contacts in one block.
const BLOCK: usize = 64;

/// One contact while its laws are evaluated.
#[derive(Clone, Copy, Default)]
struct Kinematics {
    size: PairSize,
    rate: f64,
    tangential_velocity: DVec3,
    rolling_velocity: DVec3,
    spin: f64,
    tangential_mass: f64,
    rolling_inertia: f64,
}

/// The second body of a contact.
#[derive(Clone, Copy)]
struct Partner {
    velocity: DVec3,
    angular_velocity: DVec3,
    inverse_radius: f64,
    inverse_mass: f64,
    inverse_inertia: f64,
    /// `1/(I + m l^2)`.
    inverse_rolling_inertia: f64,
}

/// The laws' view of a stretch of contacts of one material pair.
struct Run<'a> {
    dt: f64,
    integrator: Integrator,
    stride: usize,
    law: &'a PairLaw,
    geometry: &'a [Contact],
    kinematics: &'a [Kinematics],
    normal_force: &'a mut [f64],
    /// Its part that does not depend on the rate [N].
    elastic: &'a mut [f64],
    /// Normal force that friction and rolling resistance are limited by: with the pull of adhesion, not negative [N].
    friction_load: &'a mut [f64],
    /// Overlap of Hertzian contacts of the same area [m].
    bearing_overlap: &'a mut [f64],
    history: &'a mut [f64],
    tangential_force: &'a mut [DVec3],
    rolling_torque: &'a mut [DVec3],
}

/// Half of the path of the overlap over which a normal law takes its mean [m].
#[inline(always)]
pub(crate) fn normal_window<L: Normal>(integrator: Integrator, overlap: f64, rate: f64, dt: f64) -> f64 {
    if L::FOLLOWS_KINKS {
        0.5 * dt * rate.abs()
    } else {
        integrator.half_window(overlap, rate, dt)
    }
}

struct NormalPass<'r, 'a>(&'r mut Run<'a>);

/// What the normal forces of a run took out of the mechanical energy [J].
struct NormalLoss {
    viscous: f64,
    plastic: f64,
}

impl NormalVisitor for NormalPass<'_, '_> {
    type Output = NormalLoss;

    fn visit<L: Normal>(self, law: &L) -> NormalLoss {
        let run = self.0;
        let mut loss = NormalLoss {
            viscous: 0.0,
            plastic: 0.0,
        };
        let remembered = law.history();
        for (k, (contact, kin)) in run.geometry.iter().zip(run.kinematics).enumerate() {
            let input = NormalInput {
                size: kin.size,
                overlap: contact.overlap,
                rate: kin.rate,
                half_window: normal_window::<L>(run.integrator, contact.overlap, kin.rate, run.dt),
            };
            let response = law.respond(&input, &mut run.history[k * run.stride..][..remembered]);
            let (force, rate) = match run.integrator {
                Integrator::VelocityVerlet => {
                    centred_force(response, kin.rate, run.normal_force[k], kin.size.mass, run.dt)
                }
                // the predicted rate is of high order already
                Integrator::Gear => (
                    (response.elastic + response.damping * kin.rate).max(response.least),
                    kin.rate,
                ),
            };
            run.normal_force[k] = force;
            run.elastic[k] = response.elastic;
            run.friction_load[k] = (force + response.adhesion).max(0.0);
            run.bearing_overlap[k] =
                law.bearing_overlap(kin.size, contact.overlap, &run.history[k * run.stride..][..remembered]);
            // where the force is cut at its least, the spring relaxes into the dashpot without pulling
            loss.viscous += (force - response.elastic) * rate * run.dt;
            loss.plastic += response.lost;
        }
        loss
    }
}

struct TangentialPass<'r, 'a>(&'r mut Run<'a>);

impl TangentialVisitor for TangentialPass<'_, '_> {
    type Output = f64;

    fn visit<L: Tangential>(self, law: &L) -> f64 {
        let run = self.0;
        let offset = normal_history(run.law);
        let mut dissipated = 0.0;
        for (k, (contact, kin)) in run.geometry.iter().zip(run.kinematics).enumerate() {
            let history = &mut run.history[k * run.stride + offset..][..L::HISTORY.len()];
            let input = TangentialInput {
                size: kin.size,
                tangential_mass: kin.tangential_mass,
                overlap: run.bearing_overlap[k],
                normal: contact.normal,
                velocity: kin.tangential_velocity,
                spin: kin.spin,
                normal_force: run.friction_load[k],
                dt: run.dt,
                removable_share: run.integrator.removable_share(),
            };
            let response = law.respond(&input, history);
            run.tangential_force[k] = response.force;
            dissipated += response.dissipated;
        }
        dissipated
    }
}

struct RollingPass<'r, 'a>(&'r mut Run<'a>, NormalStiffness);

/// Tangent normal stiffness of every contact of a run [N/m].
type NormalStiffness = [f64; BLOCK];

impl RollingVisitor for RollingPass<'_, '_> {
    type Output = f64;

    fn visit<L: Rolling>(self, law: &L) -> f64 {
        let Self(run, stiffness) = self;
        let offset = normal_history(run.law) + tangential_history(run.law);
        let mut dissipated = 0.0;
        for (k, (contact, kin)) in run.geometry.iter().zip(run.kinematics).enumerate() {
            let first = k * run.stride + offset;
            let input = RollingInput {
                size: kin.size,
                rolling_inertia: kin.rolling_inertia,
                normal: contact.normal,
                angular_velocity: kin.rolling_velocity,
                spin: kin.spin,
                normal_force: run.friction_load[k],
                normal_stiffness: stiffness[k],
                dt: run.dt,
                removable_share: run.integrator.removable_share(),
            };
            let response = law.respond(&input, &mut run.history[first..first + L::HISTORY.len()]);
            run.rolling_torque[k] = response.torque;
            dissipated += response.dissipated;
        }
        dissipated
    }
}

struct StiffnessPass<'r, 'a>(&'r Run<'a>);

impl NormalVisitor for StiffnessPass<'_, '_> {
    type Output = NormalStiffness;

    fn visit<L: Normal>(self, law: &L) -> NormalStiffness {
        let mut stiffness = [0.0; BLOCK];
        let (run, remembered) = (self.0, law.history());
        for (k, out) in stiffness.iter_mut().enumerate().take(run.kinematics.len()) {
            let history = &run.history[k * run.stride..][..remembered];
            // an attraction that fades with the gap has a negative slope: no spring against rolling is made of that
            *out = law
                .stiffness(run.kinematics[k].size, run.geometry[k].overlap, history)
                .max(0.0);
        }
        stiffness
    }
}

impl ContactChunk {
    /// Evaluates the laws of all contacts between grains.
    pub(crate) fn evaluate_pairs(&mut self, scene: &Scene) {
        let grains = scene.grains;
        self.evaluate(scene, |j, _point, lever| {
            let (radius, mass, inertia) = (grains.radius(j), grains.mass[j], grains.inertia(j));
            Partner {
                velocity: grains.velocity[j],
                angular_velocity: grains.angular_velocity[j],
                inverse_radius: 1.0 / radius,
                inverse_mass: 1.0 / mass,
                inverse_inertia: 1.0 / inertia,
                inverse_rolling_inertia: 1.0 / (inertia + mass * lever * lever),
            }
        });
    }

    /// Evaluates the laws of all contacts with walls, and sums up what the walls feel.
    pub(crate) fn evaluate_walls(&mut self, scene: &Scene) {
        self.evaluate(scene, |j, point, _lever| {
            let wall = &scene.walls[j];
            Partner {
                velocity: wall.velocity_at(point),
                angular_velocity: wall.angular_velocity(),
                inverse_radius: 0.0,
                inverse_mass: 0.0,
                inverse_inertia: 0.0,
                inverse_rolling_inertia: 0.0,
            }
        });
        for k in 0..self.len() {
            let wall = &scene.walls[self.j[k] as usize];
            let contact = &self.now.geometry[k];
            let point = scene.grains.position[self.i[k] as usize] - contact.normal * contact.lever_i;
            let force = -self.force[k];
            self.tally.wall_work -=
                scene.dt * (force.dot(wall.velocity_at(point)) + self.torque_j[k].dot(wall.angular_velocity()));
            let load = &mut self.wall_load[self.j[k] as usize];
            load.0 += force;
            load.1 += (point - wall.origin()).cross(force) + self.torque_j[k];
        }
    }

    fn evaluate(&mut self, scene: &Scene, partner: impl Fn(usize, DVec3, f64) -> Partner) {
        let count = self.len();
        self.force.resize(count, DVec3::ZERO);
        self.torque_i.resize(count, DVec3::ZERO);
        self.torque_j.resize(count, DVec3::ZERO);
        let mut first = 0;
        while first < count {
            let last = (first + BLOCK).min(count);
            let mut kinematics = [Kinematics::default(); BLOCK];
            for (kin, k) in kinematics.iter_mut().zip(first..last) {
                *kin = gather(
                    scene,
                    self.i[k] as usize,
                    self.j[k] as usize,
                    &self.now.geometry[k],
                    &partner,
                );
            }
            let mut elastic = [0.0; BLOCK];
            let mut friction_load = [0.0; BLOCK];
            let mut bearing_overlap = [0.0; BLOCK];
            let mut tangential = [DVec3::ZERO; BLOCK];
            let mut rolling = [DVec3::ZERO; BLOCK];
            let mut run = 0..0;
            while run.end < last - first {
                run = next_run(&self.now.pair[first..last], run.end);
                let contacts = first + run.start..first + run.end;
                let laws = Run {
                    dt: scene.dt,
                    integrator: scene.integrator,
                    stride: scene.stride,
                    law: scene.materials.law(self.now.pair[contacts.start]),
                    geometry: &self.now.geometry[contacts.clone()],
                    kinematics: &kinematics[run.clone()],
                    normal_force: &mut self.now.normal_force[contacts.clone()],
                    elastic: &mut elastic[run.clone()],
                    friction_load: &mut friction_load[run.clone()],
                    bearing_overlap: &mut bearing_overlap[run.clone()],
                    history: &mut self.now.history[contacts.start * scene.stride..contacts.end * scene.stride],
                    tangential_force: &mut tangential[run.clone()],
                    rolling_torque: &mut rolling[run.clone()],
                };
                run_laws(laws, &mut self.tally);
            }
            for (b, k) in (first..last).enumerate() {
                let contact = &self.now.geometry[k];
                self.force[k] = contact.normal * self.now.normal_force[k] + tangential[b];
                let arm = contact.normal.cross(tangential[b]);
                self.torque_i[k] = rolling[b] - arm * contact.lever_i;
                self.torque_j[k] = -rolling[b] - arm * contact.lever_j;
            }
            if scene.is_coupled() {
                self.remember_coupling(first, &elastic[..last - first], scene);
            }
            first = last;
        }
    }
}

/// Runs the laws over one stretch of contacts of one material pair.
fn run_laws(mut run: Run, tally: &mut Tally) {
    let law = run.law;
    let loss = law.normal.visit(NormalPass(&mut run));
    tally.viscous += loss.viscous;
    tally.plastic += loss.plastic;
    if let Some(friction) = &law.tangential {
        tally.friction += friction.visit(TangentialPass(&mut run));
    }
    if let Some(resistance) = &law.rolling {
        let stiffness = law.normal.visit(StiffnessPass(&run));
        tally.rolling += resistance.visit(RollingPass(&mut run, stiffness));
    }
}

#[inline(always)]
fn gather(
    scene: &Scene,
    i: usize,
    j: usize,
    contact: &Contact,
    partner: &impl Fn(usize, DVec3, f64) -> Partner,
) -> Kinematics {
    let grains = scene.grains;
    let n = contact.normal;
    let point = grains.position[i] - n * contact.lever_i;
    let other = partner(j, point, contact.lever_j);
    let (omega_i, omega_j) = (grains.angular_velocity[i], other.angular_velocity);
    let (mass, inertia) = (grains.mass[i], grains.inertia(i));
    let arms = omega_i * contact.lever_i + omega_j * contact.lever_j;
    // a wall's velocity is that of its surface already, so its lever is 0
    let velocity = grains.velocity[i] - other.velocity - arms.cross(n);
    let rate = -velocity.dot(n);
    let rolling = omega_i - omega_j;
    let lever2 = contact.lever_i * contact.lever_i;
    let lever2_j = contact.lever_j * contact.lever_j;
    Kinematics {
        size: PairSize {
            radius: 1.0 / (1.0 / grains.radius(i) + other.inverse_radius),
            mass: 1.0 / (1.0 / mass + other.inverse_mass),
        },
        rate,
        tangential_velocity: velocity + n * rate,
        rolling_velocity: rolling - n * rolling.dot(n),
        spin: 0.5 * (omega_i + omega_j).dot(n),
        tangential_mass: 1.0 / (1.0 / mass + other.inverse_mass + lever2 / inertia + lever2_j * other.inverse_inertia),
        rolling_inertia: 1.0 / (1.0 / (inertia + mass * lever2) + other.inverse_rolling_inertia),
    }
}

/// The stretch of equal values that begins at `start`.
fn next_run(pairs: &[u32], start: usize) -> Range<usize> {
    let length = pairs[start..].iter().take_while(|&&p| p == pairs[start]).count();
    start..start + length
}

/// Number of history values of the normal law of a pair; they come first.
fn normal_history(law: &PairLaw) -> usize {
    struct Length;
    impl NormalVisitor for Length {
        type Output = usize;
        fn visit<L: Normal>(self, law: &L) -> usize {
            law.history()
        }
    }
    law.normal.visit(Length)
}

/// Number of history values of the tangential law; they come next, then those of the rolling law.
fn tangential_history(law: &PairLaw) -> usize {
    law.tangential.map_or(0, |t| t.info().history)
}

/// Number of history values of the laws of one pair.
pub fn history_length(law: &PairLaw) -> usize {
    normal_history(law) + tangential_history(law) + law.rolling.map_or(0, |r| r.info().history)
}

/// Largest number of history values of any pair.
pub fn stride(materials: &Materials) -> usize {
    let count = materials.list().len() as u16;
    let pairs = (0..count).flat_map(|a| (0..count).map(move |b| (a, b)));
    pairs
        .map(|(a, b)| history_length(materials.law(materials.pair(a, b))))
        .max()
        .unwrap_or(0)
}

/// Energy stored in the tangential and in the rolling spring of a contact with this history [J].
pub fn spring_energies(law: &PairLaw, history: &[f64]) -> (f64, f64) {
    struct Stored<'a>(&'a [f64]);
    impl TangentialVisitor for Stored<'_> {
        type Output = f64;
        fn visit<L: Tangential>(self, law: &L) -> f64 {
            law.energy(&self.0[..L::HISTORY.len()])
        }
    }
    impl RollingVisitor for Stored<'_> {
        type Output = f64;
        fn visit<L: Rolling>(self, law: &L) -> f64 {
            law.energy(&self.0[..L::HISTORY.len()])
        }
    }
    let tangential = &history[normal_history(law)..];
    let rolling = &tangential[tangential_history(law)..];
    (
        law.tangential.map_or(0.0, |t| t.visit(Stored(tangential))),
        law.rolling.map_or(0.0, |r| r.visit(Stored(rolling))),
    )
}

/// Energy stored by the normal law of a contact between bodies of these sizes [J].
pub fn normal_energy(law: &PairLaw, size: PairSize, overlap: f64, history: &[f64]) -> f64 {
    struct Stored<'a>(PairSize, f64, &'a [f64]);
    impl NormalVisitor for Stored<'_> {
        type Output = f64;
        fn visit<L: Normal>(self, law: &L) -> f64 {
            law.energy(self.0, self.1, &self.2[..law.history()])
        }
    }
    law.normal.visit(Stored(size, overlap, history))
}

/// Largest gap across which the normal law acts between bodies of these sizes [m].
pub fn largest_reach(law: &PairLaw, size: PairSize) -> f64 {
    struct Reach(PairSize);
    impl NormalVisitor for Reach {
        type Output = f64;
        fn visit<L: Normal>(self, law: &L) -> f64 {
            law.largest_reach(self.0)
        }
    }
    law.normal.visit(Reach(size))
}
