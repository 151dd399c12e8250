//! Energy of contacts that feel each other: what the lag of a step, the tolerance of the solution and the changing
//! geometry put in (`verification/README.md`).

mod chain;
pub mod packing;

use crate::cases::{full, on_threads, report};
use approx::assert_relative_eq;
use chain::Wave;
use demeter::contacts::Coupling;
use demeter::walls::Motion;
use packing::{FINE, Model, Packing, pressing, within};

/// Every mode of a ring grows or fades under the lag as derived, in proportion to the time step; solved, none does.
#[test]
fn lag_feeds_or_damps_every_mode_as_derived() {
    on_threads(1, || {
        for number in [1, 2, 3, 4] {
            for share in [0.01, 0.005] {
                let mut lagged = Wave::new(number, Coupling::Lagged, share);
                let (found, expected) = (lagged.growth(), lagged.growth_by_lag());
                let name = format!("mode {number}, feedback {:.3}, share {share}", lagged.feedback);
                report(&format!("{name}: growth per radian, lagged"), found);
                assert_relative_eq!(found, expected, max_relative = 2e-3, epsilon = 1e-8);
                let default = Wave::new(number, within(1e-6), share).growth();
                report(&format!("{name}: growth per radian, 1e-6"), default);
                assert!(default.abs() < 2e-5, "{name}: {default}");
                let fine = Wave::new(number, FINE, share).growth();
                assert!(fine.abs() < 1e-7, "{name}: {fine}");
            }
        }
    });
}

/// A packing of elastic grains vibrates.
struct Vibration {
    /// Change of the energy, less what the books say was put in, over the vibration.
    unexplained: f64,
    /// What was put in, over the energy stored.
    input: f64,
    /// Mean force on the plate [N].
    force: f64,
    iterations: f64,
}

/// Energy of the vibration as a share of the stored one.
const VIBRATION: f64 = 1e-3;

fn vibrate(packing: &Packing, coupling: Coupling, share: f64) -> Vibration {
    let model = Model {
        restitution: 1.0,
        share,
        ..Model::half_space(coupling)
    };
    let mut sim = packing.simulation(model, Motion::Rest);
    sim.start().unwrap();
    let before = sim.energies();
    let steps = (30.0 / share).round();
    let mut force = 0.0;
    for _ in 0..steps as u64 {
        sim.step().unwrap();
        force += pressing(&sim) / steps;
    }
    let (after, effort) = (sim.energies(), sim.coupling_effort());
    let change = after.present() - before.present();
    Vibration {
        unexplained: (change - after.multi_contact_input) / before.kinetic,
        input: after.multi_contact_input / before.elastic,
        force,
        iterations: effort.iterations as f64 / effort.solutions as f64,
    }
}

#[test]
fn a_vibrating_packing_keeps_its_energy_but_for_what_is_booked() {
    let (count, strains, last): (_, &[f64], _) = match full() {
        true => (80, &[0.02, 0.08, 0.13], 0.005),
        false => (50, &[0.13], 0.01),
    };
    on_threads(1, || {
        let mut packing = Packing::new(count);
        for &strain in strains {
            packing = packing.squeezed(Model::half_space(within(1e-8)), strain);
            let shaken = packing.shaken(Model::half_space(FINE), VIBRATION);
            let exact = [2.0 * last, last].map(|share| vibrate(&shaken, FINE, share));
            let lagged = [2.0 * last, last].map(|share| vibrate(&shaken, Coupling::Lagged, share));
            report(&format!("{strain}: unexplained, converged"), exact[1].unexplained);
            report(&format!("{strain}: unexplained, lagged"), lagged[1].unexplained);
            // second order, as without coupling
            for run in [&exact, &lagged] {
                assert!(run[1].unexplained.abs() < 2e-4 && run[1].unexplained.abs() < run[0].unexplained.abs() / 3.0);
            }
            // by geometry, whatever the step
            report(&format!("{strain}: put in by geometry, of the stored"), exact[1].input);
            assert!((exact[0].input - exact[1].input).abs() < 2e-3 * VIBRATION);
            let by_lag = [0, 1].map(|k| lagged[k].input - exact[k].input);
            report(
                &format!("{strain}: put in by lag, of the vibration"),
                by_lag[1] / VIBRATION,
            );
            let ratio = by_lag[0] / by_lag[1];
            report(&format!("{strain}: ratio over a halved step"), ratio);
            assert!((1.4..2.4).contains(&ratio), "{ratio}");
            tolerances(&shaken, strain, last, &exact[1]);
        }
    });
}

/// What the tolerance changes, against 1e-12.
fn tolerances(shaken: &Packing, strain: f64, share: f64, exact: &Vibration) {
    for exponent in [1, 2, 3, 4, 5, 6, 8, 10, 12] {
        let tolerance = libm::pow(10.0, -f64::from(exponent));
        let run = vibrate(shaken, within(tolerance), share);
        let force = run.force / exact.force - 1.0;
        let input = run.input - exact.input;
        for (what, value) in [
            ("iterations", run.iterations),
            ("force", force),
            ("put in, of the stored", input),
            ("unexplained", run.unexplained),
        ] {
            report(&format!("{strain}, tolerance {tolerance:.0e}: {what}"), value);
        }
        assert!(
            force.abs() < 0.01 * tolerance + 1e-11 && input.abs() < 0.5 * tolerance + 1e-11,
            "{tolerance}"
        );
    }
}
