//! `demeter compare`.

use crate::answer::{aligned, answer, answer_json};
use crate::arguments::CompareArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::plot::warn_of_shortfall;
use crate::readable::number;
use demeter::checkpoint::{Durability, write_atomically};
use demeter::compare::{
    CompareError, Comparison, ContactMisfit, LeftOut, Level, Mean, Metric, Phase, Position, Reading, Strokes,
    Thresholds, compare as compare_strokes, comparisons_to_json, read_measured, read_run, tells_strain,
};
use demeter::results::Run;
use demeter::scenario::units;
use demeter_physics::dimension::Dimension;
use std::path::{Path, PathBuf};

impl From<CompareError> for Failure {
    fn from(error: CompareError) -> Self {
        let message = error.to_string();
        match error.is_io() {
            true => Self::io(message),
            false => Self::wrong(message),
        }
    }
}

/// A run and how it compares.
struct Compared {
    strokes: Strokes,
    comparison: Comparison,
}

/// Compares runs with a run or with an experiment.
pub fn compare(arguments: &CompareArguments) -> Result<Exit, Failure> {
    let reading = Reading {
        load: arguments.load.clone(),
        unload: (!arguments.loading_only).then(|| arguments.unload.clone()),
        discard: arguments.discard,
        force: arguments.force.clone(),
        also: arguments.also.clone(),
        distribution: arguments.distribution.clone(),
    };
    let thresholds = Thresholds {
        run: force(arguments.threshold.as_deref(), "--threshold")?,
        reference: force(arguments.reference_threshold.as_deref(), "--reference-threshold")?.unwrap_or(0.0),
    };
    let reference = read_reference(arguments, &reading)?;
    let runs = std::iter::once(&arguments.reference).filter(|path| path.is_dir());
    for folder in runs.chain(&arguments.runs) {
        let run = Run::open(folder)?;
        if let Some(series) = run.series()? {
            warn_of_shortfall(&run, &series)?;
        }
    }
    let mut compared = Vec::new();
    for run in &arguments.runs {
        let strokes = read_run(run, &reading, Some(reference.position))?;
        let comparison = compare_strokes(&strokes, &reference, thresholds);
        compared.push(Compared { strokes, comparison });
    }
    if let Some(folder) = &arguments.out {
        write(folder, &compared, &reference, thresholds)?;
    }
    if arguments.json {
        let pairs: Vec<_> = compared.iter().map(|c| (&c.strokes, &c.comparison)).collect();
        answer_json(&comparisons_to_json(&pairs, &reference))?;
    } else {
        answer(&to_text(&compared, &reference, thresholds))?;
    }
    Ok(Exit::Finished)
}

/// The run or the measured curve that the others are compared with.
fn read_reference(arguments: &CompareArguments, reading: &Reading) -> Result<Strokes, Failure> {
    if !arguments.reference.exists() {
        return Err(Failure::wrong(format!(
            "--reference: there is no run and no file `{}`",
            arguments.reference.display()
        )));
    }
    if !arguments.reference.is_dir() {
        if arguments.reference_threshold.is_some() {
            return Err(Failure::wrong(format!(
                "--reference-threshold leaves out contacts of a run, and `{}` is no run: it tells no contacts one by one; leave the option out",
                arguments.reference.display()
            )));
        }
        return Ok(read_measured(&arguments.reference)?);
    }
    let mut strain = true;
    for run in arguments.runs.iter().chain([&arguments.reference]) {
        strain &= tells_strain(run)?;
    }
    let position = if strain { Position::Strain } else { Position::StageTime };
    Ok(read_run(&arguments.reference, reading, Some(position))?)
}

/// A force that is not negative [N].
fn force(text: Option<&str>, option: &str) -> Result<Option<f64>, Failure> {
    let Some(text) = text else {
        return Ok(None);
    };
    let refuse = |why: String| Failure::wrong(format!("{option} `{text}`: {why}; write a force, as \"4 mN\""));
    let quantity = units::parse(text).map_err(|error| refuse(error.to_string()))?;
    if quantity.dimension != Dimension::FORCE {
        return Err(refuse("this is no force".to_string()));
    }
    if quantity.value < 0.0 {
        return Err(refuse("a threshold must not be negative".to_string()));
    }
    Ok(Some(quantity.value))
}

