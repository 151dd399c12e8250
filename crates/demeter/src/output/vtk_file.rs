//! Files of VTK as they are written: XML, and behind it arrays as compressed binary data.
//!
//! Arrays are made, compressed and written one after the other, some blocks at a time, so that a frame of many contacts needs little
//! memory.
//!
//! Format: "VTK XML file formats" (version 1.0, `header_type="UInt64"`, zlib blocks, appended raw data).

use super::vtp::{Array, Cells, PolyData, Values};
use flate2::Compression;
use flate2::write::ZlibEncoder;
use glam::DVec3;
use rayon::prelude::*;
use std::borrow::Cow;
use std::io::{self, Cursor, Read, Seek, SeekFrom, Write};

/// Length of an uncompressed block [bytes], a multiple of the size of every type.
pub(crate) const BLOCK: usize = 1 << 18;
/// Bytes that are compressed at once, by all threads: two blocks for each.
fn at_once() -> usize {
    2 * BLOCK * rayon::current_num_threads()
}

/// How binary data is told, in the head of every file.
pub(crate) const ENCODING: &str =
    "byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"";
/// What stands between the head and the data.
pub(crate) const START_OF_DATA: &str = "<AppendedData encoding=\"raw\">\n_";
/// What stands behind the data.
const END_OF_DATA: &str = "\n</AppendedData>\n</VTKFile>\n";
/// The fastest level: higher ones cost much time and win little on the digits of `f64`.
const LEVEL: u32 = 1;
/// What tells whether a block is worth compressing [bytes].
const SAMPLE: usize = 4096;
/// A sample that gets no shorter than this tells that it is not: digits of `f64` take three quarters of the time of a frame and lose a
/// tenth of their length.
const WORTHWHILE: f64 = 0.85;

/// A named array that is made when it is written.
pub(crate) struct NewArray<'a> {
    name: &'a str,
    /// Numbers per point or cell.
    components: usize,
    numbers: Numbers<'a>,
}

/// Numbers, those of a point or cell behind each other.
enum Numbers<'a> {
    Float64(Box<dyn Iterator<Item = f64> + 'a>),
    Int32(Box<dyn Iterator<Item = i32> + 'a>),
    UInt32(Box<dyn Iterator<Item = u32> + 'a>),
    Int64(Box<dyn Iterator<Item = i64> + 'a>),
}

impl<'a> NewArray<'a> {
    /// One `f64` per point or cell.
    pub fn scalars(name: &'a str, values: impl Iterator<Item = f64> + 'a) -> Self {
        Self::new(name, 1, Numbers::Float64(Box::new(values)))
    }

    /// One vector per point or cell.
    pub fn vectors(name: &'a str, values: impl Iterator<Item = DVec3> + 'a) -> Self {
        Self::rows(name, values.map(|vector| vector.to_array()))
    }

    /// So many `f64` per point or cell.
    pub fn rows<const N: usize>(name: &'a str, values: impl Iterator<Item = [f64; N]> + 'a) -> Self {
        Self::new(name, N, Numbers::Float64(Box::new(values.flatten())))
    }

    /// One number per point or cell that may be negative.
    pub fn integers(name: &'a str, values: impl Iterator<Item = i32> + 'a) -> Self {
        Self::new(name, 1, Numbers::Int32(Box::new(values)))
    }

    /// One number per point or cell that is not negative.
    pub fn counts(name: &'a str, values: impl Iterator<Item = u32> + 'a) -> Self {
        Self::new(name, 1, Numbers::UInt32(Box::new(values)))
    }

    /// One long number per point or cell.
    fn places(name: &'a str, values: impl Iterator<Item = i64> + 'a) -> Self {
        Self::new(name, 1, Numbers::Int64(Box::new(values)))
    }

    fn new(name: &'a str, components: usize, numbers: Numbers<'a>) -> Self {
        Self {
            name,
            components,
            numbers,
        }
    }

    /// Name of the type in the file.
    fn kind(&self) -> &'static str {
        match self.numbers {
            Numbers::Float64(_) => "Float64",
            Numbers::Int32(_) => "Int32",
            Numbers::UInt32(_) => "UInt32",
            Numbers::Int64(_) => "Int64",
        }
    }

    /// Makes the numbers for nobody here.
    fn pass(self) {
        match self.numbers {
            Numbers::Float64(numbers) => numbers.for_each(drop),
            Numbers::Int32(numbers) => numbers.for_each(drop),
            Numbers::UInt32(numbers) => numbers.for_each(drop),
            Numbers::Int64(numbers) => numbers.for_each(drop),
        }
    }

    /// Writes the numbers of so many points or cells; answers with the length [bytes].
    fn write(self, out: &mut (impl Write + Seek), elements: usize) -> io::Result<u64> {
        let count = self.components * elements;
        match self.numbers {
            Numbers::Float64(numbers) => write_compressed(out, count, numbers.map(f64::to_le_bytes)),
            Numbers::Int32(numbers) => write_compressed(out, count, numbers.map(i32::to_le_bytes)),
            Numbers::UInt32(numbers) => write_compressed(out, count, numbers.map(u32::to_le_bytes)),
            Numbers::Int64(numbers) => write_compressed(out, count, numbers.map(i64::to_le_bytes)),
        }
    }
}

impl<'a> From<&'a Array> for NewArray<'a> {
    fn from(array: &'a Array) -> Self {
        let numbers = match &array.values {
            Values::Float64(values) => Numbers::Float64(Box::new(values.iter().copied())),
            Values::Int32(values) => Numbers::Int32(Box::new(values.iter().copied())),
            Values::UInt32(values) => Numbers::UInt32(Box::new(values.iter().copied())),
            Values::Int64(values) => Numbers::Int64(Box::new(values.iter().copied())),
        };
        Self::new(&array.name, array.components, numbers)
    }
}

/// A `.vtp` file that is to be written.
pub(crate) struct NewPolyData<'a> {
    /// Steps done.
    pub step: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Texts that belong to the file as a whole, by name.
    pub texts: Vec<(Cow<'static, str>, Vec<String>)>,
    /// Arrays that belong to the file as a whole.
    pub fields: Vec<Array>,
    /// Number of points.
    pub count: usize,
    /// The points [m].
    pub points: Box<dyn Iterator<Item = DVec3> + 'a>,
    /// The cells.
    pub cells: Cells,
    /// Arrays of the points.
    pub point_data: Vec<NewArray<'a>>,
    /// Arrays of the cells.
    pub cell_data: Vec<NewArray<'a>>,
}

impl<'a> From<&'a PolyData> for NewPolyData<'a> {
    fn from(data: &'a PolyData) -> Self {
        Self {
            step: data.step,
            time: data.time,
            texts: data.texts.clone(),
            fields: data.fields.clone(),
            count: data.points.len(),
            points: Box::new(data.points.iter().copied()),
            cells: data.cells.clone(),
            point_data: data.point_data.iter().map(NewArray::from).collect(),
            cell_data: data.cell_data.iter().map(NewArray::from).collect(),
        }
    }
}

