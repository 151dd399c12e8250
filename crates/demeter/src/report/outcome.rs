//! How a run went: how it ended, its figures, stages and walls.

use super::figures::{count, number, quantity, wait};
use super::html::Html;
use super::series::last;
use crate::results::Columns;
use serde_json::Value;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    Finished,
    Fault,
    Interrupted,
    /// It runs at this moment.
    GoingOn,
    /// There is no summary of its end: it was killed.
    Killed,
}

impl End {
    /// In a word, and the class of its mark.
    pub fn mark(self) -> (&'static str, &'static str) {
        match self {
            Self::Finished => ("Finished", "good"),
            Self::Fault => ("Stopped on a fault", "bad"),
            Self::Interrupted => ("Interrupted", "warn"),
            Self::GoingOn => ("Still running", "warn"),
            Self::Killed => ("Ended without a summary", "bad"),
        }
    }
}

/// What is known of how a run went.
#[derive(Clone, Debug)]
pub(super) struct Outcome {
    pub end: End,
    /// What ended it, as a sentence.
    pub reason: String,
    pub warnings: Vec<String>,
    pub time_step_reason: String,
    summary: Value,
}

/// Most stages and walls that tables show.
const MOST_ROWS: usize = 200;
/// With more walls than this their forces at the ends of stages are left out.
const MOST_STAGE_WALLS: usize = 6;

impl Outcome {
    /// From the summary, or without one from the log. A summary of an earlier end than that of the series counts as none:
    /// the run was resumed since.
    pub fn new(summary: Option<Value>, log: &str, going_on: bool, last_step: Option<f64>) -> Self {
        let is_latest = |summary: &Value| match (summary["steps"].as_f64(), last_step) {
            (Some(told), Some(last)) => told >= last,
            _ => true,
        };
        let Some(summary) = summary.filter(|summary| !going_on && is_latest(summary)) else {
            return Self::from_log(log, going_on);
        };
        let text = |key: &str| summary[key].as_str().unwrap_or_default().to_string();
        let reason = text("stopped_by");
        let end = match (summary["finished"].as_bool(), reason.starts_with("interrupted")) {
            (Some(true), _) => End::Finished,
            (_, true) => End::Interrupted,
            _ => End::Fault,
        };
        let warnings = summary["warnings"].as_array().into_iter().flatten();
        Self {
            end,
            reason,
            warnings: warnings.filter_map(|w| Some(w.as_str()?.to_string())).collect(),
            time_step_reason: text("time_step_reason"),
            summary,
        }
    }

    fn from_log(log: &str, going_on: bool) -> Self {
        let told = |start: &str| {
            let lines = log.lines().filter_map(move |line| line.strip_prefix(start));
            lines.map(str::to_string).collect::<Vec<String>>()
        };
        let (end, reason) = match (going_on, told("error: ").pop()) {
            (true, _) => (
                End::GoingOn,
                "a process writes into this folder at this moment; what follows is what it has written so far"
                    .to_string(),
            ),
            (false, Some(error)) => (End::Fault, error),
            (false, None) => (
                End::Killed,
                "it was killed, or the machine went down; `demeter resume` goes on from its latest checkpoint"
                    .to_string(),
            ),
        };
        Self {
            end,
            reason,
            warnings: told("warning: "),
            time_step_reason: told("time step ").into_iter().next().unwrap_or_default(),
            summary: Value::Null,
        }
    }

    /// A text of the summary.
    pub fn text(&self, key: &str) -> Option<&str> {
        self.summary[key].as_str().filter(|text| !text.is_empty())
    }

    fn figure(&self, key: &str) -> Option<f64> {
        self.summary[key].as_f64()
    }

    /// The figures of the whole run, as names, values and remarks.
    pub fn figures(&self, series: Option<&Columns>) -> Vec<[String; 3]> {
        let of_series = |name: &str| series.and_then(|series| last(series, name));
        let of = |key: &str, name: &str| self.figure(key).or_else(|| of_series(name));
        let mut figures: Vec<[String; 3]> = Vec::new();
        let mut add = |name: &str, value: Option<String>, remark: String| {
            if let Some(value) = value {
                figures.push([name.to_string(), value, remark]);
            }
        };
        let whole = |value: f64| count(value as u64);
        let contacts = of("contacts", "contacts").map(|c| format!("{} contacts between them", whole(c)));
        add(
            "Grains",
            of("grains", "grains").map(whole),
            contacts.unwrap_or_default(),
        );
        let steps = of("steps", "step").map(|steps| format!("{} steps", whole(steps)));
        add(
            "Simulated time",
            of("simulated_time", "time").map(|t| quantity(t, "s")),
            steps.unwrap_or_default(),
        );
        add(
            "Time step",
            self.figure("time_step").map(|t| quantity(t, "s")),
            String::new(),
        );
        let threads = self.figure("threads").map(|n| {
            let threads = if n == 1.0 {
                "on 1 thread".to_string()
            } else {
                format!("on {} threads", whole(n))
            };
            match self.figure("processes").filter(|count| *count > 1.0) {
                Some(count) => format!("{threads} of each of {} processes", whole(count)),
                None => threads,
            }
        });
        add(
            "Computing time",
            self.figure("wall_clock_time").map(wait),
            threads.unwrap_or_default(),
        );
        add(
            "Speed",
            self.figure("particle_steps_per_second").map(number),
            "particle-steps per second".to_string(),
        );
        let residual = self.summary["energies"]["max_residual"].as_f64();
        add(
            "Ledger residual",
            residual.map(number),
            "largest, of the energy that passed through".to_string(),
        );
        let coordination = of_series("coordination").filter(|z| z.is_finite());
        add(
            "Coordination",
            coordination.map(number),
            "mean contacts per grain at the end".to_string(),
        );
        let fraction = of_series("packing fraction").filter(|f| *f > 0.0);
        add(
            "Packing fraction",
            fraction.map(number),
            "of the box around the grains at the end".to_string(),
        );
        figures
    }

