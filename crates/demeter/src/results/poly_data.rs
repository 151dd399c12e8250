//! Reads the `.vtp` files that `output::vtp` writes: the head first, then only those arrays that are asked for.

use super::error::ResultsError;
use super::poly_head::{ArrayPlace, Head};
use crate::output::vtk_file::{BLOCK, START_OF_DATA, ends_whole};
use crate::output::vtp::{Array, Cells, PolyData, Values};
use flate2::read::ZlibDecoder;
use glam::DVec3;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};

/// Largest head that is read [bytes].
const MAX_HEAD: usize = 16 << 20;
/// Most numbers of one array.
const MAX_NUMBERS: usize = 1 << 30;
/// Sections whose arrays have a value for each row.
const OF_ROWS: [&str; 2] = ["PointData", "CellData"];
/// Bytes that are read in one piece to find the end of the head.
const PIECE: u64 = 1 << 14;

/// A table of a frame, open: its arrays are read one by one.
#[derive(Debug)]
pub struct TableFile {
    path: PathBuf,
    file: File,
    length: u64,
    /// Where the data begins [bytes].
    data: u64,
    head: Head,
}

impl TableFile {
    /// Reads the head of a file.
    pub(super) fn open(path: &Path, mut file: File) -> Result<Self, ResultsError> {
        let io = || ResultsError::io(path);
        let length = file.metadata().map_err(io())?.len();
        let text = read_head(&mut file).map_err(io())?;
        let Some(text) = text else {
            return Err(ResultsError::damaged(
                path,
                "it ends, or goes on, without the place where its data begin",
            ));
        };
        if !ends_whole(&mut file).map_err(io())? {
            return Err(ResultsError::damaged(path, "its end is missing"));
        }
        let data = text.len() as u64;
        let head = String::from_utf8(text)
            .map_err(|_| "its head is not UTF-8 text".to_string())
            .and_then(|text| Head::parse(&text));
        let head = head.map_err(|problem| ResultsError::damaged(path, problem))?;
        Ok(Self {
            path: path.to_owned(),
            file,
            length,
            data,
            head,
        })
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Steps done.
    pub fn step(&self) -> u64 {
        self.head.step
    }

    /// Simulated time [s].
    pub fn time(&self) -> f64 {
        self.head.time
    }

    /// Number of rows: grains, contacts, or triangles of walls.
    pub fn rows(&self) -> usize {
        self.head.cells
    }

    /// Texts of the file, by their name.
    pub fn texts(&self, name: &str) -> &[String] {
        let found = self.head.texts.iter().find(|texts| texts.0 == name);
        found.map_or(&[], |texts| &texts.1)
    }

    /// An array of the file as a whole, by its name.
    pub fn field(&self, name: &str) -> Option<&Array> {
        self.head.fields.iter().find(|array| array.name == name)
    }

    /// Names of the arrays of the points and cells.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let of_rows = |array: &&ArrayPlace| OF_ROWS.contains(&array.section.as_str());
        self.head.arrays.iter().filter(of_rows).map(|array| array.name.as_str())
    }

    /// The points [m].
    pub fn points(&mut self) -> Result<Vec<DVec3>, ResultsError> {
        let place = self.place("Points", "Points")?;
        let array = self.read(&place)?;
        match &array.values {
            Values::Float64(numbers) if array.components == 3 => {
                Ok(numbers.as_chunks().0.iter().map(|p| DVec3::from_array(*p)).collect())
            }
            _ => Err(ResultsError::damaged(
                &self.path,
                "its points are not of three 64-bit numbers",
            )),
        }
    }

    /// An array of the points or cells, by its name.
    pub fn array(&mut self, name: &str) -> Result<Array, ResultsError> {
        let place = self.of_rows(name)?;
        self.read(&place)
    }

