//! A shape, checked and made ready for queries in the wall frame.

use super::elements::FACES;
use super::error::WallError;
use super::limits::{UNIT_TOLERANCE, finite, not_negative, positive, unit};
use super::mesh::Mesh;
use super::shape::{Made, Shape};
use super::wall::SurfaceContact;
use demeter_physics::geometry::contact_sphere_cone::{Cone, contact_sphere_cone};
use demeter_physics::geometry::contact_sphere_cylinder::{Cylinder, contact_sphere_cylinder};
use demeter_physics::geometry::contact_sphere_disc::{Disc, contact_sphere_disc};
use demeter_physics::geometry::contact_sphere_plane::{Plane, contact_sphere_plane};
use demeter_physics::geometry::contact_sphere_rectangle::{Rectangle, contact_sphere_rectangle};
use demeter_physics::geometry::contact_sphere_shell::{Shell, contact_sphere_shell};
use demeter_physics::geometry::{AT_END, Feature, Side, SurfacePoint};
use glam::DVec3;

/// A surface in the wall frame.
#[derive(Clone, Debug)]
pub(super) enum Surface {
    Plane(Plane),
    /// Faces of a box with their numbers, its corners, between which places its faces reach, and how near to these they end.
    Box {
        faces: Vec<(u32, Plane)>,
        lower: DVec3,
        upper: DVec3,
        reach: (DVec3, DVec3),
        margin: DVec3,
    },
    Cylinder(Cylinder),
    Cone(Cone),
    Shell(Shell),
    Rectangle(Rectangle),
    Disc(Disc),
    Mesh(Box<Mesh>),
    /// Images of one of the others, but of a mesh, at these shifts; the first is not shifted.
    Images(Box<Surface>, Vec<DVec3>),
}

impl Surface {
    pub(super) fn new(shape: impl Into<Made>) -> Result<Self, WallError> {
        let shape = match shape.into() {
            Made::Mesh(mesh) => return Ok(Surface::Mesh(mesh)),
            Made::Shape(shape) => shape,
        };
        Ok(match shape {
            Shape::Plane { point, normal } => Surface::Plane(Plane {
                point: finite("the point", point)?,
                normal: unit("the normal", normal)?,
            }),
            Shape::Box { lower, upper, open } => box_surface(lower, upper, open)?,
            Shape::Cylinder {
                start,
                end,
                radius,
                side,
            } => {
                let (axis, length) = axis_between("cylinder", start, end)?;
                Surface::Cylinder(Cylinder {
                    start,
                    axis,
                    length,
                    radius: positive("the radius", radius)?,
                    side,
                })
            }
            Shape::Cone {
                start,
                end,
                start_radius,
                end_radius,
                side,
            } => {
                let (axis, length) = axis_between("cone", start, end)?;
                let start_radius = not_negative("start_radius", start_radius)?;
                let end_radius = not_negative("end_radius", end_radius)?;
                if start_radius == 0.0 && end_radius == 0.0 {
                    return Err(WallError::NoRadius);
                }
                Surface::Cone(Cone {
                    start,
                    axis,
                    length,
                    start_radius,
                    end_radius,
                    side,
                })
            }
            Shape::Sphere { center, radius, side } => Surface::Shell(Shell {
                center: finite("the centre", center)?,
                radius: positive("the radius", radius)?,
                side,
            }),
            Shape::Rectangle { center, half_u, half_v } => rectangle_surface(center, half_u, half_v)?,
            Shape::Disc { center, normal, radius } => Surface::Disc(Disc {
                center: finite("the centre", center)?,
                normal: unit("the normal", normal)?,
                radius: positive("the radius", radius)?,
            }),
            Shape::Mesh { triangles } => Surface::Mesh(Box::new(Mesh::new(&triangles)?)),
        })
    }

