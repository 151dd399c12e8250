//! Moves a wall: evaluates its motions at the time of its own clock.

use super::body::RigidBody;
use super::error::WallError;
use super::free::FreeBody;
use super::motion::{Freedom, Motion, MotionPart, Motions};
use super::motion_checks::check_motions;
use super::movement::{Carried, Movement};
use super::pose::Pose;
use super::servo::Servo;
use super::surface::Surface;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Time since the motion was told, as a count of equal steps, so that no rounding gathers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Clock {
    /// Time before the last change of the step [s].
    before: f64,
    /// Length of a step [s].
    step: f64,
    /// Steps of this length.
    count: u64,
}

impl Clock {
    fn time(&self) -> f64 {
        self.before + self.step * self.count as f64
    }

    fn advance(&mut self, dt: f64) {
        if dt != self.step {
            *self = Clock {
                before: self.time(),
                step: dt,
                count: 0,
            };
        }
        self.count += 1;
    }
}

/// What moves a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
enum Drive {
    /// The clock.
    Clock,
    /// A controller of the force or torque; the way or angle since the start and its rate.
    Servo { servo: Servo, way: f64, speed: f64 },
    /// The load itself.
    Free(FreeBody),
    /// Likewise, as a rigid body.
    Body(Box<RigidBody>),
    /// Somebody who tells place and rate before every step.
    Driver {
        told: Driven,
        /// Whether it was told for this step.
        is_fresh: bool,
    },
}

/// Where a driven wall stands relative to where it stood when the motion was told, and how fast it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Driven {
    /// Displacement [m]; of a wall that turns, the angle [rad] in its first component.
    pub place: DVec3,
    /// Its rate [m/s or 1/s].
    pub rate: DVec3,
    /// What whoever drives it counts the displacement from [m or rad], so that it can be gone on with after a restart.
    pub counted_from: DVec3,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Part {
    told: MotionPart,
    drive: Drive,
}

impl Part {
    fn new(told: MotionPart, body: Option<&RigidBody>) -> Self {
        let servo = |target, max_speed| Drive::Servo {
            servo: Servo::new(target, max_speed),
            way: 0.0,
            speed: 0.0,
        };
        let drive = match (&told.motion, body) {
            (Motion::Body(_), Some(body)) => Drive::Body(Box::new(*body)),
            (Motion::Servo { force, max_speed, .. }, _) => servo(*force, *max_speed),
            (Motion::TorqueServo { torque, max_speed, .. }, _) => servo(*torque, *max_speed),
            (Motion::Free(free), _) => Drive::Free(FreeBody::new(*free)),
            (Motion::Driven { .. }, _) => Drive::Driver {
                told: Driven::default(),
                is_fresh: false,
            },
            _ => Drive::Clock,
        };
        Part { told, drive }
    }

    fn movement(&self, time: f64) -> Movement {
        let (way, speed) = match &self.drive {
            Drive::Clock => {
                let (own, rate) = self.told.pace.own_time(time);
                return Movement::prescribed(&self.told.motion, own, rate);
            }
            Drive::Servo { way, speed, .. } => (*way, *speed),
            Drive::Free(body) => (body.coordinate, body.speed),
            Drive::Body(body) => return Movement::of_body(body),
            Drive::Driver { told, .. } => return self.driven(told),
        };
        match self.joint() {
            Some(Joint::Along(axis)) => Movement::along(axis, way, speed),
            Some(Joint::About(point, axis)) => Movement::about(point, axis, way, speed),
            None => Movement::default(),
        }
    }

    fn driven(&self, told: &Driven) -> Movement {
        match self.told.motion {
            Motion::Driven {
                axis: Some((point, axis)),
            } => Movement::about(point, axis, told.place.x, told.rate.x),
            _ => Movement {
                shift: told.place,
                velocity: told.rate,
                ..Movement::default()
            },
        }
    }

