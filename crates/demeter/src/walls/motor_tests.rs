use super::super::motion::FreeMotion;
use super::super::motion_table::{AtEnd, Interpolation, MotionTable, TableRows};
use super::super::pace::Pace;
use super::super::pose::rotation_about;
use super::*;
use std::f64::consts::TAU;
use std::sync::Arc;

const ORIGIN: DVec3 = DVec3::new(0.5, -0.25, 2.0);

fn begin(motions: impl Into<Motions>) -> Motor {
    Motor::new(motions.into(), None, Pose::START, Pose::START, ORIGIN)
}

fn run(motions: impl Into<Motions>, dt: f64, steps: u32) -> Motor {
    let mut motor = begin(motions);
    for _ in 0..steps {
        motor.answer(ORIGIN, true);
        motor.advance(dt, ORIGIN);
    }
    motor
}

fn all(motions: &[Motion]) -> Motions {
    let parts = motions.iter().flat_map(|m| Motions::from(m.clone()).parts).collect();
    Motions { parts }
}

fn paced(motions: Motions, pace: Pace) -> Motions {
    let parts = motions.parts.into_iter().map(|part| MotionPart { pace, ..part });
    Motions { parts: parts.collect() }
}

fn rotation(point: DVec3, axis: DVec3, angular_velocity: f64) -> Motion {
    Motion::Rotation {
        point,
        axis,
        angular_velocity,
    }
}

fn table(interpolation: Interpolation) -> Motion {
    let rows = TableRows {
        times: vec![0.0, 0.004, 0.011, 0.02],
        values: vec![
            [0.0; 4],
            [0.1, 0.0, -0.2, 0.3],
            [0.2, 0.1, -0.1, 0.5],
            [0.1, 0.1, 0.1, 0.1],
        ],
    };
    let axis = Some((DVec3::new(0.1, 0.2, 0.3), DVec3::Y));
    Motion::Table(Arc::new(
        MotionTable::new(rows, interpolation, AtEnd::Hold, axis).unwrap(),
    ))
}

fn rocking() -> Motion {
    Motion::Rocking {
        point: DVec3::X,
        axis: DVec3::new(0.6, 0.0, 0.8),
        amplitude: 0.7,
        frequency: 11.0,
        phase: 0.3,
    }
}

fn oscillation() -> Motion {
    Motion::Oscillation {
        amplitude: DVec3::new(0.1, 0.0, -0.2),
        frequency: 2.0,
        phase: 0.4,
    }
}

#[test]
fn constant_velocity_gathers_no_rounding() {
    let velocity = DVec3::new(0.1, -0.3, 0.7);
    let motor = run(Motion::Velocity(velocity), 1e-5, 1_000_000);
    assert_eq!(motor.pose.translation, velocity * (1e-5 * 1e6));
    assert_eq!((motor.velocity, motor.angular_velocity), (velocity, DVec3::ZERO));
}

#[test]
fn a_full_turn_returns_and_the_speed_is_that_of_the_arm() {
    let axis = DVec3::new(0.0, 0.6, 0.8);
    let point = DVec3::new(1.0, 1.0, 1.0);
    let motor = run(rotation(point, axis, TAU), 1e-4, 10_000);
    assert!(motor.pose.translation.length() < 1e-14);
    assert!((motor.pose.rotation * DVec3::X - DVec3::X).length() < 1e-14);
    assert!((motor.velocity - (axis * TAU).cross(ORIGIN - point)).length() < 1e-13);
}

/// Places of three points of the wall after so many steps, and their velocities.
fn points(motor: &Motor) -> Vec<(DVec3, DVec3)> {
    let spread = [DVec3::ZERO, DVec3::new(0.3, 0.1, 0.9), DVec3::new(-0.4, 0.8, 0.2)];
    let place = |x: DVec3| motor.pose.place(ORIGIN, ORIGIN + x);
    let velocity = |x: DVec3| motor.velocity + motor.angular_velocity.cross(place(x) - place(DVec3::ZERO));
    spread.iter().map(|x| (place(*x), velocity(*x))).collect()
}

