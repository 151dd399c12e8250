//! How the simulation goes on: until a limit, with callbacks and signals.

use super::{Live, Simulation, locked};
use crate::contacts::ContactTable;
use crate::control::{Callback, Limit, Messages, Place, Watcher};
use crate::convert::{self, flag, function as callable, path, shown, three, whole};
use crate::errors::{OrRaise, Raise, RunError, not_there, unknown_name, wrong_type, wrong_value};
use crate::functions::Function;
use crate::scenario::Scenario;
use crate::views::{Showing, Table, Views};
use demeter_physics::dimension::Dimension;
use engine::contacts::Fault as EngineFault;
use engine::scenario::{LiveRun, Pause, RunEnd, RunOptions, Until};
use engine::simulation::{CustomMotion, Simulation as EngineSimulation};
use glam::DVec3;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyString;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, TryLockError};
use std::time::{Duration, Instant};

/// The run looks so often whether Python wants something, as Ctrl-C.
const LOOK_EVERY: Duration = Duration::from_millis(50);

/// Says on drop that no run goes on.
struct Running<'a>(&'a AtomicBool);

impl Drop for Running<'_> {
    fn drop(&mut self) {
        self.0.store(false, Ordering::SeqCst);
    }
}

impl Simulation {
    pub(super) fn of(run: LiveRun, messages: Messages) -> Self {
        Self {
            live: Mutex::new(Live {
                run,
                views: Views::default(),
                contacts: ContactTable::default(),
            }),
            is_running: AtomicBool::new(false),
            is_asked_to_stop: AtomicBool::new(false),
            callbacks: Mutex::new(Vec::new()),
            functions: Mutex::new(Vec::new()),
            messages: Mutex::new(messages.list),
            is_closed: AtomicBool::new(false),
            process: std::process::id(),
        }
    }

    /// A simulation of a scenario.
    pub fn build(
        py: Python<'_>,
        scenario: &Bound<'_, PyAny>,
        out: Option<&Bound<'_, PyAny>>,
        threads: Option<&Bound<'_, PyAny>>,
        overwrite: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let out = out.map(|out| path(out, "out")).transpose()?;
        let options = options(threads, overwrite)?;
        let scenario = Scenario::engine_of(scenario)?;
        let mut messages = Messages::default();
        let run = py
            .detach(|| LiveRun::new(scenario, out.as_deref(), options, &mut messages))
            .or_raise(py)?;
        messages.tell(py, 0)?;
        Ok(Self::of(run, messages))
    }

