//! Metrics of curves whose answers are known.

use super::*;
use proptest::prelude::*;

const NONE: Thresholds = Thresholds {
    run: None,
    reference: 0.0,
};

#[test]
fn the_force_is_compared_with_a_measured_curve() {
    let run = Made::default().read(&Reading::default());
    // at these strains the run has 1, 1.5, 2 N, and 1.2 N between two rows
    let reference =
        measured("strain,loading force [N],unloading force [N]\n0.2,4.0,4.4\n0.1,1.3,\n0.12,,1.6\n0.15,1.5,\n")
            .unwrap();
    let found = compare(&run, &reference, NONE);
    let top = found.rtop.unwrap();
    assert!(near(top.value, 2.0 / 4.2) && near(top.reference, 4.2) && near(top.position, 0.2));
    assert_eq!((top.cycles, top.deviation), (3, Some(0.0)));
    let errf = found.errf.unwrap();
    let squares: f64 = [2.0, 2.4, 0.3, 0.4, 0.0].iter().map(|x: &f64| x * x).sum();
    assert!(errf.levels == 5 && near(errf.value, (squares / 5.0).sqrt()), "{errf:?}");
    assert_eq!(found.pairs.len(), 5);
    let reason = |metric: Option<LeftOut>| metric.unwrap().0;
    assert!(reason(found.errz.err()).contains("the run has no force distribution"));
    assert!(reason(found.bhat.err()).contains("the run has no force distribution"));
    assert!(found.errz_at.is_none() && found.remarks.is_empty());
}

/// Less in unloading than in loading, but at the turn.
fn with_a_loop(m: Moment) -> f64 {
    let missing = if m.loading { 0.0 } else { 20.0 * (TOP - m.strain) };
    10.0 * m.strain - missing
}

#[test]
fn a_run_that_goes_beyond_the_top_of_the_reference_is_told_by_its_loading() {
    let run = Made {
        force: with_a_loop,
        ..Made::default()
    };
    let run = run.read(&Reading::default());
    let ratio = |reference: &str| compare(&run, &measured(reference).unwrap(), NONE).rtop.unwrap().value;
    // the turn of the reference: 1.5 N in loading, 0.5 N in unloading
    assert!(near(
        ratio("strain,loading force [N],unloading force [N]\n0.1,1,0.4\n0.15,3,3\n"),
        0.5
    ));
    // where the run turns, too, both tell it
    assert!(near(
        ratio("strain,loading force [N],unloading force [N]\n0.1,1,0.4\n0.2,4,4\n"),
        0.5
    ));
    // a reference that tells unloading alone is held against unloading
    assert!(near(ratio("strain,unloading force [N]\n0.1,0.4\n0.15,1\n"), 0.5));
}

#[test]
fn what_the_run_does_not_reach_is_left_out() {
    let run = Made::default().read(&Reading::default());
    let reference = measured("strain,loading force [N]\n0.1,2\n0.25,5\n").unwrap();
    let found = compare(&run, &reference, NONE);
    assert!(
        found
            .rtop
            .unwrap_err()
            .0
            .contains("does not reach the largest strain of the reference, 0.25")
    );
    assert!(near(found.errf.as_ref().unwrap().value, 1.0) && found.errf.unwrap().levels == 1);
    assert!(found.remarks[0].starts_with("1 of 2 levels"), "{:?}", found.remarks);
    // a top that is missed by rounding is reached
    let reference = measured("strain,loading force [N]\n0.20001,4\n").unwrap();
    assert!(near(compare(&run, &reference, NONE).rtop.unwrap().value, 0.5));
    let pulled = measured("strain,loading force [N]\n0.2,-4\n").unwrap();
    assert!(compare(&run, &pulled, NONE).rtop.unwrap_err().0.contains("not above 0"));
}

/// More contacts with strain, spread over bins; 10 grains.
fn contacts(m: Moment) -> Counts {
    let n = (100.0 * m.strain).round() as u32;
    ([7 + n, 5, 3 + n, 2, 1], [4, 3, 2, 1, n])
}

