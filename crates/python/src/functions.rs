//! Python functions that the engine asks: custom forces and motions of walls.

use crate::force_state::{Arrays, ForceState};
use engine::simulation::{CustomForce, ForceMoment, GrainLoads};
use glam::DVec3;
use numpy::{PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::PyTraverseError;
use pyo3::exceptions::{PyTypeError, PyValueError};
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
                *locked(&self.raised) = Some(error);
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
                PyTypeError::new_err(format!(
                    "the motion of a wall must be three numbers in SI, not {answer}"
                ))
            })?;
            Ok(DVec3::from_array(read))
        })
    }

    /// A number at a time.
    pub fn number(&self, time: f64) -> Result<f64, String> {
        self.ask(|function| {
            let answer = function.call1((time,))?;
            let wrong = |_| PyTypeError::new_err(format!("the turning of a wall must be a number in SI, not {answer}"));
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
        let (forces, torques): (Bound<'_, PyAny>, Bound<'_, PyAny>) = both
            .extract()
            .map_err(|_| PyTypeError::new_err("a custom force returns forces, (forces, torques) or None"))?;
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
        return Err(PyValueError::new_err(format!(
            "{what} of shape ({found}, 3) for {grains} grains: ({grains}, 3) is needed"
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

/// An array of three columns, as it is where it has numbers of 64 bits.
fn three_columns<'py>(array: &Bound<'py, PyAny>, what: &str) -> PyResult<PyReadonlyArray2<'py, f64>> {
    let wrong = || {
        let found = array
            .get_type()
            .name()
            .map_or_else(|_| String::new(), |n| n.to_string());
        PyTypeError::new_err(format!(
            "`{what}` must be an array of numbers of shape (n, 3), not {found}"
        ))
    };
    let read: PyReadonlyArray2<'py, f64> = match array.extract() {
        Ok(read) => read,
        Err(_) => {
            let numpy = array.py().import("numpy")?;
            let float = numpy.call_method1("asarray", (array, "float64")).map_err(|_| wrong())?;
            float.extract().map_err(|_| wrong())?
        }
    };
    if read.shape()[1] != 3 {
        let shape = read.shape();
        let message = format!("`{what}` has the shape ({}, {}); it must be (n, 3)", shape[0], shape[1]);
        return Err(PyValueError::new_err(message));
    }
    Ok(read)
}
