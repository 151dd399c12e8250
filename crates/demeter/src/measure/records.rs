//! Contacts and walls of a moment, as they are written.

use super::contacts_at::{ContactAt, ContactsAt};
use crate::output::WallSurface;
use crate::simulation::Simulation;
use crate::walls::{ElementRecord, Wall};
use glam::DVec3;

/// The contacts of [`ContactsAt`], column by column.
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
    pub fn of<'a>(sim: &'a Simulation) -> Self {
        let contacts = || ContactsAt::State(sim).all();
        let vectors = |of: fn(ContactAt<'a>) -> DVec3| contacts().map(of).collect();
        Self {
            id_i: contacts().map(ContactAt::id_i).collect(),
            id_j: contacts().map(ContactAt::id_j).collect(),
            wall: contacts().map(ContactAt::wall).collect(),
            overlap: contacts().map(ContactAt::overlap).collect(),
            position: vectors(ContactAt::position),
            normal: vectors(ContactAt::normal),
            force: vectors(ContactAt::force),
            normal_force: vectors(ContactAt::normal_force),
            tangential_force: vectors(ContactAt::tangential_force),
            rolling_torque: vectors(ContactAt::rolling_torque),
        }
    }
}

/// All walls with what they feel; infinite ones are cut by the bounds of the grains. A periodic box that deforms, which holds no
/// walls, stands in their place.
///
/// Where processes share the run each calls this.
pub fn wall_surfaces(sim: &Simulation) -> Vec<WallSurface<'_>> {
    let (mut lower, mut upper) = super::bounds_of(sim, |_| true);
    if sim.grains.is_empty() {
        (lower, upper) = (DVec3::ZERO, DVec3::ZERO);
    }
    let walls = (sim.walls.iter()).map(|wall| {
        let (force, torque) = wall.load();
        let triangles = wall.triangles(lower, upper);
        let records = wall.element_records();
        let of_triangles = || shared_out(&triangles, &wall.elements_drawn(triangles.len()), &records);
        WallSurface {
            name: &wall.name,
            records: wall.is_recorded().then(of_triangles),
            velocities: triangles.iter().map(|corners| velocity_of(wall, corners)).collect(),
            triangles,
            force,
            torque,
        }
    });
    walls.chain(sim.deforms().then(|| box_surface(sim))).collect()
}

/// Velocity of the surface of a wall in the middle of a triangle of it [m/s].
fn velocity_of(wall: &Wall, [a, b, c]: &[DVec3; 3]) -> DVec3 {
    let normal = (*b - *a).cross(*c - *a).normalize_or_zero();
    let belt = wall.belt();
    wall.velocity_at((*a + *b + *c) / 3.0) + belt - normal * belt.dot(normal)
}

/// What was recorded on elements, shared out over the triangles that draw each by their areas, so that what adds up over a wall does.
fn shared_out(triangles: &[[DVec3; 3]], elements: &[usize], records: &[ElementRecord]) -> Vec<ElementRecord> {
    let area = |[a, b, c]: &[DVec3; 3]| (*b - *a).cross(*c - *a).length();
    let mut whole = vec![0.0; records.len()];
    for (triangle, &element) in triangles.iter().zip(elements) {
        if let Some(whole) = whole.get_mut(element) {
            *whole += area(triangle);
        }
    }
    let drawn = triangles.iter().zip(elements);
    drawn
        .filter_map(|(triangle, &element)| {
            let record = records.get(element)?;
            let part = area(triangle);
            // one that is drawn by a single triangle keeps its bits
            let share = if part == whole[element] {
                1.0
            } else {
                part / whole[element]
            };
            Some(record.shared(share))
        })
        .collect()
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
    let velocities = vec![DVec3::ZERO; triangles.len()];
    WallSurface {
        name: "periodic box",
        records: None,
        triangles,
        force: DVec3::ZERO,
        torque: DVec3::ZERO,
        velocities,
    }
}
