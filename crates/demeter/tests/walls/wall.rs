//! Walls as the engine sees them: contacts under motion, extent, restart.

use demeter::walls::{Motion, Pose, Shape, Side, SurfaceContact, Wall, WallState};
use glam::{DQuat, DVec3};
use proptest::prelude::*;

fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

fn tetrahedron() -> Vec<[DVec3; 3]> {
    let p = [v(0.0, 0.0, 0.0), v(1.0, 0.0, 0.1), v(0.2, 1.0, 0.0), v(0.3, 0.2, 0.9)];
    [[0, 1, 2], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
        .map(|t| t.map(|k: usize| p[k]))
        .to_vec()
}

fn shapes() -> Vec<Shape> {
    let open = [false, false, false, true, false, false];
    let mut all = vec![
        Shape::Plane {
            point: v(0.1, 0.2, 0.0),
            normal: v(0.0, 0.6, 0.8),
        },
        Shape::Box {
            lower: v(-0.5, -0.4, -0.3),
            upper: v(0.5, 0.6, 0.7),
            open,
        },
        Shape::Rectangle {
            center: v(0.1, 0.0, 0.2),
            half_u: v(0.3, 0.4, 0.0),
            half_v: v(-0.4, 0.3, 0.1).cross(v(0.6, 0.8, 0.0)),
        },
        Shape::Disc {
            center: v(0.0, 0.1, 0.0),
            normal: v(0.0, 0.6, -0.8),
            radius: 0.7,
        },
        Shape::Mesh {
            triangles: tetrahedron(),
        },
    ];
    for side in [Side::Inside, Side::Outside] {
        let (start, end) = (v(0.0, 0.0, -0.5), v(0.2, 0.1, 0.6));
        all.push(Shape::Cylinder {
            start,
            end,
            radius: 0.6,
            side,
        });
        all.push(Shape::Cone {
            start,
            end,
            start_radius: 0.1,
            end_radius: 0.7,
            side,
        });
        all.push(Shape::Cone {
            start,
            end,
            start_radius: 0.6,
            end_radius: 0.0,
            side,
        });
        all.push(Shape::Sphere {
            center: v(0.1, 0.1, 0.1),
            radius: 0.8,
            side,
        });
    }
    all
}

fn motions() -> Vec<Motion> {
    vec![
        Motion::Rest,
        Motion::Velocity(v(0.3, -0.1, 0.2)),
        Motion::Rotation {
            point: v(0.2, 0.0, -0.1),
            axis: v(0.0, 0.8, 0.6),
            angular_velocity: 2.5,
        },
        Motion::Oscillation {
            amplitude: v(0.0, 0.05, 0.02),
            frequency: 3.0,
            phase: 0.3,
        },
        Motion::Servo {
            axis: v(0.0, 0.0, -1.0),
            force: 5.0,
            max_speed: 0.4,
        },
    ]
}

fn wall(shape: Shape, motion: Motion) -> Wall {
    Wall::new("wall", 0, shape, motion).unwrap()
}

fn contacts(wall: &Wall, centre: DVec3, reach: f64) -> Vec<SurfaceContact> {
    let mut out = Vec::new();
    wall.contacts(centre, (reach, 0.0), &mut out);
    out
}

/// Moves with a load that changes, so that a servo has something to do.
fn step(wall: &mut Wall, number: u32) {
    wall.set_load(
        v(0.0, 0.1, 4.0 + 2.0 * libm::sin(f64::from(number) * 0.05)),
        v(0.0, 0.0, 0.3),
    );
    wall.answer(true);
    wall.advance(1e-3);
}

#[test]
fn a_turned_wall_has_the_contacts_of_the_wall_frame_turned() {
    for shape in shapes() {
        let still = wall(shape.clone(), Motion::Rest);
        let mut moved = wall(shape, Motion::Velocity(v(1.0, 2.0, -0.5)));
        for _ in 0..100 {
            moved.advance(1e-3);
        }
        moved.set_motion(motions()[2].clone()).unwrap();
        for _ in 0..500 {
            moved.advance(1e-3);
        }
        let pose = moved.pose();
        for k in 0..300 {
            let t = f64::from(k);
            let local = v(libm::sin(t), libm::sin(1.7 * t), libm::cos(2.3 * t)) * 0.9;
            let there = pose.place(still.origin(), local);
            assert!((moved.origin() - pose.place(still.origin(), still.origin())).length() < 1e-15);
            let (a, b) = (contacts(&still, local, 0.3), contacts(&moved, there, 0.3));
            assert_eq!(a.len(), b.len());
            for (a, b) in a.iter().zip(&b) {
                assert_eq!(a.element, b.element);
                assert!((a.distance - b.distance).abs() < 1e-13);
                assert!((pose.rotation * a.normal - b.normal).length() < 1e-12);
            }
            assert_eq!(still.near(local, 0.3), !a.is_empty());
        }
    }
}

#[test]
fn a_box_has_six_numbered_faces_unless_open() {
    let walls = wall(
        Shape::Box {
            lower: DVec3::ZERO,
            upper: DVec3::ONE,
            open: [false; 6],
        },
        Motion::Rest,
    );
    let found = contacts(&walls, v(0.1, 0.9, 0.5), 0.2);
    assert_eq!(found.iter().map(|c| c.element).collect::<Vec<_>>(), vec![0, 3]);
    assert_eq!((found[0].normal, found[1].normal), (DVec3::X, -DVec3::Y));
    let open = [true, false, false, false, false, false];
    let walls = wall(
        Shape::Box {
            lower: DVec3::ZERO,
            upper: DVec3::ONE,
            open,
        },
        Motion::Rest,
    );
    assert_eq!(contacts(&walls, v(0.1, 0.9, 0.5), 0.2).len(), 1);
    // Above the top, the face still pushes down.
    let above = contacts(&walls, v(0.5, 0.5, 1.05), 0.2);
    assert_eq!((above[0].element, above[0].normal), (5, -DVec3::Z));
    assert!((above[0].distance + 0.05).abs() < 1e-15);
}

#[test]
fn a_box_ends_at_its_open_faces() {
    let shape = Shape::Box {
        lower: DVec3::ZERO,
        upper: DVec3::ONE,
        open: [false, false, false, false, false, true],
    };
    let tray = wall(shape, Motion::Rest);
    let at = |x: f64, z: f64| contacts(&tray, v(x, 0.5, z), 0.1);
    // as high as its rim the side pushes inwards, above it the rim pushes straight away, and higher there is nothing
    assert_eq!(
        at(0.05, 0.99).iter().map(|c| c.normal).collect::<Vec<_>>(),
        vec![DVec3::X]
    );
    let rim = at(0.03, 1.04);
    assert_eq!(rim.len(), 1);
    assert!((rim[0].distance - 0.05).abs() < 1e-15 && (rim[0].normal - v(0.6, 0.0, 0.8)).length() < 1e-14);
    assert!(at(0.03, 1.11).is_empty() && !tray.near(v(0.03, 0.5, 1.11), 0.1));
    assert!(at(-5.0, 1.11).is_empty(), "far beside it, above its rim");
    // a closed face goes on: a grain whose centre crossed an edge is held by both faces
    assert_eq!(contacts(&tray, v(-0.01, -0.02, 0.5), 0.1).len(), 2);
}

#[test]
fn a_cylinder_lets_go_of_a_grain_that_has_wholly_passed() {
    let shape = Shape::Cylinder {
        start: DVec3::ZERO,
        end: DVec3::Z,
        radius: 1.0,
        side: Side::Inside,
    };
    let tube = wall(shape, Motion::Rest);
    let at = |x: f64| {
        contacts(&tube, v(x, 0.0, 0.5), 0.1)
            .first()
            .map(|c| (c.normal, (c.distance * 1e3).round()))
    };
    assert_eq!(at(0.95), Some((-DVec3::X, 50.0)));
    assert_eq!(at(1.05), Some((-DVec3::X, -50.0)));
    assert_eq!(at(1.15), None);
    assert!(!tube.near(v(1.15, 0.0, 0.5), 0.1));
}

#[test]
fn restart_continues_with_the_same_bits() {
    for shape in shapes() {
        for motion in motions() {
            let mut straight = wall(shape.clone(), motion.clone());
            for number in 0..300 {
                step(&mut straight, number);
            }
            let bytes = postcard::to_allocvec(&straight.state()).unwrap();
            let state: WallState = postcard::from_bytes(&bytes).unwrap();
            let mut restarted = wall(shape.clone(), Motion::Rest);
            restarted.restore(&state);
            for number in 300..600 {
                step(&mut straight, number);
                step(&mut restarted, number);
            }
            assert_eq!(straight.state(), restarted.state());
            assert_eq!(straight.pose(), restarted.pose());
            let at = straight.origin() + v(0.1, 0.2, 0.3);
            assert_eq!(straight.velocity_at(at), restarted.velocity_at(at));
            assert_eq!(contacts(&straight, at, 0.9), contacts(&restarted, at, 0.9));
        }
    }
}

#[test]
fn the_bound_on_the_displacement_holds() {
    let (lower, upper) = (v(-1.0, -1.0, -1.0), v(1.0, 1.0, 1.0));
    for shape in shapes() {
        for motion in motions() {
            let mut moving = wall(shape.clone(), motion);
            for number in 0..40 {
                step(&mut moving, number);
            }
            let since = moving.pose();
            for number in 40..100 {
                step(&mut moving, number);
            }
            let bound = moving.surface_displacement(&since, lower, upper);
            assert!(bound.is_finite());
            // A sphere that reached no wall before reaches none now when the wall moved less than the gap.
            let mut before = wall(shape.clone(), Motion::Rest);
            place_at(&mut before, &since);
            for k in 0..400 {
                let t = f64::from(k);
                let at = v(libm::sin(t), libm::sin(1.7 * t), libm::cos(2.3 * t)) * 0.5;
                let reach = 0.1;
                if !before.near(at, reach + bound + 1e-9) {
                    assert!(!moving.near(at, reach), "{shape:?} {bound}");
                }
            }
        }
    }
}

/// Puts a wall at a pose by a rotation and a shift.
fn place_at(wall: &mut Wall, pose: &Pose) {
    let sine = v(pose.rotation.x, pose.rotation.y, pose.rotation.z);
    if sine.length() > 0.0 {
        let angle = 2.0 * libm::atan2(sine.length(), pose.rotation.w);
        let turn = Motion::Rotation {
            point: wall.origin(),
            axis: sine / sine.length(),
            angular_velocity: angle,
        };
        wall.set_motion(turn).unwrap();
        wall.advance(1.0);
    }
    wall.set_motion(Motion::Velocity(pose.translation)).unwrap();
    wall.advance(1.0);
    assert!((wall.pose().rotation.dot(pose.rotation).abs() - 1.0).abs() < 1e-14);
    assert!((wall.displacement() - pose.translation).length() < 1e-14);
}

#[test]
fn a_drum_that_turns_about_its_axis_does_not_move_its_surface() {
    let shape = Shape::Cylinder {
        start: DVec3::ZERO,
        end: DVec3::Y,
        radius: 0.5,
        side: Side::Inside,
    };
    let motion = Motion::Rotation {
        point: DVec3::ZERO,
        axis: DVec3::Y,
        angular_velocity: 3.0,
    };
    let mut drum = wall(shape, motion);
    let since = drum.pose();
    for _ in 0..1000 {
        drum.advance(1e-3);
    }
    assert!(drum.surface_displacement(&since, DVec3::splat(-1.0), DVec3::splat(1.0)) < 1e-14);
    let point = v(0.5, 0.3, 0.0);
    assert!((drum.velocity_at(point) - v(0.0, 0.0, -1.5)).length() < 1e-14);
    assert_eq!(drum.angular_velocity(), DVec3::Y * 3.0);
}

#[test]
fn pictures_lie_on_the_surface_and_within_the_bounds() {
    let (lower, upper) = (v(-2.0, -2.0, -2.0), v(2.0, 2.0, 2.0));
    for shape in shapes() {
        let mut moving = wall(shape.clone(), motions()[2].clone());
        for number in 0..200 {
            step(&mut moving, number);
        }
        let triangles = moving.triangles(lower, upper);
        assert!(!triangles.is_empty());
        for triangle in &triangles {
            let [a, b, c] = *triangle;
            assert!((b - a).cross(c - a).length() > 1e-9, "{shape:?}: no area");
            for corner in triangle {
                let touching = contacts(&moving, *corner, 1e-9);
                assert!(touching.iter().any(|c| c.distance.abs() < 1e-9), "{shape:?} {corner}");
                if let Some((low, high)) = moving.bounds() {
                    let room = DVec3::splat(1e-12);
                    assert!(
                        corner.cmpge(low - room).all() && corner.cmple(high + room).all(),
                        "{shape:?} {corner}"
                    );
                }
            }
        }
    }
    let floor = wall(
        Shape::Plane {
            point: DVec3::ZERO,
            normal: DVec3::Z,
        },
        Motion::Rest,
    );
    let area: f64 = floor
        .triangles(v(0.0, 0.0, -1.0), v(2.0, 3.0, 1.0))
        .iter()
        .map(|[a, b, c]| 0.5 * (*b - *a).cross(*c - *a).length())
        .sum();
    assert!((area - 6.0).abs() < 1e-12);
    assert!(floor.triangles(v(0.0, 0.0, 1.0), v(2.0, 3.0, 2.0)).is_empty());
    assert!(floor.bounds().is_none());
}

/// A bed of springs under a plate pushes with `-stiffness x depth` and some damping.
#[test]
fn a_servo_presses_with_its_force_and_holds_it_when_the_bed_changes() {
    let plate = Shape::Rectangle {
        center: DVec3::ZERO,
        half_u: DVec3::X,
        half_v: DVec3::Y,
    };
    let motion = Motion::Servo {
        axis: v(0.0, 0.0, -1.0),
        force: 20.0,
        max_speed: 0.05,
    };
    let mut plate = wall(plate, motion);
    let dt = 1e-5;
    for (stiffness, surface) in [(1e4, -1e-3), (1e4, -3e-3), (4e5, -2.5e-3), (5e3, -2e-3)] {
        let mut pressing = 0.0;
        for _ in 0..60_000 {
            let before = plate.displacement();
            plate.answer(true);
            plate.advance(dt);
            let speed = -plate.velocity_at(plate.origin()).z;
            assert!(speed.abs() <= 0.05 && ((before - plate.displacement()).z - speed * dt).abs() < 1e-15);
            let depth = surface - plate.displacement().z;
            pressing = if depth > 0.0 {
                f64::max(stiffness * depth + 20.0 * speed, 0.0)
            } else {
                0.0
            };
            plate.set_load(v(0.3, 0.0, pressing), DVec3::ZERO);
        }
        assert!((pressing - 20.0).abs() < 1e-3, "{stiffness} {surface}: {pressing}");
        assert!((surface - plate.displacement().z - 20.0 / stiffness).abs() < 1e-6);
    }
}

proptest! {
    #[test]
    fn nothing_is_ever_not_a_number(
        at in prop::array::uniform3(prop_oneof![-1.0f64..1.0, Just(0.0), -1e-160f64..1e-160, -1e9f64..1e9]),
        turn in prop::array::uniform4(-1.0f64..1.0),
        reach in prop_oneof![0.0f64..1.0, Just(1e-12), Just(1e10)],
    ) {
        prop_assume!(DQuat::from_array(turn).length() > 0.1);
        let axis = v(turn[0], turn[1], turn[2]);
        prop_assume!(axis.length() > 0.1);
        for shape in shapes() {
            let motion = Motion::Rotation { point: DVec3::ZERO, axis: axis / axis.length(), angular_velocity: turn[3] };
            let mut wall = wall(shape.clone(), motion);
            wall.advance(1.0);
            let centre = DVec3::from_array(at);
            for on_feature in [centre, wall.origin(), wall.pose().place(DVec3::ZERO, v(1.0, 0.0, 0.1))] {
                let found = contacts(&wall, on_feature, reach);
                for contact in &found {
                    prop_assert!(contact.normal.is_finite() && (contact.normal.length() - 1.0).abs() < 1e-9, "{:?} {:?}", shape, contact);
                    prop_assert!(contact.distance < reach);
                }
                prop_assert!(found.windows(2).all(|pair| pair[0].element < pair[1].element));
                prop_assert!(found.is_empty() || wall.near(on_feature, reach));
                prop_assert!(wall.velocity_at(on_feature).is_finite());
            }
        }
    }
}
