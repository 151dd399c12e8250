//! How far a run goes, and what is called on the way.

use crate::convert::{function, quantity, shown, whole};
use crate::errors::{wrong_type, wrong_value};
use demeter_physics::dimension::Dimension;
use engine::scenario::{Observer, Progress};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyString};

/// Steps between two questions for a condition, when none are told.
const CONDITION_EVERY: u64 = 100;

/// A number of steps, or a time [s].
#[derive(Clone, Copy)]
pub enum Interval {
    Steps(u64),
    Time(f64),
}

impl Interval {
    /// An int counts steps; a text or a float is a time.
    pub fn of(value: &Bound<'_, PyAny>, name: &str) -> PyResult<Self> {
        let is_number = value.is_instance_of::<PyFloat>() || value.is_instance_of::<PyString>();
        if !is_number && value.hasattr("__index__")? {
            return whole(value, name, 1).map(Self::Steps);
        }
        let time = quantity(value, name, Dimension::TIME)?;
        if time > 0.0 && time.is_finite() {
            return Ok(Self::Time(time));
        }
        Err(wrong_value(format!(
            "`{name}` is {time} s; it must be above 0 and finite"
        )))
    }

    /// Whole steps nearest to it, at least one.
    pub fn steps(self, dt: f64) -> u64 {
        match self {
            Self::Steps(steps) => steps,
            Self::Time(time) => (time / dt).round().max(1.0) as u64,
        }
    }
}

/// A function that is called again and again.
pub struct Callback {
    interval: u64,
    next: u64,
    function: Py<PyAny>,
}

impl Callback {
    pub fn new(interval: u64, step: u64, function: Py<PyAny>) -> Self {
        Self {
            interval,
            next: step + interval,
            function,
        }
    }

    /// The step at which it is called next.
    pub fn next(&self) -> u64 {
        self.next
    }

    pub fn function(&self) -> &Py<PyAny> {
        &self.function
    }

    /// The function, when its moment has come.
    pub fn take_due(&mut self, step: u64, py: Python<'_>) -> Option<Py<PyAny>> {
        if step < self.next {
            return None;
        }
        self.next += self.interval * ((step - self.next) / self.interval + 1);
        Some(self.function.clone_ref(py))
    }
}

/// How far a run goes.
#[derive(Default)]
pub struct Limit {
    pub step: Option<u64>,
    pub stage: bool,
    pub beyond: bool,
    /// A function that tells whether to end, and how often it is asked, counted from a step.
    pub condition: Option<(Py<PyAny>, u64, u64)>,
}

impl Limit {
    /// The end of the protocol.
    pub fn end() -> Self {
        Self::default()
    }

    /// The end of the stage.
    pub fn stage() -> Self {
        Self {
            stage: true,
            ..Self::default()
        }
    }

    /// A step.
    pub fn step(step: u64) -> Self {
        Self {
            step: Some(step),
            beyond: true,
            ..Self::default()
        }
    }

    /// A time or a condition; the run is at a step and has a time step.
    pub fn until(
        until: &Bound<'_, PyAny>,
        every: Option<&Bound<'_, PyAny>>,
        at_most: Option<&Bound<'_, PyAny>>,
        (step, dt): (u64, f64),
    ) -> PyResult<Self> {
        let step_of = |value: &Bound<'_, PyAny>, name: &str| -> PyResult<u64> {
            let time = quantity(value, name, Dimension::TIME)?;
            if !(0.0..f64::INFINITY).contains(&time) {
                return Err(wrong_value(format!(
                    "`{name}` is {time} s; it must be a finite time from the beginning of the run on"
                )));
            }
            Ok((time / dt - 1e-9).ceil() as u64)
        };
        let last = at_most.map(|at_most| step_of(at_most, "at_most")).transpose()?;
        if until.is_callable() {
            let every = every.map(|every| Interval::of(every, "every")).transpose()?;
            let every = every.map_or(CONDITION_EVERY, |every| every.steps(dt));
            return Ok(Self {
                step: last,
                stage: false,
                beyond: last.is_some(),
                condition: Some((until.clone().unbind(), every, step)),
            });
        }
        if every.is_some() || last.is_some() {
            let message = "`every` and `at_most` belong to a condition, which is a function";
            return Err(wrong_type(message));
        }
        let until = match step_of(until, "until") {
            Err(error) if error.is_instance_of::<PyTypeError>(until.py()) => {
                return Err(wrong_type(format!(
                    "`until` must be a time (\"20 ms\", or seconds) or a function of the simulation, not {}",
                    shown(until)
                )));
            }
            step => step?,
        };
        if until < step {
            return Err(wrong_value(format!(
                "`until` is {:.6e} s, and the run is at {:.6e} s already; it counts from the beginning of the run (`sim.time + 1e-3` \
                 goes on for 1 ms)",
                until as f64 * dt,
                step as f64 * dt
            )));
        }
        Ok(Self::step(until))
    }

    /// Whether what was asked for is so at the end of the protocol.
    pub fn holds(&self, simulation: &Bound<'_, PyAny>) -> PyResult<bool> {
        match &self.condition {
            Some((function, ..)) => function.bind(simulation.py()).call1((simulation,))?.is_truthy(),
            None => Ok(self.step.is_none()),
        }
    }

    /// The condition, when it is to be asked at a step.
    pub fn due(&self, step: u64) -> Option<&Py<PyAny>> {
        let (function, every, from) = self.condition.as_ref()?;
        (step - from).is_multiple_of(*every).then_some(function)
    }

    /// The next step at which to pause.
    pub fn next(&self, step: u64) -> Option<u64> {
        let asked = self
            .condition
            .as_ref()
            .map(|(_, every, from)| from + every * ((step - from) / every + 1));
        [self.step, asked].into_iter().flatten().min()
    }
}

