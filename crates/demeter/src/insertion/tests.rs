use super::*;
use crate::particles::Outside;
use proptest::prelude::*;
use std::f64::consts::PI;

fn materials() -> Vec<Material> {
    let material = |name: &str, density| Material {
        name: name.to_owned(),
        young_modulus: 1e7,
        poisson_ratio: 0.3,
        density,
    };
    vec![material("glass", 2500.0), material("steel", 7800.0)]
}

fn insertion(source: Source) -> Insertion {
    Insertion {
        fixed: false,
        name: "fill".to_owned(),
        material: 0,
        types: Vec::new(),
        source,
        velocity: DVec3::ZERO,
        velocity_deviation: 0.0,
        angular_velocity: DVec3::ZERO,
        tag: None,
        seed: 42,
    }
}

fn random(region: Region, diameter: SizeDistribution, amount: Amount) -> Insertion {
    insertion(Source::Random {
        region,
        diameter,
        amount,
    })
}

fn make_grains(insertion: &Insertion, domain: Option<&Domain>) -> Vec<NewGrain> {
    insert(insertion, &materials(), &[], domain).unwrap().grains
}

fn cube(edge: f64) -> Region {
    Region::Box {
        lower: DVec3::ZERO,
        upper: DVec3::splat(edge),
    }
}

fn domain(edge: f64, periodic: [bool; 3]) -> Domain {
    Domain {
        lower: DVec3::ZERO,
        upper: DVec3::splat(edge),
        periodic,
        outside: Outside::Stop,
    }
}

fn spheres(grains: &[NewGrain]) -> Vec<SizedPlace> {
    grains.iter().map(|g| (g.position, g.radius)).collect()
}

fn volume(grains: &[NewGrain]) -> f64 {
    grains.iter().map(|g| 4.0 / 3.0 * PI * g.radius.powi(3)).sum()
}

fn assert_packed(grains: &[NewGrain], region: &Region, domain: Option<&Domain>) {
    assert_eq!(first_overlap(&spheres(grains), domain, |_, _| true), None);
    let space = Space::new(region, domain).unwrap();
    for grain in grains {
        assert!(space.holds(grain.position, grain.radius), "{grain:?}");
        assert!(domain.is_none_or(|d| d.contains(grain.position)));
    }
}

/// FNV-1a over the bits of places and radii.
fn fingerprint(grains: &[NewGrain]) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for grain in grains {
        for value in [grain.position.x, grain.position.y, grain.position.z, grain.radius] {
            for byte in value.to_bits().to_le_bytes() {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
            }
        }
    }
    hash
}

const HYDROGEL: SizeDistribution = SizeDistribution::Normal {
    mean: 0.0215,
    standard_deviation: 0.0012,
    lower: 0.018,
    upper: 0.025,
};

#[test]
fn loose_packing_in_a_box_reaches_its_fraction_without_overlap() {
    let region = cube(0.3);
    let grains = make_grains(&random(region, HYDROGEL, Amount::VolumeFraction(0.28)), None);
    assert_packed(&grains, &region, None);
    // The fraction is met to half a grain.
    let half_a_grain = 0.5 * PI / 6.0 * 0.025_f64.powi(3);
    assert!((volume(&grains) - 0.28 * 0.027).abs() <= half_a_grain);
}

#[test]
fn packing_of_the_hydrogel_example_reaches_high_densities() {
    let region = Region::Box {
        lower: DVec3::ZERO,
        upper: DVec3::new(0.16519, 0.16583, 0.18),
    };
    for fraction in [0.45, 0.55, 0.57] {
        let grains = make_grains(&random(region, HYDROGEL, Amount::VolumeFraction(fraction)), None);
        assert_packed(&grains, &region, None);
        assert!((volume(&grains) / (0.16519 * 0.16583 * 0.18) - fraction).abs() < 1e-3);
    }
    // 514 grains by number, as in the experiment, at about 0.55.
    let grains = make_grains(&random(region, HYDROGEL, Amount::Count(514)), None);
    assert_eq!(grains.len(), 514);
    assert_packed(&grains, &region, None);
}

