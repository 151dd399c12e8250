//! Sum per grain over its contacts, in the order of the partner's id.

use super::Contacts;
use crate::neighbours::Neighbours;
use glam::DVec3;

/// Force [N] and torque [N m] of all contacts on one grain.
#[inline]
pub fn contact_load(grain: usize, neighbours: &Neighbours, contacts: &Contacts) -> (DVec3, DVec3) {
    let (mut force, mut torque) = (DVec3::ZERO, DVec3::ZERO);
    for (chunk, slot, first) in neighbours.pairs_of(grain) {
        let chunk = &contacts.pairs[chunk];
        for k in chunk.contacts_of(slot) {
            if first {
                force += chunk.force[k];
                torque += chunk.torque_i[k];
            } else {
                force -= chunk.force[k];
                torque += chunk.torque_j[k];
            }
        }
    }
    for (chunk, slot) in neighbours.wall_pairs_of(grain) {
        let chunk = &contacts.walls[chunk];
        for k in chunk.contacts_of(slot) {
            force += chunk.force[k];
            torque += chunk.torque_i[k];
        }
    }
    (force, torque)
}
