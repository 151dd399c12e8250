//! Energy books of single contacts along given paths.

use super::*;
use crate::contact::conformance::cases::Random;
use approx::assert_relative_eq;

/// What went on along a walk [J].
#[derive(Debug, Default)]
struct Walk {
    /// Work done on the contact.
    work: f64,
    /// Work in and out, added up.
    through: f64,
    lost: f64,
}

/// Moves a contact through these overlaps with so many steps each.
fn walk(law: &Tomas, size: PairSize, history: &mut [f64], turns: &[f64], steps: u32) -> Walk {
    let mut done = Walk::default();
    for leg in turns.windows(2) {
        let length = leg[1] - leg[0];
        let step = length / f64::from(steps);
        for k in 0..steps {
            let input = NormalInput {
                size,
                overlap: leg[0] + (f64::from(k) + 0.5) * step,
                rate: step,
                half_window: 0.5 * step.abs(),
            };
            let response = law.respond(&input, history);
            done.work += response.elastic * step;
            done.through += (response.elastic * step).abs();
            done.lost += response.lost;
        }
    }
    done
}

/// Every choice that changes the force.
fn variants() -> Vec<Tomas> {
    let mut all = vec![];
    for tail in ["full", "cut", "none"] {
        all.push(limestone(&[("tail", tail.into()), ("loading", "elastic".into())]));
        for yield_overlap in ["continuous", "as-printed"] {
            all.push(limestone(&[
                ("tail", tail.into()),
                ("yield_overlap", yield_overlap.into()),
            ]));
        }
    }
    all
}

#[test]
fn work_is_stored_or_lost_on_random_paths() {
    for (index, law) in variants().iter().enumerate() {
        let mut random = Random(index as u64);
        for _ in 0..20 {
            let (mut history, start) = ([0.0; 3], -1.5e-9);
            let mut turns = vec![start];
            turns.extend((0..8).map(|_| random.between(-1.5e-9, 0.6e-9)));
            let done = walk(law, small(), &mut history, &turns, 3000);
            let stored = law.energy(small(), turns[turns.len() - 1], &history) - law.energy(small(), start, &[0.0; 3]);
            let error = done.work - stored - done.lost;
            // far from every bend the force at the middle of a step stands for its mean
            assert!(
                error.abs() <= 1e-5 * done.through,
                "{law:?}: {done:?}, stored {stored:e}"
            );
        }
    }
}

#[test]
fn a_coarse_walk_keeps_the_books_too() {
    // windows wider than the well of attraction
    let law = limestone(&[]);
    for steps in [1, 3, 10, 50] {
        let mut history = [0.0; 3];
        let Walk { work, lost, .. } = walk(&law, small(), &mut history, &[-40e-9, 0.4e-9, -40e-9], steps);
        assert_relative_eq!(work, lost, max_relative = 1e-6);
        assert_relative_eq!(history[0], 0.4e-9, max_relative = 1e-12);
    }
}

#[test]
fn what_a_dent_costs() {
    // out of reach, dented to h_U, out of reach: the yield line and the approach, less the way back out, in closed form
    let law = limestone(&[]);
    let scale = law.scale(small());
    let mut history = [0.0; 3];
    let deepest = 0.3e-9;
    let Walk { work, lost, .. } = walk(&law, small(), &mut history, &[-40e-9, deepest, -40e-9], 2000);
    let foot = history[1];
    let share = 1.0 / 101.0;
    let tail = |foot: f64| A * (scale.pull * (1.0 - share) + 0.5 * scale.limit * foot * (1.0 - share * share));
    let hertz = |d: f64| 0.4 * scale.hertz * d * d * d.sqrt();
    let level = scale.yields_at;
    let line = 0.5 * scale.line * (deepest * deepest - level * level);
    let into = hertz(level) + line - scale.pull * deepest - tail(0.0);
    let out = hertz(deepest - foot) - (scale.pull + scale.limit * foot) * (deepest - foot) - tail(foot);
    assert_relative_eq!(work, into - out, max_relative = 1e-9);
    assert_relative_eq!(lost, into - out, max_relative = 1e-9);
    assert!(lost > 0.0);
}

