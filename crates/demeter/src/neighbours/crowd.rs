//! The box in which nearly all grains are: a few that flew far off must not make the cells of all others large.

use super::cells::Frame;
use super::classes::SizeClasses;
use super::vicinity::Bounds;
use crate::comm::Single;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Stretches of every direction in which grains are counted.
const BINS: usize = 64;
/// Least number of grains that are a crowd.
const LEAST: usize = 64;
/// Most times that the box is cut: each is worth a factor of 2 at least.
const MOST_CUTS: usize = 16;
/// Share of the volume above which a cut is not worth its count.
const WORTH: f64 = 0.5;

/// Cells for each grain above which a crowd is looked for.
const SPARSE: f64 = 16.0;

/// Where grains are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    /// Around the centres of all.
    pub(crate) all: Bounds,
    /// Around those of nearly all.
    pub(crate) crowd: Bounds,
}

impl Extent {
    /// Of grains of these classes with these bounds, for a search of all pairs closer than `skin` to touching; `counts` counts all grains
    /// in a box, if that is asked for.
    pub(crate) fn find(
        all: Bounds,
        classes: &SizeClasses,
        comm: &Single,
        skin: f64,
        counts: impl FnMut(Bounds) -> Counts,
    ) -> Self {
        let members = classes.members().iter();
        let (most, largest) = members.copied().max_by_key(|(members, _)| *members).unwrap_or((0, 0.0));
        let size = Frame::of(Self { all, crowd: all }, comm).size;
        let crowd = match are_scattered(size, 2.0 * largest + skin, most) {
            true => crowd(all, classes.members().iter().map(|(members, _)| members).sum(), counts),
            false => all,
        };
        Self { all, crowd }
    }
}

/// Whether a box holds far more cells than grains, so that a crowd may be worth looking for.
pub(crate) fn are_scattered(size: DVec3, cell: f64, grains: usize) -> bool {
    (size / cell).max(DVec3::ONE).element_product() > SPARSE * grains as f64
}

/// Numbers of grains along every direction of a box; those outside of it count at its ends.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Counts(Vec<u32>);

impl Counts {
    /// Of no grains.
    pub(crate) fn none() -> Self {
        Self(vec![0; 3 * BINS])
    }

    /// Of some places in a box.
    pub(crate) fn of(places: impl Iterator<Item = DVec3>, within: Bounds) -> Self {
        let mut counts = Self::none();
        let per_length = DVec3::splat(BINS as f64) / (within.upper - within.lower);
        for place in places {
            let at = (place - within.lower) * per_length;
            for axis in 0..3 {
                // a cast to whole numbers ends at 0, which is also what no number becomes
                counts.0[axis * BINS + (at[axis] as usize).min(BINS - 1)] += 1;
            }
        }
        counts
    }

    /// Those of others as well.
    pub(crate) fn plus(mut self, others: Self) -> Self {
        self.0.iter_mut().zip(others.0).for_each(|(own, others)| *own += others);
        self
    }

    /// How many bins at either end of a direction hold no more than a few grains together.
    fn nearly_empty(&self, axis: usize, few: u32) -> [usize; 2] {
        let bins = &self.0[axis * BINS..(axis + 1) * BINS];
        let cut = |counts: &mut dyn Iterator<Item = &u32>| {
            let mut sum = 0;
            counts
                .take_while(|&&count| {
                    sum += count;
                    sum <= few
                })
                .count()
        };
        [cut(&mut bins.iter()), cut(&mut bins.iter().rev())]
    }
}

/// The box around all grains without the few outermost ones: at each of its sides no more lie outside than the root of their number, so that all
/// of these in one cell cost no more than some tests for each grain. `counts` counts all grains in a box.
pub(crate) fn crowd(all: Bounds, grains: usize, mut counts: impl FnMut(Bounds) -> Counts) -> Bounds {
    let few = (grains as f64).sqrt() as u32;
    let mut within = all;
    for _ in 0..MOST_CUTS {
        if grains < LEAST {
            break;
        }
        let counts = counts(within);
        let bin = (within.upper - within.lower) / BINS as f64;
        let (mut cut, mut left) = (within, 1.0);
        for axis in 0..3 {
            let [below, above] = counts.nearly_empty(axis, few);
            // all in one place
            if below + above >= BINS || bin[axis] <= 0.0 {
                continue;
            }
            cut.lower[axis] += bin[axis] * below as f64;
            cut.upper[axis] -= bin[axis] * above as f64;
            left *= (BINS - below - above) as f64 / BINS as f64;
        }
        if left > WORTH {
            break;
        }
        within = cut;
    }
    within
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(places: &[DVec3]) -> Bounds {
        let all = places
            .iter()
            .fold(Bounds::NOTHING, |all, &p| all.join(Bounds { lower: p, upper: p }));
        crowd(all, places.len(), |within| Counts::of(places.iter().copied(), within))
    }

    fn bed() -> Vec<DVec3> {
        let at = |k: u32| DVec3::new(f64::from(k % 20), f64::from(k / 20 % 20), f64::from(k / 400));
        (0..8000).map(at).collect()
    }

    #[test]
    fn a_few_far_away_are_left_out_however_far() {
        for distance in [100.0, 1e4, 1e9] {
            let mut places = bed();
            places.extend([DVec3::new(distance, -distance, 5.0), DVec3::splat(-3.0 * distance)]);
            let Bounds { lower, upper } = found(&places);
            assert!((upper - lower).max_element() < 40.0, "{distance}: {lower} {upper}");
            let inside = places
                .iter()
                .filter(|p| p.cmpge(lower).all() && p.cmple(upper).all())
                .count();
            assert!(inside > 7400, "{inside}");
        }
    }

    #[test]
    fn grains_that_are_spread_out_are_all_in_it() {
        let mut places = bed();
        let Bounds { lower, upper } = found(&places);
        assert_eq!((lower, upper), (DVec3::ZERO, DVec3::splat(19.0)));
        // two crowds far apart are not one with a few others
        places.extend(bed().into_iter().map(|p| p + DVec3::X * 1e4));
        assert_eq!(found(&places).upper.x, 1e4 + 19.0);
        // nor are places that are all one, or none
        assert_eq!(found(&vec![DVec3::ONE; 1000]).upper, DVec3::ONE);
        assert_eq!(found(&[]).lower, DVec3::INFINITY);
    }
}
