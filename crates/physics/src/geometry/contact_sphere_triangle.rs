//! Contact of a sphere and a triangle without thickness.

use super::surface_point::LEAST_LENGTH;
use super::{Feature, SurfacePoint};
use crate::lanes::{Index, Lanes, MOST_LANES, Vector, fetch_ahead};
use bytemuck::NoUninit;
use glam::DVec3;

/// Triangle; touches spheres on both sides, at its edges and at its corners.
#[derive(Clone, Copy, Debug, PartialEq, NoUninit)]
#[repr(C)]
pub struct Triangle {
    corners: [DVec3; 3],
    normal: DVec3,
}

/// Rows of four numbers that make up a triangle.
const ROWS: u32 = 3;

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

    /// Mean of the corners [m].
    pub fn centroid(&self) -> DVec3 {
        self.corners.iter().sum::<DVec3>() / 3.0
    }

    /// Lower and upper corner of the smallest box around it [m].
    pub fn bounds(&self) -> (DVec3, DVec3) {
        let [a, b, c] = self.corners;
        (a.min(b).min(c), a.max(b).max(c))
    }

    /// Unit normal, right-handed about the corners in order.
    #[inline]
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Has a triangle that is needed soon fetched into the caches.
    #[inline(always)]
    pub fn fetch_ahead(&self) {
        fetch_ahead(&self.corners[0]);
        // the triangle may reach into another line
        fetch_ahead(&self.normal.z);
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

/// Closest points of triangles, one per lane.
#[derive(Clone, Copy, Debug)]
pub struct ClosestPoints<L: Lanes> {
    /// Unit vector from the triangle towards the centre.
    pub normal: L::Vector,
    /// Distance of the centre from the triangle [m].
    pub distance: L,
    /// On which part of the triangle they lie: 0 in the face, from 1 on edges, from 4 on corners.
    features: L,
}

impl<L: Lanes> ClosestPoints<L> {
    /// Points that are nowhere.
    #[inline(always)]
    pub fn nowhere() -> Self {
        Self {
            normal: L::Vector::null(),
            distance: L::splat(f64::INFINITY),
            features: L::splat(0.0),
        }
    }

    /// These where the mask holds, `no` elsewhere.
    #[inline(always)]
    #[must_use]
    pub fn or(self, mask: L::Mask, no: Self) -> Self {
        Self {
            normal: self.normal.or(mask, no.normal),
            distance: L::select(mask, self.distance, no.distance),
            features: L::select(mask, self.features, no.features),
        }
    }

    /// On which part of its triangle the point of every lane lies.
    #[inline(always)]
    pub fn features(&self) -> Features {
        Features(self.features.to_array())
    }
}

/// On which part of its triangle the closest point of every lane lies.
#[derive(Clone, Copy, Debug)]
pub struct Features([f64; MOST_LANES]);

impl Features {
    /// That of a lane.
    #[inline(always)]
    pub fn of(&self, lane: usize) -> Feature {
        match self.0[lane] as u8 {
            0 => Feature::Face,
            code @ ..4 => Feature::Edge(code - 1),
            code => Feature::Vertex(code - 4),
        }
    }
}

/// The same as [`contact_sphere_triangle`], bit for bit, of a triangle out of a list for each lane. A centre that is nearer than the
/// square root of the smallest numbers counts as one in the triangle.
#[inline(always)]
pub fn contact_sphere_triangle_wide<L: Lanes>(
    triangles: &[Triangle],
    index: &Index,
    centre: L::Vector,
) -> ClosestPoints<L> {
    let rows: &[[f64; 4]] = bytemuck::cast_slice(triangles);
    let mut first_rows = [0; MOST_LANES];
    let mut lane = 0;
    while lane < L::COUNT {
        first_rows[lane] = ROWS * index[lane];
        lane += 1;
    }
    let [[ax, ay, az, bx], [by, bz, cx, cy], [cz, nx, ny, nz]] = L::fetch([rows, &rows[1..], &rows[2..]], &first_rows);
    let (a, b, c) = (
        L::Vector::new(ax, ay, az),
        L::Vector::new(bx, by, bz),
        L::Vector::new(cx, cy, cz),
    );
    let normal = L::Vector::new(nx, ny, nz);
    let zero = L::splat(0.0);

    let (ab, ac) = (b - a, c - a);
    let (from_a, from_b, from_c) = (centre - a, centre - b, centre - c);
    let (d1, d2) = (ab.inner(from_a), ac.inner(from_a));
    let (d3, d4) = (ab.inner(from_b), ac.inner(from_b));
    let (d5, d6) = (ab.inner(from_c), ac.inner(from_c));
    let at_a = zero.ge(d1) & zero.ge(d2);
    let at_b = d3.ge(zero) & d3.ge(d4);
    let at_c = d6.ge(zero) & d6.ge(d5);
    let on_ab = zero.ge(d1 * d4 - d3 * d2) & d1.ge(zero) & zero.ge(d3);
    let on_ca = zero.ge(d5 * d2 - d1 * d6) & d2.ge(zero) & zero.ge(d6);
    let on_bc = zero.ge(d3 * d6 - d5 * d4) & d4.ge(d3) & d5.ge(d6);

    // what comes later here is asked first there
    let mut spot = Spot::<L> {
        start: b,
        along: c - b,
        part: d4 - d3,
        rest: d5 - d6,
        feature: L::select(on_bc, L::splat(2.0), zero),
    };
    spot.put(on_ca, (a, ac), (d2, -d6), 3.0);
    spot.put(at_c, (c, ac), (zero, zero), 6.0);
    spot.put(on_ab, (a, ab), (d1, -d3), 1.0);
    spot.put(at_b, (b, ab), (zero, zero), 5.0);
    spot.put(at_a, (a, ab), (zero, zero), 4.0);

    let whole = spot.part + spot.rest;
    let share = (spot.part / whole).keep(whole.gt(zero));
    let apart = centre - (spot.start + spot.along * share);
    let length = apart.square().sqrt();
    let [x, y, z] = apart.components();
    let is_off = length.gt(L::splat(LEAST_LENGTH));
    let away = L::Vector::new(x / length, y / length, z / length).or(is_off, normal);

    let height = from_a.inner(normal);
    let up = (-normal).or(height.lt(zero), normal);
    let is_beside = spot.feature.gt(zero);
    ClosestPoints {
        normal: away.or(is_beside, up),
        distance: L::select(is_beside, length.keep(is_off), height.abs()),
        features: spot.feature,
    }
}

/// Where on the rim of a triangle the closest point lies.
struct Spot<L: Lanes> {
    start: L::Vector,
    along: L::Vector,
    part: L,
    rest: L,
    feature: L,
}

impl<L: Lanes> Spot<L> {
    /// Takes another place where the mask holds.
    #[inline(always)]
    fn put(&mut self, mask: L::Mask, (start, along): (L::Vector, L::Vector), (part, rest): (L, L), feature: f64) {
        self.start = start.or(mask, self.start);
        self.along = along.or(mask, self.along);
        self.part = L::select(mask, part, self.part);
        self.rest = L::select(mask, rest, self.rest);
        self.feature = L::select(mask, L::splat(feature), self.feature);
    }
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
    use crate::lanes::{self, Instructions, Kernel};

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

    struct Wide<'a>(&'a [Triangle], &'a [DVec3]);

    impl Kernel for Wide<'_> {
        type Output = Vec<(DVec3, f64, Feature)>;

        #[inline(always)]
        fn run<L: Lanes>(self) -> Self::Output {
            let Self(triangles, centres) = self;
            let mut found = Vec::new();
            for first in (0..centres.len()).step_by(L::COUNT) {
                let at = |lane: usize| (first + lane).min(centres.len() - 1);
                let index = std::array::from_fn(|lane| (at(lane) % triangles.len()) as u32);
                let mut components = [[0.0; MOST_LANES]; 3];
                for (axis, lanes) in components.iter_mut().enumerate() {
                    for (lane, number) in lanes.iter_mut().enumerate() {
                        *number = centres[at(lane)][axis];
                    }
                }
                let [x, y, z] = components.map(|lanes| L::load(&lanes));
                let points = contact_sphere_triangle_wide::<L>(triangles, &index, L::Vector::new(x, y, z));
                let [x, y, z] = points.normal.components().map(|lanes| lanes.to_array());
                let (distance, features) = (points.distance.to_array(), points.features());
                for lane in 0..L::COUNT.min(centres.len() - first) {
                    found.push((DVec3::new(x[lane], y[lane], z[lane]), distance[lane], features.of(lane)));
                }
            }
            found
        }
    }

    #[test]
    fn lanes_have_the_bits_of_one() {
        let example = example();
        let [a, b, c] = example.corners();
        let triangles = [
            example,
            Triangle::new([c, b, a]).unwrap(),
            Triangle::new([DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1e-7, 0.0)]).unwrap(),
        ];
        let mut at = centres();
        at.extend(triangles.iter().flat_map(|triangle| {
            let [a, b, c] = triangle.corners();
            [
                a,
                b,
                c,
                (a + b) * 0.5,
                (b + c) * 0.5,
                (c + a) * 0.5,
                (a + b + c) / 3.0,
                a - triangle.normal(),
                DVec3::ZERO,
            ]
        }));
        at.push(DVec3::splat(f64::NAN));
        for shift in 0..triangles.len() {
            at.rotate_right(shift);
            for instructions in Instructions::available() {
                let found = lanes::run(instructions, Wide(&triangles, &at));
                for (k, (normal, distance, feature)) in found.into_iter().enumerate() {
                    let expected = contact_sphere_triangle(&triangles[k % triangles.len()], at[k]);
                    let told = (normal.to_array(), distance, feature);
                    let bits = |n: f64| {
                        if n.is_nan() {
                            f64::NAN.to_bits()
                        } else {
                            (n + 0.0).to_bits()
                        }
                    };
                    assert_eq!(feature, expected.feature, "{} {told:?} {expected:?}", at[k]);
                    assert_eq!(
                        bits(distance),
                        bits(expected.distance),
                        "{} {told:?} {expected:?}",
                        at[k]
                    );
                    assert_eq!(
                        normal.to_array().map(bits),
                        expected.normal.to_array().map(bits),
                        "{} {told:?} {expected:?}",
                        at[k]
                    );
                }
            }
        }
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
