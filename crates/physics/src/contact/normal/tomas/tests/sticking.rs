//! Which collisions stick.

use super::*;
use crate::collision::{Collision, HeadOn, Outcome, Start, Sticking, Tolerance, sticking_speed};
use approx::assert_relative_eq;

fn sticking(law: &Tomas, radius: f64, start: Start) -> Sticking {
    sticking_speed(law, size(radius), start, &Tolerance::default()).unwrap()
}

#[track_caller]
fn critical(law: &Tomas, radius: f64, start: Start) -> f64 {
    match sticking(law, radius, start) {
        Sticking::Below(speed) => speed,
        other => panic!("{other:?}"),
    }
}

fn impact(law: &Tomas, speed: f64, start: Start) -> Collision {
    let size = small();
    let impact = HeadOn {
        law,
        size,
        speed,
        start,
    };
    impact.run(&Tolerance::default()).unwrap()
}

/// The contact criterion: no tail, the speed told at first touch.
fn touching(loading: &str, alpha: f64) -> Tomas {
    limestone(&[
        ("tail", "none".into()),
        ("loading", loading.into()),
        ("alpha", alpha.into()),
    ])
}

/// The escape criterion: a tail that does not end before it makes no difference.
fn escaping(loading: &str, alpha: f64) -> Tomas {
    limestone(&[
        ("range", 1e7.into()),
        ("loading", loading.into()),
        ("alpha", alpha.into()),
    ])
}

#[test]
fn critical_speeds_by_the_contact_criterion() {
    // radius [um], loading, alpha, speed [m/s] to six digits
    for (radius, loading, alpha, expected) in [
        (0.1, "elastic", 0.2, 0.0124316),
        (0.1, "elastic", 0.5, 0.0275025),
        (0.1, "elastic-plastic", 0.2, 0.0401245),
        (0.1, "elastic-plastic", 0.5, 0.106624),
        (1.0, "elastic", 0.2, 0.00182471),
        (1.0, "elastic", 0.5, 0.00403681),
        (1.0, "elastic-plastic", 0.2, 0.00220273),
        (1.0, "elastic-plastic", 0.5, 0.00576127),
    ] {
        let found = critical(&touching(loading, alpha), 1e-6 * radius, Start::Contact);
        assert_relative_eq!(found, expected, max_relative = 5e-6);
    }
}

#[test]
fn critical_speeds_by_the_escape_criterion() {
    for (loading, alpha, expected) in [
        ("elastic", 0.2, 0.0251078),
        ("elastic", 0.5, 0.0523388),
        ("elastic-plastic", 0.2, 0.217490),
        ("elastic-plastic", 0.5, 1.095307),
    ] {
        let found = critical(&escaping(loading, alpha), 0.3e-6, Start::Far);
        assert_relative_eq!(found, expected, max_relative = 5e-6);
    }
}

#[test]
fn the_end_of_the_tail_takes_a_hundredth_of_its_energy() {
    let (law, far) = (limestone(&[]), escaping("elastic-plastic", 0.2));
    let (ended, whole) = (critical(&law, 0.3e-6, Start::Far), critical(&far, 0.3e-6, Start::Far));
    assert!(ended < whole && ended > 0.985 * whole, "{ended} {whole}");
}

#[test]
fn elastic_sticking_scales_as_the_power_minus_five_sixths() {
    for (alpha, factor) in [(0.2, 1.36168109), (0.5, 3.01244962)] {
        let law = touching("elastic", alpha);
        let mut speeds = vec![];
        for radius in [0.1e-6, 0.2e-6, 1e-6] {
            let scale = law.scale(size(radius));
            let h0 = libm::pow(scale.pull / scale.hertz, 2.0 / 3.0);
            let unit = (scale.pull * h0 / size(radius).mass).sqrt();
            speeds.push(critical(&law, radius, Start::Contact));
            assert_relative_eq!(speeds[speeds.len() - 1], factor * unit, max_relative = 2e-7);
        }
        assert_relative_eq!(speeds[0] / speeds[2], libm::pow(10.0, 5.0 / 6.0), max_relative = 2e-7);
    }
}

#[test]
fn undamped_sticking_by_the_balance_of_energies() {
    let law = touching("elastic-plastic", 0.0);
    assert_relative_eq!(
        critical(&law, 0.3e-6, Start::Contact),
        5.58799563e-3,
        max_relative = 2e-7
    );
    // with neither damping nor yielding nothing sticks
    let found = impact(&touching("elastic", 0.0), 1e-4, Start::Contact);
    assert_relative_eq!(found.restitution, 1.0, max_relative = 1e-7);
}

