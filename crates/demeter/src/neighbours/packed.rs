//! Pairs as the table holds them: there are several per grain, so no byte is left unused.

use super::Pair;
use serde::{Deserialize, Serialize};

/// A pair in the segment of its later grain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[repr(C, packed)]
pub(super) struct PackedPair {
    /// Index of the earlier grain.
    earlier: u32,
    /// Twice the place of the later grain in its segment, and 1 more where it has the lower id.
    later: u16,
    shift: u8,
}

/// Most grains of a segment whose places can be told.
pub(super) const MOST_OF_A_SEGMENT: usize = 1 << (u16::BITS - 1);

impl PackedPair {
    /// Packs a pair for the segment that begins with a grain.
    #[inline(always)]
    pub(super) fn new(pair: &Pair, first: u32) -> Self {
        let (later, earlier) = (pair.later(), pair.earlier());
        Self {
            earlier,
            later: ((later - first) << 1) as u16 | u16::from(later == pair.i),
            shift: pair.shift,
        }
    }

    /// The pair, told the first grain of the segment.
    #[inline(always)]
    pub(super) fn pair(&self, first: u32) -> Pair {
        let (later, earlier) = (first + self.place() as u32, self.earlier);
        let (i, j) = if self.later & 1 == 0 {
            (earlier, later)
        } else {
            (later, earlier)
        };
        let shift = self.shift;
        Pair { i, j, shift }
    }

    /// Place of the later grain in its segment.
    #[inline(always)]
    pub(super) fn place(&self) -> usize {
        usize::from(self.later >> 1)
    }

    /// Index of the earlier grain.
    #[inline(always)]
    pub(super) fn earlier(&self) -> u32 {
        self.earlier
    }

    /// What the pairs of a segment are sorted by.
    #[inline(always)]
    pub(super) fn key(&self) -> (usize, u32) {
        (self.place(), self.earlier)
    }
}

/// Pairs of one segment that follow each other.
#[derive(Clone, Copy, Debug)]
pub struct Pairs<'a> {
    /// The first grain of the segment.
    first: u32,
    packed: &'a [PackedPair],
}

impl<'a> Pairs<'a> {
    #[inline(always)]
    pub(super) fn new(first: usize, packed: &'a [PackedPair]) -> Self {
        let first = first as u32;
        Self { first, packed }
    }

    /// Number of pairs.
    #[inline(always)]
    pub fn len(&self) -> usize {
        self.packed.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.packed.is_empty()
    }

    /// One of them.
    #[inline(always)]
    pub fn get(&self, place: usize) -> Pair {
        self.packed[place].pair(self.first)
    }

    /// All of them, in their order.
    pub fn iter(self) -> impl ExactSizeIterator<Item = Pair> + Clone + 'a {
        let first = self.first;
        self.packed.iter().map(move |packed| packed.pair(first))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pair_is_packed_and_unpacked() {
        let first = 4_000_000_000;
        let last = first + MOST_OF_A_SEGMENT as u32 - 1;
        for (i, j) in [
            (first, 3),
            (3, first),
            (last, first),
            (first, last),
            (last, 0),
            (last - 1, last),
        ] {
            let pair = Pair { i, j, shift: 26 };
            let packed = PackedPair::new(&pair, first);
            assert_eq!(packed.pair(first), pair);
            assert_eq!(packed.key(), ((pair.later() - first) as usize, pair.earlier()));
        }
        assert_eq!(size_of::<PackedPair>(), 7);
    }
}
