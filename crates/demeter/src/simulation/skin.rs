//! How far beyond touching candidates are looked for.
//!
//! A wide skin lasts for more steps, and costs more candidates that are looked at in vain. With a skin `s` that motion uses up at
//! `u` metres per step, a rebuild of cost `R` every `s/u` steps, and `e s` candidates that are no contacts, a step costs
//! `R u/s + e s`. That is least at `s = sqrt(R u/e)`, where they cost as much between two rebuilds as a rebuild.
//!
//! `R` is counted, never timed, so a run has the same bits on every machine: see [`REBUILD_PER_GRAIN`] and its neighbours.

use crate::neighbours::Neighbours;
use crate::particles::{Domain, Grains};
use serde::{Deserialize, Serialize};

/// Cost of a rebuild per grain, in candidates that are no contacts and wait for a step (0.8 ns each, their memory counted; `benches/README.md`).
const REBUILD_PER_GRAIN: f64 = 180.0;

/// Cost of a rebuild per candidate found, in the same unit.
const REBUILD_PER_CANDIDATE: f64 = 36.0;

/// Cost of a rebuild per contact handed over, in the same unit.
const REBUILD_PER_CONTACT: f64 = 12.0;

/// Cost of a candidate that is looked at in vain in every step, in the same unit: where no table tells for some steps which may act.
const LOOKED_AT: f64 = 6.0;

/// A skin changes at most by this factor at once.
const LARGEST_CHANGE: f64 = 2.0;

/// Largest number of candidates per grain that a wider skin may be expected to find: memory.
const MOST_CANDIDATES: f64 = 12.0;

/// Steps between two looks whether a skin is too wide.
const LOOK_EVERY: u64 = 16;

/// Costs of idle candidates since the last rebuild, in rebuilds, from which on a skin is given up that is too wide.
const PATIENCE: f64 = 2.0;

/// A skin that is not used up is given up when one narrower by this factor would do.
const WASTE: f64 = 1.5;

/// Narrowest and widest skin, as shares of the mean radius.
const SHARES: [f64; 2] = [0.005, 1.0];

/// Room for the bulges of two grains across a periodic side, as a share of the largest radius.
pub(crate) const ROOM_FOR_BULGES: f64 = 0.5;

/// Distance beyond touching at which bodies become candidates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Skin {
    /// Always this [m].
    Fixed(f64),
    /// Follows the motion, from this one on [m].
    Tuned(f64),
}

impl Skin {
    /// The skin that a run begins with [m].
    pub fn first(self) -> f64 {
        match self {
            Self::Fixed(skin) | Self::Tuned(skin) => skin,
        }
    }
}

/// The skin in use, and what decides on the next.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct SkinTuner {
    /// Narrowest and widest skin [m]; nothing where the skin is fixed.
    limits: Option<(f64, f64)>,
    /// Step of the latest rebuild.
    rebuilt_at: u64,
}

/// What is counted of a run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counts {
    pub(crate) grains: usize,
    pub(crate) candidates: usize,
    pub(crate) contacts: usize,
    /// Whether all candidates are looked at in every step.
    pub(crate) looks_at_all: bool,
}

impl Counts {
    pub(crate) fn new(neighbours: &Neighbours, contacts: usize, looks_at_all: bool) -> Self {
        Self {
            grains: neighbours.former.len(),
            candidates: neighbours.total(),
            contacts,
            looks_at_all,
        }
    }

    /// Cost of a rebuild, in candidates that wait for a step.
    fn rebuild(self) -> f64 {
        REBUILD_PER_GRAIN * self.grains as f64
            + REBUILD_PER_CANDIDATE * self.candidates as f64
            + REBUILD_PER_CONTACT * self.contacts as f64
    }

    /// Candidates that are no contacts; at least one, so that one can divide by it.
    fn idle(self) -> f64 {
        self.candidates.saturating_sub(self.contacts).max(1) as f64
    }

    /// What they cost in a step.
    fn vain(self) -> f64 {
        self.idle() * if self.looks_at_all { LOOKED_AT } else { 1.0 }
    }
}

impl SkinTuner {
    /// `reach`: gap across which any law acts [m]; `is_coupled`: whether contacts feel each other.
    pub(crate) fn new(skin: Skin, grains: &Grains, domain: &Domain, (reach, is_coupled): (f64, bool)) -> Self {
        let limits = match skin {
            Skin::Fixed(_) => None,
            Skin::Tuned(first) => {
                let mean = grains.radii().sum::<f64>() / grains.len().max(1) as f64;
                let largest = grains.radii().fold(0.0, f64::max);
                // a grain must not meet two images of one partner
                let bulges = if is_coupled { ROOM_FOR_BULGES * largest } else { 0.0 };
                let beyond_touch = reach + 0.5 * bulges;
                let room = (0..3)
                    .filter(|&axis| domain.periodic[axis])
                    .map(|axis| 0.49 * domain.size()[axis] - 2.0 * largest - beyond_touch)
                    .fold(f64::INFINITY, f64::min);
                let [least, most] = SHARES.map(|share| share * mean);
                Some((least.min(first), most.min(room).max(first)))
            }
        };
        Self { limits, rebuilt_at: 0 }
    }

    /// Whether its numbers are possible, as they are unless a file was tampered with.
    pub(crate) fn fits(&self, skin: f64, step: u64) -> bool {
        let is_length = |x: f64| x > 0.0 && x.is_finite();
        let limits = self
            .limits
            .is_none_or(|(least, most)| is_length(least) && least <= skin && skin <= most);
        is_length(skin) && limits && self.rebuilt_at <= step
    }

