//! Tables `[[feed]]` and `[[removal]]`: grains that come and go while the run goes on.

use super::document::{Value, join};
use super::grains::{Surroundings, cylinder};
use super::interiors::{closed_mesh, open_mesh};
use super::materials::material_index;
use super::measures::of_one_word;
use super::quantity::Kind;
use super::reader::{Item, TableReader, suggest_or_list};
use super::sizes::diameter;
use super::walls::rectangle;
use super::zones::{Named, region, selection, tag_value};
use crate::insertion::{Inlet, Insertion, MeshInlet, Region, Stream};
use crate::measure::Selection;
use crate::particles::Zone;
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use glam::DVec3;
use std::sync::Arc;

/// Most feeds, and most removals.
pub const MAX_FEEDS: usize = 1000;
/// Steps between two times at which grains come and go, when nothing is told.
pub const EXCHANGE_EVERY: u64 = 100;

/// Steps between two times at which grains come or go.
pub(super) fn exchange_steps(every: Option<f64>, dt: f64) -> u64 {
    every.map_or(EXCHANGE_EVERY, |seconds| (seconds / dt).round().max(1.0) as u64)
}

/// Most grains that one feed may let come.
const MAX_COUNT: i64 = (u32::MAX / 2) as i64;
/// Longest name; it is a part of titles of columns.
const MAX_NAME: usize = 60;

/// How fast grains come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FeedRate {
    /// As fast as there is room.
    AsRoomAllows,
    /// Mass per time [kg/s].
    Mass(f64),
    /// Number per time [1/s].
    Number(f64),
}

/// When a feed ends; at the first of these that is told and reached.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FeedEnd {
    /// So many grains came.
    pub count: Option<u64>,
    /// The mass that came is nearest to this [kg].
    pub mass: Option<f64>,
    /// Simulated time [s].
    pub until: Option<f64>,
    /// Grains are piled up beyond a plane: a point of it [m] and the unit vector beyond.
    pub level: Option<(DVec3, DVec3)>,
}

/// A table `[[feed]]`.
#[derive(Clone, Debug, PartialEq)]
pub struct FeedSpec {
    /// Name, unique among batches and feeds.
    pub name: String,
    /// The grains.
    pub stream: Stream,
    /// How fast they come.
    pub rate: FeedRate,
    /// When it ends.
    pub end: FeedEnd,
    /// Time between two times at which grains come [s]; [`EXCHANGE_EVERY`] steps when absent.
    pub every: Option<f64>,
    /// Tag of the grains.
    pub tag: i32,
}

impl FeedSpec {
    /// The step with which it ends at its time.
    pub(super) fn last_step(&self, dt: f64) -> Option<u64> {
        self.end.until.map(|until| (until / dt).ceil() as u64)
    }
}

/// A table `[[removal]]`.
#[derive(Clone, Debug, PartialEq)]
pub struct RemovalSpec {
    /// Name, unique among removals.
    pub name: String,
    /// Where grains are removed.
    pub zone: Zone,
    /// Which grains are.
    pub selection: Selection,
    /// Time between two times at which grains go [s]; [`EXCHANGE_EVERY`] steps when absent.
    pub every: Option<f64>,
    /// Whether every grain that goes is listed.
    pub list: bool,
}

const TIME: Kind = Kind::Physical(Dimension::TIME);
const VELOCITY: Kind = Kind::Physical(Dimension::VELOCITY);

/// Reads a list of tables whose names must differ from each other and from others.
fn named_tables<'a, T>(
    root: &TableReader<'a>,
    key: &str,
    others: &[&str],
    mut read: impl FnMut(TableReader<'a>, String, usize) -> T,
) -> Vec<T> {
    let Some(item) = root.optional(key) else {
        return Vec::new();
    };
    let tables = item.tables(key);
    if tables.len() > MAX_FEEDS {
        item.fault(
            format!("{} tables [[{key}]] are too many; at most {MAX_FEEDS}", tables.len()),
            None,
        );
    }
    let mut names: Vec<String> = others.iter().map(ToString::to_string).collect();
    let mut all = Vec::new();
    for (index, table) in tables.into_iter().take(MAX_FEEDS).enumerate() {
        let path = join(&table.path, "name");
        let name = table
            .required("name", "a name, for its columns and for stages")
            .map_or_else(String::new, |i| i.label());
        if name.chars().count() > MAX_NAME {
            let message = format!("`name` must have at most {MAX_NAME} characters");
            item.context.fault(&path, message, None);
        }
        if !name.is_empty() && names.contains(&name) {
            let message = format!("the name `{name}` is taken");
            item.context.fault(&path, message, None);
        }
        names.push(name.clone());
        all.push(read(table, name, index));
    }
    all
}

