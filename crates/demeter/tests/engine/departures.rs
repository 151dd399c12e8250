//! Grains that leave a domain that removes them: which are told, on any number of threads and processes, and after a restart.

use crate::cases::ranks::on_ranks;
use crate::exchange::{parse, run_in, watcher};
use demeter::scenario::{RunEnd, RunOptions, resume_shared, run_shared};
use std::fs;
use std::path::Path;

/// A layer that rests, and a column that flies out at the top: twelve of its grains in the first stage, two in the second.
fn column() -> String {
    let places: Vec<String> = (0..14).map(|k| format!("\"0 0 {} mm\"", 20 + k)).collect();
    format!(
        r#"
title = "column"
[simulation]
max_overlap = 0.3
[domain]
lower = "-20 -20 -5 mm"
upper = "20 20 45 mm"
outside = "remove"
[material.a]
young_modulus = "50 kPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"
[contact]
normal = {{ law = "hertz-tsuji", restitution = 0.5 }}
[[grains]]
material = "a"
source = "random"
region = {{ shape = "box", lower = "-19 -19 0 mm", upper = "19 19 6 mm" }}
diameter = "1 mm"
count = 1100
[[grains]]
material = "a"
source = "list"
positions = [{}]
diameter = "0.8 mm"
velocity = "0 0 10 m/s"
[[stage]]
duration = "2.35 ms"
[[stage]]
duration = "0.5 ms"
[output]
picture = false
report = false
series = "1 ms"
frames = "never"
"#,
        places.join(", ")
    )
}

fn told(folder: &Path) -> Vec<String> {
    let log = fs::read_to_string(folder.join("log.txt")).unwrap();
    let tells = |line: &&str| line.contains("left the domain at");
    log.lines().filter(tells).map(String::from).collect()
}

#[test]
fn the_first_grains_that_leave_in_a_stage_are_told() {
    let place = tempfile::tempdir().unwrap();
    let [one, two, parts] = ["one", "two", "parts"].map(|name| place.path().join(name));
    let scenario = parse(&column());
    let report = run_in(&scenario, &one, 1, &mut watcher());
    assert_eq!((report.end, report.summary.grains), (RunEnd::Finished, 1100));
    let lines = told(&one);
    // the highest first: its id is the last
    let ids = (1105..=1114).rev().chain([1102, 1101]);
    assert_eq!(lines.len(), ids.clone().count(), "{lines:#?}");
    for (line, id) in lines.iter().zip(ids) {
        assert!(
            line.starts_with("step ") && line.contains(&format!("grain {id} left")),
            "{line}"
        );
        assert!(
            line.contains("moving at (0.000000e0, 0.000000e0, 1.000000e1) m/s"),
            "{line}"
        );
        assert!(line.contains(" s, and was removed"), "{line}");
    }
    for (place, line) in lines.iter().enumerate() {
        assert_eq!(line.contains("a gap in the walls"), [0, 10].contains(&place), "{line}");
        assert_eq!(line.contains("is only counted"), place == 9, "{line}");
    }
    run_in(&scenario, &two, 3, &mut watcher());
    assert_eq!(told(&two), lines);
    let options = || RunOptions {
        threads: Some(1),
        ..RunOptions::default()
    };
    // three were told, and the checkpoint knows
    let stop = || watcher().until(report.summary.steps / 2);
    on_ranks(2, |rank| {
        run_shared(&scenario, &parts, options(), rank, &mut stop()).unwrap().end
    });
    assert_eq!(told(&parts), lines[..3]);
    on_ranks(3, |rank| {
        resume_shared(&parts, options(), rank, &mut watcher()).unwrap().end
    });
    assert_eq!(told(&parts), lines);
}
