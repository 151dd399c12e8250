//! What the predictor-corrector is feared for: strong damping in dense beds, and the drift of an elastic system.

use crate::cases;

use crate::cases::beds::{RADIUS, fill};
use crate::cases::{Case, Laws, full, law, on_threads, one_material, report};
use demeter::simulation::{SAFE_SHARE, Simulation, unsafe_share};
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;
use demeter_physics::integrator::Integrator;

/// Largest residual of the books of grains that settle in a box.
fn settle(integrator: Integrator, laws: &Laws, share: f64) -> f64 {
    let mut case = Case::new(one_material(5e6, laws));
    let a = 7.0 * RADIUS;
    (case.integrator, case.share) = (integrator, share);
    (case.skin, case.max_overlap) = (0.2 * RADIUS, 0.2);
    let upper = DVec3::new(a, a, 2.0 * a);
    fill(&mut case, DVec3::ZERO, upper, 40, 0.1);
    let (lower, open) = (DVec3::ZERO, [false; 6]);
    case.wall(0, Shape::Box { lower, upper, open }, Motion::Rest);
    case.gravity = DVec3::Z * -cases::G;
    let mut sim = Simulation::new(case.setup());
    let (duration, mut residual) = (if full() { 0.5 } else { 0.3 }, 0.0f64);
    for step in 0..(duration / sim.dt()) as u64 {
        sim.step().unwrap();
        if step % 20 == 0 {
            residual = residual.max(sim.energies().residual.abs());
        }
    }
    residual
}

fn strongly_damped() -> [(&'static str, Laws); 3] {
    let coulomb = law("coulomb", &[("friction", 0.3)]);
    let mindlin = law("mindlin-history", &[("friction", 0.3), ("damping_ratio", 1.0)]);
    [
        ("linear", Laws::linear(2e3, 0.05)),
        (
            "linear, coulomb, constant-torque",
            Laws::linear(2e3, 0.05)
                .friction(coulomb)
                .rolling("constant-torque", 0.1),
        ),
        (
            "hertz-tsuji, mindlin-history, epsd",
            Laws::hertz(0.05).friction(mindlin).rolling("epsd", 0.1),
        ),
    ]
}

/// Grains of restitution 0.05 settle at the automatic step and at the largest that is not refused; the books, which an
/// instability breaks at once, close as they do with velocity Verlet.
#[test]
fn strong_damping_in_a_dense_bed() {
    let gear = Integrator::Gear;
    on_threads(1, || {
        for (name, laws) in strongly_damped() {
            for share in [SAFE_SHARE, unsafe_share(gear)] {
                let residual = settle(gear, &laws, share);
                report(
                    &format!("{name}, {share} of the shortest time scale: residual"),
                    residual,
                );
                assert!(residual < 1e-3, "{name}, {share}: {residual}");
            }
        }
    });
}

/// Why a larger step is refused: twice as large, the bed explodes; velocity Verlet bears it.
#[test]
fn the_largest_step_that_is_not_refused_is_near_the_limit() {
    on_threads(1, || {
        let [(_, laws), ..] = strongly_damped();
        let share = 2.0 * unsafe_share(Integrator::Gear);
        let found = [Integrator::VelocityVerlet, Integrator::Gear].map(|i| settle(i, &laws, share));
        report("residual at twice the largest step, velocity Verlet", found[0]);
        report("residual at twice the largest step, gear", found[1]);
        assert!(found[0] < 1e-2 && found[1] > 1.0, "{found:?}");
    });
}

/// Mean energy of a grain that swings between two planes without parting, relative to that of the first swings.
fn energy_later(integrator: Integrator, share: f64, steps: u64) -> f64 {
    let mut case = Case::new(one_material(1e8, &Laws::linear(1e5, 1.0)));
    (case.integrator, case.share) = (integrator, share);
    let overlap = 0.02 * RADIUS;
    case.grain(RADIUS, DVec3::X * (0.5 * overlap), DVec3::ZERO);
    for side in [1.0, -1.0] {
        case.plane(0, DVec3::X * (side * (overlap - RADIUS)), DVec3::X * side);
    }
    let mut sim = Simulation::new(case.setup());
    let swing = (2.0 / share) as u64;
    let rest = 1e5 * overlap * overlap;
    let mut mean = || {
        let sum: f64 = (0..swing)
            .map(|_| {
                sim.step().unwrap();
                sim.energies().present() - rest
            })
            .sum();
        sum / swing as f64
    };
    let first = mean();
    let mut last = first;
    for _ in 0..steps / swing {
        last = mean();
    }
    last / first
}

/// Gear takes energy out of an elastic system at a steady rate; velocity Verlet does not.
#[test]
fn drift_of_an_elastic_swing() {
    let steps = if full() { 10_000_000 } else { 200_000 };
    on_threads(1, || {
        for share in [SAFE_SHARE, unsafe_share(Integrator::Gear)] {
            let [verlet, gear] = [Integrator::VelocityVerlet, Integrator::Gear].map(|integrator| {
                let change = energy_later(integrator, share, steps) - 1.0;
                report(
                    &format!("{integrator:?} at {share}: change of energy per step"),
                    change / steps as f64,
                );
                change / steps as f64
            });
            // the method damps as the sixth power of the step
            let ratio = share / SAFE_SHARE;
            let most = 4e-13 * ratio * ratio * ratio * ratio * ratio * ratio;
            assert!(-most < gear && gear < -0.3 * most, "{share}: {gear}");
            assert!(verlet.abs() < 0.05 * most, "{share}: {verlet}");
        }
    });
}
