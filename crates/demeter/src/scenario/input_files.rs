//! The files that a scenario names, and what was in them: so that a run, a sweep or another process does not go on with others.

use super::Scenario;
use super::document::{Node, Value};
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Bytes that are read at a time.
const PIECE: usize = 1 << 16;

/// Length [bytes] and CRC-32 of what is in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Content {
    bytes: u64,
    pub checksum: u32,
}

/// A file that a scenario names, and what was in it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct InputFile {
    /// Where it is.
    pub path: PathBuf,
    /// Whether it tells grains of the start: it is not read again when a run goes on.
    pub of_start: bool,
    /// Nothing where it could not be read.
    content: Option<Content>,
}

impl InputFile {
    /// Reads what is in it.
    fn read(path: PathBuf, of_start: bool) -> Self {
        let content = content(&path).ok();
        Self {
            path,
            of_start,
            content,
        }
    }

    /// Whether another one, wherever it is, holds the same.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        (self.of_start, self.content) == (other.of_start, other.content)
    }

    /// What it holds now that it did not hold before, in words; nothing when it is as it was.
    pub fn change(&self) -> Option<String> {
        let now = content(&self.path).ok();
        let path = self.path.display();
        match (self.content, now) {
            (was, is) if was == is => None,
            (_, None) => Some(format!("`{path}` is gone, or cannot be read")),
            (Some(was), Some(is)) if was.bytes != is.bytes => {
                Some(format!("`{path}` had {} bytes and now has {}", was.bytes, is.bytes))
            }
            _ => Some(format!("`{path}` holds something else than before")),
        }
    }
}

/// Reads what is in a file, piece by piece.
pub(crate) fn content(path: &Path) -> std::io::Result<Content> {
    let mut file = File::open(path)?;
    let (mut bytes, mut checksum) = (0, crc32fast::Hasher::new());
    let mut piece = vec![0; PIECE];
    loop {
        match file.read(&mut piece)? {
            0 => break,
            length => {
                checksum.update(&piece[..length]);
                bytes += length as u64;
            }
        }
    }
    let checksum = checksum.finalize();
    Ok(Content { bytes, checksum })
}

impl Scenario {
    /// All files that it names, each once, with what is in them now.
    pub fn input_files(&self) -> Vec<InputFile> {
        let mut found: Vec<(PathBuf, bool)> = Vec::new();
        if let Value::Table(entries) = &self.document.root.value {
            for entry in entries {
                let mut named = Vec::new();
                collect(&entry.key, &entry.node, &mut named);
                for file in named {
                    let path = self.base.join(file);
                    let of_start = entry.key == "grains";
                    match found.iter_mut().find(|(known, _)| *known == path) {
                        Some((_, only_at_start)) => *only_at_start &= of_start,
                        None => found.push((path, of_start)),
                    }
                }
            }
        }
        let read = |(path, of_start)| InputFile::read(path, of_start);
        found.into_iter().map(read).collect()
    }
}

/// Files are told by the key `file`, wherever it stands.
fn collect<'n>(key: &str, node: &'n Node, found: &mut Vec<&'n str>) {
    match &node.value {
        Value::String(file) if key == "file" => found.push(file),
        Value::Table(entries) => entries.iter().for_each(|e| collect(&e.key, &e.node, found)),
        Value::Array(items) => items.iter().for_each(|item| collect("", item, found)),
        _ => {}
    }
}
