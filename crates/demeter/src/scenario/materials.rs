//! Tables `[material.*]` and `[contact]`: materials and the contact laws of every pair.

use super::Scenario;
use super::diagnostics::Diagnostics;
use super::document::{Value, join};
use super::quantity::Kind;
use super::reader::{Item, MAX_LABEL, TableReader, is_label, suggest_or_list};
use crate::materials::{Material, POISSON, PairChoice, called_elsewhere};
use demeter_physics::contact::{LawChoice, LawInfo, laws as all_laws, multi_contact, normal, rolling, tangential};
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::{
    ParameterError, ParameterInfo, ParameterKind, Range, Value as ParameterValue, Values, resolve,
};
use std::collections::BTreeMap;

/// Most materials: the laws of every pair are kept.
pub const MAX_MATERIALS: usize = 256;

/// Contact laws of every pair of materials.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactSpec {
    /// Laws of a pair without an entry of its own.
    pub default: PairChoice,
    /// Entries of pairs by the indices of their materials, the lower first.
    pub pairs: Vec<(u16, u16, PairChoice)>,
    /// Path of the table that told them: `contact`, or that of a stage.
    table: String,
    /// How many of the pairs, the first ones, that table tells; others have entries in `[contact]`.
    told: usize,
}

impl ContactSpec {
    /// Laws of a pair of materials, in any order.
    pub fn choice(&self, a: usize, b: usize) -> PairChoice {
        self.entry(a, b)
            .map_or(&self.default, |index| &self.pairs[index].2)
            .clone()
    }

    /// Path of the table that tells the laws of a pair of materials, in any order.
    pub fn path(&self, a: usize, b: usize) -> String {
        match self.entry(a, b).filter(|index| *index < self.told) {
            Some(index) => format!("{}.pair[{index}]", self.table),
            None => self.table.clone(),
        }
    }

    /// Path of the table that told them.
    pub(super) fn table(&self) -> &str {
        &self.table
    }

    fn entry(&self, a: usize, b: usize) -> Option<usize> {
        let pair = (a.min(b), a.max(b));
        (self.pairs.iter()).position(|p| (usize::from(p.0), usize::from(p.1)) == pair)
    }
}

pub(super) fn materials(root: &TableReader<'_>) -> Vec<Material> {
    let example = "[material.glass] with young_modulus, poisson_ratio and density";
    let Some(item) = root.required("material", &format!("at least one table, as {example}")) else {
        return Vec::new();
    };
    let Some(table) = item.table() else {
        return Vec::new();
    };
    let entries = table.named();
    if entries.is_empty() {
        item.fault(format!("there is no material; write {example}"), None);
    }
    if !entries.is_empty() && entries.iter().all(|e| !matches!(e.node.value, Value::Table(_))) {
        item.fault(
            "a material needs a name",
            Some("write `[material.NAME]`, as [material.glass]".to_string()),
        );
        return Vec::new();
    }
    if entries.len() > MAX_MATERIALS {
        item.fault(
            format!("{} materials are too many; at most {MAX_MATERIALS}", entries.len()),
            None,
        );
    }
    for entry in entries.iter().take(MAX_MATERIALS) {
        check_name(entry);
    }
    entries.iter().take(MAX_MATERIALS).map(material).collect()
}

/// Most characters of a name that are told.
const SHOWN: usize = 40;

/// Names stand in files of grains, where commas and semicolons part the columns.
fn check_name(entry: &Item<'_>) {
    let is_apart = |c: char| matches!(c, ',' | ';' | '"');
    if !is_label(&entry.name) || entry.name.contains(is_apart) {
        let message = format!(
            "the name of a material must have 1 to {MAX_LABEL} printable characters and no comma, semicolon or quote, as it stands in \
             files of grains; this is `{}`",
            entry.name.chars().take(SHOWN).collect::<String>().escape_debug()
        );
        entry.fault(
            message,
            Some("write `[material.NAME]`, as [material.glass]".to_string()),
        );
    }
}

