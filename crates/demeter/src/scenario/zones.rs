//! Regions and selections: where grains are counted or removed, and which of them.

use super::document::Value;
use super::feeds::index_of;
use super::grains::{Surroundings, axis_ends};
use super::interiors::closed_mesh;
use super::materials::material_index;
use super::quantity::Kind;
use super::reader::{Item, TableReader};
use super::walls::{WallSpec, cone_radii, wall_index};
use crate::measure::Selection;
use crate::particles::{Zone, ZonePart, ZoneShape};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use glam::DVec3;
use std::collections::BTreeSet;

/// Most parts of a region.
const MAX_PARTS: usize = 1000;
/// Most ids of a selection.
const MAX_IDS: usize = 1_000_000;
const SHAPES: [&str; 6] = ["box", "cylinder", "cone", "sphere", "half-space", "mesh"];
const FACES: [&str; 6] = ["-x", "+x", "-y", "+y", "-z", "+z"];

/// What grains may be selected by.
pub(super) struct Named<'a> {
    pub around: &'a Surroundings<'a>,
    pub walls: &'a [WallSpec],
    /// Whether the corners of the domain are told.
    pub has_domain: bool,
    /// Acceleration of gravity [m/s^2].
    pub gravity: DVec3,
    /// Names of the batches, then of the feeds.
    pub sources: Vec<&'a str>,
}

/// Key `region`: a table, or a list of tables that hold at once.
pub(super) fn region(item: &Item<'_>, named: &Named<'_>) -> Zone {
    let tables: Vec<TableReader<'_>> = match &item.node.value {
        Value::Array(nodes) => {
            if nodes.is_empty() || nodes.len() > MAX_PARTS {
                let message = format!("a region has 1 to {MAX_PARTS} parts, found {}", nodes.len());
                item.fault(message, Some("leave it out for everywhere".to_string()));
            }
            item.items().iter().take(MAX_PARTS).filter_map(Item::table).collect()
        }
        _ => item.table().into_iter().collect(),
    };
    Zone {
        parts: tables.into_iter().map(|table| part(table, named)).collect(),
    }
}

fn part(table: TableReader<'_>, named: &Named<'_>) -> ZonePart {
    let nowhere = ZonePart {
        shape: ZoneShape::Sphere {
            center: DVec3::NAN,
            radius: f64::NAN,
        },
        outside: false,
        wall: None,
    };
    let meaning = "\"box\", \"cylinder\", \"cone\", \"sphere\", \"half-space\" or \"mesh\"";
    let shape = table.required("shape", meaning);
    let Some(index) = shape.and_then(|i| i.choice(&SHAPES)) else {
        table.abandon();
        return nowhere;
    };
    let outside = table.optional("outside").is_some_and(|i| i.boolean());
    let wall = table
        .optional("wall")
        .map(|item| wall_index(&item, &item.text(), named.walls));
    let shape = match SHAPES[index] {
        "box" => open_box(&table),
        "cylinder" => {
            let (start, end) = axis_ends(&table);
            let radius = table.length("radius", "the radius of the cylinder");
            ZoneShape::Cylinder { start, end, radius }
        }
        "cone" => {
            let (start, end) = axis_ends(&table);
            let (start_radius, end_radius) = cone_radii(&table);
            ZoneShape::Cone {
                start,
                end,
                start_radius,
                end_radius,
            }
        }
        "mesh" => closed_mesh(&table, wall.and_then(|wall| named.walls.get(wall)), named.around)
            .map_or(nowhere.shape, |mesh| ZoneShape::Mesh(mesh.interior)),
        "sphere" => ZoneShape::Sphere {
            center: table.point("center", "the centre of the sphere"),
            radius: table.length("radius", "the radius of the sphere"),
        },
        _ => ZoneShape::HalfSpace {
            point: table.point("point", "a point of the plane that ends the half-space"),
            normal: table.direction("normal", "the direction from the plane into the half-space, as \"z\""),
        },
    };
    table.finish(&format!("a region of shape \"{}\"", SHAPES[index]));
    ZonePart { shape, outside, wall }
}

/// A box some of whose sides lie at infinity: those named in `open`, and all three of a corner that is not told.
fn open_box(table: &TableReader<'_>) -> ZoneShape {
    let length = Kind::Physical(Dimension::LENGTH);
    let corner = |key: &str, far: DVec3| table.optional(key).map_or(far, |item| item.vector(length));
    let mut lower = corner("lower", DVec3::NEG_INFINITY);
    let mut upper = corner("upper", DVec3::INFINITY);
    if let Some(item) = table.optional("open") {
        for face in item.items() {
            match face.choice(&FACES) {
                Some(face) if face % 2 == 0 => lower[face / 2] = f64::NEG_INFINITY,
                Some(face) => upper[face / 2] = f64::INFINITY,
                None => {}
            }
        }
    }
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        if upper[axis] <= lower[axis] {
            let message = format!("`upper` must be above `lower` in every direction; in {name} it is not");
            table.fault_at("upper", message);
        }
    }
    ZoneShape::Box { lower, upper }
}

/// Keys `material`, `batch`, `ids`, `tag`, `finer_than` and `coarser_than` of a measure or a removal.
pub(super) fn selection(table: &TableReader<'_>, named: &Named<'_>) -> Selection {
    let material = table
        .optional("material")
        .map(|i| material_index(&i, named.around.materials));
    let source = table.optional("batch").map(|item| {
        let index = index_of(&item, "batch or feed", named.sources.iter().copied());
        index.unwrap_or(0) as u16
    });
    let mut ids: Vec<u32> = table.optional("ids").map_or_else(Vec::new, |item| {
        let items = item.items();
        if matches!(&item.node.value, Value::Array(_)) && !(1..=MAX_IDS).contains(&items.len()) {
            item.fault(format!("`ids` must have 1 to {MAX_IDS} entries"), None);
        }
        let id = |i: &Item<'_>| i.integer(0, i64::from(u32::MAX)) as u32;
        let ids: Vec<u32> = items.iter().take(MAX_IDS).map(id).collect();
        let mut known = BTreeSet::new();
        if let Some((k, id)) = ids.iter().enumerate().find(|(_, id)| !known.insert(**id)) {
            items[k].fault(format!("grain {id} is named twice"), Some("name it once".to_string()));
        }
        ids
    });
    ids.sort_unstable();
    let tag = table.optional("tag").map(|i| tag_value(&i));
    let diameter = |key: &str| {
        let item = table.optional(key)?;
        Some(item.quantity(Kind::Physical(Dimension::LENGTH), Range::POSITIVE))
    };
    Selection {
        material,
        source,
        ids,
        tag,
        finer_than: diameter("finer_than"),
        coarser_than: diameter("coarser_than"),
    }
}

/// A tag: a whole number of 32 bits.
pub(super) fn tag_value(item: &Item<'_>) -> i32 {
    item.integer(i64::from(i32::MIN), i64::from(i32::MAX)) as i32
}