    /// The axis of a motion that follows forces.
    fn joint(&self) -> Option<Joint> {
        match &self.told.motion {
            Motion::Servo { axis, .. } => Some(Joint::Along(*axis)),
            Motion::TorqueServo { point, axis, .. } => Some(Joint::About(*point, *axis)),
            Motion::Free(free) => Some(match free.freedom {
                Freedom::Slide { axis } => Joint::Along(axis),
                Freedom::Hinge { point, axis, .. } => Joint::About(point, axis),
            }),
            _ => None,
        }
    }
}

/// Along or about what a wall follows a force or a torque.
enum Joint {
    Along(DVec3),
    About(DVec3, DVec3),
}

/// What a freely moving wall did in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FreeStep {
    /// Power of the grains' load on the free motion [W].
    pub power: f64,
    /// Lost in its damper and at its stops in the step [J].
    pub dissipated: f64,
    /// Kinetic energy [J].
    pub kinetic: f64,
}

/// Motions, their clock, where they began and where they have come.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Motor {
    parts: Vec<Part>,
    clock: Clock,
    began: Pose,
    /// Where the wall that this one moves with stood when the motion was told.
    leader_began: Pose,
    pub(super) pose: Pose,
    /// Velocity of the origin [m/s].
    pub(super) velocity: DVec3,
    /// Angular velocity [1/s].
    pub(super) angular_velocity: DVec3,
    /// Velocity of the surface along itself [m/s].
    pub(super) belt: DVec3,
    /// Force of the grains on this wall and on those that move with it [N], and torque about its origin [N m].
    load: (DVec3, DVec3),
}

impl Motor {
    /// Begins motions at a pose. `body` is the rigid body that they make of the wall, if they do; `origin` the wall's origin in the wall
    /// frame; `leader` where the wall stands that this one moves with, if any.
    pub(super) fn new(motions: Motions, body: Option<&RigidBody>, pose: Pose, leader: Pose, origin: DVec3) -> Self {
        let parts = motions.parts.into_iter().map(|part| Part::new(part, body));
        let mut motor = Motor {
            parts: parts.collect(),
            clock: Clock::default(),
            began: pose,
            leader_began: leader,
            pose,
            velocity: DVec3::ZERO,
            angular_velocity: DVec3::ZERO,
            belt: DVec3::ZERO,
            load: (DVec3::ZERO, DVec3::ZERO),
        };
        motor.evaluate(origin);
        motor
    }

    /// Begins motions of a surface, where it stands at the first pose, as [`new`](Self::new) does; tells what is wrong with them.
    pub(super) fn begun(
        motions: Motions,
        surface: &Surface,
        (pose, leader): (Pose, Pose),
        origin: DVec3,
    ) -> Result<Self, WallError> {
        let motions = check_motions(motions)?;
        let body = match motions.parts.first().map(|part| &part.motion) {
            Some(Motion::Body(body)) => Some(RigidBody::new(body, body.mass.of(surface, origin, &pose)?)),
            _ => None,
        };
        Ok(Motor::new(motions, body.as_ref(), pose, leader, origin))
    }

    /// The wall that this one moves with, if any.
    #[inline]
    pub(super) fn leader(&self) -> Option<usize> {
        match self.parts.first()?.told.motion {
            Motion::With(wall) => Some(wall),
            _ => None,
        }
    }

    /// What moves the first part: a free motion is always that.
    #[inline]
    fn first_drive(&self) -> Option<&Drive> {
        self.parts.first().map(|part| &part.drive)
    }

    /// Whether the wall moves freely.
    #[inline]
    pub(super) fn is_free(&self) -> bool {
        matches!(self.first_drive(), Some(Drive::Free(_) | Drive::Body(_)))
    }

    /// The rigid body that the wall is, if it is one.
    pub(super) fn body(&self) -> Option<&RigidBody> {
        match self.first_drive() {
            Some(Drive::Body(body)) => Some(body),
            _ => None,
        }
    }

    /// Least mass with which it gives way within bounds [kg]; infinite of a wall that does not move freely.
    pub(super) fn least_mass(&self, bounds: Option<(DVec3, DVec3)>) -> f64 {
        match self.first_drive() {
            Some(Drive::Free(body)) => body.motion().least_mass(bounds),
            Some(Drive::Body(body)) => body.least_mass(bounds),
            _ => f64::INFINITY,
        }
    }

