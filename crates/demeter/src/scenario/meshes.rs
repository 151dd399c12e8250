//! Meshes of walls: from the file to triangles that can be used, and what to tell of them.

use super::{Scenario, WallShape, WallSpec};
use crate::particles::Grains;
use crate::walls::mesh::Repair;
use crate::walls::{Made, Mesh, MeshError, MeshFormat, Shape, Wall, read_mesh};
use glam::DVec3;

/// Largest and smallest size of a mesh, as a multiple of the size of all grains together, that is no reason to doubt its
/// unit. A container is rarely more than 200 times as large as what is in it at the start, and a part of it (a blade, a
/// sieve wire) rarely 1/200; millimetres that are taken for metres are off by 1000.
const PLAUSIBLE: (f64, f64) = (1.0 / 200.0, 200.0);

/// Units in which surfaces are drawn, the most usual first.
const DRAWN_IN: [(&str, f64); 4] = [("mm", 1e-3), ("cm", 1e-2), ("in", 0.0254), ("um", 1e-6)];

/// Where the triangles of a wall come from.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshOrigin {
    /// The file; `None` when the scenario itself tells the triangles.
    pub source: Option<MeshSource>,
    /// Triangles before the repair.
    pub triangles: usize,
    /// What was repaired.
    pub repair: Repair,
}

/// The file of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshSource {
    /// Its format.
    pub format: MeshFormat,
    /// In words: what a coordinate of the file counts, and who says so.
    pub unit: String,
    /// Whether the scenario or the file tells the unit.
    pub unit_is_told: bool,
    /// Faces of more than three corners, which were cut into triangles.
    pub polygons: usize,
    /// Those of them whose outline crosses itself, or which are far from flat.
    pub twisted: usize,
    /// Those whose corners do not lie in a plane, and how far apart these are across it at most [m].
    pub warped: (usize, f64),
}

/// What a wall is made of; on error the key at fault and why.
pub(super) fn made_of(spec: &WallSpec) -> Result<(Made, Option<MeshOrigin>), (&'static str, String)> {
    let (given, source) = match &spec.shape {
        WallShape::Given(Shape::Mesh { triangles }) => (triangles.clone(), None),
        WallShape::Given(shape) => return Ok((shape.clone().into(), None)),
        WallShape::File(file) => {
            let content =
                read_mesh(&file.path, file.scale, file.shift).map_err(|error| (".file", error.to_string()))?;
            let (unit, unit_is_told) = match (&file.unit, file.scale, content.told_unit) {
                (Some(unit), ..) => (format!("{unit}, as told"), true),
                (None, Some(scale), _) => (format!("{scale} m, as `scale` tells"), true),
                (None, None, Some((unit, _))) => (format!("{unit}, as the file tells"), true),
                (None, None, None) => ("m, for no `unit` is told".to_string(), false),
            };
            let source = MeshSource {
                format: content.format,
                unit,
                unit_is_told,
                polygons: content.polygons,
                twisted: content.twisted,
                warped: content.warped,
            };
            (content.triangles, Some(source))
        }
    };
    let (triangles, repair) = Mesh::repair(&given, spec.weld).map_err(|error| {
        let key = if matches!(error, MeshError::AllJoined { .. }) {
            ".weld"
        } else {
            ""
        };
        (key, error.to_string())
    })?;
    let mesh = Mesh::new(&triangles).map_err(|error| ("", error.to_string()))?;
    let mesh = mesh.with_both_fronts(&repair.both_fronts);
    if spec.closed {
        let closed = mesh.require_closed();
        closed.map_err(|error| (".closed", format!("{error}, or do not ask for a closed mesh")))?;
    }
    let origin = MeshOrigin {
        source,
        triangles: given.len(),
        repair,
    };
    Ok((Made::Mesh(Box::new(mesh)), Some(origin)))
}

/// Tells what was repaired, and doubts units that nobody told. All grains are those at the start and those that come.
pub(super) fn check(
    scenario: &Scenario,
    walls: &[Wall],
    origins: &[Option<MeshOrigin>],
    at_start: &Grains,
    grains: &Grains,
    warnings: &mut Vec<String>,
) {
    for ((spec, wall), origin) in scenario.walls.iter().zip(walls).zip(origins) {
        let Some(origin) = origin else { continue };
        if let Some(repairs) = repairs(&origin.repair) {
            warnings.push(format!("wall `{}`: {repairs}", spec.name));
        }
        if let Some(small) = smaller_than_a_grain(wall, grains) {
            warnings.push(format!("wall `{}`: {small}", spec.name));
        }
        let Some(source) = &origin.source else { continue };
        if source.twisted > 0 {
            warnings.push(format!(
                "wall `{}`: {} faces of the file cross themselves or are far from flat, their triangles are a guess; \
                 export triangles",
                spec.name, source.twisted
            ));
        }
        if let (count @ 1.., apart) = source.warped {
            warnings.push(format!(
                "wall `{}`: {count} faces of the file are not flat: their corners are up to {apart:.3e} m apart across them, and as far would \
                 the surface be elsewhere, were they cut into other triangles; export triangles",
                spec.name
            ));
        }
        if let Some(doubt) = doubt_unit_of(wall, origin, grains) {
            warnings.push(format!("wall `{}`: {doubt}", spec.name));
        }
    }
    // grains that come lie in their inlets, of which each may be a mesh whose unit is to be doubted
    let size = size_of(places(at_start)).or_else(|| size_of(places(grains)));
    for mesh in &scenario.without_unit {
        if let Some(doubt) = size.and_then(|size| doubt_unit(mesh.size, size)) {
            warnings.push(format!("{}: {doubt}", mesh.path));
        }
    }
}