    /// The run, unless it is in the middle of a step.
    pub(super) fn live(&self) -> PyResult<MutexGuard<'_, Live>> {
        if self.process != std::process::id() {
            return Err(RunError::new_err(format!(
                "the simulation belongs to the process {} and cannot be used in a fork of it, where its threads are missing: make it \
                 there, or carry it over by sim.checkpoint(folder) and demeter.Simulation.resume(folder)",
                self.process
            )));
        }
        match self.live.try_lock() {
            Ok(live) => Ok(live),
            Err(TryLockError::Poisoned(poisoned)) => Ok(poisoned.into_inner()),
            Err(TryLockError::WouldBlock) => Err(RunError::new_err(
                "the simulation is in the middle of a step: look at it between steps, in the thread that runs it or in a callback of \
                 `every`, which may leave what it sees to other threads; a custom force uses the state that it is given",
            )),
        }
    }

    /// That the simulation was not closed.
    pub(super) fn refuse_closed(&self) -> PyResult<()> {
        if !self.is_closed.load(Ordering::SeqCst) {
            return Ok(());
        }
        let live = self.live()?;
        let how = live.run.folder().map_or_else(String::new, |folder| {
            let folder = folder.display();
            format!(": demeter.read_series(\"{folder}\") reads what it wrote, demeter.Simulation.resume(\"{folder}\") goes on from its latest checkpoint")
        });
        Err(RunError::new_err(format!("the simulation was closed{how}")))
    }

    pub(super) fn look<T>(&self, look: impl FnOnce(&EngineSimulation) -> T) -> PyResult<T> {
        Ok(self.live()?.run.with_simulation(look))
    }

    /// Index of a wall.
    pub(super) fn wall(&self, name: &str) -> PyResult<usize> {
        self.look(|sim| {
            let at = sim.walls.iter().position(|wall| wall.name == name);
            at.ok_or_else(|| unknown_name("wall", name, sim.walls.iter().map(|wall| wall.name.as_str())))
        })?
    }

    /// Runs on, with callbacks, until a limit, a condition, or the end.
    pub(super) fn go(slf: &Bound<'_, Self>, limit: &Limit) -> PyResult<bool> {
        Self::go_watched(slf, limit, None)
    }

    /// The same, while a function is told how far it is.
    pub(super) fn go_watched<'py>(
        slf: &Bound<'py, Self>,
        limit: &Limit,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<bool> {
        let watcher = Watcher::of(progress)?;
        let ended = Self::go_on(slf, limit, watcher.as_ref());
        let closed = watcher.map_or(Ok(()), |watcher| watcher.close());
        ended.and_then(|reached| closed.map(|()| reached))
    }

    fn go_on(slf: &Bound<'_, Self>, limit: &Limit, watcher: Option<&Watcher<'_>>) -> PyResult<bool> {
        let this = slf.get();
        this.refuse_closed()?;
        if this.is_running.swap(true, Ordering::SeqCst) {
            return Err(RunError::new_err(
                "the simulation runs already: a callback looks and changes, it cannot run it; sim.stop() ends the run",
            ));
        }
        let _running = Running(&this.is_running);
        this.is_asked_to_stop.store(false, Ordering::SeqCst);
        loop {
            let step = this.look(|sim| sim.step)?;
            if let Some(condition) = limit.due(step)
                && condition.call1(slf.py(), (slf,))?.is_truthy(slf.py())?
            {
                return Ok(true);
            }
            let due = locked(&this.callbacks).iter().map(Callback::next).min();
            let until = Until {
                step: [due, limit.next(step)].into_iter().flatten().min(),
                deadline: Some(Instant::now() + LOOK_EVERY),
                stage: limit.stage,
                beyond: limit.beyond,
            };
            let (pause, place) = this.advance(slf.py(), &until)?;
            if let (Some(watcher), Some(place)) = (watcher, place) {
                watcher.tell(&place)?;
            }
            this.check_signals(slf.py())?;
            this.call_back(slf)?;
            match pause {
                Pause::Stage => return Ok(true),
                Pause::End(RunEnd::Fault(fault)) => return Err(this.raised(slf.py(), fault)),
                Pause::End(_) => return limit.holds(slf.as_any()),
                Pause::Step | Pause::Deadline => {}
            }
            let is_there = limit
                .step
                .is_some_and(|last| this.look(|sim| sim.step).is_ok_and(|step| step >= last));
            if is_there {
                return Ok(limit.condition.is_none());
            }
            if this.is_asked_to_stop.swap(false, Ordering::SeqCst) {
                return Ok(false);
            }
        }
    }

    /// Goes on without the interpreter.
    fn advance(&self, py: Python<'_>, until: &Until) -> PyResult<(Pause, Option<Place>)> {
        let mut live = self.live()?;
        live.part();
        let mut messages = Messages::default();
        let run = &mut live.run;
        let pause = py.detach(|| run.advance(until, &mut messages));
        drop(live);
        let place = messages.place.take();
        messages.tell(py, 0)?;
        locked(&self.messages).extend(messages.list);
        Ok((pause.or_raise(py)?, place))
    }

    /// Ctrl-C: a run with a folder leaves a checkpoint.
    fn check_signals(&self, py: Python<'_>) -> PyResult<()> {
        py.check_signals().inspect_err(|_| {
            let Ok(mut live) = self.live() else { return };
            let run = &mut live.run;
            if run.folder().is_some()
                && let Err(error) = py.detach(|| run.checkpoint(None, false))
            {
                locked(&self.messages).push(format!("warning: no checkpoint was written: {error}"));
            }
        })
    }

    /// Calls those callbacks whose moment has come.
    fn call_back(&self, slf: &Bound<'_, Self>) -> PyResult<()> {
        let step = self.look(|sim| sim.step)?;
        let mut due = Vec::new();
        for callback in locked(&self.callbacks).iter_mut() {
            due.extend(callback.take_due(step, slf.py()));
        }
        for function in due {
            function.call1(slf.py(), (slf,))?;
        }
        Ok(())
    }

    /// Takes a function out of those that are called again and again.
    pub(super) fn call_no_more(&self, py: Python<'_>, function: &Bound<'_, PyAny>) -> PyResult<()> {
        // nothing of Python is called, nor let go, while the list is locked
        let all: Vec<Py<PyAny>> = locked(&self.callbacks)
            .iter()
            .map(|callback| callback.function().clone_ref(py))
            .collect();
        // bound methods are made anew whenever they are asked for
        let is_it = |other: &Py<PyAny>| other.bind(py).eq(function).unwrap_or(false);
        let meant: Vec<Py<PyAny>> = all.into_iter().filter(is_it).collect();
        let is_meant = |callback: &mut Callback| meant.iter().any(|other| other.is(callback.function()));
        let gone: Vec<Callback> = locked(&self.callbacks).extract_if(.., is_meant).collect();
        match gone.is_empty() {
            true => Err(not_there(
                "this function is not called: cancel takes a function that `every` was given",
            )),
            false => Ok(()),
        }
    }

    /// A fault as an exception: the one that a function of the user raised, unchanged.
    fn raised(&self, py: Python<'_>, fault: EngineFault) -> PyErr {
        let raised = || {
            locked(&self.functions)
                .iter()
                .find_map(|function| function.upgrade()?.take_raised())
        };
        match fault {
            EngineFault::Custom { .. } => raised().unwrap_or_else(|| fault.raise(py)),
            fault => fault.raise(py),
        }
    }

    /// Moves a wall; see the method `move_wall` of Python. `ways`: the name of each and its function, where it is given.
    pub(super) fn drive(
        &self,
        py: Python<'_>,
        wall: &str,
        ways: [(&str, Option<Py<PyAny>>); 4],
        (axis, point): (Option<&Bound<'_, PyAny>>, Option<&Bound<'_, PyAny>>),
    ) -> PyResult<()> {
        let index = self.wall(wall)?;
        let mut given: Vec<(&str, Py<PyAny>)> = ways.into_iter().filter_map(|(n, f)| Some((n, f?))).collect();
        let (Some((how, function)), true) = (given.pop(), given.is_empty()) else {
            let message = "give one of position, velocity, angle and angular_velocity: a function of time";
            return Err(wrong_type(message));
        };
        callable(function.bind(py), how, "time [s]")?;
        let turns = how.starts_with("angle") || how.starts_with("angular");
        let axis = match (turns, axis) {
            (false, None) => None,
            (true, Some(axis)) => {
                let axis = DVec3::from_array(three(axis, "axis", Dimension::NONE)?);
                if axis == DVec3::ZERO {
                    return Err(wrong_value("`axis` is (0, 0, 0), which has no direction"));
                }
                let point = point.map_or(Ok([0.0; 3]), |point| three(point, "point", Dimension::LENGTH))?;
                Some((DVec3::from_array(point), axis))
            }
            (true, None) => return Err(wrong_type(format!("`{how}` needs an `axis`, as (0, 0, 1)"))),
            (false, Some(_)) => {
                let message = format!("`{how}` has no `axis`, which belongs to `angle` and `angular_velocity`");
                return Err(wrong_type(message));
            }
        };
        let mut live = self.live()?;
        let function = self.keep(function);
        let motion = motion(Arc::clone(&function), how, axis);
        let run = &mut live.run;
        let told = py.detach(|| run.change(|sim| sim.drive_wall(index, motion)));
        drop(live);
        told.map_err(|error| function.take_raised().unwrap_or_else(|| error.raise(py)))
    }

    /// A function that the engine asks from now on.
    pub(super) fn keep(&self, function: Py<PyAny>) -> Arc<Function> {
        let function = Function::new(function);
        let mut functions = locked(&self.functions);
        // the engine lets them go that it asks no more
        functions.retain(|function| function.strong_count() > 0);
        functions.push(Arc::downgrade(&function));
        function
    }

    /// Rows of grains by their ids, or of all in their order.
    pub(super) fn rows_of<'py>(
        &self,
        py: Python<'py>,
        ids: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyArray1<u64>>> {
        let ids = ids.map(list_of_ids).transpose()?;
        let mut order: Vec<(u32, u64)> = self.look(|sim| sim.grains().id.iter().copied().zip(0..).collect())?;
        order.sort_unstable();
        let Some(ids) = ids else {
            return Ok(PyArray1::from_iter(py, order.into_iter().map(|(_, row)| row)));
        };
        let row = |id: u32| {
            let at = order.binary_search_by_key(&id, |(id, _)| *id);
            at.map(|k| order[k].1).map_err(|_| not_there(no_grain(id, &order)))
        };
        let rows: Vec<u64> = ids.into_iter().map(row).collect::<PyResult<_>>()?;
        Ok(PyArray1::from_vec(py, rows))
    }

    pub(super) fn show<'py>(
        slf: &Bound<'py, Self>,
        table: Table,
        show: impl FnOnce(Showing<'_, 'py>, &EngineSimulation) -> PyResult<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut live = slf.get().live()?;
        let Live { run, views, .. } = &mut *live;
        let showing = Showing {
            owner: slf,
            views,
            table,
        };
        run.with_simulation(|sim| show(showing, sim))
    }

    /// The run in a folder; see the method of Python.
    pub(super) fn resumed(
        py: Python<'_>,
        folder: &Bound<'_, PyAny>,
        threads: Option<&Bound<'_, PyAny>>,
        changed: bool,
    ) -> PyResult<Self> {
        let folder = path(folder, "folder")?;
        let options = RunOptions {
            changed,
            ..options(threads, None)?
        };
        let mut messages = Messages::default();
        let run = py
            .detach(|| LiveRun::resume(&folder, options, &mut messages))
            .or_raise(py)?;
        messages.tell(py, 0)?;
        Ok(Self::of(run, messages))
    }
}

