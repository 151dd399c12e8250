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

    /// State after a straight move of the overlap to `to`.
    fn advance(&self, size: PairSize<L>, state: Self::State, to: L) -> Self::State;
    /// Force at an overlap in a state that has come there; `approaching` tells the direction.
    fn point(&self, size: PairSize<L>, state: Self::State, overlap: L, approaching: L::Mask) -> Point<L>;
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

/// Nodes and weights of Gauss-Legendre quadrature with 3 points on `[-1, 1]`.
const GAUSS: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];

/// Farther than this many half windows from every kink the force at the middle stands for its mean.
const FAR: f64 = 50.0;

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
    let mut near = L::Mask::of_bits(0);
    for kink in &law.kinks(size, state)[..B::PLACES] {
        near = near | (half_window * FAR).gt((overlap - *kink).abs());
    }
    let step = L::select(approaching, half_window, -half_window);
    let (first, last) = (overlap - step, overlap + step);
    // the length that is integrated over: a window of some units of the last digit of the overlap is rounded
    let length = last - first;
    near = near & length.abs().gt(L::splat(0.0));
    let (mut mean, mut lost, mut end) = (Point::nothing(), L::splat(0.0), state);
    if (!near).any() {
        end = law.advance(size, state, overlap);
        lost = teleport(law, size, (state, end), overlap);
        mean = law.point(size, end, overlap, approaching);
    }
    if near.any() {
        let (along, last) = walk(law, size, state, (first, last), approaching);
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
        ..NormalResponse::spring_dashpot(mean.elastic, mean.damping)
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

/// From one end of a path to the other, from kink to kink.
#[inline(always)]
fn walk<L: Lanes, B: Branched<L>>(
    law: &B,
    size: PairSize<L>,
    state: B::State,
    (first, last): (L, L),
    approaching: L::Mask,
) -> (Sums<L>, B::State) {
    let zero = L::splat(0.0);
    let mut now = law.advance(size, state, first);
    let mut total = Sums {
        work: zero,
        damping: zero,
        adhesion: zero,
        lost: teleport(law, size, (state, now), first),
    };
    let places = ordered::<L, B>(law.kinks(size, now), (first, last), approaching);
    let mut from = first;
    for to in places {
        let moves = to.gt(from) | from.gt(to);
        if moves.any() {
            let (piece, next) = stretch(law, size, now, (from, to), approaching);
            total.work = total.work + piece.work.keep(moves);
            total.damping = total.damping + piece.damping.keep(moves);
            total.adhesion = total.adhesion + piece.adhesion.keep(moves);
            total.lost = total.lost + piece.lost.keep(moves);
            now = B::select(moves, next, now);
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
    state: B::State,
    (from, to): (L, L),
    approaching: L::Mask,
) -> (Sums<L>, B::State) {
    let (middle, half) = ((from + to) * 0.5, (to - from) * 0.5);
    let zero = L::splat(0.0);
    let (mut work, mut damping, mut adhesion) = (zero, zero, zero);
    for (node, weight) in GAUSS {
        let (at, weight) = (middle + half * node, half * weight);
        let point = law.point(size, law.advance(size, state, at), at, approaching);
        work = work + weight * point.elastic;
        damping = damping + weight * point.damping;
        adhesion = adhesion + weight * point.adhesion;
    }
    let next = law.advance(size, state, to);
    let (before, after) = (law.stored(size, state, from), law.stored(size, next, to));
    let change = after - before;
    let passes_on = B::differ(state, next);
    // a reversible stretch does exactly the work that it stores, also across a well of attraction that is
    // narrower than the window
    let is_exact = change.abs().gt(before.abs().max(after.abs()) * RESOLVED);
    let sums = Sums {
        work: L::select(is_exact & !passes_on, change, work),
        damping,
        adhesion,
        lost: (work - change).keep(passes_on),
    };
    (sums, next)
}

/// What a change of state at one place loses, between the windows of two steps: what was stored and no longer is.
#[inline(always)]
fn teleport<L: Lanes, B: Branched<L>>(law: &B, size: PairSize<L>, (before, after): (B::State, B::State), at: L) -> L {
    let changes = B::differ(before, after);
    if changes.any() {
        (law.stored(size, before, at) - law.stored(size, after, at)).keep(changes)
    } else {
        L::splat(0.0)
    }
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