/// `mPa` in place of `MPa` makes a material a thousand million times too soft.
fn refuse_millipascals(table: &TableReader<'_>) {
    if let Some(number) = table.text_of("young_modulus").trim_end().strip_suffix("mPa") {
        let message = "mPa are thousandths of a pascal, of which no solid is as soft";
        let help = format!("say \"{number}MPa\" for megapascals, or write the number in Pa");
        table
            .context
            .fault(&join(&table.path, "young_modulus"), message, Some(help));
    }
}

fn material(item: &Item<'_>) -> Material {
    let mut material = Material {
        name: item.name.clone(),
        young_modulus: f64::NAN,
        poisson_ratio: f64::NAN,
        density: f64::NAN,
    };
    let Value::Table(_) = &item.node.value else {
        let message = format!(
            "a material is a table; write `[material.NAME]` with `{}` in it",
            item.name
        );
        item.fault(message, None);
        return material;
    };
    if let Some(table) = item.table() {
        let modulus = Kind::Physical(Dimension::PRESSURE);
        let density = Kind::Physical(Dimension::DENSITY);
        material.young_modulus = table.quantity(
            "young_modulus",
            modulus,
            Range::POSITIVE,
            "Young's modulus, as \"5 MPa\"",
        );
        refuse_millipascals(&table);
        material.poisson_ratio = table.quantity("poisson_ratio", Kind::Number, POISSON, "Poisson's ratio, as 0.3");
        material.density = table.quantity(
            "density",
            density,
            Range::POSITIVE,
            "the mass density, as \"2500 kg/m^3\"",
        );
        table.finish("a material");
    }
    material
}

/// Index of the material that a value names; 0 with a fault when there is none of this name.
pub(super) fn material_index(item: &Item<'_>, materials: &[Material]) -> u16 {
    let name = item.text();
    match materials.iter().position(|m| m.name == name) {
        Some(index) => index as u16,
        None => {
            if matches!(item.node.value, Value::String(_)) && !materials.is_empty() {
                let known = materials.iter().map(|m| m.name.as_str());
                item.fault(format!("unknown material `{name}`"), suggest_or_list(&name, known));
            }
            0
        }
    }
}

/// Binds the laws of every pair: a law may refuse values that are each within their range but do not go together. What is
/// wrong with a table of many pairs is told once.
pub(super) fn check_laws(scenario: &Scenario, faults: &mut Diagnostics) {
    let materials = &scenario.materials;
    let mut found = BTreeMap::<(String, String), (String, usize)>::new();
    let all = std::iter::once(&scenario.contact).chain(&scenario.stage_contacts);
    for (contact, a) in all.flat_map(|contact| (0..materials.len()).map(move |a| (contact, a))) {
        let first = &materials[a];
        for (b, second) in materials.iter().enumerate().skip(a) {
            let Err(error) = contact.choice(a, b).bind(first, second) else {
                continue;
            };
            let family = all_laws().find(|l| l.name == error.law()).map_or("", |l| l.family);
            let path = format!("{}.{}", contact.path(a, b), family.replace('-', "_"));
            let pair = || (format!("`{}` and `{}`", first.name, second.name), 0);
            let fault = (path.trim_end_matches('.').to_string(), error.to_string());
            found.entry(fault).and_modify(|told| told.1 += 1).or_insert_with(pair);
        }
    }
    for ((path, error), (pair, more)) in found {
        let others = match more {
            0 => String::new(),
            1 => " (and one more pair)".to_string(),
            more => format!(" (and {more} more pairs)"),
        };
        faults.push(&path, format!("between {pair}{others}: {error}"), None);
    }
}

/// The families in the order of their keys.
const FAMILIES: [(&str, &[LawInfo]); 4] = [
    ("normal", normal::LAWS),
    ("tangential", tangential::LAWS),
    ("rolling", rolling::LAWS),
    ("multi_contact", multi_contact::LAWS),
];

/// Laws of all families.
type Laws = [Option<LawChoice>; 4];

fn nothing() -> PairChoice {
    PairChoice {
        normal: LawChoice {
            law: String::new(),
            parameters: Values::new(),
        },
        tangential: None,
        rolling: None,
        multi_contact: None,
    }
}

fn pair_choice([normal, tangential, rolling, multi_contact]: Laws) -> PairChoice {
    let normal = normal.unwrap_or_else(|| nothing().normal);
    PairChoice {
        normal,
        tangential,
        rolling,
        multi_contact,
    }
}

