//! Writes the files of a new contact law and registers it.

use crate::shell::{read, root, write};
use std::path::Path;

/// A family of contact laws.
#[derive(Clone, Copy, Debug, PartialEq, clap::ValueEnum)]
pub enum Family {
    Normal,
    Tangential,
    Rolling,
    MultiContact,
}

impl Family {
    fn folder(self) -> &'static str {
        match self {
            Self::Normal => "normal",
            Self::Tangential => "tangential",
            Self::Rolling => "rolling",
            Self::MultiContact => "multi_contact",
        }
    }

    /// Source and documentation of a law that compiles and passes the conformance tests.
    fn templates(self) -> (&'static str, &'static str) {
        match self {
            Self::Normal => (
                include_str!("new_law_templates/normal.rs.txt"),
                include_str!("new_law_templates/normal.md"),
            ),
            Self::Tangential => (
                include_str!("new_law_templates/tangential.rs.txt"),
                include_str!("new_law_templates/tangential.md"),
            ),
            Self::Rolling => (
                include_str!("new_law_templates/rolling.rs.txt"),
                include_str!("new_law_templates/rolling.md"),
            ),
            Self::MultiContact => (
                include_str!("new_law_templates/multi_contact.rs.txt"),
                include_str!("new_law_templates/multi_contact.md"),
            ),
        }
    }
}

/// Writes the law into the workspace.
pub fn run(family: Family, name: &str) -> Result<(), String> {
    let folder = root().join("crates/physics/src/contact").join(family.folder());
    for file in generate(&folder, family, name)? {
        println!("{file}");
    }
    println!("Now write the law and its source; `cargo nextest run -p demeter-physics` already tests it.");
    Ok(())
}

/// Writes the law into the folder of its family and returns what was written.
fn generate(folder: &Path, family: Family, name: &str) -> Result<Vec<String>, String> {
    let names = Names::new(name)?;
    let registry = folder.join("mod.rs");
    let registered = register(&read(&registry)?, &names)?;
    let (source, doc) = family.templates();
    let files = [
        (folder.join(format!("{}.rs", names.snake)), names.fill(source)),
        (folder.join(format!("{}.md", names.snake)), names.fill(doc)),
    ];
    for (path, _) in &files {
        if path.exists() {
            return Err(format!("{} is there already", path.display()));
        }
    }
    for (path, text) in &files {
        write(path, text)?;
    }
    write(&registry, &registered)?;
    let shown = |path: &Path| path.display().to_string();
    Ok(vec![shown(&files[0].0), shown(&files[1].0), shown(&registry)])
}

/// One name in all its spellings.
struct Names {
    kebab: String,
    snake: String,
    pascal: String,
    words: String,
    title: String,
}

impl Names {
    fn new(name: &str) -> Result<Self, String> {
        let is_word = |word: &str| {
            word.starts_with(|c: char| c.is_ascii_lowercase())
                && word.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit())
        };
        if !name.split('-').all(is_word) {
            return Err(format!(
                "`{name}` is no name of a law; write words of small letters and digits joined by `-`: `thornton-ning`"
            ));
        }
        let capital = |word: &str| word[..1].to_uppercase() + &word[1..];
        let words = name.replace('-', " ");
        Ok(Self {
            kebab: name.to_string(),
            snake: name.replace('-', "_"),
            pascal: name.split('-').map(capital).collect(),
            title: capital(&words),
            words,
        })
    }

    fn fill(&self, template: &str) -> String {
        template
            .replace("@kebab@", &self.kebab)
            .replace("@snake@", &self.snake)
            .replace("@Pascal@", &self.pascal)
            .replace("@words@", &self.words)
            .replace("@title@", &self.title)
    }
}

