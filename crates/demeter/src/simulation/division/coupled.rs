//! What processes that share a run tell each other of contacts that feel each other.
//!
//! Every process finds how the contacts of its own grains displace their surfaces. A contact over a border is known on both sides, which
//! tell each other how far the surfaces of their own grains are displaced there: then both know the same of it.

use super::{Border, Division};
use crate::contacts::ContactChunk;
use crate::contacts::coupling::Delivered;
use crate::neighbours::Neighbours;
use crate::simulation::Simulation;

/// Numbers of a grain near a border that are told: how far its surface bulges, the largest force on it, whether forces have changed.
const NUMBERS: usize = 3;

/// A pair of grains of two processes.
#[derive(Clone, Copy, Debug)]
pub(super) struct PairAcross {
    chunk: usize,
    slot: usize,
    /// Which of both bodies is an own grain.
    own: usize,
}

impl Border {
    /// Displacements at the contacts of this border, with the own body of each.
    fn delivered<'a>(&'a self, chunks: &'a [ContactChunk]) -> impl Iterator<Item = (&'a Delivered, usize)> {
        self.pairs.iter().filter_map(move |pair| {
            let chunk = &chunks[pair.chunk];
            let contact = chunk.contacts_of(pair.slot).next()?;
            Some((&chunk.coupling.delivered[contact], pair.own))
        })
    }
}

impl Division {
    /// Finds the pairs of grains over all borders.
    pub(super) fn find_pairs_across(&mut self, neighbours: &Neighbours, per_segment: usize) {
        let mut lists = vec![Vec::new(); self.ranks.count()];
        for (pair, chunk, slot) in neighbours.places_across(&self.own) {
            let own = usize::from(!self.own.contains(&(pair.i as usize)));
            let other = [pair.j, pair.i][own];
            let across = PairAcross { chunk, slot, own };
            let key = (pair.later(), pair.earlier(), pair.shift);
            lists[self.rank_of(other, per_segment)].push((key, across));
        }
        for (border, message) in self.borders.iter_mut().zip(&self.messages) {
            let list = &mut lists[message.rank];
            list.sort_unstable_by_key(|(key, _)| *key);
            border.pairs.extend(list.iter().map(|(_, across)| *across));
        }
    }
}

impl Simulation {
    /// Tells the neighbours how far own surfaces are displaced at the contacts over borders, and hears it of theirs.
    pub(crate) fn exchange_displacements(&mut self) {
        let division = self.division.as_deref_mut().filter(|division| !division.is_whole);
        let (Some(division), Some(state)) = (division, &mut self.coupling) else {
            return;
        };
        let (chunks, messages) = (&self.contacts.pairs, &mut division.coupled_messages);
        for (border, message) in division.borders.iter().zip(messages.iter_mut()) {
            message.tell.clear();
            let displacements = border.delivered(chunks).map(|(delivered, own)| delivered.get(own));
            message.tell.extend(displacements);
            let to_hear = message.tell.len() + NUMBERS * border.hear.len();
            message.hear.resize(to_hear, 0.0);
            for &grain in &border.tell {
                let (g, changed) = (grain as usize, state.changes.any(grain));
                message
                    .tell
                    .extend([state.needed[g], state.largest_force[g], f64::from(changed)]);
            }
        }
        division.ranks.exchange(messages, &mut || ());
        for (border, message) in division.borders.iter().zip(messages) {
            let contacts = message.hear.len() - NUMBERS * border.hear.len();
            let (displacements, of_grains) = message.hear.split_at(contacts);
            for ((delivered, own), &displacement) in border.delivered(chunks).zip(displacements) {
                delivered.put(1 - own, displacement);
            }
            for (&grain, numbers) in border.hear.iter().zip(of_grains.chunks_exact(NUMBERS)) {
                state.needed[grain as usize] = numbers[0];
                state.largest_force[grain as usize] = numbers[1];
                if numbers[2] != 0.0 {
                    state.changes.note_force(grain);
                }
            }
        }
    }

    /// Tells the neighbours how far own surfaces near the borders bulge, and hears it of theirs.
    pub(crate) fn exchange_bulges(&mut self) {
        let division = self.division.as_deref_mut().filter(|division| !division.is_whole);
        let (Some(division), Some(state)) = (division, &mut self.coupling) else {
            return;
        };
        let messages = &mut division.coupled_messages;
        for (border, message) in division.borders.iter().zip(messages.iter_mut()) {
            message.tell.clear();
            let bulges = border.tell.iter().map(|&grain| state.needed[grain as usize]);
            message.tell.extend(bulges);
            message.hear.resize(border.hear.len(), 0.0);
        }
        division.ranks.exchange(messages, &mut || ());
        for (border, message) in division.borders.iter().zip(messages) {
            for (&grain, &needed) in border.hear.iter().zip(&message.hear) {
                state.needed[grain as usize] = needed;
            }
        }
    }

    /// Tells all processes how far the surfaces of all grains may bulge.
    pub(crate) fn share_bulges(&mut self) {
        let division = self.division.as_deref().filter(|division| !division.is_whole);
        let (Some(division), Some(state)) = (division, &mut self.coupling) else {
            return;
        };
        let bulge = &mut state.memory.bulge;
        let all = division
            .ranks
            .gather(bytemuck::cast_slice(&bulge[division.own.clone()]));
        let mut place = 0;
        for of in &all {
            let some = &mut bulge[place..place + of.len() / size_of::<f64>()];
            bytemuck::cast_slice_mut(some).copy_from_slice(of);
            place += some.len();
        }
    }
}
