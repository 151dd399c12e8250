//! `demeter resume`: an interrupted or killed run ends with the bits of a whole one.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::{FALL, Place, assert_same, interrupt, interrupted, signal};
use std::fs;

const CHECKPOINT: &str = "cut/checkpoint.latest";

#[test]
fn an_interrupted_run_resumes_to_the_same_bits() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    place.expect(0, &["run", "fall.toml", "--out", "whole"]);
    for name in ["INT", "TERM"] {
        let folder = format!("cut-{name}");
        interrupt(
            &place,
            &["run", "fall.toml", "--out", &folder, "--overwrite"],
            &folder,
            name,
        );
        let summary: serde_json::Value =
            serde_json::from_slice(&fs::read(place.path(&folder).join("summary.json")).unwrap()).unwrap();
        let steps = summary["steps"].as_u64().unwrap();
        assert!(summary["finished"] == false && steps < 12_000, "{summary}");
        let said = place.expect(0, &["resume", &folder, "--json"]);
        assert_eq!(said.json()["steps"], 12_000);
        assert!(
            said.err.contains(&format!("going on from step {steps}")),
            "{}",
            said.err
        );
        assert_same(&place.results("whole"), &place.results(&folder));
    }
}

/// The derivatives that the predictor-corrector remembers are in the checkpoint.
#[test]
fn an_interrupted_run_with_gear_resumes_to_the_same_bits() {
    let place = Place::new();
    let gear = "[simulation]\nintegrator = \"gear\"";
    place.write("fall.toml", &FALL.replace("[simulation]", gear));
    place.write("verlet.toml", FALL);
    place.expect(0, &["run", "verlet.toml", "--out", "verlet"]);
    let said = place
        .expect(0, &["run", "fall.toml", "--out", "whole", "--json"])
        .json();
    assert!(said["energies"]["max_residual"].as_f64().unwrap() < 1e-3, "{said}");
    interrupt(
        &place,
        &["run", "fall.toml", "--out", "cut", "--overwrite"],
        "cut",
        "INT",
    );
    place.expect(0, &["resume", "cut"]);
    assert_same(&place.results("whole"), &place.results("cut"));
    let series = |folder: &str| fs::read(place.path(folder).join("series.csv")).unwrap();
    assert!(series("verlet") != series("whole"), "the integrator changes nothing");
}

#[test]
fn a_killed_run_resumes_to_the_same_bits() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    place.expect(0, &["run", "fall.toml", "--out", "whole"]);
    let mut child = place.start_until(&["run", "fall.toml", "--out", "cut"], CHECKPOINT);
    assert_eq!(signal(&mut child, "KILL").code(), None);
    assert!(!place.path("cut/summary.json").exists());
    // resuming twice, killed again in between, on another number of threads
    let mut child = place.command(&["resume", "cut", "--threads", "1"]).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(300));
    signal(&mut child, "KILL");
    place.expect(0, &["resume", "cut"]);
    let summary = fs::read(place.path("cut/summary.json")).unwrap();
    let said = place.expect(0, &["resume", "cut"]);
    assert!(said.out.contains("nothing is left to do"), "{}", said.out);
    assert_eq!(place.expect(0, &["resume", "cut", "--json"]).json()["end"], "finished");
    assert!(summary == fs::read(place.path("cut/summary.json")).unwrap());
    assert_same(&place.results("whole"), &place.results("cut"));
}

/// Files named by the scenario are found wherever `resume` is called, and the title stays.
#[test]
fn a_run_resumes_from_another_folder() {
    let place = Place::new();
    fs::create_dir_all(place.path("case/elsewhere")).unwrap();
    let listed = FALL.find("[[grains]]").unwrap()..FALL.find("[[wall]]").unwrap();
    let mut text = FALL.replace("title = \"Grains fall into a box\"\n", "");
    let shift = FALL.len() - text.len();
    text.replace_range(
        listed.start - shift..listed.end - shift,
        "[[grains]]\nmaterial = \"glass\"\nsource = \"file\"\nfile = \"two.csv\"\n\n",
    );
    place.write("case/fall.toml", &text);
    place.write(
        "case/two.csv",
        "x y z diameter\n0.004 0.004 0.004 0.002\n0.008 0.004 0.006 0.002\n",
    );
    let run = ["run", "case/fall.toml", "--out", "cut", "--set", "stage[0].steps=60000"];
    let mut child = place.start_until(&run, CHECKPOINT);
    assert_eq!(signal(&mut child, "KILL").code(), None);
    let mut command = place.command(&["resume", "../../cut", "--json"]);
    let output = command.current_dir(place.path("case/elsewhere")).output().unwrap();
    assert_eq!(
        output.status.code(),
        Some(0),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&answer["title"], &answer["steps"]), (&"fall".into(), &66_000.into()));
}

