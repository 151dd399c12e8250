//! One number of a scenario from a measured force curve: the prefactor of the multi-contact models from the force on a
//! plate, as Brodu, Dijksman and Behringer (2015) found it, or any other number.
//!
//! Every trial is a whole run. [`Match::Top`] brackets the value at which `Rtop` is 1 and narrows it down by Brent's method;
//! [`Match::Curve`] makes `errf` least by parabolas and golden sections. Trial values are rounded to a tenth of the
//! tolerance, or finer.

mod error;
mod search;
#[cfg(test)]
mod tests;
mod trials;

pub use error::PackingError;
pub use trials::{Outcome, Trial};

use crate::compare::{Comparison, LeftOut};
use crate::scenario::{Match, Observer, PackingFile, RunError, prepare};
use search::Found;
use std::path::Path;
use trials::Laboratory;

/// Trials closer to the best than this share of the interval tell no slope: cycles scatter.
const SLOPE_WIDTH: f64 = 0.05;

/// Where the answer lies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Answer {
    /// Inside of the interval.
    Inside {
        /// The last interval, in which the exact value lies as far as the scatter of the runs allows.
        bracket: (f64, f64),
        /// Standard error from the scatter over cycles, where there are two or more and the force depends on the unknown.
        scatter: Option<f64>,
    },
    /// At the lower end of the interval, or below.
    LowerEnd,
    /// At the upper end of the interval, or above.
    UpperEnd,
    /// Not to be told: beyond the fold at both ends of the interval.
    Nowhere,
}

/// What became of a fit.
#[derive(Clone, Debug)]
pub struct PackingReport {
    /// Where the answer lies.
    pub answer: Answer,
    /// The trial that fits best, by its place among the trials; none when all were beyond the fold.
    pub best: Option<usize>,
    /// All trials in the order in which they were made.
    pub trials: Vec<Trial>,
}

impl PackingReport {
    /// The trial that fits best, beside the experiment.
    pub fn best(&self) -> Option<(&Trial, &Comparison)> {
        let trial = self.trials.get(self.best?)?;
        Some((trial, trial.comparison()?))
    }
}

/// Finds the number. Runs go into folders below `out`.
pub fn fit_packing(
    file: &PackingFile,
    out: &Path,
    threads: Option<usize>,
    observer: &mut dyn Observer,
) -> Result<PackingReport, PackingError> {
    let mut laboratory = Laboratory {
        file,
        out,
        threads,
        observer,
        trials: Vec::new(),
    };
    let interval = (file.unknown.from, file.unknown.to);
    // what is wrong at an end is told before the first long trial
    for end in [interval.0, interval.1] {
        let scenario = file.scenario_at(end).map_err(RunError::from)?;
        prepare(&scenario).map_err(RunError::from)?;
    }
    let mut misfit = |value: f64| {
        let trial = laboratory.trial(rounded(value, interval, file.tolerance))?;
        match trial.comparison() {
            Some(comparison) => misfit(comparison, file.matched).map_err(|LeftOut(reason)| PackingError::Metric {
                what: format!("{} = {}", file.unknown.key, file.unknown.plain(trial.value)),
                folder: trial.folder.clone(),
                reason,
            }),
            None => Ok(f64::INFINITY),
        }
    };
    let found = match file.matched {
        Match::Top => search::root(interval, file.tolerance, &mut misfit)?,
        Match::Curve => search::least(interval, file.tolerance, &mut misfit)?,
    };
    let trials = laboratory.trials;
    let best = best(&trials, file.matched);
    let answer = match found {
        Found::Inside {
            bracket: (low, high), ..
        } => Answer::Inside {
            bracket: (
                rounded(low, interval, file.tolerance),
                rounded(high, interval, file.tolerance),
            ),
            scatter: best.and_then(|best| scatter(&trials, best, file)),
        },
        Found::Lower => Answer::LowerEnd,
        Found::Upper => Answer::UpperEnd,
        Found::Nowhere => Answer::Nowhere,
    };
    Ok(PackingReport { answer, best, trials })
}

/// A value with as many digits as the tolerance needs; the ends as they were told.
fn rounded(value: f64, (from, to): (f64, f64), tolerance: f64) -> f64 {
    if value == from || value == to {
        return value;
    }
    let decimals = 1.0 - libm::floor(libm::log10(tolerance));
    let rounded = if decimals > 0.0 && decimals < 300.0 {
        format!("{value:.*}", decimals as usize).parse().unwrap_or(value)
    } else {
        let unit = libm::round(libm::exp10(-decimals));
        libm::round(value / unit) * unit
    };
    if rounded > from && rounded < to { rounded } else { value }
}

/// What is to become zero, or least.
fn misfit(comparison: &Comparison, matched: Match) -> Result<f64, LeftOut> {
    match matched {
        Match::Top => comparison.rtop.as_ref().map(|r| r.value - 1.0).map_err(Clone::clone),
        // the square is nearly a parabola
        Match::Curve => comparison
            .errf
            .as_ref()
            .map(|m| m.value * m.value)
            .map_err(Clone::clone),
    }
}

fn best(trials: &[Trial], matched: Match) -> Option<usize> {
    let misfit = |trial: &Trial| Some(misfit(trial.comparison()?, matched).ok()?.abs());
    let all = trials
        .iter()
        .enumerate()
        .filter_map(|(k, trial)| Some((k, misfit(trial)?)));
    all.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(k, _)| k)
}

/// Standard error of the unknown, from the standard errors `e` of the mean forces over cycles and the slopes `g` of the forces:
/// `sum |g| e / sum g^2`, the errors of all levels taken to go together.
fn scatter(trials: &[Trial], best: usize, file: &PackingFile) -> Option<f64> {
    let width = SLOPE_WIDTH * (file.unknown.to - file.unknown.from);
    let here = trials[best].comparison()?;
    let distance = |trial: &Trial| (trial.value - trials[best].value).abs();
    let others = || trials.iter().filter(|t| t.comparison().is_some() && distance(t) > 0.0);
    let by_distance = |a: &&Trial, b: &&Trial| distance(a).total_cmp(&distance(b));
    let other =
        (others().filter(|t| distance(t) >= width).min_by(by_distance)).or_else(|| others().max_by(by_distance))?;
    let there = other.comparison()?;
    let step = trials[best].value - other.value;
    if file.matched == Match::Top {
        let (a, b) = (here.rtop.as_ref().ok()?, there.rtop.as_ref().ok()?);
        let error = a.deviation? / (a.cycles as f64).sqrt();
        return Some((error * step / (a.value - b.value)).abs()).filter(|x| x.is_finite());
    }
    let (mut felt, mut slopes) = (0.0, 0.0);
    for pair in &here.pairs {
        let same = |other: &&crate::compare::Pair| other.phase == pair.phase && other.position == pair.position;
        let Some(other) = there.pairs.iter().find(same) else {
            continue;
        };
        let slope = (pair.run.value - other.run.value) / step;
        felt += slope.abs() * pair.run.error()?;
        slopes += slope * slope;
    }
    Some(felt / slopes).filter(|x| x.is_finite())
}
