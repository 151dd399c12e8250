//! Writes the tree of a scenario back as TOML, so that it means the same when it is read from another folder.

use super::document::{Entry, Node, Value, join, written_key};
use std::path::Path;

/// The tree as TOML, with the paths of files made absolute from `base`.
pub(super) fn write(root: &Node, base: &Path) -> String {
    let mut text = String::new();
    if let Value::Table(entries) = &root.value {
        write_table("", entries, base, &mut text);
    }
    text
}

/// Whether a value is written as tables of its own: a table, or a list of tables only.
fn has_header(value: &Value) -> bool {
    match value {
        Value::Table(_) => true,
        Value::Array(items) => !items.is_empty() && items.iter().all(|n| matches!(n.value, Value::Table(_))),
        _ => false,
    }
}

/// Tables this deep are written on one line: `motion = { velocity = [...] }` reads better than a header of its own.
fn is_section(path: &str, entry: &Entry) -> bool {
    let below_material = path == "material";
    let nested = ["pair", "stage"].contains(&entry.key.as_str());
    has_header(&entry.node.value) && (path.is_empty() || below_material || nested)
}

/// A value with the paths of files in the tables inside of it made absolute.
fn with_files_of(value: &Value, base: &Path) -> Value {
    match value {
        Value::Array(items) => {
            let item = |node: &Node| Node {
                value: with_files_of(&node.value, base),
                ..node.clone()
            };
            Value::Array(items.iter().map(item).collect())
        }
        Value::Table(entries) => {
            let entry = |entry: &Entry| {
                let mut entry = entry.clone();
                entry.node.value = match &entry.node.value {
                    Value::String(file) if entry.key == "file" => Value::String(base.join(file).display().to_string()),
                    other => with_files_of(other, base),
                };
                entry
            };
            Value::Table(entries.iter().map(entry).collect())
        }
        other => other.clone(),
    }
}

fn write_table(path: &str, entries: &[Entry], base: &Path, text: &mut String) {
    for entry in entries.iter().filter(|e| !is_section(path, e)) {
        let value = match &entry.node.value {
            Value::String(file) if entry.key == "file" => Value::String(base.join(file).display().to_string()).inline(),
            other => with_files_of(other, base).inline(),
        };
        text.push_str(&format!("{} = {value}\n", written_key(&entry.key)));
    }
    for entry in entries.iter().filter(|e| is_section(path, e)) {
        let below = join(path, &entry.key);
        match &entry.node.value {
            Value::Array(items) => {
                for item in items {
                    if let Value::Table(entries) = &item.value {
                        text.push_str(&format!("\n[[{below}]]\n"));
                        write_table(&below, entries, base, text);
                    }
                }
            }
            Value::Table(entries) => {
                let only_sections = !entries.is_empty() && entries.iter().all(|e| is_section(&below, e));
                if !only_sections {
                    text.push_str(&format!("\n[{below}]\n"));
                }
                write_table(&below, entries, base, text);
            }
            _ => {}
        }
    }
}
