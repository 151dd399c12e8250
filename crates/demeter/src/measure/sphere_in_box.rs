//! The part of a sphere that lies in an axis-parallel box, exactly.
//!
//! With `W(a, b, c)` the volume of the unit ball where `x > a`, `y > b`, `z > c`, the volume in a box is the alternating
//! sum of `W` over the eight corners. A negative argument is reflected, as `W(-a, b, c) = W(b, c) - W(a, b, c)`; without
//! negative arguments the body is bounded by planes and by a patch of the sphere, and the divergence theorem gives
//!
//! ```text
//! 3 W = S - a A_a - b A_b - c A_c
//! S   = sum over vertices (theta) - pi (number of vertices - 2) - a phi_a - b phi_b - c phi_c     (Gauss-Bonnet)
//! ```
//!
//! with the faces `A` in the planes, the angles `phi` over which the patch borders on each plane, and the angles
//! `theta = atan2(sqrt(1 - a^2 - b^2), a b)` of the patch where two planes meet on the sphere. Freireich, Kodam and
//! Wassgren, AIChE J. 56 (2010) 3036, solve the same task by cases. The error is a few units in the last place of the
//! volume of the whole sphere.

use glam::DVec3;
use std::f64::consts::PI;

/// Volume of the unit ball.
const BALL: f64 = 4.0 / 3.0 * PI;

/// Volume of the part of a sphere that lies in the box between two corners [m^3]. Sides of the box may be infinite.
pub fn sphere_in_box(centre: DVec3, radius: f64, lower: DVec3, upper: DVec3) -> f64 {
    let scale = radius * radius * radius;
    let (from, to) = ((lower - centre) / radius, (upper - centre) / radius);
    let outside = from.max_element() >= 1.0 || to.min_element() <= -1.0 || (to - from).min_element() <= 0.0;
    if outside || scale <= 0.0 {
        return 0.0;
    }
    if from.max_element() <= -1.0 && to.min_element() >= 1.0 {
        return BALL * scale;
    }
    let (from, to) = (from.max(DVec3::NEG_ONE), to.min(DVec3::ONE));
    let mut volume = 0.0;
    for corner in 0..8_u32 {
        let at = |axis: usize| if corner >> axis & 1 == 1 { to[axis] } else { from[axis] };
        let sign = if corner.count_ones() % 2 == 1 { -1.0 } else { 1.0 };
        volume += sign * beyond_three(at(0), at(1), at(2));
    }
    volume.clamp(0.0, BALL) * scale
}

/// Volume of the unit ball where `x > a`.
fn beyond_one(a: f64) -> f64 {
    PI / 3.0 * (1.0 - a) * (1.0 - a) * (2.0 + a)
}

/// Volume of the unit ball where `x > a` and `y > b`.
fn beyond_two(a: f64, b: f64) -> f64 {
    if a < 0.0 {
        return beyond_one(b) - beyond_two(-a, b);
    }
    if b < 0.0 {
        return beyond_one(a) - beyond_two(a, -b);
    }
    let rest = 1.0 - a * a - b * b;
    if rest <= 0.0 {
        return 0.0;
    }
    // half the edge in which the planes meet; their faces are segments of circles
    let edge = rest.sqrt();
    let (phi_a, phi_b) = (2.0 * libm::atan2(edge, b), 2.0 * libm::atan2(edge, a));
    let face_a = 0.5 * (1.0 - a * a) * phi_a - b * edge;
    let face_b = 0.5 * (1.0 - b * b) * phi_b - a * edge;
    let patch = 2.0 * libm::atan2(edge, a * b) - a * phi_a - b * phi_b;
    (patch - a * face_a - b * face_b) / 3.0
}

/// Volume of the unit ball where `x > a`, `y > b` and `z > c`.
fn beyond_three(a: f64, b: f64, c: f64) -> f64 {
    if a < 0.0 {
        return beyond_two(b, c) - beyond_three(-a, b, c);
    }
    if b < 0.0 {
        return beyond_two(a, c) - beyond_three(a, -b, c);
    }
    if c < 0.0 {
        return beyond_two(a, b) - beyond_three(a, b, -c);
    }
    if a * a + b * b + c * c >= 1.0 {
        return 0.0;
    }
    // how far along the edge of two planes the sphere is
    let edge = |p: f64, q: f64| (1.0 - p * p - q * q).max(0.0).sqrt();
    let (ab, bc, ca) = (edge(a, b), edge(b, c), edge(c, a));
    let (phi_a, face_a) = face(a, [b, c], [ca, ab]);
    let (phi_b, face_b) = face(b, [c, a], [ab, bc]);
    let (phi_c, face_c) = face(c, [a, b], [bc, ca]);
    let corners = libm::atan2(ab, a * b) + libm::atan2(bc, b * c) + libm::atan2(ca, c * a);
    let patch = corners - PI - a * phi_a - b * phi_b - c * phi_c;
    (patch - a * face_a - b * face_b - c * face_c) / 3.0
}

