//! Values between Python and the engine.

use crate::errors::{Error, Raise};
use demeter_physics::dimension::Dimension;
use engine::scenario::{Foreign, Plain, faults_with_foreign, units};
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString, PyTuple};
use serde_json::Value;
use std::path::PathBuf;

/// Deepest nesting of a dict.
const DEEPEST: usize = 32;

/// Reads Python values as those of a scenario, and notes which are none.
#[derive(Default)]
pub struct PlainReader {
    pub foreign: Vec<Foreign>,
}

impl PlainReader {
    /// A value; `path` is that of its key, for messages.
    pub fn read(&mut self, value: &Bound<'_, PyAny>, path: &str) -> PyResult<Plain> {
        self.below(value, path, DEEPEST)
    }

    /// Notes a value that is none of a scenario; a text stands in for it.
    fn wrong(&mut self, path: &str, found: &str, message: String) -> Plain {
        self.foreign.push(Foreign {
            path: path.to_string(),
            message,
        });
        Plain::Text(found.to_string())
    }

    fn below(&mut self, value: &Bound<'_, PyAny>, path: &str, deepest: usize) -> PyResult<Plain> {
        if deepest == 0 {
            return Ok(self.wrong(path, "...", format!("`{path}` is nested too deeply")));
        }
        if let Ok(text) = value.cast::<PyString>() {
            return Ok(Plain::Text(text.to_string()));
        }
        if value.is_instance_of::<PyBool>() {
            return Ok(Plain::Boolean(value.extract()?));
        }
        if let Ok(entries) = value.cast::<PyDict>() {
            return self.table(entries, path, deepest);
        }
        if value.is_instance_of::<PyFloat>() {
            return Ok(Plain::Number(value.extract()?));
        }
        if value.is_instance_of::<PyInt>() {
            return Ok(match value.extract::<i64>() {
                Ok(integer) => Plain::Integer(integer),
                Err(_) => self.wrong(
                    path,
                    "a large int",
                    format!("`{path}` is {value}, which does not fit 64 bits"),
                ),
            });
        }
        if value.is_instance_of::<PyList>() || value.is_instance_of::<PyTuple>() {
            let items = value.try_iter()?.enumerate();
            let items = items.map(|(k, item)| self.below(&item?, &format!("{path}[{k}]"), deepest - 1));
            return Ok(Plain::List(items.collect::<PyResult<_>>()?));
        }
        // arrays and numbers of NumPy
        if value.hasattr("tolist")? {
            return self.below(&value.call_method0("tolist")?, path, deepest - 1);
        }
        if value.hasattr("__fspath__")? {
            return Ok(Plain::Text(value.call_method0("__fspath__")?.extract()?));
        }
        let found = kind(value);
        let message = format!(
            "`{path}` is {found}; a scenario holds texts (as \"2 mm\"), numbers, True and False, lists and dicts"
        );
        Ok(self.wrong(path, &found, message))
    }

    fn table(&mut self, entries: &Bound<'_, PyDict>, path: &str, deepest: usize) -> PyResult<Plain> {
        let mut read = Vec::with_capacity(entries.len());
        for (key, value) in entries {
            let Ok(key) = key.extract::<String>() else {
                let place = if path.is_empty() { "the scenario" } else { path };
                self.foreign.push(Foreign {
                    path: path.to_string(),
                    message: format!("a key of {place} is {}; keys are texts", kind(&key)),
                });
                continue;
            };
            let path = if path.is_empty() {
                key.clone()
            } else {
                format!("{path}.{key}")
            };
            let value = self.below(&value, &path, deepest - 1)?;
            read.push((key, value));
        }
        Ok(Plain::Table(read))
    }
}

/// The type of a value, for messages: `None`, `a value of type set`.
pub fn kind(value: &Bound<'_, PyAny>) -> String {
    if value.is_none() {
        return "None".to_string();
    }
    let name = value.get_type().name();
    name.map_or_else(|_| "a value".to_string(), |name| format!("a value of type {name}"))
}

