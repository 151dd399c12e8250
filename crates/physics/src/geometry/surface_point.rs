//! The closest point of a surface to the centre of a sphere.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// On which side of a closed surface the grains are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Side {
    /// The surface contains the grains.
    Inside,
    /// The grains are around it.
    Outside,
    /// The surface is a thin shell with grains on both sides, as a tube that is lifted off a heap.
    Both,
}

impl Side {
    /// Sign of the outward direction on the side of a grain whose centre lies `offset` outside the surface: +1 outside,
    /// -1 inside.
    #[inline(always)]
    pub(crate) fn sign(self, offset: f64) -> f64 {
        match self {
            Side::Inside => -1.0,
            Side::Outside => 1.0,
            Side::Both if offset < 0.0 => -1.0,
            Side::Both => 1.0,
        }
    }
}

/// Part of a surface on which the closest point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feature {
    /// In the interior of the surface.
    Face,
    /// On an edge or rim, counted from 0.
    Edge(u8),
    /// On a corner or an apex, counted from 0.
    Vertex(u8),
}

/// Closest point of a surface to the centre of a sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Unit vector from the surface towards the centre: the direction of a repulsive force on the sphere.
    pub normal: DVec3,
    /// Distance of the centre from the surface [m]; negative when the centre is behind a one-sided surface.
    pub distance: f64,
    /// The closest point itself [m].
    pub foot: DVec3,
    /// Part of the surface on which the foot lies.
    pub feature: Feature,
}

impl SurfacePoint {
    /// A point on an edge, a corner or a plate, that pushes the centre straight away from the foot.
    /// A centre on the foot itself is pushed along `fallback`.
    #[inline]
    pub fn away_from(foot: DVec3, centre: DVec3, fallback: DVec3, feature: Feature) -> Self {
        let (normal, distance) = direction(centre - foot, fallback);
        SurfacePoint {
            normal,
            distance,
            foot,
            feature,
        }
    }
}

/// What is nearer to an end than this share of the whole is at the end: rounding leaves no place that lies in the faces of two surfaces
/// of which one begins where the other ends.
pub const AT_END: f64 = 1e-12;

/// Whether a coordinate lies between 0 and a length, and not at its ends.
#[inline(always)]
pub(crate) fn is_between_ends(along: f64, length: f64) -> bool {
    let end = AT_END * length;
    along >= end && along <= length - end
}

/// The square of a smaller length may vanish.
pub(crate) const LEAST_LENGTH: f64 = 1e-140;

/// Unit vector and length of `v`; the zero vector gives `(fallback, 0)`. Safe down to the smallest numbers, where the
/// square of a length vanishes.
#[inline]
pub(crate) fn direction(v: DVec3, fallback: DVec3) -> (DVec3, f64) {
    let length = v.length();
    if length > LEAST_LENGTH {
        return (v / length, length);
    }
    let largest = v.abs().max_element();
    if largest > 0.0 {
        let scaled = v / largest;
        let length = scaled.length();
        (scaled / length, length * largest)
    } else {
        (fallback, 0.0)
    }
}

/// A unit vector perpendicular to the unit vector `axis`, always the same for the same axis.
#[inline]
pub fn perpendicular(axis: DVec3) -> DVec3 {
    let magnitude = axis.abs();
    let least = if magnitude.x <= magnitude.y && magnitude.x <= magnitude.z {
        DVec3::X
    } else if magnitude.y <= magnitude.z {
        DVec3::Y
    } else {
        DVec3::Z
    };
    let across = axis.cross(least);
    across / across.length()
}

/// Place of a point relative to an axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OffAxis {
    /// Height along the axis.
    pub(crate) height: f64,
    /// Distance from the axis.
    pub(crate) distance: f64,
    /// Unit vector from the axis to the point; a fixed one for a point on the axis.
    pub(crate) radial: DVec3,
}

impl OffAxis {
    /// Where `v`, measured from a point of the axis, lies about the unit vector `axis`.
    #[inline]
    pub(crate) fn new(v: DVec3, axis: DVec3) -> Self {
        let height = v.dot(axis);
        let across = v - axis * height;
        // What rounding left along the axis is taken out again, else a point beside the axis has a skew direction; where
        // nothing else is left, the point is on the axis.
        let square = across - axis * across.dot(axis);
        let (radial, distance) = direction(square, DVec3::ZERO);
        let beside = distance > 1e-3 * across.length() && distance > 0.0;
        OffAxis {
            height,
            distance,
            radial: if beside { radial } else { perpendicular(axis) },
        }
    }
}

