//! What is in the series of a run.

use super::Info;
use crate::answer::Rows;
use crate::failure::Failure;
use crate::readable::{count, number};
use demeter::output::COLUMNS;
use serde_json::json;
use std::path::Path;

/// Rows, columns and span of a series.
pub struct Span {
    /// Titles of the columns.
    pub columns: Vec<String>,
    /// Number of rows.
    pub rows: u64,
    /// Time of the first and of the last row [s].
    pub times: Option<(f64, f64)>,
    /// Step of the last row.
    pub last_step: Option<u64>,
}

/// Whether a file starts like the series of a run.
pub fn looks_like_one(start: &[u8]) -> bool {
    start.starts_with(format!("{},{} [{}],", COLUMNS[0].name, COLUMNS[1].name, COLUMNS[1].unit).as_bytes())
}

/// Reads the span of a series, one row at a time. A last row that is not whole is left out.
pub fn span(path: &Path) -> Result<Span, Failure> {
    let fail = |error: csv::Error| refuse(path, &error);
    let mut reader = csv::ReaderBuilder::new().from_path(path).map_err(fail)?;
    let columns = reader.headers().map_err(fail)?.iter().map(str::to_owned).collect();
    let (mut rows, mut times, mut last_step) = (0, None, None);
    let mut row = csv::StringRecord::new();
    loop {
        match reader.read_record(&mut row) {
            Ok(false) => break,
            Ok(true) => {}
            Err(error) if is_short(&error) && !reader.read_record(&mut row).unwrap_or(true) => break,
            Err(error) => return Err(fail(error)),
        }
        rows += 1;
        last_step = row.get(0).and_then(|text| text.parse().ok());
        let time: Option<f64> = row.get(1).and_then(|text| text.parse().ok());
        if let Some(time) = time {
            times = Some((times.map_or(time, |(first, _)| first), time));
        }
    }
    Ok(Span {
        columns,
        rows,
        times,
        last_step,
    })
}

fn is_short(error: &csv::Error) -> bool {
    matches!(error.kind(), csv::ErrorKind::UnequalLengths { expected_len, len, .. } if len < expected_len)
}

/// Why a series cannot be read.
fn refuse(path: &Path, error: &csv::Error) -> Failure {
    let shown = path.display();
    let line = error.position().map_or(1, csv::Position::line);
    match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => Failure::wrong(format!(
            "`{shown}`, line {line}: the row has {len} cells, the header {expected_len}: the file is damaged. Put it back as \
             the run wrote it, or run the scenario again"
        )),
        csv::ErrorKind::Utf8 { .. } => Failure::wrong(format!(
            "`{shown}`, line {line}: this is no text (UTF-8): the file is damaged. Put it back as the run wrote it, or run the \
             scenario again"
        )),
        csv::ErrorKind::Io(error) => Failure::io(format!("cannot read `{shown}`: {error}")),
        _ => Failure::wrong(format!("`{shown}` is no series of a run: {error}")),
    }
}

/// Tells what is in a series.
pub fn series(path: &Path) -> Result<Info, Failure> {
    let span = span(path)?;
    let mut rows = Rows::default();
    rows.add("rows", count(span.rows));
    if let Some((first, last)) = span.times {
        rows.add("time", format!("{} s to {} s", number(first), number(last)));
    }
    rows.add("columns", span.columns.len().to_string());
    for column in &span.columns {
        rows.add("", column.as_str());
    }
    let value = json!({
        "rows": span.rows,
        "columns": span.columns,
        "start": span.times.map(|t| t.0),
        "end": span.times.map(|t| t.1),
    });
    Ok(Info {
        kind: "series of a run",
        rows,
        value,
    })
}
