//! What the contacts of every segment of grains did in a step.
//!
//! Sums over all contacts are made of sums over the segments of the table of candidates, two by two along a tree: so they are the same
//! on any number of threads, and of processes, each of which has some of the segments and tells the others the largest branches
//! that are all its own.

use super::{ContactChunk, Contacts, Fault, Tally};
use crate::neighbours::Neighbours;
use crate::walls::Mark;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Force [N] and torque about its origin [N m] on a wall.
pub(crate) type WallLoad = (DVec3, DVec3);

/// What the contacts of a segment did: those of its grains with others before them, and with walls.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct SegmentWork {
    tally: Tally,
    /// Forces across the periodic sides of a box that deforms: for each direction, the force of every contact on its first
    /// body times the boxes that lead to the image of its second [N].
    across: [DVec3; 3],
    /// What every wall feels; empty where no wall is near.
    walls: Vec<WallLoad>,
}

impl SegmentWork {
    fn sum_up(&mut self, pairs: &[ContactChunk], walls: &[ContactChunk]) {
        self.tally = Tally::default();
        self.across = [DVec3::ZERO; 3];
        self.walls.clear();
        for chunk in pairs.iter().chain(walls) {
            self.tally.add(&chunk.tally);
            for (sum, across) in self.across.iter_mut().zip(chunk.across) {
                *sum += across;
            }
        }
        for chunk in walls {
            add_loads(&mut self.walls, &chunk.wall_load);
        }
    }

    fn add(&mut self, other: &Self) {
        self.tally.add(&other.tally);
        for (sum, across) in self.across.iter_mut().zip(other.across) {
            *sum += across;
        }
        add_loads(&mut self.walls, &other.walls);
    }
}

fn add_loads(sums: &mut Vec<WallLoad>, loads: &[WallLoad]) {
    if sums.is_empty() {
        return sums.extend_from_slice(loads);
    }
    for (sum, load) in sums.iter_mut().zip(loads) {
        sum.0 += load.0;
        sum.1 += load.1;
    }
}

/// Sum of a branch: of `2^level` segments, the first of which is a multiple of that, or of as many as there are.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Branch {
    first: usize,
    level: u32,
    work: SegmentWork,
}

impl Branch {
    /// The segment behind the last one, of so many.
    fn end(&self, count: usize) -> usize {
        (self.first + (1 << self.level)).min(count)
    }

    /// Whether the next branch is the other half of the same larger one.
    fn is_half_with(&self, next: &Self, count: usize) -> bool {
        self.first.is_multiple_of(2 << self.level) && next.end(count) == (next.first + (1 << self.level)).min(count)
    }
}

/// Adds up some segments of all two by two; the sums of branches that are among them are then in the places of their first segments.
fn add_up(all: &mut [SegmentWork], some: &Range<usize>) {
    let (count, mut half) = (all.len(), 1);
    while half < some.len() {
        let firsts = (some.start.next_multiple_of(2 * half)..some.end).step_by(2 * half);
        for first in firsts.filter(|first| first + half < count && (first + 2 * half).min(count) <= some.end) {
            let (before, behind) = all.split_at_mut(first + half);
            before[first].add(&behind[0]);
        }
        half *= 2;
    }
}

/// The largest branches among some segments, which have been added up.
fn branches(all: &[SegmentWork], some: &Range<usize>) -> Vec<Branch> {
    let (count, mut first, mut branches) = (all.len(), some.start, Vec::new());
    while first < some.end {
        let mut level = 0;
        while first.is_multiple_of(2 << level)
            && first + (1 << level) < count
            && (first + (2 << level)).min(count) <= some.end
        {
            level += 1;
        }
        let work = all[first].clone();
        let branch = Branch { first, level, work };
        first = branch.end(count);
        branches.push(branch);
    }
    branches
}

/// Adds up branches that follow each other, of so many segments in all.
fn add_branches(branches: impl Iterator<Item = Branch>, count: usize) -> SegmentWork {
    let mut sums: Vec<Branch> = Vec::new();
    for branch in branches {
        let mut last = branch;
        while let Some(before) = sums.pop_if(|before| before.is_half_with(&last, count)) {
            let mut larger = before;
            larger.work.add(&last.work);
            larger.level += 1;
            last = larger;
        }
        sums.push(last);
    }
    sums.pop().map(|all| all.work).unwrap_or_default()
}

/// What all contacts did in a step.
#[derive(Clone, Debug, Default)]
pub(crate) struct StepWork {
    segments: Vec<SegmentWork>,
    pub(crate) tally: Tally,
    pub(crate) across: [DVec3; 3],
    pub(crate) walls: Vec<WallLoad>,
    /// What the contacts of all processes did to walls that record it, process by process; nothing where there is one.
    pub(crate) marks: Vec<Vec<Mark>>,
}

/// What a process tells the others of a step.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(crate) struct WorkShare {
    branches: Vec<Branch>,
    marks: Vec<Mark>,
    /// The first fault between grains, and the first with a wall.
    faults: [Option<Fault>; 2],
}

