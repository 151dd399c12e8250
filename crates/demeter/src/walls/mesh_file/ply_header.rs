//! Header of a PLY file: which elements follow, how many, and of which properties.

use super::text::{Line, Lines};
use super::{MeshFileError, MeshFormat};
use std::path::Path;

/// Most elements and most properties of one: no header that tells of a mesh has more.
const MOST: usize = 256;

/// Type of a number in a PLY file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn named(word: &[u8]) -> Option<Self> {
        Some(match word {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes that it takes in a binary file.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

#[derive(Clone, Debug)]
pub(super) struct Property {
    pub(super) name: String,
    /// Type of the count that comes before a list; `None` for a single number.
    pub(super) count: Option<Scalar>,
    pub(super) of: Scalar,
}

#[derive(Clone, Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

impl Element {
    /// Least bytes that an entry takes: in a text every number takes a digit and a blank.
    pub(super) fn least_size(&self, is_text: bool) -> usize {
        let size = |p: &Property| if is_text { 2 } else { p.count.unwrap_or(p.of).size() };
        self.properties.iter().map(size).sum()
    }
}

#[derive(Debug)]
pub(super) struct Header {
    pub(super) format: MeshFormat,
    pub(super) elements: Vec<Element>,
}

/// The header, and what follows it.
pub(super) fn parse<'a>(path: &'a Path, bytes: &'a [u8]) -> Result<(Header, Lines<'a>), MeshFileError> {
    let mut lines = Lines::new(path, bytes);
    let mut format = None;
    let mut elements: Vec<Element> = Vec::new();
    // the first line says `ply`
    lines.next();
    loop {
        let Some(line) = lines.next() else {
            return Err(MeshFileError::CutShort {
                path: path.to_owned(),
                expected: "end_header".to_string(),
            });
        };
        let words: Vec<&[u8]> = line.words().collect();
        match words[..] {
            [b"comment" | b"obj_info", ..] => {}
            [b"format", kind, _] if format.is_none() => format = Some(format_named(kind, &line, &lines)?),
            [b"element", name, count] if elements.len() < MOST => elements.push(Element {
                name: text(name),
                count: whole(count).ok_or_else(|| lines.syntax(&line, "`element`, a name and a whole number"))?,
                properties: Vec::new(),
            }),
            [b"property", ..] => {
                let read = property(&words).ok_or_else(|| {
                    lines.syntax(
                        &line,
                        "`property`, a type and a name, or `property list`, two types and a name",
                    )
                })?;
                let room = elements.last_mut().filter(|e| e.properties.len() < MOST);
                let Some(element) = room else {
                    return Err(lines.syntax(&line, "an `element` before its (at most 256) properties"));
                };
                element.properties.push(read);
            }
            [b"end_header"] => break,
            _ => return Err(lines.syntax(&line, "a line of a PLY header, as `element vertex 8`")),
        }
    }
    let Some(format) = format else {
        return Err(MeshFileError::CutShort {
            path: path.to_owned(),
            expected: "a line `format ascii 1.0` or `format binary_little_endian 1.0`, or of big endian".to_string(),
        });
    };
    Ok((Header { format, elements }, lines))
}

fn format_named(kind: &[u8], line: &Line<'_>, lines: &Lines<'_>) -> Result<MeshFormat, MeshFileError> {
    match kind {
        b"ascii" => Ok(MeshFormat::PlyAscii),
        b"binary_little_endian" => Ok(MeshFormat::PlyLittleEndian),
        b"binary_big_endian" => Ok(MeshFormat::PlyBigEndian),
        _ => Err(lines.syntax(line, "`format` ascii, binary_little_endian or binary_big_endian")),
    }
}

fn property(words: &[&[u8]]) -> Option<Property> {
    match words {
        [_, b"list", count, of, name] => {
            let count = Scalar::named(count)?;
            if matches!(count, Scalar::F32 | Scalar::F64) {
                return None;
            }
            Some(Property {
                name: text(name),
                count: Some(count),
                of: Scalar::named(of)?,
            })
        }
        [_, of, name] => Some(Property {
            name: text(name),
            count: None,
            of: Scalar::named(of)?,
        }),
        _ => None,
    }
}

fn text(word: &[u8]) -> String {
    String::from_utf8_lossy(word).into_owned()
}

fn whole(word: &[u8]) -> Option<u64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}
