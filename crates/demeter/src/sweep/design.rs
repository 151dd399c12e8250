//! What is varied: axes, whose combinations are the runs.

use super::error::SweepError;
use super::list::read_list;
use super::plan::MAX_RUNS;
use super::table::read_table;
use super::value::meaning;
use crate::scenario::{key_of, key_places, key_steps};
use std::collections::HashMap;
use std::path::PathBuf;

/// Keys that change together.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// The keys.
    pub keys: Vec<String>,
    /// Their values as written, row by row.
    pub rows: Vec<Vec<String>>,
    /// The option that told them.
    pub told_by: String,
    /// Whether the values have equal ratios.
    pub logarithmic: bool,
}

/// What is varied, as it is told on the command line.
#[derive(Clone, Debug, Default)]
pub struct Varied {
    /// `KEY=VALUES`: every value with every value of the others.
    pub vary: Vec<String>,
    /// `KEY=VALUES`: the first values go together, the second ones, ...
    pub zip: Vec<String>,
    /// A design of experiments.
    pub table: Option<PathBuf>,
    /// Number of seeds of every combination.
    pub repeat: Option<u32>,
    /// `KEY=VALUE` of all runs.
    pub set: Vec<String>,
}

impl Varied {
    /// The axes of the runs of a scenario, or everything that is wrong with them. Seeds count from that of the scenario.
    pub fn axes(&self, scenario: &str) -> Result<Vec<Axis>, SweepError> {
        let mut problems = Vec::new();
        let mut axes = Vec::new();
        let mut take = |axis: Result<Axis, String>| match axis {
            Ok(axis) => axes.push(axis),
            Err(problem) => problems.push(problem),
        };
        for told in &self.vary {
            take(one_key(told, "--vary"));
        }
        if !self.zip.is_empty() {
            take(zipped(&self.zip));
        }
        if let Some(path) = &self.table {
            take(read_table(path).map_err(|why| format!("--table: {why}")));
        }
        if let Some(repeat) = self.repeat {
            take(Ok(seeds(seed_in(scenario), repeat)));
        }
        problems.extend(axes.iter().filter_map(repeated_row));
        problems.extend(self.lost_keys(&axes, scenario));
        let mut lengths = axes.iter().map(|axis| axis.rows.len() as u64);
        let runs = lengths.try_fold(1_u64, u64::checked_mul);
        if runs.is_none_or(|runs| runs > MAX_RUNS as u64) {
            let runs = runs.map_or_else(|| "more than 1e19".to_string(), |runs| runs.to_string());
            problems.push(format!(
                "these are {runs} runs; a sweep has at most {MAX_RUNS}. Vary less at once, or tell a --table"
            ));
        }
        if axes.is_empty() && problems.is_empty() {
            problems.push("nothing is varied: tell --vary KEY=VALUES, --zip, --table or --repeat".to_string());
        }
        if problems.is_empty() {
            Ok(axes)
        } else {
            Err(SweepError::Told { problems })
        }
    }

    /// Keys that would be lost below others.
    fn lost_keys(&self, axes: &[Axis], scenario: &str) -> Vec<String> {
        let mut problems = Vec::new();
        let varied: Vec<(&str, &str)> = axes
            .iter()
            .flat_map(|axis| axis.keys.iter().map(|key| (key.as_str(), axis.told_by.as_str())))
            .collect();
        let set: Vec<&str> = self.set.iter().map(|set| key_of(set)).collect();
        let keys: Vec<&str> = varied.iter().map(|(key, _)| *key).chain(set.iter().copied()).collect();
        let places = key_places(scenario, &keys);
        let lies_in = |inner: usize, outer: usize| match (&places[inner], &places[outer]) {
            (Some(inner), Some(outer)) => inner.starts_with(outer),
            _ => keys[inner] == keys[outer],
        };
        for (k, (key, option)) in varied.iter().enumerate() {
            for (l, (other, other_option)) in varied.iter().enumerate().skip(k + 1) {
                if lies_in(k, l) || lies_in(l, k) {
                    problems.push(format!(
                        "`{key}` ({option}) and `{other}` ({other_option}) tell the same key, or one tells a part of the other"
                    ));
                }
            }
            for (_, set) in (varied.len()..).zip(&set).filter(|(n, _)| lies_in(*n, k)) {
                problems.push(format!(
                    "--set `{set}` would have no effect: `{key}` is varied by {option}"
                ));
            }
        }
        problems
    }
}

