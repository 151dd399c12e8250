//! Laws whose force depends on where the overlap has been: plastic, hysteretic and adhesive contacts.
//!
//! Such a law is a set of branches. It tells the force in a state, how a straight move of the overlap changes the
//! state, and where on the way the force or its slope jumps. This module takes contacts along the window of a step,
//! piece by piece between those places, and books what the path loses.

use super::{NormalInput, NormalResponse};
use crate::contact::PairSize;
use crate::lanes::{Lanes, Mask};

/// Most places on one path at which a force or its slope jumps.
pub const KINKS: usize = 4;

/// Force of a branch at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<L = f64> {
    /// Force that does not depend on the rate [N].
    pub elastic: L,
    /// Damping coefficient [N s/m].
    pub damping: L,
    /// Pull that presses the surfaces together [N], not negative.
    pub adhesion: L,
}

impl<L: Lanes> Point<L> {
    /// No force.
    #[inline(always)]
    pub fn nothing() -> Self {
        let zero = L::splat(0.0);
        Self {
            elastic: zero,
            damping: zero,
            adhesion: zero,
        }
    }
}

/// A law of branches, one contact per lane. What a law does not need to branch on it computes in all lanes.
pub trait Branched<L: Lanes> {
    /// What is remembered, beside what never changes in the life of a contact.
    type State: Copy;
    /// How many places the law has at most at which the force or its slope jumps, up to [`KINKS`].
    const PLACES: usize = KINKS;

    /// How many of these places, the first ones, have a force beside them that bends much: a root or a steep power begins there.
    fn bent(&self) -> usize {
        1
    }

    /// State after a straight move of the overlap to `to`.
    fn advance(&self, size: PairSize<L>, state: Self::State, to: L) -> Self::State;
    /// Force at an overlap in a state that has come there; `approaching` tells the direction.
    fn point(&self, size: PairSize<L>, state: Self::State, overlap: L, approaching: L::Mask) -> Point<L>;
    /// Force at an overlap between two states of a path without a kink. A law overrides it whose force there is known without all of
    /// the state.
    #[inline(always)]
    fn between(
        &self,
        size: PairSize<L>,
        (from, _to): (Self::State, Self::State),
        overlap: L,
        approaching: L::Mask,
    ) -> Point<L> {
        self.point(size, self.advance(size, from, overlap), overlap, approaching)
    }
    /// Energy that would be given back from here [J]; defined, and continuous, beyond the ends of the branch, too.
    fn stored(&self, size: PairSize<L>, state: Self::State, overlap: L) -> L;
    /// Places at which the force or its slope jumps on a straight path that begins in this state, of which the first
    /// [`Branched::PLACES`] are looked at. One may be told twice, or be infinite where there are fewer.
    fn kinks(&self, size: PairSize<L>, state: Self::State) -> [L; KINKS];
    /// `yes` where the mask holds, `no` elsewhere.
    fn select(mask: L::Mask, yes: Self::State, no: Self::State) -> Self::State;
    /// Where two states are not the same.
    fn differ(one: Self::State, other: Self::State) -> L::Mask;
}

/// Outer node of Gauss-Legendre quadrature with 3 points on `[-1, 1]`; the third is the middle.
const OUTER_NODE: f64 = 0.774_596_669_241_483_4;
/// Weight of the outer ones, of all three together 1.
const OUTER_WEIGHT: f64 = 5.0 / 18.0;
/// Weight of the middle one.
const MIDDLE_WEIGHT: f64 = 8.0 / 18.0;

/// Farther than this many half windows from a place beside which the force bends, the force at the middle stands for its mean: that of
/// the power 3/2 within 2.2e-4.
const FAR: f64 = 24.0;

/// Farther than this many half windows from any other kink the window does not reach it, nor does the gap to the window of the step
/// before.
const BESIDE: f64 = 2.0;

/// Takes contacts in `state` along their windows: the mean response, and the state at the end.
#[inline(always)]
pub fn follow<L: Lanes, B: Branched<L>>(
    law: &B,
    input: &NormalInput<L>,
    state: B::State,
) -> (NormalResponse<L>, B::State) {
    let NormalInput {
        size,
        overlap,
        rate,
        half_window,
    } = *input;
    let approaching = rate.gt(L::splat(0.0));
    let (mut bends, mut near) = (L::Mask::of_bits(0), L::Mask::of_bits(0));
    for (place, kink) in law.kinks(size, state)[..B::PLACES].iter().enumerate() {
        let distance = (overlap - *kink).abs();
        if place < law.bent() {
            bends = bends | (half_window * FAR).gt(distance);
        } else {
            near = near | (half_window * BESIDE).gt(distance);
        }
    }
    near = near | bends;
    let step = L::select(approaching, half_window, -half_window);
    let (first, last) = (overlap - step, overlap + step);
    // the length that is integrated over: a window of some units of the last digit of the overlap is rounded
    let length = last - first;
    near = near & length.abs().gt(L::splat(0.0));
    let (mut mean, mut lost, mut end) = (Point::nothing(), L::splat(0.0), state);
    if (!near).any() {
        end = law.advance(size, state, overlap);
        let passes_on = B::differ(state, end);
        if passes_on.any() {
            lost = law.stored(size, state, overlap) - law.stored(size, end, overlap);
            lost = lost.keep(passes_on);
        }
        mean = law.point(size, end, overlap, approaching);
    }
    if near.any() {
        let (along, last) = walk(law, size, state, (first, last), (approaching, bends));
        let share = L::splat(1.0) / length;
        mean = Point {
            elastic: L::select(near, along.work * share, mean.elastic),
            damping: L::select(near, along.damping * share, mean.damping),
            adhesion: L::select(near, along.adhesion * share, mean.adhesion),
        };
        lost = L::select(near, along.lost, lost);
        end = B::select(near, last, end);
    }
    let response = NormalResponse {
        lost,
        adhesion: mean.adhesion,
        ..NormalResponse::spring_dashpot(input, mean.elastic, mean.damping)
    };
    (response, end)
}

