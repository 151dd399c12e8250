//! What looks at the whole of a run that several processes share.
//!
//! Measures of all grains are the work of the first process, and it alone is told the whole
//! ([`Simulation::bring_together`]), some segments at a time. Whoever changes all grains from outside has all told all first
//! ([`Simulation::make_whole`]).

use super::{Aside, Division, encode};
use crate::contacts::{ContactChunk, Contacts, NearTables};
use crate::neighbours::{Neighbours, SegmentsOfCandidates};
use crate::particles::spread::Spread;
use crate::particles::{Row, Rows};
use crate::simulation::Simulation;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Segments of which another process tells the first at once: some megabytes.
const SEGMENTS_AT_ONCE: usize = 16;

/// Candidates and contacts of some segments, as others are told.
#[derive(Serialize, Deserialize)]
struct Tables {
    /// Where the grains were when the candidates were found.
    reference: Vec<Row>,
    near: NearTables,
    /// How the grains move in this step, segment by segment.
    spreads: Vec<Spread>,
    candidates: SegmentsOfCandidates,
    pairs: Vec<ContactChunk>,
    walls: Vec<ContactChunk>,
}

/// The tables of all segments, as they come.
#[derive(Default)]
struct Collected {
    reference: Rows,
    near: Vec<NearTables>,
    spreads: Vec<Spread>,
    candidates: Vec<SegmentsOfCandidates>,
    pairs: Vec<ContactChunk>,
    walls: Vec<ContactChunk>,
}

/// What the first process has been told of the whole since the latest step, as all know.
#[derive(Debug, Default)]
pub(super) struct Gathered {
    grains: bool,
    tables: bool,
    /// At the first process: the tables of the whole, or its own ones while those are in place.
    other: Option<Box<Aside>>,
    /// Whether this is the first process and those of the whole are in place.
    is_in_place: bool,
}

impl Collected {
    fn add(&mut self, tables: Tables) {
        let rows = tables.reference.iter();
        rows.for_each(|row| self.reference.push(row.vector, row.scalar));
        self.near.push(tables.near);
        self.spreads.extend(tables.spreads);
        self.candidates.push(tables.candidates);
        self.pairs.extend(tables.pairs);
        self.walls.extend(tables.walls);
    }
}

impl Division {
    /// Segments of a process, as many at once as are told.
    fn pieces(&self, rank: usize) -> impl Iterator<Item = Range<usize>> + use<> {
        let (first, end) = (self.cuts[rank], self.cuts[rank + 1]);
        let piece = move |start: usize| start..(start + SEGMENTS_AT_ONCE).min(end);
        (first..end).step_by(SEGMENTS_AT_ONCE).map(piece)
    }

    /// Tells the first process of the own segments; it hears with [`Self::heard_of_others`].
    fn tell_first(&self, of: impl Fn(Range<usize>) -> Vec<u8>) {
        let rank = self.ranks.rank();
        if rank > 0 {
            self.pieces(rank).for_each(|piece| self.ranks.tell(0, &of(piece)));
        }
    }

    /// What the first process hears of the segments of others, in the order of the segments; others hear nothing.
    fn heard_of_others(&self) -> impl Iterator<Item = (Range<usize>, Vec<u8>)> {
        let others = if self.ranks.rank() == 0 {
            1..self.ranks.count()
        } else {
            0..0
        };
        let pieces = others.flat_map(|rank| self.pieces(rank).map(move |piece| (rank, piece)));
        pieces.map(|(rank, piece)| (piece, self.ranks.hear(rank)))
    }

    /// What was told of the whole is out of date. Tells whether this process has been told of all grains.
    pub(super) fn forget_gathered(&mut self) -> bool {
        std::mem::take(&mut self.gathered).grains && self.ranks.rank() == 0
    }
}

impl Simulation {
    /// Has every process have all grains and contacts. Each calls this; nothing happens where they have.
    pub fn make_whole(&mut self) {
        self.make_grains_whole();
        self.share_bulges();
        let Some(mut division) = self.division.take_if(|division| !division.is_whole) else {
            return;
        };
        division.forget_gathered();
        let mut all = Collected::default();
        for of in division.ranks.gather(&encode(&self.tables_of(division.segments()))) {
            all.add(division.decode(&of));
        }
        division.aside = Some(Box::new(self.put_in_place(&division, all)));
        division.is_whole = true;
        self.division = Some(division);
    }

    /// Has every process have all grains, where the run is shared.
    fn make_grains_whole(&mut self) {
        debug_assert!(!self.awaits_kick, "velocities are those predicted");
        let Some(division) = self.division.as_ref().filter(|division| !division.is_whole) else {
            return;
        };
        let mine = self.grains.pack(division.own.clone());
        for (rank, of) in division.ranks.gather(&mine).iter().enumerate() {
            let some = self.grains_in(division.cuts[rank]..division.cuts[rank + 1]);
            if rank != division.ranks.rank() && !self.grains.unpack(some, of) {
                division.ranks.give_up("another process has other grains");
            }
        }
    }

