//! The checks of a merge, one by one and all together.

use crate::shell::{answers, cargo, root, run, run_cargo, rust_files};
use crate::{book, browser, house_rules, instructions, layers, python, web};
use std::process::Command;
use std::sync::OnceLock;
use std::time::Instant;

/// Features that are checked, too, where the machine has what they need, as `.ci/run` sees to and tells by this variable.
fn features() -> &'static [&'static str] {
    match std::env::var("DEMETER_MPI").as_deref() {
        Ok("1") => &["--features", "demeter-cli/mpi"],
        _ => &[],
    }
}

/// Set once the tests of the program have run, which build it.
static TESTED: OnceLock<()> = OnceLock::new();

/// Builds the program that checks call, unless its tests have just done so.
pub fn build_demeter() -> Result<(), String> {
    if TESTED.get().is_some() {
        return Ok(());
    }
    run_cargo(&[&["build", "-p", "demeter-cli"], features()].concat(), &[])
}

/// A check of a merge, and what it is called where its time is told.
type Check = (&'static str, fn() -> Result<(), String>);

/// What must hold before a merge: one block after the other, whose rows are made beside each other. Only the first row of a block compiles
/// anything, so that one never waits for another.
const CHECKS: [&[&[Check]]; 3] = [
    &[
        &[("clippy", clippy), ("documentation", documentation)],
        &[
            ("format", || format(true)),
            ("layers", layers),
            ("pages for browsers", web::check_where_possible),
        ],
    ],
    &[&[("tests", test)]],
    // these need the program that the tests have built
    &[
        &[
            ("instructions of one step", || instructions::run(false)),
            ("Python", python::test),
        ],
        &[("book", book::check), ("browser", browser::test_where_possible)],
    ],
];

/// All checks of a merge, and how long each took.
pub fn ci() -> Result<(), String> {
    // they come through the network while others work; what fails here is told by the check that needs them
    std::thread::spawn(python::with_packages);
    let mut taken = Vec::new();
    for block in CHECKS {
        for row in beside(block) {
            taken.extend(row?);
        }
    }
    println!("==> all checks passed\n{}", taken.join("\n"));
    Ok(())
}

/// Makes rows of checks beside each other, and waits for all.
fn beside(rows: &[&[Check]]) -> Vec<Result<Vec<String>, String>> {
    std::thread::scope(|scope| {
        let begun: Vec<_> = rows.iter().map(|row| scope.spawn(|| in_turn(row))).collect();
        let ended = begun.into_iter().map(std::thread::ScopedJoinHandle::join);
        ended
            .map(|row| row.unwrap_or_else(|_| Err("a check panicked".to_string())))
            .collect()
    })
}

/// Makes checks one after the other, as far as they hold; tells how long each took.
fn in_turn(checks: &[Check]) -> Result<Vec<String>, String> {
    let one = |(name, check): &Check| {
        let began = Instant::now();
        check()?;
        Ok(format!("    {name}: {} s", began.elapsed().as_secs()))
    };
    checks.iter().map(one).collect()
}

/// All tests and the examples in the documentation.
pub fn test() -> Result<(), String> {
    if answers(&cargo(), &["nextest", "--version"]) {
        run_cargo(&[&["nextest", "run", "--workspace"], features()].concat(), &[])?;
        TESTED.get_or_init(|| ());
        run_cargo(&[&["test", "--doc", "--workspace"], features()].concat(), &[])
    } else {
        run_cargo(&[&["test", "--workspace"], features()].concat(), &[])?;
        TESTED.get_or_init(|| ());
        Ok(())
    }
}

fn clippy() -> Result<(), String> {
    let arguments = [
        &["clippy", "--locked", "--workspace"],
        features(),
        &["--all-targets", "--", "-D", "warnings"],
    ];
    run_cargo(&arguments.concat(), &[])
}

/// Units in documentation, such as `[m]`, which rustdoc takes for links.
const UNITS: [&str; 15] = [
    "m", "s", "kg", "N", "J", "Pa", "W", "K", "Hz", "rad", "deg", "bytes", "pixels", "J/m", "N/m",
];

/// Documentation without warnings, but for units in brackets that look like links.
pub fn documentation() -> Result<(), String> {
    println!("==> cargo doc, warnings as errors");
    let output = Command::new(cargo())
        .args([
            "doc",
            "--no-deps",
            "-p",
            "demeter-physics",
            "-p",
            "demeter",
            "--message-format",
            "short",
        ])
        .env("RUSTDOCFLAGS", "--force-warn rustdoc::broken-intra-doc-links")
        .current_dir(root())
        .output()
        .map_err(|error| format!("cannot start cargo: {error}"))?;
    let told = String::from_utf8_lossy(&output.stderr);
    let warnings: Vec<&str> = told.lines().filter(|line| is_warning(line)).collect();
    match (output.status.success(), warnings.is_empty()) {
        (true, true) => Ok(()),
        (true, false) => Err(warnings.join("\n")),
        (false, _) => Err(told.into_owned()),
    }
}

/// Whether a line of `cargo doc` warns of anything but a unit.
fn is_warning(line: &str) -> bool {
    let Some((_, message)) = line.split_once("warning: ") else {
        return false;
    };
    let generated = message.contains("generated") && message.contains("warning");
    let unit = message
        .strip_prefix("unresolved link to `")
        .and_then(|rest| rest.split('`').next())
        .is_some_and(|link| UNITS.contains(&link));
    !generated && !unit
}

/// Formats every file: `cargo fmt` does not see modules that a macro declares, which all contact laws are.
pub fn format(check: bool) -> Result<(), String> {
    let mut files = Vec::new();
    for folder in ["crates", "benches", "xtask/src"] {
        files.extend(rust_files(&root().join(folder))?);
    }
    let files: Vec<String> = files
        .iter()
        .map(|path| path.strip_prefix(root()).unwrap_or(path).display().to_string())
        .collect();
    let mut arguments = vec!["--edition", "2024"];
    if check {
        arguments.push("--check");
    }
    arguments.extend(files.iter().map(String::as_str));
    run("rustfmt", &arguments, &[])
}

/// The arrows of the design and the rules of the house.
pub fn layers() -> Result<(), String> {
    println!("==> layers");
    let mut faults = layers::check(&root())?;
    faults.extend(house_rules::check(&root())?);
    if faults.is_empty() {
        Ok(())
    } else {
        Err(faults.join("\n"))
    }
}

/// The verification cases at full size.
pub fn verify(filter: Option<&str>) -> Result<(), String> {
    let cases = match filter {
        None => "binary(verification)".to_string(),
        Some(part) => format!("binary(verification) & test({part})"),
    };
    let arguments = ["nextest", "run", "--release", "--workspace", "-E", &cases];
    run_cargo(&arguments, &[("DEMETER_FULL", "1")])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_is_no_broken_link() {
        assert!(is_warning("a.rs:1:2: warning: unresolved link to `Grain`: no item"));
        assert!(is_warning("a.rs:1:2: warning: unclosed HTML tag `f64`"));
        assert!(!is_warning(
            "a.rs:1:2: warning: unresolved link to `m`: no item named `m` in scope"
        ));
        assert!(!is_warning("warning: `demeter` (lib doc) generated 3 warnings"));
        assert!(!is_warning("    Finished `dev` profile"));
    }
}
