//! Walls: shapes, motion, and what they feel.
//!
//! A [`Wall`] is built from a [`Shape`] and its [`Motions`]. Its shape never changes: it stays in the *wall frame*, the frame
//! in which it was described, and a [`Pose`] carries it through the world. [`Wall::contacts`] is what the engine asks for
//! each grain; [`Wall::advance`] moves the wall by one step.

mod body;
mod elements;
mod error;
mod free;
mod giving_way;
mod hierarchy;
pub mod leak;
mod limits;
mod mass;
mod meeting;
pub mod mesh;
mod mesh_file;
mod motion;
mod motion_checks;
mod motion_file;
mod motion_table;
mod motor;
mod movement;
mod outline;
mod pace;
mod placed;
mod pose;
mod record;
mod repeated;
mod servo;
mod shape;
mod surface;
mod tubes;
mod wall;
mod work;

pub use body::BodyMotion;
pub use error::WallError;
pub use mass::{BodyMass, MassProperties};
pub(crate) use meeting::{STEPS_BETWEEN_LOOKS, meeting};
pub(crate) use mesh::{Before, Overlap, SAME_SURFACE, TrianglePoint, are_one, are_still_one, joined};
pub use mesh::{Mesh, MeshError};
pub use mesh_file::{MeshFileContent, MeshFileError, MeshFormat, read_mesh};
pub use motion::{FreeMotion, Freedom, Motion, MotionPart, Motions};
pub use motion_checks::MAX_PARTS;
pub(crate) use motion_checks::{INSTEAD_OF_LINKS, link, link_in_words};
pub use motion_file::{MotionFile, MotionFileError, MotionFileProblem, read_motion_file};
pub use motion_table::{AtEnd, Interpolation, MAX_TABLE_ROWS, MotionTable, TableRows};
pub use motor::{Driven, FreeStep};
pub use pace::Pace;
pub(crate) use placed::PlacedPart;
pub use pose::Pose;
pub(crate) use record::Mark;
pub use record::{ElementRecord, Recording, WearCoefficients};
pub use repeated::{Drift, FARTHEST};
pub(crate) use servo::Servo;
pub use shape::{Made, Shape, Side};
pub(crate) use tubes::Tubes;
pub use wall::{SurfaceContact, Wall, WallState};
pub use work::WallWork;
