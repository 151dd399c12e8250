//! Contact of a sphere and an infinite plane.

use super::{Feature, SurfacePoint};
use glam::DVec3;

/// Infinite plane; the sphere belongs on the side to which the normal points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of the plane [m].
    pub point: DVec3,
    /// Unit normal.
    pub normal: DVec3,
}

/// Closest point of the plane: `d = (c - p) . n`. The normal is that of the plane on whatever side the centre is.
#[inline]
pub fn contact_sphere_plane(plane: &Plane, centre: DVec3) -> SurfacePoint {
    let distance = (centre - plane.point).dot(plane.normal);
    SurfacePoint {
        normal: plane.normal,
        distance,
        foot: centre - plane.normal * distance,
        feature: Feature::Face,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normal_stays_behind_the_plane_and_the_distance_turns_negative() {
        let plane = Plane {
            point: DVec3::new(5.0, 1.0, 2.0),
            normal: DVec3::Z,
        };
        let above = contact_sphere_plane(&plane, DVec3::new(0.0, 0.0, 3.5));
        assert_eq!(
            (above.normal, above.distance, above.foot),
            (DVec3::Z, 1.5, DVec3::new(0.0, 0.0, 2.0))
        );
        let below = contact_sphere_plane(&plane, DVec3::new(0.0, 0.0, 1.5));
        assert_eq!((below.normal, below.distance), (DVec3::Z, -0.5));
    }
}
