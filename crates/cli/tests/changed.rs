//! `demeter resume --changed`: a run goes on with what its scenario tells now.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::{FALL, Place, interrupt, interrupted, signal};
use std::fs;

/// Nobody takes a run for one of the scenario in its folder that is none from its beginning on.
#[test]
fn a_run_goes_on_with_a_changed_scenario_only_where_that_is_asked_for() {
    let place = interrupted();
    let text = fs::read_to_string(place.path("cut/scenario.toml")).unwrap();
    let commented = format!("# a remark changes nothing\n{text}");
    let longer = format!("{commented}\n[[stage]]\nname = \"more\"\nsteps = 10\n");
    place.write("cut/scenario.toml", &longer);
    let said = place.expect(2, &["resume", "cut"]);
    for part in [
        "cut/scenario.toml",
        "name = \"more\" | steps = 10",
        "in place of nothing",
        "--changed",
    ] {
        assert!(said.err.contains(part), "{part}: {}", said.err);
    }
    let other = text.replacen(
        "[material.",
        "[material.new]\nyoung_modulus = \"1 GPa\"\npoisson_ratio = 0.3\ndensity = \"1000 kg/m^3\"\n[material.",
        1,
    );
    place.write("cut/scenario.toml", &other);
    let said = place.expect(2, &["resume", "cut", "--changed"]);
    assert!(
        said.err
            .contains("tells the materials `new`, `glass`, and the run began with `glass`"),
        "{}",
        said.err
    );
    place.write("cut/scenario.toml", &commented);
    place.expect(0, &["resume", "cut"]);
    let summary =
        || -> serde_json::Value { serde_json::from_slice(&fs::read(place.path("cut/summary.json")).unwrap()).unwrap() };
    let whole = summary()["steps"].as_u64().unwrap();

    place.write("cut/scenario.toml", &longer);
    place.expect(0, &["resume", "cut", "--changed"]);
    let summary = summary();
    assert_eq!(summary["steps"], whole + 10);
    let warned = format!("from step {whole} on the scenario tells");
    assert!(
        summary["warnings"].to_string().contains(&warned),
        "{}",
        summary["warnings"]
    );
    // from here on this is its scenario
    let said = place.expect(0, &["resume", "cut"]);
    assert!(said.out.contains("nothing is left to do"), "{}", said.out);
}

/// Rows of the series in `cut`: titles, then cells.
fn series(place: &Place) -> Vec<Vec<String>> {
    let text = fs::read_to_string(place.path("cut/series.csv")).unwrap();
    text.lines()
        .map(|line| line.split(',').map(str::to_owned).collect())
        .collect()
}

#[test]
fn a_stage_added_behind_the_last_does_what_it_does_in_a_whole_run() {
    let place = Place::new();
    let told = "motion.box = {";
    let whole = FALL
        .replace(told, "absent = [\"lid\"]\nfeeds = [\"more\"]\nmotion.box = {")
        .replace(
            "[[stage]]\nname = \"fall\"",
            r#"[[wall]]
name = "lid"
material = "glass"
shape = "plane"
point = "0 0 13 mm"
normal = "-z"

[[feed]]
name = "more"
material = "glass"
diameter = "1 mm"
number_rate = "2000 1/s"
velocity = "0 0 -1 m/s"
from = { shape = "rectangle", center = "6 6 12.5 mm", half_u = "4 0 0 mm", half_v = "0 4 0 mm" }

[[stage]]
feeds = []
name = "fall""#,
        );
    let second = whole.rfind("[[stage]]").unwrap()..whole.find("[output]").unwrap();
    let mut first = whole.clone();
    first.replace_range(second, "");
    place.write("whole.toml", &whole);
    place.write("first.toml", &first);
    place.expect(0, &["run", "whole.toml", "--out", "whole"]);
    place.expect(0, &["run", "first.toml", "--out", "cut"]);
    place.write("cut/scenario.toml", &whole);
    place.expect(0, &["resume", "cut", "--changed"]);
    let read = |run: &str| fs::read_to_string(place.path(run).join("series.csv")).unwrap();
    assert!(read("cut") == read("whole"), "{}\n{}", read("cut"), read("whole"));
}

