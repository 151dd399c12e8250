//! Grains that get another process: where they are put in order again, where some go, and where the work is divided anew.
//!
//! All processes know which place every grain gets in memory, and cut the segments alike. So each knows what leaves it, and what it will
//! hear: how the grains move, and the contacts that they are in.

use super::{Division, Introduced, WORK_OF_A_GRAIN, all_introduced, encode, introduced_of};
use crate::comm::Message;
use crate::contacts::PairsAndWalls;
use crate::neighbours::{Bounds, Curve, GONE};
use crate::particles::spread::Spread;
use crate::simulation::Simulation;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// Bytes of a number that is told.
const BYTES: usize = size_of::<f64>();

/// What a process tells another of grains that become its own.
#[derive(Default, Serialize, Deserialize)]
struct Leaving {
    grains: Vec<u8>,
    contacts: PairsAndWalls,
    /// How the grains of whole segments move in this step; nothing where grains get other places in memory.
    spreads: Vec<Spread>,
}

/// Which process has a grain, before and after.
struct Owners<'a> {
    before: &'a [usize],
    after: &'a [usize],
    moved_to: &'a [u32],
    per_segment: usize,
}

impl Owners<'_> {
    /// The process of a grain, told by its old index, before and after; after nowhere where it is gone.
    fn of(&self, grain: u32) -> (usize, Option<usize>) {
        let to = self.moved_to[grain as usize];
        let after = (to != GONE).then(|| rank_in(self.after, to as usize / self.per_segment));
        (rank_in(self.before, grain as usize / self.per_segment), after)
    }

    /// Processes that this one tells of a contact: those that had none of its grains and get one. Of both that know the contact, the
    /// one tells whose first grain leaves for there.
    fn receivers(&self, rank: usize, i: u32, j: Option<u32>) -> impl Iterator<Item = usize> + use<> {
        let (first, second) = (self.of(i), j.map(|j| self.of(j)));
        let (to_first, to_second) = (first.1, second.and_then(|second| second.1));
        let knows = |to: usize| first.0 == to || second.is_some_and(|second| second.0 == to);
        let one = to_first.filter(|&to| first.0 == rank && !knows(to));
        let other =
            to_second.filter(|&to| second.is_some_and(|second| second.0 == rank) && !knows(to) && to_first != Some(to));
        one.into_iter().chain(other)
    }
}

/// The process of a segment, told the first segment of each.
pub(super) fn rank_in(cuts: &[usize], segment: usize) -> usize {
    cuts.partition_point(|&first| first <= segment) - 1
}

impl Division {
    /// Where segments are cut so that all have as much to do, told the work of each.
    pub(super) fn even_cuts(&self, of_segments: impl IntoIterator<Item = usize>) -> Vec<usize> {
        let mut work = vec![0];
        for of_segment in of_segments {
            work.push(work[work.len() - 1] + of_segment);
        }
        let (ranks, segments) = (self.ranks.count(), work.len() - 1);
        let all = work[segments];
        let cut = |rank: usize| {
            let wanted = all * rank / ranks;
            let behind = work.partition_point(|&before| before < wanted);
            // the nearer of both ends of the segment in which the cut would be
            let before = behind.saturating_sub(1);
            if wanted - work[before].min(wanted) < work[behind] - wanted {
                before
            } else {
                behind
            }
        };
        (0..ranks).map(cut).chain([segments]).collect()
    }

    /// Takes segments that are cut like this.
    pub(super) fn take_cuts(&mut self, cuts: Vec<usize>, per_segment: usize, grains: usize) {
        self.cuts = cuts;
        let own = self.segments();
        self.own = (own.start * per_segment).min(grains)..(own.end * per_segment).min(grains);
    }

    /// Which grains need not be introduced again: their process stays the same and has told the other of them before.
    fn still_introduced(&self, owners: &Owners<'_>, count: usize) -> Introduced {
        let n = owners.per_segment;
        let mut still = Introduced::new();
        for (&(other, segment), grains) in &self.introduced {
            let teller = rank_in(owners.before, segment);
            for grain in introduced_of(segment * n, grains) {
                let to = owners.moved_to[grain];
                if to != GONE && rank_in(owners.after, to as usize / n) == teller {
                    let first = to as usize / n * n;
                    let of_segment = still.entry((other, first / n)).or_default();
                    of_segment.resize(n.min(count - first), false);
                    of_segment[to as usize - first] = true;
                }
            }
        }
        still
    }