/// A run goes on with the walls that it began with; grains of the start are in its checkpoint.
#[test]
fn a_run_does_not_go_on_with_other_files() {
    let place = Place::new();
    let way = |x: &str| format!("time [s],x [m]\n0,0\n1,{x}\n");
    place.write("push.csv", &way("0.001"));
    place.write("one.csv", "x y z diameter\n0.004 0.004 0.004 0.002\n");
    let listed = FALL.find("[[grains]]").unwrap()..FALL.find("[[wall]]").unwrap();
    let mut text = FALL.to_owned();
    text.replace_range(
        listed,
        "[[grains]]\nmaterial = \"glass\"\nsource = \"file\"\nfile = \"one.csv\"\n\n",
    );
    text.push_str(
        "\n[[wall]]\nname = \"plate\"\nmaterial = \"glass\"\nshape = \"plane\"\npoint = \"0 0 -1 mm\"\nnormal = \"z\"\n\
         motion = { table = { file = \"push.csv\" } }\n",
    );
    place.write("fall.toml", &text);
    let run = ["run", "fall.toml", "--out", "cut", "--set", "stage[0].steps=60000"];
    let mut child = place.start_until(&run, CHECKPOINT);
    assert_eq!(signal(&mut child, "KILL").code(), None);
    fs::remove_file(place.path("cut/summary.json")).ok();
    place.write("push.csv", &way("0.002"));
    let said = place.expect(2, &["resume", "cut"]);
    assert!(
        said.err.contains("push.csv` holds something else than before") && said.err.contains("anew in another folder"),
        "{}",
        said.err
    );
    place.write("push.csv", &way("0.001"));
    fs::remove_file(place.path("one.csv")).unwrap();
    place.expect(0, &["resume", "cut"]);
}

#[test]
fn stages_shorter_than_the_interval_of_checkpoints_have_one_at_their_end() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let said = place
        .expect(0, &["run", "fall.toml", "--out", "whole", "--json"])
        .json();
    let stage = 6000.0 * said["time_step"].as_f64().unwrap();
    let before_the_last = |intervals_per_stage: f64| {
        let interval = format!("output.checkpoints=\"{} s\"", stage / intervals_per_stage);
        place.expect(
            0,
            &["run", "fall.toml", "--out", "cut", "--overwrite", "--set", &interval],
        );
        let checkpoint = fs::read(place.path("cut/checkpoint.previous")).unwrap();
        let text = String::from_utf8_lossy(&checkpoint).into_owned();
        let step = text.split("\"step\": ").nth(1).unwrap();
        step.split(',').next().unwrap().parse::<u64>().unwrap()
    };
    assert_eq!(before_the_last(1.0 / 1.5), 6000);
    // where the stage is less than half an interval long, none
    assert_eq!(before_the_last(1.0 / 2.5), 0);
}

#[test]
fn a_series_that_is_gone_is_not_begun_anew_in_silence() {
    let place = interrupted();
    let series = fs::read_to_string(place.path("cut/series.csv")).unwrap();
    let before = place.results("cut");

    fs::remove_file(place.path("cut/series.csv")).unwrap();
    let said = place.expect(2, &["resume", "cut"]);
    assert!(
        said.err.contains("series.csv") && said.err.contains("Put the file back") && said.err.contains("empty file"),
        "{}",
        said.err
    );
    place.write("cut/series.csv", &series);
    assert!(before == place.results("cut"), "something was changed");

    place.write("cut/series.csv", &series.replace('\n', "\r\n"));
    let said = place.expect(2, &["resume", "cut"]);
    assert!(said.err.contains("its lines end with CR LF"), "{}", said.err);
    place.write("cut/series.csv", &series);

    let second = series.match_indices('\n').nth(1).unwrap().0;
    let headless = format!("{}{}", &series[..=series.find('\n').unwrap()], &series[second + 1..]);
    place.write("cut/series.csv", &headless);
    let pvd = fs::read_to_string(place.path("cut/grains.pvd")).unwrap();
    let frame = pvd.lines().find(|line| line.contains("grains_0000000000")).unwrap();
    place.write("cut/grains.pvd", &pvd.replace(&format!("{frame}\n"), ""));
    let said = place.expect(0, &["resume", "cut"]);
    assert!(said.err.contains("warning: `cut/series.csv` "), "{}", said.err);
    assert!(
        said.err.contains("warning: `cut/grains.pvd` does not name 1 file"),
        "{}",
        said.err
    );
    let log = fs::read_to_string(place.path("cut/log.txt")).unwrap();
    assert!(log.contains("`cut/series.csv` "), "{log}");

    // whoever reads the results later is told, too
    let summary: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(place.path("cut/summary.json")).unwrap()).unwrap();
    let lost = summary["lost_rows"]["series.csv"].as_str().unwrap();
    let told = summary["warnings"].to_string();
    assert!(told.contains(&format!("`cut/series.csv` {lost}")), "{told}");
    assert!(told.contains("`cut/grains.pvd` does not name 1 file"), "{told}");
    let said = place.expect(1, &["resume", "cut"]);
    let expected = format!("its results are not whole: `series.csv`: it {lost}");
    assert!(said.err.contains(&expected), "{}", said.err);
    let said = place.expect(0, &["report", "cut"]);
    assert!(said.err.contains(&format!("it {lost}")), "{}", said.err);
}

