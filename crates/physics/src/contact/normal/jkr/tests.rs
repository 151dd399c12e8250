use super::super::walk::{rough_path, walk};
use super::*;
use crate::collision::{HeadOn, Outcome, Start, Sticking, Tolerance, restitution_of, sticking_speed};
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
const DENSITY: f64 = 2500.0;

fn law(more: &[(&str, f64)]) -> Jkr {
    let mut given = vec![("work_of_adhesion", WORK)];
    given.extend(more);
    Jkr::new(&values(&given), &PAIR).unwrap()
}

/// A sphere on a plane.
fn size(radius: f64) -> PairSize {
    PairSize::new(radius, DENSITY * 4.0 / 3.0 * PI * radius * radius * radius)
}

/// `7.09 (w^5 R^4/E^2)^(1/3)`.
fn separation(radius: f64) -> f64 {
    let modulus = PAIR.effective_modulus();
    7.092195972 * libm::cbrt(libm::pow(WORK, 5.0) * libm::pow(radius, 4.0) / (modulus * modulus))
}

/// `(3/4) (pi^2 w^2 R/E^2)^(1/3)`.
fn tear_off(radius: f64) -> f64 {
    let ratio = PI * WORK / PAIR.effective_modulus();
    0.75 * libm::cbrt(ratio * ratio * radius)
}

#[test]
fn pulled_apart_it_holds_to_the_tear_off() {
    for radius in [1e-6, 1e-3] {
        let (law, size, end) = (law(&[]), size(radius), tear_off(radius));
        let unit = PI * WORK * radius;
        let mut history = [0.0; 2];
        let mut at = |overlap: f64| {
            law.respond(&NormalInput::at(size, overlap, -1.0), &mut history[..1])
                .elastic
        };
        // nothing before the surfaces touch
        assert_eq!(at(-0.5 * end), 0.0);
        assert_relative_eq!(at(0.0), -4.0 / 3.0 * unit, max_relative = 1e-13);
        assert!(at(3.0 * end) > 0.0);
        let mut least = 0.0f64;
        for k in 0..=10_000 {
            let share = f64::from(k) / 10_000.0;
            let force = at(3.0 * end - 4.0 * (1.0 - 1e-12) * end * share);
            least = least.min(force);
        }
        assert_relative_eq!(least, -1.5 * unit, max_relative = 1e-6);
        // the force ends with a jump of 5/9 of the pull-off force, by the square root of the distance
        assert_relative_eq!(at(-(1.0 - 1e-12) * end), -5.0 / 6.0 * unit, max_relative = 1e-5);
        assert_eq!(at(-(1.0 + 1e-12) * end), 0.0);
        // and the surfaces are apart until they touch again
        assert_eq!(at(-1e-6 * end), 0.0);
        assert!(at(0.0) < 0.0);
    }
}

#[test]
fn reach_is_the_tear_off_distance_while_the_surfaces_hold() {
    let (law, size) = (law(&[]), size(2e-6));
    assert_relative_eq!(law.largest_reach(size), tear_off(2e-6), max_relative = 1e-13);
    assert_eq!(law.reach(size, &[0.0]), 0.0);
    assert_eq!(law.reach(size, &[1.0]), law.largest_reach(size));
    assert_eq!(law.history(), 1);
}

#[test]
fn books_close_on_rough_paths() {
    for (radius, seed) in [(1e-7, 1), (1e-6, 2), (1e-4, 3), (1e-2, 4)] {
        let (law, size, end) = (law(&[]), size(radius), tear_off(radius));
        let mut history = [0.0; 2];
        let turns = rough_path(-3.0 * end, (-2.0 * end, 4.0 * end), 40, seed);
        let books = walk(&law, size, &turns, 0.02 * end, &mut history[..1]);
        assert_eq!(history[0], 0.0);
        // every touch loses what it takes to part again
        let touches = (books.lost / separation(radius)).round();
        assert!(touches >= 5.0, "{touches}");
        assert_relative_eq!(books.lost, touches * separation(radius), max_relative = 1e-4);
        assert!(books.least_lost > -1e-5 * separation(radius), "{books:?}");
        assert_relative_eq!(books.work, books.lost, max_relative = 1e-4);
    }
}

#[test]
fn a_touch_takes_the_whole_binding_energy_from_the_store() {
    let (law, size) = (law(&[]), size(1e-6));
    let mut history = [0.0; 2];
    let response = law.respond(&NormalInput::at(size, 0.0, 1.0), &mut history[..1]);
    assert_relative_eq!(response.lost, separation(1e-6), max_relative = 1e-9);
    assert_relative_eq!(
        law.energy(size, 0.0, &history[..1]),
        -separation(1e-6),
        max_relative = 1e-9
    );
    assert_eq!(law.energy(size, -2.0 * tear_off(1e-6), &[0.0]), 0.0);
    assert_relative_eq!(response.adhesion, 2.0 * 1.5 * PI * WORK * 1e-6, max_relative = 1e-14);
}

