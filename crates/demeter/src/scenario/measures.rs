//! Tables `[[measure]]`: what is measured beside what every run measures.

use super::collisions::collisions;
use super::document::join;
use super::field_measures::{contact_angles, displacement, fabric, field, force_chains, paths, residence};
use super::quantity::Kind;
use super::reader::{Item, TableReader};
use super::region_measures::{cylinder_profile, mass_flow, mixing, neighbour_mixing, profile, slope};
use super::stages::walls_of;
use super::zones::{Named, region, selection};
use crate::measure::{
    BinsError, Collisions, ContactAngles, ContactNetwork, CylinderProfile, Displacement, Extent, Fabric, Field,
    ForceChains, ForceDistribution, GrainTrace, MassFlow, Mixing, NeighbourMixing, Paths, Profile, RegionCount,
    Residence, Selection, Slope, WallsLoad,
};
use crate::particles::Zone;
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;

/// Most measures.
pub const MAX_MEASURES: usize = 100;
/// Longest name of a measure; it is a part of titles of columns, and names a file.
const MAX_NAME: usize = 60;

/// A measure as the scenario tells it.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasureSpec {
    /// Name, unique whatever the case: letters, digits, hyphens and underscores.
    pub name: String,
    /// What is measured.
    pub kind: MeasureKind,
}

/// What is measured.
#[derive(Clone, Debug, PartialEq)]
pub enum MeasureKind {
    /// Columns of the series.
    ContactNetwork(ContactNetwork),
    /// A file of its own.
    ForceDistribution(ForceDistribution),
    /// Columns of the series.
    RegionCount(RegionCount),
    /// Columns of the series.
    Extent(Extent),
    /// Columns of the series.
    GrainTrace(GrainTrace),
    /// Columns of the series.
    MassFlow(MassFlow),
    /// Columns of the series.
    Mixing(Mixing),
    /// Columns of the series.
    Slope(Slope),
    /// A file of its own.
    Profile(Profile),
    /// Files of their own, with every frame.
    Field(Field),
    /// Columns of the series.
    Fabric(Fabric),
    /// A file of its own.
    ContactAngles(ContactAngles),
    /// Columns of the series, and a file of its own.
    Residence(Residence),
    /// Columns of the series.
    Displacement(Displacement),
    /// Files of their own.
    Paths(Paths),
    /// Files of their own, with every frame.
    ForceChains(ForceChains),
    /// Columns of the series.
    NeighbourMixing(NeighbourMixing),
    /// A file of its own.
    CylinderProfile(CylinderProfile),
    /// Columns of the series, and a file of its own.
    Collisions(Collisions),
    /// Columns of the series.
    WallsLoad(WallsLoad),
}

impl MeasureKind {
    /// Which grains it is about, where it is about some alone.
    pub(super) fn selection(&self) -> Option<&Selection> {
        Some(match self {
            Self::ContactNetwork(_) | Self::ForceDistribution(_) | Self::WallsLoad(_) => return None,
            Self::RegionCount(count) => &count.selection,
            Self::Extent(extent) => &extent.selection,
            Self::GrainTrace(trace) => &trace.selection,
            Self::MassFlow(flow) => &flow.selection,
            Self::Mixing(mixing) => &mixing.selection,
            Self::Slope(slope) => &slope.selection,
            Self::Profile(profile) => &profile.selection,
            Self::Field(field) => &field.selection,
            Self::Fabric(fabric) => &fabric.selection,
            Self::ContactAngles(angles) => &angles.selection,
            Self::Residence(residence) => &residence.selection,
            Self::Displacement(displacement) => &displacement.selection,
            Self::Paths(paths) => &paths.selection,
            Self::ForceChains(chains) => &chains.selection,
            Self::NeighbourMixing(mixing) => &mixing.selection,
            Self::CylinderProfile(profile) => &profile.selection,
            Self::Collisions(collisions) => &collisions.selection,
        })
    }

    /// Which part of space it is about, where it is about a region.
    pub(super) fn zone(&self) -> Option<&Zone> {
        Some(match self {
            Self::RegionCount(count) => &count.zone,
            Self::Extent(extent) => &extent.zone,
            Self::Slope(slope) => &slope.zone,
            Self::Field(field) => &field.zone,
            Self::Fabric(fabric) => &fabric.zone,
            Self::ContactAngles(angles) => &angles.zone,
            Self::Residence(residence) => &residence.zone,
            Self::ForceChains(chains) => &chains.zone,
            Self::NeighbourMixing(mixing) => &mixing.zone,
            Self::Collisions(collisions) => &collisions.zone,
            _ => return None,
        })
    }
}

