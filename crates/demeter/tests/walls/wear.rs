//! What walls record: wear of single contacts against exact results, sums against the books, stress against weights.

use crate::cases;

use crate::cases::{Case, G, Laws, hertz_overlap, law, mass, on_threads, one_material};
use demeter::contacts::Coupling;
use demeter::measure::{contact_records, wall_surfaces};
use demeter::simulation::Simulation;
use demeter::walls::{ElementRecord, Motion, MotionPart, Motions, Pace, Recording, Shape, Side, WearCoefficients};
use demeter_physics::DVec3;
use demeter_physics::integrator::Integrator;
use std::f64::consts::PI;

const MODULUS: f64 = 5e6;

const WEAR: Recording = Recording {
    stress: true,
    wear: Some(WearCoefficients {
        sliding: 2e-12,
        impact: 5e-12,
    }),
};

fn coulomb(friction: f64) -> demeter_physics::contact::LawChoice {
    law("coulomb", &[("friction", friction)])
}

/// A strip of triangles of 5 mm along x, in z = 0.
fn strip(squares: u32) -> Shape {
    let corner = |k: u32, y: f64| DVec3::new(5e-3 * f64::from(k), y, 0.0);
    let triangles = (0..squares).flat_map(|k| {
        let [a, b, c, d] = [
            corner(k, -0.01),
            corner(k + 1, -0.01),
            corner(k + 1, 0.01),
            corner(k, 0.01),
        ];
        [[a, b, c], [a, c, d]]
    });
    Shape::Mesh {
        triangles: triangles.collect(),
    }
}

/// A sphere that slides and begins to roll down an incline of 45 degrees, friction below 2/7: the slip grows as
/// `g (sin - 7/2 mu cos) t` (moment of inertia 2/5 m r^2), the normal force is `m g cos`.
#[test]
fn a_grain_that_slides_down_a_mesh_wears_it_as_archard_says() {
    on_threads(1, || {
        let (r, mu) = (1e-3, 0.2);
        let mut case = Case::new(one_material(MODULUS, &Laws::hertz(0.5).friction(coulomb(mu))));
        let along = G * 0.5f64.sqrt();
        case.gravity = DVec3::new(along, 0.0, -along);
        case.wall(0, strip(12), Motion::Rest);
        case.walls[0].record(WEAR);
        let load = mass(r) * along;
        let sunk = hertz_overlap(MODULUS, r, load);
        case.grain(r, DVec3::new(2e-3, 1e-3, r - sunk), DVec3::ZERO);
        let mut sim = case.simulation();
        let duration = 0.11;
        cases::advance(&mut sim, duration);
        let t = sim.time();
        // 7/2, but for the lever, which is shorter by the overlap
        let lever = 1.0 - sunk / r;
        let slid = 0.5 * along * (1.0 - mu * (1.0 + 2.5 * lever * lever)) * t * t;
        let expected = mu * load * slid;
        let [impact, sliding, volume] = sim.walls[0].wear();
        assert!((sliding / expected - 1.0).abs() < 1e-3, "{sliding} {expected}");
        assert!(impact < 1e-4 * sliding, "{impact}");
        assert!((volume / (2e-12 * load * slid) - 1.0).abs() < 1e-3, "{volume}");
        // what friction lost is there, triangle by triangle along the way
        let elements = sim.walls[0].element_records();
        let sum: f64 = elements.iter().map(|e| e.sliding_energy).sum();
        assert!((sum / sliding - 1.0).abs() < 1e-12);
        let booked = sim.energies().friction_dissipated;
        assert!((booked / sliding - 1.0).abs() < 1e-3, "{booked}");
        // place of the grain: a (t^2)/2 with a = g (sin - mu cos); energy per way grows as the slip over the speed, which is constant
        let end = 2e-3 + 0.5 * along * (1.0 - mu) * t * t;
        assert!((sim.grains().position[0].x / end - 1.0).abs() < 1e-3);
        // and the contact is told on one of the two triangles below it
        let [contact] = contact_records(&sim)[..] else { panic!() };
        assert_eq!(contact.element / 2, (end / 5e-3) as u32, "{contact:?}");
        for (square, pair) in elements.chunks(2).enumerate() {
            let (from, to) = (5e-3 * square as f64, 5e-3 * (square + 1) as f64);
            let share = (to.min(end) - from.max(2e-3)).max(0.0) / (end - 2e-3);
            let found = (pair[0].sliding_energy + pair[1].sliding_energy) / sliding;
            assert!((found - share).abs() < 3e-3, "square {square}: {found} {share}");
            let depth = pair[0].worn_volume / 5e-5;
            assert!((pair[0].wear_depth - depth).abs() <= 1e-12 * depth);
        }
    });
}