    /// An array of 64-bit numbers with so many components, by its name.
    pub fn floats(&mut self, name: &str, components: usize) -> Result<Vec<f64>, ResultsError> {
        let array = self.array(name)?;
        match array.values {
            Values::Float64(numbers) if array.components == components => Ok(numbers),
            _ => Err(self.other_type(name, "64-bit numbers", components)),
        }
    }

    /// An array of ids, indices or counts, by its name.
    pub fn counts(&mut self, name: &str) -> Result<Vec<u32>, ResultsError> {
        let array = self.array(name)?;
        match array.values {
            Values::UInt32(numbers) if array.components == 1 => Ok(numbers),
            _ => Err(self.other_type(name, "32-bit integers without sign", 1)),
        }
    }

    /// An array of indices that may be -1, by its name.
    pub fn integers(&mut self, name: &str) -> Result<Vec<i32>, ResultsError> {
        let array = self.array(name)?;
        match array.values {
            Values::Int32(numbers) if array.components == 1 => Ok(numbers),
            _ => Err(self.other_type(name, "32-bit integers", 1)),
        }
    }

    /// Some rows of an array of the points or cells, by its name: only the blocks that hold them are read. Rows behind the
    /// last one are left out.
    pub fn rows_of(&mut self, name: &str, rows: Range<usize>) -> Result<Array, ResultsError> {
        let place = self.of_rows(name)?;
        self.read_rows(&place, rows)
    }

    /// Single rows of an array of the points or cells, by its name, which ascend: of the blocks that hold them each is read
    /// once. Rows behind the last one are left out.
    pub fn rows_at(&mut self, name: &str, rows: &[usize]) -> Result<Array, ResultsError> {
        let place = self.of_rows(name)?;
        let width = Values::size_of(&place.kind)
            .unwrap_or(1)
            .saturating_mul(place.components);
        let block = |row: &usize| row.saturating_mul(width) / BLOCK;
        let mut bytes = Vec::new();
        for together in rows.chunk_by(|a, b| a < b && block(a) == block(b)) {
            let (first, last) = (together[0], together[together.len() - 1]);
            let span = self.read_bytes(&place, first..last.saturating_add(1))?;
            let row = |row: &usize| {
                let start = (row - first).saturating_mul(width);
                span.get(start..start.saturating_add(width))
            };
            together
                .iter()
                .filter_map(row)
                .for_each(|row| bytes.extend_from_slice(row));
        }
        self.numbers(&place, &bytes)
    }

    /// Places [m] of some points, as an array with three components.
    pub fn points_of(&mut self, rows: Range<usize>) -> Result<Array, ResultsError> {
        let place = self.place("Points", "Points")?;
        self.read_rows(&place, rows)
    }

    /// Everything in the file.
    pub fn read_all(&mut self) -> Result<PolyData, ResultsError> {
        let section = |file: &mut Self, section: &str| -> Result<Vec<Array>, ResultsError> {
            let places: Vec<ArrayPlace> = (file.head.arrays.iter())
                .filter(|a| a.section == section)
                .cloned()
                .collect();
            places.iter().map(|place| file.read(place)).collect()
        };
        Ok(PolyData {
            step: self.head.step,
            time: self.head.time,
            texts: self
                .head
                .texts
                .iter()
                .map(|(name, texts)| (name.clone().into(), texts.clone()))
                .collect(),
            fields: self.head.fields.clone(),
            points: self.points()?,
            cells: self.cells()?,
            point_data: section(self, "PointData")?,
            cell_data: section(self, "CellData")?,
        })
    }

