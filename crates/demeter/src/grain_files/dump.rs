//! LAMMPS and LIGGGHTS dumps as text (<https://docs.lammps.org/dump.html>): one moment after the other, each with its box
//! and the names of its columns.

use super::columns::{add_column, check_complete};
use super::error::{FileProblem, Located};
use super::lines::Lines;
use super::numbers::{not_allowed, number, shown};
use super::read::{Context, Notes, ReadOptions};
use super::rows::{Column, MOST_COLUMNS, Quantity, Rows};
use super::table::{Cell, GrainTable};
use super::units::FileUnits;

/// Columns of times that a grain went through a periodic side.
const IMAGES: [&str; 3] = ["ix", "iy", "iz"];

/// Column of the labels of types.
const LABEL: &str = "typelabel";

/// Whether a text is a dump.
pub(super) fn looks_like(text: &str) -> bool {
    text.trim_start().starts_with("ITEM:")
}

/// The head of a moment.
#[derive(Default)]
struct Head {
    step: Option<u64>,
    time: Option<f64>,
    atoms: Option<u64>,
    units: Option<String>,
    bounds: Option<Bounds>,
    columns: String,
}

/// How a file tells its box.
#[derive(Clone, Copy, PartialEq)]
enum Told {
    /// Ends along x, y and z.
    Ends,
    /// Ends of what lies around a tilted box, and the tilts.
    Tilted,
    /// Three edges, each with a coordinate of the corner behind it: OVITO writes this.
    Edges,
}

impl Told {
    /// Values of a line.
    fn values(self) -> usize {
        match self {
            Self::Ends => 2,
            Self::Tilted => 3,
            Self::Edges => 4,
        }
    }

    /// Words before the kinds of the sides.
    fn words(self) -> usize {
        [0, 3, 2][self.values() - 2]
    }
}

/// The box as the file tells it, in its units.
#[derive(Clone, Copy)]
struct Bounds {
    rows: [[f64; 4]; 3],
    told: Told,
    periodic: [bool; 3],
}

/// Reads the next moment; nothing at the end.
pub(super) fn read(lines: &mut Lines, context: &Context, notes: &mut Notes) -> Result<Option<GrainTable>, Located> {
    let Some(head) = read_head(lines)? else {
        return Ok(None);
    };
    let at = lines.number();
    let units = context.units(head.units.as_deref(), notes)?;
    let cell = head.bounds.map(|bounds| cell(&bounds, &units)).transpose()?;
    let mut extras = Vec::new();
    let columns =
        columns(&head.columns, &units, &context.options, &mut extras).map_err(|problem| problem.at(at, None))?;
    notes.add_extras(&extras);
    let left_out = |column: &&str| matches!(quantity(column, &units), Some((Quantity::Skipped, _)));
    let left_out: Vec<&str> = head.columns.split_whitespace().filter(left_out).collect();
    if !left_out.is_empty() {
        notes.add(format!("columns are left out: {}", left_out.join(", ")));
    }
    let expected = head.atoms.unwrap_or(0);
    let mut rows = Rows::new(&columns, &extras);
    for found in 0..expected {
        let Some((line, row)) = lines.peek()? else {
            let found = found as usize;
            return Err(FileProblem::FrameCutShort { found, expected }.at(at, None));
        };
        if row.starts_with("ITEM:") {
            let found = found as usize;
            return Err(FileProblem::FrameCutShort { found, expected }.at(line, None));
        }
        if let Some((line, row)) = lines.next()? {
            rows.read(line, row.split_whitespace())?;
        }
    }
    let mut table = rows.finish_moment(context.options.diameter, cell)?;
    table.step = head.step;
    table.time = head.time.map(|time| time * units.time);
    Ok(Some(table))
}

/// Takes the next moment without reading its grains; tells whether there was one.
pub(super) fn skip(lines: &mut Lines, context: &Context, notes: &mut Notes) -> Result<bool, Located> {
    let Some(head) = read_head(lines)? else {
        return Ok(false);
    };
    context.units(head.units.as_deref(), notes)?;
    let expected = head.atoms.unwrap_or(0);
    let found = lines.skip(expected)?;
    if found < expected {
        let found = usize::try_from(found).unwrap_or(usize::MAX);
        return Err(FileProblem::FrameCutShort { found, expected }.at(lines.number(), None));
    }
    Ok(true)
}