/// Where a run is, for those who watch it.
pub struct Place {
    stage: String,
    stage_of: (usize, usize),
    step: u64,
    steps: u64,
    time: f64,
    grains: usize,
    elapsed: f64,
    steps_here: u64,
}

impl Place {
    fn dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        let speed = self.steps_here as f64 / self.elapsed.max(f64::MIN_POSITIVE);
        dict.set_item("stage", &self.stage)?;
        dict.set_item("stage_number", self.stage_of.0)?;
        dict.set_item("stages", self.stage_of.1)?;
        dict.set_item("step", self.step)?;
        dict.set_item("steps", self.steps)?;
        dict.set_item("time", self.time)?;
        dict.set_item("grains", self.grains)?;
        dict.set_item("elapsed", self.elapsed)?;
        dict.set_item("steps_per_second", speed)?;
        dict.set_item("seconds_left", self.steps.saturating_sub(self.step) as f64 / speed)?;
        Ok(dict)
    }
}

/// A function that is told how far a run is; a bar, when it is ours, which is closed at the end.
pub struct Watcher<'py> {
    function: Bound<'py, PyAny>,
    is_bar: bool,
}

impl<'py> Watcher<'py> {
    /// None for False, a bar for True, or a function of the user.
    pub fn of(progress: Option<&Bound<'py, PyAny>>) -> PyResult<Option<Self>> {
        let Some(progress) = progress.filter(|told| !told.is_none()) else {
            return Ok(None);
        };
        if let Ok(wanted) = progress.cast::<PyBool>() {
            let bar = || progress.py().import("demeter._progress")?.call_method0("Bar");
            return (wanted.is_true())
                .then(bar)
                .transpose()
                .map(|bar| bar.map(|function| Self { function, is_bar: true }));
        }
        function(progress, "progress", "a dict, or True for a bar")?;
        Ok(Some(Self {
            function: progress.clone(),
            is_bar: false,
        }))
    }

    pub fn tell(&self, place: &Place) -> PyResult<()> {
        self.function.call1((place.dict(self.function.py())?,)).map(drop)
    }

    pub fn close(&self) -> PyResult<()> {
        match self.is_bar {
            true => self.function.call_method0("close").map(drop),
            false => Ok(()),
        }
    }
}

/// The logger of the module, of Python's `logging`.
pub fn logger(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
    py.import("logging")?.call_method1("getLogger", ("demeter",))
}

/// What a run says.
#[derive(Default)]
pub struct Messages {
    pub list: Vec<String>,
    /// Where it was when it told last.
    pub place: Option<Place>,
}

impl Messages {
    /// Tells those from a number on to `logging`: warnings as such, all else as information.
    pub fn tell(&self, py: Python<'_>, from: usize) -> PyResult<()> {
        if self.list.len() <= from {
            return Ok(());
        }
        let log = logger(py)?;
        for text in &self.list[from..] {
            match text.strip_prefix("warning: ") {
                Some(warning) => log.call_method1("warning", ("%s", warning))?,
                None => log.call_method1("info", ("%s", text))?,
            };
        }
        Ok(())
    }
}

impl Observer for Messages {
    fn progress(&mut self, progress: &Progress) -> bool {
        self.place = Some(Place {
            stage: progress.stage.to_string(),
            stage_of: progress.stage_of,
            step: progress.step,
            steps: progress.steps,
            time: progress.time,
            grains: progress.grains,
            elapsed: progress.elapsed,
            steps_here: progress.steps_here,
        });
        true
    }

    fn message(&mut self, text: &str) {
        self.list.push(text.to_string());
    }
}
