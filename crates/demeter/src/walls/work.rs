//! What the grains do to a wall, and the wall to them.

use super::Wall;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Sums over time of what passed between a wall and the grains; a force acts from half a step before its moment to half a step after it, as in
/// the energy books.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct WallWork {
    /// Force of the grains on the wall, by time [N s].
    pub impulse: DVec3,
    /// Torque of the grains on it about its origin, by time [N m s].
    pub turning: DVec3,
    /// Work of the wall on the grains [J].
    pub work: f64,
    /// What acts now: force [N], torque [N m], power [W].
    latest: (DVec3, DVec3, f64),
    /// What of it the springs of contacts do to walls with servos: force [N] and torque [N m].
    springs: (DVec3, DVec3),
}

impl WallWork {
    /// What was done since another moment.
    #[must_use]
    pub fn since(&self, before: &Self) -> Self {
        Self {
            impulse: self.impulse - before.impulse,
            turning: self.turning - before.turning,
            work: self.work - before.work,
            latest: self.latest,
            springs: self.springs,
        }
    }

    fn add(&mut self, (force, torque, power): (DVec3, DVec3, f64), dt: f64) {
        let (former_force, former_torque, former_power) = self.latest;
        self.impulse += (former_force + force) * (0.5 * dt);
        self.turning += (former_torque + torque) * (0.5 * dt);
        self.work += (former_power + power) * (0.5 * dt);
        self.latest = (force, torque, power);
    }
}

impl Wall {
    /// What passed between the wall and the grains since the start of the run.
    pub fn work(&self) -> &WallWork {
        &self.work
    }

    /// Rate of the work of the wall on the grains [W]; of a belt on a wall that is not flat, of its whole load.
    pub fn power(&self) -> f64 {
        -(self.force.dot(self.motor.velocity + self.belt_along()) + self.torque.dot(self.motor.angular_velocity))
    }

    /// Velocity of the surface along itself [m/s]: contacts do not feel what of a belt points along their normal.
    fn belt_along(&self) -> DVec3 {
        let belt = self.motor.belt;
        match self.surface().flat_normal() {
            Some(normal) if belt != DVec3::ZERO => {
                let normal = self.motor.pose.turn(normal);
                belt - normal * belt.dot(normal)
            }
            _ => belt,
        }
    }

    /// Force of the grains on the wall [N] and their torque about its [`origin`](Self::origin) [N m].
    pub fn load(&self) -> (DVec3, DVec3) {
        (self.force, self.torque)
    }

    /// What acts does so with the velocity of another motion from now on.
    pub(super) fn go_on_working(&mut self) {
        self.work.latest.2 = self.power();
    }

    /// Tells what of the load the springs of contacts do: force [N] and torque about the origin [N m].
    pub(crate) fn set_springs(&mut self, springs: (DVec3, DVec3)) {
        self.work.springs = springs;
    }

    /// Adds what these springs do with the present velocity for so long [s], and tells it [J].
    pub(crate) fn add_work_of_springs(&mut self, time: f64) -> f64 {
        let (force, torque) = self.work.springs;
        let power = -(force.dot(self.motor.velocity) + torque.dot(self.motor.angular_velocity));
        self.work.work += power * time;
        power * time
    }

    /// Adds what its load did in the latest step of `dt` [s].
    pub(crate) fn add_work(&mut self, dt: f64) {
        let now = (self.force, self.torque, self.power());
        self.work.add(now, dt);
    }
}
