//! Numbers of a file, checked before anything is made of them.

use super::error::{FileProblem, Located};

/// Range of diameters of a file [m].
pub(crate) const DIAMETERS: std::ops::RangeInclusive<f64> = 1e-12..=1e6;
/// Largest magnitude of any other number of a file.
pub(crate) const LARGEST: f64 = 1e12;

/// The start of a text, for messages.
pub(crate) fn shown(text: &str) -> String {
    const MOST: usize = 60;
    let mut start: String = text
        .chars()
        .take(MOST)
        .map(|c| if c.is_control() { '?' } else { c })
        .collect();
    if text.chars().nth(MOST).is_some() {
        start.push_str("...");
    }
    start
}

/// Reads a finite number of magnitude up to 1e12.
pub(super) fn number(text: &str) -> Result<f64, FileProblem> {
    let value: f64 = text
        .parse()
        .map_err(|_| FileProblem::NotANumber { text: shown(text) })?;
    match value.abs() <= LARGEST {
        true => Ok(value),
        false => Err(not_allowed(text, "allowed are numbers of magnitude up to 1e12")),
    }
}

/// Reads an id or a type.
pub(super) fn whole(text: &str) -> Result<u32, FileProblem> {
    match text.parse() {
        Ok(value @ 1..) => Ok(value),
        _ => Err(not_allowed(text, "allowed are whole numbers from 1 to 4294967295")),
    }
}

/// Reads a tag, which may be written as `7.0`.
pub(super) fn tag(text: &str) -> Result<i32, FileProblem> {
    let value = number(text).unwrap_or(f64::NAN);
    if value.fract() == 0.0 && (f64::from(i32::MIN)..=f64::from(i32::MAX)).contains(&value) {
        Ok(value as i32)
    } else {
        Err(not_allowed(
            text,
            "tags are whole numbers from -2147483648 to 2147483647",
        ))
    }
}

pub(crate) fn not_allowed(text: &str, allowed: &'static str) -> FileProblem {
    FileProblem::NotAllowed {
        text: shown(text),
        allowed,
    }
}

/// Checks a diameter [m] that was read from `text`.
pub(crate) fn diameter(value: f64, text: &str) -> Result<f64, FileProblem> {
    match DIAMETERS.contains(&value) {
        true => Ok(value),
        false => Err(not_allowed(text, "allowed are diameters from 1e-12 m to 1e6 m")),
    }
}

/// Checks a density that was read from `text`.
pub(super) fn density(value: f64, text: &str) -> Result<f64, FileProblem> {
    match value >= 1e-12 {
        true => Ok(value),
        false => Err(not_allowed(text, "allowed are densities from 1e-12 to 1e12 kg/m^3")),
    }
}

/// Checks that all ids differ; `line_of` tells the line of a grain.
pub(super) fn check_ids(ids: &[u32], line_of: impl Fn(usize) -> usize) -> Result<(), Located> {
    let mut order: Vec<u32> = (0..ids.len() as u32).collect();
    order.sort_by_key(|i| ids[*i as usize]);
    for pair in order.windows(2) {
        let (before, grain) = (pair[0] as usize, pair[1] as usize);
        if ids[before] == ids[grain] {
            return Err(FileProblem::DuplicateId { id: ids[grain] }.at(line_of(grain), None));
        }
    }
    Ok(())
}
