//! Grains from files. Files are not trusted: size, numbers and ids are checked before anything is made of them.

use super::spec::{Insertion, Source};
use super::{Inserted, InsertionProblem, file_columns, file_lammps};
use crate::materials::Material;
use crate::particles::NewGrain;
use glam::DVec3;
use std::fmt;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use thiserror::Error;

/// Largest grain file that is read [bytes].
pub const MAX_FILE_BYTES: u64 = 1 << 30;
/// Range of diameters of a file [m].
const DIAMETERS: std::ops::RangeInclusive<f64> = super::size_distribution::DIAMETERS;
/// Largest magnitude of any other number of a file.
const LARGEST: f64 = super::region::LARGEST_LENGTH;

/// What a grain file tells, in SI units.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GrainTable {
    /// Ids, all different, at least 1.
    pub ids: Option<Vec<u32>>,
    /// Types or materials.
    pub types: Option<Vec<TypeOfGrain>>,
    /// Names that [`TypeOfGrain::Name`] points to.
    pub type_names: Vec<String>,
    /// Centres [m].
    pub positions: Vec<DVec3>,
    /// Diameters [m].
    pub diameters: Vec<f64>,
    /// Densities [kg/m^3].
    pub densities: Option<Vec<f64>>,
    /// Velocities [m/s].
    pub velocities: Option<Vec<DVec3>>,
    /// Angular velocities [1/s].
    pub angular_velocities: Option<Vec<DVec3>>,
    /// Lower and upper corner of the box of the file [m].
    pub bounds: Option<(DVec3, DVec3)>,
}

/// How a file names the material of a grain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TypeOfGrain {
    /// A type number, from 1.
    Number(u32),
    /// A name: index into [`GrainTable::type_names`].
    Name(u32),
}

/// A grain file that cannot be used.
#[derive(Debug, Error)]
#[error("{}{location}: {problem}", path.display())]
pub struct FileError {
    /// The file.
    pub path: PathBuf,
    /// Where in it.
    pub location: Location,
    /// What is wrong.
    pub problem: FileProblem,
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
    #[error("is larger than {MAX_FILE_BYTES} bytes, the most that is read; split it into several insertions")]
    TooLarge,
    #[error("is not text (byte {position} is not UTF-8); save it as text")]
    NotText { position: usize },
    #[error(
        "is a LAMMPS dump; write a data file instead (`write_data`), or columns with a header line `id x y z diameter`"
    )]
    Dump,
    #[error("there are no grains in it")]
    NoGrains,
    #[error(
        "a grain is on every line after the header, but this line starts with `{found}`; put a header such as `x y z diameter` first"
    )]
    NoHeader { found: String },
    #[error("`{name}` is not a known column; known are {known}")]
    UnknownColumn { name: String, known: String },
    #[error("`{name}` is told twice (also as `{other}`); keep one of them")]
    TwiceColumn { name: String, other: String },
    #[error(
        "column `{name}` is missing; needed are x, y, z and diameter (or radius), and of vx, vy, vz or wx, wy, wz all or none"
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
    #[error("{what} is not read; only spheres in a rectangular box are")]
    NotSpheres { what: String },
    #[error(
        "section `{name}` is not read; known are Atoms and Velocities (`write_data FILE nocoeff` leaves out the others)"
    )]
    UnknownSection { name: String },
    #[error("section `{name}` is there twice")]
    TwiceSection { name: &'static str },
    #[error("section `{name}` is missing; is the file cut short?")]
    MissingSection { name: &'static str },
    #[error("section `{name}` has {found} lines, but the header tells {expected} atoms; is the file cut short?")]
    CutShort {
        name: &'static str,
        found: usize,
        expected: usize,
    },
    #[error("section `{name}` has more lines than the {expected} atoms that the header tells")]
    TooManyLines { name: &'static str, expected: usize },
    #[error("the atom style is `{style}`; only sphere is read")]
    Style { style: String },
    #[error(
        "{found} values; an atom of atom_style sphere has 7 (id type diameter density x y z) or 10 (and 3 image flags)"
    )]
    AtomValues { found: usize },
    #[error("there is no atom with id {id}")]
    UnknownId { id: u32 },
}

