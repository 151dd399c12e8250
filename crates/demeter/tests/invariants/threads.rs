//! A run gives the same bits on any number of threads.

use crate::cases::beds::{BEDS, bed_with};
use crate::cases::{full, on_threads};
use demeter::contacts::Fault;
use demeter::measure::{Moment, contact_records, measure};
use demeter::simulation::{Setup, Simulation, Skin};
use demeter::walls::Wall;
use demeter_physics::integrator::Integrator;

/// Bytes of the final state and of every tenth row of the series.
fn run(integrator: Integrator, name: &str, count: u32, steps: u64) -> Result<(Vec<u8>, String, usize), Fault> {
    let setup = bed_with(integrator, name, count);
    let skin = Skin::Tuned(setup.skin.first());
    let mut sim = Simulation::new(Setup { skin, ..setup });
    let mut series = String::new();
    for step in 0..steps {
        sim.step()?;
        if step % 10 == 0 {
            series += &format!("{:?}\n", measure(&mut sim, Moment::default(), None));
        }
    }
    let walls: Vec<_> = sim.walls.iter().map(Wall::state).collect();
    let contacts = format!("{:?}", contact_records(&sim));
    let chunks = sim.contacts.pairs.len() + sim.contacts.walls.len();
    Ok((
        postcard::to_stdvec(&(sim.grains(), &walls, &contacts, sim.skin(), sim.rebuilds())).unwrap(),
        series,
        chunks,
    ))
}

#[test]
fn threads_do_not_change_a_bit() {
    compare(Integrator::VelocityVerlet);
}

#[test]
fn threads_do_not_change_a_bit_with_gear() {
    compare(Integrator::Gear);
}

fn compare(integrator: Integrator) {
    // enough grains for several chunks of candidates, or the threads would share nothing
    let (count, steps) = if full() { (5000, 3_000) } else { (2000, 60) };
    for name in BEDS {
        let (state, series, chunks) = on_threads(1, || run(integrator, name, count, steps)).unwrap();
        assert!(chunks > 1, "{name}: {chunks} chunks of candidates");
        for threads in [2, 5] {
            let (other_state, other_series, _) = on_threads(threads, || run(integrator, name, count, steps)).unwrap();
            assert!(
                series == other_series,
                "{name}: the series differs on {threads} threads"
            );
            assert!(state == other_state, "{name}: the state differs on {threads} threads");
        }
    }
}