#[test]
fn velocities_are_derivatives_of_the_pose() {
    let planetary = all(&[rotation(DVec3::ZERO, DVec3::Z, 9.0), rotation(ORIGIN, DVec3::Z, -40.0)]);
    let screw = all(&[Motion::Velocity(DVec3::Y * 0.4), rotation(ORIGIN, DVec3::Y, 30.0)]);
    let shaking_drum = all(&[oscillation(), rotation(DVec3::ONE, DVec3::X, 5.0)]);
    let all_of_them = all(&[
        oscillation(),
        rocking(),
        table(Interpolation::Rates),
        rotation(DVec3::ONE, DVec3::X, 5.0),
        Motion::Velocity(DVec3::new(1.0, -2.0, 0.5)),
    ]);
    let slow = Pace {
        start_over: 0.008,
        stop_after: 0.012,
        stop_over: 0.005,
    };
    let motions = [
        rotation(DVec3::ONE, DVec3::Y, -3.0).into(),
        oscillation().into(),
        rocking().into(),
        table(Interpolation::Linear).into(),
        table(Interpolation::Smooth).into(),
        table(Interpolation::Rates).into(),
        planetary,
        screw,
        shaking_drum,
        paced(all_of_them.clone(), slow),
        all_of_them,
    ];
    for motion in motions {
        let dt = 2e-6;
        let mut motor = begin(motion.clone());
        let mut track = vec![points(&motor)];
        for _ in 0..10_000 {
            motor.advance(dt, ORIGIN);
            track.push(points(&motor));
        }
        for now in 1..10_000 {
            // straight lines of a table have kinks
            if [2000, 5500].contains(&now) && matches!(motion.parts[0].motion, Motion::Table(_)) {
                continue;
            }
            for (k, (place, velocity)) in track[now].iter().enumerate() {
                let slope = (track[now + 1][k].0 - track[now - 1][k].0) / (2.0 * dt);
                let error = (slope - *velocity).length();
                assert!(error < 2e-4, "{motion:?} at {now}: {slope} {velocity} {place}");
            }
        }
    }
}

#[test]
fn later_motions_are_carried_by_earlier_ones() {
    // a tool at 1 m from the mixer's axis turns once about itself while its carrier makes a quarter of a turn
    let tool = DVec3::new(1.0, 0.0, 0.0);
    let planetary = all(&[
        rotation(DVec3::ZERO, DVec3::Z, 0.25 * TAU),
        rotation(tool, DVec3::Z, TAU),
    ]);
    let quarter = run(planetary.clone(), 1e-3, 1000);
    let place = |motor: &Motor, x: DVec3| motor.pose.place(ORIGIN, x);
    assert!((place(&quarter, tool) - DVec3::Y).length() < 1e-13);
    assert!((place(&quarter, tool + DVec3::X * 0.1) - DVec3::Y * 1.1).length() < 1e-13);
    let half = run(planetary.clone(), 1e-3, 500);
    let eighth = DVec3::new(1.0, 1.0, 0.0) * 0.5f64.sqrt();
    assert!((place(&half, tool) - eighth).length() < 1e-13);
    // the other way about, the carrier's axis is swung by half a turn about where the tool was
    let reversed = Motions {
        parts: planetary.parts.into_iter().rev().collect(),
    };
    let other = run(reversed, 1e-3, 500);
    assert!((place(&other, tool) - (2.0 * tool - eighth)).length() < 1e-13);
}

#[test]
fn a_new_motion_starts_where_the_last_one_ended() {
    let mut motor = run(Motion::Velocity(DVec3::X), 0.1, 5);
    let there = motor.pose;
    let swing = Motion::Oscillation {
        amplitude: DVec3::Z,
        frequency: 1.0,
        phase: 1.0,
    };
    motor = Motor::new(swing.into(), None, there, Pose::START, ORIGIN);
    assert_eq!(motor.pose, there);
    assert!((motor.velocity - DVec3::Z * (TAU * 1f64.cos())).length() < 1e-14);
    motor.advance(1.0, ORIGIN);
    assert!((motor.pose.translation - there.translation).length() < 1e-14);
}

#[test]
fn a_wall_that_moves_with_another_is_one_body_with_it() {
    let its_origin = DVec3::new(-1.0, 0.3, 0.2);
    let motions = all(&[Motion::Velocity(DVec3::X), rotation(DVec3::ONE, DVec3::Y, 2.0)]);
    let mut leader = Motor::new(motions, None, Pose::START, Pose::START, its_origin);
    for _ in 0..100 {
        leader.advance(1e-3, its_origin);
    }
    let began = Pose {
        translation: DVec3::new(0.2, 0.1, 0.0),
        rotation: rotation_about(DVec3::Z, 0.4),
    };
    let mut follower = Motor::new(Motion::With(0).into(), None, began, leader.pose, ORIGIN);
    let apart =
        |leader: &Motor, follower: &Motor, x: DVec3| leader.pose.unplace(its_origin, follower.pose.place(ORIGIN, x));
    follower.follow(&leader, its_origin, ORIGIN);
    assert_eq!(follower.pose, began);
    let first: Vec<DVec3> = [DVec3::ZERO, DVec3::ONE, DVec3::Z]
        .map(|x| apart(&leader, &follower, x))
        .into();
    let before = follower.pose.place(ORIGIN, DVec3::ONE);
    leader.advance(1e-6, its_origin);
    follower.follow(&leader, its_origin, ORIGIN);
    let slope = (follower.pose.place(ORIGIN, DVec3::ONE) - before) / 1e-6;
    let arm = follower.pose.place(ORIGIN, DVec3::ONE) - follower.pose.place(ORIGIN, ORIGIN);
    let velocity = follower.velocity + follower.angular_velocity.cross(arm);
    assert!((slope - velocity).length() < 1e-4, "{slope} {velocity}");
    for _ in 0..500 {
        leader.advance(1e-3, its_origin);
        follower.follow(&leader, its_origin, ORIGIN);
    }
    for (x, first) in [DVec3::ZERO, DVec3::ONE, DVec3::Z].into_iter().zip(first) {
        assert!((apart(&leader, &follower, x) - first).length() < 1e-13);
    }
}

