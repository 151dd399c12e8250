//! What a `.vtp` file of VTK holds: points with cells and named arrays.

use super::vtk_file::NewPolyData;
use glam::DVec3;
use std::borrow::Cow;
use std::io;

/// The numbers of an array.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// 64-bit floating point.
    Float64(Vec<f64>),
    /// 32-bit integer.
    Int32(Vec<i32>),
    /// 32-bit integer, not negative.
    UInt32(Vec<u32>),
    /// 64-bit integer.
    Int64(Vec<i64>),
}

impl Values {
    /// The numbers of a type that is told by its name in the file; nothing for a type that is not written. Bytes behind the
    /// last whole number are left out.
    pub(crate) fn from_bytes(kind: &str, bytes: &[u8]) -> Option<Self> {
        fn all<const N: usize, T>(bytes: &[u8], read: fn([u8; N]) -> T) -> Vec<T> {
            bytes.as_chunks().0.iter().map(|number| read(*number)).collect()
        }
        Some(match kind {
            "Float64" => Self::Float64(all(bytes, f64::from_le_bytes)),
            "Int32" => Self::Int32(all(bytes, i32::from_le_bytes)),
            "UInt32" => Self::UInt32(all(bytes, u32::from_le_bytes)),
            "Int64" => Self::Int64(all(bytes, i64::from_le_bytes)),
            _ => return None,
        })
    }

    /// Size of a number of a type [bytes]; nothing for a type that is not written.
    pub(crate) fn size_of(kind: &str) -> Option<usize> {
        match kind {
            "Float64" | "Int64" => Some(8),
            "Int32" | "UInt32" => Some(4),
            _ => None,
        }
    }

    /// How many numbers there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Float64(v) => v.len(),
            Self::Int32(v) => v.len(),
            Self::UInt32(v) => v.len(),
            Self::Int64(v) => v.len(),
        }
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// A number as floating point, by its place; 64-bit integers beyond 2^53 are rounded.
    pub fn number(&self, at: usize) -> Option<f64> {
        match self {
            Self::Float64(v) => v.get(at).copied(),
            Self::Int32(v) => v.get(at).map(|x| f64::from(*x)),
            Self::UInt32(v) => v.get(at).map(|x| f64::from(*x)),
            Self::Int64(v) => v.get(at).map(|x| *x as f64),
        }
    }
}

/// A named array.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    /// Its name.
    pub name: Cow<'static, str>,
    /// Numbers per point or cell.
    pub components: usize,
    /// The numbers, those of a point or cell behind each other.
    pub values: Values,
}

impl Array {
    /// One `f64` per point or cell.
    pub fn scalars(name: &'static str, values: impl IntoIterator<Item = f64>) -> Self {
        Self::new(name, 1, Values::Float64(values.into_iter().collect()))
    }

    /// One vector per point or cell.
    pub fn vectors<'a>(name: &'static str, values: impl IntoIterator<Item = &'a DVec3>) -> Self {
        let values = values.into_iter().flat_map(|v| v.to_array()).collect();
        Self::new(name, 3, Values::Float64(values))
    }

    /// Any array.
    pub fn new(name: impl Into<Cow<'static, str>>, components: usize, values: Values) -> Self {
        Self {
            name: name.into(),
            components,
            values,
        }
    }
}

/// The cells of a piece.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Cells {
    /// One vertex cell for every point.
    Vertices,
    /// Triangles that use three points each, in order.
    Triangles,
    /// Lines through points that follow each other: the number of points of each.
    Lines(Vec<usize>),
}

/// What a `.vtp` file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct PolyData {
    /// Steps done.
    pub step: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Texts that belong to the file as a whole, by name.
    pub texts: Vec<(Cow<'static, str>, Vec<String>)>,
    /// Arrays that belong to the file as a whole.
    pub fields: Vec<Array>,
    /// The points [m].
    pub points: Vec<DVec3>,
    /// The cells.
    pub cells: Cells,
    /// Arrays of the points.
    pub point_data: Vec<Array>,
    /// Arrays of the cells.
    pub cell_data: Vec<Array>,
}

impl Cells {
    /// The element of the file that holds them.
    pub(crate) fn element(&self) -> &'static str {
        match self {
            Self::Vertices => "Verts",
            Self::Triangles => "Polys",
            Self::Lines(_) => "Lines",
        }
    }
}

impl PolyData {
    /// An array of the points, by its name.
    pub fn of_points(&self, name: &str) -> Option<&Array> {
        self.point_data.iter().find(|array| array.name == name)
    }

    /// An array of the cells, by its name.
    pub fn of_cells(&self, name: &str) -> Option<&Array> {
        self.cell_data.iter().find(|array| array.name == name)
    }

    /// Texts of the file, by their name.
    pub fn texts_of(&self, name: &str) -> &[String] {
        let found = self.texts.iter().find(|texts| texts.0 == name);
        found.map_or(&[], |texts| &texts.1)
    }

    /// The bytes of the file.
    pub fn encode(&self) -> io::Result<Vec<u8>> {
        NewPolyData::from(self).encode()
    }
}
