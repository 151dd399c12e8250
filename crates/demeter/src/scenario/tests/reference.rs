//! The tables of the references against the readers: the keys, whether they must be given, and what they may be.

use super::super::document::{Entry, Node, Value, join};
use super::super::reader::{Context, Sought};
use super::super::reference::{Form, Row, Section, sections, word};
use super::*;
use std::collections::{BTreeMap, BTreeSet};

/// What reading a text looked for, by path.
type Trace = BTreeMap<String, Vec<Sought>>;

fn trace(context: Context) -> Trace {
    let mut trace = Trace::new();
    for (path, sought) in context.sought.into_inner() {
        trace.entry(path).or_default().push(sought);
    }
    trace
}

/// Holds what readers look for against the sections of a reference.
struct Audit {
    sections: Vec<Section>,
    faults: BTreeSet<String>,
    /// Keys that were asked for, by section and kind of the table: how often, and how often as ones that must be there.
    asked: BTreeMap<(String, String, String), (usize, usize)>,
    /// Tables that were read, by section and kind.
    tables: BTreeMap<(String, String), usize>,
    /// Forms of values that were looked for: section, key, form.
    forms: BTreeSet<(String, String, String)>,
}

impl Audit {
    fn new(references: &[&str]) -> Self {
        let mut all: Vec<Section> = Vec::new();
        for section in references.iter().flat_map(|text| sections(text)) {
            if all.iter().all(|known| known.name != section.name) {
                all.push(section);
            }
        }
        Self {
            sections: all,
            faults: BTreeSet::new(),
            asked: BTreeMap::new(),
            tables: BTreeMap::new(),
            forms: BTreeSet::new(),
        }
    }

    fn section(&self, name: &str) -> Option<Section> {
        self.sections.iter().find(|section| section.name == name).cloned()
    }

    fn table(&mut self, trace: &Trace, name: &str, path: &str, entries: &[Entry]) {
        let Some(section) = self.section(name) else {
            self.faults.insert(format!("there is no section `{name}`"));
            return;
        };
        let kind = section.kinds().and_then(|(key, _)| {
            let entry = entries.iter().find(|entry| entry.key == key)?;
            match &entry.node.value {
                Value::String(kind) => Some(kind.clone()),
                _ => None,
            }
        });
        let kind = kind.as_deref();
        let rows: Vec<&Row> = section.rows.iter().filter(|row| row.belongs(kind).is_some()).collect();
        let told = (name.to_string(), kind.unwrap_or_default().to_string());
        *self.tables.entry(told).or_default() += 1;
        for sought in trace.get(path).into_iter().flatten() {
            let Sought::Key { key, required } = sought else {
                continue;
            };
            let is_refused = name == "a" && ["wall", "fixed"].contains(&key.as_str());
            if !is_refused && rows.iter().all(|row| row.key != *key) {
                self.faults
                    .insert(format!("`{name}` {kind:?}: `{key}` is read but not listed"));
            }
            let place = (name.to_string(), kind.unwrap_or_default().to_string(), key.clone());
            let times = self.asked.entry(place).or_default();
            times.0 += 1;
            times.1 += usize::from(*required);
        }
        for entry in entries {
            let path = join(path, &entry.key);
            match rows.iter().find(|row| row.key == entry.key) {
                Some(row) => self.value(trace, (name, row), &row.value, &path, &entry.node),
                None => {
                    self.faults.insert(format!("`{path}` is given but not listed"));
                }
            }
        }
    }

