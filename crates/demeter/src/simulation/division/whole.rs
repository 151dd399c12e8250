//! The whole of a run that several processes share, known to all of them: [`Simulation::make_whole`].

use super::{Aside, Division, encode};
use crate::contacts::{ContactChunk, Contacts, NearTables};
use crate::neighbours::{FormerPlaces, Neighbours, SegmentsOfCandidates};
use crate::particles::spread::Spread;
use crate::simulation::Simulation;
use crate::step::CouplingState;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Candidates and contacts of some segments, as others are told.
#[derive(Serialize, Deserialize)]
struct Tables {
    /// Where the grains were when the candidates were found.
    former: FormerPlaces,
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
    former: FormerPlaces,
    near: Vec<NearTables>,
    spreads: Vec<Spread>,
    candidates: Vec<SegmentsOfCandidates>,
    pairs: Vec<ContactChunk>,
    walls: Vec<ContactChunk>,
}

impl Collected {
    fn add(&mut self, tables: Tables) {
        self.former.append(tables.former);
        self.near.push(tables.near);
        self.spreads.extend(tables.spreads);
        self.candidates.push(tables.candidates);
        self.pairs.extend(tables.pairs);
        self.walls.extend(tables.walls);
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
        self.coupling.iter().for_each(CouplingState::outdate);
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
        assert!(!self.awaits_kick, "velocities are those predicted");
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

    /// Grains of some segments.
    pub(super) fn grains_in(&self, segments: Range<usize>) -> Range<usize> {
        let (per_segment, count) = (self.neighbours.grains_per_segment(), self.grains.len());
        (segments.start * per_segment).min(count)..(segments.end * per_segment).min(count)
    }

    /// Candidates and contacts of some segments.
    fn tables_of(&self, segments: Range<usize>) -> Tables {
        let of = |chunks| self.chunks_of(segments.clone(), chunks);
        Tables {
            former: self.neighbours.former.of(self.grains_in(segments.clone())),
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
        whole.former = all.former;
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