    /// The narrowest skin [m]; nothing where the skin is fixed.
    pub(crate) fn least(&self) -> Option<f64> {
        self.limits.map(|(least, _)| least)
    }

    /// Notes that candidates were found.
    pub(crate) fn note_rebuild(&mut self, step: u64) {
        self.rebuilt_at = step;
    }

    /// The next skin when the present one was used up.
    pub(crate) fn after_use(&self, skin: f64, step: u64, counts: Counts) -> f64 {
        let steps = (step - self.rebuilt_at).max(1) as f64;
        self.next(skin, skin / steps, counts)
    }

    /// What is counted, when it is time to see whether the present skin is much too wide: idle candidates have cost some rebuilds.
    pub(crate) fn counts_when_wide(&self, step: u64, counts: impl FnOnce() -> Counts) -> Option<Counts> {
        let steps = step - self.rebuilt_at;
        if self.limits.is_none() || steps == 0 || !steps.is_multiple_of(LOOK_EVERY) {
            return None;
        }
        Some(counts()).filter(|counts| steps as f64 * counts.vain() >= PATIENCE * counts.rebuild())
    }

    /// The next skin when the present one is much too wide, of which only `used` was used so far [m].
    pub(crate) fn instead_of_wide(&self, skin: f64, used: f64, step: u64, counts: Counts) -> Option<f64> {
        let steps = step - self.rebuilt_at;
        let next = self.next(skin, used / steps as f64, counts);
        (next * WASTE <= skin).then_some(next)
    }

    /// The best skin when `per_step` of it is used up in a step [m].
    fn next(&self, skin: f64, per_step: f64, counts: Counts) -> f64 {
        let Some((least, most)) = self.limits else {
            return skin;
        };
        let per_length = counts.idle() / skin;
        let best = (counts.rebuild() * per_step * skin / counts.vain()).sqrt();
        let room = MOST_CANDIDATES * counts.grains as f64 - counts.contacts as f64;
        let widest = (room / per_length).max(least).min(most);
        let changed = best.clamp(skin / LARGEST_CHANGE, skin * LARGEST_CHANGE);
        changed.max(least).min(widest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TUNER: SkinTuner = SkinTuner {
        limits: Some((1e-3, 1.0)),
        rebuilt_at: 0,
    };

    /// Counts of a packing whose candidates grow with the skin.
    fn counts(skin: f64) -> Counts {
        Counts {
            grains: 1000,
            candidates: 2000 + (20_000.0 * skin) as usize,
            contacts: 2000,
            looks_at_all: false,
        }
    }

    /// The next skin, when there is any reason to change it.
    fn instead_of_wide(tuner: &SkinTuner, skin: f64, used: f64, step: u64) -> Option<f64> {
        let counts = tuner.counts_when_wide(step, || counts(skin))?;
        tuner.instead_of_wide(skin, used, step, counts)
    }

    /// What a step costs with a skin, of which motion uses `per_step`.
    fn cost(skin: f64, per_step: f64) -> f64 {
        counts(skin).rebuild() * per_step / skin + counts(skin).vain()
    }

    #[test]
    fn a_skin_that_is_used_up_comes_to_the_cheapest() {
        for (first, per_step) in [(0.01, 1e-3), (0.5, 1e-3), (0.1, 1e-5), (0.02, 1e-4)] {
            let mut skin: f64 = first;
            for _ in 0..40 {
                let steps = (skin / per_step).ceil() as u64;
                skin = TUNER.after_use(skin, steps, counts(skin));
            }
            let all = (1..400).map(|k| cost(f64::from(k) * 2.5e-3, per_step));
            let least = all.fold(f64::INFINITY, f64::min);
            let found = cost(skin, per_step);
            assert!(found < 1.1 * least, "{per_step}: {skin} costs {found}, not {least}");
        }
    }

    #[test]
    fn a_skin_that_is_not_used_shrinks_to_the_least() {
        let (mut skin, mut rebuilds, mut last) = (0.2, 0, TUNER);
        for step in 1..200_000 {
            if let Some(next) = instead_of_wide(&last, skin, 1e-9, step) {
                assert!(next < skin);
                skin = next;
                last.note_rebuild(step);
                rebuilds += 1;
            }
        }
        assert!(skin < 2e-3, "{skin}");
        assert!(rebuilds < 10, "{rebuilds} rebuilds");
    }

    #[test]
    fn a_skin_that_is_used_up_soon_is_kept() {
        let counts = || counts(0.1);
        // at this pace motion uses it up when idle candidates have cost as much as a rebuild: that is the best skin
        let lasts = (counts().rebuild() / counts().vain()) as u64;
        assert!(lasts > 2 * LOOK_EVERY);
        for step in 1..lasts {
            let used = 0.1 * step as f64 / lasts as f64;
            assert_eq!(instead_of_wide(&TUNER, 0.1, used, step), None);
        }
        let next = TUNER.after_use(0.1, lasts, counts());
        assert!((next - 0.1).abs() < 1e-3, "{next}");
    }

    #[test]
    fn a_fixed_skin_stays() {
        let grains = Grains::default();
        let domain = Domain {
            lower: glam::DVec3::ZERO,
            upper: glam::DVec3::ONE,
            periodic: [true; 3],
            outside: crate::particles::Outside::Stop,
        };
        let fixed = SkinTuner::new(Skin::Fixed(0.1), &grains, &domain, (0.0, false));
        assert_eq!(fixed.after_use(0.1, 3, counts(0.1)), 0.1);
        assert_eq!(instead_of_wide(&fixed, 0.1, 0.0, 1 << 20), None);
    }
}
