use super::*;
use crate::contacts::CarriedContact;
use crate::materials::{Material, PairChoice};
use crate::neighbours::NewPlaces;
use crate::particles::{MOST_CROSSINGS, NewGrain, Outside};
use crate::walls::{Motion, Shape};
use demeter_physics::contact::LawChoice;
use demeter_physics::parameters::Value;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Grains per edge of the lattice.
const EDGE: u32 = 12;

fn law(law: &str, parameter: &str) -> LawChoice {
    LawChoice {
        law: law.into(),
        parameters: [(parameter.to_string(), Value::Number(0.5))].into_iter().collect(),
    }
}

fn two_materials() -> Materials {
    let list = ["a", "b"].map(|name| Material {
        name: name.into(),
        young_modulus: 1e6,
        poisson_ratio: 0.3,
        density: 2500.0,
    });
    let choice = PairChoice {
        normal: law("hertz-tsuji", "restitution"),
        tangential: Some(law("mindlin-history", "friction")),
        rolling: None,
        multi_contact: None,
    };
    Materials::new(list.into(), |_, _| choice.clone()).unwrap()
}

/// Grains of two materials on a lattice of spacing 1, shaken from their places and between a floor and a lid; with this
/// mean radius and speed. Ids and places in memory are scattered.
fn lattice(radius: f64, speed: f64, skin: Skin) -> Setup {
    let mut state = 7u64;
    let mut uniform = move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let edge = f64::from(EDGE);
    let mut grains = Grains::default();
    for k in 0..EDGE.pow(3) {
        // 1001 has no divisor in common with the number of grains
        let site = (k * 1001) % EDGE.pow(3);
        let cell = [site % EDGE, site / EDGE % EDGE, site / EDGE.pow(2)].map(f64::from);
        let mut random = || DVec3::new(uniform(), uniform(), uniform());
        let position = DVec3::from_array(cell) + 0.5 + 0.05 * random();
        let grain = NewGrain {
            material: (k % 2) as u16,
            radius: radius * (1.0 + 0.05 * random().x),
            density: 2500.0,
            position,
            velocity: speed * random(),
            angular_velocity: DVec3::ZERO,
            fixed: false,
        };
        grains.push(1 + (k * 5) % EDGE.pow(3), &grain);
    }
    let plane = |name: &str, z: f64, normal: DVec3| {
        let point = DVec3::Z * z;
        Wall::new(name, 0, Shape::Plane { point, normal }, Motion::Rest).unwrap()
    };
    let materials = two_materials();
    let walls = vec![plane("floor", 0.0, DVec3::Z), plane("lid", edge, DVec3::NEG_Z)];
    let partners: Vec<WallPartner> = walls.iter().map(WallPartner::of).collect();
    let scale = shortest_time_scale(&grains, &partners, &materials, 0.5).unwrap();
    Setup {
        walls,
        materials,
        domain: Domain {
            lower: DVec3::ZERO,
            upper: DVec3::splat(edge),
            periodic: [true, true, false],
            outside: Outside::Stop,
        },
        gravity: DVec3::ZERO,
        integrator: Integrator::default(),
        coupling: Coupling::default(),
        dt: SAFE_SHARE * scale.time,
        skin,
        max_overlap: 0.5,
        grains,
    }
}

/// A run with many contacts that remember something.
fn squeezed() -> Simulation {
    let mut sim = Simulation::new(lattice(0.51, 1.0, Skin::Fixed(0.05)));
    for _ in 0..20 {
        sim.step().unwrap();
    }
    assert!(sim.contacts.pair_count() > 2000 && sim.contacts.wall_count() > 50);
    sim
}

/// All engaged contacts: pairs that are merely near come and go with the candidates.
fn carried(sim: &Simulation) -> Vec<CarriedContact> {
    let all = sim.contacts.carry(&sim.grains);
    all.into_iter().filter(|c| c.is_engaged).collect()
}

