//! Head-on, off-centre and wall collisions give the requested restitution within 1e-4 at the automatic time step.

use crate::cases;

use crate::cases::{Case, on_threads, report, run_until_parted};
use demeter::materials::{Material, Materials};
use demeter::particles::NewGrain;
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape, Side};
use demeter_physics::DVec3;
use demeter_physics::integrator::Integrator;

const TOLERANCE: f64 = 1e-4;

/// Material 0 is soft and light, material 1 hard and heavy.
fn materials(law: &str, restitution: f64) -> Materials {
    let list = [(7e10, 0.3, 2500.0), (2e11, 0.2, 7800.0)];
    let list = list.map(|(young_modulus, poisson_ratio, density)| Material {
        name: format!("{density}"),
        young_modulus,
        poisson_ratio,
        density,
    });
    let laws = match law {
        "linear" => cases::Laws::linear(2e7, restitution),
        _ => cases::Laws::hertz(restitution),
    };
    Materials::new(list.to_vec(), |_, _| laws.0.clone()).unwrap()
}

fn add(case: &mut Case, material: u16, radius: f64, position: DVec3, velocity: DVec3) {
    let grain = NewGrain {
        fixed: false,
        material,
        radius,
        density: case.materials.list()[material as usize].density,
        position,
        velocity,
        angular_velocity: DVec3::ZERO,
    };
    let id = case.grains.len() as u32 + 1;
    case.grains.push(id, &grain);
}

/// Two grains: radius and material of each.
type Pair = ((f64, u16), (f64, u16));

/// Restitution of a collision in which the line of centres makes `offset` with the direction of motion.
fn collide(
    integrator: Integrator,
    law: &str,
    restitution: f64,
    ((r1, m1), (r2, m2)): Pair,
    steps_to_touch: f64,
    offset: f64,
) -> f64 {
    let mut case = Case::new(materials(law, restitution));
    let n = DVec3::new((1.0 - offset * offset).sqrt(), offset, 0.0);
    // slow and hard, so that the line of centres turns by less than 1e-4 during an off-centre contact
    let v = DVec3::new(0.02, 0.0, 0.0);
    let dt = {
        add(&mut case, m1, r1, -n, v);
        add(&mut case, m2, r2, DVec3::ZERO, DVec3::ZERO);
        case.domain.lower = DVec3::splat(-2.0);
        let setup = case.setup();
        let (grains, dt) = (setup.grains.clone(), setup.dt);
        case = Case::new(setup.materials);
        case.grains = grains;
        dt
    };
    // first touch comes between two steps, at a phase of the step
    case.integrator = integrator;
    case.grains.position[0] = -n * (r1 + r2) - v * steps_to_touch * dt;
    let mut sim = case.simulation();
    run_until_parted(&mut sim);
    let (a, b) = (cases::index(&sim, 1), cases::index(&sim, 2));
    // without friction the impulse points along the mean normal of the contact, which turns a little during an
    // off-centre collision
    let after = sim.grains().velocity[a] - sim.grains().velocity[b];
    let normal = (after - v).normalize();
    -after.dot(normal) / v.dot(normal)
}

#[test]
fn two_grains_part_with_the_requested_restitution() {
    two_grains_part(Integrator::VelocityVerlet);
}

#[test]
fn two_grains_part_with_the_requested_restitution_with_gear() {
    two_grains_part(Integrator::Gear);
}

/// Contacts are looked for as grains were seen to move: what was foreseen for grains at rest is forgotten when they are set in motion.
#[test]
fn grains_that_are_set_in_motion_between_steps_part_with_the_requested_restitution() {
    set_in_motion(|sim, velocities| sim.set_velocities(velocities).unwrap());
    set_in_motion(|sim, velocities| {
        let rows = sim.grains_mut().velocity.iter_mut();
        rows.zip(velocities).for_each(|(velocity, &new)| *velocity = new);
    });
}

