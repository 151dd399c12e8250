//! `demeter check`.

use crate::answer::{Rows, answer, answer_json, note};
use crate::arguments::CheckArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::readable::{bytes, count, number, things, wait};
use crate::{check_motions, check_walls};
use demeter::scenario::{Fed, Prepared, Scenario, TimeStep, WallReport, inspect_walls, prepare};
use serde_json::{Value, json};

/// Most stages that are told.
const MOST_STAGES: usize = 20;

/// Tells all that is wrong with a scenario, or how it would run.
pub fn check(arguments: &CheckArguments) -> Result<Exit, Failure> {
    let scenario = Scenario::read(&arguments.file, &arguments.set)?;
    let prepared = prepare(&scenario)?;
    let walls = inspect_walls(&scenario, &prepared);
    if arguments.json {
        answer_json(&to_json(&scenario, &prepared, &walls))?;
    } else {
        for warning in &prepared.warnings {
            note(&format!("warning: {warning}"));
        }
        answer(&to_text(&scenario, &prepared, &walls))?;
    }
    Ok(Exit::Finished)
}

fn to_text(scenario: &Scenario, prepared: &Prepared, report: &WallReport) -> String {
    let setup = &prepared.setup;
    let mut rows = Rows::default();
    rows.add("title", scenario.title.as_str());
    rows.add("time step", prepared.time_step_reason.as_str());
    if let Some(borne) = &prepared.fastest_impact {
        let gravity = setup.gravity.length();
        let fall = match gravity > 0.0 {
            true => format!(", as from a fall of {} m,", number(borne.height(gravity))),
            false => String::new(),
        };
        let overlap = number(setup.max_overlap);
        rows.add(
            "impacts",
            format!(
                "{} m/s head-on{fall} overlap {} by {overlap} r, the most that is allowed",
                number(borne.speed),
                borne.bodies
            ),
        );
    }
    let batches = things(scenario.grains.len() as u64, "batch").replace("batchs", "batches");
    rows.add("grains", format!("{} in {batches}", count(setup.grains.len() as u64)));
    if !scenario.feeds.is_empty() {
        let all = names(&scenario.feeds, |feed| &feed.name).join(", ");
        rows.add("feeds", format!("{all}: {}", fed(&prepared.fed)));
    }
    if !scenario.removals.is_empty() {
        rows.add(
            "removals",
            names(&scenario.removals, |removal| &removal.name).join(", "),
        );
    }
    let names: Vec<&str> = names(&scenario.walls, |wall| &wall.name);
    rows.add(
        "walls",
        if names.is_empty() {
            "none".to_string()
        } else {
            names.join(", ")
        },
    );
    if !scenario.walls.is_empty() {
        check_walls::add_rows(scenario, prepared, report, &mut rows);
        check_motions::add_rows(scenario, prepared, &mut rows);
    }
    let stages = scenario.stages.iter().zip(&prepared.stage_steps);
    for (index, (stage, steps)) in stages.enumerate().take(MOST_STAGES) {
        let early = if stage.stop.len() > 1 {
            ", or until a condition ends it"
        } else {
            ""
        };
        let time = number(*steps as f64 * setup.dt);
        rows.add(
            format!("stage {}", stage.name),
            format!("{}, {time} s{early}", things(*steps, "step")),
        );
        for words in check_motions::of_stage(scenario, prepared, index) {
            rows.add("", words);
        }
    }
    if let Some(more) = scenario.stages.len().checked_sub(MOST_STAGES).filter(|more| *more > 0) {
        rows.add("stages", format!("and {more} more"));
    }
    rows.add("steps", count(prepared.steps));
    // grains that come may leave
    let about = if prepared.fed.grains > 0.0 {
        "at most about"
    } else {
        "about"
    };
    rows.add("memory", format!("{about} {}", bytes(prepared.memory)));
    let each = bytes(prepared.frame_bytes);
    let all = bytes(prepared.frame_bytes.saturating_mul(prepared.frames));
    let frames = things(prepared.frames, "frame");
    rows.add("frames", format!("{frames} of {about} {each}, {all} together"));
    let (each, all) = (
        bytes(prepared.row_bytes),
        bytes(prepared.row_bytes.saturating_mul(prepared.rows)),
    );
    let told = things(prepared.rows, "row");
    rows.add("series", format!("{told} of about {each}, {all} together"));
    rows.add("run time", format!("{about} {} on one thread", wait(prepared.run_time)));
    let longest = prepared.time_scale.largest(setup.integrator);
    if scenario.simulation.time_step == TimeStep::Auto && longest > setup.dt {
        let time = wait(prepared.run_time * setup.dt / longest);
        rows.add(
            "",
            format!(
                "{about} {time} with `simulation.time_step = \"longest\"`, {longest:.3e} s: errors of energy and of collisions grow \
                 with the square of the step"
            ),
        );
    }
    format!("{} is right\n{}", scenario.name, rows.lines())
}

/// How many grains feeds let come.
fn fed(fed: &Fed) -> String {
    let known = format!("about {} come", things(fed.grains.round() as u64, "grain"));
    match (fed.unknown.as_slice(), fed.grains > 0.0) {
        ([], _) => known,
        (unknown, true) => format!(
            "{known}, and as many as there is room for by {}, which are not counted below",
            unknown.join(", ")
        ),
        (_, false) => "as many grains come as there is room for, which are not counted below".to_string(),
    }
}

/// Names of things.
fn names<T>(things: &[T], name: impl Fn(&T) -> &String) -> Vec<&str> {
    things.iter().map(|thing| name(thing).as_str()).collect()
}

fn to_json(scenario: &Scenario, prepared: &Prepared, report: &WallReport) -> Value {
    let stages = scenario.stages.iter().zip(&prepared.stage_steps);
    let stages: Vec<Value> = stages
        .map(|(stage, steps)| json!({ "name": stage.name, "steps": steps, "conditions": stage.stop.len() }))
        .collect();
    let walls = names(&scenario.walls, |wall| &wall.name);
    let materials: Vec<&str> = scenario.materials.iter().map(|m| m.name.as_str()).collect();
    json!({
        "scenario": scenario.name,
        "title": scenario.title,
        "time_step": prepared.setup.dt,
        "time_step_reason": prepared.time_step_reason,
        "grains": prepared.setup.grains.len(),
        "materials": materials,
        "feeds": names(&scenario.feeds, |feed| &feed.name),
        "fed": prepared.fed.grains,
        "removals": names(&scenario.removals, |removal| &removal.name),
        "walls": walls,
        "motions": check_motions::to_json(scenario, prepared),
        "wall_report": check_walls::to_json(scenario, prepared, report),
        "stages": stages,
        "steps": prepared.steps,
        "memory": prepared.memory,
        "run_time": prepared.run_time,
        "fastest_impact": prepared.fastest_impact.as_ref().map(|borne| borne.speed),
        "longest_time_step": prepared.time_scale.largest(prepared.setup.integrator),
        "frames": prepared.frames,
        "frame_bytes": prepared.frame_bytes,
        "rows": prepared.rows,
        "row_bytes": prepared.row_bytes,
        "warnings": prepared.warnings,
    })
}
