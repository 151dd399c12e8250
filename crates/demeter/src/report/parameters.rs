//! With which parameters it was run: the scenario as tables, in the units in which it was written.

use super::html::Html;
use super::plots::{Group, SERIES};
use demeter_physics::contact::laws;
use std::collections::BTreeSet;
use toml::{Table, Value};

/// Most rows of a table; the scenario below holds all.
const MOST_ROWS: usize = 100;
/// Most characters of a cell.
const LONGEST: usize = 240;

/// The scenario of a run, as it was resolved.
pub(super) struct Parameters(Table);

impl Parameters {
    /// Reads the text; the error tells why it cannot be read.
    pub fn read(text: &str) -> Result<Self, String> {
        text.parse()
            .map(Self)
            .map_err(|e: toml::de::Error| e.message().to_string())
    }

    /// The title that the scenario tells.
    pub fn title(&self) -> Option<&str> {
        self.0.get("title")?.as_str()
    }

    /// The plots that the scenario asks for.
    pub fn plots(&self) -> Vec<Group> {
        let plots = self.0.get("output").and_then(|output| output.get("plots"));
        let plots = plots.and_then(Value::as_array).into_iter().flatten();
        plots.filter_map(asked).collect()
    }

    /// Names of the measures that are profiles.
    pub fn profiles(&self) -> Vec<&str> {
        let measures = self.0.get("measure").and_then(Value::as_array).into_iter().flatten();
        let profiles = measures.filter(|measure| measure.get("kind").and_then(Value::as_str) == Some("profile"));
        let names = profiles.filter_map(|measure| measure.get("name")?.as_str());
        // the scenario in the folder may be anything
        names.filter(|name| !name.contains(['/', '\\'])).collect()
    }

    /// What the names of columns of measures, feeds, removals, the domain and the box begin with.
    pub fn owners_of_columns(&self) -> Vec<String> {
        let names = |key: &str, start: &str| -> Vec<String> {
            let tables = self.0.get(key).and_then(Value::as_array).into_iter().flatten();
            let names = tables.filter_map(|table| table.get("name")?.as_str());
            names.map(|name| format!("{start}{name}")).collect()
        };
        [
            names("measure", ""),
            names("feed", "feed "),
            names("removal", "removal "),
            vec!["domain".to_string(), "box".to_string()],
        ]
        .concat()
    }

    /// All tables.
    pub fn write(&self, html: &mut Html) {
        self.materials(html);
        self.contact(html);
        for (key, title) in [
            ("grains", "Grains"),
            ("feed", "Feeds"),
            ("removal", "Removals"),
            ("wall", "Walls"),
            ("tag", "Tags"),
            ("measure", "Measures"),
            ("stage", "Stages"),
        ] {
            self.list(key, title, html);
        }
        for (key, title) in [("simulation", "Simulation"), ("domain", "Domain"), ("output", "Output")] {
            if let Some(table) = self.0.get(key).and_then(Value::as_table) {
                html.words(title, &["key", "value"], &entries(table, &[]));
            }
        }
    }

    /// One column for each material.
    fn materials(&self, html: &mut Html) {
        let Some(materials) = self.0.get("material").and_then(Value::as_table) else {
            return;
        };
        let tables: Vec<(&String, &Table)> = materials
            .iter()
            .filter_map(|(name, value)| Some((name, value.as_table()?)))
            .take(MOST_ROWS)
            .collect();
        let keys: BTreeSet<&String> = tables.iter().flat_map(|(_, table)| table.keys()).collect();
        let cell = |key: &String, table: &Table| table.get(key).map_or_else(|| "–".to_string(), shown);
        let rows: Vec<Vec<String>> = (keys.iter().take(MOST_ROWS))
            .map(|key| {
                std::iter::once(words(key))
                    .chain(tables.iter().map(|(_, table)| cell(key, table)))
                    .collect()
            })
            .collect();
        let titles: Vec<&str> = std::iter::once("property")
            .chain(tables.iter().map(|(name, _)| name.as_str()))
            .collect();
        html.words("Materials", &titles, &rows);
    }

