//! Contacts told by the ids of the grains, whatever their order in memory.

use super::coupling::Coupled;
use super::{ContactChunk, Contacts};
use crate::particles::Grains;
use demeter_physics::geometry::contact_sphere_sphere::Contact;
use glam::DVec3;
use serde::Serialize;

/// What a contact is, whatever the order of the grains: lower id, partner's id (or index of the wall), element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
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

/// What is known of a contact after a step.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CarriedContact {
    /// Identity.
    pub key: ContactKey,
    /// Geometry, where it is not found from the places of the grains again.
    pub geometry: Option<Contact>,
    /// Whether it is engaged, and not merely near.
    pub is_engaged: bool,
    /// Normal force [N].
    pub normal_force: f64,
    /// Force on the first body in the contact plane [N].
    pub tangential: DVec3,
    /// Torque of the rolling law on the first body [N m].
    pub rolling: Option<DVec3>,
    /// History of its laws.
    pub history: Vec<f64>,
    /// What it remembers of the displacements by the other contacts, where contacts feel each other.
    pub coupling: Option<Coupled>,
}

impl Contacts {
    /// All contacts, by rising keys.
    pub fn carry(&self, grains: &Grains) -> Vec<CarriedContact> {
        let of = |wall: bool, chunk: &ContactChunk, k: usize| CarriedContact {
            key: ContactKey {
                wall,
                grain: grains.id[chunk.i[k] as usize],
                partner: if wall {
                    chunk.j[k]
                } else {
                    grains.id[chunk.j[k] as usize]
                },
                element: chunk.element(k),
            },
            geometry: chunk.now.geometry.get(k).copied(),
            is_engaged: chunk.is_engaged(k),
            normal_force: chunk.normal_force(k),
            tangential: chunk.tangential_force(k),
            rolling: (!chunk.rolling.is_empty()).then(|| chunk.rolling_torque(k)),
            history: chunk.history(k, self.stride).to_vec(),
            coupling: chunk.now.coupling.get(k).copied(),
        };
        let mut all = Vec::new();
        for (wall, chunks) in [(false, &self.pairs), (true, &self.walls)] {
            for chunk in chunks {
                all.extend((0..chunk.len()).map(|k| of(wall, chunk, k)));
            }
        }
        all.sort_unstable_by_key(|contact| contact.key);
        all
    }
}