    fn value(&mut self, trace: &Trace, of: (&str, &Row), forms: &[Form], path: &str, node: &Node) {
        for sought in trace.get(path).into_iter().flatten() {
            if let Sought::Key { .. } = sought {
                continue;
            }
            match forms.iter().find(|form| allows(form, sought)) {
                Some(form) => {
                    let place = (of.0.to_string(), of.1.key.clone(), format!("{form:?}"));
                    self.forms.insert(place);
                }
                None => {
                    self.faults.insert(format!(
                        "`{path}`: the reader looks for {sought:?}, listed are {forms:?}"
                    ));
                }
            }
        }
        for form in forms {
            match (form, &node.value) {
                (Form::Table(name), Value::Table(entries)) => self.table(trace, name, path, entries),
                (Form::TablesByName(name), Value::Table(entries)) => {
                    for entry in entries {
                        if let Value::Table(inner) = &entry.node.value {
                            self.table(trace, name, &join(path, &entry.key), inner);
                        }
                    }
                }
                (Form::ByName(form), Value::Table(entries)) => {
                    for entry in entries {
                        let form = std::slice::from_ref(form.as_ref());
                        self.value(trace, of, form, &join(path, &entry.key), &entry.node);
                    }
                }
                (Form::Motion, Value::Table(entries)) => self.table(trace, "motion", path, entries),
                (Form::Motion, Value::Array(nodes)) => {
                    for (index, node) in nodes.iter().enumerate() {
                        self.value(trace, of, &[Form::Motion], &format!("{path}[{index}]"), node);
                    }
                }
                (Form::List(form), Value::Array(nodes)) => {
                    for (index, node) in nodes.iter().enumerate() {
                        let form = std::slice::from_ref(form.as_ref());
                        self.value(trace, of, form, &format!("{path}[{index}]"), node);
                    }
                }
                _ => {}
            }
        }
    }

    /// Whether every key and every form of the reference was read, and as listed.
    fn finish(mut self) {
        for section in &self.sections {
            let kinds = section
                .kinds()
                .map_or_else(|| vec![String::new()], |(_, kinds)| kinds.to_vec());
            for row in &section.rows {
                for kind in &kinds {
                    let Some(required) = row.belongs(Some(kind)) else {
                        continue;
                    };
                    let place = (section.name.clone(), kind.clone(), row.key.clone());
                    let tables = self.tables.get(&(section.name.clone(), kind.clone())).copied();
                    match self.asked.get(&place) {
                        None => self.faults.insert(format!("{place:?} is listed but never read")),
                        Some((asked, as_required)) if required && as_required < asked && place != normal() => {
                            self.faults.insert(format!("{place:?} is marked * but may be left out"))
                        }
                        Some((_, as_required)) if !required && Some(*as_required) >= tables => {
                            self.faults.insert(format!("{place:?} must be given: mark it *"))
                        }
                        Some(_) => false,
                    };
                }
                for form in row.value.iter().filter(|form| is_traced(form)) {
                    let place = (section.name.clone(), row.key.clone(), format!("{form:?}"));
                    if !self.forms.contains(&place) {
                        self.faults.insert(format!("{place:?} is listed but never looked for"));
                    }
                }
            }
        }
        let faults: Vec<String> = self.faults.into_iter().collect();
        assert!(faults.is_empty(), "{}", faults.join("\n"));
    }
}

/// The one key that must be there and is asked for in another way, as its absence has a message of its own.
fn normal() -> (String, String, String) {
    ("contact".to_string(), String::new(), "normal".to_string())
}

/// Whether a form of the reference is what a getter looks for.
fn allows(form: &Form, sought: &Sought) -> bool {
    match (form, sought) {
        (Form::Text | Form::Name | Form::LawName, Sought::Text) => true,
        (Form::Boolean | Form::False, Sought::Boolean) | (Form::Integer, Sought::Integer) => true,
        (Form::Words(listed), Sought::Choice(known)) => {
            listed.iter().collect::<BTreeSet<_>>() == known.iter().collect::<BTreeSet<_>>()
        }
        (Form::Quantity(listed), Sought::Quantity(kind)) | (Form::Vector(listed), Sought::Vector(kind)) => {
            listed == kind && !word(*kind).is_empty()
        }
        (Form::AnyQuantity, Sought::Quantity(_)) | (Form::Direction, Sought::Direction) => true,
        // what a getter of vectors and directions looks for within
        (Form::Direction, Sought::Vector(_) | Sought::List) | (Form::Vector(_), Sought::List) => true,
        (Form::List(_) | Form::Motion, Sought::List) => true,
        (Form::Table(_) | Form::TablesByName(_) | Form::ByName(_) | Form::Motion, Sought::Table) => true,
        (Form::Law(_) | Form::KnownParameters | Form::UnknownParameters | Form::MeasuredPoint, _) => true,
        _ => false,
    }
}

