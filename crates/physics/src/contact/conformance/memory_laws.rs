//! Normal laws that remember or act across a gap, along random paths of the overlap: through contact and gap, with
//! reversals, in windows as the engine hands them in.

use super::cases::{MOST_HISTORY, NormalCase, OTHER_UNITS, Random, Units, memory_cases, scaled_values};
use crate::contact::MaterialPair;
use crate::contact::normal::{NormalInput, NormalLaw, NormalResponse};
use crate::dimension::Dimension;
use std::f64::consts::TAU;

/// Sizes of the overlaps as shares of the radius, besides those that the law's own reach gives.
const SCALES: [f64; 2] = [1e-4, 1e-2];
/// Steps of a path.
const STEPS: u32 = 4000;

/// A smooth closed path of the overlap.
#[derive(Clone)]
struct Path {
    mean: f64,
    amplitudes: [f64; 4],
    phases: [f64; 4],
    steps: u32,
    period: f64,
}

/// A contact on its path.
struct Moment {
    input: NormalInput,
    /// What the law remembered before and after.
    before: [f64; MOST_HISTORY],
    after: [f64; MOST_HISTORY],
    response: NormalResponse,
    /// Length of the step [s].
    dt: f64,
}

impl Path {
    /// A path that begins out of reach and ends there.
    fn new(case: &NormalCase, scale: f64, random: &mut Random) -> Self {
        let mut path = Self {
            mean: scale * random.between(-0.5, 1.0),
            amplitudes: [1.0, 0.6, 0.4, 0.3].map(|a| a * scale * random.between(0.3, 1.0)),
            phases: [0.0; 4].map(|_| random.between(0.0, TAU)),
            steps: STEPS,
            period: case.collision_time(scale),
        };
        // lower it as far as it takes, and begin at its lowest place
        let least = (0..STEPS)
            .map(|k| (path.at(k).0, k))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .unwrap();
        let out = -1.05 * case.largest_reach() - 0.05 * scale;
        path.mean += (out - least.0).min(0.0);
        let start = TAU * f64::from(least.1) / f64::from(STEPS);
        for (k, phase) in path.phases.iter_mut().enumerate() {
            *phase += (k + 1) as f64 * start;
        }
        path
    }

    /// Overlap and rate of a step.
    fn at(&self, step: u32) -> (f64, f64) {
        let time = TAU * f64::from(step) / f64::from(self.steps);
        let (mut overlap, mut rate) = (self.mean, 0.0);
        for (k, (a, phase)) in self.amplitudes.iter().zip(self.phases).enumerate() {
            let frequency = (k + 1) as f64;
            overlap += a * libm::sin(frequency * time + phase);
            rate += a * frequency * TAU / self.period * libm::cos(frequency * time + phase);
        }
        (overlap, rate)
    }

    /// Walks along the path, as the engine does: what is out of reach is forgotten.
    fn walk(&self, case: &NormalCase, mut visit: impl FnMut(&Moment)) {
        let dt = self.period / f64::from(self.steps);
        let mut history = [0.0; MOST_HISTORY];
        for step in 0..=self.steps {
            let (overlap, rate) = self.at(step);
            let input = NormalInput {
                half_window: 0.5 * dt * rate.abs(),
                ..NormalInput::at(case.size, overlap, rate)
            };
            let reach = case.largest_reach();
            let windows = if reach > 0.0 { 2.0 } else { 1.0 };
            let before = history;
            let response = if overlap + reach + windows * input.half_window > 0.0 {
                case.respond_with(&input, &mut history)
            } else {
                history = [0.0; MOST_HISTORY];
                NormalResponse::NOTHING
            };
            visit(&Moment {
                input,
                before,
                after: history,
                response,
                dt,
            });
        }
    }
}

/// Every law with memory on paths of several sizes.
fn each_path(mut check: impl FnMut(&NormalCase, &Path, &str)) {
    for (index, (case, values)) in memory_cases().into_iter().enumerate() {
        let mut random = Random(index as u64);
        let reach = case.largest_reach();
        // a path that begins out of reach goes through the whole of it
        let shares = SCALES.map(|share| share * case.size.radius).map(|s| s.max(2.0 * reach));
        for scale in shares.into_iter().chain([5.0 * reach]).filter(|s| *s > 0.0) {
            let path = Path::new(&case, scale, &mut random);
            let label = format!("{} with {values:?}, path of size {scale:e}", case.name());
            check(&case, &path, &label);
        }
    }
}

