//! Sum per grain over its contacts, in the order of the partner's id.

use super::{CHUNK, Contacts};
use crate::neighbours::Neighbours;
use glam::DVec3;

/// Force [N] and torque [N m] of all contacts on one grain.
#[inline]
pub fn contact_load(grain: usize, neighbours: &Neighbours, contacts: &Contacts) -> (DVec3, DVec3) {
    let (mut force, mut torque) = (DVec3::ZERO, DVec3::ZERO);
    for (pair, first) in neighbours.pairs_of(grain) {
        let chunk = &contacts.pairs[pair / CHUNK];
        for k in chunk.contacts_of(pair % CHUNK) {
            if first {
                force += chunk.force[k];
                torque += chunk.torque_i[k];
            } else {
                force -= chunk.force[k];
                torque += chunk.torque_j[k];
            }
        }
    }
    for pair in neighbours.wall_pairs_of(grain) {
        let chunk = &contacts.walls[pair / CHUNK];
        for k in chunk.contacts_of(pair % CHUNK) {
            force += chunk.force[k];
            torque += chunk.torque_i[k];
        }
    }
    (force, torque)
}
