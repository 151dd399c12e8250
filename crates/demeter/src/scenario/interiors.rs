//! Insides of meshes: regions that a file or a wall encloses.

use super::reader::TableReader;
use super::walls::{WallShape, mesh};
use super::zones::Named;
use crate::particles::Interior;
use crate::walls::{Mesh, Shape, read_mesh};
use glam::DVec3;
use std::sync::Arc;

/// A closed mesh as it is read: its triangles [m] and its inside.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ClosedMesh {
    pub triangles: Vec<[DVec3; 3]>,
    pub interior: Arc<Interior>,
}

/// The mesh of a region: that of a file or of triangles, or that of the wall which carries the region when none is told. What
/// is wrong with it is noted.
pub(super) fn closed_mesh(table: &TableReader<'_>, wall: Option<usize>, named: &Named<'_>) -> Option<ClosedMesh> {
    let is_told = table.has("file") || table.has("triangles");
    let shape = match wall.filter(|_| !is_told) {
        Some(wall) => {
            let spec = named.walls.get(wall)?;
            if !matches!(spec.shape, WallShape::File(_) | WallShape::Given(Shape::Mesh { .. })) {
                let help = "name a wall of shape \"mesh\", or give `file`";
                table.fault(
                    format!("wall `{}` is no mesh, so that it has no inside", spec.name),
                    Some(help.to_string()),
                );
                return None;
            }
            spec.shape.clone()
        }
        None => mesh(table, named.around),
    };
    let key = if table.has("triangles") { "triangles" } else { "file" };
    let key = if is_told { key } else { "wall" };
    let triangles = match shape {
        WallShape::Given(Shape::Mesh { triangles }) if !triangles.is_empty() => triangles,
        // a scale that is not a number, or a file that is not there, was told already
        WallShape::File(file) if file.path.is_file() && !file.scale.is_some_and(f64::is_nan) => {
            match read_mesh(&file.path, file.scale, file.shift) {
                Ok(content) => content.triangles,
                Err(error) => {
                    table.fault_at(key, error.to_string());
                    return None;
                }
            }
        }
        _ => return None,
    };
    if triangles.iter().flatten().any(|corner| corner.is_nan()) {
        return None;
    }
    let repaired = Mesh::repair(&triangles, None).map_err(|error| error.to_string());
    let closed = repaired.and_then(|(triangles, _)| match Interior::new(&triangles) {
        Ok(interior) => Ok(ClosedMesh {
            triangles,
            interior: Arc::new(interior),
        }),
        Err(error) => Err(error.to_string()),
    });
    match closed {
        Ok(mesh) => Some(mesh),
        Err(message) => {
            table.fault_at(key, message);
            None
        }
    }
}
