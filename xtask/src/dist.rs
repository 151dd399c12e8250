//! What is handed to users who do not build: the binary, completions, pages of the manual, licences, in one archive.

use crate::shell::{read, root, run, run_cargo, target_folder};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The package of the binary.
const BINARY: &str = "demeter-cli";
const SHELLS: [(&str, &str); 4] = [
    ("bash", "demeter.bash"),
    ("zsh", "_demeter"),
    ("fish", "demeter.fish"),
    ("powershell", "_demeter.ps1"),
];
/// Starts of the names of files that hold a licence.
const LICENCES: [&str; 5] = ["license", "licence", "copying", "copyright", "unlicense"];

/// Builds and packs. The binary needs no library of the system where that can be had: with musl when its target is
/// installed, else with the static parts of glibc.
pub fn pack() -> Result<(), String> {
    let target = target()?;
    let cargo_flags = ["build", "--release", "--locked", "-p", BINARY, "--target", &target];
    // line tables are for those who build it themselves; these flags take the place of those in `.cargo/config.toml`
    let mut flags = "-C llvm-args=-align-all-functions=6 -C strip=debuginfo".to_string();
    if target.contains("-linux-") {
        flags += " -C target-feature=+crt-static";
    }
    run_cargo(&cargo_flags, &[("RUSTFLAGS", &flags)])?;
    let built = target_folder()?;
    let name = format!("demeter-{}-{target}", version()?);
    let folder = built.join("dist").join(&name);
    if folder.exists() {
        std::fs::remove_dir_all(&folder).map_err(|error| format!("cannot remove {}: {error}", folder.display()))?;
    }
    let binary = folder.join("demeter");
    make(&folder.join("completions"))?;
    copy(&built.join(&target).join("release/demeter"), &binary)?;
    let binary = binary.display().to_string();
    for (shell, file) in SHELLS {
        let text = answer(&binary, &["completions", shell])?;
        write(&folder.join("completions").join(file), &text)?;
    }
    run(&binary, &["man", &folder.join("man").display().to_string()], &[])?;
    for file in ["LICENSE-APACHE", "LICENSE-MIT", "README.md", "CHANGELOG.md"] {
        copy(&root().join(file), &folder.join(file))?;
    }
    write(&folder.join("THIRD-PARTY.md"), &third_party(&target)?)?;
    check_static(&binary)?;
    let dist = built.join("dist").display().to_string();
    let archive = format!("{name}.tar.gz");
    run("tar", &["-czf", &format!("{dist}/{archive}"), "-C", &dist, &name], &[])?;
    println!("==> packed {dist}/{archive}");
    Ok(())
}

/// Writes the licences of everything that the binary holds to standard output.
pub fn licences() -> Result<(), String> {
    print!("{}", third_party(&target()?)?);
    Ok(())
}

/// The target: musl where it is installed, else the machine's own.
fn target() -> Result<String, String> {
    let told = answer("rustc", &["-vV"])?;
    let host = told.lines().find_map(|line| line.strip_prefix("host: "));
    let host = host.ok_or("rustc does not tell its host")?.to_owned();
    let musl = host.replace("-gnu", "-musl");
    let libraries = answer("rustc", &["--print", "sysroot"])?;
    let installed = Path::new(libraries.trim()).join("lib/rustlib").join(&musl).join("lib");
    let std_is_there = musl != host
        && std::fs::read_dir(&installed).is_ok_and(|entries| {
            entries
                .flatten()
                .any(|entry| entry.file_name().to_string_lossy().starts_with("libstd-"))
        });
    Ok(if std_is_there { musl } else { host })
}

/// Refuses a binary for Linux that asks for libraries of the system.
fn check_static(binary: &str) -> Result<(), String> {
    let Ok(output) = Command::new("ldd").arg(binary).output() else {
        println!("==> there is no ldd; whether the binary is static is not checked");
        return Ok(());
    };
    let told = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    let needs_none = told.contains("statically linked") || told.contains("not a dynamic executable");
    println!("==> ldd: {}", told.trim());
    if needs_none {
        Ok(())
    } else {
        Err("the binary asks for libraries of the system".to_owned())
    }
}