    /// The unit normal of a flat surface, in the wall frame.
    pub(super) fn flat_normal(&self) -> Option<DVec3> {
        match self {
            Surface::Plane(plane) => Some(plane.normal),
            Surface::Rectangle(plate) => Some(plate.normal()),
            Surface::Disc(disc) => Some(disc.normal),
            Surface::Images(one, _) => one.flat_normal(),
            _ => None,
        }
    }

    /// Appends all contacts of a sphere with `distance < radius + beyond`, sorted by element.
    #[inline]
    pub(super) fn contacts(&self, centre: DVec3, (radius, beyond): (f64, f64), out: &mut Vec<SurfaceContact>) {
        let reach = radius + beyond;
        match self {
            Surface::Mesh(mesh) => mesh.contacts(centre, (radius, beyond), out),
            Surface::Images(one, shifts) => {
                for (image, &shift) in shifts.iter().enumerate() {
                    let first = out.len();
                    one.contacts(centre - shift, (radius, beyond), out);
                    let found = out[first..].iter_mut();
                    found.for_each(|contact| contact.element = of_image(image, contact.element));
                }
            }
            Surface::Box {
                faces,
                reach: ends,
                margin,
                ..
            } => {
                for (element, plane) in faces {
                    push(contact_box_face(plane, (*ends, *margin), centre), *element, reach, out);
                }
            }
            single => {
                if let Some(point) = single
                    .closest(centre)
                    .filter(|point| !single.is_left_behind(point, reach))
                {
                    push(point, 0, reach, out);
                }
            }
        }
    }

    /// Appends all parts within `reach`: triangles of a mesh that may be as near, else elements.
    pub(super) fn parts_near(&self, centre: DVec3, reach: f64, out: &mut Vec<u32>) {
        match self {
            Surface::Mesh(mesh) => mesh.triangles_near(centre, reach, out),
            Surface::Images(one, shifts) => {
                for (image, &shift) in shifts.iter().enumerate() {
                    let first = out.len();
                    one.parts_near(centre - shift, reach, out);
                    let found = out[first..].iter_mut();
                    found.for_each(|element| *element = of_image(image, *element));
                }
            }
            Surface::Box {
                faces,
                reach: ends,
                margin,
                ..
            } => {
                for (face, plane) in faces {
                    if contact_box_face(plane, (*ends, *margin), centre).distance < reach {
                        out.push(*face);
                    }
                }
            }
            single => out.extend(single.near(centre, reach).then_some(0)),
        }
    }

    /// The contact with an element, however far away, where there is no more than one with each: `None` of meshes. What a sphere of
    /// radius `reach` has left behind is as far away as to do nothing.
    #[inline]
    pub(super) fn contact_with(&self, element: u32, centre: DVec3, reach: f64) -> Option<SurfaceContact> {
        let mut point = match self {
            Surface::Mesh(_) => return None,
            Surface::Images(one, shifts) => {
                let shift = shifts.get(element as usize / FACES)?;
                let contact = one.contact_with(element % FACES as u32, centre - shift, reach)?;
                return Some(SurfaceContact { element, ..contact });
            }
            Surface::Box {
                faces,
                reach: ends,
                margin,
                ..
            } => {
                let (_, plane) = faces.iter().find(|(face, _)| *face == element)?;
                contact_box_face(plane, (*ends, *margin), centre)
            }
            single => single.closest(centre)?,
        };
        if self.is_left_behind(&point, reach) {
            point.distance = 2.0 * reach;
        }
        Some(SurfaceContact {
            normal: point.normal,
            distance: point.distance,
            element,
            is_at_edge: point.feature != Feature::Face,
        })
    }

    /// Whether a sphere has wholly passed through the side of an open-ended surface, or came beside it around an end.
    ///
    /// Only there does the one-sided rule have an end, beyond which a grain far outside is not touched; would it be
    /// touched before the end, whatever its distance, then it would matter whether a list of neighbours knew of it.
    #[inline]
    fn is_left_behind(&self, point: &SurfacePoint, reach: f64) -> bool {
        matches!(self, Surface::Cylinder(_) | Surface::Cone(_)) && point.distance < -reach
    }