/// A problem and its place, before the file is named.
#[derive(Debug)]
pub(super) struct Located {
    pub(super) location: Location,
    pub(super) problem: FileProblem,
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
    pub(super) fn at(self, line: usize, column: Option<&str>) -> Located {
        Located {
            location: Location {
                line: Some(line),
                column: column.map(str::to_owned),
            },
            problem: self,
        }
    }
}

/// The start of a text, for messages.
pub(super) fn shown(text: &str) -> String {
    const MOST: usize = 60;
    let mut start: String = text
        .chars()
        .take(MOST)
        .map(|c| if c.is_control() { '?' } else { c })
        .collect();
    if text.chars().nth(MOST).is_some() {
        start.push_str("...");
    }
    start
}

/// Reads a finite number of magnitude up to 1e12.
pub(super) fn number(text: &str) -> Result<f64, FileProblem> {
    let value: f64 = text
        .parse()
        .map_err(|_| FileProblem::NotANumber { text: shown(text) })?;
    match value.abs() <= LARGEST {
        true => Ok(value),
        false => Err(not_allowed(text, "allowed are numbers of magnitude up to 1e12")),
    }
}

/// Reads an id or a type.
pub(super) fn whole(text: &str) -> Result<u32, FileProblem> {
    match text.parse() {
        Ok(value @ 1..) => Ok(value),
        _ => Err(not_allowed(text, "allowed are whole numbers from 1 to 4294967295")),
    }
}

pub(super) fn not_allowed(text: &str, allowed: &'static str) -> FileProblem {
    FileProblem::NotAllowed {
        text: shown(text),
        allowed,
    }
}

/// Checks a diameter [m] that was read from `text`.
pub(super) fn diameter(value: f64, text: &str) -> Result<f64, FileProblem> {
    match DIAMETERS.contains(&value) {
        true => Ok(value),
        false => Err(not_allowed(text, "allowed are diameters from 1e-12 m to 1e6 m")),
    }
}

/// Checks a density that was read from `text`.
pub(super) fn density(value: f64, text: &str) -> Result<f64, FileProblem> {
    match value >= 1e-12 {
        true => Ok(value),
        false => Err(not_allowed(text, "allowed are densities from 1e-12 to 1e12 kg/m^3")),
    }
}

/// Checks that all ids differ; `line_of` tells the line of a grain.
pub(super) fn check_ids(ids: &[u32], line_of: impl Fn(usize) -> usize) -> Result<(), Located> {
    let mut order: Vec<u32> = (0..ids.len() as u32).collect();
    order.sort_by_key(|i| ids[*i as usize]);
    for pair in order.windows(2) {
        let (before, grain) = (pair[0] as usize, pair[1] as usize);
        if ids[before] == ids[grain] {
            return Err(FileProblem::DuplicateId { id: ids[grain] }.at(line_of(grain), None));
        }
    }
    Ok(())
}

/// Reads a grain file: columns with a header, or a LAMMPS/LIGGGHTS data file of `atom_style sphere`, told by content.
pub fn read_grain_file(path: &Path) -> Result<GrainTable, FileError> {
    let read = || {
        let text = read_text(path)?;
        parse(&text)
    };
    read().map_err(|located: Located| FileError {
        path: path.to_owned(),
        location: located.location,
        problem: located.problem,
    })
}

/// Reads grains from the text of a file.
pub(super) fn parse(text: &str) -> Result<GrainTable, Located> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim_start().starts_with("ITEM:") {
        return Err(FileProblem::Dump.into());
    }
    match file_lammps::looks_like(text) {
        true => file_lammps::parse(text),
        false => file_columns::parse(text),
    }
}

fn read_text(path: &Path) -> Result<String, FileProblem> {
    let file = File::open(path)?;
    let metadata = file.metadata()?;
    if !metadata.is_file() {
        return Err(FileProblem::NotAFile);
    }
    if metadata.len() > MAX_FILE_BYTES {
        return Err(FileProblem::TooLarge);
    }
    let mut bytes = Vec::new();
    // The file may grow while it is read.
    file.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_FILE_BYTES {
        return Err(FileProblem::TooLarge);
    }
    String::from_utf8(bytes).map_err(|error| FileProblem::NotText {
        position: error.utf8_error().valid_up_to() + 1,
    })
}

