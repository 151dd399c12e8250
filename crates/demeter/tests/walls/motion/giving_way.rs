//! Walls that give way to the grain that hits them.

use super::*;
use crate::cases::law;

/// A grain that hits a plate that slides, or a blade that hangs, leaves with the restitution asked for, whatever the plate's mass.
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
            for hinged in [false, true] {
                let mut case = Case::new(one_material(5e6, laws));
                let lever = 20.0 * radius;
                case.grain(radius, DVec3::new(lever, 0.0, 1.05 * radius), DVec3::Z * -0.3);
                let mass = ratio * case.grains.mass(0);
                let freedom = if hinged {
                    Freedom::Hinge {
                        point: DVec3::ZERO,
                        axis: DVec3::Y,
                        center_of_mass: DVec3::X * lever,
                    }
                } else {
                    Freedom::Slide { axis: DVec3::Z }
                };
                let free = FreeMotion {
                    freedom,
                    inertia: if hinged { mass * lever * lever } else { mass },
                    weight: DVec3::ZERO,
                    stiffness: 0.0,
                    damping: 0.0,
                    speed: 0.0,
                    stops: [f64::NEG_INFINITY, f64::INFINITY],
                };
                let plate = Shape::Rectangle {
                    center: DVec3::X * lever,
                    half_u: DVec3::X * 5.0 * radius,
                    half_v: DVec3::Y * 5.0 * radius,
                };
                case.wall(0, plate, Motion::Free(free));
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
                // a blade turns a little on the way
                let tolerance = if hinged { 1e-3 } else { 1e-4 };
                assert!(
                    touched && (found - asked).abs() < tolerance,
                    "{ratio} {hinged}: {found} instead of {asked}"
                );
            }
        }
    }
}
