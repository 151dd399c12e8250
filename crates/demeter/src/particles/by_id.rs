//! From ids of grains to their indices.

/// Finds grains by their ids.
#[derive(Debug)]
pub enum ById {
    /// Places, from 1, by id; 0 where no grain has it.
    Listed(Vec<usize>),
    /// Ids and places in order, where few of many ids are there.
    Sorted(Vec<(u32, usize)>),
}

impl ById {
    /// Looks through the ids of grains, in their order.
    pub fn new(ids: &[u32]) -> Self {
        let largest = ids.iter().copied().max().unwrap_or(0) as usize;
        if largest / 8 <= ids.len() {
            let mut places = vec![0; largest + 1];
            for (id, place) in ids.iter().zip(1..) {
                places[*id as usize] = place;
            }
            return Self::Listed(places);
        }
        let mut by_id: Vec<(u32, usize)> = ids.iter().copied().zip(0..).collect();
        by_id.sort_unstable();
        Self::Sorted(by_id)
    }

    /// The index of the grain with an id.
    pub fn find(&self, id: u32) -> Option<usize> {
        match self {
            Self::Listed(places) => places.get(id as usize)?.checked_sub(1),
            Self::Sorted(by_id) => {
                let at = by_id.binary_search_by_key(&id, |&(id, _)| id);
                at.ok().map(|at| by_id[at].1)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grains_are_found_among_many_and_among_few_ids() {
        for ids in [vec![3, 1, 2, 0], vec![7, 4_000_000_000, 3]] {
            let by_id = ById::new(&ids);
            for (place, id) in ids.iter().enumerate() {
                assert_eq!(by_id.find(*id), Some(place));
            }
            assert_eq!((by_id.find(5), by_id.find(u32::MAX)), (None, None));
        }
        assert_eq!(ById::new(&[]).find(0), None);
    }
}
