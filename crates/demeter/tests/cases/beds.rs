//! Small beds of many grains that use every feature that has a memory: friction, rolling springs, meshes, servo,
//! periodic sides, removal.

use super::{Case, G, Laws, brick, law, one_material};
use demeter::contacts::Coupling;
use demeter::insertion::{Amount, Insertion, Region, SizeDistribution, Source, insert};
use demeter::particles::{Domain, Outside};
use demeter::simulation::Setup;
use demeter::walls::{BodyMass, BodyMotion, Motion, Shape, Side};
use demeter_physics::DVec3;
use demeter_physics::integrator::Integrator;
use std::f64::consts::TAU;

/// Mean radius of the grains [m].
pub const RADIUS: f64 = 2e-3;

/// All beds by name.
pub const BEDS: [&str; 13] = [
    "settling",
    "drum",
    "servo",
    "shear",
    "moving walls",
    "removal",
    "squeezing",
    "cohesive",
    "powder",
    "squeezed",
    "squeezed lagged",
    "squeezed cohesive",
    "squeezed out",
];

/// Steps for a bed: half as many where contacts feel each other, which costs more and begins at the first step.
pub fn steps_for(name: &str, steps: u64) -> u64 {
    if name.starts_with("squeezed") { steps / 2 } else { steps }
}

/// The bed of a name with about `count` grains, and how it is integrated.
pub fn bed_with(integrator: Integrator, name: &str, count: u32) -> Setup {
    Setup {
        integrator,
        ..bed(name, count)
    }
}

/// The bed of a name with about `count` grains.
pub fn bed(name: &str, count: u32) -> Setup {
    match name {
        "settling" => settling(count),
        "drum" => drum(count),
        "servo" => servo(count),
        "shear" => shear(count),
        "moving walls" => moving_walls(count),
        "removal" => removal(count),
        "squeezing" => squeezing(count),
        "cohesive" => cohesive(count),
        "powder" => powder(count),
        "squeezed" => squeezed(count),
        "squeezed lagged" => squeezed_lagged(count),
        "squeezed cohesive" => squeezed_cohesive(count),
        "squeezed out" => squeezed_out(count),
        _ => panic!("there is no bed `{name}`"),
    }
}

fn mindlin() -> demeter_physics::contact::LawChoice {
    law("mindlin-history", &[("friction", 0.4)])
}

/// Fills a box with loose grains that move at random.
pub fn fill(case: &mut Case, lower: DVec3, upper: DVec3, count: u32, speed: f64) {
    let insertion = Insertion {
        name: "grains".into(),
        material: 0,
        types: vec![],
        source: Source::Random {
            region: Region::Box { lower, upper },
            diameter: SizeDistribution::Uniform {
                lower: 1.5 * RADIUS,
                upper: 2.5 * RADIUS,
            },
            amount: Amount::Count(count),
        },
        velocity: DVec3::ZERO,
        velocity_deviation: speed,
        angular_velocity: DVec3::new(3.0, -2.0, 1.0),
        tag: None,
        fixed: false,
        seed: 7,
    };
    let inserted = insert(&insertion, case.materials.list(), &[], Some(&case.domain)).unwrap();
    for (k, grain) in inserted.grains.iter().enumerate() {
        case.grains.push(k as u32 + 1, grain);
    }
}

/// Edge of a cube that `count` grains fill to a share.
fn edge(count: u32, fraction: f64) -> f64 {
    let volume = 2.0 * TAU / 3.0 * RADIUS * RADIUS * RADIUS * 1.06;
    libm::cbrt(f64::from(count) * volume / fraction)
}

fn boxed(count: u32, laws: &Laws, open: [bool; 6]) -> (Case, f64) {
    let mut case = Case::new(one_material(5e6, laws));
    let a = edge(count, 0.25);
    fill(&mut case, DVec3::ZERO, DVec3::splat(a), count, 0.1);
    let walls = Shape::Box {
        lower: DVec3::ZERO,
        upper: DVec3::splat(a),
        open,
    };
    case.wall(0, walls, Motion::Rest);
    case.gravity = DVec3::new(0.0, 0.0, -G);
    case.skin = 0.2 * RADIUS;
    case.max_overlap = 0.4;
    (case, a)
}

fn settling(count: u32) -> Setup {
    let laws = Laws::hertz(0.5).friction(mindlin()).rolling("epsd", 0.1);
    boxed(count, &laws, [false; 6]).0.setup()
}

