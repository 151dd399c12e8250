//! The tools for two bodies and for measurements.

use crate::aside::{aside, listening};
use crate::convert::{
    self, flag, from_json, optional_count, optional_quantity, overrides, path, quantity, shown, text,
};
use crate::errors::{CollisionError, OrRaise, unknown_name, wrong_type, wrong_value};
use crate::scenario::Source;
use demeter_physics::collision::Sticking;
use demeter_physics::contact::laws as all_laws;
use demeter_physics::dimension::Dimension;
use demeter_physics::restitution::hertz::HertzCollision;
use demeter_physics::restitution::inverse::{Collision, Observed, SpringDashpot};
use demeter_physics::restitution::linear::LinearCollision;
use demeter_physics::restitution::{ContactEnd, RestitutionError};
use engine::calibrate::fit::fit as fit_law;
use engine::calibrate::packing::fit_packing;
use engine::calibrate::{
    Engine, Moment, collide as collide_bodies, contact_curve as trace, log_spaced, sticking as search,
};
use engine::compare::{
    Position, Reading, Thresholds, compare as compare_strokes, comparisons_to_json, read_measured, read_run,
    tells_strain,
};
use engine::materials::law_to_json;
use engine::scenario::{FitTask, units};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyList, PyString, PyTuple};
use std::path::PathBuf;

/// The stage of unloading of a comparison, where there is one.
pub struct Unload(Option<String>);

impl Unload {
    fn usual() -> Self {
        Self(Some("release".to_string()))
    }
}

impl<'py> FromPyObject<'_, 'py> for Unload {
    type Error = PyErr;

    fn extract(told: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let name = (!told.is_none()).then(|| text(&told, "unload"));
        Ok(Self(name.transpose()?))
    }
}

/// A value that is above 0.
fn positive(value: f64, name: &str) -> PyResult<f64> {
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(wrong_value(format!(
            "`{name}` is {value}; it must be a finite number above 0"
        ))),
    }
}

fn finite_force(value: Option<&Bound<'_, PyAny>>, name: &str) -> PyResult<Option<f64>> {
    match optional_quantity(value, name, Dimension::FORCE)? {
        Some(force) if !force.is_finite() => Err(wrong_value(format!("`{name}` is {force} N; it must be finite"))),
        force => Ok(force),
    }
}

/// Most moments of a collision that are handed out.
const MOST_MOMENTS: usize = 10_000_000;
/// Most sizes of a curve.
const MOST_POINTS: usize = 10_000;
/// So many are searched for before Ctrl-C is heard.
const POINTS_AT_ONCE: usize = 64;

/// Collides two bodies and tells what became of them: restitution, contact time, largest overlap and force, energies.
///
/// Parameters
/// ----------
/// bodies : path, TOML text or dict
///     A file of two bodies, as ``demeter collide`` reads it, with tables ``material``, ``a``, ``b``, ``contact`` and ``impact``. In
///     a dict plain numbers are SI.
/// engine : bool
///     With the steps of a run, instead of to reference precision.
/// course : int
///     Number of moments of the collision to hand out, at most; 0 for none.
/// set : dict, optional
///     Changes, as ``{"impact.velocity": "2 m/s"}``: quantities as `bodies` tells them, so plain numbers in SI only where that is a dict.
///
/// Returns
/// -------
/// dict
///     As ``demeter collide --json``; with ``course``: a dict of arrays ``time``, ``overlap``, ``rate``, ``force``.
#[pyfunction]
#[pyo3(signature = (bodies, *, engine=None, course=None, set=None),
    text_signature = "(bodies, *, engine=False, course=0, set=None)")]
pub fn collide<'py>(
    py: Python<'py>,
    bodies: &Bound<'py, PyAny>,
    engine: Option<&Bound<'py, PyAny>>,
    course: Option<&Bound<'py, PyAny>>,
    set: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let engine = engine.map_or(Ok(false), |told| flag(told, "engine"))?;
    let course = optional_count(course, "course", 0)?.unwrap_or(0);
    if course > MOST_MOMENTS {
        return Err(wrong_value(format!(
            "`course` is {course}; at most {MOST_MOMENTS} moments are handed out"
        )));
    }
    let file = Source::of(bodies)?.impact(py, &overrides(set)?)?;
    let how = if engine { Engine::Automatic } else { Engine::Reference };
    let report = aside(py, || collide_bodies(&file, how, course))?.or_raise(py)?;
    let told = from_json(py, &report.to_json())?;
    if course > 0 {
        let columns = PyDict::new(py);
        let column = |get: fn(&Moment) -> f64| PyArray1::from_iter(py, report.moments.iter().map(get));
        columns.set_item("time", column(|m| m.time))?;
        columns.set_item("overlap", column(|m| m.overlap))?;
        columns.set_item("rate", column(|m| m.rate))?;
        columns.set_item("force", column(|m| m.force))?;
        told.set_item("course", columns)?;
    }
    Ok(told)
}

