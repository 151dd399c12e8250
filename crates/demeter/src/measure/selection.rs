//! Which grains a measure is about.

use crate::particles::{Grains, Origins};

/// Grains by what they are; all conditions that are told hold at once.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Selection {
    /// Of this material.
    pub material: Option<u16>,
    /// Of this batch or feed: batches count first.
    pub source: Option<u16>,
    /// With one of these ids, sorted; any, when there is none.
    pub ids: Vec<u32>,
    /// With this tag.
    pub tag: Option<i32>,
    /// Of a smaller diameter than this [m].
    pub finer_than: Option<f64>,
    /// Of this diameter or a larger one [m].
    pub coarser_than: Option<f64>,
}

impl Selection {
    /// Whether a grain is meant.
    pub fn holds(&self, grains: &Grains, origins: &Origins, grain: usize) -> bool {
        let diameter = 2.0 * grains.radius(grain);
        self.holds_one(grains.id[grain], grains.material[grain], diameter, origins)
    }

    /// The same of a grain that may not be there any more, told its material and diameter [m].
    pub(super) fn holds_one(&self, id: u32, of: u16, diameter: f64, origins: &Origins) -> bool {
        self.material.is_none_or(|material| of == material)
            && (self.ids.is_empty() || self.ids.binary_search(&id).is_ok())
            && self.source.is_none_or(|source| origins.of(id) == Some(source))
            && self.tag.is_none_or(|tag| origins.tag(id) == tag)
            && self.finer_than.is_none_or(|most| diameter < most)
            && self.coarser_than.is_none_or(|least| diameter >= least)
    }
}