/// The contact networks of a list of measures, with their names.
pub(super) fn networks(measures: &[MeasureSpec]) -> impl Iterator<Item = (&str, &ContactNetwork)> {
    measures.iter().filter_map(|measure| match &measure.kind {
        MeasureKind::ContactNetwork(network) => Some((measure.name.as_str(), network)),
        _ => None,
    })
}

/// The force distributions of a list of measures, with their names.
pub(super) fn distributions(measures: &[MeasureSpec]) -> impl Iterator<Item = (&str, &ForceDistribution)> {
    measures.iter().filter_map(|measure| match &measure.kind {
        MeasureKind::ForceDistribution(bins) => Some((measure.name.as_str(), bins)),
        _ => None,
    })
}

/// The profiles of a list of measures, with their names.
pub(super) fn profiles(measures: &[MeasureSpec]) -> impl Iterator<Item = (&str, &Profile)> {
    measures.iter().filter_map(|measure| match &measure.kind {
        MeasureKind::Profile(profile) => Some((measure.name.as_str(), profile)),
        _ => None,
    })
}

const FORCE: Kind = Kind::Physical(Dimension::FORCE);

const KINDS: [&str; 20] = [
    "contact-network",
    "force-distribution",
    "region-count",
    "extent",
    "grain-trace",
    "mass-flow",
    "mixing",
    "surface-slope",
    "profile",
    "field",
    "fabric",
    "contact-angles",
    "residence",
    "displacement",
    "paths",
    "force-chains",
    "neighbour-mixing",
    "cylinder-profile",
    "collisions",
    "walls-load",
];

pub(super) fn measures(root: &TableReader<'_>, named: &Named<'_>) -> Vec<MeasureSpec> {
    let Some(item) = root.optional("measure") else {
        return Vec::new();
    };
    let tables = item.tables("measure");
    if tables.len() > MAX_MEASURES {
        item.fault(
            format!("{} measures are too many; at most {MAX_MEASURES}", tables.len()),
            None,
        );
    }
    let mut measures = Vec::new();
    let mut names: Vec<String> = Vec::new();
    for table in tables.into_iter().take(MAX_MEASURES) {
        let path = join(&table.path, "name");
        let name = table
            .required("name", "the name of the measure, for its columns or its file")
            .map_or_else(String::new, |item| word(&item));
        let other = names.iter().find(|n| n.eq_ignore_ascii_case(&name));
        if let (Some(other), false) = (other, name.is_empty()) {
            let mut message = format!("two measures are named `{name}`");
            if *other != name {
                message = format!("measures are named `{other}` and `{name}`, which is one name where case is ignored");
            }
            item.context.fault(&path, message, None);
        }
        names.push(name.clone());
        if let Some(kind) = kind(table, named) {
            measures.push(MeasureSpec { name, kind });
        }
    }
    measures
}

/// A name that is a file name everywhere, and one word in the title of a column; empty when it is none.
fn word(item: &Item<'_>) -> String {
    let text = item.text();
    match of_one_word(&text) {
        Ok(()) => return text,
        Err((rule, instead)) if matches!(&item.node.value, super::document::Value::String(_)) => {
            item.fault(format!("`{}` must be {rule}", item.name), instead);
        }
        Err(_) => {}
    }
    String::new()
}

/// What a name of a file must be, and what this one could be, where it is not that.
pub(super) fn of_one_word(text: &str) -> Result<(), (String, Option<String>)> {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_".contains(c);
    if (1..=MAX_NAME).contains(&text.len())
        && text.starts_with(|c: char| c.is_ascii_alphanumeric())
        && text.chars().all(plain)
    {
        return Ok(());
    }
    let rule =
        format!("one word of 1 to {MAX_NAME} letters (a to z), digits, `-` and `_`, and begin with a letter or digit");
    let hyphens: String = text.chars().map(|c| if plain(c) { c } else { '-' }).collect();
    let hyphens = hyphens.trim_matches('-');
    let short = (1..=MAX_NAME).contains(&hyphens.len());
    Err((rule, short.then(|| format!("write it as \"{hyphens}\""))))
}

