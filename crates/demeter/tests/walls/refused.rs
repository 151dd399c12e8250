//! Descriptions of walls and motions that are refused, and the message that each carries.

use demeter::walls::{Motion, Shape, Side, Wall, WallError};
use glam::DVec3;

#[test]
fn wrong_descriptions_are_refused() {
    let (start, end) = (DVec3::ZERO, DVec3::Z);
    let side = Side::Inside;
    let cases = [
        (
            Shape::Plane {
                point: DVec3::NAN,
                normal: DVec3::Z,
            },
            "finite",
        ),
        (
            Shape::Plane {
                point: DVec3::ZERO,
                normal: DVec3::Z * 2.0,
            },
            "unit vector",
        ),
        (
            Shape::Plane {
                point: DVec3::ZERO,
                normal: DVec3::ZERO,
            },
            "unit vector",
        ),
        (
            Shape::Box {
                lower: DVec3::ONE,
                upper: DVec3::ZERO,
                open: [false; 6],
            },
            "exceed",
        ),
        (
            Shape::Box {
                lower: DVec3::ZERO,
                upper: DVec3::ONE,
                open: [true; 6],
            },
            "open",
        ),
        (
            Shape::Cylinder {
                start,
                end,
                radius: -1.0,
                side,
            },
            "positive",
        ),
        (
            Shape::Cylinder {
                start,
                end: start,
                radius: 1.0,
                side,
            },
            "two different points",
        ),
        (
            Shape::Cylinder {
                start,
                end,
                radius: f64::INFINITY,
                side,
            },
            "finite",
        ),
        (
            Shape::Cone {
                start,
                end,
                start_radius: 0.0,
                end_radius: 0.0,
                side,
            },
            "both radii",
        ),
        (
            Shape::Cone {
                start,
                end,
                start_radius: f64::NAN,
                end_radius: 1.0,
                side,
            },
            "start_radius",
        ),
        (
            Shape::Sphere {
                center: start,
                radius: 0.0,
                side,
            },
            "positive",
        ),
        (
            Shape::Rectangle {
                center: start,
                half_u: DVec3::X,
                half_v: DVec3::ONE,
            },
            "perpendicular",
        ),
        (
            Shape::Rectangle {
                center: start,
                half_u: DVec3::X,
                half_v: DVec3::ZERO,
            },
            "half_v",
        ),
        (
            Shape::Disc {
                center: start,
                normal: DVec3::X,
                radius: f64::NAN,
            },
            "radius",
        ),
        (Shape::Mesh { triangles: vec![] }, "no triangle"),
    ];
    for (shape, message) in cases {
        let error = Wall::new("w", 0, shape.clone(), Motion::Rest)
            .expect_err(message)
            .to_string();
        assert!(error.contains(message), "{shape:?}: {error}");
    }
    let wrong_motions = [
        Motion::Velocity(DVec3::NAN),
        Motion::Rotation {
            point: start,
            axis: DVec3::ONE,
            angular_velocity: 1.0,
        },
        Motion::Rotation {
            point: start,
            axis: DVec3::X,
            angular_velocity: f64::INFINITY,
        },
        Motion::Oscillation {
            amplitude: DVec3::X,
            frequency: -1.0,
            phase: 0.0,
        },
        Motion::Servo {
            axis: DVec3::X,
            force: 0.0,
            max_speed: 1.0,
        },
        Motion::Servo {
            axis: DVec3::X,
            force: 1.0,
            max_speed: f64::NAN,
        },
    ];
    for motion in wrong_motions {
        assert!(Wall::check_motion(&motion).is_err(), "{motion:?}");
        let floor = Shape::Plane {
            point: DVec3::ZERO,
            normal: DVec3::Z,
        };
        let mut plane = Wall::new("w", 0, floor, Motion::Rest).unwrap();
        let before = plane.state();
        let refused: Result<(), WallError> = plane.set_motion(motion);
        assert!(refused.is_err());
        assert_eq!(plane.state(), before);
    }
}
