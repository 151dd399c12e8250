//! Reads triangles from STL files, ASCII and binary. The files are not trusted.

use glam::DVec3;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Bytes of a binary file before the first triangle: 80 of free text and a count.
const HEADER: usize = 84;
/// Bytes of a triangle in a binary file: a normal, three corners and two spare bytes.
const RECORD: usize = 50;

/// Why an STL file was refused.
#[derive(Debug, Error)]
pub enum StlError {
    /// The file cannot be read.
    #[error("cannot read the STL file {}: {source}; check the path and the permissions", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The path is a folder or a device.
    #[error("{} is not a regular file; give the path of an STL file", path.display())]
    NotAFile {
        /// The path.
        path: PathBuf,
    },
    /// The file is too short to be an STL file.
    #[error("{} has {bytes} bytes; a binary STL file has at least 84, an ASCII one begins with `solid`", path.display())]
    TooShort {
        /// The file.
        path: PathBuf,
        /// Its length.
        bytes: usize,
    },
    /// The count of a binary file does not fit its length.
    #[error(
        "{} is a binary STL file of {bytes} bytes whose header tells of {count} triangles, which take {expected} bytes; \
         the file is cut short or damaged, export it again",
        path.display()
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
    /// The file holds no triangle.
    #[error("{} holds no triangle; export the surface again", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
    /// A coordinate is not a finite number.
    #[error("triangle {triangle} (counted from 1) of {} has a corner at {corner}; coordinates must be finite", path.display())]
    NotFinite {
        /// The file.
        path: PathBuf,
        /// The triangle, counted from 1.
        triangle: usize,
        /// The corner, after scale and shift.
        corner: DVec3,
    },
    /// A line of an ASCII file is not what the format asks for.
    #[error("{}:{line}: expected {expected}, found `{found}`", path.display())]
    Syntax {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// What should be there.
        expected: &'static str,
        /// What is there.
        found: String,
    },
    /// An ASCII file ends too early.
    #[error("{} ends before {expected}; the file is cut short, export it again", path.display())]
    CutShort {
        /// The file.
        path: PathBuf,
        /// What should follow.
        expected: &'static str,
    },
}

/// Triangles of an STL file; every corner `x` of the file becomes `x * scale + shift` [m].
///
/// A file is binary when its length is the one that the count in its header asks for, whatever its first word; else it
/// is ASCII when it begins with `solid`. Normals of the file are not used.
pub fn read_stl(path: &Path, scale: f64, shift: DVec3) -> Result<Vec<[DVec3; 3]>, StlError> {
    let fail = |source| StlError::Read {
        path: path.to_owned(),
        source,
    };
    if !fs::metadata(path).map_err(fail)?.is_file() {
        return Err(StlError::NotAFile { path: path.to_owned() });
    }
    let bytes = fs::read(path).map_err(fail)?;
    let mut triangles = if is_ascii(&bytes) {
        parse_ascii(path, &bytes)?
    } else {
        parse_binary(path, &bytes)?
    };
    if triangles.is_empty() {
        return Err(StlError::Empty { path: path.to_owned() });
    }
    for (index, triangle) in triangles.iter_mut().enumerate() {
        for corner in triangle {
            *corner = *corner * scale + shift;
            if !corner.is_finite() {
                return Err(StlError::NotFinite {
                    path: path.to_owned(),
                    triangle: index + 1,
                    corner: *corner,
                });
            }
        }
    }
    Ok(triangles)
}

/// Count of the header and the length that it asks for.
fn told_length(bytes: &[u8]) -> Option<(u32, u64)> {
    let count = u32::from_le_bytes(bytes.get(HEADER - 4..HEADER)?.try_into().ok()?);
    Some((count, HEADER as u64 + RECORD as u64 * u64::from(count)))
}

