//! Tables of rows as columns: the series, profiles, paths and distributions of a run.

use super::error::ResultsError;
use super::rows::{Place, Table, column_name, only_position_of, position_of};
use crate::output::RunFolder;
use std::collections::HashMap;
use std::fs::File;
use std::path::{Path, PathBuf};

/// Largest file that is read [bytes].
const MAX_SIZE: u64 = 2 << 30;
/// Most cells that are kept.
const MAX_CELLS: usize = 1 << 28;
/// Columns that hold words even where the words look like numbers.
const WORDS: [&str; 1] = ["stage"];

/// The cells of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Numbers; NaN where the cell is empty or says so.
    Numbers(Vec<f64>),
    /// Words, each kept once.
    Words {
        /// The different words, in the order in which they come.
        words: Vec<String>,
        /// For every row the index of its word.
        rows: Vec<u32>,
    },
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Title as in the file: `time [s]`.
    pub title: String,
    /// Its cells, one for each row.
    pub cells: Cells,
}

impl Column {
    /// Name without the unit: `time`.
    pub fn name(&self) -> &str {
        column_name(&self.title)
    }

    /// Unit: `s`; empty for what has none.
    pub fn unit(&self) -> &str {
        let unit = self.title.split_once(" [").and_then(|(_, unit)| unit.strip_suffix(']'));
        unit.unwrap_or_default()
    }

    /// The numbers, where it holds numbers.
    pub fn numbers(&self) -> Option<&[f64]> {
        match &self.cells {
            Cells::Numbers(numbers) => Some(numbers),
            Cells::Words { .. } => None,
        }
    }

    /// The cells of some rows.
    fn taken(&self, some: impl Iterator<Item = usize>) -> Self {
        let cells = match &self.cells {
            Cells::Numbers(numbers) => Cells::Numbers(some.map(|row| numbers[row]).collect()),
            Cells::Words { words, rows } => Cells::Words {
                words: words.clone(),
                rows: some.map(|row| rows[row]).collect(),
            },
        };
        Self {
            title: self.title.clone(),
            cells,
        }
    }

    /// The word of a row, where it holds words.
    pub fn word(&self, row: usize) -> Option<&str> {
        match &self.cells {
            Cells::Numbers(_) => None,
            Cells::Words { words, rows } => words.get(*rows.get(row)? as usize).map(String::as_str),
        }
    }
}

/// Column of the lower edges of bins, in [`Columns::bins_as_rows`].
pub const BIN: &str = "bin";
/// Column of what bins hold, there.
pub const IN_BIN: &str = "in bin";

/// What reading on has found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Update {
    /// Nothing new.
    Unchanged,
    /// More rows behind those that were there.
    Grown,
    /// Another file, or one that went back to an earlier row: all rows were read anew.
    Replaced,
}

/// A table of rows as columns.
///
/// A file that still grows is followed with [`Self::update`]: only what is new is read, and a last row that is not yet whole
/// is left for the next time.
#[derive(Clone, Debug)]
pub struct Columns {
    path: PathBuf,
    columns: Vec<Column>,
    rows: usize,
    /// For every column the indices of its words.
    known: Vec<HashMap<String, u32>>,
    read_to: Place,
    /// The last bytes before that place, by which the file is known again.
    tail: Vec<u8>,
}

/// Most bytes by which a file is known again.
const TAIL: u64 = 4096;

impl Columns {
    /// Reads a table.
    pub fn read(path: &Path) -> Result<Self, ResultsError> {
        let file = File::open(path).map_err(ResultsError::io(path))?;
        Self::from_file(path, file)
    }

    /// Reads the series of the run in a folder.
    pub fn series_of(folder: &Path) -> Result<Self, ResultsError> {
        Self::read(&RunFolder::find(folder)?.series())
    }

    /// Reads a table from a file that is open.
    pub fn from_file(path: &Path, file: File) -> Result<Self, ResultsError> {
        let mut columns = Self {
            path: path.to_owned(),
            columns: Vec::new(),
            rows: 0,
            known: Vec::new(),
            read_to: Place::default(),
            tail: Vec::new(),
        };
        columns.begin(file)?;
        Ok(columns)
    }

    /// Where it was read.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// All columns, in order.
    pub fn all(&self) -> &[Column] {
        &self.columns
    }

