//! From observations of collisions to the parameters of a law, and what the observations cannot tell.
//!
//! Where one impact of a damped spring shows the restitution and one thing more, the closed forms give the parameters.
//! Everywhere else damped least squares does, on the logarithms of parameters, with the error-controlled collision as the
//! model; observations are compared by logarithms where their error is relative, by differences where it is absolute. Then
//! the singular values of `d ln(observation)/d ln(parameter)` tell which products of powers of the parameters the
//! observations fix; directions along which no observation changes are not identifiable from them.

mod exact;
mod identify;
mod least_squares;
mod model;
mod singular;
#[cfg(test)]
mod tests;
mod verdict;

pub use identify::{Advice, Combination};

use super::error::CalibrateError;
use crate::materials::Material;
use crate::scenario::{FitFile, Measured, Observable, Observation, Target};
use demeter_physics::collision::Start;
use demeter_physics::dimension::Dimension;
use demeter_physics::parameters::{Value, Values};
use identify::{Identified, identify};
use least_squares::{Minimum, Problem};
use model::Model;

/// A parameter that was sought.
#[derive(Clone, Debug, PartialEq)]
pub struct FittedParameter {
    /// Its name in the file.
    pub name: String,
    /// Its value in SI; one of many when it is not identified.
    pub value: f64,
    /// Its dimension.
    pub dimension: Dimension,
    /// Whether the observations fix it, with an error that is not larger than itself.
    pub identified: bool,
    /// Its relative error, from the errors of the observations, when it changes what they show.
    pub error: Option<f64>,
    /// Whether the search ended at one of its bounds.
    pub at_bound: bool,
}

/// An observation and what the law shows there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// Number of the observation in the file, from 0.
    pub observation: usize,
    /// What was measured.
    pub observable: Observable,
    /// The measured value in SI.
    pub measured: f64,
    /// What the law shows.
    pub found: f64,
    /// How far off the law is, in errors of the observation ([`Measured::deviation`]).
    pub deviation: f64,
}

/// What became of a fit.
#[derive(Clone, Debug)]
pub struct FitReport {
    /// How the parameters were found, in words.
    pub method: &'static str,
    /// The parameters.
    pub parameters: Vec<FittedParameter>,
    /// The observations.
    pub residuals: Vec<Residual>,
    /// Singular values of the slopes of logarithms, descending.
    pub singular_values: Vec<f64>,
    /// What the observations fix: products of powers of parameters, those of one parameter among them.
    pub fixed: Vec<Combination>,
    /// Measurements that would fix what is not.
    pub advice: Vec<Advice>,
    /// Whether parameters that are clearly others fit as well.
    pub ambiguous: Option<Vec<f64>>,
    /// The law with all its parameters, as a scenario writes it.
    pub contact: String,
    /// Constants of materials that were sought, as a scenario writes them.
    pub material: Vec<String>,
    /// Where velocities were taken to be told, when the law acts across a gap, so that it makes a difference.
    pub start: Option<Start>,
}

impl FitReport {
    /// The largest deviation, in errors.
    pub fn worst(&self) -> f64 {
        self.residuals.iter().map(|r| r.deviation.abs()).fold(0.0, f64::max)
    }

    /// Sum of the squares of the deviations.
    pub fn chi_square(&self) -> f64 {
        self.residuals.iter().map(|r| r.deviation * r.deviation).sum()
    }

    /// How many observations there are beyond the numbers that they fix.
    pub fn degrees_of_freedom(&self) -> usize {
        self.residuals.len().saturating_sub(self.fixed.len())
    }

    /// Whether the law shows the observations within their errors: with errors that are Gaussian a law that is right does in
    /// 99 % of all cases, however many observations there are.
    pub fn fits(&self) -> bool {
        verdict::fits(self.residuals.iter().map(|r| r.deviation), self.fixed.len())
    }

    /// Names of the parameters that are not identified.
    pub fn not_identified(&self) -> impl Iterator<Item = &str> {
        let open = self.parameters.iter().filter(|p| !p.identified);
        open.map(|p| p.name.as_str())
    }
}

/// Relative error beyond which a parameter may as well be any other of its size.
const LARGEST_ERROR: f64 = 1.0;

