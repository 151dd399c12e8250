//! Which closest points of the triangles near a grain are contacts.
//!
//! The closest point of one triangle lies in its face, on an edge or on a vertex.
//!
//! * In the face it is a contact.
//! * On an edge or a vertex it is a contact only if no triangle that meets there has a closer point: otherwise that
//!   triangle speaks for the neighbourhood. So a convex edge or corner touches once, and the rim of a face in a concave
//!   corner not at all. A triangle meets there, too, where the edge or vertex lies on it without being joined to it, as where parts of one
//!   plane abut or overlap.
//! * Where a rim is not a contact because it is the bottom of a bend, the plane of its face is one: a sphere that overlaps deeply meets the
//!   other side of a bend before it stands over it ([`Mesh::beyond_rim`]).
//! * Where the surface is flat around the edge or vertex the contact is one with the plane, so that nothing is felt on
//!   a seam, not even in the last digits of the normal.
//! * Of contacts with faces whose normals are less than [`SAME_DIRECTION`] apart one stays: the deepest, and where others are as deep, the
//!   shortest way out of all of them ([`bend`](super::bend)). So are those that others lead to, each so close to the next, as in a
//!   tube or a cone that a sphere nearly fills, or on the rim of a round hole, unless there is no way out of all ([`chain`](super::chain)).
//!   With edges and corners, whose normals turn as the sphere sinks, the places on the surface are asked: whether they are as close as those
//!   normals make them where the sphere just touches both. That joins the contacts of facets that stand for one curved surface, of triangles given twice, and of the two skins of a thin sheet. On a faceted surface the
//!   force so follows from one overlap and is continuous in size and direction from facet to facet. Those at edges and corners that are overlapped
//!   stay as many as they were ([`lasting`](super::lasting)).
//!
//! A triangle with a closer point is itself among those within reach: to decide, no others are asked. Where all others have
//! the direction of the closest and are left on the way out of it, none of them is judged.
//!
//! Keys: a face contact has the lowest triangle of its flat patch as key, the same on the whole patch; edges and vertices
//! have keys of their own above those of the triangles.

use super::Mesh;
use super::bend::{Overlap, WayOut};
use super::chain::Chains;
use super::lasting::{Before, Part};
use super::topology::Junction;
use crate::walls::SurfaceContact;
use demeter_physics::geometry::Feature;
use demeter_physics::geometry::contact_sphere_triangle::{
    ClosestPoints, contact_sphere_triangle, contact_sphere_triangle_wide,
};
use demeter_physics::lanes::{Index, Lanes};
use glam::DVec3;
use std::cell::RefCell;
use std::cmp::Ordering;

/// Cosine of the largest angle, 21.6 degrees, between normals of contacts with faces that are one. A cylinder of 17 facets is still smooth.
pub(super) const SAME_DIRECTION: f64 = 0.93;
/// Share by which the closest points of two triangles may differ in distance and still be the same point.
const SAME_DISTANCE: f64 = 1e-12;

/// Cosine of the sharpest bend, 60 degrees, whose other side is met by a sphere before it stands over it: sharper ones ask for an overlap of
/// half its radius.
const SHARPEST: f64 = 0.5;
/// Share of the height of a triangle above a plane by which a corner may lie below it that lies on it.
const PLANE: f64 = 1e-6;
/// Share of the radius by which a point may lie beside a triangle on which it lies: what files round.
const BESIDE: f64 = 1e-3;

/// Square of the distance between two places, an edge or a corner among them, whose contacts are one, as share of that of the radius: where a
/// sphere just touches both, their normals are as far apart as [`SAME_DIRECTION`] lets those of faces be.
const SAME_PLACE: f64 = 2.0 * (1.0 - SAME_DIRECTION);
/// Cosine of the angle, 31.8 degrees, to which the normals of such contacts turn away from each other and are one still: those of edges as far
/// apart as may be do at an overlap of three tenths.
const WIDEST: f64 = 0.85;

/// Share of the radius within which the closest points of triangles are the same point of an edge.
const SAME_POINT: f64 = 1e-9;
/// Share of the radius by which a point may be deeper that is left on the way out of a contact.
const ROUNDING: f64 = 1e-12;

/// So many triangles do not stay in the first of the caches from step to step.
const MANY: usize = 512;

