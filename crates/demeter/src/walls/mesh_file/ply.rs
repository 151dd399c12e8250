//! PLY files, as text and binary of both byte orders (G. Turk, Stanford 1994). Vertices, faces and strips of triangles are read, all
//! other elements and properties are skipped.

use super::other_kind::without_mark;
use super::ply_header::{self, Element, Header, Scalar};
use super::polygon::Cutter;
use super::text::{number, shown};
use super::{Content, MeshFileError, MeshFormat};
use glam::DVec3;
use std::path::Path;

/// Whether a file begins as a PLY file does.
pub(super) fn looks_like_one(bytes: &[u8]) -> bool {
    let bytes = without_mark(bytes);
    bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r")
}

pub(super) fn parse(path: &Path, bytes: &[u8]) -> Result<Content, MeshFileError> {
    if !looks_like_one(bytes) {
        return Err(MeshFileError::UnknownFormat { path: path.to_owned() });
    }
    let (header, lines) = ply_header::parse(path, bytes)?;
    let rest = lines.rest();
    let mut body = Body {
        path,
        rest,
        format: header.format,
    };
    let (mut vertices, mut faces) = (Vec::new(), Faces::default());
    for element in &header.elements {
        check_count(element, &body)?;
        match element.name.as_str() {
            "vertex" => read_vertices(element, &mut body, &mut vertices)?,
            "face" => read_faces(element, &mut body, (&mut faces, told_vertices(&header)), false)?,
            "tristrips" => read_faces(element, &mut body, (&mut faces, told_vertices(&header)), true)?,
            _ => skip(element, &mut body)?,
        }
    }
    refuse_left_over(&header, &body)?;
    let mut cutter = Cutter::new(path, &vertices, 0);
    let mut start = 0;
    for end in faces.ends {
        cutter.add(&faces.corners[start..end])?;
        start = end;
    }
    Ok(Content::of_faces(header.format, cutter))
}

/// Corners of all faces one after the other, and where each face ends.
#[derive(Default)]
struct Faces {
    corners: Vec<usize>,
    ends: Vec<usize>,
}

impl Faces {
    /// Adds the triangles of a strip, of which each has two corners of the one before and turns the other way about them. Two strips
    /// that were joined have triangles without area between them.
    fn add_strip(&mut self, strip: &[usize]) {
        for (k, corners) in strip.windows(3).enumerate() {
            let &[a, b, c] = corners else { continue };
            if a != b && b != c && c != a {
                self.corners.extend(if k % 2 == 0 { [a, b, c] } else { [b, a, c] });
                self.ends.push(self.corners.len());
            }
        }
    }
}

/// Ends a strip within a list.
const END_OF_STRIP: f64 = -1.0;

/// Refuses counts that the rest of the file cannot hold, before memory is taken for them.
fn check_count(element: &Element, body: &Body<'_>) -> Result<(), MeshFileError> {
    // no blank need follow the last number of a text
    let (least, spare) = match (element.least_size(body.is_text()), body.is_text()) {
        // an entry without any property takes no room, but is not to be counted through
        (0, _) => (1, 0),
        (least, is_text) => (least, u64::from(is_text)),
    };
    let expected = element.count.saturating_mul(least as u64);
    if expected > body.rest.len() as u64 + spare {
        return Err(MeshFileError::CountTooLarge {
            path: body.path.to_owned(),
            element: element.name.chars().take(60).collect(),
            count: element.count,
            expected,
            left: body.rest.len(),
        });
    }
    Ok(())
}

/// A line end after the last entry is allowed.
fn refuse_left_over(header: &Header, body: &Body<'_>) -> Result<(), MeshFileError> {
    let left = body.rest.trim_ascii().len();
    let is_newline = header.format == MeshFormat::PlyAscii || body.rest.len() <= 2;
    if left == 0 && (is_newline || body.rest.is_empty()) {
        return Ok(());
    }
    Err(MeshFileError::LeftOver {
        path: body.path.to_owned(),
        bytes: body.rest.len(),
    })
}

fn read_vertices(element: &Element, body: &mut Body<'_>, vertices: &mut Vec<DVec3>) -> Result<(), MeshFileError> {
    let at = ["x", "y", "z"].map(|name| {
        let property = |p: &ply_header::Property| p.name == name && p.count.is_none();
        element.properties.iter().position(property)
    });
    let [Some(x), Some(y), Some(z)] = at else {
        return Err(no_property(body.path, ("vertex", element), "`x`, `y` and `z`"));
    };
    let mut values = vec![0.0; element.properties.len()];
    for _ in 0..element.count {
        for (value, property) in values.iter_mut().zip(&element.properties) {
            match property.count {
                None => *value = body.scalar(property.of)?,
                Some(count) => body.skip_list(count, property.of)?,
            }
        }
        vertices.push(DVec3::new(values[x], values[y], values[z]));
    }
    Ok(())
}

