//! Results of a run that a user picks: `mean:coordination@settle`.

use crate::compare::is_repeat;
use crate::results::{Columns, ResultsError, column_name, nearest, position_of};
use crate::scenario::units;
use demeter_physics::dimension::Dimension;

/// The column of the series that holds words.
const WORDS: &str = "stage";

/// What is told of the values of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// The first.
    First,
    /// The last.
    Last,
    /// The mean over time: rows follow each other at times that may differ, and the column goes straight from one to the next.
    Mean,
    /// The standard deviation over time, likewise.
    Deviation,
    /// The least.
    Min,
    /// The largest.
    Max,
    /// How fast it rises: what it gains between rows that follow each other, over the time between these.
    Rate,
}

/// A value that is told.
struct Told {
    value: f64,
    /// Time that it stands for: half of that to the row before, and half of that to the next [s].
    time: f64,
    /// What it is more than in the row before; 0 where that does not count.
    rise: f64,
}

impl What {
    /// All of them with their names.
    pub const ALL: [(&'static str, Self); 7] = [
        ("first", Self::First),
        ("last", Self::Last),
        ("mean", Self::Mean),
        ("deviation", Self::Deviation),
        ("min", Self::Min),
        ("max", Self::Max),
        ("rate", Self::Rate),
    ];

    fn name(self) -> &'static str {
        Self::ALL
            .iter()
            .find(|(_, what)| *what == self)
            .map_or("", |(name, _)| name)
    }

    /// Of values that are no NaN.
    fn of(self, values: &[Told]) -> f64 {
        let whole: f64 = values.iter().map(|told| told.time).sum();
        let mean = |of: &dyn Fn(f64) -> f64| match whole > 0.0 {
            true => values.iter().map(|told| of(told.value) * told.time).sum::<f64>() / whole,
            false => values.iter().map(|told| of(told.value)).sum::<f64>() / values.len() as f64,
        };
        let each = || values.iter().map(|told| told.value);
        match self {
            _ if values.is_empty() => f64::NAN,
            Self::First => values[0].value,
            Self::Last => values[values.len() - 1].value,
            Self::Mean => mean(&|value| value),
            Self::Deviation => {
                // counted from one of them, so that equal values have none
                let first = values[0].value;
                let middle = mean(&|value| value - first);
                mean(&|value| (value - first - middle).powi(2)).sqrt()
            }
            Self::Min => each().fold(f64::INFINITY, f64::min),
            Self::Max => each().fold(f64::NEG_INFINITY, f64::max),
            // of one row there is none
            Self::Rate => values.iter().map(|told| told.rise).sum::<f64>() / whole,
        }
    }

    /// The unit of what is told of a column with this one.
    fn unit(self, of_column: Option<&str>) -> Option<String> {
        match (self, of_column) {
            (Self::Rate, None) => Some("1/s".to_string()),
            (Self::Rate, Some("J")) => Some("W".to_string()),
            (Self::Rate, Some(unit)) => Some(match unit.strip_suffix("/s") {
                Some(_) => format!("{unit}^2"),
                None => format!("{unit}/s"),
            }),
            (_, unit) => unit.map(str::to_string),
        }
    }
}

/// Which rows of the series are looked at.
#[derive(Clone, Debug, PartialEq)]
enum Rows {
    All,
    /// Those of a stage and its repeats.
    Stage(String),
    /// Those between two times [s].
    Times(f64, f64),
}

/// A result of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Metric {
    /// What is told.
    pub what: What,
    /// Column of the series, as it was named.
    pub column: String,
    rows: Rows,
    /// The rows as they were told.
    place: String,
}

impl Metric {
    /// Reads `WHAT:COLUMN@WHERE`; without `WHAT:` it is the last value, and `@WHERE` names a stage or two times.
    pub fn read(told: &str) -> Result<Self, String> {
        let known = || What::ALL.map(|(name, _)| name).join("`, `");
        let (rest, place) = told.rsplit_once('@').unwrap_or((told, ""));
        let (what, column) = match rest.split_once(':') {
            None => (What::Last, rest),
            Some((name, column)) => {
                let found = What::ALL.iter().find(|(known, _)| *known == name.trim());
                let found = found.ok_or_else(|| {
                    format!(
                        "result `{told}`: `{name}` is none of `{}`; as `mean:coordination`",
                        known()
                    )
                })?;
                (found.1, column)
            }
        };
        let (column, place) = (column.trim(), place.trim());
        if column.is_empty() || (told.contains('@') && place.is_empty()) {
            return Err(format!(
                "result `{told}` names no column, or no stage; write WHAT:COLUMN@STAGE, as `mean:coordination@settle`, where \
                 WHAT is one of `{}`, and WHAT: and @STAGE may be left out",
                known()
            ));
        }
        let rows = match place.split_once("..") {
            None if place.is_empty() => Rows::All,
            None => Rows::Stage(place.to_string()),
            Some((from, to)) => {
                let time = |text: &str| {
                    let parsed = units::parse(text)
                        .ok()
                        .filter(|quantity| quantity.dimension == Dimension::TIME);
                    let help = format!("result `{told}`: `{}` is no time; write `0.1 s..0.5 s`", text.trim());
                    parsed.map(|quantity| quantity.value).ok_or(help)
                };
                let (from, to) = (time(from)?, time(to)?);
                if from > to {
                    return Err(format!("result `{told}`: the smaller time first"));
                }
                Rows::Times(from, to)
            }
        };
        Ok(Self {
            what,
            column: column.to_string(),
            rows,
            place: place.to_string(),
        })
    }