/// Finds the parameters of a file.
pub fn fit(file: &FitFile) -> Result<FitReport, CalibrateError> {
    let model = Model { file };
    refuse_adhesion_of_none(&model)?;
    let measured: Vec<Measured> = (file.observations.iter().flat_map(|o| &o.measured)).copied().collect();
    let deviations_of = |point: &[f64], measured: &[Measured]| -> Option<Vec<f64>> {
        let found = model.logarithms(&from_logarithms(point)).ok()?;
        Some(found.iter().zip(measured).map(|(x, m)| m.deviation(*x)).collect())
    };
    let deviations = |point: &[f64]| deviations_of(point, &measured);
    // differences tell less of where to go from far away than logarithms do
    let relative: Vec<Measured> = measured.iter().map(Measured::as_relative).collect();
    let from_afar = |point: &[f64]| deviations_of(point, &relative);
    let logarithms = |pick: fn(&crate::scenario::Unknown) -> (f64, f64)| -> Vec<(f64, f64)> {
        let bounds = file.unknown.iter().map(pick);
        bounds.map(|(low, high)| (libm::log(low), libm::log(high))).collect()
    };
    let problem = Problem {
        deviations: &from_afar,
        measured: measured.len(),
        first: logarithms(|u| u.first),
        last: logarithms(|u| u.last),
    };
    let (method, mut minima) = search(file, &model, &problem)?;
    if measured != relative {
        minima = Problem {
            deviations: &deviations,
            ..problem
        }
        .minima_from(minima);
    }
    let best = &minima[0];
    let bounds = &logarithms(|u| u.last);
    let seen = identify(&model, &best.point, bounds, &measured).ok_or_else(|| {
        let message =
            "the law has no answer beside the parameters that were found: they lie at the edge of what it can do";
        CalibrateError::File(Box::new(file.refused("fit.unknown", message)))
    })?;
    let ambiguous = (minima.iter().skip(1))
        .filter(|other| other.cost < best.cost + 1.0)
        .find(|other| seen.differ(&best.point, &other.point))
        .map(|other| from_logarithms(&other.point));
    told(&model, best, method, seen, ambiguous, bounds)
}

/// What only adhesion shows is not to be fitted with a law that has none.
fn refuse_adhesion_of_none(model: &Model<'_>) -> Result<(), CalibrateError> {
    let file = model.file;
    let typical: Vec<f64> = file.unknown.iter().map(|u| (u.first.0 * u.first.1).sqrt()).collect();
    let Ok(law) = model.law(&typical) else {
        // the search tells what is wrong with it
        return Ok(());
    };
    for (number, observation) in file.observations.iter().enumerate() {
        let of_adhesion = observation.measured.iter().find(|m| !m.observable.of_impact());
        if let Some(seen) = of_adhesion
            && !model::adheres(&law, observation)
        {
            let key = seen.observable.name();
            let shows = match seen.observable {
                Observable::PullOffForce => "nothing holds such bodies when they are pulled apart",
                _ => "such bodies never stick",
            };
            let message = format!(
                "`{key}` cannot be fitted: law `{}` has no adhesion with these parameters, and {shows}. Leave the observation out, or \
                 fit a law with adhesion (`demeter laws` lists all)",
                file.law.name
            );
            return Err(file.refused(&format!("observation[{number}].{key}"), message).into());
        }
    }
    Ok(())
}

fn from_logarithms(point: &[f64]) -> Vec<f64> {
    point.iter().map(|x| libm::exp(*x)).collect()
}

/// The closed form, or the ends of the search.
fn search(
    file: &FitFile,
    model: &Model<'_>,
    problem: &Problem<'_>,
) -> Result<(&'static str, Vec<Minimum>), CalibrateError> {
    if let Some(values) = exact::exact(file) {
        let point: Vec<f64> = values.iter().map(|x| libm::log(*x)).collect();
        if let Some(found) = problem.at(point) {
            return Ok(("closed form", vec![found]));
        }
    }
    let minima = problem.minima();
    if minima.is_empty() {
        // the law itself tells best what it misses
        let middle: Vec<f64> = problem.first.iter().map(|(low, high)| 0.5 * (low + high)).collect();
        let why = match model.logarithms(&from_logarithms(&middle)) {
            Err(error) => error.to_string(),
            Ok(_) if problem.first == problem.last => "no values within the bounds give an answer".to_string(),
            Ok(_) => "no values that were tried give an answer; tell two bounds in place of \"free\"".to_string(),
        };
        return Err(file.refused("fit", why).into());
    }
    Ok(("damped least squares from several starts", minima))
}

