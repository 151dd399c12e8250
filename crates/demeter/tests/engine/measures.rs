//! Measures of packings whose contacts, forces and volumes are known by hand, and their files through a restart.

use crate::cases::{Case, Laws, law, one_material};
use crate::exchange::{parse, run_in, series, watcher};
use demeter::contacts::Coupling;
use demeter::materials::{Material, Materials};
use demeter::measure::{
    ContactAngles, ContactNetwork, FABRIC_COLUMNS, Fabric, ForceDistribution, Moment, Selection, Value,
    contact_records, measure,
};
use demeter::particles::{Domain, Origins, Outside, Zone, ZonePart, ZoneShape};
use demeter::scenario::{Observer, Progress, RunEnd, RunOptions, Scenario, resume, run};
use demeter::simulation::Simulation;
use demeter_physics::DVec3;
use std::f64::consts::PI;
use std::path::Path;
use std::time::Duration;

const RADIUS: f64 = 1e-3;
const STIFFNESS: f64 = 1000.0;

/// A simple cubic lattice of `n` layers, and its overlap as share of the radius.
struct Cubic {
    n: usize,
    overlap: f64,
    periodic: [bool; 3],
}

impl Cubic {
    fn spacing(&self) -> f64 {
        (2.0 - self.overlap) * RADIUS
    }

    /// At rest, with walls below and above the layers where z is not periodic.
    fn simulation(&self) -> Simulation {
        let mut case = Case::new(one_material(1e7, &Laws::linear(STIFFNESS, 1.0)));
        case.max_overlap = 0.2;
        let a = self.spacing();
        let length = self.n as f64 * a;
        let open = |axis: usize, outer: f64| if self.periodic[axis] { 0.0 } else { outer };
        let outer = DVec3::from_array([0, 1, 2].map(|axis| open(axis, 1e-2)));
        case.domain = Domain {
            lower: -outer,
            upper: DVec3::splat(length) + outer,
            periodic: self.periodic,
            outside: Outside::Stop,
        };
        for k in 0..self.n * self.n * self.n {
            let at = [k % self.n, k / self.n % self.n, k / (self.n * self.n)];
            case.grain(RADIUS, DVec3::from_array(at.map(|i| (i as f64 + 0.5) * a)), DVec3::ZERO);
        }
        if !self.periodic[2] {
            case.plane(0, DVec3::ZERO, DVec3::Z);
            case.plane(0, DVec3::new(0.0, 0.0, length), DVec3::NEG_Z);
        }
        let mut sim = case.simulation();
        sim.start().unwrap();
        sim
    }
}

fn near(found: f64, expected: f64) {
    within(1e-12, found, expected);
}

/// The same of what comes from forces of contacts, which are told in single precision.
fn near_in_singles(found: f64, expected: f64) {
    within(f64::from(f32::EPSILON), found, expected);
}

fn within(share: f64, found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < share, "{found}, expected {expected}");
}

#[test]
fn a_periodic_lattice_has_the_measures_of_its_cell() {
    let cubic = Cubic {
        n: 6,
        overlap: 0.02,
        periodic: [true; 3],
    };
    let (sim, a) = (cubic.simulation(), cubic.spacing());
    let ball = 4.0 / 3.0 * PI * RADIUS * RADIUS * RADIUS;
    let phi = ball / (a * a * a);
    let force = STIFFNESS * 0.02 * RADIUS;
    // any box that is whole cells long holds the same share of solid, wherever it cuts grains and periodic faces
    let corner = DVec3::new(-0.3, 0.2, 0.7) * a;
    let regions = [
        None,
        Some((DVec3::splat(0.1 * a), DVec3::splat(3.1 * a))),
        Some((
            DVec3::new(-9.0 * a, 0.35 * a, 0.0),
            DVec3::new(9.0 * a, 4.35 * a, 6.0 * a),
        )),
        Some((corner.max(DVec3::ZERO), corner.max(DVec3::ZERO) + a)),
    ];
    for region in regions {
        let network = ContactNetwork {
            region,
            ..ContactNetwork::default()
        };
        let found = network.measure(&sim);
        assert_eq!(found.contacts, 3 * 216);
        assert_eq!(found.coordination, 6.0);
        near_in_singles(found.mean_force, force);
        near(found.centre_distance, a);
        near(found.packing_fraction, phi);
        near_in_singles(found.scaling(), 6.0 * phi * a * force);
    }
}

