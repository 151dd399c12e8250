//! A file of grains, read moment by moment.

use super::error::{FileError, FileProblem, Located, Location};
use super::format::{Format, restart_of};
use super::lines::Lines;
use super::table::GrainTable;
use super::units::FileUnits;
use super::{columns, dump, extended_xyz, lammps_data, yade};
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::path::{Path, PathBuf};

/// What a file does not tell itself.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ReadOptions {
    /// Its format; told by its content when absent.
    pub format: Option<Format>,
    /// Its units; those that the file names, else SI.
    pub units: Option<FileUnits>,
    /// Diameter of all grains of a file that tells no sizes [m].
    pub diameter: Option<f64>,
    /// Atom style of a data file, in place of the one that it names.
    pub style: Option<String>,
    /// Whether lengths are scaled on top: the file must be in SI, or in units that are told.
    pub scaled: bool,
    /// Whether materials of its types are told; labels that it gives its types are then left out.
    pub types_told: bool,
    /// Whether columns that are no quantity of grains are taken as they are; else there are none in CSV, and tags are those of grains.
    pub extra_columns: bool,
}

/// Which moment of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Which {
    /// The last one.
    #[default]
    Last,
    /// One by its number, from 0.
    Number(usize),
}

/// What was noticed while reading, once each.
#[derive(Debug, Default)]
pub(super) struct Notes(Vec<String>);

impl Notes {
    /// Notes columns that are no quantities of grains.
    pub fn add_extras(&mut self, extras: &[(String, String)]) {
        let names: Vec<&str> = extras.iter().map(|(name, _)| name.as_str()).collect();
        if !names.is_empty() {
            self.add(format!(
                "columns that are no quantities of grains are carried over as they are: {}",
                names.join(", ")
            ));
        }
    }

    pub fn add(&mut self, note: String) {
        const MOST: usize = 100;
        if self.0.len() < MOST && !self.0.contains(&note) {
            self.0.push(note);
        }
    }
}

/// What the readers of all formats share.
pub(super) struct Context {
    pub options: ReadOptions,
    /// Units that an earlier moment of the file named: dumps name them once.
    named: std::cell::Cell<Option<FileUnits>>,
}

impl Context {
    fn new(options: &ReadOptions) -> Self {
        Self {
            options: options.clone(),
            named: std::cell::Cell::new(None),
        }
    }

    /// The units of a file that may name a unit style.
    pub fn units(&self, named: Option<&str>, notes: &mut Notes) -> Result<FileUnits, FileProblem> {
        let known = named.and_then(FileUnits::style);
        match (self.options.units.or(self.named.get()), named) {
            (Some(units), Some(name)) if known.is_some_and(|known| !known.are(&units)) => {
                Err(FileProblem::OtherUnits {
                    found: name.to_owned(),
                    told: units,
                })
            }
            (Some(units), _) => Ok(units),
            (None, Some(name)) => {
                let units = known.ok_or_else(|| FileProblem::Units { found: name.to_owned() })?;
                if self.options.scaled && !units.are(&FileUnits::SI) {
                    return Err(FileProblem::ScaledUnits { found: name.to_owned() });
                }
                self.named.set(Some(units));
                Ok(units)
            }
            (None, None) => {
                notes.add("the file names no units; its numbers are taken as SI".to_owned());
                Ok(FileUnits::SI)
            }
        }
    }
}

/// A file of grains that is being read.
pub struct GrainFile {
    path: PathBuf,
    lines: Lines<'static>,
    format: Format,
    context: Context,
    notes: Notes,
    /// Moments read or left out so far.
    count: usize,
    ended: bool,
}

impl GrainFile {
    /// Opens a file, of which nothing is read but its start.
    pub fn open(path: &Path, options: &ReadOptions) -> Result<Self, FileError> {
        let fails = |problem: FileProblem| Located::from(problem).in_file(path);
        let file = File::open(path).map_err(|e| fails(e.into()))?;
        if !file.metadata().map_err(|e| fails(e.into()))?.is_file() {
            return Err(fails(FileProblem::NotAFile));
        }
        let mut lines = Lines::new(file).map_err(fails)?;
        let start = lines.start().map_err(fails)?;
        if start.trim_start().starts_with("<VTKFile") || start.trim_start().starts_with("<?xml") {
            return Err(fails(FileProblem::OwnFile));
        }
        if let Some(code) = restart_of(start.as_bytes()) {
            return Err(fails(FileProblem::Restart { code }));
        }
        Ok(Self {
            path: path.to_owned(),
            lines,
            format: options.format.unwrap_or_else(|| Format::of_text(&start)),
            context: Context::new(options),
            notes: Notes::default(),
            count: 0,
            ended: false,
        })
    }

    /// Its format.
    pub fn format(&self) -> Format {
        self.format
    }

    /// What was left out or taken for granted so far.
    pub fn notes(&self) -> &[String] {
        &self.notes.0
    }

