//! What a custom force sees: the grains of a moment, as arrays that are made when they are asked for.
//!
//! The memory of an array serves again in the next step, unless somebody still holds the array.

use crate::errors::RunError;
use engine::particles::{Grains, Rows};
use engine::simulation::ForceMoment;
use numpy::ndarray::Dimension;
use numpy::{Element, PyArray, PyArray1, PyArray2, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use std::ptr::NonNull;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Number of arrays.
const ARRAYS: usize = 9;

/// The arrays of a state.
#[derive(Clone, Copy)]
enum Table {
    Positions,
    Velocities,
    AngularVelocities,
    Radii,
    Masses,
    Ids,
    Materials,
    Forces,
    Torques,
}

/// An array; one of an earlier step holds memory alone.
struct Kept {
    array: Py<PyAny>,
    is_of_now: bool,
}

/// Arrays by table.
#[derive(Default)]
pub struct Arrays([Option<Kept>; ARRAYS]);

impl Arrays {
    /// The same arrays as memory for the next step.
    fn of_before(mut self) -> Self {
        for kept in self.0.iter_mut().flatten() {
            kept.is_of_now = false;
        }
        self
    }
}

/// The grains, while the function is asked.
struct Lent(NonNull<Grains>);

#[allow(
    unsafe_code,
    reason = "a pointer to shared grains may go where the grains may, which are `Sync`"
)]
// SAFETY: it is read as a shared reference alone, and `Grains` may be shared between threads
unsafe impl Send for Lent {}

struct Shown {
    grains: Option<Lent>,
    arrays: Arrays,
}

/// The grains at the moment at which a custom force acts.
///
/// The arrays are copies of that moment, made when they are asked for, in the order of the engine, which may be another in every
/// step: `ids` tells which row is which grain. An array that is kept goes on to show its moment; one that was not asked for while
/// the function ran cannot be had later.
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
    count: usize,
    shown: Mutex<Shown>,
}

/// Takes the grains back when the function has answered, however it did.
pub struct Asking<'a, 'py>(&'a Bound<'py, ForceState>);

impl Drop for Asking<'_, '_> {
    fn drop(&mut self) {
        self.0.get().shown().grains = None;
    }
}

impl ForceState {
    /// The state of a moment. Its grains must not be looked at after the moment: ask while an [`Asking`] lives.
    pub fn new(moment: &ForceMoment, memory: Arrays) -> Self {
        Self {
            time: moment.time,
            step: moment.step,
            dt: moment.dt,
            count: moment.grains.len(),
            shown: Mutex::new(Shown {
                grains: Some(Lent(NonNull::from(moment.grains))),
                arrays: memory,
            }),
        }
    }

    /// To be held while the function is asked.
    pub fn asking<'a, 'py>(state: &'a Bound<'py, Self>) -> Asking<'a, 'py> {
        Asking(state)
    }

    /// An array that the function filled, if it asked for it.
    pub fn filled<'py>(&self, py: Python<'py>, torques: bool) -> Option<Bound<'py, PyAny>> {
        let table = if torques { Table::Torques } else { Table::Forces };
        let shown = self.shown();
        let kept = shown.arrays.0[table as usize].as_ref().filter(|kept| kept.is_of_now)?;
        Some(kept.array.bind(py).clone())
    }

    /// The memory of the arrays, for the next step, where nobody holds the state.
    pub fn memory(state: &Bound<'_, Self>) -> Arrays {
        if !is_ours_alone(state.as_any()) {
            return Arrays::default();
        }
        std::mem::take(&mut state.get().shown().arrays).of_before()
    }

    fn shown(&self) -> MutexGuard<'_, Shown> {
        self.shown.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The array of now, or the memory of an earlier one that nobody else holds.
    fn had<'py>(&self, py: Python<'py>, table: Table) -> Had<'py> {
        let mut shown = self.shown();
        let place = &mut shown.arrays.0[table as usize];
        match place.take() {
            Some(kept) if kept.is_of_now => {
                let array = kept.array.clone_ref(py);
                *place = Some(kept);
                Had::Now(array)
            }
            Some(kept) if is_ours_alone(kept.array.bind(py)) => Had::Memory(Some(kept.array.into_bound(py))),
            _ => Had::Memory(None),
        }
    }

    fn keep(&self, py: Python<'_>, table: Table, array: Bound<'_, PyAny>) -> Py<PyAny> {
        let array = array.unbind();
        let kept = Kept {
            array: array.clone_ref(py),
            is_of_now: true,
        };
        self.shown().arrays.0[table as usize] = Some(kept);
        array
    }

    #[allow(
        unsafe_code,
        reason = "the grains are there until `Asking` takes them back, which waits for the lock"
    )]
    fn look(&self, look: impl FnOnce(&Grains)) -> PyResult<()> {
        let shown = self.shown();
        let Some(lent) = &shown.grains else {
            let message = "the state of a custom force is that of its step, which is over: ask for an array while the function \
                           runs; it can be kept";
            return Err(RunError::new_err(message));
        };
        // SAFETY: whoever made this state holds the grains until they were taken back
        look(unsafe { lent.0.as_ref() });
        Ok(())
    }

    /// An array of three columns.
    fn vectors(
        &self,
        py: Python<'_>,
        table: Table,
        fill: impl FnOnce(&mut [[f64; 3]], &Grains),
    ) -> PyResult<Py<PyAny>> {
        let memory = match self.had(py, table) {
            Had::Now(array) => return Ok(array),
            Had::Memory(memory) => memory,
        };
        let shape = [self.count, 3];
        let fits = |array: &Bound<'_, PyArray2<f64>>| array.shape() == shape && is_plain(array);
        let memory = memory.and_then(|memory| memory.cast_into().ok()).filter(fits);
        let array = memory.unwrap_or_else(|| PyArray2::zeros(py, shape, false));
        self.look(|grains| {
            if let Ok(numbers) = array.readwrite().as_slice_mut() {
                fill(numbers.as_chunks_mut().0, grains);
            }
        })?;
        Ok(self.keep(py, table, array.into_any()))
    }

    /// An array of one column.
    fn list<T: Element>(
        &self,
        py: Python<'_>,
        table: Table,
        fill: impl FnOnce(&mut [T], &Grains),
    ) -> PyResult<Py<PyAny>> {
        let memory = match self.had(py, table) {
            Had::Now(array) => return Ok(array),
            Had::Memory(memory) => memory,
        };
        let fits = |array: &Bound<'_, PyArray1<T>>| array.len() == self.count && is_plain(array);
        let memory = memory.and_then(|memory| memory.cast_into().ok()).filter(fits);
        let array = memory.unwrap_or_else(|| PyArray1::zeros(py, [self.count], false));
        self.look(|grains| {
            if let Ok(numbers) = array.readwrite().as_slice_mut() {
                fill(numbers, grains);
            }
        })?;
        Ok(self.keep(py, table, array.into_any()))
    }
}