    /// Tells some others some bytes, and hears what each of them tells; those who are told tell, too.
    fn swap(&self, told: Vec<(usize, Vec<u8>)>) -> Vec<(usize, Vec<u8>)> {
        let mut messages: Vec<Message> = Vec::with_capacity(told.len());
        messages.extend(told.iter().map(|(rank, bytes)| Message {
            rank: *rank,
            tell: vec![bytes.len() as f64],
            hear: vec![0.0],
        }));
        self.ranks.exchange(&mut messages, &mut || ());
        let lengths: Vec<usize> = messages.iter().map(|message| message.hear[0] as usize).collect();
        for ((message, (_, mut bytes)), length) in messages.iter_mut().zip(told).zip(&lengths) {
            bytes.resize(bytes.len().next_multiple_of(BYTES), 0);
            message.tell = bytemuck::pod_collect_to_vec(&bytes);
            message.hear = vec![0.0; length.div_ceil(BYTES)];
        }
        self.ranks.exchange(&mut messages, &mut || ());
        let heard = messages.iter().zip(lengths).map(|(message, length)| {
            let bytes: &[u8] = bytemuck::cast_slice(&message.hear);
            (message.rank, bytes[..length].to_vec())
        });
        heard.collect()
    }
}

impl Simulation {
    /// Finds the order of the grains of all processes along the curve.
    pub(super) fn find_order_together(&mut self) {
        let Some(division) = &self.division else { return };
        let rows = &self.grains.position.rows()[division.own.clone()];
        let Bounds { lower, upper } = Bounds::of_centres(rows);
        let told = division
            .ranks
            .gather_even(bytemuck::cast_slice(&[lower.to_array(), upper.to_array()]));
        let all = told.chunks_exact(2 * size_of::<[f64; 3]>()).map(|corners| {
            let [lower, upper]: [[f64; 3]; 2] = bytemuck::pod_read_unaligned(corners);
            Bounds {
                lower: lower.into(),
                upper: upper.into(),
            }
        });
        let curve = Curve::new(all.fold(Bounds::NOTHING, Bounds::join), self.grains.len());
        // whatever is not told of a place is 0
        let width = if curve.is_short() {
            size_of::<u32>()
        } else {
            size_of::<u64>()
        };
        let ids = &self.grains.id[division.own.clone()];
        let mut mine = Vec::with_capacity((width + size_of::<u32>()) * rows.len());
        for (row, id) in rows.iter().zip(ids) {
            mine.extend_from_slice(&curve.place(row.vector).to_le_bytes()[..width]);
            mine.extend_from_slice(&id.to_le_bytes());
        }
        let told = division.ranks.gather(&mine).concat();
        let width_of_both = width + size_of::<u32>();
        if told.len() != width_of_both * self.grains.len() {
            division.ranks.give_up("another process has other grains");
        }
        let place_and_id = |grain: usize| {
            let (place, id) = told[width_of_both * grain..width_of_both * (grain + 1)].split_at(width);
            let mut bytes = [0; size_of::<u64>()];
            bytes[..width].copy_from_slice(place);
            (u64::from_le_bytes(bytes), bytemuck::pod_read_unaligned(id))
        };
        self.order.find(self.grains.len(), place_and_id);
    }

    /// Where segments are cut so that all processes have as much to do with the grains in their new order.
    pub(super) fn even_cuts(&self) -> Vec<usize> {
        let Some(division) = &self.division else {
            return Vec::new();
        };
        let (per_segment, moved_to) = (self.neighbours.grains_per_segment(), self.order.moved_to());
        let mut mine: BTreeMap<u32, u32> = BTreeMap::new();
        let mut add = |place: u32, work: usize| {
            if place != GONE {
                *mine.entry(place / per_segment as u32).or_default() += work as u32;
            }
        };
        moved_to[division.own.clone()]
            .iter()
            .for_each(|&to| add(to, WORK_OF_A_GRAIN));
        for (one, other) in self.neighbours.bearers(&division.own) {
            let [one, other] = [one, other].map(|grain| moved_to[grain as usize]);
            // a pair goes with the later of its grains
            add(if other == GONE { GONE } else { one.max(other) }, 1);
        }
        let mine: Vec<(u32, u32)> = mine.into_iter().collect();
        let mut work = vec![0; self.order.order().len().div_ceil(per_segment)];
        for told in division.ranks.gather(&encode(&mine)) {
            for (segment, of_segment) in division.decode::<Vec<(u32, u32)>>(&told) {
                match work.get_mut(segment as usize) {
                    Some(work) => *work += of_segment as usize,
                    None => division.ranks.give_up("another process has other grains"),
                }
            }
        }
        division.even_cuts(work)
    }

