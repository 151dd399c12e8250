//! Demeter beside its peers: every workload in Demeter and in each peer that is installed, in turn, in rounds, with the
//! same steps and the same physics; what is compared and why is told in `benches/README.md`.
#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a benchmark prints its table and where it stands"
)]

mod agreement;
mod analysis;
mod demeter_loop;
mod engines;
mod grains;
mod prepare;
mod process;
mod report;
mod workloads;

use clap::{Parser, Subcommand};
use engines::{Engine, Job, Places};
use grains::{Fault, State};
use report::{Outcome, Report, Sample, Series};
use std::fs;
use std::path::{Path, PathBuf};
use workloads::{EngineWalls, Kind, Workload};

#[derive(Parser)]
struct Arguments {
    #[command(subcommand)]
    task: Option<Subtask>,
    /// Workloads, by the beginnings of their names: `w1,w6-10k`; all when absent.
    #[arg(long, value_delimiter = ',')]
    workload: Vec<String>,
    /// Rounds, of which the median is told.
    #[arg(long, default_value_t = 3)]
    repeat: usize,
    /// Threads of Demeter and YADE, ranks of LAMMPS and LIGGGHTS.
    #[arg(long, value_delimiter = ',', default_value = "1")]
    threads: Vec<usize>,
    /// Steps of the loop, or a share of the usual number: `10 %`.
    #[arg(long, default_value = "100 %")]
    steps: String,
    /// Peers to run where they are installed.
    #[arg(long, value_delimiter = ',', default_value = "lammps,liggghts,yade")]
    peers: Vec<String>,
    /// Another LAMMPS to run beside the one on the path; may be given many times.
    #[arg(long)]
    lammps: Vec<PathBuf>,
    /// Folder for the tables, the inputs and the logs.
    #[arg(long)]
    keep: Option<PathBuf>,
    /// Folder of the start states.
    #[arg(long)]
    states: Option<PathBuf>,
}

#[derive(Subcommand)]
enum Subtask {
    /// Demeter's own loop; this program calls itself with it.
    #[command(hide = true)]
    Work(demeter_loop::Task),
}

/// Inputs that every engine finds in the folder `inputs`.
const INPUTS: [(&str, &str); 20] = [
    ("material.lmp", include_str!("../../../peers/lammps/material.lmp")),
    ("end.lmp", include_str!("../../../peers/lammps/end.lmp")),
    ("bed.lmp", include_str!("../../../peers/lammps/bed.lmp")),
    ("chute.lmp", include_str!("../../../peers/lammps/chute.lmp")),
    ("drum.lmp", include_str!("../../../peers/lammps/drum.lmp")),
    ("plate.lmp", include_str!("../../../peers/lammps/plate.lmp")),
    ("sizes.lmp", include_str!("../../../peers/lammps/sizes.lmp")),
    ("material.lig", include_str!("../../../peers/liggghts/material.lig")),
    ("end.lig", include_str!("../../../peers/liggghts/end.lig")),
    ("bed.lig", include_str!("../../../peers/liggghts/bed.lig")),
    ("chute.lig", include_str!("../../../peers/liggghts/chute.lig")),
    ("drum.lig", include_str!("../../../peers/liggghts/drum.lig")),
    ("plate.lig", include_str!("../../../peers/liggghts/plate.lig")),
    ("sizes.lig", include_str!("../../../peers/liggghts/sizes.lig")),
    ("loop.py", include_str!("../../../peers/yade/loop.py")),
    ("bed.py", include_str!("../../../peers/yade/bed.py")),
    ("chute.py", include_str!("../../../peers/yade/chute.py")),
    ("drum.py", include_str!("../../../peers/yade/drum.py")),
    ("plate.py", include_str!("../../../peers/yade/bed.py")),
    ("sizes.py", include_str!("../../../peers/yade/bed.py")),
];

fn main() -> Result<(), Fault> {
    let arguments = Arguments::parse();
    match &arguments.task {
        Some(Subtask::Work(task)) => demeter_loop::work(task),
        None => bench(&arguments),
    }
}