#[test]
fn a_rebuild_hands_all_contacts_over() {
    let mut sim = squeezed();
    let expected = carried(&sim);
    assert!(expected.iter().any(|c| c.history.iter().any(|&h| h != 0.0)));
    for skin in [0.05, 2.0, 1.0] {
        sim.skin *= skin;
        sim.find_candidates();
        assert!(carried(&sim) == expected, "skin times {skin}");
    }
}

#[test]
fn contacts_follow_grains_into_another_order() {
    let mut sim = squeezed();
    let expected = carried(&sim);
    for stride in [7, 1001] {
        // neither has a divisor in common with the number of grains
        let n = sim.grains.len() as u32;
        let mut places = NewPlaces::unknown(sim.grains.len());
        (0..n).for_each(|k| places.note((k * stride + 3) % n, k));
        let moves = Moves::Reordered(places);
        moves.apply(&mut sim.grains);
        sim.continue_with_candidates(Places::New(moves));
        assert!(carried(&sim) == expected);
    }
    // as scattered as they are now, the grains are put in order again
    let scattered = sim.neighbours.scattered();
    sim.find_candidates();
    assert!(sim.neighbours.scattered() < 0.8 * scattered);
    assert!(carried(&sim) == expected);
    sim.step().unwrap();
}

#[test]
fn contacts_of_removed_grains_end_and_all_others_go_on() {
    let mut sim = squeezed();
    let before = carried(&sim);
    let gone: Vec<usize> = (0..sim.grains.len()).step_by(5).collect();
    let ids: Vec<u32> = gone.iter().map(|&g| sim.grains.id[g]).collect();
    sim.remove(&gone);
    let stays = |c: &&CarriedContact| !ids.contains(&c.key.grain) && (c.key.wall || !ids.contains(&c.key.partner));
    let expected: Vec<_> = before.iter().filter(stays).cloned().collect();
    assert!(expected.len() < before.len());
    assert!(carried(&sim) == expected);
    sim.step().unwrap();
}

#[test]
fn a_packing_at_rest_comes_to_a_narrow_skin() {
    let first = 0.2;
    let mut sim = Simulation::new(lattice(0.46, 0.0, Skin::Tuned(first)));
    for _ in 0..2000 {
        sim.step().unwrap();
    }
    assert!(sim.skin() < 0.2 * first, "{} of {first}", sim.skin());
    assert!(sim.rebuilds() < 10);
}

/// Pairs of grains that overlap, by all distances, as indices.
fn overlapping(sim: &Simulation) -> Vec<(u32, u32)> {
    let (grains, count) = (&sim.grains, sim.grains.len() as u32);
    let all = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
    let touch = |&(a, b): &(u32, u32)| {
        let (a, b) = (a as usize, b as usize);
        let apart = grains.position[a] - grains.position[b];
        let apart = apart + sim.comm.shift(sim.comm.nearest_image(apart));
        apart.length() < grains.radius(a) + grains.radius(b)
    };
    all.filter(touch).collect()
}

#[test]
fn every_contact_that_begins_is_told_with_any_skin() {
    let told = [0.02, 0.1, 0.3, 1.0].map(|skin| {
        let mut sim = Simulation::new(lattice(0.49, 0.5, Skin::Fixed(skin)));
        sim.watch_impacts();
        let engaged = |sim: &Simulation| {
            let contacts = sim.contacts.carry(&sim.grains).into_iter();
            let keys = contacts.filter(|contact| contact.is_engaged).map(|contact| contact.key);
            keys.collect::<std::collections::BTreeSet<_>>()
        };
        // contacts of the first moment do not count
        sim.step().unwrap();
        let mut before = engaged(&sim);
        sim.take_impacts();
        let mut begun = 0;
        for _ in 0..250 {
            sim.step().unwrap();
            let now = engaged(&sim);
            begun += now.difference(&before).count();
            before = now;
        }
        let told = sim.take_impacts();
        assert_eq!(told.len(), begun, "skin {skin}");
        told
    });
    let [first, others @ ..] = &told;
    let at_walls = first.iter().filter(|impact| impact.with_wall).count();
    assert!(
        first.len() > 200 && at_walls > 10,
        "{} contacts began, {at_walls} at walls",
        first.len()
    );
    for other in others {
        assert_eq!(first, other);
    }
}

