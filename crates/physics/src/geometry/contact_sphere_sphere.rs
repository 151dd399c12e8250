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
    let Touch {
        normal,
        overlap,
        levers: [lever_i, lever_j],
        ..
    } = contact_sphere_sphere_wide(separation, DVec3::ZERO, [radius_i, radius_j], Normals::Quotients);
    Contact {
        normal,
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

/// How two spheres touch, one pair per lane.
#[derive(Clone, Copy, Debug)]
pub struct Touch<L: Lanes> {
    /// Unit vector from the second to the first.
    pub normal: L::Vector,
    /// Overlap [m].
    pub overlap: L,
    /// Distances of the contact point from both centres [m].
    pub levers: [L; 2],
    /// Rate of approach [m/s].
    pub rate: L,
}

/// The same in every lane, told the velocity of the first centre relative to the second, too.
///
/// By the inverse of the distance what takes long is begun at once: the quotient beside the root, the rate before the normal is known.
#[inline(always)]
pub fn contact_sphere_sphere_wide<L: Lanes>(
    separation: L::Vector,
    velocity: L::Vector,
    [radius_i, radius_j]: [L; 2],
    normals: Normals,
) -> Touch<L> {
    let (zero, one) = (L::splat(0.0), L::splat(1.0));
    let square = separation.square();
    let distance = square.sqrt();
    let apart = square.gt(zero);
    let upwards = L::Vector::new(zero, zero, one);
    let (normal, rate) = match normals {
        Normals::Quotients => {
            let [x, y, z] = separation.components();
            let normal = L::Vector::new(x / distance, y / distance, z / distance).or(apart, upwards);
            (normal, -velocity.inner(normal))
        }
        Normals::Inverse => {
            let inverse = L::select(apart, one / square * distance, one);
            let separation = separation.or(apart, upwards);
            (separation * inverse, -velocity.inner(separation) * inverse)
        }
    };
    let lever_i = (distance + radius_i - radius_j) * 0.5;
    Touch {
        normal,
        overlap: radius_i + radius_j - distance,
        levers: [lever_i, distance - lever_i],
        rate,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn quotients_and_the_inverse_tell_the_same() {
        let velocity = DVec3::new(0.3, -0.2, 0.7);
        for separation in [DVec3::new(1e-3, -2e-3, 5e-4), DVec3::new(0.0, 0.0, -3e-9), DVec3::ZERO] {
            let [exact, inverse] = [Normals::Quotients, Normals::Inverse]
                .map(|normals| contact_sphere_sphere_wide::<f64>(separation, velocity, [2e-3, 1e-3], normals));
            assert_relative_eq!(inverse.normal.distance(exact.normal), 0.0, epsilon = 1e-15);
            assert_relative_eq!(inverse.rate, exact.rate, max_relative = 1e-14);
            assert_relative_eq!(exact.rate, -velocity.dot(exact.normal), max_relative = 1e-15);
            assert_eq!((inverse.overlap, inverse.levers), (exact.overlap, exact.levers));
        }
    }
}
