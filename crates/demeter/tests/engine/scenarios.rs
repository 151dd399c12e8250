//! Walks `scenarios/`: the good ones are ready to run, each bad one gives the messages written at its top.

use demeter::scenario::{Diagnostics, Prepared, Scenario, TEMPLATES, prepare};
use std::path::{Path, PathBuf};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios").join(name)
}

fn scenarios(name: &str) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder(name))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    files.sort();
    files
}

/// All that is checked before step 0.
fn check(file: &Path, overrides: &[String]) -> Result<Prepared, Diagnostics> {
    Scenario::read(file, overrides).and_then(|scenario| prepare(&scenario))
}

#[test]
fn good_scenarios_are_ready_to_run() {
    let files = scenarios("good");
    assert!(files.len() >= 6);
    for file in files {
        if let Err(faults) = check(&file, &[]) {
            panic!("{}", faults.render(false));
        }
    }
}

#[test]
fn templates_are_ready_to_run() {
    for (name, _, text) in TEMPLATES {
        let read = Scenario::parse(text, name, Path::new(""), &[]);
        if let Err(faults) = read.and_then(|scenario| prepare(&scenario)) {
            panic!("{}", faults.render(false));
        }
    }
}

#[test]
fn a_resolved_scenario_means_the_same() {
    let texts = scenarios("good")
        .into_iter()
        .map(|f| (std::fs::read_to_string(&f).unwrap(), folder("good")));
    let templates = TEMPLATES.iter().map(|t| (t.2.to_string(), PathBuf::new()));
    for (text, base) in texts.chain(templates) {
        let first = Scenario::parse(&text, "case", &base, &[]).unwrap();
        let resolved = first.to_resolved_toml();
        let again = match Scenario::parse(&resolved, "case", Path::new("elsewhere"), &[]) {
            Ok(again) => again,
            Err(faults) => panic!("{}\n{resolved}", faults.render(false)),
        };
        let told = |s: &Scenario| {
            let head = (
                s.title.clone(),
                s.seed,
                s.simulation.clone(),
                s.domain.clone(),
                s.materials.clone(),
            );
            let body = (
                s.contact.clone(),
                (s.grains.clone(), s.feeds.clone(), s.removals.clone()),
                s.walls.clone(),
                s.stages.clone(),
                s.measures.clone(),
                s.output.clone(),
            );
            format!("{head:?}{body:?}")
        };
        assert_eq!(told(&first), told(&again), "{resolved}");
    }
}

/// What a bad scenario must produce: its lines `# error: ` and `# help: `, and overrides, its lines `# set: `.
fn expected(text: &str) -> (Vec<String>, Vec<String>) {
    let head = || text.lines().map_while(|l| l.strip_prefix("# "));
    let faults = head().filter(|l| l.starts_with("error: ") || l.starts_with("help: "));
    let sets = head().filter_map(|l| l.strip_prefix("set: "));
    (faults.map(str::to_string).collect(), sets.map(str::to_string).collect())
}

fn found(faults: &Diagnostics) -> Vec<String> {
    let mut lines = Vec::new();
    for fault in faults.list() {
        match (fault.line, fault.source.as_str()) {
            (0, _) => lines.push(format!("error: {}", fault.message)),
            (_, "--set") => lines.push(format!("error: --set: {}", fault.message)),
            (line, _) => lines.push(format!("error: line {line}: {}", fault.message)),
        }
        lines.extend(fault.help.as_ref().map(|help| format!("help: {help}")));
    }
    lines
}

/// Whether a message is the expected one; `[...]` stands for what depends on the machine.
fn matches(expected: &str, found: &str) -> bool {
    let mut parts = expected.split("[...]");
    let Some(mut rest) = parts.next().and_then(|start| found.strip_prefix(start)) else {
        return false;
    };
    let mut open = false;
    for part in parts {
        let Some(at) = rest.find(part) else { return false };
        rest = &rest[at + part.len()..];
        open = part.is_empty();
    }
    open || rest.is_empty()
}

#[test]
fn bad_scenarios_give_their_messages() {
    let mut wrong = Vec::new();
    for file in scenarios("bad") {
        let text = String::from_utf8_lossy(&std::fs::read(&file).unwrap()).to_string();
        let (expected, sets) = expected(&text);
        let found = match check(&file, &sets) {
            Ok(_) => vec!["no error".to_string()],
            Err(faults) => {
                assert!(!faults.render(false).is_empty() && !faults.render(true).is_empty());
                found(&faults)
            }
        };
        let same = expected.len() == found.len() && expected.iter().zip(&found).all(|(e, f)| matches(e, f));
        if expected.is_empty() || !same {
            let lines: Vec<String> = found.iter().map(|l| format!("# {l}")).collect();
            wrong.push(format!("{}\n{}", file.display(), lines.join("\n")));
        }
    }
    assert!(
        wrong.is_empty(),
        "these give other messages than they carry:\n\n{}",
        wrong.join("\n\n")
    );
}
