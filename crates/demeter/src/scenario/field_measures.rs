//! Measures of fields, fabrics and of grains that are followed: their tables `[[measure]]`.

use super::measures::{MeasureKind, MeasureSpec};
use super::quantity::Kind;
use super::reader::TableReader;
use super::zones::{Named, region, selection};
use crate::measure::{
    ContactAngles, Displacement, Fabric, Field, ForceChains, Kernel, KernelShape, LARGEST_CUT, LEAST_CUT, MAX_ANGLES,
    MAX_FIELD_CELLS, MAX_PATHS, MAX_RESIDENCE_BINS, Paths, Residence,
};
use crate::particles::Domain;
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;

/// Cut of a Gaussian when nothing is told, in widths.
const DEFAULT_CUT: f64 = 3.0;
/// Paths that are written when nothing is told.
const DEFAULT_PATHS: u32 = 100;
/// Largest cosine of the angle between two directions that must be perpendicular.
const PERPENDICULAR: f64 = 1e-9;

const TIME: Kind = Kind::Physical(Dimension::TIME);

/// Tells kernels so narrow that the middles of the cells, at which fields are told, miss or double much of what they spread: the sum of a
/// density over the cells is off by more than about a per cent then.
pub(super) fn check_kernels(measures: &[MeasureSpec], domain: &Domain, warnings: &mut Vec<String>) {
    for measure in measures {
        let MeasureKind::Field(field) = &measure.kind else {
            continue;
        };
        let (lower, upper) = field.corners.unwrap_or((domain.lower, domain.upper));
        let cell = |axis: usize| (upper - lower)[axis] / f64::from(field.cells[axis]);
        let widest = (0..3)
            .filter(|&axis| field.cells[axis] > 1)
            .map(cell)
            .fold(0.0, f64::max);
        let least = match field.kernel.shape {
            KernelShape::Lucy => 1.5,
            KernelShape::Gaussian { .. } => 0.6,
        };
        if field.kernel.width < least * widest {
            warnings.push(format!(
                "the kernel of field `{}` is {} m wide and its cells are up to {widest} m: what lies between the middles of cells is lost or counted \
                 twice. Let it be {least} cells wide or more, or take more cells",
                measure.name, field.kernel.width
            ));
        }
    }
}

/// Numbers of cells in three directions, at most so many in all.
pub(super) fn cells(table: &TableReader<'_>, meaning: &str, most: u64) -> [u32; 3] {
    let Some(item) = table.required("cells", meaning) else {
        return [1; 3];
    };
    let items = item.items();
    if items.len() != 3 {
        if matches!(&item.node.value, super::document::Value::Array(_)) {
            item.fault(
                format!("`cells` must be three whole numbers, found {}", items.len()),
                None,
            );
        }
        return [1; 3];
    }
    let cells = [0, 1, 2].map(|k| items[k].integer(1, i64::from(u32::MAX)) as u32);
    let all = cells.iter().fold(1u64, |all, n| all.saturating_mul(u64::from(*n)));
    if all > most {
        item.fault(format!("{all} cells are too many; at most {most}"), None);
        return [1; 3];
    }
    cells
}

/// Fields on a grid.
pub(super) fn field(table: &TableReader<'_>, named: &Named<'_>) -> Field {
    let cells = cells(
        table,
        "the number of cells in each direction, as [1, 1, 40]; one cell is the mean over the direction",
        MAX_FIELD_CELLS,
    );
    let corners = match table.has("lower") || table.has("upper") {
        true => Some(table.corners()),
        false => {
            // makes both keys known for the suggestion on a misspelt one
            table.optional("lower");
            table.optional("upper");
            if !named.has_domain {
                let help = "give `lower` and `upper`, or those of `[domain]`";
                table.fault("where is the grid, without a domain?", Some(help.to_string()));
            }
            None
        }
    };
    let kernel = table.optional("kernel").and_then(|i| i.choice(&["lucy", "gaussian"]));
    let width = match kernel {
        Some(1) => "the standard deviation of the Gaussian, as the mean radius",
        _ => "the radius of the kernel, as two mean diameters",
    };
    let width = table.length("width", width);
    let cut = table.optional("cut");
    let shape = match kernel {
        Some(1) => KernelShape::Gaussian {
            cut: cut.map_or(DEFAULT_CUT, |item| {
                let cut = item.quantity(Kind::Number, Range::POSITIVE);
                if cut.is_finite() && !(LEAST_CUT..=LARGEST_CUT).contains(&cut) {
                    let message = format!("`cut` is {cut}; a Gaussian is cut at {LEAST_CUT} to {LARGEST_CUT} widths");
                    item.fault(message, None);
                }
                cut
            }),
        },
        _ => {
            if let Some(item) = cut {
                item.fault(
                    "only a Gaussian is cut; Lucy's polynomial ends at its width",
                    Some("leave `cut` out, or say kernel = \"gaussian\"".to_string()),
                );
            }
            KernelShape::Lucy
        }
    };
    Field {
        corners,
        cells,
        kernel: Kernel { shape, width },
        zone: zone(table, named),
        selection: selection(table, named),
        sample_every: table.optional_quantity("sample_every", TIME, Range::POSITIVE),
    }
}

