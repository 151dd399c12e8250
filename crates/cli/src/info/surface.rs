//! What is in a mesh file.

use super::Info;
use crate::answer::Rows;
use crate::failure::Failure;
use crate::readable::{count, number, vector};
use demeter::walls::{Mesh, MeshError, read_mesh};
use demeter_physics::DVec3;
use serde_json::json;
use std::path::Path;

/// Whether a text begins as a list of triangles does: with nine numbers in its first line, or in its second below titles of which none is `x`,
/// the one that a table of grains needs.
pub fn looks_like_list(start: &[u8]) -> bool {
    let text = String::from_utf8_lossy(start).to_lowercase();
    let words = |line: &str| -> Vec<String> {
        let between = |c: char| c.is_whitespace() || matches!(c, ',' | ';' | '"' | '#');
        line.split(between)
            .filter(|word| !word.is_empty())
            .map(str::to_owned)
            .collect()
    };
    let mut lines = text.lines().map(words);
    let first = lines.next().unwrap_or_default();
    let is_triangle = |words: &[String]| words.len() == 9 && words.iter().all(|word| word.parse::<f64>().is_ok());
    let mut is_below = || lines.next().is_some_and(|second| is_triangle(&second));
    is_triangle(&first) || (!first.contains(&"x".to_owned()) && is_below())
}

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

#[cfg(test)]
mod tests {
    use super::looks_like_list;

    #[test]
    fn a_list_of_triangles_is_no_table_of_grains() {
        let corners = "0 0 0 1 0 0 0 1e-3 0\n";
        let list = |text: &str| looks_like_list(text.as_bytes());
        assert!(list(corners) && list(&corners.replace(' ', ", ")));
        assert!(list(&format!("x1 [mm],y1 [mm],z1 [mm],x2 [mm]\n{corners}")) && list(&format!("# walls\n{corners}")));
        assert!(!list(&format!("id,x [mm],y,z,diameter,vx,vy,vz,mass\n{corners}")));
        assert!(!list("0 0 0 1\n0 0 0 2\n") && !list(""));
    }
}