/// Without any weight: adhesion alone presses the surfaces together, and the energy that friction took tells load times way.
#[test]
fn a_grain_that_sticks_wears_the_floor_as_it_slides() {
    on_threads(1, || {
        let (r, friction, speed) = (1e-3, 0.2, 0.2);
        let rough = law("mindlin-history", &[("friction", friction)]);
        for normal in ["jkr", "dmt"] {
            let sticky = law(normal, &[("work_of_adhesion", 0.2), ("alpha", 0.5)]);
            let mut case = Case::new(one_material(MODULUS, &Laws::of(sticky).friction(rough.clone())));
            case.max_overlap = 0.3;
            case.wall(0, strip(12), Motion::Rest);
            case.walls[0].record(WEAR);
            // where adhesion and elasticity balance, by DMT
            let sunk = hertz_overlap(MODULUS, r, 2.0 * PI * r * 0.2);
            case.grain(r, DVec3::new(2e-3, 1e-3, r - sunk), DVec3::X * speed);
            let mut sim = case.simulation();
            cases::advance(&mut sim, 0.1);
            let [_, sliding, volume] = sim.walls[0].wear();
            // it slides until it rolls, which takes two sevenths of the energy
            let lost = mass(r) * speed * speed / 7.0;
            assert!((sliding / lost - 1.0).abs() < 0.05, "{normal}: {sliding} {lost}");
            let expected = 2e-12 * sliding / friction;
            assert!((volume / expected - 1.0).abs() < 1e-2, "{normal}: {volume} {expected}");
        }
    });
}

/// Energies and volume of a grain's oblique impact on a floor, at this friction; the floor wears by sliding only.
fn impact(friction: f64, tangential: &'static str) -> [f64; 3] {
    let mut values = vec![("friction", friction)];
    if tangential == "linear-history" {
        values.push(("stiffness", 5e3));
    }
    let laws = Laws::hertz(0.6).friction(law(tangential, &values));
    let mut case = Case::new(one_material(MODULUS, &laws));
    case.max_overlap = 0.2;
    case.wall(0, strip(2), Motion::Rest);
    case.walls[0].record(Recording {
        stress: false,
        wear: Some(WearCoefficients {
            sliding: 2e-12,
            impact: 0.0,
        }),
    });
    case.grain(2e-3, DVec3::new(5e-3, 1e-3, 2.2e-3), DVec3::new(0.05, 0.0, -0.3));
    let mut sim = case.simulation();
    cases::advance(&mut sim, 6e-3);
    assert!(sim.grains().velocity[0].z > 0.1 && sim.contacts.acting_walls() == 0);
    sim.walls[0].wear()
}

#[test]
fn an_impact_that_sticks_wears_nothing_and_one_that_slides_does_by_its_way() {
    on_threads(1, || {
        for tangential in ["linear-history", "mindlin-history", "mindlin-deresiewicz"] {
            let [_, sliding, volume] = impact(1000.0, tangential);
            assert!(sliding > 0.0 && volume == 0.0, "{tangential}: {sliding} {volume}");
        }
        for tangential in ["coulomb", "linear-history", "mindlin-history", "mindlin-deresiewicz"] {
            // friction is the same share of the normal force all the way, so the energy tells the slid load
            let mu = 0.01;
            let [_, sliding, volume] = impact(mu, tangential);
            let expected = 2e-12 * sliding / mu;
            assert!(
                (volume / expected - 1.0).abs() < 0.02,
                "{tangential}: {volume} {expected}"
            );
        }
    });
}

/// A grain under its weight on a plate that circles: it slides all the time, in a direction that turns.
fn circling(tangential: &'static str) -> [f64; 3] {
    let mut values = vec![("friction", 0.3)];
    if tangential == "linear-history" {
        values.push(("stiffness", 5e3));
    }
    let laws = Laws::hertz(0.6).friction(law(tangential, &values));
    let mut case = Case::new(one_material(MODULUS, &laws));
    case.gravity = DVec3::Z * -G;
    let swing = |amplitude: DVec3, phase: f64| MotionPart {
        motion: Motion::Oscillation {
            amplitude,
            frequency: 200.0,
            phase,
        },
        pace: Pace::FULL,
    };
    let parts = vec![swing(DVec3::X * 1e-3, 0.0), swing(DVec3::Y * 1e-3, 0.5 * PI)];
    case.wall(0, strip(2), Motions { parts });
    case.walls[0].record(Recording {
        stress: false,
        wear: Some(WearCoefficients {
            sliding: 2e-12,
            impact: 0.0,
        }),
    });
    let r = 2e-3;
    let sunk = hertz_overlap(MODULUS, r, mass(r) * G);
    case.grain(r, DVec3::new(5e-3, 1e-3, r - sunk), DVec3::ZERO);
    let mut sim = case.simulation();
    cases::advance(&mut sim, 0.01);
    sim.walls[0].wear()
}

