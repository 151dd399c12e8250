//! Runs from their start or from a checkpoint, by one process or several.

use super::changed::Former;
use super::sharing::{Inputs, agree, all_or_none};
use super::{Files, Observer, Place, RunState, Runner, of_frames};
use crate::checkpoint;
use crate::comm::Ranks;
use crate::output::{FrameWriter, OutputError, RunFolder};
use crate::scenario::Scenario;
use crate::scenario::differences::line_differences;
use crate::scenario::field_files::FieldFiles;
use crate::scenario::input_files::InputFile;
use crate::scenario::prepare::{prepare, prepare_to_resume};
use crate::scenario::report::Report;
use crate::scenario::rows::Rows;
use crate::scenario::run_error::RunError;
use crate::scenario::run_options::{MOST_THREADS, RunOptions};
use crate::scenario::traffic::Traffic;
use crate::simulation::{Setup, Simulation, SimulationState, StateError};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

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
    let is_first = ranks.as_ref().is_none_or(|ranks| ranks.rank() == 0);
    be_patient(ranks.as_deref());
    let prepared = is_first.then(|| prepare(scenario).map_err(RunError::from)).transpose();
    let prepared = all_or_none(ranks.as_deref(), prepared)?;
    if let Some(ranks) = &ranks {
        agree(&**ranks, &Inputs::of(scenario))?;
    }
    thread_pool(options.threads)?.install(|| {
        let create = || -> Result<_, RunError> {
            let (folder, lock) = options.reserve(folder, scenario)?;
            folder.write(&folder.scenario(), scenario.to_resolved_toml().as_bytes())?;
            folder.force_to_disk([folder.marker().as_path()].into_iter())?;
            Ok((folder, lock))
        };
        let (files, _lock) = all_or_none(ranks.as_deref(), is_first.then(create).transpose())?.unzip();
        let root = files.as_ref().map_or(folder, RunFolder::root).to_owned();
        if root != folder {
            observer.message(&elsewhere(folder, &root));
        }
        let begun = prepared.map(|prepared| Runner::begin(scenario, prepared, files.as_ref(), observer));
        let mut runner = Runner::among(scenario, begun, ranks, &options, observer)?;
        runner.run_to_the_end(&root, observer)
    })
}

/// Tells that a run does not go where it was to.
fn elsewhere(taken: &Path, root: &Path) -> String {
    let (taken, root) = (taken.display(), root.display());
    format!("`{taken}` is taken by another run; this one goes to `{root}` (--overwrite replaces the other)")
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
    let is_first = ranks.as_ref().is_none_or(|ranks| ranks.rank() == 0);
    be_patient(ranks.as_deref());
    let read = || -> Result<_, RunError> {
        let folder = RunFolder::open(folder)?;
        let lock = folder.lock()?;
        let (scenario, state, former) = read_run(&folder, &options, observer)?;
        Ok(((folder, lock), (scenario, (state, former))))
    };
    let (files, told) = all_or_none(ranks.as_deref(), is_first.then(read).transpose())?.unzip();
    let (scenario, state) = told.unzip();
    let scenario = of_the_first(ranks.as_deref(), scenario, folder)?;
    let is_over = state
        .as_ref()
        .is_some_and(|(state, _)| state.place.stage >= scenario.stages.len());
    let of_all = (ranks.as_deref()).map_or_else(|| vec![is_over.into()], |ranks| ranks.gather_even(&[is_over.into()]));
    if of_all.contains(&1) {
        let folder = folder.to_owned();
        return Err(RunError::Finished { folder });
    }
    if let Some(ranks) = &ranks {
        agree(&**ranks, &Inputs::of(&scenario))?;
    }
    thread_pool(options.threads)?.install(|| {
        let resumed = state.map(|(state, former)| {
            let mut runner = Runner::resume(&scenario, state, files.as_ref().map(|(folder, _)| folder), observer)?;
            if let Some(former) = former {
                runner.go_on_otherwise(&former, observer)?;
                if ranks.is_some() {
                    runner.begin_anew()?;
                }
            }
            Ok(runner)
        });
        let mut runner = Runner::among(&scenario, resumed, ranks, &options, observer)?;
        runner.run_to_the_end(folder, observer)
    })
}

/// The scenario of the first process, for all: its folder need not be where the others are.
fn of_the_first(ranks: Option<&dyn Ranks>, scenario: Option<Scenario>, folder: &Path) -> Result<Scenario, RunError> {
    let text = (scenario.as_ref()).map_or_else(String::new, Scenario::to_resolved_toml);
    let all = ranks.map(|ranks| ranks.gather(text.as_bytes())).unwrap_or_default();
    let read = || {
        let text = all
            .first()
            .map(|text| String::from_utf8_lossy(text))
            .unwrap_or_default();
        let name = folder.join("scenario.toml").display().to_string();
        Scenario::parse_for(&text, &name, folder, &[], true).map_err(RunError::from)
    };
    all_or_none(ranks, scenario.map_or_else(read, Ok))
}

/// Waits for the first process as long as it takes: it alone prepares what all begin with, and a packing can take long.
fn be_patient(ranks: Option<&dyn Ranks>) {
    if let Some(ranks) = ranks {
        ranks.be_patient(true);
    }
}

