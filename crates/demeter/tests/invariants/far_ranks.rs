//! Processes that share a run hear of the grains of others only where these are near their own, and the bits are those of one.

mod exchanges;

use crate::cases::ranks::on_ranks;
use crate::cases::{Case, Laws, law, on_threads, one_material, report};
use demeter::comm::{Ranks, ShearAxes};
use demeter::measure::{ForceDistribution, Moment, measure};
use demeter::particles::{Domain, Outside};
use demeter::simulation::{Deformation, Drive, Setup, Shear, Simulation};
use demeter_physics::DVec3;

/// Largest radius [m].
const RADIUS: f64 = 2e-3;

/// Distance between the middles of grains, a little more than the largest touch at [m].
const APART: f64 = 2.02 * RADIUS;

/// Grains along the short sides.
const WIDTH: u32 = 8;

/// A number from -1 to 1 that looks like chance.
fn scatter(k: u32) -> f64 {
    let mixed = k.wrapping_mul(2_654_435_761) ^ k.wrapping_mul(40_503).rotate_left(13);
    f64::from(mixed.wrapping_mul(2_246_822_519)) / f64::from(u32::MAX) * 2.0 - 1.0
}

/// A long duct full of grains of some radii, as shares of the largest, that fly about; its sides are periodic or planes.
fn duct(length: u32, periodic: [bool; 3], radii: &[f64]) -> Setup {
    let friction = law("mindlin-history", &[("friction", 0.4)]);
    let mut case = Case::new(one_material(5e6, &Laws::hertz(0.7).friction(friction)));
    for k in 0..length * WIDTH * WIDTH {
        let (x, y, z) = (k / (WIDTH * WIDTH), k / WIDTH % WIDTH, k % WIDTH);
        let place = (DVec3::new(x.into(), y.into(), z.into()) + 0.5) * APART;
        let velocity = DVec3::new(scatter(3 * k), scatter(3 * k + 1), scatter(3 * k + 2));
        let radius = RADIUS * radii[(k as usize * 7 + k as usize / 5) % radii.len()];
        case.spinning_grain(radius, place, velocity, DVec3::new(3.0, -2.0, 1.0));
    }
    let upper = DVec3::new(length.into(), WIDTH.into(), WIDTH.into()) * APART;
    let beyond = |axis: usize| if periodic[axis] { 0.0 } else { 0.5 };
    let room = DVec3::new(beyond(0), beyond(1), beyond(2));
    case.domain = Domain {
        lower: -room,
        upper: upper + room,
        periodic,
        outside: Outside::Stop,
    };
    for axis in (0..3).filter(|&axis| !periodic[axis]) {
        case.plane(0, DVec3::ZERO, DVec3::AXES[axis]);
        case.plane(0, upper, -DVec3::AXES[axis]);
    }
    // so narrow that candidates are found often
    case.skin = 0.02 * RADIUS * radii.iter().copied().fold(1.0, f64::min);
    case.max_overlap = 0.4;
    case.setup()
}

/// All that a checkpoint holds, with the distance tests of the search.
fn outcome(setup: Setup, shear: Option<Deformation>, steps: u64, ranks: Option<Box<dyn Ranks>>) -> (String, u64) {
    let mut sim = Simulation::new(setup);
    if let Some(shear) = shear {
        sim.deform(shear).unwrap();
    }
    if let Some(ranks) = ranks {
        sim.share(ranks);
    }
    for _ in 0..steps {
        sim.step().unwrap();
    }
    sim.make_whole();
    (format!("{:?} {:?}", sim.state(), sim.grains()), sim.rebuilds())
}

/// Compares all bits, as every `f64` is written with all its digits; shows the first place that differs.
fn compare_text(what: &str, saved: &str, alone: &str) {
    let differs = saved.bytes().zip(alone.bytes()).position(|(a, b)| a != b);
    if let Some(at) = differs {
        let shown = |text: &str| text[at.saturating_sub(200)..(at + 80).min(text.len())].to_string();
        panic!("{what}:\n{}\n{}", shown(saved), shown(alone));
    }
    assert_eq!(saved.len(), alone.len(), "{what}");
}

