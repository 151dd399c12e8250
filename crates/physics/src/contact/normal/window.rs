//! Means over the window of the powers of the overlap that linear and Hertzian laws are made of.

use super::{NormalInput, mean_slope, near_end};

/// Mean of `d^(3/2)` over the part of the window in which the bodies overlap [m^(3/2)].
#[inline(always)]
pub(crate) fn mean_three_halves(input: &NormalInput) -> f64 {
    if near_end(input) {
        mean_slope(input, |d| 0.4 * d * d * d.sqrt())
    } else if input.overlap > 0.0 {
        let share = input.half_window / input.overlap;
        input.overlap * input.overlap.sqrt() * (1.0 + share * share / 8.0)
    } else {
        0.0
    }
}

/// Mean of `d^(1/2)` [m^(1/2)].
#[inline(always)]
pub(crate) fn mean_root(input: &NormalInput) -> f64 {
    if near_end(input) {
        mean_slope(input, |d| 2.0 / 3.0 * d * d.sqrt())
    } else if input.overlap > 0.0 {
        let share = input.half_window / input.overlap;
        input.overlap.sqrt() * (1.0 - share * share / 24.0)
    } else {
        0.0
    }
}

/// Mean of `d^(1/4)` [m^(1/4)].
#[inline(always)]
pub(crate) fn mean_quarter(input: &NormalInput) -> f64 {
    if near_end(input) {
        mean_slope(input, |d| 0.8 * d * d.sqrt().sqrt())
    } else if input.overlap > 0.0 {
        let share = input.half_window / input.overlap;
        input.overlap.sqrt().sqrt() * (1.0 - share * share / 32.0)
    } else {
        0.0
    }
}

/// Mean of the overlap, 0 in a gap [m].
#[inline(always)]
pub(crate) fn mean_overlap(input: &NormalInput) -> f64 {
    if input.half_window > input.overlap.abs() {
        mean_slope(input, |d| 0.5 * d * d)
    } else {
        input.overlap.max(0.0)
    }
}

/// Share of the window in which the bodies overlap.
#[inline(always)]
pub(crate) fn contact_share(input: &NormalInput) -> f64 {
    if input.half_window > input.overlap.abs() {
        mean_slope(input, |d| d)
    } else if input.overlap > 0.0 {
        1.0
    } else {
        0.0
    }
}
