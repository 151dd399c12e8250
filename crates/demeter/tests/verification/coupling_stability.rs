//! How long contacts that feel each other hold still, and up to which time step.

use crate::coupling::packing;

use crate::cases::{full, on_threads, report};
use demeter::contacts::Coupling;
use demeter::simulation::{Simulation, unsafe_share};
use demeter::walls::Motion;
use demeter_physics::integrator::Integrator;
use packing::{Model, Packing, pressing, within};

/// Time of a run in shortest time scales.
const SPAN: f64 = 40.0;

fn kinetic(sim: &Simulation) -> f64 {
    let grains = sim.grains();
    let each = grains.masses().zip(grains.velocity.iter());
    each.map(|(mass, velocity)| 0.5 * mass * velocity.length_squared())
        .sum()
}

/// Mean kinetic energy in the quarters of some steps, or nothing where the run broke.
fn quarters(sim: &mut Simulation, steps: u64) -> Option<[f64; 4]> {
    let mut mean = [0.0; 4];
    for part in &mut mean {
        for _ in 0..steps / 4 {
            sim.step().ok()?;
            *part += kinetic(sim) / (steps / 4) as f64;
        }
    }
    Some(mean)
}

/// Whether a shaken packing does not get wilder.
fn is_stable(shaken: &Packing, model: Model, integrator: Integrator) -> bool {
    let mut case = shaken.case(model, Motion::Rest);
    case.integrator = integrator;
    let mut sim = case.simulation();
    let steps = (SPAN / model.share).round() as u64;
    quarters(&mut sim, steps).is_some_and(|mean| mean[3] < 2.0 * mean[0])
}

/// The schemes, with the law that tells whether contacts feel each other.
const SCHEMES: [(&str, &str, Coupling); 3] = [
    ("independent", "independent", Coupling::Lagged),
    ("converged", "half-space", Coupling::Converged { tolerance: 1e-6 }),
    ("lagged", "half-space", Coupling::Lagged),
];

/// The largest stable time step, as a share of the shortest time scale, by steps of a ninth.
fn largest_stable(shaken: &Packing, model: Model) -> f64 {
    let mut share = 0.05;
    loop {
        let next = share * libm::pow(2.0, 1.0 / 6.0);
        if next > 2.0 || !is_stable(shaken, Model { share: next, ..model }, Integrator::VelocityVerlet) {
            return share;
        }
        share = next;
    }
}

/// All of them are far above the step that is refused.
#[test]
fn largest_stable_time_steps() {
    let refused = unsafe_share(Integrator::VelocityVerlet);
    let (count, strains): (_, &[f64]) = if full() {
        (80, &[0.02, 0.08, 0.13])
    } else {
        (50, &[0.13])
    };
    on_threads(1, || {
        let touched = Packing::new(count);
        let mut at_rest = SCHEMES.map(|_| touched.clone());
        for &strain in strains {
            for ((name, law, coupling), packing) in SCHEMES.into_iter().zip(&mut at_rest) {
                let of = Model {
                    law,
                    ..Model::half_space(within(1e-6))
                };
                *packing = packing.squeezed(of, strain);
                let shaken = packing.shaken(of, 1e-3);
                for restitution in [1.0, 0.9, 0.5] {
                    let model = Model {
                        coupling,
                        restitution,
                        ..of
                    };
                    let largest = largest_stable(&shaken, model);
                    report(
                        &format!("strain {strain}, e {restitution}, {name}: stable up to"),
                        largest,
                    );
                    assert!(largest > 2.0 * refused, "{name} {strain} {restitution}: {largest}");
                }
            }
        }
    });
}

/// The predictor-corrector at the largest step that is not refused, damped as much as can be.
#[test]
fn gear_is_stable_at_its_largest_time_step() {
    let share = unsafe_share(Integrator::Gear);
    on_threads(1, || {
        let packing = Packing::new(50).squeezed(Model::half_space(within(1e-6)), 0.13);
        let shaken = packing.shaken(Model::half_space(within(1e-6)), 1e-3);
        for (name, law, coupling) in SCHEMES {
            for restitution in [0.9, 0.05] {
                let model = Model {
                    law,
                    coupling,
                    restitution,
                    share,
                    ..Model::half_space(coupling)
                };
                assert!(is_stable(&shaken, model, Integrator::Gear), "{name} {restitution}");
            }
        }
    });
}

/// A packing held at 13 % strain for 1e5 steps (reduced: 1e4).
#[test]
fn a_packing_holds_still_at_13_percent() {
    let (count, steps) = if full() { (64, 100_000) } else { (50, 10_000) };
    on_threads(1, || {
        let solved = Model::half_space(within(1e-6));
        let squeezed = Packing::new(count).squeezed(solved, 0.13);
        let calm = squeezed.shaken(solved, 1e-6);
        for (name, coupling) in [("converged", within(1e-6)), ("lagged", Coupling::Lagged)] {
            hold(&calm, name, Model { coupling, ..solved }, steps);
        }
        let shaken = squeezed.shaken(solved, 1e-4);
        // elastic, and solved: nothing damps, nothing feeds
        let elastic = Model {
            restitution: 1.0,
            share: 0.02,
            ..solved
        };
        let mean = quarters(&mut shaken.simulation(elastic, Motion::Rest), steps).unwrap();
        report("elastic, converged: last over first kinetic energy", mean[3] / mean[0]);
        assert!((mean[3] / mean[0] - 1.0).abs() < 0.03, "{mean:?}");
        // lagged, the slow modes are fed, and win in the end
        let lagged = Model {
            coupling: Coupling::Lagged,
            ..elastic
        };
        let mean = quarters(&mut shaken.simulation(lagged, Motion::Rest), steps).unwrap();
        report("elastic, lagged: last over first kinetic energy", mean[3] / mean[0]);
        if full() {
            assert!(mean[3] > 3.0 * mean[0], "{mean:?}");
        }
    });
}

fn hold(shaken: &Packing, name: &str, model: Model, steps: u64) {
    let mut sim = shaken.simulation(model, Motion::Rest);
    sim.start().unwrap();
    let (mut force, mut energy) = ([0.0; 10], [0.0; 10]);
    let part = steps / 10;
    for (force, energy) in force.iter_mut().zip(&mut energy) {
        for _ in 0..part {
            sim.step().unwrap();
            *force += pressing(&sim) / part as f64;
            *energy += kinetic(&sim) / part as f64;
        }
    }
    let drift = force.iter().map(|f| (f / force[9] - 1.0).abs()).fold(0.0, f64::max);
    report(&format!("{name}: largest change of the mean force on the plate"), drift);
    report(
        &format!("{name}: last over first kinetic energy"),
        energy[9] / energy[0],
    );
    let e = sim.energies();
    report(&format!("{name}: residual"), e.residual);
    report(
        &format!("{name}: put in, of the stored"),
        e.multi_contact_input / e.elastic,
    );
    let effort = sim.coupling_effort();
    report(
        &format!("{name}: iterations a step"),
        effort.iterations as f64 / effort.solutions as f64,
    );
    let (largest_drift, calmer) = if full() { (1e-4, 0.1) } else { (3e-4, 0.8) };
    assert!(
        drift < largest_drift && energy[9] < calmer * energy[0],
        "{name}: {force:?} {energy:?}"
    );
    assert!(e.residual.abs() < 1e-5 && e.multi_contact_input.abs() < 1e-5 * e.elastic);
}