/// The seed that a scenario tells; 1 when it tells none, as for a run.
fn seed_in(text: &str) -> u64 {
    let table: Option<toml::Table> = text.parse().ok();
    let seed = table.and_then(|table| table.get("seed")?.as_integer());
    seed.and_then(|seed| u64::try_from(seed).ok()).unwrap_or(1)
}

/// Reads `KEY=VALUES`.
fn one_key(told: &str, option: &str) -> Result<Axis, String> {
    let Some((key, values)) = told.split_once('=') else {
        return Err(format!(
            "{option} `{told}` has no `=`: it is told as KEY=VALUES, as `grains[0].count=500,1000`"
        ));
    };
    let key = key.trim();
    if key_steps(key).is_none() {
        return Err(format!("{option}: `{key}` is not a key"));
    }
    let list = read_list(values).map_err(|why| format!("{option} `{key}`: {why}"))?;
    Ok(Axis {
        keys: vec![key.to_string()],
        rows: list.values.into_iter().map(|value| vec![value]).collect(),
        told_by: option.to_string(),
        logarithmic: list.logarithmic,
    })
}

/// Keys whose values go together.
fn zipped(told: &[String]) -> Result<Axis, String> {
    let axes: Vec<Axis> = told
        .iter()
        .map(|told| one_key(told, "--zip"))
        .collect::<Result<_, _>>()?;
    let lengths: Vec<String> = axes
        .iter()
        .map(|axis| format!("`{}` has {}", axis.keys[0], axis.rows.len()))
        .collect();
    let length = axes.first().map_or(0, |axis| axis.rows.len());
    if axes.iter().any(|axis| axis.rows.len() != length) {
        return Err(format!(
            "--zip: lists that go together must have the same number of values; {}",
            lengths.join(", ")
        ));
    }
    let row = |k: usize| axes.iter().map(|axis| axis.rows[k][0].clone()).collect();
    Ok(Axis {
        keys: axes.iter().map(|axis| axis.keys[0].clone()).collect(),
        rows: (0..length).map(row).collect(),
        told_by: "--zip".to_string(),
        logarithmic: axes.first().is_some_and(|axis| axis.logarithmic),
    })
}

fn seeds(first: u64, count: u32) -> Axis {
    let seeds = (0..u64::from(count)).map(|k| vec![first.saturating_add(k).to_string()]);
    Axis {
        keys: vec!["seed".to_string()],
        rows: seeds.collect(),
        told_by: "--repeat".to_string(),
        logarithmic: false,
    }
}

/// Tells two rows that are the same, which would give the same bits.
fn repeated_row(axis: &Axis) -> Option<String> {
    let mut first: HashMap<Vec<String>, usize> = HashMap::new();
    let twins = axis.rows.iter().enumerate();
    let meant = |row: &[String]| row.iter().map(|value| meaning(value)).collect();
    let (row, earlier, at) = twins
        .filter_map(|(at, row)| Some((row, first.insert(meant(row), at)?, at)))
        .next()?;
    let keys = axis.keys.join("`, `");
    let remedy = "runs of the same values give the same bits; tell --repeat for several seeds";
    Some(match axis.told_by.as_str() {
        "--table" => format!(
            "--table: rows {} and {} below the header are the same; {remedy}, or add a column `seed`",
            earlier + 1,
            at + 1
        ),
        option => {
            let (row, twin) = (row.join(", "), axis.rows[earlier].join(", "));
            let as_written = if row == twin {
                String::new()
            } else {
                format!(", as {twin}")
            };
            format!("{option} `{keys}`: the value {row} is there twice{as_written}; {remedy}")
        }
    })
}

