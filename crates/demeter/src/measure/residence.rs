//! How long grains stay in a region.
//!
//! Every [`LOOK_EVERY`] steps it is looked which grains are in the region. The time of a grain begins when it is seen
//! in the region first and ends when it is not there any more, or gone; a grain that comes back begins anew. So
//! times are told to `LOOK_EVERY` steps.

use super::told_first::each_grain;
use super::{LOOK_EVERY, Selection, ToldColumn, Value, holds};
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use serde::{Deserialize, Serialize};

/// Most bins of residence times.
pub const MAX_RESIDENCE_BINS: u32 = 10_000;

/// Columns of residence times.
pub const RESIDENCE_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new("inside", "", "grains that are in the region"),
    ToldColumn::new("mass inside", "kg", "their mass"),
    ToldColumn::new("mean age", "s", "mean time since they came, by mass; NaN without any"),
    ToldColumn::new("left", "", "grains that left the region since the start of the run"),
    ToldColumn::new("mass left", "kg", "their mass"),
    ToldColumn::new(
        "mean residence",
        "s",
        "mean time that those which left had stayed, by mass; NaN without any",
    ),
    ToldColumn::new("residence deviation", "s", "standard deviation of that time, by mass"),
    ToldColumn::new(
        "residence skewness",
        "",
        "third central moment of that time over the cube of its deviation",
    ),
    ToldColumn::new("shortest residence", "s", "shortest of these times"),
    ToldColumn::new("longest residence", "s", "longest of these times"),
];

/// Where and of which grains residence is measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Residence {
    /// The region.
    pub zone: Zone,
    /// Which grains count.
    pub selection: Selection,
    /// Width [s] and number of the bins of the distribution.
    pub bins: Option<(f64, u32)>,
}

/// What was seen so far.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ResidenceState {
    /// Id, step at which it came, and mass [kg] of every grain inside, sorted by id.
    inside: Vec<(u32, u64, f64)>,
    left: u64,
    /// Time of the first grain that left, in steps. Others' are told from there, so that moments of times that hardly differ do not
    /// drown in the rounding of those of the times.
    first: Option<u64>,
    /// Sums over the grains that left of mass times powers 0 to 3 of their time beyond that.
    powers: [f64; 4],
    /// Shortest and longest time in steps.
    extremes: Option<(u64, u64)>,
    /// Mass by bins; the last is that of all longer times.
    bins: Vec<f64>,
}

impl ResidenceState {
    /// Sum over the grains inside of their mass times what is told of the step at which each came; 0 of none, where
    /// [`Iterator::sum`] is -0.
    fn sum_inside(&self, of: impl Fn(u64) -> f64) -> f64 {
        let add = |sum, &(_, came, mass): &(u32, u64, f64)| sum + mass * of(came);
        self.inside.iter().fold(0.0, add)
    }
}

impl Residence {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        RESIDENCE_COLUMNS.iter().map(|c| c.title(name)).collect()
    }

    /// Looks when it is time.
    pub fn watch(&self, sim: &Simulation, origins: &Origins, state: &mut ResidenceState) {
        if sim.step.is_multiple_of(LOOK_EVERY) {
            self.look(sim, origins, state);
        }
    }

    /// Looks which grains are inside.
    pub fn look(&self, sim: &Simulation, origins: &Origins, state: &mut ResidenceState) {
        let grains = &sim.grains;
        let is_inside = |g: usize| holds(sim, &self.zone, g) && self.selection.holds(grains, origins, g);
        let mut now = Vec::new();
        each_grain(
            sim,
            is_inside,
            |g| grains.mass(g),
            |id, mass| {
                now.push((id, sim.step, mass));
            },
        );
        self.update(state, now, sim.step, sim.dt);
    }

    fn update(&self, state: &mut ResidenceState, mut now: Vec<(u32, u64, f64)>, step: u64, dt: f64) {
        for grain in &mut now {
            if let Ok(before) = state.inside.binary_search_by_key(&grain.0, |seen| seen.0) {
                grain.1 = state.inside[before].1;
            }
        }
        for &(id, came, mass) in &std::mem::take(&mut state.inside) {
            if now.binary_search_by_key(&id, |grain| grain.0).is_err() {
                self.note(state, step - came, mass, dt);
            }
        }
        state.inside = now;
    }

    /// Books a grain that left after some steps.
    fn note(&self, state: &mut ResidenceState, steps: u64, mass: f64, dt: f64) {
        state.left += 1;
        let first = *state.first.get_or_insert(steps);
        let beyond = (steps as f64 - first as f64) * dt;
        for (k, sum) in state.powers.iter_mut().enumerate() {
            *sum += mass * beyond.powi(k as i32);
        }
        let (least, most) = state.extremes.unwrap_or((steps, steps));
        state.extremes = Some((least.min(steps), most.max(steps)));
        if let Some((width, count)) = self.bins {
            state.bins.resize(count as usize + 1, 0.0);
            let bin = ((steps as f64 * dt / width) as usize).min(count as usize);
            state.bins[bin] += mass;
        }
    }

    /// Its values, in the order of [`RESIDENCE_COLUMNS`], after a look.
    pub fn measure(&self, sim: &Simulation, state: &ResidenceState) -> Vec<Value> {
        let mass = state.sum_inside(|_| 1.0);
        let aged = state.sum_inside(|came| (sim.step - came) as f64 * sim.dt);
        let [mean, deviation, skewness] = moments(state, sim.dt);
        let extreme = |pick: fn(&(u64, u64)) -> u64| {
            let steps = state.extremes.as_ref().map(pick);
            Value::Number(steps.map_or(f64::NAN, |steps| steps as f64 * sim.dt))
        };
        vec![
            Value::Count(state.inside.len() as u64),
            Value::Number(mass),
            Value::Number(aged / mass),
            Value::Count(state.left),
            Value::Number(state.powers[0]),
            Value::Number(mean),
            Value::Number(deviation),
            Value::Number(skewness),
            extreme(|e| e.0),
            extreme(|e| e.1),
        ]
    }

    /// Mass that left by bins of residence time, that of longer times last [kg].
    pub fn distribution(&self, state: &ResidenceState) -> Vec<f64> {
        let count = self.bins.map_or(0, |(_, count)| count as usize + 1);
        let mut bins = state.bins.clone();
        bins.resize(count, 0.0);
        bins
    }

    /// Whether the state of a checkpoint is one of this measure.
    pub fn fits(&self, state: &ResidenceState) -> bool {
        let count = self.bins.map_or(0, |(_, count)| count as usize + 1);
        state.bins.is_empty() || state.bins.len() == count
    }
}

