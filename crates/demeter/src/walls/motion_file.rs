//! Rows of a table of motion, from a text file of columns: commas, semicolons or tabs.
//!
//! ```text
//! # comment
//! time [ms], z [mm], angle [deg]
//! 0, 0, 0
//! 250, -1.5, 10
//! ```
//!
//! Columns: `time`; of places `x`, `y`, `z`, `angle`, or of velocities `vx`, `vy`, `vz`, `angular velocity`; those that are
//! not there are 0. A column without a unit is in SI. Files are not trusted: size and numbers are checked.

use super::motion_table::{MAX_TABLE_ROWS, TableRows};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Largest file that is read [bytes].
const MAX_BYTES: u64 = 32 << 20;

/// Most characters of a file that a message shows.
const SHOWN: usize = 40;

/// A file with a table of motion that cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{}{}: {problem}", path.display(), place(*line, column.as_deref()))]
pub struct MotionFileError {
    /// The file.
    pub path: PathBuf,
    /// Line, from 1; 0 when the file as a whole is meant.
    pub line: usize,
    /// Title of the column at fault.
    pub column: Option<String>,
    /// What is wrong.
    pub problem: MotionFileProblem,
}

fn place(line: usize, column: Option<&str>) -> String {
    let line = if line > 0 {
        format!(", line {line}")
    } else {
        String::new()
    };
    column.map_or(line.clone(), |title| format!("{line}, column `{title}`"))
}

/// What is wrong with a file with a table of motion.
#[derive(Debug, thiserror::Error)]
#[allow(missing_docs)]
pub enum MotionFileProblem {
    #[error("cannot be read: {0}")]
    Read(#[from] std::io::Error),
    #[error("is larger than {} MiB, the most that is read", MAX_BYTES >> 20)]
    TooLarge,
    #[error("is not text (byte {position} is not UTF-8); save it as text")]
    NotText { position: usize },
    #[error("there is no line of titles; begin with one such as `time [s], z [mm]`")]
    NoTitles,
    #[error("`{found}` is no title; begin the file with a line of titles such as `time [s], z [mm]`")]
    NumberForTitle { found: String },
    #[error("`{found}` is not a known column; known are time, x, y, z, angle, and vx, vy, vz, angular velocity")]
    UnknownColumn { found: String },
    #[error("the column is told twice; keep one of them")]
    Twice,
    #[error("unit `{unit}` is not known here; allowed: {allowed}")]
    UnknownUnit { unit: String, allowed: String },
    #[error("there is no column `time`")]
    NoTime,
    #[error("there is no column beside the time; add one of x, y, z, angle, or of vx, vy, vz, angular velocity")]
    Nothing,
    #[error("a table tells places (x, y, z, angle) or velocities (vx, vy, vz, angular velocity), not both")]
    Mixed,
    #[error(
        "{found} values where the titles name {expected} columns; commas part them, so that `0,01` is two: write numbers with a point, or \
         part values by semicolons"
    )]
    CommasInNumbers { found: usize, expected: usize },
    #[error("{found} values where the titles name {expected} columns")]
    ValueCount { found: usize, expected: usize },
    #[error("`{text}` is not a number: it has a comma; write it with a point")]
    Comma { text: String },
    #[error("`{text}` is not a finite number of ordinary size")]
    NotANumber { text: String },
    #[error("the time {time} s does not come after {before} s of the row before; times must rise from row to row")]
    TimeFalls { time: f64, before: f64 },
    #[error("the time {time} s is negative; times count from the start of the motion")]
    TimeNegative { time: f64 },
    #[error("there are more than {MAX_TABLE_ROWS} rows, the most that is read")]
    TooManyRows,
    #[error("a motion needs at least 2 rows below the titles, found {rows}")]
    TooFewRows { rows: usize },
}

pub(super) type Units = &'static [(&'static str, f64)];

const TIMES: Units = &[("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9), ("min", 60.0)];
pub(super) const LENGTHS: Units = &[
    ("m", 1.0),
    ("cm", 1e-2),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("\u{b5}m", 1e-6),
    ("\u{3bc}m", 1e-6),
    ("nm", 1e-9),
    ("in", 0.0254),
];
const VELOCITIES: Units = &[("m/s", 1.0), ("cm/s", 1e-2), ("mm/s", 1e-3), ("um/s", 1e-6)];
const ANGLES: Units = &[
    ("rad", 1.0),
    ("deg", std::f64::consts::PI / 180.0),
    ("rev", std::f64::consts::TAU),
];
const ANGULAR_VELOCITIES: Units = &[
    ("rad/s", 1.0),
    ("1/s", 1.0),
    ("deg/s", std::f64::consts::PI / 180.0),
    ("rpm", std::f64::consts::TAU / 60.0),
];

/// What a column tells: the time, or a place or rate by its index among x, y, z and angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Told {
    Time,
    Place(usize),
    Rate(usize),
}

const COLUMNS: [(&str, Told, Units); 9] = [
    ("time", Told::Time, TIMES),
    ("x", Told::Place(0), LENGTHS),
    ("y", Told::Place(1), LENGTHS),
    ("z", Told::Place(2), LENGTHS),
    ("angle", Told::Place(3), ANGLES),
    ("vx", Told::Rate(0), VELOCITIES),
    ("vy", Told::Rate(1), VELOCITIES),
    ("vz", Told::Rate(2), VELOCITIES),
    ("angular velocity", Told::Rate(3), ANGULAR_VELOCITIES),
];

/// Rows of a file, and what its columns tell.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionFile {
    /// The rows, in SI.
    pub rows: TableRows,
    /// Whether they tell velocities.
    pub are_rates: bool,
    /// Whether there is a column for the angle.
    pub turns: bool,
}

