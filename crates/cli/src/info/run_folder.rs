//! What is in the folder of a run, and in a checkpoint.

use super::{Info, series};
use crate::answer::Rows;
use crate::failure::Failure;
use crate::readable::{number, things};
use demeter::checkpoint::{self, Header};
use demeter::output::RunFolder;
use demeter::results::{Run, finished_steps, shortfall};
use demeter::scenario::RunError;
use serde_json::{Value, json};
use std::path::Path;

/// Tells what is in a checkpoint.
pub fn one_checkpoint(path: &Path) -> Result<Info, Failure> {
    let header = checkpoint::read_header(path).map_err(RunError::from)?;
    let mut rows = Rows::default();
    rows.add("title", header.title.as_str());
    rows.add("state", state(&header));
    rows.add("written by", format!("demeter {}", header.engine_version));
    Ok(Info {
        kind: "checkpoint",
        rows,
        value: to_json(&header),
    })
}

fn state(header: &Header) -> String {
    let (grains, contacts) = (things(header.grains, "grain"), things(header.contacts, "contact"));
    format!("step {}, {} s, {grains}, {contacts}", header.step, number(header.time))
}

fn to_json(header: &Header) -> Value {
    json!({
        "title": header.title,
        "step": header.step,
        "time": header.time,
        "grains": header.grains,
        "contacts": header.contacts,
        "version": header.engine_version,
    })
}

/// Tells what is in the folder of a run.
pub fn run_folder(path: &Path) -> Result<Info, Failure> {
    let folder = RunFolder::find(path).map_err(RunError::from)?;
    let summary = read_summary(&folder)?;
    let latest = path.join(checkpoint::LATEST);
    let header = latest.is_file().then(|| checkpoint::read_header(&latest));
    let span = folder
        .series()
        .is_file()
        .then(|| series::span(&folder.series()))
        .transpose()?;
    let frames = frames(&folder);

    let mut rows = Rows::default();
    match &summary {
        None => rows.add(
            "state",
            "not ended: it runs now, or it was killed (`demeter resume` goes on)",
        ),
        Some(summary) => {
            rows.add("title", words(&summary["title"]));
            rows.add("ended", words(&summary["stopped_by"]));
            let time = summary["simulated_time"].as_f64().unwrap_or(f64::NAN);
            let [steps, grains] = [("steps", "step"), ("grains", "grain")].map(|(key, one)| {
                summary[key]
                    .as_u64()
                    .map_or_else(|| words(&summary[key]), |n| things(n, one))
            });
            rows.add("time", format!("{} s in {steps}, {grains}", number(time)));
            let residual = summary["energies"]["max_residual"].as_f64().unwrap_or(f64::NAN);
            rows.add("energy residual", format!("{residual:.1e} at most"));
        }
    }
    match &header {
        None => rows.add("checkpoint", "none yet"),
        Some(Ok(header)) => rows.add("checkpoint", state(header)),
        Some(Err(error)) => rows.add("checkpoint", error.to_string()),
    }
    if let Some(span) = &span {
        rows.add(
            "series",
            format!("{} of {} columns", things(span.rows, "row"), span.columns.len()),
        );
    }
    let steps = summary
        .as_ref()
        .and_then(finished_steps)
        .filter(|_| !folder.is_locked());
    let short = span
        .as_ref()
        .zip(steps)
        .filter(|(span, steps)| span.last_step < Some(*steps));
    let problem = short.map(|(span, steps)| shortfall(span.last_step, steps));
    if let Some(problem) = &problem {
        rows.add("", format!("damaged: {problem}"));
    }
    rows.add("frames", frames.to_string());
    let missing = Run::open(path)?.missing_frames()?;
    if let Some(problem) = &missing {
        rows.add("", format!("damaged: {problem}"));
    }
    let value = json!({
        "summary": summary,
        "checkpoint": header.and_then(Result::ok).map(|h| to_json(&h)),
        "series_rows": span.map(|s| s.rows),
        "series_problem": problem,
        "frames": frames,
        "frames_problem": missing,
    });
    Ok(Info {
        kind: "run",
        rows,
        value,
    })
}

/// The text of a JSON value without quotes.
fn words(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

fn read_summary(folder: &RunFolder) -> Result<Option<Value>, Failure> {
    let path = folder.summary();
    if !path.is_file() {
        return Ok(None);
    }
    let fail = |error: &dyn std::fmt::Display| Failure::io(format!("cannot read `{}`: {error}", path.display()));
    let bytes = std::fs::read(&path).map_err(|error| fail(&error))?;
    serde_json::from_slice(&bytes).map(Some).map_err(|error| fail(&error))
}

/// Number of frames of the grains.
fn frames(folder: &RunFolder) -> usize {
    let entries = std::fs::read_dir(folder.frames());
    let names = entries.into_iter().flatten().flatten().map(|entry| entry.file_name());
    let is_frame = |name: &str| name.starts_with("grains_") && name.ends_with(".vtp");
    names.filter(|name| is_frame(&name.to_string_lossy())).count()
}