impl StepWork {
    /// Sums up what the contacts of these segments did.
    fn sum_up_segments(&mut self, contacts: &Contacts, neighbours: &Neighbours, segments: Range<usize>) {
        self.segments.resize_with(neighbours.segments(), SegmentWork::default);
        for segment in segments.clone() {
            let pairs = &contacts.pairs[neighbours.chunks_of_segment(segment)];
            let walls = &contacts.walls[neighbours.wall_chunks_of_segment(segment)];
            self.segments[segment].sum_up(pairs, walls);
        }
        add_up(&mut self.segments, &segments);
    }

    /// Takes the sum of all segments, where there are any.
    fn take(&mut self, all: Option<&SegmentWork>, walls: usize) {
        self.tally = all.map_or_else(Tally::default, |all| all.tally);
        self.across = all.map_or([DVec3::ZERO; 3], |all| all.across);
        self.walls.clear();
        self.walls.extend(all.iter().flat_map(|all| &all.walls));
        self.walls.resize(walls, WallLoad::default());
    }

    /// Sums up what all contacts did, told the number of walls. The first fault is told.
    pub(crate) fn of_all(&mut self, contacts: &Contacts, neighbours: &Neighbours, walls: usize) -> Result<(), Fault> {
        self.marks.clear();
        self.sum_up_segments(contacts, neighbours, 0..neighbours.segments());
        let segments = std::mem::take(&mut self.segments);
        self.take(segments.first(), walls);
        self.segments = segments;
        contacts.fault().cloned().map_or(Ok(()), Err)
    }

    /// What the contacts of some segments did, to be told to other processes.
    pub(crate) fn share(&mut self, contacts: &Contacts, neighbours: &Neighbours, segments: Range<usize>) -> WorkShare {
        self.sum_up_segments(contacts, neighbours, segments.clone());
        let pairs = segments
            .clone()
            .map(|s| &contacts.pairs[neighbours.chunks_of_segment(s)]);
        let walls = segments
            .clone()
            .map(|s| &contacts.walls[neighbours.wall_chunks_of_segment(s)]);
        let fault = |chunk: &ContactChunk| chunk.fault.clone();
        WorkShare {
            faults: [pairs.flatten().find_map(fault), walls.clone().flatten().find_map(fault)],
            marks: walls.flatten().flat_map(|chunk| chunk.marks.iter().copied()).collect(),
            branches: branches(&self.segments, &segments),
        }
    }

    /// Sums up what the contacts of all processes did, in the order of their segments. The first fault is told.
    pub(crate) fn of_shares(&mut self, shares: Vec<WorkShare>, walls: usize) -> Result<(), Fault> {
        self.marks.clear();
        let (mut first, mut of_all) = ([None, None], Vec::new());
        for share in shares {
            of_all.extend(share.branches);
            self.marks.push(share.marks);
            for (first, fault) in first.iter_mut().zip(share.faults) {
                if first.is_none() {
                    *first = fault;
                }
            }
        }
        let all = add_branches(of_all.into_iter(), self.segments.len());
        self.take(Some(&all), walls);
        let [between_grains, with_walls] = first;
        between_grains.or(with_walls).map_or(Ok(()), Err)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers whose sum depends on the order.
    fn segments(count: usize) -> Vec<SegmentWork> {
        let work = |k: usize| SegmentWork {
            tally: Tally {
                viscous: libm::exp(libm::sin(k as f64) * 30.0),
                ..Tally::default()
            },
            walls: if k.is_multiple_of(3) {
                vec![(DVec3::X * 0.1 * k as f64, DVec3::Y)]
            } else {
                Vec::new()
            },
            ..SegmentWork::default()
        };
        (0..count).map(work).collect()
    }

    #[test]
    fn it_does_not_matter_who_has_which_segments() {
        for count in [1, 2, 3, 7, 8, 13, 64, 100] {
            let mut all = segments(count);
            add_up(&mut all, &(0..count));
            let alone = all[0].clone();
            let exact: f64 = segments(count).iter().map(|work| work.tally.viscous).sum();
            assert!((alone.tally.viscous / exact - 1.0).abs() < 1e-14);
            for cuts in [
                vec![0, count],
                vec![0, count / 3, count],
                vec![0, 1.min(count / 2), count / 2, count / 2, count],
            ] {
                let of_process = |some: &[usize]| {
                    let (mut here, own) = (segments(count), some[0]..some[1]);
                    add_up(&mut here, &own);
                    branches(&here, &own)
                };
                let told: Vec<Vec<Branch>> = cuts.windows(2).map(of_process).collect();
                let most = told.iter().map(Vec::len).max().unwrap();
                assert!(
                    most as f64 <= 2.0 * (count as f64).log2() + 1.0,
                    "{most} branches of {count}"
                );
                assert!(
                    add_branches(told.into_iter().flatten(), count) == alone,
                    "{count} cut at {cuts:?}"
                );
            }
        }
    }
}
