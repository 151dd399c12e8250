//! Stages that end with a column of the series.

use super::exchange::{HEAD, parse, run_in, series, watcher};
use super::shared_runs::{OPTIONS, Silent, share};
use crate::cases::ranks::on_ranks;
use demeter::scenario::{RunEnd, RunOptions, Scenario, resume, resume_shared};
use std::fs;
use std::path::Path;

/// Grains that fall out of a region one after the other: at 20.2, 49.5, 67.0 and 80.8 ms.
fn falling(stop: &str) -> Scenario {
    let grains = r#"
[[grains]]
material = "seed"
source = "list"
positions = ["0 0 12 mm", "0 0 22 mm", "0 0 32 mm", "0 0 42 mm"]
diameter = "2 mm"
[[measure]]
name = "bag"
kind = "region-count"
region = { shape = "box", upper = "20 20 10 mm" }
"#;
    parse(&format!(
        "{HEAD}{grains}[[stage]]\nname = \"pour\"\nduration = \"0.1 s\"\nstop = {stop}\n[[stage]]\nduration = \"6 ms\"\n"
    ))
}

/// How the first stage ended, and when [s].
fn first_end(stop: &str) -> (String, f64) {
    let place = tempfile::tempdir().unwrap();
    let report = run_in(&falling(stop), place.path(), 1, &mut watcher());
    assert_eq!(report.end, RunEnd::Finished);
    let stage = &report.summary.stages[0];
    (stage.ended_by.clone(), stage.end)
}

fn assert_ends(stop: &str, reason: &str, end: f64) {
    let (told, at) = first_end(stop);
    assert!(told.starts_with(reason) && (at - end).abs() < 1e-4, "{told} at {at}");
}

#[test]
fn a_stage_ends_at_the_row_that_tells_enough() {
    assert_ends(
        r#"{ column = { name = "bag mass", above = "12.5 mg" } }"#,
        "`bag mass` is 12.5664 mg, above 12.5 mg",
        0.068,
    );
    // what is there at the start is judged at the first row of the stage
    let none = "`bag grains` is 0, below 0";
    assert_ends(r#"{ column = { name = "bag grains", below = 0 } }"#, none, 0.002);
    assert_ends(
        r#"[{ kinetic_over_elastic = 1e-9 }, { column = { name = "max speed [m/s]", above = "0.5 m/s" } }]"#,
        "`max speed` is 0.5101",
        0.052,
    );
}

#[test]
fn a_condition_that_lasts_holds_at_all_rows_of_that_time() {
    let between =
        |lasting: &str| format!(r#"{{ column = {{ name = "bag grains", above = 1, below = 1, for = "{lasting}" }} }}"#);
    // from 22 to 48 ms there is one
    let one = "`bag grains` is 1, above 1 and below 1 for 0.02";
    assert_ends(&between("20 ms"), one, 0.042);
    assert_ends(&between("27 ms"), "its duration of 0.1 s is over", 0.1);
}

#[test]
fn threads_processes_and_restarts_end_it_at_the_same_step() {
    let place = tempfile::tempdir().unwrap();
    let folder = |name: &str| place.path().join(name);
    let scenario = falling(r#"{ column = { name = "bag grains", above = 1, for = "20 ms" } }"#);
    let whole = run_in(&scenario, &folder("one"), 1, &mut watcher());
    let ends = whole.summary.stages[0].last_step;
    assert!(ends < whole.summary.steps);
    run_in(&scenario, &folder("three"), 3, &mut watcher());
    // in the middle of the time that it must last
    let between = 3 * ends / 4;
    let mut impatient = watcher().until(between);
    assert_eq!(
        run_in(&scenario, &folder("broken"), 1, &mut impatient).end,
        RunEnd::Interrupted
    );
    resume(&folder("broken"), RunOptions::default(), &mut watcher()).unwrap();
    on_ranks(2, |rank| share(&scenario, &folder("shared"), rank, Some(between)));
    let shared = on_ranks(3, |rank| {
        resume_shared(&folder("shared"), OPTIONS, rank, &mut Silent(None))
            .unwrap()
            .end
    });
    assert!(shared.iter().all(|end| *end == RunEnd::Finished), "{shared:?}");
    let rows = |folder: &Path| fs::read_to_string(folder.join("series.csv")).unwrap();
    for other in ["three", "broken", "shared"] {
        assert!(rows(&folder("one")) == rows(&folder(other)), "{other}");
    }
    assert!(series(&folder("one"))["time [s]"].len() > 20);
}
