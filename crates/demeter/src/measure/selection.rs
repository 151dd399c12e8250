//! Which grains a measure is about.

use crate::particles::{Grains, Origins};

/// Grains by what they are; all conditions that are told hold at once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection {
    /// Of this material.
    pub material: Option<u16>,
    /// Of this batch or feed: batches count first.
    pub source: Option<u16>,
    /// With one of these ids, sorted; any, when there is none.
    pub ids: Vec<u32>,
    /// With this tag.
    pub tag: Option<i32>,
}

impl Selection {
    /// Whether a grain is meant.
    pub fn holds(&self, grains: &Grains, origins: &Origins, grain: usize) -> bool {
        let id = grains.id[grain];
        self.material.is_none_or(|material| grains.material[grain] == material)
            && (self.ids.is_empty() || self.ids.binary_search(&id).is_ok())
            && self.source.is_none_or(|source| origins.of(id) == Some(source))
            && self.tag.is_none_or(|tag| origins.tag(id) == tag)
    }
}
