//! What the registry says of every law.

use super::cases::{PAIRS, values};
use crate::contact::multi_contact::MultiContactLaw;
use crate::contact::normal::NormalLaw;
use crate::contact::rolling::RollingLaw;
use crate::contact::tangential::TangentialLaw;
use crate::contact::{LawError, LawInfo, laws};
use crate::parameters::{Presence, Values};
use std::collections::BTreeSet;

/// Builds a law of any family; the law itself is not needed.
fn build(info: &LawInfo, name: &str, values: &Values) -> Result<&'static LawInfo, LawError> {
    let pair = &PAIRS[1];
    match info.family {
        "normal" => NormalLaw::build(name, values, pair).map(|law| law.info()),
        "tangential" => TangentialLaw::build(name, values, pair).map(|law| law.info()),
        "rolling" => RollingLaw::build(name, values, pair).map(|law| law.info()),
        "multi-contact" => MultiContactLaw::build(name, values, pair).map(|law| law.info()),
        other => panic!("family `{other}` is not tested"),
    }
}

fn words_joined_by(separator: char, name: &str) -> bool {
    name.split(separator)
        .all(|word| !word.is_empty() && word.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit()))
}

#[test]
fn names_are_unique_and_kebab_case() {
    let mut seen = BTreeSet::new();
    for info in laws() {
        assert!(seen.insert((info.family, info.name)), "{} twice", info.name);
        assert!(words_joined_by('-', info.name), "`{}` is not kebab-case", info.name);
    }
    assert!(seen.len() >= 7, "the registry lost laws: {seen:?}");
}

#[test]
fn every_law_is_documented_with_its_source() {
    for info in laws() {
        assert!(!info.summary.trim().is_empty(), "{}: no summary", info.name);
        for needed in ["Source", "```text", "| symbol | meaning | unit |"] {
            assert!(info.doc.contains(needed), "{}: its doc lacks `{needed}`", info.name);
        }
    }
}

#[test]
fn every_parameter_is_documented_and_in_range() {
    for info in laws() {
        let mut seen = BTreeSet::new();
        for p in info.parameters {
            let at = format!("{}, parameter {}", info.name, p.name);
            assert!(seen.insert(p.name), "{at}: twice");
            assert!(words_joined_by('_', p.name), "{at}: not snake_case");
            assert!(!p.doc.trim().is_empty(), "{at}: no doc");
            assert!(
                info.doc.contains(&format!("`{}`", p.name)),
                "{at}: not in the law's doc"
            );
            assert!(p.range.contains(p.typical), "{at}: typical value out of range");
        }
    }
}

#[test]
fn every_law_is_built_by_its_name() {
    for info in laws() {
        let built = build(info, info.name, &values(info, &[])).unwrap();
        assert_eq!(built.name, info.name);
        assert_eq!(info.history, info.history_dimensions.len());
    }
}

#[test]
fn wrong_parameters_are_refused_by_name() {
    let refused = |info: &LawInfo, values: &Values, parameter: &str| match build(info, info.name, values) {
        Err(LawError::Parameters { errors, .. }) => {
            assert_eq!(errors.len(), 1, "{}: {errors:?}", info.name);
            assert_eq!(errors[0].parameter(), parameter);
        }
        other => panic!("{}: {parameter} gave {other:?}", info.name),
    };
    for info in laws() {
        for p in info.parameters {
            refused(info, &values(info, &[(p.name, f64::NAN)]), p.name);
            refused(info, &values(info, &[(p.name, f64::INFINITY)]), p.name);
            let mut missing = values(info, &[]);
            missing.remove(p.name);
            match p.presence {
                Presence::Required => refused(info, &missing, p.name),
                // one of several alternatives: `Together` names the first of them
                Presence::Usual => assert!(build(info, info.name, &missing).is_err()),
                Presence::Optional | Presence::Default(_) => assert!(build(info, info.name, &missing).is_ok()),
            }
        }
        let mut unknown = values(info, &[]);
        unknown.insert("colour".to_string(), 1.0.into());
        refused(info, &unknown, "colour");
    }
}

#[test]
fn an_unknown_law_names_the_known_ones() {
    for info in laws() {
        let error = build(info, "no-such-law", &Values::new()).unwrap_err().to_string();
        assert!(error.contains(&format!("`{}`", info.name)), "{error}");
    }
}
