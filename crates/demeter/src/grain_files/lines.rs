//! A text file, line by line: it is never in memory as a whole, and may be compressed (gzip).

use super::error::{FileProblem, Located};
use flate2::bufread::MultiGzDecoder;
use std::io::{BufRead, BufReader, Read};

/// Most text of one moment that is read [bytes].
pub const MAX_FRAME_BYTES: u64 = 8 << 30;
/// Longest line [bytes].
pub const MAX_LINE_BYTES: usize = 1 << 20;
/// Most empty lines one after the other: no file has more, but for one that was made to be read for very long.
pub const MAX_EMPTY_LINES: usize = 1 << 20;
/// Bytes that are read in one piece.
const PIECE: usize = 1 << 16;
/// The first bytes of a file compressed with gzip.
const GZIP: [u8; 2] = [0x1f, 0x8b];

/// Lines of a text file, of which one can be looked at before it is taken.
pub(super) struct Lines<'a> {
    reader: Box<dyn BufRead + 'a>,
    compressed: bool,
    line: Vec<u8>,
    /// Number of the line in memory, from 1.
    number: usize,
    /// Whether that line is still to be taken.
    held: bool,
    /// Empty lines before the line in memory.
    empty: usize,
    /// Bytes read before the line in memory.
    position: u64,
    /// Bytes left for this moment.
    left: u64,
}

impl<'a> Lines<'a> {
    /// The lines of what a reader gives.
    pub fn new(reader: impl Read + 'a) -> Result<Self, FileProblem> {
        let mut raw = BufReader::with_capacity(PIECE, reader);
        let compressed = raw.fill_buf()?.starts_with(&GZIP);
        let reader: Box<dyn BufRead + 'a> = match compressed {
            true => Box::new(BufReader::with_capacity(PIECE, MultiGzDecoder::new(raw))),
            false => Box::new(raw),
        };
        Ok(Self {
            reader,
            compressed,
            line: Vec::new(),
            number: 0,
            held: false,
            empty: 0,
            position: 0,
            left: MAX_FRAME_BYTES,
        })
    }

    /// The lines of a text.
    #[cfg(test)]
    pub fn of(text: &'a str) -> Self {
        Self::new(text.as_bytes()).unwrap()
    }

    /// The start of the text, without taking any of it; the end may cut a letter or a line.
    pub fn start(&mut self) -> Result<String, FileProblem> {
        let problem = |e| reading(e, self.compressed);
        let start = self.reader.fill_buf().map_err(problem)?;
        let text = String::from_utf8_lossy(start);
        Ok(text.strip_prefix('\u{feff}').unwrap_or(&text).to_owned())
    }

    /// Lets a new moment have all of its bytes.
    pub fn begin_frame(&mut self) {
        self.left = MAX_FRAME_BYTES;
    }

    /// Number of the line that was looked at or taken last.
    pub fn number(&self) -> usize {
        self.number
    }

    /// The next line, which stays.
    pub fn peek(&mut self) -> Result<Option<(usize, &str)>, Located> {
        if !self.held {
            self.read()?;
            self.held = true;
        }
        if self.line.is_empty() {
            return Ok(None);
        }
        self.text().map(Some)
    }

    /// The next line, taken.
    pub fn next(&mut self) -> Result<Option<(usize, &str)>, Located> {
        if !self.held {
            self.read()?;
        }
        self.held = false;
        if self.line.is_empty() {
            // the end stays the end
            self.held = true;
            return Ok(None);
        }
        self.text().map(Some)
    }

    /// The next line, which must be there.
    pub fn expect(&mut self, expected: &'static str) -> Result<(usize, &str), Located> {
        let at = self.number + 1;
        self.next()?.ok_or_else(|| FileProblem::Ends { expected }.at(at, None))
    }

    /// Takes lines without looking at them; tells how many there were.
    pub fn skip(&mut self, count: u64) -> Result<u64, Located> {
        for done in 0..count {
            if !self.held {
                self.read()?;
            }
            self.held = false;
            if self.line.is_empty() {
                self.held = true;
                return Ok(done);
            }
        }
        Ok(count)
    }

    fn text(&self) -> Result<(usize, &str), Located> {
        match std::str::from_utf8(&self.line) {
            Ok(text) => {
                let text = text.trim_end_matches(['\n', '\r']);
                let text = if self.number == 1 {
                    text.strip_prefix('\u{feff}').unwrap_or(text)
                } else {
                    text
                };
                Ok((self.number, text))
            }
            Err(error) => {
                let position = self.position as usize + error.valid_up_to() + 1;
                Err(FileProblem::NotText { position }.at(self.number, None))
            }
        }
    }

    /// Reads a line into memory; it is empty at the end.
    fn read(&mut self) -> Result<(), Located> {
        self.position += self.line.len() as u64;
        self.line.clear();
        let at = self.number + 1;
        let most = MAX_LINE_BYTES.min(usize::try_from(self.left).unwrap_or(usize::MAX)) as u64 + 1;
        let read = self.reader.by_ref().take(most).read_until(b'\n', &mut self.line);
        let length = read.map_err(|e| reading(e, self.compressed).at(at, None))?;
        if length > MAX_LINE_BYTES {
            self.line.clear();
            return Err(FileProblem::LineTooLong.at(at, None));
        }
        self.left = match self.left.checked_sub(length as u64) {
            Some(left) => left,
            None => return Err(FileProblem::FrameTooLarge.at(at, None)),
        };
        if length > 0 {
            self.number = at;
            self.empty = if self.line.trim_ascii().is_empty() {
                self.empty + 1
            } else {
                0
            };
        }
        if self.empty > MAX_EMPTY_LINES {
            return Err(FileProblem::Empty.at(at, None));
        }
        Ok(())
    }
}