    /// Where segments are cut so that nearly all grains that stay in the run stay with their processes.
    pub(super) fn same_cuts(&self) -> Vec<usize> {
        let Some(division) = &self.division else {
            return Vec::new();
        };
        let (per_segment, order) = (self.neighbours.grains_per_segment(), self.order.order());
        let segments = order.len().div_ceil(per_segment);
        let cut = |&before: &usize| {
            let first = order.partition_point(|&grain| (grain as usize) < before * per_segment);
            ((first + per_segment / 2) / per_segment).min(segments)
        };
        let ranks = division.ranks.count();
        let inner = division.cuts[1..ranks].iter().map(cut);
        std::iter::once(0).chain(inner).chain([segments]).collect()
    }

    /// Puts the grains into the order that was found, and gives each to the process that has its segment then. `are_moved` tells whether
    /// any gets another place in memory. Each calls this.
    pub(super) fn hand_over_grains(&mut self, cuts: Vec<usize>, are_moved: bool) {
        let Some(mut division) = self.division.take() else {
            return;
        };
        let (per_segment, rank) = (self.neighbours.grains_per_segment(), division.ranks.rank());
        let owners = Owners {
            before: &division.cuts,
            after: &cuts,
            moved_to: self.order.moved_to(),
            per_segment,
        };
        let mut told = self.leaving(&division, &owners, are_moved);
        let mut arriving: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        let (first, end) = (cuts[rank] * per_segment, cuts[rank + 1] * per_segment);
        for (to, &from) in self.order.order().iter().enumerate().take(end).skip(first) {
            let before = rank_in(owners.before, from as usize / per_segment);
            if before != rank {
                arriving.entry(before).or_default().push(to);
            }
        }
        let others: BTreeSet<usize> = told.keys().chain(arriving.keys()).copied().collect();
        let told = others
            .iter()
            .map(|other| (*other, encode(&told.remove(other).unwrap_or_default())));
        let heard = division.swap(told.collect());
        let before = division.cuts.clone();
        let order = self.order.order();
        let introduced = division.still_introduced(&owners, order.len());
        let own = first.min(order.len())..end.min(order.len());
        let stay = own.clone().filter(|&to| division.own.contains(&(order[to] as usize)));
        let near = all_introduced(&introduced, per_segment);
        let known = stay.chain(near.filter(|to| !own.contains(to)));
        self.grains.keep(order.len(), known.map(|to| (to, order[to] as usize)));
        division.introduced = introduced;
        division.take_cuts(cuts, per_segment, self.grains.len());
        for (other, bytes) in heard {
            let leaving: Leaving = division.decode(&bytes);
            let mine = arriving.remove(&other).unwrap_or_default();
            let theirs = before[other]..before[other + 1];
            let segments = division.segments().filter(|segment| theirs.contains(segment));
            if !self.grains.unpack(mine.iter().copied(), &leaving.grains) {
                division.ranks.give_up("another process has other grains");
            }
            self.contacts.join(leaving.contacts);
            for (segment, spread) in segments.zip(leaving.spreads) {
                let of_segment = self.neighbours.spreads_of_segment(segment);
                self.spreads
                    .get_mut(of_segment)
                    .into_iter()
                    .flatten()
                    .for_each(|of| *of = spread);
            }
        }
        division.note_sizes(&self.grains, per_segment);
        self.division = Some(division);
    }

    /// What each of some others is told of the grains that it gets.
    fn leaving(&self, division: &Division, owners: &Owners<'_>, are_moved: bool) -> BTreeMap<usize, Leaving> {
        let rank = division.ranks.rank();
        let mut grains: BTreeMap<usize, Vec<(u32, usize)>> = BTreeMap::new();
        for grain in division.own.clone() {
            if let (_, Some(after)) = owners.of(grain as u32)
                && after != rank
            {
                let place = owners.moved_to[grain];
                grains.entry(after).or_default().push((place, grain));
            }
        }
        let all = [&self.contacts.pairs, &self.contacts.walls].map(|chunks| 0..chunks.len());
        let mut contacts = self.contacts.leaving(all, |i, j| owners.receivers(rank, i, j));
        let told = grains.into_iter().map(|(other, mut grains)| {
            // the other hears of them in their new order
            grains.sort_unstable();
            let theirs = owners.after[other]..owners.after[other + 1];
            let segments = division
                .segments()
                .filter(|segment| !are_moved && theirs.contains(segment));
            let spreads = segments.map(|segment| {
                let of_segment = self.neighbours.spreads_of_segment(segment);
                let spreads = self.spreads.get(of_segment).unwrap_or_default();
                spreads.iter().copied().fold(Spread::NONE, Spread::join)
            });
            let leaving = Leaving {
                grains: self.grains.pack(grains.iter().map(|&(_, grain)| grain)),
                contacts: contacts.remove(&other).unwrap_or_default(),
                spreads: spreads.collect(),
            };
            (other, leaving)
        });
        told.collect()
    }
}
