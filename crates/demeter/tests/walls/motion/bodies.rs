//! Walls that move as rigid bodies.

use super::*;
use crate::cases::{brick, law};
use demeter::contacts::Fault;
use demeter::walls::{BodyMass, BodyMotion, Wall};

/// The centre of the cube below [m].
const CENTER: DVec3 = DVec3::new(0.2, -0.1, 0.3);
const HALF: f64 = 5e-3;
const DENSITY: f64 = 1500.0;
/// Mass and moment of inertia of the cube, about any axis through its centre.
const MASS: f64 = DENSITY * 8.0 * HALF * HALF * HALF;
const INERTIA: f64 = MASS * HALF * HALF * 2.0 / 3.0;

fn cube() -> Shape {
    Shape::Mesh {
        triangles: brick(CENTER, DVec3::splat(HALF)),
    }
}

fn floating(velocity: DVec3, angular_velocity: DVec3) -> BodyMotion {
    BodyMotion {
        mass: BodyMass::Density(DENSITY),
        gravity: DVec3::ZERO,
        velocity,
        angular_velocity,
        slides: [true; 3],
        turns: [true; 3],
    }
}

/// Momentum, and angular momentum about the origin, of grains and the cube.
fn momenta(sim: &Simulation) -> (DVec3, DVec3) {
    let cube = &sim.walls[0];
    let center = cube.carried(CENTER);
    let velocity = cube.velocity_at(center);
    let mut sums = (
        velocity * MASS,
        center.cross(velocity * MASS) + cube.angular_velocity() * INERTIA,
    );
    let grains = sim.grains();
    for g in 0..grains.len() {
        let momentum = grains.velocity[g] * grains.mass(g);
        let spin = grains.angular_velocity[g] * (0.4 * grains.mass(g) * grains.radius(g).powi(2));
        sums.0 += momentum;
        sums.1 += grains.position[g].cross(momentum) + spin;
    }
    sums
}

/// Grains fly at a cube from all sides: what they lose of momenta and energy it gets, but for what is booked as lost.
#[test]
fn a_body_takes_the_momenta_that_grains_lose() {
    let coulomb = law("coulomb", &[("friction", 0.4)]);
    for laws in [Laws::hertz(1.0), Laws::hertz(0.6).friction(coulomb)] {
        let mut case = Case::new(one_material(5e6, &laws));
        case.max_overlap = 0.2;
        let start = floating(DVec3::new(0.05, 0.0, -0.02), DVec3::new(3.0, -5.0, 8.0));
        case.wall(0, cube(), Motion::Body(start));
        let radius = 2e-3;
        for k in 0..20 {
            // directions spread over the sphere by the golden angle
            let (z, angle) = (1.0 - 0.1 * (f64::from(k) + 0.5), 2.4 * f64::from(k));
            let out = DVec3::new(libm::cos(angle), libm::sin(angle), 0.0) * (1.0 - z * z).sqrt() + DVec3::Z * z;
            let place = CENTER + out * (0.014 + 1e-3 * f64::from(k));
            case.grain(radius, place, out * -0.5 + DVec3::Y * 0.05);
        }
        let mut sim = case.simulation();
        sim.step().unwrap();
        let (momentum, angular) = momenta(&sim);
        let (mut touched, mut worst) = (0, 0.0f64);
        let before = (sim.walls[0].velocity_at(CENTER), sim.walls[0].angular_velocity());
        while sim.time() < 0.12 {
            sim.step().unwrap();
            touched += usize::from(sim.contacts.acting_walls() > 0);
            worst = worst.max(sim.energies().residual.abs());
        }
        let (p, l) = momenta(&sim);
        let kick = (sim.walls[0].velocity_at(sim.walls[0].origin()) - before.0).length();
        let turn = (sim.walls[0].angular_velocity() - before.1).length();
        assert!(touched > 100 && kick > 0.02 && turn > 5.0, "{touched} {kick} {turn}");
        // of what the cube got
        let off = (p - momentum).length() / (MASS * kick);
        report("momentum", off);
        assert!(off < 1e-10, "{off}");
        let off = (l - angular).length() / (INERTIA * turn);
        report("angular momentum", off);
        assert!(off < 1e-3, "{off}");
        report("residual", worst);
        assert!(worst < 1e-3, "{worst}");
    }
}

const BRICK: &str = r#"
[[wall]]
name = "brick"
material = "steel"
shape = "mesh"
triangles = TRIANGLES
[wall.motion.body]
density = "4000 kg/m^3"
"#;

fn scenario_with_brick(center: DVec3, half: DVec3, rest: &str) -> String {
    let corner = |p: DVec3| format!("[\"{} m\", \"{} m\", \"{} m\"]", p.x, p.y, p.z);
    let triangles = brick(center, half).into_iter();
    let triangles: Vec<String> = triangles.map(|t| format!("[{}]", t.map(corner).join(", "))).collect();
    let told = BRICK.replace("TRIANGLES", &format!("[{}]", triangles.join(",\n")));
    format!("{told}{rest}")
}

