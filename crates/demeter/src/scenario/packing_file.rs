#![doc = include_str!("packing_file.md")]

use super::document::Value;
use super::fit_file::FitFile;
use super::plain::PLAIN_NUMBERS;
use super::quantity::Kind;
use super::reader::{Context, Item, TableReader};
use super::run::labels;
use super::{Diagnostics, Scenario, key_of, key_places, lone_fault, read_text, tree, units};
use crate::compare::{CompareError, Position, Reading, Strokes, is_repeat, measured_points, read_measured};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::Range;
use std::iter;
use std::path::{Path, PathBuf};

/// All keys of such a file, with their meaning.
pub const PACKING_FIT_REFERENCE: &str = include_str!("packing_file.md");

/// Most points of a curve that a file tells itself.
const MAX_POINTS: usize = 10_000;
/// Most cycles that may be discarded.
const MAX_DISCARDED: i64 = 1_000_000;
/// Share of the interval to which the unknown is found when no tolerance is told.
const TOLERANCE: f64 = 0.01;

/// A file for `demeter fit`.
#[derive(Clone, Debug)]
pub enum FitTask {
    /// Collisions were observed.
    Collisions(Box<FitFile>),
    /// A packing was squeezed.
    Packing(Box<PackingFile>),
}

impl FitTask {
    /// Reads a file: one with a table `[packing]` tells a packing, any other tells collisions.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, Diagnostics> {
        let name = path.display().to_string();
        let text = read_text(path).map_err(|fault| lone_fault(&name, fault))?;
        Self::parse(&text, &name, path.parent().unwrap_or(Path::new("")), overrides)
    }

    /// Reads a text. Relative paths in it start from `base`.
    pub fn parse(text: &str, name: &str, base: &Path, overrides: &[String]) -> Result<Self, Diagnostics> {
        let document = tree(text, name, overrides)?;
        let tells_packing = match &document.root.value {
            Value::Table(entries) => entries.iter().any(|entry| entry.key == "packing"),
            _ => false,
        };
        if tells_packing {
            return Ok(Self::Packing(Box::new(PackingFile::parse(
                text, name, base, overrides,
            )?)));
        }
        Ok(Self::Collisions(Box::new(FitFile::parse(text, name, overrides)?)))
    }
}

/// The number of a scenario that is sought.
#[derive(Clone, Debug, PartialEq)]
pub struct UnknownNumber {
    /// Its key, as for an override.
    pub key: String,
    /// Least value, in SI.
    pub from: f64,
    /// Largest value, in SI.
    pub to: f64,
    /// Its dimension.
    pub dimension: Dimension,
}

impl UnknownNumber {
    /// A value as a scenario writes it.
    pub fn written(&self, value: f64) -> String {
        match self.dimension {
            Dimension::NONE => self.plain(value),
            _ => format!("\"{}\"", self.plain(value)),
        }
    }

    /// A value with its unit.
    pub fn plain(&self, value: f64) -> String {
        let number = if value != 0.0 && !(1e-4..1e7).contains(&value.abs()) {
            format!("{value:e}")
        } else {
            format!("{value}")
        };
        format!("{number} {}", self.dimension.unit()).trim_end().to_string()
    }
}

/// What the run shall have in common with the experiment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Match {
    /// The force at the largest compression.
    Top,
    /// All forces.
    Curve,
}

/// What stands in a file of a squeezed packing.
#[derive(Clone, Debug)]
pub struct PackingFile {
    /// The scenario of the experiment.
    pub scenario: PathBuf,
    /// What is changed in it.
    pub set: Vec<String>,
    /// What is sought.
    pub unknown: UnknownNumber,
    /// What is compared.
    pub matched: Match,
    /// Accuracy of the unknown, in SI.
    pub tolerance: f64,
    /// How runs are read.
    pub reading: Reading,
    /// The experiment.
    pub measured: Strokes,
}

impl PackingFile {
    /// Reads a text and checks it with its scenario. Relative paths in it start from `base`.
    pub fn parse(text: &str, name: &str, base: &Path, overrides: &[String]) -> Result<Self, Diagnostics> {
        let document = tree(text, name, overrides)?;
        let context = Context::new(Diagnostics::new(name, document.clone()));
        let read = walk(&TableReader::root(&context, &document.root), base);
        let faults = || context.faults.borrow().clone();
        let Some(read) = read.filter(|_| faults().is_empty()) else {
            return Err(faults());
        };
        // both ends must make a scenario; the one at fault tells it with the text of the override
        read.scenario_at(read.unknown.from)?;
        let scenario = read.scenario_at(read.unknown.to)?;
        read.check(&scenario, &context);
        let faults = faults();
        if faults.is_empty() { Ok(read) } else { Err(faults) }
    }

    /// The scenario with a value of the unknown.
    pub fn scenario_at(&self, value: f64) -> Result<Scenario, Diagnostics> {
        let mut overrides = self.set.clone();
        overrides.push(format!("{}={}", self.unknown.key, self.unknown.written(value)));
        Scenario::read(&self.scenario, &overrides)
    }