    /// The stages that ran.
    pub fn stages(&self, series: Option<&Columns>, html: &mut Html) {
        let stages: Vec<&Value> = self.summary["stages"].as_array().into_iter().flatten().collect();
        if stages.is_empty() {
            return stages_of_series(series, html);
        }
        let mut names: Vec<&String> = stages
            .iter()
            .flat_map(|s| s["walls"].as_object())
            .flat_map(|walls| walls.keys())
            .collect();
        names.sort();
        names.dedup();
        let powers = power_columns(&stages, &names);
        if names.len() > MOST_STAGE_WALLS {
            names.clear();
        }
        let seconds = |stage: &Value, key: &str| number(stage[key].as_f64().unwrap_or(f64::NAN));
        let row = |stage: &&Value| {
            let steps = stage["last_step"]
                .as_u64()
                .unwrap_or(0)
                .saturating_sub(stage["first_step"].as_u64().unwrap_or(0));
            let mut cells = vec![
                stage["name"].as_str().unwrap_or_default().to_string(),
                seconds(stage, "start"),
                seconds(stage, "end"),
                count(steps),
            ];
            cells.extend(
                names
                    .iter()
                    .map(|name| magnitude(&stage["walls"][name.as_str()]["force"])),
            );
            let together = |of: &[&String]| of.iter().map(|name| mean_power(stage, name)).sum();
            cells.extend(powers.iter().map(|(_, of)| number(together(of))));
            cells.push(stage["ended_by"].as_str().unwrap_or_default().to_string());
            cells
        };
        let mut rows: Vec<Vec<String>> = stages.iter().take(MOST_ROWS).map(row).collect();
        if stages.len() > MOST_ROWS {
            rows.push(vec![format!("{} more in summary.json", stages.len() - MOST_ROWS)]);
        }
        let mut loads: Vec<String> = names.iter().map(|name| format!("force on {name} [N]")).collect();
        loads.extend(powers.iter().map(|(title, _)| title.clone()));
        let mut titles = vec!["stage", "from [s]", "to [s]", "steps"];
        titles.extend(loads.iter().map(String::as_str));
        titles.push("ended because");
        html.table("Stages that ended", &titles, &rows);
    }
}

/// Mean power of a wall in a stage [W]; 0 where none is told.
fn mean_power(stage: &Value, wall: &str) -> f64 {
    stage["walls"][wall]["mean_power"].as_f64().unwrap_or(0.0)
}

/// Titles of the columns of mean powers, and the walls of each: one for every wall that did work, or one for all.
fn power_columns<'a>(stages: &[&Value], walls: &[&'a String]) -> Vec<(String, Vec<&'a String>)> {
    let works = |name: &&&String| stages.iter().any(|stage| mean_power(stage, name) != 0.0);
    let working: Vec<&String> = walls.iter().filter(works).copied().collect();
    if working.len() > MOST_STAGE_WALLS {
        return vec![(format!("mean power of {} walls [W]", working.len()), working)];
    }
    let column = |name| (format!("mean power of {name} [W]"), vec![name]);
    working.into_iter().map(column).collect()
}

/// The length of a vector.
fn magnitude(vector: &Value) -> String {
    let squares: Option<f64> = vector
        .as_array()
        .map(|v| v.iter().map(|x| x.as_f64().unwrap_or(f64::NAN).powi(2)).sum());
    squares.map_or_else(|| "–".to_string(), |sum| number(sum.sqrt()))
}

/// Stages as the series tells them, where there is no summary.
fn stages_of_series(series: Option<&Columns>, html: &mut Html) {
    let Some(series) = series.filter(|series| series.rows() > 0) else {
        html.element("p", "No stage is known.");
        return;
    };
    let time = |row: usize| number(super::series::at(series, "time", row).unwrap_or(f64::NAN));
    let row = |(name, rows): (String, std::ops::Range<usize>)| vec![name, time(rows.start), time(rows.end - 1)];
    let rows: Vec<Vec<String>> = series.spans("stage").into_iter().take(MOST_ROWS).map(row).collect();
    html.table(
        "Stages in the series",
        &["stage", "first row [s]", "last row [s]"],
        &rows,
    );
}

