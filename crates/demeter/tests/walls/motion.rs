//! Equipment in motion: mixers, flaps, presses, shear cells, covers that vanish; what they do, and that the books close.

mod bodies;
mod giving_way;

use crate::cases::beds::bed;
use crate::cases::{Case, G, Laws, on_threads, one_material, report};
use demeter::particles::Outside;
use demeter::scenario::{Observer, Progress, Report, RunEnd, RunError, RunOptions, Scenario, prepare, resume, run};
use demeter::simulation::Simulation;
use demeter::walls::{FreeMotion, Freedom, Motion, Shape};
use demeter_physics::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

struct Silent;

impl Observer for Silent {
    fn progress(&mut self, _: &Progress) -> bool {
        true
    }

    fn message(&mut self, _: &str) {}
}

const HEAD: &str = r#"
[simulation]
gravity = "0 0 -9.81 m/s^2"
max_overlap = 0.1
[domain]
lower = "-60 -60 -60 mm"
upper = "60 60 60 mm"
outside = "remove"
[material.steel]
young_modulus = "10 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"
[contact]
normal = { law = "hertz-tsuji", restitution = 0.7 }
tangential = { law = "coulomb", friction = 0.3 }
[output]
series = "1 ms"
frames = "never"
picture = false
[[wall]]
name = "floor"
material = "steel"
shape = "plane"
point = "0 0 0 mm"
normal = "z"
"#;

/// A cylinder of 10 mm with a lattice of grains of 3 mm.
const VESSEL: &str = r#"
[[wall]]
name = "vessel"
material = "steel"
shape = "cylinder"
start = "0 0 -5 mm"
end = "0 0 50 mm"
radius = "10 mm"
[[grains]]
material = "steel"
source = "lattice"
lattice = "simple-cubic"
spacing = "3.3 mm"
region = { shape = "cylinder", start = "0 0 2 mm", end = "0 0 11 mm", radius = "8 mm" }
diameter = "3 mm"
"#;

fn parse(text: &str) -> Scenario {
    match Scenario::parse(&format!("{HEAD}{text}"), "case", Path::new(""), &[]) {
        Ok(scenario) => scenario,
        Err(faults) => panic!("{}", faults.render(false)),
    }
}

fn try_in(scenario: &Scenario, folder: &Path, threads: usize) -> Result<Report, RunError> {
    let options = RunOptions {
        threads: Some(threads),
        ..RunOptions::default()
    };
    run(scenario, folder, options, &mut Silent)
}

/// Runs to the end; the series by its titles.
fn series_of(text: &str) -> BTreeMap<String, Vec<f64>> {
    let place = tempfile::tempdir().unwrap();
    let done = try_in(&parse(text), &place.path().join("run"), 1).unwrap();
    assert_eq!(done.end, RunEnd::Finished, "{done:?}");
    let mut reader = csv::Reader::from_path(place.path().join("run/series.csv")).unwrap();
    let titles: Vec<String> = reader.headers().unwrap().iter().map(String::from).collect();
    let mut columns: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for record in reader.records() {
        for (title, cell) in titles.iter().zip(record.unwrap().iter()) {
            columns
                .entry(title.clone())
                .or_default()
                .push(cell.parse().unwrap_or(f64::NAN));
        }
    }
    columns
}

fn assert_books_close(what: &str, series: &BTreeMap<String, Vec<f64>>) {
    let residual = series["energy residual"].iter().fold(0.0f64, |m, r| m.max(r.abs()));
    report(&format!("largest residual of {what}"), residual);
    assert!(residual < 1e-3, "residual {residual}");
}

/// The grains of the vessel above its tools.
fn falling() -> String {
    VESSEL
        .replace("0 0 2 mm", "0 0 15 mm")
        .replace("0 0 11 mm", "0 0 24 mm")
}