#[test]
fn a_motion_changed_in_the_stage_that_was_interrupted_holds_from_there_on() {
    let place = interrupted();
    let text = fs::read_to_string(place.path("cut/scenario.toml")).unwrap();
    let up = "name = \"fall\"\nmotion.box = { velocity = \"0 0 2 mm/s\" }";
    place.write("cut/scenario.toml", &text.replacen("name = \"fall\"", up, 1));
    let said = place.expect(0, &["resume", "cut", "--changed"]).err;
    let from: f64 = said
        .split("from step ")
        .nth(1)
        .unwrap()
        .split(' ')
        .next()
        .unwrap()
        .parse()
        .unwrap();
    let rows = series(&place);
    let column = |title: &str| rows[0].iter().position(|known| known == title).unwrap();
    let last = rows.iter().rfind(|row| row[column("stage")] == "fall").unwrap();
    let number = |title: &str| last[column(title)].parse::<f64>().unwrap();
    let moving = number("time [s]") * (1.0 - from / number("step"));
    let moved = number("wall box displacement z [m]");
    assert!(
        moved > 0.0 && (moved - 2e-3 * moving).abs() < 1e-9 * moved,
        "{moved} in {moving} s"
    );
}

#[test]
fn other_laws_and_another_gravity_keep_the_books() {
    let place = interrupted();
    let text = fs::read_to_string(place.path("cut/scenario.toml")).unwrap();
    let change = |old: &str, new: &str| {
        assert!(text.contains(old), "{text}");
        place.write("cut/scenario.toml", &text.replacen(old, new, 1));
    };
    let refused = |part: &str| {
        let said = place.expect(2, &["resume", "cut", "--changed"]);
        assert!(said.err.contains(part), "{}", said.err);
    };
    let normal = "normal = { law = \"hertz-tsuji\"";
    let luding = "normal = { law = \"luding\", loading_stiffness = \"1e3 N/m\", unloading_stiffness = \"2e3 N/m\", plastic_depth = 0.05, adhesion_stiffness = \"0 N/m\" } #";
    change(normal, luding);
    refused("is that of `mindlin-history`, `epsd`, and the scenario tells `luding`, `mindlin-history`, `epsd` now");
    change("rolling =", "# rolling =");
    refused("the scenario tells `mindlin-history` now");
    change("young_modulus = \"2 MPa\"", "young_modulus = \"2 GPa\"");
    refused("the time step of the run is unsafe for the laws that are told now");

    change("young_modulus = \"2 MPa\"", "young_modulus = \"3 MPa\"");
    let softer = fs::read_to_string(place.path("cut/scenario.toml")).unwrap();
    place.write("cut/scenario.toml", &softer.replace("0 0 -9.81 m/s^2", "4 0 -5 m/s^2"));
    let said = place.expect(0, &["resume", "cut", "--changed"]);
    assert!(
        said.err
            .contains("with the laws that are told now the time step of the run is"),
        "{}",
        said.err
    );
    let rows = series(&place);
    let column = |title: &str| rows[0].iter().position(|known| known == title).unwrap();
    let numbers = |title: &str| {
        rows[1..]
            .iter()
            .map(|row| row[column(title)].parse::<f64>().unwrap())
            .collect::<Vec<_>>()
    };
    let residual = numbers("energy residual").into_iter().map(f64::abs).fold(0.0, f64::max);
    assert!(residual < 1e-3, "{residual}");
    assert!(numbers("custom work [J]").last().unwrap().abs() > 0.0);
}

#[test]
fn laws_that_reach_farther_find_who_is_there() {
    let place = Place::new();
    let law = |cutoff| {
        format!(
            "normal = {{ law = \"dmt\", work_of_adhesion = \"0.05 N/m\", separation = \"10 um\", cutoff = \"{cutoff}\" }}"
        )
    };
    let text = format!(
        r#"
[simulation]
skin = "5 um"
[domain]
lower = "-9 -9 -9 mm"
upper = "9 9 9 mm"
[material.m]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"
[contact]
{}
[[grains]]
material = "m"
source = "list"
diameter = "2 mm"
positions = ["-1.05 0 0 mm", "1.05 0 0 mm"]
[[stage]]
name = "apart"
steps = 10
[output]
series = "1 s"
"#,
        law("20 um")
    );
    place.write("pair.toml", &text);
    place.expect(0, &["run", "pair.toml", "--out", "cut"]);
    let longer = text.replace("[output]", "[[stage]]\nname = \"drawn\"\nsteps = 10\n[output]");
    place.write("cut/scenario.toml", &longer.replace(&law("20 um"), &law("200 um")));
    place.expect(0, &["resume", "cut", "--changed"]);
    let rows = series(&place);
    let kinetic = rows[0].iter().position(|title| title == "kinetic energy [J]").unwrap();
    let last: f64 = rows.last().unwrap()[kinetic].parse().unwrap();
    assert!(last > 0.0, "they do not feel each other");
}

/// The last line that tells an end of a stage, and the stages of the summary with their steps.
fn stages_of(place: &Place) -> Vec<(String, u64, u64)> {
    let summary: serde_json::Value =
        serde_json::from_slice(&fs::read(place.path("cut/summary.json")).unwrap()).unwrap();
    let stages = summary["stages"].as_array().unwrap();
    let one = |stage: &serde_json::Value| {
        let step = |key: &str| stage[key].as_u64().unwrap();
        (
            stage["name"].as_str().unwrap().to_owned(),
            step("first_step"),
            step("last_step"),
        )
    };
    stages.iter().map(one).collect()
}