#[test]
fn efforts_follow_the_axis_that_earlier_parts_carry() {
    // after a quarter of a turn about z, what pushed along x pushes along y
    let servo = Motion::Servo {
        axis: DVec3::X,
        force: 2.0,
        max_speed: 1e-9,
    };
    let mut motor = run(all(&[rotation(DVec3::ZERO, DVec3::Z, 0.25 * TAU), servo]), 1e-3, 1000);
    motor.bear((DVec3::new(0.0, 3.0, 0.0), DVec3::ZERO));
    assert!((motor.effort(1, ORIGIN) - 3.0).abs() < 1e-12);
    let turned = Motion::TorqueServo {
        point: ORIGIN + DVec3::X,
        axis: DVec3::Z,
        torque: 1.0,
        max_speed: 1e-9,
    };
    let mut motor = run(all(&[Motion::Velocity(DVec3::X), turned]), 1e-3, 1000);
    // the axis moved with the wall: the lever of its origin is still -1 m
    motor.bear((DVec3::new(0.0, 3.0, 0.0), DVec3::Z * 0.5));
    assert!((motor.effort(1, ORIGIN) + 2.5).abs() < 1e-12);
}

#[test]
fn a_free_wall_under_constant_load_does_the_work_of_the_load() {
    let free = FreeMotion {
        freedom: Freedom::Slide { axis: DVec3::Z },
        inertia: 0.5,
        weight: DVec3::Z * -5.0,
        stiffness: 0.0,
        damping: 0.0,
        speed: 0.0,
        stops: [f64::NEG_INFINITY, f64::INFINITY],
    };
    let motions = all(&[Motion::Free(free), rotation(ORIGIN, DVec3::Z, 3.0)]);
    let mut motor = begin(motions);
    let (mut work, dt, load) = (0.0, 1e-3, (DVec3::new(1.0, 0.0, 6.0), DVec3::ZERO));
    for _ in 0..1000 {
        motor.advance(dt, ORIGIN);
        motor.bear(load);
        work += motor.settle(ORIGIN).unwrap().power * dt;
    }
    assert!((work - motor.energy()).abs() < 2e-2 * work, "{work} {}", motor.energy());
    // the first half of the first step bore nothing but the weight: -10 m/s^2 in place of (6 - 5)/0.5
    assert!((motor.velocity.z - 1.994).abs() < 1e-12, "{}", motor.velocity);
    assert!((motor.angular_velocity.z - 3.0).abs() < 1e-15);
}

#[test]
fn motions_are_done_when_all_have_stopped() {
    let stop = Pace {
        stop_after: 0.1,
        stop_over: 0.1,
        ..Pace::FULL
    };
    let stopping = paced(rotation(ORIGIN, DVec3::Z, 3.0).into(), stop);
    assert!(!run(stopping.clone(), 0.01, 15).is_done());
    assert!(run(stopping, 0.01, 21).is_done());
    assert!(!run(table(Interpolation::Linear), 1e-3, 19).is_done());
    assert!(run(table(Interpolation::Linear), 1e-3, 21).is_done());
    assert!(!run(rotation(ORIGIN, DVec3::Z, 3.0), 1.0, 99).is_done());
}

#[test]
fn a_change_of_the_step_keeps_the_time() {
    let mut clock = Clock::default();
    for _ in 0..10 {
        clock.advance(0.5);
    }
    clock.advance(0.25);
    clock.advance(0.25);
    assert_eq!(clock.time(), 5.5);
}

#[test]
fn a_belt_runs_as_the_motions_before_it_turn_it_and_moves_no_wall() {
    let turn = rotation(ORIGIN, DVec3::Z, 2.0);
    let turned = run(turn.clone(), 1e-3, 500);
    let motor = run(all(&[turn, Motion::Belt(DVec3::X * 3.0)]), 1e-3, 500);
    let expected = DVec3::new(libm::cos(1.0), libm::sin(1.0), 0.0) * 3.0;
    assert!((motor.belt - expected).length() < 1e-12, "{}", motor.belt);
    assert_eq!(
        (motor.pose, motor.velocity, motor.angular_velocity),
        (turned.pose, turned.velocity, turned.angular_velocity)
    );
    assert!(run(Motion::Belt(DVec3::X), 1e-3, 9).pose == Pose::START);
}