/// What a path came to.
#[derive(Default)]
struct Books {
    /// Work of the elastic part on the contact, and the sum of its magnitudes [J].
    work: f64,
    magnitude: f64,
    lost: f64,
    /// The losses that are negative.
    gained: f64,
    /// Largest difference between work and stored plus lost.
    error: f64,
}

fn books(case: &NormalCase, path: &Path) -> Books {
    let mut books = Books::default();
    path.walk(case, |m| {
        let work = m.response.elastic * m.input.rate * m.dt;
        let step = m.input.half_window * m.input.rate.signum();
        books.work += work;
        books.magnitude += work.abs();
        books.lost += m.response.lost;
        books.gained -= m.response.lost.min(0.0);
        let stored = case.energy_with(m.input.overlap + step, &m.after);
        books.error = books.error.max((books.work - books.lost - stored).abs());
    });
    books
}

#[test]
fn work_is_stored_or_lost_and_never_made() {
    each_path(|case, path, label| {
        let coarse = books(case, path);
        let fine = books(
            case,
            &Path {
                steps: 5 * STEPS,
                ..path.clone()
            },
        );
        if fine.magnitude == 0.0 {
            let highest = (0..STEPS).map(|k| path.at(k).0).fold(f64::NEG_INFINITY, f64::max);
            assert!(highest < 0.0, "{label}: nothing acted");
            return;
        }
        let share = |x: f64| x / fine.magnitude;
        for (books, tolerance) in [(&coarse, 2e-3), (&fine, 5e-5)] {
            assert!(
                share(books.error) < tolerance,
                "{label}: {:e} is neither stored nor lost",
                share(books.error)
            );
            assert!(
                share(books.gained) < tolerance,
                "{label}: a loss of {:e}",
                -share(books.gained)
            );
        }
        // the path ends out of reach: what the law keeps of the work is lost, never negative
        assert!(
            share(fine.work) > -5e-5,
            "{label}: {:e} of the work was made",
            -share(fine.work)
        );
    });
}

#[test]
fn the_windowed_response_is_the_mean_along_the_path() {
    const PARTS: u32 = 1000;
    each_path(|case, path, label| {
        let mut random = Random(7);
        path.walk(case, |m| {
            if random.share() > 0.005 || m.input.half_window == 0.0 {
                return;
            }
            // a wide window, so that changes of branch lie in it
            let half_window = m.input.half_window * random.between(1.0, 40.0);
            let input = NormalInput { half_window, ..m.input };
            let mut history = m.before;
            let response = case.respond_with(&input, &mut history);
            let (mut elastic, mut damping, mut adhesion) = (0.0, 0.0, 0.0);
            let mut largest = NormalResponse::NOTHING;
            let mut followed = m.before;
            let mut point = |share: f64, largest: &mut NormalResponse| {
                let overlap = m.input.overlap + half_window * m.input.rate.signum() * (2.0 * share - 1.0);
                let point = NormalInput::at(case.size, overlap, m.input.rate);
                let plain = case.respond_with(&point, &mut followed);
                largest.elastic = largest.elastic.max(plain.elastic.abs());
                largest.damping = largest.damping.max(plain.damping);
                largest.adhesion = largest.adhesion.max(plain.adhesion);
                plain
            };
            point(0.0, &mut largest);
            for part in 0..PARTS {
                let plain = point((f64::from(part) + 0.5) / f64::from(PARTS), &mut largest);
                elastic += plain.elastic / f64::from(PARTS);
                damping += plain.damping / f64::from(PARTS);
                adhesion += plain.adhesion / f64::from(PARTS);
            }
            // the force may be there at the last place only
            point(1.0, &mut largest);
            // roots of the overlap at the ends of a window take their toll; of the adhesion only friction hears
            for (what, windowed, mean, largest, tolerance) in [
                ("force", response.elastic, elastic, largest.elastic, 5e-3),
                ("damping", response.damping, damping, largest.damping, 1e-2),
                ("adhesion", response.adhesion, adhesion, largest.adhesion, 1e-1),
            ] {
                assert!(
                    (windowed - mean).abs() <= tolerance * largest,
                    "{label}: mean {what} is {windowed:e}, along the path {mean:e}, at {:?}",
                    input
                );
            }
        });
    });
}

