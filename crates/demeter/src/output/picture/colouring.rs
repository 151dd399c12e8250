//! What the colour of a grain tells.

use super::viridis::VIRIDIS;
use crate::comm::together::Together;
use crate::output::frame::Frame;
use crate::output::ticks::{round_range, round_up, si_prefix};
use crate::particles::Rows;
use std::collections::BTreeSet;

/// Colours of materials and tags (Okabe and Ito, 2008): told apart by the colour-blind too.
const CATEGORIES: [[u8; 3]; 8] = [
    [0, 114, 178],
    [230, 159, 0],
    [0, 158, 115],
    [204, 121, 167],
    [86, 180, 233],
    [213, 94, 0],
    [240, 228, 66],
    [120, 120, 120],
];

/// Share of the grains whose value the colour bar covers; a few large ones would leave the others dark.
const COVERED: f64 = 0.98;
/// Share of the largest value by which values differ that are not taken for alike.
const ALIKE: f64 = 1e-3;

/// What the colours of the grains tell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColourBy {
    /// The contact force when there is any, else the diameter.
    #[default]
    Automatic,
    /// Sum of the magnitudes of the normal forces on the grain [N].
    ContactForce,
    /// Speed [m/s].
    Speed,
    /// Diameter [m].
    Diameter,
    /// Number of contacts.
    Coordination,
    /// Material.
    Material,
    /// Tag; 0 where none was given.
    Tag,
    /// Angular speed [1/s].
    Spin,
    /// Mean normal stress of the contacts of a grain over its volume, compression positive [Pa].
    Pressure,
}

impl ColourBy {
    /// Unit of the values, empty where they have none; nothing for what has no values, or where it is not known before.
    pub fn unit(self) -> Option<&'static str> {
        match self {
            Self::Automatic | Self::Material | Self::Tag => None,
            Self::ContactForce => Some("N"),
            Self::Speed => Some("m/s"),
            Self::Diameter => Some("m"),
            Self::Coordination => Some(""),
            Self::Spin => Some("1/s"),
            Self::Pressure => Some("Pa"),
        }
    }

    /// What can be told on the command line, by name.
    pub const NAMED: [(&'static str, Self); 10] = [
        ("automatic", Self::Automatic),
        ("force", Self::ContactForce),
        ("speed", Self::Speed),
        ("diameter", Self::Diameter),
        ("radius", Self::Diameter),
        ("coordination", Self::Coordination),
        ("material", Self::Material),
        ("tag", Self::Tag),
        ("spin", Self::Spin),
        ("pressure", Self::Pressure),
    ];
}

/// Where the colour bar begins and ends, in SI, as far as it is told.
pub(super) type Ends = (Option<f64>, Option<f64>);

/// The colour bar.
pub(super) struct Bar {
    /// Value at its lower end, in the unit of the label.
    pub low: f64,
    /// Value at its upper end.
    pub high: f64,
    /// Whether some values are above.
    pub saturated: bool,
}

/// How colours are explained.
pub(super) enum Legend {
    Bar(Bar),
    Names(Vec<(String, [u8; 3])>),
}

/// The colours of all grains, sRGB, and their meaning.
pub(super) struct Colouring {
    pub colours: Vec<[u8; 3]>,
    pub label: String,
    pub legend: Legend,
    range: Option<(f64, f64)>,
}

/// The colour of a share from 0 to 1.
pub(super) fn map(share: f64) -> [u8; 3] {
    // The cast takes NaN to 0.
    VIRIDIS[(share.clamp(0.0, 1.0) * 255.0 + 0.5) as usize]
}

impl Colouring {
    /// The colours of a frame. Where its ends are not told, the bar begins at 0, or of diameters near the least, and ends where
    /// most values do.
    pub fn new(frame: &Frame, by: ColourBy, ends: Ends) -> Self {
        let (g, own, all) = (frame.grains, frame.own(), frame.part.together);
        let lengths =
            |rows: &Rows| -> Vec<f64> { rows.rows()[own.clone()].iter().map(|row| row.vector.length()).collect() };
        let unit = by.unit().unwrap_or("");
        match by {
            ColourBy::Automatic => {
                let is_any = frame.contacts.all().any(|c| c.repulsion() != 0.0);
                let by = if all.count(usize::from(is_any)) > 0 {
                    ColourBy::ContactForce
                } else {
                    ColourBy::Diameter
                };
                Self::new(frame, by, ends)
            }
            ColourBy::ContactForce => {
                let forces = frame.contact_force();
                Self::by_value("contact force", unit, &forces, false, ends, all)
            }
            ColourBy::Speed => Self::by_value("speed", unit, &lengths(&g.velocity), false, ends, all),
            ColourBy::Diameter => {
                let diameters: Vec<f64> = own.map(|grain| 2.0 * g.radius(grain)).collect();
                Self::by_value("diameter", unit, &diameters, true, ends, all)
            }
            ColourBy::Coordination => {
                let contacts: Vec<f64> = frame.coordination().into_iter().map(f64::from).collect();
                Self::by_value("contacts", unit, &contacts, false, ends, all)
            }
            ColourBy::Spin => Self::by_value("spin", unit, &lengths(&g.angular_velocity), false, ends, all),
            ColourBy::Pressure => Self::by_value("pressure", unit, &frame.mean_normal_stress(), false, ends, all),
            ColourBy::Material => Self::by_material(frame),
            ColourBy::Tag => Self::by_tag(frame),
        }
    }