    /// Has the first process have all grains and contacts until [`Simulation::go_apart`]. Each process calls both, and nothing between
    /// them that processes do together.
    pub fn bring_together(&mut self) {
        self.bring_grains_together();
        let Some(mut division) = self.division.take_if(|division| !division.is_whole) else {
            return;
        };
        if !std::mem::replace(&mut division.gathered.tables, true) {
            division.tell_first(|segments| encode(&self.tables_of(segments)));
            if division.ranks.rank() == 0 {
                let mut all = Collected::default();
                all.add(self.tables_of(division.segments()));
                division
                    .heard_of_others()
                    .for_each(|(_, told)| all.add(division.decode(&told)));
                division.gathered.other = Some(Box::new(self.put_in_place(&division, all)));
            }
        } else {
            self.swap_tables(&mut division);
        }
        if division.gathered.other.is_some() {
            (division.is_whole, division.gathered.is_in_place) = (true, true);
        }
        self.division = Some(division);
    }

    /// Has the first process have all grains until the next step. Each calls this.
    pub fn bring_grains_together(&mut self) {
        debug_assert!(!self.awaits_kick, "velocities are those predicted");
        let Some(mut division) = self.division.take_if(|division| !division.is_whole) else {
            return;
        };
        if !std::mem::replace(&mut division.gathered.grains, true) {
            division.tell_first(|segments| self.tell_grains(segments));
            for (segments, bytes) in division.heard_of_others() {
                if !self.hear_grains(segments, &bytes) {
                    division.ranks.give_up("another process has other grains");
                }
            }
        }
        self.division = Some(division);
    }

    /// After [`Simulation::bring_together`]: the first process goes on with its own contacts. Each calls this.
    pub fn go_apart(&mut self) {
        let Some(mut division) = self.division.take_if(|division| division.gathered.is_in_place) else {
            return;
        };
        self.swap_tables(&mut division);
        (division.is_whole, division.gathered.is_in_place) = (false, false);
        self.division = Some(division);
    }

    fn swap_tables(&mut self, division: &mut Division) {
        if let Some(other) = &mut division.gathered.other {
            std::mem::swap(&mut self.neighbours, &mut other.neighbours);
            std::mem::swap(&mut self.contacts, &mut other.contacts);
            std::mem::swap(&mut self.near, &mut other.near);
        }
    }

    /// Grains of some segments.
    fn grains_in(&self, segments: Range<usize>) -> Range<usize> {
        let (per_segment, count) = (self.neighbours.grains_per_segment(), self.grains.len());
        (segments.start * per_segment).min(count)..(segments.end * per_segment).min(count)
    }

    /// What is told of the grains of some segments: how they move, and how far their surfaces bulge.
    fn tell_grains(&self, segments: Range<usize>) -> Vec<u8> {
        let some = self.grains_in(segments);
        let mut bytes = self.grains.pack(some.clone());
        if let Some(state) = &self.coupling {
            bytes.extend_from_slice(bytemuck::cast_slice(&state.memory.bulge[some]));
        }
        bytes
    }

    /// Takes what [`Self::tell_grains`] made; tells whether it fits.
    fn hear_grains(&mut self, segments: Range<usize>, mut bytes: &[u8]) -> bool {
        let some = self.grains_in(segments);
        if let Some(state) = &mut self.coupling {
            let bulge: &mut [u8] = bytemuck::cast_slice_mut(&mut state.memory.bulge[some.clone()]);
            let Some((grains, bulges)) = bytes.len().checked_sub(bulge.len()).map(|at| bytes.split_at(at)) else {
                return false;
            };
            bulge.copy_from_slice(bulges);
            bytes = grains;
        }
        self.grains.unpack(some, bytes)
    }

    /// Candidates and contacts of some segments.
    fn tables_of(&self, segments: Range<usize>) -> Tables {
        let of = |chunks| self.chunks_of(segments.clone(), chunks);
        Tables {
            reference: self.neighbours.reference.rows()[self.grains_in(segments.clone())].to_vec(),
            near: self.near.of_segments(segments.clone()),
            spreads: (segments.clone())
                .map(|s| self.neighbours.spread_of(s, &self.spreads))
                .collect(),
            pairs: self.contacts.pairs[of(Neighbours::chunks_of_segment)].to_vec(),
            walls: self.contacts.walls[of(Neighbours::wall_chunks_of_segment)].to_vec(),
            candidates: self.neighbours.of_segments(segments),
        }
    }

    /// Goes on with the tables of all; answers with those before.
    fn put_in_place(&mut self, division: &Division, all: Collected) -> Aside {
        for (segment, spread) in all.spreads.into_iter().enumerate() {
            self.spreads[self.neighbours.spreads_of_segment(segment)].fill(spread);
        }
        let mut whole = self.neighbours.with_candidates(all.candidates);
        whole.reference = all.reference;
        let contacts = Contacts {
            pairs: all.pairs,
            walls: all.walls,
            stride: self.contacts.stride,
            ..Contacts::default()
        };
        let before = Aside {
            found: self.tables,
            neighbours: std::mem::replace(&mut self.neighbours, whole),
            contacts: std::mem::replace(&mut self.contacts, contacts),
            near: std::mem::replace(&mut self.near, NearTables::joined(all.near)),
        };
        self.restore_neighbours(division);
        before
    }
}