fn compare(what: &str, setup: impl Fn() -> Setup + Sync, shear: Option<Deformation>, counts: &[usize]) {
    let steps = 150;
    let (alone, rebuilds) = on_threads(2, || outcome(setup(), shear, steps, None));
    assert!(rebuilds > 4, "{what}: {rebuilds} rebuilds are few");
    for &count in counts {
        let shared = on_ranks(count, |rank| {
            on_threads(1, || outcome(setup(), shear, steps, Some(rank)))
        });
        for (rank, (saved, _)) in shared.into_iter().enumerate() {
            compare_text(&format!("{what}, rank {rank} of {count}"), &saved, &alone);
        }
    }
}

#[test]
fn far_processes_of_a_long_duct_have_the_same_bits() {
    compare("duct", || duct(128, [false; 3], &[1.0, 0.9]), None, &[4, 8]);
}

#[test]
fn processes_that_meet_across_periodic_sides_have_the_same_bits() {
    compare("ring", || duct(128, [true; 3], &[1.0, 0.9]), None, &[2, 8]);
}

#[test]
fn small_grains_among_large_ones_have_the_same_bits() {
    let radii = [1.0, 0.1, 0.4, 0.06, 0.2, 0.1, 0.7, 0.3];
    compare("sizes", || duct(96, [true, false, false], &radii), None, &[3, 8]);
}

#[test]
fn processes_that_meet_across_sliding_sides_have_the_same_bits() {
    let axes = ShearAxes { flow: 0, gradient: 1 };
    let shear = Deformation {
        shear: Some(Shear {
            axes,
            drive: Drive::StrainRate(200.0),
        }),
        ..Deformation::default()
    };
    compare("shear", || duct(64, [true; 3], &[1.0, 0.5]), Some(shear), &[2, 4, 8]);
}

/// Bytes that each rank tells all others, and those that it tells some, when candidates are found.
fn told(length: u32, ranks: usize) -> Vec<[u64; 2]> {
    on_ranks(ranks, |rank| {
        on_threads(1, || {
            let mut sim = Simulation::new(duct(length, [false; 3], &[1.0, 0.9]));
            sim.share(rank);
            (0..2).for_each(|_| sim.step().unwrap());
            let before = sim.sharing().unwrap();
            sim.find_candidates();
            let after = sim.sharing().unwrap();
            assert_eq!(before.divided, after.divided);
            [
                after.traffic.round_bytes - before.traffic.round_bytes,
                after.traffic.bytes - before.traffic.bytes,
            ]
        })
    })
}

#[test]
fn what_a_process_hears_of_places_does_not_grow_with_the_run() {
    let (short, long) = (told(128, 4), told(256, 8));
    let most = |of: &[[u64; 2]], what: usize| of.iter().map(|told| told[what]).max().unwrap();
    let own_grains = f64::from(128 * WIDTH * WIDTH / 4);
    for told in [&short, &long] {
        // a place of each grain would be 24 bytes; a box of each segment of 512 is 24
        let to_all = most(told, 0) as f64 / own_grains;
        assert!(to_all < 0.3, "{to_all} bytes of each grain are told to all");
        let to_some = most(told, 1) as f64 / own_grains;
        report("bytes told to all, per own grain", to_all);
        report("bytes told to some, per own grain", to_some);
        assert!(
            (0.5..24.0).contains(&to_some),
            "{to_some} bytes of each grain are told to some"
        );
    }
    let growth = most(&long, 1) as f64 / most(&short, 1) as f64;
    assert!(
        growth < 1.3,
        "twice the grains on twice the processes: {growth} times the bytes of each"
    );
}

