//! Handing contacts over when the candidates are found anew, and to and from a checkpoint.

use super::coupling::Coupled;
use super::{CHUNK, ContactChunk, Contacts, Load};
use crate::neighbours::Neighbours;
use crate::particles::Grains;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What a contact is, whatever the order of the grains: lower id, partner's id (or index of the wall), element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct ContactKey {
    /// Whether the partner is a wall.
    pub wall: bool,
    /// Id of the first grain.
    pub grain: u32,
    /// Id of the second grain, or index of the wall.
    pub partner: u32,
    /// Element of the wall.
    pub element: u32,
}

/// A contact as it is handed over.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CarriedContact {
    /// Identity.
    pub key: ContactKey,
    /// Material pair.
    pub pair: u32,
    /// Geometry.
    pub geometry: Contact,
    /// Normal force [N].
    pub normal_force: f64,
    /// What it does to both bodies.
    pub load: Load,
    /// Torque of the rolling law on the first body [N m].
    pub rolling: DVec3,
    /// History of its laws.
    pub history: Vec<f64>,
    /// What it remembers of the displacements by the other contacts, where contacts feel each other.
    pub coupling: Option<Coupled>,
}

impl Contacts {
    /// All contacts, sorted by their keys.
    pub fn carry(&self, grains: &Grains) -> Vec<CarriedContact> {
        let mut carried = Vec::with_capacity(self.pair_count() + self.wall_count());
        for (wall, chunks) in [(false, &self.pairs), (true, &self.walls)] {
            for chunk in chunks {
                for k in 0..chunk.len() {
                    let partner = if wall {
                        chunk.j[k]
                    } else {
                        grains.id[chunk.j[k] as usize]
                    };
                    let grain = grains.id[chunk.i[k] as usize];
                    carried.push(CarriedContact {
                        key: ContactKey {
                            wall,
                            grain,
                            partner,
                            element: chunk.now.element[k],
                        },
                        pair: chunk.now.pair[k],
                        geometry: chunk.now.geometry[k],
                        normal_force: chunk.now.normal_force[k],
                        load: chunk.load[k],
                        rolling: chunk.rolling_torque(k),
                        history: chunk.history(k, self.stride).to_vec(),
                        coupling: chunk.now.coupling.get(k).copied(),
                    });
                }
            }
        }
        carried.sort_unstable_by_key(|c| c.key);
        carried
    }

    /// Makes chunks for new candidates with the carried contacts, as if a step had just ended with them: all that can be
    /// asked of a contact after a step can be asked now. `carried` is sorted by its keys.
    pub fn adopt(&mut self, grains: &Grains, neighbours: &Neighbours, carried: &[CarriedContact]) {
        let stride = self.stride;
        refill(&mut self.pairs, neighbours.pairs.len(), |c, chunk| {
            let p = neighbours.pairs[c];
            let key = ContactKey {
                wall: false,
                grain: grains.id[p.i as usize],
                partner: grains.id[p.j as usize],
                element: 0,
            };
            remember(carried, key, (p.i, p.j), stride, chunk);
        });
        refill(&mut self.walls, neighbours.wall_pairs.len(), |c, chunk| {
            let p = neighbours.wall_pairs[c];
            let key = ContactKey {
                wall: true,
                grain: grains.id[p.grain as usize],
                partner: p.wall,
                element: 0,
            };
            remember(carried, key, (p.grain, p.wall), stride, chunk);
        });
    }
}

/// Fills chunks for new candidates; they keep the memory that they have.
fn refill(chunks: &mut Vec<ContactChunk>, candidates: usize, fill: impl Fn(usize, &mut ContactChunk)) {
    chunks.resize_with(candidates.div_ceil(CHUNK), ContactChunk::default);
    for (number, chunk) in chunks.iter_mut().enumerate() {
        chunk.forget();
        for c in number * CHUNK..((number + 1) * CHUNK).min(candidates) {
            fill(c, chunk);
            chunk.now.start.push(chunk.now.len() as u32);
            let within = (c - number * CHUNK) as u32;
            let contacts = chunk.now.len();
            chunk.now.candidate.resize(contacts, within);
        }
    }
}

/// Appends the carried contacts of a grain and a partner, from `first` on, whatever their elements.
fn remember(
    carried: &[CarriedContact],
    first: ContactKey,
    (i, j): (u32, u32),
    stride: usize,
    chunk: &mut ContactChunk,
) {
    let start = carried.partition_point(|c| c.key < first);
    let same =
        |c: &&CarriedContact| c.key.wall == first.wall && c.key.grain == first.grain && c.key.partner == first.partner;
    for c in carried[start..].iter().take_while(same) {
        chunk.i.push(i);
        chunk.j.push(j);
        chunk.load.push(c.load);
        chunk.rolling.push(c.rolling);
        let kept = &mut chunk.now;
        kept.element.push(c.key.element);
        kept.pair.push(c.pair);
        kept.geometry.push(c.geometry);
        kept.normal_force.push(c.normal_force);
        kept.history
            .extend(c.history.iter().copied().chain(std::iter::repeat(0.0)).take(stride));
        kept.coupling.extend(c.coupling);
    }
}
