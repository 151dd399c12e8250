//! Experiments of the literature, simulated anew and compared.

use crate::shell::run_cargo;

/// Builds what validates in release mode and runs it with these arguments.
pub fn run(arguments: &[String]) -> Result<(), String> {
    let mut all = vec!["run", "--release", "--quiet", "-p", "demeter-validation", "--"];
    all.extend(arguments.iter().map(String::as_str));
    run_cargo(&all, &[])
}