#[test]
fn contacts_are_counted_above_a_threshold() {
    let made = Made {
        contacts: Some(contacts),
        ..Made::default()
    };
    let run = made.read(&Reading::default());
    let (bins, top) = (
        run.bins.clone().unwrap(),
        run.loading.last().unwrap().contacts.clone().unwrap(),
    );
    assert_eq!(bins.edges(), EDGES);
    assert_eq!((top.grains, top.pairs.clone()), (10.0, vec![27.0, 5.0, 23.0, 2.0, 1.0]));
    let z = |threshold| top.coordination(&bins, threshold);
    assert!(near(z(0.0).unwrap(), (2.0 * 58.0 + 30.0) / 10.0));
    assert!(near(z(0.002).unwrap(), (2.0 * 26.0 + 23.0) / 10.0));
    // half of the second bin
    assert!(near(z(0.0015).unwrap(), (2.0 * 28.5 + 24.5) / 10.0));
    assert!(near(z(0.004).unwrap(), (2.0 + 20.0) / 10.0));
    assert_eq!(z(0.0041), None);
}

#[test]
fn the_planted_threshold_is_found() {
    let made = Made {
        contacts: Some(contacts),
        ..Made::default()
    };
    let run = made.read(&Reading::default());
    let bins = run.bins.clone().unwrap();
    for planted in EDGES {
        let mut text = "strain,loading coordination,unloading coordination\n".to_string();
        for (a, b) in run.loading.iter().zip(&run.unloading) {
            let z = |level: &Level| level.contacts.as_ref().unwrap().coordination(&bins, planted).unwrap();
            let _ = writeln!(text, "{:?},{:?},{:?}", a.position, z(a), z(b));
        }
        let told = Thresholds {
            run: Some(0.001),
            reference: 0.0,
        };
        let found = compare(&run, &measured(&text).unwrap(), told);
        let errz = found.errz.unwrap();
        assert_eq!((errz.threshold, errz.misfit.levels), (planted, 10));
        assert!(errz.misfit.value < 1e-12, "{errz:?}");
        let at = found.errz_at.unwrap().unwrap();
        assert!(
            at.threshold == 0.001 && (at.misfit.value < 1e-12) == (planted == 0.001),
            "{at:?}"
        );
        assert!(found.rtop.unwrap_err().0.contains("tells no force"));
        assert!(
            found
                .bhat
                .unwrap_err()
                .0
                .contains("the reference has no force distribution")
        );
        assert_eq!(found.remarks.len(), usize::from(planted == 0.004));
        // the same, with another run as the reference and a threshold on it
        let told = Thresholds {
            run: None,
            reference: planted,
        };
        let errz = compare(&run, &run, told).errz.unwrap();
        assert!(errz.threshold == planted && errz.misfit.value < 1e-12);
    }
}

#[test]
fn the_overlap_of_distributions_is_the_published_one() {
    let made = |contacts: fn(Moment) -> Counts| {
        Made {
            contacts: Some(contacts),
            ..Made::default()
        }
        .read(&discarding(1))
    };
    let even = made(|_| ([10, 10, 0, 0, 0], [0; 5]));
    let uneven = made(|_| ([16, 4, 0, 0, 0], [0; 5]));
    let far = made(|_| ([0, 0, 9, 0, 0], [1; 5]));
    let bhat = |a: &Strokes, b: &Strokes| compare(a, b, NONE).bhat;
    // B = sqrt(0.5 0.8) + sqrt(0.5 0.2)
    let expected = -libm::log(0.4f64.sqrt() + 0.1f64.sqrt());
    let found = bhat(&even, &uneven).unwrap();
    assert!(
        near(found.value, expected) && found.levels == 10,
        "{found:?} {expected}"
    );
    assert_eq!(bhat(&uneven, &even).unwrap(), found);
    assert!(bhat(&even, &even).unwrap().value < 1e-15);
    assert!(bhat(&even, &far).unwrap_err().0.contains("infinite"));
    // B is averaged, not its logarithm
    let half = made(|m| {
        if m.loading {
            ([10, 10, 0, 0, 0], [0; 5])
        } else {
            ([0, 0, 8, 0, 0], [0; 5])
        }
    });
    // the row at a turn belongs to both strokes: half of the ten levels
    assert!(near(bhat(&even, &half).unwrap().value, -libm::log(0.5)));
    let mut wider = even.clone();
    wider.bins = Bins::new(vec![0.0, 0.002, 0.004, 0.006, 0.008]);
    assert!(
        bhat(&wider, &even)
            .unwrap_err()
            .0
            .contains("the bins of the forces differ")
    );
    let above = made(|_| ([10, 10, 0, 0, 1], [0; 5]));
    assert!(compare(&above, &even, NONE).remarks[0].contains("4.8 % of the contacts are above"));
}

