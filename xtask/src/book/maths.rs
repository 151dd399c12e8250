//! Formulas: LaTeX between `$` becomes MathML.

use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

/// A text with its formulas as MathML. What stands in code is left alone.
pub fn render(text: &str) -> Result<String, String> {
    let mut made = String::new();
    let mut fence = false;
    let mut block: Option<String> = None;
    for line in text.lines() {
        let trimmed = line.trim_start();
        if trimmed.starts_with("```") && block.is_none() {
            fence = !fence;
        }
        match (&mut block, fence || trimmed.starts_with("```")) {
            (None, true) => made.push_str(line),
            (None, false) if trimmed == "$$" => block = Some(String::new()),
            (None, false) => made.push_str(&inline(line)?),
            (Some(latex), _) if trimmed == "$$" => {
                made.push_str(&format!(
                    "<div class=\"formula\">{}</div>",
                    formula(latex, DisplayMode::Block)?
                ));
                block = None;
            }
            (Some(latex), _) => {
                latex.push_str(line);
                latex.push('\n');
                continue;
            }
        }
        if block.is_none() {
            made.push('\n');
        }
    }
    match block {
        Some(latex) => Err(format!("a formula does not end: {latex}")),
        None => Ok(made),
    }
}

/// A line with its formulas between single `$`.
fn inline(line: &str) -> Result<String, String> {
    let mut made = String::new();
    let mut parts = line.split('`').enumerate().peekable();
    while let Some((index, part)) = parts.next() {
        if index % 2 == 1 {
            made.push_str(part);
        } else {
            let mut pieces = part.split('$');
            made.push_str(pieces.next().unwrap_or_default());
            while let Some(latex) = pieces.next() {
                let Some(after) = pieces.next() else {
                    return Err(format!("a formula does not end: {line}"));
                };
                made.push_str(&formula(latex, DisplayMode::Inline)?);
                made.push_str(after);
            }
        }
        if parts.peek().is_some() {
            made.push('`');
        }
    }
    Ok(made)
}

fn formula(latex: &str, display_mode: DisplayMode) -> Result<String, String> {
    let storage = Storage::new();
    let parsed: Result<Vec<_>, _> = Parser::new(latex, &storage).collect();
    let events = parsed.map_err(|error| format!("`{}`: {error}", latex.trim()))?;
    let config = RenderConfig {
        display_mode,
        ..RenderConfig::default()
    };
    let mut made = String::new();
    let events = events.into_iter().map(Ok::<_, std::convert::Infallible>);
    push_mathml(&mut made, events, config).map_err(|error| format!("`{}`: {error}", latex.trim()))?;
    // neither Markdown nor its tables may find anything to do in it
    let escaped = [
        // a sign alone is written as it is, where HTML wants its name
        ("><<", ">&lt;<"),
        // a slash in a formula of one line needs no room
        (">/</mo>", " lspace=\"0\" rspace=\"0\">/</mo>"),
        ("\n", " "),
        ("|", "&#124;"),
        ("*", "&#42;"),
        ("_", "&#95;"),
        ("`", "&#96;"),
    ];
    Ok(escaped.iter().fold(made, |text, (from, to)| text.replace(from, to)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_are_drawn_and_code_is_not() {
        let made = render("a $x^2$ b `$y$`\n\n```text\n$z$\n```\n\n$$\n\\frac{1}{2} m v^2\n$$\n").unwrap();
        assert_eq!(made.matches("<math").count(), 2, "{made}");
        assert!(made.contains("`$y$`") && made.contains("\n$z$\n"), "{made}");
        assert!(made.contains("<mfrac"), "{made}");
        assert!(render("$a < b$").unwrap().contains(">&lt;<"));
        assert!(render("a $x").is_err());
        assert!(render("$$\n\\frac{1}{\n$$\n").is_err());
    }
}
