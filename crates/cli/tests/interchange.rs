//! `demeter convert`, `plot`, `render`, `completions` and `man`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::{FALL, Place};
use serde_json::{Value, json};
use std::fs;

/// A place with a small run in the folder `run`.
fn with_run() -> Place {
    let place = Place::new();
    place.write("fall.toml", FALL);
    place.expect(0, &["run", "fall.toml", "--out", "run"]);
    place
}

#[test]
fn a_run_becomes_a_file_of_every_code_and_what_is_lost_is_said() {
    let place = with_run();
    for (name, start) in [
        ("a.data", "LAMMPS data file of Demeter"),
        ("a.liggghts", "LIGGGHTS data file of Demeter"),
        ("a.dump", "ITEM: UNITS\nsi\nITEM: TIME\n"),
        ("a.yade", "#format x_y_z_r\n"),
        ("a.csv", "id,x [m],y [m],z [m],diameter [m],material,density [kg/m^3],"),
        ("a.vtp", "<VTKFile"),
    ] {
        let said = place.expect(0, &["convert", "run", name]);
        assert!(
            said.out.contains("read   demeter") && said.out.contains(name),
            "{}",
            said.out
        );
        let bytes = fs::read(place.path(name)).unwrap();
        assert!(
            bytes.starts_with(start.as_bytes()),
            "{name}: {}",
            String::from_utf8_lossy(&bytes[..60])
        );
        assert_eq!(
            name == "a.yade",
            said.out.contains("does not carry it: ids, velocities"),
            "{}",
            said.out
        );
    }
    let said = place
        .expect(0, &["convert", "run", "b.xyz", "--frame", "all", "--json"])
        .json();
    let moments = said["moments"].as_u64().unwrap();
    assert!(moments > 1, "{said}");
    let said = place
        .expect(0, &["convert", "run", "each-*.data", "--frame", "all", "--json"])
        .json();
    assert_eq!(said["files"].as_array().unwrap().len() as u64, moments);
    // there and back again
    place.expect(0, &["convert", "b.xyz", "c.csv", "--frame", "last"]);
    place.expect(0, &["convert", "run", "d.csv"]);
    let column = |name: &str| -> Vec<String> {
        let text = fs::read_to_string(place.path(name)).unwrap();
        text.lines()
            .skip(1)
            .map(|line| line.split(',').nth(3).unwrap().to_owned())
            .collect()
    };
    assert_eq!(column("c.csv"), column("d.csv"));
    let said = place.expect(0, &["info", "b.xyz"]);
    assert!(said.out.contains("grains"), "{}", said.out);
}

#[test]
fn the_grains_of_a_run_are_those_of_the_next() {
    let place = with_run();
    let listed = FALL.find("[[grains]]").unwrap()..FALL.find("[[wall]]").unwrap();
    for name in ["grains.csv", "grains.tsv"] {
        place.expect(0, &["convert", "run", name]);
        let mut text = FALL.to_owned();
        text.replace_range(
            listed.clone(),
            &format!("[[grains]]\nmaterial = \"glass\"\nsource = \"file\"\nfile = \"{name}\"\n\n"),
        );
        place.write("next.toml", &text);
        place.expect(0, &["check", "next.toml"]);
    }
    let [commas, tabs] = ["grains.csv", "grains.tsv"].map(|name| fs::read_to_string(place.path(name)).unwrap());
    assert!(commas.lines().next().unwrap().ends_with(",coordination"));
    assert_eq!(commas.replace(',', "\t"), tabs);
}