/// Soft grains that yield, stick in contact and attract each other across gaps of a fifth of their radius.
fn powder(count: u32) -> Setup {
    let adhesive = law(
        "tomas",
        &[
            ("adhesion_force", 1e-3),
            ("adhesion_radius", 0.5 * RADIUS),
            ("separation", 0.01 * RADIUS),
            ("range", 20.0),
            ("micro_yield_strength", 1e5),
            ("kappa_p", 0.15),
            ("alpha", 0.3),
        ],
    );
    let laws = Laws::of(adhesive).friction(mindlin()).rolling("epsd", 0.1);
    boxed(count, &laws, [false; 6]).0.setup()
}

/// A prism of 12 triangulated sides that turns about the y axis between two planes.
fn drum(count: u32) -> Setup {
    let laws = Laws::linear(2e3, 0.6)
        .friction(law("linear-history", &[("friction", 0.5), ("stiffness", 6e2)]))
        .rolling("constant-torque", 0.05);
    let mut case = Case::new(one_material(5e6, &laws));
    let a = edge(count, 0.2);
    let half = DVec3::splat(0.5 * a);
    fill(&mut case, -half, half, count, 0.1);
    let radius = 0.8 * a;
    let corner = |k: u32, y: f64| {
        let angle = TAU * f64::from(k % 12) / 12.0;
        DVec3::new(radius * libm::cos(angle), y, radius * libm::sin(angle))
    };
    let mut triangles = vec![];
    for k in 0..12 {
        let [p, q, r, s] = [corner(k, -a), corner(k + 1, -a), corner(k + 1, a), corner(k, a)];
        triangles.extend([[p, q, r], [p, r, s]]);
    }
    let turning = Motion::Rotation {
        point: DVec3::ZERO,
        axis: DVec3::Y,
        angular_velocity: 15.0,
    };
    case.wall(0, Shape::Mesh { triangles }, turning);
    case.plane(0, DVec3::new(0.0, -0.5 * a, 0.0), DVec3::Y);
    case.plane(0, DVec3::new(0.0, 0.5 * a, 0.0), -DVec3::Y);
    case.gravity = DVec3::new(0.0, 0.0, -G);
    case.skin = 0.2 * RADIUS;
    case.max_overlap = 0.4;
    case.setup()
}

fn plate(case: &mut Case, a: f64, motion: Motion) {
    let shape = Shape::Rectangle {
        center: DVec3::new(0.5 * a, 0.5 * a, a),
        half_u: DVec3::new(0.6 * a, 0.0, 0.0),
        half_v: DVec3::new(0.0, 0.6 * a, 0.0),
    };
    case.wall(0, shape, motion);
}

const OPEN_TOP: [bool; 6] = [false, false, false, false, false, true];

fn servo(count: u32) -> Setup {
    let laws = Laws::hertz(0.5).friction(mindlin());
    let (mut case, a) = boxed(count, &laws, OPEN_TOP);
    let motion = Motion::Servo {
        axis: -DVec3::Z,
        force: 500.0 * a * a,
        max_speed: 0.5,
    };
    plate(&mut case, a, motion);
    case.setup()
}

fn squeezing(count: u32) -> Setup {
    let laws = Laws::hertz(0.7).friction(law("coulomb", &[("friction", 0.3)]));
    let (mut case, a) = boxed(count, &laws, OPEN_TOP);
    let motion = Motion::Oscillation {
        amplitude: DVec3::new(0.0, 0.0, -0.62 * a),
        frequency: 5.0,
        phase: 0.0,
    };
    plate(&mut case, a, motion);
    case.setup()
}

/// Plastic grains that stick to each other and to the floor, squeezed again and again.
fn cohesive(count: u32) -> Setup {
    let luding = law(
        "luding",
        &[
            ("loading_stiffness", 2e3),
            ("unloading_stiffness", 6e3),
            ("adhesion_stiffness", 1.5e3),
            ("plastic_depth", 0.05),
            ("damping", 0.02),
            ("attraction_force", 2e-4),
            ("attraction_range", 2e-5),
        ],
    );
    let laws = Laws::of(luding).friction(law("linear-history", &[("friction", 0.4), ("stiffness", 6e2)]));
    let (mut case, a) = boxed(count, &laws, OPEN_TOP);
    let motion = Motion::Oscillation {
        amplitude: DVec3::new(0.0, 0.0, -0.5 * a),
        frequency: 5.0,
        phase: 0.0,
    };
    plate(&mut case, a, motion);
    case.setup()
}

