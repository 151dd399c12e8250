//! A wall that moves as a rigid body: its centre of mass, and its turning about it, under the load of the grains and its weight.
//!
//! The scheme is that of the grains, velocity Verlet with velocities predicted for the contact laws, for the velocity `v` of the centre
//! of mass and the angular momentum `L`. The body turns in a step as it does in its middle: `w = I(q)^-1 L` with the orientation `q` that
//! half a step makes, so that a body on which no torque acts keeps `L` exactly and its energy to second order.
//!
//! Where it may turn about some axes of the world only, what holds it takes up the other components of the torque and does no work:
//! with `P` onto these axes, `d(P L)/dt = P torque`, and `w = (P I P)^-1 P L` within them.

use super::mass::{BodyMass, MassProperties};
use super::pose::rotation_about;
use glam::{DMat3, DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// A wall that moves as a rigid body: `m dv/dt = F + m g` and `d(I w)/dt = T` along and about the axes that are free, with the force `F` of
/// the grains and their torque `T` about the centre of mass (Newton's and Euler's equations). Motions that are told behind it are carried by it
/// and have no inertia of their own.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct BodyMotion {
    /// Its mass.
    pub mass: BodyMass,
    /// Acceleration of gravity [m/s^2].
    pub gravity: DVec3,
    /// Velocity of its centre of mass at the start [m/s].
    pub velocity: DVec3,
    /// Angular velocity at the start [1/s].
    pub angular_velocity: DVec3,
    /// Axes of the world along which it may move.
    pub slides: [bool; 3],
    /// Axes of the world about which it may turn.
    pub turns: [bool; 3],
}

/// State of a rigid body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct RigidBody {
    mass: MassProperties,
    gravity: DVec3,
    slides: DVec3,
    turns: DVec3,
    /// Way of the centre of mass since the motion was told [m].
    pub(super) way: DVec3,
    /// Turn about it since then.
    pub(super) rotation: DQuat,
    /// Velocity of the centre [m/s]; between the two halves of a step, that predicted for its end. Likewise the others.
    pub(super) velocity: DVec3,
    /// Angular velocity [1/s].
    pub(super) spin: DVec3,
    /// Angular momentum about the axes that are free [kg m^2/s].
    momentum: DVec3,
    /// Turns a torque into what it does to the spin in time [1/(kg m^2)].
    gives: DMat3,
    /// Velocity and momentum in the middle of the step.
    half: (DVec3, DVec3),
    /// Time step whose second half is still to come [s]; 0: none.
    pending: f64,
    /// Force of the grains [N] and torque about the centre of mass [N m] in the latest step.
    load: (DVec3, DVec3),
}

impl RigidBody {
    pub(super) fn new(motion: &BodyMotion, mass: MassProperties) -> Self {
        let mask = |free: [bool; 3]| DVec3::from_array(free.map(|free| if free { 1.0 } else { 0.0 }));
        let (slides, turns) = (mask(motion.slides), mask(motion.turns));
        let (velocity, spin) = (motion.velocity * slides, motion.angular_velocity * turns);
        let mut body = Self {
            mass,
            gravity: motion.gravity,
            slides,
            turns,
            way: DVec3::ZERO,
            rotation: DQuat::IDENTITY,
            velocity,
            spin,
            momentum: turns * (mass.inertia * spin),
            gives: DMat3::ZERO,
            half: (DVec3::ZERO, DVec3::ZERO),
            pending: 0.0,
            load: (DVec3::ZERO, DVec3::ZERO),
        };
        body.gives = body.giving(body.rotation);
        body
    }

    /// First half of a step.
    pub(super) fn advance(&mut self, dt: f64) {
        let gain = 0.5 * dt;
        let (velocity, momentum) = self.kicked((self.velocity, self.momentum), gain);
        self.half = (velocity, momentum);
        self.way += velocity * dt;
        let in_the_middle = turned_by(self.gives * momentum * gain) * self.rotation;
        let spin = self.giving(in_the_middle) * momentum;
        self.rotation = (turned_by(spin * dt) * self.rotation).normalize();
        self.gives = self.giving(self.rotation);
        (self.velocity, self.momentum) = self.kicked(self.half, gain);
        self.spin = self.gives * self.momentum;
        self.pending = dt;
    }

    /// Second half of a step, with the force of the grains and their torque about the centre of mass at its end.
    pub(super) fn settle(&mut self, load: (DVec3, DVec3)) {
        self.load = load;
        if self.pending > 0.0 {
            (self.velocity, self.momentum) = self.kicked(self.half, 0.5 * self.pending);
            self.spin = self.gives * self.momentum;
        }
        self.pending = 0.0;
    }

