//! The order of the grains of all processes along the curve. None hears of all grains: each sorts those of a stretch of the curve, which
//! hold about as many as its own, and tells their processes where they go.

use super::{Division, encode, introduced_of};
use crate::comm::Message;
use crate::neighbours::{Bounds, Curve, Keyed, NewPlaces};
use crate::simulation::Simulation;
use std::collections::BTreeMap;

/// Places on the curve, per process, that all hear of to choose the stretches.
const SAMPLES: usize = 64;

/// Place of a grain on the curve, and its id.
type Key = (u64, u32);

impl Simulation {
    /// Finds the order of the grains of all processes along the curve; tells where those go that this process knows.
    pub(super) fn find_order_together(&self) -> NewPlaces {
        let mut places = NewPlaces::unknown(self.grains.len());
        let Some(division) = &self.division else {
            return places;
        };
        let own = division.own.clone();
        let rows = &self.grains.position.rows()[own.clone()];
        let bounds = division.fold(Bounds::of_centres(rows), Bounds::join);
        let sorted = Curve::new(bounds, self.grains.len()).sorted(rows, &self.grains.id[own.clone()]);
        let keys: Vec<Key> = sorted.iter().map(|&(place, id, _): &Keyed| (place, id)).collect();
        for ((.., grain), to) in sorted.iter().zip(division.numbers_in_all(&keys, self.grains.len())) {
            places.note(own.start as u32 + grain, to);
        }
        division.share_places(&mut places, self.neighbours.grains_per_segment());
        places
    }
}

impl Division {
    /// Numbers of some of so many keys in the order of those of all processes; each tells its own, which rise.
    fn numbers_in_all(&self, keys: &[Key], count: usize) -> Vec<u32> {
        let rank = self.ranks.rank();
        let pieces = self.pieces_of_stretches(keys, count);
        let counts: Vec<(usize, usize)> = pieces.iter().map(|(&rank, piece)| (rank, piece.len())).collect();
        let of_all: Vec<Vec<(usize, usize)>> = self.told_by_all(&counts);
        let before = of_all.iter().flatten().filter(|(stretch, _)| *stretch < rank);
        let before: usize = before.map(|(_, count)| count).sum();
        let tells_me = |other: &usize| of_all[*other].iter().any(|(stretch, _)| *stretch == rank);
        let others = (0..self.ranks.count()).filter(|other| pieces.contains_key(other) || tells_me(other));
        let others: Vec<usize> = others.filter(|&other| other != rank).collect();
        let piece_of = |other: &usize| pieces.get(other).copied().unwrap_or_default();
        let told = others.iter().map(|other| (*other, encode(&piece_of(other))));
        let heard = self.swap(told.collect());
        let mut lists: BTreeMap<usize, Vec<Key>> =
            heard.iter().map(|(other, keys)| (*other, self.decode(keys))).collect();
        lists.insert(rank, piece_of(&rank).to_vec());
        let mut numbers = numbers_in_stretch(&lists, before);
        let mut numbers_of = |other: &usize| numbers.remove(other).unwrap_or_default();
        let mine = numbers_of(&rank);
        let told = others.iter().map(|other| (*other, encode(&numbers_of(other))));
        let mut found: BTreeMap<usize, Vec<u32>> = self
            .swap(told.collect())
            .into_iter()
            .map(|(stretch, numbers)| (stretch, self.decode(&numbers)))
            .collect();
        found.insert(rank, mine);
        // the pieces lie behind each other
        let found: Vec<u32> = found.into_values().flatten().collect();
        if found.len() != keys.len() {
            self.ranks.give_up("another process has other grains");
        }
        found
    }

    /// What of rising keys lies on the stretch of the curve that each process sorts, where there are any: all find the same stretches.
    fn pieces_of_stretches<'k>(&self, keys: &'k [Key], count: usize) -> BTreeMap<usize, &'k [Key]> {
        let ranks = self.ranks.count();
        let apart = count.div_ceil(SAMPLES * ranks).max(1);
        let mine: Vec<Key> = keys.iter().skip(apart / 2).step_by(apart).copied().collect();
        let mut samples: Vec<Key> = self.told_by_all(&mine).concat();
        samples.sort_unstable();
        let mut rest = keys;
        let mut pieces = BTreeMap::new();
        for rank in 0..ranks {
            let end = match samples.get(samples.len() * (rank + 1) / ranks) {
                Some(next) => rest.partition_point(|key| key < next),
                None => rest.len(),
            };
            let (piece, others) = rest.split_at(end);
            if !piece.is_empty() {
                pieces.insert(rank, piece);
            }
            rest = others;
        }
        pieces
    }

    /// Hears where grains of others go that this process knows, and tells others the same of its own.
    fn share_places(&self, places: &mut NewPlaces, per_segment: usize) {
        let mut lists: BTreeMap<usize, [Vec<u32>; 2]> = BTreeMap::new();
        for (message, border) in self.messages.iter().zip(&self.borders) {
            let [tell, hear] = lists.entry(message.rank).or_default();
            tell.extend(&border.tell);
            hear.extend(&border.hear);
        }
        for (&(other, segment), grains) in &self.introduced {
            let [tell, hear] = lists.entry(other).or_default();
            let list = if self.segments().contains(&segment) { tell } else { hear };
            list.extend(introduced_of(segment * per_segment, grains).map(|grain| grain as u32));
        }
        let number = |&grain: &u32| places.get(grain).map_or(f64::NAN, f64::from);
        let messages = lists.iter().map(|(&rank, [tell, hear])| Message {
            rank,
            tell: tell.iter().map(number).collect(),
            hear: vec![f64::NAN; hear.len()],
        });
        let mut messages: Vec<Message> = messages.collect();
        self.ranks.exchange(&mut messages, &mut || ());
        for (message, [_, hear]) in messages.iter().zip(lists.values()) {
            for (&grain, &to) in hear.iter().zip(&message.hear) {
                places.note(grain, to as u32);
            }
        }
    }
}

/// Numbers of the rising keys of several processes in the order of all of them, from one number on.
fn numbers_in_stretch(lists: &BTreeMap<usize, Vec<Key>>, first: usize) -> BTreeMap<usize, Vec<u32>> {
    let mut numbers: BTreeMap<usize, Vec<u32>> = BTreeMap::new();
    let of_list = |(&rank, keys): (&usize, &Vec<Key>)| keys.iter().map(|&key| (key, rank)).collect::<Vec<_>>();
    let mut all: Vec<(Key, usize)> = lists.iter().flat_map(of_list).collect();
    all.sort_unstable();
    for (number, (_, rank)) in (first as u32..).zip(all) {
        numbers.entry(rank).or_default().push(number);
    }
    numbers
}