#[cfg(test)]
pub(crate) mod sampling {
    //! Brute-force oracle: the nearest of many points of a surface.

    use glam::DVec3;

    /// Points of the square `[-2, 2]^3` to test from, on a lattice that avoids symmetry planes.
    pub fn centres() -> Vec<DVec3> {
        let ticks = [-1.93, -1.21, -0.52, 0.03, 0.37, 0.88, 1.64];
        let mut out = Vec::new();
        for x in ticks {
            for y in ticks {
                for z in ticks {
                    out.push(DVec3::new(x, y, z));
                }
            }
        }
        out
    }

    /// Smallest distance of `centre` from points `surface(s, t)` with `s`, `t` in `[0, 1]`, refined around the best.
    pub fn nearest(centre: DVec3, surface: &dyn Fn(f64, f64) -> DVec3) -> f64 {
        let distance = |s: f64, t: f64| surface(s, t).distance(centre);
        let count = 48;
        let mut seeds = Vec::new();
        for i in 0..=count {
            for j in 0..=count {
                let (s, t) = (f64::from(i) / f64::from(count), f64::from(j) / f64::from(count));
                seeds.push((distance(s, t), s, t));
            }
        }
        seeds.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut best = f64::MAX;
        for &(value, s, t) in seeds.iter().take(3) {
            best = best.min(descend(&distance, value, s, t, 1.0 / f64::from(count)));
        }
        best
    }

    fn descend(distance: &dyn Fn(f64, f64) -> f64, value: f64, s: f64, t: f64, mut step: f64) -> f64 {
        let (mut best, mut s, mut t) = (value, s, t);
        while step > 1e-10 {
            let mut moved = false;
            for (ds, dt) in [
                (1.0, 0.0),
                (-1.0, 0.0),
                (0.0, 1.0),
                (0.0, -1.0),
                (1.0, 1.0),
                (-1.0, -1.0),
            ] {
                let (a, b) = ((s + ds * step).clamp(0.0, 1.0), (t + dt * step).clamp(0.0, 1.0));
                let value = distance(a, b);
                if value < best {
                    (best, s, t, moved) = (value, a, b, true);
                }
            }
            if !moved {
                step *= 0.5;
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn direction_is_a_unit_vector_even_where_squares_vanish() {
        for scale in [1.0, 1e-100, 1e-150, 1e-200, 1e-300, 5e-324] {
            let (unit, length) = direction(DVec3::new(scale, -scale, 0.0), DVec3::Z);
            assert!((unit.length() - 1.0).abs() < 1e-15, "{scale:e}: {unit}");
            assert!(length > 0.0);
        }
        assert_eq!(direction(DVec3::ZERO, DVec3::Y), (DVec3::Y, 0.0));
    }

    #[test]
    fn directions_from_an_axis_are_square_to_it_however_near() {
        let axis = DVec3::new(0.2, 0.1, 1.1).normalize();
        let aside = perpendicular(axis);
        for height in [0.0, 0.7, -1e3] {
            for distance in [0.0, 1e-300, 1e-17, 1e-16, 1e-12, 1e-3, 10.0] {
                let found = OffAxis::new(axis * height + aside * distance, axis);
                assert!(found.radial.dot(axis).abs() < 1e-12, "{height} {distance:e} {found:?}");
                assert!((found.radial.length() - 1.0).abs() < 1e-14);
                assert!((found.distance - distance).abs() < 1e-15 * (1.0 + height.abs()));
            }
        }
    }

    #[test]
    fn perpendicular_is_perpendicular() {
        for v in [
            DVec3::X,
            DVec3::Y,
            DVec3::Z,
            -DVec3::X,
            DVec3::new(0.6, 0.0, 0.8),
            DVec3::ONE / 3f64.sqrt(),
        ] {
            let p = perpendicular(v);
            assert!(p.dot(v).abs() < 1e-15 && (p.length() - 1.0).abs() < 1e-15);
        }
    }
}
