//! Sum per grain over its contacts, segment by segment of the table of pairs: there law by law, and of each law in the order of the
//! partners' places in memory; behind those with grains of its own segment those with walls, law by law in the order of the walls.
//!
//! What a contact does is added to both of its grains as soon as its laws were asked, in the order of [`PairTable`], while
//! it is still in the cache. A task adds to its own grains, and what it has for those of other tasks is added when all are
//! done, task by task: so every grain is summed up in the same order however the work is shared out.
//!
//! [`PairTable`]: crate::neighbours

use super::shares::Shares;
use super::{ContactChunk, Contacts};
use crate::comm::Single;
use crate::neighbours::Neighbours;
use crate::particles::{Load, Rows, set_aside};
use crate::threads::{Divisible, at_home};
use demeter_physics::lanes::{self, Eight, Instructions, Kernel, Lanes, Vector, with_zero};
use glam::DVec3;
use std::ops::Range;
use std::time::{Duration, Instant};

impl Load {
    #[inline(always)]
    fn of<E: Eight>(numbers: E) -> Self {
        let mut load = Self::default();
        numbers.store(&mut load.0);
        load
    }

    /// Adds what a contact does to its first body (0), or takes away what stands for its second (1), on which it does the opposite.
    #[inline(always)]
    pub(super) fn add_side<E: Eight>(&mut self, load: E, side: usize) {
        let sum = E::load(&self.0);
        let sum = if side == 0 { sum + load } else { sum - load };
        sum.store(&mut self.0);
    }
}

/// What a task has for the grains of others.
#[derive(Debug, Default)]
struct Strays {
    /// Grains, each with the side of the contact that it is on: the first body (0) or the second (1).
    grains: Vec<(u32, u32)>,
    loads: Vec<Load>,
}

impl Strays {
    fn clear(&mut self) {
        self.grains.clear();
        self.loads.clear();
    }

    fn push(&mut self, grain: u32, side: usize, load: &Load) {
        self.grains.push((grain, side as u32));
        self.loads.push(*load);
    }
}

/// What comes out of a task beside the sums of its grains.
#[derive(Debug, Default)]
struct Outcome {
    /// What it has for the grains of each task before it.
    strays: Vec<Strays>,
    took: Duration,
}

/// Adds up what contacts do to grains.
#[derive(Debug, Default)]
pub(crate) struct Sums {
    outcomes: Vec<Outcome>,
    pub(crate) shares: Shares,
}

/// What contacts do to both of their bodies, one contact per lane.
#[derive(Clone, Copy)]
pub(super) struct Loads<L: Lanes> {
    /// Force on the first body [N]; on the second it is the opposite.
    pub(super) force: L::Vector,
    /// Torque on the first body [N m].
    pub(super) first_torque: L::Vector,
    /// The opposite of the torque on the second [N m].
    pub(super) second_torque: L::Vector,
}

impl<L: Lanes> Loads<L> {
    /// Those in one of the registers.
    #[inline(always)]
    pub(super) fn register(&self, which: usize) -> Loads<L::Register> {
        Loads {
            force: of_register::<L>(self.force, which),
            first_torque: of_register::<L>(self.first_torque, which),
            second_torque: of_register::<L>(self.second_torque, which),
        }
    }
}

#[inline(always)]
fn of_register<L: Lanes>(vector: L::Vector, which: usize) -> <L::Register as Lanes>::Vector {
    let [x, y, z] = vector.components();
    Vector::new(x.register(which), y.register(which), z.register(which))
}

/// Where what contacts do is added up.
pub(super) trait Sink {
    /// Takes what the contacts from `k` on do, one per lane, and nothing in lanes beyond the end.
    fn put<L: Lanes>(&mut self, k: usize, loads: &Loads<L>);
    /// The contacts from `k` on, as many as lanes, do nothing.
    fn put_nothing<L: Lanes>(&mut self, k: usize);
}

