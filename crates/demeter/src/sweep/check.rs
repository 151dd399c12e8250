//! Reads and prepares the scenarios of all runs before the first one starts.

use super::error::SweepError;
use super::plan::{Estimate, Plan};
use crate::scenario::{Diagnostic, Diagnostics, InputFile, prepare, thread_pool};
use rayon::prelude::*;
use std::collections::HashMap;

/// Runs that are prepared before what is wrong with them is put together.
const AT_ONCE: usize = 32;
/// Most different faults that are kept.
const MOST_FAULTS: usize = 100;

/// What the scenarios of all runs tell.
#[derive(Clone, Debug, Default)]
pub struct Checked {
    /// What each run will need.
    pub estimates: Vec<Estimate>,
    /// What the user should know.
    pub warnings: Vec<SweepWarning>,
    /// Files that the scenarios name, each once.
    pub files: Vec<InputFile>,
}

/// A warning, and the runs that it is about.
#[derive(Clone, Debug, PartialEq)]
pub struct SweepWarning {
    /// What the first of the runs tells.
    pub text: String,
    /// Whether others tell the same with other numbers.
    pub numbers_differ: bool,
    /// The runs.
    pub runs: Vec<usize>,
}

/// A fault, and the runs that have it.
#[derive(Clone, Debug)]
pub struct SweepFault {
    /// What is wrong, as in the first of the runs.
    pub diagnostic: Diagnostic,
    /// The fault drawn with the line that it is in.
    pub drawn: String,
    /// The runs.
    pub runs: Vec<usize>,
}

/// Everything that is wrong with the scenarios of a sweep.
#[derive(Clone, Debug, Default)]
pub struct SweepFaults {
    /// Different faults, in the order in which the runs have them.
    pub faults: Vec<SweepFault>,
    /// How many more there are.
    pub left_out: usize,
    known: HashMap<String, usize>,
}

impl SweepFaults {
    fn add(&mut self, run: usize, found: &Diagnostics, colour: bool) {
        for diagnostic in found.list() {
            let Diagnostic {
                message,
                help,
                path,
                source,
                line,
                column,
                ..
            } = diagnostic;
            let what = format!("{message}\n{help:?}\n{path}\n{source}\n{line}\n{column}");
            if let Some(&at) = self.known.get(&what) {
                self.faults[at].runs.push(run);
            } else if self.faults.len() >= MOST_FAULTS {
                self.left_out += 1;
            } else {
                self.known.insert(what, self.faults.len());
                self.faults.push(SweepFault {
                    diagnostic: diagnostic.clone(),
                    drawn: found.render_one(diagnostic, colour),
                    runs: vec![run],
                });
            }
        }
    }
}

/// Reads and prepares all runs, or tells everything that is wrong with any of them. Faults are drawn with or without colours.
pub fn check(plan: &Plan, threads: usize, colour: bool) -> Result<Result<Checked, SweepFaults>, SweepError> {
    let pool = thread_pool(Some(threads))?;
    let mut checked = Checked::default();
    let mut faults = SweepFaults::default();
    let mut warned: HashMap<(String, usize), usize> = HashMap::new();
    let indices: Vec<usize> = (0..plan.runs.len()).collect();
    for chunk in indices.chunks(AT_ONCE) {
        let found: Vec<_> = pool.install(|| chunk.par_iter().map(|&run| check_one(plan, run)).collect());
        for (&run, found) in chunk.iter().zip(found) {
            match found {
                Ok((estimate, warnings, files)) => {
                    checked.estimates.push(estimate);
                    for file in files {
                        if !checked.files.iter().any(|known| known.path == file.path) {
                            checked.files.push(file);
                        }
                    }
                    add_warnings(run, warnings, &mut checked.warnings, &mut warned);
                }
                Err(found) => faults.add(run, &found, colour),
            }
        }
    }
    Ok(if faults.faults.is_empty() {
        Ok(checked)
    } else {
        Err(faults)
    })
}

/// Adds the warnings of a run to those that differ from them in numbers alone; what a run tells several times stays as many warnings. `known`
/// tells where each stands, by its words and how often the run had told these.
fn add_warnings(
    run: usize,
    told: Vec<String>,
    warnings: &mut Vec<SweepWarning>,
    known: &mut HashMap<(String, usize), usize>,
) {
    let mut often: HashMap<String, usize> = HashMap::new();
    for text in told {
        let words = without_numbers(&text);
        let count = often.entry(words.clone()).or_default();
        *count += 1;
        let at = *known.entry((words, *count)).or_insert(warnings.len());
        match warnings.get_mut(at) {
            Some(same) => {
                same.numbers_differ |= same.text != text;
                same.runs.push(run);
            }
            None => warnings.push(SweepWarning {
                text,
                numbers_differ: false,
                runs: vec![run],
            }),
        }
    }
}

/// A text with `#` in place of words that are numbers, or quotients of two.
fn without_numbers(text: &str) -> String {
    let is_number = |word: &str| {
        let word = word.trim_matches(|c: char| "(),:;[]".contains(c));
        word.split('/').all(|part| part.parse::<f64>().is_ok())
    };
    let words = text.split(' ').map(|word| if is_number(word) { "#" } else { word });
    words.collect::<Vec<_>>().join(" ")
}

fn check_one(plan: &Plan, run: usize) -> Result<(Estimate, Vec<String>, Vec<InputFile>), Box<Diagnostics>> {
    let scenario = plan.scenario(run)?;
    let prepared = prepare(&scenario)?;
    let estimate = Estimate {
        grains: prepared.setup.grains.len() as u64,
        steps: prepared.steps,
        memory: prepared.memory,
        run_time: prepared.run_time,
        simulated: prepared.steps as f64 * prepared.setup.dt,
    };
    Ok((estimate, prepared.warnings, scenario.input_files()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn warnings_that_differ_in_numbers_are_one() {
        let (mut warnings, mut known) = (Vec::new(), HashMap::new());
        let long = |dt: &str, share: &str| {
            format!("the time step is long: {dt} s, {share} of what `a1` bears ({dt}); shorten it")
        };
        let of_grain = |id: u32| format!("grain {id} is fast");
        let mut add = |run, told: &[String]| add_warnings(run, told.to_vec(), &mut warnings, &mut known);
        add(0, &[long("1.2e-5", "1/40"), of_grain(3), of_grain(4)]);
        add(1, &[long("2e-5", "1/24")]);
        add(2, &[of_grain(3)]);
        add(
            3,
            &["the time step is long: 1 s, 1/40 of what `a2` bears (1); shorten it".to_string()],
        );
        let told: Vec<(bool, &[usize])> = (warnings.iter()).map(|w| (w.numbers_differ, &w.runs[..])).collect();
        assert_eq!(
            told,
            [(true, &[0, 1][..]), (false, &[0, 2]), (false, &[0]), (false, &[3])]
        );
        assert_eq!(warnings[0].text, long("1.2e-5", "1/40"));
    }
}
