//! Size classes: grains whose radii differ by less than a factor of two.
//!
//! They follow from the radii alone.

use crate::particles::{Grains, Row};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Grains looked at by one task.
const GRAINS_PER_TASK: usize = 4096;

/// Most size classes.
pub(super) const CLASSES: usize = 20;

/// The size classes, which halve from the largest radius on, and what is in them.
#[derive(Clone, Debug, Default)]
pub(crate) struct SizeClasses {
    /// Smallest radius of every class but the last [m].
    limits: Vec<f64>,
    /// Grains of every class, and their largest radius [m].
    pub(super) members: Vec<(usize, f64)>,
}

/// The smallest and the largest radius of some grains [m].
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct Extremes {
    smallest: f64,
    largest: f64,
}

impl Extremes {
    pub(crate) fn of(rows: &[Row]) -> Self {
        let of_rows = |rows: &[Row]| {
            rows.iter().fold(Self::NOTHING, |all, row| {
                all.join(Self {
                    smallest: row.scalar,
                    largest: row.scalar,
                })
            })
        };
        (rows.par_chunks(GRAINS_PER_TASK).map(of_rows)).reduce(|| Self::NOTHING, Self::join)
    }

    const NOTHING: Self = Self {
        smallest: f64::INFINITY,
        largest: 0.0,
    };

    pub(crate) fn join(self, other: Self) -> Self {
        Self {
            smallest: self.smallest.min(other.smallest),
            largest: self.largest.max(other.largest),
        }
    }
}

impl SizeClasses {
    /// Those of all grains.
    pub(crate) fn of_all(grains: &Grains) -> Self {
        let rows = grains.position.rows();
        let mut classes = Self::between(Extremes::of(rows));
        classes.count(rows);
        classes
    }

    /// Those of grains between these radii, with nothing in them yet.
    pub(crate) fn between(Extremes { smallest, largest }: Extremes) -> Self {
        let mut limits = Vec::new();
        let mut limit = 0.5 * largest;
        while smallest < limit && limits.len() + 1 < CLASSES {
            limits.push(limit);
            limit *= 0.5;
        }
        Self {
            members: vec![(0, 0.0); limits.len() + 1],
            limits,
        }
    }

    /// Adds some grains.
    pub(crate) fn count(&mut self, rows: &[Row]) {
        let nothing = || [(0, 0.0); CLASSES];
        let found = (rows.par_chunks(GRAINS_PER_TASK))
            .map(|rows| {
                let mut found = nothing();
                for row in rows {
                    let (members, largest): &mut (usize, f64) = &mut found[self.of(row.scalar)];
                    *members += 1;
                    *largest = largest.max(row.scalar);
                }
                found
            })
            .reduce(nothing, |a, b| std::array::from_fn(|class| add(a[class], b[class])));
        self.join(&found[..self.members.len()]);
    }

    /// Grains of every class, and their largest radius [m].
    pub(crate) fn members(&self) -> &[(usize, f64)] {
        &self.members
    }

    /// Adds those that others have counted in the same classes.
    pub(crate) fn join(&mut self, others: &[(usize, f64)]) {
        for (own, other) in self.members.iter_mut().zip(others) {
            *own = add(*own, *other);
        }
    }

    /// The class of a radius.
    #[inline(always)]
    pub(super) fn of(&self, radius: f64) -> usize {
        self.limits.iter().take_while(|&&limit| radius < limit).count()
    }

    /// The classes of some grains, one bit each.
    pub(crate) fn among(&self, rows: &[Row]) -> u32 {
        rows.iter().fold(0, |bits, row| bits | 1 << self.of(row.scalar))
    }
}

/// Grains of a class and their largest radius, of two lots.
fn add((members, largest): (usize, f64), (more, other): (usize, f64)) -> (usize, f64) {
    (members + more, largest.max(other))
}
