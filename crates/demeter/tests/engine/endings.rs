//! What is told before a run begins and at its end: unstable springs, books that do not close, what found no room, what left, and
//! what cannot be done in the state that a run has come to.

use crate::exchange::{HEAD, last, parse, run_in, series, watcher};
use demeter::contacts::Fault;
use demeter::scenario::{LiveRun, Report, RunEnd, RunError, RunOptions, Until, prepare, resume};
use demeter::simulation::Simulation;
use glam::DVec3;
use std::fs;

/// Runs a scenario on one thread, and answers with what it came to, what was told and what the log holds.
fn ended(text: &str) -> (Report, Vec<String>, String) {
    let place = tempfile::tempdir().unwrap();
    let mut watcher = watcher();
    let report = run_in(&parse(text), place.path(), 1, &mut watcher);
    let log = fs::read_to_string(place.path().join("log.txt")).unwrap();
    assert!(place.path().join("summary.json").is_file());
    (report, watcher.messages, log)
}

fn assert_told(told: &[String], log: &str, words: &str) {
    assert!(told.iter().any(|text| text.contains(words)), "{words}: {told:?}");
    assert!(log.contains(words), "{words}: {log}");
}

/// A grain that touches nothing, and a plate that moves freely as told.
fn free_plate(motion: &str, simulation: &str) -> String {
    format!(
        r#"
[simulation]
{simulation}
[domain]
lower = "-30 -30 -30 mm"
upper = "30 30 30 mm"
[material.a]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"
[contact]
normal = {{ law = "hertz-tsuji", restitution = 0.8 }}
[[grains]]
material = "a"
source = "list"
positions = ["0 0 20 mm"]
diameter = "2 mm"
[[wall]]
name = "w"
material = "a"
shape = "rectangle"
center = "0 0 0 m"
half_u = "5 0 0 mm"
half_v = "0 5 0 mm"
motion = {motion}
[[stage]]
duration = "20 us"
[output]
series = "1 us"
frames = "never"
picture = false
report = false
"#
    )
}

const SPRING: &str = r#"{ free = { axis = "z", mass = "1 g", spring = "1e11 N/m", speed = "0.01 m/s" } }"#;
const DAMPER: &str = r#"{ free = { axis = "z", mass = "1 g", damper = "2 kN s/m", speed = "0.01 m/s" } }"#;
const HINGE: &str = r#"{ hinge = { point = "-5 0 0 mm", axis = "y", mass = "1 g", center_of_mass = "0 0 0 m",
    inertia = "1e-7 kg m^2", damper = "1 N m s/rad", angular_velocity = "1 rad/s" } }"#;

#[test]
fn the_time_step_follows_springs_and_dampers_of_free_walls() {
    let tau = std::f64::consts::TAU;
    let cases = [
        (
            SPRING,
            tau * (1e-3f64 / 1e11).sqrt(),
            "oscillation of wall `w` on its spring",
        ),
        (DAMPER, tau * 1e-3 / 2e3, "decay of wall `w` on its damper"),
        (HINGE, tau * 1e-7, "decay of wall `w` on its damper"),
    ];
    for (motion, time, origin) in cases {
        let motion = motion.replace('\n', " ");
        let prepared = prepare(&parse(&free_plate(&motion, ""))).unwrap();
        assert!(
            (prepared.time_scale.time / time - 1.0).abs() < 1e-9,
            "{:?}",
            prepared.time_scale
        );
        assert_eq!(prepared.time_scale.origin, origin);
        let unstable = free_plate(&motion, "time_step = \"1 us\"");
        let faults = prepare(&parse(&unstable)).unwrap_err().render(false);
        assert!(
            faults.contains("the time step is unsafe") && faults.contains(origin),
            "{faults}"
        );
    }
    // what an automatic time step was chosen for closes its books
    for motion in [SPRING, DAMPER] {
        let (report, _, _) = ended(
            &free_plate(motion, "")
                .replace("20 us", "0.2 us")
                .replace("1 us", "10 ns"),
        );
        assert_eq!(report.end, RunEnd::Finished);
        assert!(
            report.summary.energies.max_residual < 1e-3,
            "{:?}",
            report.summary.energies
        );
    }
}

