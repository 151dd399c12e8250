//! Tables `[[wall]]`: shapes, materials and motion of walls.

use super::document::{Value, join};
use super::grains::{Surroundings, axis_ends, existing_file};
use super::materials::material_index;
use super::motions::{Frame, motions};
use super::quantity::Kind;
use super::reader::{Item, TableReader, suggest_or_list};
use super::units;
use crate::walls::{Motions, Recording, Shape, Side, WearCoefficients};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use glam::DVec3;
use std::path::PathBuf;

/// Most walls.
pub const MAX_WALLS: usize = 10_000;
/// Most triangles written in the scenario itself.
const MAX_TRIANGLES: usize = 100_000;
/// Largest cosine of the angle between two edges that must be perpendicular.
const PERPENDICULAR: f64 = 1e-9;

/// A wall as the scenario tells it.
#[derive(Clone, Debug, PartialEq)]
pub struct WallSpec {
    /// Name, unique.
    pub name: String,
    /// Index of the material.
    pub material: u16,
    /// Shape, or the file it is in.
    pub shape: WallShape,
    /// Whether the mesh is told to be closed: a hole in it is then an error.
    pub closed: bool,
    /// Largest distance of corners of a mesh that are joined [m]; `None`: the rounding of single precision.
    pub weld: Option<f64>,
    /// Motions from the start of the run.
    pub motion: Motions,
    /// What is recorded on every element.
    pub recording: Recording,
}

/// Shape of a wall, or the file it is in.
#[derive(Clone, Debug, PartialEq)]
pub enum WallShape {
    /// Told in the scenario.
    Given(Shape),
    /// Told by a mesh file.
    File(MeshFile),
}

/// A mesh file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFile {
    /// The file.
    pub path: PathBuf,
    /// Factor on all coordinates of the file, which then count metres; `None` when neither `unit` nor `scale` is told.
    pub scale: Option<f64>,
    /// The unit as written.
    pub unit: Option<String>,
    /// Shift after scaling [m].
    pub shift: DVec3,
}

const LENGTH: Kind = Kind::Physical(Dimension::LENGTH);

pub(super) fn walls(root: &TableReader<'_>, around: &Surroundings<'_>, gravity: DVec3) -> Vec<WallSpec> {
    let Some(item) = root.optional("wall") else {
        return Vec::new();
    };
    let tables = item.tables("wall");
    if tables.len() > MAX_WALLS {
        item.fault(
            format!("{} walls are too many; at most {MAX_WALLS}", tables.len()),
            None,
        );
    }
    let names: Vec<String> = tables
        .iter()
        .take(MAX_WALLS)
        .map(|table| table.text_of("name"))
        .collect();
    let frame = Frame {
        names: &names,
        base: around.base,
        gravity,
    };
    let mut walls: Vec<WallSpec> = Vec::new();
    for table in tables.into_iter().take(MAX_WALLS) {
        let path = join(&table.path, "name");
        let wall = wall(table, around, &frame);
        if !wall.name.is_empty() && walls.iter().any(|w| w.name == wall.name) {
            item.context
                .fault(&path, format!("two walls are named `{}`", wall.name), None);
        }
        walls.push(wall);
    }
    walls
}