#[test]
fn periodic_packing_reaches_the_limit_and_uses_the_sides() {
    let domain = domain(0.4, [true; 3]);
    let region = cube(0.4);
    let diameter = SizeDistribution::Uniform {
        lower: 0.03,
        upper: 0.04,
    };
    let grains = make_grains(
        &random(region, diameter, Amount::VolumeFraction(MAX_FRACTION)),
        Some(&domain),
    );
    assert_packed(&grains, &region, Some(&domain));
    for axis in 0..3 {
        assert!(grains.iter().any(|g| g.position[axis] < 0.5 * g.radius));
    }
}

#[test]
fn cylinders_are_packed_too_upright_slanted_and_periodic() {
    let diameter = SizeDistribution::Uniform {
        lower: 0.02,
        upper: 0.03,
    };
    for (start, end) in [
        (DVec3::new(0.2, 0.2, 0.0), DVec3::new(0.2, 0.2, 0.4)),
        (DVec3::new(-0.1, 0.0, 0.1), DVec3::new(0.2, 0.3, -0.2)),
    ] {
        let radius = 0.15;
        let region = Region::Cylinder { start, end, radius };
        for fraction in [0.25, 0.53] {
            let packing = random(region, diameter.clone(), Amount::VolumeFraction(fraction));
            assert_packed(&make_grains(&packing, None), &region, None);
        }
    }
    let domain = domain(0.4, [false, false, true]);
    let region = Region::Cylinder {
        start: DVec3::new(0.2, 0.2, 0.0),
        end: DVec3::new(0.2, 0.2, 0.4),
        radius: 0.15,
    };
    let grains = make_grains(&random(region, diameter, Amount::VolumeFraction(0.5)), Some(&domain));
    assert_packed(&grains, &region, Some(&domain));
    assert!(
        grains
            .iter()
            .any(|g| g.position.z < 0.5 * g.radius || g.position.z > 0.4 - 0.5 * g.radius)
    );
}

#[test]
fn regions_may_cross_periodic_sides_or_reach_beyond_them() {
    let domain = domain(0.4, [true, true, false]);
    let diameter = SizeDistribution::Uniform {
        lower: 0.02,
        upper: 0.03,
    };
    for region in [
        // Across the side at x = 0.4, as wide as the domain in y.
        Region::Box {
            lower: DVec3::new(0.3, -0.5, 0.0),
            upper: DVec3::new(0.55, 0.9, 0.4),
        },
        Region::Cylinder {
            start: DVec3::new(0.0, 0.4, 0.05),
            end: DVec3::new(0.05, 0.4, 0.35),
            radius: 0.13,
        },
    ] {
        for fraction in [0.25, 0.5] {
            let packing = random(region, diameter.clone(), Amount::VolumeFraction(fraction));
            let grains = make_grains(&packing, Some(&domain));
            assert_packed(&grains, &region, Some(&domain));
            let at_both =
                |k: usize| grains.iter().any(|g| g.position[k] < 0.1) && grains.iter().any(|g| g.position[k] > 0.3);
            assert!(at_both(0) && at_both(1));
        }
    }
    // Only the part inside the domain counts.
    let wide = Region::Box {
        lower: DVec3::new(0.0, -0.5, 0.0),
        upper: DVec3::new(0.2, 0.9, 0.4),
    };
    let grains = make_grains(&random(wide, diameter, Amount::VolumeFraction(0.4)), Some(&domain));
    assert!((volume(&grains) / (0.2 * 0.4 * 0.4) - 0.4).abs() < 1e-3);
}

