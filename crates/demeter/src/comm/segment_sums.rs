//! Sums over the segments of grains, the same on any number of threads and processes.
//!
//! What the segments came to is added two by two along a tree. A process that has some of the segments tells the others the largest
//! branches that are all its own: few, however many segments it has.

use serde::{Deserialize, Serialize};
use std::ops::Range;

/// What is summed up over segments.
pub(crate) trait Summand: Clone + Default {
    fn add(&mut self, other: &Self);
}

/// Sum of a branch: of `2^level` segments, the first of which is a multiple of that, or of as many as there are.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Branch<T> {
    first: usize,
    level: u32,
    sum: T,
}

impl<T: Summand> Branch<T> {
    /// The segment behind the last one, of so many.
    fn end(&self, count: usize) -> usize {
        (self.first + (1 << self.level)).min(count)
    }

    /// Whether the next branch is the other half of the same larger one.
    fn is_half_with(&self, next: &Self, count: usize) -> bool {
        self.first.is_multiple_of(2 << self.level) && next.end(count) == (next.first + (1 << self.level)).min(count)
    }
}

/// Adds up segments that follow each other, the first of which has this number among `count`, two by two; the sums of branches that are
/// among them are then in the places of their first segments.
pub(crate) fn add_up<T: Summand>(own: &mut [T], start: usize, count: usize) {
    let (end, mut half) = (start + own.len(), 1);
    while half < own.len() {
        let firsts = (start.next_multiple_of(2 * half)..end).step_by(2 * half);
        for first in firsts.filter(|first| first + half < count && (first + 2 * half).min(count) <= end) {
            let (before, behind) = own.split_at_mut(first + half - start);
            before[first - start].add(&behind[0]);
        }
        half *= 2;
    }
}

impl Summand for f64 {
    fn add(&mut self, other: &Self) {
        *self += other;
    }
}

/// The largest branches among segments that [`add_up`] has added up.
pub(crate) fn branches<T: Summand>(own: &[T], start: usize, count: usize) -> Vec<Branch<T>> {
    let some = start..start + own.len();
    let (mut first, mut branches) = (start, Vec::new());
    while first < some.end {
        let level = level(first, &some, count);
        let sum = own[first - start].clone();
        let branch = Branch { first, level, sum };
        first = branch.end(count);
        branches.push(branch);
    }
    branches
}

/// Level of the largest branch among some segments that begins with this one.
fn level(first: usize, some: &Range<usize>, count: usize) -> u32 {
    let mut level = 0;
    while first.is_multiple_of(2 << level)
        && first + (1 << level) < count
        && (first + (2 << level)).min(count) <= some.end
    {
        level += 1;
    }
    level
}

/// Branches that follow each other, of so many segments in all, with both halves of a branch as one.
pub(crate) fn joined<T: Summand>(branches: impl IntoIterator<Item = Branch<T>>, count: usize) -> Vec<Branch<T>> {
    let mut sums: Vec<Branch<T>> = Vec::new();
    for branch in branches {
        let mut last = branch;
        while let Some(before) = sums.pop_if(|before| before.is_half_with(&last, count)) {
            let mut larger = before;
            larger.sum.add(&last.sum);
            larger.level += 1;
            last = larger;
        }
        sums.push(last);
    }
    sums
}

/// The sum of all segments, told the branches that came of all of them.
pub(crate) fn sum<T: Summand>(mut branches: Vec<Branch<T>>) -> T {
    branches.pop().map(|all| all.sum).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers whose sum depends on the order.
    fn segments(count: usize) -> Vec<f64> {
        (0..count).map(|k| libm::exp(libm::sin(k as f64) * 30.0)).collect()
    }

    #[test]
    fn it_does_not_matter_who_has_which_segments() {
        for count in [1, 2, 3, 7, 8, 13, 64, 100] {
            let mut all = segments(count);
            add_up(&mut all, 0, count);
            let exact: f64 = segments(count).iter().sum();
            assert!((all[0] / exact - 1.0).abs() < 1e-14);
            for cuts in [
                vec![0, count],
                vec![0, count / 3, count],
                vec![0, 1.min(count / 2), count / 2, count / 2, count],
            ] {
                let of_process = |some: &[usize]| {
                    let mut own = segments(count)[some[0]..some[1]].to_vec();
                    add_up(&mut own, some[0], count);
                    branches(&own, some[0], count)
                };
                let told: Vec<Vec<Branch<f64>>> = cuts.windows(2).map(of_process).collect();
                let most = told.iter().map(Vec::len).max().unwrap();
                assert!(
                    most as f64 <= 2.0 * (count as f64).log2() + 1.0,
                    "{most} branches of {count}"
                );
                let at_once = joined(told.clone().into_iter().flatten(), count);
                assert!(sum(at_once) == all[0], "{count} cut at {cuts:?}");
                let two_by_two = |a: Vec<Branch<f64>>, b| joined(a.into_iter().chain(b), count);
                let from_behind = told
                    .into_iter()
                    .rev()
                    .reduce(|behind, before| two_by_two(before, behind));
                assert!(sum(from_behind.unwrap()) == all[0], "{count} cut at {cuts:?}");
            }
        }
    }
}
