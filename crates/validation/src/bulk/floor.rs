//! The floor of a silo, with a round orifice.

use std::f64::consts::TAU;
use std::fmt::Write as _;

/// Corners of the orifice.
const CORNERS: u32 = 96;

/// A flat ring about the axis z at z = 0, as STL: from the radius of the orifice to that of the floor [m].
///
/// The corners of the orifice lie so far out that the polygon has the area of its circle.
pub(super) fn floor(orifice: f64, outer: f64) -> String {
    let step = TAU / f64::from(CORNERS);
    let inner = orifice * (step / libm::sin(step)).sqrt();
    let at = |radius: f64, k: u32| {
        let angle = step * f64::from(k % CORNERS);
        (radius * libm::cos(angle), radius * libm::sin(angle))
    };
    let mut text = String::from("solid floor\n");
    for k in 0..CORNERS {
        let (a, b, c, d) = (at(inner, k), at(outer, k), at(outer, k + 1), at(inner, k + 1));
        for corners in [[a, b, c], [a, c, d]] {
            text.push_str("facet normal 0 0 1\nouter loop\n");
            for (x, y) in corners {
                // Writing to a String cannot fail.
                let _ = writeln!(text, "vertex {x:?} {y:?} 0");
            }
            text.push_str("endloop\nendfacet\n");
        }
    }
    text.push_str("endsolid floor\n");
    text
}
