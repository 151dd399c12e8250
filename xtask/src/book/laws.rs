//! A page for every contact law, from the registries.

use super::{law_text, said};
use crate::shell::write;
use serde_json::Value;
use std::path::Path;

/// A law as `demeter laws --json` tells it.
pub struct Law {
    name: String,
    family: String,
    summary: String,
    told: Value,
}

impl Law {
    fn text(&self, key: &str) -> &str {
        self.told[key].as_str().unwrap_or_default()
    }

    fn page(&self) -> String {
        format!("laws/{}/{}.md", self.family, self.name)
    }
}

/// All laws.
pub fn known(demeter: &Path) -> Result<Vec<Law>, String> {
    let answer = said(demeter, Path::new("."), "demeter laws --json")?;
    let answer: Value = serde_json::from_str(&answer).map_err(|error| format!("demeter laws --json: {error}"))?;
    let laws = answer["laws"].as_array().ok_or("demeter laws --json tells no laws")?;
    let text = |law: &Value, key: &str| law[key].as_str().unwrap_or_default().to_string();
    let law = |law: &Value| Law {
        name: text(law, "name"),
        family: text(law, "family"),
        summary: text(law, "summary"),
        told: law.clone(),
    };
    Ok(laws.iter().map(law).collect())
}

/// The laws in the table of contents, by family.
pub fn summary(laws: &[Law]) -> String {
    let mut lines = Vec::new();
    for law in laws {
        lines.push(format!("  - [`{}`, {}]({})", law.name, law.family, law.page()));
    }
    lines.join("\n")
}

/// The laws in one table for every family.
pub fn list(laws: &[Law]) -> String {
    let mut families: Vec<&str> = laws.iter().map(|law| law.family.as_str()).collect();
    families.dedup();
    let mut text = String::new();
    for family in families {
        text.push_str(&format!(
            "## `{}` laws\n\n| law | what it is | parameters |\n|---|---|---|\n",
            family.replace('-', "_")
        ));
        for law in laws.iter().filter(|law| law.family == family) {
            let parameters = law.told["parameters"].as_array().into_iter().flatten();
            let names: Vec<String> = parameters
                .map(|p| format!("`{}`", p["name"].as_str().unwrap_or_default()))
                .collect();
            text.push_str(&format!(
                "| [`{}`]({}) | {} | {} |\n",
                law.name,
                law.page(),
                law.summary,
                names.join(", ")
            ));
        }
        text.push('\n');
    }
    text
}

/// Writes the page of every law.
pub fn pages(source: &Path, laws: &[Law]) -> Result<(), String> {
    for law in laws {
        let page = source.join(law.page());
        let folder = page.parent().unwrap_or(source);
        std::fs::create_dir_all(folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
        let text = text(law).map_err(|error| format!("the law {}: {error}", law.name))?;
        write(&page, &text)?;
    }
    Ok(())
}

fn text(law: &Law) -> Result<String, String> {
    let parameters: Vec<&Value> = law.told["parameters"].as_array().into_iter().flatten().collect();
    let names: Vec<&str> = parameters.iter().filter_map(|p| p["name"].as_str()).collect();
    let mut page = format!(
        "# `{}`\n\n*A {} law: {}.*\n\n{}\n\n",
        law.name,
        law.family,
        law.summary,
        law_text::with_formulas(law.text("doc").trim(), &names)?
    );
    page.push_str("## Parameters\n\n");
    if parameters.is_empty() {
        page.push_str("None.\n\n");
    } else {
        page.push_str("| parameter | value | allowed | when not given | meaning |\n|---|---|---|---|---|\n");
        for parameter in parameters {
            page.push_str(&row(parameter));
        }
        page.push('\n');
    }
    for group in law.told["alternatives"].as_array().into_iter().flatten() {
        page.push_str(&alternatives(group));
    }
    page.push_str(&format!(
        "## Example\n\n```toml\n[contact]\n{}\n```\n\n`demeter laws {}` tells the same on the command line.\n",
        law.text("example"),
        law.name
    ));
    Ok(page)
}

fn row(parameter: &Value) -> String {
    let text = |key: &str| parameter[key].as_str().unwrap_or_default();
    let unit = text("unit");
    let (value, allowed) = match parameter["choices"].as_array() {
        Some(words) => {
            let words: Vec<String> = words
                .iter()
                .filter_map(Value::as_str)
                .map(|w| format!("`\"{w}\"`"))
                .collect();
            ("a word".to_string(), words.join(" or "))
        }
        None if parameter["may_depend_on_speed"] == true => (
            "number, rows of speed and restitution, or formula in `v`".to_string(),
            text("range").to_string(),
        ),
        None if unit.is_empty() => ("number".to_string(), text("range").to_string()),
        None => (format!("{} [{unit}]", text("quantity")), text("range").to_string()),
    };
    let otherwise = match (parameter["choices"].as_array(), &parameter["default"]) {
        (Some(words), _) => format!("`{}`", words.first().unwrap_or(&Value::Null)),
        (None, Value::Number(number)) => format!("{number}"),
        _ if parameter["required"] == true => format!("must be given; typically {}", parameter["typical"]),
        _ => String::new(),
    };
    format!(
        "| `{}` | {value} | {allowed} | {otherwise} | {} |\n",
        text("name"),
        text("meaning")
    )
}

fn alternatives(group: &Value) -> String {
    let names = |key: &str| -> Vec<String> {
        let names = group[key].as_array().into_iter().flatten();
        names
            .filter_map(Value::as_str)
            .map(|name| format!("`{name}`"))
            .collect()
    };
    let (of, with) = (names("of"), names("with"));
    let mut text = format!("One of {} is given.", of.join(", "));
    if !with.is_empty() {
        text.push_str(&format!(" {} only with them.", with.join(", ")));
    }
    text + "\n\n"
}