#[test]
fn yielding_never_gives_energy_with_a_tail() {
    for tail in ["full", "cut"] {
        let law = limestone(&[("tail", tail.into())]);
        for radius in [0.05e-6, 0.3e-6, 5e-6, 1e-3] {
            let level = law.scale(size(radius)).level;
            let (mut history, mut from) = ([0.0; 3], 0.0);
            for k in 1..200 {
                let to = level * (0.9 + 0.01 * f64::from(k * k));
                let lost = walk(&law, size(radius), &mut history, &[from, to], 1).lost;
                assert!(lost >= 0.0, "{tail}, {radius:e} m, {to:e}: {lost:e}");
                from = to;
            }
        }
    }
}

#[test]
fn the_force_is_the_slope_of_the_energy() {
    for law in variants() {
        let mut contact = Contact::new(law, small());
        contact.force(0.2e-9);
        let (deepest, foot) = (contact.history[0], contact.history[1]);
        for at in [
            -20e-9,
            -0.5e-9,
            -0.1e-9,
            foot - 0.02e-9,
            foot + 0.3 * (0.2e-9 - foot),
            0.19e-9,
        ] {
            let step = 1e-4 * (at - foot).abs().min(0.1e-9);
            assert!(at + step < deepest || deepest == 0.0);
            let slope = (contact.energy(at + step) - contact.energy(at - step)) / (2.0 * step);
            let force = contact.look(at, -1.0).elastic;
            assert_relative_eq!(slope, force, max_relative = 1e-6, epsilon = 1e-15);
        }
    }
}

#[test]
fn it_scales_with_the_size() {
    // R times 8: K sqrt(8), k_pl, k_p and the pull 8, h_Y 8; with the separation 8 times as large, forces 64 times
    let law = limestone(&[]);
    let other = limestone(&[
        ("adhesion_force", (8.0 * 2.64e-9).into()),
        ("separation", (8.0 * A).into()),
    ]);
    let (mut one, mut eight) = (Contact::new(law, small()), Contact::new(other, size(8.0 * 0.3e-6)));
    for overlap in [-1e-9, -1e-11, 5e-12, 0.1e-9, 0.07e-9, 0.3e-9, -0.2e-9] {
        for rate in [0.0, 1.0] {
            let (a, b) = (one.move_to(overlap, rate), eight.move_to(8.0 * overlap, rate));
            assert_relative_eq!(64.0 * a.elastic, b.elastic, max_relative = 1e-11);
            assert_relative_eq!(64.0 * a.damping, b.damping, max_relative = 1e-11);
            assert_relative_eq!(64.0 * a.adhesion, b.adhesion, max_relative = 1e-11);
        }
        assert_relative_eq!(
            512.0 * one.energy(overlap),
            eight.energy(8.0 * overlap),
            max_relative = 1e-11
        );
    }
}

#[test]
fn the_time_scale_resolves_the_oscillation_of_grains_that_stick() {
    for radius in [0.1e-6, 1e-6, 10e-6] {
        let law = limestone(&[]);
        let size = size(radius);
        for max_overlap in [1e-6, 1e-3, 0.05] {
            let deepest = max_overlap * radius;
            let time = law.collision_time(size, deepest);
            let mut contact = Contact::new(law, size);
            contact.force(deepest);
            // of a harmonic oscillation with the stiffness where it was pressed; that of a collision is 1.28 times as long
            let stiffest = law.stiffness(size, deepest, &contact.history);
            assert!(
                time <= PI * (size.mass / stiffest).sqrt() * 1.3,
                "{radius:e} {max_overlap:e}"
            );
            // and where it hangs at the steepest of the attraction
            let steepest = -law.stiffness(size, contact.history[1] - 1e-6 * A, &contact.history);
            assert!(time <= PI * (size.mass / steepest).sqrt() * 1.0001);
        }
    }
}
