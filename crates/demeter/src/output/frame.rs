//! What is written of one moment.

use crate::materials::Material;
use crate::particles::Grains;
use crate::walls::ElementRecord;
use glam::DVec3;

/// A contact as it is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactRecord {
    /// Id of the first grain.
    pub id_i: u32,
    /// Id of the second grain; 0 for a wall.
    pub id_j: u32,
    /// Index of the wall; -1 between grains.
    pub wall: i32,
    /// Which element of the wall is touched (triangle, edge or corner of a mesh, face of a box); 0 otherwise.
    pub element: u32,
    /// Contact point [m].
    pub position: DVec3,
    /// Unit normal, from `j` or the wall towards `i`.
    pub normal: DVec3,
    /// Overlap [m].
    pub overlap: f64,
    /// Normal force on grain `i` [N].
    pub normal_force: DVec3,
    /// Tangential force on grain `i` [N].
    pub tangential_force: DVec3,
    /// Rolling torque on grain `i` [N m].
    pub rolling_torque: DVec3,
}

/// A wall as it is written and drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct WallSurface<'a> {
    /// Name in the scenario.
    pub name: &'a str,
    /// Its surface where it stands now, as triangles [m].
    pub triangles: Vec<[DVec3; 3]>,
    /// Force of the grains on it [N].
    pub force: DVec3,
    /// Torque of the grains on it about the origin of its pose [N m].
    pub torque: DVec3,
    /// Velocity of its origin [m/s].
    pub velocity: DVec3,
    /// What was recorded on the element that every triangle draws; `None` where nothing is recorded.
    pub records: Option<Vec<ElementRecord>>,
}

/// The domain of a run at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameBox {
    /// Lower corner [m].
    pub corner: DVec3,
    /// What leads from the corner along its sides; across a periodic side, from a grain to its image [m].
    pub edges: [DVec3; 3],
    /// Which directions are periodic.
    pub periodic: [bool; 3],
}

/// One moment of a run.
#[derive(Clone, Debug)]
pub struct Frame<'a> {
    /// Steps done.
    pub step: u64,
    /// Simulated time [s].
    pub time: f64,
    /// All grains.
    pub grains: &'a Grains,
    /// Materials, by index.
    pub materials: &'a [Material],
    /// All contacts that act.
    pub contacts: &'a [ContactRecord],
    /// All walls.
    pub walls: &'a [WallSurface<'a>],
    /// Tags of the grains, by index; nothing where none has a tag.
    pub tags: Option<Vec<i32>>,
    /// The domain, where one is told.
    pub cell: Option<FrameBox>,
}

impl Frame<'_> {
    /// Sum over the contacts of every grain, walls counted: `add(sum, contact)` is called for both partners, in the
    /// order of the contacts.
    pub fn sum_over_contacts<T: Copy>(&self, start: T, add: impl Fn(T, &ContactRecord) -> T) -> Vec<T> {
        let mut by_id: Vec<(u32, usize)> = self.grains.id.iter().copied().zip(0..).collect();
        by_id.sort_unstable();
        let index = |id: u32| by_id.binary_search_by_key(&id, |&(id, _)| id).ok().map(|k| by_id[k].1);
        let mut sums = vec![start; self.grains.len()];
        for contact in self.contacts {
            let partners = [Some(contact.id_i), (contact.wall < 0).then_some(contact.id_j)];
            for at in partners.into_iter().flatten().filter_map(index) {
                sums[at] = add(sums[at], contact);
            }
        }
        sums
    }
}
