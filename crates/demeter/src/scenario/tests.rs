mod bodies;
mod boxes_of_files;
mod doubtful_units;
mod faults;
mod in_vain;
mod mesh_units;
mod pair_laws;
mod reference;
mod selections;
mod stiff_springs;
mod stray_places;
mod stray_walls;
mod tags_of_files;
mod tensions;

use super::*;
use crate::insertion::{Amount, Basis, LatticeKind, Region, SizeDistribution, Source};
use crate::measure::{ContactNetwork, ForceDistribution, WallsLoad};
use crate::particles::Outside;
use crate::simulation::StopCondition;
use crate::walls::{Motion, Motions, Shape, Side};
use glam::{DVec3, dvec3};
use std::f64::consts::PI;

fn good() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/good")
}

fn read_good(name: &str) -> Scenario {
    match Scenario::read(&good().join(name), &[]) {
        Ok(scenario) => scenario,
        Err(faults) => panic!("{}", faults.render(false)),
    }
}

fn parse(text: &str, overrides: &[&str]) -> Result<Scenario, Diagnostics> {
    let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
    Scenario::parse(text, "case.toml", Path::new(""), &overrides)
}

fn settle() -> &'static str {
    template("settle").unwrap()
}

#[test]
fn a_component_of_a_vector_is_changed_by_its_number() {
    let gravity = |overrides: &[&str]| parse(settle(), overrides).unwrap().simulation.gravity;
    assert_eq!(gravity(&[]), dvec3(0.0, 0.0, -9.81));
    assert_eq!(gravity(&["simulation.gravity[0]=2 m/s^2"]), dvec3(2.0, 0.0, -9.81));
    let all = ["simulation.gravity[2]=\"-1 m/s^2\"", "simulation.gravity[1]=50 cm/s^2"];
    assert_eq!(gravity(&all), dvec3(0.0, 0.5, -1.0));
    let refused = |told: &str| parse(settle(), &[told]).unwrap_err().render(false);
    let text = refused("simulation.gravity[3]=1 m/s^2");
    assert!(
        text.contains("there is no element 3") && text.contains("from 0 to 2"),
        "{text}"
    );
    let text = refused("grains[0].velocity[1]=3 m/s");
    assert!(
        text.contains("nothing yet of which `1`") && text.contains("the whole value"),
        "{text}"
    );
    let text = refused("title[0]=a");
    assert!(text.contains("cannot be set below"), "{text}");
}

