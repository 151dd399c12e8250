//! Elements of a surface: triangles of a mesh, faces of a box, or the whole of any other shape.

use super::surface::Surface;
use demeter_physics::geometry::contact_sphere_triangle::Triangle;
use glam::DVec3;
use std::f64::consts::PI;

/// Number of faces of a box, the open ones counted.
pub(super) const FACES: usize = 6;

/// Number of elements.
pub(super) fn count(surface: &Surface) -> usize {
    match surface {
        Surface::Mesh(mesh) => mesh.triangles().len(),
        Surface::Box { .. } => FACES,
        _ => 1,
    }
}

/// The element that a contact with a key is on, at a point of the surface in the wall frame.
pub(super) fn at(surface: &Surface, key: u32, point: DVec3, reach: f64) -> u32 {
    match surface {
        Surface::Mesh(mesh) => mesh
            .closest_triangle(point, reach)
            .map_or(0, |triangle| mesh.original(triangle)),
        Surface::Images(one, _) if matches!(**one, Surface::Box { .. }) => key % FACES as u32,
        Surface::Box { .. } => key,
        _ => 0,
    }
}

/// Area of an element [m^2]; of an infinite plane infinite. A plate has that of one side.
pub(super) fn area(surface: &Surface, element: usize) -> f64 {
    match surface {
        Surface::Plane(_) => f64::INFINITY,
        Surface::Box { lower, upper, .. } => {
            let size = *upper - *lower;
            let axis = element / 2;
            size[(axis + 1) % 3] * size[(axis + 2) % 3]
        }
        Surface::Cylinder(c) => 2.0 * PI * c.radius * c.length,
        Surface::Cone(c) => {
            let rise = c.end_radius - c.start_radius;
            PI * (c.start_radius + c.end_radius) * (rise * rise + c.length * c.length).sqrt()
        }
        Surface::Shell(s) => 4.0 * PI * s.radius * s.radius,
        Surface::Rectangle(r) => 4.0 * r.half[0] * r.half[1],
        Surface::Disc(d) => PI * d.radius * d.radius,
        Surface::Images(one, _) => area(one, element),
        Surface::Mesh(mesh) => mesh.triangles().get(element).map_or(f64::INFINITY, area_of),
    }
}

fn area_of(triangle: &Triangle) -> f64 {
    let [a, b, c] = triangle.corners();
    0.5 * (b - a).cross(c - a).length()
}

/// The element of every triangle that draws the surface; `drawn`: their number.
pub(super) fn drawn(surface: &Surface, drawn: usize) -> Vec<usize> {
    match surface {
        Surface::Mesh(_) => (0..drawn).collect(),
        // two triangles for each face
        Surface::Box { faces, .. } => faces.iter().flat_map(|(face, _)| [*face as usize; 2]).collect(),
        _ => vec![0; drawn],
    }
}
