//! Reads Rust source just far enough to know which modules of its own crate a file imports.

/// A word or a sign of the source, with its line.
#[derive(Clone, Debug, PartialEq)]
pub struct Token {
    pub text: String,
    pub line: usize,
}

/// One path into a module at the root of the crate: `crate::walls::Motion` gives `walls`.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    pub module: String,
    pub line: usize,
}

/// Words and signs of a source without comments and the contents of literals.
pub fn tokens(source: &str) -> Vec<Token> {
    let text: Vec<char> = source.chars().collect();
    let mut tokens = Vec::new();
    let (mut at, mut line) = (0, 1);
    while at < text.len() {
        let start = at;
        let c = text[at];
        let next = text.get(at + 1).copied();
        if c == '/' && next == Some('/') {
            while at < text.len() && text[at] != '\n' {
                at += 1;
            }
        } else if c == '/' && next == Some('*') {
            at = end_of_block_comment(&text, at);
        } else if let Some(end) = end_of_literal(&text, at) {
            at = end;
        } else if c.is_alphabetic() || c == '_' {
            while at < text.len() && (text[at].is_alphanumeric() || text[at] == '_') {
                at += 1;
            }
            let word = text[start..at].iter().collect();
            tokens.push(Token { text: word, line });
        } else if c == ':' && next == Some(':') {
            at += 2;
            let text = "::".to_string();
            tokens.push(Token { text, line });
        } else {
            at += 1;
            if !c.is_whitespace() {
                let text = c.to_string();
                tokens.push(Token { text, line });
            }
        }
        line += text[start..at].iter().filter(|c| **c == '\n').count();
    }
    tokens
}

fn end_of_block_comment(text: &[char], start: usize) -> usize {
    let (mut at, mut depth) = (start + 2, 1);
    while at < text.len() && depth > 0 {
        match (text[at], text.get(at + 1)) {
            ('/', Some('*')) => (at, depth) = (at + 2, depth + 1),
            ('*', Some('/')) => (at, depth) = (at + 2, depth - 1),
            _ => at += 1,
        }
    }
    at
}

/// End of the string or character literal that starts here, if one does.
fn end_of_literal(text: &[char], start: usize) -> Option<usize> {
    let in_word = start > 0 && (text[start - 1].is_alphanumeric() || text[start - 1] == '_');
    let mut at = start;
    if !in_word {
        while at < text.len() && at < start + 2 && matches!(text[at], 'b' | 'c' | 'r') {
            at += 1;
        }
        let raw = at > start && text[at - 1] == 'r';
        let hashes = text[at..].iter().take_while(|c| **c == '#').count();
        if raw && text.get(at + hashes) == Some(&'"') {
            return Some(end_of_raw_string(text, at + hashes + 1, hashes));
        }
    }
    match text.get(at) {
        Some('"') => Some(end_of_quoted(text, at, '"')),
        // a lifetime has no closing quote: 'a, but a character has: 'a', '\n', '\''
        Some('\'') if text.get(at + 1) == Some(&'\\') || text.get(at + 2) == Some(&'\'') => {
            Some(end_of_quoted(text, at, '\''))
        }
        _ => None,
    }
}

fn end_of_raw_string(text: &[char], start: usize, hashes: usize) -> usize {
    let closes =
        |at: usize| text[at] == '"' && text[at + 1..].iter().take(hashes).filter(|c| **c == '#').count() == hashes;
    (start..text.len())
        .find(|&at| closes(at))
        .map_or(text.len(), |at| at + 1 + hashes)
}

fn end_of_quoted(text: &[char], start: usize, quote: char) -> usize {
    let mut at = start + 1;
    while at < text.len() && text[at] != quote {
        at += if text[at] == '\\' { 2 } else { 1 };
    }
    (at + 1).min(text.len())
}

/// Modules at the root of the crate that the file of module `path` names. `crate_name` is the crate's own name, which
/// it may call itself by.
pub fn imports(source: &str, path: &[String], crate_name: &str) -> Vec<Import> {
    let tokens = tokens(source);
    let mut reader = Reader {
        tokens: &tokens,
        found: Vec::new(),
    };
    // inline modules that are open, by the brace depth at which they end
    let (mut depth, mut open) = (0usize, Vec::new());
    for (at, token) in tokens.iter().enumerate() {
        let word = token.text.as_str();
        match word {
            "{" => {
                if at >= 2 && reader.word(at - 2) == Some("mod") {
                    open.push(depth);
                }
                depth += 1;
            }
            "}" => {
                depth = depth.saturating_sub(1);
                if open.last() == Some(&depth) {
                    open.pop();
                }
            }
            _ if reader.word(at + 1) != Some("::") || reader.continues_a_path(at) => {}
            "crate" => reader.tree(at + 2, 0),
            "super" => reader.tree(at, path.len() + open.len()),
            _ if word == crate_name => reader.tree(at + 2, 0),
            _ => {}
        }
    }
    reader.found
}

