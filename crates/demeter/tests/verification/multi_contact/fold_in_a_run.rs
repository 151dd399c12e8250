//! A run that is compressed past the fold ends with a fault and a snapshot.

use crate::cases::report;
use demeter::contacts::Fault;
use demeter::scenario::{Observer, Progress, RunEnd, RunOptions, Scenario, run};
use std::path::Path;

struct Silent;

impl Observer for Silent {
    fn progress(&mut self, _progress: &Progress) -> bool {
        true
    }

    fn message(&mut self, _text: &str) {}
}

/// Eight grains in a box of six plates that close slowly.
fn closing_box(coupling: &str) -> String {
    let mut text = format!(
        r#"
title = "Past the fold"

[simulation]
max_overlap = 0.5
coupling = "{coupling}"

[domain]
lower = "-20 -20 -20 mm"
upper = "20 20 20 mm"

[material.gel]
young_modulus = "1 MPa"
poisson_ratio = 0.5
density = "1000 kg/m^3"

[material.steel]
young_modulus = "200 GPa"
poisson_ratio = 0.3
density = "7800 kg/m^3"

[contact]
normal = {{ law = "hertz-tsuji", restitution = 0.3 }}
multi_contact = {{ law = "half-space" }}

[[grains]]
material = "gel"
source = "list"
positions = ["-5 -5 -5 mm", "5 -5 -5 mm", "-5 5 -5 mm", "5 5 -5 mm", "-5 -5 5 mm", "5 -5 5 mm", "-5 5 5 mm", "5 5 5 mm"]
diameter = "10 mm"

[[stage]]
name = "squeeze"
duration = "60 ms"
"#
    );
    let sides = [("left", "1 0 0"), ("front", "0 1 0"), ("bottom", "0 0 1")];
    let others = [("right", "-1 0 0"), ("back", "0 -1 0"), ("top", "0 0 -1")];
    for (name, normal) in sides.into_iter().chain(others) {
        let of = |factor: f64| {
            let all = normal
                .split(' ')
                .map(|n| (factor * n.parse::<f64>().unwrap()).to_string());
            all.collect::<Vec<_>>().join(" ")
        };
        text += &format!(
            "\n[[wall]]\nname = \"{name}\"\nmaterial = \"steel\"\nshape = \"plane\"\npoint = \"{} mm\"\nnormal = [{}]\n\
             motion = {{ velocity = \"{} m/s\" }}\n",
            of(-10.0),
            of(1.0).replace(' ', ", "),
            of(0.04),
        );
    }
    text
}

#[test]
fn a_run_past_the_fold_stops_with_a_snapshot() {
    for coupling in ["converged", "lagged"] {
        let folder = tempfile::tempdir().unwrap();
        let scenario = match Scenario::parse(&closing_box(coupling), "past the fold", Path::new(""), &[]) {
            Ok(scenario) => scenario,
            Err(faults) => panic!("{}", faults.render(false)),
        };
        let options = RunOptions {
            threads: Some(1),
            overwrite: true,
            ..RunOptions::default()
        };
        let report_of = run(&scenario, folder.path(), options, &mut Silent).unwrap();
        let RunEnd::Fault(fault) = &report_of.end else {
            panic!("{coupling}: {:?}", report_of.end)
        };
        let Fault::BeyondFold { step, strain, .. } = fault else {
            panic!("{coupling}: {fault}")
        };
        report(&format!("{coupling}: strain at the end"), *strain);
        // what a stiff wall does to a grain its mirror image would: this is a simple cubic lattice. The lagged forces
        // need some steps to grow out of bounds
        let beyond = strain / 0.111_42 - 1.0;
        let allowed = if coupling == "lagged" { 0.03 } else { 1e-3 };
        assert!((-1e-3..allowed).contains(&beyond), "{coupling}: {beyond:e}, {fault}");
        assert!(!report_of.summary.finished);
        assert_eq!(report_of.summary.stopped_by, fault.to_string());
        let snapshot = format!("frames/grains_{step:010}.vtp");
        assert!(folder.path().join(&snapshot).is_file(), "{coupling}: {snapshot}");
    }
}