fn read_head(lines: &mut Lines) -> Result<Option<Head>, Located> {
    const ITEM: &str = "a line such as `ITEM: TIMESTEP`";
    while lines.peek()?.is_some_and(|(_, line)| line.trim().is_empty()) {
        lines.next()?;
    }
    if lines.peek()?.is_none() {
        return Ok(None);
    }
    let mut head = Head::default();
    loop {
        let (at, line) = lines.expect(ITEM)?;
        let Some(item) = line.strip_prefix("ITEM:").map(|item| item.trim().to_owned()) else {
            let found = shown(line);
            return Err(FileProblem::Expected { found, expected: ITEM }.at(at, None));
        };
        let (name, rest) = match item.split_once(' ') {
            _ if item.starts_with("NUMBER OF ATOMS") => ("NUMBER OF ATOMS", ""),
            _ if item.starts_with("BOX BOUNDS") => ("BOX BOUNDS", &item["BOX BOUNDS".len()..]),
            Some((name, rest)) => (name, rest),
            None => (item.as_str(), ""),
        };
        match name {
            "TIMESTEP" => {
                let (at, text) = lines.expect("the number of steps")?;
                let step = text
                    .trim()
                    .parse()
                    .map_err(|_| not_allowed(text, "allowed are whole numbers from 0"));
                head.step = Some(step.map_err(|problem| problem.at(at, None))?);
            }
            "TIME" => {
                let (at, text) = lines.expect("the time")?;
                head.time = Some(number(text.trim()).map_err(|problem| problem.at(at, None))?);
            }
            "UNITS" => head.units = Some(shown(lines.expect("the units")?.1.trim())),
            "NUMBER OF ATOMS" => {
                let (at, text) = lines.expect("the number of atoms")?;
                let atoms = text
                    .trim()
                    .parse()
                    .map_err(|_| not_allowed(text, "allowed are whole numbers from 0"));
                head.atoms = Some(atoms.map_err(|problem| problem.at(at, None))?);
            }
            "BOX BOUNDS" => head.bounds = Some(read_bounds(lines, rest)?),
            "ATOMS" => {
                if head.atoms.is_none() {
                    let found = "ITEM: ATOMS".to_owned();
                    return Err(FileProblem::Expected {
                        found,
                        expected: "`ITEM: NUMBER OF ATOMS`",
                    }
                    .at(at, None));
                }
                head.columns = rest.to_owned();
                return Ok(Some(head));
            }
            "ENTRIES" => {
                let what = "a dump of contacts (`dump local`)".to_owned();
                let remedy = "dump the atoms: `dump ID all custom N FILE id type x y z radius ...`";
                return Err(FileProblem::NotRead { what, remedy }.at(at, None));
            }
            // Other items, such as LIGGGHTS' LABEL, have one line of their own.
            _ => {
                lines.expect("the value of an item")?;
            }
        }
    }
}

fn read_bounds(lines: &mut Lines, told: &str) -> Result<Bounds, Located> {
    let words: Vec<&str> = told.split_whitespace().collect();
    let told = match words[..] {
        ["xy", "xz", "yz", ..] => Told::Tilted,
        ["abc", "origin", ..] => Told::Edges,
        _ => Told::Ends,
    };
    let flags = &words[told.words()..];
    let mut bounds = Bounds {
        rows: [[0.0; 4]; 3],
        told,
        periodic: [0, 1, 2].map(|k| flags.get(k).is_some_and(|flag| flag.starts_with('p'))),
    };
    for row in &mut bounds.rows {
        let (at, line) = lines.expect("a side of the box")?;
        let values: Vec<&str> = line.split_whitespace().take(5).collect();
        if values.len() != told.values() {
            let (found, expected) = (values.len(), told.values().to_string());
            return Err(FileProblem::ValueCount { found, expected }.at(at, None));
        }
        for (slot, text) in row.iter_mut().zip(values) {
            *slot = number(text).map_err(|problem| problem.at(at, None))?;
        }
        if told != Told::Edges && row[0] > row[1] {
            return Err(not_allowed(line, "the lower side must not be above the upper").at(at, None));
        }
    }
    Ok(bounds)
}

