use super::super::walk::{rough_path, walk};
use super::*;
use crate::collision::{Start, Sticking, Tolerance, restitution_of, sticking_speed};
use crate::contact::Elastic;
use crate::contact::normal::HertzTsuji;
use crate::parameters::values;
use crate::restitution::hertz_damping;
use approx::assert_relative_eq;
use std::f64::consts::PI;

const GLASS: Elastic = Elastic {
    young_modulus: 63e9,
    poisson_ratio: 0.22,
};
const PAIR: MaterialPair = MaterialPair { a: GLASS, b: GLASS };
const WORK: f64 = 0.05;
const SEPARATION: f64 = 0.2e-9;
const SIZE: PairSize = PairSize::new(1e-6, 1e-14);

fn with_tail(more: &[(&str, f64)]) -> Result<Dmt, Vec<ParameterError>> {
    let mut given = values(more);
    given.insert("work_of_adhesion".to_string(), WORK.into());
    given.entry("separation".to_string()).or_insert(SEPARATION.into());
    Dmt::new(&given, &PAIR)
}

fn without_tail(more: &[(&str, f64)]) -> Dmt {
    let mut given = values(more);
    given.insert("work_of_adhesion".to_string(), WORK.into());
    Dmt::new(&given, &PAIR).unwrap()
}

fn force(law: &Dmt, overlap: f64) -> f64 {
    law.respond(&NormalInput::at(SIZE, overlap, 1.0), &mut [0.0]).elastic
}

#[test]
fn pull_off_is_two_pi_w_r_at_first_and_last_touch() {
    let law = without_tail(&[]);
    let pull_off = 2.0 * PI * WORK * SIZE.radius;
    assert_relative_eq!(force(&law, 1e-30), -pull_off, max_relative = 1e-12);
    assert_eq!(force(&law, 0.0), 0.0);
    // Hertz less the pull
    let hertz = HertzTsuji::new(&values(&[("restitution", 1.0)]), &PAIR).unwrap();
    let plain = hertz.respond(&NormalInput::at(SIZE, 3e-9, 1.0), &mut []).elastic;
    assert_relative_eq!(force(&law, 3e-9), plain - pull_off, max_relative = 1e-12);
    let response = law.respond(&NormalInput::at(SIZE, 3e-9, 1.0), &mut [0.0]);
    assert_relative_eq!(response.adhesion, pull_off);
    assert_eq!((law.largest_reach(SIZE), law.history()), (0.0, 0));
}

#[test]
fn the_tail_is_that_of_van_der_waals() {
    let law = with_tail(&[("separation", SEPARATION), ("cutoff", 50.0 * SEPARATION)]).unwrap();
    // between a sphere and a plane or two spheres: A R/(6 D^2) with Hamaker's constant A = 12 pi w D_0^2
    let hamaker = 12.0 * PI * WORK * SEPARATION * SEPARATION;
    for gap in [1e-12, 1e-10, 3e-9, 9.9e-9] {
        let distance = SEPARATION + gap;
        let expected = -hamaker * SIZE.radius / (6.0 * distance * distance);
        assert_relative_eq!(force(&law, -gap), expected, max_relative = 1e-13);
        let slope = (force(&law, -gap + 1e-4 * distance) - force(&law, -gap - 1e-4 * distance)) / (2e-4 * distance);
        if gap > 1e-11 {
            assert_relative_eq!(law.stiffness(SIZE, -gap, &[]), slope, max_relative = 1e-6);
        }
    }
    assert_relative_eq!(force(&law, -1e-25), force(&law, 1e-25), max_relative = 1e-12);
    assert_eq!(force(&law, -10.1e-9), 0.0);
    assert_relative_eq!(law.largest_reach(SIZE), 1e-8, max_relative = 1e-14);
    // work of adhesion: from contact to far apart, per area 2 pi R D_0 (Derjaguin)
    let expected = -2.0 * PI * WORK * SIZE.radius * SEPARATION * 50.0 / 51.0;
    assert_relative_eq!(law.energy(SIZE, 0.0, &[]), expected, max_relative = 1e-13);
    assert_eq!(law.energy(SIZE, -1e-8, &[]), 0.0);
}

#[test]
fn means_over_windows_are_those_of_the_energy() {
    let law = with_tail(&[("separation", SEPARATION)]).unwrap();
    let cutoff = 100.0 * SEPARATION;
    for overlap in [
        -1.0001 * cutoff,
        -0.7 * cutoff,
        -SEPARATION,
        -1e-3 * SEPARATION,
        0.0,
        1e-10,
        1e-8,
    ] {
        for h in [1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-7] {
            let input = NormalInput {
                size: SIZE,
                overlap,
                rate: 1.0,
                half_window: h,
            };
            let mean = law.respond(&input, &mut [0.0]).elastic;
            let (upper, lower) = (law.energy(SIZE, overlap + h, &[]), law.energy(SIZE, overlap - h, &[]));
            let rounding = 4.0 * f64::EPSILON * upper.abs().max(lower.abs()) / (2.0 * h);
            let expected = (upper - lower) / (2.0 * h);
            assert!(
                (mean - expected).abs() <= rounding + 2e-4 * expected.abs(),
                "{overlap:e} {h:e}: {mean:e} instead of {expected:e}"
            );
        }
    }
}

