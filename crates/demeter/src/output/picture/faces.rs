//! Walls as translucent surfaces: how much of every pixel they cover, where nothing that is seen is in front of them.

use super::spheres::{Seen, Sight};
use glam::DVec3;

/// How much one surface covers.
const COVER: f32 = 0.13;
/// No pixel is covered more than this.
const MOST: f32 = 0.45;

/// Draws the triangles of all walls, which are in the frame of the camera.
pub(super) fn draw(walls: &[Vec<[DVec3; 3]>], sight: Sight, seen: &[Seen], width: usize) -> Vec<f32> {
    let mut cover = vec![0.0; seen.len()];
    if width == 0 {
        return cover;
    }
    for triangle in walls.iter().flatten() {
        // What reaches behind the camera is left out; such a wall surrounds the viewer.
        if triangle.iter().all(|p| p.is_finite() && p.z > 0.0) {
            draw_triangle(&mut cover, triangle, sight, seen, width);
        }
    }
    cover
}

fn draw_triangle(cover: &mut [f32], triangle: &[DVec3; 3], sight: Sight, seen: &[Seen], width: usize) {
    let corners = triangle.map(|p| sight.camera.pixel(p));
    let height = seen.len() / width;
    let span = |axis: usize, size: usize| {
        let low = corners.iter().map(|c| c[axis]).fold(f64::INFINITY, f64::min);
        let high = corners.iter().map(|c| c[axis]).fold(f64::NEG_INFINITY, f64::max);
        (low.max(0.0).floor() as usize).min(size)..(high.max(0.0).ceil() as usize).min(size)
    };
    let area = (corners[1] - corners[0]).perp_dot(corners[2] - corners[0]);
    if area == 0.0 {
        return;
    }
    // The inverse of the depth is linear in the picture.
    let inverse = triangle.map(|p| 1.0 / p.z);
    for y in span(1, height) {
        for x in span(0, width) {
            let at = glam::DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
            let weight = |k: usize| {
                let (a, b) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
                (b - a).perp_dot(at - a) / area
            };
            let weights = [weight(0), weight(1), weight(2)];
            // a pixel on a common edge belongs to one of two triangles
            if weights.iter().any(|w| *w < 0.0) {
                continue;
            }
            let depth = 1.0 / (0..3).map(|k| weights[k] * inverse[k]).sum::<f64>();
            let index = y * width + x;
            if depth <= f64::from(seen[index].depth) && sight.planes.keep(depth * sight.camera.ray(x, y)) {
                cover[index] = (cover[index] + COVER).min(MOST);
            }
        }
    }
}
