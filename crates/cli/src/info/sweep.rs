//! What is in the folder of a sweep.

use super::Info;
use crate::answer::Rows;
use crate::failure::Failure;
use demeter::sweep::{Status, SweepFolder};
use serde_json::json;
use std::path::Path;

/// Most runs that are listed.
const MOST_LISTED: usize = 50;

/// Tells what a sweep varies and how far it is.
pub fn sweep(path: &Path) -> Result<Info, Failure> {
    let folder = SweepFolder::open(path)?;
    let statuses = folder.statuses();
    let plan = &folder.plan;
    let mut rows = Rows::default();
    rows.add("scenario", plan.scenario.as_str());
    let keys: Vec<&str> = plan.columns.iter().map(|column| column.key.as_str()).collect();
    rows.add("varied", keys.join(", "));
    let finished = statuses.iter().filter(|status| status.is_finished()).count();
    rows.add("runs", format!("{finished} of {} finished", statuses.len()));
    for (run, status) in plan.runs.iter().zip(&statuses).take(MOST_LISTED) {
        rows.add(run.name.as_str(), status.name());
    }
    if statuses.len() > MOST_LISTED {
        rows.add("", format!("and {} more", statuses.len() - MOST_LISTED));
    }
    let runs = plan.runs.iter().zip(&statuses);
    let runs: Vec<serde_json::Value> = runs
        .map(|(run, status)| json!({ "name": run.name, "values": run.values, "state": status.name() }))
        .collect();
    let value = json!({
        "scenario": plan.scenario, "varied": keys, "finished": finished, "runs": runs,
        "failed": statuses.iter().filter_map(Status::failure).count(),
    });
    Ok(Info {
        kind: "sweep",
        rows,
        value,
    })
}
