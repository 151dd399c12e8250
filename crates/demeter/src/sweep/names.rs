//! Names of runs, which are those of their folders: `restitution=0.5_count=1000`.

use super::value::{Value, unquoted, value_of};
use crate::scenario::key_steps;
use std::collections::HashSet;

/// Longest name that is made of values.
const LONGEST: usize = 100;

/// Short names of keys: as many of their last steps as tell them apart.
pub fn short_keys(keys: &[String]) -> Vec<String> {
    let steps: Vec<Vec<String>> = keys
        .iter()
        .map(|key| key_steps(key).unwrap_or_else(|| vec![key.clone()]))
        .collect();
    let tail = |steps: &[String], length: usize| steps[steps.len().saturating_sub(length)..].join(".");
    let is_number = |step: &String| step.bytes().all(|b| b.is_ascii_digit());
    let short = |k: usize| {
        let own = &steps[k];
        let is_alone = |length: &usize| {
            let others = steps.iter().enumerate().filter(|(other, _)| *other != k);
            let begins = own[own.len() - *length..].first();
            !begins.is_some_and(is_number) && others.clone().all(|(_, s)| tail(s, *length) != tail(own, *length))
        };
        let length = (1..=own.len()).find(is_alone).unwrap_or(own.len());
        tail(own, length)
    };
    (0..keys.len()).map(short).collect()
}

/// Names of runs by their values, each the name of a folder on every system; numbers where values make none.
pub fn names(keys: &[String], runs: &[&[String]]) -> Vec<String> {
    let short = short_keys(keys);
    let name = |values: &&[String]| {
        let parts: Vec<String> = (short.iter().zip(*values))
            .map(|(key, value)| format!("{}={}", clean(key), clean(&readable(value))))
            .collect();
        parts.join("_")
    };
    let names: Vec<String> = runs.iter().map(name).collect();
    let mut taken = HashSet::new();
    let serve = names
        .iter()
        .all(|name| name.len() <= LONGEST && taken.insert(name.to_lowercase()));
    if serve {
        return names;
    }
    let width = runs.len().saturating_sub(1).to_string().len();
    (0..runs.len()).map(|k| format!("run-{k:0width$}")).collect()
}

/// Whether a name is one that is made here, which leads into no other folder.
pub fn is_name(name: &str) -> bool {
    let allowed = |c: char| c.is_ascii_alphanumeric() || "._=+-".contains(c);
    !name.is_empty() && name.len() <= LONGEST && !name.starts_with('.') && name.chars().all(allowed)
}

/// A value without quotes; a number stands right before its unit.
fn readable(written: &str) -> String {
    let text = unquoted(written);
    match value_of(written) {
        Value::Number { unit, .. } if !unit.is_empty() => {
            let number = text.trim().strip_suffix(&unit).unwrap_or(&text).trim_end();
            let unit = unit.replace('/', "-per-").replace('%', "percent").replace('^', "");
            format!("{number}{unit}")
        }
        _ => text,
    }
}

/// Letters and digits, all else as hyphens.
fn clean(text: &str) -> String {
    let mut cleaned = String::new();
    for c in text.chars() {
        match c {
            'µ' | 'μ' => cleaned.push('u'),
            c if c.is_ascii_alphanumeric() || ".+_".contains(c) => cleaned.push(c),
            '-' => cleaned.push('-'),
            _ if cleaned.ends_with('-') || cleaned.is_empty() => {}
            _ => cleaned.push('-'),
        }
    }
    cleaned.trim_end_matches('-').to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn owned(texts: &[&str]) -> Vec<String> {
        texts.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn keys_are_as_short_as_they_can_be() {
        let cases: [(&[&str], &[&str]); 4] = [
            (
                &["material.glass.restitution", "grains[0].count"],
                &["restitution", "count"],
            ),
            (
                &["grains[0].count", "grains[1].count"],
                &["grains.0.count", "grains.1.count"],
            ),
            (
                &["material.a.density", "material.b.density"],
                &["a.density", "b.density"],
            ),
            (&["wall[0].upper[2]", "seed"], &["upper.2", "seed"]),
        ];
        for (keys, short) in cases {
            assert_eq!(short_keys(&owned(keys)), short);
        }
    }

    #[test]
    fn names_tell_the_values() {
        let name = |keys: &[&str], values: &[&str]| names(&owned(keys), &[&owned(values)])[0].clone();
        let cases = [
            (("grains[0].diameter", "\"1.5 mm\""), "diameter=1.5mm"),
            (("grains[0].diameter", "-5 µm"), "diameter=-5um"),
            (("wall[0].motion.velocity", "2 mm/min"), "velocity=2mm-per-min"),
            (("simulation.gravity", "0 0 -9.81 m/s^2"), "gravity=0-0--9.81-m-s-2"),
            (("contact.normal.law", "jkr"), "law=jkr"),
            (("grains[0].file", "../a b.csv"), "file=..-a-b.csv"),
            (("grains[0].x", "[1, 2]"), "x=1-2"),
        ];
        for ((key, value), expected) in cases {
            let name = name(&[key], &[value]);
            assert_eq!(name, expected);
            assert!(is_name(&name), "{name}");
        }
        assert_eq!(name(&["a.x", "b.y"], &["1", "2"]), "x=1_y=2");
    }

    #[test]
    fn runs_are_numbered_where_values_make_no_names() {
        let long = "a".repeat(2 * LONGEST);
        let runs = [owned(&["1"]), owned(&[&long])];
        let runs: Vec<&[String]> = runs.iter().map(Vec::as_slice).collect();
        assert_eq!(names(&owned(&["x"]), &runs), ["run-0", "run-1"]);
        let twins = [owned(&["A/b"]), owned(&["a b"])];
        let twins: Vec<&[String]> = twins.iter().map(Vec::as_slice).collect();
        assert_eq!(names(&owned(&["x"]), &twins), ["run-0", "run-1"]);
    }

    #[test]
    fn names_that_lead_elsewhere_are_none() {
        for name in ["", "..", "a/b", "/a", ".x", "a\\b", "a b", "a\u{0}"] {
            assert!(!is_name(name), "{name}");
        }
    }
}
