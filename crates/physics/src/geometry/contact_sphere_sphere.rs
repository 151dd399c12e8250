//! Contact of two spheres.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Geometry of one contact, seen from its first body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// Unit vector from the second body to the first: the direction of a repulsive force on the first.
    pub normal: DVec3,
    /// Overlap [m]; negative across a gap.
    pub overlap: f64,
    /// Distance of the contact point from the centre of the first body [m].
    pub lever_i: f64,
    /// Distance of the contact point from the centre of the second body [m]; 0 for a wall.
    pub lever_j: f64,
}

/// Contact of two spheres with `separation = x_i - x_j`; the contact point lies midway in the overlap,
/// `(d + r_i - r_j)/2` from centre `i`. Coincident centres take the z axis as normal.
#[inline(always)]
pub fn contact_sphere_sphere(separation: DVec3, radius_i: f64, radius_j: f64) -> Contact {
    let distance = separation.length();
    let normal = if distance > 0.0 {
        separation / distance
    } else {
        DVec3::Z
    };
    let lever_i = 0.5 * (distance + radius_i - radius_j);
    Contact {
        normal,
        overlap: radius_i + radius_j - distance,
        lever_i,
        lever_j: distance - lever_i,
    }
}
