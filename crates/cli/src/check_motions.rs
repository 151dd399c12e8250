//! What `demeter check` tells of how walls move: an axis that is not the one meant is seen before the run.

use crate::answer::Rows;
use crate::readable::{number, vector};
use demeter::scenario::{Prepared, Scenario};
use demeter::walls::{BodyMotion, Freedom, Motion, MotionPart, Motions, Wall};
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// Most walls that are told one by one.
const MOST_WALLS: usize = 20;
/// What stands for the others.
const MORE: &str = "and more; `--json` tells all";

/// Adds the motions from the start on as rows.
pub fn add_rows(scenario: &Scenario, prepared: &Prepared, rows: &mut Rows) {
    let told = scenario.walls.iter().zip(&prepared.setup.walls);
    let mut moving = told.filter(|(spec, _)| !spec.motion.is_rest());
    for (spec, wall) in moving.by_ref().take(MOST_WALLS) {
        rows.add(format!("motion {}", spec.name), words(scenario, wall, &spec.motion));
    }
    if moving.next().is_some() {
        rows.add("motions", MORE);
    }
}

/// What a stage tells walls to do, a line for each.
pub fn of_stage(scenario: &Scenario, prepared: &Prepared, stage: usize) -> Vec<String> {
    let told = &scenario.stages[stage].motions;
    let line = |(wall, motions): &(usize, Motions)| {
        let name = &scenario.walls[*wall].name;
        format!("`{name}` {}", words(scenario, &prepared.setup.walls[*wall], motions))
    };
    let mut lines: Vec<String> = told.iter().take(MOST_WALLS).map(line).collect();
    if told.len() > MOST_WALLS {
        lines.push(MORE.to_string());
    }
    lines
}

/// All motions, those at the start and those of stages.
pub fn to_json(scenario: &Scenario, prepared: &Prepared) -> Value {
    let entry = |stage: Option<&str>, wall: usize, motions: &Motions| {
        let words = words(scenario, &prepared.setup.walls[wall], motions);
        json!({ "wall": scenario.walls[wall].name, "stage": stage, "motion": words })
    };
    let at_start = scenario
        .walls
        .iter()
        .enumerate()
        .filter(|(_, spec)| !spec.motion.is_rest());
    let mut told: Vec<Value> = at_start.map(|(wall, spec)| entry(None, wall, &spec.motion)).collect();
    for stage in &scenario.stages {
        told.extend(
            stage
                .motions
                .iter()
                .map(|(wall, motions)| entry(Some(&stage.name), *wall, motions)),
        );
    }
    Value::Array(told)
}

fn words(scenario: &Scenario, wall: &Wall, motions: &Motions) -> String {
    let parts: Vec<String> = motions.parts.iter().map(|part| of_part(scenario, wall, part)).collect();
    match parts.as_slice() {
        [] => "rests".to_string(),
        parts => parts.join("; carried by that it "),
    }
}

/// A rigid body: its mass, and along and about what it is free.
fn of_body(wall: &Wall, body: &BodyMotion) -> String {
    let along = |free: [bool; 3]| {
        let named: Vec<&str> = ["x", "y", "z"]
            .into_iter()
            .zip(free)
            .filter_map(|(axis, free)| free.then_some(axis))
            .collect();
        match named.as_slice() {
            [] => "none".to_string(),
            [_, _, _] => "any axis".to_string(),
            named => named.join(" and "),
        }
    };
    let mass = wall
        .body_mass(body)
        .map_or_else(String::new, |mass| format!(" of {} kg", number(mass)));
    format!(
        "is a body{mass} that moves along {} and turns about {}",
        along(body.slides),
        along(body.turns)
    )
}

fn of_part(scenario: &Scenario, wall: &Wall, MotionPart { motion, pace }: &MotionPart) -> String {
    let about = |axis: [f64; 3], point: [f64; 3]| format!("about {} through {} m", vector(axis), vector(point));
    let mut words = match motion {
        Motion::Rest => "rests".to_string(),
        Motion::Velocity(velocity) => format!("moves at {} m/s", vector(velocity.to_array())),
        Motion::Belt(velocity) => format!("stays, its surface moves at {} m/s", vector(velocity.to_array())),
        Motion::Rotation {
            point,
            axis,
            angular_velocity,
        } => {
            let rpm = number(60.0 * angular_velocity / TAU);
            let fastest = wall.farthest_from(*point, *axis).map_or_else(String::new, |far| {
                format!(", no point faster than {} m/s", number(far * angular_velocity.abs()))
            });
            format!(
                "turns at {rpm} rpm {}{fastest}",
                about(axis.to_array(), point.to_array())
            )
        }
        Motion::Oscillation {
            amplitude, frequency, ..
        } => format!(
            "swings by {} m at {} Hz",
            vector(amplitude.to_array()),
            number(*frequency)
        ),
        Motion::Rocking {
            point,
            axis,
            amplitude,
            frequency,
            ..
        } => format!(
            "rocks by {} degrees at {} Hz {}",
            number(amplitude.to_degrees()),
            number(*frequency),
            about(axis.to_array(), point.to_array())
        ),
        Motion::Table(_) => "follows its table".to_string(),
        Motion::Servo { axis, force, max_speed } => format!(
            "pushes the grains along {} with {} N, at {} m/s at most",
            vector(axis.to_array()),
            number(*force),
            number(*max_speed)
        ),
        Motion::TorqueServo {
            point,
            axis,
            torque,
            max_speed,
        } => format!(
            "turns the grains with {} N m, at {} rpm at most, {}",
            number(*torque),
            number(60.0 * max_speed / TAU),
            about(axis.to_array(), point.to_array())
        ),
        Motion::Free(free) => match &free.freedom {
            Freedom::Slide { axis } => format!("moves freely along {}", vector(axis.to_array())),
            Freedom::Hinge { point, axis, .. } => format!("turns freely {}", about(axis.to_array(), point.to_array())),
        },
        Motion::Body(body) => of_body(wall, body),
        Motion::With(leader) => format!("goes with `{}`", scenario.walls[*leader].name),
        Motion::Driven { .. } => "is moved from outside".to_string(),
    };
    if pace.start_over > 0.0 {
        words.push_str(&format!(", at full speed after {} s", number(pace.start_over)));
    }
    if pace.stop_after.is_finite() {
        words.push_str(&format!(
            ", at rest after {} s",
            number(pace.stop_after + pace.stop_over)
        ));
    }
    words
}