pub(super) fn feeds(root: &TableReader<'_>, around: &Surroundings<'_>, batches: &[Insertion]) -> Vec<FeedSpec> {
    let others: Vec<&str> = batches.iter().map(|b| b.name.as_str()).collect();
    named_tables(root, "feed", &others, |table, name, index| {
        let number = batches.len() + index;
        feed(table, name, around.seed.wrapping_add(number as u64), around)
    })
}

fn feed(table: TableReader<'_>, name: String, default_seed: u64, around: &Surroundings<'_>) -> FeedSpec {
    let material = table.required("material", "the material of the grains");
    let stream = Stream {
        material: material.map_or(0, |i| material_index(&i, around.materials)),
        diameter: diameter(&table),
        inlet: inlet(&table, around),
        velocity: table.vector_or_zero("velocity", VELOCITY),
        velocity_deviation: table
            .optional_quantity("velocity_deviation", VELOCITY, Range::NOT_NEGATIVE)
            .unwrap_or(0.0),
        angular_velocity: table.vector_or_zero("angular_velocity", Kind::AngularVelocity),
        seed: (table.optional("seed")).map_or(default_seed, |i| i.integer(0, i64::MAX) as u64),
    };
    let mass_rate = table.optional_quantity("mass_rate", Kind::MassRate, Range::POSITIVE);
    let number_rate = table.optional_quantity("number_rate", Kind::NumberRate, Range::POSITIVE);
    let rate = match (mass_rate, number_rate) {
        (Some(rate), Some(_)) => {
            table.fault_at(
                "number_rate",
                "`mass_rate` and `number_rate` exclude each other; give one of them",
            );
            FeedRate::Mass(rate)
        }
        (Some(rate), None) => FeedRate::Mass(rate),
        (None, Some(rate)) => FeedRate::Number(rate),
        (None, None) => FeedRate::AsRoomAllows,
    };
    let end = FeedEnd {
        count: table.optional("count").map(|i| i.integer(1, MAX_COUNT) as u64),
        mass: table.optional_quantity("mass", Kind::Physical(Dimension::MASS), Range::POSITIVE),
        until: table.optional_quantity("until", TIME, Range::POSITIVE),
        level: table.optional("level").and_then(|i| i.table()).map(level),
    };
    if rate == FeedRate::AsRoomAllows && end == FeedEnd::default() {
        let help = "give `count`, `mass`, `level` or `until`, or a rate: `mass_rate` or `number_rate`";
        table.fault("the feed has neither a rate nor an end", Some(help.to_string()));
    }
    let every = table.optional_quantity("every", TIME, Range::POSITIVE);
    let tag = table.optional("tag").map_or(0, |i| tag_value(&i));
    table.finish("a feed");
    FeedSpec {
        name,
        stream,
        rate,
        end,
        every,
        tag,
    }
}

fn level(table: TableReader<'_>) -> (DVec3, DVec3) {
    let point = table.point("point", "a point of the plane that grains are piled up to");
    let normal = table.direction("normal", "the direction in which the pile grows, as \"z\"");
    table.finish("a level");
    (point, normal)
}