fn wall(table: TableReader<'_>, around: &Surroundings<'_>, frame: &Frame<'_>) -> WallSpec {
    let name = table
        .required("name", "the name of the wall")
        .map_or_else(String::new, |i| i.label());
    let material = table.required("material", "the material of the wall");
    let mut wall = WallSpec {
        name,
        material: material.map_or(0, |i| material_index(&i, around.materials)),
        shape: WallShape::Given(Shape::Mesh { triangles: Vec::new() }),
        closed: false,
        weld: None,
        motion: table
            .optional("motion")
            .map_or_else(Motions::rest, |i| motions(&i, frame)),
        recording: recording(&table),
    };
    let meaning = "\"plane\", \"box\", \"cylinder\", \"cone\", \"sphere\", \"rectangle\", \"disc\" or \"mesh\"";
    let shape = table.required("shape", meaning);
    let Some(index) = shape.and_then(|i| i.choice(&SHAPES)) else {
        table.abandon();
        return wall;
    };
    wall.shape = match SHAPES[index] {
        "plane" => WallShape::Given(Shape::Plane {
            point: table.point("point", "a point of the plane"),
            normal: table.direction("normal", "the direction from the plane to the grains, as \"z\""),
        }),
        "box" => WallShape::Given(box_shape(&table)),
        "cylinder" => WallShape::Given(cylinder(&table)),
        "cone" => WallShape::Given(cone(&table)),
        "sphere" => WallShape::Given(Shape::Sphere {
            center: table.point("center", "the centre of the sphere"),
            radius: table.length("radius", "the radius of the sphere"),
            side: side(&table),
        }),
        "rectangle" => {
            let (center, half_u, half_v) = rectangle(&table);
            WallShape::Given(Shape::Rectangle { center, half_u, half_v })
        }
        "disc" => WallShape::Given(Shape::Disc {
            center: table.point("center", "the centre of the disc"),
            normal: table.direction("normal", "the direction across the disc, as \"z\""),
            radius: table.length("radius", "the radius of the disc"),
        }),
        _ => {
            wall.closed = table.optional("closed").is_some_and(|i| i.boolean());
            wall.weld = table.optional_quantity("weld", LENGTH, Range::POSITIVE);
            mesh(&table, around)
        }
    };
    table.finish(&format!("a wall of shape \"{}\"", SHAPES[index]));
    wall
}

fn recording(table: &TableReader<'_>) -> Recording {
    let per_pressure = Kind::Physical(Dimension::INVERSE_PRESSURE);
    let wear = table.optional("wear").and_then(|i| i.table());
    Recording {
        stress: table.optional("stress").is_some_and(|i| i.boolean()),
        wear: wear.map(|wear| {
            let coefficient = |key| wear.optional_quantity(key, per_pressure, Range::NOT_NEGATIVE);
            let read = WearCoefficients {
                sliding: coefficient("sliding").unwrap_or(0.0),
                impact: coefficient("impact").unwrap_or(0.0),
            };
            wear.finish("the wear of a wall");
            read
        }),
    }
}

const SHAPES: [&str; 8] = [
    "plane",
    "box",
    "cylinder",
    "cone",
    "sphere",
    "rectangle",
    "disc",
    "mesh",
];

fn side(table: &TableReader<'_>) -> Side {
    match table
        .optional("side")
        .and_then(|i| i.choice(&["inside", "outside", "both"]))
    {
        Some(1) => Side::Outside,
        Some(2) => Side::Both,
        _ => Side::Inside,
    }
}

fn box_shape(table: &TableReader<'_>) -> Shape {
    let (lower, upper) = table.corners();
    let mut open = [false; 6];
    if let Some(item) = table.optional("open") {
        for face in item.items() {
            if let Some(index) = face.choice(&["-x", "+x", "-y", "+y", "-z", "+z"]) {
                open[index] = true;
            }
        }
        if open == [true; 6] {
            item.fault("all six faces are open: there is no wall", None);
        }
    }
    Shape::Box { lower, upper, open }
}

fn cylinder(table: &TableReader<'_>) -> Shape {
    let (start, end) = axis_ends(table);
    Shape::Cylinder {
        start,
        end,
        radius: table.length("radius", "the radius of the cylinder"),
        side: side(table),
    }
}

fn cone(table: &TableReader<'_>) -> Shape {
    let (start, end) = axis_ends(table);
    let (start_radius, end_radius) = cone_radii(table);
    Shape::Cone {
        start,
        end,
        start_radius,
        end_radius,
        side: side(table),
    }
}

/// Radii of a cone at its start and its end.
pub(super) fn cone_radii(table: &TableReader<'_>) -> (f64, f64) {
    let start_radius = table.quantity(
        "start_radius",
        LENGTH,
        Range::NOT_NEGATIVE,
        "the radius at the start, may be 0",
    );
    let end_radius = table.quantity(
        "end_radius",
        LENGTH,
        Range::NOT_NEGATIVE,
        "the radius at the end, may be 0",
    );
    if start_radius == end_radius {
        let message = if start_radius == 0.0 {
            "a cone without radius at both ends has no surface"
        } else {
            "a cone of the same radius at both ends is a cylinder; use shape = \"cylinder\""
        };
        table.fault_at("end_radius", message);
    }
    (start_radius, end_radius)
}