    /// See [`FreeBody::inverse_mass`]; 0 of a wall that does not move freely.
    #[inline]
    pub(super) fn inverse_mass(&self, point: DVec3, direction: DVec3) -> f64 {
        match self.first_drive() {
            Some(Drive::Free(body)) => body.inverse_mass(point, direction),
            Some(Drive::Body(body)) => body.inverse_mass(point, direction),
            _ => 0.0,
        }
    }

    /// Whether a servo is among its motions.
    pub(super) fn has_servo(&self) -> bool {
        self.parts.iter().any(|part| matches!(part.drive, Drive::Servo { .. }))
    }

    /// Gives servos the speeds of the next step, by the load of the last one; they rest while the wall does not press (`presses`).
    pub(super) fn answer(&mut self, origin: DVec3, presses: bool) {
        for k in 0..self.parts.len() {
            let effort = self.effort(k, origin);
            if let Drive::Servo { servo, speed, .. } = &mut self.parts[k].drive {
                *speed = if presses { servo.speed(-effort) } else { 0.0 };
            }
        }
        self.evaluate(origin);
    }

    /// Moves by one step.
    pub(super) fn advance(&mut self, dt: f64, origin: DVec3) {
        for part in &mut self.parts {
            match &mut part.drive {
                Drive::Clock => {}
                Drive::Servo { way, speed, .. } => *way += *speed * dt,
                Drive::Free(body) => body.advance(dt),
                Drive::Body(body) => body.advance(dt),
                Drive::Driver { told, is_fresh } => {
                    if !std::mem::take(is_fresh) {
                        told.rate = DVec3::ZERO;
                    }
                }
            }
        }
        self.clock.advance(dt);
        self.evaluate(origin);
    }

    /// Whether every part follows the clock alone.
    pub(super) fn is_clockwork(&self) -> bool {
        self.parts.iter().all(|part| matches!(part.drive, Drive::Clock))
    }

    /// Tells the driven part where the wall stands at the end of the next step; without one nothing happens.
    pub(super) fn drive(&mut self, next: Driven) {
        for part in &mut self.parts {
            if let Drive::Driver { told, is_fresh } = &mut part.drive {
                (*told, *is_fresh) = (next, true);
            }
        }
    }

    /// Of a servo: share of the steps in which it pressed that it spent at its largest speed, nothing where it never did; and that
    /// speed with its unit.
    pub(super) fn limited(&self) -> Option<(Option<f64>, f64, &'static str)> {
        self.parts.iter().find_map(|part| match &part.drive {
            Drive::Servo { servo, .. } => {
                let (share, speed) = servo.limited();
                let turns = matches!(part.told.motion, Motion::TorqueServo { .. });
                Some((share, speed, if turns { "1/s" } else { "m/s" }))
            }
            _ => None,
        })
    }

    /// Whether these are its motions.
    pub(super) fn has(&self, motions: &Motions) -> bool {
        self.parts.iter().map(|part| &part.told).eq(&motions.parts)
    }

    /// What the driven part was told last, if there is one.
    pub(super) fn driven(&self) -> Option<Driven> {
        self.parts.iter().find_map(|part| match &part.drive {
            Drive::Driver { told, .. } => Some(*told),
            _ => None,
        })
    }

    /// Takes the load of the grains in this step: force [N] and torque about the origin [N m].
    pub(super) fn bear(&mut self, load: (DVec3, DVec3)) {
        self.load = load;
    }

    /// The load that the wall bears.
    pub(super) fn load(&self) -> (DVec3, DVec3) {
        self.load
    }

