//! A sphere launched without spin ends rolling at 5/7 of its speed, whatever the friction and whatever it rolls on.

use crate::cases::{Case, G, Laws, full, hertz_overlap, index, law, mass, on_threads, one_material, report};
use demeter::simulation::Simulation;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;

const RADIUS: f64 = 5e-3;
const YOUNG_MODULUS: f64 = 1e8;
const SPEED: f64 = 0.2;

/// Floor in the plane z = 0.
fn floor(kind: &str) -> Shape {
    match kind {
        "plane" => Shape::Plane {
            point: DVec3::ZERO,
            normal: DVec3::Z,
        },
        "rectangle" => Shape::Rectangle {
            center: DVec3::ZERO,
            half_u: DVec3::X * 0.5,
            half_v: DVec3::Y * 0.3,
        },
        "mesh" => Shape::Mesh { triangles: seams() },
        _ => panic!("no floor `{kind}`"),
    }
}

/// Triangles of 7 x 4 mm, smaller than the grain, so that it crosses edges and corners all the time.
fn seams() -> Vec<[DVec3; 3]> {
    let corner = |i: i32, j: i32| DVec3::new(f64::from(i) * 7e-3, f64::from(j) * 4e-3, 0.0);
    let mut triangles = vec![];
    for i in -3..25 {
        for j in -6..12 {
            let [p, q, r, s] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
            triangles.extend([[p, q, r], [p, r, s]]);
        }
    }
    triangles
}

/// Launched along the seams at a small angle.
fn direction() -> DVec3 {
    DVec3::new(0.96, 0.28, 0.0)
}

fn launched(friction: &str, coefficient: f64, kind: &str) -> Simulation {
    let mut parameters = vec![("friction", coefficient)];
    if friction == "linear-history" {
        parameters.push(("stiffness", 1e5));
    }
    let laws = Laws::hertz(0.5).friction(law(friction, &parameters));
    let mut case = Case::new(one_material(YOUNG_MODULUS, &laws));
    let overlap = hertz_overlap(YOUNG_MODULUS, RADIUS, mass(RADIUS) * G);
    case.grain(RADIUS, DVec3::new(0.0, 0.0, RADIUS - overlap), direction() * SPEED);
    case.wall(0, floor(kind), Motion::Rest);
    case.gravity = DVec3::new(0.0, 0.0, -G);
    case.simulation()
}

/// Velocity of the sphere's surface where it touches the floor.
fn slip(sim: &Simulation) -> f64 {
    let (v, w, l) = (
        sim.grains().velocity[0],
        sim.grains().angular_velocity[0],
        sim.grains().position[0].z,
    );
    (v - w.cross(DVec3::Z * l)).dot(direction())
}

#[test]
fn ends_at_five_sevenths_after_the_time_of_theory() {
    let coefficients: &[f64] = if full() { &[0.05, 0.2, 0.5, 1.0] } else { &[0.2, 0.6] };
    on_threads(1, || {
        for friction in ["mindlin-history", "linear-history", "coulomb"] {
            for &mu in coefficients {
                for kind in ["plane", "rectangle", "mesh"] {
                    let mut sim = launched(friction, mu, kind);
                    let l = sim.grains().position[0].z;
                    // coulomb ends its slide by creeping, from the speed 7/2 mu g dt/f on, f = 0.16
                    let at_rest = if friction == "coulomb" {
                        25.0 * mu * G * sim.dt()
                    } else {
                        0.0
                    };
                    // 2 v0/(7 mu g) when the overlap is nothing
                    let theory = (SPEED - at_rest) / (mu * G * (1.0 + 2.5 * (l / RADIUS) * (l / RADIUS)));
                    while slip(&sim) > at_rest {
                        sim.step().unwrap();
                        assert!(sim.time() < 1.1 * theory, "{friction} {mu} {kind}: still slides");
                    }
                    let time = sim.time() / theory - 1.0;
                    while sim.time() < 1.1 * theory + 0.05 {
                        sim.step().unwrap();
                    }
                    // angular momentum about the floor: m v l + 2/5 m r^2 v/l = m v0 l
                    let expected = SPEED / (1.0 + 0.4 * (RADIUS / l) * (RADIUS / l));
                    let v = sim.grains().velocity[0];
                    let speed = v.length() / expected - 1.0;
                    let label = format!("{friction}, mu {mu}, {kind}");
                    report(&format!("{label}: time"), time);
                    report(&format!("{label}: speed"), speed);
                    assert!(time.abs() < 1e-4 + sim.dt() / theory, "{label}: {time}");
                    assert!(speed.abs() < 1e-9, "{label}: {speed}");
                    assert!((v.length() / (5.0 / 7.0 * SPEED) - 1.0).abs() < 1e-3);
                    assert!(
                        v.normalize().dot(direction()) > 1.0 - 1e-9,
                        "{label}: pushed aside to {v}"
                    );
                    assert!(slip(&sim).abs() < 1e-5 * SPEED, "{label}: {}", slip(&sim));
                }
            }
        }
    });
}

#[test]
fn seams_of_a_flat_mesh_are_not_felt() {
    let time = if full() { 0.4 } else { 0.05 };
    on_threads(1, || {
        for friction in ["mindlin-history", "linear-history", "coulomb"] {
            let runs = ["plane", "rectangle", "mesh"].map(|kind| {
                let mut sim = launched(friction, 0.4, kind);
                let mut places = vec![];
                while sim.time() < time {
                    sim.step().unwrap();
                    let k = index(&sim, 1);
                    places.push((
                        sim.grains().position[k],
                        sim.grains().velocity[k],
                        sim.grains().angular_velocity[k],
                    ));
                }
                places
            });
            for other in &runs[1..] {
                let mut largest = 0.0f64;
                for (a, b) in runs[0].iter().zip(other) {
                    let errors = [
                        (a.0 - b.0).length() / RADIUS,
                        (a.1 - b.1).length() / SPEED,
                        (a.2 - b.2).length() * RADIUS / SPEED,
                    ];
                    largest = errors.into_iter().fold(largest, f64::max);
                }
                report(&format!("{friction}: difference from the plane"), largest);
                assert!(largest < 1e-9, "{friction}: {largest}");
            }
            let travelled = runs[0].last().unwrap().0.x;
            assert!(travelled > 7e-3, "the grain crossed no seam: {travelled}");
        }
    });
}
