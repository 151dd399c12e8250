//! Scenarios that a program makes: values without places, written as TOML.

use super::diagnostics::Diagnostics;
use super::document::{Document, Entry, Node, Span, Value};
use super::{resolved, tree};
use std::path::Path;
use std::sync::Arc;

/// A value that a program makes.
#[derive(Clone, Debug, PartialEq)]
pub enum Plain {
    /// A text, or a quantity with its unit.
    Text(String),
    /// A whole number.
    Integer(i64),
    /// A number.
    Number(f64),
    /// True or false.
    Boolean(bool),
    /// A list.
    List(Vec<Plain>),
    /// A table, with its keys in their order.
    Table(Vec<(String, Plain)>),
}

impl Plain {
    /// A table as TOML, from which it can be read as a scenario (or another file). Values that are named `file` become paths
    /// from `base`. Unless the table says otherwise, plain numbers stand for SI values: `plain_numbers = "SI"` is put before it.
    pub fn to_toml(&self, base: &Path) -> String {
        let mut node = self.node();
        if let Value::Table(entries) = &mut node.value
            && entries.iter().all(|entry| entry.key != PLAIN_NUMBERS)
        {
            entries.insert(0, entry(PLAIN_NUMBERS, Self::Text("SI".to_string()).node()));
        }
        resolved::write(&node, base)
    }

    /// The value as TOML on one line.
    pub fn inline(&self) -> String {
        self.node().value.inline()
    }

    fn node(&self) -> Node {
        let value = match self {
            Self::Text(text) => Value::String(text.clone()),
            Self::Integer(integer) => Value::Integer(*integer),
            Self::Number(number) => Value::Float(*number),
            Self::Boolean(boolean) => Value::Boolean(*boolean),
            Self::List(items) => Value::Array(items.iter().map(Self::node).collect()),
            Self::Table(entries) => Value::Table(entries.iter().map(|(key, value)| entry(key, value.node())).collect()),
        };
        let span = Span::default();
        Node { value, span }
    }
}

/// A value of a program that is none of a scenario, where a text stands in for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Foreign {
    /// The path of its key, as `grains[0].diameter`.
    pub path: String,
    /// What it is and what is allowed.
    pub message: String,
}

/// Everything that is wrong with a text in which texts stand in for foreign values: those, and what its reader found in other
/// places (`read`).
pub fn faults_with_foreign(text: &str, name: &str, foreign: &[Foreign], read: Option<Diagnostics>) -> Diagnostics {
    let mut faults = read.unwrap_or_else(|| match tree(text, name, &[]) {
        Ok(document) => Diagnostics::new(name, document),
        Err(_) => Diagnostics::new(name, Arc::new(Document::without_keys(Vec::new()))),
    });
    faults.retain(|fault| foreign.iter().all(|value| !is_at_or_below(&fault.path, &value.path)));
    for value in foreign {
        faults.push(&value.path, value.message.as_str(), None);
    }
    faults
}

fn is_at_or_below(path: &str, above: &str) -> bool {
    !above.is_empty()
        && path
            .strip_prefix(above)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
}

/// The key that says what numbers without a unit stand for.
pub(super) const PLAIN_NUMBERS: &str = "plain_numbers";

fn entry(key: &str, node: Node) -> Entry {
    Entry {
        key: key.to_string(),
        key_span: Span::default(),
        node,
    }
}

#[cfg(test)]
mod tests {
    use super::super::Scenario;
    use super::*;

    fn table(entries: &[(&str, Plain)]) -> Plain {
        Plain::Table(entries.iter().map(|(k, v)| ((*k).to_string(), v.clone())).collect())
    }

    fn numbers(values: &[f64]) -> Plain {
        Plain::List(values.iter().map(|v| Plain::Number(*v)).collect())
    }

    fn text(text: &str) -> Plain {
        Plain::Text(text.to_string())
    }

