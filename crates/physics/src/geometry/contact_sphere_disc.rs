//! Contact of a sphere and a circular plate without thickness.

use super::surface_point::{AT_END, OffAxis};
use super::{Feature, SurfacePoint};
use glam::DVec3;

/// Circular plate; touches spheres on both sides and at its rim.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Centre [m].
    pub center: DVec3,
    /// Unit normal.
    pub normal: DVec3,
    /// Radius [m].
    pub radius: f64,
}

/// Closest point of the plate; the rim is `Edge(0)`. A centre in the plate is pushed along the plate's normal.
#[inline]
pub fn contact_sphere_disc(disc: &Disc, centre: DVec3) -> SurfacePoint {
    let OffAxis {
        height,
        distance: off_axis,
        radial,
    } = OffAxis::new(centre - disc.center, disc.normal);
    let facing = if height < 0.0 { -disc.normal } else { disc.normal };
    if off_axis <= disc.radius * (1.0 - AT_END) {
        return SurfacePoint {
            normal: facing,
            distance: height.abs(),
            foot: centre - disc.normal * height,
            feature: Feature::Face,
        };
    }
    let foot = disc.center + radial * disc.radius;
    SurfacePoint::away_from(foot, centre, facing, Feature::Edge(0))
}

#[cfg(test)]
mod tests {
    use super::super::surface_point::perpendicular;
    use super::super::surface_point::sampling::{centres, nearest};
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn agrees_with_brute_force() {
        let normal = DVec3::new(0.2, -0.5, 0.7).normalize();
        let disc = Disc {
            center: DVec3::new(0.1, 0.2, -0.1),
            normal,
            radius: 0.9,
        };
        let u = perpendicular(normal);
        let v = normal.cross(u);
        let surface = |s: f64, t: f64| {
            let (sin, cos) = (s * TAU).sin_cos();
            disc.center + (u * cos + v * sin) * (t * disc.radius)
        };
        for centre in centres() {
            let found = contact_sphere_disc(&disc, centre);
            assert!(
                (found.distance - nearest(centre, &surface)).abs() < 1e-6,
                "{centre} {found:?}"
            );
            assert!((found.foot + found.normal * found.distance - centre).length() < 1e-13);
        }
        let middle = contact_sphere_disc(&disc, disc.center);
        assert_eq!((middle.normal, middle.distance), (normal, 0.0));
    }
}
