//! How walls move.
//!
//! A wall has one motion or several that add up: [`Motions`]. Every motion is told as the equipment stands at the moment when
//! it is told, as if the others did not move. **Every part is carried by the parts before it**: the first stands in the world,
//! the second moves in a frame that the first carries, and so on. With the rigid motions `M1(t), M2(t), ...` of the parts a point
//! of the wall that was at `x` is at `M1(M2(...(x)))`. So rotation about the mixer's axis before rotation about the tool's
//! own axis is a planetary mixer; translation and rotation along one axis are a screw; oscillation before rotation is a
//! vibrating drum whose axis shakes, too. The velocity of every point is the exact derivative of its place.

use super::body::BodyMotion;
use super::motion_table::MotionTable;
use super::pace::Pace;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Prescribed, controlled or free motion of a wall.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Motion {
    /// At rest.
    Rest,
    /// Constant velocity [m/s].
    Velocity(DVec3),
    /// The wall stays, and its surface moves along itself with this velocity [m/s], as the belt of a conveyor does. What points along the
    /// normal of a contact does not count there.
    Belt(DVec3),
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
    /// Harmonic rotation to and fro: angle `amplitude (sin(2 pi frequency t + phase) - sin(phase))`.
    Rocking {
        /// A point of the axis [m].
        point: DVec3,
        /// Unit vector along the axis.
        axis: DVec3,
        /// Amplitude of the angle [rad].
        amplitude: f64,
        /// Frequency [Hz].
        frequency: f64,
        /// Phase at the start [rad].
        phase: f64,
    },
    /// Told by a table of times.
    Table(#[serde(with = "shared")] Arc<MotionTable>),
    /// Moves along an axis so that the grains press on the wall with a given force.
    Servo {
        /// Unit vector along which the wall pushes the grains.
        axis: DVec3,
        /// Force with which the wall pushes the grains along the axis [N].
        force: f64,
        /// Largest speed [m/s].
        max_speed: f64,
    },
    /// Turns about an axis so that the wall acts on the grains with a given torque.
    TorqueServo {
        /// A point of the axis [m].
        point: DVec3,
        /// Unit vector along the axis.
        axis: DVec3,
        /// Torque with which the wall turns the grains, right-handed about the axis [N m].
        torque: f64,
        /// Largest angular velocity [1/s].
        max_speed: f64,
    },
    /// Moves freely along or about an axis, under the load of the grains and its own weight.
    Free(FreeMotion),
    /// Moves as a rigid body, under the load of the grains and its own weight.
    Body(BodyMotion),
    /// Moves as one body with another wall, told by its index.
    With(usize),
    /// Stands where [`Wall::drive`](super::Wall::drive) puts it before every step, and rests when nobody does.
    Driven {
        /// A point [m] and the unit vector of the axis that it turns about; `None` where it is shifted.
        axis: Option<(DVec3, DVec3)>,
    },
}

/// A wall that moves freely along an axis, or about a hinge.
///
/// With the coordinate `q` (way along the axis [m], or angle about it [rad]) from where the wall stood when the motion was
/// told: `inertia d2q/dt2 = load + weight(q) - stiffness q - damping dq/dt`. The motions that are told behind it are carried
/// by it and have no inertia of their own.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct FreeMotion {
    /// Along or about what.
    pub freedom: Freedom,
    /// Mass [kg], or moment of inertia about the hinge [kg m^2].
    pub inertia: f64,
    /// Weight of the wall [N]: its mass times the acceleration of gravity.
    pub weight: DVec3,
    /// Spring that holds the wall where it stood when the motion was told [N/m, or N m per radian].
    pub stiffness: f64,
    /// Damper [N s/m, or N m s per radian].
    pub damping: f64,
    /// Speed at the start [m/s or 1/s].
    pub speed: f64,
    /// Coordinates of the stops, where the wall loses its speed [m or rad]; infinite without.
    pub stops: [f64; 2],
}

impl FreeMotion {
    /// Least mass with which a wall within bounds gives way [kg]: of a hinged one, where it is farthest from the hinge.
    pub fn least_mass(&self, bounds: Option<(DVec3, DVec3)>) -> f64 {
        match (self.freedom, bounds) {
            (Freedom::Hinge { point, .. }, Some((lower, upper))) => {
                let reach = (upper - point).abs().max((lower - point).abs()).length();
                self.inertia / (reach * reach)
            }
            _ => self.inertia,
        }
    }
}

