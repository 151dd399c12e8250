//! Laws that are written for one contact, asked for several.

use crate::lanes::{Lanes, MOST_LANES, Mask, Vector};
use glam::DVec3;

/// At least as many values as any law remembers.
pub(super) const MOST_HISTORY: usize = 32;

/// Asks a law in every lane, which it is told with the history of that lane.
#[inline(always)]
pub(super) fn ask<L: Lanes, A: Copy>(
    history: &mut [L],
    nothing: A,
    law: impl Fn(usize, &mut [f64]) -> A,
) -> [A; MOST_LANES] {
    let mut table = laid_out(history);
    let mut answers = [nothing; MOST_LANES];
    let mut memory = [0.0; MOST_HISTORY];
    let memory = &mut memory[..history.len()];
    for (lane, answer) in answers.iter_mut().enumerate().take(L::COUNT) {
        for (one, lanes) in memory.iter_mut().zip(&table) {
            *one = lanes[lane];
        }
        *answer = law(lane, memory);
        for (one, lanes) in memory.iter().zip(&mut table) {
            lanes[lane] = *one;
        }
    }
    for (value, lanes) in history.iter_mut().zip(&table) {
        *value = L::load(lanes);
    }
    answers
}

/// Asks a law for a number in every lane, which it is told with the history of that lane.
#[inline(always)]
pub(super) fn tell<L: Lanes>(history: &[L], law: impl Fn(usize, &[f64]) -> f64) -> L {
    let table = laid_out(history);
    let mut memory = [0.0; MOST_HISTORY];
    L::from_fn(|lane| {
        for (one, lanes) in memory.iter_mut().zip(&table[..history.len()]) {
            *one = lanes[lane];
        }
        law(lane, &memory[..history.len()])
    })
}

/// What is remembered, value by value.
#[inline(always)]
fn laid_out<L: Lanes>(history: &[L]) -> [[f64; MOST_LANES]; MOST_HISTORY] {
    let mut table = [[0.0; MOST_LANES]; MOST_HISTORY];
    for (lanes, value) in table.iter_mut().zip(history) {
        value.store(lanes);
    }
    table
}

/// A positive value that a contact notes when it is new, that is where the value is still 0.
#[inline(always)]
pub(super) fn noted<L: Lanes>(value: L, find: impl Fn(usize) -> f64) -> L {
    if (!value.gt(L::splat(0.0))).any() {
        let before = value.to_array();
        L::from_fn(|lane| if before[lane] == 0.0 { find(lane) } else { before[lane] })
    } else {
        value
    }
}

/// A vector in one lane.
#[inline(always)]
pub(super) fn vector_in<L: Lanes>(vector: L::Vector, lane: usize) -> DVec3 {
    DVec3::from_array(vector.components().map(|component| component.to_array()[lane]))
}

/// A vector in every lane.
#[inline(always)]
pub(super) fn vector_of<L: Lanes>(lane: impl Fn(usize) -> DVec3) -> L::Vector {
    L::Vector::new(
        L::from_fn(|k| lane(k).x),
        L::from_fn(|k| lane(k).y),
        L::from_fn(|k| lane(k).z),
    )
}
