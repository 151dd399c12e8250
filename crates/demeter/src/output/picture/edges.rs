//! Walls as thin lines: the edges where a surface ends, bends, or turns away from the viewer.

use super::camera::Camera;
use super::spheres::{Seen, Sight};
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// Cosine of the angle between neighbouring triangles above which their common edge is drawn: 30 degrees.
const BEND: f64 = 0.866;

/// A line, in the frame of the camera.
pub(super) type Line = [DVec3; 2];

/// Exact place of a point, as a key with a fixed order.
type Place = [u64; 3];

fn place(p: DVec3) -> Place {
    // Adding 0 makes one key of 0 and -0.
    p.to_array().map(|x| (x + 0.0).to_bits())
}

/// The lines that show a surface, whose triangles are in the frame of the camera.
pub(super) fn feature_lines(triangles: &[[DVec3; 3]]) -> Vec<Line> {
    let mut normals: BTreeMap<(Place, Place), (Line, Vec<DVec3>)> = BTreeMap::new();
    for triangle in triangles {
        let normal = (triangle[1] - triangle[0])
            .cross(triangle[2] - triangle[0])
            .normalize_or_zero();
        for k in 0..3 {
            let (mut a, mut b) = (triangle[k], triangle[(k + 1) % 3]);
            if place(a) > place(b) {
                std::mem::swap(&mut a, &mut b);
            }
            let entry = normals.entry((place(a), place(b)));
            entry.or_insert(([a, b], Vec::new())).1.push(normal);
        }
    }
    let lines = normals.into_values().filter(|(line, sides)| match sides[..] {
        [first, second] => {
            // Triangles of a list need not all be turned the same way.
            let cosine = first.dot(second);
            let second = if cosine < 0.0 { -second } else { second };
            let faces = |normal: DVec3| normal.dot(line[0]) > 0.0;
            cosine.abs() < BEND || faces(first) != faces(second)
        }
        _ => true,
    });
    lines.map(|(line, _)| line).collect()
}

/// How much of every pixel lines cover, where nothing that is seen is in front of them.
pub(super) fn draw(lines: &[Line], sight: Sight, seen: &[Seen], width: usize, half_thickness: f64) -> Vec<f32> {
    let mut cover = vec![0.0; seen.len()];
    if width == 0 {
        return cover;
    }
    let size = DVec2::new(width as f64, (seen.len() / width) as f64);
    for line in lines.iter().filter_map(|line| sight.planes.clip(*line)) {
        if let Some(stroke) = Stroke::new(&line, sight.camera, size) {
            stroke.draw(&mut cover, seen, width, half_thickness);
        }
    }
    cover
}

/// The part of a line that is in the picture, in pixels with the inverse of the depth.
struct Stroke {
    ends: [DVec2; 2],
    inverse_depths: [f64; 2],
}

impl Stroke {
    fn new(line: &Line, camera: &Camera, size: DVec2) -> Option<Self> {
        let [mut a, mut b] = *line;
        if !(a.is_finite() && b.is_finite()) {
            return None;
        }
        if a.z > b.z {
            std::mem::swap(&mut a, &mut b);
        }
        // What is behind the camera, or nearly so, is cut off.
        let near = 1e-3 * b.z;
        if near <= 0.0 {
            return None;
        }
        if a.z < near {
            a = b + (a - b) * ((b.z - near) / (b.z - a.z));
        }
        let ends = [camera.pixel(a), camera.pixel(b)];
        let (from, to) = inside(ends, size)?;
        let between = |x: f64, y: f64, t: f64| x + (y - x) * t;
        let inverse = |t: f64| between(1.0 / a.z, 1.0 / b.z, t);
        Some(Self {
            ends: [from, to].map(|t| ends[0] + (ends[1] - ends[0]) * t),
            inverse_depths: [inverse(from), inverse(to)],
        })
    }

    fn draw(&self, cover: &mut [f32], seen: &[Seen], width: usize, half_thickness: f64) {
        let [a, b] = self.ends;
        let along = b - a;
        let length = along.length();
        if length <= 0.0 {
            return;
        }
        let steep = along.y.abs() > along.x.abs();
        let (major, minor) = if steep { (1, 0) } else { (0, 1) };
        let sizes = [width, seen.len() / width];
        let reach = (half_thickness + 0.5) * length / along[major].abs();
        let pixels = |low: f64, high: f64, size: usize| {
            (low.max(0.0).floor() as usize)..(high.max(0.0).ceil() as usize).min(size)
        };
        for u in pixels(a[major].min(b[major]), a[major].max(b[major]), sizes[major]) {
            let t = ((u as f64 + 0.5 - a[major]) / along[major]).clamp(0.0, 1.0);
            let middle = a[minor] + t * along[minor];
            let depth = 1.0 / (self.inverse_depths[0] + t * (self.inverse_depths[1] - self.inverse_depths[0]));
            for v in pixels(middle - reach, middle + reach, sizes[minor]) {
                let index = if steep { u * width + v } else { v * width + u };
                let distance = (v as f64 + 0.5 - middle).abs() * along[major].abs() / length;
                let share = (half_thickness + 0.5 - distance).clamp(0.0, 1.0) as f32;
                // A line that lies on a grain is drawn.
                if depth * 0.9995 <= f64::from(seen[index].depth) {
                    cover[index] = cover[index].max(share);
                }
            }
        }
    }
}

/// The part of a line that is inside a picture, as shares of its length (Liang and Barsky, 1984).
fn inside(ends: [DVec2; 2], size: DVec2) -> Option<(f64, f64)> {
    let d = ends[1] - ends[0];
    let (mut from, mut to) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        for (p, q) in [(-d[axis], ends[0][axis]), (d[axis], size[axis] - ends[0][axis])] {
            if p == 0.0 && q < 0.0 {
                return None;
            }
            if p < 0.0 {
                from = from.max(q / p);
            } else if p > 0.0 {
                to = to.min(q / p);
            }
        }
    }
    (from < to).then_some((from, to))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quad(corners: [DVec3; 4]) -> [[DVec3; 3]; 2] {
        let [a, b, c, d] = corners;
        [[a, b, c], [a, c, d]]
    }

    fn corner(k: usize) -> DVec3 {
        DVec3::new((k & 1) as f64, (k >> 1 & 1) as f64, 5.0 + (k >> 2 & 1) as f64)
    }

    #[test]
    fn a_box_has_twelve_edges_and_no_diagonal() {
        let faces = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let triangles: Vec<[DVec3; 3]> = faces.iter().flat_map(|face| quad(face.map(corner))).collect();
        let lines = feature_lines(&triangles);
        assert_eq!(lines.len(), 12);
        assert!(lines.iter().all(|line| (line[0].distance(line[1]) - 1.0).abs() < 1e-12));
    }

    #[test]
    fn a_rectangle_has_its_rim() {
        let triangles = quad([corner(0), corner(1), corner(3), corner(2)]);
        assert_eq!(feature_lines(&triangles).len(), 4);
        let [first, [a, b, c]] = triangles;
        assert_eq!(feature_lines(&[first, [c, b, a]]).len(), 4);
    }

    #[test]
    fn a_line_is_cut_at_the_picture() {
        let size = DVec2::new(100.0, 50.0);
        let (from, to) = inside([DVec2::new(-100.0, 25.0), DVec2::new(300.0, 25.0)], size).unwrap();
        assert!((from - 0.25).abs() < 1e-12 && (to - 0.5).abs() < 1e-12);
        assert_eq!(inside([DVec2::new(-10.0, -1.0), DVec2::new(300.0, -1.0)], size), None);
    }
}