    fn two_grains(duration: Plain) -> Plain {
        let glass = table(&[
            ("young_modulus", text("10 MPa")),
            ("poisson_ratio", Plain::Number(0.25)),
            ("density", Plain::Integer(2500)),
        ]);
        let law = table(&[
            ("law", text("linear")),
            ("stiffness", Plain::Number(1e3)),
            ("restitution", Plain::Number(0.5)),
        ]);
        let position = Plain::List(vec![numbers(&[0.0, 0.0, 0.0]), numbers(&[0.0, 0.0, 3e-3])]);
        table(&[
            ("material", table(&[("glass", glass)])),
            ("contact", table(&[("normal", law)])),
            (
                "grains",
                Plain::List(vec![table(&[
                    ("material", text("glass")),
                    ("source", text("list")),
                    ("positions", position),
                    ("diameter", Plain::Number(2e-3)),
                ])]),
            ),
            (
                "stage",
                Plain::List(vec![table(&[("name", text("fall")), ("duration", duration)])]),
            ),
        ])
    }

    #[test]
    fn plain_numbers_are_si_and_stay_so_in_the_folder_of_the_run() {
        let toml = two_grains(Plain::Number(0.25)).to_toml(Path::new("/data"));
        let scenario =
            Scenario::parse(&toml, "dict", Path::new(""), &[]).unwrap_or_else(|f| panic!("{}", f.render(false)));
        assert_eq!(scenario.materials[0].density, 2500.0);
        let again = Scenario::parse(&scenario.to_resolved_toml(), "again", Path::new(""), &[]).unwrap();
        assert_eq!(again.stages, scenario.stages);
        // units still go, and are still checked
        let toml = two_grains(text("250 ms")).to_toml(Path::new(""));
        let with_units = Scenario::parse(&toml, "dict", Path::new(""), &[]).unwrap();
        assert_eq!(with_units.stages, scenario.stages);
        let toml = two_grains(text("250 mm")).to_toml(Path::new(""));
        let faults = Scenario::parse(&toml, "dict", Path::new(""), &[]).unwrap_err();
        assert_eq!(faults.list()[0].path, "stage[0].duration");
    }

    #[test]
    fn foreign_values_are_told_with_all_other_faults() {
        let toml = two_grains(text("a value of type set")).to_toml(Path::new(""));
        let toml = toml.replace("poisson_ratio = 0.25", "poisson_ratio = 3");
        let read = Scenario::parse(&toml, "dict", Path::new(""), &[]).unwrap_err();
        let foreign = Foreign {
            path: "stage[0].duration".to_string(),
            message: "`stage[0].duration` is a value of type set".to_string(),
        };
        let faults = faults_with_foreign(&toml, "dict", std::slice::from_ref(&foreign), Some(read));
        let told: Vec<(&str, bool)> = faults.list().iter().map(|f| (f.path.as_str(), f.line > 0)).collect();
        assert_eq!(
            told,
            [("material.glass.poisson_ratio", true), ("stage[0].duration", true)]
        );
        assert!(faults.to_string().contains("type set"), "{faults}");
        let alone = faults_with_foreign(&toml, "dict", &[foreign], None);
        assert_eq!(alone.list().len(), 1);
    }

    #[test]
    fn without_the_word_a_number_needs_its_unit() {
        let toml = two_grains(Plain::Number(0.25)).to_toml(Path::new(""));
        let toml = toml.replace("plain_numbers = \"SI\"\n", "");
        let faults = Scenario::parse(&toml, "dict", Path::new(""), &[]).unwrap_err();
        assert!(faults.to_string().contains("with a unit"), "{faults}");
        let toml = format!("plain_numbers = \"cgs\"\n{toml}");
        let faults = Scenario::parse(&toml, "dict", Path::new(""), &[]).unwrap_err();
        assert!(faults.to_string().contains("known are `SI`"), "{faults}");
    }
}
