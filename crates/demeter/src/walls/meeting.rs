//! Where rigid bodies come to other walls. Bodies feel grains alone, so that they would go through these.

use super::outline;
use super::pose::Pose;
use super::wall::Wall;
use glam::DVec3;
use std::sync::OnceLock;

/// Steps between two looks at bodies.
pub(crate) const STEPS_BETWEEN_LOOKS: u64 = 16;
/// How near is as good as touching, as a share of the size of the body.
const TOUCHING: f64 = 1e-6;

/// Corners of the triangles that draw a wall, in its frame, once they were asked for.
pub(super) type Corners = OnceLock<Box<[DVec3]>>;

/// A rigid body, by its index, that comes to another wall, by its, and where [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Meeting {
    pub(crate) body: usize,
    pub(crate) wall: usize,
    pub(crate) place: DVec3,
}

/// The first meeting of a body, or of what moves with it, and a wall that is not of it, before the next look; where steps take `dt` [s].
/// Corners are looked at, on both sides.
pub(crate) fn meeting(walls: &[Wall], dt: f64) -> Option<Meeting> {
    let group = |k: usize| walls[k].leader().filter(|&leader| leader < walls.len()).unwrap_or(k);
    let is_of_body = |k: usize| walls[group(k)].is_body();
    for body in (0..walls.len()).filter(|&k| is_of_body(k)) {
        for wall in (0..walls.len()).filter(|&k| group(k) != group(body)) {
            // two bodies are looked at once
            if is_of_body(wall) && wall < body {
                continue;
            }
            if let Some(place) = walls[body].comes_to(&walls[wall], dt * STEPS_BETWEEN_LOOKS as f64) {
                return Some(Meeting { body, wall, place });
            }
        }
    }
    None
}

impl Wall {
    /// Where a corner of one of two walls comes to the other within a time [s], as both move now.
    fn comes_to(&self, other: &Wall, time: f64) -> Option<DVec3> {
        let (lower, upper) = self.rough_bounds()?;
        let size = (upper - lower).length();
        let reach = time * (self.largest_speed(lower, upper) + other.largest_speed(lower, upper)) + TOUCHING * size;
        if !self.is_present() || !other.near(0.5 * (lower + upper), 0.5 * size + reach) {
            return None;
        }
        let (lower, upper) = (lower - reach, upper + reach);
        let is_beside = |place: &DVec3| place.cmpge(lower).all() && place.cmple(upper).all();
        let mut own = self.placed_corners();
        let mut others = other.placed_corners().filter(is_beside);
        let touches = |wall: &Wall, place: &DVec3| wall.nearest(*place, reach).is_some();
        own.find(|place| touches(other, place))
            .or_else(|| others.find(|place| touches(self, place)))
    }

    /// Corners of the triangles that draw the wall, as it stands; none of an infinite wall.
    fn placed_corners(&self) -> impl Iterator<Item = DVec3> + '_ {
        let corners = self.corners.get_or_init(|| self.drawn_corners());
        let pose = self.pose();
        corners.iter().map(move |&corner| pose.place(self.origin, corner))
    }

    /// Each corner once, in the wall frame.
    fn drawn_corners(&self) -> Box<[DVec3]> {
        let start = Pose::START;
        let Some((lower, upper)) = outline::bounds(self.described(), self.origin, &start) else {
            return Box::default();
        };
        let triangles = outline::triangles(self.described(), self.origin, &start, lower, upper);
        let mut corners: Vec<[f64; 3]> = triangles.iter().flatten().map(|corner| corner.to_array()).collect();
        corners.sort_by(|a, b| a.map(f64::to_bits).cmp(&b.map(f64::to_bits)));
        corners.dedup();
        corners.into_iter().map(DVec3::from_array).collect()
    }
}