    /// One row for each pair of materials, and what the laws are.
    fn contact(&self, html: &mut Html) {
        let Some(contact) = self.0.get("contact").and_then(Value::as_table) else {
            return;
        };
        let pairs: Vec<&Table> = contact
            .get("pair")
            .and_then(Value::as_array)
            .into_iter()
            .flatten()
            .filter_map(Value::as_table)
            .collect();
        let own: Vec<&String> = contact.keys().filter(|key| *key != "pair").collect();
        let mut families = own.clone();
        for key in pairs.iter().flat_map(|pair| pair.keys()) {
            if key != "between" && !families.contains(&key) {
                families.push(key);
            }
        }
        let without = |table: &Table| {
            if std::ptr::eq(table, contact) {
                "–"
            } else {
                "as other pairs"
            }
        };
        let cell = |table: &Table, key: &String| table.get(key).map_or_else(|| without(table).to_string(), shown);
        let row = |name: String, table: &Table| {
            std::iter::once(name)
                .chain(families.iter().map(|key| cell(table, key)))
                .collect()
        };
        let mut rows: Vec<Vec<String>> = Vec::new();
        if !own.is_empty() {
            rows.push(row(
                if pairs.is_empty() { "all pairs" } else { "other pairs" }.to_string(),
                contact,
            ));
        }
        rows.extend(
            pairs
                .iter()
                .take(MOST_ROWS)
                .map(|pair| row(pair.get("between").map_or_else(String::new, shown), pair)),
        );
        let labels: Vec<String> = families.iter().map(|key| words(key)).collect();
        let titles: Vec<&str> = std::iter::once("materials")
            .chain(labels.iter().map(String::as_str))
            .collect();
        html.words("Contact laws", &titles, &rows);
        self.law_summaries(html);
    }

    /// What the laws that are used are, in a line each.
    fn law_summaries(&self, html: &mut Html) {
        let mut used = BTreeSet::new();
        for told in ["contact", "stage"].iter().filter_map(|key| self.0.get(*key)) {
            names_of_laws(told, &mut used);
        }
        let told: Vec<_> = laws().filter(|law| used.contains(law.name)).collect();
        if told.is_empty() {
            return;
        }
        html.raw("<dl class=\"laws\">");
        for law in told {
            html.element("dt", law.name);
            html.element("dd", &format!("{} ({} law)", law.summary, law.family));
        }
        html.raw("</dl>");
    }

    /// One row for each table of a list.
    fn list(&self, key: &str, title: &str, html: &mut Html) {
        let tables: Vec<&Table> = self
            .0
            .get(key)
            .and_then(Value::as_array)
            .into_iter()
            .flatten()
            .filter_map(Value::as_table)
            .collect();
        if tables.is_empty() {
            return;
        }
        let name = |k: usize, table: &Table| table.get("name").map_or_else(|| (k + 1).to_string(), shown);
        let told = |table: &Table| {
            let parts: Vec<String> = entries(table, &["name"]).iter().map(|row| row.join(" ")).collect();
            parts.join("; ")
        };
        let mut rows: Vec<Vec<String>> = (tables.iter().enumerate().take(MOST_ROWS))
            .map(|(k, table)| vec![name(k, table), told(table)])
            .collect();
        if tables.len() > MOST_ROWS {
            rows.push(vec![
                "…".to_string(),
                format!("{} more in the scenario below", tables.len() - MOST_ROWS),
            ]);
        }
        html.words(title, &["name", "parameters"], &rows);
    }
}

/// A plot of `[output]`.
fn asked(plot: &Value) -> Option<Group> {
    let x = plot.get("x")?.as_str()?.to_string();
    let y: Vec<String> = match plot.get("y")? {
        Value::String(one) => vec![one.clone()],
        several => several
            .as_array()?
            .iter()
            .filter_map(|y| Some(y.as_str()?.to_string()))
            .collect(),
    };
    let title = plot
        .get("name")
        .and_then(Value::as_str)
        .map_or_else(|| format!("{} over {x}", y.join(", ")), str::to_string);
    Some(Group {
        title,
        place: SERIES,
        x,
        y,
        left_out: 0,
    })
}

/// Keys and values of a table, but for some keys.
fn entries(table: &Table, without: &[&str]) -> Vec<Vec<String>> {
    let kept = table.iter().filter(|(key, _)| !without.contains(&key.as_str()));
    kept.take(MOST_ROWS)
        .map(|(key, value)| vec![words(key), shown(value)])
        .collect()
}

/// A key as words: `young modulus`.
fn words(key: &str) -> String {
    shortened(key.replace('_', " "))
}

/// A value as people write it: texts without quotes, a law by its name with its parameters in brackets.
fn shown(value: &Value) -> String {
    shortened(plain(value))
}

