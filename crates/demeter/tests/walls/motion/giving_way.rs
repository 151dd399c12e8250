//! Walls that give way to the grain that hits them.

use super::*;
use crate::cases::law;
use demeter::walls::{BodyMass, BodyMotion, MassProperties, Side};
use glam::DMat3;

/// A grain that hits a plate that slides, a blade that hangs, or a free plate beside its centre, leaves with the restitution asked for,
/// whatever the plate's mass.
#[test]
fn restitution_is_that_asked_for_on_walls_that_give_way() {
    let radius = 1e-3;
    let laws = [
        Laws::linear(2e3, 0.4),
        Laws::hertz(0.6),
        Laws::of(law("walton-braun", &[("loading_stiffness", 2e3), ("restitution", 0.5)])),
    ];
    let asked = [0.4, 0.6, 0.5];
    for (laws, asked) in laws.iter().zip(asked) {
        for ratio in [0.3, 1.0, 20.0] {
            for kind in ["slides", "hangs", "is free"] {
                let mut case = Case::new(one_material(5e6, laws));
                let lever = 20.0 * radius;
                case.grain(radius, DVec3::new(lever, 0.0, 1.05 * radius), DVec3::Z * -0.3);
                let mass = ratio * case.grains.mass(0);
                let motion = plate_that(kind, mass, lever);
                let plate = Shape::Rectangle {
                    center: DVec3::X * lever,
                    half_u: DVec3::X * 5.0 * radius,
                    half_v: DVec3::Y * 5.0 * radius,
                };
                case.wall(0, plate, motion);
                let mut sim = case.simulation();
                let apart = |sim: &Simulation| {
                    let point = sim.grains().position[0] * DVec3::new(1.0, 1.0, 0.0);
                    sim.grains().velocity[0].z - sim.walls[0].velocity_at(point).z
                };
                let mut touched = false;
                for _ in 0..200_000 {
                    sim.step().unwrap();
                    let touches = sim.contacts.acting_walls() > 0;
                    if touched && !touches {
                        break;
                    }
                    touched |= touches;
                }
                let found = apart(&sim) / 0.3;
                // what turns does so a little on the way
                let tolerance = if kind == "slides" { 1e-4 } else { 1e-3 };
                assert!(
                    touched && (found - asked).abs() < tolerance,
                    "{ratio}, it {kind}: {found} instead of {asked}"
                );
            }
        }
    }
}

/// A spring that is told by how long a contact takes keeps the energy of a grain that grazes a ball which gives way: its stiffness stays,
/// though the mass with which the ball gives way changes with the normal.
#[test]
fn springs_told_by_what_they_do_keep_energy_at_walls_that_give_way() {
    let radius = 1e-3;
    let contact = [("contact_time", 2e-3), ("impact_speed", 0.5), ("restitution", 1.0)];
    let overlap = [("max_overlap", 4e-4), ("impact_speed", 0.5), ("restitution", 1.0)];
    let laws = [
        law("linear", &[contact[0], contact[2]]),
        law("linear", &overlap),
        law("hertz-tsuji", &contact),
    ];
    for law in laws {
        let name = format!("{law:?}");
        let mut case = Case::new(one_material(1e6, &Laws::of(law)));
        case.max_overlap = 0.4;
        case.grain(radius, DVec3::new(-1.7, 0.0, 1.3) * radius, DVec3::X * 0.6);
        let ball = Shape::Sphere {
            center: DVec3::ZERO,
            radius,
            side: Side::Outside,
        };
        let motion = plate_that("slides", 0.25 * case.grains.mass(0), 0.0);
        case.wall(0, ball, motion);
        let mut sim = case.simulation();
        let (mut largest, mut touched) = (0.0f64, false);
        while sim.time() < 8e-3 {
            sim.steps(20).unwrap();
            touched |= sim.contacts.acting_walls() > 0;
            largest = largest.max(sim.energies().residual.abs());
        }
        assert!(touched && sim.contacts.acting_walls() == 0, "{name}");
        assert!(
            sim.walls[0].velocity_at(DVec3::ZERO).z < -0.05,
            "{name}: the ball has moved"
        );
        assert!(largest < 1e-4, "{name}: {largest:e}");
    }
}

/// How a plate of a mass moves that slides along z, hangs on a hinge through the origin with its mass at a distance along x, or is free
/// with its centre of mass a quarter of that distance nearer.
fn plate_that(kind: &str, mass: f64, lever: f64) -> Motion {
    if kind == "is free" {
        let moment = mass * 0.01 * lever * lever;
        return Motion::Body(BodyMotion {
            mass: BodyMass::Told(MassProperties {
                mass,
                center: DVec3::X * 0.75 * lever,
                inertia: DMat3::from_diagonal(DVec3::new(1.0, 1.0, 2.0) * moment),
            }),
            gravity: DVec3::ZERO,
            velocity: DVec3::ZERO,
            angular_velocity: DVec3::ZERO,
            slides: [true; 3],
            turns: [true; 3],
        });
    }
    let hangs = kind == "hangs";
    Motion::Free(FreeMotion {
        freedom: if hangs {
            Freedom::Hinge {
                point: DVec3::ZERO,
                axis: DVec3::Y,
                center_of_mass: DVec3::X * lever,
            }
        } else {
            Freedom::Slide { axis: DVec3::Z }
        },
        inertia: if hangs { mass * lever * lever } else { mass },
        weight: DVec3::ZERO,
        stiffness: 0.0,
        damping: 0.0,
        speed: 0.0,
        stops: [f64::NEG_INFINITY, f64::INFINITY],
    })
}
