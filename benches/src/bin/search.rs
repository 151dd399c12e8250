//! What the search for candidates costs: on loose and dense packings of one size, and of sizes 1:10 and 1:100; and a whole
//! rebuild with contacts that are carried over.
//!
//! Told is the fastest of the rounds, as others may share the machine. Grains move a little between two searches, so that nothing is searched twice.
#![allow(clippy::print_stdout, reason = "a benchmark prints its table")]

use clap::Parser;
use demeter::comm::Single;
use demeter::neighbours::{Neighbours, put_in_order};
use demeter::scenario::{Scenario, prepare};
use demeter::simulation::{Setup, Simulation, Skin};
use demeter_physics::DVec3;
use std::error::Error;
use std::path::Path;
use std::time::Instant;

type Outcome<T> = Result<T, Box<dyn Error + Send + Sync>>;

#[derive(Parser)]
struct Arguments {
    /// Grains of every packing.
    #[arg(long, default_value_t = 20_000)]
    count: u32,
    /// Rounds, of which the fastest is told.
    #[arg(long, default_value_t = 31)]
    rounds: usize,
    /// Skin, as a share of the mean diameter.
    #[arg(long, default_value_t = 0.1)]
    skin: f64,
    /// Steps of a run with a skin that is tuned, after as many to begin with; 0 for none.
    #[arg(long, default_value_t = 1000)]
    steps: u64,
    /// Threads.
    #[arg(long, default_value_t = 1)]
    threads: usize,
    /// Only packings whose name contains this.
    #[arg(long, default_value = "")]
    only: String,
}

/// What is packed.
#[derive(Clone, Copy)]
struct Packing {
    name: &'static str,
    /// Ratio of the largest to the smallest diameter.
    ratio: f64,
    /// Share of the volume that grains fill.
    fraction: f64,
    /// Grains of the largest size beside those that are drawn: few are as large among as many as fit into a benchmark.
    largest: u32,
}

const PACKINGS: [Packing; 6] = [
    Packing::drawn("one size, dilute", 1.0, 0.05),
    Packing::drawn("one size, loose", 1.0, 0.3),
    Packing::drawn("one size, dense", 1.0, 0.6),
    Packing::drawn("1:10, dense", 10.0, 0.58),
    Packing::drawn("1:100, dense", 100.0, 0.58),
    Packing {
        largest: 1,
        ..Packing::drawn("largest of 1:100, dense", 100.0, 0.5)
    },
];

impl Packing {
    const fn drawn(name: &'static str, ratio: f64, fraction: f64) -> Self {
        Self {
            name,
            ratio,
            fraction,
            largest: 0,
        }
    }

    fn is_asked(&self, arguments: &Arguments) -> bool {
        // the largest grain alone fills a box of fewer
        self.name.contains(&arguments.only) && (self.largest == 0 || arguments.count >= 100_000)
    }
}

fn main() -> Outcome<()> {
    let arguments = Arguments::parse();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(arguments.threads).build()?;
    pool.install(|| bench(&arguments))
}

/// A diameter [mm], or sizes with equal volume per logarithm of the size (`p(d) ~ d^-4` by number).
fn diameters(ratio: f64) -> (String, f64) {
    if ratio == 1.0 {
        return ("\"1 mm\"".into(), 1.0);
    }
    let points: Vec<f64> = (0..=40).map(|k| ratio.powf(f64::from(k) / 40.0)).collect();
    let list = |values: &mut dyn Iterator<Item = String>| values.collect::<Vec<_>>().join(", ");
    let sizes = list(&mut points.iter().map(|d| format!("\"{d} mm\"")));
    let finer = list(&mut (0..=40).map(|k| format!("{}", f64::from(k) / 40.0)));
    // mean volume of a grain over pi/6, with as much volume per logarithm of the size everywhere
    let mean_cube = 3.0 * ratio.ln() / (1.0 - ratio.powi(-3));
    (
        format!("{{ distribution = \"table\", basis = \"mass\", diameters = [{sizes}], finer = [{finer}] }}"),
        mean_cube,
    )
}

