//! How a sweep begins: planned and checked, or found in its folder.

use crate::answer::{colours, note};
use crate::arguments::SweepArguments;
use crate::failure::Failure;
use crate::run::run_name;
use demeter::scenario::RunError;
use demeter::sweep::{Plan, SweepError, SweepFault, SweepFaults, SweepFolder, Varied, Wishes, check, check_wishes};
use std::path::{Path, PathBuf};

/// Most runs that are named with a fault.
const MOST_NAMED: usize = 4;

/// A sweep that may run.
pub struct Begun {
    pub folder: SweepFolder,
    pub state: State,
}

/// How much of a sweep is in its folder already.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// Nothing: the folder is still to be made.
    New,
    /// Some runs; the plan is still to be written.
    Extended,
    /// All.
    There,
}

/// The sweep that the command line tells: the one that is in its folder already, or a new one, whose runs are all checked.
pub fn plan(arguments: &SweepArguments, file: &Path) -> Result<Begun, Failure> {
    let varied = Varied {
        vary: arguments.vary.clone(),
        zip: arguments.zip.clone(),
        table: arguments.table.clone(),
        repeat: arguments.repeat,
        set: arguments.set.clone(),
    };
    let plan = Plan::make(file, &varied)?;
    let root = match &arguments.out {
        Some(folder) => folder.clone(),
        None => default_folder(file)?,
    };
    if SweepFolder::is_one(&root) {
        let mut folder = SweepFolder::open(&root)?;
        let mut differences = folder.plan.differences(&plan);
        if differences.is_empty() {
            folder.check_files()?;
            take_wishes(arguments, &mut folder)?;
            let state = State::There;
            return Ok(Begun { folder, state });
        }
        let is_part = folder.plan.is_part_of(&plan);
        if arguments.extend && is_part {
            folder.check_files()?;
            folder.plan = plan;
            take_wishes(arguments, &mut folder)?;
            check_all(&mut folder)?;
            let state = State::Extended;
            return Ok(Begun { folder, state });
        }
        let hint = match (arguments.extend, is_part) {
            (_, true) => Some("all runs that are there are among those told now: --extend adds the others"),
            (true, false) => {
                Some("--extend only adds runs: each that is there must be told again, under the same name")
            }
            (false, false) => None,
        };
        differences.extend(hint.map(str::to_string));
        let error = SweepError::Differs {
            folder: root.clone(),
            differences,
        };
        if !arguments.dry_run {
            return Err(error.into());
        }
        note(&format!("warning: {error}"));
    }
    let mut folder = SweepFolder::planned(&root, plan, wishes(arguments));
    check_all(&mut folder)?;
    check_first(&folder)?;
    let state = State::New;
    Ok(Begun { folder, state })
}

/// The sweep in a folder.
pub fn open(arguments: &SweepArguments, root: &Path) -> Result<Begun, Failure> {
    let mut folder = SweepFolder::open(root)?;
    if folder.plan.version != demeter::VERSION {
        return Err(Failure::wrong(format!(
            "the sweep in `{}` was begun by Demeter {}, this is {}: results of both do not belong together. Go on with that \
             version, or begin the sweep anew in another folder",
            root.display(),
            folder.plan.version,
            demeter::VERSION
        )));
    }
    folder.check_files()?;
    take_wishes(arguments, &mut folder)?;
    let state = State::There;
    Ok(Begun { folder, state })
}

/// Puts what is asked for now in place of what was asked for earlier.
pub fn take_wishes(arguments: &SweepArguments, folder: &mut SweepFolder) -> Result<(), Failure> {
    let new = wishes(arguments);
    if new == Wishes::default() {
        return Ok(());
    }
    if !new.results.is_empty() {
        folder.wishes.results = new.results;
    }
    if !new.plots.is_empty() {
        folder.wishes.plots = new.plots;
    }
    if new.against.is_some() {
        folder.wishes.against = new.against;
    }
    check_first(folder)
}

/// What is drawn is in the table, too.
fn wishes(arguments: &SweepArguments) -> Wishes {
    let mut results = arguments.result.clone();
    for plot in &arguments.plot {
        if !results.contains(plot) {
            results.push(plot.clone());
        }
    }
    Wishes {
        results,
        plots: arguments.plot.clone(),
        against: arguments.against.clone(),
    }
}

/// Tells results that there will not be.
fn check_first(folder: &SweepFolder) -> Result<(), Failure> {
    if folder.wishes.against.is_some() && folder.wishes.plots.is_empty() {
        return Err(Failure::wrong(
            "--against tells the horizontal axis of plots, and there is none; add `--plot RESULT`, or leave it out",
        ));
    }
    let first = folder.plan.scenario(0).map_err(RunError::from)?;
    Ok(check_wishes(folder, &first)?)
}

/// `runs/NAME-sweep`.
fn default_folder(file: &Path) -> Result<PathBuf, Failure> {
    let path =
        std::path::absolute(file).map_err(|error| Failure::io(format!("cannot find `{}`: {error}", file.display())))?;
    Ok(Path::new("runs").join(format!("{}-sweep", run_name(&path))))
}

/// Checks the scenarios of all runs, and takes over what they will need.
fn check_all(folder: &mut SweepFolder) -> Result<(), Failure> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let checked = match check(&folder.plan, threads, colours())? {
        Ok(checked) => checked,
        Err(faults) => return Err(wrong(&folder.plan, faults)),
    };
    for warning in &checked.warnings {
        let numbers = match warning.numbers_differ {
            true => "; the numbers are those of the first",
            false => "",
        };
        let runs = of_runs(&folder.plan, &warning.runs);
        note(&format!("warning: {} (runs: {runs}{numbers})", warning.text));
    }
    folder.plan.files = checked.files;
    for (run, estimate) in folder.plan.runs.iter_mut().zip(checked.estimates) {
        run.estimate = estimate;
    }
    Ok(())
}

/// All that is wrong, each with the combinations that it is wrong in.
fn wrong(plan: &Plan, faults: SweepFaults) -> Failure {
    let left_out = faults.left_out;
    let one = |fault: SweepFault| {
        let runs = of_runs(plan, &fault.runs);
        (fault, runs)
    };
    Failure::Sweep {
        faults: faults.faults.into_iter().map(one).collect(),
        left_out,
    }
}

/// The runs of a fault or warning, in words.
fn of_runs(plan: &Plan, runs: &[usize]) -> String {
    if runs.len() == plan.runs.len() {
        return format!("all {}", runs.len());
    }
    let named: Vec<String> = runs.iter().take(MOST_NAMED).map(|&run| plan.describe(run)).collect();
    let more = match runs.len().saturating_sub(MOST_NAMED) {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    format!("{}{more}", named.join("; "))
}