#[test]
fn grains_that_overlap_are_always_engaged() {
    let (mut begun, mut ended, mut kept) = (0, 0, 0);
    for (radius, speed) in [(0.45, 0.5), (0.49, 0.02), (0.46, 2.0)] {
        let mut sim = Simulation::new(lattice(radius, speed, Skin::Tuned(0.05)));
        let mut before: Vec<(u32, u32)> = Vec::new();
        let mut table = 0;
        for step in 0..250 {
            sim.step().unwrap();
            let size: usize = sim.contacts.pairs.iter().map(ContactChunk::len).sum();
            kept += usize::from(size == table);
            table = size;
            // all distances take long
            if step % 4 != 0 {
                continue;
            }
            let chunks = sim.contacts.pairs.iter();
            let engaged = chunks.flat_map(|chunk| {
                let engaged = (0..chunk.len()).filter(|&k| chunk.is_engaged(k));
                engaged.map(|k| (chunk.i[k].min(chunk.j[k]), chunk.i[k].max(chunk.j[k])))
            });
            let engaged: std::collections::BTreeSet<(u32, u32)> = engaged.collect();
            assert_eq!(engaged.len(), sim.contacts.pair_count());
            let now = overlapping(&sim);
            for pair in &now {
                assert!(engaged.contains(pair), "{pair:?} in step {step} at speed {speed}");
            }
            begun += now.iter().filter(|pair| !before.contains(pair)).count();
            ended += before.iter().filter(|pair| !now.contains(pair)).count();
            before = now;
        }
    }
    assert!(begun > 500 && ended > 100, "{begun} contacts began, {ended} ended");
    assert!(kept > 300, "the table was kept in {kept} steps only");
}

#[test]
fn fixed_grains_are_no_candidates_of_each_other_or_of_walls() {
    let mut setup = lattice(0.51, 0.0, Skin::Fixed(0.05));
    for g in 0..setup.grains.len() {
        setup.grains.velocity.set_scalar(g, 0.0);
        setup.grains.angular_velocity.set_scalar(g, 0.0);
    }
    let mut sim = Simulation::new(setup);
    sim.start().unwrap();
    let places: Vec<DVec3> = sim.grains.position.iter().copied().collect();
    sim.step().unwrap();
    assert_eq!((sim.candidates(), sim.contacts.pair_count()), (0, 0));
    assert_eq!(sim.contacts.wall_count(), 0);
    assert!(sim.grains.position.iter().eq(&places));
}

#[test]
fn parts_of_several_threads_change_no_bit() {
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut sim = Simulation::new(lattice(0.5, 0.1, Skin::Tuned(0.05)));
            for _ in 0..60 {
                sim.step().unwrap();
            }
            (sim.grains, sim.books)
        })
    };
    let (grains, books) = run(1);
    for threads in [2, 5] {
        let (found, found_books) = run(threads);
        assert!(found == grains, "{threads} threads");
        assert_eq!(format!("{found_books:?}"), format!("{books:?}"));
    }
}

/// Notes whether it is asked within the pool.
struct Where(Arc<AtomicBool>);

impl CustomForce for Where {
    fn loads(&mut self, _: &ForceMoment, _: &mut GrainLoads) -> Result<(), String> {
        let is_within = rayon::current_thread_index().is_some();
        self.0.store(is_within, Ordering::Relaxed);
        Ok(())
    }
}

#[test]
fn a_step_for_many_threads_is_handed_over_to_the_pool_as_a_whole() {
    let is_within = Arc::new(AtomicBool::new(false));
    let mut sim = Simulation::new(lattice(0.5, 0.1, Skin::Tuned(0.05)));
    sim.add_force(Box::new(Where(Arc::clone(&is_within))));
    sim.step().unwrap();
    assert_eq!(is_within.load(Ordering::Relaxed), rayon::current_num_threads() > 1);
}

