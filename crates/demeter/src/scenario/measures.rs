//! Tables `[[measure]]`: what is measured beside what every run measures.

use super::document::join;
use super::quantity::Kind;
use super::reader::{Item, TableReader};
use super::walls::rectangle;
use super::zones::{Named, region, selection};
use crate::measure::{BinsError, ContactNetwork, ForceDistribution, Gate, GrainTrace, MassFlow, RegionCount};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use glam::DVec3;

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
    GrainTrace(GrainTrace),
    /// Columns of the series.
    MassFlow(MassFlow),
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

/// The flows through gates of a list of measures, with their names.
pub(super) fn flows(measures: &[MeasureSpec]) -> impl Iterator<Item = (&str, &MassFlow)> {
    measures.iter().filter_map(|measure| match &measure.kind {
        MeasureKind::MassFlow(flow) => Some((measure.name.as_str(), flow)),
        _ => None,
    })
}

const FORCE: Kind = Kind::Physical(Dimension::FORCE);

const KINDS: [&str; 5] = [
    "contact-network",
    "force-distribution",
    "region-count",
    "grain-trace",
    "mass-flow",
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
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_".contains(c);
    if (1..=MAX_NAME).contains(&text.len())
        && text.starts_with(|c: char| c.is_ascii_alphanumeric())
        && text.chars().all(plain)
    {
        return text;
    }
    if matches!(&item.node.value, super::document::Value::String(_)) {
        let message = format!(
            "`{}` must be one word of 1 to {MAX_NAME} letters (a to z), digits, `-` and `_`, and begin with a letter or digit",
            item.name
        );
        let hyphens: String = text.chars().map(|c| if plain(c) { c } else { '-' }).collect();
        let hyphens = hyphens.trim_matches('-');
        let short = (1..=MAX_NAME).contains(&hyphens.len());
        item.fault(message, short.then(|| format!("write it as \"{hyphens}\"")));
    }
    String::new()
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
            zone: table.optional("region").map(|i| region(&i)).unwrap_or_default(),
            selection: selection(&table, named),
        })),
        "grain-trace" => Some(MeasureKind::GrainTrace(GrainTrace {
            selection: selection(&table, named),
        })),
        _ => Some(MeasureKind::MassFlow(mass_flow(&table, named))),
    };
    table.finish(&format!("a measure of kind `{}`", KINDS[index]));
    kind
}

/// A gate: a disc, a rectangle, or a whole plane.
fn mass_flow(table: &TableReader<'_>, named: &Named<'_>) -> MassFlow {
    let mut flow = MassFlow {
        point: DVec3::NAN,
        normal: DVec3::NAN,
        gate: Gate::Plane,
        selection: selection(table, named),
    };
    let meaning = "where it passes, as { shape = \"disc\", center = ..., normal = ..., radius = ... }";
    let Some(gate) = table.required("gate", meaning).and_then(|i| i.table()) else {
        return flow;
    };
    const SHAPES: [&str; 3] = ["plane", "disc", "rectangle"];
    let shape = gate.required("shape", "\"plane\", \"disc\" or \"rectangle\"");
    let Some(shape) = shape.and_then(|i| i.choice(&SHAPES)) else {
        gate.abandon();
        return flow;
    };
    match SHAPES[shape] {
        "plane" => flow.point = gate.point("point", "a point of the plane"),
        "disc" => {
            flow.point = gate.point("center", "the centre of the disc");
            flow.gate = Gate::Disc(gate.length("radius", "the radius of the disc"));
        }
        _ => {
            let (center, half_u, half_v) = rectangle(&gate);
            flow.point = center;
            flow.gate = Gate::Rectangle(half_u, half_v);
            // forward is the side from which half_u turns to half_v against the clock, unless it is told
            flow.normal = half_u.cross(half_v).normalize_or_zero();
        }
    }
    if SHAPES[shape] == "rectangle" {
        if let Some(item) = gate.optional("normal") {
            let along = item.direction().dot(flow.normal);
            if along.abs() < 1.0 - 1e-9 {
                item.fault("`normal` must be perpendicular to `half_u` and `half_v`", None);
            }
            flow.normal *= along.signum();
        }
    } else {
        flow.normal = gate.direction("normal", "the direction that counts as forward, as \"-z\"");
    }
    gate.finish(&format!("a gate of shape \"{}\"", SHAPES[shape]));
    flow
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
        BinsError::Reversed { .. } => "upper",
        _ => "bin",
    };
    table.fault_at(key, refused.to_string());
    None
}