    /// Velocity and momentum after the load has acted for a time.
    fn kicked(&self, (velocity, momentum): (DVec3, DVec3), time: f64) -> (DVec3, DVec3) {
        let (force, torque) = self.load;
        let acceleration = self.slides * (force / self.mass.mass + self.gravity);
        (velocity + acceleration * time, momentum + self.turns * torque * time)
    }

    /// `(P I P)^-1` within the axes that are free, 0 elsewhere, of the body turned so.
    fn giving(&self, rotation: DQuat) -> DMat3 {
        if self.turns == DVec3::ZERO {
            return DMat3::ZERO;
        }
        let turned = DMat3::from_quat(rotation);
        let inertia = turned * self.mass.inertia * turned.transpose();
        let free = DMat3::from_diagonal(self.turns);
        let held = DMat3::from_diagonal(DVec3::ONE - self.turns);
        (free * inertia * free + held).inverse() - held
    }

    /// Where its centre of mass is [m].
    pub(super) fn center(&self) -> DVec3 {
        self.mass.center + self.way
    }

    /// Where its centre of mass was when the motion was told [m].
    pub(super) fn first_center(&self) -> DVec3 {
        self.mass.center
    }

    /// Power of a load on it [W].
    pub(super) fn power(&self, (force, torque): (DVec3, DVec3)) -> f64 {
        force.dot(self.velocity) + torque.dot(self.spin)
    }

    /// Inverse of the mass with which it gives way to a push along a direction at a point [1/kg].
    pub(super) fn inverse_mass(&self, point: DVec3, direction: DVec3) -> f64 {
        let lever = (point - self.center()).cross(direction);
        (self.slides * direction).length_squared() / self.mass.mass + lever.dot(self.gives * lever)
    }

    /// Lower bound of the mass with which it gives way to a push within bounds [kg].
    pub(super) fn least_mass(&self, bounds: Option<(DVec3, DVec3)>) -> f64 {
        let reach = bounds.map_or(0.0, |(lower, upper)| {
            let center = self.center();
            (upper - center).abs().max((lower - center).abs()).length()
        });
        let columns = [self.gives.x_axis, self.gives.y_axis, self.gives.z_axis];
        // no eigenvalue is larger than this
        let gives = columns.iter().map(|column| column.length_squared()).sum::<f64>().sqrt();
        let slides = if self.slides == DVec3::ZERO {
            0.0
        } else {
            1.0 / self.mass.mass
        };
        1.0 / (slides + gives * reach * reach)
    }

    /// Kinetic energy [J].
    pub(super) fn kinetic(&self) -> f64 {
        0.5 * (self.mass.mass * self.velocity.length_squared() + self.spin.dot(self.momentum))
    }

    /// Kinetic energy, and that of the weight, 0 where the body was when the motion was told [J].
    pub(super) fn energy(&self) -> f64 {
        self.kinetic() - self.mass.mass * self.gravity.dot(self.way)
    }
}

