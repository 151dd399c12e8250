//! What friction and rolling laws store, return and dissipate.

use super::planar::{PlanarCase, PlanarInput, planar_cases, spring_cases};
use glam::DVec3;

/// Work that the motion does on the contact over one step.
fn work(input: &PlanarInput, load: DVec3) -> f64 {
    -load.dot(input.rate) * input.dt
}

/// A spring without dashpot.
const UNDAMPED: &[(&str, f64)] = &[("damping_ratio", 0.0)];

#[test]
fn no_step_of_any_motion_gives_energy() {
    for damping_ratio in [0.0, 0.1, 1.0] {
        for (index, case) in planar_cases(&[("damping_ratio", damping_ratio)]).iter().enumerate() {
            for seed in 0..5 {
                let mut history = case.history();
                for (step, input) in case.rough_drive(77 * index as u64 + seed, 400).iter().enumerate() {
                    let before = case.energy(&history);
                    let response = case.respond(input, &mut history);
                    let work = work(input, response.load);
                    let stored = case.energy(&history) - before;
                    let rounding = 1e-12 * (work.abs() + before + case.energy(&history));
                    assert!(
                        work - stored >= -rounding,
                        "{}: step {step} with damping ratio {damping_ratio} gave {:e} J of {before:e} J stored",
                        case.name(),
                        stored - work
                    );
                    assert!(
                        (response.dissipated - (work - stored)).abs() <= rounding,
                        "{}: {:e} J booked as dissipated, {:e} J were",
                        case.name(),
                        response.dissipated,
                        work - stored
                    );
                }
            }
        }
    }
}

/// A contact that cannot slide.
fn gripping(case: &PlanarCase, overlap_share: f64) -> PlanarInput {
    let mut input = case.at_rest(overlap_share);
    input.normal_force *= 1e9;
    input
}

/// Plays a path of elongations, given in steps, and returns the work done and the largest energy stored.
fn elastic_work(case: &PlanarCase, inputs: &[PlanarInput], history: &mut [f64]) -> (f64, f64) {
    let (mut done, mut largest) = (0.0, 0.0f64);
    for input in inputs {
        done += work(input, case.respond(input, history).load);
        largest = largest.max(case.energy(history));
    }
    (done, largest)
}

#[test]
fn a_closed_elastic_path_returns_all_its_energy() {
    for case in spring_cases(UNDAMPED) {
        let rest = gripping(&case, 1e-3);
        let scale = case.rate_scale(&case.at_rest(1e-3));
        let mut path: Vec<PlanarInput> = case
            .smooth_drive(3, 500)
            .iter()
            .map(|input| PlanarInput {
                rate: input.rate,
                ..rest
            })
            .collect();
        // one step back to the start
        let total: DVec3 = path.iter().map(|input| input.rate).sum();
        path.extend([PlanarInput { rate: -total, ..rest }]);
        let mut history = case.history();
        let (done, largest) = elastic_work(&case, &path, &mut history);
        assert!(largest > 0.0 && scale > 0.0);
        assert!(
            done.abs() <= 1e-12 * largest,
            "{}: {:e} of the energy was not returned",
            case.name(),
            done / largest
        );
        assert!(case.energy(&history) <= 1e-20 * largest, "{}", case.name());
    }
}

#[test]
fn stiffness_is_the_load_per_elongation() {
    for case in spring_cases(UNDAMPED) {
        for overlap_share in [1e-6, 1e-3, 0.05] {
            let mut input = gripping(&case, overlap_share);
            input.rate = DVec3::new(0.3, -0.2, 0.0) * case.rate_scale(&case.at_rest(overlap_share));
            let mut history = case.history();
            let first = case.respond(&input, &mut history).load;
            let second = case.respond(&input, &mut history).load;
            let expected = -input.rate * input.dt * case.stiffness(&input);
            assert!(
                (second - first - expected).length() <= 1e-12 * expected.length(),
                "{}: load changed by {}, expected {expected}",
                case.name(),
                second - first
            );
            // time-centred: the first step acts with the load in its middle
            assert!(
                (first - 0.5 * expected).length() <= 1e-12 * expected.length(),
                "{}",
                case.name()
            );
        }
    }
}

#[test]
fn the_load_does_not_jump_when_the_overlap_changes() {
    for case in spring_cases(&[]) {
        let mut input = gripping(&case, 1e-3);
        input.rate = DVec3::new(0.3, -0.2, 0.0) * case.rate_scale(&case.at_rest(1e-3));
        let mut history = case.history();
        for _ in 0..5 {
            case.respond(&input, &mut history);
        }
        input.rate = DVec3::ZERO;
        let held = case.respond(&input, &mut history).load;
        for change in [1e-9, 1e-6, 1e-3] {
            for sign in [1.0, -1.0] {
                let moved = gripping(&case, 1e-3 * (1.0 + sign * change));
                let load = case.respond(&moved, &mut history.clone()).load;
                assert!(
                    (load - held).length() <= change * held.length(),
                    "{}: load changed by {:e} of itself when the overlap changed by {:e} of itself",
                    case.name(),
                    (load - held).length() / held.length(),
                    sign * change
                );
            }
        }
    }
}

#[test]
fn shear_and_unshear_at_different_overlaps_make_no_energy() {
    // press, shear, release partly, shear back; and the other way round: the path that makes energy for ever when the
    // stiffness of the present overlap is applied to the whole elongation
    for case in spring_cases(UNDAMPED) {
        let rate = DVec3::new(0.3, -0.2, 0.0) * case.rate_scale(&case.at_rest(1e-4));
        let stretch =
            |from: f64, to: f64, sign: f64| (0..50).map(move |i| (from + (to - from) * f64::from(i) / 49.0, sign));
        let deep_then_shallow = [
            (1e-3, 1e-3, 1.0),
            (1e-3, 1e-4, 0.0),
            (1e-4, 1e-4, -1.0),
            (1e-4, 1e-3, 0.0),
        ];
        let shallow_then_deep = [
            (1e-4, 1e-4, 1.0),
            (1e-4, 1e-3, 0.0),
            (1e-3, 1e-3, -1.0),
            (1e-3, 1e-4, 0.0),
        ];
        for cycle in [deep_then_shallow, shallow_then_deep] {
            let path: Vec<PlanarInput> = cycle
                .iter()
                .flat_map(|&(from, to, sign)| stretch(from, to, sign))
                .map(|(overlap_share, sign)| PlanarInput {
                    rate: rate * sign,
                    ..gripping(&case, overlap_share)
                })
                .collect();
            let mut history = case.history();
            for round in 0..20 {
                let before = case.energy(&history);
                let (done, largest) = elastic_work(&case, &path, &mut history);
                let made = case.energy(&history) - before - done;
                assert!(
                    made <= 1e-12 * largest,
                    "{}: round {round} made {:e} of the energy stored",
                    case.name(),
                    made / largest
                );
            }
        }
    }
}