fn kind(table: TableReader<'_>, named: &Named<'_>) -> Option<MeasureKind> {
    let meaning = "what is measured, as \"region-count\" or \"contact-network\"";
    let index = table.required("kind", meaning).and_then(|item| item.choice(&KINDS));
    let Some(index) = index else {
        table.abandon();
        return None;
    };
    let kind = match KINDS[index] {
        "contact-network" => Some(MeasureKind::ContactNetwork(contact_network(&table))),
        "force-distribution" => force_distribution(&table).map(MeasureKind::ForceDistribution),
        "region-count" => Some(MeasureKind::RegionCount(RegionCount {
            zone: table.optional("region").map(|i| region(&i, named)).unwrap_or_default(),
            selection: selection(&table, named),
        })),
        "extent" => Some(MeasureKind::Extent(Extent {
            zone: table.optional("region").map(|i| region(&i, named)).unwrap_or_default(),
            selection: selection(&table, named),
        })),
        "grain-trace" => Some(MeasureKind::GrainTrace(GrainTrace {
            selection: selection(&table, named),
        })),
        "mass-flow" => Some(MeasureKind::MassFlow(mass_flow(&table, named))),
        "mixing" => Some(MeasureKind::Mixing(mixing(&table, named))),
        "surface-slope" => Some(MeasureKind::Slope(slope(&table, named))),
        "profile" => Some(MeasureKind::Profile(profile(&table, named))),
        "field" => Some(MeasureKind::Field(field(&table, named))),
        "fabric" => Some(MeasureKind::Fabric(fabric(&table, named))),
        "contact-angles" => Some(MeasureKind::ContactAngles(contact_angles(&table, named))),
        "residence" => Some(MeasureKind::Residence(residence(&table, named))),
        "displacement" => Some(MeasureKind::Displacement(displacement(&table, named))),
        "paths" => Some(MeasureKind::Paths(paths(&table, named))),
        "force-chains" => Some(MeasureKind::ForceChains(force_chains(&table, named))),
        "neighbour-mixing" => Some(MeasureKind::NeighbourMixing(neighbour_mixing(&table, named))),
        "walls-load" => Some(MeasureKind::WallsLoad(walls_load(&table, named))),
        "collisions" => Some(MeasureKind::Collisions(collisions(&table, named))),
        _ => Some(MeasureKind::CylinderProfile(cylinder_profile(&table, named))),
    };
    table.finish(&format!("a measure of kind `{}`", KINDS[index]));
    kind
}

fn walls_load(table: &TableReader<'_>, named: &Named<'_>) -> WallsLoad {
    WallsLoad {
        walls: walls_of(table, named.walls),
        point: table.vector_or_zero("point", Kind::Physical(Dimension::LENGTH)),
        axis: table.optional("axis").map(|item| item.direction()),
    }
}

fn contact_network(table: &TableReader<'_>) -> ContactNetwork {
    let default = ContactNetwork::default();
    let region = table.has("lower") || table.has("upper");
    if !region {
        // makes both keys known for the suggestion on a misspelt one
        table.optional("lower");
        table.optional("upper");
    }
    ContactNetwork {
        threshold: table
            .optional_quantity("threshold", FORCE, Range::NOT_NEGATIVE)
            .unwrap_or(default.threshold),
        margin: table
            .optional_quantity("margin", Kind::Number, Range::NOT_NEGATIVE)
            .unwrap_or(default.margin),
        region: region.then(|| table.corners()),
    }
}

fn force_distribution(table: &TableReader<'_>) -> Option<ForceDistribution> {
    let lower = table.optional_quantity("lower", FORCE, Range::FINITE).unwrap_or(0.0);
    let upper = table.quantity("upper", FORCE, Range::FINITE, "the force at which the last bin ends");
    let bin = table.quantity("bin", FORCE, Range::POSITIVE, "the width of the bins, a force");
    if [lower, upper, bin].iter().any(|x| x.is_nan()) {
        return None;
    }
    let refused = match ForceDistribution::new(lower, upper, bin) {
        Ok(bins) => return Some(bins),
        Err(refused) => refused,
    };
    let key = match refused {
        BinsError::Reversed { .. } | BinsError::NotWhole { .. } => "upper",
        _ => "bin",
    };
    table.fault_at(key, refused.to_string());
    None
}
