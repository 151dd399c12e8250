//! What the contacts of every segment of grains did in a step.
//!
//! Sums over all contacts are made of sums over the segments of the table of candidates along a tree ([`segment_sums`]): so they are
//! the same on any number of threads, and of processes.

use super::{ContactChunk, Contacts, Fault, Tally};
use crate::comm::segment_sums::{self, Branch, Summand, add_up};
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
    /// What of it the springs of contacts do, where walls have servos.
    springs: Vec<WallLoad>,
}

impl SegmentWork {
    fn sum_up(&mut self, pairs: &[ContactChunk], walls: &[ContactChunk]) {
        self.tally = Tally::default();
        self.across = [DVec3::ZERO; 3];
        self.walls.clear();
        self.springs.clear();
        for chunk in pairs.iter().chain(walls) {
            self.tally.add(&chunk.tally);
            for (sum, across) in self.across.iter_mut().zip(chunk.across) {
                *sum += across;
            }
        }
        for chunk in walls {
            add_loads(&mut self.walls, &chunk.wall_load);
            add_loads(&mut self.springs, &chunk.wall_springs);
        }
    }
}

impl Summand for SegmentWork {
    fn add(&mut self, other: &Self) {
        self.tally.add(&other.tally);
        for (sum, across) in self.across.iter_mut().zip(other.across) {
            *sum += across;
        }
        add_loads(&mut self.walls, &other.walls);
        add_loads(&mut self.springs, &other.springs);
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

/// What all contacts did in a step.
#[derive(Clone, Debug, Default)]
pub(crate) struct StepWork {
    segments: Vec<SegmentWork>,
    pub(crate) tally: Tally,
    pub(crate) across: [DVec3; 3],
    pub(crate) walls: Vec<WallLoad>,
    /// What of it the springs of contacts do to walls that move with servos.
    pub(crate) springs: Vec<WallLoad>,
    /// What the contacts of all processes did to walls that record it; nothing where there is one.
    pub(crate) marks: Vec<Mark>,
}

/// What a process tells the others of a step.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(crate) struct WorkShare {
    branches: Vec<Branch<SegmentWork>>,
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
        let count = self.segments.len();
        add_up(&mut self.segments[segments.clone()], segments.start, count);
    }

    /// Takes the sum of all segments, where there are any.
    fn take(&mut self, all: Option<&SegmentWork>, walls: usize) {
        self.tally = all.map_or_else(Tally::default, |all| all.tally);
        self.across = all.map_or([DVec3::ZERO; 3], |all| all.across);
        let of = |sums: &mut Vec<WallLoad>, segment: fn(&SegmentWork) -> &[WallLoad]| {
            sums.clear();
            sums.extend(all.iter().flat_map(|all| segment(all)));
            sums.resize(walls, WallLoad::default());
        };
        of(&mut self.walls, |all| &all.walls);
        of(&mut self.springs, |all| &all.springs);
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
        let fault = |chunk: &ContactChunk| chunk.fault.as_deref().cloned();
        WorkShare {
            faults: [pairs.flatten().find_map(fault), walls.clone().flatten().find_map(fault)],
            marks: walls.flatten().flat_map(|chunk| chunk.marks.iter().copied()).collect(),
            branches: segment_sums::branches(&self.segments[segments.clone()], segments.start, self.segments.len()),
        }
    }

    /// Takes what the contacts of all processes did. The first fault is told.
    pub(crate) fn of_share(&mut self, share: WorkShare, walls: usize) -> Result<(), Fault> {
        self.marks = share.marks;
        self.take(Some(&segment_sums::sum(share.branches)), walls);
        let [between_grains, with_walls] = share.faults;
        between_grains.or(with_walls).map_or(Ok(()), Err)
    }
}

impl WorkShare {
    /// With what processes tell that have the segments behind, of so many in all.
    pub(crate) fn with(self, behind: Self, segments: usize) -> Self {
        let [a, b] = self.faults;
        let [c, d] = behind.faults;
        Self {
            branches: segment_sums::joined(self.branches.into_iter().chain(behind.branches), segments),
            marks: [self.marks, behind.marks].concat(),
            faults: [a.or(c), b.or(d)],
        }
    }
}