#[test]
fn walls_and_motions_are_read_as_told() {
    let scenario = read_good("every_wall.toml");
    let shape = |name: &str| {
        scenario
            .walls
            .iter()
            .find(|w| w.name == name)
            .map(|w| w.shape.clone())
            .unwrap()
    };
    let given = |name: &str| match shape(name) {
        WallShape::Given(shape) => shape,
        WallShape::File(file) => panic!("{file:?}"),
    };
    let motion = |name: &str| {
        scenario
            .walls
            .iter()
            .find(|w| w.name == name)
            .map(|w| w.motion.clone())
            .unwrap()
    };
    let plane = Shape::Plane {
        point: dvec3(0.0, 0.0, -0.05),
        normal: dvec3(0.0, 0.0, 1.0),
    };
    assert_eq!(given("floor"), plane);
    let (lower, upper) = (dvec3(-0.05, -0.05, -0.05), dvec3(0.05, 0.05, 0.05));
    let open = [false, false, false, false, true, true];
    assert_eq!(given("box"), Shape::Box { lower, upper, open });
    assert_eq!(
        given("shell"),
        Shape::Cylinder {
            start: dvec3(0.01, 0.01, -0.04),
            end: dvec3(0.01, 0.01, 0.04),
            radius: 0.03,
            side: Side::Inside,
        }
    );
    assert_eq!(
        given("hopper"),
        Shape::Cone {
            start: dvec3(0.01, 0.01, -0.03),
            end: dvec3(0.01, 0.01, -0.01),
            start_radius: 0.0,
            end_radius: 0.03,
            side: Side::Inside,
        }
    );
    assert_eq!(
        given("ball"),
        Shape::Sphere {
            center: dvec3(0.01, 0.01, -0.008),
            radius: 0.003,
            side: Side::Outside,
        }
    );
    assert_eq!(
        given("plate"),
        Shape::Rectangle {
            center: dvec3(0.01, 0.01, 0.014),
            half_u: dvec3(0.008, 0.0, 0.0),
            half_v: dvec3(0.0, 0.008, 0.0),
        }
    );
    assert_eq!(
        given("lid"),
        Shape::Disc {
            center: dvec3(0.01, 0.01, 0.03),
            normal: dvec3(0.0, 0.0, -1.0),
            radius: 0.02,
        }
    );
    let corner = dvec3(0.03, 0.0, 0.0);
    assert!(matches!(given("ramp"), Shape::Mesh { triangles } if triangles.len() == 1 && triangles[0][0] == corner));
    match shape("mesh") {
        WallShape::File(file) => {
            assert_eq!((file.scale, file.shift), (Some(0.001), dvec3(0.0, 0.0, -0.002)));
            assert!(file.path.ends_with("plate.stl") && file.path.is_file());
        }
        WallShape::Given(shape) => panic!("{shape:?}"),
    }
    assert_eq!(motion("floor"), Motions::rest());
    assert_eq!(motion("lid"), Motion::Velocity(dvec3(0.0, 0.0, -0.005)).into());
    match motion("shell").parts[0].motion {
        Motion::Rotation {
            point,
            axis,
            angular_velocity,
        } => {
            assert_eq!((point, axis), (dvec3(0.01, 0.01, 0.0), dvec3(0.0, 0.0, 1.0)));
            assert!((angular_velocity - 2.0 * PI).abs() < 1e-14);
        }
        ref other => panic!("{other:?}"),
    }
    let oscillation = Motion::Oscillation {
        amplitude: dvec3(0.0, 0.0, 0.001),
        frequency: 50.0,
        phase: 90.0 * (PI / 180.0),
    };
    assert_eq!(motion("ball"), oscillation.into());
    let servo = Motion::Servo {
        axis: dvec3(0.0, 0.0, -1.0),
        force: 0.01,
        max_speed: 0.05,
    };
    assert_eq!(motion("plate"), servo.into());
}

#[test]
fn settings_are_read_as_told() {
    let scenario = read_good("every_wall.toml");
    assert_eq!((scenario.title.as_str(), scenario.seed), ("Every wall", 7));
    let simulation = SimulationSpec {
        gravity: dvec3(0.0, 0.0, -9.81),
        max_overlap: 0.1,
        skin: Some(5e-4),
        ..SimulationSpec::default()
    };
    assert_eq!(scenario.simulation, simulation);
    assert_eq!(
        scenario.domain.bounds,
        Some((dvec3(-0.06, -0.06, -0.06), dvec3(0.06, 0.06, 0.06)))
    );
    assert_eq!(
        (scenario.domain.outside, scenario.domain.periodic),
        (Outside::Remove, [false; 3])
    );
    let lattice = read_good("every_lattice.toml");
    assert_eq!(lattice.simulation.time_step, TimeStep::Fixed(2e-6));
    assert_eq!(
        (lattice.domain.outside, lattice.domain.periodic),
        (Outside::Stop, [true, true, false])
    );
    let minimal = read_good("free_fall.toml");
    assert_eq!((minimal.title.as_str(), minimal.seed), ("free_fall", 1));
    assert_eq!(minimal.simulation.time_step, TimeStep::Auto);
    assert_eq!(minimal.simulation.max_overlap, DEFAULT_MAX_OVERLAP);
    assert_eq!((minimal.domain.bounds, minimal.domain.outside), (None, Outside::Stop));
    assert_eq!(minimal.contact.default.tangential, None);
    let cadence = minimal.output.cadence;
    assert_eq!(
        (cadence.series, cadence.frames),
        (Some(0.05 / AUTOMATIC_ROWS), Some(0.05 / AUTOMATIC_FRAMES))
    );
}