/// The box in SI. Of a tilted one, the file tells what lies around it.
fn cell(bounds: &Bounds, units: &FileUnits) -> Result<Cell, FileProblem> {
    let [x, y, z] = bounds.rows.map(|row| row.map(|value| value * units.length));
    let periodic = bounds.periodic;
    if bounds.told == Told::Edges {
        let edges = [x, y, z].map(|row| [row[0], row[1], row[2]].into());
        let cell = Cell::of_edges(edges, [x[3], y[3], z[3]].into());
        return cell
            .map(|cell| Cell { periodic, ..cell })
            .ok_or_else(|| FileProblem::NotRead {
                what: "a flat box, whose edges lie in a plane,".to_owned(),
                remedy: "tell three edges that span a volume",
            });
    }
    let mut cell = Cell {
        lower: [x[0], y[0], z[0]].into(),
        upper: [x[1], y[1], z[1]].into(),
        tilt: [x[2], y[2], z[2]],
        rise: [0.0; 3],
        periodic,
    };
    let over = cell.overhang();
    for (axis, [low, high]) in over.into_iter().enumerate() {
        cell.lower[axis] -= low;
        cell.upper[axis] -= high;
    }
    Ok(cell)
}

/// The quantity of a column of a dump, and its unit in SI.
fn quantity(name: &str, units: &FileUnits) -> Option<(Quantity, f64)> {
    let axis = |prefix: &str, suffix: &str| {
        let middle = name.strip_prefix(prefix)?.strip_suffix(suffix)?;
        ["x", "y", "z"].iter().position(|axis| *axis == middle)
    };
    let position = axis("", "").or_else(|| axis("", "u"));
    if let Some(k) = position {
        return Some((Quantity::Position(k), units.length));
    }
    if let Some(k) = axis("", "s").or_else(|| axis("", "su")) {
        return Some((Quantity::ScaledPosition(k), 1.0));
    }
    if let Some(k) = axis("v", "") {
        return Some((Quantity::Velocity(k), units.velocity()));
    }
    if let Some(k) = axis("omega", "") {
        return Some((Quantity::AngularVelocity(k), units.rate()));
    }
    if let Some(k) = axis("f", "") {
        return Some((Quantity::Force(k), units.force()));
    }
    if let Some(k) = axis("tq", "") {
        return Some((Quantity::Torque(k), units.torque()));
    }
    Some(match name {
        "id" => (Quantity::Id, 1.0),
        "type" | LABEL => (Quantity::Type, 1.0),
        "radius" => (Quantity::Size { is_radius: true }, units.length),
        "diameter" => (Quantity::Size { is_radius: false }, units.length),
        "mass" => (Quantity::Mass, units.mass),
        "density" => (Quantity::Density, units.density()),
        "element" | "proc" | "procp1" => (Quantity::Skipped, 1.0),
        _ => return None,
    })
}

fn columns(
    told: &str,
    units: &FileUnits,
    options: &ReadOptions,
    extras: &mut Vec<(String, String)>,
) -> Result<Vec<Column>, FileProblem> {
    let has = |name: &str| told.split_whitespace().any(|column| column == name);
    let mut columns: Vec<Column> = Vec::new();
    for name in told.split_whitespace().take(MOST_COLUMNS) {
        let found = quantity(name, units);
        let (mut quantity, factor) = found.unwrap_or_else(|| (Quantity::extra(&shown(name), "", options, extras), 1.0));
        if let (true, Quantity::Extra(index)) = (IMAGES.contains(&name), quantity) {
            quantity = Quantity::Image(index);
        }
        if name == LABEL && has("type") {
            quantity = match options.types_told {
                true => Quantity::Skipped,
                false => Quantity::Label,
            };
        }
        // Of places told in several ways, as `x` and `xs`, the first counts; many dumps of LIGGGHTS tell the type twice.
        let allowed = match quantity {
            Quantity::Type => true,
            Quantity::Position(_) | Quantity::ScaledPosition(_) => columns.iter().all(|c| c.name != name),
            _ => false,
        };
        if allowed && columns.iter().any(|c| c.quantity.is_same(quantity)) {
            quantity = Quantity::Skipped;
        }
        add_column(&mut columns, Column::new(name, quantity, factor))?;
    }
    // sizes that are missing are asked for behind the rows
    check_complete(&columns, true).map_err(in_words_of_dumps)?;
    Ok(columns)
}

/// The name of a missing column as dumps have it.
fn in_words_of_dumps(problem: FileProblem) -> FileProblem {
    match problem {
        FileProblem::MissingColumn { name } => FileProblem::MissingColumn {
            name: match name {
                "wx" => "omegax",
                "wy" => "omegay",
                "wz" => "omegaz",
                "tx" => "tqx",
                "ty" => "tqy",
                "tz" => "tqz",
                _ => name,
            },
        },
        other => other,
    }
}

#[cfg(test)]
#[path = "dump_tests.rs"]
mod tests;