const MIXER: &str = r#"
[[wall]]
name = "blade"
material = "steel"
shape = "mesh"
stress = true
wear = { sliding = "1e-13 1/Pa", impact = "1e-12 1/Pa" }
triangles = [
  [["2.5 mm", "-0.5 mm", "4 mm"], ["6.5 mm", "-0.5 mm", "4 mm"], ["6.5 mm", "0.5 mm", "12 mm"]],
  [["2.5 mm", "-0.5 mm", "4 mm"], ["6.5 mm", "0.5 mm", "12 mm"], ["2.5 mm", "0.5 mm", "12 mm"]],
]
motion = [
  { rotation = { point = "0 0 0 mm", axis = "z", angular_velocity = "120 rpm" }, start_over = "30 ms" },
  { rotation = { point = "4.5 0 0 mm", axis = "z", angular_velocity = "-400 rpm" }, start_over = "30 ms" },
]
"#;

#[test]
fn a_planetary_mixer_closes_the_books() {
    let stage = "[[stage]]\nduration = \"0.15 s\"\n";
    let series = series_of(&format!("{}{MIXER}{stage}", falling()));
    assert_books_close("a planetary mixer", &series);
    let last = |title: &str| *series[title].last().unwrap();
    assert!(last("wall work [J]") > 1e-6, "{}", last("wall work [J]"));
    // the power of the one wall that moves is the rate of the work
    let power: f64 = series["wall blade power [W]"].iter().sum::<f64>() * 1e-3;
    assert!((power / last("wall work [J]") - 1.0).abs() < 0.3, "{power}");
    // both rotations lag by half of the time in which they start, and more than half a turn is less the other way round
    let rate = -280.0 / 60.0 * TAU;
    assert!((last("wall blade angular velocity z [rad/s]") / rate - 1.0).abs() < 1e-9);
    assert!((last("wall blade turn z [rad]") - (rate * 0.135 + TAU)).abs() < 1e-3);
    assert!(last("wall blade sliding energy [J]") > 0.0 && last("wall blade impact energy [J]") > 0.0);
}

const FLAP: &str = r#"
[[grains]]
material = "steel"
source = "lattice"
lattice = "simple-cubic"
spacing = "3.3 mm"
region = { shape = "box", lower = "-8 -8 30 mm", upper = "8 8 50 mm" }
diameter = "3 mm"
velocity = "0 0 -0.5 m/s"
[[wall]]
name = "flap"
material = "steel"
shape = "rectangle"
center = "0 0 15 mm"
half_u = "12 0 0 mm"
half_v = "0 12 0 mm"
[wall.motion.hinge]
point = "-12 0 15 mm"
axis = "y"
mass = "5 g"
center_of_mass = "0 0 15 mm"
inertia = "1e-6 kg m^2"
spring = "1e-2 N m/rad"
damper = "1e-5 N m s/rad"
stops = ["-60 deg", "80 deg"]
[[stage]]
duration = "0.2 s"
"#;

#[test]
fn a_flap_that_grains_fall_on_closes_the_books() {
    let series = series_of(FLAP);
    assert_books_close("a flap", &series);
    let extreme = |title: &str| series[title].iter().fold(0.0f64, |m, x| m.max(x.abs()));
    // it gave way, the damper worked, and no drive did anything
    assert!(extreme("wall flap displacement z [m]") > 2e-3);
    assert!(extreme("free wall energy [J]") > 1e-5 && extreme("wall dissipation [J]") > 1e-7);
    assert!(extreme("wall work [J]") < 1e-6 * extreme("gravitational energy [J]"));
}

#[test]
fn the_time_step_follows_from_the_mass_of_a_light_free_wall() {
    let scale = |text: &str| prepare(&parse(text)).unwrap().time_scale;
    let heavy = scale(FLAP);
    assert!(!heavy.origin.contains("gives way"), "{}", heavy.origin);
    let light = scale(
        &FLAP
            .replace("mass = \"5 g\"", "mass = \"5 mg\"")
            .replace("inertia = \"1e-6", "inertia = \"1e-9"),
    );
    assert!(light.origin.contains("gives way as"), "{}", light.origin);
    assert!(light.time < heavy.time, "{} {}", light.time, heavy.time);
}