fn is_ascii(bytes: &[u8]) -> bool {
    let fits_binary = told_length(bytes).is_some_and(|(_, length)| length == bytes.len() as u64);
    let text = bytes.trim_ascii_start();
    let begins_solid = text.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    // A binary file whose header says "solid" and whose length is wrong has a zero byte early on; text has none.
    begins_solid && !fits_binary && !bytes.iter().take(HEADER + RECORD).any(|&byte| byte == 0)
}

fn parse_binary(path: &Path, bytes: &[u8]) -> Result<Vec<[DVec3; 3]>, StlError> {
    let Some((count, expected)) = told_length(bytes) else {
        return Err(StlError::TooShort {
            path: path.to_owned(),
            bytes: bytes.len(),
        });
    };
    if expected != bytes.len() as u64 {
        return Err(StlError::WrongLength {
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

/// Lines of a file with their numbers, from 0.
type NumberedLines<'a> = std::iter::Enumerate<std::slice::Split<'a, u8, fn(&u8) -> bool>>;

/// Lines of an ASCII file that are not blank.
struct Lines<'a> {
    path: &'a Path,
    rest: NumberedLines<'a>,
}

struct Line<'a> {
    number: usize,
    text: &'a [u8],
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Option<Line<'a>> {
        let (index, text) = self.rest.by_ref().find(|(_, text)| !text.trim_ascii().is_empty())?;
        Some(Line {
            number: index + 1,
            text: text.trim_ascii(),
        })
    }

    /// The next line, which must begin with these words; gives what follows them.
    fn expect(&mut self, words: &'static str) -> Result<(Line<'a>, &'a [u8]), StlError> {
        let Some(line) = self.next() else {
            return Err(StlError::CutShort {
                path: self.path.to_owned(),
                expected: words,
            });
        };
        match after_words(line.text, words) {
            Some(rest) => Ok((line, rest)),
            None => Err(self.syntax(&line, words)),
        }
    }

    fn syntax(&self, line: &Line<'_>, expected: &'static str) -> StlError {
        let shown = &line.text[..line.text.len().min(60)];
        let found = String::from_utf8_lossy(shown).into_owned();
        StlError::Syntax {
            path: self.path.to_owned(),
            line: line.number,
            expected,
            found,
        }
    }

    fn corner(&mut self) -> Result<DVec3, StlError> {
        let (line, rest) = self.expect("vertex")?;
        let mut values = [0.0; 3];
        let mut words = rest.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        for value in &mut values {
            let parsed = words
                .next()
                .and_then(|word| std::str::from_utf8(word).ok()?.parse::<f64>().ok());
            *value = parsed.ok_or_else(|| self.syntax(&line, "`vertex` and three numbers"))?;
        }
        match words.next() {
            None => Ok(DVec3::from_array(values)),
            Some(_) => Err(self.syntax(&line, "`vertex` and three numbers")),
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

fn parse_ascii(path: &Path, bytes: &[u8]) -> Result<Vec<[DVec3; 3]>, StlError> {
    let end_of_line: fn(&u8) -> bool = |&byte| byte == b'\n';
    let mut lines = Lines {
        path,
        rest: bytes.split(end_of_line).enumerate(),
    };
    let mut triangles = Vec::new();
    let mut open = false;
    while let Some(line) = lines.next() {
        if !open && after_words(line.text, "solid").is_some() {
            open = true;
        } else if open && after_words(line.text, "endsolid").is_some() {
            open = false;
        } else if open && after_words(line.text, "facet normal").is_some() {
            lines.expect("outer loop")?;
            triangles.push([lines.corner()?, lines.corner()?, lines.corner()?]);
            lines.expect("endloop")?;
            lines.expect("endfacet")?;
        } else {
            let expected = if open {
                "`facet normal` or `endsolid`"
            } else {
                "`solid`"
            };
            return Err(lines.syntax(&line, expected));
        }
    }
    if open {
        return Err(StlError::CutShort {
            path: path.to_owned(),
            expected: "endsolid",
        });
    }
    Ok(triangles)
}
