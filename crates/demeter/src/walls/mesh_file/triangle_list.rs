//! Lists of triangles: nine numbers per line, the three corners of a triangle, after one header line or none. So are the
//! walls of the benchmark of Dosta et al., Computer Physics Communications 296 (2024) 109066.

use super::text::{Line, Lines, number};
use super::{Content, MeshFileError, MeshFormat};
use glam::DVec3;
use std::path::Path;

/// Length units that a header may name in brackets, and their size [m].
const UNITS: [(&str, f64); 6] = [
    ("[m]", 1.0),
    ("[mm]", 1e-3),
    ("[cm]", 1e-2),
    ("[um]", 1e-6),
    ("[µm]", 1e-6),
    ("[in]", 0.0254),
];

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
            None if is_first && words(&line).all(|word| number(word).is_none()) => told_unit = unit(&line),
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
fn unit(line: &Line<'_>) -> Option<(&'static str, f64)> {
    let named = |word: &[u8]| {
        let text = std::str::from_utf8(word).ok()?;
        UNITS.into_iter().find(|(name, _)| text.ends_with(name))
    };
    let mut units = words(line).map(named);
    let first = units.next()??;
    units.all(|unit| unit == Some(first)).then_some(first)
}
