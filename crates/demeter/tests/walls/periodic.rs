//! Walls across periodic sides: those that are no longer than the box are felt as if they were repeated with it.

use crate::cases::{self, Case, Laws, hertz_overlap, law, mass, on_threads, one_material};
use demeter::particles::Domain;
use demeter::walls::{Drift, Motion, Motions, Recording, Shape, Side, Wall};
use demeter_physics::DVec3;

const MODULUS: f64 = 5e6;
const RADIUS: f64 = 2e-3;
/// The box along x and y.
const SIZE: f64 = 0.04;

/// A rolling grain over a floor in a box that is periodic in x and y.
fn rolling(shape: Shape, motion: Motion, drift: Drift) -> Case {
    let friction = law("coulomb", &[("friction", 0.5)]);
    let mut case = Case::new(one_material(MODULUS, &Laws::hertz(0.5).friction(friction)));
    case.domain = Domain {
        lower: DVec3::new(0.0, 0.0, -0.01),
        upper: DVec3::new(SIZE, SIZE, 0.04),
        periodic: [true, true, false],
        ..case.domain
    };
    case.gravity = DVec3::new(0.0, 0.0, -cases::G);
    case.wall(0, shape, motion);
    case.walls[0].repeat(&case.domain, [drift; 3]).unwrap();
    let sunk = hertz_overlap(MODULUS, RADIUS, mass(RADIUS) * cases::G);
    let place = DVec3::new(0.8 * SIZE, 0.9 * SIZE, RADIUS - sunk);
    case.spinning_grain(
        RADIUS,
        place,
        DVec3::new(0.35, 0.11, 0.0),
        DVec3::new(-0.11, 0.35, 0.0) / RADIUS,
    );
    case
}

/// Squares of the whole floor, each of two triangles.
fn floor(squares: u32) -> Shape {
    let at = |k: u32| SIZE * f64::from(k) / f64::from(squares);
    let mut triangles = Vec::new();
    for (i, j) in (0..squares).flat_map(|i| (0..squares).map(move |j| (i, j))) {
        let corner = |i, j| DVec3::new(at(i), at(j), 0.0);
        let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
        triangles.extend([[a, b, c], [a, c, d]]);
    }
    Shape::Mesh { triangles }
}

/// The floor as a plate.
fn plate() -> Shape {
    let half = 0.5 * SIZE;
    Shape::Rectangle {
        center: DVec3::new(half, half, 0.0),
        half_u: DVec3::new(half, 0.0, 0.0),
        half_v: DVec3::new(0.0, half, 0.0),
    }
}

/// A box open at the sides.
fn channel() -> Shape {
    Shape::Box {
        lower: DVec3::ZERO,
        upper: DVec3::splat(SIZE),
        open: [true, true, true, true, false, true],
    }
}

#[test]
fn a_grain_rolls_over_the_seam_of_a_floor_as_long_as_the_box_and_feels_none() {
    on_threads(1, || {
        let plane = Shape::Plane {
            point: DVec3::ZERO,
            normal: DVec3::Z,
        };
        let mut on_plane = rolling(plane, Motion::Rest, Drift::None).simulation();
        cases::advance(&mut on_plane, 0.15);
        let crossings = 0.35 * 0.15 / SIZE;
        assert!(crossings > 1.0);
        for (what, shape) in [
            ("mesh", floor(4)),
            ("two triangles", floor(1)),
            ("plate", plate()),
            ("box", channel()),
        ] {
            let mut sim = rolling(shape, Motion::Rest, Drift::None).simulation();
            cases::advance(&mut sim, 0.15);
            let (found, expected) = (sim.grains(), on_plane.grains());
            let off = (found.position[0] - expected.position[0]).length();
            assert!(off < 1e-9 * RADIUS, "{what}: {off}");
            let off = (found.velocity[0] - expected.velocity[0]).length();
            assert!(off < 1e-9, "{what}: {off}");
            assert!(found.velocity[0].z.abs() < 1e-9, "{what}");
        }
    });
}

/// Grain and floor move along x by more than half of the box.
#[test]
fn a_floor_that_moves_along_the_box_lacks_nothing_for_three_quarters_of_it() {
    on_threads(1, || {
        for shape in [floor(4), plate()] {
            let belt = Motion::Velocity(DVec3::new(0.35, 0.0, 0.0));
            let mut sim = rolling(shape, belt, Drift::Along).simulation();
            cases::advance(&mut sim, 0.7 * SIZE / 0.35);
            let grain = sim.grains();
            assert!(grain.velocity[0].z.abs() < 1e-6 && grain.position[0].z > 0.9 * RADIUS);
        }
    });
}

