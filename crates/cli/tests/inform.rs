//! `demeter check`, `new`, `laws` and `info`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

#[path = "inform/check.rs"]
mod check;
mod demeter;

use demeter::{FALL, Place};
use std::fs;
use std::path::Path;

/// Templates in the order of `demeter new`.
fn templates(place: &Place) -> Vec<String> {
    let said = place.expect(0, &["new"]);
    let rows = said.out.lines().filter_map(|line| line.strip_prefix("  "));
    rows.map(|row| row.split_whitespace().next().unwrap().to_string())
        .collect()
}

/// Settings of the runs that the head of a template tells, as a shell gives them.
fn settings_told(template: &str) -> Vec<String> {
    let told = template.lines().filter_map(|line| line.strip_prefix("#   demeter run"));
    let settings = told.filter_map(|line| Some(line.split_once("--set ")?.1));
    settings
        .map(|text| match text.splitn(3, '"').collect::<Vec<_>>()[..] {
            [path, value, _] => format!("{path}{value}"),
            _ => text.split_whitespace().next().unwrap().to_string(),
        })
        .collect()
}

#[test]
fn every_template_is_written_and_checked() {
    let place = Place::new();
    let names = templates(&place);
    assert!(names.len() >= 5, "{names:?}");
    for name in &names {
        let file = format!("{name}.toml");
        let said = place.expect(0, &["new", name]);
        assert!(said.out.contains(&format!("demeter run {file}")), "{}", said.out);
        let said = place.expect(0, &["check", &file]);
        assert!(
            said.out.contains("time step") && said.out.contains("run time"),
            "{}",
            said.out
        );
        let before = fs::read(place.path(&file)).unwrap();
        for setting in settings_told(&String::from_utf8_lossy(&before)) {
            place.expect(0, &["check", &file, "--set", &setting]);
        }
        let said = place.expect(2, &["new", name]);
        assert!(said.err.contains("exists and is not replaced"), "{}", said.err);
        assert_eq!(fs::read(place.path(&file)).unwrap(), before);
    }
    assert_eq!(
        place.names().len(),
        names.len() + 1,
        "check wrote something: {:?}",
        place.names()
    );
    let schema = fs::read_to_string(place.path("demeter-scenario.schema.json")).unwrap();
    assert_eq!(place.expect(0, &["schema"]).out, schema);
    place.expect(0, &["new", &names[0], "--out", "mine.toml"]);
    assert_eq!(
        fs::read(place.path("mine.toml")).unwrap(),
        fs::read(place.path(&format!("{}.toml", names[0]))).unwrap()
    );
    let said = place.expect(2, &["new", "drumm"]);
    assert!(said.err.contains("Did you mean `drum`?"), "{}", said.err);
}

#[test]
fn laws_are_listed_and_explained() {
    let place = Place::new();
    let all = place.expect(0, &["laws", "--json"]).json();
    let laws = all["laws"].as_array().unwrap();
    let table = place.expect(0, &["laws"]).out;
    assert!(laws.len() >= 7);
    for law in laws {
        let (name, family) = (law["name"].as_str().unwrap(), law["family"].as_str().unwrap());
        assert!(table.contains(name) && table.contains(family));
        let text = place.expect(0, &["laws", name]).out;
        assert!(text.contains(law["doc"].as_str().unwrap().trim()), "{name}");
        assert!(text.contains(law["example"].as_str().unwrap()), "{name}");
    }
    let said = place.expect(2, &["laws", "hertz_tsuji"]);
    assert!(
        said.err.contains("Did you mean `hertz-tsuji`?") && said.out.is_empty(),
        "{}",
        said.err
    );
    let error = place.expect(2, &["laws", "mindlin", "--json"]).json();
    assert!(
        error["error"]["message"]
            .as_str()
            .unwrap()
            .contains("`mindlin-history`")
    );
}

#[test]
fn a_wrong_command_line_is_an_error_in_json_too() {
    let place = Place::new();
    let said = place.expect(2, &["run", "--jsno"]);
    assert!(said.out.is_empty() && said.err.contains("--json"), "{}", said.err);
    let error = place
        .expect(2, &["run", "--json", "--threads", "many", "a.toml"])
        .json();
    assert_eq!(error["error"]["kind"], "command line");
    assert!(place.expect(0, &["--help"]).out.contains("Exit codes"));
    assert!(place.expect(0, &["run", "--help"]).out.contains("runs/NAME-2"));
    assert!(place.expect(0, &["--version"]).out.starts_with("demeter "));
}

fn shared(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../scenarios/good")
        .join(name);
    path.to_str().unwrap().to_string()
}