#[test]
fn wrong_conversions_are_refused() {
    let place = with_run();
    place.expect(0, &["convert", "run", "a.csv"]);
    place.write(
        "bad.dump",
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id x y z radius\n1 0 0 0 1\n",
    );
    for (arguments, part) in [
        (&["convert", "run", "a.csv"][..], "is there already"),
        (&["convert", "run", "a.txt"], "tells no format"),
        (
            &["convert", "run", "b.csv", "--to", "lamps-data"],
            "Did you mean `lammps-data`?",
        ),
        (&["convert", "run", "b.csv", "--columns", "x,sped"], "no column `sped`"),
        (
            &["convert", "run", "b.csv", "--frame", "12345"],
            "no moment number 12345",
        ),
        (
            &["convert", "run", "b.csv", "--frame", "first"],
            "neither `all` nor `last`",
        ),
        (&["convert", "run", "b.yade", "--frame", "all"], "as `b-*.yade`"),
        (
            &["convert", "bad.dump", "b.csv"],
            "bad.dump, line 6: 1 rows where 2 are told",
        ),
        (&["convert", "a.csv", "b.data", "--units", "lj"], "is no set of units"),
        (&["convert", "a.csv", "b.data", "--density", "1 m"], "another unit"),
        (&["convert", "nothing", "b.data"], "nothing: cannot be read"),
    ] {
        let said = place.expect(2, arguments);
        assert!(said.err.contains(part), "{arguments:?}: {}", said.err);
        assert!(!place.path("b.csv").exists() && !place.path("b.data").exists());
    }
}

#[test]
fn rows_of_one_moment_that_words_tell_apart_are_lines_of_their_own() {
    let place = Place::new();
    let rows: String = (0..30)
        .map(|step| {
            format!(
                "{step},{step}e-3,grains,{}\n{step},{step}e-3,walls,{}\n",
                100 + step,
                2 * step
            )
        })
        .collect();
    place.write("forces.csv", &format!("step,time [s],between,contacts\n{rows}"));
    let draw = [
        "plot",
        "forces.csv",
        "time",
        "contacts",
        "--out",
        "forces.svg",
        "--json",
    ];
    let said: Value = serde_json::from_str(&place.expect(0, &draw).out).unwrap();
    assert_eq!((&said["lines"], &said["points"]), (&json!(2), &json!(60)), "{said}");
    let svg = fs::read_to_string(place.path("forces.svg")).unwrap();
    assert!(
        svg.contains(">contacts, grains<") && svg.contains(">contacts, walls<"),
        "{svg}"
    );
    // a profile: several rows of a word at one moment
    let rows: String = (0..30)
        .flat_map(|step| ["a", "b"].map(|word| format!("{step},{word},1,{step}\n{step},{word},2,3\n")))
        .collect();
    place.write("profile.csv", &format!("step,kind,x,y\n{rows}"));
    let draw = |at: &str| {
        let said = place.expect(
            0,
            &["plot", "profile.csv", "x", "y", "--at", at, "--out", "p.svg", "--json"],
        );
        let said: Value = serde_json::from_str(&said.out).unwrap();
        (said["lines"].clone(), said["points"].clone())
    };
    assert_eq!(draw("last"), (json!(2), json!(4)));
    assert_eq!(draw("7"), (json!(2), json!(4)));
    assert_eq!(draw("all"), (json!(60), json!(120)));
    // so many lines have no place in a legend
    let svg = fs::read_to_string(place.path("p.svg")).unwrap();
    let named = svg.matches(">y, ").count();
    assert!(named == 12 && svg.contains(">and 48 between them<"), "{named}");
    assert!(
        svg.contains(">y, a, step 0<") && svg.contains(">y, b, step 29<"),
        "{svg}"
    );
}

#[test]
fn infinite_values_are_left_out_and_counted() {
    let place = Place::new();
    place.write("t.csv", "x,y\n0,1\n1,inf\n2,3\n3,-inf\n4,5\n5,NaN\n");
    let said = place.expect(0, &["plot", "t.csv", "x", "y", "--out", "t.svg", "--json"]);
    assert!(
        said.err
            .contains("3 of 6 points are left out: they are infinite or no numbers"),
        "{}",
        said.err
    );
    assert_eq!(said.json()["points"], 3);
    // no number alone is a gap, which is usual
    place.write("gap.csv", "x,y\n0,1\n1,NaN\n2,\n3,4\n");
    let said = place.expect(0, &["plot", "gap.csv", "x", "y", "--out", "gap.svg", "--json"]);
    assert_eq!((said.err.as_str(), &said.json()["points"]), ("", &json!(2)));
}