    /// Tells what the runs of a scenario will lack, before the first of them.
    fn check(&self, scenario: &Scenario, context: &Context) {
        let keys: Vec<&str> = iter::once(self.unknown.key.as_str())
            .chain(self.set.iter().map(|set| key_of(set)))
            .collect();
        let places = key_places(&scenario.text, &keys);
        for (_, key) in places
            .iter()
            .zip(&keys)
            .skip(1)
            .filter(|(place, _)| **place == places[0])
        {
            let message = format!("`{key}` would have no effect: it is what is sought");
            context.fault("packing.set", message, None);
        }
        let header = labels(scenario).header();
        let has = |column: &str| {
            let named = |title: &String| title == column || title.split(" [").next() == Some(column);
            header.iter().any(named)
        };
        let force = self.reading.force_column().0;
        if !has(force) {
            let message = format!("the series of the scenario will have no column `{force}`");
            let help = "name the force on a wall of it, as \"wall top force z\"".to_string();
            context.fault("packing.force", message, Some(help));
        }
        if self.measured.position == Position::Strain && !has("strain") {
            let message = "the curve is told by strain, and the series of the scenario will have no strain";
            let help = "tell `output.strain` in the scenario, or give the compression of the plate".to_string();
            context.fault("packing.measured", message, Some(help));
        }
        if self.measured.position == Position::Compression
            && !self.reading.displacement_column().is_some_and(|column| has(&column))
        {
            let message = "the curve is told by compression, and `packing.force` is not the force on a wall";
            context.fault("packing.force", message, None);
        }
        let stages: Vec<&str> = scenario.stages.iter().map(|s| s.name.as_str()).collect();
        let cycles = |name: &str| stages.iter().filter(|stage| is_repeat(stage, name)).count();
        let told = [
            ("packing.load", Some(&self.reading.load)),
            ("packing.unload", self.reading.unload.as_ref()),
        ];
        for (path, name) in told {
            let Some(name) = name else {
                continue;
            };
            match cycles(name) {
                0 => {
                    let known: Vec<String> = stages.iter().take(20).map(|s| format!("`{s}`")).collect();
                    let help = format!("its stages are {}", known.join(", "));
                    context.fault(path, format!("the scenario has no stage `{name}`"), Some(help));
                }
                n if n <= self.reading.discard => {
                    let message = format!(
                        "the scenario has {n} stages `{name}`, and {} cycles are to be discarded: none is left",
                        self.reading.discard
                    );
                    context.fault("packing.discard", message, None);
                }
                _ => {}
            }
        }
    }
}

/// Nothing when something that is needed is missing; there are faults then.
pub(super) fn walk(table: &TableReader<'_>, base: &Path) -> Option<PackingFile> {
    if let Some(title) = table.optional("title") {
        title.label();
    }
    let packing = table
        .required("packing", "a table of what is sought")
        .and_then(|i| i.table())?;
    let scenario = packing
        .required("scenario", "the scenario of the experiment, a file")
        .map(|item| base.join(item.text()));
    let set = packing
        .optional("set")
        .map_or(Vec::new(), |item| item.items().iter().map(Item::text).collect());
    let unknown = packing
        .required(
            "unknown",
            "what is sought, as { key = \"contact.multi_contact.prefactor\", from = 0.8, to = 1.3 }",
        )
        .and_then(|item| item.table())
        .and_then(unknown);
    let matched = packing
        .required(
            "match",
            "\"top\", the force at the largest compression, or \"curve\", all forces",
        )
        .and_then(|item| item.choice(&["top", "curve"]));
    let tolerance = unknown.as_ref().map(|u| tolerance(&packing, u));
    let reading = reading(&packing);
    let measured = packing
        .required(
            "measured",
            "a table with the measured curve: file, or loading and unloading",
        )
        .and_then(|item| measured(&item, base));
    if unknown.is_none() {
        // what the tolerance is cannot be told; it is no unknown key
        packing.optional("tolerance");
    }
    packing.finish("[packing]");
    for entry in table
        .named()
        .iter()
        .filter(|e| !["packing", "title", PLAIN_NUMBERS].contains(&e.name.as_str()))
    {
        entry.fault(
            format!("unknown key `{}` in a file of a packing", entry.name),
            Some("a file tells a packing or collisions; keep them apart".to_string()),
        );
    }
    Some(PackingFile {
        scenario: scenario?,
        set,
        unknown: unknown?,
        matched: [Match::Top, Match::Curve][matched?],
        tolerance: tolerance?,
        reading,
        measured: measured?,
    })
}

