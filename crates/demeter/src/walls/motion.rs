//! How walls move.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Prescribed or controlled motion of a wall.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Motion {
    /// At rest.
    Rest,
    /// Constant velocity [m/s].
    Velocity(DVec3),
    /// Rotation about an axis.
    Rotation {
        /// A point of the axis [m].
        point: DVec3,
        /// Unit vector along the axis.
        axis: DVec3,
        /// Angular velocity, right-handed about the axis [1/s].
        angular_velocity: f64,
    },
    /// Harmonic oscillation about the place where the wall stood when the motion was told:
    /// displacement `amplitude (sin(2 pi frequency t + phase) - sin(phase))`, `t` from the start of the motion.
    Oscillation {
        /// Amplitude and direction [m].
        amplitude: DVec3,
        /// Frequency [Hz].
        frequency: f64,
        /// Phase at the start [rad].
        phase: f64,
    },
    /// Moves along an axis so that the grains press on the wall with a given force.
    Servo {
        /// Unit vector along which the wall pushes the grains.
        axis: DVec3,
        /// Force with which the wall pushes the grains along the axis [N].
        force: f64,
        /// Largest speed [m/s].
        max_speed: f64,
    },
}