fn laws_of(choice: &PairChoice) -> Laws {
    let PairChoice {
        normal,
        tangential,
        rolling,
        multi_contact,
    } = choice.clone();
    [Some(normal), tangential, rolling, multi_contact]
}

pub(super) fn contact(root: &TableReader<'_>, materials: &[Material]) -> ContactSpec {
    let mut spec = ContactSpec {
        default: nothing(),
        pairs: Vec::new(),
        table: "contact".to_string(),
        told: 0,
    };
    let meaning = "a table [contact] with the contact laws, as normal = { law = \"hertz-tsuji\", restitution = 0.9 }";
    let Some(table) = root.required("contact", meaning).and_then(|i| i.table()) else {
        return spec;
    };
    let defaults = laws(&table, &[const { None }; 4], Telling::WHOLE);
    if !table.has("normal") {
        let help = "write normal = { law = \"hertz-tsuji\", restitution = 0.9 }";
        table.fault("`normal` is missing: the law of normal contact", Some(help.to_string()));
    }
    spec.pairs = pairs(&table, materials, |entry, _| laws(entry, &defaults, Telling::WHOLE));
    spec.told = spec.pairs.len();
    table.finish("[contact]");
    spec.default = pair_choice(defaults);
    spec
}

/// Laws that a stage tells. What it names holds for every pair; all else is as in `[contact]`.
pub(super) fn contact_of_stage(table: &TableReader<'_>, base: &ContactSpec, materials: &[Material]) -> ContactSpec {
    let default = pair_choice(laws(table, &laws_of(&base.default), Telling::OF_STAGE));
    let over = |choice: &PairChoice| laws(table, &laws_of(choice), Telling::FOR_ALL_PAIRS);
    let mut pairs = pairs(table, materials, |entry, between| {
        let own = between.map(|(a, b)| over(&base.choice(a.into(), b.into())));
        laws(entry, &own.unwrap_or_else(|| laws_of(&default)), Telling::OF_STAGE)
    });
    let told = pairs.len();
    for (a, b, choice) in &base.pairs {
        if pairs[..told].iter().all(|pair| (pair.0, pair.1) != (*a, *b)) {
            pairs.push((*a, *b, pair_choice(over(choice))));
        }
    }
    table.refuse_others("the contact laws of a stage");
    ContactSpec {
        default,
        pairs,
        table: table.path.clone(),
        told,
    }
}

