//! Tables `[[grains]]`: where grains come from.

use super::document::Value;
use super::interiors::MeshWithoutUnit;
use super::materials::material_index;
use super::quantity::Kind;
use super::reader::{Item, TableReader};
use super::sizes::{diameter, positive_lengths};
use super::zones::tag_value;
use crate::grain_files::{FileUnits, Format, ReadOptions, Which};
use crate::insertion::{Amount, Insertion, LatticeKind, Region, Source};
use crate::materials::Material;
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use glam::DVec3;
use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// Most batches of grains.
pub const MAX_BATCHES: usize = 10_000;
/// Most grains that one batch may ask for.
pub const MAX_GRAINS: i64 = (u32::MAX / 2) as i64;
/// Most types of a data file.
const MAX_TYPES: usize = 1000;
/// Largest share of a region that spheres placed at random are asked to fill. Random close packing is 0.64; more than
/// 1 is impossible, and what lies between is left to the packing to reach or to refuse.
const VOLUME_FRACTION: Range = Range::new(0.0, false, 1.0, false);

/// What the readers of grains and walls share.
pub(super) struct Surroundings<'a> {
    pub materials: &'a [Material],
    /// Folder that relative paths start from.
    pub base: &'a Path,
    pub seed: u64,
    /// Meshes of regions and inlets whose unit nobody tells; readers add to them.
    pub without_unit: RefCell<Vec<MeshWithoutUnit>>,
}

pub(super) fn grains(root: &TableReader<'_>, around: &Surroundings<'_>) -> Vec<Insertion> {
    let meaning = "at least one table [[grains]] that says where grains come from";
    let found = match root.has("feed") {
        // a run may begin empty when grains come later
        true => root.optional("grains"),
        false => root.required("grains", meaning),
    };
    let Some(item) = found else {
        return Vec::new();
    };
    let tables = item.tables("grains");
    if tables.len() > MAX_BATCHES {
        item.fault(
            format!("{} batches of grains are too many; at most {MAX_BATCHES}", tables.len()),
            None,
        );
    }
    let mut batches: Vec<Insertion> = Vec::new();
    for (index, table) in tables.into_iter().take(MAX_BATCHES).enumerate() {
        let path = table.path.clone();
        let batch = insertion(table, index, around);
        if batches.iter().any(|b| b.name == batch.name) {
            let message = format!("two batches of grains are named `{}`", batch.name);
            item.context.fault(&format!("{path}.name"), message, None);
        }
        batches.push(batch);
    }
    batches
}

fn insertion(table: TableReader<'_>, index: usize, around: &Surroundings<'_>) -> Insertion {
    let velocity = Kind::Physical(Dimension::VELOCITY);
    let name = table
        .optional("name")
        .map_or_else(|| format!("grains {}", index + 1), |i| i.label());
    let material = table.required("material", "the material of the grains");
    let material = material.map_or(0, |i| material_index(&i, around.materials));
    let fixed = fixed(&table);
    let insertion = Insertion {
        name,
        material,
        velocity: table.vector_or_zero("velocity", velocity),
        velocity_deviation: table
            .optional_quantity("velocity_deviation", velocity, Range::NOT_NEGATIVE)
            .unwrap_or(0.0),
        angular_velocity: table.vector_or_zero("angular_velocity", Kind::AngularVelocity),
        tag: table.optional("tag").map(|i| tag_value(&i)),
        fixed,
        seed: match table.optional("seed") {
            Some(item) => item.integer(0, i64::MAX) as u64,
            None => around.seed.wrapping_add(index as u64),
        },
        types: Vec::new(),
        source: Source::List {
            positions: Vec::new(),
            diameters: Vec::new(),
        },
    };
    source(table, insertion, around)
}

/// Whether the grains stay where they are.
fn fixed(table: &TableReader<'_>) -> bool {
    let fixed = table.optional("fixed").is_some_and(|item| item.boolean());
    for key in ["velocity", "velocity_deviation", "angular_velocity"] {
        if fixed && table.has(key) {
            table.fault_at(key, "grains that are `fixed` do not move; leave out one of the two");
        }
    }
    fixed
}