fn plain(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(items) => items.iter().take(MOST_ROWS).map(plain).collect::<Vec<_>>().join(", "),
        Value::Table(table) => {
            let head = ["law", "distribution", "shape"]
                .iter()
                .find_map(|key| Some((*key, table.get(*key)?.as_str()?)));
            let rest = table
                .iter()
                .filter(|(key, _)| head.is_none_or(|(name, _)| name != key.as_str()));
            let rest: Vec<String> = rest
                .take(MOST_ROWS)
                .map(|(key, value)| format!("{} {}", words(key), plain(value)))
                .collect();
            match head {
                Some((_, name)) if rest.is_empty() => name.to_string(),
                Some((_, name)) => format!("{name} ({})", rest.join(", ")),
                None => format!("({})", rest.join(", ")),
            }
        }
        other => other.to_string(),
    }
}

fn shortened(text: String) -> String {
    if text.chars().count() <= LONGEST {
        return text;
    }
    let cut: String = text.chars().take(LONGEST).collect();
    format!("{cut}…")
}

/// Collects what is called `law` anywhere in a value.
fn names_of_laws<'v>(value: &'v Value, found: &mut BTreeSet<&'v str>) {
    match value {
        Value::Table(table) => {
            for (key, value) in table {
                match value {
                    Value::String(name) if key == "law" => {
                        found.insert(name);
                    }
                    other => names_of_laws(other, found),
                }
            }
        }
        Value::Array(items) => items.iter().for_each(|item| names_of_laws(item, found)),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(text: &str) -> String {
        let mut html = Html::default();
        Parameters::read(text).unwrap().write(&mut html);
        html.as_str().to_string()
    }

    #[test]
    fn materials_and_laws_are_tables() {
        let html = page(
            r#"
            [material.glass]
            young_modulus = "60 GPa"
            [material.steel]
            density = "7800 kg/m^3"
            [contact]
            normal = { law = "hertz-tsuji", restitution = 0.9 }
            [[contact.pair]]
            between = ["glass", "steel"]
            normal = { law = "jkr", surface_energy = "20 mJ/m^2" }
            [[stage]]
            name = "shear"
            contact = { tangential = { law = "coulomb", friction = 0.3 } }
            "#,
        );
        assert!(
            html.contains("shear</th><td>contact (tangential coulomb (friction 0.3))</td>"),
            "{html}"
        );
        assert!(html.contains("<dt>coulomb</dt>"), "{html}");
        assert!(
            html.contains("<th scope=\"row\">young modulus</th><td>60 GPa</td><td>–</td>"),
            "{html}"
        );
        assert!(
            html.contains("<th scope=\"row\">other pairs</th><td>hertz-tsuji (restitution 0.9)</td>"),
            "{html}"
        );
        assert!(
            html.contains("<th scope=\"row\">glass, steel</th><td>jkr (surface energy 20 mJ/m^2)</td>"),
            "{html}"
        );
        assert!(html.contains("<dt>jkr</dt>"), "{html}");
    }

    #[test]
    fn texts_of_the_scenario_mean_themselves() {
        let html = page(
            r#"
            [material."<img src=x onerror=alert(1)>"]
            density = "<script>"
            [[wall]]
            name = "</td><script>alert(1)</script>"
            "#,
        );
        assert!(!html.contains("<img") && !html.contains("<script"), "{html}");
        assert!(html.contains("&lt;img src=x onerror=alert(1)&gt;"), "{html}");
    }

    #[test]
    fn long_lists_and_texts_are_cut_and_say_so() {
        let walls: String = (0..150)
            .map(|k| format!("[[wall]]\nname = \"w{k}\"\nshape = \"{}\"\n", "x".repeat(1000)))
            .collect();
        let html = page(&walls);
        assert!(html.contains("50 more in the scenario below") && !html.contains("w149"));
        assert!(html.len() < 100 * 400 + 1000, "{}", html.len());
    }

    #[test]
    fn plots_that_were_asked_for() {
        let text = "[output]\nplots = [{ x = \"strain\", y = \"wall top force z\" }, { name = \"n\", x = \"time\", y = [\"a\", \"b\"] }, 3]";
        let plots = Parameters::read(text).unwrap().plots();
        assert_eq!(plots.len(), 2);
        assert_eq!(plots[0].title, "wall top force z over strain");
        assert_eq!(plots[1].y, ["a", "b"]);
    }

    #[test]
    fn what_is_no_toml_is_told() {
        assert!(Parameters::read("a = ").is_err());
        assert!(page("material = 3\ncontact = 4\nwall = \"x\"").is_empty());
    }
}
