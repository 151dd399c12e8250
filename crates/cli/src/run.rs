//! `demeter run` and `demeter resume`.

use crate::answer::{Rows, answer, answer_json};
use crate::arguments::{Engine, HowToRun, ResumeArguments, RunArguments};
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::job::Job;
use crate::profile;
use crate::progress::Watch;
use crate::readable::{count, number, things, vector, wait};
use demeter::output::{RunFolder, StageSummary};
use demeter::results::Run;
use demeter::scenario::{Report, RunEnd, RunError, RunOptions, Scenario};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Most stages that are told at the end; a summary holds them all.
const MOST_STAGES: usize = 12;
/// With more walls than this their forces at the end of a stage are left to `summary.json`.
const MOST_STAGE_WALLS: usize = 4;

/// Runs a scenario.
pub fn run(arguments: &RunArguments) -> Result<Exit, Failure> {
    let job = Job::join()?;
    let interrupt = Interrupt::listen();
    let mut scenario = job.agree(Scenario::read(&arguments.file, &arguments.set))?;
    // The scenario in the run folder must find its files wherever `resume` is called.
    scenario.base = absolute(&scenario.base)?;
    let folder = match &arguments.out {
        Some(folder) => folder.clone(),
        None => default_folder(&arguments.file)?,
    };
    let options = RunOptions {
        overwrite: arguments.overwrite,
        numbered: arguments.out.is_none() && !arguments.overwrite,
        ..options(&job, &arguments.output, &arguments.engine)
    };
    let mut watch = Watch::new(interrupt);
    let report = match job.ranks() {
        None => demeter::scenario::run(&scenario, &folder, options, &mut watch),
        Some(ranks) => demeter::scenario::run_shared(&scenario, &folder, options, ranks, &mut watch),
    };
    watch.end();
    tell(&report.map_err(|error| job.fail(error))?, arguments.output.json)
}

/// Goes on with a run.
pub fn resume(arguments: &ResumeArguments) -> Result<Exit, Failure> {
    let job = Job::join()?;
    let mut watch = Watch::new(Interrupt::listen());
    let options = RunOptions {
        changed: arguments.changed,
        ..options(&job, &arguments.output, &arguments.engine)
    };
    let report = match job.ranks() {
        None => demeter::scenario::resume(&arguments.folder, options, &mut watch),
        Some(ranks) => demeter::scenario::resume_shared(&arguments.folder, options, ranks, &mut watch),
    };
    watch.end();
    match report {
        Err(RunError::Finished { folder }) => finished(&folder, arguments.output.json),
        report => tell(&report.map_err(|error| job.fail(error))?, arguments.output.json),
    }
}

/// Tells that there was nothing to go on with, which is what was wanted.
fn finished(folder: &Path, as_json: bool) -> Result<Exit, Failure> {
    let shown = folder.display().to_string();
    let missing = Run::open(folder)?.missing()?;
    if !missing.is_empty() {
        return Err(Failure::io(format!(
            "the run in {shown} is finished, but its results are not whole: {}. What is gone is not made again from the checkpoint: put it back, or run the scenario again",
            missing.join("; ")
        )));
    }
    if as_json {
        let mut value = read_summary(folder)?;
        value["end"] = json!("finished");
        value["exit_code"] = json!(Exit::Finished as u8);
        value["folder"] = json!(shown);
        answer_json(&value)?;
    } else {
        answer(&format!("the run in {shown} is finished: nothing is left to do\n"))?;
    }
    Ok(Exit::Finished)
}

fn read_summary(folder: &Path) -> Result<Value, Failure> {
    let path = RunFolder::find(folder).map_err(RunError::from)?.summary();
    let fail = |error: &dyn std::fmt::Display| Failure::io(format!("cannot read `{}`: {error}", path.display()));
    let bytes = std::fs::read(&path).map_err(|error| fail(&error))?;
    serde_json::from_slice(&bytes).map_err(|error| fail(&error))
}

fn options(job: &Job, how: &HowToRun, engine: &Engine) -> RunOptions {
    // processes that share a machine must not each take all of its cores
    let alone = job.ranks().is_none();
    RunOptions {
        threads: how.threads.map(usize::from).or((!alone).then_some(1)),
        instructions: engine.instructions,
        profile: engine.profile,
        ..RunOptions::default()
    }
}

fn absolute(path: &Path) -> Result<PathBuf, Failure> {
    let path = if path.as_os_str().is_empty() {
        Path::new(".")
    } else {
        path
    };
    std::path::absolute(path).map_err(|error| Failure::io(format!("cannot find `{}`: {error}", path.display())))
}

/// `runs/NAME`.
fn default_folder(scenario: &Path) -> Result<PathBuf, Failure> {
    Ok(Path::new("runs").join(run_name(&absolute(scenario)?)))
}

/// Name of the runs of a scenario: that of its file, or of its folder when the file is `scenario.toml`.
pub fn run_name(scenario: &Path) -> String {
    let text = |name: Option<&std::ffi::OsStr>| name.map(|n| n.to_string_lossy().into_owned());
    let folder = || text(scenario.parent()?.file_name());
    match text(scenario.file_stem()) {
        Some(stem) if stem == "scenario" => folder().unwrap_or(stem),
        Some(stem) => stem,
        None => "run".to_string(),
    }
}

/// Tells how a run ended.
fn tell(report: &Report, as_json: bool) -> Result<Exit, Failure> {
    let exit = match report.end {
        RunEnd::Finished => Exit::Finished,
        RunEnd::Interrupted => Exit::Interrupted,
        RunEnd::Fault(_) => Exit::Fault,
    };
    if as_json {
        answer_json(&to_json(report, exit)?)?;
    } else {
        answer(&to_text(report))?;
    }
    Ok(exit)
}