#[test]
fn a_step_joins_what_all_know_along_a_tree() {
    let joined = |ranks: usize| {
        let told = on_ranks(ranks, |rank| {
            on_threads(1, || {
                let mut sim = Simulation::new(duct(128, [false; 3], &[1.0, 0.9]));
                sim.share(rank);
                sim.step().unwrap();
                let steps = (0..10).filter_map(|_| {
                    let (before, rebuilds) = (sim.sharing().unwrap().traffic, sim.rebuilds());
                    sim.step().unwrap();
                    let after = sim.sharing().unwrap().traffic;
                    (sim.rebuilds() == rebuilds).then(|| {
                        // motion, work of the contacts, and the end of the step, which waits for the next in a run
                        assert_eq!(after.rounds - before.rounds, 3);
                        assert_eq!(
                            after.round_bytes, before.round_bytes,
                            "something is told to all at once"
                        );
                        after.joined_bytes - before.joined_bytes
                    })
                });
                steps.max().unwrap()
            })
        });
        told.into_iter().max().unwrap()
    };
    let [four, sixteen] = [4, 16].map(joined);
    report("bytes that a process joins in a step, of 4 and of 16", four as f64);
    report("", sixteen as f64);
    assert!(
        sixteen < 3 * four,
        "{four} bytes per step of 4 processes, {sixteen} of 16"
    );
}

/// What a rank tells while it does something: bytes to all and to the first, messages to neighbours.
fn told_by(sim: &mut Simulation, work: impl FnOnce(&mut Simulation)) -> [u64; 3] {
    let traffic = |sim: &Simulation| sim.sharing().unwrap().traffic;
    let before = traffic(sim);
    work(sim);
    let after = traffic(sim);
    [
        (after.round_bytes + after.joined_bytes) - (before.round_bytes + before.joined_bytes),
        after.gathered_bytes - before.gathered_bytes,
        after.messages - before.messages,
    ]
}

#[test]
fn rows_tell_sums_and_measures_of_contacts_are_told_to_the_first_process_alone() {
    let told = on_ranks(4, |rank| {
        on_threads(1, || {
            let mut sim = Simulation::new(duct(128, [false; 3], &[1.0, 0.9]));
            sim.share(rank);
            (0..40).for_each(|_| sim.step().unwrap());
            let row = told_by(&mut sim, |sim| drop(measure(sim, Moment::default(), None)));
            let bins = ForceDistribution::new(0.0, 1.0, 0.1).unwrap();
            let mut all = 0;
            let forces = told_by(&mut sim, |sim| {
                all = bins.measure(sim).iter().map(|of| of.contacts).sum()
            });
            (row, forces, all)
        })
    });
    let own_grains = u64::from(128 * WIDTH * WIDTH / 4);
    let to_first: u64 = told.iter().map(|(_, forces, _)| forces[1]).sum();
    let per_contact = to_first as f64 / told[0].2 as f64;
    report("bytes told to the first process, per contact", per_contact);
    // a force is 8 bytes, and the first process is not told those of its own
    assert!((1.0..9.0).contains(&per_contact), "{per_contact}");
    for (rank, (row, forces, contacts)) in told.into_iter().enumerate() {
        report("bytes of a row that a process tells all", row[0] as f64);
        assert!(row[0] > 0 && row[0] < own_grains, "a row told {} bytes to all", row[0]);
        assert_eq!(row[1], 0, "a row told the first process of grains");
        assert!(
            row[2] <= 2,
            "a row told neighbours more than once how grains near the borders move"
        );
        assert_eq!(forces[2], 0, "neighbours were told of forces");
        assert_eq!(forces[0], 0, "forces were told to all");
        assert_eq!(forces[1] == 0, rank == 0, "rank {rank}: {forces:?}");
        assert_eq!(contacts == 0, rank > 0, "rank {rank} has {contacts} contacts");
    }
}
