//! Where a wall stands.

use super::placed::splat;
use demeter_physics::lanes::{Lanes, Vector};
use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// Place and orientation of a wall relative to its start. A point `x` of the wall frame is in the world at
/// `origin + translation + rotation (x - origin)`, with the wall's own [`origin`](super::Wall::origin).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pose {
    /// Displacement of the origin since the start [m].
    pub translation: DVec3,
    /// Rotation about the origin since the start.
    pub rotation: DQuat,
}

impl Pose {
    /// The pose at the start.
    pub const START: Pose = Pose {
        translation: DVec3::ZERO,
        rotation: DQuat::IDENTITY,
    };

    /// Whether the wall has exactly its first orientation; rotation arithmetic is skipped then, so that a wall that is
    /// not turned gives the same bits as one that cannot turn.
    #[inline(always)]
    pub fn is_unrotated(&self) -> bool {
        self.rotation == DQuat::IDENTITY
    }

    /// Whether all of its numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.translation.is_finite() && self.rotation.is_finite()
    }

    /// World place of a point of the wall frame [m].
    #[inline]
    pub fn place(&self, origin: DVec3, point: DVec3) -> DVec3 {
        if self.is_unrotated() {
            point + self.translation
        } else {
            origin + self.translation + self.rotation * (point - origin)
        }
    }

    /// Wall-frame place of a point of the world [m].
    #[inline]
    pub fn unplace(&self, origin: DVec3, point: DVec3) -> DVec3 {
        if self.is_unrotated() {
            point - self.translation
        } else {
            origin + self.rotation.conjugate() * (point - origin - self.translation)
        }
    }

    /// Wall-frame places of points of the world [m], one in each lane.
    #[inline(always)]
    pub(crate) fn unplace_wide<L: Lanes>(&self, origin: DVec3, points: L::Vector) -> L::Vector {
        if self.is_unrotated() {
            return points - splat::<L>(self.translation);
        }
        let origin = splat::<L>(origin);
        let from_origin = points - origin - splat::<L>(self.translation);
        origin + turned::<L>(self.rotation.conjugate(), from_origin)
    }

    /// Axis of the rotation times its angle [rad], half a turn at most.
    pub fn turning(&self) -> DVec3 {
        let rotation = if self.rotation.w < 0.0 {
            -self.rotation
        } else {
            self.rotation
        };
        let axis = DVec3::new(rotation.x, rotation.y, rotation.z);
        match axis.length() {
            0.0 => DVec3::ZERO,
            sine => axis * (2.0 * libm::atan2(sine, rotation.w) / sine),
        }
    }

    /// World direction of a direction of the wall frame.
    #[inline]
    pub fn turn(&self, direction: DVec3) -> DVec3 {
        if self.is_unrotated() {
            direction
        } else {
            self.rotation * direction
        }
    }

    /// World directions of directions of the wall frame, one in each lane.
    #[inline(always)]
    pub(crate) fn turn_wide<L: Lanes>(&self, directions: L::Vector) -> L::Vector {
        if self.is_unrotated() {
            directions
        } else {
            turned::<L>(self.rotation, directions)
        }
    }
}

/// Vectors turned by a rotation.
#[inline(always)]
fn turned<L: Lanes>(rotation: DQuat, vectors: L::Vector) -> L::Vector {
    let [x, y, z, w] = rotation.to_array();
    let axis = DVec3::new(x, y, z);
    let wide = splat::<L>(axis);
    vectors * L::splat(w * w - axis.length_squared())
        + wide * (vectors.inner(wide) * 2.0)
        + wide.outer(vectors) * L::splat(2.0 * w)
}

/// Rotation by `angle` [rad] about the unit vector `axis`, right-handed; the same bits on every machine.
pub(super) fn rotation_about(axis: DVec3, angle: f64) -> DQuat {
    let (sin, cos) = (libm::sin(0.5 * angle), libm::cos(0.5 * angle));
    DQuat::from_xyzw(axis.x * sin, axis.y * sin, axis.z * sin, cos)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn place_and_unplace_are_inverse() {
        let axis = DVec3::new(1.0, -2.0, 0.5).normalize();
        let pose = Pose {
            translation: DVec3::new(0.1, 2.0, -3.0),
            rotation: rotation_about(axis, 1.3),
        };
        let (origin, point) = (DVec3::new(4.0, 5.0, 6.0), DVec3::new(-1.0, 0.3, 2.0));
        assert!((pose.unplace(origin, pose.place(origin, point)) - point).length() < 1e-14);
        assert!((pose.unplace_wide::<f64>(origin, point) - pose.unplace(origin, point)).length() < 1e-14);
        assert!((pose.turn_wide::<f64>(point) - pose.turn(point)).length() < 1e-14);
        assert!(
            (pose.place(origin, point).distance(pose.place(origin, origin)) - point.distance(origin)).abs() < 1e-14
        );
        assert_eq!(pose.place(origin, origin), origin + pose.translation);
    }

    #[test]
    fn rotation_is_right_handed() {
        let quarter = rotation_about(DVec3::Z, std::f64::consts::FRAC_PI_2);
        assert!((quarter * DVec3::X - DVec3::Y).length() < 1e-15);
        let turning = |angle: f64| {
            let rotation = rotation_about(DVec3::NEG_Y, angle);
            let translation = DVec3::ZERO;
            (Pose { translation, rotation }).turning()
        };
        assert!((turning(0.3) - DVec3::NEG_Y * 0.3).length() < 1e-15 && turning(0.0) == DVec3::ZERO);
        // more than half a turn is less the other way round
        assert!((turning(4.0) - DVec3::Y * (std::f64::consts::TAU - 4.0)).length() < 1e-14);
    }
}
