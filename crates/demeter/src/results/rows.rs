//! Tables with named columns (CSV), read row by row from files that anyone may have written.

use super::error::ResultsError;
use csv::StringRecord;
use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom, Take};
use std::path::{Path, PathBuf};

/// Most columns of a table.
const MAX_COLUMNS: usize = 200_000;

/// Bytes that are looked at in one piece to find the last end of a line.
const PIECE: u64 = 1 << 16;

/// A table that is being read.
pub(crate) struct Table {
    path: PathBuf,
    header: Vec<String>,
    reader: csv::Reader<BufReader<Take<File>>>,
    record: StringRecord,
    /// Where the reader began [bytes], and the lines before.
    before: (u64, u64),
}

/// Where reading stopped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Place {
    /// Bytes read.
    pub bytes: u64,
    /// Lines read.
    pub lines: u64,
}

/// A row of a table.
#[derive(Clone, Copy)]
pub(crate) struct Row<'t> {
    table: &'t Table,
    line: u64,
}

/// A title without its unit.
pub fn column_name(title: &str) -> &str {
    title.split(" [").next().unwrap_or(title)
}

/// Index of a column in a header, told by its title or by its name without the unit.
pub fn position_of(header: &[String], name: &str) -> Option<usize> {
    let whole = header.iter().position(|title| title == name);
    whole.or_else(|| header.iter().position(|title| column_name(title) == name))
}

/// Index of a column that must be there, and no other of that name.
pub(super) fn only_position_of(path: &Path, header: &[String], name: &str) -> Result<usize, ResultsError> {
    let Some(first) = position_of(header, name) else {
        return Err(ResultsError::NoColumn {
            path: path.to_owned(),
            column: name.to_string(),
            help: nearest(name, header.iter().map(|title| column_name(title))),
        });
    };
    let is_whole = header[first] == name;
    let is_meant = |title: &&String| *title == name || (!is_whole && column_name(title) == name);
    let meant: Vec<String> = header
        .iter()
        .filter(is_meant)
        .map(|title| format!("`{title}`"))
        .collect();
    if let [_] = meant[..] {
        return Ok(first);
    }
    let help = match meant.iter().all(|title| *title == meant[0]) {
        true => "give each its own title",
        false => "name one with its unit",
    };
    Err(ResultsError::SeveralColumns {
        path: path.to_owned(),
        column: name.to_string(),
        columns: meant.join(", "),
        help,
    })
}

impl Table {
    /// Opens a table of at most so many bytes. When it may be `cut` short, a last line without an end is left out.
    pub fn open(path: &Path, allowed: u64, cut: bool) -> Result<Self, ResultsError> {
        let file = File::open(path).map_err(ResultsError::io(path))?;
        Self::from_file(path, file, allowed, cut)
    }

    /// As [`Self::open`], of a file that is open.
    pub fn from_file(path: &Path, file: File, allowed: u64, cut: bool) -> Result<Self, ResultsError> {
        let mut table = Self::reader(path, file, allowed, cut, Place::default())?;
        let mut header = StringRecord::new();
        table.reader.read_record(&mut header).map_err(|e| table.fault(&e))?;
        if header.len() > MAX_COLUMNS {
            let problem = format!("{} columns are too many; at most {MAX_COLUMNS} are read", header.len());
            return Err(ResultsError::Table {
                path: path.to_owned(),
                problem,
            });
        }
        table.header = header.iter().map(str::to_owned).collect();
        Ok(table)
    }

    /// Goes on reading a file that may be cut short behind the rows that were read, with their header.
    pub fn go_on(
        path: &Path,
        file: File,
        allowed: u64,
        header: Vec<String>,
        from: Place,
    ) -> Result<Self, ResultsError> {
        let table = Self::reader(path, file, allowed, true, from)?;
        Ok(Self { header, ..table })
    }

    fn reader(path: &Path, mut file: File, allowed: u64, cut: bool, from: Place) -> Result<Self, ResultsError> {
        let io = || ResultsError::io(path);
        let size = file.metadata().map_err(io())?.len();
        if size > allowed {
            let path = path.to_owned();
            return Err(ResultsError::TooLarge { path, size, allowed });
        }
        let end = if cut {
            end_of_last_line(&mut file, from.bytes, size).map_err(io())?
        } else {
            size
        };
        file.seek(SeekFrom::Start(from.bytes)).map_err(io())?;
        let reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .trim(csv::Trim::All)
            .comment(Some(b'#'))
            .from_reader(BufReader::new(file.take(end.saturating_sub(from.bytes))));
        Ok(Self {
            path: path.to_owned(),
            header: Vec::new(),
            reader,
            record: StringRecord::new(),
            before: (from.bytes, from.lines),
        })
    }