/// What an error of reading means: damage, when the file is compressed.
fn reading(error: std::io::Error, compressed: bool) -> FileProblem {
    use std::io::ErrorKind::{InvalidData, InvalidInput, UnexpectedEof};
    match error.kind() {
        InvalidData | InvalidInput | UnexpectedEof if compressed => FileProblem::Compressed(error.to_string()),
        _ => FileProblem::Read(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    #[test]
    fn lines_are_numbered_looked_at_and_skipped() {
        let mut lines = Lines::of("\u{feff}a\r\nb\n\nc");
        assert_eq!(lines.start().unwrap(), "a\r\nb\n\nc");
        assert_eq!(lines.peek().unwrap(), Some((1, "a")));
        assert_eq!(lines.next().unwrap(), Some((1, "a")));
        assert_eq!(lines.skip(1).unwrap(), 1);
        assert_eq!(lines.peek().unwrap(), Some((3, "")));
        assert_eq!(lines.skip(9).unwrap(), 2);
        assert_eq!(lines.next().unwrap(), None);
        assert_eq!(lines.next().unwrap(), None);
        assert!(
            lines
                .expect("more")
                .unwrap_err()
                .to_string()
                .contains("line 5: the file ends where more")
        );
    }

    #[test]
    fn compressed_text_is_read_and_its_damage_told() {
        let text = "one\ntwo\n".repeat(10_000);
        let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        encoder.write_all(text.as_bytes()).unwrap();
        let bytes = encoder.finish().unwrap();
        let mut lines = Lines::new(&bytes[..]).unwrap();
        assert_eq!(lines.skip(u64::MAX).unwrap(), 20_000);
        let mut cut = Lines::new(&bytes[..bytes.len() - 20]).unwrap();
        assert!(
            cut.skip(u64::MAX)
                .unwrap_err()
                .to_string()
                .contains("compressed and damaged")
        );
    }

    #[test]
    fn empty_lines_are_not_read_for_ever() {
        let all_empty = |count: usize| Lines::new(std::io::repeat(b'\n').take(count as u64)).unwrap();
        assert_eq!(
            all_empty(MAX_EMPTY_LINES).skip(u64::MAX).unwrap(),
            MAX_EMPTY_LINES as u64
        );
        let found = all_empty(MAX_EMPTY_LINES + 9).skip(u64::MAX).unwrap_err().to_string();
        assert!(found.contains("line 1048577: is one of 1048576 empty lines"), "{found}");
        let halves = ["\n".repeat(MAX_EMPTY_LINES), "\n".repeat(MAX_EMPTY_LINES)].join("a grain");
        assert_eq!(Lines::of(&halves).skip(u64::MAX).unwrap(), 2 * MAX_EMPTY_LINES as u64);
    }

    #[test]
    fn a_line_without_end_is_refused() {
        let mut lines = Lines::new(std::io::repeat(b'x')).unwrap();
        let found = lines.next().unwrap_err().to_string();
        assert!(found.contains("line 1: is longer than 1048576 bytes"), "{found}");
    }
}
