//! `demeter fit` of a file that tells a packing.

use crate::answer::{Rows, answer, answer_json};
use crate::arguments::FitArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::progress::Watch;
use crate::readable::{number, things};
use demeter::calibrate::packing::{Answer, Outcome, PackingError, PackingReport, Trial, fit_packing as find};
use demeter::compare::{Comparison, LeftOut};
use demeter::scenario::{Match, PackingFile, UnknownNumber};
use std::path::{Path, PathBuf};

impl From<PackingError> for Failure {
    fn from(error: PackingError) -> Self {
        let exit = match error {
            PackingError::Run(error) => return error.into(),
            PackingError::Compare(error) => return error.into(),
            PackingError::Fault { .. } => Exit::Fault,
            PackingError::Interrupted { .. } => Exit::Interrupted,
            PackingError::Metric { .. } | PackingError::NoPlace { .. } => Exit::Wrong,
        };
        let message = error.to_string();
        Self::Other { exit, message }
    }
}

/// Finds a number of a scenario.
pub fn fit_packing(file: &PackingFile, arguments: &FitArguments) -> Result<Exit, Failure> {
    let out = arguments.out.clone().unwrap_or_else(|| default_folder(&arguments.file));
    let mut watch = Watch::new(Interrupt::listen());
    let report = find(file, &out, arguments.output.threads.map(usize::from), &mut watch);
    watch.end();
    let report = report?;
    if arguments.output.json {
        answer_json(&report.to_json(file))?;
    } else {
        answer(&to_text(file, &report))?;
    }
    Ok(match report.answer {
        Answer::Inside { .. } => Exit::Finished,
        _ => Exit::Fault,
    })
}

/// `runs/fit-NAME`.
fn default_folder(file: &Path) -> PathBuf {
    let stem = file
        .file_stem()
        .map_or_else(|| "packing".into(), |stem| stem.to_string_lossy());
    Path::new("runs").join(format!("fit-{stem}"))
}

/// A value with four digits and its unit.
fn short(unknown: &UnknownNumber, value: f64) -> String {
    format!("{} {}", number(value), unknown.dimension.unit())
        .trim_end()
        .to_string()
}

/// The metrics of a trial.
fn metrics(comparison: &Comparison) -> String {
    let rtop = match &comparison.rtop {
        Ok(rtop) => match rtop.deviation {
            Some(deviation) => format!("Rtop {} +- {}", number(rtop.value), number(deviation)),
            None => format!("Rtop {}", number(rtop.value)),
        },
        Err(LeftOut(reason)) => format!("no Rtop ({reason})"),
    };
    let errf = match &comparison.errf {
        Ok(misfit) => format!(
            "errf {} N over {}",
            number(misfit.value),
            things(misfit.levels as u64, "level")
        ),
        Err(LeftOut(reason)) => format!("no errf ({reason})"),
    };
    format!("{rtop}, {errf}")
}

fn trial_text(trial: &Trial) -> String {
    let used = if trial.reused { ", was there" } else { "" };
    let outcome = match &trial.outcome {
        Outcome::Compared(comparison) => metrics(comparison),
        Outcome::BeyondFold(_) => "beyond the fold of the multi-contact equation".to_string(),
    };
    format!("{outcome}   ({}{used})", trial.folder.display())
}

fn to_text(file: &PackingFile, report: &PackingReport) -> String {
    let unknown = &file.unknown;
    let sought = match file.matched {
        Match::Top => "the force at the largest compression is the measured one (Rtop = 1)",
        Match::Curve => "the forces differ least from the measured ones (errf)",
    };
    let end = |which: &str, value: f64, beyond: &str| {
        format!(
            "NOT found: between {} and {}, {} fits best at the {which} end of the interval, {}, or {beyond} it\n\
             look in another interval (`from`, `to`)\n",
            short(unknown, unknown.from),
            short(unknown, unknown.to),
            unknown.key,
            short(unknown, value)
        )
    };
    let mut text = match (report.answer, report.best()) {
        (Answer::Inside { bracket, scatter }, Some((trial, _))) => {
            let width = 0.5 * (bracket.1 - bracket.0);
            let from = format!("{} .. {}", short(unknown, bracket.0), short(unknown, bracket.1));
            let mut text = format!("{} = {}: {sought}\n", unknown.key, unknown.plain(trial.value));
            let mut rows = Rows::default();
            rows.add("last interval", format!("+- {}, {from}", short(unknown, width)));
            rows.add(
                "scatter over cycles",
                match scatter {
                    Some(error) => format!("+- {}", short(unknown, error)),
                    None => "not known: fewer than two cycles, or no slope".to_string(),
                },
            );
            text += &rows.lines();
            text
        }
        (Answer::UpperEnd, _) => end("upper", unknown.to, "above"),
        (Answer::Nowhere, _) => format!(
            "NOT found: at {} and at {} {} lies beyond the fold of the multi-contact equation\n\
             look in another interval (`from`, `to`): smaller prefactors, stiffer grains\n",
            short(unknown, unknown.from),
            short(unknown, unknown.to),
            unknown.key
        ),
        (Answer::LowerEnd, _) | (Answer::Inside { .. }, None) => end("lower", unknown.from, "below"),
    };
    text += "trials\n";
    let mut rows = Rows::default();
    for trial in &report.trials {
        rows.add(unknown.plain(trial.value), trial_text(trial));
    }
    text += &rows.lines();
    if let Some((trial, comparison)) = report.best() {
        for remark in &comparison.remarks {
            text += &format!("at {}: {remark}\n", unknown.plain(trial.value));
        }
        if matches!(report.answer, Answer::Inside { .. }) {
            let set = format!("{}={}", unknown.key, unknown.written(trial.value));
            text += &format!("for a run\n  --set '{set}'\n");
        }
    }
    text
}
