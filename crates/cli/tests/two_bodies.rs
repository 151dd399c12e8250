//! `demeter collide`, `contact-curve` and `sticking`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::Place;
use std::fs;
use std::path::Path;

fn place() -> Place {
    let place = Place::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/collide");
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        fs::copy(&path, place.path(path.file_name().unwrap().to_str().unwrap())).unwrap();
    }
    place
}

#[test]
fn every_example_collides_and_has_a_curve() {
    let place = place();
    let files: Vec<String> = place.names().into_iter().filter(|n| n.ends_with(".toml")).collect();
    assert!(files.len() >= 2, "{files:?}");
    for file in &files {
        let text = place.expect(0, &["collide", file]).out;
        assert!(text.contains("outcome") && text.contains("largest overlap"), "{text}");
        let text = place.expect(0, &["contact-curve", file]).out;
        assert!(text.contains("load") && text.contains("pull-off"), "{text}");
    }
}

#[test]
fn collide_answers_in_json_csv_and_svg() {
    let place = place();
    let call = [
        "collide",
        "mcc.toml",
        "--json",
        "--csv",
        "course.csv",
        "--plot",
        "course.svg",
    ];
    let answer = place.expect(0, &call).json();
    let number = |key: &str| answer[key].as_f64().unwrap_or_else(|| panic!("{key}: {answer}"));
    assert!((number("restitution") - 0.54).abs() < 1e-9);
    assert!((number("contact_time") - 69.51247874e-6).abs() < 1e-13);
    assert!((number("max_overlap") - 17.60955505e-6).abs() < 1e-13);
    assert!(number("max_force") > 17.0 && number("estimated_error") < 1e-8);
    assert_eq!(answer["outcome"], "rebound");
    let energy = |key: &str| answer["energy"][key].as_f64().unwrap();
    let kept = energy("kinetic") + energy("viscous_dissipated");
    assert!((kept - energy("kinetic_before")).abs() < 1e-9 * kept);
    let csv = fs::read_to_string(place.path("course.csv")).unwrap();
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("time [s],overlap [m],rate [m/s],force [N]"));
    let rows: Vec<Vec<f64>> = lines
        .map(|l| l.split(',').map(|x| x.parse().unwrap()).collect())
        .collect();
    assert_eq!((rows.len(), rows[0][0], rows[0][2]), (501, 0.0, 1.0));
    assert!(
        fs::read_to_string(place.path("course.svg"))
            .unwrap()
            .contains("normal force [N]")
    );
    let engine = place.expect(0, &["collide", "mcc.toml", "--json", "--engine"]).json();
    let relative = engine["contact_time"].as_f64().unwrap() / number("contact_time") - 1.0;
    assert!(relative.abs() < 1e-3 && relative != 0.0, "{relative}");
    assert!(engine["time_step"].as_f64().unwrap() > 0.0);
}

#[test]
fn overrides_make_a_wall_and_an_oblique_impact() {
    let place = place();
    let wall = "b={material = \"mcc\", wall = true}";
    let answer = place
        .expect(0, &["collide", "mcc.toml", "--json", "--set", wall])
        .json();
    assert!((answer["restitution"].as_f64().unwrap() - 0.54).abs() < 1e-9);
    assert_eq!(answer["velocity"]["b"], serde_json::json!([0.0, 0.0, 0.0]));
    let call = [
        "collide",
        "mcc.toml",
        "--json",
        "--set",
        wall,
        "--set",
        "impact.angle=30 deg",
    ];
    let answer = place.expect(0, &call).json();
    assert!((answer["tangential_restitution"].as_f64().unwrap() + 1.0).abs() < 1e-6);
    assert!((answer["restitution"].as_f64().unwrap() - 0.54).abs() < 1e-5);
}

#[test]
fn curves_are_written_row_by_row() {
    let place = place();
    let call = [
        "contact-curve",
        "mcc.toml",
        "--json",
        "--csv",
        "curve.csv",
        "--plot",
        "curve.svg",
    ];
    let answer = place.expect(0, &call).json();
    assert_eq!(answer["curve"].as_array().unwrap().len(), 800);
    assert_eq!(answer["curve"][0]["branch"], "load");
    let csv = fs::read_to_string(place.path("curve.csv")).unwrap();
    assert_eq!(csv.lines().count(), 801);
    assert!(csv.lines().last().unwrap().starts_with("pull-off,"));
    assert!(fs::read_to_string(place.path("curve.svg")).unwrap().contains("reload"));
}

#[test]
fn what_is_wrong_is_told_and_nothing_is_written() {
    let place = place();
    let before = place.names();
    let wrong = [
        (
            vec!["collide", "mcc.toml", "--set", "a.radius=-1 mm"],
            "must be above 0",
        ),
        (
            vec!["collide", "mcc.toml", "--set", "impact.angle=95 deg"],
            "below 90 deg",
        ),
        (vec!["collide", "mcc.toml", "--set", "b.wall=true"], "one or the other"),
        (
            vec!["collide", "mcc.toml", "--set", "impact.speed=1 m/s"],
            "unknown key `speed`",
        ),
        (vec!["collide", "absent.toml"], "no such file"),
        (
            vec!["contact-curve", "mcc.toml", "--set", "curve.max_force=1e12 N"],
            "the force is",
        ),
        (
            vec!["sticking", "mcc.toml", "--radius", "1um..0.1um"],
            "smaller one first",
        ),
        (vec!["sticking", "mcc.toml", "--radius", "1kg"], "is not a length"),
        (vec!["sticking", "mcc.toml", "--radius", "-1um..1um"], "must be above 0"),
        (
            vec!["sticking", "mcc.toml", "--radius", "1um", "--json"],
            "part at every speed",
        ),
    ];
    for (call, message) in wrong {
        let said = place.expect(2, &call);
        assert!(
            said.err.contains(message) || said.out.contains(message),
            "{call:?}: {} {}",
            said.err,
            said.out
        );
    }
    let said = place.expect(2, &["collide", "mcc.toml", "--json", "--set", "impact.velocity=1 kg"]);
    assert_eq!(said.json()["error"]["diagnostics"][0]["path"], "impact.velocity");
    assert_eq!(place.names(), before);
    place.expect(1, &["collide", "mcc.toml", "--csv", "no/such/folder.csv"]);
}

