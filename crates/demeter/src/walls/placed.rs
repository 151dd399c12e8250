//! Parts of walls in the world, to which one grain or several at a time are held.

use super::pose::Pose;
use super::shape::Side;
use super::surface::Surface;
use demeter_physics::geometry::contact_sphere_cylinder::Cylinder;
use demeter_physics::geometry::contact_sphere_disc::Disc;
use demeter_physics::geometry::contact_sphere_plane::Plane;
use demeter_physics::geometry::contact_sphere_rectangle::Rectangle;
use demeter_physics::lanes::{Lanes, Mask, Vector};
use glam::DVec3;

/// A part of a wall as it stands now.
#[derive(Clone, Copy, Debug)]
pub(crate) enum PlacedPart {
    /// A plane, and between which places it reaches [m].
    Plane(Plane, (DVec3, DVec3)),
    /// A cylinder with grains on one side, which lies so far along the direction from the axis.
    Cylinder(Cylinder, f64),
    /// A plate without thickness, of which grains are on either side.
    Disc(Disc),
    Rectangle(Rectangle),
}

/// The closest point of a part, one grain per lane.
pub(crate) struct Closest<L: Lanes> {
    /// Unit vector from the part to the grain.
    pub(crate) normal: L::Vector,
    /// Distance of the centre [m].
    pub(crate) distance: L,
    /// Lanes of which this is told: others are at an end, an axis or the like or have been left behind, of which the surface tells.
    pub(crate) told: u32,
}

/// A point nearer to the axis of a cylinder than this, as a share of its distance from the start, may be on it.
const ON_AXIS: f64 = 1e-3;

/// The square of a smaller length may vanish.
const LEAST_LENGTH: f64 = 1e-140;

/// Nearer to its rim than this, as a share of its size, rounding would tell whether a face of a plate or its rim is touched.
const AT_RIM: f64 = 1e-9;

impl PlacedPart {
    /// Places an element of a surface; `None` of those to which grains are held one by one.
    pub(super) fn new(surface: &Surface, element: u32, pose: &Pose, origin: DVec3) -> Option<Self> {
        let placed = |plane: &Plane| Plane {
            point: pose.place(origin, plane.point),
            normal: pose.turn(plane.normal),
        };
        match surface {
            Surface::Plane(plane) => Some(Self::Plane(placed(plane), (DVec3::NEG_INFINITY, DVec3::INFINITY))),
            Surface::Box {
                faces, reach, margin, ..
            } if pose.is_unrotated() => {
                let (_, plane) = faces.iter().find(|(face, _)| *face == element)?;
                let (from, to) = *reach;
                Some(Self::Plane(
                    placed(plane),
                    (from + *margin + pose.translation, to - *margin + pose.translation),
                ))
            }
            Surface::Cylinder(cylinder) => {
                let outward = match cylinder.side {
                    Side::Inside => -1.0,
                    Side::Outside => 1.0,
                    Side::Both => return None,
                };
                let placed = Cylinder {
                    start: pose.place(origin, cylinder.start),
                    axis: pose.turn(cylinder.axis),
                    ..*cylinder
                };
                Some(Self::Cylinder(placed, outward))
            }
            Surface::Disc(disc) => Some(Self::Disc(Disc {
                center: pose.place(origin, disc.center),
                normal: pose.turn(disc.normal),
                ..*disc
            })),
            Surface::Rectangle(plate) => Some(Self::Rectangle(Rectangle {
                center: pose.place(origin, plate.center),
                axes: plate.axes.map(|axis| pose.turn(axis)),
                ..*plate
            })),
            _ => None,
        }
    }

    /// The closest points to some centres of spheres that reach so far [m].
    #[inline(always)]
    pub(crate) fn closest<L: Lanes>(&self, centre: L::Vector, reach: L) -> Closest<L> {
        match self {
            Self::Plane(plane, ends) => of_plane(plane, *ends, centre),
            Self::Cylinder(cylinder, outward) => of_cylinder((cylinder, *outward), centre, reach),
            Self::Disc(disc) => of_disc(disc, centre),
            Self::Rectangle(plate) => of_rectangle(plate, centre),
        }
    }
}

/// The same vector in every lane.
#[inline(always)]
pub(super) fn splat<L: Lanes>(vector: DVec3) -> L::Vector {
    L::Vector::new(L::splat(vector.x), L::splat(vector.y), L::splat(vector.z))
}

#[inline(always)]
fn of_plane<L: Lanes>(plane: &Plane, (from, to): (DVec3, DVec3), centre: L::Vector) -> Closest<L> {
    let normal = splat::<L>(plane.normal);
    let distance = (centre - splat::<L>(plane.point)).inner(normal);
    let foot = (centre - normal * distance).components();
    let (from, to) = (splat::<L>(from).components(), splat::<L>(to).components());
    let mut told = u32::MAX;
    let mut axis = 0;
    while axis < 3 {
        told &= foot[axis].ge(from[axis]).bits() & to[axis].ge(foot[axis]).bits();
        axis += 1;
    }
    Closest { normal, distance, told }
}

