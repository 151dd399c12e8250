//! Exit codes, all of them.

use std::process::ExitCode;

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// It did what it was asked to.
    Finished = 0,
    /// Results could not be written, or a file that is there, and no input of a scenario, could not be read.
    InputOutput = 1,
    /// The scenario, a file that it needs, or the command line is wrong; nothing was written.
    Wrong = 2,
    /// The simulation stopped on a fault; a snapshot was written. A run of a sweep failed or is damaged; a fit found no answer.
    Fault = 3,
    /// It was interrupted; a checkpoint was written.
    Interrupted = 130,
}

/// The codes as `--help` tells them.
pub const HELP: &str = "\
Exit codes:
    0  finished
    1  results could not be written, or a file that is there, and no input of a scenario, could not be read
    2  the scenario, a file that it needs, or the command line is wrong, or names what is not there; nothing was written
    3  the simulation stopped on a fault; a snapshot of it was written. Of a sweep: a run failed, or what it left
       is damaged; of a fit: there is no answer between the ends that were told
  101  a defect of Demeter
  130  interrupted (Ctrl-C, SIGTERM); a checkpoint was written, `demeter resume` goes on from it, or the same `demeter sweep`
  134  memory could not be had: give the job more (`ulimit -v`, the memory of a batch job), or take fewer grains or threads; `demeter resume`
       goes on from the latest checkpoint";

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        ExitCode::from(exit as u8)
    }
}
