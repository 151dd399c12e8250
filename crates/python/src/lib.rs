//! The Python module `demeter`: scenarios, runs that one holds in one's hands, and the tools.
//!
//! This crate translates and adds no physics. It is outside `default-members`, so that building Demeter needs no Python.

mod aside;
mod contacts;
mod control;
mod convert;
mod errors;
mod force_state;
mod functions;
mod results;
mod scenario;
mod simulation;
mod tools;
mod views;

use numpy::PyArray1;
use pyo3::prelude::*;

/// Demeter: discrete element method for powders and soft grains.
///
/// >>> import demeter
/// >>> sim = demeter.run("drum.toml", out="runs/drum")     # as `demeter run`
/// >>> sim = demeter.Simulation(scenario); sim.step(1000)  # in your hands
/// >>> demeter.collide("two_bodies.toml")["restitution"]   # two bodies
///
/// Quantities are texts with units ("2 mm"), or in dicts plain numbers in SI; everything that comes out is SI.
#[pymodule]
fn demeter(module: &Bound<'_, PyModule>) -> PyResult<()> {
    // NumPy is taken up by the first array, and what fails then, as by a Ctrl-C, is a panic
    module.py().import("numpy")?;
    PyArray1::<f64>::zeros(module.py(), 0, false);
    module.add("__version__", engine::VERSION)?;
    module.add_class::<scenario::Scenario>()?;
    module.add_class::<simulation::Simulation>()?;
    module.add_class::<force_state::ForceState>()?;
    errors::register(module)?;
    module.add_function(wrap_pyfunction!(simulation::run, module)?)?;
    module.add_function(wrap_pyfunction!(simulation::resume, module)?)?;
    module.add_function(wrap_pyfunction!(results::read_series, module)?)?;
    module.add_function(wrap_pyfunction!(results::read_frame, module)?)?;
    module.add_function(wrap_pyfunction!(results::frames, module)?)?;
    module.add_function(wrap_pyfunction!(tools::collide, module)?)?;
    module.add_function(wrap_pyfunction!(tools::contact_curve, module)?)?;
    module.add_function(wrap_pyfunction!(tools::sticking, module)?)?;
    module.add_function(wrap_pyfunction!(tools::fit, module)?)?;
    module.add_function(wrap_pyfunction!(tools::compare, module)?)?;
    module.add_function(wrap_pyfunction!(tools::laws, module)?)?;
    module.add_function(wrap_pyfunction!(tools::damped_spring, module)?)?;
    module.add_function(wrap_pyfunction!(tools::si, module)?)
}
