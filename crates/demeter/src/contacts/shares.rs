//! How the work on contacts is shared out: each thread has segments that lie behind each other, as many as take it as long as the
//! others take for theirs. How they are shared out changes no bit of the results.

use std::ops::Range;
use std::time::Duration;

/// Steps after which the times are looked at.
const STEPS: usize = 16;

/// The share of a segment by which a part must end too early or too late before it ends elsewhere.
const FAR: f64 = 0.6;

/// Which segments are the part of which thread.
#[derive(Debug, Default)]
pub(crate) struct Shares {
    /// With which segment every part begins, and where the last one ends.
    bounds: Vec<usize>,
    /// Those before the latest look at the times.
    before: Vec<usize>,
    /// With which grains the parts but the first begin.
    first_grains: Vec<usize>,
    /// What every part took in the latest steps [s].
    took: Vec<[f64; STEPS]>,
    /// Steps since the latest look at them.
    steps: usize,
}

impl Shares {
    /// Shares segments out in so many parts, each of one segment at least. `first_grain` tells with which grain a segment begins.
    pub(super) fn share_out(&mut self, segments: Range<usize>, parts: usize, first_grain: impl Fn(usize) -> usize) {
        let is_known = self.bounds.first() == Some(&segments.start) && self.bounds.last() == Some(&segments.end);
        if self.took.len() != parts || !is_known {
            self.start_anew(&segments, parts);
        } else if self.steps == STEPS {
            self.even_out();
            self.steps = 0;
        }
        self.first_grains.clear();
        let inner = &self.bounds[1..parts];
        self.first_grains
            .extend(inner.iter().map(|&segment| first_grain(segment)));
    }

    /// Shares other segments out as those before were, or evenly in another number of parts.
    fn start_anew(&mut self, segments: &Range<usize>, parts: usize) {
        let (start, count) = (segments.start, segments.len());
        if self.took.len() == parts {
            let (first, end) = (self.bounds[0], self.bounds[parts]);
            for bound in &mut self.bounds {
                *bound = start + (*bound - first) * count / (end - first);
            }
        } else {
            self.took.resize(parts, [0.0; STEPS]);
            self.bounds.clear();
            self.bounds.extend((0..=parts).map(|part| start + part * count / parts));
        }
        self.steps = 0;
        self.leave_none_out();
    }

    /// Sees to it that each part has a segment.
    fn leave_none_out(&mut self) {
        let parts = self.took.len();
        for part in 1..parts {
            self.bounds[part] = self.bounds[part].max(self.bounds[part - 1] + 1);
        }
        for part in (1..parts).rev() {
            self.bounds[part] = self.bounds[part].min(self.bounds[part + 1] - 1);
        }
    }

    /// Lets the parts end where all would have taken equally long, if each segment of a part took as long as the others.
    fn even_out(&mut self) {
        self.before.clone_from(&self.bounds);
        let parts = self.took.len();
        let all: f64 = self.took.iter().map(median).sum();
        let (mut part, mut before_part) = (0, 0.0);
        for bound in 1..parts {
            let due = all * bound as f64 / parts as f64;
            let mut takes = median(&self.took[part]);
            while part + 1 < parts && before_part + takes < due {
                before_part += takes;
                part += 1;
                takes = median(&self.took[part]);
            }
            let (first, end) = (self.before[part] as f64, self.before[part + 1] as f64);
            let share = (due - before_part) / takes.max(f64::MIN_POSITIVE);
            let best = first + (end - first) * share.clamp(0.0, 1.0);
            if (best - self.before[bound] as f64).abs() > FAR {
                self.bounds[bound] = best.round() as usize;
            }
        }
        self.leave_none_out();
    }

    /// Notes what the parts took in a step.
    pub(super) fn note(&mut self, took: impl Iterator<Item = Duration>) {
        for (of_part, took) in self.took.iter_mut().zip(took) {
            of_part[self.steps] = took.as_secs_f64();
        }
        self.steps += 1;
    }

    /// With which segment every part begins, and where the last one ends.
    pub(super) fn bounds(&self) -> &[usize] {
        &self.bounds
    }

    /// With which grains the parts but the first begin.
    pub(crate) fn first_grains(&self) -> &[usize] {
        &self.first_grains
    }
}

/// Half of the steps took longer: what another program took in a few of them does not count.
fn median(took: &[f64; STEPS]) -> f64 {
    let mut sorted = *took;
    sorted.sort_unstable_by(f64::total_cmp);
    sorted[STEPS / 2]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Shares that were evened out until nothing changes, told how long each segment takes [us].
    fn evened_out(segments: Range<usize>, parts: usize, of: impl Fn(usize) -> u64) -> Shares {
        let mut shares = Shares::default();
        for _ in 0..20 * STEPS {
            shares.share_out(segments.clone(), parts, |segment| 10 * segment);
            let bounds = shares.bounds().to_vec();
            assert!(bounds.is_sorted_by(|one, next| one < next));
            assert_eq!([bounds[0], bounds[parts]], [segments.start, segments.end]);
            let took = |ends: &[usize]| Duration::from_micros((ends[0]..ends[1]).map(&of).sum());
            shares.note(bounds.windows(2).map(took));
        }
        shares
    }

    #[test]
    fn parts_come_to_take_equally_long() {
        let dear_in_front = |segment| if segment < 110 { 40 } else { 10 };
        assert_eq!(evened_out(100..140, 2, dear_in_front).bounds(), [100, 109, 140]);
        let all = (10 * 40 + 30 * 10) / 4;
        let shares = evened_out(100..140, 4, dear_in_front);
        for ends in shares.bounds().windows(2) {
            let took: u64 = (ends[0]..ends[1]).map(dear_in_front).sum();
            assert!(took.abs_diff(all) <= 40, "{:?}", shares.bounds());
        }
        assert_eq!(shares.first_grains().len(), 3);
        assert_eq!(shares.first_grains()[0], 10 * shares.bounds()[1]);
    }

    #[test]
    fn each_part_keeps_a_segment_whatever_they_take() {
        for parts in 1..=5 {
            evened_out(3..8, parts, |segment| if segment == 7 { 1_000_000 } else { 0 });
            evened_out(3..8, parts, |_| 0);
        }
    }

    #[test]
    fn a_few_long_steps_change_nothing() {
        let mut shares = Shares::default();
        for step in 0..10 * STEPS {
            shares.share_out(0..40, 2, |segment| segment);
            assert_eq!(shares.bounds(), [0, 20, 40]);
            let interrupted = if step % STEPS < 5 { 900 } else { 0 };
            shares.note([100 + interrupted, 100].into_iter().map(Duration::from_micros));
        }
    }

    #[test]
    fn more_segments_are_shared_out_as_before() {
        let mut shares = evened_out(0..40, 2, |segment| if segment < 10 { 3 } else { 1 });
        let before = shares.bounds()[1];
        assert!((10..=11).contains(&before));
        shares.share_out(0..80, 2, |segment| segment);
        assert_eq!(shares.bounds(), [0, 2 * before, 80]);
        shares.share_out(7..9, 2, |segment| segment);
        assert_eq!(shares.bounds(), [7, 8, 9]);
        shares.share_out(0..80, 4, |segment| segment);
        assert_eq!(shares.bounds(), [0, 20, 40, 60, 80]);
    }
}