fn told(
    model: &Model<'_>,
    best: &Minimum,
    method: &'static str,
    seen: Identified,
    ambiguous: Option<Vec<f64>>,
    bounds: &[(f64, f64)],
) -> Result<FitReport, CalibrateError> {
    let file = model.file;
    let values = from_logarithms(&best.point);
    let found = model.logarithms(&values)?;
    let measured = file.observations.iter().enumerate();
    let measured = measured.flat_map(|(k, o)| o.measured.iter().map(move |m| (k, m)));
    let residuals = measured.zip(&found).map(|((observation, m), logarithm)| Residual {
        observation,
        observable: m.observable,
        measured: m.value,
        found: libm::exp(*logarithm),
        deviation: m.deviation(*logarithm),
    });
    let residuals = residuals.collect();
    let law = model.law(&values)?;
    let acts_across_a_gap = |o: &Observation| model::acts_across_a_gap(&law, model::size_of(&o.a, &o.b));
    let start = file.observations.iter().any(acts_across_a_gap).then_some(file.start);
    let near = |x: f64, bound: f64| (x - bound).abs() < 1e-6;
    let parameters = (file.unknown.iter().enumerate())
        .map(|(k, unknown)| FittedParameter {
            name: unknown.name.clone(),
            value: values[k],
            dimension: unknown.dimension,
            identified: seen.errors[k].is_some_and(|error| error <= LARGEST_ERROR),
            error: seen.errors[k],
            at_bound: near(best.point[k], bounds[k].0) || near(best.point[k], bounds[k].1),
        })
        .collect();
    Ok(FitReport {
        method,
        parameters,
        residuals,
        fixed: seen.combinations(&file.unknown, &values),
        advice: identify::advice(model, &best.point, bounds, &seen),
        singular_values: seen.singular_values,
        ambiguous,
        contact: contact_line(file, &values),
        material: material_lines(file, &model.materials(&values)),
        start,
    })
}

/// A quantity as a scenario writes it.
pub fn written(value: f64, dimension: Dimension) -> String {
    let number = if value != 0.0 && !(1e-3..1e6).contains(&value.abs()) {
        format!("{value:e}")
    } else {
        format!("{value}")
    };
    match dimension.unit().as_str() {
        "" => number,
        unit => format!("\"{number} {unit}\""),
    }
}

fn contact_line(file: &FitFile, values: &[f64]) -> String {
    let mut all: Values = file.known.clone();
    for (unknown, &value) in file.unknown.iter().zip(values) {
        if let Target::Parameter(name) = unknown.target {
            all.insert(name.to_string(), value.into());
        }
    }
    let mut parts = vec![format!("law = \"{}\"", file.law.name)];
    for parameter in file.law.parameters {
        let text = match all.get(parameter.name) {
            None => continue,
            Some(Value::Number(value)) => written(*value, parameter.dimension),
            Some(Value::Text(text)) => toml::Value::String(text.clone()).to_string(),
            Some(Value::Table(rows)) => {
                let rows: Vec<String> = rows.iter().map(|[v, e]| format!("[\"{v} m/s\", {e}]")).collect();
                format!("[{}]", rows.join(", "))
            }
        };
        parts.push(format!("{} = {text}", parameter.name));
    }
    format!("normal = {{ {} }}", parts.join(", "))
}

fn material_lines(file: &FitFile, materials: &[Material]) -> Vec<String> {
    let mut lines = Vec::new();
    for unknown in &file.unknown {
        let (index, key, value) = match unknown.target {
            Target::YoungModulus(index) => (index, "young_modulus", materials[index].young_modulus),
            Target::PoissonRatio(index) => (index, "poisson_ratio", materials[index].poisson_ratio),
            Target::Parameter(_) => continue,
        };
        let value = written(value, unknown.dimension);
        lines.push(format!("material.{}.{key} = {value}", materials[index].name));
    }
    lines
}
