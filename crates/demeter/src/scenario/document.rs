//! The scenario as a tree in which every key and value remembers where it was written.

use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Where something was written: in the file (source 0) or in an override (1, 2, ...).
#[derive(Clone, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Span {
    /// Index into [`Document::sources`].
    pub source: usize,
    /// Bytes of that text.
    pub bytes: Range<usize>,
}

/// A text that the scenario was read from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SourceText {
    /// Name for messages: the file, or `--set`.
    pub name: String,
    /// The text.
    pub text: String,
    /// Whether it is an override.
    pub is_override: bool,
}

/// A value and where it was written.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub value: Value,
    pub span: Span,
}

impl Node {
    /// Whether the node is a table without keys.
    pub fn is_empty_table(&self) -> bool {
        matches!(&self.value, Value::Table(entries) if entries.is_empty())
    }
}

/// A value of a scenario.
#[derive(Clone, Debug)]
pub(super) enum Value {
    String(String),
    Integer(i64),
    Float(f64),
    Boolean(bool),
    /// A date or time, or an integer too large for 64 bits: never allowed, kept for the message.
    Other(String),
    Array(Vec<Node>),
    Table(Vec<Entry>),
}

/// A key with its value.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub key: String,
    pub key_span: Span,
    pub node: Node,
}

impl Value {
    /// What the value is, with an article.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::String(_) => "a text",
            Self::Integer(_) | Self::Float(_) => "a plain number",
            Self::Boolean(_) => "true or false",
            Self::Other(_) => "a date or an oversized number",
            Self::Array(_) => "a list",
            Self::Table(_) => "a table",
        }
    }

    /// The value as TOML on one line.
    pub fn inline(&self) -> String {
        match self {
            Self::String(s) => toml::Value::String(s.clone()).to_string(),
            Self::Integer(i) => i.to_string(),
            Self::Float(f) => toml::Value::Float(*f).to_string(),
            Self::Boolean(b) => b.to_string(),
            Self::Other(s) => s.clone(),
            Self::Array(items) => {
                let items: Vec<String> = items.iter().map(|n| n.value.inline()).collect();
                format!("[{}]", items.join(", "))
            }
            Self::Table(entries) if entries.is_empty() => "{}".to_string(),
            Self::Table(entries) => {
                let entries: Vec<String> = entries
                    .iter()
                    .map(|e| format!("{} = {}", written_key(&e.key), e.node.value.inline()))
                    .collect();
                format!("{{ {} }}", entries.join(", "))
            }
        }
    }
}

/// How a number is written whose point has no digit on one of its sides, as `.5` or `5.`, which TOML refuses near there.
pub(super) fn number_in_full(text: &str, at: usize) -> Option<String> {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | '_');
    let (before, after) = (text.get(..at)?, text.get(at..)?);
    let start = before.trim_end_matches(is_part).len();
    let end = at + after.find(|c| !is_part(c)).unwrap_or(after.len());
    let number = text.get(start..end)?;
    let (whole, fraction) = number.split_once('.')?;
    let digits = |part: &str| part.chars().all(|c| c.is_ascii_digit());
    let (sign, whole) = whole.split_at(whole.len() - whole.trim_start_matches(['+', '-']).len());
    if !(digits(whole) && digits(fraction)) || whole.is_empty() == fraction.is_empty() {
        return None;
    }
    let filled = |part: &str| {
        if part.is_empty() {
            "0".to_owned()
        } else {
            part.to_owned()
        }
    };
    let full = format!("{sign}{}.{}", filled(whole), filled(fraction));
    Some(format!("write `{full}`: a point has digits on both sides"))
}

/// A key as TOML writes it: quoted when it is not a bare word.
pub(super) fn written_key(key: &str) -> String {
    let bare = !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-');
    if bare {
        key.to_string()
    } else {
        toml::Value::String(key.to_string()).to_string()
    }
}

/// Path of a key below another: `stage[2].motion` and `top` give `stage[2].motion.top`.
pub(super) fn join(path: &str, key: &str) -> String {
    let key = written_key(key);
    if path.is_empty() { key } else { format!("{path}.{key}") }
}

/// The texts that a scenario was read from, and where every key stands in them.
#[derive(Clone, Debug)]
pub struct Document {
    /// The file, then the overrides.
    pub sources: Vec<SourceText>,
    pub(super) root: Node,
}

/// Where a key and its value stand.
struct Place<'a> {
    key: &'a Span,
    value: &'a Span,
}

impl Document {
    /// Texts alone, of a scenario whose keys are not known.
    pub(super) fn without_keys(sources: Vec<SourceText>) -> Self {
        let root = Node {
            value: Value::Table(Vec::new()),
            span: Span::default(),
        };
        Self { sources, root }
    }

    /// Where the value of a path stands, as `wall[1].radius`. A path that was not written is looked up at the nearest
    /// table above it; `None` when no part of it was written.
    pub fn origin(&self, path: &str) -> Option<Span> {
        self.nearest(path).map(|place| place.value.clone())
    }

    /// Where the key of a path stands.
    pub fn key_origin(&self, path: &str) -> Option<Span> {
        self.nearest(path).map(|place| place.key.clone())
    }