/// Whether a getter looks for this form; words beside other forms are compared by hand.
fn is_traced(form: &Form) -> bool {
    !matches!(
        form,
        Form::Words(_) | Form::Share | Form::False | Form::AnyQuantity | Form::MeasuredPoint
    )
}

/// Values that the good scenarios do not show, whether or not they make sense together.
const MORE: &str = r#"
plain_numbers = "SI"
[simulation]
coupling_tolerance = 1e-6
[domain]
outside = "stop"
[contact]
multi_contact = { law = "half-space" }
[[contact.pair]]
rolling = { law = "epsd" }
multi_contact = { law = "half-space" }
[[feed]]
from = { shape = "mesh", file = "room.txt", unit = "mm", scale = 0.1 }
[[feed]]
from = { shape = "mesh", triangles = [[["0 m", "0 m", "0 m"], "1 0 0 m", "0 1 0 m"]] }
[[removal]]
finer_than = "1 mm"
[[tag]]
ids = [1]
material = "glass"
coarser_than = "1 mm"
region = [{ shape = "mesh", file = "room.txt", scale = 0.1, shift = "0 0 1 m" }]
[[tag]]
region = { shape = "mesh", triangles = [["0 0 0 m", "1 0 0 m", "0 1 0 m"]] }
[[measure]]
kind = "region-count"
coarser_than = "1 mm"
[[wall]]
shape = "plane"
motion = { table = { file = "there-is-none.csv" } }
[output.strain]
from = "1 mm"
[[stage]]
output = { checkpoints = "1 s" }
contact = { rolling = { law = "epsd" }, pair = [{ rolling = { law = "epsd" } }] }
"#;

#[test]
fn the_reference_of_a_scenario_is_what_is_read() {
    let mut audit = Audit::new(&[REFERENCE]);
    let mut texts: Vec<String> = TEMPLATES.iter().map(|(_, _, text)| (*text).to_string()).collect();
    texts.retain(|text| text.contains("[[stage]]"));
    for file in std::fs::read_dir(good()).unwrap().map(|f| f.unwrap().path()) {
        if file.extension().is_some_and(|e| e == "toml") {
            texts.push(std::fs::read_to_string(file).unwrap());
        }
    }
    texts.push(MORE.to_string());
    for text in texts {
        let document = tree(&text, "case", &[]).unwrap();
        let context = Context::new(Diagnostics::new("case", Arc::clone(&document)));
        Scenario::walk(&context, &text, "case", &good(), Arc::clone(&document));
        let Value::Table(entries) = &document.root.value else {
            panic!()
        };
        audit.table(&trace(context), "", "", entries);
    }
    audit.finish();
}

/// Reads texts of another kind of file by its reader.
fn audit_files(references: &[&str], texts: &[String], read: impl Fn(&Context, &Node)) {
    let mut audit = Audit::new(references);
    for text in texts {
        let document = tree(text, "case", &[]).unwrap();
        let context = Context::new(Diagnostics::new("case", Arc::clone(&document)));
        read(&context, &document.root);
        let Value::Table(entries) = &document.root.value else {
            panic!()
        };
        audit.table(&trace(context), "", "", entries);
    }
    // of the references that are shared only what these files use is looked at
    let own: Vec<String> = sections(references[0])
        .into_iter()
        .map(|section| section.name)
        .collect();
    audit.sections.retain(|section| own.contains(&section.name));
    audit.finish();
}

