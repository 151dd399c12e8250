//! Why a run could not be carried out.

use super::Diagnostics;
use crate::checkpoint::CheckpointError;
use crate::contacts::Fault;
use crate::insertion::InsertionProblem;
use crate::output::OutputError;
use crate::simulation::{ChangeError, DeformationError, ExchangeError, StateError, WallInTheWay};
use crate::walls::WallError;
use demeter_physics::lanes::NoSuchInstructions;
use std::path::PathBuf;

/// Why a run could not be carried out.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The scenario is wrong.
    #[error("{0}")]
    Scenario(Box<Diagnostics>),
    /// Results could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A checkpoint could not be written or read.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
    /// The checkpoint does not fit the scenario.
    #[error(transparent)]
    State(#[from] StateError),
    /// Files that the scenario names were changed since the run began.
    #[error(
        "files of the scenario are not what they were when the run began:\n  {}\nPut them back as they were, or begin the run \
         anew in another folder.",
        changes.join("\n  ")
    )]
    FilesChanged {
        /// Each with what changed.
        changes: Vec<String>,
    },
    /// The scenario in the folder was changed since the run began.
    #[error(
        "`{}` is not what it was when the run began: {difference}\nPut it back as it was, or begin the run anew in another folder. To go \
         on with what it tells now nevertheless, tell `--changed` (in Python `changed=True`).",
        file.display()
    )]
    ScenarioChanged {
        /// The scenario in the folder.
        file: PathBuf,
        /// What changed.
        difference: String,
    },
    /// The scenario in the folder has other materials than the grains.
    #[error(
        "`{}` tells the materials {is}, and the run began with {was}: grains keep theirs by place in this list, so that it must stay as it was",
        file.display()
    )]
    OtherMaterials {
        /// The scenario in the folder.
        file: PathBuf,
        /// Names now.
        is: String,
        /// Names when the run began.
        was: String,
    },
    /// The scenario in the folder has no stage of the name of that which the run is in.
    #[error(
        "{} stage `{stage}`, and `{}` has no stage of this name now: it has {stages}. Stages before and behind may change; keep this \
         one with its name, and shorten it where it is to end at once",
        if *is_over { "the run has just ended" } else { "the run is in" }, file.display()
    )]
    OtherStages {
        /// The scenario in the folder.
        file: PathBuf,
        /// The stage that the run is in, or that was its last.
        stage: String,
        /// Whether the run has ended that one.
        is_over: bool,
        /// The stages that there are.
        stages: String,
    },
    /// The scenario in the folder tells laws for which contacts remember something else.
    #[error(
        "what contacts of {pair} remember in the checkpoint is that of {was}, and the scenario tells {is} now: a run goes on with other \
         parameters of laws that remember something, but not with others. Remedy: begin a new run with the grains of this one \
         (`source = \"file\"`)"
    )]
    OtherLaws {
        /// The materials.
        pair: String,
        /// Laws now.
        is: String,
        /// Laws when the run began.
        was: String,
    },
    /// The state is none that the laws of the changed scenario cover.
    #[error("the run cannot go on with the laws that the scenario tells now: {0}")]
    BeyondLaws(Box<Fault>),
    /// There is nothing to go on with.
    #[error("the run in `{}` is finished: nothing is left to do", folder.display())]
    Finished {
        /// The folder of the run.
        folder: PathBuf,
    },
    /// A run without a folder has none to write into.
    #[error("this run writes no folder: tell one for the checkpoint")]
    NoFolder,
    /// A stage tells a wall a motion that it cannot make.
    #[error("stage `{stage}`: {source}")]
    Motion {
        /// The stage.
        stage: String,
        /// Why.
        source: WallError,
    },
    /// A stage tells the box a deformation that it cannot make.
    #[error("stage `{stage}`: {source}")]
    Deformation {
        /// The stage.
        stage: String,
        /// Why.
        source: DeformationError,
    },
    /// A stage tells a gravity that cannot act.
    #[error("stage `{stage}`: {source}")]
    Gravity {
        /// The stage.
        stage: String,
        /// Why.
        source: Box<ChangeError>,
    },
    /// The state is none that the laws of a stage cover.
    #[error("the laws of stage `{stage}` have no force for the state that it begins with: {source}")]
    Laws {
        /// The stage.
        stage: String,
        /// Why.
        source: Box<Fault>,
    },
    /// A wall comes where a grain is.
    #[error("stage `{stage}`: {source}")]
    WallInTheWay {
        /// The stage.
        stage: String,
        /// What is in the way.
        source: Box<WallInTheWay>,
    },
    /// The checkpoint holds other feeds, removals or measures that remember than the scenario tells.
    #[error(
        "the checkpoint holds other feeds, removals or measures that remember what happened (mass-flow, residence, displacement, field, \
         collisions) than the scenario tells: a run goes on with as many of them as it began with, and with the bins and cells that these \
         had. Profiles, force distributions, paths and force chains may be added"
    )]
    OtherTraffic,
    /// Another process that shares the run failed, and tells why.
    #[error("process {rank} failed")]
    OtherProcess {
        /// Number of the process.
        rank: usize,
    },
    /// This process failed and the first one that shares the run did not.
    #[error("process {rank}: {source}")]
    ThisProcess {
        /// Number of the process.
        rank: usize,
        /// Why.
        source: Box<RunError>,
    },
    /// Processes that are to share the run do not have the same.
    #[error(
        "process {rank} differs from process 0: it has {what}. All processes of a run need the same program, the same options and \
         the same files, on every host"
    )]
    OtherInputs {
        /// Number of the process.
        rank: usize,
        /// What it has.
        what: String,
    },
    /// A feed cannot serve.
    #[error("feed `{feed}`: {problem}")]
    Feed {
        /// Its name.
        feed: String,
        /// Why.
        problem: Box<InsertionProblem>,
    },
    /// Grains cannot come.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
    /// This processor lacks the instructions that were asked for.
    #[error(transparent)]
    Instructions(#[from] NoSuchInstructions),
    /// The threads could not be started.
    #[error("cannot start {threads} threads: {reason}")]
    Threads {
        /// Number asked for.
        threads: usize,
        /// Why not, and what to do.
        reason: String,
    },
}

impl RunError {
    /// The fault that this is in a run that has begun, where it comes from the state of the run.
    pub(super) fn in_a_run(self, step: u64) -> Result<Fault, Self> {
        let id = match &self {
            Self::WallInTheWay { source, .. } => source.grain,
            Self::Motion { .. }
            | Self::Deformation { .. }
            | Self::Gravity { .. }
            | Self::Laws { .. }
            | Self::Feed { .. }
            | Self::Exchange(_) => 0,
            _ => return Err(self),
        };
        let reason = self.to_string();
        Ok(Fault::CannotGoOn { step, id, reason })
    }
}

impl From<Diagnostics> for RunError {
    fn from(faults: Diagnostics) -> Self {
        Self::Scenario(Box::new(faults))
    }
}
