//! A run that several processes share.
//!
//! Grains have the same numbers in all processes, in the order along the curve, and all have the same walls and books. Of the segments
//! of grains that lie behind each other on the curve each process has some of its own, so many that all have as much to do. In a
//! step it moves its own grains, hears where those are that may touch them, and finds the contacts that one of its own is in. When
//! candidates are found it hears of those near its own (`near`). Of all others it knows nothing: their rows of the tables are zeros
//! that take no memory (`Grains::keep`). A contact between grains of two processes is found by both, from the same numbers, so that
//! both know the same. What all contacts did is summed up segment by segment ([`StepWork`](crate::contacts::step_work::StepWork)).
//!
//! What is summed up over all grains and contacts each process sums up of its own (`sums`). Frames and checkpoints are written by the
//! first process, and measures made, which hears the parts of others meanwhile (`parts`). Who wants to look at the whole has all tell
//! all (`whole`). Where grains come or go, are put in order again or get another process, each finds which that are, and tells what leaves
//! it (`handing`).

mod coupled;
mod handing;
mod handing_out;
mod in_step;
mod near;
mod order;
mod parts;
mod report;
mod sums;
mod whole;

use super::misplaced::Uncounted;
use super::{Places, Simulation};
use crate::comm::together::Together;
use crate::comm::tree::{Then, turns};
use crate::comm::{Message, Ranks};
use crate::contacts::{Contacts, NearTables};
use crate::neighbours::{Moves, Neighbours, SearchEffort};
use crate::particles::spread::NUMBERS_OF_A_SPREAD;
use crate::step::{CouplingState, GRAINS_PER_TASK};
use handing::rank_in;
use near::SizesOfAll;
pub use report::{Sharing, SharingReport};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;
pub(crate) use sums::Segment;

/// Grains are divided anew when the busiest process has so much more to do, as a share of the mean, than right after they were
/// divided.
const DRIFT: f64 = 0.05;

/// Work of a grain, in candidates.
const WORK_OF_A_GRAIN: usize = 4;

/// Numbers of a grain that others hear in every step: place, velocity, angular velocity.
const NUMBERS: usize = 9;

/// How a run is shared, as one process sees it.
#[derive(Debug)]
pub(crate) struct Division {
    ranks: Arc<dyn Ranks>,
    /// The first segment of every process, and the number of all.
    cuts: Vec<usize>,
    /// Own grains.
    own: Range<usize>,
    sizes: SizesOfAll,
    introduced: Introduced,
    borders: Vec<Border>,
    /// What goes over each of them in a step.
    messages: Vec<Message>,
    /// The same of contacts that feel each other.
    coupled_messages: Vec<Message>,
    /// For every own segment whether others hear of any of its grains.
    tells_of: Vec<bool>,
    is_whole: bool,
    /// The divided tables while those of the whole are in place.
    aside: Option<Box<Aside>>,
    /// Work of the busiest process over the mean: now, and right after grains were divided.
    imbalance: f64,
    imbalance_when_divided: f64,
    divided: u64,
    /// Whether this process wants to end, and whether all know that one does.
    wants_to_end: bool,
    is_asked_to_end: bool,
}

/// Other processes with segments of which one has told the other what never changes; for every grain of the segment whether it has.
type Introduced = BTreeMap<(usize, usize), Vec<bool>>;

/// Grains of a segment that were introduced, told its first grain.
fn introduced_of(first: usize, grains: &[bool]) -> impl Iterator<Item = usize> + Clone + '_ {
    (first..).zip(grains).filter(|(_, is)| **is).map(|(grain, _)| grain)
}

/// All grains that were introduced, those told by several processes several times.
fn all_introduced(introduced: &Introduced, per_segment: usize) -> impl Iterator<Item = usize> + Clone + '_ {
    let segments = introduced.iter();
    segments.flat_map(move |(&(_, segment), grains)| introduced_of(segment * per_segment, grains))
}

/// Tables of the own segments while those of all are in place, or the other way.
#[derive(Debug)]
struct Aside {
    /// How often tables had been found when these were put aside.
    found: u64,
    neighbours: Neighbours,
    contacts: Contacts,
    near: NearTables,
}

