//! Instructions of one step, counted by callgrind: a measure of work that does not depend on who else uses the machine.

use crate::shell::{answers, read, root, run_cargo, target_folder, write};
use std::path::Path;
use std::process::Command;
use toml::Table;

/// What was counted when it was last accepted.
const REFERENCE: &str = "benches/instructions.toml";

/// Steps of the two runs whose difference is counted, so that what comes before the first step cancels.
const STEPS: [u64; 2] = [20, 320];

/// The widest that callgrind knows, and what every processor has.
const COUNTED: [&str; 2] = ["portable", "avx2"];

/// Largest difference from the reference.
const TOLERANCE: f64 = 0.05;

/// Counts, compares with what was accepted, or accepts it.
pub fn run(accept: bool) -> Result<(), String> {
    if !answers("valgrind", &["--version"]) {
        if accept {
            return Err("valgrind is needed to count instructions, and is not installed".to_string());
        }
        println!("==> instructions of one step: NOT COUNTED, valgrind is not installed");
        return Ok(());
    }
    if !cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        println!("==> instructions of one step: NOT COUNTED, the reference is of Linux on x86-64");
        return Ok(());
    }
    build()?;
    let binary = target_folder()?.join("debug/one_step");
    let mut counts = Vec::new();
    for instructions in COUNTED {
        if let Some(count) = per_particle_step(&binary, instructions)? {
            println!("==> {instructions}: {count:.1} instructions per particle-step");
            counts.push((instructions, count));
        }
    }
    let compiler = compiler()?;
    let path = root().join(REFERENCE);
    if accept {
        return write(&path, &reference(&compiler, &counts));
    }
    let accepted = read(&path).map_err(|error| format!("{error}; `cargo xtask instructions --accept` writes it"))?;
    compare(&accepted, &compiler, &counts).map(|text| println!("{text}"))
}

/// Compiles what is counted, and with it the Python module: the wheel that is tested later finds it compiled, and the tests the engine.
pub fn build() -> Result<(), String> {
    run_cargo(&[&["build"], &BUILT_BEFORE[..], &["--bin", "one_step"]].concat(), &[])
}

/// Packages that are compiled before the tests are.
const BUILT_BEFORE: [&str; 4] = ["-p", "demeter-benches", "-p", "demeter-py"];

/// The compiler, as its one line tells it.
fn compiler() -> Result<String, String> {
    let output = Command::new("rustc").arg("--version").current_dir(root()).output();
    let output = output.map_err(|error| format!("cannot start rustc: {error}"))?;
    Ok(String::from_utf8_lossy(&output.stdout).trim().to_string())
}

/// Instructions per grain and step; nothing where the processor or valgrind lacks them.
fn per_particle_step(binary: &Path, instructions: &str) -> Result<Option<f64>, String> {
    let probe = Command::new(binary)
        .args(["--steps", "0", "--instructions", instructions])
        .output()
        .map_err(|error| format!("cannot start {}: {error}", binary.display()))?;
    let told = String::from_utf8_lossy(&probe.stderr);
    if told.contains("this processor has no instructions") {
        println!("==> {instructions}: NOT COUNTED, this processor lacks them");
        return Ok(None);
    }
    let grains = number_after(&String::from_utf8_lossy(&probe.stdout), "grains")
        .ok_or_else(|| format!("one_step does not tell its number of grains: {told}"))?;
    let [few, many] = STEPS;
    let (Some(all), Some(before)) = (count(binary, instructions, many)?, count(binary, instructions, few)?) else {
        println!("==> {instructions}: NOT COUNTED, valgrind does not know an instruction that the compiler chose");
        return Ok(None);
    };
    Ok(Some((all - before) / (grains * (many - few) as f64)))
}

/// Instructions of a whole run; nothing where valgrind does not know one of them: it lacks, among others, the encoding 66 0F D6 of a move
/// between registers, which the compiler chooses by the register.
fn count(binary: &Path, instructions: &str, steps: u64) -> Result<Option<f64>, String> {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(binary)
        .args(["--steps", &steps.to_string(), "--instructions", instructions])
        .output()
        .map_err(|error| format!("cannot start valgrind: {error}"))?;
    let told = String::from_utf8_lossy(&output.stderr);
    if told.contains("Unrecognised instruction") {
        return Ok(None);
    }
    let counted = number_after(&told, "Collected :").filter(|_| output.status.success());
    counted
        .map(Some)
        .ok_or_else(|| format!("callgrind counted nothing: {told}"))
}

/// The number that follows a word.
fn number_after(text: &str, word: &str) -> Option<f64> {
    let (_, rest) = text.split_once(word)?;
    rest.split_whitespace().next()?.parse().ok()
}

/// The text of the reference.
fn reference(compiler: &str, counts: &[(&str, f64)]) -> String {
    let values: String = counts
        .iter()
        .map(|(name, count)| format!("{name} = {count:.1}\n"))
        .collect();
    format!(
        "# Instructions per particle-step of the bed in src/bin/one_step.rs, counted by callgrind.\n\
         # Written by `cargo xtask instructions --accept`, compared by `cargo xtask instructions`.\n\
         compiler = \"{compiler}\"\n\n[instructions]\n{values}"
    )
}

