//! The condition `column` of a stage: a column of the series is above or below a value, at every row of some time.

use super::Scenario;
use super::document::Node;
use super::plots::column_of;
use super::quantity::Kind;
use super::reader::{Context, Item, TableReader};
use super::run::labels;
use super::units;
use super::words::{mass, quantity, rounded};
use crate::measure::Measures;
use crate::output::SeriesLabels;
use crate::results::column_name;
use crate::simulation::{ColumnStop, Simulation, Stage, StopCondition};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use serde::{Deserialize, Serialize};

/// A condition whose values can be read once the columns are known, as their units decide what these are.
#[derive(Clone)]
pub(super) struct Told {
    /// Path of the table of the condition.
    path: String,
    /// Its place among the conditions of its stage.
    place: usize,
    /// `above` and `below`.
    limits: [Option<Node>; 2],
}

const LIMITS: [&str; 2] = ["above", "below"];

/// Reads a condition, but for its values.
pub(super) fn column_stop(told: TableReader<'_>, stop: &mut Vec<StopCondition>) -> Told {
    let meaning = "the column, as \"bag mass\" where a measure is named `bag`";
    let column = told
        .required("name", meaning)
        .map_or_else(String::new, |item| item.text());
    let limits = LIMITS.map(|key| told.optional(key).map(|item| item.node.clone()));
    if limits.iter().all(Option::is_none) {
        told.fault("give `above` or `below`, or both", None);
    }
    let time = Kind::Physical(Dimension::TIME);
    let lasting = told.optional_quantity("for", time, Range::POSITIVE).unwrap_or(0.0);
    let told_of = Told {
        path: told.path.clone(),
        place: stop.len(),
        limits,
    };
    stop.push(StopCondition::Column(ColumnStop {
        column,
        above: None,
        below: None,
        lasting,
    }));
    told.finish("the condition column");
    told_of
}

/// Finds the columns and reads the values of conditions that are told by the table of a stage.
pub(super) fn resolve(context: &Context, scenario: &mut Scenario, told: &[(String, Told)]) {
    let header = labels(scenario).header();
    for (stage, told) in told {
        let repeats = scenario.stage_paths.iter().zip(&mut scenario.stages);
        let mut repeats = repeats.filter(|(path, _)| *path == stage).map(|(_, stage)| stage);
        let Some(stop) = repeats.next().and_then(|stage| column_in(stage, told.place)) else {
            continue;
        };
        let read = read(context, told, stop, &header);
        for stage in repeats {
            if let Some(stop) = column_in(stage, told.place) {
                stop.clone_from(&read);
            }
        }
    }
}

fn column_in(stage: &mut Stage, place: usize) -> Option<&mut ColumnStop> {
    match stage.stop.get_mut(place) {
        Some(StopCondition::Column(stop)) => Some(stop),
        _ => None,
    }
}

/// The condition with its column and its values.
fn read(context: &Context, told: &Told, stop: &mut ColumnStop, header: &[String]) -> ColumnStop {
    let place = match column_of(header, &stop.column) {
        Ok(place) => place,
        Err((message, help)) => {
            context.fault(&format!("{}.name", told.path), message, help);
            return stop.clone();
        }
    };
    let title = &header[place];
    if title == "stage" {
        let message = "the column `stage` holds names; a condition needs a column of numbers";
        context.fault(&format!("{}.name", told.path), message, None);
        return stop.clone();
    }
    let (kind, scale) = kind_of(unit_of(title));
    let limits = [0, 1].map(|k| {
        let item = Item {
            context,
            node: told.limits[k].as_ref()?,
            path: format!("{}.{}", told.path, LIMITS[k]),
            name: LIMITS[k].to_string(),
        };
        Some(item.quantity(kind, Range::FINITE) / scale)
    });
    if let [Some(above), Some(below)] = limits
        && above > below
    {
        let message = "`above` is larger than `below`: no value is above the one and below the other";
        context.fault(
            &told.path,
            message,
            Some(
                "tell two conditions, `stop = [{ column = ... }, { column = ... }]`, for what is beyond either"
                    .to_string(),
            ),
        );
    }
    stop.column.clone_from(title);
    [stop.above, stop.below] = limits;
    stop.clone()
}

/// The unit in the title of a column; empty for numbers.
fn unit_of(title: &str) -> &str {
    let unit = title[column_name(title).len()..].trim();
    unit.trim_start_matches('[').trim_end_matches(']')
}

/// What a value in a column of a unit is, and what the unit is in SI.
fn kind_of(unit: &str) -> (Kind, f64) {
    let kind = match unit {
        "" => return (Kind::Number, 1.0),
        "rad" | "deg" => Kind::Angle,
        "rad/s" => Kind::AngularVelocity,
        "kg/s" => Kind::MassRate,
        "N m" => Kind::Torque,
        _ => units::parse(&format!("1 {unit}")).map_or(Kind::Number, |one| Kind::Physical(one.dimension)),
    };
    (kind, units::parse(&format!("1 {unit}")).map_or(1.0, |one| one.value))
}

/// That a condition holds, and since when.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(super) struct Held {
    /// Step of the first row at which it held, with all since.
    since: u64,
    /// Step of the latest row.
    latest: u64,
    /// Value there.
    value: f64,
}

/// Looks at the conditions of a stage at a row. Where processes share the run each calls this.
pub(super) fn look(stage: &Stage, of_row: (&Measures, &SeriesLabels), sim: &Simulation, held: &mut Vec<Option<Held>>) {
    let (row, labels) = of_row;
    held.resize(stage.stop.len(), None);
    for (stop, held) in stage.stop.iter().zip(held) {
        let StopCondition::Column(stop) = stop else { continue };
        let value = labels.value(row, &stop.column).filter(|value| stop.holds(*value));
        // the first process alone knows the row
        let told = value.filter(|_| sim.is_first_process()).unwrap_or(f64::NEG_INFINITY);
        let [value] = sim.largest_of_all([told]);
        *held = (value > f64::NEG_INFINITY).then(|| Held {
            since: held.map_or(sim.step, |held| held.since),
            latest: sim.step,
            value,
        });
    }
}

/// What a condition has come to, in words, when it holds for as long as it must.
pub(super) fn reached(stop: &ColumnStop, held: Option<Held>, dt: f64) -> Option<String> {
    let held = held?;
    let seconds = (held.latest - held.since) as f64 * dt;
    if seconds < stop.lasting * (1.0 - 1e-12) {
        return None;
    }
    let unit = unit_of(&stop.column);
    let in_words = |value: f64| match unit {
        "" => rounded(value).to_string(),
        "kg" => mass(value),
        "m" | "s" | "N" | "J" | "W" | "Pa" => quantity(value, unit),
        _ => format!("{} {unit}", rounded(value)),
    };
    let limit = |(word, limit): (&str, Option<f64>)| limit.map(|limit| format!("{word} {}", in_words(limit)));
    let limits: Vec<String> = LIMITS
        .into_iter()
        .zip([stop.above, stop.below])
        .filter_map(limit)
        .collect();
    let lasted = if stop.lasting > 0.0 {
        format!(" for {} s", rounded(seconds))
    } else {
        String::new()
    };
    Some(format!(
        "`{}` is {}, {}{lasted}",
        column_name(&stop.column),
        in_words(held.value),
        limits.join(" and ")
    ))
}
