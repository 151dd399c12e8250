#![doc = include_str!("fit_file.md")]

use super::document::Value;
use super::impact::{body_a, body_b, sphere_mass};
use super::materials::{check_known, find_law, materials, parameter_value};
use super::observed::{Measured, Observable, Observation, StandardError, Target, Unknown};
use super::other_kind::refuse_other_kind;
use super::quantity::Kind;
use super::reader::{Context, Item, TableReader, suggest_or_list};
use super::schema::FileKind;
use super::{Body, Diagnostics, Partner, lone_fault, read_text, tree};
use crate::materials::Material;
use demeter_physics::collision::Start;
use demeter_physics::contact::LawInfo;
use demeter_physics::contact::normal::LAWS;
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::{ParameterInfo, ParameterKind, Range, Values};
use std::path::Path;

/// All keys of such a file, with their meaning.
pub const FIT_REFERENCE: &str = include_str!("fit_file.md");

/// Most unknowns.
pub const MAX_UNKNOWNS: usize = 8;
/// Most observations.
pub const MAX_OBSERVATIONS: usize = 1000;

/// What stands in a file of observations.
#[derive(Clone, Debug)]
pub struct FitFile {
    /// Materials; an unknown constant has its first guess here.
    pub materials: Vec<Material>,
    /// The body that moves.
    pub a: Body,
    /// Its partner.
    pub b: Partner,
    /// Where velocities are told.
    pub start: Start,
    /// The law whose parameters are sought.
    pub law: &'static LawInfo,
    /// Its parameters that are known.
    pub known: Values,
    /// What is sought.
    pub unknown: Vec<Unknown>,
    /// What was seen.
    pub observations: Vec<Observation>,
    diagnostics: Diagnostics,
}

impl FitFile {
    /// Reads a file. Overrides are texts `key=value`, as `fit.law="linear"`.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, Diagnostics> {
        let name = path.display().to_string();
        let text = read_text(path).map_err(|fault| lone_fault(&name, fault))?;
        Self::parse(&text, &name, overrides)
    }

    /// Reads a text.
    pub fn parse(text: &str, name: &str, overrides: &[String]) -> Result<Self, Diagnostics> {
        let document = tree(text, name, overrides)?;
        refuse_other_kind(name, &document, FileKind::Fit)?;
        let diagnostics = Diagnostics::new(name, document.clone());
        let context = Context::new(diagnostics.clone());
        let read = walk(TableReader::root(&context, &document.root), diagnostics);
        let faults = context.faults.into_inner();
        match read {
            Some(read) if faults.is_empty() => Ok(read),
            _ => Err(faults),
        }
    }

    /// One fault at the value of a key.
    pub fn refused(&self, path: &str, message: impl Into<String>) -> Diagnostics {
        let mut faults = self.diagnostics.clone();
        faults.push(path, message, None);
        faults
    }
}

/// Nothing when there is no law to speak of; there are faults then.
pub(super) fn walk(table: TableReader<'_>, diagnostics: Diagnostics) -> Option<FitFile> {
    if let Some(title) = table.optional("title") {
        title.label();
    }
    let materials = materials(&table);
    let a = body_a(&table, &materials);
    let b = body_b(&table, &materials);
    let example = "a table [fit] with law and unknown";
    let fit = table.required("fit", example).and_then(|item| item.table());
    let observations = observations(&table, &materials, (a, b));
    let read = fit.and_then(|fit| {
        let law = law(&fit);
        let start = fit.optional("start").and_then(|item| item.choice(&["contact", "far"]));
        let known = fit.optional("known").and_then(|item| item.table());
        let unknown = fit
            .required("unknown", "a table of what is sought, as { restitution = \"free\" }")
            .and_then(|item| item.table());
        let Some(law) = law else {
            for table in known.into_iter().chain(unknown) {
                table.abandon();
            }
            fit.finish("[fit]");
            return None;
        };
        let known = known.map(|known| known_values(known, law)).unwrap_or_default();
        let unknown = unknown.map(|table| unknowns(table, law, &known, &materials));
        fit.finish("[fit]");
        Some(FitFile {
            materials: materials.clone(),
            a,
            b,
            start: [Start::Contact, Start::Far][start.unwrap_or(0)],
            law,
            known,
            unknown: unknown.unwrap_or_default(),
            observations,
            diagnostics,
        })
    });
    table.finish("a file of observations");
    read
}

