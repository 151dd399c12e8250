//! The `.vtp` file of VTK: points with cells and named arrays, as XML with compressed binary data behind it.
//!
//! Format: "VTK XML file formats" (version 1.0, `header_type="UInt64"`, zlib blocks, appended raw data).

use flate2::Compression;
use flate2::write::ZlibEncoder;
use glam::DVec3;
use std::borrow::Cow;
use std::fmt::Write as _;
use std::io::{self, Write as _};

/// Length of an uncompressed block [bytes], a multiple of the size of every type.
pub(crate) const BLOCK: usize = 1 << 18;
/// How binary data is told, in the head of every file.
pub(crate) const ENCODING: &str =
    "byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"";
/// What stands between the head and the data.
pub(crate) const START_OF_DATA: &str = "<AppendedData encoding=\"raw\">\n_";
/// What stands behind the data.
pub(crate) const END_OF_DATA: &str = "\n</AppendedData>\n</VTKFile>\n";
/// The fastest level: higher ones cost much time and win little on the digits of `f64`.
const LEVEL: u32 = 1;

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
    /// Name of the type in the file.
    fn kind(&self) -> &'static str {
        match self {
            Self::Float64(_) => "Float64",
            Self::Int32(_) => "Int32",
            Self::UInt32(_) => "UInt32",
            Self::Int64(_) => "Int64",
        }
    }

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

    fn bytes(&self) -> Vec<u8> {
        match self {
            Self::Float64(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
            Self::Int32(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
            Self::UInt32(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
            Self::Int64(v) => v.iter().flat_map(|x| x.to_le_bytes()).collect(),
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
        let mut file = Writer::default();
        let points = self.points.len();
        let equal = |corners: usize| (1..=points / corners).map(|k| (k * corners) as i64).collect();
        let element = self.cells.element();
        let offsets: Vec<i64> = match &self.cells {
            Cells::Vertices => equal(1),
            Cells::Triangles => equal(3),
            Cells::Lines(lengths) => {
                let mut end = 0;
                let mut next = |n: &usize| {
                    end += *n as i64;
                    end
                };
                lengths.iter().map(&mut next).collect()
            }
        };
        let [vertices, lines, triangles] =
            ["Verts", "Lines", "Polys"].map(|name| if name == element { offsets.len() } else { 0 });
        file.line(&format!(
            "<VTKFile type=\"PolyData\" version=\"1.0\" {ENCODING}>\n<PolyData>"
        ));
        field_data(&mut file, (self.step, self.time), &self.texts, &self.fields);
        file.line(&format!(
            "<Piece NumberOfPoints=\"{points}\" NumberOfVerts=\"{vertices}\" NumberOfLines=\"{lines}\" \
             NumberOfStrips=\"0\" NumberOfPolys=\"{triangles}\">"
        ));
        file.arrays("PointData", &self.point_data)?;
        file.arrays("CellData", &self.cell_data)?;
        file.arrays("Points", &[Array::vectors("Points", &self.points)])?;
        let connectivity = (0..points as i64).collect();
        let topology = [
            Array::new("connectivity", 1, Values::Int64(connectivity)),
            Array::new("offsets", 1, Values::Int64(offsets)),
        ];
        file.arrays(element, &topology)?;
        file.line("</Piece>\n</PolyData>");
        Ok(file.finish())
    }
}

/// Time, step, arrays and texts, readable in the head of the file.
pub(super) fn field_data(
    file: &mut Writer,
    (step, time): (u64, f64),
    texts: &[(Cow<'static, str>, Vec<String>)],
    fields: &[Array],
) {
    file.line("<FieldData>");
    file.line(&format!(
        "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{:?}</DataArray>",
        time
    ));
    file.line(&format!(
        "<DataArray type=\"Int64\" Name=\"step\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray>",
        step
    ));
    for array in fields {
        let numbers: Vec<String> = (0..array.values.len())
            .filter_map(|k| array.values.number(k))
            .map(|number| match array.values {
                Values::Float64(_) => format!("{number:?}"),
                _ => number.to_string(),
            })
            .collect();
        file.line(&format!(
            "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">{}</DataArray>",
            array.values.kind(),
            array.name,
            array.components,
            numbers.len() / array.components.max(1),
            numbers.join(" ")
        ));
    }
    for (name, texts) in texts {
        file.line(&format!(
            "<DataArray type=\"String\" Name=\"{name}\" NumberOfTuples=\"{}\" format=\"ascii\">",
            texts.len()
        ));
        // Texts are written as the codes of their bytes, each text closed by a zero.
        for text in texts {
            let codes: Vec<String> = text.bytes().chain([0]).map(|byte| byte.to_string()).collect();
            file.line(&codes.join(" "));
        }
        file.line("</DataArray>");
    }
    file.line("</FieldData>");
}

/// The XML and, to be put behind it, the binary data.
#[derive(Default)]
pub(super) struct Writer {
    xml: String,
    data: Vec<u8>,
}

impl Writer {
    pub fn line(&mut self, text: &str) {
        self.xml.push_str(text);
        self.xml.push('\n');
    }

    pub fn arrays(&mut self, element: &str, arrays: &[Array]) -> io::Result<()> {
        self.line(&format!("<{element}>"));
        for array in arrays {
            let offset = self.data.len();
            // Writing to a String cannot fail.
            let _ = writeln!(
                self.xml,
                "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{offset}\"/>",
                array.values.kind(),
                array.name,
                array.components,
            );
            append_compressed(&mut self.data, &array.values.bytes())?;
        }
        self.line(&format!("</{element}>"));
        Ok(())
    }

    pub fn finish(self) -> Vec<u8> {
        let mut bytes = self.xml.into_bytes();
        bytes.extend_from_slice(START_OF_DATA.as_bytes());
        bytes.extend_from_slice(&self.data);
        bytes.extend_from_slice(END_OF_DATA.as_bytes());
        bytes
    }
}

/// Appends `[blocks][block length][length of the last block if it is shorter][compressed lengths][blocks]`.
fn append_compressed(out: &mut Vec<u8>, bytes: &[u8]) -> io::Result<()> {
    let blocks: Vec<&[u8]> = bytes.chunks(BLOCK).collect();
    let mut compressed = Vec::with_capacity(blocks.len());
    for block in &blocks {
        let mut encoder = ZlibEncoder::new(Vec::new(), Compression::new(LEVEL));
        encoder.write_all(block)?;
        compressed.push(encoder.finish()?);
    }
    let head = [blocks.len(), BLOCK, bytes.len() % BLOCK];
    for number in head.into_iter().chain(compressed.iter().map(Vec::len)) {
        out.extend_from_slice(&(number as u64).to_le_bytes());
    }
    for block in &compressed {
        out.extend_from_slice(block);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::read::ZlibDecoder;
    use std::io::Read;

    fn number(bytes: &[u8], k: usize) -> usize {
        u64::from_le_bytes(bytes[8 * k..8 * k + 8].try_into().unwrap()) as usize
    }

    /// Reads an array as VTK does: a last block of length 0 means that the last block is a full one.
    fn decode(bytes: &[u8]) -> Vec<u8> {
        let (blocks, length, last) = (number(bytes, 0), number(bytes, 1), number(bytes, 2));
        let mut at = 8 * (3 + blocks);
        let mut out = Vec::new();
        for k in 0..blocks {
            let size = number(bytes, 3 + k);
            let mut block = Vec::new();
            ZlibDecoder::new(&bytes[at..at + size]).read_to_end(&mut block).unwrap();
            let expected = if k + 1 == blocks && last > 0 { last } else { length };
            assert_eq!(block.len(), expected);
            out.extend_from_slice(&block);
            at += size;
        }
        assert_eq!(at, bytes.len());
        out
    }

    #[test]
    fn blocks_decode_at_every_edge_of_the_block_length() {
        for length in [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK, 2 * BLOCK + 8] {
            let bytes: Vec<u8> = (0..length).map(|k| (k % 251) as u8).collect();
            let mut out = Vec::new();
            append_compressed(&mut out, &bytes).unwrap();
            assert!(decode(&out) == bytes, "{length}");
        }
    }
}