/// The family's `mod.rs` with one more line in its list of laws.
fn register(registry: &str, names: &Names) -> Result<String, String> {
    let list = registry
        .find("    laws {\n")
        .ok_or("no `laws { ... }` in the family's mod.rs")?;
    let end = registry[list..]
        .find("\n    }")
        .ok_or("the list of laws in the family's mod.rs has no end")?;
    let entry = format!("        {}::{},", names.snake, names.pascal);
    if registry[list..list + end].lines().any(|line| line == entry) {
        return Err(format!("`{}` is registered already", names.kebab));
    }
    let (before, after) = registry.split_at(list + end);
    Ok(format!("{before}\n{entry}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::ValueEnum;
    use std::process::Command;
    use toml::Table;

    fn copy(from: &Path, to: &Path) {
        std::fs::create_dir_all(to).unwrap();
        for entry in std::fs::read_dir(from).unwrap() {
            let entry = entry.unwrap();
            let target = to.join(entry.file_name());
            if entry.path().is_dir() {
                copy(&entry.path(), &target);
            } else {
                std::fs::copy(entry.path(), target).unwrap();
            }
        }
    }

    /// A workspace of the physics crate alone, with the same dependencies, compiled in the same way.
    fn physics_alone(to: &Path) {
        copy(&root().join("crates/physics"), &to.join("crates/physics"));
        copy(&root().join(".cargo"), &to.join(".cargo"));
        std::fs::copy(root().join("Cargo.lock"), to.join("Cargo.lock")).unwrap();
        let mut manifest: Table = toml::from_str(&read(&root().join("Cargo.toml")).unwrap()).unwrap();
        let workspace = manifest["workspace"].as_table_mut().unwrap();
        workspace.insert("members".into(), vec!["crates/physics"].into());
        workspace.remove("default-members");
        let profile = manifest["profile"]["dev"].as_table_mut().unwrap();
        // compiled once, and run for the new laws alone
        profile.insert("opt-level".into(), 0.into());
        // without those of other packages, which would be told to match none
        let kept = ["*", "libm", "proptest"];
        let packages = profile["package"].as_table_mut().unwrap();
        packages.retain(|name, _| kept.contains(&name));
        write(&to.join("Cargo.toml"), &manifest.to_string()).unwrap();
    }

    #[test]
    fn a_new_law_of_each_family_compiles_and_passes_the_conformance_tests() {
        let copy = tempfile::tempdir().unwrap();
        physics_alone(copy.path());
        for &family in Family::value_variants() {
            let folder = copy.path().join("crates/physics/src/contact").join(family.folder());
            generate(&folder, family, "brand-new2").unwrap();
            let again = generate(&folder, family, "brand-new2").unwrap_err();
            assert!(again.contains("registered already"), "{again}");
        }
        // where the tests of the workspace have built the dependencies
        let target = std::env::current_exe()
            .unwrap()
            .ancestors()
            .find(|folder| folder.join("CACHEDIR.TAG").exists())
            .unwrap()
            .to_path_buf();
        let output = Command::new(crate::shell::cargo())
            .args(["test", "--offline", "--lib", "conformance"])
            .current_dir(copy.path())
            .env("DEMETER_LAW", "brand-new2")
            .env("CARGO_TARGET_DIR", target)
            .output()
            .unwrap();
        let told = format!(
            "{}{}",
            String::from_utf8_lossy(&output.stdout),
            String::from_utf8_lossy(&output.stderr)
        );
        assert!(output.status.success(), "{told}");
        assert!(!told.contains("warning"), "{told}");
    }

    #[test]
    fn what_is_written_is_formatted() {
        let names = Names::new("brand-new2").unwrap();
        for &family in Family::value_variants() {
            let folder = tempfile::tempdir().unwrap();
            let file = folder.path().join("law.rs");
            write(&file, &names.fill(family.templates().0)).unwrap();
            let config = root().join("rustfmt.toml").display().to_string();
            let status = Command::new("rustfmt")
                .args(["--edition", "2024", "--check", "--config-path", &config])
                .arg(&file)
                .status();
            assert!(status.unwrap().success());
        }
    }

    #[test]
    fn the_chapter_of_the_book_calls_what_the_templates_call() {
        let calls = |text: &str| -> Vec<String> {
            let from = text.find("fn respond(").unwrap();
            let body: Vec<&str> = text[from..].lines().take_while(|line| line.trim() != "```").collect();
            let end = body
                .iter()
                .position(|line| line.trim_start().starts_with("NormalResponse::"));
            vec![body[0].trim().to_owned(), body[end.unwrap()].trim().to_owned()]
        };
        let book = std::fs::read_to_string(root().join("book/src/adding-a-law.md")).unwrap();
        assert_eq!(calls(&book), calls(Family::Normal.templates().0));
    }

    #[test]
    fn a_name_has_one_spelling_for_each_place() {
        let names = Names::new("thornton-ning1998").unwrap();
        assert_eq!(
            names.fill("@kebab@ @snake@ @Pascal@ @words@ @title@"),
            "thornton-ning1998 thornton_ning1998 ThorntonNing1998 thornton ning1998 Thornton ning1998"
        );
        for wrong in ["", "-", "Hertz", "a--b", "a_b", "2d", "a-", "../x"] {
            assert!(Names::new(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn the_list_of_laws_gains_one_line_at_its_end() {
        let registry = "law_family! {\n    laws {\n        linear::Linear,\n    }\n}\n";
        let names = Names::new("jkr").unwrap();
        assert_eq!(
            register(registry, &names).unwrap(),
            "law_family! {\n    laws {\n        linear::Linear,\n        jkr::Jkr,\n    }\n}\n"
        );
        assert!(register("nothing", &names).is_err());
    }
}
