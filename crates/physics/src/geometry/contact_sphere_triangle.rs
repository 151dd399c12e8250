//! Contact of a sphere and a triangle without thickness.

use super::{Feature, SurfacePoint};
use glam::DVec3;

/// Triangle; touches spheres on both sides, at its edges and at its corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    corners: [DVec3; 3],
    normal: DVec3,
}

impl Triangle {
    /// Smallest area that a triangle may have, as a share of the square of its longest edge. Below it the normal is lost
    /// in rounding.
    pub const LEAST_RELATIVE_AREA: f64 = 1e-12;

    /// Triangle with these corners [m]; `None` when a corner is not finite or the area is zero to rounding.
    pub fn new(corners: [DVec3; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let longest = (b - a).length().max((c - b).length()).max((a - c).length());
        if !(longest > 0.0 && longest.is_finite()) {
            return None;
        }
        let across = ((b - a) / longest).cross((c - a) / longest);
        let length = across.length();
        (length > 2.0 * Self::LEAST_RELATIVE_AREA).then(|| Triangle {
            corners,
            normal: across / length,
        })
    }

    /// Corners [m].
    #[inline]
    pub fn corners(&self) -> [DVec3; 3] {
        self.corners
    }

    /// Unit normal, right-handed about the corners in order.
    #[inline]
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// The closest point when it is known to lie in the interior of the face: the projection on the plane.
    #[inline]
    pub fn face_point(&self, centre: DVec3) -> SurfacePoint {
        let height = (centre - self.corners[0]).dot(self.normal);
        SurfacePoint {
            normal: if height < 0.0 { -self.normal } else { self.normal },
            distance: height.abs(),
            foot: centre - self.normal * height,
            feature: Feature::Face,
        }
    }
}

/// Closest point of the triangle. `Edge(k)` runs from corner `k` to corner `k + 1`, `Vertex(k)` is corner `k`.
/// A centre in the triangle is pushed along the triangle's normal.
///
/// Regions as in C. Ericson, *Real-Time Collision Detection* (2005), section 5.1.5.
#[inline]
pub fn contact_sphere_triangle(triangle: &Triangle, centre: DVec3) -> SurfacePoint {
    let [a, b, c] = triangle.corners;
    let (ab, ac) = (b - a, c - a);
    let from_a = centre - a;
    let (d1, d2) = (ab.dot(from_a), ac.dot(from_a));
    let at = |foot, feature| SurfacePoint::away_from(foot, centre, triangle.normal, feature);
    if d1 <= 0.0 && d2 <= 0.0 {
        return at(a, Feature::Vertex(0));
    }
    let from_b = centre - b;
    let (d3, d4) = (ab.dot(from_b), ac.dot(from_b));
    if d3 >= 0.0 && d4 <= d3 {
        return at(b, Feature::Vertex(1));
    }
    let beside_ab = d1 * d4 - d3 * d2;
    if beside_ab <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return at(a + ab * share(d1, -d3), Feature::Edge(0));
    }
    let from_c = centre - c;
    let (d5, d6) = (ab.dot(from_c), ac.dot(from_c));
    if d6 >= 0.0 && d5 <= d6 {
        return at(c, Feature::Vertex(2));
    }
    let beside_ca = d5 * d2 - d1 * d6;
    if beside_ca <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return at(a + ac * share(d2, -d6), Feature::Edge(2));
    }
    let beside_bc = d3 * d6 - d5 * d4;
    if beside_bc <= 0.0 && d4 >= d3 && d5 >= d6 {
        return at(b + (c - b) * share(d4 - d3, d5 - d6), Feature::Edge(1));
    }
    triangle.face_point(centre)
}

/// `part / (part + rest)` for two parts that are not negative; 0 when both vanish.
#[inline(always)]
fn share(part: f64, rest: f64) -> f64 {
    let whole = part + rest;
    if whole > 0.0 { part / whole } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::super::surface_point::sampling::{centres, nearest};
    use super::*;

    fn example() -> Triangle {
        let corners = [
            DVec3::new(-0.7, -0.9, 0.2),
            DVec3::new(1.2, -0.1, 0.5),
            DVec3::new(-0.3, 1.4, -0.6),
        ];
        Triangle::new(corners).unwrap()
    }

    #[test]
    fn agrees_with_brute_force() {
        let triangle = example();
        let [a, b, c] = triangle.corners();
        let surface = |s: f64, t: f64| {
            let (s, t) = if s + t > 1.0 { (1.0 - s, 1.0 - t) } else { (s, t) };
            a + (b - a) * s + (c - a) * t
        };
        let (mut faces, mut edges, mut vertices) = (0, [0; 3], [0; 3]);
        for centre in centres() {
            let found = contact_sphere_triangle(&triangle, centre);
            let by_sampling = nearest(centre, &surface);
            // The folded parametrisation has a kink, so sampling may stop early, but it is never below the true minimum.
            assert!(
                found.distance <= by_sampling + 1e-12,
                "{centre} {found:?} {by_sampling}"
            );
            assert!(
                (found.distance - by_sampling).abs() < 2e-3,
                "{centre} {found:?} {by_sampling}"
            );
            assert!((found.foot + found.normal * found.distance - centre).length() < 1e-13);
            assert!((found.normal.length() - 1.0).abs() < 1e-14);
            match found.feature {
                Feature::Face => faces += 1,
                Feature::Edge(k) => edges[usize::from(k)] += 1,
                Feature::Vertex(k) => vertices[usize::from(k)] += 1,
            }
        }
        assert!(
            faces > 5 && edges.iter().chain(&vertices).all(|&n| n > 5),
            "{faces} {edges:?} {vertices:?}"
        );
    }

    #[test]
    fn flat_and_broken_triangles_are_refused() {
        let p = DVec3::new(1.0, 2.0, 3.0);
        assert!(Triangle::new([p, p, p]).is_none());
        assert!(Triangle::new([p, p * 2.0, p * 3.0]).is_none());
        assert!(Triangle::new([p, DVec3::NAN, DVec3::ZERO]).is_none());
        assert!(Triangle::new([p, DVec3::INFINITY, DVec3::ZERO]).is_none());
        let small = 1e-9;
        assert!(Triangle::new([DVec3::ZERO, DVec3::X * small, DVec3::Y * small]).is_some());
    }

    #[test]
    fn corners_and_centroid_have_finite_unit_normals() {
        let triangle = example();
        let [a, b, c] = triangle.corners();
        for centre in [a, b, c, (a + b) / 2.0, (b + c) / 2.0, (a + b + c) / 3.0] {
            let found = contact_sphere_triangle(&triangle, centre);
            assert!(
                found.distance < 1e-15 && (found.normal.length() - 1.0).abs() < 1e-12,
                "{found:?}"
            );
        }
    }
}