/// The point of a triangle that is closest to a grain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TrianglePoint {
    pub(crate) triangle: u32,
    /// On which part of the triangle it lies.
    pub(crate) feature: Feature,
    /// Unit vector from the triangle to the grain.
    pub(crate) normal: DVec3,
    /// Distance of the centre [m].
    pub(crate) distance: f64,
}

thread_local! {
    static POINTS: RefCell<Vec<TrianglePoint>> = RefCell::default();
    static BENDS: RefCell<Bends> = RefCell::default();
}

/// Contacts of a sphere, those that are one with the same number; what is found of those.
#[derive(Debug, Default)]
struct Bends {
    parts: Vec<Part>,
    chains: Chains,
    overlaps: Vec<Overlap>,
}

impl Mesh {
    /// Appends all contacts of a sphere with `distance < radius + beyond`, sorted by element.
    pub fn contacts(&self, centre: DVec3, (radius, beyond): (f64, f64), out: &mut Vec<SurfaceContact>) {
        let reach = radius + beyond;
        POINTS.with_borrow_mut(|points| {
            points.clear();
            self.hierarchy.any_near(centre, reach, |triangle| {
                let point = contact_sphere_triangle(&self.triangles[triangle as usize], centre);
                if point.distance < reach {
                    points.push(TrianglePoint {
                        triangle,
                        feature: point.feature,
                        normal: point.normal,
                        distance: point.distance,
                    });
                }
                false
            });
            let frame = (|way| centre + way, |normal| normal);
            self.contacts_of((points, radius), frame, &Before::NOTHING, out);
        });
    }

    /// Appends the contacts of a sphere of some radius among the closest points of all triangles within reach, sorted by element. The centre
    /// is told in the wall frame, from where a way outside of it has led; the normals of the points and of contacts before are those that `turn` makes of
    /// normals there.
    pub(crate) fn contacts_of(
        &self,
        (points, radius): (&mut [TrianglePoint], f64),
        (centre, turn): (impl Fn(DVec3) -> DVec3, impl Fn(DVec3) -> DVec3),
        before: &Before,
        out: &mut Vec<SurfaceContact>,
    ) {
        let is_on_closer = |point: &TrianglePoint, nearer: &[TrianglePoint]| {
            let triangle = |point: &TrianglePoint| &self.triangles[point.triangle as usize];
            let mut closer = nearer.iter().filter(|other| other.is_closer_than(point)).peekable();
            closer.peek().is_some() && {
                let place = contact_sphere_triangle(triangle(point), centre(DVec3::ZERO)).foot;
                closer.any(|other| contact_sphere_triangle(triangle(other), place).distance <= BESIDE * radius)
            }
        };
        let Some(closest) = (0..points.len()).min_by(|&a, &b| self.order(&points[a], &points[b])) else {
            return;
        };
        points.swap(0, closest);
        let first = out.len();
        out.extend(self.judge(&points[0], &[], &turn, is_on_closer, before));
        // what acted by itself before is judged in any case
        let spare_with = |point: &TrianglePoint, contacts: &[SurfaceContact]| {
            is_known(point, radius, contacts).filter(|_| !self.edges_at(point).any(|key| before.has(key)))
        };
        if points[1..]
            .iter()
            .all(|point| spare_with(point, &out[first..]).is_some())
        {
            return;
        }
        points[1..].sort_unstable_by(|a, b| self.order(a, b));
        BENDS.with_borrow_mut(
            |Bends {
                 parts,
                 chains,
                 overlaps,
             }| {
                parts.clear();
                chains.begin(&out[first..], radius);
                for n in 1..points.len() {
                    let Some(contact) = self.judge(&points[n], &points[..n], &turn, is_on_closer, before) else {
                        continue;
                    };
                    if let Some(of) = spare_with(&points[n], &out[first..]) {
                        chains.lead(of, contact, radius);
                        continue;
                    }
                    let mut known = out[first..].iter().chain(parts.iter().map(|(_, contact)| contact));
                    if known.any(|other| other.element == contact.element) {
                        continue;
                    }
                    match out[first..].iter().position(|other| are_one(other, &contact, radius)) {
                        Some(of) => {
                            parts.push((of, contact));
                            chains.join(of, &contact, radius);
                        }
                        None => {
                            out.push(contact);
                            chains.add(&contact, radius);
                        }
                    }
                }
                let alone = out.drain(first..).enumerate();
                parts.extend(alone);
                parts.sort_unstable_by(|(_, a), (_, b)| {
                    a.distance.total_cmp(&b.distance).then(a.element.cmp(&b.element))
                });
                chains.number(parts, (radius, overlaps), |reach, faces| {
                    self.faces_within(&centre, &turn, reach, faces)
                });
                before.go_on(parts, radius);
                for n in 0..parts.len() {
                    let (of, closest) = parts[n];
                    if parts[..n].iter().any(|(other, _)| *other == of) {
                        continue;
                    }
                    let others = parts[n + 1..]
                        .iter()
                        .filter(|(other, _)| *other == of)
                        .map(|(_, other)| *other);
                    if others.clone().next().is_none() {
                        out.push(closest);
                        continue;
                    }
                    let all = std::iter::once(closest).chain(others.clone());
                    let contact = joined(closest, others, (radius, overlaps), |k, way| {
                        let part = all.clone().nth(k).filter(|part| part.is_at_edge)?;
                        let meets = |point: &&TrianglePoint| {
                            let apart = part.distance * part.normal - point.distance * point.normal;
                            apart.length_squared() <= (SAME_POINT * radius).powi(2)
                        };
                        let there = points
                            .iter()
                            .filter(meets)
                            .map(|point| &self.triangles[point.triangle as usize]);
                        let seen = there.map(|triangle| contact_sphere_triangle(triangle, centre(way)));
                        let seen = seen.min_by(|a, b| a.distance.total_cmp(&b.distance))?;
                        Some((seen.distance, turn(seen.normal)))
                    });
                    out.push(contact);
                }
            },
        );
        out[first..].sort_unstable_by_key(|contact| contact.element);
    }