    /// Columns that are bins of a distribution, as their names, which are rising numbers, tell: their indices and lower edges.
    fn bins(&self) -> Vec<(usize, f64)> {
        let edge = |column: &Column| column.name().parse::<f64>().ok().filter(|_| column.numbers().is_some());
        let columns = self.columns.iter().enumerate();
        let bins: Vec<(usize, f64)> = columns.filter_map(|(k, column)| Some((k, edge(column)?))).collect();
        if bins.is_sorted_by(|a, b| a.1 < b.1) {
            bins
        } else {
            Vec::new()
        }
    }

    /// Whether some columns are bins of a distribution.
    pub fn has_bins(&self) -> bool {
        !self.bins().is_empty()
    }

    /// Unit of the lower edges of bins; empty where there are none.
    pub fn unit_of_bins(&self) -> &str {
        self.bins().first().map_or("", |(bin, _)| self.columns[*bin].unit())
    }

    /// The columns that are no bins.
    pub fn without_bins(&self) -> impl Iterator<Item = &Column> {
        let bins = self.bins();
        let columns = self.columns.iter().enumerate();
        let others = columns.filter(move |(k, _)| !bins.iter().any(|(bin, _)| bin == k));
        others.map(|(_, column)| column)
    }

    /// The table with a row for each bin of each row: the columns [`BIN`], its lower edge, and [`IN_BIN`], what the bin holds, stand in
    /// place of those of the bins.
    pub fn bins_as_rows(&self) -> Result<Self, ResultsError> {
        let bins = self.bins();
        let count = self.rows.saturating_mul(bins.len());
        if count.saturating_mul(self.columns.len() + 2 - bins.len()) > MAX_CELLS {
            return Err(ResultsError::Table {
                path: self.path.clone(),
                problem: format!(
                    "with a row for each bin it has more than {MAX_CELLS} cells; write fewer rows or bins"
                ),
            });
        }
        let rows = || (0..self.rows).flat_map(|row| std::iter::repeat_n(row, bins.len()));
        let mut columns: Vec<Column> = self.without_bins().map(|column| column.taken(rows())).collect();
        let held = |row: usize, bin: usize| self.columns[bin].numbers().map_or(f64::NAN, |held| held[row]);
        let of_bins = bins.iter().cycle().zip(rows());
        let (edges, values) = of_bins.map(|(&(bin, edge), row)| (edge, held(row, bin))).unzip();
        let bin = match self.unit_of_bins() {
            "" => BIN.to_owned(),
            unit => format!("{BIN} [{unit}]"),
        };
        for (title, numbers) in [(bin, edges), (IN_BIN.to_owned(), values)] {
            columns.push(Column {
                title,
                cells: Cells::Numbers(numbers),
            });
        }
        Ok(Self {
            path: self.path.clone(),
            columns,
            rows: count,
            known: Vec::new(),
            read_to: Place::default(),
            tail: Vec::new(),
        })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    fn titles(&self) -> Vec<String> {
        self.columns.iter().map(|column| column.title.clone()).collect()
    }

    /// A column, told by its title or by its name without the unit; the first where several have it.
    pub fn find(&self, name: &str) -> Option<&Column> {
        position_of(&self.titles(), name).map(|k| &self.columns[k])
    }

    /// A column that must be there, and no other of that name, told by its title or by its name without the unit.
    pub fn required(&self, name: &str) -> Result<&Column, ResultsError> {
        let at = only_position_of(&self.path, &self.titles(), name)?;
        Ok(&self.columns[at])
    }

    /// The numbers of a column that must be there and hold numbers.
    pub fn numbers(&self, name: &str) -> Result<&[f64], ResultsError> {
        let column = self.required(name)?;
        column.numbers().ok_or_else(|| ResultsError::Table {
            path: self.path.clone(),
            problem: format!("the column `{name}` holds words, not numbers"),
        })
    }

    /// The words of a column that must be there and hold words.
    pub fn words(&self, name: &str) -> Result<Vec<&str>, ResultsError> {
        let column = self.required(name)?;
        let words = (0..self.rows).map(|row| column.word(row));
        words.collect::<Option<_>>().ok_or_else(|| ResultsError::Table {
            path: self.path.clone(),
            problem: format!("the column `{name}` holds numbers, not words"),
        })
    }

    /// Ranges of rows that follow each other with the same word in a column, such as `stage`; one range of all rows where
    /// there is no such column.
    pub fn spans(&self, name: &str) -> Vec<(String, std::ops::Range<usize>)> {
        let Some(column) = self.find(name) else {
            return vec![(String::new(), 0..self.rows)];
        };
        let mut spans: Vec<(String, std::ops::Range<usize>)> = Vec::new();
        for row in 0..self.rows {
            let word = column.word(row).unwrap_or_default();
            match spans.last_mut() {
                Some((last, range)) if last == word => range.end = row + 1,
                _ => spans.push((word.to_string(), row..row + 1)),
            }
        }
        spans
    }

    /// Reads what was added since.
    pub fn update(&mut self) -> Result<Update, ResultsError> {
        let file = File::open(&self.path).map_err(ResultsError::io(&self.path))?;
        self.update_from(file)
    }

    /// As [`Self::update`], from a file that is open.
    pub fn update_from(&mut self, mut file: File) -> Result<Update, ResultsError> {
        let known = tail(&mut file, self.read_to.bytes).map_err(ResultsError::io(&self.path))?;
        if self.columns.is_empty() || known != self.tail {
            let before = self.rows;
            self.begin(file)?;
            return Ok(if before == 0 && self.rows == 0 {
                Update::Unchanged
            } else {
                Update::Replaced
            });
        }
        let before = self.rows;
        let header = self.titles();
        let again = file.try_clone().map_err(ResultsError::io(&self.path))?;
        let table = Table::go_on(&self.path, file, MAX_SIZE, header, self.read_to)?;
        self.take(table, again)?;
        Ok(if self.rows > before {
            Update::Grown
        } else {
            Update::Unchanged
        })
    }

    fn begin(&mut self, file: File) -> Result<(), ResultsError> {
        let again = file.try_clone().map_err(ResultsError::io(&self.path))?;
        let table = Table::from_file(&self.path, file, MAX_SIZE, true)?;
        self.columns.clear();
        self.rows = 0;
        self.known = vec![HashMap::new(); table.header().len()];
        self.columns.extend(table.header().iter().map(|title| Column {
            title: title.clone(),
            cells: Cells::Numbers(Vec::new()),
        }));
        self.take(table, again)
    }

    fn take(&mut self, mut table: Table, mut again: File) -> Result<(), ResultsError> {
        while let Some(row) = table.next()? {
            if (self.rows + 1).saturating_mul(self.columns.len()) > MAX_CELLS {
                return Err(ResultsError::Table {
                    path: self.path.clone(),
                    problem: format!("it has more than {MAX_CELLS} cells; write fewer rows (`output.series`)"),
                });
            }
            let first = self.rows == 0;
            for (k, (column, known)) in self.columns.iter_mut().zip(&mut self.known).enumerate() {
                if let Err(expected) = add(column, known, row.text(k), first) {
                    let error = row.fault(k, expected);
                    self.shorten();
                    return Err(error);
                }
            }
            self.rows += 1;
        }
        self.read_to = table.place();
        self.tail = tail(&mut again, self.read_to.bytes).map_err(ResultsError::io(&self.path))?;
        Ok(())
    }

    /// Forgets the cells of a row that was given up.
    fn shorten(&mut self) {
        for column in &mut self.columns {
            match &mut column.cells {
                Cells::Numbers(numbers) => numbers.truncate(self.rows),
                Cells::Words { rows, .. } => rows.truncate(self.rows),
            }
        }
    }
}

/// Adds a cell; the first of a column decides whether it holds numbers or words. The error tells what was expected.
fn add(column: &mut Column, known: &mut HashMap<String, u32>, text: &str, first: bool) -> Result<(), &'static str> {
    let number = if text.is_empty() {
        Some(f64::NAN)
    } else {
        text.parse().ok()
    };
    if first && (number.is_none() || WORDS.contains(&column.title.as_str())) {
        column.cells = Cells::Words {
            words: Vec::new(),
            rows: Vec::new(),
        };
    }
    match &mut column.cells {
        Cells::Numbers(numbers) => numbers.push(number.ok_or("a number")?),
        Cells::Words { words, rows } => {
            let at = match known.get(text) {
                Some(at) => *at,
                None => {
                    let at = u32::try_from(words.len()).map_err(|_| "one of so many words")?;
                    words.push(text.to_string());
                    known.insert(text.to_string(), at);
                    at
                }
            };
            rows.push(at);
        }
    }
    Ok(())
}

/// The last bytes before a place.
fn tail(file: &mut File, end: u64) -> std::io::Result<Vec<u8>> {
    use std::io::{Read, Seek, SeekFrom};
    let start = end.saturating_sub(TAIL);
    file.seek(SeekFrom::Start(start))?;
    let mut bytes = Vec::new();
    file.take(end - start).read_to_end(&mut bytes)?;
    file.rewind()?;
    Ok(bytes)
}
