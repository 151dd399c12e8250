//! Why the file of a mesh was refused.

use glam::DVec3;
use std::io;
use std::path::PathBuf;
use thiserror::Error;

/// Why the file of a mesh was refused.
#[derive(Debug, Error)]
pub enum MeshFileError {
    /// The file cannot be read.
    #[error("cannot read the mesh file {}: {source}; check the path and the permissions", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The path is a folder or a device.
    #[error("{} is not a regular file; give the path of a mesh file", path.display())]
    NotAFile {
        /// The path.
        path: PathBuf,
    },
    /// The file is larger than what is read.
    #[error("{} has more than {} bytes; simplify the mesh", path.display(), super::MOST_BYTES)]
    TooLarge {
        /// The file.
        path: PathBuf,
    },
    /// Neither content nor name tell a format.
    #[error(
        "{} is in none of the formats that are read: STL (binary, or ASCII that begins with `solid`), OBJ (.obj), PLY (begins \
         with `ply`), or a list of triangles, nine numbers per line after a header; export the surface as STL",
        path.display()
    )]
    UnknownFormat {
        /// The file.
        path: PathBuf,
    },
    /// The beginning tells of another kind of file.
    #[error("{} seems to be {what}, which is not read; {remedy}", path.display())]
    OtherKind {
        /// The file.
        path: PathBuf,
        /// What it seems to be.
        what: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// The header of a PLY file does not tell what a mesh needs.
    #[error(
        "{}: `{element}` has the properties {found}, and needs {needed}; export the surface again, with vertices and faces",
        path.display()
    )]
    NoProperty {
        /// The file.
        path: PathBuf,
        /// The element.
        element: &'static str,
        /// The properties that it has.
        found: String,
        /// The properties that it needs.
        needed: &'static str,
    },
    /// The file is too short to be an STL file.
    #[error("{} has {bytes} bytes; a binary STL file has at least 84, an ASCII one begins with `solid`", path.display())]
    TooShort {
        /// The file.
        path: PathBuf,
        /// Its length.
        bytes: usize,
    },
    /// The count of a binary STL file does not fit its length.
    #[error(
        "{} is a binary STL file of {bytes} bytes whose header tells of {count} triangles, which take {expected} bytes; \
         the file is {}, export it again",
        path.display(),
        if *expected > *bytes as u64 { "cut short or damaged" } else { "damaged, or more lies behind its triangles" }
    )]
    WrongLength {
        /// The file.
        path: PathBuf,
        /// Its length.
        bytes: usize,
        /// Triangles that the header tells of.
        count: u32,
        /// Length that they need.
        expected: u64,
    },
    /// The counts of a PLY file do not fit its length.
    #[error(
        "{}: the header tells of {count} entries of `{element}`, which take at least {expected} bytes, and {left} bytes \
         follow; the file is cut short or damaged, export it again",
        path.display()
    )]
    CountTooLarge {
        /// The file.
        path: PathBuf,
        /// The element.
        element: String,
        /// How many entries the header tells of.
        count: u64,
        /// Least length of them.
        expected: u64,
        /// Bytes that are there.
        left: usize,
    },
    /// Data follow after all that the header of a PLY file tells of.
    #[error("{}: {bytes} bytes follow after all that the header tells of; the file is damaged, export it again", path.display())]
    LeftOver {
        /// The file.
        path: PathBuf,
        /// How many.
        bytes: usize,
    },
    /// The file holds no triangle.
    #[error("{} holds no triangle; export the surface again", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
    /// A coordinate is not a finite number, or so large that it must be damaged.
    #[error(
        "triangle {triangle} (counted from 1) of {} has a corner at ({:?}, {:?}, {:?}) m; coordinates must be finite and at most {} m; \
         the file is damaged, export it again, or correct `unit`, `scale`, `shift`",
        path.display(),
        corner.x,
        corner.y,
        corner.z,
        super::FARTHEST
    )]
    TooFar {
        /// The file.
        path: PathBuf,
        /// The triangle, counted from 1.
        triangle: usize,
        /// The corner, after scale and shift.
        corner: DVec3,
    },
    /// A line of a text is not what the format asks for.
    #[error("{}:{line}: expected {expected}, found `{found}`", path.display())]
    Syntax {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// What should be there.
        expected: String,
        /// What is there.
        found: String,
    },
    /// The header of a list of triangles names what is no unit of length that is known.
    #[error(
        "{}:{line}: unit `{unit}` is not known here; allowed: {allowed}; correct the titles, or leave units out of them and tell `unit`",
        path.display()
    )]
    UnknownUnit {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// The unit as written.
        unit: String,
        /// Units that are known.
        allowed: String,
    },
    /// The columns of a list of triangles do not have the same unit.
    #[error(
        "{}:{line}: the titles name {first} for some columns and {other} for others; name the same unit in all nine, or leave units \
         out of them and tell `unit`",
        path.display()
    )]
    MixedUnits {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// The unit of the first column.
        first: String,
        /// The unit of another.
        other: String,
    },
    /// A file ends too early.
    #[error("{} ends before {expected}; the file is cut short, export it again", path.display())]
    CutShort {
        /// The file.
        path: PathBuf,
        /// What should follow.
        expected: String,
    },
    /// A face names a vertex that is not there.
    #[error("face {face} (counted from 1) of {} names vertex {index}; the file has {vertices} vertices", path.display())]
    NoSuchVertex {
        /// The file.
        path: PathBuf,
        /// The face, counted from 1.
        face: usize,
        /// The vertex as written.
        index: String,
        /// Vertices of the file.
        vertices: usize,
    },
    /// A face has fewer than three corners.
    #[error("face {face} (counted from 1) of {} has {corners} corners; a face has at least 3", path.display())]
    TooFewCorners {
        /// The file.
        path: PathBuf,
        /// The face, counted from 1.
        face: usize,
        /// Its corners.
        corners: usize,
    },
    /// A concave face has too many corners to be cut into triangles.
    #[error(
        "face {face} (counted from 1) of {} is concave and has {corners} corners; at most {} are cut into triangles, so \
         triangulate on export",
        path.display(), super::polygon::MOST_CONCAVE
    )]
    TooManyCorners {
        /// The file.
        path: PathBuf,
        /// The face, counted from 1.
        face: usize,
        /// Its corners.
        corners: usize,
    },
}
