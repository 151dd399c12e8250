//! `demeter sweep`: what is gathered of damaged runs, and single runs.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::{FALL, Place, Said};
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

/// Two stages of 300 steps.
const SHORT: [&str; 4] = ["--set", "stage[0].steps=300", "--set", "stage[1].steps=300"];

fn place() -> Place {
    let place = Place::new();
    place.write("fall.toml", FALL);
    place
}

/// A sweep of two runs, and the folder of the second.
fn two_runs(place: &Place) -> PathBuf {
    let sweep = [&["sweep", "fall.toml", "--vary", "grains[0].count=20,30"][..], &SHORT].concat();
    place.expect(0, &sweep);
    let runs = fs::read_dir(place.path("runs/fall-sweep")).unwrap();
    runs.map(|entry| entry.unwrap().path())
        .find(|path| path.to_string_lossy().contains("30") && path.is_dir())
        .unwrap()
}

/// The table gathered with this exit code, row by row, and what was said.
fn gathered(place: &Place, code: i32) -> (Vec<BTreeMap<String, String>>, Said) {
    let said = place.expect(code, &["sweep", "--gather", "runs/fall-sweep"]);
    let mut reader = csv::Reader::from_path(place.path("runs/fall-sweep/results.csv")).unwrap();
    (reader.deserialize().map(Result::unwrap).collect(), said)
}

#[test]
fn a_run_whose_series_is_cut_short_has_no_results() {
    let place = place();
    let series = two_runs(&place).join("series.csv");
    let rows = fs::read_to_string(&series).unwrap();
    let cut: Vec<&str> = rows.lines().take(2).collect();
    fs::write(&series, cut.join("\n") + "\n").unwrap();
    let (rows, said) = gathered(&place, 3);
    assert!(said.err.contains("though the run is finished"), "{}", said.err);
    assert_eq!([&rows[0]["grains"], &rows[0]["end"]], ["20", "finished"]);
    assert_eq!([&rows[1]["grains"], &rows[1]["end"]], ["", "damaged"]);
    assert!(rows[1]["message"].contains("rows are missing"), "{:?}", rows[1]);
    // nothing goes on by itself, and nothing says that all is well
    let again = ["sweep", "--resume", "runs/fall-sweep"];
    for more in [&[][..], &["--retry-failed"]] {
        let said = place.expect(3, &[&again[..], more].concat());
        assert!(said.out.contains("1 damaged: remove the folders"), "{}", said.out);
    }
    let same = ["sweep", "fall.toml", "--vary", "grains[0].count=20,30"];
    place.expect(3, &[&same[..], &SHORT].concat());
    let said = place.expect(3, &[&again[..], &["--json"]].concat());
    assert!(said.err.contains("1 damaged: remove the folders"), "{}", said.err);
    let told = said.json();
    assert_eq!((&told["finished"], &told["damaged"]), (&1.into(), &1.into()));
    assert_eq!(
        (&told["runs"][0]["end"], &told["runs"][1]["end"]),
        (&"finished".into(), &"damaged".into())
    );
    assert!(told["runs"][0]["message"].is_null() && told["exit_code"] == 3, "{told}");
    assert!(
        told["runs"][1]["message"]
            .as_str()
            .unwrap()
            .contains("rows are missing"),
        "{told}"
    );
}

#[test]
fn a_finished_run_that_was_begun_anew_and_ended_otherwise_has_no_results() {
    let place = place();
    let run = two_runs(&place);
    let run = run.to_str().unwrap();
    let fault = ["--out", run, "--overwrite", "--set", "simulation.max_overlap=1e-7"];
    place.expect(3, &[&["run", "fall.toml"][..], &fault].concat());
    let (rows, said) = gathered(&place, 3);
    assert!(said.err.contains("something ran it again"), "{}", said.err);
    assert_eq!([&rows[1]["grains"], &rows[1]["end"]], ["", "damaged"]);
    assert!(rows[1]["message"].contains("overlaps"), "{:?}", rows[1]);
}

#[test]
fn a_finished_run_that_holds_what_another_left_has_no_results() {
    let place = place();
    let run = two_runs(&place);
    let other = [
        "--set",
        "grains[0].count=25",
        "--out",
        run.to_str().unwrap(),
        "--overwrite",
    ];
    place.expect(0, &[&["run", "fall.toml"][..], &SHORT, &other].concat());
    let damaged = |said: &str| {
        let (rows, told) = gathered(&place, 3);
        assert_eq!([&rows[1]["grains"], &rows[1]["end"]], ["", "damaged"], "{said}");
        assert!(rows[1]["message"].contains("something wrote it anew"), "{:?}", rows[1]);
        assert!(
            told.out.contains("1 of 2 runs finished") && told.out.contains("1 damaged"),
            "{}",
            told.out
        );
    };
    damaged("run with other settings");
    // the other run of the sweep, with what it noted
    fs::remove_dir_all(&run).unwrap();
    let sweep = run.parent().unwrap();
    let folders = fs::read_dir(sweep).unwrap().map(|entry| entry.unwrap().path());
    let first = folders.filter(|path| path.is_dir() && *path != run).min().unwrap();
    fs::create_dir(&run).unwrap();
    for file in fs::read_dir(&first)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_file())
    {
        fs::copy(&file, run.join(file.file_name().unwrap())).unwrap();
    }
    damaged("copied");
    // as its message tells
    fs::remove_dir_all(&run).unwrap();
    place.expect(0, &["sweep", "--resume", "runs/fall-sweep"]);
    assert_eq!(gathered(&place, 0).0[1]["end"], "finished");
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
