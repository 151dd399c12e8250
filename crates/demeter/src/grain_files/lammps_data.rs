//! LAMMPS and LIGGGHTS data files of spheres (<https://docs.lammps.org/read_data.html>): header, section Atoms in the
//! columns of the atom style that the comment behind it names (`sphere` when there is none) and maybe three image flags,
//! section Velocities. Labels of types name materials unless those are told. Sections of masses, coefficients and bonds are left out. So
//! are the image flags, which is told: places are
//! those inside the box.

use super::error::{FileProblem, Located};
use super::lammps_styles::Layout;
use super::lines::Lines;
use super::numbers::{not_allowed, number, shown, whole};
use super::read::{Context, Notes};
use super::rows::{Rows, add_label};
use super::table::{Cell, GrainTable, TypeOfGrain};
use super::units::FileUnits;
use glam::DVec3;
use std::collections::BTreeMap;

/// Lines searched for the count of atoms when a file's format is told.
const HEADER_LINES: usize = 200;
/// What the header may count besides atoms, in the singular, and whether its atoms are spheres all the same.
const OTHERS: [(&str, bool); 8] = [
    ("bond", true),
    ("angle", true),
    ("dihedral", true),
    ("improper", true),
    ("ellipsoid", false),
    ("line", false),
    ("triangle", false),
    ("bodie", false),
];
const BOUNDS: [[&str; 2]; 3] = [["xlo", "xhi"], ["ylo", "yhi"], ["zlo", "zhi"]];
/// Edges and corner of a box that lies anyhow.
const GENERAL: [&str; 4] = ["avec", "bvec", "cvec", "abc origin"];
/// Sections that say nothing of single grains.
const LEFT_OUT: [&str; 5] = ["Masses", "Bonds", "Angles", "Dihedrals", "Impropers"];
/// Section of the names of types.
const LABELS: &str = "Atom Type Labels";

/// Whether a text is a data file: it has a line `N atoms` near its start, or says so in its first line.
pub(super) fn looks_like(text: &str) -> bool {
    let first = text.lines().next().unwrap_or_default().to_ascii_lowercase();
    let titled = (first.contains("lammps") || first.contains("liggghts")) && first.contains("data");
    titled
        || text.lines().take(HEADER_LINES).any(|line| {
            let mut words = content(line).split_whitespace();
            let is_count = words.next().is_some_and(|w| w.parse::<u64>().is_ok());
            is_count && words.next() == Some("atoms") && words.next().is_none()
        })
}

/// A line without its comment.
fn content(line: &str) -> &str {
    line.split('#').next().unwrap_or_default().trim()
}

#[derive(Default)]
struct Header {
    atoms: Option<u32>,
    types: Option<u32>,
    bounds: [Option<(f64, f64)>; 3],
    tilt: Option<[f64; 3]>,
    /// Edges and corner of a box that lies anyhow.
    general: [Option<DVec3>; 4],
}

/// What the title tells of how the file was written.
struct Title {
    units: Option<String>,
    step: Option<u64>,
}

impl Title {
    /// Reads `..., timestep = 100, units = si`.
    fn of(line: &str) -> Self {
        let value = |name: &str| {
            let part = line.split(',').find_map(|part| part.trim().strip_prefix(name));
            Some(part?.trim().strip_prefix('=')?.trim().to_owned())
        };
        Self {
            units: value("units"),
            step: value("timestep").and_then(|step| step.parse().ok()),
        }
    }
}

/// The next line of values, or nothing when a section name or the end follows.
fn next_values<'l>(lines: &'l mut Lines) -> Result<Option<(usize, &'l str)>, Located> {
    loop {
        let Some((_, line)) = lines.peek()? else {
            return Ok(None);
        };
        let content = content(line);
        let is_empty = content.is_empty();
        let starts_section = content.starts_with(|c: char| c.is_ascii_alphabetic());
        if starts_section && !content.to_ascii_lowercase().starts_with("nan") {
            return Ok(None);
        }
        if !is_empty {
            break;
        }
        lines.next()?;
    }
    Ok(lines.next()?.map(|(line, text)| (line, self::content(text))))
}

