//! The class `Simulation`.

mod going;
mod looking;

pub use going::{resume, run};
use looking::{live_series, present_dict, walls_dict};

use crate::contacts::ContactTable;
use crate::control::{Callback, Interval, Limit};
use crate::convert::{flag, from_json, function as callable, path, text, whole};
use crate::errors::{Error, OrRaise, RunError, wrong_type};
use crate::functions::{Function, PythonForce, rows};
use crate::views::{Table, Views};
use engine::scenario::LiveRun;
use engine::simulation::Simulation as EngineSimulation;
use numpy::PyArray1;
use pyo3::PyTraverseError;
use pyo3::gc::PyVisit;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError, Weak};

/// A run with what Python sees of it.
pub struct Live {
    pub run: LiveRun,
    pub views: Views,
    pub contacts: ContactTable,
}

impl Live {
    /// Works on the simulation; arrays keep what they show, and a run that a fault has ended may go on.
    fn change<T: Send>(&mut self, work: impl FnOnce(&mut EngineSimulation) -> T + Send) -> T {
        self.part();
        self.run.go_on_after_fault();
        self.run.change(work)
    }

    /// Lets arrays keep what they show.
    fn part(&mut self) {
        let Self { run, views, contacts } = self;
        contacts.forget();
        if views.any() {
            run.change(|simulation| views.part(simulation));
        }
    }
}

