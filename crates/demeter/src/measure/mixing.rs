//! How well two kinds of grains are mixed: Lacey's index.
//!
//! The box is cut into cells. With the share `p_i` of one kind among the `n_i` grains of cell `i`, and `p` among all `N` grains
//! of the `K` cells that hold any,
//!
//! ```text
//! S^2 = sum n_i/N (p_i - p)^2      S_0^2 = p (1 - p)      S_R^2 = S_0^2 (K - 1)/(N - 1)      M = (S_0^2 - S^2)/(S_0^2 - S_R^2)
//! ```
//!
//! (P. M. C. Lacey, J. Appl. Chem. 4 (1954) 257). `S_0^2` is that of cells that hold one kind each. `S_R^2` is the mean over all ways
//! to deal the kinds out to the places, for cells of any fill: grains of a cell are drawn without putting back, so
//! `E (p_i - p)^2 = p (1 - p)/n_i (N - n_i)/(N - 1)`. So `M` is 0 when the kinds are apart, and 1 in the mean when chance alone
//! mixed them.

use super::{Selection, ToldColumn, Value};
use crate::particles::Origins;
use crate::simulation::Simulation;
use glam::DVec3;

/// Most cells.
pub const MAX_CELLS: u64 = 10_000_000;

/// Columns of a mixing index.
pub const MIXING_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new(
        "Lacey index",
        "",
        "0 when the kinds are apart, 1 in the mean when chance alone mixed them; NaN without both kinds",
    ),
    ToldColumn::new("share", "", "share of the kind among all grains in the box, by number"),
    ToldColumn::new("cells", "", "cells that hold grains"),
];

/// How well a kind of grains is mixed with all others.
#[derive(Clone, Debug, PartialEq)]
pub struct Mixing {
    /// Lower corner of the box [m].
    pub lower: DVec3,
    /// Upper corner [m].
    pub upper: DVec3,
    /// Cells in each direction.
    pub cells: [u32; 3],
    /// The kind.
    pub selection: Selection,
}

impl Mixing {
    /// Titles of its columns.
    pub fn titles(&self, name: &str) -> Vec<String> {
        MIXING_COLUMNS.iter().map(|c| c.title(name)).collect()
    }

    /// Its values now, in the order of [`MIXING_COLUMNS`].
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Value> {
        let grains = &sim.grains;
        let places = (0..grains.len()).map(|g| {
            let place = sim.domain().wrapped(grains.position[g]);
            (place, self.selection.holds(grains, origins, g))
        });
        let (index, share, cells) = self.index(places);
        vec![Value::Number(index), Value::Number(share), Value::Count(cells)]
    }

    /// Index, share, and number of cells that hold grains, of places that are of the kind or not.
    fn index(&self, places: impl Iterator<Item = (DVec3, bool)>) -> (f64, f64, u64) {
        let mut counts = vec![[0u32; 2]; self.cells.iter().map(|n| *n as usize).product()];
        let size = self.upper - self.lower;
        for (place, is_kind) in places {
            if !(place.cmpge(self.lower).all() && place.cmplt(self.upper).all()) {
                continue;
            }
            let cell = |k: usize| {
                let share = (place[k] - self.lower[k]) / size[k];
                ((share * f64::from(self.cells[k])) as usize).min(self.cells[k] as usize - 1)
            };
            let at = (cell(2) * self.cells[1] as usize + cell(1)) * self.cells[0] as usize + cell(0);
            counts[at][0] += 1;
            counts[at][1] += u32::from(is_kind);
        }
        let sum = |k: usize| counts.iter().map(|n| u64::from(n[k])).sum::<u64>() as f64;
        let (all, of_kind) = (sum(0), sum(1));
        let held = counts.iter().filter(|n| n[0] > 0);
        let cells = held.clone().count() as u64;
        let p = of_kind / all;
        let variance: f64 = held
            .map(|n| {
                let (n, kind) = (f64::from(n[0]), f64::from(n[1]));
                n / all * (kind / n - p) * (kind / n - p)
            })
            .sum();
        let apart = p * (1.0 - p);
        let by_chance = apart * (cells as f64 - 1.0) / (all - 1.0);
        // one kind alone, or one grain in each cell, tells nothing
        let index = match apart > 0.0 && by_chance < apart {
            true => (apart - variance) / (apart - by_chance),
            false => f64::NAN,
        };
        (index, p, cells)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn box_of(cells: [u32; 3]) -> Mixing {
        Mixing {
            lower: DVec3::ZERO,
            upper: DVec3::ONE,
            cells,
            selection: Selection::default(),
        }
    }

    fn numbers(seed: u64) -> impl FnMut() -> f64 {
        let mut x = seed;
        move || {
            x = x
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (x >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    #[test]
    fn kinds_that_are_apart_have_no_mixing_and_chance_mixes_to_one_in_the_mean() {
        let mixing = box_of([4, 5, 3]);
        let mut next = numbers(5);
        let (mut sum, runs) = (0.0, 400);
        for _ in 0..runs {
            let places: Vec<DVec3> = (0..300).map(|_| DVec3::new(next() * next(), next(), next())).collect();
            let apart = mixing.index(places.iter().map(|p| (*p, p.x < 0.25)));
            assert!(apart.0.abs() < 1e-12, "{apart:?}");
            let labels: Vec<bool> = places.iter().map(|_| next() < 0.3).collect();
            sum += mixing.index(places.iter().copied().zip(labels)).0;
        }
        // the index of one run scatters by about sqrt(2 K)/(N - K), 0.045
        let mean = sum / f64::from(runs);
        assert!((mean - 1.0).abs() < 4.0 * 0.045 / f64::from(runs).sqrt(), "{mean}");
    }

    #[test]
    fn without_two_kinds_or_with_a_cell_for_every_grain_there_is_no_index() {
        let places = [0.1, 0.3, 0.6, 0.9].map(DVec3::splat);
        assert!(
            box_of([1, 1, 2])
                .index(places.map(|p| (p, true)).into_iter())
                .0
                .is_nan()
        );
        assert!(
            box_of([9, 9, 9])
                .index(places.map(|p| (p, p.x > 0.5)).into_iter())
                .0
                .is_nan()
        );
        let (index, share, cells) = box_of([1, 1, 2]).index(places.map(|p| (p, p.x > 0.5)).into_iter());
        assert_eq!((index, share, cells), (0.0, 0.5, 2));
        let outside = [DVec3::splat(2.0), DVec3::NEG_ONE].map(|p| (p, true));
        assert_eq!(box_of([2, 2, 2]).index(outside.into_iter()).2, 0);
    }
}
