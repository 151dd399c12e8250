//! Means over the window of the powers of the overlap that linear and Hertzian laws are made of.

use super::{NormalInput, mean_slope, near_end};
use crate::lanes::{Lanes, Mask};

/// `smooth` in the middle of a contact, 0 in a gap, and the mean slope of `primitive` near the end of the contact.
#[inline(always)]
fn mean<L: Lanes>(input: &NormalInput<L>, near_end: L::Mask, smooth: L, primitive: impl Fn(L) -> L) -> L {
    let smooth = smooth.keep(input.overlap.gt(L::splat(0.0)));
    if near_end.any() {
        L::select(near_end, mean_slope(input, primitive), smooth)
    } else {
        smooth
    }
}

/// Mean of `d^(3/2)` over the part of the window in which the bodies overlap [m^(3/2)].
#[inline(always)]
pub(crate) fn mean_three_halves<L: Lanes>(input: &NormalInput<L>) -> L {
    let share = input.half_window / input.overlap;
    let smooth = input.overlap * input.overlap.sqrt() * (share * share / 8.0 + 1.0);
    mean(input, near_end(input), smooth, |d| d * 0.4 * d * d.sqrt())
}

/// Mean of `d^(1/2)` [m^(1/2)].
#[inline(always)]
pub(crate) fn mean_root<L: Lanes>(input: &NormalInput<L>) -> L {
    let share = input.half_window / input.overlap;
    let smooth = input.overlap.sqrt() * (L::splat(1.0) - share * share / 24.0);
    mean(input, near_end(input), smooth, |d| d * (2.0 / 3.0) * d.sqrt())
}

/// Mean of `d^(1/4)` [m^(1/4)].
#[inline(always)]
pub(crate) fn mean_quarter<L: Lanes>(input: &NormalInput<L>) -> L {
    let share = input.half_window / input.overlap;
    let smooth = input.overlap.sqrt().sqrt() * (L::splat(1.0) - share * share / 32.0);
    mean(input, near_end(input), smooth, |d| d * 0.8 * d.sqrt().sqrt())
}

/// Mean of the overlap, 0 in a gap [m].
#[inline(always)]
pub(crate) fn mean_overlap<L: Lanes>(input: &NormalInput<L>) -> L {
    mean(input, ends_within(input), input.overlap, |d| d * 0.5 * d)
}

/// Share of the window in which the bodies overlap.
#[inline(always)]
pub(crate) fn contact_share<L: Lanes>(input: &NormalInput<L>) -> L {
    mean(input, ends_within(input), L::splat(1.0), |d| d)
}

/// Whether contact begins or ends within the window.
#[inline(always)]
fn ends_within<L: Lanes>(input: &NormalInput<L>) -> L::Mask {
    input.half_window.gt(input.overlap.abs())
}
