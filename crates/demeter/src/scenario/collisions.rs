//! The measure of collisions: its table `[[measure]]`.

use super::materials::material_index;
use super::quantity::Kind;
use super::reader::TableReader;
use super::zones::{Named, region, selection};
use crate::measure::{Collisions, EnergyBins, MAX_ENERGY_BINS};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;

const ENERGY: Kind = Kind::Physical(Dimension::ENERGY);

/// Collisions.
pub(super) fn collisions(table: &TableReader<'_>, named: &Named<'_>) -> Collisions {
    Collisions {
        zone: table.optional("region").map(|i| region(&i, named)).unwrap_or_default(),
        selection: selection(table, named),
        partner: table
            .optional("partner")
            .map(|item| material_index(&item, named.around.materials)),
        bins: bins(table),
    }
}

fn bins(table: &TableReader<'_>) -> Option<EnergyBins> {
    let energy = |key: &str| table.optional_quantity(key, ENERGY, Range::POSITIVE);
    let (lower, upper) = (energy("lower"), energy("upper"));
    let count = table
        .optional("bins")
        .map(|i| i.integer(1, i64::from(MAX_ENERGY_BINS)) as u32);
    let told = [lower.is_some(), upper.is_some(), count.is_some()];
    let (Some(lower), Some(upper), Some(count)) = (lower, upper, count) else {
        if told.contains(&true) {
            let keys = ["lower", "upper", "bins"].into_iter().zip(told);
            let missing: Vec<String> = keys
                .filter(|(_, is_told)| !is_told)
                .map(|(key, _)| format!("`{key}`"))
                .collect();
            let help = "give `lower` and `upper`, the energies at which the first bin begins and the last ends, as \"1 nJ\" and \"1 mJ\", and \
                        `bins`, their number, or none of them";
            table.fault(
                format!("bins of energies lack {}", missing.join(" and ")),
                Some(help.to_string()),
            );
        }
        return None;
    };
    // what is no number was told already
    if [lower, upper].iter().any(|x| x.is_nan()) {
        return None;
    }
    let bins = EnergyBins::new(lower, upper, count);
    if bins.is_none() {
        table.fault_at(
            "upper",
            format!("{count} bins from {lower} J to {upper} J: they must end above their beginning, with edges that 12 digits tell apart"),
        );
    }
    bins
}
