//! What runs left in their folders, as arrays.

use crate::aside::aside;
use crate::control::logger;
use crate::convert::{index, path, vectors};
use crate::errors::{OrRaise, out_of_range};
use engine::output::vtp::{Array, PolyData, Values};
use engine::output::{SeriesTable, SeriesValues};
use engine::results::{Cells, Columns, Run};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// A series in memory as a dict of columns.
pub fn series_dict<'py>(py: Python<'py>, table: &SeriesTable) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for (title, values) in table.columns() {
        match values {
            SeriesValues::Counts(counts) => dict.set_item(title, counts.clone().into_pyarray(py))?,
            SeriesValues::Numbers(numbers) => dict.set_item(title, numbers.clone().into_pyarray(py))?,
            SeriesValues::Names(names) => dict.set_item(title, PyList::new(py, names)?)?,
        }
    }
    Ok(dict)
}

/// A table of a file as a dict of columns.
pub fn columns_dict<'py>(py: Python<'py>, columns: &Columns) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    for column in columns.all() {
        match &column.cells {
            Cells::Numbers(numbers) => dict.set_item(&column.title, numbers.clone().into_pyarray(py))?,
            Cells::Words { words, rows } => {
                let words = rows.iter().map(|k| words.get(*k as usize).map_or("", String::as_str));
                dict.set_item(&column.title, PyList::new(py, words.collect::<Vec<_>>())?)?;
            }
        }
    }
    Ok(dict)
}

/// The series of a run as a dict of columns, titled with their units: ``pandas.DataFrame(demeter.read_series(folder))``. Rows that a
/// finished run lacks are told as a warning to ``logging``.
///
/// Parameters
/// ----------
/// folder : path
///     Folder of a run, or a table that a run wrote, as ``runs/drum/profiles/height.csv``.
#[pyfunction]
pub fn read_series<'py>(py: Python<'py>, folder: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyDict>> {
    let folder = path(folder, "folder")?;
    let (columns, lacking) = aside(py, || {
        if folder.is_file() {
            return (Columns::read(&folder), None);
        }
        let columns = Columns::series_of(&folder);
        let shortfall = |columns| Run::open(&folder).ok()?.shortfall(columns).ok()?;
        let lacking = columns.as_ref().ok().and_then(shortfall);
        (columns, lacking)
    })?;
    let columns = columns.or_raise(py)?;
    if let Some(problem) = lacking {
        let told = format!("`{}`: {problem}", columns.path().display());
        logger(py)?.call_method1("warning", ("%s", told))?;
    }
    columns_dict(py, &columns)
}

/// The frames of a run: a list of (step, time [s]).
#[pyfunction]
pub fn frames(py: Python<'_>, folder: &Bound<'_, PyAny>) -> PyResult<Vec<(u64, f64)>> {
    let moments = Run::open(&path(folder, "folder")?)
        .or_raise(py)?
        .moments()
        .or_raise(py)?;
    Ok(moments.iter().map(|moment| (moment.step, moment.time)).collect())
}

/// A frame of a run, by its number; negative ones count from the end.
///
/// Returns
/// -------
/// dict
///     ``step``, ``time`` [s], and ``grains``, ``contacts`` and ``walls``: dicts of arrays with a row for each (of walls: for each
///     triangle), named as in the files for ParaView, with ``points`` [m].
#[pyfunction]
#[pyo3(signature = (folder, frame=None), text_signature = "(folder, frame=-1)")]
pub fn read_frame<'py>(
    py: Python<'py>,
    folder: &Bound<'py, PyAny>,
    frame: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let frame = frame.map_or(Ok(-1), |frame| index(frame, "frame"))?;
    let run = Run::open(&path(folder, "folder")?).or_raise(py)?;
    let moments = run.moments().or_raise(py)?;
    let at = if frame < 0 {
        frame.saturating_add_unsigned(moments.len())
    } else {
        frame
    };
    let Some(moment) = usize::try_from(at).ok().and_then(|at| moments.get(at)) else {
        let count = moments.len();
        let there = match count {
            0 => "the run has none yet".to_string(),
            count => format!(
                "the run has {count}: 0 to {}, or -{count} to -1 from the end",
                count - 1
            ),
        };
        return Err(out_of_range(format!("there is no frame {frame}; {there}")));
    };
    let tables = aside(py, || run.frame(moment.step))?.or_raise(py)?;
    let dict = PyDict::new(py);
    dict.set_item("step", moment.step)?;
    dict.set_item("time", moment.time)?;
    for (name, table) in [
        ("grains", &tables.grains),
        ("contacts", &tables.contacts),
        ("walls", &tables.walls),
    ] {
        dict.set_item(name, table_dict(py, table)?)?;
    }
    Ok(dict)
}

fn table_dict<'py>(py: Python<'py>, table: &PolyData) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    dict.set_item("points", vectors(py, table.points.iter().map(|p| p.to_array()))?)?;
    for array in table.point_data.iter().chain(&table.cell_data) {
        dict.set_item(array.name.as_ref(), numbers(py, array)?)?;
    }
    for (name, texts) in &table.texts {
        dict.set_item(name.as_ref(), texts)?;
    }
    Ok(dict)
}

fn numbers<'py>(py: Python<'py>, array: &Array) -> PyResult<Bound<'py, PyAny>> {
    let flat = match &array.values {
        Values::Float64(values) => values.clone().into_pyarray(py).into_any(),
        Values::Int32(values) => values.clone().into_pyarray(py).into_any(),
        Values::UInt32(values) => values.clone().into_pyarray(py).into_any(),
        Values::Int64(values) => values.clone().into_pyarray(py).into_any(),
    };
    if array.components == 1 {
        return Ok(flat);
    }
    flat.call_method1("reshape", ((-1, array.components),))
}