fn some_contacts() -> impl Strategy<Value = Contacts> {
    let counts = || prop::collection::vec(0..1000u32, 9).prop_map(|v| v.into_iter().map(f64::from).collect());
    (1..500u32, counts(), counts()).prop_map(|(grains, pairs, walls)| Contacts {
        grains: f64::from(grains),
        pairs,
        walls,
    })
}

/// One level of one phase.
fn lone(contacts: Contacts, bins: &Bins) -> Strokes {
    let level = |position| Level {
        position,
        force: None,
        coordination: None,
        contacts: Some(contacts.clone()),
        also: Vec::new(),
    };
    Strokes {
        name: "made".to_string(),
        position: Position::Strain,
        loading: vec![level(0.1), level(0.2)],
        unloading: Vec::new(),
        bins: Some(bins.clone()),
        also: Vec::new(),
        cycles: Some((1, 0)),
    }
}

proptest! {
    #[test]
    fn the_distance_of_distributions_is_one(a in some_contacts(), b in some_contacts()) {
        let to_itself = a.overlap_of_forces(&a);
        prop_assert!(to_itself.is_none_or(|overlap| (overlap - 1.0).abs() < 1e-14));
        let overlap = a.overlap_of_forces(&b);
        prop_assert_eq!(overlap, b.overlap_of_forces(&a));
        prop_assert!(overlap.is_none_or(|overlap| (0.0..1.0 + 1e-14).contains(&overlap)));
        let bins = Bins::new((0..9).map(f64::from).collect()).unwrap();
        let found = compare(&lone(a, &bins), &lone(b, &bins), NONE).bhat;
        prop_assert!(found.is_err() || found.is_ok_and(|m| m.value >= 0.0));
    }

    #[test]
    fn contacts_per_grain_fall_with_the_threshold(a in some_contacts(), x in 0.0..8.0, y in 0.0..8.0) {
        let bins = Bins::new((0..9).map(f64::from).collect()).unwrap();
        let (low, high) = (f64::min(x, y), f64::max(x, y));
        let z = |threshold| a.coordination(&bins, threshold).unwrap();
        prop_assert!(z(low) >= z(high) - 1e-9);
        for (edge, above) in bins.edges().iter().zip(a.coordinations()) {
            prop_assert!((z(*edge) - above).abs() <= 1e-12 * above.max(1.0));
        }
    }

    #[test]
    fn any_planted_threshold_is_found(a in some_contacts(), edge in 0..9usize) {
        let bins = Bins::new((0..9).map(f64::from).collect()).unwrap();
        let run = lone(a.clone(), &bins);
        let told = Thresholds { run: None, reference: bins.edges()[edge] };
        let errz = compare(&run, &run, told).errz.unwrap();
        prop_assert!(errz.misfit.value < 1e-12);
        // empty bins below it fit as well
        let empty = |k: usize| a.pairs[k] + a.walls[k] == 0.0;
        let lowest = (0..=edge).rev().find(|k| *k == 0 || !empty(k - 1)).unwrap();
        prop_assert_eq!(errz.threshold, bins.edges()[lowest]);
    }
}