fn law(fit: &TableReader<'_>) -> Option<&'static LawInfo> {
    let item = fit.required("law", "the name of the normal law whose parameters are sought")?;
    find_law(&item, &item.text(), "normal", LAWS)
}

fn known_values(table: TableReader<'_>, law: &'static LawInfo) -> Values {
    let mut known = Values::new();
    for parameter in law.parameters {
        if let Some(item) = table.optional(parameter.name) {
            known.insert(parameter.name.to_string(), parameter_value(&item, parameter));
        }
    }
    table.finish(&format!("the parameters of law `{}`", law.name));
    known
}

fn unknowns(table: TableReader<'_>, law: &'static LawInfo, known: &Values, materials: &[Material]) -> Vec<Unknown> {
    let items = table.named();
    if items.is_empty() {
        table.fault("nothing is sought: `unknown` names no parameter", None);
    }
    if items.len() > MAX_UNKNOWNS {
        table.fault(
            format!("{} unknowns are too many; at most {MAX_UNKNOWNS}", items.len()),
            None,
        );
    }
    let found: Vec<Unknown> = (items.iter().take(MAX_UNKNOWNS))
        .filter_map(|item| unknown(item, law, known, materials))
        .collect();
    let mut values = known.clone();
    for unknown in &found {
        if let Target::Parameter(name) = unknown.target {
            values.insert(name.to_string(), unknown.first.0.into());
        }
    }
    check_known(&table, law, &values);
    found
}

/// What a name stands for, with its dimension, its range and a typical value.
fn target(
    item: &Item<'_>,
    law: &'static LawInfo,
    known: &Values,
    materials: &[Material],
) -> Option<(Target, Dimension, Range, f64)> {
    if let Some(rest) = item.name.strip_prefix("material.") {
        let Some((name, property)) = rest.rsplit_once('.') else {
            let help = "write it as \"material.NAME.young_modulus\"".to_string();
            item.fault(format!("`{}` names no constant of a material", item.name), Some(help));
            return None;
        };
        let Some(index) = materials.iter().position(|m| m.name == name) else {
            let names = materials.iter().map(|m| m.name.as_str());
            item.fault(format!("unknown material `{name}`"), suggest_or_list(name, names));
            return None;
        };
        let material = &materials[index];
        return match property {
            "young_modulus" => Some((
                Target::YoungModulus(index),
                Dimension::PRESSURE,
                Range::POSITIVE,
                material.young_modulus,
            )),
            "poisson_ratio" => Some((
                Target::PoissonRatio(index),
                Dimension::NONE,
                Range::new(0.0, false, 0.5, true),
                material.poisson_ratio,
            )),
            _ => {
                let message = format!("`{property}` of a material cannot be sought");
                let help = "young_modulus and poisson_ratio can; a density is had by weighing".to_string();
                item.fault(message, Some(help));
                None
            }
        };
    }
    let Some(parameter) = law.parameters.iter().find(|p| p.name == item.name) else {
        let names = law.parameters.iter().filter(|p| is_number(p)).map(|p| p.name);
        item.fault(
            format!("law `{}` has no parameter `{}`", law.name, item.name),
            suggest_or_list(&item.name, names),
        );
        return None;
    };
    if !is_number(parameter) {
        item.fault(
            format!("`{}` is a choice, not a number; put it into `known`", item.name),
            None,
        );
        return None;
    }
    if known.contains_key(parameter.name) {
        item.fault(
            format!("`{}` is known and unknown; it is one or the other", item.name),
            None,
        );
    }
    let target = Target::Parameter(parameter.name);
    Some((target, parameter.dimension, parameter.range, parameter.typical))
}

fn is_number(parameter: &ParameterInfo) -> bool {
    !matches!(parameter.kind, ParameterKind::Choice(_))
}

/// A free unknown is first looked for within this factor of a typical value.
const FIRST: f64 = 1e3;
/// And then within this one.
const LAST: f64 = 1e12;
/// Least share that a free unknown can have.
const LEAST_SHARE: f64 = 1e-4;

fn unknown(item: &Item<'_>, law: &'static LawInfo, known: &Values, materials: &[Material]) -> Option<Unknown> {
    let (target, dimension, range, typical) = target(item, law, known, materials)?;
    let within = |factor: f64| {
        let (lower, upper) = (typical / factor, typical * factor);
        if range.upper.is_finite() {
            (LEAST_SHARE.max(range.lower), upper.min(range.upper))
        } else {
            (lower.max(range.lower), upper)
        }
    };
    let (first, last) = match &item.node.value {
        Value::String(text) if text == "free" => (within(FIRST), within(LAST)),
        Value::Array(_) => {
            let bounds = bounds(item, dimension, range)?;
            (bounds, bounds)
        }
        _ => {
            let help = Some("write two bounds, as [\"1 GPa\", \"10 GPa\"], or \"free\"".to_string());
            item.fault(format!("`{}` has no bounds", item.name), help);
            return None;
        }
    };
    Some(Unknown {
        name: item.name.clone(),
        target,
        dimension,
        first,
        last,
    })
}

fn bounds(item: &Item<'_>, dimension: Dimension, range: Range) -> Option<(f64, f64)> {
    let items = item.items();
    let [lower, upper] = items.as_slice() else {
        let message = format!("`{}` needs two bounds, found {}", item.name, items.len());
        item.fault(message, None);
        return None;
    };
    // the search goes by ratios
    let above_zero = Range::new(
        range.lower.max(0.0),
        range.lower > 0.0 && range.lower_allowed,
        range.upper,
        range.upper_allowed,
    );
    let kind = Kind::of(dimension);
    let (lower, upper) = (lower.quantity(kind, above_zero), upper.quantity(kind, above_zero));
    if lower >= upper {
        item.fault(
            format!("the first bound of `{}` must be below the second", item.name),
            None,
        );
    }
    (lower < upper).then_some((lower, upper))
}

fn observations(table: &TableReader<'_>, materials: &[Material], bodies: (Body, Partner)) -> Vec<Observation> {
    let Some(item) = table.required("observation", "at least one table [[observation]] of what was measured") else {
        return Vec::new();
    };
    let tables = item.tables("observation");
    if tables.len() > MAX_OBSERVATIONS {
        let message = format!("{} observations are too many; at most {MAX_OBSERVATIONS}", tables.len());
        item.fault(message, None);
        return Vec::new();
    }
    if tables.is_empty() && matches!(&item.node.value, Value::Array(_)) {
        item.fault("there is no observation", None);
    }
    tables.into_iter().map(|t| observation(t, materials, bodies)).collect()
}

fn resized(table: &TableReader<'_>, key: &str, body: Body, materials: &[Material]) -> Body {
    match table.optional_quantity(key, Kind::Physical(Dimension::LENGTH), Range::POSITIVE) {
        Some(radius) => Body {
            radius,
            mass: sphere_mass(radius, body.material, materials),
            ..body
        },
        None => body,
    }
}

fn observation(table: TableReader<'_>, materials: &[Material], (a, b): (Body, Partner)) -> Observation {
    let a = resized(&table, "radius_a", a, materials);
    let b = match b {
        Partner::Free(body) => Partner::Free(resized(&table, "radius_b", body, materials)),
        Partner::Fixed(body) => Partner::Fixed(resized(&table, "radius_b", body, materials)),
        Partner::Wall(_) => b,
    };
    let velocity = table.optional_quantity("velocity", Kind::Physical(Dimension::VELOCITY), Range::POSITIVE);
    let preload = table.optional_quantity("preload", Kind::Physical(Dimension::FORCE), Range::POSITIVE);
    let mut measured = Vec::new();
    for observable in Observable::ALL {
        let kind = Kind::of(observable.dimension());
        if let Some(value) = table.optional_quantity(observable.name(), kind, observable.range()) {
            measured.push(Measured {
                observable,
                value,
                error: StandardError::Relative(DEFAULT_ERROR),
            });
        }
    }
    if measured.is_empty() {
        let names: Vec<&str> = Observable::ALL.iter().map(|o| o.name()).collect();
        let help = Some(format!("one or more of {}", names.join(", ")));
        table.fault("this observation holds nothing that was measured", help);
    }
    if let (None, Some(seen)) = (velocity, measured.iter().find(|m| m.observable.of_impact())) {
        let name = seen.observable.name();
        table.fault(
            format!("`velocity` is missing: the impact speed at which `{name}` was measured"),
            None,
        );
    }
    if preload.is_some() && measured.iter().all(|m| m.observable != Observable::PullOffForce) {
        table.fault_at("preload", "`preload` goes with `pull_off_force`, which is not there");
    }
    if let Some(item) = table.optional("error") {
        errors(&item, &mut measured);
    }
    table.finish("an observation");
    Observation {
        a,
        b,
        velocity,
        preload,
        measured,
    }
}

/// Relative error of what tells none.
pub const DEFAULT_ERROR: f64 = 0.01;

fn errors(item: &Item<'_>, measured: &mut [Measured]) {
    if !matches!(item.node.value, Value::Table(_)) {
        let error = item.quantity(Kind::Number, Range::POSITIVE_SHARE);
        measured
            .iter_mut()
            .for_each(|m| m.error = StandardError::Relative(error));
        return;
    }
    let Some(table) = item.table() else {
        return;
    };
    for m in measured {
        let kind = Kind::of(m.observable.dimension());
        if let Some(error) = table.optional_quantity(m.observable.name(), kind, Range::POSITIVE) {
            m.error = StandardError::Absolute(error);
        }
    }
    table.finish("the errors of what this observation measured");
}