/// Key `from`: a face, or a region.
fn inlet(table: &TableReader<'_>, around: &Surroundings<'_>) -> Inlet {
    const SHAPES: [&str; 6] = ["rectangle", "disc", "mesh-face", "box", "cylinder", "mesh"];
    let nowhere = Inlet::Disc {
        center: DVec3::NAN,
        normal: DVec3::NAN,
        radius: f64::NAN,
    };
    let meaning = "where the grains come in, as { shape = \"disc\", center = ..., normal = ..., radius = ... }";
    let Some(item) = table.required("from", meaning) else {
        return nowhere;
    };
    let Some(from) = item.table() else {
        return nowhere;
    };
    let shape = from.required(
        "shape",
        "\"rectangle\", \"disc\", \"mesh-face\", \"box\", \"cylinder\" or \"mesh\"",
    );
    let Some(shape) = shape.and_then(|i| i.choice(&SHAPES)) else {
        from.abandon();
        return nowhere;
    };
    let inlet = match SHAPES[shape] {
        "rectangle" => {
            let (center, half_u, half_v) = rectangle(&from);
            Inlet::Rectangle { center, half_u, half_v }
        }
        "disc" => Inlet::Disc {
            center: from.point("center", "the centre of the disc"),
            normal: from.direction("normal", "the direction across the disc, as \"-z\""),
            radius: from.length("radius", "the radius of the disc"),
        },
        "box" => {
            let (lower, upper) = from.corners();
            Inlet::Region(Region::Box { lower, upper })
        }
        "cylinder" => Inlet::Region(cylinder(&from)),
        "mesh-face" => open_mesh(&from, around).map_or(nowhere, |triangles| {
            Inlet::Mesh(MeshInlet {
                triangles: Arc::new(triangles),
                interior: None,
            })
        }),
        _ => closed_mesh(&from, None, around).map_or(nowhere, |mesh| {
            Inlet::Mesh(MeshInlet {
                triangles: Arc::new(mesh.triangles),
                interior: Some(mesh.interior),
            })
        }),
    };
    from.finish(&format!("an inlet of shape \"{}\"", SHAPES[shape]));
    inlet
}

pub(super) fn removals(root: &TableReader<'_>, named: &Named<'_>) -> Vec<RemovalSpec> {
    named_tables(root, "removal", &[], |table, name, _| {
        let meaning = "where grains are removed, as { shape = \"half-space\", point = ..., normal = \"-z\" }";
        let removal = RemovalSpec {
            name,
            zone: table
                .required("region", meaning)
                .map(|i| region(&i, named))
                .unwrap_or_default(),
            selection: selection(&table, named),
            every: table.optional_quantity("every", TIME, Range::POSITIVE),
            list: table.optional("list").is_some_and(|item| listed(&item, &table)),
        };
        table.finish("a removal");
        removal
    })
}

/// Whether the grains that a removal takes are listed, in a file of its name.
fn listed(item: &Item<'_>, table: &TableReader<'_>) -> bool {
    let list = item.boolean();
    if let (true, Err((rule, instead))) = (list, of_one_word(&table.text_of("name"))) {
        let path = join(&table.path, "name");
        let message = format!("`name`, of the file that `list` writes, must be {rule}");
        item.context.fault(&path, message, instead);
    }
    list
}

/// A list of names of feeds or removals in a stage, as indices.
pub(super) fn chosen<'n>(item: &Item<'_>, what: &str, names: impl Iterator<Item = &'n str> + Clone) -> Vec<usize> {
    if !matches!(item.node.value, Value::Array(_)) {
        item.fault(
            format!(
                "`{}` must be a list of names, found {}",
                item.name,
                item.node.value.kind()
            ),
            None,
        );
        return Vec::new();
    }
    let mut indices = Vec::new();
    for item in item.items() {
        match index_of(&item, what, names.clone()) {
            Some(index) if indices.contains(&index) => {
                item.fault(
                    format!("`{}` is named twice", item.text()),
                    Some("name it once".to_string()),
                );
            }
            found => indices.extend(found),
        }
    }
    indices
}

/// The index of a name.
pub(super) fn index_of<'n>(item: &Item<'_>, what: &str, names: impl Iterator<Item = &'n str> + Clone) -> Option<usize> {
    let name = item.text();
    let index = names.clone().position(|known| known == name);
    if index.is_none() && matches!(item.node.value, Value::String(_)) {
        item.fault(
            format!("there is no {what} named `{name}`"),
            suggest_or_list(&name, names),
        );
    }
    index
}
