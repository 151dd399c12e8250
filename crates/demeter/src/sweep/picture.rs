//! A result of all runs against a varied key.

use super::average::{groups, mean};
use super::error::SweepError;
use super::folder::SweepFolder;
use super::gather::Results;
use crate::output::{AxisSpec, Look, Plot, Series};
use crate::results::{column_name, nearest};
use std::collections::BTreeMap;

/// Most lines that are told apart in a legend.
const MOST_NAMED: usize = 12;

/// Draws a result, told by its title, against a key: a circle for every run, and a line through the means for every
/// combination of the other keys.
pub fn plot(folder: &SweepFolder, results: &Results, result: &str) -> Result<Plot, SweepError> {
    let plan = &folder.plan;
    let y = column(results, result)?;
    let x = axis_column(folder, results)?;
    let key = x - results.varied.start;
    let seed = plan.column("seed").filter(|seed| *seed != key);
    let mut lines: BTreeMap<usize, (String, Vec<(f64, f64)>)> = BTreeMap::new();
    let mut known: Vec<String> = Vec::new();
    let short = plan.short_keys();
    for (index, row) in results.rows.iter().enumerate() {
        let (Some(at), Some(value)) = (row[x].number(), row[y].number()) else {
            continue;
        };
        let others = (plan.runs[index].values.iter().enumerate()).filter(|(k, _)| *k != key && Some(*k) != seed);
        let name: Vec<String> = others.map(|(k, value)| format!("{} = {value}", short[k])).collect();
        let name = name.join(", ");
        let line = known.iter().position(|known| *known == name).unwrap_or_else(|| {
            known.push(name.clone());
            known.len() - 1
        });
        lines
            .entry(line)
            .or_insert_with(|| (name, Vec::new()))
            .1
            .push((at, value));
    }
    let named = lines.len() <= MOST_NAMED;
    let mut series = Vec::new();
    for (line, (name, points)) in lines {
        let name = if named { name } else { String::new() };
        series.push(Series::line(name, means(&points)).with(Look::Line, line));
        series.push(Series::line("", points).with(Look::Circles, line));
    }
    let seeds = seed.map_or(1, |seed| groups(folder, seed).iter().map(Vec::len).max().unwrap_or(1));
    let title = match seeds {
        1 => results.titles[y].clone(),
        count => format!("{}, means of {count} seeds", column_name(&results.titles[y])),
    };
    Ok(Plot {
        title,
        x_label: results.titles[x].clone(),
        y_label: results.titles[y].clone(),
        x: AxisSpec {
            logarithmic: plan.columns[key].logarithmic,
            range: None,
        },
        y: AxisSpec::default(),
        series,
    })
}

/// The mean of all points at one place, from left to right.
fn means(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let groups = sorted.chunk_by(|a, b| a.0 == b.0);
    groups
        .filter_map(|group| {
            let values: Vec<f64> = group.iter().map(|point| point.1).collect();
            Some((group[0].0, mean(&values)?))
        })
        .collect()
}

/// The column against which results are drawn.
pub(super) fn axis_column(folder: &SweepFolder, results: &Results) -> Result<usize, SweepError> {
    match &folder.wishes.against {
        Some(key) => key_column(folder, results, key),
        None => first_numbers(results).ok_or_else(|| {
            SweepError::told("nothing can be drawn against the varied keys: none of them has numbers of one unit")
        }),
    }
}

fn first_numbers(results: &Results) -> Option<usize> {
    let is_number = |k: &usize| results.rows.iter().all(|row| row[*k].number().is_some());
    let is_seed = |k: &usize| results.titles[*k] == "seed";
    let numbers = || results.varied.clone().filter(is_number);
    numbers().find(|k| !is_seed(k)).or_else(|| numbers().next())
}

fn column(results: &Results, name: &str) -> Result<usize, SweepError> {
    results.find(name).ok_or_else(|| {
        let known = results.titles[results.varied.end..]
            .iter()
            .map(|title| column_name(title));
        let help = nearest(name, known);
        SweepError::told(format!("there is no result `{name}`; {help}"))
    })
}

fn key_column(folder: &SweepFolder, results: &Results, key: &str) -> Result<usize, SweepError> {
    let at = folder
        .plan
        .column(key)
        .map(|k| results.varied.start + k)
        .ok_or_else(|| {
            let keys: Vec<String> = folder
                .plan
                .columns
                .iter()
                .map(|column| format!("`{}`", column.key))
                .collect();
            SweepError::told(format!("`{key}` is not varied; varied are {}", keys.join(", ")))
        })?;
    match results.rows.iter().all(|row| row[at].number().is_some()) {
        true => Ok(at),
        false => Err(SweepError::told(format!(
            "nothing can be drawn against `{key}`: its values are words, or have different units"
        ))),
    }
}