#[test]
fn a_grain_that_crosses_the_box_too_often_ends_the_run() {
    let mut setup = lattice(0.2, 0.0, Skin::Fixed(0.1));
    setup.grains.reorder(&[0]);
    let id = setup.grains.id[0];
    setup.grains.velocity[0] = 0.02 * DVec3::X / setup.dt;
    assert!(setup.grains.load.rows_mut()[0].set_crossings([MOST_CROSSINGS - 1, 3, -2]));
    let (edge, periodic) = (f64::from(EDGE), setup.domain.periodic);
    assert!(periodic[0]);
    let mut sim = Simulation::new(setup);
    let (mut most, mut farthest) = ([0; 3], 0.0f64);
    for _ in 0..3000 {
        match sim.step() {
            Ok(()) => {
                (most, farthest) = (sim.grains.crossings(0), farthest.max(sim.unwrapped(0).x));
            }
            Err(fault) => {
                assert!(
                    matches!(fault, Fault::CrossedTooOften { id: found, .. } if found == id),
                    "{fault}"
                );
                // it was counted as often as that is possible, and no longer
                assert_eq!(most, [MOST_CROSSINGS, 3, -2]);
                assert!((farthest / edge - f64::from(MOST_CROSSINGS) - 1.0).abs() < 0.1);
                assert!(fault.to_string().contains("more than 131071 times"), "{fault}");
                return;
            }
        }
    }
    panic!("it went on to {farthest}");
}

#[test]
fn an_exchange_that_is_impossible_changes_nothing() {
    let mut sim = squeezed();
    let grains = sim.grains.len();
    let grain = NewGrain {
        material: 0,
        radius: 0.1,
        density: 1000.0,
        position: DVec3::splat(0.5),
        velocity: DVec3::ZERO,
        angular_velocity: DVec3::ZERO,
        fixed: false,
    };
    let leave = |index| ExchangeError::Leave { index, grains };
    for (indices, index) in [(vec![5, 2], 2), (vec![5, 5], 5), (vec![3, grains], grains)] {
        assert_eq!(sim.exchange(&indices, &[]), Err(leave(index)));
    }
    let come = [
        (NewGrain { material: 9, ..grain }, "a material"),
        (NewGrain { radius: 0.0, ..grain }, "a radius"),
        (
            NewGrain {
                velocity: DVec3::Y * f64::INFINITY,
                ..grain
            },
            "a velocity",
        ),
    ];
    for (wrong, expected) in come {
        let found = sim.exchange(&[], &[grain, wrong]);
        assert!(
            matches!(found, Err(ExchangeError::Come { index: 1, what, .. }) if what == expected),
            "{found:?}"
        );
    }
    assert_eq!(sim.grains.len(), grains);
}

#[test]
fn grains_that_come_where_something_is_are_refused() {
    let mut sim = squeezed();
    let grains = sim.grains.len();
    let edge = f64::from(EDGE);
    let small = |position: DVec3| NewGrain {
        material: 0,
        radius: 0.01,
        density: 1000.0,
        position,
        velocity: DVec3::ZERO,
        angular_velocity: DVec3::ZERO,
        fixed: false,
    };
    // a corner of four cells, between all grains
    let free = small(DVec3::splat(4.0));
    let (place, id) = (sim.grains.position[7], sim.grains.id[7]);
    let beside = small(free.position + DVec3::X * 0.015);
    let beyond_side = small(place + DVec3::X * if place.x > 0.5 * edge { -edge } else { edge });
    let cases = [
        (small(place), format!("grain {id},")),
        (beyond_side, format!("grain {id},")),
        (beside, "grain 0 of them, by 0.500".to_string()),
        (small(DVec3::new(4.0, 4.0, 0.005)), "wall floor, by 0.500".to_string()),
        (
            small(DVec3::new(4.0, 4.0, edge + 0.1)),
            "outside of the domain".to_string(),
        ),
    ];
    for (wrong, expected) in cases {
        let told = sim.exchange(&[], &[free, wrong]).unwrap_err().to_string();
        assert!(
            told.starts_with("grain 1 of those") && told.contains(&expected),
            "{told}"
        );
        assert_eq!(sim.grains.len(), grains);
    }
    // what leaves makes room, and fixed grains feel no wall
    let on_the_floor = NewGrain {
        fixed: true,
        ..small(DVec3::new(4.0, 4.0, 0.005))
    };
    sim.exchange(&[7], &[free, small(place), on_the_floor]).unwrap();
    sim.steps(20).unwrap();
    let residual = sim.energies().residual;
    assert!(residual.abs() < 1e-3, "{residual}");
}