#[test]
fn wide_distributions_are_packed_loosely_and_densely() {
    let diameter = SizeDistribution::RosinRammler {
        scale: 0.06,
        exponent: 2.0,
        lower: 0.015,
        upper: 0.15,
    };
    for fraction in [0.3, 0.55] {
        let region = cube(0.5);
        let grains = make_grains(
            &random(region, diameter.clone(), Amount::VolumeFraction(fraction)),
            None,
        );
        assert!(grains.len() > 500, "{}", grains.len());
        assert_packed(&grains, &region, None);
    }
}

#[test]
fn a_layer_as_thin_as_its_grains_is_filled() {
    let region = Region::Box {
        lower: DVec3::ZERO,
        upper: DVec3::new(1.0, 1.0, 0.1),
    };
    for amount in [Amount::Count(30), Amount::Count(75)] {
        let grains = make_grains(&random(region, SizeDistribution::Single(0.1), amount), None);
        assert_packed(&grains, &region, None);
    }
}

#[test]
fn random_packings_keep_clear_of_grains_already_there() {
    let domain = domain(0.5, [true, false, false]);
    let region = cube(0.5);
    let diameter = SizeDistribution::Single(0.04);
    let first = make_grains(
        &random(region, SizeDistribution::Single(0.1), Amount::VolumeFraction(0.15)),
        Some(&domain),
    );
    for fraction in [0.05, 0.3] {
        let second = random(region, diameter.clone(), Amount::VolumeFraction(fraction));
        let second = insert(&second, &materials(), &spheres(&first), Some(&domain)).unwrap();
        let all: Vec<NewGrain> = first.iter().chain(&second.grains).copied().collect();
        assert_packed(&all, &region, Some(&domain));
    }
    let full = random(region, diameter, Amount::VolumeFraction(0.5));
    let message = insert(&full, &materials(), &spheres(&first), Some(&domain))
        .unwrap_err()
        .to_string();
    assert!(message.contains("would fill 0.65"), "{message}");
}

#[test]
fn packings_are_the_same_bits_everywhere() {
    // Golden bits: the same scenario must give the same grains on any machine, in any build. They may change only with
    // a stated reason, as every packing made before changes with them.
    let region = cube(0.2);
    let boxed = random(region, HYDROGEL, Amount::VolumeFraction(0.25));
    let dense = random(region, HYDROGEL, Amount::VolumeFraction(0.5));
    let round = random(
        Region::Cylinder {
            start: DVec3::ZERO,
            end: DVec3::new(0.0, 0.1, 0.2),
            radius: 0.1,
        },
        HYDROGEL,
        Amount::VolumeFraction(0.4),
    );
    let lattice = lattice(LatticeKind::Fcc, 0.03, 0.2, region, SizeDistribution::Single(0.02));
    let found = [boxed, dense, round, lattice].map(|i| fingerprint(&make_grains(&i, None)));
    assert_eq!(
        found,
        [
            16_910_829_567_758_106_188,
            2_111_590_973_878_454_856,
            9_965_110_294_302_043_981,
            18_115_900_982_947_841_355
        ]
    );
}

#[test]
fn seeds_change_the_packing_and_velocities_do_not() {
    let mut description = random(cube(0.2), HYDROGEL, Amount::Count(60));
    let first = fingerprint(&make_grains(&description, None));
    description.velocity_deviation = 0.3;
    assert_eq!(fingerprint(&make_grains(&description, None)), first);
    description.seed += 1;
    assert_ne!(fingerprint(&make_grains(&description, None)), first);
}

