//! Why a command failed, told as text or as JSON.

use crate::answer::{answer_json, colours, note};
use crate::exit::Exit;
use demeter::calibrate::CalibrateError;
use demeter::checkpoint::CheckpointError;
use demeter::output::OutputError;
use demeter::report::ReportError;
use demeter::scenario::{Diagnostic, Diagnostics, RunError};
use demeter::sweep::SweepFault;
use serde_json::{Value, json};

/// Why a command failed.
#[derive(Debug)]
pub enum Failure {
    /// The scenario is wrong.
    Scenario(Box<Diagnostics>),
    /// The scenarios of some runs of a sweep are wrong.
    Sweep {
        /// The faults, each with the runs that have it in words.
        faults: Vec<(SweepFault, String)>,
        /// How many more there are.
        left_out: usize,
    },
    /// Anything else.
    Other {
        /// The exit code.
        exit: Exit,
        /// What is wrong and what to do.
        message: String,
    },
}

impl Failure {
    /// The command line or what it names is wrong.
    pub fn wrong(message: impl Into<String>) -> Self {
        Self::Other {
            exit: Exit::Wrong,
            message: message.into(),
        }
    }

    /// The system refused to read or write.
    pub fn io(message: impl Into<String>) -> Self {
        Self::Other {
            exit: Exit::InputOutput,
            message: message.into(),
        }
    }

    /// The failure of one of several processes.
    fn of_process(mut self, rank: usize) -> Self {
        if let Self::Other { message, .. } = &mut self {
            *message = format!("process {rank}: {message}");
        }
        self
    }

    /// Tells the user and gives the exit code.
    pub fn tell(&self, as_json: bool) -> Exit {
        if !as_json || answer_json(&self.to_json()).is_err() {
            match self {
                Self::Scenario(faults) => {
                    let count = faults.count();
                    let errors = if count == 1 {
                        "1 error"
                    } else {
                        &format!("{count} errors")
                    };
                    note(&faults.render(colours()));
                    note(&format!("\n{errors}; nothing was written"));
                }
                Self::Sweep { faults, left_out } => {
                    for (fault, runs) in faults {
                        note(&format!("{}\n  = runs: {runs}\n", fault.drawn));
                    }
                    let errors = match faults.len() + left_out {
                        1 => "1 error".to_string(),
                        count => format!("{count} errors"),
                    };
                    note(&format!("{errors}; nothing was written and no run was started"));
                }
                Self::Other { message, .. } => note(&format!("error: {message}")),
            }
        }
        self.exit()
    }

    fn exit(&self) -> Exit {
        match self {
            Self::Scenario(_) | Self::Sweep { .. } => Exit::Wrong,
            Self::Other { exit, .. } => *exit,
        }
    }

    fn to_json(&self) -> Value {
        let (message, diagnostics) = match self {
            Self::Scenario(faults) => {
                let listed = faults.list().iter().map(one_listed);
                ("the scenario is wrong".to_string(), listed.collect())
            }
            Self::Sweep { faults, .. } => {
                let one = |(fault, _): &(SweepFault, String)| {
                    let mut value = one_listed(&fault.diagnostic);
                    value["runs"] = json!(fault.runs);
                    value
                };
                (
                    "runs of the sweep are wrong".to_string(),
                    faults.iter().map(one).collect(),
                )
            }
            Self::Other { message, .. } => (message.clone(), Vec::new()),
        };
        let kind = match self.exit() {
            _ if !diagnostics.is_empty() => "scenario",
            Exit::Wrong => "command line",
            Exit::Fault => "simulation",
            Exit::Interrupted => "interrupted",
            _ => "input or output",
        };
        let mut error = json!({
            "kind": kind, "exit_code": self.exit() as u8, "message": message, "diagnostics": diagnostics,
        });
        if let Self::Scenario(faults) = self {
            error["errors"] = json!(faults.count());
        }
        json!({ "error": error })
    }
}

fn one_listed(d: &Diagnostic) -> Value {
    json!({
        "message": d.message, "help": d.help, "path": d.path,
        "source": d.source, "line": d.line, "column": d.column,
    })
}

impl From<Diagnostics> for Failure {
    fn from(faults: Diagnostics) -> Self {
        Self::Scenario(Box::new(faults))
    }
}

impl From<CalibrateError> for Failure {
    fn from(error: CalibrateError) -> Self {
        let exit = match error {
            CalibrateError::File(faults) => return Self::Scenario(faults),
            CalibrateError::Fault(_) | CalibrateError::Overlap { .. } | CalibrateError::Steps { .. } => Exit::Fault,
            _ => Exit::Wrong,
        };
        let message = error.to_string();
        Self::Other { exit, message }
    }
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        let message = error.to_string();
        if error.is_io() {
            Self::io(message)
        } else {
            Self::wrong(message)
        }
    }
}

impl From<RunError> for Failure {
    fn from(error: RunError) -> Self {
        let wrong = match error {
            RunError::Scenario(faults) => return Self::Scenario(faults),
            RunError::Output(ref output) => matches!(
                output,
                OutputError::HoldsARun { .. }
                    | OutputError::InUse { .. }
                    | OutputError::HoldsOtherFiles { .. }
                    | OutputError::NotAFolder { .. }
                    | OutputError::LinkToNowhere { .. }
                    | OutputError::NotARun { .. }
                    | OutputError::OtherSeries { .. }
                    | OutputError::OtherColumns { .. }
                    | OutputError::FilesGone { .. }
            ),
            RunError::Checkpoint(ref checkpoint) => matches!(checkpoint, CheckpointError::Missing { .. }),
            RunError::ThisProcess { rank, source } => return Self::from(*source).of_process(rank),
            RunError::Finished { .. }
            | RunError::FilesChanged { .. }
            | RunError::ScenarioChanged { .. }
            | RunError::OtherMaterials { .. }
            | RunError::OtherLaws { .. }
            | RunError::OtherStages { .. }
            | RunError::BeyondLaws(_)
            | RunError::OtherProcess { .. }
            | RunError::OtherInputs { .. }
            | RunError::NoFolder
            | RunError::State(_)
            | RunError::Motion { .. }
            | RunError::Deformation { .. }
            | RunError::Gravity { .. }
            | RunError::Laws { .. }
            | RunError::WallInTheWay { .. }
            | RunError::OtherTraffic
            | RunError::Feed { .. }
            | RunError::Exchange(_)
            | RunError::Instructions(_)
            | RunError::Threads { .. } => true,
        };
        let message = error.to_string();
        if wrong { Self::wrong(message) } else { Self::io(message) }
    }
}
