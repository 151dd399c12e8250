//! What processes that share a run agree on before its first step.

use crate::comm::Ranks;
use crate::particles::Grains;
use crate::scenario::Scenario;
use crate::scenario::run_error::RunError;
use serde::{Deserialize, Serialize};

/// What all processes must have alike.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Inputs {
    version: String,
    /// Checksums of the program, of the scenario as it is run, and of the grains at the start.
    program: Option<u32>,
    scenario: u32,
    grains: u32,
}

impl Inputs {
    pub(super) fn of(scenario: &Scenario, grains: &Grains) -> Self {
        let mut table = crc32fast::Hasher::new();
        table.update(bytemuck::cast_slice(&grains.id));
        table.update(bytemuck::cast_slice(&grains.material));
        table.update(&grains.pack(0..grains.len()));
        let program = std::env::current_exe().and_then(std::fs::read);
        Self {
            version: crate::VERSION.to_string(),
            program: program.ok().map(|bytes| crc32fast::hash(&bytes)),
            scenario: crc32fast::hash(scenario.to_resolved_toml().as_bytes()),
            grains: table.finalize(),
        }
    }

    /// What differs from that of another process, in words.
    fn other(&self, other: &Self) -> Option<String> {
        if self.version != other.version {
            return Some(format!("version {} of Demeter, not {}", other.version, self.version));
        }
        let differs = [
            (self.program != other.program, "another program of the same version"),
            (self.scenario != other.scenario, "another scenario"),
            (
                self.grains != other.grains,
                "other grains at the start (a packing file or a checkpoint differs)",
            ),
        ];
        let first = differs.into_iter().find(|(differs, _)| *differs);
        first.map(|(_, what)| what.to_string())
    }
}

/// What was done, where it was done by all processes that share a run; each calls this. Where not, each gets an error, and the one
/// that can tell why gets that: the first process, or those that failed where it did not.
pub fn all_or_none<T>(ranks: Option<&dyn Ranks>, done: Result<T, RunError>) -> Result<T, RunError> {
    let Some(ranks) = ranks else { return done };
    let failed = ranks.gather_even(&[u8::from(done.is_err())]);
    let Some(first) = failed.iter().position(|&failed| failed != 0) else {
        return done;
    };
    let rank = ranks.rank();
    match done {
        Err(error) if rank == 0 => Err(error),
        Err(error) if first != 0 => Err(RunError::ThisProcess {
            rank,
            source: Box::new(error),
        }),
        _ => Err(RunError::OtherProcess { rank: first }),
    }
}

/// Checks that all processes have the same inputs; each calls this.
pub(super) fn agree(ranks: &dyn Ranks, mine: &Inputs) -> Result<(), RunError> {
    // encoding into memory fails for no value of ours
    let all = ranks.gather(&postcard::to_stdvec(mine).unwrap_or_default());
    let first: Option<Inputs> = all.first().and_then(|bytes| postcard::from_bytes(bytes).ok());
    for (rank, bytes) in all.iter().enumerate() {
        let what = match (&first, postcard::from_bytes::<Inputs>(bytes)) {
            (Some(first), Ok(other)) => first.other(&other),
            _ => Some("another program".to_string()),
        };
        if let Some(what) = what {
            return Err(RunError::OtherInputs { rank, what });
        }
    }
    Ok(())
}