/// The scenario and the latest checkpoint of a folder, and the scenario that this followed where it was changed.
pub(in crate::scenario) fn read_run(
    folder: &RunFolder,
    options: &RunOptions,
    observer: &mut dyn Observer,
) -> Result<(Scenario, RunState<'static>, Option<Former>), RunError> {
    let mut former = None;
    let mut scenario = Scenario::read_to_go_on(&folder.scenario())?;
    let mut restored = checkpoint::read_latest::<RunState<'static>>(folder.root())?;
    // a scenario without a title is named after its file, which has another name here
    scenario.title.clone_from(&restored.header.title);
    let on_the_way = restored.value.place.files.iter().filter(|file| !file.of_start);
    let changes: Vec<String> = on_the_way.filter_map(InputFile::change).collect();
    if !changes.is_empty() {
        return Err(RunError::FilesChanged { changes });
    }
    let place = &mut restored.value.place;
    let text = scenario.to_resolved_toml();
    if let Some(difference) = line_differences(&place.scenario, &text) {
        let file = folder.scenario();
        if !options.changed {
            return Err(RunError::ScenarioChanged { file, difference });
        }
        let followed = Scenario::parse_for(
            &place.scenario,
            "the scenario of the checkpoint",
            folder.root(),
            &[],
            true,
        )?;
        let (is, was) = (material_names(&scenario), material_names(&followed));
        if is != was {
            return Err(RunError::OtherMaterials { file, is, was });
        }
        let step = restored.value.simulation.step;
        let warning =
            format!("from step {step} on {difference} (grains, box and time step are those of the checkpoint)");
        place.warnings.push(warning.clone());
        place.scenario = text;
        let followed = Former::of(followed, &restored.value, &scenario)?;
        restored.value.place.stage = followed.stage_in(&scenario, &file)?;
        former = Some(followed);
        restored.warnings.push(warning);
    }
    for warning in &restored.warnings {
        observer.message(&format!("warning: {warning}"));
    }
    Ok((scenario, restored.value, former))
}

/// Names of the materials of a scenario, in their order.
fn material_names(scenario: &Scenario) -> String {
    let names: Vec<String> = scenario.materials.iter().map(|m| format!("`{}`", m.name)).collect();
    names.join(", ")
}

/// Refuses to go on where a file is gone that the run wrote into: it would be begun anew, as if nothing had been before.
fn check_files(scenario: &Scenario, folder: &RunFolder, place: &Place) -> Result<(), OutputError> {
    let written = [
        (Rows::files(scenario, folder), place.last_row),
        (of_frames(scenario, folder), place.last_frame),
    ];
    let gone = |(files, last): (Vec<PathBuf>, Option<u64>)| {
        let gone = files
            .into_iter()
            .filter(|file| place.written.knows(folder, file) && !file.exists());
        last.map_or_else(Vec::new, |step| gone.map(|file| (file, step)).collect())
    };
    let files: Vec<(PathBuf, u64)> = written.into_iter().flat_map(gone).collect();
    if files.is_empty() {
        return Ok(());
    }
    Err(OutputError::FilesGone { files })
}

const ASK_FOR_FEWER: &str = "Ask for fewer with --threads";

/// Threads of a run; as many as there are cores, or as the environment tells, when none are asked for.
pub(crate) fn thread_pool(threads: Option<usize>) -> Result<rayon::ThreadPool, RunError> {
    if threads == Some(0) {
        return Err(RunError::Threads {
            threads: 0,
            reason: "a run needs at least 1. Leave the number out for all cores".to_string(),
        });
    }
    let told = || std::env::var("RAYON_NUM_THREADS").ok()?.parse().ok();
    if let Some(many) = threads.or_else(told).filter(|told| *told > usize::from(MOST_THREADS)) {
        let who = if threads.is_some() {
            ""
        } else {
            "the environment variable RAYON_NUM_THREADS tells so many, and "
        };
        return Err(RunError::Threads {
            threads: many,
            reason: format!("{who}at most {MOST_THREADS} are allowed. {ASK_FOR_FEWER}"),
        });
    }
    let threads = threads.unwrap_or(0);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map_err(|error| RunError::Threads {
        threads,
        reason: format!("{error}. {ASK_FOR_FEWER}"),
    })
}

impl<'a> Runner<'a> {
    /// The run of the first process, shared with others where there are any: these begin with what the first tells them.
    fn among(
        scenario: &'a Scenario,
        first: Option<Result<Self, RunError>>,
        ranks: Option<Box<dyn Ranks>>,
        options: &RunOptions,
        observer: &mut dyn Observer,
    ) -> Result<Self, RunError> {
        let first = all_or_none(ranks.as_deref(), first.transpose())?;
        let told = ranks.as_deref().and_then(|ranks| {
            let mine = first.as_ref().map(Self::told_to_others).unwrap_or_default();
            ranks.gather(&mine).into_iter().next()
        });
        let begun = first.map_or_else(
            || Self::begin_as_told(scenario, &told.unwrap_or_default(), observer),
            Ok,
        );
        let mut runner = all_or_none(ranks.as_deref(), begun)?;
        if let Some(ranks) = &ranks {
            ranks.be_patient(false);
        }
        options.apply(&mut runner.sim);
        runner.share(ranks, observer)?;
        Ok(runner)
    }

