//! Grains that get another process: where they are put in order again, where some go, and where the work is divided anew.
//!
//! Every process knows which place the grains get that it knows, and all cut the segments alike. So each knows what leaves it, and tells
//! it: how the grains move, and the contacts that they are in.

use super::{Division, Introduced, WORK_OF_A_GRAIN, encode, introduced_of};
use crate::comm::Message;
use crate::contacts::{PairsAndWalls, grains_in};
use crate::neighbours::Moves;
use crate::particles::spread::Spread;
use crate::simulation::Simulation;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// Bytes of a number that is told.
const BYTES: usize = size_of::<f64>();

/// What a process tells another of grains that become its own.
#[derive(Default, Serialize, Deserialize)]
struct Leaving {
    /// New indices of the grains, which rise.
    places: Vec<u32>,
    grains: Vec<u8>,
    contacts: PairsAndWalls,
    /// Old and new indices of the grains in these contacts, where grains are put in another order.
    moves: Vec<(u32, u32)>,
    /// How the grains of whole segments move in this step; nothing where grains get other places in memory.
    spreads: Vec<Spread>,
}

/// Which process has a grain, before and after.
struct Owners<'a> {
    before: &'a [usize],
    after: &'a [usize],
    moves: &'a Moves,
    per_segment: usize,
}

