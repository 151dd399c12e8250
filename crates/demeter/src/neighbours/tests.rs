use super::packed::PackedPair;
use super::*;
use crate::particles::{Domain, NewGrain, Outside};
use demeter_physics::contact::LawChoice;
use glam::DVec3;

/// Numbers in 0..1 that are always the same.
fn uniform(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn materials(count: usize) -> Materials {
    let list = (0..count).map(|k| crate::materials::Material {
        name: format!("m{k}"),
        young_modulus: 1e7,
        poisson_ratio: 0.3,
        density: 1000.0,
    });
    let normal = LawChoice {
        law: "hertz-tsuji".into(),
        parameters: [(
            "restitution".to_string(),
            demeter_physics::parameters::Value::Number(0.5),
        )]
        .into_iter()
        .collect(),
    };
    Materials::new(list.collect(), |_, _| crate::materials::PairChoice {
        normal: normal.clone(),
        tangential: None,
        rolling: None,
        multi_contact: None,
    })
    .unwrap()
}

/// A table that tells the pairs of every grain.
fn telling() -> Neighbours {
    let mut table = Neighbours::default();
    table.tell_pairs_of_grains();
    table
}

fn domain(size: DVec3, periodic: [bool; 3]) -> Domain {
    Domain {
        lower: -0.5 * size,
        upper: 0.5 * size,
        periodic,
        outside: Outside::Stop,
    }
}

/// Grains at places; ids run against the order of the indices, so that both orders are seen.
fn grains_at(places: &[(DVec3, f64)], materials: u16) -> Grains {
    let mut grains = Grains::default();
    for (k, &(position, radius)) in places.iter().enumerate() {
        let grain = NewGrain {
            material: k as u16 % materials,
            radius,
            density: 1.0,
            position,
            velocity: DVec3::ZERO,
            angular_velocity: DVec3::ZERO,
            fixed: false,
        };
        grains.push((places.len() - k) as u32, &grain);
    }
    grains
}

/// Grains anywhere in a domain, between two radii, more of the small ones.
fn random_places(count: usize, radii: (f64, f64), domain: &Domain) -> Vec<(DVec3, f64)> {
    let mut uniform = uniform(12345);
    (0..count)
        .map(|_| {
            let share = uniform();
            let position = domain.lower + DVec3::new(uniform(), uniform(), uniform()) * domain.size();
            (position, radii.0 * libm::pow(radii.1 / radii.0, share * share))
        })
        .collect()
}

const SKIN: f64 = 0.02;

/// Compares with all pairs, and checks the chunks and the entries of every grain.
fn check(places: &[(DVec3, f64)], domain: Domain, kinds: usize, at_least: usize) {
    let comm = Single::new(domain);
    let grains = grains_at(places, kinds as u16);
    let materials = materials(kinds);
    let mut found = telling();
    // whatever was in the memory before does not matter
    found.find(
        &grains_at(&places[places.len() / 2..], 1),
        &[],
        &materials,
        &comm,
        0.5 * SKIN,
    );
    found.find(&grains, &[], &materials, &comm, SKIN);
    let mut expected = Vec::new();
    for i in 0..grains.len() {
        for j in 0..grains.len() {
            let d = grains.position[i] - grains.position[j];
            let d = d + comm.shift(comm.nearest_image(d));
            if grains.id[i] < grains.id[j] && d.length() < grains.radius(i) + grains.radius(j) + SKIN {
                expected.push((i as u32, j as u32));
            }
        }
    }
    let mut got = vec![];
    let mut laws_before = vec![];
    for chunk in 0..found.chunks() {
        let (pairs, law) = found.chunk(chunk);
        assert!((1..=CHUNK).contains(&pairs.len()));
        assert_eq!(found.before_chunk(chunk), got.len());
        laws_before.push(law);
        for p in pairs.iter() {
            let (i, j) = (p.i as usize, p.j as usize);
            let d = grains.position[i] - grains.position[j];
            assert_eq!(comm.shift(p.shift), comm.shift(comm.nearest_image(d)));
            assert_eq!(law, materials.pair(grains.material[i], grains.material[j]));
            got.push((p.i, p.j));
        }
    }
    assert_eq!(found.pair_count(), got.len());
    got.sort_unstable();
    assert!(
        expected.len() >= at_least,
        "the case holds only {} pairs",
        expected.len()
    );
    assert!(got == expected, "{} pairs for {}", got.len(), expected.len());
    let mut summed = vec![];
    for segment in 0..found.segments() {
        let chunks = found.chunks_of_segment(segment);
        let own = found.grains_of_segment(segment);
        let first = summed.len();
        for chunk in chunks {
            let keys = found.chunk(chunk).0.iter().map(|pair| (pair.later(), pair.earlier()));
            let begin = summed.len();
            summed.extend(keys);
            let of_chunk = &summed[begin..];
            assert!(of_chunk.iter().all(|(later, _)| own.contains(&(*later as usize))));
            assert!(
                of_chunk.is_sorted_by(|a, b| a < b),
                "chunk {chunk} is not in the order of the sums"
            );
        }
        if kinds > 1 {
            // law by law
            summed[first..].sort_unstable();
        }
    }
    assert_eq!(summed.len(), got.len());
    assert!(summed.is_sorted_by(|a, b| a < b), "not in the order of the sums");
    let mut entries = 0;
    for g in 0..grains.len() {
        let partners: Vec<u32> = (found.pairs_of(g))
            .map(|(chunk, slot, first)| {
                let pair = found.chunk(chunk).0.get(slot);
                assert_eq!(if first { pair.i } else { pair.j }, g as u32);
                assert_eq!(
                    found.find_pair(pair.i, pair.j),
                    Some((chunk, found.before_chunk(chunk) + slot))
                );
                grains.id[if first { pair.j } else { pair.i } as usize]
            })
            .collect();
        assert!(partners.is_sorted_by(|a, b| a < b));
        entries += partners.len();
    }
    assert_eq!(entries, 2 * got.len());
}

#[test]
fn the_search_finds_what_all_pairs_find() {
    for (periodic, smallest) in [
        ([false; 3], 0.05),
        ([true, false, true], 0.05),
        ([true; 3], 0.1),
        ([true; 3], 0.01),
        ([false; 3], 0.01),
        ([false, true, false], 0.001),
        ([true; 3], 0.001),
    ] {
        let domain = domain(DVec3::splat(1.0), periodic);
        for kinds in [1, 3] {
            check(&random_places(900, (smallest, 0.1), &domain), domain, kinds, 100);
        }
    }
}

#[test]
fn the_search_finds_all_in_flat_and_long_boxes() {
    for size in [
        DVec3::new(4.0, 0.5, 0.5),
        DVec3::new(0.5, 0.5, 4.0),
        DVec3::new(0.45, 3.0, 3.0),
        DVec3::new(0.7, 0.7, 0.7),
    ] {
        for periodic in [[true; 3], [false; 3], [true, true, false]] {
            let domain = domain(size, periodic);
            check(&random_places(600, (0.02, 0.1), &domain), domain, 1, 100);
        }
    }
}

#[test]
fn many_small_grains_around_few_large_ones_are_found_from_either_side() {
    let domain = domain(DVec3::splat(2.0), [true, false, true]);
    // the large ones ask, and then the small ones, as there are fewer of them
    for (large, small) in [(5, 3000), (400, 40)] {
        let mut places = random_places(large, (0.3, 0.3), &domain);
        places.extend(random_places(small, (0.003, 0.003), &domain));
        check(&places, domain, 1, 20);
    }
}

#[test]
fn grains_on_the_borders_of_cells_are_found() {
    // a lattice as wide as the cells: all places are on borders, up to rounding
    let radius = 0.5 * (0.125 - SKIN);
    let domain = domain(DVec3::splat(1.0), [true; 3]);
    let mut places = vec![];
    for x in 0..8 {
        for y in 0..8 {
            for z in 0..8 {
                let cell = DVec3::new(f64::from(x), f64::from(y), f64::from(z));
                places.push((domain.lower + cell * 0.125, radius * (1.0 + 1e-12)));
            }
        }
    }
    check(&places, domain, 2, 3 * 512);
}

#[test]
fn grains_that_have_left_the_box_by_a_little_are_found() {
    for periodic in [[true; 3], [true, false, false], [false; 3]] {
        let domain = domain(DVec3::splat(1.0), periodic);
        let mut places = random_places(900, (0.03, 0.1), &domain);
        for (position, _) in &mut places {
            *position *= 1.0 + SKIN;
        }
        check(&places, domain, 1, 1000);
    }
}

#[test]
fn grains_far_away_change_neither_pairs_nor_work() {
    for periodic in [[false; 3], [true, false, false]] {
        let domain = domain(DVec3::splat(1.0), periodic);
        let far = |places: &mut Vec<(DVec3, f64)>| {
            let at = DVec3::new(0.1, -3e3, 40.0);
            places.extend([
                (at, 0.05),
                (at + DVec3::Z * 0.1, 0.05),
                (DVec3::new(0.2, 0.3, 7e3), 0.05),
            ]);
        };
        let mut places = random_places(900, (0.03, 0.06), &domain);
        far(&mut places);
        check(&places, domain, 2, 1000);

        let mut places = random_places(20_000, (0.01, 0.02), &domain);
        let tests = |places: &[(DVec3, f64)]| {
            let mut found = Neighbours::default();
            found.find(&grains_at(places, 1), &[], &materials(1), &Single::new(domain), 0.005);
            found.effort().tests
        };
        let of_all = tests(&places);
        far(&mut places);
        let with_far = tests(&places);
        assert!(
            with_far < 2 * of_all,
            "{with_far} tests, {of_all} without those far away"
        );
    }
}

#[test]
fn empty_and_tiny_sets_have_no_pairs() {
    let domain = domain(DVec3::splat(1.0), [true; 3]);
    let mut found = telling();
    for places in [vec![], vec![(DVec3::ZERO, 0.1)]] {
        let grains = grains_at(&places, 1);
        found.find(&grains, &[], &materials(1), &Single::new(domain), SKIN);
        assert_eq!((found.pair_count(), found.chunks()), (0, 0));
        assert!((0..grains.len()).all(|g| found.pairs_of(g).next().is_none()));
    }
    check(&[(DVec3::ZERO, 0.1), (DVec3::ZERO, 0.1)], domain, 1, 1);
}

fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .unwrap()
        .install(work)
}

