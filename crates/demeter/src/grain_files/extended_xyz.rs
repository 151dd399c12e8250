//! Extended XYZ, as OVITO and ASE read and write it: the number of grains, a line of `KEY=VALUE` with the box (`Lattice`,
//! `Origin`, `pbc`), the time and the names of the columns (`Properties`), and one line per grain; one moment after the
//! other. Numbers are taken as SI.

use super::columns::add_column;
use super::error::{FileProblem, Located};
use super::lines::Lines;
use super::numbers::{LARGEST, not_allowed, number, shown};
use super::read::{Context, Notes, ReadOptions};
use super::rows::{Column, MOST_COLUMNS, Quantity, Rows};
use super::table::{Cell, GrainTable};
use super::units::FileUnits;
use glam::DVec3;

/// Columns of a file that names none.
const PLAIN: &str = "species:S:1:pos:R:3";

/// Whether a text is XYZ: a number of grains, a line of anything, then lines of a word and three numbers, or a line of
/// `Properties`.
pub(super) fn looks_like(text: &str) -> bool {
    let mut lines = text.lines();
    let count = lines.next().is_some_and(|line| line.trim().parse::<u64>().is_ok());
    let comment = lines.next().unwrap_or_default();
    let row: Vec<&str> = lines.next().unwrap_or_default().split_whitespace().collect();
    let plain = row.len() >= 4 && row[1..4].iter().all(|word| word.parse::<f64>().is_ok());
    count && (comment.contains("Properties=") || comment.contains("Lattice=") || plain)
}

/// Reads the next moment; nothing at the end.
pub(super) fn read(lines: &mut Lines, context: &Context, notes: &mut Notes) -> Result<Option<GrainTable>, Located> {
    let Some((count, comment)) = read_head(lines)? else {
        return Ok(None);
    };
    let at = lines.number();
    let units = context.units(None, notes)?;
    let keys = keys(&comment);
    let value = |names: &[&str]| {
        let same = |key: &str| names.iter().any(|name| name.eq_ignore_ascii_case(key));
        keys.iter().find(|(key, _)| same(key)).map(|(_, value)| value.as_str())
    };
    let cell = cell(&value, &units, notes).map_err(|problem| problem.at(at, None))?;
    let mut extras = Vec::new();
    let properties = value(&["Properties"]).unwrap_or(PLAIN);
    let columns = columns(properties, &units, &context.options, &mut extras).map_err(|problem| problem.at(at, None))?;
    notes.add_extras(&extras);
    let mut rows = Rows::new(&columns, &extras);
    for found in 0..count {
        let Some((line, row)) = lines.next()? else {
            let found = found as usize;
            return Err(FileProblem::FrameCutShort { found, expected: count }.at(at, None));
        };
        rows.read(line, row.split_whitespace())?;
    }
    let mut table = rows.finish_moment(context.options.diameter, cell)?;
    let time = value(&["Time"])
        .map(number)
        .transpose()
        .map_err(|problem| problem.at(at, None))?;
    table.time = time.map(|time| time * units.time);
    table.step = value(&["Timestep", "Step", "Frame"]).and_then(|step| step.parse().ok());
    Ok(Some(table))
}

/// Takes the next moment without reading its grains; tells whether there was one.
pub(super) fn skip(lines: &mut Lines) -> Result<bool, Located> {
    let Some((count, _)) = read_head(lines)? else {
        return Ok(false);
    };
    let found = lines.skip(count)?;
    if found < count {
        let found = usize::try_from(found).unwrap_or(usize::MAX);
        return Err(FileProblem::FrameCutShort { found, expected: count }.at(lines.number(), None));
    }
    Ok(true)
}

/// Number of grains, and the line that tells what they are.
fn read_head(lines: &mut Lines) -> Result<Option<(u64, String)>, Located> {
    while lines.peek()?.is_some_and(|(_, line)| line.trim().is_empty()) {
        lines.next()?;
    }
    let Some((at, line)) = lines.next()? else {
        return Ok(None);
    };
    let count = line.trim().parse().map_err(|_| {
        let found = shown(line);
        FileProblem::Expected {
            found,
            expected: "the number of grains of a moment",
        }
        .at(at, None)
    })?;
    let (_, comment) = lines.expect("the line that tells the columns")?;
    Ok(Some((count, comment.to_owned())))
}

/// Keys and values of a line: `KEY=VALUE` or `KEY="VALUE WITH BLANKS"`; a key alone has the value `T`.
fn keys(line: &str) -> Vec<(String, String)> {
    let mut keys = Vec::new();
    let mut rest = line.trim_start();
    while !rest.is_empty() && keys.len() < MOST_COLUMNS {
        let end = rest.find(|c: char| c == '=' || c.is_whitespace()).unwrap_or(rest.len());
        let (key, after) = rest.split_at(end);
        let Some(after) = after.strip_prefix('=') else {
            keys.push((key.to_owned(), "T".to_owned()));
            rest = after.trim_start();
            continue;
        };
        let quoted = after.strip_prefix('"').map(|text| (text, '"'));
        let (value, after) = match quoted.or_else(|| after.strip_prefix('{').map(|text| (text, '}'))) {
            Some((text, close)) => text.split_once(close).unwrap_or((text, "")),
            None => after.split_at(after.find(char::is_whitespace).unwrap_or(after.len())),
        };
        keys.push((key.to_owned(), value.to_owned()));
        rest = after.trim_start();
    }
    keys
}

