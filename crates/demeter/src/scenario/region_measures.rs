//! Measures of flows, mixtures, surfaces and slices: their tables `[[measure]]`.

use super::field_measures::cells;
use super::grains::axis_ends;
use super::measures::{MeasureKind, MeasureSpec};
use super::quantity::Kind;
use super::reader::TableReader;
use super::walls::rectangle;
use super::zones::{Named, region, selection};
use crate::measure::{
    Along, CylinderProfile, Gate, MAX_CELLS, MAX_NEAREST, MAX_SLICES, MassFlow, Mixing, MixingSpace, NeighbourMixing,
    Profile, Selection, Slope,
};
use crate::particles::{Domain, Grains, Outside};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use glam::DVec3;
use std::f64::consts::PI;

/// Most bins of a surface.
const MAX_BINS: i64 = 10_000;
/// Nearest neighbours that are looked at when nothing is told.
const DEFAULT_NEAREST: u32 = 6;
/// Largest cosine of the angle between the direction of a slope and the horizontal.
const HORIZONTAL: f64 = 1e-9;

/// A gate: a disc, a rectangle, or a whole plane.
pub(super) fn mass_flow(table: &TableReader<'_>, named: &Named<'_>) -> MassFlow {
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

/// Tells gates that grains cannot be seen to pass, as they are removed where they leave the domain: a look every few steps finds them
/// before the gate, and not behind it.
pub(super) fn check_gates(measures: &[MeasureSpec], grains: &Grains, domain: &Domain, warnings: &mut Vec<String>) {
    if domain.outside != Outside::Remove {
        return;
    }
    let room = grains.radii().fold(0.0, f64::max);
    for measure in measures {
        let MeasureKind::MassFlow(flow) = &measure.kind else {
            continue;
        };
        for axis in (0..3).filter(|&k| !domain.periodic[k] && flow.normal[k].abs() > 0.99) {
            let behind = [
                flow.point[axis] - domain.lower[axis],
                domain.upper[axis] - flow.point[axis],
            ];
            if behind.into_iter().any(|way| way < room) {
                warnings.push(format!(
                    "the gate of measure `{}` is closer than a grain's radius to a side of the domain, {} m of {} to {} m along {}: grains that leave \
                     there are removed before they are seen behind the gate, and do not count. Let the domain reach beyond the gate",
                    measure.name,
                    flow.point[axis],
                    domain.lower[axis],
                    domain.upper[axis],
                    ["x", "y", "z"][axis]
                ));
            }
        }
    }
}

/// Tells cells of a mixing index that hold no whole grain: each then counts one kind alone.
pub(super) fn check_cells(measures: &[MeasureSpec], grains: &Grains, warnings: &mut Vec<String>) {
    let largest = 2.0 * grains.radii().fold(0.0, f64::max);
    for measure in measures {
        let MeasureKind::Mixing(mixing) = &measure.kind else {
            continue;
        };
        let all = match mixing.space {
            MixingSpace::Box { lower, upper } => (upper - lower).element_product(),
            MixingSpace::Cylinder { start, end, radius } => PI * radius * radius * (end - start).length(),
        };
        let cell = all / mixing.cells.iter().map(|&count| f64::from(count)).product::<f64>();
        if cell < PI / 6.0 * largest * largest * largest {
            warnings.push(format!(
                "the cells of measure `{}` are smaller than a grain, {cell:.3e} m^3 each, and grains are up to {largest:.3e} m in diameter: a \
                 cell holds one grain at most, and looks unmixed. Take fewer cells, some grains wide each",
                measure.name
            ));
        }
    }
}

/// A mixing index: the cells of a box or a cylinder, and the kind whose share is looked at.
pub(super) fn mixing(table: &TableReader<'_>, named: &Named<'_>) -> Mixing {
    let is_round = match table.has("start") || table.has("end") || table.has("radius") {
        true => true,
        false => {
            // makes these keys known for the suggestion on a misspelt one
            ["start", "end", "radius"].into_iter().for_each(|key| {
                table.optional(key);
            });
            false
        }
    };
    let space = match is_round {
        true => {
            let (start, end, radius) = cylinder(table);
            MixingSpace::Cylinder { start, end, radius }
        }
        false => {
            let (lower, upper) = table.corners();
            MixingSpace::Box { lower, upper }
        }
    };
    let meaning = match is_round {
        true => "the number of cells outwards, around and along the axis, as [5, 8, 1]",
        false => "the number of cells in each direction, as [10, 1, 10]",
    };
    let cells = cells(table, meaning, MAX_CELLS);
    let selection = kind(table, named);
    Mixing {
        space,
        cells,
        selection,
    }
}

/// Axis and radius of a cylinder.
fn cylinder(table: &TableReader<'_>) -> (DVec3, DVec3, f64) {
    let (start, end) = axis_ends(table);
    (start, end, table.length("radius", "the radius of the cylinder"))
}

/// The kind that is mixed with all others.
fn kind(table: &TableReader<'_>, named: &Named<'_>) -> Selection {
    let chosen = ["material", "batch", "ids", "tag", "finer_than", "coarser_than"]
        .iter()
        .any(|key| table.has(key));
    let selection = selection(table, named);
    if !chosen {
        let help = "name the kind by `material`, `batch`, `ids`, `tag`, `finer_than` or `coarser_than`";
        table.fault("which grains are mixed with the others?", Some(help.to_string()));
    }
    selection
}

/// A mixing index of neighbours.
pub(super) fn neighbour_mixing(table: &TableReader<'_>, named: &Named<'_>) -> NeighbourMixing {
    NeighbourMixing {
        zone: table.optional("region").map(|i| region(&i, named)).unwrap_or_default(),
        nearest: table
            .optional("nearest")
            .map_or(DEFAULT_NEAREST, |i| i.integer(1, i64::from(MAX_NEAREST)) as u32),
        selection: kind(table, named),
    }
}

/// Rings or slices of a cylinder.
pub(super) fn cylinder_profile(table: &TableReader<'_>, named: &Named<'_>) -> CylinderProfile {
    let (start, end, radius) = cylinder(table);
    let along = table.required("along", "\"radius\" for rings, \"axis\" for slices");
    let bins = table.required("bins", "the number of rings or slices, as 20");
    CylinderProfile {
        start,
        end,
        radius,
        along: match along.and_then(|i| i.choice(&["radius", "axis"])) {
            Some(1) => Along::Axis,
            _ => Along::Radius,
        },
        bins: bins.map_or(1, |i| i.integer(1, i64::from(MAX_SLICES))) as u32,
        selection: selection(table, named),
    }
}

/// The surface of a packing along a direction, or around an axis.
pub(super) fn slope(table: &TableReader<'_>, named: &Named<'_>) -> Slope {
    let point = table.point(
        "point",
        "where distances are counted from; of a heap, a point of its axis",
    );
    let along = table.optional("along").map(|item| (item.direction(), item));
    let up = match table.optional("up") {
        Some(item) => item.direction(),
        None if named.gravity == DVec3::ZERO => {
            let help = "give `up`, a direction, or `simulation.gravity`";
            table.fault("which way is up, without gravity?", Some(help.to_string()));
            DVec3::NAN
        }
        None => -named.gravity.normalize(),
    };
    if let Some((along, item)) = &along
        && along.dot(up).abs() > HORIZONTAL
    {
        item.fault("`along` must be horizontal", None);
    }
    let length = Kind::Physical(Dimension::LENGTH);
    let mut between = (f64::NAN, f64::NAN);
    if let Some(item) = table.required("between", "the distances of the surface, as [\"0 mm\", \"30 mm\"]") {
        let items = item.items();
        if let [from, to] = items.as_slice() {
            between = (from.quantity(length, Range::FINITE), to.quantity(length, Range::FINITE));
            if between.1 <= between.0 {
                item.fault("the second distance must be larger than the first", None);
            } else if between.0 < 0.0 && along.is_none() {
                let help = "begin at \"0 mm\", or tell `along`, the direction of the distances";
                from.fault("a distance from an axis is never negative", Some(help.to_string()));
            }
        } else if matches!(&item.node.value, super::document::Value::Array(_)) {
            item.fault(format!("`between` must be two distances, found {}", items.len()), None);
        }
    }
    let bins = table.required("bins", "the number of bins, as 10");
    Slope {
        point,
        along: along.map(|(along, _)| along),
        up,
        between,
        bins: bins.map_or(2, |i| i.integer(2, MAX_BINS)) as u32,
        zone: table.optional("region").map(|i| region(&i, named)).unwrap_or_default(),
        selection: selection(table, named),
    }
}

/// Slices of a box.
pub(super) fn profile(table: &TableReader<'_>, named: &Named<'_>) -> Profile {
    let (lower, upper) = table.corners();
    let axis = table.required("axis", "the axis across the slices, \"x\", \"y\" or \"z\"");
    let slices = table.required("slices", "the number of slices, as 20");
    Profile {
        lower,
        upper,
        axis: axis.and_then(|i| i.choice(&["x", "y", "z"])).unwrap_or(0),
        slices: slices.map_or(1, |i| i.integer(1, i64::from(MAX_SLICES))) as u32,
        selection: selection(table, named),
    }
}