#[test]
fn impossible_packings_say_what_is_possible() {
    let message = |region, diameter, amount| {
        let result = insert(&random(region, diameter, amount), &materials(), &[], None);
        result.unwrap_err().to_string()
    };
    let single = SizeDistribution::Single;
    for (found, part) in [
        (
            message(cube(1.0), single(0.1), Amount::VolumeFraction(0.65)),
            "the volume fraction is 0.65",
        ),
        (
            message(cube(1.0), single(0.1), Amount::VolumeFraction(f64::NAN)),
            "the volume fraction is NaN",
        ),
        (message(cube(1.0), single(0.1), Amount::Count(0)), "at least 1"),
        (message(cube(1.0), single(0.1), Amount::Count(1500)), "would fill 0.785"),
        (
            message(cube(1.0), single(0.1), Amount::Count(u32::MAX)),
            "at most 20000000",
        ),
        (
            message(cube(1.0), single(1e-9), Amount::VolumeFraction(0.3)),
            "at most 20000000",
        ),
        (
            message(cube(1.0), single(1.1), Amount::VolumeFraction(0.3)),
            "does not fit",
        ),
        (
            message(cube(-1.0), single(1.1), Amount::Count(1)),
            "must be below the upper",
        ),
        (
            message(cube(f64::NAN), single(1.1), Amount::Count(1)),
            "coordinates must be numbers",
        ),
        // Five grains in a box of 1.6 diameters: 0.64 by volume, but at hard sides fewer.
        (
            message(cube(0.18), single(0.1), Amount::Count(6)),
            "the grains jammed; 0.539",
        ),
    ] {
        assert!(
            found.starts_with("insertion `fill`: ") && found.contains(part),
            "{found}"
        );
    }
}

#[test]
fn a_packing_that_jams_beside_others_tells_what_these_fill() {
    let there = [(DVec3::splat(0.09), 0.07)];
    let packing = random(cube(0.18), SizeDistribution::Single(0.1), Amount::Count(3));
    let message = insert(&packing, &materials(), &there, None).unwrap_err().to_string();
    assert!(
        message.contains("0.269 of the region was asked for beside 0.246 that the grains of other"),
        "{message}"
    );
}

#[test]
fn the_reached_fraction_of_a_jammed_packing_is_possible() {
    // 6 grains of diameter 0.1 in this cube jam. With the diameter that the message's fraction means they fit.
    let region = cube(0.18);
    let jammed = insert(
        &random(region, SizeDistribution::Single(0.1), Amount::Count(6)),
        &materials(),
        &[],
        None,
    );
    let Err(InsertionError {
        problem: InsertionProblem::Packing(PackingError::Jammed { wanted, reached, .. }),
        ..
    }) = jammed
    else {
        panic!("{jammed:?}");
    };
    assert!(reached > 0.3 && reached < wanted);
    let diameter = 0.1 * (0.99 * reached / wanted).cbrt();
    make_grains(
        &random(region, SizeDistribution::Single(diameter), Amount::Count(6)),
        None,
    );
}

fn lattice(kind: LatticeKind, spacing: f64, jitter: f64, region: Region, diameter: SizeDistribution) -> Insertion {
    insertion(Source::Lattice {
        kind,
        spacing,
        jitter,
        region,
        diameter,
        count: None,
    })
}

#[test]
fn lattices_have_the_neighbours_and_the_density_of_their_kind() {
    let (three, two): (f64, f64) = (3.0, 2.0);
    for (kind, neighbours, cell, sites) in [
        (LatticeKind::SimpleCubic, 6, DVec3::ONE, 1),
        (LatticeKind::Bcc, 8, DVec3::splat(2.0 / three.sqrt()), 2),
        (LatticeKind::Fcc, 12, DVec3::splat(two.sqrt()), 4),
        (
            LatticeKind::Hcp,
            12,
            DVec3::new(1.0, three.sqrt(), (8.0 / three).sqrt()),
            4,
        ),
    ] {
        // A periodic box of whole cells: every site has all its neighbours.
        let domain = Domain {
            lower: DVec3::splat(-0.3),
            upper: DVec3::splat(-0.3) + 4.0 * cell,
            periodic: [true; 3],
            outside: Outside::Stop,
        };
        let region = Region::Box {
            lower: domain.lower,
            upper: domain.upper,
        };
        let grains = make_grains(
            &lattice(kind, 1.0, 0.0, region, SizeDistribution::Single(1.0 - 1e-9)),
            Some(&domain),
        );
        assert_eq!(grains.len(), 64 * sites);
        assert_packed(&grains, &region, Some(&domain));
        for a in &grains {
            let near = |b: &&NewGrain| domain.difference(a.position, b.position).length() < 1.0 + 1e-9;
            assert_eq!(grains.iter().filter(near).count() - 1, neighbours, "{kind:?}");
        }
    }
}