#[test]
fn a_stage_that_is_shorter_than_a_step_is_told() {
    let text = |duration: &str| {
        let text = free_plate("\"rest\"", "").replace("motion = \"rest\"", "");
        text.replace("20 us", duration)
    };
    let warns = |duration: &str| {
        let prepared = prepare(&parse(&text(duration))).unwrap();
        let dt = prepared.setup.dt;
        let told = |warning: &String| warning.contains("less than a time step") && warning.contains("takes one step");
        (dt, prepared.warnings.iter().any(told))
    };
    let (dt, is_told) = warns("20 us");
    assert!(dt < 20e-6 && !is_told, "{dt}");
    assert!(warns(&format!("{:e} s", 0.5 * dt)).1);
    assert!(!warns(&format!("{dt:e} s")).1);
}

#[test]
fn a_wall_at_no_finite_place_ends_the_run() {
    let unstable = "time_step = \"1 us\"\nallow_unsafe_time_step = true";
    let (report, told, log) = ended(&free_plate(SPRING, unstable).replace("20 us", "2 ms"));
    let RunEnd::Fault(Fault::WallNotFinite { wall, .. }) = &report.end else {
        panic!("{:?}", report.end);
    };
    assert_eq!(wall, "w");
    assert_told(&told, &log, "of wall `w` is not a finite number");
}

#[test]
fn a_residual_that_is_no_number_is_not_told_as_zero() {
    let mut sim = Simulation::new(
        prepare(&parse(&free_plate("\"rest\"", "").replace("motion = \"rest\"", "")))
            .unwrap()
            .setup,
    );
    sim.start().unwrap();
    assert_eq!(sim.energies().residual, 0.0);
    sim.grains_mut().velocity[0] = DVec3::splat(f64::NAN);
    assert!(sim.energies().residual.is_nan());
}

#[test]
fn the_books_of_a_box_that_begins_to_deform_close_before_grains_meet() {
    let text = r#"
[simulation]
max_overlap = 0.1
[material.glass]
young_modulus = "5 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }
[domain]
lower = "0 0 0 mm"
upper = "14 14 14 mm"
periodic = ["x", "y", "z"]
deform = { x = { strain_rate = "-10 1/s" } }
[[grains]]
material = "glass"
source = "random"
region = { shape = "box", lower = "0 0 0 mm", upper = "14 14 14 mm" }
diameter = "2 mm"
count = 150
[output]
series = "0.05 ms"
picture = false
report = false
frames = "never"
[[stage]]
duration = "0.5 ms"
"#;
    let (report, told, _) = ended(text);
    let energies = &report.summary.energies;
    assert!(energies.max_residual < 1e-3, "{energies:?}");
    assert!(told.iter().all(|text| !text.contains("books")), "{told:?}");
    assert!(report.summary.warnings.is_empty(), "{:?}", report.summary.warnings);
}

#[test]
fn books_that_do_not_close_are_told_at_the_end() {
    let text = r#"
[simulation]
time_step = "40 us"
allow_unsafe_time_step = true
max_overlap = 0.4
[domain]
lower = "-10 -10 -10 mm"
upper = "10 10 10 mm"
[material.a]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.5 }
[[grains]]
material = "a"
source = "list"
positions = ["-1.5 0 0 mm"]
velocity = "0.5 0 0 m/s"
diameter = "2 mm"
[[grains]]
material = "a"
source = "list"
positions = ["1.5 0 0 mm"]
diameter = "2 mm"
[[stage]]
duration = "4 ms"
[output]
series = "40 us"
frames = "never"
picture = false
report = false
"#;
    let (report, told, log) = ended(text);
    let words = "the energy books do not close";
    assert!(
        report.summary.energies.max_residual > 1e-3,
        "{:?}",
        report.summary.energies
    );
    assert!(report.summary.warnings.iter().any(|text| text.contains(words)));
    assert_told(&told, &log, &format!("warning: {words}"));
}

