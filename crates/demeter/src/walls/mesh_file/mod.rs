//! Reads triangles from mesh files: STL, OBJ, PLY, and plain lists of triangles. The files are not trusted: what they
//! claim of their size is held against their length before memory is taken, and every refusal tells file and place.

mod error;
mod obj;
mod other_kind;
mod ply;
mod ply_header;
mod polygon;
mod stl;
mod text;
mod triangle_list;

pub use error::MeshFileError;

use glam::DVec3;
use polygon::Cutter;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Largest file that is read [bytes].
const MOST_BYTES: u64 = 2 << 30;
/// Largest coordinate [m]: beyond it a number is damaged, as by a bit that was turned.
const FARTHEST: f64 = 1e8;

/// Format of a mesh file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshFormat {
    /// Binary STL.
    StlBinary,
    /// STL as text.
    StlAscii,
    /// Wavefront OBJ.
    Obj,
    /// PLY as text.
    PlyAscii,
    /// Binary PLY, the low byte first.
    PlyLittleEndian,
    /// Binary PLY, the high byte first.
    PlyBigEndian,
    /// Nine numbers per line.
    TriangleList,
}

impl MeshFormat {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::StlBinary => "STL, binary",
            Self::StlAscii => "STL, text",
            Self::Obj => "OBJ",
            Self::PlyAscii => "PLY, text",
            Self::PlyLittleEndian => "PLY, binary (little endian)",
            Self::PlyBigEndian => "PLY, binary (big endian)",
            Self::TriangleList => "list of triangles",
        }
    }
}

/// What a mesh file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshFileContent {
    /// Format of the file.
    pub format: MeshFormat,
    /// Corners of every triangle, scaled and shifted.
    pub triangles: Vec<[DVec3; 3]>,
    /// Faces of more than three corners, which were cut into triangles.
    pub polygons: usize,
    /// Those of them whose outline crosses itself, or which are far from flat: their triangles are a guess.
    pub twisted: usize,
    /// Those whose corners do not lie in a plane, and how far apart these are across it at most [m].
    pub warped: (usize, f64),
    /// Unit that the file itself names, and its size [m]; only lists of triangles can.
    pub told_unit: Option<(&'static str, f64)>,
}

type Content = MeshFileContent;

impl Content {
    fn of_triangles(format: MeshFormat, triangles: Vec<[DVec3; 3]>) -> Self {
        Content {
            format,
            triangles,
            polygons: 0,
            twisted: 0,
            warped: (0, 0.0),
            told_unit: None,
        }
    }

    fn of_faces(format: MeshFormat, cutter: Cutter<'_>) -> Self {
        Content {
            polygons: cutter.polygons,
            twisted: cutter.twisted,
            warped: cutter.warped,
            ..Self::of_triangles(format, cutter.triangles)
        }
    }
}

/// Triangles of a mesh file; every corner `x` of the file becomes `x * scale + shift` [m]. Without a scale that is the
/// unit which the file names, and 1 when it names none.
///
/// The format is told by the content where it can be, else by the extension of the name.
pub fn read_mesh(path: &Path, scale: Option<f64>, shift: DVec3) -> Result<MeshFileContent, MeshFileError> {
    let bytes = read_bytes(path)?;
    let mut content = parse(path, &bytes)?;
    if content.triangles.is_empty() {
        return Err(MeshFileError::Empty { path: path.to_owned() });
    }
    let scale = scale.or(content.told_unit.map(|(_, size)| size)).unwrap_or(1.0);
    content.warped.1 *= scale.abs();
    for (index, triangle) in content.triangles.iter_mut().enumerate() {
        for corner in triangle {
            *corner = *corner * scale + shift;
            let usable = corner.is_finite() && corner.abs().max_element() <= FARTHEST;
            if !usable {
                return Err(MeshFileError::TooFar {
                    path: path.to_owned(),
                    triangle: index + 1,
                    corner: *corner,
                });
            }
        }
    }
    Ok(content)
}

fn read_bytes(path: &Path) -> Result<Vec<u8>, MeshFileError> {
    let fail = |source| MeshFileError::Read {
        path: path.to_owned(),
        source,
    };
    if !std::fs::metadata(path).map_err(fail)?.is_file() {
        return Err(MeshFileError::NotAFile { path: path.to_owned() });
    }
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(fail)?;
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(fail)?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(MeshFileError::TooLarge { path: path.to_owned() });
    }
    Ok(bytes)
}

fn parse(path: &Path, bytes: &[u8]) -> Result<Content, MeshFileError> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase());
    let extension = extension.as_deref().unwrap_or("");
    let binary_stl = || {
        Ok(Content::of_triangles(
            MeshFormat::StlBinary,
            stl::parse_binary(path, bytes)?,
        ))
    };
    if stl::fits_binary(bytes) && !ply::looks_like_one(bytes) {
        return binary_stl();
    }
    if stl::is_ascii(bytes) {
        return Ok(Content::of_triangles(
            MeshFormat::StlAscii,
            stl::parse_ascii(path, bytes)?,
        ));
    }
    if ply::looks_like_one(bytes) {
        return ply::parse(path, bytes);
    }
    if let Some((what, remedy)) = other_kind::seems(bytes) {
        return Err(MeshFileError::OtherKind {
            path: path.to_owned(),
            what,
            remedy,
        });
    }
    let is_text = other_kind::is_text(bytes);
    if extension == "obj" || (is_text && obj::looks_like_one(bytes)) {
        return obj::parse(path, bytes);
    }
    if triangle_list::looks_like_one(bytes) {
        return triangle_list::parse(path, bytes);
    }
    match extension {
        "stl" if !is_text || bytes.len() < stl::HEADER => binary_stl(),
        "ply" => ply::parse(path, bytes),
        "txt" | "csv" | "dat" => triangle_list::parse(path, bytes),
        _ => Err(MeshFileError::UnknownFormat { path: path.to_owned() }),
    }
}