fn set_in_motion(set: impl Fn(&mut Simulation, &[DVec3]) + Sync) {
    on_threads(1, || {
        let (radius, gap, restitution) = (1e-3, 1e-5, 0.6);
        let at_rest = || {
            let mut case = Case::new(materials("hertz-tsuji", restitution));
            add(&mut case, 0, radius, DVec3::ZERO, DVec3::ZERO);
            add(&mut case, 0, radius, DVec3::X * (2.0 * radius + gap), DVec3::ZERO);
            case
        };
        let mut case = at_rest();
        let steps_to_touch = 20.0;
        let speed = gap / (steps_to_touch * at_rest().setup().dt);
        // others are as fast before, so that no bound of speeds tells of the change
        for side in [1.0, -1.0] {
            let velocity = DVec3::new(speed, speed, 0.0) * side;
            add(&mut case, 0, radius, DVec3::Y * (0.1 * side), velocity);
        }
        let mut sim = case.simulation();
        (0..3).for_each(|_| sim.step().unwrap());
        let velocity = |id| {
            if id == 1 {
                DVec3::X * speed
            } else {
                sim.grains().velocity[cases::index(&sim, id)]
            }
        };
        let velocities: Vec<DVec3> = sim.grains().id.iter().map(|&id| velocity(id)).collect();
        set(&mut sim, &velocities);
        run_until_parted(&mut sim);
        let (a, b) = (cases::index(&sim, 1), cases::index(&sim, 2));
        let found = (sim.grains().velocity[b].x - sim.grains().velocity[a].x) / speed;
        assert!((found - restitution).abs() < 1e-3, "{found}");
    });
}

#[test]
fn grains_that_begin_in_touch_part_with_the_requested_restitution() {
    let pair = ((1e-3, 0), (1e-3, 0));
    on_threads(1, || {
        for law in ["hertz-tsuji", "linear"] {
            for restitution in [0.95, 0.54, 0.05] {
                for steps in [0.0, 0.2, 0.45, 0.55] {
                    let found = collide(Integrator::VelocityVerlet, law, restitution, pair, steps, 0.0);
                    let error = (found - restitution).abs();
                    assert!(
                        error < TOLERANCE,
                        "{law}, e {restitution}, {steps} steps to touch: {found}"
                    );
                }
            }
        }
    });
}

fn two_grains_part(integrator: Integrator) {
    let pairs: [Pair; 3] = [((1e-3, 0), (1e-3, 0)), ((1e-3, 0), (3e-3, 1)), ((0.5e-3, 1), (5e-3, 0))];
    on_threads(1, || {
        let mut largest = 0.0f64;
        for law in ["hertz-tsuji", "linear"] {
            for restitution in [1.0, 0.95, 0.8, 0.5, 0.2, 0.05] {
                for pair in pairs {
                    for (phase, offset) in [(0.0, 0.0), (0.3, 0.0), (0.7, 0.6)] {
                        let found = collide(integrator, law, restitution, pair, 10.0 + phase, offset);
                        largest = largest.max((found - restitution).abs());
                        assert!(
                            (found - restitution).abs() < TOLERANCE,
                            "{law}, e {restitution}, {pair:?}, offset {offset}: {found}"
                        );
                    }
                }
            }
        }
        report("largest error between grains", largest);
    });
}

/// Walls of every shape that a grain of radius 2 mm falls on along -z, just before it touches at z = 0.
fn floors() -> Vec<(&'static str, Shape)> {
    let plane = Shape::Plane {
        point: DVec3::ZERO,
        normal: DVec3::Z,
    };
    let faces = Shape::Box {
        lower: DVec3::new(-0.1, -0.1, 0.0),
        upper: DVec3::splat(0.1),
        open: [false; 6],
    };
    let rectangle = Shape::Rectangle {
        center: DVec3::ZERO,
        half_u: DVec3::X * 0.1,
        half_v: DVec3::Y * 0.1,
    };
    let disc = Shape::Disc {
        center: DVec3::ZERO,
        normal: DVec3::Z,
        radius: 0.1,
    };
    let cylinder = |side, height: f64| Shape::Cylinder {
        start: DVec3::new(0.0, -0.1, height),
        end: DVec3::new(0.0, 0.1, height),
        radius: height.abs(),
        side,
    };
    let sphere = |side, height: f64| Shape::Sphere {
        center: DVec3::new(0.0, 0.0, height),
        radius: height.abs(),
        side,
    };
    let corners = [
        DVec3::new(-0.1, -0.1, 0.0),
        DVec3::new(0.1, -0.1, 0.0),
        DVec3::new(0.0, 0.1, 0.0),
    ];
    let triangle = Shape::Mesh {
        triangles: vec![corners],
    };
    vec![
        ("plane", plane),
        ("box face", faces),
        ("rectangle", rectangle),
        ("disc", disc),
        ("cylinder inside", cylinder(Side::Inside, 0.05)),
        ("cylinder outside", cylinder(Side::Outside, -0.05)),
        ("sphere inside", sphere(Side::Inside, 0.05)),
        ("sphere outside", sphere(Side::Outside, -0.05)),
        ("mesh triangle", triangle),
    ]
}

