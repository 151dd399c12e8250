//! The processes of an MPI job, of which each runs this program.

#[cfg(feature = "mpi")]
use crate::answer;
use crate::failure::Failure;
#[cfg(feature = "mpi")]
use crate::mpi_job::MpiJob;
use demeter::comm::Ranks;
use demeter::scenario::{RunError, all_or_none};
use std::time::Duration;
#[cfg(feature = "mpi")]
use std::{cell::RefCell, rc::Rc};

/// Seconds after which a process gives up that hears nothing of the others, where `DEMETER_PATIENCE` tells no other.
#[cfg(feature = "mpi")]
const PATIENCE: u64 = 600;

/// Environment variables by which launchers tell a process how many there are, or which of them it is, with the least number that
/// tells of several: Open MPI, MPICH and its kin, Slurm.
const LAUNCHERS: [(&str, u32); 5] = [
    ("OMPI_COMM_WORLD_SIZE", 2),
    ("PMI_SIZE", 2),
    ("MPI_LOCALNRANKS", 2),
    ("PMIX_RANK", 1),
    ("SLURM_STEP_NUM_TASKS", 2),
];

/// Environment variables by which they tell a process which of them it is.
const PLACES: [&str; 4] = ["OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK", "SLURM_PROCID"];

/// Time in which a launcher ends the others once the first has ended with an error.
const TO_BE_ENDED: Duration = Duration::from_secs(2);

/// What launchers told this process.
fn launchers() -> impl Iterator<Item = (String, u32)> {
    LAUNCHERS
        .iter()
        .filter_map(|(name, several)| Some((std::env::var(name).ok()?, *several)))
}

/// Whether a launcher has started several processes.
fn are_several() -> bool {
    launchers().any(|(told, several)| told.parse::<u32>().is_ok_and(|number| number >= several))
}

/// Lets the first of several processes tell what is wrong with all before they know of each other. Where no launcher ends the others then,
/// they tell it, too: the first may have had another command line.
pub fn let_the_first_speak() {
    let is_later =
        |name| std::env::var(name).is_ok_and(|told: String| told.parse::<u32>().is_ok_and(|place| place > 0));
    if are_several() && PLACES.iter().any(is_later) {
        std::thread::sleep(TO_BE_ENDED);
    }
}

/// What is wrong with all processes, before they know of each other.
fn wrong_with_all(message: impl Into<String>) -> Failure {
    let_the_first_speak();
    Failure::wrong(message)
}

/// Refuses to be one of several processes that each do the same, where work is not shared.
pub fn refuse_several() -> Result<(), Failure> {
    if are_several() {
        return Err(wrong_with_all(
            "a launcher has started several processes, and each would do all of this: only `demeter run` and `demeter resume` \
             share their work. Start it once, without `mpirun`; `demeter sweep` uses all cores by itself, and `--slurm` many hosts",
        ));
    }
    Ok(())
}

/// Tells why the job is given up, whoever speaks otherwise.
#[cfg(feature = "mpi")]
fn tell(reason: &str) {
    answer::be_silent(false);
    answer::note(&format!("error: {reason}"));
}

#[cfg(feature = "mpi")]
type Mpi = Rc<(MpiJob, Duration)>;

#[cfg(feature = "mpi")]
thread_local! {
    /// Keeps the job until this process has told what it has to tell: the launcher ends all once one has ended with an error.
    static KEPT: RefCell<Option<Mpi>> = const { RefCell::new(None) };
}

/// Leaves the job, where there is one, together with the other processes. All is told by then: a launcher that ends those that are still
/// there, once one has ended with an error, does not interrupt them.
pub fn leave() {
    #[cfg(feature = "mpi")]
    if let Some(job) = KEPT.take() {
        answer::be_silent(true);
        drop(job);
    }
}

/// An MPI job, where a launcher such as `mpirun` has started this process.
pub struct Job {
    #[cfg(feature = "mpi")]
    mpi: Option<Mpi>,
}

impl Job {
    /// Joins the job. The first of several processes speaks for all.
    #[cfg(feature = "mpi")]
    pub fn join() -> Result<Self, Failure> {
        if launchers().next().is_none() {
            return Ok(Self { mpi: None });
        }
        let seconds = match std::env::var("DEMETER_PATIENCE") {
            Err(_) => PATIENCE,
            Ok(text) => text.parse().ok().filter(|&seconds| seconds > 0).ok_or_else(|| {
                wrong_with_all(format!(
                    "DEMETER_PATIENCE is `{text}`, not a whole number of seconds above 0"
                ))
            })?,
        };
        let mpi = MpiJob::begin().map_err(|error| Failure::io(error.to_string()))?;
        let patience = Duration::from_secs(seconds);
        let ranks = mpi.ranks(patience, tell);
        if ranks.count() == 1 && are_several() {
            return Err(wrong_with_all(
                "a launcher has started several processes, and MPI knows of one only: each would run all. The launcher must be that of \
                 the MPI that this program was built with; under Slurm `srun --mpi=pmix` (Open MPI) or `srun --mpi=pmi2` (MPICH), of \
                 those that `srun --mpi=list` tells",
            ));
        }
        if ranks.rank() > 0 {
            answer::be_silent(true);
        }
        let mpi = Rc::new((mpi, patience));
        KEPT.set(Some(Rc::clone(&mpi)));
        Ok(Self { mpi: Some(mpi) })
    }

    /// Refuses to be one of several processes, each of which would run all.
    #[cfg(not(feature = "mpi"))]
    pub fn join() -> Result<Self, Failure> {
        if are_several() {
            return Err(wrong_with_all(
                "this program was built without MPI, so that of several processes each would run all; build it with \
                 `cargo build --release -p demeter-cli --features mpi`, or run it without `mpirun`",
            ));
        }
        Ok(Self {})
    }

    /// The processes that share a run; `None` where there is one.
    pub fn ranks(&self) -> Option<Box<dyn Ranks>> {
        #[cfg(feature = "mpi")]
        if let Some((mpi, patience)) = self.mpi.as_deref() {
            let ranks = mpi.ranks(*patience, tell);
            return (ranks.count() > 1).then(|| Box::new(ranks) as Box<dyn Ranks>);
        }
        None
    }

    /// What all processes have read, or why one could not.
    pub fn agree<T>(&self, read: Result<T, impl Into<RunError>>) -> Result<T, Failure> {
        all_or_none(self.ranks().as_deref(), read.map_err(Into::into)).map_err(|error| self.fail(error))
    }

    /// Why the run failed. Where the other processes do not know, it is told, and they are ended.
    pub fn fail(&self, error: RunError) -> Failure {
        let is_first = self.ranks().is_none_or(|ranks| ranks.rank() == 0);
        match error {
            RunError::ThisProcess { .. } => self.end_all(Failure::from(error)),
            RunError::Output(_) | RunError::Checkpoint(_) if is_first => self.end_all(Failure::from(error)),
            error => Failure::from(error),
        }
    }

    fn end_all(&self, failure: Failure) -> Failure {
        #[cfg(feature = "mpi")]
        if let Some((mpi, _)) = self.mpi.as_deref().filter(|_| self.ranks().is_some()) {
            answer::be_silent(false);
            mpi.abort(failure.tell(false) as i32);
        }
        failure
    }
}