/// Centre of a rectangle, and from there to the middles of two edges.
pub(super) fn rectangle(table: &TableReader<'_>) -> (DVec3, DVec3, DVec3) {
    let center = table.point("center", "the centre of the rectangle");
    let half_u = table.point("half_u", "from the centre to the middle of one edge");
    let half_v = table.point("half_v", "from the centre to the middle of the next edge");
    for (key, half) in [("half_u", half_u), ("half_v", half_v)] {
        if half == DVec3::ZERO {
            table
                .context
                .fault(&join(&table.path, key), format!("`{key}` has no length"), None);
        }
    }
    let product = half_u.dot(half_v).abs();
    if product > PERPENDICULAR * half_u.length() * half_v.length() {
        let message = "`half_u` and `half_v` must be perpendicular";
        table.fault_at("half_v", message);
    }
    (center, half_u, half_v)
}

pub(super) fn mesh(table: &TableReader<'_>, around: &Surroundings<'_>) -> WallShape {
    let nothing = WallShape::Given(Shape::Mesh { triangles: Vec::new() });
    let file = table.optional("file");
    let triangles = table.optional("triangles");
    match (file, triangles) {
        (Some(file), None) => {
            let path = existing_file(&file, around.base);
            let scale = table.optional_quantity("scale", Kind::Number, Range::POSITIVE);
            let unit = table.optional("unit");
            if scale.is_some() && unit.is_some() {
                table.fault_at("scale", "`unit` and `scale` exclude each other; give one of them");
            }
            WallShape::File(MeshFile {
                path,
                scale: scale.or(unit.as_ref().map(length_unit)),
                unit: unit.map(|item| item.text()),
                shift: table.vector_or_zero("shift", LENGTH),
            })
        }
        (None, Some(item)) => {
            let items = item.items();
            if matches!(item.node.value, Value::Array(_)) && (items.is_empty() || items.len() > MAX_TRIANGLES) {
                item.fault(format!("`triangles` must have 1 to {MAX_TRIANGLES} entries"), None);
            }
            let triangles = items.iter().take(MAX_TRIANGLES).map(triangle).collect();
            WallShape::Given(Shape::Mesh { triangles })
        }
        (None, None) => {
            let help = "give `file`, the path of an STL, OBJ or PLY file or a list of triangles, or `triangles`";
            table.fault("the triangles of the mesh are missing", Some(help.to_string()));
            nothing
        }
        (Some(_), Some(_)) => {
            table.fault_at(
                "triangles",
                "`file` and `triangles` exclude each other; give one of them",
            );
            nothing
        }
    }
}

/// Metres in a unit of length, as `"mm"`.
fn length_unit(item: &Item<'_>) -> f64 {
    let text = item.text();
    if !matches!(item.node.value, Value::String(_)) {
        return f64::NAN;
    }
    let begins_with_number = text.trim_start().starts_with(|c: char| c.is_ascii_digit());
    let read = units::parse(&format!("1 {}", text.trim()));
    match read {
        Ok(unit) if unit.has_unit && unit.dimension == Dimension::LENGTH && unit.angle == 0 && !begins_with_number => {
            unit.value
        }
        _ => {
            let help = "write \"m\", \"mm\", \"cm\", \"um\", \"in\" or \"ft\"; a factor is told by `scale`";
            item.fault(format!("`{text}` is no unit of length"), Some(help.to_string()));
            f64::NAN
        }
    }
}

fn triangle(item: &Item<'_>) -> [DVec3; 3] {
    let corners = item.items();
    if corners.len() != 3 {
        if matches!(item.node.value, Value::Array(_)) {
            item.fault(format!("a triangle has three corners, found {}", corners.len()), None);
        }
        return [DVec3::NAN; 3];
    }
    [0, 1, 2].map(|k| corners[k].vector(LENGTH))
}

/// Index of the wall that a name tells; notes a fault when there is none.
pub(super) fn wall_index(item: &Item<'_>, name: &str, walls: &[WallSpec]) -> usize {
    index_of_name(item, name, walls.iter().map(|w| w.name.as_str()))
}

/// Index of the wall of a name among those that there are; notes a fault when there is none.
pub(super) fn index_of_name<'a>(item: &Item<'_>, name: &str, names: impl Iterator<Item = &'a str> + Clone) -> usize {
    names.clone().position(|known| known == name).unwrap_or_else(|| {
        item.fault(format!("there is no wall named `{name}`"), suggest_or_list(name, names));
        0
    })
}
