//! Which batch or feed every grain came from, and when, and the tags that grains carry.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Sources of grains by ranges of their ids, and their tags.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origins {
    /// Sorted; no two overlap.
    ranges: Vec<Range>,
    /// Tags of the grains that carry another than 0.
    tags: BTreeMap<u32, i32>,
}

/// Ids that follow each other, of one source and one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Range {
    first: u32,
    last: u32,
    source: u16,
    step: u64,
}

impl Origins {
    /// Notes that a grain came from a source at a step. Ids that follow each other take no memory of their own.
    pub fn add(&mut self, id: u32, source: u16, step: u64) {
        let at = self.ranges.partition_point(|range| range.first <= id);
        if let Some(before) = at.checked_sub(1).and_then(|k| self.ranges.get_mut(k)) {
            if id <= before.last {
                return;
            }
            if before.last + 1 == id && (before.source, before.step) == (source, step) {
                before.last = id;
                return;
            }
        }
        let range = Range {
            first: id,
            last: id,
            source,
            step,
        };
        self.ranges.insert(at, range);
    }

    /// The source of a grain.
    pub fn of(&self, id: u32) -> Option<u16> {
        self.range(id).map(|range| range.source)
    }

    /// The step at which a grain came; 0 of one that is not known.
    pub fn born(&self, id: u32) -> u64 {
        self.range(id).map_or(0, |range| range.step)
    }

    /// The tag of a grain; 0 unless another was given.
    pub fn tag(&self, id: u32) -> i32 {
        self.tags.get(&id).copied().unwrap_or(0)
    }

    /// Whether any grain carries another tag than 0.
    pub fn have_tags(&self) -> bool {
        !self.tags.is_empty()
    }

    /// Gives a grain a tag in place of the one that it had.
    pub fn set_tag(&mut self, id: u32, tag: i32) {
        if tag == 0 {
            self.tags.remove(&id);
        } else {
            self.tags.insert(id, tag);
        }
    }

    /// Forgets the tag of a grain that is gone; its id is never used again.
    pub fn forget_tag(&mut self, id: u32) {
        self.tags.remove(&id);
    }

    fn range(&self, id: u32) -> Option<&Range> {
        let at = self.ranges.partition_point(|range| range.first <= id);
        let range = self.ranges.get(at.checked_sub(1)?)?;
        (id <= range.last).then_some(range)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_of_mixed_ids_are_found_again() {
        let told = [(10, 0), (11, 0), (5, 1), (12, 1), (13, 0), (14, 0), (1, 0), (6, 1)];
        let mut origins = Origins::default();
        for (id, source) in told {
            origins.add(id, source, 7 * u64::from(source));
        }
        for (id, source) in told {
            assert_eq!(origins.of(id), Some(source), "{id}");
            assert_eq!(origins.born(id), 7 * u64::from(source), "{id}");
        }
        assert_eq!([0, 2, 7, 9, 15].map(|id| origins.of(id)), [None; 5]);
        assert_eq!(origins.ranges.len(), 5);
        origins.add(11, 7, 0);
        assert_eq!(origins.of(11), Some(0), "a grain keeps its source");
    }

    #[test]
    fn a_tag_stays_until_another_is_given() {
        let mut origins = Origins::default();
        origins.set_tag(4, 7);
        origins.set_tag(5, -2);
        origins.set_tag(4, 3);
        assert_eq!([3, 4, 5].map(|id| origins.tag(id)), [0, 3, -2]);
        origins.set_tag(5, 0);
        origins.forget_tag(4);
        assert_eq!(origins, Origins::default());
    }
}