/// Reads a data file.
pub(super) fn read(lines: &mut Lines, context: &Context, notes: &mut Notes) -> Result<GrainTable, Located> {
    let title = match lines.next()? {
        Some((_, line)) => Title::of(line),
        None => return Err(FileProblem::HeaderMissing { what: "atoms" }.into()),
    };
    let units = context.units(title.units.as_deref(), notes)?;
    let mut header = Header::default();
    let mut atoms: Option<(GrainTable, Layout)> = None;
    let mut velocities: Option<Vec<[DVec3; 2]>> = None;
    let mut labels = BTreeMap::new();
    while let Some((line, whole_line)) = lines.next()? {
        let content = content(whole_line);
        if content.is_empty() {
            continue;
        }
        if !content.starts_with(|c: char| c.is_ascii_alphabetic()) {
            read_header(&mut header, content, &units, notes).map_err(|problem| problem.at(line, None))?;
            continue;
        }
        match content {
            "Atoms" if atoms.is_some() => return Err(FileProblem::TwiceSection { name: "Atoms" }.at(line, None)),
            "Atoms" => {
                let layout = layout(whole_line, context, &units).map_err(|problem| problem.at(line, None))?;
                let expected =
                    (header.atoms).ok_or_else(|| FileProblem::HeaderMissing { what: "atoms" }.at(line, None))?;
                let cell = cell(&header)?;
                let told = (expected as usize, header.types);
                let table = read_atoms(lines, told, &layout, (context, notes), cell)?;
                atoms = Some((table, layout));
            }
            "Velocities" if velocities.is_some() => {
                return Err(FileProblem::TwiceSection { name: "Velocities" }.at(line, None));
            }
            "Velocities" => {
                let missing = || FileProblem::AtomsBehind.at(line, None);
                let (table, layout) = atoms.as_ref().ok_or_else(missing)?;
                velocities = Some(read_velocities(lines, table, layout, &units)?);
            }
            LABELS if !context.options.types_told => read_labels(lines, &mut labels)?,
            name if LEFT_OUT.contains(&name) || name.ends_with(" Coeffs") || name.ends_with(" Labels") => {
                notes.add(format!("section `{}` is left out", shown(name)));
                while next_values(lines)?.is_some() {}
            }
            name => {
                let name = shown(name);
                return Err(FileProblem::UnknownSection { name }.at(line, None));
            }
        }
    }
    if header.atoms.is_none() {
        return Err(FileProblem::HeaderMissing { what: "atoms" }.into());
    }
    let (mut table, layout) = atoms.ok_or(FileProblem::MissingSection { name: "Atoms" })?;
    if let Some(values) = velocities {
        table.velocities = Some(values.iter().map(|both| both[0]).collect());
        let turns = layout.velocities.len() > 3;
        table.angular_velocities = turns.then(|| values.iter().map(|both| both[1]).collect());
    }
    table.label_types(&labels);
    table.step = title.step;
    Ok(table)
}

/// The box of a header that is whole.
fn cell(header: &Header) -> Result<Cell, Located> {
    if header.general.iter().any(Option::is_some) {
        return general_cell(header);
    }
    let mut cell = Cell {
        tilt: header.tilt.unwrap_or_default(),
        ..Cell::default()
    };
    for (k, what) in ["xlo xhi", "ylo yhi", "zlo zhi"].into_iter().enumerate() {
        (cell.lower[k], cell.upper[k]) = header.bounds[k].ok_or(FileProblem::HeaderMissing { what })?;
    }
    Ok(cell)
}

/// The box of three edges. Its corner is the origin where it is not told, as in LAMMPS.
fn general_cell(header: &Header) -> Result<Cell, Located> {
    let [a, b, c, corner] = header.general;
    if header.tilt.is_some() || header.bounds.iter().any(Option::is_some) {
        let what = "a box told both by its edges (`avec`, ...) and by its sides (`xlo xhi`, ...)".to_owned();
        let remedy = "tell it in one way";
        return Err(FileProblem::NotRead { what, remedy }.into());
    }
    let mut edges = [DVec3::ZERO; 3];
    for ((edge, told), what) in edges.iter_mut().zip([a, b, c]).zip(GENERAL) {
        *edge = told.ok_or(FileProblem::HeaderMissing { what })?;
    }
    Cell::of_edges(edges, corner.unwrap_or_default()).ok_or_else(|| {
        let what = "a flat box, whose edges lie in a plane,".to_owned();
        let remedy = "tell three edges that span a volume";
        FileProblem::NotRead { what, remedy }.into()
    })
}

