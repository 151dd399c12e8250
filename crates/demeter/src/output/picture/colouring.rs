//! What the colour of a grain tells.

use super::viridis::VIRIDIS;
use crate::output::frame::Frame;
use crate::output::ticks::{round_up, si_prefix};
use glam::DVec3;

/// Colours of materials (Okabe and Ito, 2008): told apart by the colour-blind too.
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
    /// Angular speed [1/s].
    Spin,
    /// Mean normal stress of the contacts of a grain over its volume, compression positive [Pa].
    Pressure,
}

impl ColourBy {
    /// What can be told on the command line, by name.
    pub const NAMED: [(&'static str, Self); 9] = [
        ("automatic", Self::Automatic),
        ("force", Self::ContactForce),
        ("speed", Self::Speed),
        ("diameter", Self::Diameter),
        ("radius", Self::Diameter),
        ("coordination", Self::Coordination),
        ("material", Self::Material),
        ("spin", Self::Spin),
        ("pressure", Self::Pressure),
    ];
}

/// The colour bar.
pub(super) struct Bar {
    /// Value at its upper end, in the unit of the label; the lower end is 0.
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
    end: Option<f64>,
}

/// The colour of a share from 0 to 1.
pub(super) fn map(share: f64) -> [u8; 3] {
    // The cast takes NaN to 0.
    VIRIDIS[(share.clamp(0.0, 1.0) * 255.0 + 0.5) as usize]
}

impl Colouring {
    /// The colours of a frame; the bar ends at `high`, in SI, or where most values do.
    pub fn new(frame: &Frame, by: ColourBy, high: Option<f64>) -> Self {
        let g = frame.grains;
        match by {
            ColourBy::Automatic => {
                let by = if frame.contacts.iter().any(|c| c.normal_force != DVec3::ZERO) {
                    ColourBy::ContactForce
                } else {
                    ColourBy::Diameter
                };
                Self::new(frame, by, high)
            }
            ColourBy::ContactForce => {
                let forces = frame.contact_sums().force;
                Self::by_value("contact force", "N", &forces, high)
            }
            ColourBy::Speed => {
                let speeds: Vec<f64> = g.velocity.iter().map(|v| v.length()).collect();
                Self::by_value("speed", "m/s", &speeds, high)
            }
            ColourBy::Diameter => {
                let diameters: Vec<f64> = g.radii().map(|r| 2.0 * r).collect();
                Self::by_value("diameter", "m", &diameters, high)
            }
            ColourBy::Coordination => {
                let contacts: Vec<f64> = frame.contact_sums().coordination.into_iter().map(f64::from).collect();
                Self::by_value("contacts", "", &contacts, high)
            }
            ColourBy::Spin => {
                let speeds: Vec<f64> = g.angular_velocity.iter().map(|w| w.length()).collect();
                Self::by_value("spin", "1/s", &speeds, high)
            }
            ColourBy::Pressure => Self::by_value("pressure", "Pa", &frame.contact_sums().stress, high),
            ColourBy::Material => Self::by_material(frame),
        }
    }

    fn by_material(frame: &Frame) -> Self {
        let colour = |index: usize| CATEGORIES[index % CATEGORIES.len()];
        let materials = frame.materials.iter().enumerate();
        Self {
            colours: frame.grains.material.iter().map(|&m| colour(usize::from(m))).collect(),
            label: "material".to_owned(),
            legend: Legend::Names(materials.map(|(k, m)| (m.name.clone(), colour(k))).collect()),
            end: None,
        }
    }

    /// The end of the bar, in SI; nothing for names.
    pub fn end(&self) -> Option<f64> {
        self.end
    }

    fn by_value(name: &str, unit: &str, values: &[f64], end: Option<f64>) -> Self {
        let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
        sorted.sort_by(f64::total_cmp);
        let largest = sorted.last().copied().unwrap_or(0.0);
        let covered = sorted
            .get((COVERED * sorted.len() as f64) as usize)
            .copied()
            .unwrap_or(largest);
        let positive = [covered, largest].into_iter().find(|&v| v > f64::MIN_POSITIVE);
        let high = end
            .filter(|end| *end > 0.0)
            .unwrap_or_else(|| positive.map_or(1.0, round_up));
        let (prefix, factor) = if unit.is_empty() { ("", 1.0) } else { si_prefix(high) };
        let label = if unit.is_empty() {
            name.to_owned()
        } else {
            format!("{name} [{prefix}{unit}]")
        };
        Self {
            colours: values.iter().map(|v| map(v / high)).collect(),
            label,
            legend: Legend::Bar(Bar {
                high: high / factor,
                saturated: largest > high,
            }),
            end: Some(high),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_covers_most_values_with_round_ends() {
        let mut values: Vec<f64> = (0..1000).map(|k| 1e-3 * f64::from(k) / 137.0).collect();
        values[999] = 5.0;
        let colouring = Colouring::by_value("force", "N", &values, None);
        let Legend::Bar(bar) = colouring.legend else {
            panic!("no bar")
        };
        assert_eq!(colouring.label, "force [mN]");
        assert!((bar.high - 8.0).abs() < 1e-12 && bar.saturated);
        assert_eq!(colouring.colours[0], VIRIDIS[0]);
        assert_eq!(colouring.colours[999], VIRIDIS[255]);
    }

    #[test]
    fn values_that_are_all_zero_or_not_finite_have_a_bar_too() {
        for values in [vec![], vec![0.0; 5], vec![f64::NAN, f64::INFINITY]] {
            let colouring = Colouring::by_value("speed", "m/s", &values, None);
            let Legend::Bar(bar) = colouring.legend else {
                panic!("no bar")
            };
            assert_eq!(bar.high, 1.0);
        }
    }
}
