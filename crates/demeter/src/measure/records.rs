//! Contacts and walls of a moment, as they are written.

use super::told_first::{Acting, acting};
use crate::contacts::ContactChunk;
use crate::output::{ContactRecord, FramePart, WallSurface};
use crate::simulation::Simulation;
use glam::DVec3;
use rayon::prelude::*;

/// All contacts that act ([`ContactChunk::acts`]), between grains first, in the order of the tables.
///
/// Bodies that are near, or touch without force, are left out: they would appear as contacts in pictures and counts, and
/// as many of them as the time step and the reach of the law happen to gather.
pub fn contact_records(sim: &Simulation) -> Vec<ContactRecord> {
    let contacts = &sim.contacts;
    let mut records = vec![ContactRecord::default(); contacts.acting_pairs() + contacts.acting_walls()];
    let (mut rest, mut of_chunks) = (&mut records[..], Vec::new());
    for (with_wall, chunks) in [(false, &contacts.pairs), (true, &contacts.walls)] {
        for chunk in chunks {
            let (of_chunk, others) = std::mem::take(&mut rest).split_at_mut(chunk.acting());
            of_chunks.push((chunk, with_wall, of_chunk));
            rest = others;
        }
    }
    of_chunks.into_par_iter().for_each(|(chunk, with_wall, of_chunk)| {
        for (to, contact) in of_chunk.iter_mut().zip(acting(std::slice::from_ref(chunk), with_wall)) {
            *to = record(sim, &contact);
        }
    });
    records
}

/// What this process has of a frame with these contacts.
pub(crate) fn frame_part(sim: &Simulation) -> FramePart<'_> {
    let acting = |chunks: &[ContactChunk]| chunks.iter().map(ContactChunk::acting).sum::<usize>();
    let (own, all) = (sim.own_chunks().end, &sim.contacts.pairs);
    FramePart {
        together: sim.together(),
        grains: sim.own_grains(),
        of_others: acting(&all[..own])..acting(all),
    }
}

/// The contacts of [`contact_records`], column by column.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ContactColumns {
    /// Ids of the first grains.
    pub id_i: Vec<u32>,
    /// Ids of the second grains; 0 for a wall.
    pub id_j: Vec<u32>,
    /// Indices of the walls; -1 between grains.
    pub wall: Vec<i32>,
    /// Overlaps [m].
    pub overlap: Vec<f64>,
    /// Contact points [m].
    pub position: Vec<DVec3>,
    /// Unit normals, from `j` or the wall towards `i`.
    pub normal: Vec<DVec3>,
    /// Forces on grain `i` [N].
    pub force: Vec<DVec3>,
    /// Their parts along the normal [N].
    pub normal_force: Vec<DVec3>,
    /// Their parts in the contact plane [N].
    pub tangential_force: Vec<DVec3>,
    /// Rolling torques on grain `i` [N m].
    pub rolling_torque: Vec<DVec3>,
}

impl ContactColumns {
    /// Those of a moment.
    pub fn of(sim: &Simulation) -> Self {
        let records = contact_records(sim);
        let vectors = |of: fn(&ContactRecord) -> DVec3| records.iter().map(of).collect();
        Self {
            id_i: records.iter().map(|c| c.id_i).collect(),
            id_j: records.iter().map(|c| c.id_j).collect(),
            wall: records.iter().map(|c| c.wall).collect(),
            overlap: records.iter().map(|c| c.overlap).collect(),
            position: vectors(|c| c.position),
            normal: vectors(|c| c.normal),
            force: vectors(ContactRecord::force),
            normal_force: vectors(ContactRecord::normal_force),
            tangential_force: vectors(ContactRecord::tangential_force),
            rolling_torque: vectors(ContactRecord::rolling_torque),
        }
    }
}

fn record(sim: &Simulation, acting: &Acting<'_>) -> ContactRecord {
    let &Acting {
        chunk,
        place,
        with_wall,
    } = acting;
    let contact = acting.contact(sim);
    let (i, j) = (chunk.i[place] as usize, chunk.j[place]);
    ContactRecord {
        id_i: sim.grains.id[i],
        id_j: if with_wall { 0 } else { sim.grains.id[j as usize] },
        wall: if with_wall { j as i32 } else { -1 },
        element: chunk.element(place),
        position: sim.grains.position[i] - contact.normal * contact.lever_i,
        normal: contact.normal,
        overlap: contact.overlap,
        push: chunk.normal_force(place) as f32,
        drag: chunk.tangential_force(place).as_vec3(),
        torque: chunk.rolling_torque(place).as_vec3(),
    }
}

/// All walls with what they feel; infinite ones are cut by the bounds of the grains. A periodic box that deforms, which holds no
/// walls, stands in their place.
///
/// Where processes share the run each calls this.
pub fn wall_surfaces(sim: &Simulation) -> Vec<WallSurface<'_>> {
    let (mut lower, mut upper) = super::all_bounds(sim);
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
