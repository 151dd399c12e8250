//! `demeter run`: results, exit codes, and that nothing is lost.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

mod demeter;

use demeter::{FALL, Place, assert_same};
use std::fs;
use std::process::{Command, Stdio};

const SHORT: [&str; 4] = ["--set", "stage[0].steps=300", "--set", "stage[1].steps=300"];

#[test]
fn a_run_to_the_end_answers_in_json() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let said = place.expect(0, &[&["run", "fall.toml", "--json"], &SHORT[..]].concat());
    let answer = said.json();
    assert_eq!(answer["end"], "finished");
    assert_eq!(answer["exit_code"], 0);
    assert_eq!(answer["folder"], "runs/fall");
    assert_eq!(answer["grains"], 120);
    assert_eq!(answer["steps"], 600);
    assert_eq!(answer["stages"].as_array().unwrap().len(), 2);
    assert!(answer["energies"]["max_residual"].as_f64().unwrap() < 1e-3);
    let summary: serde_json::Value =
        serde_json::from_slice(&fs::read(place.path("runs/fall/summary.json")).unwrap()).unwrap();
    assert_eq!(summary["simulated_time"], answer["simulated_time"]);
    assert!(said.err.contains("stage `fall` ended"), "{}", said.err);
}

#[test]
fn an_earlier_run_is_never_lost() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let run = [&["run", "fall.toml"], &SHORT[..]].concat();
    let said = place.expect(0, &run);
    assert!(
        said.out.contains("runs/fall\n") && said.out.contains("energy residual"),
        "{}",
        said.out
    );
    let first = place.results("runs/fall");
    let said = place.expect(0, &run);
    assert!(
        said.err.contains("runs/fall-2") && said.err.contains("--overwrite"),
        "{}",
        said.err
    );
    assert_same(&first, &place.results("runs/fall-2"));
    assert!(
        place
            .call(&[&run[..], &["--overwrite"]].concat())
            .out
            .contains("runs/fall\n")
    );
    assert!(!place.path("runs/fall-3").exists());

    let said = place.expect(2, &[&run[..], &["--out", "runs/fall"]].concat());
    assert!(said.err.contains("already holds a Demeter run"), "{}", said.err);
    assert!(
        said.err.contains("demeter resume") && said.err.contains("--overwrite"),
        "{}",
        said.err
    );
    assert_same(&first, &place.results("runs/fall"));
}

/// Calls at the same moment, and what they said.
fn at_once(place: &Place, count: usize, arguments: &[&str]) -> Vec<demeter::Said> {
    std::thread::scope(|scope| {
        let calls: Vec<_> = (0..count).map(|_| scope.spawn(|| place.call(arguments))).collect();
        calls.into_iter().map(|call| call.join().unwrap()).collect()
    })
}

#[test]
fn runs_that_start_at_the_same_moment_have_a_folder_each() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let run = [&["run", "fall.toml", "--threads", "1"], &SHORT[..]].concat();
    let said = at_once(&place, 3, &run);
    for said in &said {
        assert_eq!(said.code, 0, "{}", said.err);
    }
    let first = place.results("runs/fall");
    assert_same(&first, &place.results("runs/fall-2"));
    assert_same(&first, &place.results("runs/fall-3"));
}