/// The quasi-static curve of the normal law between two bodies: approach, load, unload, reload, pull-off.
///
/// Returns
/// -------
/// dict
///     Columns ``branch`` (a list of texts), ``overlap`` [m], ``force`` [N] and ``stored`` [J].
#[pyfunction]
#[pyo3(signature = (bodies, *, set=None))]
pub fn contact_curve<'py>(
    py: Python<'py>,
    bodies: &Bound<'py, PyAny>,
    set: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let file = Source::of(bodies)?.impact(py, &overrides(set)?)?;
    let curve = aside(py, || trace(&file))?.or_raise(py)?.points;
    let dict = PyDict::new(py);
    dict.set_item(
        "branch",
        PyList::new(py, curve.iter().map(|p| p.branch.name()).collect::<Vec<_>>())?,
    )?;
    dict.set_item("overlap", PyArray1::from_iter(py, curve.iter().map(|p| p.overlap)))?;
    dict.set_item("force", PyArray1::from_iter(py, curve.iter().map(|p| p.force)))?;
    dict.set_item("stored", PyArray1::from_iter(py, curve.iter().map(|p| p.stored)))?;
    Ok(dict)
}

/// The speed below which two bodies stick, against their size.
///
/// Parameters
/// ----------
/// bodies : path, TOML text or dict
/// radius : quantity, or a pair of quantities
///     Effective radius, or the least and the largest: ``("0.1 um", "1 um")``. The bodies are scaled to it.
/// points : int
///     Number of radii, at equal ratios.
///
/// Returns
/// -------
/// dict
///     ``effective_radius`` [m] and ``velocity`` [m/s]: NaN where they part at low speeds, infinite where they always stick.
#[pyfunction]
#[pyo3(signature = (bodies, radius, *, points=None, set=None), text_signature = "(bodies, radius, *, points=20, set=None)")]
pub fn sticking<'py>(
    py: Python<'py>,
    bodies: &Bound<'py, PyAny>,
    radius: &Bound<'py, PyAny>,
    points: Option<&Bound<'py, PyAny>>,
    set: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let file = Source::of(bodies)?.impact(py, &overrides(set)?)?;
    let length = |value: &Bound<'_, PyAny>| quantity(value, "radius", Dimension::LENGTH);
    // a text is no sequence here, and neither is an array of no dimension
    let sequence: Option<Vec<Bound<'_, PyAny>>> = radius.extract().ok();
    let (first, last) = match sequence.as_deref() {
        Some([first, last]) => (length(first)?, length(last)?),
        Some(_) => {
            return Err(wrong_value(format!(
                "`radius` is {}; it must be one radius, or a pair of the least and the largest, as (\"0.1 um\", \"1 um\")",
                shown(radius)
            )));
        }
        None => (length(radius)?, length(radius)?),
    };
    if !(first > 0.0 && last >= first && last.is_finite()) {
        let message = format!("`radius` is from {first} m to {last} m; it must rise, and be above 0");
        return Err(wrong_value(message));
    }
    let (points, least) = (
        optional_count(points, "points", 1)?.unwrap_or(20),
        if first == last { 1 } else { 2 },
    );
    if points < least {
        return Err(wrong_value(format!(
            "`points` is {points}; a range of radii has {least} at least"
        )));
    }
    if points > MOST_POINTS {
        return Err(wrong_value(format!(
            "`points` is {points}; at most {MOST_POINTS} are computed"
        )));
    }
    let radii = log_spaced(first, last, if first == last { 1 } else { points });
    let mut found = Vec::new();
    for some in radii.chunks(POINTS_AT_ONCE) {
        found.extend(aside(py, || search(&file, some))?.or_raise(py)?);
    }
    let speed = |sticking: Sticking| match sticking {
        Sticking::Below(speed) => speed,
        Sticking::Never(_) | Sticking::From { .. } => f64::NAN,
        Sticking::Always(_) => f64::INFINITY,
    };
    let dict = PyDict::new(py);
    dict.set_item("effective_radius", radii.into_pyarray(py))?;
    dict.set_item(
        "velocity",
        PyArray1::from_iter(py, found.iter().map(|p| speed(p.sticking))),
    )?;
    Ok(dict)
}