#[test]
fn no_force_acts_out_of_reach() {
    each_path(|case, path, label| {
        path.walk(case, |m| {
            let reach = case.reach_with(&m.after);
            let largest = case.largest_reach();
            assert!(
                reach <= largest * (1.0 + 1e-12),
                "{label}: reach {reach:e} above {largest:e}"
            );
            let margin = 1e-9 * reach.abs() + 1e-15 * case.size.radius;
            let input = NormalInput::at(case.size, -reach - margin, -1.0);
            let mut history = m.after;
            let response = case.respond_with(&input, &mut history);
            let silent = response.elastic == 0.0 && response.damping == 0.0 && response.adhesion == 0.0;
            assert!(silent, "{label}: {response:?} beyond {reach:e} m");
            let energy = case.energy_with(input.overlap, &history);
            assert!(energy == 0.0, "{label}: {energy:e} J stored beyond {reach:e} m");
        });
    });
}

#[test]
fn signs_hold_along_every_path() {
    each_path(|case, path, label| {
        path.walk(case, |m| {
            assert!(m.response.damping >= 0.0, "{label}: damping {:e}", m.response.damping);
            assert!(
                m.response.adhesion >= 0.0,
                "{label}: adhesion {:e}",
                m.response.adhesion
            );
            let stiffness = case.stiffness_with(m.input.overlap, &m.after);
            assert!(stiffness.is_finite(), "{label}: stiffness {stiffness:e}");
            assert!(m.after.iter().all(|x| x.is_finite()), "{label}: {:?}", m.after);
        });
    });
}

#[track_caller]
fn assert_same_history(label: &str, a: &[f64], b: &[f64], tolerance: f64) {
    for (k, (x, y)) in a.iter().zip(b).enumerate() {
        let close = (x - y).abs() <= tolerance * x.abs().max(y.abs());
        assert!(close, "{label}: value {k} of the history is {x:e} or {y:e}");
    }
}

#[test]
fn a_second_look_at_a_place_changes_nothing() {
    each_path(|case, path, label| {
        path.walk(case, |m| {
            let input = NormalInput::at(case.size, m.input.overlap, m.input.rate);
            let mut once = m.before;
            let first = case.respond_with(&input, &mut once);
            let mut twice = once;
            let second = case.respond_with(&input, &mut twice);
            assert_same_history(label, &once, &twice, 1e-12);
            let scale = first.elastic.abs() + first.adhesion;
            let close = (first.elastic - second.elastic).abs() <= 1e-9 * scale;
            assert!(close, "{label}: {first:?}, then {second:?}");
            let stored = case.energy_with(m.input.overlap, &once).abs() + scale * m.input.overlap.abs();
            assert!(
                second.lost.abs() <= 1e-9 * stored,
                "{label}: lost {:e} in no move",
                second.lost
            );
        });
    });
}

#[test]
fn a_way_that_changes_nothing_is_retraced() {
    // from a place in contact out a little and back in windows: where the law lost nothing and remembers the same, the
    // forces on the way back are those on the way out
    let mut retraced = 0;
    each_path(|case, path, label| {
        let mut random = Random(3);
        path.walk(case, |m| {
            if random.share() > 0.005 || m.response.elastic == 0.0 {
                return;
            }
            let way = random.between(0.0, 0.3) * path.amplitudes[0];
            let at = m.input.overlap + m.input.half_window * m.input.rate.signum();
            let parts = 200;
            let half_window = 0.5 * way / f64::from(parts);
            let (mut forces, mut history, mut lost, mut largest) = (vec![], m.after, 0.0, 0.0f64);
            for part in 0..2 * parts {
                let outward = part < parts;
                let place = if outward { part } else { 2 * parts - 1 - part };
                let input = NormalInput {
                    half_window,
                    ..NormalInput::at(
                        case.size,
                        at - way * (f64::from(place) + 0.5) / f64::from(parts),
                        if outward { -1.0 } else { 1.0 },
                    )
                };
                let response = case.respond_with(&input, &mut history);
                forces.push(response.elastic);
                lost += response.lost.abs();
                largest = largest.max(response.elastic.abs());
            }
            let same = |(x, y): (&f64, &f64)| (x - y).abs() <= 1e-9 * x.abs();
            if lost > 1e-9 * largest * way || !m.after.iter().zip(&history).all(same) {
                return;
            }
            retraced += 1;
            for part in 0..parts as usize {
                let (out, back) = (forces[part], forces[2 * parts as usize - 1 - part]);
                assert!(
                    (out - back).abs() <= 1e-6 * largest,
                    "{label}: {out:e} N out, {back:e} N back"
                );
            }
            let stored = [&m.after, &history].map(|h| case.energy_with(at, h));
            assert!(
                (stored[0] - stored[1]).abs() <= 1e-6 * largest * way,
                "{label}: stored {stored:?}"
            );
        });
    });
}

