//! Whole runs that several processes share: the same files as of one, and the same after a restart with other numbers of them.

use crate::cases::ranks::{on_ranks, on_ranks_counting};
use demeter::comm::Ranks;
use demeter::scenario::{Observer, Progress, RunEnd, RunOptions, Scenario, resume_shared, run, run_shared};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::time::Duration;

/// Asks a run to end at a step, when told.
pub(super) struct Silent(pub(super) Option<u64>);

impl Observer for Silent {
    fn progress(&mut self, progress: &Progress) -> bool {
        self.0.is_none_or(|step| progress.step < step)
    }

    fn interval(&self) -> Duration {
        Duration::ZERO
    }

    fn message(&mut self, _: &str) {}
}

pub(super) const OPTIONS: RunOptions = RunOptions {
    threads: Some(1),
    overwrite: false,
    numbered: false,
    instructions: None,
    profile: false,
    changed: false,
};

fn mixer(changes: &[&str]) -> Scenario {
    scenario("mixer.toml", changes)
}

fn scenario(name: &str, changes: &[&str]) -> Scenario {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/engine/shared_runs");
    let file = folder.join(name);
    let changes: Vec<String> = changes.iter().map(|change| (*change).to_string()).collect();
    Scenario::read(&file, &changes).unwrap_or_else(|faults| panic!("{}", faults.render(false)))
}

/// Files that tell how the run was computed, and so are others every time.
const OF_COMPUTING: [&str; 6] = [
    "checkpoint.latest",
    "checkpoint.previous",
    "log.txt",
    "report.html",
    "run.json",
    "summary.json",
];

/// All other files of a run, by name.
fn results(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            if path.is_dir() {
                folders.push(path);
            } else if !OF_COMPUTING.contains(&name.as_str()) {
                files.insert(name, fs::read(path).unwrap());
            }
        }
    }
    files
}

fn assert_same(one: &Path, other: &Path) {
    let (one, other) = (results(one), results(other));
    assert!(one.len() > 10, "little to compare: {:?}", one.keys());
    assert_eq!(one.keys().collect::<Vec<_>>(), other.keys().collect::<Vec<_>>());
    for (name, bytes) in one {
        assert!(bytes == other[&name], "`{name}` differs");
    }
}

pub(super) fn share(scenario: &Scenario, folder: &Path, ranks: Box<dyn Ranks>, last: Option<u64>) -> RunEnd {
    let report = run_shared(scenario, folder, OPTIONS, ranks, &mut Silent(last)).unwrap();
    report.end
}

#[test]
fn feeds_walls_and_measures_do_not_feel_the_processes() {
    let place = tempfile::tempdir().unwrap();
    let one = place.path().join("one");
    let scenario = mixer(&[]);
    let report = run(&scenario, &one, OPTIONS, &mut Silent(None)).unwrap();
    assert_eq!(report.end, RunEnd::Finished);
    let told = &report.summary;
    assert!(
        told.grains > 1024,
        "{} grains are few for several processes",
        told.grains
    );
    for count in [2, 3] {
        let folder = place.path().join(count.to_string());
        for end in on_ranks(count, |rank| share(&scenario, &folder, rank, None)) {
            assert_eq!(end, RunEnd::Finished);
        }
        assert_same(&one, &folder);
    }
}

#[test]
fn contacts_pass_from_wall_to_wall_as_with_one_process() {
    let place = tempfile::tempdir().unwrap();
    let one = place.path().join("one");
    let scenario = scenario("plates.toml", &[]);
    let report = run(&scenario, &one, OPTIONS, &mut Silent(None)).unwrap();
    // contacts that begin anew at seams, as in f5c99c3, leave 1.8e-4
    assert!(
        report.summary.energies.max_residual < 2e-5,
        "{:?}",
        report.summary.energies
    );
    for count in [2, 3] {
        let folder = place.path().join(count.to_string());
        for end in on_ranks(count, |rank| share(&scenario, &folder, rank, None)) {
            assert_eq!(end, RunEnd::Finished);
        }
        assert_same(&one, &folder);
    }
}