    /// Appends the faces that the centre of a sphere stands over within some distance [m], told as for [`Mesh::contacts_of`].
    fn faces_within(
        &self,
        centre: impl Fn(DVec3) -> DVec3,
        turn: impl Fn(DVec3) -> DVec3,
        reach: f64,
        out: &mut Vec<SurfaceContact>,
    ) {
        let centre = centre(DVec3::ZERO);
        self.hierarchy.any_near(centre, reach, |triangle| {
            let point = contact_sphere_triangle(&self.triangles[triangle as usize], centre);
            if point.feature == Feature::Face && point.distance < reach {
                out.push(self.face_at(&TrianglePoint {
                    triangle,
                    feature: point.feature,
                    normal: turn(point.normal),
                    distance: point.distance,
                }));
            }
            false
        });
    }

    /// The contact with the face of a triangle at its closest point.
    fn face_at(&self, point: &TrianglePoint) -> SurfaceContact {
        SurfaceContact {
            normal: point.normal,
            distance: point.distance,
            element: self.topology.patch(point.triangle),
            is_at_edge: false,
        }
    }

    /// Which of two points is asked first, in whatever order they were found.
    fn order(&self, a: &TrianglePoint, b: &TrianglePoint) -> Ordering {
        let names = |point: &TrianglePoint| (self.topology.patch(point.triangle), point.triangle);
        (a.distance.total_cmp(&b.distance)).then_with(|| names(a).cmp(&names(b)))
    }

    /// Appends all triangles that may be within `reach` of a point.
    pub fn triangles_near(&self, centre: DVec3, reach: f64, out: &mut Vec<u32>) {
        self.hierarchy.any_near(centre, reach, |triangle| {
            out.push(triangle);
            false
        });
    }

    /// Has triangles that are needed soon fetched into the caches, if all of them have no room there; those that this mesh does not have
    /// are passed over.
    #[inline(always)]
    pub(crate) fn fetch_ahead(&self, triangles: &[u32]) {
        if self.triangles.len() < MANY {
            return;
        }
        for &triangle in triangles {
            if let Some(triangle) = self.triangles.get(triangle as usize) {
                triangle.fetch_ahead();
            }
        }
    }

