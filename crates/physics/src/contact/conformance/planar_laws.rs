//! Bound, direction, symmetries, dimensions and history of friction and rolling laws.

use super::cases::OTHER_UNITS;
use super::planar::{PlanarCase, PlanarInput, load_and_rate, planar_cases};
use crate::contact::MaterialPair;
use crate::dimension::Dimension;
use crate::integrator::rotate;
use glam::{DQuat, DVec3};

/// Loads over a drive, from an untouched contact.
fn play(case: &PlanarCase, drive: &[PlanarInput]) -> Vec<DVec3> {
    let mut history = case.history();
    drive
        .iter()
        .map(|input| case.respond(input, &mut history).load)
        .collect()
}

fn each_rough_drive(check: impl Fn(&PlanarCase, &[PlanarInput])) {
    for (index, case) in planar_cases(&[]).iter().enumerate() {
        for seed in 0..5 {
            check(case, &case.rough_drive(1000 * index as u64 + seed, 300));
        }
    }
}

#[test]
fn load_stays_within_friction_times_the_normal_force() {
    each_rough_drive(|case, drive| {
        for (load, input) in play(case, drive).iter().zip(drive) {
            let limit = case.limit(input).expect("a law without a coefficient of friction");
            assert!(
                load.length() <= limit * (1.0 + 1e-12),
                "{}: load {:e} beyond {limit:e}",
                case.name(),
                load.length()
            );
        }
    });
}

#[test]
fn load_lies_in_the_contact_plane() {
    each_rough_drive(|case, drive| {
        for (load, input) in play(case, drive).iter().zip(drive) {
            assert!(load.dot(input.normal).abs() <= 1e-12 * load.length(), "{}", case.name());
        }
    });
}

#[test]
fn sliding_load_is_the_limit_against_the_motion() {
    for case in planar_cases(&[]) {
        let mut input = case.at_rest(1e-3);
        let direction = DVec3::new(0.6, -0.8, 0.0);
        let mut history = case.history();
        let mut load = DVec3::ZERO;
        for step in 0..400 {
            // first across the later direction, so that a law with memory has something to forget
            let towards = if step < 20 { DVec3::X } else { direction };
            input.rate = towards * 100.0 * case.rate_scale(&input);
            load = case.respond(&input, &mut history).load;
        }
        let expected = -direction * case.limit(&input).unwrap();
        assert!(
            (load - expected).length() <= 1e-9 * expected.length(),
            "{}: {load} instead of {expected}",
            case.name()
        );
    }
}

#[test]
fn nothing_acts_without_normal_force() {
    for case in planar_cases(&[]) {
        let mut drive = case.rough_drive(7, 100);
        for input in &mut drive[50..] {
            input.normal_force = 0.0;
        }
        let mut history = case.history();
        for input in &drive {
            let response = case.respond(input, &mut history);
            if input.normal_force == 0.0 {
                assert_eq!(response.load, DVec3::ZERO, "{}", case.name());
                assert_eq!(case.energy(&history), 0.0, "{}", case.name());
            }
        }
    }
}

#[test]
fn swapping_the_bodies_reverses_the_load() {
    each_rough_drive(|case, drive| {
        let swapped: Vec<PlanarInput> = drive
            .iter()
            .map(|input| PlanarInput {
                normal: -input.normal,
                rate: -input.rate,
                spin: -input.spin,
                ..*input
            })
            .collect();
        for (load, other) in play(case, drive).into_iter().zip(play(case, &swapped)) {
            assert_eq!(load, -other, "{}", case.name());
        }
    });
}

#[test]
fn swapping_the_materials_changes_nothing() {
    for case in planar_cases(&[]) {
        let swapped = PlanarCase {
            pair: MaterialPair {
                a: case.pair.b,
                b: case.pair.a,
            },
            ..case
        };
        assert_eq!(swapped.rebuilt(&[]).law, case.law, "{}", case.name());
    }
}

#[test]
fn a_mirror_image_of_the_motion_gives_the_mirror_image_of_the_load() {
    let mirror = |v: DVec3| DVec3::new(-v.x, v.y, v.z);
    each_rough_drive(|case, drive| {
        // angular velocities and torques turn the other way in a mirror
        let sign = if case.is_friction() { 1.0 } else { -1.0 };
        let image: Vec<PlanarInput> = drive
            .iter()
            .map(|input| PlanarInput {
                normal: mirror(input.normal),
                rate: sign * mirror(input.rate),
                spin: -input.spin,
                ..*input
            })
            .collect();
        for (load, other) in play(case, drive).into_iter().zip(play(case, &image)) {
            assert_eq!(sign * mirror(load), other, "{}", case.name());
        }
    });
}

/// Largest difference between the load seen in a frame that turns at `omega` (in turns of one radian per drive) and
/// the turned load, as a share of the largest load.
fn frame_error(case: &PlanarCase, omega: DVec3, steps: u32) -> f64 {
    let drive = case.smooth_drive(11, steps);
    let period = drive[0].dt * f64::from(steps);
    let omega = omega / period;
    let frame = |step: usize| rotate(DQuat::IDENTITY, omega, drive[0].dt * step as f64);
    let turned: Vec<PlanarInput> = drive
        .iter()
        .enumerate()
        .map(|(step, input)| PlanarInput {
            normal: frame(step) * input.normal,
            rate: frame(step) * input.rate,
            spin: input.spin + omega.dot(frame(step) * input.normal),
            ..*input
        })
        .collect();
    let loads = play(case, &drive);
    let largest = loads.iter().map(|load| load.length()).fold(0.0, f64::max);
    let differences = play(case, &turned)
        .into_iter()
        .zip(&loads)
        .enumerate()
        .map(|(step, (seen, load))| (seen - frame(step) * *load).length());
    differences.fold(0.0, f64::max) / largest
}