fn no_property(path: &Path, (name, element): (&'static str, &Element), needed: &'static str) -> MeshFileError {
    let names: Vec<String> = element
        .properties
        .iter()
        .take(12)
        .map(|p| format!("`{}`", p.name))
        .collect();
    MeshFileError::NoProperty {
        path: path.to_owned(),
        element: name,
        found: if names.is_empty() {
            "none".to_string()
        } else {
            names.join(", ")
        },
        needed,
    }
}

fn read_faces(
    element: &Element,
    body: &mut Body<'_>,
    (faces, vertices): (&mut Faces, usize),
    are_strips: bool,
) -> Result<(), MeshFileError> {
    let named = |p: &ply_header::Property| ["vertex_indices", "vertex_index"].contains(&p.name.as_str());
    let Some(list) = element.properties.iter().position(|p| named(p) && p.count.is_some()) else {
        let name = if are_strips { "tristrips" } else { "face" };
        return Err(no_property(body.path, (name, element), "a list `vertex_indices`"));
    };
    let mut strip = Vec::new();
    for _ in 0..element.count {
        for (k, property) in element.properties.iter().enumerate() {
            match property.count {
                None => {
                    body.scalar(property.of)?;
                }
                Some(count) if k == list => {
                    let corners = body.list_length(count, property.of)?;
                    for _ in 0..corners {
                        let value = body.scalar(property.of)?;
                        if are_strips && value == END_OF_STRIP {
                            faces.add_strip(&strip);
                            strip.clear();
                            continue;
                        }
                        let corner = index(value, (faces.ends.len() + 1, vertices), body.path)?;
                        if are_strips { &mut strip } else { &mut faces.corners }.push(corner);
                    }
                }
                Some(count) => body.skip_list(count, property.of)?,
            }
        }
        if are_strips {
            faces.add_strip(&strip);
            strip.clear();
        } else {
            faces.ends.push(faces.corners.len());
        }
    }
    Ok(())
}

/// The index of a vertex; whether the vertex exists is asked when the face is cut into triangles.
fn index(value: f64, (face, vertices): (usize, usize), path: &Path) -> Result<usize, MeshFileError> {
    if value >= 0.0 && value <= f64::from(u32::MAX) && value.fract() == 0.0 {
        return Ok(value as usize);
    }
    Err(MeshFileError::NoSuchVertex {
        path: path.to_owned(),
        face,
        index: value.to_string(),
        vertices,
    })
}

/// How many vertices the header tells of; the vertices may come after the faces.
fn told_vertices(header: &Header) -> usize {
    let vertices = header.elements.iter().find(|element| element.name == "vertex");
    vertices.map_or(0, |element| element.count as usize)
}

fn skip(element: &Element, body: &mut Body<'_>) -> Result<(), MeshFileError> {
    if element.properties.is_empty() {
        return Ok(());
    }
    for _ in 0..element.count {
        for property in &element.properties {
            match property.count {
                None => body.scalar(property.of).map(drop)?,
                Some(count) => body.skip_list(count, property.of)?,
            }
        }
    }
    Ok(())
}

/// What follows the header.
struct Body<'a> {
    path: &'a Path,
    rest: &'a [u8],
    format: MeshFormat,
}

impl Body<'_> {
    fn is_text(&self) -> bool {
        self.format == MeshFormat::PlyAscii
    }

    fn cut_short(&self) -> MeshFileError {
        MeshFileError::CutShort {
            path: self.path.to_owned(),
            expected: "all that its header tells of".to_string(),
        }
    }

    /// The next number.
    fn scalar(&mut self, of: Scalar) -> Result<f64, MeshFileError> {
        if self.is_text() {
            return self.word();
        }
        let (bytes, rest) = self.rest.split_at_checked(of.size()).ok_or_else(|| self.cut_short())?;
        self.rest = rest;
        let mut low_first = [0u8; 8];
        low_first[..bytes.len()].copy_from_slice(bytes);
        if self.format == MeshFormat::PlyBigEndian {
            low_first[..bytes.len()].reverse();
        }
        let [a, b, c, d, ..] = low_first;
        Ok(match of {
            Scalar::I8 => f64::from(a as i8),
            Scalar::U8 => f64::from(a),
            Scalar::I16 => f64::from(i16::from_le_bytes([a, b])),
            Scalar::U16 => f64::from(u16::from_le_bytes([a, b])),
            Scalar::I32 => f64::from(i32::from_le_bytes([a, b, c, d])),
            Scalar::U32 => f64::from(u32::from_le_bytes([a, b, c, d])),
            Scalar::F32 => f64::from(f32::from_le_bytes([a, b, c, d])),
            Scalar::F64 => f64::from_le_bytes(low_first),
        })
    }

    fn word(&mut self) -> Result<f64, MeshFileError> {
        self.rest = self.rest.trim_ascii_start();
        let end = self.rest.iter().position(u8::is_ascii_whitespace);
        let (word, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        if word.is_empty() {
            return Err(self.cut_short());
        }
        self.rest = rest;
        number(word).ok_or_else(|| MeshFileError::CutShort {
            path: self.path.to_owned(),
            expected: format!("all numbers that its header tells of (`{}` is none)", shown(word)),
        })
    }

    /// Length of a list that begins here; what the rest of the file cannot hold is refused.
    fn list_length(&mut self, count: Scalar, of: Scalar) -> Result<usize, MeshFileError> {
        let length = self.scalar(count)?;
        let least = if self.is_text() { 2.0 } else { of.size() as f64 };
        let fits = length >= 0.0 && length.fract() == 0.0 && length * least <= self.rest.len() as f64 + 1.0;
        if fits {
            Ok(length as usize)
        } else if length < 0.0 || length.fract() != 0.0 {
            Err(MeshFileError::CutShort {
                path: self.path.to_owned(),
                expected: format!("all lists that its header tells of (one would have {length} entries)"),
            })
        } else {
            Err(self.cut_short())
        }
    }

    fn skip_list(&mut self, count: Scalar, of: Scalar) -> Result<(), MeshFileError> {
        for _ in 0..self.list_length(count, of)? {
            self.scalar(of)?;
        }
        Ok(())
    }
}