/// Angle and area of the part of the disc in the plane at `height` where `u > p` and `v > q`; its circle meets `v = q` at
/// `u = along_u` and `u = p` at `v = along_v`.
fn face(height: f64, [p, q]: [f64; 2], [along_u, along_v]: [f64; 2]) -> (f64, f64) {
    let angle = libm::atan2(along_v, p) - libm::atan2(q, along_u);
    let area = 0.5 * ((1.0 - height * height) * angle - p * (along_v - q) - q * (along_u - p));
    (angle, area)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    /// The volume by columns along z over a grid of points.
    fn by_columns(lower: DVec3, upper: DVec3) -> f64 {
        let n = 1200;
        let step = (upper - lower) / f64::from(n);
        let mut sum = 0.0;
        for ix in 0..n {
            let x = lower.x + (f64::from(ix) + 0.5) * step.x;
            for iy in 0..n {
                let y = lower.y + (f64::from(iy) + 0.5) * step.y;
                let half = (1.0 - x * x - y * y).max(0.0).sqrt();
                sum += (upper.z.min(half) - lower.z.max(-half)).max(0.0);
            }
        }
        sum * step.x * step.y
    }

    #[test]
    fn parts_of_a_ball_are_those_of_an_integration() {
        let boxes = [
            // one plane, two, three that meet inside, three that do not, and what is left of a ball in a small box
            (dvec3(0.3, -1.0, -1.0), DVec3::ONE),
            (dvec3(0.3, 0.5, -1.0), DVec3::ONE),
            (dvec3(-0.3, 0.5, -1.0), DVec3::ONE),
            (dvec3(0.3, 0.5, 0.2), DVec3::ONE),
            (dvec3(-0.3, -0.5, -0.2), DVec3::ONE),
            (dvec3(-0.8, -0.7, 0.1), dvec3(0.9, 0.8, 0.6)),
            (dvec3(-0.3, 0.1, 0.2), dvec3(0.6, 0.7, 0.9)),
            (dvec3(-0.9, -0.9, -0.9), dvec3(0.9, 0.9, 0.9)),
        ];
        for (lower, upper) in boxes {
            let (exact, expected) = (sphere_in_box(DVec3::ZERO, 1.0, lower, upper), by_columns(lower, upper));
            assert!((exact - expected).abs() < 2e-5, "{lower} {upper}: {exact}, {expected}");
        }
    }

    #[test]
    fn known_parts_are_exact() {
        let (centre, r) = (dvec3(0.1, -2.0, 3.0), 0.7);
        let ball = BALL * r * r * r;
        let far = DVec3::INFINITY;
        let part = |lower: DVec3, upper: DVec3| sphere_in_box(centre, r, lower, upper) / ball;
        assert!((part(-far, far) - 1.0).abs() < 1e-15);
        assert!((part(centre, far) - 0.125).abs() < 1e-15);
        assert!((part(-far, centre) - 0.125).abs() < 1e-15);
        assert!((part(dvec3(centre.x, -9.0, -9.0), far) - 0.5).abs() < 1e-15);
        assert!((part(dvec3(centre.x, centre.y, -9.0), far) - 0.25).abs() < 1e-15);
        // a box inside of the ball
        let cube = part(centre - 0.3 * r, centre + 0.3 * r);
        assert!((cube * BALL - 0.6 * 0.6 * 0.6).abs() < 1e-14);
        assert_eq!(part(centre + r, far), 0.0);
        assert_eq!(part(centre + 0.6 * r, far), 0.0, "the corner lies outside of the ball");
        assert_eq!(part(far, -far), 0.0);
    }

    #[test]
    fn boxes_that_fill_space_share_the_ball() {
        // pseudo-random cuts; the 27 boxes between them hold the whole ball, one and the same for all units of length
        let mut x = 7u64;
        let mut next = || {
            x = x
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (x >> 11) as f64 / (1u64 << 53) as f64
        };
        for scale in [1e-9, 1.0, 1e6] {
            for _ in 0..200 {
                let centre = DVec3::new(next(), next(), next()) * scale;
                let mut cuts = [[f64::NEG_INFINITY, 0.0, 0.0, f64::INFINITY]; 3];
                for (axis, planes) in cuts.iter_mut().enumerate() {
                    let two = [2.4 * next() - 1.2, 2.4 * next() - 1.2].map(|u| centre[axis] + u * scale);
                    planes[1] = two[0].min(two[1]);
                    planes[2] = two[0].max(two[1]);
                }
                let mut sum = 0.0;
                for cell in 0..27 {
                    let k = [cell % 3, cell / 3 % 3, cell / 9];
                    let corner = |up: usize| DVec3::from_array(std::array::from_fn(|axis| cuts[axis][k[axis] + up]));
                    sum += sphere_in_box(centre, scale, corner(0), corner(1));
                }
                let ball = BALL * scale * scale * scale;
                assert!((sum / ball - 1.0).abs() < 1e-13, "{sum} of {ball}");
            }
        }
    }
}
