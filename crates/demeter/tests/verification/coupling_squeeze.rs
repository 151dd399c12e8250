//! A packing squeezed and eased by a plate: what the coupling is of energy and work, and how exact its force is.

use crate::coupling::packing;

use crate::cases::{full, on_threads, report};
use demeter::contacts::Coupling;
use demeter::simulation::Energies;
use demeter::walls::Motion;
use demeter_physics::DVec3;
use packing::{Model, Packing, pressing, within};

/// Strains at which forces and energies are read.
const STRAINS: [f64; 3] = [0.02, 0.08, 0.13];

/// Speed of the plate [m/s].
const SPEED: f64 = 0.1;

/// What was read at the strains while the plate came down, and when it was back.
struct Stroke {
    forces: [f64; 3],
    energies: [Energies; 3],
    back: Energies,
}

/// Squeezes a packing and eases it again, if so asked.
fn stroke(packing: &Packing, model: Model, and_back: bool) -> Stroke {
    let mut sim = packing.simulation(model, Motion::Velocity(-DVec3::Z * SPEED));
    // a whole number of steps to every hundredth of strain
    let hundredth = 0.01 * packing.touch / SPEED;
    let steps = (hundredth / sim.dt()).ceil();
    sim.set_dt(hundredth / steps).unwrap();
    let mut run = Stroke {
        forces: [0.0; 3],
        energies: [Energies::default(); 3],
        back: Energies::default(),
    };
    for (k, strain) in STRAINS.into_iter().enumerate() {
        let until = (100.0 * strain).round() as u64 * steps as u64;
        while sim.step < until {
            sim.step().unwrap();
        }
        (run.forces[k], run.energies[k]) = (pressing(&sim), sim.energies());
    }
    if and_back {
        sim.walls[1].set_motion(Motion::Velocity(DVec3::Z * SPEED)).unwrap();
        for _ in 0..sim.step {
            sim.step().unwrap();
        }
        run.back = sim.energies();
    }
    run
}

/// Force on the plate at the same strain, with ever smaller steps.
#[test]
fn the_force_on_a_plate_converges_with_the_time_step() {
    let (count, shares, finest): (_, &[f64], _) = match full() {
        true => (80, &[0.04, 0.02, 0.01], 0.005),
        false => (50, &[0.04, 0.02], 0.005),
    };
    on_threads(1, || {
        let packing = Packing::new(count);
        let model = |coupling, share| Model {
            share,
            restitution: 0.5,
            ..Model::half_space(coupling)
        };
        let exact = stroke(&packing, model(within(1e-8), finest), false);
        for (name, coupling) in [
            ("converged", within(1e-6)),
            ("1e-4", within(1e-4)),
            ("lagged", Coupling::Lagged),
        ] {
            for &share in shares {
                let found = stroke(&packing, model(coupling, share), false);
                let error = [0, 1, 2].map(|k| (found.forces[k] - exact.forces[k]).abs() / exact.forces[k]);
                for (strain, error) in STRAINS.into_iter().zip(error) {
                    report(&format!("{name}, share {share}: error of the force at {strain}"), error);
                    // second order, as without coupling; lagged, first
                    let coarse = share / 0.04;
                    let allowed = if name == "lagged" {
                        6e-3 * coarse
                    } else {
                        5e-4 * coarse * coarse
                    };
                    assert!(error < allowed, "{name}, share {share}, strain {strain}: {error}");
                }
            }
        }
    });
}

/// The correction as a share of energy and work, and what a cycle puts in or takes out beside them.
#[test]
fn shares_of_the_correction() {
    let count = if full() { 80 } else { 50 };
    on_threads(1, || {
        let packing = Packing::new(count);
        let run = |law: &'static str, poisson_ratio: f64, coupling| {
            let model = Model {
                law,
                poisson_ratio,
                share: 0.02,
                ..Model::half_space(coupling)
            };
            stroke(&packing, model, true)
        };
        let converged = within(1e-6);
        let mut cases = vec![
            ("half-space", 0.5, converged),
            ("half-space", 0.5, Coupling::Lagged),
            ("sphere-to-sphere", 0.5, converged),
            ("point-on-sphere", 0.5, converged),
        ];
        if full() {
            cases.extend([("half-space", 0.3, converged), ("half-space", 0.0, converged)]);
        }
        for (law, poisson_ratio, coupling) in cases {
            let independent = run("independent", poisson_ratio, converged);
            let coupled = run(law, poisson_ratio, coupling);
            let name = format!("{law}, nu {poisson_ratio}, {coupling:?}");
            for (k, strain) in STRAINS.into_iter().enumerate() {
                let (e, alone) = (coupled.energies[k], independent.energies[k]);
                report(
                    &format!("{name}, {strain}: force over independent"),
                    coupled.forces[k] / independent.forces[k],
                );
                report(
                    &format!("{name}, {strain}: energy of the correction, of the elastic"),
                    e.multi_contact / e.elastic,
                );
                report(
                    &format!("{name}, {strain}: work of the plate over independent"),
                    e.wall_work / alone.wall_work,
                );
                report(
                    &format!("{name}, {strain}: put in, of the work"),
                    e.multi_contact_input / e.wall_work,
                );
                assert!(e.residual.abs() < 1e-3);
            }
            let (down, back) = (coupled.energies[2], coupled.back);
            let per_work = |energy: f64| energy / down.wall_work;
            report(
                &format!("{name}: given back, of the work"),
                per_work(down.wall_work - back.wall_work),
            );
            report(
                &format!("{name}: put in over the cycle, of the work"),
                per_work(back.multi_contact_input),
            );
            report(&format!("{name}: dissipated, of the work"), per_work(back.dissipated()));
            report(&format!("{name}: residual"), back.residual);
            assert!(back.residual.abs() < 1e-3);
            let bound = if coupling == Coupling::Lagged { 5e-3 } else { 1e-3 };
            assert!(per_work(back.multi_contact_input).abs() < bound, "{name}");
            assert!(per_work(down.multi_contact_input).abs() < 0.02, "{name}");
        }
    });
}