    /// Whether it is a column of the last row, which is told of every run.
    pub fn is_last(&self) -> bool {
        self.what == What::Last && self.rows == Rows::All
    }

    /// Its title in the table of results; `title` is that of the column, with its unit.
    pub fn title(&self, title: &str) -> String {
        if self.is_last() {
            return title.to_string();
        }
        let (name, unit) = title
            .split_once(" [")
            .map_or((title, None), |(name, unit)| (name, Some(unit.trim_end_matches(']'))));
        let place = if self.place.is_empty() {
            String::new()
        } else {
            format!(" in {}", self.place)
        };
        let unit = self.what.unit(unit).map_or(String::new(), |unit| format!(" [{unit}]"));
        format!("{} {name}{place}{unit}", self.what.name())
    }

    /// What is wrong with it for runs with these columns and stages, which end at `latest` at the latest [s]; 0 where that is not known.
    pub fn problem(&self, titles: &[String], stages: &[&str], latest: f64) -> Option<String> {
        if position_of(titles, &self.column).is_none() {
            let help = nearest(&self.column, titles.iter().map(|title| column_name(title)));
            return Some(format!(
                "the series of these runs has no column `{}`; {help}",
                self.column
            ));
        }
        if column_name(&self.column) == WORDS {
            return Some(format!(
                "the column `{WORDS}` holds words, of which there is no number to tell"
            ));
        }
        match &self.rows {
            Rows::Stage(stage) if !stages.iter().any(|name| is_repeat(name, stage)) => {
                let help = nearest(stage, stages.iter().copied());
                Some(format!("the scenario has no stage `{stage}`; {help}"))
            }
            // the last row lies within a step of the end
            Rows::Times(from, _) if latest > 0.0 && *from > latest * (1.0 + 1e-9) => Some(format!(
                "these runs end at {latest:.6} s at the latest: no row of the series lies in `{}`",
                self.place
            )),
            _ => None,
        }
    }

    /// Its title and value in a series; NaN where there are no values.
    pub fn of(&self, series: &Columns) -> Result<(String, f64), ResultsError> {
        let column = series.required(&self.column)?;
        let values = series.numbers(&self.column)?;
        let times = series.numbers("time")?;
        let stages = series.words("stage")?;
        // the row of a time is that of the step nearest to it
        let half = 0.5 * longest_step(series, times) * (1.0 + 1e-9);
        let counts = |row: &usize| match &self.rows {
            Rows::All => true,
            Rows::Stage(stage) => is_repeat(stages[*row], stage),
            Rows::Times(from, to) => (from - half..=to + half).contains(&times[*row]),
        };
        let is_told = |row: &usize| counts(row) && !values[*row].is_nan();
        let mut told: Vec<Told> = Vec::new();
        let mut before: Option<usize> = None;
        for row in (0..series.rows()).filter(is_told) {
            // what lies between two rows of which one does not count is not known
            let since = |column: &[f64]| {
                let before = before.filter(|before| before + 1 == row);
                before.map_or(0.0, |before| column[row] - column[before])
            };
            let half = 0.5 * since(times);
            if let Some(last) = told.last_mut() {
                last.time += half;
            }
            told.push(Told {
                value: values[row],
                time: half,
                rise: since(values),
            });
            before = Some(row);
        }
        Ok((self.title(&column.title), self.what.of(&told)))
    }
}

