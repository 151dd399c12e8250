//! `demeter plot`: columns of what runs left, as SVG or PNG.

use crate::answer::{Rows, answer, answer_json, note};
use crate::arguments::PlotArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::readable::word;
use crate::suggestion::did_you_mean;
use demeter::output::{AxisSpec, Look, Plot, Series};
use demeter::results::{BIN, Column, Columns, IN_BIN, ResultsError, Run};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Folders of a run that hold tables.
const FOLDERS: [&str; 6] = ["distributions", "profiles", "fields", "paths", "chains", "removals"];

/// Draws columns, or lists them.
pub fn plot(arguments: &PlotArguments) -> Result<Exit, Failure> {
    let Some(x) = &arguments.x else {
        list(arguments)?;
        return Ok(Exit::Finished);
    };
    let mut tables = Vec::new();
    for path in std::iter::once(&arguments.run).chain(&arguments.with) {
        let table = read(path)?;
        let asks = |name: &str| table.has_bins() && table.find(name).is_none() && [BIN, IN_BIN].contains(&name);
        let of_bins = asks(x) || arguments.y.iter().any(|y| asks(signed(y).1));
        let table = if of_bins { table.bins_as_rows()? } else { table };
        tables.push((name_of(path), table));
    }
    let drawing = Drawing { arguments, x };
    let plot = drawing.plot(&tables)?;
    let out = arguments.out.clone().unwrap_or_else(|| default_name(x, &arguments.y));
    write(&plot, &out)?;
    let shown = out.display().to_string();
    if arguments.json {
        let is_drawn = |point: &&(f64, f64)| point.0.is_finite() && point.1.is_finite();
        let points: usize = (plot.series.iter())
            .map(|series| series.points.iter().filter(is_drawn).count())
            .sum();
        answer_json(&json!({ "file": shown, "lines": plot.series.len(), "points": points }))?;
    } else {
        answer(&format!("wrote {shown}\n"))?;
    }
    Ok(Exit::Finished)
}

/// The series of a run, or a table.
fn read(path: &Path) -> Result<Columns, Failure> {
    if path.is_dir() {
        let run = Run::open(path)?;
        let Some(series) = run.series()? else {
            let gone = run.missing_series()?;
            let problem = gone.unwrap_or_else(|| "the run has no series yet".to_string());
            return Err(Failure::wrong(format!("`{}`: {problem}", path.display())));
        };
        warn_of_shortfall(&run, &series)?;
        return Ok(series);
    }
    if !path.exists() {
        return Err(Failure::wrong(format!(
            "there is no run and no file `{}`",
            path.display()
        )));
    }
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("toml") => Err(Failure::wrong(format!(
            "`{0}` is a scenario, no table; `demeter run {0}` makes a run of it, and `demeter plot RUN` lists what can be plotted",
            path.display()
        ))),
        Some("pvd" | "vtu" | "vtp") => Err(Failure::wrong(format!(
            "`{}` holds frames for ParaView, no table; `demeter render RUN` draws them, and `demeter plot RUN` lists what can be plotted",
            path.display()
        ))),
        _ => Ok(Columns::read(path)?),
    }
}

/// Warns of rows that the series of a finished run lacks.
pub fn warn_of_shortfall(run: &Run, series: &Columns) -> Result<(), Failure> {
    match run.shortfall(series) {
        Ok(None) => {}
        Ok(Some(problem)) => note(&format!("warning: `{}`: {problem}", series.path().display())),
        // a summary that is damaged takes nothing from the rows
        Err(error @ ResultsError::Table { .. }) => note(&format!("warning: {error}")),
        Err(error) => return Err(error.into()),
    }
    Ok(())
}

/// A short name of a run or table.
fn name_of(path: &Path) -> String {
    // the folders of a sweep have values in their names: what is behind their last dot is no ending
    let name = if path.is_dir() {
        path.file_name()
    } else {
        path.file_stem()
    };
    let name = name.map_or_else(
        || path.display().to_string(),
        |name| name.to_string_lossy().into_owned(),
    );
    match (name.as_str(), path.parent().and_then(Path::file_name)) {
        ("series", Some(folder)) => folder.to_string_lossy().into_owned(),
        _ => name,
    }
}

/// Writes by the ending of the name.
pub fn write(plot: &Plot, out: &Path) -> Result<(), Failure> {
    let ending = out.extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let written = match ending.as_deref() {
        Some("svg") => plot.write_svg(out),
        Some("png") => plot.write_png(out),
        _ => {
            let message = format!("`{}` ends with neither .svg nor .png; name it so", out.display());
            return Err(Failure::wrong(message));
        }
    };
    written.map_err(|error| Failure::io(error.to_string()))
}

