//! Moves a wall: evaluates its motion at the time of its own clock.

use super::motion::Motion;
use super::pose::{Pose, rotation_about};
use super::servo::Servo;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

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

/// A motion, its clock, where it began and where it has come.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Motor {
    motion: Motion,
    clock: Clock,
    began: Pose,
    pub(super) pose: Pose,
    /// Velocity of the origin [m/s].
    pub(super) velocity: DVec3,
    /// Angular velocity [1/s].
    pub(super) angular_velocity: DVec3,
    servo: Option<Servo>,
}

impl Motor {
    /// Begins a motion at a pose. `origin` is the wall's origin in the wall frame.
    pub(super) fn new(motion: Motion, pose: Pose, origin: DVec3) -> Self {
        let servo = match motion {
            Motion::Servo { force, max_speed, .. } => Some(Servo::new(force, max_speed)),
            _ => None,
        };
        let mut motor = Motor {
            motion,
            clock: Clock::default(),
            began: pose,
            pose,
            velocity: DVec3::ZERO,
            angular_velocity: DVec3::ZERO,
            servo,
        };
        motor.evaluate(origin);
        motor
    }

    /// Moves by one step; `load` is the force of the grains on the wall in the last step [N].
    pub(super) fn advance(&mut self, dt: f64, load: DVec3, origin: DVec3) {
        self.clock.advance(dt);
        if let (Motion::Servo { axis, .. }, Some(servo)) = (&self.motion, &mut self.servo) {
            self.velocity = *axis * servo.speed(-load.dot(*axis));
            self.pose.translation += self.velocity * dt;
        } else {
            self.evaluate(origin);
        }
    }

    /// Pose and velocity of a prescribed motion at the time of the clock.
    fn evaluate(&mut self, origin: DVec3) {
        let time = self.clock.time();
        let began = self.began.translation;
        match &self.motion {
            Motion::Rest | Motion::Servo { .. } => {}
            Motion::Velocity(velocity) => {
                self.velocity = *velocity;
                self.pose.translation = began + *velocity * time;
            }
            Motion::Oscillation {
                amplitude,
                frequency,
                phase,
            } => {
                let pulsation = TAU * frequency;
                let angle = pulsation * time + phase;
                self.velocity = *amplitude * (pulsation * libm::cos(angle));
                self.pose.translation = began + *amplitude * (libm::sin(angle) - libm::sin(*phase));
            }
            Motion::Rotation {
                point,
                axis,
                angular_velocity,
            } => {
                self.angular_velocity = *axis * *angular_velocity;
                let arm = origin + began - *point;
                if *angular_velocity != 0.0 && time != 0.0 {
                    let turned = rotation_about(*axis, angular_velocity * time);
                    self.pose.rotation = turned * self.began.rotation;
                    self.pose.translation = began + (turned * arm - arm);
                }
                let arm_now = origin + self.pose.translation - *point;
                self.velocity = self.angular_velocity.cross(arm_now);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ORIGIN: DVec3 = DVec3::new(0.5, -0.25, 2.0);

    fn run(motion: Motion, dt: f64, steps: u32) -> Motor {
        let mut motor = Motor::new(motion, Pose::START, ORIGIN);
        for _ in 0..steps {
            motor.advance(dt, DVec3::ZERO, ORIGIN);
        }
        motor
    }

    #[test]
    fn constant_velocity_gathers_no_rounding() {
        let velocity = DVec3::new(0.1, -0.3, 0.7);
        let motor = run(Motion::Velocity(velocity), 1e-5, 1_000_000);
        assert_eq!(motor.pose.translation, velocity * (1e-5 * 1e6));
        assert_eq!((motor.velocity, motor.angular_velocity), (velocity, DVec3::ZERO));
    }

    #[test]
    fn a_full_turn_returns_and_the_speed_is_that_of_the_arm() {
        let axis = DVec3::new(0.0, 0.6, 0.8);
        let point = DVec3::new(1.0, 1.0, 1.0);
        let motion = Motion::Rotation {
            point,
            axis,
            angular_velocity: TAU,
        };
        let motor = run(motion, 1e-4, 10_000);
        assert!(motor.pose.translation.length() < 1e-14);
        assert!((motor.pose.rotation * DVec3::X - DVec3::X).length() < 1e-14);
        assert!((motor.velocity - (axis * TAU).cross(ORIGIN - point)).length() < 1e-13);
    }

    #[test]
    fn velocities_are_derivatives_of_the_pose() {
        let motions = [
            Motion::Rotation {
                point: DVec3::ONE,
                axis: DVec3::Y,
                angular_velocity: -3.0,
            },
            Motion::Oscillation {
                amplitude: DVec3::new(0.1, 0.0, -0.2),
                frequency: 2.0,
                phase: 0.4,
            },
        ];
        for motion in motions {
            let dt = 1e-5;
            let (before, now, after) = (
                run(motion.clone(), dt, 999),
                run(motion.clone(), dt, 1000),
                run(motion, dt, 1001),
            );
            let slope = (after.pose.translation - before.pose.translation) / (2.0 * dt);
            assert!((slope - now.velocity).length() < 1e-6, "{slope} {}", now.velocity);
            let x = DVec3::new(0.3, 0.1, 0.9);
            let turning = (after.pose.rotation * x - before.pose.rotation * x) / (2.0 * dt);
            assert!((turning - now.angular_velocity.cross(now.pose.rotation * x)).length() < 1e-6);
        }
    }

    #[test]
    fn a_new_motion_starts_where_the_last_one_ended() {
        let mut motor = run(Motion::Velocity(DVec3::X), 0.1, 5);
        let there = motor.pose;
        motor = Motor::new(
            Motion::Oscillation {
                amplitude: DVec3::Z,
                frequency: 1.0,
                phase: 1.0,
            },
            there,
            ORIGIN,
        );
        assert_eq!(motor.pose, there);
        assert!((motor.velocity - DVec3::Z * (TAU * 1f64.cos())).length() < 1e-14);
        motor.advance(1.0, DVec3::ZERO, ORIGIN);
        assert!((motor.pose.translation - there.translation).length() < 1e-14);
    }

    #[test]
    fn a_change_of_the_step_keeps_the_time() {
        let mut clock = Clock::default();
        for _ in 0..10 {
            clock.advance(0.5);
        }
        clock.advance(0.25);
        clock.advance(0.25);
        assert_eq!(clock.time(), 5.5);
    }
}