#[test]
fn every_measure_is_that_of_one_process() {
    let place = tempfile::tempdir().unwrap();
    let gear = "simulation.integrator=\"gear\"";
    let coupled = "contact.multi_contact={law=\"half-space\"}";
    for (name, changes) in [("steps", &[][..]), ("gear", &[gear][..]), ("coupled", &[coupled][..])] {
        let [one, two, parts] = ["one", "two", "parts"].map(|of| place.path().join(format!("{of} {name}")));
        let scenario = scenario("measured.toml", changes);
        let report = run(&scenario, &one, OPTIONS, &mut Silent(None)).unwrap();
        assert_eq!(report.end, RunEnd::Finished);
        let files = results(&one);
        for file in [
            "layers.csv",
            "rose.csv",
            "stay.csv",
            "tracers.csv",
            "rings.csv",
            "column.csv",
            "drain.csv",
            "map.pvd",
            "chains.pvd",
        ] {
            assert!(files.contains_key(file), "no `{file}`: {:?}", files.keys());
        }
        let ends = on_ranks(2, |rank| share(&scenario, &two, rank, None));
        assert!(ends.iter().all(|end| *end == RunEnd::Finished), "{ends:?}");
        assert_same(&one, &two);
        // what measures remember goes from the first process through the checkpoint to another
        let half = Some(report.summary.steps / 2);
        on_ranks(4, |rank| share(&scenario, &parts, rank, half));
        let ends = on_ranks(3, |rank| {
            resume_shared(&parts, OPTIONS, rank, &mut Silent(None)).unwrap().end
        });
        assert!(ends.iter().all(|end| *end == RunEnd::Finished), "{ends:?}");
        assert_same(&one, &parts);
    }
}

#[test]
fn a_bin_that_is_empty_at_first_fills_and_drains_as_with_one() {
    let place = tempfile::tempdir().unwrap();
    let (one, parts) = (place.path().join("one"), place.path().join("parts"));
    let scenario = scenario("filled.toml", &[]);
    let report = run(&scenario, &one, OPTIONS, &mut Silent(None)).unwrap();
    assert_eq!(report.end, RunEnd::Finished);
    let steps = report.summary.steps;
    assert!(report.summary.grains > 1024, "{} grains", report.summary.grains);
    let half = on_ranks(3, |rank| share(&scenario, &parts, rank, Some(steps / 2)));
    assert!(half.iter().all(|end| *end == RunEnd::Interrupted), "{half:?}");
    let ends = on_ranks_counting(4, |rank| {
        resume_shared(&parts, OPTIONS, rank, &mut Silent(None)).unwrap().end
    });
    assert!(ends.iter().all(|(end, _)| *end == RunEnd::Finished), "{ends:?}");
    assert_same(&one, &parts);
}

#[test]
fn what_is_written_is_told_to_the_first_process_alone() {
    let place = tempfile::tempdir().unwrap();
    let told = |name: &str, changes: &[&str]| {
        let (scenario, folder) = (scenario("bed.toml", changes), place.path().join(name));
        let ended = on_ranks_counting(3, |rank| share(&scenario, &folder, rank, None));
        let traffic = |(end, traffic)| {
            assert_eq!(end, RunEnd::Finished);
            traffic
        };
        ended.into_iter().map(traffic).collect::<Vec<_>>()
    };
    // for a picture the first tells all what is seen
    let often = told("often", &["output.picture=false"]);
    let once = told(
        "once",
        &[
            "output.series=\"1 s\"",
            "output.frames=\"1 s\"",
            "output.checkpoints=\"1 s\"",
            "output.picture=false",
        ],
    );
    let grains = 3600 / 3;
    for (rank, (often, once)) in often.iter().zip(&once).enumerate() {
        // nine rows more: each tells neighbours once how grains near the borders move, as a step does
        let (messages, bytes) = (often.messages - once.messages, often.bytes - once.bytes);
        assert!(messages <= 9 * 2, "rank {rank}: {messages}");
        assert!(
            bytes * once.messages < 2 * messages * once.bytes,
            "rank {rank}: {bytes} in {messages}"
        );
        // and sums to all; a place of each grain would be 24 bytes every time
        let to_all = (often.round_bytes + often.joined_bytes) - (once.round_bytes + once.joined_bytes);
        assert!(to_all < 9 * 2 * grains, "rank {rank} told all {to_all} bytes more");
        let to_first = often.gathered_bytes - once.gathered_bytes;
        assert_eq!(
            to_first > 0,
            rank > 0,
            "rank {rank} told the first {to_first} bytes more"
        );
    }
    let one = place.path().join("one");
    run(
        &scenario("bed.toml", &["output.picture=false"]),
        &one,
        OPTIONS,
        &mut Silent(None),
    )
    .unwrap();
    assert_same(&one, &place.path().join("often"));
}

#[test]
fn frames_without_rows_are_the_same_with_gear() {
    let place = tempfile::tempdir().unwrap();
    let (one, parts) = (place.path().join("one"), place.path().join("parts"));
    let changes = ["simulation.integrator=\"gear\"", "output.series=\"1 s\""];
    let scenario = scenario("bed.toml", &changes);
    run(&scenario, &one, OPTIONS, &mut Silent(None)).unwrap();
    for end in on_ranks(3, |rank| share(&scenario, &parts, rank, None)) {
        assert_eq!(end, RunEnd::Finished);
    }
    assert_same(&one, &parts);
}

