//! What is in a mesh file.

use super::Info;
use crate::answer::Rows;
use crate::failure::Failure;
use crate::readable::{count, number, vector};
use demeter::walls::{Mesh, MeshError, read_mesh};
use demeter_physics::DVec3;
use serde_json::json;
use std::path::Path;

/// Tells what is in a mesh file, in the unit of the file.
pub fn surface(path: &Path) -> Result<Info, Failure> {
    let content = read_mesh(path, Some(1.0), DVec3::ZERO).map_err(|error| Failure::wrong(error.to_string()))?;
    let triangles = content.triangles;
    let area: f64 = triangles
        .iter()
        .map(|[a, b, c]| 0.5 * (*b - *a).cross(*c - *a).length())
        .sum();
    let corners = || triangles.iter().flatten();
    let lower = corners().fold(DVec3::INFINITY, |low, corner| low.min(*corner));
    let upper = corners().fold(DVec3::NEG_INFINITY, |high, corner| high.max(*corner));
    let state = state(&triangles);
    let mut rows = Rows::default();
    rows.add("format", content.format.name());
    rows.add("triangles", count(triangles.len() as u64));
    rows.add("lower corner", vector(lower.to_array()));
    rows.add("upper corner", vector(upper.to_array()));
    rows.add("area", number(area));
    rows.add("as a wall", state.words.as_str());
    rows.add(
        "unit",
        "that of the file; `unit` of a wall tells it, as `unit = \"mm\"`",
    );
    let value = json!({
        "format": content.format.name(),
        "triangles": triangles.len(),
        "lower": lower.to_array(),
        "upper": upper.to_array(),
        "area": area,
        "closed": state.closed,
        "open_edges": state.open_edges,
        "usable": state.usable,
        "remark": state.words,
    });
    Ok(Info {
        kind: "surface",
        rows,
        value,
    })
}

struct State {
    usable: bool,
    closed: bool,
    open_edges: usize,
    words: String,
}

/// Whether the surface can be a wall, and whether it has holes.
fn state(triangles: &[[DVec3; 3]]) -> State {
    let (usable, found) = match Mesh::new(triangles) {
        Ok(mesh) => (true, mesh.require_closed()),
        Err(error) => (false, Err(error)),
    };
    let open_edges = match &found {
        Err(MeshError::Open { count, .. }) => *count,
        _ => 0,
    };
    let words = match &found {
        Ok(()) => "closed, without holes".to_string(),
        Err(error) if usable => format!("open: {error}"),
        Err(error) => format!("not usable: {error}"),
    };
    State {
        usable,
        closed: found.is_ok(),
        open_edges,
        words,
    }
}