#[test]
fn a_weight_that_falls_on_a_bed_rests_on_it() {
    let lid = r#"
[[wall]]
name = "lid"
material = "steel"
shape = "disc"
center = "0 0 12 mm"
normal = "-z"
radius = "9.5 mm"
motion = [
  { free = { axis = "z", mass = "20 g", damper = "2 N s/m" } },
  { rotation = { point = "0 0 0 mm", axis = "z", angular_velocity = "20 rpm" } },
]
[[stage]]
duration = "0.25 s"
"#;
    let series = series_of(&format!("{VESSEL}{lid}"));
    assert_books_close("a weight", &series);
    let force = &series["wall lid force z [N]"];
    let tail = &force[force.len() - 100..];
    let mean = tail.iter().sum::<f64>() / 100.0;
    assert!((mean / (0.02 * 9.81) - 1.0).abs() < 0.02, "{mean}");
}

#[test]
fn a_pendulum_swings_with_its_period_in_a_run() {
    on_threads(1, || {
        let mut case = Case::new(one_material(5e6, &Laws::hertz(0.9)));
        case.gravity = DVec3::Z * -G;
        // a grain that falls out of the domain
        case.grain(1e-3, DVec3::new(0.5, 0.5, 0.5), DVec3::ZERO);
        case.domain.outside = Outside::Remove;
        let (long, mass, start) = (0.2, 0.3, 0.2f64);
        let arm = DVec3::new(libm::sin(start), 0.0, -libm::cos(start)) * (0.5 * long);
        let hinge = FreeMotion {
            freedom: Freedom::Hinge {
                point: DVec3::ZERO,
                axis: -DVec3::Y,
                center_of_mass: arm,
            },
            inertia: mass * long * long / 3.0,
            weight: DVec3::Z * (-mass * G),
            stiffness: 0.0,
            damping: 0.0,
            speed: 0.0,
            stops: [f64::NEG_INFINITY, f64::INFINITY],
        };
        let shape = Shape::Rectangle {
            center: arm,
            half_u: arm,
            half_v: DVec3::Y * 0.05,
        };
        case.wall(0, shape, Motion::Free(hinge));
        let mut sim = case.simulation();
        sim.set_dt(1e-4).unwrap();
        // T = 2 pi sqrt(2 L/(3 g)) (1 + start^2/16 + 11 start^4/3072)
        let period = 2.0
            * std::f64::consts::PI
            * libm::sqrt(2.0 * long / 3.0 / G)
            * (1.0 + start * start / 16.0 + 11.0 * start * start * start * start / 3072.0);
        let (mut before, mut turned) = (f64::NAN, Vec::new());
        for _ in 0..30_000 {
            sim.step().unwrap();
            let spin = sim.walls[0].angular_velocity().y;
            if before < 0.0 && spin >= 0.0 || before > 0.0 && spin <= 0.0 {
                turned.push(sim.time() - sim.dt() * spin / (spin - before));
            }
            before = spin;
        }
        let swings = turned.len() - 1;
        let found = 2.0 * (turned[swings] - turned[0]) / swings as f64;
        assert!(swings > 5 && (found / period - 1.0).abs() < 1e-5, "{found} {period}");
        assert!(sim.walls[0].energy().abs() < 1e-6, "{}", sim.walls[0].energy());
    });
}