/// Every grain of a cubic lattice has the same fabric, so every part of it must, too: contacts across its border are not to weigh more.
#[test]
fn a_part_of_a_lattice_has_the_fabric_of_the_whole() {
    let cubic = Cubic {
        n: 4,
        overlap: 0.02,
        periodic: [true; 3],
    };
    let (sim, a) = (cubic.simulation(), cubic.spacing());
    for layers in [1, 2, 4] {
        let part = ZonePart {
            shape: ZoneShape::Box {
                lower: DVec3::ZERO,
                upper: DVec3::new(f64::from(layers) * a, 4.0 * a, 4.0 * a),
            },
            outside: false,
            wall: None,
        };
        let zone = Zone { parts: vec![part] };
        let fabric = Fabric {
            zone: zone.clone(),
            ..Fabric::default()
        };
        let told = fabric.measure(&sim, &Origins::default());
        let value = |name: &str| {
            let titled = format!("part {name}");
            let at = FABRIC_COLUMNS.iter().position(|column| column.title("part") == titled);
            match told[at.unwrap()] {
                Value::Number(number) => number,
                Value::Count(count) => count as f64,
            }
        };
        within(1e-12, value("contacts per grain"), 6.0);
        for name in ["fabric xx", "fabric yy", "force fabric zz"] {
            within(1e-9, value(name), 1.0 / 3.0);
        }
        assert!(value("fabric anisotropy") < 1e-9 && value("force fabric anisotropy") < 1e-9);
        let rose = ContactAngles {
            from: DVec3::X,
            towards: DVec3::Z,
            bins: 2,
            zone,
            selection: Selection::default(),
            with_walls: true,
        };
        let rose = rose.measure(&sim, &Origins::default());
        assert!(rose.preference.anisotropy < 1e-9 && rose.force_preference.anisotropy < 1e-9);
    }
}

#[test]
fn walls_count_and_the_core_begins_a_margin_away_from_them() {
    let cubic = Cubic {
        n: 6,
        overlap: 0.1,
        periodic: [true, true, false],
    };
    let (sim, a) = (cubic.simulation(), cubic.spacing());
    let of_margin = |margin: f64| {
        let network = ContactNetwork {
            margin,
            ..ContactNetwork::default()
        };
        let (lower, upper) = network.core(&sim);
        assert_eq!((lower.x, upper.y), (0.0, 6.0 * a), "periodic directions have no margin");
        near(lower.z, 0.5 * a - RADIUS + 2.0 * margin * RADIUS);
        near(upper.z, 5.5 * a + RADIUS - 2.0 * margin * RADIUS);
        network.measure(&sim)
    };
    let found = of_margin(1.0);
    assert_eq!(found.contacts, 2 * 216 + 180);
    // every layer has 36 grains, two of the layers a wall
    near(found.coordination, 6.0);
    // the whole packing is in the box around its surfaces
    let ball = 4.0 / 3.0 * PI * RADIUS * RADIUS * RADIUS;
    let height = 5.0 * a + 2.0 * RADIUS;
    near(of_margin(0.0).packing_fraction, 216.0 * ball / (36.0 * a * a * height));
    // a margin of one radius cuts both outer layers in the middle
    near(
        of_margin(0.5).packing_fraction,
        (4.0 * 36.0 + 36.0) * ball / (36.0 * a * a * 5.0 * a),
    );
    // one diameter: the second layer is cut at h below its centres, the first one a - h above them
    let solid = {
        let h = 1.5 * a - (0.5 * a + RADIUS);
        let beyond = |c: f64| PI / 3.0 * (RADIUS - c) * (RADIUS - c) * (2.0 * RADIUS + c);
        2.0 * 36.0 * (beyond(-h) + beyond(a - h)) + 2.0 * 36.0 * ball
    };
    let core = 36.0 * a * a * (height - 4.0 * RADIUS);
    near(found.packing_fraction, solid / core);
    // nothing is left beyond half the height
    let none = of_margin(3.0);
    assert!(none.packing_fraction.is_nan() && none.scaling().is_nan());
    assert_eq!(none.contacts, found.contacts);
}

