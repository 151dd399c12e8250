//! The contacts of a moment, as arrays without copies.
//!
//! The engine holds contacts in pieces and only part of what a row tells, so their table is put together, once for every state of
//! the simulation in which it is asked for. It never changes: arrays show it for as long as they live, the simulation until it
//! goes on.

use crate::views::{Memory, show1, show2};
use engine::measure::ContactColumns;
use engine::scenario::LiveRun;
use glam::DVec3;
use numpy::Element;
use numpy::ndarray::{ArrayView1, ArrayView2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// The table of the present state, if it was asked for.
#[derive(Default)]
pub struct ContactTable(Option<Arc<ContactColumns>>);

impl ContactTable {
    /// Gives the table up: the state is about to change.
    pub fn forget(&mut self) {
        self.0 = None;
    }

    /// The table as a dict of arrays.
    pub fn dict<'py>(&mut self, py: Python<'py>, run: &mut LiveRun) -> PyResult<Bound<'py, PyDict>> {
        let table = self
            .0
            .get_or_insert_with(|| Arc::new(run.change(|sim| ContactColumns::of(sim))));
        let shown = Shown {
            memory: Memory::keeping(py, Arc::<ContactColumns>::clone(table))?,
            dict: PyDict::new(py),
        };
        shown.list("i", &table.id_i)?;
        shown.list("j", &table.id_j)?;
        shown.list("wall", &table.wall)?;
        shown.list("overlap", &table.overlap)?;
        shown.vectors("position", &table.position)?;
        shown.vectors("normal", &table.normal)?;
        shown.vectors("force", &table.force)?;
        shown.vectors("normal_force", &table.normal_force)?;
        shown.vectors("tangential_force", &table.tangential_force)?;
        shown.vectors("rolling_torque", &table.rolling_torque)?;
        Ok(shown.dict)
    }
}

/// Columns of a table on their way into a dict.
struct Shown<'py> {
    memory: Bound<'py, PyAny>,
    dict: Bound<'py, PyDict>,
}

impl Shown<'_> {
    #[allow(
        unsafe_code,
        reason = "`memory` keeps the table that the column is part of, and nothing changes it"
    )]
    fn list<T: Element>(&self, name: &str, column: &[T]) -> PyResult<()> {
        // SAFETY: the column lives, unchanged, until the memory is dropped
        let array = unsafe { show1(ArrayView1::from(column), self.memory.clone()) };
        self.dict.set_item(name, array)
    }

    #[allow(
        unsafe_code,
        reason = "`memory` keeps the table that the column is part of, and nothing changes it"
    )]
    fn vectors(&self, name: &str, column: &[DVec3]) -> PyResult<()> {
        let rows: &[[f64; 3]] = bytemuck::cast_slice(column);
        // SAFETY: the column lives, unchanged, until the memory is dropped
        let array = unsafe { show2(ArrayView2::from(rows), self.memory.clone()) };
        self.dict.set_item(name, array)
    }
}
