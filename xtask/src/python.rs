//! The output of a run, opened with PyVista in Python.

use crate::shell::{run, run_cargo};
use std::path::Path;

/// Where the virtual environment and the run go: beside what cargo builds.
const ENVIRONMENT: &str = "python-environment";
const RUN: &str = "python-run";

/// Runs a small scenario and tests what it wrote. Installs the pinned packages first; fails if it cannot.
pub fn test() -> Result<(), String> {
    let target = crate::shell::target_folder()?;
    let text = |path: &Path| path.display().to_string();
    let environment = target.join(ENVIRONMENT);
    let python = text(&environment.join("bin/python"));
    if !Path::new(&python).exists() {
        run("python3", &["-m", "venv", &text(&environment)], &[])?;
    }
    let requirements = "tests/python/requirements.txt";
    run(
        &python,
        &[
            "-m",
            "pip",
            "install",
            "--quiet",
            "--disable-pip-version-check",
            "-r",
            requirements,
        ],
        &[],
    )?;
    run_cargo(&["build", "-p", "demeter-cli"], &[])?;
    let folder = target.join(RUN);
    if folder.exists() {
        crate::shell::remove_run(&folder)?;
    }
    let folder = text(&folder);
    run(
        &text(&target.join("debug/demeter")),
        &["run", "tests/python/scenario.toml", "--out", &folder],
        &[],
    )?;
    run(
        &python,
        &["-m", "pytest", "-q", "tests/python"],
        &[("DEMETER_RUN", &folder)],
    )
}