/// Walls in the last row of the series; what moved less than `rounding` [m] did not move.
pub(super) fn walls(series: &Columns, rounding: f64, html: &mut Html) {
    let names: Vec<&str> = (series.all().iter())
        .filter_map(|column| column.name().strip_prefix("wall ")?.strip_suffix(" force x"))
        .collect();
    if names.is_empty() {
        html.element("p", "There are no walls.");
        return;
    }
    let row = |name: &&str| {
        let value = |column: &str| last(series, &format!("wall {name} {column}")).unwrap_or(f64::NAN);
        let vector = |quantity: &str| ["x", "y", "z"].map(|axis| value(&format!("{quantity} {axis}")));
        let force = vector("force");
        let displacement = vector("displacement").map(|moved| if moved.abs() < rounding { 0.0 } else { moved });
        let size = force.iter().map(|f| f * f).sum::<f64>().sqrt();
        let mut cells = vec![(*name).to_string(), number(size)];
        cells.extend(force.iter().map(|v| number(*v)));
        cells.push(number(value("contacts")));
        cells.extend(displacement.iter().map(|v| number(*v)));
        cells
    };
    let mut rows: Vec<Vec<String>> = names.iter().take(MOST_ROWS).map(row).collect();
    if names.len() > MOST_ROWS {
        rows.push(vec![format!("{} more in series.csv", names.len() - MOST_ROWS)]);
    }
    let titles = [
        "wall",
        "force of the grains [N]",
        "x [N]",
        "y [N]",
        "z [N]",
        "contacts",
        "moved in x [m]",
        "in y [m]",
        "in z [m]",
    ];
    html.table("Walls at the end", &titles, &rows);
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn powers_are_told_wall_by_wall_or_together() {
        let turned = |count: usize| {
            let walls = (0..count).map(|k| (format!("w{k}"), json!({ "mean_power": 0.5 * k as f64 })));
            json!({ "walls": walls.collect::<serde_json::Map<_, _>>() })
        };
        let told = |stages: &[&Value], count: usize| {
            let names: Vec<String> = (0..count).map(|k| format!("w{k}")).collect();
            let columns = power_columns(stages, &names.iter().collect::<Vec<_>>());
            let titles_and_counts = columns.into_iter().map(|(title, walls)| (title, walls.len()));
            titles_and_counts.collect::<Vec<_>>()
        };
        assert_eq!(told(&[&json!({}), &turned(1)], 1), []);
        let title = |wall: &str| (format!("mean power of {wall} [W]"), 1);
        assert_eq!(told(&[&json!({}), &turned(3)], 3), [title("w1"), title("w2")]);
        let many = MOST_STAGE_WALLS + 2;
        let together = (format!("mean power of {} walls [W]", many - 1), many - 1);
        assert_eq!(told(&[&turned(many)], many), [together]);
    }

    #[test]
    fn the_end_is_told_by_summary_or_log() {
        let end = |summary: Value| Outcome::new(Some(summary), "", false, None).end;
        assert_eq!(
            end(json!({ "finished": true, "stopped_by": "all stages are done" })),
            End::Finished
        );
        assert_eq!(
            end(json!({ "finished": false, "stopped_by": "interrupted; continue" })),
            End::Interrupted
        );
        assert_eq!(
            end(json!({ "finished": false, "stopped_by": "grain 3 overlaps" })),
            End::Fault
        );
        let killed = Outcome::new(None, "time step automatic: 1 s\nwarning: w\n", false, None);
        assert_eq!((killed.end, killed.warnings.len()), (End::Killed, 1));
        assert_eq!(killed.time_step_reason, "automatic: 1 s");
        assert_eq!(Outcome::new(None, "error: too deep\n", false, None).reason, "too deep");
        // a run that goes on may have the summary of an earlier end beside it
        assert_eq!(
            Outcome::new(Some(json!({ "finished": false })), "", true, None).end,
            End::GoingOn
        );
        let earlier = json!({ "finished": false, "stopped_by": "interrupted", "steps": 100 });
        assert_eq!(
            Outcome::new(Some(earlier.clone()), "", false, Some(101.0)).end,
            End::Killed
        );
        assert_eq!(
            Outcome::new(Some(earlier), "", false, Some(100.0)).end,
            End::Interrupted
        );
    }

    #[test]
    fn damaged_summaries_are_no_panic() {
        for summary in [
            json!(null),
            json!([]),
            json!({ "stages": [1, {}, { "walls": 3 }], "warnings": "x", "grains": "many" }),
        ] {
            let outcome = Outcome::new(Some(summary), "", false, None);
            let mut html = Html::default();
            outcome.stages(None, &mut html);
            assert!(outcome.figures(None).len() < 3);
        }
    }
}
