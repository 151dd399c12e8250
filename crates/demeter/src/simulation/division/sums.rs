//! Sums over all grains and contacts, of which each process adds up its own and tells what they came to.

use crate::comm::segment_sums::{Branch, Summand, add_up, branches, joined, sum};
use crate::contacts::ContactChunk;
use crate::simulation::Simulation;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Grains behind each other in memory, and the contacts that are theirs: with those before them, and with walls.
pub(crate) struct Segment<'a> {
    pub(crate) grains: Range<usize>,
    pub(crate) pairs: &'a [ContactChunk],
    pub(crate) walls: &'a [ContactChunk],
}

impl Simulation {
    fn segment(&self, segment: usize) -> Segment<'_> {
        let neighbours = &self.neighbours;
        Segment {
            grains: neighbours.grains_of_segment(segment),
            pairs: &self.contacts.pairs[neighbours.chunks_of_segment(segment)],
            walls: &self.contacts.walls[neighbours.wall_chunks_of_segment(segment)],
        }
    }

    /// What some segments come to, added up as far as that goes among them.
    fn added_up<T: Summand + Send>(&self, some: Range<usize>, of: &(impl Fn(Segment) -> T + Sync)) -> Vec<T> {
        let count = self.neighbours.segments();
        if count == 0 {
            // before the first search
            return vec![of(Segment {
                grains: 0..self.grains.len(),
                pairs: &[],
                walls: &[],
            })];
        }
        let first = some.start;
        let mut sums: Vec<T> = (some.into_par_iter().with_min_len(self.pieces_per_task()))
            .map(|s| of(self.segment(s)))
            .collect();
        add_up(&mut sums, first, count);
        sums
    }

    /// Sum over all segments, where this process has all grains and contacts.
    pub(crate) fn sum_here<T: Summand + Send>(&self, of: impl Fn(Segment) -> T + Sync) -> T {
        let sums = self.added_up(0..self.neighbours.segments(), &of);
        sums.into_iter().next().unwrap_or_default()
    }

    /// Sum over the segments of all processes; each calls this.
    pub(crate) fn sum_of_all<T>(&self, of: impl Fn(Segment) -> T + Sync) -> T
    where
        T: Summand + Send + Serialize + for<'a> Deserialize<'a>,
    {
        let count = self.neighbours.segments();
        let division = self.division.as_ref().filter(|division| !division.is_whole);
        let Some(division) = division.filter(|_| count > 0) else {
            return self.sum_here(of);
        };
        let own = division.segments();
        let mine = branches(&self.added_up(own.clone(), &of), own.start, count);
        let join = |before: Vec<Branch<T>>, behind| joined(before.into_iter().chain(behind), count);
        sum(division.fold(mine, join))
    }
}
