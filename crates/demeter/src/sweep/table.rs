//! A design of experiments: a CSV file with a column for every key and a row for every run.

use super::design::Axis;
use super::plan::MAX_RUNS;
use crate::scenario::units;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Largest file that is read [bytes].
const MAX_SIZE: u64 = 64 << 20;
/// Most columns.
const MAX_COLUMNS: usize = 200;

/// Reads a design. The error tells what is wrong, with the line.
pub fn read_table(path: &Path) -> Result<Axis, String> {
    let shown = path.display();
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(MAX_SIZE + 1).read_to_end(&mut bytes))
        .map_err(|error| format!("cannot read `{shown}`: {error}"))?;
    if bytes.len() as u64 > MAX_SIZE {
        return Err(format!("`{shown}` is larger than {} MiB", MAX_SIZE >> 20));
    }
    let text = String::from_utf8(bytes).map_err(|_| format!("`{shown}` is not UTF-8 text; save it as UTF-8"))?;
    parse_table(&text).map_err(|why| format!("`{shown}`{why}"))
}

/// The design in a text. The error begins with the line.
fn parse_table(text: &str) -> Result<Axis, String> {
    // programs for tables put a mark of the byte order in front
    let text = text.trim_start_matches('\u{feff}');
    let header = text
        .lines()
        .find(|line| !line.trim_start().starts_with('#'))
        .unwrap_or_default();
    let semicolons = header.contains(';') && !header.contains(',');
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(if semicolons { b';' } else { b',' })
        .comment(Some(b'#'))
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let fault = |error: csv::Error| format!(": {error}");
    let titles: Vec<String> = reader.headers().map_err(fault)?.iter().map(str::to_string).collect();
    if titles.len() > MAX_COLUMNS {
        return Err(format!(
            ": {} columns are too many; at most {MAX_COLUMNS} are read",
            titles.len()
        ));
    }
    let columns: Vec<(String, Option<String>)> = titles.iter().map(|title| split_title(title)).collect();
    if let Some(at) = columns.iter().position(|column| column.0.is_empty()) {
        return Err(format!(
            ": the title of column {} is empty; the first line tells the key of every column",
            at + 1
        ));
    }
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(fault)?;
        let line = record.position().map_or(0, csv::Position::line);
        if record.len() != columns.len() {
            let (found, expected) = (record.len(), columns.len());
            return Err(format!(", line {line}: {found} cells, the header has {expected}"));
        }
        let cells = columns.iter().zip(&record);
        let row: Result<Vec<String>, String> = cells
            .map(|((key, unit), text)| cell(key, unit.as_deref(), text))
            .collect();
        rows.push(row.map_err(|why| format!(", line {line}: {why}"))?);
        if rows.len() > MAX_RUNS {
            return Err(format!(": these are more than {MAX_RUNS} rows"));
        }
    }
    if rows.is_empty() {
        return Err(": there is no row below the header".to_string());
    }
    Ok(Axis {
        keys: columns.into_iter().map(|(key, _)| key).collect(),
        rows,
        told_by: "--table".to_string(),
        logarithmic: false,
    })
}

/// Key and unit of a title such as `grains[0].diameter [mm]`.
fn split_title(title: &str) -> (String, Option<String>) {
    let with_unit = title
        .rsplit_once(" [")
        .and_then(|(key, rest)| Some((key, rest.strip_suffix(']')?)));
    match with_unit {
        Some((key, unit)) => (key.trim().to_string(), Some(unit.trim().to_string())),
        None => (title.to_string(), None),
    }
}

/// A value with the unit of its column.
fn cell(key: &str, unit: Option<&str>, text: &str) -> Result<String, String> {
    if text.is_empty() {
        return Err(format!("the cell of `{key}` is empty"));
    }
    match unit.filter(|unit| !unit.is_empty()) {
        None => Ok(text.to_string()),
        Some(unit) if units::split_number(text).is_ok_and(|(_, rest)| rest.is_empty()) => Ok(format!("{text} {unit}")),
        Some(unit) => Err(format!(
            "`{key}`: `{text}` is no plain number, but the header tells the unit `{unit}`; leave one of them out"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_stand_in_the_header_or_in_the_cells() {
        let text = "\u{feff}# plan\ngrains[0].diameter [mm],contact.normal.law,x\n1.5,jkr,2 mm\n2,\"a, b\",[1]\n";
        let table = parse_table(text).unwrap();
        assert_eq!(table.keys, ["grains[0].diameter", "contact.normal.law", "x"]);
        assert_eq!(table.rows[0], ["1.5 mm", "jkr", "2 mm"]);
        assert_eq!(table.rows[1], ["2 mm", "a, b", "[1]"]);
        let semicolons = parse_table("a;b [N/m]\n1;2\n").unwrap();
        assert_eq!(semicolons.rows, [["1", "2 N/m"]]);
    }

    #[test]
    fn what_is_no_design_is_told_with_its_line() {
        let cases = [
            ("", "no row below the header"),
            ("a,b\n", "no row below the header"),
            ("a,\n1,2\n", "the title of column 2 is empty"),
            ("a,b\n1,2\n3\n", ", line 3: 1 cells, the header has 2"),
            ("a,b\n1,\n", ", line 2: the cell of `b` is empty"),
            ("a [mm]\n1 mm\n", ", line 2: `a`: `1 mm` is no plain number"),
        ];
        for (text, expected) in cases {
            let fault = parse_table(text).map(|_| ()).unwrap_err();
            assert!(fault.contains(expected), "{text:?}: {fault}");
        }
    }
}
