//! Equilibrium of Johnson, Kendall and Roberts (1971): contact radius, force and energy over the overlap.
//!
//! With `z = sqrt(a)` the overlap is a polynomial in the contact radius `a`,
//! `d = (z^4 - 4 z_c^3 z)/R`, `F = 4 E/(3 R) z^3 (z^3 - 6 z_c^3)`, and all depends on adhesion through the root `z_c` of
//! the radius at tear-off, `z_c^6 = a_c^3 = pi w R^2/(8 E)`. Without adhesion `z_c = 0`, and this is Hertz.

use super::NormalResponse;
use crate::contact::PairSize;
use crate::lanes::{Lanes, cube_root};

/// A Hertzian collision that reaches the contact radius `a` takes `c sqrt(m/(4/3 E a))`; `c` is
/// [`crate::restitution::duration::UNDAMPED`] times `(4/5)^(-1/10)`.
const DURATION: f64 = crate::restitution::duration::UNDAMPED * 1.022_565_182_563_573;

/// Steps of Halley's method, each of which leaves the cube of the error.
const HALLEY_STEPS: usize = 2;

/// `(sqrt(6) - 1)^2`.
const SEED: f64 = 2.101_020_514_433_644;

/// The curve of one contact per lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JkrCurve<L = f64> {
    /// Effective modulus [Pa].
    modulus: f64,
    /// Radius of curvature [m].
    radius: L,
    /// Overlap at which the undeformed surfaces touch [m].
    origin: L,
    /// Square root of the contact radius at tear-off [m^(1/2)].
    least_root: L,
}

/// `sqrt(2 pi w/E)` [m^(1/2)]: what adhesion takes from the overlap is this times the root of the contact radius.
pub fn adhesion_length_root(work_of_adhesion: f64, modulus: f64) -> f64 {
    (2.0 * std::f64::consts::PI * work_of_adhesion / modulus).sqrt()
}

/// A response whose damping is told as the mean root of the contact radius: with the area that this is, and the dashpot
/// `alpha sqrt(m 4/3 E a)`.
#[inline(always)]
pub fn of_mean_root<L: Lanes>(
    response: NormalResponse<L>,
    size: PairSize<L>,
    alpha: L,
    modulus: f64,
) -> NormalResponse<L> {
    let contact_radius = response.damping * response.damping;
    NormalResponse {
        damping: response.damping * alpha * (size.mass * (4.0 / 3.0 * modulus)).sqrt(),
        bearing_overlap: contact_radius * contact_radius / size.radius,
        ..response
    }
}

impl<L: Lanes> JkrCurve<L> {
    /// The curve of spheres with an effective modulus [Pa] and radius [m]; `adhesion` is [`adhesion_length_root`].
    #[inline(always)]
    pub fn new(modulus: f64, radius: L, adhesion: f64, origin: L) -> Self {
        Self {
            modulus,
            radius,
            origin,
            least_root: cube_root(radius * (0.25 * adhesion)),
        }
    }

    /// `yes` where the mask holds, `no` elsewhere, of curves of one modulus.
    #[inline(always)]
    pub fn select(mask: L::Mask, yes: Self, no: Self) -> Self {
        Self {
            modulus: no.modulus,
            radius: L::select(mask, yes.radius, no.radius),
            origin: L::select(mask, yes.origin, no.origin),
            least_root: L::select(mask, yes.least_root, no.least_root),
        }
    }

    /// Radius of curvature [m].
    #[inline(always)]
    pub fn radius(&self) -> L {
        self.radius
    }

    /// Overlap at which the undeformed surfaces touch [m].
    #[inline(always)]
    pub fn origin(&self) -> L {
        self.origin
    }

    /// Square root of the contact radius at tear-off [m^(1/2)].
    #[inline(always)]
    pub fn least_root(&self) -> L {
        self.least_root
    }

    /// `z_c^3`.
    #[inline(always)]
    fn least_cube(&self) -> L {
        self.least_root * self.least_root * self.least_root
    }

    /// Gap at which the contact tears off, before the origin: `3 a_c^2/R` [m].
    #[inline(always)]
    pub fn tear_off_distance(&self) -> L {
        self.least_cube() * self.least_root * 3.0 / self.radius
    }

    /// Overlap at which the contact tears off [m].
    #[inline(always)]
    pub fn tear_off(&self) -> L {
        self.origin - self.tear_off_distance()
    }

