//! Which columns of the series are plotted together.

use super::parameters::Parameters;
use super::series::{PUT_IN, RESIDUAL, STORED, TAKEN_OUT, shown};
use crate::results::{Column, Columns};

/// Most lines of a plot.
const MOST_LINES: usize = 12;
/// Most plots of measures, feeds and removals.
const MOST_PLOTS: usize = 60;
/// A column of walls that stays smaller than this share of the largest beside it is not plotted unasked.
const SMALL: f64 = 0.01;

/// Where plots are on the page.
pub(super) const SERIES: &str = "plots-series";
/// Plots of the ledger.
pub(super) const ENERGY: &str = "plots-energy";
/// Plots of walls.
pub(super) const WALLS: &str = "plots-walls";

/// What is plotted of walls: the title, the ends of the names of its columns, and whether those of walls that turn alone.
const OF_WALLS: [(&str, &[&str], bool); 8] = [
    ("Wall forces", &["force x", "force y", "force z"], false),
    ("Wall torques", &["torque x", "torque y", "torque z"], true),
    ("Wall powers", &["power"], false),
    (
        WALL_DISPLACEMENTS,
        &["displacement x", "displacement y", "displacement z"],
        false,
    ),
    (
        "Wall angular velocities",
        &["angular velocity x", "angular velocity y", "angular velocity z"],
        true,
    ),
    ("Wall turns", &["turn x", "turn y", "turn z"], true),
    ("Energy lost at walls", &["impact energy", "sliding energy"], false),
    ("Worn volume of walls", &["worn volume"], false),
];
const WALL_DISPLACEMENTS: &str = "Wall displacements";

/// Columns that are plotted together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Group {
    pub title: String,
    /// Where on the page.
    pub place: &'static str,
    pub x: String,
    pub y: Vec<String>,
    /// How many columns more there are.
    pub left_out: usize,
}

impl Group {
    fn over_time(title: &str, place: &'static str, mut y: Vec<String>) -> Self {
        let left_out = y.len().saturating_sub(MOST_LINES);
        y.truncate(MOST_LINES);
        Self {
            title: title.to_string(),
            place,
            x: "time".to_string(),
            y,
            left_out,
        }
    }
}

/// All plots of the page.
#[derive(Debug, Default)]
pub(super) struct Plots {
    pub groups: Vec<Group>,
    /// Plots of measures, feeds and removals that would be too many.
    left_out: usize,
}

impl Plots {
    /// Of a series: those that the scenario asks for, what it measures, and what every run has; those without a column that
    /// changes are left out. `rounding` is the length below which walls only seem to move [m].
    pub fn new(series: &Columns, parameters: Option<&Parameters>, rounding: f64) -> Self {
        let mut groups = parameters.map(Parameters::plots).unwrap_or_default();
        let owners = parameters.map(Parameters::owners_of_columns).unwrap_or_default();
        let mut owned: Vec<Group> = (owners.iter())
            .flat_map(|owner| of_owner(series, owner, &owners))
            .collect();
        let left_out = owned.len().saturating_sub(MOST_PLOTS);
        owned.truncate(MOST_PLOTS);
        groups.extend(owned);
        groups.extend(of_every_run(series));
        groups.extend(of_walls(series, rounding));
        groups.retain(|group| !group.y.is_empty());
        Self { groups, left_out }
    }

    /// What the plots of a place leave out, as sentences.
    pub fn told(&self, place: &str) -> Vec<String> {
        let short = |group: &&Group| group.place == place && group.left_out > 0;
        let told = self.groups.iter().filter(short).map(|group| {
            let (title, lines) = (&group.title, group.y.len());
            format!(
                "“{title}” shows {lines} of {} columns; `output.plots` or “A plot of your own” draws others.",
                lines + group.left_out
            )
        });
        let many = (place == SERIES && self.left_out > 0).then(|| {
            format!(
                "{} more plots of measures, feeds and removals are left out; `output.plots` or “A plot of your own” draws them.",
                self.left_out
            )
        });
        told.chain(many).collect()
    }
}

