//! The report of a run: `report.html`, one file that needs nothing else and no network.
//!
//! It is written from what the run left in its folder, at the end of every run and by `demeter report`: how it ended, its
//! parameters, the series and profiles as plots, the energy ledger, distributions of the last state, walls, and the last state in 3D.
//! Texts of the scenario are not trusted: they are escaped, and a Content-Security-Policy in the page allows no script but
//! its own, whose hash it tells, and no connection at all. What is too much for a page is thinned, and the page says so.

mod arrays;
mod distributions;
mod error;
mod figures;
mod html;
mod ledger;
mod outcome;
mod packing;
mod page;
mod parameters;
mod plots;
mod profiles;
mod series;
mod thin;

pub use error::ReportError;

use crate::results::{Columns, Packing, ResultsError, Run};
use outcome::Outcome;
use parameters::Parameters;
use profiles::Profile;
use std::fmt::Display;
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

/// Longest log that is shown: its last bytes.
const LONGEST_LOG: u64 = 100_000;
/// Longest scenario that is shown [bytes].
const LONGEST_SCENARIO: usize = 500_000;

/// A report that was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The page.
    pub path: PathBuf,
    /// What of the folder could not be read; the page says so, too.
    pub problems: Vec<String>,
}

/// Writes the report of the run in a folder, whole or not at all. Whether the run still goes on is asked of its lock.
///
/// Only a folder that is no run and a page that cannot be written are errors. What is missing or damaged in the folder is
/// left out and told.
pub fn write(folder: &Path) -> Result<Written, ReportError> {
    let run = Run::open(folder)?;
    let going_on = run.is_going_on();
    write_page(&run, going_on)
}

/// As [`write()`], at the end of a run by the process that holds its lock.
pub fn write_at_the_end(folder: &Path) -> Result<Written, ReportError> {
    write_page(&Run::open(folder)?, false)
}

fn write_page(run: &Run, going_on: bool) -> Result<Written, ReportError> {
    let contents = Contents::read(run, going_on);
    let path = run.folder().report();
    run.folder().write(&path, page::page(&contents).as_bytes())?;
    Ok(Written {
        path,
        problems: contents.problems,
    })
}

/// What the folder of a run holds, as far as it can be read.
struct Contents {
    /// Name of the folder.
    name: String,
    outcome: Outcome,
    series: Option<Columns>,
    packing: Option<Packing>,
    parameters: Option<Parameters>,
    profiles: Vec<Profile>,
    scenario: String,
    log: String,
    problems: Vec<String>,
}

impl Contents {
    fn read(run: &Run, going_on: bool) -> Self {
        let mut problems = Vec::new();
        let series = kept(run.series(), &mut problems);
        let short = series
            .as_ref()
            .and_then(|series| kept(run.shortfall(series), &mut problems));
        problems.extend(short.map(|problem| format!("`series.csv`: {problem}")));
        for gone in [run.missing_series(), run.missing_frames()] {
            let gone = kept(gone, &mut problems);
            problems.extend(gone);
        }
        let packing = kept(Packing::latest(run), &mut problems);
        let summary = kept(run.summary(), &mut problems);
        let log = kept(log(run), &mut problems).unwrap_or_default();
        let mut scenario = kept(run.scenario(), &mut problems).unwrap_or_default();
        let parameters = match Parameters::read(&scenario) {
            Ok(parameters) => Some(parameters),
            Err(reason) => {
                problems.push(format!("the scenario in the folder cannot be read: {reason}"));
                None
            }
        };
        let names = parameters.as_ref().map(Parameters::profiles).unwrap_or_default();
        let drawn = names.iter().take(profiles::MOST);
        let profiles = drawn
            .filter_map(|name| kept(profile(run, name), &mut problems))
            .collect();
        if scenario.len() > LONGEST_SCENARIO {
            let end = (0..=LONGEST_SCENARIO).rev().find(|k| scenario.is_char_boundary(*k));
            scenario.truncate(end.unwrap_or(0));
            scenario.push_str("\n… scenario.toml holds the rest");
        }
        let last_step = series.as_ref().and_then(|series| series::last(series, "step"));
        let root = run.folder().root();
        let name = root.canonicalize().unwrap_or_else(|_| root.to_owned());
        Self {
            name: name
                .file_name()
                .map_or_else(String::new, |name| name.to_string_lossy().into_owned()),
            outcome: Outcome::new(summary, &log, going_on, last_step),
            series,
            packing,
            parameters,
            profiles,
            scenario,
            log,
            problems,
        }
    }

    /// The title of the run; the name of its folder where it has none.
    fn title(&self) -> &str {
        let of_scenario = || self.parameters.as_ref().and_then(Parameters::title);
        self.outcome.text("title").or_else(of_scenario).unwrap_or(&self.name)
    }
}

/// What could be read; what could not is told.
fn kept<T>(read: Result<Option<T>, impl Display>, problems: &mut Vec<String>) -> Option<T> {
    read.unwrap_or_else(|error| {
        problems.push(error.to_string());
        None
    })
}

/// A profile that the run has written.
fn profile(run: &Run, name: &str) -> Result<Option<Profile>, ResultsError> {
    let path = run.folder().profile(name);
    let Some(file) = run.file(&path)? else {
        return Ok(None);
    };
    Columns::from_file(&path, file).map(|table| Some(Profile::new(name, &table)))
}

/// The log, or its end.
fn log(run: &Run) -> Result<Option<String>, ResultsError> {
    let path = run.folder().log();
    let Some(mut file) = run.file(&path)? else {
        return Ok(None);
    };
    let mut bytes = Vec::new();
    let mut read = |file: &mut std::fs::File| {
        let start = file.metadata()?.len().saturating_sub(LONGEST_LOG);
        file.seek(SeekFrom::Start(start))?;
        file.take(LONGEST_LOG).read_to_end(&mut bytes)
    };
    read(&mut file).map_err(ResultsError::io(&path))?;
    Ok(Some(String::from_utf8_lossy(&bytes).into_owned()))
}
