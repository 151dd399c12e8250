//! Checkpoints: the file that holds a whole run, its checks, and the pair of the latest and the one before.
//!
//! Layout, little-endian:
//!
//! | bytes | what |
//! |---|---|
//! | 0..8 | `DEMETERC` |
//! | 8..12 | version of the format, `u32` |
//! | 12..16 | length of the header, `u32` |
//! | 16..24 | length of the payload, `u64` |
//! | 24..28 | CRC-32 of the header |
//! | 28..32 | CRC-32 of the payload |
//! | then | header: JSON, readable with any text viewer |
//! | then | payload: the state, in `postcard` encoding |
//!
//! A checkpoint is written under a temporary name, forced to the disk, and then renamed; the one before is kept. So
//! one usable checkpoint exists at every moment, whenever the process is killed or the power fails.

mod atomic_file;
mod error;

pub use atomic_file::{Durability, hint, part_path, write_atomically};
pub(crate) use atomic_file::{force_to_disk, write_atomically_with};
pub use error::CheckpointError;

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Version of the format. It grows with every change of the layout or of the type of the payload.
pub const FORMAT: u32 = 38;

/// File name of the latest checkpoint of a run.
pub const LATEST: &str = "checkpoint.latest";

/// File name of the checkpoint before the latest.
pub const PREVIOUS: &str = "checkpoint.previous";

const MAGIC: &[u8; 8] = b"DEMETERC";
const FIXED: usize = 32;
/// A header is a few hundred bytes; a longer one can only come from a damaged file.
const LONGEST_HEADER: u32 = 1 << 16;
/// All texts in a payload: the scenario, names, reasons and warnings, mostly some kilobytes.
const LONGEST_TEXTS: u64 = 1 << 26;
/// Bytes that are read or written at once.
const PIECE: usize = 1 << 20;

/// What a checkpoint says about itself without being decoded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// Version of Demeter that wrote it.
    pub engine_version: String,
    /// Title of the run.
    pub title: String,
    /// Steps done.
    pub step: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Number of grains.
    pub grains: u64,
    /// Number of contacts.
    pub contacts: u64,
}

/// A state read by [`read_latest`].
#[derive(Debug)]
pub struct Restored<T> {
    /// The state.
    pub value: T,
    /// What the checkpoint says about itself.
    pub header: Header,
    /// The file that was used.
    pub path: PathBuf,
    /// What was wrong with newer ones, to be shown to the user.
    pub warnings: Vec<String>,
}

/// Writes one checkpoint, whole or not at all.
pub fn write<T: Serialize>(path: &Path, header: &Header, value: &T) -> Result<(), CheckpointError> {
    let part = write_part(path, header, value)?;
    atomic_file::give_name(&part, path, Durability::PowerCut)
        .map_err(|e| CheckpointError::io("rename a finished checkpoint to", path, e))
}

/// Writes the latest checkpoint of a run folder; what was the latest becomes the previous one.
pub fn write_latest<T: Serialize>(folder: &Path, header: &Header, value: &T) -> Result<(), CheckpointError> {
    let latest = folder.join(LATEST);
    let previous = folder.join(PREVIOUS);
    let part = write_part(&latest, header, value)?;
    match fs::rename(&latest, &previous) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => {
            return Err(CheckpointError::io("keep the previous checkpoint as", &previous, e));
        }
        _ => {}
    }
    atomic_file::give_name(&part, &latest, Durability::PowerCut)
        .map_err(|e| CheckpointError::io("rename a finished checkpoint to", &latest, e))
}

/// Makes what [`write_latest`] writes of a value that several processes have together, where it is another process that writes.
pub(crate) fn pass<T: Serialize>(value: &T) {
    // what goes nowhere always arrives, and the values are those that the other process encodes
    let _ = postcard::to_io(value, io::sink());
}

fn write_part<T: Serialize>(path: &Path, header: &Header, value: &T) -> Result<PathBuf, CheckpointError> {
    let encode = |part, problem: String| CheckpointError::Encode {
        path: path.to_owned(),
        part,
        problem,
    };
    let header = serde_json::to_vec_pretty(header).map_err(|e| encode("header", e.to_string()))?;
    let header_length = u32::try_from(header.len()).unwrap_or(u32::MAX);
    if header_length > LONGEST_HEADER {
        return Err(encode("header", format!("{} bytes are too long", header.len())));
    }
    let mut problem = None;
    let written = atomic_file::write_part(path, Durability::PowerCut, |file| {
        // what is known when the payload has passed by comes last
        file.write_all(&[0; FIXED])?;
        file.write_all(&header)?;
        let payload = Payload::write(file, value, &mut problem)?;
        let mut fixed = Vec::with_capacity(FIXED);
        fixed.extend_from_slice(MAGIC);
        fixed.extend_from_slice(&FORMAT.to_le_bytes());
        fixed.extend_from_slice(&header_length.to_le_bytes());
        fixed.extend_from_slice(&payload.length.to_le_bytes());
        fixed.extend_from_slice(&crc32fast::hash(&header).to_le_bytes());
        fixed.extend_from_slice(&payload.checksum.finalize().to_le_bytes());
        file.rewind()?;
        file.write_all(&fixed)
    });
    match problem {
        Some(problem) => Err(encode("payload", problem)),
        None => written.map_err(|e| CheckpointError::io("write checkpoint", path, e)),
    }
}

