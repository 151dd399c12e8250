//! Contact of two spheres.

use crate::lanes::{Lanes, Vector};
use bytemuck::{Pod, Zeroable};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Geometry of one contact, seen from its first body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Pod, Zeroable)]
#[repr(C)]
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

impl Contact {
    /// Numbers that make up a contact, in the order of its fields.
    pub const NUMBERS: usize = 6;

    /// Contacts as plain numbers, [`Contact::NUMBERS`] each.
    #[inline(always)]
    pub fn numbers(contacts: &[Self]) -> &[f64] {
        bytemuck::cast_slice(contacts)
    }
}

/// Contact of two spheres with `separation = x_i - x_j`; the contact point lies midway in the overlap,
/// `(d + r_i - r_j)/2` from centre `i`. Coincident centres take the z axis as normal.
#[inline(always)]
pub fn contact_sphere_sphere(separation: DVec3, radius_i: f64, radius_j: f64) -> Contact {
    let [x, y, z, overlap, lever_i, lever_j] =
        contact_sphere_sphere_wide(separation, radius_i, radius_j, Normals::Quotients);
    Contact {
        normal: DVec3::new(x, y, z),
        overlap,
        lever_i,
        lever_j,
    }
}

/// How the components of a normal are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Normals {
    /// Each by a quotient. By the inverse, normals of a regular packing would differ in their last bits; near a fold of the
    /// multi-contact equation the regular solution would be lost.
    Quotients,
    /// All by the inverse of the distance.
    Inverse,
}

/// The same in every lane: the components of the normal, the overlap and both levers.
#[inline(always)]
pub fn contact_sphere_sphere_wide<L: Lanes>(
    separation: L::Vector,
    radius_i: L,
    radius_j: L,
    normals: Normals,
) -> [L; 6] {
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    let distance = separation.square().sqrt();
    let apart = distance.gt(zero);
    let normal = match normals {
        Normals::Quotients => {
            let [x, y, z] = separation.components();
            L::Vector::new(x / distance, y / distance, z / distance)
        }
        Normals::Inverse => separation * (one / distance),
    };
    let normal = normal.or(apart, L::Vector::new(zero, zero, one));
    let [x, y, z] = normal.components();
    let lever_i = (distance + radius_i - radius_j) * 0.5;
    [x, y, z, radius_i + radius_j - distance, lever_i, distance - lever_i]
}