/// Cells are laid about nearly all grains, which all processes must find alike.
#[test]
fn grains_far_away_are_those_of_one_process() {
    let place = tempfile::tempdir().unwrap();
    let one = place.path().join("one");
    let scenario = scenario("far.toml", &[]);
    let end = run(&scenario, &one, OPTIONS, &mut Silent(None)).unwrap().end;
    assert_eq!(end, RunEnd::Finished);
    for count in [2, 3] {
        let folder = place.path().join(count.to_string());
        on_ranks(count, |rank| share(&scenario, &folder, rank, None));
        assert_same(&one, &folder);
    }
}

#[test]
fn a_changed_run_goes_on_with_several_processes_as_with_one() {
    let place = tempfile::tempdir().unwrap();
    let scenario = mixer(&[]);
    let changed = RunOptions {
        changed: true,
        ..OPTIONS
    };
    let folders = [1, 2, 3].map(|count| (count, place.path().join(count.to_string())));
    for (count, folder) in &folders {
        let begun = run(&scenario, folder, OPTIONS, &mut Silent(Some(200))).unwrap();
        assert_eq!(begun.end, RunEnd::Interrupted);
        let file = folder.join("scenario.toml");
        let text = fs::read_to_string(&file).unwrap();
        let other = text.replace("friction = 0.4", "friction = 0.2");
        assert_ne!(text, other);
        fs::write(&file, other).unwrap();
        for end in on_ranks(*count, |rank| {
            resume_shared(folder, changed, rank, &mut Silent(None)).unwrap().end
        }) {
            assert_eq!(end, RunEnd::Finished);
        }
        assert_same(&folders[0].1, folder);
    }
}

#[test]
fn a_run_goes_on_with_other_numbers_of_processes() {
    let place = tempfile::tempdir().unwrap();
    let (one, parts) = (place.path().join("one"), place.path().join("parts"));
    let scenario = mixer(&[]);
    let whole = run(&scenario, &one, OPTIONS, &mut Silent(None)).unwrap();
    let at = |quarters| Some(whole.summary.steps * quarters / 4);
    // on other hosts
    let nowhere = place.path().join("nowhere");
    for end in on_ranks(2, |rank| share(&scenario, &parts, rank, at(1))) {
        assert_eq!(end, RunEnd::Interrupted);
    }
    for (count, last) in [(3, at(2)), (1, at(3)), (2, None)] {
        let ends = on_ranks(count, |rank| {
            let folder = if rank.rank() == 0 { &parts } else { &nowhere };
            resume_shared(folder, OPTIONS, rank, &mut Silent(last)).unwrap().end
        });
        assert!(!nowhere.exists());
        let expected = if last.is_none() {
            RunEnd::Finished
        } else {
            RunEnd::Interrupted
        };
        assert!(ends.iter().all(|end| *end == expected), "{ends:?}");
    }
    assert_same(&one, &parts);
}

#[test]
fn all_end_with_the_fault_of_one() {
    let scenario = mixer(&[
        "simulation.max_overlap=0.09",
        "simulation.time_step=\"1 us\"",
        "wall[3].motion.free.speed=\"-4 m/s\"",
    ]);
    let place = tempfile::tempdir().unwrap();
    let (one, two) = (place.path().join("one"), place.path().join("two"));
    let end = run(&scenario, &one, OPTIONS, &mut Silent(None)).unwrap().end;
    assert!(matches!(end, RunEnd::Fault(_)), "{end:?}");
    let ends = on_ranks(2, |rank| {
        let observer = &mut Silent(None);
        run_shared(&scenario, &two, OPTIONS, rank, observer).unwrap().end
    });
    assert!(ends.iter().all(|other| *other == end), "{ends:?}, not {end:?}");
    let series = |folder: &Path| fs::read_to_string(folder.join("series.csv")).unwrap();
    assert!(series(&one) == series(&two), "`series.csv` differs");
}

#[test]
fn what_a_stage_changes_is_that_of_one_process_and_lasts() {
    let place = tempfile::tempdir().unwrap();
    let [one, two, parts] = ["one", "two", "parts"].map(|name| place.path().join(name));
    let scenario = scenario("tilted.toml", &[]);
    let report = run(&scenario, &one, OPTIONS, &mut Silent(None)).unwrap();
    assert_eq!(report.end, RunEnd::Finished);
    let energies = &report.summary.energies;
    assert!(energies.max_residual < 1e-4, "{energies:?}");
    for end in on_ranks(2, |rank| share(&scenario, &two, rank, None)) {
        assert_eq!(end, RunEnd::Finished);
    }
    assert_same(&one, &two);
    // from the middle of the stage, and from the one behind it
    for (count, tenths) in [(3, Some(6)), (2, Some(9)), (1, None)] {
        let last = tenths.map(|tenths| report.summary.steps * tenths / 10);
        on_ranks(count, |rank| match parts.exists() {
            false => share(&scenario, &parts, rank, last),
            true => resume_shared(&parts, OPTIONS, rank, &mut Silent(last)).unwrap().end,
        });
    }
    assert_same(&one, &parts);
}
