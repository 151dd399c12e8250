//! Walks the tree of a scenario: every getter checks type, unit and range, notes what is wrong and goes on.
//!
//! A getter that finds a fault notes it and returns a stand-in (not a number, an empty text, ...): the scenario is
//! refused anyway, and the walk goes on to find the other faults. Comparisons are written so that a stand-in, which is
//! not a number, never causes a second message.

use super::diagnostics::Diagnostics;
use super::document::{Entry, Node, Value, join};
use super::plain::PLAIN_NUMBERS;
use super::quantity::Kind;
use std::cell::{Cell, RefCell};
use std::collections::HashSet;

/// What a getter looks for. Tests hold it against what the reference tells.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(not(test), allow(dead_code))]
pub(super) enum Sought {
    /// A key of a table, and whether it must be there.
    Key { key: String, required: bool },
    /// A text.
    Text,
    /// True or false.
    Boolean,
    /// A whole number.
    Integer,
    /// One of a list of words.
    Choice(Vec<String>),
    /// A quantity.
    Quantity(Kind),
    /// Three of them.
    Vector(Kind),
    /// A direction.
    Direction,
    /// A list.
    List,
    /// A table.
    Table,
}

/// What all readers of one scenario share.
pub(super) struct Context {
    /// What is wrong so far.
    pub faults: RefCell<Diagnostics>,
    /// Whether numbers without a unit are SI values.
    pub plain_si: Cell<bool>,
    /// Whether a run goes on with it: the grains of the start are in a checkpoint, and their files may be gone.
    pub has_started: bool,
    /// What was looked for, with the path of the value or, of a key, of its table.
    #[cfg(test)]
    pub sought: RefCell<Vec<(String, Sought)>>,
}

impl Context {
    /// Nothing is wrong yet but what is told.
    pub fn new(faults: Diagnostics) -> Self {
        Self {
            faults: RefCell::new(faults),
            plain_si: Cell::new(false),
            has_started: false,
            #[cfg(test)]
            sought: RefCell::new(Vec::new()),
        }
    }

    /// Notes in tests what is looked for.
    #[cfg_attr(not(test), allow(unused_variables, clippy::unused_self))]
    fn seeks(&self, path: &str, sought: impl FnOnce() -> Sought) {
        #[cfg(test)]
        self.sought.borrow_mut().push((path.to_string(), sought()));
    }

    /// Notes a fault at the value of a path.
    pub fn fault(&self, path: &str, message: impl Into<String>, help: Option<String>) {
        self.faults.borrow_mut().push(path, message, help);
    }
}

/// "did you mean `x`?" for a word that is not among the known ones but close to one.
pub(super) fn did_you_mean<'k>(word: &str, known: impl IntoIterator<Item = &'k str>) -> Option<String> {
    let distance = |k: &str| strsim::osa_distance(&word.to_lowercase(), &k.to_lowercase());
    let limit = 1 + word.chars().count().min(64) / 4;
    known
        .into_iter()
        .map(|k| (distance(k), k))
        .filter(|(d, k)| *d <= limit && *d < k.chars().count())
        .min_by_key(|(d, _)| *d)
        .map(|(_, k)| format!("did you mean `{k}`?"))
}

/// What is close to a word among the known ones, or some of these: "did you mean `a`?", "known are `a`, `b`".
pub fn suggest_or_list<'k>(word: &str, known: impl IntoIterator<Item = &'k str>) -> Option<String> {
    let known: Vec<&str> = known.into_iter().collect();
    let list = || match known.as_slice() {
        [] => None,
        known => {
            let shown: Vec<String> = known.iter().take(20).map(|k| format!("`{k}`")).collect();
            let more = if known.len() > 20 { ", ..." } else { "" };
            Some(format!("known are {}{more}", shown.join(", ")))
        }
    };
    did_you_mean(word, known.iter().copied()).or_else(list)
}

/// A value with its key and path.
#[derive(Clone)]
pub(super) struct Item<'a> {
    pub context: &'a Context,
    pub node: &'a Node,
    /// Path from the root: `wall[1].radius`.
    pub path: String,
    /// The key, for messages.
    pub name: String,
}

impl<'a> Item<'a> {
    /// Notes a fault at this value.
    pub fn fault(&self, message: impl Into<String>, help: Option<String>) {
        self.context.fault(&self.path, message, help);
    }

    /// Notes in tests what is looked for here.
    pub fn seeks(&self, sought: impl FnOnce() -> Sought) {
        self.context.seeks(&self.path, sought);
    }

