//! Walls: shapes, motion, and what they feel.

mod motion;

pub use motion::Motion;
