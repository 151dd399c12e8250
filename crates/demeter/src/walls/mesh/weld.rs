//! Joins corners of triangles that are the same point.

use glam::DVec3;
use std::collections::HashMap;

/// Rounding of a coordinate in single precision, in which STL files are written, as a share of the largest coordinate.
pub(super) const ROUNDING: f64 = 2e-7;
/// Least distance of two corners that are joined, as a share of the largest coordinate: it keeps the cells countable.
const LEAST: f64 = 1e-15;
/// Largest distance of two corners that are joined, as a share of the shortest edge.
pub(super) const SAFE_SHARE: f64 = 0.01;
const NONE: u32 = u32::MAX;

/// Triangles that share their corners.
pub(super) struct Welded {
    /// Distinct points, in the order in which they first appear.
    pub(super) points: Vec<DVec3>,
    /// Indices of the corners of every triangle.
    pub(super) triangles: Vec<[u32; 3]>,
    /// Largest distance of two corners that were joined [m].
    pub(super) tolerance: f64,
}

/// Joins every corner to the earliest point within a tolerance [m]; without one, within rounding.
pub(super) fn weld(corners: &[[DVec3; 3]], tolerance: Option<f64>) -> Welded {
    let tolerance = chosen_tolerance(corners, tolerance);
    let mut grid = Grid {
        tolerance,
        first: HashMap::new(),
        next: Vec::new(),
        points: Vec::new(),
    };
    let triangles = corners
        .iter()
        .map(|triangle| triangle.map(|corner| grid.join(corner)))
        .collect();
    Welded {
        points: grid.points,
        triangles,
        tolerance,
    }
}

fn chosen_tolerance(corners: &[[DVec3; 3]], told: Option<f64>) -> f64 {
    let (mut largest, mut shortest) = (0.0f64, f64::MAX);
    for [a, b, c] in corners {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            largest = largest.max(from.abs().max_element());
            shortest = shortest.min(from.distance(*to));
        }
    }
    told.unwrap_or((ROUNDING * largest).min(SAFE_SHARE * shortest))
        .max(LEAST * largest)
        .max(f64::MIN_POSITIVE)
}

struct Grid {
    tolerance: f64,
    /// First point of each cell; the others hang on it through `next`.
    first: HashMap<[i64; 3], u32>,
    next: Vec<u32>,
    points: Vec<DVec3>,
}

impl Grid {
    fn join(&mut self, corner: DVec3) -> u32 {
        let cell = self.cell(corner);
        let mut found = NONE;
        for x in -1..=1 {
            for y in -1..=1 {
                for z in -1..=1 {
                    let neighbour = [cell[0] + x, cell[1] + y, cell[2] + z];
                    let mut point = self.first.get(&neighbour).copied().unwrap_or(NONE);
                    while point != NONE {
                        if self.points[point as usize].distance(corner) <= self.tolerance {
                            found = found.min(point);
                        }
                        point = self.next[point as usize];
                    }
                }
            }
        }
        if found != NONE {
            return found;
        }
        let id = self.points.len() as u32;
        self.points.push(corner);
        self.next.push(self.first.insert(cell, id).unwrap_or(NONE));
        id
    }

    /// Cell of a point; the casts saturate, and cells that far out are only crowded, not wrong.
    fn cell(&self, point: DVec3) -> [i64; 3] {
        (point / (2.0 * self.tolerance))
            .floor()
            .to_array()
            .map(|c| (c as i64).clamp(i64::MIN / 2, i64::MAX / 2))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joins_what_single_precision_tore_apart_and_nothing_else() {
        let p = |x: f64, y: f64| DVec3::new(x, y, 10.0);
        let torn = 1e-6;
        let welded = weld(
            &[
                [p(0.0, 0.0), p(1.0, 0.0), p(0.0, 1.0)],
                [p(1.0, torn), p(1.0, 1.0), p(-torn, 1.0)],
            ],
            None,
        );
        assert_eq!(welded.triangles, vec![[0, 1, 2], [1, 3, 2]]);
        assert_eq!(welded.points.len(), 4);
        let small = 1e-6;
        let fine = weld(&[[p(0.0, 0.0), p(small, 0.0), p(0.0, small)]], None);
        assert_eq!(fine.triangles, vec![[0, 1, 2]]);
    }
}
