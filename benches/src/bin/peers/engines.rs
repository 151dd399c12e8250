//! The engines: how each is started, and what it tells of its loop.

use crate::agreement::Tolerance;
use crate::demeter_loop;
use crate::grains::{Fault, State};
use crate::process::{self, Ended, find_program};
use crate::workloads::{EngineWalls, Kind, POISSON, Variable, Workload};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// Longest that one run may take.
const PATIENCE: Duration = Duration::from_secs(3600);

/// What an engine tells of its loop.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Loop {
    /// Seconds of the loop on the clock.
    pub seconds: f64,
    /// Seconds on cores, of all threads or ranks.
    pub cpu: Option<f64>,
    /// Steps.
    pub steps: u64,
    /// Grains.
    pub grains: usize,
    /// How often candidates were found anew.
    pub builds: Option<u64>,
    /// Peak of the memory in the loop, set-up left out [bytes].
    pub memory: Option<u64>,
}

/// An engine and the way it is run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Engine {
    /// Demeter, in a process of its own.
    Demeter,
    /// LAMMPS with one of its styles.
    Lammps {
        /// The program.
        program: PathBuf,
        /// What starts more than one rank.
        launcher: Option<PathBuf>,
        /// Its version.
        version: String,
        /// Which of the styles of the workload.
        style: usize,
    },
    /// LIGGGHTS.
    Liggghts {
        /// The program.
        program: PathBuf,
        /// What starts more than one rank.
        launcher: Option<PathBuf>,
    },
    /// YADE.
    Yade {
        /// The program.
        program: PathBuf,
    },
}

/// Where things lie.
#[derive(Clone, Debug)]
pub struct Places {
    /// Start states.
    pub states: PathBuf,
    /// What is kept; every engine runs here, with its inputs in `inputs`.
    pub kept: PathBuf,
}

/// One run that is asked of an engine.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// The workload.
    pub workload: &'a Workload,
    /// Its start.
    pub state: &'a State,
    /// Steps of the loop.
    pub steps: u64,
    /// Threads or ranks.
    pub threads: usize,
    /// File for the grains at the end, if they are wanted.
    pub end: Option<&'a Path>,
    /// Where things lie.
    pub places: &'a Places,
    /// Stem of the names of what this run leaves.
    pub name: &'a str,
}

impl Engine {
    /// How it is called in the table.
    pub fn label(&self, workload: &Workload) -> String {
        match self {
            Self::Demeter => "Demeter".into(),
            Self::Lammps { version, .. } => format!("LAMMPS {version} {}", self.style(workload).unwrap_or_default()),
            Self::Liggghts { .. } => "LIGGGHTS".into(),
            Self::Yade { .. } => "YADE".into(),
        }
    }

