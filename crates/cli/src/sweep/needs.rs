//! What the runs of a sweep will need, and how many may go on at a time.

use crate::answer::{aligned, answer, answer_json};
use crate::arguments::SweepArguments;
use crate::failure::Failure;
use crate::readable::{bytes, count, things, wait};
use demeter::scenario::available_memory;
use demeter::sweep::SweepFolder;
use serde_json::{Value, json};

/// Most runs that are listed as text.
const MOST_LISTED: usize = 200;

/// Runs at a time when nobody tells: one for every core and thread, as far as there are runs.
pub fn jobs(arguments: &SweepArguments, runs: usize) -> usize {
    let cores = num_cpus::get_physical().min(std::thread::available_parallelism().map_or(1, usize::from));
    let free = (cores / usize::from(arguments.threads)).max(1);
    arguments.jobs.map_or(free, |jobs| jobs as usize).min(runs.max(1))
}

/// Memory that runs may take together [bytes]; all of it where the system does not tell.
pub fn memory() -> u64 {
    available_memory().map_or(u64::MAX, |free| free as u64)
}

/// Lists the runs with what they will need.
pub fn tell(folder: &SweepFolder, arguments: &SweepArguments) -> Result<(), Failure> {
    let runs = &folder.plan.runs;
    let statuses = folder.statuses();
    let jobs = jobs(arguments, runs.len());
    let left = runs.iter().zip(&statuses).filter(|(_, status)| !status.is_finished());
    let times: Vec<f64> = left.map(|(run, _)| run.estimate.run_time).collect();
    let total: f64 = times.iter().sum();
    let longest = times.iter().copied().fold(0.0, f64::max);
    let together = (total / jobs as f64).max(longest);
    let mut largest: Vec<u64> = runs.iter().map(|run| run.estimate.memory).collect();
    largest.sort_unstable_by(|a, b| b.cmp(a));
    let memory: u64 = largest.iter().take(jobs).sum();
    if arguments.json {
        let one = |(index, run): (usize, &demeter::sweep::PlannedRun)| {
            let estimate = run.estimate;
            json!({
                "index": index, "name": run.name, "values": values(folder, index), "state": statuses[index].name(),
                "grains": estimate.grains, "steps": estimate.steps, "memory": estimate.memory, "run_time": estimate.run_time,
            })
        };
        let all: Vec<Value> = runs.iter().enumerate().map(one).collect();
        return answer_json(&json!({
            "folder": folder.root().display().to_string(), "runs": all, "jobs": jobs, "memory": memory,
            "run_time": total, "time": together,
        }));
    }
    let titles = ["", "run", "grains", "steps", "memory", "time"];
    let mut rows = vec![titles.map(str::to_string).to_vec()];
    for (index, run) in runs.iter().enumerate().take(MOST_LISTED) {
        let estimate = run.estimate;
        rows.push(vec![
            index.to_string(),
            run.name.clone(),
            count(estimate.grains),
            count(estimate.steps),
            bytes(estimate.memory),
            wait(estimate.run_time),
        ]);
    }
    let mut text = format!(
        "{}, nothing was written\n{}",
        things(runs.len() as u64, "run"),
        aligned(&rows)
    );
    if runs.len() > MOST_LISTED {
        text += &format!("  and {} more\n", runs.len() - MOST_LISTED);
    }
    text += &format!(
        "{} of computing on one thread; with {} at a time about {} and {} of memory, in {}\n",
        wait(total),
        things(jobs as u64, "run"),
        wait(together),
        bytes(memory),
        folder.root().display()
    );
    answer(&text)
}

/// The varied values of a run.
pub fn values(folder: &SweepFolder, index: usize) -> Value {
    let plan = &folder.plan;
    let pairs = plan.columns.iter().zip(&plan.runs[index].values);
    Value::Object(
        pairs
            .map(|(column, value)| (column.key.clone(), json!(value)))
            .collect(),
    )
}
