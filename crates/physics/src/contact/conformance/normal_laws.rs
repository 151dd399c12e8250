//! Normal laws without memory, one by one: no engine, no motion.

use super::cases::{NormalCase, OTHER_UNITS, Random, plain_cases, scaled_values};
use crate::contact::normal::{NormalLaw, NormalResponse};
use crate::dimension::Dimension;

/// Overlaps as shares of the radius, from rounding noise to the end of any law's range.
const OVERLAP_SHARES: [f64; 6] = [1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1];

fn each_overlap(check: impl Fn(&NormalCase, f64)) {
    for case in plain_cases(&[]) {
        for share in OVERLAP_SHARES {
            check(&case, share * case.size.radius);
        }
    }
}

/// Derivative at `x` through five points; the error is `step^4 f'''''/30`, below 1e-11 of the value here.
fn derivative(x: f64, f: impl Fn(f64) -> f64) -> f64 {
    let h = 1e-3 * x;
    (8.0 * (f(x + h) - f(x - h)) - (f(x + 2.0 * h) - f(x - 2.0 * h))) / (12.0 * h)
}

/// Size of the terms that a force is the difference of: what repels, and what attracts.
fn terms(response: &NormalResponse) -> f64 {
    response.elastic.abs() + 2.0 * response.adhesion
}

#[track_caller]
fn assert_close(case: &NormalCase, what: &str, value: f64, expected: f64, tolerance: f64) {
    assert_within(case, what, (value, expected), tolerance, expected.abs());
}

/// The two values agree to a share of a scale.
#[track_caller]
fn assert_within(case: &NormalCase, what: &str, (value, expected): (f64, f64), tolerance: f64, scale: f64) {
    assert!(
        (value - expected).abs() <= tolerance * scale,
        "{}: {what} is {value:e}, expected {expected:e} within {tolerance:e}",
        case.name()
    );
}

#[test]
fn force_is_the_slope_of_the_stored_energy() {
    each_overlap(|case, d| {
        let response = case.respond(d, 0.0);
        let slope = derivative(d, |x| case.energy(x));
        assert_within(case, "elastic force", (response.elastic, slope), 1e-9, terms(&response));
    });
}

#[test]
fn stiffness_is_the_slope_of_the_force() {
    each_overlap(|case, d| {
        let slope = derivative(d, |x| case.respond(x, 0.0).elastic);
        // where two terms are all but equal, their rounding is left
        let scale = slope.abs().max(1e-2 * terms(&case.respond(d, 0.0)) / d);
        assert_within(case, "stiffness", (case.stiffness(d), slope), 1e-9, scale);
    });
}

#[test]
fn damping_is_never_negative() {
    each_overlap(|case, d| {
        for window in [0.0, 1e-3 * d, 0.2 * d, 0.3 * d, d, 10.0 * d] {
            for overlap in [d, 0.0, -0.5 * d] {
                let damping = case.respond(overlap, window).damping;
                assert!(damping >= 0.0, "{}: damping {damping:e}", case.name());
            }
        }
    });
}

#[test]
fn nothing_acts_across_a_gap() {
    let nothing = NormalResponse::NOTHING;
    each_overlap(|case, d| {
        for gap in [0.0, f64::MIN_POSITIVE, 1e-9 * d, d, 1e3 * d] {
            assert_eq!(case.respond(-gap, 0.0), nothing, "{}: gap {gap:e}", case.name());
            // a window that ends before the surfaces meet
            assert_eq!(case.respond(-gap, 0.99 * gap), nothing, "{}: gap {gap:e}", case.name());
            assert_eq!(case.energy(-gap), 0.0, "{}: energy across {gap:e}", case.name());
        }
    });
}

/// Points and weights of Gauss-Legendre quadrature with 8 points on `[-1, 1]` (Abramowitz and Stegun, table 25.4).
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_3),
];

/// Mean of the plain response over `[overlap - h, overlap + h]`. With `d = u^4` a law of quarter powers of the overlap
/// is a polynomial in `u`, so that the quadrature is exact.
fn integrated_mean(case: &NormalCase, overlap: f64, h: f64) -> NormalResponse {
    let root = |d: f64| d.max(0.0).sqrt().sqrt();
    let (lower, upper) = (root(overlap - h), root(overlap + h));
    let (middle, half) = (0.5 * (lower + upper), 0.5 * (upper - lower));
    let mut mean = NormalResponse::NOTHING;
    for (point, weight) in GAUSS {
        for u in [middle - half * point, middle + half * point] {
            let cube = u * u * u;
            let response = case.respond(cube * u, 0.0);
            let share = weight * half * 4.0 * cube / (2.0 * h);
            mean.elastic += share * response.elastic;
            mean.damping += share * response.damping;
        }
    }
    mean
}

/// Windows as shares of the overlap, from tiny to far beyond the end of the contact.
const WINDOW_SHARES: [f64; 12] = [1e-6, 1e-3, 0.01, 0.1, 0.2, 0.249, 0.251, 0.4, 0.8, 1.0, 3.0, 1e4];

#[test]
fn windowed_response_is_the_mean_over_the_window() {
    each_overlap(|case, d| {
        for share in WINDOW_SHARES {
            let response = case.respond(d, share * d);
            let mean = integrated_mean(case, d, share * d);
            // inside, the mean is taken through the second-order term of its expansion: what is left is of fourth order
            let truncated = if share > 0.25 { 0.0 } else { 0.02 * share.powi(4) };
            // the quadrature itself takes the difference of two ends that lie close together
            let tolerance = truncated + 1e-11 + 1e-15 / share;
            let forces = (response.elastic, mean.elastic);
            assert_within(case, "mean force", forces, tolerance, terms(&response));
            assert_close(case, "mean damping", response.damping, mean.damping, tolerance);
        }
    });
}