#[test]
fn the_stage_is_found_by_its_name_where_others_come_and_go() {
    let place = Place::new();
    let start = FALL.find("[[stage]]").unwrap();
    let end = FALL.find("[output]").unwrap();
    let stage = |name: &str, steps: u32| format!("[[stage]]\nname = \"{name}\"\nsteps = {steps}\n");
    let whole = |stages: &str| [&FALL[..start], stages, &FALL[end..]].concat();
    let stages = [stage("one", 20), stage("two", 4000), stage("three", 30)].concat();
    place.write("fall.toml", &whole(&stages));
    // in the second stage
    for _ in 0..10 {
        let mut child = place.start_until(
            &["run", "fall.toml", "--out", "cut", "--overwrite"],
            "cut/pictures/01-one.png",
        );
        if signal(&mut child, "INT").code() == Some(130) {
            break;
        }
    }
    let at_first = fs::read_to_string(place.path("cut/scenario.toml")).unwrap();
    let told = |stages: &str| {
        let from = at_first.find("[[stage]]").unwrap();
        let rest = at_first[from..]
            .find("\n[output]")
            .map_or("", |at| &at_first[from + at..]);
        place.write("cut/scenario.toml", &[&at_first[..from], stages, rest].concat());
    };
    told(&[stage("one", 20), stage("three", 30)].concat());
    let said = place.expect(2, &["resume", "cut", "--changed"]).err;
    let needed = [
        "the run is in stage `two`",
        "no stage of this name now: it has `one`, `three`",
    ];
    assert!(needed.iter().all(|part| said.contains(part)), "{said}");
    // one is gone in front, which moves the others forwards; another comes in front, which moves them back
    for stages in [
        [stage("two", 4000), stage("three", 30)].concat(),
        [
            stage("zero", 10),
            stage("one", 20),
            stage("two", 4000),
            stage("three", 30),
        ]
        .concat(),
    ] {
        let kept = tempfile::tempdir().unwrap();
        for name in [
            "checkpoint.latest",
            "series.csv",
            "grains.pvd",
            "contacts.pvd",
            "walls.pvd",
        ] {
            fs::copy(place.path("cut").join(name), kept.path().join(name)).unwrap();
        }
        told(&stages);
        place.expect(0, &["resume", "cut", "--changed"]);
        let expected = [("one", 0, 20), ("two", 20, 4020), ("three", 4020, 4050)];
        assert_eq!(stages_of(&place), expected.map(|(name, a, b)| (name.to_owned(), a, b)));
        for entry in fs::read_dir(kept.path()).unwrap() {
            let path = entry.unwrap().path();
            fs::copy(&path, place.path("cut").join(path.file_name().unwrap())).unwrap();
        }
    }
}

#[test]
fn measures_are_added_where_no_file_has_other_columns_for_them() {
    let place = Place::new();
    let recording = FALL.replace("name = \"box\"\n", "name = \"box\"\nstress = true\n");
    place.write("fall.toml", &recording);
    interrupt(
        &place,
        &["run", "fall.toml", "--out", "cut", "--overwrite"],
        "cut",
        "INT",
    );
    let text = fs::read_to_string(place.path("cut/scenario.toml")).unwrap();
    let within = "lower = \"0 0 0 mm\"\nupper = \"12 12 14 mm\"\n";
    let counted = format!(
        "{text}\n[[measure]]\nname = \"low\"\nkind = \"region-count\"\nregion = {{ shape = \"box\", {} }}\n",
        within.trim_end().replace('\n', ", ")
    );
    place.write("cut/scenario.toml", &counted);
    let said = place.expect(2, &["resume", "cut", "--changed"]).err;
    for part in [
        "`cut/series.csv` has other columns",
        "it lacks `low grains`",
        "measures and what walls record as they were",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }

    // a file of its own begins here, and a wall records nothing any more
    let text = text.replace("stress = true\n", "");
    let slices =
        format!("{text}\n[[measure]]\nname = \"slices\"\nkind = \"profile\"\n{within}axis = \"z\"\nslices = 4\n");
    place.write("cut/scenario.toml", &slices);
    place.expect(0, &["resume", "cut", "--changed"]);
    let rows = fs::read_to_string(place.path("cut/profiles/slices.csv")).unwrap();
    let first: u64 = rows.lines().nth(1).unwrap().split(',').next().unwrap().parse().unwrap();
    assert!(first > 0 && rows.lines().count() > 4, "{rows}");
}
