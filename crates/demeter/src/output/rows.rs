//! A CSV file that grows by rows, each of which begins with the step that it belongs to.

use super::error::OutputError;
use super::folder::RunFolder;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::{File, Metadata, OpenOptions};
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Bytes of a row that are looked at to find its step: more than the digits of the largest one.
const STEP_LENGTH: usize = 32;

/// Longest header that is read to tell what differs [bytes].
const LONGEST_HEADER: u64 = 1 << 20;

/// A file of rows, open at its end.
#[derive(Debug)]
pub(crate) struct RowFile {
    path: PathBuf,
    file: File,
    length: u64,
    /// Steps of the first and the last row that were there already.
    kept: Option<(u64, u64)>,
}

impl RowFile {
    /// Starts a file with its header.
    pub fn create(path: &Path, header: &[String]) -> Result<Self, OutputError> {
        let file = File::create(path).map_err(OutputError::io("create", path))?;
        let mut rows = Self {
            path: path.to_owned(),
            file,
            length: 0,
            kept: None,
        };
        rows.add(std::slice::from_ref(&header))?;
        Ok(rows)
    }

    /// Goes on after a step: rows of later steps and a row that was cut short are removed. A file that is not there, or
    /// was cut in its header, is started again. However long the file is, only a little of it is in memory.
    pub fn resume(path: &Path, header: &[String], step: u64) -> Result<Self, OutputError> {
        let io = |e| OutputError::io("continue", path)(e);
        let file = match OpenOptions::new().read(true).write(true).open(path) {
            Err(e) if e.kind() == io::ErrorKind::NotFound => return Self::create(path, header),
            file => file.map_err(io)?,
        };
        let expected = encode(std::slice::from_ref(&header), path)?;
        let mut reader = BufReader::new(file);
        let mut found = Vec::new();
        (&mut reader)
            .take(expected.len() as u64)
            .read_to_end(&mut found)
            .map_err(io)?;
        if expected.starts_with(&found) && found != expected {
            return Self::create(path, header);
        }
        let other = |problem: String| OutputError::OtherSeries {
            path: path.to_owned(),
            problem,
        };
        if found != expected {
            return Err(other_columns(path, header, &found, reader).map_err(io)?);
        }
        let (bytes, kept) = rows_up_to(&mut reader, step).map_err(io)?.map_err(other)?;
        let length = expected.len() as u64 + bytes;
        let mut file = reader.into_inner();
        file.set_len(length).map_err(io)?;
        file.seek(SeekFrom::Start(length)).map_err(io)?;
        Ok(Self {
            path: path.to_owned(),
            file,
            length,
            kept,
        })
    }

    /// What the file lacks of the bytes that were written into it, in words behind its name; told the last moment, where each has rows, also
    /// which rows from the start of the run on.
    fn lacks(&self, last: Option<u64>, written: u64) -> Option<String> {
        let problem = match (self.kept, last) {
            (Some((0, found)), Some(last)) if found < last => {
                format!("lacks the rows behind step {found}, up to that of step {last}")
            }
            (Some((first @ 1.., _)), Some(_)) => format!("begins at step {first}, not at the start of the run"),
            (None, Some(last)) => format!("holds no rows up to step {last} any more"),
            _ if self.length < written => {
                let lost = written - self.length;
                format!("lacks {lost} of the {written} bytes that the run wrote into it up to its checkpoint")
            }
            _ => return None,
        };
        Some(problem)
    }

    /// What something else did to the file while it was written, in words; nothing where it is as it was written.
    pub fn is_changed(&self) -> Option<String> {
        let path = self.path.display();
        let Ok(there) = std::fs::metadata(&self.path) else {
            return Some(format!("`{path}` is gone"));
        };
        let is_another = self.file.metadata().is_ok_and(|own| !is_same_file(&own, &there));
        if is_another {
            return Some(format!("another file stands in the place of `{path}`"));
        }
        (there.len() != self.length).then(|| self.other_length(there.len()))
    }

    fn other_length(&self, held: u64) -> String {
        format!(
            "`{}` holds {held} bytes, and the run wrote {}",
            self.path.display(),
            self.length
        )
    }

    /// Its path.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Adds rows in one piece; they are in the file when this returns. When that fails, what got through of them is
    /// taken back.
    pub fn add<R: AsRef<[String]>>(&mut self, rows: &[R]) -> Result<(), OutputError> {
        let bytes = encode(rows, &self.path)?;
        // behind the end of a file that was cut rows would follow a hole
        let held = self.file.metadata().map_or(self.length, |file| file.len());
        if held != self.length {
            return Err(OutputError::RowsLost {
                path: self.path.clone(),
                problem: self.other_length(held),
            });
        }
        let written = self.file.write_all(&bytes);
        if written.is_err() {
            let back = self.file.set_len(self.length);
            // If even that fails, `resume` removes the row that was cut short.
            let _ = back.and_then(|()| self.file.seek(SeekFrom::Start(self.length)));
        }
        written.map_err(OutputError::io("add a row to", &self.path))?;
        self.length += bytes.len() as u64;
        Ok(())
    }
}