/// What a freely moving wall may do.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Freedom {
    /// Slide along an axis.
    Slide {
        /// Unit vector along it.
        axis: DVec3,
    },
    /// Turn about a hinge.
    Hinge {
        /// A point of the hinge [m].
        point: DVec3,
        /// Unit vector along it.
        axis: DVec3,
        /// Centre of mass of the wall [m].
        center_of_mass: DVec3,
    },
}

/// A motion and when it comes to its speed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MotionPart {
    /// The motion.
    pub motion: Motion,
    /// When it starts and stops; only of prescribed motions other than full speed throughout.
    pub pace: Pace,
}

/// All motions of a wall, which add up: every part is carried by the parts before it. None: the wall is at rest.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Motions {
    /// The parts, from the one that stands in the world to the one that moves the wall itself.
    pub parts: Vec<MotionPart>,
}

impl Motions {
    /// At rest.
    pub fn rest() -> Self {
        Self::default()
    }

    /// Whether no part moves the wall.
    pub fn is_rest(&self) -> bool {
        self.parts.iter().all(|part| matches!(part.motion, Motion::Rest))
    }

    /// Whether the wall stays where it is, though its surface may move along itself.
    pub fn stays(&self) -> bool {
        (self.parts.iter()).all(|part| matches!(part.motion, Motion::Rest | Motion::Belt(_)))
    }

    /// Whether it moves freely: such a motion is always the first.
    pub fn is_free(&self) -> bool {
        matches!(
            self.parts.first().map(|part| &part.motion),
            Some(Motion::Free(_) | Motion::Body(_))
        )
    }

    /// Whether some part turns the wall by what it is told, or as a torque lets it.
    pub fn turns(&self) -> bool {
        self.parts.iter().any(|part| match &part.motion {
            Motion::Rotation { .. } | Motion::Rocking { .. } | Motion::TorqueServo { .. } => true,
            Motion::Table(table) => table.axis().is_some(),
            Motion::Driven { axis } => axis.is_some(),
            Motion::Free(free) => matches!(free.freedom, Freedom::Hinge { .. }),
            Motion::Body(body) => body.turns.contains(&true),
            Motion::Rest
            | Motion::Velocity(_)
            | Motion::Belt(_)
            | Motion::Oscillation { .. }
            | Motion::Servo { .. }
            | Motion::With(_) => false,
        })
    }

    /// The wall that this one moves with as one body, if any.
    pub fn leader(&self) -> Option<usize> {
        self.parts.iter().find_map(|part| match part.motion {
            Motion::With(wall) => Some(wall),
            _ => None,
        })
    }

    /// Why they never come to an end, as the first part that does not tells; nothing where all of them do.
    pub fn never_ends(&self) -> Option<&'static str> {
        self.parts.iter().find_map(|part| match &part.motion {
            Motion::Servo { .. } | Motion::TorqueServo { .. } => Some("its servo follows the load for ever"),
            Motion::Free(_) | Motion::Body(_) => Some("it moves as its load lets it, for ever"),
            Motion::With(_) => Some("it moves with another wall, whose motion may be named"),
            Motion::Driven { .. } => Some("it is moved from outside, by whoever knows when to end"),
            Motion::Table(table) if table.comes_to_rest() => None,
            _ if part.pace.stop_after.is_finite() => None,
            Motion::Table(_) => Some("its table goes on behind the last row, and no `stop_after` ends it"),
            _ => Some("no `stop_after` ends it"),
        })
    }
}

impl From<Motion> for Motions {
    fn from(motion: Motion) -> Self {
        let parts = match motion {
            Motion::Rest => Vec::new(),
            motion => vec![MotionPart {
                motion,
                pace: Pace::FULL,
            }],
        };
        Self { parts }
    }
}

/// A table is shared by all stages that tell it.
mod shared {
    use super::{Arc, MotionTable};
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(super) fn serialize<S: Serializer>(table: &Arc<MotionTable>, to: S) -> Result<S::Ok, S::Error> {
        table.as_ref().serialize(to)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Arc<MotionTable>, D::Error> {
        let table = MotionTable::deserialize(from)?;
        if table.is_whole() {
            Ok(Arc::new(table))
        } else {
            Err(serde::de::Error::custom(
                "the columns of a table of motion differ in length",
            ))
        }
    }
}
