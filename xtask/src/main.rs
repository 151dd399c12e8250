//! What Demeter's developers do often, as `cargo xtask <command>`.

mod bench;
mod book;
mod browser;
mod checks;
mod dist;
mod house_rules;
mod imports;
mod instructions;
mod interchange;
mod layers;
mod new_law;
mod python;
mod shell;
mod validate;
mod web;

use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(Parser)]
#[command(name = "cargo xtask", about = "What Demeter's developers do often")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Everything that must hold before a merge: format, layers, clippy, tests, documentation, the Python crate
    Ci,
    /// All tests, with nextest where it is installed, and the examples in the documentation
    Test,
    /// Run a small scenario and open what it wrote with PyVista
    Python,
    /// Run small scenarios and open their pages in headless Chromium (needs Node.js and Chromium)
    Browser,
    /// Bundle the pages for browsers into crates/web/dist (needs Node.js)
    Web {
        /// Change nothing, fail where dist is not what the sources make
        #[arg(long)]
        check: bool,
    },
    /// Let LAMMPS, LIGGGHTS, YADE, OVITO and ASE, as far as they are installed, read converted files, and read theirs
    Interchange,
    /// Build the release binary, static where it can be, and pack it with completions, manual and licences
    Dist,
    /// Tell the licences of everything in the binary
    Licences,
    /// Format all sources, also those that only a macro declares as modules
    Fmt {
        /// Change nothing, fail where something would change
        #[arg(long)]
        check: bool,
    },
    /// Documentation without warnings
    Doc,
    /// Modules import along the arrows of the design; libraries neither print nor exit
    Layers,
    /// Write the files of a new contact law and register it
    NewLaw {
        /// `normal`, `tangential`, `rolling` or `multi-contact`
        family: new_law::Family,
        /// Name in the scenario, such as `thornton-ning`
        name: String,
    },
    /// Make the book, with all that is generated for it, and check its links
    Book,
    /// Verification cases at full size, in release mode
    Verify {
        /// Only cases whose name contains this
        filter: Option<String>,
    },
    /// Simulate an experiment of the literature anew and compare; `validate hydrogel --help` tells more
    Validate {
        /// Name of the experiment and its options
        #[arg(trailing_var_arg = true, allow_hyphen_values = true, required = true)]
        arguments: Vec<String>,
    },
    /// Count the instructions of one step with callgrind and compare with `benches/instructions.toml`
    Instructions {
        /// Take what is counted as the new reference
        #[arg(long)]
        accept: bool,
        /// Only compile what is counted, and the Python module as it is tested
        #[arg(long, conflicts_with = "accept")]
        build: bool,
    },
    /// Settle the benchmark packing and print the speed
    Bench {
        /// Threads
        #[arg(long, default_value_t = 1)]
        threads: usize,
        /// Scenario to run
        #[arg(long, default_value = "examples/settle-20000/scenario.toml")]
        scenario: PathBuf,
        /// Folder of the run; by default one in the target folder
        #[arg(long)]
        out: Option<PathBuf>,
    },
}

fn main() -> ExitCode {
    let result = match Arguments::parse().command {
        Command::Ci => checks::ci(),
        Command::Test => checks::test(),
        Command::Python => python::test(),
        Command::Browser => browser::test(),
        Command::Dist => dist::pack(),
        Command::Licences => dist::licences(),
        Command::Interchange => interchange::test(),
        Command::Web { check } => web::build(check),
        Command::Fmt { check } => checks::format(check),
        Command::Doc => checks::documentation(),
        Command::Layers => checks::layers(),
        Command::NewLaw { family, name } => new_law::run(family, &name),
        Command::Book => book::make(),
        Command::Verify { filter } => checks::verify(filter.as_deref()),
        Command::Validate { arguments } => validate::run(&arguments),
        Command::Instructions { build: true, .. } => instructions::build(),
        Command::Instructions { accept, .. } => instructions::run(accept),
        Command::Bench { threads, scenario, out } => bench::run(&scenario, threads, out),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