/// Grains of a file with the settings of the insertion. The scale acts on every length, and so on velocities too.
pub(super) fn insert_file(insertion: &Insertion, materials: &[Material]) -> Result<Inserted, InsertionProblem> {
    let Source::File {
        path,
        keep_velocities,
        density,
        scale,
        shift,
    } = &insertion.source
    else {
        return Ok(Inserted::default());
    };
    check_settings(*density, *scale, *shift)?;
    let table = read_grain_file(path)?;
    let located = |problem| FileError {
        path: path.clone(),
        location: Location::default(),
        problem,
    };
    let kinds = materials_of(&table, insertion, materials).map_err(located)?;
    let mut grains = Vec::with_capacity(table.positions.len());
    for (k, &material) in kinds.iter().enumerate() {
        let moving = |values: &Option<Vec<DVec3>>| match values {
            Some(values) if *keep_velocities => values[k],
            _ => DVec3::ZERO,
        };
        let own_density = table.densities.as_ref().map(|values| values[k]);
        let diameter_value = table.diameters[k] * scale;
        diameter(
            diameter_value,
            &format!("{diameter_value:e} m (grain {}, scaled)", k + 1),
        )
        .map_err(located)?;
        let position = table.positions[k] * *scale + *shift;
        if position.abs().max_element() > LARGEST {
            let text = format!("position of grain {} after scale and shift", k + 1);
            return Err(located(not_allowed(&text, "coordinates must be within 1e12 m")).into());
        }
        grains.push(NewGrain {
            fixed: false,
            material,
            radius: 0.5 * diameter_value,
            density: (density.or(own_density)).unwrap_or(materials[usize::from(material)].density),
            position,
            velocity: moving(&table.velocities) * *scale,
            angular_velocity: moving(&table.angular_velocities),
        });
    }
    Ok(Inserted { grains, ids: table.ids })
}

fn check_settings(density: Option<f64>, scale: f64, shift: DVec3) -> Result<(), InsertionProblem> {
    let setting = |what, value, allowed| Err(InsertionProblem::FileSetting { what, value, allowed });
    if let Some(value) = density
        && !(1e-12..=LARGEST).contains(&value)
    {
        return setting("the density", value, "allowed are 1e-12 to 1e12 kg/m^3");
    }
    if !(1e-12..=LARGEST).contains(&scale) {
        return setting("the scale", scale, "allowed are factors from 1e-12 to 1e12");
    }
    let outside = |value: &f64| !(0.0..=LARGEST).contains(&value.abs());
    match shift.to_array().into_iter().find(outside) {
        Some(value) => setting("a component of the shift", value, "it must be a number within 1e12 m"),
        None => Ok(()),
    }
}

/// Material of every grain. Names are those of materials; numbers are types of the insertion, or nothing when it has
/// no types.
fn materials_of(table: &GrainTable, insertion: &Insertion, materials: &[Material]) -> Result<Vec<u16>, FileProblem> {
    let mut named = Vec::with_capacity(table.type_names.len());
    for name in &table.type_names {
        let found = materials.iter().position(|m| m.name == *name);
        named.push(found.ok_or_else(|| FileProblem::UnknownMaterial {
            name: shown(name),
            known: materials.iter().map(|m| m.name.as_str()).collect::<Vec<_>>().join(", "),
        })? as u16);
    }
    let Some(types) = &table.types else {
        return Ok(vec![insertion.material; table.positions.len()]);
    };
    let material_of = |(k, kind): (usize, &TypeOfGrain)| match *kind {
        TypeOfGrain::Name(index) => Ok(named[index as usize]),
        TypeOfGrain::Number(_) if insertion.types.is_empty() => Ok(insertion.material),
        TypeOfGrain::Number(found) => {
            (insertion.types.get(found as usize - 1).copied()).ok_or(FileProblem::TypeWithoutMaterial {
                number: k + 1,
                found,
                known: insertion.types.len(),
            })
        }
    };
    types.iter().enumerate().map(material_of).collect()
}