/// A run, in your hands.
///
/// It follows the protocol of its scenario (stages, motions, feeds, output) wherever you let it pause: `run` to the end,
/// `step`, `run_until`, `run_stage`. Between, its state is there as NumPy arrays, without copies. All values are SI.
///
/// Rows of arrays lie in the order of the engine, which changes while the run goes on; `ids` tells which grain a row is, and
/// `indices` finds grains.
///
/// Parameters
/// ----------
/// scenario : Scenario, path, TOML text or dict
/// out : path, optional
///     Folder for the results, as of ``demeter run``. Without it nothing is written, and `series` is kept in memory.
/// threads : int, optional
///     Number of threads; all cores without it. The results are the same bits on any number.
/// overwrite : bool
///     Whether an earlier run in the folder may be replaced.
///
/// Examples
/// --------
/// >>> sim = demeter.Simulation("drum.toml")
/// >>> sim.step(1000)
/// >>> sim.positions[sim.radii > 1e-3].mean(axis=0)
#[pyclass(module = "demeter", frozen, weakref)]
pub struct Simulation {
    live: Mutex<Live>,
    /// Whether a run goes on, also while a callback is called.
    is_running: AtomicBool,
    is_asked_to_stop: AtomicBool,
    callbacks: Mutex<Vec<Callback>>,
    /// Functions that the engine asks.
    /// Those that the engine asks, which keeps them alive.
    functions: Mutex<Vec<Weak<Function>>>,
    messages: Mutex<Vec<String>>,
    is_closed: AtomicBool,
    /// The process that made it: its threads do not follow into one that is forked.
    process: u32,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[pymethods]
impl Simulation {
    #[new]
    #[pyo3(signature = (scenario, *, out=None, threads=None, overwrite=None),
        text_signature = "(scenario, *, out=None, threads=None, overwrite=False)")]
    fn new(
        py: Python<'_>,
        scenario: &Bound<'_, PyAny>,
        out: Option<&Bound<'_, PyAny>>,
        threads: Option<&Bound<'_, PyAny>>,
        overwrite: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        Self::build(py, scenario, out, threads, overwrite)
    }

    /// The run in a folder, from its latest checkpoint on, to the bits of an uninterrupted run.
    ///
    /// Checkpoints hold no Python functions: callbacks, custom forces and custom motions must be added again, before the
    /// next step for the same bits. Without them the force is absent and the wall rests where it stood; `messages` says so.
    /// ``changed`` goes on although ``scenario.toml`` in the folder was changed, with what it tells now.
    #[staticmethod]
    #[pyo3(signature = (folder, *, threads=None, changed=false))]
    fn resume(
        py: Python<'_>,
        folder: &Bound<'_, PyAny>,
        threads: Option<&Bound<'_, PyAny>>,
        changed: bool,
    ) -> PyResult<Self> {
        Self::resumed(py, folder, threads, changed)
    }

    /// Runs to the end of the protocol, or until a callback calls `stop`. Tells whether the end was reached.
    ///
    /// Other Python threads run meanwhile. Ctrl-C raises KeyboardInterrupt after the present step; the simulation can go
    /// on, and a run with a folder has left a checkpoint.
    ///
    /// Parameters
    /// ----------
    /// progress : bool or callable
    ///     True draws a bar. A function is called some times in a second with a dict: ``stage``, ``stage_number`` of ``stages``,
    ///     ``step`` of ``steps``, simulated ``time`` [s], ``grains``, ``elapsed`` [s], ``steps_per_second``, ``seconds_left`` [s].
    #[pyo3(signature = (*, progress=None))]
    fn run<'py>(slf: &Bound<'py, Self>, progress: Option<&Bound<'py, PyAny>>) -> PyResult<bool> {
        Self::go_watched(slf, &Limit::end(), progress)
    }

    /// Runs so many steps, also beyond the end of the protocol.
    #[pyo3(signature = (n=None), text_signature = "($self, n=1)")]
    fn step(slf: &Bound<'_, Self>, n: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let n = n.map_or(Ok(1), |n| whole(n, "n", 0))?;
        let step = slf.get().look(|sim| sim.step)?.saturating_add(n);
        Self::go(slf, &Limit::step(step)).map(drop)
    }

    /// Runs until a time, also beyond the end of the protocol, or until a condition holds.
    ///
    /// Parameters
    /// ----------
    /// until : str, float or callable
    ///     A simulated time, as ``"20 ms"`` or in seconds; or a function of the simulation that tells True.
    /// every : int, str or float
    ///     How often a function is asked: steps (int) or time.
    /// at_most : str or float, optional
    ///     Simulated time at which to end in any case. Without it a condition is waited for until the end of the protocol.
    /// progress : bool or callable
    ///     As in `run`.
    ///
    /// Returns
    /// -------
    /// bool
    ///     Whether the time was reached, or the condition holds.
    #[pyo3(signature = (until, *, every=None, at_most=None, progress=None))]
    fn run_until<'py>(
        slf: &Bound<'py, Self>,
        until: &Bound<'py, PyAny>,
        every: Option<&Bound<'py, PyAny>>,
        at_most: Option<&Bound<'py, PyAny>>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<bool> {
        let (step, dt) = slf.get().look(|sim| (sim.step, sim.dt()))?;
        let limit = Limit::until(until, every, at_most, (step, dt))?;
        Self::go_watched(slf, &limit, progress)
    }

    /// Runs to the end of the present stage. Tells whether a stage is left. `progress` as in `run`.
    #[pyo3(signature = (*, progress=None))]
    fn run_stage<'py>(slf: &Bound<'py, Self>, progress: Option<&Bound<'py, PyAny>>) -> PyResult<bool> {
        Self::go_watched(slf, &Limit::stage(), progress)?;
        Ok(slf.get().live()?.run.stage().is_some())
    }

    /// Ends the run that goes on, after the present step: for callbacks and other threads.
    fn stop(&self) {
        self.is_asked_to_stop.store(true, Ordering::SeqCst);
    }

    /// Calls a function again and again while the simulation runs: ``function(sim)``.
    ///
    /// Parameters
    /// ----------
    /// interval : int, str or float
    ///     Steps (an int), or simulated time: ``"1 ms"``, or seconds (a float), which is rounded to whole steps.
    /// function : callable, optional
    ///     Without it `every` is a decorator.
    ///
    /// The function sees whole steps and may change the simulation. What it raises comes out of `run` unchanged; the
    /// simulation can go on.
    #[pyo3(signature = (interval, function=None))]
    fn every<'py>(
        slf: &Bound<'py, Self>,
        interval: &Bound<'py, PyAny>,
        function: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let Some(function) = function else {
            let later = slf.py().import("functools")?.getattr("partial")?;
            return later.call1((slf.getattr("every")?, interval));
        };
        callable(function, "function", "the simulation")?;
        let (step, dt) = slf.get().look(|sim| (sim.step, sim.dt()))?;
        let interval = Interval::of(interval, "interval")?.steps(dt);
        locked(&slf.get().callbacks).push(Callback::new(interval, step, function.clone().unbind()));
        Ok(function.clone())
    }

    /// Calls a function of `every` no more.
    fn cancel(&self, py: Python<'_>, function: &Bound<'_, PyAny>) -> PyResult<()> {
        self.call_no_more(py, function)
    }

    /// Adds a force on the grains: ``function(state)``, asked once in every step.
    ///
    /// `state` has `time`, `positions`, `velocities`, `angular_velocities`, `radii`, `masses`, `ids`, `materials`
    /// (arrays of that moment), and `forces` and `torques` to fill. The function returns an array of forces (n, 3) [N], a
    /// tuple of forces and torques [N m], or None when it has filled those of `state`. Its work is booked as ``custom work``, so
    /// the ledger stays closed. The answer should depend on the state alone; then runs are the same bits after a restart.
    ///
    /// When the function raises, the step is completed with its last answer, and the exception comes out unchanged.
    fn add_force<'py>(&self, function: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        callable(function, "function", "a state")?;
        let mut live = self.live()?;
        let force = PythonForce::new(self.keep(function.clone().unbind()));
        live.run.change(|sim| sim.add_force(Box::new(force)));
        Ok(function.clone())
    }

    /// Takes all custom forces away.
    fn clear_forces(&self) -> PyResult<()> {
        self.live()?.run.change(EngineSimulation::clear_forces);
        Ok(())
    }

    /// Moves a wall as a function of simulated time [s] tells, from where it stands; until a stage tells it another motion.
    ///
    /// Give one of
    ///
    /// * ``position``: three numbers [m]; the wall is displaced by f(t) - f(t0), its velocity is the central difference
    /// * ``velocity``: three numbers [m/s]
    /// * ``angle``: a number [rad], about `axis` through `point`; the wall is turned by f(t) - f(t0)
    /// * ``angular_velocity``: a number [rad/s], about `axis` through `point`
    #[pyo3(signature = (wall, *, position=None, velocity=None, angle=None, angular_velocity=None, axis=None, point=None))]
    #[allow(clippy::too_many_arguments, reason = "they are keywords")]
    fn move_wall(
        &self,
        py: Python<'_>,
        wall: &Bound<'_, PyAny>,
        position: Option<Py<PyAny>>,
        velocity: Option<Py<PyAny>>,
        angle: Option<Py<PyAny>>,
        angular_velocity: Option<Py<PyAny>>,
        axis: Option<&Bound<'_, PyAny>>,
        point: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let ways = [
            ("position", position),
            ("velocity", velocity),
            ("angle", angle),
            ("angular_velocity", angular_velocity),
        ];
        self.drive(py, &text(wall, "wall")?, ways, (axis, point))
    }

    /// Writes a checkpoint: into the folder of the run, or into a new folder, from which `resume` goes on. Tells the folder.
    ///
    /// It holds no Python functions: see `resume`. With ``overwrite`` what a run or an earlier checkpoint has left in another folder is
    /// removed first.
    #[pyo3(signature = (folder=None, *, overwrite=None), text_signature = "($self, folder=None, *, overwrite=False)")]
    fn checkpoint(
        &self,
        py: Python<'_>,
        folder: Option<&Bound<'_, PyAny>>,
        overwrite: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<std::path::PathBuf> {
        let folder = folder.map(|folder| path(folder, "folder")).transpose()?;
        let overwrite = overwrite.map_or(Ok(false), |told| flag(told, "overwrite"))?;
        folder.is_none().then(|| self.refuse_closed()).transpose()?;
        let run = &mut self.live()?.run;
        py.detach(|| run.checkpoint(folder.as_deref(), overwrite)).or_raise(py)
    }

    /// Lets the folder of the run go, so that another one may be written there, and goes no further. The state stays to be looked
    /// at. ``with demeter.Simulation(scenario, out=folder) as sim:`` closes at its end.
    ///
    /// The folder holds what the run has told so far, and its latest checkpoint. A run lets its folder go by itself when its
    /// protocol is over, or when nobody holds it any more.
    fn close(&self) -> PyResult<()> {
        if self.is_running.load(Ordering::SeqCst) {
            return Err(RunError::new_err(
                "the simulation runs: sim.stop() ends it, close comes then",
            ));
        }
        self.is_closed.store(true, Ordering::SeqCst);
        self.live()?.run.release();
        Ok(())
    }

    fn __enter__<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, Self>> {
        slf.get().refuse_closed()?;
        Ok(slf.clone())
    }

    #[pyo3(signature = (*_exception))]
    fn __exit__(&self, _exception: &Bound<'_, PyTuple>) -> PyResult<bool> {
        self.close()?;
        Ok(false)
    }

    fn __reduce__(&self) -> PyResult<()> {
        Err(wrong_type(
            "a simulation can be neither copied nor pickled: sim.checkpoint(folder) writes its state, \
             demeter.Simulation.resume(folder) goes on with it, also in another process",
        ))
    }

    /// Simulated time [s].
    #[getter]
    fn time(&self) -> PyResult<f64> {
        self.look(EngineSimulation::time)
    }

    /// Steps done.
    #[getter]
    fn steps(&self) -> PyResult<u64> {
        self.look(|sim| sim.step)
    }

    /// Time step [s].
    #[getter]
    fn dt(&self) -> PyResult<f64> {
        self.look(|sim| sim.dt())
    }

    /// Name of the present stage; None when the protocol is over.
    #[getter]
    fn stage(&self) -> PyResult<Option<String>> {
        let live = self.live()?;
        Ok(live
            .run
            .stage()
            .map(|stage| live.run.scenario().stages[stage].name.clone()))
    }

    /// Whether the protocol is over.
    #[getter]
    fn finished(&self) -> PyResult<bool> {
        Ok(self.live()?.run.stage().is_none())
    }

    /// The folder of the results; None for a run that writes nothing.
    #[getter]
    fn folder(&self) -> PyResult<Option<std::path::PathBuf>> {
        Ok(self.live()?.run.folder().map(ToOwned::to_owned))
    }

    /// What the run had to say so far: time step, ends of stages, warnings. Warnings also go to ``logging``.
    #[getter]
    fn messages(&self) -> Vec<String> {
        locked(&self.messages).clone()
    }

    /// The summary at the end of the protocol, as in ``summary.json``; None before.
    #[getter]
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let live = self.live()?;
        let Some((_, summary)) = live.run.end() else {
            return Ok(None);
        };
        let json = serde_json::to_value(summary).map_err(|e| Error::new_err(e.to_string()))?;
        from_json(py, &json).map(Some)
    }

    /// Centres of the grains [m], (n, 3).
    ///
    /// A read-only array that shares the memory of the simulation. It shows the moment at which it was taken, for as long
    /// as it lives: when the simulation goes on, it leaves that memory to the array. Assigning moves all grains:
    /// candidates and forces are found anew, the change of energy is booked; rows may lie in another order afterwards. Places beyond
    /// periodic sides are those of their images in the box. Where a Fault is raised, as grains overlap too deeply, the grains are at the
    /// new places: assign others before the next step. What contacts remembered that were not there then is gone.
    #[getter]
    fn positions<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::show(slf, Table::Position, |s, sim| s.vectors(&sim.grains().position))
    }

    #[setter]
    fn set_positions(&self, py: Python<'_>, values: &Bound<'_, PyAny>) -> PyResult<()> {
        let values = rows(values, "positions")?;
        let mut guard = self.live()?;
        let live = &mut *guard;
        py.detach(|| live.change(|sim| sim.set_positions(&values))).or_raise(py)
    }

    /// Velocities [m/s], (n, 3); read-only and without a copy, as `positions`. Assigning books the change of energy; grains that are
    /// `fixed` keep theirs.
    #[getter]
    fn velocities<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::show(slf, Table::Velocity, |s, sim| s.vectors(&sim.grains().velocity))
    }

    #[setter]
    fn set_velocities(&self, py: Python<'_>, values: &Bound<'_, PyAny>) -> PyResult<()> {
        let values = rows(values, "velocities")?;
        let mut guard = self.live()?;
        let live = &mut *guard;
        py.detach(|| live.change(|sim| sim.set_velocities(&values)))
            .or_raise(py)
    }

    /// Angular velocities [rad/s], (n, 3); read-only and without a copy, as `positions`. Assigning books the change of energy; grains
    /// that are `fixed` keep theirs.
    #[getter]
    fn angular_velocities<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::show(slf, Table::AngularVelocity, |s, sim| {
            s.vectors(&sim.grains().angular_velocity)
        })
    }

    #[setter]
    fn set_angular_velocities(&self, py: Python<'_>, values: &Bound<'_, PyAny>) -> PyResult<()> {
        let values = rows(values, "angular_velocities")?;
        let mut guard = self.live()?;
        let live = &mut *guard;
        py.detach(|| live.change(|sim| sim.set_angular_velocities(&values)))
            .or_raise(py)
    }

    /// Total forces on the grains in the latest step [N], (n, 3); without a copy.
    #[getter]
    fn forces<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::show(slf, Table::Load, |s, sim| s.forces(&sim.grains().load))
    }

    /// Total torques on the grains in the latest step [N m], (n, 3); without a copy.
    #[getter]
    fn torques<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::show(slf, Table::Load, |s, sim| s.torques(&sim.grains().load))
    }

    /// Radii [m], (n,); without a copy.
    #[getter]
    fn radii<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::show(slf, Table::Position, |s, sim| s.scalars(&sim.grains().position))
    }

    /// Masses [kg], (n,); without a copy.
    #[getter]
    fn masses<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::show(slf, Table::Load, |s, sim| s.masses(&sim.grains().load))
    }

    /// Which grains forces leave where they are, (n,).
    #[getter]
    fn fixed<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<bool>>> {
        let fixed = |sim: &EngineSimulation| {
            (0..sim.grains().len())
                .map(|grain| sim.grains().is_fixed(grain))
                .collect()
        };
        Ok(PyArray1::from_vec(py, self.live()?.run.with_simulation(fixed)))
    }

    /// Ids, which never change, (n,); without a copy.
    #[getter]
    fn ids<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::show(slf, Table::Id, |s, sim| s.list(&sim.grains().id))
    }

    /// Indices of the materials, (n,); their names are `material_names`. Without a copy.
    #[getter]
    fn materials<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::show(slf, Table::Material, |s, sim| s.list(&sim.grains().material))
    }

    /// Unit quaternions x, y, z, w, (n, 4), where `simulation.orientations` is true; read-only and without a copy.
    #[getter]
    fn orientations<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        Self::show(slf, Table::Orientation, |s, sim| s.orientations(sim.grains()))
    }

    /// Names of the materials.
    #[getter]
    fn material_names(&self) -> PyResult<Vec<String>> {
        self.look(|sim| sim.materials.list().iter().map(|m| m.name.clone()).collect())
    }

    /// Rows of the grains with these ids, in their order; of all grains in the order of their ids when none are told.
    ///
    /// >>> sim.positions[sim.indices()]        # by id
    /// >>> sim.positions[sim.indices([17])]    # grain 17
    #[pyo3(signature = (ids=None))]
    fn indices<'py>(&self, py: Python<'py>, ids: Option<&Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyArray1<u64>>> {
        self.rows_of(py, ids)
    }

    /// All contacts that act, as a dict of read-only arrays with one row for each of the c contacts. The table is put together when it
    /// is asked for first, and kept until the simulation goes on: asking again costs nothing and makes no copy. Arrays show the
    /// moment at which they were taken for as long as they live.
    ///
    /// ``i`` and ``j`` (ids; ``j`` is 0 for a wall), ``wall`` (index, -1 between grains) and ``overlap`` [m], of shape (c,);
    /// ``position`` [m], ``normal`` (from j to i), ``force``, ``normal_force`` and ``tangential_force`` on i [N], and
    /// ``rolling_torque`` [N m], of shape (c, 3).
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let mut guard = self.live()?;
        let live = &mut *guard;
        live.contacts.dict(py, &mut live.run)
    }

    /// The walls by name, each a dict: ``force`` [N] and ``torque`` [N m] (about ``position``) of the grains on it, ``position``
    /// of its origin [m], ``displacement`` since the start [m], ``velocity`` [m/s], ``angular_velocity`` [rad/s], arrays of shape
    /// (3,), and ``present``, a bool.
    #[getter]
    fn walls<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        walls_dict(py, &self.live()?.run)
    }

    /// The energy ledger [J], as a dict: what is there (``kinetic``, ``rotational``, ``gravitational``, ``elastic``, ...), what was
    /// dissipated and put in since the start (``friction_dissipated``, ``wall_work``, ``custom_work``, ...), and ``residual``.
    fn energies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let energies = self.live()?.run.energies();
        let json = serde_json::to_value(energies).map_err(|e| Error::new_err(e.to_string()))?;
        from_json(py, &json)
    }

    /// Share of the energy that passed through the system which the ledger does not explain.
    #[getter]
    fn residual(&self) -> PyResult<f64> {
        Ok(self.live()?.run.energies().residual)
    }

    /// Everything that a row of the series tells, now, as a dict: ``{"time [s]": 0.1, "coordination": 4.2, ...}``.
    fn measures<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        present_dict(py, &mut self.live()?.run)
    }

    /// The series so far as a dict of columns, titled with their units: ``pandas.DataFrame(sim.series())``.
    fn series<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        if self.live()?.run.folder().is_some() {
            self.refuse_closed()?;
        }
        live_series(py, &self.live()?.run)
    }

    fn __len__(&self) -> PyResult<usize> {
        self.look(|sim| sim.grains().len())
    }

    fn __repr__(&self) -> String {
        match self.live() {
            Ok(live) => live.run.with_simulation(|sim| {
                let (grains, step, time) = (sim.grains().len(), sim.step, sim.time());
                format!("<demeter.Simulation: {grains} grains, step {step}, time {time:.4e} s>")
            }),
            Err(_) => "<demeter.Simulation, running>".to_string(),
        }
    }

    fn __traverse__(&self, visit: PyVisit<'_>) -> Result<(), PyTraverseError> {
        if let Ok(callbacks) = self.callbacks.try_lock() {
            for callback in callbacks.iter() {
                visit.call(callback.function())?;
            }
        }
        if let Ok(functions) = self.functions.try_lock() {
            for function in functions.iter().filter_map(Weak::upgrade) {
                function.traverse(&visit)?;
            }
        }
        Ok(())
    }

    fn __clear__(&self) {
        if let Ok(mut callbacks) = self.callbacks.try_lock() {
            callbacks.clear();
        }
        if let Ok(functions) = self.functions.try_lock() {
            functions
                .iter()
                .filter_map(Weak::upgrade)
                .for_each(|function| function.clear());
        }
    }
}