    /// How far it is read.
    pub fn place(&self) -> Place {
        let at = self.reader.position();
        Place {
            bytes: self.before.0 + at.byte(),
            lines: self.before.1 + at.line() - 1,
        }
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
        position_of(&self.header, name)
    }

    /// Index of a column that must be there.
    pub fn required(&self, name: &str) -> Result<usize, ResultsError> {
        only_position_of(&self.path, &self.header, name)
    }

    /// The next row.
    pub fn next(&mut self) -> Result<Option<Row<'_>>, ResultsError> {
        let read = self.reader.read_record(&mut self.record);
        if !read.map_err(|e| self.fault(&e))? {
            return Ok(None);
        }
        let line = self.before.1 + self.record.position().map_or(0, csv::Position::line);
        if self.record.len() != self.header.len() {
            let (found, expected) = (self.record.len(), self.header.len());
            let problem = format!("line {line} has {found} cells, the header has {expected}");
            let path = self.path.clone();
            return Err(ResultsError::Table { path, problem });
        }
        Ok(Some(Row { table: self, line }))
    }

    fn fault(&self, error: &csv::Error) -> ResultsError {
        let line = error
            .position()
            .map_or(String::new(), |at| format!("line {}: ", self.before.1 + at.line()));
        let problem = match error.kind() {
            csv::ErrorKind::Utf8 { .. } => format!("{line}not UTF-8 text"),
            _ => format!("{line}{error}"),
        };
        ResultsError::Table {
            path: self.path.clone(),
            problem,
        }
    }
}

/// Where the last whole line ends, or where the search begins when none ends behind that [bytes].
fn end_of_last_line(file: &mut File, from: u64, size: u64) -> io::Result<u64> {
    let mut end = size;
    let mut piece = Vec::new();
    while end > from {
        let start = end.saturating_sub(PIECE).max(from);
        file.seek(SeekFrom::Start(start))?;
        piece.clear();
        file.by_ref().take(end - start).read_to_end(&mut piece)?;
        if let Some(at) = piece.iter().rposition(|byte| *byte == b'\n') {
            return Ok(start + at as u64 + 1);
        }
        end = start;
    }
    Ok(from)
}

/// What is close to a name, or some of what there is.
pub(crate) fn nearest<'n>(name: &str, known: impl Iterator<Item = &'n str>) -> String {
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

impl Row<'_> {
    /// The text of a cell.
    pub fn text(&self, column: usize) -> &str {
        self.table.record.get(column).unwrap_or_default()
    }

    /// A finite number.
    pub fn number(&self, column: usize) -> Result<f64, ResultsError> {
        let value = self.text(column).parse().ok().filter(|x: &f64| x.is_finite());
        value.ok_or_else(|| self.fault(column, "a finite number"))
    }

    /// A finite number, or not a number, which is what a series tells where a measure has nothing to average.
    pub fn number_or_nan(&self, column: usize) -> Result<f64, ResultsError> {
        match self.text(column) {
            "NaN" => Ok(f64::NAN),
            _ => self.number(column),
        }
    }

    /// A finite number, or nothing where the cell is empty.
    pub fn maybe_number(&self, column: usize) -> Result<Option<f64>, ResultsError> {
        match self.text(column) {
            "" => Ok(None),
            _ => self.number(column).map(Some),
        }
    }

    /// A whole number.
    pub fn count<T: std::str::FromStr>(&self, column: usize) -> Result<T, ResultsError> {
        (self.text(column).parse().ok()).ok_or_else(|| self.fault(column, "a whole number"))
    }

    /// Says that a cell holds something else.
    pub fn fault(&self, column: usize, expected: &'static str) -> ResultsError {
        ResultsError::Cell {
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

    fn table(text: &str, cut: bool) -> Result<Table, ResultsError> {
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
    fn a_name_that_several_columns_have_decides_nothing() {
        let told = |header: &str, name: &str| {
            let found = table(&format!("{header}\n"), false).unwrap().required(name);
            found.map_err(|error| error.to_string())
        };
        assert_eq!(
            [told("a [m],a,a [s]", "a"), told("a [m],b,a [s]", "a [s]")],
            [Ok(1), Ok(2)]
        );
        let units = told("a [m],b,a [s]", "a").unwrap_err();
        assert!(
            units.ends_with("the name `a` fits several columns: `a [m]`, `a [s]`; name one with its unit"),
            "{units}"
        );
        for name in ["b", "b [m]"] {
            let twice = told(&format!("a,{name},{name}"), name).unwrap_err();
            assert!(
                twice.ends_with(&format!(
                    "fits several columns: `{name}`, `{name}`; give each its own title"
                )),
                "{twice}"
            );
        }
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
            Err(ResultsError::TooLarge { .. })
        ));
    }
}