#[test]
fn contacts_below_the_threshold_and_without_force_do_not_count() {
    // grains in a row with overlaps of 1 % and 2 %, a wall with 3 %, and a grain that parts so fast that its dashpot takes
    // all force from the contact, which ends at zero force
    let mut laws = law("linear", &[("stiffness", STIFFNESS), ("restitution", 0.5)]);
    laws.parameters.insert("contact_end".into(), "zero-force".into());
    let mut case = Case::new(one_material(1e7, &Laws::of(laws)));
    let r = RADIUS;
    let places = [0.0, 1.99, 3.97, -1.99];
    let speeds = [0.0, 0.0, 0.0, -0.5];
    for (x, speed) in places.into_iter().zip(speeds) {
        case.grain(r, DVec3::X * (x * r), DVec3::X * speed);
    }
    case.plane(0, DVec3::X * (4.94 * r), DVec3::NEG_X);
    let mut sim = case.simulation();
    sim.start().unwrap();
    assert_eq!((sim.contacts.pair_count(), sim.contacts.acting_pairs()), (3, 2));
    let row = measure(&mut sim, Moment::default(), None);
    assert_eq!((row.contacts, row.walls[0].contacts), (2, 1));
    assert_eq!(row.coordination, 5.0 / 4.0);
    let records = contact_records(&sim);
    assert_eq!(records.len(), 3);
    // the dashpot takes a little of the forces of the first step
    let mut forces: Vec<f64> = records.iter().map(|c| c.repulsion().abs()).collect();
    forces.sort_by(f64::total_cmp);
    for (force, overlap) in forces.iter().zip([0.01, 0.02, 0.03]) {
        assert!(
            (force / (STIFFNESS * overlap * r) - 1.0).abs() < 0.02,
            "{force} at {overlap} r"
        );
    }
    let (weak, strong, on_wall) = (forces[0], forces[1], forces[2]);
    let of = |threshold: f64| {
        ContactNetwork {
            threshold,
            ..ContactNetwork::default()
        }
        .measure(&sim)
    };
    let all = of(0.0);
    assert_eq!((all.contacts, all.coordination), (2, 5.0 / 4.0));
    near(all.mean_force, 0.5 * (weak + strong));
    near(all.centre_distance, 1.985 * r);
    let few = of(1.5 * weak);
    assert_eq!((few.contacts, few.coordination), (1, 3.0 / 4.0));
    near(few.mean_force, strong);
    near(few.centre_distance, 1.98 * r);
    let none = of(1.0);
    assert_eq!((none.contacts, none.coordination), (0, 0.0));
    assert!(none.mean_force.is_nan() && none.centre_distance.is_nan());
    // a row of one grain's width has no core
    assert!(all.packing_fraction.is_nan());

    let bins = ForceDistribution::new(0.0, 2.7 * weak, 0.45 * weak).unwrap();
    let [grains, walls] = bins.measure(&sim);
    assert_eq!(
        (grains.contacts, grains.counts, grains.above),
        (2, vec![0, 0, 1, 0, 1, 0], 0)
    );
    near(grains.sum, weak + strong);
    assert_eq!((walls.contacts, walls.counts, walls.above), (1, vec![0; 6], 1));
    near(walls.sum, on_wall);
}

#[test]
fn an_attraction_acts_across_a_gap() {
    // within the reach of a van der Waals tail two grains pull: that contact counts, though they do not touch
    let pull = law(
        "dmt",
        &[("work_of_adhesion", 0.05), ("separation", 1.65e-10), ("cutoff", 1e-7)],
    );
    let mut case = Case::new(one_material(1e7, &Laws::of(pull)));
    case.grain(RADIUS, DVec3::ZERO, DVec3::ZERO);
    case.grain(RADIUS, DVec3::new(2.0 * RADIUS + 1e-8, 0.0, 0.0), DVec3::ZERO);
    let mut sim = case.simulation();
    sim.start().unwrap();
    let found = ContactNetwork::default().measure(&sim);
    assert_eq!(found.contacts, 1);
    assert!(found.mean_force < 0.0, "{found:?}");
    let network = ContactNetwork {
        threshold: 0.5 * found.mean_force.abs(),
        ..ContactNetwork::default()
    };
    assert_eq!(network.measure(&sim).contacts, 1, "the magnitude counts");
    let [grains, _] = ForceDistribution::new(0.0, 1.0, 0.1).unwrap().measure(&sim);
    assert_eq!(
        (grains.contacts, grains.counts.iter().sum::<u64>(), grains.above),
        (1, 0, 0)
    );
    let [grains, _] = ForceDistribution::new(-1.0, 0.0, 1.0).unwrap().measure(&sim);
    assert_eq!(grains.counts, [1]);
}

