//! JSON schemas of the files that Demeter reads, for editors that complete and check while one writes.
//!
//! They follow from what the readers follow: the keys from the tables of the references (`reference.md`, `impact.md`,
//! `fit_file.md`, `packing_file.md`), the laws with their parameters from the registries, the units from the table of
//! units. A schema tells unknown keys, wrong types, unknown words, units that do not exist or are missing, and missing keys.
//! What depends on other values (a name that no wall has, bounds that are reversed) only the reader tells.

mod laws;
mod needs_unit;
mod quantities;

use super::plain::PLAIN_NUMBERS;
use super::reference::{Form, Of, Row, Section, sections};
use super::{FIT_REFERENCE, IMPACT_REFERENCE, PACKING_FIT_REFERENCE, REFERENCE};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;

/// A kind of file that Demeter reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// A scenario, of `demeter run`.
    Scenario,
    /// Two bodies, of `demeter collide`, `demeter contact-curve` and `demeter sticking`.
    TwoBodies,
    /// Observed collisions, of `demeter fit`.
    Fit,
    /// A measured force curve of a packing, of `demeter fit`.
    PackingFit,
}

impl FileKind {
    /// All kinds.
    pub const ALL: [Self; 4] = [Self::Scenario, Self::TwoBodies, Self::Fit, Self::PackingFit];

    /// Name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Scenario => "scenario",
            Self::TwoBodies => "two-bodies",
            Self::Fit => "fit",
            Self::PackingFit => "packing-fit",
        }
    }

    /// Name of the file that its schema is written to beside a file of this kind.
    pub fn schema_file(self) -> String {
        format!("demeter-{}.schema.json", self.name())
    }

    fn title(self) -> &'static str {
        match self {
            Self::Scenario => "A scenario of Demeter",
            Self::TwoBodies => "Two bodies, for demeter collide, contact-curve and sticking",
            Self::Fit => "Observed collisions, for demeter fit",
            Self::PackingFit => "A measured force curve of a packing, for demeter fit",
        }
    }

    /// The tables of keys of this file. Those that it shares with others come from their reference.
    fn sections(self) -> Vec<Section> {
        let scenario = || sections(REFERENCE).into_iter();
        let of_scenario = |names: &'static [&'static str]| {
            scenario().filter(move |s| names.iter().any(|name| s.name.starts_with(name)))
        };
        match self {
            Self::Scenario => scenario().collect(),
            Self::TwoBodies => {
                let own = sections(IMPACT_REFERENCE).into_iter();
                own.chain(of_scenario(&["material.", "contact"])).collect()
            }
            Self::Fit => {
                let bodies = sections(IMPACT_REFERENCE).into_iter();
                let bodies = bodies.filter(|s| s.name == "a" || s.name == "b");
                let own = sections(FIT_REFERENCE).into_iter();
                own.chain(bodies).chain(of_scenario(&["material."])).collect()
            }
            Self::PackingFit => sections(PACKING_FIT_REFERENCE),
        }
    }
}

/// The schema of a file, JSON Schema draft 7.
pub fn schema(of: FileKind) -> Value {
    let mut definitions = Map::new();
    let mut root = Map::from_iter([
        ("$schema".to_string(), json!("http://json-schema.org/draft-07/schema#")),
        ("title".to_string(), json!(of.title())),
    ]);
    for section in of.sections() {
        let value = table(&section, &mut definitions);
        if section.name.is_empty() {
            root.extend(value.as_object().cloned().unwrap_or_default());
            root.insert("if".to_string(), json!({ "not": { "required": [PLAIN_NUMBERS] } }));
            root.insert("then".to_string(), needs_unit::table(&section));
        } else {
            definitions.insert(schema_name(&section.name), value);
            definitions.insert(needs_unit::name(&section.name), needs_unit::table(&section));
        }
    }
    definitions.insert("with-unit".to_string(), needs_unit::quantity());
    root.insert("definitions".to_string(), Value::Object(definitions));
    Value::Object(root)
}

/// Name of a section among the definitions: `measure[].region` is `measure.region`.
fn schema_name(section: &str) -> String {
    section.replace("[]", "").replace('*', "NAME")
}

fn reference(name: &str) -> Value {
    json!({ "$ref": format!("#/definitions/{name}") })
}

/// The table of a section. Where keys depend on its kind, all of them are there to be completed, and a rule for every kind tells
/// which belong to it: of alternatives an editor could only say that none fits.
fn table(section: &Section, shared: &mut Map<String, Value>) -> Value {
    let Some((key, kinds)) = section.kinds() else {
        return table_of_kind(section, None, shared);
    };
    let mut properties = Map::new();
    for row in &section.rows {
        let same = section.rows.iter().filter(|other| other.key == row.key);
        let mut forms: Vec<&Form> = Vec::new();
        for form in same.flat_map(|row| &row.value) {
            if !forms.contains(&form) {
                forms.push(form);
            }
        }
        let values = forms.iter().map(|form| value(form, &section.name, shared)).collect();
        (properties.entry(row.key.clone())).or_insert_with(|| described(any_of(values), row));
    }
    let mut rules = Vec::new();
    for kind in kinds {
        rules.push(json!({ "if": is_of_kind(key, kind), "then": table_of_kind(section, Some((key, kind)), shared) }));
    }
    json!({ "type": "object", "properties": properties, "required": [key], "allOf": rules })
}

