//! The published files, made into those that the scenarios name.
//!
//! Grains: one header line, then `radius x y z` [m]; lines of other length are no grains (empty ones, and a line of six numbers that
//! tells of the ball). Walls: one header line, then three corners of a triangle [m] per line.

use super::{Case, DostaError, Kind};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

/// Largest published file [bytes].
const MAX_BYTES: u64 = 1 << 30;
/// Radius between those of the two kinds of grains in the drum [m]: M2 is the larger.
const BETWEEN_KINDS: f64 = 1.5e-3;

/// Files that a scenario names, in one folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Files {
    /// The folder.
    pub folder: PathBuf,
    /// Number of grains.
    pub grains: usize,
    /// Number of triangles.
    pub triangles: usize,
}

/// Writes the files of a case into a folder.
pub fn prepare(case: &Case, data: &Path, folder: &Path) -> Result<Files, DostaError> {
    fs::create_dir_all(folder).map_err(DostaError::io("make the folder", folder))?;
    let mut files = Files {
        folder: folder.to_owned(),
        grains: 0,
        triangles: 0,
    };
    if let Some(walls) = case.files.first() {
        let path = data.join(walls);
        let triangles = rows::<9>(&path)?;
        if let Some(row) = rows_of_other_length(&path, 9)? {
            return Err(DostaError::Data {
                path,
                found: row,
                expected: "every line behind the first tells the three corners of a triangle, nine numbers",
            });
        }
        files.triangles = triangles.len();
        write(&folder.join("walls.stl"), &stl(&triangles))?;
    }
    if let Some(particles) = case.files.get(1) {
        let grains = rows::<4>(&data.join(particles))?;
        files.grains = grains.len();
        match case.kind {
            Kind::Drum => {
                let (m2, m1): (Vec<_>, Vec<_>) = grains.into_iter().partition(|grain| grain[0] > BETWEEN_KINDS);
                write(&folder.join("m1.csv"), &csv(&m1))?;
                write(&folder.join("m2.csv"), &csv(&m2))?;
            }
            Kind::Penetration | Kind::Silo(_) => write(&folder.join("bed.csv"), &csv(&grains))?,
        }
    }
    Ok(files)
}

fn read(path: &Path) -> Result<String, DostaError> {
    let length = fs::metadata(path).map_err(DostaError::io("read", path))?.len();
    if length > MAX_BYTES {
        return Err(DostaError::Data {
            path: path.to_owned(),
            found: format!("{length} bytes"),
            expected: "the published files have a few megabytes",
        });
    }
    let bytes = fs::read(path).map_err(DostaError::io("read", path))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The numbers of a line, when it holds nothing else.
fn numbers(line: &str) -> Option<Vec<f64>> {
    let number = |word: &str| word.parse::<f64>().ok().filter(|x| x.is_finite());
    line.split_whitespace().map(number).collect()
}

/// All lines behind the header that are so many numbers.
fn rows<const N: usize>(path: &Path) -> Result<Vec<[f64; N]>, DostaError> {
    let text = read(path)?;
    let rows: Vec<[f64; N]> = text
        .lines()
        .skip(1)
        .filter_map(|line| numbers(line)?.try_into().ok())
        .collect();
    if rows.is_empty() {
        return Err(DostaError::Data {
            path: path.to_owned(),
            found: format!("no line of {N} numbers"),
            expected: "it is not one of the published files",
        });
    }
    Ok(rows)
}

/// A line behind the header that is neither empty nor of so many numbers.
fn rows_of_other_length(path: &Path, length: usize) -> Result<Option<String>, DostaError> {
    let text = read(path)?;
    let is_other = |line: &&str| !line.trim().is_empty() && numbers(line).is_none_or(|row| row.len() != length);
    let other = text.lines().skip(1).enumerate().find(|(_, line)| is_other(line));
    Ok(other.map(|(k, line)| format!("`{}` in line {}", line.trim(), k + 2)))
}

fn csv(grains: &[[f64; 4]]) -> String {
    let mut text = String::from("x,y,z,radius\n");
    for [radius, x, y, z] in grains {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{x:?},{y:?},{z:?},{radius:?}");
    }
    text
}

/// ASCII, which keeps all digits.
fn stl(triangles: &[[f64; 9]]) -> String {
    let mut text = String::from("solid walls\n");
    for corners in triangles {
        text.push_str("facet normal 0 0 0\nouter loop\n");
        for corner in corners.chunks_exact(3) {
            let _ = writeln!(text, "vertex {:?} {:?} {:?}", corner[0], corner[1], corner[2]);
        }
        text.push_str("endloop\nendfacet\n");
    }
    text.push_str("endsolid walls\n");
    text
}

fn write(path: &Path, text: &str) -> Result<(), DostaError> {
    fs::write(path, text).map_err(DostaError::io("write", path))
}