#[test]
fn of_runs_that_start_in_one_folder_at_the_same_moment_one_is_carried_out() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    place.expect(0, &[&["run", "fall.toml", "--out", "one"], &SHORT[..]].concat());
    let whole = place.results("one");
    let again = ["run", "fall.toml", "--threads", "1", "--out", "one", "--overwrite"];
    let said = at_once(&place, 4, &[&again[..], &SHORT[..]].concat());
    assert!(said.iter().any(|said| said.code == 0));
    for refused in said.iter().filter(|said| said.code != 0) {
        assert!(refused.err.contains("another run is being written"), "{}", refused.err);
    }
    assert_same(&whole, &place.results("one"));
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let base = [&["run", "fall.toml", "--set", "grains[0].count=300"], &SHORT[..]].concat();
    let base = [
        &base[..],
        &["--set", "grains[0].region.upper=[\"12 mm\",\"12 mm\",\"30 mm\"]"],
    ]
    .concat();
    let base = [&base[..], &["--set", "wall[0].upper=[\"12 mm\",\"12 mm\",\"32 mm\"]"]].concat();
    place.expect(0, &[&base[..], &["--threads", "1", "--out", "one"]].concat());
    place.expect(0, &[&base[..], &["--threads", "2", "--out", "two"]].concat());
    place.expect(0, &[&base[..], &["--threads", "5", "--out", "five"]].concat());
    assert_same(&place.results("one"), &place.results("two"));
    assert_same(&place.results("one"), &place.results("five"));
}

#[test]
fn a_profile_tells_where_the_time_went_and_changes_no_bit() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let base = [&["run", "fall.toml"], &SHORT[..]].concat();
    let said = place.expect(0, &[&base[..], &["--out", "quiet"]].concat());
    assert!(!said.out.contains("where the time went"), "{}", said.out);
    let summary = |folder: &str| -> serde_json::Value {
        serde_json::from_slice(&fs::read(place.path(folder).join("summary.json")).unwrap()).unwrap()
    };
    assert!(summary("quiet").get("profile").is_none());

    let asked = ["--profile", "--instructions", "portable", "--out", "told"];
    let said = place.expect(0, &[&base[..], &asked].concat());
    for line in [
        "where the time went",
        "search",
        "laws",
        "sums and kick",
        "output",
        "the time that memory alone would need",
    ] {
        assert!(said.out.contains(line), "no `{line}`: {}", said.out);
    }
    let profile = &summary("told")["profile"];
    assert_eq!(
        (&profile["steps"], &profile["particle_steps"]),
        (&600.into(), &72_000.into())
    );
    assert_eq!(profile["instructions"], "portable");
    let phases = profile["phases"].as_array().unwrap();
    let seconds: f64 = phases.iter().map(|phase| phase["seconds"].as_f64().unwrap()).sum();
    assert!(
        (seconds / profile["seconds"].as_f64().unwrap() - 1.0).abs() < 1e-6,
        "{profile}"
    );
    assert!(profile["roofline"]["times_memory"].as_f64().unwrap() > 0.0, "{profile}");
    assert_same(&place.results("quiet"), &place.results("told"));
}

#[test]
fn instructions_that_are_not_there_are_refused_before_anything_is_written() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let foreign = if cfg!(target_arch = "aarch64") { "avx2" } else { "neon" };
    for name in ["sse9", foreign] {
        let said = place.expect(2, &["run", "fall.toml", "--instructions", name]);
        let lists = said.err.contains(&format!("no instructions `{name}`")) && said.err.contains("`portable`");
        assert!(lists, "{}", said.err);
    }
    assert_eq!(place.names(), ["fall.toml"]);
}

#[test]
fn the_environment_asks_for_no_more_threads_than_the_command_line() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let mut command = place.command(&["run", "fall.toml"]);
    let output = command.env("RAYON_NUM_THREADS", "20000").output().unwrap();
    assert_ne!(output.status.code(), Some(0));
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(told.contains("RAYON_NUM_THREADS") && told.contains("4096"), "{told}");
    assert_eq!(place.names(), ["fall.toml"]);
}