#[test]
fn info_knows_a_run_and_what_is_in_it() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    place.expect(
        0,
        &[
            "run",
            "fall.toml",
            "--out",
            "fall",
            "--set",
            "stage[0].steps=300",
            "--set",
            "stage[1].steps=300",
        ],
    );
    let run = place.expect(0, &["info", "fall", "--json"]).json();
    assert_eq!((&run["kind"], &run["checkpoint"]["step"]), (&"run".into(), &600.into()));
    assert_eq!(run["summary"]["title"], "Grains fall into a box");
    let rows = fs::read_to_string(place.path("fall/series.csv"))
        .unwrap()
        .lines()
        .count()
        - 1;
    assert_eq!(run["series_rows"], rows);
    let series = place.expect(0, &["info", "fall/series.csv", "--json"]).json();
    assert_eq!(
        (&series["kind"], &series["rows"]),
        (&"series of a run".into(), &rows.into())
    );
    assert!(
        series["columns"]
            .as_array()
            .unwrap()
            .contains(&"wall box force x [N]".into()),
        "{series}"
    );
    assert_eq!(series["end"], run["summary"]["simulated_time"]);
    let checkpoint = place.expect(0, &["info", "fall/checkpoint.latest", "--json"]).json();
    assert_eq!(
        (&checkpoint["kind"], &checkpoint["grains"]),
        (&"checkpoint".into(), &120.into())
    );
    let scenario = place.expect(0, &["info", "fall.toml", "--json"]).json();
    assert_eq!(scenario["stages"], serde_json::json!(["fall", "shake"]));
    for file in ["fall", "fall/series.csv", "fall/checkpoint.latest", "fall.toml"] {
        let text = place.expect(0, &["info", file]).out;
        assert!(text.starts_with(file) && text.lines().count() > 3, "{text}");
    }
    let said = place.expect(2, &["info", "fall/grains.pvd"]);
    assert!(said.err.contains("ParaView"), "{}", said.err);

    // what is damaged is not called whole
    let path = place.path("fall/checkpoint.latest");
    let mut bytes = fs::read(&path).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&path, bytes).unwrap();
    let said = place.expect(1, &["info", "fall/checkpoint.latest"]);
    assert!(said.err.contains("checksum"), "{}", said.err);
    assert!(place.expect(0, &["info", "fall"]).out.contains("checksum"));
    let mut frames: Vec<_> = fs::read_dir(place.path("fall/frames"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    frames.sort();
    fs::remove_file(frames.pop().unwrap()).unwrap();
    let lacks = "1 frame is not whole";
    assert!(place.expect(0, &["info", "fall"]).out.contains(lacks));
    let said = place.expect(0, &["render", "fall", "--out", "last.png"]);
    assert!(said.err.contains(lacks), "{}", said.err);
    let said = place.expect(2, &["render", "fall", "--colour", "material", "--colour-end", "2 m"]);
    assert!(said.err.contains("materials have none"), "{}", said.err);
}

#[test]
fn a_series_that_is_cut_short_is_not_taken_for_whole() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let short = ["--set", "stage[0].steps=300", "--set", "stage[1].steps=300"];
    place.expect(0, &[&["run", "fall.toml", "--out", "fall"][..], &short].concat());
    let plot = ["plot", "fall", "time", "kinetic energy", "--out", "energy.svg"];
    assert!(!place.expect(0, &plot).err.contains("warning"));
    // a summary that is damaged takes nothing from the rows
    let summary = std::fs::read_to_string(place.path("fall/summary.json")).unwrap();
    place.write("fall/summary.json", &summary[..summary.len() / 2]);
    let said = place.expect(0, &plot).err;
    assert!(said.contains("warning: ") && said.contains("summary.json"), "{said}");
    place.write("fall/summary.json", &summary);
    let series = std::fs::read_to_string(place.path("fall/series.csv")).unwrap();
    let rows: Vec<&str> = series.lines().collect();
    // two rows and a part of a third
    place.write(
        "fall/series.csv",
        &format!("{}\n{}", rows[..3].join("\n"), &rows[3][..9]),
    );
    let lost = "though the run is finished and has 600 steps";
    let said = place.expect(0, &plot);
    assert!(
        said.err.contains("warning: `fall/series.csv`") && said.err.contains(lost),
        "{}",
        said.err
    );
    let said = place.expect(0, &["info", "fall"]);
    assert!(
        said.out.contains("damaged: it ends at step") && said.out.contains(lost),
        "{}",
        said.out
    );
    let said = place.expect(0, &["report", "fall"]);
    assert!(said.err.contains(lost), "{}{}", said.out, said.err);

    place.write(
        "fall/series.csv",
        &format!("{}\n1,2\n{}\n", rows[..2].join("\n"), rows[2]),
    );
    let said = place.expect(2, &["info", "fall/series.csv"]);
    assert!(said.err.contains("line 3: the row has 2 cells"), "{}", said.err);
}