    /// Its style of LAMMPS for a workload, if there is one.
    fn style(&self, workload: &Workload) -> Option<&'static str> {
        match self {
            Self::Lammps { style, .. } => workload.lammps_styles().get(*style).copied(),
            _ => None,
        }
    }

    /// How closely it must agree with Demeter.
    pub fn tolerance(&self, workload: &Workload) -> Tolerance {
        match self {
            // the faster style has other dashpots than the law from E, nu and e; that of the chute is the same
            Self::Lammps { style: 1, .. } if workload.kind != Kind::Chute => workload.tolerance.with_other_dashpots(),
            _ => workload.tolerance,
        }
    }

    /// What is particular about its walls.
    pub fn walls(&self, kind: Kind) -> EngineWalls {
        let plain = EngineWalls::PLAIN;
        match self {
            // `hertz/material` at a wall: E/(2 (1 - nu)) in place of E/(2 (1 - nu^2)) in 2021, no longer in 2025
            Self::Lammps { style: 0, version, .. } if year(version) < 2022 => EngineWalls {
                stiffness: 1.0 + POISSON,
                ..plain
            },
            Self::Demeter | Self::Lammps { .. } => plain,
            Self::Liggghts { .. } => EngineWalls { faceted: true, ..plain },
            Self::Yade { .. } => {
                // the wall is taken for a sphere: as large as the grain at a plane, of twice its radius at a facet
                let share: f64 = if kind == Kind::Drum { 2.0 / 3.0 } else { 0.5 };
                EngineWalls {
                    stiffness: share.sqrt(),
                    faceted: true,
                }
            }
        }
    }

    /// Whether more threads are further processes.
    pub fn has_ranks(&self) -> bool {
        matches!(self, Self::Lammps { .. } | Self::Liggghts { .. })
    }

    /// Whether it can do a job.
    pub fn can(&self, job: &Job) -> bool {
        match self {
            Self::Demeter => true,
            Self::Lammps { launcher, .. } => {
                self.style(job.workload).is_some() && (job.threads == 1 || launcher.is_some())
            }
            Self::Liggghts { launcher, .. } => job.workload.liggghts() && (job.threads == 1 || launcher.is_some()),
            Self::Yade { .. } => job.workload.yade(),
        }
    }

    /// Does a job.
    pub fn run(&self, job: &Job) -> Result<(Loop, Ended), Fault> {
        let log = |ending: &str| job.places.kept.join("logs").join(format!("{}.{ending}", job.name));
        let own_log = log("log");
        let (command, own) = match self {
            Self::Demeter => (demeter(job)?, false),
            Self::Lammps { program, launcher, .. } => {
                let mut command = ranks(program, launcher.as_deref(), job.threads)?;
                let file = format!("inputs/{}.lmp", job.workload.kind.input());
                command.args(["-in", &file, "-screen", "none", "-log"]).arg(&own_log);
                let model = self.style(job.workload).unwrap_or_default();
                let model = [("model", model.to_owned())];
                pass(&mut command, variables(job).into_iter().chain(model));
                (command, true)
            }
            Self::Liggghts { program, launcher } => {
                let mut command = ranks(program, launcher.as_deref(), job.threads)?;
                let file = format!("inputs/{}.lig", job.workload.kind.input());
                command.args(["-in", &file, "-log"]).arg(&own_log);
                let mesh = [("mesh", format!("inputs/{}.stl", job.workload.kind.input()))];
                pass(&mut command, variables(job).into_iter().chain(mesh));
                (command, true)
            }
            Self::Yade { program } => (yade(program, job), false),
        };
        let ended = process::run(command, &job.places.kept, &log("out"), PATIENCE)?;
        let text = if own {
            std::fs::read_to_string(&own_log)?
        } else {
            String::new()
        };
        let found = match self {
            Self::Demeter => demeter_loop::parse(&ended.output),
            Self::Lammps { .. } => parse_lammps(&text),
            Self::Liggghts { .. } => parse_liggghts(&text, &ended.output),
            Self::Yade { .. } => parse_yade(&ended.output),
        };
        let found = found.map_err(|e| format!("{}: {e}", log(if own { "log" } else { "out" }).display()))?;
        if found.steps != job.steps || found.grains != job.state.grains.len() {
            let (steps, grains) = (found.steps, found.grains);
            return Err(format!("{}: its loop had {steps} steps of {grains} grains", job.name).into());
        }
        Ok((found, ended))
    }
}

fn demeter(job: &Job) -> Result<Command, Fault> {
    let scenario = job.places.kept.join(format!("inputs/{}.toml", job.workload.key));
    std::fs::write(&scenario, job.workload.kind.scenario())?;
    let mut command = Command::new(std::env::current_exe()?);
    command
        .arg("work")
        .arg("--scenario")
        .arg(scenario)
        .arg("--states")
        .arg(&job.places.states);
    for change in job.workload.overrides(job.state) {
        command.args(["--set", &change]);
    }
    command.args(["--fixed", &job.workload.fixed().to_string()]);
    let [threads, relax, steps] = [job.threads as u64, job.workload.relax, job.steps].map(|n| n.to_string());
    command.args(["--threads", &threads, "--relax", &relax, "--steps", &steps]);
    if let Some(end) = job.end {
        command.arg("--end").arg(end);
    }
    Ok(command)
}

fn yade(program: &Path, job: &Job) -> Command {
    let mut command = Command::new(program);
    let script = format!("inputs/{}.py", job.workload.kind.input());
    command.args(["-n", "-x", &format!("-j{}", job.threads), &script]);
    let data = job.places.states.join(format!("{}.txt", job.workload.state));
    let mut told = vec![
        ("data", data.display().to_string()),
        ("nrelax", job.workload.relax.to_string()),
        ("nrun", job.steps.to_string()),
    ];
    if let Some(end) = job.end {
        told.push(("dumpto", end.display().to_string()));
    }
    told.extend(job.workload.yade_arguments(job.state));
    let lines: Vec<String> = told.iter().map(|(key, value)| format!("{key}={value}")).collect();
    command
        .env("PEERS", lines.join("\n"))
        .env("OMP_NUM_THREADS", job.threads.to_string());
    command
}