/// Reads what depends on the source and finishes the table.
fn source(table: TableReader<'_>, mut insertion: Insertion, around: &Surroundings<'_>) -> Insertion {
    const SOURCES: [&str; 4] = ["random", "lattice", "file", "list"];
    let meaning = "\"random\", \"lattice\", \"file\" or \"list\"";
    let Some(kind) = table.required("source", meaning).and_then(|i| i.choice(&SOURCES)) else {
        table.abandon();
        return insertion;
    };
    insertion.source = match kind {
        0 => random(&table),
        1 => lattice(&table),
        2 => {
            if let Some(item) = table.optional("types") {
                let types = item.items();
                if types.is_empty() || types.len() > MAX_TYPES {
                    let message = format!("`types` names the material of each of 1 to {MAX_TYPES} types of the file");
                    item.fault(message, None);
                }
                let named = types.iter().take(MAX_TYPES);
                insertion.types = named.map(|i| material_index(i, around.materials)).collect();
            }
            file(&table, around.base)
        }
        _ => list(&table),
    };
    table.finish(&format!("grains from source \"{}\"", SOURCES[kind]));
    insertion
}

fn random(table: &TableReader<'_>) -> Source {
    let (region, diameter) = (region(table), diameter(table));
    let count = table.optional("count").map(|i| i.integer(1, MAX_GRAINS) as u32);
    let fraction = table.optional_quantity("volume_fraction", Kind::Number, VOLUME_FRACTION);
    let amount = match (count, fraction) {
        (Some(count), None) => Amount::Count(count),
        (None, Some(fraction)) => Amount::VolumeFraction(fraction),
        (None, None) => {
            table.fault("how many grains? Give `count` or `volume_fraction`", None);
            Amount::Count(0)
        }
        (Some(count), Some(_)) => {
            table.fault(
                "`count` and `volume_fraction` exclude each other; give one of them",
                None,
            );
            Amount::Count(count)
        }
    };
    Source::Random {
        region,
        diameter,
        amount,
    }
}

fn lattice(table: &TableReader<'_>) -> Source {
    let kinds = ["simple-cubic", "bcc", "fcc", "hcp"];
    let kind = table.required("lattice", "\"simple-cubic\", \"bcc\", \"fcc\" or \"hcp\"");
    let kind = kind.and_then(|i| i.choice(&kinds)).unwrap_or(0);
    let jitter = Range::new(0.0, true, 0.5, true);
    Source::Lattice {
        kind: [
            LatticeKind::SimpleCubic,
            LatticeKind::Bcc,
            LatticeKind::Fcc,
            LatticeKind::Hcp,
        ][kind],
        spacing: table.length("spacing", "the distance of nearest neighbours, as \"2.1 mm\""),
        jitter: table.optional_quantity("jitter", Kind::Number, jitter).unwrap_or(0.0),
        region: region(table),
        diameter: diameter(table),
        count: table.optional("count").map(|i| i.integer(1, MAX_GRAINS) as u32),
    }
}

fn file(table: &TableReader<'_>, base: &Path) -> Source {
    let path = table.required("file", "the path of the file, relative to the scenario");
    Source::File {
        path: path.map_or_else(PathBuf::new, |i| match i.context.has_started {
            true => base.join(i.text()),
            false => existing_file(&i, base),
        }),
        keep_velocities: table.optional("keep_velocities").is_none_or(|i| i.boolean()),
        density: table.optional_quantity("density", Kind::Physical(Dimension::DENSITY), Range::POSITIVE),
        scale: table
            .optional_quantity("scale", Kind::Number, Range::POSITIVE)
            .unwrap_or(1.0),
        shift: table.vector_or_zero("shift", Kind::Physical(Dimension::LENGTH)),
        reading: reading(table),
        which: match table.optional("frame") {
            Some(item) => Which::Number(item.integer(0, i64::from(u32::MAX)) as usize),
            None => Which::Last,
        },
    }
}

