//! Values between Python and the engine.

use crate::errors::{Error, Raise, out_of_range, wrong_type, wrong_value};
use demeter_physics::dimension::Dimension;
use engine::scenario::{Foreign, MOST_THREADS, Plain, faults_with_foreign, units};
use numpy::{PyArray1, PyArray2};
use pyo3::exceptions::PyOverflowError;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyMapping, PyString, PyTuple};
use serde_json::Value;
use std::path::PathBuf;

/// Deepest nesting of a dict.
const DEEPEST: usize = 32;
/// Longest text of a wrong value in a message.
const LONGEST: usize = 60;

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

/// A wrong value with its type, for messages: `2.5 (of type float)`.
pub fn shown(value: &Bound<'_, PyAny>) -> String {
    if value.is_none() {
        return "None".to_string();
    }
    let text = value.repr().map(|repr| repr.to_string()).unwrap_or_default();
    match value.get_type().name() {
        Ok(name) if text.is_empty() => format!("a value of type {name}"),
        Ok(name) if text.chars().count() > LONGEST => {
            let begin: String = text.chars().take(LONGEST).collect();
            format!("{begin}... (of type {name})")
        }
        Ok(name) => format!("{text} (of type {name})"),
        Err(_) => "a value".to_string(),
    }
}

/// A dict, or what else has keys and values.
pub fn dict<'py>(value: &Bound<'py, PyAny>, name: &str, example: &str) -> PyResult<Bound<'py, PyDict>> {
    if let Ok(dict) = value.cast::<PyDict>() {
        return Ok(dict.clone());
    }
    if value.cast::<PyMapping>().is_ok() {
        let dict = PyDict::new(value.py());
        dict.update(value.cast::<PyMapping>()?)?;
        return Ok(dict);
    }
    Err(wrong_type(format!(
        "`{name}` must be a dict, as {example}, not {}",
        shown(value)
    )))
}