/// A feed without a rate into a box above a floor, in two stages.
fn fed(feed: &str, stages: &str) -> String {
    format!(
        r#"{HEAD}
[domain]
lower = "-20 -20 -20 mm"
upper = "20 20 40 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 m"
normal = "z"
[[feed]]
name = "fd"
material = "seed"
diameter = "2 mm"
{feed}
{stages}
"#
    )
}

#[test]
fn a_feed_without_a_rate_that_finds_no_room_says_so_at_its_end() {
    let nowhere = "from = { shape = \"box\", lower = \"-11 -11 -19 mm\", upper = \"11 11 -6 mm\" }";
    let one = "[[stage]]\nname = \"a\"\nduration = \"4 ms\"";
    let (_, told, log) = ended(&fed(&format!("{nowhere}\ncount = 30"), one));
    assert_told(
        &told,
        &log,
        "warning: feed `fd` let 0 of 30 grains come until the end of stage `a`",
    );
    let (_, told, log) = ended(&fed(&format!("{nowhere}\nmass = \"1 g\""), one));
    assert_told(
        &told,
        &log,
        "warning: feed `fd` let 0 g of 1 g come until the end of stage `a`",
    );
    // in its last stage, and once
    let two = "[[stage]]\nname = \"a\"\nduration = \"4 ms\"\n[[stage]]\nname = \"b\"\nduration = \"4 ms\"";
    let (_, told, log) = ended(&fed(&format!("{nowhere}\ncount = 30"), two));
    assert_told(&told, &log, "until the end of stage `b`");
    assert!(!log.contains("until the end of stage `a`"), "{log}");
    let stopped = format!("{two}\nfeeds = []");
    let (_, told, log) = ended(&fed(&format!("{nowhere}\ncount = 30"), &stopped));
    assert_told(&told, &log, "until the end of stage `a`");
    assert!(!log.contains("until the end of stage `b`"), "{log}");
    let roomy = "from = { shape = \"box\", lower = \"-11 -11 9 mm\", upper = \"11 11 16 mm\" }\ncount = 3";
    let (_, told, _) = ended(&fed(roomy, one));
    assert!(told.iter().all(|text| !text.contains("warning")), "{told:?}");
    // 3 spheres of 4/3 pi mg
    let done = "feed `fd` is done: 3 grains, 12.5664 mg came";
    assert!(told.iter().any(|text| text.contains(done)), "{told:?}");
}

#[test]
fn what_left_the_domain_is_told_at_the_end() {
    let text = format!(
        r#"{HEAD}
[domain]
lower = "-20 -20 -2 mm"
upper = "20 20 40 mm"
outside = "remove"
[[grains]]
material = "seed"
source = "list"
positions = ["0 0 0 mm", "5 0 0 mm", "0 5 30 mm"]
diameter = "2 mm"
[[stage]]
duration = "40 ms"
"#
    );
    let (report, told, log) = ended(&text);
    assert_eq!((report.summary.grains, &report.end), (1, &RunEnd::Finished));
    // 2 spheres of 4/3 pi mg
    let words = "2 grains, 8.37758 mg left the domain and were removed";
    assert_told(&told, &log, words);
    assert!(report.summary.warnings.iter().any(|text| text.contains(words)));
    let place = tempfile::tempdir().unwrap();
    run_in(&parse(&text), place.path(), 1, &mut watcher());
    let of = |column| last(&series(place.path()), column);
    assert_eq!(of("domain lost grains"), 2.0);
    assert!((of("domain lost mass [kg]") / 8.38e-6 - 1.0).abs() < 1e-3);
}

