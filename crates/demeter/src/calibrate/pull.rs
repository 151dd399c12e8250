//! The largest pull while the overlap of two bodies moves straight from one place to another.

use demeter_physics::contact::PairSize;
use demeter_physics::contact::normal::{Normal, NormalInput};

/// A pull at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pull {
    /// Pull [N]; negative where the bodies push all the way.
    pub force: f64,
    /// Overlap [m].
    pub overlap: f64,
}

/// Places at which the pull is looked at before the largest is searched for.
const PLACES: usize = 400;
/// Halvings, nearly, of the search for the largest pull.
const GOLDEN_STEPS: usize = 60;
/// So near to an end of the way, as share of it, a search that runs into the end comes.
const AT_THE_END: f64 = 1e-9;

/// Force after a straight move, which the history takes part in [N].
pub(super) fn press<L: Normal>(law: &L, size: PairSize, history: &mut [f64], overlap: f64, rate: f64) -> f64 {
    law.respond(&NormalInput::at(size, overlap, rate), history).elastic
}

/// The largest pull on the way. Its ends count as what comes next to them: some laws jump there.
pub(super) fn largest_pull<L: Normal>(law: &L, size: PairSize, history: &[f64], (from, to): (f64, f64)) -> Pull {
    let rate = f64::MIN_POSITIVE.copysign(to - from);
    let place = |share: f64| from + (to - from) * share * share;
    let pull = |share: f64| -press(law, size, &mut history.to_vec(), place(share), rate);
    let share = |k: usize| k as f64 / PLACES as f64;
    let best = (1..PLACES).max_by(|&a, &b| pull(share(a)).total_cmp(&pull(share(b))));
    let best = best.unwrap_or(1);
    let ratio = 0.5 * (5f64.sqrt() - 1.0);
    let (mut lower, mut upper) = (share(best - 1), share(best + 1));
    for _ in 0..GOLDEN_STEPS {
        let (left, right) = (upper - ratio * (upper - lower), lower + ratio * (upper - lower));
        if pull(left) > pull(right) {
            upper = right;
        } else {
            lower = left;
        }
    }
    let middle = 0.5 * (lower + upper);
    let (found, force) = [share(best), middle]
        .map(|share| (share, pull(share)))
        .into_iter()
        .fold((middle, f64::NEG_INFINITY), |a, b| if b.1 > a.1 { b } else { a });
    let overlap = match found {
        found if found < AT_THE_END => from,
        found if found > 1.0 - AT_THE_END => to,
        found => place(found),
    };
    Pull { force, overlap }
}