/// That a table is of a kind.
fn is_of_kind(key: &str, kind: &str) -> Value {
    json!({ "properties": { key: { "const": kind } }, "required": [key] })
}

/// For every key that shuts others out: the rule that it does.
fn exclusions(section: &Section) -> Vec<Value> {
    let mut shut_out: BTreeMap<&str, Map<String, Value>> = BTreeMap::new();
    for row in &section.rows {
        if let Of::Without(other) = &row.of {
            shut_out.entry(other).or_default().insert(row.key.clone(), json!(false));
        }
    }
    let rule = |(key, keys): (&str, Map<String, Value>)| json!({ "if": { "required": [key] }, "then": { "properties": keys } });
    shut_out.into_iter().map(rule).collect()
}

fn table_of_kind(section: &Section, kind: Option<(&str, &str)>, shared: &mut Map<String, Value>) -> Value {
    let mut properties = Map::new();
    let mut required = Vec::new();
    for row in &section.rows {
        let Some(must) = row.belongs(kind.map(|(_, kind)| kind)) else {
            continue;
        };
        let value = match kind {
            Some((key, kind)) if key == row.key => json!({ "const": kind }),
            _ => any_of(
                row.value
                    .iter()
                    .map(|form| value(form, &section.name, shared))
                    .collect(),
            ),
        };
        if must {
            required.push(row.key.clone());
        }
        properties.insert(row.key.clone(), described(value, row));
    }
    let mut table = json!({ "type": "object", "properties": properties, "additionalProperties": false });
    if !required.is_empty() {
        table["required"] = json!(required);
    }
    let exclusions = exclusions(section);
    if kind.is_none() && !exclusions.is_empty() {
        table["allOf"] = json!(exclusions);
    }
    table
}

/// The value with what the reference tells of it. A reference cannot carry a description of its own in draft 7.
fn described(value: Value, row: &Row) -> Value {
    let mut text = row.meaning.replace('`', "");
    if !row.otherwise.is_empty() {
        text = format!("{text}. Otherwise: {}", row.otherwise.replace('`', ""));
    }
    if text.is_empty() {
        return value;
    }
    match value {
        Value::Object(mut fields) if !fields.contains_key("$ref") => {
            let said = fields.get("description").and_then(Value::as_str);
            let text = said.map_or_else(|| text.clone(), |said| format!("{text} ({said})"));
            fields.insert("description".to_string(), json!(text));
            Value::Object(fields)
        }
        value => json!({ "allOf": [value], "description": text }),
    }
}

fn any_of(mut values: Vec<Value>) -> Value {
    match values.len() {
        1 => values.remove(0),
        _ => json!({ "anyOf": values }),
    }
}

/// The schema of a value; what many share goes to `shared`.
fn value(form: &Form, section: &str, shared: &mut Map<String, Value>) -> Value {
    let mut share = |name: &str, made: Value| {
        shared.insert(name.to_string(), made);
        reference(name)
    };
    match form {
        Form::Text => json!({ "type": "string" }),
        Form::Name => json!({ "type": "string", "minLength": 1, "maxLength": 200 }),
        Form::Boolean => json!({ "type": "boolean" }),
        Form::False => json!({ "const": false }),
        Form::Integer => json!({ "type": "integer" }),
        Form::Words(words) => json!({ "enum": words }),
        Form::Quantity(kind) => share(&quantities::name(*kind), quantities::quantity(*kind)),
        Form::AnyQuantity => share("any-quantity", quantities::any()),
        Form::Vector(kind) => {
            share(&quantities::name(*kind), quantities::quantity(*kind));
            share(
                &format!("{}-vector", quantities::name(*kind)),
                quantities::vector(*kind),
            )
        }
        Form::Direction => share("direction", quantities::direction()),
        Form::Share => quantities::share(),
        Form::List(items) => json!({ "type": "array", "items": value(items, section, shared) }),
        Form::Table(name) => reference(&schema_name(name)),
        Form::TablesByName(name) => {
            json!({ "type": "object", "additionalProperties": reference(&schema_name(name)), "minProperties": 1 })
        }
        Form::ByName(of) => json!({ "type": "object", "additionalProperties": value(of, section, shared) }),
        Form::Law(family) if section.ends_with("pair[]") || section.starts_with("stage[]") => {
            share(&format!("{family}-law-of-a-pair"), laws::law_of_pair(family))
        }
        Form::Law(family) => share(&format!("{family}-law"), laws::law(family)),
        Form::LawName => laws::name("normal"),
        Form::KnownParameters => laws::known("normal"),
        Form::UnknownParameters => laws::unknown("normal"),
        Form::MeasuredPoint => quantities::measured_point(),
        Form::Motion => {
            let one = reference("motion");
            share(
                "motions",
                json!({ "anyOf": [{ "const": "rest" }, one, { "type": "array", "items": one, "minItems": 1 }] }),
            )
        }
        Form::Unreadable(_) => json!(false),
    }
}

#[cfg(test)]
mod tests;
