//! Schemas of the contact laws, from their registries.

use super::quantities::quantity;
use super::{is_of_kind, needs_unit, reference};
use crate::scenario::quantity::Kind;
use demeter_physics::contact::{LawInfo, laws};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::{ParameterInfo, ParameterKind, Presence, Range};
use serde_json::{Map, Value, json};

fn of_family(family: &str) -> Vec<&'static LawInfo> {
    laws().filter(|law| law.family == family).collect()
}

/// The names of the laws of a family.
pub(super) fn name(family: &str) -> Value {
    let names: Vec<&str> = of_family(family).iter().map(|law| law.name).collect();
    json!({ "enum": names })
}

/// A law of a family: a table of its name and parameters, its name alone where it needs none, or `"none"`.
pub(super) fn law(family: &str) -> Value {
    let laws = of_family(family);
    let alone = |law: &&&LawInfo| law.parameters.iter().all(|p| p.presence != Presence::Required);
    let mut names: Vec<&str> = laws.iter().filter(alone).map(|law| law.name).collect();
    if family != "normal" {
        names.push("none");
    }
    let tables = laws.iter().map(|law| table(law, true));
    let choices: Vec<Value> = std::iter::once(json!({ "enum": names })).chain(tables).collect();
    json!({ "oneOf": choices })
}

/// A law of one pair, or of a stage: what it does not name is that of `[contact]`.
pub(super) fn law_of_pair(family: &str) -> Value {
    let laws = of_family(family);
    let mut names: Vec<&str> = laws.iter().map(|law| law.name).collect();
    if family != "normal" {
        names.push("none");
    }
    let tables = laws.iter().map(|law| table(law, false));
    let same_law = json!({
        "type": "object",
        "description": "changes of the law of [contact]",
        "properties": all_parameters(&laws),
        "additionalProperties": false,
    });
    let choices: Vec<Value> = (std::iter::once(json!({ "enum": names })).chain(tables))
        .chain(std::iter::once(same_law))
        .collect();
    json!({ "oneOf": choices })
}

/// Parameters of the laws of a family that a fit does not seek.
pub(super) fn known(family: &str) -> Value {
    let laws = of_family(family);
    json!({ "type": "object", "properties": all_parameters(&laws), "additionalProperties": false })
}

/// What a fit seeks: `"free"`, or two bounds.
pub(super) fn unknown(family: &str) -> Value {
    let mut properties = Map::new();
    let mut add = |name: &str, kind: Kind| {
        let bounds = json!({ "type": "array", "items": quantity(kind), "minItems": 2, "maxItems": 2 });
        properties.insert(name.to_string(), json!({ "anyOf": [{ "const": "free" }, bounds] }));
    };
    for parameter in of_family(family).iter().flat_map(|law| law.parameters) {
        if !matches!(parameter.kind, ParameterKind::Choice(_)) {
            add(parameter.name, Kind::of(parameter.dimension));
        }
    }
    let modulus = json!({ "type": "array", "items": quantity(Kind::Physical(Dimension::PRESSURE)), "minItems": 2,
        "maxItems": 2 });
    let ratio = json!({ "type": "array", "items": quantity(Kind::Number), "minItems": 2, "maxItems": 2 });
    json!({
        "type": "object",
        "minProperties": 1,
        "properties": properties,
        "patternProperties": {
            r"^material\..+\.young_modulus$": { "anyOf": [{ "const": "free" }, modulus] },
            r"^material\..+\.poisson_ratio$": { "anyOf": [{ "const": "free" }, ratio] },
        },
        "additionalProperties": false,
    })
}

/// The parameters of the laws of a family with their units. One that is a pure number in some laws is asked of by law.
pub(super) fn needs_unit(family: &str) -> Value {
    let laws = of_family(family);
    let all = |name: &str| {
        laws.iter()
            .flat_map(|law| law.parameters)
            .filter(move |p| p.name == name)
            .collect::<Vec<_>>()
    };
    let mut always: Map<String, Value> = Map::new();
    let mut rules = Vec::new();
    for law in &laws {
        let mut own: Map<String, Value> = Map::new();
        for parameter in law.parameters {
            let Some(asked) = parameter_needs_unit(parameter) else {
                continue;
            };
            let is_everywhere = all(parameter.name)
                .into_iter()
                .all(|p| parameter_needs_unit(p).is_some());
            let place = if is_everywhere { &mut always } else { &mut own };
            place.insert(parameter.name.to_string(), asked);
        }
        if !own.is_empty() {
            rules.push(json!({ "if": is_of_kind("law", law.name), "then": { "properties": own } }));
        }
    }
    match rules.is_empty() {
        true => json!({ "properties": always }),
        false => json!({ "properties": always, "allOf": rules }),
    }
}