/// Change of the stored energy, as share of it, that rounding leaves sharp.
const RESOLVED: f64 = 1e-7;

/// Integrals over the path.
struct Sums<L> {
    work: L,
    damping: L,
    adhesion: L,
    lost: L,
}

/// Where a stretch begins or ends.
#[derive(Clone, Copy)]
struct Place<L, S> {
    state: S,
    at: L,
    /// Energy that would be given back from here [J].
    stored: L,
}

/// From one end of a path to the other, from kink to kink.
#[inline(always)]
fn walk<L: Lanes, B: Branched<L>>(
    law: &B,
    size: PairSize<L>,
    state: B::State,
    (first, last): (L, L),
    (approaching, bends): (L::Mask, L::Mask),
) -> (Sums<L>, B::State) {
    let zero = L::splat(0.0);
    let mut now = law.advance(size, state, first);
    let mut total = Sums {
        work: zero,
        damping: zero,
        adhesion: zero,
        lost: zero,
    };
    // what was stored and no longer is where the state jumps between the windows of two steps
    let mut stored = law.stored(size, now, first);
    let jumps = B::differ(state, now);
    if jumps.any() {
        total.lost = (law.stored(size, state, first) - stored).keep(jumps);
    }
    let places = ordered::<L, B>(law.kinks(size, now), (first, last), approaching);
    let mut from = first;
    for to in places {
        let moves = to.gt(from) | from.gt(to);
        if moves.any() {
            let begin = Place {
                state: now,
                at: from,
                stored,
            };
            let (piece, next) = stretch(law, size, begin, to, (approaching, bends));
            total.work = total.work + piece.work.keep(moves);
            total.damping = total.damping + piece.damping.keep(moves);
            total.adhesion = total.adhesion + piece.adhesion.keep(moves);
            total.lost = total.lost + piece.lost.keep(moves);
            now = B::select(moves, next.state, now);
            stored = L::select(moves, next.stored, stored);
            from = to;
        }
    }
    (total, now)
}

/// One stretch without a kink inside.
#[inline(always)]
fn stretch<L: Lanes, B: Branched<L>>(
    law: &B,
    size: PairSize<L>,
    from: Place<L, B::State>,
    to: L,
    (approaching, bends): (L::Mask, L::Mask),
) -> (Sums<L>, Place<L, B::State>) {
    let state = from.state;
    let next = law.advance(size, state, to);
    let (ends, middle, length) = ((state, next), (from.at + to) * 0.5, to - from.at);
    let mut mean = law.between(size, ends, middle, approaching);
    if bends.any() {
        let away = length * (0.5 * OUTER_NODE);
        let before = law.between(size, ends, middle - away, approaching);
        let after = law.between(size, ends, middle + away, approaching);
        mean = Point {
            elastic: mean_of(bends, [before.elastic, mean.elastic, after.elastic]),
            damping: mean_of(bends, [before.damping, mean.damping, after.damping]),
            adhesion: mean_of(bends, [before.adhesion, mean.adhesion, after.adhesion]),
        };
    }
    let work = mean.elastic * length;
    let (before, after) = (from.stored, law.stored(size, next, to));
    let change = after - before;
    let passes_on = B::differ(state, next);
    // a reversible stretch does exactly the work that it stores, also across a well of attraction that is
    // narrower than the window
    let is_exact = change.abs().gt(before.abs().max(after.abs()) * RESOLVED);
    let sums = Sums {
        work: L::select(is_exact & !passes_on, change, work),
        damping: mean.damping * length,
        adhesion: mean.adhesion * length,
        lost: (work - change).keep(passes_on),
    };
    let end = Place {
        state: next,
        at: to,
        stored: after,
    };
    (sums, end)
}

/// Mean over a stretch of what is known at its nodes, where it bends; elsewhere that in the middle.
#[inline(always)]
fn mean_of<L: Lanes>(bends: L::Mask, [before, middle, after]: [L; 3]) -> L {
    L::select(bends, (before + after) * OUTER_WEIGHT + middle * MIDDLE_WEIGHT, middle)
}

/// The places strictly between two ends, in the order of the path, and then the last end as often as is left.
#[inline(always)]
fn ordered<L: Lanes, B: Branched<L>>(kinks: [L; KINKS], (first, last): (L, L), upward: L::Mask) -> [L; KINKS + 1] {
    let mut places = [last; KINKS + 1];
    if B::PLACES == 0 {
        return places;
    }
    // keys rise along the path
    let (begin, end) = (L::select(upward, first, -first), L::select(upward, last, -last));
    let mut keys = [end; KINKS];
    for (key, kink) in keys.iter_mut().zip(&kinks[..B::PLACES]) {
        let place = L::select(upward, *kink, -*kink);
        *key = L::select(place.gt(begin) & end.gt(place), place, end);
    }
    // a network that sorts four
    for (low, high) in [(0, 1), (2, 3), (0, 2), (1, 3), (1, 2)] {
        if high < B::PLACES {
            (keys[low], keys[high]) = (keys[low].min(keys[high]), keys[low].max(keys[high]));
        }
    }
    for (place, key) in places.iter_mut().zip(keys) {
        *place = L::select(upward, key, -key);
    }
    places
}
