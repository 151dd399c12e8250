//! The exceptions, with the messages of the command line.

use engine::calibrate::CalibrateError;
use engine::calibrate::packing::PackingError;
use engine::checkpoint::CheckpointError;
use engine::compare::CompareError;
use engine::contacts::Fault as EngineFault;
use engine::output::OutputError as EngineOutputError;
use engine::results::ResultsError;
use engine::scenario::{Diagnostics, RunError as EngineRunError, suggest_or_list};
use engine::simulation::{ChangeError, CustomMotionError};
use pyo3::create_exception;
use pyo3::exceptions::{PyBaseException, PyException, PyIndexError, PyKeyError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyList, PyType};

create_exception!(
    demeter,
    Error,
    PyException,
    "Everything that Demeter refuses or cannot do."
);
create_exception!(
    demeter,
    ScenarioError,
    Error,
    "A scenario or another input file is wrong.\n\nThe message shows every fault with its line. `faults` lists them as dicts with \
     `path` (the key, as `stage[0].duration`), `message`, `help`, `source`, `line` and `column`."
);
create_exception!(demeter, RunError, Error, "A run cannot be begun, continued or changed.");
create_exception!(
    demeter,
    Fault,
    RunError,
    "The simulation reached a state that its model does not cover.\n\n`grain` is the id of the grain at fault, 0 where it is none."
);
create_exception!(
    demeter,
    OutputError,
    Error,
    "A file or folder cannot be read or written."
);
create_exception!(
    demeter,
    CollisionError,
    Error,
    "Two bodies cannot be computed as asked."
);

create_exception!(
    demeter,
    ArgumentError,
    Error,
    "An argument of a function is wrong.\n\nThose below it are also the exception that Python has for such a case, as ValueError."
);

/// What is wrong with an argument. Each kind is a class below [`ArgumentError`] and below an exception of Python, so that both
/// `except demeter.Error` and `except ValueError` catch it.
#[derive(Clone, Copy)]
enum Argument {
    Type,
    Value,
    Name,
    Index,
}

const ARGUMENTS: [Argument; 4] = [Argument::Type, Argument::Value, Argument::Name, Argument::Index];
static CLASSES: [PyOnceLock<Py<PyType>>; 4] = [const { PyOnceLock::new() }; 4];

impl Argument {
    fn name(self) -> &'static str {
        match self {
            Self::Type => "WrongType",
            Self::Value => "WrongValue",
            Self::Name => "UnknownName",
            Self::Index => "OutOfRange",
        }
    }

    fn about(self) -> &'static str {
        match self {
            Self::Type => "An argument is of a type that is not understood; also a TypeError.",
            Self::Value => "An argument has a value that it cannot have; also a ValueError.",
            Self::Name => "There is nothing of this name; also a KeyError.",
            Self::Index => "There is nothing of this number; also an IndexError.",
        }
    }

    fn class(self, py: Python<'_>) -> PyResult<&Bound<'_, PyType>> {
        let class = CLASSES[self as usize].get_or_try_init(py, || {
            let of_python = match self {
                Self::Type => py.get_type::<PyTypeError>(),
                Self::Value => py.get_type::<PyValueError>(),
                Self::Name => py.get_type::<PyKeyError>(),
                Self::Index => py.get_type::<PyIndexError>(),
            };
            let dict = PyDict::new(py);
            dict.set_item("__module__", "demeter")?;
            dict.set_item("__doc__", self.about())?;
            // a KeyError shows its message in quotes
            dict.set_item("__str__", py.get_type::<PyBaseException>().getattr("__str__")?)?;
            let bases = (py.get_type::<ArgumentError>(), of_python);
            let class = py.get_type::<PyType>().call1((self.name(), bases, dict))?;
            Ok::<_, PyErr>(class.cast_into::<PyType>()?.unbind())
        })?;
        Ok(class.bind(py))
    }

    fn error(self, message: String) -> PyErr {
        Python::attach(|py| match self.class(py) {
            Ok(class) => PyErr::from_type(class.clone(), message),
            Err(error) => error,
        })
    }
}

/// An argument is of a type that is not understood.
pub fn wrong_type(message: impl Into<String>) -> PyErr {
    Argument::Type.error(message.into())
}

/// An argument has a value that it cannot have.
pub fn wrong_value(message: impl Into<String>) -> PyErr {
    Argument::Value.error(message.into())
}

/// There is no `what` called `name`; tells what is close to it, or what there is.
pub fn unknown_name<'k>(what: &str, name: &str, known: impl IntoIterator<Item = &'k str>) -> PyErr {
    let help = suggest_or_list(name, known).unwrap_or_else(|| "there are none".to_string());
    Argument::Name.error(format!("there is no {what} `{name}`; {help}"))
}

/// There is nothing of a number or name.
pub fn not_there(message: impl Into<String>) -> PyErr {
    Argument::Name.error(message.into())
}

