//! Commands, folders and files.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Root of the workspace.
pub fn root() -> PathBuf {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
    manifest.parent().unwrap_or(manifest).to_path_buf()
}

/// The cargo that runs this program.
pub fn cargo() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_string())
}

/// A command in the root of the workspace, told before it starts.
pub fn run(program: &str, arguments: &[&str], environment: &[(&str, &str)]) -> Result<(), String> {
    let set: String = environment.iter().map(|(k, v)| format!("{k}='{v}' ")).collect();
    let shown: Vec<&str> = arguments.iter().copied().take(12).collect();
    let more = if arguments.len() > 12 { " ..." } else { "" };
    println!("==> {set}{} {}{more}", display_name(program), shown.join(" "));
    let status = Command::new(program)
        .args(arguments)
        .envs(environment.iter().copied())
        .current_dir(root())
        .status()
        .map_err(|error| format!("cannot start {program}: {error}"))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("{} {}: {status}", display_name(program), shown.join(" ")))
    }
}

/// Cargo with these arguments.
pub fn run_cargo(arguments: &[&str], environment: &[(&str, &str)]) -> Result<(), String> {
    run(&cargo(), arguments, environment)
}

fn display_name(program: &str) -> &str {
    Path::new(program)
        .file_name()
        .and_then(|name| name.to_str())
        .unwrap_or(program)
}

/// Whether a program answers to these arguments.
pub fn answers(program: &str, arguments: &[&str]) -> bool {
    Command::new(program)
        .args(arguments)
        .output()
        .is_ok_and(|output| output.status.success())
}

/// Text of a file.
pub fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

/// Writes a file.
pub fn write(path: &Path, text: &str) -> Result<(), String> {
    std::fs::write(path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}

/// Every Rust file below a folder, in order of their paths; not those of npm's packages.
pub fn rust_files(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_path_buf()];
    while let Some(folder) = folders.pop() {
        let entries =
            std::fs::read_dir(&folder).map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
        for entry in entries {
            let path = entry.map_err(|error| error.to_string())?.path();
            if path.is_dir() && path.file_name().is_some_and(|name| name != "node_modules") {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}

/// Removes the folder of an earlier run, and nothing that is not one.
pub fn remove_run(folder: &Path) -> Result<(), String> {
    let folder = root().join(folder);
    if !folder.join("summary.json").exists() {
        return Err(format!(
            "{} is there and is not the folder of a run; it is left as it is",
            folder.display()
        ));
    }
    std::fs::remove_dir_all(&folder).map_err(|error| format!("cannot remove {}: {error}", folder.display()))
}

/// Where cargo builds to.
pub fn target_folder() -> Result<PathBuf, String> {
    let output = Command::new(cargo())
        .args(["metadata", "--format-version", "1", "--no-deps", "--offline"])
        .current_dir(root())
        .output()
        .map_err(|error| format!("cannot ask cargo for its target folder: {error}"))?;
    let metadata: Value = serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata: {error}"))?;
    metadata["target_directory"]
        .as_str()
        .map(PathBuf::from)
        .ok_or_else(|| "cargo metadata names no target folder".to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_folder_of_a_run_is_removed() {
        let folder = tempfile::tempdir().unwrap();
        let run = folder.path().join("run");
        std::fs::create_dir(&run).unwrap();
        std::fs::write(run.join("notes.txt"), "mine").unwrap();
        assert!(remove_run(&run).unwrap_err().contains("is not the folder of a run"));
        assert!(run.join("notes.txt").exists());
        std::fs::write(run.join("summary.json"), "{}").unwrap();
        remove_run(&run).unwrap();
        assert!(!run.exists());
    }
}