#[test]
fn sticking_speed_of_thornton_and_ning() {
    // v_s = 1.84 ((w/R)^5/(rho^3 E^2))^(1/6) for a sphere on a plane, the third digit being 1.8402
    for radius in [1e-7, 1e-6, 5e-5] {
        let size = size(radius);
        let Sticking::Below(found) = sticking_speed(&law(&[]), size, Start::Contact, &Tolerance::default()).unwrap()
        else {
            panic!("no sticking speed");
        };
        assert_relative_eq!(
            found,
            (2.0 * separation(radius) / size.mass).sqrt(),
            max_relative = 1e-6
        );
        let modulus = PAIR.effective_modulus();
        let paper = libm::pow(
            libm::pow(WORK / radius, 5.0) / (DENSITY * DENSITY * DENSITY * modulus * modulus),
            1.0 / 6.0,
        );
        assert_relative_eq!(found, 1.84 * paper, max_relative = 2e-4);
    }
}

#[test]
fn above_the_sticking_speed_the_tear_off_alone_is_lost() {
    let size = size(1e-6);
    let limit = (2.0 * separation(1e-6) / size.mass).sqrt();
    for ratio in [1.01, 1.5, 10.0] {
        let impact = HeadOn {
            law: &law(&[]),
            size,
            speed: ratio * limit,
            start: Start::Contact,
        };
        let found = impact.run(&Tolerance::default()).unwrap();
        assert_eq!(found.outcome, Outcome::Rebound);
        assert_relative_eq!(
            found.restitution,
            (1.0 - 1.0 / (ratio * ratio)).sqrt(),
            max_relative = 1e-7
        );
        assert_relative_eq!(found.energy.lost, separation(1e-6), max_relative = 1e-7);
    }
}

#[test]
fn without_adhesion_it_is_hertz_and_tsuji() {
    let given = values(&[("work_of_adhesion", 0.0), ("alpha", hertz_damping(0.6))]);
    let jkr = Jkr::new(&given, &PAIR).unwrap();
    let hertz = HertzTsuji::new(&values(&[("restitution", 0.6)]), &PAIR).unwrap();
    let size = size(1e-3);
    for overlap in [1e-9, 1e-6, 1e-4] {
        let (a, b) = (
            jkr.respond(&NormalInput::at(size, overlap, 0.3), &mut [0.0; 2]),
            hertz.respond(&NormalInput::at(size, overlap, 0.3), &mut []),
        );
        assert_relative_eq!(a.elastic, b.elastic, max_relative = 1e-13);
        assert_relative_eq!(a.damping, b.damping, max_relative = 1e-13);
        assert_relative_eq!(
            jkr.collision_time(size, overlap),
            hertz.collision_time(size, overlap),
            max_relative = 1e-12
        );
        assert_relative_eq!(
            jkr.stiffness(size, overlap, &[1.0]),
            hertz.stiffness(size, overlap, &[]),
            max_relative = 1e-13
        );
    }
    assert_relative_eq!(restitution_of(&jkr, size, 0.7).unwrap(), 0.6, max_relative = 1e-9);
}

#[test]
fn a_requested_restitution_is_met_for_every_size() {
    let law = law(&[("restitution", 0.5), ("impact_speed", 2.0)]);
    assert_eq!(law.history(), 2);
    for radius in [1e-6, 1e-4, 1e-2] {
        let size = size(radius);
        law.check(size).unwrap();
        assert_relative_eq!(restitution_of(&law, size, 2.0).unwrap(), 0.5, max_relative = 1e-7);
    }
    // a fine powder loses more than that to adhesion alone
    let told = law.check(size(2.9e-8)).unwrap_err();
    let limit2 = 2.0 * separation(2.9e-8) / size(2.9e-8).mass;
    let largest = (1.0 - limit2 / 4.0).max(0.0).sqrt();
    assert!(largest > 0.0 && largest < 0.5);
    assert!(
        told.contains(&format!("the law gives {largest:.6}")),
        "{told}, {largest}"
    );
}

#[test]
fn restitution_needs_its_speed_and_excludes_alpha() {
    let refused = |more: &[(&str, f64)]| {
        let mut given = values(more);
        given.insert("work_of_adhesion".to_string(), 0.1.into());
        Jkr::new(&given, &PAIR).unwrap_err()[0].to_string()
    };
    assert!(refused(&[("restitution", 0.5)]).contains("impact_speed"));
    assert!(refused(&[("restitution", 0.5), ("impact_speed", 1.0), ("alpha", 0.1)]).contains("alpha"));
}

#[test]
fn bodies_that_stick_anyway_are_not_to_be_asked_for_less() {
    let law = law(&[("restitution", 1e-3), ("impact_speed", 1e-5)]);
    let told = law.check(size(1e-4)).unwrap_err();
    assert!(
        told.contains("they stick even without a dashpot; ask for a higher speed"),
        "{told}"
    );
}