#[test]
fn a_torque_servo_reaches_its_torque() {
    on_threads(1, || {
        let mut case = Case::new(one_material(5e6, &Laws::hertz(0.3)));
        // a vane about z pushes a grain into a corner
        let r = 2e-3;
        case.grain(r, DVec3::new(0.02, r, 0.0), DVec3::ZERO);
        case.plane(0, DVec3::new(0.0, 2.0 * r, 0.0), -DVec3::Y);
        case.plane(0, DVec3::new(0.02 - r, 0.0, 0.0), DVec3::X);
        let vane = Shape::Rectangle {
            center: DVec3::new(0.015, -2e-4, 0.0),
            half_u: DVec3::X * 0.015,
            half_v: DVec3::Z * 0.01,
        };
        let servo = Motion::TorqueServo {
            point: DVec3::ZERO,
            axis: DVec3::Z,
            torque: 2e-4,
            max_speed: 2.0,
        };
        case.wall(0, vane, servo);
        let mut sim = case.simulation();
        for _ in 0..60_000 {
            sim.step().unwrap();
        }
        let wall = &sim.walls[2];
        let (force, torque) = wall.load();
        let on_wall = (torque + wall.origin().cross(force)).z;
        let turned = wall.pose().rotation.z * 2.0;
        assert!((on_wall / -2e-4 - 1.0).abs() < 1e-3, "{on_wall} at {turned}");
    });
}

const CELL: &str = r#"
[[wall]]
name = "lid"
material = "steel"
shape = "disc"
center = "0 0 24 mm"
normal = "-z"
radius = "9.5 mm"
motion = { servo = { axis = "-z", force = "0.5 N", max_speed = "200 mm/s" } }
[[stage]]
name = "settle"
duration = "0.1 s"
[[stage]]
name = "shear"
duration = "0.12 s"
motion = { lid = [
  { servo = { axis = "-z", force = "0.5 N", max_speed = "50 mm/s" } },
  { rotation = { point = "0 0 0 mm", axis = "z", angular_velocity = "15 rpm" }, start_over = "20 ms" },
] }
"#;

/// Grains that fall into the vessel at random.
fn random() -> String {
    let lattice = VESSEL.find("source =").map_or("", |at| &VESSEL[at..]);
    let random = r#"source = "random"
region = { shape = "cylinder", start = "0 0 1.6 mm", end = "0 0 22 mm", radius = "9.8 mm" }
diameter = "3 mm"
count = 60
"#;
    VESSEL.replace(lattice, random)
}

#[test]
fn a_shear_cell_holds_its_normal_load_while_it_turns() {
    let series = series_of(&format!("{}{CELL}", random()));
    assert_books_close("a shear cell", &series);
    let force = &series["wall lid force z [N]"];
    let sheared = &force[force.len() - 90..];
    let mean = sheared.iter().sum::<f64>() / 90.0;
    assert!((mean / 0.5 - 1.0).abs() < 0.02, "{mean}");
    let torque = &series["wall lid torque z [N m]"];
    let mean = torque[torque.len() - 90..].iter().sum::<f64>() / 90.0;
    // friction of 0.3 at some radius below that of the lid
    assert!((-0.3 * 0.5 * 0.0095..-0.02 * 0.5 * 0.0095).contains(&mean), "{mean}");
}

/// Two punches in a die: the upper moves down to a force, then both hold it by force, then the upper goes up.
const PRESS: &str = r#"
[[wall]]
name = "upper"
material = "steel"
shape = "disc"
center = "0 0 12 mm"
normal = "-z"
radius = "9.5 mm"
[[wall]]
name = "collar"
material = "steel"
shape = "cylinder"
start = "0 0 12 mm"
end = "0 0 30 mm"
radius = "9.5 mm"
side = "outside"
motion = { with = "upper" }
[[wall]]
name = "lower"
material = "steel"
shape = "disc"
center = "0 0 0.5 mm"
normal = "z"
radius = "9.5 mm"
[[stage]]
name = "fill"
duration = "0.1 s"
[[stage]]
name = "compress"
duration = "1 s"
motion = { upper = { velocity = "0 0 -30 mm/s" } }
stop = { wall_force = { wall = "upper", direction = "z", above = "1 N" } }
[[stage]]
name = "dwell"
duration = "0.05 s"
motion = { upper = { servo = { axis = "-z", force = "1 N", max_speed = "10 mm/s" } }, lower = { servo = { axis = "z", force = "1.02 N", max_speed = "10 mm/s" } } }
[[stage]]
name = "unload"
duration = "0.05 s"
motion = { upper = { velocity = "0 0 30 mm/s", start_over = "5 ms" }, lower = "rest" }
"#;