    /// Square root of the contact radius at an overlap [m^(1/2)]; that at tear-off below its overlap.
    ///
    /// With `z = z_c + t` the polynomial is `t^2 (6 z_c^2 + 4 z_c t + t^2) = R d + 3 z_c^4`, well conditioned down to the
    /// tear-off, where two roots of `z` meet. With `q` for the root of the right side, `q/(z_c + sqrt((sqrt(6) - 1)^2 z_c^2 + q))` is
    /// `t` at both ends and within 0.4 % between, and two of Halley's steps leave rounding.
    #[inline(always)]
    pub fn root(&self, overlap: L) -> L {
        let least = self.least_root;
        let square = least * least;
        let right = self.radius * (overlap - self.origin) + square * square * 3.0;
        let root = right.sqrt();
        let mut t = root / (least + (square * SEED + root).sqrt());
        for _ in 0..HALLEY_STEPS {
            let value = t * t * (square * 6.0 + t * (least * 4.0 + t)) - right;
            // a fourth of the slope, and of its own
            let slope = t * (square * 3.0 + t * (least * 3.0 + t));
            let bend = square * 3.0 + t * (least * 6.0 + t * 3.0);
            t = t - value * slope * 2.0 / (slope * slope * 8.0 - value * bend);
        }
        L::select(right.gt(L::splat(0.0)), least + t, least)
    }

    /// Overlap of a contact with this root of the contact radius [m].
    #[inline(always)]
    pub fn overlap(&self, root: L) -> L {
        self.origin + root * (root * root * root - self.least_cube() * 4.0) / self.radius
    }

    /// Force of a contact with this root of the contact radius [N].
    #[inline(always)]
    pub fn force(&self, root: L) -> L {
        let cube = root * root * root;
        cube * (cube - self.least_cube() * 6.0) / self.radius * (4.0 / 3.0 * self.modulus)
    }

    /// Energy that such a contact gives back on its way to the tear-off [J]: the integral of the force from there.
    #[inline(always)]
    pub fn energy(&self, root: L) -> L {
        let least3 = self.least_cube();
        let least6 = least3 * least3;
        let cube = root * root * root;
        let inside = cube * (cube * 0.1 - least3) + least6 * 1.5;
        let at_tear_off = least6 * least3 * self.least_root * 0.6;
        (cube * root * inside - at_tear_off) / (self.radius * self.radius) * (16.0 / 3.0 * self.modulus)
    }

    /// Tangent stiffness of such a contact [N/m]; negative before the tear-off, and there without bound but
    /// for rounding.
    #[inline(always)]
    pub fn stiffness(&self, root: L) -> L {
        let least3 = self.least_cube();
        let cube = root * root * root;
        let above = (cube - least3).max(least3 * f64::EPSILON);
        let stiffness = root * root * (cube - least3 * 3.0) / above * (2.0 * self.modulus);
        stiffness.keep(above.gt(L::splat(0.0)))
    }
}

