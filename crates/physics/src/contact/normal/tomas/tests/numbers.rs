//! Forces and constants.

use super::*;
use approx::assert_relative_eq;
use proptest::prelude::*;

#[test]
fn constants_of_one_size() {
    let size = small();
    let scale = limestone(&[]).scale(size);
    for (value, expected) in [
        (scale.hertz, 59431701.118),
        (scale.line, 192.35971818),
        (scale.limit, 43.259730840),
        (scale.yields_at, 10.475914414e-12),
        (size.mass, 2.4790935948e-15),
        (scale.pull, 2.64e-9),
    ] {
        assert_relative_eq!(value, expected, max_relative = 1e-9);
    }
    assert_eq!(scale.yields_at, scale.level);
    let printed = limestone(&[("yield_overlap", "as-printed".into())]).scale(size);
    assert_eq!(printed.yields_at, 4.0 * scale.level);
}

#[test]
fn the_pull_is_that_of_the_size() {
    let twice = size(0.6e-6);
    assert_relative_eq!(limestone(&[]).scale(twice).pull, 5.28e-9, max_relative = 1e-15);
    let mut without_radius = values(&[]);
    without_radius.remove("adhesion_radius");
    let pair = MaterialPair {
        a: LIMESTONE,
        b: LIMESTONE,
    };
    let constant = Tomas::new(&without_radius, &pair).unwrap();
    assert_eq!(constant.scale(twice).pull, 2.64e-9);
}

#[test]
fn forces_after_yielding() {
    // h_U, F_U, h_A, F_A
    for (deepest, force, foot, pull) in [
        (0.05e-9, 6.9779859e-9, 18.663618e-12, -3.4473831e-9),
        (0.5e-9, 93.539859e-9, 348.12230e-12, -17.699677e-9),
    ] {
        let mut contact = Contact::new(limestone(&[]), small());
        let loading = contact.move_to(deepest, 1.0);
        assert_relative_eq!(loading.elastic, force, max_relative = 3e-8);
        assert_relative_eq!(-loading.adhesion, pull, max_relative = 3e-8);
        assert_eq!(contact.history[0], deepest);
        assert_relative_eq!(contact.history[1], foot, max_relative = 3e-8);
        // unloading begins at the same force, and ends on the adhesion limit
        assert_relative_eq!(contact.move_to(deepest, -1.0).elastic, force, max_relative = 3e-8);
        let foot = contact.history[1];
        assert_relative_eq!(contact.force(foot), pull, max_relative = 3e-8);
        assert_relative_eq!(contact.force(foot * (1.0 + 1e-12)), pull, max_relative = 3e-8);
    }
}

#[test]
fn attraction_before_and_after_contact() {
    let mut new = Contact::new(limestone(&[]), small());
    assert_relative_eq!(new.force(-0.1e-9), -1.5678680e-9, max_relative = 3e-8);
    assert_relative_eq!(new.force(0.0), -2.64e-9, max_relative = 1e-12);
    // the end of the tail, 100 separations
    assert!(new.force(-99.9999 * A) < -2.5e-13);
    assert_eq!(new.force(-100.0001 * A), 0.0);
    new.force(0.1e-9);
    let foot = new.history[1];
    assert_relative_eq!(foot, 49.427506e-12, max_relative = 3e-8);
    assert_relative_eq!(new.force(foot - 0.1e-9), -2.5464808e-9, max_relative = 3e-8);
    assert_eq!(new.move_to(foot - 0.1e-9, -1.0).damping, 0.0);
    assert_eq!(new.move_to(foot - 0.1e-9, -1.0).adhesion, 0.0);
    assert_eq!(new.law.reach(new.size, &new.history), 100.0 * A - foot);
}

#[test]
fn tails_end_where_they_are_told_to() {
    for (tail, gap) in [("cut", A), ("none", 0.0), ("full", 100.0 * A)] {
        let mut contact = Contact::new(limestone(&[("tail", tail.into())]), small());
        assert_eq!(contact.law.largest_reach(contact.size), gap);
        contact.force(0.1e-9);
        let end = contact.history[1] - gap;
        let close = 1e-9 * (gap + end.abs());
        assert!(contact.force(end + close) < 0.0, "{tail}");
        assert_eq!(contact.force(end - close), 0.0, "{tail}");
        assert_eq!(contact.energy(end - close), 0.0, "{tail}");
        assert!(contact.energy(end + close).abs() < 1e-26, "{tail}");
    }
}