    fn cells(&mut self) -> Result<Cells, ResultsError> {
        let (points, cells) = (self.head.points, self.head.cells);
        let odd = |file: &Self| {
            ResultsError::damaged(&file.path, format!("its {cells} cells do not fit its {points} points"))
        };
        match self.head.element.as_str() {
            "Verts" if cells == points => Ok(Cells::Vertices),
            "Polys" if cells.checked_mul(3) == Some(points) => Ok(Cells::Triangles),
            "Lines" => {
                let place = self.place("Lines", "offsets")?;
                let Values::Int64(ends) = self.read(&place)?.values else {
                    return Err(odd(self));
                };
                let mut start = 0;
                let mut lengths = Vec::with_capacity(ends.len());
                for end in ends {
                    let length = end.checked_sub(start).and_then(|length| usize::try_from(length).ok());
                    lengths.push(length.ok_or_else(|| odd(self))?);
                    start = end;
                }
                if usize::try_from(start).ok() != Some(points) {
                    return Err(odd(self));
                }
                Ok(Cells::Lines(lengths))
            }
            _ => Err(odd(self)),
        }
    }

    fn find(&self, section: &str, name: &str) -> Option<&ArrayPlace> {
        self.head
            .arrays
            .iter()
            .find(|array| array.section == section && array.name == name)
    }

    fn of_rows(&self, name: &str) -> Result<ArrayPlace, ResultsError> {
        let found = OF_ROWS.iter().find_map(|section| self.find(section, name));
        found.cloned().ok_or_else(|| self.missing(name))
    }

    fn place(&self, section: &str, name: &str) -> Result<ArrayPlace, ResultsError> {
        self.find(section, name).cloned().ok_or_else(|| self.missing(name))
    }

    fn missing(&self, name: &str) -> ResultsError {
        ResultsError::NoArray {
            path: self.path.clone(),
            name: name.to_string(),
            known: self.names().map(|name| format!("`{name}`")).collect(),
        }
    }

    fn other_type(&self, name: &str, expected: &str, components: usize) -> ResultsError {
        let problem = format!("its array `{name}` does not hold {expected}, {components} for each row");
        ResultsError::damaged(&self.path, problem)
    }

    fn read(&mut self, place: &ArrayPlace) -> Result<Array, ResultsError> {
        self.read_rows(place, 0..place.tuples)
    }

    fn read_rows(&mut self, place: &ArrayPlace, rows: Range<usize>) -> Result<Array, ResultsError> {
        let bytes = self.read_bytes(place, rows)?;
        self.numbers(place, &bytes)
    }

    fn numbers(&self, place: &ArrayPlace, bytes: &[u8]) -> Result<Array, ResultsError> {
        let values = Values::from_bytes(&place.kind, bytes);
        let values = values.ok_or_else(|| self.damaged(place, &format!("unknown type `{}`", place.kind)))?;
        Ok(Array::new(place.name.clone(), place.components, values))
    }

    fn damaged(&self, place: &ArrayPlace, problem: &str) -> ResultsError {
        ResultsError::damaged(&self.path, format!("array `{}`: {problem}", place.name))
    }

    fn read_bytes(&mut self, place: &ArrayPlace, rows: Range<usize>) -> Result<Vec<u8>, ResultsError> {
        let start = self.data.checked_add(place.offset).filter(|start| *start < self.length);
        let start = start.ok_or_else(|| self.damaged(place, "it begins behind the end of the file"))?;
        self.file
            .seek(SeekFrom::Start(start))
            .map_err(ResultsError::io(&self.path))?;
        match read_blocks(&mut self.file, place, self.length - start, rows) {
            Ok(bytes) => Ok(bytes),
            Err(ReadFault::Io(error)) => Err(ResultsError::io(&self.path)(error)),
            Err(ReadFault::Damaged(problem)) => Err(self.damaged(place, &problem)),
        }
    }
}

/// Why the blocks of an array cannot be read.
enum ReadFault {
    Io(io::Error),
    Damaged(String),
}

impl From<io::Error> for ReadFault {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::UnexpectedEof => Self::Damaged("the file ends within it".to_string()),
            io::ErrorKind::InvalidInput | io::ErrorKind::InvalidData => Self::Damaged(error.to_string()),
            _ => Self::Io(error),
        }
    }
}