impl NewPolyData<'_> {
    /// The bytes of the file.
    pub fn encode(self) -> io::Result<Vec<u8>> {
        in_memory(|out| self.write(out))
    }

    /// Makes what [`NewPolyData::write`] writes, in the same order, where it is another process that writes.
    pub fn pass(self) {
        let data = self.point_data.into_iter().chain(self.cell_data);
        data.for_each(NewArray::pass);
        self.points.for_each(drop);
    }

    /// Writes the file.
    pub fn write(self, out: &mut (impl Write + Seek)) -> io::Result<()> {
        let mut file = Writer::default();
        let points = self.count;
        let element = self.cells.element();
        let (count, offsets): (usize, Box<dyn Iterator<Item = usize>>) = match self.cells {
            Cells::Vertices => (points, Box::new(1..=points)),
            Cells::Triangles => (points / 3, Box::new((1..=points / 3).map(|k| 3 * k))),
            Cells::Lines(lengths) => {
                let next = |end: &mut usize, n: usize| {
                    *end += n;
                    Some(*end)
                };
                (lengths.len(), Box::new(lengths.into_iter().scan(0, next)))
            }
        };
        let [vertices, lines, triangles] =
            ["Verts", "Lines", "Polys"].map(|name| if name == element { count } else { 0 });
        file.line(&format!(
            "<VTKFile type=\"PolyData\" version=\"1.0\" {ENCODING}>\n<PolyData>"
        ));
        file.field_data((self.step, self.time), &self.texts, &self.fields);
        file.line(&format!(
            "<Piece NumberOfPoints=\"{points}\" NumberOfVerts=\"{vertices}\" NumberOfLines=\"{lines}\" \
             NumberOfStrips=\"0\" NumberOfPolys=\"{triangles}\">"
        ));
        file.arrays("PointData", self.point_data.into_iter().map(|array| (points, array)));
        file.arrays("CellData", self.cell_data.into_iter().map(|array| (count, array)));
        file.arrays("Points", [(points, NewArray::vectors("Points", self.points))]);
        let topology = [
            (points, NewArray::places("connectivity", 0..points as i64)),
            (count, NewArray::places("offsets", offsets.map(|end| end as i64))),
        ];
        file.arrays(element, topology);
        file.line("</Piece>\n</PolyData>");
        file.finish(out)
    }
}

