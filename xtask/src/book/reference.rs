//! The tables of keys, with links between them.

/// The tables of a reference: everything from the first heading on, one level deeper, and `table` a link to its keys.
pub fn tables(reference: &str) -> String {
    let sections: Vec<String> = reference.lines().filter_map(section).collect();
    let mut lines: Vec<String> = Vec::new();
    let mut own = String::new();
    // what stands before the first heading is for readers of the code where it names its items
    let skipped = match reference.split_once("\n# ") {
        Some((lead, _)) if !lead.starts_with('#') && lead.contains("[`") => lead.lines().count(),
        _ => 0,
    };
    for line in reference.lines().skip(skipped) {
        if let Some(name) = section(line) {
            own.clone_from(&name);
            let (_, told) = line.split_once("`: ").unwrap_or(("", ""));
            let shown = if name.is_empty() {
                "The top of the file".to_string()
            } else {
                format!("`{name}`")
            };
            let is_top = name.is_empty();
            lines.push(format!("## {shown} {{#{}}}", anchor(&name)));
            if !told.is_empty() && !is_top {
                let mut told = told.to_string();
                told[..1].make_ascii_uppercase();
                lines.push(format!("\n{}.", told.trim_end_matches('.')));
            }
        } else if line.starts_with("| `") {
            lines.push(linked(line, &own, &sections));
        } else if let Some(title) = line.strip_prefix("# ") {
            lines.push(format!("## {title}"));
        } else {
            lines.push(plain(line));
        }
    }
    lines.join("\n")
}

fn section(line: &str) -> Option<String> {
    let heading = line.strip_prefix("## `")?;
    Some(heading.split('`').next().unwrap_or_default().trim().to_string())
}

fn anchor(section: &str) -> String {
    match section {
        "" => "top-of-the-file".to_string(),
        section => format!(
            "keys-{}",
            section.replace("[]", "").replace('.', "-").replace('*', "name")
        ),
    }
}

/// A row whose `table` leads to the keys of that table.
fn linked(row: &str, own: &str, sections: &[String]) -> String {
    let key = row.split('`').nth(1).unwrap_or_default();
    let child = if own.is_empty() {
        key.to_string()
    } else {
        format!("{own}.{key}")
    };
    let mut cells: Vec<String> = row.split(" | ").map(str::to_string).collect();
    for cell in cells.iter_mut().skip(1) {
        let named = ["list of tables `", "table `"].iter().find_map(|start| {
            let (before, rest) = cell.split_once(start)?;
            let (name, after) = rest.split_once('`')?;
            sections.contains(&name.to_string()).then(|| {
                let words = start.trim_end_matches(" `");
                format!("{before}[{words}](#{}){}", anchor(name), after)
            })
        });
        if let Some(named) = named {
            *cell = named;
            continue;
        }
        let target = match cell.as_str() {
            "table" | "length or table" => child.clone(),
            "list of tables" => format!("{child}[]"),
            "tables by name" => format!("{child}.*"),
            "motion" | "motions by name" => "motion".to_string(),
            "number or table" => child.clone(),
            _ => continue,
        };
        if sections.contains(&target) {
            let link = format!("(#{})", anchor(&target));
            *cell = match cell.split_once("table") {
                Some((before, after)) => {
                    let before_words = before.strip_suffix("list of ").map_or(before, |b| b);
                    let words = format!("{}table{after}", &before[before_words.len()..]);
                    format!("{before_words}[{words}]{link}")
                }
                None => format!("[{cell}]{link}"),
            };
        }
    }
    cells.join(" | ")
}

/// A line without the links that only rustdoc knows.
fn plain(line: &str) -> String {
    let mut made = line.replace("[`units`]", "[units](units.md)");
    while let Some((before, rest)) = made.split_once("[`")
        && let Some((name, after)) = rest.split_once("`]")
        && !after.starts_with('(')
    {
        made = format!("{before}`{name}`{after}");
    }
    made
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_lead_to_their_keys() {
        let text = "# Keys\n\n## `` : the top\n\n| key | value | meaning | otherwise |\n|---|---|---|---|\n\
            | `wall` | list of tables | walls | none |\n| `output` | table | [`x`] | |\n\n## `wall[]`\n\n## `output`\n";
        let made = tables(text);
        assert!(
            made.contains("| `wall` | [list of tables](#keys-wall) | walls"),
            "{made}"
        );
        assert!(made.contains("| `output` | [table](#keys-output) |"), "{made}");
        assert!(made.contains("## `wall[]` {#keys-wall}"), "{made}");
    }
}
