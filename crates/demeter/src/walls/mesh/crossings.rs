//! Triangles of a mesh that pass through one another, or lie on one another in one plane.
//!
//! Two convex bodies are apart, or only touch, where along some direction their shadows overlap by no more than nothing.
//! For two triangles it is enough to look along their normals, along the products of their edges, and in their planes
//! across their edges (S. Gottschalk, M. C. Lin and D. Manocha, SIGGRAPH 1996). Triangles that share an edge or a corner
//! touch, and so do those whose corner lies on a neighbour: none of them is told.

use super::weld::ROUNDING;
use crate::walls::hierarchy::Hierarchy;
use demeter_physics::geometry::contact_sphere_triangle::Triangle;
use glam::DVec3;

/// Overlap that is rounding, as a multiple of the rounding of the largest coordinate.
const ROUNDINGS: f64 = 4.0;
/// Sine of the angle of two edges below which they are parallel and tell no direction.
const PARALLEL: f64 = 1e-10;
/// Most pairs of near triangles that are looked at, so that a mesh of a million triangles in one place ends, too.
const MOST_PAIRS: usize = 50_000_000;

/// Triangles that cross.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Crossings {
    /// Pairs of triangles that pass through or lie on one another.
    pub count: usize,
    /// The first pair, counted from 1.
    pub first: [usize; 2],
    /// Where the first pair meets, to the size of the smaller of the two [m].
    pub place: DVec3,
    /// Triangles that were held against all others: fewer than all when too many lie in one place.
    pub looked_at: usize,
}

pub(super) fn crossings(triangles: &[Triangle], hierarchy: &Hierarchy) -> Crossings {
    let (lower, upper) = hierarchy.bounds();
    let rounding = ROUNDINGS * ROUNDING * lower.abs().max(upper.abs()).max_element();
    let mut found = Crossings::default();
    let mut pairs = 0;
    for (index, triangle) in triangles.iter().enumerate() {
        let (lower, upper) = bounds(triangle);
        hierarchy.visit_box(lower, upper, |other| {
            let other_index = other as usize;
            if other_index <= index {
                return;
            }
            pairs += 1;
            if pairs <= MOST_PAIRS && cross(triangle, &triangles[other_index], rounding) {
                if found.count == 0 {
                    found.first = [index + 1, other_index + 1];
                    let (l, u) = bounds(&triangles[other_index]);
                    found.place = 0.5 * (lower.max(l) + upper.min(u));
                }
                found.count += 1;
            }
        });
        if pairs > MOST_PAIRS {
            break;
        }
        found.looked_at = index + 1;
    }
    found
}

/// Where a triangle of a mesh passes through one of others, told by their corners in the frame of that mesh.
pub(super) fn meeting(
    triangles: &[Triangle],
    hierarchy: &Hierarchy,
    others: impl Iterator<Item = [DVec3; 3]>,
) -> Option<DVec3> {
    let (least, most) = hierarchy.bounds();
    let mut pairs = 0;
    for other in others.filter_map(Triangle::new) {
        let (lower, upper) = bounds(&other);
        let largest = (least.abs().max(most.abs())).max(lower.abs().max(upper.abs()));
        let rounding = ROUNDINGS * ROUNDING * largest.max_element();
        let mut met = None;
        hierarchy.visit_box(lower, upper, |index| {
            pairs += 1;
            let triangle = &triangles[index as usize];
            if met.is_none() && pairs <= MOST_PAIRS && cross(triangle, &other, rounding) {
                let (l, u) = bounds(triangle);
                met = Some(0.5 * (lower.max(l) + upper.min(u)));
            }
        });
        if met.is_some() || pairs > MOST_PAIRS {
            return met;
        }
    }
    None
}

fn bounds(triangle: &Triangle) -> (DVec3, DVec3) {
    let [a, b, c] = triangle.corners();
    (a.min(b).min(c), a.max(b).max(c))
}

