//! `demeter`: the command line of the Demeter engine.
//!
//! Arguments come in, a command runs, its answer goes to standard output and everything that is said on the way to
//! standard error. Only this crate prints and ends the process.

mod answer;
mod arguments;
#[cfg(test)]
mod book;
mod bug_report;
mod check;
mod check_motions;
mod check_walls;
mod collide;
mod compare;
mod contact_curve;
mod convert;
mod exit;
mod failure;
mod figure;
mod fit;
mod fit_packing;
mod info;
mod interrupt;
mod job;
mod laws;
#[cfg(feature = "mpi")]
mod mpi_job;
mod new;
mod plot;
mod profile;
mod progress;
mod readable;
mod render;
mod report;
mod run;
mod schema;
mod shell;
mod sticking;
mod suggestion;
mod sweep;
mod table;
mod view;

use answer::note;
use arguments::{Arguments, Command};
use clap::Parser;
use clap::error::ErrorKind;
use exit::Exit;
use failure::Failure;
use std::process::ExitCode;

fn main() -> ExitCode {
    bug_report::install();
    #[cfg(unix)]
    interrupt::hear_of_limits();
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => return refuse(&error).into(),
    };
    let json = arguments.command.wants_json();
    let is_shared = matches!(arguments.command, Command::Run(_) | Command::Resume(_));
    if !is_shared && let Err(failure) = job::refuse_several() {
        return failure.tell(json).into();
    }
    let outcome = match arguments.command {
        Command::Run(arguments) => run::run(&arguments),
        Command::Resume(arguments) => run::resume(&arguments),
        Command::Sweep(arguments) => sweep::sweep(&arguments),
        Command::Check(arguments) => check::check(&arguments),
        Command::Report(arguments) => report::report(&arguments),
        Command::View(arguments) => view::view(&arguments),
        Command::Collide(arguments) => collide::collide(&arguments),
        Command::ContactCurve(arguments) => contact_curve::contact_curve(&arguments),
        Command::Sticking(arguments) => sticking::sticking(&arguments),
        Command::Fit(arguments) => fit::fit(&arguments),
        Command::Compare(arguments) => compare::compare(&arguments),
        Command::Figure(arguments) => figure::figure(&arguments),
        Command::Plot(arguments) => plot::plot(&arguments),
        Command::Render(arguments) => render::render(&arguments),
        Command::Convert(arguments) => convert::convert(&arguments),
        Command::Completions(arguments) => shell::completions(&arguments),
        Command::Man(arguments) => shell::man(&arguments),
        Command::Laws(arguments) => laws::laws(&arguments),
        Command::Schema(arguments) => schema::schema(&arguments),
        Command::New(arguments) => new::new(&arguments),
        Command::Info(arguments) => info::info(&arguments),
    };
    let exit = match outcome {
        Ok(exit) => exit,
        Err(failure) => failure.tell(json),
    };
    job::leave();
    exit.into()
}

/// What clap has to say instead of arguments: help, the version, or what is wrong.
fn refuse(error: &clap::Error) -> Exit {
    let asked_for = matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion);
    if !asked_for {
        job::let_the_first_speak();
    }
    let json = std::env::args_os().any(|argument| argument == "--json");
    if !asked_for && json {
        return Failure::wrong(error.render().to_string().trim_end()).tell(true);
    }
    if error.print().is_err() && !asked_for {
        note("the command line is wrong; `demeter --help` tells what is right");
    }
    if asked_for { Exit::Finished } else { Exit::Wrong }
}