#[test]
fn a_contact_that_bulges_are_about_to_make_does_not_count_before_it_pushes() {
    // two grains side by side at a gap of 0.01 R between plates: their bulges meet at a compression of 0.0568857413
    // (half-space, Poisson's ratio 0.5); before, they are in the table without force
    for (q, acting) in [(0.0568, 0), (0.0570, 1)] {
        let mut laws = Laws::hertz(1.0);
        laws.0.multi_contact = Some(law("half-space", &[]));
        let of = |young_modulus: f64| Material {
            name: format!("{young_modulus} Pa"),
            young_modulus,
            poisson_ratio: 0.5,
            density: 1.0,
        };
        let mut case = Case::new(Materials::new(vec![of(1.0), of(1e15)], |_, _| laws.0.clone()).unwrap());
        case.coupling = Coupling::Converged { tolerance: 1e-12 };
        case.max_overlap = 0.5;
        case.skin = 0.2;
        case.domain.lower = DVec3::splat(-10.0);
        case.domain.upper = DVec3::splat(10.0);
        for side in [-1.0, 1.0] {
            case.grain(1.0, DVec3::X * (1.005 * side), DVec3::ZERO);
            case.plane(1, DVec3::Z * ((1.0 - q) * side), DVec3::Z * -side);
        }
        let mut sim = case.simulation();
        sim.start().unwrap();
        assert_eq!(sim.contacts.pair_count(), 1, "the gap is within reach of the bulges");
        let row = measure(&mut sim, Moment::default(), None);
        assert_eq!(
            (row.contacts, row.walls[0].contacts, row.walls[1].contacts),
            (acting, 2, 2)
        );
        assert_eq!(contact_records(&sim).len(), 4 + acting);
        let found = ContactNetwork::default().measure(&sim);
        assert_eq!(
            (found.contacts, found.coordination),
            (acting, (4 + 2 * acting) as f64 / 2.0)
        );
        if acting > 0 {
            near(found.centre_distance, 2.01);
        }
    }
}

const SQUEEZE: &str = r#"
[simulation]
max_overlap = 0.3
gravity = "0 0 -9.81 m/s^2"

[material.gel]
young_modulus = "200 kPa"
poisson_ratio = 0.3
density = "1000 kg/m^3"

[contact]
normal = { law = "hertz-tsuji", restitution = 0.5, contact_end = "zero-force" }
tangential = { law = "linear-history", friction = 0.3, stiffness = "20 N/m" }

[[grains]]
material = "gel"
source = "random"
region = { shape = "box", lower = "0 0 0 mm", upper = "10 10 30 mm" }
diameter = "2 mm"
count = 150

[[wall]]
name = "box"
material = "gel"
shape = "box"
lower = "0 0 0 mm"
upper = "10 10 40 mm"

[[measure]]
name = "packing"
kind = "contact-network"
threshold = "0.1 mN"

[[measure]]
name = "all"
kind = "force-distribution"
bin = "0.02 mN"
upper = "2 mN"

[[measure]]
name = "strong"
kind = "force-distribution"
lower = "1 mN"
bin = "1 mN"
upper = "5 mN"

[[stage]]
name = "fall, then settle"
steps = 40_000

[output]
series = "2 ms"
frames = "never"
checkpoints = "never"
picture = false
plots = [{ x = "time", y = "packing coordination" }]
"#;

/// Ends the run at a step, when it is told to.
struct Watch(Option<u64>);

impl Observer for Watch {
    fn progress(&mut self, progress: &Progress) -> bool {
        self.0.is_none_or(|step| progress.step < step)
    }

    fn interval(&self) -> Duration {
        Duration::ZERO
    }

    fn message(&mut self, _: &str) {}
}

const ROWS: [&str; 3] = ["series.csv", "distributions/all.csv", "distributions/strong.csv"];

fn rows(folder: &Path) -> [String; 3] {
    ROWS.map(|name| std::fs::read_to_string(folder.join(name)).unwrap())
}

/// Cells of a column.
fn column<'a>(text: &'a str, title: &str) -> Vec<&'a str> {
    let mut lines = text.lines();
    let at = lines.next().unwrap().split(',').position(|cell| cell == title).unwrap();
    // the one name in quotes holds a comma
    lines
        .map(|line| {
            let cells = line.split(',').collect::<Vec<_>>();
            let quoted = usize::from(at > 2 && line.contains('"'));
            cells[at + quoted]
        })
        .collect()
}

