//! Overrides from the command line: `--set grains[0].count=200`.

use super::document::{Entry, Node, SourceText, Span, SyntaxFault, Value, read_toml, read_value};
use super::reader::did_you_mean;

/// Longest path of an override.
const MAX_DEPTH: usize = 20;

/// A value that takes the place of that in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Override {
    /// Key and value, as `grains[0].count=200`.
    pub text: String,
    /// Where it was told, for messages, as `--set`.
    pub source: String,
}

impl Override {
    /// What `--set` tells.
    pub(super) fn set(text: &str) -> Self {
        Self {
            text: text.to_string(),
            source: "--set".to_string(),
        }
    }
}

/// The key of `KEY=VALUE`.
pub fn key_of(told: &str) -> &str {
    told.split('=').next().unwrap_or(told).trim()
}

/// The steps of a key, as `grains`, `0`, `count` of `grains[0].count`; nothing where it is not a key.
pub fn key_steps(key: &str) -> Option<Vec<String>> {
    let steps: Vec<String> = steps(key).into_iter().map(|step| step.text).collect();
    let is_key = steps.len() <= MAX_DEPTH && steps.iter().all(|step| !step.is_empty());
    is_key.then_some(steps)
}

/// [`key_steps`] of some keys of a scenario, where elements of lists stand by their numbers, whether the keys tell numbers or names.
pub fn key_places(scenario: &str, keys: &[&str]) -> Vec<Option<Vec<String>>> {
    let root = read_toml(scenario, 0).ok();
    let place = |key: &&str| {
        let mut at = root.as_ref();
        let mut steps = key_steps(key)?;
        for step in &mut steps {
            at = match at.map(|node| &node.value) {
                Some(Value::Array(items)) => position(items, step).ok().map(|index| {
                    *step = index.to_string();
                    &items[index]
                }),
                Some(Value::Table(entries)) => entries.iter().find(|e| e.key == *step).map(|e| &e.node),
                _ => None,
            };
        }
        Some(steps)
    };
    keys.iter().map(place).collect()
}

/// One step of the path of an override.
#[derive(Clone, Debug)]
struct Step {
    text: String,
    bytes: std::ops::Range<usize>,
    in_brackets: bool,
}

/// A fault of an override.
pub(super) type OverrideFault = (SyntaxFault, Option<String>);

/// Puts an override into the tree. `source` is the index that its text will have among the sources.
pub(super) fn apply(root: &mut Node, text: &str, source: usize) -> Result<(), Vec<OverrideFault>> {
    let fault = |bytes, message: String, help| {
        vec![(
            SyntaxFault {
                message,
                span: Span { source, bytes },
            },
            help,
        )]
    };
    let Some(equals) = text.find('=') else {
        let help = Some("as in `--set grains[0].count=200`".to_string());
        return Err(fault(
            0..text.len(),
            "an override has the form key=value".to_string(),
            help,
        ));
    };
    let steps = steps(&text[..equals]);
    if steps.iter().any(|s| s.text.is_empty()) || steps.len() > MAX_DEPTH {
        return Err(fault(0..equals, format!("`{}` is not a key", &text[..equals]), None));
    }
    let written = &text[equals + 1..];
    let leading = written.len() - written.trim_start().len();
    let value = read_value(written.trim(), source, equals + 1 + leading).unwrap_or_else(|_| Node {
        value: Value::String(written.trim().to_string()),
        span: Span {
            source,
            bytes: equals + 1..text.len(),
        },
    });
    let mut at = root;
    let (last, before) = match steps.split_last() {
        Some(split) => split,
        None => return Ok(()),
    };
    for step in before {
        at = descend(at, step, source).map_err(|(m, h)| fault(step.bytes.clone(), m, h))?;
    }
    let slot = descend(at, last, source).map_err(|(m, h)| fault(last.bytes.clone(), m, h))?;
    *slot = value;
    Ok(())
}

/// The text of an override as a source of messages.
pub(super) fn source_text(told: &Override) -> SourceText {
    SourceText {
        name: told.source.clone(),
        text: told.text.clone(),
        is_override: true,
    }
}