#[test]
fn sliding_whose_direction_turns_wears_as_much_with_every_law() {
    on_threads(1, || {
        for tangential in ["coulomb", "linear-history", "mindlin-history", "mindlin-deresiewicz"] {
            let [_, sliding, volume] = circling(tangential);
            let expected = 2e-12 * sliding / 0.3;
            assert!(
                (volume / expected - 1.0).abs() < 0.01,
                "{tangential}: {volume} {expected}"
            );
            // about as fast as the plate, under the weight
            let way = 2.0 * PI * 200.0 * 1e-3 * 0.01;
            let load = mass(2e-3) * G * way;
            assert!((volume / (2e-12 * load) - 1.0).abs() < 0.05, "{tangential}: {volume}");
        }
    });
}

/// A grain that bounces about in a box of which one side is a mesh.
fn bouncing(integrator: Integrator, laws: &Laws) -> Simulation {
    let mut case = Case::new(one_material(MODULUS, laws));
    case.integrator = integrator;
    case.max_overlap = 0.3;
    let (lower, upper) = (DVec3::new(0.0, -0.01, -0.02), DVec3::new(0.03, 0.01, 0.01));
    let open = [false, false, false, false, true, false];
    case.wall(0, strip(6), Motion::Rest);
    case.wall(0, Shape::Box { lower, upper, open }, Motion::Rest);
    case.walls.iter_mut().for_each(|wall| wall.record(WEAR));
    let spin = DVec3::new(50.0, -100.0, 30.0);
    case.spinning_grain(1e-3, DVec3::new(0.01, 2e-3, 5e-3), DVec3::new(0.7, 0.4, -0.9), spin);
    case.simulation()
}