/// Finds the parameters of a law from observed collisions, or a number of a scenario from a measured force curve.
///
/// Parameters
/// ----------
/// task : path, TOML text or dict
///     As ``demeter fit`` reads it. Where a number of a scenario is sought, the ends of ``unknown`` tell its unit: ``"30 kPa"``.
/// out : path, optional
///     Of a force curve: the folder for the runs; needed there.
/// threads : int, optional
///     Of a force curve: number of threads.
///
/// Returns
/// -------
/// dict
///     As ``demeter fit --json``: of collisions ``parameters`` (with ``value``, ``relative_error``, ``identified``), ``residuals``,
///     ``not_identified``, ``advice``, ``contact``; of a curve ``value``, ``bracket``, ``trials``.
#[pyfunction]
#[pyo3(signature = (task, *, out=None, threads=None, set=None))]
pub fn fit<'py>(
    py: Python<'py>,
    task: &Bound<'py, PyAny>,
    out: Option<&Bound<'py, PyAny>>,
    threads: Option<&Bound<'py, PyAny>>,
    set: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let out = out.map(|out| path(out, "out")).transpose()?;
    let threads = convert::threads(threads)?;
    match Source::of(task)?.fit(py, &overrides(set)?)? {
        FitTask::Collisions(file) => {
            if out.is_some() || threads.is_some() {
                let message = "`out` and `threads` belong to a task with a table `packing`, whose trials are runs";
                return Err(wrong_type(message));
            }
            let report = aside(py, || fit_law(&file))?.or_raise(py)?;
            from_json(py, &report.to_json())
        }
        FitTask::Packing(file) => {
            let Some(out) = out else {
                return Err(wrong_type("`out` is missing: the folder for the runs of this fit"));
            };
            let report = listening(py, |listener| fit_packing(&file, &out, threads, listener))?.or_raise(py)?;
            from_json(py, &report.to_json(&file))
        }
    }
}

/// Averages the cycles of runs and sets them beside another run or a measured curve.
///
/// Parameters
/// ----------
/// runs : path or list of paths
///     Folders of runs.
/// reference : path
///     Folder of a run, or a CSV file of a measured curve.
/// load, unload : str
///     Names of the stages that load and unload; ``unload=None`` compares loading alone.
/// discard : int
///     Cycles left out at the beginning.
/// force : str
///     Column of the force; a ``-`` before it turns its sign round.
/// threshold, reference_threshold : quantity, optional
///     Contacts below these forces are left out, of the runs and of the reference.
///
/// Returns
/// -------
/// dict
///     As ``demeter compare --json``, and for every run ``forces``: columns ``phase``, ``position``, ``run`` [N], ``reference`` [N].
#[pyfunction]
#[pyo3(signature = (runs, reference, *, load=None, unload=Unload::usual(), discard=None, force=None, threshold=None,
    reference_threshold=None),
    text_signature = "(runs, reference, *, load='squeeze', unload='release', discard=0, force='wall top force z', threshold=None, \
                      reference_threshold=None)")]
#[allow(clippy::too_many_arguments, reason = "they are keywords")]
pub fn compare<'py>(
    py: Python<'py>,
    runs: &Bound<'py, PyAny>,
    reference: &Bound<'py, PyAny>,
    load: Option<&Bound<'py, PyAny>>,
    unload: Unload,
    discard: Option<&Bound<'py, PyAny>>,
    force: Option<&Bound<'py, PyAny>>,
    threshold: Option<&Bound<'py, PyAny>>,
    reference_threshold: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let runs: Vec<PathBuf> = if runs.is_instance_of::<PyList>() || runs.is_instance_of::<PyTuple>() {
        let all = runs.try_iter()?.map(|run| path(&run?, "runs"));
        all.collect::<PyResult<_>>()?
    } else {
        vec![path(runs, "runs")?]
    };
    if runs.is_empty() {
        return Err(wrong_value("`runs` is empty; name at least one folder of a run"));
    }
    let or = |told: Option<&Bound<'py, PyAny>>, name: &str, default: &str| {
        told.map_or_else(|| Ok(default.to_string()), |told| text(told, name))
    };
    let reading = Reading {
        load: or(load, "load", "squeeze")?,
        unload: unload.0,
        discard: optional_count(discard, "discard", 0)?.unwrap_or(0),
        force: or(force, "force", "wall top force z")?,
        ..Reading::default()
    };
    let thresholds = Thresholds {
        run: finite_force(threshold, "threshold")?,
        reference: finite_force(reference_threshold, "reference_threshold")?.unwrap_or(0.0),
    };
    let place = path(reference, "reference")?;
    let reference = if place.is_dir() {
        let mut strain = true;
        for run in runs.iter().chain([&place]) {
            strain &= tells_strain(run).or_raise(py)?;
        }
        let position = if strain { Position::Strain } else { Position::StageTime };
        read_run(&place, &reading, Some(position)).or_raise(py)?
    } else {
        read_measured(&place).or_raise(py)?
    };
    let mut compared = Vec::new();
    for run in &runs {
        let strokes = read_run(run, &reading, Some(reference.position)).or_raise(py)?;
        let comparison = compare_strokes(&strokes, &reference, thresholds);
        compared.push((strokes, comparison));
    }
    let pairs: Vec<_> = compared
        .iter()
        .map(|(strokes, comparison)| (strokes, comparison))
        .collect();
    let told = from_json(py, &comparisons_to_json(&pairs, &reference))?;
    for (one, (_, comparison)) in told.get_item("runs")?.try_iter()?.zip(&compared) {
        let forces = PyDict::new(py);
        let phases: Vec<&str> = comparison.pairs.iter().map(|pair| pair.phase.name()).collect();
        forces.set_item("phase", PyList::new(py, phases)?)?;
        forces.set_item(
            "position",
            PyArray1::from_iter(py, comparison.pairs.iter().map(|p| p.position)),
        )?;
        forces.set_item(
            "run",
            PyArray1::from_iter(py, comparison.pairs.iter().map(|p| p.run.value)),
        )?;
        forces.set_item(
            "reference",
            PyArray1::from_iter(py, comparison.pairs.iter().map(|p| p.reference.value)),
        )?;
        one?.set_item("forces", forces)?;
    }
    Ok(told)
}