#[test]
fn files_of_measures_are_the_same_after_restarts() {
    let place = tempfile::tempdir().unwrap();
    let scenario = Scenario::parse(SQUEEZE, "squeeze.toml", Path::new(""), &[]).unwrap();
    let [whole, parts] = ["whole", "parts"].map(|name| place.path().join(name));
    let threads = |count| RunOptions {
        threads: Some(count),
        ..RunOptions::default()
    };
    run(&scenario, &whole, threads(1), &mut Watch(None)).unwrap();
    let expected = rows(&whole);
    check_files(&expected);

    let first = run(&scenario, &parts, threads(2), &mut Watch(Some(15_000))).unwrap();
    assert_eq!(first.end, RunEnd::Interrupted);
    let checkpoint = parts.join("checkpoint.latest");
    let early = std::fs::read(&checkpoint).unwrap();
    let shorter = rows(&parts);
    // goes on, and is killed behind its last checkpoint: rows of later steps, and one that is cut short
    resume(&parts, threads(1), &mut Watch(Some(25_000))).unwrap();
    std::fs::write(&checkpoint, &early).unwrap();
    for (name, text) in ROWS.iter().zip(&shorter) {
        let path = parts.join(name);
        let longer = std::fs::read_to_string(&path).unwrap();
        assert!(longer.len() > text.len() && longer.starts_with(text.as_str()), "{name}");
        std::fs::write(&path, &longer[..longer.len() - 7]).unwrap();
    }
    let last = resume(&parts, threads(1), &mut Watch(None)).unwrap();
    assert_eq!(last.end, RunEnd::Finished);
    for (name, (found, expected)) in ROWS.iter().zip(rows(&parts).iter().zip(&expected)) {
        assert!(found == expected, "`{name}` differs");
    }
    assert!(whole.join("plots/packing-coordination-over-time.svg").is_file());
}

/// The files of a whole run agree with each other.
fn check_files([series, all, strong]: &[String; 3]) {
    let count = |cells: Vec<&str>| cells.iter().map(|c| c.parse::<u64>().unwrap()).collect::<Vec<_>>();
    let (steps, contacts) = (column(series, "step"), count(column(series, "contacts")));
    assert!(steps.len() > 40 && contacts.iter().max() > Some(&250), "{contacts:?}");
    let with_walls = count(column(series, "wall box contacts"));
    let above = count(column(series, "packing contacts"));
    assert!(above.iter().zip(&contacts).all(|(few, all)| few <= all));
    assert!(above.iter().zip(&contacts).any(|(few, all)| few < all && *few > 100));
    for text in [all, strong] {
        let (of_steps, between) = (column(text, "step"), column(text, "between"));
        let (found, sum) = (count(column(text, "contacts")), column(text, "sum [N]"));
        assert_eq!(of_steps.len(), 2 * steps.len());
        for k in 0..steps.len() {
            assert_eq!([of_steps[2 * k], of_steps[2 * k + 1]], [steps[k]; 2]);
            assert_eq!(between[2 * k..2 * k + 2], ["grains", "walls"]);
            assert_eq!(found[2 * k..2 * k + 2], [contacts[k], with_walls[k]]);
            let force: f64 = sum[2 * k].parse().unwrap();
            assert_eq!(force > 0.0, contacts[k] > 0);
        }
    }
    // 5 bins of 0.02 mN lie below the threshold of the network; all other contacts are in the rest, as none pulls
    let bins: Vec<Vec<u64>> = (0..100).map(|k| count(column(all, &bin_title(k)))).collect();
    let last = count(column(all, "above"));
    for (k, &counted) in above.iter().enumerate() {
        let rest: u64 = bins[5..].iter().map(|bin| bin[2 * k]).sum();
        assert_eq!(rest + last[2 * k], counted, "row {k}");
    }
}

/// Title of a bin of 0.02 mN.
fn bin_title(k: u32) -> String {
    format!("{} [N]", format!("{}e-5", 2 * k).parse::<f64>().unwrap())
}

/// Two pairs: one pushes as hard as the other pulls, so that the sum of their forces is 0 and that of the magnitudes is not.
#[test]
fn the_fabric_of_sticky_grains_weighs_pulls_like_pushes() {
    let text = r#"
[simulation]
max_overlap = 0.3
time_step = "1e-7 s"
[domain]
lower = "-5 -5 -5 mm"
upper = "15 15 15 mm"
[material.g]
young_modulus = "1 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"
[contact]
normal = { law = "sjkr", cohesion_energy_density = "20000 Pa", alpha = 0.5 }
[[grains]]
material = "g"
source = "list"
diameter = "1 mm"
positions = ["0 0 0 mm", "0.99048239 0 0 mm", "5 0 0 mm", "5 0.99799 0 mm"]
[[measure]]
name = "all"
kind = "fabric"
[[stage]]
steps = 1
[output]
series = "1e-7 s"
frames = "never"
picture = false
report = false
"#;
    let place = tempfile::tempdir().unwrap();
    run_in(&parse(text), place.path(), 1, &mut watcher());
    let of = |column: &str| series(place.path())[&format!("all {column}")][0];
    for (column, expected) in [
        ("force fabric xx", 0.5),
        ("force fabric yy", 0.5),
        ("force fabric anisotropy", 0.5),
        ("strong force share", 0.5),
    ] {
        assert!((of(column) - expected).abs() < 1e-3, "{column}: {}", of(column));
    }
}
