//! The text of a law, written for a terminal, with its formulas as those of the other chapters.

use super::plain_maths::{Names, latex};

/// The text with `$` around its formulas: blocks of text, and code that is a formula. `parameters` are those of the law, whose names
/// stay code.
pub fn with_formulas(text: &str, parameters: &[&str]) -> Result<String, String> {
    let names = Names::new(symbols(text).into_iter().map(str::to_string));
    let mut made = String::new();
    let mut block: Option<Vec<&str>> = None;
    let mut other_fence = false;
    for line in text.lines() {
        match (&mut block, line.trim_end()) {
            (None, "```text") if !other_fence => block = Some(Vec::new()),
            (Some(lines), "```") => {
                made.push_str(&formulas(lines, &names)?);
                block = None;
            }
            (Some(lines), line) => lines.push(line),
            (None, line) => {
                other_fence ^= line.starts_with("```");
                let line = if other_fence {
                    line.to_string()
                } else {
                    inline(line, &names, parameters)?
                };
                made.push_str(&line);
                made.push('\n');
            }
        }
    }
    Ok(made)
}

/// Codes in the first column of the table of symbols.
fn symbols(text: &str) -> Vec<&str> {
    let rows = text.lines().skip_while(|line| !line.starts_with("| symbol ")).skip(2);
    let cells = rows
        .take_while(|line| line.starts_with('|'))
        .filter_map(|row| row.split('|').nth(1));
    cells.flat_map(codes).collect()
}

fn codes(text: &str) -> impl Iterator<Item = &str> {
    text.split('`').skip(1).step_by(2)
}

/// A line with its formulas between `$`. In the column of symbols names are those of the formulas.
fn inline(line: &str, names: &Names, parameters: &[&str]) -> Result<String, String> {
    let first_column = line
        .strip_prefix('|')
        .and_then(|row| row.find('|'))
        .map_or(0, |end| end + 1);
    let mut made = String::new();
    let mut place = 0;
    for (index, part) in line.split('`').enumerate() {
        let is_parameter = parameters.contains(&part) && place >= first_column;
        if index % 2 == 0 {
            made.push_str(part);
        } else if !is_parameter && names.makes(part, parameters) {
            made.push_str(&format!(
                "${}$",
                latex(part, names, false).map_err(|error| format!("`{part}`: {error}"))?
            ));
        } else {
            made.push_str(&format!("`{part}`"));
        }
        place += part.len() + 1;
    }
    Ok(made)
}

/// The lines of a block; blank ones part formulas of their own.
fn formulas(lines: &[&str], names: &Names) -> Result<String, String> {
    let mut made = String::new();
    for group in lines
        .split(|line| line.trim().is_empty())
        .filter(|group| !group.is_empty())
    {
        made.push_str(&format!("$$\n{}\n$$\n", table(group, names)?));
    }
    Ok(made)
}

/// The parts of a line that two spaces or more keep apart, each with its place.
fn parts(line: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut at = 0;
    for part in line.split("  ") {
        let text = part.trim();
        if !text.is_empty() {
            found.push((at + part.len() - part.trim_start().len(), text));
        }
        at += part.len() + 2;
    }
    found
}

/// Lines one below the other; parts that begin at the same place in two of them stand in a column.
fn table(lines: &[&str], names: &Names) -> Result<String, String> {
    let lines: Vec<Vec<(usize, &str)>> = lines.iter().map(|line| parts(line)).collect();
    let is_shared = |place: usize| {
        lines
            .iter()
            .filter(|parts| parts.iter().any(|(at, _)| *at == place))
            .count()
            > 1
    };
    let mut columns: Vec<usize> = lines
        .iter()
        .flatten()
        .map(|(at, _)| *at)
        .filter(|at| *at == 0 || is_shared(*at))
        .collect();
    columns.push(0);
    columns.sort_unstable();
    columns.dedup();
    let mut rows = Vec::new();
    for parts in &lines {
        let mut cells = vec![String::new(); columns.len()];
        let mut column = 0;
        for (at, part) in parts {
            column = columns.binary_search(at).unwrap_or(column);
            let formula = latex(part, names, true).map_err(|error| format!("`{part}`: {error}"))?;
            let between = if cells[column].is_empty() {
                "\\displaystyle "
            } else {
                " \\qquad "
            };
            cells[column] += &format!("{between}{formula}");
        }
        rows.push(cells.join(" & "));
    }
    match rows.as_slice() {
        [row] if columns.len() == 1 => Ok(row.clone()),
        rows => Ok(format!(
            "\\begin{{array}}{{{}}}\n{}\n\\end{{array}}",
            "l".repeat(columns.len()),
            rows.join(" \\\\\n")
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::book::maths;
    use crate::shell::{read, root};

    #[test]
    fn blocks_and_codes_become_formulas_and_parameters_stay_code() {
        let text = "\
A law with `alpha`.

```text
F = k d        loading
F = kc d - p   else
```

| symbol | meaning | unit |
|---|---|---|
| `kc`, `alpha` | `alpha` or the work `1/2 kc d^2` of `jkr` | N/m |
";
        let made = with_formulas(text, &["alpha"]).unwrap();
        assert!(
            made.starts_with("A law with `alpha`.\n\n$$\n\\begin{array}{ll}\n"),
            "{made}"
        );
        assert!(made.contains("F = k d & \\displaystyle \\;\\text{loading}"), "{made}");
        assert!(
            made.contains("| $k_{c}$, $\\alpha$ | `alpha` or the work $1 / 2 k_{c} d^{2}$ of `jkr` | N/m |"),
            "{made}"
        );
    }

    /// The texts of all laws: every block is a formula that can be drawn.
    #[test]
    fn the_formulas_of_every_law_are_drawn() {
        let laws = root().join("crates/physics/src/contact");
        let mut count = 0;
        for family in std::fs::read_dir(laws)
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .filter(|path| path.is_dir())
        {
            for file in std::fs::read_dir(family).unwrap().map(|entry| entry.unwrap().path()) {
                if file.extension().is_none_or(|extension| extension != "md") {
                    continue;
                }
                let made = with_formulas(&read(&file).unwrap(), &[])
                    .unwrap_or_else(|error| panic!("{}: {error}", file.display()));
                let drawn = maths::render(&made).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
                assert!(
                    !made.contains("```text") && drawn.contains("<math"),
                    "{}",
                    file.display()
                );
                count += 1;
            }
        }
        assert!(count > 15, "only {count} laws were found");
    }
}