fn zone(table: &TableReader<'_>, named: &Named<'_>) -> crate::particles::Zone {
    table.optional("region").map(|i| region(&i, named)).unwrap_or_default()
}

/// Fabric of the contacts.
pub(super) fn fabric(table: &TableReader<'_>, named: &Named<'_>) -> Fabric {
    let force = Kind::Physical(Dimension::FORCE);
    Fabric {
        zone: zone(table, named),
        selection: selection(table, named),
        threshold: table
            .optional_quantity("threshold", force, Range::NOT_NEGATIVE)
            .unwrap_or(0.0),
        with_walls: table.optional("with_walls").is_some_and(|i| i.boolean()),
    }
}

/// Force chains.
pub(super) fn force_chains(table: &TableReader<'_>, named: &Named<'_>) -> ForceChains {
    let force = Kind::Physical(Dimension::FORCE);
    ForceChains {
        zone: zone(table, named),
        selection: selection(table, named),
        threshold: table
            .optional_quantity("threshold", force, Range::NOT_NEGATIVE)
            .unwrap_or(0.0),
        strong_only: table.optional("strong_only").is_some_and(|i| i.boolean()),
    }
}

/// Rose of contact angles.
pub(super) fn contact_angles(table: &TableReader<'_>, named: &Named<'_>) -> ContactAngles {
    let from = table.direction(
        "from",
        "the direction in the plane from which angles are counted, as \"x\"",
    );
    let towards = table.direction("towards", "the direction in the plane at 90 degrees, as \"z\"");
    if from.dot(towards).abs() > PERPENDICULAR {
        table.fault_at("towards", "`from` and `towards` must be perpendicular");
    }
    let bins = table.required("bins", "the number of bins from 0 to 180 degrees, as 36");
    ContactAngles {
        from,
        towards,
        bins: bins.map_or(1, |i| i.integer(1, i64::from(MAX_ANGLES))) as u32,
        zone: zone(table, named),
        selection: selection(table, named),
        with_walls: table.optional("with_walls").is_some_and(|i| i.boolean()),
    }
}

/// Residence times in a region.
pub(super) fn residence(table: &TableReader<'_>, named: &Named<'_>) -> Residence {
    let meaning = "where grains stay, as { shape = \"cylinder\", start = ..., end = ..., radius = ... }";
    let zone = table.required("region", meaning).map(|i| region(&i, named));
    let bin = table.optional_quantity("bin", TIME, Range::POSITIVE);
    let bins = table
        .optional("bins")
        .map(|i| i.integer(1, i64::from(MAX_RESIDENCE_BINS)) as u32);
    if bin.is_some() != bins.is_some() {
        let (told, missing) = if bin.is_some() {
            ("bin", "bins")
        } else {
            ("bins", "bin")
        };
        let help = "give both `bin`, the width of the bins as \"0.5 s\", and `bins`, their number, or none";
        table.fault(
            format!("`{told}` is told and `{missing}` is not"),
            Some(help.to_string()),
        );
    }
    Residence {
        zone: zone.unwrap_or_default(),
        selection: selection(table, named),
        bins: bin.zip(bins),
    }
}

/// Displacements.
pub(super) fn displacement(table: &TableReader<'_>, named: &Named<'_>) -> Displacement {
    Displacement {
        selection: selection(table, named),
        from: table
            .optional_quantity("from", TIME, Range::NOT_NEGATIVE)
            .unwrap_or(0.0),
    }
}

/// Paths of grains.
pub(super) fn paths(table: &TableReader<'_>, named: &Named<'_>) -> Paths {
    Paths {
        selection: selection(table, named),
        most: table
            .optional("most")
            .map_or(DEFAULT_PATHS, |i| i.integer(1, i64::from(MAX_PATHS)) as u32),
    }
}