/// A value and its standard deviation.
fn with_deviation(value: f64, deviation: Option<f64>) -> String {
    match deviation {
        Some(deviation) => format!("{} +- {}", number(value), number(deviation)),
        None => number(value),
    }
}

/// A metric in a table.
fn cell<T>(metric: &Metric<T>, text: impl Fn(&T) -> String) -> String {
    metric.as_ref().map_or_else(|_| "-".to_string(), text)
}

/// A force in millinewton.
fn millinewton(force: f64) -> String {
    format!("{} mN", number(1e3 * force))
}

fn to_text(compared: &[Compared], reference: &Strokes, thresholds: Thresholds) -> String {
    let mut titles = vec!["run", "cycles", "Rtop", "errf [N]", "errZ", "tau"];
    let at = thresholds.run.map(|tau| format!("errZ at {}", millinewton(tau)));
    titles.extend(at.as_deref());
    titles.push("bhat");
    let mut rows: Vec<Vec<String>> = vec![titles.into_iter().map(String::from).collect()];
    for Compared { strokes, comparison } in compared {
        let misfit = |m: &ContactMisfit| number(m.misfit.value);
        let mut row = vec![
            strokes.name.clone(),
            strokes.cycles.map_or(String::new(), |(kept, _)| kept.to_string()),
            cell(&comparison.rtop, |r| with_deviation(r.value, r.deviation)),
            cell(&comparison.errf, |m| number(m.value)),
            cell(&comparison.errz, misfit),
            cell(&comparison.errz, |m| millinewton(m.threshold)),
        ];
        row.extend(comparison.errz_at.as_ref().map(|metric| cell(metric, misfit)));
        row.push(cell(&comparison.bhat, |m| number(m.value)));
        rows.push(row);
    }
    let mut text = format!(
        "reference {}, by {}\n{}",
        reference.name,
        reference.position.name(),
        aligned(&rows)
    );
    for Compared { strokes, comparison } in compared {
        for (metric, LeftOut(reason)) in comparison.left_out() {
            text += &format!("{}: {metric} is left out: {reason}\n", strokes.name);
        }
        for remark in &comparison.remarks {
            text += &format!("{}: {remark}\n", strokes.name);
        }
    }
    text
}

/// Writes `metrics.csv`, and `cycles.csv` of every run into a folder of its name.
fn write(folder: &Path, compared: &[Compared], reference: &Strokes, thresholds: Thresholds) -> Result<(), Failure> {
    let mut rows = vec![metrics_titles(thresholds)];
    rows.extend(compared.iter().map(|c| metrics_row(c, thresholds)));
    write_csv(&folder.join("metrics.csv"), &rows)?;
    let mut taken: Vec<String> = Vec::new();
    for Compared { strokes, comparison } in compared {
        let tau = comparison.errz.as_ref().ok().map(|m| m.threshold);
        let place = folder.join(free_name(&strokes.name, &mut taken));
        write_csv(&place.join("cycles.csv"), &cycles_rows(strokes, [tau, thresholds.run]))?;
    }
    if reference.cycles.is_some() {
        let place = folder.join(free_name(&reference.name, &mut taken));
        let threshold = Some(thresholds.reference).filter(|t| *t > 0.0);
        write_csv(&place.join("cycles.csv"), &cycles_rows(reference, [threshold, None]))?;
    }
    Ok(())
}

/// The name of a run folder, made different from those before it.
fn free_name(run: &str, taken: &mut Vec<String>) -> String {
    let path = std::fs::canonicalize(run).unwrap_or_else(|_| PathBuf::from(run));
    let stem = path
        .file_name()
        .map_or_else(|| "run".to_string(), |n| n.to_string_lossy().into_owned());
    let mut name = stem.clone();
    let mut number = 1;
    while taken.contains(&name) {
        number += 1;
        name = format!("{stem}-{number}");
    }
    taken.push(name.clone());
    name
}

fn metrics_titles(thresholds: Thresholds) -> Vec<String> {
    let mut titles = vec![
        "run",
        "cycles",
        "discarded",
        "Rtop",
        "Rtop deviation",
        "errf [N]",
        "errZ",
        "tau [N]",
    ];
    if thresholds.run.is_some() {
        titles.extend(["errZ at threshold", "threshold [N]"]);
    }
    titles.extend(["bhat", "levels", "left out"]);
    titles.into_iter().map(String::from).collect()
}