    /// Reads the next moment; nothing at the end.
    pub fn next_frame(&mut self) -> Result<Option<GrainTable>, FileError> {
        if self.ended {
            return Ok(None);
        }
        self.lines.begin_frame();
        let (lines, context, notes) = (&mut self.lines, &self.context, &mut self.notes);
        let read = match self.format {
            Format::LammpsDump | Format::LiggghtsDump => dump::read(lines, context, notes),
            Format::ExtendedXyz => extended_xyz::read(lines, context, notes),
            Format::LammpsData | Format::LiggghtsData => lammps_data::read(lines, context, notes).map(Some),
            Format::Yade => yade::read(lines, context, notes).map(Some),
            Format::Columns => columns::read(lines, context, notes).map(Some),
        };
        let frame = read.map_err(|located| located.in_file(&self.path))?;
        self.ended = frame.is_none() || !self.format.holds_many();
        self.count += usize::from(frame.is_some());
        self.not_empty(frame.is_none())?;
        if let Some(table) = &frame {
            self.refuse_in_vain(table)
                .map_err(|problem| Located::from(problem).in_file(&self.path))?;
        }
        Ok(frame)
    }

    /// Options are refused that nothing comes of, since the file tells otherwise.
    fn refuse_in_vain(&self, table: &GrainTable) -> Result<(), FileProblem> {
        let options = &self.context.options;
        let (option, why) = if options
            .diameter
            .is_some_and(|told| table.diameters.iter().any(|d| *d != told))
        {
            ("diameter", "the file tells the size of every grain")
        } else if options.style.is_some() && !matches!(self.format, Format::LammpsData | Format::LiggghtsData) {
            ("atom_style", "only data files of LAMMPS and LIGGGHTS have one")
        } else {
            return Ok(());
        };
        Err(FileProblem::NoEffect { option, why })
    }

    /// Takes the next moment without reading its grains; tells whether there was one.
    pub fn skip_frame(&mut self) -> Result<bool, FileError> {
        if self.ended {
            return Ok(false);
        }
        self.lines.begin_frame();
        let skipped = match self.format {
            Format::LammpsDump | Format::LiggghtsDump => dump::skip(&mut self.lines, &self.context, &mut self.notes),
            Format::ExtendedXyz => extended_xyz::skip(&mut self.lines),
            _ => Ok(true),
        };
        let there = skipped.map_err(|located| located.in_file(&self.path))?;
        self.ended = !there || !self.format.holds_many();
        self.count += usize::from(there);
        self.not_empty(!there)?;
        Ok(there)
    }

    /// Whether nothing but blank lines is left.
    pub fn at_end(&mut self) -> Result<bool, FileError> {
        if self.ended || !self.format.holds_many() {
            return Ok(self.ended);
        }
        loop {
            let next = self.lines.peek().map_err(|located| located.in_file(&self.path))?;
            match next.map(|(_, line)| line.trim().is_empty()) {
                None => return Ok(true),
                Some(false) => return Ok(false),
                Some(true) => {}
            }
            self.lines.skip(1).map_err(|located| located.in_file(&self.path))?;
        }
    }

    /// A file without a moment is refused.
    fn not_empty(&self, at_end: bool) -> Result<(), FileError> {
        match at_end && self.count == 0 {
            true => Err(Located::from(FileProblem::NoGrains).in_file(&self.path)),
            false => Ok(()),
        }
    }
}

/// Reads one moment of a file.
pub fn read_grain_file(path: &Path, options: &ReadOptions, which: Which) -> Result<GrainTable, FileError> {
    let mut file = GrainFile::open(path, options)?;
    let number = match which {
        Which::Number(number) => number,
        Which::Last if file.format.holds_many() => {
            while file.skip_frame()? {}
            let last = file.count.saturating_sub(1);
            file = GrainFile::open(path, options)?;
            last
        }
        Which::Last => 0,
    };
    let missing = |there| FileError {
        path: path.to_owned(),
        location: Location::default(),
        problem: Box::new(FileProblem::NoFrame { number, there }),
    };
    for there in 0..number {
        if !file.skip_frame()? {
            return Err(missing(there));
        }
    }
    let table = file.next_frame()?.ok_or_else(|| missing(number))?;
    match table.is_empty() {
        true => Err(FileError {
            problem: Box::new(FileProblem::NoGrainsYet { number }),
            ..missing(number)
        }),
        false => Ok(table),
    }
}

/// Reads the first moment of a text.
#[cfg(test)]
pub(super) fn parse(text: &str) -> Result<GrainTable, Located> {
    parse_as(text, &ReadOptions::default())
}

/// Reads the first moment of a text.
#[cfg(test)]
pub(super) fn parse_as(text: &str, options: &ReadOptions) -> Result<GrainTable, Located> {
    let mut lines = Lines::of(text);
    let format = options
        .format
        .unwrap_or_else(|| Format::of_text(&lines.start().unwrap()));
    let context = Context::new(options);
    let notes = &mut Notes::default();
    let frame = match format {
        Format::LammpsDump | Format::LiggghtsDump => dump::read(&mut lines, &context, notes)?,
        Format::ExtendedXyz => extended_xyz::read(&mut lines, &context, notes)?,
        Format::LammpsData | Format::LiggghtsData => Some(lammps_data::read(&mut lines, &context, notes)?),
        Format::Yade => Some(yade::read(&mut lines, &context, notes)?),
        Format::Columns => Some(columns::read(&mut lines, &context, notes)?),
    };
    frame.ok_or_else(|| FileProblem::NoGrains.into())
}
