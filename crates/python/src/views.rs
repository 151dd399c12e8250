//! Arrays that show tables of a simulation without a copy.
//!
//! The memory of a table belongs to the simulation until this is to change it. Then, if any array still shows the table, the
//! simulation goes on with a copy and leaves the old memory to the arrays. So an array shows the moment at which it was
//! taken for as long as it lives; nobody ever sees a table half changed, and nobody waits.

use crate::errors::{Error, RunError};
use crate::simulation::Simulation;
use bytemuck::Pod;
use engine::particles::{Grains, Load, Rows};
use engine::simulation::Simulation as EngineSimulation;
use glam::DQuat;
use numpy::ndarray::{ArrayView1, ArrayView2, ShapeBuilder};
use numpy::{Element, PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use std::any::Any;
use std::sync::{Arc, Mutex, PoisonError, Weak};

/// The tables that arrays show.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Table {
    Position,
    Velocity,
    AngularVelocity,
    Orientation,
    Load,
    Id,
    Material,
}

/// Keeps the memory of a table alive for the arrays that show it.
struct Keeper {
    table: Table,
    held: Mutex<Held>,
}

enum Held {
    /// The memory is the simulation's.
    BySimulation { _owner: Py<Simulation> },
    /// The memory is here.
    Here { _memory: Box<dyn Any + Send + Sync> },
}

/// What arrays have for a base: it lives as long as they do.
#[pyclass(module = "demeter", name = "_Memory", frozen)]
pub struct Memory {
    _kept: Arc<dyn Any + Send + Sync>,
}

impl Memory {
    /// A base that keeps something alive.
    pub fn keeping<'py>(py: Python<'py>, kept: Arc<dyn Any + Send + Sync>) -> PyResult<Bound<'py, PyAny>> {
        Ok(Bound::new(py, Self { _kept: kept })?.into_any())
    }
}

/// The arrays of one simulation.
#[derive(Default)]
pub struct Views {
    keepers: Vec<Weak<Keeper>>,
}

impl Views {
    /// Something to keep the memory of a table alive.
    fn keeper<'py>(&mut self, owner: &Bound<'py, Simulation>, table: Table) -> PyResult<Bound<'py, PyAny>> {
        let alive = self.keepers.iter().filter_map(Weak::upgrade).find(|k| k.table == table);
        let keeper = alive.unwrap_or_else(|| {
            let held = Held::BySimulation {
                _owner: owner.clone().unbind(),
            };
            let keeper = Arc::new(Keeper {
                table,
                held: Mutex::new(held),
            });
            self.keepers.push(Arc::downgrade(&keeper));
            keeper
        });
        Memory::keeping(owner.py(), keeper)
    }

    /// Gives the tables that arrays show to these arrays; the simulation goes on with copies. To be called before anything
    /// changes or moves a table.
    pub fn part(&mut self, simulation: &mut EngineSimulation) {
        for keeper in self.keepers.drain(..).filter_map(|keeper| keeper.upgrade()) {
            let memory = take(simulation.grains_mut(), keeper.table);
            let mut held = keeper.held.lock().unwrap_or_else(PoisonError::into_inner);
            *held = Held::Here { _memory: memory };
        }
    }

    /// Whether any array shows a table.
    pub fn any(&self) -> bool {
        self.keepers.iter().any(|keeper| keeper.strong_count() > 0)
    }
}

/// The memory of a table, in whose place a copy is put.
fn take(grains: &mut Grains, table: Table) -> Box<dyn Any + Send + Sync> {
    fn swap<T: Clone + Send + Sync + 'static>(place: &mut T) -> Box<dyn Any + Send + Sync> {
        let copy = place.clone();
        Box::new(std::mem::replace(place, copy))
    }
    match table {
        Table::Position => swap(&mut grains.position),
        Table::Velocity => swap(&mut grains.velocity),
        Table::AngularVelocity => swap(&mut grains.angular_velocity),
        Table::Orientation => swap(&mut grains.orientation),
        Table::Load => swap(&mut grains.load),
        Table::Id => swap(&mut grains.id),
        Table::Material => swap(&mut grains.material),
    }
}

/// A table of a simulation, about to be shown.
pub struct Showing<'a, 'py> {
    pub owner: &'a Bound<'py, Simulation>,
    pub views: &'a mut Views,
    pub table: Table,
}

