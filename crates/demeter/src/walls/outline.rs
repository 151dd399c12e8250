//! Extent of a wall: its box, its triangles for a picture, and how far it moved.

use super::Wall;
use super::pose::Pose;
use super::surface::Surface;
use demeter_physics::geometry::contact_sphere_plane::Plane;
use demeter_physics::geometry::surface_point::perpendicular;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Flat pieces around an axis in a picture.
const AROUND: u32 = 48;
/// Flat pieces from pole to pole in a picture of a sphere.
const POLE_TO_POLE: u32 = 24;

impl Wall {
    /// Distance from an axis, told by a point [m] and its unit vector, to the farthest corner of the box around the wall [m]; `None` for
    /// infinite walls.
    pub fn farthest_from(&self, point: DVec3, axis: DVec3) -> Option<f64> {
        let (lower, upper) = self.bounds()?;
        let distances = corners(lower, upper).map(|corner| (corner - point).cross(axis).length());
        Some(distances.into_iter().fold(0.0, f64::max))
    }
}

/// A circle about an axis; cylinders, cones and discs lie between such circles.
struct Ring {
    center: DVec3,
    axis: DVec3,
    radius: f64,
}

impl Ring {
    fn placed(&self, origin: DVec3, pose: &Pose) -> Ring {
        Ring {
            center: pose.place(origin, self.center),
            axis: pose.turn(self.axis),
            radius: self.radius,
        }
    }

    fn bounds(&self) -> (DVec3, DVec3) {
        let out = self
            .axis
            .to_array()
            .map(|a| self.radius * (1.0 - a * a).max(0.0).sqrt());
        let out = DVec3::from_array(out);
        (self.center - out, self.center + out)
    }

    fn point(&self, index: u32) -> DVec3 {
        let u = perpendicular(self.axis);
        let angle = TAU * f64::from(index % AROUND) / f64::from(AROUND);
        self.center + (u * libm::cos(angle) + self.axis.cross(u) * libm::sin(angle)) * self.radius
    }
}

/// Circles that span a surface of revolution; a disc has one, a sphere none. No memory is taken: steps ask.
fn rings(surface: &Surface) -> impl Iterator<Item = Ring> {
    let ring = |start: DVec3, axis: DVec3, along: f64, radius| Ring {
        center: start + axis * along,
        axis,
        radius,
    };
    let all = match surface {
        Surface::Cylinder(c) => [
            Some(ring(c.start, c.axis, 0.0, c.radius)),
            Some(ring(c.start, c.axis, c.length, c.radius)),
        ],
        Surface::Cone(c) => [
            Some(ring(c.start, c.axis, 0.0, c.start_radius)),
            Some(ring(c.start, c.axis, c.length, c.end_radius)),
        ],
        Surface::Disc(d) => [Some(ring(d.center, d.normal, 0.0, d.radius)), None],
        _ => [None, None],
    };
    all.into_iter().flatten()
}

/// Smallest box around a placed surface; `None` when it is infinite. The faces of a box go on beyond closed ones, but
/// it is meant to hold what is between them.
pub(super) fn bounds(surface: &Surface, origin: DVec3, pose: &Pose) -> Option<(DVec3, DVec3)> {
    match surface {
        Surface::Plane(_) => None,
        Surface::Images(one, shifts) => {
            let (lower, upper) = bounds(one, origin, pose)?;
            let shifts = shifts.iter().map(|&shift| pose.turn(shift));
            Some(around(shifts.flat_map(|shift| [lower + shift, upper + shift])))
        }
        Surface::Box { lower, upper, .. } => Some(around(
            corners(*lower, *upper)
                .into_iter()
                .map(|corner| pose.place(origin, corner)),
        )),
        Surface::Shell(shell) => {
            let center = pose.place(origin, shell.center);
            Some((center - DVec3::splat(shell.radius), center + DVec3::splat(shell.radius)))
        }
        Surface::Rectangle(plate) => {
            let center = pose.place(origin, plate.center);
            let out = [0, 1].map(|k| (pose.turn(plate.axes[k]) * plate.half[k]).abs());
            Some((center - out[0] - out[1], center + out[0] + out[1]))
        }
        Surface::Mesh(mesh) => {
            if pose.is_unrotated() {
                let (lower, upper) = mesh.bounds();
                return Some((lower + pose.translation, upper + pose.translation));
            }
            let corners = mesh.triangles().iter().flat_map(|triangle| triangle.corners());
            Some(around(corners.map(|corner| pose.place(origin, corner))))
        }
        Surface::Cylinder(_) | Surface::Cone(_) | Surface::Disc(_) => {
            let boxes = rings(surface).map(|ring| ring.placed(origin, pose).bounds());
            Some(around(boxes.flat_map(|(lower, upper)| [lower, upper])))
        }
    }
}