/// A cloud flies apart in a box, a tube and over a tilted floor that shake, each otherwise, and under a bar and plates that turn: no wall
/// rests, and none stands at the origin.
fn moving_walls(count: u32) -> Setup {
    let laws = Laws::hertz(0.6).friction(mindlin()).rolling("epsd", 0.05);
    let mut case = Case::new(one_material(5e6, &laws));
    let a = edge(count, 0.25);
    fill(&mut case, DVec3::ZERO, DVec3::splat(a), count, 0.8);
    let shaken = |x: f64, y: f64, z: f64, frequency| Motion::Oscillation {
        amplitude: DVec3::new(x, y, z) * RADIUS,
        frequency,
        phase: 0.4,
    };
    let turned = |point: DVec3, axis: DVec3, angular_velocity| Motion::Rotation {
        point: point * a,
        axis: axis.normalize(),
        angular_velocity,
    };
    let floor = Shape::Plane {
        point: DVec3::new(0.5, 0.5, -0.15) * a,
        normal: DVec3::new(0.2, -0.1, 1.0).normalize(),
    };
    case.wall(0, floor, shaken(0.1, 0.0, 0.5, 30.0));
    let walls = Shape::Box {
        lower: DVec3::new(-0.1, -0.1, -1.0) * a,
        upper: DVec3::new(1.1, 1.1, 3.0) * a,
        open: [false, false, false, false, true, false],
    };
    case.wall(0, walls, shaken(0.2, 0.1, 0.3, 20.0));
    let cylinder = |[start, end]: [DVec3; 2], radius, side| Shape::Cylinder {
        start: start * a,
        end: end * a,
        radius: radius * a,
        side,
    };
    let ends = [DVec3::new(0.5, 0.5, -1.0), DVec3::new(0.5, 0.5, 3.0)];
    case.wall(0, cylinder(ends, 0.75, Side::Inside), shaken(0.2, 0.2, 0.0, 25.0));
    let ends = [DVec3::new(0.5, 0.1, 1.12), DVec3::new(0.5, 0.9, 1.12)];
    let turning = turned(ends[0], DVec3::new(0.1, 1.0, 0.1), 40.0);
    case.wall(0, cylinder(ends, 0.1, Side::Outside), turning);
    let disc = Shape::Disc {
        center: DVec3::new(0.2, 0.5, 1.1) * a,
        normal: DVec3::new(0.3, 0.1, 1.0).normalize(),
        radius: 0.2 * a,
    };
    case.wall(
        0,
        disc,
        turned(DVec3::new(0.2, 0.5, 1.1), DVec3::new(0.1, 0.2, 1.0), 60.0),
    );
    let plate = Shape::Rectangle {
        center: DVec3::new(0.8, 0.5, 1.1) * a,
        half_u: DVec3::new(0.15, 0.0, -0.05) * a,
        half_v: DVec3::new(0.0, 0.3, 0.0) * a,
    };
    case.wall(
        0,
        plate,
        turned(DVec3::new(0.8, 0.5, 1.15), DVec3::new(0.3, 1.0, 0.0), 30.0),
    );
    case.gravity = DVec3::new(0.0, 0.0, -G);
    case.skin = 0.2 * RADIUS;
    case.max_overlap = 0.4;
    case.setup()
}

/// Sheared between two planes, periodic along x and y.
fn shear(count: u32) -> Setup {
    let laws = Laws::hertz(0.8).friction(mindlin()).rolling("epsd", 0.05);
    let mut case = Case::new(one_material(5e6, &laws));
    let a = edge(count, 0.45);
    case.domain = Domain {
        lower: DVec3::new(0.0, 0.0, -a),
        upper: DVec3::new(a, a, 2.0 * a),
        periodic: [true, true, false],
        outside: Outside::Stop,
    };
    fill(&mut case, DVec3::ZERO, DVec3::splat(a), count, 0.2);
    for (z, normal, speed) in [(0.0, DVec3::Z, -0.5), (a, -DVec3::Z, 0.5)] {
        let shape = Shape::Plane {
            point: DVec3::Z * z,
            normal,
        };
        case.wall(0, shape, Motion::Velocity(DVec3::X * speed));
    }
    case.skin = 0.2 * RADIUS;
    case.max_overlap = 0.4;
    case.setup()
}

/// A cloud that flies apart, below a cube that floats above it; what leaves the domain is removed.
fn removal(count: u32) -> Setup {
    let laws = Laws::hertz(0.7).friction(mindlin());
    let mut case = Case::new(one_material(5e6, &laws));
    let a = edge(count, 0.4);
    fill(&mut case, DVec3::ZERO, DVec3::splat(a), count, 0.8);
    case.plane(0, DVec3::ZERO, DVec3::Z);
    let half = 0.2 * a;
    let floating = BodyMotion {
        mass: BodyMass::Density(500.0),
        gravity: DVec3::ZERO,
        velocity: DVec3::ZERO,
        angular_velocity: DVec3::new(5.0, 10.0, -3.0),
        slides: [true; 3],
        turns: [true; 3],
    };
    let triangles = brick(DVec3::new(0.5, 0.5, 1.4) * a, DVec3::splat(half));
    case.wall(0, Shape::Mesh { triangles }, Motion::Body(floating));
    case.domain = Domain {
        lower: DVec3::splat(-0.1 * a),
        upper: DVec3::new(1.1, 1.1, 1.3) * a,
        periodic: [false; 3],
        outside: Outside::Remove,
    };
    case.gravity = DVec3::new(2.0, 0.0, -G);
    case.skin = 0.2 * RADIUS;
    case.max_overlap = 0.4;
    case.setup()
}

