//! The atom styles of LAMMPS and LIGGGHTS: which columns a line of the section Atoms has
//! (<https://docs.lammps.org/read_data.html>).

use super::error::FileProblem;
use super::numbers::shown;
use super::rows::{Column, Quantity};
use super::units::FileUnits;

/// A style: its name, its columns, and those that it adds to the style `hybrid`.
struct Style {
    name: &'static str,
    columns: &'static str,
    added: &'static str,
    /// Whether its atoms have angular velocities.
    turns: bool,
}

const STYLES: [Style; 10] = [
    style("sphere", "id type diameter density x y z", "diameter density", true),
    style("granular", "id type diameter density x y z", "diameter density", true),
    style(
        "bpm/sphere",
        "id molecule type diameter density x y z",
        "molecule diameter density",
        true,
    ),
    style("atomic", "id type x y z", "", false),
    style("charge", "id type charge x y z", "charge", false),
    style("bond", "id molecule type x y z", "molecule", false),
    style("angle", "id molecule type x y z", "molecule", false),
    style("molecular", "id molecule type x y z", "molecule", false),
    style("full", "id molecule type charge x y z", "molecule charge", false),
    style(
        "dipole",
        "id type charge x y z mux muy muz",
        "charge mux muy muz",
        false,
    ),
];

/// The columns of `hybrid` before those of its parts.
const HYBRID: &str = "id type x y z";

const fn style(name: &'static str, columns: &'static str, added: &'static str, turns: bool) -> Style {
    Style {
        name,
        columns,
        added,
        turns,
    }
}

/// What the lines of a style tell.
pub(super) struct Layout {
    /// Name of the style, as in the file.
    pub style: String,
    /// Columns of the section Atoms.
    pub atoms: Vec<Column>,
    /// Names and units of the columns of [`Quantity::Extra`].
    pub extras: Vec<(String, String)>,
    /// Columns of the section Velocities.
    pub velocities: Vec<&'static str>,
}

impl Layout {
    /// The layout of a style, as the comment behind `Atoms` names it: `sphere`, `hybrid sphere bond`.
    pub fn of(name: &str, units: &FileUnits) -> Result<Self, FileProblem> {
        let mut words = name.split_whitespace();
        let first = words.next().unwrap_or("sphere");
        let parts: Vec<&str> = words.collect();
        let unknown = |part: &str| FileProblem::Style {
            style: shown(name),
            part: shown(part),
            known: STYLES
                .iter()
                .map(|s| s.name)
                .chain(["hybrid PART PART ..."])
                .collect::<Vec<_>>()
                .join(", "),
        };
        let find = |name: &str| STYLES.iter().find(|s| s.name == name).ok_or_else(|| unknown(name));
        let (mut names, mut turns): (Vec<&str>, bool);
        if first == "hybrid" && !parts.is_empty() {
            (names, turns) = (HYBRID.split(' ').collect(), false);
            for part in &parts {
                let style = find(part)?;
                turns |= style.turns;
                for column in style.added.split_whitespace() {
                    if !names.contains(&column) {
                        names.push(column);
                    }
                }
            }
        } else if first == "hybrid" {
            return Err(FileProblem::Hybrid);
        } else if let (true, Some(part)) = (first != "hybrid", parts.first()) {
            return Err(unknown(part));
        } else {
            let style = find(first)?;
            (names, turns) = (style.columns.split(' ').collect(), style.turns);
        }
        let mut extras = Vec::new();
        let atoms = names.into_iter().map(|name| column(name, units, &mut extras)).collect();
        let mut velocities = vec!["vx", "vy", "vz"];
        if turns {
            velocities.extend(["wx", "wy", "wz"]);
        }
        Ok(Self {
            style: name.trim().to_owned(),
            atoms,
            extras,
            velocities,
        })
    }

    /// Names of the columns of Atoms.
    pub fn names(&self) -> String {
        self.atoms.iter().map(|c| c.name.as_str()).collect::<Vec<_>>().join(" ")
    }
}

fn column(name: &str, units: &FileUnits, extras: &mut Vec<(String, String)>) -> Column {
    let (quantity, factor) = match name {
        "id" => (Quantity::Id, 1.0),
        "type" => (Quantity::Type, 1.0),
        "diameter" => (Quantity::Size { is_radius: false }, units.length),
        "density" => (Quantity::Density, units.density()),
        "x" => (Quantity::Position(0), units.length),
        "y" => (Quantity::Position(1), units.length),
        "z" => (Quantity::Position(2), units.length),
        _ => {
            extras.push((name.to_owned(), String::new()));
            (Quantity::Extra(extras.len() - 1), 1.0)
        }
    };
    Column::new(name, quantity, factor)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hybrid_styles_add_their_columns_once() {
        let layout = Layout::of("hybrid sphere bond full", &FileUnits::SI).unwrap();
        assert_eq!(layout.names(), "id type x y z diameter density molecule charge");
        assert_eq!(layout.velocities.len(), 6);
        assert_eq!(layout.extras[1].0, "charge");
        let layout = Layout::of("full", &FileUnits::SI).unwrap();
        assert_eq!(
            (layout.names().as_str(), layout.velocities.len()),
            ("id molecule type charge x y z", 3)
        );
        for wrong in ["hybrid", "hybrid sphere tri", "sphere dipole", "ellipsoid"] {
            assert!(Layout::of(wrong, &FileUnits::SI).is_err(), "{wrong}");
        }
    }
}
