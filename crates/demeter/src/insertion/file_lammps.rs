//! LAMMPS and LIGGGHTS data files of `atom_style sphere`
//! (<https://docs.lammps.org/read_data.html>): header, section Atoms with `id type diameter density x y z` and maybe
//! three image flags, section Velocities with `id vx vy vz wx wy wz`. Numbers are taken as SI. The image flags are read
//! and dropped: places are those inside the box.

use super::grain_file::{
    FileProblem, GrainTable, Located, TypeOfGrain, check_ids, density, diameter, number, shown, whole,
};
use glam::DVec3;

/// Lines searched for the count of atoms when a file's format is told.
const HEADER_LINES: usize = 200;
/// What the header may count besides atoms, in the singular.
const OTHERS: [&str; 8] = [
    "bond",
    "angle",
    "dihedral",
    "improper",
    "ellipsoid",
    "line",
    "triangle",
    "bodie",
];
const BOUNDS: [[&str; 2]; 3] = [["xlo", "xhi"], ["ylo", "yhi"], ["zlo", "zhi"]];

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
}

/// Atoms as they are read.
#[derive(Default)]
struct Atoms {
    ids: Vec<u32>,
    types: Vec<TypeOfGrain>,
    diameters: Vec<f64>,
    densities: Vec<f64>,
    positions: Vec<DVec3>,
    lines: Vec<u32>,
}

/// Lines that say something, after the title.
struct Lines<'a> {
    lines: std::iter::Peekable<std::iter::Skip<std::iter::Enumerate<std::str::Lines<'a>>>>,
}

impl<'a> Lines<'a> {
    /// The next line with content: its number, its content and the whole.
    fn next(&mut self) -> Option<(usize, &'a str, &'a str)> {
        for (k, line) in self.lines.by_ref() {
            if !content(line).is_empty() {
                return Some((k + 1, content(line), line));
            }
        }
        None
    }

    /// The next line of values, or nothing when a section name or the end follows.
    fn next_values(&mut self) -> Option<(usize, &'a str)> {
        while let Some((_, line)) = self.lines.peek() {
            let starts_section = content(line).starts_with(|c: char| c.is_ascii_alphabetic());
            if starts_section && !content(line).to_ascii_lowercase().starts_with("nan") {
                return None;
            }
            if let Some((k, line)) = self.lines.next()
                && !content(line).is_empty()
            {
                return Some((k + 1, content(line)));
            }
        }
        None
    }
}

/// Reads a data file.
pub(super) fn parse(text: &str) -> Result<GrainTable, Located> {
    let mut lines = Lines {
        lines: text.lines().enumerate().skip(1).peekable(),
    };
    let mut header = Header::default();
    let mut atoms: Option<Atoms> = None;
    let mut velocities: Option<Vec<[DVec3; 2]>> = None;
    while let Some((line, content, whole_line)) = lines.next() {
        if !content.starts_with(|c: char| c.is_ascii_alphabetic()) {
            read_header(&mut header, content).map_err(|problem| problem.at(line, None))?;
            continue;
        }
        match content {
            "Atoms" if atoms.is_some() => return Err(FileProblem::TwiceSection { name: "Atoms" }.at(line, None)),
            "Atoms" => {
                check_style(whole_line).map_err(|problem| problem.at(line, None))?;
                let expected =
                    (header.atoms).ok_or_else(|| FileProblem::HeaderMissing { what: "atoms" }.at(line, None))?;
                atoms = Some(read_atoms(&mut lines, expected as usize, header.types)?);
            }
            "Velocities" if velocities.is_some() => {
                return Err(FileProblem::TwiceSection { name: "Velocities" }.at(line, None));
            }
            "Velocities" => {
                let missing = || FileProblem::MissingSection { name: "Atoms" }.at(line, None);
                velocities = Some(read_velocities(&mut lines, atoms.as_ref().ok_or_else(missing)?)?);
            }
            name => {
                let name = shown(name);
                return Err(FileProblem::UnknownSection { name }.at(line, None));
            }
        }
    }
    finish(&header, atoms, velocities)
}

fn finish(header: &Header, atoms: Option<Atoms>, velocities: Option<Vec<[DVec3; 2]>>) -> Result<GrainTable, Located> {
    if header.atoms.is_none() {
        return Err(FileProblem::HeaderMissing { what: "atoms" }.into());
    }
    let atoms = atoms.ok_or(FileProblem::MissingSection { name: "Atoms" })?;
    if atoms.ids.is_empty() {
        return Err(FileProblem::NoGrains.into());
    }
    let mut bounds = (DVec3::ZERO, DVec3::ZERO);
    for (k, what) in ["xlo xhi", "ylo yhi", "zlo zhi"].into_iter().enumerate() {
        (bounds.0[k], bounds.1[k]) = header.bounds[k].ok_or(FileProblem::HeaderMissing { what })?;
    }
    let part = |k: usize| velocities.as_ref().map(|v| v.iter().map(|both| both[k]).collect());
    Ok(GrainTable {
        velocities: part(0),
        angular_velocities: part(1),
        ids: Some(atoms.ids),
        types: Some(atoms.types),
        type_names: Vec::new(),
        positions: atoms.positions,
        diameters: atoms.diameters,
        densities: Some(atoms.densities),
        bounds: Some(bounds),
    })
}

