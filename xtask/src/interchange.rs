//! Files for LAMMPS, LIGGGHTS, YADE, OVITO and ASE, read by those programs, and what they wrote.

use crate::checks::build_demeter;
use crate::shell::{answers, run};
use std::path::Path;

/// Where the virtual environment and the run go: beside what cargo builds.
const ENVIRONMENT: &str = "interchange-environment";
const RUN: &str = "interchange-run";
/// Programs and the packages of Debian that hold them.
const PROGRAMS: [(&str, &str); 3] = [("lmp", "lammps"), ("liggghts", "liggghts"), ("yade", "yade")];

/// Runs a small scenario, converts it, and lets what is installed read it. Installs the Python packages first.
pub fn test() -> Result<(), String> {
    for (program, package) in PROGRAMS {
        // asked for its help, LIGGGHTS would leave a log here
        if !answers("which", &[program]) {
            println!("==> {program} is not there (apt-get install {package}); its tests are skipped");
        }
    }
    let target = crate::shell::target_folder()?;
    let text = |path: &Path| path.display().to_string();
    let environment = target.join(ENVIRONMENT);
    let python = text(&environment.join("bin/python"));
    if !Path::new(&python).exists() {
        run("python3", &["-m", "venv", &text(&environment)], &[])?;
    }
    let pip = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"];
    run(
        &python,
        &[&pip[..], &["tests/interchange/requirements.txt"]].concat(),
        &[],
    )?;
    build_demeter()?;
    let folder = target.join(RUN);
    if folder.exists() {
        crate::shell::remove_run(&folder)?;
    }
    let (folder, demeter) = (text(&folder), text(&target.join("debug/demeter")));
    run(&demeter, &["run", "tests/python/scenario.toml", "--out", &folder], &[])?;
    let environment = [("DEMETER", demeter.as_str()), ("DEMETER_RUN", folder.as_str())];
    run(
        &python,
        &["-m", "pytest", "-q", "-rs", "tests/interchange"],
        &environment,
    )
}