/// Grains of this process that may touch grains of another, by rising indices, and those of the other.
#[derive(Debug)]
struct Border {
    tell: Vec<u32>,
    hear: Vec<u32>,
    /// Segments of both.
    tell_segments: Vec<u32>,
    hear_segments: Vec<u32>,
    /// Pairs of these grains, in the same order on both sides: where contacts feel each other.
    pairs: Vec<coupled::PairAcross>,
}

/// Encodes what is told to others.
fn encode(value: &impl Serialize) -> Vec<u8> {
    // encoding into memory fails for no value of ours
    postcard::to_stdvec(value).unwrap_or_default()
}

impl Division {
    fn segments(&self) -> Range<usize> {
        let rank = self.ranks.rank();
        self.cuts[rank]..self.cuts[rank + 1]
    }

    /// What others told.
    fn decode<T: for<'a> Deserialize<'a>>(&self, bytes: &[u8]) -> T {
        match postcard::from_bytes(bytes) {
            Ok(value) => value,
            Err(error) => self
                .ranks
                .give_up(&format!("another process said what cannot be read: {error}")),
        }
    }

    /// What every process tells all others, by rank; each calls this with its own.
    fn told_by_all<T: Serialize + for<'a> Deserialize<'a>>(&self, mine: &T) -> Vec<T> {
        let told = self.ranks.gather(&encode(mine));
        told.iter().map(|bytes| self.decode(bytes)).collect()
    }

    /// What all processes have, joined in the order of the ranks; each calls this with its own.
    fn fold<T: Serialize + for<'a> Deserialize<'a>>(&self, mine: T, join: impl Fn(T, T) -> T) -> T {
        self.ranks.begin_round();
        let mut known = mine;
        for turn in turns(self.ranks.rank(), self.ranks.count()) {
            let told = if turn.tells { encode(&known) } else { Vec::new() };
            let heard = self.ranks.swap(turn.other, &told);
            known = match turn.then {
                Then::Nothing => known,
                Then::Behind => join(known, self.decode(&heard)),
                Then::Before => join(self.decode(&heard), known),
                Then::Instead => self.decode(&heard),
            };
        }
        known
    }

    /// The largest numbers of all processes, place by place; not a number where any is none.
    fn largest<const N: usize>(&self, mine: [f64; N]) -> [f64; N] {
        let larger = |(one, other): (f64, f64)| if one.is_nan() || one > other { one } else { other };
        let join = |a: Vec<f64>, b: Vec<f64>| a.into_iter().zip(b).map(larger).collect();
        let all = self.fold(mine.to_vec(), join);
        all.try_into()
            .unwrap_or_else(|_| self.ranks.give_up("another process told other numbers"))
    }

    /// Sums of what all processes count, and the largest of each.
    fn counts<const N: usize>(&self, mine: [u64; N]) -> ([u64; N], [u64; N]) {
        Together::of(&*self.ranks).counts_and_most(mine)
    }

    /// Grains of which this process knows anything: its own, those of segments that were near, and those that it hears of. Some are told
    /// twice.
    fn known(&self, per_segment: usize, count: usize) -> impl Iterator<Item = usize> + Clone + '_ {
        let near = all_introduced(&self.introduced, per_segment);
        known_grains(Some(self), count).chain(near.filter(|grain| !self.own.contains(grain)))
    }

    /// The process that a grain belongs to.
    fn rank_of(&self, grain: u32, per_segment: usize) -> usize {
        rank_in(&self.cuts, grain as usize / per_segment)
    }

    /// Finds which grains others must hear of, and which of theirs are heard of here: both sides find the same.
    fn find_borders(&mut self, neighbours: &Neighbours, are_coupled: bool) {
        let per_segment = neighbours.grains_per_segment().max(1);
        let mut lists: Vec<[Vec<u32>; 2]> = vec![Default::default(); self.ranks.count()];
        for (own, other) in neighbours.pairs_across(&self.own) {
            let rank = self.rank_of(other, per_segment);
            lists[rank][0].push(own);
            lists[rank][1].push(other);
        }
        self.borders.clear();
        self.messages.clear();
        self.coupled_messages.clear();
        let own = self.segments();
        self.tells_of.clear();
        self.tells_of.resize(own.len(), false);
        for [tell, _] in &lists {
            tell.iter()
                .for_each(|&g| self.tells_of[g as usize / per_segment - own.start] = true);
        }
        for (rank, [mut tell, mut hear]) in lists.into_iter().enumerate() {
            if tell.is_empty() {
                continue;
            }
            for list in [&mut tell, &mut hear] {
                list.sort_unstable();
                list.dedup();
            }
            let segments = |grains: &[u32]| {
                let mut segments: Vec<u32> = grains.iter().map(|&g| g / per_segment as u32).collect();
                segments.dedup();
                segments
            };
            let (tell_segments, hear_segments) = (segments(&tell), segments(&hear));
            let numbers =
                |grains: &[u32], segments: &[u32]| NUMBERS * grains.len() + NUMBERS_OF_A_SPREAD * segments.len();
            self.messages.push(Message {
                rank,
                tell: Vec::with_capacity(numbers(&tell, &tell_segments)),
                hear: vec![0.0; numbers(&hear, &hear_segments)],
            });
            self.coupled_messages.push(Message {
                rank,
                ..Message::default()
            });
            self.borders.push(Border {
                tell,
                hear,
                tell_segments,
                hear_segments,
                pairs: Vec::new(),
            });
        }
        if are_coupled {
            self.find_pairs_across(neighbours, per_segment);
        }
    }
}

