//! Contacts and walls of a moment, as they are written.

use crate::contacts::ContactChunk;
use crate::output::{ContactRecord, WallSurface};
use crate::simulation::Simulation;
use glam::DVec3;

/// All contacts that act ([`ContactChunk::acts`]), between grains first, in the order of the tables.
///
/// Bodies that are near, or touch without force, are left out: they would appear as contacts in pictures and counts, and
/// as many of them as the time step and the reach of the law happen to gather.
pub fn contact_records(sim: &Simulation) -> Vec<ContactRecord> {
    let mut records = Vec::with_capacity(sim.contacts.acting_pairs() + sim.contacts.acting_walls());
    for (wall, chunks) in [(false, &sim.contacts.pairs), (true, &sim.contacts.walls)] {
        for chunk in chunks {
            let acting = (0..chunk.len()).filter(|&k| chunk.acts(k));
            records.extend(acting.map(|k| record(sim, chunk, k, wall)));
        }
    }
    records
}

fn record(sim: &Simulation, chunk: &ContactChunk, k: usize, wall: bool) -> ContactRecord {
    let contact = sim.contact(chunk, k);
    let i = chunk.i[k] as usize;
    let normal_force = contact.normal * chunk.normal_force()[k];
    ContactRecord {
        id_i: sim.grains.id[i],
        id_j: if wall { 0 } else { sim.grains.id[chunk.j[k] as usize] },
        wall: if wall { chunk.j[k] as i32 } else { -1 },
        element: chunk.element(k),
        position: sim.grains.position[i] - contact.normal * contact.lever_i,
        normal: contact.normal,
        overlap: contact.overlap,
        normal_force,
        tangential_force: chunk.tangential_force(k),
        rolling_torque: chunk.rolling_torque(k),
    }
}

/// All walls with what they feel; infinite ones are cut by the bounds of the grains. A periodic box that deforms, which holds no
/// walls, stands in their place.
pub fn wall_surfaces(sim: &Simulation) -> Vec<WallSurface<'_>> {
    let (mut lower, mut upper) = super::bounds(&sim.grains);
    if sim.grains.is_empty() {
        (lower, upper) = (DVec3::ZERO, DVec3::ZERO);
    }
    let walls = (sim.walls.iter()).map(|wall| {
        let (force, torque) = wall.load();
        let velocity = wall.velocity_at(wall.origin());
        let triangles = wall.triangles(lower, upper);
        let records = wall.element_records();
        let of_triangles = || {
            let elements = wall.elements_drawn(triangles.len());
            elements.iter().filter_map(|e| records.get(*e).copied()).collect()
        };
        WallSurface {
            name: &wall.name,
            records: wall.is_recorded().then(of_triangles),
            triangles,
            force,
            torque,
            velocity,
        }
    });
    walls.chain(sim.deforms().then(|| box_surface(sim))).collect()
}

/// The sides of a periodic box.
fn box_surface(sim: &Simulation) -> WallSurface<'_> {
    let (lower, size) = (sim.domain().lower, sim.domain().size());
    let mut triangles = Vec::new();
    for axis in (0..3).filter(|&k| sim.domain().periodic[k]) {
        let edge = |k: usize| DVec3::AXES[k] * size[k];
        let (u, v) = (edge((axis + 1) % 3), edge((axis + 2) % 3));
        for corner in [lower, lower + edge(axis)] {
            triangles.push([corner, corner + u, corner + u + v]);
            triangles.push([corner, corner + u + v, corner + v]);
        }
    }
    WallSurface {
        name: "periodic box",
        records: None,
        triangles,
        force: DVec3::ZERO,
        torque: DVec3::ZERO,
        velocity: DVec3::ZERO,
    }
}
