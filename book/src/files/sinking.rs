//! Grains that sink in a liquid: a program of its own, with a force that no contact law has.

use demeter::scenario::{LiveRun, Observer, Progress, RunOptions, Scenario, Until};
use demeter::simulation::{CustomForce, ForceMoment, GrainLoads};
use std::error::Error;
use std::f64::consts::PI;
use std::path::Path;

const SCENARIO: &str = r#"
[simulation]
gravity = "0 0 -9.81 m/s^2"

[material.glass]
young_modulus = "10 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"

[contact]
normal = { law = "hertz-tsuji", restitution = 0.8 }
tangential = { law = "mindlin-history", friction = 0.4 }

[[grains]]
material = "glass"
source = "list"
positions = ["0 0 0.5 mm", "0 0 2 mm"]
diameter = "0.5 mm"

[[wall]]
name = "floor"
material = "glass"
shape = "plane"
point = "0 0 0 mm"
normal = "z"

[[stage]]
name = "sink"
duration = "50 ms"

[output]
series = "5 ms"
"#;

/// Viscosity of the liquid [Pa s].
const VISCOSITY: f64 = 0.1;

/// The drag [N] of a sphere in a viscous liquid, `-6 pi eta r v` (Stokes 1851).
struct Drag;

impl CustomForce for Drag {
    fn loads(&mut self, moment: &ForceMoment, loads: &mut GrainLoads) -> Result<(), String> {
        let grains = moment.grains;
        for g in 0..grains.len() {
            loads.force[g] = -6.0 * PI * VISCOSITY * grains.radius(g) * grains.velocity[g];
        }
        Ok(())
    }
}

/// Prints what the run has to say.
struct Console;

impl Observer for Console {
    fn progress(&mut self, _: &Progress) -> bool {
        // `false` ends the run with a checkpoint
        true
    }

    fn message(&mut self, text: &str) {
        println!("{text}");
    }
}

pub fn main() -> Result<(), Box<dyn Error>> {
    let scenario = Scenario::parse(SCENARIO, "sinking", Path::new(""), &[]).map_err(|faults| faults.render(false))?;
    // without a folder nothing is written, and the series stays in memory
    let mut run = LiveRun::new(scenario, None, RunOptions::default(), &mut Console)?;
    run.change(|sim| sim.add_force(Box::new(Drag)));

    // ten milliseconds, and a look at the grains
    let dt = run.with_simulation(|sim| sim.dt());
    let until = Until {
        step: Some((10e-3 / dt).round() as u64),
        ..Until::default()
    };
    run.advance(&until, &mut Console)?;
    run.with_simulation(|sim| {
        let (grains, time) = (sim.grains(), sim.time());
        for g in 0..grains.len() {
            // m dv/dt = -m g - 6 pi eta r v, from rest
            let relaxation = grains.mass(g) / (6.0 * PI * VISCOSITY * grains.radius(g));
            let expected = -9.81 * relaxation * (1.0 - (-time / relaxation).exp());
            let found = grains.velocity[g].z;
            println!("grain {}: {found:.6e} m/s, {expected:.6e} expected", grains.id[g]);
            assert!((found / expected - 1.0).abs() < 1e-3);
        }
    });

    // to the end of the protocol
    run.advance(&Until::default(), &mut Console)?;
    let energies = run.change(|sim| sim.energies());
    println!(
        "work of the drag {:.4e} J, residual {:.1e}",
        energies.custom_work, energies.residual
    );
    assert!(energies.custom_work < 0.0 && energies.residual.abs() < 1e-3);
    Ok(())
}
