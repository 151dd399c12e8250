//! The exceptions, with the messages of the command line.

use engine::calibrate::CalibrateError;
use engine::calibrate::packing::PackingError;
use engine::checkpoint::CheckpointError;
use engine::compare::CompareError;
use engine::contacts::Fault as EngineFault;
use engine::output::OutputError as EngineOutputError;
use engine::results::ResultsError;
use engine::scenario::{Diagnostics, RunError as EngineRunError};
use engine::simulation::{ChangeError, CustomMotionError};
use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

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
            Self::Length { .. } | Self::NotFinite { .. } => PyValueError::new_err(self.to_string()),
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

raise_as!(
    EngineOutputError => OutputError,
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
    module.add("CollisionError", py.get_type::<CollisionError>())
}