#[test]
fn lattices_fill_boxes_exactly_and_layers_from_below() {
    let mut cubic = lattice(
        LatticeKind::SimpleCubic,
        0.1,
        0.0,
        cube(1.0),
        SizeDistribution::Single(0.1),
    );
    assert_eq!(make_grains(&cubic, None).len(), 1000);
    let Source::Lattice { count, .. } = &mut cubic.source else {
        panic!("not a lattice");
    };
    *count = Some(150);
    let grains = make_grains(&cubic, None);
    assert_eq!(grains.len(), 150);
    assert!(grains.iter().all(|g| g.position.z < 0.16 && g.position.z >= 0.05));
    assert!(grains.windows(2).all(|pair| pair[0].position.z <= pair[1].position.z));
}

#[test]
fn jitter_moves_grains_within_its_reach_and_not_out_of_the_region() {
    let region = Region::Cylinder {
        start: DVec3::ZERO,
        end: DVec3::new(0.0, 0.0, 1.0),
        radius: 0.5,
    };
    let at = |jitter| {
        make_grains(
            &lattice(LatticeKind::Hcp, 0.1, jitter, region, SizeDistribution::Single(0.045)),
            None,
        )
    };
    let (still, moved) = (at(0.0), at(0.15));
    assert_eq!(still.len(), moved.len());
    assert_packed(&moved, &region, None);
    let shift = |k: usize| (moved[k].position - still[k].position).abs().max_element();
    let shifts: Vec<f64> = (0..still.len()).map(shift).collect();
    assert!(shifts.iter().all(|s| *s <= 0.015 * (1.0 + 1e-9)));
    assert!(shifts.iter().filter(|s| **s > 0.0).count() > 9 * shifts.len() / 10);
}

#[test]
fn wrong_lattices_are_refused() {
    let message = |spacing, jitter, edge, diameter| {
        let lattice = lattice(
            LatticeKind::Fcc,
            spacing,
            jitter,
            cube(edge),
            SizeDistribution::Single(diameter),
        );
        insert(&lattice, &materials(), &[], None).unwrap_err().to_string()
    };
    assert!(message(0.0, 0.0, 1.0, 0.1).contains("the spacing is 0 m"));
    assert!(message(0.1, 0.7, 1.0, 0.1).contains("the jitter is 0.7"));
    assert!(message(0.1, 0.0, 1.0, 1.1).contains("no site with room"));
    assert!(message(1e-9, 0.0, 1.0, 0.1).contains("at most 20000000"));
}

#[test]
fn velocities_have_the_mean_and_the_deviation_that_were_asked_for() {
    let mut description = lattice(
        LatticeKind::SimpleCubic,
        0.1,
        0.0,
        cube(2.0),
        SizeDistribution::Single(0.05),
    );
    description.velocity = DVec3::new(1.0, -2.0, 0.5);
    description.velocity_deviation = 0.2;
    description.angular_velocity = DVec3::Z;
    let grains = make_grains(&description, None);
    let n = grains.len() as f64;
    for axis in 0..3 {
        let mean = grains.iter().map(|g| g.velocity[axis]).sum::<f64>() / n;
        let variance = grains.iter().map(|g| (g.velocity[axis] - mean).powi(2)).sum::<f64>() / n;
        // Standard errors: deviation / sqrt(n), and variance sqrt(2 / n); 5 of them allowed.
        assert!(
            (mean - description.velocity[axis]).abs() < 5.0 * 0.2 / n.sqrt(),
            "{mean}"
        );
        assert!((variance / 0.04 - 1.0).abs() < 5.0 * (2.0 / n).sqrt(), "{variance}");
    }
    assert!(
        grains
            .iter()
            .all(|g| g.angular_velocity == DVec3::Z && g.density == 2500.0)
    );
}