fn bench(arguments: &Arguments) -> Result<(), Fault> {
    let workloads = workloads::chosen(&arguments.workload)?;
    let share = Steps::read(&arguments.steps)?;
    let engines = engines(arguments)?;
    let folder = default_folder()?;
    let keep = arguments.keep.clone().unwrap_or_else(|| folder.join("latest"));
    let states = arguments.states.clone().unwrap_or_else(|| folder.join("states"));
    for part in ["inputs", "logs"] {
        fs::create_dir_all(keep.join(part))?;
    }
    fs::create_dir_all(&states)?;
    let places = Places {
        states: fs::canonicalize(states)?,
        kept: fs::canonicalize(keep)?,
    };
    for (name, text) in INPUTS {
        fs::write(places.kept.join("inputs").join(name), text)?;
    }
    let mut report = Report {
        machine: machine(),
        demeter: demeter::VERSION.to_owned(),
        outcomes: Vec::new(),
    };
    for workload in &workloads {
        prepare::ensure(workload.state, &places.states)?;
        report
            .outcomes
            .push(outcome(workload, share, &engines, arguments, &places)?);
        // after each, so that nothing is lost when a later one cannot be run
        fs::write(places.kept.join("peers.md"), report.markdown())?;
        fs::write(places.kept.join("peers.json"), serde_json::to_string_pretty(&report)?)?;
    }
    println!("{}", report.markdown());
    eprintln!("kept in {}", places.kept.display());
    Ok(())
}

/// How many steps a loop has.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Steps {
    Number(u64),
    Share(f64),
}

impl Steps {
    fn read(text: &str) -> Result<Self, Fault> {
        let wrong = || format!("`--steps {text}`: a number of steps, or a share such as `10 %`");
        let steps = match text.trim().strip_suffix('%') {
            Some(percent) => Self::Share(percent.trim().parse::<f64>().map_err(|_| wrong())? / 100.0),
            None => Self::Number(text.trim().parse().map_err(|_| wrong())?),
        };
        match steps {
            Self::Number(0) => Err(wrong().into()),
            Self::Share(share) if !(share > 0.0 && share.is_finite()) => Err(wrong().into()),
            _ => Ok(steps),
        }
    }

    fn of(self, usual: u64) -> u64 {
        match self {
            Self::Number(steps) => steps,
            Self::Share(share) => ((usual as f64 * share).round() as u64).max(1),
        }
    }
}

/// Demeter and the peers that were asked for and are there.
fn engines(arguments: &Arguments) -> Result<Vec<Engine>, Fault> {
    let mut all = vec![Engine::Demeter];
    for peer in &arguments.peers {
        let program = match peer.as_str() {
            "lammps" => process::find_program("lmp"),
            "liggghts" | "yade" => process::find_program(peer),
            "" => continue,
            _ => return Err(format!("there is no peer `{peer}`; there are lammps, liggghts, yade").into()),
        };
        let Some(program) = program else {
            eprintln!("{peer} is not installed: left out");
            continue;
        };
        match peer.as_str() {
            "lammps" => all.extend(lammps(&program)?),
            "liggghts" => all.push(Engine::Liggghts {
                launcher: engines::launcher_of(&program),
                program,
            }),
            _ => all.push(Engine::Yade { program }),
        }
    }
    for program in &arguments.lammps {
        all.extend(lammps(&std::path::absolute(program)?)?);
    }
    Ok(all)
}

/// A LAMMPS with each of its styles.
fn lammps(program: &Path) -> Result<[Engine; 2], Fault> {
    let version = engines::lammps_version(program)?;
    Ok([0, 1].map(|style| Engine::Lammps {
        program: program.to_owned(),
        launcher: engines::launcher_of(program),
        version: version.clone(),
        style,
    }))
}

/// `peers` in the target folder, beside the profile that this program was built with.
fn default_folder() -> Result<PathBuf, Fault> {
    let program = std::env::current_exe()?;
    let target = program
        .ancestors()
        .nth(2)
        .ok_or("the program lies in no folder; give --keep and --states")?;
    Ok(target.join("peers"))
}

fn machine() -> String {
    let text = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text
        .lines()
        .find_map(|l| l.strip_prefix("model name"))
        .unwrap_or("an unknown processor");
    let cores = std::thread::available_parallelism().map_or(1, usize::from);
    format!(
        "{}, {cores} hardware threads",
        name.trim_start_matches(['\t', ' ', ':'])
    )
}

/// Runs one workload in every engine, round by round.
fn outcome(
    workload: &Workload,
    share: Steps,
    engines: &[Engine],
    arguments: &Arguments,
    places: &Places,
) -> Result<Outcome, Fault> {
    let state = State::read(&places.states.join(format!("{}.data", workload.state)))?;
    write_meshes(workload.kind, &state, places)?;
    let steps = share.of(workload.steps);
    let mut outcome = Outcome {
        key: workload.key.to_owned(),
        title: workload.title.to_owned(),
        grains: state.grains.len(),
        steps,
        bearing: bearing_name(workload.kind),
        series: Vec::new(),
    };
    let contenders: Vec<(&Engine, usize)> = (engines.iter())
        .flat_map(|e| arguments.threads.iter().map(move |&t| (e, t)))
        .collect();
    for round in 0..arguments.repeat {
        for (engine, threads) in &contenders {
            let name = format!("{}-{}-{threads}-{round}", workload.key, engine.label(workload)).replace(' ', "-");
            let end = places.kept.join(format!("{name}.end"));
            let job = Job {
                workload,
                state: &state,
                steps,
                threads: *threads,
                // every run of one thread ends the same
                end: (round == 0 && *threads == 1).then_some(end.as_path()),
                places,
                name: &name,
            };
            if engine.can(&job) {
                measure(engine, &job, round, &mut outcome);
            }
        }
    }
    Ok(outcome)
}

