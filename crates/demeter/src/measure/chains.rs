//! Force chains: contacts as lines between the bodies that they join.

use super::Selection;
use super::told_first::{Acting, counting, own_pairs, own_with_walls};
use crate::comm::together::Together;
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use glam::DVec3;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Which contacts are written as lines.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ForceChains {
    /// Contacts of grains whose centres lie here.
    pub zone: Zone,
    /// Contacts of these grains.
    pub selection: Selection,
    /// Contacts with a normal force of smaller magnitude are left out [N].
    pub threshold: f64,
    /// Whether only those are written that carry more than the mean normal force.
    pub strong_only: bool,
}

/// A contact as a line. It begins at the centre of the first grain, and ends at that of the second, where that is seen from the
/// first across periodic sides, or at the contact point on a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainLink {
    /// Where it begins [m].
    pub from: DVec3,
    /// Where it ends [m].
    pub to: DVec3,
    /// Id of the first grain, and of the second; 0 for a wall.
    pub ids: [u32; 2],
    /// Index of the wall; -1 between grains.
    pub wall: i32,
    /// Force on the first grain [N].
    pub force: DVec3,
    /// Its component along the normal, repulsion positive [N].
    pub normal_force: f64,
    /// Whether it carries more than the mean normal force of the contacts that count.
    pub is_strong: bool,
}

/// The lines of a moment.
#[derive(Clone, Debug)]
pub struct ChainLinks<'a> {
    /// Those between grains, in the order of the tables; of several processes its own.
    pairs: Vec<ChainLink>,
    /// Those with walls.
    with_walls: Vec<ChainLink>,
    together: Together<'a>,
}

impl ChainLinks<'_> {
    /// The lines, those between grains first; of several processes the own.
    pub fn iter(&self) -> impl Iterator<Item = &ChainLink> {
        self.pairs.iter().chain(&self.with_walls)
    }

    /// How many all processes have; each calls this.
    pub(crate) fn count(&self) -> usize {
        self.together.count(self.pairs.len() + self.with_walls.len())
    }

    /// What all have, those between grains first: for the first process, that is, and for others what they tell it.
    pub(crate) fn each<'b, T>(&'b self, of: impl Fn(&ChainLink) -> T + Copy + 'b) -> impl Iterator<Item = T> + 'b
    where
        T: Serialize + DeserializeOwned + 'b,
    {
        let pairs = self.together.joined(self.pairs.iter().map(of));
        pairs.chain(self.together.joined(self.with_walls.iter().map(of)))
    }
}

impl ForceChains {
    /// The lines of the present state, in the order of the tables, those between grains first. Where processes share the run each calls
    /// this, and has its own.
    pub fn measure<'a>(&self, sim: &'a Simulation, origins: &Origins) -> ChainLinks<'a> {
        let counts = counting(sim, &self.zone, &self.selection, origins);
        let counts = |contact: &Acting<'_>| {
            contact.normal_force().abs() >= self.threshold && contact.grains().into_iter().flatten().any(|g| counts[g])
        };
        let mut links = ChainLinks {
            pairs: own_pairs(sim)
                .filter(counts)
                .map(|contact| link(sim, contact))
                .collect(),
            with_walls: own_with_walls(sim)
                .filter(counts)
                .map(|contact| link(sim, contact))
                .collect(),
            together: sim.together(),
        };
        let sum: f64 = links.each(|link| link.normal_force).sum();
        let mean = links.together.told_by_first(&[sum / links.count() as f64]);
        for own in [&mut links.pairs, &mut links.with_walls] {
            own.iter_mut()
                .for_each(|link| link.is_strong = mean.iter().all(|mean| link.normal_force > *mean));
            own.retain(|link| link.is_strong || !self.strong_only);
        }
        links
    }
}

fn link(sim: &Simulation, acting: Acting<'_>) -> ChainLink {
    let (chunk, k) = (acting.chunk, acting.place);
    let contact = acting.contact(sim);
    let (i, j) = (chunk.i[k] as usize, chunk.j[k]);
    let from = sim.grains.position[i];
    let length = contact.lever_i + if acting.with_wall { 0.0 } else { contact.lever_j };
    ChainLink {
        from,
        to: from - contact.normal * length,
        ids: [
            sim.grains.id[i],
            if acting.with_wall { 0 } else { sim.grains.id[j as usize] },
        ],
        wall: if acting.with_wall { j as i32 } else { -1 },
        force: chunk.force(k, contact.normal),
        normal_force: acting.normal_force(),
        is_strong: false,
    }
}
