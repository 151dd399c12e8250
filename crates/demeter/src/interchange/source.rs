//! What is converted: a file of grains, a run, or one frame of it.

use super::error::ConvertError;
use super::run_frames::table_of_run;
use crate::grain_files::{GrainFile, GrainTable, ReadOptions};
use crate::results::{Moment, Run, TableKind};
use std::path::{Path, PathBuf};

/// Which moments are converted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Frames {
    /// All where the output holds many, else the last.
    #[default]
    Automatic,
    /// All of them.
    All,
    /// The last one.
    Last,
    /// One by its number, from 0.
    Number(usize),
}

/// What moments are read from.
pub struct Source {
    path: PathBuf,
    reading: ReadOptions,
    kind: Kind,
}

enum Kind {
    File {
        file: Box<GrainFile>,
        /// Moments taken so far.
        taken: usize,
    },
    Run {
        run: Run,
        moments: Vec<Moment>,
        /// What was noticed: frames that are gone, and why a moment that was read has no box.
        notes: Vec<String>,
    },
}

/// Numbers of the moments that are converted.
pub(super) enum Numbers {
    One(Option<usize>),
    From(usize),
}

impl Source {
    /// Opens a file of grains, the folder of a run, its `grains.pvd`, or one `.vtp` of its frames.
    pub fn open(path: &Path, reading: &ReadOptions) -> Result<Self, ConvertError> {
        if reading.format.is_none() && path.extension().is_some_and(|ending| ending == "toml") {
            return Err(ConvertError::Scenario { path: path.to_owned() });
        }
        let kind = match run_of(path) {
            None => Kind::File {
                file: Box::new(GrainFile::open(path, reading)?),
                taken: 0,
            },
            Some(OfRun { folder, frame }) => {
                let told = [
                    ("units", reading.units.is_some()),
                    ("diameter", reading.diameter.is_some()),
                    ("atom-style", reading.style.is_some()),
                ];
                if let Some((option, _)) = told.into_iter().find(|(_, told)| *told) {
                    return Err(ConvertError::NoEffect {
                        option,
                        why: "the frames of a run tell it",
                    });
                }
                let run = Run::open(&folder)?;
                let mut moments = run.moments()?;
                let mut notes = Vec::new();
                match frame {
                    None => notes.extend(run.missing_frames()?),
                    Some((kind, step)) if kind == TableKind::Grains.name() => {
                        moments.retain(|moment| moment.step == step);
                    }
                    Some((kind, step)) => {
                        return Err(ConvertError::NoGrains {
                            path: path.to_owned(),
                            kind,
                            grains: run.table_path(TableKind::Grains, step),
                        });
                    }
                }
                Kind::Run { run, moments, notes }
            }
        };
        Ok(Self {
            path: path.to_owned(),
            reading: reading.clone(),
            kind,
        })
    }

    /// What it is, in words.
    pub fn kind(&self) -> String {
        match &self.kind {
            Kind::File { file, .. } => file.format().to_string(),
            Kind::Run { .. } => "demeter".to_owned(),
        }
    }

    /// What was noticed while reading.
    pub fn notes(&self) -> Vec<String> {
        match &self.kind {
            Kind::File { file, .. } => file.notes().to_vec(),
            Kind::Run { notes, .. } => notes.clone(),
        }
    }

    /// The moments that are asked for.
    pub(super) fn numbers(&mut self, frames: Frames, many: bool) -> Result<Numbers, ConvertError> {
        let last = match frames {
            Frames::All => false,
            Frames::Automatic => !many,
            Frames::Last => true,
            Frames::Number(number) => return Ok(Numbers::One(Some(number))),
        };
        if !last {
            return Ok(Numbers::From(0));
        }
        let count = match &mut self.kind {
            Kind::Run { moments, .. } => moments.len(),
            Kind::File { file, .. } => {
                let mut count = 0;
                while file.skip_frame()? {
                    count += 1;
                }
                **file = GrainFile::open(&self.path, &self.reading)?;
                count
            }
        };
        Ok(Numbers::One(Some(count.saturating_sub(1))))
    }

    /// A moment by its number, which never goes back; nothing behind the last of several.
    pub fn table(&mut self, number: usize) -> Result<Option<GrainTable>, ConvertError> {
        match &mut self.kind {
            Kind::Run { run, moments, notes } => {
                let Some(moment) = moments.get(number) else {
                    return Ok(None);
                };
                let (table, why) = table_of_run(run, moment.step)?;
                notes.extend(why.filter(|why| !notes.contains(why)));
                Ok(Some(table))
            }
            Kind::File { file, taken } => {
                while *taken < number {
                    if !file.skip_frame()? {
                        return Ok(None);
                    }
                    *taken += 1;
                }
                *taken += 1;
                Ok(file.next_frame()?)
            }
        }
    }

    /// Number of moments taken or there.
    fn there(&self) -> usize {
        match &self.kind {
            Kind::Run { moments, .. } => moments.len(),
            Kind::File { taken, .. } => *taken,
        }
    }

    fn missing(&self, number: usize) -> ConvertError {
        let there = self.there().min(number);
        let lacks = match &self.kind {
            Kind::Run { notes, .. } => notes.clone(),
            Kind::File { .. } => Vec::new(),
        };
        ConvertError::NoMoment {
            path: self.path.clone(),
            number,
            there,
            lacks,
        }
    }
}

impl Numbers {
    /// The next number, as long as there is a moment of it. One that was asked for must be there.
    pub fn next(&mut self, source: &mut Source) -> Result<Option<usize>, ConvertError> {
        match self {
            Self::From(next) => {
                *next += 1;
                if let Kind::Run { moments, .. } = &source.kind
                    && moments.is_empty()
                {
                    return Err(source.missing(0));
                }
                Ok(Some(*next - 1))
            }
            Self::One(number) => {
                let Some(number) = number.take() else { return Ok(None) };
                let there = match &mut source.kind {
                    Kind::Run { moments, .. } => number < moments.len(),
                    Kind::File { file, taken } => {
                        let mut there = true;
                        while there && *taken < number {
                            there = file.skip_frame()?;
                            *taken += usize::from(there);
                        }
                        there && !file.at_end()?
                    }
                };
                if there {
                    Ok(Some(number))
                } else {
                    Err(source.missing(number))
                }
            }
        }
    }
}

/// The run that a path is of.
struct OfRun {
    folder: PathBuf,
    /// What a table of a single frame is of, and its step.
    frame: Option<(&'static str, u64)>,
}

fn run_of(path: &Path) -> Option<OfRun> {
    let whole = |folder| Some(OfRun { folder, frame: None });
    if path.is_dir() {
        return whole(path.to_owned());
    }
    let name = path.file_name()?.to_string_lossy().into_owned();
    let folder = || {
        path.parent().map(|parent| {
            if parent.as_os_str().is_empty() {
                Path::new(".")
            } else {
                parent
            }
        })
    };
    if name.ends_with(".pvd") {
        return whole(folder()?.to_owned());
    }
    let (told, step) = name.strip_suffix(".vtp")?.rsplit_once('_')?;
    let kind = TableKind::ALL
        .map(TableKind::name)
        .into_iter()
        .find(|kind| *kind == told)?;
    Some(OfRun {
        folder: folder()?.join(".."),
        frame: Some((kind, step.parse().ok()?)),
    })
}
