//! Walls: shapes, motion, and what they feel.

mod motion;
mod shape;

pub use motion::Motion;
pub use shape::{Shape, Side};
