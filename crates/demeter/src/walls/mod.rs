//! Walls: shapes, motion, and what they feel.
//!
//! A [`Wall`] is built from a [`Shape`] and a [`Motion`]. Its shape never changes: it stays in the *wall frame*, the frame
//! in which it was described, and a [`Pose`] carries it through the world. [`Wall::contacts`] is what the engine asks for
//! each grain; [`Wall::advance`] moves the wall by one step.

mod error;
pub mod leak;
pub mod mesh;
mod mesh_file;
mod motion;
mod motor;
mod outline;
mod pose;
mod servo;
mod shape;
mod surface;
mod wall;

pub use error::WallError;
pub use mesh::{Mesh, MeshError};
pub use mesh_file::{MeshFileContent, MeshFileError, MeshFormat, read_mesh};
pub use motion::Motion;
pub use pose::Pose;
pub(crate) use servo::Servo;
pub use shape::{Shape, Side};
pub use wall::{SurfaceContact, Wall, WallState};
