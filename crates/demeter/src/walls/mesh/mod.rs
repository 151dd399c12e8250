//! Triangle meshes as walls.
//!
//! * `weld` joins corners that are the same point, `topology` finds edges, neighbours and flat patches
//! * `walls::hierarchy` finds the triangles near a grain
//! * `contacts` decides which of their closest points are contacts
//! * `repair` makes a mesh as it comes usable, with `orientation`; `inspection` tells what is remarkable, with `crossings`

mod bend;
mod chain;
mod contacts;
mod crossings;
mod inspection;
mod lasting;
mod orientation;
mod repair;
mod topology;
mod weld;

pub(crate) use bend::Overlap;
pub(crate) use contacts::{TrianglePoint, are_one, joined};
pub use crossings::Crossings;
pub use inspection::{Inspection, Places, Rim, Torn};
pub(crate) use lasting::{Before, SAME_SURFACE, are_still_one};
pub use repair::{LeftOut, Repair};

use super::hierarchy::Hierarchy;
use demeter_physics::geometry::contact_sphere_triangle::{Triangle, contact_sphere_triangle};
use glam::DVec3;
use thiserror::Error;
use topology::Topology;

/// Why a mesh was refused. Triangles are counted from 1, as in most programs that show them.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MeshError {
    /// There is no triangle.
    #[error("the mesh has no triangle; give at least one")]
    Empty,
    /// More triangles than contacts can be keyed for.
    #[error(
        "the mesh has {count} triangles; at most {} are supported, so simplify it",
        Mesh::MOST_TRIANGLES
    )]
    TooMany {
        /// Triangles given.
        count: usize,
    },
    /// A corner is infinite or not a number, or too large to square.
    #[error("triangle {triangle} of the mesh has a corner at {corner}; coordinates must be finite and at most 1e100 m")]
    NotFinite {
        /// The triangle, counted from 1.
        triangle: usize,
        /// The corner [m].
        corner: DVec3,
    },
    /// A triangle has no area.
    #[error(
        "triangle {triangle} of the mesh, {}, has zero area; remove it or repair the mesh",
        corners.map(shown).join(" ")
    )]
    ZeroArea {
        /// The triangle, counted from 1.
        triangle: usize,
        /// Its corners [m].
        corners: [DVec3; 3],
    },
    /// The distance within which corners are joined leaves no triangle.
    #[error(
        "none of the {count} triangles of the mesh is left where corners within {tolerance} m are joined; its shortest edge is \
         {shortest} m long, so join corners within far less than that"
    )]
    AllJoined {
        /// Distance within which corners are joined [m].
        tolerance: f64,
        /// Triangles with an area before.
        count: usize,
        /// Shortest edge [m].
        shortest: f64,
    },
    /// The mesh should be closed and is not.
    #[error(
        "the mesh is not closed: {count} edges belong to an odd number of triangles, the first from {start} to {end} of \
         triangle {triangle}; {}",
        inspection::closing(torn.as_deref(), *cracks)
    )]
    Open {
        /// Edges with an odd number of triangles.
        count: usize,
        /// A triangle at the first of them, counted from 1.
        triangle: usize,
        /// Start of the edge [m].
        start: DVec3,
        /// End of the edge [m].
        end: DVec3,
        /// How wide the widest crack is, where all gaps are cracks [m]; 0 without width.
        cracks: Option<f64>,
        /// Open edges whose corners nearly meet those of others.
        torn: Option<Box<Torn>>,
    },
}

/// A surface of triangles, ready for queries. It never changes.
#[derive(Clone, Debug)]
pub struct Mesh {
    triangles: Vec<Triangle>,
    topology: Topology,
    hierarchy: Hierarchy,
    /// Of which triangles the last ones are copies.
    copies: Vec<u32>,
    /// Triangles that came with both fronts.
    both_fronts: Vec<u32>,
}

impl Mesh {
    /// Most triangles that a mesh may have, so that faces, edges and vertices have keys of their own in 32 bits.
    pub const MOST_TRIANGLES: usize = 1 << 29;

    /// Largest coordinate [m].
    const LARGEST: f64 = 1e100;

    /// Builds a mesh from the corners of its triangles [m].
    ///
    /// Corners that differ by no more than the rounding of single precision (in which STL files are written) are joined.
    /// Edges with one, two or more triangles are all allowed, and the order of the corners does not matter.
    pub fn new(corners: &[[DVec3; 3]]) -> Result<Self, MeshError> {
        repair::check_corners(corners)?;
        for (index, triangle) in corners.iter().enumerate() {
            make_triangle(index, *triangle)?;
        }
        let welded = weld::weld(corners, None);
        let mut triangles = Vec::with_capacity(corners.len());
        for (index, ids) in welded.triangles.iter().enumerate() {
            triangles.push(make_triangle(index, ids.map(|id| welded.points[id as usize]))?);
        }
        let topology = Topology::new(&welded, &triangles);
        let centroids: Vec<DVec3> = triangles.iter().map(Triangle::centroid).collect();
        let hierarchy = Hierarchy::new(&centroids, |triangle| triangles[triangle as usize].bounds());
        Ok(Mesh {
            triangles,
            topology,
            hierarchy,
            copies: Vec::new(),
            both_fronts: Vec::new(),
        })
    }

