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
//!
//! The intensity of segregation is `S^2/S_0^2` (P. V. Danckwerts, Appl. Sci. Res. A 3 (1952) 279), the relative standard deviation
//! `S/p`. Both count chance as segregation: they fall with the number of grains in a cell.

use super::images::{Corners, Periods, around_cylinder};
use super::told_first::each_in_order;
use super::{Selection, ToldColumn, Value};
use crate::particles::Origins;
use crate::simulation::Simulation;
use glam::DVec3;
use std::f64::consts::PI;

/// Most cells.
pub const MAX_CELLS: u64 = 10_000_000;

/// The part of space that is cut into cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MixingSpace {
    /// A box: cells in x, y and z.
    Box {
        /// Lower corner [m].
        lower: DVec3,
        /// Upper corner [m].
        upper: DVec3,
    },
    /// A cylinder: cells outwards (rings of equal area), around the axis and along it.
    Cylinder {
        /// Start of the axis [m].
        start: DVec3,
        /// End of the axis [m].
        end: DVec3,
        /// Radius [m].
        radius: f64,
    },
}

impl MixingSpace {
    /// A box around it.
    fn bounds(&self) -> Corners {
        match *self {
            Self::Box { lower, upper } => (lower, upper),
            Self::Cylinder { start, end, radius } => around_cylinder(start, end, radius),
        }
    }

    /// Where a point lies, each coordinate as a share from 0 to 1 of the way through the cells; nothing outside.
    fn shares(&self, place: DVec3) -> Option<[f64; 3]> {
        match *self {
            Self::Box { lower, upper } => {
                let inside = place.cmpge(lower).all() && place.cmplt(upper).all();
                inside.then(|| ((place - lower) / (upper - lower)).to_array())
            }
            Self::Cylinder { start, end, radius } => {
                let (axis, length) = ((end - start).normalize(), (end - start).length());
                let away = place - start;
                let height = away.dot(axis);
                let outwards = away - axis * height;
                let share = outwards.length_squared() / (radius * radius);
                let first = axis.any_orthonormal_vector();
                let angle = libm::atan2(outwards.dot(axis.cross(first)), outwards.dot(first));
                let inside = share < 1.0 && height >= 0.0 && height < length;
                inside.then(|| [share, angle / (2.0 * PI) + 0.5, height / length])
            }
        }
    }
}

/// Columns of a mixing index.
pub const MIXING_COLUMNS: &[ToldColumn] = &[
    ToldColumn::new(
        "Lacey index",
        "",
        "0 when the kinds are apart, 1 in the mean when chance alone mixed them; NaN without both kinds",
    ),
    ToldColumn::new("share", "", "share of the kind among all grains in the box, by number"),
    ToldColumn::new("cells", "", "cells that hold grains"),
    ToldColumn::new(
        "segregation intensity",
        "",
        "variance of the share over its value when the kinds are apart: 1 apart, 0 when all cells are alike",
    ),
    ToldColumn::new(
        "relative standard deviation",
        "",
        "standard deviation of the share between the cells, over the share",
    ),
];

/// How well a kind of grains is mixed with all others.
#[derive(Clone, Debug, PartialEq)]
pub struct Mixing {
    /// What is cut into cells.
    pub space: MixingSpace,
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

    /// Its values now, in the order of [`MIXING_COLUMNS`]; across periodic sides every image counts that lies in the space.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<Value> {
        let grains = &sim.grains;
        let mut counts = self.empty_cells();
        let (periods, bounds) = (Periods::of(sim), self.space.bounds());
        let tell = |g: usize| {
            let place = sim.comm.wrapped(grains.position[g]);
            let is_in = periods.any_meets((place, place), bounds);
            is_in.then(|| (place, self.selection.holds(grains, origins, g)))
        };
        each_in_order(sim, tell, |(place, is_kind)| {
            periods.each_image((place, place), bounds, &mut |shift, _| {
                if let Some(cell) = self.cell_of(place + shift) {
                    count(&mut counts[cell], is_kind);
                }
            });
        });
        let told = Mixedness::of(&counts);
        vec![
            Value::Number(told.lacey),
            Value::Number(told.share),
            Value::Count(told.cells),
            Value::Number(told.intensity),
            Value::Number(told.relative_deviation),
        ]
    }

    /// For every cell how many grains it holds, and how many of the kind: none.
    fn empty_cells(&self) -> Vec<[u32; 2]> {
        vec![[0; 2]; self.cells.iter().map(|n| *n as usize).product()]
    }

    /// The cell that a place lies in.
    fn cell_of(&self, place: DVec3) -> Option<usize> {
        let shares = self.space.shares(place)?;
        let cell = |k: usize| ((shares[k] * f64::from(self.cells[k])) as usize).min(self.cells[k] as usize - 1);
        Some((cell(2) * self.cells[1] as usize + cell(1)) * self.cells[0] as usize + cell(0))
    }
}