/// Sums of the grains of a task, and what it has for others.
pub(crate) struct Adder<'a> {
    first_grain: u32,
    sums: &'a mut [Load],
    /// What it has for the grains of each task before it.
    strays: &'a mut [Strays],
    /// With which grains the tasks but the first begin.
    first_grains: &'a [usize],
    /// Grains that are summed up at all: others are the work of other processes.
    own: Range<u32>,
}

impl Adder<'_> {
    /// Adds what a contact with a wall does to its grain, which is one of the task's own.
    #[inline(always)]
    pub(super) fn add_own<E: Eight>(&mut self, grain: u32, load: E) {
        if let Some(sum) = self.sums.get_mut(grain.wrapping_sub(self.first_grain) as usize) {
            sum.add_side(load, 0);
        }
    }

    /// Adds what a contact does to one of its bodies, which may be the work of others.
    #[inline(never)]
    fn add(&mut self, grain: u32, side: usize, load: &Load) {
        if let Some(sum) = self.sums.get_mut(grain.wrapping_sub(self.first_grain) as usize) {
            sum.add_side(<f64 as Lanes>::Eight::load(&load.0), side);
        } else if self.own.contains(&grain) {
            let task = self.first_grains.partition_point(|&first| first <= grain as usize);
            self.strays[task].push(grain, side, load);
        }
    }
}

/// Adds up contacts of one law as they come.
pub(super) struct AddAtOnce<'s, 'a> {
    pub(super) adder: &'s mut Adder<'a>,
    /// Bodies of the contacts.
    pub(super) i: &'s [u32],
    pub(super) j: &'s [u32],
    /// What acts across periodic sides, where the box deforms.
    pub(super) across: Option<Across<'s>>,
}

/// Forces of contacts across periodic sides.
pub(super) struct Across<'s> {
    /// Codes of the shifts of the contacts.
    pub(super) shift: &'s [u8],
    /// Forces on the first bodies, times the boxes to the images of the second, by direction [N].
    pub(super) forces: [DVec3; 3],
}

impl Across<'_> {
    fn add(&mut self, contact: usize, [x, y, z, _]: [f64; 4]) {
        let code = self.shift[contact];
        if code != Single::UNSHIFTED {
            let boxes = Single::boxes(code);
            for (axis, sum) in self.forces.iter_mut().enumerate() {
                *sum += DVec3::new(x, y, z) * boxes[axis];
            }
        }
    }
}

impl Sink for AddAtOnce<'_, '_> {
    #[inline(always)]
    fn put<L: Lanes>(&mut self, k: usize, loads: &Loads<L>) {
        let first = L::side_by_side(loads.force, loads.first_torque);
        let second = L::side_by_side(loads.force, loads.second_torque);
        let whole = k..k + L::COUNT;
        let Adder { sums, first_grain, .. } = &mut *self.adder;
        let is_added = match (self.i.get(whole.clone()), self.j.get(whole)) {
            (Some(i), Some(j)) => lanes::add_to_both::<L, _>(sums, *first_grain, [i, j], [&first, &second]),
            _ => false,
        };
        let end = (k + L::COUNT).min(self.i.len());
        if !is_added {
            let (i, j) = (&self.i[k..end], &self.j[k..end]);
            // lanes are counted to a number known beforehand, so that what they hold stays in registers
            let mut lane = 0;
            while lane < L::COUNT {
                if lane < i.len() {
                    self.adder.add(i[lane], 0, &Load::of(first.as_ref()[lane]));
                    self.adder.add(j[lane], 1, &Load::of(second.as_ref()[lane]));
                }
                lane += 1;
            }
        }
        if let Some(across) = &mut self.across {
            let forces = L::rows(with_zero::<L>(loads.force));
            for (contact, &force) in (k..end).zip(forces.as_ref()) {
                across.add(contact, force);
            }
        }
    }

    #[inline(always)]
    fn put_nothing<L: Lanes>(&mut self, _k: usize) {}
}

/// What acts on grains that lie behind each other.
struct Sum<'a> {
    first: usize,
    loads: &'a mut [Load],
}