impl<'py> Showing<'_, 'py> {
    /// The vectors of rows, as an array of three columns.
    pub fn vectors(self, rows: &Rows) -> PyResult<Bound<'py, PyAny>> {
        self.vectors_of(rows, 0)
    }

    /// Forces.
    pub fn forces(self, loads: &Rows<Load>) -> PyResult<Bound<'py, PyAny>> {
        self.vectors_of(loads, 0)
    }

    /// Torques.
    pub fn torques(self, loads: &Rows<Load>) -> PyResult<Bound<'py, PyAny>> {
        self.vectors_of(loads, 4)
    }

    /// The vectors that stand behind so many numbers of every row.
    fn vectors_of<T: Pod>(self, rows: &Rows<T>, behind: usize) -> PyResult<Bound<'py, PyAny>> {
        let width = size_of::<T>() / size_of::<f64>();
        let view = match rows.is_empty() {
            // where there is nothing, strides lead out of it
            true => ArrayView2::from_shape((0, 3), &[]),
            false => ArrayView2::from_shape((rows.len(), 3).strides((width, 1)), &rows.numbers()[behind..]),
        };
        self.show2(view.map_err(|e| Error::new_err(e.to_string()))?)
    }

    /// The numbers beside the vectors.
    pub fn scalars(self, rows: &Rows) -> PyResult<Bound<'py, PyAny>> {
        self.beside(rows)
    }

    /// Masses.
    pub fn masses(self, loads: &Rows<Load>) -> PyResult<Bound<'py, PyAny>> {
        self.beside(loads)
    }

    /// The numbers beside the first vectors of all rows.
    fn beside<T: Pod>(self, rows: &Rows<T>) -> PyResult<Bound<'py, PyAny>> {
        let width = size_of::<T>() / size_of::<f64>();
        let behind = rows.numbers().get(3..).unwrap_or(&[]);
        let view = ArrayView1::from_shape((rows.len(),).strides((width,)), behind);
        self.show1(view.map_err(|e| Error::new_err(e.to_string()))?)
    }

    /// Orientations of the grains, where they are followed, as an array of four columns.
    pub fn orientations(self, grains: &Grains) -> PyResult<Bound<'py, PyAny>> {
        let list = grains.orientation.as_deref().ok_or_else(|| {
            let why = "it is not followed how the grains of this run turn: begin it with `orientations = true` in [simulation]";
            RunError::new_err(why)
        })?;
        let view = ArrayView2::from_shape((list.len(), 4), bytemuck::cast_slice::<DQuat, f64>(list));
        self.show2(view.map_err(|e| Error::new_err(e.to_string()))?)
    }

    /// A list as it is.
    pub fn list<T: Element>(self, list: &[T]) -> PyResult<Bound<'py, PyAny>> {
        self.show1(ArrayView1::from(list))
    }

    #[allow(
        unsafe_code,
        reason = "the keeper keeps the memory, which `Views::part` never lets change"
    )]
    fn show1<T: Element>(self, view: ArrayView1<'_, T>) -> PyResult<Bound<'py, PyAny>> {
        let keeper = self.views.keeper(self.owner, self.table)?;
        // SAFETY: the memory is the table's, and lives until the keeper is dropped
        Ok(unsafe { show1(view, keeper) })
    }

    #[allow(
        unsafe_code,
        reason = "the keeper keeps the memory, which `Views::part` never lets change"
    )]
    fn show2<T: Element>(self, view: ArrayView2<'_, T>) -> PyResult<Bound<'py, PyAny>> {
        let keeper = self.views.keeper(self.owner, self.table)?;
        // SAFETY: the memory is the table's, and lives until the keeper is dropped
        Ok(unsafe { show2(view, keeper) })
    }
}

/// A read-only array of numbers where they lie.
///
/// # Safety
///
/// The numbers must live, unchanged, until the base is dropped.
#[allow(unsafe_code, reason = "an array without a copy can outlive a borrow")]
pub unsafe fn show1<'py, T: Element>(view: ArrayView1<'_, T>, base: Bound<'py, PyAny>) -> Bound<'py, PyAny> {
    // SAFETY: told above
    let array = unsafe { PyArray1::borrow_from_array(&view, base) };
    array.readwrite().make_nonwriteable();
    array.into_any()
}

/// A read-only array of rows where they lie.
///
/// # Safety
///
/// The numbers must live, unchanged, until the base is dropped.
#[allow(unsafe_code, reason = "an array without a copy can outlive a borrow")]
pub unsafe fn show2<'py, T: Element>(view: ArrayView2<'_, T>, base: Bound<'py, PyAny>) -> Bound<'py, PyAny> {
    // SAFETY: told above
    let array = unsafe { PyArray2::borrow_from_array(&view, base) };
    array.readwrite().make_nonwriteable();
    array.into_any()
}