    /// A mesh that is told which of its triangles came with both fronts ([`Repair::both_fronts`]).
    #[must_use]
    pub fn with_both_fronts(self, both_fronts: &[u32]) -> Self {
        let both_fronts = both_fronts.to_vec();
        Self { both_fronts, ..self }
    }

    /// A mesh whose last triangles are copies of others, beside which they stand: what happens on a copy happens on its original.
    pub(super) fn with_copies(corners: &[[DVec3; 3]], copies: Vec<u32>) -> Result<Self, MeshError> {
        Ok(Mesh {
            copies,
            ..Self::new(corners)?
        })
    }

    /// The triangle that a triangle is a copy of, or that triangle itself.
    pub(super) fn original(&self, triangle: u32) -> u32 {
        let own = self.triangles.len() - self.copies.len();
        let copied = (triangle as usize).checked_sub(own);
        copied
            .and_then(|copy| self.copies.get(copy))
            .copied()
            .unwrap_or(triangle)
    }

    /// Error when the surface has a hole: an edge with an odd number of triangles.
    pub fn require_closed(&self) -> Result<(), MeshError> {
        self.closed_triangles().map(drop)
    }

    /// Corners of the triangles that together have no hole [m]: all, or all but those that came with both fronts, which divide the inside.
    pub fn closed_triangles(&self) -> Result<Vec<[DVec3; 3]>, MeshError> {
        let corners = |kept: &[u32]| kept.iter().map(|&k| self.triangles[k as usize].corners()).collect();
        let all: Vec<u32> = (0..self.triangles.len() as u32).collect();
        let open = self.topology.odd_edges();
        let Some(&(triangle, side)) = open.first() else {
            return Ok(corners(&all));
        };
        let mut undivided = all;
        undivided.retain(|k| self.both_fronts.binary_search(k).is_err());
        if !self.both_fronts.is_empty() && !undivided.is_empty() && self.topology.is_closed_with(&undivided) {
            return Ok(corners(&undivided));
        }
        let [start, end] = self.ends(triangle, side.into());
        Err(MeshError::Open {
            count: open.len(),
            triangle: triangle as usize + 1,
            start,
            end,
            cracks: self.cracks(),
            torn: self.torn().map(Box::new),
        })
    }

    /// Distance of a point from the surface, or `limit` when that is less [m].
    pub fn distance(&self, point: DVec3, limit: f64) -> f64 {
        self.hierarchy.least_distance(point, limit, |triangle, _| {
            contact_sphere_triangle(&self.triangles[triangle as usize], point).distance
        })
    }

    /// The triangle closest to a point, among those within `reach` [m]; the lowest where several are as close.
    pub fn closest_triangle(&self, point: DVec3, reach: f64) -> Option<u32> {
        let mut closest: Option<(f64, u32)> = None;
        self.hierarchy.any_near(point, reach, |triangle| {
            let distance = contact_sphere_triangle(&self.triangles[triangle as usize], point).distance;
            let is_closer = closest.is_none_or(|(least, lowest)| (distance, triangle) < (least, lowest));
            if distance <= reach && is_closer {
                closest = Some((distance, triangle));
            }
            false
        });
        closest.map(|(_, triangle)| triangle)
    }

    /// Triangles, with joined corners, in the order given.
    pub fn triangles(&self) -> &[Triangle] {
        &self.triangles
    }

    /// Smallest box around the mesh [m].
    pub fn bounds(&self) -> (DVec3, DVec3) {
        self.hierarchy.bounds()
    }

    /// Centroid of the surface [m].
    pub fn centroid(&self) -> DVec3 {
        let first = self.triangles[0].corners()[0];
        let (mut moment, mut total) = (DVec3::ZERO, 0.0);
        for triangle in &self.triangles {
            let [a, b, c] = triangle.corners();
            let area = (b - a).cross(c - a).length();
            moment += ((a - first) + (b - first) + (c - first)) * (area / 3.0);
            total += area;
        }
        if total > 0.0 { first + moment / total } else { first }
    }
}

/// A place in brackets; what is far below all lengths keeps its digits and not its zeros.
fn shown(place: DVec3) -> String {
    let number = |x: f64| match x.abs() {
        tiny if tiny > 0.0 && tiny < 1e-9 => format!("{x:e}"),
        _ => x.to_string(),
    };
    format!("[{}]", place.to_array().map(number).join(", "))
}

fn make_triangle(index: usize, corners: [DVec3; 3]) -> Result<Triangle, MeshError> {
    Triangle::new(corners).ok_or(MeshError::ZeroArea {
        triangle: index + 1,
        corners,
    })
}