#[test]
fn what_walls_record_is_what_the_books_lost() {
    let history = || law("mindlin-history", &[("friction", 0.3)]);
    let plain = Laws::hertz(0.8).friction(history());
    let plastic = Laws::of(law(
        "luding",
        &[
            ("loading_stiffness", 500.0),
            ("unloading_stiffness", 1000.0),
            ("adhesion_stiffness", 50.0),
            ("plastic_depth", 0.05),
        ],
    ));
    on_threads(1, || {
        for integrator in [Integrator::VelocityVerlet, Integrator::Gear] {
            for laws in [&plain, &plastic.clone().friction(history())] {
                let mut sim = bouncing(integrator, laws);
                let mut bounces = 0;
                let mut touching = false;
                for _ in 0..2_000_000 {
                    sim.step().unwrap();
                    let touches = sim.contacts.acting_walls() > 0;
                    bounces += u32::from(touching && !touches);
                    touching = touches;
                    if bounces == 8 && sim.contacts.wall_count() == 0 {
                        break;
                    }
                }
                sim.step().unwrap();
                assert!(bounces >= 8, "{bounces}");
                let e = sim.energies();
                let totals = sim
                    .walls
                    .iter()
                    .map(|w| w.wear())
                    .fold([0.0; 3], |a, b| [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
                let normal = e.viscous_dissipated + e.plastic_dissipated;
                assert!((totals[0] / normal - 1.0).abs() < 1e-9, "{totals:?} {e:?}");
                assert!(
                    (totals[1] / e.friction_dissipated - 1.0).abs() < 1e-9,
                    "{totals:?} {e:?}"
                );
                assert!(e.friction_dissipated > 0.0 && totals[2] > 0.0);
                assert!(sim.walls.iter().all(|wall| wall.wear()[0] > 0.0));
                // what is drawn of a wall adds up to it, however many triangles an element has
                for (wall, drawn) in sim.walls.iter().zip(wall_surfaces(&sim)) {
                    let records = drawn.records.unwrap();
                    let sum = |of: fn(&ElementRecord) -> f64| records.iter().map(of).sum::<f64>();
                    let sums = [
                        sum(|r| r.impact_energy),
                        sum(|r| r.sliding_energy),
                        sum(|r| r.worn_volume),
                    ];
                    for (sum, whole) in sums.into_iter().zip(wall.wear()) {
                        assert!((sum - whole).abs() <= 1e-12 * whole, "{}: {sum} {whole}", wall.name);
                    }
                }
            }
        }
    });
}

#[test]
fn stress_is_weight_over_area() {
    on_threads(1, || {
        let mut case = Case::new(one_material(MODULUS, &Laws::hertz(0.3).friction(coulomb(0.5))));
        case.gravity = DVec3::Z * -G;
        case.wall(0, strip(2), Motion::Rest);
        case.walls[0].record(Recording {
            stress: true,
            wear: None,
        });
        let r = 1e-3;
        let sunk = hertz_overlap(MODULUS, r, mass(r) * G);
        // below the diagonal of the second square
        case.grain(r, DVec3::new(8e-3, -5e-3, r - sunk), DVec3::ZERO);
        let mut sim = case.simulation();
        cases::advance(&mut sim, 0.01);
        sim.walls[0].begin_interval();
        cases::advance(&mut sim, 0.01);
        let elements = sim.walls[0].element_records();
        let weight = mass(r) * G;
        for (k, element) in elements.iter().enumerate() {
            let expected = if k == 2 { weight } else { 0.0 };
            assert!((element.force.z + expected).abs() < 1e-3 * weight, "{k}: {element:?}");
            assert!((element.pressure - expected / 5e-5).abs() < 1e-3 * weight / 5e-5);
            assert!(element.shear_stress < 1e-6 * weight / 5e-5);
        }
        sim.walls[0].begin_interval();
        assert_eq!(sim.walls[0].element_records()[2].force, DVec3::ZERO);
    });
}

/// The mean was taken in the frame of the wall: over half a turn 2/pi of the weight, and across.
#[test]
fn the_mean_force_on_a_drum_that_turns_is_that_in_the_world() {
    on_threads(1, || {
        let mut case = Case::new(one_material(MODULUS, &Laws::hertz(0.3)));
        case.gravity = DVec3::Z * -G;
        let drum = Shape::Cylinder {
            start: DVec3::Y * -0.01,
            end: DVec3::Y * 0.01,
            radius: 5e-3,
            side: Side::Inside,
        };
        let turning = Motion::Rotation {
            point: DVec3::ZERO,
            axis: DVec3::Y,
            angular_velocity: 50.0 * PI,
        };
        case.wall(0, drum, turning);
        case.walls[0].record(Recording {
            stress: true,
            wear: None,
        });
        let (r, weight) = (1e-3, mass(1e-3) * G);
        case.grain(r, DVec3::Z * (r - 5e-3), DVec3::ZERO);
        let mut sim = case.simulation();
        cases::advance(&mut sim, 0.02);
        sim.walls[0].begin_interval();
        cases::advance(&mut sim, 0.02);
        let found = sim.walls[0].element_records()[0].force;
        assert!((found + DVec3::Z * weight).length() < 0.01 * weight, "{found} {weight}");
    });
}

#[test]
fn the_velocity_of_a_surface_is_told_triangle_by_triangle() {
    let middle = |[a, b, c]: &[DVec3; 3]| (*a + *b + *c) / 3.0;
    let turning = Motion::Rotation {
        point: DVec3::X,
        axis: DVec3::Z,
        angular_velocity: 2.0,
    };
    let turns = |triangle: &[DVec3; 3]| 2.0 * DVec3::Z.cross(middle(triangle) - DVec3::X);
    let drawn = |motion: Motion| {
        let mut case = Case::new(one_material(MODULUS, &Laws::hertz(0.3)));
        case.wall(0, strip(2), motion);
        case.grain(1e-3, DVec3::Z, DVec3::ZERO);
        let mut sim = case.simulation();
        cases::advance(&mut sim, 0.01);
        let drawn = wall_surfaces(&sim).remove(0);
        assert_eq!(drawn.velocities.len(), drawn.triangles.len());
        drawn.triangles.into_iter().zip(drawn.velocities)
    };
    for (triangle, velocity) in drawn(turning) {
        assert!((velocity - turns(&triangle)).length() < 1e-12, "{velocity}");
    }
    for (_, velocity) in drawn(Motion::Belt(DVec3::new(1.0, 0.0, 1.0))) {
        assert_eq!(velocity, DVec3::X);
    }
}

#[test]
fn coupled_contacts_are_recorded_once() {
    on_threads(1, || {
        let laws = Laws::hertz(0.5).friction(coulomb(0.3)).multi_contact("half-space", &[]);
        let mut case = Case::new(one_material(MODULUS, &laws));
        case.coupling = Coupling::default();
        case.gravity = DVec3::Z * -G;
        case.wall(0, strip(2), Motion::Rest);
        case.walls[0].record(WEAR);
        case.grain(1e-3, DVec3::new(4e-3, 0.0, 3e-3), DVec3::new(0.3, 0.0, 0.0));
        let mut sim = case.simulation();
        cases::run_until_parted(&mut sim);
        sim.step().unwrap();
        let (e, [impact, sliding, _]) = (sim.energies(), sim.walls[0].wear());
        assert!((impact / (e.viscous_dissipated + e.plastic_dissipated) - 1.0).abs() < 1e-9);
        assert!((sliding / e.friction_dissipated - 1.0).abs() < 1e-9, "{sliding} {e:?}");
    });
}
