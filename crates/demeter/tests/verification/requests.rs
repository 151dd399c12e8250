//! What a scenario asks of a damped spring is what the engine shows: every way of asking for stiffness and damping, both
//! ends of contact, restitution that depends on the speed; equal and unequal grains, a plane, a mesh.

use crate::cases;

use crate::cases::{Case, Laws, law, on_threads, report};
use demeter::materials::{Material, Materials};
use demeter::particles::NewGrain;
use demeter::walls::{Motion, Shape};
use demeter_physics::DVec3;
use demeter_physics::contact::LawChoice;
use demeter_physics::parameters::Value;

/// Asked of the engine at the automatic time step.
const TOLERANCE: f64 = 1e-3;

/// What is hit.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Target {
    Grain { radius: f64 },
    Plane,
    Mesh,
}

const TARGETS: [Target; 4] = [
    Target::Grain { radius: 1e-3 },
    Target::Grain { radius: 6e-3 },
    Target::Plane,
    Target::Mesh,
];

/// What a head-on impact showed.
struct Seen {
    restitution: f64,
    max_overlap: f64,
    contact_time: f64,
    least_force: f64,
}

/// A grain of radius 1 mm hits the target at rest at `speed`; `phase` is where within a step they touch.
fn collide(choice: &LawChoice, target: Target, speed: f64, phase: f64) -> Seen {
    let list = [(5e9, 0.3, 2500.0), (2e11, 0.2, 7800.0)].map(|(young_modulus, poisson_ratio, density)| Material {
        name: format!("{density}"),
        young_modulus,
        poisson_ratio,
        density,
    });
    let build = |case: &mut Case, height: f64| {
        let mut add = |material: u16, radius: f64, z: f64, v: f64| {
            let grain = NewGrain {
                fixed: false,
                material,
                radius,
                density: list[material as usize].density,
                position: DVec3::Z * z,
                velocity: DVec3::Z * v,
                angular_velocity: DVec3::ZERO,
            };
            let id = case.grains.len() as u32 + 1;
            case.grains.push(id, &grain);
        };
        add(0, 1e-3, 1e-3 + height, -speed);
        match target {
            Target::Grain { radius } => add(1, radius, -radius, 0.0),
            Target::Plane => case.plane(1, DVec3::ZERO, DVec3::Z),
            Target::Mesh => {
                let corner = |x: f64, y: f64| DVec3::new(0.05 * x, 0.05 * y, 0.0);
                let triangles = vec![
                    [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0)],
                    [corner(-1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)],
                ];
                case.wall(1, Shape::Mesh { triangles }, Motion::Rest);
            }
        }
    };
    let case = |height: f64| {
        let laws = Laws::of(choice.clone());
        let mut case = Case::new(Materials::new(list.to_vec(), |_, _| laws.0.clone()).unwrap());
        build(&mut case, height);
        case
    };
    let dt = case(0.0).setup().dt;
    let mut sim = case(speed * dt * (3.0 + phase)).simulation();
    let mut seen = Seen {
        restitution: 0.0,
        max_overlap: 0.0,
        contact_time: 0.0,
        least_force: f64::INFINITY,
    };
    for _ in 0..200_000 {
        sim.step().unwrap();
        let chunks = || sim.contacts.pairs.iter().chain(&sim.contacts.walls);
        if let Some(chunk) = chunks().find(|chunk| chunk.engaged() > 0) {
            let (overlap, force) = (sim.contact(chunk, 0).overlap, chunk.normal_force(0));
            seen.max_overlap = seen.max_overlap.max(overlap);
            seen.least_force = seen.least_force.min(force);
            // a force acts from half a step before its moment to half a step after
            seen.contact_time += if force != 0.0 { sim.dt() } else { 0.0 };
        } else if seen.max_overlap > 0.0 {
            let relative = match target {
                Target::Grain { .. } => {
                    let z = |id| sim.grains().velocity[cases::index(&sim, id)].z;
                    z(1) - z(2)
                }
                _ => sim.grains().velocity[0].z,
            };
            seen.restitution = relative / speed;
            return seen;
        }
    }
    panic!(
        "{choice:?} on {target:?} at {speed} m/s: the bodies never parted; {:?}",
        sim.grains().velocity
    );
}

fn at_zero_force(mut choice: LawChoice) -> LawChoice {
    choice
        .parameters
        .insert("contact_end".to_string(), Value::from("zero-force"));
    choice
}

