//! The series of `validation/rheology` on a small packing: its two fastest flows.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test tells what it measured, and may panic"
)]

use demeter_validation::rheology::{Experiment, Flow, glass_beads, read_points, run_series, write_tables};
use std::path::{Path, PathBuf};

#[test]
fn a_small_box_flows_with_the_friction_of_glass_beads() {
    let scenario = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../validation/rheology/scenario.toml");
    let text = std::fs::read_to_string(&scenario).unwrap();
    // the slow flows take long
    let fast = text.split("[[stage]]\nname = \"I 0.03\"").next().unwrap();
    let place = tempfile::tempdir().unwrap();
    let file: PathBuf = place.path().join("fast.toml");
    std::fs::write(&file, fast).unwrap();
    let set = [
        "domain.upper=\"7.5 7.5 7.5 mm\"",
        "grains[0].region.upper=\"7.5 7.5 7.5 mm\"",
        "grains[0].count=240",
        "stage[2].stop={ shear_strain = 6 }",
    ];
    let experiment = Experiment {
        scenario: file,
        set: set.map(String::from).to_vec(),
        threads: Some(1),
        overwrite: false,
    };
    let folder = place.path().join("run");
    let scenario = run_series(&experiment, &folder, &|_| ()).unwrap();
    let flow = Flow {
        diameter: 1e-3,
        density: 2500.0,
    };
    let points = read_points(&scenario, flow, &folder).unwrap();
    let table = write_tables(&points, place.path()).unwrap();
    println!("{table}");
    assert_eq!(points.len(), 2);
    for point in &points {
        let beads = glass_beads(point.inertial_number);
        assert!((point.friction.0 / beads - 1.0).abs() < 0.2, "{table}");
        assert!((0.4..0.62).contains(&point.solid_fraction.0), "{table}");
        assert!((point.pressure / 100.0 - 1.0).abs() < 0.05, "{table}");
        assert!(point.residual < 1e-3, "{table}");
    }
    // slower flows are denser and have less friction
    assert!(points[1].friction.0 < points[0].friction.0 && points[1].solid_fraction.0 > points[0].solid_fraction.0);
    for name in ["rheology.csv", "friction.svg", "solid-fraction.svg"] {
        assert!(place.path().join(name).is_file(), "{name}");
    }
}