/// Grains in a box that they fill as told.
fn packing(
    count: u32,
    Packing {
        ratio,
        fraction,
        largest,
        ..
    }: Packing,
) -> Outcome<Setup> {
    let (diameter, mean_cube) = diameters(ratio);
    let cubes = f64::from(count) * mean_cube + f64::from(largest) * ratio.powi(3);
    let edge = (cubes * std::f64::consts::FRAC_PI_6 / fraction).cbrt();
    // it comes first: what is there stays where it is, and others find room around it
    let large = if largest == 0 {
        String::new()
    } else {
        format!(
            r#"
[[grains]]
material = "m"
source = "random"
region = {{ shape = "box", lower = "0 0 0 mm", upper = "{edge} {edge} {edge} mm" }}
diameter = "{ratio} mm"
count = {largest}
"#
        )
    };
    // the largest grains of a wide mixture are too large for a periodic box of so few
    let periodic = if ratio > 10.0 { "" } else { "\"x\", \"y\", \"z\"" };
    let text = format!(
        r#"
title = "packing"
[simulation]
max_overlap = 0.5
[domain]
lower = "0 0 0 mm"
upper = "{edge} {edge} {edge} mm"
periodic = [{periodic}]
[material.m]
young_modulus = "10 MPa"
poisson_ratio = 0.3
density = "2500 kg/m^3"
[contact]
normal = {{ law = "hertz-tsuji", restitution = 0.5 }}
tangential = {{ law = "mindlin-history", friction = 0.5 }}
{large}
[[grains]]
material = "m"
source = "random"
region = {{ shape = "box", lower = "0 0 0 mm", upper = "{edge} {edge} {edge} mm" }}
diameter = {diameter}
count = {count}

[[stage]]
name = "none"
duration = "1 s"
"#
    );
    let fault = |d: demeter::scenario::Diagnostics| d.to_string();
    let scenario = Scenario::parse(&text, "packing.toml", Path::new("."), &[]).map_err(fault)?;
    Ok(prepare(&scenario).map_err(fault)?.setup)
}

fn bench(arguments: &Arguments) -> Outcome<()> {
    println!(
        "{} grains, skin {} mean diameters, {} threads",
        arguments.count, arguments.skin, arguments.threads
    );
    println!(
        "| packing | sizes | search, ns/grain | candidates/grain | distance tests/grain | order along the curve, ns/grain | \
         rebuild, ns/grain | contacts/grain | table, B/grain |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for asked in PACKINGS.iter().filter(|packing| packing.is_asked(arguments)) {
        measure(arguments, asked.name, packing(arguments.count, *asked)?)?;
    }
    if arguments.steps == 0 {
        return Ok(());
    }
    println!();
    println!("The tuned skin, from {} mean diameters on:", arguments.skin);
    println!(
        "| packing | speed, diameters per step | skin, mean diameters | steps between rebuilds | candidates/grain | contacts/grain | ns per grain and step | rebuilds, share of the time |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for asked in PACKINGS
        .iter()
        .filter(|packing| packing.is_asked(arguments) && packing.ratio <= 10.0)
    {
        let (name, setup) = (asked.name, packing(arguments.count, *asked)?);
        let idle = idle_candidate(arguments, &setup)?;
        println!(
            "| {name} | a candidate that is no contact costs {:.1} ns per step |",
            idle * 1e9
        );
        for speed in [0.0, 1e-5, 1e-4, 3e-4] {
            tune(arguments, name, setup.clone(), speed)?;
        }
    }
    Ok(())
}

/// What a candidate that is no contact costs in a step [s]: from two runs at rest, with a narrow and a wide skin.
fn idle_candidate(arguments: &Arguments, setup: &Setup) -> Outcome<f64> {
    let n = setup.grains.len() as f64;
    let mean = 2.0 * setup.grains.radii().sum::<f64>() / n;
    let run = |share: f64| -> Outcome<(f64, f64)> {
        let skin = Skin::Fixed(share * mean);
        let mut sim = Simulation::new(Setup { skin, ..setup.clone() });
        sim.step()?;
        let times: Vec<f64> = (0..arguments.steps).map(|_| timed(|| drop(sim.step()))).collect();
        Ok((
            fastest(&times),
            sim.candidates() as f64 - sim.contacts.pair_count() as f64,
        ))
    };
    let (narrow, wide) = (run(0.02)?, run(0.2)?);
    Ok((wide.0 - narrow.0) / (wide.1 - narrow.1))
}

/// Grains that fly through each other's places: from a packing, at a speed in mean diameters per step.
fn tune(arguments: &Arguments, name: &str, mut setup: Setup, speed: f64) -> Outcome<()> {
    let n = setup.grains.len() as f64;
    let mean = 2.0 * setup.grains.radii().sum::<f64>() / n;
    let mut state = 1u64;
    for velocity in setup.grains.velocity.iter_mut() {
        let mut component = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            2.0 * ((state >> 11) as f64 / (1u64 << 53) as f64) - 1.0
        };
        *velocity = DVec3::new(component(), component(), component()) * (speed * mean / setup.dt);
    }
    setup.skin = Skin::Tuned(arguments.skin * mean);
    let mut sim = Simulation::new(setup);
    sim.steps(arguments.steps)?;
    let before = sim.rebuilds();
    let begun = Instant::now();
    sim.steps(arguments.steps)?;
    let time = begun.elapsed().as_secs_f64();
    let rebuilds = (sim.rebuilds() - before) as f64;
    let one = fastest(&(0..5).map(|_| timed(|| sim.find_candidates())).collect::<Vec<_>>());
    println!(
        "| {name} | {speed:.0e} | {:.3} | {:.0} | {:.2} | {:.2} | {:.0} | {:.0} % |",
        sim.skin() / mean,
        arguments.steps as f64 / rebuilds.max(1.0),
        sim.candidates() as f64 / n,
        sim.contacts.pair_count() as f64 / n,
        time / n / arguments.steps as f64 * 1e9,
        100.0 * rebuilds * one / time,
    );
    Ok(())
}