/// What a file of grains does not tell itself.
fn reading(table: &TableReader<'_>) -> ReadOptions {
    let formats: Vec<&str> = Format::names().collect();
    let format = table.optional("format").and_then(|item| item.choice(&formats));
    let units = table
        .optional("units")
        .and_then(|item| match item.text().parse::<FileUnits>() {
            Ok(units) => Some(units),
            Err(error) => {
                item.fault(error.to_string(), None);
                None
            }
        });
    ReadOptions {
        format: format.map(|k| Format::ALL[k]),
        units,
        diameter: table.optional_quantity("diameter", Kind::Physical(Dimension::LENGTH), Range::POSITIVE),
        style: table.optional("atom_style").map(|item| item.text().to_owned()),
        ..ReadOptions::default()
    }
}

/// Path of a file that must be there, from the folder of the scenario.
pub(super) fn existing_file(item: &Item<'_>, base: &Path) -> PathBuf {
    let written = item.text();
    if written.is_empty() {
        if matches!(item.node.value, Value::String(_)) {
            item.fault(format!("`{}` is empty", item.name), None);
        }
        return PathBuf::new();
    }
    let path = base.join(&written);
    let help = || Some("a relative path starts at the folder of the scenario".to_string());
    match std::fs::metadata(&path) {
        Ok(found) if found.is_file() => {}
        Ok(_) => item.fault(format!("`{written}` is not a file"), None),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            item.fault(format!("there is no file `{written}`"), help());
        }
        Err(error) => item.fault(format!("`{written}` cannot be read: {}", error.kind()), help()),
    }
    path
}

fn list(table: &TableReader<'_>) -> Source {
    let positions: Vec<DVec3> = match table.required("positions", "a list of points, as [[\"0 m\", \"0 m\", \"1 m\"]]")
    {
        None => Vec::new(),
        Some(item) => {
            let points = item.items();
            if points.is_empty() && matches!(item.node.value, Value::Array(_)) {
                item.fault("`positions` is empty", None);
            }
            points
                .iter()
                .map(|i| i.vector(Kind::Physical(Dimension::LENGTH)))
                .collect()
        }
    };
    let single = table.optional_quantity("diameter", Kind::Physical(Dimension::LENGTH), Range::POSITIVE);
    let several = table.optional("diameters").map(|i| (positive_lengths(&i), i));
    let diameters = match (single, several) {
        (Some(diameter), None) => vec![diameter; positions.len()],
        (None, Some((diameters, item))) => {
            if diameters.len() != positions.len() && table.has("positions") {
                let message = format!("{} diameters for {} positions", diameters.len(), positions.len());
                item.fault(message, Some("give as many diameters as positions".to_string()));
            }
            diameters
        }
        (None, None) => {
            table.fault(
                "`diameters` is missing: the diameter of each grain, or `diameter` of all",
                None,
            );
            Vec::new()
        }
        (Some(_), Some(_)) => {
            table.fault_at(
                "diameters",
                "`diameter` and `diameters` exclude each other; give one of them",
            );
            Vec::new()
        }
    };
    Source::List { positions, diameters }
}

fn region(table: &TableReader<'_>) -> Region {
    let empty = Region::Box {
        lower: DVec3::NAN,
        upper: DVec3::NAN,
    };
    let meaning = "where the grains are put, as { shape = \"box\", lower = ..., upper = ... }";
    let Some(table) = table.required("region", meaning).and_then(|i| i.table()) else {
        return empty;
    };
    let shape = table.required("shape", "\"box\" or \"cylinder\"");
    let Some(shape) = shape.and_then(|i| i.choice(&["box", "cylinder"])) else {
        table.abandon();
        return empty;
    };
    if shape == 0 {
        let (lower, upper) = table.corners();
        table.finish("a region of shape \"box\"");
        return Region::Box { lower, upper };
    }
    let region = cylinder(&table);
    table.finish("a region of shape \"cylinder\"");
    region
}

/// The keys of a cylinder.
pub(super) fn cylinder(table: &TableReader<'_>) -> Region {
    let (start, end) = axis_ends(table);
    let radius = table.length("radius", "the radius of the cylinder");
    Region::Cylinder { start, end, radius }
}

/// The two ends of an axis, which must differ.
pub(super) fn axis_ends(table: &TableReader<'_>) -> (DVec3, DVec3) {
    let start = table.point("start", "the start of the axis");
    let end = table.point("end", "the end of the axis");
    if start == end {
        table.fault_at("end", "`start` and `end` are the same point");
    }
    (start, end)
}