/// What there is of an array.
enum Had<'py> {
    Now(Py<PyAny>),
    Memory(Option<Bound<'py, PyAny>>),
}

/// Whether nobody else holds an object.
#[allow(unsafe_code, reason = "there is no safe way to ask")]
fn is_ours_alone(object: &Bound<'_, PyAny>) -> bool {
    // SAFETY: the object is alive, as it is borrowed
    unsafe { pyo3::ffi::Py_REFCNT(object.as_ptr()) == 1 }
}

/// Whether an array may be written, row after row.
fn is_plain<T: Element, D: Dimension>(array: &Bound<'_, PyArray<T, D>>) -> bool {
    array
        .try_readwrite()
        .is_ok_and(|mut writable| writable.as_slice_mut().is_ok())
}

fn copy_vectors(to: &mut [[f64; 3]], from: &Rows) {
    for (to, [x, y, z, _]) in to.iter_mut().zip(from.table()) {
        *to = [*x, *y, *z];
    }
}

#[pymethods]
impl ForceState {
    /// Centres [m], (n, 3).
    #[getter]
    fn positions(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.vectors(py, Table::Positions, |to, grains| copy_vectors(to, &grains.position))
    }

    /// Velocities, as predicted for the end of the step [m/s], (n, 3).
    #[getter]
    fn velocities(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.vectors(py, Table::Velocities, |to, grains| copy_vectors(to, &grains.velocity))
    }

    /// Angular velocities, as predicted for the end of the step [rad/s], (n, 3).
    #[getter]
    fn angular_velocities(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.vectors(py, Table::AngularVelocities, |to, grains| {
            copy_vectors(to, &grains.angular_velocity);
        })
    }

    /// Radii [m], (n,).
    #[getter]
    fn radii(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.list(py, Table::Radii, |to: &mut [f64], grains| {
            for (to, row) in to.iter_mut().zip(grains.position.table()) {
                *to = row[3];
            }
        })
    }

    /// Masses [kg], (n,).
    #[getter]
    fn masses(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.list(py, Table::Masses, |to: &mut [f64], grains| {
            to.iter_mut().zip(grains.masses()).for_each(|(to, mass)| *to = mass);
        })
    }

    /// Ids, (n,), of uint32.
    #[getter]
    fn ids(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.list(py, Table::Ids, |to, grains| to.copy_from_slice(&grains.id))
    }

    /// Indices of the materials, (n,), of uint16.
    #[getter]
    fn materials(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.list(py, Table::Materials, |to, grains| to.copy_from_slice(&grains.material))
    }

    /// Forces to fill [N], (n, 3); zero at first. Used when the function returns None.
    #[getter]
    fn forces(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.vectors(py, Table::Forces, |to, _| to.fill([0.0; 3]))
    }

    /// Torques to fill [N m], (n, 3); zero at first. Used when the function returns None or forces alone.
    #[getter]
    fn torques(&self, py: Python<'_>) -> PyResult<Py<PyAny>> {
        self.vectors(py, Table::Torques, |to, _| to.fill([0.0; 3]))
    }

    fn __len__(&self) -> usize {
        self.count
    }
}
