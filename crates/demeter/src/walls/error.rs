//! What can be wrong with the description of a wall.

use super::mesh::MeshError;
use glam::DVec3;
use thiserror::Error;

/// Why a wall was refused.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum WallError {
    /// There is no such wall.
    #[error("there is no wall {index}: {count} walls are counted from 0")]
    NoSuchWall {
        /// The index that was told.
        index: usize,
        /// Number of walls.
        count: usize,
    },
    /// A number is infinite, not a number, or so large that its square overflows.
    #[error("{field} of the wall is {value}; every coordinate must be finite and at most 1e100 m in magnitude")]
    NotFinite {
        /// What holds the number.
        field: &'static str,
        /// The value.
        value: DVec3,
    },
    /// A number is out of its range.
    #[error("{field} of the wall is {value}; it must be finite and {allowed}")]
    OutOfRange {
        /// What holds the number.
        field: &'static str,
        /// The value.
        value: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A direction is not a unit vector.
    #[error("{field} of the wall is {value} with length {}; it must be a unit vector, so divide it by its length", .value.length())]
    NotUnit {
        /// What holds the vector.
        field: &'static str,
        /// The value.
        value: DVec3,
    },
    /// The two half axes of a rectangle are not perpendicular.
    #[error(
        "half_u {half_u} and half_v {half_v} of the rectangle are not perpendicular; choose half_v at a right angle to half_u"
    )]
    NotPerpendicular {
        /// First half axis [m].
        half_u: DVec3,
        /// Second half axis [m].
        half_v: DVec3,
    },
    /// Start and end of an axis are the same point.
    #[error("start and end of the {shape} are both {point}; they must be two different points of its axis")]
    NoLength {
        /// Name of the shape.
        shape: &'static str,
        /// The point [m].
        point: DVec3,
    },
    /// The upper corner of a box is not above the lower.
    #[error("the box reaches from {lower} to {upper}; every coordinate of upper must exceed that of lower")]
    EmptyBox {
        /// Lower corner [m].
        lower: DVec3,
        /// Upper corner [m].
        upper: DVec3,
    },
    /// All six faces of a box are open.
    #[error("all six faces of the box are open; leave at least one closed, or remove the wall")]
    NoFace,
    /// Both radii of a cone are 0.
    #[error("both radii of the cone are 0; at least one must be positive")]
    NoRadius,
    /// Too many motions of one wall.
    #[error(
        "{count} motions of one wall are too many; at most {} add up",
        super::motion_checks::MAX_PARTS
    )]
    Parts {
        /// Their number.
        count: usize,
    },
    /// A free motion behind others.
    #[error(
        "a motion that is free is not the first of those that add up; tell `free`, `hinge` or `body` first: the others are carried by it"
    )]
    FreeNotFirst,
    /// A body that may neither move nor turn.
    #[error(
        "the body may move along no axis and turn about none; leave its motion out, or free it in `slides` or `turns`"
    )]
    BodyHeld,
    /// No mass that is nowhere negative has such moments of inertia.
    #[error(
        "no body has these moments of inertia: about three axes none is larger than the sum of the others, and products are small \
         beside them; tell those about the centre of mass, in `products` the elements beside the diagonal of the tensor"
    )]
    Inertia,
    /// The density of a wall that encloses nothing.
    #[error(
        "a `density` needs a closed mesh, or a sphere with `side = \"outside\"`; tell `mass`, `center_of_mass` and `inertia` of other shapes"
    )]
    NotSolid,
    /// A closed mesh around no volume.
    #[error(
        "the mesh is closed but encloses no volume, so a `density` gives it no mass; look at it in a viewer, or tell `mass`"
    )]
    NoVolume,
    /// A wall that moves with another one and has motions of its own.
    #[error("a wall that moves `with` another has no other motion; tell that one to the wall it moves with")]
    WithOthers,
    /// A wall that moves with one that moves with another.
    #[error(
        "{}; {}", super::motion_checks::link_in_words(.follower, .leader), super::motion_checks::INSTEAD_OF_LINKS
    )]
    Link {
        /// Name of the wall.
        follower: String,
        /// Name of the wall that it would move with.
        leader: String,
    },
    /// A start or stop of a motion that is not prescribed.
    #[error(
        "`start_over`, `stop_after` and `stop_over` belong to motions that are prescribed, not to servos and free walls"
    )]
    PaceOfForce,
    /// A motion that is to stop before it has its full speed.
    #[error(
        "the motion begins to stop after {stop_after} s, before it has its full speed after {start_over} s; stop it later or start it faster"
    )]
    StopsBeforeStart {
        /// Time after which it begins to stop [s].
        stop_after: f64,
        /// Time of starting [s].
        start_over: f64,
    },
    /// The stops of a free wall do not enclose its start.
    #[error(
        "the stops of the free wall are at {lower} and {upper}; the first must be lower, and 0, where the wall stands at first, between them"
    )]
    Stops {
        /// Lower stop [m or rad].
        lower: f64,
        /// Upper stop [m or rad].
        upper: f64,
    },
    /// A table of motion has too few or too many rows.
    #[error(
        "the table of motion has {rows} rows; from 2 to {} are allowed",
        super::motion_table::MAX_TABLE_ROWS
    )]
    TableRows {
        /// Their number.
        rows: usize,
    },
    /// Times of a table of motion do not rise from 0 on, or a number is not finite.
    #[error("the times of the table of motion must rise from row to row, from 0 on, and all values must be finite")]
    TableOrder,
    /// The mesh is not usable.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}
