//! The arrows of the design: which module and which crate may import which.

use crate::imports::imports;
use crate::shell::{read, rust_files};
use std::path::{Path, PathBuf};

/// Modules of the engine from the lowest to the highest. A module imports from its own line and from those above it
/// in this table, never from one below.
const ORDER: [&[&str]; 11] = [
    &["particles", "materials", "comm", "threads", "grain_files"],
    &["neighbours", "walls"],
    &["contacts"],
    &["insertion"],
    &["step", "simulation", "checkpoint"],
    &["measure", "output"],
    &["results"],
    &["report"],
    &["compare"],
    &["scenario"],
    &["calibrate", "interchange", "render", "sweep"],
];

/// Crates and those of the workspace that they may depend on.
const CRATES: [(&str, &[&str]); 7] = [
    ("physics", &[]),
    ("web", &[]),
    ("demeter", &["demeter-physics", "demeter-web"]),
    ("viewer", &["demeter", "demeter-physics", "demeter-web"]),
    ("cli", &["demeter", "demeter-physics", "demeter-viewer"]),
    ("python", &["demeter", "demeter-physics"]),
    ("validation", &["demeter"]),
];

/// Names of the workspace's crates.
const PACKAGES: [&str; 7] = [
    "demeter",
    "demeter-physics",
    "demeter-web",
    "demeter-viewer",
    "demeter-cli",
    "demeter-py",
    "demeter-validation",
];

fn level(module: &str) -> Option<usize> {
    ORDER.iter().position(|modules| modules.contains(&module))
}

/// Every import and dependency against the arrows, as `file:line: what is wrong`.
pub fn check(root: &Path) -> Result<Vec<String>, String> {
    let mut faults = Vec::new();
    let source = root.join("crates/demeter/src");
    for file in rust_files(&source)? {
        let path = module_path(file.strip_prefix(&source).unwrap_or(&file));
        let shown = file.strip_prefix(root).unwrap_or(&file).display().to_string();
        faults.extend(check_file(&shown, &path, &read(&file)?));
    }
    for (folder, allowed) in CRATES {
        let manifest = root.join("crates").join(folder).join("Cargo.toml");
        faults.extend(check_manifest(
            &format!("crates/{folder}/Cargo.toml"),
            &read(&manifest)?,
            allowed,
        ));
    }
    Ok(faults)
}

/// `walls/mod.rs` and `walls.rs` are `[walls]`, `walls/motion.rs` is `[walls, motion]`, `lib.rs` is the root.
fn module_path(file: &Path) -> Vec<String> {
    let mut path: PathBuf = file.with_extension("");
    if path.ends_with("mod") || path == Path::new("lib") {
        path.pop();
    }
    path.iter().map(|part| part.to_string_lossy().into_owned()).collect()
}

fn check_file(file: &str, path: &[String], source: &str) -> Vec<String> {
    let Some(module) = path.first() else {
        return Vec::new();
    };
    let Some(own_level) = level(module) else {
        return vec![format!(
            "{file}:1: module `{module}` has no place in the order of modules; give it one in xtask/src/layers.rs"
        )];
    };
    let mut faults = Vec::new();
    for import in imports(source, path, "demeter") {
        let at = format!("{file}:{}", import.line);
        if import.module == "*" {
            faults.push(format!(
                "{at}: `crate::*` imports every module; name those that are needed"
            ));
        }
        if level(&import.module).is_some_and(|imported| imported > own_level) {
            faults.push(format!(
                "{at}: `{module}` imports `{}`, which stands above it; what both need belongs into `{module}` or below",
                import.module
            ));
        }
    }
    faults
}

fn check_manifest(file: &str, manifest: &str, allowed: &[&str]) -> Vec<String> {
    let mut faults = Vec::new();
    let mut own_name = "";
    for (index, line) in manifest.lines().enumerate() {
        let key = line.split(['=', '.', ' ']).next().unwrap_or_default().trim_matches('"');
        if key == "name" && own_name.is_empty() {
            own_name = line.split('"').nth(1).unwrap_or_default();
        }
        let table = line.trim().trim_start_matches('[').trim_end_matches(']');
        let named = table.rsplit('.').next().unwrap_or_default();
        let name = if line.starts_with('[') && table.contains("dependencies.") {
            named
        } else {
            key
        };
        if PACKAGES.contains(&name) && name != own_name && !allowed.contains(&name) {
            faults.push(format!("{file}:{}: must not depend on `{name}`", index + 1));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faults(file: &str, source: &str) -> Vec<String> {
        check_file(file, &module_path(Path::new(file)), source)
    }

    #[test]
    fn an_import_against_the_arrows_is_told_with_its_line() {
        let faults = faults(
            "walls/motion.rs",
            "use glam::DVec3;\n\nuse crate::{particles, contacts::Contact};\n",
        );
        assert_eq!(faults.len(), 1);
        assert!(
            faults[0].starts_with("walls/motion.rs:3: `walls` imports `contacts`"),
            "{faults:?}"
        );
    }

    #[test]
    fn each_module_may_not_import_what_stands_above_it() {
        for (low, lower) in ORDER.iter().enumerate() {
            for higher in &ORDER[low + 1..] {
                for (a, b) in lower.iter().zip(higher.iter().cycle()) {
                    let upwards = faults(&format!("{a}/x.rs"), &format!("use crate::{b}::X;"));
                    assert_eq!(upwards.len(), 1, "{a} imports {b}");
                    let downwards = faults(&format!("{b}.rs"), &format!("use crate::{a}::X;"));
                    assert_eq!(downwards, Vec::<String>::new(), "{b} imports {a}");
                }
            }
        }
    }

    #[test]
    fn neighbours_in_one_group_may_import_each_other() {
        assert!(faults("output/x.rs", "use crate::measure::Energies;").is_empty());
        assert!(faults("measure/x.rs", "use crate::output::Folder;").is_empty());
    }

    #[test]
    fn a_way_up_through_super_and_a_glob_are_found() {
        assert_eq!(
            faults("walls/mesh/x.rs", "use super::super::super::scenario::Unit;").len(),
            1
        );
        assert_eq!(faults("walls/x.rs", "use crate::*;").len(), 1);
    }

    #[test]
    fn an_unknown_module_needs_a_place() {
        assert!(faults("helpers/x.rs", "")[0].contains("no place"));
        assert!(faults("lib.rs", "pub use crate::scenario::Scenario;").is_empty());
    }

    #[test]
    fn physics_may_not_depend_on_the_engine() {
        let manifest = "[package]\nname = \"demeter-physics\"\n[dependencies]\nglam = \"1\"\n";
        assert!(check_manifest("x", manifest, &[]).is_empty());
        for line in [
            "demeter.workspace = true",
            "demeter = { path = \"..\" }",
            "[dependencies.demeter]",
        ] {
            let faults = check_manifest("x", &format!("{manifest}{line}\n"), &[]);
            assert_eq!(faults, ["x:5: must not depend on `demeter`"], "{line}");
        }
    }

    #[test]
    fn this_workspace_follows_the_arrows() {
        assert_eq!(check(&crate::shell::root()).unwrap(), Vec::<String>::new());
    }
}
