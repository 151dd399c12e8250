//! A run continued from any of its states gives the bits of the uninterrupted run.

use crate::cases::beds::{BEDS, bed_with, steps_for};
use crate::cases::{full, on_threads};
use demeter::measure::{Moment, contact_records, measure};
use demeter::simulation::{Setup, Simulation, SimulationState, Skin, StateError};
use demeter::walls::Wall;
use demeter_physics::integrator::Integrator;

/// All that can be seen of a run, in bytes.
fn fingerprint(sim: &mut Simulation) -> Vec<u8> {
    let carried = sim.contacts.carry(sim.grains());
    let walls: Vec<_> = sim.walls.iter().map(Wall::state).collect();
    let mut bytes = postcard::to_stdvec(&(sim.step, sim.grains(), &carried, &walls)).unwrap();
    bytes.extend(postcard::to_stdvec(&(sim.energies(), sim.books, sim.rebuilds(), sim.skin())).unwrap());
    bytes.extend(format!("{:?}", measure(sim, Moment::default(), None)).bytes());
    bytes.extend(format!("{:?}", contact_records(sim)).bytes());
    bytes
}

/// Steps at which states are saved: a fixed pseudo-random choice and, in a dense stretch, every step, so that some lie
/// right before a search for candidates or the removal of a grain.
fn saved_steps(last: u64) -> Vec<u64> {
    let mut x = 12345u64;
    let mut steps: Vec<u64> = (0..6)
        .map(|_| {
            x = x
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (x >> 33) % last + 1
        })
        .collect();
    steps.extend(last - 20..last);
    steps.sort_unstable();
    steps.dedup();
    steps
}

#[test]
fn a_continued_run_gives_the_same_bits() {
    interrupt(|name, count| bed_with(Integrator::VelocityVerlet, name, count));
}

#[test]
fn a_continued_run_whose_skin_is_tuned_gives_the_same_bits() {
    interrupt(tuned);
}

/// A bed whose skin follows the motion.
fn tuned(name: &str, count: u32) -> Setup {
    let setup = bed_with(Integrator::VelocityVerlet, name, count);
    Setup {
        skin: Skin::Tuned(setup.skin.first()),
        ..setup
    }
}

#[test]
fn a_continued_run_gives_the_same_bits_with_gear() {
    interrupt(|name, count| bed_with(Integrator::Gear, name, count));
}

#[test]
fn a_state_of_the_other_integrator_is_refused() {
    let both = [Integrator::VelocityVerlet, Integrator::Gear];
    for (wrote, reads) in [(both[0], both[1]), (both[1], both[0])] {
        let mut sim = Simulation::new(bed_with(wrote, "settling", 20));
        sim.step().unwrap();
        let refused = Simulation::resume(bed_with(reads, "settling", 20), sim.state());
        assert_eq!(refused.err(), Some(StateError::Integrator));
    }
}

fn interrupt(setup: impl Fn(&str, u32) -> Setup + Sync) {
    let (count, most, more) = if full() { (300, 20_000, 3_000) } else { (60, 5_000, 400) };
    on_threads(1, || {
        for name in BEDS {
            let last = steps_for(name, most);
            let saved = saved_steps(last);
            let mut sim = Simulation::new(setup(name, count));
            let mut states = vec![];
            for step in 1..=last {
                sim.step().unwrap();
                if saved.contains(&step) {
                    states.push((postcard::to_stdvec(&sim.state()).unwrap(), fingerprint(&mut sim)));
                }
            }
            for _ in 0..more {
                sim.step().unwrap();
            }
            let expected = fingerprint(&mut sim);
            for (bytes, at_once) in states {
                let state: SimulationState = postcard::from_bytes(&bytes).unwrap();
                let start = state.step;
                let mut continued = Simulation::resume(setup(name, count), state).unwrap();
                assert!(
                    fingerprint(&mut continued) == at_once,
                    "{name}: restored at step {start}, before any step"
                );
                let remaining = last + more - start;
                for _ in 0..remaining {
                    continued.step().unwrap();
                    // the books note the lowest place seen whenever they are asked, as the series does at its cadence
                    if saved.contains(&continued.step) {
                        continued.energies();
                    }
                }
                assert!(
                    fingerprint(&mut continued) == expected,
                    "{name}: {remaining} steps after the restart at step {start}"
                );
            }
        }
    });
}