#[test]
fn reloading_passes_through_where_it_was_unloaded() {
    let mut contact = Contact::new(limestone(&[]), small());
    let deepest = 0.2e-9;
    let force = contact.force(deepest);
    for below in [0.15e-9, 0.05e-9, -0.3e-9, -20e-9] {
        contact.force(below);
        assert_relative_eq!(contact.move_to(deepest, 1.0).elastic, force, max_relative = 1e-13);
        assert_eq!(contact.history[0], deepest);
    }
    // and goes on along the yield line
    let scale = contact.law.scale(contact.size);
    assert_relative_eq!(
        contact.force(0.3e-9),
        scale.line * 0.3e-9 - scale.pull,
        max_relative = 1e-13
    );
}

#[test]
fn damping_follows_the_elastic_part_of_the_overlap() {
    let mut contact = Contact::new(limestone(&[]), small());
    let scale = contact.law.scale(contact.size);
    let mass = contact.size.mass;
    let yielding = 0.2 * (mass * scale.line).sqrt();
    // continuous where the contact first yields
    let first = contact.look(scale.yields_at * (1.0 - 1e-12), 1.0).damping;
    assert_relative_eq!(first, yielding, max_relative = 1e-9);
    assert_relative_eq!(contact.move_to(0.1e-9, 1.0).damping, yielding, max_relative = 1e-14);
    let foot = contact.history[1];
    let elastic = 0.2 * (mass * scale.hertz).sqrt() * libm::pow(0.1e-9 - foot, 0.25);
    assert_relative_eq!(contact.look(0.1e-9, -1.0).damping, elastic, max_relative = 1e-12);

    let mut total = Contact::new(limestone(&[("damping_overlap", "total".into())]), small());
    total.force(0.1e-9);
    let as_printed = 0.2 * (mass * scale.hertz).sqrt() * libm::pow(0.06e-9, 0.25);
    assert_relative_eq!(total.look(0.06e-9, -1.0).damping, as_printed, max_relative = 1e-12);
}

#[test]
fn the_yield_overlap_as_printed_makes_the_force_jump() {
    let mut contact = Contact::new(limestone(&[("yield_overlap", "as-printed".into())]), small());
    let scale = contact.law.scale(contact.size);
    let (before, after) = (scale.yields_at * (1.0 - 1e-12), scale.yields_at * (1.0 + 1e-12));
    // 8 k_pl h_Y of Hertz, 4 k_pl h_Y of the yield line
    let unit = scale.line * scale.level;
    assert_relative_eq!(contact.force(before) + scale.pull, 8.0 * unit, max_relative = 1e-9);
    assert_relative_eq!(contact.force(after) + scale.pull, 4.0 * unit, max_relative = 1e-9);
}

#[test]
fn without_adhesion_and_yielding_it_is_hertz_and_tsuji() {
    let pair = MaterialPair {
        a: LIMESTONE,
        b: LIMESTONE,
    };
    let restitution = 0.7541807;
    let hertz =
        super::super::super::HertzTsuji::new(&crate::parameters::values(&[("restitution", restitution)]), &pair);
    let hertz = hertz.unwrap();
    let alpha = crate::restitution::hertz_damping(restitution);
    let changed = [
        ("adhesion_force", 0.0.into()),
        ("loading", "elastic".into()),
        ("alpha", alpha.into()),
    ];
    let law = limestone(&changed);
    for overlap in [-1e-9, 1e-12, 1e-9, 1e-8] {
        for (rate, share) in [(1.0, 0.0), (-1.0, 1e-3), (1.0, 0.1), (-1.0, 1.5)] {
            let input = NormalInput {
                size: small(),
                overlap,
                rate,
                half_window: share * overlap.abs(),
            };
            let (one, other) = (law.respond(&input, &mut [0.0; 3]), hertz.respond(&input, &mut []));
            // the mean over the window is taken with 3 points where the contact ends
            assert_relative_eq!(one.elastic, other.elastic, max_relative = 1e-4);
            assert_relative_eq!(one.damping, other.damping, max_relative = 2e-2);
        }
        assert_relative_eq!(
            law.energy(small(), overlap, &[0.0; 3]),
            hertz.energy(small(), overlap, &[]),
            max_relative = 1e-14
        );
    }
}

