//! `demeter check`.

use super::demeter::{FALL, Place};
use std::fs;

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
    let told = place.expect(0, &["check", "fall.toml"]).out;
    let borne = answer["fastest_impact"].as_f64().unwrap();
    let fall = "m/s head-on, as from a fall of ";
    assert!(
        borne > 0.1 && told.contains(fall) && told.contains("the most that is allowed"),
        "{told}"
    );
    assert!(told.contains("time_step = \"longest\""), "{told}");
    let with = |step: &str| format!("simulation.time_step={step}");
    for (step, share) in [("longest", 1.0), ("1/50", 0.4)] {
        let answer = place
            .expect(0, &["check", "fall.toml", "--set", &with(step), "--json"])
            .json();
        let step = answer["time_step"].as_f64().unwrap() / answer["longest_time_step"].as_f64().unwrap();
        assert!((step - share).abs() < 1e-9, "{step}");
        assert!(
            answer["warnings"].to_string().contains("times the automatic one"),
            "{answer}"
        );
    }
    let told = place.expect(0, &["check", "fall.toml", "--set", &with("1/50")]).out;
    assert!(
        told.contains("1/50 of the shortest time scale") && !told.contains("\"longest\""),
        "{told}"
    );
    place.expect(2, &["check", "fall.toml", "--set", &with("1/19")]);
    assert_eq!(place.names(), ["fall.toml"]);
}

#[test]
fn check_tells_how_walls_move() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let told = place.expect(0, &["check", "fall.toml"]).out;
    assert!(told.contains("`box` swings by (2.000e-4, 0, 0) m at 50"), "{told}");
    let turned = [
        "--set",
        "wall[0].motion={ rotation = { point = \"6 0 7 mm\", axis = \"y\", angular_velocity = \"30 rpm\" } }",
        "--set",
        "stage[1].motion.box=\"rest\"",
    ];
    let told = place.expect(0, &[&["check", "fall.toml"], &turned[..]].concat()).out;
    // the farthest corner is 9.22 mm from the axis
    let words = [
        "turns at 30",
        "about (0, 1, 0) through",
        "no point faster than 0.02896 m/s",
        "`box` rests",
    ];
    assert!(words.iter().all(|words| told.contains(words)), "{told}");
    let json = place
        .expect(0, &[&["check", "fall.toml", "--json"], &turned[..]].concat())
        .json();
    let of = |k: usize, key: &str| json["motions"][k][key].clone();
    assert_eq!((of(0, "wall"), of(0, "stage")), ("box".into(), serde_json::Value::Null));
    assert_eq!((of(1, "stage"), of(1, "motion")), ("shake".into(), "rests".into()));
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

/// Grains of a feed come around a shaft through the floor, and not where it is, from where they would fall through the hole.
#[test]
fn check_asks_feeds_around_a_shaft() {
    let place = Place::new();
    let (head, _) = OBJ_BOX.split_once("[[grains]]").unwrap();
    let piece = |k: usize, center: &str, half_u: &str, half_v: &str| {
        format!(
            "[[wall]]\nname = \"floor-{k}\"\nmaterial = \"glass\"\nshape = \"rectangle\"\ncenter = \"{center} 0 mm\"\n\
             half_u = \"{half_u} 0 mm\"\nhalf_v = \"{half_v} 0 mm\"\n"
        )
    };
    let floor: String = [
        ("6.5 0", "3.5 0", "0 10"),
        ("-6.5 0", "3.5 0", "0 10"),
        ("0 6.5", "3 0", "0 3.5"),
        ("0 -6.5", "3 0", "0 3.5"),
    ]
    .into_iter()
    .enumerate()
    .map(|(k, (center, half_u, half_v))| piece(k, center, half_u, half_v))
    .collect();
    place.write(
        "ring.toml",
        &format!(
            r#"{head}
[[wall]]
name = "cup"
material = "glass"
shape = "cylinder"
start = "0 0 0 mm"
end = "0 0 40 mm"
radius = "10 mm"
[[wall]]
name = "shaft"
material = "glass"
shape = "cylinder"
side = "outside"
start = "0 0 -5 mm"
end = "0 0 40 mm"
radius = "4.5 mm"
{floor}
[[feed]]
name = "in"
material = "glass"
diameter = "2.5 mm"
number_rate = "1000 1/s"
from = {{ shape = "cylinder", start = "0 0 20 mm", end = "0 0 35 mm", radius = "9 mm" }}
[[stage]]
duration = "0.5 s"
"#
        ),
    );
    let said = place.expect(0, &["check", "ring.toml"]);
    let holds = "hold a grain of diameter 0.0025 m, and are open at the top";
    assert!(said.out.contains(holds), "{}", said.out);
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
    assert!(!said.err.contains("not flat"), "{}", said.err);
    let surface = place.expect(0, &["info", "box.obj", "--json"]).json();
    assert_eq!((&surface["format"], &surface["triangles"]), (&"OBJ".into(), &10.into()));

    // one corner of the floor is lifted by 2 mm
    place.write("box.obj", &leaky_box().replace("v 20 20 0", "v 20 20 2"));
    let said = place.expect(0, &["check", "box.toml"]);
    let told = "wall `box`: 1 faces of the file are not flat: their corners are up to 9.9";
    assert!(
        said.err.contains(told) && said.err.contains("e-4 m apart"),
        "{}",
        said.err
    );
}