    fn by_material(frame: &Frame) -> Self {
        let colour = |index: usize| CATEGORIES[index % CATEGORIES.len()];
        let materials = frame.materials.iter().enumerate();
        let materials_of_grains = &frame.grains.material[frame.own()];
        Self {
            colours: materials_of_grains.iter().map(|&m| colour(usize::from(m))).collect(),
            label: "material".to_owned(),
            legend: Legend::Names(materials.map(|(k, m)| (m.name.clone(), colour(k))).collect()),
            range: None,
        }
    }

    /// A tag has the same colour in every frame; told are those that grains have.
    fn by_tag(frame: &Frame) -> Self {
        let colour = |tag: i32| CATEGORIES[tag.rem_euclid(CATEGORIES.len() as i32) as usize];
        let tags = match &frame.tags {
            Some(tags) => tags.clone(),
            None => vec![0; frame.own().len()],
        };
        let own: BTreeSet<i32> = tags.iter().copied().collect();
        let all: BTreeSet<i32> = frame.part.together.joined(own.into_iter()).collect();
        Self {
            colours: tags.into_iter().map(colour).collect(),
            label: "tag".to_owned(),
            legend: Legend::Names(all.into_iter().map(|tag| (tag.to_string(), colour(tag))).collect()),
            range: None,
        }
    }

    /// The ends of the bar, in SI; nothing for names.
    pub fn range(&self) -> Option<(f64, f64)> {
        self.range
    }

    /// By the values of the own grains; those of all decide where the bar ends, and where it begins if it is to begin at the least.
    fn by_value(name: &str, unit: &str, values: &[f64], from_least: bool, ends: Ends, all: Together) -> Self {
        let count = all.count(values.iter().filter(|v| v.is_finite()).count());
        let sorted = |place: usize| (place < count).then(|| ranked(values, place, all));
        let covered = sorted((COVERED * count as f64) as usize).unwrap_or(0.0);
        let largest = sorted(count.saturating_sub(1)).unwrap_or(0.0);
        let least = if from_least { sorted(0).unwrap_or(0.0) } else { 0.0 };
        let is_more = |value: f64| value - least > ALIKE * largest;
        let (low, high) = if from_least && is_more(largest) {
            round_range(least, if is_more(covered) { covered } else { largest })
        } else {
            let positive = [covered, largest].into_iter().find(|&v| v > f64::MIN_POSITIVE);
            (0.0, positive.map_or(1.0, round_up))
        };
        let (low, high) = told_range(ends, (low, high));
        let size = low.abs().max(high.abs());
        let (prefix, factor) = if unit.is_empty() { ("", 1.0) } else { si_prefix(size) };
        let label = if unit.is_empty() {
            name.to_owned()
        } else {
            format!("{name} [{prefix}{unit}]")
        };
        Self {
            colours: values.iter().map(|v| map((v - low) / (high - low))).collect(),
            label,
            legend: Legend::Bar(Bar {
                low: low / factor,
                high: high / factor,
                saturated: largest > high,
            }),
            range: Some((low, high)),
        }
    }
}

/// The range between ends that are told, or those of the values; never a point.
fn told_range((start, end): Ends, (low, high): (f64, f64)) -> (f64, f64) {
    let (low, high) = (start.unwrap_or(low), end.unwrap_or(high));
    if low < high {
        return (low, high);
    }
    let size = |value: f64| if value == 0.0 { 1.0 } else { value.abs() };
    match (start, end) {
        (Some(_), None) => (low, low + size(low)),
        _ => (high - size(high), high),
    }
}