#[test]
fn measures_are_read_as_told() {
    let scenario = read_good("every_measure.toml");
    let names: Vec<&str> = scenario.measures.iter().map(|m| m.name.as_str()).collect();
    let expected = [
        "all",
        "strong_4-mN",
        "forces",
        "low-half",
        "kind",
        "bed",
        "heap",
        "slices",
        "pull",
        "weight",
        "height",
    ];
    assert_eq!(names, expected);
    let kind = |k: usize| scenario.measures[k].kind.clone();
    assert_eq!(kind(0), MeasureKind::ContactNetwork(ContactNetwork::default()));
    let strong = ContactNetwork {
        threshold: 0.004,
        margin: 1.5,
        region: Some((dvec3(0.005, 0.005, 0.0), dvec3(0.015, 0.015, 0.06))),
    };
    assert_eq!(kind(1), MeasureKind::ContactNetwork(strong));
    let bins = |lower, upper, bin| MeasureKind::ForceDistribution(ForceDistribution::new(lower, upper, bin).unwrap());
    assert_eq!(kind(2), bins(0.0, 0.3, 0.0005));
    assert_eq!(kind(8), bins(-0.001, 0.0, 0.0001));
    let MeasureKind::Mixing(mixing) = kind(3) else { panic!() };
    assert_eq!((mixing.cells, mixing.selection.ids.len()), ([4, 4, 5], 10));
    let MeasureKind::Mixing(mixing) = kind(4) else { panic!() };
    assert_eq!((mixing.selection.material, mixing.selection.source), (Some(0), Some(0)));
    let slopes = [kind(5), kind(6)].map(|kind| match kind {
        MeasureKind::Slope(slope) => (slope.along, slope.up, slope.between, slope.bins),
        other => panic!("{other:?}"),
    });
    assert_eq!(
        slopes[0],
        (Some(dvec3(1.0, 0.0, 0.0)), dvec3(0.0, 0.0, 1.0), (0.0, 0.02), 8)
    );
    assert_eq!(slopes[1], (None, dvec3(0.0, 0.0, 1.0), (0.0, 0.009), 4));
    let MeasureKind::Profile(profile) = kind(7) else {
        panic!()
    };
    assert_eq!(
        (profile.axis, profile.slices, profile.upper),
        (2, 10, dvec3(0.02, 0.02, 0.05))
    );
    let weight = WallsLoad {
        walls: vec![0],
        point: dvec3(0.01, 0.01, 0.0),
        axis: Some(DVec3::Z),
    };
    assert_eq!(kind(9), MeasureKind::WallsLoad(weight));
    assert!(read_good("free_fall.toml").measures.is_empty());
}