#[test]
fn contact_may_end_at_zero_force_without_a_pull() {
    on_threads(1, || {
        let mut largest = 0.0f64;
        for e in [1.0, 0.9, 0.54, 0.3, 0.1, 0.02] {
            for choice in [
                law("hertz-tsuji", &[("restitution", e)]),
                law("linear", &[("stiffness", 1e6), ("restitution", e)]),
            ] {
                let choice = at_zero_force(choice);
                for target in TARGETS {
                    for phase in [0.0, 0.37] {
                        let seen = collide(&choice, target, 0.2, phase);
                        largest = largest.max((seen.restitution - e).abs());
                        let label = format!("{} {e} {target:?}", choice.law);
                        assert!(
                            (seen.restitution - e).abs() < TOLERANCE,
                            "{label}: {}",
                            seen.restitution
                        );
                        assert!(seen.least_force >= 0.0, "{label}: it pulls with {} N", seen.least_force);
                    }
                }
            }
        }
        report("zero force, largest error of the restitution", largest);
    });
}

#[test]
fn stiffness_follows_from_contact_time_and_from_overlap() {
    on_threads(1, || {
        let (mut times, mut overlaps) = (0.0f64, 0.0f64);
        for name in ["linear", "hertz-tsuji"] {
            for e in [1.0, 0.6, 0.2] {
                let base = [("restitution", e), ("impact_speed", 0.2)];
                for end in ["zero-overlap", "zero-force"] {
                    for target in TARGETS {
                        let ask = |more: (&str, f64)| {
                            let mut choice = law(name, &[base[0], base[1], more]);
                            choice.parameters.insert("contact_end".to_string(), Value::from(end));
                            collide(&choice, target, 0.2, 0.4)
                        };
                        let (timed, deep) = (ask(("contact_time", 2e-5)), ask(("max_overlap", 3e-6)));
                        let errors = [timed.contact_time / 2e-5 - 1.0, deep.max_overlap / 3e-6 - 1.0];
                        (times, overlaps) = (times.max(errors[0].abs()), overlaps.max(errors[1].abs()));
                        let label = format!("{name} {e} {end} {target:?}");
                        for seen in [&timed, &deep] {
                            assert!(
                                (seen.restitution - e).abs() < TOLERANCE,
                                "{label}: {}",
                                seen.restitution
                            );
                        }
                        // time and overlap are seen at whole steps only
                        assert!(errors[0].abs() < 1.5e-2, "{label}: contact time off by {:e}", errors[0]);
                        assert!(errors[1].abs() < 2e-3, "{label}: overlap off by {:e}", errors[1]);
                    }
                }
            }
        }
        report("largest error of the contact time, seen in whole steps", times);
        report("largest error of the overlap", overlaps);
    });
}

#[test]
fn a_restitution_that_depends_on_the_speed_is_met_at_every_speed() {
    let rows = [[0.01, 0.95], [0.1, 0.9], [1.0, 0.6], [5.0, 0.2]];
    on_threads(1, || {
        let mut largest = 0.0f64;
        for name in ["linear", "hertz-tsuji"] {
            let base: &[(&str, f64)] = if name == "linear" { &[("stiffness", 1e6)] } else { &[] };
            for end in ["zero-overlap", "zero-force"] {
                let with = |value: Value| {
                    let mut choice = law(name, base);
                    choice.parameters.insert("restitution".to_string(), value);
                    choice.parameters.insert("contact_end".to_string(), Value::from(end));
                    choice
                };
                let table = with(Value::Table(rows.to_vec()));
                let formula = with(Value::from("0.9 * exp(-v/2)"));
                for target in TARGETS {
                    for [speed, e] in rows {
                        let asked = [(&table, e), (&formula, 0.9 * libm::exp(-speed / 2.0))];
                        for (choice, e) in asked {
                            let found = collide(choice, target, speed, 0.2).restitution;
                            largest = largest.max((found - e).abs());
                            assert!(
                                (found - e).abs() < TOLERANCE,
                                "{name} {end} {target:?} at {speed} m/s: {found}, not {e}"
                            );
                        }
                    }
                }
            }
        }
        report("profile, largest error of the restitution", largest);
    });
}

#[test]
fn viscoelastic_grains_part_with_the_restitution_asked_at_the_speed() {
    on_threads(1, || {
        let mut largest = 0.0f64;
        for e in [0.95, 0.6, 0.2] {
            let choice = law("viscoelastic", &[("restitution", e), ("impact_speed", 0.5)]);
            let mut pulling = choice.clone();
            pulling
                .parameters
                .insert("contact_end".to_string(), Value::from("zero-overlap"));
            for target in TARGETS {
                for choice in [&choice, &pulling] {
                    let found = collide(choice, target, 0.5, 0.6).restitution;
                    largest = largest.max((found - e).abs());
                    assert!((found - e).abs() < TOLERANCE, "{e} {target:?}: {found}");
                    let slower = collide(choice, target, 0.05, 0.6).restitution;
                    assert!(slower > found, "{e} {target:?}: {slower} at a tenth of the speed");
                }
            }
        }
        report("viscoelastic, largest error of the restitution", largest);
    });
}
