//! The energy books of a run close: what came in, what is there and what was dissipated agree.

use crate::cases::beds::{BEDS, bed_with};
use crate::cases::{full, on_threads, report};
use demeter::simulation::Simulation;
use demeter_physics::integrator::Integrator;

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
