//! The benchmark: a packing that settles, and how fast.

use crate::shell::{self, read, remove_run, root, run_cargo, target_folder};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Runs the scenario with the release binary and prints particle-steps per second.
pub fn run(scenario: &Path, threads: usize, out: Option<PathBuf>) -> Result<(), String> {
    let target = target_folder()?;
    let out = out.unwrap_or_else(|| target.join("bench-run"));
    run_cargo(&["build", "--release", "-p", "demeter-cli"], &[])?;
    // a run does not write over another one
    if out.exists() {
        remove_run(&out)?;
    }
    let binary = target.join("release/demeter");
    let texts = [&binary, scenario, &out].map(|path: &Path| path.display().to_string());
    let [binary, scenario, out_text] = texts;
    let threads_text = threads.to_string();
    let arguments = ["run", &scenario, "--out", &out_text, "--threads", &threads_text];
    shell::run(&binary, &arguments, &[])?;
    let summary = root().join(&out).join("summary.json");
    println!("{}", report(&read(&summary)?, threads)?);
    Ok(())
}

/// One line on the speed of a run, from its summary.
fn report(summary: &str, threads: usize) -> Result<String, String> {
    let summary: Value = serde_json::from_str(summary).map_err(|error| format!("summary.json: {error}"))?;
    let number = |key: &str| {
        summary[key]
            .as_f64()
            .ok_or_else(|| format!("summary.json has no number `{key}`"))
    };
    let speed = number("particle_steps_per_second")?;
    Ok(format!(
        "{} grains, {} steps in {:.2} s: {speed:.4e} particle-steps per second, {:.4e} per thread on {threads}",
        number("grains")?,
        number("steps")?,
        number("wall_clock_time")?,
        speed / threads.max(1) as f64,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_tells_the_speed() {
        let summary = r#"{"grains": 20000, "steps": 1000, "wall_clock_time": 4.0, "particle_steps_per_second": 5e6}"#;
        assert_eq!(
            report(summary, 2).unwrap(),
            "20000 grains, 1000 steps in 4.00 s: 5.0000e6 particle-steps per second, 2.5000e6 per thread on 2"
        );
        assert_eq!(
            report("{}", 1).unwrap_err(),
            "summary.json has no number `particle_steps_per_second`"
        );
    }
}
