//! Reads quantities, vectors and directions of a scenario, checked for dimension and range.

use super::document::Value;
use super::reader::{Item, Sought, TableReader};
use super::units::{self, Quantity, UnitError};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use glam::DVec3;

/// What a quantity must be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    /// A quantity with a unit of this dimension.
    Physical(Dimension),
    /// An angle: `"30 deg"`, or a plain number in radian.
    Angle,
    /// An angular velocity, with an angle in its unit: `"60 rpm"`, `"2 rad/s"`.
    AngularVelocity,
    /// A plain number, or a percentage.
    Number,
    /// Mass per time: `"0.5 kg/s"`.
    MassRate,
    /// Things per time: `"200 1/s"`.
    NumberRate,
    /// A torque: `"5 N m"`.
    Torque,
    /// A torque per angle: `"2 N m/rad"`.
    TorsionalStiffness,
    /// A torque per angular velocity: `"0.1 N m s/rad"`.
    TorsionalDamping,
}

/// Dimension of torques times a power of time.
const fn torque(time: i8) -> Dimension {
    Dimension::new(1, 2, time)
}

impl Kind {
    /// The kind of a law parameter of this dimension.
    pub fn of(dimension: Dimension) -> Self {
        if dimension == Dimension::NONE {
            Self::Number
        } else {
            Self::Physical(dimension)
        }
    }

    fn accepts(self, quantity: &Quantity) -> bool {
        match self {
            Self::Physical(dimension) => quantity.has_unit && quantity.dimension == dimension && quantity.angle == 0,
            Self::Angle => quantity.dimension == Dimension::NONE && quantity.angle <= 1,
            Self::AngularVelocity => quantity.dimension == Dimension::FREQUENCY && quantity.angle == 1,
            Self::Number => quantity.dimension == Dimension::NONE && quantity.angle == 0,
            Self::MassRate => quantity.dimension == Dimension::DAMPING && quantity.angle == 0,
            Self::NumberRate => quantity.dimension == Dimension::FREQUENCY && quantity.angle == 0,
            Self::Torque => quantity.dimension == torque(-2) && quantity.angle == 0,
            Self::TorsionalStiffness => quantity.dimension == torque(-2) && [0, -1].contains(&quantity.angle),
            Self::TorsionalDamping => quantity.dimension == torque(-1) && [0, -1].contains(&quantity.angle),
        }
    }

    /// What is expected, with an article.
    fn expected(self) -> String {
        match self {
            Self::Physical(Dimension::FREQUENCY) => "a frequency".to_string(),
            Self::Physical(dimension) => with_article(&dimension.name()),
            Self::Angle => "an angle".to_string(),
            Self::AngularVelocity => "an angular velocity".to_string(),
            Self::Number => "a pure number".to_string(),
            Self::MassRate => "a mass per time".to_string(),
            Self::NumberRate => "a number per time".to_string(),
            Self::Torque => "a torque".to_string(),
            Self::TorsionalStiffness => "a torque per angle".to_string(),
            Self::TorsionalDamping => "a torque per angular velocity".to_string(),
        }
    }

    /// How a number that lacks its unit is written with one.
    fn with_unit(self, number: &str) -> String {
        match self {
            // which of these was meant nobody knows
            Self::Physical(d) if [Dimension::LENGTH, Dimension::PRESSURE, Dimension::TIME].contains(&d) => {
                self.example()
            }
            Self::Physical(d) => format!("\"{number} {}\"", d.unit()),
            _ => self.example(),
        }
    }

    /// How it is written.
    pub fn example(self) -> String {
        match self {
            Self::Physical(d) if d == Dimension::LENGTH => "\"2 mm\"".to_string(),
            Self::Physical(d) if d == Dimension::PRESSURE => "\"5 MPa\"".to_string(),
            Self::Physical(d) if d == Dimension::TIME => "\"10 ms\"".to_string(),
            Self::Physical(d) if d == Dimension::DENSITY => "\"2500 kg/m^3\"".to_string(),
            Self::Physical(d) => format!("\"1 {}\"", d.unit()),
            Self::Angle => "\"30 deg\"".to_string(),
            Self::AngularVelocity => "\"60 rpm\" or \"2 rad/s\"".to_string(),
            Self::Number => "0.5".to_string(),
            Self::MassRate => "\"0.5 kg/s\"".to_string(),
            Self::NumberRate => "\"200 1/s\"".to_string(),
            Self::Torque => "\"5 N m\"".to_string(),
            Self::TorsionalStiffness => "\"2 N m/rad\"".to_string(),
            Self::TorsionalDamping => "\"0.1 N m s/rad\"".to_string(),
        }
    }
}

fn with_article(name: &str) -> String {
    let vowel = name.starts_with(['a', 'e', 'i', 'o', 'u']);
    format!("{} {name}", if vowel { "an" } else { "a" })
}

