//! Grains that come, go, are put in order again and get other processes.

use super::{APART, RADIUS, WIDTH, compare_text, duct};
use crate::cases::ranks::on_ranks;
use crate::cases::{Laws, law, on_threads, one_material, report};
use demeter::comm::{Ranks, Traffic};
use demeter::contacts::Coupling;
use demeter::particles::{NewGrain, Outside};
use demeter::simulation::{Setup, Simulation, Skin};
use demeter_physics::DVec3;
use demeter_physics::integrator::Integrator;

/// Layers of grains along the duct.
const LENGTH: u32 = 128;

/// Steps between two exchanges.
const EVERY: u64 = 12;

/// Grains that come at once.
const COMING: u32 = 60;

/// Gaps between those that come all over the duct, whose neighbours lie far from them in memory.
const ALL_OVER: u32 = 13;

/// Grains that leave at an exchange, as rising indices: many of one stretch of the duct, so that its process has less to do than others,
/// and some here and there.
fn leaving(sim: &Simulation, round: u32) -> Vec<usize> {
    let stretch = (0..120).map(|k| LENGTH * WIDTH * WIDTH / 3 + 120 * round + k);
    let others = (0..7).map(|k| 1171 * k + 5 * round + 3);
    let ids: Vec<u32> = stretch.chain(others).collect();
    sim.grains_where(|grain| ids.contains(&sim.grains().id[grain]))
}

/// Grains that come in the middle between eight others, so many gaps behind each other.
fn coming(round: u32, apart: u32) -> Vec<NewGrain> {
    let gaps = WIDTH - 1;
    let grain = |k: u32| {
        let gap = (round * COMING + k) * apart % ((LENGTH - 1) * gaps * gaps);
        let place = [gap / (gaps * gaps), gap / gaps % gaps, gap % gaps].map(|n| f64::from(n) + 1.0);
        NewGrain {
            material: 0,
            radius: 0.6 * RADIUS,
            density: 2500.0,
            position: DVec3::from_array(place) * APART,
            velocity: DVec3::new(0.2, 0.1, -0.3),
            angular_velocity: DVec3::X,
            fixed: false,
        }
    };
    (0..COMING).map(grain).collect()
}

fn go_on(sim: &mut Simulation, rounds: std::ops::Range<u32>) {
    for round in rounds {
        let leaves = leaving(sim, round);
        assert!(!leaves.is_empty());
        // grains only come, only go, or both
        match round % 4 {
            1 => sim.exchange(&[], &coming(round, ALL_OVER)).unwrap(),
            2 => sim.exchange(&leaves, &[]).unwrap(),
            _ => sim.exchange(&leaves, &coming(round, ALL_OVER)).unwrap(),
        };
        for _ in 0..EVERY {
            sim.step().unwrap();
        }
    }
}

fn begin(setup: Setup, ranks: Option<Box<dyn Ranks>>) -> Simulation {
    let mut sim = Simulation::new(setup);
    if let Some(ranks) = ranks {
        sim.share(ranks);
    }
    (0..3).for_each(|_| sim.step().unwrap());
    sim
}

/// All that a checkpoint holds, as a text and as bytes.
fn saved(sim: &mut Simulation) -> (String, Vec<u8>) {
    sim.make_whole();
    let energies = sim.energies();
    let state = sim.state();
    (format!("{state:?} {energies:?}"), postcard::to_stdvec(&state).unwrap())
}

fn restored(setup: Setup, saved: &[u8]) -> Simulation {
    Simulation::resume(setup, postcard::from_bytes(saved).unwrap()).unwrap()
}

/// Whether grains that came lie before others that were there at the start, so many layers.
fn were_sorted(sim: &Simulation, length: u32) -> bool {
    let came = |id: u32| id > length * WIDTH * WIDTH;
    sim.grains().id.windows(2).any(|ids| came(ids[0]) && !came(ids[1]))
}

/// A duct at one end of which grains fly out of the domain, and are removed in the middle of a step.
fn leaky() -> Setup {
    let mut setup = setup([false; 3], Integrator::VelocityVerlet);
    setup.domain.lower.x = 0.5 * APART - 0.01 * RADIUS;
    setup.domain.outside = Outside::Remove;
    setup
}

/// Contacts that feel each other.
fn coupled() -> Setup {
    let friction = law("mindlin-history", &[("friction", 0.4)]);
    let laws = Laws::hertz(0.7).friction(friction).multi_contact("half-space", &[]);
    Setup {
        materials: one_material(5e6, &laws),
        coupling: Coupling::Lagged,
        ..setup([false; 3], Integrator::VelocityVerlet)
    }
}

fn setup(periodic: [bool; 3], integrator: Integrator) -> Setup {
    Setup {
        integrator,
        skin: Skin::Fixed(0.2 * RADIUS),
        ..duct(LENGTH, periodic, &[1.0, 0.9])
    }
}

