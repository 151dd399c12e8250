//! How fast grains may meet, told before the run.

use super::silent::{Silent, parsed};
use demeter::contacts::Fault;
use demeter::scenario::{Prepared, RunEnd, RunOptions, Scenario, prepare, run};
use std::path::Path;

/// A grain and a smaller one that meet head-on, told the law and the speed. Of the pairs of such grains it is the one that bears least.
fn meeting(law: &str, speed: f64) -> Scenario {
    let text = format!(
        r#"
title = "meeting"
[simulation]
gravity = "0 0 -10 m/s^2"
max_overlap = 0.1
[material.soft]
young_modulus = "2 MPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"
[contact]
normal = {law}
[[grains]]
material = "soft"
source = "list"
positions = ["0 0 0 mm"]
diameter = "3 mm"
[[grains]]
material = "soft"
source = "list"
positions = ["2.6 0 0 mm"]
diameter = "2 mm"
velocity = "{} 0 0 m/s"
[[stage]]
name = "meet"
duration = "5 ms"
"#,
        -speed
    );
    parsed(&text, Path::new(""))
}

fn prepared(scenario: &Scenario) -> Prepared {
    prepare(scenario).unwrap_or_else(|faults| panic!("{}", faults.render(false)))
}

#[test]
fn an_impact_that_is_faster_than_what_is_borne_is_told_and_ends_the_run() {
    for law in [
        r#"{ law = "hertz-tsuji", restitution = 0.4 }"#,
        r#"{ law = "linear", stiffness = "2 kN/m", restitution = 0.9 }"#,
    ] {
        let borne = prepared(&meeting(law, 0.1)).fastest_impact.unwrap();
        assert_eq!(borne.bodies, "two grains of `soft`", "{law}");
        assert!((borne.height(10.0) / (borne.speed * borne.speed / 20.0) - 1.0).abs() < 1e-12);
        for (share, ends_well) in [(0.99, true), (1.01, false)] {
            let scenario = meeting(law, share * borne.speed);
            let warnings = prepared(&scenario).warnings;
            let told = warnings
                .iter()
                .any(|text| text.contains("grain 2 begins with") && text.contains("0.1 of the smaller"));
            assert_eq!(told, !ends_well, "{law} {warnings:?}");
            let place = tempfile::tempdir().unwrap();
            let report = run(&scenario, &place.path().join("run"), RunOptions::default(), &mut Silent).unwrap();
            match report.end {
                RunEnd::Finished => assert!(ends_well, "{law} {share}"),
                RunEnd::Fault(Fault::Overlap { .. }) => assert!(!ends_well, "{law} {share}"),
                end => panic!("{law} {share}: {end:?}"),
            }
        }
    }
}
