//! Demeter's own loop, run in a process of its own so that its memory can be told.

use crate::engines::Loop;
use crate::grains::{FIXED, Fault, Grain, end_file};
use crate::process::peak_memory;
use clap::Args;
use demeter::scenario::{Scenario, prepare};
use demeter::simulation::Simulation;
use rustix::time::{ClockId, clock_gettime};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// What the process is told.
#[derive(Args, Clone, Debug)]
pub struct Task {
    /// The scenario.
    #[arg(long)]
    pub scenario: PathBuf,
    /// Folder that the files it names lie in.
    #[arg(long)]
    pub states: PathBuf,
    /// What changes in it.
    #[arg(long = "set")]
    pub overrides: Vec<String>,
    /// Grains with ids up to this are fixed.
    #[arg(long, default_value_t = 0)]
    pub fixed: u32,
    /// Threads.
    #[arg(long)]
    pub threads: usize,
    /// Steps before the loop.
    #[arg(long)]
    pub relax: u64,
    /// Steps of the loop.
    #[arg(long)]
    pub steps: u64,
    /// File for the grains at the end.
    #[arg(long)]
    pub end: Option<PathBuf>,
}

/// Word with which the line of results begins.
const RESULT: &str = "LOOP ";

/// A simulation of a scenario, whose files lie in a folder, with grains with ids up to `fixed` held where they are.
pub fn simulation(text: &str, folder: &Path, overrides: &[String], fixed: u32) -> Result<Simulation, Fault> {
    let told = |faults: demeter::scenario::Diagnostics| faults.to_string();
    let scenario = Scenario::parse(text, "scenario", folder, overrides).map_err(told)?;
    let mut setup = prepare(&scenario).map_err(told)?.setup;
    let grains = &mut setup.grains;
    for g in 0..grains.len() {
        if grains.id[g] <= fixed {
            grains.velocity.set_scalar(g, 0.0);
            grains.angular_velocity.set_scalar(g, 0.0);
        }
    }
    Ok(Simulation::new(setup))
}

/// The grains of a simulation as they are, sorted by id.
pub fn grains(sim: &Simulation) -> Vec<Grain> {
    let grains = sim.grains();
    let grain = |g: usize| Grain {
        id: grains.id[g],
        kind: if grains.is_fixed(g) { FIXED } else { 1 },
        diameter: 2.0 * grains.radius(g),
        position: grains.position[g],
        velocity: grains.velocity[g],
        spin: grains.angular_velocity[g],
    };
    let mut all: Vec<Grain> = (0..grains.len()).map(grain).collect();
    all.sort_unstable_by_key(|g| g.id);
    all
}

/// Runs a task and prints what its loop took.
pub fn work(task: &Task) -> Result<(), Fault> {
    let text = std::fs::read_to_string(&task.scenario)?;
    let mut sim = simulation(&text, &task.states, &task.overrides, task.fixed)?;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(task.threads).build()?;
    let measured = pool.install(|| timed_loop(&mut sim, task))?;
    println!("{RESULT}{}", serde_json::to_string(&measured)?);
    if let Some(end) = &task.end {
        std::fs::write(end, end_file(&grains(&sim)))?;
    }
    Ok(())
}

fn timed_loop(sim: &mut Simulation, task: &Task) -> Result<Loop, Fault> {
    sim.start()?;
    sim.steps(task.relax)?;
    // from here on the peak is that of the loop; where the system does not allow it, that of all
    let _ = std::fs::write("/proc/self/clear_refs", "5");
    let (wall, cpu, rebuilds) = (Instant::now(), processor_time(), sim.rebuilds());
    sim.steps(task.steps)?;
    Ok(Loop {
        seconds: wall.elapsed().as_secs_f64(),
        cpu: Some(processor_time() - cpu),
        steps: task.steps,
        grains: sim.grains().len(),
        builds: Some(sim.rebuilds() - rebuilds),
        memory: peak_memory(Path::new("/proc/self")),
    })
}

/// Processor time of all threads of this process [s].
fn processor_time() -> f64 {
    let time = clock_gettime(ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}

/// What a process printed of its loop.
pub fn parse(output: &str) -> Result<Loop, Fault> {
    let line = output.lines().find_map(|l| l.strip_prefix(RESULT));
    Ok(serde_json::from_str(line.ok_or("Demeter told no loop")?)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_task_runs_and_is_told() {
        let scenario = include_str!("../../../peers/prepare/bed.toml");
        let mut sim = simulation(scenario, Path::new("."), &["grains[0].count=300".into()], 2).unwrap();
        let task = Task {
            scenario: PathBuf::new(),
            states: PathBuf::new(),
            overrides: Vec::new(),
            fixed: 0,
            threads: 1,
            relax: 3,
            steps: 20,
            end: None,
        };
        let measured = timed_loop(&mut sim, &task).unwrap();
        assert_eq!((measured.steps, measured.grains, sim.step), (20, 300, 23));
        assert!(measured.seconds > 0.0 && measured.cpu.unwrap() > 0.0);
        let printed = format!("something\n{RESULT}{}\n", serde_json::to_string(&measured).unwrap());
        let told = parse(&printed).unwrap();
        assert_eq!(
            (told.steps, told.grains, told.builds, told.memory),
            (20, 300, measured.builds, measured.memory)
        );
        assert!(
            (told.cpu.unwrap() - measured.cpu.unwrap()).abs() < 1e-12
                && (told.seconds - measured.seconds).abs() < 1e-12
        );
        assert!(parse("nothing").is_err());
        let all = grains(&sim);
        assert!(all[..2].iter().all(|g| g.kind == FIXED) && all[2..].iter().all(|g| g.kind == 1));
        assert!(all.windows(2).all(|w| w[0].id < w[1].id) && all.iter().all(|g| g.diameter == 5e-3));
    }
}
