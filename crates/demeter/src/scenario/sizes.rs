//! Diameters of grains: one, or a distribution.

use super::document::Value;
use super::quantity::Kind;
use super::reader::{Item, TableReader};
use crate::insertion::{Basis, SizeDistribution};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;

const LENGTH: Kind = Kind::Physical(Dimension::LENGTH);
/// Most entries of a list or table of diameters.
const MAX_ENTRIES: usize = 1_000_000;
/// Where a normal or lognormal distribution is cut when no bounds are told, in standard deviations.
const CUT: f64 = 3.0;
/// How far the shares of a cumulative table may be from 0 and 1.
const TOLERANCE: f64 = 1e-9;
/// Kinds of distributions.
const DISTRIBUTIONS: [&str; 6] = ["list", "uniform", "normal", "lognormal", "rosin-rammler", "table"];

/// Key `diameter` of a table: `"2 mm"`, or a table that tells a distribution.
pub(super) fn diameter(table: &TableReader<'_>) -> SizeDistribution {
    let Some(item) = table.required("diameter", "the diameter of the grains, as \"2 mm\", or a distribution") else {
        return SizeDistribution::Single(f64::NAN);
    };
    match &item.node.value {
        Value::Table(_) => item.table().map_or(SizeDistribution::Single(f64::NAN), distribution),
        _ => SizeDistribution::Single(item.quantity(LENGTH, Range::POSITIVE)),
    }
}

fn distribution(table: TableReader<'_>) -> SizeDistribution {
    let meaning = "\"list\", \"uniform\", \"normal\", \"lognormal\", \"rosin-rammler\" or \"table\"";
    let kind = table.required("distribution", meaning);
    let Some(kind) = kind.and_then(|i| i.choice(&DISTRIBUTIONS)) else {
        table.abandon();
        return SizeDistribution::Single(f64::NAN);
    };
    let read = match kind {
        0 => list(&table),
        1 => {
            let (lower, upper) = bounds(&table, None);
            SizeDistribution::Uniform { lower, upper }
        }
        2 => normal(&table),
        3 => lognormal(&table),
        4 => {
            let (lower, upper) = bounds(&table, None);
            SizeDistribution::RosinRammler {
                scale: table.length("scale", "the diameter at which 63.2 % of the mass is finer"),
                exponent: table.quantity("exponent", Kind::Number, Range::POSITIVE, "the spread, as 3"),
                lower,
                upper,
            }
        }
        _ => cumulative(&table),
    };
    table.finish(&format!("a {} distribution", DISTRIBUTIONS[kind]));
    read
}

/// Smallest and largest diameter, from `automatic` where they are not told.
fn bounds(table: &TableReader<'_>, automatic: Option<(f64, f64)>) -> (f64, f64) {
    let read = |key: &str, meaning: &str, automatic: Option<f64>| match automatic {
        Some(value) => table.optional_quantity(key, LENGTH, Range::POSITIVE).unwrap_or(value),
        None => table.length(key, meaning),
    };
    let lower = read("lower", "the smallest diameter", automatic.map(|a| a.0));
    let upper = read("upper", "the largest diameter", automatic.map(|a| a.1));
    if upper < lower {
        let message = format!("the largest diameter, {upper} m, must not be below the smallest, {lower} m");
        table.fault_at("upper", message);
    }
    (lower, upper)
}

fn normal(table: &TableReader<'_>) -> SizeDistribution {
    let mean = table.length("mean", "the mean diameter");
    let standard_deviation = table.length("standard_deviation", "the standard deviation of the diameter");
    let automatic = (mean - CUT * standard_deviation, mean + CUT * standard_deviation);
    if automatic.0 <= 0.0 && !table.has("lower") {
        let help = "give `lower`, the smallest diameter";
        table.fault(
            format!(
                "the mean less {CUT} standard deviations is no diameter: {} m",
                automatic.0
            ),
            Some(help.to_string()),
        );
    }
    let (lower, upper) = bounds(table, Some(automatic));
    check_mean_inside(table, "mean", mean, (lower, upper));
    SizeDistribution::Normal {
        mean,
        standard_deviation,
        lower,
        upper,
    }
}

