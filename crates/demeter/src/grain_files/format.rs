//! The formats: names, endings, and how each is known by its content.

use super::table::Cell;
use super::{dump, extended_xyz, lammps_data, yade};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::path::Path;
use std::str::FromStr;

/// A format of files of grains.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Format {
    /// Named columns: commas, semicolons, tabs or blanks.
    Columns,
    /// Data file of LAMMPS, `read_data` and `write_data`.
    LammpsData,
    /// Data file of LIGGGHTS; differs in what the program accepts.
    LiggghtsData,
    /// Text dump of LAMMPS, with time and units.
    LammpsDump,
    /// Text dump of LIGGGHTS.
    LiggghtsDump,
    /// Extended XYZ, for OVITO and ASE.
    ExtendedXyz,
    /// Text packing of YADE.
    Yade,
}

/// Formats, the names that tell them, and the endings of files.
const NAMES: [(Format, &str, &[&str]); 7] = [
    (Format::Columns, "csv", &["csv", "tsv"]),
    (Format::LammpsData, "lammps-data", &["data", "lammps", "lmp"]),
    (Format::LiggghtsData, "liggghts-data", &["liggghts"]),
    (Format::LammpsDump, "lammps-dump", &["dump", "lammpstrj"]),
    (Format::LiggghtsDump, "liggghts-dump", &[]),
    (Format::ExtendedXyz, "xyz", &["xyz", "extxyz"]),
    (Format::Yade, "yade", &["yade", "spheres"]),
];

impl Format {
    /// All formats.
    pub const ALL: [Self; 7] = [
        Self::Columns,
        Self::LammpsData,
        Self::LiggghtsData,
        Self::LammpsDump,
        Self::LiggghtsDump,
        Self::ExtendedXyz,
        Self::Yade,
    ];

    /// Its name on the command line.
    pub fn name(self) -> &'static str {
        NAMES
            .iter()
            .find(|(format, ..)| *format == self)
            .map_or("", |(_, name, _)| name)
    }

    /// The names of all formats.
    pub fn names() -> impl Iterator<Item = &'static str> {
        NAMES.iter().map(|(_, name, _)| *name)
    }

    /// The format that the ending of a file tells, `.gz` left out.
    pub fn of_path(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_string_lossy().to_lowercase();
        let name = name.strip_suffix(".gz").unwrap_or(&name);
        let (_, ending) = name.rsplit_once('.')?;
        NAMES
            .iter()
            .find(|(.., endings)| endings.contains(&ending))
            .map(|(format, ..)| *format)
    }

    /// The format of a text, by how it starts; columns when it starts like no other.
    pub fn of_text(start: &str) -> Self {
        match start {
            _ if dump::looks_like(start) => Self::LammpsDump,
            _ if yade::looks_like(start) => Self::Yade,
            _ if extended_xyz::looks_like(start) => Self::ExtendedXyz,
            _ if lammps_data::looks_like(start) => Self::LammpsData,
            _ => Self::Columns,
        }
    }

    /// Whether it can tell a box: LIGGGHTS knows none with edges in any direction.
    pub(super) fn knows_box(self, cell: &Cell) -> bool {
        match self {
            Self::Columns | Self::Yade => false,
            Self::LiggghtsData | Self::LiggghtsDump => !cell.is_general(),
            Self::LammpsData | Self::LammpsDump | Self::ExtendedXyz => true,
        }
    }

    /// Whether one file holds several moments.
    pub fn holds_many(self) -> bool {
        matches!(self, Self::LammpsDump | Self::LiggghtsDump | Self::ExtendedXyz)
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The code whose binary restart file starts so.
pub fn restart_of(start: &[u8]) -> Option<&'static str> {
    const OF_LIGGGHTS: &[u8] = b"Version LIGGGHTS";
    let head = &start[..start.len().min(64)];
    match head {
        _ if head.starts_with(b"LammpS RestartT") => Some("LAMMPS"),
        [0, ..] if head.windows(OF_LIGGGHTS.len()).any(|part| part == OF_LIGGGHTS) => Some("LIGGGHTS"),
        _ => None,
    }
}

/// A name that is no format's.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{name}` is no format; there are {}", Format::names().collect::<Vec<_>>().join(", "))]
pub struct UnknownFormat {
    name: String,
}

impl FromStr for Format {
    type Err = UnknownFormat;

    fn from_str(name: &str) -> Result<Self, UnknownFormat> {
        let found = NAMES.iter().find(|(_, known, _)| *known == name);
        found.map(|(format, ..)| *format).ok_or_else(|| UnknownFormat {
            name: super::numbers::shown(name),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_are_told_by_name_and_by_content() {
        for format in Format::ALL {
            assert_eq!(format.name().parse(), Ok(format));
        }
        for (name, format) in [
            ("a.data", Some(Format::LammpsData)),
            ("x/b.DUMP.gz", Some(Format::LammpsDump)),
            ("c.extxyz", Some(Format::ExtendedXyz)),
            ("d.txt", None),
            ("data", None),
        ] {
            assert_eq!(Format::of_path(Path::new(name)), format, "{name}");
        }
        for (text, format) in [
            ("ITEM: TIMESTEP\n", Format::LammpsDump),
            ("#format x_y_z_r\n0 0 0 1\n", Format::Yade),
            ("2\nLattice=\"1 0 0 0 1 0 0 0 1\"\n", Format::ExtendedXyz),
            ("1\n\nH 0 0 0\n", Format::ExtendedXyz),
            ("any title\n\n12 atoms\n", Format::LammpsData),
            ("x,y,z,diameter\n", Format::Columns),
            ("", Format::Columns),
        ] {
            assert_eq!(Format::of_text(text), format, "{text}");
        }
    }
}