#[test]
fn slow_impacts_stick_and_fast_ones_part() {
    for alpha in [0.2, 0.3, 0.4, 0.5] {
        let law = touching("elastic-plastic", alpha);
        // 2 mm/min and 2 m/min
        let (slow, fast) = (
            impact(&law, 2e-3 / 60.0, Start::Contact),
            impact(&law, 2.0 / 60.0, Start::Contact),
        );
        assert_eq!((slow.outcome, fast.outcome), (Outcome::Stick, Outcome::Rebound));
        assert!(fast.energy.lost > 0.0 && fast.energy.viscous > 0.0);
    }
}

#[test]
fn restitution_of_the_damping_alone() {
    for (alpha, expected) in [(0.2, 0.7541807), (0.3, 0.6535513), (0.4, 0.5648480), (0.5, 0.4863967)] {
        let law = limestone(&[
            ("adhesion_force", 0.0.into()),
            ("loading", "elastic".into()),
            ("tail", "none".into()),
            ("alpha", alpha.into()),
        ]);
        let found = impact(&law, 0.05, Start::Contact).restitution;
        assert_relative_eq!(found, expected, max_relative = 1e-7);
    }
}

#[test]
fn without_losses_the_speed_comes_back_from_the_attraction() {
    for tail in ["full", "cut"] {
        let law = limestone(&[
            ("alpha", 0.0.into()),
            ("loading", "elastic".into()),
            ("tail", tail.into()),
        ]);
        for speed in [1e-3, 0.1] {
            let found = impact(&law, speed, Start::Far);
            assert_relative_eq!(found.restitution, 1.0, max_relative = 1e-7);
        }
    }
}

#[test]
fn a_requested_restitution_is_realised() {
    let mut values = values(&[("restitution", 0.2.into()), ("impact_speed", 2.0.into())]);
    values.remove("alpha");
    let pair = MaterialPair {
        a: LIMESTONE,
        b: LIMESTONE,
    };
    let law = Tomas::new(&values, &pair).unwrap();
    assert_eq!(law.history(), 3);
    assert_eq!(law.check(small()), Ok(()));
    assert_relative_eq!(impact(&law, 2.0, Start::Far).restitution, 0.2, max_relative = 1e-7);
    // below the speed at which they stick
    values.insert("impact_speed".to_string(), 0.01.into());
    let refused = Tomas::new(&values, &pair).unwrap().check(small()).unwrap_err();
    assert!(refused.contains("stick"), "{refused}");
}

#[test]
fn damping_by_the_total_overlap_makes_escape_impossible() {
    let total = |tail: &str, alpha: f64| {
        limestone(&[
            ("tail", tail.into()),
            ("damping_overlap", "total".into()),
            ("alpha", alpha.into()),
        ])
    };
    let found = |alpha: f64| sticking(&total("full", alpha), 0.3e-6, Start::Far);
    assert!(matches!(found(0.2), Sticking::Below(_)));
    for alpha in [0.4, 0.5] {
        assert!(
            matches!(found(alpha), Sticking::Always(_)),
            "{alpha}: {:?}",
            found(alpha)
        );
    }
    // without a tail they part in a window of speeds only
    let outcome = |speed: f64| impact(&total("none", 0.5), speed, Start::Contact).outcome;
    assert_eq!(
        [0.05, 0.1, 0.4].map(outcome),
        [Outcome::Stick, Outcome::Rebound, Outcome::Stick]
    );
}

#[test]
fn grains_that_adhesion_alone_does_not_dent_part_at_every_speed_without_damping() {
    let law = touching("elastic-plastic", 0.0);
    assert!(matches!(sticking(&law, 0.3e-6, Start::Contact), Sticking::Below(_)));
    let large = sticking(&law, 1e-6, Start::Contact);
    let Sticking::Never(slowest) = large else {
        panic!("{large:?}");
    };
    // attraction makes them much faster than that; slower ones are not asked, as rounding would answer
    let impact = HeadOn {
        law: &law,
        size: size(1e-6),
        speed: slowest,
        start: Start::Contact,
    };
    let collision = impact.run(&Tolerance::default()).unwrap();
    let share = slowest / collision.max_speed;
    assert!((1e-7..4e-7).contains(&share), "{share}");
}