#[test]
fn a_tablet_press_reaches_its_force_holds_it_and_lets_go() {
    let place = tempfile::tempdir().unwrap();
    let done = try_in(&parse(&format!("{VESSEL}{PRESS}")), &place.path().join("run"), 1).unwrap();
    assert_eq!(done.end, RunEnd::Finished);
    let summary = fs::read_to_string(place.path().join("run/summary.json")).unwrap();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap();
    let ended = |stage: usize| summary["stages"][stage]["ended_by"].as_str().unwrap().to_owned();
    assert!(ended(1).contains("the force on wall `upper` is 1."), "{}", ended(1));
    let series = series_of(&format!("{VESSEL}{PRESS}"));
    assert_books_close("a press", &series);
    let upper = &series["wall upper force z [N]"];
    let (before, after) = (upper.len() - 52, upper.len() - 1);
    assert!((upper[before - 5] / 1.0 - 1.0).abs() < 0.01, "{}", upper[before - 5]);
    let lower = series["wall lower force z [N]"][before - 5];
    assert!((lower / -1.02 - 1.0).abs() < 0.01, "{lower}");
    assert_eq!(upper[after], 0.0);
    // the collar came along
    let way = |wall: &str| series[&format!("wall {wall} displacement z [m]")].clone();
    assert_eq!(way("upper"), way("collar"));
}

const COVER: &str = r#"
[[grains]]
material = "steel"
source = "list"
positions = ["0 0 32 mm", "6 0 32 mm"]
diameter = "4 mm"
[[wall]]
name = "cover"
material = "steel"
shape = "disc"
center = "0 0 30 mm"
normal = "z"
radius = "10 mm"
[[stage]]
name = "rest"
duration = "50 ms"
[[stage]]
name = "open"
duration = "60 ms"
absent = ["cover"]
"#;

#[test]
fn a_cover_vanishes_at_once_and_its_books_close() {
    let series = series_of(COVER);
    assert_books_close("a cover", &series);
    let force = &series["wall cover force z [N]"];
    assert!(force[40] < 0.0 && *force.last().unwrap() == 0.0);
    assert!(*series["removed energy [J]"].last().unwrap() > 0.0);
    // both fall freely from rest for 60 ms
    let speed = *series["max speed [m/s]"].last().unwrap();
    assert!((speed / (9.81 * 0.06) - 1.0).abs() < 0.02, "{speed}");
}

#[test]
fn a_wall_does_not_come_where_a_grain_is() {
    let comes = COVER
        .replace("absent = [\"cover\"]", "")
        .replace("name = \"rest\"", "name = \"rest\"\nabsent = [\"cover\"]");
    let fall = comes.replace("duration = \"50 ms\"", "duration = \"1 ms\"") + "absent = []\n";
    let disc = "shape = \"disc\"\ncenter = \"0 0 30 mm\"\nnormal = \"z\"\nradius = \"10 mm\"";
    // they lie wholly within
    let shaft =
        "shape = \"cylinder\"\nstart = \"0 0 0 mm\"\nend = \"0 0 60 mm\"\nradius = \"20 mm\"\nside = \"outside\"";
    let place = tempfile::tempdir().unwrap();
    for (k, text) in [fall.clone(), fall.replace(disc, shaft)].iter().enumerate() {
        let end = try_in(&parse(text), &place.path().join(k.to_string()), 1).unwrap().end;
        let RunEnd::Fault(fault) = end else { panic!("{end:?}") };
        let named = "stage `open`: wall `cover` cannot come: grain 1 at";
        assert!(fault.to_string().contains(named) && fault.grain() == 1, "{fault}");
    }
    // later both are below it
    let free = comes.replace("duration = \"50 ms\"", "duration = \"90 ms\"") + "absent = []\n";
    try_in(&parse(&free), &place.path().join("free"), 1).unwrap();
}

