//! `demeter check`, `new`, `laws` and `info`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

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
fn check_tells_how_the_run_would_be() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let answer = place
        .expect(0, &["check", "fall.toml", "--set", "grains[0].count=7", "--json"])
        .json();
    assert_eq!((&answer["grains"], &answer["steps"]), (&7.into(), &12_000.into()));
    assert_eq!(answer["stages"][1]["name"], "shake");
    assert_eq!(answer["stages"][1]["steps"], 6000);
    assert!(answer["memory"].as_u64().unwrap() > 0 && answer["run_time"].as_f64().unwrap() > 0.0);
    assert!(answer["time_step_reason"].as_str().unwrap().starts_with("automatic"));
    assert_eq!(place.names(), ["fall.toml"]);
}

#[test]
fn check_tells_how_many_frames_a_run_writes_and_counts_triangles() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let short = [
        "--set",
        "stage[0].steps=300",
        "--set",
        "stage[1].steps=310",
        "--set",
        "output.frames=20 us",
    ];
    let told = place
        .expect(0, &[&["check", "fall.toml", "--json"], &short[..]].concat())
        .json();
    place.expect(0, &[&["run", "fall.toml", "--out", "fall"], &short[..]].concat());
    let frames = fs::read_dir(place.path("fall/frames")).unwrap();
    let names = frames.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let written = names.filter(|name| name.starts_with("grains_")).count();
    assert!(written > 5, "{written}");
    assert_eq!(told["frames"], written);
    let series = fs::read_to_string(place.path("fall/series.csv")).unwrap();
    assert_eq!(told["rows"], series.lines().count() - 1);
    let per_row = (series.len() / series.lines().count()) as f64;
    let ratio = told["row_bytes"].as_f64().unwrap() / per_row;
    assert!((0.3..3.0).contains(&ratio), "{ratio}");
    let needs = |file: &str| {
        let answer = place.expect(0, &["check", file, "--json"]).json();
        ["memory", "frame_bytes", "run_time"].map(|key| answer[key].as_f64().unwrap())
    };
    let mesh =
        "\n[[wall]]\nname = \"mesh\"\nmaterial = \"glass\"\nshape = \"mesh\"\nfile = \"many.txt\"\nunit = \"m\"\n";
    place.write("mesh.toml", &format!("{FALL}{mesh}"));
    let line = |k: usize| {
        let [x, beside] = [k, k + 1].map(|k| 1e-5 * k as f64);
        format!("{x} 0.006 0.02 {beside} 0.006 0.02 {x} 0.0061 0.02\n")
    };
    place.write("many.txt", &(0..1000).map(line).collect::<String>());
    let (plain, with_mesh) = (needs("fall.toml"), needs("mesh.toml"));
    assert_eq!(with_mesh[0] - plain[0], 300_000.0);
    assert_eq!(with_mesh[1] - plain[1], 21_000.0);
    assert!(with_mesh[2] > plain[2]);
    // contacts that feel each other need more memory, and time
    let coupled = [
        "check",
        "fall.toml",
        "--json",
        "--set",
        "contact.multi_contact={law=\"half-space\"}",
    ];
    let coupled = place.expect(0, &coupled).json();
    assert!(coupled["memory"].as_f64().unwrap() > plain[0] && coupled["run_time"].as_f64().unwrap() > plain[2]);
}

/// A box of 20 mm without lid, drawn in millimetres, with a hole in the side at x = 20: one of its triangles is missing.
fn leaky_box() -> String {
    let mut text = "o box\n".to_string();
    for k in 0..8 {
        text.push_str(&format!(
            "v {} {} {}\n",
            20 * (k & 1),
            20 * ((k >> 1) & 1),
            20 * ((k >> 2) & 1)
        ));
    }
    text + "f 1 3 4 2\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8\nf 2 4 4\n"
}

#[test]
fn check_asks_feeds_where_grains_come() {
    let place = Place::new();
    let (head, _) = OBJ_BOX.split_once("[[grains]]").unwrap();
    let scenario = |from: &str| {
        format!(
            r#"{head}
[[wall]]
name = "cup"
material = "glass"
shape = "cylinder"
start = "0 0 0 mm"
end = "0 0 85 mm"
radius = "10 mm"
[[wall]]
name = "floor"
material = "glass"
shape = "disc"
center = "0 0 0 mm"
normal = "z"
radius = "10 mm"
[[feed]]
name = "in"
material = "glass"
diameter = "2.5 mm"
number_rate = "1000 1/s"
from = {from}
[[stage]]
duration = "0.5 s"
"#
        )
    };
    // the corners of the boxes around these are outside of the cup
    for from in [
        r#"{ shape = "disc", center = "0 0 80 mm", normal = "z", radius = "9 mm" }"#,
        r#"{ shape = "cylinder", start = "0 0 70 mm", end = "0 0 80 mm", radius = "9 mm" }"#,
        r#"{ shape = "rectangle", center = "0 0 80 mm", half_u = "6 6 0 mm", half_v = "-2 2 0 mm" }"#,
    ] {
        place.write("cup.toml", &scenario(from));
        let said = place.expect(0, &["check", "cup.toml"]);
        let holds = "hold a grain of diameter 0.0025 m, and are open at the top";
        assert!(said.out.contains(holds), "{from}: {}", said.out);
        assert!(said.out.contains("about 500 grains come"), "{}", said.out);
        assert!(said.out.contains("at most about"), "{}", said.out);
    }
}