/// The entries of pairs in a table, each with the laws that `read` finds for these materials.
fn pairs(
    table: &TableReader<'_>,
    materials: &[Material],
    read: impl Fn(&TableReader<'_>, Option<(u16, u16)>) -> Laws,
) -> Vec<(u16, u16, PairChoice)> {
    let mut pairs: Vec<(u16, u16, PairChoice)> = Vec::new();
    let header = format!("{}.pair", table.path);
    let entries = table.optional("pair").map(|i| i.tables(&header));
    for entry in entries.unwrap_or_default() {
        let between = between(&entry, materials);
        let choice = pair_choice(read(&entry, between));
        if let Some((a, b)) = between {
            if pairs.iter().any(|p| (p.0, p.1) == (a, b)) {
                let (first, second) = (&materials[usize::from(a)].name, &materials[usize::from(b)].name);
                entry.fault(format!("the pair `{first}` and `{second}` has two entries"), None);
            }
            pairs.push((a, b, choice));
        }
        entry.finish(&format!("[[{header}]]"));
    }
    pairs
}

fn between(entry: &TableReader<'_>, materials: &[Material]) -> Option<(u16, u16)> {
    let item = entry.required("between", "the two materials, as [\"glass\", \"steel\"]")?;
    let names = item.items();
    if names.len() != 2 {
        if matches!(item.node.value, Value::Array(_)) {
            item.fault(format!("`between` names two materials, found {}", names.len()), None);
        }
        return None;
    }
    let a = material_index(&names[0], materials);
    let b = material_index(&names[1], materials);
    (usize::from(a.max(b)) < materials.len()).then_some((a.min(b), a.max(b)))
}

/// What a table may tell of laws.
#[derive(Clone, Copy)]
struct Telling {
    /// How many of the families.
    families: usize,
    /// Whether values without a law stand for nothing where there is none.
    may_be_in_vain: bool,
}

impl Telling {
    const WHOLE: Self = Self {
        families: FAMILIES.len(),
        may_be_in_vain: false,
    };
    /// How surfaces are displaced holds for all stages.
    const OF_STAGE: Self = Self {
        families: 3,
        may_be_in_vain: false,
    };
    const FOR_ALL_PAIRS: Self = Self {
        families: 3,
        may_be_in_vain: true,
    };
}

fn laws(table: &TableReader<'_>, defaults: &Laws, telling: Telling) -> Laws {
    let names_no_law =
        |item: &Item<'_>| matches!(&item.node.value, Value::Table(keys) if keys.iter().all(|key| key.key != "law"));
    let mut chosen = defaults.clone();
    for (chosen, (family, known)) in chosen.iter_mut().zip(FAMILIES).take(telling.families) {
        if let Some(item) = table.optional(family) {
            let is_in_vain = telling.may_be_in_vain && chosen.is_none() && names_no_law(&item);
            if !is_in_vain {
                *chosen = law(&item, family, known, chosen.as_ref());
            }
        }
    }
    chosen
}

/// A law: its name alone, `"none"`, or a table of its name and parameters. Parameters that an entry of a pair does
/// not name are those of the default, as long as the law is the same; one of several alternatives takes the place of
/// the others, and of what stands beside these.
fn law(item: &Item<'_>, family: &str, known: &[LawInfo], default: Option<&LawChoice>) -> Option<LawChoice> {
    if let Value::String(name) = &item.node.value {
        if name == "none" && family != "normal" {
            return None;
        }
        let info = find_law(item, name, family, known)?;
        let parameters = inherited(info, default);
        check_parameters(item, info, &parameters);
        return Some(LawChoice {
            law: info.name.to_string(),
            parameters,
        });
    }
    let table = item.table()?;
    let info = match (table.optional("law"), default) {
        (Some(name), _) => find_law(&name, &name.text(), family, known),
        (None, Some(default)) => known.iter().find(|l| l.name == default.law),
        (None, None) => {
            let names: Vec<String> = known.iter().map(|l| format!("`{}`", l.name)).collect();
            let help = format!("known are {}", names.join(", "));
            table.fault(format!("`law` is missing: the name of the {family} law"), Some(help));
            None
        }
    };
    let Some(info) = info else {
        table.abandon();
        return None;
    };
    let mut parameters = inherited(info, default);
    let told: Vec<(&str, ParameterValue)> = (info.parameters.iter())
        .filter_map(|parameter| {
            Some((
                parameter.name,
                parameter_value(&table.optional(parameter.name)?, parameter),
            ))
        })
        .collect();
    for group in info.alternatives {
        let Some((name, value)) = told.iter().find(|(name, _)| group.of.contains(name)) else {
            continue;
        };
        // another number in place of one leaves what stands beside it, as the speed of a restitution
        let is_another_number =
            |was: &ParameterValue| matches!((was, value), (ParameterValue::Number(_), ParameterValue::Number(_)));
        let keeps = parameters.get(*name).is_some_and(is_another_number);
        let beside = if keeps { &[][..] } else { group.with };
        for name in group.of.iter().chain(beside) {
            parameters.remove(*name);
        }
    }
    parameters.extend(told.into_iter().map(|(name, value)| (name.to_string(), value)));
    check_parameters(item, info, &parameters);
    table.finish(&format!("the {family} law `{}`", info.name));
    Some(LawChoice {
        law: info.name.to_string(),
        parameters,
    })
}

/// Value of a parameter as its kind asks.
pub(super) fn parameter_value(item: &Item<'_>, parameter: &ParameterInfo) -> ParameterValue {
    match parameter.kind {
        ParameterKind::Number => item.quantity(Kind::of(parameter.dimension), parameter.range).into(),
        ParameterKind::Choice(words) => {
            let word = item.text();
            if matches!(item.node.value, Value::String(_)) && !words.contains(&word.as_str()) {
                let message = format!("`{}` has no choice `{word}`", item.name);
                item.fault(message, suggest_or_list(&word, words.iter().copied()));
            }
            ParameterValue::Text(word)
        }
        ParameterKind::Restitution => restitution_value(item, parameter),
    }
}

/// A restitution: a number, rows of impact speed and restitution, or a formula.
fn restitution_value(item: &Item<'_>, parameter: &ParameterInfo) -> ParameterValue {
    let value = match &item.node.value {
        Value::Array(_) => ParameterValue::Table(item.items().iter().map(restitution_row).collect()),
        // a percentage is a number, too
        Value::String(text) if super::units::parse(text).is_err() => ParameterValue::Text(text.clone()),
        Value::Integer(0) | Value::Float(0.0) => {
            let help = "a small one, as 0.01, is nearly the same: no dashpot stops bodies within one collision";
            item.fault(
                format!("`{}` is 0; it must be {}", item.name, parameter.range),
                Some(help.to_string()),
            );
            return f64::NAN.into();
        }
        _ => return item.quantity(Kind::Number, parameter.range).into(),
    };
    if matches!(&value, ParameterValue::Table(rows) if rows.iter().flatten().any(|x| x.is_nan())) {
        return value;
    }
    let alone = [(parameter.name.to_string(), value.clone())].into();
    let known = std::slice::from_ref(parameter);
    for error in resolve(known, &alone).err().into_iter().flatten() {
        item.fault(error.to_string(), None);
    }
    value
}

/// One row `["0.1 m/s", 0.9]` of a table of restitution.
fn restitution_row(row: &Item<'_>) -> [f64; 2] {
    let cells = row.items();
    let [speed, restitution] = cells.as_slice() else {
        if matches!(row.node.value, Value::Array(_)) {
            let message = format!("a row of a restitution table holds two values, found {}", cells.len());
            row.fault(message, Some("write it as [\"0.1 m/s\", 0.9]".to_string()));
        }
        return [f64::NAN; 2];
    };
    let mut told = speed.quantity(Kind::Physical(Dimension::VELOCITY), Range::FINITE);
    if told <= 0.0 {
        let message = format!("an impact speed of `{}` is {told} m/s; it must be above 0", row.name);
        let help = "begin with a small speed, as [\"1 mm/s\", 0.9]: below that of the first row its restitution holds";
        speed.fault(message, Some(help.to_string()));
        told = f64::NAN;
    }
    [told, restitution.quantity(Kind::Number, Range::POSITIVE_SHARE)]
}

fn inherited(info: &LawInfo, default: Option<&LawChoice>) -> Values {
    let same = default.filter(|d| d.law == info.name);
    same.map(|d| d.parameters.clone()).unwrap_or_default()
}

/// Tells parameters that are neither known nor sought.
pub(super) fn check_known(table: &TableReader<'_>, info: &LawInfo, parameters: &Values) {
    for error in resolve(info.parameters, parameters).err().into_iter().flatten() {
        if let ParameterError::Missing { .. } = error {
            let message = format!("law `{}`: {error}; make it known or unknown", info.name);
            table.fault(message, None);
        }
    }
}

/// Tells parameters that are missing; those that are there were checked when they were read.
fn check_parameters(item: &Item<'_>, info: &LawInfo, parameters: &Values) {
    let Err(errors) = resolve(info.parameters, parameters) else {
        return;
    };
    for error in errors {
        if let ParameterError::Missing { .. } = error {
            let message = format!("law `{}`: {error}", info.name).trim_end().to_string();
            item.fault(message, None);
        }
    }
}

pub(super) fn find_law<'l>(item: &Item<'_>, name: &str, family: &str, known: &'l [LawInfo]) -> Option<&'l LawInfo> {
    let found = known.iter().find(|l| l.name == name);
    if found.is_none() && matches!(item.node.value, Value::String(_)) {
        let other = FAMILIES.iter().find(|(_, laws)| laws.iter().any(|l| l.name == name));
        let help = match other {
            Some((other, _)) => Some(format!("`{name}` is a {other} law")),
            None => called_elsewhere(name).or_else(|| suggest_or_list(name, known.iter().map(|l| l.name))),
        };
        item.fault(format!("unknown {family} law `{name}`"), help);
    }
    found
}
