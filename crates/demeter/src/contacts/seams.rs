//! Where separate walls meet: there a grain is pushed by one of them, as by one surface.
//!
//! A wall that a grain touches at an edge does nothing when that place lies on another wall, too, and that one is nearer to the centre.
//! So a grain on the seam of two plates, or beside the rim at which a cylinder ends on a cone, rebounds as it does from a plate or a
//! cone alone. Within a mesh its [triangles](crate::walls::Mesh) follow the same rule. Of walls that are as near, one pushes that is not
//! touched at an edge, else the first.

use super::Scene;
use crate::walls::{SurfaceContact, Wall};
use glam::DVec3;
use std::cell::RefCell;

/// Within so many radii of the grain two walls meet: more than what single precision makes of coordinates in mesh files.
const MEETS: f64 = 1e-3;

/// Distances that are the same to so many radii are the same.
const SAME: f64 = 1e-9;

/// Distance, whether that is to an edge, and the number of the wall: the same whichever wall is asked, so that of walls that meet one
/// pushes always.
type Rank = (f64, bool, usize);

thread_local! {
    static PARTS: RefCell<Vec<SurfaceContact>> = RefCell::default();
}

impl Scene<'_> {
    /// Whether a grain is pushed by another wall where it touches this one.
    #[inline]
    pub(super) fn is_pushed_by_another(&self, grain: usize, wall: usize, part: &SurfaceContact) -> bool {
        part.is_at_edge && self.walls.len() > 1 && self.is_on_a_nearer(grain, wall, part)
    }

    fn is_on_a_nearer(&self, grain: usize, wall: usize, part: &SurfaceContact) -> bool {
        let (centre, radius) = (self.grains.position[grain], self.grains.radius(grain));
        let place = centre - part.normal * part.distance;
        let meets = |other: &Wall| other.clearance(place, 2.0 * MEETS * radius).abs() <= MEETS * radius;
        let others = (self.walls.iter().enumerate()).filter(|(k, other)| *k != wall && meets(other));
        let mut own: Option<Rank> = None;
        for (k, _) in others {
            let beyond = part.distance + MEETS * radius - radius;
            let rank = |k: usize, element| self.rank(k, element, centre, (radius, beyond));
            let own = own.get_or_insert_with(|| rank(wall, Some(part.element)).unwrap_or((f64::INFINITY, true, wall)));
            if rank(k, None).is_some_and(|rank| rank < *own) {
                return true;
            }
        }
        false
    }

    /// Rank of an element of a wall, or of that of its elements which comes first, of all that a sphere of a radius touches or is so near.
    fn rank(&self, wall: usize, element: Option<u32>, centre: DVec3, (radius, beyond): (f64, f64)) -> Option<Rank> {
        PARTS.with_borrow_mut(|parts| {
            parts.clear();
            self.walls[wall].contacts(centre, (radius, beyond), parts);
            (parts.iter())
                .filter(|part| element.is_none_or(|element| part.element == element))
                .map(|part| ((part.distance / (SAME * radius)).round(), part.is_at_edge, wall))
                .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)))
        })
    }
}
