//! Distributions of the last state.

use super::figures::{number, quantity};
use super::packing::mean;
use crate::results::Packing;
use serde_json::{Value, json};

/// Bins of a distribution of forces or overlaps.
const BINS: usize = 50;
/// Most bins of a coordination histogram; grains with more contacts are counted in the last.
const MOST_CONTACTS: u32 = 200;

/// A histogram with the sentence that tells what it holds.
pub(super) struct Distribution {
    /// Which one, for the page.
    pub key: &'static str,
    pub title: &'static str,
    /// Mean, extremes, counts.
    pub told: String,
    /// Nothing where there is nothing to count.
    pub data: Option<Value>,
}

/// All distributions of a state.
pub(super) fn distributions(packing: &Packing) -> [Distribution; 3] {
    [forces(packing), overlaps(packing), coordination(packing)]
}

fn forces(packing: &Packing) -> Distribution {
    let c = &packing.contacts;
    let finite = || c.normal.iter().copied().filter(|f| f.is_finite());
    let told = match (mean(finite()), finite().reduce(f64::max)) {
        (Some(mean), Some(largest)) => format!(
            "{} contacts, mean normal force {}, largest {}; repulsion is positive.",
            c.normal.len(),
            quantity(mean, "N"),
            quantity(largest, "N")
        ),
        _ => "No contact carries a force in this state.".to_string(),
    };
    Distribution {
        key: "forces",
        title: "Normal forces",
        told,
        data: by_partner(packing, &c.normal, "normal force", "N"),
    }
}

fn overlaps(packing: &Packing) -> Distribution {
    let shares: Vec<f64> = packing.relative_overlaps().iter().map(|share| 100.0 * share).collect();
    let largest = shares.iter().copied().filter(|v| v.is_finite()).reduce(f64::max);
    let told = match (mean(shares.iter().copied()), largest) {
        (Some(mean), Some(largest)) => format!(
            "Mean overlap {} % of the smaller radius, largest {} %.",
            number(mean),
            number(largest)
        ),
        _ => "No contact acts in this state.".to_string(),
    };
    Distribution {
        key: "overlaps",
        title: "Overlaps",
        told,
        data: by_partner(packing, &shares, "overlap over smaller radius", "%"),
    }
}

fn coordination(packing: &Packing) -> Distribution {
    let z = &packing.grains.coordination;
    let alone = z.iter().filter(|z| **z == 0).count();
    let told = match mean(z.iter().map(|z| f64::from(*z))) {
        Some(mean) => format!(
            "Mean number of contacts per grain {}, walls counted; {alone} of {} grains have none.",
            number(mean),
            z.len()
        ),
        None => "There is no grain in this state.".to_string(),
    };
    let most = z.iter().copied().max().unwrap_or(0).min(MOST_CONTACTS);
    let mut counts = vec![0_u64; most as usize + 1];
    for z in z {
        counts[(*z).min(most) as usize] += 1;
    }
    Distribution {
        key: "coordination",
        title: "Coordination",
        told,
        data: (!z.is_empty()).then(|| {
            json!({
                "x": "contacts of a grain", "unit": "", "low": -0.5, "width": 1.0, "of": "grains",
                "lines": [{ "name": "grains", "counts": counts }],
            })
        }),
    }
}

/// Counts contacts between grains apart from those with walls.
fn by_partner(packing: &Packing, values: &[f64], x: &str, unit: &str) -> Option<Value> {
    let finite = || values.iter().copied().filter(|v| v.is_finite());
    let (low, high) = (finite().fold(0.0, f64::min), finite().reduce(f64::max)?.max(0.0));
    let width = if high > low { (high - low) / BINS as f64 } else { 1.0 };
    let mut counts = [vec![0_u64; BINS], vec![0_u64; BINS]];
    for (value, wall) in values.iter().zip(&packing.contacts.wall).filter(|(v, _)| v.is_finite()) {
        // the cast takes rounding below the first bin to it
        let bin = (((value - low) / width) as usize).min(BINS - 1);
        counts[usize::from(*wall >= 0)][bin] += 1;
    }
    let [grains, walls] = counts;
    let mut lines = vec![json!({ "name": "between grains", "counts": grains })];
    if walls.iter().any(|count| *count > 0) {
        lines.push(json!({ "name": "with walls", "counts": walls }));
    }
    Some(json!({ "x": x, "unit": unit, "low": low, "width": width, "of": "contacts", "lines": lines }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::results::{PackedContacts as Contacts, PackedGrains as Grains};

    fn packing(normal: &[f64], wall: &[i32]) -> Packing {
        Packing {
            grains: Grains {
                id: vec![1, 2],
                radius: vec![1.0, 2.0],
                coordination: vec![0, 3],
                ..Grains::default()
            },
            contacts: Contacts {
                id_i: vec![1; normal.len()],
                id_j: vec![2; normal.len()],
                wall: wall.to_vec(),
                overlap: vec![0.1; normal.len()],
                normal: normal.to_vec(),
                ..Contacts::default()
            },
            ..Packing::default()
        }
    }

    fn sum(line: &Value) -> u64 {
        line["counts"]
            .as_array()
            .unwrap()
            .iter()
            .map(|n| n.as_u64().unwrap())
            .sum()
    }

    #[test]
    fn every_finite_value_is_in_a_bin() {
        let packing = packing(&[1.0, -0.5, 4.0, f64::NAN, 4.0], &[-1, -1, -1, -1, 0]);
        let [forces, overlaps, coordination] = distributions(&packing);
        let data = forces.data.unwrap();
        assert_eq!(
            (data["low"].as_f64(), data["width"].as_f64()),
            (Some(-0.5), Some(4.5 / 50.0))
        );
        assert_eq!((sum(&data["lines"][0]), sum(&data["lines"][1])), (3, 1));
        assert_eq!(data["lines"][0]["counts"][49], 1, "the largest belongs to the last bin");
        assert_eq!(sum(&overlaps.data.unwrap()["lines"][0]), 4);
        assert_eq!(coordination.data.unwrap()["lines"][0]["counts"], json!([1, 0, 0, 1]));
        assert!(coordination.told.contains("1.5") && coordination.told.contains("1 of 2"));
    }

    #[test]
    fn nothing_is_said_to_be_nothing() {
        let [forces, overlaps, coordination] = distributions(&Packing::default());
        assert!(forces.data.is_none() && overlaps.data.is_none() && coordination.data.is_none());
        assert!(forces.told.contains("No contact") && coordination.told.contains("no grain"));
        let same = packing(&[0.0, 0.0], &[-1, -1]);
        assert_eq!(sum(&distributions(&same)[0].data.as_ref().unwrap()["lines"][0]), 2);
    }
}