/// What to say of a mesh that is smaller than the largest grain in every direction: a part that grains meet is larger in one at least.
fn smaller_than_a_grain(wall: &Wall, grains: &Grains) -> Option<String> {
    let (lower, upper) = wall.bounds()?;
    let diameter = 2.0 * grains.radii().fold(0.0, f64::max);
    let [x, y, z] = (upper - lower).to_array();
    (x.max(y).max(z) < diameter).then(|| {
        format!(
            "the mesh is {x:.4e} x {y:.4e} x {z:.4e} m, smaller than the largest grain of {diameter:.4e} m: is its `unit` or `scale` right?"
        )
    })
}

/// Why the unit of a wall's mesh is to be doubted, where nobody told it.
pub(super) fn doubt_unit_of(wall: &Wall, origin: &MeshOrigin, grains: &Grains) -> Option<String> {
    let source = origin.source.as_ref().filter(|source| !source.unit_is_told);
    let (lower, upper) = wall.bounds().filter(|_| source.is_some())?;
    doubt_unit((upper - lower).length(), size_of(places(grains))?)
}

/// What was repaired, in words.
fn repairs(repair: &Repair) -> Option<String> {
    let mut parts = Vec::new();
    let of = |count: usize| format!("{count} triangle{}", if count == 1 { "" } else { "s" });
    if repair.flat.count > 0 {
        let (count, first, place) = (of(repair.flat.count), repair.flat.first, repair.flat.place);
        parts.push(format!(
            "left out {count} without area (the first is triangle {first} at {place})"
        ));
    }
    if repair.twice.count > 0 {
        let (count, first, place) = (of(repair.twice.count), repair.twice.first, repair.twice.place);
        parts.push(format!(
            "left out {count} that came before (the first is triangle {first} at {place})"
        ));
    }
    if repair.turned > 0 {
        parts.push(format!(
            "turned {} around, so that neighbours agree on their front",
            of(repair.turned)
        ));
    }
    (!parts.is_empty()).then(|| format!("the mesh was repaired: {}", parts.join("; ")))
}

/// Places and radii of all grains [m].
fn places(grains: &Grains) -> impl Iterator<Item = (DVec3, f64)> {
    grains.position.iter().copied().zip(grains.radii())
}

/// From corner to corner of the box around balls, told by place and radius [m]; `None` without any.
pub(super) fn size_of(balls: impl Iterator<Item = (DVec3, f64)>) -> Option<f64> {
    let boxes = balls.map(|(at, radius)| (at - radius, at + radius));
    let (lower, upper) = boxes.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))?;
    Some((upper - lower).length())
}

/// Why the unit of a mesh is to be doubted, from its size and that of all grains [m].
fn doubt_unit(mesh: f64, grains: f64) -> Option<String> {
    let ratio = mesh / grains;
    if ratio >= PLAUSIBLE.0 && ratio <= PLAUSIBLE.1 {
        return None;
    }
    let fits = |(_, size): &&(&str, f64)| ratio * size >= PLAUSIBLE.0 && ratio * size <= PLAUSIBLE.1;
    let hint = match DRAWN_IN.iter().find(fits) {
        Some((unit, size)) => {
            let drawn = metres(mesh * size);
            format!("is this file in {unit}? Then say `unit = \"{unit}\"`, and it is {drawn}")
        }
        None => "is the file in another unit? Then say so with `unit`".to_string(),
    };
    Some(format!(
        "no `unit` of its file is told, so its numbers count metres; it is {} from corner to corner, and all grains \
         together {}. {hint}; if it is right, say `unit = \"m\"`",
        metres(mesh),
        metres(grains)
    ))
}

/// A length with its unit; one that four places would tell as nothing, or nearly so, keeps its digits.
fn metres(length: f64) -> String {
    if length < 1e-3 {
        format!("{length:.3e} m")
    } else {
        format!("{length:.4} m")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn millimetres_taken_for_metres_are_told_and_containers_are_not() {
        for (mesh, grains) in [(0.4, 0.1), (2.0, 0.02), (0.005, 0.5), (100.0, 60.0)] {
            assert_eq!(doubt_unit(mesh, grains), None);
        }
        let doubt = doubt_unit(400.0, 0.1).unwrap();
        assert!(doubt.contains("unit = \"mm\"") && doubt.contains("0.4000 m"), "{doubt}");
        let tiny = doubt_unit(4e-11, 0.1).unwrap();
        assert!(
            tiny.contains("another unit") && tiny.contains("it is 4.000e-11 m from"),
            "{tiny}"
        );
        assert!(doubt_unit(4e5, 0.1).unwrap().contains("\"um\""));
    }
}
