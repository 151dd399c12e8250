//! A box that deforms has the same bits on any number of threads and processes and after a restart.

use super::{PRESSURE, gas, rough, rough_and_soft, sheared_at_constant_stress};
use crate::cases::ranks::on_ranks;
use crate::cases::{Laws, on_threads};
use demeter::comm::Ranks;
use demeter::simulation::{Drive, Simulation, SimulationState};

/// All that can be seen of a run, in bytes.
fn fingerprint(sim: &mut Simulation) -> Vec<u8> {
    let carried = sim.contacts.carry(sim.grains());
    let mut bytes = postcard::to_stdvec(&(sim.step, sim.grains(), &carried)).unwrap();
    bytes.extend(postcard::to_stdvec(&(sim.energies(), sim.books, sim.rebuilds(), sim.skin())).unwrap());
    bytes.extend(format!("{:?} {:?}", sim.box_state(), sim.domain()).bytes());
    bytes
}

#[test]
fn shear_at_constant_stress_has_the_same_bits_on_threads_and_after_a_restart() {
    cases().iter().for_each(hold_the_bits);
}

/// At a rate and at a shear stress.
fn cases() -> [(Laws, Drive); 2] {
    let (target, max_rate) = (0.5 * PRESSURE, 100.0);
    [
        (rough(), Drive::Stress { target, max_rate }),
        (rough_and_soft(), Drive::StrainRate(50.0)),
    ]
}

fn hold_the_bits((laws, drive): &(Laws, Drive)) {
    let go = |threads: usize| {
        on_threads(threads, || {
            let mut sim = sheared_at_constant_stress(laws, 7, *drive);
            let mut states = Vec::new();
            for step in 1..=2400 {
                sim.step().unwrap();
                if step % 397 == 0 {
                    states.push(postcard::to_stdvec(&sim.state()).unwrap());
                }
            }
            (fingerprint(&mut sim), states)
        })
    };
    let (expected, states) = go(1);
    assert!(go(2).0 == expected, "two threads give other bits");
    on_threads(1, || {
        for bytes in states {
            let state: SimulationState = postcard::from_bytes(&bytes).unwrap();
            let from = state.step;
            let mut sim = Simulation::resume(gas(laws, 7, 0.52, 0.1, 0.15), state).unwrap();
            for _ in from..2400 {
                sim.step().unwrap();
            }
            assert!(
                fingerprint(&mut sim) == expected,
                "other bits after a restart at step {from}"
            );
        }
    });
}

#[test]
fn shear_at_constant_stress_has_the_same_bits_on_any_number_of_processes() {
    let go = |(laws, drive): &(Laws, Drive), rank: Option<Box<dyn Ranks>>| {
        on_threads(1, || {
            let mut sim = sheared_at_constant_stress(laws, 13, *drive);
            let is_shared = rank.is_some();
            rank.into_iter().for_each(|rank| sim.share(rank));
            for _ in 0..450 {
                sim.step().unwrap();
            }
            sim.make_whole();
            assert!(sim.rebuilds() > 3 && (!is_shared || sim.sharing().unwrap().divided > 0));
            fingerprint(&mut sim)
        })
    };
    for case in cases() {
        let alone = go(&case, None);
        for ranks in [2, 3] {
            let shared = on_ranks(ranks, |rank| go(&case, Some(rank)));
            assert!(
                shared.iter().all(|bits| *bits == alone),
                "{ranks} processes give other bits"
            );
        }
    }
}