/// There is nothing of a number.
pub fn out_of_range(message: impl Into<String>) -> PyErr {
    Argument::Index.error(message.into())
}

/// An engine error as a Python exception.
pub trait Raise {
    /// The exception.
    fn raise(self, py: Python<'_>) -> PyErr;
}

/// Turns the error of a result into an exception.
pub trait OrRaise<T> {
    /// The value, or the exception.
    fn or_raise(self, py: Python<'_>) -> PyResult<T>;
}

impl<T, E: Raise> OrRaise<T> for Result<T, E> {
    fn or_raise(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|error| error.raise(py))
    }
}

impl Raise for Diagnostics {
    fn raise(self, py: Python<'_>) -> PyErr {
        let error = ScenarioError::new_err(self.render(false));
        match attach_faults(py, &error, &self) {
            Ok(()) => error,
            Err(other) => other,
        }
    }
}

fn attach_faults(py: Python<'_>, error: &PyErr, faults: &Diagnostics) -> PyResult<()> {
    let list = PyList::empty(py);
    for fault in faults.list() {
        let one = PyDict::new(py);
        one.set_item("path", &fault.path)?;
        one.set_item("message", &fault.message)?;
        one.set_item("help", &fault.help)?;
        one.set_item("source", &fault.source)?;
        one.set_item("line", fault.line)?;
        one.set_item("column", fault.column)?;
        list.append(one)?;
    }
    error.value(py).setattr("faults", list)
}

impl Raise for EngineFault {
    fn raise(self, py: Python<'_>) -> PyErr {
        let error = Fault::new_err(self.to_string());
        match error.value(py).setattr("grain", self.grain()) {
            Ok(()) => error,
            Err(other) => other,
        }
    }
}

impl Raise for EngineRunError {
    fn raise(self, py: Python<'_>) -> PyErr {
        match self {
            Self::Scenario(faults) => faults.raise(py),
            Self::Output(error) => error.raise(py),
            Self::Checkpoint(error) => error.raise(py),
            other => RunError::new_err(other.to_string()),
        }
    }
}

impl Raise for CalibrateError {
    fn raise(self, py: Python<'_>) -> PyErr {
        match self {
            Self::File(faults) => faults.raise(py),
            Self::Fault(fault) => fault.raise(py),
            other => CollisionError::new_err(other.to_string()),
        }
    }
}

impl Raise for PackingError {
    fn raise(self, py: Python<'_>) -> PyErr {
        match self {
            Self::Run(error) => error.raise(py),
            Self::Compare(error) => error.raise(py),
            other => RunError::new_err(other.to_string()),
        }
    }
}

impl Raise for ChangeError {
    fn raise(self, py: Python<'_>) -> PyErr {
        match self {
            Self::Fault(fault) => fault.raise(py),
            Self::Length { .. } => wrong_value(format!(
                "{self}, in the order of `sim.ids`, which is another one when grains have come or gone"
            )),
            Self::NotFinite { .. } | Self::Gravity { .. } => wrong_value(self.to_string()),
            Self::Deforms => RunError::new_err(self.to_string()),
        }
    }
}

macro_rules! raise_as {
    ($($from:ty => $to:ident),*) => {
        $(impl Raise for $from {
            fn raise(self, _py: Python<'_>) -> PyErr {
                $to::new_err(self.to_string())
            }
        })*
    };
}

impl Raise for EngineOutputError {
    fn raise(self, _py: Python<'_>) -> PyErr {
        let how = match &self {
            Self::HoldsARun { .. } => " In Python: `overwrite=True`, or `demeter.resume(folder)`.",
            Self::HoldsOtherFiles { .. } => " In Python: `overwrite=True`.",
            Self::InUse { .. } => " A simulation of this process lets its folder go with `sim.close()`.",
            _ => "",
        };
        OutputError::new_err(format!("{self}{how}"))
    }
}

raise_as!(
    CheckpointError => OutputError,
    ResultsError => OutputError,
    CompareError => OutputError,
    CustomMotionError => RunError
);

impl<E: Raise> Raise for Box<E> {
    fn raise(self, py: Python<'_>) -> PyErr {
        (*self).raise(py)
    }
}

/// Puts the exceptions into the module.
pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let py = module.py();
    module.add("Error", py.get_type::<Error>())?;
    module.add("ScenarioError", py.get_type::<ScenarioError>())?;
    module.add("RunError", py.get_type::<RunError>())?;
    module.add("Fault", py.get_type::<Fault>())?;
    module.add("OutputError", py.get_type::<OutputError>())?;
    module.add("CollisionError", py.get_type::<CollisionError>())?;
    module.add("ArgumentError", py.get_type::<ArgumentError>())?;
    for argument in ARGUMENTS {
        module.add(argument.name(), argument.class(py)?)?;
    }
    Ok(())
}
