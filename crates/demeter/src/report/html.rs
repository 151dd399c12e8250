//! Text that becomes HTML. Whatever comes from outside goes through [`Html::text`] or [`escaped`].

use std::fmt::Write as _;

/// A piece of a page.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Html(String);

/// Text that means itself, inside elements and between the quotes of attributes.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // HTML knows no character without a shape but these
            c if c.is_control() && !matches!(c, '\n' | '\t') => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

impl Html {
    /// Adds HTML that this program wrote.
    pub fn raw(&mut self, html: &str) {
        self.0.push_str(html);
    }

    /// Adds text that means itself.
    pub fn text(&mut self, text: &str) {
        self.0.push_str(&escaped(text));
    }

    /// Adds a text whose parts between backticks are names or commands.
    pub fn prose(&mut self, text: &str) {
        let parts: Vec<&str> = text.split('`').collect();
        if parts.len().is_multiple_of(2) {
            // a backtick alone means itself
            return self.text(text);
        }
        for (k, part) in parts.iter().enumerate() {
            if k % 2 == 0 {
                self.text(part);
            } else {
                self.element("code", part);
            }
        }
    }

    /// Adds an element that holds a text.
    pub fn element(&mut self, tag: &str, text: &str) {
        let _ = write!(self.0, "<{tag}>{}</{tag}>", escaped(text));
    }

    /// Adds a table of numbers: titles of the columns and rows of texts; the first cell of a row is its title, and where
    /// it begins with `=` the row is a total.
    pub fn table(&mut self, caption: &str, titles: &[&str], rows: &[Vec<String>]) {
        self.aligned_table("numbers", caption, titles, rows);
    }

    /// Adds a table of words.
    pub fn words(&mut self, caption: &str, titles: &[&str], rows: &[Vec<String>]) {
        self.aligned_table("words", caption, titles, rows);
    }

    fn aligned_table(&mut self, class: &str, caption: &str, titles: &[&str], rows: &[Vec<String>]) {
        self.raw("<div class=\"table-scroller\" tabindex=\"0\" role=\"region\" aria-label=\"");
        self.text(&format!("Table: {caption}"));
        self.raw(&format!("\"><table class=\"{class}\"><caption>"));
        self.text(caption);
        self.raw("</caption><thead><tr>");
        for title in titles {
            let _ = write!(self.0, "<th scope=\"col\">{}</th>", escaped(title));
        }
        self.raw("</tr></thead><tbody>");
        for row in rows {
            let is_total = row.first().is_some_and(|cell| cell.starts_with('='));
            self.raw(if is_total { "<tr class=\"total\">" } else { "<tr>" });
            for (k, cell) in row.iter().enumerate() {
                let cell = escaped(cell);
                let _ = match k {
                    0 => write!(self.0, "<th scope=\"row\">{cell}</th>"),
                    _ => write!(self.0, "<td>{cell}</td>"),
                };
            }
            self.raw("</tr>");
        }
        self.raw("</tbody></table></div>");
    }

    /// Adds a text that can be unfolded, as it is.
    pub fn unfolded(&mut self, title: &str, text: &str) {
        self.raw("<details><summary>");
        self.text(title);
        self.raw("</summary><pre tabindex=\"0\">");
        self.text(text);
        self.raw("</pre></details>");
    }

    /// The HTML.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

/// JSON that may stand inside a `<script>` element: without `<`, `>` and `&`, which could end it.
pub(super) fn json_for_script(value: &serde_json::Value) -> String {
    let text = value.to_string();
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => {
                let _ = write!(out, "\\u{:04x}", c as u32);
            }
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_mean_themselves() {
        assert_eq!(
            escaped("a<b> & \"c\" 'd'"),
            "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;"
        );
        assert_eq!(escaped("bell\u{7}\n"), "bell\u{fffd}\n");
        let mut html = Html::default();
        html.prose("a `<b>` c");
        html.prose("a ` <d>");
        assert_eq!(html.as_str(), "a <code>&lt;b&gt;</code> ca ` &lt;d&gt;");
        let mut html = Html::default();
        html.table("<x>", &["<t>"], &[vec!["<r>".into(), "<c>".into()]]);
        for tag in ["<x>", "<t>", "<r>", "<c>"] {
            assert!(!html.as_str().contains(tag), "{tag}");
        }
    }

    #[test]
    fn json_cannot_end_its_script() {
        let value = serde_json::json!({ "</script><!--": "]]>&\u{2028}" });
        let text = json_for_script(&value);
        assert!(!text.contains(['<', '>', '&', '\u{2028}']), "{text}");
        assert_eq!(serde_json::from_str::<serde_json::Value>(&text).unwrap(), value);
    }
}
