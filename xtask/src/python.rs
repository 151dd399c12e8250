//! The Python module, built and tested as a user has it; and the output of a run, opened with PyVista.

use crate::checks::build_demeter;
use crate::shell::run;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Where the virtual environment, the run and the wheel go: beside what cargo builds.
const ENVIRONMENT: &str = "python-environment";
const RUN: &str = "python-run";
const WHEELS: &str = "python-wheels";

/// Runs a small scenario and tests what it wrote; then builds the wheel, installs it, and runs its tests, the check of its
/// stubs and the notebooks. Installs the pinned packages first; fails if it cannot.
pub fn test() -> Result<(), String> {
    let target = crate::shell::target_folder()?;
    let python = with_packages()?;
    test_output(&python, &target)?;
    test_module(&python, &target)
}

fn text(path: &Path) -> String {
    path.display().to_string()
}

/// The interpreter of the virtual environment, with the pinned packages. Whoever comes while they are installed waits for that.
pub fn with_packages() -> Result<String, String> {
    static INSTALLING: Mutex<()> = Mutex::new(());
    let _one = INSTALLING.lock();
    let python = environment(&crate::shell::target_folder()?)?;
    install(&python, &["-r", "tests/python/requirements.txt"])?;
    Ok(python)
}

/// The interpreter of the virtual environment.
fn environment(target: &Path) -> Result<String, String> {
    let environment = target.join(ENVIRONMENT);
    let python = environment.join("bin/python");
    if !python.exists() {
        run("python3", &["-m", "venv", &text(&environment)], &[])?;
    }
    Ok(text(&python))
}

fn install(python: &str, what: &[&str]) -> Result<(), String> {
    let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
    run(python, &[&pip, what].concat(), &[])
}

fn test_output(python: &str, target: &Path) -> Result<(), String> {
    build_demeter()?;
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
        python,
        &["-m", "pytest", "-q", "tests/python"],
        &[("DEMETER_RUN", &folder)],
    )
}

/// The wheel as `pip install .` makes it, but compiled faster.
fn test_module(python: &str, target: &Path) -> Result<(), String> {
    let wheels = target.join(WHEELS);
    if wheels.exists() {
        fs::remove_dir_all(&wheels).map_err(|e| format!("cannot empty {}: {e}", wheels.display()))?;
    }
    let pip = [
        "-m",
        "pip",
        "--quiet",
        "--disable-pip-version-check",
        "wheel",
        ".",
        "--no-deps",
    ];
    let settings = [
        "--config-settings",
        "build-args=--profile dev",
        "--wheel-dir",
        &text(&wheels),
    ];
    let target_text = text(target);
    run(
        python,
        &[&pip[..], &settings].concat(),
        &[("CARGO_TARGET_DIR", &target_text)],
    )?;
    let wheel = only_file(&wheels)?;
    install(python, &["--force-reinstall", "--no-deps", &text(&wheel)])?;
    let quietly = [("PYTHONDONTWRITEBYTECODE", "1"), ("MPLBACKEND", "agg")];
    run(python, &["-m", "pytest", "-q", "crates/python/tests"], &quietly)?;
    run(
        python,
        &["-m", "mypy.stubtest", "demeter", "--ignore-disjoint-bases"],
        &[],
    )?;
    run(
        python,
        &["-m", "pytest", "-q", "--nbmake", "examples/notebooks"],
        &quietly,
    )
}

fn only_file(folder: &Path) -> Result<PathBuf, String> {
    let read = fs::read_dir(folder).map_err(|e| format!("cannot list {}: {e}", folder.display()))?;
    let files: Vec<PathBuf> = read.filter_map(|entry| Some(entry.ok()?.path())).collect();
    match files.as_slice() {
        [file] => Ok(file.clone()),
        files => Err(format!("one wheel was expected, {} files are there", files.len())),
    }
}
