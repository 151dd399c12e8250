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
}

/// Whether a file starts like the series of a run.
pub fn looks_like_one(start: &[u8]) -> bool {
    start.starts_with(format!("{},{} [{}],", COLUMNS[0].name, COLUMNS[1].name, COLUMNS[1].unit).as_bytes())
}

/// Reads the span of a series, one row at a time.
pub fn span(path: &Path) -> Result<Span, Failure> {
    let fail = |error: csv::Error| Failure::io(format!("cannot read `{}`: {error}", path.display()));
    let mut reader = csv::ReaderBuilder::new().from_path(path).map_err(fail)?;
    let columns = reader.headers().map_err(fail)?.iter().map(str::to_owned).collect();
    let (mut rows, mut times) = (0, None);
    let mut row = csv::StringRecord::new();
    while reader.read_record(&mut row).map_err(fail)? {
        rows += 1;
        let time: Option<f64> = row.get(1).and_then(|text| text.parse().ok());
        if let Some(time) = time {
            times = Some((times.map_or(time, |(first, _)| first), time));
        }
    }
    Ok(Span { columns, rows, times })
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