/// Whether two triangles have more than a rim or a point in common.
fn cross(first: &Triangle, second: &Triangle, rounding: f64) -> bool {
    let (a, b) = (first.corners(), second.corners());
    let overlap = |axis: DVec3| {
        let shadow = |corners: &[DVec3; 3]| {
            let along = corners.map(|corner| (corner - a[0]).dot(axis));
            let [x, y, z] = along;
            (x.min(y).min(z), x.max(y).max(z))
        };
        let (of_a, of_b) = (shadow(&a), shadow(&b));
        (of_a.1 - of_b.0).min(of_b.1 - of_a.0)
    };
    let apart = |axis: DVec3| overlap(axis) <= rounding;
    let height = |corners: &[DVec3; 3], of: &Triangle| {
        let above = corners.map(|corner| (corner - of.corners()[0]).dot(of.normal()).abs());
        above[0].max(above[1]).max(above[2])
    };
    let coplanar = height(&b, first) <= rounding && height(&a, second) <= rounding;
    if !coplanar && (apart(first.normal()) || apart(second.normal())) {
        return false;
    }
    let edges = |corners: &[DVec3; 3]| [0, 1, 2].map(|k| (corners[(k + 1) % 3] - corners[k]).normalize_or_zero());
    let (of_a, of_b) = (edges(&a), edges(&b));
    let in_plane = |edges: &[DVec3; 3], normal: DVec3| edges.iter().any(|edge| apart(edge.cross(normal)));
    if in_plane(&of_a, first.normal()) || in_plane(&of_b, second.normal()) {
        return false;
    }
    if coplanar {
        return true;
    }
    !of_a.iter().any(|u| {
        of_b.iter().any(|v| {
            let axis = u.cross(*v);
            let sine = axis.length();
            sine > PARALLEL && apart(axis / sine)
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn p(x: f64, y: f64, z: f64) -> DVec3 {
        DVec3::new(x, y, z)
    }

    fn crosses(a: [DVec3; 3], b: [DVec3; 3]) -> bool {
        let both = [Triangle::new(a).unwrap(), Triangle::new(b).unwrap()];
        let found = cross(&both[0], &both[1], 1e-7);
        assert_eq!(found, cross(&both[1], &both[0], 1e-7));
        found
    }

    #[test]
    fn touching_is_not_crossing() {
        let base = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(0.0, 1.0, 0.0)];
        let [a, b, c] = base;
        let up = p(0.2, 0.2, 1.0);
        assert!(!crosses(base, [a, b, up]), "a shared edge");
        assert!(!crosses(base, [b, a, p(0.5, -1.0, 0.0)]), "a shared edge in one plane");
        assert!(!crosses(base, [a, up, p(-1.0, -1.0, -0.5)]), "a shared corner");
        assert!(
            !crosses(base, [a, p(-1.0, 0.0, 0.0), p(0.0, -1.0, 0.0)]),
            "a shared corner in one plane"
        );
        assert!(
            !crosses(base, [p(0.2, 0.2, 0.0), up, p(0.4, 0.3, 1.0)]),
            "a corner on the face"
        );
        assert!(
            !crosses(base, [p(0.2, 0.0, 0.0), p(0.7, 0.0, 0.0), p(0.5, -1.0, 0.3)]),
            "an edge along an edge"
        );
        assert!(
            !crosses(base, [p(0.5, 0.5, 0.5), p(0.5, 0.5, 1.5), p(1.5, 0.5, 1.0)]),
            "above"
        );
        assert!(
            !crosses(base, [c, p(2.0, 2.0, -1.0), p(2.0, 2.0, 1.0)]),
            "through the plane, beside the face"
        );
    }

    #[test]
    fn passing_through_and_lying_on_are_told() {
        let base = [p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0), p(0.0, 1.0, 0.0)];
        let [a, b, _] = base;
        assert!(crosses(base, [p(0.2, 0.2, -1.0), p(0.2, 0.2, 1.0), p(2.0, 2.0, 0.0)]));
        assert!(
            crosses(base, [a, p(0.3, 0.3, -1.0), p(0.3, 0.3, 1.0)]),
            "through the face from a shared corner"
        );
        assert!(crosses(base, [a, b, p(0.3, 0.6, 0.0)]), "folded onto its neighbour");
        assert!(
            crosses(base, [p(0.1, 0.1, 0.0), p(0.3, 0.1, 0.0), p(0.1, 0.3, 0.0)]),
            "inside, in one plane"
        );
        assert!(
            crosses(base, [p(-1.0, 0.2, 0.0), p(3.0, 0.2, 0.0), p(3.0, 0.3, 0.0)]),
            "across, in one plane"
        );
    }
}