#[test]
fn lists_give_their_grains_and_refuse_nonsense() {
    let list = |positions: &[DVec3], diameters: &[f64]| {
        let mut description = insertion(Source::List {
            positions: positions.to_vec(),
            diameters: diameters.to_vec(),
        });
        description.material = 1;
        insert(&description, &materials(), &[], None)
    };
    let grains = list(&[DVec3::X, DVec3::Y], &[0.2, 0.4]).unwrap().grains;
    assert_eq!(
        (grains[1].position, grains[1].radius, grains[1].density),
        (DVec3::Y, 0.2, 7800.0)
    );
    let message = |positions: &[DVec3], diameters: &[f64]| list(positions, diameters).unwrap_err().to_string();
    assert!(message(&[DVec3::X], &[]).contains("1 positions but 0 diameters"));
    assert!(message(&[], &[]).contains("empty"));
    assert!(message(&[DVec3::X], &[-1.0]).contains("grain 1 of the list: the diameter is -1"));
    assert!(message(&[DVec3::X], &[1e-300]).contains("the diameter is 1e-300; allowed"));
    assert!(message(&[DVec3::NAN], &[1.0]).contains("a coordinate is NaN"));
}

#[test]
fn wrong_settings_are_refused() {
    let message = |change: fn(&mut Insertion)| {
        let mut description = random(cube(1.0), HYDROGEL, Amount::Count(1));
        change(&mut description);
        insert(&description, &materials(), &[], None).unwrap_err().to_string()
    };
    assert!(message(|i| i.material = 2).contains("material number 2 does not exist; there are 2"));
    assert!(message(|i| i.types = vec![0, 7]).contains("material number 7"));
    assert!(message(|i| i.velocity.y = f64::NAN).contains("the velocity is (0, NaN, 0)"));
    assert!(message(|i| i.velocity_deviation = -1.0).contains("velocity deviation is -1"));
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>(), -1.0..1.0f64, Just(0.0), Just(1.0)]
}

proptest! {
    #[test]
    fn any_region_gives_an_error_or_grains_inside(
        corners in proptest::array::uniform6(coordinate()), radius in coordinate(), diameter in coordinate(),
        round in any::<bool>(), dense in any::<bool>(), periodic in any::<[bool; 3]>(),
    ) {
        let (a, b) = (DVec3::from_slice(&corners[..3]), DVec3::from_slice(&corners[3..]));
        let region = match round {
            true => Region::Cylinder { start: a, end: b, radius },
            false => Region::Box { lower: a, upper: b },
        };
        let domain = Domain { lower: DVec3::splat(-1.0), upper: DVec3::ONE, periodic, outside: Outside::Stop };
        let amount = if dense { Amount::Count(25) } else { Amount::Count(4) };
        let diameter = SizeDistribution::Single(diameter.abs());
        let packing = random(region, diameter.clone(), amount);
        let sites = insertion(Source::Lattice {
            kind: LatticeKind::Bcc, spacing: 0.3, jitter: 0.1, region, diameter, count: Some(10),
        });
        for domain in [None, Some(&domain)] {
            if let Ok(made) = insert(&packing, &materials(), &[], domain) {
                prop_assert_eq!(first_overlap(&spheres(&made.grains), domain, |_, _| true), None);
                let space = Space::new(&region, domain).unwrap();
                prop_assert!(made.grains.iter().all(|g| space.holds(g.position, g.radius)));
            }
            let _ = insert(&sites, &materials(), &[], domain);
        }
    }
}
