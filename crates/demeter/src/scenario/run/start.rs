//! Runs from their start or from a checkpoint, by one process or several.

use super::sharing::{Inputs, agree, all_or_none};
use super::{Observer, RunState, Runner};
use crate::checkpoint;
use crate::comm::Ranks;
use crate::output::RunFolder;
use crate::scenario::Scenario;
use crate::scenario::input_files::InputFile;
use crate::scenario::prepare::prepare;
use crate::scenario::report::Report;
use crate::scenario::run_error::RunError;
use crate::scenario::run_options::RunOptions;
use std::path::Path;

/// Runs a scenario and writes its results into a folder.
pub fn run(
    scenario: &Scenario,
    folder: &Path,
    options: RunOptions,
    observer: &mut dyn Observer,
) -> Result<Report, RunError> {
    run_among(scenario, folder, options, None, observer)
}

/// Runs a scenario together with other processes, of which each calls this; the first writes the results. They are those of
/// one process, to the bit.
pub fn run_shared(
    scenario: &Scenario,
    folder: &Path,
    options: RunOptions,
    ranks: Box<dyn Ranks>,
    observer: &mut dyn Observer,
) -> Result<Report, RunError> {
    run_among(scenario, folder, options, Some(ranks), observer)
}

fn run_among(
    scenario: &Scenario,
    folder: &Path,
    options: RunOptions,
    ranks: Option<Box<dyn Ranks>>,
    observer: &mut dyn Observer,
) -> Result<Report, RunError> {
    options.check()?;
    let prepared = all_or_none(ranks.as_deref(), prepare(scenario).map_err(RunError::from))?;
    if let Some(ranks) = &ranks {
        agree(&**ranks, &Inputs::of(scenario, &prepared.setup.grains))?;
    }
    thread_pool(options.threads)?.install(|| {
        let create = || -> Result<_, RunError> {
            let folder = RunFolder::create(folder, options.overwrite)?;
            let lock = folder.lock()?;
            folder.write(&folder.scenario(), scenario.to_resolved_toml().as_bytes())?;
            Ok((folder, lock))
        };
        let writes = ranks.as_ref().is_none_or(|ranks| ranks.rank() == 0);
        let (files, _lock) = all_or_none(ranks.as_deref(), writes.then(create).transpose())?.unzip();
        let mut runner = Runner::begin(scenario, prepared, files.as_ref(), observer)?;
        options.apply(&mut runner.sim);
        runner.share(ranks, observer)?;
        runner.run_to_the_end(folder, observer)
    })
}

/// Continues the run in a folder from its latest checkpoint.
pub fn resume(folder: &Path, options: RunOptions, observer: &mut dyn Observer) -> Result<Report, RunError> {
    resume_among(folder, options, None, observer)
}

/// Continues the run in a folder together with other processes, of which each calls this, however many there were before.
pub fn resume_shared(
    folder: &Path,
    options: RunOptions,
    ranks: Box<dyn Ranks>,
    observer: &mut dyn Observer,
) -> Result<Report, RunError> {
    resume_among(folder, options, Some(ranks), observer)
}

fn resume_among(
    folder: &Path,
    options: RunOptions,
    ranks: Option<Box<dyn Ranks>>,
    observer: &mut dyn Observer,
) -> Result<Report, RunError> {
    options.check()?;
    let writes = ranks.as_ref().is_none_or(|ranks| ranks.rank() == 0);
    let mut read = || -> Result<_, RunError> {
        let folder = RunFolder::open(folder)?;
        let lock = writes.then(|| folder.lock()).transpose()?;
        let (scenario, state) = read_run(&folder, observer)?;
        Ok((folder, lock, scenario, state))
    };
    let (folder, _lock, scenario, state) = all_or_none(ranks.as_deref(), read())?;
    if state.place.stage >= scenario.stages.len() {
        let folder = folder.root().to_owned();
        return Err(RunError::Finished { folder });
    }
    if let Some(ranks) = &ranks {
        // nobody writes the next checkpoint before all have read this one
        agree(&**ranks, &Inputs::of(&scenario, &state.simulation.grains))?;
    }
    thread_pool(options.threads)?.install(|| {
        let mut runner = Runner::resume(&scenario, state, writes.then_some(&folder), observer)?;
        options.apply(&mut runner.sim);
        runner.share(ranks, observer)?;
        runner.run_to_the_end(folder.root(), observer)
    })
}

/// The scenario and the latest checkpoint of a folder.
pub(in crate::scenario) fn read_run(
    folder: &RunFolder,
    observer: &mut dyn Observer,
) -> Result<(Scenario, RunState<'static>), RunError> {
    let mut scenario = Scenario::read_to_go_on(&folder.scenario())?;
    let restored = checkpoint::read_latest::<RunState<'static>>(folder.root())?;
    // a scenario without a title is named after its file, which has another name here
    scenario.title.clone_from(&restored.header.title);
    let on_the_way = restored.value.place.files.iter().filter(|file| !file.of_start);
    let changes: Vec<String> = on_the_way.filter_map(InputFile::change).collect();
    if !changes.is_empty() {
        return Err(RunError::FilesChanged { changes });
    }
    for warning in &restored.warnings {
        observer.message(&format!("warning: {warning}"));
    }
    Ok((scenario, restored.value))
}

/// Threads of a run; as many as there are cores when none are asked for.
pub(crate) fn thread_pool(threads: Option<usize>) -> Result<rayon::ThreadPool, RunError> {
    let threads = threads.unwrap_or(0);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map_err(|error| RunError::Threads {
        threads,
        reason: error.to_string(),
    })
}

impl Runner<'_> {
    /// Shares the run with other processes, where there are any.
    fn share(&mut self, ranks: Option<Box<dyn Ranks>>, observer: &mut dyn Observer) -> Result<(), RunError> {
        let Some(ranks) = ranks else { return Ok(()) };
        let count = ranks.count();
        self.sim.share(ranks);
        self.say(&format!("the run is shared by {count} processes"), observer)?;
        if let Some(reason) = self.sim.shares_nothing() {
            let text = format!(
                "warning: with {reason} every process does the work of all: the results are right, but nothing is gained; run                  one process with more --threads"
            );
            self.say(&text, observer)?;
        }
        Ok(())
    }
}