/// A grain of radius 2 mm that comes to a wall from a gap with the relative speed 0.3 m/s; the wall moves at `wall_speed`.
fn fall_on(
    integrator: Integrator,
    gap: f64,
    law: &str,
    restitution: f64,
    wall_material: u16,
    shape: Shape,
    wall_speed: f64,
) -> (f64, Simulation) {
    let mut case = Case::new(materials(law, restitution));
    case.integrator = integrator;
    let approach = 0.3;
    let v = DVec3::new(0.0, 0.0, wall_speed - approach);
    add(&mut case, 0, 2e-3, DVec3::Z * (2e-3 + gap), v);
    let motion = match wall_speed {
        0.0 => Motion::Rest,
        speed => Motion::Velocity(DVec3::Z * speed),
    };
    case.wall(wall_material, shape, motion);
    let mut sim = case.simulation();
    run_until_parted(&mut sim);
    ((sim.grains().velocity[0].z - wall_speed) / approach, sim)
}

/// Some steps before touch.
const GAP: f64 = 1.3e-6;

/// A wall that moves from the start against a grain at rest beside it.
#[test]
fn a_wall_of_any_shape_that_begins_in_touch_returns_the_requested_restitution() {
    on_threads(1, || {
        for law in ["hertz-tsuji", "linear"] {
            for restitution in [0.9, 0.5, 0.1] {
                for (name, shape) in floors() {
                    for gap in [0.0, 1e-9] {
                        let verlet = Integrator::VelocityVerlet;
                        let (found, _) = fall_on(verlet, gap, law, restitution, 0, shape.clone(), 0.3);
                        let error = (found - restitution).abs();
                        assert!(error < TOLERANCE, "{law}, e {restitution}, {name}, {gap} m: {found}");
                    }
                }
            }
        }
    });
}

#[test]
fn a_wall_of_any_shape_returns_the_requested_restitution() {
    walls_return(Integrator::VelocityVerlet);
}

#[test]
fn a_wall_of_any_shape_returns_the_requested_restitution_with_gear() {
    walls_return(Integrator::Gear);
}

fn walls_return(integrator: Integrator) {
    on_threads(1, || {
        let mut largest = 0.0f64;
        for law in ["hertz-tsuji", "linear"] {
            for restitution in [1.0, 0.9, 0.5, 0.1] {
                for wall_material in [0, 1] {
                    for wall_speed in [0.0, 0.7, -2.0] {
                        let (plane, _) = fall_on(
                            integrator,
                            GAP,
                            law,
                            restitution,
                            wall_material,
                            floors()[0].1.clone(),
                            wall_speed,
                        );
                        for (name, shape) in floors() {
                            let (found, sim) =
                                fall_on(integrator, GAP, law, restitution, wall_material, shape, wall_speed);
                            let label = format!("{law}, e {restitution}, {name} at {wall_speed} m/s");
                            largest = largest.max((found - restitution).abs());
                            assert!((found - restitution).abs() < TOLERANCE, "{label}: {found}");
                            // every wall is the same to the laws; only the rounding of the distance differs
                            assert!((found - plane).abs() < 1e-9, "{label}: {found}, plane {plane}");
                            let aside = sim.grains().velocity[0].truncate().length();
                            assert!(aside < 1e-12, "{label}: pushed aside at {aside} m/s");
                        }
                    }
                }
            }
        }
        report("largest error at walls", largest);
    });
}