#[test]
fn a_wrong_scenario_writes_nothing() {
    let place = Place::new();
    place.write(
        "wrong.toml",
        &FALL
            .replace("poisson_ratio = 0.25", "poisson_ratio = 0.9")
            .replace("count", "cuont"),
    );
    for command in ["run", "check"] {
        let said = place.expect(2, &[command, "wrong.toml"]);
        assert!(said.out.is_empty(), "{}", said.out);
        assert!(
            said.err.contains("did you mean `count`") && said.err.contains("poisson_ratio"),
            "{}",
            said.err
        );
        assert!(said.err.contains("wrong.toml:10:17"), "{}", said.err);
        assert!(!said.err.contains('\u{1b}'), "colours without a terminal: {}", said.err);
        let error = &place.expect(2, &[command, "wrong.toml", "--json"]).json()["error"];
        let diagnostics = error["diagnostics"].as_array().unwrap();
        assert_eq!(error["kind"], "scenario");
        assert_eq!(diagnostics[0]["path"], "material.glass.poisson_ratio");
        assert_eq!(
            (&diagnostics[0]["line"], &diagnostics[0]["column"]),
            (&10.into(), &17.into())
        );
        assert!(diagnostics.iter().any(|d| d["help"] == "did you mean `count`?"));
    }
    assert_eq!(place.names(), ["wrong.toml"]);
}

/// What only shows while the run is made ready must also leave nothing behind.
#[test]
fn what_the_reader_cannot_see_writes_nothing() {
    let place = Place::new();
    place.write(
        "mesh.toml",
        &FALL.replace(
            "shape = \"box\"\nlower = \"0 0 0 mm\"\nupper = \"12 12 14 mm\"",
            "shape = \"mesh\"\nfile = \"none.stl\"",
        ),
    );
    let said = place.expect(2, &["run", "mesh.toml"]);
    assert!(said.err.contains("none.stl"), "{}", said.err);
    place.write("fall.toml", FALL);
    place.expect(2, &["run", "fall.toml", "--set", "grains[0].count=100000"]);
    place.expect(2, &["run", "fall.toml", "--set", "simulation.time_step=1 ms"]);
    place.expect(2, &["run", "fall.toml", "--threads", "0"]);
    place.expect(2, &["run", "absent.toml"]);
    place.expect(2, &["run", "."]);
    assert_eq!(place.names(), ["fall.toml", "mesh.toml"]);
}

/// Grains fly out of a box through its open side.
fn leak(outside: &str) -> String {
    let open = FALL.replace("upper = \"12 12 14 mm\"", "upper = \"12 12 14 mm\"\nopen = [\"+x\"]");
    let domain = format!(
        "[domain]\nlower = \"-5 -5 -5 mm\"\nupper = \"15 20 20 mm\"\noutside = \"{outside}\"\n\n[material.glass]"
    );
    open.replace("0.3 0.1 -0.2 m/s", "3 0 0 m/s")
        .replace("[material.glass]", &domain)
}

/// Grains in contact that leave in the step in which candidates are found anew.
#[test]
fn grains_that_may_leave_do() {
    let place = Place::new();
    place.write("leak.toml", &leak("remove"));
    let answer = place.expect(0, &["run", "leak.toml", "--json"]).json();
    assert!(answer["grains"].as_u64().unwrap() < 60, "{}", answer["grains"]);
    assert!(answer["energies"]["removed"].as_f64().unwrap() > 0.0);
    assert!(answer["energies"]["max_residual"].as_f64().unwrap() < 1e-3);
}

#[test]
fn a_fault_leaves_a_snapshot_and_names_the_grain() {
    let place = Place::new();
    place.write("leak.toml", &leak("stop"));
    let said = place.expect(3, &["run", "leak.toml", "--out", "leak"]);
    assert!(
        said.err.contains("error: step") && said.err.contains("left the domain"),
        "{}",
        said.err
    );
    assert!(said.out.contains("stopped on a fault of grain"), "{}", said.out);
    let answer = place
        .expect(3, &["run", "leak.toml", "--out", "again", "--json"])
        .json();
    assert_eq!(answer["end"], "fault");
    let grain = answer["fault"]["grain"].as_u64().unwrap();
    assert!(
        answer["fault"]["message"]
            .as_str()
            .unwrap()
            .contains(&format!("grain {grain} left"))
    );
    assert!(answer["finished"] == false && answer["stopped_by"] == answer["fault"]["message"]);
    // the last frame is the state at the fault
    let pvd = fs::read_to_string(place.path("leak/grains.pvd")).unwrap();
    let last = pvd.lines().rfind(|line| line.contains("<DataSet")).unwrap();
    let snapshot = format!("frames/grains_{:010}.vtp", answer["steps"].as_u64().unwrap());
    assert!(last.contains(&snapshot), "{last} {snapshot}");
    assert!(place.path("leak").join(snapshot).is_file());
}