fn numbers<const N: usize>(text: &str, expected: &'static str) -> Result<[f64; N], FileProblem> {
    let words: Vec<&str> = text.split_whitespace().take(N + 1).collect();
    let mut values = [0.0; N];
    if words.len() != N {
        return Err(FileProblem::Expected {
            found: shown(text),
            expected,
        });
    }
    for (value, word) in values.iter_mut().zip(words) {
        *value = number(word)?;
    }
    Ok(values)
}

/// The box, when there is one.
fn cell<'k>(
    value: &impl Fn(&[&str]) -> Option<&'k str>,
    units: &FileUnits,
    notes: &mut Notes,
) -> Result<Option<Cell>, FileProblem> {
    let Some(lattice) = value(&["Lattice"]) else {
        return Ok(None);
    };
    let edges: [f64; 9] = numbers(lattice, "Lattice=\"ax ay az bx by bz cx cy cz\"")?;
    let edges = edges.map(|value| value * units.length);
    let origin: [f64; 3] = match value(&["Origin", "cell_origin"]) {
        Some(origin) => numbers(origin, "Origin=\"x y z\"")?,
        None => [0.0; 3],
    };
    let corner = DVec3::from_array(origin) * units.length;
    let edges = [0, 3, 6].map(|k| DVec3::from_slice(&edges[k..k + 3]));
    let Some(cell) = Cell::of_edges(edges, corner) else {
        notes.add("the edges of the box lie in a plane; it is left out".to_owned());
        return Ok(None);
    };
    if edges.iter().any(|edge| (corner + *edge).abs().max_element() > LARGEST) {
        return Err(not_allowed(lattice, "a box ends within 1e12 m"));
    }
    // A box without a word on its sides is periodic.
    let flags: Vec<&str> = value(&["pbc"]).unwrap_or("T T T").split_whitespace().collect();
    Ok(Some(Cell {
        periodic: [0, 1, 2].map(|k| {
            flags
                .get(k)
                .is_some_and(|flag| ["T", "1", "True", "true"].contains(flag))
        }),
        ..cell
    }))
}

/// Reads `NAME:KIND:COUNT:NAME:KIND:COUNT...`.
fn columns(
    told: &str,
    units: &FileUnits,
    options: &ReadOptions,
    extras: &mut Vec<(String, String)>,
) -> Result<Vec<Column>, FileProblem> {
    let malformed = || FileProblem::Expected {
        found: shown(told),
        expected: "Properties=NAME:KIND:COUNT:..., as `pos:R:3:radius:R:1`,",
    };
    let parts: Vec<&str> = told.split(':').collect();
    if !parts.len().is_multiple_of(3) {
        return Err(malformed());
    }
    let mut columns: Vec<Column> = Vec::new();
    for part in parts.chunks_exact(3) {
        let (name, kind) = (part[0], part[1]);
        let count: usize = part[2].parse().map_err(|_| malformed())?;
        if !["S", "R", "I", "L"].contains(&kind) || count == 0 || columns.len() + count > MOST_COLUMNS {
            return Err(malformed());
        }
        for k in 0..count {
            let column_name = match (count, name) {
                (1, _) => name.to_owned(),
                (4, "orientation") => format!("{name}_{}", ["x", "y", "z", "w"][k]),
                _ => format!("{name}_{}", k + 1),
            };
            let (mut quantity, factor) = match quantity(name, count, k, units) {
                Some(found) => found,
                None if kind == "S" || kind == "L" => (Quantity::Skipped, 1.0),
                None => (Quantity::extra(&column_name, "", options, extras), 1.0),
            };
            // Names of materials come with their numbers, and the first of both counts.
            if quantity == Quantity::Type && columns.iter().any(|c| c.quantity == quantity) {
                quantity = Quantity::Skipped;
            }
            let column = Column {
                name: column_name,
                quantity,
                factor,
            };
            add_column(&mut columns, column)?;
        }
    }
    match (0..3).all(|k| columns.iter().any(|c| c.quantity == Quantity::Position(k))) {
        true => Ok(columns),
        false => Err(FileProblem::MissingColumn { name: "pos" }),
    }
}

/// The quantity of a component of a property, and its unit in SI. Names as OVITO and ASE use them.
fn quantity(name: &str, count: usize, k: usize, units: &FileUnits) -> Option<(Quantity, f64)> {
    let lower = name.to_ascii_lowercase();
    Some(match (lower.as_str(), count) {
        ("pos" | "position" | "positions", 3) => (Quantity::Position(k), units.length),
        ("velo" | "vel" | "velocity" | "velocities", 3) => (Quantity::Velocity(k), units.velocity()),
        ("angular_velocity" | "omega" | "angularvelocity", 3) => (Quantity::AngularVelocity(k), units.rate()),
        ("force" | "forces", 3) => (Quantity::Force(k), units.force()),
        ("torque" | "torques", 3) => (Quantity::Torque(k), units.torque()),
        ("radius", 1) => (Quantity::Size { is_radius: true }, units.length),
        ("diameter", 1) => (Quantity::Size { is_radius: false }, units.length),
        ("density", 1) => (Quantity::Density, units.density()),
        ("mass" | "masses", 1) => (Quantity::Mass, units.mass),
        ("id" | "identifier", 1) => (Quantity::Id, 1.0),
        ("species" | "material" | "element" | "type" | "atom_types" | "particle_type", 1) => (Quantity::Type, 1.0),
        _ => return None,
    })
}

#[cfg(test)]
#[path = "extended_xyz_tests.rs"]
mod tests;