/// Grains that overlap from the beginning, on a floor and under a plate that comes down by some 12 % of the height at
/// which it meets their resistance: contacts of a grain feel each other. The plate is a mesh.
fn squeezed_between(laws: &Laws, count: u32, periodic: bool, stroke: f64) -> (Case, f64) {
    let mut case = Case::new(one_material(5e6, laws));
    let a = edge(count, 0.44);
    if periodic {
        case.domain = Domain {
            lower: DVec3::new(0.0, 0.0, -a),
            upper: DVec3::new(a, a, 2.0 * a),
            periodic: [true, true, false],
            outside: Outside::Stop,
        };
    }
    fill(&mut case, DVec3::ZERO, DVec3::splat(a), count, 0.1);
    swell(&mut case, 1.06);
    let [q, r, s, t] = [(-1.0, -1.0), (2.0, -1.0), (2.0, 2.0), (-1.0, 2.0)].map(|(x, y)| DVec3::new(x * a, y * a, a));
    let motion = Motion::Oscillation {
        amplitude: DVec3::new(0.0, 0.0, -stroke * a),
        frequency: 30.0,
        phase: 0.0,
    };
    let triangles = vec![[q, s, r], [q, t, s]];
    case.wall(0, Shape::Mesh { triangles }, motion);
    case.gravity = DVec3::new(0.0, 0.0, -G);
    case.skin = 0.2 * RADIUS;
    case.max_overlap = 0.4;
    (case, a)
}

/// Makes the grains larger where they are.
fn swell(case: &mut Case, factor: f64) {
    let grains = &mut case.grains;
    for k in 0..grains.len() {
        grains.set_size(k, grains.radius(k) * factor, grains.mass(k) * factor * factor * factor);
    }
}

fn walled(case: &mut Case, a: f64, open: [bool; 6]) {
    let walls = Shape::Box {
        lower: DVec3::ZERO,
        upper: DVec3::splat(a),
        open,
    };
    case.wall(0, walls, Motion::Rest);
}

fn squeezed(count: u32) -> Setup {
    let laws = Laws::hertz(0.7).friction(law("coulomb", &[("friction", 0.3)]));
    let (mut case, a) = squeezed_between(&laws.multi_contact("half-space", &[]), count, false, 0.14);
    walled(&mut case, a, OPEN_TOP);
    case.setup()
}

fn squeezed_lagged(count: u32) -> Setup {
    let laws = Laws::hertz(0.7).friction(mindlin());
    let (mut case, _) = squeezed_between(&laws.multi_contact("sphere-to-sphere", &[]), count, true, 0.14);
    case.plane(0, DVec3::ZERO, DVec3::Z);
    case.coupling = Coupling::Lagged;
    case.setup()
}

/// What pulls displaces the other way, and plastic contacts feel each other across gaps.
fn squeezed_cohesive(count: u32) -> Setup {
    let adhesive = law(
        "tomas",
        &[
            ("adhesion_force", 2e-2),
            ("adhesion_radius", 0.5 * RADIUS),
            ("separation", 0.01 * RADIUS),
            ("range", 10.0),
            ("micro_yield_strength", 5e5),
            ("kappa_p", 0.15),
            ("alpha", 0.3),
        ],
    );
    let laws = Laws::of(adhesive).friction(mindlin()).rolling("epsd", 0.1);
    let (mut case, a) = squeezed_between(&laws.multi_contact("half-space", &[]), count, false, 0.1);
    walled(&mut case, a, OPEN_TOP);
    case.setup()
}

/// The plate presses grains out at an open side, where they are removed.
fn squeezed_out(count: u32) -> Setup {
    let laws = Laws::hertz(0.7).friction(mindlin());
    let (mut case, a) = squeezed_between(
        &laws.multi_contact("half-space", &[("prefactor", 1.125)]),
        count,
        false,
        0.3,
    );
    walled(&mut case, a, [false, true, false, false, false, true]);
    case.domain = Domain {
        lower: DVec3::splat(-0.5 * a),
        upper: DVec3::splat(1.1 * a),
        periodic: [false; 3],
        outside: Outside::Remove,
    };
    case.setup()
}