fn picture(report: &Report) -> Option<PathBuf> {
    let picture = RunFolder::find(&report.folder).ok()?.picture();
    picture.is_file().then_some(picture)
}

fn page(report: &Report) -> Option<PathBuf> {
    let page = RunFolder::find(&report.folder).ok()?.report();
    page.is_file().then_some(page)
}

fn to_json(report: &Report, exit: Exit) -> Result<Value, Failure> {
    let mut value = serde_json::to_value(&report.summary)
        .map_err(|error| Failure::io(format!("the summary is no JSON: {error}")))?;
    let (end, fault) = match &report.end {
        RunEnd::Finished => ("finished", Value::Null),
        RunEnd::Interrupted => ("interrupted", Value::Null),
        RunEnd::Fault(fault) => ("fault", json!({ "message": fault.to_string(), "grain": fault.grain() })),
    };
    value["end"] = json!(end);
    value["fault"] = fault;
    value["exit_code"] = json!(exit as u8);
    value["folder"] = json!(report.folder.display().to_string());
    value["picture"] = json!(picture(report).map(|p| p.display().to_string()));
    value["report"] = json!(page(report).map(|p| p.display().to_string()));
    Ok(value)
}

/// Who did the work.
fn workers(threads: usize, processes: usize) -> String {
    let threads = things(threads as u64, "thread");
    match processes {
        0 | 1 => threads,
        many => format!("{threads} of each of {many} processes"),
    }
}

fn to_text(report: &Report) -> String {
    let summary = &report.summary;
    let folder = report.folder.display();
    let head = match &report.end {
        RunEnd::Finished => "finished".to_string(),
        RunEnd::Interrupted => {
            format!("interrupted; a checkpoint was written. Go on with `demeter resume {folder}`")
        }
        // the fault itself was told when it happened
        RunEnd::Fault(fault) => match fault.grain() {
            0 => "stopped on a fault; the last frame shows it".to_string(),
            grain => format!("stopped on a fault of grain {grain}; the last frame shows it"),
        },
    };
    let mut rows = Rows::default();
    rows.add("results", folder.to_string());
    if let Some(page) = page(report) {
        rows.add("report", format!("{} (open it in a browser)", page.display()));
    }
    if let Some(picture) = picture(report) {
        rows.add("picture", picture.display().to_string());
    }
    rows.add(
        "time",
        format!(
            "{} s in {} of {} s",
            number(summary.simulated_time),
            things(summary.steps, "step"),
            number(summary.time_step)
        ),
    );
    rows.add(
        "grains",
        format!(
            "{} with {}",
            things(summary.grains, "grain"),
            things(summary.contacts, "contact")
        ),
    );
    for stage in summary.stages.iter().take(MOST_STAGES) {
        let span = format!("{} s to {} s", number(stage.start), number(stage.end));
        rows.add(format!("stage {}", stage.name), format!("{span}: {}", stage.ended_by));
        if !stage.walls.is_empty() && stage.walls.len() <= MOST_STAGE_WALLS {
            let loads = stage.walls.iter().map(|(name, wall)| {
                let [x, y, z] = wall.force;
                format!("`{name}` {} N", number((x * x + y * y + z * z).sqrt()))
            });
            rows.add("", format!("force on {}", loads.collect::<Vec<_>>().join(", ")));
        }
        if let Some(powers) = mean_powers(stage) {
            rows.add("", powers);
        }
    }
    if let Some(more) = summary.stages.len().checked_sub(MOST_STAGES).filter(|more| *more > 0) {
        rows.add("stages", format!("and {more} more in summary.json"));
    }
    for (name, wall) in &summary.walls {
        let touching = things(u64::from(wall.contacts), "contact");
        rows.add(
            format!("wall {name}"),
            format!("force {} N, {touching}", vector(wall.force)),
        );
    }
    let energies = &summary.energies;
    rows.add(
        "energy residual",
        format!(
            "{:.1e} at the end, {:.1e} at most",
            energies.ledger.residual, energies.max_residual
        ),
    );
    rows.add(
        "speed",
        format!(
            "{} particle-steps/s on {}, {} of computing",
            count(summary.particle_steps_per_second as u64),
            workers(summary.threads, summary.processes),
            wait(summary.wall_clock_time)
        ),
    );
    let profile = summary.profile.as_ref().map(profile::to_text).unwrap_or_default();
    format!("{head}\n{}{profile}", rows.lines())
}

/// Mean power of the walls that did work in a stage, in words.
fn mean_powers(stage: &StageSummary) -> Option<String> {
    let at_work = || stage.walls.iter().filter(|(_, wall)| wall.work != 0.0);
    match at_work().count() {
        0 => None,
        count if count > MOST_STAGE_WALLS => {
            let all: f64 = at_work().map(|(_, wall)| wall.mean_power).sum();
            Some(format!("mean power of {count} walls together {} W", number(all)))
        }
        _ => {
            let powers = at_work().map(|(name, wall)| format!("`{name}` {} W", number(wall.mean_power)));
            Some(format!("mean power of {}", powers.collect::<Vec<_>>().join(", ")))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_named_after_its_scenario() {
        let cases = [
            ("/a/drum.toml", "drum"),
            ("/a/mill/scenario.toml", "mill"),
            ("/scenario.toml", "scenario"),
        ];
        for (path, name) in cases {
            assert_eq!(run_name(Path::new(path)), name);
        }
    }
}
