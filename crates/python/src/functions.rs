//! Python functions that the engine asks: custom forces and motions of walls.

use crate::convert::shown;
use crate::errors::{wrong_type, wrong_value};
use crate::force_state::{Arrays, ForceState};
use engine::simulation::{CustomForce, ForceMoment, GrainLoads};
use glam::DVec3;
use numpy::{PyReadonlyArray2, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::PyTraverseError;
use pyo3::gc::PyVisit;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A Python function, which the engine and the simulation share.
pub struct Function {
    function: Mutex<Option<Py<PyAny>>>,
    /// The exception that it raised last.
    raised: Mutex<Option<PyErr>>,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Function {
    pub fn new(function: Py<PyAny>) -> Arc<Self> {
        Arc::new(Self {
            function: Mutex::new(Some(function)),
            raised: Mutex::new(None),
        })
    }

    /// The exception that was raised since the last time.
    pub fn take_raised(&self) -> Option<PyErr> {
        locked(&self.raised).take()
    }

    pub fn traverse(&self, visit: &PyVisit<'_>) -> Result<(), PyTraverseError> {
        match self.function.try_lock() {
            Ok(function) => visit.call(&*function),
            Err(_) => Ok(()),
        }
    }

    pub fn clear(&self) {
        if let Ok(mut function) = self.function.try_lock() {
            function.take();
        }
    }

    /// Calls the function and reads its answer; an exception is kept, and told as a text.
    fn ask<T>(&self, call: impl for<'py> FnOnce(&Bound<'py, PyAny>) -> PyResult<T>) -> Result<T, String> {
        Python::attach(|py| {
            let function = locked(&self.function).as_ref().map(|f| f.clone_ref(py));
            let Some(function) = function else {
                return Err("the function is gone".to_string());
            };
            call(function.bind(py)).map_err(|error| {
                let text = error.to_string();
                // what was raised before is dropped when nothing is locked: that may call Python
                let before = locked(&self.raised).replace(error);
                drop(before);
                text
            })
        })
    }

    /// A vector at a time.
    pub fn vector(&self, time: f64) -> Result<DVec3, String> {
        self.ask(|function| {
            let answer = function.call1((time,))?;
            let read: Result<[f64; 3], _> = answer.extract();
            let read = read.map_err(|_| {
                let found = shown(&answer);
                wrong_type(format!(
                    "the motion of a wall must be three numbers in SI, as (0, 0, 0.1), not {found}"
                ))
            })?;
            Ok(DVec3::from_array(read))
        })
    }

    /// A number at a time.
    pub fn number(&self, time: f64) -> Result<f64, String> {
        self.ask(|function| {
            let answer = function.call1((time,))?;
            let wrong = |_| {
                let found = shown(&answer);
                wrong_type(format!("the turning of a wall must be one number in SI, not {found}"))
            };
            answer.extract().map_err(wrong)
        })
    }
}

/// A custom force that is a Python function.
pub struct PythonForce {
    function: Arc<Function>,
    /// Memory of the arrays that it was shown.
    memory: Arrays,
}

impl PythonForce {
    pub fn new(function: Arc<Function>) -> Self {
        Self {
            function,
            memory: Arrays::default(),
        }
    }
}

impl CustomForce for PythonForce {
    fn loads(&mut self, moment: &ForceMoment, loads: &mut GrainLoads) -> Result<(), String> {
        let memory = &mut self.memory;
        self.function.ask(|function| {
            let py = function.py();
            let state = Bound::new(py, ForceState::new(moment, std::mem::take(memory)))?;
            let asking = ForceState::asking(&state);
            let answer = function.call1((&state,));
            drop(asking);
            fill_loads(loads, &answer?, &state)?;
            *memory = ForceState::memory(&state);
            Ok(())
        })
    }
}

/// Reads what a custom force answered. Loads are 0 before.
fn fill_loads(loads: &mut GrainLoads, answer: &Bound<'_, PyAny>, state: &Bound<'_, ForceState>) -> PyResult<()> {
    let filled = |torques| state.get().filled(answer.py(), torques);
    let (forces, torques) = if answer.is_none() {
        (filled(false), filled(true))
    } else if let Ok(both) = answer.cast::<PyTuple>() {
        let (forces, torques): (Bound<'_, PyAny>, Bound<'_, PyAny>) = both.extract().map_err(|_| {
            wrong_type(format!(
                "a custom force returns forces, (forces, torques) or None, not {}",
                shown(answer)
            ))
        })?;
        (Some(forces), Some(torques))
    } else {
        (Some(answer.clone()), filled(true))
    };
    if let Some(forces) = forces {
        fill(&mut loads.force, &forces, "forces")?;
    }
    match torques {
        Some(torques) => fill(&mut loads.torque, &torques, "torques"),
        None => Ok(()),
    }
}

/// Reads an array of three columns into vectors.
fn fill(vectors: &mut [DVec3], array: &Bound<'_, PyAny>, what: &str) -> PyResult<()> {
    let read = three_columns(array, what)?;
    if read.shape()[0] != vectors.len() {
        let (found, grains) = (read.shape()[0], vectors.len());
        return Err(wrong_value(format!(
            "a custom force answered with {what} of shape ({found}, 3) for {grains} grains: ({grains}, 3) is needed, in the order of \
             `state.ids`"
        )));
    }
    match read.as_slice() {
        Ok(numbers) => {
            for (vector, row) in vectors.iter_mut().zip(numbers.as_chunks().0) {
                *vector = DVec3::from_array(*row);
            }
        }
        Err(_) => {
            for (vector, row) in vectors.iter_mut().zip(read.as_array().rows()) {
                *vector = DVec3::new(row[0], row[1], row[2]);
            }
        }
    }
    Ok(())
}

/// An array of three columns as vectors.
pub fn rows(array: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<DVec3>> {
    let read = three_columns(array, what)?;
    let rows = read.as_array();
    Ok(rows
        .rows()
        .into_iter()
        .map(|row| DVec3::new(row[0], row[1], row[2]))
        .collect())
}

/// Whether entries of an array are masked: NumPy gives what lies behind the mask to whoever does not ask.
fn is_masked(array: &Bound<'_, PyAny>) -> PyResult<bool> {
    if array.is_exact_instance_of::<PyUntypedArray>() {
        return Ok(false);
    }
    let masks = array.py().import("numpy.ma")?;
    masks.call_method1("is_masked", (array,))?.extract()
}

/// An array of three columns, as it is where it has numbers of 64 bits.
fn three_columns<'py>(array: &Bound<'py, PyAny>, what: &str) -> PyResult<PyReadonlyArray2<'py, f64>> {
    if is_masked(array)? {
        return Err(wrong_value(format!(
            "`{what}` has masked entries, which are no numbers; fill them, as with `.filled(0)`"
        )));
    }
    if let Ok(read) = array.extract::<PyReadonlyArray2<'py, f64>>()
        && read.shape()[1] == 3
    {
        return Ok(read);
    }
    let numpy = array.py().import("numpy")?;
    let wrong = || {
        let found = shown(array);
        wrong_type(format!(
            "`{what}` must be an array of numbers of shape (n, 3), not {found}"
        ))
    };
    let given = numpy.call_method1("asarray", (array,)).map_err(|_| wrong())?;
    let kind: String = given.getattr("dtype")?.getattr("kind")?.extract()?;
    // numbers; neither complex ones, nor texts that look like numbers, nor objects
    if !["f", "i", "u", "b"].contains(&kind.as_str()) {
        return Err(wrong());
    }
    let float = numpy
        .call_method1("asarray", (&given, "float64"))
        .map_err(|_| wrong())?;
    match float.extract::<PyReadonlyArray2<'py, f64>>() {
        Ok(read) if read.shape()[1] == 3 => Ok(read),
        _ => Err(wrong_value(format!(
            "`{what}` has the shape {}; it must be (n, 3), a row for each grain",
            given.getattr("shape")?
        ))),
    }
}