/// All contact laws, or those of a name: a list of dicts with ``name``, ``family``, ``summary``, ``doc``, ``parameters`` and an
/// ``example`` line for a scenario.
#[pyfunction]
#[pyo3(signature = (name=None))]
pub fn laws<'py>(py: Python<'py>, name: Option<&Bound<'py, PyAny>>) -> PyResult<Bound<'py, PyList>> {
    let name = name.map(|name| text(name, "name")).transpose()?;
    let list = PyList::empty(py);
    for law in all_laws().filter(|law| name.as_ref().is_none_or(|name| law.name == name)) {
        list.append(from_json(py, &law_to_json(law))?)?;
    }
    match name {
        Some(name) if list.is_empty() => Err(unknown_name("law", &name, all_laws().map(|law| law.name))),
        _ => Ok(list),
    }
}

/// Closed forms of the damped springs: from what a head-on collision shows to stiffness and damping, and back.
///
/// Give the restitution and one of `stiffness`, `contact_time`, `max_overlap` and `max_force`; or `contact_time` and
/// `max_overlap`, which tell the restitution.
///
/// Parameters
/// ----------
/// law : {"linear", "hertz"}
///     ``F = k x + 2 gamma m v``, or ``F = K x^(3/2) + alpha sqrt(m K) x^(1/4) v``.
/// mass : quantity
///     Effective mass ``m1 m2/(m1 + m2)``; against a wall that of the grain [kg].
/// velocity : quantity
///     Impact speed [m/s].
/// restitution : float, optional
///     Speed after over speed before, in (0, 1].
/// stiffness : quantity, optional
///     k, as ``"5 kN/m"``, or K, as ``"1 GN/m^1.5"``.
/// contact_time, max_overlap, max_force : quantity, optional
/// contact_end : {"zero-overlap", "zero-force"}
///     When the bodies part.
///
/// Returns
/// -------
/// dict
///     ``restitution``, ``stiffness``, ``damping`` (gamma over sqrt(k/m), or alpha; no unit), ``contact_time`` [s],
///     ``max_overlap`` [m], ``max_force`` [N].
///
/// Source: Antypov & Elliott, EPL 94, 50004 (2011).
#[pyfunction]
#[pyo3(signature = (law, *, mass, velocity, restitution=None, stiffness=None, contact_time=None, max_overlap=None,
    max_force=None, contact_end=None),
    text_signature = "(law, *, mass, velocity, restitution=None, stiffness=None, contact_time=None, max_overlap=None, \
                      max_force=None, contact_end='zero-overlap')")]
