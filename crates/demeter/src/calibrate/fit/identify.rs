//! What observations fix of the parameters, and what else would have to be measured.

use super::least_squares::slopes;
use super::model::{Model, Scene, adheres};
use super::singular::{NOTHING, dot, reduced, singular};
use crate::scenario::{Measured, Observable, Observation, StandardError, Unknown};

/// A direction is not felt when no observation changes by more than this share while a parameter changes by a factor e.
const UNFELT: f64 = 1e-5;

/// A product of powers of parameters that the observations fix.
#[derive(Clone, Debug, PartialEq)]
pub struct Combination {
    /// Parameters and their powers.
    pub powers: Vec<(String, f64)>,
    /// Its value in SI.
    pub value: f64,
}

/// A measurement that would fix what is open.
#[derive(Clone, Debug, PartialEq)]
pub struct Advice {
    /// What to measure.
    pub observable: Observable,
    /// At which impact speed [m/s], where there is one.
    pub velocity: Option<f64>,
    /// Relative change of it while the open parameters change by a factor e.
    pub sensitivity: f64,
}

/// What the slopes tell.
#[derive(Clone, Debug)]
pub(super) struct Identified {
    pub singular_values: Vec<f64>,
    /// Directions that are felt, and those that are not.
    felt: Vec<Vec<f64>>,
    unfelt: Vec<Vec<f64>>,
    /// Relative errors of the parameters that are identified.
    pub errors: Vec<Option<f64>>,
}

/// Slopes at a point, taken apart; nothing when the law has no answer beside it.
pub(super) fn identify(
    model: &Model<'_>,
    point: &[f64],
    bounds: &[(f64, f64)],
    measured: &[Measured],
) -> Option<Identified> {
    let values = |point: &[f64]| model.logarithms(&super::from_logarithms(point)).ok();
    let rows = slopes(values, point, bounds)?;
    let taken = singular(&rows, point.len());
    let rank = taken.values.iter().filter(|s| **s > UNFELT).count();
    let (felt, unfelt) = taken.directions.split_at(rank);
    let mut seen = Identified {
        singular_values: taken.values.clone(),
        felt: felt.to_vec(),
        unfelt: unfelt.to_vec(),
        errors: Vec::new(),
    };
    let weights = values(point)?
        .into_iter()
        .zip(measured)
        .map(|(shown, m)| m.weight(shown));
    let weighted: Vec<Vec<f64>> = (rows.iter().zip(weights))
        .map(|(row, weight)| row.iter().map(|x| x * weight).collect())
        .collect();
    let weighted = singular(&weighted, point.len());
    let variance = |k: usize| {
        let directions = weighted.values.iter().zip(&weighted.directions).take(rank);
        directions.map(|(s, d)| (d[k] / s) * (d[k] / s)).sum::<f64>()
    };
    let error = |k: usize| seen.is_identified(k).then(|| variance(k).sqrt());
    seen.errors = (0..point.len()).map(error).collect();
    Some(seen)
}

impl Identified {
    /// Whether the observations fix this parameter.
    pub fn is_identified(&self, parameter: usize) -> bool {
        self.unfelt.iter().all(|direction| direction[parameter].abs() < NOTHING)
    }

    /// Whether two points differ by more than a percent where the observations should fix everything. Where they do
    /// not, the points of a curved valley differ in every direction, which tells nothing new.
    pub fn differ(&self, a: &[f64], b: &[f64]) -> bool {
        if !self.unfelt.is_empty() {
            return false;
        }
        let step: Vec<f64> = a.iter().zip(b).map(|(x, y)| x - y).collect();
        self.felt.iter().any(|direction| dot(direction, &step).abs() > 0.01)
    }

    /// The products of powers that are fixed.
    pub fn combinations(&self, unknown: &[Unknown], values: &[f64]) -> Vec<Combination> {
        let rows = reduced(self.felt.clone(), unknown.len());
        let combination = |row: &Vec<f64>| Combination {
            powers: (unknown.iter().zip(row))
                .filter(|(_, power)| **power != 0.0)
                .map(|(u, power)| (u.name.clone(), *power))
                .collect(),
            value: libm::exp(row.iter().zip(values).map(|(p, v)| p * libm::log(*v)).sum()),
        };
        rows.iter().map(combination).collect()
    }
}

