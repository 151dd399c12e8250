//! Force chains: contacts as lines between the bodies that they join.

use super::{Selection, holds};
use crate::contacts::ContactChunk;
use crate::particles::{Origins, Zone};
use crate::simulation::Simulation;
use glam::DVec3;

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

impl ForceChains {
    /// The lines of the present state, in the order of the tables, those between grains first.
    pub fn measure(&self, sim: &Simulation, origins: &Origins) -> Vec<ChainLink> {
        let counts: Vec<bool> = (0..sim.grains.len())
            .map(|g| holds(sim, &self.zone, g) && self.selection.holds(&sim.grains, origins, g))
            .collect();
        let mut links = Vec::new();
        for chunk in &sim.contacts.pairs {
            let counts = |k: usize| counts[chunk.i[k] as usize] || counts[chunk.j[k] as usize];
            self.add(sim, chunk, false, counts, &mut links);
        }
        for chunk in &sim.contacts.walls {
            self.add(sim, chunk, true, |k| counts[chunk.i[k] as usize], &mut links);
        }
        let mean = links.iter().map(|link| link.normal_force).sum::<f64>() / links.len() as f64;
        for link in &mut links {
            link.is_strong = link.normal_force > mean;
        }
        links.retain(|link| link.is_strong || !self.strong_only);
        links
    }

    fn add(
        &self,
        sim: &Simulation,
        chunk: &ContactChunk,
        is_wall: bool,
        counts: impl Fn(usize) -> bool,
        links: &mut Vec<ChainLink>,
    ) {
        let strong = |k: &usize| chunk.acts(*k) && chunk.normal_force()[*k].abs() >= self.threshold;
        for k in (0..chunk.len()).filter(strong).filter(|&k| counts(k)) {
            let contact = sim.contact(chunk, k);
            let (i, j) = (chunk.i[k] as usize, chunk.j[k]);
            let from = sim.grains.position[i];
            let length = contact.lever_i + if is_wall { 0.0 } else { contact.lever_j };
            links.push(ChainLink {
                from,
                to: from - contact.normal * length,
                ids: [sim.grains.id[i], if is_wall { 0 } else { sim.grains.id[j as usize] }],
                wall: if is_wall { j as i32 } else { -1 },
                force: chunk.force(k, contact.normal),
                normal_force: chunk.normal_force()[k],
                is_strong: false,
            });
        }
    }
}
