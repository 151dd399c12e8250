//! Insides of meshes: regions that a file or a wall encloses.

use super::grains::Surroundings;
use super::meshes::size_of;
use super::reader::TableReader;
use super::walls::{WallShape, WallSpec, mesh};
use crate::particles::{Interior, InteriorError};
use crate::walls::mesh::Repair;
use crate::walls::{Mesh, Shape, read_mesh};
use glam::DVec3;
use std::sync::Arc;

/// A closed mesh as it is read: its triangles [m] and its inside.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ClosedMesh {
    pub triangles: Vec<[DVec3; 3]>,
    pub interior: Arc<Interior>,
}

/// The mesh of a region or an inlet whose unit neither the scenario nor the file tells, so that its numbers count metres.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MeshWithoutUnit {
    /// Path of its table, as `removal[0].region`.
    pub path: String,
    /// From corner to corner of the box around it [m].
    pub size: f64,
}

/// The mesh of a region: that of a file or of triangles, or that of the wall which carries the region when none is told. What
/// is wrong with it is noted.
pub(super) fn closed_mesh(
    table: &TableReader<'_>,
    wall: Option<&WallSpec>,
    around: &Surroundings<'_>,
) -> Option<ClosedMesh> {
    let is_told = table.has("file") || table.has("triangles");
    let (shape, key, weld) = match wall.filter(|_| !is_told) {
        Some(spec) if !matches!(spec.shape, WallShape::File(_) | WallShape::Given(Shape::Mesh { .. })) => {
            let message = format!("wall `{}` is no mesh, so that it has no inside", spec.name);
            let help = "name a wall of shape \"mesh\", or give `file`";
            table.fault(message, Some(help.to_string()));
            return None;
        }
        Some(spec) => (spec.shape.clone(), "wall", spec.weld),
        None => (mesh(table, around), key_of(table), None),
    };
    let (triangles, repair) = triangles(table, (shape, weld), key, around)?;
    match closed(triangles, &repair) {
        Ok(closed) => Some(closed),
        Err(message) => {
            table.fault_at(key, message);
            None
        }
    }
}

/// The inside of repaired triangles, or why they have none.
fn closed(triangles: Vec<[DVec3; 3]>, repair: &Repair) -> Result<ClosedMesh, String> {
    let inside = |triangles: &[[DVec3; 3]]| Interior::new(triangles).map(Arc::new);
    let (triangles, interior) = match inside(&triangles) {
        Err(InteriorError::Open { .. }) => {
            let mesh = Mesh::new(&triangles).map(|mesh| mesh.with_both_fronts(&repair.both_fronts));
            let closed = mesh.and_then(|mesh| mesh.closed_triangles());
            let closed = closed.map_err(|error| error.to_string())?;
            let interior = inside(&closed);
            (closed, interior)
        }
        interior => (triangles, interior),
    };
    let interior = interior.map_err(|error| error.to_string())?;
    Ok(ClosedMesh { triangles, interior })
}

/// The triangles of a mesh that need not be closed [m].
pub(super) fn open_mesh(table: &TableReader<'_>, around: &Surroundings<'_>) -> Option<Vec<[DVec3; 3]>> {
    let read = triangles(table, (mesh(table, around), None), key_of(table), around);
    read.map(|(triangles, _)| triangles)
}

/// The key that tells the triangles.
fn key_of(table: &TableReader<'_>) -> &'static str {
    if table.has("triangles") { "triangles" } else { "file" }
}

/// Triangles of the shape of a wall [m], whose corners are joined within some distance [m], and what was repaired.
fn triangles(
    table: &TableReader<'_>,
    (shape, weld): (WallShape, Option<f64>),
    key: &str,
    around: &Surroundings<'_>,
) -> Option<(Vec<[DVec3; 3]>, Repair)> {
    let mut unit_is_told = true;
    let read = match shape {
        WallShape::Given(Shape::Mesh { triangles }) if !triangles.is_empty() => Ok(triangles),
        // a scale that is not a number, or a file that is not there, was told already
        WallShape::File(file) if file.path.is_file() && !file.scale.is_some_and(f64::is_nan) => {
            read_mesh(&file.path, file.scale, file.shift)
                .map(|content| {
                    // that of a wall is told with the wall
                    unit_is_told = key == "wall" || file.scale.is_some() || content.told_unit.is_some();
                    content.triangles
                })
                .map_err(|error| error.to_string())
        }
        _ => return None,
    };
    if read.iter().flatten().flatten().any(|corner| corner.is_nan()) {
        return None;
    }
    let repaired = read.and_then(|read| Mesh::repair(&read, weld).map_err(|error| error.to_string()));
    match repaired {
        Ok((triangles, repair)) => {
            let size = size_of(triangles.iter().flatten().map(|&corner| (corner, 0.0)));
            if let Some(size) = size.filter(|_| !unit_is_told) {
                around.without_unit.borrow_mut().push(MeshWithoutUnit {
                    path: table.path.clone(),
                    size,
                });
            }
            Some((triangles, repair))
        }
        Err(message) => {
            table.fault_at(key, message);
            None
        }
    }
}