#[test]
fn info_knows_grains_and_surfaces() {
    let place = Place::new();
    place.write("two.csv", "id x y z diameter\n1 0 0 0 0.002\n7 0.01 0 0 0.004\n");
    let grains = place.expect(0, &["info", "two.csv", "--json"]).json();
    assert_eq!(grains["grains"], 2);
    assert_eq!(grains["diameter"]["maximum"], 0.004);
    assert_eq!(grains["diameter"]["mean"], 0.003);
    assert_eq!(grains["upper"], serde_json::json!([0.012, 0.002, 0.002]));
    assert_eq!(grains["columns"], serde_json::json!(["ids", "positions", "diameters"]));
    place.expect(0, &["info", &shared("grains.csv")]);
    let tilted =
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS xy xz yz pp pp pp\n0 14 4\n0 10 0\n0 10 0\n";
    place.write("one.dump", &format!("{tilted}ITEM: ATOMS x y z radius\n1 1 1 1\n"));
    let said = place.expect(0, &["info", "one.dump"]);
    assert!(said.out.contains("tilted by xy, xz, yz = (4, 0, 0) m"), "{}", said.out);

    let said = place.expect(0, &["info", &shared("plate.stl")]);
    assert!(said.out.contains("open"), "{}", said.out);
    place.write("tetrahedron.stl", &tetrahedron(4));
    let surface = place.expect(0, &["info", "tetrahedron.stl", "--json"]).json();
    assert_eq!((&surface["triangles"], &surface["closed"]), (&4.into(), &true.into()));
    let area = 1.5 + 0.75f64.sqrt();
    assert!((surface["area"].as_f64().unwrap() - area).abs() < 1e-12);
    place.write("hole.stl", &tetrahedron(3));
    let surface = place.expect(0, &["info", "hole.stl", "--json"]).json();
    assert_eq!((&surface["closed"], &surface["open_edges"]), (&false.into(), &3.into()));

    place.write("broken.csv", "x y z diameter\n0 0 zero 1\n");
    let said = place.expect(2, &["info", "broken.csv"]);
    assert!(said.err.contains("line 2") && said.err.contains("zero"), "{}", said.err);
    let said = place.expect(2, &["plot", &shared("plate.stl")]);
    assert!(said.err.contains("no column of numbers"), "{}", said.err);
    fs::write(place.path("tetrahedron.stl.gz"), [0x1f, 0x8b, 8, 0]).unwrap();
    let said = place.expect(2, &["info", "tetrahedron.stl.gz"]);
    assert!(said.err.contains("compressed by gzip"), "{}", said.err);
    place.write("notes.pdf", "hello");
    assert!(
        place
            .expect(2, &["info", "notes.pdf"])
            .err
            .contains("a checkpoint, a file of grains")
    );
    place.expect(2, &["info", "absent"]);
    place.expect(2, &["info", "."]);
}

/// The first faces of the tetrahedron with corners 0, x, y and z, as an ASCII STL file.
fn tetrahedron(faces: usize) -> String {
    let corners = ["0 0 0", "1 0 0", "0 1 0", "0 0 1"];
    let all = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
    let mut text = String::from("solid t\n");
    for face in &all[..faces] {
        let [a, b, c] = face.map(|k: usize| corners[k]);
        text.push_str(&format!(
            "facet normal 0 0 0\nouter loop\nvertex {a}\nvertex {b}\nvertex {c}\nendloop\nendfacet\n"
        ));
    }
    text + "endsolid t\n"
}

#[test]
fn a_schema_is_told_and_written_and_nothing_else_is_replaced() {
    let place = Place::new();
    for kind in ["scenario", "two-bodies", "fit", "packing-fit"] {
        let told = place.expect(0, &["schema", kind]);
        assert_eq!(told.json()["$schema"], "http://json-schema.org/draft-07/schema#");
        let said = place.expect(0, &["schema", kind, "--out", "s.json"]);
        assert!(said.out.contains("#:schema s.json"), "{}", said.out);
        assert_eq!(fs::read_to_string(place.path("s.json")).unwrap(), told.out);
    }
    place.write("mine.json", "{}");
    let said = place.expect(2, &["schema", "--out", "mine.json"]);
    assert!(said.err.contains("exists and is no schema"), "{}", said.err);
    let said = place.expect(2, &["schema", "scenaro"]);
    assert!(said.err.contains("scenario"), "{}", said.err);
}

/// What a launcher tells several processes that do not share their work.
#[test]
fn several_processes_that_would_each_do_all_are_refused() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let refused = |name: &str, value: &str, command: &[&str]| {
        let output = place.command(command).env(name, value).output().unwrap();
        (
            output.status.code(),
            String::from_utf8_lossy(&output.stderr).into_owned(),
        )
    };
    for (name, value) in [
        ("OMPI_COMM_WORLD_SIZE", "2"),
        ("PMIX_RANK", "1"),
        ("SLURM_STEP_NUM_TASKS", "2"),
    ] {
        let (code, err) = refused(name, value, &["sweep", "fall.toml", "--repeat", "2"]);
        assert!(code == Some(2) && err.contains("share their work"), "{err}");
    }
    let (code, err) = refused("SLURM_STEP_NUM_TASKS", "1", &["check", "fall.toml"]);
    assert_eq!(code, Some(0), "{err}");
    let (code, err) = refused("SLURM_STEP_NUM_TASKS", "2", &["run", "fall.toml"]);
    assert!(code == Some(2) && err.contains("each would run all"), "{err}");
    assert_eq!(place.names(), ["fall.toml"]);
}