#[test]
fn a_name_that_several_columns_have_is_refused() {
    let place = Place::new();
    place.write("t.csv", "a [m],a [s],b,b\n1,4,5,6\n2,3,7,8\n");
    let refused = |x: &str, y: &str, what: &str| {
        let said = place.expect(2, &["plot", "t.csv", x, y, "--out", "t.svg"]);
        assert!(said.err.contains(what), "{}", said.err);
    };
    refused(
        "a",
        "a [s]",
        "the name `a` fits several columns: `a [m]`, `a [s]`; name one with its unit",
    );
    refused(
        "a [m]",
        "b",
        "the name `b` fits several columns: `b`, `b`; give each its own title",
    );
    place.expect(0, &["plot", "t.csv", "a [m]", "a [s]", "--out", "t.svg"]);
}

#[test]
fn bins_of_a_distribution_are_drawn_over_their_edges() {
    let place = Place::new();
    let rows: String = (0..3)
        .flat_map(|step| ["grains", "walls"].map(|word| format!("{step},{word},9,{step},5,2,1\n")))
        .collect();
    place.write(
        "forces.csv",
        &format!("step,between,contacts,0 [N],0.25 [N],0.5 [N],above\n{rows}"),
    );
    let said = place.expect(0, &["plot", "forces.csv"]);
    assert!(
        said.out.lines().any(|line| line.split_whitespace().eq(["bin", "N"])),
        "{}",
        said.out
    );
    let listed: Vec<&str> = said
        .out
        .lines()
        .map(|line| line.trim().split("  ").next().unwrap())
        .collect();
    assert_eq!(
        listed,
        ["step", "between", "contacts", "above", "bin", "in bin"],
        "{}",
        said.out
    );
    assert!(
        said.err.contains("demeter plot forces.csv bin \"in bin\"") || said.err.contains("bin 'in bin'"),
        "{}",
        said.err
    );
    let draw = |at: &str| {
        let run = ["plot", "forces.csv", "bin", "in bin", "--at", at];
        let said = place.expect(0, &[&run[..], &["--points", "--out", "p.svg", "--json"]].concat());
        let said: Value = serde_json::from_str(&said.out).unwrap();
        (said["lines"].clone(), said["points"].clone())
    };
    assert_eq!(draw("last"), (json!(2), json!(6)));
    assert_eq!(draw("all"), (json!(6), json!(18)));
    // what is told at its first row: 0 in the first bin, then 5 and 2
    place.expect(
        0,
        &[
            "plot",
            "forces.csv",
            "bin",
            "in bin",
            "--at",
            "0",
            "--x-range",
            "0.1..1",
            "--log",
            "y",
            "--out",
            "p.svg",
        ],
    );
    let said = place.expect(2, &["plot", "forces.csv", "step", "contacts", "--at", "1"]);
    assert!(
        said.err.contains("draws its bins") && said.err.contains("plot forces.csv bin"),
        "{}",
        said.err
    );
}

#[test]
fn runs_of_a_sweep_keep_the_values_in_their_names() {
    let place = with_run();
    let names = ["restitution=0.3", "restitution=0.3_gravity=0-0--1.62-m-s-2_seed=1"];
    fs::create_dir(place.path(names[1])).unwrap();
    for name in ["series.csv", "run.json", "summary.json"] {
        fs::copy(place.path("run").join(name), place.path(names[1]).join(name)).unwrap();
    }
    fs::rename(place.path("run"), place.path(names[0])).unwrap();
    place.expect(
        0,
        &[
            "plot", names[0], "time", "contacts", "--with", names[1], "--out", "two.svg",
        ],
    );
    let svg = fs::read_to_string(place.path("two.svg")).unwrap();
    for name in names {
        assert!(svg.contains(&format!(">{name}<")), "{name}: {svg}");
    }
}

