//! Means over the seeds of every combination.

use super::folder::SweepFolder;
use super::gather::{Results, ResultsCell};
use crate::results::column_name;

/// The runs that differ in their seed alone, put together: means of all results, and their standard deviations. Nothing
/// where no seed is varied.
pub fn averages(folder: &SweepFolder, results: &Results) -> Option<Results> {
    let seed = folder.plan.column("seed")?;
    let keys: Vec<usize> = results
        .varied
        .clone()
        .filter(|k| k - results.varied.start != seed)
        .collect();
    let measured: Vec<usize> = (results.varied.end..results.titles.len())
        .filter(|&k| results.rows.iter().any(|row| row[k].number().is_some()))
        .collect();
    let mut titles: Vec<String> = keys.iter().map(|&k| results.titles[k].clone()).collect();
    titles.push("finished runs".to_string());
    let mut asked = Vec::new();
    for &k in &measured {
        if results.asked.contains(&k) {
            asked.push(titles.len());
        }
        titles.push(results.titles[k].clone());
        titles.push(deviation_title(&results.titles[k]));
    }
    let rows = groups(folder, seed).into_iter().map(|group| {
        let first = &results.rows[group[0]];
        let mut row: Vec<ResultsCell> = keys.iter().map(|&k| first[k].clone()).collect();
        let counted = group
            .iter()
            .filter(|&&run| measured.iter().any(|&k| results.rows[run][k].number().is_some()));
        row.push(ResultsCell::Number(counted.count() as f64));
        for &k in &measured {
            let values: Vec<f64> = group.iter().filter_map(|&run| results.rows[run][k].number()).collect();
            let (mean, deviation) = mean_and_deviation(&values);
            row.push(mean.map_or(ResultsCell::Empty, ResultsCell::Number));
            row.push(deviation.map_or(ResultsCell::Empty, ResultsCell::Number));
        }
        row
    });
    Some(Results {
        rows: rows.collect(),
        varied: 0..keys.len(),
        titles,
        asked,
        ..Results::default()
    })
}

/// The runs of every combination of all keys but the seed, in the order of their first runs.
pub fn groups(folder: &SweepFolder, seed: usize) -> Vec<Vec<usize>> {
    let mut found: Vec<(Vec<&String>, Vec<usize>)> = Vec::new();
    let mut places = std::collections::HashMap::new();
    for (index, run) in folder.plan.runs.iter().enumerate() {
        let others: Vec<&String> = (run.values.iter().enumerate())
            .filter(|(k, _)| *k != seed)
            .map(|(_, value)| value)
            .collect();
        let at = *places.entry(others.clone()).or_insert(found.len());
        if at == found.len() {
            found.push((others, Vec::new()));
        }
        found[at].1.push(index);
    }
    found.into_iter().map(|(_, runs)| runs).collect()
}

/// The mean, counted from the first value, so that equal values have that one as their mean and no deviation.
pub(super) fn mean(values: &[f64]) -> Option<f64> {
    let first = *values.first()?;
    let beyond = values.iter().map(|value| value - first).sum::<f64>() / values.len() as f64;
    Some(first + beyond)
}

/// The mean, and the standard deviation of a sample of more than one.
fn mean_and_deviation(values: &[f64]) -> (Option<f64>, Option<f64>) {
    let Some(mean) = mean(values) else {
        return (None, None);
    };
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    let deviation = (values.len() > 1).then(|| (squares / (values.len() - 1) as f64).sqrt());
    (Some(mean), deviation)
}

fn deviation_title(title: &str) -> String {
    let name = column_name(title);
    format!("{name} deviation{}", &title[name.len()..])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_values_have_no_deviation() {
        for value in [0.1, 1e-3 / 3.0, -7.3e12, 0.0] {
            for count in 2..12 {
                let values = vec![value; count];
                assert_eq!(mean_and_deviation(&values), (Some(value), Some(0.0)), "{count}");
            }
        }
        assert_eq!(mean_and_deviation(&[1.0, 3.0]), (Some(2.0), Some(2f64.sqrt())));
        assert_eq!(
            (mean_and_deviation(&[5.0]), mean_and_deviation(&[])),
            ((Some(5.0), None), (None, None))
        );
    }
}