fn lognormal(table: &TableReader<'_>) -> SizeDistribution {
    let median = table.length("median", "the median diameter");
    let spread = Range::new(1.0, false, 100.0, true);
    let meaning = "the geometric standard deviation, above 1";
    let geometric_deviation = table.quantity("geometric_deviation", Kind::Number, spread, meaning);
    let factor = geometric_deviation * geometric_deviation * geometric_deviation;
    let (lower, upper) = bounds(table, Some((median / factor, median * factor)));
    check_mean_inside(table, "median", median, (lower, upper));
    SizeDistribution::Lognormal {
        median,
        geometric_deviation,
        lower,
        upper,
    }
}

/// The centre of a distribution lies between its bounds, or nearly all draws would be thrown away.
fn check_mean_inside(table: &TableReader<'_>, key: &str, value: f64, (lower, upper): (f64, f64)) {
    if lower <= upper && (value < lower || value > upper) {
        let bounds = format!("{lower} m and {upper} m");
        let message = format!("`{key}` must lie between the smallest and the largest diameter, {bounds}");
        table.fault_at(key, message);
    }
}

fn list(table: &TableReader<'_>) -> SizeDistribution {
    let diameters = table.required("diameters", "a list of diameters");
    let diameters = diameters.map_or_else(Vec::new, |i| positive_lengths(&i));
    let shares = match table.required("shares", "how often each diameter occurs, as [1, 2, 1]") {
        None => Vec::new(),
        Some(item) => {
            let shares = numbers(&item, Kind::Number, Range::NOT_NEGATIVE);
            if shares.len() != diameters.len() && table.has("diameters") {
                item.fault(
                    format!("{} shares for {} diameters", shares.len(), diameters.len()),
                    None,
                );
            }
            if !shares.is_empty() && shares.iter().all(|s| *s == 0.0) {
                item.fault("all shares are 0", None);
            }
            shares
        }
    };
    SizeDistribution::List {
        diameters,
        shares,
        basis: basis(table),
    }
}

fn cumulative(table: &TableReader<'_>) -> SizeDistribution {
    let diameters = match table.required("diameters", "a list of rising diameters") {
        None => Vec::new(),
        Some(item) => {
            let diameters = positive_lengths(&item);
            check_rising(&item, &diameters, true);
            diameters
        }
    };
    let finer = match table.required("finer", "the share of grains finer than each diameter, from 0 to 1") {
        None => Vec::new(),
        Some(item) => {
            let finer = numbers(&item, Kind::Number, Range::SHARE);
            check_rising(&item, &finer, false);
            if finer.len() != diameters.len() && table.has("diameters") {
                item.fault(
                    format!("{} shares for {} diameters", finer.len(), diameters.len()),
                    None,
                );
            }
            let (first, last) = (finer.first().copied(), finer.last().copied());
            if finer.len() < 2 || first.is_some_and(|f| f > TOLERANCE) || last.is_some_and(|l| l < 1.0 - TOLERANCE) {
                item.fault("`finer` must begin with 0 and end with 1", None);
            }
            finer
        }
    };
    SizeDistribution::Table {
        diameters,
        finer,
        basis: basis(table),
    }
}

fn check_rising(item: &Item<'_>, values: &[f64], strictly: bool) {
    let falls = |w: &[f64]| if strictly { w[1] <= w[0] } else { w[1] < w[0] };
    if let Some(at) = values.windows(2).position(falls) {
        let path = format!("{}[{}]", item.path, at + 1);
        let message = format!("`{}` must rise from entry to entry", item.name);
        item.context.fault(&path, message, None);
    }
}

fn basis(table: &TableReader<'_>) -> Basis {
    let item = table.required("basis", "whether shares are by \"number\" or by \"mass\"");
    match item.and_then(|i| i.choice(&["number", "mass"])) {
        Some(1) => Basis::Mass,
        _ => Basis::Number,
    }
}

/// A list of positive lengths, not empty.
pub(super) fn positive_lengths(item: &Item<'_>) -> Vec<f64> {
    numbers(item, LENGTH, Range::POSITIVE)
}

fn numbers(item: &Item<'_>, kind: Kind, range: Range) -> Vec<f64> {
    let items = item.items();
    if matches!(item.node.value, Value::Array(_)) && (items.is_empty() || items.len() > MAX_ENTRIES) {
        item.fault(format!("`{}` must have 1 to {MAX_ENTRIES} entries", item.name), None);
    }
    items
        .iter()
        .take(MAX_ENTRIES)
        .map(|i| i.quantity(kind, range))
        .collect()
}
