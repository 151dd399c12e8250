//! A file of another kind than the one that is read: one fault, in place of one for every key.

use super::diagnostics::Diagnostics;
use super::document::{Document, Value};
use super::schema::FileKind;
use std::sync::Arc;

/// Refuses a file that is plainly of another kind, and names the command that takes it.
pub(super) fn refuse_other_kind(name: &str, document: &Arc<Document>, wanted: FileKind) -> Result<(), Diagnostics> {
    let Value::Table(entries) = &document.root.value else {
        return Ok(());
    };
    let has = |keys: &[&str]| entries.iter().any(|entry| keys.contains(&entry.key.as_str()));
    let found = FileKind::ALL.into_iter().rev().find(|kind| has(marks(*kind)));
    let Some(found) = found.filter(|_| !has(marks(wanted))) else {
        return Ok(());
    };
    let (what, command) = told(found);
    let mut faults = Diagnostics::new(name, Arc::clone(document));
    faults.push(
        "",
        format!("this is {what}, not {}", told(wanted).0),
        Some(format!("{command} it")),
    );
    Err(faults)
}

/// Keys that files of a kind have.
fn marks(kind: FileKind) -> &'static [&'static str] {
    match kind {
        FileKind::Scenario => &["grains", "stage", "feed"],
        FileKind::TwoBodies => &["a", "b"],
        FileKind::Fit => &["observation", "fit"],
        FileKind::PackingFit => &["packing"],
    }
}

/// What a kind is called, and which commands take it.
fn told(kind: FileKind) -> (&'static str, &'static str) {
    match kind {
        FileKind::Scenario => ("the scenario of a run", "`demeter run` takes"),
        FileKind::TwoBodies => (
            "a file of two bodies",
            "`demeter collide`, `demeter contact-curve` and `demeter sticking` take",
        ),
        FileKind::Fit => ("a file of observations", "`demeter fit` takes"),
        FileKind::PackingFit => ("a file of a measured packing", "`demeter fit` takes"),
    }
}

#[cfg(test)]
mod tests {
    use crate::scenario::{FitFile, ImpactFile, Scenario, template};
    use std::path::Path;

    #[test]
    fn a_file_of_another_kind_is_told_in_one_fault() {
        let drum = template("drum").unwrap();
        let bodies = include_str!("../../../../examples/collide/mcc.toml");
        let fit = include_str!("../../../../examples/fit/mcc.toml");
        let here = Path::new(".");
        let run = |text: &str| Scenario::parse(text, "file.toml", here, &[]).unwrap_err().to_string();
        for (found, expected) in [
            (run(bodies), "this is a file of two bodies, not the scenario of a run"),
            (run(fit), "this is a file of observations, not the scenario of a run"),
            (
                ImpactFile::parse(drum, "file.toml", &[]).unwrap_err().to_string(),
                "this is the scenario of a run, not a file of two bodies",
            ),
            (
                FitFile::parse(drum, "file.toml", &[]).unwrap_err().to_string(),
                "this is the scenario of a run, not a file of observations",
            ),
        ] {
            assert!(found.contains(expected) && !found.contains('\n'), "{found}");
        }
        let found = run(bodies);
        assert!(found.contains("`demeter collide`, `demeter contact-curve`"), "{found}");
        // keys of another kind in a scenario are told one by one
        let both = format!("{drum}\n[a]\nradius = \"1 mm\"\n");
        assert!(run(&both).contains("unknown key `a` in the scenario"));
    }
}
