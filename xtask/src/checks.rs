//! The checks of a merge, one by one and all together.

use crate::shell::{answers, cargo, root, run, run_cargo, rust_files};
use crate::{house_rules, layers, python};

/// The Python crate is left out of what needs linking: it is checked on its own.
const ALL_BUT_PYTHON: [&str; 3] = ["--workspace", "--exclude", "demeter-py"];

/// Everything that must hold before a merge. The quick checks come first.
pub fn ci() -> Result<(), String> {
    format(true)?;
    layers()?;
    clippy()?;
    run_cargo(&["check", "-p", "demeter-py", "--locked"], &[])?;
    documentation()?;
    test()?;
    python::test()?;
    println!("==> all checks passed");
    Ok(())
}

/// All tests and the examples in the documentation.
pub fn test() -> Result<(), String> {
    if answers(&cargo(), &["nextest", "--version"]) {
        run_cargo(&[&["nextest", "run"], &ALL_BUT_PYTHON[..]].concat(), &[])?;
        run_cargo(&[&["test", "--doc"], &ALL_BUT_PYTHON[..]].concat(), &[])
    } else {
        run_cargo(&[&["test"], &ALL_BUT_PYTHON[..]].concat(), &[])
    }
}

fn clippy() -> Result<(), String> {
    let arguments = [
        &["clippy"],
        &ALL_BUT_PYTHON[..],
        &["--all-targets", "--", "-D", "warnings"],
    ];
    run_cargo(&arguments.concat(), &[])
}

fn documentation() -> Result<(), String> {
    run_cargo(
        &["doc", "--no-deps", "-p", "demeter-physics", "-p", "demeter"],
        &[("RUSTDOCFLAGS", "-D warnings")],
    )
}

/// Formats every file: `cargo fmt` does not see modules that a macro declares, which all contact laws are.
pub fn format(check: bool) -> Result<(), String> {
    let mut files = Vec::new();
    for folder in ["crates", "xtask/src"] {
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
    let mut arguments = vec![
        "nextest",
        "run",
        "--release",
        "--workspace",
        "--exclude",
        "demeter-py",
        "-E",
        "binary(/^verification_/)",
    ];
    arguments.extend(filter);
    run_cargo(&arguments, &[("DEMETER_FULL", "1")])
}
