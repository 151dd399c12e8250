//! Collisions against the closed forms of Antypov and Elliott (2011).

use super::*;
use crate::contact::normal::{HertzTsuji, Linear, Normal, NormalLaw, ThorntonNing};
use crate::contact::{Elastic, MaterialPair, PairSize};
use crate::parameters::values;
use approx::assert_relative_eq;
use std::f64::consts::PI;

const MCC: Elastic = Elastic {
    young_modulus: 6e9,
    poisson_ratio: 0.3,
};
const PAIR: MaterialPair = MaterialPair { a: MCC, b: MCC };

/// A sphere of MCC on a wall, the reduced mass of two equal ones for half the radius.
fn size(radius: f64) -> PairSize {
    let mass = 1500.0 * 4.0 / 3.0 * PI * radius * radius * radius;
    PairSize::new(radius, mass)
}

fn run<L: Normal>(law: &L, size: PairSize, speed: f64) -> Collision {
    let start = Start::Contact;
    let impact = HeadOn {
        law,
        size,
        speed,
        start,
    };
    impact.run(&Tolerance::default()).unwrap()
}

fn hertz(restitution: f64) -> HertzTsuji {
    HertzTsuji::new(&values(&[("restitution", restitution)]), &PAIR).unwrap()
}

/// `tau/T` of the damped over the undamped Hertzian collision, from the closed form with the gamma function.
const DURATIONS: [(f64, f64, f64); 3] = [
    (0.1, 4.861402527, 0.63070503),
    (0.54, 3.477236761, 0.88088633),
    (0.9, 3.253683413, 1.04918396),
];

#[test]
fn hertzian_collisions_meet_the_closed_forms_at_every_scale() {
    for radius in [1e-7, 5e-3, 1.0] {
        for speed in [1e-6, 1e-2, 30.0] {
            let size = size(radius);
            let k = 4.0 / 3.0 * PAIR.effective_modulus() * radius.sqrt();
            let overlap_unit = libm::pow(size.mass * speed * speed / k, 0.4);
            for (e, duration, overlap) in DURATIONS {
                let found = run(&hertz(e), size, speed);
                assert_eq!(found.outcome, Outcome::Rebound);
                assert_relative_eq!(found.restitution, e, max_relative = 1e-10);
                assert_relative_eq!(found.duration, duration * overlap_unit / speed, max_relative = 5e-10);
                assert_relative_eq!(found.max_overlap, overlap * overlap_unit, max_relative = 1e-8);
                let energy = found.energy;
                assert!(energy.lost.abs() < 1e-11 * energy.kinetic_before, "{energy:?}");
                assert!(found.steps < 500, "{}", found.steps);
            }
        }
    }
}

#[test]
fn undamped_hertzian_collision() {
    let size = size(1e-3);
    let k = 4.0 / 3.0 * PAIR.effective_modulus() * size.radius.sqrt();
    let found = run(&hertz(1.0), size, 2.0);
    let unit = libm::pow(size.mass * 4.0 / k, 0.4);
    assert_relative_eq!(found.restitution, 1.0, max_relative = 1e-12);
    assert_relative_eq!(found.duration, 3.2180654597190435 * unit / 2.0, max_relative = 1e-11);
    let overlap = libm::pow(1.25, 0.4) * unit;
    assert_relative_eq!(found.max_overlap, overlap, max_relative = 1e-12);
    assert_relative_eq!(found.max_force, k * overlap * overlap.sqrt(), max_relative = 1e-11);
}

#[test]
fn linear_collisions_meet_the_closed_forms() {
    for restitution in [0.05, 0.3, 0.54, 0.9, 1.0] {
        for (stiffness, radius, speed) in [(1e4, 1e-3, 0.3), (1e-2, 1e-7, 1e-4), (1e9, 1.0, 3.0)] {
            let given = values(&[("stiffness", stiffness), ("restitution", restitution)]);
            let law = Linear::new(&given, &PAIR).unwrap();
            let size = size(radius);
            let found = run(&law, size, speed);
            let l = -libm::log(restitution);
            let g = l / (l * l + PI * PI).sqrt();
            let w = (1.0 - g * g).sqrt();
            let unit = (size.mass / stiffness).sqrt();
            assert_relative_eq!(found.restitution, restitution, max_relative = 1e-11);
            assert_relative_eq!(found.duration, unit * PI / w, max_relative = 1e-11);
            let overlap = speed * unit * libm::exp(-(g / w) * libm::atan2(w, g));
            assert_relative_eq!(found.max_overlap, overlap, max_relative = 1e-11);
            // F = exp(-g t) (a cos(w t) + b sin(w t)) with units k v0 sqrt(m/k): at t = 0 it is 2 g, its maximum where
            // the derivative vanishes, tan(w t) = w (1 - 4 g^2)/(g (3 - 4 g^2)), while that is ahead
            let rise = 1.0 - 4.0 * g * g;
            let peak = if rise > 0.0 {
                let phase = libm::atan2(w * rise, g * (3.0 - 4.0 * g * g));
                let b = (1.0 - 2.0 * g * g) / w;
                libm::exp(-g / w * phase) * (2.0 * g * libm::cos(phase) + b * libm::sin(phase))
            } else {
                2.0 * g
            };
            assert_relative_eq!(
                found.max_force,
                peak * speed * (size.mass * stiffness).sqrt(),
                max_relative = 1e-10
            );
            assert!(found.energy.lost.abs() < 1e-11 * found.energy.kinetic_before);
        }
    }
}