#[test]
fn threads_do_not_change_the_table() {
    let domain = domain(DVec3::splat(10.0), [true, false, true]);
    let grains = grains_at(&random_places(40_000, (0.03, 0.3), &domain), 2);
    let walls = [crate::walls::Wall::new(
        "floor",
        0,
        crate::walls::Shape::Plane {
            point: DVec3::new(0.0, -5.0, 0.0),
            normal: DVec3::Y,
        },
        crate::walls::Motion::Rest,
    )
    .unwrap()];
    let (materials, comm) = (materials(2), Single::new(domain));
    let table = |threads| {
        on_threads(threads, || {
            let (mut found, mut grains) = (telling(), grains.clone());
            put_in_order(&mut grains);
            found.find(&grains, &walls, &materials, &comm, SKIN);
            let entries: Vec<Vec<_>> = (0..grains.len()).map(|g| found.pairs_of(g).collect()).collect();
            let on_walls: Vec<Vec<_>> = (0..grains.len()).map(|g| found.wall_pairs_of(g).collect()).collect();
            assert!(found.wall_pair_count() > 100);
            (
                grains,
                found.pairs.table.segments,
                found.walls.segments,
                entries,
                on_walls,
                found.effort,
            )
        })
    };
    let expected = table(1);
    for threads in [2, 7] {
        assert!(table(threads) == expected, "{threads} threads");
    }
}

