//! Contacts and walls of a moment, as they are written.

use crate::contacts::ContactChunk;
use crate::output::{ContactRecord, WallSurface};
use crate::simulation::Simulation;
use glam::DVec3;

/// All contacts, between grains first, in the order of the tables.
pub fn contact_records(sim: &Simulation) -> Vec<ContactRecord> {
    let mut records = Vec::with_capacity(sim.contacts.pair_count() + sim.contacts.wall_count());
    for (wall, chunks) in [(false, &sim.contacts.pairs), (true, &sim.contacts.walls)] {
        for chunk in chunks {
            records.extend((0..chunk.len()).map(|k| record(sim, chunk, k, wall)));
        }
    }
    records
}

fn record(sim: &Simulation, chunk: &ContactChunk, k: usize, wall: bool) -> ContactRecord {
    let contact = &chunk.geometry()[k];
    let i = chunk.i[k] as usize;
    let normal_force = contact.normal * chunk.normal_force()[k];
    let tangential_force = chunk.force[k] - normal_force;
    ContactRecord {
        id_i: sim.grains.id[i],
        id_j: if wall { 0 } else { sim.grains.id[chunk.j[k] as usize] },
        wall: if wall { chunk.j[k] as i32 } else { -1 },
        element: chunk.element()[k],
        position: sim.grains.position[i] - contact.normal * contact.lever_i,
        normal: contact.normal,
        overlap: contact.overlap,
        normal_force,
        tangential_force,
        rolling_torque: chunk.torque_i[k] + contact.normal.cross(tangential_force) * contact.lever_i,
    }
}

/// All walls with what they feel; infinite ones are cut by the bounds of the grains.
pub fn wall_surfaces(sim: &Simulation) -> Vec<WallSurface<'_>> {
    let (mut lower, mut upper) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for (&p, &r) in sim.grains.position.iter().zip(&sim.grains.radius) {
        lower = lower.min(p - r);
        upper = upper.max(p + r);
    }
    if sim.grains.is_empty() {
        (lower, upper) = (DVec3::ZERO, DVec3::ZERO);
    }
    (sim.walls.iter())
        .map(|wall| {
            let (force, torque) = wall.load();
            let velocity = wall.velocity_at(wall.origin());
            WallSurface {
                name: &wall.name,
                triangles: wall.triangles(lower, upper),
                force,
                torque,
                velocity,
            }
        })
        .collect()
}