/// Overrides as the command line takes them: a dict of keys and values.
pub fn overrides(set: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<String>> {
    let Some(set) = set else { return Ok(Vec::new()) };
    let mut reader = PlainReader::default();
    let mut all = Vec::new();
    for (key, value) in dict(set, "set", "{\"grains[0].count\": 200}")? {
        let key: String = key.extract().map_err(|_| {
            let found = shown(&key);
            wrong_type(format!(
                "the keys of `set` are texts, as \"grains[0].count\", not {found}"
            ))
        })?;
        all.push(format!("{key}={}", reader.read(&value, &key)?.inline()));
    }
    match reader.foreign.is_empty() {
        true => Ok(all),
        false => Err(faults_with_foreign("", "set", &reader.foreign, None).raise(set.py())),
    }
}

/// A quantity: a text with a unit of this dimension, or a number in SI.
pub fn quantity(value: &Bound<'_, PyAny>, name: &str, dimension: Dimension) -> PyResult<f64> {
    let (what, unit) = (dimension.name(), dimension.unit());
    let allowed = match dimension {
        Dimension::NONE => "a number without a unit".to_string(),
        _ => format!("a {what}, as \"1 {unit}\", or a number in SI ({unit})"),
    };
    if let Ok(text) = value.cast::<PyString>() {
        let text = text.to_string();
        let read = units::parse(&text)
            .map_err(|error| wrong_value(format!("`{name}` must be {allowed}, found \"{text}\": {error}")))?;
        if read.dimension != dimension {
            let hint = if read.has_unit { "" } else { ", which has no unit" };
            return Err(wrong_value(format!(
                "`{name}` must be {allowed}, found \"{text}\"{hint}"
            )));
        }
        return Ok(read.value);
    }
    match value.extract::<f64>() {
        Ok(number) if !value.is_instance_of::<PyBool>() => Ok(number),
        _ => Err(wrong_type(format!("`{name}` must be {allowed}, not {}", shown(value)))),
    }
}

/// The same where nothing may be given.
pub fn optional_quantity(value: Option<&Bound<'_, PyAny>>, name: &str, dimension: Dimension) -> PyResult<Option<f64>> {
    value.map(|value| quantity(value, name, dimension)).transpose()
}

/// A whole number that is at least `least`.
pub fn whole(value: &Bound<'_, PyAny>, name: &str, least: u64) -> PyResult<u64> {
    let is_bool = value.is_instance_of::<PyBool>();
    match value.extract::<u64>() {
        Ok(number) if !is_bool && number >= least => Ok(number),
        Err(error) if !error.is_instance_of::<PyOverflowError>(value.py()) => Err(not_whole(value, name)),
        _ if is_bool => Err(not_whole(value, name)),
        _ => Err(wrong_value(format!(
            "`{name}` is {}; it must be a whole number from {least} on",
            shown(value)
        ))),
    }
}

/// A whole number of either sign.
pub fn index(value: &Bound<'_, PyAny>, name: &str) -> PyResult<isize> {
    match value.extract::<isize>() {
        Ok(number) if !value.is_instance_of::<PyBool>() => Ok(number),
        Err(error) if error.is_instance_of::<PyOverflowError>(value.py()) => Err(out_of_range(format!(
            "`{name}` is {}, far beyond everything",
            shown(value)
        ))),
        _ => Err(not_whole(value, name)),
    }
}

fn not_whole(value: &Bound<'_, PyAny>, name: &str) -> PyErr {
    wrong_type(format!("`{name}` must be a whole number, not {}", shown(value)))
}

/// The same where nothing may be given, for numbers of things in memory.
pub fn optional_count(value: Option<&Bound<'_, PyAny>>, name: &str, least: u64) -> PyResult<Option<usize>> {
    let count = |value| whole(value, name, least).map(|number| usize::try_from(number).unwrap_or(usize::MAX));
    value.map(count).transpose()
}

/// A number of threads.
pub fn threads(value: Option<&Bound<'_, PyAny>>) -> PyResult<Option<usize>> {
    match optional_count(value, "threads", 1)? {
        Some(threads) if threads > usize::from(MOST_THREADS) => Err(wrong_value(format!(
            "`threads` is {threads}; at most {MOST_THREADS} are allowed"
        ))),
        threads => Ok(threads),
    }
}

/// True or False.
pub fn flag(value: &Bound<'_, PyAny>, name: &str) -> PyResult<bool> {
    let wrong = |_| wrong_type(format!("`{name}` must be True or False, not {}", shown(value)));
    value.cast::<PyBool>().map(|told| told.is_true()).map_err(wrong)
}

/// A text.
pub fn text(value: &Bound<'_, PyAny>, name: &str) -> PyResult<String> {
    let wrong = |_| wrong_type(format!("`{name}` must be a text, not {}", shown(value)));
    value.cast::<PyString>().map(|told| told.to_string()).map_err(wrong)
}

/// Three numbers, or three quantities.
pub fn three(value: &Bound<'_, PyAny>, name: &str, dimension: Dimension) -> PyResult<[f64; 3]> {
    let wrong = || {
        wrong_type(format!(
            "`{name}` must be three numbers, as (0, 0, 1), not {}",
            shown(value)
        ))
    };
    if value.cast::<PyString>().is_ok() {
        return Err(wrong());
    }
    let items: [Bound<'_, PyAny>; 3] = value.extract().map_err(|_| wrong())?;
    let [x, y, z] = items.each_ref().map(|item| quantity(item, name, dimension));
    let three = [x?, y?, z?];
    match three.iter().all(|number| number.is_finite()) {
        true => Ok(three),
        false => Err(wrong_value(format!(
            "`{name}` is {}, which is not finite",
            shown(value)
        ))),
    }
}

/// A function.
pub fn function<'a, 'py>(value: &'a Bound<'py, PyAny>, name: &str, takes: &str) -> PyResult<&'a Bound<'py, PyAny>> {
    match value.is_callable() {
        true => Ok(value),
        false => Err(wrong_type(format!(
            "`{name}` must be a function of {takes} (it is not called here: no brackets), not {}",
            shown(value)
        ))),
    }
}

/// A path, with `~` opened.
pub fn path(value: &Bound<'_, PyAny>, name: &str) -> PyResult<PathBuf> {
    let wrong = |_| wrong_type(format!("`{name}` must be a path, not {}", shown(value)));
    let opened = value.py().import("os.path")?.call_method1("expanduser", (value,));
    let path: PathBuf = opened.map_err(wrong)?.extract().map_err(wrong)?;
    if path.as_os_str().is_empty() {
        return Err(wrong_value(format!(
            "`{name}` is {}; it must be a path, \".\" for the working directory",
            shown(value)
        )));
    }
    Ok(path)
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
