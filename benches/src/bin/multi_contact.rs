//! What contacts that feel each other cost on a dense packing, over independent ones.
//!
//! A packing is squeezed with independent contacts. From that state every model runs slices of steps in turn, while the
//! plate squeezes on slowly; told is the median over the rounds of the ratio to the slice of independent contacts beside it.
#![allow(clippy::print_stdout, reason = "a benchmark prints its table")]

use clap::Parser;
use demeter::contacts::Coupling;
use demeter::contacts::coupling::DEFAULT_TOLERANCE;
use demeter::scenario::{Scenario, prepare};
use demeter::simulation::{Setup, Simulation};
use demeter::walls::Motion;
use demeter_physics::DVec3;
use std::error::Error;
use std::path::Path;
use std::time::Instant;

const SCENARIO: &str = include_str!("../dense_packing.toml");

/// Speed of the plate while steps are timed [m/s].
const SLOW: f64 = 5e-3;

const CONVERGED: Coupling = Coupling::Converged {
    tolerance: DEFAULT_TOLERANCE,
};

/// Law and coupling of every column.
const MODELS: [(&str, Coupling); 7] = [
    ("independent", CONVERGED),
    ("half-space", Coupling::Lagged),
    ("half-space", CONVERGED),
    ("sphere-to-sphere", Coupling::Lagged),
    ("sphere-to-sphere", CONVERGED),
    ("point-on-sphere", Coupling::Lagged),
    ("point-on-sphere", CONVERGED),
];

#[derive(Parser)]
struct Arguments {
    /// Rounds, of which the median is told.
    #[arg(long, default_value_t = 9)]
    rounds: usize,
    /// Steps of one slice.
    #[arg(long, default_value_t = 200)]
    steps: u64,
    /// Steps before the first slice.
    #[arg(long, default_value_t = 2000)]
    settle: u64,
    /// Threads.
    #[arg(long, default_value_t = 1)]
    threads: usize,
    /// Only this coupling.
    #[arg(long, default_value = "")]
    coupling: String,
    /// Only laws whose name contains this, beside independent contacts.
    #[arg(long, default_value = "")]
    only: String,
}

fn main() -> Result<(), Box<dyn Error + Send + Sync>> {
    let arguments = Arguments::parse();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(arguments.threads).build()?;
    pool.install(|| bench(&arguments))
}

fn setup(law: &str) -> Result<Setup, Box<dyn Error + Send + Sync>> {
    let overrides = [format!("contact.multi_contact={{law=\"{law}\"}}")];
    let fault = |d: demeter::scenario::Diagnostics| d.to_string();
    let scenario = Scenario::parse(SCENARIO, "dense_packing.toml", Path::new("."), &overrides).map_err(fault)?;
    Ok(prepare(&scenario).map_err(fault)?.setup)
}

fn squeezed() -> Result<Simulation, Box<dyn Error + Send + Sync>> {
    let mut sim = Simulation::new(setup("independent")?);
    sim.walls[1].set_motion(Motion::Velocity(DVec3::Z * -0.3))?;
    while sim.time() < 0.1 {
        sim.step()?;
    }
    Ok(sim)
}

fn bench(arguments: &Arguments) -> Result<(), Box<dyn Error + Send + Sync>> {
    let start = squeezed()?;
    let models: Vec<_> = MODELS
        .into_iter()
        .filter(|(law, c)| {
            *law == "independent" || law.contains(&arguments.only) && name(*c).contains(&arguments.coupling)
        })
        .collect();
    let mut runs = Vec::new();
    for (law, coupling) in &models {
        let mut sim = Simulation::new(Setup {
            grains: start.grains().clone(),
            coupling: *coupling,
            dt: start.dt(),
            ..setup(law)?
        });
        sim.walls[1].restore(&start.walls[1].state());
        sim.walls[1].set_motion(Motion::Velocity(DVec3::Z * -SLOW))?;
        // comes to rest under the new law, and everything has its memory
        sim.steps(arguments.settle)?;
        runs.push(sim);
    }
    let mut times = vec![Vec::new(); runs.len()];
    let before: Vec<_> = runs.iter().map(Simulation::coupling_effort).collect();
    for _ in 0..arguments.rounds {
        for (sim, times) in runs.iter_mut().zip(&mut times) {
            let begun = Instant::now();
            sim.steps(arguments.steps)?;
            times.push(begun.elapsed().as_secs_f64());
        }
    }
    let contacts = |sim: &Simulation| sim.contacts.pair_count() + sim.contacts.wall_count();
    println!("{} grains, {} threads", start.grains().len(), arguments.threads);
    println!(
        "| law | coupling | ns per grain and step | over independent | iterations per step | repeats per step | contacts |"
    );
    println!("|---|---|---|---|---|---|---|");
    for (k, ((law, coupling), sim)) in models.iter().zip(&runs).enumerate() {
        let ratios: Vec<f64> = times[k].iter().zip(&times[0]).map(|(t, one)| t / one).collect();
        let steps = arguments.steps as f64 * sim.grains().len() as f64;
        let (effort, first) = (sim.coupling_effort(), before[k]);
        let solved = (effort.solutions - first.solutions).max(1) as f64;
        println!(
            "| {law} | {} | {:.0} | {:.2} | {:.2} | {:.3} | {} |",
            name(*coupling),
            median(&times[k]) / steps * 1e9,
            median(&ratios),
            (effort.iterations - first.iterations) as f64 / solved,
            (effort.repeats - first.repeats) as f64 / (arguments.rounds as u64 * arguments.steps) as f64,
            contacts(sim),
        );
    }
    Ok(())
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}

fn name(coupling: Coupling) -> &'static str {
    match coupling {
        Coupling::Lagged => "lagged",
        Coupling::Converged { .. } => "converged",
    }
}