/// What a quantity is, in words.
fn found(quantity: &Quantity) -> String {
    match (quantity.dimension, quantity.angle) {
        (_, 0) if !quantity.has_unit => "a number without a unit".to_string(),
        (Dimension::NONE, 0) => "a pure number".to_string(),
        (Dimension::NONE, 1) => "an angle".to_string(),
        (Dimension::FREQUENCY, 0) => "a frequency".to_string(),
        (Dimension::FREQUENCY, 1) => "an angular velocity".to_string(),
        (dimension, _) => with_article(&dimension.name()),
    }
}

impl Item<'_> {
    /// A quantity of this kind and range, in SI.
    pub fn quantity(&self, kind: Kind, range: Range) -> f64 {
        self.seeks(|| Sought::Quantity(kind));
        let Some((value, written)) = self.read_quantity(kind) else {
            return f64::NAN;
        };
        if !range.contains(value) {
            self.fault(format!("`{}` is {written}; it must be {range}", self.name), None);
            return f64::NAN;
        }
        value
    }

    /// The value in SI and as it was written.
    fn read_quantity(&self, kind: Kind) -> Option<(f64, String)> {
        let (value, written) = match &self.node.value {
            Value::Integer(i) => (*i as f64, i.to_string()),
            Value::Float(f) => (*f, f.to_string()),
            Value::String(text) => return self.quantity_of_text(text, kind).map(|v| (v, text.trim().to_string())),
            other => {
                let message = format!("`{}` must be {}, found {}", self.name, kind.expected(), other.kind());
                self.fault(message, Some(format!("write it as {}", kind.example())));
                return None;
            }
        };
        if !value.is_finite() {
            self.fault(
                format!("`{}` must be {}, `{written}` is not finite", self.name, kind.expected()),
                None,
            );
            return None;
        }
        match kind {
            Kind::Number | Kind::Angle => Some((value, written)),
            _ if self.context.plain_si.get() => Some((value, written)),
            _ => {
                let message = format!(
                    "`{}` must be {} with a unit, found {written}",
                    self.name,
                    kind.expected()
                );
                self.fault(message, Some(format!("write it as {}", kind.with_unit(&written))));
                None
            }
        }
    }

    fn quantity_of_text(&self, text: &str, kind: Kind) -> Option<f64> {
        let quantity = match units::parse(text) {
            Ok(quantity) => quantity,
            Err(error) => {
                let help = match &error {
                    UnitError::Unknown { suggestion, .. } => {
                        suggestion.as_ref().map(|s| format!("did you mean `{s}`?"))
                    }
                    UnitError::Number(_) | UnitError::NotFinite(_) => Some(format!("write it as {}", kind.example())),
                    UnitError::Form { .. } => None,
                };
                self.fault(format!("`{}`: {error}", self.name), help);
                return None;
            }
        };
        if kind == Kind::Number && !quantity.has_unit {
            let message = format!("`{}` must be a pure number, found a text", self.name);
            self.fault(message, Some("write it without quotes".to_string()));
            return None;
        }
        if kind.accepts(&quantity) {
            return Some(quantity.value);
        }
        let message = format!(
            "`{}` must be {}, found {} (`{}`)",
            self.name,
            kind.expected(),
            found(&quantity),
            text.trim()
        );
        let help = match kind {
            Kind::AngularVelocity if quantity.dimension == Dimension::FREQUENCY => {
                Some("say what the number counts: \"1 rpm\", \"1 rev/s\", \"1 rad/s\" or \"1 deg/s\"".to_string())
            }
            Kind::Physical(d) if d == Dimension::FREQUENCY && quantity.dimension == d => {
                Some("a frequency counts cycles: write it in Hz".to_string())
            }
            _ if !quantity.has_unit => Some(format!("write it as {}", kind.with_unit(text.trim()))),
            _ => Some(format!("write it as {}", kind.example())),
        };
        self.fault(message, help);
        None
    }

    /// Three quantities of this kind: `["0 m", "0 m", "1 m"]` or `"0 0 1 m"`.
    pub fn vector(&self, kind: Kind) -> DVec3 {
        self.seeks(|| Sought::Vector(kind));
        match &self.node.value {
            Value::Array(nodes) if nodes.len() == 3 => {
                let parts: Vec<f64> = self.items().iter().map(|i| i.quantity(kind, Range::FINITE)).collect();
                DVec3::from_slice(&parts)
            }
            Value::Array(nodes) => {
                self.vector_fault(kind, &format!("found a list of {}", nodes.len()));
                DVec3::NAN
            }
            Value::String(text) => self.vector_of_text(text, kind),
            other => {
                self.vector_fault(kind, &format!("found {}", other.kind()));
                DVec3::NAN
            }
        }
    }

    fn vector_fault(&self, kind: Kind, found: &str) {
        let vector = match kind {
            Kind::Physical(d) => format!("\"0 0 1 {}\"", d.unit()),
            Kind::AngularVelocity => "\"0 0 1 rad/s\"".to_string(),
            _ => "[0, 0, 1]".to_string(),
        };
        self.fault(
            format!("`{}` must be a vector of three components, {found}", self.name),
            Some(format!("write it as {vector}")),
        );
    }

    /// `"0 0 -9.81 m/s^2"`: three numbers and one unit.
    fn vector_of_text(&self, text: &str, kind: Kind) -> DVec3 {
        let words: Vec<&str> = text.split_whitespace().collect();
        if words.len() < 3 || words[..3].iter().any(|w| w.parse::<f64>().is_err()) {
            self.vector_fault(kind, &format!("found `{text}`"));
            return DVec3::NAN;
        }
        let unit = words[3..].join(" ");
        let mut parts = DVec3::NAN;
        for axis in 0..3 {
            match self.quantity_of_text(&format!("{} {unit}", words[axis]), kind) {
                Some(value) => parts[axis] = value,
                None => return DVec3::NAN,
            }
        }
        parts
    }

    /// A unit vector: three plain numbers of any length, also in one text, or an axis: `"x"`, `"-z"`.
    pub fn direction(&self) -> DVec3 {
        self.seeks(|| Sought::Direction);
        let vector = match &self.node.value {
            Value::String(text) => axis(text).or_else(|| three_numbers(text)).unwrap_or_else(|| {
                let help = "write an axis, \"x\" or \"-z\", or three numbers, [0, 0, 1]";
                self.fault(
                    format!("`{}`: `{text}` is not a direction", self.name),
                    Some(help.to_string()),
                );
                DVec3::NAN
            }),
            _ => self.vector(Kind::Number),
        };
        // scaled by the largest part first: its square might be beyond what a double holds
        let largest = vector.abs().max_element();
        if vector == DVec3::ZERO {
            self.fault(
                format!("`{}` has no direction: all its components are 0", self.name),
                None,
            );
            return DVec3::NAN;
        }
        let scaled = vector / largest;
        scaled / scaled.length()
    }
}