/// Reads those compressed blocks of an array that hold some rows; `left` are the bytes from here to the end of the file.
fn read_blocks(file: &mut File, place: &ArrayPlace, left: u64, rows: Range<usize>) -> Result<Vec<u8>, ReadFault> {
    let fault = |problem: &str| ReadFault::Damaged(problem.to_string());
    let size = Values::size_of(&place.kind);
    let size = size.ok_or_else(|| ReadFault::Damaged(format!("unknown type `{}`", place.kind)))?;
    let numbers = place.tuples.checked_mul(place.components).filter(|n| *n <= MAX_NUMBERS);
    let expected = numbers.map(|n| n * size).ok_or_else(|| fault("it is too long"))?;
    let mut lengths = LengthReader { file, left };
    let [blocks, block, last] = lengths.next()?;
    let told = [expected.div_ceil(BLOCK), BLOCK, expected % BLOCK].map(|n| n as u64);
    if [blocks, block, last] != told {
        return Err(fault("its length is not that of its points or cells"));
    }
    let mut compressed = Vec::new();
    for _ in 0..blocks {
        let [length] = lengths.next()?;
        compressed.push(length);
    }
    let mut left = lengths.left;
    let row = place.components.saturating_mul(size);
    let wanted = rows.start.min(place.tuples) * row..rows.end.min(place.tuples) * row;
    let first = wanted.start / BLOCK;
    let mut out = Vec::new();
    for (k, length) in compressed.into_iter().enumerate() {
        left = left
            .checked_sub(length)
            .ok_or_else(|| fault("the file ends within it"))?;
        if k < first {
            // lengths of blocks that were checked against the file fit
            file.seek_relative(i64::try_from(length).unwrap_or(i64::MAX))?;
        } else if k * BLOCK < wanted.end {
            read_block(file, length, BLOCK.min(expected - k * BLOCK), &mut out)?;
        }
    }
    out.drain(..(wanted.start - first * BLOCK).min(out.len()));
    out.truncate(wanted.len());
    Ok(out)
}

/// Reads a block of so many bytes in the file, which become `expected` ones.
fn read_block(file: &mut File, length: u64, expected: usize, out: &mut Vec<u8>) -> Result<(), ReadFault> {
    let before = out.len();
    let mut decoder = ZlibDecoder::new(file.take(length));
    // one byte more than there may be tells a block that is too long
    decoder.by_ref().take(expected as u64 + 1).read_to_end(out)?;
    if out.len() - before != expected {
        return Err(ReadFault::Damaged(
            "a block has another length than it should".to_string(),
        ));
    }
    if decoder.into_inner().limit() > 0 {
        return Err(ReadFault::Damaged("a block ends before its place does".to_string()));
    }
    Ok(())
}

/// Reads lengths of 8 bytes while there are bytes left.
struct LengthReader<'f> {
    file: &'f mut File,
    left: u64,
}

impl LengthReader<'_> {
    fn next<const N: usize>(&mut self) -> Result<[u64; N], ReadFault> {
        let left = self.left.checked_sub(8 * N as u64);
        self.left = left.ok_or_else(|| ReadFault::Damaged("the file ends within it".to_string()))?;
        let mut numbers = [0; N];
        for number in &mut numbers {
            let mut bytes = [0; 8];
            self.file.read_exact(&mut bytes)?;
            *number = u64::from_le_bytes(bytes);
        }
        Ok(numbers)
    }
}

/// Reads up to where the data begins; nothing when that does not come.
fn read_head(file: &mut File) -> io::Result<Option<Vec<u8>>> {
    let mark = START_OF_DATA.as_bytes();
    let mut head = Vec::new();
    while head.len() < MAX_HEAD {
        let looked_at = head.len().saturating_sub(mark.len());
        if file.by_ref().take(PIECE).read_to_end(&mut head)? == 0 {
            return Ok(None);
        }
        if let Some(at) = head[looked_at..].windows(mark.len()).position(|piece| piece == mark) {
            head.truncate(looked_at + at + mark.len());
            return Ok(Some(head));
        }
    }
    Ok(None)
}