#[test]
fn no_file_is_replaced_that_is_not_meant() {
    let place = place();
    let before = fs::read(place.path("mcc.toml")).unwrap();
    for command in ["collide", "contact-curve"] {
        for (flag, file, part) in [
            ("--csv", "mcc.toml", "does not end with .csv"),
            ("--plot", "mcc.toml", "does not end with .svg or .png"),
            ("--plot", "notes.txt", "does not end with .svg or .png"),
        ] {
            let said = place.expect(2, &[command, "mcc.toml", flag, file]);
            assert!(said.err.contains(part), "{}", said.err);
        }
    }
    let said = place.expect(2, &["sticking", "mcc.toml", "--radius", "1um", "--csv", "mcc.toml"]);
    assert!(said.err.contains("does not end with .csv"), "{}", said.err);
    assert_eq!(fs::read(place.path("mcc.toml")).unwrap(), before);
    place.expect(0, &["contact-curve", "mcc.toml", "--plot", "curve.png"]);
    assert!(fs::read(place.path("curve.png")).unwrap().starts_with(b"\x89PNG"));
}

#[test]
fn a_file_that_is_there_is_only_replaced_when_that_is_told() {
    let place = place();
    for (flag, file) in [("--csv", "mine.csv"), ("--plot", "mine.svg")] {
        fs::write(place.path(file), "mine").unwrap();
        for call in [
            &["collide", "mcc.toml"][..],
            &["contact-curve", "mcc.toml"],
            &["sticking", "limestone.toml", "--radius", "0.3um"],
        ] {
            let call = [call, &[flag, file]].concat();
            let said = place.expect(2, &call);
            assert!(
                said.err.contains("is there already") && said.err.contains("--overwrite"),
                "{}",
                said.err
            );
        }
        assert_eq!(fs::read_to_string(place.path(file)).unwrap(), "mine");
        place.expect(0, &["collide", "mcc.toml", flag, file, "--overwrite"]);
        assert_ne!(fs::read_to_string(place.path(file)).unwrap(), "mine");
    }
}

#[cfg(unix)]
#[test]
fn the_input_is_no_output_behind_a_link_either() {
    let place = place();
    std::os::unix::fs::symlink("mcc.toml", place.path("link.svg")).unwrap();
    let said = place.expect(2, &["collide", "mcc.toml", "--plot", "link.svg"]);
    assert!(said.err.contains("is input and output"), "{}", said.err);
}

#[test]
fn an_impact_too_deep_for_a_run_is_told_with_what_helps_here() {
    let place = place();
    let fast = "impact.velocity=300 m/s";
    let said = place.expect(3, &["collide", "mcc.toml", "--engine", "--set", fast]);
    assert!(said.err.contains("Without `--engine`"), "{}", said.err);
    assert!(!said.err.contains("raise `simulation"), "{}", said.err);
    let said = place.expect(0, &["collide", "mcc.toml", "--set", fast]);
    assert!(said.err.contains("warning: the bodies overlap by"), "{}", said.err);
    let said = place.expect(0, &["collide", "mcc.toml"]);
    assert!(!said.err.contains("warning"), "{}", said.err);
}

#[test]
fn sticking_tells_what_it_does_not_look_at() {
    let place = place();
    let one = ["sticking", "limestone.toml", "--radius", "0.3um"];
    let said = place.expect(2, &[&one[..], &["--points", "7"]].concat());
    assert!(
        said.err.contains("--points: `--radius 0.3um` is one radius"),
        "{}",
        said.err
    );
    let said = place.expect(0, &[&one[..], &["--set", "impact.angle=30 deg"]].concat());
    assert!(said.err.contains("warning: the angle and the spins"), "{}", said.err);
}

#[test]
fn a_contact_time_with_an_attraction_across_the_gap_says_from_where_to_where() {
    let place = place();
    let told = |tail: &str, start: &str| {
        let (tail, start) = (format!("contact.normal.tail={tail}"), format!("impact.start={start}"));
        let mut call = vec!["collide", "limestone.toml", "--set", "impact.velocity=10 m/s"];
        call.extend(["--set", &tail, "--set", &start]);
        let text = place.expect(0, &call).out;
        text.lines()
            .find(|line| line.contains("contact time"))
            .unwrap()
            .to_string()
    };
    assert!(told("none", "contact").ends_with(" s"));
    assert!(told("full", "far").ends_with(" s, from the first pull across the gap to the last"));
    assert!(told("full", "contact").ends_with(" s, from first touch to the last pull across the gap"));
}