#[test]
fn a_wall_that_cannot_come_later_ends_the_run_as_a_fault() {
    let text = format!(
        r#"{HEAD}
[domain]
lower = "-20 -20 -20 mm"
upper = "20 20 20 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 m"
normal = "z"
[[wall]]
name = "lid"
material = "seed"
shape = "rectangle"
center = "0 0 1.5 mm"
half_u = "8 0 0 mm"
half_v = "0 8 0 mm"
[[grains]]
material = "seed"
source = "list"
positions = ["0 0 1 mm"]
diameter = "2 mm"
[[stage]]
name = "a"
duration = "2 ms"
absent = ["lid"]
[[stage]]
name = "b"
duration = "2 ms"
absent = []
"#
    );
    let (report, told, log) = ended(&text);
    let RunEnd::Fault(fault @ Fault::CannotGoOn { id: 1, .. }) = &report.end else {
        panic!("{:?}", report.end);
    };
    assert!(
        fault.to_string().contains("stage `b`: wall `lid` cannot come: grain 1"),
        "{fault}"
    );
    assert_told(&told, &log, &format!("error: {fault}"));
    assert!(!report.summary.finished);
    assert_eq!(report.summary.stopped_by, fault.to_string());
}

/// The rows of the series were older, and after a restart there were none: energies of 0 were told.
#[test]
fn a_summary_tells_of_the_moment_of_a_fault() {
    let head = HEAD.replace("series = \"2 ms\"", "series = \"50 ms\"");
    let head = head.replace("checkpoints = \"10 ms\"", "checkpoints = \"1 ms\"");
    let text = format!(
        r#"{head}
[domain]
lower = "-20 -20 -2 mm"
upper = "20 20 40 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "plane"
point = "0 0 0 m"
normal = "z"
[[grains]]
material = "seed"
source = "list"
positions = ["0 0 0.999 mm", "0 0 2.997 mm"]
diameter = "2 mm"
[[grains]]
material = "seed"
source = "list"
positions = ["0 10 10 mm"]
velocity = "0 2 0 m/s"
diameter = "2 mm"
[[feed]]
name = "fd"
material = "seed"
diameter = "2 mm"
from = {{ shape = "box", lower = "-11 -11 29 mm", upper = "11 -5 36 mm" }}
count = 3
[[stage]]
duration = "20 ms"
"#
    );
    let place = tempfile::tempdir().unwrap();
    let report = run_in(&parse(&text), place.path(), 1, &mut watcher());
    assert!(
        matches!(&report.end, RunEnd::Fault(fault @ Fault::Outside { .. }) if fault.grain() == 3),
        "{:?}",
        report.end
    );
    let summary = report.summary;
    assert_eq!((summary.grains, summary.contacts), (6, 1));
    assert_eq!(summary.walls["floor"].contacts, 1);
    assert!(
        (4.9e-3..5.1e-3).contains(&summary.simulated_time),
        "{}",
        summary.simulated_time
    );
    let energies = summary.energies;
    // three spheres of 4/3 pi mg, dropped from 30 to 35 mm
    let dropped = 3.0 * 4.19e-6 * 9.81;
    assert!(
        (0.030 * dropped..0.035 * dropped).contains(&energies.ledger.inserted),
        "{energies:?}"
    );
    assert!(energies.ledger.residual.abs() < 1e-3, "{energies:?}");

    let resumed = resume(place.path(), RunOptions::default(), &mut watcher()).unwrap();
    assert_eq!(resumed.end, report.end);
    let resumed = resumed.summary;
    assert_eq!((resumed.energies, resumed.walls), (energies, summary.walls));
    assert_eq!((resumed.grains, resumed.contacts), (6, 1));
}

/// It was warned of, and the run told as if all was written.
#[test]
fn a_page_that_cannot_be_written_is_an_error() {
    let text = format!(
        "{HEAD}[domain]\nlower = \"-9 -9 -9 mm\"\nupper = \"9 9 9 mm\"\n[[grains]]\nmaterial = \"seed\"\nsource = \"list\"\n\
         positions = [\"0 0 0 mm\"]\ndiameter = \"2 mm\"\n[[stage]]\nduration = \"2 ms\"\n"
    );
    let place = tempfile::tempdir().unwrap();
    let (folder, mut watcher) = (place.path().join("run"), watcher());
    let mut run = LiveRun::new(parse(&text), Some(&folder), RunOptions::default(), &mut watcher).unwrap();
    let in_the_way = folder.join("report.html.part");
    fs::create_dir(&in_the_way).unwrap();
    let error = run.advance(&Until::default(), &mut watcher).unwrap_err().to_string();
    assert!(
        error.starts_with("cannot write `") && error.contains("report.html"),
        "{error}"
    );
    let told = watcher.messages.last().unwrap();
    assert!(told.contains("`demeter report"), "{told}");
    drop(run);
    // all else is there
    let again = resume(&folder, RunOptions::default(), &mut watcher).unwrap_err();
    assert!(matches!(again, RunError::Finished { .. }), "{again}");
    assert!(folder.join("summary.json").is_file());
    fs::remove_dir(in_the_way).unwrap();
    demeter::report::write(&folder).unwrap();
}