    /// The text of a value that must be a text.
    pub fn text(&self) -> String {
        self.seeks(|| Sought::Text);
        match &self.node.value {
            Value::String(text) => text.clone(),
            other => {
                let message = format!("`{}` must be a text in quotes, found {}", self.name, other.kind());
                self.fault(message, None);
                String::new()
            }
        }
    }

    /// A text that must not be empty and holds no control characters.
    pub fn label(&self) -> String {
        let text = self.text();
        if matches!(self.node.value, Value::String(_)) && !is_label(&text) {
            let message = format!(
                "`{}` must be a text of 1 to {MAX_LABEL} printable characters",
                self.name
            );
            self.fault(message, None);
        }
        text
    }

    /// True or false.
    pub fn boolean(&self) -> bool {
        self.seeks(|| Sought::Boolean);
        match &self.node.value {
            Value::Boolean(value) => *value,
            other => {
                let message = format!("`{}` must be true or false, found {}", self.name, other.kind());
                let quoted = matches!(other, Value::String(s) if s == "true" || s == "false");
                self.fault(message, quoted.then(|| "write it without quotes".to_string()));
                false
            }
        }
    }

    /// A whole number within bounds, both allowed.
    pub fn integer(&self, lower: i64, upper: i64) -> i64 {
        self.seeks(|| Sought::Integer);
        match &self.node.value {
            Value::Integer(value) if (lower..=upper).contains(value) => *value,
            Value::Integer(value) => {
                let message = format!("`{}` is {value}; it must be from {lower} to {upper}", self.name);
                self.fault(message, None);
                lower
            }
            Value::Float(value) if value.is_finite() => {
                let whole = value.fract() == 0.0;
                let help = whole.then(|| format!("write it without a point: {value}"));
                self.fault(format!("`{}` must be a whole number, found {value:?}", self.name), help);
                lower
            }
            other => {
                let message = format!("`{}` must be a whole number, found {}", self.name, other.kind());
                self.fault(message, None);
                lower
            }
        }
    }

    /// One of a list of words; the index of the word.
    pub fn choice(&self, known: &[&str]) -> Option<usize> {
        self.seeks(|| Sought::Choice(known.iter().map(ToString::to_string).collect()));
        let Value::String(text) = &self.node.value else {
            let words: Vec<String> = known.iter().map(|k| format!("\"{k}\"")).collect();
            let kind = self.node.value.kind();
            let message = format!("`{}` must be one of {}, found {kind}", self.name, words.join(", "));
            self.fault(message, None);
            return None;
        };
        let found = known.iter().position(|k| k == text);
        if found.is_none() {
            let message = format!("unknown value `{text}` of `{}`", self.name);
            self.fault(message, suggest_or_list(text, known.iter().copied()));
        }
        found
    }

    /// The elements of a list.
    pub fn items(&self) -> Vec<Item<'a>> {
        self.seeks(|| Sought::List);
        match &self.node.value {
            Value::Array(nodes) => (nodes.iter().enumerate())
                .map(|(index, node)| Item {
                    context: self.context,
                    node,
                    path: format!("{}[{index}]", self.path),
                    name: self.name.clone(),
                })
                .collect(),
            other => {
                self.fault(format!("`{}` must be a list, found {}", self.name, other.kind()), None);
                Vec::new()
            }
        }
    }

    /// The tables of a list of tables, as `[[wall]]`; `header` is how they are written.
    pub fn tables(&self, header: &str) -> Vec<TableReader<'a>> {
        if let Value::Table(_) = &self.node.value {
            self.fault(
                format!("`{}` is a list of tables", self.name),
                Some(format!("write `[[{header}]]` in place of `[{header}]`")),
            );
            return Vec::new();
        }
        self.items().iter().filter_map(Item::table).collect()
    }

    /// The table.
    pub fn table(&self) -> Option<TableReader<'a>> {
        self.seeks(|| Sought::Table);
        match &self.node.value {
            Value::Table(entries) => Some(TableReader {
                context: self.context,
                entries,
                path: self.path.clone(),
                asked: RefCell::new(Vec::new()),
            }),
            other => {
                self.fault(format!("`{}` must be a table, found {}", self.name, other.kind()), None);
                None
            }
        }
    }
}

/// Longest name.
pub(super) const MAX_LABEL: usize = 200;