    /// The value of a key where it is a text.
    pub fn text(&self, path: &str) -> Option<&str> {
        let (mut node, mut rest) = (&self.root, path);
        while !rest.is_empty() {
            (_, node, rest) = step(node, rest)?;
        }
        match &node.value {
            Value::String(text) => Some(text),
            _ => None,
        }
    }

    /// The place of the longest written part of a path.
    fn nearest(&self, path: &str) -> Option<Place<'_>> {
        let mut found = None;
        let mut node = &self.root;
        let mut rest = path;
        loop {
            let (place, next, after) = match step(node, rest) {
                Some(step) => step,
                None => return found,
            };
            (found, node, rest) = (Some(place), next, after);
        }
    }

    /// Line and column of a span, both from 1; the column counts characters.
    pub fn line_column(&self, span: &Span) -> (usize, usize) {
        let Some(source) = self.sources.get(span.source) else {
            return (0, 0);
        };
        let before = source.text.get(..span.bytes.start).unwrap_or(&source.text);
        let line = before.matches('\n').count() + 1;
        let column = before.chars().rev().take_while(|c| *c != '\n').count() + 1;
        (line, column)
    }
}

/// One step along a path: the place reached, the node there and the rest of the path.
fn step<'n, 'p>(node: &'n Node, path: &'p str) -> Option<(Place<'n>, &'n Node, &'p str)> {
    match &node.value {
        Value::Table(entries) => {
            let path = path.strip_prefix('.').unwrap_or(path);
            entries.iter().find_map(|entry| {
                let rest = path.strip_prefix(written_key(&entry.key).as_str())?;
                let place = Place {
                    key: &entry.key_span,
                    value: &entry.node.span,
                };
                (rest.is_empty() || rest.starts_with(['.', '['])).then_some((place, &entry.node, rest))
            })
        }
        Value::Array(items) => {
            let (index, rest) = path.strip_prefix('[')?.split_once(']')?;
            let item = items.get(index.parse::<usize>().ok()?)?;
            let place = Place {
                key: &item.span,
                value: &item.span,
            };
            Some((place, item, rest))
        }
        _ => None,
    }
}

/// A fault of the TOML itself.
#[derive(Clone, Debug)]
pub(super) struct SyntaxFault {
    pub message: String,
    pub span: Span,
}

/// Reads a text as TOML.
pub(super) fn read_toml(text: &str, source: usize) -> Result<Node, Vec<SyntaxFault>> {
    let (table, errors) = DeTable::parse_recoverable(text);
    if errors.is_empty() {
        let span = table.span();
        return Ok(table_node(table.get_ref(), span, source));
    }
    Err(faults(&errors, text, source))
}

/// Reads a text as one TOML value.
pub(super) fn read_value(text: &str, source: usize, offset: usize) -> Result<Node, Vec<SyntaxFault>> {
    let (value, errors) = DeValue::parse_recoverable(text);
    if !errors.is_empty() {
        return Err(faults(&errors, text, source));
    }
    let mut node = value_node(&value, source);
    shift(&mut node, offset);
    Ok(node)
}

fn faults(errors: &[toml::de::Error], text: &str, source: usize) -> Vec<SyntaxFault> {
    errors
        .iter()
        .map(|e| SyntaxFault {
            message: e.message().trim().replace('\n', ", "),
            span: Span {
                source,
                bytes: e.span().unwrap_or(text.len()..text.len()),
            },
        })
        .collect()
}

fn shift(node: &mut Node, offset: usize) {
    let moved = |span: &mut Span| span.bytes = span.bytes.start + offset..span.bytes.end + offset;
    moved(&mut node.span);
    match &mut node.value {
        Value::Array(items) => items.iter_mut().for_each(|n| shift(n, offset)),
        Value::Table(entries) => {
            for entry in entries {
                moved(&mut entry.key_span);
                shift(&mut entry.node, offset);
            }
        }
        _ => {}
    }
}

fn table_node(table: &DeTable<'_>, bytes: Range<usize>, source: usize) -> Node {
    let mut entries: Vec<Entry> = table
        .iter()
        .map(|(key, value)| Entry {
            key: key.get_ref().to_string(),
            key_span: Span {
                source,
                bytes: key.span(),
            },
            node: value_node(value, source),
        })
        .collect();
    // the parser sorts keys by name; materials, and so on, are numbered in the order of the file
    entries.sort_by_key(|e| e.key_span.bytes.start);
    Node {
        value: Value::Table(entries),
        span: Span { source, bytes },
    }
}

fn value_node(value: &Spanned<DeValue<'_>>, source: usize) -> Node {
    let bytes = value.span();
    let read = match value.get_ref() {
        DeValue::String(s) => Value::String(s.to_string()),
        DeValue::Integer(i) => i64::from_str_radix(i.as_str(), i.radix())
            .map(Value::Integer)
            .unwrap_or_else(|_| Value::Other(i.to_string())),
        DeValue::Float(f) => f.as_str().parse().map(Value::Float).unwrap_or(Value::Float(f64::NAN)),
        DeValue::Boolean(b) => Value::Boolean(*b),
        DeValue::Datetime(d) => Value::Other(d.to_string()),
        DeValue::Array(items) => Value::Array(items.iter().map(|v| value_node(v, source)).collect()),
        DeValue::Table(table) => return table_node(table, bytes, source),
    };
    Node {
        value: read,
        span: Span { source, bytes },
    }
}
