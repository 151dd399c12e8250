//! Where a quantity needs its unit: everywhere, unless the file says that plain numbers are SI values.
//!
//! This is a second tree beside that of the keys, with the same tables as far as they hold quantities. It refuses plain
//! numbers in their places and accepts all else, so that an editor tells nothing twice. The top of a schema asks for it where
//! the file has no `plain_numbers`.

use super::{is_of_kind, laws, reference, schema_name};
use crate::scenario::quantity::Kind;
use crate::scenario::reference::{Form, Section};
use serde_json::{Map, Value, json};

/// What is said of a number in the place of a quantity.
const TOLD: &str =
    "a quantity needs its unit, as \"2 mm\"; plain numbers are SI values where the file says `plain_numbers = \"SI\"`";
/// All types but numbers.
const NO_NUMBER: [&str; 5] = ["string", "array", "object", "boolean", "null"];

/// Name of the definition for a section.
pub(super) fn name(section: &str) -> String {
    format!("units.{}", schema_name(section))
}

/// A quantity alone in its place.
pub(super) fn quantity() -> Value {
    json!({ "type": "string", "description": TOLD })
}

/// The quantities of a section with their units.
pub(super) fn table(section: &Section) -> Value {
    let same = section
        .rows
        .iter()
        .filter(|row| is_the_same_everywhere(section, &row.key));
    let always: Map<String, Value> = same
        .filter_map(|row| Some((row.key.clone(), of_forms(&row.value)?)))
        .collect();
    let Some((kind_key, kinds)) = section.kinds() else {
        return json!({ "properties": always });
    };
    let mut rules = Vec::new();
    for kind in kinds {
        let rows = section.rows.iter().filter(|row| row.belongs(Some(kind)).is_some());
        let own: Map<String, Value> = rows
            .filter(|row| !is_the_same_everywhere(section, &row.key))
            .filter_map(|row| Some((row.key.clone(), of_forms(&row.value)?)))
            .collect();
        if !own.is_empty() {
            rules.push(json!({ "if": is_of_kind(kind_key, kind), "then": { "properties": own } }));
        }
    }
    match rules.is_empty() {
        true => json!({ "properties": always }),
        false => json!({ "properties": always, "allOf": rules }),
    }
}

fn is_the_same_everywhere(section: &Section, key: &str) -> bool {
    let mut rows = section.rows.iter().filter(|row| row.key == key);
    let first = rows.next();
    rows.all(|row| first.is_some_and(|first| first.value == row.value))
}

/// What is asked of a value that may be any of some forms.
fn of_forms(forms: &[Form]) -> Option<Value> {
    if let [form] = forms {
        return of_form(form);
    }
    let mut asked: Vec<Value> = Vec::new();
    let takes_numbers = forms.iter().any(takes_numbers);
    if forms.iter().any(is_quantity) && !takes_numbers {
        asked.push(json!({ "type": NO_NUMBER, "description": TOLD }));
    }
    // of two kinds of lists nothing can be said without knowing which is meant
    let lists = forms.iter().filter(|form| is_list(form)).count();
    let others = forms
        .iter()
        .filter(|form| !is_quantity(form) && (lists < 2 || !is_list(form)));
    asked.extend(others.filter_map(of_form));
    match asked.len() {
        0 => None,
        1 => asked.pop(),
        _ => Some(json!({ "allOf": asked })),
    }
}

fn is_quantity(form: &Form) -> bool {
    matches!(form, Form::Quantity(kind) if needs_unit(*kind))
}

fn takes_numbers(form: &Form) -> bool {
    match form {
        Form::Quantity(kind) => !needs_unit(*kind),
        Form::AnyQuantity | Form::Integer => true,
        _ => false,
    }
}

fn is_list(form: &Form) -> bool {
    matches!(
        form,
        Form::List(_) | Form::Vector(_) | Form::Direction | Form::MeasuredPoint | Form::Motion
    )
}

/// Whether a plain number is not enough for a quantity of this kind.
pub(super) fn needs_unit(kind: Kind) -> bool {
    !matches!(kind, Kind::Number | Kind::Angle)
}

fn of_form(form: &Form) -> Option<Value> {
    let with_unit = || reference("with-unit");
    Some(match form {
        Form::Quantity(kind) if needs_unit(*kind) => with_unit(),
        Form::Vector(kind) if needs_unit(*kind) => json!({ "items": with_unit() }),
        Form::List(items) => json!({ "items": of_form(items)? }),
        Form::Table(of) => reference(&name(of)),
        Form::TablesByName(of) => json!({ "additionalProperties": reference(&name(of)) }),
        Form::ByName(of) => json!({ "additionalProperties": of_form(of)? }),
        Form::Motion => json!({ "allOf": [reference(&name("motion"))], "items": reference(&name("motion")) }),
        Form::Law(family) => laws::needs_unit(family),
        Form::KnownParameters => laws::needs_unit("normal"),
        Form::UnknownParameters => laws::unknown_needs_unit("normal"),
        Form::MeasuredPoint => json!({ "items": [{}, with_unit()] }),
        _ => return None,
    })
}
