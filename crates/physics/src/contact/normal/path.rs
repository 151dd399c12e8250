//! Laws whose force depends on where the overlap has been: plastic, hysteretic and adhesive contacts.
//!
//! Such a law is a set of branches. It tells the force in a state, how a straight move of the overlap changes the
//! state, and where on the way the force or its slope jumps. This module takes a contact along the window of a step,
//! piece by piece between those places, and books what the path loses.

use super::{NormalInput, NormalResponse};
use crate::contact::PairSize;

/// Most places on one path at which a force or its slope jumps.
pub const KINKS: usize = 4;

/// Force of a branch at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Force that does not depend on the rate [N].
    pub elastic: f64,
    /// Damping coefficient [N s/m].
    pub damping: f64,
    /// Pull that presses the surfaces together [N], not negative.
    pub adhesion: f64,
}

/// A law of branches.
pub trait Branched {
    /// What is remembered, beside what never changes in the life of a contact.
    type State: Copy + PartialEq;

    /// State after a straight move of the overlap to `to`.
    fn advance(&self, size: PairSize, state: Self::State, to: f64) -> Self::State;
    /// Force at an overlap in a state that has come there; `approaching` tells the direction.
    fn point(&self, size: PairSize, state: Self::State, overlap: f64, approaching: bool) -> Point;
    /// Energy that would be given back from here [J]; defined, and continuous, beyond the ends of the branch, too.
    fn stored(&self, size: PairSize, state: Self::State, overlap: f64) -> f64;
    /// Places at which the force or its slope jumps on a straight path that begins in this state; not a number where
    /// there are fewer.
    fn kinks(&self, size: PairSize, state: Self::State) -> [f64; KINKS];
}

/// Nodes and weights of Gauss-Legendre quadrature with 3 points on `[-1, 1]`.
const GAUSS: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];

/// Farther than this many half windows from every kink the force at the middle stands for its mean.
const FAR: f64 = 50.0;

/// Takes a contact in `state` along its window: the mean response, and the state at the end.
#[inline]
pub fn follow<L: Branched>(law: &L, input: &NormalInput, state: L::State) -> (NormalResponse, L::State) {
    let NormalInput {
        size,
        overlap,
        rate,
        half_window,
    } = *input;
    let approaching = rate > 0.0;
    let kinks = law.kinks(size, state);
    let near = kinks.iter().any(|k| (overlap - k).abs() < FAR * half_window);
    let mut total = Sums::default();
    if !near {
        let next = law.advance(size, state, overlap);
        total.teleport(law, size, (state, next), overlap);
        let point = law.point(size, next, overlap, approaching);
        return (total.mean(point.elastic, point.damping, point.adhesion), next);
    }
    let step = if approaching { half_window } else { -half_window };
    let (first, last) = (overlap - step, overlap + step);
    let mut state_now = law.advance(size, state, first);
    total.teleport(law, size, (state, state_now), first);
    let kinks = law.kinks(size, state_now);
    let mut from = first;
    for to in ordered(kinks, first, last).into_iter().chain([last]) {
        if to.is_nan() || to == from {
            continue;
        }
        state_now = total.piece(law, size, state_now, (from, to), approaching);
        from = to;
    }
    let share = 1.0 / (last - first);
    let response = total.mean(total.work * share, total.damping * share, total.adhesion * share);
    (response, state_now)
}

/// Change of the stored energy, as share of it, that rounding leaves sharp.
const RESOLVED: f64 = 1e-7;

/// Integrals over the path.
#[derive(Clone, Copy, Default)]
struct Sums {
    work: f64,
    damping: f64,
    adhesion: f64,
    lost: f64,
}

impl Sums {
    /// One stretch without a kink inside.
    fn piece<L: Branched>(
        &mut self,
        law: &L,
        size: PairSize,
        state: L::State,
        (from, to): (f64, f64),
        approaching: bool,
    ) -> L::State {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let (mut work, mut damping, mut adhesion) = (0.0, 0.0, 0.0);
        for (node, weight) in GAUSS {
            let at = middle + node * half;
            let point = law.point(size, law.advance(size, state, at), at, approaching);
            work += weight * half * point.elastic;
            damping += weight * half * point.damping;
            adhesion += weight * half * point.adhesion;
        }
        let next = law.advance(size, state, to);
        let (before, after) = (law.stored(size, state, from), law.stored(size, next, to));
        let change = after - before;
        if next != state {
            self.lost += work - change;
        } else if change.abs() > RESOLVED * before.abs().max(after.abs()) {
            // a reversible stretch does exactly the work that it stores, also across a well of attraction that is
            // narrower than the window
            work = change;
        }
        self.work += work;
        self.damping += damping;
        self.adhesion += adhesion;
        next
    }

    /// A change of state at one place, between the windows of two steps: what was stored and no longer is, is lost.
    fn teleport<L: Branched>(&mut self, law: &L, size: PairSize, (before, after): (L::State, L::State), at: f64) {
        if after != before {
            self.lost += law.stored(size, before, at) - law.stored(size, after, at);
        }
    }

    fn mean(&self, elastic: f64, damping: f64, adhesion: f64) -> NormalResponse {
        NormalResponse {
            elastic,
            damping,
            least: f64::NEG_INFINITY,
            adhesion,
            lost: self.lost,
        }
    }
}

/// The places strictly between two ends, in the order of the path; not a number for the others.
fn ordered(kinks: [f64; KINKS], first: f64, last: f64) -> [f64; KINKS] {
    let (lower, upper) = (first.min(last), first.max(last));
    let mut inside = kinks.map(|k| if k > lower && k < upper { k } else { f64::NAN });
    let key = |k: &f64| if last > first { *k } else { -*k };
    inside.sort_by(|a, b| key(a).total_cmp(&key(b)));
    inside
}