#[test]
fn surfaces_that_just_touch_attract() {
    let law = with_tail(&[("cutoff", 5e-9)]).unwrap();
    let pull = 2.0 * PI * WORK * SIZE.radius;
    for overlap in [-1e-15, -0.0, 0.0, 1e-18] {
        let input = NormalInput {
            size: SIZE,
            overlap,
            rate: 0.0,
            half_window: 0.0,
        };
        let force = law.respond(&input, &mut [0.0]).elastic;
        assert_relative_eq!(force, -pull, max_relative = 1e-5);
    }
}

#[test]
fn nothing_is_lost_on_any_path() {
    for law in [without_tail(&[]), with_tail(&[("cutoff", 5e-9)]).unwrap()] {
        for seed in 0..5 {
            let turns = rough_path(-6e-9, (-6e-9, 1e-8), 30, seed);
            let books = walk(&law, SIZE, &turns, 2e-12, &mut [0.0]);
            assert_eq!(books.lost, 0.0);
            assert!(books.work.abs() < 1e-6 * books.turnover, "{books:?}");
        }
    }
}

#[test]
fn undamped_grains_never_stick_and_damped_ones_do() {
    let law = without_tail(&[]);
    for speed in [1e-3, 0.1, 3.0] {
        assert_relative_eq!(restitution_of(&law, SIZE, speed).unwrap(), 1.0, max_relative = 1e-9);
    }
    let damped = without_tail(&[("alpha", hertz_damping(0.5))]);
    let found = sticking_speed(&damped, SIZE, Start::Contact, &Tolerance::default()).unwrap();
    let Sticking::Below(speed) = found else {
        panic!("{found:?}");
    };
    // by dimensions: v = f(alpha) sqrt(F d/m), F the pull, d = (F/K)^(2/3)
    let k = 4.0 / 3.0 * PAIR.effective_modulus() * SIZE.radius.sqrt();
    let pull = 2.0 * PI * WORK * SIZE.radius;
    let unit = |pull: f64| (pull * libm::pow(pull / k, 2.0 / 3.0) / SIZE.mass).sqrt();
    let doubled = Dmt {
        work_of_adhesion: 2.0 * WORK,
        ..damped
    };
    let found = sticking_speed(&doubled, SIZE, Start::Contact, &Tolerance::default()).unwrap();
    let Sticking::Below(faster) = found else {
        panic!("{found:?}");
    };
    assert_relative_eq!(faster / speed, unit(2.0 * pull) / unit(pull), max_relative = 1e-6);
}

#[test]
fn without_adhesion_it_is_hertz_and_tsuji() {
    let given = values(&[("work_of_adhesion", 0.0), ("alpha", hertz_damping(0.4))]);
    let law = Dmt::new(&given, &PAIR).unwrap();
    let hertz = HertzTsuji::new(&values(&[("restitution", 0.4)]), &PAIR).unwrap();
    for (overlap, half_window) in [(1e-9, 0.0), (1e-9, 1e-10), (1e-9, 3e-9), (-1e-9, 3e-9)] {
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
    assert_relative_eq!(
        law.collision_time(SIZE, 1e-9),
        hertz.collision_time(SIZE, 1e-9),
        max_relative = 1e-13
    );
}

#[test]
fn a_requested_restitution_is_met() {
    for tail in [false, true] {
        let more = [("restitution", 0.6), ("impact_speed", 0.8)];
        let law = if tail {
            with_tail(&more).unwrap()
        } else {
            without_tail(&more)
        };
        law.check(SIZE).unwrap();
        assert_eq!(law.history(), 1);
        let impact = crate::collision::HeadOn {
            law: &law,
            size: SIZE,
            speed: 0.8,
            start: Start::Far,
        };
        let found = impact.run(&Tolerance::default()).unwrap();
        assert_relative_eq!(found.restitution, 0.6, max_relative = 1e-7);
    }
}

#[test]
fn a_cutoff_without_a_tail_is_refused() {
    let given = values(&[("work_of_adhesion", WORK), ("cutoff", 1e-9)]);
    let told = Dmt::new(&given, &PAIR).unwrap_err()[0].to_string();
    assert!(told.contains("cutoff") && told.contains("`separation`"), "{told}");
}