/// `grains[0].file` and `grains.0.file` both give three steps; a part in double quotes may hold dots.
fn steps(path: &str) -> Vec<Step> {
    let mut steps: Vec<Step> = Vec::new();
    let mut start = 0;
    let (mut quoted, mut is_open) = (false, false);
    let mut push = |from: usize, to: usize, in_brackets: bool| {
        let text = path[from..to].trim().trim_matches('"').to_string();
        // `grains[0].file`: nothing stands between `]` and `.`
        let after_bracket = !in_brackets && text.is_empty() && from > 0 && path[..from].ends_with(']');
        if !after_bracket {
            steps.push(Step {
                text,
                bytes: from..to,
                in_brackets,
            });
        }
    };
    for (at, c) in path.char_indices() {
        match c {
            '"' => quoted = !quoted,
            '.' | '[' if !quoted => {
                push(start, at, false);
                (start, is_open) = (at + 1, c == '[');
            }
            ']' if !quoted => {
                // one that closes nothing stands for a step without a name
                push(if is_open { start } else { at }, at, true);
                (start, is_open) = (at + 1, false);
            }
            _ => {}
        }
    }
    push(start, path.len(), false);
    steps
}

type Refused = (String, Option<String>);

/// The node below another, made when it is a key that was not there.
fn descend<'a>(node: &'a mut Node, step: &Step, source: usize) -> Result<&'a mut Node, Refused> {
    if let (Value::String(text), true) = (&node.value, step.in_brackets)
        && let Some(parts) = components(text, &node.span)
    {
        node.value = Value::Array(parts);
    }
    let kind = node.value.kind();
    match &mut node.value {
        Value::Array(items) => {
            let index = position(items, &step.text)?;
            Ok(&mut items[index])
        }
        Value::Table(entries) if step.in_brackets && entries.is_empty() => Err((
            format!("there is nothing yet of which `{}` could be an element", step.text),
            Some("tell the whole value".to_string()),
        )),
        Value::Table(entries) if !step.in_brackets => {
            let index = match entries.iter().position(|e| e.key == step.text) {
                Some(index) => index,
                None => {
                    let span = Span {
                        source,
                        bytes: step.bytes.clone(),
                    };
                    entries.push(Entry {
                        key: step.text.clone(),
                        key_span: span.clone(),
                        node: Node {
                            value: Value::Table(Vec::new()),
                            span,
                        },
                    });
                    entries.len() - 1
                }
            };
            Ok(&mut entries[index].node)
        }
        _ => Err((format!("`{}` cannot be set below {kind}", step.text), None)),
    }
}

/// The three components of a vector in one text, each with the unit of all.
fn components(text: &str, span: &Span) -> Option<Vec<Node>> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let (numbers, unit) = words.split_at_checked(3)?;
    let are_numbers = numbers.iter().all(|word| word.parse::<f64>().is_ok());
    let component = |number: &&str| Node {
        value: Value::String(format!("{number} {}", unit.join(" "))),
        span: span.clone(),
    };
    (are_numbers && !unit.is_empty()).then(|| numbers.iter().map(component).collect())
}

/// Index of an element told by its number from 0 or by its `name`.
fn position(items: &[Node], text: &str) -> Result<usize, Refused> {
    let name_of = |item: &Node| match &item.value {
        Value::Table(entries) => entries.iter().find_map(|e| match &e.node.value {
            Value::String(name) if e.key == "name" => Some(name.clone()),
            _ => None,
        }),
        _ => None,
    };
    if let Ok(index) = text.parse::<usize>() {
        if index < items.len() {
            return Ok(index);
        }
        let help = match items.len() {
            0 => "the list is empty".to_string(),
            1 => "the only element is number 0".to_string(),
            n => format!("elements are numbered from 0 to {}", n - 1),
        };
        return Err((format!("there is no element {index}"), Some(help)));
    }
    let names: Vec<Option<String>> = items.iter().map(name_of).collect();
    names.iter().position(|n| n.as_deref() == Some(text)).ok_or_else(|| {
        let help = did_you_mean(text, names.iter().flatten().map(String::as_str));
        (format!("no element is named `{text}`"), help)
    })
}
