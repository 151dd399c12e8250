//! Which batch or feed every grain came from.

use serde::{Deserialize, Serialize};

/// Sources of grains by ranges of their ids.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origins {
    /// First id, last id and source, sorted; no two ranges overlap.
    ranges: Vec<(u32, u32, u16)>,
}

impl Origins {
    /// Notes that a grain came from a source. Ids that follow each other take no memory of their own.
    pub fn add(&mut self, id: u32, source: u16) {
        let at = self.ranges.partition_point(|range| range.0 <= id);
        if let Some(before) = at.checked_sub(1).and_then(|k| self.ranges.get_mut(k)) {
            if id <= before.1 {
                return;
            }
            if before.1 + 1 == id && before.2 == source {
                before.1 = id;
                return;
            }
        }
        self.ranges.insert(at, (id, id, source));
    }

    /// The source of a grain.
    pub fn of(&self, id: u32) -> Option<u16> {
        let at = self.ranges.partition_point(|range| range.0 <= id);
        let range = self.ranges.get(at.checked_sub(1)?)?;
        (id <= range.1).then_some(range.2)
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
            origins.add(id, source);
        }
        for (id, source) in told {
            assert_eq!(origins.of(id), Some(source), "{id}");
        }
        assert_eq!([0, 2, 7, 9, 15].map(|id| origins.of(id)), [None; 5]);
        assert_eq!(origins.ranges.len(), 5);
        origins.add(11, 7);
        assert_eq!(origins.of(11), Some(0), "a grain keeps its source");
    }
}
