//! Cuts faces of any number of corners into triangles.
//!
//! A strictly convex face becomes a fan about its first corner. Any other is cut by clipping ears (G. H. Meisters, Am.
//! Math. Monthly 82 (1975) 648) in its projection along the normal of M. E. Newell. Where no ear is left, because the
//! outline crosses itself or the face is far from flat, the rest becomes a fan, and the face is counted as twisted.

use super::MeshFileError;
use glam::{DVec2, DVec3};
use std::path::Path;

/// Most corners of a face that is not strictly convex: the work grows with their cube at worst.
pub(super) const MOST_CONCAVE: usize = 512;

/// Corners that are apart across their face by more than this share of its length do not lie in a plane.
const FLAT: f64 = 0.01;

/// Turns whose sine is less than this are straight on.
const STRAIGHT: f64 = 1e-9;

/// Collects the faces of a file as triangles.
pub(super) struct Cutter<'a> {
    path: &'a Path,
    vertices: &'a [DVec3],
    /// Number of the first vertex in the file.
    first: usize,
    /// Triangles so far.
    pub(super) triangles: Vec<[DVec3; 3]>,
    faces: usize,
    /// Faces of more than three corners.
    pub(super) polygons: usize,
    /// Those of them whose outline crosses itself, or which are far from flat.
    pub(super) twisted: usize,
    /// Those whose corners do not lie in a plane, and how far apart these are across it at most.
    pub(super) warped: (usize, f64),
}

impl<'a> Cutter<'a> {
    pub(super) fn new(path: &'a Path, vertices: &'a [DVec3], first: usize) -> Self {
        Cutter {
            path,
            vertices,
            first,
            triangles: Vec::new(),
            faces: 0,
            polygons: 0,
            twisted: 0,
            warped: (0, 0.0),
        }
    }

    /// Adds a face by the indices of its corners, counted from 0.
    pub(super) fn add(&mut self, indices: &[usize]) -> Result<(), MeshFileError> {
        self.faces += 1;
        let (face, corners) = (self.faces, indices.len());
        let path = || self.path.to_owned();
        if let Some(index) = indices.iter().find(|&&index| index >= self.vertices.len()) {
            return Err(MeshFileError::NoSuchVertex {
                path: path(),
                face,
                index: (index + self.first).to_string(),
                vertices: self.vertices.len(),
            });
        }
        if corners < 3 {
            let path = path();
            return Err(MeshFileError::TooFewCorners { path, face, corners });
        }
        let at = |k: usize| self.vertices[indices[k]];
        if corners == 3 {
            self.triangles.push([at(0), at(1), at(2)]);
            return Ok(());
        }
        self.polygons += 1;
        let points: Vec<DVec3> = (0..corners).map(at).collect();
        let (warp, length) = warp(&points);
        if warp > FLAT * length {
            self.warped = (self.warped.0 + 1, self.warped.1.max(warp));
        }
        let flat = project(&points);
        if is_strictly_convex(&flat) {
            self.push_fan(&points);
            return Ok(());
        }
        if corners > MOST_CONCAVE {
            let path = path();
            return Err(MeshFileError::TooManyCorners { path, face, corners });
        }
        self.clip_ears(&points, &flat);
        Ok(())
    }

    fn push_fan(&mut self, points: &[DVec3]) {
        let fan = points.windows(2).skip(1).map(|pair| [points[0], pair[0], pair[1]]);
        self.triangles.extend(fan);
    }

    fn clip_ears(&mut self, points: &[DVec3], flat: &[DVec2]) {
        let mut left: Vec<usize> = (0..points.len()).collect();
        while left.len() > 3 {
            let Some(ear) = (0..left.len()).find(|&k| is_ear(&left, k, flat)) else {
                self.twisted += 1;
                break;
            };
            let [before, at, after] = around(&left, ear);
            self.triangles.push([points[before], points[at], points[after]]);
            left.remove(ear);
        }
        let rest: Vec<DVec3> = left.iter().map(|&k| points[k]).collect();
        self.push_fan(&rest);
    }
}

/// How far apart the corners of a face are along its normal at most, and how far from the first of them.
fn warp(points: &[DVec3]) -> (f64, f64) {
    let normal = newell_normal(points).normalize_or_zero();
    let from_first = || points.iter().map(|&point| point - points[0]);
    let heights = || from_first().map(|way| way.dot(normal));
    let apart = heights().fold(0.0, f64::max) - heights().fold(0.0, f64::min);
    (apart, from_first().map(DVec3::length).fold(0.0, f64::max))
}

fn newell_normal(points: &[DVec3]) -> DVec3 {
    let from_first = |k: usize| points[k % points.len()] - points[0];
    (0..points.len()).map(|k| from_first(k).cross(from_first(k + 1))).sum()
}

/// The corners in the plane across the normal of the face, counter-clockwise, about the first of them.
fn project(points: &[DVec3]) -> Vec<DVec2> {
    let origin = points[0];
    let normal = newell_normal(points);
    let size = normal.abs();
    let axis = if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    };
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let side = if normal[axis] < 0.0 { -1.0 } else { 1.0 };
    let flat = |point: &DVec3| DVec2::new((point[u] - origin[u]) * side, point[v] - origin[v]);
    points.iter().map(flat).collect()
}

