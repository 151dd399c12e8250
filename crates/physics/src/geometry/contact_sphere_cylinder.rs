//! Contact of a sphere and the lateral surface of a finite cylinder with open ends.

use super::surface_point::{OffAxis, is_between_ends};
use super::{Feature, Side, SurfacePoint};
use glam::DVec3;

/// Lateral surface of a cylinder, without caps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Start of the axis [m].
    pub start: DVec3,
    /// Unit vector along the axis.
    pub axis: DVec3,
    /// Length along the axis [m].
    pub length: f64,
    /// Radius [m].
    pub radius: f64,
    /// Where the sphere belongs.
    pub side: Side,
}

/// Closest point of the cylinder. Between the ends the sphere is pushed to its side even when its centre has crossed;
/// beyond an end the rim is an edge (`Edge(0)` at the start, `Edge(1)` at the end) that pushes straight away.
/// A centre on the axis takes a fixed radial direction.
#[inline]
pub fn contact_sphere_cylinder(cylinder: &Cylinder, centre: DVec3) -> SurfacePoint {
    let OffAxis {
        height,
        distance: off_axis,
        radial,
    } = OffAxis::new(centre - cylinder.start, cylinder.axis);
    let along = height.clamp(0.0, cylinder.length);
    let foot = cylinder.start + cylinder.axis * along + radial * cylinder.radius;
    let outward = cylinder.side.sign(off_axis - cylinder.radius);
    if is_between_ends(height, cylinder.length) {
        return SurfacePoint {
            normal: radial * outward,
            distance: (off_axis - cylinder.radius) * outward,
            foot,
            feature: Feature::Face,
        };
    }
    let rim = Feature::Edge(u8::from(height > 0.5 * cylinder.length));
    SurfacePoint::away_from(foot, centre, radial * outward, rim)
}

#[cfg(test)]
mod tests {
    use super::super::surface_point::perpendicular;
    use super::super::surface_point::sampling::{centres, nearest};
    use super::*;
    use std::f64::consts::TAU;

    fn example(side: Side) -> Cylinder {
        let axis = DVec3::new(1.0, 2.0, -0.5).normalize();
        Cylinder {
            start: DVec3::new(-0.4, -0.6, 0.3),
            axis,
            length: 1.7,
            radius: 0.8,
            side,
        }
    }

    #[test]
    fn agrees_with_brute_force() {
        let cylinder = example(Side::Outside);
        let u = perpendicular(cylinder.axis);
        let v = cylinder.axis.cross(u);
        let surface = |s: f64, t: f64| {
            let (sin, cos) = (s * TAU).sin_cos();
            cylinder.start + cylinder.axis * (t * cylinder.length) + (u * cos + v * sin) * cylinder.radius
        };
        for centre in centres() {
            for side in [Side::Inside, Side::Outside, Side::Both] {
                let found = contact_sphere_cylinder(&example(side), centre);
                let expected = nearest(centre, &surface);
                assert!(
                    (found.distance.abs() - expected).abs() < 1e-7,
                    "{centre}: {found:?} {expected}"
                );
                assert!((found.foot + found.normal * found.distance - centre).length() < 1e-12);
                assert!((found.normal.length() - 1.0).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn both_sides_push_their_own_way() {
        let centre = DVec3::new(0.0, 0.9, 0.5);
        let mut c = Cylinder {
            start: DVec3::ZERO,
            axis: DVec3::Z,
            length: 1.0,
            radius: 1.0,
            side: Side::Inside,
        };
        let inside = contact_sphere_cylinder(&c, centre);
        assert_eq!(inside.normal, -DVec3::Y);
        assert!((inside.distance - 0.1).abs() < 1e-15);
        c.side = Side::Outside;
        let outside = contact_sphere_cylinder(&c, centre);
        assert_eq!(outside.normal, DVec3::Y);
        assert!((outside.distance + 0.1).abs() < 1e-15);
        c.side = Side::Both;
        assert_eq!(contact_sphere_cylinder(&c, centre), inside);
        let beside = contact_sphere_cylinder(&c, DVec3::new(0.0, 1.1, 0.5));
        assert_eq!(beside.normal, DVec3::Y);
        assert!((beside.distance - 0.1).abs() < 1e-15);
    }

    #[test]
    fn a_centre_on_the_axis_or_on_the_rim_has_a_unit_normal() {
        let c = example(Side::Inside);
        let rim = c.start + perpendicular(c.axis) * c.radius;
        for centre in [
            c.start,
            c.start + c.axis * 0.5,
            c.start - c.axis,
            c.start + c.axis * 9.0,
            rim,
        ] {
            let found = contact_sphere_cylinder(&c, centre);
            assert!((found.normal.length() - 1.0).abs() < 1e-12, "{found:?}");
            assert!(found.distance.is_finite());
        }
    }
}
