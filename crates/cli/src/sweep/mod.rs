//! `demeter sweep`: many runs of one scenario with different values.
//!
//! Each run is a process of its own, so that a crash or a lack of memory ends one run and not the sweep. The process that
//! starts them holds the other end of their standard input: when it ends, however it ends, they write a checkpoint and end.

mod begin;
mod needs;
mod part;
mod slurm;
mod team;
mod told;
mod watch;

use crate::arguments::SweepArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use begin::{Begun, State};
use demeter::sweep::{SweepError, SweepFolder};
use std::path::Path;
use team::Team;

/// Plans a sweep, goes on with one, or gathers its results.
pub fn sweep(arguments: &SweepArguments) -> Result<Exit, Failure> {
    if let Some(folder) = &arguments.gather {
        return gather(arguments, folder);
    }
    if let (Some(folder), Some(index)) = (&arguments.resume, arguments.only) {
        return part::carry_out(arguments, folder, index);
    }
    // where a scenario is told, the command line cannot tell that --resume is missing
    if let Some(index) = arguments.only {
        return Err(Failure::wrong(format!(
            "--only {index} carries out one run of a sweep that is in a folder already: tell the folder with --resume, without the \
             scenario. Without --only the sweep is begun here, with all its runs; --slurm only writes its plan and a script"
        )));
    }
    let interrupt = Interrupt::listen();
    let begun = match (&arguments.resume, &arguments.file) {
        (Some(folder), _) => begin::open(arguments, folder)?,
        (None, Some(file)) => begin::plan(arguments, file)?,
        (None, None) => return Err(Failure::wrong("name a scenario, or a folder with --resume")),
    };
    if arguments.dry_run {
        needs::tell(&begun.folder, arguments)?;
        return Ok(Exit::Finished);
    }
    run(arguments, begun, interrupt)
}

/// Runs what is left to do, or writes the script that does.
fn run(arguments: &SweepArguments, begun: Begun, interrupt: Interrupt) -> Result<Exit, Failure> {
    let Begun { folder, state } = begun;
    let script = arguments.slurm.then(|| slurm::script(&folder, arguments)).transpose()?;
    if state == State::New {
        folder.create()?;
    }
    let held = folder.hold()?;
    if state == State::Extended {
        folder.write_state(&folder.statuses())?;
    }
    if let Some(script) = script {
        return slurm::write(&folder, arguments, &script);
    }
    let ended = Team::new(&folder, arguments).run(interrupt)?;
    let exit = ended.exit();
    let exit = told::results(&folder, arguments, &ended.statuses, Some(exit))?;
    drop(held);
    Ok(exit)
}

/// Gathers results, also while runs go on.
fn gather(arguments: &SweepArguments, root: &Path) -> Result<Exit, Failure> {
    let mut folder = SweepFolder::open(root)?;
    begin::take_wishes(arguments, &mut folder)?;
    let statuses = folder.statuses();
    let exit = told::results(&folder, arguments, &statuses, None)?;
    match folder.hold() {
        // nobody works on it: what was asked for is kept, and how far it is
        Ok(_held) => folder.write_state(&statuses)?,
        Err(SweepError::InUse { .. }) => {}
        Err(error) => return Err(error.into()),
    }
    Ok(exit)
}

impl From<SweepError> for Failure {
    fn from(error: SweepError) -> Self {
        let message = error.to_string();
        match error {
            SweepError::Scenario(faults) => Self::Scenario(faults),
            SweepError::Run(error) => error.into(),
            SweepError::Results(error) => error.into(),
            SweepError::Output(_) | SweepError::Io { .. } => Self::io(message),
            SweepError::Told { .. }
            | SweepError::Differs { .. }
            | SweepError::FilesChanged { .. }
            | SweepError::HoldsOtherFiles { .. }
            | SweepError::NoSweep { .. }
            | SweepError::InUse { .. }
            | SweepError::Damaged { .. }
            | SweepError::NoRun { .. }
            | SweepError::OtherRun { .. } => Self::wrong(message),
        }
    }
}