/// All combinations; the last axis changes fastest.
pub fn combinations(axes: &[Axis]) -> Vec<Vec<String>> {
    axes.iter().fold(vec![Vec::new()], |runs, axis| {
        let longer = |run: &Vec<String>| {
            let run = run.clone();
            axis.rows.iter().map(move |row| [run.as_slice(), row].concat())
        };
        runs.iter().flat_map(longer).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn owned(texts: &[&str]) -> Vec<String> {
        texts.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn axes_combine_and_lists_of_zip_go_together() {
        let varied = Varied {
            vary: owned(&["a=1,2"]),
            zip: owned(&["b=x,y", "c=3 mm,4 mm"]),
            repeat: Some(2),
            ..Varied::default()
        };
        let axes = varied.axes("seed = 7").unwrap();
        let runs = combinations(&axes);
        assert_eq!(runs.len(), 8);
        assert_eq!(runs[0], ["1", "x", "3 mm", "7"]);
        assert_eq!(runs[1], ["1", "x", "3 mm", "8"]);
        assert_eq!(runs[2], ["1", "y", "4 mm", "7"]);
        assert_eq!(runs[7], ["2", "y", "4 mm", "8"]);
    }

    #[test]
    fn all_that_is_wrong_is_told_at_once() {
        let varied = Varied {
            vary: owned(&[
                "a",
                "b=1,,2",
                "c=1,1",
                "c.d=0.2,1,0.20",
                "c.e=4 mm,4000 um",
                "c.f=1 m,1 kg,1",
                "d=1..5",
                "e.f=1,2",
                "e=3",
                "g[0].h=1",
                "g.0.h=2",
                "g.fine.h=3",
                "=1",
            ]),
            zip: owned(&["x=1,2", "y=1,2,3"]),
            table: Some("absent.csv".into()),
            repeat: None,
            set: owned(&["e.f.k=5", "e=7", "g.fine.h=4"]),
        };
        let scenario = "[[g]]\nname = \"fine\"\nh = 1\n";
        let text = varied.axes(scenario).unwrap_err().to_string();
        assert!(!text.contains("`c.f`: the value"), "{text}");
        for expected in [
            "--vary `a` has no `=`",
            "--vary `b`: a value is missing",
            "`c`: the value 1 is there twice;",
            "`c.d`: the value 0.20 is there twice, as 0.2;",
            "`c.e`: the value 4000 um is there twice, as 4 mm;",
            "--vary `d`: `1..5`: the number of values is missing",
            "`e.f` (--vary) and `e` (--vary) tell the same key, or one",
            "`g[0].h` (--vary) and `g.0.h` (--vary)",
            "`g[0].h` (--vary) and `g.fine.h` (--vary)",
            "--set `g.fine.h` would have no effect: `g[0].h` is varied",
            "`` is not a key",
            "`x` has 2, `y` has 3",
            "absent.csv",
            "--set `e.f.k` would have no effect: `e.f` is varied",
            "--set `e` would have no effect: `e` is varied",
        ] {
            assert!(text.contains(expected), "no `{expected}`:\n{text}");
        }
        assert!(
            Varied::default()
                .axes("")
                .unwrap_err()
                .to_string()
                .contains("nothing is varied")
        );
        let many = Varied {
            vary: owned(&["a=1..2:5000", "b=1..2:5000"]),
            ..Varied::default()
        };
        assert!(many.axes("").unwrap_err().to_string().contains("25000000 runs"));
        let all = Varied {
            vary: ["a", "b", "c", "d", "e", "f"]
                .map(|key| format!("{key}=1..2:5000"))
                .to_vec(),
            ..Varied::default()
        };
        let text = all.axes("").unwrap_err().to_string();
        assert!(text.contains("these are more than 1e19 runs"), "{text}");
    }
}