    /// The points of some triangles that are closest to some centres in the wall frame.
    #[inline(always)]
    pub(crate) fn closest_points<L: Lanes>(&self, triangles: &Index, centres: L::Vector) -> ClosestPoints<L> {
        contact_sphere_triangle_wide(&self.triangles, triangles, centres)
    }

    /// Whether a triangle is within `reach` of a point.
    pub fn near(&self, centre: DVec3, reach: f64) -> bool {
        self.hierarchy.any_near(centre, reach, |triangle| {
            contact_sphere_triangle(&self.triangles[triangle as usize], centre).distance <= reach
        })
    }

    /// The contact at the closest point of a triangle, if there is one beside those that are `nearer`; what tells whether the point lies on
    /// one of them is asked last.
    fn judge(
        &self,
        point: &TrianglePoint,
        nearer: &[TrianglePoint],
        turn: impl Fn(DVec3) -> DVec3,
        is_on_closer: impl Fn(&TrianglePoint, &[TrianglePoint]) -> bool,
        before: &Before,
    ) -> Option<SurfaceContact> {
        let mut contact = self.face_at(point);
        let junction = match point.feature {
            Feature::Face => return Some(contact),
            Feature::Edge(side) => self.topology.edge(point.triangle, side),
            Feature::Vertex(corner) => self.topology.vertex(point.triangle, corner),
        };
        if junction.closer(point, nearer).next().is_some() {
            let lasting = || {
                let element = self.edges_at(point).find(|&key| before.has(key))?;
                Some(SurfaceContact {
                    element,
                    is_at_edge: true,
                    ..contact
                })
            };
            return self.beyond_rim(point, &junction, nearer, turn).or_else(lasting);
        }
        if junction.flat {
            let normal = turn(self.triangles[point.triangle as usize].normal());
            let height = point.distance * normal.dot(point.normal);
            contact.normal = if height < 0.0 { -normal } else { normal };
            contact.distance = height.abs();
        } else if is_on_closer(point, nearer) {
            return None;
        } else {
            contact.element = junction.key;
            contact.is_at_edge = true;
        }
        Some(contact)
    }

    /// Keys of the edge on which a point of a triangle lies, or of those beside its vertex.
    fn edges_at(&self, point: &TrianglePoint) -> impl Iterator<Item = u32> {
        let sides = match point.feature {
            Feature::Face => [None; 2],
            Feature::Edge(side) => [Some(side), None],
            Feature::Vertex(corner) => [Some(corner), Some((corner + 2) % 3)],
        };
        let key = |side| self.topology.edge(point.triangle, side).key;
        sides.into_iter().flatten().map(key)
    }

    /// The contact with the plane of a face whose rim is closest, where the sphere stands over a face at the rim, and all that meets there and
    /// is closer rises from that plane towards the sphere, in a bend that is no part of a round surface.
    ///
    /// Two planes that rise from each other by an angle `b` are both overlapped from where the sphere is deeper in one than `(1 - cos b) r`, while
    /// its foot on the other comes to lie on it only later. Were the rim no contact until then, that force would begin with a jump.
    fn beyond_rim(
        &self,
        point: &TrianglePoint,
        junction: &Junction,
        nearer: &[TrianglePoint],
        turn: impl Fn(DVec3) -> DVec3,
    ) -> Option<SurfaceContact> {
        if !junction
            .closer(point, nearer)
            .any(|other| other.feature == Feature::Face)
        {
            return None;
        }
        let triangle = &self.triangles[point.triangle as usize];
        let height = point.distance * turn(triangle.normal()).dot(point.normal);
        let upwards = height.signum() * triangle.normal();
        let normal = turn(upwards);
        let rises = |other: &TrianglePoint| {
            let face = &self.triangles[other.triangle as usize];
            let facing = turn(face.normal());
            let cosine = facing.dot(normal) * facing.dot(other.normal).signum();
            let mut heights = face.corners().map(|corner| upwards.dot(corner - triangle.corners()[0]));
            heights.sort_unstable_by(f64::total_cmp);
            let is_ahead = other.normal.dot(point.normal) <= SAME_DIRECTION && height.abs() >= other.distance;
            is_ahead && (SHARPEST..=SAME_DIRECTION).contains(&cosine) && heights[0] > -PLANE * heights[2]
        };
        junction.closer(point, nearer).all(rises).then_some(SurfaceContact {
            normal,
            distance: height.abs(),
            element: self.topology.patch(point.triangle),
            is_at_edge: false,
        })
    }
}

