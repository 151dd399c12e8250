//! Walks a law along a path of overlaps in small windows, as the engine does, and keeps its books. For tests.

use super::{Normal, NormalInput};
use crate::contact::PairSize;

/// What a walk came to.
#[derive(Clone, Copy, Debug, Default)]
pub struct Books {
    /// Work done on the contact by the rate-independent force [J].
    pub work: f64,
    /// Lost other than in the dashpot [J].
    pub lost: f64,
    /// The least loss of any window [J].
    pub least_lost: f64,
    /// Sum of the magnitudes of the work of all windows [J].
    pub turnover: f64,
}

/// Walks from turn to turn in windows of at most `step`; `history` goes along.
pub fn walk<L: Normal>(law: &L, size: PairSize, turns: &[f64], step: f64, history: &mut [f64]) -> Books {
    let mut books = Books::default();
    for ends in turns.windows(2) {
        let (from, to) = (ends[0], ends[1]);
        let count = ((to - from).abs() / step).ceil().max(1.0);
        let width = (to - from) / count;
        for k in 0..count as usize {
            let input = NormalInput {
                size,
                overlap: from + (k as f64 + 0.5) * width,
                rate: width,
                half_window: 0.5 * width.abs(),
            };
            let response = law.respond(&input, history);
            let work = response.elastic * width;
            books.work += work;
            books.turnover += work.abs();
            books.lost += response.lost;
            books.least_lost = books.least_lost.min(response.lost);
        }
    }
    books
}

/// Turning points all over the range between `lower` and `upper`, beginning and ending at `apart`: multiples of the
/// golden ratio, another beginning for each seed.
pub fn rough_path(apart: f64, (lower, upper): (f64, f64), count: u32, seed: u32) -> Vec<f64> {
    let golden = 0.5 * (5f64.sqrt() - 1.0);
    let inner = (0..count).map(|k| {
        let turns = golden * f64::from(17 * seed + 3 * k + 1);
        lower + (upper - lower) * (turns - turns.floor())
    });
    let mut turns = vec![apart];
    turns.extend(inner);
    turns.push(apart);
    turns
}
