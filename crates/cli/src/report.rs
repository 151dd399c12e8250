//! `demeter report`.

use crate::answer::{answer, answer_json, note};
use crate::arguments::ReportArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use serde_json::json;

/// Writes the report of a run anew.
pub fn report(arguments: &ReportArguments) -> Result<Exit, Failure> {
    let written = demeter::report::write(&arguments.folder)?;
    for problem in &written.problems {
        note(&format!("warning: {problem}"));
    }
    let path = written.path.display().to_string();
    if arguments.json {
        answer_json(&json!({ "report": path, "problems": written.problems }))?;
    } else {
        answer(&format!("{path}\n"))?;
    }
    Ok(Exit::Finished)
}
