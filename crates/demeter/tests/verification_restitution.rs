//! Head-on, off-centre and wall collisions give the requested restitution within 1e-4 at the automatic time step.

use demeter::contacts::Fault;
use demeter::materials::{Material, Materials, PairChoice};
use demeter::particles::{Domain, Grains, NewGrain, Outside};
use demeter::simulation::{SAFE_SHARE, Setup, Simulation, shortest_time_scale};
use demeter::walls::{Motion, Shape, Wall};
use demeter_physics::DVec3;
use demeter_physics::contact::LawChoice;

const TOLERANCE: f64 = 1e-4;
const MAX_OVERLAP: f64 = 0.05;

fn materials(law: &str, restitution: f64) -> Materials {
    let soft = Material {
        name: "soft".into(),
        young_modulus: 7e10,
        poisson_ratio: 0.3,
        density: 2500.0,
    };
    let hard = Material {
        name: "hard".into(),
        young_modulus: 2e11,
        poisson_ratio: 0.2,
        density: 7800.0,
    };
    let mut parameters = [("restitution".to_string(), restitution)]
        .into_iter()
        .collect::<std::collections::BTreeMap<_, _>>();
    if law == "linear" {
        parameters.insert("stiffness".into(), 2e7);
    }
    let choice = PairChoice {
        normal: LawChoice {
            law: law.into(),
            parameters,
        },
        tangential: None,
        rolling: None,
    };
    Materials::new(vec![soft, hard], |_, _| choice.clone()).unwrap()
}

fn setup(grains: Grains, walls: Vec<Wall>, materials: Materials) -> Setup {
    let wall_materials: Vec<u16> = walls.iter().map(|w| w.material).collect();
    let scale = shortest_time_scale(&grains, &wall_materials, &materials, MAX_OVERLAP).unwrap();
    Setup {
        grains,
        walls,
        materials,
        domain: Domain {
            lower: DVec3::splat(-1.0),
            upper: DVec3::splat(1.0),
            periodic: [false; 3],
            outside: Outside::Stop,
        },
        gravity: DVec3::ZERO,
        dt: SAFE_SHARE * scale.time,
        skin: 1e-4,
        max_overlap: MAX_OVERLAP,
    }
}

fn grain(material: u16, radius: f64, position: DVec3, velocity: DVec3) -> NewGrain {
    let density = if material == 0 { 2500.0 } else { 7800.0 };
    NewGrain {
        material,
        radius,
        density,
        position,
        velocity,
        angular_velocity: DVec3::ZERO,
    }
}

fn run_until_parted(setup: Setup) -> Result<Simulation, Fault> {
    let mut sim = Simulation::new(setup);
    let mut touched = false;
    for _ in 0..100_000 {
        sim.step()?;
        let contacts = sim.contacts.pair_count() + sim.contacts.wall_count();
        touched |= contacts > 0;
        if touched && contacts == 0 {
            return Ok(sim);
        }
    }
    panic!("the collision never ended");
}

#[test]
fn two_grains_part_with_the_requested_restitution() {
    for law in ["hertz-tsuji", "linear"] {
        for restitution in [1.0, 0.95, 0.8, 0.5, 0.2, 0.05] {
            for (r1, m1, r2, m2) in [(1e-3, 0, 1e-3, 0), (1e-3, 0, 3e-3, 1), (0.5e-3, 1, 5e-3, 0)] {
                for (phase, offset) in [(0.0, 0.0), (0.3, 0.0), (0.7, 0.6)] {
                    let mut grains = Grains::default();
                    let reach = r1 + r2;
                    let n = DVec3::new((1.0f64 - offset * offset).sqrt(), offset, 0.0);
                    // slow and hard, so that the line of centres turns by less than 1e-4 during an off-centre contact
                    let v = DVec3::new(0.02, 0.0, 0.0);
                    grains.push(1, &grain(m1, r1, -n * reach - v * (5.0 + phase) * 1e-5, v));
                    grains.push(2, &grain(m2, r2, DVec3::ZERO, DVec3::ZERO));
                    let sim = run_until_parted(setup(grains, vec![], materials(law, restitution))).unwrap();
                    let index = |id: u32| sim.grains.id.iter().position(|&i| i == id).unwrap();
                    let (a, b) = (index(1), index(2));
                    // without friction the impulse points along the mean normal of the contact, which turns a little
                    // during an off-centre collision
                    let after = sim.grains.velocity[a] - sim.grains.velocity[b];
                    let normal = (after - v).normalize();
                    let realised = -after.dot(normal) / v.dot(normal);
                    assert!(
                        (realised - restitution).abs() < TOLERANCE,
                        "{law}, e {restitution}, radii {r1} {r2}, offset {offset}: {realised}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_wall_returns_the_requested_restitution() {
    for law in ["hertz-tsuji", "linear"] {
        for restitution in [1.0, 0.9, 0.5, 0.1] {
            for wall_material in [0, 1] {
                let mut grains = Grains::default();
                let v = DVec3::new(0.0, 0.0, -0.3);
                grains.push(1, &grain(0, 2e-3, DVec3::new(0.0, 0.0, 2.0013e-3), v));
                let floor = Shape::Plane {
                    point: DVec3::ZERO,
                    normal: DVec3::Z,
                };
                let wall = Wall::new("floor", wall_material, floor, Motion::Rest).unwrap();
                let sim = run_until_parted(setup(grains, vec![wall], materials(law, restitution))).unwrap();
                let realised = -sim.grains.velocity[0].z / v.z;
                assert!(
                    (realised - restitution).abs() < TOLERANCE,
                    "{law} e {restitution}: {realised}"
                );
            }
        }
    }
}