struct Column {
    title: String,
    told: Told,
    factor: f64,
}

/// Reads a file with a table of motion.
pub fn read_motion_file(path: &Path) -> Result<MotionFile, MotionFileError> {
    let fails = |(line, column, problem): Fault| MotionFileError {
        path: path.to_owned(),
        line,
        column,
        problem,
    };
    let text = read_text(path).map_err(|problem| fails((0, None, problem)))?;
    parse(&text).map_err(fails)
}

type Fault = (usize, Option<String>, MotionFileProblem);

fn read_text(path: &Path) -> Result<String, MotionFileProblem> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(MotionFileProblem::TooLarge);
    }
    String::from_utf8(bytes).map_err(|error| MotionFileProblem::NotText {
        position: error.utf8_error().valid_up_to(),
    })
}

fn parse(text: &str) -> Result<MotionFile, Fault> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = (text.lines().enumerate())
        .map(|(k, line)| (k + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let Some((line, titles)) = lines.next() else {
        return Err((0, None, MotionFileProblem::NoTitles));
    };
    let separator = [',', ';', '\t']
        .into_iter()
        .find(|c| titles.contains(*c))
        .unwrap_or(',');
    let columns = columns(titles, separator).map_err(|(column, problem)| (line, column, problem))?;
    let mut rows = TableRows::default();
    for (line, row) in lines {
        read_row(&columns, row, separator, &mut rows).map_err(|(column, problem)| (line, column, problem))?;
    }
    if rows.times.len() < 2 {
        let rows = rows.times.len();
        return Err((0, None, MotionFileProblem::TooFewRows { rows }));
    }
    Ok(MotionFile {
        rows,
        are_rates: columns.iter().any(|c| matches!(c.told, Told::Rate(_))),
        turns: columns.iter().any(|c| matches!(c.told, Told::Place(3) | Told::Rate(3))),
    })
}

fn shown(text: &str) -> String {
    text.chars().take(SHOWN).collect()
}

/// A title, `z [mm]`: the name, and the unit in brackets where there is one.
pub(super) fn name_and_unit(title: &str) -> (&str, Option<&str>) {
    match title.split_once(['[', '(']) {
        Some((name, rest)) => (name.trim(), Some(rest.trim_end_matches([']', ')']).trim())),
        None => (title.trim(), None),
    }
}

/// Names of units, for a message.
pub(super) fn names(units: Units) -> String {
    units.iter().map(|unit| unit.0).collect::<Vec<_>>().join(", ")
}

fn columns(titles: &str, separator: char) -> Result<Vec<Column>, (Option<String>, MotionFileProblem)> {
    let mut columns: Vec<Column> = Vec::new();
    for title in titles
        .split(separator)
        .map(|title| title.trim().trim_matches('"').trim())
    {
        let (name, unit) = name_and_unit(title);
        let name = name.to_ascii_lowercase();
        if name.parse::<f64>().is_ok() {
            return Err((None, MotionFileProblem::NumberForTitle { found: shown(title) }));
        }
        let Some((_, told, units)) = COLUMNS.iter().find(|(known, ..)| *known == name) else {
            return Err((None, MotionFileProblem::UnknownColumn { found: shown(title) }));
        };
        let factor = match unit {
            None => 1.0,
            Some(unit) => {
                let found = units.iter().find(|(known, _)| *known == unit);
                let refuse = || MotionFileProblem::UnknownUnit {
                    unit: shown(unit),
                    allowed: names(units),
                };
                found.ok_or_else(|| (Some(shown(title)), refuse()))?.1
            }
        };
        if columns.iter().any(|c| c.told == *told) {
            return Err((Some(shown(title)), MotionFileProblem::Twice));
        }
        columns.push(Column {
            title: shown(title),
            told: *told,
            factor,
        });
    }
    let has = |fits: fn(Told) -> bool| columns.iter().any(|c| fits(c.told));
    let (places, rates) = (
        has(|t| matches!(t, Told::Place(_))),
        has(|t| matches!(t, Told::Rate(_))),
    );
    match (has(|t| t == Told::Time), places, rates) {
        (false, ..) => Err((None, MotionFileProblem::NoTime)),
        (true, false, false) => Err((None, MotionFileProblem::Nothing)),
        (true, true, true) => Err((None, MotionFileProblem::Mixed)),
        _ => Ok(columns),
    }
}

fn read_row(
    columns: &[Column],
    row: &str,
    separator: char,
    rows: &mut TableRows,
) -> Result<(), (Option<String>, MotionFileProblem)> {
    if rows.times.len() == MAX_TABLE_ROWS {
        return Err((None, MotionFileProblem::TooManyRows));
    }
    let (found, expected) = (row.split(separator).count(), columns.len());
    if found != expected {
        let problem = match separator {
            ',' if found > expected => MotionFileProblem::CommasInNumbers { found, expected },
            _ => MotionFileProblem::ValueCount { found, expected },
        };
        return Err((None, problem));
    }
    let (mut time, mut values) = (0.0, [0.0; 4]);
    for (column, text) in columns.iter().zip(row.split(separator)) {
        let at = |problem| (Some(column.title.clone()), problem);
        let text = text.trim().trim_matches('"').trim();
        let value = match text.parse::<f64>() {
            Ok(value) if value.abs() <= super::limits::LARGEST => value * column.factor,
            _ if text.replace(',', ".").parse::<f64>().is_ok() && text.contains(',') => {
                return Err(at(MotionFileProblem::Comma { text: shown(text) }));
            }
            _ => return Err(at(MotionFileProblem::NotANumber { text: shown(text) })),
        };
        match (column.told, rows.times.last()) {
            (Told::Place(k) | Told::Rate(k), _) => values[k] = value,
            (Told::Time, Some(&before)) if value <= before => {
                return Err(at(MotionFileProblem::TimeFalls { time: value, before }));
            }
            (Told::Time, _) if value < 0.0 => return Err(at(MotionFileProblem::TimeNegative { time: value })),
            (Told::Time, _) => time = value,
        }
    }
    rows.times.push(time);
    rows.values.push(values);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_come_in_any_order_and_unit() {
        let text = "# a punch\n\nangle [deg]; time [ms]; z [mm]\n0; 0; 1\n180; 500; -2.5\n";
        let file = parse(text).unwrap();
        assert!(file.turns && !file.are_rates);
        assert_eq!(file.rows.times, [0.0, 0.5]);
        assert_eq!(file.rows.values[1], [0.0, 0.0, -2.5e-3, std::f64::consts::PI]);
        let rates = parse("time, vx [mm/s], angular velocity [rpm]\n0,1,60\n1,2,0").unwrap();
        assert!(rates.turns && rates.are_rates);
        assert!((rates.rows.values[0][3] - std::f64::consts::TAU).abs() < 1e-15);
        let fine = parse("time [ns], z [nm]\n0,0\n2,5").unwrap();
        assert_eq!((fine.rows.times[1], fine.rows.values[1][2]), (2.0 * 1e-9, 5.0 * 1e-9));
    }

    #[test]
    fn faults_tell_line_and_column() {
        let cases = [
            ("", ": there is no line of titles"),
            ("0, 1\n1, 2", ", line 1: `0` is no title"),
            ("time, u\n", ", line 1: `u` is not a known column"),
            (
                "time, z [s]\n",
                ", line 1, column `z [s]`: unit `s` is not known here; allowed: m,",
            ),
            (
                "time, z, z [mm]\n",
                ", line 1, column `z [mm]`: the column is told twice",
            ),
            ("z\n", ", line 1: there is no column `time`"),
            ("time\n", ", line 1: there is no column beside the time"),
            ("time, z, vz\n", ", line 1: a table tells places"),
            (
                "time, z\n0, 0\n1\n",
                ", line 3: 1 values where the titles name 2 columns",
            ),
            (
                "time, z\n0, 0\n1, x\n",
                ", line 3, column `z`: `x` is not a finite number",
            ),
            (
                "time, z\n0, 0\n1, inf\n",
                ", line 3, column `z`: `inf` is not a finite number",
            ),
            (
                "time, z\n0, 0\n0, 1\n",
                ", line 3, column `time`: the time 0 s does not come after 0 s",
            ),
            ("time, z\n-1, 0\n", ", line 2, column `time`: the time -1 s is negative"),
            (
                "time, z\n0, 0\n",
                ": a motion needs at least 2 rows below the titles, found 1",
            ),
            (
                "time, z\n0, 0\n1, 0,01\n",
                ", line 3: 3 values where the titles name 2 columns; commas part them, so that `0,01` is two",
            ),
            (
                "time; z\n0; 0\n1; 0,01\n",
                ", line 3, column `z`: `0,01` is not a number: it has a comma",
            ),
        ];
        for (text, expected) in cases {
            let (line, column, problem) = parse(text).unwrap_err();
            let error = MotionFileError {
                path: "t.csv".into(),
                line,
                column,
                problem,
            };
            let found = error.to_string();
            assert!(found.starts_with(&format!("t.csv{expected}")), "{text:?}: {found}");
        }
    }

    #[test]
    fn a_file_that_is_not_there_is_told() {
        let error = read_motion_file(Path::new("no-such-table.csv"))
            .unwrap_err()
            .to_string();
        assert!(error.starts_with("no-such-table.csv: cannot be read"), "{error}");
    }
}