/// A grain in the box of `leaky_box`.
const OBJ_BOX: &str = r#"
[simulation]
gravity = "0 0 -9.81 m/s^2"
[material.glass]
young_modulus = "5 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.8 }
[[grains]]
material = "glass"
source = "list"
positions = ["10 10 3 mm"]
diameters = ["2 mm"]
[[wall]]
name = "box"
material = "glass"
shape = "mesh"
file = "box.obj"
[[stage]]
name = "fall"
duration = "1 ms"
"#;

#[test]
fn check_tells_of_meshes_that_move_through_one_another() {
    let place = Place::new();
    place.write("box.obj", &leaky_box());
    place.write("blade.txt", "corners\n4 10 10 16 10 10 10 10 18\n");
    let turns = r#"{ rotation = { point = "10 10 10 mm", axis = "z", angular_velocity = "10 rad/s" } }"#;
    let box_turns = format!("motion.box = {turns}\n");
    let both_turn = format!("{box_turns}motion.blade = {{ with = \"box\" }}\n");
    for (shift, motion, in_stage, crosses) in [
        ("0 0 0 mm", turns, "", false),
        ("-7 0 0 mm", turns, "", true),
        ("-7 0 0 mm", "\"rest\"", "", false),
        ("-7 0 0 mm", "\"rest\"", &box_turns, true),
        ("-7 0 0 mm", "\"rest\"", &both_turn, false),
        ("-7 0 0 mm", r#"{ with = "box" }"#, "", false),
        ("-7 0 0 mm", r#"{ with = "box" }"#, &box_turns, false),
        ("30 0 0 mm", turns, "", false),
    ] {
        let blade = format!(
            "[[wall]]\nname = \"blade\"\nmaterial = \"glass\"\nshape = \"mesh\"\nfile = \"blade.txt\"\nunit = \"mm\"\n\
             shift = \"{shift}\"\nmotion = {motion}\n[[stage]]"
        );
        let scenario = OBJ_BOX.replace("\"box.obj\"", "\"box.obj\"\nunit = \"mm\"");
        place.write("cross.toml", &(scenario.replace("[[stage]]", &blade) + in_stage));
        let said = place.expect(0, &["check", "cross.toml"]);
        let told = said.out.contains("`box` passes through `blade`");
        assert_eq!(told, crosses, "{shift} {motion} {in_stage}: {}", said.out);
        let answer = place.expect(0, &["check", "cross.toml", "--json"]).json();
        let crossings = answer["wall_report"]["crossings"].as_array().unwrap();
        assert_eq!(crossings.len(), usize::from(crosses));
        if crosses {
            let x = crossings[0]["place"][0].as_f64().unwrap();
            assert!(x.abs() < 2e-3, "{crossings:?}");
        }
    }
}

#[test]
fn check_tells_of_meshes_and_where_grains_get_out() {
    let place = Place::new();
    place.write("box.obj", &leaky_box());
    let scenario = OBJ_BOX;
    place.write("box.toml", scenario);
    let said = place.expect(0, &["check", "box.toml"]);
    assert!(
        said.err.contains("is this file in mm? Then say `unit = \"mm\"`"),
        "{}",
        said.err
    );
    assert!(said.err.contains("left out 1 triangle without area"), "{}", said.err);

    place.write(
        "box.toml",
        &scenario.replace("\"box.obj\"", "\"box.obj\"\nunit = \"mm\""),
    );
    let said = place.expect(0, &["check", "box.toml"]);
    assert!(!said.err.contains("unit"), "{}", said.err);
    for words in [
        "wall box",
        "unit: mm, as told",
        "holes or open ends",
        "leak test",
        "m wide",
        "upwards: open at the top",
    ] {
        assert!(said.out.contains(words), "`{words}` is missing: {}", said.out);
    }
    let answer = place.expect(0, &["check", "box.toml", "--json"]).json();
    let leaks = &answer["wall_report"]["leak_test"];
    assert_eq!(
        (&leaks["tight"], &leaks["open_at_top"]),
        (&false.into(), &true.into()),
        "{leaks}"
    );
    let opening = &leaks["openings"][0];
    assert!((opening["place"][0].as_f64().unwrap() - 0.02).abs() < 1e-3, "{opening}");
    let mesh = &answer["wall_report"]["meshes"][0];
    assert_eq!(
        (&mesh["wall"], &mesh["repair"]["without_area"]),
        (&"box".into(), &1.into())
    );

    // with the missing triangle it is tight
    place.write("box.obj", &leaky_box().replace("f 2 4 4", "f 2 8 6"));
    let said = place.expect(0, &["check", "box.toml"]);
    assert!(
        said.out
            .contains("hold a grain of diameter 0.002 m, and are open at the top"),
        "{}",
        said.out
    );
    let surface = place.expect(0, &["info", "box.obj", "--json"]).json();
    assert_eq!((&surface["format"], &surface["triangles"]), (&"OBJ".into(), &10.into()));
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