fn read_header(header: &mut Header, content: &str, units: &FileUnits, notes: &mut Notes) -> Result<(), FileProblem> {
    let words: Vec<&str> = content.split_whitespace().take(12).collect();
    let first_word = words
        .iter()
        .position(|w| w.starts_with(|c: char| c.is_ascii_alphabetic()));
    let (values, names) = words.split_at(first_word.unwrap_or(words.len()));
    let twice = |is_twice: bool| match is_twice {
        true => Err(FileProblem::HeaderTwice { what: names.join(" ") }),
        false => Ok(()),
    };
    match (values, names) {
        (&[count], ["atoms"]) => {
            twice(header.atoms.is_some())?;
            header.atoms = Some(whole(count)?);
        }
        (&[count], ["atom", "types"]) => {
            twice(header.types.is_some())?;
            header.types = Some(whole(count)?);
        }
        (&[low, high], &[low_name, high_name]) if BOUNDS.contains(&[low_name, high_name]) => {
            let axis = BOUNDS.iter().position(|b| b[0] == low_name).unwrap_or(0);
            twice(header.bounds[axis].is_some())?;
            let (from, to) = (number(low)?, number(high)?);
            if from >= to {
                return Err(not_allowed(content, "the lower side must be below the upper"));
            }
            header.bounds[axis] = Some((from * units.length, to * units.length));
        }
        (&[xy, xz, yz], ["xy", "xz", "yz"]) => {
            twice(header.tilt.is_some())?;
            header.tilt = Some([number(xy)?, number(xz)?, number(yz)?].map(|tilt| tilt * units.length));
        }
        (&[x, y, z], names) if GENERAL.contains(&names.join(" ").as_str()) => {
            let name = names.join(" ");
            let which = GENERAL.iter().position(|known| *known == name).unwrap_or(0);
            twice(header.general[which].is_some())?;
            header.general[which] = Some(DVec3::new(number(x)?, number(y)?, number(z)?) * units.length);
        }
        // Space for what may be bonded later says nothing of the grains.
        (_, ["extra", ..]) => {}
        (&[count], &[kind, ..]) if OTHERS.iter().any(|other| kind.trim_end_matches('s') == other.0) => {
            let spheres = OTHERS
                .iter()
                .any(|other| kind.trim_end_matches('s') == other.0 && other.1);
            if count != "0" && !spheres {
                return Err(FileProblem::NotSpheres {
                    what: format!("an entry of `{}`", names.join(" ")),
                });
            }
            if count != "0" && names.len() == 1 {
                notes.add(format!("{} {kind} are left out", shown(count)));
            }
        }
        _ => return Err(FileProblem::UnknownHeader { text: shown(content) }),
    }
    Ok(())
}

/// The columns of the style that a comment behind the section name tells, as LAMMPS writes it.
fn layout(line: &str, context: &Context, units: &FileUnits) -> Result<Layout, FileProblem> {
    let comment = line.split_once('#').map_or("", |(_, comment)| comment.trim());
    match (&context.options.style, comment) {
        (Some(style), _) => Layout::of(style, units),
        (None, "") => Layout::of("sphere", units),
        (None, style) => Layout::of(style, units),
    }
}

