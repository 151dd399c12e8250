//! Values that would be usual in another unit than the one in which they are written.
//!
//! Only a value beyond what there is whose number is usual in another unit is doubted: a density that is scaled to save
//! steps, the gravity of an asteroid and numbers of a scene in units of its own are not.

use super::Scenario;
use super::document::join;
use super::units::{parse, split_number};
use demeter_physics::contact::LawChoice;
use demeter_physics::parameters::Value;
use std::ops::RangeInclusive;

/// What is usual of a quantity, in SI.
struct Usual {
    /// What there is.
    known: RangeInclusive<f64>,
    /// What is meant most often.
    common: RangeInclusive<f64>,
    /// Units in which it is written.
    units: &'static [&'static str],
}

/// Aerogels have a few kg/m^3, osmium 22,600.
const DENSITY: Usual = Usual {
    known: 1.0..=25_000.0,
    common: 50.0..=23_000.0,
    units: &["kg/m^3", "g/cm^3"],
};

/// Planets and moons that are round have more, and centrifuges for soils reach some 300 times that of the Earth.
const GRAVITY: Usual = Usual {
    known: 0.05..=5000.0,
    common: 1.0..=50.0,
    units: &["m/s^2", "cm/s^2", "mm/s^2"],
};

impl Usual {
    /// The other unit in which a value would be usual.
    fn meant(&self, value: f64, told: &str) -> Option<&'static str> {
        let size = |unit: &str| parse(&format!("1 {unit}")).map(|one| one.value).ok();
        let number = value / size(told)?;
        let is_common = |unit: &&str| size(unit).is_some_and(|size| self.common.contains(&(number * size)));
        let is_doubted = value != 0.0 && !self.known.contains(&value);
        is_doubted.then(|| self.units.iter().copied().find(is_common))?
    }
}

/// Nothing slides on a slope of nearly 80 degrees at this friction ...
const HIGH_FRICTION: f64 = 5.0;
/// ... and more than this one is told where nothing is to slide at all.
const NO_SLIDING: f64 = 100.0;

/// Doubts densities, gravity and friction.
pub(super) fn check(scenario: &Scenario, warnings: &mut Vec<String>) {
    let densities = scenario.materials.iter().filter_map(|material| {
        let path = join(&join("material", &material.name), "density");
        let text = scenario.document.text(&path)?.trim();
        let (number, told) = split_number(text).ok()?;
        let meant = DENSITY.meant(material.density, told)?;
        Some(format!(
            "`{path}` is {text}; all matter has 1 to 25,000 kg/m^3. Are {number} {meant} meant?"
        ))
    });
    warnings.extend(densities);
    let gravity = || {
        let text = scenario.document.text("simulation.gravity")?.trim();
        let told: Vec<&str> = text.split_whitespace().skip(3).collect();
        let meant = GRAVITY.meant(scenario.simulation.gravity.length(), &told.join(" "))?;
        Some(format!(
            "`simulation.gravity` is {text}; that of the Earth is 9.81 m/s^2. Is it meant in {meant}?"
        ))
    };
    warnings.extend(gravity());
    let told = std::iter::once(&scenario.contact).chain(&scenario.stage_contacts);
    let mut frictions: Vec<(String, f64)> = Vec::new();
    for contact in told {
        let common = friction(contact.default.tangential.as_ref());
        frictions.extend(common.map(|common| (contact.table().to_string(), common)));
        frictions.extend(contact.pairs.iter().filter_map(|(a, b, choice)| {
            // a pair that does not tell its own has the common one
            let own = friction(choice.tangential.as_ref()).filter(|own| Some(*own) != common)?;
            Some((contact.path((*a).into(), (*b).into()), own))
        }));
    }
    let high = (frictions.into_iter()).filter(|(_, friction)| (HIGH_FRICTION..=NO_SLIDING).contains(friction));
    warnings.extend(high.map(|(path, friction)| {
        let angle = if friction < 90.0 {
            let tangent = libm::tan(friction.to_radians());
            format!("an angle of friction of {friction} deg meant, which is a friction of {tangent:.4}, or ")
        } else {
            String::new()
        };
        format!(
            "`{path}.tangential.friction` is {friction}; that of bodies is below 2. Is {angle}{friction} % meant? \
             Where nothing is to slide, tell more than {NO_SLIDING}"
        )
    }));
}

fn friction(law: Option<&LawChoice>) -> Option<f64> {
    match law?.parameters.get("friction")? {
        Value::Number(friction) => Some(*friction),
        _ => None,
    }
}
