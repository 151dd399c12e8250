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

/// A value with the paths of files in it made absolute.
fn absolute(key: &str, value: &Value, base: &Path) -> Value {
    match value {
        Value::String(file) if key == "file" => Value::String(base.join(file).display().to_string()),
        Value::Table(entries) => {
            let mut entries = entries.clone();
            for entry in &mut entries {
                entry.node.value = absolute(&entry.key, &entry.node.value, base);
            }
            Value::Table(entries)
        }
        Value::Array(items) => {
            let mut items = items.clone();
            for item in &mut items {
                item.value = absolute("", &item.value, base);
            }
            Value::Array(items)
        }
        other => other.clone(),
    }
}

fn write_table(path: &str, entries: &[Entry], base: &Path, text: &mut String) {
    for entry in entries.iter().filter(|e| !is_section(path, e)) {
        let value = absolute(&entry.key, &entry.node.value, base).inline();
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