fn parameter_needs_unit(parameter: &ParameterInfo) -> Option<Value> {
    let with_unit = || reference("with-unit");
    match parameter.kind {
        ParameterKind::Choice(_) => None,
        ParameterKind::Restitution => Some(json!({ "items": { "items": [with_unit(), {}] } })),
        ParameterKind::Number => needs_unit::needs_unit(Kind::of(parameter.dimension)).then(with_unit),
    }
}

/// The bounds of what a fit seeks with their units.
pub(super) fn unknown_needs_unit(family: &str) -> Value {
    let bounds = || json!({ "items": reference("with-unit") });
    let parameters = of_family(family).into_iter().flat_map(|law| law.parameters);
    let with_units = parameters
        .filter(|p| p.kind == ParameterKind::Number && needs_unit::needs_unit(Kind::of(p.dimension)))
        .map(|p| (p.name.to_string(), bounds()));
    json!({
        "properties": with_units.collect::<Map<_, _>>(),
        "patternProperties": { r"^material\..+\.young_modulus$": bounds() },
    })
}

/// The parameters of several laws; one that differs between them may be any of those.
fn all_parameters(laws: &[&LawInfo]) -> Map<String, Value> {
    let mut merged: Map<String, Value> = Map::new();
    for parameter in laws.iter().flat_map(|law| law.parameters) {
        let own = value(parameter);
        match merged.get_mut(parameter.name) {
            None => {
                merged.insert(parameter.name.to_string(), json!({ "anyOf": [own] }));
            }
            Some(known) => {
                if let Some(choices) = known["anyOf"].as_array_mut()
                    && !choices.contains(&own)
                {
                    choices.push(own);
                }
            }
        }
    }
    merged
}

fn table(law: &LawInfo, complete: bool) -> Value {
    let mut properties = Map::new();
    properties.insert(
        "law".to_string(),
        json!({ "const": law.name, "description": law.summary }),
    );
    let mut required = vec!["law"];
    for parameter in law.parameters {
        properties.insert(parameter.name.to_string(), value(parameter));
        if complete && parameter.presence == Presence::Required {
            required.push(parameter.name);
        }
    }
    json!({
        "type": "object",
        "title": law.name,
        "description": law.summary,
        "properties": properties,
        "required": required,
        "additionalProperties": false,
    })
}

fn value(parameter: &ParameterInfo) -> Value {
    let mut value = match parameter.kind {
        ParameterKind::Choice(words) => json!({ "enum": words, "default": words.first() }),
        ParameterKind::Number if parameter.dimension == Dimension::NONE => number(parameter.range),
        ParameterKind::Number => quantity(Kind::of(parameter.dimension)),
        ParameterKind::Restitution => restitution(parameter.range),
    };
    value["description"] = json!(description(parameter));
    value
}

/// A pure number in a range; percentages are not checked for it.
fn number(range: Range) -> Value {
    limited(quantity(Kind::Number), range)
}

/// The same with limits, which are for numbers alone.
fn limited(mut number: Value, range: Range) -> Value {
    if range.lower.is_finite() {
        let key = if range.lower_allowed {
            "minimum"
        } else {
            "exclusiveMinimum"
        };
        number[key] = json!(range.lower);
    }
    if range.upper.is_finite() {
        let key = if range.upper_allowed {
            "maximum"
        } else {
            "exclusiveMaximum"
        };
        number[key] = json!(range.upper);
    }
    number
}

/// A number, a formula in the impact speed, or rows of impact speed and restitution.
fn restitution(range: Range) -> Value {
    let row = json!({
        "type": "array",
        "items": [quantity(Kind::Physical(Dimension::VELOCITY)), quantity(Kind::Number)],
        "minItems": 2,
        "maxItems": 2,
    });
    let restitution = json!({ "type": ["number", "string", "array"], "items": row, "minItems": 1 });
    limited(restitution, range)
}

fn description(parameter: &ParameterInfo) -> String {
    if let ParameterKind::Choice(words) = parameter.kind {
        let first = words.first().copied().unwrap_or_default();
        return format!("{}; \"{first}\" when not given", parameter.doc);
    }
    let unit = parameter.dimension.unit();
    let unit = if unit.is_empty() {
        String::new()
    } else {
        format!(" [{unit}]")
    };
    let typical = parameter.typical;
    let presence = match parameter.presence {
        Presence::Required => format!("must be given, typically {typical:e}"),
        Presence::Usual | Presence::Optional => format!("typically {typical:e}"),
        Presence::Default(value) => format!("{value:e} when not given"),
    };
    format!("{}{unit}; {}; {presence}", parameter.doc, parameter.range)
}