fn read_header(header: &mut Header, content: &str) -> Result<(), FileProblem> {
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
                return Err(super::grain_file::not_allowed(
                    content,
                    "the lower side must be below the upper",
                ));
            }
            header.bounds[axis] = Some((from, to));
        }
        (_, ["xy", "xz", "yz"]) | (_, ["avec" | "bvec" | "cvec" | "abc", ..]) => {
            return Err(FileProblem::NotSpheres {
                what: "a triclinic box".to_owned(),
            });
        }
        // Space for what may be bonded later says nothing of the grains.
        (_, ["extra", ..]) => {}
        (&[count], &[kind, ..]) if OTHERS.iter().any(|other| kind.trim_end_matches('s') == *other) => {
            if count != "0" {
                return Err(FileProblem::NotSpheres {
                    what: format!("an entry of `{}`", names.join(" ")),
                });
            }
        }
        _ => return Err(FileProblem::UnknownHeader { text: shown(content) }),
    }
    Ok(())
}

/// Checks the style that a comment behind the section name tells, as LAMMPS writes it.
fn check_style(line: &str) -> Result<(), FileProblem> {
    match line.split_once('#').map(|(_, comment)| comment.trim()) {
        // `granular` is the name of the style in LIGGGHTS.
        None | Some("" | "sphere" | "granular") => Ok(()),
        Some(style) => Err(FileProblem::Style { style: shown(style) }),
    }
}

fn read_atoms(lines: &mut Lines, expected: usize, types: Option<u32>) -> Result<Atoms, Located> {
    // Grows with what is there, not with what the header claims.
    let mut atoms = Atoms::default();
    while let Some((line, content)) = lines.next_values() {
        if atoms.ids.len() == expected {
            return Err(FileProblem::TooManyLines {
                name: "Atoms",
                expected,
            }
            .at(line, None));
        }
        let words: Vec<&str> = content.split_whitespace().take(12).collect();
        if words.len() != 7 && words.len() != 10 {
            return Err(FileProblem::AtomValues { found: words.len() }.at(line, None));
        }
        let at = |name: &'static str| move |problem: FileProblem| problem.at(line, Some(name));
        let kind = whole(words[1]).map_err(at("type"))?;
        if types.is_some_and(|most| kind > most) {
            let problem = super::grain_file::not_allowed(words[1], "it is above the `atom types` of the header");
            return Err(problem.at(line, Some("type")));
        }
        atoms.ids.push(whole(words[0]).map_err(at("id"))?);
        atoms.types.push(TypeOfGrain::Number(kind));
        let size = number(words[2]).and_then(|value| diameter(value, words[2]));
        atoms.diameters.push(size.map_err(at("diameter"))?);
        let mass_density = number(words[3]).and_then(|value| density(value, words[3]));
        atoms.densities.push(mass_density.map_err(at("density"))?);
        let mut position = DVec3::ZERO;
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            position[axis] = number(words[4 + axis]).map_err(at(name))?;
        }
        atoms.positions.push(position);
        for (flag, name) in words[7..].iter().zip(["ix", "iy", "iz"]) {
            let allowed = "image flags are whole numbers";
            flag.parse::<i32>()
                .map_err(|_| super::grain_file::not_allowed(flag, allowed).at(line, Some(name)))?;
        }
        atoms.lines.push(u32::try_from(line).unwrap_or(u32::MAX));
    }
    let found = atoms.ids.len();
    if found < expected {
        let name = "Atoms";
        return Err(FileProblem::CutShort { name, found, expected }.into());
    }
    check_ids(&atoms.ids, |grain| atoms.lines[grain] as usize)?;
    Ok(atoms)
}

/// Velocity and angular velocity of every atom, in the order of the atoms.
fn read_velocities(lines: &mut Lines, atoms: &Atoms) -> Result<Vec<[DVec3; 2]>, Located> {
    let expected = atoms.ids.len();
    let mut order: Vec<u32> = (0..expected as u32).collect();
    order.sort_by_key(|i| atoms.ids[*i as usize]);
    let mut read: Vec<Option<[DVec3; 2]>> = vec![None; expected];
    let mut found = 0;
    while let Some((line, content)) = lines.next_values() {
        let words: Vec<&str> = content.split_whitespace().take(8).collect();
        if words.len() != 7 {
            let expected = "7 (id vx vy vz wx wy wz)".to_owned();
            return Err(FileProblem::ValueCount {
                found: words.len(),
                expected,
            }
            .at(line, None));
        }
        let id = whole(words[0]).map_err(|problem| problem.at(line, Some("id")))?;
        let place = (order.binary_search_by_key(&id, |i| atoms.ids[*i as usize]))
            .map_err(|_| FileProblem::UnknownId { id }.at(line, Some("id")))?;
        let mut values = [0.0; 6];
        for (k, name) in ["vx", "vy", "vz", "wx", "wy", "wz"].into_iter().enumerate() {
            values[k] = number(words[k + 1]).map_err(|problem| problem.at(line, Some(name)))?;
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
#[path = "file_lammps_tests.rs"]
mod tests;
