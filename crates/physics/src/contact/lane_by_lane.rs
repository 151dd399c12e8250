//! Laws that are written for one contact, asked for several.
//!
//! Closures must not touch lanes: they are functions of their own, compiled without the instructions of the kernel that they
//! end up in, and every operation on lanes in a closure that is not inlined becomes a call.

use crate::lanes::{Lanes, MOST_LANES, Mask, Vector};
use glam::DVec3;

/// At least as many values as any law remembers.
pub(super) const MOST_HISTORY: usize = 32;

/// Asks a law in every lane, with the number of the lane and what is remembered there.
#[inline(always)]
pub(super) fn ask<L: Lanes, A: Copy>(
    history: &mut [L],
    nothing: A,
    law: impl Fn(usize, &mut [f64]) -> A,
) -> [A; MOST_LANES] {
    let mut answers = [nothing; MOST_LANES];
    let mut memory = [0.0; MOST_HISTORY];
    for (lane, answer) in answers.iter_mut().enumerate().take(L::COUNT) {
        let memory = recalled(history, lane, &mut memory);
        *answer = law(lane, memory);
        for (value, one) in history.iter_mut().zip(memory) {
            value.as_mut_slice()[lane] = *one;
        }
    }
    answers
}

/// Asks a law for a number in every lane, with the number of the lane and what is remembered there.
#[inline(always)]
pub(super) fn tell<L: Lanes>(history: &[L], law: impl Fn(usize, &[f64]) -> f64) -> L {
    let mut memory = [0.0; MOST_HISTORY];
    let mut answers = L::splat(0.0);
    for (lane, answer) in answers.as_mut_slice().iter_mut().enumerate() {
        *answer = law(lane, recalled(history, lane, &mut memory));
    }
    answers
}

/// What is remembered in one lane.
#[inline(always)]
fn recalled<'a, L: Lanes>(history: &[L], lane: usize, memory: &'a mut [f64; MOST_HISTORY]) -> &'a mut [f64] {
    for (one, value) in memory.iter_mut().zip(history) {
        *one = value.as_slice()[lane];
    }
    &mut memory[..history.len()]
}

/// Whether some contact has still to note its positive value: it is 0 when the contact is new.
#[inline(always)]
pub(super) fn some_new<L: Lanes>(noted: L) -> bool {
    (!noted.gt(L::splat(0.0))).any()
}

/// What contacts have noted, found where it is still 0.
#[inline(always)]
pub(super) fn noted<L: Lanes>(mut value: L, find: impl Fn(usize) -> f64) -> L {
    for (lane, one) in value.as_mut_slice().iter_mut().enumerate() {
        if *one == 0.0 {
            *one = find(lane);
        }
    }
    value
}

/// A vector in one lane.
#[inline(always)]
pub(super) fn vector_in<L: Lanes>(vector: &L::Vector, lane: usize) -> DVec3 {
    let [x, y, z] = vector.components();
    DVec3::new(x.as_slice()[lane], y.as_slice()[lane], z.as_slice()[lane])
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
