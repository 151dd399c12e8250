//! Shapes of walls, as a user describes them, in the wall's own frame.

use super::mesh::Mesh;
pub use demeter_physics::geometry::Side;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Shape of a wall.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Shape {
    /// Infinite plane; grains are on the side to which the normal points.
    Plane {
        /// A point of the plane [m].
        point: DVec3,
        /// Unit normal.
        normal: DVec3,
    },
    /// The six (or fewer) inner faces of a box, which end at the faces that are open. Faces: -x, +x, -y, +y, -z, +z.
    Box {
        /// Lower corner [m].
        lower: DVec3,
        /// Upper corner [m].
        upper: DVec3,
        /// Faces left out.
        open: [bool; 6],
    },
    /// Lateral surface of a cylinder between two points of its axis; without caps.
    Cylinder {
        /// Start of the axis [m].
        start: DVec3,
        /// End of the axis [m].
        end: DVec3,
        /// Radius [m].
        radius: f64,
        /// Where the grains are.
        side: Side,
    },
    /// Lateral surface of a (truncated) cone between two points of its axis; without caps.
    Cone {
        /// Start of the axis [m].
        start: DVec3,
        /// End of the axis [m].
        end: DVec3,
        /// Radius at the start [m]; may be 0.
        start_radius: f64,
        /// Radius at the end [m]; may be 0.
        end_radius: f64,
        /// Where the grains are.
        side: Side,
    },
    /// Sphere.
    Sphere {
        /// Centre [m].
        center: DVec3,
        /// Radius [m].
        radius: f64,
        /// Where the grains are.
        side: Side,
    },
    /// Rectangular plate without thickness; touches grains on both sides and at its edges.
    Rectangle {
        /// Centre [m].
        center: DVec3,
        /// From the centre to the middle of one edge [m].
        half_u: DVec3,
        /// From the centre to the middle of the next edge [m], perpendicular to `half_u`.
        half_v: DVec3,
    },
    /// Circular plate without thickness; touches grains on both sides and at its rim.
    Disc {
        /// Centre [m].
        center: DVec3,
        /// Unit normal.
        normal: DVec3,
        /// Radius [m].
        radius: f64,
    },
    /// Triangles; touch grains on both sides.
    Mesh {
        /// Corners of every triangle [m].
        triangles: Vec<[DVec3; 3]>,
    },
}

/// What a wall is made of.
#[derive(Clone, Debug)]
pub enum Made {
    /// A shape as it is described.
    Shape(Shape),
    /// A mesh of which more is known than its triangles.
    Mesh(Box<Mesh>),
}

impl From<Shape> for Made {
    fn from(shape: Shape) -> Self {
        Self::Shape(shape)
    }
}