    /// Whether anything is within `reach`.
    #[inline]
    pub(super) fn near(&self, centre: DVec3, reach: f64) -> bool {
        match self {
            Surface::Mesh(mesh) => mesh.near(centre, reach),
            Surface::Images(one, shifts) => shifts.iter().any(|&shift| one.near(centre - shift, reach)),
            Surface::Box {
                faces,
                reach: ends,
                margin,
                ..
            } => faces
                .iter()
                .any(|(_, plane)| contact_box_face(plane, (*ends, *margin), centre).distance <= reach),
            single => {
                let within = |point: SurfacePoint| point.distance <= reach && !single.is_left_behind(&point, reach);
                single.closest(centre).is_some_and(within)
            }
        }
    }

    /// Radius of the largest grain at a point that touches nothing, or `limit` when that is less. Beyond the side of a
    /// cylinder or cone, whose ends are open, a grain that has wholly passed is free again.
    pub(super) fn clearance(&self, point: DVec3, limit: f64) -> f64 {
        let found = match self {
            Surface::Mesh(_) if limit <= 0.0 => return limit,
            Surface::Mesh(mesh) => mesh.distance(point, limit),
            Surface::Images(one, shifts) => shifts
                .iter()
                .fold(limit, |least, &shift| one.clearance(point - shift, least)),
            Surface::Box {
                faces, reach, margin, ..
            } => {
                let distances = faces
                    .iter()
                    .map(|(_, plane)| contact_box_face(plane, (*reach, *margin), point).distance);
                distances.fold(limit, f64::min)
            }
            single => single.closest(point).map_or(limit, |closest| match single {
                Surface::Cylinder(_) | Surface::Cone(_) => closest.distance.abs(),
                _ => closest.distance,
            }),
        };
        found.min(limit)
    }

    /// How deep a point lies in a shaft [m]: within a cylinder or cone that has grains outside, between its ends.
    pub(super) fn depth_in_shaft(&self, point: DVec3) -> Option<f64> {
        let side = match self {
            Surface::Images(one, shifts) => {
                return shifts.iter().find_map(|&shift| one.depth_in_shaft(point - shift));
            }
            Surface::Cylinder(cylinder) => cylinder.side,
            Surface::Cone(cone) => cone.side,
            _ => return None,
        };
        let closest = self.closest(point).filter(|_| side == Side::Outside)?;
        (closest.distance < 0.0).then_some(-closest.distance)
    }

    /// The one closest point of a shape that touches a sphere at most once; `None` for boxes, meshes and images.
    #[inline]
    fn closest(&self, centre: DVec3) -> Option<SurfacePoint> {
        Some(match self {
            Surface::Plane(plane) => contact_sphere_plane(plane, centre),
            Surface::Cylinder(cylinder) => contact_sphere_cylinder(cylinder, centre),
            Surface::Cone(cone) => contact_sphere_cone(cone, centre),
            Surface::Shell(shell) => contact_sphere_shell(shell, centre),
            Surface::Rectangle(plate) => contact_sphere_rectangle(plate, centre),
            Surface::Disc(disc) => contact_sphere_disc(disc, centre),
            Surface::Box { .. } | Surface::Mesh(_) | Surface::Images(..) => return None,
        })
    }

    /// Centroid of the shape; of an infinite plane, the point it was described with [m].
    pub(super) fn centroid(&self) -> DVec3 {
        match self {
            Surface::Plane(plane) => plane.point,
            Surface::Box { lower, upper, .. } => 0.5 * (*lower + *upper),
            Surface::Cylinder(cylinder) => cylinder.start + cylinder.axis * (0.5 * cylinder.length),
            Surface::Cone(cone) => {
                // Of the lateral surface: slices weigh as their radius.
                let (a, b) = (cone.start_radius, cone.end_radius);
                cone.start + cone.axis * (cone.length * (a + 2.0 * b) / (3.0 * (a + b)))
            }
            Surface::Shell(shell) => shell.center,
            Surface::Rectangle(plate) => plate.center,
            Surface::Disc(disc) => disc.center,
            Surface::Mesh(mesh) => mesh.centroid(),
            Surface::Images(one, _) => one.centroid(),
        }
    }
}

