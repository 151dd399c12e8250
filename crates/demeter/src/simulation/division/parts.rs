//! What this process has of what all write together.

use crate::comm::parts::Part;
use crate::comm::together::Together;
use crate::contacts::SavedContacts;
use crate::neighbours::Neighbours;
use crate::simulation::Simulation;
use std::ops::Range;

impl Simulation {
    /// The processes that have all together.
    pub(crate) fn together(&self) -> Together<'_> {
        self.part().together
    }

    /// What this process has of all grains and segments.
    pub(in crate::simulation) fn part(&self) -> Part<'_> {
        let divided = self.division.as_deref().filter(|division| !division.is_whole);
        divided.map_or(Part::WHOLE, |division| Part {
            together: Together::of(&*division.ranks),
            grains: division.own.clone(),
            segments: division.segments(),
        })
    }

    /// The own contacts, to be written together with those of others.
    pub(in crate::simulation) fn saved_contacts<'a>(&'a self, part: &Part<'a>) -> SavedContacts<'a> {
        let end = self.neighbours.segments();
        let segments = part.segments.start.min(end)..part.segments.end.min(end);
        let pairs = self.chunks_of(segments.clone(), Neighbours::chunks_of_segment);
        let walls = self.chunks_of(segments, Neighbours::wall_chunks_of_segment);
        SavedContacts::of(&self.contacts, [pairs, walls], part.together)
    }

    /// Chunks of contacts with walls of the own segments.
    pub(crate) fn own_wall_chunks(&self) -> Range<usize> {
        self.chunks_of(self.own_segments(), Neighbours::wall_chunks_of_segment)
    }
}