fn count(cell: &mut [u32; 2], is_kind: bool) {
    cell[0] += 1;
    cell[1] += u32::from(is_kind);
}

/// What is told of cells.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Mixedness {
    lacey: f64,
    share: f64,
    cells: u64,
    intensity: f64,
    relative_deviation: f64,
}

impl Mixedness {
    /// Of what cells hold, and of that of the kind.
    fn of(counts: &[[u32; 2]]) -> Self {
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
        Self {
            lacey: index,
            share: p,
            cells,
            intensity: if apart > 0.0 { variance / apart } else { f64::NAN },
            relative_deviation: variance.sqrt() / p,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Mixing {
        /// Indices of places that are of the kind or not.
        fn index(&self, places: impl Iterator<Item = (DVec3, bool)>) -> Mixedness {
            let mut counts = self.empty_cells();
            for (place, is_kind) in places {
                if let Some(cell) = self.cell_of(place) {
                    count(&mut counts[cell], is_kind);
                }
            }
            Mixedness::of(&counts)
        }
    }

    fn box_of(cells: [u32; 3]) -> Mixing {
        Mixing {
            space: MixingSpace::Box {
                lower: DVec3::ZERO,
                upper: DVec3::ONE,
            },
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
            assert!(
                apart.lacey.abs() < 1e-12 && (apart.intensity - 1.0).abs() < 1e-12,
                "{apart:?}"
            );
            let labels: Vec<bool> = places.iter().map(|_| next() < 0.3).collect();
            sum += mixing.index(places.iter().copied().zip(labels)).lacey;
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
                .lacey
                .is_nan()
        );
        assert!(
            box_of([9, 9, 9])
                .index(places.map(|p| (p, p.x > 0.5)).into_iter())
                .lacey
                .is_nan()
        );
        let told = box_of([1, 1, 2]).index(places.map(|p| (p, p.x > 0.5)).into_iter());
        assert_eq!((told.lacey, told.share, told.cells), (0.0, 0.5, 2));
        assert_eq!((told.intensity, told.relative_deviation), (1.0, 1.0));
        let outside = [DVec3::splat(2.0), DVec3::NEG_ONE].map(|p| (p, true));
        assert_eq!(box_of([2, 2, 2]).index(outside.into_iter()).cells, 0);
    }

    #[test]
    fn cells_of_a_cylinder_are_rings_of_equal_area_sectors_and_slices() {
        let space = MixingSpace::Cylinder {
            start: DVec3::ZERO,
            end: DVec3::X * 2.0,
            radius: 1.0,
        };
        let shares = space.shares(DVec3::new(0.5, 0.0, 0.5)).unwrap();
        assert!((shares[0] - 0.25).abs() < 1e-15 && (shares[2] - 0.25).abs() < 1e-15);
        let opposite = space.shares(DVec3::new(0.5, 0.0, -0.5)).unwrap();
        assert!(((shares[1] - opposite[1]).abs() - 0.5).abs() < 1e-12);
        assert!(space.shares(DVec3::new(0.5, 0.8, 0.8)).is_none() && space.shares(DVec3::X * 2.0).is_none());
        let mixing = Mixing {
            space,
            cells: [2, 1, 1],
            selection: Selection::default(),
        };
        let mut next = numbers(3);
        let places: Vec<DVec3> = (0..4000)
            .map(|_| DVec3::new(2.0 * next(), 2.0 * next() - 1.0, 2.0 * next() - 1.0))
            .collect();
        let core = |p: &DVec3| p.y * p.y + p.z * p.z < 0.5;
        let told = mixing.index(places.iter().map(|p| (*p, core(p))));
        assert!(told.lacey.abs() < 1e-12 && (told.share - 0.5).abs() < 0.03, "{told:?}");
        let sliced = Mixing {
            cells: [1, 8, 4],
            ..mixing
        }
        .index(places.iter().map(|p| (*p, core(p))));
        assert!(sliced.lacey > 0.8, "{sliced:?}");
    }
}
