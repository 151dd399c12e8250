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

/// Mean of a value that grows with this power of the overlap, over the part of the window in which the bodies overlap.
#[inline(always)]
pub(super) fn mean_of_power<L: Lanes>(input: &NormalInput<L>, exponent: f64, value: impl Fn(L) -> L) -> L {
    let share = input.half_window / input.overlap;
    // f + f'' h^2/6
    let bend = exponent * (exponent - 1.0) / 6.0;
    let smooth = value(input.overlap) * (share * share * bend + 1.0);
    mean(input, near_end(input), smooth, |d| {
        value(d) * d * (1.0 / (exponent + 1.0))
    })
}

/// Mean of the overlap, 0 in a gap [m].
#[inline(always)]
pub(super) fn mean_overlap<L: Lanes>(input: &NormalInput<L>) -> L {
    mean(input, ends_within(input), input.overlap, |d| d * 0.5 * d)
}

/// Share of the window in which the bodies overlap.
#[inline(always)]
pub(super) fn contact_share<L: Lanes>(input: &NormalInput<L>) -> L {
    mean(input, ends_within(input), L::splat(1.0), |d| d)
}

/// Whether contact begins or ends within the window.
#[inline(always)]
fn ends_within<L: Lanes>(input: &NormalInput<L>) -> L::Mask {
    input.half_window.gt(input.overlap.abs())
}