impl Divisible for Sum<'_> {
    fn len(&self) -> usize {
        self.loads.len()
    }

    fn split(self, first: usize) -> (Self, Self) {
        // grains of other processes lie behind the own ones
        let (loads, others) = self.loads.split_at_mut(first.min(self.loads.len()));
        let (first, behind) = (self.first, self.first + loads.len());
        (
            Self { first, loads },
            Self {
                first: behind,
                loads: others,
            },
        )
    }
}

/// Segments of the table of pairs that are worked on, and the grains that are theirs.
struct Task<'a> {
    neighbours: &'a Neighbours,
    segments: Range<usize>,
    chunks: &'a mut [ContactChunk],
    first_chunk: usize,
    wall_chunks: &'a mut [ContactChunk],
    first_wall_chunk: usize,
    sum: Sum<'a>,
    /// Of this task, and of those that are split off behind it.
    outcomes: &'a mut [Outcome],
}

impl Divisible for Task<'_> {
    fn len(&self) -> usize {
        self.segments.len()
    }

    fn split(self, first: usize) -> (Self, Self) {
        let (neighbours, middle) = (self.neighbours, self.segments.start + first);
        let chunk = neighbours.chunks_of_segment(middle).start;
        let wall_chunk = neighbours.wall_chunks_of_segment(middle).start;
        let grains = neighbours.grains_of_segment(middle).start - self.sum.first;
        let (chunks, other_chunks) = self.chunks.split_at_mut(chunk - self.first_chunk);
        let (wall_chunks, other_wall_chunks) = self.wall_chunks.split_at_mut(wall_chunk - self.first_wall_chunk);
        let (sum, other_sum) = self.sum.split(grains);
        let (outcome, other_outcomes) = self.outcomes.split_at_mut(1);
        let one = Task {
            segments: self.segments.start..middle,
            chunks,
            wall_chunks,
            sum,
            outcomes: outcome,
            ..self
        };
        let other = Task {
            neighbours,
            segments: middle..self.segments.end,
            chunks: other_chunks,
            first_chunk: chunk,
            wall_chunks: other_wall_chunks,
            first_wall_chunk: wall_chunk,
            sum: other_sum,
            outcomes: other_outcomes,
        };
        (one, other)
    }
}

/// How the work of a step on contacts is done.
pub(crate) struct Work<'a, S, W> {
    pub(crate) neighbours: &'a Neighbours,
    /// Segments of the table of pairs that are worked on.
    pub(crate) segments: Range<usize>,
    pub(crate) instructions: Instructions,
    /// Finds what the contacts of a chunk between grains do, told by its number.
    pub(crate) step: S,
    /// The same of a chunk with walls. Those of a segment come right after its pairs: the grains are in the cache then.
    pub(crate) at_walls: W,
}

impl Sums {
    /// Bytes set aside.
    pub(crate) fn bytes(&self) -> usize {
        let stray = |s: &Strays| set_aside(&s.grains) + set_aside(&s.loads);
        let all = self.outcomes.iter().flat_map(|outcome| &outcome.strays);
        all.map(stray).sum()
    }