#[test]
fn columns_are_listed_and_drawn() {
    let place = with_run();
    let said = place.expect(0, &["plot", "run"]);
    assert!(
        said.out.contains("kinetic energy") && said.out.contains("J"),
        "{}",
        said.out
    );
    assert!(
        said.err.contains("`demeter plot run time 'kinetic energy'`"),
        "{}",
        said.err
    );
    place.write("a.csv", "words,x,y\nnone,1,2\n");
    let said = place.expect(0, &["plot", "a.csv"]);
    assert!(said.err.contains("`demeter plot a.csv x y`"), "{}", said.err);
    place.expect(0, &["plot", "run", "time", "kinetic energy"]);
    let svg = fs::read_to_string(place.path("kinetic-energy-over-time.svg")).unwrap();
    assert!(svg.contains(">kinetic energy [J]") && svg.contains(">time [s]<"));
    place.expect(
        0,
        &[
            "plot",
            "run",
            "time",
            "kinetic energy",
            "--with",
            "run/series.csv",
            "--log",
            "y",
            "--out",
            "two.png",
        ],
    );
    assert!(fs::read(place.path("two.png")).unwrap().starts_with(b"\x89PNG"));
    // the first row is that of time 0
    let said = place.expect(0, &["plot", "run", "time", "kinetic energy", "--log", "x"]);
    assert!(
        said.err.contains("warning: 1 of ") && said.err.contains("not above 0"),
        "{}",
        said.err
    );
    for (arguments, part) in [
        (
            &["plot", "run", "time", "kinetc energy"][..],
            "Did you mean `kinetic energy`? `demeter plot run` lists them",
        ),
        (&["plot", "run", "time", "stage"], "holds words"),
        (&["plot", "run", "fall.toml", "time"], "are named behind `--with`"),
        (
            &["plot", "run", "time", "contacts", "--out", "a.gif"],
            "neither .svg nor .png",
        ),
        (&["plot", "run", "time", "contacts", "--x-range", "2..1"], "is no range"),
        (&["plot", "run", "time", "contacts", "--at", "3"], "one row at a time"),
        (
            &["plot", "run", "time", "contacts", "--x-range", "100..200"],
            "there is nothing to draw",
        ),
        (
            &["plot", "run", "--log", "y", "--", "time", "-kinetic energy"],
            "there is nothing to draw",
        ),
        (
            &["plot", "nothing", "time", "contacts"],
            "there is no run and no file `nothing`",
        ),
        (
            &["plot", "fall.toml"],
            "`fall.toml` is a scenario, no table; `demeter run",
        ),
        (&["plot", "run/grains.pvd"], "holds frames for ParaView"),
    ] {
        let said = place.expect(2, arguments);
        assert!(said.err.contains(part), "{arguments:?}: {}", said.err);
    }
}

