//! How fast grains may approach each other, told by bounds of the velocities of those that lie behind each other in memory.

use super::Row;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Grains behind each other whose velocities are bounded together.
pub(crate) const GRAINS_OF_A_SPREAD: usize = 512;

/// Numbers that tell a [`Spread`].
pub(crate) const NUMBERS_OF_A_SPREAD: usize = 7;

/// Bounds of the velocities of some grains in a step, component by component [m/s].
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Spread {
    pub(crate) lower: DVec3,
    pub(crate) upper: DVec3,
    /// The half kick that none of their velocities exceeds at the end of the step before, in size [m/s].
    pub(crate) kick: f64,
}

impl Spread {
    /// That of no grain.
    pub(crate) const NONE: Self = Self {
        lower: DVec3::INFINITY,
        upper: DVec3::NEG_INFINITY,
        kick: 0.0,
    };

    /// That of grains of which nothing is known.
    pub(crate) const ANY: Self = Self {
        lower: DVec3::NEG_INFINITY,
        upper: DVec3::INFINITY,
        kick: f64::INFINITY,
    };

    /// That of these velocities, none of which was changed by a larger half kick than told.
    pub(crate) fn of(velocities: &[Row], kick: f64) -> Self {
        let one = |row: &Row| Self {
            lower: row.vector,
            upper: row.vector,
            kick,
        };
        velocities.iter().map(one).fold(Self::NONE, Self::join)
    }

    pub(crate) fn join(self, other: Self) -> Self {
        Self {
            lower: self.lower.min(other.lower),
            upper: self.upper.max(other.upper),
            kick: self.kick.max(other.kick),
        }
    }

    /// A speed that no grain exceeds [m/s].
    pub(crate) fn speed(&self) -> f64 {
        self.upper.max(-self.lower).max(DVec3::ZERO).length()
    }

    /// A speed [m/s] that none of these grains exceeds against any of others: `|v_i - v_j| <= |max(u_i - l_j, u_j - l_i)|`, with the upper
    /// and lower bounds `u`, `l` of either, component by component.
    pub(crate) fn against(&self, other: &Self) -> f64 {
        let apart = (self.upper - other.lower).max(other.upper - self.lower);
        apart.max(DVec3::ZERO).length()
    }

    /// As numbers, to be told.
    pub(crate) fn numbers(&self) -> [f64; NUMBERS_OF_A_SPREAD] {
        let ([a, b, c], [d, e, f]) = (self.lower.to_array(), self.upper.to_array());
        [a, b, c, d, e, f, self.kick]
    }

    /// What was told.
    pub(crate) fn of_numbers(numbers: &[f64]) -> Self {
        Self {
            lower: DVec3::from_slice(&numbers[..3]),
            upper: DVec3::from_slice(&numbers[3..6]),
            kick: numbers[6],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(velocities: &[[f64; 3]]) -> Vec<Row> {
        let row = |&velocity: &[f64; 3]| Row {
            vector: DVec3::from_array(velocity),
            scalar: 1.0,
        };
        velocities.iter().map(row).collect()
    }

    #[test]
    fn no_two_grains_move_faster_against_each_other() {
        let one = rows(&[[3.0, 0.5, -1.0], [2.5, 0.0, 0.0], [3.5, -0.5, 1.0]]);
        let other = rows(&[[-1.0, 0.1, 0.2], [4.0, 0.0, 0.0]]);
        let (a, b) = (Spread::of(&one, 0.1), Spread::of(&other, 0.2));
        assert_eq!(a.against(&b), b.against(&a));
        let fastest = |some: &[Row], others: &[Row]| {
            let apart = |x: &Row, y: &Row| (x.vector - y.vector).length();
            let all = some.iter().flat_map(|x| others.iter().map(move |y| apart(x, y)));
            all.fold(0.0, f64::max)
        };
        for (found, (some, others)) in [
            (a.against(&b), (&one, &other)),
            (a.against(&a), (&one, &one)),
            (b.against(&b), (&other, &other)),
        ] {
            let fastest = fastest(some, others);
            assert!((fastest..1.4 * fastest).contains(&found), "{found} {fastest}");
        }
        assert!(one.iter().all(|row| row.vector.length() <= a.speed()));
        // grains that move together do not approach each other
        assert_eq!(a.join(b).kick, 0.2);
        let together = Spread::of(&rows(&[[7.0, 8.0, 9.0]; 3]), 0.0);
        assert_eq!(together.against(&together), 0.0);
    }

    #[test]
    fn nothing_adds_nothing_and_the_unknown_is_not_bounded() {
        let some = Spread::of(&rows(&[[1.0, 2.0, 3.0], [-1.0, 0.0, 5.0]]), 4.0);
        assert_eq!(Spread::NONE.join(some), some);
        assert_eq!((Spread::NONE.speed(), Spread::NONE.against(&some)), (0.0, 0.0));
        assert_eq!(Spread::ANY.against(&some), f64::INFINITY);
        assert_eq!(Spread::of_numbers(&some.numbers()), some);
    }
}