/// Grains of other processes that this one hears of in every step.
pub(crate) fn heard_grains(division: Option<&Division>) -> impl Iterator<Item = usize> + Clone + '_ {
    let divided = division.filter(|division| !division.is_whole);
    let borders = divided.into_iter().flat_map(|division| &division.borders);
    borders.flat_map(|border| border.hear.iter().map(|&grain| grain as usize))
}

/// Grains whose motion this process knows: its own, and those that it hears of.
pub(crate) fn known_grains(division: Option<&Division>, count: usize) -> impl Iterator<Item = usize> + Clone + '_ {
    let divided = division.filter(|division| !division.is_whole);
    let own = divided.map_or(0..count, |division| division.own.clone());
    own.chain(heard_grains(division))
}

impl Simulation {
    /// Shares the run with other processes, of which each calls this with the same state; where no force is custom, only that of the first
    /// need hold grains.
    pub fn share(&mut self, ranks: Box<dyn Ranks>) {
        self.division = Some(Box::new(Division {
            ranks: Arc::from(ranks),
            cuts: Vec::new(),
            own: 0..0,
            sizes: SizesOfAll::default(),
            introduced: Introduced::new(),
            borders: Vec::new(),
            messages: Vec::new(),
            coupled_messages: Vec::new(),
            tells_of: Vec::new(),
            is_whole: true,
            aside: None,
            imbalance: 1.0,
            imbalance_when_divided: 1.0,
            divided: 0,
            wants_to_end: false,
            is_asked_to_end: false,
        }));
    }

    /// Number of processes that share the run, this one among them.
    pub fn processes(&self) -> usize {
        self.division.as_ref().map_or(1, |division| division.ranks.count())
    }