const BODIES: &str = r#"
plain_numbers = "SI"
title = "two"
[material.mcc]
young_modulus = "6 GPa"
poisson_ratio = 0.3
density = "1500 kg/m^3"
[a]
material = "mcc"
radius = "5 mm"
[b]
material = "mcc"
radius = "5 mm"
fixed = true
"#;

#[test]
fn the_reference_of_two_bodies_is_what_is_read() {
    let rest = r#"
[contact]
normal = { law = "linear", restitution = 0.5, stiffness = "1e5 N/m" }
[impact]
velocity = "1 m/s"
angle = "10 deg"
spin_a = "1 rad/s"
spin_b = ["0 rad/s", "1 rad/s", "0 rad/s"]
start = "far"
[curve]
max_overlap = "1 um"
max_force = "1 N"
unload_to = "1 um"
reload = true
points = 10
"#;
    let swapped = format!("{BODIES}{rest}")
        .replace("spin_a", "spin")
        .replace("spin_b", "spin_a")
        .replace("spin = ", "spin_b = ");
    let wall = format!("{BODIES}{rest}").replace("fixed = true", "wall = true");
    audit_files(
        &[IMPACT_REFERENCE, REFERENCE],
        &[format!("{BODIES}{rest}"), swapped, wall],
        |context, root| {
            let diagnostics = context.faults.borrow().clone();
            impact::walk(TableReader::root(context, root), "case", diagnostics);
        },
    );
}

#[test]
fn the_reference_of_a_fit_is_what_is_read() {
    let rest = r#"
[fit]
law = "hertz-tsuji"
known = { contact_end = "zero-overlap" }
unknown = { restitution = "free", "material.mcc.young_modulus" = ["0.1 GPa", "100 GPa"] }
start = "contact"
[[observation]]
radius_a = "1 mm"
radius_b = "1 mm"
velocity = "1 m/s"
preload = "1 N"
restitution = 0.5
contact_time = "1 us"
max_overlap = "1 um"
max_force = "1 N"
sticking_velocity = "1 mm/s"
pull_off_force = "1 nN"
error = { restitution = 0.1, contact_time = "1 us", max_overlap = "1 um", max_force = "1 N", sticking_velocity = "1 mm/s", pull_off_force = "1 nN" }
[[observation]]
restitution = 0.5
error = "2 %"
"#;
    let references = [FIT_REFERENCE, IMPACT_REFERENCE, REFERENCE];
    audit_files(&references, &[format!("{BODIES}{rest}")], |context, root| {
        let diagnostics = context.faults.borrow().clone();
        fit_file::walk(TableReader::root(context, root), diagnostics);
    });
}

#[test]
fn the_reference_of_a_packing_is_what_is_read() {
    let told = r#"
title = "packing"
plain_numbers = "SI"
[packing]
scenario = "scenario.toml"
set = ["stage[2].repeat=7"]
unknown = { key = "contact.multi_contact.prefactor", from = 0.8, to = 1.3 }
match = "top"
tolerance = 0.005
force = "wall top force z"
load = "squeeze"
unload = "release"
discard = 5
[packing.measured]
loading = [[0.05, "1.2 N"], [0.18, "15.6 N"]]
unloading = [[0.05, "0.7 N"]]
"#;
    let file = told.split("loading").next().unwrap().to_string() + "file = \"there-is-none.csv\"\n";
    audit_files(&[PACKING_FIT_REFERENCE], &[told.to_string(), file], |context, root| {
        packing_file::walk(&TableReader::root(context, root), Path::new(""));
    });
}

#[test]
fn the_reference_tells_every_column_of_the_series() {
    for column in crate::output::COLUMNS {
        let title = column.title();
        assert!(REFERENCE.contains(&format!("`{title}`")), "`{title}`");
    }
}
