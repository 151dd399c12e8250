//! Every example and every template runs to its end, its energy books close within 1e-3 of the energy that passed
//! through, and an interruption changes no bit. Shortened here; whole with `DEMETER_FULL=1`.

#![allow(clippy::print_stdout, reason = "a test tells what it measured")]

use demeter::scenario::{Observer, Progress, RunEnd, RunOptions, Scenario, TEMPLATES, resume, run};
use std::path::{Path, PathBuf};
use std::time::Duration;

const LARGEST_RESIDUAL: f64 = 1e-3;

/// Says nothing, and asks the run to end at a step.
struct Silent {
    last: u64,
}

impl Observer for Silent {
    fn progress(&mut self, progress: &Progress) -> bool {
        progress.step < self.last
    }
    fn interval(&self) -> Duration {
        Duration::ZERO
    }
    fn message(&mut self, _text: &str) {}
}

/// An observer that lets the run end by itself.
fn silent() -> Silent {
    Silent { last: u64::MAX }
}

fn full() -> bool {
    std::env::var_os("DEMETER_FULL").is_some()
}

fn check(name: &str, scenario: &Scenario) {
    let place = tempfile::tempdir().unwrap();
    let whole = place.path().join("whole");
    let report = run(scenario, &whole, RunOptions::default(), &mut silent()).unwrap();
    assert_eq!(report.end, RunEnd::Finished, "{name}");
    let residual = report.summary.energies.max_residual;
    println!(
        "{name}: {} steps, largest residual {residual:.2e}",
        report.summary.steps
    );
    assert!(residual < LARGEST_RESIDUAL, "{name}: largest residual {residual:e}");

    // interrupted half way, and continued on one thread
    let parts = place.path().join("parts");
    let mut impatient = Silent {
        last: report.summary.steps / 2,
    };
    let first = run(scenario, &parts, RunOptions::default(), &mut impatient).unwrap();
    assert_eq!(first.end, RunEnd::Interrupted, "{name}");
    let options = RunOptions {
        threads: Some(1),
        ..RunOptions::default()
    };
    let second = resume(&parts, options, &mut silent()).unwrap();
    assert_eq!(second.end, RunEnd::Finished, "{name}");
    for file in results(&whole) {
        let same = std::fs::read(whole.join(&file)).unwrap() == std::fs::read(parts.join(&file)).unwrap();
        assert!(same, "{name}: {} differs after a restart", file.display());
    }
}

/// Series and frames of a run, relative to its folder.
fn results(folder: &Path) -> Vec<PathBuf> {
    let frames = std::fs::read_dir(folder.join("frames")).unwrap();
    let frames = frames.map(|entry| Path::new("frames").join(entry.unwrap().file_name()));
    frames.chain([PathBuf::from("series.csv")]).collect()
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
fn examples_close_their_books_and_restart() {
    let mut found = 0;
    for folder in std::fs::read_dir(examples())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        // other folders hold files of two bodies, which the tests of `demeter collide` run
        .filter(|folder| folder.join("scenario.toml").exists())
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
fn templates_close_their_books_and_restart() {
    for (name, _, text) in TEMPLATES {
        let overrides: Vec<String> = match *name {
            _ if full() => vec![],
            "collide" => vec![],
            "settle" => vec!["stage[0].duration=\"20 ms\"".into()],
            // its strokes are nested, and end by their way: one of them, three times as fast
            "uniaxial-compression" => vec![
                "stage[0].duration=\"20 ms\"".into(),
                "stage[1].duration=\"10 ms\"".into(),
                "stage[2].repeat=1".into(),
                "stage[2].stage[0].motion.top.velocity=\"0 0 -60 mm/s\"".into(),
                "stage[2].stage[1].motion.top.velocity=\"0 0 60 mm/s\"".into(),
            ],
            _ => {
                let stages = text.matches("\n[[stage]]\n").count();
                let short = |k: usize| format!("stage[{k}].duration=\"{} ms\"", 8 / stages);
                (0..stages).map(short).collect()
            }
        };
        let scenario = Scenario::parse(text, name, Path::new(""), &overrides).unwrap();
        check(name, &scenario);
    }
}