/// Does a job and puts what it gave to the others; a failure is told in the table.
fn measure(engine: &Engine, job: &Job, round: usize, outcome: &mut Outcome) {
    let label = engine.label(job.workload);
    let at = outcome
        .series
        .iter()
        .position(|s| s.engine == label && s.threads == job.threads);
    let at = at.unwrap_or_else(|| {
        outcome.series.push(Series {
            engine: label,
            threads: job.threads,
            samples: Vec::new(),
            fault: None,
            physics: None,
            deviation: None,
            tolerance: engine.tolerance(job.workload),
        });
        outcome.series.len() - 1
    });
    if outcome.series[at].fault.is_some() {
        return;
    }
    let done = engine.run(job).and_then(|(measured, ended)| {
        let physics = job
            .end
            .map(|end| judge(end, job, engine.walls(job.workload.kind)))
            .transpose()?;
        Ok((measured, ended, physics))
    });
    match done {
        Err(fault) => {
            eprintln!("{}: {fault}", job.name);
            outcome.series[at].fault = Some(fault.to_string());
        }
        Ok((measured, ended, physics)) => {
            let shown = measured.cpu.unwrap_or(f64::NAN);
            eprintln!(
                "{}: {:.2} s on the clock, {shown:.2} s on cores",
                job.name, measured.seconds
            );
            outcome.series[at].samples.push(Sample {
                round,
                measured,
                peak: (job.threads == 1 || !engine.has_ranks())
                    .then_some(ended.peak)
                    .flatten(),
                others: (job.threads == 1).then_some(ended.others).flatten(),
            });
            if physics.is_some() {
                let demeter = outcome.series[0].physics.filter(|_| at > 0);
                let series = &mut outcome.series[at];
                series.physics = physics;
                series.deviation = (demeter.zip(physics)).map(|(d, p)| agreement::compare(&d, &p, &series.tolerance));
            }
        }
    }
}

/// Judges the grains that a run left, and takes their file away.
fn judge(end: &Path, job: &Job, walls: EngineWalls) -> Result<analysis::Physics, Fault> {
    let text = fs::read_to_string(end).map_err(|e| format!("{}: {e}", end.display()))?;
    let grains = grains::read_end(&text).map_err(|e| format!("{}: {e}", end.display()))?;
    fs::remove_file(end)?;
    let scene = job.workload.scene(job.state, job.workload.relax + job.steps, walls);
    Ok(analysis::judge(&grains, &scene))
}

fn bearing_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Bed | Kind::Column | Kind::Sizes => "floor",
        Kind::Chute => "base",
        Kind::Drum => "drum",
        Kind::Plate => "plate",
    }
}

/// Meshes that LIGGGHTS reads.
fn write_meshes(kind: Kind, state: &State, places: &Places) -> Result<(), Fault> {
    let triangles = match kind {
        Kind::Drum => workloads::drum_mesh(),
        Kind::Plate => workloads::plate_mesh(state),
        _ => return Ok(()),
    };
    let file = places.kept.join(format!("inputs/{}.stl", kind.input()));
    Ok(fs::write(file, workloads::stl(&triangles))?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_a_number_or_a_share() {
        assert_eq!(Steps::read("250").unwrap().of(1000), 250);
        assert_eq!(Steps::read("10 %").unwrap().of(3760), 376);
        assert_eq!(Steps::read("0.001%").unwrap().of(25), 1);
        for wrong in ["0", "-3", "0 %", "ten", "inf %"] {
            assert!(Steps::read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn every_workload_has_an_input_for_every_peer() {
        for workload in workloads::WORKLOADS {
            for ending in ["lmp", "lig", "py"] {
                let name = format!("{}.{ending}", workload.kind.input());
                assert!(INPUTS.iter().any(|(known, _)| *known == name), "{name}");
            }
        }
    }

    #[test]
    fn unknown_peers_are_told() {
        let arguments = Arguments::parse_from(["peers", "--peers", "lammps2"]);
        assert!(engines(&arguments).unwrap_err().to_string().contains("`lammps2`"));
        let none = Arguments::parse_from(["peers", "--peers", ""]);
        assert_eq!(engines(&none).unwrap(), [Engine::Demeter]);
    }
}