/// A program on some ranks.
fn ranks(program: &Path, launcher: Option<&Path>, count: usize) -> Result<Command, Fault> {
    let mut command = if count == 1 {
        Command::new(program)
    } else {
        let launcher = launcher.ok_or("no `mpirun`")?;
        let mut command = Command::new(launcher);
        if launcher.ends_with("mpirun") {
            command.args(["--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]);
        }
        command.args(["-np", &count.to_string()]).arg(program);
        command
    };
    command.env("OMP_NUM_THREADS", "1");
    if let Some(libraries) = libraries_of(launcher) {
        command.env("LD_LIBRARY_PATH", libraries);
    }
    Ok(command)
}

/// The libraries of a launcher in a Python environment, which programs of that environment need, too.
fn libraries_of(launcher: Option<&Path>) -> Option<PathBuf> {
    let libraries = launcher?.parent()?.parent()?.join("lib");
    libraries.join("libmpi.so.12").is_file().then_some(libraries)
}

/// Variables that every input of LAMMPS and LIGGGHTS asks for.
fn variables(job: &Job) -> Vec<Variable> {
    let data = job.places.states.join(format!("{}.data", job.workload.state));
    let end = job.end.map_or_else(|| "none".into(), |path| path.display().to_string());
    let mut all = vec![
        ("data", data.display().to_string()),
        ("nrelax", job.workload.relax.to_string()),
        ("nrun", job.steps.to_string()),
        ("dodump", u8::from(job.end.is_some()).to_string()),
        ("dumpto", end),
    ];
    all.extend(job.workload.variables(job.state));
    all
}

fn pass(command: &mut Command, variables: impl Iterator<Item = Variable>) {
    for (name, value) in variables {
        command.args(["-var", name, &value]);
    }
}

/// The version that LAMMPS tells of itself: `29 Sep 2021`.
pub fn lammps_version(program: &Path) -> Result<String, Fault> {
    let mut command = ranks(program, launcher_of(program).as_deref(), 1)?;
    let told = command
        .arg("-h")
        .output()
        .map_err(|e| format!("{}: {e}", program.display()))?;
    let text = String::from_utf8_lossy(&told.stdout);
    let line = text
        .lines()
        .find_map(|l| l.split_once("Massively Parallel Simulator - "));
    let (_, version) = line.ok_or_else(|| format!("{} does not tell its version", program.display()))?;
    Ok(version.split(" - ").next().unwrap_or(version).trim().to_owned())
}

/// The year of a version such as `29 Sep 2021`.
fn year(version: &str) -> u32 {
    version
        .rsplit(' ')
        .next()
        .and_then(|word| word.parse().ok())
        .unwrap_or(u32::MAX)
}

/// The launcher of ranks that belongs to a program: that of the Python environment in which it lies, or that on the path.
pub fn launcher_of(program: &Path) -> Option<PathBuf> {
    let environment = program.ancestors().find(|folder| folder.join("pyvenv.cfg").is_file());
    let own = environment
        .map(|folder| folder.join("bin/mpiexec"))
        .filter(|path| path.is_file());
    own.or_else(|| find_program("mpirun"))
}

/// The last `Loop time of ...` with steps in a log of LAMMPS or LIGGGHTS, its number of ranks, and what follows it.
fn last_loop(log: &str) -> Result<(Loop, f64, &str), Fault> {
    const TITLE: &str = "Loop time of ";
    for (at, _) in log.rmatch_indices(TITLE) {
        let rest = &log[at + TITLE.len()..];
        let line = rest.lines().next().unwrap_or_default();
        let words: Vec<&str> = line.split_whitespace().collect();
        let [seconds, "on", ranks, "procs", "for", steps, "steps", "with", grains, ..] = words.as_slice() else {
            return Err(format!("`{TITLE}{line}` is not understood").into());
        };
        let builds = rest.lines().find_map(|l| l.strip_prefix("Neighbor list builds = "));
        let found = Loop {
            seconds: seconds.parse()?,
            cpu: None,
            steps: steps.parse()?,
            grains: grains.parse()?,
            builds: builds.and_then(|b| b.trim().parse().ok()),
            memory: None,
        };
        if found.steps > 0 {
            return Ok((found, ranks.parse()?, rest));
        }
    }
    Err("no line `Loop time of` with steps".into())
}

fn parse_lammps(log: &str) -> Result<Loop, Fault> {
    let (found, ranks, rest) = last_loop(log)?;
    let share = rest.lines().find_map(|l| l.split_once("% CPU use with "));
    let (share, _) = share.ok_or("no line `% CPU use with`")?;
    Ok(Loop {
        cpu: Some(share.trim().parse::<f64>()? / 100.0 * found.seconds * ranks),
        ..found
    })
}

/// Nanoseconds, first of three numbers on a line, in every note that LIGGGHTS made of its time on a core.
fn notes(output: &str) -> Vec<f64> {
    let note = |line: &str| {
        let numbers: Option<Vec<f64>> = line
            .split_whitespace()
            .map(|w| w.parse::<u64>().ok().map(|n| n as f64))
            .collect();
        numbers.filter(|n| n.len() == 3).map(|n| n[0])
    };
    output.lines().filter_map(note).collect()
}

fn parse_liggghts(log: &str, output: &str) -> Result<Loop, Fault> {
    let (found, ranks, _) = last_loop(log)?;
    // notes: before and after a run of no steps, and after the loop; the rank that notes stands for the others
    let cpu = match notes(output).as_slice() {
        [first, set_up, end] => Some(((end - set_up) - (set_up - first)) * 1e-9 * ranks),
        _ => None,
    };
    Ok(Loop { cpu, ..found })
}

fn parse_yade(output: &str) -> Result<Loop, Fault> {
    let line = output
        .lines()
        .find(|l| l.starts_with("PEERS "))
        .ok_or("no line `PEERS loop`")?;
    let words: Vec<&str> = line.split_whitespace().collect();
    let ["PEERS", "loop", seconds, "cpu", cpu, "steps", steps, "grains", grains] = words.as_slice() else {
        return Err(format!("`{line}` is not understood").into());
    };
    Ok(Loop {
        seconds: seconds.parse()?,
        cpu: Some(cpu.parse()?),
        steps: steps.parse()?,
        grains: grains.parse()?,
        builds: None,
        memory: None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAMMPS: &str = "Loop time of 0.9 on 1 procs for 200 steps with 20000 atoms\n\n99.0% CPU use with 1 MPI tasks\n\
        Neighbor list builds = 1\nLoop time of 3.25 on 2 procs for 1000 steps with 20000 atoms\n\n\
        97.0% CPU use with 2 MPI tasks x 1 OpenMP threads\n\nPair    | 2.1        | 2.2 |\n\
        Neighbor list builds = 7\nDangerous builds = 0\n";

    #[test]
    fn the_last_loop_of_lammps_counts() {
        let found = parse_lammps(LAMMPS).unwrap();
        assert_eq!(
            (found.seconds, found.steps, found.grains, found.builds),
            (3.25, 1000, 20_000, Some(7))
        );
        assert!((found.cpu.unwrap() - 0.97 * 3.25 * 2.0).abs() < 1e-12);
        assert!(parse_lammps("ERROR: no such file").is_err());
        assert!(parse_lammps(&LAMMPS.replace("% CPU use", "")).is_err());
        assert!(parse_lammps(&LAMMPS.replace("1000 steps", "steps")).is_err());
    }

    #[test]
    fn the_set_up_of_liggghts_is_taken_off() {
        let log = "Loop time of 3.95e-1 on 1 procs for 100 steps with 500 atoms, finish time Sat Nov 21 2026\n\n\
            Neighbor list builds = 4\nLoop time of 7e-07 on 1 procs for 0 steps with 500 atoms, finish time Sat Nov 21\n";
        let output = "Setting up run ...\n5000000000 12 3\n100 2 3 4\n5100000000 13 4\nhello\n5600000000 14 9\n";
        let found = parse_liggghts(log, output).unwrap();
        assert_eq!((found.seconds, found.steps, found.builds), (0.395, 100, Some(4)));
        assert!((found.cpu.unwrap() - 0.4).abs() < 1e-12);
        assert_eq!(parse_liggghts(log, "").unwrap().cpu, None);
    }

    #[test]
    fn the_line_of_yade_is_read() {
        let found =
            parse_yade("Welcome\nPEERS loop 12.5 cpu 12.25 steps 200 grains 20000\nYade: normal exit.\n").unwrap();
        assert_eq!(
            (found.seconds, found.cpu, found.steps, found.grains),
            (12.5, Some(12.25), 200, 20_000)
        );
        assert!(parse_yade("PEERS loop nothing").is_err() && parse_yade("").is_err());
    }

    #[test]
    fn walls_of_lammps_depend_on_its_age() {
        let walls = |version: &str, style| {
            let lammps = Engine::Lammps {
                program: PathBuf::new(),
                launcher: None,
                version: version.into(),
                style,
            };
            lammps.walls(Kind::Bed).stiffness
        };
        assert_eq!(
            (
                walls("29 Sep 2021", 0),
                walls("29 Sep 2021", 1),
                walls("22 Jul 2025", 0)
            ),
            (1.3, 1.0, 1.0)
        );
        assert_eq!(walls("of no year", 0), 1.0);
    }

    #[test]
    fn ranks_need_a_launcher() {
        let (program, mpirun) = (Path::new("lmp"), Path::new("/opt/mpirun"));
        assert!(ranks(program, None, 2).is_err());
        assert_eq!(ranks(program, None, 1).unwrap().get_program(), "lmp");
        let two = ranks(program, Some(mpirun), 2).unwrap();
        let arguments: Vec<_> = two.get_args().collect();
        assert_eq!(arguments[arguments.len() - 3..], ["-np", "2", "lmp"]);
    }
}
