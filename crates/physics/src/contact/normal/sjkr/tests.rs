use super::super::walk::{rough_path, walk};
use super::*;
use crate::collision::restitution_of;
use crate::contact::Elastic;
use crate::contact::normal::HertzTsuji;
use crate::parameters::{Value, values};
use approx::assert_relative_eq;
use std::f64::consts::PI;

const SOFT: Elastic = Elastic {
    young_modulus: 5e6,
    poisson_ratio: 0.3,
};
const PAIR: MaterialPair = MaterialPair { a: SOFT, b: SOFT };
const DENSITY: f64 = 1e5;
const SIZE: PairSize = PairSize::new(1e-3, 1e-5);

fn law(area: &str, more: &[(&str, f64)]) -> Sjkr {
    let mut given = values(more);
    given.insert("cohesion_energy_density".to_string(), DENSITY.into());
    given.insert("area".to_string(), Value::from(area));
    Sjkr::new(&given, &PAIR).unwrap()
}

/// Area of the circle in which two spheres, or a sphere and a plane (no second radius), cut each other.
fn circle(first: f64, second: Option<f64>, overlap: f64) -> f64 {
    let Some(second) = second else {
        return PI * (2.0 * first - overlap) * overlap;
    };
    let distance = first + second - overlap;
    let along = (distance * distance + first * first - second * second) / (2.0 * distance);
    PI * (first * first - along * along)
}

#[test]
fn the_lens_is_the_circle_of_intersection_to_leading_order() {
    for (first, second) in [(1e-3, None), (2e-3, Some(2e-3)), (1.1e-3, Some(1.1e-2))] {
        let radius = second.map_or(first, |second| first * second / (first + second));
        let size = PairSize { radius, ..SIZE };
        for overlap in [1e-7, 1e-6, 1e-5] {
            let response = law("lens", &[]).respond(&NormalInput::at(size, overlap, 1.0), &mut [0.0]);
            let exact = DENSITY * circle(first, second, overlap);
            let deviation = response.adhesion / exact - 1.0;
            // told in the documentation: at most d/(2 R), that of a wall
            let most = overlap / (2.0 * radius);
            assert!(deviation > -1e-9 && deviation < 1.01 * most, "{deviation} {most}");
        }
    }
}

#[test]
fn areas_and_the_largest_pull() {
    let k = 4.0 / 3.0 * PAIR.effective_modulus() * SIZE.radius.sqrt();
    for (area, factor) in [("lens", 2.0 * PI), ("hertz", PI), ("double-lens", 4.0 * PI)] {
        let law = law(area, &[]);
        let pull = DENSITY * factor * SIZE.radius;
        let force = |d: f64| law.respond(&NormalInput::at(SIZE, d, 1.0), &mut [0.0]).elastic;
        for d in [1e-8, 1e-6, 1e-4] {
            assert_relative_eq!(force(d), k * d * d.sqrt() - pull * d, max_relative = 1e-12);
        }
        // F = K d^(3/2) - p d is least, -4 p^3/(27 K^2), at (2 p/(3 K))^2, and zero at (p/K)^2
        let (least, rest) = (
            (2.0 * pull / (3.0 * k)) * (2.0 * pull / (3.0 * k)),
            pull * pull / (k * k),
        );
        assert_relative_eq!(
            force(least),
            -4.0 * pull * pull * pull / (27.0 * k * k),
            max_relative = 1e-12
        );
        assert!(law.stiffness(SIZE, least, &[]).abs() < 1e-12 * pull);
        assert!(force(1.01 * least) > force(least) && force(0.99 * least) > force(least));
        assert!(force(rest).abs() < 1e-12 * pull * rest);
        // the well is p d^2/10 deep there
        assert_relative_eq!(
            law.energy(SIZE, rest, &[]),
            -0.1 * pull * rest * rest,
            max_relative = 1e-12
        );
    }
}

#[test]
fn nothing_is_lost_on_any_path() {
    let law = law("lens", &[]);
    for seed in 0..5 {
        let turns = rough_path(-1e-5, (-1e-5, 1e-4), 30, seed);
        let books = walk(&law, SIZE, &turns, 2e-8, &mut [0.0]);
        assert_eq!(books.lost, 0.0);
        assert!(books.work.abs() < 1e-7 * books.turnover, "{books:?}");
    }
}

#[test]
fn without_cohesion_it_is_hertz_and_tsuji() {
    let given = values(&[
        ("cohesion_energy_density", 0.0),
        ("alpha", crate::restitution::hertz_damping(0.4)),
    ]);
    let law = Sjkr::new(&given, &PAIR).unwrap();
    let hertz = HertzTsuji::new(&values(&[("restitution", 0.4)]), &PAIR).unwrap();
    for (overlap, half_window) in [(1e-6, 0.0), (1e-6, 1e-7), (1e-6, 3e-6), (-1e-6, 3e-6)] {
        let input = NormalInput {
            size: SIZE,
            overlap,
            rate: 1.0,
            half_window,
        };
        let (a, b) = (law.respond(&input, &mut [0.0]), hertz.respond(&input, &mut []));
        assert_relative_eq!(a.elastic, b.elastic, max_relative = 1e-13);
        assert_relative_eq!(a.damping, b.damping, max_relative = 1e-13);
    }
}

#[test]
fn a_requested_restitution_is_met() {
    let law = law("lens", &[("restitution", 0.6), ("impact_speed", 0.8)]);
    law.check(SIZE).unwrap();
    assert_relative_eq!(restitution_of(&law, SIZE, 0.8).unwrap(), 0.6, max_relative = 1e-7);
}