#[test]
fn faults_are_told() {
    let told = |changed: &[(&str, Value)], removed: &[&str]| {
        let mut values = values(changed);
        for name in removed {
            values.remove(*name);
        }
        let pair = MaterialPair {
            a: LIMESTONE,
            b: LIMESTONE,
        };
        Tomas::new(&values, &pair).map_err(|errors| errors[0].to_string())
    };
    assert!(
        told(&[], &["micro_yield_strength"])
            .unwrap_err()
            .contains("`micro_yield_strength` is missing")
    );
    assert!(told(&[], &["kappa_p"]).unwrap_err().contains("`kappa_p` is missing"));
    assert!(told(&[], &["alpha"]).unwrap_err().contains("the damping is missing"));
    assert!(
        told(&[("kappa_p", 0.9.into())], &[])
            .unwrap_err()
            .contains("`kappa_a` must be larger")
    );
    assert!(
        told(&[("restitution", 0.5.into())], &[])
            .unwrap_err()
            .contains("both tell the damping")
    );
    let elastic = [("loading", "elastic".into())];
    assert!(told(&elastic, &["micro_yield_strength", "kappa_p"]).is_ok());
    for (changed, name) in [
        ([("tail", "none".into()), ("range", 50.0.into())], "`range`"),
        ([("tail", "cut".into()), ("range", 50.0.into())], "`range`"),
        (
            [("loading", "elastic".into()), ("yield_overlap", "as-printed".into())],
            "`yield_overlap`",
        ),
    ] {
        let refused = told(&changed, &[]).unwrap_err();
        assert!(refused.contains(name) && refused.contains("leave out"), "{refused}");
    }
}

/// A contact with random parameters that is dented to some overlap: the law, its size, and the overlap over `h_Y`.
fn any_contact() -> impl Strategy<Value = (Tomas, PairSize, f64)> {
    let exponent = |lower: f64, upper: f64| (lower..upper).prop_map(|e| libm::pow(10.0, e));
    (
        exponent(-10.0, -6.0),
        exponent(-10.0, -8.5),
        exponent(7.0, 10.0),
        (0.1f64..1.0, 0.0f64..0.99),
        exponent(-8.0, -4.0),
        exponent(-3.0, 5.0),
    )
        .prop_map(|(force, separation, strength, (kappa_a, share), radius, depth)| {
            let law = limestone(&[
                ("adhesion_force", force.into()),
                ("separation", separation.into()),
                ("micro_yield_strength", strength.into()),
                ("kappa_a", kappa_a.into()),
                ("kappa_p", (share * kappa_a).into()),
            ]);
            (law, size(radius), depth)
        })
}

proptest! {
    #[test]
    fn the_foot_is_where_both_curves_meet((law, size, depth) in any_contact()) {
        let scale = law.scale(size);
        let deepest = scale.level * (1.0 + depth);
        let foot = scale.foot(deepest);
        prop_assert!((0.0..deepest).contains(&foot));
        let elastic_part = deepest - foot;
        let curve = scale.hertz * elastic_part * elastic_part.sqrt();
        let line = scale.line * deepest + scale.limit * foot;
        // where the foot is close to the deepest overlap, rounding of the difference
        let rounding = 1e-13 + 1e-15 * deepest / elastic_part;
        prop_assert!((curve - line).abs() <= rounding * line, "{curve:e} {line:e}");
        prop_assert!(scale.foot(scale.level) <= 1e-14 * scale.level);
    }

    #[test]
    fn the_force_is_continuous((law, size, depth) in any_contact()) {
        let scale = law.scale(size);
        let mut contact = Contact::new(law, size);
        let deepest = scale.level * (1.0 + depth);
        prop_assume!(deepest < size.radius);
        let unit = scale.pull + (scale.line + scale.limit) * deepest;
        let mut places = vec![0.0, scale.level, deepest];
        let close = |contact: &Contact, place: f64| {
            let step = 1e-12 * place.abs().max(scale.separation);
            let (below, above) = (contact.look(place - step, -1.0).elastic, contact.look(place + step, 1.0).elastic);
            (above - below).abs()
        };
        for &place in &places {
            prop_assert!(close(&contact, place) <= 1e-6 * unit, "new, at {place:e}");
        }
        contact.force(deepest);
        places.push(contact.history[1]);
        for place in places {
            prop_assert!(close(&contact, place) <= 1e-6 * unit, "dented, at {place:e}");
        }
    }

    #[test]
    fn stiffness_is_the_slope_of_the_force((law, size, depth) in any_contact(), share in -2.0f64..2.0) {
        let scale = law.scale(size);
        let mut contact = Contact::new(law, size);
        let deepest = scale.level * (1.0 + depth);
        contact.force(deepest);
        let foot = contact.history[1];
        let unit = if share > 0.0 { deepest - foot } else { scale.separation };
        let at = foot + share * unit;
        let step = 1e-4 * share.abs() * unit;
        prop_assume!((at - deepest).abs() > 2.0 * step && share.abs() > 0.01);
        let slope = (contact.look(at + step, 1.0).elastic - contact.look(at - step, 1.0).elastic) / (2.0 * step);
        let stiffness = law.stiffness(size, at, &contact.history);
        let rounding = 1e-14 * contact.look(at, 1.0).elastic.abs().max(scale.pull) / step
            + 1e-15 * deepest / step * stiffness.abs();
        prop_assert!((slope - stiffness).abs() <= 1e-6 * stiffness.abs() + rounding, "{slope:e} {stiffness:e}");
    }
}
