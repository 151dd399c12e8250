//! Wavefront OBJ files: vertices and faces. Texture, normals, groups and materials are not used; free-form surfaces are
//! refused.

use super::polygon::Cutter;
use super::text::{Line, Lines, number, shown};
use super::{Content, MeshFileError, MeshFormat};
use glam::DVec3;
use std::path::Path;

/// Words at the start of lines that tell nothing of the surface.
const IGNORED: [&[u8]; 15] = [
    b"vt", b"vn", b"vp", b"o", b"g", b"s", b"mg", b"usemtl", b"mtllib", b"l", b"p", b"usemap", b"maplib", b"lod",
    b"bevel",
];
/// Words at the start of lines that tell of a surface which is not made of faces.
const FREE_FORM: [&[u8]; 7] = [b"curv", b"curv2", b"surf", b"cstype", b"deg", b"bmat", b"parm"];

/// Whether a text begins as an OBJ file does.
pub(super) fn looks_like_one(bytes: &[u8]) -> bool {
    let mut lines = Lines::new(Path::new(""), bytes);
    lines.next_but_comments().is_some_and(|line| {
        let word = line.words().next().unwrap_or(b"");
        word == b"v" || word == b"f" || (IGNORED.contains(&word) && line.words().count() > 1)
    })
}

pub(super) fn parse(path: &Path, bytes: &[u8]) -> Result<Content, MeshFileError> {
    let mut lines = Lines::new(path, bytes);
    let mut vertices: Vec<DVec3> = Vec::new();
    // corners of all faces one after the other, for vertices may come after the faces that name them
    let (mut corners, mut ends): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
    while let Some(line) = lines.next() {
        let words = continued(&mut lines, line);
        match words.first().copied().unwrap_or(b"") {
            b"" => {}
            b"v" => vertices.push(vertex(&words).ok_or_else(|| lines.syntax(&line, "`v` and three numbers"))?),
            b"f" => {
                for word in &words[1..] {
                    let face = ends.len() + 1;
                    corners.push(corner(word, vertices.len(), path, face).map_err(|refused| {
                        refused
                            .unwrap_or_else(|| lines.syntax(&line, "`f` and the numbers of vertices, counted from 1"))
                    })?);
                }
                ends.push(corners.len());
            }
            word if IGNORED.contains(&word) => {}
            word if FREE_FORM.contains(&word) => {
                return Err(lines.syntax(&line, "faces (`f`): free-form surfaces are not read, export triangles"));
            }
            _ => return Err(lines.syntax(&line, "a line of an OBJ file, as `v 0 0 1` or `f 1 2 3`")),
        }
    }
    let mut cutter = Cutter::new(path, &vertices, 1);
    let mut start = 0;
    for end in ends {
        cutter.add(&corners[start..end])?;
        start = end;
    }
    Ok(Content::of_faces(MeshFormat::Obj, cutter))
}

/// Words of a line without its comment, with those of the next line where a backslash at the end asks for it.
fn continued<'a>(lines: &mut Lines<'a>, line: Line<'a>) -> Vec<&'a [u8]> {
    let told = |line: Line<'a>| line.words().take_while(|word| !word.starts_with(b"#"));
    let mut words: Vec<&[u8]> = told(line).collect();
    while let Some(b"\\") = words.last().copied() {
        words.pop();
        let Some(next) = lines.next() else { break };
        words.extend(told(next));
    }
    words
}

fn vertex(words: &[&[u8]]) -> Option<DVec3> {
    // a weight or a colour may follow
    let numbers: Option<Vec<f64>> = words
        .get(1..8.min(words.len()))?
        .iter()
        .map(|word| number(word))
        .collect();
    match numbers?.as_slice() {
        [x, y, z, ..] => Some(DVec3::new(*x, *y, *z)),
        _ => None,
    }
}

/// Index of a vertex, counted from 0, of a corner such as `3`, `3/1`, `3//2` or `-1`; negative ones count back from the
/// vertices so far. `Err(None)` when it is not a number.
fn corner(word: &[u8], so_far: usize, path: &Path, face: usize) -> Result<usize, Option<MeshFileError>> {
    let digits = word.split(|&byte| byte == b'/').next().unwrap_or(b"");
    let told: i64 = std::str::from_utf8(digits)
        .ok()
        .and_then(|w| w.parse().ok())
        .ok_or(None)?;
    let index = if told > 0 {
        usize::try_from(told - 1).ok()
    } else if told < 0 {
        usize::try_from(told.unsigned_abs())
            .ok()
            .and_then(|back| so_far.checked_sub(back))
    } else {
        None
    };
    index.ok_or_else(|| {
        Some(MeshFileError::NoSuchVertex {
            path: path.to_owned(),
            face,
            index: shown(digits),
            vertices: so_far,
        })
    })
}
