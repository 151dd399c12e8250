//! Where grains go in memory.

use crate::particles::Grains;
use itertools::{Either, Itertools};

/// The new index of every grain by its old one.
#[derive(Clone, Debug)]
pub enum Moves {
    /// Grains in another order. Where several processes share a run, each knows where its own go, and those that it knows of others.
    Reordered(NewPlaces),
    /// Grains in their order, without some.
    ClosedUp {
        /// Those that are gone, by rising indices.
        gone: Vec<u32>,
        /// Number of all grains before.
        before: usize,
    },
}

/// One more than the new index of every grain, 0 of those that are not known: these take no memory.
#[derive(Clone, Debug)]
pub struct NewPlaces(Vec<u32>);

impl NewPlaces {
    /// Of so many grains none is known.
    pub(crate) fn unknown(grains: usize) -> Self {
        Self(vec![0; grains])
    }

    /// Where a grain goes, if that is known.
    #[inline(always)]
    pub(crate) fn get(&self, grain: u32) -> Option<u32> {
        self.0[grain as usize].checked_sub(1)
    }

    /// Notes where a grain goes.
    #[inline(always)]
    pub(crate) fn note(&mut self, grain: u32, to: u32) {
        self.0[grain as usize] = to + 1;
    }
}

impl Moves {
    /// All grains stay where they are.
    pub(crate) fn none(grains: usize) -> Self {
        Self::without(&[], grains)
    }

    /// Some of so many grains, told by rising indices, are gone, and the others close up.
    pub(crate) fn without(gone: &[usize], grains: usize) -> Self {
        Self::ClosedUp {
            gone: gone.iter().map(|&grain| grain as u32).collect(),
            before: grains,
        }
    }

    /// Number of grains after the move.
    pub(crate) fn count(&self) -> usize {
        match self {
            Self::Reordered(places) => places.0.len(),
            Self::ClosedUp { gone, before } => before - gone.len(),
        }
    }

    /// Where a grain goes; nowhere if it is gone.
    #[inline(always)]
    pub(crate) fn of(&self, grain: u32) -> Option<u32> {
        match self {
            Self::Reordered(places) => {
                let to = places.get(grain);
                assert!(to.is_some(), "it is not known where grain {grain} goes");
                to
            }
            Self::ClosedUp { gone, .. } => match gone.binary_search(&grain) {
                Ok(_) => None,
                Err(before) => Some(grain - before as u32),
            },
        }
    }

    /// Whether it is known where a grain goes, or that it is gone.
    pub(crate) fn knows(&self, grain: u32) -> bool {
        match self {
            Self::Reordered(places) => places.get(grain).is_some(),
            Self::ClosedUp { .. } => true,
        }
    }

    /// Notes where a grain goes of which another process told.
    pub(crate) fn note(&mut self, grain: u32, to: u32) {
        if let Self::Reordered(places) = self {
            places.note(grain, to);
        }
    }

    /// Old and new indices of some grains, each once, where others cannot know where these go.
    pub(crate) fn to_be_told(&self, some: impl Iterator<Item = u32>) -> Vec<(u32, u32)> {
        match self {
            Self::Reordered(places) => {
                let known = some.filter_map(|grain| places.get(grain).map(|to| (grain, to)));
                known.sorted_unstable().dedup().collect()
            }
            Self::ClosedUp { .. } => Vec::new(),
        }
    }

    /// New and old indices of all grains that are known.
    fn kept(&self) -> impl Iterator<Item = (usize, usize)> + Clone + '_ {
        match self {
            Self::Reordered(places) => {
                let known = places.0.iter().enumerate().filter(|(_, to)| **to > 0);
                Either::Left(known.map(|(from, &to)| (to as usize - 1, from)))
            }
            Self::ClosedUp { gone, before } => {
                let stretches = (0..=gone.len()).flat_map(move |k| {
                    let first = k.checked_sub(1).map_or(0, |last| gone[last] as usize + 1);
                    let end = gone.get(k).map_or(*before, |&next| next as usize);
                    (first..end).map(move |from| (from - k, from))
                });
                Either::Right(stretches)
            }
        }
    }

    /// Moves grains, all of which are known.
    pub(crate) fn apply(&self, grains: &mut Grains) {
        grains.keep(self.count(), self.kept());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grains_close_up_where_some_are_gone() {
        for gone in [&[][..], &[0], &[5], &[0, 1, 4], &[2, 5], &[0, 1, 2, 3, 4, 5]] {
            let moves = Moves::without(gone, 6);
            let stay: Vec<usize> = (0..6).filter(|grain| !gone.contains(grain)).collect();
            let kept: Vec<_> = stay.iter().copied().enumerate().collect();
            assert_eq!(moves.kept().collect::<Vec<_>>(), kept);
            assert_eq!(moves.count(), stay.len());
            for grain in 0..6 {
                let to = stay.iter().position(|&other| other == grain);
                assert_eq!(moves.of(grain as u32).map(|to| to as usize), to, "{gone:?}");
            }
        }
    }
}
