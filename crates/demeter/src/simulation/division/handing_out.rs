//! How a run comes to be shared: the first process has all of it, and hands out to each what it needs. No other ever has the whole.

use super::{Division, WORK_OF_A_GRAIN, encode};
use crate::contacts::{NearTables, PairsAndWalls};
use crate::neighbours::{FormerPlaces, SegmentsOfCandidates, put_in_order};
use crate::particles::HigherDerivatives;
use crate::particles::spread::{GRAINS_OF_A_SPREAD, Spread};
use crate::simulation::{Simulation, memory};
use demeter_physics::integrator::Integrator;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// What a process is handed.
#[derive(Serialize, Deserialize)]
struct Portion {
    /// The first segment of every process, and the number of all.
    cuts: Vec<usize>,
    /// Number of all grains.
    count: usize,
    /// Grains that it must know, its own and partners of theirs, by rising indices, and what they are.
    known: Vec<u32>,
    grains: Vec<u8>,
    /// How far the surfaces of these grains may bulge [m]; nothing where none does.
    bulges: Vec<f64>,
    contacts: PairsAndWalls,
    near: NearTables,
    /// Nothing before the first search.
    tables: Option<Tables>,
}

/// What was found for the own grains.
#[derive(Serialize, Deserialize)]
struct Tables {
    candidates: SegmentsOfCandidates,
    /// Where the own grains were then.
    former: FormerPlaces,
}

impl Simulation {
    /// Hands out the run that the first process has. Each calls this.
    pub(super) fn hand_out(&mut self, mut division: Box<Division>) {
        let ranks = Arc::clone(&division.ranks);
        let portion = if ranks.rank() == 0 {
            let cuts = self.cuts_to_hand_out(&division);
            for rank in 1..ranks.count() {
                ranks.tell(rank, &encode(&self.portion(&cuts, rank)));
            }
            self.portion(&cuts, 0)
        } else {
            division.decode(&ranks.hear(0))
        };
        self.take_portion(&mut division, portion);
        self.division = Some(division);
        self.weigh_work();
        self.note_balance();
        memory::give_back();
    }

    /// Where the segments are cut so that all processes have as much to do.
    fn cuts_to_hand_out(&mut self, division: &Division) -> Vec<usize> {
        if self.rebuilds == 0 {
            // in the order of the first search, so that few grains go on from one process to another then
            put_in_order(&mut self.grains);
            self.neighbours = self.neighbours.before_search(&self.grains, &self.materials);
        }
        let neighbours = &self.neighbours;
        let work_of = |segment: usize| {
            let of_grains = WORK_OF_A_GRAIN * neighbours.grains_of_segment(segment).len();
            of_grains + neighbours.work_of_segment(segment)
        };
        division.even_cuts((0..neighbours.segments()).map(work_of))
    }

    /// What a process needs that gets some segments.
    fn portion(&self, cuts: &[usize], rank: usize) -> Portion {
        let own = self.grains_in(cuts[rank]..cuts[rank + 1]);
        let is_own = |grain: u32| own.contains(&(grain as usize));
        let partners = self.neighbours.pairs_across(&own).map(|(_, partner)| partner);
        let mut known: Vec<u32> = own.clone().map(|grain| grain as u32).chain(partners).collect();
        known.sort_unstable();
        known.dedup();
        let receives = |i, j: Option<u32>| (is_own(i) || j.is_some_and(is_own)).then_some(rank);
        let mut contacts = match self.rebuilds {
            0 => BTreeMap::new(),
            _ => self.contacts.leaving(self.chunks_with(&own), receives),
        };
        let bulge = |&grain: &u32| self.coupling.as_ref()?.memory.bulge.get(grain as usize).copied();
        let tables = || Tables {
            candidates: self.neighbours.picked(&own),
            former: self.neighbours.former.of(own.clone()),
        };
        Portion {
            cuts: cuts.to_vec(),
            count: self.grains.len(),
            grains: self.grains.pack(known.iter().map(|&grain| grain as usize)),
            bulges: known.iter().filter_map(bulge).collect(),
            known,
            contacts: contacts.remove(&rank).unwrap_or_default(),
            near: self.near.saved(),
            tables: (self.rebuilds > 0).then(tables),
        }
    }

    /// Chunks that may have contacts of some grains, whose segments are whole: between grains, and with walls.
    fn chunks_with(&self, grains: &Range<usize>) -> [Vec<usize>; 2] {
        let (neighbours, segments) = (&self.neighbours, self.neighbours.segments_with(grains));
        let pairs = segments.clone().flat_map(|s| neighbours.chunks_of_segment(s));
        let walls = segments.flat_map(|s| neighbours.wall_chunks_of_segment(s));
        [pairs.collect(), walls.collect()]
    }

    /// Goes on with what this process was handed.
    fn take_portion(&mut self, division: &mut Division, portion: Portion) {
        let (count, known) = (portion.count, portion.known.iter().map(|&grain| grain as usize));
        self.grains.keep(count, std::iter::empty());
        if self.integrator == Integrator::Gear {
            self.grains.higher.resize(count, HigherDerivatives::default());
        }
        if !self.grains.unpack(known.clone(), &portion.grains) {
            division.ranks.give_up("the first process has other grains");
        }
        if let (Some(coupling), false) = (&mut self.coupling, portion.bulges.is_empty()) {
            let mut bulge = vec![0.0; count];
            known.zip(portion.bulges).for_each(|(grain, of)| bulge[grain] = of);
            coupling.memory.bulge = bulge;
        }
        self.near = portion.near;
        let spreads = count.div_ceil(GRAINS_OF_A_SPREAD);
        self.spreads.resize(spreads, Spread::ANY);
        [self.contacts.pairs, self.contacts.walls] = portion.contacts;
        match portion.tables {
            None => self.neighbours = self.neighbours.before_search(&self.grains, &self.materials),
            Some(tables) => {
                self.neighbours = self.neighbours.with_candidates([tables.candidates]);
                let first = portion.cuts[division.ranks.rank()];
                self.neighbours.former = tables.former.among(first, count);
                self.restore_neighbours(division);
                self.contacts.hand_over(&self.neighbours, None);
            }
        }
        let per_segment = self.neighbours.grains_per_segment();
        division.take_cuts(portion.cuts, per_segment, count);
        division.introduced.clear();
        division.note_sizes(&self.grains, per_segment);
        division.find_borders(&self.neighbours, self.coupling.is_some());
    }
}