/// A brick that is dropped on a bed tilts as it likes and comes to rest with its weight on the grains.
#[test]
fn a_brick_that_falls_on_a_bed_rests_on_it() {
    let half = DVec3::new(4e-3, 3e-3, 1.5e-3);
    let text = scenario_with_brick(DVec3::new(1e-3, 0.0, 26e-3), half, "[[stage]]\nduration = \"0.5 s\"\n");
    let deep = VESSEL.replace("0 0 11 mm", "0 0 20 mm");
    let series = series_of(&format!("{deep}{text}"));
    assert_books_close("a brick", &series);
    let weight = 4000.0 * 8.0 * half.element_product() * G;
    // at 0.3 s it may still rock, differently with other roundings
    let mean = |axis: &str| {
        let force = &series[&format!("wall brick force {axis} [N]")];
        force[force.len() - 50..].iter().sum::<f64>() / 50.0
    };
    assert!((mean("z") / weight - 1.0).abs() < 0.02, "{} {weight}", mean("z"));
    assert!(mean("x").abs() < 0.02 * weight, "{}", mean("x"));
    let energy = series["free wall energy [J]"].last().unwrap();
    assert!(*energy < 0.0, "{energy}");
    // it falls freely at first, and lies askew in the end
    let (time, speed) = (&series["time [s]"], &series["wall brick velocity z [m/s]"]);
    let row = time.iter().position(|&time| time >= 0.02).unwrap();
    assert!(
        (speed[row] + 9.81 * time[row]).abs() < 1e-9,
        "{} {}",
        speed[row],
        time[row]
    );
    let turn = |axis: &str| *series[&format!("wall brick turn {axis} [rad]")].last().unwrap();
    let tilt = DVec3::new(turn("x"), turn("y"), turn("z"));
    let fastest = series["wall brick angular velocity y [rad/s]"]
        .iter()
        .fold(0.0f64, |m, w| m.max(w.abs()));
    assert!(tilt.length() > 0.01 && fastest > 0.1, "{tilt} {fastest}");
}

#[test]
fn a_body_that_comes_to_a_wall_is_told() {
    let half = DVec3::splat(2e-3);
    let grain = r#"
[[grains]]
material = "steel"
source = "list"
positions = ["20 20 10 mm"]
diameter = "3 mm"
[[stage]]
duration = "0.1 s"
"#;
    let text = scenario_with_brick(DVec3::Z * 12e-3, half, grain);
    let place = tempfile::tempdir().unwrap();
    let done = try_in(&parse(&text), &place.path().join("run"), 1).unwrap();
    let RunEnd::Fault(Fault::BodyAtWall {
        step,
        body,
        wall,
        position,
    }) = &done.end
    else {
        panic!("{done:?}");
    };
    assert_eq!((body.as_str(), wall.as_str()), ("brick", "floor"));
    assert!(position.z.abs() < 1e-4, "{position}");
    // the fall of its lower face through 10 mm
    let time = *step as f64 * prepare(&parse(&text)).unwrap().setup.dt;
    assert!((time / (0.02f64 / G).sqrt() - 1.0).abs() < 1e-2, "{time}");
    // and before step 0
    let text = scenario_with_brick(DVec3::Z * 2e-3, half, grain);
    let faults = prepare(&parse(&text)).unwrap_err().render(false);
    assert!(
        faults.contains("wall `brick` is a body and touches wall `floor`"),
        "{faults}"
    );
}

#[test]
fn what_holds_a_body_holds_it() {
    let mut case = Case::new(one_material(5e6, &Laws::hertz(0.7)));
    case.max_overlap = 0.2;
    let start = BodyMotion {
        slides: [true, false, true],
        turns: [false, true, false],
        ..floating(DVec3::X * 0.01, DVec3::Y)
    };
    case.wall(0, cube(), Motion::Body(start));
    case.grain(2e-3, CENTER + DVec3::new(3e-3, 4e-3, 8e-3), DVec3::new(0.1, -0.3, -0.5));
    let mut sim = case.simulation();
    while sim.time() < 0.05 {
        sim.step().unwrap();
    }
    let cube = &sim.walls[0];
    let (velocity, spin) = (cube.velocity_at(cube.origin()), cube.angular_velocity());
    assert!(velocity.y == 0.0 && spin.x == 0.0 && spin.z == 0.0, "{velocity} {spin}");
    assert!(velocity.z < -0.01 && spin.y > 1.5, "{velocity} {spin}");
    assert!(cube.displacement().y.abs() < 1e-15);
}

#[test]
fn a_body_must_be_one() {
    let of = |shape: Shape, change: &dyn Fn(&mut BodyMotion)| {
        let mut motion = floating(DVec3::ZERO, DVec3::ZERO);
        change(&mut motion);
        Wall::new("body", 0, shape, Motion::Body(motion)).map(drop)
    };
    assert!(of(cube(), &|_| ()).is_ok());
    let plate = Shape::Disc {
        center: DVec3::ZERO,
        normal: DVec3::Z,
        radius: 1.0,
    };
    let why = |found: Result<(), demeter::walls::WallError>| found.unwrap_err().to_string();
    assert!(why(of(plate, &|_| ())).contains("needs a closed mesh"));
    let held = |motion: &mut BodyMotion| (motion.slides, motion.turns) = ([false; 3], [false; 3]);
    assert!(why(of(cube(), &held)).contains("move along no axis"));
    let behind = vec![
        Motion::Velocity(DVec3::X),
        Motion::Body(floating(DVec3::ZERO, DVec3::ZERO)),
    ];
    let parts = behind
        .into_iter()
        .flat_map(|motion| demeter::walls::Motions::from(motion).parts);
    let motions = demeter::walls::Motions { parts: parts.collect() };
    assert!(why(Wall::new("body", 0, cube(), motions).map(drop)).contains("is not the first"));
}
