//! The class `Scenario`.

use crate::aside::aside;
use crate::convert::{PlainReader, dict, from_json, overrides, path, shown, text};
use crate::errors::{OrRaise, Raise, unknown_name, wrong_type, wrong_value};
use engine::scenario::{
    Diagnostics, FitTask, Foreign, ImpactFile, Scenario as EngineScenario, TEMPLATES, faults_with_foreign, prepare,
    template,
};
use pyo3::prelude::*;
use pyo3::types::{PyMapping, PyString};
use serde_json::json;
use std::path::{Path, PathBuf};

/// What was handed in: a text, where it is from, and where relative paths in it start.
pub struct Source {
    pub text: String,
    pub name: String,
    pub base: PathBuf,
    /// The file, where it is one.
    pub file: Option<PathBuf>,
    /// Values of a dict that are none of a scenario.
    foreign: Vec<Foreign>,
}

impl Source {
    /// A path, a text or a dict.
    pub fn of(value: &Bound<'_, PyAny>) -> PyResult<Self> {
        let here = || std::env::current_dir().unwrap_or_default();
        if value.cast::<PyMapping>().is_ok() {
            let value = dict(value, "scenario", "those of TOML")?;
            let base = here();
            let mut reader = PlainReader::default();
            let text = reader.read(value.as_any(), "")?.to_toml(&base);
            return Ok(Self {
                text,
                foreign: reader.foreign,
                ..Self::text(String::new(), "dict", base)
            });
        }
        if let Ok(text) = value.cast::<PyString>() {
            let text = text.to_string();
            if text.contains('\n') || text.contains('=') && !Path::new(&text).exists() {
                return Ok(Self::text(text, "text", here()));
            }
        } else if !value.hasattr("__fspath__")? {
            let message = format!("a scenario is a path, a TOML text or a dict, not {}", shown(value));
            return Err(wrong_type(message));
        }
        let file = path(value, "scenario")?;
        Ok(Self {
            text: String::new(),
            name: file.display().to_string(),
            base: file.parent().map_or_else(PathBuf::new, Path::to_path_buf),
            file: Some(file),
            foreign: Vec::new(),
        })
    }

    fn text(text: String, name: &str, base: PathBuf) -> Self {
        Self {
            text,
            name: name.to_string(),
            base,
            file: None,
            foreign: Vec::new(),
        }
    }

    /// What was read, unless values of the dict are wrong; then these are told with all else that is.
    fn whole<T>(&self, py: Python<'_>, read: Result<T, Diagnostics>) -> PyResult<T> {
        if self.foreign.is_empty() {
            return read.or_raise(py);
        }
        Err(faults_with_foreign(&self.text, &self.name, &self.foreign, read.err()).raise(py))
    }

    /// Reads a scenario. What is in its file is kept, and where relative paths start, so that it is the same scenario later and elsewhere.
    pub fn scenario(&mut self, py: Python<'_>, set: &[String]) -> PyResult<EngineScenario> {
        if let Some(file) = self.file.take() {
            self.text = EngineScenario::text_of(&file).or_raise(py)?;
        }
        if let Ok(here) = std::env::current_dir() {
            self.base = here.join(&self.base);
        }
        self.whole(py, EngineScenario::parse(&self.text, &self.name, &self.base, set))
    }

    /// Reads a file of two bodies.
    pub fn impact(&self, py: Python<'_>, set: &[String]) -> PyResult<ImpactFile> {
        let read = match &self.file {
            Some(file) => ImpactFile::read(file, set),
            None => ImpactFile::parse(&self.text, &self.name, set),
        };
        self.whole(py, read)
    }

    /// Reads a file of a fit.
    pub fn fit(&self, py: Python<'_>, set: &[String]) -> PyResult<FitTask> {
        let read = match &self.file {
            Some(file) => FitTask::read(file, set),
            None => FitTask::parse(&self.text, &self.name, &self.base, set),
        };
        self.whole(py, read)
    }
}

/// A scenario: everything that a run is made of, read and checked.
///
/// Values are texts with a unit, as `"2 mm"`, or, in dicts, plain numbers in SI. All keys:
/// the scenario reference of the book.
///
/// Examples
/// --------
/// >>> scenario = demeter.Scenario.template("drum")
/// >>> scenario = scenario.set({"grains[0].count": 200})
#[pyclass(module = "demeter", frozen)]
pub struct Scenario {
    source: Source,
    set: Vec<String>,
    pub read: EngineScenario,
}

impl Scenario {
    fn new(py: Python<'_>, mut source: Source, set: Vec<String>) -> PyResult<Self> {
        let read = source.scenario(py, &set)?;
        Ok(Self { source, set, read })
    }

    /// What a function takes for a scenario: one, a path, a text or a dict.
    pub fn engine_of(value: &Bound<'_, PyAny>) -> PyResult<EngineScenario> {
        match value.cast::<Self>() {
            Ok(scenario) => Ok(scenario.get().read.clone()),
            Err(_) => Source::of(value)?.scenario(value.py(), &[]),
        }
    }
}