    /// Why every process does the work of all, though the run is shared; `None` where each does a part.
    pub fn shares_nothing(&self) -> Option<&'static str> {
        self.has_custom_force().then_some("custom forces")
    }

    /// Number of grains of which this process knows anything.
    pub(crate) fn known_grains(&self) -> usize {
        let (per_segment, count) = (self.neighbours.grains_per_segment(), self.grains.len());
        match self.division.as_ref().filter(|division| !division.is_whole) {
            Some(division) => division.known(per_segment, count).collect::<BTreeSet<usize>>().len(),
            None => count,
        }
    }

    /// Grains whose motion this process knows: its own, and those that it hears of.
    pub(crate) fn grains_here(&self) -> impl Iterator<Item = usize> + Clone + '_ {
        known_grains(self.division.as_deref(), self.grains.len())
    }

    /// Whether this process has some of the contacts only.
    pub(crate) fn is_divided(&self) -> bool {
        self.division.as_ref().is_some_and(|division| !division.is_whole)
    }

    /// Grains that this process moves.
    pub(crate) fn own_grains(&self) -> Range<usize> {
        match &self.division {
            Some(division) if !division.is_whole => division.own.clone(),
            _ => 0..self.grains.len(),
        }
    }

    /// Grains of a segment; all where there are no segments yet, as before the first search.
    pub(crate) fn grains_per_piece(&self) -> usize {
        match self.neighbours.grains_per_segment() {
            0 => self.grains.len().max(1),
            count => count,
        }
    }

    /// Segments of a task that does little for each grain.
    pub(crate) fn pieces_per_task(&self) -> usize {
        GRAINS_PER_TASK.div_ceil(self.grains_per_piece())
    }

    /// Own grains, segment by segment.
    pub(crate) fn own_pieces(&self) -> Vec<Range<usize>> {
        let (own, n) = (self.own_grains(), self.grains_per_piece());
        let piece = |first: usize| first..(first + n).min(own.end);
        own.clone().step_by(n).map(piece).collect()
    }

    /// Segments of the grains that this process moves.
    pub(crate) fn own_segments(&self) -> Range<usize> {
        match &self.division {
            Some(division) if !division.is_whole => division.segments(),
            _ => 0..self.neighbours.segments(),
        }
    }

    /// Chunks of contacts between grains of these segments.
    pub(crate) fn own_chunks(&self) -> Range<usize> {
        self.chunks_of(self.own_segments(), Neighbours::chunks_of_segment)
    }

    /// Chunks of segments that follow each other.
    fn chunks_of(&self, segments: Range<usize>, of: fn(&Neighbours, usize) -> Range<usize>) -> Range<usize> {
        match segments.end.checked_sub(1).filter(|last| segments.start <= *last) {
            Some(last) => of(&self.neighbours, segments.start).start..of(&self.neighbours, last).end,
            None => 0..0,
        }
    }

    /// Segments of the table of candidates that this process works on: its own, and those with pairs of its own grains.
    pub(crate) fn segments_here(&self) -> Range<usize> {
        match &self.division {
            Some(division) if !division.is_whole => self.neighbours.segments_in_use(&division.segments()),
            _ => 0..self.neighbours.segments(),
        }
    }

    /// Divides the run, where it is shared and whole: from then on each process has its part. The first must have all of it.
    pub(crate) fn divide(&mut self) {
        if self.shares_nothing().is_some() {
            return;
        }
        let Some(mut division) = self.division.take_if(|division| division.is_whole) else {
            return;
        };
        division.is_whole = false;
        self.coupling.iter().for_each(CouplingState::outdate);
        match division.aside.take() {
            Some(aside) if aside.found == self.tables => {
                (self.neighbours, self.contacts, self.near) = (aside.neighbours, aside.contacts, aside.near);
                self.division = Some(division);
                self.forget_others();
            }
            _ => self.hand_out(division),
        }
    }

    /// After the first search: where some have more to do than others, divides the work anew.
    pub(crate) fn even_out_start(&mut self) {
        if !self.is_divided() {
            return;
        }
        if self.division.as_ref().is_some_and(|d| d.imbalance > 1.0 + DRIFT) {
            let places = self.hand_over_evenly();
            self.continue_together(places);
        }
        self.note_balance();
    }

    /// Forgets all grains of which this process needs to know nothing.
    fn forget_others(&mut self) {
        let (per_segment, count) = (self.neighbours.grains_per_segment(), self.grains.len());
        if let Some(division) = &self.division {
            let known = division.known(per_segment, count).map(|grain| (grain, grain));
            self.grains.keep(count, known);
        }
    }

    fn restore_neighbours(&mut self, division: &Division) {
        let (walls, materials) = (self.walls.len(), self.materials.list().len());
        if !self.neighbours.restore(&self.grains, walls, materials) {
            division.ranks.give_up("another process has other candidates");
        }
    }

    /// Finds all candidates anew, each process those of its own grains.
    pub(super) fn find_candidates_together(&mut self) {
        let is_uneven = self
            .division
            .as_ref()
            .is_some_and(|d| d.imbalance > d.imbalance_when_divided + DRIFT);
        self.wrap_grains();
        let is_moved = self.is_out_of_order();
        let places = if is_moved {
            let mut moves = Moves::Reordered(self.find_order_together());
            let cuts = self.even_cuts(&moves);
            self.hand_over_grains(cuts, &mut moves, true);
            Places::New(moves)
        } else if is_uneven {
            self.hand_over_evenly()
        } else {
            Places::Kept
        };
        self.rebuilds += 1;
        self.continue_together(places);
        if is_moved {
            self.scattered_in_order = self.neighbours.scattered();
        }
        if is_moved || is_uneven {
            self.note_balance();
        }
    }

    /// Gives grains that keep their places in memory to other processes, so that all have as much to do.
    fn hand_over_evenly(&mut self) -> Places {
        let mut moves = Moves::none(self.grains.len());
        let cuts = self.even_cuts(&moves);
        self.hand_over_grains(cuts, &mut moves, false);
        Places::HandedOver
    }

    /// Takes grains, told by rising indices, out of the run. Each calls this.
    pub(super) fn leave_out_together(&mut self, gone: &[usize]) {
        let mut moves = Moves::without(gone, self.grains.len());
        let cuts = self.same_cuts(gone);
        self.hand_over_grains(cuts, &mut moves, true);
        self.wrap_grains();
        self.continue_together(Places::New(moves));
    }

    /// Notes that grains came, behind all others: the last process has them.
    pub(super) fn lengthen_division(&mut self) {
        let (per_segment, grains) = (self.neighbours.grains_per_segment(), self.grains.len());
        let divided = self.division.as_mut().filter(|division| !division.is_whole);
        let Some(division) = divided else { return };
        let mut cuts = division.cuts.clone();
        cuts.pop();
        cuts.push(grains.div_ceil(per_segment));
        division.take_cuts(cuts, per_segment, grains);
        for (&(_, segment), of_segment) in &mut division.introduced {
            // all know what comes
            of_segment.resize(per_segment.min(grains - segment * per_segment), true);
        }
        division.note_sizes(&self.grains, per_segment);
    }

    /// Finds the candidates of the own grains, and who must hear of which then.
    pub(super) fn continue_together(&mut self, places: Places) {
        self.continue_with_candidates(places);
        if let Some(division) = &mut self.division {
            division.find_borders(&self.neighbours, self.coupling.is_some());
        }
    }

    /// Notes how evenly the work is divided right after it was.
    fn note_balance(&mut self) {
        if let Some(division) = &mut self.division {
            division.divided += 1;
            division.imbalance_when_divided = division.imbalance;
        }
    }

    /// Counts the candidates of all processes, after each has found its own.
    pub(super) fn count_candidates(&mut self) {
        if !self.is_divided() {
            return;
        }
        let Some(division) = &mut self.division else { return };
        let effort = self.neighbours.effort();
        let own: usize = division
            .segments()
            .map(|s| self.neighbours.candidates_of_segment(s))
            .sum();
        let uncounted = self.uncounted.is_some().into();
        let ([tests, scattered, candidates, uncounted], _) =
            division.counts([effort.tests, effort.scattered, own as u64, uncounted]);
        if uncounted > 0 {
            self.uncounted.get_or_insert(Uncounted::ELSEWHERE);
        }
        (self.neighbours).note_total(SearchEffort { tests, scattered }, candidates as usize);
        self.weigh_work();
    }

    /// Notes how unevenly the work is divided.
    fn weigh_work(&mut self) {
        let Some(division) = &mut self.division else { return };
        let candidates = self.neighbours.pair_count() + self.neighbours.wall_pair_count();
        let work = (WORK_OF_A_GRAIN * division.own.len() + candidates) as u64;
        let ([all], [most]) = division.counts([work]);
        division.imbalance = (most * division.ranks.count() as u64) as f64 / all.max(1) as f64;
    }

    /// Contacts between grains that are engaged, of all processes.
    pub(crate) fn engaged_contacts(&self) -> usize {
        match self.division.as_ref().filter(|division| !division.is_whole) {
            None => self.contacts.pair_count(),
            Some(division) => {
                let chunks = division.segments().flat_map(|s| self.neighbours.chunks_of_segment(s));
                let own: usize = chunks.map(|c| self.contacts.pairs[c].engaged()).sum();
                division.counts([own as u64]).0[0] as usize
            }
        }
    }

    /// Asks all processes to end the run after the next step; where it is not shared, nothing is asked.
    pub fn ask_to_end(&mut self) {
        if let Some(division) = &mut self.division {
            division.wants_to_end = true;
        }
    }

    /// Whether any process has asked to end, as all know after the step.
    pub fn is_asked_to_end(&self) -> bool {
        self.division.as_ref().is_some_and(|division| division.is_asked_to_end)
    }

    /// Whether this process is the one that writes and tells: the first, or the only one.
    pub fn is_first_process(&self) -> bool {
        self.division.as_ref().is_none_or(|division| division.ranks.rank() == 0)
    }
}