pub fn default_name(x: &str, y: &[String]) -> PathBuf {
    let stem = |text: &str| {
        let text = text.split(" [").next().unwrap_or(text).trim_start_matches('-');
        let words = text
            .split(|c: char| !c.is_alphanumeric())
            .filter(|word| !word.is_empty());
        words.collect::<Vec<_>>().join("-").to_lowercase()
    };
    let names: Vec<String> = y.iter().take(3).map(|y| stem(y)).collect();
    PathBuf::from(format!("{}-over-{}.svg", names.join("-"), stem(x)))
}

/// Lists the columns, and the other tables of a run.
fn list(arguments: &PlotArguments) -> Result<(), Failure> {
    let columns = read(&arguments.run)?;
    if columns.all().iter().all(|column| column.numbers().is_none()) {
        return Err(Failure::wrong(format!(
            "`{}` is no table: it has no column of numbers. The series of a run, its profiles and distributions are tables, and CSV files \
             whose first line tells titles",
            columns.path().display()
        )));
    }
    let others = other_tables(&arguments.run);
    if arguments.json {
        let one = |column: &Column| json!({ "name": column.name(), "unit": column.unit(), "words": column.numbers().is_none() });
        let all: Vec<Value> = columns.all().iter().map(one).collect();
        return answer_json(&json!({ "columns": all, "rows": columns.rows(), "tables": others }));
    }
    let mut rows = Rows::default();
    for column in columns.without_bins() {
        let unit = match column.numbers() {
            Some(_) => column.unit(),
            None => "words",
        };
        rows.add(column.name(), unit);
    }
    if columns.has_bins() {
        rows.add(BIN, columns.unit_of_bins());
        rows.add(IN_BIN, "");
    }
    answer(&rows.lines())?;
    let numeric = || {
        columns
            .without_bins()
            .filter(|column| column.numbers().is_some())
            .map(Column::name)
    };
    let numbers = |name: &'static str| numeric().any(|known| known == name).then_some(name);
    let of_bins = columns.has_bins().then_some((BIN, IN_BIN));
    let usual = of_bins.or_else(|| numbers("time").zip(numbers("kinetic energy")));
    let mut first = numeric();
    if let Some((x, y)) = usual.or_else(|| first.next().zip(first.next())) {
        let [x, y] = [x, y].map(word);
        note(&format!(
            "draw two with `demeter plot {} {x} {y}`",
            word(arguments.run.display())
        ));
    }
    for table in others {
        note(&format!("more columns: `demeter plot {}`", word(table)));
    }
    Ok(())
}

/// Paths of the tables of a run beside its series.
fn other_tables(run: &Path) -> Vec<String> {
    let mut tables = Vec::new();
    for folder in FOLDERS {
        let entries = std::fs::read_dir(run.join(folder)).into_iter().flatten().flatten();
        let paths = entries
            .map(|entry| entry.path())
            .filter(|path| path.extension().is_some_and(|e| e == "csv"));
        tables.extend(paths.map(|path| path.display().to_string()));
    }
    tables.sort();
    tables
}

/// Rows that are drawn as one line, and what tells them apart.
type Moment = (Option<String>, Vec<usize>);

/// What is drawn of tables.
struct Drawing<'a> {
    arguments: &'a PlotArguments,
    x: &'a str,
}

