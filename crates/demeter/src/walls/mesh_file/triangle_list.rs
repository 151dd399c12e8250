//! Lists of triangles: nine numbers per line, the three corners of a triangle, after one header line or none. So are the
//! walls of the benchmark of Dosta et al., Computer Physics Communications 296 (2024) 109066.

use super::super::motion_file::{LENGTHS, name_and_unit, names};
use super::text::{Line, Lines, number, shown};
use super::{Content, MeshFileError, MeshFormat};
use glam::DVec3;
use std::path::Path;

/// Whether a text begins as a list of triangles does: its first or second line holds nine numbers.
pub(super) fn looks_like_one(bytes: &[u8]) -> bool {
    let mut lines = Lines::new(Path::new(""), bytes);
    let mut has_nine = || lines.next().is_some_and(|line| corners(&line).is_some());
    has_nine() || has_nine()
}

pub(super) fn parse(path: &Path, bytes: &[u8]) -> Result<Content, MeshFileError> {
    let mut lines = Lines::new(path, bytes);
    let mut triangles = Vec::new();
    let mut told_unit = None;
    let mut is_first = true;
    while let Some(line) = lines.next() {
        match corners(&line) {
            Some(triangle) => triangles.push(triangle),
            None if is_first && words(&line).all(|word| number(word).is_none()) => {
                told_unit = unit(path, &line)?;
            }
            None => return Err(lines.syntax(&line, "nine numbers, the three corners of a triangle")),
        }
        is_first = false;
    }
    Ok(Content {
        told_unit,
        ..Content::of_triangles(MeshFormat::TriangleList, triangles)
    })
}

fn words<'a>(line: &Line<'a>) -> impl Iterator<Item = &'a [u8]> + use<'a> {
    let between = |byte: &u8| byte.is_ascii_whitespace() || matches!(byte, b',' | b';');
    line.text.split(between).filter(|word: &&[u8]| !word.is_empty())
}

fn corners(line: &Line<'_>) -> Option<[DVec3; 3]> {
    let mut words = words(line);
    let mut values = [0.0; 9];
    for value in &mut values {
        *value = number(words.next()?)?;
    }
    let corner = |k: usize| DVec3::new(values[k], values[k + 1], values[k + 2]);
    words.next().is_none().then(|| [corner(0), corner(3), corner(6)])
}

/// The unit that all columns of a header name.
fn unit(path: &Path, line: &Line<'_>) -> Result<Option<(&'static str, f64)>, MeshFileError> {
    let text = String::from_utf8_lossy(line.text);
    // where blanks separate, a unit belongs to the name before it
    let (text, separators): (_, &[char]) = match [',', ';', '\t'].into_iter().find(|c| text.contains(*c)) {
        Some(_) => (text.into_owned(), &[',', ';', '\t']),
        None => (text.replace(" [", "[").replace(" (", "("), &[' ']),
    };
    let titles = text
        .trim_start_matches('#')
        .split(separators)
        .map(|title| title.trim().trim_matches('"'));
    let mut units = Vec::new();
    for title in titles.filter(|title| !title.is_empty()) {
        let told = name_and_unit(title).1.map(|unit| {
            let known = LENGTHS.iter().find(|(name, _)| *name == unit).copied();
            known.ok_or_else(|| MeshFileError::UnknownUnit {
                path: path.to_owned(),
                line: line.number,
                unit: shown(unit.as_bytes()),
                allowed: names(LENGTHS),
            })
        });
        units.push(told.transpose()?);
    }
    let first = units.first().copied().flatten();
    match units.iter().find(|unit| **unit != first) {
        None => Ok(first),
        Some(other) => {
            let name =
                |unit: Option<(&str, f64)>| unit.map_or_else(|| "no unit".to_owned(), |(name, _)| format!("`{name}`"));
            Err(MeshFileError::MixedUnits {
                path: path.to_owned(),
                line: line.number,
                first: name(first),
                other: name(*other),
            })
        }
    }
}
