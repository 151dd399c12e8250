//! Contact of a sphere and a spherical wall around or below it.

use super::surface_point::direction;
use super::{Feature, Side, SurfacePoint};
use glam::DVec3;

/// Spherical wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shell {
    /// Centre [m].
    pub center: DVec3,
    /// Radius [m].
    pub radius: f64,
    /// Where the sphere belongs.
    pub side: Side,
}

/// Closest point of the shell. The sphere is pushed to its side even when its centre has crossed; a centre in the
/// middle takes the z axis as the outward direction.
#[inline]
pub fn contact_sphere_shell(shell: &Shell, centre: DVec3) -> SurfacePoint {
    let (radial, off_centre) = direction(centre - shell.center, DVec3::Z);
    let outward = shell.side.sign(off_centre - shell.radius);
    SurfacePoint {
        normal: radial * outward,
        distance: (off_centre - shell.radius) * outward,
        foot: shell.center + radial * shell.radius,
        feature: Feature::Face,
    }
}

#[cfg(test)]
mod tests {
    use super::super::surface_point::sampling::{centres, nearest};
    use super::*;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn agrees_with_brute_force() {
        let center = DVec3::new(0.1, 0.2, -0.3);
        let surface = |s: f64, t: f64| {
            let (sin, cos) = (s * TAU).sin_cos();
            let (up, out) = ((t * PI).cos(), (t * PI).sin());
            center + DVec3::new(out * cos, out * sin, up) * 1.1
        };
        for centre in centres() {
            for (side, sign) in [(Side::Inside, -1.0), (Side::Outside, 1.0)] {
                let found = contact_sphere_shell(
                    &Shell {
                        center,
                        radius: 1.1,
                        side,
                    },
                    centre,
                );
                assert!((found.distance.abs() - nearest(centre, &surface)).abs() < 1e-6);
                assert_eq!(found.distance * sign > 0.0, centre.distance(center) > 1.1);
                assert!((found.foot + found.normal * found.distance - centre).length() < 1e-13);
            }
        }
        let middle = contact_sphere_shell(
            &Shell {
                center,
                radius: 1.1,
                side: Side::Inside,
            },
            center,
        );
        assert_eq!((middle.normal, middle.distance), (-DVec3::Z, 1.1));
    }
}
