//! Size classes: grains whose radii differ by less than a factor of two.
//!
//! They follow from the radii alone, so that every process knows those of all grains.

use crate::particles::{Grains, Row};
use rayon::prelude::*;

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

impl SizeClasses {
    /// Those of all grains.
    pub(crate) fn of_all(grains: &Grains) -> Self {
        let rows = || grains.position.rows().par_chunks(GRAINS_PER_TASK);
        let largest = rows()
            .map(|rows| rows.iter().map(|row| row.scalar).fold(0.0, f64::max))
            .reduce(|| 0.0, f64::max);
        let smallest = rows()
            .map(|rows| rows.iter().map(|row| row.scalar).fold(f64::INFINITY, f64::min))
            .reduce(|| f64::INFINITY, f64::min);
        let mut classes = Self::default();
        let mut limit = 0.5 * largest;
        while smallest < limit && classes.limits.len() + 1 < CLASSES {
            classes.limits.push(limit);
            limit *= 0.5;
        }
        let nothing = || [(0, 0.0); CLASSES];
        let found = rows()
            .map(|rows| {
                let mut found = nothing();
                for row in rows {
                    let (members, largest): &mut (usize, f64) = &mut found[classes.of(row.scalar)];
                    *members += 1;
                    *largest = largest.max(row.scalar);
                }
                found
            })
            .reduce(nothing, |a, b| {
                std::array::from_fn(|class| (a[class].0 + b[class].0, a[class].1.max(b[class].1)))
            });
        classes.members = found[..=classes.limits.len()].to_vec();
        classes
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