/// Mean and standard deviation [s] and skewness of the times of the grains that left, by mass; not a number where there are none, the
/// skewness also where all times are the same.
fn moments(state: &ResidenceState, dt: f64) -> [f64; 3] {
    let [m0, m1, m2, m3] = state.powers;
    let beyond = m1 / m0;
    let square = m2 / m0 - beyond * beyond;
    let variance = if square > ROUNDING * m2 / m0 {
        square
    } else {
        0.0 * square
    };
    let third = m3 / m0 - 3.0 * beyond * m2 / m0 + 2.0 * beyond * beyond * beyond;
    let skewness = if variance > 0.0 {
        third / (variance * variance.sqrt())
    } else {
        f64::NAN
    };
    [state.first.unwrap_or(0) as f64 * dt + beyond, variance.sqrt(), skewness]
}

/// A variance of less than this share of the mean square is rounding.
const ROUNDING: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_counted_from_coming_to_going() {
        let residence = Residence {
            zone: Zone::default(),
            selection: Selection::default(),
            bins: Some((1.0, 3)),
        };
        let mut state = ResidenceState::default();
        let mut look = |step: u64, ids: &[u32]| {
            let now = ids.iter().map(|id| (*id, step, f64::from(*id))).collect();
            residence.update(&mut state, now, step, 0.1);
            state.clone()
        };
        look(0, &[1]);
        look(10, &[1, 2, 3]);
        // grain 1 stayed 2 s, grain 3 comes back
        let state_then = look(20, &[2]);
        assert_eq!((state_then.left, state_then.extremes), (2, Some((10, 20))));
        look(30, &[2, 3]);
        let end = look(60, &[]);
        assert_eq!(end.left, 4);
        // masses 1, 3, 2, 3 with 2, 1, 5 and 3 s
        assert_eq!(end.powers[0], 9.0);
        let mean = (2.0 + 3.0 + 10.0 + 9.0) / 9.0;
        let central = |power: i32| {
            let each =
                [(1.0, 2.0), (3.0, 1.0), (2.0, 5.0), (3.0, 3.0)].map(|(m, t): (f64, f64)| m * (t - mean).powi(power));
            each.iter().sum::<f64>() / 9.0
        };
        let deviation = central(2).sqrt();
        let expected = [mean, deviation, central(3) / (deviation * deviation * deviation)];
        for (found, expected) in moments(&end, 0.1).into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
        assert_eq!(residence.distribution(&end), [0.0, 3.0, 1.0, 5.0]);
        assert!(residence.fits(&end));
        assert_eq!(state_then.sum_inside(|_| 1.0), 2.0);
        let nothing = end.sum_inside(|_| 1.0);
        assert!(nothing == 0.0 && nothing.is_sign_positive(), "{nothing}");
    }

    #[test]
    fn a_plug_has_no_spread_and_a_narrow_one_its_own() {
        let residence = Residence {
            zone: Zone::default(),
            selection: Selection::default(),
            bins: None,
        };
        let of = |times: &[u64]| {
            let mut state = ResidenceState::default();
            times
                .iter()
                .for_each(|&steps| residence.note(&mut state, steps, 0.3, 1e-6));
            moments(&state, 1e-6)
        };
        assert!(of(&[]).iter().all(|value| value.is_nan()));
        let [mean, deviation, skewness] = of(&[700_000; 7]);
        assert!((mean - 0.7).abs() < 1e-15 && deviation == 0.0 && skewness.is_nan());
        // one of four stays a step longer: deviation sqrt(3)/4 steps, skewness 2/sqrt(3)
        let [_, deviation, skewness] = of(&[700_000, 700_000, 700_001, 700_000]);
        assert!(
            (deviation / (1e-6 * 3f64.sqrt() / 4.0) - 1.0).abs() < 1e-9,
            "{deviation}"
        );
        assert!((skewness - 2.0 / 3f64.sqrt()).abs() < 1e-9, "{skewness}");
    }
}