/// A number that reads back to the same bits, or an empty cell.
fn told(value: Option<f64>) -> String {
    value.map_or(String::new(), |x| format!("{x:?}"))
}

fn metrics_row(compared: &Compared, thresholds: Thresholds) -> Vec<String> {
    let Compared { strokes, comparison } = compared;
    let count = |n: Option<usize>| n.map_or(String::new(), |n| n.to_string());
    let rtop = comparison.rtop.as_ref().ok();
    let (errf, errz) = (comparison.errf.as_ref().ok(), comparison.errz.as_ref().ok());
    let mut row = vec![
        strokes.name.clone(),
        count(strokes.cycles.map(|c| c.0)),
        count(strokes.cycles.map(|c| c.1)),
        told(rtop.map(|r| r.value)),
        told(rtop.and_then(|r| r.deviation)),
        told(errf.map(|m| m.value)),
        told(errz.map(|m| m.misfit.value)),
        told(errz.map(|m| m.threshold)),
    ];
    if thresholds.run.is_some() {
        let at = comparison.errz_at.as_ref().and_then(|m| m.as_ref().ok());
        row.extend([told(at.map(|m| m.misfit.value)), told(thresholds.run)]);
    }
    let reasons = comparison
        .left_out()
        .into_iter()
        .map(|(name, LeftOut(why))| format!("{name}: {why}"));
    row.extend([
        told(comparison.bhat.as_ref().ok().map(|m| m.value)),
        count(errf.map(|m| m.levels)),
        reasons.collect::<Vec<_>>().join("; "),
    ]);
    row
}

/// Levels of both phases, loading first; `Z` without a threshold and above others.
fn cycles_rows(strokes: &Strokes, thresholds: [Option<f64>; 2]) -> Vec<Vec<String>> {
    let mut above: Vec<f64> = thresholds.into_iter().flatten().collect();
    above.dedup();
    let mut titles: Vec<String> = [
        "phase",
        strokes.position.title(),
        "cycles",
        "force [N]",
        "force deviation [N]",
    ]
    .map(String::from)
    .to_vec();
    titles.push("contacts per grain".to_string());
    titles.extend(above.iter().map(|tau| format!("contacts per grain above {tau} N")));
    for title in &strokes.also {
        let deviation = match title.split_once(" [") {
            Some((name, unit)) => format!("{name} deviation [{unit}"),
            None => format!("{title} deviation"),
        };
        titles.extend([title.clone(), deviation]);
    }
    let mut rows = vec![titles];
    for phase in Phase::ALL {
        rows.extend(
            strokes
                .levels(phase)
                .iter()
                .map(|level| level_row(strokes, phase, level, &above)),
        );
    }
    rows
}

fn level_row(strokes: &Strokes, phase: Phase, level: &Level, above: &[f64]) -> Vec<String> {
    let z = |tau: f64| match (&level.contacts, &strokes.bins) {
        (Some(contacts), Some(bins)) => contacts.coordination(bins, tau),
        _ => None,
    };
    let both = |mean: &Mean| [told(Some(mean.value)), told(mean.deviation)];
    let mut row = vec![
        phase.name().to_string(),
        told(Some(level.position)),
        level.force.map_or(String::new(), |f| f.cycles.to_string()),
    ];
    row.extend(level.force.as_ref().map_or([String::new(), String::new()], both));
    row.push(told(z(0.0)));
    row.extend(above.iter().map(|tau| told(z(*tau))));
    row.extend(level.also.iter().flat_map(both));
    row
}

/// Writes a table; the folders above it are made.
fn write_csv(path: &Path, rows: &[Vec<String>]) -> Result<(), Failure> {
    let fail = |error: &dyn std::fmt::Display| Failure::io(format!("cannot write `{}`: {error}", path.display()));
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.write_record(row).map_err(|error| fail(&error))?;
    }
    let bytes = writer.into_inner().map_err(|error| fail(&error))?;
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|error| fail(&error))?;
    }
    write_atomically(path, &bytes, Durability::Kill).map_err(|error| fail(&error))
}
