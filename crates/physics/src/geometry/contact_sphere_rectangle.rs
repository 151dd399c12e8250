//! Contact of a sphere and a rectangular plate without thickness.

use super::surface_point::is_between_ends;
use super::{Feature, SurfacePoint};
use glam::DVec3;

/// Rectangular plate; touches spheres on both sides and at its edges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// Centre [m].
    pub center: DVec3,
    /// Unit vectors along the two edges, perpendicular to each other.
    pub axes: [DVec3; 2],
    /// Half lengths along the two axes [m].
    pub half: [f64; 2],
}

impl Rectangle {
    /// Unit normal of the plate.
    #[inline]
    pub fn normal(&self) -> DVec3 {
        self.axes[0].cross(self.axes[1])
    }
}

/// Closest point of the plate. Edges: 0 and 1 at `-half` and `+half` of the first axis, 2 and 3 of the second; corners:
/// bit 0 and bit 1 of the number tell the positive end of the first and second axis.
/// A centre in the plate is pushed along the plate's normal.
#[inline]
pub fn contact_sphere_rectangle(plate: &Rectangle, centre: DVec3) -> SurfacePoint {
    let from_centre = centre - plate.center;
    let at = [from_centre.dot(plate.axes[0]), from_centre.dot(plate.axes[1])];
    let held = [
        at[0].clamp(-plate.half[0], plate.half[0]),
        at[1].clamp(-plate.half[1], plate.half[1]),
    ];
    let foot = plate.center + plate.axes[0] * held[0] + plate.axes[1] * held[1];
    let normal = plate.normal();
    let height = from_centre.dot(normal);
    let facing = if height < 0.0 { -normal } else { normal };
    let positive = [u8::from(at[0] > 0.0), u8::from(at[1] > 0.0)];
    let within = [0, 1].map(|k| is_between_ends(at[k] + plate.half[k], 2.0 * plate.half[k]));
    let feature = match (within[0], within[1]) {
        (true, true) => {
            return SurfacePoint {
                normal: facing,
                distance: height.abs(),
                foot,
                feature: Feature::Face,
            };
        }
        (false, true) => Feature::Edge(positive[0]),
        (true, false) => Feature::Edge(2 + positive[1]),
        (false, false) => Feature::Vertex(positive[0] + 2 * positive[1]),
    };
    SurfacePoint::away_from(foot, centre, facing, feature)
}

#[cfg(test)]
mod tests {
    use super::super::surface_point::sampling::{centres, nearest};
    use super::*;

    #[test]
    fn agrees_with_brute_force() {
        let u = DVec3::new(0.6, 0.8, 0.0);
        let v = DVec3::new(-0.8, 0.6, 0.0).cross(u).cross(u) + DVec3::new(0.0, 0.0, 0.4);
        let v = (v - u * v.dot(u)).normalize();
        let plate = Rectangle {
            center: DVec3::new(0.1, -0.2, 0.3),
            axes: [u, v],
            half: [0.9, 0.4],
        };
        let surface = |s: f64, t: f64| plate.center + u * (0.9 * (2.0 * s - 1.0)) + v * (0.4 * (2.0 * t - 1.0));
        let mut features = [0; 3];
        for centre in centres() {
            let found = contact_sphere_rectangle(&plate, centre);
            assert!(
                (found.distance - nearest(centre, &surface)).abs() < 1e-7,
                "{centre} {found:?}"
            );
            assert!((found.foot + found.normal * found.distance - centre).length() < 1e-13);
            features[match found.feature {
                Feature::Face => 0,
                Feature::Edge(_) => 1,
                Feature::Vertex(_) => 2,
            }] += 1;
        }
        assert!(features.iter().all(|&n| n > 10), "{features:?}");
    }

    #[test]
    fn a_centre_in_the_plate_is_pushed_along_its_normal() {
        let plate = Rectangle {
            center: DVec3::ZERO,
            axes: [DVec3::X, DVec3::Y],
            half: [1.0, 1.0],
        };
        for centre in [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0), DVec3::new(-1.0, 0.3, 0.0)] {
            let found = contact_sphere_rectangle(&plate, centre);
            assert_eq!((found.normal, found.distance), (DVec3::Z, 0.0));
        }
    }
}