impl TrianglePoint {
    fn is_closer_than(&self, other: &Self) -> bool {
        self.distance < other.distance * (1.0 - SAME_DISTANCE)
    }
}

/// Whether two contacts of a sphere are one.
pub(crate) fn are_one(a: &SurfaceContact, b: &SurfaceContact, radius: f64) -> bool {
    let cosine = a.normal.dot(b.normal);
    match a.is_at_edge || b.is_at_edge {
        true => are_close((a.normal, a.distance), (b.normal, b.distance), radius),
        false => cosine > SAME_DIRECTION,
    }
}

/// Whether two places on a surface, told by directions and distances from the centre of a sphere, are close to each other.
fn are_close(a: (DVec3, f64), b: (DVec3, f64), radius: f64) -> bool {
    are_one_up_to(WIDEST, SAME_PLACE, a, b, radius)
}

/// The same with a cosine and the square of a distance, as share of that of the radius.
pub(super) fn are_one_up_to(cosine: f64, place: f64, a: (DVec3, f64), b: (DVec3, f64), radius: f64) -> bool {
    a.0.dot(b.0) > cosine && (a.1 * a.0 - b.1 * b.0).length_squared() < place * radius * radius
}

/// Whether a contact of a sphere is known that is one with that of a point, whatever this turns out to be, on whose way out the point is
/// left, too; its place among them is told, and it is the first that may be one with it.
fn is_known(point: &TrianglePoint, radius: f64, contacts: &[SurfaceContact]) -> Option<usize> {
    let compare = |other: &SurfaceContact| {
        let cosine = other.normal.dot(point.normal);
        let is_at_edge = other.is_at_edge || point.feature != Feature::Face;
        let [as_faces, as_edges] = [
            cosine > SAME_DIRECTION,
            is_at_edge && are_close((other.normal, other.distance), (point.normal, point.distance), radius),
        ];
        let left = cosine * (radius - other.distance).max(0.0) + ROUNDING * radius;
        let is_left = radius - point.distance <= left;
        (as_faces || as_edges).then_some(as_faces && (as_edges || !is_at_edge) && is_left)
    };
    let found = contacts
        .iter()
        .enumerate()
        .find_map(|(k, other)| Some((k, compare(other)?)));
    found.filter(|(_, is_left)| *is_left).map(|(k, _)| k)
}

/// The contact of the shortest way out of some that are one, the closest first: this where the sphere does not overlap with it. `seen` tells distance
/// and normal of one, by its number, from where a way has led, unless it is flat.
pub(crate) fn joined(
    closest: SurfaceContact,
    others: impl Iterator<Item = SurfaceContact>,
    (radius, overlaps): (f64, &mut Vec<Overlap>),
    seen: impl Fn(usize, DVec3) -> Option<(f64, DVec3)>,
) -> SurfaceContact {
    if closest.distance >= radius {
        return closest;
    }
    overlaps.clear();
    overlaps.push(Overlap::of(&closest, radius));
    overlaps.extend(others.map(|other| Overlap::of(&other, radius)));
    let out = WayOut::curved(overlaps, |k, way| {
        seen(k, way).map(|(distance, normal)| (radius - distance, normal))
    });
    let depth = out.way.length();
    SurfaceContact {
        normal: out.way / depth,
        distance: radius - depth,
        // while it holds in the bend it is one contact, whichever side is deeper
        element: (out.holding().iter().filter(|&&k| overlaps[k].depth > 0.0))
            .map(|&k| overlaps[k].element)
            .min()
            .unwrap_or(closest.element),
        is_at_edge: false,
    }
}

impl Junction<'_> {
    /// The points of triangles that meet here which are closer than one at the junction.
    fn closer<'p>(
        &self,
        point: &TrianglePoint,
        nearer: &'p [TrianglePoint],
    ) -> impl Iterator<Item = &'p TrianglePoint> {
        let is_closer =
            |other: &&TrianglePoint| other.is_closer_than(point) && self.triangles.contains(&other.triangle);
        nearer.iter().filter(is_closer)
    }
}

#[cfg(test)]
#[path = "contacts_tests.rs"]
mod tests;
