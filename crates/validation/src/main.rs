//! `cargo xtask validate`: simulates experiments of the literature anew and compares them with what was measured.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a program for the command line"
)]

use clap::{Parser, Subcommand};
use demeter_validation::hydrogel::{
    Experiment, Results, Standards, TOP_FORCE, ValidationError, find_models, run_models, write_figures, write_table,
};
use demeter_validation::{bulk, dosta, rheology};
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(Parser)]
#[command(
    name = "cargo xtask validate",
    about = "Experiments of the literature, simulated anew and compared"
)]
struct Arguments {
    #[command(subcommand)]
    experiment: Which,
}

#[derive(Subcommand)]
enum Which {
    /// 514 hydrogel grains that a plate squeezes, with five contact models: Table I and figures 3 to 6 of Brodu, Dijksman
    /// and Behringer (2015)
    Hydrogel(Hydrogel),
    /// A ball that falls into a bed, a turning drum, a silo: the cross-code benchmark of Dosta et al. (2024)
    Dosta(Dosta),
    /// Spheres sheared at a constant pressure, from fast to slow: the friction of dense granular flow (Jop et al. 2006)
    Rheology(Rheology),
    /// Laws of bulk solids: Beverloo's discharge, Janssen's floor, an angle of repose that rises with friction
    Bulk(Bulk),
}

#[derive(clap::Args)]
struct Rheology {
    /// Threads; otherwise all cores
    #[arg(long)]
    threads: Option<usize>,
    /// Scenario of the series
    #[arg(long, default_value = "validation/rheology/scenario.toml")]
    scenario: PathBuf,
    /// Changes of the scenario, as `demeter run --set`
    #[arg(long)]
    set: Vec<String>,
    /// Mean diameter of the grains [m]
    #[arg(long, default_value_t = 1e-3)]
    diameter: f64,
    /// Density of their material [kg/m^3]
    #[arg(long, default_value_t = 2500.0)]
    density: f64,
    /// Folder of the results; the run goes into a folder below it
    #[arg(long, default_value = "runs/validate-rheology")]
    out: PathBuf,
    /// Replace another run in the folder
    #[arg(long)]
    overwrite: bool,
}

#[derive(clap::Args)]
struct Bulk {
    /// Study: beverloo, janssen or repose; all when absent
    #[arg(long)]
    study: Option<String>,
    /// Points in place of those of the study, with commas between
    #[arg(long, value_delimiter = ',', requires = "study")]
    points: Vec<f64>,
    /// Runs at a time, with one thread each
    #[arg(long, default_value_t = 2)]
    jobs: usize,
    /// Folder of the scenarios
    #[arg(long, default_value = "validation/bulk")]
    scenarios: PathBuf,
    /// Changes of the scenario, as `demeter run --set`
    #[arg(long)]
    set: Vec<String>,
    /// Folder of the results; runs go into folders below it
    #[arg(long, default_value = "runs/validate-bulk")]
    out: PathBuf,
    /// Replace other runs in the folders
    #[arg(long)]
    overwrite: bool,
}

#[derive(clap::Args)]
struct Dosta {
    /// Case: penetration-25k, penetration-50k, drum, silo-small-m1, silo-small-m2, silo-large-m1 or silo-large-m2
    #[arg(long)]
    case: String,
    /// Folder of the published files, with the folders `penetration`, `drum` and `silo`
    #[arg(long)]
    data: PathBuf,
    /// Simulated time [s], of a silo from when it is opened; otherwise the published one
    #[arg(long)]
    until: Option<f64>,
    /// Threads; otherwise all cores
    #[arg(long)]
    threads: Option<usize>,
    /// Folder of the scenarios
    #[arg(long, default_value = "validation/dosta")]
    scenarios: PathBuf,
    /// Changes of the scenario, as `demeter run --set`
    #[arg(long)]
    set: Vec<String>,
    /// Folder of the results; every case has a folder below it
    #[arg(long, default_value = "runs/validate-dosta")]
    out: PathBuf,
    /// Replace another run in the folder
    #[arg(long)]
    overwrite: bool,
}

#[derive(clap::Args)]
struct Hydrogel {
    /// Cycles of squeezing and releasing; the paper has 20
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u16).range(1..=1000))]
    cycles: u16,
    /// Cycles left out at the beginning; otherwise 5 of 8 and more, 1 of fewer, none of one
    #[arg(long)]
    discard: Option<u16>,
    /// Grains, as a LIGGGHTS data file or CSV; otherwise a packing is made
    #[arg(long)]
    packing: Option<PathBuf>,
    /// Models by name, with commas between; otherwise all five
    #[arg(long, value_delimiter = ',')]
    models: Vec<String>,
    /// Prefactor of MC-DEM
    #[arg(long, default_value_t = PREFACTOR)]
    prefactor: f64,
    /// Measured force on the plate at full compression [N]
    #[arg(long, default_value_t = TOP_FORCE)]
    top_force: f64,
    /// Measured curve (CSV, as `demeter compare` reads it), compressions from the first touch
    #[arg(long)]
    measured: Option<PathBuf>,
    /// Runs at a time, with one thread each
    #[arg(long, default_value_t = 2)]
    jobs: usize,
    /// Scenario of the experiment
    #[arg(long, default_value = "validation/hydrogel/scenario.toml")]
    scenario: PathBuf,
    /// Changes of the scenario, as `demeter run --set`
    #[arg(long)]
    set: Vec<String>,
    /// Folder of the results; runs go into folders below it
    #[arg(long, default_value = "runs/validate-hydrogel")]
    out: PathBuf,
    /// Replace other runs in the folders
    #[arg(long)]
    overwrite: bool,
}

