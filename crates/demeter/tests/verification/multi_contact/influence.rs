//! How a force at one contact of a ball moves its surface at another: the published formulas in vectors, written for the
//! tests alone.

use demeter_physics::DVec3;
use std::f64::consts::PI;
use std::sync::OnceLock;

/// A model, with what the engine calls it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Model {
    Independent,
    PointOnSphere,
    SphereToSphere,
    /// With its prefactor.
    HalfSpace(f64),
}

/// All models, in the order of the tables.
pub const MODELS: [Model; 5] = [
    Model::Independent,
    Model::PointOnSphere,
    Model::SphereToSphere,
    Model::HalfSpace(1.0),
    Model::HalfSpace(1.125),
];

/// An elastic ball.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    pub centre: DVec3,
    pub radius: f64,
    pub young_modulus: f64,
    pub poisson_ratio: f64,
}

/// A contact as one of its balls sees it.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Unit vector into the ball.
    pub normal: DVec3,
    /// Distance of the contact point from the centre [m].
    pub lever: f64,
}

impl Model {
    pub fn name(self) -> &'static str {
        match self {
            Self::Independent => "independent",
            Self::PointOnSphere => "point-on-sphere",
            Self::SphereToSphere => "sphere-to-sphere",
            Self::HalfSpace(_) => "half-space",
        }
    }

    /// Whether displacements depend on where the surfaces are.
    pub fn feels_levers(self) -> bool {
        matches!(self, Self::HalfSpace(_))
    }

    /// Outward displacement at `to` per force at `from` [m/N].
    pub fn influence(self, ball: &Ball, from: Place, to: Place) -> f64 {
        let (e, nu) = (ball.young_modulus, ball.poisson_ratio);
        let on_sphere = |shape: f64| (1.0 + nu) / (4.0 * PI * e * ball.radius) * shape;
        let half_chord = 0.5 * (from.normal - to.normal).length();
        match self {
            Self::Independent => 0.0,
            Self::HalfSpace(gamma) => gamma * half_space(e, nu, from, to),
            Self::SphereToSphere => on_sphere(sphere_to_sphere(nu, half_chord)),
            Self::PointOnSphere => on_sphere(point_on_sphere(nu, half_chord)),
        }
    }
}

/// Eq 1 of Brodu et al. with the normals inwards.
fn half_space(e: f64, nu: f64, from: Place, to: Place) -> f64 {
    let (n_k, n_c) = (from.normal, to.normal);
    let way = from.lever * n_k - to.lever * n_c;
    let (d, u) = (way.length(), way.normalize());
    let last = (n_k + u).dot(n_c) / (1.0 + n_k.dot(u));
    let braces = n_k.dot(u) * n_c.dot(u) + (3.0 - 4.0 * nu) * n_k.dot(n_c) - (1.0 - 2.0 * nu) * last;
    -(1.0 + nu) / (2.0 * PI * e * d) * braces
}

fn sphere_to_sphere(nu: f64, s: f64) -> f64 {
    (-2.0 * (1.0 - nu) - 2.0 * (1.0 - 2.0 * nu) * s + (7.0 - 8.0 * nu) * s * s) / s
}

/// Exact displacement of a sphere under a point force, with the series of Legendre polynomials as an integral:
/// `sum over n of P_n/(n + z) = integral over r from 0 to 1 of r^(z - 1)/sqrt(1 - 2 r x + r^2)`, and the denominator of the
/// series has the roots `-a +- i b`.
fn point_on_sphere(nu: f64, s: f64) -> f64 {
    let cosine = 1.0 - 2.0 * s * s;
    let s0 = 1.0 / (2.0 * s) - 1.0 - cosine;
    let s1 = 1.0 - 2.0 * s - cosine - cosine * libm::log(s * (1.0 + s));
    let (a, b) = (0.5 + nu, 0.5 * (3.0 - 4.0 * nu * nu).sqrt());
    let first = 1.0 - 8.0 * nu + 8.0 * nu * nu;
    let second = (-2.0 - nu + 4.0 * nu * nu - first * a) / b;
    // with r = exp(-l)
    let integrand = |l: f64| {
        let r = libm::exp(-l);
        let distance = ((1.0 - r) * (1.0 - r) + 4.0 * r * s * s).sqrt();
        let weight = first * libm::cos(b * l) + second * libm::sin(b * l);
        libm::exp(-a * l) * weight * (1.0 / distance - 1.0 - r * cosine)
    };
    let (mut start, mut width, mut t) = (0.0, f64::min(2.0 * s, 1.0), 0.0);
    while start < 18.0 {
        t += gauss(start, start + width, integrand);
        start += width;
        width = f64::min(2.0 * width, 1.5);
    }
    let rest = (1.0 - 2.0 * nu) / (1.0 + nu);
    -(4.0 * (1.0 - nu) * s0 + s1 + t + rest + 1.5 * rest * cosine)
}

/// Points of the Gauss-Legendre rule.
const POINTS: usize = 24;

fn gauss(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    static RULE: OnceLock<[(f64, f64); POINTS]> = OnceLock::new();
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let rule = RULE.get_or_init(|| std::array::from_fn(node));
    rule.iter().map(|(x, w)| w * f(middle + half * x)).sum::<f64>() * half
}

/// Node and weight: a root of the Legendre polynomial, by Newton's method.
fn node(k: usize) -> (f64, f64) {
    let mut x = libm::cos(PI * (k as f64 + 0.75) / (POINTS as f64 + 0.5));
    let mut slope = 1.0;
    for _ in 0..50 {
        let (mut before, mut now) = (1.0, x);
        for n in 2..=POINTS {
            let n = n as f64;
            (before, now) = (now, ((2.0 * n - 1.0) * x * now - (n - 1.0) * before) / n);
        }
        slope = POINTS as f64 * (x * now - before) / (x * x - 1.0);
        x -= now / slope;
    }
    (x, 2.0 / ((1.0 - x * x) * slope * slope))
}

#[test]
fn influences_are_those_of_the_notes() {
    use approx::assert_relative_eq;
    let table = [
        (30.0, -3.087_246_170, -0.550_002_591_2),
        (90.0, 0.5f64.sqrt(), 0.867_939_903_7),
        (150.0, 1.862_501_298, -1.097_410_086),
        (180.0, 2.0, -1.478_487_790),
    ];
    for (angle, spheres, point) in table {
        let s = libm::sin(f64::to_radians(angle) / 2.0);
        assert_relative_eq!(sphere_to_sphere(0.5, s), spheres, max_relative = 1e-9);
        assert_relative_eq!(point_on_sphere(0.5, s), point, max_relative = 1e-9);
    }
    let s = 0.5f64.sqrt();
    assert_relative_eq!(sphere_to_sphere(0.3, s), 0.472_792_206_1, max_relative = 1e-9);
    assert_relative_eq!(point_on_sphere(0.3, s), 0.781_424_743_3, max_relative = 1e-9);
    let place = |p: DVec3| Place {
        normal: -p.normalize(),
        lever: p.length(),
    };
    let (p0, p1) = (DVec3::new(0.1, -0.2, -0.95), DVec3::new(0.85, 0.3, 0.25));
    for (nu, from, to, expected) in [
        (0.5, p0, p1, 0.135_027_072_165_4),
        (0.3, p0, p1, 0.111_753_066_5),
        (0.3, p1, p0, 0.110_747_598_7),
    ] {
        assert_relative_eq!(
            half_space(1.0, nu, place(from), place(to)),
            expected,
            max_relative = 1e-9
        );
    }
}
