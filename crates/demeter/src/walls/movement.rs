//! One motion of a wall at one moment, as a rigid movement with its velocity.

use super::body::RigidBody;
use super::motion::Motion;
use super::pose::{Pose, rotation_about};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// A turn about a point, and a shift after it; and their rates.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Movement {
    pub(super) turn: Option<Turn>,
    pub(super) shift: DVec3,
    pub(super) velocity: DVec3,
    /// Velocity of the surface along itself [m/s].
    pub(super) belt: DVec3,
}

/// A turn about a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) point: DVec3,
    /// `None` where it has not turned.
    pub(super) rotation: Option<DQuat>,
    /// Angular velocity [1/s].
    pub(super) spin: DVec3,
}

impl Turn {
    fn about(point: DVec3, axis: DVec3, angle: f64, rate: f64) -> Self {
        Self {
            point,
            rotation: (angle != 0.0).then(|| rotation_about(axis, angle)),
            spin: axis * rate,
        }
    }
}

/// A wall on its way: where it stands and how it moves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Carried {
    pub(super) pose: Pose,
    pub(super) velocity: DVec3,
    pub(super) angular_velocity: DVec3,
    pub(super) belt: DVec3,
}

impl Movement {
    /// A prescribed motion at its own time, which passes at a rate; none for motions that follow forces.
    pub(super) fn prescribed(motion: &Motion, time: f64, rate: f64) -> Self {
        match motion {
            Motion::Rest
            | Motion::Servo { .. }
            | Motion::TorqueServo { .. }
            | Motion::Free(_)
            | Motion::Body(_)
            | Motion::With(_)
            | Motion::Driven { .. } => Self::default(),
            Motion::Velocity(velocity) => Self::along(*velocity, time, rate),
            Motion::Belt(velocity) => Self {
                belt: *velocity * rate,
                ..Self::default()
            },
            Motion::Oscillation {
                amplitude,
                frequency,
                phase,
            } => {
                let (swing, speed) = swing(*frequency, *phase, time);
                Self::along(*amplitude, swing, speed * rate)
            }
            Motion::Rotation {
                point,
                axis,
                angular_velocity,
            } => Self::about(*point, *axis, angular_velocity * time, angular_velocity * rate),
            Motion::Rocking {
                point,
                axis,
                amplitude,
                frequency,
                phase,
            } => {
                let (swing, speed) = swing(*frequency, *phase, time);
                Self::about(*point, *axis, amplitude * swing, amplitude * speed * rate)
            }
            Motion::Table(table) => {
                let ([x, y, z, angle], [vx, vy, vz, turning]) = table.at(time);
                let mut movement = Self::along(DVec3::new(x, y, z), 1.0, 0.0);
                movement.velocity = DVec3::new(vx, vy, vz) * rate;
                let about = |(point, axis)| Turn::about(point, axis, angle, turning * rate);
                movement.turn = table.axis().map(about);
                movement
            }
        }
    }

    /// By a way along a vector.
    pub(super) fn along(vector: DVec3, way: f64, speed: f64) -> Self {
        Self {
            shift: vector * way,
            velocity: vector * speed,
            ..Self::default()
        }
    }

    /// By an angle about an axis.
    pub(super) fn about(point: DVec3, axis: DVec3, angle: f64, rate: f64) -> Self {
        Self {
            turn: Some(Turn::about(point, axis, angle, rate)),
            ..Self::default()
        }
    }

    /// As a rigid body has moved.
    pub(super) fn of_body(body: &RigidBody) -> Self {
        Self {
            turn: Some(Turn {
                point: body.first_center(),
                rotation: (body.rotation != DQuat::IDENTITY).then_some(body.rotation),
                spin: body.spin,
            }),
            shift: body.way,
            velocity: body.velocity,
            belt: DVec3::ZERO,
        }
    }

    /// Carries a wall, with what it has done so far. `origin`: that of the wall in its own frame.
    pub(super) fn carry(&self, wall: &mut Carried, origin: DVec3) {
        if let Some(turn) = &self.turn {
            if let Some(turned) = turn.rotation {
                let arm = origin + wall.pose.translation - turn.point;
                wall.pose.rotation = turned * wall.pose.rotation;
                wall.pose.translation += turned * arm - arm;
                wall.velocity = turned * wall.velocity;
                wall.angular_velocity = turned * wall.angular_velocity;
                wall.belt = turned * wall.belt;
            }
            wall.angular_velocity += turn.spin;
            wall.velocity += turn.spin.cross(origin + wall.pose.translation - turn.point);
        }
        wall.pose.translation += self.shift;
        wall.velocity += self.velocity;
        wall.belt += self.belt;
    }

    /// Carries an axis: a point of it and its direction.
    pub(super) fn carry_axis(&self, (mut point, mut direction): (DVec3, DVec3)) -> (DVec3, DVec3) {
        if let Some(turn) = &self.turn
            && let Some(turned) = turn.rotation
        {
            point = turn.point + turned * (point - turn.point);
            direction = turned * direction;
        }
        (point + self.shift, direction)
    }
}

/// `sin(2 pi f t + phase) - sin(phase)` and its rate.
fn swing(frequency: f64, phase: f64, time: f64) -> (f64, f64) {
    let pulsation = TAU * frequency;
    let angle = pulsation * time + phase;
    (libm::sin(angle) - libm::sin(phase), pulsation * libm::cos(angle))
}
