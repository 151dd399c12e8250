//! What the folder of a run holds.

use demeter::checkpoint;
use demeter::output::RunFolder;
use demeter::scenario::Scenario;
use std::fs;
use std::path::{Path, PathBuf};

/// What a folder holds, beside a scenario that is to run in it.
pub(crate) enum State {
    /// Nothing.
    Free,
    /// A run of the scenario, finished.
    Finished,
    /// A run of the scenario that can go on.
    Begun,
    /// Something else.
    Other,
}

/// A path that means the same from any folder.
pub(crate) fn absolute(path: &Path) -> PathBuf {
    let path = if path.as_os_str().is_empty() {
        Path::new(".")
    } else {
        path
    };
    std::path::absolute(path).unwrap_or_else(|_| path.to_owned())
}

/// What a folder holds.
pub(crate) fn state(folder: &Path, scenario: &Scenario) -> State {
    let free = match fs::read_dir(folder) {
        Ok(mut entries) => entries.next().is_none(),
        Err(error) => error.kind() == std::io::ErrorKind::NotFound,
    };
    if free {
        return State::Free;
    }
    let resolved = RunFolder::find(folder).and_then(|found| {
        let path = found.scenario();
        fs::read_to_string(&path).map_err(|source| demeter::output::OutputError::Io {
            action: "read",
            path,
            source,
        })
    });
    let same = resolved.is_ok_and(|text| text == scenario.to_resolved_toml());
    let version = told(&folder.join("run.json"), "version");
    if !same || version.is_none_or(|version| version != demeter::VERSION) {
        return State::Other;
    }
    if told(&folder.join("summary.json"), "finished").is_some_and(|finished| finished == true) {
        State::Finished
    } else if folder.join(checkpoint::LATEST).is_file() {
        State::Begun
    } else {
        State::Other
    }
}

/// A value of a file of JSON in a run folder.
pub(crate) fn told(path: &Path, key: &str) -> Option<serde_json::Value> {
    let text = fs::read_to_string(path).ok()?;
    let value: serde_json::Value = serde_json::from_str(&text).ok()?;
    value.get(key).cloned()
}