    /// Completes the step of a freely moving wall; tells what it did.
    pub(super) fn settle(&mut self, origin: DVec3) -> Option<FreeStep> {
        let effort = self.is_free().then(|| self.effort(0, origin))?;
        let (force, torque) = self.load;
        let place = origin + self.pose.translation;
        let step = match &mut self.parts.first_mut()?.drive {
            Drive::Free(body) => {
                let power = effort * body.speed;
                body.settle(effort);
                FreeStep {
                    power,
                    dissipated: body.dissipated(),
                    kinetic: body.kinetic(),
                }
            }
            Drive::Body(body) => {
                let load = (force, torque + (place - body.center()).cross(force));
                let power = body.power(load);
                body.settle(load);
                FreeStep {
                    power,
                    dissipated: 0.0,
                    kinetic: body.kinetic(),
                }
            }
            _ => return None,
        };
        self.evaluate(origin);
        Some(step)
    }

    /// Energy of a freely moving wall [J].
    pub(super) fn energy(&self) -> f64 {
        match self.first_drive() {
            Some(Drive::Free(body)) => body.energy(),
            Some(Drive::Body(body)) => body.energy(),
            _ => 0.0,
        }
    }

    /// Whether all motions have stopped for good, or tables have come to their ends.
    pub(super) fn is_done(&self) -> bool {
        let time = self.clock.time();
        self.parts.iter().all(|part| match (&part.told.motion, &part.drive) {
            (Motion::Table(table), _) => {
                let (own, rate) = part.told.pace.own_time(time);
                table.is_over(own) || rate == 0.0 && part.told.pace.is_over(time)
            }
            (_, Drive::Clock) => part.told.pace.is_over(time),
            _ => false,
        })
    }

    /// Moves as one body with another wall, whose origin in its frame is `its_origin`.
    pub(super) fn follow(&mut self, leader: &Motor, its_origin: DVec3, origin: DVec3) {
        let (then, now) = (self.leader_began, leader.pose);
        if then == now {
            self.pose = self.began;
        } else {
            let point = origin + self.began.translation - its_origin - then.translation;
            if then.rotation == now.rotation {
                self.pose.rotation = self.began.rotation;
                self.pose.translation = self.began.translation + (now.translation - then.translation);
            } else {
                let turned = now.rotation * then.rotation.conjugate();
                self.pose.rotation = turned * self.began.rotation;
                self.pose.translation = its_origin + now.translation + turned * point - origin;
            }
        }
        let arm = origin + self.pose.translation - its_origin - now.translation;
        self.angular_velocity = leader.angular_velocity;
        self.velocity = leader.velocity + leader.angular_velocity.cross(arm);
    }

    /// Load along or about the axis of a part that follows forces, as the parts before it carry that axis now.
    fn effort(&self, part: usize, origin: DVec3) -> f64 {
        let carried = |axis: (DVec3, DVec3)| {
            let time = self.clock.time();
            let before = self.parts[..part].iter().rev();
            before.fold(axis, |axis, part| part.movement(time).carry_axis(axis))
        };
        let (force, torque) = self.load;
        match self.parts[part].joint() {
            None => 0.0,
            Some(Joint::Along(axis)) => force.dot(carried((DVec3::ZERO, axis)).1),
            Some(Joint::About(point, axis)) => {
                let (point, axis) = carried((point, axis));
                let arm = origin + self.pose.translation - point;
                axis.dot(torque + arm.cross(force))
            }
        }
    }

    /// Pose and velocity at the time of the clock; walls that move with another one are moved by it.
    fn evaluate(&mut self, origin: DVec3) {
        if let [part] = self.parts.as_slice()
            && matches!(part.told.motion, Motion::With(_))
        {
            return;
        }
        let mut wall = Carried {
            pose: self.began,
            velocity: DVec3::ZERO,
            angular_velocity: DVec3::ZERO,
            belt: DVec3::ZERO,
        };
        let time = self.clock.time();
        for part in self.parts.iter().rev() {
            part.movement(time).carry(&mut wall, origin);
        }
        (self.pose, self.velocity, self.angular_velocity) = (wall.pose, wall.velocity, wall.angular_velocity);
        self.belt = wall.belt;
    }
}

#[cfg(test)]
#[path = "motor_tests.rs"]
mod tests;