#[test]
fn a_finished_run_whose_results_are_gone_is_no_whole_one() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    place.expect(0, &["run", "fall.toml", "--out", "whole"]);
    for (file, expected) in [
        ("summary.json", "`summary.json` is gone"),
        ("series.csv", "`series.csv` is gone"),
        ("grains.pvd", "grains.pvd` does not name"),
    ] {
        let kept = fs::read(place.path("whole").join(file)).unwrap();
        fs::remove_file(place.path("whole").join(file)).unwrap();
        let said = place.expect(1, &["resume", "whole"]);
        assert!(
            said.err.contains(expected) && said.err.contains("put it back"),
            "{file}: {}",
            said.err
        );
        fs::write(place.path("whole").join(file), kept).unwrap();
    }
    let said = place.expect(0, &["resume", "whole"]);
    assert!(said.out.contains("nothing is left to do"), "{}", said.out);
}

/// What is written beside the series, every kind of file once.
const MEASURES: &str = r#"
[[measure]]
name = "forces"
kind = "force-distribution"
bin = "0.5 mN"
upper = "30 mN"

[[measure]]
name = "rose"
kind = "contact-angles"
from = "x"
towards = "z"
bins = 12

[[measure]]
name = "slices"
kind = "profile"
lower = "0 0 0 mm"
upper = "12 12 14 mm"
axis = "z"
slices = 4

[[measure]]
name = "ways"
kind = "paths"
ids = [1, 2]

[[measure]]
name = "density"
kind = "field"
lower = "0 0 0 mm"
upper = "12 12 14 mm"
cells = [1, 1, 4]
width = "4 mm"

[[measure]]
name = "links"
kind = "force-chains"
"#;

const BESIDE_THE_SERIES: [&str; 8] = [
    "distributions/forces.csv",
    "distributions/rose.csv",
    "profiles/slices.csv",
    "paths/ways.csv",
    "grains.pvd",
    "fields/density.pvd",
    "fields/density.csv",
    "chains/links.pvd",
];

