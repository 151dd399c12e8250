//! Rules of the house that the compiler does not know.

use crate::imports::{Token, tokens};
use crate::shell::{read, rust_files};
use std::path::Path;

/// Crates that neither print nor exit; only the command line does.
const SILENT: [&str; 5] = ["physics", "demeter", "web", "viewer", "python"];
const PRINTING: [&str; 5] = ["print", "println", "eprint", "eprintln", "dbg"];
/// Names that say nothing of what is inside.
const EMPTY_NAMES: [&str; 5] = ["utils", "util", "common", "misc", "helpers"];
const LONGEST_FILE: usize = 600;

/// Every breach, as `file:line: what is wrong`.
pub fn check(root: &Path) -> Result<Vec<String>, String> {
    let mut faults = Vec::new();
    for folder in ["crates", "xtask/src"] {
        for file in rust_files(&root.join(folder))? {
            let shown = file.strip_prefix(root).unwrap_or(&file);
            let source = read(&file)?;
            faults.extend(check_shape(shown, &source));
            let silent = SILENT
                .iter()
                .any(|name| shown.starts_with(format!("crates/{name}/src")));
            let is_test = shown.with_extension("").iter().any(|part| part == "tests");
            if silent && !is_test {
                faults.extend(check_silence(shown, &tokens(&source)));
            }
        }
    }
    Ok(faults)
}

fn check_shape(file: &Path, source: &str) -> Vec<String> {
    let mut faults = Vec::new();
    let lines = source.lines().count();
    if lines > LONGEST_FILE {
        faults.push(format!("{}:{lines}: longer than {LONGEST_FILE} lines", file.display()));
    }
    for part in file.with_extension("").iter() {
        if EMPTY_NAMES.iter().any(|name| part == *name) {
            faults.push(format!(
                "{}:1: a file named for what is inside is found again",
                file.display()
            ));
        }
    }
    faults
}

fn check_silence(file: &Path, tokens: &[Token]) -> Vec<String> {
    let word = |at: usize| tokens.get(at).map_or("", |token: &Token| token.text.as_str());
    let mut faults = Vec::new();
    let (mut depth, mut tests_end_at) = (0usize, None);
    for (at, token) in tokens.iter().enumerate() {
        match word(at) {
            "{" if at >= 2 && word(at - 2) == "mod" && word(at - 1) == "tests" => {
                tests_end_at = tests_end_at.or(Some(depth));
                depth += 1;
            }
            "{" => depth += 1,
            "}" => {
                depth = depth.saturating_sub(1);
                tests_end_at = tests_end_at.filter(|end| *end != depth);
            }
            _ => {}
        }
        if tests_end_at.is_some() {
            continue;
        }
        let prints = PRINTING.contains(&word(at)) && word(at + 1) == "!";
        let exits = word(at) == "process" && word(at + 1) == "::" && matches!(word(at + 2), "exit" | "abort");
        if prints || exits {
            let what = if prints { "prints" } else { "exits" };
            faults.push(format!(
                "{}:{}: a library {what}; only the command line may",
                file.display(),
                token.line
            ));
        }
    }
    faults
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_library_that_prints_or_exits_is_told() {
        let breaches = [
            "fn f() {\n    println!(\"x\");\n}",
            "\nuse std::process; fn f() { process::exit(1) }",
            "\nstd::process::abort()",
            "\ndbg!(x)",
        ];
        for source in breaches {
            let faults = check_silence(Path::new("a.rs"), &tokens(source));
            assert_eq!(faults.len(), 1, "{source}");
            assert!(faults[0].starts_with("a.rs:2: a library"), "{faults:?}");
        }
        let quiet = "// println!\nwriteln!(file, \"print!\")?; let exit = print(2);";
        assert!(check_silence(Path::new("a.rs"), &tokens(quiet)).is_empty());
        let tested = "mod tests {\n fn f() { println!() }\n}\n";
        assert!(check_silence(Path::new("a.rs"), &tokens(tested)).is_empty());
        let after = format!("{tested}fn g() {{ println!() }}");
        assert_eq!(check_silence(Path::new("a.rs"), &tokens(&after)).len(), 1);
    }

    #[test]
    fn long_files_and_empty_names_are_told() {
        assert_eq!(check_shape(Path::new("crates/x/src/utils.rs"), "").len(), 1);
        assert_eq!(check_shape(Path::new("crates/x/src/common/y.rs"), "").len(), 1);
        assert_eq!(
            check_shape(Path::new("crates/x/src/y.rs"), &"\n".repeat(LONGEST_FILE + 1)).len(),
            1
        );
        assert!(check_shape(Path::new("crates/x/src/y.rs"), &"\n".repeat(LONGEST_FILE)).is_empty());
    }

    #[test]
    fn this_workspace_keeps_the_rules() {
        assert_eq!(check(&crate::shell::root()).unwrap(), Vec::<String>::new());
    }
}