impl JkrCurve {
    /// Duration of a Hertzian collision that reaches the contact radius of this overlap [s], at least that of the
    /// equilibrium without load; the small oscillation about it takes as long to 1 %.
    pub fn collision_time(&self, overlap: f64, mass: f64) -> f64 {
        let at_rest = libm::cbrt(6.0) * self.least_root;
        let root = self.root(self.origin + overlap).max(at_rest);
        DURATION * (mass / (4.0 / 3.0 * self.modulus)).sqrt() / root
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use std::f64::consts::PI;

    const MODULUS: f64 = 3.4e9;

    fn curves() -> Vec<(f64, f64, JkrCurve)> {
        let mut all = Vec::new();
        for radius in [1e-7, 2.5e-6, 1e-3, 0.7] {
            for work in [1e-6, 0.05, 3.0] {
                let curve = JkrCurve::new(MODULUS, radius, adhesion_length_root(work, MODULUS), 0.0);
                all.push((radius, work, curve));
            }
        }
        all
    }

    /// Equations of the paper.
    fn overlap_of(radius: f64, work: f64, a: f64) -> f64 {
        a * a / radius - (2.0 * PI * a * work / MODULUS).sqrt()
    }

    fn force_of(radius: f64, work: f64, a: f64) -> f64 {
        4.0 * MODULUS * a * a * a / (3.0 * radius) - (8.0 * PI * work * MODULUS * a * a * a).sqrt()
    }

    #[test]
    fn radius_and_force_are_those_of_the_paper() {
        for (radius, work, curve) in curves() {
            let least = curve.least_root() * curve.least_root();
            assert_relative_eq!(
                least,
                libm::cbrt(PI * work * radius * radius / (8.0 * MODULUS)),
                max_relative = 1e-15
            );
            for k in 1..400 {
                let a = least * (1.0 + 1e-3 * f64::from(k) * f64::from(k));
                let overlap = overlap_of(radius, work, a);
                let root = curve.root(overlap);
                assert_relative_eq!(root * root, a, max_relative = 1e-13);
                let scale = PI * work * radius;
                // beside the tear-off a rounded overlap moves the force by some 1e-12
                assert_relative_eq!(
                    curve.force(root),
                    force_of(radius, work, a),
                    max_relative = 3e-12,
                    epsilon = 1e-13 * scale
                );
                // the root meets the equation that it solves to rounding
                let size = (root * root * root * root).max(3.0 * least * least) / radius;
                assert!((curve.overlap(root) - overlap).abs() <= 16.0 * f64::EPSILON * size);
            }
        }
    }

    #[test]
    fn closed_forms_of_first_touch_pull_off_and_tear_off() {
        for (radius, work, curve) in curves() {
            let unit = PI * work * radius;
            let touch = curve.root(0.0);
            assert_relative_eq!(curve.force(touch), -4.0 / 3.0 * unit, max_relative = 1e-14);
            assert_relative_eq!(
                touch * touch,
                libm::cbrt(2.0 * PI * work * radius * radius / MODULUS),
                max_relative = 1e-14
            );
            let pull_off = libm::cbrt(3.0) * curve.least_root();
            assert_relative_eq!(curve.force(pull_off), -1.5 * unit, max_relative = 1e-14);
            assert!(curve.stiffness(pull_off).abs() < 1e-14 * MODULUS * touch * touch);
            assert_relative_eq!(curve.force(curve.least_root()), -5.0 / 6.0 * unit, max_relative = 1e-14);
            // (3/4) (pi^2 w^2 R/E^2)^(1/3), e.g. Johnson (1985), section 5.5
            let distance = 0.75 * libm::cbrt(PI * PI * work * work * radius / (MODULUS * MODULUS));
            assert_relative_eq!(curve.tear_off_distance(), distance, max_relative = 1e-14);
            assert_relative_eq!(curve.root(-distance), curve.least_root(), max_relative = 1e-7);
            // no force at a^3 = 9 pi w R^2/(2 E)
            let rest = libm::cbrt(6.0) * curve.least_root();
            let equilibrium = libm::pow(rest, 6.0);
            assert_relative_eq!(
                equilibrium,
                4.5 * PI * work * radius * radius / MODULUS,
                max_relative = 1e-13
            );
            assert!(curve.force(rest).abs() < 1e-14 * unit);
            assert_relative_eq!(curve.stiffness(rest), 1.2 * MODULUS * rest * rest, max_relative = 1e-14);
        }
    }

    #[test]
    fn work_to_separate_from_first_touch() {
        for (radius, work, curve) in curves() {
            let unit = libm::cbrt(libm::pow(work, 5.0) * libm::pow(radius, 4.0) / (MODULUS * MODULUS));
            let separation = -curve.energy(curve.root(0.0));
            assert_relative_eq!(separation, 7.092195972 * unit, max_relative = 1e-9);
            assert!(curve.energy(curve.least_root()).abs() < 1e-15 * separation);
        }
    }

    #[test]
    fn without_adhesion_it_is_hertz() {
        let radius: f64 = 2e-3;
        let hertz = JkrCurve::new(MODULUS, radius, 0.0, 0.0);
        for overlap in [1e-12, 1e-7, 1e-4] {
            let root = hertz.root(overlap);
            let k = 4.0 / 3.0 * MODULUS * radius.sqrt();
            assert_relative_eq!(root * root, (radius * overlap).sqrt(), max_relative = 1e-14);
            assert_relative_eq!(hertz.force(root), k * overlap * overlap.sqrt(), max_relative = 1e-13);
            assert_relative_eq!(
                hertz.energy(root),
                0.4 * k * overlap * overlap * overlap.sqrt(),
                max_relative = 1e-13
            );
            assert_relative_eq!(hertz.stiffness(root), 1.5 * k * overlap.sqrt(), max_relative = 1e-13);
        }
        assert_eq!(
            (hertz.root(0.0), hertz.root(-1.0), hertz.tear_off_distance()),
            (0.0, 0.0, 0.0)
        );
        assert_eq!(
            (hertz.force(0.0), hertz.energy(0.0), hertz.stiffness(0.0)),
            (0.0, 0.0, 0.0)
        );
        // and almost none is almost Hertz
        let faint = JkrCurve::new(MODULUS, radius, adhesion_length_root(1e-30, MODULUS), 0.0);
        assert_relative_eq!(
            faint.force(faint.root(1e-7)),
            hertz.force(hertz.root(1e-7)),
            max_relative = 1e-12
        );
    }

    #[test]
    fn an_origin_shifts_the_curve() {
        let adhesion = adhesion_length_root(0.1, MODULUS);
        let (curve, shifted) = (
            JkrCurve::new(MODULUS, 1e-3, adhesion, 0.0),
            JkrCurve::new(MODULUS, 1e-3, adhesion, 3e-6),
        );
        assert_relative_eq!(shifted.root(4e-6), curve.root(1e-6), max_relative = 1e-13);
        assert_relative_eq!(shifted.overlap(curve.root(1e-6)), 4e-6, max_relative = 1e-13);
        assert_relative_eq!(shifted.tear_off(), 3e-6 - curve.tear_off_distance());
    }
}
