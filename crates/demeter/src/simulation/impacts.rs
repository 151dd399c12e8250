//! Contacts that began, until somebody asks.

use super::Simulation;
use crate::contacts::Impact;

impl Simulation {
    /// Keeps every contact that begins from now on, until it is taken. Contacts of the first moment do not count, as nobody knows how they
    /// began.
    pub(crate) fn watch_impacts(&mut self) {
        self.impacts.get_or_insert_default();
    }

    /// Whether contacts that begin are kept.
    pub(crate) fn watches_impacts(&self) -> bool {
        self.impacts.is_some()
    }

    /// The contacts that began since the last time, in their order.
    pub(crate) fn take_impacts(&mut self) -> Vec<Impact> {
        let mut taken = self.impacts.as_mut().map(std::mem::take).unwrap_or_default();
        // contacts of a mesh with one grain come in the order of the table
        taken.sort_by_key(Impact::order);
        taken
    }

    /// Gathers the contacts of own chunks that began in this step.
    pub(crate) fn gather_impacts(&mut self) {
        let (pairs, walls) = (self.own_chunks(), self.own_wall_chunks());
        let Some(impacts) = &mut self.impacts else { return };
        let chunks = (self.contacts.pairs[pairs].iter_mut()).chain(&mut self.contacts.walls[walls]);
        chunks.for_each(|chunk| impacts.append(&mut chunk.impacts));
    }
}
