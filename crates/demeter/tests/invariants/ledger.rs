//! The energy books of a run close: what came in, what is there and what was dissipated agree.

use crate::cases::beds::{BEDS, bed_with};
use crate::cases::{Case, Laws, full, law, on_threads, one_material, report};
use demeter::simulation::{Setup, Simulation};
use demeter_physics::integrator::Integrator;
use glam::DVec3;

/// What the issue asks of every example.
const TOLERANCE: f64 = 1e-3;

#[test]
fn the_books_close() {
    close(Integrator::VelocityVerlet);
}

#[test]
fn the_books_close_with_gear() {
    close(Integrator::Gear);
}

fn close(integrator: Integrator) {
    let (count, steps) = if full() { (400, 100_000) } else { (60, 20_000) };
    for name in BEDS {
        let largest = on_threads(1, || {
            let mut sim = Simulation::new(bed_with(integrator, name, count));
            let mut largest = 0.0f64;
            for step in 0..steps {
                sim.step().unwrap();
                if step % 20 == 0 {
                    largest = largest.max(sim.energies().residual.abs());
                }
            }
            let e = sim.energies();
            let passed = e.dissipated() > 0.0 && e.viscous_dissipated > 0.0 && e.friction_dissipated > 0.0;
            assert!(passed, "{name}: nothing was dissipated, so nothing was tested: {e:?}");
            if name == "removal" {
                assert!(sim.books.removed_grains > 10 && e.removed > 0.0, "{e:?}");
            }
            report(&format!("removed grains of {name}"), sim.books.removed_grains as f64);
            largest
        });
        report(&format!("largest residual of {name}"), largest);
        assert!(largest < TOLERANCE, "{name}: {largest}");
    }
}

/// Largest residual of two grains that overlap and slide at the start, within 56 us.
fn residual_of_two_that_begin_loaded(dt: f64) -> f64 {
    let spring = law(
        "linear-history",
        &[("friction", 100.0), ("stiffness", 400.0), ("damping_ratio", 0.0)],
    );
    let mut case = Case::new(one_material(2e6, &Laws::hertz(1.0).friction(spring)));
    case.grain(1.3e-3, DVec3::ZERO, DVec3::Y * 0.1);
    case.grain(1.3e-3, DVec3::X * 2.55e-3, DVec3::Y * -0.1);
    case.max_overlap = 0.2;
    let mut sim = Simulation::new(Setup { dt, ..case.setup() });
    (0..(56e-6 / dt).round() as u32)
        .map(|_| {
            sim.step().unwrap();
            sim.energies().residual.abs()
        })
        .fold(0.0, f64::max)
}

#[test]
fn contacts_that_are_there_at_the_start_close_the_books_to_second_order() {
    on_threads(1, || {
        let [coarse, fine] = [1.4e-6, 0.7e-6].map(residual_of_two_that_begin_loaded);
        report("residual of two grains that begin loaded", coarse);
        assert!(coarse < 1e-4 && fine < 0.35 * coarse, "{coarse:e} {fine:e}");
    });
}