#[cfg(unix)]
fn is_same_file(one: &Metadata, other: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (one.dev(), one.ino()) == (other.dev(), other.ino())
}

#[cfg(not(unix))]
fn is_same_file(_one: &Metadata, _other: &Metadata) -> bool {
    true
}

/// The files that a run wrote until a checkpoint, by their names from its folder on, with the bytes of those that hold rows.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct WrittenFiles(BTreeMap<String, u64>);

impl WrittenFiles {
    /// Files of rows as they are now, and others.
    pub fn of<'a>(folder: &RunFolder, rows: impl Iterator<Item = &'a RowFile>, others: &[PathBuf]) -> Self {
        let rows = rows.map(|file| (name_in(folder, &file.path), file.length));
        let others = others.iter().map(|path| (name_in(folder, path), 0));
        Self(others.chain(rows).collect())
    }

    /// Whether a file is one of them.
    pub fn knows(&self, folder: &RunFolder, path: &Path) -> bool {
        self.0.contains_key(&name_in(folder, path))
    }

    /// Name of a file that goes on, and what it lacks; `last` is the last moment, where each has rows there.
    pub fn lacks(&self, folder: &RunFolder, file: &RowFile, last: Option<u64>) -> Option<(String, String)> {
        let name = name_in(folder, &file.path);
        let problem = file.lacks(last, *self.0.get(&name)?)?;
        Some((name, problem))
    }
}

/// The error of a file that begins with another header than its own, told how it begins and what reads on.
fn other_columns(path: &Path, header: &[String], begin: &[u8], rest: impl BufRead) -> io::Result<OutputError> {
    let mut line = Vec::new();
    begin.chain(rest.take(LONGEST_HEADER)).read_until(b'\n', &mut line)?;
    let record = csv::ReaderBuilder::new()
        .has_headers(false)
        .from_reader(&*line)
        .records()
        .next();
    let found: Vec<String> = record
        .and_then(Result::ok)
        .map(|record| record.iter().map(str::to_owned).collect())
        .unwrap_or_default();
    if found == header && line.ends_with(b"\r\n") {
        return Ok(OutputError::OtherSeries {
            path: path.to_owned(),
            problem: "its lines end with CR LF, as an editor or a copy made them, and the run ends them with LF"
                .to_string(),
        });
    }
    let without = |all: &[String], others: &[String]| -> Vec<String> {
        all.iter().filter(|title| !others.contains(title)).cloned().collect()
    };
    Ok(OutputError::OtherColumns {
        path: path.to_owned(),
        lacks: without(header, &found),
        others: without(&found, header),
    })
}

fn name_in(folder: &RunFolder, path: &Path) -> String {
    let name = path.strip_prefix(folder.root()).unwrap_or(path);
    name.to_string_lossy().into_owned()
}

fn encode<R: AsRef<[String]>>(rows: &[R], path: &Path) -> Result<Vec<u8>, OutputError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer
            .write_record(row.as_ref())
            .map_err(|e| OutputError::encode(path, &e))?;
    }
    writer.into_inner().map_err(|e| OutputError::encode(path, &e))
}

/// Bytes of whole rows, and the steps of the first and the last of them.
type Kept = (u64, Option<(u64, u64)>);

/// The whole rows up to a step, from behind the header on; the inner error tells a row that is none.
fn rows_up_to(reader: &mut impl BufRead, step: u64) -> io::Result<Result<Kept, String>> {
    let (mut bytes, mut kept) = (0, None);
    let mut start = Vec::with_capacity(STEP_LENGTH);
    // names hold no control characters, so every line feed ends a row
    for line in 2_u64.. {
        let Some(length) = next_row(reader, &mut start)? else {
            break;
        };
        let cell = start.split(|&b| b == b',').next().unwrap_or_default();
        let number = std::str::from_utf8(cell).ok().and_then(|text| text.parse::<u64>().ok());
        let Some(found) = number else {
            return Ok(Err(format!("row {line} does not begin with a step")));
        };
        if found > step {
            break;
        }
        bytes += length;
        kept = Some((kept.map_or(found, |(first, _)| first), found));
    }
    Ok(Ok((bytes, kept)))
}

/// Reads over a row, keeps its start, and tells its length with the line feed; `None` when the file ends before that.
fn next_row(reader: &mut impl BufRead, start: &mut Vec<u8>) -> io::Result<Option<u64>> {
    start.clear();
    let mut length = 0;
    loop {
        let bytes = reader.fill_buf()?;
        if bytes.is_empty() {
            return Ok(None);
        }
        let end = bytes.iter().position(|&b| b == b'\n');
        let part = end.unwrap_or(bytes.len());
        start.extend(bytes.iter().take(part.min(STEP_LENGTH - start.len())));
        let read = end.map_or(bytes.len(), |at| at + 1);
        reader.consume(read);
        length += read as u64;
        if end.is_some() {
            return Ok(Some(length));
        }
    }
}