    /// A run that goes on from a state.
    pub(in crate::scenario) fn resume(
        scenario: &'a Scenario,
        mut state: RunState<'_>,
        folder: Option<&RunFolder>,
        observer: &mut dyn Observer,
    ) -> Result<Self, RunError> {
        let mut setup: Setup = prepare_to_resume(scenario, state.place.stage, state.domain)?;
        setup.dt = state.simulation.dt;
        let step = state.simulation.step;
        let had_custom_force = state.simulation.had_custom_force();
        let sim = Simulation::resume(setup, state.simulation)?;
        let traffic = Traffic::resume(scenario, &sim, state.traffic)?;
        let mut told = vec![format!("going on from step {step}, time {:.4e} s", sim.time())];
        folder.map_or(Ok(()), |folder| check_files(scenario, folder, &state.place))?;
        let rows = match folder {
            Some(folder) => Rows::resume(scenario, folder, step)?,
            None => Rows::in_memory(scenario),
        };
        let mut lost: BTreeMap<String, String> = BTreeMap::new();
        let mut files = |folder: &RunFolder| -> Result<Files, RunError> {
            let (frames, of_frames) = FrameWriter::open(folder, Some(step))?;
            let (fields, of_fields) = FieldFiles::open(scenario, folder, Some(step))?;
            let Place { written, last_row, .. } = &state.place;
            let lacks =
                |(file, every_moment): (_, bool)| written.lacks(folder, file, last_row.filter(|_| every_moment));
            lost.extend(rows.open_files().filter_map(lacks));
            lost.extend(fields.tables().map(|file| (file, false)).filter_map(lacks));
            for warning in of_frames.into_iter().chain(of_fields) {
                told.push(format!("warning: {warning}"));
                if !state.place.warnings.contains(&warning) {
                    state.place.warnings.push(warning);
                }
            }
            Ok(Files {
                frames,
                fields,
                folder: folder.clone(),
            })
        };
        let files = folder.map(&mut files).transpose()?;
        for (file, problem) in lost {
            let shown = folder.map_or_else(|| file.clone().into(), |folder| folder.root().join(&file));
            let warning = format!(
                "`{}` {problem}; what is missing stays so, and the file is not that of the whole run",
                shown.display()
            );
            told.push(format!("warning: {warning}"));
            if state.place.lost_rows.get(&file) != Some(&problem) {
                state.place.warnings.push(warning);
                state.place.lost_rows.insert(file, problem);
            }
        }
        if had_custom_force {
            told.push(
                "warning: a custom force acted, which a checkpoint does not hold: it must be added again".to_string(),
            );
        }
        let walls = sim.undriven_walls().into_iter();
        told.extend(walls.map(|wall| {
            format!(
                "warning: wall `{wall}` had a custom motion, which a checkpoint does not hold: it rests until told anew"
            )
        }));
        for text in told {
            observer.message(&text);
            folder.map_or(Ok(()), |folder| folder.log_line(&text))?;
        }
        Ok(Self::new(scenario, (sim, traffic), state.place, (rows, files)))
    }

    /// Goes on from what a checkpoint would hold now, as the others do with which the run is to be shared: whatever else they do not know.
    fn begin_anew(&mut self) -> Result<(), RunError> {
        // encoding into memory fails for no value of ours
        let bytes = postcard::to_stdvec(&self.sim.state()).unwrap_or_default();
        let unreadable = |_| StateError::Inconsistent("what the first process has");
        let state: SimulationState<'static> = postcard::from_bytes(&bytes).map_err(unreadable)?;
        let mut setup = prepare_to_resume(self.scenario, self.place.stage, *self.sim.domain())?;
        setup.dt = state.dt;
        self.sim = Simulation::resume(setup, state)?;
        Ok(())
    }

    /// What others need to go on with this run, but for what each of them is handed of the grains.
    fn told_to_others(&self) -> Vec<u8> {
        // encoding into memory fails for no value of ours
        postcard::to_stdvec(&self.state_with(self.sim.state_without_grains())).unwrap_or_default()
    }

    /// A run as the first process told it.
    fn begin_as_told(scenario: &'a Scenario, told: &[u8], observer: &mut dyn Observer) -> Result<Self, RunError> {
        let unreadable = |_| StateError::Inconsistent("what the first process told");
        let state: RunState<'static> = postcard::from_bytes(told).map_err(unreadable)?;
        Self::resume(scenario, state, None, observer)
    }

    /// Shares the run with other processes, where there are any.
    fn share(&mut self, ranks: Option<Box<dyn Ranks>>, observer: &mut dyn Observer) -> Result<(), RunError> {
        let Some(ranks) = ranks else { return Ok(()) };
        let count = ranks.count();
        self.sim.share(ranks);
        self.sim.divide();
        self.say(&format!("the run is shared by {count} processes"), observer)
    }
}