/// Everything at once, for restarts and threads.
fn everything() -> String {
    let lid = r#"
[[wall]]
name = "lid"
material = "steel"
shape = "disc"
center = "0 0 32 mm"
normal = "-z"
radius = "9.5 mm"
motion = [
  { free = { axis = "z", mass = "5 g", damper = "0.1 N s/m", stops = ["-8 mm", "1 mm"] } },
  { rocking = { point = "0 0 0 mm", axis = "z", amplitude = "20 deg", frequency = "20 Hz" } },
]
[[wall]]
name = "rim"
material = "steel"
shape = "cylinder"
start = "0 0 32 mm"
end = "0 0 35 mm"
radius = "9.5 mm"
side = "outside"
motion = { with = "lid" }
[[stage]]
name = "a"
duration = "30 ms"
output = { frames = "9 ms", checkpoints = "20 ms" }
[[stage]]
name = "b"
duration = "30 ms"
output = { frames = "9 ms", checkpoints = "never" }
absent = ["blade"]
motion = { lid = { servo = { axis = "-z", force = "0.5 N", max_speed = "100 mm/s" } }, floor = { oscillation = { amplitude = "0 0 0.1 mm", frequency = "50 Hz" } } }
"#;
    format!("{}{MIXER}{lid}", falling())
}

/// The results of a run, file by file.
fn results(folder: &Path) -> Vec<Vec<u8>> {
    let mut files: Vec<_> = (fs::read_dir(folder.join("frames")).unwrap())
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "vtp"))
        .collect();
    files.sort();
    files.push(folder.join("series.csv"));
    files.iter().map(|file| fs::read(file).unwrap()).collect()
}

#[test]
fn threads_and_restarts_change_no_bit() {
    let place = tempfile::tempdir().unwrap();
    let scenario = parse(&everything());
    let folder = |name: &str| place.path().join(name);
    try_in(&scenario, &folder("one"), 1).unwrap();
    try_in(&scenario, &folder("three"), 3).unwrap();
    let whole = results(&folder("one"));
    let frames = whole.iter().map(|bytes| String::from_utf8_lossy(bytes));
    let recorded = frames.filter(|text| {
        [
            "mean_force",
            "pressure",
            "shear_stress",
            "impact_energy",
            "sliding_energy",
            "worn_volume",
            "wear_depth",
        ]
        .iter()
        .all(|name| text.contains(&format!("Name=\"{name}\"")))
    });
    assert!(recorded.count() > 5);
    assert!(whole == results(&folder("three")));
    // the checkpoint before that of the end is from the middle of the first stage
    fs::remove_file(folder("one").join("checkpoint.latest")).unwrap();
    let options = RunOptions::default();
    resume(&folder("one"), options, &mut Silent).unwrap();
    assert!(whole == results(&folder("one")), "after a restart");
}

#[test]
fn a_mesh_that_turns_loses_no_contact() {
    let mut sim = Simulation::new(bed("drum", 80));
    let mut seen = 0;
    for step in 0..40_000 {
        sim.step().unwrap();
        let mut in_table = BTreeMap::new();
        for chunk in &sim.contacts.walls {
            for k in 0..chunk.len() {
                let key = (chunk.i[k], chunk.j[k], chunk.element(k));
                in_table.insert(key, sim.contact(chunk, k).overlap);
            }
        }
        // whatever the wall is asked as a whole is in the table, with the same overlap
        for g in 0..sim.grains().len() {
            let radius = sim.grains().radius(g);
            let mut touched = vec![];
            sim.walls[0].contacts(sim.grains().position[g], (radius, 0.0), &mut touched);
            for part in &touched {
                let overlap = in_table.get(&(g as u32, 0, part.element));
                assert_eq!(overlap, Some(&(radius - part.distance)), "step {step}, grain {g}");
            }
            seen += touched.len();
        }
    }
    assert!(seen > 10_000, "{seen} contacts");
}