fn read_atoms(
    lines: &mut Lines,
    (expected, types): (usize, Option<u32>),
    layout: &Layout,
    (context, notes): (&Context, &mut Notes),
    cell: Cell,
) -> Result<GrainTable, Located> {
    // Grows with what is there, not with what the header claims.
    let mut rows = Rows::new(&layout.atoms, &layout.extras);
    let columns = layout.atoms.len();
    while let Some((line, content)) = next_values(lines)? {
        if rows.len() == expected {
            let name = "Atoms";
            return Err(FileProblem::TooManyLines { name, expected }.at(line, None));
        }
        let found = content.split_whitespace().take(columns + 4).count();
        if found != columns && found != columns + 3 {
            let problem = FileProblem::AtomValues {
                found,
                expected: columns,
                style: layout.style.clone(),
                columns: layout.names(),
            };
            return Err(problem.at(line, None));
        }
        rows.read(line, content.split_whitespace().take(columns))?;
        if let (Some(most), Some(TypeOfGrain::Number(kind))) = (types, rows.last_type())
            && kind > most
        {
            let problem = not_allowed(&kind.to_string(), "it is above the `atom types` of the header");
            return Err(problem.at(line, Some("type")));
        }
        for (flag, name) in content.split_whitespace().skip(columns).zip(["ix", "iy", "iz"]) {
            let allowed = "image flags are whole numbers";
            let flag = (flag.parse::<i32>()).map_err(|_| not_allowed(flag, allowed).at(line, Some(name)))?;
            if flag != 0 {
                notes.add("image flags are left out".to_owned());
            }
        }
    }
    let found = rows.len();
    if found < expected {
        let name = "Atoms";
        return Err(FileProblem::CutShort { name, found, expected }.into());
    }
    rows.finish(context.options.diameter, Some(cell))
}

/// Names of types, by their numbers.
fn read_labels(lines: &mut Lines, labels: &mut BTreeMap<u32, String>) -> Result<(), Located> {
    while let Some((line, content)) = next_values(lines)? {
        let words: Vec<&str> = content.split_whitespace().take(3).collect();
        let [number, label] = words[..] else {
            let (found, expected) = (words.len(), "2 (type label)".to_owned());
            return Err(FileProblem::ValueCount { found, expected }.at(line, None));
        };
        let added = whole(number).and_then(|number| add_label(labels, number, label.trim_matches('"')));
        added.map_err(|problem| problem.at(line, Some("type")))?;
    }
    Ok(())
}

/// Velocity and angular velocity of every atom, in the order of the atoms.
fn read_velocities(
    lines: &mut Lines,
    atoms: &GrainTable,
    layout: &Layout,
    units: &FileUnits,
) -> Result<Vec<[DVec3; 2]>, Located> {
    let expected = atoms.len();
    let names = &layout.velocities;
    let mut order: Vec<u32> = (0..expected as u32).collect();
    order.sort_by_key(|i| atoms.id(*i as usize));
    let mut read: Vec<Option<[DVec3; 2]>> = vec![None; expected];
    let mut found = 0;
    while let Some((line, content)) = next_values(lines)? {
        let words: Vec<&str> = content.split_whitespace().take(8).collect();
        if words.len() != names.len() + 1 {
            let expected = format!("{} (id {})", names.len() + 1, names.join(" "));
            let found = words.len();
            return Err(FileProblem::ValueCount { found, expected }.at(line, None));
        }
        let id = whole(words[0]).map_err(|problem| problem.at(line, Some("id")))?;
        let place = (order.binary_search_by_key(&id, |i| atoms.id(*i as usize)))
            .map_err(|_| FileProblem::UnknownId { id }.at(line, Some("id")))?;
        let mut values = [0.0; 6];
        for (k, name) in names.iter().enumerate() {
            let factor = if k < 3 { units.velocity() } else { units.rate() };
            values[k] = number(words[k + 1]).map_err(|problem| problem.at(line, Some(name)))? * factor;
        }
        let slot = &mut read[order[place] as usize];
        if slot.is_some() {
            return Err(FileProblem::DuplicateId { id }.at(line, Some("id")));
        }
        *slot = Some([DVec3::from_slice(&values[..3]), DVec3::from_slice(&values[3..])]);
        found += 1;
    }
    let name = "Velocities";
    let all: Option<Vec<_>> = read.into_iter().collect();
    all.ok_or_else(|| FileProblem::CutShort { name, found, expected }.into())
}

#[cfg(test)]
#[path = "lammps_data_tests.rs"]
mod tests;