/// Prefactor with which the force on the plate is the measured one; `validation/hydrogel/README.md` tells how it was found.
const PREFACTOR: f64 = 1.2;

impl Hydrogel {
    fn discard(&self) -> usize {
        usize::from(self.discard.unwrap_or(match self.cycles {
            8.. => 5,
            2..8 => 1,
            _ => 0,
        }))
    }

    /// What is run, in words.
    fn made(&self) -> String {
        let packing = match &self.packing {
            Some(file) => {
                let name = file.file_name().unwrap_or(file.as_os_str());
                format!("Packing: `{}`.", name.to_string_lossy())
            }
            None => "Packing: made here, `grains` of the scenario.".to_string(),
        };
        let changes = match self.set.as_slice() {
            [] => String::new(),
            set => format!(" Changes of the scenario: `{}`.", set.join("`, `")),
        };
        let (cycles, version) = (self.cycles, demeter::VERSION);
        format!("Demeter {version}, {cycles} cycles. {packing}{changes}")
    }
}

fn hydrogel(arguments: &Hydrogel) -> Result<(), ValidationError> {
    let models = find_models(&arguments.models)?;
    let experiment = Experiment {
        scenario: arguments.scenario.clone(),
        set: arguments.set.clone(),
        packing: arguments.packing.clone(),
        cycles: usize::from(arguments.cycles),
        prefactor: arguments.prefactor,
        overwrite: arguments.overwrite,
    };
    let tell = |text: &str| eprintln!("{text}");
    let folders = run_models(&experiment, &models, &arguments.out, arguments.jobs, &tell)?;
    let standards = Standards {
        top_force: arguments.top_force,
        discard: arguments.discard(),
        measured: arguments.measured.clone(),
    };
    let results = Results::read(&models, &folders, arguments.prefactor, &standards)?;
    println!("{}", write_table(&results, &arguments.made(), &arguments.out)?);
    for check in write_figures(&results, &arguments.out)? {
        println!("{check}");
    }
    Ok(())
}

fn dosta(arguments: &Dosta) -> Result<(), dosta::DostaError> {
    let case = dosta::find_case(&arguments.case)?;
    let experiment = dosta::Experiment {
        data: arguments.data.clone(),
        scenarios: arguments.scenarios.clone(),
        until: arguments.until,
        set: arguments.set.clone(),
        threads: arguments.threads,
        overwrite: arguments.overwrite,
    };
    let out = arguments.out.join(case.name);
    let folder = dosta::run_case(&experiment, case, &out, &|text| eprintln!("{text}"))?;
    let outcome = dosta::Outcome::read(case, &folder)?;
    let (line, table) = dosta::write_outcome(&outcome, case, &out)?;
    println!("{line}\n{}", table.display());
    Ok(())
}

fn rheology(arguments: &Rheology) -> Result<(), rheology::RheologyError> {
    let experiment = rheology::Experiment {
        scenario: arguments.scenario.clone(),
        set: arguments.set.clone(),
        threads: arguments.threads,
        overwrite: arguments.overwrite,
    };
    let folder = arguments.out.join("run");
    let scenario = rheology::run_series(&experiment, &folder, &|text| eprintln!("{text}"))?;
    let flow = rheology::Flow {
        diameter: arguments.diameter,
        density: arguments.density,
    };
    let points = rheology::read_points(&scenario, flow, &folder)?;
    println!("{}", rheology::write_tables(&points, &arguments.out)?);
    Ok(())
}

fn bulk(arguments: &Bulk) -> Result<(), bulk::BulkError> {
    let studies = match &arguments.study {
        Some(name) => vec![bulk::find_study(name)?],
        None => bulk::STUDIES.iter().collect(),
    };
    let experiment = bulk::Experiment {
        scenarios: arguments.scenarios.clone(),
        points: arguments.points.clone(),
        set: arguments.set.clone(),
        jobs: arguments.jobs,
        overwrite: arguments.overwrite,
    };
    for study in studies {
        let runs = bulk::run_study(&experiment, study, &arguments.out, &|text| eprintln!("{text}"))?;
        let findings = bulk::find(study, &runs)?;
        let words = bulk::write_findings(&findings, study, &arguments.out)?;
        println!("{}: {words}", study.name);
    }
    Ok(())
}

fn main() -> ExitCode {
    let result: Result<(), Box<dyn std::error::Error>> = match Arguments::parse().experiment {
        Which::Hydrogel(arguments) => hydrogel(&arguments).map_err(Into::into),
        Which::Bulk(arguments) => bulk(&arguments).map_err(Into::into),
        Which::Dosta(arguments) => dosta(&arguments).map_err(Into::into),
        Which::Rheology(arguments) => rheology(&arguments).map_err(Into::into),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