/// Impact speeds at which a measurement is thought of, over those that were measured.
const FACTORS: [f64; 3] = [1.0, 10.0, 0.1];
/// Impact speed where none was measured [m/s].
const SOME_SPEED: f64 = 1.0;
/// A later measurement must be so much better to be preferred.
const BETTER: f64 = 2.0;

/// Measurements that together fix what is open, each the one that feels most of what is left.
pub(super) fn advice(model: &Model<'_>, point: &[f64], bounds: &[(f64, f64)], seen: &Identified) -> Vec<Advice> {
    if seen.unfelt.is_empty() {
        return Vec::new();
    }
    let candidates: Vec<(Advice, Vec<f64>)> = (candidates(model).into_iter())
        .filter_map(|(observation, advice)| {
            let slope = slopes_of(model, point, bounds, &observation, advice.observable)?;
            Some((advice, slope))
        })
        .collect();
    let mut open = seen.unfelt.clone();
    let mut chosen = Vec::new();
    while !open.is_empty() {
        let strength = |slope: &[f64]| open.iter().map(|d| dot(d, slope)).map(|x| x * x).sum::<f64>().sqrt();
        let mut best: Option<(&Advice, &[f64], f64)> = None;
        for (advice, slope) in &candidates {
            let strength = strength(slope);
            if strength > NOTHING && best.is_none_or(|(_, _, least)| strength > BETTER * least) {
                best = Some((advice, slope, strength));
            }
        }
        let Some((advice, slope, sensitivity)) = best else {
            break;
        };
        chosen.push(Advice {
            sensitivity,
            ..advice.clone()
        });
        open = left_open(&open, slope);
    }
    chosen
}

/// What stays open of a space of directions when one more slope is known.
fn left_open(open: &[Vec<f64>], slope: &[f64]) -> Vec<Vec<f64>> {
    let row: Vec<f64> = open.iter().map(|d| dot(d, slope)).collect();
    let taken = singular(&[row], open.len());
    let combine = |weights: &Vec<f64>| -> Vec<f64> {
        (0..slope.len())
            .map(|k| weights.iter().zip(open).map(|(w, d)| w * d[k]).sum())
            .collect()
    };
    taken.directions.iter().skip(1).map(combine).collect()
}

/// What could be measured of the bodies that were looked at first.
fn candidates(model: &Model<'_>) -> Vec<(Observation, Advice)> {
    let Some(first) = model.file.observations.first() else {
        return Vec::new();
    };
    let speeds = model.file.observations.iter().filter_map(|o| o.velocity);
    let mut speeds: Vec<f64> = speeds.take(1).collect();
    if speeds.is_empty() {
        speeds.push(SOME_SPEED);
    }
    let mut all = Vec::new();
    let mut add = |observable: Observable, velocity: Option<f64>| {
        let observation = Observation {
            velocity,
            preload: None,
            measured: vec![Measured {
                observable,
                value: 1.0,
                error: StandardError::Relative(1.0),
            }],
            ..first.clone()
        };
        let advice = Advice {
            observable,
            velocity,
            sensitivity: 0.0,
        };
        all.push((observation, advice));
    };
    for factor in FACTORS {
        for &speed in &speeds {
            for observable in Observable::ALL.into_iter().filter(|o| o.of_impact()) {
                add(observable, Some(factor * speed));
            }
        }
        if factor == 1.0 {
            add(Observable::PullOffForce, None);
            add(Observable::StickingVelocity, None);
        }
    }
    all
}

/// Slope of the logarithm of a measurement that was not made.
fn slopes_of(
    model: &Model<'_>,
    point: &[f64],
    bounds: &[(f64, f64)],
    observation: &Observation,
    observable: Observable,
) -> Option<Vec<f64>> {
    let value = |point: &[f64]| -> Option<Vec<f64>> {
        let law = model.law(&super::from_logarithms(point)).ok()?;
        if !observable.of_impact() && !adheres(&law, observation) {
            return None;
        }
        let seen = Scene::new(model, &law, observation).ok()?.observe(observable).ok()?;
        (seen > 0.0 && seen.is_finite()).then(|| vec![libm::log(seen)])
    };
    slopes(value, point, bounds)?
        .pop()
        .filter(|slope| slope.iter().all(|x| x.is_finite()))
}