/// They were begun anew in silence, and held the end of the run alone.
#[test]
fn no_file_that_is_gone_is_begun_anew_in_silence() {
    let place = Place::new();
    place.write("fall.toml", &format!("{FALL}{MEASURES}"));
    let run = ["run", "fall.toml", "--out", "cut", "--overwrite"];
    interrupt(&place, &run, "cut", "INT");
    let path = |name: &str| place.path("cut").join(name);
    let kept = BESIDE_THE_SERIES.map(|name| fs::read(path(name)).unwrap());
    for (name, bytes) in BESIDE_THE_SERIES.iter().zip(&kept) {
        fs::remove_file(path(name)).unwrap();
        let said = place.expect(2, &["resume", "cut"]);
        assert!(
            said.err.contains(&format!("`cut/{name}` is not there")) && said.err.contains("empty file"),
            "{}",
            said.err
        );
        assert!(!path(name).exists());
        fs::write(path(name), bytes).unwrap();
    }
    // nor is one that holds something else
    let slices = fs::read(path("profiles/slices.csv")).unwrap();
    fs::write(path("profiles/slices.csv"), "a,b\n1,2\n").unwrap();
    let said = place.expect(2, &["resume", "cut"]);
    assert!(
        said.err
            .contains("slices.csv` has other columns than the scenario tells: it lacks `step`")
            && said.err.contains("empty file"),
        "{}",
        said.err
    );
    fs::write(path("profiles/slices.csv"), slices).unwrap();
    // all at once
    for name in ["distributions", "fields"] {
        fs::remove_dir_all(path(name)).unwrap();
    }
    let said = place.expect(2, &["resume", "cut"]);
    assert_eq!(said.err.matches("is not there, though").count(), 4, "{}", said.err);

    // what is empty is wanted so, and told
    for name in ["distributions", "fields"] {
        fs::create_dir(path(name)).unwrap();
    }
    for name in BESIDE_THE_SERIES {
        fs::write(path(name), "").unwrap();
    }
    fs::remove_file(path("frames/contacts_0000000000.vtp")).unwrap();
    let said = place.expect(0, &["resume", "cut"]);
    for told in [
        "`cut/distributions/forces.csv` holds no rows",
        "`cut/distributions/rose.csv` holds no rows",
        "`cut/profiles/slices.csv` holds no rows",
        "`cut/grains.pvd` does not name",
        "`cut/chains/links.pvd` does not name",
        "`cut/contacts.pvd` names 1 file that is gone or cut short",
    ] {
        assert!(said.err.contains(told), "{told}: {}", said.err);
    }
}

/// The end of a file went with a full disk or an editor, in the middle of a moment.
#[test]
fn rows_that_are_gone_from_the_end_of_a_moment_are_told() {
    let place = Place::new();
    place.write("fall.toml", &format!("{FALL}{MEASURES}"));
    let run = ["run", "fall.toml", "--out", "cut", "--overwrite"];
    interrupt(&place, &run, "cut", "INT");
    let tables = BESIDE_THE_SERIES.iter().filter(|name| name.ends_with(".csv"));
    for (k, name) in tables.clone().enumerate() {
        let path = place.path("cut").join(name);
        let text = fs::read_to_string(&path).unwrap();
        let last = text.trim_end().rfind('\n').unwrap() + 1;
        // a whole row, or the end of it
        fs::write(path, &text[..if k % 2 == 0 { last } else { text.len() - 15 }]).unwrap();
    }
    let said = place.expect(0, &["resume", "cut"]);
    for name in tables {
        let told = format!("warning: `cut/{name}` lacks ");
        assert!(said.err.contains(&told), "{told}: {}", said.err);
    }
}

#[test]
fn a_run_goes_on_without_its_rows_where_that_is_wanted() {
    let place = interrupted();
    place.write("cut/series.csv", "");
    let said = place.expect(0, &["resume", "cut"]);
    assert!(said.err.contains("holds no rows up to step"), "{}", said.err);
}

#[test]
fn what_cannot_be_resumed_is_told() {
    let place = Place::new();
    let said = place.expect(2, &["resume", "nothing"]);
    assert!(said.err.contains("is not the folder of a Demeter run"), "{}", said.err);
    place.write("fall.toml", FALL);
    place.expect(
        0,
        &[
            "run",
            "fall.toml",
            "--out",
            "cut",
            "--set",
            "stage[0].steps=10",
            "--set",
            "stage[1].steps=10",
        ],
    );
    for name in ["checkpoint.latest", "checkpoint.previous"] {
        let _ = fs::remove_file(place.path("cut").join(name));
    }
    let said = place.expect(2, &["resume", "cut", "--json"]);
    assert!(
        said.json()["error"]["message"]
            .as_str()
            .unwrap()
            .contains("holds no checkpoint")
    );
    place.write("cut/checkpoint.latest", "DEMETERC");
    let said = place.expect(1, &["resume", "cut"]);
    assert!(said.err.contains("cut short"), "{}", said.err);
}

/// `timeout` tells the process, and then its group.
#[test]
fn a_signal_that_comes_twice_at_once_is_one() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let run = ["run", "fall.toml", "--out", "cut", "--set", "stage[0].steps=600000"];
    let mut child = place.start_until(&run, CHECKPOINT);
    let kill = format!("kill -TERM {0}; kill -TERM {0}", child.id());
    let sent = std::process::Command::new("sh").args(["-c", &kill]).status();
    assert!(sent.unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let summary: serde_json::Value =
        serde_json::from_slice(&fs::read(place.path("cut/summary.json")).unwrap()).unwrap();
    assert_eq!(summary["finished"], false);
}
