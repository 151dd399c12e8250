//! The studies of bulk solids at reduced size: fewer grains, fewer points, shorter.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test tells what it measured, and may panic"
)]

use demeter_validation::bulk::{BulkError, Experiment, Findings, find, find_study, run_study, write_findings};
use std::fs;
use std::path::Path;

fn experiment(points: &[f64], set: &[&str]) -> Experiment {
    Experiment {
        scenarios: Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/bulk"),
        points: points.to_vec(),
        set: set.iter().map(ToString::to_string).collect(),
        jobs: 2,
        overwrite: false,
    }
}

fn study(name: &str, points: &[f64], set: &[&str]) -> Findings {
    let place = tempfile::tempdir().unwrap();
    let study = find_study(name).unwrap();
    let runs = run_study(&experiment(points, set), study, place.path(), &|_| ()).unwrap();
    let findings = find(study, &runs).unwrap();
    println!("{}", write_findings(&findings, study, place.path()).unwrap());
    for ending in ["csv", "txt", "svg"] {
        let length = fs::metadata(place.path().join(format!("{name}.{ending}")))
            .unwrap()
            .len();
        assert!(length > 50, "{name}.{ending}");
    }
    assert!(findings.residual < 1e-3, "{}", findings.residual);
    findings
}

const SOFT: &str = "material.glass.young_modulus=\"0.3 MPa\"";

#[test]
fn more_flows_out_of_a_larger_orifice_as_beverloo_tells() {
    let set = [
        SOFT,
        "simulation.time_step=\"3e-5 s\"",
        "simulation.max_overlap=0.6",
        "grains[0].count=1500",
        "grains[0].region.end=\"0 0 90 mm\"",
        "measure.bulk.region.start=\"0 0 5 mm\"",
        "measure.bulk.region.end=\"0 0 30 mm\"",
        "stage.fill.duration=\"0.2 s\"",
        "stage.flow.duration=\"0.5 s\"",
        "stage.flow.stop={ grains_at_most = 100 }",
    ];
    let found = study("beverloo", &[4.0, 6.0], &set);
    let [small, large] = found.rows.as_slice() else {
        unreachable!("two points, two rows: {:?}", found.rows);
    };
    // 2.5 of the orifice less the empty ring; the bed is shallow, the run short, and another seed gives another exponent
    assert!((1.8..3.2).contains(&found.number("exponent")), "{:?}", found.numbers);
    assert!(small[1] > 0.02 && large[1] > 2.0 * small[1], "{:?}", found.rows);
}

#[test]
fn the_floor_of_a_column_carries_less_and_less() {
    let set = [
        SOFT,
        "simulation.time_step=\"3e-5 s\"",
        "simulation.max_overlap=0.6",
        "feed.layers.count=1500",
        "feed.layers.number_rate=\"2500 1/s\"",
        "stage.layer.repeat=6",
        "stage.layer.stage[0].duration=\"0.1 s\"",
        "stage.layer.stage[1].duration=\"0.15 s\"",
        "wall.column.radius=\"18 mm\"",
        "wall.floor.radius=\"18 mm\"",
        "feed.layers.from.radius=\"16 mm\"",
        "feed.layers.from.center=\"0 0 150 mm\"",
    ];
    let found = study("janssen", &[0.5], &set);
    assert_eq!(found.rows.len(), 6);
    let carried: Vec<f64> = found.rows.iter().map(|row| row[2] / row[1]).collect();
    // the first layer stands on the floor, of the last little reaches it
    assert!(carried[0] > 0.45, "{carried:?}");
    // so few grains tell it with noise
    assert!(carried[..5].windows(2).all(|two| two[1] < 1.1 * two[0]), "{carried:?}");
    assert!(
        carried[5] < 0.5 * carried[0] && found.number("deviation") < 0.25,
        "{carried:?} {:?}",
        found.numbers
    );
}

#[test]
fn a_heap_is_steeper_with_friction() {
    let set = [
        "material.grain.young_modulus=\"0.3 MPa\"",
        "simulation.time_step=\"3e-5 s\"",
        "simulation.max_overlap=0.6",
        "grains.heap.count=700",
        "grains.heap.region.end=\"0 0 80 mm\"",
        "grains.heap.region.radius=\"24 mm\"",
        "wall.tube.radius=\"25 mm\"",
        "grains.rough.region.radius=\"80 mm\"",
        "stage.lift.duration=\"0.8 s\"",
        "stage.rest.duration=\"0.3 s\"",
        "measure.slope.between=[\"8 mm\", \"45 mm\"]",
    ];
    let found = study("repose", &[0.1, 0.8], &set);
    let [slippery, rough] = found.rows.as_slice() else {
        unreachable!("two points, two rows: {:?}", found.rows);
    };
    assert!(
        slippery[1] > 2.0 && rough[1] > slippery[1] + 3.0 && rough[1] < 45.0,
        "{:?}",
        found.rows
    );
}

#[test]
fn studies_and_points_that_do_not_exist_are_refused() {
    assert!(matches!(find_study("Janssen"), Err(BulkError::UnknownStudy { .. })));
    let place = tempfile::tempdir().unwrap();
    for (name, point) in [
        ("beverloo", 0.0),
        ("beverloo", 12.0),
        ("repose", -0.1),
        ("repose", f64::NAN),
    ] {
        let refused = run_study(
            &experiment(&[point], &[]),
            find_study(name).unwrap(),
            place.path(),
            &|_| (),
        );
        assert!(matches!(refused, Err(BulkError::Point { .. })), "{name} {point}");
    }
}