/// The element of an image.
fn of_image(image: usize, element: u32) -> u32 {
    (image * FACES) as u32 + element
}

#[inline]
fn push(point: SurfacePoint, element: u32, reach: f64, out: &mut Vec<SurfaceContact>) {
    if point.distance < reach {
        out.push(SurfaceContact {
            normal: point.normal,
            distance: point.distance,
            element,
            is_at_edge: point.feature != Feature::Face,
        });
    }
}

/// Closest point of a face of a box. It goes on beyond closed faces, where no grain gets, so that a grain that has crossed an edge
/// is pushed back by both; beyond an open face, and a margin before it, its rim is an edge that pushes straight away.
#[inline]
fn contact_box_face(plane: &Plane, ((from, to), margin): ((DVec3, DVec3), DVec3), centre: DVec3) -> SurfacePoint {
    let on_plane = contact_sphere_plane(plane, centre);
    if on_plane.foot.cmpge(from + margin).all() && on_plane.foot.cmple(to - margin).all() {
        return on_plane;
    }
    let foot = on_plane.foot.clamp(from, to);
    SurfacePoint::away_from(foot, centre, plane.normal, Feature::Edge(0))
}

fn box_surface(lower: DVec3, upper: DVec3, open: [bool; 6]) -> Result<Surface, WallError> {
    finite("the lower corner", lower)?;
    finite("the upper corner", upper)?;
    if !lower.cmplt(upper).all() {
        return Err(WallError::EmptyBox { lower, upper });
    }
    let normals = [DVec3::X, -DVec3::X, DVec3::Y, -DVec3::Y, DVec3::Z, -DVec3::Z];
    let faces: Vec<(u32, Plane)> = (0u32..)
        .zip(normals.into_iter().zip(open))
        .filter(|(_, (_, open))| !open)
        .map(|(face, (normal, _))| {
            (
                face,
                Plane {
                    point: if face.is_multiple_of(2) { lower } else { upper },
                    normal,
                },
            )
        })
        .collect();
    if faces.is_empty() {
        return Err(WallError::NoFace);
    }
    let end = |side: usize, corner: DVec3, beyond: f64| {
        DVec3::from_array([0, 1, 2].map(|k| if open[2 * k + side] { corner[k] } else { beyond }))
    };
    Ok(Surface::Box {
        faces,
        lower,
        upper,
        reach: (end(0, lower, f64::NEG_INFINITY), end(1, upper, f64::INFINITY)),
        margin: (upper - lower) * AT_END,
    })
}

fn rectangle_surface(center: DVec3, half_u: DVec3, half_v: DVec3) -> Result<Surface, WallError> {
    finite("the centre", center)?;
    let half = [finite("half_u", half_u)?.length(), finite("half_v", half_v)?.length()];
    positive("the length of half_u", half[0])?;
    positive("the length of half_v", half[1])?;
    let u = half_u / half[0];
    let across = half_v / half[1];
    if u.dot(across).abs() > UNIT_TOLERANCE {
        return Err(WallError::NotPerpendicular { half_u, half_v });
    }
    let v = across - u * u.dot(across);
    Ok(Surface::Rectangle(Rectangle {
        center,
        axes: [u, v / v.length()],
        half,
    }))
}

fn axis_between(shape: &'static str, start: DVec3, end: DVec3) -> Result<(DVec3, f64), WallError> {
    let along = finite("the end of the axis", end)? - finite("the start of the axis", start)?;
    let length = along.length();
    if length > 0.0 {
        Ok((along / length, length))
    } else {
        Err(WallError::NoLength { shape, point: start })
    }
}
