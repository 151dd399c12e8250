//! What all processes of a run have together, as the first of them writes it: it hears it piece by piece, so that it never has the whole.

use super::Ranks;
use itertools::{Either, Itertools};
use serde::de::DeserializeOwned;
use serde::ser::SerializeSeq;
use serde::{Serialize, Serializer};
use std::iter;
use std::marker::PhantomData;

/// Bytes that another process tells the first at once; it may hold as many of each.
const PIECE: usize = 1 << 16;

/// The processes that have something together; each does the same with it, and the first alone gets the whole.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Together<'a> {
    /// Nothing where this process has all.
    ranks: Option<&'a dyn Ranks>,
}

impl Together<'_> {
    /// One process that has all.
    pub(crate) const ALONE: Self = Self { ranks: None };
}

impl<'a> Together<'a> {
    pub(crate) fn of(ranks: &'a dyn Ranks) -> Self {
        Self { ranks: Some(ranks) }
    }

    /// Whether this process gets the whole.
    pub(crate) fn is_first(self) -> bool {
        self.ranks.is_none_or(|ranks| ranks.rank() == 0)
    }

    /// How many all have.
    pub(crate) fn count(self, own: usize) -> usize {
        let [all] = self.counts([own as u64]);
        all as usize
    }

    /// How many all have of several things.
    pub(crate) fn counts<const N: usize>(self, own: [u64; N]) -> [u64; N] {
        let (sums, _) = self.counts_and_most(own);
        sums
    }

    /// The same, and the most that one has of each.
    pub(crate) fn counts_and_most<const N: usize>(self, own: [u64; N]) -> ([u64; N], [u64; N]) {
        let Some(ranks) = self.ranks else { return (own, own) };
        let (mut sums, mut most) = ([0; N], [0; N]);
        let told: Vec<u64> = bytemuck::pod_collect_to_vec(&ranks.gather_even(bytemuck::cast_slice(&own)));
        for (k, count) in told.into_iter().enumerate() {
            sums[k % N] += count;
            most[k % N] = count.max(most[k % N]);
        }
        (sums, most)
    }

    /// Whether this process has all.
    pub(crate) fn is_alone(self) -> bool {
        self.ranks.is_none()
    }

    /// The largest number of all.
    pub(crate) fn largest(self, own: f64) -> f64 {
        let Some(ranks) = self.ranks else { return own };
        let all = ranks.gather_even(&own.to_ne_bytes());
        let numbers = all.as_chunks::<8>().0.iter();
        numbers.map(|&bytes| f64::from_ne_bytes(bytes)).fold(own, f64::max)
    }

    /// What the first has.
    pub(crate) fn told_by_first<T: Clone + Serialize + DeserializeOwned>(self, own: &[T]) -> Vec<T> {
        let Some(ranks) = self.ranks else { return own.to_vec() };
        // encoding into memory fails for no value of ours
        let mine = match self.is_first() {
            true => postcard::to_stdvec(own).unwrap_or_default(),
            false => Vec::new(),
        };
        let all = ranks.gather(&mine);
        let told = all.first().map(|bytes| postcard::from_bytes(bytes));
        match told {
            Some(Ok(list)) => list,
            _ => ranks.give_up("the first process said what cannot be read"),
        }
    }