#[test]
fn frames_become_pictures() {
    let place = with_run();
    let said = place
        .expect(0, &["render", "run", "--size", "400x300", "--json"])
        .json();
    let file = said["files"][0].as_str().unwrap().to_owned();
    assert!(fs::read(place.path(&file)).unwrap().starts_with(b"\x89PNG"));
    let draw = |name: &str, options: &[&str]| {
        place.expect(
            0,
            &[&["render", "run", "--size", "400x300", "--out", name], options].concat(),
        );
        fs::read(place.path(name)).unwrap()
    };
    let plain = draw("a.png", &["--colour", "material"]);
    for (k, options) in [
        &["--colour", "diameter"][..],
        &["--colour", "diameter", "--colour-start", "1 mm"],
        &["--colour", "material", "--view", "top"],
        &["--colour", "material", "--walls", "faces"],
        &["--colour", "material", "--frame", "0"],
        &["--chains"],
        &["--colour", "material", "--clip", "x > 0 m"],
    ]
    .into_iter()
    .enumerate()
    {
        assert!(draw(&format!("{k}.png"), options) != plain, "{options:?}");
    }
    let base = ["render", "run", "--size", "400x300", "--out", "b.png"];
    let said = place.expect(0, &[&base[..], &["--clip", "x > -10 m"]].concat());
    assert!(said.err.contains("the picture shows no grain"), "{}", said.err);
    let said = place.expect(0, &[&base[..], &["--frame", "100 s"]].concat());
    assert!(said.err.contains("there is no frame at 100 s"), "{}", said.err);
    let said = place.expect(0, &base);
    assert!(!said.err.contains("warning"), "{}", said.err);
    let said = place.expect(
        0,
        &["render", "run", "--size", "400x300", "--frame", "all", "--out", "film"],
    );
    assert!(
        said.err.contains("ffmpeg -framerate 25 -i film/%05d.png"),
        "{}",
        said.err
    );
    assert!(place.path("film/00000.png").exists() && place.path("film/00001.png").exists());
    // a longer film that was there leaves no pictures behind its own
    for name in ["film/00099.png", "film/notes.png", "film/99.png"] {
        fs::write(place.path(name), "").unwrap();
    }
    place.expect(
        0,
        &["render", "run", "--size", "400x300", "--frame", "all", "--out", "film"],
    );
    assert!(!place.path("film/00099.png").exists() && place.path("film/00001.png").exists());
    assert!(place.path("film/notes.png").exists() && place.path("film/99.png").exists());
    for (arguments, part) in [
        (&["render", "run", "--colour", "sped"][..], "Did you mean `speed`?"),
        (
            &["render", "run", "--colour", "speed", "--colour-end", "2 kg"],
            "`2 kg` has another unit than what the colours tell, which is in m/s",
        ),
        (&["render", "run", "--colour-end", "2 kg"], "which is in N or m"),
        (
            &["render", "run", "--colour", "coordination", "--colour-end", "2 m"],
            "what the colours tell has none",
        ),
        (
            &["render", "run", "--colour", "diameter", "--colour-start", "2 m/s"],
            "--colour-start: `2 m/s` has another unit than what the colours tell, which is in m",
        ),
        (
            &["render", "run", "--colour-start", "5 N", "--colour-end", "2 N"],
            "--colour-end: `2 N` is not above `--colour-start`, which is `5 N`",
        ),
        (&["render", "run", "--colour-end", "0 N"], "`0 N` is no value above 0"),
        (&["render", "run", "--view", "above"], "tell one of corner, front"),
        (&["render", "run", "--size", "10x10"], "as `1200x900`"),
        (&["render", "run", "--frame", "999"], "there is no frame number 999"),
        (&["render", "run", "--frame", "soon"], "a time, as \"0.5 s\""),
        (&["render", "run", "--clip", "y"], "as `y > 10 mm`"),
        (&["render", "run", "--out", "a.svg"], "does not end with .png"),
        (&["render", "nothing"], "nothing"),
    ] {
        let said = place.expect(2, arguments);
        assert!(said.err.contains(part), "{arguments:?}: {}", said.err);
    }
}

#[test]
fn shells_and_man_know_every_command() {
    let place = Place::new();
    for (shell, part) in [
        ("bash", "_demeter"),
        ("zsh", "#compdef demeter"),
        ("fish", "complete -c demeter"),
        ("powershell", "demeter"),
    ] {
        let said = place.expect(0, &["completions", shell]);
        assert!(said.out.contains(part) && said.out.contains("convert"), "{shell}");
    }
    place.expect(0, &["man", "pages"]);
    let page = fs::read_to_string(place.path("pages/demeter-convert.1")).unwrap();
    assert!(page.contains(".TH") && page.contains("ParaView; output only"), "{page}");
    assert!(place.path("pages/demeter.1").exists());
}
