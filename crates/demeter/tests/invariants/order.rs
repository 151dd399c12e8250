//! Neither the order of the grains in memory, nor the skin, nor whether steps are taken one by one changes a trajectory.

use crate::cases::beds::{BEDS, bed_with, steps_for};
use crate::cases::{full, on_threads};
use demeter::contacts::ContactKey;
use demeter::simulation::{Setup, Simulation, Skin};
use demeter_physics::integrator::Integrator;

/// Position, velocity, angular velocity, orientation and image of every grain by id, and the engaged contacts with what
/// they remember, as bytes.
fn trajectories(setup: Setup, steps: u64) -> (Vec<Vec<u8>>, u64) {
    let mut sim = Simulation::new(setup);
    let mut seen = vec![];
    for step in 1..=steps {
        sim.step().unwrap();
        if step % (steps / 10) == 0 {
            seen.push(snapshot(&sim));
        }
    }
    (seen, sim.rebuilds())
}

fn snapshot(sim: &Simulation) -> Vec<u8> {
    let g = sim.grains();
    let mut order: Vec<usize> = (0..g.len()).collect();
    order.sort_by_key(|&k| g.id[k]);
    let size = sim.domain().size();
    let grains: Vec<_> = (order.into_iter())
        .map(|k| {
            // a grain is put back into the periodic box when candidates are found, which depends on the skin
            let unwrapped = glam::DVec3::from_array(std::array::from_fn(|axis| {
                g.position[k][axis] + f64::from(g.crossings(k)[axis]) * size[axis]
            }));
            (
                g.id[k],
                unwrapped,
                g.velocity[k],
                g.angular_velocity[k],
                g.orientation.as_ref().map(|all| all[k]),
                g.force(k),
                g.higher.get(k).copied(),
            )
        })
        .collect();
    // pairs that are merely near come and go with the candidates
    let contacts: Vec<(ContactKey, f64, Vec<f64>)> = (sim.contacts.carry(g).iter())
        .filter(|c| c.is_engaged)
        .map(|c| (c.key, c.normal_force, c.history.clone()))
        .collect();
    postcard::to_stdvec(&(grains, contacts)).unwrap()
}

/// The same setup with the grains in another order.
fn shuffled(mut setup: Setup) -> Setup {
    let n = setup.grains.len() as u32;
    let stride = (2..n).rev().find(|s| gcd(*s, n) == 1 && *s < n / 2).unwrap_or(1);
    let order: Vec<u32> = (0..n).map(|k| (k * stride + 3) % n).collect();
    setup.grains.reorder(&order);
    setup
}

fn gcd(a: u32, b: u32) -> u32 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[test]
fn the_order_in_memory_changes_nothing() {
    shuffle(Integrator::VelocityVerlet);
}

#[test]
fn the_order_in_memory_changes_nothing_with_gear() {
    shuffle(Integrator::Gear);
}

fn shuffle(integrator: Integrator) {
    let (count, steps) = if full() { (300, 30_000) } else { (60, 6_000) };
    on_threads(1, || {
        for name in BEDS {
            let steps = steps_for(name, steps);
            let (expected, _) = trajectories(bed_with(integrator, name, count), steps);
            let (found, _) = trajectories(shuffled(bed_with(integrator, name, count)), steps);
            assert!(expected == found, "{name}");
        }
    });
}

/// The force on a wall is summed in the order of the table of contacts, which depends on when candidates were found. A
/// servo answers to that force, so its bed follows only to rounding; and positions in a periodic box are rounded after
/// a shift. Where contacts feel each other, the mixing of forces follows sums over the table, and the search reaches as far
/// as the surfaces bulged when it was made. Everything else keeps its bits.
const EXACT: [&str; 5] = ["settling", "drum", "moving walls", "removal", "squeezing"];

#[test]
fn the_skin_changes_nothing() {
    let (count, steps) = if full() { (300, 30_000) } else { (60, 6_000) };
    let cases = EXACT.iter().map(|name| (Integrator::VelocityVerlet, *name));
    let cases = cases.chain([(Integrator::Gear, "settling"), (Integrator::Gear, "removal")]);
    on_threads(1, || {
        for (integrator, name) in cases {
            let (expected, rebuilds) = trajectories(bed_with(integrator, name, count), steps);
            let first = bed_with(integrator, name, count).skin.first();
            let mut differing = 0;
            for skin in [Skin::Fixed(0.2 * first), Skin::Fixed(3.0 * first), Skin::Tuned(first)] {
                let mut setup = bed_with(integrator, name, count);
                setup.skin = skin;
                let (found, others) = trajectories(setup, steps);
                differing += usize::from(rebuilds != others);
                let same = expected.iter().zip(&found).take_while(|(a, b)| a == b).count();
                assert!(same == expected.len(), "{name}, {skin:?}: {same} tenths agree");
            }
            assert!(
                differing > 1,
                "{name}: {rebuilds} searches for candidates with most skins"
            );
        }
    });
}

#[test]
fn steps_taken_together_are_those_taken_one_by_one() {
    let count = if full() { 300 } else { 60 };
    on_threads(1, || {
        for integrator in [Integrator::VelocityVerlet, Integrator::Gear] {
            for name in BEDS {
                let steps = steps_for(name, 1_000);
                let mut together = Simulation::new(bed_with(integrator, name, count));
                together.steps(steps).unwrap();
                let mut one_by_one = Simulation::new(bed_with(integrator, name, count));
                for _ in 0..steps {
                    one_by_one.step().unwrap();
                }
                assert!(snapshot(&together) == snapshot(&one_by_one), "{name}");
            }
        }
    });
}