fn unknown(table: TableReader<'_>) -> Option<UnknownNumber> {
    let key = table.required(
        "key",
        "the key of a number of the scenario, as \"contact.multi_contact.prefactor\"",
    );
    let [from, to] = ["from", "to"].map(|end| table.required(end, "an end of the interval in which it is sought"));
    let key = key.map(|item| item.text());
    let (from, to) = (number(&from?)?, number(&to?)?);
    if from.1 != to.1 {
        let message = format!("`from` is a {} and `to` a {}", from.1.name(), to.1.name());
        table.fault_at("to", message);
        return None;
    }
    if from.0 >= to.0 {
        table.fault_at("to", "`to` must be above `from`");
        return None;
    }
    table.finish("the unknown");
    Some(UnknownNumber {
        key: key?,
        from: from.0,
        to: to.0,
        dimension: from.1,
    })
}

/// A number of any dimension but an angle, in SI.
fn number(item: &Item<'_>) -> Option<(f64, Dimension)> {
    let Value::String(text) = &item.node.value else {
        let value = item.quantity(Kind::Number, Range::FINITE);
        return value.is_finite().then_some((value, Dimension::NONE));
    };
    match units::parse(text) {
        Ok(quantity) if quantity.angle == 0 => Some((quantity.value, quantity.dimension)),
        Ok(_) => {
            item.fault("an angle cannot be sought", None);
            None
        }
        Err(error) => {
            let help = "write it as 0.5 or \"5 kPa\"".to_string();
            item.fault(format!("`{}`: {error}", item.name), Some(help));
            None
        }
    }
}

fn tolerance(packing: &TableReader<'_>, unknown: &UnknownNumber) -> f64 {
    let width = unknown.to - unknown.from;
    let kind = Kind::of(unknown.dimension);
    let range = Range::new(0.0, false, width, false);
    (packing.optional_quantity("tolerance", kind, range)).unwrap_or(TOLERANCE * width)
}

fn reading(packing: &TableReader<'_>) -> Reading {
    let usual = Reading::default();
    let text = |key: &str, usual: String| packing.optional(key).map_or(usual, |item| item.label());
    let unload = match packing.optional("unload") {
        Some(item) if matches!(item.node.value, Value::Boolean(false)) => None,
        Some(item) => Some(item.label()),
        None => usual.unload,
    };
    let discard = packing
        .optional("discard")
        .map_or(0, |item| item.integer(0, MAX_DISCARDED));
    Reading {
        load: text("load", usual.load),
        unload,
        discard: usize::try_from(discard).unwrap_or(0),
        force: text("force", usual.force),
        also: Vec::new(),
        distribution: None,
    }
}

fn measured(item: &Item<'_>, base: &Path) -> Option<Strokes> {
    let table = item.table()?;
    let read = match table.optional("file") {
        Some(file) => {
            if let Some(key) = table.present(&["loading", "unloading"]).first() {
                table.fault_at(key, format!("`{key}` stands beside `file`; tell the curve once"));
            }
            let [_, _] = ["loading", "unloading"].map(|key| table.optional(key));
            read_measured(&base.join(file.text()))
        }
        None => told_points(&table)?,
    };
    table.finish("the measured curve");
    let refuse = |error: CompareError| item.fault(error.to_string(), None);
    let strokes = read.map_err(refuse).ok()?;
    if strokes
        .loading
        .iter()
        .chain(&strokes.unloading)
        .all(|level| level.force.is_none())
    {
        item.fault("the measured curve tells no force", None);
        return None;
    }
    Some(strokes)
}

type Points = Vec<(f64, f64)>;

fn told_points(table: &TableReader<'_>) -> Option<Result<Strokes, CompareError>> {
    let mut position = None;
    let [loading, unloading] = ["loading", "unloading"].map(|key| match table.optional(key) {
        None => Some(Points::new()),
        Some(item) => points(&item, &mut position),
    });
    let (loading, unloading) = (loading?, unloading?);
    let Some(position) = position else {
        let help = "write `file = \"measured.csv\"`, or `loading = [[0.05, \"1.2 N\"], ...]`".to_string();
        table.fault("the measured curve is missing", Some(help));
        return None;
    };
    Some(measured_points("the measured curve", position, &loading, &unloading))
}

/// Points of a position and a force. The first of all decides whether positions are strains or compressions.
fn points(item: &Item<'_>, position: &mut Option<Position>) -> Option<Points> {
    let items = item.items();
    if items.len() > MAX_POINTS {
        let message = format!("{} points are too many; at most {MAX_POINTS}, or a file", items.len());
        item.fault(message, None);
        return None;
    }
    let mut points = Points::new();
    for point in &items {
        let parts = point.items();
        let [at, force] = parts.as_slice() else {
            let help = "write it as [0.05, \"1.2 N\"]".to_string();
            point.fault("a point must be a strain and a force", Some(help));
            return None;
        };
        let kind = match position.get_or_insert(match at.node.value {
            Value::String(_) => Position::Compression,
            _ => Position::Strain,
        }) {
            Position::Compression => Kind::Physical(Dimension::LENGTH),
            _ => Kind::Number,
        };
        let force = force.quantity(Kind::Physical(Dimension::FORCE), Range::FINITE);
        points.push((at.quantity(kind, Range::FINITE), force));
    }
    points
        .iter()
        .all(|(at, force)| at.is_finite() && force.is_finite())
        .then_some(points)
}