pub(super) fn options(
    threads: Option<&Bound<'_, PyAny>>,
    overwrite: Option<&Bound<'_, PyAny>>,
) -> PyResult<RunOptions> {
    Ok(RunOptions {
        threads: convert::threads(threads)?,
        overwrite: overwrite.map_or(Ok(false), |told| flag(told, "overwrite"))?,
        ..RunOptions::default()
    })
}

/// Ids of grains, from a list or an array.
fn list_of_ids(ids: &Bound<'_, PyAny>) -> PyResult<Vec<u32>> {
    if let Ok(list) = ids.extract() {
        return Ok(list);
    }
    let wrong = || {
        let found = shown(ids);
        wrong_type(format!(
            "`ids` must be a list or an array of whole numbers, as [17], not {found}"
        ))
    };
    if ids.cast::<PyString>().is_ok() {
        return Err(wrong());
    }
    let items = ids.try_iter().map_err(|_| wrong())?;
    let id = |item: PyResult<Bound<'_, PyAny>>| {
        let id = whole(&item?, "ids", 0)?;
        u32::try_from(id).map_err(|_| not_there(format!("there is no grain {id}")))
    };
    items.map(id).collect()
}

/// That a grain is not there, and which are.
fn no_grain(id: u32, order: &[(u32, u64)]) -> String {
    match (order.first(), order.last()) {
        (Some((first, _)), Some((last, _))) => {
            format!(
                "there is no grain {id}; there are {} with ids from {first} to {last}",
                order.len()
            )
        }
        _ => format!("there is no grain {id}; there are no grains"),
    }
}

