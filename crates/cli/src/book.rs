//! The commands that the book and the README show are commands that there are.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests may fail as tests do")]

use crate::arguments::Arguments;
use clap::Parser;
use std::path::{Path, PathBuf};

/// Command lines of `demeter` in a text: in blocks of a shell, and those that the book runs.
fn commands(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut shell = false;
    // a line that ends with a backslash goes on
    let joined = text.replace("\\\n", " ");
    for line in joined.lines() {
        if let Some(mark) = line.trim_start().strip_prefix("```") {
            shell = !shell && ["sh", "console"].contains(&mark);
        }
        let run = line.strip_prefix("{{#run ").and_then(|rest| rest.strip_suffix("}}"));
        let typed = line.trim().trim_start_matches("$ ");
        if let Some(command) = run.or(shell.then_some(typed)).filter(|c| c.starts_with("demeter ")) {
            found.push(command.split(" #").next().unwrap_or_default().to_string());
        }
    }
    found
}

/// The words of a command line; quotes hold words together.
fn words(command: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quote = None;
    for c in command.chars() {
        match (quote, c) {
            (Some(open), c) if c == open => quote = None,
            (None, '\'' | '"') => quote = Some(c),
            (None, ' ') => words.push(String::new()),
            (_, c) => words.last_mut().unwrap().push(c),
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

#[test]
fn every_command_that_is_shown_is_one() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files: Vec<PathBuf> = vec![root.join("README.md")];
    for entry in std::fs::read_dir(root.join("book/src")).unwrap() {
        files.push(entry.unwrap().path());
    }
    files.retain(|file| file.extension().is_some_and(|e| e == "md"));
    let mut count = 0;
    for file in files {
        for command in commands(&std::fs::read_to_string(&file).unwrap()) {
            count += 1;
            if command == "demeter --version" {
                continue;
            }
            if let Err(error) = Arguments::try_parse_from(words(&command)) {
                panic!("{}: `{command}`: {error}", file.display());
            }
        }
    }
    assert!(count > 30, "only {count} commands were found");
}