#[allow(clippy::too_many_arguments, reason = "they are keywords")]
pub fn damped_spring<'py>(
    py: Python<'py>,
    law: &Bound<'py, PyAny>,
    mass: &Bound<'py, PyAny>,
    velocity: &Bound<'py, PyAny>,
    restitution: Option<&Bound<'py, PyAny>>,
    stiffness: Option<&Bound<'py, PyAny>>,
    contact_time: Option<&Bound<'py, PyAny>>,
    max_overlap: Option<&Bound<'py, PyAny>>,
    max_force: Option<&Bound<'py, PyAny>>,
    contact_end: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let wrong = |error: RestitutionError| match error {
        RestitutionError::Restitution { .. } => wrong_value(error.to_string()),
        other => CollisionError::new_err(other.to_string()),
    };
    let optional = |value: Option<&Bound<'_, PyAny>>, name: &str, dimension: Dimension| {
        let told = optional_quantity(value, name, dimension)?;
        told.map(|told| positive(told, name)).transpose()
    };
    let (law, unit) = match text(law, "law")?.as_str() {
        "linear" => (SpringDashpot::Linear, Dimension::STIFFNESS),
        "hertz" => (SpringDashpot::Hertz, Dimension::HERTZ_STIFFNESS),
        other => {
            let message = format!("`law` is \"{other}\"; it must be \"linear\" or \"hertz\"");
            return Err(wrong_value(message));
        }
    };
    let end = contact_end.map(|end| text(end, "contact_end")).transpose()?;
    let end = match end.as_deref() {
        None | Some("zero-overlap") => ContactEnd::ZeroOverlap,
        Some("zero-force") => ContactEnd::ZeroForce,
        Some(other) => {
            let message = format!("`contact_end` is \"{other}\"; it must be \"zero-overlap\" or \"zero-force\"");
            return Err(wrong_value(message));
        }
    };
    let restitution = optional_quantity(restitution, "restitution", Dimension::NONE)?;
    let mass = positive(quantity(mass, "mass", Dimension::MASS)?, "mass")?;
    let speed = positive(quantity(velocity, "velocity", Dimension::VELOCITY)?, "velocity")?;
    let time = optional(contact_time, "contact_time", Dimension::TIME)?;
    let overlap = optional(max_overlap, "max_overlap", Dimension::LENGTH)?;
    let force = optional(max_force, "max_force", Dimension::FORCE)?;
    let stiffness = optional(stiffness, "stiffness", unit)?;
    let given = [stiffness, time, overlap, force].iter().flatten().count();
    let restitution = match (restitution, time, overlap) {
        (Some(restitution), ..) if given == 1 => restitution,
        (None, Some(contact_time), Some(max_overlap)) if given == 2 => {
            let observed = Observed {
                law,
                end,
                speed,
                contact_time,
                max_overlap,
            };
            observed.restitution().map_err(wrong)?
        }
        _ => {
            let message = "give `restitution` and one of `stiffness`, `contact_time`, `max_overlap` and `max_force`; or \
                           `contact_time` and `max_overlap`";
            return Err(wrong_type(message));
        }
    };
    let collision = Collision {
        law,
        end,
        mass,
        speed,
        restitution,
    };
    let stiffness = match (stiffness, time, overlap, force) {
        (Some(stiffness), ..) => Ok(stiffness),
        (_, Some(time), ..) => collision.stiffness_of_contact_time(time),
        (_, _, Some(overlap), _) => collision.stiffness_of_max_overlap(overlap),
        (_, _, _, force) => collision.stiffness_of_max_force(force.unwrap_or(f64::NAN)),
    }
    .map_err(wrong)?;
    let extent = collision.extent(stiffness).map_err(wrong)?;
    let damping = match law {
        SpringDashpot::Linear => LinearCollision::from_restitution(restitution, end).map(|c| c.ratio()),
        SpringDashpot::Hertz => HertzCollision::from_restitution(restitution, end).map(|c| c.alpha()),
    }
    .map_err(wrong)?;
    let dict = PyDict::new(py);
    for (name, value) in [
        ("restitution", restitution),
        ("stiffness", stiffness),
        ("damping", damping),
        ("contact_time", extent.contact_time),
        ("max_overlap", extent.max_overlap),
        ("max_force", extent.max_force),
    ] {
        dict.set_item(name, value)?;
    }
    Ok(dict)
}

/// The value of a quantity in SI: ``demeter.si("23.3 kPa")`` is 23300.0. Numbers stay as they are.
#[pyfunction]
pub fn si(value: &Bound<'_, PyAny>) -> PyResult<f64> {
    match value.cast::<PyString>() {
        Ok(text) => {
            let read = units::parse(&text.to_string());
            read.map(|quantity| quantity.value)
                .map_err(|e| wrong_value(e.to_string()))
        }
        Err(_) => match value.extract::<f64>() {
            Ok(number) if !value.is_instance_of::<PyBool>() => Ok(number),
            _ => Err(wrong_type(format!(
                "a quantity is a text with a unit or a number, not {}",
                shown(value)
            ))),
        },
    }
}
