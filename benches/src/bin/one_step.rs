//! A bed for counting work: dense, of one Hertz-Mindlin material, made in the process and the same everywhere. `cargo xtask
//! instructions` runs it under callgrind with few and with more steps; the difference is what the steps cost.
#![allow(clippy::print_stdout, reason = "the count is read from what it prints")]

use clap::Parser;
use demeter::particles::{Grains, NewGrain};
use demeter::scenario::{Scenario, prepare};
use demeter::simulation::{Setup, Simulation, Skin};
use demeter_physics::DVec3;
use demeter_physics::lanes::Instructions;
use rand::{Rng, SeedableRng};
use rand_pcg::Pcg64;
use std::error::Error;
use std::path::Path;

type Outcome<T> = Result<T, Box<dyn Error + Send + Sync>>;

#[derive(Parser)]
struct Arguments {
    /// Steps.
    #[arg(long)]
    steps: u64,
    /// `portable`, `avx2`, `avx512` or `neon`.
    #[arg(long, value_parser = Instructions::named)]
    instructions: Instructions,
}

/// Cells of the lattice along each edge; two grains in each.
const CELLS: u32 = 10;

/// Diameter of the grains [m].
const DIAMETER: f64 = 1e-3;
/// Distance of nearest neighbours over the diameter: every grain overlaps eight others.
const SPACING: f64 = 0.995;
/// Distance beyond touching at which grains become candidates, over the diameter: beyond the next but one neighbours.
const SKIN: f64 = 0.18;
/// Largest speed in each direction [m/s]: candidates go stale now and then.
const SPEED: f64 = 2.0;

/// Materials, laws and time step, with one grain that the bed takes the place of.
fn scene(edge: f64) -> Outcome<Setup> {
    let text = format!(
        r#"
title = "bed"
[simulation]
max_overlap = 0.5
gravity = "0 0 -9.81 m/s^2"
[domain]
lower = "0 0 0 m"
upper = "{edge} {edge} {edge} m"
periodic = ["x", "y", "z"]
[material.m]
young_modulus = "10 MPa"
poisson_ratio = 0.3
density = "2500 kg/m^3"
[contact]
normal = {{ law = "hertz-tsuji", restitution = 0.5 }}
tangential = {{ law = "mindlin-history", friction = 0.5 }}
[[grains]]
material = "m"
source = "list"
diameter = "{DIAMETER} m"
positions = ["{DIAMETER} {DIAMETER} {DIAMETER} m"]
[[stage]]
name = "none"
duration = "1 s"
"#
    );
    let fault = |d: demeter::scenario::Diagnostics| d.to_string();
    let scenario = Scenario::parse(&text, "bed.toml", Path::new("."), &[]).map_err(fault)?;
    Ok(prepare(&scenario).map_err(fault)?.setup)
}

/// A body-centred lattice in a periodic box, pressed together, with random velocities.
fn bed() -> Outcome<Simulation> {
    let cell = SPACING * DIAMETER * 2.0 / 3f64.sqrt();
    let mut setup = scene(cell * f64::from(CELLS))?;
    setup.grains = Grains::default();
    setup.skin = Skin::Fixed(SKIN * DIAMETER);
    let mut numbers = Pcg64::seed_from_u64(1);
    let mut random = || SPEED * (2.0 * ((numbers.next_u64() >> 11) as f64 / (1u64 << 53) as f64) - 1.0);
    let site = |k: u32| {
        DVec3::new(
            f64::from(k % CELLS),
            f64::from(k / CELLS % CELLS),
            f64::from(k / CELLS / CELLS),
        )
    };
    for k in 0..CELLS.pow(3) {
        for shift in [0.25, 0.75] {
            let grain = NewGrain {
                material: 0,
                radius: 0.5 * DIAMETER,
                density: 2500.0,
                position: (site(k) + shift) * cell,
                velocity: DVec3::new(random(), random(), random()),
                angular_velocity: DVec3::ZERO,
                fixed: false,
            };
            let id = setup.grains.len() as u32 + 1;
            setup.grains.push(id, &grain);
        }
    }
    Ok(Simulation::new(setup))
}

fn main() -> Outcome<()> {
    let arguments = Arguments::parse();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    pool.install(|| {
        let mut sim = bed()?;
        sim.set_instructions(arguments.instructions);
        sim.steps(arguments.steps)?;
        let work = sim.work();
        println!(
            "grains {} candidates {} contacts {} rebuilds {}",
            work.grains,
            work.candidates,
            work.contacts,
            sim.rebuilds()
        );
        Ok(())
    })
}