#[test]
fn grains_and_sizes_are_read_as_told() {
    let scenario = read_good("every_size.toml");
    let size = |index: usize| match &scenario.grains[index].source {
        Source::Random { diameter, .. } => diameter.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!(
        size(0),
        SizeDistribution::List {
            diameters: vec![1.5e-3, 2.5e-3],
            shares: vec![3.0, 1.0],
            basis: Basis::Number,
        }
    );
    let (lower, upper) = (1.5e-3, 2.5e-3);
    assert_eq!(size(1), SizeDistribution::Uniform { lower, upper });
    match size(3) {
        SizeDistribution::Lognormal { lower, upper, .. } => {
            assert!((lower * 1.1 * 1.1 * 1.1 / 2e-3 - 1.0).abs() < 1e-14);
            assert!((upper / (2e-3 * 1.1 * 1.1 * 1.1) - 1.0).abs() < 1e-14);
        }
        other => panic!("{other:?}"),
    }
    assert!(matches!(size(5), SizeDistribution::Table { finer, .. } if finer == [0.0, 0.2, 0.7, 1.0]));
    let milled = &scenario.grains[4];
    assert_eq!((milled.seed, milled.velocity_deviation), (11, 0.01));
    assert_eq!(scenario.grains[5].seed, 3 + 5);
    assert!((milled.angular_velocity.z - PI).abs() < 1e-14);
    assert!(matches!(&milled.source, Source::Random { amount, .. } if *amount == Amount::VolumeFraction(0.05)));
    let region = Region::Cylinder {
        start: dvec3(0.01, 0.01, 0.04),
        end: dvec3(0.01, 0.01, 0.06),
        radius: 0.009,
    };
    assert!(matches!(&scenario.grains[2].source, Source::Random { region: r, .. } if *r == region));
    let lattices = read_good("every_lattice.toml");
    let kinds: Vec<_> = (lattices.grains.iter())
        .filter_map(|g| match &g.source {
            Source::Lattice {
                kind, count, jitter, ..
            } => Some((*kind, *count, *jitter)),
            _ => None,
        })
        .collect();
    let expected = [
        (LatticeKind::SimpleCubic, None, 0.05),
        (LatticeKind::Bcc, Some(50), 0.0),
        (LatticeKind::Fcc, None, 0.0),
        (LatticeKind::Hcp, None, 0.0),
    ];
    assert_eq!(kinds, expected);
}

#[test]
fn sizes_between_equal_bounds_are_read() {
    let text = std::fs::read_to_string(good().join("every_size.toml")).unwrap();
    let same = |batch: usize| ["lower", "upper"].map(|key| format!("grains[{batch}].diameter.{key}=2 mm"));
    let overrides: Vec<String> = (1..5).flat_map(same).collect();
    let overrides: Vec<&str> = overrides.iter().map(String::as_str).collect();
    let prepared = prepare(&parse(&text, &overrides).unwrap()).unwrap();
    let grains = &prepared.setup.grains;
    let of_one_size = (0..grains.len()).filter(|&grain| grains.radius(grain) == 1e-3).count();
    assert!(of_one_size > 2 * 40, "{of_one_size}");
    let away = [overrides[2], overrides[3], "grains[2].diameter.mean=3 mm"];
    let text = parse(&text, &away).unwrap_err().render(false);
    assert!(
        text.contains("`mean` must lie between the smallest and the largest diameter"),
        "{text}"
    );
}

#[test]
fn a_pair_changes_only_what_it_names() {
    let scenario = read_good("every_stop.toml");
    let friction = |a, b| {
        scenario
            .contact
            .choice(a, b)
            .tangential
            .map(|t| (t.law, t.parameters["friction"].clone()))
    };
    assert_eq!(friction(0, 0), Some(("coulomb".to_string(), 0.1.into())));
    assert_eq!(friction(0, 1), Some(("coulomb".to_string(), 0.02.into())));
    assert_eq!(friction(1, 0), friction(0, 1));
    assert_eq!(friction(1, 1), None);
    assert_eq!(scenario.contact.choice(0, 1).normal, scenario.contact.default.normal);
    let steel = scenario.contact.choice(1, 1).normal;
    assert_eq!(
        (steel.law.as_str(), steel.parameters["stiffness"].clone()),
        ("linear", 10_000.0.into())
    );
}

#[test]
fn repeats_are_unrolled_with_names_of_their_own() {
    let scenario = read_good("every_stop.toml");
    let names: Vec<&str> = scenario.stages.iter().map(|s| s.name.as_str()).collect();
    let expected = [
        "settle",
        "touch",
        "hold",
        "squeeze 1",
        "shake 1.1",
        "shake 1.2",
        "release 1",
        "squeeze 2",
        "shake 2.1",
        "shake 2.2",
        "release 2",
    ];
    assert_eq!(names, expected);
    assert_eq!(scenario.stage_paths[8], "stage[3].stage[1]");
    let settle = &scenario.stages[0];
    assert_eq!(
        settle.stop,
        [StopCondition::Duration(0.5), StopCondition::KineticOverElastic(1e-3)]
    );
    assert_eq!((settle.cadence.frames, settle.cadence.series), (None, Some(2e-3)));
    let touch = StopCondition::WallForce {
        walls: vec![1],
        direction: [0.0, 0.0, 1.0],
        above: 5e-3,
    };
    assert_eq!(scenario.stages[1].stop[1], touch);
    assert_eq!(
        scenario.stages[1].motions,
        [(1, Motion::Velocity(dvec3(0.0, 0.0, -0.05)).into())]
    );
    let together = StopCondition::WallForce {
        walls: vec![1, 0],
        direction: [0.0, 0.0, -1.0],
        above: 0.5,
    };
    assert_eq!(scenario.stages[2].stop, [StopCondition::Steps(1000), together]);
    let strain = StopCondition::Strain {
        wall: 1,
        length: 0.02,
        strain: 0.05,
    };
    assert_eq!(scenario.stages[3].stop[1], strain);
    // 0.5 + 0.2 + 2 (0.5 + 2 0.02 + 0.1) s
    let total = 1.98;
    let checkpoints = scenario.stages[3].cadence.checkpoints.unwrap();
    assert!((checkpoints * AUTOMATIC_CHECKPOINTS - total).abs() < 1e-12);
    assert_eq!(scenario.output.cadence.checkpoints, Some(0.1));
}

/// A grain in the middle of a box of 20 mm.
const ONE_GRAIN: &str = r#"
[material.glass]
young_modulus = "1 MPa"
poisson_ratio = 0.25
density = "2500 kg/m^3"

[contact]
normal = { law = "hertz-tsuji", restitution = 0.7 }

[[grains]]
material = "glass"
source = "list"
positions = ["10 10 15 mm"]
diameter = "2 mm"
"#;

#[test]
fn a_wall_that_ends_at_a_periodic_side_and_is_not_repeated_is_told() {
    let text = |walls: &str| {
        format!(
            r#"
[domain]
lower = "0 0 0 mm"
upper = "20 20 20 mm"
periodic = ["x"]

{ONE_GRAIN}

{walls}

[[stage]]
name = "fall"
steps = 10
"#
        )
    };
    let ball = |x: f64| {
        format!(
            "[[wall]]\nname = \"ball\"\nmaterial = \"glass\"\nshape = \"sphere\"\ncenter = \"{x} 10 5 mm\"\nradius = \"3 mm\"\nside = \"outside\"\n"
        )
    };
    let floor =
        "[[wall]]\nname = \"floor\"\nmaterial = \"glass\"\nshape = \"plane\"\npoint = \"0 0 0 mm\"\nnormal = \"z\"\n";
    let plate = |half: f64, more: &str| {
        format!(
            "[[wall]]\nname = \"plate\"\nmaterial = \"glass\"\nshape = \"rectangle\"\ncenter = \"10 10 2 mm\"\nhalf_u = \"{half} 0 0 mm\"\nhalf_v = \"0 3 0 mm\"\n{more}"
        )
    };
    let turning = "motion = { rotation = { point = \"10 10 5 mm\", axis = \"z\", angular_velocity = \"1 rpm\" } }\n";
    let told = |walls: &str| prepare(&parse(&text(walls), &[]).unwrap()).unwrap().warnings.join("\n");
    for walls in [
        floor,
        &plate(11.1, ""),
        &plate(10.0, ""),
        &plate(5.0, turning),
        &ball(10.0),
        &ball(3.9),
        &ball(0.0),
    ] {
        assert_eq!(told(walls), "", "{walls}");
    }
    for (walls, words) in [
        (
            plate(10.0, turning),
            "from 0.000000 m to 0.020000 m along x, where periodic sides are at 0.000000 m and 0.020000 m, and is not repeated",
        ),
        (plate(10.5, ""), "as it is longer than the box"),
        (plate(9.9, ""), "a gap of 2.000e-4 m"),
        (ball(16.5) + turning, "within a grain's radius of the periodic side +x"),
        (ball(3.9) + turning, "within a grain's radius of the periodic side -x"),
    ] {
        let told = told(&walls);
        assert!(told.contains(words), "{told}");
    }
}

#[test]
fn measures_that_would_miss_grains_are_warned_of() {
    let told = |gate: &str, width: &str| {
        let text = format!(
            r#"
[domain]
lower = "0 0 0 mm"
upper = "20 20 20 mm"
outside = "remove"

{ONE_GRAIN}

[[measure]]
name = "out"
kind = "mass-flow"
gate = {{ shape = "plane", point = "0 0 {gate} mm", normal = "-z" }}

[[measure]]
name = "flow"
kind = "field"
cells = [10, 1, 1]
{width}

[[stage]]
name = "fall"
steps = 10
"#
        );
        prepare(&parse(&text, &[]).unwrap()).unwrap().warnings
    };
    let wide = "kernel = \"lucy\"\nwidth = \"4 mm\"";
    assert_eq!(told("1.5", wide), [""; 0]);
    assert!(told("0.5", wide)[0].starts_with("the gate of measure `out` is closer than a grain's radius"));
    assert!(told("19.5", wide)[0].contains("19.5") || told("19.5", wide)[0].contains("0.0195"));
    for narrow in [
        "kernel = \"lucy\"\nwidth = \"2.9 mm\"",
        "kernel = \"gaussian\"\nwidth = \"1.1 mm\"",
    ] {
        assert!(
            told("1.5", narrow)[0].starts_with("the kernel of field `flow`"),
            "{narrow}"
        );
    }
}