/// A box around a placed surface that costs little, for it is asked for in every step: a turned mesh is as large as its
/// turned box.
pub(super) fn enclosing(surface: &Surface, origin: DVec3, pose: &Pose) -> Option<(DVec3, DVec3)> {
    match surface {
        Surface::Box { .. } => None,
        Surface::Images(one, _) if matches!(**one, Surface::Box { .. }) => None,
        Surface::Mesh(mesh) => {
            let (lower, upper) = mesh.bounds();
            Some(around(
                corners(lower, upper)
                    .into_iter()
                    .map(|corner| pose.place(origin, corner)),
            ))
        }
        _ => bounds(surface, origin, pose),
    }
}

fn around(points: impl Iterator<Item = DVec3>) -> (DVec3, DVec3) {
    points.fold((DVec3::MAX, DVec3::MIN), |(lower, upper), point| {
        (lower.min(point), upper.max(point))
    })
}

/// Upper bound of how far the surface inside a box moved between two poses.
pub(super) fn displacement(
    surface: &Surface,
    origin: DVec3,
    since: &Pose,
    now: &Pose,
    lower: DVec3,
    upper: DVec3,
) -> f64 {
    if since.rotation == now.rotation {
        return now.translation.distance(since.translation);
    }
    // The displacement is an affine function of the place, so it is longest at a corner of the box; the box counts both
    // as what holds the surface now and as what held it then.
    let moved = |from: &Pose, to: &Pose, point: DVec3| to.place(origin, from.unplace(origin, point)).distance(point);
    let (inner, outer) = match enclosing(surface, origin, now).zip(enclosing(surface, origin, since)) {
        // A finite wall need not be looked for outside its own box.
        Some((a, b)) => (a.0.min(b.0).max(lower), a.1.max(b.1).min(upper)),
        None => (lower, upper),
    };
    let mut as_body = 0.0f64;
    if inner.cmple(outer).all() {
        for point in corners(inner, outer) {
            as_body = as_body.max(moved(since, now, point)).max(moved(now, since, point));
        }
    }
    as_body.min(displacement_of_revolution(surface, origin, since, now).unwrap_or(f64::MAX))
}

/// Bound for surfaces that do not change when they turn about their own axis: what their circles moved.
fn displacement_of_revolution(surface: &Surface, origin: DVec3, since: &Pose, now: &Pose) -> Option<f64> {
    if let Surface::Shell(shell) = surface {
        return Some(
            now.place(origin, shell.center)
                .distance(since.place(origin, shell.center)),
        );
    }
    rings(surface)
        .map(|ring| {
            let (before, after) = (ring.placed(origin, since), ring.placed(origin, now));
            // The shortest turn from one axis to the other moves a point of the circle by at most radius times chord.
            after.center.distance(before.center) + ring.radius * after.axis.distance(before.axis)
        })
        .reduce(f64::max)
}

/// The corners of a box along the axes.
pub(super) fn corners(lower: DVec3, upper: DVec3) -> [DVec3; 8] {
    std::array::from_fn(|k| {
        DVec3::new(
            if k & 1 == 0 { lower.x } else { upper.x },
            if k & 2 == 0 { lower.y } else { upper.y },
            if k & 4 == 0 { lower.z } else { upper.z },
        )
    })
}

