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
    /// Sums over the grains that left of mass times powers 0 to 3 of their time.
    powers: [f64; 4],
    /// Shortest and longest time in steps.
    extremes: Option<(u64, u64)>,
    /// Mass by bins; the last is that of all longer times.
    bins: Vec<f64>,
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
        let time = steps as f64 * dt;
        state.left += 1;
        for (sum, power) in state
            .powers
            .iter_mut()
            .zip([1.0, time, time * time, time * time * time])
        {
            *sum += mass * power;
        }
        let (least, most) = state.extremes.unwrap_or((steps, steps));
        state.extremes = Some((least.min(steps), most.max(steps)));
        if let Some((width, count)) = self.bins {
            state.bins.resize(count as usize + 1, 0.0);
            let bin = ((time / width) as usize).min(count as usize);
            state.bins[bin] += mass;
        }
    }

    /// Its values, in the order of [`RESIDENCE_COLUMNS`], after a look.
    pub fn measure(&self, sim: &Simulation, state: &ResidenceState) -> Vec<Value> {
        let mass: f64 = state.inside.iter().map(|grain| grain.2).sum();
        let aged: f64 = (state.inside.iter())
            .map(|grain| grain.2 * (sim.step - grain.1) as f64 * sim.dt)
            .sum();
        let [m0, m1, m2, m3] = state.powers;
        let mean = m1 / m0;
        let variance = (m2 / m0 - mean * mean).max(0.0);
        let third = m3 / m0 - 3.0 * mean * m2 / m0 + 2.0 * mean * mean * mean;
        let deviation = variance.sqrt();
        let extreme = |pick: fn(&(u64, u64)) -> u64| {
            let steps = state.extremes.as_ref().map(pick);
            Value::Number(steps.map_or(f64::NAN, |steps| steps as f64 * sim.dt))
        };
        vec![
            Value::Count(state.inside.len() as u64),
            Value::Number(mass),
            Value::Number(aged / mass),
            Value::Count(state.left),
            Value::Number(m0),
            Value::Number(mean),
            Value::Number(if m0 > 0.0 { deviation } else { f64::NAN }),
            Value::Number(third / (deviation * variance)),
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
        assert_eq!(end.powers[..2], [9.0, 2.0 + 3.0 + 10.0 + 9.0]);
        assert_eq!(residence.distribution(&end), [0.0, 3.0, 1.0, 5.0]);
        assert!(residence.fits(&end));
        assert!(end.inside.is_empty());
    }
}