/// Overrides as the command line takes them: a dict of keys and values.
pub fn overrides(set: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<String>> {
    let Some(set) = set else { return Ok(Vec::new()) };
    let mut reader = PlainReader::default();
    let mut all = Vec::new();
    for (key, value) in set {
        let key: String = key
            .extract()
            .map_err(|_| PyTypeError::new_err("the keys of `set` are texts, as \"grains[0].count\""))?;
        all.push(format!("{key}={}", reader.read(&value, &key)?.inline()));
    }
    match reader.foreign.is_empty() {
        true => Ok(all),
        false => Err(faults_with_foreign("", "set", &reader.foreign, None).raise(set.py())),
    }
}

/// A quantity: a text with a unit of this dimension, or a number in SI.
pub fn quantity(value: &Bound<'_, PyAny>, name: &str, dimension: Dimension) -> PyResult<f64> {
    if let Ok(text) = value.cast::<PyString>() {
        let text = text.to_string();
        let read = units::parse(&text).map_err(|error| PyValueError::new_err(format!("`{name}`: {error}")))?;
        if read.dimension != dimension {
            let message = format!("`{name}` must be a {}, found \"{text}\"", dimension.name());
            return Err(PyValueError::new_err(message));
        }
        return Ok(read.value);
    }
    match value.extract::<f64>() {
        Ok(number) if !value.is_instance_of::<PyBool>() => Ok(number),
        _ => Err(PyTypeError::new_err(format!(
            "`{name}` must be a text with a unit, or a number in SI ({}), not {}",
            dimension.unit(),
            kind(value)
        ))),
    }
}

/// The same where nothing may be given.
pub fn optional_quantity(value: Option<&Bound<'_, PyAny>>, name: &str, dimension: Dimension) -> PyResult<Option<f64>> {
    value.map(|value| quantity(value, name, dimension)).transpose()
}

/// A path, with `~` opened.
pub fn path(value: &Bound<'_, PyAny>, name: &str) -> PyResult<PathBuf> {
    let wrong = |_| PyTypeError::new_err(format!("`{name}` must be a path, not {}", kind(value)));
    let opened = value.py().import("os.path")?.call_method1("expanduser", (value,));
    opened.map_err(wrong)?.extract().map_err(wrong)
}

/// JSON as Python values.
pub fn from_json<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(match value {
        Value::Null => py.None().into_bound(py),
        Value::Bool(value) => PyBool::new(py, *value).to_owned().into_any(),
        Value::Number(number) => match (number.as_i64(), number.as_f64()) {
            (Some(integer), _) => integer.into_pyobject(py)?.into_any(),
            (None, number) => number.unwrap_or(f64::NAN).into_pyobject(py)?.into_any(),
        },
        Value::String(text) => PyString::new(py, text).into_any(),
        Value::Array(items) => {
            let list = PyList::empty(py);
            for item in items {
                list.append(from_json(py, item)?)?;
            }
            list.into_any()
        }
        Value::Object(entries) => {
            let dict = PyDict::new(py);
            for (key, value) in entries {
                dict.set_item(key, from_json(py, value)?)?;
            }
            dict.into_any()
        }
    })
}

/// Vectors as an array of three columns.
pub fn vectors<'py>(
    py: Python<'py>,
    rows: impl ExactSizeIterator<Item = [f64; 3]>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let count = rows.len();
    let numbers: Vec<f64> = rows.flatten().collect();
    let array = PyArray1::from_vec(py, numbers);
    let table = array.call_method1("reshape", ((count, 3),))?;
    table
        .cast_into::<PyArray2<f64>>()
        .map_err(|_| Error::new_err("an array has a wrong shape"))
}

/// One vector.
pub fn vector(py: Python<'_>, value: [f64; 3]) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_slice(py, &value)
}