impl Units {
    fn path(self, path: &Path) -> Path {
        Path {
            mean: path.mean * self.length,
            amplitudes: path.amplitudes.map(|a| a * self.length),
            period: path.period * self.time,
            ..path.clone()
        }
    }
}

#[test]
fn memory_scales_as_the_declared_dimensions() {
    let units = OTHER_UNITS;
    for (index, (case, values)) in memory_cases().into_iter().enumerate() {
        let scaled = scaled_values(case.info, &values, units);
        let other = NormalCase {
            law: NormalLaw::build(case.info.name, &scaled, &units.pair(&case.pair)).unwrap(),
            size: units.size(case.size),
            ..case
        };
        let label = format!("{} with {values:?}", case.name());
        let close = |what: &str, dimension: Dimension, a: f64, b: f64, scale: f64| {
            let expected = units.of(dimension) * a;
            let allowed = 1e-6 * units.of(dimension) * scale.max(a.abs());
            assert!(
                (b - expected).abs() <= allowed,
                "{label}: {what} {b:e}, expected {expected:e}"
            );
        };
        let path = Path::new(&case, 1e-3 * case.size.radius, &mut Random(index as u64));
        let mut moments = vec![];
        path.walk(&case, |m| {
            let energy = case.energy_with(m.input.overlap, &m.after);
            let stiffness = case.stiffness_with(m.input.overlap, &m.after);
            moments.push((m.response, m.after, energy, stiffness, case.reach_with(&m.after)));
        });
        let largest = |f: &dyn Fn(&NormalResponse) -> f64| moments.iter().map(|m| f(&m.0).abs()).fold(0.0, f64::max);
        let (forces, dampings) = (largest(&|r| r.elastic), largest(&|r| r.damping));
        let most = |value: usize| moments.iter().map(|m| m.1[value].abs()).fold(0.0, f64::max);
        let most: Vec<f64> = (0..case.info.history).map(most).collect();
        let mut k = 0;
        units.path(&path).walk(&other, |m| {
            let (response, history, energy, stiffness, reach) = &moments[k];
            close("force", Dimension::FORCE, response.elastic, m.response.elastic, forces);
            close(
                "adhesion",
                Dimension::FORCE,
                response.adhesion,
                m.response.adhesion,
                forces,
            );
            close(
                "damping",
                Dimension::DAMPING,
                response.damping,
                m.response.damping,
                dampings,
            );
            let energies = forces * 1e-3 * case.size.radius;
            close("loss", Dimension::ENERGY, response.lost, m.response.lost, energies);
            let other_energy = other.energy_with(m.input.overlap, &m.after);
            close("energy", Dimension::ENERGY, *energy, other_energy, energies);
            let other_stiffness = other.stiffness_with(m.input.overlap, &m.after);
            close("stiffness", Dimension::STIFFNESS, *stiffness, other_stiffness, 0.0);
            close(
                "reach",
                Dimension::LENGTH,
                *reach,
                other.reach_with(&m.after),
                1e-3 * case.size.radius,
            );
            for (value, dimension) in case.info.history_dimensions.iter().enumerate() {
                close("history", *dimension, history[value], m.after[value], most[value]);
            }
            k += 1;
        });
        let times = [case, other].map(|c| c.collision_time(1e-3 * c.size.radius));
        close("collision time", Dimension::TIME, times[0], times[1], 0.0);
        let reaches = [case, other].map(|c| c.largest_reach());
        close("largest reach", Dimension::LENGTH, reaches[0], reaches[1], 0.0);
    }
}

#[test]
fn a_law_with_memory_does_not_see_which_material_is_first() {
    for (case, values) in memory_cases() {
        let swapped = MaterialPair {
            a: case.pair.b,
            b: case.pair.a,
        };
        let law = NormalLaw::build(case.info.name, &values, &swapped).unwrap();
        assert_eq!(law, case.law, "{} with {values:?}", case.name());
    }
}
