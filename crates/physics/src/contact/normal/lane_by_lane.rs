//! Laws that are written for one contact, asked for several.

use super::{NormalInput, NormalResponse};
use crate::contact::PairSize;
use crate::lanes::{Lanes, MOST_LANES};

/// More values than any normal law remembers.
const MOST_HISTORY: usize = 64;

/// Asks a law for its force in every lane.
#[inline(always)]
pub(super) fn respond<L: Lanes>(
    input: &NormalInput<L>,
    history: &mut [L],
    law: impl Fn(&NormalInput, &mut [f64]) -> NormalResponse,
) -> NormalResponse<L> {
    let mut answers = [NormalResponse::NOTHING; MOST_LANES];
    let (overlap, rate, half_window) = (
        input.overlap.to_array(),
        input.rate.to_array(),
        input.half_window.to_array(),
    );
    let mut memory = [0.0; MOST_HISTORY];
    for (lane, answer) in answers.iter_mut().enumerate().take(L::COUNT) {
        let memory = take(history, lane, &mut memory);
        let input = NormalInput {
            size: input.size.lane(lane),
            overlap: overlap[lane],
            rate: rate[lane],
            half_window: half_window[lane],
        };
        *answer = law(&input, memory);
        for (value, changed) in history.iter_mut().zip(memory.iter()) {
            let mut lanes = value.to_array();
            lanes[lane] = *changed;
            *value = L::load(&lanes);
        }
    }
    NormalResponse {
        elastic: L::from_fn(|k| answers[k].elastic),
        damping: L::from_fn(|k| answers[k].damping),
        least: L::from_fn(|k| answers[k].least),
        adhesion: L::from_fn(|k| answers[k].adhesion),
        lost: L::from_fn(|k| answers[k].lost),
    }
}

/// Asks a law for a number in every lane.
#[inline(always)]
pub(super) fn tell<L: Lanes>(
    size: PairSize<L>,
    overlap: L,
    history: &[L],
    law: impl Fn(PairSize, f64, &[f64]) -> f64,
) -> L {
    let overlap = overlap.to_array();
    let mut memory = [0.0; MOST_HISTORY];
    L::from_fn(|lane| law(size.lane(lane), overlap[lane], take(history, lane, &mut memory)))
}

/// What is remembered in one lane.
#[inline(always)]
fn take<'a, L: Lanes>(history: &[L], lane: usize, memory: &'a mut [f64; MOST_HISTORY]) -> &'a mut [f64] {
    for (one, value) in memory.iter_mut().zip(history) {
        *one = value.to_array()[lane];
    }
    &mut memory[..history.len()]
}
