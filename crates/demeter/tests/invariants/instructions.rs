//! A run gives the same bits with all instructions of the processor, and with the clock read or not.

use crate::cases::beds::{BEDS, bed_with, steps_for};
use crate::cases::{full, on_threads};
use demeter::measure::{Moment, contact_records, measure};
use demeter::simulation::Simulation;
use demeter::walls::Wall;
use demeter_physics::integrator::Integrator;
use demeter_physics::lanes::{Instructions, MOST_LANES};

/// All that a run came to: grains, walls, contacts, and every twentieth row of the series, with the contacts then.
#[derive(PartialEq)]
struct Fingerprint {
    state: Vec<u8>,
    series: String,
    /// The most contacts of any step.
    contacts: usize,
}

fn run(integrator: Integrator, name: &str, set: impl FnOnce(&mut Simulation) + Send) -> Fingerprint {
    // squeezed beds touch from the first step on, the others when their grains have met
    let (count, steps) = if full() { (400, 6_000) } else { (100, 3_000) };
    on_threads(1, || {
        let mut sim = Simulation::new(bed_with(integrator, name, count));
        set(&mut sim);
        let mut series = String::new();
        let mut contacts = 0;
        for step in 0..steps_for(name, steps) {
            sim.step().unwrap();
            contacts = contacts.max(sim.contacts.pair_count());
            if step % 20 == 0 {
                series += &format!("{:?}\n", measure(&mut sim, Moment::default(), None));
                series += &format!("{:?}\n", contact_records(&sim));
            }
        }
        let walls: Vec<_> = sim.walls.iter().map(Wall::state).collect();
        let records = format!("{:?}", contact_records(&sim));
        Fingerprint {
            state: postcard::to_stdvec(&(sim.grains(), &walls, &records)).unwrap(),
            series,
            contacts,
        }
    })
}

fn compare(integrator: Integrator) {
    let available = Instructions::available();
    assert!(available.contains(&Instructions::Portable));
    let mut contacts = vec![];
    for name in BEDS {
        let portable = run(integrator, name, |sim| sim.set_instructions(Instructions::Portable));
        for &wide in available.iter().filter(|&&i| i != Instructions::Portable) {
            let other = run(integrator, name, |sim| sim.set_instructions(wide));
            let what = wide.name();
            assert!(
                portable.series == other.series,
                "{name}: the series differs with {what}"
            );
            assert!(portable.state == other.state, "{name}: the state differs with {what}");
        }
        contacts.push((name, portable.contacts));
    }
    // fewer contacts than lanes would leave most of the wide code unused
    let full = contacts
        .iter()
        .filter(|(_, contacts)| *contacts > 3 * MOST_LANES)
        .count();
    assert!(2 * full > BEDS.len(), "few contacts: {contacts:?}");
}

#[test]
fn instructions_do_not_change_a_bit() {
    compare(Integrator::VelocityVerlet);
}

#[test]
fn instructions_do_not_change_a_bit_with_gear() {
    compare(Integrator::Gear);
}

#[test]
fn a_profile_changes_no_bit() {
    for name in ["settling", "drum", "squeezed"] {
        let quiet = run(Integrator::VelocityVerlet, name, |_| ());
        let told = run(Integrator::VelocityVerlet, name, Simulation::profile_from_now);
        assert!(quiet == told, "{name}: a profile changes the run");
    }
}