    /// What all have, in the order of the processes: for the first, that is; for others what is their own, which they tell on the way.
    pub(crate) fn joined<T>(self, own: impl Iterator<Item = T> + 'a) -> impl Iterator<Item = T> + 'a
    where
        T: Serialize + DeserializeOwned + 'a,
    {
        if self.ranks.is_none() {
            return Either::Left(own);
        }
        let (mut own, mut teller) = (own.fuse(), self.teller());
        let mine = iter::from_fn(move || {
            let next = own.next();
            match &next {
                Some(value) => teller.iter_mut().for_each(|teller| teller.tell(value)),
                None => teller.take().into_iter().for_each(Teller::end),
            }
            next
        });
        Either::Right(mine.chain(self.heard()))
    }

    /// The same by rising keys, where those of each process rise.
    pub(crate) fn merged<T, K>(
        self,
        own: impl Iterator<Item = T> + 'a,
        key: fn(&T) -> K,
    ) -> impl Iterator<Item = T> + 'a
    where
        T: Serialize + DeserializeOwned + 'a,
        K: Ord + 'a,
    {
        if self.ranks.is_none() {
            return Either::Left(own);
        }
        let told = match self.is_first() {
            true => Box::new(own) as Box<dyn Iterator<Item = T> + 'a>,
            false => Box::new(self.joined(own)),
        };
        let heard = self
            .others()
            .map(move |(ranks, rank)| Box::new(Heard::new(ranks, rank)) as _);
        Either::Right((iter::once(told).chain(heard)).kmerge_by(move |one, other| key(one) < key(other)))
    }

    /// Writes a list that all have together, so long.
    pub(super) fn write<T, S: Serializer>(self, own: &[T], length: usize, serializer: S) -> Result<S::Ok, S::Error>
    where
        T: Serialize + DeserializeOwned,
    {
        let mut list = serializer.serialize_seq(Some(length))?;
        let mut teller = self.teller();
        for value in own {
            teller.iter_mut().for_each(|teller| teller.tell(value));
            list.serialize_element(value)?;
        }
        teller.into_iter().for_each(Teller::end);
        self.heard::<T>().try_for_each(|value| list.serialize_element(&value))?;
        list.end()
    }

    fn teller(self) -> Option<Teller<'a>> {
        let ranks = self.ranks.filter(|ranks| ranks.rank() > 0)?;
        let piece = Vec::new();
        Some(Teller { ranks, piece })
    }

    /// What others tell: for the first.
    fn heard<T: DeserializeOwned + 'a>(self) -> impl Iterator<Item = T> + 'a {
        self.others().flat_map(|(ranks, rank)| Heard::new(ranks, rank))
    }

    /// Those that the first hears.
    fn others(self) -> impl Iterator<Item = (&'a dyn Ranks, usize)> + 'a {
        let ranks = self.ranks.filter(|ranks| ranks.rank() == 0);
        ranks
            .into_iter()
            .flat_map(|ranks| (1..ranks.count()).map(move |rank| (ranks, rank)))
    }
}

/// Tells the first process values one after the other.
struct Teller<'a> {
    ranks: &'a dyn Ranks,
    piece: Vec<u8>,
}

impl Teller<'_> {
    fn tell(&mut self, value: &impl Serialize) {
        // encoding into memory fails for no value of ours
        self.piece = postcard::to_extend(value, std::mem::take(&mut self.piece)).unwrap_or_default();
        if self.piece.len() >= PIECE {
            self.ranks.tell(0, &self.piece);
            self.piece.clear();
        }
    }

    /// Tells the rest, and that this is all.
    fn end(self) {
        if !self.piece.is_empty() {
            self.ranks.tell(0, &self.piece);
        }
        self.ranks.tell(0, &[]);
    }
}

/// What a [`Teller`] tells.
struct Heard<'a, T> {
    ranks: &'a dyn Ranks,
    rank: usize,
    piece: Vec<u8>,
    done: usize,
    is_all: bool,
    values: PhantomData<T>,
}

impl<'a, T> Heard<'a, T> {
    fn new(ranks: &'a dyn Ranks, rank: usize) -> Self {
        Self {
            ranks,
            rank,
            piece: Vec::new(),
            done: 0,
            is_all: false,
            values: PhantomData,
        }
    }
}

impl<T: DeserializeOwned> Iterator for Heard<'_, T> {
    type Item = T;

    fn next(&mut self) -> Option<T> {
        if self.done == self.piece.len() && !self.is_all {
            (self.piece, self.done) = (self.ranks.hear(self.rank), 0);
            self.is_all = self.piece.is_empty();
        }
        if self.is_all {
            return None;
        }
        match postcard::take_from_bytes(&self.piece[self.done..]) {
            Ok((value, rest)) => {
                self.done = self.piece.len() - rest.len();
                Some(value)
            }
            Err(error) => self
                .ranks
                .give_up(&format!("another process said what cannot be read: {error}")),
        }
    }
}