#[test]
fn a_frame_that_spins_about_the_normal_sees_the_turned_load() {
    for case in planar_cases(&[]) {
        for omega in [DVec3::Z, -3.0 * DVec3::Z] {
            let (coarse, fine) = (frame_error(&case, omega, 1000), frame_error(&case, omega, 2000));
            assert!(coarse < 1e-5, "{}: frame error {coarse:e} at {omega}", case.name());
            // second order in the step, unless nothing but rounding is left
            assert!(
                fine < coarse / 3.0 || fine < 1e-11,
                "{}: frame error {coarse:e} falls to {fine:e} only",
                case.name()
            );
        }
    }
}

#[test]
fn a_turning_frame_sees_the_turned_load() {
    for case in planar_cases(&[]) {
        for omega in [DVec3::X, DVec3::new(0.6, -0.9, 1.3), DVec3::new(-2.0, 0.3, -2.5)] {
            let (coarse, fine) = (frame_error(&case, omega, 1000), frame_error(&case, omega, 2000));
            // A law remembers its load but not the normal that it had: carried into a plane tilted by `a`, the load
            // turns by up to a^2/4 within it. That adds up to the angle of the whole path times that of one step.
            let bound = 0.25 * omega.length_squared() / 1000.0;
            assert!(coarse < bound, "{}: frame error {coarse:e} at {omega}", case.name());
            assert!(
                fine < 0.6 * coarse || fine < 1e-11,
                "{}: frame error {coarse:e} falls to {fine:e} only at {omega}",
                case.name()
            );
        }
    }
}

#[test]
fn a_law_continues_from_the_bytes_of_its_history() {
    each_rough_drive(|case, drive| {
        let (first, second) = drive.split_at(drive.len() / 2);
        let mut history = case.history();
        for input in first {
            case.respond(input, &mut history);
        }
        let bytes: Vec<[u8; 8]> = history.iter().map(|value| value.to_le_bytes()).collect();
        // a new law and a new history: nothing may live anywhere else
        let restored_case = case.rebuilt(&[]);
        let mut restored: Vec<f64> = bytes.into_iter().map(f64::from_le_bytes).collect();
        for input in second {
            let expected = case.respond(input, &mut history);
            let response = restored_case.respond(input, &mut restored);
            assert_eq!(
                response.load.to_array().map(f64::to_bits),
                expected.load.to_array().map(f64::to_bits),
                "{}",
                case.name()
            );
        }
        assert_eq!(restored, history, "{}", case.name());
    });
}

#[test]
fn response_and_history_scale_as_the_declared_dimensions() {
    let units = OTHER_UNITS;
    each_rough_drive(|case, drive| {
        let other = case.in_units(units);
        let (load_dimension, rate_dimension) = load_and_rate(case);
        let load_scale = units.of(load_dimension);
        let inertia_dimension = if case.is_friction() {
            Dimension::MASS
        } else {
            Dimension::new(1, 2, 0)
        };
        let (mut history, mut other_history) = (case.history(), other.history());
        let mut largest = vec![0.0f64; history.len()];
        for input in drive {
            let other_input = PlanarInput {
                size: other.size,
                inertia: input.inertia * units.of(inertia_dimension),
                overlap: input.overlap * units.length,
                normal_stiffness: input.normal_stiffness * units.of(Dimension::STIFFNESS),
                normal: input.normal,
                rate: input.rate * units.of(rate_dimension),
                spin: input.spin * units.of(Dimension::FREQUENCY),
                normal_force: input.normal_force * units.of(Dimension::FORCE),
                dt: input.dt * units.time,
            };
            let stored_before = case.energy(&history);
            let (a, b) = (
                case.respond(input, &mut history),
                other.respond(&other_input, &mut other_history),
            );
            let limit = case.limit(input).unwrap();
            assert!(
                (b.load - a.load * load_scale).length() <= 1e-10 * limit * load_scale,
                "{}: load in other units",
                case.name()
            );
            let energy = limit * input.rate.length() * input.dt + stored_before + case.energy(&history);
            for (what, a, b) in [
                ("dissipation", a.dissipated, b.dissipated),
                ("energy", case.energy(&history), other.energy(&other_history)),
            ] {
                let scale = units.of(Dimension::ENERGY);
                assert!(
                    (b - a * scale).abs() <= 1e-10 * energy * scale,
                    "{}: {what} in other units",
                    case.name()
                );
            }
            for (index, dimension) in case.info.history_dimensions.iter().enumerate() {
                let scale = units.of(*dimension);
                largest[index] = largest[index].max(history[index].abs());
                assert!(
                    (other_history[index] - history[index] * scale).abs()
                        <= 1e-9 * largest[index].max(limit * 1e-3) * scale,
                    "{}: history {index} in other units",
                    case.name()
                );
            }
        }
    });
}