/// As [`contact_sphere_cylinder`] finds it between the ends, of spheres that have not wholly passed through the side.
///
/// [`contact_sphere_cylinder`]: demeter_physics::geometry::contact_sphere_cylinder
#[inline(always)]
fn of_cylinder<L: Lanes>((cylinder, outward): (&Cylinder, f64), centre: L::Vector, reach: L) -> Closest<L> {
    let axis = splat::<L>(cylinder.axis);
    let from_start = centre - splat::<L>(cylinder.start);
    let height = from_start.inner(axis);
    let across = from_start - axis * height;
    let beside = across - axis * across.inner(axis);
    let off_axis = beside.square().sqrt();
    let distance = (off_axis - L::splat(cylinder.radius)) * outward;
    let told = height.ge(L::splat(0.0)).bits()
        & (distance + reach).ge(L::splat(0.0)).bits()
        & L::splat(cylinder.length).ge(height).bits()
        & off_axis.gt(from_start.square().sqrt() * ON_AXIS).bits()
        & off_axis.gt(L::splat(LEAST_LENGTH)).bits();
    Closest {
        normal: beside * (L::splat(outward) / off_axis),
        distance,
        told,
    }
}

/// As [`contact_sphere_disc`] finds it off the rim.
///
/// [`contact_sphere_disc`]: demeter_physics::geometry::contact_sphere_disc
#[inline(always)]
fn of_disc<L: Lanes>(disc: &Disc, centre: L::Vector) -> Closest<L> {
    let normal = splat::<L>(disc.normal);
    let from_centre = centre - splat::<L>(disc.center);
    let height = from_centre.inner(normal);
    let beside = (from_centre - normal * height).square();
    let inner = disc.radius * (1.0 - AT_RIM);
    of_plate(normal, height, L::splat(inner * inner).ge(beside).bits())
}

/// As [`contact_sphere_rectangle`] finds it off the edges.
///
/// [`contact_sphere_rectangle`]: demeter_physics::geometry::contact_sphere_rectangle
#[inline(always)]
fn of_rectangle<L: Lanes>(plate: &Rectangle, centre: L::Vector) -> Closest<L> {
    let normal = splat::<L>(plate.normal());
    let from_centre = centre - splat::<L>(plate.center);
    let mut told = u32::MAX;
    let mut axis = 0;
    while axis < 2 {
        let along = from_centre.inner(splat::<L>(plate.axes[axis])).abs();
        told &= L::splat(plate.half[axis] * (1.0 - AT_RIM)).ge(along).bits();
        axis += 1;
    }
    of_plate(normal, from_centre.inner(normal), told)
}

/// Beside a plate, at a height above it, on the side where the grain is.
#[inline(always)]
fn of_plate<L: Lanes>(normal: L::Vector, height: L, told: u32) -> Closest<L> {
    let above = height.ge(L::splat(0.0));
    let facing = L::select(above, L::splat(1.0), L::splat(-1.0));
    Closest {
        normal: normal * facing,
        distance: height.abs(),
        told,
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Motion, Shape, Wall};
    use super::*;

    #[test]
    fn what_is_told_is_the_contact_with_the_surface() {
        let cylinder = |side| Shape::Cylinder {
            start: DVec3::new(0.1, -0.2, 0.3),
            end: DVec3::new(0.9, 0.4, 0.1),
            radius: 0.4,
            side,
        };
        let plane = Shape::Plane {
            point: DVec3::new(0.2, 0.0, -0.1),
            normal: DVec3::new(0.6, 0.0, 0.8),
        };
        let open = Shape::Box {
            lower: DVec3::splat(-0.6),
            upper: DVec3::splat(0.7),
            open: [false, false, false, false, false, true],
        };
        let disc = Shape::Disc {
            center: DVec3::new(0.1, 0.0, -0.1),
            normal: DVec3::new(0.6, 0.0, 0.8),
            radius: 0.9,
        };
        let plate = Shape::Rectangle {
            center: DVec3::new(0.1, 0.0, -0.1),
            half_u: DVec3::new(0.8, 0.0, -0.6) * 0.9,
            half_v: DVec3::new(0.0, 0.7, 0.0),
        };
        let turning = Motion::Rotation {
            point: DVec3::new(0.3, 0.1, 0.0),
            axis: DVec3::new(0.0, 0.6, 0.8),
            angular_velocity: 2.0,
        };
        for (shape, motion) in [
            (cylinder(Side::Inside), turning.clone()),
            (cylinder(Side::Outside), turning.clone()),
            (plane, turning.clone()),
            (disc, turning.clone()),
            (plate, turning),
            (open, Motion::Rest),
        ] {
            let mut wall = Wall::new("wall", 0, shape, motion).unwrap();
            wall.advance(0.2);
            let part = wall.placed_part(0).unwrap();
            let mut count = 0;
            for k in 0..1000 {
                let centre = DVec3::from_array([k % 10, k / 10 % 10, k / 100].map(|c| 0.21 * f64::from(c) - 0.9));
                let expected = wall.in_its_frame(0, centre, 10.0).unwrap();
                let found = part.closest::<f64>(centre, 10.0);
                if found.told & 1 != 0 {
                    assert!((found.distance - expected.distance).abs() < 1e-14, "{centre}");
                    assert!((found.normal - expected.normal).length() < 1e-13, "{centre}");
                    assert!(!expected.is_at_edge, "{centre}");
                    count += 1;
                }
            }
            assert!(count > 200, "{count}");
        }
    }
}