/// What is written, as bytes in memory.
pub(super) fn in_memory(write: impl FnOnce(&mut Cursor<Vec<u8>>) -> io::Result<()>) -> io::Result<Vec<u8>> {
    let mut out = Cursor::default();
    write(&mut out)?;
    Ok(out.into_inner())
}

/// The XML, and the arrays that are to be put behind it.
#[derive(Default)]
pub(super) struct Writer<'a> {
    xml: String,
    /// With the places in the XML where it is told where they begin, and of how many points or cells they are.
    arrays: Vec<(usize, usize, NewArray<'a>)>,
}

impl<'a> Writer<'a> {
    pub fn line(&mut self, text: &str) {
        self.xml.push_str(text);
        self.xml.push('\n');
    }

    /// Arrays of so many points or cells.
    pub fn arrays(&mut self, element: &str, arrays: impl IntoIterator<Item = (usize, NewArray<'a>)>) {
        self.line(&format!("<{element}>"));
        for (elements, array) in arrays {
            self.xml.push_str(&format!(
                "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" ",
                array.kind(),
                array.name,
                array.components,
            ));
            self.arrays.push((self.xml.len(), elements, array));
            self.xml.push_str(&offset(0));
            self.line("/>");
        }
        self.line(&format!("</{element}>"));
    }

    /// Time, step, arrays and texts, readable in the head of the file.
    pub fn field_data(
        &mut self,
        (step, time): (u64, f64),
        texts: &[(Cow<'static, str>, Vec<String>)],
        fields: &[Array],
    ) {
        self.line("<FieldData>");
        self.line(&format!(
            "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{:?}</DataArray>",
            time
        ));
        self.line(&format!(
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
            self.line(&format!(
                "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" NumberOfTuples=\"{}\" format=\"ascii\">{}</DataArray>",
                NewArray::from(array).kind(),
                array.name,
                array.components,
                numbers.len() / array.components.max(1),
                numbers.join(" ")
            ));
        }
        for (name, texts) in texts {
            self.line(&format!(
                "<DataArray type=\"String\" Name=\"{name}\" NumberOfTuples=\"{}\" format=\"ascii\">",
                texts.len()
            ));
            // Texts are written as the codes of their bytes, each text closed by a zero.
            for text in texts {
                let codes: Vec<String> = text.bytes().chain([0]).map(|byte| byte.to_string()).collect();
                self.line(&codes.join(" "));
            }
            self.line("</DataArray>");
        }
        self.line("</FieldData>");
    }

    /// Writes the file: the XML, which does not tell yet where arrays begin, the arrays, and the XML again.
    pub fn finish(self, out: &mut (impl Write + Seek)) -> io::Result<()> {
        let mut xml = self.xml;
        out.write_all(xml.as_bytes())?;
        out.write_all(START_OF_DATA.as_bytes())?;
        let mut begin = 0;
        for (place, elements, array) in self.arrays {
            let told = offset(begin);
            xml.replace_range(place..place + told.len(), &told);
            begin += array.write(out, elements)?;
        }
        out.write_all(END_OF_DATA.as_bytes())?;
        out.rewind()?;
        out.write_all(xml.as_bytes())
    }
}

/// Whether a file has the end that is written last.
pub(crate) fn ends_whole(file: &mut (impl Read + Seek)) -> io::Result<bool> {
    let mark = END_OF_DATA.as_bytes();
    let length = file.seek(SeekFrom::End(0))?;
    file.seek(SeekFrom::Start(length.saturating_sub(mark.len() as u64)))?;
    let mut end = Vec::new();
    file.take(mark.len() as u64).read_to_end(&mut end)?;
    Ok(end == mark)
}

/// Tells where an array begins, in a text of always the same length.
fn offset(begin: u64) -> String {
    const WIDTH: usize = "offset=\"\"".len() + 20;
    format!("{:<WIDTH$}", format!("offset=\"{begin}\""))
}

/// Writes `[blocks][block length][length of the last block if it is shorter][compressed lengths][blocks]`; answers with the length
/// [bytes]. The compressed lengths are not known before, so the head is written twice.
fn write_compressed<const N: usize>(
    out: &mut (impl Write + Seek),
    count: usize,
    mut numbers: impl Iterator<Item = [u8; N]>,
) -> io::Result<u64> {
    let length = count * N;
    let mut head = vec![length.div_ceil(BLOCK), BLOCK, length % BLOCK];
    let begin = out.stream_position()?;
    out.write_all(&vec![0; size_of::<u64>() * (head.len() + head[0])])?;
    let (mut some, mut left) = (Vec::<[u8; N]>::new(), count);
    while left > 0 {
        some.clear();
        some.extend(numbers.by_ref().take(left.min(at_once() / N)));
        if some.is_empty() {
            break;
        }
        left -= some.len();
        let compressed: io::Result<Vec<Vec<u8>>> = some.as_flattened().par_chunks(BLOCK).map(compress).collect();
        for block in compressed? {
            out.write_all(&block)?;
            head.push(block.len());
        }
    }
    // the others of a run wait until all they tell has been heard
    let more = numbers.count();
    if left > 0 || more > 0 {
        let found = count - left + more;
        return Err(io::Error::other(format!(
            "an array has {found} numbers in place of {count}"
        )));
    }
    let end = out.stream_position()?;
    out.seek(SeekFrom::Start(begin))?;
    let head: Vec<u8> = head
        .into_iter()
        .flat_map(|number| (number as u64).to_le_bytes())
        .collect();
    out.write_all(&head)?;
    out.seek(SeekFrom::Start(end))?;
    Ok(end - begin)
}

/// A block as zlib has it, its bytes as they are where their like is hardly ever shorter.
fn compress(block: &[u8]) -> io::Result<Vec<u8>> {
    match block.first_chunk::<SAMPLE>() {
        Some(sample) if deflate(sample)?.len() as f64 > WORTHWHILE * SAMPLE as f64 => Ok(store(block)),
        _ => deflate(block),
    }
}

fn deflate(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::new(LEVEL));
    encoder.write_all(bytes)?;
    encoder.finish()
}

/// A stream of zlib (RFC 1950) of stored parts (RFC 1951, 3.2.4), many times faster than a compressor that is told to do nothing.
fn store(bytes: &[u8]) -> Vec<u8> {
    const HEAD: [u8; 2] = [0x78, 0x01];
    let mut parts = bytes.chunks(u16::MAX.into()).peekable();
    let mut stream = HEAD.to_vec();
    stream.reserve_exact(bytes.len() + 5 * parts.len() + 4);
    while let Some(part) = parts.next() {
        let length = part.len() as u16;
        stream.push(parts.peek().is_none().into());
        stream.extend(length.to_le_bytes());
        stream.extend((!length).to_le_bytes());
        stream.extend_from_slice(part);
    }
    stream.extend(simd_adler32::adler32(&bytes).to_be_bytes());
    stream
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
        for length in [
            0,
            1,
            BLOCK - 1,
            BLOCK,
            BLOCK + 1,
            2 * BLOCK,
            2 * BLOCK + 8,
            at_once() + 1,
        ] {
            check(length, |k| (k % 251) as u8);
        }
    }

    #[test]
    fn blocks_that_get_hardly_shorter_are_stored() {
        // 7 of 8 bits tell something
        let noise = |k: usize| {
            let mixed = (k as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            ((mixed ^ mixed >> 29).wrapping_mul(0xbf58_476d_1ce4_e5b9) >> 57) as u8
        };
        for length in [SAMPLE - 1, SAMPLE, 0xffff, 0x1_0000, 2 * 0xffff, BLOCK] {
            let stored = length + 8 * 4 + 2 + 4 + 5 * length.div_ceil(0xffff);
            assert_eq!(check(length, noise) == stored, length >= SAMPLE, "{length}");
        }
        assert!(check(BLOCK, |k| (k % 251) as u8) < BLOCK / 50);
    }

    /// Writes an array of bytes and reads it; answers with its length in the file.
    fn check(length: usize, byte: impl Fn(usize) -> u8) -> usize {
        let bytes: Vec<u8> = (0..length).map(byte).collect();
        let mut out = Cursor::default();
        let written = write_compressed(&mut out, length, bytes.iter().map(|byte| [*byte])).unwrap();
        let out: Vec<u8> = out.into_inner();
        assert_eq!(written, out.len() as u64);
        assert!(decode(&out) == bytes, "{length}");
        out.len()
    }

    #[test]
    fn an_array_of_another_length_than_its_file_tells_is_no_file() {
        for (count, found) in [(3, 2), (2, 3), (0, 1), (1, 0)] {
            let array = NewArray::counts("id", (0..found).map(|id| id as u32));
            let error = array
                .write(&mut Cursor::new(Vec::new()), count)
                .unwrap_err()
                .to_string();
            assert_eq!(error, format!("an array has {found} numbers in place of {count}"));
        }
    }
}