#[test]
fn windowed_response_across_the_end_is_the_mean_over_the_window() {
    each_overlap(|case, d| {
        for gap in [0.0, 0.01 * d, 0.5 * d, 0.999 * d] {
            let response = case.respond(-gap, d);
            let mean = integrated_mean(case, -gap, d);
            assert_close(case, "mean force", response.elastic, mean.elastic, 1e-10);
            assert_close(case, "mean damping", response.damping, mean.damping, 1e-10);
        }
    });
}

#[test]
fn response_steps_by_less_than_1e_4_as_the_window_grows() {
    // wherever a law changes from an expansion to the exact mean: no step of more than 1e-4 of the response
    const LARGEST_STEP: f64 = 1e-4;
    const FINE: f64 = 1e-5;
    for case in plain_cases(&[]).iter().step_by(3) {
        let d = 1e-3 * case.size.radius;
        let mut before = case.respond(d, 0.0);
        for i in 1..300_000 {
            let now = case.respond(d, FINE * f64::from(i) * d);
            let change = |a: f64, b: f64| (a - b).abs() / a.abs().max(f64::MIN_POSITIVE);
            for step in [change(before.elastic, now.elastic), change(before.damping, now.damping)] {
                assert!(
                    step < LARGEST_STEP + FINE,
                    "{}: step {step:e} at window {i} * 1e-5",
                    case.name()
                );
            }
            before = now;
        }
    }
}

#[test]
fn no_closed_cycle_of_overlap_gives_energy() {
    for (index, case) in plain_cases(&[]).iter().enumerate() {
        let mut random = Random(index as u64);
        for _ in 0..10 {
            let cycle = Cycle::new(case, &mut random);
            let (elastic, viscous, turnover) = cycle.work(case, 8000);
            // what the elastic part fails to return is an error of integration, second order in the step
            assert!(
                elastic.abs() <= 1e-6 * turnover,
                "{}: {:e} of the energy was not returned",
                case.name(),
                elastic / turnover
            );
            assert!(viscous >= 0.0, "{}: the dashpot gave {viscous:e} J", case.name());
        }
    }
}

/// A closed path of the overlap, through the end of the contact and back.
struct Cycle {
    mean: f64,
    amplitudes: [f64; 3],
    phases: [f64; 3],
    period: f64,
}

impl Cycle {
    fn new(case: &NormalCase, random: &mut Random) -> Self {
        let scale = 1e-3 * case.size.radius;
        Self {
            mean: scale * random.between(-0.3, 1.0),
            amplitudes: [1.0, 0.5, 0.3].map(|a| a * scale * random.between(0.5, 1.5)),
            phases: [0.0; 3].map(|_| random.between(0.0, std::f64::consts::TAU)),
            period: case.collision_time(scale),
        }
    }

    /// Work done on the contact by its elastic and by its viscous part over one period, and the magnitudes of the former.
    fn work(&self, case: &NormalCase, steps: u32) -> (f64, f64, f64) {
        let dt = self.period / f64::from(steps);
        let (mut elastic, mut viscous, mut turnover) = (0.0, 0.0, 0.0);
        for step in 0..steps {
            let (mut overlap, mut rate) = (self.mean, 0.0);
            for (k, (a, phase)) in self.amplitudes.iter().zip(self.phases).enumerate() {
                let frequency = (k + 1) as f64 * std::f64::consts::TAU / self.period;
                let angle = frequency * dt * f64::from(step) + phase;
                overlap += a * libm::sin(angle);
                rate += a * frequency * libm::cos(angle);
            }
            let response = case.respond(overlap, 0.5 * rate.abs() * dt);
            elastic += response.elastic * rate * dt;
            turnover += (response.elastic * rate * dt).abs();
            viscous += response.damping * rate * rate * dt;
        }
        (elastic, viscous, turnover)
    }
}

#[test]
fn response_scales_as_the_declared_dimensions() {
    let units = OTHER_UNITS;
    for case in plain_cases(&[]) {
        let values = scaled_values(case.info, &super::cases::values(case.info, &[]), units);
        let law = NormalLaw::build(case.info.name, &values, &units.pair(&case.pair)).unwrap();
        let other = NormalCase {
            law,
            size: units.size(case.size),
            ..case
        };
        for share in OVERLAP_SHARES {
            let d = share * case.size.radius;
            let d_other = d * units.length;
            for window in [0.0, 0.1, 0.7, 2.0] {
                let (a, b) = (case.respond(d, window * d), other.respond(d_other, window * d_other));
                let force = units.of(Dimension::FORCE) * a.elastic;
                assert_close(&case, "force in other units", b.elastic, force, 1e-12);
                let damping = units.of(Dimension::DAMPING) * a.damping;
                assert_close(&case, "damping in other units", b.damping, damping, 1e-12);
            }
            for (what, dimension, a, b) in [
                ("energy", Dimension::ENERGY, case.energy(d), other.energy(d_other)),
                (
                    "stiffness",
                    Dimension::STIFFNESS,
                    case.stiffness(d),
                    other.stiffness(d_other),
                ),
                (
                    "collision time",
                    Dimension::TIME,
                    case.collision_time(d),
                    other.collision_time(d_other),
                ),
            ] {
                assert_close(&case, what, b, units.of(dimension) * a, 1e-12);
            }
        }
    }
}

#[test]
fn swapping_the_materials_changes_nothing() {
    for case in plain_cases(&[]) {
        let swapped = crate::contact::MaterialPair {
            a: case.pair.b,
            b: case.pair.a,
        };
        let law = NormalLaw::build(case.info.name, &super::cases::values(case.info, &[]), &swapped).unwrap();
        assert_eq!(law, case.law, "{}", case.name());
    }
}