impl Drawing<'_> {
    fn plot(&self, tables: &[(String, Columns)]) -> Result<Plot, Failure> {
        let log = self.arguments.log.as_deref().unwrap_or_default();
        let x = axis(log.contains('x'), "--x-range", self.arguments.x_range.as_deref())?;
        let y = axis(log.contains('y'), "--y-range", self.arguments.y_range.as_deref())?;
        let mut series = Vec::new();
        for (name, table) in tables {
            for asked in &self.arguments.y {
                let several = (tables.len() > 1, self.arguments.y.len() > 1);
                series.extend(self.series(table, name, asked, several)?);
            }
        }
        let points: usize = series.iter().map(|line| line.points.len()).sum();
        let all = || series.iter().flat_map(|line| &line.points);
        // cells without a number alone are usual in series
        if all().any(|point| point.0.is_infinite() || point.1.is_infinite()) {
            let left_out = all()
                .filter(|point| !(point.0.is_finite() && point.1.is_finite()))
                .count();
            note(&format!(
                "warning: {left_out} of {points} points are left out: they are infinite or no numbers"
            ));
        }
        let mut without_logarithm = 0;
        for line in &mut series {
            without_logarithm += cut(&mut line.points, x, y);
        }
        if without_logarithm > 0 {
            note(&format!(
                "warning: {without_logarithm} of {points} points are left out: they are not above 0, and --log {log} has no place for them"
            ));
        }
        if series
            .iter()
            .all(|line| line.points.iter().all(|p| !(p.0.is_finite() && p.1.is_finite())))
        {
            return Err(Failure::wrong(
                "there is nothing to draw: no row has numbers in these columns and ranges",
            ));
        }
        let (_, table) = &tables[0];
        let title = |name: &str| column(table, name).map(|column| column.title.clone());
        Ok(Plot {
            title: self.arguments.title.clone().unwrap_or_else(|| tables[0].0.clone()),
            x_label: title(self.x)?,
            y_label: self.y_label(table)?,
            x,
            y,
            series,
        })
    }

    /// Name and unit of the one column, or the unit that all have.
    fn y_label(&self, table: &Columns) -> Result<String, Failure> {
        if let [only] = &self.arguments.y[..] {
            let (sign, name) = signed(only);
            return Ok(format!("{sign}{}", column(table, name)?.title));
        }
        let mut units = Vec::new();
        for asked in &self.arguments.y {
            units.push(column(table, signed(asked).1)?.unit());
        }
        units.dedup();
        match units[..] {
            [""] | [] => Ok(String::new()),
            [unit] => Ok(format!("[{unit}]")),
            _ => {
                note("the columns have different units; the legend names them");
                Ok(String::new())
            }
        }
    }

    /// The lines of a column: one, or one for every moment.
    fn series(&self, table: &Columns, run: &str, asked: &str, several: (bool, bool)) -> Result<Vec<Series>, Failure> {
        let (sign, name) = signed(asked);
        let factor = if sign.is_empty() { 1.0 } else { -1.0 };
        let (x, y) = (numbers(table, self.x)?, numbers(table, name)?);
        let title = &column(table, name)?.title;
        let label = match several {
            (true, true) => format!("{run}: {sign}{title}"),
            (true, false) => run.to_owned(),
            (false, _) => format!("{sign}{title}"),
        };
        let look = if self.arguments.points {
            Look::Circles
        } else {
            Look::Line
        };
        let mut lines = Vec::new();
        for (moment, rows) in self.moments(table)? {
            let points = rows.iter().map(|&row| (x[row], factor * y[row])).collect();
            let name = moment.map_or_else(|| label.clone(), |moment| format!("{label}, {moment}"));
            lines.push(Series {
                look,
                ..Series::line(name, points)
            });
        }
        Ok(lines)
    }

    /// The rows that are drawn as lines of their own. A table that tells a step more than once holds moments; where words tell rows of one
    /// step apart (`grains` and `walls` of a distribution), each word has lines of its own.
    fn moments(&self, table: &Columns) -> Result<Vec<Moment>, Failure> {
        let steps = table.find("step").and_then(Column::numbers).unwrap_or_default();
        let differs = |c: &&Column| (1..steps.len()).any(|r| steps[r] == steps[r - 1] && c.word(r) != c.word(r - 1));
        let Some(kinds) = table.all().iter().find(differs) else {
            return self.moments_of(table, (0..table.rows()).collect(), steps);
        };
        let mut by_word: Vec<(&str, Vec<usize>)> = Vec::new();
        for row in 0..table.rows() {
            let word = kinds.word(row).unwrap_or_default();
            match by_word.iter_mut().find(|(known, _)| *known == word) {
                Some((_, rows)) => rows.push(row),
                None => by_word.push((word, vec![row])),
            }
        }
        let mut moments = Vec::new();
        for (word, rows) in by_word {
            for (moment, rows) in self.moments_of(table, rows, steps)? {
                let name = moment.map_or_else(|| word.to_owned(), |moment| format!("{word}, {moment}"));
                moments.push((Some(name), rows));
            }
        }
        Ok(moments)
    }

    /// The same of some rows.
    fn moments_of(&self, table: &Columns, rows: Vec<usize>, steps: &[f64]) -> Result<Vec<Moment>, Failure> {
        let mut spans: Vec<(f64, Vec<usize>)> = Vec::new();
        for &row in rows.iter().take_while(|row| **row < steps.len()) {
            match spans.last_mut() {
                Some((last, rows)) if *last == steps[row] => rows.push(row),
                _ => spans.push((steps[row], vec![row])),
            }
        }
        if spans.iter().all(|(_, rows)| rows.len() == 1) {
            if !["last", "all"].contains(&self.arguments.at.as_str()) {
                let path = table.path().display();
                let instead = if table.has_bins() {
                    format!("`demeter plot {path} {BIN} {}` draws its bins", word(IN_BIN))
                } else {
                    "`--x-range` shows a part of it".to_owned()
                };
                return Err(Failure::wrong(format!(
                    "--at is for distributions and profiles: `{path}` has one row at a time; {instead}"
                )));
            }
            return Ok(vec![(None, rows)]);
        }
        match self.arguments.at.as_str() {
            "all" => Ok(spans
                .into_iter()
                .map(|(step, rows)| (Some(format!("step {step}")), rows))
                .collect()),
            "last" => Ok(spans.pop().map(|(_, rows)| (None, rows)).into_iter().collect()),
            text => {
                let asked: Option<f64> = text.parse::<u64>().ok().map(|step| step as f64);
                let found = spans.iter().find(|(step, _)| Some(*step) == asked);
                let (first, last) = (spans[0].0, spans[spans.len() - 1].0);
                found.map(|(_, rows)| vec![(None, rows.clone())]).ok_or_else(|| {
                    let there = spans.len();
                    Failure::wrong(format!(
                        "--at: there is no step `{text}`; there are {there}, from {first} to {last}, and `last` and `all`"
                    ))
                })
            }
        }
    }
}