/// Triangles of a placed surface.
pub(super) fn triangles(surface: &Surface, origin: DVec3, pose: &Pose, lower: DVec3, upper: DVec3) -> Vec<[DVec3; 3]> {
    let place = |triangle: [DVec3; 3]| triangle.map(|corner| pose.place(origin, corner));
    match surface {
        Surface::Plane(plane) => {
            let placed = Plane {
                point: pose.place(origin, plane.point),
                normal: pose.turn(plane.normal),
            };
            cut_plane(&placed, lower, upper)
        }
        Surface::Box {
            faces, lower, upper, ..
        } => faces
            .iter()
            .flat_map(|(face, _)| box_face(*face, *lower, *upper))
            .map(place)
            .collect(),
        Surface::Cylinder(_) | Surface::Cone(_) => {
            let mut rings = rings(surface);
            let ends = rings.next().zip(rings.next());
            let side = ends.map_or_else(Vec::new, |(start, end)| ribbon(&start, &end));
            side.into_iter().map(place).collect()
        }
        Surface::Disc(disc) => {
            let hub = Ring {
                center: disc.center,
                axis: disc.normal,
                radius: 0.0,
            };
            rings(surface).flat_map(|rim| ribbon(&hub, &rim)).map(place).collect()
        }
        Surface::Shell(shell) => {
            let ring = |k: u32| {
                let angle = PI * f64::from(k) / f64::from(POLE_TO_POLE);
                let pole = k == 0 || k == POLE_TO_POLE;
                Ring {
                    center: shell.center - DVec3::Z * (shell.radius * libm::cos(angle)),
                    axis: DVec3::Z,
                    radius: if pole { 0.0 } else { shell.radius * libm::sin(angle) },
                }
            };
            (0..POLE_TO_POLE)
                .flat_map(|k| ribbon(&ring(k), &ring(k + 1)))
                .map(place)
                .collect()
        }
        Surface::Rectangle(plate) => {
            let (u, v) = (plate.axes[0] * plate.half[0], plate.axes[1] * plate.half[1]);
            let c = plate.center;
            fan(&[c - u - v, c + u - v, c + u + v, c - u + v])
                .into_iter()
                .map(place)
                .collect()
        }
        Surface::Images(one, _) => triangles(one, origin, pose, lower, upper),
        Surface::Mesh(mesh) => mesh
            .triangles()
            .iter()
            .map(|triangle| place(triangle.corners()))
            .collect(),
    }
}

/// Triangles between two circles about one axis; an apex gives one per piece, not two.
fn ribbon(first: &Ring, second: &Ring) -> Vec<[DVec3; 3]> {
    let mut out = Vec::new();
    for k in 0..AROUND {
        let (a, b) = (first.point(k), first.point(k + 1));
        let (c, d) = (second.point(k), second.point(k + 1));
        if first.radius > 0.0 {
            out.push([a, b, c]);
        }
        if second.radius > 0.0 {
            out.push([b, d, c]);
        }
    }
    out
}

fn fan(polygon: &[DVec3]) -> Vec<[DVec3; 3]> {
    polygon
        .windows(2)
        .skip(1)
        .map(|pair| [polygon[0], pair[0], pair[1]])
        .collect()
}

/// Face of a box, seen from inside; -x, +x, -y, +y, -z, +z.
fn box_face(face: u32, lower: DVec3, upper: DVec3) -> Vec<[DVec3; 3]> {
    let axis = face as usize / 2;
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let at = |on_u: DVec3, on_v: DVec3| {
        let mut point = if face.is_multiple_of(2) { lower } else { upper };
        point[u] = on_u[u];
        point[v] = on_v[v];
        point
    };
    let quad = [at(lower, lower), at(upper, lower), at(upper, upper), at(lower, upper)];
    let mut triangles = fan(&quad);
    if face % 2 == 1 {
        triangles.iter_mut().for_each(|triangle| triangle.swap(1, 2));
    }
    triangles
}

/// Part of a plane inside a box: a large square about the box, cut by the six faces in turn.
fn cut_plane(plane: &Plane, lower: DVec3, upper: DVec3) -> Vec<[DVec3; 3]> {
    let middle = 0.5 * (lower + upper);
    let foot = middle - plane.normal * (middle - plane.point).dot(plane.normal);
    let size = (upper - lower).length();
    let u = perpendicular(plane.normal) * size;
    let v = plane.normal.cross(u);
    let mut polygon = vec![foot - u - v, foot + u - v, foot + u + v, foot - u + v];
    for axis in 0..3 {
        polygon = clip(&polygon, |point| point[axis] - lower[axis]);
        polygon = clip(&polygon, |point| upper[axis] - point[axis]);
    }
    fan(&polygon)
}

/// Part of a convex polygon where `depth` is not negative (Sutherland and Hodgman 1974).
fn clip(polygon: &[DVec3], depth: impl Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut out = Vec::new();
    for (index, &from) in polygon.iter().enumerate() {
        let to = polygon[(index + 1) % polygon.len()];
        let (at_from, at_to) = (depth(from), depth(to));
        if at_from >= 0.0 {
            out.push(from);
        }
        if (at_from < 0.0) != (at_to < 0.0) {
            out.push(from + (to - from) * (at_from / (at_from - at_to)));
        }
    }
    out
}
