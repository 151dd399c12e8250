//! Schemas of quantities: texts with a unit, checked for the symbols and, as far as a pattern can, for the dimension.

use crate::scenario::quantity::Kind;
use crate::scenario::reference::word;
use crate::scenario::units::{PREFIXES, UNITS, Unit};
use demeter_physics::dimension::Dimension;
use serde_json::{Value, json};

/// Pattern of a number.
const NUMBER: &str = r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?";

/// Name of a quantity among the definitions: `angular-velocity`.
pub(super) fn name(kind: Kind) -> String {
    word(kind).replace(' ', "-")
}

/// The symbols of some units, with their prefixes, as a pattern.
fn symbols<'u>(units: impl Iterator<Item = &'u Unit>) -> String {
    let (prefixed, plain): (Vec<&Unit>, Vec<&Unit>) = units.partition(|unit| unit.prefixes);
    let join = |units: Vec<&Unit>| units.iter().map(|unit| unit.symbol).collect::<Vec<_>>().join("|");
    let prefixes: Vec<&str> = PREFIXES.iter().map(|(prefix, _)| *prefix).collect();
    let mut parts = Vec::new();
    if !prefixed.is_empty() {
        parts.push(format!("({})?({})", prefixes.join("|"), join(prefixed)));
    }
    if plain.iter().any(|unit| unit.symbol == "deg") {
        parts.push("°".to_string());
    }
    if !plain.is_empty() {
        parts.push(join(plain));
    }
    format!("({})", parts.join("|"))
}

/// Pattern of products and quotients of units: two factors or more, or a power.
fn compound() -> String {
    let symbol = symbols(UNITS.iter());
    let power = r"(\^-?([1-9](\.[05])?|0?\.5)|²|³)";
    let factor = format!(r"\(?(1|{symbol}{power}?)\)?");
    let joint = r"(\s*[*·/]\s*|\s+)";
    format!("({factor}({joint}{factor})+|{symbol}{power})")
}

/// Dimension of a kind and the power of the angle that its units may have.
fn dimension(kind: Kind) -> (Dimension, i8) {
    let torque = |time: i8| Dimension::new(1, 2, time);
    match kind {
        Kind::Physical(dimension) => (dimension, 0),
        Kind::Angle => (Dimension::NONE, 1),
        Kind::AngularVelocity => (Dimension::FREQUENCY, 1),
        Kind::Number => (Dimension::NONE, 0),
        Kind::MassRate => (Dimension::DAMPING, 0),
        Kind::NumberRate => (Dimension::FREQUENCY, 0),
        Kind::Torque | Kind::TorsionalStiffness => (torque(-2), 0),
        Kind::TorsionalDamping => (torque(-1), 0),
    }
}

/// Pattern of the units of a kind: the symbols of its dimension, and whatever is a product or a quotient.
fn unit(kind: Kind) -> String {
    let (dimension, angle) = dimension(kind);
    let own: Vec<&Unit> = (UNITS.iter())
        .filter(|unit| unit.dimension == dimension && unit.angle == angle)
        .collect();
    match own.is_empty() {
        true => compound(),
        false => format!("({}|{})", symbols(own.into_iter()), compound()),
    }
}

/// What is told of a quantity, and examples.
fn told(kind: Kind) -> (String, Vec<Value>) {
    let example = kind.example();
    let examples = example
        .split(" or ")
        .map(|text| json!(text.trim_matches('"')))
        .collect();
    (format!("{}, as {example}", word(kind)), examples)
}

/// A quantity. Whether it may be a plain number depends on the file: see `needs_unit`.
pub(super) fn quantity(kind: Kind) -> Value {
    let (description, examples) = told(kind);
    // a pattern is for texts alone
    let number_or = |unit: &str, description: &str| {
        json!({
            "description": description,
            "type": ["number", "string"],
            "pattern": format!(r"^\s*{NUMBER}\s*{unit}\s*$"),
        })
    };
    match kind {
        Kind::Number => number_or("%", "pure number, as 0.5 or \"50 %\""),
        Kind::Angle => number_or(
            &format!("({})?", unit(kind)),
            "angle, as \"30 deg\", or a plain number in radian",
        ),
        _ => {
            let mut quantity = number_or(&unit(kind), &description);
            quantity["examples"] = json!(examples);
            quantity
        }
    }
}

/// A quantity whose dimension another key tells.
pub(super) fn any() -> Value {
    let symbol = symbols(UNITS.iter());
    let text = format!(r"^\s*{NUMBER}\s*({symbol}|{}|%)?\s*$", compound());
    json!({ "type": ["number", "string"], "pattern": text })
}

/// Three quantities, in a list or in one text.
pub(super) fn vector(kind: Kind) -> Value {
    let part = json!({ "$ref": format!("#/definitions/{}", name(kind)) });
    let unit = unit(kind);
    let text = format!(r"^\s*{NUMBER}\s+{NUMBER}\s+{NUMBER}\s+{unit}\s*$");
    let (description, _) = told(kind);
    json!({
        "description": format!("vector: three of {description}; or three numbers and the unit in one text"),
        "type": ["array", "string"],
        "items": part,
        "minItems": 3,
        "maxItems": 3,
        "pattern": text,
    })
}

/// An axis, or three plain numbers of any length.
pub(super) fn direction() -> Value {
    json!({
        "description": "direction: an axis, as \"-z\", or three plain numbers, as [0, 0, 1] or \"0 0 1\"",
        "anyOf": [
            { "enum": ["x", "y", "z", "-x", "-y", "-z", "+x", "+y", "+z"] },
            { "type": "string", "pattern": format!(r"^\s*{NUMBER}\s+{NUMBER}\s+{NUMBER}\s*$") },
            { "type": "array", "items": quantity(Kind::Number), "minItems": 3, "maxItems": 3 },
        ],
    })
}

/// A quotient of two numbers.
pub(super) fn share() -> Value {
    json!({ "type": "string", "pattern": format!(r"^\s*{NUMBER}\s*/\s*{NUMBER}\s*$"), "description": "share, as \"1/50\"" })
}

/// A strain, or a compression, and a force.
pub(super) fn measured_point() -> Value {
    let position = json!({ "anyOf": [quantity(Kind::Number), quantity(Kind::Physical(Dimension::LENGTH))] });
    json!({
        "type": "array",
        "items": [position, quantity(Kind::Physical(Dimension::FORCE))],
        "minItems": 2,
        "maxItems": 2,
    })
}