#[test]
fn very_many_errors_are_counted() {
    let place = Place::new();
    let keys: String = (0..150).map(|k| format!("k{k} = 1\n")).collect();
    place.write("fall.toml", &format!("{FALL}{keys}"));
    let said = place.expect(2, &["run", "fall.toml"]);
    assert!(
        said.err.contains("... and 50 more faults") && said.err.contains("\n150 errors; nothing was written"),
        "{}",
        said.err
    );
    assert_eq!(
        place.expect(2, &["check", "fall.toml", "--json"]).json()["error"]["errors"],
        150
    );
}

/// A limit on the size of files stands in for a full disk, which needs privileges to make.
#[test]
fn a_refused_write_keeps_what_was_written() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let demeter = env!("CARGO_BIN_EXE_demeter");
    // 16 blocks of 512 or 1024 bytes, after which a write fails
    let script = format!("ulimit -f 16; exec '{demeter}' run fall.toml --out full --set output.series='\"20 us\"'");
    let mut command = Command::new("bash");
    let output = command
        .args(["-c", &script])
        .current_dir(place.path(""))
        .output()
        .unwrap();
    let err = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{err}");
    let last = err.lines().last().unwrap();
    assert!(
        last.starts_with("error: cannot") && last.contains("full/") && last.contains("choose another disk"),
        "{err}"
    );
    let series = fs::read_to_string(place.path("full/series.csv")).unwrap();
    assert!(series.starts_with("step,time [s]") && series.ends_with('\n') && series.lines().count() > 1);
    assert!(place.path("full/scenario.toml").is_file());
}

#[test]
fn a_series_that_goes_while_the_run_goes_on_is_told() {
    let place = Place::new();
    place.write("fall.toml", FALL);
    let mut run = place.command(&["run", "fall.toml", "--out", "lost"]);
    let child = run.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    while !place.path("lost/checkpoint.latest").exists() {
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    fs::remove_file(place.path("lost/series.csv")).unwrap();
    let output = child.wait_with_output().unwrap();
    let told = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(
        told.contains("series.csv") && told.contains("Something else removed"),
        "{told}"
    );
    assert!(!told.contains("defect"), "{told}");
    let said = place.expect(2, &["resume", "lost"]);
    assert!(said.err.contains("Put the file back"), "{}", said.err);
}

#[test]
fn a_reader_that_goes_away_is_no_fault() {
    let place = Place::new();
    for arguments in [&["laws"][..], &["new"], &["laws", "epsd", "--json"], &["--help"]] {
        let mut child = place
            .command(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), err.as_str()), (Some(0), ""), "{arguments:?}");
    }
}

/// A grain between a floor that shakes and a lid that a servo presses on it.
const LID: &str = r#"
[simulation]
max_overlap = 0.3

[material.soft]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "2500 kg/m^3"

[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }

[[grains]]
material = "soft"
source = "list"
positions = ["0 0 2 mm"]
diameter = "4 mm"

[[wall]]
name = "floor"
material = "soft"
shape = "plane"
point = "0 0 0 mm"
normal = "z"
motion = { oscillation = { amplitude = "0 0 0.1 mm", frequency = "50 Hz" } }

[[wall]]
name = "lid"
material = "soft"
shape = "plane"
point = "0 0 4.1 mm"
normal = "-z"
motion = { servo = { axis = "-z", force = "20 mN", max_speed = "10 mm/s" } }