/// Name, version, licence and texts of every package in the binary.
fn third_party(target: &str) -> Result<String, String> {
    let arguments = [
        "metadata",
        "--format-version",
        "1",
        "--locked",
        "--filter-platform",
        target,
    ];
    let metadata: Value = serde_json::from_str(&answer(&crate::shell::cargo(), &arguments)?)
        .map_err(|error| format!("cargo metadata: {error}"))?;
    let mut texts: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut table = String::new();
    for package in packages(&metadata)? {
        let text = |key: &str| package[key].as_str().unwrap_or_default().to_owned();
        let name = format!("{} {}", text("name"), text("version"));
        let licence = if text("license").is_empty() {
            "see its text below".to_owned()
        } else {
            text("license")
        };
        // Writing to a String cannot fail.
        let _ = writeln!(table, "| {name} | {licence} | {} |", text("repository"));
        let folder = PathBuf::from(text("manifest_path"))
            .parent()
            .map(Path::to_path_buf)
            .unwrap_or_default();
        for text in licence_texts(&folder) {
            texts.entry(text).or_default().insert(name.clone());
        }
    }
    let mut out = String::from(
        "# Licences of what the binary holds\n\nWritten by `cargo xtask licences`.\n\n| package | licence | source |\n|---|---|---|\n",
    );
    out.push_str(&table);
    for (text, names) in &texts {
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let _ = write!(out, "\n## {}\n\n```text\n{}\n```\n", names.join(", "), text.trim_end());
    }
    Ok(out)
}

/// The packages of others that the binary is built of, sorted by name.
fn packages(metadata: &Value) -> Result<Vec<&Value>, String> {
    let list = |value: &'_ Value| value.as_array().cloned().unwrap_or_default();
    let all = metadata["packages"]
        .as_array()
        .ok_or("cargo metadata names no packages")?;
    let by_id: BTreeMap<&str, &Value> = all.iter().filter_map(|p| Some((p["id"].as_str()?, p))).collect();
    let root = all.iter().find(|p| p["name"] == BINARY).and_then(|p| p["id"].as_str());
    let nodes = list(&metadata["resolve"]["nodes"]);
    let mut found: BTreeSet<String> = BTreeSet::new();
    let mut next: VecDeque<String> = root.map(str::to_owned).into_iter().collect();
    while let Some(id) = next.pop_front() {
        if !found.insert(id.clone()) {
            continue;
        }
        let node = nodes.iter().find(|node| node["id"] == id.as_str());
        for dependency in node.map(|node| list(&node["deps"])).unwrap_or_default() {
            // neither what only builds nor what only tests is in the binary
            let normal = list(&dependency["dep_kinds"]).iter().any(|kind| kind["kind"].is_null());
            if let (true, Some(id)) = (normal, dependency["pkg"].as_str()) {
                next.push_back(id.to_owned());
            }
        }
    }
    let others = found.iter().filter_map(|id| by_id.get(id.as_str()).copied());
    let mut others: Vec<&Value> = others.filter(|package| !package["source"].is_null()).collect();
    others.sort_by_key(|package| package["name"].as_str().unwrap_or_default().to_owned());
    Ok(others)
}

/// Texts of the files of a package that hold its licences.
fn licence_texts(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.path()).collect();
    files.sort();
    let is_licence = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
        path.is_file() && LICENCES.iter().any(|start| name.starts_with(start))
    };
    files
        .iter()
        .filter(|path| is_licence(path))
        .filter_map(|path| std::fs::read_to_string(path).ok())
        .collect()
}

fn version() -> Result<String, String> {
    let manifest: toml::Table = read(&root().join("Cargo.toml"))?
        .parse()
        .map_err(|error| format!("Cargo.toml: {error}"))?;
    let version = manifest["workspace"]["package"]["version"].as_str();
    version
        .map(str::to_owned)
        .ok_or_else(|| "Cargo.toml tells no version".to_owned())
}

fn answer(program: &str, arguments: &[&str]) -> Result<String, String> {
    let fails = |why: String| format!("{program} {}: {why}", arguments.join(" "));
    let output = Command::new(program).args(arguments).current_dir(root()).output();
    let output = output.map_err(|error| fails(error.to_string()))?;
    match output.status.success() {
        true => String::from_utf8(output.stdout).map_err(|error| fails(error.to_string())),
        false => Err(fails(String::from_utf8_lossy(&output.stderr).into_owned())),
    }
}

fn make(folder: &Path) -> Result<(), String> {
    std::fs::create_dir_all(folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    let copied = std::fs::copy(from, to);
    copied
        .map(|_| ())
        .map_err(|error| format!("cannot copy {} to {}: {error}", from.display(), to.display()))
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    std::fs::write(path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}
