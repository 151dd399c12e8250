//! `demeter sweep`: what is gathered of damaged runs, and single runs.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::{FALL, Place};
use std::collections::BTreeMap;
use std::fs;

/// Two stages of 300 steps.
const SHORT: [&str; 4] = ["--set", "stage[0].steps=300", "--set", "stage[1].steps=300"];

fn place() -> Place {
    let place = Place::new();
    place.write("fall.toml", FALL);
    place
}

#[test]
fn a_run_whose_series_is_cut_short_has_no_results() {
    let place = place();
    let sweep = [&["sweep", "fall.toml", "--vary", "grains[0].count=20,30"][..], &SHORT].concat();
    place.expect(0, &sweep);
    let run = fs::read_dir(place.path("runs/fall-sweep"))
        .unwrap()
        .map(|entry| entry.unwrap().path().join("series.csv"))
        .find(|path| path.to_string_lossy().contains("30") && path.exists())
        .unwrap();
    let series = fs::read_to_string(&run).unwrap();
    let cut: Vec<&str> = series.lines().take(2).collect();
    fs::write(&run, cut.join("\n") + "\n").unwrap();
    let said = place.expect(0, &["sweep", "--gather", "runs/fall-sweep"]);
    assert!(said.err.contains("though the run is finished"), "{}", said.err);
    let mut reader = csv::Reader::from_path(place.path("runs/fall-sweep/results.csv")).unwrap();
    let rows: Vec<BTreeMap<String, String>> = reader.deserialize().map(Result::unwrap).collect();
    assert_eq!(rows[0]["grains"], "20");
    assert_eq!(rows[1]["grains"], "");
    assert!(rows[1]["message"].contains("rows are missing"), "{:?}", rows[1]);
}

#[test]
fn one_run_alone_needs_the_folder_of_a_sweep() {
    let place = place();
    let said = place.expect(
        2,
        &[&["sweep", "fall.toml", "--vary", "seed=1,2", "--only", "0"][..], &SHORT].concat(),
    );
    assert!(
        said.err.contains("--only 0") && said.err.contains("--resume"),
        "{}",
        said.err
    );
    assert!(!place.path("runs").exists());
}