/// A grain that falls beside an obstacle does the same wherever the box is cut.
#[test]
fn an_obstacle_at_a_periodic_side_is_felt_behind_it() {
    on_threads(1, || {
        let obstacles: [fn(DVec3) -> Shape; 5] = [
            |at| Shape::Sphere {
                center: at,
                radius: 4e-3,
                side: Side::Outside,
            },
            |at| Shape::Cylinder {
                start: at - DVec3::new(0.0, 5e-3, 0.0),
                end: at + DVec3::new(0.0, 5e-3, 0.0),
                radius: 3e-3,
                side: Side::Outside,
            },
            |at| Shape::Disc {
                center: at,
                normal: DVec3::new(0.6, 0.0, 0.8),
                radius: 5e-3,
            },
            |at| Shape::Rectangle {
                center: at,
                half_u: DVec3::new(4e-3, 0.0, -3e-3),
                half_v: DVec3::new(0.0, 5e-3, 0.0),
            },
            |at| {
                let corner = |x: f64, y: f64, z: f64| at + DVec3::new(x, y, z) * 1e-3;
                let top = corner(0.0, 0.0, 3.0);
                let [a, b, c] = [corner(-5.0, -4.0, 0.0), corner(5.0, -4.0, 0.0), corner(0.0, 5.0, 0.0)];
                Shape::Mesh {
                    triangles: vec![[a, b, top], [b, c, top], [c, a, top]],
                }
            },
        ];
        for (k, obstacle) in obstacles.iter().enumerate() {
            let fall = |at: DVec3, beside: DVec3| {
                let mut case = rolling(obstacle(at), Motion::Rest, Drift::None);
                case.domain.lower.z = -0.04;
                case.grains = demeter::particles::Grains::default();
                let whole = DVec3::new(SIZE, SIZE, 0.0);
                let place = (at + beside) - whole * ((at + beside) / SIZE).floor();
                case.grain(RADIUS, place, DVec3::ZERO);
                let mut sim = case.simulation();
                cases::advance(&mut sim, 0.06);
                let way = sim.domain().difference(sim.grains().position[0], at + beside);
                (way, sim.grains().velocity[0])
            };
            let middle = DVec3::new(0.5 * SIZE, 0.5 * SIZE, 0.0);
            for beside in [DVec3::new(1.5e-3, 1e-3, 0.012), DVec3::new(-1.5e-3, -1e-3, 0.012)] {
                let (way, velocity) = fall(middle, beside);
                // pushed aside, not only fallen
                assert!(way.x.abs() > 1e-4, "{k}: {way}");
                for at in [
                    DVec3::ZERO,
                    DVec3::new(SIZE, 0.5 * SIZE, 0.0),
                    DVec3::new(1e-3, SIZE - 1e-3, 0.0),
                ] {
                    let (other_way, other_velocity) = fall(at, beside);
                    assert!((other_way - way).length() < 1e-8, "{k} {at}: {way} {other_way}");
                    assert!((other_velocity - velocity).length() < 1e-6, "{k} {at}");
                }
            }
        }
    });
}

#[test]
fn what_happens_on_a_copy_is_told_of_the_triangle_that_it_is_a_copy_of() {
    on_threads(1, || {
        let mut case = rolling(floor(4), Motion::Rest, Drift::None);
        case.walls[0].record(Recording {
            stress: true,
            wear: None,
        });
        let drawn = case.walls[0].triangles(DVec3::ZERO, DVec3::ONE);
        assert_eq!(drawn.len(), 32);
        assert_eq!(case.walls[0].bounds(), Some((DVec3::ZERO, DVec3::new(SIZE, SIZE, 0.0))));
        // it rests above the corner of the box, on copies but for a little
        case.grains = demeter::particles::Grains::default();
        let sunk = hertz_overlap(MODULUS, RADIUS, mass(RADIUS) * cases::G);
        case.grain(
            RADIUS,
            DVec3::new(SIZE - 1e-9, SIZE - 1e-9, RADIUS - sunk),
            DVec3::new(1e-6, 1e-6, 0.0),
        );
        let mut sim = case.simulation();
        cases::advance(&mut sim, 5e-3);
        let records = sim.walls[0].element_records();
        assert_eq!(records.len(), 32);
        let force: f64 = records.iter().map(|record| record.force.z).sum();
        assert!(
            (force + mass(RADIUS) * cases::G).abs() < 1e-3 * mass(RADIUS) * cases::G,
            "{force}"
        );
    });
}

#[test]
fn walls_that_turn_about_another_axis_or_are_longer_than_the_box_are_not_repeated() {
    let domain = rolling(plate(), Motion::Rest, Drift::None).domain;
    let repeated = |shape: Shape, motion: Motion| {
        let mut wall = Wall::new("wall", 0, shape, motion.clone()).unwrap();
        let motions = Motions::from(motion);
        wall.repeat(&domain, [0, 1, 2].map(|axis| motions.drift(axis))).unwrap();
        [0, 1, 2].map(|axis| wall.is_repeated(axis))
    };
    let turn = |axis: DVec3| Motion::Rotation {
        point: DVec3::ZERO,
        axis,
        angular_velocity: 1.0,
    };
    assert_eq!(repeated(plate(), Motion::Rest), [true, true, false]);
    assert_eq!(repeated(plate(), turn(DVec3::X)), [true, false, false]);
    assert_eq!(repeated(plate(), turn(DVec3::Z)), [false; 3]);
    let ball = |center: DVec3, side| Shape::Sphere {
        center,
        radius: 1e-3,
        side,
    };
    assert_eq!(
        repeated(ball(DVec3::ZERO, Side::Outside), Motion::Rest),
        [true, true, false]
    );
    assert_eq!(repeated(ball(DVec3::ZERO, Side::Inside), Motion::Rest), [false; 3]);
    assert_eq!(repeated(ball(DVec3::ONE, Side::Outside), Motion::Rest), [false; 3]);
    let longer = Shape::Rectangle {
        center: DVec3::new(0.5 * SIZE, 0.5 * SIZE, 0.0),
        half_u: DVec3::new(0.6 * SIZE, 0.0, 0.0),
        half_v: DVec3::new(0.0, 0.5 * SIZE, 0.0),
    };
    assert_eq!(repeated(longer, Motion::Rest), [false, true, false]);
}
