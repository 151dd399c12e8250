//! STL files, ASCII and binary. A file is binary when its length is the one that the count in its header asks for,
//! whatever its first word; else it is ASCII when it begins with `solid`. Normals of the file are not used.

use super::MeshFileError;
use super::text::{Line, Lines, number};
use glam::DVec3;
use std::path::Path;

/// Bytes of a binary file before the first triangle: 80 of free text and a count.
pub(super) const HEADER: usize = 84;
/// Bytes of a triangle in a binary file: a normal, three corners and two spare bytes.
const RECORD: usize = 50;

/// Whether the length of a file is the one that a binary STL file with the count in its header has.
pub(super) fn fits_binary(bytes: &[u8]) -> bool {
    told_length(bytes).is_some_and(|(_, length)| length == bytes.len() as u64)
}

/// Count of the header and the length that it asks for.
fn told_length(bytes: &[u8]) -> Option<(u32, u64)> {
    let count = u32::from_le_bytes(bytes.get(HEADER - 4..HEADER)?.try_into().ok()?);
    Some((count, HEADER as u64 + RECORD as u64 * u64::from(count)))
}

pub(super) fn is_ascii(bytes: &[u8]) -> bool {
    let first = Lines::new(Path::new(""), bytes).next_but_comments();
    let begins_solid = first.is_some_and(|line| {
        line.text
            .get(..5)
            .is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
    });
    // A binary file whose header says "solid" and whose length is wrong has a zero byte early on; text has none.
    begins_solid && !fits_binary(bytes) && !bytes.iter().take(HEADER + RECORD).any(|&byte| byte == 0)
}

pub(super) fn parse_binary(path: &Path, bytes: &[u8]) -> Result<Vec<[DVec3; 3]>, MeshFileError> {
    let Some((count, expected)) = told_length(bytes) else {
        return Err(MeshFileError::TooShort {
            path: path.to_owned(),
            bytes: bytes.len(),
        });
    };
    if expected != bytes.len() as u64 {
        return Err(MeshFileError::WrongLength {
            path: path.to_owned(),
            bytes: bytes.len(),
            count,
            expected,
        });
    }
    Ok(bytes[HEADER..].chunks_exact(RECORD).map(corners_of_record).collect())
}

fn corners_of_record(record: &[u8]) -> [DVec3; 3] {
    let number = |index: usize| {
        let at = 12 + 4 * index;
        f64::from(f32::from_le_bytes([
            record[at],
            record[at + 1],
            record[at + 2],
            record[at + 3],
        ]))
    };
    [0, 3, 6].map(|first| DVec3::new(number(first), number(first + 1), number(first + 2)))
}

/// Lines of an ASCII file, asked for one by one.
struct Facets<'a> {
    lines: Lines<'a>,
}

impl<'a> Facets<'a> {
    /// The next line, which must begin with these words; gives what follows them.
    fn expect(&mut self, words: &str) -> Result<(Line<'a>, &'a [u8]), MeshFileError> {
        let Some(line) = self.lines.next_but_comments() else {
            return Err(MeshFileError::CutShort {
                path: self.lines.path.to_owned(),
                expected: words.to_string(),
            });
        };
        match after_words(line.text, words) {
            Some(rest) => Ok((line, rest)),
            None => Err(self.lines.syntax(&line, words)),
        }
    }

    fn corner(&mut self) -> Result<DVec3, MeshFileError> {
        let (line, text) = self.expect("vertex")?;
        let rest = Line { text, ..line };
        let mut words = rest.words();
        let values: [Option<f64>; 3] = std::array::from_fn(|_| words.next().and_then(number));
        match (values, words.next()) {
            ([Some(x), Some(y), Some(z)], None) => Ok(DVec3::new(x, y, z)),
            _ => Err(self.lines.syntax(&line, "`vertex` and three numbers")),
        }
    }
}

/// What follows the given words (in any case, with any blanks) at the start of a line; `None` when it begins otherwise.
fn after_words<'a>(mut text: &'a [u8], words: &str) -> Option<&'a [u8]> {
    for word in words.split(' ') {
        text = text.trim_ascii_start();
        let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
        if !text[..end].eq_ignore_ascii_case(word.as_bytes()) {
            return None;
        }
        text = &text[end..];
    }
    Some(text)
}

/// Words that begin a line.
const LINES: [&str; 6] = ["facet", "outer", "vertex", "endloop", "endfacet", "endsolid"];

/// The text with its line ends, where it has other blanks in their place; nothing where it has line ends.
fn broken_into_lines(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut lines = Lines::new(Path::new(""), bytes);
    let first = loop {
        let line = lines.next_but_comments()?;
        let place = line.words().position(|word| word.eq_ignore_ascii_case(b"vertex"));
        if let Some(place) = place {
            break place;
        }
    };
    if first == 0 {
        return None;
    }
    let mut text = Vec::with_capacity(bytes.len());
    for word in bytes.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()) {
        let begins = LINES.iter().any(|known| word.eq_ignore_ascii_case(known.as_bytes()));
        text.push(if begins { b'\n' } else { b' ' });
        text.extend_from_slice(word);
    }
    Some(text)
}

pub(super) fn parse_ascii(path: &Path, bytes: &[u8]) -> Result<Vec<[DVec3; 3]>, MeshFileError> {
    let Some(text) = broken_into_lines(bytes) else {
        return parse_lines(path, bytes);
    };
    parse_lines(path, &text).map_err(|mut error| {
        if let MeshFileError::Syntax { line, .. } = &mut error {
            // the lines are ours
            *line = 1;
        }
        error
    })
}

fn parse_lines(path: &Path, text: &[u8]) -> Result<Vec<[DVec3; 3]>, MeshFileError> {
    let mut facets = Facets {
        lines: Lines::new(path, text),
    };
    let mut triangles = Vec::new();
    let mut open = false;
    while let Some(line) = facets.lines.next_but_comments() {
        if !open && after_words(line.text, "solid").is_some() {
            open = true;
        } else if open && after_words(line.text, "endsolid").is_some() {
            open = false;
        } else if open && after_words(line.text, "facet normal").is_some() {
            facets.expect("outer loop")?;
            triangles.push([facets.corner()?, facets.corner()?, facets.corner()?]);
            facets.expect("endloop")?;
            facets.expect("endfacet")?;
        } else {
            let expected = if open {
                "`facet normal` or `endsolid`"
            } else {
                "`solid`"
            };
            return Err(facets.lines.syntax(&line, expected));
        }
    }
    if open {
        return Err(MeshFileError::CutShort {
            path: path.to_owned(),
            expected: "endsolid".to_string(),
        });
    }
    Ok(triangles)
}