/// Sine of the turn at `b` times the lengths of both sides, and these lengths.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> (f64, f64) {
    let (before, after) = (b - a, c - b);
    (before.perp_dot(after), before.length() * after.length())
}

fn turns_left(a: DVec2, b: DVec2, c: DVec2) -> bool {
    let (sine, lengths) = turn(a, b, c);
    sine > STRAIGHT * lengths
}

/// Whether every corner turns left and the outline goes round once.
fn is_strictly_convex(flat: &[DVec2]) -> bool {
    let n = flat.len();
    let corners = (0..n).all(|k| turns_left(flat[k], flat[(k + 1) % n], flat[(k + 2) % n]));
    corners && (1..n - 1).all(|k| turns_left(flat[0], flat[k], flat[k + 1]))
}

fn around(left: &[usize], k: usize) -> [usize; 3] {
    let n = left.len();
    [left[(k + n - 1) % n], left[k], left[(k + 1) % n]]
}

/// Whether a corner can be cut off: it turns left, and no other corner is in the triangle or on its rim.
fn is_ear(left: &[usize], k: usize, flat: &[DVec2]) -> bool {
    let [a, b, c] = around(left, k).map(|index| flat[index]);
    if !turns_left(a, b, c) {
        return false;
    }
    let n = left.len();
    let others = (2..n - 1).map(|step| flat[left[(k + step) % n]]);
    others
        .filter(|&point| point != a && point != b && point != c)
        .all(|point| {
            let outside = |from: DVec2, to: DVec2| (to - from).perp_dot(point - from) < 0.0;
            outside(a, b) || outside(b, c) || outside(c, a)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(points: &[[f64; 2]]) -> (Vec<[DVec3; 3]>, usize) {
        // in a plane that is not one of the axes
        let vertices: Vec<DVec3> = points
            .iter()
            .map(|p| DVec3::new(p[0], p[1], 0.5 * p[0] - p[1]))
            .collect();
        let mut cutter = Cutter::new(Path::new("face"), &vertices, 0);
        let indices: Vec<usize> = (0..points.len()).collect();
        cutter.add(&indices).unwrap();
        (cutter.triangles, cutter.twisted)
    }

    /// Sum of the signed areas seen along z, and of their magnitudes.
    fn areas(triangles: &[[DVec3; 3]]) -> (f64, f64) {
        let signed = triangles.iter().map(|[a, b, c]| 0.5 * (*b - *a).cross(*c - *a).z);
        (signed.clone().sum(), signed.map(f64::abs).sum())
    }

    #[test]
    fn convex_and_concave_faces_keep_their_area_and_nothing_overlaps() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let arrow = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.5, 1.0]];
        let comb = [
            [0.0, 0.0],
            [5.0, 0.0],
            [5.0, 3.0],
            [4.0, 3.0],
            [4.0, 1.0],
            [3.0, 1.0],
            [3.0, 3.0],
            [2.0, 3.0],
            [2.0, 1.0],
            [1.0, 1.0],
            [1.0, 3.0],
            [0.0, 3.0],
        ];
        let on_a_side = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        for (points, area) in [(&square[..], 1.0), (&arrow, 1.5), (&comb, 11.0), (&on_a_side, 4.0)] {
            for reversed in [false, true] {
                let mut points = points.to_vec();
                if reversed {
                    points.reverse();
                }
                let (triangles, twisted) = cut(&points);
                let (signed, magnitude) = areas(&triangles);
                assert_eq!((triangles.len(), twisted), (points.len() - 2, 0));
                assert!(
                    (signed.abs() - area).abs() < 1e-12 && (magnitude - area).abs() < 1e-12,
                    "{points:?}"
                );
                let flat = triangles.iter().filter(|t| areas(&[**t]).1 < 1e-9).count();
                assert_eq!(flat, 0, "no triangle without area: {points:?}");
            }
        }
    }

    #[test]
    fn faces_whose_corners_lie_in_no_plane_are_counted_with_how_far_they_are_from_it() {
        let warped = |height: f64| {
            let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
            let at = |(k, [x, y]): (usize, [f64; 2])| DVec3::new(x, y, if k == 1 { height } else { 0.0 });
            let vertices: Vec<DVec3> = corners.into_iter().enumerate().map(at).collect();
            let mut cutter = Cutter::new(Path::new("face"), &vertices, 0);
            (0..2).for_each(|_| cutter.add(&[0, 1, 2, 3]).unwrap());
            cutter.warped
        };
        assert_eq!(warped(0.0), (0, 0.0));
        assert_eq!(warped(0.01), (0, 0.0));
        // along (-1, 1, 8) two corners lie beyond the others
        let (count, apart) = warped(0.5);
        let expected = 2.0 / 66f64.sqrt();
        assert_eq!(count, 2);
        assert!((apart - expected).abs() < 1e-12, "{apart}, {expected}");
    }

    #[test]
    fn a_face_that_crosses_itself_is_counted_and_no_endless_loop() {
        let bow = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        let (triangles, _) = cut(&bow);
        assert_eq!(triangles.len(), 2);
        let point = [[0.0, 0.0]; 6];
        let (triangles, twisted) = cut(&point);
        assert_eq!((triangles.len(), twisted), (4, 1));
    }
}