#[test]
fn walls_are_found_like_grain_by_grain() {
    use crate::walls::{Motion, Shape, Side};
    let domain = domain(DVec3::splat(2.0), [false; 3]);
    let places = random_places(3000, (0.01, 0.05), &domain);
    let grains = grains_at(&places, 3);
    let shapes = [
        Shape::Plane {
            point: DVec3::new(0.0, 0.0, -0.9),
            normal: DVec3::Z,
        },
        Shape::Cylinder {
            start: DVec3::new(0.0, 0.0, -0.3),
            end: DVec3::new(0.1, 0.0, 0.4),
            radius: 0.4,
            side: Side::Outside,
        },
        Shape::Cone {
            start: DVec3::new(0.0, 0.0, -0.5),
            end: DVec3::new(0.0, 0.0, 0.5),
            start_radius: 0.9,
            end_radius: 0.2,
            side: Side::Inside,
        },
        Shape::Rectangle {
            center: DVec3::ZERO,
            half_u: DVec3::X * 0.7,
            half_v: DVec3::Y * 0.6,
        },
    ];
    let walls: Vec<Wall> = (shapes.into_iter().enumerate())
        .map(|(k, shape)| Wall::new(&format!("w{k}"), k as u16 % 3, shape, Motion::Rest).unwrap())
        .collect();
    let materials = materials(3);
    let mut grains = grains;
    put_in_order(&mut grains);
    let mut found = telling();
    found.find(&grains, &walls, &materials, &Single::new(domain), SKIN);
    let mut met = vec![0; walls.len()];
    for g in 0..grains.len() {
        let expected: Vec<u32> = (0..walls.len() as u32)
            .filter(|&w| walls[w as usize].near(grains.position[g], grains.radius(g) + SKIN))
            .collect();
        let got: Vec<u32> = (found.wall_pairs_of(g))
            .map(|(chunk, slot)| {
                let (pairs, law) = found.wall_chunk(chunk);
                let pair = pairs[slot];
                assert_eq!(pair.grain, g as u32);
                let wall = &walls[pair.wall as usize];
                assert_eq!(law, materials.pair(grains.material[g], wall.material));
                pair.wall
            })
            .collect();
        assert_eq!(got, expected);
        expected.iter().for_each(|&w| met[w as usize] += 1);
    }
    assert!(met.iter().all(|&count| count > 20), "{met:?}");
}

