//! The book: its chapters, what is generated for it from the references, the registries and runs, and its pages.
//!
//! `book/src` holds what people write. Lines `{{#...}}` in it stand for what is made here, in the folder of the build:
//!
//! | line | what it becomes |
//! |---|---|
//! | `{{#reference scenario.md}}` | the tables of keys of a kind of file, with links between them |
//! | `{{#laws}}` | the list of the contact laws; every law gets a page of its own |
//! | `{{#repo PATH}}` | a text of the repository |
//! | `{{#run demeter ARGUMENTS}}` | the command and what it says, run in a folder that the chapters share |
//! | `{{#chapter PATH TITLE}}` | a line of the contents, where there is such a chapter |
//! | `{{#picture PATH TEXT}}` | a picture that such a command wrote, or one of the repository |
//!
//! Formulas between `$` become MathML, which browsers draw without a script and without a network. So do those of the laws, which are
//! written for a terminal, too.

mod expand;
mod law_text;
mod laws;
mod links;
mod maths;
mod plain_maths;
mod reference;

use crate::checks::build_demeter;
use crate::shell::{answers, read, root, run, target_folder, write};
use expand::Workplace;
use std::path::{Path, PathBuf};

/// The version that the pages are tried with.
const MDBOOK: &str = "0.5.4";

/// Makes the book and checks its links.
pub fn make() -> Result<(), String> {
    match build()? {
        true => Ok(()),
        false => Err(format!(
            "mdbook is not there; `cargo install mdbook --locked --version {MDBOOK}` installs it (or set MDBOOK to its path)"
        )),
    }
}

/// The same; without mdbook all that is generated is made, and the pages are not.
pub fn check() -> Result<(), String> {
    if !build()? {
        println!("==> mdbook is not there: the pages of the book are not made, nor are their links checked");
    }
    Ok(())
}

/// Whether mdbook is there and made the pages.
fn build() -> Result<bool, String> {
    let mdbook = std::env::var("MDBOOK").unwrap_or_else(|_| "mdbook".to_string());
    let target = target_folder()?;
    let build = target.join("book-source");
    let pages = target.join("book");
    build_demeter()?;
    sources(&build, &target.join("debug/demeter"))?;
    if !answers(&mdbook, &["--version"]) {
        return Ok(false);
    }
    let (build_shown, pages_shown) = (build.display().to_string(), pages.display().to_string());
    run(&mdbook, &["build", &build_shown, "--dest-dir", &pages_shown], &[])?;
    let broken = links::broken(&pages)?;
    if !broken.is_empty() {
        return Err(format!("links that lead nowhere:\n{}", broken.join("\n")));
    }
    println!("==> the book is {}", pages.join("index.html").display());
    Ok(true)
}

/// Writes the sources of the book with all that is generated.
fn sources(build: &Path, demeter: &Path) -> Result<(), String> {
    empty(build)?;
    let written = root().join("book");
    copy(&written, build)?;
    let mut workplace = Workplace::new(build, demeter)?;
    let laws = laws::known(demeter)?;
    laws::pages(&build.join("src"), &laws)?;
    let chapters = markdown(&build.join("src"))?;
    for chapter in chapters {
        let text = expand::expand(&read(&chapter)?, &chapter, &mut workplace, &laws)?;
        let text = maths::render(&text).map_err(|error| format!("{}: {error}", chapter.display()))?;
        write(&chapter, &text)?;
    }
    Ok(())
}

fn empty(folder: &Path) -> Result<(), String> {
    match std::fs::remove_dir_all(folder) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            Err(format!("cannot empty {}: {error}", folder.display()))
        }
        _ => std::fs::create_dir_all(folder).map_err(|error| format!("cannot make {}: {error}", folder.display())),
    }
}

/// Copies a folder with all that is in it.
fn copy(from: &Path, to: &Path) -> Result<(), String> {
    let failed = |path: &Path, error: std::io::Error| format!("cannot copy {}: {error}", path.display());
    std::fs::create_dir_all(to).map_err(|error| failed(to, error))?;
    for entry in std::fs::read_dir(from).map_err(|error| failed(from, error))? {
        let path = entry.map_err(|error| failed(from, error))?.path();
        let target = to.join(path.file_name().unwrap_or_default());
        if path.is_dir() {
            copy(&path, &target)?;
        } else {
            std::fs::copy(&path, &target).map_err(|error| failed(&path, error))?;
        }
    }
    Ok(())
}

/// Every chapter below a folder.
fn markdown(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let mut found = Vec::new();
    let entries = std::fs::read_dir(folder).map_err(|error| format!("cannot read {}: {error}", folder.display()))?;
    for entry in entries {
        let path = entry.map_err(|error| error.to_string())?.path();
        if path.is_dir() {
            found.extend(markdown(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

/// What a command says, without colours. `demeter` stands for the one that was built.
fn said(demeter: &Path, folder: &Path, command: &str) -> Result<String, String> {
    let words = words(command);
    let Some(("demeter", arguments)) = words.split_first().map(|(first, rest)| (first.as_str(), rest)) else {
        return Err(format!("only `demeter` is run in the book, not `{command}`"));
    };
    let output = std::process::Command::new(demeter)
        .args(arguments)
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .output()
        .map_err(|error| format!("cannot start {}: {error}", demeter.display()))?;
    let told = format!(
        "{}{}",
        String::from_utf8_lossy(&output.stderr),
        String::from_utf8_lossy(&output.stdout)
    );
    // a command that shows what is wrong with a file is no mistake of the book
    match output.status.code() {
        Some(0 | 2) => Ok(told),
        _ => Err(format!("`{command}` ended with {}: {told}", output.status)),
    }
}

/// The words of a command line; quotes hold words together.
fn words(command: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word = String::new();
    let mut quote = None;
    for c in command.trim().chars() {
        match (quote, c) {
            (Some(open), c) if c == open => quote = None,
            (None, '\'' | '"') => quote = Some(c),
            (None, ' ') => words.extend((!word.is_empty()).then(|| std::mem::take(&mut word))),
            _ => word.push(c),
        }
    }
    words.extend((!word.is_empty()).then_some(word));
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotes_hold_words_together() {
        assert_eq!(
            words("demeter collide a.toml --set impact.angle='\"60 deg\"'"),
            ["demeter", "collide", "a.toml", "--set", "impact.angle=\"60 deg\""]
        );
    }
}
