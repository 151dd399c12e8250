//! The book's scenarios are read by the reader: whole ones as they are, fragments within a scenario that has the rest.

use demeter::scenario::{FitFile, ImpactFile, PackingFile, Scenario, prepare, template};
use std::path::{Path, PathBuf};
use toml::{Table, Value};

fn book() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src")
}

/// A block of TOML in a chapter.
struct Block {
    chapter: String,
    line: usize,
    /// What stands behind `toml` on the line that opens it.
    mark: String,
    text: String,
}

fn blocks(path: &Path) -> Vec<Block> {
    let text = std::fs::read_to_string(path).unwrap();
    let mut blocks: Vec<Block> = Vec::new();
    let mut open = false;
    let mut other = false;
    for (index, line) in text.lines().enumerate() {
        if let Some(fence) = line.strip_prefix("```") {
            if open || other {
                (open, other) = (false, false);
            } else if let Some(mark) = fence.strip_prefix("toml") {
                open = true;
                blocks.push(Block {
                    chapter: path.file_name().unwrap().to_string_lossy().into_owned(),
                    line: index + 1,
                    mark: mark.trim_start_matches([',', ' ']).to_string(),
                    text: String::new(),
                });
            } else {
                other = true;
            }
        } else if open {
            let block = blocks.last_mut().unwrap();
            match line
                .strip_prefix("{{#include ")
                .and_then(|rest| rest.strip_suffix("}}"))
            {
                Some(file) => block.text += &std::fs::read_to_string(book().join(file)).unwrap(),
                None => block.text += &format!("{line}\n"),
            }
        }
    }
    blocks
}

/// Puts a fragment into a table: tables into tables, all else in place of what was there.
fn merge(into: &mut Table, fragment: Table) {
    for (key, value) in fragment {
        match (into.get_mut(&key), value) {
            (Some(Value::Table(there)), Value::Table(value)) => merge(there, value),
            (_, value) => {
                into.insert(key, value);
            }
        }
    }
}

fn scenario(text: &str) -> Result<(), String> {
    let read = Scenario::parse(text, "book", &book().join("files"), &[]).map_err(|faults| faults.render(false))?;
    prepare(&read).map(|_| ()).map_err(|faults| faults.render(false))
}

fn check(block: &Block) -> Result<(), String> {
    if block.mark.starts_with("fragment") {
        let mut whole: Table = template("settle").unwrap().parse().unwrap();
        merge(
            &mut whole,
            block.text.parse().map_err(|error: toml::de::Error| error.to_string())?,
        );
        let read = scenario(&whole.to_string());
        // of a file that a reader has and the book has not, only its absence may be told
        let is_absence = |fault: &String| {
            let mut told = fault.lines().filter(|line| line.starts_with("error: "));
            block.mark == "fragment,file" && told.all(|line| line.contains("there is no file"))
        };
        return match read {
            Err(fault) if is_absence(&fault) => Ok(()),
            read => read,
        };
    }
    let table: Table = block.text.parse().map_err(|error: toml::de::Error| error.to_string())?;
    let told = |faults: demeter::scenario::Diagnostics| faults.render(false);
    let read = if table.contains_key("packing") {
        // the scenario that it names is that of the validation
        let base = book().join("../../validation/hydrogel");
        PackingFile::parse(&block.text, "book", &base, &[])
            .map(|_| ())
            .map_err(told)
    } else if table.contains_key("fit") {
        FitFile::parse(&block.text, "book", &[]).map(|_| ()).map_err(told)
    } else if table.contains_key("a") {
        ImpactFile::parse(&block.text, "book", &[]).map(|_| ()).map_err(told)
    } else {
        scenario(&block.text)
    };
    match (block.mark.as_str(), read) {
        ("bad", Ok(())) => Err("nothing is wrong with it".to_string()),
        ("bad", Err(_)) => Ok(()),
        (_, read) => read,
    }
}

#[test]
fn every_scenario_of_the_book_is_read() {
    let mut faults = Vec::new();
    let mut count = 0;
    for path in std::fs::read_dir(book()).unwrap().map(|f| f.unwrap().path()) {
        if path.extension().is_some_and(|e| e == "md") {
            for block in blocks(&path) {
                count += 1;
                if let Err(fault) = check(&block) {
                    faults.push(format!("{}:{}\n{fault}", block.chapter, block.line));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(count > 12, "only {count} were found");
}

#[test]
fn the_units_of_the_book_are_those_that_there_are() {
    let text = std::fs::read_to_string(book().join("units.md")).unwrap();
    for unit in demeter::scenario::units::UNITS {
        assert!(text.contains(&format!("`{}`", unit.symbol)), "{}", unit.symbol);
    }
    for (prefix, _) in demeter::scenario::units::PREFIXES
        .iter()
        .filter(|(prefix, _)| *prefix != "μ")
    {
        assert!(text.contains(&format!("`{prefix}`")), "{prefix}");
    }
}

#[path = "../../../../book/src/files/sinking.rs"]
#[allow(clippy::print_stdout, reason = "a program of a user prints")]
mod sinking;

#[test]
fn the_program_of_the_chapter_for_rust_works() {
    sinking::main().unwrap();
}
