//! Every example and every template runs to its end, and its energy books close within 1e-3 of the energy that passed
//! through. Shortened here; whole with `DEMETER_FULL=1`.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test tells what it measured, and may panic"
)]

use demeter::scenario::{Observer, Progress, RunEnd, RunOptions, Scenario, TEMPLATES, run};
use std::path::{Path, PathBuf};

const LARGEST_RESIDUAL: f64 = 1e-3;

struct Silent;

impl Observer for Silent {
    fn progress(&mut self, _progress: &Progress) -> bool {
        true
    }
    fn message(&mut self, _text: &str) {}
}

fn full() -> bool {
    std::env::var_os("DEMETER_FULL").is_some()
}

fn check(name: &str, scenario: &Scenario) {
    let folder = tempfile::tempdir().unwrap();
    let report = run(scenario, &folder.path().join(name), RunOptions::default(), &mut Silent).unwrap();
    assert_eq!(report.end, RunEnd::Finished, "{name}");
    let residual = report.summary.energies.max_residual;
    println!(
        "{name}: {} steps, largest residual {residual:.2e}",
        report.summary.steps
    );
    assert!(residual < LARGEST_RESIDUAL, "{name}: largest residual {residual:e}");
}

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// Overrides that make an example short.
fn shortened(name: &str) -> Vec<&'static str> {
    if full() {
        return Vec::new();
    }
    match name {
        // five times faster strokes
        "hydrogel-compression" => vec![
            "stage[0].duration=\"50 ms\"",
            "stage[1].duration=\"60 ms\"",
            "stage[1].motion.top.velocity=\"0 0 -500 mm/s\"",
            "stage[2].repeat=1",
            "stage[2].stage[0].duration=\"60 ms\"",
            "stage[2].stage[0].motion.top.velocity=\"0 0 -502 mm/s\"",
            "stage[2].stage[1].duration=\"20 ms\"",
            "stage[2].stage[1].motion.top.velocity=\"0 0 502 mm/s\"",
        ],
        "settle-20000" => vec![
            "grains[0].count=2000",
            "grains[0].region.upper=\"28 28 28 mm\"",
            "stage[0].duration=\"20 ms\"",
        ],
        // an example without an entry here runs whole
        _ => Vec::new(),
    }
}

#[test]
fn examples_close_their_books() {
    let mut found = 0;
    for folder in std::fs::read_dir(examples())
        .unwrap()
        .map(|entry| entry.unwrap().path())
    {
        let name = folder.file_name().unwrap().to_string_lossy().to_string();
        let overrides: Vec<String> = shortened(&name).into_iter().map(String::from).collect();
        let scenario = Scenario::read(&folder.join("scenario.toml"), &overrides).unwrap();
        check(&name, &scenario);
        found += 1;
    }
    assert!(found > 0);
}

#[test]
fn templates_close_their_books() {
    for (name, _, text) in TEMPLATES {
        let overrides: Vec<String> = match *name {
            _ if full() => vec![],
            "collide" => vec![],
            "settle" | "drum" | "silo" => vec!["stage[0].duration=\"30 ms\"".into()],
            _ => vec![
                "stage[0].duration=\"30 ms\"".into(),
                "stage[1].duration=\"20 ms\"".into(),
            ],
        };
        let scenario = Scenario::parse(text, name, Path::new(""), &overrides).unwrap();
        check(name, &scenario);
    }
}