/// A grain on a square plate of the given half width, in a box of 40 mm that is periodic along x and y.
fn on_a_plate(half: f64) -> Vec<String> {
    let text = format!(
        r#"{HEAD}
[domain]
lower = "0 0 -10 mm"
upper = "40 40 40 mm"
periodic = ["x", "y"]
[[grains]]
material = "seed"
source = "list"
positions = ["30 7 2 mm"]
diameter = "4 mm"
[[wall]]
name = "floor"
material = "seed"
shape = "rectangle"
center = "20 20 0 mm"
half_u = "{half} 0 0 mm"
half_v = "0 30 0 mm"
[[stage]]
duration = "1 ms"
"#
    );
    prepare(&parse(&text)).unwrap().warnings
}

#[test]
fn a_wall_that_ends_between_a_periodic_side_and_a_grain_there_is_warned_of() {
    let warnings = on_a_plate(21.9);
    let [warning] = &warnings[..] else {
        panic!("{warnings:?}")
    };
    assert!(
        warning.contains("wall `floor`") && warning.contains("along x"),
        "{warning}"
    );
    // as long as the box it is repeated
    assert_eq!(on_a_plate(20.0), Vec::<String>::new());
    assert_eq!(on_a_plate(22.1), Vec::<String>::new());
}

#[test]
fn a_stage_that_waits_for_rest_ends_where_grains_stick() {
    let text = format!(
        r#"{STICKY}
[[stage]]
duration = "0.2 s"
stop = {{ kinetic_over_elastic = 1e-3 }}
"#
    );
    let (report, _, _) = ended(&text);
    let summary = &report.summary;
    assert!(summary.energies.ledger.elastic < 0.0, "{:?}", summary.energies);
    let why = &summary.stages[0].ended_by;
    assert!(why.contains("kinetic over elastic"), "{why}");
}

/// Two grains that stick to each other.
const STICKY: &str = r#"
[domain]
lower = "-10 -10 -10 mm"
upper = "10 10 10 mm"
[material.a]
young_modulus = "1 MPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"
[contact]
normal = { law = "jkr", work_of_adhesion = "0.1 N/m", alpha = 0.6 }
[[grains]]
material = "a"
source = "list"
positions = ["-0.999 0 0 mm", "0.999 0 0 mm"]
diameter = "2 mm"
[output]
frames = "never"
picture = false
report = false
"#;

#[test]
fn a_wall_that_went_into_fixed_grains_is_told() {
    let scene = |fixed: &str, speed: &str| {
        format!(
            r#"{HEAD}
[domain]
lower = "-20 -20 -20 mm"
upper = "20 20 20 mm"
[[grains]]
material = "seed"
source = "list"
positions = ["0 0 5 mm", "4 0 5 mm", "8 0 9 mm"]
diameter = "2 mm"
fixed = {fixed}
[[wall]]
name = "plate"
material = "seed"
shape = "plane"
point = "0 0 0 mm"
normal = "z"
motion = {{ velocity = "0 0 {speed}" }}
[[stage]]
name = "a"
duration = "10 ms"
"#
        )
    };
    // 4.5 mm: within two of the three
    let (_, told, log) = ended(&scene("true", "0.45 m/s"));
    assert_told(
        &told,
        &log,
        "wall `plate` has moved into 2 fixed grains, one of them grain 1",
    );
    for (fixed, speed) in [("true", "0.39 m/s"), ("false", "0.01 m/s")] {
        let (_, told, _) = ended(&scene(fixed, speed));
        assert!(told.iter().all(|text| !text.contains("fixed grains")), "{told:?}");
    }
}
