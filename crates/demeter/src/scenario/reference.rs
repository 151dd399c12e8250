//! The tables of keys in `reference.md` and its kin, read: the one list that the documentation, the schema for editors
//! and the tests of the readers share.

use super::quantity::Kind;
use demeter_physics::dimension::Dimension;

/// The keys of one table of a file.
#[derive(Clone, Debug)]
pub(super) struct Section {
    /// Where the table stands: `` for the top, `wall[]`, `material.*`.
    pub name: String,
    /// Its keys. A key whose value depends on the kind of the table has several rows.
    pub rows: Vec<Row>,
}

/// One key.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub key: String,
    /// Whether it must be given wherever it belongs.
    pub required: bool,
    /// The choices of the table's kind that it belongs to.
    pub of: Of,
    /// What its value may be: one of these.
    pub value: Vec<Form>,
    pub meaning: String,
    /// What stands in when it is not given.
    pub otherwise: String,
}

/// Kinds of a table that a key belongs to.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Of {
    /// All.
    All,
    /// These; whether it must be given there.
    Only(Vec<(String, bool)>),
    /// All but these.
    Not(Vec<String>),
    /// Tables that do not have this key.
    Without(String),
}

/// What a value may be.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Form {
    Text,
    /// A text that the user chooses.
    Name,
    Boolean,
    /// The boolean `false` alone.
    False,
    Integer,
    /// One of these words.
    Words(Vec<String>),
    Quantity(Kind),
    /// A quantity of any dimension, or a number.
    AnyQuantity,
    Vector(Kind),
    Direction,
    /// A quotient of two numbers.
    Share,
    List(Box<Form>),
    /// The table of a section.
    Table(String),
    /// Tables of a section by names.
    TablesByName(String),
    /// Other values by names.
    ByName(Box<Form>),
    /// A law of a family.
    Law(&'static str),
    /// The name of a normal law.
    LawName,
    /// Parameters of a normal law.
    KnownParameters,
    /// What a fit seeks.
    UnknownParameters,
    /// A position and a force.
    MeasuredPoint,
    /// One motion or several.
    Motion,
    /// What the column `value` tells cannot be understood; a test refuses it.
    Unreadable(String),
}

/// Words of the column `value` for quantities.
const QUANTITIES: [(&str, Kind); 22] = [
    ("number", Kind::Number),
    ("length", Kind::Physical(Dimension::LENGTH)),
    ("time", Kind::Physical(Dimension::TIME)),
    ("mass", Kind::Physical(Dimension::MASS)),
    ("velocity", Kind::Physical(Dimension::VELOCITY)),
    ("acceleration", Kind::Physical(Dimension::ACCELERATION)),
    ("force", Kind::Physical(Dimension::FORCE)),
    ("energy", Kind::Physical(Dimension::ENERGY)),
    ("pressure", Kind::Physical(Dimension::PRESSURE)),
    ("inverse pressure", Kind::Physical(Dimension::INVERSE_PRESSURE)),
    ("density", Kind::Physical(Dimension::DENSITY)),
    ("stiffness", Kind::Physical(Dimension::STIFFNESS)),
    ("damping coefficient", Kind::Physical(Dimension::DAMPING)),
    ("moment of inertia", Kind::Physical(Dimension::new(1, 2, 0))),
    ("frequency", Kind::Physical(Dimension::FREQUENCY)),
    ("angle", Kind::Angle),
    ("angular velocity", Kind::AngularVelocity),
    ("mass per time", Kind::MassRate),
    ("number per time", Kind::NumberRate),
    ("torque", Kind::Torque),
    ("torque per angle", Kind::TorsionalStiffness),
    ("torque per angular velocity", Kind::TorsionalDamping),
];

/// The sections of a reference.
pub(super) fn sections(reference: &str) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    let mut columns: Vec<String> = Vec::new();
    for line in reference.lines() {
        if let Some(heading) = line.strip_prefix("## `") {
            let name = heading.split('`').next().unwrap_or_default().trim();
            sections.push(Section {
                name: name.to_string(),
                rows: Vec::new(),
            });
        } else if line.starts_with("| key |") {
            columns = cells(line);
        } else if let (Some(section), true) = (sections.last_mut(), line.starts_with("| `")) {
            section.rows.push(row(&section.name, &columns, &cells(line)));
        }
    }
    sections
}

fn cells(line: &str) -> Vec<String> {
    let inner = line.trim().trim_start_matches('|').trim_end_matches('|');
    inner.split('|').map(|cell| cell.trim().to_string()).collect()
}

fn row(section: &str, columns: &[String], cells: &[String]) -> Row {
    let cell = |name: &str| {
        let place = columns.iter().position(|column| column == name);
        place.and_then(|place| cells.get(place)).map_or("", String::as_str)
    };
    let key = cell("key").split('`').nth(1).unwrap_or_default().to_string();
    let own = format!("{section}{}{key}", if section.is_empty() { "" } else { "." });
    Row {
        required: cell("key").ends_with('*'),
        of: of(cell("of")),
        value: value(cell("value"), &own),
        meaning: cell("meaning").to_string(),
        otherwise: cell("otherwise").to_string(),
        key,
    }
}

