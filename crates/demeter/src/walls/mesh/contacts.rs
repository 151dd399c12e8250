//! Which closest points of the triangles near a grain are contacts.
//!
//! The closest point of one triangle lies in its face, on an edge or on a vertex.
//!
//! * In the face it is a contact.
//! * On an edge or a vertex it is a contact only if no triangle that meets there has a closer point: otherwise that
//!   triangle speaks for the neighbourhood. So a convex edge or corner touches once, and the rim of a face in a concave
//!   corner not at all.
//! * Where the surface is flat around the edge or vertex the contact is one with the plane, so that nothing is felt on
//!   a seam, not even in the last digits of the normal.
//! * Of contacts whose normals are less than [`SAME_DIRECTION`] apart only the deepest stays. That joins the contacts of
//!   facets that stand for one curved surface, of triangles given twice, and of the two skins of a thin sheet. On a
//!   faceted surface the force so follows from one overlap, the largest, and stays continuous from facet to facet.
//!
//! Keys: a face contact has the lowest triangle of its flat patch as key, the same on the whole patch; edges and vertices
//! have keys of their own above those of the triangles.

use super::Mesh;
use super::topology::Junction;
use crate::walls::SurfaceContact;
use demeter_physics::geometry::contact_sphere_triangle::contact_sphere_triangle;
use demeter_physics::geometry::{Feature, SurfacePoint};
use glam::DVec3;

/// Cosine of the largest angle, 21.6 degrees, between normals of contacts that are one. Two planes that meet at this bend
/// touch a sphere both at once only from an overlap of 7 % of the radius on. A cylinder of 17 facets is still smooth.
const SAME_DIRECTION: f64 = 0.93;
/// Share by which the closest points of two triangles may differ in distance and still be the same point.
const SAME_DISTANCE: f64 = 1e-12;

impl Mesh {
    /// Appends all contacts of a sphere centre with `distance < reach`, sorted by element.
    pub fn contacts(&self, centre: DVec3, reach: f64, out: &mut Vec<SurfaceContact>) {
        let first = out.len();
        self.hierarchy.any_near(centre, reach, |triangle| {
            self.try_triangle(triangle, centre, reach, first, out);
            false
        });
        keep_deepest(out, first);
    }

    /// The same, where [`Mesh::triangles_near`] told the triangles that may be within reach.
    pub fn contacts_among(&self, triangles: &[u32], centre: DVec3, reach: f64, out: &mut Vec<SurfaceContact>) {
        let first = out.len();
        for &triangle in triangles {
            self.try_triangle(triangle, centre, reach, first, out);
        }
        keep_deepest(out, first);
    }

    /// Appends all triangles within `reach` of a point, in the order in which [`Mesh::contacts`] looks at them.
    pub fn triangles_near(&self, centre: DVec3, reach: f64, out: &mut Vec<u32>) {
        self.hierarchy.any_near(centre, reach, |triangle| {
            if contact_sphere_triangle(&self.triangles[triangle as usize], centre).distance <= reach {
                out.push(triangle);
            }
            false
        });
    }

    fn try_triangle(&self, triangle: u32, centre: DVec3, reach: f64, first: usize, out: &mut Vec<SurfaceContact>) {
        let point = contact_sphere_triangle(&self.triangles[triangle as usize], centre);
        if point.distance < reach {
            self.judge(triangle, &point, centre, first, out);
        }
    }

    /// Whether a triangle is within `reach` of a point.
    pub fn near(&self, centre: DVec3, reach: f64) -> bool {
        self.hierarchy.any_near(centre, reach, |triangle| {
            contact_sphere_triangle(&self.triangles[triangle as usize], centre).distance <= reach
        })
    }

    /// Appends the closest point of a triangle if it is a contact.
    fn judge(&self, triangle: u32, point: &SurfacePoint, centre: DVec3, first: usize, out: &mut Vec<SurfaceContact>) {
        let junction = match point.feature {
            Feature::Face => {
                out.push(self.face_contact(triangle, point));
                return;
            }
            Feature::Edge(side) => self.topology.edge(triangle, side),
            Feature::Vertex(corner) => self.topology.vertex(triangle, corner),
        };
        let known = out[first..].iter().any(|contact| contact.element == junction.key);
        if known || self.has_closer(&junction, point.distance, centre) {
            return;
        }
        out.push(if junction.flat {
            self.face_contact(triangle, &self.triangles[triangle as usize].face_point(centre))
        } else {
            SurfaceContact {
                normal: point.normal,
                distance: point.distance,
                element: junction.key,
            }
        });
    }

    fn face_contact(&self, triangle: u32, point: &SurfacePoint) -> SurfaceContact {
        SurfaceContact {
            normal: point.normal,
            distance: point.distance,
            element: self.topology.patch(triangle),
        }
    }

    fn has_closer(&self, junction: &Junction<'_>, distance: f64, centre: DVec3) -> bool {
        let closer = distance * (1.0 - SAME_DISTANCE);
        junction
            .triangles
            .iter()
            .any(|&other| contact_sphere_triangle(&self.triangles[other as usize], centre).distance < closer)
    }
}

/// Keeps, of the contacts from `first` on, the deepest of each direction, and sorts them by element.
fn keep_deepest(out: &mut Vec<SurfaceContact>, first: usize) {
    if out.len() < first + 2 {
        return;
    }
    out[first..].sort_unstable_by(|a, b| a.distance.total_cmp(&b.distance).then(a.element.cmp(&b.element)));
    let mut kept = first;
    for index in first..out.len() {
        let contact = out[index];
        let same = |other: &SurfaceContact| {
            other.element == contact.element || other.normal.dot(contact.normal) > SAME_DIRECTION
        };
        if !out[first..kept].iter().any(same) {
            out[kept] = contact;
            kept += 1;
        }
    }
    out.truncate(kept);
    out[first..].sort_unstable_by_key(|contact| contact.element);
}
