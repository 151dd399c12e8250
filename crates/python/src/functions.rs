//! Python functions that the engine asks: custom forces and motions of walls.

use crate::convert::vectors;
use engine::simulation::{CustomForce, ForceMoment, GrainLoads};
use glam::DVec3;
use numpy::{PyArray1, PyArray2, PyReadonlyArray2, PyUntypedArrayMethods};
use pyo3::PyTraverseError;
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::gc::PyVisit;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

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

/// The grains at the moment at which a custom force acts.
///
/// The arrays are copies of that moment, in the order of the engine, which may be another in every step: `ids` tells which
/// row is which grain.
#[pyclass(module = "demeter", frozen)]
pub struct ForceState {
    /// Simulated time [s].
    #[pyo3(get)]
    time: f64,
    /// Steps done, with the present one.
    #[pyo3(get)]
    step: u64,
    /// Time step [s].
    #[pyo3(get)]
    dt: f64,
    snapshot: Snapshot,
    forces: Py<PyArray2<f64>>,
    torques: Py<PyArray2<f64>>,
}

/// The tables, copied; arrays are made of them when they are asked for.
struct Snapshot {
    position: Vec<[f64; 4]>,
    velocity: Vec<[f64; 4]>,
    spin: Vec<[f64; 4]>,
    mass: Vec<f64>,
    id: Vec<u32>,
    material: Vec<u16>,
    /// Arrays that were asked for.
    made: [OnceLock<Py<PyAny>>; 7],
}

fn first_three(rows: &[[f64; 4]]) -> impl ExactSizeIterator<Item = [f64; 3]> + '_ {
    rows.iter().map(|[x, y, z, _]| [*x, *y, *z])
}

impl ForceState {
    fn made<'py>(
        &self,
        py: Python<'py>,
        place: usize,
        make: impl FnOnce(&Snapshot) -> PyResult<Bound<'py, PyAny>>,
    ) -> PyResult<Py<PyAny>> {
        if let Some(made) = self.snapshot.made[place].get() {
            return Ok(made.clone_ref(py));
        }
        let array = make(&self.snapshot)?.unbind();
        Ok(self.snapshot.made[place].get_or_init(|| array).clone_ref(py))
    }
}

#[pymethods]
impl ForceState {
    /// Centres [m], (n, 3).
    #[getter]
    fn positions(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.made(py, 0, |s| Ok(vectors(py, first_three(&s.position))?.into_any()))
    }

    /// Velocities, as predicted for the end of the step [m/s], (n, 3).
    #[getter]
    fn velocities(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.made(py, 1, |s| Ok(vectors(py, first_three(&s.velocity))?.into_any()))
    }

    /// Angular velocities, as predicted for the end of the step [rad/s], (n, 3).
    #[getter]
    fn angular_velocities(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.made(py, 2, |s| Ok(vectors(py, first_three(&s.spin))?.into_any()))
    }

    /// Radii [m], (n,).
    #[getter]
    fn radii(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        let radii = |s: &Snapshot| s.position.iter().map(|row| row[3]).collect::<Vec<f64>>();
        self.made(py, 3, |s| Ok(PyArray1::from_vec(py, radii(s)).into_any()))
    }

    /// Masses [kg], (n,).
    #[getter]
    fn masses(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.made(py, 4, |s| Ok(PyArray1::from_slice(py, &s.mass).into_any()))
    }

    /// Ids, (n,).
    #[getter]
    fn ids(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.made(py, 5, |s| Ok(PyArray1::from_slice(py, &s.id).into_any()))
    }

    /// Indices of the materials, (n,).
    #[getter]
    fn materials(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.made(py, 6, |s| Ok(PyArray1::from_slice(py, &s.material).into_any()))
    }

    /// Forces to fill [N], (n, 3); zero at first. Used when the function returns None.
    #[getter]
    fn forces(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.forces.clone_ref(py)
    }

    /// Torques to fill [N m], (n, 3); zero at first. Used when the function returns None or forces alone.
    #[getter]
    fn torques(&self, py: Python<'_>) -> Py<PyArray2<f64>> {
        self.torques.clone_ref(py)
    }

    fn __len__(&self) -> usize {
        self.snapshot.mass.len()
    }
}

/// A custom force that is a Python function.
pub struct PythonForce(pub Arc<Function>);

impl CustomForce for PythonForce {
    fn loads(&mut self, moment: &ForceMoment, loads: &mut GrainLoads) -> Result<(), String> {
        self.0.ask(|function| {
            let py = function.py();
            let grains = moment.grains;
            let zeros = || PyArray2::<f64>::zeros(py, [grains.len(), 3], false);
            let state = ForceState {
                time: moment.time,
                step: moment.step,
                dt: moment.dt,
                snapshot: Snapshot {
                    position: grains.position.table().to_vec(),
                    velocity: grains.velocity.table().to_vec(),
                    spin: grains.angular_velocity.table().to_vec(),
                    mass: grains.mass.clone(),
                    id: grains.id.clone(),
                    material: grains.material.clone(),
                    made: Default::default(),
                },
                forces: zeros().unbind(),
                torques: zeros().unbind(),
            };
            let state = Bound::new(py, state)?;
            let answer = function.call1((&state,))?;
            let (forces, torques) = if answer.is_none() {
                (state.get().forces(py).into_any(), state.get().torques(py).into_any())
            } else if let Ok(both) = answer.cast::<PyTuple>() {
                let (forces, torques): (Bound<'_, PyAny>, Bound<'_, PyAny>) = both
                    .extract()
                    .map_err(|_| PyTypeError::new_err("a custom force returns forces, (forces, torques) or None"))?;
                (forces.unbind(), torques.unbind())
            } else {
                (answer.unbind(), state.get().torques(py).into_any())
            };
            fill(&mut loads.force, forces.bind(py), "forces")?;
            fill(&mut loads.torque, torques.bind(py), "torques")
        })
    }
}

/// Reads an array of three columns into vectors.
fn fill(vectors: &mut [DVec3], array: &Bound<'_, PyAny>, what: &str) -> PyResult<()> {
    let read = rows(array, what)?;
    if read.len() != vectors.len() {
        let (found, grains) = (read.len(), vectors.len());
        return Err(PyValueError::new_err(format!(
            "{what} of shape ({found}, 3) for {grains} grains: ({grains}, 3) is needed"
        )));
    }
    vectors.copy_from_slice(&read);
    Ok(())
}

/// An array of three columns as vectors.
pub fn rows(array: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<DVec3>> {
    let py = array.py();
    let numpy = py.import("numpy")?;
    let wrong = || {
        let found = array
            .get_type()
            .name()
            .map_or_else(|_| String::new(), |n| n.to_string());
        PyTypeError::new_err(format!(
            "`{what}` must be an array of numbers of shape (n, 3), not {found}"
        ))
    };
    let float = numpy.call_method1("asarray", (array, "float64")).map_err(|_| wrong())?;
    let read: PyReadonlyArray2<'_, f64> = float.extract().map_err(|_| wrong())?;
    if read.shape()[1] != 3 {
        let shape = read.shape();
        let message = format!("`{what}` has the shape ({}, {}); it must be (n, 3)", shape[0], shape[1]);
        return Err(PyValueError::new_err(message));
    }
    Ok(read
        .as_array()
        .rows()
        .into_iter()
        .map(|row| DVec3::new(row[0], row[1], row[2]))
        .collect())
}
