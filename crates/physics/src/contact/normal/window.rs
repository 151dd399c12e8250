//! Means over the window of the overlap and of whether there is any.

use super::{NormalInput, mean_of_change, window};
use crate::lanes::{Lanes, Mask};

/// Mean of the overlap, 0 in a gap [m].
#[inline(always)]
pub(super) fn mean_overlap<L: Lanes>(input: &NormalInput<L>) -> L {
    let inside = input.overlap.max(L::splat(0.0));
    let ends_within = ends_within(input);
    if ends_within.any() {
        let [upper, lower] = window(input);
        let change = upper * 0.5 * upper - lower * 0.5 * lower;
        L::select(ends_within, mean_of_change(input, change), inside)
    } else {
        inside
    }
}

/// Share of the window in which the bodies overlap.
#[inline(always)]
pub(super) fn contact_share<L: Lanes>(input: &NormalInput<L>) -> L {
    let inside = L::splat(1.0).keep(input.overlap.gt(L::splat(0.0)));
    let ends_within = ends_within(input);
    if ends_within.any() {
        let [upper, lower] = window(input);
        L::select(ends_within, mean_of_change(input, upper - lower), inside)
    } else {
        inside
    }
}

/// Whether contact begins or ends within the window.
#[inline(always)]
fn ends_within<L: Lanes>(input: &NormalInput<L>) -> L::Mask {
    input.half_window.gt(input.overlap.abs())
}