#[test]
fn a_table_that_was_tampered_with_is_refused() {
    let domain = domain(DVec3::splat(1.0), [true; 3]);
    let grains = grains_at(&random_places(300, (0.05, 0.1), &domain), 2);
    let mut found = telling();
    found.find(&grains, &[], &materials(2), &Single::new(domain), SKIN);
    let read =
        |found: &Neighbours| -> Neighbours { postcard::from_bytes(&postcard::to_stdvec(found).unwrap()).unwrap() };
    let mut restored = read(&found);
    restored.tell_pairs_of_grains();
    assert!(restored.restore(&grains, 0, 2));
    assert_eq!(restored.pairs.table.segments, found.pairs.table.segments);
    assert_eq!(restored.chunks(), found.chunks());
    for g in 0..grains.len() {
        assert!(restored.pairs_of(g).eq(found.pairs_of(g)));
    }
    fn packed(i: u32, j: u32, shift: u8) -> PackedPair {
        PackedPair::new(&Pair { i, j, shift }, 0)
    }
    let tampered: [fn(&mut Neighbours); 10] = [
        |n| n.pairs.table.segments[0].candidates[3] = packed(300, 3, 0),
        |n| n.pairs.table.segments[0].candidates[3] = packed(3, 32_767, 0),
        |n| n.pairs.table.segments[0].candidates[3] = packed(3, 3, 0),
        |n| n.pairs.table.segments[0].candidates[3] = packed(200, 3, 27),
        |n| n.pairs.table.segments[0].runs[0].law = 4,
        |n| n.pairs.table.segments[0].runs[1].end = 0,
        |n| n.pairs.table.segments[0].runs.truncate(3),
        |n| n.pairs.per_segment = 0,
        |n| n.pairs.per_segment = 100,
        |n| n.former = FormerPlaces::default(),
    ];
    for tamper in tampered {
        let mut other = read(&found);
        tamper(&mut other);
        assert!(!other.restore(&grains, 0, 2));
    }
}
