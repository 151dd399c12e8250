//! Lines of a text file that is not trusted.

use super::MeshFileError;
use super::other_kind::without_mark;
use std::path::Path;

/// Longest piece of a file that a message shows [bytes].
const SHOWN: usize = 60;

/// Lines that are not blank, with any of the three line ends: `\n`, `\r\n` and `\r`.
pub(super) struct Lines<'a> {
    pub(super) path: &'a Path,
    rest: &'a [u8],
    number: usize,
}

/// A line without blanks around it.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    /// Counted from 1.
    pub(super) number: usize,
    pub(super) text: &'a [u8],
}

impl<'a> Line<'a> {
    /// Words between blanks.
    pub(super) fn words(&self) -> impl Iterator<Item = &'a [u8]> + use<'a> {
        self.text
            .split(u8::is_ascii_whitespace)
            .filter(|word: &&[u8]| !word.is_empty())
    }
}

impl<'a> Lines<'a> {
    pub(super) fn new(path: &'a Path, bytes: &'a [u8]) -> Self {
        let rest = without_mark(bytes);
        Lines { path, rest, number: 0 }
    }

    /// The next line that does not begin with `#`.
    pub(super) fn next_but_comments(&mut self) -> Option<Line<'a>> {
        loop {
            let line = self.next()?;
            if !line.text.starts_with(b"#") {
                return Some(line);
            }
        }
    }

    pub(super) fn next(&mut self) -> Option<Line<'a>> {
        while !self.rest.is_empty() {
            let end = self.rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
            let end = end.unwrap_or(self.rest.len());
            let text = self.rest[..end].trim_ascii();
            let ends_twice = self.rest[end..].starts_with(b"\r\n");
            self.rest = &self.rest[(end + 1 + usize::from(ends_twice)).min(self.rest.len())..];
            self.number += 1;
            if !text.is_empty() {
                return Some(Line {
                    number: self.number,
                    text,
                });
            }
        }
        None
    }

    /// What follows the lines that were taken.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }

    pub(super) fn syntax(&self, line: &Line<'_>, expected: impl Into<String>) -> MeshFileError {
        MeshFileError::Syntax {
            path: self.path.to_owned(),
            line: line.number,
            expected: expected.into(),
            found: shown(line.text),
        }
    }
}

/// The beginning of a piece of a file, for a message.
pub(super) fn shown(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(SHOWN)]);
    text.chars().map(|c| if c.is_control() { '?' } else { c }).collect()
}

/// A number as text. What is too large for a double becomes infinite, and is refused later with its place.
pub(super) fn number(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}
