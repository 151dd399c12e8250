//! Contact of a sphere and the lateral surface of a (truncated) cone with open ends.

use super::surface_point::{OffAxis, direction, is_between_ends};
use super::{Feature, Side, SurfacePoint};
use glam::DVec3;

/// Lateral surface of a cone, without caps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// Start of the axis [m].
    pub start: DVec3,
    /// Unit vector along the axis.
    pub axis: DVec3,
    /// Length along the axis [m].
    pub length: f64,
    /// Radius at the start [m]; 0 makes it the apex.
    pub start_radius: f64,
    /// Radius at the end [m]; 0 makes it the apex.
    pub end_radius: f64,
    /// Where the sphere belongs.
    pub side: Side,
}

/// Closest point of the cone, found in the half plane of axis and centre, in which the cone is a segment.
///
/// Between the ends the sphere is pushed to its side even when its centre has crossed. A rim is an edge (`Edge(0)` at
/// the start, `Edge(1)` at the end) that pushes straight away. An apex (`Vertex`) is closed: it pushes to the side of
/// the sphere. A centre on the axis takes a fixed radial direction.
#[inline]
pub fn contact_sphere_cone(cone: &Cone, centre: DVec3) -> SurfacePoint {
    let OffAxis {
        height,
        distance: off_axis,
        radial,
    } = OffAxis::new(centre - cone.start, cone.axis);
    let rise = cone.end_radius - cone.start_radius;
    let slant = (cone.length * cone.length + rise * rise).sqrt();
    let tangent = (cone.length / slant, rise / slant);
    let offset = off_axis - cone.start_radius;
    let along = height * tangent.0 + offset * tangent.1;
    let beside = offset * tangent.0 - height * tangent.1;
    let outward = cone.side.sign(beside);
    let normal = (radial * tangent.0 - cone.axis * tangent.1) * outward;
    if is_between_ends(along, slant) {
        let foot_radius = cone.start_radius + along * tangent.1;
        return SurfacePoint {
            normal,
            distance: beside * outward,
            foot: cone.start + cone.axis * (along * tangent.0) + radial * foot_radius,
            feature: Feature::Face,
        };
    }
    let (end, end_height, end_radius) = if along > 0.5 * slant {
        (1, cone.length, cone.end_radius)
    } else {
        (0, 0.0, cone.start_radius)
    };
    let foot = cone.start + cone.axis * end_height + radial * end_radius;
    if end_radius > 0.0 {
        return SurfacePoint::away_from(foot, centre, normal, Feature::Edge(end));
    }
    let beyond = if end == 1 { cone.axis } else { -cone.axis };
    let (outward_normal, distance) = direction(centre - foot, beyond);
    SurfacePoint {
        normal: outward_normal * outward,
        distance: distance * outward,
        foot,
        feature: Feature::Vertex(end),
    }
}

#[cfg(test)]
mod tests {
    use super::super::surface_point::perpendicular;
    use super::super::surface_point::sampling::{centres, nearest};
    use super::*;
    use std::f64::consts::TAU;

    fn example(start_radius: f64, end_radius: f64, side: Side) -> Cone {
        let axis = DVec3::new(-0.3, 0.4, 1.1).normalize();
        Cone {
            start: DVec3::new(0.2, -0.3, -0.7),
            axis,
            length: 1.3,
            start_radius,
            end_radius,
            side,
        }
    }

    #[test]
    fn agrees_with_brute_force() {
        for (a, b) in [(0.2, 1.1), (1.0, 0.3), (0.0, 0.9), (0.7, 0.0), (0.5, 0.5)] {
            let cone = example(a, b, Side::Outside);
            let u = perpendicular(cone.axis);
            let v = cone.axis.cross(u);
            let surface = |s: f64, t: f64| {
                let (sin, cos) = (s * TAU).sin_cos();
                cone.start + cone.axis * (t * cone.length) + (u * cos + v * sin) * (a + t * (b - a))
            };
            for centre in centres() {
                for side in [Side::Inside, Side::Outside, Side::Both] {
                    let found = contact_sphere_cone(&example(a, b, side), centre);
                    let expected = nearest(centre, &surface);
                    // The search of the oracle may stop early beside the apex, but never below the true minimum.
                    let excess = expected - found.distance.abs();
                    assert!(
                        (-1e-12..1e-4).contains(&excess),
                        "{a} {b} {centre}: {found:?} {expected}"
                    );
                    assert!((found.foot + found.normal * found.distance - centre).length() < 1e-12);
                    assert!((found.normal.length() - 1.0).abs() < 1e-14);
                }
            }
        }
    }

    #[test]
    fn the_apex_is_closed_and_pushes_to_the_side_of_the_sphere() {
        let mut cone = example(0.0, 0.9, Side::Inside);
        let below = cone.start - cone.axis * 0.1;
        let inside = contact_sphere_cone(&cone, below);
        assert_eq!(inside.feature, Feature::Vertex(0));
        assert!((inside.normal - cone.axis).length() < 1e-14 && (inside.distance + 0.1).abs() < 1e-15);
        cone.side = Side::Outside;
        let outside = contact_sphere_cone(&cone, below);
        assert!((outside.normal + cone.axis).length() < 1e-14 && (outside.distance - 0.1).abs() < 1e-15);
        let at_apex = contact_sphere_cone(&cone, cone.start);
        assert!((at_apex.normal.length() - 1.0).abs() < 1e-14 && at_apex.distance.abs() < 1e-15);
    }
}