/// An axis, `z` or `-x`.
fn axis(text: &str) -> Option<DVec3> {
    let (sign, axis) = match text.strip_prefix('-') {
        Some(axis) => (-1.0, axis),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    };
    let axis = match axis {
        "x" => DVec3::X,
        "y" => DVec3::Y,
        "z" => DVec3::Z,
        _ => return None,
    };
    Some(axis * sign)
}

/// Three plain numbers in one text.
fn three_numbers(text: &str) -> Option<DVec3> {
    let numbers: Vec<f64> = text
        .split_whitespace()
        .map(|word| word.parse().ok())
        .collect::<Option<_>>()?;
    (numbers.len() == 3 && numbers.iter().all(|number| number.is_finite())).then(|| DVec3::from_slice(&numbers))
}

/// Getters by key; a missing key that must be there is a fault.
impl TableReader<'_> {
    /// A quantity that must be there.
    pub fn quantity(&self, key: &str, kind: Kind, range: Range, meaning: &str) -> f64 {
        self.required(key, meaning)
            .map_or(f64::NAN, |item| item.quantity(kind, range))
    }

    /// A quantity that may be there.
    pub fn optional_quantity(&self, key: &str, kind: Kind, range: Range) -> Option<f64> {
        self.optional(key).map(|item| item.quantity(kind, range))
    }

    /// A positive length that must be there.
    pub fn length(&self, key: &str, meaning: &str) -> f64 {
        self.quantity(key, Kind::Physical(Dimension::LENGTH), Range::POSITIVE, meaning)
    }

    /// A point in space that must be there.
    pub fn point(&self, key: &str, meaning: &str) -> DVec3 {
        let item = self.required(key, meaning);
        item.map_or(DVec3::NAN, |item| item.vector(Kind::Physical(Dimension::LENGTH)))
    }

    /// A vector that may be there; zero when it is not.
    pub fn vector_or_zero(&self, key: &str, kind: Kind) -> DVec3 {
        self.optional(key).map_or(DVec3::ZERO, |item| item.vector(kind))
    }

    /// A direction that must be there.
    pub fn direction(&self, key: &str, meaning: &str) -> DVec3 {
        self.required(key, meaning).map_or(DVec3::NAN, |item| item.direction())
    }

    /// Two corners, the lower below the upper in every direction.
    pub fn corners(&self) -> (DVec3, DVec3) {
        let lower = self.point("lower", "the corner with the smallest coordinates");
        let upper = self.point("upper", "the corner with the largest coordinates");
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            if upper[axis] <= lower[axis] {
                let message = format!("`upper` must be above `lower` in every direction; in {name} it is not");
                self.fault_at("upper", message);
            }
        }
        (lower, upper)
    }
}
