//! A box that is sheared at a given shear stress.

use super::{PRESSURE, plan_at_constant_stress, rough, run, sheared_at_constant_stress};
use crate::cases::report;
use demeter::comm::ShearAxes;
use demeter::simulation::{Drive, Simulation};

/// Of the flow before [1/s].
const RATE: f64 = 200.0;

/// Means over a while: of the rate of shear [1/s] and of the shear stress [Pa]; and the largest residual.
fn means(sim: &mut Simulation, looks: u32) -> (f64, f64, f64) {
    let axes = ShearAxes { flow: 0, gradient: 1 };
    let (begin, time) = (sim.box_state().unwrap().shear_strain, sim.time());
    let (mut stress, mut residual) = (0.0, 0.0f64);
    for _ in 0..looks {
        residual = residual.max(run(sim, 50));
        stress += sim.box_state().unwrap().shear_stress(axes) / f64::from(looks);
    }
    let rate = (sim.box_state().unwrap().shear_strain - begin) / (sim.time() - time);
    (rate, stress, residual)
}

/// A packing that flows at a rate, and what it is driven by from then on.
fn from_flow(rate: f64) -> (Simulation, impl Fn(&mut Simulation, f64)) {
    let mut sim = sheared_at_constant_stress(&rough(), 7, Drive::StrainRate(rate));
    run(&mut sim, 20_000);
    let drive = |sim: &mut Simulation, target: f64| {
        let max_rate = 4.0 * RATE;
        sim.deform(plan_at_constant_stress(Drive::Stress { target, max_rate }))
            .unwrap();
    };
    (sim, drive)
}

/// What a rate needs as a stress, that stress drives at the rate.
#[test]
fn a_stress_that_a_rate_needs_drives_at_that_rate() {
    let (mut sim, drive) = from_flow(RATE);
    let (told, target, _) = means(&mut sim, 400);
    assert!((told / RATE - 1.0).abs() < 1e-9, "{told}");
    drive(&mut sim, target);
    let before = run(&mut sim, 20_000);
    let (found, stress, residual) = means(&mut sim, 800);
    report("shear stress over its target", stress / target);
    report("rate of shear over that which needs the stress", found / RATE);
    report("largest residual", before.max(residual));
    assert!((stress / target - 1.0).abs() < 0.02, "{stress} {target}");
    assert!((found / RATE - 1.0).abs() < 0.2, "{found}");
    assert!(before.max(residual) < 1e-3, "{residual}");
}

/// Less than what makes it flow is borne: the packing comes to rest under it, whichever way it draws.
#[test]
fn a_packing_bears_a_shear_stress_below_that_of_flow() {
    for sign in [1.0, -1.0] {
        let target = sign * 0.1 * PRESSURE;
        let (mut sim, drive) = from_flow(RATE);
        drive(&mut sim, target);
        let before = run(&mut sim, 50_000);
        let (rate, stress, residual) = means(&mut sim, 100);
        report("shear stress over its target", stress / target);
        report("rate of shear [1/s]", rate);
        assert!((stress / target - 1.0).abs() < 0.01, "{stress} {target}");
        assert!(rate.abs() < 0.05, "{rate}");
        assert!(before.max(residual) < 1e-3, "{residual}");
    }
}