    /// Works on the chunks of all segments, between grains and with walls, in parallel in `parts`, and sums up for the own grains, which
    /// the segments have, in their `loads`: into how many parts the work is cut changes no sum.
    pub(crate) fn work<S, W>(
        &mut self,
        (loads, contacts): (&mut Rows<Load>, &mut Contacts),
        own: Range<usize>,
        parts: usize,
        work: &Work<S, W>,
    ) where
        S: Fn(usize, &mut ContactChunk, &mut Adder) + Sync,
        W: Fn(usize, &mut ContactChunk, &mut Adder) + Sync,
    {
        let Range { start, end } = work.segments;
        let sums = &mut loads.rows_mut()[own.clone()];
        if start == end {
            return sums.iter_mut().for_each(Load::clear);
        }
        let parts = parts.clamp(1, end - start);
        let chunks = of_segments(start..end, |s| work.neighbours.chunks_of_segment(s));
        let wall_chunks = of_segments(start..end, |s| work.neighbours.wall_chunks_of_segment(s));
        self.outcomes.resize_with(parts, Outcome::default);
        for (task, outcome) in self.outcomes.iter_mut().enumerate() {
            outcome.strays.resize_with(task, Strays::default);
            outcome.strays.iter_mut().for_each(Strays::clear);
        }
        let first_grain = |segment| work.neighbours.grains_of_segment(segment).start;
        self.shares.share_out(start..end, parts, first_grain);
        let (bounds, first_grains) = (&self.shares.bounds()[1..parts], self.shares.first_grains());
        let all = Task {
            neighbours: work.neighbours,
            segments: start..end,
            first_chunk: chunks.start,
            chunks: &mut contacts.pairs[chunks],
            first_wall_chunk: wall_chunks.start,
            wall_chunks: &mut contacts.walls[wall_chunks],
            sum: Sum {
                first: own.start,
                loads: &mut *sums,
            },
            outcomes: &mut self.outcomes,
        };
        let of_run = own.start as u32..own.end as u32;
        at_home(
            (start, bounds),
            all,
            &|_, task| task.work(first_grains, &of_run, work),
            &|(), ()| (),
        );
        if parts > 1 {
            let add = |task, to: Sum| {
                let outcomes = &self.outcomes[task + 1..];
                lanes::run(work.instructions, AddStrays { task, to, outcomes });
            };
            let all = Sum {
                first: own.start,
                loads: sums,
            };
            at_home((own.start, first_grains), all, &add, &|(), ()| ());
        }
        self.shares.note(self.outcomes.iter().map(|outcome| outcome.took));
    }
}

/// What belongs to segments that follow each other, told what belongs to one.
fn of_segments(segments: Range<usize>, of: impl Fn(usize) -> Range<usize>) -> Range<usize> {
    of(segments.start).start..of(segments.end - 1).end
}

impl Task<'_> {
    fn work<S, W>(self, first_grains: &[usize], own: &Range<u32>, work: &Work<S, W>)
    where
        S: Fn(usize, &mut ContactChunk, &mut Adder) + Sync,
        W: Fn(usize, &mut ContactChunk, &mut Adder) + Sync,
    {
        let (begun, neighbours) = (Instant::now(), self.neighbours);
        let outcome = &mut self.outcomes[0];
        let first_grain = self.sum.first;
        let mut adder = Adder {
            first_grain: first_grain as u32,
            sums: self.sum.loads,
            strays: &mut outcome.strays,
            first_grains,
            own: own.clone(),
        };
        let count = adder.sums.len();
        for segment in self.segments {
            let grains = neighbours.grains_of_segment(segment);
            let [first, end] = [grains.start, grains.end].map(|grain| (grain - first_grain).min(count));
            adder.sums[first..end].iter_mut().for_each(Load::clear);
            for chunk in neighbours.chunks_of_segment(segment) {
                (work.step)(chunk, &mut self.chunks[chunk - self.first_chunk], &mut adder);
            }
            for chunk in neighbours.wall_chunks_of_segment(segment) {
                (work.at_walls)(chunk, &mut self.wall_chunks[chunk - self.first_wall_chunk], &mut adder);
            }
        }
        outcome.took = begun.elapsed();
    }
}

/// Adds to the grains of a task what those behind it have for them.
struct AddStrays<'a> {
    task: usize,
    to: Sum<'a>,
    outcomes: &'a [Outcome],
}

impl Kernel for AddStrays<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        for Outcome { strays, .. } in self.outcomes {
            let strays = &strays[self.task];
            for (&(grain, side), load) in strays.grains.iter().zip(&strays.loads) {
                if let Some(sum) = self.to.loads.get_mut((grain as usize).wrapping_sub(self.to.first)) {
                    sum.add_side(L::Eight::load(&load.0), side as usize);
                }
            }
        }
    }
}