[[stage]]
duration = "0.1 s"
[output]
frames = "never"
picture = false
report = false
"#;

#[test]
fn a_servo_that_is_too_slow_is_told() {
    let place = Place::new();
    place.write("lid.toml", LID);
    let run = ["run", "lid.toml", "--overwrite", "--out", "lid"];
    let told = "warning: the servo of wall `lid` was at its largest speed, 0.01 m/s";
    let said = place.expect(0, &run).err;
    assert!(said.contains(told), "{said}");
    let faster = ["--set", "wall.lid.motion.servo.max_speed=\"0.5 m/s\""];
    let said = place.expect(0, &[&run[..], &faster].concat()).err;
    assert!(!said.contains("the servo"), "{said}");
    // a lid that is still on its way
    let away = ["--set", "wall.lid.point=\"0 0 6 mm\""];
    let said = place.expect(0, &[&run[..], &away].concat()).err;
    assert!(
        said.contains("warning: the servo of wall `lid` has not pressed yet"),
        "{said}"
    );
    // unless less is asked for, and came
    let touches = "stage[0].stop.wall_force={ wall = \"lid\", direction = \"z\", above = \"1 mN\" }";
    let said = place.expect(0, &[&run[..], &["--set", touches]].concat()).err;
    assert!(said.contains("1 mN was asked") && !said.contains("the servo"), "{said}");
}

/// A grain alone in a periodic box that is to have a stress.
const STRETCHED: &str = r#"
[domain]
lower = "0 0 0 mm"
upper = "20 20 20 mm"
periodic = ["x", "y", "z"]

[material.soft]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "2500 kg/m^3"

[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }

[[grains]]
material = "soft"
source = "list"
positions = ["10 10 10 mm"]
diameter = "4 mm"

[[stage]]
duration = "5 ms"
deform = { y = { stress = "2 kPa", max_rate = "1 1/s" } }
[output]
frames = "never"
picture = false
report = false
"#;

#[test]
fn a_box_that_does_not_come_to_its_stress_is_told() {
    let place = Place::new();
    place.write("box.toml", STRETCHED);
    let run = ["run", "box.toml", "--overwrite", "--out", "box"];
    let said = place.expect(0, &run).err;
    let told = "warning: the stress of the box along y has not come yet to what it is told, 2e3 Pa: it is on its way, at 1 1/s at most";
    assert!(said.contains(told), "{said}");
    // where the stage waits for less, that came
    let awaited = [
        "--set",
        "stage[0].stop.box_stress={ direction = \"y\", above = \"0 Pa\" }",
    ];
    let said = place.expect(0, &[&run[..], &awaited].concat()).err;
    assert!(
        said.contains("0e0 Pa was asked") && !said.contains("not come yet"),
        "{said}"
    );
    // not where it waits for another stress
    let other = [
        "--set",
        "stage[0].stop.box_stress={ direction = \"x\", above = \"0 Pa\" }",
    ];
    let said = place.expect(0, &[&run[..], &other].concat()).err;
    assert!(said.contains(told), "{said}");
    let free = ["--set", "stage[0].deform.y.stress=\"0 Pa\""];
    let said = place.expect(0, &[&run[..], &free].concat()).err;
    assert!(!said.contains("the stress of the box"), "{said}");
    let sheared = |stress: &str| {
        let shear = format!("{{ flow = \"x\", gradient = \"y\", stress = \"{stress}\", max_rate = \"1 1/s\" }}");
        let set = ["--set", &format!("stage[0].deform={{ shear = {shear} }}")];
        place.expect(0, &[&run[..], &set].concat()).err
    };
    let said = sheared("2 kPa");
    let told = "warning: the stress of the box in shear has not come yet to what it is told, 2e3 Pa: it is on its way, at 1 1/s at most";
    assert!(said.contains(told), "{said}");
    let said = sheared("0 Pa");
    assert!(!said.contains("the stress of the box"), "{said}");
}
