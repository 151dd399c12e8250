//! Boxes that files of grains tell, against a domain that repeats itself otherwise.

use crate::grain_files::Cell;
use crate::particles::Domain;

/// How far lengths may differ, as a share of them: files hold few digits.
const ROUNDED: f64 = 1e-6;

/// Tells an insertion whose file tells a box that repeats itself otherwise than the domain does.
pub(super) fn check(insertion: &str, cell: &Cell, domain: &Domain) -> Option<String> {
    let edges = cell.edges();
    let size = domain.size();
    let tilted = cell.is_tilted() && domain.periodic != [false; 3];
    let differs = |k: usize| {
        let both = domain.periodic[k] && cell.periodic[k];
        both && (edges[k][k].abs() / size[k] - 1.0).abs() > ROUNDED
    };
    let lengths: Vec<String> = (0..3)
        .filter(|&k| !tilted && differs(k))
        .map(|k| {
            let (axis, own, of_domain) = (["x", "y", "z"][k], edges[k][k].abs(), size[k]);
            format!("{own} m along {axis}, and the domain {of_domain} m")
        })
        .collect();
    let (what, remedy) = match (tilted, lengths.as_slice()) {
        (true, _) => {
            let [xy, xz, yz] = cell.tilt;
            let what = format!(
                "the box of its file is tilted (xy = {xy} m, xz = {xz} m, yz = {yz} m), and the periodic domain is not"
            );
            (
                what,
                "take a file whose box is not tilted, or leave out `domain.periodic`",
            )
        }
        (false, []) => return None,
        (false, told) => {
            let what = format!("the periodic box of its file is {}", told.join("; "));
            (
                what,
                "give the domain the corners of that box, or leave out `periodic` there",
            )
        }
    };
    Some(format!(
        "insertion `{insertion}`: {what}: grains near periodic sides meet others than in the file, and may overlap or leave gaps; {remedy}"
    ))
}