/// A sign and the name behind it.
fn signed(asked: &str) -> (&str, &str) {
    asked.strip_prefix('-').map_or(("", asked), |name| ("-", name))
}

fn axis(logarithmic: bool, flag: &str, range: Option<&str>) -> Result<AxisSpec, Failure> {
    let read = |text: &str| -> Option<(f64, f64)> {
        let (low, high) = text.split_once("..")?;
        let range = (low.trim().parse().ok()?, high.trim().parse().ok()?);
        let (low, high): (f64, f64) = range;
        let positive = !logarithmic || low > 0.0;
        (low < high && low.is_finite() && high.is_finite() && positive).then_some(range)
    };
    let range = range.map(|text| {
        let positive = if logarithmic {
            " above 0, since the axis is logarithmic"
        } else {
            ""
        };
        let wrong =
            format!("{flag}: `{text}` is no range; give two numbers{positive}, the smaller first, as `0.1..2.5`");
        read(text).ok_or_else(|| Failure::wrong(wrong))
    });
    Ok(AxisSpec {
        logarithmic,
        range: range.transpose()?,
    })
}

/// Breaks lines where they leave the ranges, and where values have no logarithm; tells how many these are.
fn cut(points: &mut [(f64, f64)], x: AxisSpec, y: AxisSpec) -> usize {
    let inside = |value: f64, axis: AxisSpec| axis.range.is_none_or(|(low, high)| (low..=high).contains(&value));
    let has_no_place = |value: f64, axis: AxisSpec| axis.logarithmic && value <= 0.0;
    let mut without_logarithm = 0;
    for point in points {
        let is_without = has_no_place(point.0, x) || has_no_place(point.1, y);
        without_logarithm += usize::from(is_without);
        if is_without || !(inside(point.0, x) && inside(point.1, y)) {
            *point = (f64::NAN, f64::NAN);
        }
    }
    without_logarithm
}

fn column<'t>(table: &'t Columns, name: &str) -> Result<&'t Column, Failure> {
    table.required(name).map_err(|error| {
        let ResultsError::NoColumn { .. } = error else {
            return error.into();
        };
        let meant = match Path::new(name).exists() {
            true => " It is a file or a folder: runs beside the first are named behind `--with`.".to_owned(),
            false => did_you_mean(name, table.all().iter().map(Column::name)),
        };
        let file = table.path();
        let folder = file.parent().filter(|_| file.ends_with("series.csv"));
        let path = folder.unwrap_or(file).display();
        Failure::wrong(format!(
            "`{path}` has no column `{name}`.{meant} `demeter plot {path}` lists them"
        ))
    })
}

fn numbers<'t>(table: &'t Columns, name: &str) -> Result<&'t [f64], Failure> {
    let column = column(table, name)?;
    column.numbers().ok_or_else(|| {
        let example = column.word(0).unwrap_or_default();
        Failure::wrong(format!(
            "column `{name}` holds words, such as `{example}`, which cannot be drawn; name one of numbers"
        ))
    })
}

impl From<ResultsError> for Failure {
    fn from(error: ResultsError) -> Self {
        let message = error.to_string();
        if error.is_io() {
            Self::io(message)
        } else {
            Self::wrong(message)
        }
    }
}