/// What to tell where all is as it was accepted, or cannot be compared; else what is wrong.
fn compare(reference: &str, compiler: &str, counts: &[(&str, f64)]) -> Result<String, String> {
    let table: Table = reference.parse().map_err(|error| format!("{REFERENCE}: {error}"))?;
    let accepted_with = table
        .get("compiler")
        .and_then(|value| value.as_str())
        .unwrap_or("nothing");
    if accepted_with != compiler {
        return Ok(format!(
            "==> instructions of one step: NOT COMPARED, {REFERENCE} was counted with {accepted_with}, this is {compiler}; \
             `cargo xtask instructions --accept` takes the new values"
        ));
    }
    let mut faults = Vec::new();
    for (name, count) in counts {
        let accepted = table.get("instructions").and_then(|counts| counts.get(name));
        let Some(accepted) = accepted.and_then(|value| value.as_float()) else {
            faults.push(format!("{REFERENCE} has no number for `{name}`"));
            continue;
        };
        let change = count / accepted - 1.0;
        if change.abs() > TOLERANCE {
            faults.push(format!(
                "`{name}` takes {count:.1} instructions per particle-step, {:+.1} % from the {accepted:.1} accepted",
                100.0 * change
            ));
        }
    }
    if faults.is_empty() {
        return Ok(format!(
            "==> instructions of one step: within {} % of {REFERENCE}",
            100.0 * TOLERANCE
        ));
    }
    Err(format!(
        "{}\nif that is meant to be, and better work or the reason is told in the commit: `cargo xtask instructions --accept`, \
         and commit {REFERENCE}",
        faults.join("\n")
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_read_from_what_programs_say() {
        let told = "==12== Events    : Ir\n==12== Collected : 123456\n==12== \n";
        assert_eq!(number_after(told, "Collected :"), Some(123_456.0));
        assert_eq!(number_after("grains 2000 candidates 9", "grains"), Some(2000.0));
        assert_eq!(number_after("nothing", "grains"), None);
    }

    /// What cargo tells of the packages that some need, one in a line.
    fn packages(of: &[&str], kinds: &str, shown: &str) -> Vec<String> {
        let output = Command::new(crate::shell::cargo())
            .args([
                "tree", "--locked", "--prefix", "none", "--edges", kinds, "--format", shown,
            ])
            .args(of)
            .current_dir(root())
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let told = String::from_utf8_lossy(&output.stdout);
        let mut all: Vec<_> = told
            .lines()
            .map(|line| line.trim_end_matches(" (*)").to_string())
            .collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Packages that the engine is compiled with, each with its features, where some are chosen.
    fn compiled_with(chosen: &[&str]) -> Vec<String> {
        let of_engine = packages(&["-p", "demeter"], "normal,no-proc-macro", "{p} ");
        let mut all = packages(chosen, "normal,dev,no-proc-macro", "{p} {f}");
        all.retain(|line| of_engine.iter().any(|package| line.starts_with(package)));
        all
    }

    #[test]
    fn what_is_counted_and_tested_is_compiled_once() {
        let counted = compiled_with(&BUILT_BEFORE);
        assert!(
            counted.iter().any(|line| line.starts_with("serde_json v1")),
            "{counted:?}"
        );
        for tested in [&["--workspace"][..], &["--workspace", "--features", "demeter-cli/mpi"]] {
            let tested = compiled_with(tested);
            let other =
                |a: &[String], b: &[String]| a.iter().filter(|line| !b.contains(line)).cloned().collect::<Vec<_>>();
            let differ = [other(&counted, &tested), other(&tested, &counted)];
            assert!(
                differ.iter().all(Vec::is_empty),
                "with other features the engine is compiled twice: let crates/python/Cargo.toml name those of the second: {differ:#?}"
            );
        }
    }

    #[test]
    fn a_change_of_work_is_seen() {
        let accepted = reference("rustc 1", &[("portable", 1000.0), ("avx2", 400.0)]);
        let compare = |compiler, counts: &[(&str, f64)]| compare(&accepted, compiler, counts);
        assert!(
            compare("rustc 1", &[("portable", 1040.0), ("avx2", 385.0)])
                .unwrap()
                .contains("within 5 %")
        );
        for counts in [
            [("portable", 1060.0), ("avx2", 400.0)],
            [("portable", 1000.0), ("avx2", 370.0)],
        ] {
            let fault = compare("rustc 1", &counts).unwrap_err();
            assert!(fault.contains("--accept") && fault.lines().count() == 2, "{fault}");
        }
        // only what was counted is compared, and only with the same compiler
        assert!(compare("rustc 1", &[("avx2", 400.0)]).is_ok());
        assert!(compare("rustc 2", &[("avx2", 900.0)]).unwrap().contains("NOT COMPARED"));
        assert!(
            compare("rustc 1", &[("neon", 1.0)])
                .unwrap_err()
                .contains("no number for `neon`")
        );
    }
}