/// Plots of the columns that begin with a name: one for each unit, and numbers of things apart from shares.
fn of_owner(series: &Columns, owner: &str, owners: &[String]) -> Vec<Group> {
    let mut kinds: Vec<(&str, bool, Vec<String>)> = Vec::new();
    let begins = |column: &Column, name: &str| {
        column
            .name()
            .strip_prefix(name)
            .is_some_and(|rest| rest.starts_with(' '))
    };
    let owned = |column: &&Column| {
        // of `feed a` and `feed a b` the latter
        let longer = owners
            .iter()
            .any(|other| other.len() > owner.len() && begins(column, other));
        begins(column, owner) && !longer
    };
    for column in shown(series).filter(owned).filter(|column| changes(column)) {
        let (unit, counts) = (column.unit(), column.unit().is_empty() && is_whole(column));
        let name = column.name().to_string();
        match kinds.iter_mut().find(|kind| (kind.0, kind.1) == (unit, counts)) {
            Some((.., names)) => names.push(name),
            None => kinds.push((unit, counts, vec![name])),
        }
    }
    let group = |(unit, counts, names): (&str, bool, Vec<String>)| {
        let title = match (names.as_slice(), unit, counts) {
            ([one], ..) => one.clone(),
            (_, "", true) => format!("{owner}: numbers"),
            (_, "", false) => format!("{owner}: shares and ratios"),
            (_, unit, _) => format!("{owner} [{unit}]"),
        };
        Group::over_time(&title, SERIES, names)
    };
    kinds.into_iter().map(group).collect()
}

fn of_every_run(series: &Columns) -> Vec<Group> {
    let of = |title: &str, place: &'static str, names: &[&str]| {
        let changing = names.iter().filter(|name| series.find(name).is_some_and(changes));
        Group::over_time(title, place, changing.map(|name| (*name).to_string()).collect())
    };
    let without_gravity: Vec<&str> = STORED
        .iter()
        .copied()
        .filter(|name| !name.starts_with("gravi"))
        .collect();
    vec![
        of("Energies", ENERGY, &without_gravity),
        of("Energy of gravity", ENERGY, &["gravitational energy"]),
        of(
            "Work and losses since the start",
            ENERGY,
            &[&PUT_IN[..], &TAKEN_OUT[..]].concat(),
        ),
        of("Ledger residual", ENERGY, &[RESIDUAL]),
        of("Coordination", SERIES, &["coordination"]),
        of("Contacts", SERIES, &["contacts"]),
        of("Grains", SERIES, &["grains"]),
        of("Packing fraction", SERIES, &["packing fraction"]),
        of("Strain", SERIES, &["strain"]),
        of(
            "Stress",
            SERIES,
            &[
                "stress xx",
                "stress yy",
                "stress zz",
                "stress xy",
                "stress xz",
                "stress yz",
            ],
        ),
        of("Largest overlap", SERIES, &["max overlap"]),
        of("Largest speed", SERIES, &["max speed"]),
        of("Kinetic over elastic energy", SERIES, &["kinetic over elastic"]),
        of("Momentum", SERIES, &["momentum x", "momentum y", "momentum z"]),
    ]
}

/// Plots of all walls; the columns that stay small are left out, and the largest come first.
fn of_walls(series: &Columns, rounding: f64) -> impl Iterator<Item = Group> {
    let turning: Vec<&str> = (shown(series).map(Column::name))
        .filter_map(|name| name.strip_suffix(" turn x"))
        .collect();
    OF_WALLS.iter().map(move |(title, ends, only_turning)| {
        let wall_of = |column: &'_ Column| {
            let name = column.name();
            let wall = ends.iter().find_map(|end| name.strip_suffix(end)?.strip_suffix(' '))?;
            wall.starts_with("wall ").then(|| wall.to_string())
        };
        let kept = |wall: &str| !only_turning || turning.contains(&wall);
        let sized: Vec<(&Column, f64)> = shown(series)
            .filter(|column| wall_of(column).is_some_and(|wall| kept(&wall)))
            .map(|column| (column, size(column)))
            .collect();
        let least = if *title == WALL_DISPLACEMENTS { rounding } else { 0.0 };
        let largest = sized.iter().map(|(_, size)| *size).fold(least, f64::max);
        let mut seen: Vec<(&Column, f64)> = (sized.into_iter())
            .filter(|(_, size)| *size > least && *size >= SMALL * largest)
            .collect();
        seen.sort_by(|a, b| b.1.total_cmp(&a.1));
        let names = seen.iter().map(|(column, _)| column.name().to_string()).collect();
        Group::over_time(title, WALLS, names)
    })
}

/// The finite numbers of a column.
fn finite(column: &Column) -> impl Iterator<Item = f64> {
    let numbers = column.numbers().unwrap_or_default().iter().copied();
    numbers.filter(|v| v.is_finite())
}

/// The largest magnitude in a column.
fn size(column: &Column) -> f64 {
    finite(column).fold(0.0, |most, v| most.max(v.abs()))
}

/// Whether a column has two different numbers.
fn changes(column: &Column) -> bool {
    let mut numbers = finite(column);
    let first = numbers.next();
    numbers.any(|v| Some(v) != first)
}

/// Whether a column counts things.
fn is_whole(column: &Column) -> bool {
    finite(column).all(|v| v.fract() == 0.0)
}
