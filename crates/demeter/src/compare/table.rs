//! Tables with named columns, read row by row from files that anyone may have written.

use super::error::CompareError;
use csv::StringRecord;
use std::fs::File;
use std::io::{BufReader, Read, Seek, SeekFrom, Take};
use std::path::{Path, PathBuf};

/// Most columns of a table.
const MAX_COLUMNS: usize = 200_000;

/// A table that is being read.
pub(super) struct Table {
    path: PathBuf,
    header: Vec<String>,
    reader: csv::Reader<BufReader<Take<File>>>,
    record: StringRecord,
    /// Where a last line ends that was cut short and is left out [bytes].
    cut_at: Option<u64>,
}

/// A row of a table.
#[derive(Clone, Copy)]
pub(super) struct Row<'t> {
    table: &'t Table,
    line: u64,
}

/// A title without its unit.
fn name_of(title: &str) -> &str {
    title.split(" [").next().unwrap_or(title)
}

impl Table {
    /// Opens a table of at most so many bytes. When it may be `cut` short, a last line without an end is left out.
    pub fn open(path: &Path, allowed: u64, cut: bool) -> Result<Self, CompareError> {
        let mut file = File::open(path).map_err(CompareError::io(path))?;
        let size = file.metadata().map_err(CompareError::io(path))?.len();
        if size > allowed {
            let path = path.to_owned();
            return Err(CompareError::TooLarge { path, size, allowed });
        }
        let mut last = [b'\n'];
        if cut && size > 0 {
            file.seek(SeekFrom::End(-1)).map_err(CompareError::io(path))?;
            file.read_exact(&mut last).map_err(CompareError::io(path))?;
            file.rewind().map_err(CompareError::io(path))?;
        }
        let mut reader = csv::ReaderBuilder::new()
            .flexible(true)
            .trim(csv::Trim::All)
            .comment(Some(b'#'))
            .from_reader(BufReader::new(file.take(allowed)));
        let header = reader.headers().map_err(|e| fault(path, &e))?;
        if header.len() > MAX_COLUMNS {
            let problem = format!("{} columns are too many; at most {MAX_COLUMNS} are read", header.len());
            return Err(CompareError::Table {
                path: path.to_owned(),
                problem,
            });
        }
        let header: Vec<String> = header.iter().map(str::to_owned).collect();
        Ok(Self {
            path: path.to_owned(),
            header,
            reader,
            record: StringRecord::new(),
            cut_at: (last != [b'\n']).then_some(size),
        })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Titles of the columns.
    pub fn header(&self) -> &[String] {
        &self.header
    }

    /// Index of a column, told with or without its unit.
    pub fn column(&self, name: &str) -> Option<usize> {
        let whole = self.header.iter().position(|title| title == name);
        whole.or_else(|| self.header.iter().position(|title| name_of(title) == name))
    }

    /// Index of a column that must be there.
    pub fn required(&self, name: &str) -> Result<usize, CompareError> {
        self.column(name).ok_or_else(|| CompareError::NoColumn {
            path: self.path.clone(),
            column: name.to_string(),
            help: nearest(name, self.header.iter().map(|title| name_of(title))),
        })
    }

    /// The next row.
    pub fn next(&mut self) -> Result<Option<Row<'_>>, CompareError> {
        let path = self.path.clone();
        if !self
            .reader
            .read_record(&mut self.record)
            .map_err(|e| fault(&path, &e))?
        {
            return Ok(None);
        }
        let line = self.record.position().map_or(0, csv::Position::line);
        if self.cut_at.is_some_and(|end| self.reader.position().byte() >= end) {
            return Ok(None);
        }
        if self.record.len() != self.header.len() {
            let (found, expected) = (self.record.len(), self.header.len());
            let problem = format!("line {line} has {found} cells, the header has {expected}");
            return Err(CompareError::Table { path, problem });
        }
        Ok(Some(Row { table: self, line }))
    }
}

/// What is close to a name, or some of what there is.
fn nearest<'n>(name: &str, known: impl Iterator<Item = &'n str>) -> String {
    let known: Vec<&str> = known.collect();
    let distance = |k: &&&str| strsim::osa_distance(&name.to_lowercase(), &k.to_lowercase());
    match known.iter().min_by_key(distance) {
        Some(close) if distance(&close) <= 1 + name.chars().count().min(64) / 4 => {
            format!("did you mean `{close}`?")
        }
        _ => {
            let shown: Vec<String> = known.iter().take(60).map(|k| format!("`{k}`")).collect();
            let more = if known.len() > 60 { ", ..." } else { "" };
            format!("there are {}{more}", shown.join(", "))
        }
    }
}