struct Reader<'a> {
    tokens: &'a [Token],
    found: Vec<Import>,
}

impl Reader<'_> {
    fn word(&self, at: usize) -> Option<&str> {
        self.tokens.get(at).map(|token| token.text.as_str())
    }

    /// Whether the word follows `something::`, other than `self::`.
    fn continues_a_path(&self, at: usize) -> bool {
        at >= 1 && self.word(at - 1) == Some("::") && !(at >= 2 && self.word(at - 2) == Some("self"))
    }

    /// Reads the path or the group in braces that starts here, `depth` modules below the root.
    fn tree(&mut self, at: usize, depth: usize) {
        match self.word(at) {
            Some("super") if self.word(at + 1) == Some("::") => self.tree(at + 2, depth.saturating_sub(1)),
            Some("{") => {
                let (mut next, mut level, mut branch) = (at + 1, 1, true);
                while level > 0 && next < self.tokens.len() {
                    let word = self.word(next).unwrap_or_default();
                    match word {
                        "{" if branch => {}
                        "{" => level += 1,
                        "}" => level -= 1,
                        "," if level == 1 => {}
                        _ if branch => self.tree(next, depth),
                        _ => {}
                    }
                    branch = level == 1 && self.word(next) == Some(",") && self.word(next + 1) != Some("}");
                    next += 1;
                }
            }
            Some(word) if depth == 0 && word != "self" => self.found.push(Import {
                module: word.to_string(),
                line: self.tokens[at].line,
            }),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn modules(source: &str, path: &[&str]) -> Vec<String> {
        let path: Vec<String> = path.iter().map(ToString::to_string).collect();
        let imports = imports(source, &path, "demeter");
        imports.into_iter().map(|import| import.module).collect()
    }

    #[test]
    fn every_way_to_name_a_module_is_found() {
        for (source, expected) in [
            ("use crate::walls::Motion;", vec!["walls"]),
            ("pub(crate) use crate::walls;", vec!["walls"]),
            (
                "use crate::{walls::{Motion, Shape}, comm, measure as m};",
                vec!["walls", "comm", "measure"],
            ),
            (
                "use crate::{walls::{a::{b, c}, d}, comm::{e}, };",
                vec!["walls", "comm"],
            ),
            ("fn f(x: crate::output::Folder) {}", vec!["output"]),
            ("let x = $crate::scenario::read();", vec!["scenario"]),
            ("use demeter::walls;", vec!["walls"]),
            ("use super::super::scenario::Unit;", vec!["scenario"]),
            ("use super::{super::scenario, shape};", vec!["scenario"]),
            (
                "mod tests { use super::super::super::scenario; use super::super::shape; }",
                vec!["scenario"],
            ),
            ("use crate::*;", vec!["*"]),
            ("use self::super::super::step;", vec!["step"]),
        ] {
            assert_eq!(modules(source, &["walls", "motion"]), expected, "{source}");
        }
    }

    #[test]
    fn words_that_are_not_paths_of_this_crate_are_left_alone() {
        for source in [
            "// use crate::scenario;",
            "/* use crate::scenario; /* nested */ use crate::output; */",
            "let x = \"crate::scenario \\\" crate::output\";",
            "let x = r#\"crate::scenario \" crate::output\"#;",
            "use super::shape;",
            "use other::crate_like::demeter::scenario;",
            "pub(crate) fn f<'a>(x: &'a str, y: char) -> bool { y == '\"' || y == '\\'' }",
            "mod demeter { }",
        ] {
            assert_eq!(modules(source, &["walls", "motion"]), Vec::<String>::new(), "{source}");
        }
    }

    #[test]
    fn lines_are_counted_through_comments_and_strings() {
        let source = "/* a\nb */ let x = \"c\nd\";\n// e\nuse crate::walls;\n";
        assert_eq!(imports(source, &[], "demeter")[0].line, 5);
    }
}