/// What has gone into a file as payload, piece by piece: in memory it would need as much as the state itself.
struct Payload<'a> {
    file: &'a mut File,
    length: u64,
    checksum: crc32fast::Hasher,
    error: Option<io::Error>,
}

impl<'a> Payload<'a> {
    /// Writes a value; notes a problem that is none of the file.
    fn write<T: Serialize>(file: &'a mut File, value: &T, problem: &mut Option<String>) -> io::Result<Self> {
        let mut payload = Self {
            file,
            length: 0,
            checksum: crc32fast::Hasher::new(),
            error: None,
        };
        let mut pieces = BufWriter::with_capacity(PIECE, &mut payload);
        let encoded = postcard::to_io(value, &mut pieces).map(|_| ());
        let written = pieces.flush();
        drop(pieces);
        if let Some(error) = payload.error.take() {
            return Err(error);
        }
        written?;
        if let Err(error) = encoded {
            *problem = Some(error.to_string());
        }
        Ok(payload)
    }
}

impl Write for Payload<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self.file.write(bytes) {
            Ok(count) => {
                self.checksum.update(&bytes[..count]);
                self.length += count as u64;
                Ok(count)
            }
            Err(error) => {
                // the encoder does not tell why it could not go on
                let kind = error.kind();
                if kind != io::ErrorKind::Interrupted {
                    self.error.get_or_insert(error);
                }
                Err(kind.into())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Reads one checkpoint.
pub fn read<T: DeserializeOwned>(path: &Path) -> Result<(Header, T), CheckpointError> {
    let mut opened = Opened::new(path)?;
    opened.check_payload()?;
    let contents = |problem: String| CheckpointError::Contents {
        path: path.to_owned(),
        part: "payload",
        problem,
    };
    let payload = (&mut opened.file).take(opened.payload_length);
    // room for all texts, which are no more than the payload
    let mut texts = vec![0; opened.payload_length.min(LONGEST_TEXTS) as usize];
    let read = postcard::from_io((BufReader::with_capacity(PIECE, payload), &mut texts));
    let (value, (rest, _)) = read.map_err(|e| contents(e.to_string()))?;
    let left = rest.buffer().len() as u64 + rest.get_ref().limit();
    if left > 0 {
        return Err(contents(format!("{left} bytes are left over")));
    }
    Ok((opened.header, value))
}

/// Reads what a checkpoint says about itself. All of the file is checked, so that one that is damaged is never called whole.
pub fn read_header(path: &Path) -> Result<Header, CheckpointError> {
    let mut opened = Opened::new(path)?;
    opened.check_payload()?;
    Ok(opened.header)
}

/// Whether a file starts like a checkpoint.
pub fn looks_like_one(path: &Path) -> bool {
    let mut start = [0; 8];
    File::open(path).is_ok_and(|mut file| file.read_exact(&mut start).is_ok()) && &start == MAGIC
}

/// Reads the latest usable checkpoint of a run folder.
///
/// When the latest is missing or damaged, one that was complete but not yet renamed is taken, or else the previous
/// one, and a warning says so.
pub fn read_latest<T: DeserializeOwned>(folder: &Path) -> Result<Restored<T>, CheckpointError> {
    let latest = folder.join(LATEST);
    let candidates = [latest.clone(), part_path(&latest), folder.join(PREVIOUS)];
    let mut problems = Vec::new();
    for path in candidates {
        match read(&path) {
            Ok((header, value)) => {
                let mut warnings: Vec<String> = problems.iter().map(CheckpointError::to_string).collect();
                if path != latest {
                    warnings.push(format!(
                        "the latest checkpoint is not usable; resuming from `{}` at step {}",
                        path.display(),
                        header.step
                    ));
                }
                return Ok(Restored {
                    value,
                    header,
                    path,
                    warnings,
                });
            }
            Err(error) if error.is_absent() => {}
            Err(error) => problems.push(error),
        }
    }
    let folder = folder.to_owned();
    Err(if problems.is_empty() {
        CheckpointError::Missing { folder }
    } else {
        CheckpointError::NoneUsable { folder, problems }
    })
}

/// A checkpoint whose fixed part and header are read and checked; the file stands at the payload.
struct Opened {
    path: PathBuf,
    file: File,
    header: Header,
    payload_length: u64,
    payload_checksum: u32,
}

impl Opened {
    fn new(path: &Path) -> Result<Self, CheckpointError> {
        let io = |e| CheckpointError::io("read checkpoint", path, e);
        let mut file = File::open(path).map_err(io)?;
        let found = file.metadata().map_err(io)?.len();
        let mut fixed = Vec::with_capacity(FIXED);
        (&mut file).take(FIXED as u64).read_to_end(&mut fixed).map_err(io)?;
        let fixed = FixedPart::parse(path, &fixed, found)?;
        let mut opened = Self {
            path: path.to_owned(),
            file,
            header: Header {
                engine_version: String::new(),
                title: String::new(),
                step: 0,
                time: 0.0,
                grains: 0,
                contacts: 0,
            },
            payload_length: fixed.payload_length,
            payload_checksum: fixed.payload_checksum,
        };
        let header = opened.bytes(u64::from(fixed.header_length), "header", fixed.header_checksum)?;
        opened.header = serde_json::from_slice(&header).map_err(|e| CheckpointError::Contents {
            path: path.to_owned(),
            part: "header",
            problem: e.to_string(),
        })?;
        Ok(opened)
    }

    /// Checks the payload, and goes back to its beginning.
    fn check_payload(&mut self) -> Result<(), CheckpointError> {
        let io = |e| CheckpointError::io("read checkpoint", &self.path, e);
        let begin = self.file.stream_position().map_err(io)?;
        let mut payload = BufReader::with_capacity(PIECE, (&mut self.file).take(self.payload_length));
        let mut found = crc32fast::Hasher::new();
        loop {
            let piece = payload.fill_buf().map_err(io)?;
            if piece.is_empty() {
                break;
            }
            found.update(piece);
            let length = piece.len();
            payload.consume(length);
        }
        self.file.seek(SeekFrom::Start(begin)).map_err(io)?;
        self.check("payload", self.payload_checksum, found.finalize())
    }

    fn check(&self, part: &'static str, expected: u32, found: u32) -> Result<(), CheckpointError> {
        if found == expected {
            return Ok(());
        }
        Err(CheckpointError::Checksum {
            path: self.path.clone(),
            part,
            expected,
            found,
        })
    }

    /// The next bytes of the file, checked. Their number was compared with the length of the file before.
    fn bytes(&mut self, length: u64, part: &'static str, expected: u32) -> Result<Vec<u8>, CheckpointError> {
        let mut bytes = Vec::with_capacity(usize::try_from(length).unwrap_or(0));
        (&mut self.file)
            .take(length)
            .read_to_end(&mut bytes)
            .map_err(|e| CheckpointError::io("read checkpoint", &self.path, e))?;
        self.check(part, expected, crc32fast::hash(&bytes))?;
        Ok(bytes)
    }
}

struct FixedPart {
    header_length: u32,
    payload_length: u64,
    header_checksum: u32,
    payload_checksum: u32,
}

impl FixedPart {
    /// Reads the fixed part and compares the lengths that it tells with that of the file.
    fn parse(path: &Path, bytes: &[u8], file_length: u64) -> Result<Self, CheckpointError> {
        let path = path.to_owned();
        let known = bytes.len().min(MAGIC.len());
        if known == 0 || bytes[..known] != MAGIC[..known] {
            return Err(CheckpointError::NotACheckpoint { path });
        }
        let (Some(found), Some(header_length), Some(payload_length), Some(header_checksum), Some(payload_checksum)) = (
            u32_at(bytes, 8),
            u32_at(bytes, 12),
            u64_at(bytes, 16),
            u32_at(bytes, 24),
            u32_at(bytes, 28),
        ) else {
            return Err(CheckpointError::CutShort {
                path,
                expected: FIXED as u64,
                found: file_length,
            });
        };
        if found != FORMAT {
            return Err(CheckpointError::Format {
                path,
                found,
                known: FORMAT,
            });
        }
        let expected = payload_length.saturating_add(FIXED as u64 + u64::from(header_length));
        if file_length < expected || header_length > LONGEST_HEADER {
            return Err(CheckpointError::CutShort {
                path,
                expected,
                found: file_length,
            });
        }
        if file_length > expected {
            return Err(CheckpointError::TooLong {
                path,
                expected,
                found: file_length,
            });
        }
        Ok(Self {
            header_length,
            payload_length,
            header_checksum,
            payload_checksum,
        })
    }
}

fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    let bytes = bytes.get(at..at + 4)?;
    Some(u32::from_le_bytes(bytes.try_into().ok()?))
}

fn u64_at(bytes: &[u8], at: usize) -> Option<u64> {
    let bytes = bytes.get(at..at + 8)?;
    Some(u64::from_le_bytes(bytes.try_into().ok()?))
}

#[cfg(test)]
mod tests;