fn fault(path: &Path, error: &csv::Error) -> CompareError {
    let line = error
        .position()
        .map_or(String::new(), |at| format!("line {}: ", at.line()));
    let problem = match error.kind() {
        csv::ErrorKind::Utf8 { .. } => format!("{line}not UTF-8 text"),
        _ => format!("{line}{error}"),
    };
    CompareError::Table {
        path: path.to_owned(),
        problem,
    }
}

impl Row<'_> {
    /// The text of a cell.
    pub fn text(&self, column: usize) -> &str {
        self.table.record.get(column).unwrap_or_default()
    }

    /// A finite number.
    pub fn number(&self, column: usize) -> Result<f64, CompareError> {
        let value = self.text(column).parse().ok().filter(|x: &f64| x.is_finite());
        value.ok_or_else(|| self.fault(column, "a finite number"))
    }

    /// A finite number, or not a number, which is what a series tells where a measure has nothing to average.
    pub fn number_or_nan(&self, column: usize) -> Result<f64, CompareError> {
        match self.text(column) {
            "NaN" => Ok(f64::NAN),
            _ => self.number(column),
        }
    }

    /// A finite number, or nothing where the cell is empty.
    pub fn maybe_number(&self, column: usize) -> Result<Option<f64>, CompareError> {
        match self.text(column) {
            "" => Ok(None),
            _ => self.number(column).map(Some),
        }
    }

    /// A whole number.
    pub fn count<T: std::str::FromStr>(&self, column: usize) -> Result<T, CompareError> {
        (self.text(column).parse().ok()).ok_or_else(|| self.fault(column, "a whole number"))
    }

    /// Says that a cell holds something else.
    pub fn fault(&self, column: usize, expected: &'static str) -> CompareError {
        CompareError::Cell {
            path: self.table.path.clone(),
            line: self.line,
            column: self.table.header.get(column).cloned().unwrap_or_default(),
            found: self.text(column).chars().take(40).collect(),
            expected,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(text: &str, cut: bool) -> Result<Table, CompareError> {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("t.csv");
        std::fs::write(&path, text).unwrap();
        Table::open(&path, 1000, cut)
    }

    #[test]
    fn columns_are_found_with_and_without_unit() {
        let table = table("a [m],b,a\n1,2,3\n", false).unwrap();
        assert_eq!(
            [table.column("a [m]"), table.column("a"), table.column("b")],
            [Some(0), Some(2), Some(1)]
        );
        let error = table.required("bb").unwrap_err().to_string();
        assert!(error.contains("no column `bb`; did you mean `b`?"), "{error}");
    }

    #[test]
    fn a_line_that_was_cut_is_left_out() {
        let mut whole = table("a,b\n1,2\n3,4", false).unwrap();
        assert!(whole.next().unwrap().is_some() && whole.next().unwrap().is_some());
        let mut cut = table("a,b\n1,2\n3,4", true).unwrap();
        assert_eq!(cut.next().unwrap().unwrap().number(1).unwrap(), 2.0);
        assert!(cut.next().unwrap().is_none());
    }

    #[test]
    fn what_is_no_number_is_told_with_its_place() {
        let mut odd = table("a,b\n1,NaN\n", false).unwrap();
        let row = odd.next().unwrap().unwrap();
        let error = row.number(1).unwrap_err().to_string();
        assert!(
            error.contains("line 2, column `b`: `NaN` is not a finite number"),
            "{error}"
        );
        assert!(row.count::<u64>(1).is_err() && row.maybe_number(0).unwrap() == Some(1.0));
        assert!(row.number_or_nan(1).unwrap().is_nan() && row.number_or_nan(0).unwrap() == 1.0);
        let mut short = table("a,b\n1\n", false).unwrap();
        assert!(short.next().err().unwrap().to_string().contains("line 2 has 1 cells"));
        assert!(matches!(
            table(&"x".repeat(1001), false),
            Err(CompareError::TooLarge { .. })
        ));
    }
}