fn of(text: &str) -> Of {
    let words = |text: &str| -> Vec<String> { text.split(", ").map(str::to_string).collect() };
    if text.is_empty() {
        return Of::All;
    }
    if let Some(key) = text.strip_prefix("without `") {
        return Of::Without(key.trim_end_matches('`').to_string());
    }
    if let Some(others) = text.strip_prefix("all but ") {
        return Of::Not(words(others));
    }
    let only = words(text).into_iter().map(|word| match word.strip_suffix('*') {
        Some(word) => (word.to_string(), true),
        None => (word, false),
    });
    Of::Only(only.collect())
}

/// Reads the column `value`: forms joined by commas and `or`. `own` is the section that a table of this key has.
fn value(text: &str, own: &str) -> Vec<Form> {
    let mut forms: Vec<Form> = Vec::new();
    for part in text.split(", ").flat_map(|part| part.split(" or ")) {
        let word = part.strip_prefix("`\"").and_then(|rest| rest.strip_suffix("\"`"));
        match (word, forms.last_mut()) {
            (Some(word), Some(Form::Words(words))) => words.push(word.to_string()),
            (Some(word), Some(Form::List(items))) => {
                if let Form::Words(words) = items.as_mut() {
                    words.push(word.to_string());
                }
            }
            _ => forms.push(form(part, own)),
        }
    }
    forms
}

fn form(text: &str, own: &str) -> Form {
    if let Some(items) = text.strip_prefix("list of ").or_else(|| text.strip_prefix("lists of ")) {
        let own = format!("{own}[]");
        return Form::List(Box::new(form(items, &own)));
    }
    if let Some(kind) = text.strip_suffix(" vector").and_then(kind) {
        return Form::Vector(kind);
    }
    if let Some(word) = text.strip_prefix("`\"").and_then(|rest| rest.strip_suffix("\"`")) {
        return Form::Words(vec![word.to_string()]);
    }
    if let Some((_, section)) = text.split_once("table `").or_else(|| text.split_once("tables `")) {
        return Form::Table(section.trim_end_matches('`').to_string());
    }
    match text.strip_suffix('s').unwrap_or(text) {
        "table" => Form::Table(own.to_string()),
        "tables by name" => Form::TablesByName(format!("{own}.*")),
        "motions by name" => Form::ByName(Box::new(Form::Motion)),
        "motion" => Form::Motion,
        "text" => Form::Text,
        "name" => Form::Name,
        "boolean" => Form::Boolean,
        "`false`" => Form::False,
        "whole number" => Form::Integer,
        "direction" => Form::Direction,
        "share" => Form::Share,
        "point" => Form::Vector(Kind::Physical(Dimension::LENGTH)),
        "any quantity" => Form::AnyQuantity,
        "normal law" => Form::Law("normal"),
        "tangential law" => Form::Law("tangential"),
        "rolling law" => Form::Law("rolling"),
        "multi-contact law" => Form::Law("multi-contact"),
        "normal law name" => Form::LawName,
        "known parameter" => Form::KnownParameters,
        "unknown parameter" => Form::UnknownParameters,
        "measured point" => Form::MeasuredPoint,
        _ => kind(text).map_or_else(|| Form::Unreadable(text.to_string()), Form::Quantity),
    }
}

/// The quantity of a word, in the singular or the plural.
fn kind(word: &str) -> Option<Kind> {
    let known = |word: &str| QUANTITIES.iter().find(|(name, _)| *name == word).map(|(_, kind)| *kind);
    known(word).or_else(|| word.strip_suffix('s').and_then(known))
}

/// The word of the column `value` for a quantity.
pub(super) fn word(kind: Kind) -> String {
    match (QUANTITIES.iter().find(|(_, known)| *known == kind), kind) {
        (Some((word, _)), _) => (*word).to_string(),
        (None, Kind::Physical(dimension)) => dimension.name(),
        (None, _) => String::new(),
    }
}

impl Section {
    /// The key that tells the kind of the table, and its words, when other keys depend on it.
    pub fn kinds(&self) -> Option<(&str, &[String])> {
        let mut named = self.rows.iter().filter_map(|row| match &row.of {
            Of::All | Of::Without(_) => None,
            Of::Only(words) => words.first().map(|(word, _)| word),
            Of::Not(words) => words.first(),
        });
        let word = named.next()?;
        self.rows.iter().find_map(|row| match row.value.as_slice() {
            [Form::Words(words)] if row.required && words.contains(word) => Some((row.key.as_str(), words.as_slice())),
            _ => None,
        })
    }
}

impl Row {
    /// Whether the key belongs to a table of this kind, and whether it must be given there.
    pub fn belongs(&self, kind: Option<&str>) -> Option<bool> {
        match (&self.of, kind) {
            (Of::All | Of::Without(_), _) | (_, None) => Some(self.required),
            (Of::Only(words), Some(kind)) => words
                .iter()
                .find(|(word, _)| word == kind)
                .map(|(_, required)| *required),
            (Of::Not(words), Some(kind)) => (!words.iter().any(|word| word == kind)).then_some(self.required),
        }
    }
}
