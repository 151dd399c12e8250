//! What a run shows beside its tables.

use crate::convert::vector;
use crate::errors::{OrRaise, OutputError};
use crate::results::{columns_dict, series_dict};
use engine::results::Columns;
use engine::scenario::LiveRun;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The walls by name.
pub(super) fn walls_dict<'py>(py: Python<'py>, run: &LiveRun) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    run.with_simulation(|sim| {
        for wall in &sim.walls {
            let (force, torque) = wall.load();
            let one = PyDict::new(py);
            for (name, value) in [
                ("force", force),
                ("torque", torque),
                ("position", wall.origin()),
                ("displacement", wall.displacement()),
                ("velocity", wall.velocity_at(wall.origin())),
                ("angular_velocity", wall.angular_velocity()),
            ] {
                one.set_item(name, vector(py, value.to_array()))?;
            }
            one.set_item("work", wall.work().work)?;
            one.set_item("present", wall.is_present())?;
            all.set_item(&wall.name, one)?;
        }
        Ok(all)
    })
}

/// A row of the series, now.
pub(super) fn present_dict<'py>(py: Python<'py>, run: &mut LiveRun) -> PyResult<Bound<'py, PyDict>> {
    let columns = series_dict(py, &run.present())?;
    let dict = PyDict::new(py);
    for (title, column) in &columns {
        let value = column.get_item(0)?;
        let value = if value.hasattr("item")? {
            value.call_method0("item")?
        } else {
            value
        };
        dict.set_item(title, value)?;
    }
    Ok(dict)
}

/// The series so far, from memory or from the folder.
pub(super) fn live_series<'py>(py: Python<'py>, run: &LiveRun) -> PyResult<Bound<'py, PyDict>> {
    if let Some(columns) = run.with_series(|table| series_dict(py, table)) {
        return columns;
    }
    let folder = run
        .folder()
        .ok_or_else(|| OutputError::new_err("this run has no folder"))?;
    columns_dict(py, &Columns::series_of(folder).or_raise(py)?)
}