/// The longest time step in a series whose rows are at these times [s]; 0 where it tells no steps.
fn longest_step(series: &Columns, times: &[f64]) -> f64 {
    let Ok(steps) = series.numbers("step") else { return 0.0 };
    let between = steps.windows(2).zip(times.windows(2));
    let each = between.map(|(steps, times)| (times[1] - times[0]) / (steps[1] - steps[0]));
    each.filter(|step| step.is_finite()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_read_and_titled() {
        let cases = [
            ("coordination", "coordination", "coordination"),
            ("mean:coordination", "coordination", "mean coordination"),
            (
                "max: wall top force z @ squeeze",
                "wall top force z [N]",
                "max wall top force z in squeeze [N]",
            ),
            (
                "min:max speed@20 ms..0.1 s",
                "max speed [m/s]",
                "min max speed in 20 ms..0.1 s [m/s]",
            ),
            ("rate:contacts", "contacts", "rate contacts [1/s]"),
            (
                "rate:wall shell work",
                "wall shell work [J]",
                "rate wall shell work [W]",
            ),
            ("rate:max speed", "max speed [m/s]", "rate max speed [m/s^2]"),
        ];
        for (told, title, expected) in cases {
            let metric = Metric::read(told).unwrap();
            assert_eq!(metric.title(title), expected, "{told}");
        }
        for (told, expected) in [
            ("", "names no column"),
            ("mean:", "names no column"),
            ("mean:x@", "names no column, or no stage"),
            ("median:x", "`median` is none of `first`, `last`, `mean`"),
            ("x@1..2 s", "`1` is no time"),
            ("x@0.1 s..20 ms", "the smaller time first"),
        ] {
            let fault = Metric::read(told).unwrap_err();
            assert!(fault.contains(expected), "{told}: {fault}");
        }
    }

    #[test]
    fn a_series_is_looked_at_by_stage_and_time() {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("series.csv");
        let rows =
            "step,time [s],stage,f [N]\n0,0,fill,NaN\n1,1,press 1,2\n2,2,press 1,4\n3,3,press 2,9\n4,4,rest,-1\n";
        std::fs::write(&path, rows).unwrap();
        let series = Columns::read(&path).unwrap();
        let value = |told: &str| Metric::read(told).unwrap().of(&series).unwrap().1;
        assert_eq!([value("f"), value("first:f"), value("last:f@press")], [-1.0, 2.0, 9.0]);
        assert_eq!(
            [value("mean:f@press"), value("max:f"), value("min:f")],
            [4.75, 9.0, -1.0]
        );
        assert_eq!([value("mean:f@1 s..2 s"), value("deviation:f@press 1")], [3.0, 1.0]);
        assert!(value("mean:f@fill").is_nan());
        let equal: String = (0..7).map(|k| format!("{k},{},a,0.1\n", 0.3 * f64::from(k))).collect();
        std::fs::write(&path, "step,time [s],stage,f [N]\n".to_string() + &equal).unwrap();
        let deviation = Metric::read("deviation:f").unwrap();
        assert_eq!(deviation.of(&Columns::read(&path).unwrap()).unwrap().1, 0.0);
        // a stage with few rows counts as long as it lasts, and one row alone is its own mean
        std::fs::write(&path, "time [s],stage,f [N]\n0,a,0\n1,a,1\n2,a,2\n10,b,10\n").unwrap();
        let uneven = Columns::read(&path).unwrap();
        let value = |told: &str| Metric::read(told).unwrap().of(&uneven).unwrap().1;
        assert_eq!(
            [value("mean:f"), value("mean:f@b"), value("mean:f@a")],
            [5.0, 10.0, 1.0]
        );
        // the rows of a stage and its repeats, not what is between these
        std::fs::write(
            &path,
            "time [s],stage,m [kg]\n0,a 1,1\n2,a 1,3\n3,b 1,9\n4,a 2,8\n6,a 2,12\n",
        )
        .unwrap();
        let repeats = Columns::read(&path).unwrap();
        let rate = |told: &str| Metric::read(told).unwrap().of(&repeats).unwrap();
        assert_eq!(rate("rate:m@a"), ("rate m in a [kg/s]".to_string(), 1.5));
        assert_eq!(rate("rate:m").1, 11.0 / 6.0);
        assert!(rate("rate:m@b").1.is_nan());
        // rows lie at the steps nearest to the times asked for
        std::fs::write(
            &path,
            "step,time [s],stage,f [N]\n0,0,a,0\n14,0.98,a,1\n29,2.03,a,2\n43,3.01,a,3\n57,3.99,a,4\n",
        )
        .unwrap();
        let nearest = Columns::read(&path).unwrap();
        let value = |told: &str| Metric::read(told).unwrap().of(&nearest).unwrap().1;
        assert_eq!([value("first:f@1 s..3 s"), value("last:f@1 s..3 s")], [1.0, 3.0]);
        assert_eq!(value("max:f@1.1 s..2.9 s"), 2.0);
        let value = |told: &str| Metric::read(told).unwrap().of(&series).unwrap().1;
        assert_eq!(value("mean:f@rest"), -1.0);
        let titles = ["time [s]", "stage", "f [N]"].map(str::to_string);
        let problem = |told: &str| {
            Metric::read(told)
                .unwrap()
                .problem(&titles, &["fill", "press 1", "press 2"], 4.0)
        };
        assert_eq!(problem("max:f@press"), None);
        assert!(problem("g").unwrap().contains("no column `g`"));
        assert!(problem("mean:stage").unwrap().contains("holds words"));
        assert!(problem("f@prss").unwrap().contains("no stage `prss`"));
        assert_eq!(problem("f@4 s..9 s"), None);
        assert!(
            problem("f@5 s..9 s")
                .unwrap()
                .contains("end at 4.000000 s at the latest")
        );
    }
}