impl Owners<'_> {
    /// The process that a grain, told by its old index, belongs to after, and its index then; nowhere where it is gone.
    fn place_after(&self, grain: u32) -> Option<(usize, u32)> {
        let to = self.moves.of(grain)?;
        Some((rank_in(self.after, to as usize / self.per_segment), to))
    }

    /// The process of a grain, told by its old index, before and after; after nowhere where it is gone.
    fn of(&self, grain: u32) -> (usize, Option<usize>) {
        let after = self.place_after(grain).map(|(rank, _)| rank);
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

    /// Which grains need not be introduced again: their process stays the same and has told the other of them before. Beside them the
    /// new and old indices of those of others.
    fn still_introduced(&self, owners: &Owners<'_>) -> (Introduced, Vec<(usize, usize)>) {
        let (n, count, rank) = (owners.per_segment, owners.moves.count(), self.ranks.rank());
        let (mut still, mut of_others) = (Introduced::new(), Vec::new());
        for (&(other, segment), grains) in &self.introduced {
            let teller = rank_in(owners.before, segment);
            for grain in introduced_of(segment * n, grains) {
                let to = owners.moves.of(grain as u32).map(|to| to as usize);
                let Some(to) = to.filter(|to| rank_in(owners.after, to / n) == teller) else {
                    continue;
                };
                let first = to / n * n;
                let of_segment = still.entry((other, first / n)).or_default();
                of_segment.resize(n.min(count - first), false);
                of_segment[to - first] = true;
                if teller != rank {
                    of_others.push((to, grain));
                }
            }
        }
        (still, of_others)
    }

    /// Tells some others some bytes, and hears what each of them tells; those who are told tell, too.
    pub(super) fn swap(&self, told: Vec<(usize, Vec<u8>)>) -> Vec<(usize, Vec<u8>)> {
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
    /// Where segments are cut so that all processes have as much to do with the grains in their new order.
    pub(super) fn even_cuts(&self, moves: &Moves) -> Vec<usize> {
        let Some(division) = &self.division else {
            return Vec::new();
        };
        let per_segment = self.neighbours.grains_per_segment();
        let mut mine: BTreeMap<u32, u32> = BTreeMap::new();
        let mut add = |place: u32, work: usize| *mine.entry(place / per_segment as u32).or_default() += work as u32;
        let own = division.own.start as u32..division.own.end as u32;
        own.filter_map(|grain| moves.of(grain))
            .for_each(|to| add(to, WORK_OF_A_GRAIN));
        for (one, other) in self.neighbours.bearers(&division.own) {
            // a pair goes with the later of its grains
            if let (Some(one), Some(other)) = (moves.of(one), moves.of(other)) {
                add(one.max(other), 1);
            }
        }
        let mine: Vec<(u32, u32)> = mine.into_iter().collect();
        let mut work = vec![0; moves.count().div_ceil(per_segment)];
        for (segment, of_segment) in division.told_by_all(&mine).concat() {
            match work.get_mut(segment as usize) {
                Some(work) => *work += of_segment as usize,
                None => division.ranks.give_up("another process has other grains"),
            }
        }
        division.even_cuts(work)
    }

    /// Where segments are cut so that nearly all grains that stay in the run stay with their processes, told by rising indices which
    /// are gone.
    pub(super) fn same_cuts(&self, gone: &[usize]) -> Vec<usize> {
        let Some(division) = &self.division else {
            return Vec::new();
        };
        let per_segment = self.neighbours.grains_per_segment();
        let segments = (self.grains.len() - gone.len()).div_ceil(per_segment);
        let cut = |&before: &usize| {
            let before = (before * per_segment).min(self.grains.len());
            let first = before - gone.partition_point(|&grain| grain < before);
            ((first + per_segment / 2) / per_segment).min(segments)
        };
        let ranks = division.ranks.count();
        let inner = division.cuts[1..ranks].iter().map(cut);
        std::iter::once(0).chain(inner).chain([segments]).collect()
    }

    /// Puts the grains where they go, and gives each to the process that has its segment then. `are_moved` tells whether any gets another
    /// place in memory. Comes to know where grains go that were unknown here and are in contacts that others had. Each calls this.
    pub(super) fn hand_over_grains(&mut self, cuts: Vec<usize>, moves: &mut Moves, are_moved: bool) {
        let Some(mut division) = self.division.take() else {
            return;
        };
        let (per_segment, rank) = (self.neighbours.grains_per_segment(), division.ranks.rank());
        let owners = Owners {
            before: &division.cuts,
            after: &cuts,
            moves,
            per_segment,
        };
        let mut told = self.leaving(&division, &owners, are_moved);
        let receivers: Vec<usize> = told.keys().copied().collect();
        let of_all = division.told_by_all(&receivers);
        let tellers = (0..of_all.len()).filter(|&other| of_all[other].contains(&rank));
        let others: BTreeSet<usize> = told.keys().copied().chain(tellers).collect();
        let told = others
            .iter()
            .map(|other| (*other, encode(&told.remove(other).unwrap_or_default())));
        let heard = division.swap(told.collect());
        let (introduced, of_others) = division.still_introduced(&owners);
        let stay = division.own.clone().filter_map(|grain| {
            let to = owners.place_after(grain as u32).filter(|(after, _)| *after == rank);
            to.map(|(_, to)| (to as usize, grain))
        });
        self.grains.keep(moves.count(), stay.chain(of_others.iter().copied()));
        let before = std::mem::take(&mut division.cuts);
        division.introduced = introduced;
        division.take_cuts(cuts, per_segment, self.grains.len());
        for (other, bytes) in heard {
            let leaving: Leaving = division.decode(&bytes);
            let theirs = before[other]..before[other + 1];
            let segments = division.segments().filter(|segment| theirs.contains(segment));
            let places = leaving.places.iter().map(|&place| place as usize);
            let are_mine = places.clone().all(|place| division.own.contains(&place));
            if !(are_mine && self.grains.unpack(places, &leaving.grains)) {
                division.ranks.give_up("another process has other grains");
            }
            leaving.moves.iter().for_each(|&(grain, to)| moves.note(grain, to));
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
        if !grains_in(&self.contacts.pairs, &self.contacts.walls).all(|grain| moves.knows(grain)) {
            division
                .ranks
                .give_up("it is not known where a grain in a contact goes");
        }
        division.note_sizes(&self.grains, per_segment);
        self.division = Some(division);
    }

    /// What each of some others is told of the grains that it gets.
    fn leaving(&self, division: &Division, owners: &Owners<'_>, are_moved: bool) -> BTreeMap<usize, Leaving> {
        let rank = division.ranks.rank();
        let mut grains: BTreeMap<usize, Vec<(u32, usize)>> = BTreeMap::new();
        for grain in division.own.clone() {
            if let Some((after, place)) = owners.place_after(grain as u32)
                && after != rank
            {
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
            let contacts = contacts.remove(&other).unwrap_or_default();
            let leaving = Leaving {
                places: grains.iter().map(|&(place, _)| place).collect(),
                grains: self.grains.pack(grains.iter().map(|&(_, grain)| grain)),
                moves: owners.moves.to_be_told(grains_in(&contacts[0], &contacts[1])),
                contacts,
                spreads: spreads.collect(),
            };
            (other, leaving)
        });
        told.collect()
    }
}