/// What is there when the books are opened came from nowhere.
#[test]
fn grains_that_come_and_go_before_the_start_are_not_booked_twice() {
    let mut sim = Simulation::new(lattice(0.51, 1.0, Skin::Fixed(0.05)));
    sim.exchange(&[0, 7], &[]).unwrap();
    sim.steps(20).unwrap();
    let residual = sim.energies().residual;
    assert!(residual.abs() < 1e-3, "{residual}");
}

#[test]
fn a_gravity_that_cannot_be_is_refused() {
    let mut sim = squeezed();
    for value in [DVec3::NAN, DVec3::X * f64::INFINITY] {
        let told = sim.set_gravity(value).unwrap_err().to_string();
        assert!(told.contains("must be finite"), "{told}");
        assert_eq!(sim.gravity, DVec3::ZERO);
    }
    let mut setup = lattice(0.45, 1.0, Skin::Fixed(0.05));
    setup.walls.clear();
    setup.domain.periodic = [true; 3];
    let mut sim = Simulation::new(setup);
    let directions = [Drive::StrainRate(-0.01); 3];
    let plan = Deformation {
        directions,
        ..Deformation::default()
    };
    sim.deform(plan).unwrap();
    let told = sim.set_gravity(DVec3::Z).unwrap_err().to_string();
    assert!(told.contains("as the periodic box deforms"), "{told}");
    sim.set_gravity(DVec3::ZERO).unwrap();
}

#[test]
fn a_wall_moves_with_no_wall_that_moves_with_another() {
    let mut sim = Simulation::new(lattice(0.45, 1.0, Skin::Fixed(0.05)));
    let mut told = |wall, leader| match sim.set_wall_motion(wall, Motion::With(leader).into()) {
        Ok(()) => String::new(),
        Err(error) => error.to_string(),
    };
    assert!(told(0, 9).contains("there is no wall 9: 2 walls"), "{}", told(0, 9));
    assert!(told(0, 0).contains("wall `floor` moves with itself"), "{}", told(0, 0));
    assert_eq!(told(0, 1), "");
    let back = told(1, 0);
    assert!(
        back.contains("`lid` moves with `floor`, which itself moves with another wall; let all"),
        "{back}"
    );
}

#[test]
fn places_round_the_box_more_often_than_is_counted_change_nothing() {
    let mut sim = squeezed();
    let now: Vec<DVec3> = sim.grains.position.iter().copied().collect();
    for x in [1e30, -1e30] {
        let mut places = now.clone();
        places[3].x = x;
        let found = sim.set_positions(&places);
        assert!(
            matches!(found, Err(ChangeError::Fault(Fault::CrossedTooOften { .. }))),
            "{found:?}"
        );
        assert!(sim.grains.position.iter().eq(&now));
    }
    sim.steps(5).unwrap();
}

#[test]
fn another_gravity_is_booked() {
    let mut sim = squeezed();
    sim.set_gravity(DVec3::new(30.0, 0.0, -50.0)).unwrap();
    sim.steps(50).unwrap();
    let energies = sim.energies();
    assert!(energies.custom_work.abs() > energies.kinetic, "{energies:?}");
    assert!(energies.residual.abs() < 1e-3, "{}", energies.residual);
}
