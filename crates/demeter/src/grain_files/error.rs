//! What is wrong with a file of grains, and where.

use super::lines::{MAX_EMPTY_LINES, MAX_FRAME_BYTES, MAX_LINE_BYTES};
use super::units::FileUnits;
use std::fmt;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// A grain file that cannot be used.
#[derive(Debug, Error)]
#[error("{}{location}: {problem}", path.display())]
pub struct FileError {
    /// The file.
    pub path: PathBuf,
    /// Where in it.
    pub location: Location,
    /// What is wrong.
    pub problem: Box<FileProblem>,
}

/// Place in a text file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Location {
    /// Line, from 1.
    pub line: Option<usize>,
    /// Name of the column.
    pub column: Option<String>,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(line) = self.line {
            write!(f, ", line {line}")?;
        }
        if let Some(column) = &self.column {
            write!(f, ", column `{column}`")?;
        }
        Ok(())
    }
}

/// What is wrong with a grain file.
#[derive(Debug, Error)]
#[allow(missing_docs)]
pub enum FileProblem {
    #[error("cannot be read: {0}")]
    Read(#[from] std::io::Error),
    #[error("is not a regular file; give the path of a text file with grains")]
    NotAFile,
    #[error("a moment of it is larger than {MAX_FRAME_BYTES} bytes, the most that is read")]
    FrameTooLarge,
    #[error("is longer than {MAX_LINE_BYTES} bytes, the most that a line may have")]
    LineTooLong,
    #[error(
        "is one of {MAX_EMPTY_LINES} empty lines and more, one after the other: nothing that is read has so many; leave them out"
    )]
    Empty,
    #[error("is compressed and damaged: {0}")]
    Compressed(String),
    #[error("is not text (byte {position} is not UTF-8); save it as text")]
    NotText { position: usize },
    #[error("there are no grains in it")]
    NoGrains,
    #[error("there are no grains in its moment {number}; tell the number of another")]
    NoGrainsYet { number: usize },
    #[error(
        "a grain is on every line after the header, but this line starts with `{found}`; put a header such as `x y z diameter` first"
    )]
    NoHeader { found: String },
    #[error("`{name}` is not a known column; known are {known}")]
    UnknownColumn { name: String, known: String },
    #[error("`{name}` is told twice (also as `{other}`); keep one of them")]
    TwiceColumn { name: String, other: String },
    #[error(
        "column `{name}` is missing; needed are x, y, z and diameter (or radius), and of the components of a velocity, an angular velocity, a force or a torque all or none"
    )]
    MissingColumn { name: &'static str },
    #[error("unit `{unit}` is not known here; allowed: {allowed}")]
    UnknownUnit { unit: String, allowed: String },
    #[error("{found} values where {expected} are needed")]
    ValueCount { found: usize, expected: String },
    #[error("`{text}` is not a number")]
    NotANumber { text: String },
    #[error("`{text}` is not allowed; {allowed}")]
    NotAllowed { text: String, allowed: &'static str },
    #[error(
        "{mass:?} kg and the size make {of_mass:.5e} kg/m^3, and the density is told as {density:?} kg/m^3; correct one of \
         them or its unit, or leave one column out"
    )]
    MassAgainstDensity { mass: f64, of_mass: f64, density: f64 },
    #[error("id {id} is there twice; every grain needs an id of its own")]
    DuplicateId { id: u32 },
    #[error("material `{name}` does not exist; known are {known}")]
    UnknownMaterial { name: String, known: String },
    #[error("grain {number} is of type {found}, but the insertion gives materials for types 1 to {known}; add one")]
    TypeWithoutMaterial { number: usize, found: u32, known: usize },
    #[error(
        "the header does not tell `{what}`; a data file of atom_style sphere starts with lines such as `514 atoms` and `0 0.1 xlo xhi`"
    )]
    HeaderMissing { what: &'static str },
    #[error("`{what}` is told twice in the header")]
    HeaderTwice { what: String },
    #[error(
        "`{text}` is not known in the header of a data file; is it a section? Known sections are Atoms and Velocities"
    )]
    UnknownHeader { text: String },
    #[error("{what} is not read; only spheres are")]
    NotSpheres { what: String },
    #[error(
        "section `{name}` is not known; read are Atoms and Velocities, and those of masses, coefficients and bonds are left out"
    )]
    UnknownSection { name: String },
    #[error("section `{name}` is there twice")]
    TwiceSection { name: &'static str },
    #[error("type {number} has two labels, `{}` and `{}`; keep one of them", labels[0], labels[1])]
    TwoLabels { number: u32, labels: [String; 2] },
    #[error("section `{name}` is missing; is the file cut short?")]
    MissingSection { name: &'static str },
    #[error("section `Velocities` stands before `Atoms`; move it behind")]
    AtomsBehind,
    #[error("section `{name}` has {found} lines, but the header tells {expected} atoms; is the file cut short?")]
    CutShort {
        name: &'static str,
        found: usize,
        expected: usize,
    },
    #[error("section `{name}` has more lines than the {expected} atoms that the header tells")]
    TooManyLines { name: &'static str, expected: usize },
    #[error("the atom style is `{style}`, and `{part}` of it is not known here; known are {known}")]
    Style { style: String, part: String, known: String },
    #[error(
        "the file does not tell the parts of its style hybrid; tell them, as `hybrid sphere charge` (`atom_style` in a scenario, \
         `--atom-style` of `demeter convert`)"
    )]
    Hybrid,
    #[error("{found} values; an atom of atom_style {style} has {expected} ({columns}) or {} (and 3 image flags)", expected + 3)]
    AtomValues {
        found: usize,
        expected: usize,
        style: String,
        columns: String,
    },
    #[error(
        "the file tells no sizes; tell the diameter of all grains (`diameter = \"1 mm\"` in a scenario, `--diameter \"1 mm\"` of `demeter convert`)"
    )]
    NoSizes,
    #[error("`{option}` is told and has no effect: {why}; leave it out")]
    NoEffect { option: &'static str, why: &'static str },
    #[error(
        "the file is in `{found}` units of LAMMPS; tell what they are here: `si`, `cgs`, `micro`, `nano`, or the units of length, mass and time, as `mm,g,ms` (`units` in a scenario, `--units` of `demeter convert`)"
    )]
    Units { found: String },
    #[error(
        "the file is in `{found}` units of LAMMPS, and `{told}` was told; leave that out (`units` in a scenario, `--units` of `demeter \
         convert`), or correct the file"
    )]
    OtherUnits { found: String, told: FileUnits },
    #[error(
        "the file is in `{found}` units of LAMMPS and is read in them, and `scale` would act on top; leave it out, or tell \
         `units = \"{found}\"` beside it where both are meant"
    )]
    ScaledUnits { found: String },
    #[error("`{found}` stands where {expected} is needed")]
    Expected { found: String, expected: &'static str },
    #[error("the file ends where {expected} is needed; is it cut short?")]
    Ends { expected: &'static str },
    #[error("{found} rows where {expected} are told; is the file cut short?")]
    FrameCutShort { found: usize, expected: u64 },
    #[error("{what} is not read; {remedy}")]
    NotRead { what: String, remedy: &'static str },
    #[error("there is no moment number {number}; there are {there}")]
    NoFrame { number: usize, there: usize },
    #[error(
        "is a frame or a folder of Demeter; `demeter convert` makes a file of grains of it (`demeter convert RUN grains.csv`), a frame in the \
         folder of its run and with its name there"
    )]
    OwnFile,
    #[error(
        "is a binary restart file of {code}, which only {code} reads; make a data file of it: `write_data FILE` in the script that wrote \
         it, or `lmp -restart2data RESTART FILE` of LAMMPS"
    )]
    Restart { code: &'static str },
    #[error("there is no atom with id {id}")]
    UnknownId { id: u32 },
}

/// A problem and its place, before the file is named.
#[derive(Debug, Error)]
#[error("{location}: {problem}")]
pub(crate) struct Located {
    pub location: Location,
    pub problem: FileProblem,
}

impl Located {
    pub fn in_file(self, path: &Path) -> FileError {
        FileError {
            path: path.to_owned(),
            location: self.location,
            problem: Box::new(self.problem),
        }
    }
}

impl From<FileProblem> for Located {
    fn from(problem: FileProblem) -> Self {
        Self {
            location: Location::default(),
            problem,
        }
    }
}

impl FileProblem {
    pub(crate) fn at(self, line: usize, column: Option<&str>) -> Located {
        Located {
            location: Location {
                line: Some(line),
                column: column.map(str::to_owned),
            },
            problem: self,
        }
    }
}