#[test]
fn the_law_by_name_gives_the_same_and_moments_follow_the_course() {
    let name = NormalLaw::build("hertz-tsuji", &values(&[("restitution", 0.54)]), &PAIR).unwrap();
    let size = size(2.5e-3);
    let impact = HeadOn {
        law: &name,
        size,
        speed: 1.0,
        start: Start::Far,
    };
    let (found, moments) = impact.run_recorded(&Tolerance::default(), 101).unwrap();
    let direct = run(&hertz(0.54), size, 1.0);
    assert_eq!(
        (found.restitution, found.duration),
        (direct.restitution, direct.duration)
    );
    assert_eq!(moments.len(), 101);
    assert_eq!((moments[0].time, moments[0].rate), (0.0, 1.0));
    let last = moments[100];
    assert_relative_eq!(last.rate, -0.54, max_relative = 1e-9);
    assert_relative_eq!(last.time, found.duration, max_relative = 1e-14);
    let deepest = moments.iter().map(|m| m.overlap).fold(0.0, f64::max);
    assert_relative_eq!(deepest, found.max_overlap, max_relative = 1e-3);
    // the change of the overlap is the integral of the rate (Simpson)
    let h = found.duration / 100.0;
    let area: f64 = (0..50)
        .map(|k| h / 3.0 * (moments[2 * k].rate + 4.0 * moments[2 * k + 1].rate + moments[2 * k + 2].rate))
        .sum();
    assert!(area.abs() < 1e-5 * found.max_overlap, "{area}");
}

#[test]
fn impossible_input_is_refused() {
    let law = hertz(0.5);
    for (speed, radius) in [(0.0, 1e-3), (f64::NAN, 1e-3), (-1.0, 1e-3), (1.0, 0.0)] {
        let found = restitution_of(&law, PairSize::new(radius, 1e-6), speed);
        assert!(matches!(found, Err(CollisionError::Input { .. })), "{found:?}");
    }
    let few = Tolerance {
        max_steps: 5,
        ..Tolerance::default()
    };
    let impact = HeadOn {
        law: &law,
        size: size(1e-3),
        speed: 1.0,
        start: Start::Contact,
    };
    assert!(matches!(impact.run(&few), Err(CollisionError::Steps { steps: 5, .. })));
}

#[test]
fn what_is_told_wrongly_is_refused_by_name() {
    let law = NormalLaw::build("hertz-tsuji", &values(&[("restitution", 0.2)]), &PAIR).unwrap();
    let impact = HeadOn {
        law: &law,
        size: size(1e-3),
        speed: 1.0,
        start: Start::Contact,
    };
    let usual = Tolerance::default();
    for relative in [0.0, -1.0, 1.0, f64::INFINITY, f64::NAN] {
        let told = impact.run(&Tolerance { relative, ..usual }).unwrap_err().to_string();
        let expected = format!("the relative tolerance of the collision is {relative}");
        assert!(told.starts_with(&expected), "{told}");
    }
    let too_many = Err(CollisionError::Moments { count: usize::MAX });
    assert_eq!(impact.run_recorded(&usual, usize::MAX), too_many);
    assert_eq!(
        impact.follow(&usual, 1e-3, usize::MAX).map(|_| ()),
        too_many.map(|_| ())
    );
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let sizes = [("radius", PairSize::new(bad, 1.0)), ("mass", PairSize::new(1.0, bad))];
        for (what, size) in sizes {
            let told = sticking_speed_of(&law, size, Start::Contact, &usual).unwrap_err();
            assert!(told.to_string().contains(&format!("effective {what}")), "{told}");
        }
    }
}

#[test]
fn laws_without_adhesion_never_stick() {
    let law = NormalLaw::build("hertz-tsuji", &values(&[("restitution", 0.2)]), &PAIR).unwrap();
    let found = sticking_speed_of(&law, size(1e-6), Start::Contact, &Tolerance::default()).unwrap();
    assert!(matches!(found, Sticking::Never(speed) if speed < 1e-11), "{found:?}");
}

#[test]
fn a_dent_that_grows_holds_what_is_fast_enough() {
    let (k1, k2, kc) = (1e3, 5e3, 1e3);
    let given = [
        ("loading_stiffness", k1),
        ("unloading_stiffness", k2),
        ("adhesion_stiffness", kc),
        ("plastic_depth", 0.05),
    ];
    let law = NormalLaw::build("luding", &values(&given), &PAIR).unwrap();
    let found = sticking_speed_of(&law, size(0.5e-3), Start::Contact, &Tolerance::default()).unwrap();
    let Sticking::From { parting, speed: edge } = found else {
        panic!("{found:?}")
    };
    // what asks for the speed below which they stick is not told the one above which they do
    assert!(found.below() == parting && parting < 1e-6 * edge, "{found:?}");
    let outcome = |speed: f64| {
        let impact = HeadOn {
            law: &law,
            size: size(0.5e-3),
            speed,
            start: Start::Contact,
        };
        impact.run(&Tolerance::default()).unwrap().outcome
    };
    let [below, above, far] = [0.999, 1.001, 1.5].map(|share| outcome(share * edge));
    assert!(below != Outcome::Stick && above == Outcome::Stick && far == Outcome::Stick);
    assert!(outcome(20.0 * edge) != Outcome::Stick);
}

#[test]
fn rounding_gives_no_energy() {
    // below the speed of first yield nothing is lost
    let law = ThorntonNing::new(&values(&[("yield_pressure", 1e8)]), &PAIR).unwrap();
    for speed in [1e-3, 2e-3, 5e-3, 1e-2] {
        assert!(run(&law, size(1e-3), speed).restitution <= 1.0);
    }
}