#[pymethods]
impl Scenario {
    /// Reads a scenario from a TOML file or text.
    ///
    /// Parameters
    /// ----------
    /// source : path of a file, or a TOML text
    /// set : dict, optional
    ///     Changes of the scenario before it is checked, as ``{"grains[0].count": 200, "wall.lid.point": "0 0 5 cm"}``.
    ///
    /// Raises
    /// ------
    /// ScenarioError
    ///     With all faults at once.
    #[staticmethod]
    #[pyo3(signature = (source, *, set=None))]
    fn from_toml(source: &Bound<'_, PyAny>, set: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        if source.cast::<PyMapping>().is_ok() {
            return Err(wrong_type("this is a dict: use Scenario.from_dict"));
        }
        Self::new(source.py(), Source::of(source)?, overrides(set)?)
    }

    /// Builds a scenario from nested dicts and lists, with the keys of the TOML file.
    ///
    /// Quantities are texts with units or plain numbers in SI; arrays of NumPy serve as lists. Relative
    /// paths start from the present folder.
    ///
    /// Raises
    /// ------
    /// ScenarioError
    ///     With all faults at once, each with the path of its key, values of wrong types among them.
    #[staticmethod]
    #[pyo3(signature = (tables, *, set=None))]
    fn from_dict(tables: &Bound<'_, PyAny>, set: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        if tables.cast::<PyMapping>().is_err() {
            let found = shown(tables);
            let message = format!("`tables` must be a dict, not {found}; Scenario.from_toml reads files and texts");
            return Err(wrong_type(message));
        }
        Self::new(tables.py(), Source::of(tables)?, overrides(set)?)
    }

    /// One of the templates that ``demeter new`` writes: see `templates`.
    #[staticmethod]
    #[pyo3(signature = (name, *, set=None))]
    fn template(py: Python<'_>, name: &Bound<'_, PyAny>, set: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let name = text(name, "name")?;
        let Some(text) = template(&name) else {
            return Err(unknown_name(
                "template",
                &name,
                TEMPLATES.iter().map(|(name, ..)| *name),
            ));
        };
        let here = std::env::current_dir().unwrap_or_default();
        let source = Source::text(text.to_string(), &format!("{name}.toml"), here);
        Self::new(py, source, overrides(set)?)
    }

    /// Names of the templates.
    #[staticmethod]
    fn templates() -> Vec<&'static str> {
        TEMPLATES.iter().map(|(name, ..)| *name).collect()
    }

    /// The same scenario, as it was read, with changes, checked anew. Keys as ``"grains[0].count"`` or ``"wall.lid.velocity"``.
    fn set(&self, py: Python<'_>, changes: &Bound<'_, PyAny>) -> PyResult<Self> {
        let mut set = self.set.clone();
        set.extend(overrides(Some(changes))?);
        let source = Source {
            text: self.source.text.clone(),
            name: self.source.name.clone(),
            base: self.source.base.clone(),
            file: None,
            foreign: Vec::new(),
        };
        Self::new(py, source, set)
    }

    /// Makes the scenario ready to run, without running it: places the grains, finds the time step.
    ///
    /// Returns
    /// -------
    /// dict
    ///     ``time_step`` [s] and ``time_step_reason``, ``fastest_impact`` that is borne [m/s], ``grains``, ``materials``, ``walls``, ``stages``, ``steps``,
    ///     ``memory`` [bytes], ``run_time`` on one thread [s], ``warnings``.
    fn check<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let scenario = &self.read;
        let prepared = aside(py, || prepare(scenario))?.or_raise(py)?;
        let stages = scenario.stages.iter().zip(&prepared.stage_steps);
        let told = json!({
            "title": scenario.title,
            "time_step": prepared.setup.dt,
            "time_step_reason": prepared.time_step_reason,
            "fastest_impact": prepared.fastest_impact.as_ref().map(|borne| borne.speed),
            "grains": prepared.setup.grains.len(),
            "materials": scenario.materials.iter().map(|m| m.name.clone()).collect::<Vec<_>>(),
            "walls": scenario.walls.iter().map(|w| w.name.clone()).collect::<Vec<_>>(),
            "stages": stages.map(|(s, steps)| json!({ "name": s.name, "steps": steps })).collect::<Vec<_>>(),
            "steps": prepared.steps,
            "memory": prepared.memory,
            "run_time": prepared.run_time,
            "frames": prepared.frames,
            "frame_bytes": prepared.frame_bytes,
            "rows": prepared.rows,
            "row_bytes": prepared.row_bytes,
            "warnings": prepared.warnings,
        });
        from_json(py, &told)
    }

    /// The scenario as TOML, with all changes put in and the paths of files absolute.
    fn to_toml(&self) -> String {
        self.read.to_resolved_toml()
    }

    /// Its title.
    #[getter]
    fn title(&self) -> &str {
        &self.read.title
    }

    /// Names of its stages, repeats unrolled.
    #[getter]
    fn stages(&self) -> Vec<String> {
        self.read.stages.iter().map(|stage| stage.name.clone()).collect()
    }

    fn __repr__(&self) -> String {
        format!(
            "<demeter.Scenario {:?}, {} stages>",
            self.read.title,
            self.read.stages.len()
        )
    }

    fn __reduce__(slf: &Bound<'_, Self>) -> PyResult<(Py<PyAny>, (String,))> {
        let read = slf.getattr("from_toml")?.unbind();
        let text = slf.get().to_toml();
        if text.is_empty() {
            return Err(wrong_value("an empty scenario cannot be pickled"));
        }
        Ok((read, (text,)))
    }
}