/// Seconds of one call.
fn timed(work: impl FnOnce()) -> f64 {
    let begun = Instant::now();
    work();
    begun.elapsed().as_secs_f64()
}

fn measure(arguments: &Arguments, name: &str, setup: Setup) -> Outcome<()> {
    let mut grains = setup.grains.clone();
    let n = grains.len() as f64;
    let comm = Single::new(setup.domain);
    let mean = 2.0 * grains.radii().sum::<f64>() / n;
    let skin = arguments.skin * mean;
    let mut found = Neighbours::default();
    let radii = |fold: fn(f64, f64) -> f64| grains.radii().reduce(fold).unwrap_or(f64::NAN);
    let sizes = format!("1:{:.1}", radii(f64::max) / radii(f64::min));
    let (mut search, mut sort) = (vec![], vec![]);
    let mut state = 1u64;
    for _ in 0..arguments.rounds {
        let mut random = || {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        for position in grains.position.iter_mut() {
            position.x += 0.05 * skin * random();
        }
        comm.wrap(&mut grains);
        sort.push(timed(|| drop(put_in_order(&mut grains))));
        search.push(timed(|| found.find(&grains, &[], &setup.materials, &comm, skin)));
    }
    // grains of the same places, all a little larger by as much: those that nearly touched do
    let mut squeezed = setup;
    for g in 0..squeezed.grains.len() {
        let (radius, mass) = (squeezed.grains.radius(g), squeezed.grains.mass(g));
        squeezed.grains.set_size(g, radius + 0.005 * mean, mass);
    }
    squeezed.skin = Skin::Fixed(skin);
    let mut sim = Simulation::new(squeezed);
    sim.step()?;
    let rebuild: Vec<f64> = (0..arguments.rounds).map(|_| timed(|| sim.find_candidates())).collect();
    println!(
        "| {name} | {sizes} | {:.0} | {:.2} | {:.1} | {:.0} | {:.0} | {:.2} | {:.0} |",
        fastest(&search) / n * 1e9,
        found.pair_count() as f64 / n,
        found.effort().tests as f64 / n,
        fastest(&sort) / n * 1e9,
        fastest(&rebuild) / n * 1e9,
        sim.contacts.pair_count() as f64 / n,
        found.bytes(grains.len()) as f64 / n,
    );
    Ok(())
}

fn fastest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}