/// A motion that a Python function tells; exactly one way of telling it.
pub(super) fn motion(function: Arc<Function>, how: &str, axis: Option<(DVec3, DVec3)>) -> CustomMotion {
    let vector = |f: Arc<Function>| Box::new(move |t: f64| f.vector(t));
    let number = |f: Arc<Function>| Box::new(move |t: f64| f.number(t));
    let (point, axis) = axis.unwrap_or((DVec3::ZERO, DVec3::Z));
    match how {
        "position" => CustomMotion::Place(vector(function)),
        "velocity" => CustomMotion::Velocity(vector(function)),
        "angle" => CustomMotion::Angle {
            point,
            axis,
            angle: number(function),
        },
        _ => CustomMotion::AngularVelocity {
            point,
            axis,
            rate: number(function),
        },
    }
}

/// Runs a scenario to its end and hands out the simulation.
///
/// Parameters
/// ----------
/// scenario : Scenario, path, TOML text or dict
/// out : path, optional
///     Folder for the results; without it nothing is written.
/// threads : int, optional
///     Number of threads; all cores without it.
/// overwrite : bool
///     Whether an earlier run in the folder may be replaced.
/// progress : bool or callable
///     True draws a bar; a function is told where the run is, some times in a second: see `Simulation.run`.
///
/// Examples
/// --------
/// >>> sim = demeter.run("drum.toml", out="runs/drum", progress=True)
/// >>> pandas.DataFrame(sim.series()).plot(x="time [s]", y="kinetic energy [J]")
#[pyfunction]
#[pyo3(signature = (scenario, *, out=None, threads=None, overwrite=None, progress=None),
    text_signature = "(scenario, *, out=None, threads=None, overwrite=False, progress=None)")]
pub fn run<'py>(
    py: Python<'py>,
    scenario: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
    threads: Option<&Bound<'py, PyAny>>,
    overwrite: Option<&Bound<'py, PyAny>>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, Simulation>> {
    let simulation = Bound::new(py, Simulation::build(py, scenario, out, threads, overwrite)?)?;
    Simulation::go_watched(&simulation, &Limit::end(), progress)?;
    Ok(simulation)
}

/// Goes on with the run in a folder to its end, from its latest checkpoint: `Simulation.resume` and `run`.
#[pyfunction]
#[pyo3(signature = (folder, *, threads=None, changed=false, progress=None))]
pub fn resume<'py>(
    py: Python<'py>,
    folder: &Bound<'py, PyAny>,
    threads: Option<&Bound<'py, PyAny>>,
    changed: bool,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, Simulation>> {
    let simulation = Bound::new(py, Simulation::resumed(py, folder, threads, changed)?)?;
    Simulation::go_watched(&simulation, &Limit::end(), progress)?;
    Ok(simulation)
}
