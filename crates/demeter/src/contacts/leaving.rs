//! Contacts that another process is told, because a grain in them becomes its own.

use super::{ContactChunk, Contacts};
use std::collections::BTreeMap;

/// Contacts between grains, and those with walls.
pub(crate) type PairsAndWalls = [Vec<ContactChunk>; 2];

/// Grains in contacts between grains and with walls, each as often as it is in one.
pub(crate) fn grains_in<'c>(pairs: &'c [ContactChunk], walls: &'c [ContactChunk]) -> impl Iterator<Item = u32> + 'c {
    let first = pairs.iter().chain(walls).flat_map(|chunk| &chunk.i);
    first.chain(pairs.iter().flat_map(|chunk| &chunk.j)).copied()
}

impl Contacts {
    /// Copies of the contacts that some processes get, of those in some chunks between grains and some with walls. `receivers` tells the
    /// processes of a contact, by its first grain and its second where that is no wall.
    pub(crate) fn leaving<R>(
        &self,
        chunks: [impl IntoIterator<Item = usize>; 2],
        receivers: impl Fn(u32, Option<u32>) -> R,
    ) -> BTreeMap<usize, PairsAndWalls>
    where
        R: IntoIterator<Item = usize>,
    {
        let mut leaving: BTreeMap<usize, PairsAndWalls> = BTreeMap::new();
        let all = [&self.pairs, &self.walls].into_iter().zip(chunks);
        for (kind, (all, some)) in all.enumerate() {
            let are_walls = kind == 1;
            for chunk in some.into_iter().map(|number| &all[number]) {
                let mut of_chunk: BTreeMap<usize, ContactChunk> = BTreeMap::new();
                for (_, contacts) in chunk.now.of_candidates() {
                    let first = contacts.start;
                    for rank in receivers(chunk.i[first], (!are_walls).then(|| chunk.j[first])) {
                        let copy = of_chunk.entry(rank).or_insert_with(|| chunk.begin_copy());
                        copy.take_over(chunk, contacts.clone(), self.stride);
                        copy.end_candidate(copy.now.candidate.len(), are_walls);
                    }
                }
                for (rank, copy) in of_chunk {
                    leaving.entry(rank).or_default()[kind].push(copy);
                }
            }
        }
        leaving
    }

    /// Takes contacts that another process had, to be handed over with those here.
    pub(crate) fn join(&mut self, [pairs, walls]: PairsAndWalls) {
        self.pairs.extend(pairs);
        self.walls.extend(walls);
    }
}

impl ContactChunk {
    /// A chunk of the same law without contacts.
    fn begin_copy(&self) -> Self {
        let mut copy = Self::default();
        copy.forget();
        copy.law = self.law;
        copy
    }
}