/// Whether a text is not empty, not long, and holds no control characters.
pub(super) fn is_label(text: &str) -> bool {
    !text.trim().is_empty() && !text.chars().any(char::is_control) && text.chars().count() <= MAX_LABEL
}

/// A table being read. It remembers the keys it was asked for; [`TableReader::finish`] refuses all others.
pub(super) struct TableReader<'a> {
    pub context: &'a Context,
    entries: &'a [Entry],
    pub path: String,
    asked: RefCell<Vec<String>>,
}

impl<'a> TableReader<'a> {
    /// Reader of the whole scenario.
    pub fn root(context: &'a Context, root: &'a Node) -> Self {
        let entries: &[Entry] = match &root.value {
            Value::Table(entries) => entries,
            _ => &[],
        };
        let table = Self {
            context,
            entries,
            path: String::new(),
            asked: RefCell::new(Vec::new()),
        };
        if let Some(item) = table.optional(PLAIN_NUMBERS) {
            context.plain_si.set(item.choice(&["SI"]).is_some());
        }
        table
    }

    /// Notes a fault at the table.
    pub fn fault(&self, message: impl Into<String>, help: Option<String>) {
        self.context.faults.borrow_mut().push_key(&self.path, message, help);
    }

    /// Notes a fault at the value of a key.
    pub fn fault_at(&self, key: &str, message: impl Into<String>) {
        self.context.fault(&join(&self.path, key), message, None);
    }

    /// The value of a key, when it is there.
    pub fn optional(&self, key: &str) -> Option<Item<'a>> {
        self.ask(key, false)
    }

    fn ask(&self, key: &str, required: bool) -> Option<Item<'a>> {
        self.asked.borrow_mut().push(key.to_string());
        self.context.seeks(&self.path, || Sought::Key {
            key: key.to_string(),
            required,
        });
        let entry = self.entries.iter().find(|e| e.key == key)?;
        Some(self.item(entry, key.to_string()))
    }

    /// The value of a key that must be there; `meaning` says what it is, for the message.
    pub fn required(&self, key: &str, meaning: &str) -> Option<Item<'a>> {
        let item = self.ask(key, true);
        if item.is_none() {
            self.fault(format!("`{key}` is missing: {meaning}"), None);
        }
        item
    }

    /// Whether a key is there; asking does not make it known.
    pub fn has(&self, key: &str) -> bool {
        self.entries.iter().any(|e| e.key == key)
    }

    /// The text of a key when it is there and a text; asking does not make it known.
    pub fn text_of(&self, key: &str) -> String {
        match self.entries.iter().find(|e| e.key == key).map(|e| &e.node.value) {
            Some(Value::String(text)) => text.clone(),
            _ => String::new(),
        }
    }

    /// All entries of a table whose keys are names chosen by the user.
    pub fn named(&self) -> Vec<Item<'a>> {
        (self.entries.iter())
            .map(|entry| {
                self.asked.borrow_mut().push(entry.key.clone());
                self.item(entry, entry.key.clone())
            })
            .collect()
    }

    fn item(&self, entry: &'a Entry, name: String) -> Item<'a> {
        Item {
            context: self.context,
            node: &entry.node,
            path: join(&self.path, &entry.key),
            name,
        }
    }

    /// The keys that are there, of those given.
    pub fn present(&self, keys: &[&str]) -> Vec<String> {
        let given = |k: &&&str| self.entries.iter().any(|e| e.key == **k);
        keys.iter().filter(given).map(|k| (*k).to_string()).collect()
    }

    /// Refuses every key that was not asked for. `place` says what the table is: "a wall of shape `sphere`".
    pub fn finish(self, place: &str) {
        self.refuse_others(place);
    }

    /// Refuses every key that was not asked for so far.
    pub fn refuse_others(&self, place: &str) {
        let asked = self.asked.borrow();
        let mut is_known = HashSet::new();
        let mut known: Vec<&str> = asked.iter().map(String::as_str).collect();
        known.retain(|key| is_known.insert(*key));
        for entry in self.entries.iter().filter(|e| !is_known.contains(e.key.as_str())) {
            let help = suggest_or_list(&entry.key, known.iter().copied());
            let message = format!("unknown key `{}` in {place}", entry.key);
            let path = join(&self.path, &entry.key);
            self.context.faults.borrow_mut().push_key(&path, message, help);
        }
    }

    /// Accepts all other keys unread: for a table whose kind could not be told, so that its keys mean nothing.
    pub fn abandon(self) {}
}
