//! What processes that share a run agree on before its first step.

use crate::comm::Ranks;
use crate::scenario::Scenario;
use crate::scenario::input_files::{Content, InputFile, content};
use crate::scenario::resolved;
use crate::scenario::run_error::RunError;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What all processes must have alike.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Inputs {
    version: String,
    program: Option<Content>,
    /// Checksum of the scenario as it is run.
    scenario: u32,
    files: Vec<InputFile>,
}

impl Inputs {
    pub(super) fn of(scenario: &Scenario) -> Self {
        let program = std::env::current_exe().and_then(|path| content(&path));
        Self {
            version: crate::VERSION.to_string(),
            program: program.ok(),
            // paths as they were told: files may lie elsewhere on another host
            scenario: crc32fast::hash(resolved::write(&scenario.document.root, Path::new("")).as_bytes()),
            files: scenario.input_files(),
        }
    }

    /// What differs from that of another process, in words.
    fn other(&self, other: &Self) -> Option<String> {
        if self.version != other.version {
            return Some(format!("version {} of Demeter, not {}", other.version, self.version));
        }
        if self.program != other.program {
            return Some("another program of the same version".to_string());
        }
        if self.scenario != other.scenario {
            return Some("another scenario, by its file or by what `--set` changes".to_string());
        }
        // files of one scenario: only what is in them can differ
        let files = self.files.iter().zip(&other.files);
        let (_, file) = files.into_iter().find(|(mine, others)| !mine.is_like(others))?;
        Some(format!("something else in `{}`", file.path.display()))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn processes_are_told_apart_by_what_is_in_their_files() {
        let place = tempfile::tempdir().unwrap();
        let mesh = place.path().join("plate.stl");
        let plate = |z: f64| {
            format!(
                "solid p\nfacet normal 0 0 1\nouter loop\nvertex 0 0 {z}\nvertex 1 0 {z}\nvertex 0 1 {z}\nendloop\nendfacet\nendsolid p\n"
            )
        };
        std::fs::write(&mesh, plate(1.0)).unwrap();
        let text = format!(
            "{}\n[[wall]]\nname = \"plate\"\nmaterial = \"steel\"\nshape = \"mesh\"\nfile = \"plate.stl\"\nunit = \"m\"\n",
            include_str!("../../../tests/engine/shared_runs/mixer.toml")
        );
        let scenario = Scenario::parse(&text, "mixer.toml", place.path(), &[]).unwrap();
        let inputs = || Inputs::of(&scenario);
        let first = inputs();
        assert_eq!(first.other(&inputs()), None);
        let elsewhere = tempfile::tempdir().unwrap();
        std::fs::copy(&mesh, elsewhere.path().join("plate.stl")).unwrap();
        let there = Scenario::parse(&text, "mixer.toml", elsewhere.path(), &[]).unwrap();
        assert_eq!(first.other(&Inputs::of(&there)), None);
        std::fs::write(&mesh, plate(2.0)).unwrap();
        let told = first.other(&inputs()).unwrap();
        assert!(
            told.starts_with("something else in `") && told.ends_with("plate.stl`"),
            "{told}"
        );
        assert!(first.files[0].change().unwrap().contains("holds something else"));
        std::fs::remove_file(&mesh).unwrap();
        assert!(first.files[0].change().unwrap().contains("is gone"));
    }
}