/// The rotation by a vector of turning [rad].
fn turned_by(turning: DVec3) -> DQuat {
    let angle = turning.length();
    if angle == 0.0 {
        DQuat::IDENTITY
    } else {
        rotation_about(turning / angle, angle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    const ALL: [bool; 3] = [true; 3];

    fn body(moments: DVec3, spin: DVec3, turns: [bool; 3]) -> RigidBody {
        let mass = MassProperties {
            mass: 2.0,
            center: DVec3::new(0.1, 0.2, 0.3),
            inertia: DMat3::from_diagonal(moments),
        };
        let motion = BodyMotion {
            mass: BodyMass::Told(mass),
            gravity: DVec3::ZERO,
            velocity: DVec3::ZERO,
            angular_velocity: spin,
            slides: ALL,
            turns,
        };
        RigidBody::new(&motion, mass)
    }

    fn step(body: &mut RigidBody, dt: f64, torque: impl Fn(&RigidBody) -> DVec3) {
        body.advance(dt);
        let torque = torque(body);
        body.settle((DVec3::ZERO, torque));
    }

    /// A symmetric top on which nothing acts: its axis goes round the momentum with `L/I1`.
    #[test]
    fn a_top_precesses_as_poinsot_says() {
        let (across, along) = (0.04, 0.06);
        let mut top = body(DVec3::new(across, across, along), DVec3::new(3.0, 0.0, 40.0), ALL);
        let momentum = top.momentum;
        let energy = top.energy();
        let period = 2.0 * PI * across / momentum.length();
        let steps = 4000;
        let axis = |top: &RigidBody| top.rotation * DVec3::Z;
        for k in 1..=steps {
            step(&mut top, period / f64::from(steps), |_| DVec3::ZERO);
            if k == steps / 2 {
                // on the other side of the momentum
                let n = momentum.normalize();
                let opposite = n * (2.0 * n.z) - DVec3::Z;
                assert!((axis(&top) - opposite).length() < 1e-5, "{}", axis(&top));
            }
        }
        assert!((axis(&top) - DVec3::Z).length() < 1e-5, "{}", axis(&top));
        assert_eq!(top.momentum, momentum);
        assert!(
            (top.energy() / energy - 1.0).abs() < 1e-8,
            "{}",
            top.energy() / energy - 1.0
        );
    }

    /// About the axis of the middle moment a body turns over and over; the errors of its energy stay, and are of second order.
    #[test]
    fn a_body_that_tumbles_keeps_its_energy_to_second_order() {
        let error = |dt: f64| {
            let mut wing = body(DVec3::new(0.01, 0.02, 0.03), DVec3::new(1e-3, 10.0, 0.0), ALL);
            let before = wing.energy();
            let (mut worst, mut flips, mut last): (f64, u32, f64) = (0.0, 0, 1.0);
            for _ in 0..(20.0 / dt) as u32 {
                step(&mut wing, dt, |_| DVec3::ZERO);
                worst = worst.max((wing.energy() / before - 1.0).abs());
                let upright = (wing.rotation * DVec3::Y).y;
                if upright.abs() > 0.5 && upright.signum() != last {
                    (last, flips) = (upright.signum(), flips + 1);
                }
            }
            assert!(flips > 3, "{flips}");
            worst
        };
        let (coarse, fine) = (error(2e-3), error(1e-3));
        assert!(fine < 2e-5 && (coarse / fine - 4.0).abs() < 0.5, "{coarse} {fine}");
    }

    /// A heavy top that spins fast goes round the vertical with `m g l/(I w)`.
    #[test]
    fn a_torque_turns_the_axis_of_a_gyroscope() {
        let (inertia, spin, torque) = (0.06, 400.0, 2.0);
        let mut top = body(DVec3::new(0.04, 0.04, inertia), DVec3::X * spin, ALL);
        // its axis lies along x: the large moment does, too
        top.mass.inertia = DMat3::from_diagonal(DVec3::new(inertia, 0.04, 0.04));
        top = RigidBody {
            momentum: DVec3::X * inertia * spin,
            gives: top.giving(DQuat::IDENTITY),
            ..top
        };
        let rate = torque / (inertia * spin);
        let quarter = 0.5 * PI / rate;
        let steps = 400_000;
        for _ in 0..steps {
            // a weight at the end of the axis pulls down
            step(&mut top, quarter / f64::from(steps), |top| {
                (top.rotation * DVec3::X).cross(DVec3::NEG_Z) * torque
            });
        }
        let axis = top.rotation * DVec3::X;
        // nutation about it is as large as rate over spin
        assert!((axis - DVec3::Y).length() < 1e-3, "{axis}");
    }

    /// What holds a body about two axes does no work: it turns about the third as if hinged there.
    #[test]
    fn a_body_held_about_two_axes_turns_about_the_third() {
        let mut plate = body(DVec3::new(0.01, 0.02, 0.03), DVec3::ONE, [false, true, false]);
        assert_eq!(plate.spin, DVec3::Y);
        let dt = 1e-3;
        for _ in 0..1000 {
            step(&mut plate, dt, |_| DVec3::new(5.0, 0.04, -7.0));
        }
        // w = 1 + t M/I, angle = t + t^2 M/2 I
        assert!((plate.spin - DVec3::Y * 3.0).length() < 1e-2, "{}", plate.spin);
        let exact = rotation_about(DVec3::Y, 2.0);
        let off = (plate.rotation * DVec3::X - exact * DVec3::X).length();
        assert!(
            off < 3e-3 && plate.rotation.x == 0.0 && plate.rotation.z == 0.0,
            "{off}"
        );
        let held = body(DVec3::ONE, DVec3::ONE, [false; 3]);
        assert_eq!((held.spin, held.gives), (DVec3::ZERO, DMat3::ZERO));
    }

    #[test]
    fn a_push_beside_the_centre_meets_less_mass() {
        let moments = DVec3::new(0.01, 0.02, 0.04);
        let one = body(moments, DVec3::ZERO, ALL);
        let center = DVec3::new(0.1, 0.2, 0.3);
        let at = |arm: DVec3| one.inverse_mass(center + arm, DVec3::Z);
        assert_eq!(at(DVec3::ZERO), 0.5);
        assert!((at(DVec3::X * 0.1) - (0.5 + 0.01 / 0.02)).abs() < 1e-12);
        assert!((at(DVec3::Y * 0.1) - (0.5 + 0.01 / 0.01)).abs() < 1e-12);
        let bounds = (center - DVec3::splat(0.1), center + DVec3::splat(0.1));
        let least = one.least_mass(Some(bounds));
        assert!(least * at(DVec3::new(-0.1, 0.1, 0.1)) <= 1.0 && one.least_mass(None) <= 2.0);
    }
}