/// The value that stands at this place when the finite ones of all are sorted.
fn ranked(values: &[f64], place: usize, all: Together) -> f64 {
    // numbers whose order is that of the values
    let key = |value: f64| match value.to_bits() {
        bits if value.is_sign_negative() => !bits,
        bits => bits | SIGN,
    };
    let mut keys: Vec<u64> = values.iter().filter(|v| v.is_finite()).map(|&v| key(v)).collect();
    let (mut found, mut place) = (0, place as u64);
    for shift in (0..u64::BITS).step_by(DIGIT as usize).rev() {
        let digit = |key: u64| (key >> shift) as usize % DIGITS;
        let mut counts = [0; DIGITS];
        keys.iter().for_each(|&key| counts[digit(key)] += 1);
        let counts = all.counts(counts);
        let mut next = 0;
        while next + 1 < DIGITS && place >= counts[next] {
            place -= counts[next];
            next += 1;
        }
        keys.retain(|&key| digit(key) == next);
        found |= (next as u64) << shift;
    }
    f64::from_bits(if found & SIGN == 0 { !found } else { found ^ SIGN })
}

/// Bits of a digit, and how many digits there are.
const DIGIT: u32 = 4;
const DIGITS: usize = 1 << DIGIT;

/// The bit that tells the sign.
const SIGN: u64 = 1 << 63;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_covers_most_values_with_round_ends() {
        let mut values: Vec<f64> = (0..1000).map(|k| 1e-3 * f64::from(k) / 137.0).collect();
        values[999] = 5.0;
        let colouring = Colouring::by_value("force", "N", &values, false, (None, None), Together::ALONE);
        let Legend::Bar(bar) = colouring.legend else {
            panic!("no bar")
        };
        assert_eq!(colouring.label, "force [mN]");
        assert!((bar.high - 8.0).abs() < 1e-12 && bar.saturated);
        assert_eq!(colouring.colours[0], VIRIDIS[0]);
        assert_eq!(colouring.colours[999], VIRIDIS[255]);
    }

    #[test]
    fn diameters_use_the_whole_bar() {
        let bar = |values: &[f64], ends: Ends| {
            let colouring = Colouring::by_value("diameter", "m", values, true, ends, Together::ALONE);
            let Legend::Bar(bar) = colouring.legend else {
                panic!("no bar")
            };
            (
                (bar.low * 1e6).round() / 1e6,
                (bar.high * 1e6).round() / 1e6,
                colouring.colours,
            )
        };
        let values: Vec<f64> = (0..=265).map(|k| 2.35e-3 + 1e-5 * f64::from(k)).collect();
        let (low, high, colours) = bar(&values, (None, None));
        assert_eq!((low, high), (2.0, 5.0));
        assert_eq!((colours[0], colours[265]), (map(0.35 / 3.0), VIRIDIS[255]));
        let told = |ends| bar(&values, ends);
        assert_eq!((told((Some(3e-3), None)).0, told((None, Some(4e-3))).1), (3.0, 4.0));
        // a few coarse among fines, all alike, and ends beyond all values
        let mut mixed = vec![1e-3; 999];
        mixed.push(4e-3);
        assert_eq!(bar(&mixed, (None, None)).1, 4.0);
        let (low, high, _) = bar(&[2e-3; 5], (None, None));
        assert_eq!((low, high), (0.0, 2.0));
        assert_eq!(told((None, Some(1e-3))).0, 0.0);
        let (low, high, _) = told((Some(6e-3), None));
        assert_eq!((low, high), (6.0, 12.0));
    }

    #[test]
    fn a_value_is_found_by_its_place() {
        let values = [3.0, -0.0, 1e-310, -7.5, 0.0, f64::NAN, 3.0, -1e300, f64::INFINITY, 2.0];
        let mut sorted: Vec<f64> = values.into_iter().filter(|v| v.is_finite()).collect();
        sorted.sort_by(f64::total_cmp);
        for (place, value) in sorted.into_iter().enumerate() {
            let found = ranked(&values, place, Together::ALONE);
            assert_eq!(found.to_bits(), value.to_bits(), "place {place}");
        }
    }

    #[test]
    fn values_that_are_all_zero_or_not_finite_have_a_bar_too() {
        for values in [vec![], vec![0.0; 5], vec![f64::NAN, f64::INFINITY]] {
            let colouring = Colouring::by_value("speed", "m/s", &values, false, (None, None), Together::ALONE);
            let Legend::Bar(bar) = colouring.legend else {
                panic!("no bar")
            };
            assert_eq!(bar.high, 1.0);
        }
    }
}