/// Runs with grains that come and go, the second half after a restart with other numbers of processes.
fn compare(what: &str, setup: impl Fn() -> Setup + Sync, counts: &[usize]) {
    let rounds = [0..6, 6..11];
    let (halfway, alone) = on_threads(2, || {
        let mut sim = begin(setup(), None);
        go_on(&mut sim, rounds[0].clone());
        let (halfway, state) = saved(&mut sim);
        let mut sim = restored(setup(), &state);
        go_on(&mut sim, rounds[1].clone());
        assert!(
            were_sorted(&sim, LENGTH),
            "{what}: grains were never put in order again"
        );
        (halfway, saved(&mut sim).0)
    });
    for (k, &count) in counts.iter().enumerate() {
        let first = on_ranks(count, |rank| {
            on_threads(1, || {
                let mut sim = begin(setup(), Some(rank));
                go_on(&mut sim, rounds[0].clone());
                let divided = sim.sharing().unwrap().divided;
                assert!(divided > 1, "{what}: divided {divided} times");
                saved(&mut sim)
            })
        });
        for (rank, (text, _)) in first.iter().enumerate() {
            compare_text(&format!("{what}, rank {rank} of {count}, halfway"), text, &halfway);
        }
        let state = &first[0].1;
        let other = counts[(k + 1) % counts.len()];
        let second = on_ranks(other, |rank| {
            on_threads(1, || {
                let mut sim = restored(setup(), state);
                sim.share(rank);
                go_on(&mut sim, rounds[1].clone());
                saved(&mut sim).0
            })
        });
        for (rank, text) in second.iter().enumerate() {
            compare_text(&format!("{what}, rank {rank} of {other} after {count}"), text, &alone);
        }
    }
}

#[test]
fn grains_that_come_and_go_have_the_same_bits() {
    compare("duct", || setup([false; 3], Integrator::VelocityVerlet), &[2, 3, 8]);
}

#[test]
fn grains_that_come_and_go_have_the_same_bits_in_a_ring_with_gear() {
    compare("ring", || setup([true, false, true], Integrator::Gear), &[4, 2]);
}

#[test]
fn grains_that_are_lost_have_the_same_bits() {
    let mut sim = begin(leaky(), None);
    let told = leaving(&sim, 0).len() as u64;
    go_on(&mut sim, 0..1);
    let removed = sim.books.removed_grains;
    assert!(removed > told, "{removed} grains were removed, {told} of them as told");
    compare("leak", leaky, &[3, 4]);
}

#[test]
fn grains_that_come_and_go_have_the_same_bits_where_contacts_feel_each_other() {
    compare("coupled", coupled, &[3, 2]);
}

/// Bytes that a rank tells while it does something.
fn told_by<T>(sim: &mut Simulation, work: impl FnOnce(&mut Simulation) -> T) -> f64 {
    let bytes = |traffic: Traffic| traffic.bytes + traffic.round_bytes + traffic.joined_bytes + traffic.gathered_bytes;
    let traffic = |sim: &Simulation| bytes(sim.sharing().unwrap().traffic);
    let before = traffic(sim);
    work(sim);
    (traffic(sim) - before) as f64
}

#[test]
fn an_exchange_does_not_tell_the_whole() {
    for count in [2, 3, 4, 8] {
        let told = on_ranks(count, |rank| {
            on_threads(1, || {
                let mut sim = begin(setup([false; 3], Integrator::VelocityVerlet), Some(rank));
                let candidates = told_by(&mut sim, Simulation::find_candidates);
                let leaves = leaving(&sim, 0);
                let goes = told_by(&mut sim, |sim| sim.exchange(&leaves, &[]).unwrap());
                let comes = told_by(&mut sim, |sim| sim.exchange(&[], &coming(0, 1)).unwrap());
                let whole = told_by(&mut sim, Simulation::make_whole);
                [candidates, goes, comes, whole]
            })
        });
        let own_grains = f64::from(LENGTH * WIDTH * WIDTH) / count as f64;
        let most = |what: usize| told.iter().map(|told| told[what]).fold(0.0, f64::max) / own_grains;
        let [candidates, goes, comes, whole] = [0, 1, 2, 3].map(most);
        for (what, bytes) in [
            ("candidates", candidates),
            ("grains go", goes),
            ("grains come", comes),
            ("whole", whole),
        ] {
            report(
                &format!("{count} processes, {what}: most bytes told, per own grain"),
                bytes,
            );
        }
        // places of some segments, and the grains and contacts of up to half a segment at each cut
        let most = 48.0 + 2.0 * 256.0 * 400.0 / own_grains;
        assert!(goes < most && comes < most && whole > 200.0, "{count} processes");
    }
}

/// Bytes per own grain that a rank tells all, and that it tells some, when grains that came all over the duct are put in order with the
/// others.
fn told_of_an_order(length: u32, count: usize) -> [f64; 2] {
    let told = on_ranks(count, |rank| {
        on_threads(1, || {
            let setup = Setup {
                skin: Skin::Fixed(0.2 * RADIUS),
                ..duct(length, [false; 3], &[1.0, 0.9])
            };
            let mut sim = begin(setup, Some(rank));
            for round in 0..40 {
                let before = sim.sharing().unwrap().traffic;
                sim.exchange(&[], &coming(round, ALL_OVER)).unwrap();
                let after = sim.sharing().unwrap().traffic;
                sim.make_whole();
                if were_sorted(&sim, length) {
                    return [after.round_bytes - before.round_bytes, after.bytes - before.bytes];
                }
                sim.step().unwrap();
            }
            panic!("grains were never put in order again")
        })
    });
    let own_grains = f64::from(length * WIDTH * WIDTH) / count as f64;
    [0, 1].map(|what| told.iter().map(|told| told[what]).max().unwrap() as f64 / own_grains)
}

#[test]
fn what_a_process_hears_of_the_order_does_not_grow_with_the_run() {
    for (length, count) in [(LENGTH, 4), (2 * LENGTH, 8)] {
        let [to_all, to_some] = told_of_an_order(length, count);
        report(
            &format!("an order of {count} processes: bytes told to all, per own grain"),
            to_all,
        );
        report("and to some", to_some);
        // the place and the id of each grain would be 8 bytes
        assert!(to_all < 2.0, "{to_all} bytes of each grain are told to all");
    }
}
